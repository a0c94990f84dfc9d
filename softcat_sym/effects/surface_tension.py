"""Surface tension: the surface energy exerts an axial force that shortens the filament."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, Estimate, held_up
from softcat_sym.errors import Fault
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import (
    instant_modulus,
    pull_of_surface,
    static_modulus,
    surface_stress,
    yield_stress_of,
)
from softcat_sym.scene.scene import Scene

_UNSTABLE = 2.0
"""Gam over E above which the axial force decreases with stretch, dQ/ds = A_0 (E - Gam/2), and the filament forms beads
(gamma > 6 mu R for a circle, Mora et al. 2010)."""

_SQUARE = 0.1
"""Relative difference of the sides of a rectangle above which surface tension would round it."""


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    starts = "it acts at once" if scene.initial.surface == "fresh" else "it acted before t = 0"
    meaning = f"reduction of the sag by the pull of the surface, C/(1+C), C = m 4 P gamma f/(q L^2) ({starts})"
    return Estimate(motion.amplified(motion.capillary), meaning, without=held_up(motion.capillary))


def unstable_faults(scene: Scene) -> list[Fault]:
    """Refuse a surface tension at which an elastic filament of this thickness is unstable as a cylinder."""
    modulus, pull = static_modulus(scene), surface_stress(scene)
    # A filament that has shortened under its surface is thicker, and stable: dQ/ds = A_0 E (1 - log(s)/2)/s^2 at Q = 0.
    stable = scene.filament.section == "sheet" or scene.initial.surface == "relaxed"
    if modulus is None or not scene.material.spec.is_solid or stable or pull <= _UNSTABLE * modulus:
        return []
    most = scene.surroundings.surface_tension * _UNSTABLE * modulus / pull
    found = f"{scene.surroundings.surface_tension:.3g} N/m, at which the filament forms beads"
    return [Fault("surroundings.surface_tension", found, f"at most {most:.3g} N/m for this modulus and thickness")]


def _warnings(scene: Scene, motion: Motion) -> list[str]:
    """Surface tension that is left out although it matters, or that would round a rectangle."""
    filament, pull, share, found = scene.filament, pull_of_surface(scene), motion.capillary, list[str]()
    if not pull and share > scene.run.accuracy:
        key = "run.closure = 'printed'" if scene.run.closure == "printed" else "run.effects"
        found.append(f"surface tension is left out by {key}, but would take about {share:.0%} of the sag")
    uneven = filament.section == "rectangle" and abs(filament.width / filament.thickness - 1) > _SQUARE
    if uneven and pull > (yield_stress_of(scene) or instant_modulus(scene) or 0.0):
        found.append(
            f"surface tension ({pull:.3g} Pa) would round the rectangle, whose sides are assumed to shrink alike; use "
            "section = 'circle' if it does"
        )
    return found


SURFACE_TENSION = Effect(
    name="surface-tension",
    summary="axial force gamma P_0/2 s^-1/2 (for a sheet 2 gamma D_0), and that of the outline's slope",
    source="Eggers & Dupont 1994",
    contribute=partial(replace, surface_tension=True),
    applies=lambda scene: scene.surroundings.surface_tension > 0,
    without_it="the scene states no surface tension",
    estimate=_estimate,
    observable="share of the pull of the surface in the axial force, times that of the load carried in tension",
    example="ink-bridge",
    derivation="18_surface_tension",
    warnings=_warnings,
    causes=("surface",),
    needs=("extensibility",),
    in_paper=False,
    indispensable=lambda scene: "initial.surface is 'relaxed'" if scene.initial.surface == "relaxed" else "",
    faults=unstable_faults,
)
