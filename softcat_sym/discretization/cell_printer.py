"""The expressions of one cell, printed onto vectors of cells or nodes, and over the points of a section."""

from __future__ import annotations

import functools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.discretization.graph import CATALOGUE, REST_LENGTH, TIME_SCALE, Setting
from softcat_sym.discretization.section_rule import Sampling
from softcat_sym.discretization.supports import outline
from softcat_sym.physics import reissner, symbols
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.bulk import sigma_eq
from softcat_sym.physics.filament import FilamentEquations, Terms
from softcat_sym.physics.laws import Constant
from softcat_sym.physics.reissner import FibreBranch, ResolvedSection

_INPUTS = tuple(parameter.symbol for parameter in CATALOGUE)
_BEFORE, _BEHIND = (sy.x_X_before, sy.y_X_before), (sy.x_X, sy.y_X)
_MOVING_BEFORE, _MOVING = (sy.x_Xt_before, sy.y_Xt_before), (sy.x_Xt, sy.y_Xt)

Pair = tuple[ca.SX, ca.SX]


def inputs_of(equations: FilamentEquations) -> tuple[sy.Symbol, ...]:
    """Every parameter that may occur in these equations."""
    return (*_INPUTS, *(constant.symbol for constant in equations.law.constants))


class CellPrinter:
    """The expressions of one cell, evaluated on vectors of cells, nodes or half cells."""

    def __init__(self, equations: FilamentEquations, values: Mapping[sy.Symbol, Any]) -> None:
        self._values, self._inputs, self.equations = dict(values), inputs_of(equations), equations
        self._relations = equations.response.relations()
        self._stresses = [part.stress() for part in equations.response.parts]
        self._flows = [part.flow() for part in equations.response.parts]

    def stretch(self, slope: Pair) -> ca.SX:
        """Stretch of cells with tangent r_X."""
        return _on_line(self.equations.terms.centreline.stretch, {_BEHIND: slope})

    def stretch_rate(self, slope: Pair, speed: Pair) -> ca.SX:
        """Rate of the stretch of cells with tangent r_X and its rate."""
        return _on_line(self.equations.terms.centreline.stretch_rate(), {_BEHIND: slope, _MOVING: speed})

    def turning(self, before: Pair, behind: Pair) -> ca.SX:
        """Angle between neighbouring tangents."""
        return _on_line(self.equations.terms.centreline.turning, {_BEFORE: before, _BEHIND: behind})

    def turning_rate(self, tangents: tuple[Pair, Pair], speeds: tuple[Pair, Pair]) -> ca.SX:
        """Rate of the angle between neighbouring tangents."""
        places = dict(zip((_BEFORE, _BEHIND, _MOVING_BEFORE, _MOVING), (*tangents, *speeds), strict=True))
        return _on_line(self.equations.terms.centreline.turning_rate(), places)

    def force(self, slope: Pair, s: ca.SX, axial: ca.SX, moment_change: ca.SX) -> Pair:
        """Internal force of cells (2.1, 2.2)."""
        force, every = self.equations.force, ca.SX.ones(s.numel())
        values = {sy.x_X: slope[0], sy.y_X: slope[1], sy.s: s, sy.Q: axial, sy.M_X: moment_change}
        out = CellFunction({"x": force.horizontal, "y": force.vertical}, tuple(values))(values)
        return out["x"] * every, out["y"] * every

    def section(self, name: str, values: Mapping[sy.Symbol, Any]) -> ca.SX:
        """One of the section's relations, named as in :class:`SectionResponse`, on vectors of cells or nodes."""
        return self._on_places(self._relations[name], values)

    def stress(self, part: int, name: str, values: Mapping[sy.Symbol, Any]) -> ca.SX:
        """Stress of a branch, by its number, or of the viscous part, which follows the branches."""
        return self._on_places(self._stresses[part][name], values)

    def flow(self, part: int, s: ca.SX, sigma_0: ca.SX, sigma_1: ca.SX) -> dict[str, ca.SX]:
        """Plastic rates, energies and yielded fraction where the stress of a part is sigma_0 + sigma_1 zeta."""
        given = {sy.s: s, sy.sigma_0: sigma_0, sy.sigma_1: sigma_1}
        out = CellFunction(self._flows[part], (*given, *self._inputs))({**self._values, **given})
        return {name: ca.SX(value) * ca.SX.ones(s.numel()) for name, value in out.items()}

    def _on_places(self, expression: Any, values: Mapping[sy.Symbol, Any]) -> ca.SX:
        size = max(value.numel() for value in values.values() if hasattr(value, "numel"))
        given = {symbol: value for symbol, value in values.items() if value is not None}
        function = CellFunction({"value": expression}, (*given, *self._inputs))
        return ca.SX(function({**self._values, **given})["value"]) * ca.SX.ones(size)


def _on_line(expression: Any, places: Mapping[tuple[sy.Symbol, sy.Symbol], Pair]) -> ca.SX:
    """An expression of the centreline, where pairs of symbols have these values."""
    values = {symbol: value for pair, given in places.items() for symbol, value in zip(pair, given, strict=True)}
    return ca.SX(CellFunction({"value": expression}, tuple(values))(values)["value"])


def gravity_at(terms: Terms, values: Mapping[sy.Symbol, Any], time: ca.SX) -> Pair:
    """g(t) and its rate."""
    load = CellFunction({"g": terms.load, "rate": terms.load_rate}, (sy.t, *_INPUTS))
    out = load({**values, sy.t: time})
    return ca.SX(out["g"]), ca.SX(out["rate"])


@dataclass(frozen=True)
class Inputs:
    """The numeric inputs of a graph."""

    symbols: dict[sy.Symbol, ca.SX]  # Those that occur in expressions
    named: dict[str, ca.SX]  # All of them, by name
    vector: ca.SX  # All of them, in the order of `named`


def parameter_inputs(expressions: Iterable[Any], constants: Iterable[Constant], others: Iterable[str]) -> Inputs:
    """Only the parameters that occur in these expressions become inputs, besides the scales of length and time."""
    used = set().union(*(expression.free_symbols for expression in expressions)) | {sy.rho}
    chosen = {p.symbol: p.name for p in CATALOGUE if p.symbol in used or p.name == REST_LENGTH}
    chosen |= {constant.symbol: constant.name for constant in constants if constant.symbol in used}
    symbols = {symbol: ca.SX.sym(name) for symbol, name in chosen.items()}
    named = {name: symbols[symbol] for symbol, name in chosen.items()}
    named |= {name: ca.SX.sym(name) for name in (*others, TIME_SCALE)}
    return Inputs(symbols, named, ca.vertcat(*named.values()))


_NO_STRESS = 1e-12
"""Equivalent stress, in Young's moduli, below which a point counts as unstressed: it is divided by."""


_FLOW = ("axial_rate", "shear_rate", "speed", "dissipation", "yields")


@dataclass(frozen=True)
class StrainRates:
    """Rates of the strains of all cells [1/s]; k_t is that of k [1/(m s)]."""

    Lam_t: ca.SX
    Gam_t: ca.SX
    k_t: ca.SX


@dataclass(frozen=True)
class Strains:
    """Strains of all cells, shape (cells,), and their rates where the stress depends on them."""

    Lam: ca.SX
    Gam: ca.SX
    k: ca.SX
    rates: StrainRates | None


@dataclass(frozen=True)
class PointFlow:
    """Flow of one branch at every point of every cell, shape (cells, points)."""

    axial_rate: ca.SX
    shear_rate: ca.SX
    speed: ca.SX
    dissipation: ca.SX
    yields: ca.SX


@dataclass(frozen=True)
class Points:
    """What happens at every point of every cell, shape (cells, points): in all branches together, and in each."""

    axial_stress: ca.SX
    shear_stress: ca.SX
    speed: ca.SX
    dissipation: ca.SX
    yields: ca.SX
    energy: ca.SX
    flows: tuple[PointFlow, ...]


@dataclass(frozen=True)
class Resultants:
    """What a section does, per unit undeformed area of the scene's section, shape (cells,)."""

    tension: ca.SX
    moment: ca.SX
    shear_force: ca.SX
    couple: ca.SX
    turning_moment: ca.SX
    force: tuple[ca.SX, ca.SX]
    relative_thickness: ca.SX


class ResolvedPrinter:
    """One cell's chain, ready to be evaluated on vectors of cells."""

    def __init__(self, equations: FilamentEquations, setting: Setting, rule: Sampling) -> None:
        if equations.resolved is None:
            raise ValueError("the section is not resolved: neither shear nor fibres are in force")
        self._resolved: ResolvedSection = equations.resolved
        self._values = dict(setting.values)
        self._inputs = inputs_of(equations)
        self._rule = rule
        self._total = setting.total
        self._varies = setting.profile.cells is not None
        self._moduli = [branch.modulus for branch in equations.law.branches]
        self.outline = outline(setting.profile, equations.shape.area_power, setting.values)

    @property
    def branches(self) -> int:
        """Number of springs in parallel."""
        return len(self._resolved.branches)

    @property
    def is_viscous(self) -> bool:
        """Whether the stress depends on the strain rate."""
        return self._resolved.viscous is not None

    def _evaluate(self, outputs: Mapping[str, Any], values: Mapping[symbols.Symbol, Any]) -> dict[str, ca.SX]:
        function = CellFunction(outputs, (*values, *(symbol for symbol in self._inputs if symbol not in values)))
        size = max(value.numel() for value in values.values())
        out = function({**self._values, **values})
        return {name: ca.SX(value) * ca.SX.ones(size) if size > 1 else ca.SX(value) for name, value in out.items()}

    def strains(self, slope: Pair, angle: ca.SX) -> Pair:
        """Lam and Gam of cells with tangent r_X and section angle psi."""
        Lam, Gam = self._resolved.strains
        out = self._evaluate(
            {"Lam": Lam, "Gam": Gam}, {symbols.x_X: slope[0], symbols.y_X: slope[1], reissner.psi: angle}
        )
        return out["Lam"], out["Gam"]

    def strain_rates(self, slope: Pair, angle: ca.SX, speed: Pair, spin: ca.SX) -> Pair:
        """Rates of Lam and Gam."""
        Lam_t, Gam_t = self._resolved.strain_rates
        at = {symbols.x_X: slope[0], symbols.y_X: slope[1], reissner.psi: angle}
        moving = {symbols.x_Xt: speed[0], symbols.y_Xt: speed[1], reissner.psi_t: spin}
        out = self._evaluate({"Lam": Lam_t, "Gam": Gam_t}, {**at, **moving})
        return out["Lam"], out["Gam"]

    def points(self, strains: Strains, plastic: Sequence[Pair]) -> Points:
        """Stress and flow at every point."""
        cells, points = strains.Lam.numel(), self._rule.points
        given = self._at_points(strains)
        parts = [self._branch(number, given, plastic[number]) for number in range(self.branches)]
        nothing = ca.SX(cells, points)

        def shaped(value: ca.SX) -> ca.SX:
            return ca.reshape(value, cells, points)

        axial, shear, energy = (
            sum((shaped(part[name]) for part in parts), nothing) for name in ("axial", "shear", "energy")
        )
        flows = tuple(PointFlow(*(shaped(part[name]) for name in _FLOW)) for part in parts)
        speed, yields = (
            functools.reduce(ca.fmax, [getattr(flow, name) for flow in flows] or [nothing])
            for name in ("speed", "yields")
        )
        dissipation = sum((flow.dissipation for flow in flows), nothing)
        if self.is_viscous:
            viscous = self._viscous(given)
            axial, shear = axial + shaped(viscous["axial"]), shear + shaped(viscous["shear"])
            dissipation = dissipation + shaped(viscous["dissipation"])
            if not flows:
                speed, yields = shaped(viscous["speed"]), ca.SX.ones(cells, points)
        return Points(axial, shear, speed, dissipation, yields, energy, flows)

    def _at_points(self, strains: Strains) -> dict[symbols.Symbol, Any]:
        """Strains of the cells, and thickness where it varies, repeated at every point; zeta of every point."""
        cells, points = strains.Lam.numel(), self._rule.points
        given: dict[symbols.Symbol, Any] = {reissner.Lam: strains.Lam, reissner.Gam: strains.Gam, reissner.k: strains.k}
        if strains.rates is not None:
            rates = strains.rates
            given |= {reissner.Lam_t: rates.Lam_t, reissner.Gam_t: rates.Gam_t, reissner.k_t: rates.k_t}
        if self._varies:
            given[symbols.h0] = self.outline.h_cells
        every = {symbol: ca.repmat(ca.SX(value), points, 1) for symbol, value in given.items()}
        zeta = self._rule.zeta
        row = zeta if isinstance(zeta, ca.SX) else ca.DM(zeta).T
        return every | {symbols.zeta: ca.SX(ca.vec(ca.repmat(row, cells, 1)))}

    def _branch(self, number: int, given: Mapping[symbols.Symbol, Any], plastic: Pair) -> dict[str, ca.SX]:
        branch = self._resolved.branches[number]
        state = {reissner.eps_p: ca.vec(plastic[0]), reissner.gamma_p: ca.vec(plastic[1])}
        stress = self._evaluate({"axial": branch.axial_stress, "shear": branch.shear_stress}, {**given, **state})
        pair = {symbols.sigma: stress["axial"], reissner.tau_f: stress["shear"]}
        energy = self._evaluate({"energy": branch.elastic_energy}, pair)
        return {**stress, **energy, **self._flow(branch, self._moduli[number], pair)}

    def _flow(self, branch: FibreBranch, modulus: Any, pair: Mapping[symbols.Symbol, ca.SX]) -> dict[str, ca.SX]:
        flow = branch.flow
        if flow is None:
            return {name: ca.SX(pair[symbols.sigma].numel(), 1) for name in _FLOW}
        # Compared before the root is taken, whose derivative is infinite where nothing is stressed.
        square = self._evaluate({"square": flow.equivalent**2, "modulus": modulus}, pair)
        equivalent = ca.sqrt(ca.fmax(square["square"], (_NO_STRESS * square["modulus"]) ** 2))
        return self._evaluate({name: getattr(flow, name) for name in _FLOW}, {**pair, sigma_eq: equivalent})

    def _viscous(self, given: Mapping[symbols.Symbol, Any]) -> dict[str, ca.SX]:
        viscous = self._resolved.viscous
        if viscous is None:
            raise ValueError("this law has no viscous stress")
        stress = self._evaluate({"axial": viscous.axial_stress, "shear": viscous.shear_stress}, given)
        pair = {symbols.sigma: stress["axial"], reissner.tau_f: stress["shear"]}
        return {**stress, **self._evaluate({"dissipation": viscous.dissipation, "speed": viscous.speed}, pair)}

    def resultants(self, strains: Strains, angle: ca.SX, points: Points) -> Resultants:
        """Forces and couple of every section, and what they do to positions and section angle."""
        cell, mean = self._resolved.cell, self._rule.mean
        means = {
            reissner.sigma_mean: mean("axial_stress", points.axial_stress, self._total),
            reissner.sigma_zeta: mean("axial_stress", points.axial_stress, self._total, linear=True),
            reissner.tau_mean: mean("shear_stress", points.shear_stress, self._total),
            reissner.Lam: strains.Lam,
        }
        if self.outline.h_cells is not None:
            means[symbols.h0] = ca.SX(self.outline.h_cells)
        # Per unit undeformed area, as everything in the balance.
        whole = {"T": cell.tension, "M": cell.moment, "S": cell.shear_force, "h": self._resolved.relative_thickness}
        section = self._evaluate({name: value.subs(symbols.A0, 1) for name, value in whole.items()}, means)
        T, M, S = (self.outline.area_cells * section[name] for name in ("T", "M", "S"))
        at = {reissner.Lam: strains.Lam, reissner.Gam: strains.Gam, reissner.k: strains.k}
        forces = {"n_1": cell.normal_force, "n_2": cell.section_force, "m": cell.couple}
        conjugate = self._evaluate(forces, {**at, symbols.T: T, symbols.M: M, reissner.S: S})
        acting = {
            reissner.n_1: conjugate["n_1"],
            reissner.n_2: conjugate["n_2"],
            reissner.psi: angle,
            reissner.Lam: at[reissner.Lam],
        }
        done = self._evaluate(
            {"x": cell.force[0], "y": cell.force[1], "turning": cell.turning_moment},
            {**acting, reissner.Gam: at[reissner.Gam]},
        )
        return Resultants(
            tension=T,
            moment=M,
            shear_force=S,
            couple=conjugate["m"],
            turning_moment=done["turning"],
            force=(done["x"], done["y"]),
            relative_thickness=section["h"] * self.outline.relative,
        )
