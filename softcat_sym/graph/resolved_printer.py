"""The chain from strains over the points of a section to forces, printed onto all cells and points at once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca

from softcat_sym.equations import reissner as re
from softcat_sym.equations import symbols as sy
from softcat_sym.equations.bulk import sigma_eq
from softcat_sym.equations.fibres import ResolvedSection
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.parameters import CATALOGUE
from softcat_sym.graph.section_rule import SectionRule
from softcat_sym.printing import CellFunction

_INPUTS = tuple(parameter.symbol for parameter in CATALOGUE)

_NO_STRESS = 1e-12
"""Equivalent stress, in Young's moduli, below which a point counts as unstressed: it is divided by."""


@dataclass(frozen=True)
class Points:
    """What happens at every point of every cell, shape (cells, points)."""

    axial_stress: ca.SX
    shear_stress: ca.SX
    axial_rate: ca.SX
    shear_rate: ca.SX
    speed: ca.SX
    dissipation: ca.SX
    yields: ca.SX
    energy: ca.SX


@dataclass(frozen=True)
class Resultants:
    """What a section does, per unit undeformed area, shape (cells,)."""

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
    values : mapping of sympy.Symbol to casadi value
        Parameters.
    rule : SectionRule
        Points through the thickness.

    Raises
    ------
    ValueError
        If the section of these equations is not resolved.
    """

    def __init__(self, equations: FilamentEquations, values: Mapping[sy.Symbol, Any], rule: SectionRule) -> None:
        if equations.resolved is None:
            raise ValueError("the section is not resolved: neither shear nor fibres are in force")
        self._resolved: ResolvedSection = equations.resolved
        self._values = dict(values)
        self._rule = rule

    def _evaluate(self, outputs: Mapping[str, Any], values: Mapping[sy.Symbol, ca.SX]) -> dict[str, ca.SX]:
        function = CellFunction(outputs, (*values, *_INPUTS))
        size = max(value.numel() for value in values.values())
        out = function({**self._values, **values})
        return {name: ca.SX(value) * ca.SX.ones(size) if size > 1 else ca.SX(value) for name, value in out.items()}

    def strains(self, slope: tuple[ca.SX, ca.SX], angle: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Lam and Gam of cells with tangent r_X and section angle psi."""
        Lam, Gam = self._resolved.strains
        out = self._evaluate({"Lam": Lam, "Gam": Gam}, {sy.x_X: slope[0], sy.y_X: slope[1], re.psi: angle})
        return out["Lam"], out["Gam"]

    def points(self, Lam: ca.SX, Gam: ca.SX, k: ca.SX, plastic_axial: ca.SX, plastic_shear: ca.SX) -> Points:
        """Stress and flow at every point.

        Parameters
        ----------
        Lam, Gam, k : casadi.SX, shape (cells,)
            Strains of the cells.
        plastic_axial, plastic_shear : casadi.SX, shape (cells, points)
            Plastic strains.
        """
        cell, cells, points = self._resolved.cell, Lam.numel(), self._rule.points
        every = [ca.repmat(value, points, 1) for value in (Lam, Gam, k)]
        zeta = ca.SX(ca.vec(ca.repmat(ca.DM(self._rule.zeta).T, cells, 1)))
        given = dict(zip((re.Lam, re.Gam, re.k), every, strict=True)) | {
            sy.zeta: zeta,
            re.eps_p: ca.vec(plastic_axial),
            re.gamma_p: ca.vec(plastic_shear),
        }
        stress = self._evaluate({"axial": cell.axial_stress, "shear": cell.shear_stress}, given)
        pair = {sy.sigma: stress["axial"], re.tau_f: stress["shear"]}
        energy = self._evaluate({"energy": cell.elastic_energy}, pair)["energy"]
        flow = self._flow(pair)
        shaped = {name: ca.reshape(value, cells, points) for name, value in {**stress, **flow}.items()}
        return Points(
            axial_stress=shaped["axial"],
            shear_stress=shaped["shear"],
            axial_rate=shaped["axial_rate"],
            shear_rate=shaped["shear_rate"],
            speed=shaped["speed"],
            dissipation=shaped["dissipation"],
            yields=shaped["yields"],
            energy=ca.reshape(energy, cells, points),
        )

    def _flow(self, pair: Mapping[sy.Symbol, ca.SX]) -> dict[str, ca.SX]:
        names = ("axial_rate", "shear_rate", "speed", "dissipation", "yields")
        flow = self._resolved.flow
        size = pair[sy.sigma].numel()
        if flow is None:
            return {name: ca.SX(size, 1) for name in names}
        # Compared before the root is taken, whose derivative is infinite where nothing is stressed.
        square = self._evaluate({"square": flow.equivalent**2}, pair)["square"]
        floor = (_NO_STRESS * self._values[sy.E]) ** 2
        equivalent = ca.sqrt(ca.fmax(square, floor))
        return self._evaluate({name: getattr(flow, name) for name in names}, {**pair, sigma_eq: equivalent})

    def resultants(self, Lam: ca.SX, Gam: ca.SX, k: ca.SX, angle: ca.SX, points: Points) -> Resultants:
        """Forces and couple of every section, and what they do to positions and section angle."""
        cell, weight = self._resolved.cell, ca.DM(self._rule.weight)
        means = {
            re.sigma_mean: points.axial_stress @ weight,
            re.sigma_zeta: points.axial_stress @ (weight * ca.DM(self._rule.zeta)),
            re.tau_mean: points.shear_stress @ weight,
            re.Lam: Lam,
        }
        # Per unit undeformed area, as everything in the balance.
        whole = {"T": cell.tension, "M": cell.moment, "S": cell.shear_force, "h": self._resolved.relative_thickness}
        section = self._evaluate({name: value.subs(sy.A0, 1) for name, value in whole.items()}, means)
        strains = {re.Lam: Lam, re.Gam: Gam, re.k: k}
        forces = {"n_1": cell.normal_force, "n_2": cell.section_force, "m": cell.couple}
        conjugate = self._evaluate(forces, {**strains, sy.T: section["T"], sy.M: section["M"], re.S: section["S"]})
        acting = {re.n_1: conjugate["n_1"], re.n_2: conjugate["n_2"], re.psi: angle, re.Lam: Lam, re.Gam: Gam}
        done = self._evaluate({"x": cell.force[0], "y": cell.force[1], "turning": cell.turning_moment}, acting)
        return Resultants(
            tension=section["T"],
            moment=section["M"],
            shear_force=section["S"],
            couple=conjugate["m"],
            turning_moment=done["turning"],
            force=(done["x"], done["y"]),
            relative_thickness=section["h"],
        )
