"""Shear: the section rotates independently of the centreline, and is sheared (Reissner's kinematics)."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, OfMotion, let_down, of_large_deflections
from softcat_sym.errors import Fault
from softcat_sym.estimates.scaling import flow_nonlinearity, section_of
from softcat_sym.scene.dimensions import needs_section_angles
from softcat_sym.scene.scene import Scene, distance, is_held, stress_free_length
from softcat_sym.scene.tables import farthest


def elastic_stretch(scene: Scene) -> float:
    """Elastic stretch that the supports impose at the start, and for a solid at any time."""
    apart = farthest(scene) if scene.material.spec.is_solid and scene.ends.motion else distance(scene)
    return apart / stress_free_length(scene) if is_held(scene) else 1.0


def stays_straight(scene: Scene) -> bool:
    """Whether a stretched section is stable perpendicular to the centreline: log s (1 - kappa_s/2) < kappa_s mu/E.

    A section rotated by phi at a fixed stretch gains the energy kappa_s mu phi^2/2 in shear and loses
    E log(s) (1 - kappa_s/2) phi^2/2 in stretching, since a shear gam lengthens its fibres by gam^2/4: beyond that
    stretch it rotates spontaneously, unlike any material.
    """
    return elastic_stretch(scene) < _limit(scene)


def _limit(scene: Scene) -> float:
    correction = section_of(scene).shear_correction
    return math.exp(correction / (2 * (1 + scene.material.poisson)) / (1 - correction / 2))


def _applies(scene: Scene) -> bool:
    turns = needs_section_angles(scene) or stays_straight(scene)
    return of_large_deflections(scene) and bool(turns) and not scene.material.spec.has_chains


def _faults(scene: Scene) -> list[Fault]:
    """Refuse a filament with unstable sections where shear is indispensable."""
    if stays_straight(scene) or not needs_section_angles(scene):
        return []
    at_start = distance(scene) / stress_free_length(scene) >= _limit(scene)
    given = "initial.stretch" if scene.filament.rest_length is None else "filament.rest_length"
    found = (
        f"stretched elastically {elastic_stretch(scene):.4g} times, at which sections rotate spontaneously "
        f"({needs_section_angles(scene)})"
    )
    return [Fault(given if at_start else "ends.motion", found, f"less than {_limit(scene):.4g} times")]


def _eases(scene: Scene) -> str:
    if scene.material.spec.has_closed_means or flow_nonlinearity(scene, math.inf) == 0:
        return ""
    return "included because its flow rule runs faster with it"


SHEAR = Effect(
    name="shear",
    summary="shear strain of the section, shear stress in its flow",
    source="Reissner 1972; 3.5-3.7",
    contribute=partial(replace, shear=True),
    applies=_applies,
    without_it=(
        "the filament is stretched elastically beyond log s = kappa_s mu/(E (1 - kappa_s/2)), its law is one of "
        f"polymer chains, which stretch only along and across the fibres, or {SMALL_MODEL}"
    ),
    estimate=OfMotion(
        "sheared",
        "share of the sag by shear",
        "of Timoshenko's beam, bent ends and hinges",
        amplified=True,
        without=let_down,
    ),
    observable="transverse force times shear compliance, and the share of Timoshenko at the largest sag",
    example="arrested-overdamped",
    derivation="09_shearing_filament",
    causes=("shear",),
    needs=("bending", "finite-stretch", "thinning", "large-rotation"),
    in_paper=False,
    eases=_eases,
    indispensable=needs_section_angles,
    faults=_faults,
)
