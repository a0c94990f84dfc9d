"""Which experiment tells most: span, thickness, frame rate and duration of least worst error."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np
import pandas as pd
from scipy.optimize import minimize

from softcat_sym import store
from softcat_sym.design.critical_span import LIMITS, read_limit, sentences
from softcat_sym.design.information import (
    DURATION,
    FRAME_RATE,
    SPAN,
    THICKNESS,
    Films,
    Range,
    ReadingNoise,
    Trial,
    Within,
    as_given,
    exact_film,
    films_of,
    read_noise,
    read_ranges,
    relative_errors,
)
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.estimates.span import Limit
from softcat_sym.fitting.free_parameters import FreeParameter, free_parameters
from softcat_sym.fitting.identifiability import FACTOR, MAX_ERROR, Information, information, two_sided_quantile
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import NotAQuantity, length_text, shown
from softcat_sym.simulate import identity_of, simulated, without_estimate
from softcat_sym.solvers.solution import Progress, Silence

_GRID = {1: 9, 2: 5}
_FINEST = math.log(1.05)

Point = tuple[float, ...]
Free = tuple[FreeParameter, ...]


def least_in_box(value: Callable[[Point], float], lower: Floats, upper: Floats, most: int) -> Point | None:
    """Where a value is least in a box: Nelder and Mead's simplex (1965) from the best point of a grid; None if nowhere.

    Infinite where there is no answer; at most so many points are tried.
    """
    if not lower.size:
        return () if math.isfinite(value(())) else None
    at, count = functools.cache(value), _GRID[lower.size]
    axes = [np.linspace(a, b, count).tolist() for a, b in zip(lower, upper, strict=True)]
    best = min(product(*axes), key=at)
    if not math.isfinite(at(best)):
        return None
    step = (upper - lower) / (2 * (count - 1))
    sides = np.where(best + step > upper, -step, step)
    options = {"initial_simplex": best + np.vstack([0 * step, np.diag(sides)]), "maxfev": most - count**lower.size}
    options |= {"xatol": _FINEST, "fatol": math.inf}
    search = partial(minimize, method="Nelder-Mead", bounds=np.column_stack([lower, upper]), options=options)
    return tuple(search(lambda point: at(tuple(point.tolist())), best).x.tolist())


_TRIAL = store.json_form(asdict, lambda found: Trial(**found))
_ROUNDING = 1e-9
_MARGIN = 0.01


@dataclass(frozen=True)
class ExperimentJudge:
    """Judges experiments."""

    scene: Scene  # With rough values
    names: tuple[str, ...]  # All that is estimated, nuisance included
    counted: tuple[bool, ...]  # What of it counts
    noise: ReadingNoise  # Of one reading
    ranges: dict[str, Range]  # Of every design variable
    max_frames: int | None  # That the camera keeps
    max_sag: Limit | None = None  # That no film may show more than

    def stored(self, what: object, compute: Callable[[], Trial]) -> Trial:
        """Return a trial of these rough values and demands, from the store if it was made before."""
        demands = (self.names, self.counted, self.noise, self.ranges, self.max_frames, self.max_sag)
        return store.stored(store.key_of("trial", identity_of(self.scene), demands, what), compute, _TRIAL)

    def best_film(self, span: float, thickness: float) -> Trial:
        """The best duration and frame rate of one filament, from one run."""
        duration = self.ranges[DURATION]
        try:
            scene = self.scene.replace({SPAN: f"{span!r} m", THICKNESS: f"{thickness!r} m"})
            free = free_parameters(scene, self.names)
            films = films_of(scene, free, duration.low, duration.high)
        except SceneError as error:
            return self._nothing(span, thickness, str(error))
        return self._best_of(span, thickness, films, free)

    def exactly(self, trial: Trial) -> tuple[Trial, Floats | None]:
        """The same design judged by its own frames, with the effects of its own duration; its information."""
        if trial.frames < 2:
            return trial, None
        try:
            scene = self.scene.replace(trial.changes)
            free = free_parameters(scene, self.names)
            film = exact_film(scene, free, trial.frames, self.noise)
        except SceneError as error:
            return self._nothing(trial.span, trial.thickness, str(error)), None
        if film.sag > self._allowed(trial.span):
            return self._nothing(trial.span, trial.thickness, self._too_deep(trial.span)), None
        errors = relative_errors(film.information, free)
        return self._trial(trial.values, trial.frames, errors, film.sag, film.message), film.information

    def checked(self, trial: Trial) -> Trial:
        """The same, or infinite errors if the run is no answer: neither neck nor lost energy shows in the midpoint."""
        if not math.isfinite(trial.worst):
            return trial
        run = simulated(without_estimate(self.scene.replace(trial.changes)))
        if run.outcome.is_success:
            return trial
        return self._nothing(trial.span, trial.thickness, f"{run.outcome.name}: {run.outcome.value}")

    def frames(self, durations: Floats) -> Floats:
        """Frames of films of these durations, shape (m,); NaN where the camera keeps too few for its lowest rate."""
        rate = self.ranges[FRAME_RATE]
        frames = np.floor(rate.high * durations * (1 + _ROUNDING)) + 1
        if self.max_frames is not None:
            frames = np.minimum(frames, self.max_frames)
        # A whole number of frames hits a rate to within one of them.
        enough = (frames >= 2) & (frames + 1 >= rate.low * durations * (1 - _ROUNDING) + 1)
        return np.where(enough, frames, np.nan)

    def _best_of(self, span: float, thickness: float, films: Films, free: Free) -> Trial:
        frames = self.frames(films.durations)
        errors = relative_errors(films.information(frames, self.noise.of(films.sag)), free)
        # An experiment is judged again by its own frames and tolerances, which must not find it too deep.
        shallow = ~(films.sag > (1 - _MARGIN) * self._allowed(span))
        worst = np.where(shallow, errors[:, np.array(self.counted)].max(axis=-1), np.inf)
        held = np.flatnonzero(shallow & np.isfinite(frames) & np.isfinite(films.mean).all(axis=(1, 2)))
        if not shallow.any():
            return self._nothing(span, thickness, self._too_deep(span))
        if not held.size and not np.isfinite(worst).any():
            why = films.message or "the camera keeps too few frames for its lowest rate"
            return self._nothing(span, thickness, why)
        # Where nothing determines everything, the longest film is as good as any.
        number = int(np.argmin(worst)) if np.isfinite(worst).any() else int(held[-1])
        duration, count = float(films.durations[number]), int(frames[number])
        values = {SPAN: span, THICKNESS: thickness, FRAME_RATE: (count - 1) / duration, DURATION: duration}
        return self._trial(values, count, errors[number], float(films.sag[number]), films.message)

    def _allowed(self, span: float) -> float:
        """Largest sag [m] of a film of this span."""
        return math.inf if self.max_sag is None else self.max_sag.at(span)

    def _too_deep(self, span: float) -> str:
        return f"even the shortest film sags more than {length_text(self._allowed(span))}"

    def _trial(self, values: dict[str, float], frames: int, errors: Floats, sag: float, note: str) -> Trial:
        worst = float(errors[np.array(self.counted)].max())
        return Trial(
            span=values[SPAN],
            thickness=values[THICKNESS],
            frame_rate=values[FRAME_RATE],
            duration=values[DURATION],
            frames=frames,
            worst=worst,
            errors=dict(zip(self.names, errors.tolist(), strict=True)),
            sag=sag,
            note="" if math.isfinite(worst) else note,
        )

    def _nothing(self, span: float, thickness: float, note: str) -> Trial:
        rate, duration = self.ranges[FRAME_RATE].high, self.ranges[DURATION].high
        return Trial(span, thickness, rate, duration, 0, math.inf, dict.fromkeys(self.names, math.inf), note=note)


_MOST = 200
_CANDIDATES = 8


@dataclass(frozen=True, eq=False)
class Experiment:
    """The experiment to make."""

    best: Trial  # Of least worst error, judged by its own frames
    as_given: Trial  # The scene as it is, with as many frames as the camera keeps
    at_bounds: Mapping[str, str]  # Design variables whose bound binds, ``"lower"`` or ``"upper"``
    noise: ReadingNoise  # Of one reading
    counted: tuple[str, ...]  # The parameters whose worst error counts
    # In the order of the search, each filament with its best film: what beats all before it is judged by its own
    # frames and by a whole run, the others by the mean information of their film.
    tried: tuple[Trial, ...]
    scene: Scene  # The best experiment, to be run
    max_sag: Limit | None = None  # That the filament was allowed to sag

    @property
    def gain(self) -> float:
        """Worst error of the scene as given over that of the best experiment."""
        return self.as_given.worst / self.best.worst

    def to_dict(self) -> dict[str, Any]:
        """What ``experiment.json`` holds, in SI."""
        return {
            "best": self.best.to_dict(),
            "as_given": self.as_given.to_dict(),
            "gain": self.gain,
            "counted": list(self.counted),
            "noise_m": self.noise.of(self.best.sag),
            "noise_of_sag": self.noise.value if self.noise.of_sag else None,
            "sag_at_most_m": None if self.max_sag is None else self.max_sag.at(self.best.span),
            "at_bounds": dict(self.at_bounds),
            "tried": len(self.tried),
            "text": list(self.text),
        }

    def to_frame(self) -> pd.DataFrame:
        """One row a trial in SI, the best and the scene as given first; errors are relative, the camera's own in SI."""
        rows = []
        named = [("best", self.best), ("as given", self.as_given), *(("tried", one) for one in self.tried)]
        for what, one in named:
            row = {"what": what} | one.to_dict()
            note = row.pop("note")
            errors = {f"error_{name.rpartition('.')[2]}": error for name, error in row.pop("errors").items()}
            rows.append(row | errors | {"note": note})
        return pd.DataFrame(rows).replace(math.inf, math.nan)

    @property
    def text(self) -> tuple[str, ...]:
        """Plain sentences."""
        return sentences(self.best, self.as_given, self.at_bounds, self.noise, self.counted, self.max_sag)


def design_experiment(
    scene: Scene,
    free: Sequence[str],
    noise: object,
    within: Within,
    *,
    nuisance: Sequence[str] = (),
    max_frames: int | None = None,
    max_sag: object = None,
    progress: Progress | None = None,
) -> Experiment:
    """Choose the experiment whose film determines the free parameters best.

    The standard errors are those of the Cramer-Rao bound with white noise: the inverse of the Fisher information
    sum s s^T/noise^2, s = d midpoint/dq over all frames and q the logarithms of the parameters (Atkinson, Donev and
    Tobias 2007). The worst of all `free` ones that are not the camera's is minimised over span and thickness by a grid
    and a simplex; one run of each filament serves all its films, at the highest frame rate unless `max_frames`
    binds.

    `noise` is that of one reading: a length, a number in m, or ``"1 %"`` of the largest sag of each film; `within` has
    bounds of ``filament.span``, ``filament.thickness``, ``frame_rate`` and ``run.duration``, what is left out stays;
    `nuisance` is unknown too and does not count; `max_sag` is a length with its unit, or a fraction of the span.
    SoftcatError names the combination that is determined where no experiment determines the parameters.
    """
    judge = judge_of(scene, free, noise, within, nuisance, max_frames, max_sag)
    return best_experiment(judge, progress or Silence())


def best_experiment(judge: ExperimentJudge, progress: Progress) -> Experiment:
    """Search the best film, and judge the scene's own beside it; the rest of :func:`design_experiment`."""
    return _chosen(judge, _searched(judge, progress))


def _searched(judge: ExperimentJudge, progress: Progress) -> list[Trial]:
    """Every film that was judged on the way to the best."""
    tried: list[Trial] = []

    def value(point: tuple[float, ...]) -> float:
        span, thickness = _filament(judge, point)
        trial = judge.stored(["film", span, thickness], lambda: judge.best_film(span, thickness))
        if trial.worst < min((one.worst for one in tried), default=math.inf):
            rough = trial
            trial = judge.stored(["checked", rough], lambda: judge.checked(judge.exactly(rough)[0]))
        tried.append(trial)
        progress.stage(f"tried a span of {trial.span:.3g} m")
        return trial.worst

    open_to_choice = [path for path in (SPAN, THICKNESS) if not judge.ranges[path].is_fixed]
    lower, upper = (np.log([getattr(judge.ranges[path], edge) for path in open_to_choice]) for edge in ("low", "high"))
    least_in_box(value, lower, upper, _MOST)
    return tried


def _chosen(judge: ExperimentJudge, tried: list[Trial]) -> Experiment:
    """The best film, with what limits it; refuses where none is worth anything."""
    best = min(tried, key=lambda one: one.worst)
    if not best.worst < MAX_ERROR:
        raise SoftcatError(_nothing_to_see(judge, tried))
    counted = tuple(name for name, counts in zip(judge.names, judge.counted, strict=True) if counts)
    # A whole number of frames: one more would be faster than the camera.
    fastest = judge.ranges[FRAME_RATE].high
    values = best.values | ({FRAME_RATE: fastest} if best.frames > fastest * best.duration * (1 - 1e-9) else {})
    at_bounds = {path: bound for path, one in judge.ranges.items() if (bound := one.bound_at(values[path]))}
    if best.frames == judge.max_frames:
        at_bounds["max_frames"] = "upper"
    return Experiment(
        best=best,
        as_given=_as_given(judge),
        at_bounds=at_bounds,
        noise=judge.noise,
        counted=counted,
        tried=tuple(tried),
        scene=judge.scene.replace(best.changes),
        max_sag=judge.max_sag,
    )


def _filament(judge: ExperimentJudge, point: tuple[float, ...]) -> tuple[float, float]:
    """Span and thickness [m] from the logarithms of those that are open to choice."""
    logs = iter(point)
    span, thickness = (
        one.snapped(one.low if one.is_fixed else math.exp(next(logs)))
        for one in (judge.ranges[SPAN], judge.ranges[THICKNESS])
    )
    return span, thickness


def judge_of(
    scene: Scene,
    free: Sequence[str],
    noise: object,
    within: Within,
    nuisance: Sequence[str],
    max_frames: int | None,
    max_sag: object,
) -> ExperimentJudge:
    """Read what :func:`design_experiment` is given; every fault is refused before anything runs."""
    ranges, faults, reading, allowed = read_ranges(scene, within), [], ReadingNoise(math.nan), None
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
        allowed = None if max_sag is None else read_limit(max_sag)
    except NotAQuantity as error:
        faults.append(Fault("max_sag", str(error), LIMITS))
    if max_frames is not None and max_frames < 2:
        faults.append(Fault("max_frames", shown(max_frames), "two frames or more"))
    if faults:
        raise SceneError(faults)
    names = tuple(one.path for one in unknowns)
    return ExperimentJudge(scene, names, counted, reading, ranges, max_frames, allowed)


def _as_given(judge: ExperimentJudge) -> Trial:
    scene = judge.scene
    frames = min(scene.run.frames, judge.max_frames or scene.run.frames)
    values = as_given(scene)
    rate, duration = (frames - 1) / scene.run.duration, scene.run.duration
    errors = dict.fromkeys(judge.names, math.inf)
    start = Trial(values[SPAN], values[THICKNESS], rate, duration, frames, math.inf, errors)
    return replace(judge, max_sag=None).exactly(start)[0]


def _nothing_to_see(judge: ExperimentJudge, tried: Sequence[Trial]) -> str:
    """Say that no experiment determines the parameters, and what combination of them is determined."""
    names = " and ".join(name.rpartition(".")[2] for name in judge.names)
    span = math.exp(2 * two_sided_quantile(None) * MAX_ERROR)
    head = f"no experiment within these bounds determines {names} to a factor of {span:.2g}"
    head += f" (95 % interval; identified is less than {FACTOR:g})"
    seen = sorted((one for one in tried if one.frames), key=lambda one: one.worst)[:_CANDIDATES]
    if not seen:
        notes = sorted({one.note for one in tried if one.note})
        return f"{head}: no filament within them can be filmed" + (f" ({notes[0]})" if notes else "")
    exact = [(trial, matrix) for trial, matrix in map(judge.exactly, seen) if matrix is not None]
    pairs = [(trial, matrix) for trial, matrix in exact if np.isfinite(matrix).all()]
    if not pairs:
        return f"{head}: no filament within them holds as long as its film"
    # The information whose smallest eigenvalue is the largest, relative to its largest.
    values = [np.linalg.eigvalsh(matrix) for _, matrix in pairs]
    trial, matrix = pairs[int(np.argmax([row[0] / row[-1] if row[-1] > 0 else -1.0 for row in values]))]
    what = _information(judge, trial, matrix).combinations
    if not what:
        return f"{head}, nor any combination of them: more frames, less noise, or wider bounds are needed"
    listed = "; ".join(f"{one.text}, to {100 * one.standard_error:.2g} %" for one in what)
    remedy = "free fewer, or give the others from elsewhere"
    return f"{head}; what is determined, with a span of {trial.span:.3g} m, is {listed}: {remedy}"


def _information(judge: ExperimentJudge, trial: Trial, matrix: Floats) -> Information:
    """The information as a fit would judge it."""
    free = free_parameters(judge.scene.replace(trial.changes), judge.names)
    values, directions = np.linalg.eigh(matrix)
    root = np.sqrt(np.maximum(values, 0.0))[:, None] * directions.T
    box = np.array([one.lower for one in free]), np.array([one.upper for one in free])
    flags = tuple(one.logarithmic for one in free)
    start = np.array([one.scaled(one.typical) for one in free])
    names = tuple(one.name for one in free)
    return information(names, start, np.zeros(len(free)), root, box, noise_known=True, logarithmic=flags)
