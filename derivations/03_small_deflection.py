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
# # 3. Small deflections: (2.13)–(2.19)
#
# A filament that has sagged by a small fraction of its span is already interesting: bending, tension, inertia and
# gravity can all matter. We let $y$, the thickness, gravity and the rates become small *together*, in the one way
# that keeps all four, and let SymPy expand the full balance. What remains is a single deflection $y(X, t)$ with one
# tension for the whole span. Its two memory integrals become two states that relax, so that it runs like any other
# filament.
#
# We shall find that (2.18) counts bending twice.

# %%
import sympy as sp
from proving import Erratum, prove_equal, record_errata, vanishes

from softcat_sym.physics import symbols as sy
from softcat_sym.physics.regimes import K_I, V, delta, gyration, tau_star
from softcat_sym.physics.rheometry import t_star
from softcat_sym.physics.section_equations import derive
from softcat_sym.physics.sections import CIRCLE, RECTANGLE
from softcat_sym.physics.symbols import (
    A0,
    M_X,
    E,
    L,
    M,
    T,
    X,
    a_0,
    a_1,
    eta,
    g,
    h0,
    rho,
    sigma_0,
    sigma_1,
    t,
    y_X,
    zeta,
)
from softcat_sym.physics.terms import Rheology, Terms

# Fields of (X, t) or of time alone; those with a bar or a star in units of L and sqrt(L/g).
y_of, U_of, M_of, T_of, a_0_of, a_1_of, y_bar, m_bar, q_bar = (
    sp.Function(name, real=True) for name in ("y", "U", "M", "T", "a_0", "a_1", "y_bar", "m", "q")
)
x_bar, t_prime, t_star_prime = sp.symbols("x_bar t' t*'", real=True)
# The mean of y_X^2/2 over the span, the curvature, and their rates
e_mean, e_mean_t, y_XX, y_XXt = sp.symbols("e_mean e_mean_t y_XX y_XXt", real=True)
D = sp.Derivative


half = sp.Rational(1, 2)
y, U, a0X, a1 = y_of(X, t), U_of(X, t), sp.Function("a_0")(X, t), a_1_of(X, t)

# %% [markdown]
# ## The one way to be small
#
# Let $y \sim \varepsilon$. The stretch due to slope is $y_X^2/2 \sim \varepsilon^2$, and a displacement $U = x - X$
# of the same order can even it out. So the tension is $T \sim EA\varepsilon^2$ and pulls up with
# $T y_{XX} \sim \varepsilon^3$. The other forces across the span are
#
# * bending, $EI y_{XXXX} \sim h_0^2\,\varepsilon$,
# * weight, $\rho A_0 g$,
# * inertia, $\rho A_0 y_{tt} \sim \omega^2\varepsilon$ with a rate $\omega$,
#
# and the stress must relax on the same clock, $E/\eta \sim \omega$. Writing $h_0 \sim \varepsilon^a$,
# $g \sim \varepsilon^b$, $\omega \sim \varepsilon^c$, all are equal for one choice of exponents.

# %%
exponent_h, exponent_g, exponent_rate = sp.symbols("a b c")
exponents = sp.solve(
    [2 * exponent_h + 1 - 3, exponent_g - 3, 2 * exponent_rate + 1 - 3], [exponent_h, exponent_g, exponent_rate]
)
assert exponents == {exponent_h: 1, exponent_g: 3, exponent_rate: 1}

# %% [markdown]
# So slenderness $\delta$ and sag are of the same order, as (2.18) with its $\delta^2$ assumes. If $\delta$ is much
# smaller the bending term is merely negligible: nothing is lost. We mark orders with a bookkeeping parameter:
# $y \to \varepsilon y$, $U \to \varepsilon^2 U$, $h_0 \to \varepsilon h_0$, $g \to \varepsilon^3 g$,
# $\partial_t \to \varepsilon\,\partial_t$, $\eta \to \eta/\varepsilon$, plastic strains $\to \varepsilon^2$ times
# themselves, and set $\varepsilon = 1$ at the end.
#
# ## Geometry (2.13)

# %%
eps = sp.Symbol("varepsilon", positive=True)
p, u = sp.symbols("p u", real=True)  # y_X and U_X


def truncated(expression: sp.Expr, order: int) -> sp.Expr:
    """Taylor polynomial in eps."""
    return sum(
        (expression.diff(eps, n).subs(eps, 0) / sp.factorial(n) * eps**n for n in range(1, order + 1)),
        expression.subs(eps, 0),
    )


def polynomial(expression: sp.Expr, order: int) -> sp.Expr:
    """The same for an expression that is a polynomial in eps already."""
    return sum(sp.expand(expression.doit()).coeff(eps, n) * eps**n for n in range(order + 1))


as_fields = {p: D(y, X), u: D(U, X)}
stretch_exact = sp.sqrt((1 + eps**2 * u) ** 2 + (eps * p) ** 2)
stretch = truncated(stretch_exact, 4).subs(as_fields)
log_stretch = truncated(sp.log(stretch_exact), 4).subs(as_fields)
shrink = truncated(1 / stretch_exact, 4).subs(as_fields)  # 1/s
shrink_root = truncated(1 / sp.sqrt(stretch_exact), 4).subs(as_fields)  # s^(-1/2)
angle = truncated(sp.atan(eps * p / (1 + eps**2 * u)), 5).subs(as_fields)

assert vanishes(stretch.coeff(eps, 2) - (D(U, X) + D(y, X) ** 2 / 2))
assert stretch.coeff(eps, 1) == 0
assert angle.coeff(eps, 1) == D(y, X)

# %% [markdown]
# ## Section
#
# Stress $\sigma = E(\epsilon - \epsilon_p)$ with $\epsilon = \log s - \theta_s\,(h/2)\,\zeta$, a section that thins
# as $A = A_0/s$, $h = h_0 s^{-1/2}$, and a plastic strain linear across it, $\epsilon_p = a_0 + a_1\zeta$. Tension
# and moment are $T = A\langle\sigma\rangle$, $M = A(h/2)\langle\sigma\zeta\rangle$; $\langle\zeta^2\rangle$ stays a
# symbol, so that this is any symmetric section. Angle brackets are means over the section.

# %%
zz = sp.Symbol("zeta_squared", positive=True)
thickness = eps * h0 * shrink_root
stress_0 = E * (log_stretch - eps**2 * a0X)
stress_1 = -E * (thickness / 2 * shrink * D(angle, X) + eps**2 * a1)
tension = polynomial(A0 * shrink * stress_0, 4)
moment = polynomial(A0 * shrink * thickness / 2 * zz * stress_1, 5)

tension_2 = tension.coeff(eps, 2)
moment_3 = moment.coeff(eps, 3)
prove_equal(tension_2, E * A0 * (D(U, X) + D(y, X) ** 2 / 2 - a0X))
prove_equal(moment_3, -E * A0 * h0**2 * zz / 4 * (D(y, X, X) + 2 * a1 / h0))

# %% [markdown]
# This is (2.15): $T = E(A(y_X^2/2 + U_X) - P)$ with $P = A a_0$, and $M = -E(I y_{XX} + C)$ with
# $I = \tfrac14 A_0h_0^2\langle\zeta^2\rangle$ and $C = \tfrac12 A_0h_0\langle\zeta^2\rangle a_1$. Hence the form
# factor $K = I/(A_0h_0^2) = \langle\zeta^2\rangle/4$.

# %%
turn_angle = sp.Symbol("a", real=True)  # zeta = sin a spares SymPy the square roots
widths = {"rectangle": half, "circle": 2 * sp.cos(turn_angle) / sp.pi}  # relative width w of the section at zeta
SHAPES = {"rectangle": RECTANGLE, "circle": CIRCLE}
FORM_FACTORS = {"rectangle": sp.Rational(1, 12), "circle": sp.Rational(1, 16)}
moments = {
    name: [
        sp.integrate(width * sp.sin(turn_angle) ** n * sp.cos(turn_angle), (turn_angle, -sp.pi / 2, sp.pi / 2))
        for n in range(3)
    ]
    for name, width in widths.items()
}


def mean(fibre: sp.Expr, name: str) -> sp.Expr:
    """Mean over a section of a quadratic in zeta."""
    powers = sp.Poly(fibre, zeta).all_coeffs()[::-1]
    return sum(power * moment for power, moment in zip(powers, moments[name], strict=False))


for name, form_factor in FORM_FACTORS.items():
    assert moments[name] == [1, 0, 4 * form_factor]
    assert gyration(SHAPES[name]) == form_factor

# %% [markdown]
# ## Balance (2.14)
#
# $\lambda_0\mathbf x_{tt} = \partial_X(Q\,\mathbf t + N\,\mathbf n) - \lambda_0 g\,\mathbf e_y$ with $N = M_X/s$. The
# force conjugate to the stretch is $Q = T + kM\theta_s$: $k = 0$ in the paper, $3/2$ for a section that thins in both
# directions, 2 for a sheet. We leave $k$ open: it will not matter.

# %%
k = sp.Symbol("k", real=True)
turn = polynomial(shrink * D(angle, X), 3)
axial = polynomial(tension + k * moment * turn, 5)
shear = polynomial(D(moment, X) * shrink, 5)
cosine = polynomial(truncated(sp.cos(eps * p), 4).subs(p, angle / eps), 4)
sine = polynomial(truncated(sp.sin(eps * p), 5).subs(p, angle / eps), 5)

along = polynomial(D(axial * cosine - shear * sine, X), 4)
across = polynomial(D(axial * sine + shear * cosine, X), 4)
inertia_along = rho * A0 * eps**2 * eps**2 * D(U, t, t)
inertia_across = rho * A0 * eps**2 * eps * D(y, t, t) + rho * A0 * eps**3 * g

# %% [markdown]
# Along the span the leading order is $\varepsilon^2$, and there is no inertia in it: $T_X = 0$. A sound wave crosses
# the span in no time on the clock of the sag.

# %%
assert all(along.coeff(eps, n) == 0 for n in (0, 1, 3))
prove_equal(along.coeff(eps, 2), D(tension_2, X).doit())
assert sp.expand(inertia_along).coeff(eps, 2) == 0

# %% [markdown]
# Across the span it is $\varepsilon^3$, where inertia, weight, tension and bending all stand. With $T_X = 0$ this is
# the first equation of (2.14).

# %%
assert all(across.coeff(eps, n) == 0 for n in (0, 1, 2, 4))
balance_across = across.coeff(eps, 3) - sp.expand(inertia_across).coeff(eps, 3)
written_out = D(tension_2 * D(y, X), X) + D(moment_3, X, X) - rho * A0 * (D(y, t, t) + g)
prove_equal(balance_across, written_out.doit())
assert not across.coeff(eps, 3).has(k) and not along.coeff(eps, 2).has(k)

T_t, M_Xt = T_of(t), M_of(X, t)
momentum = rho * A0 * D(y, t, t) - (T_t * D(y, X, X) + D(M_Xt, X, X) - rho * A0 * g)
in_terms_of_y = {T_t: tension_2, M_Xt: moment_3}
prove_equal(
    (balance_across + momentum.subs(in_terms_of_y).doit()).expand(),
    (D(tension_2, X) * D(y, X)).doit().expand(),  # zero, since T_X = 0
)

# %% [markdown]
# Neither equation has a term one order up ($\varepsilon^3$ along, $\varepsilon^4$ across): thinning, large rotation,
# true strain, the closure and $Q - T$ all enter at relative order $\varepsilon^2$. The reduced model therefore errs
# by a fraction of order $(\text{sag}/L)^2$ and $\delta^2$, not $\text{sag}/L$.
#
# ## One elongation for the whole span
#
# The material is a Maxwell fluid: $\partial_t\epsilon_p = \sigma/\eta$ (2.7), fibre by fibre. The rates of $a_0$ and
# $a_1$ are the projections $\langle\phi\rangle$ and $\langle\phi\zeta\rangle/\langle\zeta^2\rangle$.

# %%
for name in SHAPES:
    fibre_rate = (sigma_0 + sigma_1 * zeta) / eta
    prove_equal(mean(fibre_rate, name), sigma_0 / eta)
    prove_equal(mean(fibre_rate * zeta, name) / mean(zeta**2, name), sigma_1 / eta)

# %% [markdown]
# So $\partial_t a_0 = \langle\sigma\rangle/\eta = T/(A_0\eta)$ (2.12), which is the same for all $X$: an $a_0$
# uniform at first stays uniform. (Beyond a yield stress the mean rate would depend on $\sigma_1(X)$ too, and this
# argument fails: the reduced model belongs to elastic and Maxwell filaments.) Then $y_X^2/2 + U_X = T/(EA_0) + a_0$
# is uniform as well. Its value follows by integration over the half span, at whose ends $U$ vanishes by symmetry and
# by the support.

# %%
e_of = sp.Function("e")(t)
slope_squared = sp.Integral(D(y, X) ** 2 / 2, (X, 0, L / 2))
displaced = sp.Function("U_end")(t) - sp.Function("U_mid")(t)  # integral of U_X
uniform = sp.solve(e_of * L / 2 - slope_squared - displaced, e_of)[0]
mean_elongation = uniform.subs({sp.Function("U_end")(t): 0, sp.Function("U_mid")(t): 0})
prove_equal(mean_elongation, sp.Integral(D(y, X) ** 2, (X, 0, L / 2)) / L)

a0 = a_0_of(t)
uniform_tension = tension_2.subs({D(U, X): mean_elongation - D(y, X) ** 2 / 2, a0X: a0})
prove_equal(uniform_tension, E * A0 * (mean_elongation - a0))
moment_K = moment_3.subs(zz, 4 * K_I)
stress_of_moment = sp.solve(M - A0 * h0 / 2 * 4 * K_I * sigma_1, sigma_1)[0]

# %% [markdown]
# ## Memory, three ways: plastic strain, relaxation, integral (2.16), (2.17)
#
# Differentiate $T = EA_0(\bar\epsilon - a_0)$ and $M = -EI(y_{XX} + 2a_1/h_0)$ and put the flow in: the plastic
# strains disappear and stress that relaxes at the rate $E/\eta = 1/\tau$ is left.

# %%
e_t = sp.Function("e")(t)
rate_of_tension = D(E * A0 * (e_t - a0), t).doit().subs(D(a0, t), T_t / (A0 * eta))
prove_equal(rate_of_tension, E * A0 * D(e_t, t) - E / eta * T_t)
rate_of_moment = D(moment_K, t).doit().subs(D(a1, t), stress_of_moment.subs(M, M_Xt) / eta)
prove_equal(rate_of_moment, -E * K_I * A0 * h0**2 * D(y, X, X, t) - E / eta * M_Xt)

# %% [markdown]
# The other way: multiply by the integrating factor $e^{t/\tau}$. Then
# $\partial_t(e^{t/\tau}T) = e^{t/\tau}EA_0\bar\epsilon_t$, and with $T(0) = 0$ (a relaxed filament)
# $T = EA_0 e^{-t/\tau}\int_0^t e^{t'/\tau}\bar\epsilon_{t'}dt'$. The moment likewise.

# %%
relaxation = eta / E
factor = sp.exp(t / relaxation)
for stress, driving in ((T_t, E * A0 * D(e_t, t)), (M_Xt, -E * K_I * A0 * h0**2 * D(y, X, X, t))):
    relaxes = driving - stress / relaxation
    prove_equal(D(factor * stress, t).doit().subs(D(stress, t), relaxes), factor * driving)


def remembered(rate: sp.Expr) -> sp.Expr:
    """exp(-t/tau) times the integral of exp(t'/tau) rate(t') from 0 to t."""
    integrand = (sp.exp(t / relaxation) * rate).subs(t, t_prime)
    return sp.exp(-t / relaxation) * sp.Integral(integrand, (t_prime, 0, t))


# %% [markdown]
# That the integral solves the relaxation equation, and starts from zero, SymPy shows by Leibniz's rule for any rate
# $r(t)$.

# %%
r = sp.Function("r")
any_memory = remembered(r(t))
prove_equal(sp.diff(any_memory, t), r(t) - any_memory / relaxation)
assert any_memory.subs(t, 0).doit() == 0

# %% [markdown]
# ## Dimensionless (2.18)
#
# Lengths in $L$, times in $\sqrt{L/g}$: $x = \bar xL$, $y = \bar yL$ (the paper prints $(\bar x, \bar y) = (x, y)L$,
# which is an area), $h_0 = \delta L$, $\eta = V\rho\sqrt{gL^3}$, $\eta/E = \tau^*\sqrt{L/g}$. Define the memories
#
# $$q = e^{-t/\tau}\!\int_0^t\! e^{t'/\tau}\,\partial_{t'}\!\int_0^{1/2}\!\tfrac12 y_x^2\,dx\,dt', \qquad
#   m = e^{-t/\tau}\!\int_0^t\! e^{t'/\tau}\, y_{xxxxt'}\,dt'.$$
#
# Then $T = 2EA_0q$: the factor 2 of (2.17), from a mean taken over *half* a span. And $M_{XX} = -EI\,m/L^3$.

# %%
yb, mb, qb = y_bar(x_bar, t_star), m_bar(x_bar, t_star), q_bar(t_star)
clock = sp.sqrt(L / g)
groups = {h0: delta * L, E: eta / (tau_star * clock)}
viscosity = {eta: V * rho * sp.sqrt(g * L**3)}

curvature_up, inertia_up = D(yb, x_bar, x_bar) / L, L / clock**2 * D(yb, t_star, t_star)
tension_q = E * A0 * 2 * qb
bending_m = -E * K_I * A0 * h0**2 * mb / L**3
in_groups = (tension_q * curvature_up + bending_m - rho * A0 * (inertia_up + g)).subs(groups).subs(viscosity)
per_weight = sp.powsimp(sp.expand(in_groups / (rho * A0 * g)), force=True)
E_star = V / tau_star  # E/(rho g L)
prove_equal(
    per_weight, 2 * E_star * qb * D(yb, x_bar, x_bar) - E_star * delta**2 * K_I * mb - D(yb, t_star, t_star) - 1
)

# %% [markdown]
# Bring $y_{tt} + 1$ to the right and multiply by $\tau/(2V)$, so that the tension stands bare as in the paper:

# %%
reduced = sp.expand(per_weight * tau_star / (2 * V))
load = (D(yb, t_star, t_star) + 1) * tau_star / (2 * V)
prove_equal(reduced + load, qb * D(yb, x_bar, x_bar) - delta**2 * K_I * mb / 2)

# %% [markdown]
# The bending term carries $\delta^2K/2$. **Printed: $\delta^2K$.** An independent check needs no algebra of ours. Let
# the filament be elastic ($\tau\to\infty$, so that $m = y_{xxxx}$), stiff ($q \to 0$) and at rest: a clamped beam,
# whose sag under its weight every table gives as $\rho gA_0L^4/(384EI)$.

# %%
sag_coefficient = sp.Symbol("a")
beam = -sag_coefficient * (x_bar**2 - sp.Rational(1, 4)) ** 2
assert beam.subs(x_bar, half) == 0 and beam.diff(x_bar).subs(x_bar, half) == 0
book_sag = 1 / (384 * E_star * K_I * delta**2)  # rho g A L^4/(384 E I) in units of L
sags = {}
for name, coefficient in (("derived", delta**2 * K_I / 2), ("printed", delta**2 * K_I)):
    at_rest = -coefficient * beam.diff(x_bar, 4) - tau_star / (2 * V)
    sags[name] = -beam.subs(x_bar, 0).subs(sag_coefficient, sp.solve(at_rest, sag_coefficient)[0])
prove_equal(sags["derived"], book_sag)
prove_equal(sags["printed"], book_sag / 2)

# %% [markdown]
# As printed, a beam is twice as stiff as it is. The right side is also printed with $\bar y_{\bar t} + 1$: velocity
# plus gravity. Then a filament let go would fall at a constant speed, $y = -t$, against the paper's own
# $y_{tt} + 1 = 0$ two paragraphs on; and (2.19) would give one initial condition too many.

# %%
fall = sp.Function("y")(t_star)
from_rest = {fall.subs(t_star, 0): 0, fall.diff(t_star).subs(t_star, 0): 0}
assert sp.dsolve(fall.diff(t_star) + 1, fall, ics={fall.subs(t_star, 0): 0}).rhs == -t_star
assert sp.dsolve(fall.diff(t_star, 2) + 1, fall, ics=from_rest).rhs == -(t_star**2) / 2

# %% [markdown]
# ## Two memories as two states
#
# $q$ and $m$ as defined satisfy equations that relax (the proof by Leibniz's rule above, with $\tau^*$ for $\eta/E$),
# so no integral over the past has to be kept.

# %%


def remembered_bar(rate: sp.Expr) -> sp.Expr:
    """The same memory in dimensionless time."""
    integrand = (sp.exp(t_star / tau_star) * rate).subs(t_star, t_star_prime)
    return sp.exp(-t_star / tau_star) * sp.Integral(integrand, (t_star_prime, 0, t_star))


any_memory = remembered_bar(r(t_star))
prove_equal(sp.diff(any_memory, t_star), r(t_star) - any_memory / tau_star)

# %% [markdown]
# The solver carries the plastic strains instead, one number $a_0$ for the span and $a_1$ on nodes. Both are the same
# thing: with $\bar\epsilon = 2\int_0^{1/2}\tfrac12y_x^2dx$ let $q = (\bar\epsilon - a_0)/2$ and
# $m = \partial_{xx}(y_{xx} + 2a_1/\delta)$. Put the flow in dimensionless form,
# $\dot a_0 = (\bar\epsilon - a_0)/\tau^*$ and $\dot a_1 = -(\tfrac12\delta y_{xx} + a_1)/\tau^*$, and the equations
# of $q$ and $m$ follow.

# %%
e_star, a0_star, a1_star = sp.Function("e")(t_star), a_0_of(t_star), a_1_of(x_bar, t_star)
a0_flow = (e_star - a0_star) / tau_star
a1_flow = -(delta * D(yb, x_bar, x_bar) / 2 + a1_star) / tau_star
q_by_state = (e_star - a0_star) / 2
m_by_state = D(D(yb, x_bar, x_bar) + 2 * a1_star / delta, x_bar, x_bar)
prove_equal(
    D(q_by_state, t_star).doit().subs(D(a0_star, t_star), a0_flow), D(e_star / 2, t_star) - q_by_state / tau_star
)
m_rate = D(yb, (x_bar, 4), t_star) + D(2 * a1_flow / delta, x_bar, x_bar)
prove_equal(m_rate.doit(), (D(yb, (x_bar, 4), t_star) - m_by_state / tau_star).doit())

# the flow in dimensionless form is the one of the stresses
stress_mean, stress_bending = E * (e_mean - a_0), -E * (h0 / 2 * y_XX + a_1)
prove_equal((stress_mean / eta * clock).subs(groups), (e_mean - a_0) / tau_star)
prove_equal((stress_bending / eta * clock).subs(groups).subs(y_XX, y_XX / L), -(delta * y_XX / 2 + a_1) / tau_star)

# %% [markdown]
# ## Power, and with it the boundary conditions (2.19)
#
# Multiply the momentum balance by $y_t$. The rate of kinetic and potential energy, plus the power that elongation and
# curvature take from the stresses, is the divergence of the power that crosses a section.

# %%
F_vertical = T_t * D(y, X) + D(M_Xt, X)
crossing = D(y, t) * F_vertical - D(y, X, t) * M_Xt
kinetic_and_potential = D(y, t) * (D(F_vertical, X) - rho * A0 * g) + rho * A0 * g * D(y, t)
absorbed = T_t * D(D(y, X) ** 2 / 2, t) - M_Xt * D(y, X, X, t)
prove_equal((kinetic_and_potential + absorbed).doit().expand(), D(crossing, X).doit().expand())

# %% [markdown]
# So at an end either $y$ is held or $F = Ty_X + M_X$ vanishes, and either $y_X$ is held or $M$ vanishes; no other end
# does no work. A clamp holds both; a pin holds $y$ with $M = 0$; midspan holds $y_X = 0$ by symmetry, with $F = 0$.
# Four conditions for four derivatives in $x$. In time: $y$ and $y_t$, and a relaxed filament has $m = q = 0$.
#
# What the stresses take is stored or dissipated, fibre by fibre:
# $\sigma\,\epsilon_t = \partial_t(\sigma^2/2E) + \sigma\phi(\sigma)$. Averaged over the section with
# $\sigma = \sigma_0 + \sigma_1\zeta$, and compared with the power $T\bar\epsilon_t - My_{XXt}$:

# %%
s0, s1 = sp.Function("s_0")(t), sp.Function("s_1")(t)
for name, shape in SHAPES.items():
    fibre = sigma_0 + sigma_1 * zeta
    stored, dissipated = A0 * mean(fibre**2 / (2 * E), name), A0 * mean(fibre**2 / eta, name)
    T_section, M_section = A0 * mean(fibre, name), A0 * h0 / 2 * mean(fibre * zeta, name)
    fill = {sigma_0: s0, sigma_1: s1}
    flowing = {D(s0, t): E * (e_mean_t - s0 / eta), D(s1, t): -E * (h0 / 2 * y_XXt + s1 / eta)}
    power = (T_section * e_mean_t - M_section * y_XXt).subs(fill)
    prove_equal(sp.diff(stored.subs(fill), t).subs(flowing) + dissipated.subs(fill), power)

    # What the solver prints, of a Maxwell fluid and of an elastic filament, whose plastic strain is zero
    for flows in (True, False):
        law, at_rest = Rheology("maxwell" if flows else "elastic"), {} if flows else {a_0: 0, a_1: 0}
        equations = derive(Terms(law=law, bending=True, stretches=True, inertia=True, flows=flows), shape, "material")
        response, fluidity = equations.response, 1 / eta if flows else 0
        part, uniform = response.branch, {sy.s: 1 + e_mean, sy.theta_X: y_XX}
        stress = {sigma_0: part.stress_mean, sigma_1: part.stress_bending}
        for printed, derived in (
            (equations.centreline.stretch.subs(sy.x_X, 1) - 1, stretch.coeff(eps, 2).subs({D(U, X): 0, D(y, X): y_X})),
            (part.stress_mean, stress_mean.subs(at_rest)),
            (part.stress_bending, stress_bending.subs(at_rest)),
            (response.tension, T_section),
            (response.moment, M_section),
            (
                equations.force.vertical.subs(sy.Q, T),
                F_vertical.subs({D(M_Xt, X): M_X, D(y, X): y_X, T_t: T}),
            ),
            (part.rate_mean, sigma_0 * fluidity),
            (part.rate_bending, sigma_1 * fluidity),
            (part.stretching + part.bending, stored.subs(stress)),
            (sum(part.dissipation), dissipated if flows else 0),
        ):
            prove_equal(sp.sympify(printed).subs(uniform), sp.sympify(derived).subs(uniform))
        assert not (part.stretching.has(a_1) or part.bending.has(a_0))

# %% [markdown]
# $T\bar\epsilon_t$ per unit length times $L$ is $T\,\partial_t\int y_X^2/2\,dX$, the power in the identity above:
# energy closes on the whole span although stress and strain are not local to a cell.
#
# ## The misprints

# %%
record_errata(
    "03_small_deflection",
    [
        Erratum(
            "2.18",
            r"-\delta^2 K e^{-t/\tau}\int_0^t e^{t'/\tau} y_{xxxxt'}dt'",
            r"-\tfrac12\delta^2 K e^{-t/\tau}\int_0^t e^{t'/\tau} y_{xxxxt'}dt'",
            "Expansion of the full balance; as printed a clamped beam sags rho g A L^4/(768 E I), half the truth.",
        ),
        Erratum(
            "before 2.18",
            r"(\bar x, \bar y) = (x, y)L",
            r"(\bar x, \bar y) = (x, y)/L",
            "Dimensions: a length times a length is not a number.",
        ),
        Erratum(
            "2.18",
            r"(\bar y_{\bar t} + 1)\bar\tau/2V",
            r"(\bar y_{\bar t\bar t} + 1)\bar\tau/2V",
            "Expansion of the full balance; as printed a filament let go falls at constant speed. Perhaps the scan.",
        ),
    ],
)
