"""How a filament has moved: the numbers from which the size of every effect that was left out follows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from softcat_sym.effects import Effects
from softcat_sym.effects.forecast import flowing_overstress, forecast, missed_by, tension_share
from softcat_sym.effects.motion import Motion
from softcat_sym.effects.natural_frequency import solid_decay
from softcat_sym.effects.prediction import (
    effective_viscosity_at,
    pull_of_surface,
    surface_stress,
    weight_stress,
    yield_stress_of,
)
from softcat_sym.effects.quasi_static import load_factor, retardation
from softcat_sym.effects.ringing import ringing
from softcat_sym.effects.shearing import compliant_sag, lagging, sheared_share
from softcat_sym.equations.surface import SURFACES
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, is_held, is_slack, undeformed_area

_LEAST = 1e-12
"""Sag over span below which nothing has moved."""


def seen(
    scene: Scene, effects: Effects, time: Floats, places: tuple[Floats, Floats], fields: Mapping[str, Floats]
) -> Motion:
    """Describe the motion of a finished run; what it cannot show, because its effect was left out, is as foreseen.

    Parameters
    ----------
    scene : Scene
        What was asked.
    effects : Effects
        What was in force.
    time : ndarray, shape (frames,)
        [s].
    places : pair of ndarray
        Material coordinates [m] of nodes and cells.
    fields : mapping of str to ndarray
        (frames, nodes), (frames, cells): ``x``, ``y``, ``stretch``, ``shear_force``, ``stress_mean``,
        ``stress_bending``, ``yielded_fraction``, ``tension``.
    """
    span, length = scene.filament.span, np.diff(places[0])
    midpoint, chord = _midpoint(scene, fields)
    depth = np.abs(midpoint - chord) / span
    sag = max(float(np.max(depth)), _LEAST)
    strain = float(np.max(np.abs((fields["stretch"] - 1) @ length))) / float(np.sum(length))
    shared = tension_share(scene, sag)
    shown = replace(
        forecast(scene),
        sag=sag,
        scale=max(float(np.max(np.abs(midpoint))) / span, _LEAST),
        strain=strain,
        slope=_slope(fields),
        tension_share=shared,
        swings=_swings(midpoint),
        relaxed=max(forecast(scene).relaxed, _relaxed(effects, fields)),
        overstress=_overstress(scene, fields),
        flowing_overstress=flowing_overstress(scene, sag),
        sheared=max(sheared_share(scene, sag, shared), _compliance(scene, effects, time, fields, length) / sag),
        folds=_folds(scene, strain, time, fields),
        capillary=_capillary(scene, depth, fields, length),
    )
    return _what_was_left_out(scene, effects, time, midpoint, shown)


def _what_was_left_out(scene: Scene, effects: Effects, time: Floats, midpoint: Floats, shown: Motion) -> Motion:
    """The numbers that only a run without the effect shows."""
    names = effects.names
    if "inertia" not in names:
        shown = replace(shown, missed=missed_by(scene, time, midpoint))
    if "viscous-flow" not in names and np.isfinite(shown.overstress):
        # Below the yield stress nothing flows, whatever was foreseen.
        shown = replace(shown, relaxed=1 - 1 / max(1.0, shown.overstress))
    if "viscous-stress" not in names and retardation(scene):
        shown = replace(shown, retarded=max(shown.retarded, _lost(scene, shown.swings, ringing(scene).decay)))
    if "solid-damping" not in names and scene.material.has_loss:
        shown = replace(shown, damped=max(shown.damped, _lost(scene, shown.swings, solid_decay(scene))))
    if "gravity-ramp" not in names and scene.load.ramp > 0:
        moved = np.abs(midpoint - midpoint[0] * is_slack(scene))
        risen = float(np.interp(scene.load.ramp, time, moved)) / max(float(np.max(moved)), _LEAST)
        shown = replace(shown, risen=risen)
    return shown


def _lost(scene: Scene, swings: float, decay: float) -> float:
    """What a decay [1/s] would have taken from the swings that a run without it shows."""
    swing = swings / max(1.0, ringing(scene, lossless=True).frequency * scene.run.duration)
    return float(-swing * np.expm1(-decay * scene.run.duration))


def _midpoint(scene: Scene, fields: Mapping[str, Floats]) -> tuple[Floats, Floats]:
    """Height of the midpoint, and of the middle of the line between the ends [m]; with a free one, of the support."""
    y = fields["y"]
    line = (y[:, 0] + y[:, -1]) / 2 if is_held(scene) else np.zeros(len(y))
    return y[:, y.shape[1] // 2], line


def _slope(fields: Mapping[str, Floats]) -> float:
    """Largest angle of any cell against the horizontal [rad]."""
    rise, run = np.diff(fields["y"], axis=1), np.diff(fields["x"], axis=1)
    return float(np.max(np.abs(np.arctan2(rise, run))))


def _swings(midpoint: Floats) -> float:
    """Phase times amplitude of the ringing, over the largest sag: it travels four amplitudes in 2 pi."""
    largest = float(np.max(np.abs(midpoint)))
    if largest == 0:
        return 0.0
    travelled = float(np.sum(np.abs(np.diff(midpoint)))) - abs(float(midpoint[-1] - midpoint[0]))
    return np.pi / 2 * max(0.0, travelled) / largest


def _relaxed(effects: Effects, fields: Mapping[str, Floats]) -> float:
    """What flow has dissipated, of that and the most that was stored; unknown where a solid dissipates too."""
    if "solid-damping" in effects.names:
        return 0.0
    lost, stored = float(fields["energy_dissipated"][-1]), float(np.max(fields["energy_elastic"]))
    return lost / (lost + stored) if lost > 0 else 0.0


def _compliance(scene: Scene, effects: Effects, time: Floats, fields: Mapping[str, Floats], length: Floats) -> float:
    """Sag over span by shear that follows the transverse force, behind a viscous stress with its retardation time."""
    lag = retardation(scene) if "viscous-stress" in effects.names else 0.0
    return compliant_sag(scene, lagging(time, fields["shear_force"], lag), length)


def _overstress(scene: Scene, fields: Mapping[str, Floats]) -> float:
    limit = yield_stress_of(scene)
    if limit is None or "stress_mean" not in fields:
        return np.inf
    return float(np.max(np.abs(fields["stress_mean"]) + np.abs(fields["stress_bending"]))) / limit


def _capillary(scene: Scene, depth: Floats, fields: Mapping[str, Floats], length: Floats) -> float:
    """Largest share of the pull of the surface in the axial force, times the share of the load carried by that."""
    load, pull = weight_stress(scene) * load_factor(scene), surface_stress(scene)
    if pull == 0 or load == 0 or not is_held(scene):
        return forecast(scene).capillary
    shrinks = SURFACES[scene.filament.section].shrinks
    surface = pull * (1 / np.sqrt(fields["stretch"]) if shrinks else np.ones_like(fields["stretch"]))
    taut = np.maximum(fields["tension"], 0.0) / undeformed_area(scene)
    pulled, tension = (values @ length / np.sum(length) for values in (surface, taut))
    carried = np.minimum(1.0, 8 * (pulled + tension) * depth / load)
    return float(np.max(pulled / (pulled + tension) * carried))


def _folds(scene: Scene, strain: float, time: Floats, fields: Mapping[str, Floats]) -> float:
    """E-folds of an unevenness: the strain, and beyond a yield stress sigma/eta for as long as a section flows."""
    limit = yield_stress_of(scene)
    viscosity = effective_viscosity_at(scene, limit) if limit is not None else None
    if not viscosity or "stress_mean" not in fields or len(time) < 2:
        return strain
    stress = np.maximum(fields["stress_mean"] + pull_of_surface(scene) / 2, 0.0)
    rate = stress * fields["yielded_fraction"] / viscosity
    grown = np.trapezoid(rate, time, axis=0)
    return max(strain, float(np.max(grown)))
