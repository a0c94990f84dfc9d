"""Likelihood of films: noise, camera and theory error as one Gaussian covariance of the readings of each film."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular

from softcat_sym.effects.theory_limits import theory_error
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene

# Relative change of the noise, and change of a correlation, at which the iterations for it end; and their number.
_SAME_NOISE, _ITERATIONS = 1e-3, 30
_SIGNIFICANT = 2.6  # Standard normal, 1 %
_MAX_CORRELATION = 0.98
_RANK = 1e-8  # Smallest significant singular value, as a share of the largest
_MEDIAN_TO_DEVIATION = 1.4826
# Smallest noise, as a share of the largest reading: cameras resolve no less, and the integration error is as large.
MIN_NOISE = 1e-4
FEWEST = 20
"""Smallest number of consecutive readings whose noise and its correlation can be estimated."""


@dataclass(frozen=True)
class Noise:
    """Noise of the readings."""

    deviation: float  # Of a reading without a stated error [m]; a factor of stated errors
    correlation: float = 0.0  # Of neighbouring readings

    def differs(self, other: Noise, share: float) -> bool:
        """Whether another noise differs by more than a share."""
        ratio = self.deviation / other.deviation
        return abs(math.log(ratio)) > share or abs(self.correlation - other.correlation) > share


@dataclass(frozen=True, eq=False)
class Covariance:
    """Covariance of the differences between readings and model, and its Cholesky factor."""

    noise: Floats  # shape (n, n); [m^2]
    camera: Floats  # shape (n, c); Change of the readings by one standard deviation of each parameter of the camera
    theory: Floats  # shape (n, n); Covariance of the theory's error

    @cached_property
    def systematic(self) -> Floats:
        """Covariance of the errors of camera and theory, shape (n, n)."""
        return np.asarray(self.camera @ self.camera.T + self.theory)

    @cached_property
    def whitening(self) -> Floats:
        """Inverse of the lower Cholesky factor, shape (n, n).

        Each whitened residual is an innovation: a residual less its prediction from those before, over its standard
        error.
        """
        root = np.linalg.cholesky(self.noise + self.systematic)
        return np.asarray(solve_triangular(root, np.eye(len(root)), lower=True))

    def whitened(self, rows: Floats) -> Floats:
        """Whitened rows, shape as given."""
        return np.asarray(self.whitening @ rows)

    def systematic_part(self, residuals: Floats) -> Floats:
        """Expectation of the errors of camera and theory, given the residuals, shape (n,)."""
        return np.asarray(self.systematic @ (self.whitening.T @ (self.whitening @ residuals)))

    def camera_part(self, residuals: Floats, slopes: Floats, covariance: Floats) -> tuple[Floats, Floats]:
        """Expectation and variance of the camera's parameters in standard deviations, given the fit, shape (c,).

        The residuals are model less readings; `covariance` is that of the unknowns, by which `slopes` are.
        """
        seen, unexplained = self.whitened(self.camera), np.eye(self.camera.shape[1])
        mixed = seen.T @ self.whitened(slopes)
        variance = np.diag(unexplained - seen.T @ seen + mixed @ covariance @ mixed.T)
        return -seen.T @ self.whitened(residuals), variance

    def excess(self, whitened: Floats) -> tuple[float, float]:
        """Squares of the errors of camera and theory over their variances, and the number of them that the film shows.

        It is chi^2 with so many degrees of freedom, or less, if the errors are as large as expected.
        """
        root = self.whitening
        shown = float(np.sum((root @ self.systematic) * root))
        return float(whitened @ (root @ (self.systematic @ (root.T @ whitened)))), shown


@dataclass(frozen=True, eq=False)
class Errors:
    """What is known of the errors of a film's readings: all but the size of the noise, if that is not stated."""

    unit: Floats  # shape (n,); Standard errors as stated; one where they are not
    time: Floats  # shape (count,); Of the readings of the midpoint, whose noise may be correlated [s]
    camera: Floats  # As in `Covariance`
    theory: Floats

    def covariance(self, noise: Noise) -> Covariance:
        """Covariance with a noise."""
        std, count = noise.deviation * self.unit, self.time.size
        covariance = np.diag(std**2)
        if noise.correlation and count > 1:
            frame = float(np.median(np.diff(self.time)))
            apart = np.abs(np.subtract.outer(self.time, self.time)) / frame
            covariance[:count, :count] = np.outer(std[:count], std[:count]) * noise.correlation**apart
        return Covariance(covariance, self.camera, self.theory)


_FALLEN = 2.1462  # (1 + s) exp(-s) is 1/e here


@dataclass(frozen=True)
class Discrepancy:
    """Error of a theory, h(t) = (1 + a(t)) y((1 + b(t)) t) of the continuum's y: a slow change of height and of pace.

    Both a and b are independent Gaussian processes of log t, with paths that have one derivative and an autocorrelation
    of (1 + s) exp(-s), s = 2.146 |log t - log t'|/correlation (Matern's, order 3/2; Rasmussen & Williams 2006, 4.2.1).
    """

    amplitude: float  # Standard deviation of a and of b
    correlation: float = 1.0  # Difference of log t over which their autocorrelation falls to 1/e

    def covariance(self, time: Floats, heights: Floats, rates: Floats) -> Floats:
        """Covariance of the error at times since the onset of gravity, shape (n, n).

        It is amplitude^2 (1 + s) exp(-s) (h h' + t h_t t' h_t') for heights h of the model and their rates h_t; before
        the onset there is no error of pace. A change of a frequency moves heights as an error of pace does.
        """
        logarithm = np.log(np.maximum(time, np.finfo(float).tiny))
        apart = _FALLEN * np.abs(np.subtract.outer(logarithm, logarithm)) / self.correlation
        pace = np.maximum(time, 0.0) * rates
        both = np.outer(heights, heights) + np.outer(pace, pace)
        return np.asarray(self.amplitude**2 * (1 + apart) * np.exp(-apart) * both)


_CORRELATION_LENGTH = 1 / 8  # Over the span: a hinge is a few thicknesses long


def shape_covariance(place: Floats, span: float) -> Floats:
    """Covariance of the relative errors of two points of a shape over that of the midpoint, shape (n, n).

    It is 1 + k(x, x') - k(x, 0) k(0, x') at places x from halfway between the supports (NaN of a midpoint), where k is
    Gaussian with a standard deviation of an eighth of the span; the same on both sides of the midpoint. Elements sag
    less by some share everywhere, and near their clamps by up to twice of it.
    """
    x = np.abs(np.nan_to_num(place)) / (span * _CORRELATION_LENGTH)
    beside = np.exp(-0.5 * x**2)
    return np.asarray(1 + np.exp(-0.5 * np.subtract.outer(x, x) ** 2) - np.outer(beside, beside))


def discrepancy(scene: Scene, effects: Collection[str], terms: Terms) -> Discrepancy:
    """Return the error of a theory against the continuum, as large as :func:`theory_error` says of a best estimate."""
    return Discrepancy(theory_error(scene, effects, terms))


def theory_covariance(
    error: Discrepancy, time: Floats, place: Floats, heights: Floats, rates: Floats, span: float
) -> Floats:
    """Covariance of the theory's error in heights, at times, and places that are NaN of a midpoint, shape (n, n).

    Points of a shape err by a share that changes along it, and in time as that of the deepest point.
    """
    times, row, deepest = deepest_points(time, heights)
    scale = np.where(heights[deepest] == 0, 1.0, heights[deepest])
    shares = error.covariance(times, heights[deepest], rates[deepest]) / np.outer(scale, scale)
    along = np.outer(heights, heights) * (1.0 if np.isnan(place).all() else shape_covariance(place, span))
    return np.asarray(shares[np.ix_(row, row)] * along)


def deepest_points(time: Floats, heights: Floats) -> tuple[Floats, NDArray[np.int_], NDArray[np.int_]]:
    """The times, the number of the time of every reading, and the reading farthest from zero at each time."""
    times, row = np.unique(time, return_inverse=True)
    order = np.lexsort((np.abs(heights), row))
    return times, row, order[np.append(np.flatnonzero(np.diff(row[order])), row.size - 1)[: row.size]]


@dataclass(frozen=True, eq=False)
class Residuals:
    """The residuals of a film, and the errors in them."""

    errors: Errors
    values: Floats  # shape (n,); Model less reading [m]
    slopes: Floats  # shape (n, k); Derivatives by the unknowns


def estimate_noise(
    noise: Noise, films: Sequence[Residuals], others: Floats, *, stated: bool, least: float, correlated: bool = True
) -> Noise:
    """Estimate the noise from the residuals at an optimum, by restricted maximum likelihood.

    (Patterson & Thompson 1971.) The correlation is changed until innovations are not correlated.

    Parameters
    ----------
    noise : Noise
        First guess.
    films : sequence of Residuals
        At the optimum.
    others : ndarray, shape (m, k)
        Derivatives of further residuals in standard errors, such as those of a flow curve.
    stated, least : bool, float
        Whether errors are stated; the least noise.
    correlated : bool
        Whether the correlation may change.
    """
    for _ in range(_ITERATIONS):
        covariances = [one.errors.covariance(noise) for one in films]
        white = [one.whitened(film.values) for one, film in zip(covariances, films, strict=True)]
        slopes = [one.whitened(film.slopes) for one, film in zip(covariances, films, strict=True)]
        left, sizes, _ = np.linalg.svd(np.vstack([*slopes, others]), full_matrices=False)
        basis = left[:, sizes > _RANK * max(sizes[0], np.finfo(float).tiny)]
        squares, free, begin, found = 0.0, 0.0, 0, noise
        for one, part in zip(covariances, white, strict=True):
            score = one.whitening.T @ part
            taken = basis[begin : begin + part.size].T @ one.whitening
            squares += float(score @ one.noise @ score)
            free += _trace(one.whitening, one.noise) - _trace(taken, one.noise)
            begin += part.size
        if not stated:
            found = replace(found, deviation=max(noise.deviation * math.sqrt(squares / max(free, 1.0)), least))
        if correlated and (stated or found.deviation > least):
            rows = [part[: film.errors.time.size] for part, film in zip(white, films, strict=True)]
            found = replace(found, correlation=_correlation(noise.correlation, rows, basis.shape[1]))
        same, noise = not noise.differs(found, _SAME_NOISE), found
        if same:
            break
    return noise


def _trace(root: Floats, variances: Floats) -> float:
    """Trace of R V R^T; the variances are mostly diagonal."""
    diagonal = np.diag(variances)
    if np.count_nonzero(variances) == np.count_nonzero(diagonal):
        return float(np.sum(root**2 @ diagonal))
    return float(np.sum((root @ variances) * root))


def _correlation(former: float, rows: Sequence[Floats], unknowns: int) -> float:
    """Correlation of neighbouring readings by their innovations; the former one if these are not correlated."""
    rows = [row for row in rows if row.size >= FEWEST and np.any(row)]
    if not rows:
        return former
    size, squares = sum(row.size for row in rows), sum(float(row @ row) for row in rows)
    # The fitted parameters make neighbouring residuals anticorrelated by their share of the degrees of freedom.
    left = sum(float(row[1:] @ row[:-1]) for row in rows) / squares + unknowns / size
    if abs(left) * math.sqrt(size) < _SIGNIFICANT:
        return former
    return float(np.clip((former + left) / (1 + former * left), 0.0, _MAX_CORRELATION))


def noise_from_differences(rows: Sequence[Floats], largest: float) -> float:
    """Standard deviation of noise in rows of readings, from second differences, to which a smooth motion adds little.

    It is a hundredth of the largest reading if all rows are short.
    """
    differences = [np.diff(row, 2) for row in rows if row.size >= FEWEST]
    if not differences:
        return 0.01 * largest
    found = _MEDIAN_TO_DEVIATION * float(np.median(np.abs(np.concatenate(differences)))) / math.sqrt(6)
    return max(found, MIN_NOISE * largest)
