"""A filament that shears (geometrically exact in the plane), its section resolved point by point."""

from __future__ import annotations

import casadi as ca

from softcat_sym.discretization.cell import (
    Builder,
    Mechanics,
    derivatives,
    mean_of_nodes,
    neck_force,
    positions,
    printed,
    surface_force,
    velocities,
)
from softcat_sym.discretization.sampling import OnePoint, Sampling
from softcat_sym.discretization.section_points import Sampled, sampled
from softcat_sym.discretization.stencil import Field, Neighbours, Same
from softcat_sym.discretization.unknowns import CELLS, Slot
from softcat_sym.physics import reissner, symbols


def shearing(b: Builder, rule: Sampling) -> Mechanics:
    """A filament that shears (geometrically exact in the plane), its section resolved point by point.

    Positions and section angle live on nodes, the whole section on cells: a two-node element with one point along the
    filament, so that it neither locks in shear nor has a spurious mode.
    """
    resolved = b.equations.resolved
    if resolved is None:
        raise ValueError("the section is not resolved: neither shear nor fibres are in force")
    x, y = positions(b)
    u, v, *moved = velocities(b)
    psi, omega = angles(b)
    slope_x, slope_y = ((r[1] - r[0]) / b.length[0] for r in (x, y))
    at = {symbols.x_X: slope_x, symbols.y_X: slope_y, reissner.psi: mean_of_nodes(psi)}
    strains = [*(printed(one, at) for one in resolved.strains), (psi[1] - psi[0]) / b.length[0] / b.span]
    rates = [ca.SX(0)] * 3
    if resolved.viscous is not None:
        speed = [(r[1] - r[0]) / b.length[0] / b.scale for r in moved]
        moving = {symbols.x_Xt: speed[0], symbols.y_Xt: speed[1], reissner.psi_t: mean_of_nodes(omega) / b.scale}
        rates = [printed(one, {**at, **moving}) for one in resolved.strain_rates]
        rates.append((omega[1] - omega[0]) / b.scale / b.length[0] / b.span)
    if isinstance(rule, OnePoint):
        # What all fibres see is looked up.
        names = ("Lam", "Gam", "k")
        strains = [b.stage(name, CELLS, one)[0] for name, one in zip(names, strains, strict=True)]
        rates = [b.stage(f"{name}_t", CELLS, one)[0] for name, one in zip(names, rates, strict=True)]
    by = (reissner.Lam, reissner.Gam, reissner.k)
    values = {**b.values, symbols.h0: b.h_cell, **dict(zip(by, strains, strict=True))}
    values |= dict(zip((reissner.Lam_t, reissner.Gam_t, reissner.k_t), rates, strict=True))
    fibres = sampled(b, resolved, rule, values)
    values |= fibres.means
    # Stresses to the conjugates of the cell's strains, and these to forces on its nodes, each by virtual power.
    n_1, n_2, couple = (b.area_cell * one for one in derivatives(resolved.cell.power, by, values))
    turned_by = b.stage("couple", CELLS, couple)
    at |= {reissner.n_1: n_1, reissner.n_2: n_2}
    power = reissner.n_1 * resolved.strains[0] + reissner.n_2 * resolved.strains[1]
    force_x, force_y, turn = derivatives(power, (symbols.x_X, symbols.y_X, reissner.psi), at)
    turned = b.stage("turning_half", CELLS, -b.length[0] * b.span * turn / 2)
    section = {
        name: b.area_cell * printed(one, values)
        for name, one in (("tension", resolved.cell.tension), ("moment", resolved.cell.moment))
    }
    section["shear_force"] = b.area_cell * printed(resolved.cell.shear_force, values)
    # Along the tangent of the centreline, not along the normal of the section: conjugate to its stretch.
    stretch = b.stage("stretch", CELLS, ca.sqrt(slope_x**2 + slope_y**2))
    pull, surface = surface_force(b, stretch)
    tension = b.stage("tension", CELLS, section["tension"]) if b.equations.neck is not None else Same()
    double_force, necked = neck_force(b, stretch, tension)
    along = (pull + necked) / stretch[0]
    force = (
        b.stage("force_x", CELLS, force_x + along * slope_x),
        b.stage("force_y", CELLS, force_y + along * slope_y),
    )

    def torque(before: int | None, behind: int | None) -> ca.SX:
        """Change of the couple and the moment of the forces about a node [Pa m]."""
        ahead = ca.SX(0) if behind is None else turned_by[behind] + turned[behind]
        return ahead if before is None else ahead - turned_by[before] + turned[before]

    shown = {
        **section,
        "relative_thickness": printed(resolved.relative_thickness, values) * b.relative * b.thinned,
        "curvature": strains[2] / strains[0],
        "shear": strains[1] / strains[0],
        **fibres.shown,
        **({"axial_force": (force[0][0] * slope_x + force[1][0] * slope_y) / stretch[0]} if surface else {}),
    }
    volume = b.length[0] * b.area_cell
    return Mechanics(
        x,
        y,
        u,
        v,
        stretch,
        force,
        fibres.plastic,
        {"elastic": [Field("elastic", CELLS, volume * fibres.energy)], "surface": surface},
        [Field("power_plastic", CELLS, volume * fibres.dissipation)],
        shown,
        psi,
        omega,
        torque,
        double_force,
        fibres.profiles,
        moved=(moved[0], moved[1]),
        ageing=_aged(b, volume, fibres, surface),
        softening=_softened(b, volume, fibres, surface),
    )


def _aged(b: Builder, volume: ca.SX, fibres: Sampled, surface: list[Field]) -> list[Field]:
    """What clocks do to the energies; that of the fibres may be a sum, which says nothing of the time."""
    if not b.equations.clocks:
        return []
    of_fibres = b.rate(volume) * fibres.energy + volume * fibres.ageing
    return [Field("fibres_aged", CELLS, of_fibres), *map(b.aged, surface)]


def _softened(b: Builder, volume: ca.SX, fibres: Sampled, surface: list[Field]) -> list[Field]:
    """What a kelvin adds to the energies."""
    if not b.thermal:
        return []
    of_fibres = b.by_temperature(volume) * fibres.energy + volume * fibres.softening
    return [Field("fibres_softened", CELLS, of_fibres), *map(b.softened, surface)]


def angles(b: Builder) -> tuple[Neighbours, Neighbours]:
    """Section angles of all nodes and their rates, which an end that holds the angle gives."""
    viscous, terms = b.equations.law.viscosity is not None, b.equations.terms
    turns, rotary = terms.rotary_inertia or viscous, terms.rotary_inertia and terms.inertia
    psi = b.unknown(
        Slot("psi", "node", b.bends, turns, "omega" if turns else "", section=False),
        0 if b.half else b.supports.left_angle,
        b.supports.right_angle,
    )
    omega = b.unknown(Slot("omega", "node", b.bends, rotary, "", section=False)) if turns else Same()
    return psi, omega
