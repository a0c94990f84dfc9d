"""The expressions of one cell, printed onto vectors of cells or nodes; and the parameters that occur in them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations, Terms
from softcat_sym.graph.parameters import CATALOGUE, SPAN, TIME_SCALE
from softcat_sym.printing import CellFunction

_INPUTS = tuple(parameter.symbol for parameter in CATALOGUE)


class CellPrinter:
    """The expressions of one cell, ready to be evaluated on vectors of cells, nodes or half cells."""

    def __init__(self, equations: FilamentEquations, values: Mapping[sy.Symbol, Any]) -> None:
        self._values = dict(values)
        self.equations = equations
        terms, response = equations.terms, equations.response
        self._stretch = CellFunction({"s": terms.centreline.stretch}, (sy.x_X, sy.y_X))
        self._turning = CellFunction(
            {"turning": terms.centreline.turning}, (sy.x_X_before, sy.y_X_before, sy.x_X, sy.y_X)
        )
        self._force = CellFunction(
            {"x": equations.force.horizontal, "y": equations.force.vertical}, (sy.x_X, sy.y_X, sy.s, sy.Q, sy.M_X)
        )
        places = (sy.s, sy.theta_X, sy.a_0, sy.a_1, sy.sigma_0, sy.sigma_1, sy.T, sy.M, *_INPUTS)
        self._section = {
            name: CellFunction({name: relation}, places) for name, relation in response.relations_per_area().items()
        }
        self._flow = CellFunction(response.flow_per_area(), (sy.s, sy.sigma_0, sy.sigma_1, *_INPUTS))

    def stretch(self, slope: tuple[ca.SX, ca.SX]) -> ca.SX:
        """Stretch of cells with tangent r_X."""
        return ca.SX(self._stretch({sy.x_X: slope[0], sy.y_X: slope[1]})["s"])

    def turning(self, before: tuple[ca.SX, ca.SX], behind: tuple[ca.SX, ca.SX]) -> ca.SX:
        """Angle between neighbouring tangents."""
        values = {sy.x_X_before: before[0], sy.y_X_before: before[1], sy.x_X: behind[0], sy.y_X: behind[1]}
        return ca.SX(self._turning(values)["turning"])

    def force(self, slope: tuple[ca.SX, ca.SX], s: ca.SX, axial: ca.SX, moment_change: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Internal force of cells (2.1, 2.2)."""
        values = {sy.x_X: slope[0], sy.y_X: slope[1], sy.s: s, sy.Q: axial, sy.M_X: moment_change}
        out = self._force(values)
        return out["x"], out["y"]

    def section(self, name: str, values: Mapping[sy.Symbol, ca.SX]) -> ca.SX:
        """One of the section's relations, named as in :class:`SectionEquations`, on vectors of cells or nodes."""
        size = max(value.numel() for value in values.values())
        return ca.SX(self._section[name]({**self._values, **values})[name]) * ca.SX.ones(size)

    def flow(self, s: ca.SX, sigma_0: ca.SX, sigma_1: ca.SX) -> dict[str, ca.SX]:
        """Plastic rates, energies and yielded fraction where the stress is sigma_0 + sigma_1 zeta."""
        out = self._flow({**self._values, sy.s: s, sy.sigma_0: sigma_0, sy.sigma_1: sigma_1})
        return {name: ca.SX(value) * ca.SX.ones(s.numel()) for name, value in out.items()}


def gravity_at(terms: Terms, values: Mapping[sy.Symbol, Any], time: ca.SX) -> tuple[ca.SX, ca.SX]:
    """g(t) and its rate."""
    load = CellFunction({"g": terms.gravity, "rate": terms.gravity_rate}, (sy.t, *_INPUTS))
    out = load({**values, sy.t: time})
    return ca.SX(out["g"]), ca.SX(out["rate"])


def parameter_symbols(expressions: Iterable[Any]) -> tuple[dict[sy.Symbol, ca.SX], list[str], ca.SX]:
    """Only the parameters that occur in these expressions become inputs, besides the scales of length and time."""
    used = set().union(*(expression.free_symbols for expression in expressions)) | {sy.rho}
    chosen = [parameter for parameter in CATALOGUE if parameter.symbol in used or parameter.name == SPAN]
    inputs = {parameter.symbol: ca.SX.sym(parameter.name) for parameter in chosen}
    scale = ca.SX.sym(TIME_SCALE)
    names = [parameter.name for parameter in chosen] + [TIME_SCALE]
    return inputs, names, ca.vertcat(*inputs.values(), scale)
