"""Residuals of films against their models, whitened by the covariance of noise, camera and theory error."""

from __future__ import annotations

import copy
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from scipy import stats
from scipy.interpolate import make_interp_spline, make_smoothing_spline

from softcat_sym.error_control.estimate import Resolution
from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.flow_curve import FlowCurve
from softcat_sym.fitting.flow_readings import FlowReadings
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import INITIAL_SAG, TIME_OFFSET, FreeParameter, Unknowns, free_parameters
from softcat_sym.fitting.identifiability import Statistic
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.fitting.likelihood import (
    FEWEST,
    MIN_NOISE,
    Covariance,
    Errors,
    Noise,
    Residuals,
    deepest_points,
    discrepancy,
    estimate_noise,
    noise_from_differences,
    theory_covariance,
)
from softcat_sym.fitting.measurements import Measurements, Series
from softcat_sym.fitting.plausibility import own_scene
from softcat_sym.interrupts import until
from softcat_sym.scene.scene import Scene

SCALE, TILT = "scale", "tilt"
CAMERA = {SCALE: 0.02, INITIAL_SAG: 0.02, TIME_OFFSET: 1.0, TILT: math.radians(1)}
"""Standard deviations of a camera's parameters, unless it is said to be calibrated.

The scale is a share, the sag at the start a share of the largest height, the clock in frames, the tilt in radians.
"""

_RANK = 1e-6  # Smallest significant singular value, as a share of the largest


def camera_spread(film: Series) -> dict[str, float]:
    """Standard deviations of the parameters of a film's camera: a share, [m], [s], [rad]."""
    shapes = film.shapes
    times, heights = film.time, film.midpoint
    if shapes is not None:
        times, heights = np.append(times, shapes.time), np.append(heights, shapes.y)
    times, largest = np.unique(times), float(np.max(np.abs(heights), initial=0.0))
    found = {SCALE: CAMERA[SCALE], INITIAL_SAG: CAMERA[INITIAL_SAG] * largest, TILT: CAMERA[TILT]}
    if shapes is None:
        del found[TILT]
    else:
        found[INITIAL_SAG] = math.hypot(found[INITIAL_SAG], shapes.level_std)
        if shapes.shows_supports:
            # Supports in the same picture are its ruler.
            del found[SCALE]
    return found | ({TIME_OFFSET: CAMERA[TIME_OFFSET] * float(np.median(np.diff(times)))} if times.size > 1 else {})


@dataclass(frozen=True, eq=False)
class FilmReadings:
    """All readings of one film, of the midpoint and then of shapes; the model of its filament; their errors."""

    series: Series
    time: Floats  # shape (n,); [s]
    place: Floats  # shape (n,); [m]; NaN except for points of shapes
    data: Floats  # shape (n,); [m]
    model: ForwardModel  # Its last unknown may be a clock that is not free
    columns: tuple[int, ...]  # Number in the problem of each free unknown of the model
    camera: Mapping[str, float]  # Standard deviations of the parameters of the camera that are not free
    noise: Noise
    errors: Errors
    theory_error: float = 0.0  # Standard deviation of the theory's error over the heights
    # Reading of the clock at the release, about which its error is linear [s], and what that adds to the values, (n,).
    clock: float = 0.0
    by_clock: Floats | float = 0.0

    @cached_property
    def covariance(self) -> Covariance:
        """Covariance of the readings about the model."""
        return self.errors.covariance(self.noise)

    @property
    def std(self) -> Floats:
        """Standard errors of the readings, shape (n,)."""
        return self.noise.deviation * self.errors.unit

    @property
    def name(self) -> str:
        """Label of the film, or the name of its file; empty if it has neither."""
        return self.series.label or (self.series.path.name if self.series.path else "")

    def own(self, q: Floats) -> Floats:
        """The unknowns of the model, from those of the whole problem."""
        clocks = self.model.free[len(self.columns) :]
        return np.append(q[list(self.columns)], [one.scaled(self.clock) for one in clocks])

    def scene(self, q: Floats) -> Scene:
        """The scene of this filament with the values of the unknowns."""
        return self.model.scene(self.own(q))

    def run_scene(self, q: Floats) -> tuple[Scene, float]:
        """That scene with its effects and its filmed duration, and the release on the camera's clock [s]."""
        scene, begin = self.scene(q), self.model.release(self.own(q))
        lasts = max(float(self.time.max()) - begin, 1e-6 * scene.run.duration)
        return scene.replace({"run.effects": list(self.model.effects), "run.duration": f"{lasts!r} s"}), begin

    def values(self, q: Floats) -> Floats:
        """Values of the model at every reading [m], shape (n,)."""
        own, shapes = self.own(q), self.series.shapes
        parts = [self.model.midpoints(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x)[0])
        return np.asarray(np.concatenate(parts) + self.by_clock)

    def linearised(self, q: Floats) -> tuple[Floats, Floats, Floats]:
        """Values of the model, shape (n,), derivatives by the unknowns of the problem, (n, k), and by time, (n,)."""
        own, shapes = self.own(q), self.series.shapes
        parts = [self.model.with_derivatives(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x))
        values, by_own = (np.concatenate(column) for column in zip(*parts, strict=True))
        slopes, rates = np.zeros((self.data.size, q.size)), np.zeros(self.data.size)
        slopes[:, list(self.columns)] = by_own[:, : len(self.columns)]
        for k, one in enumerate(self.model.free):
            if one.path == TIME_OFFSET:
                rates = -by_own[:, k] / one.scale
        return values + self.by_clock, slopes, rates

    def with_errors(self, scene: Scene, values: Floats, *, theory: bool, by_time: Floats | None = None) -> FilmReadings:
        """The film with the errors of camera and theory for heights [m] of a scene.

        An error of the clock acts by the derivatives by time, by default those of the values.
        """
        rates = self._rates(values)
        changes = {
            SCALE: values,
            INITIAL_SAG: np.ones(values.size),
            TILT: np.nan_to_num(self.place),
            TIME_OFFSET: -(rates if by_time is None else by_time),
        }
        columns = [spread * changes[name] for name, spread in self.camera.items()]
        camera = np.array(columns).reshape(len(columns), values.size).T
        covariance, error = np.zeros((values.size, values.size)), 0.0
        if theory:
            known = discrepancy(scene, self.model.effects, self.model.terms)
            error = known.amplitude
            covariance = theory_covariance(known, self.time, self.place, values, rates, scene.filament.span)
        return replace(self, errors=replace(self.errors, camera=camera, theory=covariance), theory_error=error)

    def _rates(self, values: Floats) -> Floats:
        """Rates of values [m/s] by a cubic spline; of a shape in proportion to its deepest point's."""
        found, count = np.zeros(values.size), self.series.time.size
        for rows in (slice(0, count), slice(count, values.size)):
            times, row, deepest = deepest_points(self.time[rows], values[rows])
            if times.size > 1:
                track = values[rows][deepest]
                rates = make_interp_spline(times, track, k=min(3, times.size - 1)).derivative()(times)
                share = values[rows] / np.where(track == 0, np.inf, track)[row] if row.size > times.size else 1.0
                found[rows] = rates[row] * share
        return found

    def smooth_readings(self) -> Floats:
        """Readings, smoothed where the midpoint was read often enough."""
        values, count = self.data.copy(), self.series.time.size
        if count >= FEWEST:
            values[:count] = make_smoothing_spline(self.series.time, self.series.midpoint)(self.series.time)
        return values

    def systematic_part(self, values: Floats) -> Floats:
        """Errors of camera and theory that the readings show, beside values of the model, shape (n,)."""
        return -self.covariance.systematic_part(values - self.data)


class FilamentProblem(Unknowns):
    """Whitened residuals of films in the free parameters: a problem of least squares.

    All filaments share the free parameters, except those of their cameras. Errors of the camera (:data:`CAMERA`) and of
    the theory (:class:`softcat_sym.fitting.likelihood.Discrepancy`) are part of the covariance, linear in the heights
    of the model, of which the readings are a first guess.

    `camera` and `theory` say whether it includes them; `noise` is by default a guess by second differences. The clock
    and the zero of the camera may be free: then they are unknowns like any other. An evaluation beyond the `deadline`
    of the monotonic clock ends with TimeLimitError.
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
        flow_curve: FlowCurve | None = None,
        deadline: float = math.inf,
    ) -> None:
        series = measurements.series
        scenes = [own_scene(film, scene) for film in series]
        self.free, columns = _unknowns(scene, series, names, bounds or {})
        self.flow = None if flow_curve is None else _flow_readings(flow_curve, scene, self.free)
        readings = [_readings(film) for film in series]
        self.noise_known = all(np.isfinite(stated).all() for *_, stated in readings)
        self.deadline, self._theory, self._scene = deadline, theory, scene
        largest = max(float(np.abs(data).max()) for _, _, data, _ in readings) or 1.0
        self.least_noise = MIN_NOISE * largest
        """Smallest noise that is assumed [m], even if the residuals are smaller."""
        if noise is None:
            guess = 1.0 if self.noise_known else noise_from_differences([film.midpoint for film in series], largest)
            noise = Noise(guess)
        self.noise = noise
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
        for film, one, places, (time, place, data, stated) in zip(series, scenes, columns, readings, strict=True):
            of_model = [self.free[number] for number in places]
            named = {free.path for free in of_model}
            spread = {name: size for name, size in camera_spread(film).items() if camera and name not in named}
            of_model += free_parameters(one, [TIME_OFFSET]) if TIME_OFFSET in spread else ()
            none = np.zeros((data.size, 0))
            unit = stated if self.noise_known else np.ones(data.size)
            made = FilmReadings(
                film,
                time,
                place,
                data,
                model=ForwardModel(one, of_model, film.time, backend, rtol),
                columns=places,
                camera=spread,
                noise=noise,
                errors=Errors(unit, film.time, none, none @ none.T),
            )
            films.append(made.with_errors(one, made.smooth_readings(), theory=theory))
        self.films = tuple(films)

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        """Which unknowns are logarithms."""
        return tuple(free.logarithmic for free in self.free)

    @property
    def unit(self) -> float:
        """Mean standard error of the readings [m]."""
        return float(np.mean(np.concatenate([film.std for film in self.films])))

    @property
    def systematic(self) -> float:
        """Degrees of freedom that the errors of camera and theory take from the readings."""
        return sum(film.covariance.excess(np.zeros(film.data.size))[1] for film in self.films)

    def residuals(self, q: Floats) -> Floats:
        """Whitened residuals of all films, then those of a flow curve, shape (m,); NaN where there is no answer."""
        with until(self.deadline):
            parts = [film.covariance.whitened(film.values(q) - film.data) for film in self.films]
        return np.concatenate([*parts, *([] if self.flow is None else [self.flow.residuals(q)])])

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives, shape (m, k)."""
        residuals, rows = [], []
        for film in self.films:
            with until(self.deadline):
                values, slopes, _ = film.linearised(q)
            residuals.append(film.covariance.whitened(values - film.data))
            rows.append(film.covariance.whitened(slopes))
        if self.flow is not None:
            residuals.append(self.flow.residuals(q))
            rows.append(self.flow.slopes(q))
        return np.concatenate(residuals), np.concatenate(rows)

    def by_film(self, values: Floats) -> list[Floats]:
        """Split an array over all residuals, shape (m,), into one for each film, without a flow curve."""
        ends = np.cumsum([film.data.size for film in self.films])
        return [np.asarray(part) for part in np.split(values, ends)[:-1]]

    def values(self, q: Floats) -> dict[str, float]:
        """The unknowns in SI."""
        return {free.name: free.value(float(x)) for free, x in zip(self.free, q, strict=True)}

    def at(self, resolution: Resolution) -> FilamentProblem:
        """The problem at another resolution, with the same errors."""
        made = self._with(scene=resolution.of(self._scene), noise=self.noise)
        made.films = tuple(
            replace(former, model=film.model) for film, former in zip(made.films, self.films, strict=True)
        )
        return made

    def updated(self, q: Floats, *, correlated: bool = True, renewed: bool = True) -> FilamentProblem:
        """The problem with the noise at an optimum and, if renewed, the errors of camera and theory there."""
        with until(self.deadline):
            films = [self._renewed(film, q) if renewed else film for film in self.films]
            linearised = [film.linearised(q) for film in films]
        others = np.zeros((0, q.size)) if self.flow is None else self.flow.slopes(q)
        residuals = [
            Residuals(film.errors, values - film.data, slopes)
            for film, (values, slopes, _) in zip(films, linearised, strict=True)
        ]
        how = {"stated": self.noise_known, "correlated": correlated}
        made = copy.copy(self)
        made.noise = estimate_noise(self.noise, residuals, others, least=self.least_noise, **how)
        made.films = tuple(replace(film, noise=made.noise) for film in films)
        return made

    def _renewed(self, film: FilmReadings, q: Floats) -> FilmReadings:
        """The film with the errors of camera and theory at an optimum.

        The theory's is about the filament of the film, which a change of constants hardly moves; the clock's about the
        reading that the film shows, as the filament falls far within a frame.
        """
        values, slopes, rates = film.linearised(q)
        shown = values + film.systematic_part(values)
        if TIME_OFFSET in film.camera:
            none = np.zeros((q.size, q.size))
            means, _ = film.covariance.camera_part(values - film.data, slopes, none)
            clock = film.camera[TIME_OFFSET] * float(means[list(film.camera).index(TIME_OFFSET)])
            film = replace(film, clock=clock, by_clock=0.0)
            rates = film.linearised(q)[2]
            film = replace(film, by_clock=rates * clock)
        return film.with_errors(film.scene(q), shown, theory=self._theory, by_time=rates)

    def excess(self, residuals: Floats) -> float:
        """Probability of larger errors of camera and theory than the films show; one without them."""
        parts = zip(self.films, self.by_film(residuals), strict=True)
        squares, freedom = np.sum([film.covariance.excess(part) for film, part in parts], axis=0)
        return float(stats.chi2.sf(squares, freedom)) if freedom > 0 else 1.0

    def camera_at(self, q: Floats, covariance: Floats) -> dict[str, tuple[float, float, float]]:
        """Value, standard error and standard deviation beforehand of each parameter of the cameras; SI."""
        found = {}
        for number, film in enumerate(self.films, start=1):
            values, slopes, _ = film.linearised(q)
            parts = film.covariance.camera_part(values - film.data, slopes, covariance)
            rows = zip(film.camera.items(), *parts, strict=True)
            for (name, spread), value, variance in rows:
                at = float(name == SCALE) + spread * float(value)
                key = f"{name}_{number}" if len(self.films) > 1 else name
                found[key] = (at, spread * math.sqrt(max(float(variance), 0.0)), spread)
        return found

    def contradiction(self, residuals: Floats, jacobian: Floats) -> Statistic | None:
        """Test whether films and flow curve have the same constants; None without a flow curve.

        The statistic is the amount by which separate fits of both would lower chi^2, to first order. Its degrees of
        freedom are the ranks of both alone less the rank of both together (Maltoni & Schwetz 2003).
        """
        if self.flow is None:
            return None
        of_curve = np.arange(residuals.size) >= residuals.size - self.flow.std.size
        fall, ranks = 0.0, 0
        for part, known in ((of_curve, self.flow.known), (~of_curve, self.noise_known)):
            left, size, _ = np.linalg.svd(jacobian[part], full_matrices=False)
            basis = left[:, size > _RANK * max(float(size[0]), 1.0)]
            explained = float(np.sum((basis.T @ residuals[part]) ** 2))
            remaining = float(residuals[part] @ residuals[part]) - explained
            freedom = max(int(part.sum()) - basis.shape[1], 1)
            # An estimated noise is taken from each part alone, without the contradiction.
            fall += explained / (1.0 if known else max(remaining / freedom, MIN_NOISE))
            ranks += basis.shape[1]
        freedom = max(ranks - int(np.linalg.matrix_rank(jacobian, tol=_RANK * float(np.linalg.norm(jacobian, 2)))), 1)
        return Statistic("films against flow curve", fall, float(stats.chi2.sf(fall, freedom)))


def _readings(series: Series) -> list[Floats]:
    """Times, places (NaN of a midpoint), heights and stated errors (NaN without) of all readings of one film."""
    none = np.full(series.time.size, np.nan)
    rows = [series.time, none, series.midpoint, none if series.std is None else series.std]
    if (shapes := series.shapes) is not None:
        stated = np.full(shapes.time.size, np.nan) if shapes.std is None else shapes.std
        more = (shapes.time, shapes.x, shapes.y, stated)
        rows = [np.concatenate(pair) for pair in zip(rows, more, strict=True)]
    return rows


def _flow_readings(curve: FlowCurve, scene: Scene, free: Sequence[FreeParameter]) -> FlowReadings:
    pairs = [(k, one) for k, one in enumerate(free) if one.path.startswith("material.")]
    return FlowReadings.of(curve, scene, [one for _, one in pairs], [k for k, _ in pairs])


def _unknowns(
    scene: Scene, series: Sequence[Series], names: Sequence[str], bounds: Mapping[str, tuple[object, object]]
) -> tuple[tuple[FreeParameter, ...], list[tuple[int, ...]]]:
    """All unknowns, and the numbers of those of each film: parameters of a camera are of one film each."""
    common, films = free_parameters(scene, names, bounds), range(1, len(series) + 1)
    faults = [
        Fault(f"free {free.name}", f"set by {film.path or 'a series'} itself", "a parameter that no film sets")
        for free in common
        for film in series
        if free.path in film.overrides
    ]
    if faults:
        raise SceneError(faults)
    unknowns = list[FreeParameter]()
    for free in common:
        several = free.of_measurement and len(films) > 1
        unknowns += [replace(free, name=f"{free.name}_{k}", film=k) for k in films] if several else [free]
    return tuple(unknowns), [tuple(n for n, one in enumerate(unknowns) if one.film in (None, k)) for k in films]
