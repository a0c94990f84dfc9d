"""What appears on the terminal, and when."""

from __future__ import annotations

import io

import pytest
from rich.console import Console

from softcat_sym.report import progress
from softcat_sym.report.progress import IntegrationProgress, StepProgress
from softcat_sym.report.terminal import print_summary, summary_rows


def console(terminal: bool = True, width: int = 100) -> Console:
    return Console(file=io.StringIO(), force_terminal=terminal, width=width, color_system=None)


def written(of: Console) -> str:
    return of.file.getvalue()  # type: ignore[attr-defined, no-any-return]


class Clock:
    """A clock that the test turns."""

    def __init__(self) -> None:
        self.now = 100.0

    def monotonic(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch) -> Clock:
    clock = Clock()
    monkeypatch.setattr(progress, "time", clock)
    return clock


def test_the_bar_waits_a_second(clock):
    screen = console()
    with IntegrationProgress(2.0, console=screen) as bar:
        clock.now += 0.9
        bar.update(0.1, 1e-3)
        assert not bar.shown
        clock.now += 0.2
        bar.update(0.5, 1e-3)
        assert bar.shown
    assert "integrating" in written(screen)
    assert "0.500 of 2.00 s, step 1.00 ms" in written(screen)
    assert not bar.shown


def test_forced_it_appears_at_once(clock):
    screen = console()
    with IntegrationProgress(600.0, "trial", force=True, console=screen) as bar:
        assert bar.shown
    assert "trial" in written(screen)
    assert "0 of 10.0 min" in written(screen)


@pytest.mark.parametrize(("quiet", "terminal"), [(True, True), (False, False), (True, False)])
def test_it_is_silent_when_asked_or_without_a_terminal(clock, quiet, terminal):
    screen = console(terminal)
    with IntegrationProgress(2.0, quiet=quiet, force=True, console=screen) as bar:
        clock.now += 10
        bar.update(1.0, 0.1)
        assert not bar.shown
    assert written(screen) == ""


def test_it_redraws_ten_times_a_second_at_most(clock, monkeypatch):
    drawn = []
    with IntegrationProgress(2.0, force=True, console=console()) as bar:
        monkeypatch.setattr(bar, "_draw", lambda: drawn.append(clock.now))
        for step in range(1000):
            clock.now += 0.001
            bar.update(0.001 * step, 1e-3)
    assert 9 <= len(drawn) <= 10


def test_mean_step_is_time_over_steps():
    bar = IntegrationProgress(10.0, quiet=True)
    assert bar.mean_step is None
    bar.update(1.0, 0.01)
    bar.update(2.0, 1.0)
    bar.update(3.0, None)
    assert bar.mean_step == pytest.approx(2.0 / 101)


def test_the_bar_is_taken_down_when_the_integration_fails(clock):
    with pytest.raises(ZeroDivisionError), IntegrationProgress(2.0, force=True, console=console()) as bar:
        _ = 1 / 0
    assert not bar.shown


def test_going_back_or_past_the_end_does_no_harm(clock):
    with IntegrationProgress(1.0, force=True, console=console()) as bar:
        for reached in (0.5, 0.2, 7.0):
            clock.now += 1
            bar.update(reached, 0.0)
    assert bar.mean_step is None


@pytest.mark.parametrize(("terminal", "quiet"), [(True, False), (False, False), (True, True)])
def test_step_progress_tells_which_task_runs_where_it_is_watched(terminal, quiet):
    screen = console(terminal)
    with StepProgress(2, "two runs", quiet=quiet, console=screen) as bar:
        bar.step("the first")
        bar.step("the second")
    told = "the second" in written(screen) and "50%" in written(screen)
    assert told is (terminal and not quiet)


def test_summary_says_what_a_user_asks(summary, scene):
    rows = summary_rows(summary, scene)
    words = dict(rows)
    assert words["outcome"] == "success\nThe run reached its end within the accuracy asked."
    assert words["final midpoint"] == "\N{MINUS SIGN}50.0 mm = \N{MINUS SIGN}0.250 of the span"
    assert words["error estimate"] == "not estimated"
    assert words["effects"].splitlines() == ["inertia: always", "yielding: the law yields [at 9.32 kPa]"]
    assert words["left out"] == "shear: expected 0.0210"
    assert words["solver"] == "cvodes, interpreted, 80 cells a half span"
    assert words["wall time"].startswith("build 0.500 s, compile 0 s, solve 0.210 s")
    assert words["warning"] == "surface tension: Ca = 0.3"


def test_an_error_estimate_is_given_with_its_parts(summary, scene):
    summary["error_estimate"] = {"total": 8e-4, "space": 6e-4, "time": 1e-4, "section": None, "effects": 1e-4}
    words = dict(summary_rows(summary, scene))
    found = "8.00e-04 of the largest midpoint (space 6.00e-04, time 1.00e-04); effects left out may be worth 1.00e-04"
    assert words["error estimate"] == found
    summary["error_estimate"] = {"total": None, "space": 6e-4, "time": None, "section": None, "effects": 0.0}
    assert dict(summary_rows(summary, scene))["error estimate"] == "not estimated in full (space 6.00e-04)"


def test_what_was_refined_is_said(summary, scene):
    summary["refinements"] = ["40 -> 96 cells: estimated error 0.004 against 0.001"]
    assert ("refined", summary["refinements"][0]) in summary_rows(summary, scene)


def test_a_summary_of_a_failed_run_is_still_a_table(scene):
    screen = console()
    print_summary({"outcome": "localised"}, scene, screen)
    assert "localised" in written(screen)


def test_brackets_of_the_user_are_not_markup(summary, make_scene):
    screen = console()
    print_summary(summary, make_scene(title="[red]ink[/] at [5 mm]"), screen)
    assert "[red]ink[/] at [5 mm]" in written(screen)
    assert "the law yields [at 9.32 kPa]" in written(screen)
