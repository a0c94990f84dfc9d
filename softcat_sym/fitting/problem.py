"""Films beside their models: residuals whose Gaussian likelihood knows of noise, camera and theory's own error."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_smoothing_spline
from scipy.linalg import eigh

from softcat_sym.error_control.estimate import Resolution
from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.discrepancy import discrepancy
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import (
    INITIAL_SAG,
    SCALE,
    TILT,
    TIME_OFFSET,
    FreeParameter,
    Unknowns,
    free_parameters,
)
from softcat_sym.fitting.identifiability import taken
from softcat_sym.fitting.least_squares import Floats, Loss, TimeLimitError
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.plausibility import own_scene
from softcat_sym.scene.scene import Scene

CAMERA = {SCALE: 0.02, INITIAL_SAG: 0.02, TIME_OFFSET: 1.0, TILT: math.radians(1)}
"""Standard deviations with which a camera's own numbers are known unless it is said to be calibrated.

The scale as a share, the sag at the start as a share of the largest height, the clock in frames, the tilt in radians.
"""

THEORY = "theory_error"

# Of the variance of a reading's noise: directions in which the theory's error has less are not followed.
_SEEN = 0.05
_MOST_COMPONENTS, _MOST_DIRECTIONS = 300, 24
# Of the largest height: no camera tells less, and the integrator has as much of its own.
_LEAST_NOISE = 1e-4
_WIDE = 8.0  # Bounds of what has a prior, in its standard deviations
_SIGNIFICANT = 2.6  # Standard normal, 1 %
_MOST_CORRELATED = 0.98
_FEWEST = 20  # Readings in a row from which on a correlation of neighbours can be estimated
# Relative change of the noise that is worth another round.
_SAME_NOISE = 0.1


@dataclass(frozen=True)
class Noise:
    """What is known of a camera's noise beside the errors that its film states."""

    deviation: float  # Of a reading without a stated error [m]
    correlation: float = 0.0  # Of neighbours

    def is_like(self, other: Noise) -> bool:
        """Whether nothing is gained by fitting again with the other."""
        same = abs(math.log(self.deviation / other.deviation)) < _SAME_NOISE
        return same and abs(self.correlation - other.correlation) < _SAME_NOISE


@dataclass(frozen=True, eq=False)
class Filmed:
    """One series, the model of its filament, and which unknowns of the problem that model has."""

    series: Series  # What was measured
    model: ForwardModel  # What it is compared with
    columns: tuple[int, ...]  # For each unknown of the model its number in the problem
    time: Floats  # shape (n,); Of every reading [s]: those of the midpoint, then the points of whole shapes
    place: Floats  # shape (n,); Distance of a point of a shape from halfway between the supports [m]; NaN of a midpoint
    data: Floats  # shape (n,); Heights [m]
    std: Floats  # shape (n,); Standard errors [m]
    scale: int | None = None  # Numbers of the camera's scale and tilt in the problem
    tilt: int | None = None
    theory: tuple[int, ...] = ()  # Numbers of the amplitudes of the theory's error, and
    basis: Floats | None = None  # shape (n, their number); what each of them adds [m]
    theory_size: float = 0.0  # Standard deviation of the theory's error over the heights
    # Directions of the theory's error that have no amplitudes, shape (n, their number), of whitened residuals, and by
    # how much they are to be shortened.
    rest: tuple[Floats, Floats] | None = None
    correlation: float = 0.0  # Of the noise of neighbouring readings of the midpoint

    @property
    def name(self) -> str:
        """Its file; empty if it has none."""
        return self.series.path.name if self.series.path else ""

    def heights(self, q: Floats) -> Floats:
        """What the model says at every reading [m], shape (n,), of the unknowns of the whole problem."""
        own, shapes = q[list(self.columns)], self.series.shapes
        parts = [self.model.midpoints(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x)[0])
        return self._seen(np.concatenate(parts), q)

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """The same with derivatives by the unknowns of the whole problem, shape (n, k)."""
        own, shapes = q[list(self.columns)], self.series.shapes
        parts = [self.model.with_derivatives(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x))
        slopes, plain = np.zeros((self.data.size, q.size)), np.concatenate([part[0] for part in parts])
        slopes[:, list(self.columns)] = np.concatenate([part[1] for part in parts])
        if self.scale is not None:
            slopes *= math.exp(q[self.scale])
            slopes[:, self.scale] = math.exp(q[self.scale]) * plain
        if self.tilt is not None:
            slopes[:, self.tilt] = self._across
        if self.basis is not None:
            slopes[:, list(self.theory)] = self.basis
        return self._seen(plain, q), slopes

    def _seen(self, plain: Floats, q: Floats) -> Floats:
        """Heights as the camera sees those of the model, the theory's own error added."""
        seen = plain if self.scale is None else math.exp(q[self.scale]) * plain
        if self.tilt is not None:
            seen = seen + q[self.tilt] * self._across
        return seen + self.error(q)

    def error(self, q: Floats) -> Floats:
        """What the theory's own error adds [m], shape (n,)."""
        return np.zeros(self.data.size) if self.basis is None else np.asarray(self.basis @ q[list(self.theory)])

    @property
    def _across(self) -> Floats:
        """Height that one radian of the camera's tilt adds [m]."""
        return np.nan_to_num(self.place)

    def whitened(self, rows: Floats) -> Floats:
        """Rows over the standard errors, without what is correlated with the reading before; shape as given."""
        over = self._apart(rows / (self.std if rows.ndim == 1 else self.std[:, None]))
        if self.rest is None:
            return over
        directions, shorter = self.rest
        return np.asarray(
            over - directions @ ((shorter if rows.ndim == 1 else shorter[:, None]) * (directions.T @ over))
        )

    def _apart(self, over: Floats) -> Floats:
        """Rows in standard errors without what is correlated with the reading before."""
        count = self.series.time.size
        if not self.correlation or count < 2:
            return over
        apart = np.diff(self.series.time)
        carried = self.correlation ** (apart / np.median(apart))
        root = np.sqrt(1 - carried**2)
        if over.ndim > 1:
            carried, root = carried[:, None], root[:, None]
        result = over.copy()
        result[1:count] = (over[1:count] - carried * over[: count - 1]) / root
        return result


class FilamentProblem(Unknowns):
    """Residuals in standard errors: a problem of least squares with Gaussian priors.

    Every filament shares the unknowns of the material, which are named first. Behind them come each camera's own
    numbers, known about as well as :data:`CAMERA` says, with the number of the film behind their names where there are
    several; and the amplitudes of the theory's own error, in the directions of its covariance
    (:mod:`softcat_sym.fitting.discrepancy`). What has a prior adds a row to the residuals, behind those of the data.

    Parameters
    ----------
    scene, measurements, names, bounds
        As :func:`softcat_sym.fitting.fit` has them.
    backend, rtol : str, float, optional
        Of the models.
    camera, theory : bool
        Whether the camera's own numbers and the theory's error are unknowns.
    noise : Noise, optional
        Of readings without a stated error; by default a first guess by second differences.
    near : sequence of (Scene, ndarray), optional
        For each film a model near the best and its heights [m], by which the theory's error is scaled; by default that
        of the scene, and what was measured, smoothed.
    """

    def __init__(
        self,
        scene: Scene,
        measurements: Measurements,
        names: Sequence[str],
        bounds: Mapping[str, tuple[object, object]] | None = None,
        backend: str = "auto",
        rtol: float | None = None,
        *,
        camera: bool = False,
        theory: bool = False,
        noise: Noise | None = None,
        near: Sequence[tuple[Scene, Floats]] | None = None,
    ) -> None:
        common, series = free_parameters(scene, names, bounds), measurements.series
        # A film that has a free parameter's value of its own leaves nothing to fit there.
        faults = [
            Fault(f"free {free.name}", f"set by {film.path or 'a series'} itself", "free it, or set it, not both")
            for free in common
            for film in series
            if free.path in film.overrides
        ]
        if faults:
            raise SceneError(faults)
        scenes = [own_scene(film, scene) for film in series]
        own = [
            _of_camera(one, film, {free.path for free in common}) if camera else ()
            for one, film in zip(scenes, series, strict=True)
        ]
        self.free, self.asked, columns = _unknowns(common, own)
        readings = [_readings(film) for film in series]
        self.noise_known = all(std is not None for *_, std in readings)
        self.noise = noise or _first_guess(series)
        self.deadline = math.inf
        self._how = (scene, measurements, names, bounds, backend, rtol, camera, theory)
        films = []
        for film, one, places, (time, place, data, std) in zip(series, scenes, columns, readings, strict=True):
            unknowns = [(number, self.free[number]) for number in places]
            inside = [(number, free) for number, free in unknowns if free.path not in (SCALE, TILT)]
            of_camera = {free.path: number for number, free in unknowns if free.path in (SCALE, TILT)}
            films.append(
                Filmed(
                    series=film,
                    model=ForwardModel(one, [free for _, free in inside], film.time, backend, rtol),
                    columns=tuple(number for number, _ in inside),
                    time=time,
                    place=place,
                    data=data,
                    std=std if self.noise_known and std is not None else np.full(data.size, self.noise.deviation),
                    scale=of_camera.get(SCALE),
                    tilt=of_camera.get(TILT),
                    correlation=self.noise.correlation,
                )
            )
        if theory:
            films = [self._with_theory(film, None if near is None else near[k], k) for k, film in enumerate(films)]
        self.films = tuple(films)
        spread = np.array([free.prior for free in self.free])
        self._known = np.flatnonzero(np.isfinite(spread))
        self._spread = spread[self._known]

    def _with_theory(self, film: Filmed, near: tuple[Scene, Floats] | None, number: int) -> Filmed:
        """The film with the theory's error among its unknowns: its largest principal components."""
        scene, heights = near or (film.model.scene(self.typical[list(film.columns)]), _smoothed(film))
        error = discrepancy(scene, film.model.effects)
        times, row = np.unique(film.time, return_inverse=True)
        # Of whole shapes the deepest point speaks for all: they err as it does, by the same share.
        order = np.lexsort((np.abs(heights), row))
        deepest = heights[order[np.append(np.flatnonzero(np.diff(row[order])), row.size - 1)]]
        last = times.size - 1
        size, vectors = eigh(
            error.covariance(times, deepest), subset_by_index=[max(0, last + 1 - _MOST_COMPONENTS), last]
        )
        scaled = np.where(deepest == 0, 1.0, deepest)
        shares = vectors * np.sqrt(np.maximum(size, 0.0)) / scaled[:, None]
        # Principal components of what the camera sees, against its noise.
        seen = heights[:, None] * shares[row] / film.std[:, None]
        left, singular, _ = np.linalg.svd(seen, full_matrices=False)
        count = min(int(np.sum(singular**2 > _SEEN)), _MOST_DIRECTIONS)
        begin = len(self.free)
        several = f"_{number + 1}" if len(self._how[1].series) > 1 else ""
        self.free += tuple(
            FreeParameter(f"{THEORY}{several}_{k + 1}", THEORY, "1", 0.0, False, 1.0, (-_WIDE, _WIDE), 1.0)
            for k in range(count)
        )
        basis = film.std[:, None] * left[:, :count] * singular[:count]
        # What is not followed is part of the noise: I + B B^T to the power -1/2, by singular vectors of B.
        rest, lengths, _ = np.linalg.svd(film._apart(left[:, count:] * singular[count:]), full_matrices=False)
        return replace(
            film,
            theory=tuple(range(begin, begin + count)),
            basis=basis,
            theory_size=error.amplitude,
            rest=(rest, 1 - 1 / np.sqrt(1 + lengths**2)),
        )

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        """Which unknowns are logarithms."""
        return tuple(free.logarithmic for free in self.free)

    @property
    def unit(self) -> float:
        """Standard error of a reading [m]; where they differ, their mean."""
        return float(np.mean(np.concatenate([film.std for film in self.films])))

    @property
    def readings(self) -> int:
        """Residuals that are not those of priors."""
        return sum(film.data.size for film in self.films)

    def curves(self, q: Floats) -> list[Floats]:
        """What the model says at the readings of each film [m]."""
        return [film.heights(q) for film in self.films]

    def residuals(self, q: Floats) -> Floats:
        """(model - datum)/standard error of all films, then of all priors, shape (m,); NaN where there is no answer."""
        self._check_time()
        pairs = zip(self.films, self.curves(q), strict=True)
        return np.concatenate([*(film.whitened(found - film.data) for film, found in pairs), self._priors(q)])

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives, shape (m, k)."""
        self._check_time()
        residuals, rows = [], []
        for film in self.films:
            found, slopes = film.linearised(q)
            residuals.append(film.whitened(found - film.data))
            rows.append(film.whitened(slopes))
        of_priors = np.zeros((self._known.size, q.size))
        of_priors[np.arange(self._known.size), self._known] = 1 / self._spread
        return np.concatenate([*residuals, self._priors(q)]), np.concatenate([*rows, of_priors])

    def _priors(self, q: Floats) -> Floats:
        return np.asarray((q - self.typical)[self._known] / self._spread)

    def _check_time(self) -> None:
        if clock.monotonic() > self.deadline:
            raise TimeLimitError

    def by_film(self, values: Floats) -> list[Floats]:
        """Split what all readings have, shape (m,) or longer, into one array for each film."""
        return [np.asarray(part) for part in np.split(values, self._ends)[:-1]]

    @property
    def _ends(self) -> NDArray[np.int_]:
        return np.cumsum([film.data.size for film in self.films])

    def values(self, q: Floats) -> dict[str, float]:
        """The unknowns in SI, those of the theory's error aside, which come last and in other numbers for other q."""
        pairs = zip(self.free, q, strict=False)
        return {free.name: free.value(float(x)) for free, x in pairs if free.path != THEORY}

    def at(self, resolution: Resolution, q: Floats) -> tuple[FilamentProblem, Floats]:
        """The problem on another grid, and where a point of this one lies in it."""
        scene, *rest = self._how
        return self._again((resolution.of(scene), *rest), q, self.noise)

    def settled(self, q: Floats, noise: Noise) -> tuple[FilamentProblem, Floats]:
        """The problem with another noise, its theory's error scaled by the model at q, and where q lies in it."""
        return self._again(self._how, q, noise)

    def has(self, noise: Noise, q: Floats) -> bool:
        """Whether it has this noise, and the theory's error that belongs to this point."""
        errors = [
            (film, discrepancy(self._scene_of(film, q), film.model.effects)) for film in self.films if film.theory
        ]
        alike = all(abs(error.amplitude / film.theory_size - 1) < _SAME_NOISE for film, error in errors)
        return noise.is_like(self.noise) and alike

    @staticmethod
    def _scene_of(film: Filmed, q: Floats) -> Scene:
        return film.model.scene(q[list(film.columns)])

    def _again(self, how: tuple, q: Floats, noise: Noise) -> tuple[FilamentProblem, Floats]:  # type: ignore[type-arg]
        scene, measurements, names, bounds, backend, rtol, camera, theory = how
        near = [(self._scene_of(film, q), film.heights(q) - film.error(q)) for film in self.films]
        made = FilamentProblem(
            scene, measurements, names, bounds, backend, rtol, camera=camera, theory=theory, noise=noise, near=near
        )
        made.deadline = self.deadline
        moved = np.array([free.scaled(free.typical) for free in made.free])
        known = dict(zip(((one.name, one.path) for one in self.free), q, strict=True))
        for k, free in enumerate(made.free):
            if free.path != THEORY:
                moved[k] = known[free.name, free.path]
        return made, np.clip(moved, made.lower, made.upper)

    def noise_at(self, residuals: Floats, jacobian: Floats, loss: Loss) -> Noise:
        """Noise that these residuals at an optimum speak of, the freedom of the unknowns allowed for."""
        count = self.readings
        data = residuals[:count]
        freedom = max(count - taken(jacobian, count), 1.0)
        rms = math.sqrt(float(data @ data) / freedom)
        if loss.kind != "linear":
            rms = 1.4826 * float(np.median(np.abs(data))) * math.sqrt(count / freedom)
        if self.noise_known:
            deviation = self.noise.deviation
        elif (deviation := self.noise.deviation * rms) < self.least_noise:
            return Noise(self.least_noise)
        return Noise(deviation, self._correlation_at(self.innovations(residuals, jacobian), loss))

    @property
    def least_noise(self) -> float:
        """What is taken for noise [m] where residuals are less; they are then nobody's error."""
        return _LEAST_NOISE * max(float(np.max(np.abs(film.data))) for film in self.films)

    def innovations(self, residuals: Floats, jacobian: Floats) -> list[Floats]:
        """Each film's residuals less what those before tell of its camera and theory, over their standard errors.

        White if the likelihood is right, which residuals are not: the amplitudes that are fitted take noise up.
        """
        known, found = residuals[self.readings :], []
        for data, slopes in zip(self.by_film(residuals), np.split(jacobian, self._ends)[:-1], strict=True):
            columns = slopes[:, self._known] * self._spread
            seen, spread = np.zeros(known.size), np.eye(known.size)
            left = data - columns @ known
            for k, column in enumerate(columns):
                gain = spread @ column
                variance = 1 + column @ gain
                apart = left[k] - column @ seen
                seen, spread = seen + gain * apart / variance, spread - np.outer(gain, gain) / variance
                left[k] = apart / math.sqrt(variance)
            found.append(left)
        return found

    def _correlation_at(self, innovations: Sequence[Floats], loss: Loss) -> float:
        """Correlation of neighbours, none where it may be chance; of what is left when the present one is taken out."""
        rows = [part[: film.series.time.size] for film, part in zip(self.films, innovations, strict=True)]
        rows = [row for row in rows if row.size >= _FEWEST and np.any(row)]
        if loss.kind != "linear" or not rows:
            return self.noise.correlation
        size = sum(row.size for row in rows)
        squares = sum(float(row @ row) for row in rows)
        # What a fit takes out makes neighbours differ by as much as it takes.
        left = sum(float(row[1:] @ row[:-1]) for row in rows) / squares + self.asked / size
        if abs(left) * math.sqrt(size) < _SIGNIFICANT:
            return self.noise.correlation
        together = (self.noise.correlation + left) / (1 + self.noise.correlation * left)
        return float(np.clip(together, 0.0, _MOST_CORRELATED))


def _readings(series: Series) -> tuple[Floats, Floats, Floats, Floats | None]:
    """Times [s], places [m], heights [m] and, where all are stated, standard errors [m]: midpoints, then shapes."""
    shapes, midpoint = series.shapes, np.full(series.time.size, np.nan)
    if shapes is None:
        return series.time, midpoint, series.midpoint, series.std
    if not series.time.size:
        return shapes.time, shapes.x, shapes.y, shapes.std
    known = None if series.std is None or shapes.std is None else np.concatenate([series.std, shapes.std])
    pairs = (series.time, shapes.time), (midpoint, shapes.x), (series.midpoint, shapes.y)
    time, place, data = (np.concatenate(pair) for pair in pairs)
    return time, place, data, known


def _first_guess(series: Sequence[Series]) -> Noise:
    """Noise by second differences of midpoints, in which what moves smoothly hardly shows; a hundredth without them."""
    largest = max(float(np.max(np.abs(_readings(film)[2]))) for film in series)
    bends = [np.diff(film.midpoint, 2) for film in series if film.time.size >= _FEWEST]
    if not bends:
        return Noise(0.01 * largest)
    found = 1.4826 * float(np.median(np.abs(np.concatenate(bends)))) / math.sqrt(6)
    return Noise(max(found, _LEAST_NOISE * largest))


def _smoothed(film: Filmed) -> Floats:
    """Measured heights [m] without their noise, by generalised cross-validation of a spline; shapes as they are."""
    count, heights = film.series.time.size, film.data.copy()
    if count >= _FEWEST:
        heights[:count] = make_smoothing_spline(film.series.time, film.series.midpoint)(film.series.time)
    return heights


def _of_camera(scene: Scene, film: Series, asked: set[str]) -> tuple[FreeParameter, ...]:
    """The camera's own numbers that are not asked for, with what is known of them."""
    time, _, data, _ = _readings(film)
    names = [name for name in CAMERA if name not in asked and (name != TILT or film.shapes is not None)]
    frame = float(np.median(np.diff(np.unique(time)))) if np.unique(time).size > 1 else 0.0
    units = {INITIAL_SAG: float(np.max(np.abs(data))), TIME_OFFSET: frame}
    found = []
    for one in free_parameters(scene, names) if names else ():
        spread = CAMERA[one.path] * units.get(one.path, 1.0)
        if not spread > 0:
            continue
        prior = spread if one.logarithmic else spread / one.scale
        ends = tuple(one.value(sign * _WIDE * prior) for sign in (-1, 1))
        found.append(replace(one, prior=prior, bounds=(ends[0], ends[1])))
    return tuple(found)


def _unknowns(
    common: tuple[FreeParameter, ...], own: Sequence[tuple[FreeParameter, ...]]
) -> tuple[tuple[FreeParameter, ...], int, list[tuple[int, ...]]]:
    """All unknowns, how many of them are asked for, and for each film the numbers of its own."""
    films, unknowns = len(own), list[FreeParameter]()
    columns: list[list[int]] = [[] for _ in range(films)]

    def numbered(free: FreeParameter, film: int) -> FreeParameter:
        return free if films == 1 else replace(free, name=f"{free.name}_{film + 1}")

    for free in common:
        for k in range(films):
            if k == 0 or free.of_measurement:
                unknowns.append(numbered(free, k) if free.of_measurement else free)
            columns[k].append(len(unknowns) - 1)
    asked = len(unknowns)
    for k, given in enumerate(own):
        for free in given:
            unknowns.append(numbered(free, k))
            columns[k].append(len(unknowns) - 1)
    return tuple(unknowns), asked, [tuple(numbers) for numbers in columns]
