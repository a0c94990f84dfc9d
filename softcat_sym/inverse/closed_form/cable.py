"""The lowest symmetric mode of a sagging elastic cable, from its frequency back to its modulus.

Irvine and Caughey, Proc. R. Soc. Lond. A 341 (1974) 299; derived in derivations/07_rheometry. A parabolic cable of sag
H carries its weight by the tension rho g A L^2/(8 H). Its symmetric modes obey tan x = x - 4 x^3/l^2 with x = (w/2)
sqrt(8 H/g) and the number l^2 = 512 (H/L)^3 E/(rho g L). The mode is no parabola: it goes from one arch (l = 0, 2x =
pi) to three of one length (l large, 2x = 8.99), where the frequency says nothing about the modulus. A string that sags
by its own elasticity has l^2 = 24, one that has crept for a time t after that has about 24 + 36 t/tau; (2.21) holds the
shape and overestimates the frequency for any of them. By correspondence a Maxwell cable has E s/(s + 1/tau) for E and
-i s for w.
"""

from __future__ import annotations

import cmath
import math
from typing import NamedTuple

SLACKEST = 8.9868
"""w sqrt(8 H/g) of an inextensible cable: 2x where tan x = x."""

TAUTEST = math.pi
"""The same of a taut string."""


class CableModulus(NamedTuple):
    """What the ringing of a Maxwell cable says.

    Attributes
    ----------
    modulus : float
        E/(rho g L).
    relaxation_time : float
        tau [s]; infinite or negative where the decay is less than none.
    """

    modulus: float
    relaxation_time: float


def mode_number(frequency: float, sag: float, gravity: float) -> float:
    """R sqrt(8 H/g): between pi (taut) and 8.99 (inextensible) in the lowest symmetric mode."""
    return frequency * math.sqrt(8 * sag / gravity)


def stiffness_number(mode: complex) -> complex:
    """l^2 of a mode number 2x; infinite where 2x = `SLACKEST`."""
    half = mode / 2
    return 4 * half**3 / (half - cmath.tan(half))


def sensitivity(mode: float) -> float:
    """Slope d log E/d log R at given sag; infinite outside of the lowest mode."""
    if not TAUTEST < mode < SLACKEST:
        return math.inf
    half = mode / 2
    return 3 - half * -(math.tan(half) ** 2) / (half - math.tan(half))


def modulus_of(frequency: float, decay: float, sag: float, gravity: float, span: float) -> CableModulus | None:
    """Modulus and relaxation time of a cable that rings at R with a decay rate d about a sag H.

    Parameters
    ----------
    frequency, decay : float
        R [rad/s], d [1/s].
    sag, gravity, span : float
        H [m], g [m/s^2], L [m].

    Returns
    -------
    CableModulus or None
        None if no cable rings so fast or so slowly about this sag in its lowest symmetric mode.
    """
    if not TAUTEST < mode_number(frequency, sag, gravity) < SLACKEST:
        return None
    # K s/(s + 1/tau) = l^2 for a complex s = -d + i R: its imaginary part gives tau, then its real part K.
    inverse = 1 / stiffness_number(complex(frequency, decay) * math.sqrt(8 * sag / gravity))
    reciprocal = inverse.real - decay / frequency * inverse.imag
    if reciprocal <= 0:
        return None
    number = 1 / reciprocal
    rate = -number * inverse.imag * (frequency**2 + decay**2) / frequency
    return CableModulus(number / (512 * (sag / span) ** 3), 1 / rate if rate else math.inf)
