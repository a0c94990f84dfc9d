"""Whether the midpoint rings, and how: a search over stretches of the film, then a fit in the best of them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

import numpy as np

from softcat_sym.inverse.closed_form.cable import mode_number, sensitivity
from softcat_sym.inverse.features.damped_sinusoid import Oscillation, Stretch, beats_polynomial, fitted, phase
from softcat_sym.inverse.features.reading import Floats
from softcat_sym.inverse.features.trend import DEGREE

FALSE_ALARMS = 1e-3
"""Share of films of mere noise in which an oscillation may be seen."""

FEWEST = 14
"""Frames in a stretch: a cubic, five constants of an oscillation, and some to spare."""

FEWEST_PER_PERIOD = 2.5
"""Frames a period; below, it may be another frequency's alias."""

_STARTS, _LENGTHS = 1.35, (1.7, 3.0, 5.0)
_CYCLES = (1.5, 40.0)
_PER_CYCLE = 3
_DECAYS = (0.0, 2.0, 6.0)
_STIFFENINGS = (0.0, 1 / 3)
_CLEAR = 400.0
"""Energy at which an oscillation is told to some percent, in variances of a frame."""

_NO_CABLE = 1e3
_SOFTENING = 0.4
"""Share (A/H)^2 by which an amplitude A shifts the frequency of a string of sag H, roughly: it weighs stretches."""


@dataclass(frozen=True)
class _Peak:
    """The likeliest oscillation in one stretch.

    Attributes
    ----------
    odds : float
        Logarithm of the chance that noise does as well at this place of the search.
    energy : float
        By how much it lowers the sum of squares over the variances of the frames.
    stretch : Stretch
        The frames.
    frequency, decay, stiffening : float
        As :func:`softcat_sym.inverse.features.damped_sinusoid.fitted` takes them.
    """

    odds: float
    energy: float
    stretch: Stretch
    frequency: float
    decay: float
    stiffening: float


def find_oscillation(film: Stretch, caught: float, gravity: float) -> Oscillation | str:
    """Look for a damped oscillation about the descent.

    Every stretch is searched by a periodogram of damped cosines beside a cubic trend in log t. The chance that noise
    lowers the sum of squares as much is (RSS_1/RSS_0)^(freedom/2) (the F test with two degrees of freedom), times the
    places looked at (Bonferroni).

    Parameters
    ----------
    film : Stretch
        All frames at positive times.
    caught : float
        Time [s] from which the filament no longer falls freely.
    gravity : float
        [m/s^2].

    Returns
    -------
    Oscillation or str
        The best determined one, or why there is none.
    """
    stretches = _stretches(film, caught)
    if not stretches:
        return f"fewer than {FEWEST} frames in any part of the film after free fall"
    searched = [_search(stretch) for stretch in stretches]
    places = sum(count for _, count in searched)
    limit = math.log(FALSE_ALARMS / max(places, 1))
    peaks = [peak for peak, _ in searched if peak is not None and peak.odds < limit]
    peaks.sort(key=lambda one: -one.energy)
    if not peaks:
        return "no oscillation is seen above the noise"
    kept: list[Oscillation] = []
    for peak in peaks:
        # Of many doubtful fits the best is the luckiest: only the clear ones are compared.
        if kept and peak.energy < min(_CLEAR, peaks[0].energy / 2):
            break
        one = fitted(peak.stretch, peak.frequency, peak.decay, peak.stiffening)
        if one is not None and _is_ringing(one) and beats_polynomial(one):
            kept.append(one)
    if not kept:
        return "what departs from the trend is no damped oscillation that is seen to repeat"
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
            if high - low >= FEWEST:
                part = slice(low, high)
                found[low, high] = Stretch(film.time[part], film.sag[part], film.std[part], film.noise_known)
        start *= _STARTS
    return list(found.values())


def _search(stretch: Stretch) -> tuple[_Peak | None, int]:
    """Likeliest frequency, decay and stiffening of a stretch, and how many were looked at."""
    time, weight = stretch.time, 1 / stretch.std
    middle, long = math.sqrt(time[0] * time[-1]), time[-1] - time[0]
    fastest = 2 * math.pi / (FEWEST_PER_PERIOD * float(np.median(np.diff(time))))
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
        # With known errors the same chance is exp(-gain/2): frames that scatter less than said prove nothing more.
        odds = max(odds, -0.5 * float(gain[at])) if stretch.noise_known else odds
        if best is None or odds < best.odds:
            best = _Peak(odds, float(gain[at]), stretch, float(frequency[at]), decay / long, stiffening)
    return best, count * len(_DECAYS) * len(_STIFFENINGS)


def _gain(cosine: Floats, sine: Floats, trend: Floats, rest: Floats) -> Floats:
    """By how much a cosine and a sine beside the trend lower the sum of squares, for each column."""
    cosine = cosine - trend @ (trend.T @ cosine)
    sine = sine - trend @ (trend.T @ sine)
    cc, ss, cs = (np.einsum("ij,ij->j", a, b) for a, b in ((cosine, cosine), (sine, sine), (cosine, sine)))
    c, s = cosine.T @ rest, sine.T @ rest
    determinant = cc * ss - cs**2
    # A wave that the trend nearly contains explains nothing that the trend does not.
    apart = determinant > 1e-6 * (cc.max() * ss.max())
    gain: Floats = np.where(apart, (ss * c**2 - 2 * cs * c * s + cc * s**2) / np.where(apart, determinant, 1.0), 0.0)
    return gain


def _is_ringing(one: Oscillation) -> bool:
    """Whether the fit stayed an oscillation that the frames resolve and that is seen to repeat."""
    time = one.stretch.time
    frames = 2 * math.pi / one.frequency / float(np.median(np.diff(time)))
    cycles = abs(float(np.ptp(phase(time, one.middle, one.frequency, one.stiffening)))) / (2 * math.pi)
    error = math.sqrt(one.covariance[0, 0])
    inside = float(time[0]) <= one.middle <= float(time[-1])
    repeats = frames >= FEWEST_PER_PERIOD and cycles >= 1.0 and one.decay < one.frequency
    return inside and repeats and error < 0.2 * one.frequency and one.amplitude(float(time[0])) < one.sag


def _uncertainty(one: Oscillation, gravity: float) -> float:
    """Relative error that noise and amplitude leave in the modulus of a cable that rings like this."""
    share = one.amplitude(one.middle) / one.sag
    error = math.hypot(math.sqrt(one.covariance[0, 0]) / one.frequency, _SOFTENING * share**2)
    leverage = sensitivity(mode_number(one.frequency, one.sag, gravity))
    return error * min(leverage, _NO_CABLE)
