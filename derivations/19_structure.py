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
# # 19. Structure: materials that build up at rest and break down in flow
#
# Fresh concrete, pastes and gels gain yield stress while they rest and lose it where they flow. One structure parameter
# $\lambda$ at every point, 0 destroyed and 1 built up, follows
#
# $$\dot\lambda = \frac{1 - \lambda - \lambda\,(\tau\,|\dot\epsilon^p|)^c}{t_b},$$
#
# Moore's kinetics (1959) with the power of de Souza Mendes and Thompson (2013). Proved here: where it comes to rest,
# that it never leaves $[0, 1]$, that rest is an exponential, that Roussel's linear growth (2006) is its beginning, how
# numbers of a rheometer in shear convert, and that yield stress and viscosity are what the scene states at the start.
#
# Effects derived here: `structure` (`clocks.build_up_rate`, `clocks.structure_clock`) and
# `backstress` (`hardening_rule.back_rate`, `reissner.hardened`).

# %%
import sympy as sp
from proving import prove_equal

from softcat_sym.physics import clocks as st
from softcat_sym.physics.symbols import eta, sigma_Y

# %% [markdown]
# ## Where it comes to rest, and that it stays between 0 and 1
#
# With $b = (\tau |\dot\epsilon^p|)^c \geq 0$ the rate vanishes at $\lambda = 1/(1 + b)$, is not negative at
# $\lambda = 0$ and not positive at $\lambda = 1$: the interval is never left.

# %%
b = sp.Symbol("b", nonnegative=True)
rate = st.build_up_rate(linear=False).subs(st.breakdown(), b)
(settled,) = sp.solve(rate, st.lam)
prove_equal(settled, 1 / (1 + b))
prove_equal(rate.subs(st.lam, 0), 1 / st.t_b)
prove_equal(rate.subs(st.lam, 1), -b / st.t_b)

# %% [markdown]
# The power is rounded at rest, where its slope would be infinite for $c < 1$: by $10^{-16}$ where $\tau
# |\dot\epsilon^p|$ is of order one.

# %%
plain = (st.tau_b * st.speed) ** st.exponent
numbers = {st.tau_b: 2.0, st.speed: 0.5, st.exponent: sp.Rational(1, 2)}
assert abs(st.breakdown().subs(numbers) / plain.subs(numbers) - 1) < 1e-15
prove_equal(st.breakdown().subs(st.speed, 0), 0)

# %% [markdown]
# ## Rest
#
# Without flow $\lambda = 1 - (1 - \lambda_i)\,e^{-t/t_b}$; without a limit it grows by $t/t_b$. Both begin alike: of a
# destroyed material Roussel's $A_{thix}$ is the yield stress gained over $t_b$.

# %%
start, time = sp.Symbol("lambda_0"), st.rest
for linear in (False, True):
    law = st.build_up_rate(linear=linear).subs(st.speed, 0)
    grown = st.rested(start, linear=linear)
    prove_equal(sp.diff(grown, time), sp.simplify(law.subs(st.lam, grown)))
    prove_equal(grown.subs(time, 0), start)
first = [sp.series(st.rested(sp.S.Zero, linear=linear), time, 0, 2).removeO() for linear in (False, True)]
prove_equal(first[0], first[1])

# %% [markdown]
# ## What the scene states
#
# Yield stress and viscosity are linear in $\lambda$ (Houska 1981), and those of `[material]` at the start: with both
# ends of the yield stress given, $\lambda_i = (\sigma_Y - \sigma_{Yd})/(\sigma_{Ys} - \sigma_{Yd})$.

# %%
given = frozenset({"build_up_time", "breakdown_time", "exponent", "structured_yield_stress", "destroyed_yield_stress"})
clock = st.structure_clock(given | {"structured_viscosity"}, linear=False)
made, state = dict(clock.replaces), clock.state
high, low = st.yield_ends
begin = (sigma_Y - low) / (high - low)
prove_equal(state.value.subs(st.change, 0), begin)
prove_equal(made[sigma_Y].subs(st.change, 0), sigma_Y)
for end, value in ((1, high), (0, low)):
    prove_equal(made[sigma_Y].subs(st.change, end - begin), value)
prove_equal(made[eta].subs(st.change, 0), eta)
prove_equal(made[eta].subs(st.change, 1 - begin), st.viscosity_ends[0])

# %% [markdown]
# ## Shear and tension
#
# By von Mises' equivalence $\dot\gamma = \sqrt3\,|\dot\epsilon^p|$, $\sigma = \sqrt3\,\tau$: $(\tau_s \dot\gamma)^c$ is
# $(\sqrt3\,\tau_s |\dot\epsilon^p|)^c$, so that a time of breakdown in shear is $\sqrt3$ times as long in tension.

# %%
in_shear = sp.Symbol("tau_s", positive=True)
both = (in_shear * sp.sqrt(3) * st.speed) ** st.exponent
prove_equal(both, plain.subs(st.tau_b, sp.sqrt(3) * in_shear))

# %% [markdown]
# ## Backstress
#
# A fibre flows by $\sigma - \chi$, $\chi = C A$, and $\dot A = D - q A |D|$ (Armstrong and Frederick). Power of the
# stresses in the plastic rates is that of the flow, $\sigma_{eq}|D|$, what is stored, and $q C A^2 |D| \geq 0$: with
# the shear, whose rate $\dot\gamma^p + c\gamma^p\dot\epsilon^p$ works against $\tau_d$, and where the width is held.

# %%
from softcat_sym.physics import hardening_rule, reissner
from softcat_sym.physics.bulk import sigma_eq
from softcat_sym.physics.symbols import sigma

phi = sp.Symbol("phi", nonnegative=True)
for share in (sp.S.One, sp.Rational(3, 4)):
    flow, hardening = reissner.hardened(reissner.fibre_flow(phi, share), share)
    sheared = flow.shear_rate[0] + reissner.CARRY * reissner.gamma_p * flow.axial_rate
    power = sigma * flow.axial_rate + reissner.tau_d * sheared
    stored = sum(
        sp.diff(hardening.stored, one) * rate
        for one, rate in zip((hardening_rule.axial, hardening_rule.shear), hardening.rates, strict=True)
    )
    lost = flow.dissipation - flow.speed * sigma_eq
    driving = phi * flow.equivalent**2 / sigma_eq
    prove_equal(sp.expand(power - stored - driving - lost), 0)
    prove_equal(sp.expand(lost - 2 * hardening_rule.recovery * phi * hardening.stored), 0)

# %% [markdown]
# Flow one way by a plastic strain $e$: $\chi = C (1 - e^{-q e})/q$, at length $C/q$, or $C e$ (Prager). In
# shear, $\alpha = \chi/\sqrt3$ and $\gamma^p = \sqrt3 e$: $C_s = C/3$, $q_s = q/\sqrt3$.

# %%
e = sp.Symbol("e", positive=True)
back = (1 - sp.exp(-hardening_rule.recovery * e)) / hardening_rule.recovery
prove_equal(sp.diff(back, e), hardening_rule.back_rate(sp.S.One, back, sp.S.One))
prove_equal(sp.limit(back, hardening_rule.recovery, 0), e)
