"""A filament in three dimensions: the planar one in its plane, rigid turns, forces of the energy, beams, torsion."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import cycle
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.discretization.assembly import choose_body, choose_theory
from softcat_sym.discretization.graph import Graph, Theory
from softcat_sym.discretization.grid import whole_span
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.discretization.section_rule import SectionRule, ring_rule, spatial_rule, warping_rule
from softcat_sym.discretization.shearing import Quaternion
from softcat_sym.discretization.symbolic import gathered
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.physics.section_equations import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.results.out_of_plane_stability import PlanarCells, banded, is_positive, out_of_plane_instability
from softcat_sym.results.run import run_form
from softcat_sym.scene.ends import CLAMPED, SUPPORTS
from softcat_sym.scene.laws import LAWS
from softcat_sym.scene.reading import load_scene
from tests.common.assembled import assemble
from tests.common.pairs import differences, pair_of

EFFECTS = ["inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear", "fibres"]
FLOW = {"maxwell": ["viscous-flow"], "bingham": ["viscous-flow", "yielding"], "kelvin-voigt": ["viscous-stress"]}
FLOW |= {"multimode-maxwell": ["viscous-flow"], "elastic": []}
MATERIALS: dict[str, dict[str, Any]] = {
    "elastic": {"youngs_modulus": 4e6},
    "maxwell": {"youngs_modulus": 4e6, "viscosity": 1e4},
    "bingham": {"youngs_modulus": 4e6, "viscosity": 1.4e4, "yield_stress": 9e3},
    "kelvin-voigt": {"youngs_modulus": 4e6, "viscosity": 1e4},
    "multimode-maxwell": {
        "modes": [{"youngs_modulus": 3e6, "viscosity": 1e4}, {"youngs_modulus": 1e6, "viscosity": 1e5}]
    },
}


def chord_rule(zeta: Floats, weight: Floats) -> SectionRule:
    """Points of a circle on chords at given heights, two a chord: what bends in the plane has its fibres there."""
    half = np.sqrt(np.maximum(1 - zeta**2, 0.0) / 3)
    Y, Z = np.repeat(zeta, 2), np.column_stack([-half, half]).ravel()
    return spatial_rule(Y, Z, -Z, Y, np.repeat(weight / 2, 2))


def strand(law: str, section: str = "circle", **changes: object) -> sc.Scene:
    """A strand of 20 cm, with every effect that the theory in three dimensions needs."""
    names = [name for name in EFFECTS if name != "fibres" or law not in ("elastic", "kelvin-voigt")]
    return sc.Scene.from_dict(
        {
            "filament": {"span": 0.2, "thickness": 0.006, "section": section, "density": 1900.0},
            "material": {"law": law, "poisson": 0.45, **MATERIALS[law]},
            "run": {"duration": 0.3, "frames": 16, "effects": [*names, *FLOW[law]]},
            "numerics": {"cells": 6, "grading": 1.0, "estimate": False, "rtol": 1e-7},
        }
    ).replace(changes)


@cache
def pair(law: str, section: str) -> tuple[Graph, Graph, int, Floats, Floats]:
    """The planar filament, and that in three dimensions with points at the heights of its fibres; their numbers."""
    scene = strand(law, section)
    effects = choose_effects(scene)
    equations = derive(effects.terms(), SECTIONS[section], "material")
    grid = whole_span(6, CLAMPED, CLAMPED, 1.0)
    theory, body = choose_theory(scene, equations.terms), choose_body(scene, grid)
    planar_rule = theory.rule
    assert planar_rule is not None and not planar_rule.is_spatial
    rule = chord_rule(planar_rule.zeta, planar_rule.weight)
    if section == "rectangle":
        # A twist shears as in a circle: in the plane there is none.
        Y, Z, *_ = rule.tables.values()
        rule = spatial_rule(Y, 0.4 * Z, -0.4 * Z, Y, rule.weight)
    planar = assemble(equations, grid, effects.names, theory, body)
    space = assemble(equations, grid, effects.names, Theory("filament", rule), body)
    values = parameter_values(scene)
    return planar, space, planar_rule.points, planar.vector(values), space.vector(values)


def evaluated(graph: Graph, state: dict[str, Floats], p: Floats) -> tuple[dict[str, Floats], Floats, dict[str, Floats]]:
    """Rates and residuals of all unknowns, powers, and what a run stores."""
    x, z = (
        np.array(gathered(layout, {b.name: ca.DM(state[b.name][list(b.places)]) for b in layout.blocks})).ravel()
        for layout in (graph.differential, graph.algebraic)
    )
    out = ca.Function("all", graph.symbolic.inputs, [*graph.symbolic.balances, *graph.symbolic.raw.powers])
    ode, alg, *powers = (np.array(one).ravel() for one in out(0.3, x, z, p))
    found = graph.differential.split(ode) | graph.algebraic.split(alg)
    observed = graph.observe(np.array([0.3]), x[:, None], z[:, None], p)
    return found, np.array([one.sum() for one in powers]), observed


@pytest.mark.parametrize(("law", "section"), [*zip(MATERIALS, cycle(("circle", "rectangle")), strict=False)])
def test_in_the_plane_it_is_the_planar_filament(law: str, section: str) -> None:
    planar, space, points, p, q = pair(law, section)
    X, rng = planar.grid.nodes, np.random.default_rng(1)
    bump, states = 0.25 - X**2, dict[str, Floats]()
    flat = {"x": X + 0.01 * np.sin(5 * X) * bump, "y": -0.2 * bump, "psi": 0.35 * X * (1 - 4 * X**2)}
    flat |= {"u": 0.1 * bump, "v": -0.3 * bump, "omega": 0.2 * np.sin(6 * X) * bump}
    for layout in (planar.differential, planar.algebraic):
        for block in layout.blocks:
            if block.name not in flat:
                states[block.name] = 0.02 * rng.standard_normal(12)
    deep = {**{name: flat[name] for name in ("x", "y", "u", "v")}, "z": 0 * X, "w": 0 * X}
    deep |= {"q0": np.cos(flat["psi"] / 2), "q1": 0 * X, "q2": 0 * X, "q3": np.sin(flat["psi"] / 2)}
    deep |= {"o1": 0 * X, "o2": 0 * X, "o3": flat["omega"]}
    for name, values in states.items():
        kind, _, rest = name.partition("_")
        number, _, mode = rest.partition("_")
        for point in (2 * int(number), 2 * int(number) + 1):
            label = f"{point}_{mode}" if mode else str(point)
            deep[f"{ {'axial': 'axial', 'shear': 'shear2'}[kind] }_{label}"] = values
            deep[f"shear3_{label}"] = 0 * values
    one, powers, shown = evaluated(planar, {**flat, **states}, p)
    other, deep_powers, deep_shown = evaluated(space, deep, q)
    alike = {"x": "x", "y": "y", "u": "u", "v": "v", **({"axial_0": "axial_0"} if "axial_0" in one else {})}
    alike |= {"shear_0": "shear2_0"} if "shear_0" in one else {}
    alike |= {"omega": "o3"} if "omega" in one else {"psi": "q3"}
    for name, same in alike.items():
        assert np.allclose(one[name], other[same], rtol=1e-11, atol=1e-11 * np.abs(one[name]).max()), name
    assert np.allclose(powers, deep_powers, rtol=1e-11, atol=1e-9)
    assert max(np.abs(other[name]).max() for name in ("w", "z", "q1", "q2")) < 1e-9
    for name in set(shown) & set(deep_shown):
        assert np.allclose(shown[name], deep_shown[name], rtol=1e-10, atol=1e-10 * np.abs(shown[name]).max()), name
    assert points > 0


OUT = {"load.direction": [0.1, -1.0, 0.4]}


@pytest.mark.parametrize(
    "scene",
    [
        strand("bingham", **OUT, **{"numerics.fibres": 3}),
        strand("kelvin-voigt", "rectangle", **OUT, **{"filament.width": "12 mm"}),
        strand(
            "maxwell",
            **OUT,
            **{"ends.right": "free", "load.tip_force": ["0 N", "1 mN", "2 mN"], "load.tip_mass": "1 g"},
        ),
        strand("elastic", **OUT, **{"ends.right_twist": [["0 s", "0 deg"], ["1 s", "90 deg"]], "ends.left": "pinned"}),
        strand(
            "kelvin-voigt",
            **{
                "ends.right_slides": True,
                "ends.right_twist": [["0 s", "0 deg"], ["1 s", "900 deg"]],
                "load.tip_force": ["1 N", "0 N", "0 N"],
                "initial.centreline": [["0 m"] * 3, ["10 cm", "2 mm", "-1 mm"], ["20 cm", "0 m", "0 m"]],
            },
        ),
    ],
    ids=["bingham", "kelvin-voigt", "tip", "twist", "slides"],
)
@pytest.mark.slow
def test_c_is_the_interpreter(scene: sc.Scene) -> None:
    both = pair_of(scene.replace({"numerics.cells": 4}))
    assert max(differences(both, range(2)).values()) < 1e-9


@pytest.mark.slow
def test_elastic_torsion_and_that_beyond_yield() -> None:
    """T/T_Y = (4/3)(1 - (theta_Y/theta)^3/4) of a circle that is twisted slowly; T = G J theta below."""
    modulus, limit, radius, length = 4e6, 9e3, 3e-3, 0.2
    shear, yielding = modulus / 2.9, limit / np.sqrt(3)
    first = yielding / (shear * radius)
    turns = 3 * first * length
    scene = strand(
        "bingham",
        **{
            "load.gravity": "0 m/s^2",
            "material.viscosity": "20 kPa*s",
            "ends.right_twist": [["0 s", "0 rad"], ["200 s", f"{turns} rad"]],
            "run": {"duration": "200 s", "frames": 31, "effects": [*EFFECTS[1:], *FLOW["bingham"]]},
            "numerics.cells": 4,
            "numerics.fibres": 60,
            "numerics.rtol": 1e-6,
        },
    )
    run = sc.simulate(scene)
    assert run.outcome.is_success, run.summary["message"]
    rate = run.data.time.values / 200 * turns / length
    torque = run.data.torque.values[:, 3]
    at_yield = np.pi * radius**3 * yielding / 2
    below = rate < 0.9 * first
    assert np.allclose(torque[below], shear * np.pi * radius**4 / 2 * rate[below], rtol=2e-3, atol=1e-3 * at_yield)
    beyond = rate > 1.3 * first
    exact = 4 / 3 * (1 - (first / rate[beyond]) ** 3 / 4)
    assert np.allclose(torque[beyond] / at_yield, exact, rtol=2e-2)


def test_rules_of_a_section_have_its_moments() -> None:
    for rule, second, torsion in (
        (ring_rule(3, 5), (1 / 4, 1 / 4), 1 / 2),
        (ring_rule(4, 6), (1 / 4, 1 / 4), 1 / 2),
        (warping_rule(4, 4, 1.0), (1 / 3, 1 / 3), 4 * 0.140577),
        (warping_rule(4, 4, 4.0), (1 / 3, 16 / 3), 4 * 0.280813),
    ):
        Y, Z, W_2, W_3, _ = rule.tables.values()
        found = [float(rule.weight @ square) for square in (Y**2, Z**2, W_2**2 + W_3**2)]
        assert found == pytest.approx([*second, torsion], rel=1e-4)
        assert abs(float(rule.weight @ (Y * Z))) < 1e-14 and float(rule.weight.sum()) == pytest.approx(1)


def turned_out_of_plane(psi: ca.SX, first: ca.SX, second: ca.SX) -> list[ca.SX]:
    """Quaternion of a planar section that turns about its own axes d1 and d2, to second order."""
    c, s = ca.cos(psi / 2), ca.sin(psi / 2)
    w, x, y = 1 - (first**2 + second**2) / 8, first / 2, second / 2
    return [c * w, c * x - s * y, c * y + s * x, s * w]


def test_the_tangent_sideways_is_the_second_derivative_of_the_energy_of_a_cell() -> None:
    """In closed form what CasADi finds of the strains of a cell in three dimensions."""
    given, out = ca.SX.sym("given", 13), ca.SX.sym("out", 6)
    xa, ya, pa, xb, yb, pb, d, n1, n2, M, shear, twist, bend = ca.vertsplit(given)
    za, a1, a2, zb, b1, b2 = ca.vertsplit(out)
    slope = [(xb - xa) / d, (yb - ya) / d, (zb - za) / d]
    turns = turned_out_of_plane(pa, a1, a2), turned_out_of_plane(pb, b1, b2)
    Lam, Gam, Gam_3, k_1, k_2, k_3 = Quaternion().strains(slope, *turns, d)
    stiff = (shear * Gam_3**2 + twist * k_1**2 + bend * k_2**2) / 2
    energy = d * (n1 * ca.sqrt(Lam**2 + Gam_3**2) + n2 * Gam - M * k_3 + stiff)
    hessian = ca.Function("hessian", [given], [ca.substitute(ca.hessian(energy, out)[0], out, ca.SX.zeros(6))])
    rng = np.random.default_rng(0)
    for turn in (0.0, 0.02, 0.3, -1.2):
        length, stretch, off = rng.uniform(0.5, 1), rng.uniform(0.8, 1.5), rng.uniform(-0.3, 0.3)
        (xa, ya), pa = rng.normal(size=2), rng.uniform(-2, 2)
        along = pa + turn / 2 + off
        forces, stiffness = rng.uniform(-2, 2, 3), rng.uniform(0.5, 2, 3)
        ahead = xa + stretch * length * np.cos(along), ya + stretch * length * np.sin(along)
        exact = np.asarray(hessian([xa, ya, pa, *ahead, pa + turn, length, *forces, *stiffness]))
        strains = (stretch * np.cos(off), stretch * np.sin(off), turn)
        cells = PlanarCells(
            np.array([length]),
            *(np.array([[one]]) for one in (*strains, *forces)),
            tuple(np.array([[one]]) for one in stiffness),
        )
        np.testing.assert_allclose(cells.tangent(1.0, 1.0)[0, 0], exact, rtol=0, atol=1e-11)


def test_what_surely_stays_in_its_plane_has_no_way_out_of_it() -> None:
    """The bound is below the eigenvalues: on random bent filaments it never says that one stays which does not."""
    rng, cells, sure, unstable = np.random.default_rng(1), 40, 0, 0
    length = np.full(cells, 1 / cells)
    for ends in (("clamped", "clamped"), ("clamped", "free"), ("free", "clamped"), ("pinned", "pinned")):
        for size in np.geomspace(0.03, 30, 40):
            at = (np.arange(cells) + 0.5) / cells
            # A moment that vanishes where nothing holds it, and the transverse force that balances it.
            free = "free" in ends
            modes = [np.cos((k - 0.5) * np.pi * at) if free else np.sin(k * np.pi * at) for k in (1, 2, 3)]
            shape = np.array(rng.normal(size=3)) @ modes
            M = size * (shape[::-1] if ends[0] == "free" else shape)
            turn = 0.1 * rng.normal() * M / max(1.0, np.abs(M).max()) / cells
            row = (np.ones(cells), 0 * at, turn, size * rng.uniform(-0.5, 2) * np.ones(cells), np.gradient(M, at), M)
            stiff = 1e6 * np.ones((1, cells)), rng.uniform(0.5, 2) * np.ones((1, cells)), np.ones((1, cells))
            found = PlanarCells(length, *(one[None] for one in row), stiff)
            held = np.zeros(3 * (cells + 1), dtype=bool)
            for end, first in zip(ends, (0, 3 * cells), strict=True):
                held[first : first + {"clamped": 3, "pinned": 2, "free": 0}[end]] = True
            stable = is_positive(banded(found.tangent(1.0, 1.0), held)[0])
            unstable += not stable
            if found.stay(1.0, [SUPPORTS[end] for end in ends]):
                sure += 1
                assert stable, (ends, size)
    assert sure > 40 and unstable > 20, (sure, unstable)


@pytest.mark.slow
def test_a_planar_run_that_would_leave_its_plane_is_followed_in_space() -> None:
    """A rod of curvature times length 3 is unstable sideways from 0.53 of gravity on (THEORY3D 9.4)."""
    curl = {"filament.curvature": "30 1/m", "numerics.estimate": False, "run.accuracy": 0.01}
    for gravity, dimensions, unstable in (
        ("4.9 m/s^2", "auto", False),
        ("9.81 m/s^2", "auto", True),
        ("9.81 m/s^2", 2, True),
    ):
        scene = load_scene("curled-rod", {**curl, "load.gravity": gravity, "run.dimensions": dimensions})
        run = sc.simulate(scene)
        assert (run.summary["sideways"] is not None) == unstable
        assert any("unstable sideways" in text for text in run.summary["warnings"]) == unstable
        followed = unstable and dimensions == "auto"
        assert run.summary["dimensions"] == (3 if followed else 2) and ("z" in run.data) == followed
        if followed:
            # From its weight's 1e-4 aside: a hundredth of a millimetre at once, and millimetres after two seconds.
            assert np.abs(run.data.z.values[-1]).max() > 1e-3 > 1e-4 > np.abs(run.data.z.values[10]).max()
            assert "unstable sideways" in run.summary["dimensions_reason"]
            # Taken from the store it is the same run.
            form = run_form(scene)
            again = form.read(form.write(run))
            assert again.scene == run.scene and again.summary == run.summary


def test_a_strand_that_is_pressed_buckles_sideways_as_fast_as_its_law_lets_it() -> None:
    """s^2 rho A + (E + eta s) I k^4 = P k^2 of a pinned strand: Euler's column. What flows counts as elastic."""
    E, eta, length, nodes, frames = 4e6, 3e3, 0.2, 161, 41
    moduli: dict[str, Callable[[float], float]] = {
        "elastic": lambda s: E,
        "kelvin-voigt": lambda s: E + eta * s,
        "maxwell": lambda s: E,
    }
    area, at = np.pi * 4e-6, np.linspace(0, length, nodes)

    def excess(s: float, k: float, modulus: Callable[[float], float], force: float) -> float:
        return s**2 * 1000 * area + modulus(s) * area * 4e-3**2 / 16 * k**4 - force * k**2

    for law, modulus in moduli.items():
        material = {"law": law, **{name: {"youngs_modulus": E, "viscosity": eta}[name] for name in LAWS[law].constants}}
        scene = sc.Scene.from_dict(
            {
                "filament": {"span": length, "thickness": 4e-3, "section": "circle", "density": 1000.0},
                "material": material,
                "ends": {"left": "pinned", "right": "pinned"},
                "run": {"duration": 1.0},
            }
        )
        for pressed in (0.5, 2.0, 3.5):
            force = pressed * E * area * 4e-3**2 / 16 * (np.pi / length) ** 2
            cells = np.ones((frames, nodes - 1))
            fields = {
                "time": np.linspace(0, 1, frames),
                "X_node": at,
                **{"x": np.tile(at - length / 2, (frames, 1)), "y": np.zeros((frames, nodes))},
                **{"thickness": 4e-3 * cells, "tension": -force * cells, "moment": 1e-15 * cells},
                **dict.fromkeys(("shear_force", "curvature"), 0 * cells),
                "stretch": cells,
            }
            found, rates = out_of_plane_instability(scene, fields), [0.0]
            for k in np.arange(1, 9) * np.pi / length:
                given = k, modulus, force
                if excess(1.0, *given) < 0:
                    rates.append(float(brentq(excess, 1.0, 1e5, args=given)))
            assert (found is None) == (max(rates) == 0), (law, pressed)
            # Euler's column does not shear.
            assert found is None or found.rate == pytest.approx(max(rates), rel=1e-2), (law, pressed)


TORQUE = {"ends.right": "free", "load.gravity": "0 m/s^2", "filament.thickness": "1 mm", "numerics.cells": 20}


def torque(*parts: float) -> dict[str, object]:
    """A torque on the free end [N m]."""
    return {**TORQUE, "load.tip_torque": [f"{part!r} N*m" for part in parts]}


@pytest.mark.slow
def test_a_torque_at_the_end_bends_it_to_an_arc_and_twists_it() -> None:
    """M = E I kappa and T = G J theta': half a circle in either plane, and a turn about its own axis."""
    bending, span = 4e6 * np.pi * 1e-12 / 64, 0.2
    half = np.pi * bending / span
    for parts, other in ((0.0, 0.0, half), "y"), ((0.0, -half, 0.0), "z"):
        data = sc.simulate(strand("elastic", **{**AT_REST, **torque(*parts)})).data.isel(time=-1)
        assert data.x.values[-1] + span / 2 == pytest.approx(0, abs=1e-4 * span)
        # A chain of 40 straight cells; an arc is a few parts in ten thousand less high.
        assert data[other].values[-1] == pytest.approx(span / 40 / np.sin(np.pi / 80), rel=1e-4)
        assert np.allclose(np.hypot(data.moment, data.moment_2), half, rtol=1e-10)
    twisting = bending / 1.45
    data = sc.simulate(strand("elastic", **{**AT_REST, **torque(2 * twisting / span, 0.0, 0.0)})).data.isel(time=-1)
    assert np.allclose(data.torque, 2 * twisting / span, rtol=1e-10)
    assert np.allclose(data.twist * span, 2, rtol=1e-3) and np.abs(data.y).max() < 1e-12


AT_REST = {"run": {"duration": "1 s", "frames": 2, "effects": EFFECTS[1:-1]}, "numerics.cells": 4}
INTERPRETED = {"numerics.backend": "interpreted"}


def test_it_begins_on_a_given_curve_with_what_that_strains() -> None:
    """An arc of a straight rod holds E I/(2 R^2) a length; its sections do not turn about it."""
    radius, angle = 0.3, 2 / 3
    s = np.linspace(0, angle, 9)
    arc = np.column_stack([radius * np.sin(s), radius * (1 - np.cos(s)), 0 * s])
    span, rise, _ = arc[-1].tolist()
    shape = {
        "filament.rest_length": "0.2 m",
        "filament.span": f"{span!r} m",
        "ends": {"drop": f"{-rise!r} m", "right_angle": f"{angle!r} rad"},
        "initial.centreline": [[f"{one!r} m" for one in point] for point in arc.tolist()],
        "run": {"duration": "1 ms", "frames": 2, "effects": EFFECTS[:-1]},
        "numerics.cells": 4,
    }
    run = sc.simulate(strand("elastic", **shape, **INTERPRETED))
    first = run.data.isel(time=0)
    assert np.allclose(np.stack([first.x - first.x[0], first.y, first.z], axis=-1), arc, atol=1e-15)
    assert np.allclose(first.curvature, 1 / radius, rtol=1e-3)
    bending = 4e6 * np.pi * 0.006**4 / 64
    # Chords are shorter than the arc: 0.3 % of the energy.
    assert float(first.energy_elastic) == pytest.approx(bending / (2 * radius**2) * 0.2, rel=5e-3)
    assert float(first.energy_kinetic) == 0
    aside = {
        **shape,
        "ends": {"right": "free"},
        "initial.centreline": [[f"{x!r} m", f"{0.6 * y!r} m", f"{0.8 * y!r} m"] for x, y, _ in arc.tolist()],
    }
    first = sc.simulate(strand("elastic", **aside, **INTERPRETED)).data.isel(time=0)
    assert np.allclose(first.z, 0.8 * arc[:, 1], atol=1e-15) and np.allclose(first.twist, 0, atol=1e-12)


@pytest.mark.slow
def test_what_is_free_is_found_in_space() -> None:
    """Midpoints of runs are those of the model that is fitted; its slopes are their differences; a fit finds them."""
    cases = {
        "hanging-curl": ({"run.duration": "1 s"}, ["youngs_modulus", "viscosity", "curvature", "thickness"]),
        "coil-spring": ({"run.duration": "1 s", "numerics.cells": 20}, ["youngs_modulus", "viscosity", "density"]),
        "windy-ink": ({"run.duration": "0.05 s", "run.accuracy": 1e-3}, ["shear_yield_stress", "surface_tension"]),
        "overtwisted-rod": ({"run.duration": "3 s"}, ["youngs_modulus", "gravity"]),
    }
    short = {"numerics.cells": 10, "numerics.rtol": 1e-7, "run.frames": 9, "numerics.estimate": False}
    for name, (changes, free) in cases.items():
        scene = load_scene(name, {**short, **changes})
        model = ForwardModel(scene, free_parameters(scene, free), np.linspace(0, scene.run.duration, 9), rtol=1e-7)
        q = np.array([one.scaled(one.typical) for one in model.free])
        found, slopes = model.with_derivatives(q)
        same = scene.replace({"run.effects": list(model.effects)})
        moved = np.ptp(found)
        assert np.abs(sc.simulate(same).data.midpoint.values - found).max() < 1e-5 * moved, name
        # Either difference averages over the points that begin to yield in it.
        bound = 1e-2 if scene.material.law == "bingham" else 1e-3
        for k, e in enumerate(1e-3 * np.eye(len(q))):
            differences = (model.midpoints(q + e) - model.midpoints(q - e)) / 2e-3
            assert np.abs(differences - slopes[:, k]).max() < bound * np.abs(differences).max(), (name, free[k])
    scene = load_scene("hanging-curl", {**short, "run.duration": "1 s", "run.frames": 41})
    data = sc.simulate(scene).data
    film = sc.Measurements.of(data.time.values, data.midpoint.values, std=1e-5)
    guess = scene.replace({"material.youngs_modulus": "1.1 MPa", "material.viscosity": "50 kPa*s"})
    fit = sc.fit(film, guess, ["youngs_modulus", "viscosity"], starts=0, profiles=False)
    assert fit.parameters["youngs_modulus"].value == pytest.approx(1.3e6, rel=1e-4)
    assert fit.parameters["viscosity"].value == pytest.approx(6e4, rel=1e-3)
