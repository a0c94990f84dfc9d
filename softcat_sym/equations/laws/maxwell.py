"""Maxwell fluid: a spring in line with a dashpot, phi = sigma/eta (2.7)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.equations.equation import Equation
from softcat_sym.equations.law import Branch, Flow, Law
from softcat_sym.equations.laws.flow_rule import flow_rule
from softcat_sym.equations.section import Section
from softcat_sym.equations.section_means import SectionMeans
from softcat_sym.equations.symbols import eta, sigma, sigma_0, sigma_1


def maxwell_rate(viscosity: sp.Expr = eta) -> sp.Expr:
    """phi(sigma) = sigma/eta (2.7)."""
    return sigma / viscosity


def maxwell_means(section: Section, viscosity: sp.Expr = eta) -> SectionMeans:
    """Means of :func:`maxwell_rate`, linear in the stress, so that the section does not matter (2.12)."""
    del section
    return SectionMeans(
        rate=sigma_0 / viscosity,
        bending_rate=sigma_1 / viscosity,
        yielded_fraction=sp.Integer(1),
        largest_rate=(sp.Abs(sigma_0) + sp.Abs(sigma_1)) / viscosity,
    )


@dataclass(frozen=True, slots=True)
class _MaxwellMeans:
    """:func:`maxwell_means` at a viscosity: not a closure, so that its representation names it in every process."""

    viscosity: sp.Expr

    def __call__(self, section: Section) -> SectionMeans:
        return maxwell_means(section, self.viscosity)


def linear_flow(viscosity: sp.Expr) -> Flow:
    """The flow rule of a dashpot of this tensile viscosity."""
    return Flow(maxwell_rate(viscosity), closed_means=_MaxwellMeans(viscosity))


LAW = Law("maxwell", branches=(Branch(flow=linear_flow(eta)),))

EQUATIONS: tuple[Equation, ...] = (flow_rule("Maxwell fluid", maxwell_rate(), "2.7"),)
