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
# # 25. Laying: a nozzle that moves while the strand hangs
#
# A strand is fed out of a nozzle at the place $p(t)$ with $U(t)$, its rest length per time; $\dot L_e = U$. Inside it
# is straight and moves as one: $r(X) = p + d\,(X - L_e)$, with the tangent $d$ and the velocity $v_e = \dot p - dU$.
# The grid stays: the exit cuts a cell, of which the length $l$ is out, $\dot l = U$. Proved here: the balance of
# mass, momentum and energy of that cell, with what the nozzle does; what guides a node until it is out; and the
# closed forms by which laying is tested.
#
# Effects derived here: `laying` (`exit_cell.dilution`, `exit_cell.handed_over`, `exit_cell.arriving_momentum`,
# `exit_cell.guide_energy`, `exit_cell.guide_loss`).

# %%
import sympy as sp
from proving import prove_equal

from softcat_sym.physics.exit_cell import arriving_momentum, dilution, guide_energy, guide_loss, handed_over

t, X, rho, U = sp.symbols("t X rho U", positive=True)

# %% [markdown]
# ## Mass
#
# A node has half of what is out of the cells beside it. Their sum is what is out, whatever part of which cell it is,
# so that its rate is $\rho U$.

# %%
lengths = sp.symbols("l_0:5")
masses = [rho * (before + after) / 2 for before, after in zip((0, *lengths), (*lengths, 0), strict=True)]
prove_equal(sum(masses), rho * sum(lengths))

# %% [markdown]
# ## The exit cell
#
# From a node at $r_0$ to the exit at $p$: the mean slope is $(p - r_0)/l$. Material arrives with the slope $d$ of the
# nozzle, and the velocities differ by $v_e - v_0$ along what is out, which is the mean rate of its slope. The mean of
# a state changes likewise: what arrives has none of it.

# %%
p, r_0, length = (sp.Function(name)(t) for name in ("p", "r_0", "l"))
d = sp.Symbol("d", real=True)
v_0, v_e = sp.diff(r_0, t), sp.diff(p, t) - d * U
slope = (p - r_0) / length
growth = U / length
found = sp.diff(slope, t).subs(sp.diff(length, t), U)
prove_equal(found, (v_e - v_0) / length + dilution(slope - d, growth))

a = sp.Function("a")
total = sp.Integral(a(X, t), (X, 0, length))
rate = sp.diff(total / length, t).doit().subs(sp.diff(length, t), U).subs(a(length, t), 0)
mean_rate = sp.Integral(sp.diff(a(X, t), t), (X, 0, length)) / length
prove_equal(sp.expand(rate - mean_rate - dilution(total / length, growth)), 0)

# %% [markdown]
# ## Energy
#
# Of the mean slope $s$ and the mean state $\bar a$ the cell stores $l\,W$, its nodes pull with $Q = W_s$, and its
# flow takes $-l\,W_a\,\phi$. What is missing is lost where fresh material is suddenly loaded to the tension of the
# cell: $U\,(Q(s - d) - W + \bar a W_a)$. For a relaxed strand that is pulled along, that is never negative.

# %%
s, state, phi, Q = sp.symbols("s a phi Q", real=True)
W = sp.Function("W")(s, state)
V_0, V_e, cell = sp.symbols("v_0 v_e l", real=True)
s_t = (V_e - V_0) / cell + dilution(s - d, U / cell)
a_t = phi + dilution(state, U / cell)
stored = U * W + cell * (sp.diff(W, s) * s_t + sp.diff(W, state) * a_t)
supplied, dissipated = sp.diff(W, s) * (V_e - V_0), -cell * sp.diff(W, state) * phi
lost = U * (sp.diff(W, s) * (s - d) - W + state * sp.diff(W, state))
prove_equal(sp.expand(stored - (supplied - dissipated - lost)), 0)

stretch, E = sp.symbols("s E", positive=True)
bar = E * sp.log(stretch) ** 2 / 2
loss = sp.diff(bar, stretch) * (stretch - 1) - bar
prove_equal(loss.subs(stretch, 1), 0)
prove_equal(sp.diff(loss, stretch).subs(stretch, 1), 0)
prove_equal(sp.diff(loss, stretch, 2).subs(stretch, 1), E)

# %% [markdown]
# The package takes the loss as minus the rate of the stored energy at places and states that stay, of a cell whose
# right end is a node inside the nozzle less what of the cell is inside it, $r_1 - d(\Delta - l)$; and of states that
# are diluted: the same.

# %%
r_1, r_left, whole = sp.symbols("r_1 r_0 Delta", real=True)
mean = (r_1 - d * (whole - cell) - r_left) / cell
kept = cell * sp.Function("W")(mean, state)
passing = U * sp.diff(kept, cell) + dilution(state, U / cell) * sp.diff(kept, state)
at_exit = lost.subs(s, mean).doit()
prove_equal(sp.simplify(-passing.doit() - at_exit), 0)

# %% [markdown]
# ## Momentum
#
# A node of the mass $m$, to which $\dot m$ comes with the velocity of the nozzle: $(mv)_t = F + \dot m v_e$. The
# kinetic energy that is fed is $\dot m v_e^2/2$; an inelastic impact takes $\dot m(v_e - v)^2/2$ of it.

# %%
m, v = sp.Function("m")(t), sp.Function("v")(t)
F, nozzle = sp.symbols("F v_e", real=True)
m_t = sp.diff(m, t)
acceleration = sp.solve(sp.Eq(sp.diff(m * v, t), F + m_t * nozzle), sp.diff(v, t))[0]
prove_equal(acceleration, (F + arriving_momentum(m_t, nozzle, v)) / m)
kinetic = sp.diff(m * v**2 / 2, t).subs(sp.diff(v, t), acceleration)
prove_equal(sp.expand(kinetic - (F * v + m_t * nozzle**2 / 2 - m_t * (nozzle - v) ** 2 / 2)), 0)

# %% [markdown]
# ## What guides a node
#
# Without inertia a node obeys $wF + (1 - w)k\,\delta = 0$, $\delta$ the distance from its place in the nozzle: it
# hangs on a spring $K = k(1 - w)/w$, rigid before it comes out and gone afterwards. $w$ is smooth. The work of the
# spring is what its rest does, which moves with $v_e$, less what it stores and loses.

# %%
share = sp.Symbol("x", real=True)
step = handed_over(share)
for place, value in ((0, 0), (1, 1)):
    prove_equal(step.subs(share, place), value)
    prove_equal(sp.diff(step, share).subs(share, place), 0)

w, r = sp.Function("w")(t), sp.Function("r")(t)
rest = sp.Function("r_n")(t)
k = sp.Symbol("k", positive=True)
off, spring = rest - r, k * (1 - w) / w
reaction = spring * off  # R = - F
balance = w * -reaction + (1 - w) * k * off
prove_equal(sp.simplify(balance), 0)
work = reaction * sp.diff(r, t)
energy = guide_energy(reaction, off)
losing = guide_loss(sp.diff(w, t), k, k * off / w)
prove_equal(sp.simplify(work - (reaction * sp.diff(rest, t) - sp.diff(energy, t) - losing)), 0)
prove_equal(sp.simplify(k * off / w - reaction / (1 - w)), 0)

# %% [markdown]
# ## A strand extruded downwards
#
# Quasi-static, of true strain: at a distance $X$ from its free end $E\log(s)/s = \rho g X$. So what is out has the
# length $\int_0^{L_e} s\,dX$, and the nozzle carries $\rho g A L_e$: equilibrium knows nothing of how it came there.
#
# ## A viscous beam
#
# Clamped at both ends of a span $\xi$ that grows with $V = U$: the rate of its deflection is that of the elastic beam
# with $\eta$ in the place of $E$. A place $x$ begins to sag when the nozzle passes it.

# %%
q, eta, inertia, V, L, x, xi = sp.symbols("q eta I V L x xi", positive=True)
rate = q * x**2 * (xi - x) ** 2 / (24 * eta * inertia)
prove_equal(eta * inertia * sp.diff(rate, x, 4), q)
laid = sp.integrate(rate / V, (xi, x, L))
prove_equal(laid, q * x**2 * (L - x) ** 3 / (72 * eta * inertia * V))
at_once = (rate * L / V).subs({xi: L, x: L / 2})
prove_equal(laid.subs(x, L / 2) / at_once, sp.Rational(1, 6))
prove_equal(sp.diff(laid, x).subs(x, 2 * L / 5), 0)

# %% [markdown]
# ## A viscous string
#
# A shallow parabola of the sag $f$ over $\xi$ is longer than flat by $8f^2/(3\xi)$, and its tension $q\xi^2/(8f)$
# stretches all of it. With $\xi = Vt$, $f^3 = 9q\xi^5/(448\eta AV)$; released at once over $L$, $9qL^4t/(128\eta A)$.

# %%
A, sag = sp.symbols("A f", positive=True)
law = (9 * q * xi**5 / (448 * eta * A * V)) ** sp.Rational(1, 3)
excess = 8 * law**2 / (3 * xi)
prove_equal(sp.simplify(V * sp.diff(excess, xi) - q * xi**2 / (8 * law) * xi / (eta * A)), 0)
once = (9 * q * L**4 * t / (128 * eta * A)) ** sp.Rational(1, 3)
prove_equal(sp.simplify(sp.diff(8 * once**2 / (3 * L), t) - q * L**2 / (8 * once) * L / (eta * A)), 0)
ratio = law.subs(xi, L) ** 3 / once.subs(t, L / V) ** 3
prove_equal(sp.simplify(ratio), sp.Rational(2, 7))

# %% [markdown]
# ## A dragged catenary
#
# At rest in space a thread has the same mass flux $\rho UA_0$ everywhere, and moves along itself with $v$: in an
# element $ds$ there is the rest length $U\,ds/v$. Its tension $T = 3\mu (A_0U/v)\,v'$ is drawn by the belt,
# $T\cos\theta$ is the same everywhere without inertia, and $(T\sin\theta)' = \rho gA_0U/v$. With $C = T\cos\theta$
# and $p = \tan\theta$: $Cp' = \rho gA_0U/v$ and $v'/v = C\sqrt{1+p^2}/(\eta A_0U)$.

# %%
arc, C = sp.symbols("s C", positive=True)
speed, tangent = sp.Function("v", positive=True)(arc), sp.Function("p")(arc)
tension = C * sp.sqrt(1 + tangent**2)
drawn = sp.solve(sp.Eq(eta * A * U / speed * sp.diff(speed, arc), tension), sp.diff(speed, arc))[0]
prove_equal(sp.simplify(drawn / speed - tension / (eta * A * U)), 0)
