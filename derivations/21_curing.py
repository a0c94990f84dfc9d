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
# # 21. Curing and shrinking
#
# A material that dries, sets or cures while it hangs has constants that change in time, and another length at which it
# is without stress. What a growing modulus does to a strain that is there already, what a falling one does, what work
# that is, and how a section shrinks and curls.
#
# Effects derived here: `curing` (`section_response.respond`, `reissner.growing`) and `natural-strain`
# (`section_response.natural_strains`, `section_response.shrunk`).

# %%
import sympy as sp
from proving import prove_equal

from softcat_sym.physics import bulk, constitutive_laws, reissner, symbols
from softcat_sym.physics.kinematics import TRUE_STRAIN
from softcat_sym.physics.section_response import SectionShape, natural_strains, respond, shrunk
from softcat_sym.physics.section_response import material as closure
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.terms import Course, Terms

t, tau = sp.symbols("t tau", positive=True)
E, eps = sp.Function("E")(t), sp.Function("epsilon")(t)
sigma = sp.Function("sigma")(t)

# %% [markdown]
# ## Springs that join
#
# In a network that cures, strands join that are without stress in the shape which they find: each pulls by what the
# network has been strained since (transient networks, Castonguay et al. 2025). A spring that joined at $\tau$ carries
# $dE(\tau)\,(\epsilon(t)-\epsilon(\tau))$, so that of linear springs
#
# $$\sigma(t) = E(0)\epsilon(t) + \int_0^t \dot E(\tau)\,(\epsilon(t)-\epsilon(\tau))\,d\tau, \qquad
# \dot\sigma = E(t)\,\dot\epsilon.$$
#
# At a strain that is held the stress stays: a modulus that grows does not pull up what hangs. ($\sigma = E(t)\epsilon$
# would: it gives springs that join the stress of those that were there.) The proof takes powers of time for both.

# %%
for E_of, eps_of in ((1 + 3 * tau, tau**2), (2 + tau**2, 1 + tau**3), (1 + tau**3, sp.exp(-tau))):
    joined = E_of.subs(tau, 0) * eps_of.subs(tau, t)
    joined += sp.integrate(sp.expand(sp.diff(E_of, tau) * (eps_of.subs(tau, t) - eps_of)), (tau, 0, t))
    prove_equal(sp.diff(joined, t), (E_of * sp.diff(eps_of, tau)).subs(tau, t))

# %% [markdown]
# A plastic strain $a$ of the one spring $\sigma = E(\epsilon-a)$ that follows the strain at the rate $g = \dot E/E$
# says the same: $\dot a = g\,\sigma/E$, a dashpot of the viscosity $E^2/\dot E$ in line with it. It adds to what flows.

# %%
a = eps - sigma / E
rate = sp.diff(E, t) / E * sigma / E
held = sp.diff(eps, t) - sp.diff(sigma / E, t)
(stress_rate,) = sp.solve(held - rate, sp.diff(sigma, t))
prove_equal(stress_rate, E * sp.diff(eps, t))

# %% [markdown]
# Springs that break let go of what they carry: of a modulus that falls each strand's share is lost, $\dot\sigma =
# E\dot\epsilon + (\dot E/E)\sigma$, so that $a$ stays. The rate of $a$ is therefore $\max(\dot E, 0)/E$ times
# $\sigma/E$.

# %%
(stress_rate,) = sp.solve(held, sp.diff(sigma, t))
prove_equal(stress_rate, E * sp.diff(eps, t) + sp.diff(E, t) / E * sigma)

# %% [markdown]
# The section of the package has this term, of any law, beside what flows.

# %%
growth = constitutive_laws.growth_of(symbols.E)
for law in (constitutive_laws.law_of("elastic"), constitutive_laws.law_of("maxwell")):
    branch = constitutive_laws.Branch(flow=law.branches[0].flow, growth=growth)
    terms = Terms(bending=True, stretches=True, natural_strain=(Course("natural_strain"),))
    outline = SectionShape(SECTIONS["rectangle"], SECTIONS["rectangle"].contraction, TRUE_STRAIN, terms)
    section = respond(outline, closure(TRUE_STRAIN, outline.contraction), constitutive_laws.Law("curing", (branch,)))
    flows = symbols.sigma_0 / symbols.eta if law.flows else 0
    prove_equal(section.branch.rate_mean, flows + growth * symbols.sigma_0 / symbols.E)
    fibre = reissner.growing(None, growth)
    prove_equal(fibre.axial_rate, growth * reissner.eps_e)

# %% [markdown]
# Of a fibre that shears the elastic shear is $\gamma_e = \gamma-\gamma_p e^{-c\epsilon_e}$. Its plastic shear follows
# so that at held strains both elastic strains fade at $g$, and with a modulus that grows at $g$ both stresses stay.

# %%
c, held_shear, g = reissner.CARRY, sp.Symbol("gamma", real=True), growth
gone = {reissner.eps_e: -g * reissner.eps_e}
elastic_shear = held_shear - reissner.gamma_p * sp.exp(-c * reissner.eps_e)
fading = sp.diff(elastic_shear, reissner.gamma_p) * fibre.shear_rate[0]
fading += sp.diff(elastic_shear, reissner.eps_e) * gone[reissner.eps_e]
prove_equal(fading.subs(reissner.gamma_e, elastic_shear), -g * elastic_shear)

# %% [markdown]
# ## The audit
#
# With $W = E(\epsilon-a)^2/2$, $\dot W = \sigma\dot\epsilon - \sigma\dot a + \dot E(\epsilon-a)^2/2$: the last term is
# `work_ageing`, what the energy of a strain that is held gains; the second is counted as dissipated. Where springs join
# they are $-\sigma\dot a + \dot E\sigma^2/(2E^2) = -\dot E\sigma^2/(2E^2)$ together: no heat, but what springs of other
# lengths hold against each other and never give back as one. Where springs break it is lost.

# %%
W = sigma**2 / (2 * E)
ageing = sp.diff(E, t) * (sigma / E) ** 2 / 2
balance = sp.diff(W, t) - sigma * sp.diff(eps, t) + sigma * rate - ageing
prove_equal(balance.subs(sp.diff(sigma, t), E * sp.diff(eps, t)), 0)
locked = -sigma * rate + ageing
prove_equal(locked, -sp.diff(E, t) * sigma**2 / (2 * E**2))

# %% [markdown]
# ## Shrinking and curling
#
# A natural strain $\epsilon^n_0 + \epsilon^n_1\zeta$ is that at which a fibre is without stress. Free, the filament
# takes it: $\log s = \epsilon^n_0$, and a curvature $-2\epsilon^n_1/h$ of the section as it then is.

# %%
stretch, turn = symbols.s, symbols.theta_X
mean, more = natural_strains(SECTIONS["rectangle"])
at_rest = {stretch: sp.exp(mean), symbols.a_0: 0, symbols.a_1: 0}
prove_equal(section.branch.stress_mean.subs(at_rest), 0)
(curl,) = sp.solve(section.branch.stress_bending.subs(symbols.a_1, 0), turn)
thickness = symbols.h0 / sp.sqrt(stretch)
prove_equal(curl / stretch, -2 * more / thickness)

# %% [markdown]
# A section that shrinks alike in all directions has the volume $e^{3\epsilon^n_0}$; held at the stretch $s$ it keeps
# it, $A = A_0e^{3\epsilon^n_0}/s$, and free it is smaller by $e^{\epsilon^n_0}$ each way.

# %%
area, thinner = shrunk(SECTIONS["circle"])
free = {stretch: sp.exp(symbols.n_0)}
prove_equal((area / stretch).subs(free), sp.exp(2 * symbols.n_0))
prove_equal((thinner / sp.sqrt(stretch)).subs(free), sp.exp(symbols.n_0))
area, thinner = shrunk(SECTIONS["sheet"])
prove_equal((thinner / stretch).subs(free), sp.exp(symbols.n_0))

# %% [markdown]
# A sheet is too wide to curl across. With $\epsilon_y$ held at the mean natural strain, plane stress $\sigma_z = 0$
# gives $\sigma = E/(1-\nu^2)\,(\epsilon - \epsilon^n_0 - (1+\nu)\epsilon^n_1\zeta)$: what is more at the top counts 1 +
# nu times, since it pulls across too, and what is alike everywhere once, since the width becomes smaller with it.

# %%
nu, zeta, along = sp.symbols("nu zeta epsilon_x")
n_0, n_1 = symbols.n_0, symbols.n_1
natural = n_0 + n_1 * zeta
biaxial = symbols.E / (1 - nu**2) * ((along - natural) + nu * (n_0 - natural))
mean, more = (one.subs(bulk.nu, nu) for one in natural_strains(SECTIONS["sheet"]))
prove_equal(biaxial, symbols.E / (1 - nu**2) * (along - mean - more * zeta))

# %% [markdown]
# A stress that resists the rate of strain resists $\dot\epsilon - \dot\epsilon^n$: of the Rayleigh potential $\eta
# (\dot\epsilon-\dot\epsilon^n)^2/2$ twice is dissipated, and the rest of the power, $-\sigma\dot\epsilon^n$, is worked
# by the shrinking.

# %%
eta, moved, shrinks = sp.symbols("eta epsilon_t n_t")
rayleigh = eta * (moved - shrinks) ** 2 / 2
power = sp.diff(rayleigh, moved) * moved
prove_equal(power - 2 * rayleigh, -sp.diff(rayleigh, shrinks) * shrinks)

# %% [markdown]
# ## A bar in its own weight whose yield stress grows
#
# $\sigma = \rho g(L-X)$ and $\sigma_Y = s_0 + rt$: a section flows until $t = (\sigma-s_0)/r$ by
# $(\sigma-s_0)^2/(2r\eta)$ in all, the bar by $(\rho gL-s_0)^3/(6r\eta\rho g)$. `tests/slow/test_clocks.py` holds the
# package against it.

# %%
weight, length, s_0, r, X = sp.symbols("q L s_0 r X", positive=True)
overstress = weight * (length - X) - s_0
strain = sp.integrate((overstress - r * t) / eta, (t, 0, overstress / r))
prove_equal(strain, overstress**2 / (2 * r * eta))
whole = sp.integrate(sp.expand(overstress**2 / (2 * r * eta)), (X, 0, length - s_0 / weight))
prove_equal(whole, (weight * length - s_0) ** 3 / (6 * r * eta * weight))
