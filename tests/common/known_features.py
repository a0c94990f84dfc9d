"""Features that no film was needed for: what a theory says of given constants."""

from __future__ import annotations

import math

import numpy as np

from softcat_sym.fitting.features import Features, Oscillation, Reading, Stretch, unread

GRAVITY, SPAN, DENSITY = 9.81, 0.2, 1900.0
UNIT = math.sqrt(SPAN / GRAVITY)


def features_of(
    frequency: float,
    decay: float | None,
    sag: float,
    load: float | None,
    *,
    clock: float = 0.2,
    errors: tuple[float, float, float, float] = (0.01, 0.05, 0.02, 0.03),
    t_high: float | None = None,
) -> Features:
    """Features from dimensionless numbers, in L and sqrt(L/g), with relative errors of R, d, H and B."""
    value = np.array([frequency / UNIT, (decay or 0.0) / UNIT, sag * SPAN])
    covariance = np.diag((value * errors[:3]) ** 2)
    time = np.linspace(clock * UNIT, 2 * clock * UNIT, 20)
    stretch = Stretch(time, np.full(20, value[2]), np.ones(20), False)
    linear = np.array([value[2], 0.0, 0.0, 0.0, 1e-4, 0.0])
    one = Oscillation(stretch, clock * UNIT, value[0], value[1], 0.2, linear, 0.0, covariance)
    of_logs = np.diag(np.square(errors[:3]))
    if decay is None:
        of_logs[1, 1] = np.nan
    return Features(
        gravity=GRAVITY,
        span=SPAN,
        t_high=unread("not filmed") if t_high is None else Reading(t_high * UNIT, 0.02 * t_high * UNIT),
        frequency=Reading(value[0], value[0] * errors[0]),
        decay=unread("it does not fade") if decay is None else Reading(value[1], value[1] * errors[1]),
        sag=Reading(value[2], value[2] * errors[2]),
        prefactor=unread("not late enough") if load is None else Reading(load, load * errors[3]),
        ringing_covariance=of_logs,
        ringing=one,
        late=None,
        noise=1e-5,
    )
