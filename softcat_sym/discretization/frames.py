"""Frames of the sections of a filament that shears: an angle in the plane, a quaternion in space (THEORY3D 5).

The turn of a cell is the middle of the geodesic between those of its nodes, curvature and twist their relative turn
over the length (Crisfield & Jelenic 1999): a rigid motion strains nothing, and what is planar is the planar cell.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.cell import Builder
from softcat_sym.discretization.stencil import Field, Neighbours, Same
from softcat_sym.discretization.supports import NATURAL_PLACES, TIP_TORQUE
from softcat_sym.discretization.unknowns import SPIN, TURN, Slot
from softcat_sym.physics import reissner, spatial, symbols

Values = Sequence[ca.SX]

_ROUND = 1e-24
"""Square of the angle between two nodes below which it counts as none."""


class Angle:
    """The angle of the section's normal from the horizontal."""

    # Coordinates of a node, and the unknowns of a frame and of its spin
    ways, names, spins = 2, ("psi",), ("omega",)

    def clamps(self, b: Builder) -> tuple[Values, Values]:
        """Angles that the supports hold."""
        return [b.supports.left_angle], [b.supports.right_angle]

    def unknowns(self, b: Builder) -> tuple[list[Neighbours], list[Neighbours]]:
        """Section angles of all nodes and their rates, which an end that holds the angle gives."""
        viscous, terms = b.equations.law.viscosity is not None, b.equations.terms
        turns, rotary = terms.rotary_inertia or viscous, terms.rotary_inertia and terms.inertia
        slot = Slot("psi", "node", b.bends, turns, "omega" if turns else "", section=False)
        psi = b.unknown(slot, 0 if b.half else b.supports.left_angle, b.supports.right_angle)
        return [psi], [b.unknown(Slot("omega", "node", b.bends, rotary, "", section=False)) if turns else Same()]

    def strains(self, slope: Values, first: Values, last: Values, length: ca.SX) -> list[ca.SX]:
        """Lam, Gam and k."""
        middle = (first[0] + last[0]) / 2
        at = {symbols.x_X: slope[0], symbols.y_X: slope[1], reissner.psi: middle}
        return [*(printed(one, at) for one in reissner.director_strains()), (last[0] - first[0]) / length]

    def rate(self, frame: Values, spin: Values) -> list[ca.SX]:
        """The spin itself."""
        del frame
        return list(spin)

    def torque(self, frame: Values, slopes: Values) -> list[ca.SX]:
        """The derivative itself."""
        del frame
        return list(slopes)

    def natural(self, b: Builder) -> dict[Any, ca.SX]:
        """Nothing: its points know the curvature."""
        del b
        return {}


class Quaternion:
    """A unit quaternion that turns the fixed axes into those of the section."""

    ways, names, spins = 3, TURN, SPIN

    def clamps(self, b: Builder) -> tuple[Values, Values]:
        """Quaternions that the supports hold: a turn in the plane or the end of a shape; the right may be twisted."""
        at, flat = b.supports, ca.SX(0)
        left = at.turns[0] or [ca.cos(at.left_angle / 2), flat, flat, ca.sin(at.left_angle / 2)]
        w, x, y, z = at.turns[1] or [ca.cos(at.right_angle / 2), flat, flat, ca.sin(at.right_angle / 2)]
        c, s = ca.cos(at.right_twist / 2), ca.sin(at.right_twist / 2)
        return left, [w * c - x * s, x * c + w * s, y * c + z * s, z * c - y * s]

    def unknowns(self, b: Builder) -> tuple[list[Neighbours], list[Neighbours]]:
        """Quaternions of all nodes and their spins; their lengths or rates, which need no forces."""
        turns, held = b.equations.law.viscosity is not None, self.clamps(b)
        slots = [Slot(name, "node", b.bends, turns, "", section=False) for name in TURN]
        turn = [b.unknown(slot, *pair) for slot, pair in zip(slots, zip(*held, strict=True), strict=True)]
        spin: list[Neighbours] = [Same()] * 3
        if turns:
            last = (b.supports.right_spin * b.scale, 0, 0)
            spin = [
                b.unknown(Slot(name, "node", b.bends, False, "", section=False), 0, end)
                for name, end in zip(SPIN, last, strict=True)
            ]
        q = [one[0] for one in turn]
        excess = sum((one**2 for one in q), ca.SX(0)) - 1
        found = [excess]
        if turns:
            rates = self.rate(q, [one[0] for one in spin])
            found = [rate - excess * one for rate, one in zip(rates, q, strict=True)]
        b.rates |= {
            slot.name: Field(f"f_{slot.name}", slot.where, one) for slot, one in zip(slots, found, strict=False)
        }
        return turn, spin

    def strains(self, slope: Values, first: Values, last: Values, length: ca.SX) -> list[ca.SX]:
        """Gamma = R_m^T r_X, and kappa from the relative turn of two nodes: 2 atan2(|v|, w)/|v| v over the length."""
        middle = tuple(a + z for a, z in zip(first, last, strict=True))
        w, *v = spatial.relative(tuple(first), tuple(last))
        size = ca.sqrt(sum((one**2 for one in v), ca.SX(0)) + _ROUND)
        angle = 2 * ca.atan2(size, w) / size / length
        return [*spatial.unrotated(middle, tuple(slope)), *(angle * one for one in v)]  # type: ignore[arg-type]

    def rate(self, frame: Values, spin: Values) -> list[ca.SX]:
        """Q (0, spin)/2."""
        w, x, y, z = frame
        a, b, c = spin
        return [
            -(x * a + y * b + z * c) / 2,
            (w * a + y * c - z * b) / 2,
            (w * b + z * a - x * c) / 2,
            (w * c + x * b - y * a) / 2,
        ]

    def torque(self, frame: Values, slopes: Values) -> list[ca.SX]:
        """G(q)^T of the slopes in the four components, halved."""
        w, x, y, z = frame
        a, b, c, d = slopes
        return [
            (-x * a + w * b + z * c - y * d) / 2,
            (-y * a - z * b + w * c + x * d) / 2,
            (-z * a + y * b - x * c + w * d) / 2,
        ]

    def natural(self, b: Builder) -> dict[Any, ca.SX]:
        """Natural twist and curvatures: the scene's, or those of its shape."""
        values = [b.values[spatial.natural_twist], ca.SX(0), b.values[symbols.kappa_0]]
        if b.body.natural is not None:
            values = [b.place(name)[0] for name in NATURAL_PLACES]
        return dict(zip(spatial.NATURAL, values, strict=True))

    def dead_torque(self, b: Builder, turn: Sequence[Neighbours]) -> list[ca.SX]:
        """Torque on the free end, in its own axes."""
        dead = tuple(b.named[name] for name in TIP_TORQUE)
        return list(spatial.unrotated(tuple(one[0] for one in turn), dead))  # type: ignore[arg-type]


Frame = Angle | Quaternion
