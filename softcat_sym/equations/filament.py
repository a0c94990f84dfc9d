"""One section of the filament, assembled from the terms that the effects in force have picked.

:class:`Terms` starts as the barest filament there is: an elastic string at small slope and strain, without inertia,
under gravity switched on at once. Each effect replaces what it is responsible for. :func:`derive` turns the terms into
the expressions of one cell; the graph prints these same objects.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations import closure, kinematics, section
from softcat_sym.equations.balance import InternalForce, internal_force
from softcat_sym.equations.fibres import ResolvedSection, resolve
from softcat_sym.equations.necking import NECKS, Neck
from softcat_sym.equations.rheology import SectionMeans
from softcat_sym.equations.symbols import A0, E, M, T, a_0, a_1, g, h0, s, sigma_0, sigma_1, theta_X

MeansOf = Callable[[section.Section], SectionMeans]


@dataclass(frozen=True, slots=True)
class Terms:
    """What the equations are made of; every field has the value of the barest filament.

    Attributes
    ----------
    centreline : Kinematics
        Stretch and turning.
    strain : StrainMeasure
        Axial strain.
    contraction : Contraction
        How the section shrinks.
    inertia, bending : bool
        Whether momentum and moment are in the balance.
    flow, flow_beyond_yield : callable or None
        Means of the flow rule without and with a yield stress; no plastic state if both are None.
    rate, rate_beyond_yield : sympy.Expr or None
        The flow rule phi of one fibre, in the symbol ``sigma``, without and with a yield stress.
    shear, rotary_inertia : bool
        Whether the section turns by itself, and whether it takes a moment to turn it faster.
    resolved : bool
        Whether the plastic strain has any profile through the thickness, instead of a linear one.
    necking_gradient : bool
        Whether a neck's slope stiffens it.
    gravity, gravity_rate : sympy.Expr
        g(t) and dg/dt.
    """

    centreline: kinematics.Kinematics = kinematics.SMALL_SLOPE
    strain: kinematics.StrainMeasure = kinematics.SMALL_STRAIN
    contraction: section.Contraction = section.NONE
    inertia: bool = False
    bending: bool = False
    flow: MeansOf | None = None
    flow_beyond_yield: MeansOf | None = None
    rate: sp.Expr | None = None
    rate_beyond_yield: sp.Expr | None = None
    shear: bool = False
    rotary_inertia: bool = False
    resolved: bool = False
    necking_gradient: bool = False
    gravity: sp.Expr = g
    gravity_rate: sp.Expr = sp.S.Zero


@dataclass(frozen=True, slots=True)
class SectionEquations:
    """A section's answer to its stretch s, turning theta_X and plastic state (a_0, a_1).

    Attributes
    ----------
    stress_mean, stress_bending : sympy.Expr
        sigma_0 of (s, a_0) and sigma_1 of (s, theta_X, a_1): the stress is sigma_0 + sigma_1 zeta (2.23).
    area, thickness : sympy.Expr
        A(s), h(s) (2.9).
    tension, moment : sympy.Expr
        T of (sigma_0, s) and M of (sigma_1, s) (2.10).
    stress_of_tension, stress_of_moment : sympy.Expr
        The inverse: sigma_0 of (T, s) and sigma_1 of (M, s) (2.23).
    axial_correction : sympy.Expr
        Q - T of (M, theta_X, s).
    means : SectionMeans or None
        Means of the flow rule of (sigma_0, sigma_1).
    rate_mean, rate_bending : sympy.Expr
        da_0/dt and da_1/dt of (sigma_0, sigma_1, s) (2.24).
    elastic_mean, elastic_bending : sympy.Expr
        Stored energy per unit material length, of stretching and of bending.
    volume : sympy.Expr
        Material that a unit of material length stores energy in. If it depends on s, because only one of finite stretch
        and thinning is in force, T has no potential and the energy balance cannot close.
    dissipation_mean, dissipation_bending : sympy.Expr
        Plastic power per unit material length, of stretching and of bending. Neither is ever negative: for an odd,
        monotone flow rule and a symmetric section <phi> has the sign of sigma_0 and <phi zeta> that of sigma_1.
    """

    stress_mean: sp.Expr
    stress_bending: sp.Expr
    area: sp.Expr
    thickness: sp.Expr
    tension: sp.Expr
    moment: sp.Expr
    stress_of_tension: sp.Expr
    stress_of_moment: sp.Expr
    axial_correction: sp.Expr
    volume: sp.Expr
    means: SectionMeans | None
    rate_mean: sp.Expr
    rate_bending: sp.Expr
    elastic_mean: sp.Expr
    elastic_bending: sp.Expr
    dissipation_mean: sp.Expr
    dissipation_bending: sp.Expr

    def relations_per_area(self) -> dict[str, sp.Expr]:
        """Relations between strain, stress and resultants, per unit undeformed area.

        The balance is divided by A_0 throughout, so forces and energies are those of a filament of unit area.
        """
        names = (
            "stress_mean",
            "stress_bending",
            "tension",
            "moment",
            "stress_of_tension",
            "stress_of_moment",
            "axial_correction",
        )
        relations = {name: getattr(self, name).subs(A0, 1) for name in names}
        return {**relations, "relative_thickness": self.thickness / h0}

    def flow_per_area(self) -> dict[str, sp.Expr]:
        """What a known stress does to the section, of (sigma_0, sigma_1, s), per unit undeformed area."""
        means = self.means
        relations = {
            "rate_mean": self.rate_mean,
            "rate_bending": self.rate_bending,
            "elastic_mean": self.elastic_mean,
            "elastic_bending": self.elastic_bending,
            "dissipation_mean": self.dissipation_mean,
            "dissipation_bending": self.dissipation_bending,
            "yielded_fraction": means.yielded_fraction if means else sp.Integer(0),
            "plastic_rate": means.largest_rate if means else sp.Integer(0),
        }
        return {name: relation.subs(A0, 1) for name, relation in relations.items()}


@dataclass(frozen=True, slots=True)
class FilamentEquations:
    """The expressions of one cell of a filament: what the graph is printed from.

    Attributes
    ----------
    terms : Terms
        What the effects left.
    shape : Section
        Cross-section.
    closure : str
        ``material`` or ``printed``.
    response : SectionEquations
        The section of the paper: no shear, a plastic strain linear through the thickness.
    resolved : ResolvedSection or None
        The section point by point, where shear or fibres are in force; it then replaces `response`.
    neck : Neck or None
        The gradient term, if in force.
    force : InternalForce
        Q t + N n of a filament that does not shear.
    """

    terms: Terms
    shape: section.Section
    closure: str
    response: SectionEquations
    resolved: ResolvedSection | None
    neck: Neck | None
    force: InternalForce

    @property
    def conserves_energy(self) -> bool:
        """Whether forces and stored energy belong together, so that the energy balance can be judged."""
        return self.closure == "material" and s not in self.response.volume.free_symbols


def derive(terms: Terms, shape: section.Section, closure_name: str) -> FilamentEquations:
    """Assemble one cell.

    Parameters
    ----------
    terms : Terms
        As left by the effects.
    shape : Section
        Rectangle or circle.
    closure_name : str
        ``material`` or ``printed``.
    """
    closed = closure.CLOSURES[closure_name](terms.strain, terms.contraction)
    means_of = terms.flow_beyond_yield or terms.flow
    means = means_of(shape) if means_of is not None else None
    rate = terms.rate_beyond_yield if terms.rate_beyond_yield is not None else terms.rate
    return FilamentEquations(
        terms=terms,
        shape=shape,
        closure=closure_name,
        response=_respond(terms, shape, closed, means),
        resolved=resolve(shape, rate, shear=terms.shear) if terms.shear or terms.resolved else None,
        neck=NECKS[shape.name] if terms.necking_gradient else None,
        force=internal_force(terms.centreline, bending=terms.bending),
    )


def _respond(
    terms: Terms, shape: section.Section, closed: closure.ClosedSection, means: SectionMeans | None
) -> SectionEquations:
    zero = sp.Integer(0)
    bends = sp.Integer(1) if terms.bending else zero
    area, thickness = terms.contraction.area, terms.contraction.thickness
    plastic_mean = closed.recall_mean * a_0 if means else zero
    plastic_bending = closed.recall_bending * a_1 if means else zero
    modulus = area * thickness * shape.zeta_squared / 2
    # Power of the stress is T s_t - M theta_X,t = (A ds/deps) <sigma eps_t>: the bracket is A_0 when the section thins.
    weight = sp.simplify(area / sp.diff(terms.strain.strain, s))
    bending_weight = bends * weight * shape.zeta_squared
    return SectionEquations(
        stress_mean=E * (terms.strain.strain - plastic_mean),
        stress_bending=-bends * E * (closed.lever * theta_X + plastic_bending),
        area=area,
        thickness=thickness,
        tension=area * sigma_0,
        moment=bends * modulus * sigma_1,
        stress_of_tension=T / area,
        stress_of_moment=bends * M / modulus,
        axial_correction=bends * closed.axial_correction,
        volume=weight,
        means=means,
        rate_mean=means.rate / closed.recall_mean if means else zero,
        rate_bending=bends * means.bending_rate / closed.recall_bending if means else zero,
        elastic_mean=weight * sigma_0**2 / (2 * E),
        elastic_bending=bending_weight * sigma_1**2 / (2 * E),
        dissipation_mean=weight * sigma_0 * means.rate if means else zero,
        dissipation_bending=bending_weight * sigma_1 * means.bending_rate if means else zero,
    )
