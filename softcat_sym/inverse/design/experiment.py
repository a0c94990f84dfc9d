"""Which experiment tells most: span, thickness, frame rate and duration of least worst relative error."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.inverse.design.judging import Judge
from softcat_sym.inverse.design.noise import Noise, read_noise
from softcat_sym.inverse.design.polishing import LIMITS, Limit, read_limit
from softcat_sym.inverse.design.precision import Unknowns, strongest
from softcat_sym.inverse.design.search import pattern_search
from softcat_sym.inverse.design.trial import Trial
from softcat_sym.inverse.design.variables import (
    FRAME_RATE,
    SPAN,
    THICKNESS,
    Within,
    as_given,
    read_ranges,
)
from softcat_sym.inverse.design.wording import sentences
from softcat_sym.inverse.estimation.fisher import LARGEST_ERROR, Information, information
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.forward.free import free_parameters
from softcat_sym.scene import Scene
from softcat_sym.scene.units import NotAQuantity, shown

_MOST = 200
_CANDIDATES = 8
_MOST_ROUGH = 4

Told = Callable[[Trial], None]


@dataclass(frozen=True, eq=False)
class Experiment:
    """The experiment to make.

    Attributes
    ----------
    best : Trial
        Of least worst error, judged by its own frames.
    as_given : Trial
        The scene as it is, with as many frames as the camera keeps.
    at_bounds : dict of str to str
        Design variables whose bound binds, ``"lower"`` or ``"upper"``.
    noise : Noise
        Of one reading.
    counted : tuple of str
        The parameters whose worst error counts.
    rough : float
        Factor by which the rough values were allowed to be wrong.
    tried : tuple of Trial
        In the order of the search, each filament with its best film: what beats all before it is judged by its own
        frames and by a whole run, the others by the mean information of their film.
    scene : Scene
        The best experiment, to be run.
    sag_at_most : Limit or None
        That the filament was allowed to sag.
    """

    best: Trial
    as_given: Trial
    at_bounds: Mapping[str, str]
    noise: Noise
    counted: tuple[str, ...]
    rough: float
    tried: tuple[Trial, ...]
    scene: Scene
    sag_at_most: Limit | None = None

    @property
    def gain(self) -> float:
        """Worst error of the scene as given over that of the best experiment."""
        return self.as_given.worst / self.best.worst

    @property
    def text(self) -> tuple[str, ...]:
        """Plain sentences."""
        return sentences(
            self.best, self.as_given, self.at_bounds, self.noise, self.counted, self.rough, self.sag_at_most
        )


def design_experiment(
    scene: Scene,
    free: Sequence[str],
    noise: object,
    within: Within,
    *,
    nuisance: Sequence[str] = (),
    frames_at_most: int | None = None,
    rough: float = 1.0,
    sag_at_most: object = None,
    told: Told | None = None,
) -> Experiment:
    """Choose the experiment whose film determines the free parameters best.

    The standard errors are those of the Cramer-Rao bound with white noise: the inverse of the Fisher information
    sum s s^T/noise^2, s = d midpoint/dq over all frames and q the logarithms of the parameters (Atkinson, Donev and
    Tobias 2007). The worst is minimised over span and thickness by a grid and a pattern search; one run of each
    filament serves all its films, at the highest frame rate unless `frames_at_most` binds.

    Parameters
    ----------
    scene : Scene
        With rough values.
    free : sequence of str
        Names as in a fit. Those of the camera (``time_offset``, ``initial_sag``) are estimated, but do not count.
    noise : str or float
        Standard deviation of one reading: a length, a number in m, or ``"1 %"`` of the largest sag of each film.
    within : mapping
        ``{"filament.span": ("2 mm", "50 mm"), "frame_rate": ("25 Hz", "1 kHz"), "run.duration": "5 s"}``; of
        ``filament.span``, ``filament.thickness``, ``frame_rate`` and ``run.duration``. What is left out stays.
    nuisance : sequence of str
        More that is unknown and does not count.
    frames_at_most : int, optional
        That the camera keeps.
    rough : float
        Factor by which rough values may be wrong: the worst error over all corners, two a parameter, is minimised.
    sag_at_most : str or float, optional
        How far the filament may sag: a length with its unit, or a fraction of the span, ``"5 %"``.
    told : callable, optional
        Told every trial.

    Raises
    ------
    SceneError
        If a design variable is unknown or its bounds make no sense, or something cannot be free.
    SoftcatError
        If no experiment within the bounds determines the parameters, with the combination that is determined.
    """
    judge = _judge(scene, tuple(free), tuple(nuisance), noise, within, frames_at_most, rough, sag_at_most)
    return _chosen(scene, judge, _searched(judge, told), frames_at_most)


def _searched(judge: Judge, told: Told | None) -> list[Trial]:
    """Every film that was judged on the way to the best."""
    tried: list[Trial] = []

    def value(point: tuple[float, ...]) -> float:
        span, thickness = _filament(judge, point)
        trial = judge.kept(f"film of {span!r} {thickness!r}", lambda: judge.best_film(span, thickness))
        if trial.worst < min((one.worst for one in tried), default=math.inf):
            rough = trial
            trial = judge.kept(f"checked {rough!r}", lambda: judge.checked(judge.exactly(rough)[0]))
        tried.append(trial)
        if told is not None:
            told(trial)
        return trial.worst

    open_to_choice = [path for path in (SPAN, THICKNESS) if not judge.ranges[path].is_fixed]
    lower, upper = (np.log([getattr(judge.ranges[path], edge) for path in open_to_choice]) for edge in ("low", "high"))
    pattern_search(value, lower, upper, _MOST)
    return tried


def _chosen(scene: Scene, judge: Judge, tried: list[Trial], frames_at_most: int | None) -> Experiment:
    """The best film, with what limits it; refuses where none is worth anything."""
    best = min(tried, key=lambda one: one.worst)
    if not best.worst < LARGEST_ERROR:
        raise SoftcatError(_nothing_to_see(judge, tried))
    counted = tuple(name for name, counts in zip(judge.names, judge.counted, strict=True) if counts)
    # A whole number of frames: one more would be faster than the camera.
    fastest = judge.ranges[FRAME_RATE].high
    values = best.values | ({FRAME_RATE: fastest} if best.frames > fastest * best.duration * (1 - 1e-9) else {})
    at_bounds = {path: bound for path, one in judge.ranges.items() if (bound := one.bound_at(values[path]))}
    if frames_at_most is not None and best.frames == frames_at_most:
        at_bounds["frames_at_most"] = "upper"
    return Experiment(
        best=best,
        as_given=_as_given(judge),
        at_bounds=at_bounds,
        noise=judge.noise,
        counted=counted,
        rough=judge.rough,
        tried=tuple(tried),
        scene=scene.replace(best.changes),
        sag_at_most=judge.sag_at_most,
    )


def _filament(judge: Judge, point: tuple[float, ...]) -> tuple[float, float]:
    """Span and thickness [m] from the logarithms of those that are open to choice."""
    logs = iter(point)
    span, thickness = (
        one.snapped(one.low if one.is_fixed else math.exp(next(logs)))
        for one in (judge.ranges[SPAN], judge.ranges[THICKNESS])
    )
    return span, thickness


def _judge(
    scene: Scene,
    free: tuple[str, ...],
    nuisance: tuple[str, ...],
    noise: object,
    within: Within,
    frames_at_most: int | None,
    rough: float,
    sag_at_most: object,
) -> Judge:
    ranges, faults, reading, allowed = read_ranges(scene, within), [], Noise(math.nan), None
    unknowns = free_parameters(scene, [*free, *nuisance])
    counted = tuple(k < len(free) and not one.of_measurement for k, one in enumerate(unknowns))
    if not any(counted):
        found = "nothing that counts is free: the camera's own and nuisance do not"
        faults.append(Fault("free", found, "one name or more, such as youngs_modulus"))
    try:
        reading = read_noise(noise)
    except NotAQuantity as error:
        faults.append(Fault("noise", str(error), 'the error of one reading, such as "10 um", or "1 %" of the sag'))
    try:
        allowed = None if sag_at_most is None else read_limit(sag_at_most)
    except NotAQuantity as error:
        faults.append(Fault("sag_at_most", str(error), LIMITS))
    if frames_at_most is not None and frames_at_most < 2:
        faults.append(Fault("frames_at_most", shown(frames_at_most), "two frames or more"))
    if not 1 <= rough < math.inf:
        faults.append(Fault("rough", shown(rough), "a factor of at least one, such as 2"))
    corners = sum(one.logarithmic and not one.of_measurement for one in unknowns)
    if rough > 1 and corners > _MOST_ROUGH:
        found = f"{corners} rough values have {2**corners} corners"
        faults.append(Fault("rough", found, f"1, or at most {_MOST_ROUGH} parameters"))
    if faults:
        raise SceneError(faults)
    names = tuple(one.path for one in unknowns)
    return Judge(scene, names, counted, reading, ranges, frames_at_most, float(rough), allowed)


def _as_given(judge: Judge) -> Trial:
    scene = judge.scene
    frames = min(scene.run.frames, judge.frames_at_most or scene.run.frames)
    values = as_given(scene)
    rate, duration = (frames - 1) / scene.run.duration, scene.run.duration
    errors = dict.fromkeys(judge.names, math.inf)
    start = Trial(values[SPAN], values[THICKNESS], rate, duration, frames, math.inf, errors)
    return replace(judge, sag_at_most=None).exactly(start)[0]


def _nothing_to_see(judge: Judge, tried: Sequence[Trial]) -> str:
    """Say that no experiment determines the parameters, and what combination of them is determined."""
    names = " and ".join(name.rpartition(".")[2] for name in judge.names)
    head = f"no experiment within these bounds determines {names} to better than {100 * LARGEST_ERROR:g} %"
    seen = sorted((one for one in tried if one.frames), key=lambda one: one.worst)[:_CANDIDATES]
    if not seen:
        notes = sorted({one.note for one in tried if one.note})
        return f"{head}: no filament within them can be filmed" + (f" ({notes[0]})" if notes else "")
    pairs = [pair for pair in (judge.exactly(one) for one in seen) if pair[1] and np.isfinite(pair[1][0]).all()]
    if not pairs:
        return f"{head}: no filament within them holds as long as its film"
    trial, matrices = pairs[strongest([pair[1][0] for pair in pairs])]
    what = _information(judge, trial, matrices[0]).combinations
    if not what:
        return f"{head}, nor any combination of them: more frames, less noise, or wider bounds are needed"
    listed = "; ".join(f"{one.text}, to {100 * one.standard_error:.2g} %" for one in what)
    remedy = "free fewer, or give the others from elsewhere"
    return f"{head}; what is determined, with a span of {trial.span:.3g} m, is {listed}: {remedy}"


def _information(judge: Judge, trial: Trial, matrix: Floats) -> Information:
    """The information as a fit would judge it."""
    free = free_parameters(judge.scene.replace(trial.changes), judge.names)
    unknowns = Unknowns(free, np.array(judge.counted))
    values, directions = np.linalg.eigh(matrix)
    root = np.sqrt(np.maximum(values, 0.0))[:, None] * directions.T
    box = np.array([one.lower for one in free]), np.array([one.upper for one in free])
    flags = tuple(one.logarithmic for one in free)
    start = np.array([one.scaled(one.typical) for one in free])
    return information(unknowns.names, start, np.zeros(len(free)), root, box, noise_known=True, logarithmic=flags)
