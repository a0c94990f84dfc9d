"""Straight beams and catenaries: first yield, plastic collapse and arrest (3.9)-(3.14).

What is rational is a fraction, exact in numbers and in expressions; what takes an `m` is a formula of numbers, or with
SymPy as `m` of symbols. derivations/05_regimes.py derives them.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import numpy as np

from softcat_sym.physics.cross_sections import CrossSection
from softcat_sym.scene.ends import Support


def clamped_relief(psi: Any, m: Any = math) -> Any:
    """Share of a clamp's static moment that a steady tension leaves, of psi = (L/2) sqrt(T/(E I))."""
    return 3 * (psi / m.tanh(psi) - 1) / psi**2


def propped_relief(psi: Any, m: Any = math) -> Any:
    """The same of a beam with a clamp and a pin: the pin answers the clamp by the carry-over of a beam in tension."""
    carried = (m.sinh(2 * psi) - 2 * psi) / (2 * psi * m.cosh(2 * psi) - m.sinh(2 * psi))
    return 2 * (1 + carried) * clamped_relief(psi, m) / 3


def pinned_relief(psi: Any, m: Any = math) -> Any:
    """The same at midspan of a beam between pins."""
    return 2 * (1 - 1 / m.cosh(psi)) / psi**2


def no_relief(psi: Any, m: Any = math) -> Any:
    """A free end carries no tension."""
    del psi, m
    return 1


@dataclass(frozen=True, slots=True)
class Beam:
    """A straight beam of span L under its own weight q per length, by the way its ends are held."""

    largest_moment: Fraction | float  # Largest static bending moment over q L^2
    midspan_sag: Fraction | float  # Static elastic sag at midspan over q L^4/(E I)
    # Bound on the largest moment over the static one, when the weight is applied at once and no mode is damped: the
    # moment that all modes add up to when all are at their worst.
    overshoot_bound: float
    collapse: float  # q L^2 over the fully plastic moment when enough hinges have formed for it to give way
    shear_sag: Fraction  # Midspan sag by shear alone over q L^2/(kappa_s mu A)
    frequency: float  # First natural one, (b L)^2 of omega = (b L)^2 sqrt(E I/(rho A L^4))
    relief: Callable[..., Any]  # Share of the largest static moment that a steady tension leaves, of psi


_F = Fraction
CLAMPED = Beam(_F(1, 12), _F(1, 384), 2.0, 16.0, _F(1, 8), 4.730041**2, clamped_relief)
PROPPED = Beam(_F(1, 8), _F(1, 192), 2.0, 6 + 4 * math.sqrt(2), _F(1, 8), 3.926602**2, propped_relief)
PINNED = Beam(_F(1, 8), _F(5, 384), 2.0855090288816704, 8.0, _F(1, 8), math.pi**2, pinned_relief)  # 1 + 28 zeta(3)/pi^3
CANTILEVER = Beam(_F(1, 2), _F(17, 384), 2.0, 2.0, _F(3, 8), 1.875104**2, no_relief)
"""One end clamped, the other free; the sag is that of the middle."""


def beam_between(left: Support, right: Support) -> Beam:
    """The beam between two ends; with a free one, the cantilever that the other must hold."""
    if left.is_free or right.is_free:
        return CANTILEVER
    return (PINNED, PROPPED, CLAMPED)[left.carries_moment + right.carries_moment]


def beam_on_springs(nearest: Beam, places: tuple[float, float], turns: tuple[float, float]) -> Beam:
    """A beam whose ends are held by springs, of stiffness k L^3/(E I) and c L/(E I), infinite where they are rigid.

    Of deflection, moments and frequency (Rayleigh's quotient of the static shape); the rest is that of the nearest
    beam, which gives way to plastic hinges and to tension much like it.
    """
    springs = np.array([places[0], turns[0], places[1], turns[1]])
    free = np.isfinite(springs)
    bending = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4.0]])
    moved, clamped = np.zeros(4), np.array([1 / 2, 1 / 12, 1 / 2, -1 / 12])
    moved[free] = np.linalg.solve((bending + np.diag(np.where(free, springs, 0.0)))[np.ix_(free, free)], clamped[free])
    x = np.linspace(0.0, 1.0, 201)
    hermite = np.array([1 - 3 * x**2 + 2 * x**3, x * (1 - x) ** 2, 3 * x**2 - 2 * x**3, x**2 * (x - 1)])
    curved = np.array([12 * x - 6, 6 * x - 4, 6 - 12 * x, 6 * x - 2])
    sag, moment = moved @ hermite + x**2 * (1 - x) ** 2 / 24, moved @ curved + (1 - 6 * x + 6 * x**2) / 12
    frequency = math.sqrt(np.sum(sag) / np.sum(sag**2))
    largest = float(np.max(np.abs(moment)))
    return replace(nearest, largest_moment=largest, midspan_sag=float(sag[100]), frequency=frequency)


def first_yield(section: CrossSection, beam: Beam, slenderness: float) -> float:
    """G at which the most stressed fibre yields under a slowly applied weight (3.11)."""
    return 2 * section.gyration * slenderness / float(beam.largest_moment)


def plastic_collapse(section: CrossSection, beam: Beam, slenderness: float) -> float:
    """G at which a straight perfectly plastic beam turns into a mechanism."""
    return beam.collapse * section.mean_lever * slenderness / 2


def stretched_first_yield(psi: Any, gyration: Any, slenderness: Any, m: Any = math) -> tuple[Any, Any]:
    """(eps_Y, G) at first yield of a clamped filament with bending and tension in the balance, along psi."""
    coth = m.cosh(psi) / m.sinh(psi)
    slopes = (2 * psi**2 + 12) / (3 * psi**2) - 3 * coth / psi - 1 / m.sinh(psi) ** 2
    slope = 4 * slenderness * psi * m.sqrt(gyration / slopes)
    strain = 4 * gyration * slenderness**2 * psi**2 + slenderness * slope * (psi * coth - 1)
    return strain, 8 * gyration * slenderness**2 * psi**2 * slope / strain


def ramp_gain(k: Any, m: Any = math) -> Any:
    """Share of a mode's ringing that is left when gravity is switched on by the quintic step, of omega g_on; signed."""
    return 120 * ((12 - k**2) * m.sin(k / 2) - 6 * k * m.cos(k / 2)) / k**5


ARREST_THRESHOLD = math.sqrt(2)
"""G above which the shallow catenary of the paper finds no sag to rest at (3.12)."""

_LIGHTEST = 1.1996786402577338
"""The u of the lightest stressed catenary, u tanh u = 1."""

ARREST_THRESHOLD_EXACT = 2 * math.sqrt(_LIGHTEST**2 - 1)
"""G above which no catenary can be held: 1.3255."""


def stopping_depth(gravity_number: float) -> float:
    """H_stop/L of the shallow catenary (3.13)."""
    return 1 / (2 * gravity_number) - math.sqrt((1 / (2 * gravity_number)) ** 2 - 1 / 8)


def stopping_depth_exact(gravity_number: float) -> float:
    """H_stop/L of the exact catenary, whose largest stress is the yield stress: G cosh u = 2 u, the smaller root."""
    u = gravity_number / 2
    for _ in range(100):
        # From the left of a convex function's root no step goes too far.
        step = (gravity_number * math.cosh(u) - 2 * u) / (2 - gravity_number * math.sinh(u))
        u = min(u + step, _LIGHTEST)
        if step < 1e-15 * u:
            break
    return (math.cosh(u) - 1) / (2 * u)
