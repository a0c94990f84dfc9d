"""Contact: what sinks onto a floor, or lies on pillars, is held up by a stiff penalty with damping, bond and friction.

The penalty errs by a stated penetration d_p, to which a filament sinks in under its own weight. Where it leaves a body
it presses harder, over the length l = (4 E I d_p/q)^(1/4) of a beam on an elastic foundation (Hetenyi 1946); over that
length its first point of contact is blurred, so that lengths of contact are given with it.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from softcat_sym.effects.effect import Effect, Estimate, Fields, Observed
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.forecast import forecast
from softcat_sym.estimates.quasi_static_sag import load_factor
from softcat_sym.estimates.scaling import effective_viscosity, gravity_of, instant_modulus, section_of
from softcat_sym.physics.terms import Terms, Touch
from softcat_sym.scene.bodies import Body, body_number, overlap
from softcat_sym.scene.scene import Scene, rest_length, undeformed_area
from softcat_sym.scene.tables import bodies_of, nearest, unsupported
from softcat_sym.scene.units import length_text

Floats = npt.NDArray[np.float64]
_SHARE, _OF_SAG, _LEAST = 0.1, 0.01, 1e-6
"""Penetration over accuracy times the smallest length; at most that of the sag at an edge; at least that thickness."""

_SLOW = 1e-3
"""Slip speed of Coulomb friction over the fastest sliding."""

MAX_PENETRATION = 10.0
"""Of the stated penetration, beyond which a run is refused: with that of auto, the accuracy times the least length."""


def _smallest(scene: Scene, body: Body) -> float:
    """Least of expected sag, thickness and room [m]."""
    sag, thickness = forecast(scene).sag * scene.filament.span, scene.filament.thickness
    return max(_LEAST * thickness, min(thickness, sag, body.room() or math.inf))


def penetration_of(scene: Scene, body: Body) -> float:
    """Penetration under the filament's own weight [m]."""
    if not isinstance(body.penetration, str):
        return body.penetration
    least, accuracy, speed = _smallest(scene, body), scene.run.accuracy, forecast(scene).speed
    share = _SHARE * accuracy
    if body.edge_place is not None:
        # An edge carries half of the load over the gap on about a thickness.
        narrow = scene.filament.thickness / (2 * body.edge_place * load_factor(scene))
        return min(share, _OF_SAG) * least * min(1.0, narrow)
    # What lands with a velocity v sinks in by v sqrt(d_p/g)/e, critically damped.
    landing = scene.load.gravity * (math.e * accuracy * least / speed) ** 2 if speed else math.inf
    return max(_LEAST * scene.filament.thickness, min(share * least, landing))


def _bond_of(scene: Scene, body: Body) -> float:
    """Viscous bond [Pa s]: what sticks slips in the run by no more than changes the sag by the accuracy.

    A slip s on either side adds 2 s to the length, which is longer than the span by 8 H^2/(3 L), and stretched by
    T L/(E A). The bond takes part where half the free span presses.
    """
    if not isinstance(body.bond, str):
        return body.bond
    span, sag = unsupported(scene).filament.span, forecast(scene).sag * scene.filament.span
    depth = max(_LEAST * scene.filament.thickness, min(sag, body.room() or math.inf))
    tension = _weight(scene) * span**2 / (8 * depth)
    modulus = instant_modulus(scene)
    stretched = tension * span / (modulus * undeformed_area(scene)) if modulus else 0.0
    slip = scene.run.accuracy * (8 / 3 * depth**2 / span + stretched) / 2
    return tension * scene.run.duration / (span / 2 * slip) if body.bond == "stick" else 0.0


def _weight(scene: Scene) -> float:
    """Weight of a unit of rest length [N/m]."""
    return scene.filament.density * scene.load.gravity * undeformed_area(scene)


def _slip_speed(scene: Scene, body: Body) -> float:
    """Speed below which friction grows with the sliding [m/s]: a share of the belt's, an end's or the sag's speed."""
    motion, rows = forecast(scene), ((0.0, 0.0), *scene.ends.motion)
    moved = [abs(b[1] - a[1]) / (b[0] - a[0]) for a, b in pairwise(rows) if b[0] > a[0]]
    fastest = max([abs(body.speed_along), motion.speed * min(1.0, 8 / 3 * motion.sag), *moved])
    return _SLOW * fastest or math.sqrt(gravity_of(scene) * _LEAST * scene.filament.thickness)


def _values(scene: Scene) -> dict[str, float]:
    """Numbers of the densities, by the names of a run."""
    found: dict[str, float] = {}
    for body in bodies_of(scene):
        numbers = {key: getattr(body, key) for key in (*body.sizes, "friction")}
        numbers |= {"penetration": penetration_of(scene, body), "bond": _bond_of(scene, body)}
        numbers |= {"slip": _slip_speed(scene, body), "speed": body.speed_along}
        found |= {body_number(body.table_name, key): float(value) for key, value in numbers.items()}
    return found


def _adapt(scene: Scene, terms: Terms) -> Terms:
    """What depends on velocities acts where they are known, by inertia or a viscous stress."""
    known = terms.inertia or terms.resists
    touches = (
        Touch(one.table_name, one.bond != "none", one.friction > 0, one.speed_along != 0, known)
        for one in bodies_of(scene)
    )
    return replace(terms, touches=tuple(touches))


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    sag, room = motion.sag * scene.filament.span, min((body.room() for body in bodies_of(scene)), default=math.inf)
    if scene.ends.motion:
        # No deeper than two straight halves between the supports where they are nearest.
        sag = max(sag, math.sqrt(max(0.0, rest_length(scene) ** 2 - nearest(scene) ** 2)) / 2)
    # A body that is reached holds what falls on it, however little that is in the estimate.
    meaning = "whether the free sag reaches a body"
    return Estimate(float(sag > room), meaning, "1 if sag > depth", without=sag / room if room else None)


def _indispensable(scene: Scene) -> str:
    lies = [body.table_name for body in bodies_of(scene) if body.room() == 0]
    return f"the filament lies on [{lies[0]}] from the beginning" if lies else ""


def _warnings(scene: Scene, motion: Motion) -> list[str]:
    """Distances are those of the undeformed thickness."""
    room = max((body.room() for body in bodies_of(scene)), default=0.0)
    thinner = scene.filament.thickness / 2 * (1 - 1 / math.sqrt(1 + motion.strain))
    if not room or motion.sag * scene.filament.span < room or thinner < scene.run.accuracy * room:
        return []
    return [
        f"contact is that of the undeformed thickness: a strain of {motion.strain:.2g} thins the filament so that its "
        f"underside is {length_text(thinner)} higher"
    ]


def _observe(scene: Scene, fields: Fields) -> Observed:
    """Pressure at the nodes, length and force of the contact, and how deep the filament has sunk in."""
    x, y, time, nodes = (fields[name] for name in ("x", "y", "time", "X_node"))
    bodies, thickness, sag = bodies_of(scene), scene.filament.thickness, float(np.max(np.abs(y - y[:1])))
    stated = np.array([penetration_of(scene, body) for body in bodies])
    gaps = np.array([body.clearance(body, x, y, thickness, np.sqrt) for body in bodies])
    sunk = np.array([overlap(gap, penetration)[1] for gap, penetration in zip(gaps, stated, strict=True)])
    shares = sunk / stated[:, None, None]
    pressure, lengths = _weight(scene) * shares.sum(axis=0), _lengths_beyond(nodes, shares.max(axis=0) - 0.5)
    force, blur = np.trapezoid(pressure, nodes, axis=1), _blur(scene, time, float(stated.min()))
    found = {
        "contact_pressure": pressure,
        "contact_length": lengths,
        "contact_length_blur": blur,
        "contact_force": force,
        "penetration_max": sunk.max(axis=(0, 2)),
    }
    summary = {
        "touches_at_s": _first_time(time, -gaps.min(axis=(0, 2))),
        "contact_length_m": float(lengths[-1]),
        "contact_length_blur_m": float(blur[-1]),
        "contact_force_N": float(force[-1]),
        "penetration_max_m": float(sunk.max()),
        "penetration_stated_m": float(stated.min()),
    }
    doubts = [
        f"it sinks {length_text(deepest)} into [{body.table_name}], {deepest / penetration:.3g} times the stated "
        f"penetration of {length_text(penetration)}"
        for body, deepest, penetration in zip(bodies, sunk.max(axis=(1, 2)), stated, strict=True)
        if deepest > max(MAX_PENETRATION * penetration, scene.run.accuracy * min(thickness, sag))
    ]
    return Observed(found, summary, "; ".join(doubts))


def _lengths_beyond(nodes: Floats, values: Floats) -> Floats:
    """Length on which functions of the nodes, linear between them, are positive; shape (frames,)."""
    above, below = np.maximum(values[:, :-1], values[:, 1:]), np.minimum(values[:, :-1], values[:, 1:])
    share = np.clip(above / np.where(above > below, above - below, 1.0), 0.0, 1.0)
    return np.asarray(np.where(below >= 0, 1.0, share) @ np.diff(nodes))


def _first_time(time: Floats, depths: Floats) -> float | None:
    """When something first touches [s], linear between frames; None if it never does."""
    reached = np.flatnonzero(depths >= 0)
    if not len(reached):
        return None
    around = slice(max(0, int(reached[0]) - 1), int(reached[0]) + 1)
    return float(np.interp(0.0, depths[around], time[around]))


def _blur(scene: Scene, time: Floats, penetration: float) -> Floats:
    """Length l over which a line of contact is blurred [m]; of a fluid with eta/t in the place of the modulus."""
    modulus = instant_modulus(scene)
    stiffness = (
        np.full(len(time), modulus)
        if modulus
        else (effective_viscosity(scene) or 0.0) / np.maximum(time, time[1] if len(time) > 1 else 1.0)
    )
    second_moment = section_of(scene).gyration * undeformed_area(scene) * scene.filament.thickness**2
    return (4 * stiffness * second_moment * penetration / _weight(scene)) ** 0.25


CONTACT = Effect(
    name="contact",
    summary="a floor or pillars hold up what lies on them",
    source="Winkler 1867; Hunt & Crossley 1975",
    adapt=_adapt,
    applies=lambda scene: bool(bodies_of(scene)) and scene.model == "filament",
    without_it="the scene has neither [floor] nor [pillars]",
    estimate=_estimate,
    observable="whether the midpoint has sunk below the first body",
    example="ink-over-a-layer",
    derivation="24_contact",
    in_paper=False,
    indispensable=_indispensable,
    warnings=_warnings,
    values=_values,
    observe=_observe,
)
