"""Assembly of a filament that shears (geometrically exact in the plane), its section resolved point by point.

Positions and section angle live on nodes, the whole section on cells: a two-node element with one point along the
filament, so that it neither locks in shear nor has a spurious mode, and stretch, shear, bending and flow of a section
are in one place. Forces and torques are the exact derivatives of the discrete energy.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.discretisation import Discretisation, Fields, State, Unknowns
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.kirchhoff import free_nodes
from softcat_sym.graph.layout import Block, cell_block, node_block
from softcat_sym.graph.means import to_cells
from softcat_sym.graph.neck_force import neck_double_force, neck_tension
from softcat_sym.graph.resolved_printer import Points, ResolvedPrinter, Resultants
from softcat_sym.graph.section_rule import SectionRule


def reissner(rule: SectionRule) -> Discretisation:
    """The theory with its section sampled and its plastic state represented by `rule`."""
    section = _Sampled(rule)
    return Discretisation(section.unknowns, section.evaluate, expressions)


def expressions(equations: FilamentEquations) -> Iterable[Any]:
    """Whatever is printed of these equations, besides the balance."""
    resolved, neck = equations.resolved, equations.neck
    if resolved is None:
        return []
    cell, flow = resolved.cell, resolved.flow
    printed = [cell.axial_stress, cell.shear_stress, cell.moment.subs(sy.A0, 1), cell.elastic_energy]
    printed += [] if flow is None else [flow.speed]
    return [*printed, neck.double_force()] if neck is not None else printed


def _angle_nodes(grid: Grid) -> list[int]:
    """Nodes whose section angle is unknown: an end that holds the angle holds it at zero."""
    held = {0 if grid.first.holds_angle else None, grid.cells if grid.last.holds_angle else None}
    return [node for node in range(grid.cells + 1) if node not in held]


@dataclass(frozen=True)
class _Sampled:
    rule: SectionRule

    def unknowns(self, equations: FilamentEquations, grid: Grid) -> Unknowns:
        """Positions and angles of free nodes; the plastic states of every cell."""
        free_x, free_y = free_nodes(grid)
        zeros = np.zeros(grid.cells + 1)
        angles = _angle_nodes(grid)
        spins = (node_block("omega", angles, grid, zeros),) if equations.terms.rotary_inertia else ()
        return Unknowns(
            positions=(node_block("x", free_x, grid, grid.nodes), node_block("y", free_y, grid, zeros)),
            velocities=(node_block("u", free_x, grid, zeros), node_block("v", free_y, grid, zeros)),
            plastic=tuple(self._plastic(equations, grid)),
            angles=(node_block("psi", angles, grid, zeros),),
            spins=spins,
        )

    def _plastic(self, equations: FilamentEquations, grid: Grid) -> list[Block]:
        resolved = equations.resolved
        if resolved is None or resolved.flow is None:
            return []
        kinds = ("axial", "shear") if resolved.shears else ("axial",)
        return [cell_block(f"{kind}_{n}", grid) for kind in kinds for n in range(self.rule.states)]

    def evaluate(
        self, equations: FilamentEquations, values: Mapping[sy.Symbol, Any], grid: Grid, state: State
    ) -> Fields:
        """Evaluate the whole filament."""
        cell, span = ResolvedPrinter(equations, values, self.rule), values[sy.L]
        zeros = ca.SX(grid.cells + 1, 1)
        x, y = state.field("x", ca.SX(grid.nodes)), state.field("y", zeros)
        psi = state.field("psi", zeros)
        length, per_length = ca.DM(grid.cell_length), ca.DM(1 / grid.cell_length)
        slope = (ca.diff(x) * per_length, ca.diff(y) * per_length)
        k = ca.diff(psi) * (per_length / span)
        angle = to_cells(psi)
        Lam, Gam = cell.strains(slope, angle)
        points = cell.points(Lam, Gam, k, self._at_points(state, grid, "axial"), self._at_points(state, grid, "shear"))
        section = cell.resultants(Lam, Gam, k, angle, points)
        stretch = ca.sqrt(slope[0] ** 2 + slope[1] ** 2)
        force_x, force_y = section.force
        double_force = None
        if equations.neck is not None:
            double_force = neck_double_force(equations.neck, values, grid, stretch, section.tension)
            gain = neck_tension(grid, double_force) / stretch
            force_x, force_y = force_x + gain * slope[0], force_y + gain * slope[1]
        return Fields(
            x=x,
            y=y,
            stretch=stretch,
            force_x=force_x,
            force_y=force_y,
            plastic_rates=self._rates(points),
            elastic_energy=ca.dot(length, points.energy @ ca.DM(self.rule.weight)),
            dissipation=length * (points.dissipation @ ca.DM(self.rule.weight)),
            observables=self._shown(section, points, Lam, Gam, k),
            torque=_torque(length * span, section),
            double_force=double_force,
        )

    def _at_points(self, state: State, grid: Grid, kind: str) -> ca.SX:
        """Plastic strain at every point of every cell, shape (cells, points)."""
        zeros = ca.SX(grid.cells, 1)
        states = ca.horzcat(*(state.field(f"{kind}_{n}", zeros) for n in range(self.rule.states)))
        return states @ ca.sparsify(ca.DM(self.rule.recall)).T

    def _rates(self, points: Points) -> dict[str, ca.SX]:
        project = ca.sparsify(ca.DM(self.rule.project)).T
        axial, shear = points.axial_rate @ project, points.shear_rate @ project
        both = (("axial", axial), ("shear", shear))
        return {f"{kind}_{n}": rates[:, n] for kind, rates in both for n in range(self.rule.states)}

    def _shown(self, section: Resultants, points: Points, Lam: ca.SX, Gam: ca.SX, k: ca.SX) -> dict[str, ca.SX]:
        weight, zeta = ca.DM(self.rule.weight), ca.DM(self.rule.zeta)
        fastest = points.speed[:, 0]
        for n in range(1, self.rule.points):
            fastest = ca.fmax(fastest, points.speed[:, n])
        low, high = self._core(points.yields)
        return {
            "core_low": low,
            "core_high": high,
            "tension": section.tension,
            "moment": section.moment,
            "shear_force": section.shear_force,
            "relative_thickness": section.relative_thickness,
            "curvature": k / Lam,
            "shear": Gam / Lam,
            "yielded_fraction": points.yields @ weight,
            "plastic_rate": fastest,
            "stress_mean": points.axial_stress @ weight,
            "stress_bending": points.axial_stress @ (weight * zeta / ca.dot(weight, zeta**2)),
        }

    def _core(self, yields: ca.SX) -> tuple[ca.SX, ca.SX]:
        """Limits in zeta of what does not yield, between the fibres that do on either side and those that do not."""
        zeta = np.concatenate([[-1.0], (self.rule.zeta[1:] + self.rule.zeta[:-1]) / 2, [1.0]])
        below = above = ca.SX.ones(yields.size1(), 1)
        low, high = -below, 1 * above
        for n in range(self.rule.points):
            below, above = below * yields[:, n], above * yields[:, -1 - n]
            low += below * (zeta[n + 1] - zeta[n])
            high -= above * (zeta[-1 - n] - zeta[-2 - n])
        # Where the whole thickness yields both limits have met on the opposite faces: they are put together.
        return low, ca.fmax(low, high)


def _torque(length: ca.SX, section: Resultants) -> ca.SX:
    """Change of the couple and the moment of the forces about each node, shape (cells + 1,) [Pa m]."""
    half = length * section.turning_moment / 2
    return ca.vertcat(section.couple, 0) - ca.vertcat(0, section.couple) + ca.vertcat(half, 0) + ca.vertcat(0, half)
