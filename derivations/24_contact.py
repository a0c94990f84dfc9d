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
# # 24. Contact: floors and pillars
#
# A body holds up what comes to lie on it by a penalty $\Phi(g)$ of the gap $g$ between it and the lower surface, smooth
# over a half width $e$. Proved here: that the energy has two continuous derivatives, that the force is normal to the
# body and balances the weight at the stated penetration, that damping, bond and friction take power and never give it,
# that pillars are what a disk of the filament's thickness rolls over; and the closed forms by which contact is tested.
#
# Effects derived here: `contact` (`surroundings.contact_of`, `surroundings.densities_of_contact`).

# %%
import sympy as sp
from proving import prove_equal

from softcat_sym.physics.surroundings import constants_of, contact_of, densities_of_contact
from softcat_sym.physics.symbols import A0, g, h0, rho, x, x_t, y, y_t
from softcat_sym.physics.terms import Touch

floor, on_floor = constants_of("floor"), contact_of("floor")
weight, d_p = rho * g * A0, floor["penetration"]
half = d_p  # Of the smoothing

# %% [markdown]
# ## The energy
#
# $\Phi = k(\langle e - g\rangle^3 - \langle -e - g\rangle^3)/(12e)$: nothing beyond $e$, a parabola below $-e$, and a
# cubic between that joins both with their first two derivatives. Above a floor $g = y + D$ with the depth $D$ below the
# underside at rest, as half the thickness is on both sides. A filament that sinks in by $d_p$ is held by its weight.

# %%
gap = sp.Symbol("gap", real=True)
energy = on_floor.energy.subs(y, gap - floor["depth"])
stiffness = weight / d_p
pieces = {
    "apart": (sp.S.Zero, 3 * half),
    "joined": (stiffness * (half - gap) ** 3 / (12 * half), half / 3),
    "pressed": (stiffness * (gap**2 / 2 + half**2 / 6), -3 * half),
}
for piece, place in pieces.values():
    prove_equal((energy - piece).subs(gap, place).subs(d_p, 1), 0)
for one, other, place in (("apart", "joined", half), ("joined", "pressed", -half)):
    for order in range(3):
        prove_equal(sp.diff(pieces[one][0] - pieces[other][0], gap, order).subs(gap, place), 0)
prove_equal(on_floor.pressure.subs(y, -floor["depth"] - d_p), weight)
force = -sp.diff(on_floor.energy, y)
for place in (2 * half, half / 3, -2 * half):
    prove_equal((on_floor.pressure - force).subs(y, place - floor["depth"]).doit(), 0)

# %% [markdown]
# ## Pillars
#
# The centreline keeps the distance $R = R_e + h_0/2$ from the centre of a round edge at $|x| = a/2 + R_e$, and half the
# thickness from wall and top: on each of them the gap vanishes. Its gradient is a unit vector, so that the force is the
# pressure along the normal.

# %%
pillars, on_pillars = constants_of("pillars"), contact_of("pillars")
numbers = {pillars["gap"]: 5, pillars["edge"]: 1, pillars["height"]: 0, h0: sp.Rational(2, 5)}
radius, turn = sp.Rational(6, 5), sp.Rational(7, 10)
touching = [(4, 0), (sp.Rational(23, 10), -5), (3.5 - radius * sp.cos(turn), -radius * (1 - sp.sin(turn)))]
for place in touching:
    at = {**numbers, x: place[0], y: place[1]}
    assert abs(sp.N(on_pillars.gap.subs(at))) < 2e-6
    slopes = [sp.N(sp.diff(on_pillars.gap, one).subs(at)) for one in (x, y)]
    assert abs(sp.sqrt(slopes[0] ** 2 + slopes[1] ** 2) - 1) < 2e-6

# %% [markdown]
# ## What depends on velocities
#
# Rayleigh potentials of the velocity relative to the body. Normal damping $c_n d/d_p$ with $c_n = 2\rho A_0
# \sqrt{g/d_p}$ is critical for a weight on the penalty; the bond is $c_b d/d_p$; friction is $\mu p$ against the
# sliding, smooth below the slip speed $v_s$. Each takes $R_{v}\cdot(v - V)$ from the filament, which is not negative.

# %%
stored, damping, bond, friction = densities_of_contact(Touch("floor", True, True, True, True))
relative = x_t - floor["speed"]
critical = 2 * sp.sqrt(stiffness * rho * A0)
rubbing = floor["friction"] * on_floor.pressure / sp.sqrt(relative**2 + floor["slip"] ** 2)
for one, power in (
    (damping, critical * on_floor.pressed * y_t**2),
    (bond, floor["bond"] * on_floor.pressed * relative**2),
    (friction, rubbing * relative**2),
):
    prove_equal(one.carried, floor["speed"])
    prove_equal(sp.diff(one.dissipation, x_t) * relative + sp.diff(one.dissipation, y_t) * y_t, power)

# %% [markdown]
# ## A beam on a floor
#
# The free part hangs from a clamp over a length $a$ and touches at a tangent, without a moment, since what lies flat
# has none. Five conditions give its shape and $a^4 = 72EID/q$; it presses with $qa/3$ where it touches.

# %%
X, a, q, bending, depth = sp.symbols("X a q EI D", positive=True)
c = sp.symbols("c:4")
shape = -q * X**4 / (24 * bending) + sum(c[k] * X**k for k in range(4))
conditions = [
    shape.subs(X, 0),
    sp.diff(shape, X).subs(X, 0),
    sp.diff(shape, X).subs(X, a),
    sp.diff(shape, X, 2).subs(X, a),
]
solved = shape.subs(sp.solve(conditions, c, dict=True)[0])
prove_equal(-solved.subs(X, a), q * a**4 / (72 * bending))
prove_equal(-bending * sp.diff(solved, X, 2).subs(X, 0), q * a**2 / 6)
prove_equal(sp.simplify(-bending * sp.diff(solved, X, 3).subs(X, a)), q * a / 3)

# %% [markdown]
# What the penalty adds there is a beam on an elastic foundation, $EIw'''' + kw = 0$, which decays over
# $l = (4EI/k)^{1/4}$ with $k = q/d_p$, and yields by $F/(2kl)$ below a force $F$ in its middle (Hetenyi 1946).

# %%
k, decay, F = sp.symbols("k l F", positive=True)
near = F / (2 * k * decay) * sp.exp(-X / decay) * (sp.cos(X / decay) + sp.sin(X / decay))
foundation = k * decay**4 / 4
prove_equal((foundation * sp.diff(near, X, 4) + k * near).simplify(), 0)
prove_equal((2 * foundation * sp.diff(near, X, 3)).subs(X, 0).simplify(), F)

# %% [markdown]
# ## A cable on a floor
#
# A catenary $y = c(\cosh(x/c) - 1)$ rises from the floor to the height $H$: its length is $l^2 = H^2 + 2cH$, over
# $c\,\mathrm{arcosh}(1 + H/c)$.

# %%
H, c_0 = sp.symbols("H c", positive=True)
reach = c_0 * sp.acosh(1 + H / c_0)
prove_equal(sp.simplify((c_0 * sp.sinh(reach / c_0)) ** 2), sp.expand(H**2 + 2 * c_0 * H))

# %% [markdown]
# ## A viscous string on a floor
#
# A shallow string of length $L$ touches a floor at the depth $D$ at $t_0 = 128\eta D^3/(9\rho gL^4)$. From then on
# either part hangs over $a$ as the parabola $Dx^2/a^2$, under $T = qa^2/(2D)$, longer than flat by $2D^2/(3a)$. The
# excess grows at the rate of strain $T/(\eta A)$ times what stretches: the hanging part where it sticks, half of the
# string where it slips. So $a^{-4}$ grows by $3\rho g/(\eta D^3)$, and $a^{-3}$ by $9\rho gL/(8\eta D^3)$.

# %%
t, eta, L, A = sp.symbols("t eta L A", positive=True)
part = sp.Function("a", positive=True)(t)
excess = sp.integrate(sp.diff(depth * X**2 / a**2, X) ** 2 / 2, (X, 0, a)).subs(a, part)
rate = q * part**2 / (2 * depth) / (eta * A)
for stretching, exponent, growth in (
    (part, 4, 3 * q / A / (eta * depth**3)),
    (L / 2, 3, sp.Rational(9, 8) * q / A * L / (eta * depth**3)),
):
    speed = sp.solve(sp.diff(excess, t) - rate * stretching, sp.diff(part, t))[0]
    prove_equal(sp.diff(part**-exponent, t).subs(sp.diff(part, t), speed), growth)
