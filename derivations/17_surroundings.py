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
# # 17. What surrounds a filament: buoyancy, drag, added mass
#
# A strand in a bath is carried, slowed down and made heavier by what surrounds it. Each follows from one density of a
# unit of rest length: an energy $W$, a Rayleigh potential $R$, a kinetic energy $T$. Proved here: that the pressure of
# a bath leaves its weight and nothing else; that the potentials give the forces which the literature states; that the
# kinetic energy gives Lighthill's reactive force, and what the mass of a node becomes.
#
# Effects derived here: `buoyancy` (`surroundings.BUOYANT`), `drag` (`surroundings.SLENDER`,
# `surroundings.CROSS_FLOW`), `added-mass` (`surroundings.ADDED`).

# %%
import sympy as sp
from proving import prove_equal, vanishes

from softcat_sym.physics.densities import outer_force, outer_momentum
from softcat_sym.physics.necking import aspect
from softcat_sym.physics.surroundings import ADDED, BUOYANT, CROSS_FLOW, SLENDER, across, along
from softcat_sym.physics.symbols import A0, L_0, X, g, g_t, h0, mu_b, rho_b, s, t, x_t, x_X, y_t, y_X

stretch = sp.sqrt(x_X**2 + y_X**2)

# %% [markdown]
# ## Buoyancy
#
# A bath at rest presses with $p = -\rho_b g y$. We let it press on a piece of a tube whose radius $R(\ell)$ changes
# and whose axis rises at an angle $\alpha$, and integrate over the surface, point by point. The result is the weight of
# what the piece displaces, upwards, and what the pressure on two cuts would do,
# $\mathrm d(pA\,\mathbf t)/\mathrm d\ell$. The second joins the tension: the force $A\sigma_{xx} + pA$ is the one that
# a stress difference $\sigma_{xx} - \sigma_{rr}$ makes, with $\sigma_{rr} = -p$ at the surface. The law of a fibre is
# one of that difference, so the section feels nothing of the pressure, at any depth.

# %%
length, angle, phi = sp.symbols("ell alpha phi", real=True)
R = sp.Function("R", positive=True)(length)
tangent = sp.Matrix([sp.cos(angle), sp.sin(angle), 0])
normal, binormal = sp.Matrix([-sp.sin(angle), sp.cos(angle), 0]), sp.Matrix([0, 0, 1])
radial = sp.cos(phi) * normal + sp.sin(phi) * binormal
surface = length * tangent + R * radial
outward = sp.diff(surface, phi).cross(sp.diff(surface, length))  # Normal times the area
assert vanishes(outward.dot(radial) - R)
pressure = -rho_b * g * surface[1]
pushed = -(pressure * outward).applyfunc(lambda term: sp.integrate(sp.expand(term), (phi, 0, 2 * sp.pi)))
area = sp.pi * R**2
on_cuts = sp.diff(-rho_b * g * length * tangent[1] * area * tangent, length)
carried = sp.Matrix([0, rho_b * g * area, 0])
assert all(vanishes(sp.expand_trig(sp.expand(term))) for term in pushed - (carried + on_cuts))

# %% [markdown]
# Per unit of rest length the displaced area is $A s = A_0$: what is left of the weight is $(\rho - \rho_b) A_0 g$, and
# the inertia keeps its $\rho$.

# %%
(horizontal, vertical), _ = outer_force([BUOYANT], stretch)
prove_equal(horizontal, 0)
prove_equal(vertical, rho_b * A0 * g_t)

# %% [markdown]
# ## Drag
#
# A slender body in a viscous liquid: $\mathbf f = -s\,[\zeta_t v_t\mathbf t + \zeta_n v_n\mathbf n]$ (Cox 1970;
# Batchelor 1970 with $\ln(L/R) + 0.193$ across and $- 0.807$ along, for a cylinder). For a rectangle, $R$ is half the
# mean of its sides, which is exact for an ellipse.

# %%
unit, across_it = sp.Matrix([x_X, y_X]) / stretch, sp.Matrix([-y_X, x_X]) / stretch
velocity = sp.Matrix([x_t, y_t])
v_t, v_n = velocity.dot(unit), velocity.dot(across_it)


def force_of(potential: sp.Expr) -> sp.Matrix:
    """-R_v."""
    return -sp.Matrix([sp.diff(potential.subs(s, stretch), one) for one in (x_t, y_t)])


stated = -stretch * (along * v_t * unit + across * v_n * across_it)
assert all(vanishes(term) for term in force_of(SLENDER) - stated)
power = -velocity.dot(stated)
prove_equal(power, 2 * SLENDER.subs(s, stretch))

round_one = {aspect: 1, h0: 2, mu_b: 1}
logarithm = sp.log(L_0 / 1)
assert abs(float((4 * sp.pi / across.subs(round_one) - logarithm).subs(L_0, 50)) - 0.193) < 5e-4
assert abs(float((2 * sp.pi / along.subs(round_one) - logarithm).subs(L_0, 50)) + 0.807) < 5e-4

# %% [markdown]
# Beyond a Reynolds number of one: $\frac12\rho_b C_d d\,|v_n| v_n$ with White's $C_d = 1 + 10\,\mathrm{Re}^{-2/3}$, on
# the thickness $d = d_0 s^{-1/2}$ that the stretched strand has. As it stands it has no slope at rest, where nothing
# would hold the velocity of a strand without inertia; with $v_n (v_n^2 + v_0^2)^{1/6}$ in the place of
# $|v_n|^{1/3} v_n$ it passes into the slender body there, near a Reynolds number of 0.1.

# %%
speed, diameter = sp.symbols("U d", positive=True)
reynolds = rho_b * diameter * speed / mu_b
drag = rho_b / 2 * (1 + 10 * reynolds ** sp.Rational(-2, 3)) * diameter * speed**2
pull = -force_of(CROSS_FLOW).subs({x_t: 0, y_t: speed, y_X: 0, aspect: 1})[1].doit()
water = {mu_b: sp.Rational(1, 1000), rho_b: 1000, L_0: sp.Rational(1, 5)}
for stretched in (1, 4):
    # As thick as the stretched strand, and as long.
    found, exact = pull.subs(x_X, stretched).subs(h0, diameter), drag.subs(diameter, diameter / sp.sqrt(stretched))
    for number, error in ((1, 5e-3), (10, 5e-5), (1000, 5e-9)):
        numbers = {**water, diameter: sp.Rational(1, 500), speed: sp.Rational(number, 2000) * sp.sqrt(stretched)}
        ratio = float((found / (stretched * exact)).subs(numbers))
        assert 0 < ratio - 1 < error, (stretched, number, ratio)
slope = sp.limit(sp.diff(pull.subs({x_X: 1, h0: diameter}), speed), speed, 0, "+")
prove_equal(sp.powsimp(slope, force=True).replace(sp.Abs, lambda log: log), across.subs({aspect: 1, h0: diameter}))

# %% [markdown]
# ## Added mass
#
# Around a cylinder that moves across itself the liquid has the kinetic energy of its own volume,
# $\frac12\rho_b A v_n^2$ a length: $T = \frac12\rho_b A_0 v_n^2$ a unit of rest length, whatever the stretch. Its
# Euler-Lagrange derivative is the reactive force of Lighthill (1971): momentum $m w\mathbf n$ carried along, and a flux
# of it through the section.

# %%
fields = [sp.Function(name)(X, t) for name in ("xi", "eta")]
at = dict(zip((x_X, y_X), (sp.diff(one, X) for one in fields), strict=True))
at |= dict(zip((x_t, y_t), (sp.diff(one, t) for one in fields), strict=True))
momentum = sp.Matrix(outer_momentum([ADDED["circle"]], stretch))
inner = sp.Matrix(outer_force([ADDED["circle"]], stretch)[1])
m = rho_b * A0
prove_equal(momentum[0], (m * v_n * across_it)[0])
prove_equal(momentum[1], (m * v_n * across_it)[1])
assert all(vanishes(term) for term in inner - m * v_n * v_t * across_it / stretch)
reactive = sp.diff(inner.subs(at), X) - sp.diff(momentum.subs(at), t)
lighthill = sp.diff((m * v_n * v_t * across_it / stretch).subs(at), X) - sp.diff((m * v_n * across_it).subs(at), t)
assert all(vanishes(term) for term in reactive - lighthill)

# %% [markdown]
# Lighthill's section has a constant mass a *length*, so that his force has $-\frac12 m w^2\mathbf t$ in the flux beside
# it: with an inextensible centreline that is a part of the tension. Here the volume of an incompressible strand is
# what is constant, and the term is absent.
#
# A straight strand that slides along itself feels nothing; one that moves across itself feels $-m\ddot y$:

# %%
flat = {fields[0]: X, fields[1]: sp.Function("h")(t)}
assert vanishes(reactive[0].subs(flat).doit())
prove_equal(reactive[1].subs(flat).doit(), -m * sp.diff(sp.Function("h")(t), t, 2))
sliding = {fields[0]: X + sp.Function("h")(t), fields[1]: sp.S.Zero}
assert all(vanishes(term.subs(sliding).doit()) for term in reactive)

# %% [markdown]
# A node carries the mass matrix $\rho A_0\mathbf 1 + m\,\mathbf n\mathbf n^T$, and solves two equations for its
# acceleration; by Sherman and Morrison that is
# $\mathbf a = (\mathbf F - \mathbf n\,(\mathbf n\cdot\mathbf F)\,r/(1 + r))/(\rho A_0)$, $r = m/(\rho A_0)$.

# %%
rho, F_x, F_y = sp.symbols("rho F_x F_y")
mass = rho * A0 * sp.eye(2) + momentum.jacobian(velocity)
forces, r = sp.Matrix([F_x, F_y]), rho_b / rho
morrison = (forces - across_it * across_it.dot(forces) * r / (1 + r)) / (rho * A0)
assert all(vanishes(sp.simplify(term)) for term in mass.inv() * forces - morrison)
