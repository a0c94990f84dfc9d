"""Drag: the surrounding fluid resists the motion of a slender body, or, with a density, of a cylinder in cross-flow.

The second law contains the first as its limit, so that no speed is needed beforehand, and a fit can pass between them.
"""

from __future__ import annotations

import math
from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import weight_stress
from softcat_sym.scene.scene import Scene, rest_length, undeformed_area

_FASTEST = 2e5
"""Largest Reynolds number of White's law."""


def reynolds_number(scene: Scene, motion: Motion) -> float:
    """Re = rho_b d U/mu_b at the largest speed of the midpoint."""
    bath = scene.surroundings
    return bath.density * _diameter(scene) * motion.speed / bath.viscosity


def _diameter(scene: Scene) -> float:
    return (scene.filament.thickness + scene.filament.width) / 2


def _applies(scene: Scene) -> bool:
    return scene.filament.section != "sheet" and scene.surroundings.viscosity > 0


def resistance(scene: Scene, speed: float) -> float:
    """Force per length across the filament at a speed [N/m]."""
    bath, d = scene.surroundings, _diameter(scene)
    slender = 4 * math.pi * bath.viscosity / (math.log(4 * rest_length(scene) / d) - 0.5)
    if bath.density == 0 or speed == 0:
        return slender * speed
    slow = slender**3 / (125 * bath.density * d * bath.viscosity**2)
    viscous = 10 * (bath.viscosity / (bath.density * d)) ** (2 / 3) * speed * (speed**2 + slow**2) ** (1 / 6)
    return float(bath.density * d / 2 * (speed**2 + viscous))


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    weight = weight_stress(scene) * undeformed_area(scene) / scene.filament.span
    taken = resistance(scene, motion.speed) / weight if weight > 0 else 1.0
    # An oscillation with that speed decays at the rate zeta/(2 m).
    mass = scene.filament.density * undeformed_area(scene)
    decay = resistance(scene, motion.speed) / motion.speed / (2 * mass) if motion.speed > 0 else 0.0
    lost = motion.swings * -math.expm1(-decay * scene.run.duration)
    # It changes the sag only during the fall.
    fall = motion.sag * scene.filament.span / motion.speed if motion.speed > 0 else 0.0
    falling = min(1.0, fall / scene.run.duration)
    law = "a cylinder in cross-flow (White)" if scene.surroundings.density > 0 else "a slender body (Cox)"
    meaning = f"drag of {law} over the weight, or ringing that it damps"
    return Estimate(
        min(1.0, max(taken * falling, lost)), meaning, "zeta U/q, or swings (1 - exp(-zeta T/(2 m)))", late=True
    )


def _warnings(scene: Scene, motion: Motion) -> list[str]:
    if not _applies(scene) or (number := reynolds_number(scene, motion)) < _FASTEST:
        return []
    return [f"the drag is that of cross-flow up to Reynolds numbers of 2e5, but the largest is {number:.2g}"]


DRAG = Effect(
    name="drag",
    summary="resistance of a slender body; in a bath with a density, of a cylinder in cross-flow",
    source="Cox 1970; White 1991",
    adapt=lambda scene, terms: replace(terms, drag="cross-flow" if scene.surroundings.density > 0 else "slender"),
    applies=_applies,
    without_it="surroundings.viscosity is zero, or the section is a sheet, for which there is no slow flow",
    estimate=_estimate,
    observable="resistance at the largest speed of the midpoint, over the weight; ringing that it would have damped",
    example="embedded-strand",
    derivation="17_surroundings",
    in_paper=False,
    warnings=_warnings,
    causes=("bath",),
)
