"""The equations in force, written out from the very objects that the graph is printed from."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from softcat_sym.physics import hardening_rule, heat, polymer_chains, reissner
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.bulk import sigma_eq
from softcat_sym.physics.constitutive_laws import Flow, plastic_rate
from softcat_sym.physics.densities import outer_force, outer_momentum
from softcat_sym.physics.equation import Mean, Rate, Stated, stated
from softcat_sym.physics.kinematics import F_x, F_y, mass_per_length
from softcat_sym.physics.loads import h0_slope
from softcat_sym.physics.necking import s_slope
from softcat_sym.physics.polymer_chains import ChainResponse
from softcat_sym.physics.reissner import (
    Gam,
    Lam,
    ResolvedSection,
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
from softcat_sym.physics.section_equations import FilamentEquations
from softcat_sym.physics.section_response import CLOSURES, PLANE_STRAIN, A, SectionResponse, h, shrunk, stiffness
from softcat_sym.physics.sections import NONE, Section

Rename = dict[sp.Symbol, sp.Symbol]
Rows = tuple[tuple[sp.Symbol, str, sy.Dimension, str], ...]

_READABLE = 12
"""Operations up to which a mean in closed form is written as such."""


def equations_in_force(equations: FilamentEquations, *, reduced: bool = False) -> tuple[Stated, ...]:
    """Write the equations of a filament out, in the order in which one would derive them.

    Means over the section stay means, and a rule that is rounded at zero stress for the integrator is written without
    the rounding.
    """
    if (resolved := equations.resolved) is not None:
        stress = _stresses_of_fibres(resolved) if equations.chains is None else _chains_of_fibres(equations, resolved)
        section = (*_strains(resolved), *stress, *_flows(equations, resolved), *_resultants(equations, resolved))
    else:
        kinematics = _uniform_stretch if reduced else _kinematics
        section = (*kinematics(equations), *_stresses(equations), *_plastic_rates(equations))
        section = (*section, *_forces(equations, reduced=reduced))
    clocks = (*_histories(equations), *_temperature(equations))
    return (*section, *clocks, *_balance(equations, reduced=reduced), *_gravity(equations))


# Symbols of one of several parts in parallel: the plain one, the LaTeX of its own before the part's number.
_MEANS: Rows = (
    (sy.sigma_0, r"\sigma_0^{{({j})}}", sy.STRESS, "mean stress"),
    (sy.sigma_1, r"\sigma_1^{{({j})}}", sy.STRESS, "bending stress"),
    (sy.a_0, "a_0^{{({j})}}", sy.ONE, "axial plastic strain"),
    (sy.a_1, "a_1^{{({j})}}", sy.ONE, "bending plastic strain"),
)
_FIBRE: Rows = (
    (sy.sigma, r"\sigma^{{({j})}}", sy.STRESS, "stress of a fibre"),
    (tau_f, r"\tau^{{({j})}}", sy.STRESS, "shear stress of a fibre"),
    (eps_p, r"\epsilon^{{p({j})}}", sy.ONE, "axial plastic strain of a fibre"),
    (gamma_p, r"\gamma^{{p({j})}}", sy.ONE, "plastic shear of a fibre"),
    (reissner.eps_e, r"\epsilon^{{e({j})}}", sy.ONE, "axial elastic strain of a fibre"),
    (reissner.gamma_e, r"\gamma^{{e({j})}}", sy.ONE, "elastic shear of a fibre"),
    (reissner.sigma_c, r"\hat\sigma^{{({j})}}", sy.STRESS, "stress conjugate to the axial strain"),
    (reissner.tau_d, r"\tau_d^{{({j})}}", sy.STRESS, "driving shear stress of a fibre"),
)


class _Parts:
    """Springs and a viscous stress in parallel: symbols of each, and the plain ones of an only part."""

    def __init__(self, section: SectionResponse | ResolvedSection, rows: Rows, viscous: str = "") -> None:
        self.springs, self._rows, self._viscous = len(section.branches), rows, viscous
        self.count = self.springs + (section.viscous is not None)

    def symbols(self, number: int) -> Rename:
        """Symbols of one part."""
        j = number + 1
        return {
            symbol: sy.enter(f"{symbol.name}_part{j}", latex.format(j=j), dimension, f"{meaning} of part {j}", "2.8")
            for symbol, latex, dimension, meaning in (self._rows if self.count > 1 else ())
        }

    def stated(self, number: int, name: str, left: sp.Expr, right: sp.Expr, source: str) -> Stated:
        """An equation of one part."""
        new, words = self.symbols(number), f", part {number + 1}" if self.count > 1 else ""
        if words and number == self.springs:
            words = self._viscous or words
        return stated(f"{name}{words}", left.xreplace(new), right.xreplace(new), source)

    def sums(self, *totals: sp.Symbol) -> Iterator[Stated]:
        """What the parts add up to."""
        for total in totals if self.count > 1 else ():
            added = sp.Add(*(total.xreplace(self.symbols(j)) for j in range(self.count)))
            yield stated("sum over the parts in parallel", total, added, "2.8")


def _stresses(equations: FilamentEquations) -> Iterator[Stated]:
    """The stress of every branch, of the viscous stress, and their sum."""
    response, parts = equations.response, _Parts(equations.response, _MEANS, ", viscous")
    if equations.chains is not None:
        solvent = sp.S.Zero if response.viscous is None else response.viscous.stress_mean
        yield from _conformation(equations.chains, axial_strain)
        yield stated("mean stress", sy.sigma_0, chain_stress + solvent, "2.8")
        return
    stretches, bends = equations.terms.stretches, equations.terms.bending
    for j, part in enumerate(response.parts):
        if stretches:
            yield parts.stated(j, "mean stress", sy.sigma_0, part.stress_mean, "2.8, 2.11")
        if bends:
            yield parts.stated(j, "bending stress at zeta = 1", sy.sigma_1, part.stress_bending, "2.8, 2.11")
    yield from parts.sums(*[sy.sigma_0] * stretches, *[sy.sigma_1] * bends)


axial_strain = sy.enter("eps", r"\epsilon", sy.ONE, "axial strain of a fibre", "2.6")
chain_stress = sy.enter("sigma_ch", r"\sigma_{ch}", sy.STRESS, "stress of the polymer chains", "Bird et al. 1987")


def _conformation(chains: ChainResponse, strain: sp.Symbol) -> Iterator[Stated]:
    """The conformation of the chains of a fibre, what it relaxes by, and its stress."""
    words, source = {"along": "along", "across": "across", "width": "in the width of"}, "Bird et al. 1987"
    for one, extension in zip(chains.directions, chains.extensions, strict=True):
        shown = extension.xreplace({polymer_chains.strain: strain})
        yield stated(f"conformation {words[one.name]} a fibre", one.extension, shown, source)
    factor = chains.spring_factor
    if chains.relaxes or factor != 1:
        yield stated("trace of the conformation", polymer_chains.trace, chains.trace, source)
    if factor != 1:
        yield stated("stiffening of the chains", polymer_chains.spring_factor, factor, "Bird et al. 1980")
    plain = {polymer_chains.spring_factor: factor} if factor == 1 else {}
    for one, rate in zip(chains.states, chains.rates, strict=False):
        left = Rate(one.taken, sy.t, 1)
        yield stated(f"relaxation {words[one.name]} a fibre", left, rate.xreplace(plain), source)
    yield stated("stress of the chains", chain_stress, chains.stress.xreplace(plain), source)


def _plastic_rates(equations: FilamentEquations) -> Iterator[Stated]:
    """The flow rule of every branch that flows, and the rates of its plastic states."""
    shape, terms, parts = equations.shape, equations.terms, _Parts(equations.response, _MEANS, ", viscous")
    closed = CLOSURES[equations.closure](equations.strain, shape.contraction if terms.thins else NONE)
    for j, (branch, response) in enumerate(zip(equations.law.branches, equations.response.branches, strict=True)):
        flow, means = branch.flow, response.means
        if means is None:
            continue
        if flow is not None:
            yield parts.stated(j, "flow rule of a fibre", plastic_rate, shown_rate(flow, shape), "2.7, 2.25")
        # A mean in closed form is written as such where one can read it.
        at_once = sp.count_ops(means.rate) <= _READABLE and sp.count_ops(means.bending_rate) <= _READABLE
        if terms.bending and not at_once:
            through = (sy.sigma_0 if terms.stretches else sp.Integer(0)) + sy.sigma_1 * sy.zeta
            yield parts.stated(j, "stress of the fibre zeta", sy.sigma, through, "2.23")
        # Springs without stress that join the others: the plastic strain follows the strain.
        joining = sp.S.Zero if branch.growth is None else branch.growth / stiffness(shape, branch.modulus)
        if terms.stretches:
            # <eps_p_t>, or the rule itself of the only stress there is.
            flowing = sp.S.Zero if flow is None else Mean(plastic_rate)
            if flow is not None and not terms.bending:
                flowing = shown_rate(flow, shape).subs(sy.sigma, sy.sigma_0)
            mean = (flowing + sy.sigma_0 * joining) / closed.recall_mean
            rate = response.rate_mean if at_once else mean
            yield parts.stated(j, "axial flow", Rate(sy.a_0, sy.t, 1), rate, "2.12, 2.24")
        if terms.bending:
            flowing = sp.S.Zero if flow is None else Mean(plastic_rate * sy.zeta) / shape.zeta_squared
            mean = (flowing + sy.sigma_1 * joining) / closed.recall_bending
            rate = response.rate_bending if at_once else mean
            yield parts.stated(j, "bending flow", Rate(sy.a_1, sy.t, 1), rate, "2.12, 2.24")


def shown_rate(flow: Flow, shape: Section) -> sp.Expr:
    """The flow rule of an axial stress.

    In a section too wide to change its width the equivalent stress is sqrt(3)/2 times the axial one, and so is the
    axial rate of the equivalent one.
    """
    rate = plain_rate(flow)
    return PLANE_STRAIN * rate.subs(sy.sigma, PLANE_STRAIN * sy.sigma) if shape.plane_strain else rate


def plain_rate(flow: Flow) -> sp.Expr:
    """The flow rule without the rounding at zero stress, the only place where E stands in it."""
    rate = flow.rate
    if rate.has(sy.E):
        over = {part: sp.Dummy("over", positive=True) for part in rate.atoms(sp.Max)}
        rate = sp.powsimp(sp.simplify(rate.subs(sy.E, 0).xreplace(over)))
        rate = rate.xreplace({stand_in: part for part, stand_in in over.items()})
    return rate


def gradient_term(equations: FilamentEquations) -> sp.Expr:
    """What a neck adds to the axial force; zero if it is not in force."""
    return sp.Integer(0) if equations.neck is None else -Rate(equations.neck.stiffness() * s_slope, sy.X, 1)


def surface_term(equations: FilamentEquations, *, reduced: bool = False) -> sp.Expr:
    """What surface tension adds to the axial force; zero if it is not in force."""
    if equations.surface is None:
        return sp.Integer(0)
    direct, across = (sy.A0 * one.subs(h0_slope, 0) for one in equations.surface.slope_forces())
    uniform = sy.A0 * equations.surface.force()
    return uniform if reduced else uniform + direct - Rate(across, sy.X, 1)


_SOURCE = "Reissner 1972"


def _strains(resolved: ResolvedSection) -> Iterator[Stated]:
    yield stated("stretch along the section's normal", Lam, reissner.director_strains()[0], _SOURCE)
    if resolved.shears:
        yield stated("shear of the section", Gam, reissner.director_strains()[1], _SOURCE)
    else:
        yield stated("sections stay normal to the centreline", sp.Integer(0), reissner.director_strains()[1], "2.5")
    yield stated("bending", k, Rate(psi, sy.X, 1), _SOURCE)
    yield stated("area", A, resolved.cell.area, "2.9")
    yield stated("thickness", h, resolved.relative_thickness * sy.h0, "2.9")


def _stresses_of_fibres(resolved: ResolvedSection) -> Iterator[Stated]:
    kept, parts = 2 if resolved.shears else 1, _Parts(resolved, _FIBRE)
    yield stated("strain of a fibre", reissner.eps, resolved.cell.axial_strain, "2.6")
    if resolved.shears:
        yield stated("shear strain of a fibre", reissner.gamma, resolved.cell.shear_strain, _SOURCE)
    conjugate = (reissner.sigma_c, tau_f) if resolved.shears else (sy.sigma,)
    names, elastic = ("axial", "shear")[:kept], (reissner.eps_e, reissner.gamma_e)
    for j, branch in enumerate(resolved.branches):
        # A spring by itself has no plastic state.
        rest = {} if branch.flow is not None else {eps_p: sp.Integer(0), gamma_p: sp.Integer(0)}
        spring = branch.spring
        for name, symbol, strain in zip(("strain", "shear")[:kept], elastic, spring.elastic, strict=False):
            yield parts.stated(j, f"elastic {name} of a fibre", symbol, strain.xreplace(rest), "THEORY 12a")
        for name, symbol, value in zip(names, (sy.sigma, tau_f), spring.stress, strict=False):
            yield parts.stated(j, f"{name} stress of a fibre", symbol, value, "2.8")
        if resolved.shears:
            along = spring.conjugate.xreplace({reissner.tau_d: spring.driving[0]}).xreplace(rest)
            yield parts.stated(j, "conjugate stress of a fibre", conjugate[0], along, "THEORY 12a")
    if resolved.viscous is not None:
        for name, symbol, value in zip(names, conjugate, _viscous_stress(resolved), strict=False):
            yield parts.stated(len(resolved.branches), f"viscous {name} stress of a fibre", symbol, value, "2.8")
    yield from parts.sums(*conjugate)


def _viscous_stress(resolved: ResolvedSection) -> list[sp.Expr]:
    """What the Rayleigh potential of a fibre derives to, axially and in shear."""
    potential = sp.S.Zero if resolved.viscous is None else resolved.viscous.rayleigh
    moving = {reissner.eps_t: Rate(reissner.eps, sy.t, 1), reissner.gamma_t: Rate(reissner.gamma, sy.t, 1)}
    return [sp.diff(potential, rate).xreplace(moving) for rate in moving]


def _chains_of_fibres(equations: FilamentEquations, resolved: ResolvedSection) -> Iterator[Stated]:
    yield stated("strain of a fibre", reissner.eps, resolved.cell.axial_strain - resolved.relaxed, "2.6")
    if equations.chains is not None:
        yield from _conformation(equations.chains, reissner.eps)
    yield stated("stress of a fibre", sy.sigma, chain_stress + _viscous_stress(resolved)[0], "2.8")


def _flows(equations: FilamentEquations, resolved: ResolvedSection) -> Iterator[Stated]:
    parts, carry = _Parts(resolved, _FIBRE), resolved.cell.carry
    share = PLANE_STRAIN**2 if equations.shape.plane_strain else sp.S.One
    # The rates of the section with the rule as one symbol, which is written by itself.
    flow = reissner.fibre_flow(plastic_rate, share, carry, resolved.kinds)
    for j, branch in enumerate(equations.law.branches):
        if not branch.has_state:
            continue
        if resolved.shears:
            drive = resolved.branches[j].spring.driving[0]
            yield parts.stated(j, "driving shear stress", reissner.tau_d, drive, "THEORY 12a")
        total = flow if branch.flow is not None else reissner.still(resolved.kinds)
        if branch.flow is not None and equations.terms.hardens:
            total, hardening = reissner.hardened(flow, share, carry)
            symbols = hardening_rule.axial_stress, hardening_rule.shear_stress
            chi = dict(zip(hardening_rule.back_stress(share), symbols, strict=True))
            total = total.subs(chi)
            names = (("backstress", "back strain"), ("shear backstress", "back strain in shear"))[: 1 + resolved.shears]
            for (name, _), (value, symbol) in zip(names, chi.items(), strict=False):
                yield parts.stated(j, f"{name} of a fibre", symbol, value, hardening_rule.SOURCE)
            strains = (hardening_rule.axial, hardening_rule.shear)
            for (_, name), strain, rate in zip(names, strains, hardening.rates, strict=False):
                left, right = Rate(strain, sy.t, 1), rate.xreplace(chi)
                yield parts.stated(j, f"{name} of a fibre", left, right, hardening_rule.SOURCE)
        if branch.flow is not None:
            yield parts.stated(j, "equivalent stress", sigma_eq, total.equivalent, "3.5")
            rule = plain_rate(branch.flow).subs(sy.sigma, sigma_eq)
            yield parts.stated(j, "flow rule", plastic_rate, rule, "2.7, 2.25")
        if branch.growth is not None:
            total = reissner.growing(total, branch.growth, carry, resolved.kinds)
        yield parts.stated(j, "axial flow of a fibre", Rate(eps_p, sy.t, 1), total.axial_rate, "3.7")
        if resolved.shears:
            yield parts.stated(j, "plastic shear of a fibre", Rate(gamma_p, sy.t, 1), total.shear_rate[0], "3.7")


def _resultants(equations: FilamentEquations, resolved: ResolvedSection) -> Iterator[Stated]:
    cell = resolved.cell
    along = reissner.sigma_c if resolved.shears else sy.sigma
    means = {sigma_mean: Mean(along), sigma_zeta: Mean(along * sy.zeta), tau_mean: Mean(tau_f)}
    yield stated("tension", sy.T, cell.tension.xreplace(means), "2.10")
    yield stated("bending moment", sy.M, cell.moment.xreplace(means), "2.10")
    if resolved.shears:
        yield stated("shear force", S, cell.shear_force.xreplace(means), _SOURCE)
    along = cell.normal_force if resolved.shears else cell.normal_force.subs(Gam, 0)
    pull = surface_term(equations)
    stretch = sy.s if pull and resolved.shears else Lam
    gain = gradient_term(equations).subs(sy.s, stretch)
    outward, aside = (pull * Lam / sy.s, pull * Gam / sy.s) if resolved.shears else (pull.subs(sy.s, Lam), sp.S.Zero)
    source = "THEORY 4; Audoly & Hutchinson 2016" if gain else "THEORY 4"
    source += "; Eggers & Dupont 1994" if pull else ""
    if aside:
        yield stated("stretch of the centreline", sy.s, sp.sqrt(Lam**2 + Gam**2), _SOURCE)
    yield stated("force along the section's normal", n_1, along + gain + outward, source)
    if equations.neck is not None or pull:
        yield stated("change of the stretch", s_slope, Rate(stretch, sy.X, 1), "Audoly & Hutchinson 2016")
    if resolved.shears:
        yield stated("force along the section", n_2, cell.section_force + aside, _SOURCE)
    yield stated("couple", m_c, cell.couple, _SOURCE)
    yield stated("internal force, horizontal", F_x, cell.force[0], _SOURCE)
    yield stated("internal force, vertical", F_y, cell.force[1], _SOURCE)
    turning = resolved.rotary_inertia * Rate(psi, sy.t, 2) if equations.terms.rotary_inertia else sp.Integer(0)
    moments = cell.turning_moment if resolved.shears else cell.turning_moment.subs(Gam, 0)
    yield stated("balance of moments", turning, Rate(m_c, sy.X, 1) + moments, _SOURCE)


progress = sy.enter("v_on", "v", sy.ONE, "how far gravity is switched on, in time", "section 3")


A0_t = sy.enter(
    "A0_t", r"A_0^n", sy.AREA, "area of the section that has shrunk, where it is not stretched", "isotropic"
)
h0_t = sy.enter("h0_t", r"h_0^n", sy.LENGTH, "thickness of the section that has shrunk, likewise", "isotropic")


def _histories(equations: FilamentEquations) -> Iterator[Stated]:
    """What clocks put in the place of constants, their numbers as symbols: of a table its times, values and slopes."""
    for clock in equations.clocks:
        if clock.state is not None:
            yield stated(f"{clock.name}: of a fibre", clock.state.shown, clock.state.value, "as the scene states it")
            yield stated(f"{clock.name}: its rate", Rate(clock.state.shown, sy.t, 1), clock.state.rate, "Moore 1959")
        for symbol, value in clock.replaces:
            if value != 0:
                yield stated(f"{clock.name}: {sy.entry(symbol).meaning}", symbol, value, "as the scene states it")
    if equations.terms.shrinks:
        area, thickness = shrunk(equations.shape)
        yield stated("natural-strain: area without stress", A0_t, sy.A0 * area, "isotropic")
        yield stated("natural-strain: thickness without stress", h0_t, sy.h0 * thickness, "isotropic")


def _kinematics(equations: FilamentEquations) -> Iterator[Stated]:
    terms = equations.terms
    if terms.stretches:
        yield stated("stretch of the centreline", sy.s, equations.centreline.stretch, equations.centreline.source)
    if terms.bending:
        angle = equations.centreline.turning.subs({sy.x_X_before: 1, sy.y_X_before: 0})
        yield stated("angle of the tangent", sy.theta, angle, equations.centreline.source)
        yield stated("turning", sy.theta_X, Rate(sy.theta, sy.X, 1), equations.centreline.source)
    contraction = equations.shape.contraction if terms.thins else NONE
    lever = CLOSURES[equations.closure](equations.strain, contraction).lever
    along = equations.strain.strain if terms.stretches else sp.Integer(0)
    across = lever * sy.theta_X * sy.zeta if terms.bending else sp.Integer(0)
    yield stated("axial strain of the fibre zeta = 2z/h", axial_strain, along - across, equations.strain.source)
    if terms.thins:
        yield stated("area", A, equations.response.area, contraction.source)
        if terms.bending:
            yield stated("thickness", h, equations.response.thickness, contraction.source)


def _uniform_stretch(equations: FilamentEquations) -> Iterator[Stated]:
    elongation = equations.centreline.stretch.subs(sy.x_X, 1) - 1
    if equations.terms.stretches:
        mean = sp.Integral(elongation, (sy.X, -sy.L_0 / 2, sy.L_0 / 2)) / sy.L_0
        yield stated("stretch, the same everywhere", sy.s, 1 + mean, "2.13, 2.17")
    if equations.terms.bending:
        yield stated("turning", sy.theta_X, Rate(sy.y, sy.X, 2), "2.13")


def _forces(equations: FilamentEquations, *, reduced: bool) -> Iterator[Stated]:
    terms, response = equations.terms, equations.response
    if terms.stretches:
        yield stated("tension", sy.T, response.tension, "2.10")
    if terms.bending:
        yield stated("bending moment", sy.M, response.moment, "2.10")
    if terms.stretches:
        gain, pull = gradient_term(equations), surface_term(equations, reduced=reduced)
        source = "THEORY 4" if response.axial_correction != 0 else "2.4"
        source += "; Audoly & Hutchinson 2016" if gain else ""
        source += "; Eggers & Dupont 1994" if pull else ""
        yield stated(
            "axial force, conjugate to the stretch", sy.Q, sy.T + response.axial_correction + gain + pull, source
        )
        if gain or (pull and not reduced):
            yield stated("change of the stretch", s_slope, Rate(sy.s, sy.X, 1), "Audoly & Hutchinson 2016")
    if terms.bending:
        yield stated("change of the moment", sy.M_X, Rate(sy.M, sy.X, 1), "2.3")


def _balance(equations: FilamentEquations, *, reduced: bool) -> Iterator[Stated]:
    terms, force = equations.terms, equations.force
    along = terms.stretches and not reduced
    if equations.resolved is None:
        if along:
            yield stated("internal force, horizontal", F_x, force.horizontal, "2.4, corrected")
        upwards = force.vertical.subs(sy.Q, sy.T + surface_term(equations, reduced=True)) if reduced else force.vertical
        yield stated("internal force, vertical", F_y, upwards, "2.14" if reduced else "2.4, corrected")
    mass, source = mass_per_length(), "2.14" if reduced else "2.1, 2.2"
    if not terms.inertia:
        mass = sp.Integer(0)
    densities = equations.densities if along else [one.level for one in equations.densities]
    outer, inner = outer_force(densities, equations.centreline.stretch)
    carried = [Rate(one, sy.t, 1) if one else one for one in outer_momentum(densities, equations.centreline.stretch)]
    if equations.densities:
        source += f"; {', '.join(one.name for one in equations.densities)}"
    if along:
        pulled = Rate(F_x + inner[0], sy.X, 1) + outer[0]
        yield stated("balance of momentum, horizontal", mass * Rate(sy.x, sy.t, 2) + carried[0], pulled, source)
    falling = sy.rho * sy.A0 * (sy.g_t if _changes(equations) else equations.load)
    held = Rate(F_y + inner[1], sy.X, 1) + outer[1] - falling
    yield stated("balance of momentum, vertical", mass * Rate(sy.y, sy.t, 2) + carried[1], held, source)
    if along:
        yield stated("tangent, horizontal", sy.x_X, Rate(sy.x, sy.X, 1), "2.5")
    yield stated("tangent, vertical", sy.y_X, Rate(sy.y, sy.X, 1), "2.5")


def _gravity(equations: FilamentEquations) -> Iterator[Stated]:
    if not _changes(equations):
        return
    terms = equations.terms
    names = {"switched on smoothly": terms.ramped, "shaken": terms.shaken}
    sources = {"section 3": terms.ramped, "Rayleigh 1877": terms.shaken}
    how, source = ([what for what, there in found.items() if there] for found in (names, sources))
    shares = {part for part in equations.gravity.atoms(sp.Min) if part.has(sy.t)}
    load = equations.load.subs(dict.fromkeys(shares, progress))
    yield stated(f"gravity, {' and '.join(how)}", sy.g_t, load, "; ".join(source))
    for share in shares:
        yield stated("time of switching on", progress, share, "section 3")


def _temperature(equations: FilamentEquations) -> Iterator[Stated]:
    """The balance of heat of a filament that has a temperature, and what the temperature makes of the material."""
    law = equations.heat
    if law is None:
        return
    for symbol, value in law.factors:
        row = sy.entry(symbol)
        given = sy.enter(
            f"{symbol.name}_stated", f"{row.latex}_{{r}}", row.dimension, f"{row.meaning}, as stated", "Ferry 1980"
        )
        factor = heat.viscosity_factor if value == law.viscosity else heat.modulus_factor
        yield stated(f"{row.meaning}, at its temperature", symbol, given * factor, "Ferry 1980")
    if law.viscosity != 1:
        yield stated("viscosity over the stated one", heat.viscosity_factor, law.viscosity, "Fulcher 1925; Ferry 1980")
    gained = heat.heat_source
    if law.stiffens:
        gained -= Rate(heat.stored, heat.temperature, 1) * Rate(heat.temperature, sy.t, 1)
    if law.expands:
        yield stated("natural strain", sy.n_0, law.strain, "Timoshenko 1925")
    around = heat.around if law.partial else heat.ambient
    if law.coefficient != 0:
        gained -= heat.transfer * sy.A0 * equations.exchange * (heat.temperature - around)
    if law.conducts:
        through = heat.conductivity * equations.response.area / sy.s * Rate(heat.temperature, sy.X, 1)
        gained += Rate(through, sy.X, 1)
    held = sy.rho * heat.heat_capacity * sy.A0 * Rate(heat.temperature, sy.t, 1)
    yield stated("balance of heat", held, gained, "Incropera 2007")
    if law.partial:
        place = sy.X + sy.L_0 / 2
        within = sp.Piecewise((heat.ambient, (place >= heat.begin) & (place <= heat.end)), (heat.outside, True))
        yield stated("temperature around a place", heat.around, within, "ASTM C338")
    if law.coefficient not in (0, heat.transfer):
        coefficient = law.coefficient if equations.terms.thins else law.thick().coefficient
        shown = coefficient.subs(heat.around, around).evalf(4)
        yield stated("coefficient of a cylinder in air", heat.transfer, shown, "Churchill & Chu 1975")


def _changes(equations: FilamentEquations) -> bool:
    return bool(equations.load.has(sy.t))
