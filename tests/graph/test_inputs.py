"""Material and load are inputs: a graph built once serves every value."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.graph import CATALOGUE, TIME_SCALE, parameter_values, time_scale
from softcat_sym.discretization.grid import End, half_span

from .filaments import build, parameters, random_state, rhs, scene_of, value


@pytest.mark.parametrize("without", [(), ("inertia",)], ids=["ode", "dae"])
def test_the_right_hand_side_depends_on_every_parameter(without: tuple[str, ...]) -> None:
    graph = build(scene_of(), without=without)
    beyond_the_paper = {
        *("poisson", "aspect", "curvature", "shake", "shake_frequency"),
        *("surface_tension", "solid_viscosity"),
    }
    assert set(graph.parameters) == {p.name for p in CATALOGUE} - beyond_the_paper | {TIME_SCALE}
    everything = ca.vertcat(graph.ode, graph.alg)
    touched = ca.DM(ca.jacobian_sparsity(everything, graph.p), 1)
    for k, name in enumerate(graph.parameters):
        assert float(ca.sum1(touched[:, k])) > 0, name


def test_changing_a_value_is_rebuilding() -> None:
    for change in [
        {"material.yield_stress": "3 kPa"},
        {"material.youngs_modulus": "40 MPa"},
        {"material.viscosity": "1 kPa*s"},
        {"filament.thickness": "2 mm"},
        {"filament.span": "0.31 m"},
        {"filament.density": "1000 kg/m^3"},
        {"load.gravity": "1.62 m/s^2"},
        {"load.ramp": "0.3 s"},
    ]:
        old = scene_of()
        new = old.replace(change)
        kept, rebuilt = build(old), build(new)
        x, z = random_state(kept, 1)
        at = parameters(new, kept)
        before = value(rhs(kept), 0.3, x, z, parameters(old, kept))
        one, two = value(rhs(kept), 0.3, x, z, at), value(rhs(rebuilt), 0.3, x, z, parameters(new, rebuilt))
        for a, b in zip(one, two, strict=True):
            np.testing.assert_array_equal(a, b)
        assert not np.array_equal(one[0], before[0])


def test_a_missing_value_is_named() -> None:
    graph = build(scene_of())
    values = parameter_values(scene_of("maxwell"))
    with pytest.raises(KeyError, match="yield_stress"):
        graph.vector(values)


def test_time_is_an_input_only_with_a_ramp_or_a_shake() -> None:
    ramped, sudden = build(scene_of()), build(scene_of(ramp="0 s"))
    assert ca.depends_on(ramped.ode, ramped.t)
    assert not ca.depends_on(ca.vertcat(sudden.ode, sudden.quad), sudden.t)
    shaken = build(scene_of(ramp="0 s").replace({"load.shake": 0.5, "load.shake_frequency": "3 Hz"}))
    assert ca.depends_on(shaken.ode, shaken.t)
    assert {*shaken.parameters} - {*sudden.parameters} == {"shake", "shake_frequency"}
    assert float(ca.Function("work", [sudden.x, sudden.p], [sudden.quad[1]])(*sudden_inputs())) == 0


def sudden_inputs() -> tuple[np.ndarray, np.ndarray]:
    scene = scene_of(ramp="0 s")
    graph = build(scene)
    return random_state(graph, 2)[0], parameters(scene, graph)


@pytest.mark.parametrize("law", ["elastic", "bingham"])
def test_the_jacobian_is_banded_whatever_the_grid(law: str) -> None:
    """Unknowns are sorted along the filament: the bandwidth is that of a few neighbours, not of the span."""
    widths = []
    for cells in (8, 16):
        graph = build(scene_of(law), half_span(cells, End.CLAMPED))
        pattern = ca.jacobian_sparsity(graph.ode, graph.x)
        widths.append((pattern.bw_lower(), pattern.bw_upper()))
    assert widths[0] == widths[1]
    per_cell = 4 if law == "elastic" else 6
    assert max(widths[0]) <= 4 * per_cell


def test_the_unit_of_time_does_not_matter() -> None:
    """Positions are per span, velocities span per unit of time: another unit scales the rates and nothing else."""
    scene = scene_of()
    graph = build(scene)
    x, z = random_state(graph, 3)
    moving = np.array([name.startswith(("u", "v")) for name in graph.state_names])
    values = parameter_values(scene)
    one = value(rhs(graph), 0.2, x, z, graph.vector(values))[0]
    faster = {**values, TIME_SCALE: values[TIME_SCALE] / 2}
    # half the unit: velocities half, rates of velocity a quarter
    two = value(rhs(graph), 0.4, np.where(moving, x / 2, x), z, graph.vector(faster))[0]
    np.testing.assert_allclose(two, np.where(moving, one / 4, one / 2), rtol=1e-12, atol=1e-15)


def test_units_of_time() -> None:
    scene = scene_of()
    assert time_scale(scene) == pytest.approx(np.sqrt(0.2 / 9.81))
    weightless = scene.replace({"load.gravity": "0 m/s^2"})
    assert time_scale(weightless) == pytest.approx(0.2 * np.sqrt(1900 / 4e6))


def test_observing_gives_a_row_for_each_time() -> None:
    scene = scene_of()
    graph = build(scene)
    states = np.stack([random_state(graph, seed)[0] for seed in range(3)], axis=1)
    seen = graph.observe(np.zeros(3), states, np.zeros((0, 3)), parameters(scene, graph))
    cells = graph.grid.cells
    for name, shape in (("x", cells + 1), ("stretch", cells), ("moment", cells), ("energy_elastic", 1)):
        assert seen[name].shape == (3, shape)
    alone = graph.observe(np.zeros(1), states[:, 1:2], np.zeros((0, 1)), parameters(scene, graph))
    for name, field in alone.items():
        np.testing.assert_array_equal(field[0], seen[name][1])
