"""How a section is sampled in both of its directions, and how it warps where it twists (THEORY3D 6)."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.physics.cross_sections import CROSS_SECTIONS

POINT_TABLES = ("Y_f", "Z_f", "W_2", "W_3", "weight")
"""Numbers of a point, by the names of their symbols."""

_TERMS = 60
"""Of Prandtl's stress function: the last is 1e-7 of the first."""


def spatial_rule(Y: Floats, Z: Floats, W_2: Floats, W_3: Floats, weight: Floats) -> SectionRule:
    """Points at places Y and Z with what a twist shears there along either axis; lengths over h0/2.

    The shear is (-Z, Y) of a circle, Saint-Venant's of a rectangle.
    """
    return SectionRule.of_points(dict(zip(POINT_TABLES, (Y, Z, W_2, W_3, weight), strict=True)))


def ring_rule(rings: int, angles: int) -> SectionRule:
    """Points of a circle: Gauss in the square of the radius, equal angles, every second ring turned by half of one.

    They mirror each other in the plane of d1 and d2, so that what is planar stays in the plane.
    """
    square, share = np.polynomial.legendre.leggauss(rings)
    radius = np.sqrt((square + 1) / 2)
    turned = 2 * np.pi / angles * (np.arange(angles) + 0.5 * (np.arange(rings)[:, None] % 2))
    Y, Z = (radius[:, None] * part(turned) for part in (np.cos, np.sin))
    weight = np.repeat(share / 2 / angles, angles)
    return spatial_rule(Y.ravel(), Z.ravel(), -Z.ravel(), Y.ravel(), weight)


@lru_cache(maxsize=64)
def warping_rule(across: int, beside: int, aspect: float) -> SectionRule:
    """Gauss points of a rectangle of width over thickness `aspect`, which warps freely where it twists (Saint-Venant).

    What a twist shears is the slope of Prandtl's function, scaled so that the torsional stiffness is exact.
    """
    (y, share_y), (z, share_z) = (np.polynomial.legendre.leggauss(count) for count in (across, beside))
    Y, Z = (part.ravel() for part in np.meshgrid(y, aspect * z, indexing="ij"))
    weight = np.outer(share_y, share_z).ravel() / 4
    # (phi_Z, -phi_Y) of phi = 1 - Y^2 - sum a_n cos(k_n Y) cosh(k_n Z)/cosh(k_n s), lap phi = -2, zero on the edge.
    term = np.arange(_TERMS)[:, None]
    k = (2 * term + 1.0) * np.pi / 2
    a = 4 / k**3 * (-1.0) ** term
    # cosh(k Z)/cosh(k s) and sinh likewise, of what does not overflow.
    grown, faded = np.exp(k * (np.abs(Z) - aspect)), np.exp(-k * (np.abs(Z) + aspect))
    below = 1 + np.exp(-2 * k * aspect)
    even, odd = (grown + faded) / below, np.sign(Z) * (grown - faded) / below
    along_Y = -2 * Y + np.sum(a * k * np.sin(k * Y) * even, axis=0)
    along_Z = -np.sum(a * k * np.cos(k * Y) * odd, axis=0)
    W_2, W_3 = along_Z, -along_Y
    scale = np.sqrt(4 * CROSS_SECTIONS["rectangle"].torsion(aspect) / np.sum(weight * (W_2**2 + W_3**2)))
    return spatial_rule(Y, Z, scale * W_2, scale * W_3, weight)
