"""The rivals are what they are said to be: the same scheme, and answers as good as those they are compared with."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.grid import Floats
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Silence
from tests.acceptance.table import show

from . import casadi_rosenbrock, radau, scenes
from .casadi_rosenbrock import compiled_rosenbrock, interpreted_bdf
from .kirchhoff_c import Generated, HandWritten, places_of
from .radau import RadauRival
from .scenes import Physics

NAMES = ("continual-descent", "arrested-overdamped")
BATCHES = 7
ENOUGH = 1e-3


def admissible_states(prepared: Prepared, number: int) -> list[tuple[float, Floats]]:
    """Times and states of a run with noise on top: a fiftieth of the shortest cell, a twentieth of the rest."""
    rng, graph = np.random.default_rng(7), prepared.graph
    kinds, states = np.array(graph.x_kinds), prepared.solve(Silence()).x
    noise = np.full(states.shape[0], 0.02 * graph.grid.cell_length.min())
    found = []
    for frame in rng.integers(1, states.shape[1], number):
        state = states[:, frame]
        for kind in ("u", "v", "a_0", "a_1"):
            noise[kinds == kind] = 0.05 * np.abs(state[kinds == kind]).max()
        found.append((float(rng.uniform(0, 0.5)), state + rng.uniform(-1, 1, len(state)) * noise))
    return found


def worst(prepared: Prepared, rates: list[Floats], exact: list[Floats]) -> float:
    """Largest difference, over the largest rate of its kind."""
    kinds = np.array(prepared.graph.x_kinds)
    return max(
        float(np.max(np.abs(found - wanted)[kinds == kind]) / np.max(np.abs(wanted[kinds == kind])))
        for found, wanted in zip(rates, exact, strict=True)
        for kind in set(prepared.graph.x_kinds)
    )


@pytest.mark.parametrize("name", NAMES)
def test_right_hand_sides_are_those_of_the_graph(name: str) -> None:
    prepared = scenes.prepare(name, frames=41)
    graph, states = prepared.graph, admissible_states(prepared, 20)
    interpreted = ca.Function("rates", [graph.t, graph.x, graph.p], [graph.ode])
    exact = [np.asarray(interpreted(t, x, prepared.p)).ravel() for t, x in states]
    bending = np.array(graph.x_kinds) == "a_1"
    assert all(0 < np.count_nonzero(rate[bending]) for rate in exact), "some sections yield"
    hand, numpy = HandWritten(graph, prepared.p), RadauRival(prepared)
    places = numpy.filament.places(places_of(graph))
    vectorised = []
    for t, x in states:
        full = numpy.start.copy()
        full[places] = x
        vectorised.append(numpy.filament.rates(t, full)[places])
    rows = [
        ["hand-written C", worst(prepared, [hand.rates(t, x) for t, x in states], exact)],
        ["vectorised NumPy", worst(prepared, vectorised, exact)],
    ]
    show(
        f"{name}: right-hand side against the interpreted graph, 20 states",
        ("", "worst of any kind"),
        [[label, f"{error:.1e}"] for label, error in rows],
    )
    assert all(error < 1e-12 for _, error in rows)


@pytest.mark.slow
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


def test_jacobian_of_the_radau_rival_is_that_of_the_graph() -> None:
    prepared = scenes.prepare("continual-descent", frames=41)
    graph, rival = prepared.graph, RadauRival(prepared)
    exact = ca.Function("jacobian", [graph.t, graph.x, graph.p], [ca.jacobian(graph.ode, graph.x)])
    places = rival.filament.places(places_of(graph))
    kinds = np.array(graph.x_kinds)
    for t, x in admissible_states(prepared, 3):
        full = rival.start.copy()
        full[places] = x
        found = rival.jacobian(t, full).toarray()[np.ix_(places, places)]
        wanted = np.asarray(exact(t, x, prepared.p))
        for kind in set(graph.x_kinds):
            scale = np.abs(wanted[kinds == kind]).max()
            assert np.abs(found - wanted)[kinds == kind].max() < 1e-2 * scale, kind


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.parametrize("physics", ["paper", "fibres"])
@pytest.mark.parametrize("name", NAMES)
def test_converged_midpoints_are_what_is_stored(name: str, physics: Physics) -> None:
    stored = scenes.converged_midpoint(name, physics), scenes.converged_error(name, physics)
    found = scenes.extrapolate(name, physics)
    show(f"{name}, {physics}", ("stored", "found", "error"), [[stored[0], found.value, f"{found.error:.1e}"]])
    assert abs(found.value - stored[0]) < stored[1]
