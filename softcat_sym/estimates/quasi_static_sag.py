"""Quasi-static sag of a filament: beam and cable together, elastic and flowing (THEORY 5-7, 11)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from softcat_sym.estimates import scaling as scales
from softcat_sym.scene.scene import Scene, distance, groups_of, is_held, stress_free_length, undeformed_area

Floats = npt.NDArray[np.float64]

_MAX_TIMES = 201
_CANTILEVER_SAG = 0.5  # Sag of the middle of a filament that hangs straight down
_SHALLOW, _DEEP, _POINTS = 1e-7, 10.0, 120


@dataclass(frozen=True, slots=True)
class SagHistory:
    """Sag over span at output times."""

    time: Floats  # shape (n,); [s]
    sag: Floats  # shape (n,); Depth below the line between the supports


def smooth_step(share: Floats) -> Floats:
    """The quintic ramp of gravity at a share of its duration."""
    s = np.clip(share, 0.0, 1.0)
    return np.asarray(s**3 * (10 - 15 * s + 6 * s * s))


def load_factor(scene: Scene) -> float:
    """Sag with point masses over that without: a mass counts twice at midspan, (L^3/3)/(L^3/8) times at a free end."""
    weight, load = scales.weight_stress(scene) * undeformed_area(scene), scene.load
    return 1 + (2 * load.point_mass + 8 / 3 * load.tip_mass) * load.gravity / weight if weight > 0 else 1.0


def slackness(scene: Scene) -> float:
    """Stress-free length over the distance of the ends, minus one: negative if the filament starts stretched."""
    if not is_held(scene):
        return 0.0
    strains = scene.initial.P or (0.0,)
    return stress_free_length(scene) * math.exp(sum(strains) / len(strains)) / distance(scene) - 1


def quasi_static_history(scene: Scene) -> SagHistory:
    """Sag at the output times, with the scene's ramp of gravity."""
    run, ramp = scene.run, scene.load.ramp
    time = np.linspace(0.0, run.duration, min(run.frames, _MAX_TIMES))
    share = smooth_step(time / ramp) if ramp > 0 else np.ones_like(time)
    if scene.material.histories():
        sag = np.interp(time, *followed_sag(scene))
    else:
        sag = np.empty_like(time)
        for level in set(share.tolist()):
            sag[share == level] = _sag(scene, time[share == level], level)
    return SagHistory(time, np.minimum(sag, _CANTILEVER_SAG) if not is_held(scene) else sag)


_LOOKS = 40
"""Number of time steps for a material that changes."""


def followed_sag(scene: Scene) -> tuple[Floats, Floats]:
    """Times and sags of a material that may change: the constants at a time decide the rate of the sag at that time.

    New springs do not lift the filament, so that its elastic sag is that of the smallest modulus up to that time.
    """
    looks, ramp = np.linspace(0.0, scene.run.duration, _LOOKS + 1), scene.load.ramp
    share = smooth_step(looks / ramp) if ramp > 0 else np.ones_like(looks)
    elastic = flown = 0.0
    sags = [start_sag(scene)]
    for frame, (before, now) in enumerate(pairwise(looks.tolist()), start=1):
        stage, elapsed = scene.at((before + now) / 2), now - before
        weight = scales.weight_stress(stage) * load_factor(stage) * float(share[frame])
        if weight > 0 and stage.material.spec.is_solid:
            lasting = elastic_sag_under(stage, weight, scales.static_modulus(stage))
            reached = -math.expm1(-elapsed / retardation(stage)) if retardation(stage) else 1.0
            elastic += max(0.0, lasting - elastic) * reached
        elif weight > 0:
            elastic = max(elastic, elastic_sag_under(stage, weight, scales.instant_modulus(stage)))
            flown += float(flow_sag(stage, weight, elastic + flown, np.array(elapsed)))
        sags.append(max(elastic + flown, sags[0]))
    if scene.load.ramp == 0 and not (scene.material.spec.is_solid and retardation(scene)):
        sags[0] = max(sags[0], float(_sag(scene, np.zeros(()), 1.0)))
    return looks, np.array(sags)


def _sag(scene: Scene, time: Floats, share: float) -> Floats:
    weight = scales.weight_stress(scene) * load_factor(scene) * share
    if weight == 0:
        return np.full_like(time, start_sag(scene))
    elapsed = np.maximum(0.0, time - scene.load.ramp / 2)
    at_once = elastic_sag_under(scene, weight, scales.instant_modulus(scene))
    if scene.material.spec.is_solid:
        lasting = elastic_sag_under(scene, weight, scales.static_modulus(scene))
        if not retardation(scene):
            return np.full_like(time, lasting)
        first = at_once if scene.material.spec.flows else 0.0
        return lasting + (first - lasting) * np.exp(-elapsed / retardation(scene))
    return at_once + flow_sag(scene, weight, at_once, elapsed)


def retardation(scene: Scene) -> float:
    """Retardation time of a solid [s]: eta/E; for a standard linear solid eta (1/E + 1/E_2)."""
    material = scene.material
    if material.viscosity is None or material.youngs_modulus is None or not scene.material.spec.is_solid:
        return 0.0
    compliance = 1 / material.youngs_modulus + (1 / material.second_modulus if material.second_modulus else 0.0)
    return material.viscosity * scales.hot_viscosity_factor(scene) * compliance


def solvent_lag(scene: Scene) -> float:
    """Retardation time of polymer chains by their solvent [s]: its viscosity over their modulus."""
    material = scene.material
    return (material.solvent_viscosity or 0.0) / material.youngs_modulus if material.youngs_modulus else 0.0


def start_sag(scene: Scene) -> float:
    """Sag of a slack filament without stretch: arc length 1 + (8/3) H^2."""
    return math.sqrt(3 / 8 * max(0.0, slackness(scene)))


def elastic_sag_under(scene: Scene, weight: float, modulus: float | None, *, taut: bool = True) -> float:
    """Static elastic sag under a weight rho g L [Pa]; a filament that starts slack or stretched is a cable.

    Without `taut` it is the sag of the beam alone.
    """
    if modulus is None:
        return start_sag(scene)
    stiff, slack = modulus / weight, slackness(scene)
    beam = 1 / (scales.bending_stiffness(scene) * stiff)
    if not is_held(scene) or not taut:
        return beam
    cable = cable_sag(3 / (64 * stiff), 3 / 8 * slack)
    return cable if slack > 0 else scales.smaller_of(beam, cable)


def cable_sag(load: float, slack: float) -> float:
    """Largest root H of H^3 - slack H = load: strain (8/3)(H^2 - slack) under a tension proportional to 1/H."""
    height = float(max(load ** (1 / 3), math.sqrt(max(0.0, slack)) + load, 1e-300))
    if slack < 0:
        height = min(height, load / -slack)
    for _ in range(50):
        step = (height**3 - slack * height - load) / (3 * height**2 - slack)
        height -= step
        if abs(step) < 1e-9 * height:
            break
    return height


def flow_sag(scene: Scene, weight: float, first: float, time: Floats) -> Floats:
    """Sag that flow adds to a first one after times [s], as a viscous beam and string, until a yield stress ends it."""
    gravity_number = scales.gravity_number_of(scene)
    if (
        gravity_number is not None
        and gravity_number < scales.first_yield_gravity_number(scene)
        and start_sag(scene) == 0
    ):
        return np.zeros_like(time)
    first = max(first, _SHALLOW)
    sag, reached = _flow_table(scene, weight, first)
    flown = np.interp(time, reached, sag) - first
    # A beam with an elastic core is held by the core, however fast the rest flows.
    held = gravity_number is not None and not scales.yields_throughout(scene)
    return np.minimum(flown, first) if held else flown


@lru_cache(maxsize=64)
def _flow_table(scene: Scene, weight: float, first: float) -> tuple[Floats, Floats]:
    """Sags from the first one on, and the times [s] at which flow reaches them."""
    sag = np.geomspace(first, max(_DEEP, 2 * first), _POINTS)
    beam = weight / scales.bending_stiffness(scene) / _viscosity(scene, weight / (2 * groups_of(scene).delta))
    held = is_held(scene)  # Else it flows as a beam alone
    speed = np.array([_flow_speed(scene, weight, float(height), beam) if held else beam for height in sag])
    moving = np.minimum.accumulate(speed > 0)
    slowness = np.where(moving, 1 / np.where(moving, speed, 1.0), 0.0)
    time = np.concatenate([[0.0], np.cumsum((slowness[1:] + slowness[:-1]) / 2 * np.diff(sag))])
    reached = np.count_nonzero(moving)
    return (sag[:reached], time[:reached]) if reached else (sag[:1], time[:1])


def _flow_speed(scene: Scene, weight: float, sag: float, beam: float) -> float:
    """Rate of the sag over span [1/s] by flow alone: about the slower of beam and string."""
    taut = weight * (sag + 1 / (8 * sag))
    string = taut / _viscosity(scene, taut) * (1 + 8 / 3 * sag**2) / (16 / 3 * sag)
    return scales.smaller_of(beam, string)


def _viscosity(scene: Scene, stress: float) -> float:
    """Stress over flow rate [Pa s]; infinite below the yield stress."""
    beyond = stress - (scales.yield_stress_of(scene) or 0.0)
    viscosity = scales.effective_viscosity_at(scene, beyond) if beyond > 0 else None
    return viscosity * stress / beyond if viscosity else math.inf
