"""Equations and a grid become a Graph: the theory that a scene calls for, and the filament at one instant."""

from __future__ import annotations

import math

import numpy as np

from softcat_sym.discretization.graph import Graph, Recorded, Theory
from softcat_sym.discretization.grid import (
    Grid,
    choose_grading,
    half_span,
    may_yield,
    towards_middle,
    whole_span,
)
from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, order_rule, ring_rule, warping_rule
from softcat_sym.discretization.supports import (
    EXIT_PLACES,
    NATURAL_PLACES,
    FilamentBody,
    Supports,
    ThicknessProfile,
    node_mass,
)
from softcat_sym.discretization.unknowns import INVERTED, PER, Block, Floats, Layout, Signature, Slot
from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.estimates.scaling import first_yield_gravity_number, gravity_number_of
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.feed import exit_time, feed_rows, nozzle_path
from softcat_sym.scene.natural_curve import has_shape
from softcat_sym.scene.parts import DOWN
from softcat_sym.scene.scene import Scene, carries_moment, is_symmetric, rest_length
from softcat_sym.scene.tables import bodies_of

DEFAULT_CELLS = 40
"""Cells per half span: where the whole section is on the cell, and of the published theory away from clamps."""

CLAMPED_CELLS = 80
"""Cells per half span of the published theory between clamps, at an accuracy of a thousandth: its moment, and with it
the largest error, is at the clamp. The error falls as the square, so that fewer do where less is asked."""

_THOUSANDTH = 1e-3

LINEAR_FIBRES = 2
"""Points that follow a linear profile exactly."""

DEFAULT_FIBRES = 8
"""Points through the thickness where fibres yield in turn."""

HINGE_FIBRES = 16
"""Where hinges carry much of the load: while they turn the midpoint is 5 % off with 8, 2 % with 12, 0.4 % with 16."""

_MAX_OF_FIRST_YIELD = 4.0
"""Weight, in that of first yield, beyond which tension carries it: a rectangle collapses at 2, a circle at 2.3."""

_MANY_POINTS = 0.005
"""Accuracy below which a section in three dimensions has twice as many points."""

_POINTS = {True: (15, 24), False: (16, 36)}
"""Of a circle and of a rectangle: as a rule, and where more is asked."""

_RINGS = 0.6
"""Square of the rings of a circle over its points: 3 x 5, 4 x 6."""

_IN_THE_PLANE = 3
"""Numbers of a row of the motion that stays in the plane: time, right and up."""

DEFAULT_PROJECTION = 24
"""Points that project a flow rule on polynomials: it has kinks."""


def choose_cells(scene: Scene, effects: Effects | None = None) -> int:
    """Cells per half span: as many as the scene says, otherwise what its theory, ends and accuracy need."""
    if scene.numerics.cells is not None:
        return scene.numerics.cells
    terms = (effects or choose_effects(scene)).terms()
    bent_ends = terms.bending and carries_moment(scene)
    if terms.turns or not bent_ends:
        return DEFAULT_CELLS
    fewer = CLAMPED_CELLS * math.sqrt(_THOUSANDTH / scene.run.accuracy)
    return int(min(CLAMPED_CELLS, max(DEFAULT_CELLS, round(fewer))))


def choose_fibres(scene: Scene) -> int:
    """Points through the thickness where fibres yield in turn: as many as the scene says, or as its hinges need.

    In three dimensions those of the whole section.
    """
    if scene.numerics.fibres is not None:
        return scene.numerics.fibres
    if is_spatial(scene):
        many = scene.run.accuracy < _MANY_POINTS
        return _POINTS[scene.filament.section == "circle"][many]
    return HINGE_FIBRES if _hinges_carry(scene) else DEFAULT_FIBRES


def _hinges_carry(scene: Scene) -> bool:
    """Whether much of the load is carried by hinges that yield in bending: not far beyond collapse."""
    gravity_number = gravity_number_of(scene)
    near = gravity_number is not None and gravity_number < _MAX_OF_FIRST_YIELD * first_yield_gravity_number(scene)
    return near and carries_moment(scene) and may_yield(scene)


def choose_grid(scene: Scene, effects: Effects | None = None) -> Grid:
    """Cells graded towards the clamps, unless the scene says how; half the span when it is symmetric."""
    cells = choose_cells(scene, effects)
    grading = scene.numerics.grading or choose_grading(scene, cells, effects)
    left, right = scene.ends.supports
    middle = towards_middle(scene, effects)
    densities = (effects or choose_effects(scene)).terms().densities
    edges = [one.edge_place / rest_length(scene) for one in bodies_of(scene) if one.edge_place is not None]
    edge = min(edges, default=0.5)
    if is_symmetric(scene) and all(one.symmetric for one in densities):
        return half_span(cells, right, grading, middle=middle, edge=edge)
    return whole_span(cells, left, right, grading, middle=middle, edge=edge)


def choose_body(scene: Scene, grid: Grid) -> FilamentBody:
    """Supports, profile and point mass, as far as they are not plain."""
    ends, shaped = scene.ends, has_shape(scene)
    left, right = (support.carries_moment for support in ends.supports)
    supports = Supports(
        apart=not math.isclose(rest_length(scene), scene.filament.span, rel_tol=1e-14),
        lowered=ends.drop != 0,
        # A clamp across the chord is turned into its place from there.
        left_turned=ends.left_angle != 0 or (left and ends.drop != 0),
        right_turned=ends.right_angle != 0 or (right and ends.drop != 0) or scene.extrusion.present,
        rows=len(nozzle_path(scene) if scene.extrusion.present else ends.motion),
        sideways=any(len(row) > _IN_THE_PLANE for row in ends.motion),
        turns=len(ends.right_twist),
        directed=scene.load.direction != DOWN,
        springs=tuple(ends.springs),
        feeds=len(feed_rows(scene)) if scene.extrusion.present else 0,
        curved=(shaped and left, shaped and right),
    )
    return FilamentBody(
        supports,
        ThicknessProfile.sampled(scene.filament.profile, grid),
        weighted=scene.load.point_mass > 0,
        tip_mass=scene.load.tip_mass > 0,
        tip_force=any(scene.load.tip_force),
        tip_torque=any(scene.load.tip_torque),
        natural=_natural(scene, grid),
        exits=_exits(scene, grid),
    )


def _exits(scene: Scene, grid: Grid) -> tuple[Floats, Floats] | None:
    """When nodes and cells come out of a nozzle, of a material that changes in time."""
    if not scene.extrusion.present or not scene.material.changes:
        return None
    length = rest_length(scene)
    nodes, centres = (np.array([exit_time(scene, (X + 0.5) * length) for X in at]) for at in (grid.nodes, grid.centres))
    return nodes, np.append(centres, 1.0)


def _natural(scene: Scene, grid: Grid) -> Floats | None:
    if not has_shape(scene):
        return None
    # Imported here, with SciPy, which takes half a second to load.
    from softcat_sym.discretization.natural_shape import shaped

    return shaped(scene, grid.nodes)[2]


def choose_theory(scene: Scene, terms: Terms) -> Theory:
    """The theory of the scene's model and effects."""
    if is_spatial(scene):
        return Theory(scene.model, _points(scene, asked_points(scene, terms)))
    return Theory(scene.model, choose_rule(scene, terms) if terms.turns else None)


def elastic_theory(scene: Scene) -> Theory:
    """The theory of a filament in three dimensions where nothing has flowed: with as few points as are exact then."""
    return Theory(scene.model, _points(scene, 0))


def asked_points(scene: Scene, terms: Terms) -> int:
    """Number of points from which those of a section in three dimensions are chosen."""
    return choose_fibres(scene) if terms.flows else 0


def _points(scene: Scene, points: int) -> SectionRule:
    """Points of a section in three dimensions: few where nothing flows, which they follow exactly, more where it does.

    What counts is how many different heights the angles of a circle give (THEORY3D 6).
    """
    if scene.filament.section == "circle":
        rings = max(1, round(math.sqrt(_RINGS * points)))
        return ring_rule(rings, max(3, math.ceil(points / rings)))
    count = max(2, math.ceil(math.sqrt(points)))
    return warping_rule(count, count, scene.filament.width / scene.filament.thickness)


def choose_rule(scene: Scene, terms: Terms) -> SectionRule:
    """Points through the thickness: two for a linear law, which they follow exactly, more where fibres yield in turn.

    ``numerics.order`` asks for amplitudes of polynomials instead of fibres.
    """
    numerics, section = scene.numerics, scene.filament.section
    if numerics.order is not None:
        return order_rule(section, numerics.order, DEFAULT_PROJECTION)
    fibres = choose_fibres(scene) if terms.resolved else numerics.fibres or LINEAR_FIBRES
    return fibre_rule(section, fibres, halves=in_halves(scene, terms))


def in_halves(scene: Scene, terms: Terms) -> bool:
    """Whether fibres are those of a rule in either half of the section."""
    return terms.resolved and _hinges_carry(scene)


def graph_of(recorded: Recorded, effects: tuple[str, ...], signature: Signature) -> Graph:
    """A filament whose sites compute what a signature names."""
    grid, formulation = recorded.grid, recorded.formulation
    differential, algebraic = (
        Layout([_block(slot, grid) for slot in signature.slots if slot.differential == differential])
        for differential in (True, False)
    )
    places = places_of(grid, recorded.body, formulation.area_power)
    described = effects, formulation.terms, formulation.conserves_energy
    return Graph(grid, *described, signature, recorded.theory.rule, recorded, places, differential, algebraic)


def _block(slot: Slot, grid: Grid) -> Block:
    """The unknowns of a slot on a grid, with the straight, relaxed filament at rest."""
    places = grid.nodes if slot.on == "node" else grid.centres
    first, last = (0, 1) if slot.on == "whole" else (slot.held[0], len(places) - slot.held[1])
    start = grid.nodes if slot.name == "x" else np.full(len(places), float(slot.name == "q0"))
    return Block(slot.name, tuple(range(first, last)), places[first:last], start[first:last])


def places_of(grid: Grid, body: FilamentBody, power: int) -> dict[str, Floats]:
    """Geometry of each site; what the last site's missing cell would have is one."""
    profile, middle = body.profile, np.zeros(grid.cells + 1)
    middle[int(np.argmin(np.abs(grid.nodes)))] = 0.5 if grid.is_half else 1.0
    known = {
        "X": grid.nodes,
        "cell": np.append(grid.cell_length, 1.0),
        "node": grid.node_length,
        "mass": node_mass(grid, profile, power),
        "hung": middle,
    }
    if profile.nodes is not None and profile.cells is not None:
        known |= {"h_node": np.asarray(profile.nodes), "h_cell": np.append(np.asarray(profile.cells), 1.0)}
    if body.natural is not None:
        known |= dict(zip(NATURAL_PLACES, np.vstack([body.natural, np.ones(3)]).T, strict=True))
    known |= dict(zip(EXIT_PLACES, body.exits or (), strict=False))
    return known | {PER + name: 1 / known[name] for name in INVERTED}
