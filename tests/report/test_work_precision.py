"""Work-precision diagrams: a program is judged by its best settings, and what is drawn is what was measured."""

from __future__ import annotations

import csv
import io
import math
from pathlib import Path

import numpy as np
import pytest

from softcat_sym.plotting.accuracy import (
    WorkCurve,
    WorkPanel,
    WorkPoint,
    draw,
    front,
    power_of_ten,
    seconds_for,
    work_precision_csv,
    work_precision_figure,
)


def points(count: int = 60) -> tuple[WorkPoint, ...]:
    rng = np.random.default_rng(5)
    pairs = 10 ** rng.uniform([-3, -6], [1, -1], (count, 2))
    return (*(WorkPoint(float(t), float(e), f"{k}") for k, (t, e) in enumerate(pairs)), WorkPoint(0.1, math.nan, "bad"))


def panels() -> list[WorkPanel]:
    slow = tuple(WorkPoint(10 * p.seconds, p.error, p.setting) for p in points())
    pair = (WorkCurve("ours", points()), WorkCurve('theirs, "quoted"', slow))
    return [WorkPanel(f"problem {k}", pair) for k in range(3)]


def test_front_is_every_run_that_no_other_beats() -> None:
    every = [p for p in points() if math.isfinite(p.error)]
    kept = front(points())
    by_pairs = {p for p in every if not any(q.seconds < p.seconds and q.error < p.error for q in every)}
    assert set(kept) == by_pairs
    assert [p.seconds for p in kept] == sorted(p.seconds for p in kept)
    assert [p.error for p in kept] == sorted((p.error for p in kept), reverse=True)


def test_equal_runs_count_once() -> None:
    same = WorkPoint(1.0, 0.1)
    assert front([same, same, WorkPoint(1.0, 0.2), WorkPoint(2.0, 0.1)]) == (same,)
    assert front([WorkPoint(1.0, math.nan)]) == ()


def test_seconds_for_an_error() -> None:
    measured = points()
    assert seconds_for(measured, 1e-3) == min(p.seconds for p in measured if p.error <= 1e-3)
    assert seconds_for(measured, 1e-9) is None


def test_what_is_drawn_is_what_was_measured() -> None:
    figure = work_precision_figure(panels(), "A title with $ signs", "A caption. " * 30)
    assert len(figure.axes) == 3
    best = front(points())
    for axes in figure.axes:
        line = next(line for line in axes.lines if line.get_label() == "ours")
        np.testing.assert_array_equal(line.get_xdata(), [p.seconds for p in best])
        np.testing.assert_array_equal(line.get_ydata(), [p.error for p in best])
        assert axes.get_xscale() == axes.get_yscale() == "log"
    # One frame for all, so that panels can be compared by eye.
    assert len({(axes.get_xlim(), axes.get_ylim()) for axes in figure.axes}) == 1
    boxes = [axes.get_position() for axes in figure.axes]
    assert not any(a.overlaps(b) for k, a in enumerate(boxes) for b in boxes[k + 1 :])


def test_decades_are_labelled_and_nothing_else() -> None:
    assert [power_of_ten(value) for value in (1e-12, 1e-3, 1.0, 1e10, 2e-3)] == ["10⁻¹²", "10⁻³", "10⁰", "10¹⁰", ""]


def test_one_panel_takes_the_whole_width() -> None:
    figure = work_precision_figure(panels()[:1], "One")
    figure.draw_without_rendering()
    (axes,) = figure.axes
    assert axes.get_position().width > 0.8


def test_table_holds_every_run_and_leaves_a_failed_error_empty() -> None:
    rows = list(csv.DictReader(io.StringIO(work_precision_csv(panels()).decode())))
    assert len(rows) == 3 * 2 * len(points())
    assert {row["program"] for row in rows} == {"ours", "theirs, 'quoted'"}
    failed = [row for row in rows if row["setting"] == "bad"]
    assert all(row["relative_error"] == "" and row["on_front"] == "0" for row in failed)
    assert sum(row["on_front"] == "1" for row in rows[: len(points())]) == len(front(points()))


def test_picture_and_table_are_written_side_by_side(tmp_path: Path) -> None:
    written = draw(panels(), tmp_path / "new" / "rods.png", "Rods")
    assert [path.name for path in written] == ["rods.png", "rods.csv"]
    assert written[0].read_bytes().startswith(b"\x89PNG")


def test_nothing_to_draw_is_said_and_nothing_written(tmp_path: Path) -> None:
    empty = [WorkPanel("none", (WorkCurve("ours", (WorkPoint(1.0, math.nan),)),))]
    with pytest.raises(ValueError, match="no run with an error to draw"):
        draw(empty, tmp_path / "rods.png", "Rods")
    assert not list(tmp_path.iterdir())
