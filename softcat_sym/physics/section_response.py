"""The section of the paper: its stress is linear through the thickness, its plastic state a mean and a moment.

The closures say what that state counts for (THEORY 4): the paper's, as printed, and the material one, the default.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from softcat_sym.physics.bulk import nu
from softcat_sym.physics.constitutive_laws import Branch, Law
from softcat_sym.physics.kinematics import StrainMeasure
from softcat_sym.physics.sections import Contraction, Section, SectionMeans, of_bending_alone, scaled
from softcat_sym.physics.symbols import (
    A0,
    AREA,
    LENGTH,
    M,
    T,
    a_0,
    a_1,
    enter,
    h0,
    kappa_0,
    n_0,
    n_0_t,
    n_1,
    n_1_t,
    s,
    s_t,
    sigma_0,
    sigma_1,
    theta_X,
    theta_Xt,
)
from softcat_sym.physics.terms import Terms

PLANE_STRAIN = sp.sqrt(3) / 2
"""Equivalent stress over axial stress in a section too wide to change its width (von Mises, incompressible flow)."""


@dataclass(frozen=True, slots=True)
class ClosedSection:
    """What a closure makes of a strain measure and a contraction."""

    lever: sp.Expr  # Bending strain at zeta = 1 per unit -theta_X
    recall_mean: sp.Expr  # Factors with which the states a_0 and a_1 count as plastic strain
    recall_bending: sp.Expr
    axial_correction: sp.Expr  # Q - T in terms of M, theta_X and s


def material(measure: StrainMeasure, contraction: Contraction) -> ClosedSection:
    """Fibres keep their zeta: eps = log s - theta_s (h/2) zeta, and Q = T + (3/2) M theta_s by work conjugacy.

    The correction to T is what the bending strain gains when the stretch changes at a fixed turning.
    """
    lever = contraction.thickness / (2 * measure.arc_stretch)
    return ClosedSection(
        lever=lever,
        recall_mean=sp.Integer(1),
        recall_bending=sp.Integer(1),
        axial_correction=-M * theta_X * sp.powsimp(sp.diff(lever, s) / lever),
    )


def printed(measure: StrainMeasure, contraction: Contraction) -> ClosedSection:
    """(2.6), (2.9)-(2.12): eps = log s - theta_X z, P and C as states, Q = T.

    P_t = integral of phi over the *current* section, so that P/A grows or shrinks with the section: the terms that the
    shrinking adds (A_t P/A and the like) are missing, and at finite stretch the tension is too small.
    """
    del measure
    shrink = A0 / contraction.area
    return ClosedSection(
        lever=contraction.thickness / 2,
        recall_mean=shrink,
        recall_bending=shrink * h0 / contraction.thickness,
        axial_correction=sp.Integer(0),
    )


CLOSURES = {"material": material, "printed": printed}

h = enter("h", "h", LENGTH, "thickness of the section", "2.26", positive=True)
A = enter("A", "A", AREA, "area of the section", "2.9", positive=True)


@dataclass(frozen=True, slots=True)
class StressPart:
    """One part of the stress sigma_0 + sigma_1 zeta (2.23), with its densities per unit material length."""

    stress_mean: sp.Expr  # sigma_0 and sigma_1 of the strains and the plastic state, or the rates of the strains
    stress_bending: sp.Expr
    # What its tension and its moment derive from: the stored energy of a spring, of (s, a_0) and (s, theta_X, a_1), or
    # the Rayleigh potential of a viscous stress, of (s, s_t) and (s, s_t, theta_X, theta_Xt).
    stretching: sp.Expr
    bending: sp.Expr
    yielded_fraction: sp.Expr  # Share of the section that flows, and its largest rate, of (sigma_0, sigma_1)
    plastic_rate: sp.Expr


@dataclass(frozen=True, slots=True)
class BranchResponse(StressPart):
    """A spring with its flow rule."""

    means: SectionMeans | None  # Means of the flow rule of (sigma_0, sigma_1)
    rate_mean: sp.Expr  # da_0/dt and da_1/dt of (sigma_0, sigma_1, s) (2.24)
    rate_bending: sp.Expr
    # Plastic power of stretching and of bending, of (sigma_0, sigma_1, s). Neither is ever negative: for an odd,
    # monotone flow rule and a symmetric section <phi> has the sign of sigma_0 and <phi zeta> that of sigma_1.
    dissipation: tuple[sp.Expr, sp.Expr]


@dataclass(frozen=True, slots=True)
class ViscousResponse(StressPart):
    """The viscous stress eta eps_t."""


@dataclass(frozen=True, slots=True)
class SectionResponse:
    """The whole section."""

    branches: tuple[BranchResponse, ...]  # Springs in parallel
    viscous: ViscousResponse | None  # What acts beside them
    area: sp.Expr  # A(s), h(s) (2.9)
    thickness: sp.Expr
    tension: sp.Expr  # T of (sigma_0, s) and M of (sigma_1, s) (2.10)
    moment: sp.Expr
    stress_of_tension: sp.Expr  # The inverse: sigma_0 of (T, s) and sigma_1 of (M, s) (2.23)
    stress_of_moment: sp.Expr
    axial_correction: sp.Expr  # Q - T of (M, theta_X, s)
    # Material that a unit of material length stores energy in. If it depends on s, because only one of finite stretch
    # and thinning is in force, T has no potential and the energy balance cannot close.
    volume: sp.Expr

    @property
    def branch(self) -> BranchResponse:
        """The only branch."""
        (only,) = self.branches
        return only

    @property
    def parts(self) -> tuple[BranchResponse | ViscousResponse, ...]:
        """The branches, followed by the viscous stress if there is one."""
        return self.branches if self.viscous is None else (*self.branches, self.viscous)


@dataclass(frozen=True, slots=True)
class SectionShape:
    """The section as the effects in force leave it."""

    section: Section  # Its outline
    contraction: Contraction  # How it shrinks
    strain: StrainMeasure  # Axial strain
    terms: Terms  # What is in force: bending, stretching, a natural curvature, a natural strain

    @property
    def axial_strain(self) -> sp.Expr:
        """Strain of the centreline, a function of s."""
        return self.strain.strain if self.terms.stretches else sp.Integer(0)

    @property
    def mean_stress(self) -> sp.Expr:
        """sigma_0, or nothing in a beam that does not stretch: only the part sigma_1 zeta is left of its stress."""
        return sigma_0 if self.terms.stretches else sp.Integer(0)

    def natural_strains(self, *, rates: bool = False) -> tuple[sp.Expr, sp.Expr]:
        """Natural strain, its mean and what the top has more, or their rates; nothing where there is none."""
        nothing = sp.Integer(0), sp.Integer(0)
        mean, more = natural_strains(self.section, rates=rates) if self.terms.shrinks else nothing
        return mean if self.terms.stretches else sp.Integer(0), more

    @property
    def weight(self) -> sp.Expr:
        """Power of the stress is T s_t - M theta_X,t = weight <sigma eps_t>: A_0 when the section thins."""
        return sp.powsimp(self.contraction.area / sp.diff(self.strain.strain, s))


def natural_strains(shape: Section, *, rates: bool = False) -> tuple[sp.Expr, sp.Expr]:
    """Natural strain of the section: its mean, and what the top has more; or their rates.

    A width that is held flat and may become smaller as a whole bends by 1 + nu times as much: what shrinks in it pulls
    across, too.
    """
    mean, more = (n_0_t, n_1_t) if rates else (n_0, n_1)
    return mean, more * (1 + nu) if shape.plane_strain else more


def shrunk(shape: Section) -> tuple[sp.Expr, sp.Expr]:
    """Factors on area and thickness of a section that has shrunk alike in all directions, its stretch left aside.

    A filament of the volume exp(3 n_0) that is held at the stretch s has the area exp(3 n_0)/s.
    """
    return sp.exp(3 * n_0), sp.exp(2 * n_0 if shape.plane_strain else 3 * n_0 / 2)


def respond(shape: SectionShape, closed: ClosedSection, law: Law) -> SectionResponse:
    """Assemble the section of a law whose branches hold the flow rule that is in force."""
    area, thickness = shape.contraction.area, shape.contraction.thickness
    bends = sp.Integer(1) if shape.terms.bending else sp.Integer(0)
    modulus = area * thickness * shape.section.zeta_squared / 2
    return SectionResponse(
        branches=tuple(_branch(shape, closed, branch) for branch in law.branches),
        viscous=None if law.viscosity is None else _viscous(shape, closed, law.viscosity),
        area=area,
        thickness=thickness,
        tension=area * shape.mean_stress,
        moment=bends * modulus * sigma_1,
        stress_of_tension=T / area if shape.terms.stretches else sp.Integer(0),
        stress_of_moment=bends * M / modulus,
        axial_correction=bends * closed.axial_correction,
        volume=shape.weight,
    )


def stiffness(shape: Section, modulus: sp.Expr) -> sp.Expr:
    """Modulus of a fibre: E, or E/(1 - nu^2) where the width is held."""
    return modulus / (1 - nu**2) if shape.plane_strain else modulus


def resistance(shape: Section, viscosity: sp.Expr) -> sp.Expr:
    """Viscosity of a fibre: eta, or 4/3 eta where the width is held."""
    return viscosity / PLANE_STRAIN**2 if shape.plane_strain else viscosity


def _branch(shape: SectionShape, closed: ClosedSection, branch: Branch) -> BranchResponse:
    zero = sp.Integer(0)
    bends = sp.Integer(1) if shape.terms.bending else zero
    modulus, means = stiffness(shape.section, branch.modulus), None
    if branch.flow is not None:
        means = branch.flow.means(shape.section)
        means = scaled(means, PLANE_STRAIN) if shape.section.plane_strain else means
        means = means if shape.terms.stretches else of_bending_alone(means)
    if branch.growth is not None:
        means = _growing(means, branch.growth / modulus, shape)
    bending = closed.lever * theta_X - (h0 * kappa_0 / 2 if shape.terms.curved else zero)
    natural = shape.natural_strains()
    plastic_mean = closed.recall_mean * a_0 if means and shape.terms.stretches else zero
    plastic_bending = closed.recall_bending * a_1 if means else zero
    weight, bending_weight = shape.weight, bends * shape.weight * shape.section.zeta_squared
    stress_mean = modulus * (shape.axial_strain - plastic_mean - natural[0])
    stress_bending = -bends * modulus * (bending + plastic_bending + natural[1])
    return BranchResponse(
        stress_mean=stress_mean,
        stress_bending=stress_bending,
        stretching=weight * stress_mean**2 / (2 * modulus),
        bending=bending_weight * stress_bending**2 / (2 * modulus),
        yielded_fraction=means.yielded_fraction if means else zero,
        plastic_rate=means.largest_rate if means else zero,
        means=means,
        rate_mean=means.rate / closed.recall_mean if means else zero,
        rate_bending=bends * means.bending_rate / closed.recall_bending if means else zero,
        dissipation=(
            weight * shape.mean_stress * means.rate if means else zero,
            bending_weight * sigma_1 * means.bending_rate if means else zero,
        ),
    )


def _growing(means: SectionMeans | None, compliance: sp.Expr, shape: SectionShape) -> SectionMeans:
    """What flows, and what springs without stress that join the others add: the stress over E, times the growth g.

    With a_t = sigma g/E, g = E_t/E, the stress E (eps - a) of a strain that is held stays as it is: sigma_t = E eps_t.
    """
    zero = sp.Integer(0)
    flowing = means or SectionMeans(rate=zero, bending_rate=zero, yielded_fraction=zero, largest_rate=zero)
    return replace(
        flowing,
        rate=flowing.rate + shape.mean_stress * compliance,
        bending_rate=flowing.bending_rate + sigma_1 * compliance,
    )


def _viscous(shape: SectionShape, closed: ClosedSection, viscosity: sp.Expr) -> ViscousResponse:
    eta = resistance(shape.section, viscosity)
    bends = sp.Integer(1) if shape.terms.bending else sp.Integer(0)
    turning = sp.diff(closed.lever, s) * s_t * theta_X + closed.lever * theta_Xt
    natural = shape.natural_strains(rates=True)
    stress_mean = eta * (sp.diff(shape.axial_strain, s) * s_t - natural[0])
    stress_bending = -bends * eta * (turning + natural[1])
    return ViscousResponse(
        stress_mean=stress_mean,
        stress_bending=stress_bending,
        stretching=shape.weight * stress_mean**2 / (2 * eta),
        bending=bends * shape.weight * shape.section.zeta_squared * stress_bending**2 / (2 * eta),
        yielded_fraction=sp.Integer(1),
        plastic_rate=(sp.Abs(shape.mean_stress) + sp.Abs(sigma_1)) / eta,
    )
