"""What an experiment would tell, judged at the rough values and at the corners of how wrong they may be."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from itertools import product

import numpy as np

from softcat_sym.errors import SceneError
from softcat_sym.inverse.design.film import Films, exact_film, films_of
from softcat_sym.inverse.design.noise import Noise
from softcat_sym.inverse.design.polishing import Limit
from softcat_sym.inverse.design.precision import Unknowns, relative_errors
from softcat_sym.inverse.design.trial import Trial
from softcat_sym.inverse.design.variables import DURATION, FRAME_RATE, SPAN, THICKNESS, Range
from softcat_sym.inverse.design.wording import length_text
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.forward.free import FreeParameter, free_parameters
from softcat_sym.inverse.forward.substituting import with_values
from softcat_sym.scene import Scene
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.solve.keeping import json_form, kept

_TRIAL = json_form(asdict, lambda told: Trial(**told))
_ROUNDING = 1e-9
_MARGIN = 0.01


@dataclass(frozen=True)
class Judge:
    """Judges experiments.

    Attributes
    ----------
    scene : Scene
        With rough values.
    names : tuple of str
        All that is estimated, nuisance included.
    counted : tuple of bool
        What of it counts.
    noise : Noise
        Of one reading.
    ranges : dict of str to Range
        Of every design variable.
    frames_at_most : int or None
        That the camera keeps.
    rough : float
        Factor by which the rough values may be wrong either way; one: not at all.
    sag_at_most : Limit or None
        That no film may show more than, at any of the rough values.
    """

    scene: Scene
    names: tuple[str, ...]
    counted: tuple[bool, ...]
    noise: Noise
    ranges: dict[str, Range]
    frames_at_most: int | None
    rough: float
    sag_at_most: Limit | None = None

    def kept(self, what: str, compute: Callable[[], Trial]) -> Trial:
        """Return a trial of these rough values and demands, from where it is kept if it is."""
        demands = (self.names, self.counted, self.noise, self.ranges, self.frames_at_most, self.rough, self.sag_at_most)
        return kept(lambda: ("trial", self.scene.to_toml(), repr(demands), what), compute, _TRIAL)

    def best_film(self, span: float, thickness: float) -> Trial:
        """The best duration and frame rate of one filament, from one run for each set of rough values."""
        duration = self.ranges[DURATION]
        try:
            scene = self._filament(span, thickness)
            films = [
                (films_of(one, free, duration.low, duration.high), unknowns)
                for one, free, unknowns in self._corners(scene)
            ]
        except SceneError as error:
            return self._nothing(span, thickness, str(error))
        return self._best_of(span, thickness, films)

    def exactly(self, trial: Trial) -> tuple[Trial, list[Floats]]:
        """The same design judged by its own frames, with the effects of its own duration; its information, a corner."""
        if trial.frames < 2:
            return trial, []
        try:
            scene = self.scene.replace(trial.changes)
            found = [
                (exact_film(one, free, trial.frames, self.noise), unknowns)
                for one, free, unknowns in self._corners(scene)
            ]
        except SceneError as error:
            return self._nothing(trial.span, trial.thickness, str(error)), []
        sag = max(film.sag for film, _ in found)
        if sag > self._allowed(trial.span):
            return self._nothing(trial.span, trial.thickness, self._too_deep(trial.span)), []
        errors = np.array([relative_errors(film.information, unknowns) for film, unknowns in found])
        note = next((film.complaint for film, _ in found if film.complaint), "")
        return self._trial(trial.values, trial.frames, errors, sag, note), [film.information for film, _ in found]

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
        if self.frames_at_most is not None:
            frames = np.minimum(frames, self.frames_at_most)
        # A whole number of frames hits a rate to within one of them.
        enough = (frames >= 2) & (frames + 1 >= rate.low * durations * (1 - _ROUNDING) + 1)
        return np.where(enough, frames, np.nan)

    def _best_of(self, span: float, thickness: float, films: list[tuple[Films, Unknowns]]) -> Trial:
        durations = films[0][0].durations
        frames = self.frames(durations)
        rows = [(one.information(frames, self.noise.of_each(one.sag)), unknowns) for one, unknowns in films]
        errors = np.array([relative_errors(information, unknowns) for information, unknowns in rows])
        sag = np.max([one.sag for one, _ in films], axis=0)
        # An experiment is judged again by its own frames and tolerances, which must not find it too deep.
        shallow = ~(sag > (1 - _MARGIN) * self._allowed(span))
        worst = np.array([unknowns.worst(row) for row, (_, unknowns) in zip(errors, films, strict=True)]).max(axis=0)
        worst = np.where(shallow, worst, np.inf)
        # Where nothing determines everything, the film that is best without the gate would be as good as any.
        number = (
            int(np.argmin(worst)) if np.isfinite(worst).any() else self._last(films, np.where(shallow, frames, np.nan))
        )
        note = next((one.complaint for one, _ in films if one.complaint), "")
        if number < 0 and not shallow.any():
            return self._nothing(span, thickness, self._too_deep(span))
        if number < 0:
            return self._nothing(span, thickness, note or "the camera keeps too few frames for its lowest rate")
        duration, count = float(durations[number]), int(frames[number])
        rate = (count - 1) / duration
        values = {SPAN: span, THICKNESS: thickness, FRAME_RATE: rate, DURATION: duration}
        return self._trial(values, count, errors[:, number], float(sag[number]), note)

    @staticmethod
    def _last(films: list[tuple[Films, Unknowns]], frames: Floats) -> int:
        """Number of the longest film that there is; -1 if there is none."""
        held = np.isfinite(frames) & np.all([np.isfinite(one.mean).all(axis=(1, 2)) for one, _ in films], axis=0)
        return int(np.flatnonzero(held)[-1]) if held.any() else -1

    def _allowed(self, span: float) -> float:
        """Largest sag [m] of a film of this span."""
        return math.inf if self.sag_at_most is None else self.sag_at_most.at(span)

    def _too_deep(self, span: float) -> str:
        return f"even the shortest film sags more than {length_text(self._allowed(span))}"

    def _trial(self, values: dict[str, float], frames: int, errors: Floats, sag: float, note: str) -> Trial:
        largest = errors.max(axis=0)
        worst = float(largest[np.array(self.counted)].max())
        return Trial(
            span=values[SPAN],
            thickness=values[THICKNESS],
            frame_rate=values[FRAME_RATE],
            duration=values[DURATION],
            frames=frames,
            worst=worst,
            errors=dict(zip(self.names, largest.tolist(), strict=True)),
            sag=sag,
            note="" if math.isfinite(worst) else note,
        )

    def _nothing(self, span: float, thickness: float, note: str) -> Trial:
        rate, duration = self.ranges[FRAME_RATE].high, self.ranges[DURATION].high
        return Trial(span, thickness, rate, duration, 0, math.inf, dict.fromkeys(self.names, math.inf), note=note)

    def _filament(self, span: float, thickness: float) -> Scene:
        return self.scene.replace({SPAN: f"{span!r} m", THICKNESS: f"{thickness!r} m"})

    def _corners(self, scene: Scene) -> list[tuple[Scene, tuple[FreeParameter, ...], Unknowns]]:
        """The scene with its rough values, and with each of them too small or too large by the factor."""
        rough = free_parameters(scene, self.names)
        scenes = [scene]
        wrong = [one for one in rough if one.logarithmic and not one.of_measurement and self.rough > 1]
        for signs in product((-1, 1), repeat=len(wrong)) if wrong else ():
            values = [
                min(max(one.typical * self.rough**sign, one.bounds[0]), one.bounds[1])
                for one, sign in zip(wrong, signs, strict=True)
            ]
            scenes.append(with_values(scene, wrong, values))
        found = []
        for one in scenes:
            free = free_parameters(one, self.names)
            found.append((one, free, Unknowns(free, np.array(self.counted))))
        return found
