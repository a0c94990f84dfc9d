"""A section with a stress linear through its thickness, on the staggered grid: for theories without shear.

Stretching lives on cells, bending on nodes. The flow rule couples both through two-point means of the stress resultants
T and M of each branch, never of the strains, whose means have checkerboard modes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import CellPrinter
from softcat_sym.graph.discretisation import Fields, Setting
from softcat_sym.graph.means import to_cells, to_nodes
from softcat_sym.graph.profile import Outline, outline


def branch_name(kind: str, branch: int) -> str:
    """Name of a plastic state: that of its kind in the first branch, numbered in the others."""
    return kind if branch == 0 else f"{kind}_mode{branch + 1}"


@dataclass(frozen=True)
class Strained:
    """Deformation of the filament.

    Attributes
    ----------
    stretch, stretch_node : casadi.SX
        On cells and on nodes.
    turning : casadi.SX
        theta_X on nodes [1/m].
    stretch_rate, turning_rate : casadi.SX
        Their rates [1/s], on cells and on nodes; zero where nothing depends on them.
    """

    stretch: ca.SX
    stretch_node: ca.SX
    turning: ca.SX
    stretch_rate: ca.SX
    turning_rate: ca.SX


@dataclass(frozen=True)
class Stressed:
    """One part of the stress, a branch or the viscous one, and what it does: (cells) and (nodes)."""

    mean: ca.SX
    tension: ca.SX
    moment: ca.SX
    cells: Mapping[str, ca.SX]
    nodes: Mapping[str, ca.SX]


@dataclass(frozen=True)
class LinearSection:
    """All parts of the stress, and their resultants per unit undeformed area of the scene's section."""

    strained: Strained
    outline: Outline
    parts: tuple[Stressed, ...]
    viscous: bool
    tension: ca.SX
    moment: ca.SX
    stress_bending: ca.SX

    def gather(self, name: str) -> tuple[ca.SX, ca.SX]:
        """Sum over the parts of one quantity of stretching (cells) and the same of bending (nodes)."""
        zero = (ca.SX(self.strained.stretch.numel(), 1), ca.SX(self.strained.stretch_node.numel(), 1))
        cells = sum((p.cells[f"{name}_mean"] for p in self.parts if f"{name}_mean" in p.cells), zero[0])
        nodes = sum((p.nodes[f"{name}_bending"] for p in self.parts if f"{name}_bending" in p.nodes), zero[1])
        return cells, nodes


def stress_section(
    cell: CellPrinter, setting: Setting, recall: Callable[[str, ca.SX], ca.SX], strained: Strained
) -> LinearSection:
    """Stress of every branch, and their sum; `recall` gives the plastic state by its name."""
    response, grid = cell.equations.response, setting.grid
    shape = outline(setting.profile, cell.equations.shape.area_power, setting.values)
    zeros = ca.SX(grid.cells, 1), ca.SX(grid.cells + 1, 1)
    parts = []
    for number in range(len(response.branches)):
        a_0 = recall(branch_name("a_0", number), zeros[0])
        a_1 = recall(branch_name("a_1", number), zeros[1])
        parts.append(_part(cell, setting, shape, strained, number, (a_0, a_1)))
    if response.viscous is not None:
        parts.append(_part(cell, setting, shape, strained, len(response.branches), zeros))
    tension = sum((part.tension for part in parts), zeros[0])
    moment = sum((part.moment for part in parts), zeros[1])
    whole = {sy.s: strained.stretch, sy.M: to_cells(moment) / shape.area_cells, sy.h0: shape.h_cells}
    return LinearSection(
        strained=strained,
        outline=shape,
        parts=tuple(parts),
        viscous=response.viscous is not None,
        tension=tension,
        moment=moment,
        stress_bending=cell.section("stress_of_moment", whole),
    )


def _part(
    cell: CellPrinter, setting: Setting, shape: Outline, at: Strained, number: int, plastic: tuple[ca.SX, ca.SX]
) -> Stressed:
    grid, lengths, s, s_node = setting.grid, setting.lengths, at.stretch, at.stretch_node
    mean = cell.stress(number, "stress_mean", {sy.s: s, sy.s_t: at.stretch_rate, sy.a_0: plastic[0]})
    turned = {sy.theta_X: at.turning, sy.theta_Xt: at.turning_rate, sy.a_1: plastic[1], sy.h0: shape.h_nodes}
    if sy.kappa_0 in setting.values:
        # An end that carries no moment has no curvature of its own either.
        carries = np.ones(grid.cells + 1)
        carries[0], carries[-1] = grid.first.holds_angle, grid.last.holds_angle
        turned[sy.kappa_0] = setting.values[sy.kappa_0] * ca.DM(carries)
    stage, tag = setting.stage, f"_{number}"
    rates = {sy.s: s_node, sy.s_t: to_nodes(lengths, at.stretch_rate * ca.SX.ones(grid.cells))}
    bending = cell.stress(number, "stress_bending", {**turned, **rates})
    tension = stage("tension" + tag, shape.area_cells * cell.section("tension", {sy.s: s, sy.sigma_0: mean}))
    at_nodes = {sy.s: s_node, sy.sigma_1: bending, sy.h0: shape.h_nodes}
    moment = stage("moment" + tag, shape.area_nodes * cell.section("moment", at_nodes))
    on_nodes = stage("tension_node" + tag, to_nodes(lengths, tension) / shape.area_nodes)
    mean_node = cell.section("stress_of_tension", {sy.s: s_node, sy.T: on_nodes})
    moment_cell = stage("moment_cell" + tag, to_cells(moment) / shape.area_cells)
    on_cells = {sy.s: s, sy.M: moment_cell, sy.h0: shape.h_cells}
    bending_cell = cell.section("stress_of_moment", on_cells)
    return Stressed(
        mean=mean,
        tension=tension,
        moment=moment,
        cells=cell.flow(number, s, mean, bending_cell),
        nodes=cell.flow(number, s_node, mean_node, bending),
    )


def section_fields(
    setting: Setting,
    positions: tuple[ca.SX, ca.SX],
    force: tuple[ca.SX, ca.SX],
    section: LinearSection,
    shown: Mapping[str, ca.SX],
) -> Fields:
    """Gather rates, energies and observables from cells (stretching) and nodes (bending).

    Parameters
    ----------
    force : tuple of casadi.SX, shape (cells,)
        Internal force.
    shown : mapping of str to casadi.SX
        Observables that the theory has at hand.
    """
    grid, at, shape = setting.grid, section.strained, section.outline
    cell, node = setting.lengths.cell * shape.area_cells, setting.lengths.node * shape.area_nodes
    dissipated, stored = section.gather("dissipation"), section.gather("elastic")
    branches = section.parts[:-1] if section.viscous else section.parts
    # Where nothing stretches, no cell dissipates: a power that is zero at every place is left out of the quadratures.
    places = [cell * dissipated[0], node * dissipated[1]]
    rates = {branch_name("a_0", j): part.cells["rate_mean"] for j, part in enumerate(branches)}
    rates |= {branch_name("a_1", j): part.nodes["rate_bending"] for j, part in enumerate(branches)}
    return Fields(
        x=positions[0],
        y=positions[1],
        stretch=at.stretch,
        force_x=force[0],
        force_y=force[1],
        plastic_rates=rates,
        elastic_energy=ca.dot(cell, stored[0]) + ca.dot(node, stored[1]),
        dissipation=places[1] if places[0].is_zero() else ca.vertcat(*places),
        observables={
            **shown,
            "tension": section.tension,
            "moment": to_cells(section.moment),
            "curvature": to_cells(at.turning / at.stretch_node),
            "shear": ca.SX(grid.cells, 1),
            **_flowing(section, grid.cells),
            "stress_mean": sum((part.mean for part in section.parts), ca.SX(grid.cells, 1)),
            "stress_bending": section.stress_bending,
        },
    )


def _flowing(section: LinearSection, cells: int) -> dict[str, ca.SX]:
    """Share of the section that flows and its fastest rate: of the fastest branch, or of a fluid without any."""
    if section.viscous and len(section.parts) == 1:
        return {"yielded_fraction": ca.SX.ones(cells), "plastic_rate": to_cells(section.parts[0].nodes["plastic_rate"])}
    branches = section.parts[:-1] if section.viscous else section.parts
    shown = {}
    for name in ("yielded_fraction", "plastic_rate"):
        largest = to_cells(branches[0].nodes[name])
        for branch in branches[1:]:
            largest = ca.fmax(largest, to_cells(branch.nodes[name]))
        shown[name] = largest
    return shown


def plastic_names(equations: FilamentEquations) -> list[tuple[str, str]]:
    """Names of the axial and the bending plastic state of every branch that flows."""
    return [
        (branch_name("a_0", number), branch_name("a_1", number))
        for number, branch in enumerate(equations.response.branches)
        if branch.means is not None
    ]
