"""One section driven through a history of stretch and turning by the package's own chain, fibres or amplitudes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.cell import Builder, derivatives
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.discretization.section_points import sampled
from softcat_sym.discretization.section_rule import SectionRule, fibre_rule
from softcat_sym.discretization.stencil import PARAMETER, UNKNOWN, Leaf
from softcat_sym.discretization.supports import FilamentBody
from softcat_sym.effects.selection import choose_effects
from softcat_sym.physics import reissner
from softcat_sym.physics.section_equations import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.ends import CLAMPED, SYMMETRY
from softcat_sym.scene.scene import Scene
from tests.common.filaments import GEOMETRY, Array, scene

UNIT = 1.0
"""Young's modulus, viscosity and thickness are one: times are in relaxation times, turning in 1/h0."""


@dataclass(frozen=True)
class OneCell:
    """A Bingham section."""

    rates: ca.Function
    resultants: ca.Function
    states: int


def one_cell(section: str, rule: SectionRule, yield_stress: float) -> OneCell:
    """Print the chain of one cell that does not shear; E = eta = h0 = A0 = 1."""
    names = (*GEOMETRY, "inertia", "viscous-flow", "yielding", "fibres")
    asked = scene(
        thickness=UNIT, span=10.0, E=UNIT, eta=UNIT, yield_stress=yield_stress, section=section, effects=names
    )
    equations = derive(choose_effects(asked).terms(), SECTIONS[section], asked.run.closure)
    builder = Builder(equations, (SYMMETRY, CLAMPED), FilamentBody())
    s, turning, a = ca.SX.sym("s"), ca.SX.sym("theta_X"), ca.SX.sym("a", rule.states)
    straight = {reissner.Lam: s, reissner.Gam: ca.SX(0), reissner.k: turning}
    resolved = equations.resolved
    assert resolved is not None
    fibres = sampled(builder, resolved, rule, {**builder.values, **straight})
    means = {**fibres.means, reissner.Lam: s}
    forces = [printed(force, {**builder.values, **means}) for force in (resolved.cell.tension, resolved.cell.moment)]
    names = [f"axial_{label}" for label in rule.labels]
    found = [ca.vertcat(*(fibres.plastic[name] for name in names)), *forces]
    return _numbers(asked, builder, names, [s, turning, a], found)


def sheared_cell(material: Mapping[str, object]) -> OneCell:
    """Print the chain of one cell that is stretched and sheared; of (Lam, Gam, states), with n_1 and n_2 over its area.

    Without bending all fibres are alike: there is one.
    """
    effects = [*GEOMETRY, "inertia", "viscous-flow", "yielding", "shear", "fibres"]
    asked = Scene.from_dict(
        {
            "filament": {"span": 10.0, "thickness": UNIT, "density": 1000.0},
            "material": material,
            "run": {"duration": 1.0, "effects": effects},
        }
    )
    equations = derive(choose_effects(asked).terms(), SECTIONS["rectangle"], asked.run.closure)
    builder, rule = Builder(equations, (SYMMETRY, CLAMPED), FilamentBody()), fibre_rule("rectangle", 2)
    strains, resolved = (ca.SX.sym("Lam"), ca.SX.sym("Gam"), ca.SX(0)), equations.resolved
    assert resolved is not None
    by = (reissner.Lam, reissner.Gam, reissner.k)
    values = {**builder.values, **dict(zip(by, strains, strict=True))}
    fibres = sampled(builder, resolved, rule, values)
    values |= fibres.means
    names = [f"{kind}_{label}" for kind in ("axial", "shear") for label in rule.labels]
    a = ca.SX.sym("a", len(names))
    forces = derivatives(resolved.cell.power, by, values)[:2]
    found = [ca.vertcat(*(fibres.plastic[name] for name in names)), *forces]
    return _numbers(asked, builder, names, [*strains[:2], a], found)


def _numbers(
    asked: Scene, builder: Builder, names: Sequence[str], inputs: Sequence[ca.SX], found: Sequence[ca.SX]
) -> OneCell:
    """The cell with numbers in the place of parameters, and the states, the last of the inputs, in that of unknowns."""
    given = {Leaf(PARAMETER, name): ca.SX(number) for name, number in parameter_values(asked).items()}
    given |= {Leaf(UNKNOWN, name): state for name, state in zip(names, ca.vertsplit(inputs[-1]), strict=True)}
    symbols, values = ca.vertcat(*map(builder.leaves.symbol, given)), ca.vertcat(*given.values())
    rates, *resultants = (ca.densify(ca.substitute(one, symbols, values)) for one in found)
    return OneCell(ca.Function("rates", inputs, [rates]), ca.Function("resultants", inputs, resultants), len(names))


def follow(cell: OneCell, duration: float, s: Array, turning: Array) -> tuple[Array, Array]:
    """T and M at every second instant of a history, by the classical Runge-Kutta method."""
    steps = (len(s) - 1) // 2
    dt = duration / steps
    a, strains = ca.MX.sym("a", cell.states), ca.MX.sym("strains", 2, 3)
    begin, middle, end = (strains[:, n] for n in range(3))
    k1 = cell.rates(begin[0], begin[1], a)
    k2 = cell.rates(middle[0], middle[1], a + dt / 2 * k1)
    k3 = cell.rates(middle[0], middle[1], a + dt / 2 * k2)
    k4 = cell.rates(end[0], end[1], a + dt * k3)
    step = ca.Function("step", [a, strains], [a + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)])
    given = np.array([s, turning])
    pieces = np.stack([given[:, :-1:2], given[:, 1::2], given[:, 2::2]], axis=-1)
    states = step.mapaccum(steps)(np.zeros(cell.states), pieces.transpose(0, 1, 2).reshape(2, -1))
    states = np.hstack([np.zeros((cell.states, 1)), np.asarray(states)])
    tension, moment = cell.resultants.map(steps + 1)(s[None, ::2], turning[None, ::2], states)
    return np.asarray(tension).ravel(), np.asarray(moment).ravel()


def bend_slowly(cell: OneCell, rule: SectionRule, turning: Array, dt: float) -> tuple[Array, Array]:
    """T and M of a section of fixed length that is bent so slowly that viscosity hardly matters: implicit Euler.

    Under a monotone history this is the return to the yield surface, which has no error of its own. Each step minimises
    a convex function that is quadratic piece by piece: Newton's method, held back wherever it would climb.
    """
    a, before, k = ca.SX.sym("a", cell.states), ca.SX.sym("b", cell.states), ca.SX.sym("k")
    # weighted with <p_n p_m> the residual is the slope of that convex function
    norm = ca.DM(rule.recall.T @ np.diag(rule.weight) @ rule.recall)
    residual = norm @ ((a - before) / dt - cell.rates(1.0, k, a))
    slope = ca.Function("slope", [a, before, k], [residual, ca.jacobian(residual, a)])
    states = [np.zeros(cell.states)]
    for turned in turning[1:]:
        states.append(_minimum(slope, states[-1], float(turned)))
    every = np.array(states).T
    tension, moment = cell.resultants.map(len(turning))(np.ones((1, len(turning))), turning[None, :], every)
    return np.asarray(tension).ravel(), np.asarray(moment).ravel()


def _minimum(slope: ca.Function, before: Array, turned: float) -> Array:
    a = before
    for _ in range(200):
        residual, jacobian = (np.array(value) for value in slope(a, before, turned))
        step = -np.linalg.solve(jacobian, residual).ravel()
        if np.max(np.abs(step)) <= 1e-12 * max(float(np.max(np.abs(a))), abs(turned)):
            return a + step
        a = a + _length(slope, a, step, before, turned) * step
    raise ArithmeticError(f"no convergence at a turning of {turned}")


def _length(slope: ca.Function, a: Array, step: Array, before: Array, turned: float) -> float:
    """How far to go along the step: to where the function stops falling, by bisection, if the whole step climbs."""

    def climb(part: float) -> float:
        return float(step @ np.asarray(slope(a + part * step, before, turned)[0]).ravel())

    if climb(1.0) <= 1e-9 * abs(climb(0.0)):
        return 1.0
    low, high = 0.0, 1.0
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if climb(middle) < 0 else (low, middle)
    return (low + high) / 2
