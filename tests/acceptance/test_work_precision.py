"""What accuracy costs: continual-descent to a true error of 1e-4, against every rival in the diagram."""

from __future__ import annotations

from dataclasses import replace
from math import inf

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.plotting.accuracy import best, knee_sentence, program_rows
from softcat_sym.scene.scene import groups_of
from softcat_sym.studies.work_precision import LEVELS, Plan, WorkPrecision, study
from tests.common.rk4_filament import run as paper_rk4

from .table import show

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]

NAME, ERROR = "continual-descent", 1e-4
OWN = "compiled-rodas5p"
SAME_RUNTIME = {OWN, "compiled-rodas4"}
PLAN = Plan(cells=(20, 40, 60, 80), tolerances=(1e-2, 1e-3, 1e-4, 1e-5), orders=(), cold=False, limit=10.0)


def measured(effects: str) -> WorkPrecision:
    scene = sc.load_scene(NAME, {"run.effects": effects})
    return study(NAME, scene, PLAN)


def judged(found: WorkPrecision, effects: str) -> tuple[float, float]:
    """Print the tables; seconds of the package and of the quickest rival to the error asked."""
    header = ("program", *(f"{level:.0e}" for level in LEVELS), "us/step", "", "")
    show(f"{NAME}, effects {effects}: quickest warm solve with at most this error", header, program_rows(found))
    rows, times = [], {}
    for curve in found.curves:
        row = best(curve, ERROR)
        times[curve.program.key] = row.measured.seconds if row is not None else inf
    for curve in found.curves:
        row = best(curve, ERROR)
        said = curve.refusal or "not reached within the limit"
        cells = [f"{1e3 * row.measured.seconds:.1f}", f"{row.error:.1e}", row.task.text] if row else ["–", "", said]
        rows.append([curve.program.name, *cells, f"{times[curve.program.key] / times[OWN]:.3g}"])
    show(f"to {ERROR:.0e}", ("program", "ms", "error", "with", "times Rodas5P"), rows)
    reference = found.reference
    print(f"{knee_sentence(found)}\n{reference.note}: families {reference.time:.1e} apart, space {reference.space:.1e}")
    # What is read off must be well above what the reference can tell.
    assert reference.floor < ERROR / 5
    assert np.isfinite(reference.time)
    return times[OWN], min(seconds for key, seconds in times.items() if key not in SAME_RUNTIME)


def test_published_theory_to_1e_4_is_faster_than_any_rival() -> None:
    found = measured("paper")
    ours, rival = judged(found, "paper")
    _paper_in_numpy(found, ours)
    print(f"ratio to the best rival: {rival / ours:.3g}")
    assert ours < rival
    # All of them apply to the published theory: whoever has no answer was too slow.
    assert all("stopped" in curve.refusal or "would take" in curve.refusal for curve in found.curves if curve.refusal)


def test_what_auto_chooses_to_1e_4_is_faster_than_any_rival() -> None:
    found = measured("auto")
    ours, rival = judged(found, "auto")
    print(f"ratio to the best rival: {rival / ours:.3g}")
    assert ours < rival
    refused = {curve.program.key: curve.refusal for curve in found.curves if curve.refusal}
    assert "algebraic" in refused["compiled-rk4"]
    assert "algebraic" in refused["scipy-radau"]


def _paper_in_numpy(found: WorkPrecision, ours: float) -> None:
    """The paper's own method, vectorised, on equal cells at its stability limit: it is far from the error asked."""
    groups, rows = groups_of(found.scene), []
    assert groups.G is not None
    assert groups.V is not None
    frames = len(found.reference.midpoint)
    times = np.linspace(0.0, 460.0, frames)[1:].tolist()
    for cells in (10, 20, 40):
        run = paper_rk4(
            groups.delta, groups.G, groups.V, groups.eps_Y, "bingham", "material", cells, 460.0, outputs=times
        )
        error = found.reference.error_of((0.0, *run.midpoint.tolist()))
        seconds = run.wall_seconds
        rows.append([cells, f"{1e3 * seconds:.0f}", f"{error:.1e}", run.steps, f"{4 * run.rhs_microseconds:.0f}"])
        assert error > ERROR
    rows[-1].append(f"{seconds / ours:.3g}")
    show(
        "the paper's RK4 in NumPy, equal cells",
        ("cells", "ms", "error", "steps", "us/step", "times Rodas5P, without reaching 1e-4"),
        [[*row, *[""] * (6 - len(row))] for row in rows],
    )
    assert seconds > ours


def test_a_tighter_limit_lists_what_it_stops() -> None:
    """A rival that is stopped is a line of the table with its reason, not a gap."""
    scene = sc.load_scene(NAME, {"run.effects": "paper"})
    plan = replace(PLAN, cells=(40,), tolerances=(1e-2,), programs=("compiled-rk4", "cvodes"), limit=0.05)
    found = study(NAME, scene, plan)
    (rk4,) = (curve for curve in found.curves if curve.program.key == "compiled-rk4")
    assert "steps would take" in rk4.refusal
    assert all(row.error == inf for row in rk4.rows)
