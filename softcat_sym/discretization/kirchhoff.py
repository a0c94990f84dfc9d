"""Shear-free filaments on the staggered grid: the paper's kinematics, and small deflections."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.casadi_printer import CellFunction
from softcat_sym.discretization.cell_printer import CellPrinter, Pair
from softcat_sym.discretization.graph import Discretisation, Fields, Recall, Setting, Unknowns
from softcat_sym.discretization.grid import Block, Grid, Lengths, block, cell_block, node_block, to_cells, to_nodes
from softcat_sym.discretization.supports import Outline, as_values, outline
from softcat_sym.physics import symbols
from softcat_sym.physics.filament import FilamentEquations
from softcat_sym.physics.loads import Surface, surface_tension
from softcat_sym.physics.necking import Neck, aspect, s_slope

_INPUTS = (symbols.T, symbols.s, s_slope, symbols.h0, aspect)


def neck_double_force(neck: Neck, setting: Setting, stretch: ca.SX, tension: ca.SX) -> ca.SX:
    """B s_X at inner nodes, over the rest length [Pa], shape (cells - 1,)."""
    lengths, span = setting.lengths, setting.values[symbols.L_0]
    slope = ca.diff(stretch) / lengths.node[1:-1] / span
    at_nodes = {
        symbols.T: to_nodes(lengths, tension)[1:-1],
        symbols.s: to_nodes(lengths, stretch)[1:-1],
        s_slope: slope,
    }
    known = {symbol: setting.values[symbol] for symbol in _INPUTS if symbol in setting.values}
    if setting.profile.nodes is not None:
        known[symbols.h0] = known[symbols.h0] * as_values(setting.profile.nodes)[1:-1]
    force = CellFunction({"b": neck.double_force()}, _INPUTS)({**known, **at_nodes})["b"]
    return setting.stage("double_force", ca.SX(force / span))


def neck_tension(lengths: Lengths, double_force: ca.SX) -> ca.SX:
    """- d/dX (b s_X), what the axial force of each cell gains, shape (cells,)."""
    padded = ca.vertcat(0, double_force, 0)
    return ca.SX(-ca.diff(padded) / lengths.cell)


def surface_force(surface: Surface, setting: Setting, outline: Outline, stretch: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Axial force of each cell per unit undeformed area of the section, and the surface energy per unit span."""
    values = setting.values
    # Along a profile the width stays, so that its ratio to the thickness does not.
    given = {symbols.s: stretch, symbols.h0: outline.h_cells, surface_tension: values[surface_tension]}
    if aspect in values:
        given[aspect] = values[aspect] / outline.relative
    expressions = {"force": surface.force(), "energy": surface.energy()}
    found = CellFunction(expressions, (symbols.s, symbols.h0, surface_tension, aspect))(given)
    per_cell = ca.SX.ones(setting.grid.cells) * outline.area_cells
    return found["force"] * per_cell, ca.dot(setting.lengths.cell * per_cell, found["energy"])


def branch_name(kind: str, branch: int) -> str:
    """Name of a plastic state: that of its kind in the first branch, numbered in the others."""
    return kind if branch == 0 else f"{kind}_mode{branch + 1}"


@dataclass(frozen=True)
class Strained:
    """Deformation of the filament."""

    stretch: ca.SX  # On cells and on nodes
    stretch_node: ca.SX
    turning: ca.SX  # theta_X on nodes [1/m]
    stretch_rate: ca.SX  # Their rates [1/s], on cells and on nodes; zero where nothing depends on them
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
    whole = {symbols.s: strained.stretch, symbols.M: to_cells(moment) / shape.area_cells, symbols.h0: shape.h_cells}
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
    mean = cell.stress(number, "stress_mean", {symbols.s: s, symbols.s_t: at.stretch_rate, symbols.a_0: plastic[0]})
    turned = {
        symbols.theta_X: at.turning,
        symbols.theta_Xt: at.turning_rate,
        symbols.a_1: plastic[1],
        symbols.h0: shape.h_nodes,
    }
    if symbols.kappa_0 in setting.values:
        # An end that carries no moment has no curvature of its own either.
        carries = np.ones(grid.cells + 1)
        carries[0], carries[-1] = grid.first.holds_angle, grid.last.holds_angle
        turned[symbols.kappa_0] = setting.values[symbols.kappa_0] * ca.DM(carries)
    stage, tag = setting.stage, f"_{number}"
    rates = {symbols.s: s_node, symbols.s_t: to_nodes(lengths, at.stretch_rate * ca.SX.ones(grid.cells))}
    bending = cell.stress(number, "stress_bending", {**turned, **rates})
    tension = stage("tension" + tag, shape.area_cells * cell.section("tension", {symbols.s: s, symbols.sigma_0: mean}))
    at_nodes = {symbols.s: s_node, symbols.sigma_1: bending, symbols.h0: shape.h_nodes}
    moment = stage("moment" + tag, shape.area_nodes * cell.section("moment", at_nodes))
    on_nodes = stage("tension_node" + tag, to_nodes(lengths, tension) / shape.area_nodes)
    mean_node = cell.section("stress_of_tension", {symbols.s: s_node, symbols.T: on_nodes})
    moment_cell = stage("moment_cell" + tag, to_cells(moment) / shape.area_cells)
    on_cells = {symbols.s: s, symbols.M: moment_cell, symbols.h0: shape.h_cells}
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
    """Gather rates, energies and observables from cells (stretching) and nodes (bending)."""
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
    return {
        name: functools.reduce(ca.fmax, [to_cells(branch.nodes[name]) for branch in branches])
        for name in ("yielded_fraction", "plastic_rate")
    }


def plastic_names(equations: FilamentEquations) -> list[tuple[str, str]]:
    """Names of the axial and the bending plastic state of every branch that flows."""
    return [
        (branch_name("a_0", number), branch_name("a_1", number))
        for number, branch in enumerate(equations.response.branches)
        if branch.means is not None
    ]


def _unknowns(
    equations: FilamentEquations, grid: Grid, axial: Callable[[str], Block] | None, *, along: bool
) -> Unknowns:
    """Positions and velocities of free nodes; `axial` plastic states, a_1 of every node that carries a moment."""
    (free_x, free_y), zeros, names = free_nodes(grid), np.zeros(grid.cells + 1), plastic_names(equations)
    plastic: list[Block] = []
    for mean, bending in names:
        plastic += [axial(mean)] if axial is not None else []
        plastic += [node_block(bending, bending_nodes(grid), grid, zeros)] if equations.terms.bending else []
    # What each kind of plastic state is of a linear plastic strain.
    means = {mean: (1.0, 0.0) for mean, _ in names} if equations.terms.stretches else {}
    x = (node_block("x", free_x, grid, grid.nodes),) if along else ()
    u = (node_block("u", free_x, grid, zeros),) if along else ()
    return Unknowns(
        positions=(*x, node_block("y", free_y, grid, zeros)),
        velocities=(*u, node_block("v", free_y, grid, zeros)),
        plastic=tuple(plastic),
        profiles=means | {bending: (0.0, 1.0) for _, bending in names},
    )


def kirchhoff_unknowns(equations: FilamentEquations, grid: Grid) -> Unknowns:
    """Positions and velocities; a_0 of every cell.

    A filament that does not stretch has neither x nor a_0: its nodes stay above the places where they start.
    """
    stretches = equations.terms.stretches
    return _unknowns(equations, grid, (lambda name: cell_block(name, grid)) if stretches else None, along=stretches)


def evaluate_kirchhoff(equations: FilamentEquations, setting: Setting, state: Recall) -> Fields:
    """Evaluate the whole filament."""
    cell, grid = CellPrinter(equations, setting.values), setting.grid
    x, y = setting.positions(state)
    x = x if equations.terms.stretches else unstretched_places(setting)
    stage, lengths = setting.stage, setting.lengths
    per_length, per_span = 1 / lengths.cell, 1 / setting.values[symbols.L_0]
    slope = (stage("slope_x", ca.diff(x) * per_length), stage("slope_y", ca.diff(y) * per_length))
    s = stage("s", cell.stretch(slope)) if equations.terms.stretches else ca.SX.ones(grid.cells, 1)
    s_node, turned_by = stage("s_node", to_nodes(lengths, s)), stage("turning", turning(cell, setting, slope))
    strained = Strained(s, s_node, turned_by, *_rates(cell, setting, state, slope))
    section = stress_section(cell, setting, state.field, strained)
    turned = {symbols.s: strained.stretch_node, symbols.theta_X: strained.turning, symbols.M: section.moment}
    axial = section.tension + to_cells(stage("axial_correction", cell.section("axial_correction", turned)))
    surface_energy = None
    if equations.surface is not None:
        pull, surface_energy = surface_force(equations.surface, setting, section.outline, s)
        axial += pull
    double_force = None
    if equations.neck is not None:
        double_force = neck_double_force(equations.neck, setting, s, section.tension)
        axial += neck_tension(lengths, double_force)
    transverse = ca.diff(section.moment) * (per_length * per_span)
    shown = {
        **({"axial_force": axial} if surface_energy is not None else {}),
        "shear_force": transverse / s,
        "relative_thickness": cell.section("relative_thickness", {symbols.s: s}) * section.outline.relative,
    }
    force_x, force_y = cell.force(slope, s, axial, transverse)
    force = stage("force_x", force_x), stage("force_y", force_y)
    fields = section_fields(setting, (x, y), force, section, shown)
    return replace(fields, double_force=double_force, surface_energy=surface_energy)


def unstretched_places(setting: Setting) -> ca.SX:
    """Places of nodes that stay above those where a straight, level filament has them, in rest lengths."""
    grid, nodes = setting.grid, ca.SX(setting.lengths.nodes)
    if grid.first.holds_height:
        return nodes + (setting.supports.left_x - nodes[0])
    return nodes + (setting.supports.right_x - nodes[-1])


def turning(cell: CellPrinter, setting: Setting, slope: Pair) -> ca.SX:
    """theta_X at every node [1/m]; an end that holds the angle turns against its clamp."""
    grid = setting.grid
    if not cell.equations.terms.bending:
        return ca.SX(grid.cells + 1, 1)
    before, behind = clamp_tangents(setting)
    first = cell.turning(before, (slope[0][0], slope[1][0])) if grid.first.holds_angle else ca.SX(0)
    last = cell.turning((slope[0][-1], slope[1][-1]), behind) if grid.last.holds_angle else ca.SX(0)
    inner = cell.turning((slope[0][:-1], slope[1][:-1]), (slope[0][1:], slope[1][1:]))
    return ca.SX(ca.vertcat(first, inner, last) * (1 / setting.lengths.node / setting.values[symbols.L_0]))


def clamp_tangents(setting: Setting) -> tuple[Pair, Pair]:
    """Directions that the ends hold: a clamp its own, a plane of symmetry the level one."""
    left, right = setting.supports.left_angle, setting.supports.right_angle
    if setting.grid.is_half:
        return (ca.SX(1), ca.SX(0)), (ca.cos(right), ca.sin(right))
    return (ca.cos(left), ca.sin(left)), (ca.cos(right), ca.sin(right))


def _rates(cell: CellPrinter, setting: Setting, state: Recall, slope: Pair) -> Pair:
    """Rates of stretch and turning [1/s], where the stress depends on them."""
    grid = setting.grid
    if cell.equations.response.viscous is None:
        return ca.SX(grid.cells, 1), ca.SX(grid.cells + 1, 1)
    per_length, stage = 1 / setting.lengths.cell, setting.stage
    u, v = setting.velocities(state)
    speed = (stage("speed_x", ca.diff(u) * per_length), stage("speed_y", ca.diff(v) * per_length))
    stretches = cell.equations.terms.stretches
    stretching = stage("stretching", cell.stretch_rate(slope, speed)) if stretches else ca.SX(grid.cells, 1)
    if not cell.equations.terms.bending:
        return stretching, ca.SX(grid.cells + 1, 1)
    at_rest = (ca.SX(0), ca.SX(0))
    before, behind = clamp_tangents(setting)
    (slope_0, speed_0), (slope_1, speed_1) = [[(a[0][k], a[1][k]) for a in (slope, speed)] for k in (0, -1)]
    first = cell.turning_rate((before, slope_0), (at_rest, speed_0)) if grid.first.holds_angle else ca.SX(0)
    last = cell.turning_rate((slope_1, behind), (speed_1, at_rest)) if grid.last.holds_angle else ca.SX(0)
    inner = cell.turning_rate(*(((a[0][:-1], a[1][:-1]), (a[0][1:], a[1][1:])) for a in (slope, speed)))
    per_node = 1 / setting.lengths.node / setting.values[symbols.L_0]
    return stretching, stage("turning_rate", ca.vertcat(first, inner, last) * per_node)


def bending_nodes(grid: Grid) -> list[int]:
    """Nodes that carry a moment, and with it a bending plastic strain."""
    inner = list(range(1, grid.cells))
    first = [0] if grid.first.holds_angle else []
    last = [grid.cells] if grid.last.holds_angle else []
    return [*first, *inner, *last]


def free_nodes(grid: Grid) -> tuple[list[int], list[int]]:
    """Nodes whose x, and nodes whose y, is unknown."""
    inner, ends = list(range(1, grid.cells)), ((0, grid.first), (grid.cells, grid.last))
    free_x = {node for node, end in ends if not end.holds_x}
    free_y = {node for node, end in ends if not end.holds_height}
    return sorted({*inner, *free_x}), sorted({*inner, *free_y})


def expressions(equations: FilamentEquations) -> Iterable[Any]:
    """Whatever is printed of these equations, besides the balance."""
    return [*equations.response.expressions(), *beyond_the_section(equations)]


def beyond_the_section(equations: FilamentEquations) -> Iterable[Any]:
    """What neck and surface add to the axial force."""
    neck, surface = equations.neck, equations.surface
    return [*([neck.double_force()] if neck else []), *([surface.energy()] if surface else [])]


KIRCHHOFF = Discretisation("kirchhoff", kirchhoff_unknowns, evaluate_kirchhoff, expressions)


def small_deflection_unknowns(equations: FilamentEquations, grid: Grid) -> Unknowns:
    """Heights and their velocities; one a_0 for the filament."""
    return _unknowns(equations, grid, lambda name: block(name, (0,), grid.centres, np.zeros(grid.cells)), along=False)


def evaluate_small_deflection(equations: FilamentEquations, setting: Setting, state: Recall) -> Fields:
    """Evaluate the whole filament from its heights."""
    cell, grid = CellPrinter(equations, setting.values), setting.grid
    zeros, every = ca.SX(grid.cells + 1, 1), ca.SX.ones(grid.cells, 1)
    length, per_span = setting.lengths.cell, 1 / setting.values[symbols.L_0]
    per_length = 1 / length
    y = state.field("y", zeros)
    slope = (every, ca.diff(y) * per_length)
    # Elongation of each cell at x_X = 1; what the mean has beyond it is the horizontal displacement U (2.13).
    lengthening = cell.stretch(slope) - 1
    elongation = ca.dot(length, lengthening) / float(np.sum(grid.cell_length))
    displacement = ca.vertcat(0, ca.cumsum(length * (elongation - lengthening)))
    s, s_node = (1 + elongation) * every, (1 + elongation) * ca.SX.ones(grid.cells + 1, 1)
    strained = Strained(s, s_node, turning(cell, setting, slope), ca.SX(grid.cells, 1), zeros)

    def recall(name: str, full: ca.SX) -> ca.SX:
        values = state.field(name, full)
        # One axial plastic strain for all: every cell has that of the first.
        return values[0] * every if name.startswith("a_0") else values

    section = stress_section(cell, setting, recall, strained)
    transverse = ca.diff(section.moment) * (per_length * per_span)
    axial, surface_energy = section.tension, None
    if equations.surface is not None:
        pull, surface_energy = surface_force(equations.surface, setting, section.outline, s)
        axial += pull
    _, force_y = cell.force(slope, s, axial, transverse)
    shown = {"shear_force": transverse / s, "relative_thickness": every}
    shown |= {"axial_force": axial} if surface_energy is not None else {}
    places, force = (ca.SX(grid.nodes) + displacement, y), (ca.SX(grid.cells, 1), force_y)
    return replace(section_fields(setting, places, force, section, shown), surface_energy=surface_energy)


SMALL_DEFLECTION = Discretisation("small-deflection", small_deflection_unknowns, evaluate_small_deflection, expressions)
