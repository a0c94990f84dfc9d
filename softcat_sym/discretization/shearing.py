"""A filament that shears, in its plane or in space: a node has a place and a frame, a cell the whole section.

A two-node element with one point along the filament, so that it neither locks in shear nor has a spurious mode. Its
turn is the middle of the geodesic between those of its nodes, curvature and twist their relative turn over the length
(THEORY3D 5; Crisfield & Jelenic 1999): a rigid motion strains nothing, what is planar is the planar cell. Stresses act
on the conjugates of the cell's strains, and these on its nodes, each by virtual power.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import casadi as ca

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.cell import (
    Builder,
    Mechanics,
    Sided,
    Turning,
    derivatives,
    neck_force,
    positions,
    slopes_of,
    surface_force,
    velocities,
)
from softcat_sym.discretization.section_points import SectionSums, sampled
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.stencil import Field, Neighbours, Same
from softcat_sym.discretization.supports import NATURAL_PLACES, TIP_TORQUE
from softcat_sym.discretization.unknowns import CELLS, SPIN, TURN, Slot
from softcat_sym.physics import reissner, spatial, symbols
from softcat_sym.physics.reissner import SampledSection

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


def shearing(b: Builder, rule: SectionRule, section: SampledSection) -> Mechanics:
    """A filament whose sections turn by themselves, resolved point by point."""
    frame: Frame = Quaternion() if rule.is_spatial else Angle()
    places, (speeds, moved) = positions(b, frame.ways), velocities(b, frame.ways)
    turn, spin = frame.unknowns(b)
    length, size = b.length[0] * b.span, len(turn)
    slope = slopes_of(b, places)
    first, last = ([q[n] for q in turn] for n in (0, 1))
    now, every = ca.vertcat(*slope, *first, *last), ca.SX.sym("slope_and_frames", frame.ways + 2 * size)
    parts = ca.vertsplit(every)
    expressions = ca.vertcat(*frame.strains(parts[: frame.ways], parts[frame.ways : -size], parts[-size:], length))
    strains, rates = ca.vertsplit(ca.substitute(expressions, every, now)), [ca.SX(0)] * len(section.strains)
    if section.viscous is not None:
        speed = [(r[1] - r[0]) / b.length[0] / b.scale for r in moved]
        turning = [one / b.scale for n, q in ((0, first), (1, last)) for one in frame.rate(q, [o[n] for o in spin])]
        rates = ca.vertsplit(ca.substitute(ca.jtimes(expressions, every, ca.vertcat(*speed, *turning)), every, now))
    if rule.stands_for_all:
        # What all points see is looked up.
        strains = [b.stage(f"strain_{n}", CELLS, one)[0] for n, one in enumerate(strains)]
        rates = [b.stage(f"strain_{n}_t", CELLS, one)[0] for n, one in enumerate(rates)]
    values = {**b.values, symbols.h0: b.h_cell, **dict(zip(section.strains, strains, strict=True))}
    values |= dict(zip(section.strain_rates, rates, strict=True)) | (
        frame.natural(b) if b.equations.terms.curved else {}
    )
    points = sampled(b, section, rule, values)
    conjugate = derivatives(section.power, section.strains, values | points.means)
    if section.stiffener != 0:
        points = _stiffened(b, section, values, points)
        for potential, by in ((section.stiffener, section.strains), (section.damper, section.strain_rates)):
            stiff = derivatives(potential, by, values)
            conjugate = [one + two for one, two in zip(conjugate, stiff, strict=True)]
    conjugate = [b.area_cell * one for one in conjugate]
    held = ca.SX.sym("conjugate", len(conjugate))
    slopes = ca.jtimes(expressions, every, held, True)
    found = ca.vertsplit(ca.substitute(slopes, ca.vertcat(every, held), ca.vertcat(now, *conjugate)))
    # Along the tangent of the centreline, not along the normal of the section: conjugate to its stretch.
    stretch = b.stage("stretch", CELLS, ca.sqrt(sum((one**2 for one in slope), ca.SX(0))))
    pull, surface = surface_force(b, stretch)
    tension = b.area_cell * next(iter(points.means.values())) / strains[0]
    double_force, necked = neck_force(
        b, stretch, b.stage("tension", CELLS, tension) if b.equations.neck is not None else Same()
    )
    along = (pull + necked) / stretch[0]
    force = tuple(b.stage(f"force_{n}", CELLS, one + along * slope[n]) for n, one in enumerate(found[: frame.ways]))
    on_first, on_last = (
        [b.stage(f"torque_{side}_{n}", CELLS, -length * one) for n, one in enumerate(frame.torque(q, of))]
        for side, q, of in (("first", first, found[frame.ways : -size]), ("last", last, found[-size:]))
    )
    balancing = frame.spins if b.slots[frame.names[0]].differential else frame.names[-len(frame.spins) :]
    volume = b.length[0] * b.area_cell
    shown = {
        "tension": tension,
        "shear_force": conjugate[1],
        "moment": -conjugate[-1],
        "relative_thickness": printed(section.relative_thickness, values) * b.relative * b.thinned,
        "curvature": strains[-1] / strains[0],
        "shear": strains[1] / strains[0],
        **points.shown,
    }
    if surface and not rule.is_spatial:
        shown["axial_force"] = sum((f[0] * t for f, t in zip(force, slope, strict=True)), ca.SX(0)) / stretch[0]
    if isinstance(frame, Quaternion):
        # What a run stores of the cells beside what it stores in the plane.
        Lam, _, third, twist, k_2, _ = strains
        mean, bending, *_ = points.means.values()
        shown |= {
            "curvature_2": k_2 / Lam,
            "twist": twist,
            "shear_3": third / Lam,
            "shear_force_3": conjugate[2],
            "torque": conjugate[3],
            "moment_2": conjugate[4],
            "stress_mean": mean,
            "stress_bending": bending / float(b.equations.shape.zeta_squared),
        }
    return Mechanics(
        places,
        speeds,
        moved,
        stretch,
        force,
        points.plastic,
        {"elastic": [Field("elastic", CELLS, volume * points.energy)], "surface": surface},
        [Field("power_plastic", CELLS, volume * points.dissipation)],
        shown,
        double_force,
        points.profiles,
        _aged(b, volume, points, surface),
        _softened(b, volume, points, surface),
        Turning(
            turn,
            spin,
            frame.clamps(b),
            {name: _both(*pair) for name, pair in zip(balancing, zip(on_first, on_last, strict=True), strict=True)},
            lambda slopes: frame.torque([one[0] for one in turn], slopes),
            _fixed(b, frame, turn, spin) if isinstance(frame, Quaternion) else {},
            frame.dead_torque(b, turn) if isinstance(frame, Quaternion) and b.body.tip_torque else (),
        ),
    )


def _stiffened(b: Builder, section: SampledSection, values: Mapping[Any, Any], points: SectionSums) -> SectionSums:
    """What the points sum up to, with what keeps the section square to the centreline."""
    stored, lost = printed(section.stiffener, values), 2 * printed(section.damper, values)
    return replace(
        points,
        energy=points.energy + stored,
        dissipation=points.dissipation + lost,
        ageing=points.ageing + b.rate(stored),
        softening=points.softening + b.by_temperature(stored),
    )


def _both(on_first: Neighbours, on_last: Neighbours) -> Sided:
    """Torque on a node by the cells beside it [Pa m]."""

    def torque(before: int | None, behind: int | None) -> ca.SX:
        ahead = ca.SX(0) if behind is None else on_first[behind]
        return ahead if before is None else ahead + on_last[before]

    return torque


def _fixed(
    b: Builder, frame: Quaternion, turn: list[Neighbours], spin: list[Neighbours]
) -> dict[str, dict[int, ca.SX]]:
    """A pin leaves the normal free but does not let it spin: the filament would, without resistance."""
    q = [one[0] for one in turn]
    name, value = (
        (frame.spins[0], frame.rate(q, [o[0] for o in spin])[1]) if frame.spins[0] in b.slots else ("q1", q[1])
    )
    pinned = (at for at, one in ((0, b.first), (-1, b.last)) if not (one.is_free or one.carries_moment))
    return {name: dict.fromkeys(pinned, value)}


def _aged(b: Builder, volume: ca.SX, fibres: SectionSums, surface: list[Field]) -> list[Field]:
    """What clocks do to the energies; that of the fibres may be a sum, which says nothing of the time."""
    if not b.equations.clocks:
        return []
    of_fibres = b.rate(volume) * fibres.energy + volume * fibres.ageing
    return [Field("fibres_aged", CELLS, of_fibres), *map(b.aged, surface)]


def _softened(b: Builder, volume: ca.SX, fibres: SectionSums, surface: list[Field]) -> list[Field]:
    """What a kelvin adds to the energies."""
    if not b.thermal:
        return []
    of_fibres = b.by_temperature(volume) * fibres.energy + volume * fibres.softening
    return [Field("fibres_softened", CELLS, of_fibres), *map(b.softened, surface)]
