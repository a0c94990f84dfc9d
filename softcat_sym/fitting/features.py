"""Features of a film of the midpoint, read without running a model: oscillation, the late 1/3 law and its start."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np
from numpy.polynomial import Chebyshev, chebyshev
from numpy.polynomial.polyutils import mapdomain
from numpy.typing import NDArray
from scipy.optimize import least_squares

from softcat_sym.discretization.casadi_printer import evaluate
from softcat_sym.physics import closed_forms, rheometry
from softcat_sym.physics.regimes import H as SAG
from softcat_sym.physics.symbols import L as SPAN

SLACKEST = 8.9868
"""w sqrt(8 H/g) of an inextensible cable: 2x where tan x = x."""

TAUTEST = math.pi
"""w sqrt(8 H/g) of a taut string."""


def mode_number(frequency: float, sag: float, gravity: float) -> float:
    """R sqrt(8 H/g): between pi (taut) and 8.99 (inextensible) in the lowest symmetric mode."""
    return frequency * math.sqrt(8 * sag / gravity)


def sensitivity(mode: float) -> float:
    """Slope d log E/d log R at given sag; infinite outside of the lowest mode."""
    if not TAUTEST < mode < SLACKEST:
        return math.inf
    half = mode / 2
    return 3 - half * -(math.tan(half) ** 2) / (half - math.tan(half))


Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Reading:
    """A feature's value with its standard error, or the reason why there is none."""

    value: float | None  # In SI units, None if it cannot be read
    error: float | None  # Standard error, in the same unit; None with the value
    reason: str = ""  # Why there is no value; empty if there is one

    @property
    def log_variance(self) -> float:
        """Variance of the logarithm to first order; infinite without a value."""
        if self.value is None or self.error is None:
            return math.inf
        return (self.error / self.value) ** 2


def unread(reason: str) -> Reading:
    """A feature that cannot be read."""
    return Reading(None, None, reason)


DEGREE = 3
"""Degree of the trend in log t: over a factor of five in time it follows any power law to 1e-3 of its change."""

_BLOCK = 7


@dataclass(frozen=True, eq=False)
class LogPolynomial:
    """Chebyshev polynomials of log t on a stretch of time."""

    first: float  # Ends of the stretch [s], positive
    last: float
    degree: int  # Highest degree

    @property
    def _domain(self) -> list[float]:
        return [math.log(self.first), math.log(self.last)]

    def columns(self, time: Floats) -> Floats:
        """Values of the basis at times [s], shape (n, degree + 1)."""
        return np.asarray(chebyshev.chebvander(mapdomain(np.log(time), self._domain, [-1, 1]), self.degree))

    def second_derivative(self, time: float) -> Floats:
        """d^2/dt^2 of the basis at one time [1/s^2], shape (degree + 1,)."""
        basis, at = [Chebyshev.basis(k, self._domain) for k in range(self.degree + 1)], math.log(time)
        return np.array([one.deriv(2)(at) - one.deriv(1)(at) for one in basis]) / time**2


def noise_of(time: Floats, sag: Floats) -> float:
    """Scatter of the frames about short parabolas, over the later half of the film [m].

    Each block of seven neighbouring frames is fitted by its own parabola; an oscillation with fewer frames a period
    counts as scatter.
    """
    half = max(len(time) // 2, min(len(time), _BLOCK))
    late_time, late_sag = time[-half:], sag[-half:]
    squares, freedom = 0.0, 0
    for start in range(0, len(late_time) - 3, _BLOCK):
        block = slice(start, start + _BLOCK)
        t, y = late_time[block], late_sag[block]
        if len(t) < 4:
            continue
        columns = np.vander((t - t.mean()) / (np.ptp(t) or 1.0), 3)
        rest = y - columns @ np.linalg.lstsq(columns, y, rcond=None)[0]
        squares, freedom = squares + float(rest @ rest), freedom + len(t) - 3
    return math.sqrt(squares / freedom) if freedom else 0.0


STIFFENING, STIFFENING_SPREAD = 0.2, 0.2
"""Prior of g in R ~ t^g: the frequency of a string scales with its sag, as t^(1/3); that of a beam is constant."""

_LEAST = 1e-3  # Of the first frequency


@dataclass(frozen=True, eq=False)
class Stretch:
    """Part of a film."""

    # shape (n,); Times [s], positive; sag [m]; standard errors [m], from the scatter of the whole film where they are
    # unknown.
    time: Floats
    sag: Floats
    std: Floats
    noise_known: bool  # Whether `std` was given

    @property
    def basis(self) -> LogPolynomial:
        """Basis of the trend."""
        return LogPolynomial(float(self.time[0]), float(self.time[-1]), DEGREE)

    def noise_scale(self, squares: float, freedom: int) -> float:
        """Factor of all standard errors: from the scatter about the fit, but at least that of the film.

        Otherwise, among many stretches, the one with the smallest scatter by chance would seem the best.
        """
        return max(math.sqrt(squares / max(freedom, 1)), 1.0)


@dataclass(frozen=True, eq=False)
class Oscillation:
    """trend(t) + exp(-d (t - t_0)) (a cos p + b sin p) with the phase p of the frequency R (t/t_0)^g."""

    stretch: Stretch  # The frames it was fitted to
    middle: float  # t_0 [s], the centroid of the squared amplitude, at which R, d and the sag are given
    frequency: float  # R [rad/s], d [1/s] and g
    decay: float
    stiffening: float
    linear: Floats  # shape (DEGREE + 3,); Coefficients of the trend, then a and b [m]
    squares: float  # Sum of the squared residuals over their standard errors
    covariance: Floats  # shape (3, 3); Of R, d and the sag of the trend at t_0, to first order

    @property
    def sag(self) -> float:
        """Sag of the trend at t_0 [m]."""
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
        """Amplitude of the oscillation at a time [m], also beyond the stretch."""
        return float(np.hypot(*self.linear[-2:])) * math.exp(-self.decay * (time - self.middle))


def phase(time: Floats, middle: float, frequency: float, stiffening: float) -> Floats:
    """Integral of R (t/t_0)^g from t_0 [rad], shape of `time`."""
    angle: Floats = frequency * middle / (1 + stiffening) * ((time / middle) ** (1 + stiffening) - 1)
    return angle


def fitted(stretch: Stretch, frequency: float, decay: float, stiffening: float) -> Oscillation | None:
    """Fit an oscillation, from a guess whose phase error over the stretch is at most half a cycle."""
    middle, nonlinear = math.sqrt(stretch.time[0] * stretch.time[-1]), np.array([frequency, decay, stiffening])
    bounds = np.full((2, DEGREE + 6), [[-np.inf], [np.inf]])
    bounds[:, :3] = (_LEAST * frequency, -3 * frequency, -0.9), (3 * frequency, 3 * frequency, 2.0)
    if not np.all((bounds[0, :3] < nonlinear) & (nonlinear < bounds[1, :3])):
        return None
    unknowns = _with_linear(stretch, middle, nonlinear)
    how: dict[str, Any] = {"x_scale": "jac", "ftol": 1e-12, "xtol": 1e-9, "max_nfev": 50}
    try:
        # The prior of g counts by the noise, which the first fit finds.
        for _ in range(2):
            scale = _scatter(_linearised(stretch, middle, unknowns, 1.0)[0][:-1])
            problem = partial(_linearised, stretch, middle, scale=scale)
            steps = least_squares(lambda x: problem(x)[0], unknowns, lambda x: problem(x)[1], bounds, **how)  # noqa: B023
            unknowns = np.asarray(steps.x)
    except (ValueError, np.linalg.LinAlgError):
        # The model is not finite there, or its columns are no longer independent.
        return None
    weight = np.exp(-2 * unknowns[1] * (stretch.time - stretch.time[0]))
    centre = float(np.sum(weight * stretch.time) / np.sum(weight))
    nonlinear = unknowns[:3] * np.array([(centre / middle) ** unknowns[2], 1.0, 1.0])
    return _judged(stretch, centre, _with_linear(stretch, centre, nonlinear))


def _columns(basis: LogPolynomial, time: Floats, middle: float, nonlinear: Floats) -> Floats:
    angle = phase(time, middle, nonlinear[0], nonlinear[2])
    envelope = np.exp(-nonlinear[1] * (time - middle))
    return np.column_stack([basis.columns(time), envelope * np.cos(angle), envelope * np.sin(angle)])


def _with_linear(stretch: Stretch, middle: float, nonlinear: Floats) -> Floats:
    """R, d and g with the best coefficients of the trend, a and b beside them."""
    columns = _columns(stretch.basis, stretch.time, middle, nonlinear) / stretch.std[:, None]
    return np.append(nonlinear, np.linalg.lstsq(columns, stretch.sag / stretch.std, rcond=None)[0])


def _scatter(rest: Floats) -> float:
    return math.sqrt(float(rest @ rest) / max(len(rest) - DEGREE - 6, 1))


def _linearised(stretch: Stretch, middle: float, unknowns: Floats, scale: float) -> tuple[Floats, Floats]:
    """Residuals over the errors and their derivatives; behind them the prior of g, for errors of another scale."""
    time, nonlinear, linear = stretch.time, unknowns[:3], unknowns[3:]
    columns = _columns(stretch.basis, time, middle, nonlinear) / stretch.std[:, None]
    frequency, _, stiffening = nonlinear
    wave, quarter = columns[:, -2:] @ linear[-2:], columns[:, -2:] @ np.array([linear[-1], -linear[-2]])
    grown = (time / middle) ** (1 + stiffening)
    by_frequency = middle / (1 + stiffening) * (grown - 1)
    by_stiffening = frequency * (middle * grown * np.log(time / middle) - by_frequency) / (1 + stiffening)
    jacobian = np.column_stack([quarter * by_frequency, -wave * (time - middle), quarter * by_stiffening, columns])
    pull = np.zeros(jacobian.shape[1])
    pull[2] = scale / STIFFENING_SPREAD
    rest = np.append(columns @ linear - stretch.sag / stretch.std, pull[2] * (stiffening - STIFFENING))
    return rest, np.vstack([jacobian, pull])


def _judged(stretch: Stretch, middle: float, unknowns: Floats) -> Oscillation | None:
    """Oscillation with standard errors of the whole linearised fit, with the prior of g as one more datum."""
    rest = _linearised(stretch, middle, unknowns, 0.0)[0][:-1]
    squares = float(rest @ rest)
    scale = stretch.noise_scale(squares, len(rest) - DEGREE - 6)
    every = _linearised(stretch, middle, unknowns, scale)[1]
    size = np.linalg.norm(every, axis=0)
    if not np.all(size > 0):
        return None
    triangle = np.linalg.qr(every / size, mode="r")
    if np.abs(np.diag(triangle)).min() < 1e-12:
        return None
    half = np.linalg.inv(triangle) * scale / size[:, None]
    reported = np.zeros((3, every.shape[1]))
    reported[0, 0] = reported[1, 1] = 1.0
    reported[2, 3:-2] = stretch.basis.columns(np.array([middle]))[0]
    root = reported @ half
    frequency, decay, stiffening = unknowns[:3].tolist()
    found = Oscillation(stretch, middle, frequency, decay, stiffening, unknowns[3:], squares, root @ root.T)
    return found if found.sag > 0 else None


def beats_polynomial(one: Oscillation) -> bool:
    """Whether an oscillation describes the frames better than a trend with as many additional constants."""
    stretch = one.stretch
    basis = replace(stretch.basis, degree=DEGREE + 5)
    weight = 1 / stretch.std
    columns = basis.columns(stretch.time) * weight[:, None]
    rest = stretch.sag * weight - columns @ np.linalg.lstsq(columns, stretch.sag * weight, rcond=None)[0]
    return one.squares < float(rest @ rest)


MIN_LATE_FRAMES = 8
"""Smallest number of frames for the late law."""

EXPONENT_MARGIN = 0.06
"""Largest difference of the exponent of t from 1/3: a string that still relaxes has 0.34, a beam has 1."""

_SHARE = 4.0
_QUIET = 0.02


@dataclass(frozen=True, eq=False)
class LateLaw:
    """sag = (k (t - t_0))^(1/3)."""

    slope: float  # k [m^3/s]
    slope_error: float  # Its standard error
    shift: float  # t_0 [s], from earlier motion: elastic sag, bending, a clock that was started late
    first: float  # Times of the frames that are fitted [s]
    last: float

    def sag(self, time: Floats) -> Floats:
        """Sag [m] at times [s] after `shift`."""
        values: Floats = np.cbrt(self.slope * (time - self.shift))
        return values


_ALIKE = 1e6  # Condition number above which the data do not determine both unknowns


def late_law_of(film: Stretch, ringing: Oscillation | None) -> LateLaw | str:
    """Fit the law to the last three quarters of the film, or to the part after the ringing has decayed."""
    start = float(film.time[-1]) / _SHARE
    if ringing is not None and ringing.decay > 0:
        quiet = ringing.middle + math.log(ringing.amplitude(ringing.middle) / (_QUIET * ringing.sag)) / ringing.decay
        start = min(max(start, quiet), float(film.time[-1]) / 2)
    part = film.time >= start
    time, sag, std = film.time[part], film.sag[part], film.std[part]
    if len(time) < MIN_LATE_FRAMES:
        return f"fewer than {MIN_LATE_FRAMES} frames in the late part of the film"
    if np.any(sag <= 0):
        return "the midpoint is not below the supports throughout the late part of the film"
    # Powers of the time, fitted to the logarithms.
    weight = sag / std
    columns = np.column_stack([np.log(time / time[0]), np.ones_like(time)]) * weight[:, None]
    line = np.linalg.lstsq(columns, np.log(sag) * weight, rcond=None)[0]
    left = columns @ line - np.log(sag) * weight
    spread = film.noise_scale(float(left @ left), len(time) - 2)
    exponent = float(line[0])
    exponent_error = spread * math.sqrt(float(np.linalg.inv(columns.T @ columns)[0, 0]))
    if abs(exponent - 1 / 3) > EXPONENT_MARGIN + 2 * exponent_error:
        cause = "bending still carries load, or the sag grows at another rate"
        cause = cause if exponent > 1 / 3 else "the filament stops, or is held elastically"
        return f"the sag grows as t^{exponent:.2f}, not as t^(1/3): {cause}"
    solved = _fit_third_law(time, sag, std)
    # A constant sag is fitted by every law with an early t_0.
    if solved is None or np.linalg.cond(solved[3] / np.linalg.norm(solved[3], axis=0)) > _ALIKE:
        return "the cube of the sag does not grow linearly in time"
    slope, shift, rest, jacobian = solved
    scale = film.noise_scale(float(rest @ rest), len(time) - 2)
    covariance = np.linalg.inv(jacobian.T @ jacobian) * scale**2
    error = slope * math.sqrt(covariance[0, 0])
    return LateLaw(slope, error, shift, float(time[0]), float(time[-1]))


def _fit_third_law(time: Floats, sag: Floats, std: Floats) -> tuple[float, float, Floats, Floats] | None:
    """Slope k, shift, residuals over std, and the derivative of these by (log k, shift)."""
    columns = np.column_stack([time, np.ones_like(time)]) / (3 * sag**2 * std)[:, None]
    slope, offset = np.linalg.lstsq(columns, sag**3 / (3 * sag**2 * std), rcond=None)[0].tolist()
    if slope <= 0 or not -offset / slope < time[0]:
        return None

    def law(unknowns: Floats) -> Floats:
        return np.asarray(np.cbrt(math.exp(unknowns[0]) * (time - unknowns[1])))

    def derivatives(unknowns: Floats) -> Floats:
        here = law(unknowns)
        return np.column_stack([here / 3, -here / (3 * (time - unknowns[1]))]) / std[:, None]

    # The law is defined after its t_0 only.
    bounds = (-math.inf, -math.inf), (math.inf, float(time[0]))
    start, how = np.array([math.log(slope), -offset / slope]), {"x_scale": "jac", "ftol": 1e-15, "xtol": 1e-12}
    found = least_squares(lambda unknowns: (law(unknowns) - sag) / std, start, derivatives, bounds, **how)
    return (math.exp(found.x[0]), float(found.x[1]), found.fun, found.jac) if found.success else None


_CLEAR = 3.0
_WINDOW, _FEWEST, _STEP = 1.6, 8, 1.05
_NOISY = 0.5
_CAUGHT, _FREE = 0.5, 0.9


def caught_after(film: Stretch, gravity: float, noise: float) -> float:
    """First time [s] at which the midpoint has significantly fallen less than half of g t^2/2."""
    free = 0.5 * gravity * film.time**2
    caught = np.flatnonzero(_CAUGHT * free > np.maximum.accumulate(film.sag) + _CLEAR * noise)
    return float(film.time[caught[0]]) if len(caught) else math.inf


def start_of_third_law(
    film: Stretch, gravity: float, noise: float, tolerance: float, ringing: Oscillation | None
) -> Reading:
    """Time t_high at which the descent's deceleration has fallen to alpha g.

    On the 1/3 law this is only 1.4 times the time at which the law departs from g t^2/2. It can be read if the filament
    does not ring and the frame rate is high enough.
    """
    wanted = tolerance * gravity
    free = 0.5 * gravity * film.time**2
    slower = np.flatnonzero(_FREE * free > np.maximum.accumulate(film.sag) + _CLEAR * noise)
    begin = float(film.time[slower[0]]) if len(slower) else math.inf
    centres, slowing, errors = _decelerations(film, begin)
    if not len(centres):
        return unread(f"fewer than {_FEWEST} frames over any factor of {_WINDOW:g} in time after free fall")
    below = np.flatnonzero(slowing < wanted)
    if not len(below):
        return unread("inertia carries more than alpha of the weight to the end of the film")
    if below[0] == 0:
        return unread("the descent has slowed down before there are enough frames")
    k = int(below[0])
    fraction = math.log(wanted / slowing[k - 1]) / math.log(max(slowing[k], 0.1 * wanted) / slowing[k - 1])
    high = float(centres[k - 1] * (centres[k] / centres[k - 1]) ** fraction)
    if ringing is not None and ringing.amplitude(high) * ringing.frequency**2 > wanted:
        return unread("at that time the oscillation hides how the descent slows down")
    # On the 1/3 law the deceleration is proportional to t^(-5/3).
    error = float(errors[k]) / wanted * 3 / 5
    if error > _NOISY:
        return unread("the deceleration of the descent is lost in the noise")
    return Reading(high, error * high)


def _decelerations(film: Stretch, begin: float) -> tuple[Floats, Floats, Floats]:
    """Times, deceleration and its standard error [m/s^2], by cubics in log t over short stretches."""
    rows = []
    later = film.time[film.time >= begin]
    start = float(later[0]) if len(later) else math.inf
    while start * _WINDOW <= film.time[-1]:
        part = (film.time >= start) & (film.time <= start * _WINDOW)
        time, sag, std = film.time[part], film.sag[part], film.std[part]
        if len(time) >= _FEWEST:
            basis = LogPolynomial(float(time[0]), float(time[-1]), DEGREE)
            columns = basis.columns(time) / std[:, None]
            linear = np.linalg.lstsq(columns, sag / std, rcond=None)[0]
            rest = columns @ linear - sag / std
            scale = film.noise_scale(float(rest @ rest), len(time) - DEGREE - 1)
            centre = math.sqrt(time[0] * time[-1])
            bent = basis.second_derivative(centre)
            error = scale * float(np.linalg.norm(np.linalg.lstsq(columns.T, bent, rcond=None)[0]))
            rows.append((centre, -float(bent @ linear), error))
        start *= _STEP
    table = np.array(rows).reshape(-1, 3)
    return table[:, 0], table[:, 1], table[:, 2]


FALSE_ALARMS = 1e-3
"""Largest share of films of pure noise in which an oscillation is found."""

MIN_RINGING_FRAMES = 14
"""Smallest number of frames in a stretch: nine constants of a cubic and an oscillation, and some degrees of freedom."""

MIN_PER_PERIOD = 2.5
"""Smallest number of frames a period; with fewer, a frequency may be an alias."""

_STARTS, _LENGTHS = 1.35, (1.7, 3.0, 5.0)
_CYCLES = (1.5, 40.0)
_PER_CYCLE = 3
_DECAYS = (0.0, 2.0, 6.0)
_STIFFENINGS = (0.0, 1 / 3)
_CLEAR_RINGING = 400.0
"""Energy, in variances of a frame, above which an oscillation is known to some percent."""

_NO_CABLE = 1e3
_SOFTENING = 0.4
"""Approximate relative shift of a string's frequency over (A/H)^2, for an amplitude A and a sag H; weighs stretches."""


@dataclass(frozen=True)
class _Peak:
    """The likeliest oscillation in one stretch."""

    odds: float  # Logarithm of the probability that noise fits as well at this point of the search
    energy: float  # Decrease of the sum of squares, over the variances of the frames
    stretch: Stretch  # The frames
    frequency: float  # As :func:`softcat_sym.fitting.features.fitted` takes them
    decay: float
    stiffening: float


def find_oscillation(film: Stretch, caught: float, gravity: float) -> Oscillation | str:
    """Look for a damped oscillation about the descent.

    Every stretch is searched by a periodogram of damped cosines on a cubic trend in log t. The probability that noise
    lowers the sum of squares as much is (RSS_1/RSS_0)^(freedom/2) (the F test with two degrees of freedom), times the
    number of points searched (Bonferroni).
    """
    stretches = _stretches(film, caught)
    if not stretches:
        return f"fewer than {MIN_RINGING_FRAMES} frames in any part of the film after free fall"
    searched = [_search(stretch) for stretch in stretches]
    places = sum(count for _, count in searched)
    limit = math.log(FALSE_ALARMS / max(places, 1))
    peaks = [peak for peak, _ in searched if peak is not None and peak.odds < limit]
    peaks.sort(key=lambda one: -one.energy)
    if not peaks:
        return "no oscillation is seen above the noise"
    kept: list[Oscillation] = []
    for peak in peaks:
        # Only clear oscillations are compared, as the best of many doubtful fits may be so by chance.
        if kept and peak.energy < min(_CLEAR_RINGING, peaks[0].energy / 2):
            break
        one = fitted(peak.stretch, peak.frequency, peak.decay, peak.stiffening)
        if one is not None and _is_ringing(one) and beats_polynomial(one):
            kept.append(one)
    if not kept:
        return "the departure from the trend is not a damped oscillation over at least one period"
    return min(kept, key=lambda one: _uncertainty(one, gravity))


def _stretches(film: Stretch, caught: float) -> list[Stretch]:
    last = float(film.time[-1])
    later = film.time[film.time >= caught]
    if not len(later):
        return []
    found: dict[tuple[int, int], Stretch] = {}
    start = float(later[0])
    while start < last / _LENGTHS[0] * 1.0001:
        for length in _LENGTHS:
            low, high = np.searchsorted(film.time, [start, start * length * 1.0001]).tolist()
            if high - low >= MIN_RINGING_FRAMES:
                part = slice(low, high)
                found[low, high] = Stretch(film.time[part], film.sag[part], film.std[part], film.noise_known)
        start *= _STARTS
    return list(found.values())


def _search(stretch: Stretch) -> tuple[_Peak | None, int]:
    """Likeliest frequency, decay and stiffening of a stretch, and the number of points searched."""
    time, weight = stretch.time, 1 / stretch.std
    middle, long = math.sqrt(time[0] * time[-1]), time[-1] - time[0]
    fastest = 2 * math.pi / (MIN_PER_PERIOD * float(np.median(np.diff(time))))
    cycles = min(_CYCLES[1], fastest * long / (2 * math.pi))
    if cycles <= _CYCLES[0]:
        return None, 0
    count = max(int((cycles - _CYCLES[0]) * _PER_CYCLE), 2)
    frequency = 2 * math.pi / long * np.linspace(_CYCLES[0], cycles, count)
    trend = np.linalg.qr(stretch.basis.columns(time) * weight[:, None])[0]
    rest = stretch.sag * weight
    rest = rest - trend @ (trend.T @ rest)
    squares = float(rest @ rest)
    if squares <= (1e-9 * float(np.linalg.norm(stretch.sag * weight))) ** 2:
        return None, 0
    freedom = len(time) - DEGREE - 3
    best: _Peak | None = None
    for decay, stiffening in product(_DECAYS, _STIFFENINGS):
        envelope = np.exp(-decay / long * (time - time[0])) * weight
        angle = np.outer(phase(time, middle, 1.0, stiffening), frequency)
        gain = _gain(envelope[:, None] * np.cos(angle), envelope[:, None] * np.sin(angle), trend, rest)
        at = int(np.argmax(gain))
        odds = 0.5 * freedom * math.log(max(1 - float(gain[at]) / squares, 1e-300))
        # With known errors the probability is exp(-gain/2), even if the frames scatter less than stated.
        odds = max(odds, -0.5 * float(gain[at])) if stretch.noise_known else odds
        if best is None or odds < best.odds:
            best = _Peak(odds, float(gain[at]), stretch, float(frequency[at]), decay / long, stiffening)
    return best, count * len(_DECAYS) * len(_STIFFENINGS)


def _gain(cosine: Floats, sine: Floats, trend: Floats, rest: Floats) -> Floats:
    """Decrease of the sum of squares by a cosine and a sine besides the trend, for each column."""
    cosine = cosine - trend @ (trend.T @ cosine)
    sine = sine - trend @ (trend.T @ sine)
    cc, ss, cs = (np.einsum("ij,ij->j", a, b) for a, b in ((cosine, cosine), (sine, sine), (cosine, sine)))
    c, s = cosine.T @ rest, sine.T @ rest
    determinant = cc * ss - cs**2
    # A wave that the trend nearly contains has no gain.
    apart = determinant > 1e-6 * (cc.max() * ss.max())
    gain: Floats = np.where(apart, (ss * c**2 - 2 * cs * c * s + cc * s**2) / np.where(apart, determinant, 1.0), 0.0)
    return gain


def _is_ringing(one: Oscillation) -> bool:
    """Whether the fit is still an oscillation that the frames resolve, over at least one period."""
    time = one.stretch.time
    frames = 2 * math.pi / one.frequency / float(np.median(np.diff(time)))
    cycles = abs(float(np.ptp(phase(time, one.middle, one.frequency, one.stiffening)))) / (2 * math.pi)
    error = math.sqrt(one.covariance[0, 0])
    inside = float(time[0]) <= one.middle <= float(time[-1])
    repeats = frames >= MIN_PER_PERIOD and cycles >= 1.0 and one.decay < one.frequency
    return inside and repeats and error < 0.2 * one.frequency and one.amplitude(float(time[0])) < one.sag


def _uncertainty(one: Oscillation, gravity: float) -> float:
    """Relative error of a cable's modulus from this oscillation, by noise and amplitude."""
    share = one.amplitude(one.middle) / one.sag
    error = math.hypot(math.sqrt(one.covariance[0, 0]) / one.frequency, _SOFTENING * share**2)
    leverage = sensitivity(mode_number(one.frequency, one.sag, gravity))
    return error * min(leverage, _NO_CABLE)


_FINEST, _ROUNDING = 1e-4, 1e-12
"""Smallest error of a frame: resolution of a film over its largest sag; rounding over the span, without motion."""

FEWEST = 8
"""Smallest number of frames from which features are read."""


@dataclass(frozen=True, eq=False)
class Features:
    """Features of a film in SI, each with its standard error or the reason why there is none."""

    gravity: float  # g [m/s^2] and L [m], as given
    span: float
    t_high: Reading  # Start of the 1/3 law [s], which a filament that rings hides
    frequency: Reading  # R [rad/s], d [1/s] and the sag H [m] about which it rings, all at `ringing.middle`
    decay: Reading
    sag: Reading
    prefactor: Reading  # B of the late 1/3 law, dimensionless
    ringing_covariance: Floats  # shape (3, 3); Of log R, log d and log H; NaN where one of them cannot be read
    ringing: Oscillation | None  # The fit that they come from
    late: LateLaw | None  # The fit that B comes from
    noise: float  # Scatter of the frames [m]


def read_features(time: Floats, midpoint: Floats, std: Floats | None, gravity: float, span: float) -> Features:
    """Read all features from a film of the midpoint."""
    film, noise = _film(time, midpoint, std, span)
    tolerance = float(closed_forms.TOLERANCE)
    caught = caught_after(film, gravity, noise)
    found = find_oscillation(film, caught, gravity)
    ringing = found if isinstance(found, Oscillation) else None
    frequency, decay, sag, covariance = _of_ringing(found)
    late = late_law_of(film, ringing)
    if isinstance(late, str):
        prefactor = unread(late)
    else:
        # B of sag^3 = k (t - t_0), by the formula for the sag at a time of one unit.
        known = {SAG: math.cbrt(late.slope * math.sqrt(span / gravity)), SPAN: span, rheometry.t_star: 1.0}
        value = float(evaluate(rheometry.B_FROM_SAG.right, known)[0])
        prefactor = Reading(value, value * late.slope_error / late.slope)
    return Features(
        gravity=gravity,
        span=span,
        t_high=start_of_third_law(film, gravity, noise, tolerance, ringing),
        frequency=frequency,
        decay=decay,
        sag=sag,
        prefactor=prefactor,
        ringing_covariance=covariance,
        ringing=ringing,
        late=None if isinstance(late, str) else late,
        noise=noise,
    )


def _film(time: Floats, midpoint: Floats, std: Floats | None, span: float) -> tuple[Stretch, float]:
    """Frames after the start as sags with errors, and the error of a typical one [m]."""
    later = time > 0
    clock, sag = time[later], -midpoint[later]
    noise = noise_of(clock, sag) if std is None else float(np.median(std[later]))
    least = max(noise, _FINEST * float(np.abs(sag).max()), _ROUNDING * span)
    return Stretch(clock, sag, np.full_like(sag, least) if std is None else std[later], std is not None), noise


def _of_ringing(found: Oscillation | str) -> tuple[Reading, Reading, Reading, Floats]:
    if isinstance(found, str):
        return unread(found), unread(found), unread(found), np.full((3, 3), np.nan)
    errors = np.sqrt(np.diag(found.covariance)).tolist()
    frequency, sag = Reading(found.frequency, errors[0]), Reading(found.sag, errors[2])
    decay = Reading(found.decay, errors[1])
    if found.decay <= 2 * errors[1]:
        most = max(found.decay, 0.0) + 2 * errors[1]
        decay = unread(f"the oscillation does not decay within its frames: slower than {most:.3g} 1/s")
    value = np.array([found.frequency, found.decay if decay.value else np.nan, found.sag])
    return frequency, decay, sag, found.covariance / np.outer(value, value)
