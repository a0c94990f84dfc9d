"""How a section is sampled through its thickness, and what its plastic state stands for.

Fibres: one plastic strain at each point of a Gauss rule, or of one in either half. Order k: amplitudes of the
orthogonal polynomials p_0 ... p_k (A 1), whose rates are projections by the same kind of rule (A 2). With k + 1 points
of one rule both are the same.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np

from softcat_sym.discretization.unknowns import PER_FIBRE, Floats
from softcat_sym.physics.cross_sections import CROSS_SECTIONS

_MIN_IN_HALVES = 6
"""Points from which on rules in the two halves are as good as one for what is smooth."""

_MOMENT_POINTS = 200
"""Of the sums that stand for integrals over a half; they are exact for what they are taken of."""


@dataclass(frozen=True)
class SectionRule:
    """Points of a section, through its thickness or in both directions, and the states of their plastic strain."""

    # Of every point its zeta, or in space what `POINT_TABLES` names, and its weight; the weights sum to one.
    tables: Mapping[str, Any]
    recall: Floats  # shape (points, states); Plastic strain at the points of the states
    # shape (states, points); Rates of the states of the rates at the points; ``project @ recall`` is the identity.
    project: Floats
    stands_for_all: bool = False  # Whether it is one point of symbols, for code that loops over points

    @classmethod
    def of_points(cls, tables: Mapping[str, Any], *, stands_for_all: bool = False) -> SectionRule:
        """Points with plastic states of their own."""
        points = len(tables["weight"])
        return cls(tables, np.eye(points), np.eye(points), stands_for_all)

    @property
    def zeta(self) -> Floats:
        """Places through the thickness, shape (points,)."""
        return np.asarray(self.tables["zeta"])

    @property
    def weight(self) -> Floats:
        """Shares of the section, shape (points,)."""
        return np.asarray(self.tables["weight"])

    @property
    def points(self) -> int:
        """Number of points."""
        return len(self.tables["weight"])

    @property
    def states(self) -> int:
        """Number of plastic states of one kind."""
        return int(self.recall.shape[1])

    @property
    def is_spatial(self) -> bool:
        """Whether the points are those of a filament in three dimensions."""
        return "zeta" not in self.tables

    @property
    def is_of_fibres(self) -> bool:
        """Whether every point has plastic states of its own."""
        return self.recall.shape[0] == self.recall.shape[1] and bool(np.all(self.recall == np.eye(self.points)))

    @property
    def labels(self) -> tuple[str, ...]:
        """What the plastic states of one kind are called, besides their kind."""
        return (PER_FIBRE,) if self.stands_for_all else tuple(map(str, range(self.states)))

    @property
    def point_labels(self) -> tuple[str, ...]:
        """What the points are called."""
        return (PER_FIBRE,) if self.stands_for_all else tuple(map(str, range(self.points)))

    @property
    def places(self) -> list[dict[str, Any]]:
        """Numbers of every point."""
        return [{name: table[k] for name, table in self.tables.items()} for k in range(self.points)]

    @property
    def across(self) -> Floats:
        """Place of every point through the thickness, from -1 to 1; of one that stands for all over its own."""
        if self.is_spatial:
            return np.zeros(self.points)
        return np.ones(1) if self.stands_for_all else self.zeta

    @property
    def label(self) -> str:
        """All of its numbers."""
        return ", ".join(repr(np.asarray(part).tolist()) for part in (*self.tables.values(), self.recall, self.project))

    @property
    def heading(self) -> str:
        """Comment above its tables in C."""
        if self.is_spatial:
            what = "Places of the points of a section, what a twist shears there, over half the thickness, and"
            return f"/* {what} their shares of it. */"
        return "/* Coordinate of each fibre, from -1 to 1 through the thickness, and its share of the section. */"


@lru_cache(maxsize=64)
def fibre_rule(section: str, fibres: int, *, halves: bool = False) -> SectionRule:
    """A plastic state for each of `fibres` points of the section's Gauss rule, or of one in either half of it.

    Where a section yields in bending its stress jumps in the middle. A rule through the whole thickness gives it a
    plastic moment 0.75/n^2 too high, and a hinge near collapse goes by that moment: rules in the two halves have it
    exactly. What yields in tension from face to face is smooth, and better off with one rule through all of it, as are
    few points, and an odd number of them.
    """
    split = halves and fibres >= _MIN_IN_HALVES and fibres % 2 == 0
    nodes, weights = _in_halves(section, fibres) if split else _gauss(section, fibres)
    return SectionRule.of_points({"zeta": nodes, "weight": weights})


def order_rule(section: str, order: int, points: int) -> SectionRule:
    """Amplitudes of p_0 ... p_order, projected with `points` points (at least order + 1)."""
    nodes, weights = _gauss(section, max(points, order + 1))
    values = polynomials(section, nodes, order)
    # <p_n^2> of Legendre's and of Chebyshev's.
    squares = [1 / (n + 1) ** 2 if section == "circle" else 1 / (2 * n + 1) for n in range(order + 1)]
    tables = {"zeta": nodes, "weight": weights}
    return SectionRule(tables, values, weights * values.T / np.array(squares)[:, None])


def polynomials(section: str, places: Floats, order: int) -> Floats:
    """p_0 to p_n, orthogonal under the width of the section with p_n(1) = 1 (A 1), shape (places, order + 1)."""
    if section != "circle":
        return np.asarray(np.polynomial.legendre.legvander(places, order), dtype=float)
    found = [np.ones_like(places), 2 * places]
    while len(found) <= order:
        found.append(2 * places * found[-1] - found[-2])
    return np.column_stack([one / (n + 1) for n, one in enumerate(found[: order + 1])])


def _gauss(section: str, points: int) -> tuple[Floats, Floats]:
    """Nodes and weights for the width of the section: Legendre's, or Chebyshev's of the second kind for a circle."""
    if section == "circle":
        angle = np.arange(points, 0, -1) * np.pi / (points + 1)
        return np.cos(angle), 2 / (points + 1) * np.sin(angle) ** 2
    nodes, weights = np.polynomial.legendre.leggauss(points)
    return nodes, weights / 2


def _in_halves(section: str, points: int) -> tuple[Floats, Floats]:
    """Nodes and weights of a Gauss rule for the width of the section in the upper half, and their mirror image."""
    if section == "circle":
        angle, share = np.polynomial.legendre.leggauss(_MOMENT_POINTS)
        angle = (angle + 1) * np.pi / 4
        nodes, weights = _gauss_of_sums(np.cos(angle), share / 2 * np.sin(angle) ** 2, points // 2)
    else:
        nodes, weights = np.polynomial.legendre.leggauss(points // 2)
        nodes, weights = (nodes + 1) / 2, weights / 4
    return np.concatenate([-nodes[::-1], nodes]), np.concatenate([weights[::-1], weights])


def _gauss_of_sums(places: Floats, masses: Floats, points: int) -> tuple[Floats, Floats]:
    """Gauss rule of a weight that is given as many masses: its three-term recurrence (Stieltjes; Golub & Welsch)."""
    before, now = np.zeros_like(places), np.ones_like(places)
    centre, spread, norm = np.zeros(points), np.zeros(points), float(np.sum(masses))
    for k in range(points):
        centre[k] = np.sum(masses * places * now**2) / np.sum(masses * now**2)
        following = (places - centre[k]) * now - spread[k] * before
        if k + 1 < points:
            spread[k + 1] = np.sum(masses * following**2) / np.sum(masses * now**2)
        before, now = now, following
    beside = np.sqrt(spread[1:])
    nodes, vectors = np.linalg.eigh(np.diag(centre) + np.diag(beside, 1) + np.diag(beside, -1))
    return nodes, norm * vectors[0] ** 2


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


POINT = "point_"
"""Beginning of the names of what single points of a section show."""


def shown_of_points(observed: dict[str, Floats]) -> dict[str, Floats]:
    """Take out of fields (frames, cells) what points show, and put it together by kind: (frames, points, cells)."""
    kinds = dict.fromkeys(name.rpartition("_")[0] for name in observed if name.startswith(POINT))
    rows = {kind: [name for name in observed if name.rpartition("_")[0] == kind] for kind in kinds}
    return {kind: np.stack([observed.pop(name) for name in names], axis=1) for kind, names in rows.items()}


def shown_of_section(points: dict[str, Floats], rule: SectionRule) -> dict[str, Floats]:
    """What a run stores of a section that is resolved: means, limits and largest of what its points show.

    Parameters
    ----------
    points : dict
        Of each kind, whose name begins with `POINT`, shape (frames, points, cells).
    rule : SectionRule
        Where the points are.

    Returns
    -------
    dict
        Fields of the section (frames, cells).
    """
    if not points:
        return {}
    kinds = {name.removeprefix(POINT): values for name, values in points.items()}
    yields, speed = kinds.pop("yields"), kinds.pop("speed")
    found = {"yielded_fraction": rule.weight @ yields, "plastic_rate": speed.max(axis=1)}
    if not rule.is_spatial:
        axial = kinds.pop("axial")
        slope = rule.weight * rule.zeta / float(rule.weight @ rule.zeta**2)
        # Limits in zeta of what does not yield, between the fibres that do on either side and those that do not. Where
        # the whole thickness yields both limits have met on the opposite faces: they are put together.
        edges = np.concatenate([[-1.0], (rule.zeta[1:] + rule.zeta[:-1]) / 2, [1.0]])
        widths = np.diff(edges)
        low = -1 + _yielded_from_face(widths, yields)
        high = 1 - _yielded_from_face(widths[::-1], yields[:, ::-1])
        found |= dict(zip(("core_low", "core_high"), (low, np.maximum(low, high)), strict=True))
        found |= {"stress_mean": rule.weight @ axial, "stress_bending": slope @ axial}
    return found | {kind: rule.weight @ values for kind, values in kinds.items()}


def _yielded_from_face(widths: Floats, yields: Floats) -> Floats:
    """Width of what yields from the first fibre on without a gap."""
    total, so_far = np.zeros_like(yields[:, 0]), np.ones_like(yields[:, 0])
    for k, width in enumerate(widths):
        so_far = so_far * yields[:, k]
        if not so_far.any():
            break
        total += width * so_far
    return total
