"""How far a filament falls past the catenary that would hold it, and how it stops: one parabola, one number.

A parabola of sag h (in spans, time in sqrt(L/g)) whose stress is the yield stress and what viscosity adds to it,
sigma/(rho g L) = 1/G + (16/3) V h h', obeys in Galerkin's sense h'' = 5/4 - 10 h sigma/(rho g L). With h = (G/8) u and
time in sqrt(G/10) this is u'' = 1 - u - D u^2 u', D = (5/6) sqrt(1/10) V G^(5/2): it rests at u = 1, the small-sag
limit of (3.13), and stops first at 2 if nothing damps it, sooner if D does, at 1 from D = 3.5 on.
"""

from __future__ import annotations

import math

import numpy as np

from softcat_sym.effects.necks import neck_length
from softcat_sym.equations import regimes
from softcat_sym.scene import Scene, rest_length

_DAMPING = (0.0, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 1.3, 1.6, 2.0, 2.5, 3.0, 3.25, 3.5)
_PAST = (1.0, 0.981, 0.945, 0.841, 0.729, 0.643, 0.517, 0.425, 0.325, 0.250, 0.191, 0.129, 0.0695, 0.0239, 0.0059, 0.0)
"""u - 1 where u first stops, of D: from u'' = 1 - u - D u^2 u'."""


def damping(gravity_number: float, viscous: float) -> float:
    """D = (5/6) sqrt(1/10) V G^(5/2)."""
    return 5 / 6 * math.sqrt(0.1) * viscous * math.pow(gravity_number, 2.5)


def ringing_share(frequency: float, ramp: float) -> float:
    """Share of the swing that a ramp of gravity leaves: 1 for none, 0 for a slow one (the quintic step, section 3)."""
    number = frequency * ramp
    if number < 1e-2:
        return 1.0
    return abs(float(regimes.ramp_gain().subs(regimes.k_on, number)))


def overshoot(gravity_number: float, viscous: float, ramp: float) -> float:
    """u: where the filament first stops, over the depth at which it could rest.

    Parameters
    ----------
    gravity_number, viscous : float
        G and V (3.10).
    ramp : float
        Time over which gravity is switched on, in sqrt(L/g).
    """
    past = float(np.interp(damping(gravity_number, viscous), _DAMPING, _PAST))
    return 1 + past * ringing_share(math.sqrt(10 / gravity_number), ramp)


def rebound(gravity_number: float, yield_strain: float, past: float) -> float:
    """How far the elastic filament springs back once it has stopped, over its sag.

    It swings about the depth at which the elastic stress, 1/G + (16/3) E* h (h - h_stop) less than that of the stop,
    carries the weight; to twice that distance: 2 (1 - 1/u)/(1 + G^2 u^2/(12 eps_Y)).

    Parameters
    ----------
    gravity_number, yield_strain : float
        G and eps_Y (3.9, 3.10).
    past : float
        u, of :func:`overshoot`.
    """
    return 2 * (1 - 1 / past) / (1 + (gravity_number * past) ** 2 / (12 * yield_strain))


def hinge_pace(gravity_number: float, viscous: float, sag: float, time: float) -> float:
    """Plastic rate that is left at a clamp after a time, over sigma_Y/eta.

    The hinge must turn by 4 h. A viscous beam under the tension A sigma_Y turns over the length
    sqrt(eta I/(A sigma_Y t)), which narrows: its outer fibre flows at 4 sqrt(3) h sqrt(G V/t) sigma_Y/eta.
    """
    return 4 * math.sqrt(3) * sag * math.sqrt(gravity_number * viscous / time) if time > 0 else math.inf


def neck_draw(scene: Scene, gravity_number: float, viscous: float, sag: float) -> float:
    """Strain of the necks at the two ends, when the elongation of the fall gathers there.

    A neck grows at sigma_Y/eta while the section flows, for the half period pi sqrt(G/10) of the fall: of the
    elongation (8/3) h^2 of the span the share 1 - exp(-pi sqrt(G/10)/(G V)) goes into two necks, none shorter than pi
    sqrt(beta) h0 (Audoly & Hutchinson 2016).
    """
    if viscous == 0:
        gathered = 1.0
    else:
        gathered = -math.expm1(-math.pi * math.sqrt(gravity_number / 10) / (gravity_number * viscous))
    return gathered * 8 / 3 * sag**2 * rest_length(scene) / (2 * neck_length(scene))
