"""When a filament has come to rest, and about which height it rings until then."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass

import numpy as np

from softcat_sym.effects import Effects
from softcat_sym.effects.natural_frequency import first_vibration
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, gravity_time, rest_length
from softcat_sym.solve import Prepared, Progress, Solution, Start
from softcat_sym.trajectory.midpoint import midpoint_heights

PERIODS = 5
"""Periods of the first mode over which mean and amplitude are taken."""

STRIDE = 1.25
"""Ratio of the times, since the whole load acts, at which the filament is looked at."""

NOISE = 0.01
"""Share of the accuracy below which a change of the mean is none: the time steps err by about as much."""

FEWEST_PERIODS = 10.0
"""In a run of which height and amplitude are told, and no phase, where it rings on to the end."""

_SAMPLES = 200
_FRAMES_PER_PERIOD = 8
_WORTH = 0.1
"""Share of a run that may be integrated again to see the ringing between frames that are far apart."""


@dataclass(frozen=True, slots=True)
class Ringing:
    """Height about which the midpoint rings at last, and half of what it swings through; both in m."""

    mean: float
    amplitude: float


def period_of(scene: Scene) -> float:
    """Period of the ringing [s]: of the shaking, or of the first natural frequency; sqrt(L/g) without a spring."""
    if scene.load.shake > 0:
        return 1 / scene.load.shake_frequency
    vibration = first_vibration(scene)
    return 2 * math.pi / vibration.frequency if vibration else min(gravity_time(scene), scene.run.duration / PERIODS)


def ringing_of(heights: Floats) -> Ringing:
    """Mean and amplitude of evenly spaced heights over some periods.

    The mean is weighted by 1 - cos, so that it does not matter with which phase the stretch begins and ends; the
    amplitude is what is left beside a steady drift. Where nothing turns back the mean is the last height.
    """
    along = np.linspace(-1.0, 1.0, len(heights))
    weights = 1 + np.cos(np.pi * along) + 1e-12
    drift = np.polyfit(along, heights, 1, w=np.sqrt(weights))[0] * along
    amplitude = float(np.ptp(heights - drift)) / 2
    steps = np.diff(heights)
    steps = steps[np.abs(steps) > 1e-9 * float(np.max(np.abs(heights), initial=1e-300))]
    if np.count_nonzero(steps[1:] * steps[:-1] < 0) < 2:
        return Ringing(float(heights[-1]), min(amplitude, float(np.ptp(heights)) / 2))
    return Ringing(float(np.average(heights, weights=weights)), amplitude)


def ringing_at_last(
    scene: Scene, effects: Effects, prepared: Prepared, solution: Solution, progress: Progress
) -> tuple[dict[str, float] | None, str]:
    """Mean and amplitude over the last periods of a run, for the summary; without them, why there are none.

    Frames that are too far apart to show the ringing are not believed: the last periods are integrated again from the
    frame before them, with the same steps.
    """
    heights = midpoint_heights(prepared.graph, solution) * rest_length(scene) + 0.0
    if not solution.outcome.is_success or len(heights) < 2:
        return None, "the run has not reached its end"
    if "inertia" not in effects.names or prepared.integration is None:
        return asdict(Ringing(float(heights[-1]), 0.0)), ""
    period, time = period_of(scene) / prepared.scale, solution.time
    periods = min(PERIODS, int((time[-1] - time[0]) / period))
    if periods == 0:
        return None, f"the run is shorter than one period of the first mode, {period * prepared.scale:.3g} s"
    begin = float(time[-1]) - periods * period
    frame = max(0, int(np.searchsorted(time, begin, side="right")) - 1)
    if (len(time) - 1 - frame) >= _FRAMES_PER_PERIOD * periods:
        return asdict(ringing_of(heights[frame:])), ""
    again = float(time[-1] - time[frame])
    if again > max(2 * PERIODS * period, _WORTH * float(time[-1])):
        return None, "the frames are too far apart to show the ringing: more run.frames would"
    start = Start(solution.x[:, frame], solution.z[:, frame])
    piece = prepared.piece(start, (float(time[frame]), begin, float(time[-1])), _SAMPLES, progress)
    if not piece.outcome.is_success:
        return None, "the frames are too far apart to show the ringing: more run.frames would"
    return asdict(ringing_of(midpoint_heights(prepared.graph, piece)[1:] * rest_length(scene) + 0.0)), ""


def rings_on(scene: Scene, told: dict[str, float] | None, largest: float) -> bool:
    """Whether a run rings for so long, and to its end, that height and amplitude are all that an answer tells of it.

    Parameters
    ----------
    scene : Scene
        What is asked.
    told : dict of str to float, or None
        As from :func:`ringing_at_last`.
    largest : float
        Largest distance of the midpoint [m].
    """
    long = scene.load.shake == 0 and scene.run.duration >= FEWEST_PERIODS * period_of(scene)
    return told is not None and long and told["amplitude"] > scene.run.accuracy * largest


def settling_time(scene: Scene, effects: Effects, prepared: Prepared, progress: Progress) -> float | None:
    """Time [s] at which nothing moves any more by the accuracy asked; None if that is not before the end of the run.

    The filament is looked at for five periods before the times t_load + 1.25^k of them. It has settled when the
    midpoint swings by less than the accuracy times its largest height, and when its mean, too, is not going to move by
    that much in what is left of the run. What is going to happen is what has happened from one such time to the next:
    changes that fall by a ratio go on doing so (a logarithm moves by the same, an exponential by ever less), and at
    most at a constant rate. Of a filament that may flow a change too small to be seen counts as one that can just be
    seen and goes on at a constant rate, so that it is watched for some 4 % of the run at least.

    Parameters
    ----------
    scene : Scene
        What is asked.
    effects : Effects
        In force.
    prepared : Prepared
        Its filament.
    progress : Progress
        Told about simulated time.
    """
    loaded = max((scene.load.ramp, *(row[0] for row in scene.ends.motion)))
    if prepared.start is None:
        return None
    if prepared.integration is None:
        return loaded if 0 < loaded < scene.run.duration else None
    unit = rest_length(scene)
    flows = "viscous-flow" in effects.names
    window = PERIODS * period_of(scene)
    state, reached, elapsed = prepared.start, 0.0, window
    largest, means = 0.0, list[float]()
    while loaded + elapsed < scene.run.duration:
        end = loaded + elapsed
        scale, samples = prepared.scale, max(reached, end - window)
        piece = prepared.piece(state, (reached / scale, samples / scale, end / scale), _SAMPLES, progress)
        if not piece.outcome.is_success:
            return None
        heights = midpoint_heights(prepared.graph, piece)[1:] * unit
        largest = max(largest, float(np.max(np.abs(heights))))
        means.append(ringing_of(heights).mean)
        least, left = scene.run.accuracy * largest, scene.run.duration - loaded
        still = float(np.ptp(heights)) / 2 < least
        if still and len(means) > 2 and still_to_move(means, left / elapsed, NOISE * least, flows=flows) < least:
            return end
        state, reached = Start(piece.x[:, -1], piece.z[:, -1]), end
        elapsed *= STRIDE
    return None


def still_to_move(means: list[float], times: float, noise: float, *, flows: bool) -> float:
    """By how much a mean is going to change while the time grows so many times, from its last three values.

    Parameters
    ----------
    means : list of float
        At times that grow by :data:`STRIDE`.
    times : float
        End of the run over the present time.
    noise : float
        Change that cannot be told from none.
    flows : bool
        Whether a change too small to be seen may go on for ever.
    """
    before, change = abs(means[-2] - means[-3]), abs(means[-1] - means[-2])
    if change <= noise and not flows:
        return noise
    ratio = min(STRIDE, change / before) if before > noise and change > noise else STRIDE
    strides = math.log(max(1.0, times)) / math.log(STRIDE)
    total = strides if abs(ratio - 1) < 1e-9 else ratio * (ratio**strides - 1) / (ratio - 1)
    return max(change, noise) * total
