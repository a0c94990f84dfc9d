"""Noise, Fisher information, standard errors, identified combinations, and tests whether residuals are white."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.least_squares import Floats

Determination = Literal["determined", "poorly determined", "undetermined", "on a bound"]

FACTOR = 2.0
"""The ends of the 95 % interval of an identified unknown differ by less than this factor, those of a poorly determined
one by more. Of an unknown that may be zero or negative, the limit is +- 50 % of its scale."""


def is_identified(lower: float, upper: float, *, logarithmic: bool = True) -> bool:
    """Whether the ends of a 95 % interval of q = log(value/typical), or of q = value/scale, identify the unknown."""
    return upper - lower < (math.log(FACTOR) if logarithmic else 1.0)


def span_text(lower: float, upper: float, *, logarithmic: bool = True) -> str:
    """How wide a 95 % interval of q is, and how wide it may be of what is identified."""
    width = upper - lower
    if logarithmic:
        return f"spans a factor of {math.exp(width):.2g}, and less than {FACTOR:g} where it is identified"
    return f"is +- {50 * width:.2g} % of its scale, and less than 50 % where it is identified"


LEVEL = 0.95


@dataclass(frozen=True)
class FittedConstant:
    """A fitted constant."""

    value: float  # In SI units
    # Linearised, from the Jacobian at the optimum; None where it is undefined: on a bound, or with a singular Jacobian.
    standard_error: float | None
    # 95 % interval of Student's distribution, within the bounds of the constant; None with the standard error.
    interval: tuple[float, float] | None
    half_width: float | None  # Of the 95 % interval, without the bounds; None if there is no standard error
    # ``"undetermined"`` if the interval leaves the bounds of the constant (a yield stress that may be zero, say),
    # ``"poorly determined"`` if it is too wide for an identified one.
    verdict: Determination


_UNSURE: dict[bool, Determination] = {True: "poorly determined", False: "undetermined"}


def estimate(value: float, error: float, quantile: float, bounds: tuple[float, float]) -> FittedConstant:
    """Standard error, interval and verdict of a constant that lies between its bounds."""
    if not math.isfinite(error):
        return FittedConstant(value, None, None, None, "undetermined")
    half = quantile * error
    inside = bounds[0] < value - half and value + half < bounds[1]
    interval = (max(value - half, bounds[0]), min(value + half, bounds[1]))
    known = inside and is_identified(math.log(value - half), math.log(value + half))
    return FittedConstant(value, error, interval, half, "determined" if known else _UNSURE[inside])


def standard_errors(jacobian: NDArray[np.float64], squares: float) -> NDArray[np.float64]:
    """Standard errors of a least-squares fit, sqrt(diag(s^2 (J^T J)^-1)) with s^2 = squares/(points - constants)."""
    points, constants = jacobian.shape
    scale = np.linalg.norm(jacobian, axis=0)
    if not np.all(scale > 0):
        return np.full(constants, np.inf)
    triangle = np.linalg.qr(jacobian / scale, mode="r")
    if np.abs(np.diag(triangle)).min() < 1e-10:
        return np.full(constants, np.inf)
    spread = np.linalg.norm(np.linalg.inv(triangle), axis=1)
    errors: NDArray[np.float64] = math.sqrt(squares / (points - constants)) * spread / scale
    return errors


def student_quantile(freedom: int) -> float:
    """The number of standard errors within which Student's t lies with probability 95 %."""
    return float(stats.t.ppf(0.5 + 0.5 * LEVEL, freedom))


def two_sided_quantile(freedom: int | None) -> float:
    """The 97.5 % quantile of Student's t, or of the normal distribution where the noise is known.

    Its square is the 95 % quantile of F with 1 and `freedom` degrees of freedom, or of chi^2 with one.
    """
    return float(stats.norm.ppf(0.5 + 0.5 * LEVEL)) if freedom is None else student_quantile(freedom)


# Accuracy of the model over its change by a unit of q: the smallest noise that can be estimated.
_MODEL_ACCURACY = 1e-7


@dataclass(frozen=True)
class ResidualNoise:
    """The noise of the residuals of a fit."""

    deviation: float  # Standard deviation of a residual
    freedom: int | None  # m - k; None where the noise is known

    @property
    def variance(self) -> float:
        """Rise of the sum of squares for each unit of chi^2."""
        return self.deviation**2


def noise_of(residuals: Floats, jacobian: Floats, *, noise_known: bool, systematic: float = 0.0) -> ResidualNoise:
    """Estimate the noise at an optimum.

    If the residuals are whitened by a covariance with systematic errors, which take some degrees of freedom, they are
    in units of the estimated noise, and their deviation is at least one.
    """
    points, unknowns = jacobian.shape
    freedom = math.floor(points - unknowns - systematic + 1e-6)
    if noise_known:
        return ResidualNoise(1.0, None)
    if freedom < 1:
        raise SoftcatError(
            f"{points} data for {unknowns + systematic:.3g} unknowns do not determine the noise; accepted: at least "
            f"{math.ceil(unknowns + systematic) + 1} data, or their standard errors"
        )
    least = max(_MODEL_ACCURACY * float(np.sqrt(np.mean(jacobian**2))), float(np.finfo(float).tiny))
    deviation = math.sqrt(float(residuals @ residuals) / (points - unknowns))
    return ResidualNoise(max(deviation, 1.0 if systematic else least), freedom)


# Largest standard error, of a logarithm, of a combination that is reported.
_KNOWN = 0.5
# Largest factor by which rounded exponents may increase the standard error of a combination.
_ROUNDED = 1.5
# Exponents that occur in formulas of mechanics.
_DENOMINATORS = (1, 2, 3, 4)
_DIGITS = 3


@dataclass(frozen=True, eq=False)
class Combination:
    """A weighted sum of unknowns; of logarithmic ones, the logarithm of a product of powers."""

    names: tuple[str, ...]  # The unknowns that take part
    exponents: tuple[float, ...]  # Their weights, the largest in magnitude being one
    # ``"youngs_modulus^1 * viscosity^-1"``, or ``"1 * log(youngs_modulus) - 2 * offset"`` where an unknown is not
    # logarithmic.
    text: str
    value: float  # The sum of exponent times q: the logarithm of the product over that of the typical values
    standard_error: float  # Of `value`; where it is small, the relative standard error of the product
    interval: tuple[float, float]  # 95 % interval of `value`

    def product(self, typical: Sequence[float]) -> tuple[float, float, float]:
        """Value and 95 % interval of the product of powers, in the parameters' own units."""
        unit = math.prod(value**exponent for value, exponent in zip(typical, self.exponents, strict=True))
        low, high = self.interval
        return unit * math.exp(self.value), unit * math.exp(low), unit * math.exp(high)


def combinations(
    names: Sequence[str], q: Floats, root: Floats, determined: Floats, quantile: float, logarithmic: Sequence[bool]
) -> tuple[Combination, ...]:
    """Write the determined directions as combinations of few unknowns with simple exponents.

    The directions' span is brought to reduced echelon form, which gives as many combinations as there are directions,
    each with an unknown of its own; exponents are then rounded as far as their errors allow.
    """
    found = []
    for row in _echelon(determined.T):
        weights = _simplified(row / row[np.argmax(np.abs(row))], root)
        part = np.flatnonzero(weights).tolist()
        weights *= np.sign(weights[part[0]])
        error = float(np.linalg.norm(weights @ root))
        if len(part) < 2 or error > _KNOWN:
            continue
        value, half = float(weights @ q), quantile * error
        terms = [(names[k], float(weights[k]), logarithmic[k]) for k in part]
        exponents = tuple(weight for _, weight, _ in terms)
        interval = (value - half, value + half)
        found.append(Combination(tuple(names[k] for k in part), exponents, _text(terms), value, error, interval))
    return tuple(sorted(found, key=lambda one: one.standard_error))


def _echelon(rows: Floats) -> Floats:
    """Reduced row echelon form; each pivot is the largest remaining entry."""
    rows = rows.copy()
    pivots: list[int] = []
    for k in range(len(rows)):
        left = np.abs(rows[k:]).copy()
        left[:, pivots] = 0
        below, column = np.unravel_index(int(np.argmax(left)), left.shape)
        rows[[k, k + int(below)]] = rows[[k + int(below), k]]
        rows[k] /= rows[k, column]
        others = np.arange(len(rows)) != k
        rows[others] -= np.outer(rows[others, column], rows[k])
        pivots.append(int(column))
    return rows


def _simplified(weights: Floats, root: Floats) -> Floats:
    """Round all weights to the simplest numbers that hardly increase the standard error of the combination."""
    allowed = _ROUNDED * float(np.linalg.norm(weights @ root)) + 1e-6
    for denominator in _DENOMINATORS:
        rounded = np.round(weights * denominator) / denominator
        if rounded.any() and float(np.linalg.norm(rounded @ root)) <= allowed:
            return rounded
    return np.where(np.abs(weights) < 10.0**-_DIGITS, 0.0, weights)


def _text(terms: Sequence[tuple[str, float, bool]]) -> str:
    """A product of powers, or a sum where an unknown is not logarithmic."""

    def number(weight: float) -> str:
        fraction = Fraction(weight).limit_denominator(_DENOMINATORS[-1])
        return str(fraction) if abs(float(fraction) - weight) < 1e-9 else f"{weight:.{_DIGITS}g}"

    if all(logarithmic for *_, logarithmic in terms):
        powers = [(name, number(weight)) for name, weight, _ in terms]
        return " * ".join(f"{name}^({power})" if "/" in power else f"{name}^{power}" for name, power in powers)
    text = ""
    for name, weight, logarithmic in terms:
        sign = " - " if weight < 0 else " + "
        term = f"log({name})" if logarithmic else name
        text += f"{sign if text else sign.strip(' +')}{number(abs(weight))} * {term}"
    return text


MAX_ERROR = 1.0
"""Largest standard error of a determined q: a factor e, or the typical value itself."""

DERIVATIVE_ACCURACY = 1e-6
"""Share of the largest singular value below which a singular value is an error of the derivatives."""


@dataclass(frozen=True, eq=False)
class Information:
    """Fisher information: the curvature of the sum of squares at the optimum.

    A direction of the unknowns is determined if its standard error is less than `MAX_ERROR` and its singular value is
    more than `DERIVATIVE_ACCURACY` of the largest. Along the others the linear theory has no meaning beyond the bounds:
    their standard error is at most the half-length of the box.
    """

    names: tuple[str, ...]  # The k unknowns
    spread: ResidualNoise  # Of the residuals
    # shape (k, k); Inverse of J^T J/s^2, s being `noise`, with the errors of undetermined directions cut as above.
    covariance: Floats
    standard_errors: Floats  # shape (k,); Square roots of its diagonal, of q
    determined: NDArray[np.bool_]  # shape (k,); Which directions are determined, the best known first
    # Combinations that are determined; empty if every unknown and every direction is.
    combinations: tuple[Combination, ...]
    logarithmic: tuple[bool, ...]  # Which unknowns are logarithms

    @property
    def noise(self) -> float:
        """Standard deviation s of the residuals, one if it is known."""
        return self.spread.deviation

    @property
    def freedom(self) -> int | None:
        """Degrees m - k; None where the noise is known."""
        return self.spread.freedom

    @property
    def correlation(self) -> Floats:
        """Normalised covariance, shape (k, k)."""
        normalised: Floats = self.covariance / np.outer(self.standard_errors, self.standard_errors)
        return normalised

    @property
    def identified(self) -> NDArray[np.bool_]:
        """Which single unknowns are determined, shape (k,): those with a standard error below `MAX_ERROR`."""
        below: NDArray[np.bool_] = self.standard_errors < MAX_ERROR
        return below

    @property
    def quantile(self) -> float:
        """The number of standard errors in half a 95 % interval."""
        return two_sided_quantile(self.freedom)


def information(
    names: tuple[str, ...],
    q: Floats,
    residuals: Floats,
    jacobian: Floats,
    box: tuple[Floats, Floats],
    *,
    noise_known: bool,
    logarithmic: tuple[bool, ...] | None = None,
    systematic: float = 0.0,
) -> Information:
    """Fisher information of the unknowns at an optimum, from its Jacobian."""
    spread, unknowns = noise_of(residuals, jacobian, noise_known=noise_known, systematic=systematic), len(names)
    scaled = jacobian / spread.deviation
    # Rows of zeros, so that there are as many singular values as unknowns even for fewer data.
    _, singular, rows = np.linalg.svd(np.vstack([scaled, np.zeros((unknowns, unknowns))]), full_matrices=False)
    significant = singular > DERIVATIVE_ACCURACY * singular[0]
    with np.errstate(divide="ignore"):
        half_lengths = (0.5 * (box[1] - box[0])[:, None] / np.abs(rows.T)).min(axis=0)
    raw = 1 / np.where(significant, singular, np.nan)
    root = rows.T * np.where(significant, np.fmin(raw, half_lengths), half_lengths)
    determined, standard = significant & (raw < MAX_ERROR), np.linalg.norm(root, axis=1)
    quantile, flags = two_sided_quantile(spread.freedom), logarithmic or (True,) * unknowns
    found = combinations(names, q, root, rows.T[:, determined], quantile, flags)
    return Information(
        names=names,
        spread=spread,
        covariance=root @ root.T,
        standard_errors=standard,
        determined=determined,
        combinations=() if determined.all() and np.all(standard < MAX_ERROR) else found,
        logarithmic=flags,
    )


SIGNIFICANCE = 0.01
"""Largest probability of calling white residuals not white."""

FEWEST = 20
"""Smallest number of consecutive residuals for which the approximations of these tests hold."""

_LAGS = 10


@dataclass(frozen=True)
class Statistic:
    """Result of one test of the hypothesis that residuals are white."""

    name: str  # Name of the test
    value: float  # Standard normal, or chi^2
    p_value: float  # Probability of a statistic at least as extreme from white residuals


@dataclass(frozen=True)
class ResidualChecks:
    """Tests of the residuals of a fit."""

    # ``"white"``; ``"not white"``: the model misses something that the data show, and intervals are too narrow; or
    # ``"cannot tell"``: fewer than `FEWEST` in every series.
    verdict: Literal["white", "not white", "cannot tell"]
    # Runs of signs (Wald and Wolfowitz 1940), correlation of neighbours, the first lags together (Ljung and Box
    # 1978). The verdict is "not white" if the least of their p-values is below `SIGNIFICANCE` over their number
    # (Bonferroni).
    tests: tuple[Statistic, ...]
    autocorrelation: float | None  # Of neighbours, the mean over the series
    # RSS against chi^2 with m - k degrees of freedom, where the noise is known: a small p-value says that the model
    # misses more than the stated errors, whatever the order. None where the noise is estimated.
    size: Statistic | None


def check_residuals(series: Sequence[Floats], unknowns: int, *, noise_known: bool) -> ResidualChecks:
    """Test the residuals of a fit."""
    total = sum(row.size for row in series)
    squares = float(sum(row @ row for row in series))
    size = None
    if noise_known and total > unknowns:
        size = Statistic("chi-square", squares, float(stats.chi2.sf(squares, total - unknowns)))
    # Residuals that are all zero have no order.
    long = [row for row in series if row.size >= FEWEST and np.any(row != 0)]
    if not long:
        return ResidualChecks("cannot tell", (), None, size)
    runs, box, freedom = _runs(long), 0.0, 0
    first, sizes = np.zeros(len(long)), np.array([row.size for row in long])
    for k, row in enumerate(long):
        lags = np.arange(1, min(_LAGS, row.size // 5) + 1)
        # The mean is not subtracted, as that of white residuals is zero.
        correlations = np.array([float(row[lag:] @ row[:-lag]) for lag in lags]) / float(row @ row)
        box += row.size * (row.size + 2) * float((correlations**2 / (row.size - lags)).sum())
        first[k], freedom = correlations[0], freedom + lags.size
    normal = float((np.sqrt(sizes) * first).sum()) / math.sqrt(len(long))
    tests = (
        Statistic("Wald-Wolfowitz runs", runs, 2 * float(stats.norm.sf(abs(runs)))),
        Statistic("lag-one autocorrelation", normal, 2 * float(stats.norm.sf(abs(normal)))),
        Statistic("Ljung-Box", box, float(stats.chi2.sf(box, freedom))),
    )
    white = min(test.p_value for test in tests) >= SIGNIFICANCE / len(tests)
    return ResidualChecks("white" if white else "not white", tests, float(first.mean()), size)


def _runs(series: Sequence[Floats]) -> float:
    """Numbers of runs of one sign, against their mean and variance for random order, summed over the series."""
    excess, variance = 0.0, 0.0
    for row in series:
        signs = row[row != 0] > 0
        above, below = int(signs.sum()), int((~signs).sum())
        both, count = 2 * above * below, above + below
        if count > 1:
            excess += 1 + int((signs[1:] != signs[:-1]).sum()) - (both / count + 1)
            variance += both * (both - count) / (count**2 * (count - 1))
    if variance <= 0:
        # All residuals have one sign: their mean is not zero.
        return -math.inf
    # Continuity correction of half a run.
    return math.copysign(max(abs(excess) - 0.5, 0.0), excess) / math.sqrt(variance)
