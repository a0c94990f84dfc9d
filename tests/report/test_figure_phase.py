"""Figure 3(a): drawn from runs on a coarse lattice, nothing outside the page, every run in its table."""

from __future__ import annotations

import csv
import io
import json

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.plotting.paper_figures import phase_caption as caption
from softcat_sym.plotting.paper_figures import phase_figure, phase_files
from softcat_sym.studies.phase import SETTINGS, PhaseDiagram, phase_diagram


@pytest.fixture(scope="module")
def diagram() -> PhaseDiagram:
    return phase_diagram(sc.load_scene("arrested-overdamped", list(SETTINGS)), resolution=8)


@pytest.mark.slow
def test_picture_fits_its_page_and_its_caption_has_every_number(diagram: PhaseDiagram) -> None:
    figure = phase_figure(diagram)
    figure.canvas.draw()
    page = figure.bbox
    assert "nan" not in caption(diagram)
    for thing in (*figure.texts, *figure.legends):
        box = thing.get_window_extent()
        assert box.x0 >= 0
        assert box.y0 >= 0
        assert box.x1 <= page.width
        assert box.y1 <= page.height
    first, second = figure.legends
    assert not first.get_window_extent().overlaps(second.get_window_extent())


@pytest.mark.slow
def test_table_holds_every_run_and_every_line(diagram: PhaseDiagram) -> None:
    files = phase_files(diagram)
    runs = list(csv.DictReader(io.StringIO(files["figure3a-runs.csv"].decode())))
    assert len(runs) == sum(len(sheet.points) for sheet in diagram.sheets)
    lightest = [row for row in runs if row["plane"] == "G-V" and float(row["G"]) == pytest.approx(0.01)]
    assert {row["regime"] for row in lightest} == {"no-yield"}
    lines = list(csv.DictReader(io.StringIO(files["figure3a-lines.csv"].decode())))
    first = [row for row in lines if row["plane"] == "G-delta" and row["equation"] == "(3.11)"]
    assert [float(row["G"]) for row in first] == pytest.approx([2 * float(row["other"]) for row in first])
    facts = json.loads(files["figure3a.json"])
    for plane, sheet in zip(facts["planes"], diagram.sheets, strict=True):
        assert plane["nodes_never_run"] + len(sheet.points) == plane["lattice_nodes"] == 81
        assert {each["source"] for each in plane["boundary_over_formula"]} >= {"paper", "exact"}


@pytest.mark.slow
def test_papers_parameter_sets_lie_where_the_paper_puts_them(diagram: PhaseDiagram) -> None:
    """Its underdamped set excepted: there the published physics has no answer."""
    sheet = next(sheet for sheet in diagram.sheets if sheet.plane.name == "G-V")

    def mark(G: float, V: float) -> str:
        i, j = (int(np.argmin(np.abs(np.log(axis / value)))) for axis, value in ((sheet.x, G), (sheet.y, V)))
        return str(sheet.labels[i, j])

    assert mark(0.01, 26.0) == "no-yield"
    assert mark(0.4, 26.0) in ("arrested-overdamped", "arrested-underdamped")
    assert mark(1.9, 26.0).startswith("descending")
    assert mark(0.4, 0.4) == "localised"
