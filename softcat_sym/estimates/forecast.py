"""Forecast of a filament's motion from its groups alone, for the estimates of all effects."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from softcat_sym.estimates import quasi_static_sag as quasi_static
from softcat_sym.estimates import scaling as scales
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.free_vibration import ExpectedRinging, ringing, solid_decay, solid_retardation
from softcat_sym.physics.beams import ramp_gain
from softcat_sym.scene.scene import (
    Scene,
    carries_moment,
    distance,
    groups_of,
    is_held,
    is_slack,
    rest_length,
    undeformed_area,
)
from softcat_sym.scene.tables import farthest, unsupported


def shaken_share(scene: Scene) -> float:
    """Largest oscillation by the shaking over the sag under steady gravity: a times the gain; 0 without shaking.

    For a mode of frequency omega, driven from rest at r omega, the forced and the free vibration together reach at most
    (1 + r)/sqrt((1 - r^2)^2 + (2 zeta r)^2) static deflections (Rayleigh 1877, section 46). The damping zeta includes,
    besides the decay, the limited time of the run for a resonance, which grows by one static deflection in 2/omega. A
    fluid does not spring back: r = 0.
    """
    return scene.load.shake * (1 + _ratio(scene)) * steady_gain(scene) if scene.load.shake > 0 else 0.0


def steady_gain(scene: Scene) -> float:
    """Amplitude of the forced vibration over that of a quasi-static filament."""
    ratio = _ratio(scene)
    if ratio == 0:
        return 1.0
    rings = ringing(scene)
    damping = rings.decay / rings.frequency + 1 / (rings.frequency * scene.run.duration)
    return 1 / math.hypot(1 - ratio**2, 2 * damping * ratio)


def _ratio(scene: Scene) -> float:
    """Frequency of the shaking over that of the first mode; 0 for a filament that does not spring back."""
    if scene.load.shake == 0:
        return 0.0
    frequency = ringing(scene).frequency
    return 2 * math.pi * scene.load.shake_frequency / frequency if math.isfinite(frequency) else 0.0


_DAMPING = (0.0, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.3, 1.6, 2.0, 2.5, 3.0, 3.25, 3.5)
_PAST = (1.0, 0.981, 0.945, 0.841, 0.729, 0.643, 0.517, 0.425, 0.325, 0.250, 0.191, 0.129, 0.0695, 0.0239, 0.0059, 0.0)
"""u - 1 at the first stop, as a function of D: from u'' = 1 - u - D u^2 u'."""


def damping(gravity_number: float, viscous: float) -> float:
    """D = (5/6) sqrt(1/10) V G^(5/2)."""
    return 5 / 6 * math.sqrt(0.1) * viscous * math.pow(gravity_number, 2.5)


def ringing_share(frequency: float, ramp: float) -> float:
    """Share of the oscillation after a ramp of gravity: 1 without one, 0 for a slow one (quintic step, section 3)."""
    number = frequency * ramp
    if number < 1e-2:
        return 1.0
    return abs(float(ramp_gain(number)))


def overshoot(gravity_number: float, viscous: float, ramp: float) -> float:
    """u: sag at the first stop, over the equilibrium sag."""
    past = float(np.interp(damping(gravity_number, viscous), _DAMPING, _PAST))
    return 1 + past * ringing_share(math.sqrt(10 / gravity_number), ramp)


def rebound(gravity_number: float, yield_strain: float, past: float) -> float:
    """Elastic rebound of the filament after its first stop, over its sag.

    It oscillates about the sag at which the elastic stress, 1/G + (16/3) E* h (h - h_stop), carries the weight; the
    rebound is twice the distance to that sag: 2 (1 - 1/u)/(1 + G^2 u^2/(12 eps_Y)).
    """
    return 2 * (1 - 1 / past) / (1 + (gravity_number * past) ** 2 / (12 * yield_strain))


def hinge_pace(gravity_number: float, viscous: float, sag: float, time: float) -> float:
    """Plastic rate at a clamp after a time, over sigma_Y/eta.

    The hinge must rotate by 4 h. A viscous beam under the tension A sigma_Y rotates over the decreasing length
    sqrt(eta I/(A sigma_Y t)): its outer fibre flows at 4 sqrt(3) h sqrt(G V/t) sigma_Y/eta.
    """
    return 4 * math.sqrt(3) * sag * math.sqrt(gravity_number * viscous / time) if time > 0 else math.inf


def neck_draw(scene: Scene, gravity_number: float, viscous: float, sag: float) -> float:
    """Strain of the necks at the two ends, if the elongation of the fall concentrates there.

    A neck grows at sigma_Y/eta while the section flows, for the half period pi sqrt(G/10) of the fall: of the
    elongation (8/3) h^2 of the span the share 1 - exp(-pi sqrt(G/10)/(G V)) goes into two necks, none shorter than pi
    sqrt(beta) h0 (Audoly & Hutchinson 2016).
    """
    if viscous == 0:
        gathered = 1.0
    else:
        # The surface's part of the tension at yield contributes half as much to the growth of a neck.
        growth = (1 + scales.share_of_yield(scene)) / 2
        gathered = -math.expm1(-math.pi * math.sqrt(gravity_number / 10) / (gravity_number * viscous) * growth)
    return gathered * 8 / 3 * sag**2 * rest_length(scene) / (2 * scales.neck_length(scene))


def missed_inertia(time: quasi_static.Floats, sag: quasi_static.Floats, gravity: float, ramp: float) -> float:
    """Largest change of the sag by inertia at the output times, over the largest sag; without ringing.

    A suddenly released filament follows free fall until it reaches its quasi-static sag H(t) ~ t^p, at t_i with
    g t_i^2/2 = H(t_i); from then on it lags by about t_i, which changes the sag by p H t_i/t. Under a slow load the
    relative change is the acceleration over gravity.
    """
    largest = float(np.max(np.abs(sag)))
    if largest == 0 or gravity == 0 or len(time) < 2:
        return 0.0
    moved = np.abs(sag - sag[0])
    # Largest product of sag and acceleration over gravity [m], the share of the load that inertia carries.
    if len(time) < 3:
        slow = 0.0
    else:
        acceleration = np.abs(np.diff(sag, 2)) / (time[1] - time[0]) ** 2
        slow = float(np.max(np.minimum(acceleration / gravity, 1.0) * np.abs(sag[1:-1])))
    if ramp > 0:
        loaded = time > ramp
        return max(_late(time[loaded], moved[loaded], gravity), slow) / largest
    jump = float(np.abs(sag[0]))
    return max(_late(time[1:], moved[1:] + jump, gravity), jump, slow) / largest


def missed_from_rest(time: quasi_static.Floats, sag: quasi_static.Floats, frequency: float) -> float:
    """Largest change of the sag by inertia, over the largest sag, for a filament in equilibrium that begins to flow.

    The initial speed v of the flow causes ringing of amplitude v/omega about the equilibrium.
    """
    largest = float(np.max(np.abs(sag)))
    if largest == 0 or len(time) < 2:
        return 0.0
    speed = abs(float(sag[1] - sag[0])) / float(time[1] - time[0])
    return min(1.0, speed / frequency / largest)


def _late(time: quasi_static.Floats, sag: quasi_static.Floats, gravity: float) -> float:
    """Largest change of the sag by the lag behind the quasi-static sag [m]."""
    if len(time) < 2 or not np.any(sag > 0):
        return 0.0
    safe = np.maximum(sag, 1e-12 * np.max(sag))
    power = np.clip(np.gradient(np.log(safe), np.log(time)), 0.0, 1.0)
    fallen = 2 * safe / (gravity * time**2)
    return float(np.max(power * safe * np.minimum(1.0, fallen ** (1 / (2 - power)))))


_HINGES = 0.7
"""Change of the sag by shear in the hinges of a yielding filament, per h0/L, against plane-stress elements."""

_BENT_ENDS = 5.0
"""Relative change of the sag by shear in the bent ends of a string in clamps, over h0 H/L^2 and the tension's share."""


def sheared_share(scene: Scene, sag: float, tension_share: float) -> float:
    """Relative change of the sag by shear."""
    delta, beam = groups_of(scene).delta, scales.beam_of(scene)
    section = scales.section_of(scene)
    compliance = section.gyration * 2 * (1 + scene.material.poisson) / section.shear_correction * delta**2
    bent = beam.shear_sag / beam.midspan_sag * compliance * (1 - tension_share)
    clamped = carries_moment(scene)
    ends = _BENT_ENDS * delta * sag * tension_share if clamped else 0.0
    hinges = _HINGES * delta if clamped and scales.yield_stress_of(scene) is not None else 0.0
    return max(hinges, bent + ends)


def lagging(time: npt.NDArray[np.float64], force: npt.NDArray[np.float64], lag: float) -> npt.NDArray[np.float64]:
    """Response of a parallel spring and dashpot to a force: lag dF/dt + F = force, from 0 at the first frame."""
    if lag <= 0:
        return force
    felt = np.zeros_like(force)
    for frame, kept in enumerate(np.exp(-np.diff(time) / lag)):
        felt[frame + 1] = kept * felt[frame] + (1 - kept) * force[frame]
    return felt


def compliant_sag(scene: Scene, shear_force: npt.NDArray[np.float64], length: npt.NDArray[np.float64]) -> float:
    """Sag over span by elastic shear under the transverse force of a finished run: its sum times 1/(kappa mu A)."""
    modulus = scales.instant_modulus(scene)
    if modulus is None:
        return 0.0
    correction = scales.section_of(scene).shear_correction
    stiffness = correction * modulus / (2 * (1 + scene.material.poisson)) * undeformed_area(scene)
    half = len(length) // 2
    return float(np.max(np.abs(shear_force[:, :half] @ length[:half]))) / stiffness / scene.filament.span


_TIP_SLOPE = 64 / 17
"""Slope at the tip of a cantilever over the relative sag of its middle, (1/6)/(17/384) for a linear beam."""

_KINKED = 0.1
"""Share of ringing in the sag above which the load counts as sudden."""


def forecast(scene: Scene) -> Motion:
    """Forecast the motion of a scene by closed forms of beam, cable and string (THEORY 5-7, 11).

    It is that of the filament until it touches anything; over pillars, that of a filament clamped at their walls.
    """
    free = unsupported(scene.without_numerics())
    motion, share = _forecast(free), free.filament.span / scene.filament.span
    return motion if share == 1 else replace(motion, sag=motion.sag * share, scale=motion.scale * share)


@lru_cache(maxsize=256)
def _forecast(scene: Scene) -> Motion:
    free, rings = quasi_static.quasi_static_history(scene), ringing(scene)
    history = free
    if scales.pull_of_surface(scene):
        history = quasi_static.SagHistory(
            free.time, np.array([sag * _left_by_surface(scene, float(sag)) for sag in free.sag])
        )
    first, lengths = float(history.time[1]), history.sag * scene.filament.span
    sag, shaken = max(float(np.max(history.sag)), 1e-12), shaken_share(scene)
    weight = scales.weight_stress(scene) * quasi_static.load_factor(scene) * (1 + shaken)
    if shaken and weight:
        sag = max(sag, quasi_static.elastic_sag_under(scene, weight, scales.static_modulus(scene)))
    amplitude = min(1.0, rings.lasting(first) / max(sag, rings.way))
    missed, overstress = missed_by(scene, history.time, lengths), _overstress(scene, rings)
    # There is no forecast for the initial rate of hinges in a slack filament, nor for the motion that a moving support
    # or a force at the end causes.
    moved = scene.ends.motion or scene.ends.right_twist or any(scene.load.tip_force)
    moved = moved or any(scene.load.tip_torque)
    sudden = moved or (is_slack(scene) and 1 < overstress < math.inf)
    # Largest speed of the midpoint [m/s]: of the growing sag and of the ringing, at most that of free fall.
    span = scene.filament.span
    reached = float(np.interp(scene.load.ramp, history.time, history.sag)) / max(float(np.max(history.sag)), 1e-12)
    growing = float(np.max(np.abs(np.diff(history.sag)) / np.diff(history.time))) if len(history.time) > 1 else 0.0
    ringing_speed = rings.amplitude * rings.frequency if math.isfinite(rings.frequency) else 0.0
    fallen = math.sqrt(2 * scales.gravity_of(scene) * float(np.max(history.sag)) * span)
    return Motion(
        sag=sag,
        scale=sag,
        strain=strain_of(scene, sag),
        slope=slope_of(scene, sag),
        tension_share=tension_share(scene, sag),
        # Of the oscillation over a small relative change of the stiffness: d log gain / d log r^2 = r^2 gain.
        swings=amplitude * rings.phase(scene.run.duration)
        + min(1.0, shaken) * 2 * _ratio(scene) ** 2 * steady_gain(scene),
        missed=1.0 if sudden else max(amplitude, missed, min(1.0, shaken)),
        risen=min(1.0, reached + amplitude) if scene.load.ramp > 0 else 0.0,
        relaxed=_relaxed(scene, rings),
        overstress=overstress,
        flowing_overstress=flowing_overstress(scene, sag),
        retarded=_retarded(scene, rings, amplitude),
        damped=_damped(scene, sag, first),
        sheared=sheared_share(scene, sag, tension_share(scene, sag)),
        folds=scales.neck_folds(scene, strain_of(scene, sag)),
        speed=min(max(growing, ringing_speed) * span, fallen),
        capillary=_capillary(scene, float(np.max(free.sag))),
    )


def _left_by_surface(scene: Scene, sag: float) -> float:
    """Sag with surface tension over that without it, x, from C = 8 Gam f/(rho g L) of the latter.

    The load in bending is proportional to x, that in stretching to x^3: (1 - r) x + r x^3 + C x = 1, with r the share
    of tension. In a yielding section C counts three times while the beam carries the load (Haythornthwaite 1957), and
    once if the membrane does.
    """
    weight = scales.weight_stress(scene) * quasi_static.load_factor(scene)
    if weight == 0 or not is_held(scene):
        return 1.0
    carried = 8 * scales.surface_stress(scene) / weight * sag
    number = scales.gravity_number_of(scene)
    if number is not None and number > scales.first_yield_gravity_number(scene):
        return 1 / (1 + (3 if sag < groups_of(scene).delta else 1) * carried)
    stretching, left = tension_share(scene, sag), 1.0
    for _ in range(_NEWTON):
        excess = (1 - stretching + carried) * left + stretching * left**3 - 1
        left -= excess / (1 - stretching + carried + 3 * stretching * left**2)
    return left


_NEWTON = 30
"""Newton steps to the root of a convex function from above."""


def _capillary(scene: Scene, sag: float) -> float:
    """Share by which surface tension reduces the sag; with a free end, five times the shortening of the filament."""
    if scales.surface_stress(scene) == 0:
        return 0.0
    if not is_held(scene):
        return min(1.0, 5 * _shortened(scene, scales.surface_stress(scene)))
    if scales.weight_stress(scene) == 0:
        return 1.0
    return 1 - _left_by_surface(scene, sag)


def _shortened(scene: Scene, pull: float) -> float:
    """Shortening strain of a filament with a free end by its surface: elastic, and by flow beyond the yield stress."""
    modulus, limit = scales.instant_modulus(scene), scales.yield_stress_of(scene) or 0.0
    viscosity = scales.effective_viscosity_at(scene, pull - limit) if pull > limit else None
    flown = scene.run.duration * (pull - limit) / viscosity if viscosity else 0.0
    return min(1.0, (pull / modulus if modulus else 0.0) + flown)


def expected_sag(scene: Scene) -> float:
    """Largest sag over span in the run, at most that of free fall."""
    return min(scales.duration_star(scene) ** 2 / 2, forecast(scene).sag)


def expected_strain(scene: Scene) -> float:
    """Mean stretch minus one of a parabola of the expected sag: (8/3) (H/L)^2."""
    return 8 / 3 * expected_sag(scene) ** 2


def missed_by(scene: Scene, time: quasi_static.Floats, sag: quasi_static.Floats) -> float:
    """Change of the sag by inertia, over the largest sag; a slack filament starts in equilibrium under its weight."""
    if is_slack(scene):
        return missed_from_rest(time, sag, ringing(scene).frequency)
    return missed_inertia(time, sag, scales.gravity_of(scene), scene.load.ramp)


def strain_of(scene: Scene, sag: float) -> float:
    """Largest mean strain: (8/3) H^2 beyond the slack and that of the supports, or by the weight below a free end."""
    if not is_held(scene):
        modulus, pull = scales.instant_modulus(scene), scales.pull_of_surface(scene)
        shortened = _shortened(scene, pull) if pull else 0.0
        return (scales.weight_stress(scene) / modulus if modulus else sag**2) + shortened
    imposed = (
        farthest(scene) / distance(scene) - 1 + max(0.0, -quasi_static.slackness(scene), scene.initial.stretch - 1)
    )
    return max(0.0, 8 / 3 * (sag**2 - quasi_static.start_sag(scene) ** 2)) + imposed


def slope_of(scene: Scene, sag: float) -> float:
    """Largest slope: that of the parabola, plus that of the line between the supports or of the clamps."""
    ends = scene.ends
    lowest = max(abs(ends.drop), *(abs(ends.drop - dy) for _, _, dy, *_ in ends.motion), 0.0)
    imposed = math.atan2(lowest, scene.filament.span)
    own = min(math.pi / 2, (4 if is_held(scene) else _TIP_SLOPE) * sag)
    return own + max(imposed, abs(ends.left_angle), abs(ends.right_angle))


def tension_share(scene: Scene, sag: float) -> float:
    """Share of the load carried in tension at a sag: (64/3) H^2 against the stiffness of the beam."""
    stiffness = scales.bending_stiffness(scene)
    if not is_held(scene):
        return min(1.0, sag**2)
    taut = 8 * max(0.0, -quasi_static.slackness(scene), farthest(scene) / distance(scene) - 1)
    ratio = (64 / 3 * sag**2 + taut) / stiffness
    return ratio / (1 + ratio)


def flowing_overstress(scene: Scene, sag: float) -> float:
    """Mean stress of beam or catenary, less the surface's part, over the yield stress; infinite without one."""
    limit, delta = scales.yield_stress_of(scene), groups_of(scene).delta
    if limit is None:
        return math.inf
    weight, pull = scales.weight_stress(scene), scales.pull_of_surface(scene) if is_held(scene) else 0.0
    return max(0.0, min(weight * (sag + 1 / (8 * sag)) - pull, weight / (2 * delta))) / limit


def _relaxed(scene: Scene, rings: ExpectedRinging) -> float:
    modulus, delta = scales.instant_modulus(scene), groups_of(scene).delta
    if modulus is None:
        return 0.0
    stress = scales.weight_stress(scene) / (2 * delta)
    viscosity = scales.effective_viscosity_at(scene, stress or 1.0)
    if not viscosity:
        return 0.0 if viscosity is None else 1.0
    relaxation = viscosity / modulus
    if scene.material.modes:
        relaxation = min(mode.viscosity / mode.youngs_modulus for mode in scene.material.modes)
    if scene.material.spec.is_solid:
        relaxation = quasi_static.retardation(scene)
    share = -math.expm1(-scene.run.duration / relaxation)
    over = _overstress(scene, rings)
    return share * (1 - 1 / max(1.0, over))


def _overstress(scene: Scene, rings: ExpectedRinging) -> float:
    """Largest elastic fibre stress over the yield stress."""
    limit, modulus = scales.yield_stress_of(scene), scales.instant_modulus(scene)
    if limit is None or modulus is None:
        return math.inf
    strained = largest_strain(scene, rings) * scales.moment_left_by_surface(scene)
    squeezed = 0.0 if is_held(scene) else scales.pull_of_surface(scene)
    return max(modulus * strained, squeezed) / limit


def largest_strain(scene: Scene, rings: ExpectedRinging) -> float:
    """Largest strain of an elastic fibre of the overshooting filament: mean strain, and bending where it is clamped."""
    weight, delta = (
        scales.weight_stress(scene) * quasi_static.load_factor(scene) * (1 + shaken_share(scene)),
        groups_of(scene).delta,
    )
    deep = (
        quasi_static.elastic_sag_under(scene, weight, scales.instant_modulus(scene)) if weight else 0.0
    ) + rings.amplitude
    # A suddenly released string is bent at its travelling kinks, between pins too.
    kinked = rings.amplitude > _KINKED * deep
    pinned = is_held(scene) and not carries_moment(scene)
    bent = 4.8 * delta * deep if pinned and not kinked else 16 * delta * deep + 11 * deep**2
    begins = max((abs(value) for value in scene.initial.C), default=0.0) + max(0.0, -quasi_static.slackness(scene))
    return max(0.0, 8 / 3 * (deep**2 - quasi_static.start_sag(scene) ** 2)) + begins + bent


def _damped(scene: Scene, scale: float, first: float) -> float:
    """Ringing that the loss below yield damps in a run, or lag of the sag at the first frame, whichever is larger."""
    if not scene.material.has_loss or is_slack(scene):
        return 0.0
    rings = ringing(scene, lossless=True)
    lost = -math.expm1(-solid_decay(scene) * scene.run.duration)
    return max(min(1.0, rings.lasting(first) / max(scale, rings.way)) * lost, _lag(scene, solid_retardation(scene)))


def _retarded(scene: Scene, rings: ExpectedRinging, amplitude: float) -> float:
    """Lag of a solid's sag, or ringing that it damps; for polymer chains also the part of their solvent."""
    late = quasi_static.retardation(scene) or quasi_static.solvent_lag(scene)
    if late == 0 or is_slack(scene):
        return 0.0
    lost = -math.expm1(-rings.decay * scene.run.duration) if math.isfinite(rings.frequency) else 0.0
    relaxation = scene.material.relaxation_time
    share = late / (late + relaxation) * _relaxed(scene, rings) if relaxation else 0.0
    return max(_lag(scene, late), amplitude * lost, share)


def _lag(scene: Scene, late: float) -> float:
    """Share of the sag that is missing at the first frame, or during the ramp, by a retardation time [s]."""
    if scene.load.ramp > 0:
        return min(1.0, late / scene.load.ramp)
    first = float(np.linspace(0.0, scene.run.duration, min(scene.run.frames, 201))[1])
    return math.exp(-min(700.0, first / late)) if late > 0 else 0.0
