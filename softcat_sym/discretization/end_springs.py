"""The springs of elastic ends: one energy each, of the place and the turn of an end node, and its derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from softcat_sym.discretization.cell import Builder
from softcat_sym.discretization.parameters import AREA
from softcat_sym.discretization.stencil import Field, Neighbours
from softcat_sym.discretization.unknowns import SiteRange
from softcat_sym.physics import spatial
from softcat_sym.scene.ends import Hold

_ROUND = 1e-24
"""Square of half the turn of a spring below which it counts as none: a root is taken of it."""


@dataclass(frozen=True)
class EndSpring:
    """The springs of one end; all per unit undeformed area."""

    site: int  # 0 or -1
    energy: ca.SX  # Over the rest length [Pa]
    pull: list[ca.SX]  # Force on the node [Pa]
    by_turn: list[ca.SX]  # Derivatives of the energy by the angle of the section, or by its quaternion [Pa]

    def acts(self, before: int | None, behind: int | None) -> bool:
        """Whether it acts on the node between cells at these distances."""
        return (before if self.site == 0 else behind) is None

    @property
    def stored(self) -> Field:
        """Its energy, to be audited."""
        return Field(f"spring_{'last' if self.site else 'first'}", SiteRange(self.site, 0, alone=True), self.energy)


def end_springs(
    b: Builder, places: Sequence[Neighbours], turn: Sequence[Neighbours], held: tuple[Sequence[ca.SX], Sequence[ca.SX]]
) -> tuple[EndSpring, ...]:
    """Springs between the end nodes and their supports, which hold an angle or a quaternion each.

    A spring is alike in all directions: k |r - r_0|^2/2, and c/2 times the square of the angle between the section and
    its support, about whatever axis.
    """
    at, found = b.supports, []
    origins = (at.left_x, ca.SX(0), ca.SX(0)), (at.right_x, at.right_y, at.right_z)
    for side, site, support, origin, frame in zip(
        ("left", "right"), (0, -1), (b.first, b.last), origins, held, strict=True
    ):
        energy, q = ca.SX(0), ca.SX.sym("end", len(places) + len(turn))
        moved, turned = ca.vertsplit(q[: len(places)]), ca.vertsplit(q[len(places) :]) if turn else []
        if support.y is Hold.SPRING:
            off = sum(((one - zero) ** 2 for one, zero in zip(moved, origin, strict=False)), ca.SX(0))
            energy += b.named[f"{side}_stiffness"] * b.span / 2 * off
        if support.angle is Hold.SPRING and turned:
            energy += b.named[f"{side}_rotational_stiffness"] / b.span / 2 * _angle(turned, frame) ** 2
        if not energy.is_zero():
            energy = energy / b.named[AREA]
            now = ca.vertcat(*(one[0] for one in (*places, *turn)))
            energy, *slopes = ca.vertsplit(ca.substitute(ca.vertcat(energy, ca.gradient(energy, q)), q, now))
            found.append(EndSpring(site, energy, [-one for one in slopes[: len(places)]], slopes[len(places) :]))
    return tuple(found)


def _angle(turned: Sequence[ca.SX], frame: Sequence[ca.SX]) -> ca.SX:
    """Angle between a section and its support."""
    if len(turned) == 1:
        return turned[0] - frame[0]
    w, *v = spatial.relative(tuple(frame), tuple(turned))
    return 2 * ca.atan2(ca.sqrt(sum((one**2 for one in v), ca.SX(0)) + _ROUND), w)
