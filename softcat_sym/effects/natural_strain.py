"""Natural strain: the stress-free strain changes as a material dries, cures or cools; if unevenly, the filament curls.

It is the same along and across the filament, so that the section shrinks, too; the mass is constant.
"""

from __future__ import annotations

import math
from dataclasses import replace

from softcat_sym.effects.effect import Effect, Estimate
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import instant_modulus, weight_stress
from softcat_sym.physics.terms import Course
from softcat_sym.scene.history import extremes_of
from softcat_sym.scene.scene import Scene, groups_of, is_held


def largest_strains(scene: Scene) -> tuple[float, float]:
    """Largest magnitude of the mean natural strain and of its difference over the thickness, during the run."""
    material, duration = scene.material, scene.run.duration
    mean, more = (
        max(map(abs, extremes_of(strain, duration)))
        for strain in (material.natural_strain, material.natural_strain_difference)
    )
    return mean, more


def shrinking(scene: Scene, motion: Motion, strain: float) -> float:
    """Relative change of the sag by a mean natural strain."""
    if strain == 0 or not is_held(scene):
        return strain
    # The tension E n of a shrinking cable over the tension that carries the load, rho g L/(8 H).
    weight, modulus = weight_stress(scene), instant_modulus(scene) or 0.0
    tightened = 8 * modulus * strain * motion.sag / weight if weight > 0 else math.inf
    return tightened / (1 + tightened) if tightened < math.inf else 1.0


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    mean, more = largest_strains(scene)
    meaning = "relative change of the sag by shrinking or curling"
    # Its curvature n/h bends a filament with a pinned or free end by n L^2/(8 h) or more; two clamps prevent that.
    turns = not all(support.holds_angle for support in scene.ends.supports)
    curled = more / groups_of(scene).delta / (8 if is_held(scene) else 2) * turns
    value = max(shrinking(scene, motion, mean), curled / motion.scale)
    return Estimate(min(1.0, value), meaning, "C/(1 + C), C = 8 E n f/(q L/A), or n L/(8 h)")


NATURAL_STRAIN = Effect(
    name="natural-strain",
    summary="stress-free strain of the material that changes in time, more at the top or at the bottom",
    source="Timoshenko 1925",
    adapt=lambda scene, terms: replace(
        terms, natural_strain=tuple(Course.of(*one) for one in scene.material.natural_strains().items())
    ),
    applies=lambda scene: bool(scene.material.natural_strains()),
    without_it="the scene states no material.natural_strain",
    estimate=_estimate,
    observable="tension by the natural strain over that by the weight at the sag, or curl of a free filament",
    example="solvent-cast-strand",
    derivation="21_curing",
    in_paper=False,
)
