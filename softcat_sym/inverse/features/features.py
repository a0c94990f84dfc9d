"""What the film of a sagging midpoint shows: free fall, oscillation, 1/3 law."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from softcat_sym.equations import asymptotics, rheometry
from softcat_sym.equations.regimes import H as SAG
from softcat_sym.equations.symbols import L as SPAN
from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.inverse.features.damped_sinusoid import Oscillation, Stretch
from softcat_sym.inverse.features.late_law import LateLaw, late_law_of
from softcat_sym.inverse.features.onset import caught_after, end_of_free_fall, start_of_third_law
from softcat_sym.inverse.features.reading import Floats, Reading, unread
from softcat_sym.inverse.features.ringing import find_oscillation
from softcat_sym.inverse.features.trend import noise_of
from softcat_sym.printing import evaluate

_FINEST, _ROUNDING = 1e-4, 1e-12
"""No film resolves less than the first, of its largest sag; the second, of the span, is for one that never moves."""

FEWEST = 8
"""Frames without which nothing can be read."""


@dataclass(frozen=True, eq=False)
class Features:
    """What was read, in SI, each number with its error or the reason why there is none.

    Attributes
    ----------
    gravity, span : float
        g [m/s^2] and L [m], as given.
    t_low, t_high : Reading
        End of free fall and start of the 1/3 law [s]; a filament that rings hides the latter.
    frequency, decay, sag : Reading
        R [rad/s], d [1/s] and the sag H [m] about which it rings, all at `ringing.middle`.
    prefactor : Reading
        B of the late 1/3 law, dimensionless.
    ringing_covariance : ndarray, shape (3, 3)
        Of log R, log d and log H; NaN where one of them cannot be read.
    ringing : Oscillation or None
        The fit that they come from.
    late : LateLaw or None
        The fit that B comes from.
    noise : float
        Scatter of the frames [m].
    """

    gravity: float
    span: float
    t_low: Reading
    t_high: Reading
    frequency: Reading
    decay: Reading
    sag: Reading
    prefactor: Reading
    ringing_covariance: Floats
    ringing: Oscillation | None
    late: LateLaw | None
    noise: float


def read_features(time: Floats, midpoint: Floats, std: Floats | None, gravity: float, span: float) -> Features:
    """Read all features from a film of the midpoint.

    Parameters
    ----------
    time : ndarray, shape (n,)
        [s], increasing, zero when the filament is let go; frames before that are not used.
    midpoint : ndarray, shape (n,)
        [m], relative to the supports, negative down.
    std : ndarray, shape (n,), or None
        Standard errors of the midpoint [m], independent of one another; without them they follow from the scatter.
    gravity, span : float
        g [m/s^2] and L [m].

    Returns
    -------
    Features

    Raises
    ------
    SoftcatError
        If the arrays do not belong together, hold anything but finite numbers, or fewer than eight frames.
    """
    _refuse(time, midpoint, std, gravity, span)
    film, noise = _film(time, midpoint, std, span)
    tolerance = float(asymptotics.TOLERANCE)
    caught = caught_after(film, gravity, noise)
    found = find_oscillation(film, caught, gravity)
    ringing = found if isinstance(found, Oscillation) else None
    frequency, decay, sag, covariance = _of_ringing(found)
    late = late_law_of(film, ringing)
    return Features(
        gravity=gravity,
        span=span,
        t_low=end_of_free_fall(film, gravity, tolerance),
        t_high=start_of_third_law(film, gravity, noise, tolerance, ringing),
        frequency=frequency,
        decay=decay,
        sag=sag,
        prefactor=unread(late) if isinstance(late, str) else _prefactor(late, gravity, span),
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


def _refuse(time: Floats, midpoint: Floats, std: Floats | None, gravity: float, span: float) -> None:
    faults = []
    columns = {"time": time, "midpoint": midpoint} | ({} if std is None else {"std": std})
    for name, column in columns.items():
        if column.ndim != 1 or column.shape != time.shape:
            faults.append(Fault(name, f"an array of shape {column.shape}", f"one number a frame, {time.shape}"))
        elif not np.all(np.isfinite(column)):
            faults.append(Fault(name, "holds numbers that are not finite", "finite numbers"))
    if not faults and np.any(np.diff(time) <= 0):
        faults.append(Fault("time", "does not increase", "increasing times"))
    if std is not None and not faults and np.any(std <= 0):
        faults.append(Fault("std", "holds standard errors that are not positive", "positive lengths"))
    if not faults and np.sum(time > 0) < FEWEST:
        faults.append(Fault("time", f"{np.sum(time > 0)} frames after the start", f"at least {FEWEST}"))
    for name, value in (("gravity", gravity), ("span", span)):
        if not (math.isfinite(value) and value > 0):
            faults.append(Fault(name, f"{value:g}", "a positive number"))
    if faults:
        raise SoftcatError("features of a film:\n" + "\n".join(f"  {fault}" for fault in faults))


def _of_ringing(found: Oscillation | str) -> tuple[Reading, Reading, Reading, Floats]:
    if isinstance(found, str):
        return unread(found), unread(found), unread(found), np.full((3, 3), np.nan)
    errors = np.sqrt(np.diag(found.covariance)).tolist()
    frequency, sag = Reading(found.frequency, errors[0]), Reading(found.sag, errors[2])
    decay = Reading(found.decay, errors[1])
    if found.decay <= 2 * errors[1]:
        most = max(found.decay, 0.0) + 2 * errors[1]
        decay = unread(f"it does not fade within the frames that show it: slower than {most:.3g} 1/s")
    value = np.array([found.frequency, found.decay if decay.value else np.nan, found.sag])
    return frequency, decay, sag, found.covariance / np.outer(value, value)


def _prefactor(late: LateLaw, gravity: float, span: float) -> Reading:
    """B of sag^3 = k (t - t_0), by the formula for the sag at a time of one unit."""
    unit = math.sqrt(span / gravity)
    known = {SAG: math.cbrt(late.slope * unit), SPAN: span, rheometry.t_star: 1.0}
    value = float(evaluate(rheometry.B_FROM_SAG.right, known)[0])
    return Reading(value, value * late.slope_error / late.slope)
