"""What the rivals cost, and answers as good as those they are compared with."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.codegen.compiler import find_compiler
from tests.common.rivals import casadi_rosenbrock, radau, scenes
from tests.common.rivals.casadi_rosenbrock import compiled_rosenbrock, interpreted_bdf
from tests.common.rivals.kirchhoff_c import Generated, HandWritten
from tests.common.rivals.radau import RadauRival
from tests.common.rivals.scenes import Physics
from tests.common.table import show
from tests.test_rivals import NAMES, admissible_states, worst

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]
BATCHES = 7
ENOUGH = 1e-3


def test_microseconds_of_a_right_hand_side() -> None:
    rows = []
    for cells in (40, 320):
        prepared = scenes.prepare("continual-descent", cells=cells, frames=41)
        t, x = admissible_states(prepared, 1)[0]
        rivals = (HandWritten(prepared.graph, prepared.p), Generated(prepared.graph, prepared.p))
        calls = 160_000 // cells
        spent = np.median([[rival.seconds(t, x, calls) for rival in rivals] for _ in range(BATCHES)], axis=0) * 1e6
        numpy = np.median([RadauRival(prepared).microseconds() for _ in range(BATCHES)])
        assert worst(prepared, [rivals[1].rates(t, x)], [rivals[0].rates(t, x)]) < 1e-12
        rows.append([cells, f"{spent[0]:.2f}", f"{spent[1]:.2f}", f"{spent[1] / spent[0]:.1f}", f"{numpy:.0f}"])
        assert spent[0] < spent[1]
    header = ("cells", "by hand", "CasADi's C", "ratio", "NumPy")
    show(f"us per right-hand side, continual-descent, medians of {BATCHES}", header, rows)


def test_radau_finds_the_converged_midpoint() -> None:
    rows = []
    for name in NAMES:
        rival = RadauRival(scenes.prepare(name))
        rtol, atol = radau.LOOSEST[name]
        runs = [rival.solve(rtol, atol) for _ in range(BATCHES)]
        error = runs[0].midpoint / scenes.converged_midpoint(name) - 1
        seconds = float(np.median([run.seconds for run in runs]))
        cost = [f"{seconds:.3f}", runs[0].steps, runs[0].evaluations, f"{rival.microseconds():.0f}"]
        rows.append([name, f"{rtol:g}", f"{atol:g}", *cost, f"{error:.1e}"])
        assert abs(error) < ENOUGH
    header = ("scene", "rtol", "atol", "seconds", "steps", "evaluations", "us of one", "error")
    show(f"SciPy's Radau, N = 40, paper's effects, medians of {BATCHES}", header, rows)


@pytest.mark.parametrize("physics", ["paper", "fibres"])
def test_casadis_own_integrators(physics: Physics) -> None:
    rows = []
    for name in NAMES:
        compiled, rival = compiled_rosenbrock(name, physics)
        chosen, loosest = (interpreted_bdf(name, physics, loosest=loose) for loose in (False, True))
        size = f"{rival.size / 1e3:.0f} kB, {rival.generating + rival.compiling:.1f} s"
        found = [("rosenbrock in C", compiled, size), ("BDF as chosen", chosen, ""), ("BDF, loosest", loosest, "")]
        rows += [[name, label, f"{t.seconds:.4f}", f"{t.error:.1e}", t.steps, note] for label, t, note in found]
        assert all(abs(timed.error) < ENOUGH for _, timed, _ in found)
    header = ("scene", "", "seconds", "error", "steps", "C text, generating and compiling")
    show(f"CasADi's integrators, N = 40, {physics}, medians of {casadi_rosenbrock.REPEATS}", header, rows)


@pytest.mark.parametrize("physics", ["paper", "fibres"])
@pytest.mark.parametrize("name", NAMES)
def test_converged_midpoints_are_what_is_stored(name: str, physics: Physics) -> None:
    stored = scenes.converged_midpoint(name, physics), scenes.converged_error(name, physics)
    found = scenes.extrapolate(name, physics)
    show(f"{name}, {physics}", ("stored", "found", "error"), [[stored[0], found.value, f"{found.error:.1e}"]])
    assert abs(found.value - stored[0]) < stored[1]
