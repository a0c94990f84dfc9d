"""Assembly of a filament that shears (geometrically exact in the plane), its section resolved point by point.

Positions and section angle live on nodes, the whole section on cells: a two-node element with one point along the
filament, so that it neither locks in shear nor has a spurious mode, and stretch, shear, bending and flow of a section
are in one place. Forces and torques are the exact derivatives of the discrete energy.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.cell_printer import Pair, Points, ResolvedPrinter, Resultants, StrainRates, Strains
from softcat_sym.discretization.graph import Discretisation, Fibres, Fields, Recall, Setting, Stage, Unknowns
from softcat_sym.discretization.grid import Floats, Grid, cell_block, node_block, to_cells
from softcat_sym.discretization.kirchhoff import (
    beyond_the_section,
    branch_name,
    free_nodes,
    neck_double_force,
    neck_tension,
    surface_force,
)
from softcat_sym.discretization.section_rule import OneFibre, Sampling, SectionRule
from softcat_sym.physics import symbols
from softcat_sym.physics.filament import FilamentEquations


def reissner(rule: SectionRule) -> Discretisation:
    """The theory with its section sampled and its plastic state represented by `rule`."""
    if not rule.is_of_fibres:
        return _theory(rule)
    one = OneFibre()
    return replace(_theory(rule), fibres=Fibres(rule, one, _theory(one)))


def _theory(rule: Sampling) -> Discretisation:
    section = _Sampled(rule)
    return Discretisation(f"reissner {rule.label}", section.unknowns, section.evaluate, expressions)


def expressions(equations: FilamentEquations) -> Iterable[Any]:
    """Whatever is printed of these equations, besides the balance."""
    resolved = equations.resolved
    if resolved is None:
        return []
    printed = [resolved.cell.moment.subs(symbols.A0, 1)]
    for branch in resolved.branches:
        printed += [branch.axial_stress, branch.shear_stress, branch.elastic_energy]
        printed += [] if branch.flow is None else [branch.flow.speed]
    if resolved.viscous is not None:
        printed += [resolved.viscous.axial_stress, resolved.viscous.shear_stress]
    return [*printed, *beyond_the_section(equations)]


def _angle_nodes(grid: Grid) -> list[int]:
    """Nodes whose section angle is unknown: an end that holds the angle gives it."""
    held = {0 if grid.first.holds_angle else None, grid.cells if grid.last.holds_angle else None}
    return [node for node in range(grid.cells + 1) if node not in held]


@dataclass(frozen=True)
class _Sampled:
    rule: Sampling

    def unknowns(self, equations: FilamentEquations, grid: Grid) -> Unknowns:
        """Positions and angles of free nodes; the plastic states of every cell."""
        free_x, free_y = free_nodes(grid)
        zeros = np.zeros(grid.cells + 1)
        angles = _angle_nodes(grid)
        turns = equations.terms.rotary_inertia or equations.law.viscosity is not None
        spins = (node_block("omega", angles, grid, zeros),) if turns else ()
        flowing = self._flowing(equations)
        names = [(name, n) for branch in flowing for n, name in enumerate(self._names("axial", branch))]
        sheared = [name for branch in flowing for name in self._names("shear", branch)]
        shears = equations.resolved is not None and equations.resolved.shears
        plastic = [name for name, _ in names] + (sheared if shears else [])
        return Unknowns(
            positions=(node_block("x", free_x, grid, grid.nodes), node_block("y", free_y, grid, zeros)),
            velocities=(node_block("u", free_x, grid, zeros), node_block("v", free_y, grid, zeros)),
            plastic=tuple(cell_block(name, grid) for name in plastic),
            profiles=self._profiles(names),
            angles=(node_block("psi", angles, grid, zeros),),
            spins=spins,
        )

    def _profiles(self, names: Sequence[tuple[str, int]]) -> dict[str, tuple[float, float]]:
        """What each axial state is of a plastic strain that is linear through the thickness."""
        if isinstance(self.rule, OneFibre):
            return {}
        mean, linear = self.rule.project @ np.ones(self.rule.points), self.rule.project @ self.rule.zeta
        return {name: (float(mean[n]), float(linear[n])) for name, n in names}

    def _flowing(self, equations: FilamentEquations) -> list[int]:
        branches = equations.resolved.branches if equations.resolved is not None else ()
        return [number for number, branch in enumerate(branches) if branch.flow is not None]

    def _names(self, kind: str, branch: int) -> list[str]:
        return [branch_name(f"{kind}_{label}", branch) for label in self.rule.labels]

    def evaluate(self, equations: FilamentEquations, setting: Setting, state: Recall) -> Fields:
        """Evaluate the whole filament."""
        grid = setting.grid
        cell = ResolvedPrinter(equations, setting, self.rule)
        x, y = setting.positions(state)
        psi = self._angles(setting, state)
        length, per_length, stage = setting.lengths.cell, 1 / setting.lengths.cell, setting.stage
        per_span = 1 / setting.values[symbols.L_0]
        slope = (ca.diff(x) * per_length, ca.diff(y) * per_length)
        k, angle = ca.diff(psi) * (per_length * per_span), to_cells(psi)
        Lam, Gam = cell.strains(slope, angle)
        strains = self._seen(Strains(Lam, Gam, k, self._strain_rates(cell, setting, state, slope, angle)), stage)
        plastic = [
            (self._at_points(state, grid, "axial", j), self._at_points(state, grid, "shear", j))
            for j in range(cell.branches)
        ]
        points = cell.points(strains, plastic)
        section = cell.resultants(strains, angle, points)
        stretch = ca.sqrt(slope[0] ** 2 + slope[1] ** 2)
        force_x, force_y = stage("section_force_x", section.force[0]), stage("section_force_y", section.force[1])
        # Along the tangent of the centreline, not along the normal of the section: conjugate to its stretch.
        double_force, surface_energy, gain = None, None, ca.SX(0)
        if equations.surface is not None:
            gain, surface_energy = surface_force(equations.surface, setting, cell.outline, stretch)
        if equations.neck is not None:
            stretch = stage("stretch", stretch)
            double_force = neck_double_force(equations.neck, setting, stretch, stage("tension", section.tension))
            gain += neck_tension(setting.lengths, double_force)
        if surface_energy is not None or double_force is not None:
            force_x = stage("force_x", force_x + gain / stretch * slope[0])
            force_y = stage("force_y", force_y + gain / stretch * slope[1])
        volume, shown = length * cell.outline.area_cells, self._shown(section, points, strains)
        energy, dissipation = (
            self.rule.mean(name, value, setting.total)
            for name, value in (("energy", points.energy), ("dissipation", points.dissipation))
        )
        if surface_energy is not None:
            shown["axial_force"] = (force_x * slope[0] + force_y * slope[1]) / stretch
        return Fields(
            x=x,
            y=y,
            stretch=stretch,
            force_x=force_x,
            force_y=force_y,
            plastic_rates=self._rates(points),
            elastic_energy=ca.dot(volume, energy),
            dissipation=volume * dissipation,
            observables=shown,
            torque=_torque(length * setting.values[symbols.L_0], section, stage),
            double_force=double_force,
            surface_energy=surface_energy,
        )

    def _seen(self, strains: Strains, stage: Stage) -> Strains:
        """The strains as fibres see them: of one that stands for all they are looked up."""
        if not isinstance(self.rule, OneFibre):
            return strains
        rates = strains.rates
        if rates is not None:
            rates = StrainRates(*(stage(name, getattr(rates, name)) for name in ("Lam_t", "Gam_t", "k_t")))
        return Strains(stage("Lam", strains.Lam), stage("Gam", strains.Gam), stage("k", strains.k), rates)

    def _angles(self, setting: Setting, state: Recall) -> ca.SX:
        psi = ca.SX.zeros(setting.grid.cells + 1)
        if not setting.grid.is_half:
            psi[0] = setting.supports.left_angle
        psi[-1] = setting.supports.right_angle
        return state.field("psi", psi)

    def _strain_rates(
        self, cell: ResolvedPrinter, setting: Setting, state: Recall, slope: Pair, angle: ca.SX
    ) -> StrainRates | None:
        """Rates of the strains [1/s], where the stress depends on them."""
        if not cell.is_viscous:
            return None
        per_length = 1 / setting.lengths.cell
        u, v = setting.velocities(state)
        omega = state.field("omega", ca.SX.zeros(setting.grid.cells + 1)) / setting.time_scale
        speed = (ca.diff(u) * per_length, ca.diff(v) * per_length)
        bending = ca.diff(omega) * (per_length / setting.values[symbols.L_0])
        return StrainRates(*cell.strain_rates(slope, angle, speed, to_cells(omega)), bending)

    def _at_points(self, state: Recall, grid: Grid, kind: str, branch: int) -> ca.SX:
        """Plastic strain of a branch at every point of every cell, shape (cells, points)."""
        zeros = ca.SX(grid.cells, 1)
        states = ca.horzcat(*(state.field(name, zeros) for name in self._names(kind, branch)))
        return self.rule.at_points(states)

    def _rates(self, points: Points) -> dict[str, ca.SX]:
        rates: dict[str, ca.SX] = {}
        for number, flow in enumerate(points.flows):
            for kind, at_points in (("axial", flow.axial_rate), ("shear", flow.shear_rate)):
                states = self.rule.of_states(at_points)
                rates |= {name: states[:, n] for n, name in enumerate(self._names(kind, number))}
        return rates

    def _shown(self, section: Resultants, points: Points, strains: Strains) -> dict[str, ca.SX]:
        if isinstance(self.rule, OneFibre):
            return {}
        weight, zeta = ca.DM(self.rule.weight), ca.DM(self.rule.zeta)
        fastest = points.speed[:, 0]
        for n in range(1, self.rule.points):
            fastest = ca.fmax(fastest, points.speed[:, n])
        low, high = _core(points.yields, self.rule.zeta)
        return {
            "core_low": low,
            "core_high": high,
            "tension": section.tension,
            "moment": section.moment,
            "shear_force": section.shear_force,
            "relative_thickness": section.relative_thickness,
            "curvature": strains.k / strains.Lam,
            "shear": strains.Gam / strains.Lam,
            "yielded_fraction": points.yields @ weight,
            "plastic_rate": fastest,
            "stress_mean": points.axial_stress @ weight,
            "stress_bending": points.axial_stress @ (weight * zeta / ca.dot(weight, zeta**2)),
        }


def _torque(length: ca.SX, section: Resultants, stage: Stage) -> ca.SX:
    """Change of the couple and the moment of the forces about each node, shape (cells + 1,) [Pa m]."""
    half, couple = stage("turning_half", length * section.turning_moment / 2), stage("couple", section.couple)
    return ca.vertcat(couple, 0) - ca.vertcat(0, couple) + ca.vertcat(half, 0) + ca.vertcat(0, half)


def _core(yields: ca.SX, points: Floats) -> tuple[ca.SX, ca.SX]:
    """Limits in zeta of what does not yield, between the fibres that do on either side and those that do not."""
    zeta = np.concatenate([[-1.0], (points[1:] + points[:-1]) / 2, [1.0]])
    below = above = ca.SX.ones(yields.size1(), 1)
    low, high = -below, 1 * above
    for n in range(len(points)):
        below, above = below * yields[:, n], above * yields[:, -1 - n]
        low += below * (zeta[n + 1] - zeta[n])
        high -= above * (zeta[-1 - n] - zeta[-2 - n])
    # Where the whole thickness yields both limits have met on the opposite faces: they are put together.
    return low, ca.fmax(low, high)
