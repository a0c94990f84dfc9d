"""How a filament is going to move, from its groups alone: the motion that the estimates of all effects start from."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np

from softcat_sym.effects.law import is_solid
from softcat_sym.effects.missed_inertia import missed_from_rest, missed_inertia
from softcat_sym.effects.motion import Motion
from softcat_sym.effects.natural_frequency import solid_decay, solid_retardation
from softcat_sym.effects.necks import neck_folds
from softcat_sym.effects.prediction import (
    beam_share_of_surface,
    bending_stiffness,
    duration_star,
    effective_viscosity_at,
    first_yield_gravity_number,
    gravity_number_of,
    instant_modulus,
    pull_of_surface,
    static_modulus,
    surface_stress,
    weight_stress,
    yield_stress_of,
)
from softcat_sym.effects.quasi_static import (
    Floats,
    History,
    elastic_sag_under,
    load_factor,
    quasi_static_history,
    retardation,
    slackness,
    start_sag,
)
from softcat_sym.effects.resonance import shaken_peak, shaken_phase, shaken_share
from softcat_sym.effects.ringing import Ringing, ringing
from softcat_sym.effects.shearing import sheared_share
from softcat_sym.scene import Scene, distance, groups_of, is_held, is_slack
from softcat_sym.scene.support_path import farthest

_TIP_SLOPE = 64 / 17
"""Slope at the tip of a cantilever over the sag of its middle over the span, (1/6)/(17/384) of a linear beam."""

_KINKED = 0.1
"""Share of the sag that rings, from which on the load counts as sudden."""


def forecast(scene: Scene) -> Motion:
    """Foresee the motion of a scene: closed forms of beam, cable and string put together (THEORY 5-7, 11).

    Parameters
    ----------
    scene : Scene
        Any scene.
    """
    return _forecast(scene.without_numerics())


@lru_cache(maxsize=256)
def _forecast(scene: Scene) -> Motion:
    free, rings = quasi_static_history(scene), ringing(scene)
    history = free
    if pull_of_surface(scene):
        history = History(free.time, np.array([sag / (1 + _carried(scene, float(sag))) for sag in free.sag]))
    span, first = scene.filament.span, float(history.time[1])
    sag = max(float(np.max(history.sag)), _shaken_sag(scene), 1e-12)
    scale = max(sag, abs(sag + scene.ends.drop / span / 2))
    amplitude = min(1.0, rings.lasting(first) / scale)
    missed, overstress = missed_by(scene, history.time, history.sag * span), _overstress(scene, rings)
    # How fast the hinges of a slack filament give way from its first moment on is not foreseen, nor what a moving
    # support sets in motion.
    sudden = scene.ends.motion or (is_slack(scene) and 1 < overstress < math.inf)
    return Motion(
        sag=sag,
        scale=scale,
        strain=strain_of(scene, sag),
        slope=slope_of(scene, sag),
        tension_share=tension_share(scene, sag),
        swings=amplitude * rings.phase(scene.run.duration) + shaken_phase(scene),
        missed=1.0 if sudden else max(amplitude, missed * sag / scale, min(1.0, shaken_share(scene))),
        risen=_risen(scene, history, amplitude),
        relaxed=_relaxed(scene, rings),
        overstress=overstress,
        flowing_overstress=flowing_overstress(scene, sag),
        retarded=_retarded(scene, rings, amplitude),
        damped=_damped(scene, scale, first),
        sheared=sheared_share(scene, sag, tension_share(scene, sag)),
        folds=neck_folds(scene, strain_of(scene, sag)),
        capillary=_capillary(scene, float(np.max(free.sag))),
    )


def _carried(scene: Scene, sag: float) -> float:
    """C: weight that surface tension carries at a sag without it, over the rest of it; its share of the sag is C/(1+C).

    C = m 8 Gam f/(rho g L^2). Of a string m = 1/3 by its cubic law, of a beam 1; where the section yields 3 as long as
    the beam carries on (Haythornthwaite 1957), and 1 where the membrane does.
    """
    weight = weight_stress(scene) * load_factor(scene)
    if weight == 0 or not is_held(scene):
        return 0.0
    number = gravity_number_of(scene)
    if number is not None and number > first_yield_gravity_number(scene):
        power = 3.0 if sag < groups_of(scene).delta else 1.0
    else:
        power = 1 - 2 / 3 * tension_share(scene, sag)
    return power * 8 * surface_stress(scene) / weight * sag


def _capillary(scene: Scene, sag: float) -> float:
    """Share of the sag that surface tension takes; with a free end, what it shortens the filament by, five times."""
    if surface_stress(scene) == 0:
        return 0.0
    if not is_held(scene):
        return min(1.0, 5 * _shortened(scene, surface_stress(scene)))
    if weight_stress(scene) == 0:
        return 1.0
    carried = _carried(scene, sag)
    return carried / (1 + carried)


def _shortened(scene: Scene, pull: float) -> float:
    """Strain of a filament with a free end that its surface pulls together: elastic, and flowing beyond yield."""
    modulus, limit = instant_modulus(scene), yield_stress_of(scene) or 0.0
    viscosity = effective_viscosity_at(scene, pull - limit) if pull > limit else None
    flown = scene.run.duration * (pull - limit) / viscosity if viscosity else 0.0
    return min(1.0, (pull / modulus if modulus else 0.0) + flown)


def _shaken_sag(scene: Scene) -> float:
    """Largest elastic sag over span of a filament whose weight oscillates; 0 without shaking."""
    weight = weight_stress(scene) * load_factor(scene)
    if scene.load.shake == 0 or weight == 0:
        return 0.0
    return elastic_sag_under(scene, weight * shaken_peak(scene), static_modulus(scene))


def expected_sag(scene: Scene) -> float:
    """Largest sag over span in the run, no further than free fall goes."""
    return min(duration_star(scene) ** 2 / 2, forecast(scene).sag)


def expected_strain(scene: Scene) -> float:
    """Mean stretch minus one of a parabola of the expected sag: (8/3) (H/L)^2."""
    return 8 / 3 * expected_sag(scene) ** 2


def missed_by(scene: Scene, time: Floats, sag: Floats) -> float:
    """What a filament that is in balance at every instant misses; a slack one hangs in its weight from the start.

    Parameters
    ----------
    time, sag : ndarray, shape (n,)
        Output times [s] and balanced sag [m].
    """
    if is_slack(scene):
        return missed_from_rest(time, sag, scene.load.gravity)
    return missed_inertia(time, sag, scene.load.gravity, scene.load.ramp)


def strain_of(scene: Scene, sag: float) -> float:
    """Largest mean strain: (8/3) H^2 beyond the slack, what the supports impose, or the weight of a hanging end."""
    if not is_held(scene):
        modulus, pull = instant_modulus(scene), pull_of_surface(scene)
        shortened = _shortened(scene, pull) if pull else 0.0
        return (weight_stress(scene) / modulus if modulus else sag**2) + shortened
    imposed = farthest(scene) / distance(scene) - 1 + max(0.0, -slackness(scene), scene.initial.stretch - 1)
    return max(0.0, 8 / 3 * (sag**2 - start_sag(scene) ** 2)) + imposed


def slope_of(scene: Scene, sag: float) -> float:
    """Largest slope: of the parabola, of the line between the supports and of the clamps."""
    ends = scene.ends
    lowest = max(abs(ends.drop), *(abs(ends.drop - dy) for _, _, dy in ends.motion), 0.0)
    imposed = math.atan2(lowest, scene.filament.span)
    own = min(math.pi / 2, (4 if is_held(scene) else _TIP_SLOPE) * sag)
    return own + max(imposed, abs(ends.left_angle), abs(ends.right_angle))


def tension_share(scene: Scene, sag: float) -> float:
    """Share of the load carried in tension at a sag: (64/3) H^2 against the stiffness of the beam."""
    stiffness = bending_stiffness(scene)
    if not is_held(scene):
        return min(1.0, sag**2)
    taut = 8 * max(0.0, -slackness(scene), farthest(scene) / distance(scene) - 1)
    ratio = (64 / 3 * sag**2 + taut) / stiffness
    return ratio / (1 + ratio)


def flowing_overstress(scene: Scene, sag: float) -> float:
    """Mean stress of beam or catenary over the yield stress; infinite without one."""
    limit, delta = yield_stress_of(scene), groups_of(scene).delta
    if limit is None:
        return math.inf
    return weight_stress(scene) * min(sag + 1 / (8 * sag), 1 / (2 * delta)) / limit


def _risen(scene: Scene, history: History, amplitude: float) -> float:
    ramp = scene.load.ramp
    if ramp == 0:
        return 0.0
    reached = float(np.interp(ramp, history.time, history.sag)) / max(float(np.max(history.sag)), 1e-12)
    return min(1.0, reached + amplitude)


def _relaxed(scene: Scene, rings: Ringing) -> float:
    modulus, delta = instant_modulus(scene), groups_of(scene).delta
    if modulus is None:
        return 0.0
    stress = weight_stress(scene) / (2 * delta)
    viscosity = effective_viscosity_at(scene, stress or 1.0)
    if not viscosity:
        return 0.0 if viscosity is None else 1.0
    relaxation = viscosity / modulus
    if scene.material.modes:
        relaxation = min(mode.viscosity / mode.youngs_modulus for mode in scene.material.modes)
    if is_solid(scene):
        relaxation = retardation(scene)
    share = -math.expm1(-scene.run.duration / relaxation)
    over = _overstress(scene, rings)
    return share * (1 - 1 / max(1.0, over))


def _overstress(scene: Scene, rings: Ringing) -> float:
    """Largest elastic fibre stress over the yield stress."""
    limit, modulus = yield_stress_of(scene), instant_modulus(scene)
    if limit is None or modulus is None:
        return math.inf
    strained = largest_strain(scene, rings) / (1 + beam_share_of_surface(scene))
    squeezed = 0.0 if is_held(scene) else pull_of_surface(scene)
    return max(modulus * strained, squeezed) / limit


def largest_strain(scene: Scene, rings: Ringing) -> float:
    """Largest strain of an elastic fibre of the overshooting filament: mean strain, and bending where it is clamped."""
    weight, delta = weight_stress(scene) * load_factor(scene) * shaken_peak(scene), groups_of(scene).delta
    deep = (elastic_sag_under(scene, weight, instant_modulus(scene)) if weight else 0.0) + rings.amplitude
    ends = {scene.ends.left, scene.ends.right}
    # A string that falls at once is bent where its kinks run, between pins too.
    kinked = rings.amplitude > _KINKED * deep
    bent = 4.8 * delta * deep if ends == {"pinned"} and not kinked else 16 * delta * deep + 11 * deep**2
    begins = max((abs(value) for value in scene.initial.C), default=0.0) + max(0.0, -slackness(scene))
    return max(0.0, 8 / 3 * (deep**2 - start_sag(scene) ** 2)) + begins + bent


def _damped(scene: Scene, scale: float, first: float) -> float:
    """What the loss below yield takes from the ringing of a run, or how far it lets the sag lag at the first frame."""
    if not scene.material.has_loss or is_slack(scene):
        return 0.0
    rings = ringing(scene, lossless=True)
    lost = -math.expm1(-solid_decay(scene) * scene.run.duration)
    return max(min(1.0, rings.lasting(first) / scale) * lost, _lag(scene, solid_retardation(scene)))


def _retarded(scene: Scene, rings: Ringing, amplitude: float) -> float:
    """What the sag of a solid lags behind, or what its ringing loses."""
    late = retardation(scene)
    if late == 0 or is_slack(scene):
        return 0.0
    lost = -math.expm1(-rings.decay * scene.run.duration) if math.isfinite(rings.frequency) else 0.0
    return max(_lag(scene, late), amplitude * lost)


def _lag(scene: Scene, late: float) -> float:
    """Share of the sag that a retardation time [s] keeps from the first frame, or from a load that comes on."""
    if scene.load.ramp > 0:
        return min(1.0, late / scene.load.ramp)
    first = float(np.linspace(0.0, scene.run.duration, min(scene.run.frames, 201))[1])
    return math.exp(-min(700.0, first / late)) if late > 0 else 0.0
