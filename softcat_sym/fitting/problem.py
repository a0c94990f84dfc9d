"""Residuals of films against their models, with a Gaussian likelihood of noise, camera and theory error."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray
from scipy import stats
from scipy.interpolate import make_smoothing_spline
from scipy.linalg import eigh

from softcat_sym.error_control.estimate import Resolution
from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.discrepancy import discrepancy, shape_modes
from softcat_sym.fitting.flow_curve import FlowCurve
from softcat_sym.fitting.flow_readings import FlowReadings
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
from softcat_sym.fitting.identifiability import Statistic, leverages
from softcat_sym.fitting.least_squares import Floats, Loss, Optimum
from softcat_sym.fitting.measurements import WAYS, Measurements, Series
from softcat_sym.fitting.plausibility import own_scene
from softcat_sym.interrupts import until
from softcat_sym.scene.scene import Scene

CAMERA = {SCALE: 0.02, INITIAL_SAG: 0.02, TIME_OFFSET: 1.0, TILT: math.radians(1)}
"""Prior standard deviations of a camera's parameters, unless it is said to be calibrated.

The scale is a share, the sag at the start a share of the largest height, the clock in frames, the tilt in radians.
"""

THEORY = "theory_error"

# Share of the variance of a reading's noise above which a direction of the theory's error has an amplitude of its own.
_MIN_VARIANCE = 0.05
_MAX_COMPONENTS, _MAX_DIRECTIONS = 300, 24
# Smallest noise, as a share of the largest height: cameras resolve no less, and the integration error is as large.
_MIN_NOISE = 1e-4
_WIDE = 8.0  # Bounds of an unknown with a prior, in its standard deviations
_SIGNIFICANT = 2.6  # Standard normal, 1 %
_MAX_CORRELATION = 0.98
_RANK = 1e-6  # Smallest significant singular value, as a share of the largest
_FEWEST = 20  # Smallest number of consecutive readings whose correlation can be estimated
_RTOL_OF_FORCES = 1e-4
"""Relative tolerance beside forces: they err a hundred times as much as heights, by about a thousandth then."""

EACH = "each"
"""Suffix after the @ of a parameter with a separate value for every film."""

# Relative change of the noise above which the fit is repeated.
_SAME_NOISE = 0.1


@dataclass(frozen=True)
class Noise:
    """Noise of the readings, as far as a film does not state their errors."""

    deviation: float  # Of a height without a stated error [m]
    correlation: float = 0.0  # Of neighbouring readings
    of_force: float = 1.0  # Standard deviation of a force without a stated error [N]

    def is_like(self, other: Noise) -> bool:
        """Whether the other noise differs so little that the fit need not be repeated."""
        pairs = (self.deviation, other.deviation), (self.of_force, other.of_force)
        same = all(abs(math.log(one / another)) < _SAME_NOISE for one, another in pairs)
        return same and abs(self.correlation - other.correlation) < _SAME_NOISE


@dataclass(frozen=True, eq=False)
class Readings:
    """All readings of one film: of the midpoint, then of shapes, then of forces."""

    time: Floats  # shape (n,); [s]
    place: Floats  # shape (n,); [m]; NaN except for points of shapes
    data: Floats  # shape (n,); [m], [N]
    std: Floats  # shape (n,); NaN where it is not stated
    is_force: NDArray[np.bool_]  # shape (n,)

    @classmethod
    def of(cls, series: Series) -> Readings:
        """Collect the readings of one film."""

        def rows(time: Floats, data: Floats, std: Floats | None, place: Floats | None = None) -> tuple[Floats, ...]:
            unknown = np.full(time.size, np.nan)
            return time, unknown if place is None else place, data, unknown if std is None else std

        shapes, parts = series.shapes, [rows(series.time, series.midpoint, series.std)]
        if shapes is not None:
            parts.append(rows(shapes.time, shapes.y, shapes.std, shapes.x))
        heights = sum(part[0].size for part in parts)
        parts += [rows(one.time, one.force, one.std) for one in series.forces]
        time, place, data, std = (np.concatenate(column) for column in zip(*parts, strict=True))
        return cls(time, place, data, std, np.arange(time.size) >= heights)

    @property
    def largest(self) -> float:
        """Largest magnitude of the heights [m]; 0 if there are none."""
        return float(np.max(np.abs(self.data[~self.is_force]), initial=0.0))


@dataclass(frozen=True, eq=False)
class Filmed(Readings):
    """One series, the model of its filament, and the unknowns of the problem on which that model depends."""

    series: Series  # The measurements, of which the readings have a standard error each
    model: ForwardModel  # The model that they are compared with
    columns: tuple[int, ...]  # Number in the problem of each unknown of the model
    scale: int | None = None  # Numbers of the camera's scale and tilt in the problem
    tilt: int | None = None
    theory: tuple[int, ...] = ()  # Numbers of the amplitudes of the theory's error in the problem
    basis: Floats | None = None  # shape (n, amplitudes); Height for a unit of each amplitude [m]
    theory_size: float = 0.0  # Standard deviation of the theory's error over the heights
    # shape (n, components); C C^T is the covariance of the theory's error [m^2].
    components: Floats | None = None
    # Directions of the theory's error without amplitudes, shape (n, directions), of whitened residuals; and the shares
    # by which the residuals are shortened along them.
    rest: tuple[Floats, Floats] | None = None
    correlation: float = 0.0  # Of the noise of neighbouring readings of the midpoint

    @property
    def force_way(self) -> NDArray[np.int64]:
        """Number of the direction of each force in `WAYS`, -1 for heights, shape (n,)."""
        ways = [np.full(one.time.size, WAYS.index(one.way)) for one in self.series.forces]
        return np.concatenate([np.full(int(np.sum(~self.is_force)), -1), *ways])

    def own(self, q: Floats) -> Floats:
        """The unknowns of the model among those of the whole problem."""
        return q[list(self.columns)]

    def scene(self, q: Floats) -> Scene:
        """The scene of this filament with the values of the unknowns."""
        return self.model.scene(self.own(q))

    def run_scene(self, q: Floats) -> tuple[Scene, float]:
        """That scene with its effects and its filmed duration, and the release on the camera's clock [s]."""
        scene, begin = self.scene(q), self.model.release(self.own(q))
        lasts = max(float(self.time.max()) - begin, 1e-6 * scene.run.duration)
        return scene.replace({"run.effects": list(self.model.effects), "run.duration": f"{lasts!r} s"}), begin

    @property
    def name(self) -> str:
        """Label of the film, or the name of its file; empty if it has neither."""
        return self.series.label or (self.series.path.name if self.series.path else "")

    def heights(self, q: Floats) -> Floats:
        """Values of the model at every reading [m], [N], shape (n,), for the unknowns of the whole problem."""
        own, shapes = self.own(q), self.series.shapes
        parts = [self.model.midpoints(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x)[0])
        parts += [self._force(own, number)[0] for number in range(len(self.series.forces))]
        return self._observed(np.concatenate(parts), q)

    def _force(self, own: Floats, number: int) -> tuple[Floats, Floats]:
        one = self.series.forces[number]
        return self.model.forces(own, one.time, WAYS.index(one.way))

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Values of the model, with derivatives by the unknowns of the whole problem, shape (n, k)."""
        own, shapes = self.own(q), self.series.shapes
        parts = [self.model.with_derivatives(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x))
        parts += [self._force(own, number) for number in range(len(self.series.forces))]
        slopes, plain = np.zeros((self.data.size, q.size)), np.concatenate([part[0] for part in parts])
        slopes[:, list(self.columns)] = np.concatenate([part[1] for part in parts])
        if self.scale is not None:
            slopes *= self._magnification(q)[:, None]
            slopes[:, self.scale] = np.where(self.is_force, 0.0, self._magnification(q) * plain)
        if self.tilt is not None:
            slopes[:, self.tilt] = self._height_by_tilt
        if self.basis is not None:
            slopes[:, list(self.theory)] = self.basis
        return self._observed(plain, q), slopes

    def _observed(self, plain: Floats, q: Floats) -> Floats:
        """Heights of the model as the camera shows them, with the theory's error added."""
        seen = plain * self._magnification(q)
        if self.tilt is not None:
            seen = seen + q[self.tilt] * self._height_by_tilt
        return seen + self.error(q)

    def _magnification(self, q: Floats) -> Floats:
        """Magnification of each reading by the camera; one for forces."""
        return np.where(self.is_force, 1.0, 1.0 if self.scale is None else math.exp(q[self.scale]))

    def error(self, q: Floats) -> Floats:
        """Height that the theory's error adds [m], shape (n,)."""
        return np.zeros(self.data.size) if self.basis is None else np.asarray(self.basis @ q[list(self.theory)])

    @property
    def _height_by_tilt(self) -> Floats:
        """Height that one radian of the camera's tilt adds [m]."""
        return np.nan_to_num(self.place)

    def whitened(self, rows: Floats) -> Floats:
        """Rows over the standard errors, decorrelated from the reading before; shape as given."""
        over = self._decorrelated(rows / (self.std if rows.ndim == 1 else self.std[:, None]))
        if self.rest is None:
            return over
        directions, shorter = self.rest
        return np.asarray(
            over - directions @ ((shorter if rows.ndim == 1 else shorter[:, None]) * (directions.T @ over))
        )

    def _decorrelated(self, over: Floats) -> Floats:
        """Rows in standard errors, decorrelated from the reading before."""
        count, carried = self.series.time.size, self._carried
        if not carried.size:
            return over
        root = np.sqrt(1 - carried**2)
        if over.ndim > 1:
            carried, root = carried[:, None], root[:, None]
        result = over.copy()
        result[1:count] = (over[1:count] - carried * over[: count - 1]) / root
        return result

    @property
    def _carried(self) -> Floats:
        """Correlation of each reading of the midpoint with the one before, shape (readings - 1,); empty without any."""
        apart = np.diff(self.series.time) if self.correlation else np.empty(0)
        return self.correlation ** (apart / np.median(apart)) if apart.size else apart


class FilamentProblem(Unknowns):
    """Residuals in standard errors: a problem of least squares with Gaussian priors.

    The free parameters come first. All filaments share them, except those whose names end in ``@2``, the number of a
    film, or in ``@each``. Then come the parameters of each camera, with the priors of :data:`CAMERA` and, if there are
    several films, the film's number in their names; and the amplitudes of the theory's error, in the directions of its
    covariance (:mod:`softcat_sym.fitting.discrepancy`). Every unknown with a prior adds a row to the residuals, after
    those of the data.

    `camera` and `theory` say whether the camera's parameters and the theory's error are unknowns; `noise` is that of
    readings without a stated error, by default a guess by second differences; `near` has for each film a scene near the
    best fit and its heights [m], which scale the theory's error, by default the given scene and the measured heights,
    smoothed. An evaluation beyond the `deadline` of the monotonic clock ends with TimeLimitError.
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
        flow_curve: FlowCurve | None = None,
        deadline: float = math.inf,
    ) -> None:
        series = measurements.series
        scenes = [own_scene(film, scene) for film in series]
        common, single = _asked(scene, scenes, series, names, bounds or {})
        own = [
            _camera_parameters(one, film, {free.path for free in (*common, *alone)}) if camera else ()
            for one, film, alone in zip(scenes, series, single, strict=True)
        ]
        self.free, self.asked, columns = _unknowns(common, single, own)
        self.flow = None if flow_curve is None else _flow_readings(flow_curve, scene, self.free)
        readings = [Readings.of(film) for film in series]
        self.noise_known = all(np.all(np.isfinite(one.std)) for one in readings)
        stated = [
            all(np.all(np.isfinite(one.std[one.is_force == force])) for one in readings) for force in (False, True)
        ]
        self.noise, self._several = noise or _first_guess(series, readings), len(series) > 1
        self.deadline, self._scene = deadline, scene
        self._with = partial(
            FilamentProblem,
            measurements=measurements,
            names=names,
            bounds=bounds,
            backend=backend,
            rtol=rtol,
            camera=camera,
            theory=theory,
            flow_curve=flow_curve,
            deadline=deadline,
        )
        films = []
        for film, one, places, given in zip(series, scenes, columns, readings, strict=True):
            unknowns = [(number, self.free[number]) for number in places]
            inside = [(number, free) for number, free in unknowns if free.path not in (SCALE, TILT)]
            of_camera = {free.path: number for number, free in unknowns if free.path in (SCALE, TILT)}
            of_height = given.std if stated[False] else self.noise.deviation
            of_force = given.std if stated[True] else self.noise.of_force
            films.append(
                Filmed(
                    **vars(replace(given, std=np.where(given.is_force, of_force, of_height))),
                    series=film,
                    model=ForwardModel(
                        one, [free for _, free in inside], film.time, backend, time_steps(film, one, rtol)
                    ),
                    columns=tuple(number for number, _ in inside),
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
        """The film with the largest principal components of the theory's error among its unknowns."""
        scene, heights = near or (film.scene(self.typical), film.data.copy())
        count = film.series.time.size
        if near is None and count >= _FEWEST:
            heights[:count] = make_smoothing_spline(film.series.time, film.series.midpoint)(film.series.time)
        error, seen = discrepancy(scene, film.model.effects, film.model.terms), ~film.is_force
        if not seen.any():
            return film
        heights, std = heights[seen], film.std[seen]
        times, row = np.unique(film.time[seen], return_inverse=True)
        # Points of a shape err by a share that changes along it, and in time as that of the deepest point.
        order = np.lexsort((np.abs(heights), row))
        deepest = heights[order[np.append(np.flatnonzero(np.diff(row[order])), row.size - 1)]]
        last = times.size - 1
        size, vectors = eigh(
            error.covariance(times, deepest), subset_by_index=[max(0, last + 1 - _MAX_COMPONENTS), last]
        )
        scaled = np.where(deepest == 0, 1.0, deepest)
        shares = vectors * np.sqrt(np.maximum(size, 0.0)) / scaled[:, None]
        # Principal components of the error in the readings, relative to their noise.
        relative = shares[row]
        if film.series.shapes is not None:
            along = shape_modes(film.place[seen], scene.filament.span)
            relative = (relative[:, :, None] * along[:, None, :]).reshape(row.size, -1)
        left, singular, _ = np.linalg.svd(heights[:, None] * relative / std[:, None], full_matrices=False)
        count = min(int(np.sum(singular**2 > _MIN_VARIANCE)), _MAX_DIRECTIONS)
        begin = len(self.free)
        several = f"_{number + 1}" if self._several else ""
        self.free += tuple(
            FreeParameter(f"{THEORY}{several}_{k + 1}", THEORY, "1", 0.0, False, 1.0, (-_WIDE, _WIDE), 1.0)
            for k in range(count)
        )
        components, basis = np.zeros((film.data.size, singular.size)), np.zeros((film.data.size, count))
        components[seen] = left * singular
        basis[seen] = std[:, None] * components[seen, :count]
        # The other components B add to the noise: its whitening is (I + B B^T)^(-1/2), by singular vectors of B.
        rest, lengths, _ = np.linalg.svd(film._decorrelated(components[:, count:]), full_matrices=False)
        return replace(
            film,
            theory=tuple(range(begin, begin + count)),
            basis=basis,
            theory_size=error.amplitude,
            components=film.std[:, None] * components,
            rest=(rest, 1 - 1 / np.sqrt(1 + lengths**2)),
        )

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        """Which unknowns are logarithms."""
        return tuple(free.logarithmic for free in self.free)

    @property
    def unit(self) -> float:
        """Mean standard error of the heights [m]; of the forces [N] if there are no heights."""
        std = np.concatenate([film.std for film in self.films])
        return float(np.mean(std[~self._is_force] if not self._is_force.all() else std))

    @property
    def _is_force(self) -> NDArray[np.bool_]:
        return np.concatenate([film.is_force for film in self.films])

    @property
    def readings(self) -> int:
        """Number of residuals without those of priors."""
        return sum(film.data.size for film in self.films) + (0 if self.flow is None else self.flow.std.size)

    def curves(self, q: Floats) -> list[Floats]:
        """Values of the model at the readings of each film [m], [N]."""
        return [film.heights(q) for film in self.films]

    def residuals(self, q: Floats) -> Floats:
        """(model - datum)/standard error of all films, then of all priors, shape (m,); NaN where there is no answer."""
        with until(self.deadline):
            curves = self.curves(q)
        pairs = zip(self.films, curves, strict=True)
        of_curve = [] if self.flow is None else [self.flow.residuals(q)]
        return np.concatenate(
            [*(film.whitened(found - film.data) for film, found in pairs), *of_curve, self._priors(q)]
        )

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives, shape (m, k)."""
        residuals, rows = [], []
        with until(self.deadline):
            linearised = [film.linearised(q) for film in self.films]
        for film, (found, slopes) in zip(self.films, linearised, strict=True):
            residuals.append(film.whitened(found - film.data))
            rows.append(film.whitened(slopes))
        if self.flow is not None:
            residuals.append(self.flow.residuals(q))
            rows.append(self.flow.slopes(q))
        of_priors = np.zeros((self._known.size, q.size))
        of_priors[np.arange(self._known.size), self._known] = 1 / self._spread
        return np.concatenate([*residuals, self._priors(q)]), np.concatenate([*rows, of_priors])

    def squares_of_camera(self, q: Floats) -> float:
        """Squares of the residuals of the camera's priors."""
        of_camera = np.array([self.free[k].path != THEORY for k in self._known], dtype=bool)
        return float(np.sum(self._priors(q)[of_camera] ** 2))

    def _priors(self, q: Floats) -> Floats:
        return np.asarray((q - self.typical)[self._known] / self._spread)

    def by_film(self, values: Floats) -> list[Floats]:
        """Split an array over all residuals, shape (m,), into one for each film, without flow curve and priors."""
        return [np.asarray(part) for part in np.split(values, self._ends)[:-1]]

    @property
    def _ends(self) -> NDArray[np.int_]:
        return np.cumsum([film.data.size for film in self.films])

    def values(self, q: Floats) -> dict[str, float]:
        """The unknowns in SI, without those of the theory's error, which come last and whose number depends on q."""
        pairs = zip(self.free, q, strict=False)
        return {free.name: free.value(float(x)) for free, x in pairs if free.path != THEORY}

    def at(self, resolution: Resolution, q: Floats) -> tuple[FilamentProblem, Floats]:
        """The problem at another resolution, and the point of it that corresponds to q."""
        return self._again(resolution.of(self._scene), q, self.noise)

    def settled(self, q: Floats, noise: Noise) -> tuple[FilamentProblem, Floats]:
        """The problem with another noise and the theory's error at q, and the point of it that corresponds to q."""
        return self._again(self._scene, q, noise)

    def has(self, noise: Noise, q: Floats) -> bool:
        """Whether the problem uses this noise and the theory's error at this point."""
        errors = [
            (film, discrepancy(film.scene(q), film.model.effects, film.model.terms))
            for film in self.films
            if film.theory
        ]
        alike = all(abs(error.amplitude / film.theory_size - 1) < _SAME_NOISE for film, error in errors)
        return noise.is_like(self.noise) and alike

    def _again(self, scene: Scene, q: Floats, noise: Noise) -> tuple[FilamentProblem, Floats]:
        near = [(film.scene(q), film.heights(q) - film.error(q)) for film in self.films]
        made = self._with(scene=scene, noise=noise, near=near)
        moved = np.array([free.scaled(free.typical) for free in made.free])
        known = dict(zip(((one.name, one.path) for one in self.free), q, strict=True))
        for k, free in enumerate(made.free):
            if free.path != THEORY:
                moved[k] = known[free.name, free.path]
        return made, np.clip(moved, made.lower, made.upper)

    def noise_at(self, residuals: Floats, jacobian: Floats, loss: Loss) -> Noise:
        """Noise estimated from the residuals at an optimum, corrected for the degrees of freedom of the unknowns."""
        is_force = self._is_force
        count, readings = is_force.size, np.concatenate([film.data for film in self.films])
        data, taken = residuals[:count], leverages(jacobian)[:count]
        found = []
        for which, former in ((~is_force, self.noise.deviation), (is_force, self.noise.of_force)):
            part, size = data[which], int(which.sum())
            if not size:
                found.append(former)
                continue
            freedom = max(size - float(taken[which].sum()), 1.0)
            rms = math.sqrt(float(part @ part) / freedom)
            if loss.kind != "linear":
                rms = 1.4826 * float(np.median(np.abs(part))) * math.sqrt(size / freedom)
            found.append(max(former * rms, _MIN_NOISE * float(np.max(np.abs(readings[which])))))
        deviation, of_force = (self.noise.deviation, self.noise.of_force) if self.noise_known else found
        if not self.noise_known and deviation == self.least_noise:
            return Noise(deviation, 0.0, of_force)
        return Noise(deviation, self._correlation_at(self.innovations(residuals, jacobian), loss), of_force)

    def contradiction(self, residuals: Floats, jacobian: Floats) -> Statistic | None:
        """Test whether films and flow curve have the same constants; None without a flow curve.

        The statistic is the amount by which separate fits of both would lower chi^2, to first order. Its degrees of
        freedom are the ranks of both alone less the rank of both together (Maltoni & Schwetz 2003).
        """
        if self.flow is None:
            return None
        end = self.readings
        of_curve = np.zeros(residuals.size, dtype=bool)
        of_curve[end - self.flow.std.size : end] = True
        fall, ranks = 0.0, 0
        for part in (of_curve, ~of_curve):
            left, size, _ = np.linalg.svd(jacobian[part], full_matrices=False)
            basis = left[:, size > _RANK * max(float(size[0]), 1.0)]
            explained = float(np.sum((basis.T @ residuals[part]) ** 2))
            remaining = float(residuals[part] @ residuals[part]) - explained
            freedom = max(int(part.sum()) - basis.shape[1], 1)
            # An estimated noise is taken from each part alone, without the contradiction.
            known = self.flow.known if part[end - 1] else self.noise_known
            fall += explained / (1.0 if known else max(remaining / freedom, _MIN_NOISE))
            ranks += basis.shape[1]
        freedom = max(ranks - int(np.linalg.matrix_rank(jacobian, tol=_RANK * float(np.linalg.norm(jacobian, 2)))), 1)
        return Statistic("films against flow curve", fall, float(stats.chi2.sf(fall, freedom)))

    @property
    def least_noise(self) -> float:
        """Smallest noise that is assumed [m], even if the residuals are smaller."""
        heights = np.concatenate([film.data[~film.is_force] for film in self.films])
        return _MIN_NOISE * float(np.max(np.abs(heights), initial=0.0))

    def innovations(self, residuals: Floats, jacobian: Floats) -> list[Floats]:
        """Innovations: residuals of each film less their prediction from those before, over its standard error.

        The prediction is that of the camera's parameters and of the theory's error. Innovations are white if the
        likelihood is right; residuals are not, as the fitted amplitudes absorb noise.
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
        """Updated correlation of neighbouring readings; the present one if the innovations are not correlated."""
        rows = [part[: film.series.time.size] for film, part in zip(self.films, innovations, strict=True)]
        rows = [row for row in rows if row.size >= _FEWEST and np.any(row)]
        if loss.kind != "linear" or not rows:
            return self.noise.correlation
        size = sum(row.size for row in rows)
        squares = sum(float(row @ row) for row in rows)
        # The fitted parameters make neighbouring residuals anticorrelated by their share of the degrees of freedom.
        left = sum(float(row[1:] @ row[:-1]) for row in rows) / squares + self.asked / size
        if abs(left) * math.sqrt(size) < _SIGNIFICANT:
            return self.noise.correlation
        together = (self.noise.correlation + left) / (1 + self.noise.correlation * left)
        return float(np.clip(together, 0.0, _MAX_CORRELATION))


def _first_guess(series: Sequence[Series], readings: Sequence[Readings]) -> Noise:
    """Noise from second differences, to which a smooth motion hardly contributes."""
    forces = [one.force for film in series for one in film.forces]
    strongest = max((float(np.max(np.abs(one))) for one in forces), default=1.0)
    largest = max(one.largest for one in readings) or 1.0
    return Noise(
        _from_second_differences([film.midpoint for film in series], largest),
        of_force=_from_second_differences(forces, strongest),
    )


def _from_second_differences(rows: Sequence[Floats], largest: float) -> float:
    """Standard deviation of noise in rows of readings; a hundredth of the largest one if all rows are short."""
    differences = [np.diff(row, 2) for row in rows if row.size >= _FEWEST]
    if not differences:
        return 0.01 * largest
    found = 1.4826 * float(np.median(np.abs(np.concatenate(differences)))) / math.sqrt(6)
    return max(found, _MIN_NOISE * largest)


def time_steps(film: Series, scene: Scene, rtol: float | None) -> float | None:
    """Relative tolerance of the model of a film; None for the one of a run."""
    if rtol is not None or not film.forces:
        return rtol
    return min(scene.numerics.rtol or math.inf, _RTOL_OF_FORCES)


def _flow_readings(curve: FlowCurve, scene: Scene, free: Sequence[FreeParameter]) -> FlowReadings:
    alone = [one for one in free if one.film is not None and one.path.startswith("material.")]
    if alone:
        found = "of single films, and a flow curve is of one material"
        raise SceneError([Fault(f"free {one.name}", found, one.name.partition("@")[0]) for one in alone])
    shared = [(k, one) for k, one in enumerate(free) if one.film is None and one.path.startswith("material.")]
    return FlowReadings.of(curve, scene, [one for _, one in shared], [k for k, _ in shared])


def _camera_parameters(scene: Scene, film: Series, asked: set[str]) -> tuple[FreeParameter, ...]:
    """The camera's parameters that are not free parameters themselves, with their priors."""
    read = Readings.of(film)
    names = [name for name in CAMERA if name not in asked and (name != TILT or film.shapes is not None)]
    if film.shapes is not None and film.shapes.shows_supports:
        # Supports in the same picture are its ruler.
        names = [name for name in names if name != SCALE]
    if not read.largest:
        # A load cell has a clock, but no heights.
        names = [name for name in names if name == TIME_OFFSET]
    times = np.unique(read.time)
    frame = float(np.median(np.diff(times))) if times.size > 1 else 0.0
    units = {INITIAL_SAG: read.largest, TIME_OFFSET: frame}
    found = []
    for one in free_parameters(scene, names) if names else ():
        spread = CAMERA[one.path] * units.get(one.path, 1.0)
        if one.path == INITIAL_SAG and film.shapes is not None:
            spread = math.hypot(spread, film.shapes.level_std)
        if not spread > 0:
            continue
        prior = spread if one.logarithmic else spread / one.scale
        ends = tuple(one.value(sign * _WIDE * prior) for sign in (-1, 1))
        found.append(replace(one, prior=prior, bounds=(ends[0], ends[1])))
    return tuple(found)


def _asked(
    scene: Scene,
    scenes: Sequence[Scene],
    series: Sequence[Series],
    names: Sequence[str],
    bounds: Mapping[str, tuple[object, object]],
) -> tuple[tuple[FreeParameter, ...], list[tuple[FreeParameter, ...]]]:
    """Free parameters that all films share, and those of each film: ``thickness@2`` of one film, ``@each`` of all."""
    count, everyone = len(scenes), [name for name in names if "@" not in name]
    numbers = {EACH: tuple(range(count)), **{str(k + 1): (k,) for k in range(count)}}
    accepted = f"{EACH}, or the number of a film, " + ("1" if count == 1 else f"1 to {count}")
    pairs = [name.partition("@")[::2] for name in (*names, *bounds) if "@" in name]
    faults = [Fault(f"free {name}@{of}", "no such film", f"@{accepted}") for name, of in pairs if of not in numbers]
    if faults:
        raise SceneError(faults)

    def own(name: str, film: int) -> str:
        """The bare name if it is of this film; empty if not."""
        bare, _, of = name.partition("@")
        return bare if of and film in numbers[of] else ""

    single = []
    for k, one in enumerate(scenes):
        mine = [own(name, k) for name in names if own(name, k)]
        within = {own(name, k): pair for name, pair in bounds.items() if own(name, k)}
        single.append(free_parameters(one, mine, within) if mine or within else ())
    shared = {name: pair for name, pair in bounds.items() if "@" not in name}
    common = free_parameters(scene, everyone, shared) if everyone or shared or not any(single) else ()
    # A parameter whose value a film sets itself cannot be free for that film.
    faults = [
        Fault(f"free {free.name}", f"set by {film.path or 'a series'} itself", f"{free.name}@{k}, or set it")
        for free in common
        for k, (film, alone) in enumerate(zip(series, single, strict=True), start=1)
        if free.path in film.overrides and free.path not in {one.path for one in alone}
    ]
    if not any(film.shapes is not None for film in series):
        tilted = [free.name for free in (*common, *(one for alone in single for one in alone)) if free.path == TILT]
        found = "of a camera rotates whole shapes, and does not move midpoints"
        faults += [Fault(f"free {name}", found, "a film of whole shapes, or another name") for name in tilted]
    kept = [[one for one in common if one.path not in {mine.path for mine in alone}] for alone in single]
    faults += [
        Fault(f"free {free.name}", "every film has one of its own", "either, not both")
        for free in common
        if not any(free in left for left in kept)
    ]
    if faults:
        raise SceneError(faults)
    for one, left, alone in zip(scenes, kept, single, strict=True):
        if alone:
            # Together: no constant of a film may be named twice, in tension and in shear.
            free_parameters(one, [free.path for free in (*left, *alone)])
    return common, single


def _unknowns(
    common: tuple[FreeParameter, ...],
    single: Sequence[tuple[FreeParameter, ...]],
    own: Sequence[tuple[FreeParameter, ...]],
) -> tuple[tuple[FreeParameter, ...], int, list[tuple[int, ...]]]:
    """All unknowns, the number of free parameters among them, and the numbers of the unknowns of each film."""
    count = len(own)

    def numbered(free: FreeParameter, film: int, mark: str = "_") -> FreeParameter:
        return free if count == 1 else replace(free, name=f"{free.name}{mark}{film + 1}", film=film + 1)

    # Every unknown with the films that depend on it.
    rows = list[tuple[FreeParameter, list[int]]]()
    for free in common:
        having = [k for k in range(count) if free.path not in {one.path for one in single[k]}]
        rows += [(numbered(free, k), [k]) for k in having] if free.of_measurement else [(free, having)]
    rows += [(numbered(free, k, "@"), [k]) for k, given in enumerate(single) for free in given]
    asked = len(rows)
    rows += [(numbered(free, k), [k]) for k, given in enumerate(own) for free in given]
    columns = [tuple(number for number, (_, films) in enumerate(rows) if k in films) for k in range(count)]
    return tuple(free for free, _ in rows), asked, columns


class Marginal(Unknowns):
    """A problem in the free parameters; the other unknowns are integrated out around an optimum.

    The residuals are linear in the others, or nearly so. Their part of the residuals is projected out, so that r.r is
    the sum of squares at their best values, and J^T J the marginal precision.
    """

    def __init__(self, problem: FilamentProblem, best: Optimum) -> None:
        self._problem, self._best = problem, best.q
        self.free, self.noise_known = problem.free[: problem.asked], problem.noise_known
        asked, others = best.jacobian[:, : problem.asked], best.jacobian[:, problem.asked :]
        # Derivative of the others' best values by the free parameters.
        self._follow = -np.linalg.lstsq(others, asked, rcond=None)[0] if others.size else np.zeros((0, problem.asked))

    def residuals(self, q: Floats) -> Floats:
        """Residuals with the others projected out, shape (m,)."""
        return self.linearised(q)[0]

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals with the others projected out, and their derivatives, shape (m, k)."""
        count = q.size
        around = self._best[count:] + self._follow @ (q - self._best[:count])
        whole = np.clip(np.append(q, around), self._problem.lower, self._problem.upper)
        residuals, jacobian = self._problem.linearised(whole)
        if not (np.isfinite(residuals).all() and np.isfinite(jacobian).all()):
            return np.full(residuals.size, np.nan), np.full((residuals.size, count), np.nan)
        taken, _ = np.linalg.qr(jacobian[:, count:])
        left = np.column_stack([residuals, jacobian[:, :count]])
        left = left - taken @ (taken.T @ left)
        return left[:, 0], left[:, 1:]
