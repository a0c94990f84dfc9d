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
# # 22. Conformation
#
# A polymer solution is chains in a solvent. The conformation tensor $A$ of the chains is carried by the flow and
# relaxes to $1$: $\overset{\nabla}{A} = -\frac1\lambda Y\,(fA-1)(1+\alpha(A-1))$, with the stress $G(fA-1)$ beside the
# solvent's. Here $A$ is diagonal in the axes of a fibre, and the law becomes one of a stored energy and of a rate that
# knows no rate of strain: that of a generalised standard material, as every other law of this package.
#
# Laws derived here: `oldroyd-b`, `fene-p`, `giesekus`, `ptt` (`polymer_chains.respond`).

# %%
import sympy as sp
from proving import prove_equal

from softcat_sym.physics import polymer_chains as co
from softcat_sym.physics.sections import CIRCLE, SHEET
from softcat_sym.physics.symbols import E

t, a = sp.symbols("t a", positive=True)
eps = sp.Function("epsilon")(t)
LAWS = {"oldroyd-b": co.OLDROYD_B, "fene-p": co.FENE_P, "giesekus": co.GIESEKUS, "ptt": co.PTT}

# %% [markdown]
# ## The upper-convected derivative without a rate of strain
#
# A fibre drawn at $\dot\epsilon$ has $L = \mathrm{diag}(1,-\frac12,-\frac12)\,\dot\epsilon$, of a sheet
# $\mathrm{diag}(1,-1,0)\,\dot\epsilon$. With $A_i = e^{p_i\epsilon-b_i}$, $p_i$ twice the entries of $L/\dot\epsilon$,
# convection is the strain itself, and what is left of the law is the rate of $b_i$.

# %%
for section, shape in ((CIRCLE, (1, -sp.Rational(1, 2))), (SHEET, (1, -1, 0))):
    for chains in LAWS.values():
        response = co.respond(section, chains)
        taken = {one.taken: sp.Function(f"b_{one.name}")(t) for one in response.directions}
        given = {co.strain: eps, **taken}
        A = [extension.xreplace(given) for extension in response.extensions]
        trace = sp.Add(*(one.count * value for one, value in zip(response.directions, A, strict=True)))
        f = chains.spring_factor.xreplace({co.trace: trace})
        Y = chains.haste.xreplace({co.trace: trace})
        for one, value, pull, rate in zip(response.directions, A, shape, response.rates, strict=True):
            moved = sp.diff(value, t).xreplace({sp.diff(taken[one.taken], t): response.of_states(rate).xreplace(given)})
            drag = 1 + chains.anisotropy * (value - 1)
            relaxed = -Y * (f * value - 1) * drag / co.relaxation_time
            prove_equal(moved, 2 * pull * sp.diff(eps, t) * value + relaxed)

# %% [markdown]
# ## Stress and dissipation follow from one energy
#
# $W = \frac G2\,(U(\mathrm{tr} A) - \log\det A)$ with $f = U'$: $\sigma = \partial W/\partial\epsilon$ is the
# difference $G f (A_{zz}-A_{rr})$ that pulls a fibre whose sides are free. Since a fibre keeps its volume,
# $\log\det A$ is minus the sum of the $b_i$.

# %%
for section in (CIRCLE, SHEET):
    for chains in LAWS.values():
        response = co.respond(section, chains)
        along, across = response.directions[:2]
        prove_equal(response.of_states(response.stress), sp.diff(response.stored, co.strain))
        prove_equal(response.stress, E / 3 * co.spring_factor * (along.extension - across.extension))
        lost = -sp.Add(
            *(
                sp.diff(response.stored, one.taken) * response.of_states(rate)
                for one, rate in zip(response.directions, response.rates, strict=True)
            )
        )
        prove_equal(lost, response.of_states(response.dissipation))

# %% [markdown]
# The dissipation is a sum of $\frac G2\,(fA_i-1)^2\,Y\,(1+\alpha(A_i-1))/(\lambda A_i)$: never negative, since $Y>0$,
# $f>0$ and $0<\alpha<1$ with $A_i>0$.

# %%
response = co.respond(CIRCLE, co.GIESEKUS)
squares = [
    one.count * (co.spring_factor * one.extension - 1) ** 2 * (1 + co.mobility * (one.extension - 1)) / one.extension
    for one in response.directions
]
prove_equal(response.dissipation, E / 6 * sp.Add(*squares) / co.relaxation_time)

# %% [markdown]
# ## At small strain all of them are Maxwell
#
# $\sigma = E(\epsilon - b)$ at first order, with the time $\lambda$ and the viscosity $E\lambda$; of a sheet $\frac43$
# of both.

# %%
small = sp.Symbol("delta")
for section, factor in ((CIRCLE, 1), (SHEET, sp.Rational(4, 3))):
    for chains in LAWS.values():
        response = co.respond(section, chains)
        # Every b_i is p_i times the flow b of a Maxwell fibre, up to second order.
        flown = sp.Symbol("b")
        given = {co.strain: small * a} | {one.taken: small * one.power * flown for one in response.directions}
        stress = sp.diff(response.stored, co.strain).subs(given)
        prove_equal(stress.subs(small, 0), 0)
        prove_equal(sp.diff(stress, small).subs(small, 0), factor * E * (a - flown))
        for one, rate in zip(response.directions, response.rates, strict=True):
            found = response.of_states(rate).subs(given)
            prove_equal(found.subs(small, 0), 0)
            prove_equal(sp.diff(found, small).subs(small, 0), one.power * (a - flown) / co.relaxation_time)

# %% [markdown]
# ## Start-up of Oldroyd-B
#
# At a steady rate with $\mathrm{Wi} = \lambda\dot\epsilon$ the conformation along the fibre grows without bound from
# $\mathrm{Wi} = \frac12$ on: coils are stretched out.

# %%
Wi, lam = sp.Symbol("Wi", positive=True), co.relaxation_time
along = (1 - 2 * Wi * sp.exp(-(1 - 2 * Wi) * t / lam)) / (1 - 2 * Wi)
across = (1 + Wi * sp.exp(-(1 + Wi) * t / lam)) / (1 + Wi)
for value, power in ((along, 2), (across, -1)):
    prove_equal(sp.diff(value, t), power * Wi / lam * value - (value - 1) / lam)
    prove_equal(value.subs(t, 0), 1)

# %% [markdown]
# ## A thread that its surface drains
#
# Entov & Hinch (1997): a thread of radius $R$ between drops, thin beside them, is pulled by a force in proportion to
# $\gamma R$, and nothing but $G A_{zz}$ resists: $G A_{zz} \propto \gamma/R$. With $\dot R/R = -\dot\epsilon/2$ and
# $\dot A_{zz} = (2\dot\epsilon - 1/\lambda) A_{zz}$ it thins at $\dot\epsilon = 2/(3\lambda)$, above the coil-stretch
# rate: $R \propto e^{-t/(3\lambda)}$, and $A_{rr}$ tends to $1/(1+\frac23) = \frac35$.

# %%
rate = sp.Symbol("rate", positive=True)
(thinning,) = sp.solve(sp.Eq(2 * rate - 1 / lam, rate / 2), rate)
prove_equal(thinning, sp.Rational(2, 3) / lam)
prove_equal(sp.limit(across.subs(Wi, sp.Rational(2, 3)), t, sp.oo), sp.Rational(3, 5))

# %% [markdown]
# ## The viscosity of FENE-P is bounded
#
# $A_{zz} = 1/(f-2\,\mathrm{Wi})$, $A_{rr} = 1/(f+\mathrm{Wi})$. As Wi grows $f$ follows $2\,\mathrm{Wi}$, $A_{zz}$
# tends to $L^2$, and the tensile viscosity to $2G\lambda L^2$, instead of $3G\lambda$ at rest.

# %%
f = sp.Symbol("f", positive=True)
for power, value in ((2, 1 / (f - 2 * Wi)), (-1, 1 / (f + Wi))):
    prove_equal(power * Wi * value - (f * value - 1), 0)
L2 = co.extensibility
excess = sp.Symbol("excess", positive=True)
drawn = {f: 2 * Wi + excess}
trace = (1 / (f - 2 * Wi) + 2 / (f + Wi)).subs(drawn)
# f (L^2 - tr A) = L^2 - 3 with f ~ 2 Wi: tr A tends to L^2, so that the excess tends to 1/L^2.
prove_equal(sp.limit(trace, Wi, sp.oo), 1 / excess)
viscosity = (f * (1 / (f - 2 * Wi) - 1 / (f + Wi)) / Wi).subs(drawn)
prove_equal(sp.limit(viscosity, Wi, sp.oo).subs(excess, 1 / L2), 2 * L2)
