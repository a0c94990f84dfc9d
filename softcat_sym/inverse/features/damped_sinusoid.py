"""A damped oscillation about a slow trend: linear constants by projection, frequency and decay by Gauss-Newton.

Variable projection after Golub and Pereyra, SIAM J. Numer. Anal. 10 (1973) 413, with the shortened Jacobian of Kaufman,
BIT 15 (1975) 49.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.inverse.features.reading import Floats
from softcat_sym.inverse.features.trend import DEGREE, LogPolynomial

STIFFENING, STIFFENING_SPREAD = 0.2, 0.2
"""Prior of g in R ~ t^g: the frequency of a string goes with its sag, as t^(1/3); that of a beam is constant."""

_STEPS = 40


@dataclass(frozen=True, eq=False)
class Stretch:
    """Part of a film.

    Attributes
    ----------
    time, sag, std : ndarray, shape (n,)
        Times [s], positive; sag [m]; standard errors [m], from the scatter of the whole film where they are unknown.
    noise_known : bool
        Whether `std` was given.
    """

    time: Floats
    sag: Floats
    std: Floats
    noise_known: bool

    @property
    def basis(self) -> LogPolynomial:
        """Of the trend."""
        return LogPolynomial(float(self.time[0]), float(self.time[-1]), DEGREE)

    def noise_scale(self, squares: float, freedom: int) -> float:
        """Factor of all standard errors: from the scatter about the fit, but never below that of the film.

        Among many stretches the one that scatters least by chance would be taken for the best.
        """
        return max(math.sqrt(squares / max(freedom, 1)), 1.0)


@dataclass(frozen=True, eq=False)
class Oscillation:
    """trend(t) + exp(-d (t - t_0)) (a cos p + b sin p) with the phase p of the frequency R (t/t_0)^g.

    Attributes
    ----------
    stretch : Stretch
        The frames it was fitted to.
    middle : float
        t_0 [s], where the amplitude has its centre of gravity; R, d and the sag are told there.
    frequency, decay, stiffening : float
        R [rad/s], d [1/s] and g.
    linear : ndarray, shape (DEGREE + 3,)
        Coefficients of the trend, then a and b [m].
    squares : float
        Sum of the squared residuals over their standard errors.
    covariance : ndarray, shape (3, 3)
        Of R, d and the sag of the trend at t_0, to first order.
    """

    stretch: Stretch
    middle: float
    frequency: float
    decay: float
    stiffening: float
    linear: Floats
    squares: float
    covariance: Floats

    @property
    def sag(self) -> float:
        """Of the trend at t_0 [m]."""
        return float(self.trend(np.array([self.middle]))[0])

    def trend(self, time: Floats) -> Floats:
        """Sag about which it rings [m] at times within the stretch."""
        values: Floats = self.stretch.basis.columns(time) @ self.linear[:-2]
        return values

    def curve(self, time: Floats) -> Floats:
        """Sag with the oscillation [m] at times within the stretch."""
        nonlinear = np.array([self.frequency, self.decay, self.stiffening])
        values: Floats = _columns(self.stretch.basis, time, self.middle, nonlinear) @ self.linear
        return values

    def amplitude(self, time: float) -> float:
        """Of the oscillation at a time [m], also beyond the stretch."""
        return float(np.hypot(*self.linear[-2:])) * math.exp(-self.decay * (time - self.middle))


def phase(time: Floats, middle: float, frequency: float, stiffening: float) -> Floats:
    """Integral of R (t/t_0)^g from t_0 [rad], shape of `time`."""
    angle: Floats = frequency * middle / (1 + stiffening) * ((time / middle) ** (1 + stiffening) - 1)
    return angle


def fitted(stretch: Stretch, frequency: float, decay: float, stiffening: float) -> Oscillation | None:
    """Fit an oscillation, from a guess that is right to half a cycle over the stretch.

    Parameters
    ----------
    stretch : Stretch
        The frames.
    frequency, decay, stiffening : float
        Where to start; the frequency is told at the geometric middle of the stretch.

    Returns
    -------
    Oscillation or None
        None if the search does not end, or ends where the errors are infinite.
    """
    middle = math.sqrt(stretch.time[0] * stretch.time[-1])
    nonlinear = np.array([frequency, decay, stiffening])
    for _ in range(2):
        found = _gauss_newton(stretch, middle, nonlinear)
        if found is None:
            return None
        nonlinear = found[0]
        weight = np.exp(-2 * nonlinear[1] * (stretch.time - stretch.time[0]))
        centre = float(np.sum(weight * stretch.time) / np.sum(weight))
        nonlinear = nonlinear * np.array([(centre / middle) ** nonlinear[2], 1.0, 1.0])
        middle = centre
    found = _gauss_newton(stretch, middle, nonlinear)
    return None if found is None else _judged(stretch, middle, *found)


def _columns(basis: LogPolynomial, time: Floats, middle: float, nonlinear: Floats) -> Floats:
    angle = phase(time, middle, nonlinear[0], nonlinear[2])
    envelope = np.exp(-nonlinear[1] * (time - middle))
    return np.column_stack([basis.columns(time), envelope * np.cos(angle), envelope * np.sin(angle)])


def _projected(stretch: Stretch, middle: float, nonlinear: Floats) -> tuple[Floats, Floats, Floats, Floats, float]:
    """Columns, linear constants, residuals, derivative by the three others, and the cost with the prior of g."""
    time, weight = stretch.time, 1 / stretch.std
    columns = _columns(stretch.basis, time, middle, nonlinear) * weight[:, None]
    data = stretch.sag * weight
    linear: Floats = np.asarray(np.linalg.lstsq(columns, data, rcond=None)[0], dtype=np.float64)
    rest = columns @ linear - data
    frequency, _, stiffening = nonlinear
    wave, quarter = columns[:, -2:] @ linear[-2:], columns[:, -2:] @ np.array([linear[-1], -linear[-2]])
    grown = (time / middle) ** (1 + stiffening)
    by_frequency = middle / (1 + stiffening) * (grown - 1)
    by_stiffening = frequency * (middle * grown * np.log(time / middle) - by_frequency) / (1 + stiffening)
    jacobian = np.column_stack([quarter * by_frequency, -wave * (time - middle), quarter * by_stiffening])
    prior = (stiffening - STIFFENING) / STIFFENING_SPREAD
    variance = float(rest @ rest) / max(len(time) - columns.shape[1] - 3, 1)
    return columns, linear, rest, jacobian, float(rest @ rest) + variance * prior**2


def _gauss_newton(stretch: Stretch, middle: float, start: Floats) -> tuple[Floats, Floats] | None:
    """Levenberg-Marquardt in (R, d, g) on what the linear constants leave; the end and its linear constants."""
    nonlinear, damping = start.copy(), 1e-3
    columns, linear, rest, jacobian, cost = _projected(stretch, middle, nonlinear)
    for _ in range(_STEPS):
        across = np.linalg.qr(columns)[0]
        reduced = jacobian - across @ (across.T @ jacobian)
        variance = float(rest @ rest) / max(len(rest) - columns.shape[1] - 3, 1)
        pull = variance / STIFFENING_SPREAD**2
        normal = reduced.T @ reduced + np.diag([0.0, 0.0, pull])
        slope = reduced.T @ rest + np.array([0.0, 0.0, pull * (nonlinear[2] - STIFFENING)])
        if not np.all(np.isfinite(normal)) or np.any(np.diag(normal) <= 0):
            return None
        step = -np.linalg.solve(normal + damping * np.diag(np.diag(normal)), slope)
        trial = nonlinear + step
        if trial[0] <= 0 or not -0.9 < trial[2] < 2 or abs(trial[1]) > 3 * trial[0]:
            damping = max(10 * damping, 1e-2)
            if damping > 1e8:
                return None
            continue
        tried = _projected(stretch, middle, trial)
        if tried[-1] <= cost:
            small = bool(np.all(np.abs(step) < 1e-9 * np.array([trial[0], trial[0], 1.0])))
            nonlinear, damping = trial, damping / 10
            columns, linear, rest, jacobian, cost = tried
            if small:
                break
        else:
            damping *= 10
            if damping > 1e8:
                break
    return nonlinear, linear


def _judged(stretch: Stretch, middle: float, nonlinear: Floats, linear: Floats) -> Oscillation | None:
    """Standard errors of the whole linearised fit, with the prior of g as one more datum."""
    columns, linear, rest, jacobian, _ = _projected(stretch, middle, nonlinear)
    squares = float(rest @ rest)
    scale = stretch.noise_scale(squares, len(rest) - columns.shape[1] - 3)
    every = np.column_stack([jacobian, columns])
    every = np.vstack([every, np.zeros(every.shape[1])])
    every[-1, 2] = scale / STIFFENING_SPREAD
    size = np.linalg.norm(every, axis=0)
    if not np.all(size > 0):
        return None
    triangle = np.linalg.qr(every / size, mode="r")
    if np.abs(np.diag(triangle)).min() < 1e-12:
        return None
    half = np.linalg.inv(triangle) * scale / size[:, None]
    told = np.zeros((3, every.shape[1]))
    told[0, 0] = told[1, 1] = 1.0
    told[2, 3:-2] = stretch.basis.columns(np.array([middle]))[0]
    root = told @ half
    frequency, decay, stiffening = nonlinear.tolist()
    found = Oscillation(stretch, middle, frequency, decay, stiffening, linear, squares, root @ root.T)
    return found if found.sag > 0 else None


def beats_polynomial(one: Oscillation) -> bool:
    """Whether it describes the frames better than a trend with as many more constants would."""
    stretch = one.stretch
    basis = replace(stretch.basis, degree=DEGREE + 5)
    weight = 1 / stretch.std
    columns = basis.columns(stretch.time) * weight[:, None]
    rest = stretch.sag * weight - columns @ np.linalg.lstsq(columns, stretch.sag * weight, rcond=None)[0]
    return one.squares < float(rest @ rest)
