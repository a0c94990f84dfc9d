"""What is on the screen after a run."""

from __future__ import annotations

import dataclasses
import io
from pathlib import Path

import pytest
from rich.console import Console

from softcat_sym.plotting.terminal import REFUSED, answer_rows, detail_rows, headline, print_summary


def console(width: int = 80) -> Console:
    return Console(file=io.StringIO(), width=width, color_system=None)


def written(of: Console) -> str:
    return of.file.getvalue()  # type: ignore[attr-defined, no-any-return]


def test_the_screen_says_what_is_asked(summary, scene):
    summary["error_estimate"] = {"total": 8e-4, "space": 6e-4, "time": 1e-4, "section": None, "effects": 1e-4}
    assert answer_rows(summary, scene) == [
        ("outcome", "solved"),
        ("sag", "50.0 mm ± 0.08 %, 25 % of the span"),
        ("regime", "it does not stop within this run (descending)"),
        ("warning", "surface tension: Ca = 0.3"),
    ]


def test_everything_else_is_a_detail(summary):
    words = dict(detail_rows(summary))
    assert words["error"] == "not estimated"
    assert words["energy"] == "balanced to 2.50e-05 of the largest energy"
    assert words["effects"].splitlines() == ["inertia: on, always", "yielding: on, the law yields [at 9.32 kPa]"]
    assert words["left out"] == "shear: worth at most 2 % of the sag"
    assert words["solver"] == "cvodes, interpreted, 80 cells a half span"
    assert words["wall time"].startswith("build 0.500 s, compile 0 s, solve 0.210 s")
    summary["refinements"] = ["40 -> 96 cells: estimated error 0.004 against 0.001"]
    assert ("refined", summary["refinements"][0]) in detail_rows(summary)


def test_an_error_estimate_is_given_with_its_parts(summary):
    summary["error_estimate"] = {"total": 8e-4, "space": 6e-4, "time": 1e-4, "section": None, "effects": 1e-4}
    assert dict(detail_rows(summary))["error"] == "0.08 % of the largest midpoint (grid 0.06 %, time steps 0.01 %)"
    summary["error_estimate"] = {"total": None, "space": 6e-4, "time": None, "section": None, "effects": 0.0}
    assert dict(detail_rows(summary))["error"] == "not estimated in full (grid 0.06 %)"


@pytest.mark.parametrize(
    ("final", "largest", "ends", "said"),
    [
        (-0.05, 0.05, {}, ("sag", "50.0 mm ± 1.1 %, 25 % of the span")),
        (-0.05, 0.09, {}, ("sag", "50.0 mm ± 2 %, 25 % of the span")),
        (-0.005, 0.05, {}, ("sag", "5.00 mm ± 560 µm, 2.5 % of the span")),
        (0.0, 0.0, {}, ("sag", "0 mm ± 0 %, 0 % of the span")),
        (0.02, 0.02, {}, ("midpoint", "20.0 mm up ± 1.1 %, 10 % of the span")),
        (-0.05, 0.05, {"drop": 0.1}, ("midpoint", "50.0 mm down ± 1.1 %, 25 % of the span")),
        (-0.05, 0.05, {"right": "free"}, ("midpoint", "50.0 mm down ± 1.1 %, 25 % of the span")),
        (-0.05, 0.05, {"motion": ((1.0, 0.1, 0.0),)}, ("midpoint", "50.0 mm down ± 1.1 %, 25 % of the span")),
    ],
)
def test_a_sag_is_that_of_a_level_strand_and_else_it_is_a_midpoint(summary, scene, final, largest, ends, said):
    held = dataclasses.replace(scene, ends=dataclasses.replace(scene.ends, **ends))
    summary |= {"midpoint_final_m": final, "midpoint_largest_m": largest}
    summary["error_estimate"] = {"total": 0.0112 if final else 0.0}
    assert said in answer_rows(summary, held)


def test_a_midpoint_that_still_swings_is_told_by_its_mean(summary, scene):
    summary |= {"midpoint_settled_m": {"mean": -0.049, "amplitude": 2e-3}, "settled_s": None}
    words = dict(answer_rows(summary, scene))
    assert words["sag"] == "49.0 mm (error not estimated), 24 % of the span, swinging by 2.00 mm about it"
    assert words["settled"] == "no: it still swings when the run ends"
    summary |= {"midpoint_settled_m": {"mean": -0.05, "amplitude": 1e-9}, "settled_s": 0.32}
    words = dict(answer_rows(summary, scene))
    assert words["sag"] == "50.0 mm (error not estimated), 25 % of the span"
    assert words["settled"] == "from 320 ms on"


def test_what_was_left_out_is_one_number_and_shown_where_it_exceeds_the_accuracy(summary, scene):
    summary |= {"left_out": {"shear": 0.021, "rotary-inertia": 1e-4}, "checked": {"shear": 0.03, "rotary-inertia": 0.0}}
    said = ("left out", "shear, rotary-inertia: together worth at most 3 % of the sag")
    assert said in detail_rows(summary)
    assert said not in answer_rows({**summary, "accuracy": 0.05}, scene)
    assert said in answer_rows({**summary, "accuracy": 0.01}, scene)


def test_a_refused_answer_is_stamped_on_its_first_line(summary, scene):
    summary |= {"outcome": "localised", "regime": None, "message": "a neck", "advice": "do not trust it"}
    screen = console()
    print_summary(summary, scene, console=screen)
    lines = written(screen).splitlines()
    assert lines[0] == f"{REFUSED} (localised): Growing catenary"
    assert "reached  midpoint 50.0 mm when the run ended: no answer" in lines
    assert not any(line.startswith(("sag", "outcome")) for line in lines)
    assert headline({"outcome": "solved"}, scene) == "Growing catenary"


def test_a_summary_of_a_failed_run_is_still_told(scene):
    screen = console()
    print_summary({"outcome": "localised"}, scene, console=screen)
    assert "localised" in written(screen)


def test_a_clean_run_is_told_in_a_few_lines_and_in_full_where_asked(summary, scene):
    summary["warnings"] = []
    files = [Path("/somewhere") / name for name in ("trajectory.nc", "summary.json", "scene.toml", "midpoint.csv")]
    short, full = console(), console()
    print_summary(summary, scene, files, console=short)
    print_summary(summary, scene, files, verbose=True, console=full)
    assert len(written(short).splitlines()) <= 6
    assert "files    /somewhere (4: trajectory.nc, summary.json, ...)" in written(short).splitlines()
    assert "midpoint.csv" in written(full) and "inertia: on, always" in written(full)
    assert "inertia" not in written(short)


def test_no_line_is_wider_than_the_screen_or_ends_in_blanks(summary, scene):
    summary |= {"outcome": "localised", "advice": "do not trust the sag, " * 12, "message": "a neck " * 20}
    screen = console(60)
    print_summary(summary, scene, [Path("a") / "b"], verbose=True, console=screen)
    assert all(len(line) <= 60 and line == line.rstrip() for line in written(screen).splitlines())


def test_brackets_of_the_user_are_not_markup(summary, make_scene):
    screen = console()
    print_summary(summary, make_scene(title="[red]ink[/] at [5 mm]"), verbose=True, console=screen)
    assert "[red]ink[/] at [5 mm]" in written(screen)
    assert "the law yields [at 9.32 kPa]" in written(screen)
