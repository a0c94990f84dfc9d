"""Whether a filament stays in a plane or moves in space: decided by the scene (THEORY3D 8), and what space has not."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from softcat_sym.scene.ends import Hold
from softcat_sym.scene.natural_curve import misses_supports
from softcat_sym.scene.parts import DOWN, Rule, if_given
from softcat_sym.scene.tables import Tables, bodies_of

_IN_THE_PLANE = 3
"""Values in a row of a motion that stays in the plane: time, right and up."""


def out_of_plane(scene: Tables) -> str:
    """Reason why the equations of the plane do not hold for a scene; empty if everything lies in one plane.

    Gravity that is tilted within the plane, and what acts on a free end, are planar; only the theory in three
    dimensions has them.
    """
    filament, ends, load = scene.filament, scene.ends, scene.load
    reasons = (
        (load.direction[2] != 0, "load.direction points out of the plane"),
        (load.tip_force[2] != 0, "load.tip_force points out of the plane"),
        (any(len(row) > _IN_THE_PLANE for row in ends.motion), "ends.motion leaves the plane"),
        (any(angle != 0 for _, angle in ends.right_twist), "ends.right_twist turns a clamp about its own normal"),
        (filament.shape != "straight", "filament.shape gives it a curve in space"),
        (filament.twist != 0 and filament.curvature != 0, "filament.curvature and filament.twist make a helix"),
        (filament.twist != 0, "filament.twist turns the section along the filament"),
        (load.direction != DOWN, "load.direction is not straight down"),
        (any(load.tip_force), "load.tip_force pulls at the end"),
        (any(load.tip_torque), "load.tip_torque turns the end"),
        (ends.right_slides, "ends.right_slides lets a clamp slide"),
        (scene.initial.centreline, "initial.centreline says where it begins"),
        (load.tip_mass != 0, "load.tip_mass hangs at the end"),
    )
    return next((why for holds, why in reasons if holds), "")


def is_spatial(scene: Tables) -> bool:
    """Tell whether a scene is followed in three dimensions."""
    asked = scene.run.dimensions
    return asked == 3 or (asked == "auto" and out_of_plane(scene) != "")


def reason_for_dimensions(scene: Tables) -> str:
    """Say why a scene is followed in its plane, or in three dimensions."""
    if is_spatial(scene):
        return out_of_plane(scene) or "run.dimensions asks for them"
    return "everything lies in one plane"


def needed_in_space(scene: Tables) -> str:
    """Reason why a scene cannot do without what its theory in three dimensions holds; empty in the plane."""
    return f"three dimensions: {reason_for_dimensions(scene)}" if is_spatial(scene) else ""


def needs_section_angles(scene: Tables) -> str:
    """Reason why the angle of a section is an unknown of its own; empty where none is known."""
    springs = any(support.angle is Hold.SPRING for support in scene.ends.supports)
    laid = "the strand comes out of a nozzle at its angle" if scene.extrusion.present else ""
    return needed_in_space(scene) or ("a rotational spring turns the section of an end" if springs else laid)


def dimension_rules(scene: Tables) -> Iterator[Rule]:
    """List what goes neither with the ends nor with the dimensions of a scene."""
    ends, load, out, right = scene.ends, scene.load, "leaving it out", scene.ends.supports[1]
    found = f"given, but the right end is {ends.right}"
    loose = f'{out}, or ends.right = "free"'
    slides = ends.right_slides
    pulled = any(load.tip_force) and not right.is_free and not slides
    yield pulled, "load.tip_force", found, f"{loose}, or ends.right_slides"
    along = "a force along the span, right or left"
    yield slides and any(load.tip_force[1:]), "load.tip_force", "across the way that the clamp slides", along
    yield load.tip_mass > 0 and not right.is_free, "load.tip_mass", found, loose
    yield any(load.tip_torque) and not right.is_free, "load.tip_torque", found, loose
    clamped = f'{out}, or ends.right = "clamped"'
    yield ends.right_twist and not right.holds_angle, "ends.right_twist", found, clamped
    yield slides and not (right.holds_height and right.holds_angle), "ends.right_slides", found, clamped
    yield slides and ends.right_angle, "ends.right_angle", "given, but the clamp slides along the span", out
    pushed = slides and any(row[1] for row in ends.motion)
    yield pushed, "ends.motion", "along the span, where ends.right_slides leaves the end free", "rows with dx = 0"
    yield from _of_centreline(scene)
    why = out_of_plane(scene)
    yield scene.run.dimensions == 2 and why, "run.dimensions", f"2, but {why}", "auto or 3, or a scene in one plane"
    if is_spatial(scene):
        yield from _of_space(scene)


def _of_centreline(scene: Tables) -> Iterator[Rule]:
    """List what does not go with a filament that begins on a given curve."""
    points = scene.initial.centreline
    if not points:
        return
    yield from misses_supports(scene, points, "initial.centreline")
    double = any(a == b for a, b in pairwise(points))
    yield double, "initial.centreline", "two neighbouring points in one place", "a curve with a length"
    given, out = "given, but initial.centreline says where the filament begins", "leaving it out"
    yield from if_given(scene, given, out, "initial.stretch", "initial.surface")
    newtonian = f"given, but a fluid has no strain to begin with: the law is '{scene.material.law}'"
    yield not scene.material.spec.is_elastic, "initial.centreline", newtonian, "another law"


def _of_space(scene: Tables) -> Iterator[Rule]:
    """List what only a filament in its plane has so far."""
    filament, material, out = scene.filament, scene.material, "leaving it out"
    asked = needed_in_space(scene)
    only = f"only in the plane so far ({asked})"
    yield filament.section == "sheet", "filament.section", f"'sheet', whose torsion is a plate's ({asked})", "rectangle"
    yield scene.model == "small-deflection", "model", f"'small-deflection', {only}", "filament"
    yield scene.run.closure == "printed", "run.closure", f"'printed', {only}", "material"
    yield material.spec.has_chains, "material.law", f"'{material.law}', {only}", "a law without polymer chains"
    tables = [f"effects.{name}" for name, _ in scene.effects] + ["temperature"] * scene.temperature.present
    tables += [body.table_name for body in bodies_of(scene)]
    for path in (*(f"material.{name}" for name in (*material.histories(), *material.natural_strains())), *tables):
        yield True, path, f"given, {only}", out
    keys = ("material.structure", "material.hardening_modulus", "surroundings.density", "surroundings.viscosity")
    yield from if_given(scene, f"given, {only}", out, *keys, "load.point_mass", "initial.C", "numerics.order")
