"""The late 1/3 law of a viscous string: sag^3 = 9 B t/64 in units of L and sqrt(L/g) (2.20)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from softcat_sym.inverse.features.damped_sinusoid import Oscillation, Stretch
from softcat_sym.inverse.features.reading import Floats

FEWEST = 8
"""Frames that are needed."""

EXPONENT_MARGIN = 0.06
"""By how much the exponent of t may differ from 1/3: a string that relaxes still has 0.34, a beam has 1."""

_SHARE = 4.0
_QUIET = 0.02


@dataclass(frozen=True, eq=False)
class LateLaw:
    """sag = (k (t - t_0))^(1/3).

    Attributes
    ----------
    slope : float
        k [m^3/s].
    slope_error : float
        Its standard error.
    shift : float
        t_0 [s]; it stands for the past: elastic sag, bending, a clock that was started late.
    exponent, exponent_error : float
        Of the bare power law over the same frames.
    first, last : float
        Times of the frames that are fitted [s].
    """

    slope: float
    slope_error: float
    shift: float
    exponent: float
    exponent_error: float
    first: float
    last: float

    def sag(self, time: Floats) -> Floats:
        """Sag [m] at times [s] after `shift`."""
        values: Floats = np.cbrt(self.slope * (time - self.shift))
        return values


def late_law_of(film: Stretch, ringing: Oscillation | None) -> LateLaw | str:
    """Fit the law to the last three quarters of the film, from when the ringing has died away, if it does.

    Parameters
    ----------
    film : Stretch
        All frames at positive times.
    ringing : Oscillation or None
        As found; its frames count where it is less than 2 % of the sag.

    Returns
    -------
    LateLaw or str
        The law, or why the film does not show it.
    """
    start = float(film.time[-1]) / _SHARE
    if ringing is not None and ringing.decay > 0:
        quiet = ringing.middle + math.log(ringing.amplitude(ringing.middle) / (_QUIET * ringing.sag)) / ringing.decay
        start = min(max(start, quiet), float(film.time[-1]) / 2)
    part = film.time >= start
    time, sag, std = film.time[part], film.sag[part], film.std[part]
    if len(time) < FEWEST:
        return f"fewer than {FEWEST} frames in the late part of the film"
    if np.any(sag <= 0):
        return "the midpoint is not below the supports throughout the late part of the film"
    exponent, exponent_error = _exponent(film, time, sag, std)
    if abs(exponent - 1 / 3) > EXPONENT_MARGIN + 2 * exponent_error:
        cause = "bending still carries load, or the sag grows with a rate of its own"
        cause = cause if exponent > 1 / 3 else "it stops, or is held elastically"
        return f"the sag grows as t^{exponent:.2f}, not as t^(1/3): {cause}"
    solved = _gauss_newton(time, sag, std)
    if solved is None:
        return "no line t - t_0 follows the cube of the sag"
    slope, shift, rest, jacobian = solved
    scale = film.noise_scale(float(rest @ rest), len(time) - 2)
    covariance = np.linalg.inv(jacobian.T @ jacobian) * scale**2
    error = slope * math.sqrt(covariance[0, 0])
    return LateLaw(slope, error, shift, exponent, exponent_error, float(time[0]), float(time[-1]))


def _exponent(film: Stretch, time: Floats, sag: Floats, std: Floats) -> tuple[float, float]:
    weight = sag / std
    columns = np.column_stack([np.log(time / time[0]), np.ones_like(time)]) * weight[:, None]
    found, *_ = np.linalg.lstsq(columns, np.log(sag) * weight, rcond=None)
    rest = columns @ found - np.log(sag) * weight
    scale = film.noise_scale(float(rest @ rest), len(time) - 2)
    return float(found[0]), scale * math.sqrt(float(np.linalg.inv(columns.T @ columns)[0, 0]))


def _gauss_newton(time: Floats, sag: Floats, std: Floats) -> tuple[float, float, Floats, Floats] | None:
    """Slope k, shift, residuals over std, and the derivative of these by (log k, shift)."""
    columns = np.column_stack([time, np.ones_like(time)]) / (3 * sag**2 * std)[:, None]
    line = np.linalg.lstsq(columns, sag**3 / (3 * sag**2 * std), rcond=None)[0]
    slope, shift = float(line[0]), float(-line[1] / line[0]) if line[0] else math.inf
    for _ in range(30):
        if slope <= 0 or not shift < time[0]:
            return None
        law = np.cbrt(slope * (time - shift))
        rest: Floats = (law - sag) / std
        jacobian: Floats = np.column_stack([law / 3, -law / (3 * (time - shift))]) / std[:, None]
        step = -np.linalg.lstsq(jacobian, rest, rcond=None)[0]
        # Halfway to the first frame at most: the law has no sag before its own beginning.
        step[1] = min(step[1], 0.5 * (time[0] - shift))
        slope, shift = slope * math.exp(float(np.clip(step[0], -1, 1))), shift + float(step[1])
        if abs(step[0]) < 1e-10 and abs(step[1]) < 1e-10 * time[-1]:
            return slope, shift, rest, jacobian
    return None
