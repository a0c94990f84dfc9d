"""End of free fall and start of the 1/3 law, by the paper's definitions, as far as a film shows them.

On the film of a midpoint tension is not seen, accelerations are: what inertia does not take is tension. Tension reaches
alpha of inertia (t_low) where the acceleration has fallen to g/(1 + alpha); inertia falls to alpha of the tension
(t_high) where the descent slows down by alpha g.
"""

from __future__ import annotations

import math

import numpy as np

from softcat_sym.inverse.features.damped_sinusoid import Oscillation, Stretch
from softcat_sym.inverse.features.reading import Floats, Reading, unread
from softcat_sym.inverse.features.trend import DEGREE, LogPolynomial

_FALLING, _CLEAR = 4, 3.0
_WINDOW, _FEWEST, _STEP = 1.6, 8, 1.05
_NOISY = 0.5
_CAUGHT, _FREE = 0.5, 0.9


def caught_after(film: Stretch, gravity: float, noise: float) -> float:
    """First time [s] at which the midpoint has fallen less than half of g t^2/2, beyond doubt.

    Parameters
    ----------
    film : Stretch
        All frames at positive times.
    gravity : float
        [m/s^2].
    noise : float
        Standard error of a frame [m].
    """
    free = 0.5 * gravity * film.time**2
    caught = np.flatnonzero(_CAUGHT * free > np.maximum.accumulate(film.sag) + _CLEAR * noise)
    return float(film.time[caught[0]]) if len(caught) else math.inf


def end_of_free_fall(film: Stretch, gravity: float, tolerance: float) -> Reading:
    """Time t_low at which the midpoint's acceleration falls to g/(1 + alpha).

    The first frames are fitted by g t^2/2 (1 - c t^n): n = 5 where the filament has relaxed, 6 where it is elastic
    still, so that with 5.5 t_low is known to 5 % at best.

    Parameters
    ----------
    film : Stretch
        All frames at positive times.
    gravity : float
        [m/s^2].
    tolerance : float
        alpha.
    """
    free = 0.5 * gravity * film.time**2
    power = 5.5
    left = np.flatnonzero(film.sag < 0.75 * free)
    first = slice(0, int(left[0]) if len(left) else len(free))
    time, fall, std = film.time[first], free[first], film.std[first]
    if len(time) < _FALLING:
        return unread(f"free fall is over within {_FALLING} frames")
    if not len(left):
        return unread("the midpoint falls freely to the end of the film")
    if abs(float(film.sag[first][-1] / fall[-1] - 1)) > 0.5:
        return unread("the midpoint does not start with free fall")
    column = fall * (time / time[-1]) ** power / std
    missing = (fall - film.sag[first]) / std
    size = float(column @ column)
    lost = float(column @ missing) / size
    scale = film.noise_scale(float(np.sum((missing - lost * column) ** 2)), len(time) - 1)
    error = scale / math.sqrt(size)
    if lost <= 2 * error:
        return unread("the frames in which the fall slows down are too few or too noisy")
    # d^2/dt^2 of the fit is g (1 - (n + 2)(n + 1)/2 c t^n).
    share = tolerance / (1 + tolerance)
    low = float(time[-1]) * (2 * share / ((power + 1) * (power + 2) * lost)) ** (1 / power)
    return Reading(low, low * math.hypot(error / lost / power, 0.05))


def start_of_third_law(
    film: Stretch, gravity: float, noise: float, tolerance: float, ringing: Oscillation | None
) -> Reading:
    """Time t_high at which the descent's deceleration has fallen to alpha g.

    On the 1/3 law that is only 1.4 times the time at which the law leaves g t^2/2: it is seen where the filament does
    not ring and is filmed closely enough.

    Parameters
    ----------
    film : Stretch
        All frames at positive times.
    gravity : float
        [m/s^2].
    noise : float
        Standard error of a frame [m].
    tolerance : float
        alpha.
    ringing : Oscillation or None
        The acceleration of an oscillation must have died away first.
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
        return unread("the descent has slowed down before there are frames enough to see how")
    k = int(below[0])
    fraction = math.log(wanted / slowing[k - 1]) / math.log(max(slowing[k], 0.1 * wanted) / slowing[k - 1])
    high = float(centres[k - 1] * (centres[k] / centres[k - 1]) ** fraction)
    if ringing is not None and ringing.amplitude(high) * ringing.frequency**2 > wanted:
        return unread("at that time the oscillation hides how the descent slows down")
    # On the 1/3 law the deceleration goes as t^(-5/3).
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
