"""How fast each effect fades as its coefficient goes to zero: the table of limits, by effect.

The exponents and prefactors are derived where the filaments are built.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from . import fading_filaments as fading
from .fading_filaments import Pair
from .rheology import STRING


@dataclass(frozen=True)
class Limit:
    """An effect that fades."""

    effect: str
    what: str
    coefficient: str
    values: tuple[float, ...]
    exponent: float
    band: float
    pair: Callable[[float], Pair]
    prefactor: Callable[[], float] | None = None
    share: float = 0.03


@dataclass(frozen=True)
class Faded:
    """What a limit was measured to be."""

    shares: tuple[float, ...]
    exponents: tuple[float, ...]


def measure(limit: Limit) -> Faded:
    """Shares of the effect at every value, and the exponents between them."""
    shares = []
    for value in limit.values:
        with_it, without_it = limit.pair(value)
        shares.append(float(np.max(np.abs(with_it - without_it)) / np.max(np.abs(without_it))))
    exponents = np.diff(np.log(shares)) / np.diff(np.log(limit.values))
    return Faded(tuple(shares), tuple(float(exponent) for exponent in exponents))


def _constant(number: float) -> Callable[[], float]:
    return lambda: number


_GEOMETRY = {"finite-stretch": 1 / 6, "thinning": 1 / 3, "large-rotation": 2 / 5}

LIMITS: tuple[Limit, ...] = (
    Limit(
        "inertia",
        "falling viscous string, all times",
        "rho at fixed rho g",
        (1.0, 0.1, 0.01),
        1 / 5,
        0.03,
        fading.inertia_always,
    ),
    Limit(
        "inertia",
        "falling viscous string, late",
        "rho at fixed rho g",
        (0.1, 0.01, 0.001),
        13 / 60,
        0.03,
        fading.inertia_late,
    ),
    Limit("inertia", "viscous beam", "rho at fixed rho g", (1e-2, 1e-3, 1e-4), 1, 0.02, fading.inertia_of_a_beam),
    Limit(
        "bending",
        "elastic cable between clamps",
        "l/L",
        (0.016, 0.008, 0.004),
        1,
        0.06,
        partial(fading.bending_of_a_cable, {}),
        _constant(1.0),
        0.04,
    ),
    Limit(
        "bending",
        "elastic cable between pins",
        "l/L",
        (0.04, 0.02, 0.01),
        3,
        0.06,
        partial(fading.bending_of_a_cable, fading.PINNED),
        _constant(20.0),
        0.04,
    ),
    Limit(
        "bending",
        "creeping string between pins, late",
        "h/L",
        (0.04, 0.02, 0.01),
        2,
        0.1,
        fading.bending_of_a_creeping_string,
    ),
    Limit(
        "extensibility",
        "clamped elastic beam",
        "H/h",
        (0.2, 0.1, 0.05),
        2,
        0.03,
        fading.extensibility_of_a_beam,
        _constant(fading.STIFFENING),
    ),
    *(
        Limit(
            name,
            "elastic cable",
            "mean strain",
            (0.02, 0.01, 0.005),
            1,
            0.03,
            partial(fading.geometry_of_a_cable, name),
            _constant(_GEOMETRY[name]),
        )
        for name in STRING
    ),
    Limit(
        "viscous-flow",
        "Maxwell cable",
        "duration E/eta",
        (0.1, 0.05, 0.025),
        1,
        0.03,
        fading.flow_of_a_cable,
        _constant(1 / 3),
    ),
    Limit(
        "viscous-stress",
        "Kelvin-Voigt beam under a ramp",
        "eta/(E ramp)",
        (0.02, 0.01, 0.005),
        1,
        0.02,
        fading.viscous_stress_of_a_beam,
        _constant(15 / 8),
    ),
    Limit(
        "yielding",
        "creeping string",
        "sigma_Y/(rho g L)",
        (0.4, 0.2, 0.1),
        1,
        0.03,
        fading.yielding_of_a_string,
        _constant(2 * fading.CREPT),
    ),
    Limit(
        "gravity-ramp",
        "creeping beam",
        "ramp/duration",
        (0.1, 0.05, 0.025),
        1,
        0.02,
        fading.ramp_of_a_creeping_beam,
        _constant(1 / 2),
    ),
    Limit("gravity-ramp", "swinging beam", "ramp [s]", (0.04, 0.02, 0.01), 1, 0.05, fading.ramp_of_a_swinging_beam),
    Limit(
        "shear",
        "clamped elastic beam",
        "h/L",
        (0.1, 0.05, 0.025),
        2,
        0.02,
        fading.shear_of_a_beam,
        _constant(8 * 1.45 * 6 / 5),
        0.01,
    ),
    Limit("fibres", "Bingham beam between pins", "sigma_Y/(rho g L)", (0.4, 0.2, 0.1), 2, 0.1, fading.fibres_of_a_beam),
    Limit(
        "necking-gradient",
        "Maxwell string between pins",
        "h/L",
        (0.1, 0.05, 0.025),
        2,
        0.04,
        fading.gradient_of_a_string,
    ),
    Limit(
        "rotary-inertia",
        "swinging clamped beam",
        "h/L",
        (0.05, 0.025, 0.0125),
        2,
        0.04,
        fading.rotation_of_a_beam,
        fading.rayleigh_share,
        0.04,
    ),
    Limit(
        "gravity-shaking",
        "swinging clamped beam",
        "a",
        (0.4, 0.2, 0.1),
        1,
        0.01,
        fading.shaking_of_a_beam,
        fading.duhamel_share,
        0.01,
    ),
    Limit(
        "surface-tension",
        "clamped beam",
        "F L^2/(E I)",
        (0.4, 0.2, 0.1),
        1,
        0.02,
        fading.surface_of_a_beam,
        lambda: 1 / 40,
        0.01,
    ),
    Limit(
        "solid-damping",
        "swinging clamped beam",
        "G''/G'",
        (0.02, 0.01, 0.005),
        1,
        0.04,
        fading.loss_of_a_beam,
        fading.loss_share,
        0.04,
    ),
)
"""Every limit; each effect has one or more."""
