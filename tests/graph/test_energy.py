"""The discrete filament conserves what the continuous one does, to rounding, at any state."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.assembly import energy_scale
from softcat_sym.discretization.graph import Graph, parameter_values
from softcat_sym.discretization.grid import End, Floats, Grid, half_span, whole_span
from softcat_sym.scene.scene import Scene

from .filaments import SMALL_GRID, build, energy_of, parameters, place, random_state, scene_of, value

STORED = ("energy_kinetic", "energy_elastic", "energy_potential")
GRIDS = {
    "half": SMALL_GRID,
    "half pinned": half_span(5, End.PINNED),
    "whole": whole_span(3, End.CLAMPED, End.PINNED),
    "graded": Grid(np.array([0.0, 0.13, 0.3, 0.42, 0.5]), End.SYMMETRY, End.CLAMPED),
}


def balance(graph: Graph, scene: Scene, seed: int, time: float = 0.3) -> tuple[float, float]:
    """d(energy)/dt + plastic power - power of the changing load, and the size of what was added up."""
    energy = energy_of(graph, STORED)
    gradient, drift = ca.gradient(energy, graph.x), ca.jacobian(energy, graph.t)
    values = parameter_values(scene)
    span = values["span"]
    unit = energy_scale(values["density"], span, values["time_scale"])
    function = ca.Function(
        "power", [graph.t, graph.x, graph.p], [gradient * graph.ode, drift, graph.quad * span * unit]
    )
    x, _ = random_state(graph, seed)
    parts, pushed, (lost, gained, steepened) = value(function, time, x, parameters(scene, graph))
    return float(np.sum(parts) + np.sum(pushed) + lost + steepened - gained), float(np.sum(np.abs(parts)) + abs(lost))


def test_energy_is_kept_or_dissipated() -> None:
    for law, section, grid in [
        *(("bingham", "rectangle", grid) for grid in GRIDS),
        ("bingham", "circle", "half"),
        ("maxwell", "circle", "graded"),
        ("maxwell", "rectangle", "half pinned"),
        ("elastic", "rectangle", "half"),
        ("elastic", "circle", "whole"),
    ]:
        scene = scene_of(law, section=section)
        graph = build(scene, GRIDS[grid])
        for seed in range(3):
            residual, size = balance(graph, scene, seed)
            assert abs(residual) <= 1e-12 * size


def test_so_do_the_reduced_filaments() -> None:
    for without in [
        ("bending",),
        ("large-rotation",),
        ("finite-stretch", "thinning"),
        ("finite-stretch", "thinning", "large-rotation"),
    ]:
        scene = scene_of()
        graph = build(scene, without=without)
        for seed in range(3):
            residual, size = balance(graph, scene, seed)
            assert abs(residual) <= 1e-12 * size


def test_the_printed_closure_does_not_balance() -> None:
    """Which is why energy is judged with the material closure only."""
    scene = scene_of(closure="printed")
    residual, size = balance(build(scene), scene, 0)
    assert abs(residual) > 1e-4 * size


@pytest.mark.parametrize("time", [0.0, 0.35, 5.0], ids=["start", "ramp", "after"])
def test_a_changing_load_does_work(time: float) -> None:
    scene = scene_of("elastic")
    residual, size = balance(build(scene), scene, 4, time)
    assert abs(residual) <= 1e-12 * size


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_flow_only_ever_dissipates(section: str) -> None:
    scene = scene_of(section=section)
    graph = build(scene)
    power = ca.Function("power", [graph.t, graph.x, graph.p], [graph.quad[0]])
    for seed in range(20):
        x, _ = random_state(graph, seed, size=0.05 * (seed + 1) / 20)
        assert value(power, 0.0, x, parameters(scene, graph))[0][0] >= 0


def test_forces_are_minus_the_gradient_of_the_energy() -> None:
    for without, grid in [
        *(((), grid) for grid in GRIDS),
        (("large-rotation",), "half"),
        (("bending",), "half"),
        (("bending",), "whole"),
    ]:
        scene = scene_of()
        graph = build(scene, GRIDS[grid], without)
        slope = ca.gradient(energy_of(graph, ("energy_elastic", "energy_potential")), graph.x)
        x, _ = random_state(graph, 5)
        function = ca.Function("g", [graph.t, graph.x, graph.p], [slope, graph.ode])
        gradient, rates = value(function, 0.3, x, parameters(scene, graph))
        values = parameter_values(scene)
        span, unit = values["span"], values["time_scale"]
        index = {place(name): k for k, name in enumerate(graph.state_names)}
        pairs = [(index[kind, n], index[{"u": "x", "v": "y"}[kind], n], n) for kind, n in index if kind in ("u", "v")]
        assert pairs
        forces, wanted = (
            np.array(found)
            for found in zip(
                *(
                    (
                        rates[fast] * span / unit**2 * values["density"] * span * graph.grid.node_length[node],
                        -gradient[slow] / span,
                    )
                    for fast, slow, node in pairs
                ),
                strict=True,
            )
        )
        np.testing.assert_allclose(forces, wanted, rtol=0, atol=1e-11 * np.max(np.abs(wanted)))


def test_without_inertia_the_same_forces_balance() -> None:
    scene = scene_of()
    moving, still = build(scene), build(scene, without=("inertia",))
    state = dict(zip(moving.state_names, random_state(moving, 6)[0], strict=True))
    forces = dict(zip(moving.state_names, rate(moving, scene, state), strict=True))
    x = np.array([state[name] for name in still.state_names])
    z = np.array([state[name] for name in still.algebraic_names])
    function = ca.Function("dae", [still.t, still.x, still.z, still.p], [still.ode, still.alg])
    ode, alg = value(function, 0.3, x, z, parameters(scene, still))
    np.testing.assert_allclose(ode, [forces[name] for name in still.state_names], rtol=1e-11, atol=1e-13)
    wanted = np.array([forces[{"x": "u", "y": "v"}[name[0]] + name[1:]] for name in still.algebraic_names])
    np.testing.assert_allclose(alg, wanted, rtol=0, atol=1e-11 * np.max(np.abs(wanted)))


def rate(graph: Graph, scene: Scene, state: dict[str, float]) -> Floats:
    function = ca.Function("ode", [graph.t, graph.x, graph.p], [graph.ode])
    return value(function, 0.3, np.array([state[n] for n in graph.state_names]), parameters(scene, graph))[0]


@pytest.mark.parametrize(
    ("law", "support", "closure"),
    [
        ("bingham", End.CLAMPED, "material"),
        ("bingham", End.PINNED, "printed"),
        ("elastic", End.CLAMPED, "printed"),
        ("elastic", End.PINNED, "material"),
    ],
)
def test_half_a_span_is_the_whole_at_a_symmetric_state(law: str, support: End, closure: str) -> None:
    scene = scene_of(law, closure=closure)
    cells = 5
    half, whole = build(scene, half_span(cells, support)), build(scene, whole_span(cells, support, support))
    right = dict(zip(map(place, half.state_names), random_state(half, 7)[0], strict=True))
    # x and u vanish on the symmetry plane, where they are no unknowns
    right |= {("x", 0): 0.0, ("u", 0): 0.0}

    def reflected(name: str) -> tuple[tuple[str, int], float]:
        kind, number = place(name)
        on_cells = kind == "a_0"
        offset = number - cells
        folded = offset if offset >= 0 else -offset - on_cells
        return (kind, folded), -1.0 if kind in ("x", "u") and offset < 0 else 1.0

    state = {name: sign * right[key] for name in whole.state_names for key, sign in [reflected(name)]}
    found = dict(zip(whole.state_names, rate(whole, scene, state), strict=True))
    names = {name: right[place(name)] for name in half.state_names}
    wanted = dict(zip(map(place, half.state_names), rate(half, scene, names), strict=True))
    wanted |= {("x", 0): 0.0, ("u", 0): 0.0}
    size = max(map(abs, found.values()))
    for name, speed in found.items():
        key, sign = reflected(name)
        assert speed == pytest.approx(sign * wanted[key], abs=1e-11 * size), name


@pytest.mark.parametrize("direction", ["u", "v"])
def test_internal_forces_telescope(direction: str) -> None:
    """Their sum over all nodes is the difference of the two end forces: what happens far from the ends drops out."""
    cells = 12
    scene = scene_of("elastic")
    graph = build(scene, whole_span(cells // 2, End.CLAMPED, End.CLAMPED))
    mass = dict(enumerate(graph.grid.node_length))
    chosen = [(k, place(name)[1]) for k, name in enumerate(graph.state_names) if name.startswith(direction)]
    total = sum((graph.ode[k] * mass[node] for k, node in chosen), ca.SX(0))
    single = graph.ode[chosen[len(chosen) // 2][0]] * mass[chosen[len(chosen) // 2][1]]
    slopes = ca.Function("s", [graph.t, graph.x, graph.p], [ca.gradient(total, graph.x), ca.gradient(single, graph.x)])
    x, _ = random_state(graph, 8)
    of_sum, of_one = value(slopes, 0.0, x, parameters(scene, graph))
    inner = [k for k, name in enumerate(graph.state_names) if name[0] in "xy" and 4 <= place(name)[1] <= cells - 4]
    assert inner
    assert np.max(np.abs(of_sum[inner])) <= 1e-11 * np.max(np.abs(of_one))


def test_top_and_bottom_are_the_same() -> None:
    """Mirroring a pinned filament in the line of its supports keeps every stored energy but that of the weight."""
    scene = scene_of(ramp="0 s")
    graph = build(scene, whole_span(3, End.PINNED, End.PINNED))
    x, _ = random_state(graph, 9)
    flip = np.array([-1.0 if name.startswith(("y", "v", "a_1")) else 1.0 for name in graph.state_names])
    energies = [graph.observables.name_out().index(name) for name in STORED]
    seen = [value(graph.observables, 0.0, state, np.zeros(0), parameters(scene, graph)) for state in (x, x * flip)]
    kinetic, elastic, potential = ((seen[0][k][0], seen[1][k][0]) for k in energies)
    assert kinetic[0] == kinetic[1] > 0
    assert elastic[0] == pytest.approx(elastic[1], rel=1e-13)
    assert elastic[0] > 0
    assert potential[0] == pytest.approx(-potential[1], rel=1e-13)
