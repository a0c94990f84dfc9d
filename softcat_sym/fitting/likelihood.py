"""Likelihood of films: noise, camera and theory error as one Gaussian covariance of the readings of each film."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.discrepancy import Discrepancy, shape_covariance
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.fitting.measurements import Series

# Relative change of the noise, and change of a correlation, at which the iterations for it end; and their number.
_SAME_NOISE, _ITERATIONS = 1e-3, 30
_SIGNIFICANT = 2.6  # Standard normal, 1 %
_MAX_CORRELATION = 0.98
_RANK = 1e-8  # Smallest significant singular value, as a share of the largest
_MEDIAN_TO_DEVIATION = 1.4826
# Smallest mean slope of psi: below it nearly all readings count as outliers.
_MIN_SLOPE = 1e-3
# Smallest noise, as a share of the largest reading: cameras resolve no less, and the integration error is as large.
MIN_NOISE = 1e-4
FEWEST = 20
"""Smallest number of consecutive readings whose noise and its correlation can be estimated."""


@dataclass(frozen=True)
class Loss:
    """Loss rho of a reading's residual in standard errors, with z = (r/scale)^2.

    ``"linear"``: rho = r^2. ``"soft-l1"``: rho = 2 scale^2 (sqrt(1 + z) - 1). ``"cauchy"``: rho = scale^2 log(1 + z).
    Outliers beyond `scale` weigh less (Triggs et al. 2000, section 3; the forms are those of SciPy).
    """

    kind: Literal["linear", "soft-l1", "cauchy"] = "linear"
    scale: float = 1.0  # Residual from which on a reading counts as an outlier, in standard errors

    def __post_init__(self) -> None:
        if self.kind not in ("linear", "soft-l1", "cauchy"):
            raise SoftcatError(f"no loss {self.kind!r}; accepted: linear, soft-l1, cauchy")
        if not 0 < self.scale < math.inf:
            raise SoftcatError(f"the scale of a loss is {self.scale!r}; accepted: a positive number")

    @property
    def is_robust(self) -> bool:
        """Whether outliers weigh less."""
        return self.kind != "linear"

    def value(self, residuals: Floats) -> float:
        """1/2 sum rho(r^2)."""
        z = (residuals / self.scale) ** 2
        # These forms avoid cancellation for small residuals.
        rho = {"linear": z, "soft-l1": 2 * z / (np.sqrt(1 + z) + 1), "cauchy": np.log1p(z)}[self.kind]
        return 0.5 * self.scale**2 * float(rho.sum())

    def psi(self, residuals: Floats) -> Floats:
        """psi(r) = rho'(r^2) r, shape as given: the residual as it counts."""
        z = (residuals / self.scale) ** 2
        weights = {"linear": np.ones_like(z), "soft-l1": 1 / np.sqrt(1 + z), "cauchy": 1 / (1 + z)}[self.kind]
        return np.asarray(weights * residuals)

    def slopes(self, residuals: Floats) -> Floats:
        """Derivative of psi, shape as given; negative for Cauchy's outliers."""
        z = (residuals / self.scale) ** 2
        return {"linear": np.ones_like(z), "soft-l1": (1 + z) ** -1.5, "cauchy": (1 - z) / (1 + z) ** 2}[self.kind]


LINEAR = Loss()


@dataclass(frozen=True)
class Noise:
    """Noise of the readings."""

    deviation: float  # Of a height without a stated error [m]; a factor of stated errors
    of_force: float = 1.0  # Of a force [N], likewise
    correlation: float = 0.0  # Of neighbouring readings
    # Standard deviation of the winsorised readings of a robust loss over that of the readings.
    winsorised: float = 1.0

    def differs(self, other: Noise, share: float) -> bool:
        """Whether another noise differs by more than a share."""
        names = ("deviation", "of_force", "winsorised")
        ratios = [getattr(self, name) / getattr(other, name) for name in names]
        return max(abs(math.log(one)) for one in ratios) > share or abs(self.correlation - other.correlation) > share


@dataclass(frozen=True, eq=False)
class Covariance:
    """Covariance of the differences between readings and model, and its Cholesky factor."""

    noise: Floats  # shape (n, n); [m^2], [N^2]
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
    is_force: NDArray[np.bool_]  # shape (n,)
    time: Floats  # shape (count,); Of the readings of the midpoint, whose noise may be correlated [s]
    camera: Floats  # As in `Covariance`
    theory: Floats

    def std(self, noise: Noise) -> Floats:
        """Standard errors of the readings, shape (n,)."""
        return np.asarray(self.unit * np.where(self.is_force, noise.of_force, noise.deviation))

    def covariance(self, noise: Noise) -> Covariance:
        """Covariance with a noise."""
        std, count = noise.winsorised * self.std(noise), self.time.size
        covariance = np.diag(std**2)
        if noise.correlation and count > 1:
            frame = float(np.median(np.diff(self.time)))
            apart = np.abs(np.subtract.outer(self.time, self.time)) / frame
            covariance[:count, :count] = np.outer(std[:count], std[:count]) * noise.correlation**apart
        return Covariance(covariance, self.camera, self.theory)


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
    values: Floats  # shape (n,); Model less reading [m], [N]
    slopes: Floats  # shape (n, k); Derivatives by the unknowns


@dataclass(frozen=True, eq=False)
class NoiseEstimate:
    """The noise, and what a robust loss makes of the residuals."""

    noise: Noise
    residuals: list[Floats]  # Of each film [m], [N]; winsorised by a robust loss


def estimate_noise(
    noise: Noise,
    films: Sequence[Residuals],
    others: Floats,
    *,
    stated: tuple[bool, bool],
    least: tuple[float, float],
    loss: Loss = LINEAR,
    correlated: bool = True,
) -> NoiseEstimate:
    """Estimate the noise from the residuals at an optimum, by restricted maximum likelihood.

    (Patterson & Thompson 1971.) The correlation is changed until innovations are not correlated. A robust loss has the
    residuals r of
    readings replaced by psi(r)/<psi'>: the optimum of the least squares of these is that of the loss, and their noise
    gives its standard errors (Huber 1981, sections 7.6 and 7.8).

    Parameters
    ----------
    noise : Noise
        First guess.
    films : sequence of Residuals
        At the optimum.
    others : ndarray, shape (m, k)
        Derivatives of further residuals in standard errors, such as those of a flow curve.
    stated, least : tuple
        Whether errors are stated, and the least noise: of heights and of forces.
    loss : Loss
        The loss of a reading.
    correlated : bool
        Whether the correlation may change.
    """
    residuals = [one.values for one in films]
    for number in range(_ITERATIONS):
        covariances = [one.errors.covariance(noise) for one in films]
        white = [one.whitened(part) for one, part in zip(covariances, residuals, strict=True)]
        slopes = [one.whitened(film.slopes) for one, film in zip(covariances, films, strict=True)]
        left, sizes, _ = np.linalg.svd(np.vstack([*slopes, others]), full_matrices=False)
        basis = left[:, sizes > _RANK * max(sizes[0], np.finfo(float).tiny)]
        ends, found = np.cumsum([0, *(part.size for part in white)]), noise
        ratios = list[float]()
        for force, name in enumerate(("deviation", "of_force")):
            squares, free, count = 0.0, 0.0, 0
            for k, (one, film) in enumerate(zip(covariances, films, strict=True)):
                which = film.errors.is_force == bool(force)
                if not which.any():
                    continue
                variances, root = one.noise[np.ix_(which, which)], one.whitening[:, which]
                score = root.T @ white[k]
                taken = basis[ends[k] : ends[k + 1]].T @ root
                squares += float(score @ variances @ score)
                free += _trace(root, variances) - _trace(taken, variances)
                count += int(which.sum())
            if not count:
                continue
            ratios.append(math.sqrt(squares / max(free, 1.0)))
            if not stated[force] and not loss.is_robust:
                former = getattr(noise, name)
                found = replace(found, **{name: max(former * ratios[-1], least[force])})
        if loss.is_robust:
            found = replace(found, winsorised=max(noise.winsorised * ratios[0], 1.0))
            found, residuals = _winsorised(found, covariances, films, residuals, stated, least, loss)
        elif correlated and (stated[0] or found.deviation > least[0]):
            rows = [part[: film.errors.time.size] for part, film in zip(white, films, strict=True)]
            found = replace(found, correlation=_correlation(noise.correlation, rows, basis.shape[1]))
        same, noise = not noise.differs(found, _SAME_NOISE), found
        # The first winsorised readings are those of the first guess.
        if same and not (loss.is_robust and number == 0):
            break
    return NoiseEstimate(noise, residuals)


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


def _winsorised(
    noise: Noise,
    covariances: Sequence[Covariance],
    films: Sequence[Residuals],
    residuals: Sequence[Floats],
    stated: tuple[bool, bool],
    least: tuple[float, float],
    loss: Loss,
) -> tuple[Noise, list[Floats]]:
    """The noise by medians, and the residuals with outliers moved towards the model."""
    systematic = [one.systematic_part(part) for one, part in zip(covariances, residuals, strict=True)]
    left = [film.values - part for film, part in zip(films, systematic, strict=True)]
    force = np.concatenate([film.errors.is_force for film in films])
    over = np.concatenate([part / film.errors.unit for part, film in zip(left, films, strict=True)])
    for kind, name in enumerate(("deviation", "of_force")):
        if not stated[kind] and np.any(force == bool(kind)):
            middle = _MEDIAN_TO_DEVIATION * float(np.median(np.abs(over[force == bool(kind)])))
            noise = replace(noise, **{name: max(middle, least[kind])})
    scores = [part / film.errors.std(noise) for part, film in zip(left, films, strict=True)]
    every = np.concatenate(scores)
    # Far from the optimum the mean slope may be negative; half of the mean weight psi(r)/r leads there safely.
    weight = np.mean(loss.psi(every) / np.where(every == 0, 1.0, every))
    slope = max(float(np.mean(loss.slopes(every))), 0.5 * float(weight), _MIN_SLOPE)
    moved = [
        part + film.errors.std(noise) * loss.psi(score) / slope
        for part, film, score in zip(systematic, films, scores, strict=True)
    ]
    return noise, moved


def noise_from_differences(rows: Sequence[Floats], largest: float) -> float:
    """Standard deviation of noise in rows of readings, from second differences, to which a smooth motion adds little.

    It is a hundredth of the largest reading if all rows are short.
    """
    differences = [np.diff(row, 2) for row in rows if row.size >= FEWEST]
    if not differences:
        return 0.01 * largest
    found = _MEDIAN_TO_DEVIATION * float(np.median(np.abs(np.concatenate(differences)))) / math.sqrt(6)
    return max(found, MIN_NOISE * largest)


def first_guess(series: Sequence[Series], stated: tuple[bool, bool], largest: tuple[float, float]) -> Noise:
    """Noise before any fit: one, as a factor, where errors are stated."""
    forces = [one.force for film in series for one in film.forces]
    rows = [film.midpoint for film in series]
    found = [noise_from_differences(*one) for one in zip((rows, forces), largest, strict=True)]
    return Noise(*(1.0 if known else one for known, one in zip(stated, found, strict=True)))
