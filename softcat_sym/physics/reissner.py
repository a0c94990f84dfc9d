"""A filament that shears, resolved fibre by fibre (THEORY 12): exact in the plane, J2 flow in each fibre."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

import sympy as sp

from softcat_sym.physics import hardening_rule, polymer_chains
from softcat_sym.physics.bulk import shear_modulus, sigma_eq
from softcat_sym.physics.constitutive_laws import Law
from softcat_sym.physics.kinematics import mass_per_length
from softcat_sym.physics.section_response import PLANE_STRAIN, natural_strains, resistance, stiffness
from softcat_sym.physics.sections import UNIFORM, Contraction, Section
from softcat_sym.physics.symbols import (
    FORCE,
    MOMENT,
    ONE,
    PER_LENGTH,
    RATE,
    STRESS,
    E,
    M,
    T,
    enter,
    h0,
    kappa_0,
    s,
    sigma,
    x_X,
    y_X,
    zeta,
)

psi = enter("psi", r"\psi", ONE, "angle of the section's normal from the horizontal", "THEORY 12")
Lam = enter("Lam", r"\Lambda", ONE, "r_X along the section's normal", "THEORY 12", positive=True)
Gam = enter("Gam", r"\Gamma", ONE, "r_X along the section", "THEORY 12")
k = enter("k", "k", PER_LENGTH, "psi_X, bending per unit material length", "THEORY 12")
psi_t = enter("psi_t", r"\dot\psi", RATE, "rate of psi", "THEORY 12")
Lam_t = enter("Lam_t", r"\dot\Lambda", RATE, "rate of Lam", "THEORY 12")
Gam_t = enter("Gam_t", r"\dot\Gamma", RATE, "rate of Gam", "THEORY 12")
k_t = enter("k_t", r"\dot k", (0, -1, -1), "rate of k", "THEORY 12")
eps_p = enter("eps_p", r"\epsilon^p", ONE, "axial plastic strain of a fibre", "THEORY 12")
gamma_p = enter("gamma_p", r"\gamma^p", ONE, "plastic shear of a fibre", "THEORY 12")
eps = enter("eps_f", r"\epsilon", ONE, "axial true strain of a fibre", "THEORY 12")
gamma = enter("gamma_f", r"\gamma", ONE, "shear strain of a fibre", "THEORY 12")
eps_t = enter("eps_f_t", r"\dot\epsilon", RATE, "rate of eps", "THEORY 12")
gamma_t = enter("gamma_f_t", r"\dot\gamma", RATE, "rate of gamma", "THEORY 12")
tau_f = enter("tau_f", r"\tau", STRESS, "shear stress of a fibre", "THEORY 12")
eps_e = enter("eps_f_e", r"\epsilon^e", ONE, "axial elastic strain of a fibre", "THEORY 12a")
gamma_e = enter("gamma_f_e", r"\gamma^e", ONE, "elastic shear of a fibre", "THEORY 12a")
sigma_c = enter("sigma_f_c", r"\hat\sigma", STRESS, "stress conjugate to the axial strain", "THEORY 12a")
tau_d = enter("tau_f_d", r"\tau_d", STRESS, "shear stress that drives the flow", "THEORY 12a")
kappa_s = enter("kappa_s", r"\kappa_s", ONE, "shear correction of the section", "THEORY 12", positive=True)
sigma_zeta = enter("sigma_zeta", r"\langle\sigma\zeta\rangle", STRESS, "mean of sigma zeta", "THEORY 12")
sigma_mean = enter("sigma_mean", r"\langle\sigma\rangle", STRESS, "mean of sigma", "THEORY 12")
tau_mean = enter("tau_mean", r"\langle\tau\rangle", STRESS, "mean of the shear stress", "THEORY 12")
S = enter("S", "S", FORCE, "shear force, area times mean shear stress", "THEORY 12")
n_1 = enter("n_1", "n_1", FORCE, "force conjugate to Lam", "THEORY 12")
n_2 = enter("n_2", "n_2", FORCE, "force conjugate to Gam", "THEORY 12")
m_c = enter("m_c", "m", MOMENT, "moment conjugate to k, minus M", "THEORY 12")


def director_strains() -> tuple[sp.Expr, sp.Expr]:
    """(Lam, Gam) of (r_X, psi)."""
    return (x_X * sp.cos(psi) + y_X * sp.sin(psi), -x_X * sp.sin(psi) + y_X * sp.cos(psi))


@dataclass(frozen=True, slots=True)
class ShearingCell:
    """One cell: every link of the chain, in the symbols that the link before it computes."""

    area: sp.Expr  # A and h of Lam (2.9)
    thickness: sp.Expr
    axial_strain: sp.Expr  # True strain of the fibre zeta, of (Lam, k)
    shear_strain: sp.Expr  # sqrt(kappa_s) Gam/Lam, the same for all fibres
    carry: sp.Expr  # Power of a stretch f in f over its contraction through the thickness: 3/2, or 2 in a sheet
    tension: sp.Expr  # T, M and S of the means over the section and Lam
    moment: sp.Expr
    shear_force: sp.Expr
    normal_force: sp.Expr  # n_1, n_2 and m, conjugate to Lam, Gam and k, of (T, M, S) and (Lam, Gam, k)
    section_force: sp.Expr
    couple: sp.Expr
    force: tuple[sp.Expr, sp.Expr]  # n_1 d1 + n_2 d2 in the fixed frame, of (n_1, n_2, psi)
    turning_moment: sp.Expr  # Lam n_2 - Gam n_1, what the forces do to the section angle besides m_X

    @property
    def power(self) -> sp.Expr:
        """Power of the stresses in the strains, per unit rest length and undeformed area.

        Its derivatives by (Lam, Gam, k) at fixed stresses are the conjugate forces n_1, n_2 and couple m.
        """
        axial = sigma_mean * self.axial_strain.subs(zeta, 0) + sigma_zeta * sp.diff(self.axial_strain, zeta)
        return axial + tau_mean * self.shear_strain


def shearing_cell(contraction: Contraction = UNIFORM, correction: sp.Expr = kappa_s) -> ShearingCell:
    """The chain for one way of contracting that keeps the volume: ``UNIFORM`` or ``WIDE``.

    n_1 = T - M k (Lam d(log lever)/dLam)/Lam - S Gam/Lam, where lever = h/(2 Lam) is the bending strain of the outer
    fibre per unit -k: 3/2 M k/Lam if the section shrinks both ways, 2 M k/Lam for a sheet.
    """
    area, thickness = contraction.area.subs(s, Lam), contraction.thickness.subs(s, Lam)
    lever = sp.powsimp(thickness / (2 * Lam))
    axial, shear = sp.log(Lam) - k * lever * zeta, sp.sqrt(correction) * Gam / Lam
    # Exponent of Lam in the lever, a number: -3/2 or -2.
    exponent = sp.powsimp(Lam * sp.diff(lever, Lam) / lever)
    return ShearingCell(
        area=area,
        thickness=thickness,
        axial_strain=axial,
        shear_strain=shear,
        carry=-exponent,
        tension=area * sigma_mean,
        moment=area * thickness * sigma_zeta / 2,
        shear_force=sp.sqrt(correction) * area * tau_mean,
        normal_force=T - exponent * M * k / Lam - S * Gam / Lam,
        section_force=S,
        couple=-M,
        force=(n_1 * sp.cos(psi) - n_2 * sp.sin(psi), n_1 * sp.sin(psi) + n_2 * sp.cos(psi)),
        turning_moment=Lam * n_2 - Gam * n_1,
    )


CARRY = sp.Rational(3, 2)
"""``carry`` of a section that shrinks both ways."""


class Shear(NamedTuple):
    """Symbols of one shear of a point of the section."""

    total: sp.Symbol
    plastic: sp.Symbol
    elastic: sp.Symbol
    rate: sp.Symbol
    stress: sp.Symbol  # Conjugate to it
    drive: sp.Symbol  # Stress that drives its flow


IN_PLANE = (Shear(gamma, gamma_p, gamma_e, gamma_t, tau_f, tau_d),)
"""The shear of a filament in its plane; three dimensions have two, sections that are kept square have none."""


@dataclass(frozen=True, slots=True)
class FibreSpring:
    """The stored energy of a fibre and its derivatives; what the package runs on is differentiated from the energy."""

    elastic: tuple[sp.Expr, ...]  # eps_e and gamma_e of the strains (eps, gamma), the plastic state and eps_e
    stored: sp.Expr  # Per unit undeformed volume, of (eps_e, gamma_e)
    stress: tuple[sp.Expr, ...]  # sigma of (eps_e, gamma_e), and tau of sigma and these
    conjugate: sp.Expr  # Stress conjugate to eps, of (sigma, tau_d) and the plastic state
    driving: tuple[sp.Expr, ...]  # tau_d = -d stored/d gamma_p, of tau and eps_e


def fibre_spring(
    modulus: sp.Expr,
    shearing: sp.Expr,
    carry: sp.Expr = CARRY,
    relaxed: sp.Expr = sp.S.Zero,
    shears: tuple[Shear, ...] = IN_PLANE,
) -> FibreSpring:
    """Energy E (eps_e + gamma_e^2/4)^2/2 + mu gamma_e^2/2: Hencky's to third order if the volume is kept."""
    carried, square = sp.exp(-carry * eps_e), sp.Add(*(one.elastic**2 for one in shears))
    lengthened = eps_e + square / 4
    return FibreSpring(
        elastic=(eps - relaxed - eps_p, *(one.total - one.plastic * carried for one in shears)),
        stored=modulus * lengthened**2 / 2 + shearing * square / 2,
        # What the shear stress has of the axial one, as a multiple of it.
        stress=(
            modulus * lengthened,
            *(shearing * one.elastic + sigma * sp.diff(lengthened, one.elastic) for one in shears),
        ),
        conjugate=sigma + carry * sp.Add(*(one.plastic * one.drive for one in shears)),
        driving=tuple(carried * one.stress for one in shears),
    )


@dataclass(frozen=True, slots=True)
class FibreFlow:
    """J2 flow of a fibre, the bulk law under driving stresses (sigma, tau_d); rates in ``sigma_eq`` as one symbol."""

    # sig_eq of (sigma, tau_d). It vanishes where nothing is stressed: a consumer floors it before it divides.
    equivalent: sp.Expr
    axial_rate: sp.Expr  # Rates of eps_p and gamma_p
    shear_rate: tuple[sp.Expr, ...]
    speed: sp.Expr  # Equivalent plastic rate phi(sig_eq)
    dissipation: sp.Expr  # Plastic power per unit undeformed volume
    yields: sp.Expr  # 1 where the fibre flows, otherwise 0

    def subs(self, values: Mapping[sp.Expr, sp.Expr]) -> FibreFlow:
        """The same of other stresses."""
        plain = {
            name: getattr(self, name).subs(values, simultaneous=True)
            for name in ("equivalent", "axial_rate", "speed", "dissipation", "yields")
        }
        return FibreFlow(shear_rate=tuple(one.subs(values, simultaneous=True) for one in self.shear_rate), **plain)


def fibre_flow(
    rate: sp.Expr, share: sp.Expr = sp.S.One, carry: sp.Expr = CARRY, shears: tuple[Shear, ...] = IN_PLANE
) -> FibreFlow:
    """sig_eq = sqrt(m sigma^2 + 3 tau_d^2), eps_p_t = phi m sigma/sig_eq; gamma_p is carried by the plastic stretch.

    Of a plastic deformation that leaves sections plane the shear rate 3 phi tau_d/sig_eq is gamma_p_t + c gamma_p
    eps_p_t.
    """
    speed = rate.subs(sigma, sigma_eq)
    axial = share * speed * sigma / sigma_eq
    return FibreFlow(
        equivalent=sp.sqrt(share * sigma**2 + 3 * sp.Add(*(one.drive**2 for one in shears))),
        axial_rate=axial,
        shear_rate=tuple(3 * speed * one.drive / sigma_eq - carry * one.plastic * axial for one in shears),
        speed=speed,
        dissipation=speed * sigma_eq,
        yields=sp.sign(speed),
    )


def still(shears: tuple[Shear, ...] = IN_PLANE) -> FibreFlow:
    """A fibre that does not flow."""
    zero = sp.S.Zero
    return FibreFlow(zero, zero, (zero,) * len(shears), zero, zero, zero)


@dataclass(frozen=True, slots=True)
class FibreHardening:
    """Kinematic hardening of a fibre."""

    stored: sp.Expr  # Per unit undeformed volume, of the back strains
    rates: tuple[sp.Expr, ...]  # Of the axial back strain, and of that in shear, in ``sigma_eq`` as one symbol
    stress: sp.Expr  # Axial backstress


def hardened(flow: FibreFlow, share: sp.Expr = sp.S.One, carry: sp.Expr = CARRY) -> tuple[FibreFlow, FibreHardening]:
    """The same flow driven by the stresses less the backstresses, and what becomes of these.

    The back strain in shear follows the shear rate of the plastic deformation, gamma_p_t + c gamma_p eps_p_t: that
    which tau_d is the driving stress of. So the energy is closed at any stretch.
    """
    axially, across = hardening_rule.back_stress(share)
    absent = {} if flow.shear_rate else {hardening_rule.shear: 0}
    moved = flow.subs({sigma: sigma - axially, tau_d: tau_d - across})
    rates = (
        hardening_rule.back_rate(moved.axial_rate, hardening_rule.axial, moved.speed),
        *(
            hardening_rule.back_rate(rate + carry * gamma_p * moved.axial_rate, hardening_rule.shear, moved.speed)
            for rate in moved.shear_rate
        ),
    )
    # Power of the stresses in the plastic rates, less what is stored of it.
    lost = moved.dissipation + hardening_rule.recovered(share, moved.speed).subs(absent)
    stored = hardening_rule.stored(share).subs(absent)
    return replace(moved, dissipation=lost), FibreHardening(stored, rates, axially)


def growing(
    flow: FibreFlow | None, growth: sp.Expr, carry: sp.Expr = CARRY, shears: tuple[Shear, ...] = IN_PLANE
) -> FibreFlow:
    """What flows, and what springs without stress that join the others at this rate, over the modulus, add to it.

    Elastic strains fade at this rate, so that the stresses E eps_e and mu gamma_e of strains that are held stay as they
    are; the plastic stretch carries the plastic shear with it.
    """
    flowing = flow or still(shears)
    axial = growth * eps_e
    across = [growth * one.elastic * sp.exp(carry * eps_e) - carry * one.plastic * axial for one in shears]
    return replace(
        flowing,
        axial_rate=flowing.axial_rate + axial,
        shear_rate=tuple(one + added for one, added in zip(flowing.shear_rate, across, strict=True)),
        dissipation=flowing.dissipation
        + sigma_c * axial
        + sp.Add(*(one.drive * added for one, added in zip(shears, across, strict=True))),
    )


def rotary_inertia(section: Section) -> sp.Expr:
    """Rho I_0 = lambda_0 (h_0/2)^2 <zeta^2>, of the undeformed section.

    Thinning would divide it by Lam. It is kept constant so that the kinetic energy rho I_0 psi_t^2/2 has no other force
    to it; what it changes at all is of the order of (h_0/L)^2.
    """
    return mass_per_length() * h0**2 * section.zeta_squared / 4


RIGIDITY = 1000
"""How many times stiffer in shear a section is made that is not to shear: what remains of the shear is a thousandth."""


@dataclass(frozen=True, slots=True)
class FibreBranch:
    """One spring of a fibre with its flow rule."""

    modulus: sp.Expr  # Young's modulus of the material
    spring: FibreSpring
    flow: FibreFlow | None  # Plastic rates, of (sigma, tau_d), gamma_p and ``sigma_eq``; None where it does not flow
    hardening: FibreHardening | None = None


@dataclass(frozen=True, slots=True)
class ViscousFibre:
    """The viscous stress of a fibre: what its Rayleigh potential, half the power, derives to."""

    rayleigh: sp.Expr  # Of the shear strain and the rates of the strains (eps, gamma)
    strain_rates: tuple[sp.Expr, ...]  # These rates, of the strains of the cell and theirs
    natural_rate: sp.Expr = sp.S.Zero  # Rate of the strain without stress, beyond which the axial one is counted


@dataclass(frozen=True, slots=True)
class SampledSection:
    """What one point of a section answers to the strains of its cell, and what the section sums over its points."""

    point_strains: tuple[sp.Expr, ...]  # Axial strain of a point and its shears
    kinds: tuple[Shear, ...]  # None where sections are kept square, one in the plane, two in space
    branches: tuple[FibreBranch, ...]  # Springs in parallel
    viscous: ViscousFibre | None  # What acts beside them
    # Means over the section, by name: their symbol, of the stresses conjugate to the strains, times a lever.
    means: Mapping[str, tuple[sp.Symbol, sp.Expr, sp.Expr]]
    strains: tuple[sp.Symbol, ...]  # Of the cell: stretch, shears, curvatures; and their rates
    strain_rates: tuple[sp.Symbol, ...]
    power: sp.Expr  # Of the means in the strains, per unit rest length and undeformed area
    relative_thickness: sp.Expr  # h/h0 of Lam
    relaxed: sp.Expr = sp.S.Zero  # Strain of a fibre where the filament is as curved as it is by nature
    # Stored energy and Rayleigh potential that keep sections square to the centreline, of the strains of the cell.
    stiffener: sp.Expr = sp.S.Zero
    damper: sp.Expr = sp.S.Zero

    @property
    def shears(self) -> bool:
        """Whether shear is physics here; otherwise it is only kept small."""
        return bool(self.kinds)


@dataclass(frozen=True, slots=True, kw_only=True)
class ResolvedSection(SampledSection):
    """What one cell of a filament in its plane with a resolved section consists of."""

    cell: ShearingCell  # The chain from strains to forces
    rotary_inertia: sp.Expr  # rho I0, undeformed


def resolve(
    shape: Section, law: Law, *, shear: bool, curved: bool = False, shrinks: bool = False, hardens: bool = False
) -> ResolvedSection:
    """Assemble the chain for a section that shrinks as its shape does; where its material `shrinks`, so besides.

    Where shear is not physics a section is kept square to the centreline by a stiffness in shear that is large.
    """
    correction = shape.shear_correction * (1 if shear else RIGIDITY)
    cell, kinds = shearing_cell(shape.contraction, correction), IN_PLANE if shear else ()
    relaxed = -h0 * kappa_0 / 2 * zeta if curved else sp.Integer(0)
    natural, natural_rate = (
        (mean + more * zeta if shrinks else sp.Integer(0))
        for mean, more in (natural_strains(shape), natural_strains(shape, rates=True))
    )
    strains = (cell.axial_strain, *(cell.shear_strain for _ in kinds))
    pairs = ((Lam, Lam_t), (Gam, Gam_t), (k, k_t))
    means = {"axial": (sigma_mean, sigma_c, sp.S.One), "axial_zeta": (sigma_zeta, sigma_c, zeta)}
    means |= {"shear": (tau_mean, tau_f, sp.S.One)} if shear else {}
    moduli = [_shear_modulus(branch.modulus) for branch in law.branches] or [polymer_chains.modulus()]
    slipping = sp.Add(*(sp.diff(cell.shear_strain, strain) * rate for strain, rate in pairs))
    return ResolvedSection(
        point_strains=strains,
        kinds=kinds,
        branches=fibre_branches(shape, law, cell.carry, relaxed + natural, kinds, hardens=hardens),
        viscous=viscous_fibre(shape, law, strains, pairs, natural_rate, cell.carry, kinds),
        means=means,
        strains=tuple(strain for strain, _ in pairs),
        strain_rates=tuple(rate for _, rate in pairs),
        power=cell.power if shear else cell.power.subs(tau_mean, 0),
        relative_thickness=cell.thickness / h0,
        relaxed=relaxed,
        stiffener=sp.S.Zero if shear else sp.Add(*moduli) * cell.shear_strain**2 / 2,
        damper=sp.S.Zero if shear or law.viscosity is None else law.viscosity * slipping**2 / 6,
        cell=cell,
        rotary_inertia=rotary_inertia(shape),
    )


def _shear_modulus(modulus: sp.Expr) -> sp.Expr:
    return sp.factor(shear_modulus().subs(E, modulus))


def fibre_branches(
    shape: Section,
    law: Law,
    carry: sp.Expr = CARRY,
    relaxed: sp.Expr = sp.S.Zero,
    shears: tuple[Shear, ...] = IN_PLANE,
    *,
    hardens: bool = False,
) -> tuple[FibreBranch, ...]:
    """The springs of a law at a point of a section, with their flow rules."""
    share, found = PLANE_STRAIN**2 if shape.plane_strain else sp.S.One, []
    for branch in law.branches:
        flow = hardening = None
        if branch.flow is not None:
            flow = fibre_flow(branch.flow.rate, share, carry, shears)
            if hardens:
                flow, hardening = hardened(flow, share, carry)
        if branch.growth is not None:
            flow = growing(flow, branch.growth, carry, shears)
        modulus, shearing = stiffness(shape, branch.modulus), _shear_modulus(branch.modulus)
        spring = fibre_spring(modulus, shearing, carry, relaxed, shears)
        found.append(FibreBranch(branch.modulus, spring, flow, hardening))
    return tuple(found)


def viscous_fibre(
    shape: Section,
    law: Law,
    strains: Iterable[sp.Expr],
    pairs: Iterable[tuple[sp.Symbol, sp.Symbol]],
    natural_rate: sp.Expr = sp.S.Zero,
    carry: sp.Expr = CARRY,
    shears: tuple[Shear, ...] = IN_PLANE,
) -> ViscousFibre | None:
    """The viscous stress at a point: along it, and eta/3 (Trouton) in the shear of the whole deformation.

    The stretch carries that shear as well; `pairs` are the strains of the cell with their rates.
    """
    if law.viscosity is None:
        return None
    moving = tuple(pairs)
    axial, *sheared = (sp.Add(*(sp.diff(strain, one) * rate for one, rate in moving)) for strain in strains)
    square = sp.Add(*((one.rate + carry * one.total * eps_t) ** 2 for one in shears))
    potential = resistance(shape, law.viscosity) * eps_t**2 / 2 + law.viscosity * square / 6
    return ViscousFibre(potential, (axial - natural_rate, *sheared), natural_rate)
