"""A filament that shears, in its plane or in space: a node has a place and a frame, a cell the whole section.

A two-node element with one point along the filament, so that it neither locks in shear nor has a spurious mode.
Stresses act on the conjugates of the cell's strains, and these on its nodes, each by virtual power.
"""

from __future__ import annotations

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
from softcat_sym.discretization.frames import Angle, Frame, Quaternion
from softcat_sym.discretization.section_points import SectionSums, sampled
from softcat_sym.discretization.section_rule import SectionRule
from softcat_sym.discretization.stencil import Field, Neighbours, Same
from softcat_sym.discretization.unknowns import CELLS
from softcat_sym.physics import symbols
from softcat_sym.physics.reissner import SampledSection


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
    conjugate = [b.area_cell * one for one in derivatives(section.power, section.strains, values | points.means)]
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
