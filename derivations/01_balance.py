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
# # 1. Balance of force and moment: (2.1)–(2.5)
#
# A filament is a curve $\mathbf r(X, t) = (x, y)$ that carries mass, force and moment. $X$ labels material points
# (the paper's $x_0$) and never moves with respect to them, so that $\partial_t$ at fixed $X$ is the rate that a
# particle feels. Nothing is assumed here about the material. We cut out an element, write Newton's two laws for it,
# let it shrink, and compare with the paper. Two slips of (2.4) come to light.
#
# The names on the left of each comparison are derived here; those on the right are the very objects the solver runs.
#
# Effects derived here: `inertia` (`kinematics.mass_per_length`), `bending` (`kinematics.internal_force`),
# `large-rotation` (`kinematics.LARGE_ROTATION`), `gravity-ramp` (`loads.ramped_gravity`, `loads.ramp_rate`),
# `gravity-shaking` (`loads.shaking`, `loads.shaking_rate`).

# %%
import math
from itertools import pairwise

import mpmath as mp
import sympy as sp
from proving import Erratum, prove_equal, record_errata

from softcat_sym.physics import kinematics, loads
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.section_equations import derive
from softcat_sym.physics.sections import RECTANGLE
from softcat_sym.physics.symbols import A0, M_X, Q, X, a_g, f_g, g, g_on, rho, s, t, x_X, x_X_before, y_X, y_X_before
from softcat_sym.physics.terms import Terms

x, y, S, theta, axial, shear, moment = (
    sp.Function(name, real=True)(X, t) for name in ("x", "y", "s_X", "theta", "Q", "N", "M")
)

# %% [markdown]
# ## The element
#
# Between $X$ and $X + d$ lies the mass $\lambda_0 d$, whatever its present length: $\lambda_0 = \rho A_0$. In the
# current configuration the mass per unit *arclength* is $\lambda = \lambda_0/s_X$, because an arc of the length
# $s_X d$ carries it.
#
# The filament ahead of a section pulls the part behind it with the force $\mathbf F = Q\,\mathbf t + N\,\mathbf n$,
# where $\mathbf t = (\cos\theta, \sin\theta)$, $\mathbf n = (-\sin\theta, \cos\theta)$. The paper writes $T$ for $Q$.
# The stress $\sigma$ of a fibre at the distance $z$ along $\mathbf n$ exerts the couple
# $z\mathbf n\times\sigma\mathbf t = -z\sigma$ about the centreline: with $M = \int_A\sigma z\,da$ the couple that the
# part ahead exerts is $-M$.

# %%
tangent = sp.Matrix([sp.cos(theta), sp.sin(theta)])
normal = sp.Matrix([-sp.sin(theta), sp.cos(theta)])


def cross(a: sp.Matrix, b: sp.Matrix) -> sp.Expr:
    """Out-of-plane component of a x b."""
    return a[0] * b[1] - a[1] * b[0]


assert sp.simplify(cross(tangent, normal)) == 1
couple_of_a_fibre = sp.simplify(cross(sy.z * normal, sy.sigma * tangent))
assert couple_of_a_fibre == -sy.z * sy.sigma

# %% [markdown]
# Newton's second law for the element, to first order in its size $d$. A quantity ahead is its value plus $d$ times
# its derivative. The body force is $-\lambda_0 g\,\mathbf e_y$ per unit $X$; in the moment about the rear end it
# acts with a lever of order $d$, and drops out, as does the rotary inertia of a thin section.

# %%
d = sp.Symbol("d", positive=True)
lambda_0 = rho * A0
r = sp.Matrix([x, y])
F = axial * tangent + shear * normal
acceleration = r.diff(t, 2)
body = lambda_0 * (acceleration + sp.Matrix([0, g]))


def ahead(field: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
    """At the front end of the element."""
    return field + d * field.diff(X)


forces = (ahead(F) - F - d * body).applyfunc(sp.expand)
couples = sp.expand(-ahead(moment) + moment + cross(ahead(r) - r, ahead(F)) - cross((ahead(r) - r) / 2, d * body))
force_balance = (forces / d).applyfunc(sp.expand)
moment_balance = sp.expand(couples / d).subs(d, 0)

# %% [markdown]
# The tangent is the direction of the curve: $\mathbf r_X = s_X\mathbf t$. With it the moment balance gives
# $N = M_X/s_X = M_s$, (2.3), and the projections of the force balance on $\mathbf t$ and $\mathbf n$, per unit
# arclength, are (2.1) and (2.2).

# %%
r_X = S * tangent
along_curve = {sp.Derivative(x, X): r_X[0], sp.Derivative(y, X): r_X[1]}
N_derived = sp.solve(sp.simplify(moment_balance.subs(along_curve)), shear)[0]
prove_equal(N_derived, moment.diff(X) / S)

per_arclength, density, bend = force_balance / S, lambda_0 / S, theta.diff(X) / S
along_tangent = axial.diff(X) / S - shear * bend - density * (g * sp.sin(theta) + tangent.dot(acceleration))
along_normal = shear.diff(X) / S + axial * bend - density * (g * sp.cos(theta) + normal.dot(acceleration))
prove_equal(sp.trigsimp(sp.expand(tangent.dot(per_arclength))), sp.expand(along_tangent))
prove_equal(sp.trigsimp(sp.expand(normal.dot(per_arclength))), sp.expand(along_normal))

# %% [markdown]
# ## Change to the material coordinate
#
# $\partial_s = (1/s_X)\,\partial_X$. Eliminate $N$ and solve for the acceleration. The rotation that takes
# components along $(\mathbf t, \mathbf n)$ to components along $(\mathbf e_x, \mathbf e_y)$ has $\mathbf t$ and
# $\mathbf n$ as its **columns**. The normal entry is $N_X + Q\theta_X$ with $N_X = (M_{XX} - M_X s_{XX}/s_X)/s_X$.

# %%
eliminated = force_balance.subs(shear, N_derived).doit()
at_rest = {x.diff(t, 2): 0, y.diff(t, 2): 0}
accelerations = [sp.expand(force / lambda_0) for force in eliminated.subs(at_rest)]
# What is left of the balance is -lambda_0 r_tt: so these are the accelerations.
for left, derived, second_rate in zip(eliminated, accelerations, acceleration, strict=True):
    prove_equal(sp.expand(left), sp.expand(lambda_0 * (derived - second_rate)))

N_X = sp.diff(moment.diff(X) / S, X)
prove_equal(N_X, (moment.diff(X, 2) - moment.diff(X) * S.diff(X) / S) / S)
rotation = sp.Matrix.hstack(tangent, normal)
column = sp.Matrix([axial.diff(X) - moment.diff(X) * theta.diff(X) / S, N_X + axial * theta.diff(X)])
weight = lambda_0 * g * sp.Matrix([sp.sin(theta), sp.cos(theta)])
for derived, expected in zip(rotation * (column - weight) / lambda_0, accelerations, strict=True):
    prove_equal(sp.expand(derived), expected)

# %% [markdown]
# The same law in conservative form, the one that is discretised, because a difference of $\mathbf F$ between
# neighbouring cells cannot create momentum:
# $$\lambda_0\,\mathbf r_{tt}
# = \partial_X\Big(Q\,\mathbf t + \tfrac{M_X}{s_X}\,\mathbf n\Big) - \lambda_0 g\,\mathbf e_y .$$

# %%
for derived, pull, weight_ in zip(accelerations, F.subs(shear, N_derived).diff(X), (0, lambda_0 * g), strict=True):
    prove_equal(sp.expand(lambda_0 * derived), sp.expand(pull.doit() - weight_))
prove_equal(lambda_0, kinematics.mass_per_length())
# Mass: what an arc of the length s_X carries is what it always carried.
prove_equal(rho * (A0 / s) * s, kinematics.mass_per_length())

# %% [markdown]
# ## Geometry: (2.5)
#
# Insert $\mathbf r_X = s_X(\cos\theta, \sin\theta)$ into the right-hand sides of (2.5).

# %%
S_, theta_ = sp.Function("S", positive=True)(X), sp.Function("Theta", real=True)(X)
r_X_ = S_ * sp.Matrix([sp.cos(theta_), sp.sin(theta_)])
in_polar = [
    (sp.Derivative(x, (X, 2)), r_X_[0].diff(X)),
    (sp.Derivative(y, (X, 2)), r_X_[1].diff(X)),
    (sp.Derivative(x, X), r_X_[0]),
    (sp.Derivative(y, X), r_X_[1]),
    (S, S_),
]
x_1, y_1, x_2, y_2 = x.diff(X), y.diff(X), x.diff(X, 2), y.diff(X, 2)
turning_2_5 = (x_1 * y_2 - y_1 * x_2) / S**2
geometry = (sp.sqrt(x_1**2 + y_1**2), (x_1 * x_2 + y_1 * y_2) / S, sp.atan2(y_1, x_1), turning_2_5)
held_stretch, held_change, held_angle, held_turning = (right.subs(in_polar) for right in geometry)
prove_equal(S_, held_stretch)
prove_equal(S_.diff(X), held_change)
prove_equal(theta_.diff(X), held_turning)
prove_equal(sp.cos(held_angle), sp.cos(theta_))
prove_equal(sp.sin(held_angle), sp.sin(theta_))

# %% [markdown]
# The paper prints $\theta = \arctan(y_X/x_X)$, which is right while the filament runs forward. Where it runs backward
# ($x_X < 0$) the arctangent turns the tangent round; the two-argument arctangent does not.

# %%
backward = {x_X: -1, y_X: sp.Rational(1, 10)}
assert sp.cos(sp.atan(y_X / x_X)).subs(backward) > 0
assert sp.cos(sp.atan2(y_X, x_X)).subs(backward) < 0

# %% [markdown]
# ## Turning between neighbours
#
# A cell knows its tangent $\mathbf r_X$. The angle from the tangent of one cell to that of the next is
# $\operatorname{atan2}(\mathbf r_X^-\times\mathbf r_X,\ \mathbf r_X^-\cdot\mathbf r_X)$. Its sine and cosine are
# those of $\theta - \theta^-$; so it *is* $\theta - \theta^- = \int\theta_X\,dX$ as long as neighbours differ by
# less than $\pi$, however far the whole filament has turned.

# %%
before, behind = sp.symbols("theta_1 theta_2", real=True)
s_before = sp.Symbol("s_1", positive=True)
neighbours = {
    x_X_before: s_before * sp.cos(before),
    y_X_before: s_before * sp.sin(before),
    x_X: s * sp.cos(behind),
    y_X: s * sp.sin(behind),
}
turning = kinematics.LARGE_ROTATION.turning
assert isinstance(turning, sp.atan2)
sine, cosine = (argument.subs(neighbours) for argument in turning.args)
prove_equal(sine, s * s_before * sp.sin(behind - before))
prove_equal(cosine, s * s_before * sp.cos(behind - before))
# ... and its change with the second tangent is the theta_X of (2.5).
x_XX, y_XX = sp.symbols("x_XX y_XX", real=True)
change = sp.diff(turning, x_X) * x_XX + sp.diff(turning, y_X) * y_XX
turning_2_5 = turning_2_5.subs([(x.diff(X, 2), x_XX), (y.diff(X, 2), y_XX), (x.diff(X), x_X), (y.diff(X), y_X), (S, s)])
prove_equal(change, turning_2_5.subs(s, sp.sqrt(x_X**2 + y_X**2)))

# %% [markdown]
# A filament curled through more than one full turn, in 40 cells:

# %%
angles = [9 * (k / 40) for k in range(41)]
turns = [
    math.atan2(
        math.sin(b) * math.cos(a) - math.cos(b) * math.sin(a), math.cos(b) * math.cos(a) + math.sin(b) * math.sin(a)
    )
    for a, b in pairwise(angles)
]
assert math.isclose(sum(turns), 9, rel_tol=1e-14)
assert abs(math.atan(math.tan(9)) - 9) > 3

# %% [markdown]
# ## First slip of (2.4): the matrix is transposed
#
# Printed:
# $$\mathbf r_{tt} = \frac1{\lambda_0}
# \begin{pmatrix}\cos\theta & \sin\theta\\ -\sin\theta & \cos\theta\end{pmatrix}(\ldots).$$
# Let a straight rod, tilted by $\theta$, fall freely: $Q = M = 0$. It must fall with $(0, -g)$.

# %%
printed_rotation = sp.Matrix([[sp.cos(theta), sp.sin(theta)], [-sp.sin(theta), sp.cos(theta)]])
assert printed_rotation == rotation.T
falling = {axial: 0, moment: 0}
printed_fall = (printed_rotation * (column - weight) / lambda_0).subs(falling).doit().applyfunc(sp.trigsimp)
prove_equal(printed_fall[0], -g * sp.sin(2 * theta))
prove_equal(printed_fall[1], -g * sp.cos(2 * theta))
for derived, expected in zip(accelerations, (0, -g), strict=True):
    prove_equal(derived.subs(falling).doit(), expected)

# %% [markdown]
# The printed rod, tilted by 45°, is accelerated sideways with $g$ and does not fall at all.

# %%
assert printed_fall.subs(theta, sp.pi / 4) == sp.Matrix([-g, 0])

# %% [markdown]
# ## Second slip of (2.4): a factor $1/s_X$ in the second entry
#
# Printed: $M_{XX} - M_X s_{XX}/s_X + T\theta_X - g\lambda_0\cos\theta$. The first two terms should be divided by
# $s_X$. Take a bent, stretched, free filament without gravity: an arc $\theta = X$ on $-\frac12 \le X \le \frac12$,
# stretched by $s_X = 1 + X/2$, and let $M = (X^2 - \frac14)^2$, $Q = 0$: no force and no moment on either end. Its
# momentum cannot change. We grant the print the right rotation, so that only the factor is judged.

# %%
free_arc = {axial: 0, theta: X, moment: (X**2 - sp.Rational(1, 4)) ** 2, S: 1 + X / 2}
printed_column = sp.Matrix([column[0], moment.diff(X, 2) - moment.diff(X) * S.diff(X) / S + axial * theta.diff(X)])


def momentum_gain(entries: sp.Matrix) -> list[float]:
    """Integral of the force per unit X over the whole arc."""
    force = sp.lambdify(X, list((rotation * entries).subs(free_arc).doit()), "mpmath")
    return [float(mp.quad(lambda at, i=i: force(at)[i], [-0.5, 0.5])) for i in (0, 1)]


assert all(abs(component) < 1e-10 for component in momentum_gain(column))
pushed = momentum_gain(printed_column)
print(f"free bent arc, rate of change of its momentum: printed {pushed}, correct [0, 0]")
assert max(map(abs, pushed)) > 1e-2

# %% [markdown]
# For a uniform stretch the error is the factor itself: a filament drawn to twice its length would feel twice its true
# bending force.

# %%
uniform = {axial: 0, theta: 0, S: sp.Integer(2)}
prove_equal(printed_column[1].subs(uniform).doit(), 2 * column[1].subs(uniform).doit())

# %% [markdown]
# ## The force of one cell
#
# The two components are, in the angle,

# %%
in_symbols = [(moment.diff(X), M_X), (axial, Q), (S, s), (theta, sy.theta)]
F_x, F_y = (component.subs(shear, N_derived).subs(in_symbols) for component in F)
prove_equal(F_x, Q * sp.cos(sy.theta) - M_X / s * sp.sin(sy.theta))
prove_equal(F_y, Q * sp.sin(sy.theta) + M_X / s * sp.cos(sy.theta))

# %% [markdown]
# The solver never writes $\theta$. It builds the force of a cell from gradients of the stretch and of the angle with
# respect to the tangent $\mathbf r_X$,
# $\mathbf F = Q\,\partial s/\partial\mathbf r_X + M_X\,\partial\theta/\partial\mathbf r_X$. For large rotations that
# is $Q\,\mathbf t + (M_X/s)\,\mathbf n$: the force derived above.

# %%
derived_stretch = sp.sqrt(x_X**2 + y_X**2)
prove_equal(kinematics.LARGE_ROTATION.stretch, derived_stretch)
force = kinematics.internal_force(kinematics.LARGE_ROTATION, bending=True)
polar = {x_X: s * sp.cos(sy.theta), y_X: s * sp.sin(sy.theta)}
string = kinematics.internal_force(kinematics.LARGE_ROTATION, bending=False)
for held, taut, derived in (
    (force.horizontal, string.horizontal, F_x),
    (force.vertical, string.vertical, F_y),
):
    prove_equal(derived, held.subs(polar))
    prove_equal(derived.subs(M_X, 0), taut.subs(polar))

# %% [markdown]
# Its power is $\mathbf F\cdot\mathbf v_X = Q\,s_t + M_X\,\theta_t$ — whatever the kinematics, and so for those of
# small slope too. This identity, together with work conjugacy (notebook 2), is what closes the energy balance.

# %%
x_Xt, y_Xt = sp.symbols("x_Xt y_Xt", real=True)


def rate(of: sp.Expr) -> sp.Expr:
    """Time derivative through the tangent."""
    return sp.diff(of, x_X) * x_Xt + sp.diff(of, y_X) * y_Xt


for held, stretch, angle in (
    (kinematics.LARGE_ROTATION, derived_stretch, sp.atan2(y_X, x_X)),
    (kinematics.SMALL_SLOPE, x_X + y_X**2 / 2, y_X),
):
    pulled = kinematics.internal_force(held, bending=True)
    power = pulled.horizontal * x_Xt + pulled.vertical * y_Xt
    prove_equal(Q * rate(stretch) + M_X * rate(angle), power.subs(s, stretch))

# %% [markdown]
# ## Small slopes
#
# Let the slope be $y_X = \epsilon Y$ and the filament as slender as it is flat, $h_0/L\sim\epsilon$. Then
# $x_X = 1 + \epsilon^2 U$, the strain and with it $Q$ are of order $\epsilon^2$, and $M_X\sim E h_0^2 y_{XXX}$ is of
# order $\epsilon^3$. The leading order of the exact stretch, turning and force is what `SMALL_SLOPE` holds.

# %%
small, U, Y, Y_before, q, m = sp.symbols("epsilon U Y Y_before q m", real=True)
flat = {
    x_X: 1 + small**2 * U,
    y_X: small * Y,
    x_X_before: 1 + small**2 * U,
    y_X_before: small * Y_before,
    Q: small**2 * q,
    M_X: small**3 * m,
}


def leading(exact: sp.Expr, order: int) -> sp.Expr:
    """Coefficient of epsilon^order, after making sure that no lower one is left."""
    powers = [sp.diff(exact, small, k).subs(small, 0) / math.factorial(k) for k in range(order + 1)]
    assert not any(powers[:-1])
    return sp.simplify(powers[-1])


held = kinematics.SMALL_SLOPE
prove_equal(leading(sp.atan2(y_X, x_X).subs(flat), 1), Y)
exact_stretch = derived_stretch.subs(flat)
prove_equal(1 + small**2 * leading(exact_stretch - 1, 2), held.stretch.subs(flat))
prove_equal(small * leading(turning.subs(flat), 1), held.turning.subs(flat))
exact_force = [component.subs(s, derived_stretch).subs(flat) for component in (force.horizontal, force.vertical)]
shallow = kinematics.internal_force(held, bending=True)
prove_equal(small**2 * leading(exact_force[0], 2), shallow.horizontal.subs(flat))
prove_equal(small**3 * leading(exact_force[1], 3), sp.expand(shallow.vertical.subs(flat)))

# %% [markdown]
# ## The load
#
# Gravity is switched on by the polynomial of least degree that joins 0 to 1 with two continuous derivatives. Six
# conditions, degree five; the rate is its derivative.

# %%
u = sp.Symbol("u", positive=True)
coefficients = sp.symbols("b_0:6")
step = sum(b * u**k for k, b in enumerate(coefficients))
conditions = [sp.diff(step, u, k).subs(u, end) - (end if k == 0 else 0) for k in range(3) for end in (0, 1)]
step = step.subs(sp.solve(conditions, coefficients))
inside = {sp.Max(0, u): u, sp.Min(1, sp.Max(0, u)): u, sp.Min(1, u): u}
prove_equal(step, loads.quintic_step(u).subs(inside))
assert [loads.quintic_step(sp.Integer(k)) for k in (-1, 0, 1, 2)] == [0, 0, 1, 1]


def during(expression: sp.Expr) -> sp.Expr:
    """Between 0 and g_on, where nothing is clipped."""
    unclipped = expression.replace(sp.Max, lambda *a: next(b for b in a if b != 0))
    return unclipped.replace(sp.Min, lambda *a: next(b for b in a if b != 1))


ramp = g * step.subs(u, t / g_on)
prove_equal(ramp, during(loads.ramped_gravity()))
prove_equal(sp.diff(ramp, t), during(loads.ramp_rate()))
for outside in (-g_on, 2 * g_on):
    assert loads.ramp_rate().subs(t, outside) == 0

# %% [markdown]
# ## Gravity shaken
#
# In a frame at the height $b(t)$ above the laboratory a body of mass $m$ that gravity $g$ pulls obeys
# $m(\ddot y + \ddot b) = F - mg$: it feels $g + \ddot b$. A table that moves by $b = -(ag/\omega^2)\sin\omega t$,
# $\omega = 2\pi f$, makes of it $g(1 + a\sin\omega t)$ (Rayleigh 1877, section 46). Filament and supports move along
# with the table, so that nothing else changes. The changing weight does the work
# $-\dot g\int\lambda_0 y\,dX$ per time on the potential energy; the rate of a weight that is switched on and shaken
# follows from the product rule.

# %%
table_height = -a_g * g / (2 * sp.pi * f_g) ** 2 * sp.sin(2 * sp.pi * f_g * t)
prove_equal(g + sp.diff(table_height, t, 2), g * loads.shaking())
prove_equal(sp.diff(loads.shaking(), t), loads.shaking_rate())
steady, shaken = (
    derive(Terms(bending=True, ramped=moves, shaken=moves), RECTANGLE, "material") for moves in (False, True)
)
prove_equal(during(shaken.load), ramp * loads.shaking())
prove_equal(during(shaken.load_rate), sp.diff(ramp * loads.shaking(), t))
assert (shaken.load.subs(t, 0), steady.load, steady.load_rate) == (0, g, 0)

# %% [markdown]
# ## What is left behind
#
# The errata table gets its two rows.

# %%
record_errata(
    "01_balance",
    [
        Erratum(
            equation="(2.4), matrix",
            printed=r"$\begin{pmatrix}\cos\theta & \sin\theta\\ -\sin\theta & \cos\theta\end{pmatrix}$",
            correct=r"$\begin{pmatrix}\cos\theta & -\sin\theta\\ \sin\theta & \cos\theta\end{pmatrix}$",
            proof=r"A free rod tilted by $\theta$ would fall with $-g(\sin2\theta, \cos2\theta)$ instead of $(0, -g)$.",
        ),
        Erratum(
            equation="(2.4), second entry",
            printed=r"$M_{XX} - M_X s_{XX}/s_X + T\theta_X - g\lambda_0\cos\theta$",
            correct=r"$(M_{XX} - M_X s_{XX}/s_X)/s_X + T\theta_X - g\lambda_0\cos\theta$",
            proof=r"$N_X$ with $N = M_X/s_X$; as printed, a free bent stretched arc changes its own momentum.",
        ),
    ],
)
