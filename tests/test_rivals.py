"""SciPy's rival is what it is said to be: the same scheme as the graph of the package."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Silence
from tests.common.rivals import scenes
from tests.common.rivals.radau import RadauRival, places_of

pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
NAMES = ("continual-descent", "arrested-overdamped")


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


def test_the_right_hand_side_is_that_of_the_graph() -> None:
    for name in NAMES:
        prepared = scenes.prepare(name, frames=41)
        graph, states = prepared.graph, admissible_states(prepared, 20)
        interpreted = ca.Function("rates", [graph.t, graph.x, graph.p], [graph.ode])
        exact = [np.asarray(interpreted(t, x, prepared.p)).ravel() for t, x in states]
        kinds = np.array(graph.x_kinds)
        assert all(0 < np.count_nonzero(rate[kinds == "a_1"]) for rate in exact), "some sections yield"
        rival = RadauRival(prepared)
        places = rival.filament.places(places_of(graph))
        full = np.tile(rival.start, (len(states), 1))
        full[:, places] = [x for _, x in states]
        vectorised = [rival.filament.rates(t, state)[places] for (t, _), state in zip(states, full, strict=True)]
        assert worst(prepared, vectorised, exact) < 1e-12, name
