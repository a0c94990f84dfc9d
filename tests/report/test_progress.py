"""What is told while a command works, and when."""

from __future__ import annotations

import contextlib
import io
import itertools
import time

import pytest
from rich.console import Console

import softcat_sym as sc
from softcat_sym import progress
from softcat_sym.ensemble.ensemble import MembersBar
from softcat_sym.plotting.terminal import FitProgressBar, IntegrationProgress, StepProgress
from softcat_sym.progress import Display, Stage, seconds


@pytest.fixture(autouse=True)
def _plain_lines_after_two_seconds(monkeypatch: pytest.MonkeyPatch) -> None:
    """As for users; other tests see none."""
    monkeypatch.setattr(progress, "_PLAIN_DELAY", 2.0)


def console(terminal: bool = True, width: int = 80) -> Console:
    return Console(file=io.StringIO(), force_terminal=terminal, width=width, color_system=None)


def written(of: Console) -> str:
    return of.file.getvalue()  # type: ignore[attr-defined, no-any-return]


class Clock:
    """A clock that the test turns."""

    def __init__(self) -> None:
        self.now = 100.0

    def monotonic(self) -> float:
        return self.now

    def pass_by(self, seconds: float, display: Display) -> None:
        """Let time pass, with a look every quarter of a second."""
        for _ in range(round(4 * seconds)):
            self.now += 0.25
            display.tick()


@pytest.fixture
def clock(monkeypatch) -> Clock:
    """The display looks when the test lets time pass, and at no other time."""
    clock = Clock()
    monkeypatch.setattr(progress, "time", clock)
    monkeypatch.setattr(progress, "LOOK", 1e6)
    return clock


def test_on_a_terminal_there_is_a_line_for_each_stage_and_none_is_left(clock):
    screen = console()
    with IntegrationProgress(2.0, console=screen) as bar:
        bar.doing("compiling")
        clock.pass_by(0.75, bar)
        assert not bar.shown, "a run of less than a second shows nothing"
        clock.pass_by(3.25, bar)
        assert bar.shown
        assert "compiling" in written(screen) and "4 s" in written(screen)
        bar.doing("solving")
        bar.update(0.1, 1e-3)
        clock.pass_by(1.5, bar)
        bar.update(0.5, 1e-3)
        clock.pass_by(0.25, bar)
    shown = written(screen)
    assert "0.500 of 2.00 s" in shown and "done" in shown
    # 0.4 s in 1.5 s, and 1.5 s to go.
    assert "about 6 s left" in shown
    assert not bar.shown
    assert shown.endswith("\x1b[2K") or "\x1b[1A\x1b[2K" in shown, "its lines are taken away"


@pytest.mark.parametrize("terminal", [True, False])
def test_quiet_it_tells_nothing(clock, terminal):
    screen = console(terminal)
    with IntegrationProgress(2.0, quiet=True, console=screen) as bar:
        bar.doing("solving")
        clock.pass_by(20, bar)
        assert not bar.shown
    assert written(screen) == ""


def test_without_a_terminal_plain_lines_come_at_each_stage_that_lasts_and_every_few_seconds(clock):
    screen = console(terminal=False)
    with IntegrationProgress(1.0, console=screen) as bar:
        bar.doing("building")
        clock.pass_by(1.5, bar)
        assert written(screen) == ""
        bar.doing("compiling")
        clock.pass_by(12, bar)
        bar.stage("estimating 1 of 2")
        bar.doing("solving")
        clock.pass_by(0.5, bar)
        bar.stage("estimating 2 of 2")
        bar.update(0.2, None)
        clock.pass_by(1.25, bar)
        bar.update(0.45, None)
        clock.pass_by(5, bar)
    assert written(screen).splitlines() == [
        "softcat: compiling for 1 s",
        "softcat: compiling for 6 s",
        "softcat: compiling for 11 s",
        "softcat: estimating 2 of 2 for 1 s, 0.200 of 1.00 s",
        "softcat: estimating 2 of 2 for 6 s, 0.450 of 1.00 s, about 3 s left",
    ]


def test_within_a_stage_what_is_done_is_told_beside_it(clock):
    with IntegrationProgress(1.0, console=console()) as bar:
        for what in ("building", "solving"):
            bar.doing(what)
        bar.update(0.5, None)
        bar.stage("refining to 80 cells")
        bar.doing("compiling")
        assert [one.name for one in bar.stages] == ["building", "solving", "refining to 80 cells"]
        assert (bar.stages[-1].doing, bar.stages[-1].share) == ("compiling", None)


def test_time_left_follows_the_pace_of_late_and_is_not_guessed_too_early():
    stage = Stage("solving", began=0.0)
    for now in range(10):
        stage.reach(float(now), 0.001 * now, "", None)
        assert stage.left() is None
    # Slow at first, a tenth a second later: the rest goes on as it went of late.
    for tenth in range(1, 10):
        stage.reach(9.0 + tenth, 0.1 * tenth, "", None)
    assert stage.left() == pytest.approx(1.0, rel=0.3)
    stage.reach(20.0, 0.05, "", None)
    assert stage.left() is None, "it has begun anew"


def test_the_lines_are_taken_down_when_the_work_fails(clock):
    with pytest.raises(ZeroDivisionError), IntegrationProgress(2.0, console=console()) as bar:
        bar.doing("solving")
        clock.pass_by(2, bar)
        assert bar.shown
        _ = 1 / 0
    assert not bar.shown


def test_a_thread_looks_by_itself(monkeypatch):
    """What compiles says nothing for a while: the line goes on all the same."""
    monkeypatch.setattr(progress, "LOOK", 0.01)
    monkeypatch.setattr(progress, "_DELAY", 0.0)
    screen = console()
    with IntegrationProgress(2.0, console=screen) as bar:
        bar.doing("compiling")
        for _ in range(500):
            if bar.shown:
                break
            bar._over.wait(0.01)
        assert bar.shown
    assert not bar._thread.is_alive()


def test_what_redirects_standard_error_meanwhile_does_not_swallow_it(monkeypatch, capsys):
    monkeypatch.setattr(progress, "_DELAY", 0.0)
    monkeypatch.setattr(progress, "_PLAIN_DELAY", 0.0)
    monkeypatch.setattr(progress, "_PLAIN_BETWEEN", 0.0)
    monkeypatch.setattr(progress, "LOOK", 1e6)
    with IntegrationProgress(2.0) as bar:
        bar.doing("solving")
        with contextlib.redirect_stderr(io.StringIO()) as taken:
            bar.tick()
    assert taken.getvalue() == ""
    assert capsys.readouterr().err == "softcat: solving for 0 s\n"


def test_tasks_members_and_fits_are_told_likewise(clock):
    screen = console(terminal=False, width=200)
    with StepProgress(2, "two runs", console=screen) as steps:
        steps.step("the first")
        clock.pass_by(3, steps)
    with MembersBar("members", console=screen) as members:
        clock.pass_by(2, members)
        members.update(3, 30, 54.0)
        clock.pass_by(5, members)
    with FitProgressBar(console=screen) as fit:
        clock.pass_by(2, fit)
        fit.stage("starts", 1, 4)
        fit.stage("starts", 2, 4)
        clock.pass_by(1, fit)
    assert written(screen).splitlines() == [
        "softcat: two runs for 2 s, 1 of 2, the first",
        "softcat: members for 2 s",
        "softcat: members for 7 s, 3 of 30, about 54 s left",
        "softcat: reading and compiling for 2 s",
        "softcat: starts for 1 s, 3 of 4",
    ]


def test_names_are_not_markup(clock):
    screen = console()
    with IntegrationProgress(2.0, "[red]without[/] [shear]", console=screen) as bar:
        clock.pass_by(2, bar)
    assert "[red]without[/] [shear]" in written(screen)


class Timed(io.StringIO):
    """Remembers when it was written to."""

    def __init__(self) -> None:
        super().__init__()
        self.times: list[float] = []

    def write(self, text: str) -> int:
        self.times.append(time.monotonic())
        return super().write(text)


def test_no_stage_of_a_run_with_refinement_is_silent(monkeypatch):
    """Every stage is told by whoever does it, and the screen is renewed all the while, whatever holds the thread."""
    monkeypatch.setattr(progress, "_DELAY", 0.0)
    scene, screen = sc.load_scene("glass-rod", {"run.accuracy": 1e-5}), Timed()
    with IntegrationProgress(
        scene.run.duration, console=Console(file=screen, force_terminal=True, width=80, color_system=None)
    ) as bar:
        run = sc.simulate(scene, bar)
    assert len(run.summary["refinements"]) == 1
    first, *rest = [stage.name for stage in bar.stages]
    assert first == "building"
    assert [name for name in rest if name != "compiling"] == [
        "solving",
        "checking the answer",
        "estimating 1 of 2",
        "estimating 2 of 2",
        f"refining to {run.summary['cells']} cells",
        # The error of the time steps is far below what was asked, and known from before the grid was made finer.
        "estimating 1 of 2",
    ]
    ends = (bar.stages[0].began, *screen.times, bar.stages[-1].ended)
    assert max(later - sooner for sooner, later in itertools.pairwise(ends)) < 3.0
    assert f"refining to {run.summary['cells']} cells" in screen.getvalue()


@pytest.mark.parametrize(
    ("value", "text"), [(0.4, "0 s"), (59.4, "59 s"), (61, "1 min 1 s"), (3600, "1 h 0 min"), (9000, "2 h 30 min")]
)
def test_times_are_told_as_people_say_them(value, text):
    assert seconds(value) == text
