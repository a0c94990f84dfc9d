"""How a section is sampled in both of its directions, and how it warps where it twists (THEORY3D 6)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import ClassVar

import numpy as np

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.physics.cross_sections import CROSS_SECTIONS

POINT_TABLES = ("Y_f", "Z_f", "W_2", "W_3", "weight")
"""Numbers of a point, by the names of their symbols."""

_TERMS = 60
"""Of Prandtl's stress function: the last is 1e-7 of the first."""


@dataclass(frozen=True)
class PointRule:
    """Points of a section, with what a twist shears there; lengths over h0/2."""

    Y: Floats  # shape (points,); Places
    Z: Floats
    W_2: Floats  # Shear along either axis by a twist: (-Z, Y) of a circle, Saint-Venant's of a rectangle
    W_3: Floats
    weight: Floats  # They sum to one

    @property
    def points(self) -> int:
        """Number of points."""
        return len(self.weight)

    is_spatial: ClassVar[bool] = True
    heading: ClassVar[str] = """\
/* Places of the points of a section, what a twist shears there, over half the thickness, and their shares of it. */"""

    @property
    def is_of_fibres(self) -> bool:
        """Whether every point has plastic states of its own, as here."""
        return True

    @property
    def recall(self) -> Floats:
        """Every point has its own states."""
        return np.eye(self.points)

    project = recall

    @property
    def across(self) -> Floats:
        """Nothing of its states is linear through the thickness."""
        return np.zeros(self.points)

    @property
    def tables(self) -> Mapping[str, Floats]:
        """Its numbers, by the names of the symbols of a point."""
        return dict(zip(POINT_TABLES, (self.Y, self.Z, self.W_2, self.W_3, self.weight), strict=True))

    @property
    def labels(self) -> tuple[str, ...]:
        """What the plastic states of one kind are called, besides their kind."""
        return tuple(str(number) for number in range(self.points))

    @property
    def label(self) -> str:
        """All of its numbers."""
        return ", ".join(repr(part.tolist()) for part in self.tables.values())

    @property
    def places(self) -> list[dict[str, float]]:
        """Numbers of every point."""
        return [{name: float(table[k]) for name, table in self.tables.items()} for k in range(self.points)]


def ring_rule(rings: int, angles: int) -> PointRule:
    """Points of a circle: Gauss in the square of the radius, equal angles, every second ring turned by half of one.

    They mirror each other in the plane of d1 and d2, so that what is planar stays in the plane.
    """
    square, share = np.polynomial.legendre.leggauss(rings)
    radius = np.sqrt((square + 1) / 2)
    turned = 2 * np.pi / angles * (np.arange(angles) + 0.5 * (np.arange(rings)[:, None] % 2))
    Y, Z = (radius[:, None] * part(turned) for part in (np.cos, np.sin))
    weight = np.repeat(share / 2 / angles, angles)
    return PointRule(Y.ravel(), Z.ravel(), -Z.ravel(), Y.ravel(), weight)


@lru_cache(maxsize=64)
def warping_rule(across: int, beside: int, aspect: float) -> PointRule:
    """Gauss points of a rectangle of width over thickness `aspect`, which warps freely where it twists (Saint-Venant).

    What a twist shears is the slope of Prandtl's function, scaled so that the torsional stiffness is exact.
    """
    (y, share_y), (z, share_z) = (np.polynomial.legendre.leggauss(count) for count in (across, beside))
    Y, Z = (part.ravel() for part in np.meshgrid(y, aspect * z, indexing="ij"))
    weight = np.outer(share_y, share_z).ravel() / 4
    W_2, W_3 = _slope_of_prandtl(Y, Z, aspect)
    scale = np.sqrt(4 * CROSS_SECTIONS["rectangle"].torsion(aspect) / np.sum(weight * (W_2**2 + W_3**2)))
    return PointRule(Y, Z, scale * W_2, scale * W_3, weight)


def _slope_of_prandtl(Y: Floats, Z: Floats, aspect: float) -> tuple[Floats, Floats]:
    """(phi_Z, -phi_Y) of phi = 1 - Y^2 - sum a_n cos(k_n Y) cosh(k_n Z)/cosh(k_n s), lap phi = -2, zero on the edge."""
    term = np.arange(_TERMS)[:, None]
    k = (2 * term + 1.0) * np.pi / 2
    a = 4 / k**3 * (-1.0) ** term
    # cosh(k Z)/cosh(k s) and sinh likewise, of what does not overflow.
    grown, faded = np.exp(k * (np.abs(Z) - aspect)), np.exp(-k * (np.abs(Z) + aspect))
    below = 1 + np.exp(-2 * k * aspect)
    even, odd = (grown + faded) / below, np.sign(Z) * (grown - faded) / below
    along_Y = -2 * Y + np.sum(a * k * np.sin(k * Y) * even, axis=0)
    along_Z = -np.sum(a * k * np.cos(k * Y) * odd, axis=0)
    return along_Z, -along_Y
