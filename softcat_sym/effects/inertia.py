"""Inertia: momentum in the balance."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate, OfMotion, always
from softcat_sym.errors import Fault
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import instant_modulus
from softcat_sym.scene.feed import laid_at
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.tables import bodies_of


def outrunning_faults(scene: Scene) -> list[Fault]:
    """Refuse a support that moves faster than axial waves, sqrt(E/rho), which a filament with inertia cannot follow."""
    modulus = instant_modulus(scene)
    places = ((0.0,) * len(next(iter(scene.ends.motion), ())), *scene.ends.motion)
    if modulus is None:
        return []
    speeds = [
        math.dist(after[1:], before[1:]) / (after[0] - before[0])
        for before, after in itertools.pairwise(places)
        if after[0] > before[0]
    ]
    fastest, wave = max(speeds, default=0.0), math.sqrt(modulus / scene.filament.density)
    if fastest <= wave:
        return []
    found = f"the right support moves at {fastest:.3g} m/s, faster than axial waves of the filament at {wave:.3g} m/s"
    return [Fault("ends.motion", found, "a slower path, or run.effects without inertia")]


def _indispensable(scene: Scene) -> str:
    """What needs velocities, or begins out of balance."""
    if scene.initial.centreline:
        return "initial.centreline need not be an equilibrium"
    # A fluid's viscous stress tells its velocities, too.
    rubs = [body.table_name for body in bodies_of(scene) if body.resists_sliding and scene.material.spec.is_elastic]
    return f"the bond or friction of [{rubs[0]}] acts on velocities" if rubs else ""


_OF_MOTION = OfMotion(
    "missed", "lag behind its equilibrium, or ringing", "|y - y balanced| over the largest sag", late=True
)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    """Of a strand that is laid only what is fed while it falls lags behind: the load grows with the span."""
    if not scene.extrusion.present or scene.load.gravity == 0:
        return _OF_MOTION(scene, motion)
    falls = math.sqrt(2 * motion.sag * scene.filament.span / scene.load.gravity)
    share = min(1.0, falls / laid_at(scene))
    return Estimate(share, "share that is laid while it falls", "sqrt(2 f/g) over the time of laying", late=True)


INERTIA = Effect(
    name="inertia",
    summary="acceleration of the filament",
    source="2.1, 2.2",
    contribute=partial(replace, inertia=True),
    applies=always,
    without_it="",
    estimate=_estimate,
    observable="lag behind the balanced sag: its jump, its rate against free fall, acceleration over gravity",
    example="maxwell-slow",
    derivation="01_balance",
    causes=("inertia", "flow"),
    indispensable=_indispensable,
    faults=outrunning_faults,
)
