"""Phase diagrams: a sample of nodes against single runs, boundaries against the formulas."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.batch.executor import run_pool
from softcat_sym.scene.scene import elastic_time
from softcat_sym.studies.phase import SETTINGS, PhaseDiagram, PhaseSheet, phase_diagram, phase_lines
from softcat_sym.studies.phase_runs import CLAMPS_ONLY, PASSED, PLANES, Place, duration_at, place_at, run_places
from tests.common.table import show

SPAN, DENSITY, GRAVITY = 0.2, 1900.0, 9.81
SAMPLE = 6  # nodes of each plane that are run once more, one by one

pytestmark = pytest.mark.slow


def scene(*changes: str) -> sc.Scene:
    return sc.load_scene("arrested-overdamped", [*SETTINGS, *changes])


@pytest.fixture(scope="module")
def diagram() -> PhaseDiagram:
    return phase_diagram(scene(), tuple(PLANES), 16)


def by_hand(place: Place, duration: float) -> sc.Scene:
    """Constants from the definitions of the groups (3.9), (3.10)."""
    return scene().replace(
        {
            "filament.thickness": f"{place.delta * SPAN!r} m",
            "material.yield_stress": f"{DENSITY * GRAVITY * SPAN / place.G!r} Pa",
            "material.viscosity": f"{place.V * DENSITY * math.sqrt(GRAVITY * SPAN**3)!r} Pa*s",
            "run.duration": f"{duration!r} s",
        }
    )


def brute_force(place: Place) -> str:
    """Regime or outcome of a node by `simulate` alone."""
    run = sc.simulate(by_hand(place, duration_at(scene(), place)))
    sag = -run.data.midpoint.values / SPAN
    if not run.outcome.is_success and np.any(sag > PASSED):
        fallen = sc.simulate(by_hand(place, float(run.data.time[int(np.argmax(sag > PASSED))])))
        if fallen.summary["regime"] == "descending":
            return "descending"
    return str(run.summary["regime"] or run.outcome.name)


def test_nodes_against_single_runs(diagram: PhaseDiagram) -> None:
    """Run or inferred, a node has the regime that a single run shows; what lies on a boundary may go either way."""
    random, rows, wrong = np.random.default_rng(9), [], 0
    for sheet in diagram.sheets:
        n, labels = sheet.lattice.cells, sheet.lattice.labels
        for i, j in random.integers(0, n + 1, (SAMPLE, 2)):
            mark = str(labels[i, j])
            regime = "descending" if mark == CLAMPS_ONLY else mark
            found = brute_force(place_at(diagram.scene, sheet.plane, float(sheet.x[i]), float(sheet.y[j])))
            how = "run" if (int(i), int(j)) in sheet.lattice.known else "inferred"
            if found != regime:
                wrong += 1
                rows.append([sheet.plane.name, f"{sheet.x[i]:.4g}", f"{sheet.y[j]:.4g}", how, regime, found])
    header = ("plane", "G", "delta or V", "node", "diagram", "single run")
    show(f"{2 * SAMPLE} nodes of the diagrams by single runs: {wrong} differ", header, rows or [["none"] + [""] * 5])
    assert wrong == 0


def test_boundaries_against_formulas(diagram: PhaseDiagram) -> None:
    """G of the runs over that of the formula, less one.

    First yield: the weight comes on within a third of the beam's period, so that it swings past its static sag; tension
    raises what a thin filament bears. Arrest in every fibre: hinges at the clamps keep turning, and where sections are
    perfectly plastic the thinnest, at the clamps, draws out; nothing in the published theory stops it. Arrest of the
    span: what flows by less than 0.5 sigma_Y/eta counts as arrested, so its line is 1.5 times the exact threshold.
    """
    rows = [
        [sheet.plane.name, one.kind, one.line.name, one.line.source, one.rows]
        + [f"{100 * value:+.0f} %" for value in (one.median, one.least, one.most)]
        for sheet in diagram.sheets
        for one in sheet.distances
    ]
    show("boundaries", ("plane", "boundary", "line", "source", "rows", "median", "least", "most"), rows)
    for sheet in diagram.sheets:
        step = float(sheet.x[1] / sheet.x[0])
        # No filament yields below the bound of the undamped beam, whatever its modes do.
        assert off(sheet, "first yield", "sudden load, undamped beam")[1] > 1 / step - 1
        # Runs are arrested at G < sqrt 2, and those beyond 1.5 times the exact threshold flow along the whole span.
        assert off(sheet, "arrest", "arrest of a shallow catenary")[2] < 0
        assert off(sheet, "arrest of the span", "the same, of rate 0.5")[0] == pytest.approx(0, abs=step - 1)


def off(sheet: PhaseSheet, kind: str, line: str) -> tuple[float, float, float]:
    [one] = [one for one in sheet.distances if (one.kind, one.line.name) == (kind, line)]
    return one.median, one.least, one.most


def bisected(below: Callable[[float], bool], low: float, high: float) -> float:
    for _ in range(9):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if below(middle) else (low, middle)
    return math.sqrt(low * high)


def test_first_yield_goes_from_the_sudden_to_the_slow_line() -> None:
    """Between the two exact lines there is nothing but the ramp of gravity: what the paper's 2 delta leaves out."""
    rows, found = [], {}
    for ramp in (0, 10, 400):
        asked = scene(f"load.ramp={ramp * elastic_time(scene())} s")

        def sound(gravity_number: float, asked: sc.Scene = asked) -> bool:
            with run_pool(1) as pool:
                return run_places(asked, [Place(gravity_number, 26.0, 0.03)], pool)[0].regime == "no-yield"

        found[ramp] = bisected(sound, 0.02, 0.12)
        lines = {line.name: line.at(1.0) for line in phase_lines(asked, PLANES["G-V"], 3) if line.kind == "first yield"}
        rows.append([ramp, f"{found[ramp]:.4f}", *(f"{lines[name]:.4f}" for name in sorted(lines))])
    show("first yield, delta = 0.03, E = 4 MPa", ("ramp t~", "G of the runs", *sorted(lines)), rows)
    assert lines["sudden load, undamped beam"] < found[0] < 1.12 * lines["sudden load, undamped beam"]
    assert found[10] == pytest.approx(0.035, rel=0.01)
    assert found[400] == pytest.approx(lines["slow load, bending and tension"], rel=0.015)
