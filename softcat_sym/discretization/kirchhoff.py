"""A filament that does not shear: stretching on cells, bending on joints."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca

from softcat_sym.discretization.casadi_printer import printed
from softcat_sym.discretization.cell import (
    Builder,
    Mechanics,
    branch_name,
    chain_state,
    derivatives,
    mean_of_nodes,
    neck_force,
    positions,
    shown_chains,
    surface_force,
    velocities,
)
from softcat_sym.discretization.stencil import Field, Neighbours, Same
from softcat_sym.discretization.unknowns import CELLS, Slot
from softcat_sym.physics import polymer_chains, symbols
from softcat_sym.physics.polymer_chains import ChainResponse
from softcat_sym.physics.section_response import BranchResponse, ViscousResponse


@dataclass(frozen=True)
class Strains:
    """Deformation without shear, of cells and of joints, with its rates where stress depends on them."""

    s: Neighbours
    s_node: Neighbours
    turning: Neighbours  # theta_X [1/m]
    s_t: Neighbours
    s_node_t: Neighbours
    turning_t: Neighbours


@dataclass
class SectionParts:
    """What a section does: sums over its parts, in expressions of a cell."""

    tension: ca.SX = field(default_factory=lambda: ca.SX(0))
    moment: tuple[ca.SX, ca.SX] = field(default_factory=lambda: (ca.SX(0), ca.SX(0)))  # At both ends of the cell
    correction: ca.SX = field(default_factory=lambda: ca.SX(0))  # Q - T
    plastic: dict[str, ca.SX] = field(default_factory=dict)  # Rates of the plastic states [1/s]
    stored: list[Field] = field(default_factory=list)  # Energies of cells and joints
    dissipation: list[Field] = field(default_factory=list)
    ageing: list[Field] = field(default_factory=list)  # Work of a natural strain on the viscous stress
    stress: tuple[ca.SX, ca.SX] = field(default_factory=lambda: (ca.SX(0), ca.SX(0)))  # sigma_0 and sigma_1
    fraction: ca.SX | None = None  # Share that yields, and the largest plastic rate
    speed: ca.SX | None = None
    profiles: dict[str, tuple[float, float]] = field(default_factory=dict)  # Of chains, as those of `Mechanics`
    conformation: list[ca.SX] = field(default_factory=list)


def linear_section(b: Builder, at: Strains) -> SectionParts:
    """The section of the paper: a plastic strain linear through the thickness; stretching on cells, bending on joints.

    What has a potential is differentiated. What has none - the printed closure, and a finite stretch of a section that
    does not thin - states its resultants, conjugate to the rates of the strains (virtual power).
    """
    response, found = b.equations.response, SectionParts()
    for j, part in enumerate(response.parts):
        viscous = isinstance(part, ViscousResponse)
        flows = isinstance(part, BranchResponse) and part.means is not None
        a_0, a_1 = _states(b, j) if flows else (Same(), Same())
        cell = {**b.values, symbols.s: at.s[0], symbols.s_t: at.s_t[0], symbols.a_0: a_0[0], symbols.h0: b.h_cell}
        node = {**b.values_node, symbols.s: at.s_node[0], symbols.s_t: at.s_node_t[0], symbols.h0: b.h_node}
        node |= {symbols.theta_X: at.turning[0], symbols.theta_Xt: at.turning_t[0], symbols.a_1: a_1[0]}
        sigma_0, sigma_1 = printed(part.stress_mean, cell), printed(part.stress_bending, node)
        if b.equations.conserves_energy:
            (pull,) = derivatives(part.stretching, (symbols.s_t if viscous else symbols.s,), cell)
            by = (symbols.theta_Xt, symbols.s_t) if viscous else (symbols.theta_X, symbols.s)
            turn, correction = derivatives(part.bending, by, node)
            T, M, C = b.area_cell * pull, -b.area_node * turn, b.area_node * correction
        else:
            T = b.area_cell * printed(response.tension, {**cell, symbols.sigma_0: sigma_0})
            M = b.area_node * printed(response.moment, {**node, symbols.sigma_1: sigma_1})
            C = printed(response.axial_correction, {**node, symbols.M: M})
        tension, moment = b.stage(f"tension_{j}", CELLS, T), b.joints(f"moment_{j}", M)
        lengthening = b.joints(f"axial_correction_{j}", C)
        found.tension += tension[0]
        found.moment = found.moment[0] + moment[0], found.moment[1] + moment[1]
        found.correction += mean_of_nodes(lengthening)
        # The other stress, where the flow of one needs both: resultants are averaged, not stresses.
        moment_cell = b.stage(f"moment_cell_{j}", CELLS, mean_of_nodes(moment) / b.area_cell)
        tension_node = b.nodes(f"tension_node_{j}", b.averaged(tension, over=b.area_node))
        across = printed(response.stress_of_moment, {**cell, symbols.M: moment_cell[0]})
        along = printed(response.stress_of_tension, {**node, symbols.T: tension_node[0]})
        cell |= {symbols.sigma_0: sigma_0, symbols.sigma_1: across}
        node |= {symbols.sigma_0: along, symbols.sigma_1: sigma_1}
        found.stress = found.stress[0] + sigma_0, found.stress[1] + across
        over_cell, over_node = b.length[0] * b.area_cell, b.node[0] * b.area_node
        if isinstance(part, ViscousResponse):
            lost = [2 * printed(part.stretching, cell), 2 * printed(part.bending, node)]
            if b.equations.terms.shrinks:
                mean, more = (
                    b.values[rate] * derivatives(of, (rate,), given)[0]
                    for of, rate, given in (
                        (part.stretching, symbols.n_0_t, cell),
                        (part.bending, symbols.n_1_t, node),
                    )
                )
                found.ageing += [
                    Field("shrinking", CELLS, over_cell * mean),
                    b.joint_field("curling", over_node * more),
                ]
        else:
            found.stored += [
                Field("stretching", CELLS, over_cell * printed(part.stretching, cell)),
                b.joint_field("bending", over_node * printed(part.bending, node)),
            ]
            rates = printed(part.rate_mean, cell), printed(part.rate_bending, node)
            names = branch_name("a_0", j), branch_name("a_1", j)
            found.plastic |= {n: r for n, r in zip(names, rates, strict=True) if n in b.slots}
            lost = [printed(power, given) for power, given in zip(part.dissipation, (cell, node), strict=True)]
        found.dissipation += [
            Field("power_stretching", CELLS, over_cell * lost[0]),
            b.joint_field("power_bending", over_node * lost[1]),
        ]
        if not viscous or len(response.parts) == 1:
            end = {**node, symbols.sigma_1: ca.SX(0)}
            shown = [
                mean_of_nodes(b.joints(f"{name}_{j}", printed(value, node), printed(value, end)))
                for name, value in (("fraction", part.yielded_fraction), ("speed", part.plastic_rate))
            ]
            found.fraction = shown[0] if found.fraction is None else ca.fmax(found.fraction, shown[0])
            found.speed = shown[1] if found.speed is None else ca.fmax(found.speed, shown[1])
    if b.equations.chains is not None:
        _add_chains(b, b.equations.chains, at, found)
    return found


def _add_chains(b: Builder, chains: ChainResponse, at: Strains, found: SectionParts) -> None:
    """Polymer chains of a section that does not bend: one conformation in every cell."""
    response, strain = b.equations.response, b.equations.strain.strain
    slots = [Slot(chain_state(one), "cell", (False, False), True, "", section=False) for one in chains.states]
    taken = {one.taken: b.unknown(slot)[0] for one, slot in zip(chains.states, slots, strict=True)}
    cell = {**b.values, **taken, symbols.s: at.s[0], symbols.h0: b.h_cell}
    (pull,) = derivatives(response.volume * chains.stored.subs(polymer_chains.strain, strain), (symbols.s,), cell)
    fibre = {**cell, polymer_chains.strain: printed(strain, cell)}
    (stress,) = derivatives(chains.stored, (polymer_chains.strain,), fibre)
    if not b.equations.conserves_energy:
        pull = printed(response.tension, {**cell, symbols.sigma_0: stress})
    found.tension += b.stage("tension_chains", CELLS, b.area_cell * pull)[0]
    found.stress = found.stress[0] + stress, found.stress[1]
    volume = b.length[0] * b.area_cell * printed(response.volume, cell)
    found.stored.append(Field("chains", CELLS, volume * printed(chains.stored, fibre)))
    of_states = chains.of_states
    relaxing = [printed(of_states(rate), fibre) for rate in chains.rates]
    found.plastic |= {chain_state(one): rate for one, rate in zip(chains.states, relaxing, strict=False)}
    found.dissipation.append(Field("power_chains", CELLS, volume * printed(of_states(chains.dissipation), fibre)))
    found.fraction, found.speed = ca.SX(int(chains.relaxes)), ca.fabs(relaxing[0]) / 2
    found.conformation = [printed(extension, fibre) for extension in chains.extensions]
    found.profiles = {chain_state(one): (float(one.power), 0.0) for one in chains.states}


def _states(b: Builder, branch: int) -> tuple[Neighbours, Neighbours]:
    """Plastic states of a branch: a_0 of every cell, a_1 of every joint with a moment."""
    terms, free = b.equations.terms, (not b.first.holds_angle, not b.last.holds_angle)
    mean = Slot(branch_name("a_0", branch), "cell", (False, False), True, "", section=False)
    bending = Slot(branch_name("a_1", branch), "node", free, True, "", section=False)
    return b.unknown(mean) if terms.stretches else Same(), b.unknown(bending) if terms.bending else Same()


def kirchhoff(b: Builder) -> Mechanics:
    """A filament whose sections stay normal to the centreline."""
    terms, line = b.equations.terms, b.equations.centreline
    places = positions(b, along=terms.stretches)
    speeds, moved = velocities(b, along=terms.stretches)
    slope = tuple(b.stage(f"slope_{n}", CELLS, (r[1] - r[0]) / b.length[0]) for n, r in zip("xy", places, strict=True))
    tangent = {symbols.x_X: slope[0][0], symbols.y_X: slope[1][0]}
    s = b.stage("s", CELLS, printed(line.stretch, tangent) if terms.stretches else ca.SX(1))
    s_node = b.nodes("s_node", b.averaged(s))
    turning = b.turning("turning", line.turning, slope) if terms.bending else Same()
    s_t: Neighbours = Same()
    s_node_t: Neighbours = Same()
    turning_t: Neighbours = Same()
    if b.equations.response.viscous is not None:
        speed = tuple(
            b.stage(f"speed_{n}", CELLS, (r[1] - r[0]) / b.length[0] / b.scale)
            for n, r in zip("xy", moved, strict=True)
        )
        if terms.stretches:
            rates = {symbols.x_Xt: speed[0][0], symbols.y_Xt: speed[1][0]}
            s_t = b.stage("stretching", CELLS, printed(line.stretch_rate(), {**tangent, **rates}))
            s_node_t = b.nodes("stretching_node", b.averaged(s_t))
        if terms.bending:
            turning_t = b.turning("turning_rate", line.turning_rate(), slope, speed)
    section = linear_section(b, Strains(s, s_node, turning, s_t, s_node_t, turning_t))
    pull, surface = surface_force(b, s)
    total = b.stage("tension", CELLS, section.tension) if b.equations.neck is not None else s
    double_force, necked = neck_force(b, s, total)
    axial = section.tension + section.correction + pull + necked
    transverse = (section.moment[1] - section.moment[0]) / b.length[0] / b.span
    given = {**tangent, symbols.s: s[0], symbols.Q: axial, symbols.M_X: transverse}
    force = tuple(
        b.stage(f"force_{n}", CELLS, printed(component, given))
        for n, component in (("x", b.equations.force.horizontal), ("y", b.equations.force.vertical))
    )
    shown = {
        **_shown(b, section, s[0], transverse, mean_of_nodes(b.nodes("curvature", lambda *_: turning[0] / s_node[0]))),
        **({"axial_force": axial} if surface else {}),
    }
    energies = {"elastic": section.stored, "surface": surface}
    return Mechanics(
        places,
        speeds,
        moved,
        s,
        force,
        section.plastic,
        energies,
        section.dissipation,
        shown,
        double_force=double_force,
        profiles=section.profiles,
        ageing=[*map(b.aged, (*section.stored, *surface)), *section.ageing] if b.equations.clocks else [],
        softening=[*map(b.softened, (*section.stored, *surface))] if b.thermal else [],
    )


def _shown(b: Builder, section: SectionParts, s: ca.SX, transverse: ca.SX, curvature: ca.SX) -> dict[str, ca.SX]:
    thickness = b.equations.response.thickness / symbols.h0
    return {
        "shear_force": transverse / s,
        "relative_thickness": printed(thickness, {**b.values, symbols.s: s}) * b.relative * b.thinned,
        "tension": section.tension,
        "moment": (section.moment[0] + section.moment[1]) / 2,
        "curvature": curvature,
        "shear": ca.SX(0),
        "yielded_fraction": ca.SX(0) if section.fraction is None else section.fraction,
        "plastic_rate": ca.SX(0) if section.speed is None else section.speed,
        "stress_mean": section.stress[0],
        "stress_bending": section.stress[1],
        **shown_chains(section.conformation),
    }
