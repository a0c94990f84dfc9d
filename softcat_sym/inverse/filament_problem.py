"""Filmed filaments of one material as one least-squares problem."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.errors import Fault, SceneError
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.forward.free import FreeParameter, free_parameters
from softcat_sym.inverse.forward.model import ForwardModel
from softcat_sym.inverse.forward.unknowns import Unknowns
from softcat_sym.inverse.measurements.plausibility import own_scene
from softcat_sym.inverse.measurements.series import Measurements, Series
from softcat_sym.scene import Scene


@dataclass(frozen=True, eq=False)
class Filmed:
    """One series, the model of its filament, and which unknowns of the problem that model has.

    Attributes
    ----------
    series : Series
        What was measured.
    model : ForwardModel
        What it is compared with.
    columns : tuple of int
        For each unknown of the model its number in the problem.
    time : ndarray, shape (n,)
        Of every reading [s]: those of the midpoint, then the points of whole shapes.
    place : ndarray, shape (n,)
        Distance of a point of a shape from halfway between the supports [m]; NaN of a midpoint.
    data : ndarray, shape (n,)
        Heights [m].
    std : ndarray, shape (n,)
        By which residuals are divided [m].
    """

    series: Series
    model: ForwardModel
    columns: tuple[int, ...]
    time: Floats
    place: Floats
    data: Floats
    std: Floats

    def heights(self, q: Floats) -> Floats:
        """What the model says at every reading [m], shape (n,), of the unknowns of the whole problem."""
        own, shapes = q[list(self.columns)], self.series.shapes
        parts = [self.model.midpoints(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x)[0])
        return np.concatenate(parts)

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """The same with derivatives by the unknowns of the whole problem, shape (n, k)."""
        own, shapes = q[list(self.columns)], self.series.shapes
        parts = [self.model.with_derivatives(own)] if self.series.time.size else []
        if shapes is not None:
            parts.append(self.model.shapes(own, shapes.time, shapes.x))
        slopes = np.zeros((self.data.size, q.size))
        slopes[:, list(self.columns)] = np.concatenate([part[1] for part in parts])
        return np.concatenate([part[0] for part in parts]), slopes


class FilamentProblem(Unknowns):
    """(model - measured)/standard error of all readings: a problem of least squares.

    Every filament shares the unknowns of the material; each camera has its own `time_offset` and `initial_sag`, with
    the number of the film behind their names where there are several.

    Parameters
    ----------
    scene : Scene
        Common to all filaments.
    measurements : Measurements
        One series for each filament.
    names : sequence of str
        What is free, as :func:`softcat_sym.inverse.forward.free.free_parameters` takes it.
    bounds : mapping, optional
        Likewise.
    backend : str
        Of the forward model.
    rtol : float, optional
        Likewise.

    Attributes
    ----------
    free : tuple of FreeParameter
        The k unknowns.
    films : tuple of Filmed
        The series with their models.
    noise_known : bool
        Whether every series states its standard errors; otherwise residuals are in units of the largest height.

    Raises
    ------
    SceneError
        If a name cannot be free, or a film sets what is free.
    """

    def __init__(
        self,
        scene: Scene,
        measurements: Measurements,
        names: Sequence[str],
        bounds: Mapping[str, tuple[object, object]] | None = None,
        backend: str = "auto",
        rtol: float | None = None,
    ) -> None:
        common = free_parameters(scene, names, bounds)
        series = measurements.series
        _refuse_what_is_set(common, series)
        self.free, columns = _unknowns(common, len(series))
        readings = [_readings(one) for one in series]
        self.noise_known = all(std is not None for *_, std in readings)
        unit = max(float(np.max(np.abs(data))) for *_, data, _ in readings)
        self.films = tuple(
            Filmed(
                series=one,
                model=ForwardModel(own_scene(one, scene), common, one.time, backend, rtol),
                columns=places,
                time=time,
                place=place,
                data=data,
                std=std if self.noise_known and std is not None else np.full(data.size, unit),
            )
            for one, places, (time, place, data, std) in zip(series, columns, readings, strict=True)
        )

    @property
    def logarithmic(self) -> tuple[bool, ...]:
        """Which unknowns are logarithms."""
        return tuple(one.logarithmic for one in self.free)

    @property
    def unit(self) -> float:
        """What a residual of one is [m]; where the errors are known they differ, and it is their mean."""
        return float(np.mean(np.concatenate([film.std for film in self.films])))

    @property
    def complaint(self) -> str:
        """Why the last evaluation has no answer; empty if it has."""
        return "; ".join(film.model.complaint for film in self.films if film.model.complaint)

    def residuals(self, q: Floats) -> Floats:
        """(model - datum)/standard error of all films, shape (m,); NaN where the model has no answer."""
        return np.concatenate(
            [(found - film.data) / film.std for film, found in zip(self.films, self.curves(q), strict=True)]
        )

    def curves(self, q: Floats) -> list[Floats]:
        """What the model says at the readings of each film [m]."""
        return [film.heights(q) for film in self.films]

    def linearised(self, q: Floats) -> tuple[Floats, Floats]:
        """Residuals, shape (m,), and their derivatives, shape (m, k)."""
        residuals, rows = [], []
        for film in self.films:
            found, slopes = film.linearised(q)
            residuals.append((found - film.data) / film.std)
            rows.append(slopes / film.std[:, None])
        return np.concatenate(residuals), np.concatenate(rows)

    def by_film(self, values: Floats) -> list[Floats]:
        """Split what all films have, shape (m,), into one array for each."""
        ends = np.cumsum([film.data.size for film in self.films])[:-1]
        return [np.asarray(part) for part in np.split(values, ends)]


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


def _refuse_what_is_set(free: Sequence[FreeParameter], series: Sequence[Series]) -> None:
    """A film that has a free parameter's value of its own leaves nothing to fit there."""
    faults = [
        Fault(f"free {one.name}", f"set by {film.path or 'a series'} itself", "free it, or set it, not both")
        for one in free
        for film in series
        if one.path in film.overrides
    ]
    if faults:
        raise SceneError(faults)


def _unknowns(common: tuple[FreeParameter, ...], films: int) -> tuple[tuple[FreeParameter, ...], list[tuple[int, ...]]]:
    """All unknowns, and for each film the numbers of its own."""
    unknowns: list[FreeParameter] = []
    columns: list[list[int]] = [[] for _ in range(films)]
    for one in common:
        for k in range(films):
            if k == 0 or one.of_measurement:
                alone = films == 1 or not one.of_measurement
                unknowns.append(one if alone else replace(one, name=f"{one.name}_{k + 1}"))
            columns[k].append(len(unknowns) - 1)
    return tuple(unknowns), [tuple(numbers) for numbers in columns]
