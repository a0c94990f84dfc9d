# ---
# jupyter:
#   jupytext:
#     text_representation:
#       extension: .py
#       format_name: percent
#   kernelspec:
#     display_name: Python 3
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 20. A filament with a temperature
#
# One temperature $\vartheta(X, t)$ over the section, along the filament. Proved here: the balance of heat of a filament
# that is drawn, per unit of rest length; the area through which heat passes; that what a modulus loses as it warms is
# found again as heat; closed forms that the tests hold runs against; that the laws of Vogel, Fulcher and Tammann, of
# Williams, Landel and Ferry, and of Arrhenius are one family; and what Churchill and Chu's coefficient is for a fibre.
#
# A kelvin and a mole count as pure numbers in the dimensions of the table of symbols.
#
# Effects derived here: `temperature` (`heat.lateral_area`).

# %%
import sympy as sp
from proving import prove_equal, vanishes

from softcat_sym.physics import heat
from softcat_sym.physics.loads import SURFACES
from softcat_sym.physics.necking import aspect
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.symbols import A0, X, h0, rho, s, t

# %% [markdown]
# ## The balance of heat
#
# A slice of the drawn filament, $\mathrm d\ell = s\,\mathrm dX$ long, of area $A = A_0/s$ and perimeter
# $P = P_0/\sqrt s$, holds $\rho c_p A\,\mathrm d\ell\,\vartheta$, gains what it dissipates, loses
# $h_T P\,\mathrm d\ell\,(\vartheta - \vartheta_a)$ through its surface, and conducts
# $-k A\,\partial\vartheta/\partial\ell$. We divide by $\mathrm dX$: the mass of a unit of rest length stays, the
# surface grows as $\sqrt s$, and heat is conducted as by $k A_0/s^2$.

# %%
T, stretch = (sp.Function(name, positive=True)(X, t) for name in ("theta", "s"))
source, coefficient = heat.heat_source, heat.transfer
area, perimeter = A0 / stretch, 4 * A0 / h0 / sp.sqrt(stretch)
flux = -heat.conductivity * area * sp.diff(T, X) / stretch  # d/dl = d/(s dX)
held = rho * heat.heat_capacity * area * stretch * sp.diff(T, t)
balance = held - (source - coefficient * perimeter * stretch * (T - heat.ambient) - sp.diff(flux, X))
stored, conducted = rho * heat.heat_capacity * A0 * sp.diff(T, t), heat.conductivity * A0 / stretch**2 * sp.diff(T, X)
passed = coefficient * 4 * A0 / h0 * sp.sqrt(stretch) * (T - heat.ambient)
prove_equal(balance, stored - (source - passed + sp.diff(conducted, X)))

# %% [markdown]
# The package takes the lateral area from the energy of the surface, $\gamma$ times that area: of a circle and of a
# rectangle the perimeter shrinks as $1/\sqrt s$, a sheet has two faces of a width that is held.

# %%
expected = {
    "circle": 4 / h0 * sp.sqrt(s),
    "rectangle": 2 * (1 / h0 + 1 / (aspect * h0)) * sp.sqrt(s),
    "sheet": 2 / h0 * s,
}
for name, over_volume in expected.items():
    prove_equal(heat.lateral_area(SECTIONS[name], thins=True), over_volume)
    prove_equal(heat.lateral_area(SECTIONS[name], thins=False), over_volume.subs(s, 1))
assert set(expected) == set(SURFACES)

# %% [markdown]
# ## A modulus that changes
#
# The stored energy is $W = m(\vartheta)\,w$, with $w$ of the strains and the plastic state. Of its rate the part
# $w\,m'\vartheta_t$ is no work of the stress. If the balance of heat has $-W (m'/m)\,\vartheta_t$ beside what is
# dissipated, the sum of stored energy and heat changes by the power of the stress and by what passes the surface, and
# by nothing else: the first law. The same holds of an expansion, with $-\partial_\vartheta W\,\vartheta_t$. (The stress
# is the derivative of $W$ at constant temperature; that a spring also cools as it is stretched, by
# $\vartheta\,\partial_\vartheta\sigma\,\varepsilon_t$, is left out.)

# %%
strain, plastic, kelvin = (sp.Function(name)(t) for name in ("eps", "a", "theta"))
m, E, viscosity, lost = sp.Function("m")(kelvin), *sp.symbols("E eta q", positive=True)
stored = m * E * (strain - plastic) ** 2 / 2
stress = m * E * (strain - plastic)
flow = {sp.Derivative(plastic, t): stress / viscosity}
dissipated = stress**2 / viscosity
capacity = rho * heat.heat_capacity
softening = sp.diff(stored, kelvin)
prove_equal(softening, stored * sp.diff(m, kelvin) / m)
warming = (dissipated - lost) / (capacity + softening)
rate = sp.diff(stored + capacity * kelvin, t).subs(flow).subs(sp.Derivative(kelvin, t), warming)
prove_equal(sp.simplify(rate.doit()), stress * sp.diff(strain, t) - lost)

# %% [markdown]
# ## Closed forms
#
# Newton's cooling of a round bar; the Maxwell bar that is stretched by $\epsilon$, held and insulated; a cosine of the
# temperature along an insulated bar; the lag behind surroundings that warm at a constant rate; and the fin, a long
# fibre half of which is in a furnace.

# %%
time, length, mode, pace = sp.symbols("t L n b", positive=True)
start, around = heat.initial, heat.ambient
d = h0
tau = rho * heat.heat_capacity * d / (4 * coefficient)
cooled = around + (start - around) * sp.exp(-time / tau)
assert vanishes(capacity * sp.diff(cooled, time) + 4 * coefficient / d * (cooled - around))

modulus, epsilon = sp.symbols("E epsilon", positive=True)
relaxing = modulus * epsilon * sp.exp(-modulus * time / viscosity)
warmer = modulus * epsilon**2 / 2 * (1 - sp.exp(-2 * modulus * time / viscosity)) / capacity
assert vanishes(capacity * sp.diff(warmer, time) - relaxing**2 / viscosity)

decay = heat.conductivity * (mode * sp.pi / length) ** 2 / capacity
wave = sp.cos(mode * sp.pi * X / length) * sp.exp(-decay * time)
assert vanishes(capacity * sp.diff(wave, time) - heat.conductivity * sp.diff(wave, X, 2))

following = pace * (time - tau * (1 - sp.exp(-time / tau)))
assert vanishes(tau * sp.diff(following, time) - (pace * time - following))

reach = sp.sqrt(heat.conductivity * d / (4 * coefficient))
inside = around + (heat.outside - around) / 2 * sp.exp(X / reach)  # X < 0
outside = heat.outside - (heat.outside - around) / 2 * sp.exp(-X / reach)
for side, far in ((inside, around), (outside, heat.outside)):
    assert vanishes(heat.conductivity * sp.diff(side, X, 2) - 4 * coefficient / d * (side - far))
assert vanishes((inside - outside).subs(X, 0))
assert vanishes(sp.diff(inside - outside, X).subs(X, 0))

# %% [markdown]
# ## Laws of the viscosity
#
# VFT, $\log_{10}\eta = A + B/(\vartheta - T_0)$, over its value at $\vartheta_r$ is WLF with
# $C_1 = B/(\vartheta_r - T_0)$ and $C_2 = \vartheta_r - T_0$; with $T_0 = 0$ it is Arrhenius with the activation
# temperature $B\ln 10$. All are one at the reference.

# %%
vft = heat.shift("vft", by_reference=True)
above = heat.reference - heat.T_V
wlf = heat.shift("wlf", by_reference=True).subs({heat.C_1: heat.B_V / above, heat.C_2: above})
assert vanishes(sp.log(vft).expand(force=True) - sp.log(wlf).expand(force=True)) or vanishes(
    sp.simplify(sp.expand_log(sp.log(vft / wlf), force=True))
)
arrhenius = heat.shift("arrhenius", by_reference=True)
limit = sp.expand_log(sp.log(vft.subs(heat.T_V, 0) / arrhenius.subs(heat.B_A, heat.B_V * sp.log(10))), force=True)
assert vanishes(limit)
for law in ("vft", "wlf", "arrhenius"):
    assert vanishes(heat.shift(law, by_reference=True).subs(heat.temperature, heat.reference) - 1)

# %% [markdown]
# ## A thin fibre in still air
#
# Churchill and Chu (1975): $\mathrm{Nu} = (0.60 + 0.387\,\mathrm{Ra}^{1/6}/(1 + (0.559/\mathrm{Pr})^{9/16})^{8/27})^2$,
# of the mean of both temperatures. Of the sixth root the difference of temperature is rounded within 0.01 K, since its
# slope at none is infinite. Air is that of the U.S. Standard Atmosphere (1976).
#
# The thinner a fibre, the smaller its Rayleigh number and the nearer its Nusselt number to $0.6^2$: its coefficient
# grows as $0.36\,k/d$.

# %%
given = {heat.temperature: 320, heat.around: 300, s: 1, sp.Symbol("g", positive=True): sp.Float("9.81")}
conducts = float(heat.air(sp.Integer(310))[0])
numbers = [float(heat.cylinder_in_air().subs(given).subs(h0, one)) * one / conducts for one in (1e-2, 1e-4, 1e-8)]
print("Nu of 10 mm, 0.1 mm and 10 nm:", [f"{number:.3f}" for number in numbers])
assert numbers[0] > numbers[1] > numbers[2] > 0.36
assert abs(numbers[2] - 0.36) < 1e-2
