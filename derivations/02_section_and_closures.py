# ---
# jupyter:
#   jupytext:
#     formats: py:percent
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 2. The section, and two closures for its plastic state: (2.6)–(2.12), (2.23)–(2.27), (A1)–(A2)
#
# Balance (notebook 1) asks each section for two numbers, an axial force and a moment. Here the section answers, from
# the stress in its fibres. The paper closes the equations with the plastic stretch $P$ and bend $C$. We prove its
# formulas, show what they lose once the filament has stretched, and derive the closure that loses nothing.
#
# $s$ stands for $s_X$. Means over the section are $\langle f\rangle = \int_{-1}^1 f(\zeta)\,w(\zeta)\,d\zeta$, where
# $\zeta = 2z/h$.
#
# Effects derived here: `extensibility` (`kinematics.internal_force`), `finite-stretch` (`kinematics.TRUE_STRAIN`),
# `thinning` (`sections.UNIFORM`, `sections.WIDE`), `yielding` (`constitutive_laws.bingham_rate`,
# `constitutive_laws.bingham_means`).

# %%
from collections.abc import Sequence
from dataclasses import replace

import sympy as sp
from proving import Erratum, prove_equal, record_errata

from softcat_sym.physics import constitutive_laws, kinematics, section_equations, sections
from softcat_sym.physics import section_response as closures
from softcat_sym.physics.bulk import nu
from softcat_sym.physics.section_response import PLANE_STRAIN, SectionResponse
from softcat_sym.physics.sections import CIRCLE, NONE, RECTANGLE, SHEET, UNIFORM, WIDE, scaled
from softcat_sym.physics.symbols import (
    A0,
    M_X,
    E,
    L,
    M,
    Q,
    T,
    X,
    a_0,
    a_1,
    c,
    eta,
    h0,
    s,
    s_t,
    sigma,
    sigma_0,
    sigma_1,
    sigma_Y,
    t,
    theta_X,
    theta_Xt,
    x_X,
    y_X,
    z,
    zeta,
)
from softcat_sym.physics.terms import Rheology, Terms

# %% [markdown]
# ## Strain of a fibre: (2.6)
#
# A fibre at the distance $z$ from the centreline runs along $\mathbf r + z\mathbf n$. With $\mathbf r_X = s\mathbf t$
# and $\mathbf n_X = -\theta_X\mathbf t$ its length per unit $X$ is $s - z\theta_X$. The true strain is the logarithm,
# to first order in the thickness:
# $$\epsilon = \log(s - z\theta_X) = \log s - \frac{\theta_X}{s}z + O(z^2) = \log s - \theta_s z .$$

# %%
angle = sp.Function("angle", real=True)(X)
tangent = sp.Matrix([sp.cos(angle), sp.sin(angle)])
normal = sp.Matrix([-sp.sin(angle), sp.cos(angle)])
along_fibre = s * tangent + z * normal.diff(X)
length = sp.simplify(along_fibre.dot(tangent)).subs(angle.diff(X), theta_X)
prove_equal(along_fibre.dot(normal), 0)
prove_equal(length, s - z * theta_X)
true_strain = sp.log(length).subs(z, 0) + z * sp.diff(sp.log(length), z).subs(z, 0)
prove_equal(true_strain, sp.log(s) - theta_X / s * z)
prove_equal(kinematics.TRUE_STRAIN.strain - theta_X / kinematics.TRUE_STRAIN.arc_stretch * z, true_strain)
for shrinking in (UNIFORM, WIDE):
    lever = closures.material(kinematics.TRUE_STRAIN, shrinking).lever
    prove_equal(true_strain.subs(z, shrinking.thickness * zeta / 2), sp.log(s) - lever * theta_X * zeta)

# %% [markdown]
# The paper prints $\epsilon = \log s - \theta_X z$. Its bending strain is too large by $(s-1)$ of itself: a fifth at
# twenty per cent stretch.

# %%
PRINTED_STRAIN = sp.log(s) - theta_X * z
excess = (PRINTED_STRAIN - true_strain) / (-theta_X / s * z)
prove_equal(excess, s - 1)
assert excess.subs(s, sp.Rational(6, 5)) == sp.Rational(1, 5)

# %% [markdown]
# The printed form also remembers where the filament began. Take the filament when it has been stretched by $s_1$ as
# a new reference, $X' = s_1X$: then $s = s_1s'$, $\theta_X = s_1\theta_{X'}$. A fluid must not care. The strain
# *added* since is the same in either reference for $\theta_sz$, not for $\theta_Xz$.

# %%
s_1, s_new, turning_new = sp.symbols("s_1 s' theta_X'", positive=True)
renamed = {s: s_1 * s_new, theta_X: s_1 * turning_new}
anew = {s: s_new, theta_X: turning_new}
prove_equal((true_strain.subs(renamed, simultaneous=True) - true_strain.subs(anew)).diff(turning_new), 0)
assert sp.simplify((PRINTED_STRAIN.subs(renamed) - PRINTED_STRAIN.subs(anew)).diff(turning_new))
prove_equal(kinematics.SMALL_STRAIN.strain, sp.series(sp.log(s), s, 1, 2).removeO())
assert kinematics.SMALL_STRAIN.arc_stretch == 1

# %% [markdown]
# ## The section as it shrinks: (2.9)
#
# Volume is kept, $As = A_0$. A filament shrinks alike in both directions; a sheet, whose width $D$ is held, in its
# thickness alone.

# %%
h, D, D_0 = sp.symbols("h D D_0", positive=True)
A_0 = h0 * D_0
volume = sp.Eq(h * D * s, A_0)
both_ways = sp.solve(volume.subs(D, D_0 * h / h0), h)
width_held = sp.solve(volume.subs(D, D_0), h)
for found, held, inertia_power in ((both_ways, UNIFORM, 2), (width_held, WIDE, 3)):
    thickness = next(root for root in found if root.is_positive)
    prove_equal(thickness, held.thickness)
    prove_equal(A0 / s, held.area)
    inertia = held.area * (held.thickness / 2) ** 2
    prove_equal(inertia, inertia.subs(s, 1) / s**inertia_power)
assert (NONE.area, NONE.thickness) == (A0, h0)

# %% [markdown]
# The weight is the relative width: one half for rectangle and sheet; for a circle the chord $2\sqrt{(h/2)^2 - z^2}$
# times $dz$ over the area $\pi h^2/4$. Moments of the weight by integration (for a circle with $\zeta = \cos\varphi$):

# %%
phi = sp.Symbol("varphi", positive=True)
chord = 2 * sp.sqrt((h / 2) ** 2 - z**2) * (h / 2) / (sp.pi * h**2 / 4)
prove_equal(sp.simplify(chord.subs(z, h * zeta / 2)), CIRCLE.weight)
assert RECTANGLE.weight == SHEET.weight == sp.Rational(1, 2)
ROUND = 2 / sp.pi * sp.sin(phi) ** 2


def moment_of_weight(shape: sections.Section, power: int) -> sp.Expr:
    """<zeta^n>."""
    if shape is CIRCLE:
        return sp.integrate(sp.expand(sp.cos(phi) ** power) * ROUND, (phi, 0, sp.pi))
    return sp.integrate(zeta**power / 2, (zeta, -1, 1))


MOMENTS = {shape.name: [moment_of_weight(shape, power) for power in range(9)] for shape in (RECTANGLE, SHEET, CIRCLE)}


def mean(shape: sections.Section, polynomial: sp.Expr) -> sp.Expr:
    """<f> of a polynomial in zeta."""
    terms = sp.Poly(polynomial, zeta).terms()
    return sp.Add(*(coefficient * MOMENTS[shape.name][power] for (power,), coefficient in terms))


SHAPES = (RECTANGLE, SHEET, CIRCLE)
for shape in SHAPES:
    assert MOMENTS[shape.name][0] == 1
    assert MOMENTS[shape.name][1] == 0
    prove_equal(MOMENTS[shape.name][2], shape.zeta_squared)
# I = A (h/2)^2 <zeta^2> is D h^3/12 and pi h^4/64.
prove_equal(h * D * (h / 2) ** 2 * RECTANGLE.zeta_squared, D * h**3 / 12)
prove_equal(sp.pi * h**2 / 4 * (h / 2) ** 2 * CIRCLE.zeta_squared, sp.pi * h**4 / 64)
prove_equal(UNIFORM.area * (UNIFORM.thickness / 2) ** 2 * RECTANGLE.zeta_squared, A0 * h0**2 / (12 * s**2))

# %% [markdown]
# ## Tension and moment: (2.10), (2.11), (2.23)
#
# For *any* plastic strain — here a quartic with arbitrary coefficients — the printed strain gives (2.11), with
# $P = \int_A\epsilon^p\,da$ and $C = \int_A\epsilon^pz\,da$. A stress $\sigma_0 + \sigma_1\zeta$ gives (2.23).

# %%
A, I_z = closures.A, sp.Symbol("I_z", positive=True)
P, C = sp.symbols("P C", real=True)
TENSION, MOMENT = E * (A * sp.log(s) - P), -E * (I_z * theta_X + C)  # (2.11)
STRESS_FIELD = T / A + M / I_z * z  # (2.23)
plastic = sum(b * zeta**n for n, b in enumerate(sp.symbols("e_0:5", real=True)))
for shape in (RECTANGLE, CIRCLE):
    area_, inertia_ = A, A * (h / 2) ** 2 * shape.zeta_squared
    stress = E * (PRINTED_STRAIN.subs(z, h * zeta / 2) - plastic)
    P_, C_ = area_ * mean(shape, plastic), area_ * h / 2 * mean(shape, plastic * zeta)
    letters = {P: P_, C: C_, I_z: inertia_}
    prove_equal(area_ * mean(shape, stress), TENSION.subs(letters))
    prove_equal(area_ * h / 2 * mean(shape, stress * zeta), MOMENT.subs(letters))
    linear = sigma_0 + sigma_1 * zeta
    tension, moment = area_ * mean(shape, linear), area_ * h / 2 * mean(shape, linear * zeta)
    prove_equal(tension, area_ * sigma_0)
    prove_equal(moment, inertia_ * (sigma_1 / (h / 2)))
    prove_equal(STRESS_FIELD.subs({T: tension, M: moment, I_z: inertia_, z: h * zeta / 2}), linear)

# %% [markdown]
# ## The Maxwell fluid: (2.7), (2.8), (2.12)

# %%
assert constitutive_laws.maxwell_rate() == sigma / eta
for shape in SHAPES:
    flow = constitutive_laws.maxwell_rate().subs(sigma, linear)
    means = constitutive_laws.maxwell_means(shape)
    prove_equal(mean(shape, flow), means.rate)
    prove_equal(mean(shape, flow * zeta) / mean(shape, zeta**2), means.bending_rate)
    assert means.yielded_fraction == 1
    assert means.largest_rate == (abs(sigma_0) + abs(sigma_1)) / eta
prove_equal(A * mean(RECTANGLE, flow), A * sigma_0 / eta)
moment = A * h / 2 * mean(CIRCLE, linear * zeta)
prove_equal(A * h / 2 * mean(CIRCLE, flow * zeta), moment / eta)

# %% [markdown]
# ## Yielding: (2.25)–(2.27)
#
# Where a formula has `Max`, `Min`, `Abs`, `sign` or branches, we prove it region by region. A region is a set of
# stresses in which no comparison changes its outcome; one sample point tells which branch holds, and the branch is
# then compared symbolically.


# %%
def settle(expression: sp.Basic, sample: dict[sp.Symbol, sp.Rational]) -> sp.Basic:
    """Replace every comparison by the outcome it has at the sample point."""
    if not expression.args:
        return expression
    if isinstance(expression, sp.Piecewise):
        chosen = next(branch for branch, condition in expression.args if condition.subs(sample) == sp.true)
        return settle(chosen, sample)
    arguments = [settle(argument, sample) for argument in expression.args]
    values = [argument.subs(sample) for argument in arguments]
    if isinstance(expression, sp.Max):
        return arguments[values.index(max(values))]
    if isinstance(expression, sp.Min):
        return arguments[values.index(min(values))]
    if isinstance(expression, sp.Abs | sp.sign | sp.Heaviside) and values[0].is_comparable:
        sign = sp.sign(values[0])
        return {sp.Abs: sign * arguments[0], sp.sign: sign, sp.Heaviside: (1 + sign) / 2}[expression.func]
    return expression.func(*arguments)


at_unit = {sigma_Y: sp.Integer(1), eta: sp.Integer(1), E: sp.Integer(1)}
for stress_, derived in (
    (2, (sigma - sigma_Y) / eta),
    (sp.Rational(1, 2), 0),
    (-sp.Rational(1, 2), 0),
    (-2, (sigma + sigma_Y) / eta),
):
    sample = at_unit | {sigma: sp.sympify(stress_)}
    prove_equal(derived, settle(constitutive_laws.bingham_rate(), sample))
    printed_rate = (sigma - sp.sign(sigma) * sigma_Y) * sp.Heaviside(sp.Abs(sigma) - sigma_Y) / eta  # (2.25)
    prove_equal(derived, settle(printed_rate, sample))

# %% [markdown]
# ### The paper's formulas, by integration
#
# The filament yields in $-h/2 < z < z_L$ and $z_H < z < h/2$. At the top the stress has the sign of $hT + 6M$; call
# it $p$. At the bottom it has that of $hT - 6M$, minus the sign printed; call the printed one $q$. Integrate
# $(\sigma - \operatorname{sign}(\sigma)\sigma_Y)/\eta$ over both zones. (2.26) and (2.27) are right.

# %%
p, q = sp.symbols("p q", real=True)
h = closures.h
D = sp.Symbol("D", positive=True)
z_L, z_H = sp.symbols("z_L z_H", real=True)
stress = STRESS_FIELD.subs({A: h * D, I_z: h**3 * D / 12})
prove_equal(sp.simplify(stress.subs(z, h / 2) * D * h**2), h * T + 6 * M)
prove_equal(sp.simplify(stress.subs(z, -h / 2) * D * h**2), h * T - 6 * M)


def yielded(weight: sp.Expr) -> sp.Expr:
    """Integral of the flow rule times the weight over both yielded zones."""
    top = sp.integrate(sp.expand((stress - p * sigma_Y) * weight), (z, z_H, h / 2))
    bottom = sp.integrate(sp.expand((stress + q * sigma_Y) * weight), (z, -h / 2, z_L))
    return D * (top + bottom) / eta


top, bottom = sp.sign(6 * M + h * T), sp.sign(6 * M - h * T)
PLASTIC_STRETCH_RATE = (  # (2.26)
    (1 + (z_L - z_H) / h) * T
    + 6 * M * (z_L**2 - z_H**2) / h**3
    + (z_H - h / 2) * D * sigma_Y * top
    + (z_L + h / 2) * D * sigma_Y * bottom
) / eta
PLASTIC_BEND_RATE = (  # (2.27)
    (1 - 4 * (z_H**3 - z_L**3) / h**3) * M
    + T * (z_L**2 - z_H**2) / (2 * h)
    + (z_H**2 / 2 - h**2 / 8) * D * sigma_Y * top
    + (z_L**2 / 2 - h**2 / 8) * D * sigma_Y * bottom
) / eta
signs = {top: p, bottom: q}
prove_equal(sp.expand(yielded(sp.Integer(1))), sp.expand(PLASTIC_STRETCH_RATE.subs(signs)))
prove_equal(sp.expand(yielded(z)), sp.expand(PLASTIC_BEND_RATE.subs(signs)))

# %% [markdown]
# ### Partial moments of the section
#
# The solver writes the same means through $K_n(c) = \int_c^1(\zeta - c)\,\zeta^n\,w\,d\zeta$: free of the differences
# of cubes in (2.27), and of its $0/0$ where the moment vanishes. Rectangle directly, circle with
# $\zeta = \cos\varphi$.

# %%
edge = sp.Symbol("varphi_c", positive=True)
to_angle = [(sp.acos(c), edge), (sp.sqrt(1 - c**2), sp.sin(edge)), (c, sp.cos(edge))]
for shape in SHAPES:
    held_moments = (shape.area, shape.overstress_mean, shape.overstress_moment)
    for weight, held in zip((1, zeta - c, (zeta - c) * zeta), held_moments, strict=True):
        if shape is CIRCLE:
            integrand = sp.sympify(weight).subs({zeta: sp.cos(phi), c: sp.cos(edge)}) * ROUND
            derived = sp.integrate(sp.expand(integrand), (phi, 0, edge))
            held = held.subs(to_angle)
        else:
            derived = sp.integrate(sp.expand(sp.sympify(weight) / 2), (zeta, c, 1))
        prove_equal(derived, held)
    assert all(abs(abs(end) - 1) <= sp.Rational(1, 10**12) for end in shape.interval)

# %% [markdown]
# ### Every sign case
#
# In the code the stress enters only through $\sigma_0\mp\sigma_Y$ and $|\sigma_1|$; each side of yield (tension,
# compression) may hold nowhere, in part, or throughout. Of the nine pairs three are impossible, because a section
# that flows throughout in tension has no fibre in compression beyond yield, and the reverse. Six remain, for either
# sign of $\sigma_1$: twelve regions, each with a sample point.

# %%
REGIONS = [
    (mean_ * (-1 if upside_down else 1), slope_ * turn)
    for upside_down in (False, True)
    for turn in (1, -1)
    for mean_, slope_ in (
        (sp.Rational(1, 2), sp.Rational(2, 3)),  # one side, in part
        (sp.Rational(3), sp.Rational(1, 2)),  # right through
        (sp.Rational(1, 5), sp.Rational(3)),  # both sides
        (sp.Rational(1, 5), sp.Rational(1, 3)),  # nowhere
    )
]


def zone(sign: int, at: dict[sp.Symbol, sp.Rational]) -> str:
    """Where the fibres beyond yield of one sign are: nowhere, throughout, at the top or at the bottom."""
    ends = [sign * (at[sigma_0] + at[sigma_1] * end) > 1 for end in (1, -1)]
    return {(False, False): "nowhere", (True, True): "throughout", (True, False): "top", (False, True): "bottom"}[
        tuple(ends)
    ]


seen = set()
for mean_, slope_ in REGIONS:
    at = {sigma_0: mean_, sigma_1: slope_}
    seen.add((zone(1, at), zone(-1, at), slope_ > 0))
assert len(seen) == 12

# %% [markdown]
# **Rectangle, literally against (2.26), (2.27).** The edges of the zones follow from $\sigma = \pm\sigma_Y$. A
# section that has yielded right through has $z_L = z_H$, *any* common value: it stays a free symbol below, and drops
# out.

# %%
anywhere = sp.Symbol("z_0", real=True)
means = constitutive_laws.bingham_means(RECTANGLE)
for mean_, slope_ in REGIONS:
    sample = at_unit | {sigma_0: mean_, sigma_1: slope_}
    where = {zone(sign, sample): sign for sign in (1, -1)}
    top = h / 2 * (where["top"] * sigma_Y - sigma_0) / sigma_1 if "top" in where else h / 2
    bottom = h / 2 * (where["bottom"] * sigma_Y - sigma_0) / sigma_1 if "bottom" in where else -h / 2
    if "throughout" in where:
        top = bottom = anywhere
    letters = {z_H: top, z_L: bottom, T: h * D * sigma_0, M: D * h**2 / 6 * sigma_1}
    full_sample = sample | {h: sp.Integer(1), D: sp.Integer(1), anywhere: sp.Rational(1, 7)}
    P_t, C_t = (settle(rate.subs(letters), full_sample) for rate in (PLASTIC_STRETCH_RATE, PLASTIC_BEND_RATE))
    prove_equal(sp.cancel(P_t / (h * D)), settle(means.rate, sample))
    bending = C_t / (h * D * h / 2) / RECTANGLE.zeta_squared
    prove_equal(sp.cancel(bending), settle(means.bending_rate, sample))
    prove_equal((bottom + h / 2 + h / 2 - top) / h, settle(means.yielded_fraction, sample))
    ends = [settle(constitutive_laws.bingham_rate().subs(sigma, sigma_0 + sigma_1 * k), sample) for k in (1, -1)]
    largest = max((abs(end.subs(sample)), n) for n, end in enumerate(ends))[1]
    prove_equal(ends[largest] ** 2, settle(means.largest_rate, sample) ** 2)

# %% [markdown]
# **Circle, by integration.** The edges are $\zeta = \cos\varphi_H$ and $\cos\varphi_L$; $\sigma_0$ and, if both sides
# yield, $\sigma_1$ are expressed by them.

# %%
phi_H, phi_L = sp.symbols("varphi_H varphi_L", positive=True)


# Integrals of w, zeta w, zeta^2 w from 0 to varphi.
PARTIAL = [sp.expand(sp.integrate(sp.cos(phi) ** n * ROUND, phi)) for n in range(3)]


def over_zone(where: str, antiderivative: sp.Expr) -> sp.Expr:
    """Integral over one yielded zone of a circle."""
    start, end = {"nowhere": (0, 0), "throughout": (0, sp.pi), "top": (0, phi_H), "bottom": (phi_L, sp.pi)}[where]
    return antiderivative.subs(phi, end) - antiderivative.subs(phi, start)


def flow_times(power: int, sign: int) -> sp.Expr:
    """Antiderivative of the flow rule beyond yield times zeta^n."""
    return ((sigma_0 - sign * sigma_Y) * PARTIAL[power] + sigma_1 * PARTIAL[power + 1]) / eta


def in_angles(expression: sp.Expr, by_edges: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """Write acos and square roots of an edge through its angle."""
    known = {phi_H: sp.cos(phi_H), phi_L: sp.cos(phi_L), sp.pi - phi_H: -sp.cos(phi_H), sp.pi - phi_L: -sp.cos(phi_L)}

    def to_angle(argument: sp.Expr) -> sp.Expr:
        value = sp.cancel(argument)
        return next((angle for angle, cosine in known.items() if value == cosine), sp.acos(value))

    def to_sine(base: sp.Expr) -> sp.Expr:
        value = sp.cancel(base)
        return next(
            (sp.sin(angle) for angle, cosine in known.items() if sp.expand(value - 1 + cosine**2) == 0), sp.sqrt(value)
        )

    expression = expression.subs(by_edges)
    expression = expression.replace(lambda e: isinstance(e, sp.acos), lambda e: to_angle(e.args[0]))
    return expression.replace(lambda e: e.is_Pow and e.exp == sp.Rational(1, 2), lambda e: to_sine(e.base))


def on_the_circle(expression: sp.Expr) -> sp.Expr:
    """Numerator, with cos^2 + sin^2 = 1 used for each edge."""
    numerator = sp.numer(sp.together(expression))
    for angle in (phi_H, phi_L):
        C, S = sp.symbols("C S")
        numerator = numerator.subs({sp.cos(angle): C, sp.sin(angle): S})
        numerator = sp.rem(sp.expand(numerator), S**2 + C**2 - 1, S).subs({C: sp.cos(angle), S: sp.sin(angle)})
    return sp.expand(numerator)


# Outside the section the code keeps an edge within 1e-14 of the rim, for the sake of derivatives; here it may touch it.
means = constitutive_laws.bingham_means(replace(CIRCLE, interval=(sp.Integer(-1), sp.Integer(1))))
as_run = constitutive_laws.bingham_means(CIRCLE)
for mean_, slope_ in REGIONS:
    sample = at_unit | {sigma_0: mean_, sigma_1: slope_}
    where = {zone(sign, sample): sign for sign in (1, -1)}
    edges = [
        sigma_0 + sigma_1 * sp.cos(angle) - where[side] * sigma_Y
        for side, angle in (("top", phi_H), ("bottom", phi_L))
        if side in where
    ]
    by_edges = sp.solve(edges, [sigma_0, sigma_1][: len(edges)], dict=True)[0] if edges else {}
    for integrand, held in (
        (lambda sign: flow_times(0, sign), means.rate),
        (lambda sign: flow_times(1, sign), means.bending_rate * CIRCLE.zeta_squared),
        (lambda sign: PARTIAL[0], means.yielded_fraction),
    ):
        derived = sum(over_zone(side, integrand(sign)) for side, sign in where.items() if side != "nowhere")
        derived = sp.sympify(derived).subs(by_edges)
        held = in_angles(settle(held, sample), by_edges)
        prove_equal(on_the_circle(derived - held), 0)
    for name in ("rate", "bending_rate", "yielded_fraction"):
        touching, kept = (settle(getattr(of, name), sample).subs(sample).evalf(30) for of in (means, as_run))
        assert abs(touching - kept) < sp.Rational(1, 10**13)

# %% [markdown]
# **No moment.** Where $\sigma_1 = 0$ the section flows with its overstress and does not bend: no $0/0$.

# %%
for shape in (RECTANGLE, CIRCLE):
    for stress_, derived in ((2, sigma_0 - sigma_Y), (-2, sigma_0 + sigma_Y), (sp.Rational(1, 2), 0)):
        uniform = at_unit | {sigma_0: sp.sympify(stress_)}
        held = constitutive_laws.bingham_means(shape)
        prove_equal(derived / eta, settle(held.rate.subs(sigma_1, 0), uniform))
        prove_equal(0, held.bending_rate.subs(sigma_1, 0))

# %% [markdown]
# ## The printed closure, as the solver holds it
#
# The states are $a_0 = P/A_0$ and $a_1 = C/(A_0\frac{h_0}{2}\langle\zeta^2\rangle)$; the stress is
# $\frac TA + \frac MIz$ with (2.11), and (2.24) moves the states: $P_t = A\langle\varphi\rangle$,
# $C_t = A\frac h2\langle\varphi\zeta\rangle$.

# %%
m_2 = sp.Symbol("m_2", positive=True)  # <zeta^2>
area, thick = UNIFORM.area, UNIFORM.thickness
inertia = area * (thick / 2) ** 2 * m_2
states = {P: A0 * a_0, C: A0 * h0 / 2 * m_2 * a_1, A: area, I_z: inertia}
field = STRESS_FIELD.subs({T: TENSION, M: MOMENT})
field = sp.expand(field.subs(z, thick * zeta / 2).subs(states))
printed = closures.printed(kinematics.TRUE_STRAIN, UNIFORM)
prove_equal(field.coeff(zeta, 0), E * (sp.log(s) - printed.recall_mean * a_0))
prove_equal(field.coeff(zeta, 1), -E * (printed.lever * theta_X + printed.recall_bending * a_1))
assert printed.axial_correction == 0
rate, bending_rate = sp.symbols("rate bending_rate", real=True)  # <phi> and <phi zeta>/<zeta^2>
prove_equal(area * rate / A0, rate / printed.recall_mean)
prove_equal(area * thick / 2 * m_2 * bending_rate / (A0 * h0 / 2 * m_2), bending_rate / printed.recall_bending)
prove_equal(field.coeff(zeta, 0), E * (sp.log(s) - s * a_0))
prove_equal(field.coeff(zeta, 1), -E * (h0 * theta_X / (2 * sp.sqrt(s)) + s ** sp.Rational(3, 2) * a_1))

# %% [markdown]
# ## What it loses
#
# A Newtonian bar ($E\to\infty$, no elastic strain) that is being stretched pulls with Trouton's $\eta As_t/s$. In the
# printed closure $T = \eta P_t$ with $P = A\log s$:

# %%
S, Theta = sp.Function("S", positive=True)(t), sp.Function("Theta", real=True)(t)
A_t = A0 / S
trouton = eta * A_t * S.diff(t) / S
P_rigid = sp.solve((TENSION / E).subs({A: A_t, s: S}), P)[0]
loses = sp.simplify(eta * P_rigid.diff(t) / trouton)
prove_equal(loses, 1 - sp.log(S))
assert loses.subs(S, sp.exp(sp.Rational(1, 5))) == sp.Rational(4, 5)
assert loses.subs(S, sp.E) == 0
assert loses.subs(S, 3).is_negative

# %% [markdown]
# Twenty per cent of the tension is gone at twenty per cent of true strain, all of it at $s = e$, and beyond that the
# bar *pushes*. The lost term is $A_tP/A$: the integral of the plastic strain shrinks with the section, without any
# fibre flowing. In the moment the lost terms are of the same kind, and larger.
#
# ## The material closure
#
# A fibre keeps its $\zeta$ while the section shrinks. Its plastic strain changes by flow alone,
# $\partial_t\epsilon^p(\zeta, t) = \varphi(\sigma)$. Expand it in polynomials orthogonal under the width of the
# section. They follow from Gram and Schmidt, with $p_n(1) = 1$, so that $p_1 = \zeta$ for every section:

# %%
ORDER = 4
POLYNOMIALS = {}
for shape in SHAPES:
    found: list[sp.Expr] = []
    for n in range(ORDER + 1):
        new = zeta**n - sum(mean(shape, zeta**n * other) / mean(shape, other**2) * other for other in found)
        found.append(sp.expand(new / new.subs(zeta, 1)))
        known = sp.chebyshevu(n, zeta) / (n + 1) if shape is CIRCLE else sp.legendre(n, zeta)
        prove_equal(found[n], sp.expand(known))
        prove_equal(mean(shape, found[n] ** 2), 1 / sp.Integer((n + 1) ** 2 if shape is CIRCLE else 2 * n + 1))
    POLYNOMIALS[shape.name] = found
    assert found[1] == zeta

# %% [markdown]
# Project the flow on $p_n$: $\langle p_n\,\partial_t\epsilon^p\rangle = \langle p_n^2\rangle\,\dot a_n$, since the
# others are orthogonal, so that $\dot a_n = \langle\varphi p_n\rangle/\langle p_n^2\rangle$. The stress lies in the
# same space: $\sigma = \sum b_np_n$, in which only $b_0$ and $b_1$ know the strain. The resultants see only these
# two, at any order.


# %%
def stress_amplitudes(shrinking: sections.Contraction, states: Sequence[sp.Expr]) -> list[sp.Expr]:
    """b_n of the stress; the strain is linear, so that b_n = -E a_n from n = 2 on."""
    strains = [sp.log(s), -shrinking.thickness / (2 * s) * theta_X] + [sp.Integer(0)] * len(states)
    return [E * (strain - state) for strain, state in zip(strains, states, strict=False)]


def stored_energy(shape: sections.Section, stresses: Sequence[sp.Expr]) -> sp.Expr:
    """Elastic energy per unit material length, A0 <sigma^2>/(2E), of the b_n."""
    basis = POLYNOMIALS[shape.name]
    return A0 / (2 * E) * sum(b**2 * mean(shape, p_n**2) for b, p_n in zip(stresses, basis, strict=False))


amplitudes = sp.symbols("a_0:5", real=True)
rates = sp.symbols("adot_0:5", real=True)
for shape, shrinking in ((RECTANGLE, UNIFORM), (SHEET, WIDE), (CIRCLE, UNIFORM)):
    basis = POLYNOMIALS[shape.name]
    grown = sum(rate_ * p_n for rate_, p_n in zip(rates, basis, strict=True))
    for n, p_n in enumerate(basis):
        prove_equal(mean(shape, p_n * grown) / mean(shape, p_n**2), rates[n])
    stress = sp.expand(
        E
        * (
            true_strain.subs(z, shrinking.thickness * zeta / 2)
            - sum(a * p_n for a, p_n in zip(amplitudes, basis, strict=True))
        )
    )
    b = stress_amplitudes(shrinking, amplitudes)
    prove_equal(stress, sp.expand(sum(b_n * p_n for b_n, p_n in zip(b, basis, strict=True))))
    prove_equal(shrinking.area * mean(shape, stress), shrinking.area * b[0])
    prove_equal(mean(shape, stress * zeta), shape.zeta_squared * b[1])
    prove_equal(sp.expand(A0 / (2 * E) * mean(shape, stress**2)), sp.expand(stored_energy(shape, b)))

# %% [markdown]
# Trouton, again: $a_0 = \log s$ and $T = A\sigma_0$ with $\sigma_0 = \eta\dot a_0$. Nothing is lost. The moment of a
# Newtonian filament that bends and stretches is $-\eta\frac{I}{h/2}\partial_t(\theta_s\frac h2)$; the printed
# closure has $-\eta\,\partial_t(I\theta_X)$ instead.

# %%
b_0 = stress_amplitudes(UNIFORM, (a_0,))[0].subs(s, S)
prove_equal(A_t * eta * sp.solve(b_0 / E, a_0)[0].diff(t), trouton)
half = (UNIFORM.thickness / 2).subs(s, S)
I_t = A_t * half**2 * m_2
material_moment = -eta * I_t / half * sp.diff(Theta / S * half, t)
printed_moment = -eta * sp.diff(I_t * Theta, t)
prove_equal(material_moment, -eta * I_t / S * (Theta.diff(t) - sp.Rational(3, 2) * Theta * S.diff(t) / S))
prove_equal(printed_moment, -eta * I_t * (Theta.diff(t) - 2 * Theta * S.diff(t) / S))

# %% [markdown]
# ## The axial force conjugate to the stretch
#
# Per unit $X$ there is the volume $A_0$, and the fibres do the work $A_0\langle\sigma\,\epsilon_t\rangle$. Whatever
# the distribution of stress, only $\langle\sigma\rangle = T/A$ and $\langle\sigma\zeta\rangle = 2M/(Ah)$ occur.
# Because the lever of bending, $h/(2s)$, changes with the stretch, the force that works on $s_t$ is *not* $T$:
# $$A_0\langle\sigma\epsilon_t\rangle = Q\,s_t - M\,\theta_{Xt},\qquad
#   Q = T + \tfrac32 M\theta_s\quad(\text{sheet: } T + 2M\theta_s).$$

# %%
moving = {s: S, theta_X: Theta}
CONJUGATE = {}
for name, shrinking, factor in (("filament", UNIFORM, sp.Rational(3, 2)), ("sheet", WIDE, sp.Integer(2))):
    growth = sp.expand(true_strain.subs(z, shrinking.thickness * zeta / 2).subs(moving).diff(t).doit())
    power = A0 * (
        growth.coeff(zeta, 0) * T / shrinking.area
        + growth.coeff(zeta, 1) * 2 * M / (shrinking.area * shrinking.thickness)
    ).subs(moving)
    power = sp.expand(sp.simplify(power))
    CONJUGATE[name] = power.coeff(S.diff(t)).subs({S: s, Theta: theta_X})
    prove_equal(CONJUGATE[name], T + factor * M * theta_X / s)
    prove_equal(power.coeff(Theta.diff(t)), -M)
    prove_equal(CONJUGATE[name], T + closures.material(kinematics.TRUE_STRAIN, shrinking).axial_correction)
assert closures.material(kinematics.SMALL_STRAIN, NONE).axial_correction == 0

# %% [markdown]
# The printed closure has no such force. Even if nothing flows, its $T = EA\log s$ and $M = -EI\theta_X$ are not
# derivatives of any energy: $\partial T/\partial\theta_X\ne\partial(-M)/\partial s$, so that a closed cycle of
# stretching and bending makes or destroys energy.

# %%
printed_T = (E * area * sp.log(s)).diff(theta_X)
printed_M = (E * inertia * theta_X).diff(s)
assert printed_T == 0
assert printed_M != 0

# %% [markdown]
# ## One cell of the solver
#
# All that the solver evaluates in a cell, against what has been derived: material closure for rectangle, circle and
# sheet, printed closure for rectangle and circle, at finite and at small strain.


# %%
def cell(shape: sections.Section, name: str, law: str, *, finite: bool = True) -> SectionResponse:
    """What the solver holds."""
    terms = Terms(
        large_rotation=True,
        finite=finite,
        thins=finite,
        inertia=True,
        bending=True,
        stretches=True,
        law=Rheology(law),
        flows=True,
        yields=True,
    )
    return section_equations.derive(terms, shape, name).response


def modulus_of(shape: sections.Section) -> sp.Expr:
    """E, or E/(1 - nu^2) of a sheet, whose width is held (plane strain)."""
    return E / (1 - nu**2) if shape is SHEET else E


def prove_common(shape: sections.Section, shrinking: sections.Contraction, held: SectionResponse) -> None:
    """Size, resultants and energies, which do not depend on the closure."""
    area, half, m_2 = shrinking.area, shrinking.thickness / 2, mean(shape, zeta**2)
    tension, moment = area * mean(shape, linear), area * half * mean(shape, linear * zeta)
    stored = sp.expand(A0 / (2 * modulus_of(shape)) * mean(shape, linear**2))
    assert (held.area, held.thickness) == (area, shrinking.thickness)
    for derived, holds in (
        (tension, held.tension),
        (moment, held.moment),
        (sigma_0, held.stress_of_tension.subs(T, tension)),
        (sigma_1, held.stress_of_moment.subs(M, moment)),
        (A0, held.volume),
        (stored.coeff(sigma_0, 2) * held.branch.stress_mean**2, held.branch.stretching),
        (stored.coeff(sigma_1, 2) * held.branch.stress_bending**2, held.branch.bending),
        # A0 <sigma phi> = A0 (sigma_0 <phi> + sigma_1 <phi zeta>)
        (A0 * sigma_0 * held.branch.means.rate, held.branch.dissipation[0]),
        (A0 * sigma_1 * m_2 * held.branch.means.bending_rate, held.branch.dissipation[1]),
    ):
        prove_equal(derived, holds)


for shape, shrinking in ((RECTANGLE, UNIFORM), (CIRCLE, UNIFORM), (SHEET, WIDE), (RECTANGLE, NONE)):
    for law, closed in (("maxwell", constitutive_laws.maxwell_means), ("bingham", constitutive_laws.bingham_means)):
        response = cell(shape, "material", law, finite=shrinking is not NONE)
        prove_common(shape, shrinking, response)
        if shrinking is NONE:
            b_0, b_1 = E * (s - 1 - a_0), -E * (theta_X * h0 / 2 + a_1)
            correction = sp.Integer(0)
        else:
            b_0, b_1 = stress_amplitudes(shrinking, (a_0, a_1))
            correction = CONJUGATE["sheet" if shrinking is WIDE else "filament"] - T
        prove_equal(b_0.subs(E, modulus_of(shape)), response.branch.stress_mean)
        prove_equal(b_1.subs(E, modulus_of(shape)), response.branch.stress_bending)
        prove_equal(correction, response.axial_correction)
        # The solver differentiates the densities: T and Q - T are their slopes by s, -M that by theta_X.
        moment = response.moment.subs(sigma_1, response.branch.stress_bending)
        prove_equal(response.branch.stretching.diff(s), response.tension.subs(sigma_0, response.branch.stress_mean))
        prove_equal(response.branch.bending.diff(theta_X), -moment)
        prove_equal(response.branch.bending.diff(s), response.axial_correction.subs(M, moment))
        means = scaled(closed(shape), PLANE_STRAIN) if shape is SHEET else closed(shape)
        assert response.branch.rate_mean == means.rate
        assert response.branch.rate_bending == means.bending_rate

# %% [markdown]
# A viscous stress derives from a Rayleigh potential in the same way: $T$ and $Q - T$ are its slopes by $\dot s_X$, $-M$
# that by $\dot\theta_X$, and its power is twice the potential.

# %%
for shape in (RECTANGLE, CIRCLE, SHEET):
    fluid = Terms(finite=True, thins=True, bending=True, stretches=True, law=Rheology("newtonian"), viscous=True)
    response = section_equations.derive(fluid, shape, "material").response
    viscous = response.viscous
    moment = response.moment.subs(sigma_1, viscous.stress_bending)
    axial = response.tension.subs(sigma_0, viscous.stress_mean)
    correction = response.axial_correction.subs(M, moment)
    prove_equal(viscous.stretching.diff(s_t), axial)
    prove_equal(viscous.bending.diff(theta_Xt), -moment)
    prove_equal(viscous.bending.diff(s_t), correction)
    prove_equal(2 * viscous.stretching, axial * s_t)
    prove_equal(2 * viscous.bending, correction * s_t - moment * theta_Xt)
    eta_of = 4 * eta / 3 if shape is SHEET else eta
    prove_equal(viscous.stress_mean, eta_of * s_t / s)

for shape in (RECTANGLE, CIRCLE):
    response = cell(shape, "printed", "maxwell")
    prove_common(shape, UNIFORM, response)
    with_shape = {m_2: shape.zeta_squared}
    prove_equal(field.coeff(zeta, 0), response.branch.stress_mean)
    prove_equal(field.coeff(zeta, 1), response.branch.stress_bending)
    prove_equal(A0 * response.branch.rate_mean, response.tension / eta)  # P_t = T/eta
    bend = (A0 * h0 / 2 * m_2).subs(with_shape)
    prove_equal(bend * response.branch.rate_bending, response.moment / eta)  # C_t = M/eta
    assert response.axial_correction == 0

# %% [markdown]
# ## Energy
#
# *Forces.* Multiply the balance of momentum by the velocity. With $\mathbf v_X = s_t\mathbf t + s\theta_t\mathbf n$,
# $$\partial_t\big(\tfrac12\lambda_0|\mathbf v|^2\big) + \underbrace{Q s_t - M\theta_{Xt}}_{\text{on the section}}
#   = \partial_X\big(\mathbf F\cdot\mathbf v - M\theta_t\big) - \lambda_0 g\,y_t .$$
# What flows through $X$ vanishes at a clamp ($\mathbf v = 0$, $\theta_t = 0$), a pin ($\mathbf v = 0$, $M = 0$), a
# free end ($\mathbf F = 0$, $M = 0$) and a plane of symmetry ($v_x = 0$, $N = 0$, $\theta_t = 0$).

# %%
x, y, stretch, theta, axial, bending = (
    sp.Function(name, real=True)(X, t) for name in ("x", "y", "s_X", "theta", "Q", "M")
)
along = sp.Matrix([sp.cos(theta), sp.sin(theta)])
force = axial * along + bending.diff(X) / stretch * sp.Matrix([-sp.sin(theta), sp.cos(theta)])
velocity = sp.Matrix([x, y]).diff(t)
lambda_0, g = kinematics.mass_per_length(), sp.Symbol("g", positive=True)
on_the_section = axial * stretch.diff(t) - bending * theta.diff(X, t)
flux = force.dot(velocity) - bending * theta.diff(t)
energy_rate = lambda_0 * velocity.dot(velocity.diff(t)) + on_the_section
residual = (energy_rate - flux.diff(X) + lambda_0 * g * y.diff(t)).doit()
acceleration = (force.diff(X) / lambda_0 - sp.Matrix([0, g])).doit()  # Notebook 1
for old, new in (
    (x.diff(X, t), (stretch * sp.cos(theta)).diff(t)),
    (y.diff(X, t), (stretch * sp.sin(theta)).diff(t)),
    (x.diff(t, 2), acceleration[0]),
    (y.diff(t, 2), acceleration[1]),
):
    residual = residual.subs(old, new)
prove_equal(sp.trigsimp(sp.expand(residual)), 0)

# %% [markdown]
# *Section.* That power is stored or dissipated: $Qs_t - M\theta_{Xt} = W_t + A_0\langle\sigma\varphi\rangle$ with
# $W = A_0\langle\sigma^2\rangle/2E$ — exactly, at **every** order of truncation. The reason is that the truncated
# stress lies in the space on which the flow is projected:
# $\langle\sigma\varphi\rangle = \sum b_n\langle\varphi p_n\rangle$. Below, $r_n$ stands for
# $\langle\varphi p_n\rangle$ of an arbitrary flow rule.

# %%
r = sp.symbols("r_0:5", real=True)
a_of_t = [sp.Function(f"a_{n}", real=True)(t) for n in range(ORDER + 1)]
for shape, shrinking, axial in (
    (RECTANGLE, UNIFORM, CONJUGATE["filament"]),
    (CIRCLE, UNIFORM, CONJUGATE["filament"]),
    (SHEET, WIDE, CONJUGATE["sheet"]),
):
    basis = POLYNOMIALS[shape.name]
    for k in (1, 2, ORDER):
        b = stress_amplitudes(shrinking, a_of_t[: k + 1])
        stored = stored_energy(shape, b).subs(moving)
        flowing = {a_of_t[n].diff(t): r[n] / mean(shape, basis[n] ** 2) for n in range(k + 1)}
        stored_rate = stored.diff(t).subs(flowing)
        dissipated = A0 * sum(b[n] * r[n] for n in range(k + 1))
        resultants = {
            T: shrinking.area * b[0],
            M: shrinking.area * shrinking.thickness / 2 * shape.zeta_squared * b[1],
        }
        for wrong in (False, True):
            force = T if wrong else axial
            power = (force * S.diff(t) - M * Theta.diff(t)).subs(resultants).subs(moving)
            defect = sp.expand(sp.expand(stored_rate + dissipated.subs(moving) - power))
            if wrong:
                assert sp.simplify(defect) != 0
            else:
                prove_equal(defect, 0)

# %% [markdown]
# *Dissipation.* $\sigma\varphi(\sigma)\ge0$ in every fibre if $\varphi$ has the sign of $\sigma$, so
# $A_0\langle\sigma\varphi\rangle\ge0$. For an odd, monotone $\varphi$ and a symmetric section even its two parts,
# $\sigma_0\langle\varphi\rangle$ of stretching and $\sigma_1\langle\varphi\zeta\rangle$ of bending, are never
# negative. Fold the section about its middle ($w$ is even); $u = \sigma_1\zeta$:
# $$\langle\varphi\rangle = \tfrac12\big\langle\varphi(u+\sigma_0) - \varphi(u-\sigma_0)\big\rangle,\qquad
#   \langle\varphi\zeta\rangle = \tfrac12\big\langle\zeta\,[\varphi(\sigma_0+u) - \varphi(\sigma_0-u)]\big\rangle .$$
# A monotone $\varphi$ makes the first bracket have the sign of $\sigma_0$, as $u + \sigma_0 \gtrless u - \sigma_0$,
# and the second that of $u = \sigma_1\zeta$: times $\zeta$, that of $\sigma_1$. The folding, for *any* odd function
# $\varphi(v) = f(v) - f(-v)$:

# %%
f = sp.Function("f")


def odd(v: sp.Expr) -> sp.Expr:
    """An arbitrary odd function."""
    return f(sp.expand(v)) - f(sp.expand(-v))


def folded(of_zeta: sp.Expr) -> sp.Expr:
    """Even part, all that a symmetric section sees."""
    other_side = of_zeta.subs(zeta, -zeta)
    return sp.expand((of_zeta + other_side) / 2)


u = sigma_1 * zeta
prove_equal(folded(odd(sigma_0 + u)), sp.expand((odd(u + sigma_0) - odd(u - sigma_0)) / 2))
prove_equal(folded(zeta * odd(sigma_0 + u)), sp.expand(zeta * (odd(sigma_0 + u) - odd(sigma_0 - u)) / 2))
for shape in SHAPES:
    prove_equal(shape.weight.subs(zeta, -zeta), shape.weight)

# %% [markdown]
# ## Without stretching
#
# At small slope and strain the balance along the filament, without axial inertia, is $T_X = 0$: the tension is the
# same everywhere. Between supports that stay, $\int(x_X - 1)\,dX = 0$, and the stretch $s = x_X + \tfrac12y_X^2$
# leaves for the mean strain, and so for the tension, only what the slope makes:
# $$T = EA\,\tfrac12\langle y_X^2\rangle,\qquad EI\,y_{XXXX} - T\,y_{XX} = -q .$$

# %%
shallow = kinematics.internal_force(kinematics.SMALL_SLOPE, bending=True)
assert shallow.horizontal == Q
prove_equal(shallow.vertical, Q * y_X + M_X)
rise = sp.Function("w", real=True)(X)
drift = sp.Function("U", real=True)(X)
elongated = kinematics.SMALL_SLOPE.stretch.subs({x_X: 1 + drift.diff(X), y_X: rise.diff(X)}) - 1
# As U = 0 at both ends, its integral is that of the strain.
prove_equal(elongated - drift.diff(X), rise.diff(X) ** 2 / 2)
second_moment, load = sp.symbols("I_0 q", positive=True)
pull = sp.Symbol("T_0", real=True)
carried = (shallow.vertical.subs(M_X, -E * second_moment * rise.diff(X, 3)).subs({Q: pull, y_X: rise.diff(X)})).diff(X)
prove_equal(carried, pull * rise.diff(X, 2) - E * second_moment * rise.diff(X, 4))

# %% [markdown]
# Tension and bending share the load. For any shape $y = H f(X/L)$, with $I = A(h_0/2)^2\langle\zeta^2\rangle$, the
# ratio of the two, $T y_{XX}/EI y_{XXXX}$, is $(H/h_0)^2$ times a number of the shape: leaving tension out changes the
# sag by a share that falls with the *square* of the sag over the thickness. For one mode between pins,
# $y = -H\cos(\pi X/L)$, the number follows from Euler's load: $T/(\pi^2EI/L^2) = AH^2/4I$, which is $3(H/h_0)^2$ for a
# rectangle.

# %%
sag = sp.Symbol("H", positive=True)
shape_of = sp.Function("f", real=True)


def tension_of(height: sp.Expr) -> sp.Expr:
    """T of a shape between fixed supports."""
    return E * A0 * sp.integrate(sp.expand(height.diff(X) ** 2), (X, -L / 2, L / 2)) / (2 * L)


any_shape = sag * shape_of(X / L)
local_ratio = any_shape.diff(X) ** 2 * any_shape.diff(X, 2) / any_shape.diff(X, 4)
prove_equal((local_ratio / sag**2).diff(sag), 0)
mode = -sag * sp.cos(sp.pi * X / L)
ratio = sp.simplify(tension_of(mode) * mode.diff(X, 2) / (-E * second_moment * mode.diff(X, 4)))
prove_equal(ratio, A0 * sag**2 / (4 * second_moment))
prove_equal(ratio.subs(second_moment, A0 * (h0 / 2) ** 2 * RECTANGLE.zeta_squared), 3 * (sag / h0) ** 2)

# %% [markdown]
# Of the static shapes the first correction to the sag is exact as well: $EI\,y^{(1)}_{XXXX} = T\,y^{(0)}_{XX}$ under
# the same ends, with $T$ of the linear beam $y^{(0)}$. It takes the share $c\,AH^2/I$ of the sag $H$, with
# $c = 32/525$ between clamps, $16592/65625$ between pins, $23/175$ between a clamp and a pin: $0.73$, $3.03$ and
# $1.58$ times $(H/h_0)^2$ for a rectangle.

# %%
HELD = {"clamped": 1, "pinned": 2}  # order of the derivative that vanishes besides the height


def bent(pressure: sp.Expr, left: str, right: str) -> sp.Expr:
    """Solution of EI y'''' = pressure."""
    constants = sp.symbols("c_0:4")
    height = pressure / (E * second_moment)
    for constant in constants:
        height = sp.expand(sp.integrate(height, X)) + constant
    held_ = [height.subs(X, end) for end in (-L / 2, L / 2)]
    held_ += [height.diff(X, HELD[kind]).subs(X, end) for kind, end in ((left, -L / 2), (right, L / 2))]
    return sp.expand(height.subs(sp.solve(held_, constants)))


for left, right, stiffness_, share in (
    ("clamped", "clamped", sp.Integer(384), sp.Rational(32, 525)),
    ("pinned", "pinned", sp.Rational(384, 5), sp.Rational(16592, 65625)),
    ("clamped", "pinned", sp.Integer(192), sp.Rational(23, 175)),
):
    linear_beam = bent(-load, left, right)
    depth = -linear_beam.subs(X, 0)
    prove_equal(depth, load * L**4 / (stiffness_ * E * second_moment))
    lifted = bent(tension_of(linear_beam) * linear_beam.diff(X, 2), left, right).subs(X, 0)
    prove_equal(lifted / depth, share * A0 * depth**2 / second_moment)

# %% [markdown]
# The solver's section then loses everything axial: $s = 1$, $\sigma_0 = 0$, no $a_0$; $\sigma_1\zeta$ alone flows, and
# $\mathbf F = M_X\mathbf e_y$, whose power is that of the moment, so that the energy closes as before.

# %%
for law in ("maxwell", "bingham"):
    beam = Terms(bending=True, law=Rheology(law), flows=True, yields=True)
    loose, stiff = (
        section_equations.derive(replace(beam, stretches=given), CIRCLE, "material") for given in (True, False)
    )
    with_mean, alone = loose.response.branch, stiff.response.branch
    assert stiff.response.tension == alone.stress_mean == alone.rate_mean == 0
    assert stiff.response.moment == loose.response.moment
    assert alone.stress_bending == with_mean.stress_bending
    assert alone.rate_bending == with_mean.means.bending_rate.xreplace({sigma_0: sp.Integer(0)})
    assert (stiff.force.horizontal, stiff.force.vertical) == (0, M_X)
    kept = (alone.stress_bending, alone.bending, alone.rate_bending, stiff.response.moment)
    assert not {s, sigma_0, a_0, T} & set().union(*(expression.free_symbols for expression in kept))

# %% [markdown]
# ## The appendix: (A1), (A2)
#
# The paper expands in $L_n(z) = \sqrt{(2n+1)/h}\,P_n(2z/h)$, orthonormal over the present thickness. Its $a_n$ are
# ours times $\sqrt{h/(2n+1)}$.

# %%
L_n = [sp.sqrt((2 * n + 1) / h) * sp.legendre(n, 2 * z / h) for n in range(4)]
for n in range(4):
    for m in range(n + 1):
        inner = sp.integrate(sp.expand(L_n[n] * L_n[m]), (z, -h / 2, h / 2))
        prove_equal(sp.Integer(n == m), inner)
to_paper = [sp.sqrt(h / (2 * n + 1)) for n in range(4)]
for n in range(4):
    prove_equal(to_paper[n] * L_n[n].subs(z, h * zeta / 2), sp.legendre(n, zeta))

# %% [markdown]
# With $dz = \frac h2d\zeta$ the right-hand side of (A2) is $\sqrt{h/(2n+1)}$ times ours, *provided* that the stress
# under the integral is the same: it is where $s = 1$ multiplies the curvature ($\theta_Xz$ against $\theta_sz$).

# %%
in_paper = [amplitudes[n] * to_paper[n] for n in range(4)]
plastic = sum(a * L for a, L in zip(in_paper, L_n, strict=True))
paper_stress = (E * sp.log(s) - E * theta_X * z - E * plastic).subs({z: h * zeta / 2, s: 1})
ours = sum(
    b_n * p_n for b_n, p_n in zip(stress_amplitudes(NONE, amplitudes[:4]), POLYNOMIALS["rectangle"], strict=False)
)
prove_equal(sp.expand(paper_stress), sp.expand(ours.subs({s: 1, h0: h})))
for n in range(4):
    integrand = L_n[n].subs(z, h * zeta / 2) * h / 2
    prove_equal(integrand, to_paper[n] * (2 * n + 1) * sp.legendre(n, zeta) * RECTANGLE.weight)

# %% [markdown]
# So in a filament whose thickness does not change (A2) *is* the material closure, order by order, and its $k = 1$ is
# (2.24): $P = A a_0$ and $C = A\frac h2\langle\zeta^2\rangle a_1$ then have the rates $A\langle\varphi\rangle$ and
# $A\frac h2\langle\varphi\zeta\rangle$.
#
# When the section shrinks the three part. Our $a_n$ obey $\dot a_n = \langle\varphi p_n\rangle/\langle p_n^2\rangle$
# with nothing added; hence
# $$P_t = \int_A\varphi\,da + \frac{A_t}{A}P,\qquad C_t = \int_A\varphi z\,da + \frac{(Ah)_t}{Ah}C,\qquad
#   \partial_ta_n^{\text{paper}} = \int\varphi L_n\,dz + \frac{h_t}{2h}a_n^{\text{paper}} .$$
# The paper drops each last term: a different error in (2.12) than in (A2), so that its claim that $k = 1$ of the
# appendix *is* the system of its section 2 holds only while nothing stretches.

# %%
thickness_t = h0 / sp.sqrt(S)
state = sp.Function("a", real=True)(t)
flow_mean = sp.Symbol("flow", real=True)
spurious = {}
for name, factor, derived in (
    ("P", A_t, -S.diff(t) / S),
    ("C", A_t * thickness_t, -sp.Rational(3, 2) * S.diff(t) / S),
    ("a_n", sp.sqrt(thickness_t), -S.diff(t) / (4 * S)),
):
    theirs = factor * state
    exact = theirs.diff(t).subs(state.diff(t), flow_mean)
    spurious[name] = sp.simplify((exact - factor * flow_mean) / theirs)
    prove_equal(spurious[name], derived)
# Trouton's ratio of (A2) read literally: 1 - (log s)/4, between the material 1 and 1 - log s of (2.12).
root = sp.sqrt(thickness_t)
literal = sp.simplify(eta * A_t * sp.diff(root * sp.log(S), t) / root / trouton)
prove_equal(literal, 1 - sp.log(S) / 4)

# %%
record_errata(
    "02_section_and_closures",
    [
        Erratum(
            equation="(2.6)",
            printed=r"$\epsilon = \log s_X - \theta_X z$",
            correct=r"$\epsilon = \log s_X - \theta_s z$, $\theta_s = \theta_X/s_X$",
            proof=r"A fibre has the length $s_X - z\theta_X$ per unit $X$; the log has the slope $\theta_X/s_X$.",
        ),
        Erratum(
            equation="(2.12), (2.24)",
            printed=r"$P_t = \int_A\varphi\,da$, $C_t = \int_A\varphi z\,da$",
            correct=r"$P_t = \int_A\varphi\,da + (A_t/A)P$, $C_t = \int_A\varphi z\,da + ((Ah)_t/Ah)C$",
            proof=r"As printed, a Newtonian bar pulls with $\eta A(s_t/s)(1 - \log s)$: not at all at $s = e$.",
        ),
        Erratum(
            equation="(2.4) with (2.11)",
            printed=r"axial force $T$",
            correct=r"$Q = T + \frac32 M\theta_s$ (sheet: $T + 2M\theta_s$)",
            proof=r"Work conjugacy: with $T$ alone even the elastic filament has no stored energy.",
        ),
        Erratum(
            equation="(A 2)",
            printed=r"$\partial_t a_n = \int\varphi L_n\,dz$, said to contain (2.12) as $k \le 1$",
            correct=r"$\partial_t a_n = \int\varphi L_n\,dz + (h_t/2h)a_n$",
            proof=r"Fibres keep $2z/h$; as printed, Trouton's tension comes out $1 - \frac14\log s$ times.",
        ),
    ],
)
