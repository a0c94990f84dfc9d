"""The section resolved point by point, that shears or not, written out."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from softcat_sym.equations import reissner
from softcat_sym.equations.balance import F_x, F_y
from softcat_sym.equations.bulk import sigma_eq
from softcat_sym.equations.fibres import ResolvedSection
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.equations.in_force_section import gradient_term, plain_rate, surface_term
from softcat_sym.equations.laws.flow_rule import plastic_rate
from softcat_sym.equations.necking import s_slope
from softcat_sym.equations.paper_section import A, h
from softcat_sym.equations.reissner import (
    Gam,
    Lam,
    S,
    eps_p,
    gamma_p,
    k,
    m_c,
    n_1,
    n_2,
    psi,
    sigma_mean,
    sigma_zeta,
    tau_f,
    tau_mean,
)
from softcat_sym.equations.section_response import PLANE_STRAIN
from softcat_sym.equations.symbols import ONE, STRESS, M, T, X, enter, h0, s, sigma, t, zeta
from softcat_sym.equations.written import Mean, Rate, Stated, stated

_SOURCE = "Reissner 1972"


def resolved_section(equations: FilamentEquations) -> tuple[Stated, ...]:
    """Everything of a resolved section up to the forces.

    Raises
    ------
    ValueError
        If the section is not resolved.
    """
    resolved = equations.resolved
    if resolved is None:
        raise ValueError("this section is not resolved point by point")
    return (
        *_strains(resolved),
        *_stresses(resolved),
        *_flows(equations, resolved),
        *_resultants(equations, resolved),
    )


def _strains(resolved: ResolvedSection) -> Iterator[Stated]:
    yield stated("stretch along the section's normal", Lam, resolved.strains[0], _SOURCE)
    if resolved.shears:
        yield stated("shear of the section", Gam, resolved.strains[1], _SOURCE)
    else:
        yield stated("sections stay normal to the centreline", sp.Integer(0), resolved.strains[1], "2.5")
    yield stated("bending", k, Rate(psi, X, 1), _SOURCE)
    yield stated("area", A, resolved.cell.area, "2.9")
    yield stated("thickness", h, resolved.relative_thickness * h0, "2.9")


def _stresses(resolved: ResolvedSection) -> Iterator[Stated]:
    # A spring by itself has no plastic state.
    at_rest = {eps_p: sp.Integer(0), gamma_p: sp.Integer(0)}
    parts = [
        (b.axial_stress, b.shear_stress) if b.flow else (b.axial_stress.subs(at_rest), b.shear_stress.subs(at_rest))
        for b in resolved.branches
    ]
    if resolved.viscous is not None:
        parts.append((resolved.viscous.axial_stress, resolved.viscous.shear_stress))
    several = len(parts) > 1
    for j, (axial, shear) in enumerate(parts):
        new, which = _names(j, several=several), f", part {j + 1}" if several else ""
        yield stated(f"axial stress of a fibre{which}", sigma.xreplace(new), axial.xreplace(new), "2.6, 2.8")
        if resolved.shears:
            yield stated(f"shear stress of a fibre{which}", tau_f.xreplace(new), shear.xreplace(new), _SOURCE)
    if several:
        for total in (sigma, tau_f) if resolved.shears else (sigma,):
            added = sp.Add(*(total.xreplace(_names(j, several=True)) for j in range(len(parts))))
            yield stated("sum over the parts in parallel", total, added, "2.8")


def _flows(equations: FilamentEquations, resolved: ResolvedSection) -> Iterator[Stated]:
    several = len(resolved.branches) + (resolved.viscous is not None) > 1
    share = PLANE_STRAIN**2 if equations.shape.plane_strain else sp.S.One
    # The rates of the section with the rule as one symbol, which is written by itself.
    flow = (reissner.fibre_flow if resolved.shears else reissner.axial_flow)(plastic_rate, share)
    for j, branch in enumerate(equations.law.branches):
        if branch.flow is None:
            continue
        new, which = _names(j, several=several), f", part {j + 1}" if several else ""
        yield stated(f"equivalent stress{which}", sigma_eq, flow.equivalent.xreplace(new), "3.5")
        rule = plain_rate(branch.flow).subs(sigma, sigma_eq)
        yield stated(f"flow rule{which}", plastic_rate, rule, "2.7, 2.25")
        yield stated(
            f"axial flow of a fibre{which}", Rate(eps_p.xreplace(new), t, 1), flow.axial_rate.xreplace(new), "3.7"
        )
        if resolved.shears:
            shear = flow.shear_rate.xreplace(new)
            yield stated(f"plastic shear of a fibre{which}", Rate(gamma_p.xreplace(new), t, 1), shear, "3.7")


def _resultants(equations: FilamentEquations, resolved: ResolvedSection) -> Iterator[Stated]:
    cell = resolved.cell
    means = {sigma_mean: Mean(sigma), sigma_zeta: Mean(sigma * zeta), tau_mean: Mean(tau_f)}
    yield stated("tension", T, cell.tension.xreplace(means), "2.10")
    yield stated("bending moment", M, cell.moment.xreplace(means), "2.10")
    if resolved.shears:
        yield stated("shear force", S, cell.shear_force.xreplace(means), _SOURCE)
    along = cell.normal_force if resolved.shears else cell.normal_force.subs(Gam, 0)
    gain = gradient_term(equations).subs(s, Lam)
    pull = surface_term(equations)
    outward, aside = (pull * Lam / s, pull * Gam / s) if resolved.shears else (pull.subs(s, Lam), sp.S.Zero)
    source = "THEORY 4; Audoly & Hutchinson 2016" if gain else "THEORY 4"
    source += "; Eggers & Dupont 1994" if pull else ""
    if aside:
        yield stated("stretch of the centreline", s, sp.sqrt(Lam**2 + Gam**2), _SOURCE)
    yield stated("force along the section's normal", n_1, along + gain + outward, source)
    if equations.neck is not None:
        yield stated("slope of a neck", s_slope, Rate(Lam, X, 1), "Audoly & Hutchinson 2016")
    if resolved.shears:
        yield stated("force along the section", n_2, cell.section_force + aside, _SOURCE)
    yield stated("couple", m_c, cell.couple, _SOURCE)
    yield stated("internal force, horizontal", F_x, cell.force[0], _SOURCE)
    yield stated("internal force, vertical", F_y, cell.force[1], _SOURCE)
    turning = resolved.rotary_inertia * Rate(psi, t, 2) if equations.terms.rotary_inertia else sp.Integer(0)
    moments = cell.turning_moment if resolved.shears else cell.turning_moment.subs(Gam, 0)
    yield stated("balance of moments", turning, Rate(m_c, X, 1) + moments, _SOURCE)


def _names(number: int, *, several: bool) -> dict[sp.Symbol, sp.Symbol]:
    """Symbols of one of several parts in parallel; the plain ones of an only part."""
    if not several:
        return {}
    j = number + 1
    return {
        symbol: enter(f"{symbol.name}_part{j}", f"{latex}({j})}}", dimension, f"{meaning} of part {j}", "2.8")
        for symbol, latex, dimension, meaning in (
            (sigma, r"\sigma^{", STRESS, "stress of a fibre"),
            (tau_f, r"\tau^{", STRESS, "shear stress of a fibre"),
            (eps_p, r"\epsilon^{p", ONE, "axial plastic strain of a fibre"),
            (gamma_p, r"\gamma^{p", ONE, "plastic shear of a fibre"),
        )
    }
