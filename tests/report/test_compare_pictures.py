"""Pictures and tables of a comparison: nothing clipped, nothing overlapping, every number where it belongs."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from rich.console import Console

import softcat_sym as sc
from softcat_sym.plotting import style
from softcat_sym.plotting.compare import (
    clamp_figure,
    document,
    errors_csv,
    midpoint_figure,
    print_comparison,
    rate_csv,
    rate_fields,
    rate_figure,
    shapes_csv,
    shapes_figure,
    write_comparison,
)
from softcat_sym.plotting.files import finite, json_bytes
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.reference.elements import ElementRun
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.studies.compare import Comparison, FilamentRow, compare, discrepancy

FIGURES = (midpoint_figure, shapes_figure, rate_figure, clamp_figure)
CHANGES = {"groups.duration": 20, "run.frames": 21, "numerics.cells": 10}


@pytest.fixture(scope="module")
def comparison() -> Comparison:
    return compare(sc.load_scene("continual-descent", CHANGES), Mesh(8, 2))


def with_midpoint(row: FilamentRow, time: np.ndarray, midpoint: np.ndarray, elements: np.ndarray) -> FilamentRow:
    return replace(row, midpoint=midpoint, discrepancy=discrepancy(time, midpoint, elements))


def run_away(comparison: Comparison) -> Comparison:
    """The printed closure leaves every picture; the filament's run ended half way, in failure."""
    time, elements = comparison.elements.time, comparison.elements.midpoint
    own, material, printed = comparison.filaments
    half = np.where(time <= time[-1] / 2, own.midpoint, np.nan)
    fields = style.first_frames(own.trajectory.fields, 11)
    trajectory = replace(own.trajectory, fields=fields, outcome=Outcome.no_convergence)
    own = with_midpoint(replace(own, trajectory=trajectory), time, half, elements)
    return replace(comparison, filaments=(own, material, with_midpoint(printed, time, 1e4 * elements, elements)))


def at_rest(comparison: Comparison) -> Comparison:
    run, zero = comparison.elements, np.zeros_like(comparison.elements.midpoint)
    straight = replace(run, midpoint=zero, x=run.x[:1] + 0 * run.x, y=0 * run.y, rate=0 * run.rate)
    return replace(
        comparison,
        elements=straight,
        filaments=tuple(with_midpoint(row, run.time, zero, zero) for row in comparison.filaments),
    )


def alone(comparison: Comparison) -> Comparison:
    return replace(comparison, filaments=comparison.filaments[:1])


def texts_of(figure: Figure) -> list[Text]:
    with style.styled():
        figure.draw_without_rendering()
    return [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()]


@pytest.mark.parametrize("draw", FIGURES)
@pytest.mark.parametrize("case", [lambda c: c, run_away, at_rest, alone], ids=["plain", "run away", "at rest", "alone"])
def test_nothing_is_clipped_and_no_legend_lies_on_the_data(
    comparison: Comparison, case: Callable[[Comparison], Comparison], draw: Callable[[Comparison], Figure]
) -> None:
    figure = draw(case(comparison))
    paper = figure.bbox
    for text in texts_of(figure):
        box = text.get_window_extent()
        # Ticks outside the limits are kept by Matplotlib, but not drawn.
        tick = any(text in (*axes.get_xticklabels(), *axes.get_yticklabels()) for axes in figure.axes)
        if not tick:
            assert box.x0 >= 0 and box.y0 >= 0, text
            assert box.x1 <= paper.width and box.y1 <= paper.height, text
    legends = [*figure.legends, *(legend for axes in figure.axes if (legend := axes.get_legend()) is not None)]
    for legend in legends:
        assert not any(legend.get_window_extent().overlaps(axes.bbox) for axes in figure.axes)
    # Headings, notes, legends and axis labels keep clear of one another.
    every = [*figure.axes, *(above for axes in figure.axes for above in axes.child_axes)]
    labels = [label for axes in every for label in (axes.xaxis.label, axes.yaxis.label) if label.get_text()]
    boxes = [thing.get_window_extent() for thing in (*figure.texts, *labels, *legends)]
    for k, one in enumerate(boxes):
        assert not any(one.overlaps(other) for other in boxes[k + 1 :])


def field_run(run: ElementRun) -> ElementRun:
    """An undeformed strip whose rate tells where it was measured, and that stops flowing."""
    tell = 1.0 + 100 * run.point[..., 0] + 10 * run.point[..., 1]
    share = np.linspace(1, 0, len(run.rate_time)) if len(run.rate_time) > 1 else np.ones(1)
    share[3:] = 0
    straight = np.broadcast_to(run.X, run.x.shape)
    return replace(run, rate=share[:, None, None] * tell, x=straight.copy(), y=np.zeros_like(run.y))


def test_each_rate_is_drawn_where_it_was_measured(comparison: Comparison) -> None:
    run, thickness = field_run(comparison.elements), comparison.scene.filament.thickness
    first = rate_fields(run, thickness)[0]
    assert first.rate.shape == (16, 4)
    np.testing.assert_allclose(first.rate, np.sqrt(3) * (1 + 100 * first.X + 10 * first.Y))
    # Undeformed, a quarter of an element surrounds the reference position of its Gauss point.
    for low, point, high in (
        (first.x[:-1, :-1], first.X, first.x[1:, 1:]),
        (first.y[:-1, :-1], first.Y, first.y[1:, 1:]),
    ):
        assert np.all((low < point) & (point < high))
    np.testing.assert_allclose(np.ptp(first.y, axis=1), thickness)


def test_fields_that_flow_are_drawn_and_the_last(comparison: Comparison) -> None:
    run = field_run(comparison.elements)
    times = [field.time for field in rate_fields(run, comparison.scene.filament.thickness)]
    # Kept at every frame: of the moments, that at 10 % flows still; the fastest is the first; the last is always there.
    assert times == [run.time[0], run.time[2], run.time[-1]]


def test_a_strip_turned_stays_as_thick_as_its_stretch_allows(comparison: Comparison) -> None:
    run, thickness = comparison.elements, comparison.scene.filament.thickness
    for field in rate_fields(run, thickness):
        drawn = np.hypot(*(np.diff(c[:, [0, -1]], axis=1)[:, 0] for c in (field.x, field.y)))
        frame = int(np.abs(run.time - field.time).argmin())
        stretch = np.hypot(np.gradient(run.x[frame], run.X), np.gradient(run.y[frame], run.X))
        np.testing.assert_allclose(drawn, thickness / np.sqrt(stretch))
        # Sections at midspan and clamp are vertical.
        assert np.ptp(field.x[0]) < 1e-9 * thickness and np.ptp(field.x[-1]) < 1e-9 * thickness


def test_tables_read_back_exactly(comparison: Comparison) -> None:
    broken = run_away(comparison)
    rows = list(csv.DictReader(io.StringIO(errors_csv(broken).decode())))
    assert [row["what"] for row in rows] == ["error"] * 4 + ["mean error", "largest error"]
    assert rows[3]["filament"] == rows[4]["filament"] == ""
    assert float(rows[1]["filament"]) == broken.filament.discrepancy.at[1]
    assert [float(row["time_s"]) for row in rows[:4]] == [broken.elements.time[k] for k in (2, 5, 10, 20)]
    shapes = list(csv.DictReader(io.StringIO(shapes_csv(broken).decode())))
    assert len(shapes) == 3 * len(broken.elements.X)
    assert float(shapes[0]["elements_y_m"]) == broken.elements.y[2, 0]
    assert len(rate_csv(comparison).splitlines()) > 16 * 4


def test_the_document_has_no_number_that_json_lacks(comparison: Comparison) -> None:
    for case in (run_away, at_rest, alone):
        assert b"NaN" not in json_bytes(document(case(comparison)))
    assert finite(document(run_away(comparison)))["filament"]["midpoint_final_m"] is None
    assert finite(document(at_rest(comparison)))["errors"]["filament"]["mean"] is None


def test_the_table_fits_a_terminal_and_says_what_is_not_to_be_trusted(comparison: Comparison) -> None:
    screen = Console(file=io.StringIO(), width=80, color_system=None)
    print_comparison(run_away(comparison), screen)
    written = screen.file.getvalue()  # type: ignore[attr-defined]
    assert "…" not in written
    assert max(map(len, written.splitlines())) <= 80
    assert "–" in written
    assert "filament: no_convergence" in written
    assert "plane stress" in written


def test_a_comparison_that_cannot_be_drawn_writes_nothing(
    comparison: Comparison, tmp_path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(comparison: Comparison) -> bytes:
        raise KeyError("gone")

    monkeypatch.setattr("softcat_sym.plotting.compare.clamp_csv", fail)
    with pytest.raises(KeyError):
        write_comparison(comparison, tmp_path / "out")
    assert not (tmp_path / "out").exists()
