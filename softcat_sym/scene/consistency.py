"""What single keys cannot show: whether geometry, ends, initial state and law go together."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.geometry import chord_angle, distance, is_held, is_slack, rest_length
from softcat_sym.scene.laws import SOLIDS
from softcat_sym.scene.support_path import farthest, motion_faults

if TYPE_CHECKING:
    from softcat_sym.scene.model import Scene

_ROUNDING = 1e-12
# Beyond, the two supports are one point.
_LONGEST = 1000
_ANGLE_ROUNDING = 1e-9
# The small-deflection model has laws of one plastic stretch; a law that yields is refused where effects are chosen.
_SMALL_LAWS = ("elastic", "maxwell")
_REFUSED_LATER = ("bingham", "herschel-bulkley")


def faults_between_parts(scene: Scene) -> list[Fault]:
    """List everything that does not go together.

    Parameters
    ----------
    scene : Scene
        Sound part by part.

    Returns
    -------
    list of Fault
        Empty for a scene that makes sense.
    """
    checks = (
        *(_of_ends, motion_faults, _of_reach, _of_slack, _of_initial_state, _of_newtonian, _of_small_deflection),
        *(_of_shaking, _of_loss, _of_section),
    )
    return [fault for check in checks for fault in check(scene)]


def refuse_settled(scene: Scene, why: str) -> None:
    """Refuse a run that ends when it has settled, where several answers are compared at the same times.

    Raises
    ------
    SceneError
        If the scene asks for that.
    """
    if scene.run.until == "settled":
        raise SceneError([Fault("run.until", f"'settled', but {why}", "duration")])


def _of_ends(scene: Scene) -> Iterator[Fault]:
    ends = scene.ends
    if ends.left == ends.right == "free":
        yield Fault("ends", "both ends are free", "at least one end clamped or pinned")
    for side, how in (("left", ends.left), ("right", ends.right)):
        if how != "clamped" and getattr(ends, f"{side}_angle") != 0:
            found = f"given, but the {side} end is {how}"
            yield Fault(f"ends.{side}_angle", found, f'leaving it out, or ends.{side} = "clamped"')
    if ends.drop != 0 and not is_held(scene):
        yield Fault("ends.drop", "given, but one end is free", "leaving it out, or two ends that are held")
    if ends.motion and ends.right == "free":
        yield Fault("ends.motion", "given, but the right end is free", "leaving it out, or a right end that is held")


def _of_section(scene: Scene) -> Iterator[Fault]:
    numerics = scene.numerics
    if numerics.order is not None and numerics.fibres is not None:
        found = f"{numerics.order}, but numerics.fibres is {numerics.fibres}: polynomials stand in the place of fibres"
        yield Fault("numerics.order", found, "one of the two")


def _of_shaking(scene: Scene) -> Iterator[Fault]:
    load = scene.load
    if load.shake > 0 and scene.run.until == "settled":
        found = f"'settled', but load.shake is {load.shake:g}: what is shaken does not come to rest"
        yield Fault("run.until", found, "duration")
    if load.shake > 0 and load.shake_frequency == 0:
        found = f"zero or missing, but load.shake is {load.shake:g}"
        yield Fault("load.shake_frequency", found, 'a positive frequency, such as "5 Hz", or no load.shake')
    if load.shake_frequency > 0 and load.shake == 0:
        found = f"zero or missing, but load.shake_frequency is {load.shake_frequency:g} Hz"
        yield Fault("load.shake", found, "a positive number without a unit, such as 0.3, or no load.shake_frequency")


def _of_loss(scene: Scene) -> Iterator[Fault]:
    """A loss below yield is a stress that only the filament of the material closure has."""
    material, ends = scene.material, scene.ends
    if not material.has_loss:
        return
    key = "loss_modulus" if material.loss_modulus else "loss_tangent" if material.loss_tangent else "solid_viscosity"
    path, accepted = f"material.{key}", "leaving it out"
    if scene.model == "small-deflection":
        yield Fault(path, "given with model 'small-deflection'", f'{accepted}, or model = "filament"')
    if scene.run.closure == "printed":
        found = "given with run.closure = 'printed', whose section has no viscous stress beside its flow"
        yield Fault(path, found, f'{accepted}, or run.closure = "material"')
    if key != "solid_viscosity" and sorted((ends.left, ends.right)) == ["free", "pinned"]:
        found = "given, but a strand that a pin alone holds has no elastic natural frequency at which it holds"
        yield Fault(path, found, f"material.solid_viscosity, or {accepted}")


def _of_reach(scene: Scene) -> Iterator[Fault]:
    """The force A0 E log(s)/s of a true-strain bar is greatest at s = e: beyond it no weight is carried stably."""
    if scene.material.law not in SOLIDS or not is_held(scene):
        return
    length = rest_length(scene)
    limit = math.e * length * (1 + _ROUNDING)
    reach = farthest(scene)
    if reach <= limit:
        return
    # By what stretches it: a motion if that is why, else the length, however it was given.
    drawn_at_first = distance(scene) > limit
    given = "initial.stretch" if scene.filament.rest_length is None else "filament.rest_length"
    found = (
        f"the supports are up to {reach:.4g} m apart, {reach / length:.4g} times the rest length {length:.4g} m: "
        "beyond what the filament can follow; an elastic filament of true strain is strongest at stretch e = 2.718"
    )
    yield Fault(
        given if drawn_at_first else "ends.motion", found, f"at most {math.e:.4g} times, {math.e * length:.4g} m"
    )


def _of_slack(scene: Scene) -> Iterator[Fault]:
    if not is_slack(scene):
        return
    if rest_length(scene) > _LONGEST * distance(scene):
        times = rest_length(scene) / distance(scene)
        found = f"{rest_length(scene):.4g} m, {times:.4g} times the distance of the supports"
        yield Fault("filament.rest_length", found, f"at most {_LONGEST} times, {_LONGEST * distance(scene):.4g} m")
    slack = f"the filament is slack ({rest_length(scene):.4g} m over {distance(scene):.4g} m)"
    if scene.material.law == "newtonian":
        yield Fault("material.law", f"'newtonian', but {slack}: a fluid has no shape to start from", "maxwell")
    if scene.load.ramp > 0:
        found = f"{scene.load.ramp:g} s, but {slack}: a slack filament hangs in its weight from the start"
        yield Fault("load.ramp", found, "leaving it out")
    if scene.load.gravity == 0:
        yield Fault("load.gravity", f"zero, but {slack}: nothing tells what shape it has", "a positive acceleration")
    for name in ("P", "C"):
        if getattr(scene.initial, name):
            yield Fault(f"initial.{name}", f"given, but {slack}", "leaving it out, or a taut filament")


def _of_initial_state(scene: Scene) -> Iterator[Fault]:
    initial, law = scene.initial, scene.material.law
    stretched = initial.stretch != 1
    if law in SOLIDS and initial.relaxed and stretched:
        found = f"true with a stretch, but the law '{law}' does not flow"
        yield Fault("initial.relaxed", found, "false; or filament.rest_length instead of initial.stretch")
    if not initial.relaxed and stretched and scene.filament.rest_length is not None:
        follows = distance(scene) / initial.stretch
        if not math.isclose(scene.filament.rest_length, follows, rel_tol=_ROUNDING):
            found = f"{initial.stretch:g}, but filament.rest_length is {scene.filament.rest_length:g} m"
            yield Fault("initial.stretch", found, f"one of the two, or a rest length of {follows!r} m")
    if law in (*SOLIDS, "newtonian"):
        for name in ("P", "C"):
            if getattr(initial, name):
                yield Fault(f"initial.{name}", f"given, but the law '{law}' has no plastic strain", "leaving it out")


def _of_newtonian(scene: Scene) -> Iterator[Fault]:
    if scene.material.law != "newtonian":
        return
    ends, accepted = scene.ends, "leaving it out, or the law 'maxwell'"
    if scene.filament.curvature != 0:
        yield Fault(
            "filament.curvature", "given, but a newtonian filament has no elastic shape to start from", accepted
        )
    if not is_held(scene):
        return
    chord = chord_angle(scene)
    for side, how, angle in (("left", ends.left, ends.left_angle), ("right", ends.right, ends.right_angle)):
        if how == "clamped" and abs(angle - chord) > _ANGLE_ROUNDING:
            found = (
                f"a clamp at {math.degrees(angle):.4g} deg off the line between the supports, at "
                f"{math.degrees(chord):.4g} deg: a newtonian filament has no elastic shape to start from"
            )
            yield Fault(f"ends.{side}_angle", found, f"\"{chord!r} rad\", a pinned end, or the law 'maxwell'")


def _of_small_deflection(scene: Scene) -> Iterator[Fault]:
    if scene.model != "small-deflection":
        return
    law, accepted = scene.material.law, 'leaving it out, or model = "filament"'
    if law not in (*_SMALL_LAWS, *_REFUSED_LATER):
        yield Fault("material.law", f"{law!r} with model 'small-deflection'", " or ".join(_SMALL_LAWS))
    defaults = (
        ("filament", {"rest_length": None, "profile": (), "curvature": 0.0}),
        ("ends", {"drop": 0.0, "left_angle": 0.0, "right_angle": 0.0, "motion": ()}),
        ("initial", {"stretch": 1.0, "P": (), "C": ()}),
    )
    for table, keys in defaults:
        for key, default in keys.items():
            if getattr(getattr(scene, table), key) != default:
                yield Fault(f"{table}.{key}", "given with model 'small-deflection'", accepted)
    if scene.filament.section == "sheet":
        yield Fault("filament.section", "'sheet' with model 'small-deflection'", "rectangle, circle")
    for side in ("left", "right"):
        if getattr(scene.ends, side) == "free":
            yield Fault(f"ends.{side}", "'free' with model 'small-deflection'", "clamped, pinned")
