"""The graph of a filament that does not stretch holds heights and bending alone, and conserves what it should."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import End, Grid, half_span, whole_span

from .filaments import SMALL_GRID, build, parameters, place, random_state, rhs, scene_of, value
from .test_energy import GRIDS, balance

BEAM = ("inertia", "bending", "viscous-flow", "yielding", "gravity-ramp")


def beam(law: str = "bingham", section: str = "rectangle", grid: Grid = SMALL_GRID, *, axial: bool = False) -> Graph:
    """The paper's filament without finite stretch, thinning and large rotation, and without extensibility."""
    names = [*BEAM, "extensibility"] if axial else list(BEAM)
    flow = {"elastic": ("viscous-flow", "yielding"), "maxwell": ("yielding",)}.get(law, ())
    asked = scene_of(law, section=section).replace({"run.effects": [name for name in names if name not in flow]})
    return build(asked, grid)


def test_it_has_fewer_states_and_instructions_and_no_further_parameter() -> None:
    for section in ["rectangle", "circle"]:
        for law in ["elastic", "maxwell", "bingham"]:
            plain, axial = beam(law, section), beam(law, section, axial=True)
            kinds, all_kinds = ({place(name)[0] for name in graph.state_names} for graph in (plain, axial))
            assert kinds == all_kinds - {"x", "u", "a_0"}
            assert "a_0" not in plain.profiles
            assert set(plain.parameters) <= set(axial.parameters)
            print(f"{law} {section}: {plain.instructions} of {axial.instructions} instructions")
            assert plain.instructions < 0.7 * axial.instructions


def test_energy_is_kept_or_dissipated() -> None:
    for grid in list(GRIDS):
        for law, section in [("bingham", "circle"), ("maxwell", "rectangle"), ("elastic", "circle")]:
            graph = beam(law, section, GRIDS[grid])
            assert graph.conserves_energy
            for seed in range(3):
                residual, size = balance(graph, scene_of(law, section=section), seed)
                assert abs(residual) <= 1e-12 * size


@pytest.mark.parametrize("ends", [(End.CLAMPED, End.FREE), (End.FREE, End.CLAMPED), (End.CLAMPED, End.PINNED)])
def test_nodes_stay_above_their_places(ends: tuple[End, End]) -> None:
    grid = whole_span(4, *ends)
    graph = beam(grid=grid)
    x, z = random_state(graph, 1)
    seen = graph.observe(np.zeros(1), x[:, None], z[:, None], parameters(scene_of(), graph))
    np.testing.assert_allclose(seen["x"][0], 0.2 * grid.nodes, atol=1e-16)
    assert not np.any(seen["tension"])
    assert np.all(seen["stretch"] == 1)


def test_an_elastic_one_is_linear() -> None:
    scene, graph = scene_of("elastic"), beam("elastic")
    p, function = parameters(scene, graph), rhs(graph)
    states = [random_state(graph, seed, 10.0)[0] for seed in (1, 2)]
    one, two, both, none = (value(function, 0.0, x, [], p)[0] for x in (*states, sum(states), 0 * states[0]))
    np.testing.assert_allclose(one + two - none, both, rtol=1e-12, atol=1e-12 * np.max(np.abs(both)))


def test_pinned_half_spans_carry_no_moment_at_the_support() -> None:
    graph = beam(grid=half_span(5, End.PINNED))
    assert ("a_1", 5) not in {place(name) for name in graph.state_names}
    assert ("a_1", 0) in {place(name) for name in graph.state_names}
