"""Means of the Bingham rule over a section: the package's closed forms, and two references that know none of them."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

import numpy as np
import sympy as sp

from softcat_sym.physics.laws import bingham_means
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.symbols import E, eta, sigma_0, sigma_1, sigma_Y

MODULUS, VISCOSITY, YIELD = 4e6, 13.84e3, 9.32e3


@dataclass(frozen=True)
class Means:
    """<phi>, <phi zeta>, yielded fraction and largest rate."""

    rate: float
    moment: float
    yielded: float
    largest: float


@cache
def _compiled(section: str) -> Callable[..., tuple[float, ...]]:
    means = bingham_means(SECTIONS[section])
    moment = means.bending_rate * SECTIONS[section].zeta_squared
    expressions = [means.rate, moment, means.yielded_fraction, means.largest_rate]
    return sp.lambdify((sigma_0, sigma_1, sigma_Y, eta, E), expressions, modules="math")


def closed_form(section: str, mean: float, slope: float, *, threshold: float = YIELD) -> Means:
    """The package's means, where the stress is mean + slope zeta."""
    return Means(*_compiled(section)(mean, slope, threshold, VISCOSITY, MODULUS))


def flow_rule(stress: np.ndarray) -> np.ndarray:
    """<|sigma| - sigma_Y> sign(sigma)/eta."""
    return np.sign(stress) * np.maximum(np.abs(stress) - YIELD, 0.0) / VISCOSITY


def quadrature(section: str, mean: float, slope: float) -> Means:
    """Gauss quadrature in zeta = sin(angle), split at the yield points, where the flow rule has its kinks."""
    edges = [-1.0, 1.0]
    if slope != 0:
        edges += [zeta for zeta in ((YIELD - mean) / slope, (-YIELD - mean) / slope) if -1 < zeta < 1]
    angles = np.arcsin(np.sort(edges))
    nodes, weights = np.polynomial.legendre.leggauss(40)
    totals = np.zeros(3)
    for low, high in pairwise(angles):
        angle = (high + low) / 2 + (high - low) / 2 * nodes
        zeta = np.sin(angle)
        density = 2 / math.pi * np.cos(angle) if section == "circle" else np.full_like(zeta, 0.5)
        measure = weights * (high - low) / 2 * density * np.cos(angle)
        stress = mean + slope * zeta
        rate = flow_rule(stress)
        totals += [np.sum(measure * rate), np.sum(measure * rate * zeta), np.sum(measure * (np.abs(stress) > YIELD))]
    largest = float(np.max(np.abs(flow_rule(np.array([mean - slope, mean + slope])))))
    return Means(*map(float, totals), largest)


def paper(mean: float, slope: float, *, thickness: float, width: float) -> Means:
    """(2.26) and (2.27) of a rectangle in the paper's letters; T = A sigma_0, M = I sigma_1/(h/2), P_t = A<phi>,
    C_t = A (h/2)<phi zeta>.

    The section yields in -h/2 < z < z_L and z_H < z < h/2. A section that has yielded right through has z_L = z_H.
    """
    h, D, sY = thickness, width, YIELD
    T, M = mean * h * D, slope * (h**3 * D / 12) / (h / 2)
    z_L, z_H = -h / 2, h / 2
    if slope != 0:
        # sigma(z) = T/(D h) + 12 M z/(D h^3) = -+ sigma_Y, clipped to the section
        ends = sorted((sign * sY - mean) / (slope / (h / 2)) for sign in (-1, 1))
        z_L, z_H = (min(max(end, -h / 2), h / 2) for end in ends)
    elif abs(mean) > sY:
        z_L = z_H = 0.0
    top, bottom = math.copysign(1, 6 * M + h * T), math.copysign(1, 6 * M - h * T)
    P_t = (
        (1 + (z_L - z_H) / h) * T
        + 6 * M * (z_L**2 - z_H**2) / h**3
        + (z_H - h / 2) * D * sY * top
        + (z_L + h / 2) * D * sY * bottom
    ) / VISCOSITY
    C_t = (
        (1 - 4 * (z_H**3 - z_L**3) / h**3) * M
        + T * (z_L**2 - z_H**2) / (2 * h)
        + (z_H**2 / 2 - h**2 / 8) * D * sY * top
        + (z_L**2 / 2 - h**2 / 8) * D * sY * bottom
    ) / VISCOSITY
    fraction = (z_L + h / 2 + h / 2 - z_H) / h
    return Means(P_t / (h * D), C_t / (h * D * h / 2), fraction, math.nan)


def sign_cases() -> dict[str, tuple[float, float]]:
    """(sigma_0, sigma_1) in units of the yield stress: every way to yield, in all four quadrants."""
    cases = {
        "rest": (0.0, 0.0),
        "below everywhere": (0.3, 0.4),
        "exactly at yield on one side": (0.25, 0.75),
        "exactly at yield, pure bending": (0.0, 1.0),
        "one side": (0.5, 1.2),
        "one side, barely": (0.5, 0.5001),
        "both sides": (0.2, 3.0),
        "both sides, pure bending": (0.0, 2.5),
        "half in tension": (1.0, 2.0),
        "right through": (3.0, 0.7),
        "right through, exactly": (2.0, 1.0),
        "right through, uniform": (1.7, 0.0),
        "uniform below": (0.7, 0.0),
        "nearly uniform above": (1.7, 1e-9),
        "nearly uniform at yield": (1.0, 1e-9),
        "very steep": (0.5, 500.0),
        "very far": (400.0, 3.0),
    }
    return {
        f"{name} {'+-'[a < 0]}{'+-'[b < 0]}": (a * mean, b * slope)
        for name, (mean, slope) in cases.items()
        for a in (1, -1)
        for b in (1, -1)
    }
