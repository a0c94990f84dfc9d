"""The chain from strains over the points of a section to forces, printed onto all cells and points at once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations import reissner as re
from softcat_sym.equations import symbols as sy
from softcat_sym.equations.bulk import sigma_eq
from softcat_sym.equations.fibres import FibreBranch, ResolvedSection
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import Pair, inputs_of
from softcat_sym.graph.discretisation import Setting
from softcat_sym.graph.profile import outline
from softcat_sym.graph.section_rule import Sampling
from softcat_sym.printing import CellFunction

_NO_STRESS = 1e-12
"""Equivalent stress, in Young's moduli, below which a point counts as unstressed: it is divided by."""


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
    """One cell's chain, ready to be evaluated on vectors of cells.

    Parameters
    ----------
    equations : FilamentEquations
        With a resolved section.
    setting : Setting
        Parameters, grid and profile.
    rule : SectionRule or OneFibre
        Points through the thickness.

    Raises
    ------
    ValueError
        If the section of these equations is not resolved.
    """

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

    def _evaluate(self, outputs: Mapping[str, Any], values: Mapping[sy.Symbol, Any]) -> dict[str, ca.SX]:
        function = CellFunction(outputs, (*values, *(symbol for symbol in self._inputs if symbol not in values)))
        size = max(value.numel() for value in values.values())
        out = function({**self._values, **values})
        return {name: ca.SX(value) * ca.SX.ones(size) if size > 1 else ca.SX(value) for name, value in out.items()}

    def strains(self, slope: Pair, angle: ca.SX) -> Pair:
        """Lam and Gam of cells with tangent r_X and section angle psi."""
        Lam, Gam = self._resolved.strains
        out = self._evaluate({"Lam": Lam, "Gam": Gam}, {sy.x_X: slope[0], sy.y_X: slope[1], re.psi: angle})
        return out["Lam"], out["Gam"]

    def strain_rates(self, slope: Pair, angle: ca.SX, speed: Pair, spin: ca.SX) -> Pair:
        """Rates of Lam and Gam."""
        Lam_t, Gam_t = self._resolved.strain_rates
        at = {sy.x_X: slope[0], sy.y_X: slope[1], re.psi: angle}
        moving = {sy.x_Xt: speed[0], sy.y_Xt: speed[1], re.psi_t: spin}
        out = self._evaluate({"Lam": Lam_t, "Gam": Gam_t}, {**at, **moving})
        return out["Lam"], out["Gam"]

    def points(self, strains: Strains, plastic: Sequence[Pair]) -> Points:
        """Stress and flow at every point.

        Parameters
        ----------
        strains : Strains
            Of the cells.
        plastic : sequence of pairs of casadi.SX, shape (cells, points)
            Axial and shear plastic strain of every branch.
        """
        cells, points = strains.Lam.numel(), self._rule.points
        given = self._at_points(strains)
        parts = [self._branch(number, given, plastic[number]) for number in range(self.branches)]
        nothing = ca.SX(cells, points)

        def shaped(value: ca.SX) -> ca.SX:
            return ca.reshape(value, cells, points)

        axial = sum((shaped(part["axial"]) for part in parts), nothing)
        shear = sum((shaped(part["shear"]) for part in parts), nothing)
        names = ("axial_rate", "shear_rate", "speed", "dissipation", "yields")
        flows = tuple(PointFlow(*(shaped(part[name]) for name in names)) for part in parts)
        speed, yields = nothing, nothing
        if flows:
            speed, yields = flows[0].speed, flows[0].yields
        for flow in flows[1:]:
            speed, yields = ca.fmax(speed, flow.speed), ca.fmax(yields, flow.yields)
        dissipation = sum((flow.dissipation for flow in flows), nothing)
        if self.is_viscous:
            viscous = self._viscous(given)
            axial, shear = axial + shaped(viscous["axial"]), shear + shaped(viscous["shear"])
            dissipation = dissipation + shaped(viscous["dissipation"])
            if not flows:
                speed, yields = shaped(viscous["speed"]), ca.SX.ones(cells, points)
        energy = sum((shaped(part["energy"]) for part in parts), nothing)
        return Points(axial, shear, speed, dissipation, yields, energy, flows)

    def _at_points(self, strains: Strains) -> dict[sy.Symbol, Any]:
        """Strains of the cells, and thickness where it varies, repeated at every point; zeta of every point."""
        cells, points = strains.Lam.numel(), self._rule.points
        given: dict[sy.Symbol, Any] = {re.Lam: strains.Lam, re.Gam: strains.Gam, re.k: strains.k}
        if strains.rates is not None:
            rates = strains.rates
            given |= {re.Lam_t: rates.Lam_t, re.Gam_t: rates.Gam_t, re.k_t: rates.k_t}
        if self._varies:
            given[sy.h0] = self.outline.h_cells
        every = {symbol: ca.repmat(ca.SX(value), points, 1) for symbol, value in given.items()}
        zeta = self._rule.zeta
        row = zeta if isinstance(zeta, ca.SX) else ca.DM(zeta).T
        return every | {sy.zeta: ca.SX(ca.vec(ca.repmat(row, cells, 1)))}

    def _branch(self, number: int, given: Mapping[sy.Symbol, Any], plastic: Pair) -> dict[str, ca.SX]:
        branch = self._resolved.branches[number]
        state = {re.eps_p: ca.vec(plastic[0]), re.gamma_p: ca.vec(plastic[1])}
        stress = self._evaluate({"axial": branch.axial_stress, "shear": branch.shear_stress}, {**given, **state})
        pair = {sy.sigma: stress["axial"], re.tau_f: stress["shear"]}
        energy = self._evaluate({"energy": branch.elastic_energy}, pair)
        return {**stress, **energy, **self._flow(branch, self._moduli[number], pair)}

    def _flow(self, branch: FibreBranch, modulus: Any, pair: Mapping[sy.Symbol, ca.SX]) -> dict[str, ca.SX]:
        names = ("axial_rate", "shear_rate", "speed", "dissipation", "yields")
        flow = branch.flow
        size = pair[sy.sigma].numel()
        if flow is None:
            return {name: ca.SX(size, 1) for name in names}
        # Compared before the root is taken, whose derivative is infinite where nothing is stressed.
        square = self._evaluate({"square": flow.equivalent**2, "modulus": modulus}, pair)
        equivalent = ca.sqrt(ca.fmax(square["square"], (_NO_STRESS * square["modulus"]) ** 2))
        return self._evaluate({name: getattr(flow, name) for name in names}, {**pair, sigma_eq: equivalent})

    def _viscous(self, given: Mapping[sy.Symbol, Any]) -> dict[str, ca.SX]:
        viscous = self._resolved.viscous
        if viscous is None:
            raise ValueError("this law has no viscous stress")
        stress = self._evaluate({"axial": viscous.axial_stress, "shear": viscous.shear_stress}, given)
        pair = {sy.sigma: stress["axial"], re.tau_f: stress["shear"]}
        return {**stress, **self._evaluate({"dissipation": viscous.dissipation, "speed": viscous.speed}, pair)}

    def resultants(self, strains: Strains, angle: ca.SX, points: Points) -> Resultants:
        """Forces and couple of every section, and what they do to positions and section angle."""
        cell, mean = self._resolved.cell, self._rule.mean
        means = {
            re.sigma_mean: mean("axial_stress", points.axial_stress, self._total),
            re.sigma_zeta: mean("axial_stress", points.axial_stress, self._total, linear=True),
            re.tau_mean: mean("shear_stress", points.shear_stress, self._total),
            re.Lam: strains.Lam,
        }
        if self.outline.h_cells is not None:
            means[sy.h0] = ca.SX(self.outline.h_cells)
        # Per unit undeformed area, as everything in the balance.
        whole = {"T": cell.tension, "M": cell.moment, "S": cell.shear_force, "h": self._resolved.relative_thickness}
        section = self._evaluate({name: value.subs(sy.A0, 1) for name, value in whole.items()}, means)
        T, M, S = (self.outline.area_cells * section[name] for name in ("T", "M", "S"))
        at = {re.Lam: strains.Lam, re.Gam: strains.Gam, re.k: strains.k}
        forces = {"n_1": cell.normal_force, "n_2": cell.section_force, "m": cell.couple}
        conjugate = self._evaluate(forces, {**at, sy.T: T, sy.M: M, re.S: S})
        acting = {re.n_1: conjugate["n_1"], re.n_2: conjugate["n_2"], re.psi: angle, re.Lam: at[re.Lam]}
        done = self._evaluate(
            {"x": cell.force[0], "y": cell.force[1], "turning": cell.turning_moment}, {**acting, re.Gam: at[re.Gam]}
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
