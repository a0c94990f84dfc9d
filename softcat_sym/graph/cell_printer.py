"""The expressions of one cell, printed onto vectors of cells or nodes; and the parameters that occur in them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations, Terms
from softcat_sym.equations.law import Constant
from softcat_sym.graph.parameters import CATALOGUE, REST_LENGTH, TIME_SCALE
from softcat_sym.printing import CellFunction

_INPUTS = tuple(parameter.symbol for parameter in CATALOGUE)
_STRAINED = (sy.s, sy.s_t, sy.theta_X, sy.theta_Xt, sy.a_0, sy.a_1)
_STRESSED = (sy.s, sy.theta_X, sy.sigma_0, sy.sigma_1, sy.T, sy.M)

Pair = tuple[ca.SX, ca.SX]


def inputs_of(equations: FilamentEquations) -> tuple[sy.Symbol, ...]:
    """Every parameter that may occur in these equations."""
    return (*_INPUTS, *(constant.symbol for constant in equations.law.constants))


class CellPrinter:
    """The expressions of one cell, ready to be evaluated on vectors of cells, nodes or half cells."""

    def __init__(self, equations: FilamentEquations, values: Mapping[sy.Symbol, Any]) -> None:
        self._values = dict(values)
        self.equations = equations
        terms, response, inputs = equations.terms, equations.response, inputs_of(equations)
        before, behind = (sy.x_X_before, sy.y_X_before), (sy.x_X, sy.y_X)
        moving = (sy.x_Xt_before, sy.y_Xt_before, sy.x_Xt, sy.y_Xt)
        line = terms.centreline
        self._stretch = CellFunction({"s": line.stretch}, behind)
        self._turning = CellFunction({"turning": line.turning}, (*before, *behind))
        self._stretch_rate = CellFunction({"s": line.stretch_rate()}, (*behind, sy.x_Xt, sy.y_Xt))
        self._turning_rate = CellFunction({"turning": line.turning_rate()}, (*before, *behind, *moving))
        self._force = CellFunction(
            {"x": equations.force.horizontal, "y": equations.force.vertical}, (*behind, sy.s, sy.Q, sy.M_X)
        )
        self._section = {
            name: CellFunction({name: relation}, (*_STRESSED, *inputs))
            for name, relation in response.relations().items()
        }
        parts = response.parts
        self._stresses = [
            {name: CellFunction({name: stress}, (*_STRAINED, *inputs)) for name, stress in part.stress().items()}
            for part in parts
        ]
        self._flows = [CellFunction(part.flow(), (sy.s, sy.sigma_0, sy.sigma_1, *inputs)) for part in parts]

    def stretch(self, slope: Pair) -> ca.SX:
        """Stretch of cells with tangent r_X."""
        return ca.SX(self._stretch({sy.x_X: slope[0], sy.y_X: slope[1]})["s"])

    def stretch_rate(self, slope: Pair, speed: Pair) -> ca.SX:
        """Rate of the stretch of cells with tangent r_X and its rate."""
        values = {sy.x_X: slope[0], sy.y_X: slope[1], sy.x_Xt: speed[0], sy.y_Xt: speed[1]}
        return ca.SX(self._stretch_rate(values)["s"])

    def turning(self, before: Pair, behind: Pair) -> ca.SX:
        """Angle between neighbouring tangents."""
        values = {sy.x_X_before: before[0], sy.y_X_before: before[1], sy.x_X: behind[0], sy.y_X: behind[1]}
        return ca.SX(self._turning(values)["turning"])

    def turning_rate(self, tangents: tuple[Pair, Pair], speeds: tuple[Pair, Pair]) -> ca.SX:
        """Rate of the angle between neighbouring tangents."""
        (before, behind), (first, second) = tangents, speeds
        values = {sy.x_X_before: before[0], sy.y_X_before: before[1], sy.x_X: behind[0], sy.y_X: behind[1]}
        moving = {sy.x_Xt_before: first[0], sy.y_Xt_before: first[1], sy.x_Xt: second[0], sy.y_Xt: second[1]}
        return ca.SX(self._turning_rate({**values, **moving})["turning"])

    def force(self, slope: Pair, s: ca.SX, axial: ca.SX, moment_change: ca.SX) -> Pair:
        """Internal force of cells (2.1, 2.2)."""
        values = {sy.x_X: slope[0], sy.y_X: slope[1], sy.s: s, sy.Q: axial, sy.M_X: moment_change}
        out, every = self._force(values), ca.SX.ones(s.numel())
        return out["x"] * every, out["y"] * every

    def section(self, name: str, values: Mapping[sy.Symbol, Any]) -> ca.SX:
        """One of the section's relations, named as in :class:`SectionResponse`, on vectors of cells or nodes."""
        return self._on_places(self._section[name], values)

    def stress(self, part: int, name: str, values: Mapping[sy.Symbol, Any]) -> ca.SX:
        """Stress of a branch, by its number, or of the viscous part, which follows the branches."""
        return self._on_places(self._stresses[part][name], values)

    def flow(self, part: int, s: ca.SX, sigma_0: ca.SX, sigma_1: ca.SX) -> dict[str, ca.SX]:
        """Plastic rates, energies and yielded fraction where the stress of a part is sigma_0 + sigma_1 zeta."""
        out = self._flows[part]({**self._values, sy.s: s, sy.sigma_0: sigma_0, sy.sigma_1: sigma_1})
        return {name: ca.SX(value) * ca.SX.ones(s.numel()) for name, value in out.items()}

    def _on_places(self, function: CellFunction, values: Mapping[sy.Symbol, Any]) -> ca.SX:
        size = max(value.numel() for value in values.values() if hasattr(value, "numel"))
        given = {symbol: value for symbol, value in values.items() if value is not None}
        (out,) = function({**self._values, **given}).values()
        return ca.SX(out) * ca.SX.ones(size)


def gravity_at(terms: Terms, values: Mapping[sy.Symbol, Any], time: ca.SX) -> Pair:
    """g(t) and its rate."""
    load = CellFunction({"g": terms.load, "rate": terms.load_rate}, (sy.t, *_INPUTS))
    out = load({**values, sy.t: time})
    return ca.SX(out["g"]), ca.SX(out["rate"])


@dataclass(frozen=True)
class Inputs:
    """The numeric inputs of a graph.

    Attributes
    ----------
    symbols : dict of sympy.Symbol to casadi.SX
        Those that occur in expressions.
    named : dict of str to casadi.SX
        All of them, by name.
    vector : casadi.SX
        All of them, in the order of `named`.
    """

    symbols: dict[sy.Symbol, ca.SX]
    named: dict[str, ca.SX]
    vector: ca.SX


def parameter_inputs(expressions: Iterable[Any], constants: Iterable[Constant], others: Iterable[str]) -> Inputs:
    """Only the parameters that occur in these expressions become inputs, besides the scales of length and time.

    Parameters
    ----------
    expressions : iterable of sympy.Expr
        All that is printed.
    constants : iterable of Constant
        What the law has of its own.
    others : iterable of str
        Parameters that no expression holds, such as the places of the supports.
    """
    used = set().union(*(expression.free_symbols for expression in expressions)) | {sy.rho}
    chosen = {p.symbol: p.name for p in CATALOGUE if p.symbol in used or p.name == REST_LENGTH}
    chosen |= {constant.symbol: constant.name for constant in constants if constant.symbol in used}
    symbols = {symbol: ca.SX.sym(name) for symbol, name in chosen.items()}
    named = {name: symbols[symbol] for symbol, name in chosen.items()}
    named |= {name: ca.SX.sym(name) for name in (*others, TIME_SCALE)}
    return Inputs(symbols, named, ca.vertcat(*named.values()))
