"""What a constitutive law is: springs in parallel, each in line with a flow rule, beside a viscous stress.

sigma = sum of E_j (eps - eps_p_j) + eta eps_t,   d eps_p_j/dt = phi_j(sigma_j).   (2.7, 2.8, 2.25)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import sympy as sp

from softcat_sym.equations.section import Section
from softcat_sym.equations.section_means import SectionMeans, quadrature_means
from softcat_sym.equations.symbols import E

MeansOf = Callable[[Section], SectionMeans]


@dataclass(frozen=True, slots=True)
class Flow:
    """A flow rule and its means over a section.

    Attributes
    ----------
    rate : sympy.Expr
        phi, the plastic strain rate of a fibre, in the symbol ``sigma``: odd, and nowhere decreasing.
    threshold : sympy.Expr
        Stress below which nothing flows.
    closed_means : callable or None
        Means over a section in closed form; None where there is none, and they are taken by quadrature.
    """

    rate: sp.Expr
    threshold: sp.Expr = sp.S.Zero
    closed_means: MeansOf | None = None

    def means(self, section: Section) -> SectionMeans:
        """Means over a section in which the stress is sigma_0 + sigma_1 zeta."""
        if self.closed_means is not None:
            return self.closed_means(section)
        return quadrature_means(section, self.rate, self.threshold)


@dataclass(frozen=True, slots=True)
class Branch:
    """A spring in line with a flow rule.

    Attributes
    ----------
    modulus : sympy.Expr
        E_j.
    flow : Flow or None
        Without a yield stress; None for a spring alone.
    flow_beyond_yield : Flow or None
        With the yield stress; None if the law has none.
    """

    modulus: sp.Expr = E
    flow: Flow | None = None
    flow_beyond_yield: Flow | None = None

    def in_force(self, *, flows: bool, yields: bool) -> Branch:
        """The branch with the one flow rule that is in force, or none."""
        flow = self.flow_beyond_yield if yields and self.flow_beyond_yield is not None else self.flow
        return replace(self, flow=flow if flows else None, flow_beyond_yield=None)


@dataclass(frozen=True, slots=True)
class Constant:
    """A number that a law asks for, by the name that the scene gives it."""

    name: str
    symbol: sp.Symbol


@dataclass(frozen=True, slots=True)
class Law:
    """A constitutive law.

    Attributes
    ----------
    name : str
        As in the scene.
    branches : tuple of Branch
        Springs in parallel; none for a Newtonian fluid. Where a flow rule is not linear there is one branch only.
    viscosity : sympy.Expr or None
        eta of the viscous stress eta eps_t, if there is one.
    constants : tuple of Constant
        Beyond those that several laws share: of further modes, or of the user's own rule.
    """

    name: str
    branches: tuple[Branch, ...] = (Branch(),)
    viscosity: sp.Expr | None = None
    constants: tuple[Constant, ...] = ()

    @property
    def flows(self) -> bool:
        """Whether any branch flows."""
        return any(branch.flow is not None for branch in self.branches)

    @property
    def yields(self) -> bool:
        """Whether any branch has a yield stress."""
        return any(branch.flow_beyond_yield is not None for branch in self.branches)


ELASTIC = Law("elastic")
