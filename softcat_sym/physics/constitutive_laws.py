"""The constitutive laws: springs in parallel, each in line with a flow rule, beside a viscous stress."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import cast

import sympy as sp

from softcat_sym.physics import polymer_chains
from softcat_sym.physics.polymer_chains import Chains
from softcat_sym.physics.sections import TINY, Section, SectionMeans, quadrature_means
from softcat_sym.physics.symbols import (
    ONE,
    RATE,
    STRESS,
    VISCOSITY,
    Dimension,
    E,
    c,
    enter,
    eta,
    sigma,
    sigma_0,
    sigma_1,
    sigma_Y,
)
from softcat_sym.scene.formula import Formula, parse_formula
from softcat_sym.scene.laws import LAWS, LINEAR, POWER, LawSpec

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
    growth : sympy.Expr or None
        Rate at which the modulus grows by springs that are without stress when they join, over the modulus [1/s]; None
        of a modulus that stays.
    """

    modulus: sp.Expr = E
    flow: Flow | None = None
    flow_beyond_yield: Flow | None = None
    growth: sp.Expr | None = None

    @property
    def has_state(self) -> bool:
        """Whether its spring has a plastic strain: of flow, or of springs that joined it later."""
        return self.flow is not None or self.growth is not None

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
    chains : Chains or None
        Polymer chains instead of springs, of modulus E/3 in shear; None for every other law.
    """

    name: str
    branches: tuple[Branch, ...] = (Branch(),)
    viscosity: sp.Expr | None = None
    constants: tuple[Constant, ...] = ()
    chains: Chains | None = None

    @property
    def flows(self) -> bool:
        """Whether any branch flows, or chains relax."""
        relaxes = self.chains is not None and self.chains.relaxes
        return relaxes or any(branch.flow is not None for branch in self.branches)

    @property
    def yields(self) -> bool:
        """Whether any branch has a yield stress."""
        return any(branch.flow_beyond_yield is not None for branch in self.branches)


def growth_of(modulus: sp.Symbol) -> sp.Symbol:
    """Rate at which a modulus grows, over it; zero while it falls."""
    name = f"g_{modulus.name}"
    return enter(
        name, name, RATE, f"growth of {modulus.name} over it, by springs without stress", "Castonguay et al. 2025"
    )


plastic_rate = enter("eps_p_t", r"\epsilon^p_t", RATE, "plastic strain rate of a fibre", "2.7")


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


def linear_flow(viscosity: sp.Expr) -> Flow:
    """The flow rule of a dashpot of this tensile viscosity."""
    return Flow(maxwell_rate(viscosity), closed_means=partial(maxwell_means, viscosity=viscosity))


E_2 = enter("E_2", "E_2", STRESS, "modulus of the spring in line with the dashpot", "Zener 1948", positive=True)

_SOURCE = "Wiechert 1893"


def mode(number: int) -> tuple[sp.Symbol, sp.Symbol]:
    """Modulus and tensile viscosity of one mode; the first is number 1."""
    return (
        enter(f"E_m{number}", f"E_{{m{number}}}", STRESS, f"modulus of mode {number}", _SOURCE, positive=True),
        enter(
            f"eta_m{number}", rf"\eta_{{m{number}}}", VISCOSITY, f"viscosity of mode {number}", _SOURCE, positive=True
        ),
    )


def multimode_maxwell(modes: int) -> Law:
    """The law of so many modes, whose constants are ``mode_1_youngs_modulus``, ``mode_1_viscosity`` and so on.

    Raises
    ------
    ValueError
        If there is no mode.
    """
    if modes < 1:
        raise ValueError(f"a multi-mode fluid has one mode or more, not {modes}")
    branches, constants = [], []
    for number in range(1, modes + 1):
        modulus, viscosity = mode(number)
        branches.append(Branch(modulus, flow=linear_flow(viscosity)))
        constants.append(Constant(f"mode_{number}_youngs_modulus", modulus))
        constants.append(Constant(f"mode_{number}_viscosity", viscosity))
    return Law("multimode-maxwell", branches=tuple(branches), constants=tuple(constants))


def bingham_rate() -> sp.Expr:
    """phi(sigma) = <|sigma| - sigma_Y> sign(sigma)/eta (2.25)."""
    return sp.Piecewise(
        ((sigma - sigma_Y) / eta, sigma > sigma_Y), ((sigma + sigma_Y) / eta, sigma < -sigma_Y), (sp.Integer(0), True)
    )


def bingham_means(section: Section) -> SectionMeans:
    """Means of :func:`bingham_rate` in closed form: (2.26), (2.27) for every sign case, free of 0/0.

    The fibres beyond sigma_Y in tension fill zeta from an edge c to the stressed side, those in compression from the
    other side; with the stress slope |sigma_1| the means are |sigma_1| K_n(c), and a section that has yielded right
    through adds the overstress of its least stressed fibre. Both sides bend the section the way of sigma_1.
    """
    slope = sp.Abs(sigma_1)
    tension = _one_sided(section, sigma_0 - sigma_Y, slope)
    compression = _one_sided(section, -sigma_0 - sigma_Y, slope)
    moment_per_slope = tension.moment_per_slope + compression.moment_per_slope
    return SectionMeans(
        rate=(tension.mean - compression.mean) / eta,
        bending_rate=sigma_1 * moment_per_slope / (section.zeta_squared * eta),
        yielded_fraction=tension.area + compression.area,
        largest_rate=sp.Max(0, sp.Abs(sigma_0) + slope - sigma_Y) / eta,
    )


@dataclass(frozen=True, slots=True)
class _OneSided:
    mean: sp.Expr
    moment_per_slope: sp.Expr
    area: sp.Expr


def _one_sided(section: Section, overstress: sp.Expr, slope: sp.Expr) -> _OneSided:
    low, high = section.interval
    edge = sp.Min(sp.Max(-overstress / sp.Max(slope, TINY * E), low), high)

    def beyond(partial: sp.Expr) -> sp.Expr:
        value = partial.subs(c, edge)
        # Where c is kept inside (-1, 1) a trace of 1e-21 would be left of a section that does not yield at all.
        return value if high == 1 else sp.Piecewise((value, edge < high), (sp.Integer(0), True))

    return _OneSided(
        mean=sp.Max(overstress + low * slope, 0) + slope * beyond(section.overstress_mean),
        moment_per_slope=beyond(section.overstress_moment),
        area=beyond(section.area),
    )


n = enter("n", "n", ONE, "flow index", "Ostwald 1925", positive=True)
K = enter("K", "K", cast("Dimension", (1, -1, n - 2)), "tensile consistency, in Pa s^n", "Ostwald 1925", positive=True)

# |sigma|^(1/n) has an infinite slope at zero stress if n > 1. Within this many E of zero the rule is linear instead;
# at a thousand times that it is off by less than a millionth. For n = 1 nothing is changed.
SMALL_STRESS = sp.Rational(1, 10**9)


def power_of(stress: sp.Expr) -> sp.Expr:
    """(|stress|/K)^(1/n) sign(stress), with a finite slope where the stress vanishes.

    As s (s^2 + e^2)^((1/n - 1)/2) with s the stress over K: powers of K alone would overflow for small n.
    """
    relative = stress / K
    return relative * (relative**2 + (SMALL_STRESS * E / K) ** 2) ** ((1 / n - 1) / 2)


def power_law_rate() -> sp.Expr:
    """phi(sigma) = (|sigma|/K)^(1/n) sign(sigma)."""
    return power_of(sigma)


def herschel_bulkley_rate() -> sp.Expr:
    """phi(sigma) = (<|sigma| - sigma_Y>/K)^(1/n) sign(sigma)."""
    return sp.sign(sigma) * power_of(sp.Max(sp.Abs(sigma) - sigma_Y, 0))


FLOW_RULES: dict[str, tuple[Flow, Flow]] = {
    LINEAR: (linear_flow(eta), Flow(bingham_rate(), sigma_Y, bingham_means)),
    POWER: (Flow(power_law_rate()), Flow(herschel_bulkley_rate(), sigma_Y)),
}
"""Without a yield stress and with one."""

SYMBOLS = {
    "youngs_modulus": E,
    "second_modulus": E_2,
    "viscosity": eta,
    "yield_stress": sigma_Y,
    "relaxation_time": polymer_chains.relaxation_time,
    "solvent_viscosity": polymer_chains.solvent_viscosity,
    "finite_extensibility": polymer_chains.extensibility,
    "mobility": polymer_chains.mobility,
    "ptt_epsilon": polymer_chains.destruction,
}
"""Symbols of constants by the names of the scene."""
SHARED = (E, eta, sigma_Y)
"""Constants that every filament has."""

CHAINS = {
    "oldroyd-b": polymer_chains.OLDROYD_B,
    "fene-p": polymer_chains.FENE_P,
    "giesekus": polymer_chains.GIESEKUS,
    "ptt": polymer_chains.PTT,
}


def _asinh(size: sp.Expr) -> sp.Expr:
    """By its logarithm, for size >= 0: of a negative one the sum would lose its digits."""
    return sp.log(size + sp.sqrt(size**2 + 1))


OPERATIONS: dict[str, Callable[..., sp.Expr]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "pow": lambda a, b: a**b,
    "neg": lambda a: -a,
    "exp": sp.exp,
    "log": sp.log,
    "sqrt": sp.sqrt,
    "sinh": sp.sinh,
    "cosh": sp.cosh,
    "tanh": sp.tanh,
    "asinh": lambda a: sp.Piecewise((_asinh(a), a >= 0), (-_asinh(-a), True)),
    "atan": sp.atan,
    "sin": sp.sin,
    "cos": sp.cos,
    "abs": sp.Abs,
    "sign": sp.sign,
    "min": sp.Min,
    "max": sp.Max,
}


def expression_of(formula: Formula, symbol_of: Callable[[str], sp.Expr]) -> sp.Expr:
    """The expression of a formula, given what its names stand for.

    Raises
    ------
    ValueError
        If the formula asks for an operation that is not among :data:`OPERATIONS`.
    """
    return formula.fold(_number, symbol_of, _operation)


def custom_law(formula: Formula, *, yields: bool = False) -> Law:
    """The law whose plastic strain rate is a formula in ``sigma`` and parameters.

    Parameters
    ----------
    formula : Formula
        phi(sigma) [1/s], odd and nowhere decreasing; every name in it but ``sigma`` is a constant of the law.
    yields : bool
        Whether it is zero up to a stress, which the law then has as its yield stress. The rule knows its threshold by
        itself: it is the same with yielding and without.
    """
    constants: dict[str, sp.Symbol] = {}

    def named(name: str) -> sp.Expr:
        # The prefix keeps a user's "s" or "eta" apart from the theory's.
        return constants.setdefault(name, sp.Symbol(f"custom_{name}", real=True)) if name != sigma.name else sigma

    flow = Flow(expression_of(formula, named), sigma_Y if yields else sp.S.Zero)
    branch = Branch(flow=flow, flow_beyond_yield=flow if yields else None)
    return Law(
        "custom", branches=(branch,), constants=tuple(Constant(name, symbol) for name, symbol in constants.items())
    )


def _number(value: float) -> sp.Expr:
    """A whole number as it is, so that x^2 stays a product; any other to all its digits."""
    return sp.Integer(int(value)) if float(value).is_integer() else sp.Float(value, 17)


def _operation(name: str, values: Sequence[sp.Expr]) -> sp.Expr:
    if name not in OPERATIONS:
        raise ValueError(f"no operation {name}: there are {', '.join(sorted(OPERATIONS))}")
    return OPERATIONS[name](*values)


def law_of(
    name: str, *, modes: int = 0, formula: Formula | None = None, yields: bool = False, solvent: bool = True
) -> Law:
    """A law by its name.

    Parameters
    ----------
    name : str
        As in the scene.
    modes : int
        How many, for ``multimode-maxwell``.
    formula : Formula or None
        The flow rule of ``custom``.
    yields : bool
        Whether the rule of ``custom`` is zero up to the yield stress.
    solvent : bool
        Whether a viscous solvent is beside polymer chains.

    Raises
    ------
    ValueError
        If there is no such law, or it lacks its modes or its formula.
    """
    if name not in LAWS:
        raise ValueError(f"no law {name}: there are {', '.join(LAWS)}")
    spec = LAWS[name]
    if "modes" in spec.lists:
        return multimode_maxwell(modes)
    if "flow" in spec.lists:
        if formula is None:
            raise ValueError("a custom law is made of a formula")
        return custom_law(formula, yields=yields)
    symbols = SYMBOLS | ({"viscosity": K, "index": n} if spec.has_index else {})
    flow, beyond = _flows_of(spec, symbols)
    branches = [Branch(symbols[modulus]) for modulus in spec.springs]
    branches += [Branch(symbols[modulus], flow, beyond if spec.yields else None) for modulus in spec.flowing]
    own = [Constant(key, symbols[key]) for key in (*spec.constants, "index") if symbols.get(key) not in (None, *SHARED)]
    return Law(
        name,
        branches=tuple(branches),
        viscosity=symbols[spec.viscous_stress] if spec.viscous_stress and (solvent or not spec.has_chains) else None,
        constants=tuple(own),
        chains=CHAINS[name] if spec.has_chains else None,
    )


def _flows_of(spec: LawSpec, symbols: Mapping[str, sp.Symbol]) -> tuple[Flow | None, Flow | None]:
    """The flow rules of a law without its yield stress and with it."""
    if not spec.flow or spec.flow in FLOW_RULES:
        return FLOW_RULES.get(spec.flow, (None, None))
    known = {**symbols, sigma.name: sigma}
    beyond, fluid = (
        Flow(expression_of(parse_formula(text), known.__getitem__), limit)
        for text, limit in ((spec.flow, sigma_Y), (spec.flow_without_yield or spec.flow, sp.S.Zero))
    )
    return fluid, beyond
