"""The filament that shears keeps its energy to rounding, does not mind rigid motion, and has its known limits."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.assembly import assemble, choose_theory, energy_scale
from softcat_sym.discretization.graph import Graph, parameter_values
from softcat_sym.discretization.grid import End, Floats, Grid, half_span, whole_span
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.initial_state import Equilibrium, sagging_guesses

from .filaments import energy_of, parameters, place, random_state, scene_of, value

GEOMETRY = ("bending", "finite-stretch", "thinning", "large-rotation")
FLOW = ("viscous-flow", "yielding", "gravity-ramp", "fibres")
STORED = ("energy_kinetic", "energy_elastic", "energy_potential")
GRIDS = {
    "half": half_span(6, End.CLAMPED),
    "half pinned": half_span(5, End.PINNED),
    "whole": whole_span(3, End.CLAMPED, End.PINNED),
    "graded": Grid(np.array([0.0, 0.13, 0.3, 0.42, 0.47, 0.5]), End.SYMMETRY, End.CLAMPED),
}
VARIANTS: dict[str, tuple[str, ...]] = {
    "fibres alone": (),
    "shear": ("shear",),
    "shear, gradient": ("shear", "necking-gradient"),
    "shear, rotary": ("shear", "rotary-inertia"),
    "everything": ("shear", "necking-gradient", "rotary-inertia"),
}
TIME = 0.3


def resolved(scene: Scene, grid: Grid, more: tuple[str, ...] = (), **numerics: int) -> Graph:
    """Assemble the scene's filament with inertia, the flow of its law and the effects named."""
    flow = FLOW if scene.material.law == "bingham" else tuple(name for name in FLOW if name != "yielding")
    changes = {f"numerics.{key}": number for key, number in numerics.items()}
    asked = scene.replace({"run.effects": ["inertia", *GEOMETRY, *flow, *more], **changes})
    effects = choose_effects(asked)
    equations = derive(effects.terms(), SECTIONS[asked.filament.section], asked.run.closure)
    return assemble(equations, grid, effects.names, choose_theory(asked, equations))


def settled(graph: Graph, scene: Scene, seed: int, size: float = 0.01) -> tuple[Floats, Floats]:
    """A random state, its section angles where their torques balance."""
    x, z = random_state(graph, seed, size)
    if not graph.is_dae:
        return x, z
    found = Equilibrium(graph).search(TIME, x, parameters(scene, graph), [z, graph.straight])
    assert found is not None
    return x, found


def balance(graph: Graph, scene: Scene, seed: int) -> tuple[float, float, float]:
    """d(energy)/dt + plastic power + power of the gradient - power of the load; what was added up; the slope in psi."""
    energy = energy_of(graph, STORED)
    values = parameter_values(scene)
    span = values["span"]
    unit = energy_scale(values["density"], span, values["time_scale"])
    outputs = [
        ca.gradient(energy, graph.x) * graph.ode,
        ca.jacobian(energy, graph.t),
        graph.quad * span * unit,
        ca.gradient(energy, graph.z),
    ]
    function = ca.Function("power", [graph.t, graph.x, graph.z, graph.p], outputs)
    x, z = settled(graph, scene, seed)
    parts, drift, (lost, gained, steepened), slope = value(function, TIME, x, z, parameters(scene, graph))
    size = float(np.sum(np.abs(parts)) + abs(lost) + abs(steepened))
    residual = float(np.sum(parts) + np.sum(drift) + lost + steepened - gained)
    stored = value(
        ca.Function("e", [graph.t, graph.x, graph.z, graph.p], [energy]), TIME, x, z, parameters(scene, graph)
    )
    return residual, size, float(np.max(np.abs(slope), initial=0.0) / abs(stored[0][0]))


def test_energy_is_kept_or_dissipated() -> None:
    """With section angles from their own balance the energy does not depend on how fast they turn."""
    for law, section, grid, variant, numerics in [
        *(("bingham", "rectangle", grid, "everything", {"fibres": 4}) for grid in GRIDS),
        *(("bingham", "rectangle", "graded", variant, {"fibres": 3}) for variant in VARIANTS),
        ("bingham", "circle", "half", "shear, gradient", {"fibres": 4}),
        ("bingham", "circle", "whole", "everything", {"order": 3}),
        ("bingham", "rectangle", "half pinned", "shear, gradient", {"order": 2}),
        ("bingham", "circle", "graded", "fibres alone", {"order": 3}),
        ("maxwell", "rectangle", "graded", "everything", {}),
        ("maxwell", "circle", "whole", "shear", {}),
    ]:
        scene = scene_of(law, section=section)
        graph = resolved(scene, GRIDS[grid], VARIANTS[variant], **numerics)
        assert graph.is_dae is ("rotary" not in variant and variant != "everything")
        for seed in range(3):
            residual, size, slope = balance(graph, scene, seed)
            assert abs(residual) <= 1e-12 * size
            assert slope <= 1e-8


@pytest.mark.parametrize("variant", ["shear, gradient", "everything"])
def test_flow_only_ever_dissipates(variant: str) -> None:
    scene = scene_of()
    for numerics in ({"fibres": 4}, {"order": 3}):
        graph = resolved(scene, GRIDS["half"], VARIANTS[variant], **numerics)
        power = ca.Function("power", [graph.t, graph.x, graph.z, graph.p], [graph.powers[0]])
        for seed in range(10):
            x, z = random_state(graph, seed, 0.01 * (seed + 1) / 10)
            (lost,) = value(power, TIME, x, z, parameters(scene, graph))
            assert np.all(lost >= 0)
            assert np.any(lost > 0)


def test_rigid_motion_strains_nothing() -> None:
    """Inner nodes turned and moved together: the cells between them feel nothing, those at the ends do."""
    for angle in [0.0, 0.4, 1.5, -3.0]:
        for section in ["rectangle", "circle"]:
            scene = scene_of("maxwell", section=section)
            grid = whole_span(4, End.CLAMPED, End.CLAMPED)
            graph = resolved(scene, grid, ("shear", "necking-gradient"))
            x, z = graph.start.copy(), np.full_like(graph.straight, angle)
            for k, name in enumerate(graph.state_names):
                kind, number = place(name)
                if kind in ("x", "y"):
                    turned = grid.nodes[number] * (np.cos(angle) if kind == "x" else np.sin(angle))
                    x[k] = turned + (0.02 if kind == "x" else -0.05)
            seen = dict(
                zip(
                    graph.observables.name_out(),
                    value(graph.observables, 0.0, x, z, parameters(scene, graph)),
                    strict=True,
                )
            )
            modulus = scene.material.youngs_modulus
            inner = slice(1, grid.cells - 1)
            np.testing.assert_allclose(seen["stretch"][inner], 1.0, atol=1e-14)
            np.testing.assert_allclose(seen["shear"][inner], 0.0, atol=1e-14)
            np.testing.assert_allclose(seen["tension"][inner], 0.0, atol=1e-13 * modulus)
            np.testing.assert_allclose(seen["shear_force"][inner], 0.0, atol=1e-13 * modulus)
            np.testing.assert_allclose(seen["moment"][inner], 0.0, atol=1e-13 * modulus * scene.filament.thickness)
            assert abs(seen["tension"][0]) > 1e-3 * modulus


def test_section_angles_are_determined() -> None:
    """The stiffness against turning is symmetric and positive: the index of the algebraic equations is one."""
    for grid in GRIDS:
        for variant in ["fibres alone", "shear", "shear, gradient"]:
            scene = scene_of()
            graph = resolved(scene, GRIDS[grid], VARIANTS[variant], fibres=4)
            jacobian = ca.Function("j", [graph.t, graph.x, graph.z, graph.p], [ca.jacobian(graph.alg, graph.z)])
            for seed in range(5):
                x, z = settled(graph, scene, seed)
                found = np.array(jacobian(TIME, x, z, parameters(scene, graph)))
                # the angles' equations are divided by the length of their nodes
                lengths = graph.grid.node_length[[place(name)[1] for name in graph.algebraic_names]]
                stiffness = -lengths[:, None] * found
                np.testing.assert_allclose(stiffness, stiffness.T, atol=1e-12 * np.abs(stiffness).max())
                eigenvalues = np.linalg.eigvalsh(stiffness)
                assert eigenvalues[0] > 1e-5 * eigenvalues[-1]


def elastic_sag(scene: Scene, cells: int, *, resolve: bool, shear: bool) -> float:
    """Static sag of the elastic half span, in spans."""
    effects = choose_effects(scene.replace({"run.effects": list(GEOMETRY)}))
    terms = replace(effects.terms(), resolved=resolve, shear=shear)
    equations = derive(terms, SECTIONS[scene.filament.section], "material")
    graph = assemble(equations, half_span(cells, End.CLAMPED), effects.names, choose_theory(scene, equations))
    guesses = sagging_guesses(graph, graph.straight, 0.02)
    z = Equilibrium(graph).search(1e3, np.zeros(0), parameters(scene, graph), guesses)
    assert z is not None
    (row,) = [k for k, name in enumerate(graph.algebraic_names) if name.startswith("y[0]")]
    return -float(z[row])


@pytest.mark.parametrize("section", ["rectangle", "circle"])
def test_rigid_in_shear_it_is_the_filament_of_the_paper(section: str) -> None:
    """Two discretisations of one theory: their difference falls with the square of the cells."""
    scene = scene_of("elastic", ramp="0 s", section=section)
    sizes = (10, 20, 40)
    paper = [elastic_sag(scene, cells, resolve=False, shear=False) for cells in sizes]
    found = [elastic_sag(scene, cells, resolve=True, shear=False) for cells in sizes]
    gaps = [(a - b) / b for a, b in zip(found, paper, strict=True)]
    print(section, "resolved against Kirchhoff, N = 10, 20, 40:", gaps)
    assert abs(gaps[1]) < abs(gaps[0]) / 3.5
    assert abs(gaps[2]) < abs(gaps[1]) / 3.5
    # what is left without a grid: the shear of a section a thousand times too stiff for it, (h/L)^2/1000, and N^-4
    assert abs(4 * gaps[2] - gaps[1]) / 3 < 1e-5


@pytest.mark.parametrize(("section", "gyration", "correction"), [("rectangle", 1 / 12, 5 / 6), ("circle", 1 / 16, 0.9)])
def test_a_stubby_beam_sags_by_shear_as_timoshenko_says(section: str, gyration: float, correction: float) -> None:
    """Small sag: q L^4/(384 E I) + q L^2/(8 kappa_s mu A) (Timoshenko 1921)."""
    delta, weight = 0.1, 1e-5  # thickness over span, weight per area and span over E
    scene = scene_of("elastic", ramp="0 s", section=section).replace(
        {"filament.thickness": f"{0.2 * delta} m", "load.gravity": f"{weight * 4e6 / (1900 * 0.2)!r} m/s^2"}
    )
    bending = weight / (384 * gyration * delta**2)
    shearing = weight / (8 * correction / (2 * (1 + scene.material.poisson)))
    coarse, fine = (elastic_sag(scene, cells, resolve=True, shear=True) for cells in (20, 40))
    stiff = elastic_sag(scene, 40, resolve=True, shear=False)
    assert (4 * fine - coarse) / 3 == pytest.approx(bending + shearing, rel=1e-4)
    assert stiff == pytest.approx(bending, rel=2e-3)
    assert shearing > 0.09 * bending
