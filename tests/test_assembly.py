"""The discrete filament conserves what the continuous one does, to rounding, at any state; numbers are inputs."""

from __future__ import annotations

import re
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Grid, half_span, whole_span
from softcat_sym.discretization.parameters import energy_scale, parameter_values
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.ends import CLAMPED, PINNED
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.equilibrium import Equilibrium
from tests.common.assembled import (
    GRIDS,
    build,
    energy_of,
    parameters,
    place,
    random_state,
    scene_of,
    value,
)

STORED = ("energy_kinetic", "energy_elastic", "energy_potential")
GEOMETRY = ("bending", "finite-stretch", "thinning", "large-rotation")
SHEARS: dict[str, tuple[str, ...]] = {
    "fibres alone": (),
    "shear": ("shear",),
    "shear, gradient": ("shear", "necking-gradient"),
    "shear, rotary": ("shear", "rotary-inertia"),
    "everything": ("shear", "necking-gradient", "rotary-inertia"),
}
TIME = 0.3


def flowing(scene: Scene, *names: str) -> Scene:
    """The scene with these effects, those of flow only as its law has them."""
    without = {"elastic": ("viscous-flow", "yielding"), "maxwell": ("yielding",)}.get(scene.material.law, ())
    return scene.replace({"run.effects": [name for name in names if name not in without]})


def resolved(scene: Scene, grid: Grid, more: tuple[str, ...] = (), **numerics: int) -> Graph:
    """The scene's filament with inertia, fibres or amplitudes of its section, the flow of its law and these effects."""
    names = ("inertia", *GEOMETRY, "viscous-flow", "yielding", "gravity-ramp", "fibres", *more)
    return build(flowing(scene, *names).replace({f"numerics.{key}": n for key, n in numerics.items()}), grid)


def settled(graph: Graph, scene: Scene, seed: int, size: float = 0.01) -> tuple[Floats, Floats]:
    """A random state, its section angles where their torques balance."""
    x, z = random_state(graph, seed, size)
    if not graph.is_dae:
        return x, z
    found = Equilibrium(graph).search(TIME, x, parameters(scene, graph), [z, graph.straight])
    assert found is not None
    return x, found


def imbalance(graph: Graph, scene: Scene, time: float = TIME, size: float = 0.02) -> float:
    """Largest |d(energy)/dt + dissipation + power of the gradient - power of the load| over what was added up.

    At random states; with section angles from their own balance the energy does not depend on how fast they turn.
    """
    energy, values = energy_of(graph, STORED), parameter_values(scene)
    unit = values["span"] * energy_scale(values["density"], values["span"], values["time_scale"])
    inputs = graph.symbolic.inputs
    rates = [
        ca.gradient(energy, graph.symbolic.x) * graph.symbolic.ode,
        ca.jacobian(energy, graph.symbolic.t),
        graph.symbolic.quad * unit,
    ]
    function = ca.Function("power", inputs, [*rates, ca.gradient(energy, graph.symbolic.z), energy])
    worst = 0.0
    for seed in range(3):
        at = (time, *settled(graph, scene, seed, size), parameters(scene, graph))
        parts, drift, (lost, gained, steepened), slope, stored = value(function, *at)
        assert np.max(np.abs(slope), initial=0.0) <= 1e-8 * abs(stored[0])
        residual = float(np.sum(parts) + np.sum(drift) + lost + steepened - gained)
        worst = max(worst, abs(residual) / float(np.sum(np.abs(parts)) + abs(lost) + abs(steepened)))
    return worst


def test_the_published_filament_keeps_or_dissipates_its_energy() -> None:
    for law, section, grid in [
        *(("bingham", "rectangle", grid) for grid in GRIDS),
        ("bingham", "circle", "half"),
        ("maxwell", "circle", "graded"),
        ("maxwell", "rectangle", "half pinned"),
        ("elastic", "circle", "whole"),
    ]:
        scene = scene_of(law, section=section)
        assert imbalance(build(scene, GRIDS[grid]), scene) <= 1e-12, (law, section, grid)
    for absent in [
        ("bending",),
        ("large-rotation",),
        ("finite-stretch", "thinning"),
        ("finite-stretch", "thinning", "large-rotation"),
    ]:
        assert imbalance(build(scene_of(), absent=absent), scene_of()) <= 1e-12, absent
    for time in (0.0, 0.35, 5.0):  # at the start, within and after the ramp a changing load does work
        assert imbalance(build(scene_of("elastic")), scene_of("elastic"), time) <= 1e-12, time
    for grid in (half_span(6, CLAMPED, 10.0), whole_span(4, CLAMPED, PINNED, 10.0)):
        # So close to the straight filament that no cell, however short, is turned inside out.
        assert imbalance(build(scene_of(), grid), scene_of(), size=0.002) <= 1e-12
    printed = scene_of(closure="printed")
    assert imbalance(build(printed), printed) > 1e-4, "which is why energy is judged with the material closure only"


@pytest.mark.slow
def test_the_filament_that_shears_keeps_or_dissipates_its_energy() -> None:
    for law, section, grid, variant, numerics in [
        *(("bingham", "rectangle", grid, "everything", {"fibres": 4}) for grid in GRIDS),
        *(("bingham", "rectangle", "graded", variant, {"fibres": 3}) for variant in SHEARS),
        ("bingham", "circle", "half", "shear, gradient", {"fibres": 4}),
        ("bingham", "circle", "whole", "everything", {"order": 3}),
        ("bingham", "rectangle", "half pinned", "shear, gradient", {"order": 2}),
        ("bingham", "circle", "graded", "fibres alone", {"order": 3}),
        ("maxwell", "rectangle", "graded", "everything", {}),
        ("maxwell", "circle", "whole", "shear", {}),
        ("bingham", "sheet", "graded", "everything", {"fibres": 4}),
        ("bingham", "sheet", "half", "shear", {"order": 2}),
    ]:
        scene = scene_of(law, section=section)
        graph = resolved(scene, GRIDS[grid], SHEARS[variant], **numerics)
        assert graph.is_dae is ("rotary" not in variant and variant != "everything")
        assert imbalance(graph, scene, size=0.01) <= 1e-12, (law, section, grid, variant)
    graph = resolved(scene_of(), half_span(6, CLAMPED, 10.0), SHEARS["everything"], fibres=4)
    assert imbalance(graph, scene_of(), size=0.002) <= 1e-12
    # Far from the straight filament, where what the stretch carries is a tenth of the shear.
    for section in SECTIONS:
        graph = resolved(scene_of(section=section), GRIDS["whole"], SHEARS["everything"], fibres=4)
        assert imbalance(graph, scene_of(section=section), size=0.05) <= 1e-12, section


@pytest.mark.parametrize("section", list(SECTIONS))
def test_a_viscous_stress_beside_a_section_that_shears_loses_twice_its_potential(section: str) -> None:
    scene = scene_of("maxwell", section=section).replace({"material.law": "kelvin-voigt"})
    names = ("inertia", *GEOMETRY, "viscous-stress", "gravity-ramp", "shear", "rotary-inertia")
    graph = build(scene.replace({"run.effects": list(names)}), GRIDS["whole"])
    assert imbalance(graph, scene, size=0.02) <= 1e-12


def test_a_mirrored_filament_that_shears_moves_as_its_mirror_image() -> None:
    """In the line of its supports, without weight: shear, angles and what is above change sign or side."""
    graph = resolved(scene_of(), whole_span(4, CLAMPED, PINNED), SHEARS["everything"], fibres=4)
    names = list(graph.differential.names)

    def image(name: str) -> str:
        kind, _, number = name.partition("[")[0].partition("_")
        return name.replace(f"_{number}", f"_{3 - int(number)}", 1) if kind in ("axial", "shear") else name

    sides = np.array([names.index(image(name)) for name in names])
    signs = np.array([-1.0 if name.startswith(("y", "v", "psi", "omega", "shear")) else 1.0 for name in names])
    assert {-1.0, 1.0} == set(signs) and np.any(sides != np.arange(len(names)))
    motion = ca.Function("motion", graph.symbolic.inputs, [graph.symbolic.ode])
    p = parameters(scene_of(), graph)
    for seed in range(3):
        x, z = random_state(graph, seed)
        (one,), (other,) = (value(motion, 0.0, state, z, p) for state in (x, signs * x[sides]))
        assert np.any(np.abs(one[[name.startswith("shear") for name in names]]) > 0)
        assert other == pytest.approx(signs * one[sides], rel=1e-9, abs=1e-9 * float(np.max(np.abs(one))))


def test_flow_only_ever_dissipates() -> None:
    for section in ("rectangle", "circle"):
        scene = scene_of(section=section)
        graphs = [build(scene)]
        graphs += [
            resolved(scene, GRIDS["half"], SHEARS[variant], **numerics)
            for variant in ("shear, gradient", "everything")
            for numerics in ({"fibres": 4}, {"order": 3})
        ]
        for graph in graphs if section == "rectangle" else graphs[:1]:
            power = ca.Function("power", graph.symbolic.inputs, [graph.symbolic.powers[0]])
            for seed in range(10):
                state = random_state(graph, seed, size=0.01 * (seed + 1) / 10)
                (lost,) = value(power, TIME, *state, parameters(scene, graph))
                assert np.all(lost >= 0) and np.any(lost > 0)


def test_forces_are_minus_the_gradient_of_the_energy() -> None:
    scene = scene_of()
    values = parameter_values(scene)
    span, unit = values["span"], values["time_scale"]
    for absent, grid in [
        *(((), grid) for grid in GRIDS),
        (("large-rotation",), "half"),
        (("bending",), "half"),
        (("bending",), "whole"),
    ]:
        graph = build(scene, GRIDS[grid], absent)
        slope = ca.gradient(energy_of(graph, ("energy_elastic", "energy_potential")), graph.symbolic.x)
        function = ca.Function("g", [graph.symbolic.t, graph.symbolic.x, graph.symbolic.p], [slope, graph.symbolic.ode])
        gradient, rates = value(function, TIME, random_state(graph, 5)[0], parameters(scene, graph))
        index = {place(name): k for k, name in enumerate(graph.differential.names)}
        pairs = [(k, index[{"u": "x", "v": "y"}[kind], n], n) for (kind, n), k in index.items() if kind in ("u", "v")]
        fast, slow, nodes = (np.array(part) for part in zip(*pairs, strict=True))
        forces = rates[fast] * span / unit**2 * values["density"] * span * graph.grid.node_length[nodes]
        wanted = -gradient[slow] / span
        np.testing.assert_allclose(forces, wanted, rtol=0, atol=1e-11 * np.max(np.abs(wanted)))


def rate(graph: Graph, scene: Scene, state: dict[str, float]) -> dict[str, float]:
    function = ca.Function("ode", [graph.symbolic.t, graph.symbolic.x, graph.symbolic.p], [graph.symbolic.ode])
    found = value(function, TIME, np.array([state[n] for n in graph.differential.names]), parameters(scene, graph))[0]
    return dict(zip(graph.differential.names, found.tolist(), strict=True))


def test_half_a_span_is_the_whole_at_a_symmetric_state() -> None:
    cells = 5

    def reflected(name: str) -> tuple[tuple[str, int], float]:
        kind, number = place(name)
        offset = number - cells
        folded = offset if offset >= 0 else -offset - (kind == "a_0")
        return (kind, folded), -1.0 if kind in ("x", "u") and offset < 0 else 1.0

    for law, support, closure in [
        ("bingham", CLAMPED, "material"),
        ("bingham", PINNED, "printed"),
        ("elastic", CLAMPED, "printed"),
        ("elastic", PINNED, "material"),
    ]:
        scene = scene_of(law, closure=closure)
        half, whole = build(scene, half_span(cells, support)), build(scene, whole_span(cells, support, support))
        names = dict(zip(half.differential.names, random_state(half, 7)[0], strict=True))
        # x and u vanish on the symmetry plane, where they are no unknowns
        held = {("x", 0): 0.0, ("u", 0): 0.0}
        right = {place(name): value for name, value in names.items()} | held
        state = {name: sign * right[key] for name in whole.differential.names for key, sign in [reflected(name)]}
        found = rate(whole, scene, state)
        wanted = {place(name): speed for name, speed in rate(half, scene, names).items()} | held
        size = max(map(abs, found.values()))
        for name, speed in found.items():
            key, sign = reflected(name)
            assert speed == pytest.approx(sign * wanted[key], abs=1e-11 * size), name


def test_rigid_motion_strains_nothing() -> None:
    """Inner nodes turned and moved together: the cells between them feel nothing, those at the ends do."""
    grid = whole_span(4, CLAMPED, CLAMPED)
    for section in ["rectangle", "circle"]:
        scene = scene_of("maxwell", section=section)
        modulus, thickness = scene.material.youngs_modulus, scene.filament.thickness
        graph = resolved(scene, grid, ("shear", "necking-gradient"))
        for angle in [0.0, 0.4, 1.5, -3.0]:
            x, z = graph.start.copy(), np.full_like(graph.straight, angle)
            for k, name in enumerate(graph.differential.names):
                kind, number = place(name)
                if kind in ("x", "y"):
                    turned = grid.nodes[number] * (np.cos(angle) if kind == "x" else np.sin(angle))
                    x[k] = turned + (0.02 if kind == "x" else -0.05)
            found = value(graph.symbolic.observables, 0.0, x, z, parameters(scene, graph))
            observed = dict(zip(graph.symbolic.observables.name_out(), found, strict=True))
            sizes = {
                "stretch": 1,
                "shear": 1,
                "tension": modulus,
                "shear_force": modulus,
                "moment": modulus * thickness,
            }
            for name, size in sizes.items():
                inner = observed[name][1 : grid.cells - 1]
                np.testing.assert_allclose(inner, float(name == "stretch"), atol=1e-13 * size, err_msg=name)
            assert abs(observed["tension"][0]) > 1e-3 * modulus


def test_the_jacobian_is_banded_whatever_the_grid() -> None:
    """Unknowns are sorted along the filament: the bandwidth is that of a few neighbours, not of the span."""
    for law, per_cell in (("elastic", 4), ("bingham", 6)):
        graphs = [build(scene_of(law), half_span(cells, CLAMPED)) for cells in (8, 16)]
        patterns = [ca.jacobian_sparsity(graph.symbolic.ode, graph.symbolic.x) for graph in graphs]
        widths = [(pattern.bw_lower(), pattern.bw_upper()) for pattern in patterns]
        assert widths[0] == widths[1] and max(widths[0]) <= 4 * per_cell


def test_the_page_from_sympy_to_an_integrator_agrees_with_the_package(capsys: pytest.CaptureFixture[str]) -> None:
    page = Path(__file__).parents[1] / ".docs" / "manual" / "small-deflection.md"
    (text,) = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
    exec(text, {})
    changes = {"model": "small-deflection", "numerics.cells": 20, "numerics.estimate": False, "run.frames": 201}
    run = sc.simulate(sc.load_scene("maxwell-slow", changes))
    assert float(capsys.readouterr().out) == pytest.approx(run.summary["midpoint_final_m"] / 0.2, rel=0.01)
