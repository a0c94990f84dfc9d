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
# # 11. Any rheology: from shear to tension, sheets, limits, and a string that sags
#
# A law is springs in parallel, each in line with a flow rule $\varphi_j$, beside a viscous stress:
# $\sigma = \sum_j E_j(\epsilon - \epsilon^p_j) + \eta\,\epsilon_t$, $\dot\epsilon^p_j = \varphi_j(\sigma_j)$.
# Proved here: what the constants measured in shear are worth in tension, what a wide sheet makes of a rule, which law
# becomes which, and how a string of a power-law fluid sags.
#
# Effects derived here: `viscous-flow` (`constitutive_laws.power_law_rate`, `constitutive_laws.maxwell_rate`),
# `viscous-stress` (`constitutive_laws.law_of`), `solid-damping` (`section_equations.law_in_force`).

# %%
import sympy as sp
from proving import prove_equal

from softcat_sym.physics import bulk, closed_forms
from softcat_sym.physics.constitutive_laws import (
    E_2,
    SMALL_STRESS,
    K,
    Law,
    bingham_rate,
    herschel_bulkley_rate,
    law_of,
    maxwell_means,
    maxwell_rate,
    mode,
    n,
    power_law_rate,
)
from softcat_sym.physics.regimes import H
from softcat_sym.physics.section_equations import law_in_force
from softcat_sym.physics.sections import RECTANGLE, scaled
from softcat_sym.physics.symbols import E, L, eta, eta_s, g, rho, sigma, sigma_0, sigma_1, sigma_Y, t
from softcat_sym.physics.terms import Rheology, Terms

# %% [markdown]
# ## The rules themselves
#
# Above the tiny stress that keeps their slope finite at rest, and in tension, where signs and bars drop out:

# %%
tensile, excess = sp.symbols("tensile excess", positive=True)


def without_smoothing(rule: sp.Expr) -> sp.Expr:
    """The rule for a modulus of zero, of which the smallest stress is a fraction."""
    return sp.powsimp(sp.powdenest(rule.subs(E, 0), force=True))


smooth = power_law_rate().subs(sigma, tensile)
prove_equal(without_smoothing(smooth), (tensile / K) ** (1 / n))
beyond = herschel_bulkley_rate().subs(sigma, sigma_Y + excess)
prove_equal(without_smoothing(beyond), (excess / K) ** (1 / n))
assert herschel_bulkley_rate().subs(sigma, sigma_Y * sp.Rational(2, 3)) == 0
# Off by (1/n - 1)/2 (e/stress)^2 to leading order: a millionth where the stress is a thousand times e.
small = sp.Symbol("small", positive=True)
leading = sp.series((1 + small**2) ** ((1 / n - 1) / 2), small, 0, 4).removeO()
prove_equal(leading, 1 + (1 / n - 1) / 2 * small**2)
slope = sp.diff(power_law_rate(), sigma).subs(sigma, 0)
for index in (sp.Rational(3, 10), sp.Integer(1), sp.Integer(2)):
    prove_equal(slope.subs(n, index), (SMALL_STRESS * E / K) ** (1 / index - 1) / K)

# %% [markdown]
# **Index one** is Maxwell's and Bingham's rule, with nothing left of the smoothing; **no yield stress** is the power
# law, in every region of the stress.

# %%
prove_equal(power_law_rate().subs({n: 1, K: eta}), maxwell_rate())
for stress in (sigma_Y + excess, -sigma_Y - excess, sigma_Y / 2, -sigma_Y / 2):
    one, other = (rule.subs(sigma, stress) for rule in (herschel_bulkley_rate(), bingham_rate()))
    prove_equal(one.subs({n: 1, K: eta}), sp.piecewise_fold(other))
for sign in (1, -1):
    prove_equal(
        herschel_bulkley_rate().subs(sigma_Y, 0).subs(sigma, sign * tensile),
        power_law_rate().subs(sigma, sign * tensile),
    )

# %% [markdown]
# ## From shear to tension
#
# In three dimensions the rule acts on the equivalent stress: $L^p = \frac32\varphi(\sigma_{eq})M'/\sigma_{eq}$. In
# simple shear $\sigma_{eq} = \sqrt3\,\tau$, and the shear rate $2L^p_{12}$ is $\sqrt3\,\varphi$.

# %%
tau = sp.Symbol("tau", positive=True)
shear = sp.Matrix([[0, tau, 0], [tau, 0, 0], [0, 0, 0]])
equivalent = bulk.equivalent_stress(shear)
prove_equal(equivalent, sp.sqrt(3) * tau)
phi = sp.Function("phi")
shear_rate = 2 * bulk.plastic_flow(shear, phi(sigma))[0, 1].subs(bulk.sigma_eq, equivalent)
prove_equal(shear_rate, sp.sqrt(3) * phi(sp.sqrt(3) * tau))

rate, tau_Y, k_shear, mu = sp.symbols("rate tau_Y k mu", positive=True)
measured = {
    # yield stress: where phi begins
    sigma_Y: sp.solve(sp.Eq(sp.sqrt(3) * tau_Y, sigma_Y), sigma_Y)[0],
    # Trouton: tau = mu times the shear rate
    eta: sp.solve(sp.Eq(rate, sp.sqrt(3) * (sp.sqrt(3) * mu * rate) / eta), eta)[0],
}
held = {sigma_Y: sp.sqrt(3) * tau_Y, eta: 3 * mu, K: 3 ** ((n + 1) / 2) * k_shear}
for constant, derived in measured.items():
    prove_equal(derived, held[constant])
# tau - tau_Y = k rate^n, put into the rule in tension
overstress = sp.sqrt(3) * (tau_Y + k_shear * rate**n) - held[sigma_Y]
in_shear = sp.sqrt(3) * (sp.expand(overstress) / held[K]) ** (1 / n)
prove_equal(sp.powsimp(sp.powdenest(sp.simplify(in_shear), force=True)), rate)
prove_equal(held[K].subs(n, 1) / k_shear, held[eta] / mu)

# %% [markdown]
# ## A wide sheet
#
# It cannot contract across its width: the width carries the stress $\sigma/2$ that stops its flow. Then
# $\sigma_{eq} = \frac{\sqrt3}2\sigma$ and $\dot\epsilon^p = r\varphi(r\sigma)$ with $r = \sqrt3/2$.

# %%
r = sp.sqrt(3) / 2
across = sp.Symbol("across", real=True)
wide = sp.diag(tensile, across, 0)
held_width = sp.solve(bulk.plastic_flow(wide, phi(sigma))[1, 1], across)
assert held_width == [tensile / 2]
wide = wide.subs(across, held_width[0])
prove_equal(bulk.equivalent_stress(wide), r * tensile)
prove_equal(bulk.plastic_flow(wide, phi(sigma))[0, 0].subs(bulk.sigma_eq, r * tensile), r * phi(r * tensile))

of_sheet = scaled(maxwell_means(RECTANGLE), r)
prove_equal(of_sheet.rate, sigma_0 / (sp.Rational(4, 3) * eta))
prove_equal(of_sheet.bending_rate, sigma_1 / (sp.Rational(4, 3) * eta))
wider = {sigma_Y: 2 / sp.sqrt(3) * sigma_Y, eta: sp.Rational(4, 3) * eta, K: (2 / sp.sqrt(3)) ** (n + 1) * K}
stress = sp.expand(2 / sp.sqrt(3) * (sigma_Y + excess))
for rule in (maxwell_rate(), bingham_rate(), herschel_bulkley_rate()):
    ours = without_smoothing(r * rule.subs(sigma, sp.expand(r * stress)))
    theirs = without_smoothing(rule.subs(wider, simultaneous=True).subs(sigma, stress))
    for index in (sp.Rational(1, 2), sp.Integer(1), sp.Integer(2)):
        prove_equal(ours.subs(n, index), theirs.subs(n, index))

# %% [markdown]
# ## Linear laws and their limits
#
# For a strain that grows as $e^{qt}$ a branch answers with the modulus $E_j q/(q + E_j/\eta_j)$. One mode is Maxwell; a
# stiff Maxwell fluid is Newtonian, with an error of $q\eta/E$; the standard linear solid is $E + E_2$ at once, $E$ in
# the end, and Kelvin-Voigt's for a stiff arm.

# %%
q = sp.Symbol("q", positive=True)


def complex_modulus(name: str, **options: int) -> sp.Expr:
    """Stress over strain where both grow as exp(q t)."""
    return modulus_of(law_of(name, **options))


def modulus_of(law: Law) -> sp.Expr:
    """The same of a law that is there already."""
    total = q * law.viscosity if law.viscosity is not None else sp.Integer(0)
    for branch in law.branches:
        fluidity = sp.diff(branch.flow.rate, sigma) if branch.flow is not None else 0
        # sigma_j = E_j (eps - eps_p), q eps_p = fluidity sigma_j
        total += branch.modulus / (1 + branch.modulus * fluidity / q)
    return total


maxwell, newtonian = complex_modulus("maxwell"), complex_modulus("newtonian")
zener, voigt = complex_modulus("standard-linear"), complex_modulus("kelvin-voigt")
prove_equal(complex_modulus("elastic"), E)
prove_equal(newtonian, eta * q)
prove_equal(voigt, E + eta * q)
prove_equal(maxwell, E * q / (q + E / eta))
prove_equal(newtonian / maxwell - 1, q * eta / E)
modulus, viscosity = mode(1)
prove_equal(complex_modulus("multimode-maxwell", modes=1).subs({modulus: E, viscosity: eta}), maxwell)
alike = {symbol: value for k in (1, 2, 3) for symbol, value in zip(mode(k), (E / 3, eta / 3), strict=True)}
prove_equal(complex_modulus("multimode-maxwell", modes=3).subs(alike), maxwell)
prove_equal(sp.limit(zener, E_2, sp.oo), voigt)
prove_equal(sp.limit(zener, q, sp.oo), E + E_2)
prove_equal(sp.limit(zener, q, 0), E)
prove_equal(sp.limit(maxwell, q, sp.oo), E)

# %% [markdown]
# A loss below yield stands beside spring and flow: a viscous stress $\eta_s\dot\epsilon$. Below yield the modulus is
# $E + i\omega\eta_s$, so that $\eta_s = \tan\delta\,E/\omega_1$ has the loss tangent $G''/G'$ at $\omega_1$.

# %%
omega, loss_tangent = sp.symbols("omega_1 tan_delta", positive=True)
damped = law_in_force(Terms(law=Rheology("bingham"), damped=True))
below_yield = modulus_of(damped).subs(q, sp.I * omega).subs(eta_s, loss_tangent * E / omega)
prove_equal(sp.im(below_yield) / sp.re(below_yield), loss_tangent)

# %% [markdown]
# ## The sagging string
#
# Without bending and inertia the horizontal tension $T$ is uniform, and $T y_{xx} = \rho g A$: a parabola that hangs
# $H$ below its supports.

# %%
x = sp.Symbol("x", real=True)
shape = 4 * H * (x / L) ** 2 - H
area, tension = sp.symbols("area tension", positive=True)
prove_equal(shape.subs(x, L / 2), 0)
carried = sp.solve(tension * sp.diff(shape, x, 2) - rho * g * area, tension)[0]
string_stress = carried / area
string_strain = sp.integrate(sp.diff(shape, x) ** 2 / 2, (x, -L / 2, L / 2)) / L
prove_equal(string_stress, rho * g * L**2 / (8 * H))
prove_equal(string_strain, sp.Rational(8, 3) * (H / L) ** 2)

# %% [markdown]
# **Elastic**: the stress is $E$ times the strain. **Power law**: $\epsilon_t = (\sigma/K)^{1/n}$ is separable in $H$;
# from a straight start it integrates to
# $$H^{2 + 1/n} = \frac{2n+1}{n}\,\frac{3L^2}{16}\left(\frac{\rho g L^2}{8K}\right)^{1/n} t.$$

# %%
at_rest = sp.solve(E * string_strain - string_stress, H)
prove_equal(at_rest[0] ** 3, sp.Rational(3, 64) * rho * g * L**4 / E)
prove_equal(closed_forms.elastic_string_sag() ** 3, at_rest[0] ** 3)

cost = sp.diff(string_strain, H) / (string_stress / K) ** (1 / n)  # dt/dH
time = sp.integrate(sp.powsimp(sp.powdenest(sp.expand_power_base(cost, force=True), force=True)), H)
assert sp.limit(time.subs(n, 2), H, 0) == 0  # straight at t = 0
for index in (sp.Rational(3, 10), sp.Rational(1, 2), sp.Integer(1), sp.Integer(2)):
    of_index = closed_forms.power_law_string_sag().subs(n, index)
    assert sp.simplify(time.subs(n, index).subs(H, of_index) / t - 1).equals(0)
    growth = sp.simplify(t * sp.diff(sp.log(of_index), t))
    prove_equal(growth, index / (2 * index + 1))
    print(f"n = {index}: H ~ t^({growth}),  H = {sp.simplify(of_index)}")

viscous = closed_forms.power_law_string_sag().subs({n: 1, K: eta})
prove_equal(viscous**3, sp.Rational(9, 128) * rho * g * L**4 * t / eta)
prove_equal(closed_forms.viscous_string_sag() ** 3, viscous**3)
