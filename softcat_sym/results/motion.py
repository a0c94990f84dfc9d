"""How a filament has moved: its regime, when it has come to rest, and about which height it rings until then."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.polynomial import Polynomial

from softcat_sym.discretization.unknowns import PLACES, Floats
from softcat_sym.effects.selection import Effects
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.expected_regime import TURNS_BACK
from softcat_sym.estimates.forecast import (
    compliant_sag,
    flowing_overstress,
    forecast,
    lagging,
    missed_by,
    sheared_share,
    tension_share,
)
from softcat_sym.estimates.free_vibration import first_vibration, ringing, solid_decay
from softcat_sym.estimates.quasi_static_sag import load_factor, retardation, solvent_lag
from softcat_sym.estimates.scaling import (
    effective_viscosity,
    effective_viscosity_at,
    pull_of_surface,
    surface_stress,
    weight_stress,
    yield_stress_of,
)
from softcat_sym.physics.cross_sections import CROSS_SECTIONS
from softcat_sym.results.fields import least_displacement, midpoint_heights
from softcat_sym.scene.history import extremes_of, values_at
from softcat_sym.scene.scene import Scene, gravity_time, is_held, is_slack, loaded_from, rest_length, undeformed_area
from softcat_sym.solvers.solution import Extremes, Progress, Solution, Start
from softcat_sym.solvers.solve import Prepared

FRAMES_A_PERIOD = 4.0
"""Fewer pictures a period show a swing that is not there: the wheels of the stage-coach that turn backwards."""

SEEN = 0.01
"""Of the largest sag: smaller swings do not show in pictures."""

NOISE = 0.01
"""Share of the accuracy below which a turning point, or a change of the mean, is none: the time steps err by that."""

_LISTED = 25

NO_SAG = 1e-12
"""Sag over span below which nothing has moved."""


_NO_STRAIN = 1e-12
"""Rounding of a plastic strain."""


def midpoint_extremes(scene: Scene, prepared: Prepared, solution: Solution) -> Extremes:
    """Turning points of the midpoint in s and m, as the integrator has found them."""
    found = solution.extremes
    if found is None:
        found = Extremes.of(solution.time, midpoint_heights(prepared.graph, solution))
    return found.scaled(prepared.scale, rest_length(scene))


def beyond_noise(scene: Scene, extremes: Extremes) -> Extremes:
    """Those that are no noise of the time steps, nor rounding."""
    return extremes.beyond(max(NOISE * scene.run.accuracy * largest_of(extremes), NO_SAG * scene.filament.span))


def turning_points(extremes: Extremes) -> list[list[float]]:
    """Time [s] and height [m] of the first and of the last turning points, for the summary."""
    found = np.stack([extremes.time, extremes.height], axis=1)[1:-1].tolist()
    return [*found[:_LISTED], *found[_LISTED:][-_LISTED:]]


def largest_of(extremes: Extremes) -> float:
    """Largest height of the midpoint above or below its supports [m]."""
    return float(np.max(np.abs(extremes.height)))


def frames_a_period(extremes: Extremes, frames: int) -> float | None:
    """Frames for each period of the last swings that can be seen; None of a filament that does not swing."""
    rings = ringing_of(extremes.beyond(SEEN * largest_of(extremes)), lasting=False)
    return None if rings is None else rings.period * (frames - 1) / float(extremes.time[-1] - extremes.time[0])


def too_few_frames(duration: float, frames: int, per_period: float | None) -> list[str]:
    """Warn of frames that show a swing slower than it is, or jagged."""
    if per_period is None or per_period >= FRAMES_A_PERIOD:
        return []
    frequency, enough = (frames - 1) / per_period / duration, math.ceil(2 * FRAMES_A_PERIOD / per_period * frames)
    return [
        f"it rings at about {frequency:.3g} Hz, with {per_period:.2g} frames a period: too few to show the swing, "
        f"which may look slower than it is in midpoint.csv, pictures and films; run.frames = {enough} shows it"
    ]


def observed_motion(
    scene: Scene,
    effects: Effects,
    time: Floats,
    places: tuple[Floats, Floats],
    fields: Mapping[str, Floats],
    moved: Floats,
    extremes: Extremes,
) -> Motion:
    """Describe the motion of a finished run; what it cannot show, because its effect was left out, is as foreseen.

    `moved` are the displacements of the nodes [m], shape (frames, nodes, axes).
    """
    span, length, y = scene.filament.span, np.diff(places[0]), fields["y"]
    midpoint, expected = y[:, y.shape[1] // 2], forecast(scene)
    depth = np.sqrt(np.sum(moved[:, moved.shape[1] // 2] ** 2, axis=-1)) / span
    # The way of the node that moves farthest, in the direction in which it does.
    distance = np.einsum("fna,fna->fn", moved, moved)
    frame, node = np.unravel_index(int(np.argmax(distance)), distance.shape)
    path = moved[:, node] @ moved[frame, node] / (math.sqrt(distance[frame, node]) or 1.0)
    largest = max(math.sqrt(distance[frame, node]), least_displacement(scene, fields))
    sag = max(float(np.max(depth)), NO_SAG)
    # A filament with a free end hangs by where it is, and not by how far it has moved.
    hanging = sag if is_held(scene) else max(float(np.max(np.abs(midpoint))) / span, NO_SAG)
    strain = float(np.max(np.abs((fields["stretch"] - 1) @ length))) / float(np.sum(length))
    slope = _steepest(np.diff(fields["x"], axis=1), np.diff(y, axis=1))
    # Phase times amplitude of the ringing, over the largest sag: it travels four amplitudes in 2 pi.
    travelled = max(
        float(np.sum(np.abs(np.diff(way)))) - abs(float(way[-1] - way[0])) for way in (path, extremes.height)
    )
    # Of what was dissipated and the most that was stored; unknown where a solid dissipates too.
    lost, stored = float(fields["energy_dissipated"][-1]), float(np.max(fields["energy_elastic"]))
    relaxed = lost / (lost + stored) if lost > 0 and not effects.terms().damped else 0.0
    limit, overstress = yield_stress_of(scene), np.inf
    if limit is not None and "stress_mean" in fields:
        stress = np.abs(fields["stress_mean"]) + np.abs(fields["stress_bending"])
        overstress = float(np.max(np.max(stress, axis=1) / values_at(limit, time)))
    shared = tension_share(scene, hanging)
    # Shear follows the transverse force, behind a viscous stress with its retardation time.
    lag = retardation(scene) if effects.terms().viscous else 0.0
    compliance = compliant_sag(scene, lagging(time, fields["shear_force"], lag), length)
    motion = replace(
        expected,
        sag=sag,
        scale=largest / span,
        strain=strain,
        slope=slope,
        tension_share=shared,
        swings=np.pi / 2 * max(0.0, travelled) / largest,
        relaxed=max(expected.relaxed, relaxed),
        overstress=overstress,
        flowing_overstress=flowing_overstress(scene, hanging),
        sheared=max(sheared_share(scene, hanging, shared), compliance / sag),
        folds=_folds(scene, strain, time, fields),
        speed=float(np.max(np.abs(np.diff(midpoint) / np.diff(time)))) if len(time) > 1 else 0.0,
        capillary=_capillary(scene, depth, fields, length, expected.capillary),
    )
    return _what_was_left_out(scene, effects, time, path, motion)


def _steepest(along: Floats, up: Floats) -> float:
    """Largest slope angle, up to pi of what is folded back; by the tangent of its half, an arctan for each is slow."""
    whole = np.sqrt(along * along + up * up)
    with np.errstate(divide="ignore", invalid="ignore"):
        half = np.abs(up) / (whole + along)
    return 2 * math.atan(float(np.max(np.where(whole > 0, half, 0.0))))


def _what_was_left_out(scene: Scene, effects: Effects, time: Floats, path: Floats, motion: Motion) -> Motion:
    """The numbers that only a run without the effect shows."""
    terms, shown = effects.terms(), dict[str, Any]()

    def damped(decay: float) -> float:
        """What a decay [1/s] would have taken from the swings that a run without it shows."""
        swing = motion.swings / max(1.0, ringing(scene, lossless=True).frequency * scene.run.duration)
        return float(-swing * np.expm1(-decay * scene.run.duration))

    if not terms.inertia:
        # Of what is as good as none nothing is missed.
        share = float(np.max(np.abs(path))) / scene.filament.span / motion.scale
        shown["missed"] = missed_by(scene, time, path) * min(1.0, share)
    if not terms.flows and np.isfinite(motion.overstress):
        # Below the yield stress nothing flows, whatever was foreseen.
        shown["relaxed"] = 1 - 1 / max(1.0, motion.overstress)
    if not terms.viscous and (retardation(scene) or solvent_lag(scene)):
        shown["retarded"] = max(motion.retarded, damped(ringing(scene).decay))
    if not terms.damped and scene.material.has_loss:
        shown["damped"] = max(motion.damped, damped(solid_decay(scene)))
    if not terms.ramped and scene.load.ramp > 0 and scene.load.gravity > 0:
        moved = np.abs(path - path[0] * is_slack(scene))
        shown["risen"] = float(np.interp(scene.load.ramp, time, moved)) / max(float(np.max(moved)), NO_SAG)
    return replace(motion, **shown)


def _capillary(scene: Scene, depth: Floats, fields: Mapping[str, Floats], length: Floats, expected: float) -> float:
    """Largest share of the pull of the surface in the axial force, times the share of the load carried by that."""
    load, pull = weight_stress(scene) * load_factor(scene), surface_stress(scene)
    if pull == 0 or load == 0 or not is_held(scene):
        return expected
    held = CROSS_SECTIONS[scene.filament.section].plane_strain
    surface = pull * (np.ones_like(fields["stretch"]) if held else 1 / np.sqrt(fields["stretch"]))
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
    return max(strain, float(np.max(np.trapezoid(rate, time, axis=0))))


PERIODS = 5
"""Periods over which mean and amplitude are taken."""

STRIDE = 1.25
"""Ratio of the times, since the whole load acts, at which the filament is looked at."""

MIN_PERIODS = 10.0
"""A run that rings on to its end for so long is described by height and amplitude, without a phase."""

_SAMPLES = 200


@dataclass(frozen=True, slots=True)
class Ringing:
    """Height about which the midpoint swings, half of what it swings through [m], and its period [s]."""

    mean: float
    amplitude: float
    period: float
    drift: float | None  # Rate at which the mean changes [m/s], where there are enough periods to tell


def period_of(scene: Scene) -> float:
    """Period of the ringing [s]: of the shaking, or of the first natural frequency; sqrt(L/g) without a spring."""
    if scene.load.shake > 0:
        return 1 / scene.load.shake_frequency
    vibration = first_vibration(scene)
    return 2 * math.pi / vibration.frequency if vibration else min(gravity_time(scene), scene.run.duration / PERIODS)


def ringing_of(extremes: Extremes, *, lasting: bool = True) -> Ringing | None:
    """The last swings, over whole periods; None without them, or if they have ended before a `lasting` one would."""
    turns = len(extremes.time) - 2
    half = min(PERIODS, (turns - 1) // 2)
    if half < 1:
        return None
    time, height, area = (part[-2 - 2 * half : -1] for part in (extremes.time, extremes.height, extremes.area))
    period = float(time[-1] - time[0]) / half
    # Two turning points at one instant, as where a nozzle hands a node over, are no swing.
    if not np.all(np.diff(time) > 0) or (lasting and extremes.time[-1] - time[-1] > period):
        return None
    # Means from one turning point to the next but one, each amid its period.
    means, middles = (area[2:] - area[:-2]) / (time[2:] - time[:-2]), (time[2:] + time[:-2]) / 2
    drift = float((means[-1] - means[0]) / (middles[-1] - middles[0])) if len(means) > 1 else None
    amplitude = float(np.max(np.abs(np.diff(height)))) / 2
    return Ringing(float((area[-1] - area[0]) / (time[-1] - time[0])), amplitude, period, drift)


def settled_height(
    scene: Scene, effects: Effects, extremes: Extremes, rings: Ringing | None
) -> tuple[dict[str, float] | None, str]:
    """Mean and amplitude of the last swings, for the summary; without them, why there are none."""
    if rings is not None:
        return {"mean": rings.mean, "amplitude": rings.amplitude}, ""
    turned = float(extremes.time[-2]) if len(extremes.time) > 2 else 0.0
    if effects.terms().inertia and extremes.time[-1] - turned < period_of(scene):
        return None, f"what it shows is shorter than one period of the first mode, {period_of(scene):.3g} s"
    return {"mean": float(extremes.height[-1]), "amplitude": 0.0}, ""


AGREE = 0.1
"""Of the way that is left: what its estimates from the last half and the last quarter of a run may differ by."""


def creep_of(scene: Scene, extremes: Extremes, time: Floats, midpoint: Floats) -> dict[str, float | None] | None:
    """Rate at which the midpoint still moves at last, beside swings however small, and where it tends, for the summary.

    None if it has moved by less than the accuracy asked in the last fifth of the run, or if it still swings by more.
    """
    rings, least = ringing_of(extremes), scene.run.accuracy * largest_of(extremes)
    if abs(last_fifth(time, midpoint)) <= least or (rings is not None and rings.amplitude > least):
        return None
    if rings is None or rings.drift is None:
        # Ringing too small to turn the midpoint back makes its speed at one instant say little.
        last = slice(-max(4, len(time) // 3), None)
        rate = float(Polynomial.fit(time[last], midpoint[last], min(3, len(time) - 1)).deriv()(time[-1]))
    else:
        rate = rings.drift
    return {"rate_m_per_s": rate, "tends_to_m": _limit(scene, time, midpoint)}


def _limit(scene: Scene, time: Floats, midpoint: Floats) -> float | None:
    """Height to which a solid tends, where it goes there exponentially: heights are linear in earlier ones then."""
    found, frames = list[float](), len(time) - 1
    for begin in (frames - frames // 2, frames - frames // 4):
        apart, heights = (frames - begin) // 4, midpoint[begin:]
        if not apart or time[begin] < loaded_from(scene) or not np.ptp(heights):
            return None
        ratio, rest = np.polyfit(heights[:-apart], heights[apart:], 1)
        if not 0 < ratio < 1:
            return None
        found.append(float(rest / (1 - ratio)))
    agree = abs(found[1] - found[0]) <= AGREE * abs(found[0] - float(midpoint[-1]))
    return found[0] if scene.material.spec.is_solid and agree else None


def last_fifth(time: Floats, midpoint: Floats) -> float:
    """What the midpoint has moved by in the last fifth of a run [m]."""
    return float(midpoint[-1] - np.interp(0.8 * time[-1], time, midpoint))


def rings_on(scene: Scene, rings: Ringing | None, largest: float) -> bool:
    """Whether a run rings for so long, and to its end, that height and amplitude are its whole answer."""
    if rings is None or scene.load.shake > 0 or scene.run.duration < MIN_PERIODS * rings.period:
        return False
    return rings.amplitude > scene.run.accuracy * largest


def settling_time(scene: Scene, effects: Effects, prepared: Prepared, progress: Progress) -> float | None:
    """Time [s] at which nothing moves any more by the accuracy asked; None if that is not before the end of the run.

    The filament is looked at for five periods before the times t_load + 1.25^k of them. It has settled when the
    midpoint swings by less than the accuracy times its largest height, and when its mean, too, is not going to move by
    that much in what is left of the run. What is going to happen is what has happened from one such time to the next:
    changes that fall by a ratio go on doing so (a logarithm moves by the same, an exponential by ever less), and at
    most at a constant rate. Of a filament that may flow a change too small to be seen counts as one that can just be
    seen and goes on at a constant rate, so that it is watched for some 4 % of the run at least.
    """
    loaded = loaded_from(scene)
    if prepared.start is None:
        return None
    if prepared.integration is None:
        return loaded if 0 < loaded < scene.run.duration else None
    flows, scale = effects.terms().flows, prepared.scale
    window = PERIODS * period_of(scene)
    state, reached, elapsed = prepared.start, 0.0, window
    largest, means = 0.0, list[float]()
    while loaded + elapsed < scene.run.duration:
        end = loaded + elapsed
        for until, samples in ((end - window, 1), (end, _SAMPLES)):
            if until <= reached:
                continue
            piece = prepared.piece(state, reached / scale, until / scale, samples, progress)
            if not piece.outcome.is_success:
                return None
            seen = beyond_noise(scene, midpoint_extremes(scene, prepared, piece))
            state, reached = Start(piece.x[:, -1], piece.z[:, -1]), until
            largest = max(largest, largest_of(seen))
        rings, least = ringing_of(seen), scene.run.accuracy * largest
        means.append(float(seen.height[-1]) if rings is None else rings.mean)
        left, still = scene.run.duration - loaded, float(np.ptp(seen.height)) / 2 < least
        if effects.terms().touches:
            # What lies on a floor goes on moving beside a midpoint that rests: by its velocity until the end.
            still = still and _fastest(prepared, piece) * (scene.run.duration - end) < least
        if still and len(means) > 2 and still_to_move(means, left / elapsed, NOISE * least, flows=flows) < least:
            return end
        elapsed *= STRIDE
    return None


def _fastest(prepared: Prepared, piece: Solution) -> float:
    """Mean speed of the node that goes farthest during a piece of a run [m/s]."""
    places = [prepared.observe(piece)[name] for name in PLACES[:2]]
    moved = np.sqrt(sum((place[-1] - place[0]) ** 2 for place in places))
    return float(np.max(moved)) / (float(piece.time[-1] - piece.time[0]) * prepared.scale)


def still_to_move(means: list[float], times: float, noise: float, *, flows: bool) -> float:
    """By how much a mean is going to change while the time grows so many times, from its last three values."""
    before, change = abs(means[-2] - means[-3]), abs(means[-1] - means[-2])
    if change <= noise and not flows:
        return noise
    ratio = min(STRIDE, change / before) if before > noise and change > noise else STRIDE
    strides = math.log(max(1.0, times)) / math.log(STRIDE)
    total = strides if abs(ratio - 1) < 1e-9 else ratio * (ratio**strides - 1) / (ratio - 1)
    return max(change, noise) * total


Regime = Literal[
    "no-yield", "arrested-overdamped", "arrested-underdamped", "descending", "viscous", "elastic", "shaken"
]

ARREST_RATE = 0.5
"""Arrested: the plastic rate stays below this fraction of sigma_Y/eta, in every fibre ...

The hinges at the clamps are the last to stop: in the paper's overdamped arrest they still flow at 0.25 sigma_Y/eta at
t~ = 460 (N = 320), in its continual descent at 2.
"""

ARREST_TIME = 0.1
"""... over this last fraction of the run."""


def has_yielded(prepared: Prepared, solution: Solution) -> bool:
    """Whether plastic strain has come about, which stays, whatever the frames have seen of the flow."""
    plastic = np.isin(prepared.graph.differential.kinds, list(prepared.graph.profiles))
    return bool(np.any(np.abs(solution.x[plastic, -1] - solution.x[plastic, 0]) > _NO_STRAIN))


def regime_of(
    scene: Scene, effects: Effects, fields: Mapping[str, Floats], heights: Floats, *, yielded: bool
) -> Regime:
    """Name the regime, by the fields of frames, the heights of the midpoint at its turning points, and plastic strain.

    Under shaken gravity a filament that has yielded never comes to rest: it is "descending" where it flows on in the
    last tenth and the last period, and otherwise "shaken", of which nothing more is claimed.
    """
    if scene.material.spec.is_solid:
        return "elastic"
    if not (effects.terms().flows or effects.terms().viscous):
        stress = np.abs(fields["stress_mean"]) + np.abs(fields["stress_bending"])
        first = lowest_yield_stress(scene)
        return "no-yield" if first is not None and float(np.max(stress)) < first else "elastic"
    if not effects.terms().yields:
        return "viscous"
    if not yielded:
        return "no-yield"
    if not is_arrested(scene, fields["plastic_rate"]):
        return "descending"
    if scene.load.shake > 0:
        return "shaken"
    return "arrested-underdamped" if rebound_of(heights) > TURNS_BACK else "arrested-overdamped"


def pace_of(scene: Scene) -> float | None:
    """Plastic rate at an overstress as large as the yield stress of the end [1/s], sigma_Y/eta or (sigma_Y/K)^(1/n)."""
    scene = scene.at(scene.run.duration)
    material, yield_stress, viscosity = scene.material, yield_stress_of(scene), effective_viscosity(scene)
    if not yield_stress or not viscosity:
        return None
    if material.viscosity is not None:
        return float((yield_stress / material.viscosity) ** (1 / material.index))
    return yield_stress / viscosity


def lowest_yield_stress(scene: Scene) -> float | None:
    """Lowest yield stress during a run [Pa]; None of a law without one."""
    limit = yield_stress_of(scene)
    return None if limit is None else extremes_of(limit, scene.run.duration)[0]


def is_arrested(scene: Scene, plastic_rate: Floats) -> bool:
    """Whether flow has died out: see :data:`ARREST_RATE` and :data:`ARREST_TIME`; by the material of the end."""
    pace = pace_of(scene)
    if pace is None:
        return False
    frames, share = len(plastic_rate), ARREST_TIME
    if scene.load.shake > 0:
        share = min(1.0, max(share, 1 / (scene.load.shake_frequency * scene.run.duration)))
    last = plastic_rate[min(frames - 1, int((1 - share) * (frames - 1))) :]
    return bool(np.max(last) < ARREST_RATE * pace)


def rebound_of(heights: Floats) -> float:
    """Largest rise of the midpoint after it had been lower, relative to its largest sag."""
    sag = -heights
    deepest = np.maximum.accumulate(sag)
    return float(np.max(deepest - sag) / np.max(sag)) if np.max(sag) > 0 else 0.0


_STILL = 0.01


def time_of_rest(time: Floats, sag: Floats) -> float | None:
    """Time from which the sag stays within 1 % of its last value [s]; None if it moves in the last tenth of the run."""
    moving = np.flatnonzero(np.abs(sag - sag[-1]) > _STILL * abs(sag[-1]))
    first = int(moving[-1]) + 1 if moving.size else 0
    rests = first == 0 or time[first] <= time[0] + (1 - ARREST_TIME) * (time[-1] - time[0])
    return float(time[first]) if rests else None


def time_to_share(time: Floats, sag: Floats, share: float = 0.9) -> float:
    """Time at which the sag first reaches a share of its last value [s], linear between frames; NaN if it rises."""
    if not sag[-1] > 0:
        return math.nan
    level = share * float(sag[-1])
    frame = int(np.argmax(sag >= level))
    if frame == 0:
        return float(time[0])
    before, after = float(sag[frame - 1]), float(sag[frame])
    part = (level - before) / (after - before)
    return float(time[frame - 1] + part * (time[frame] - time[frame - 1]))
