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
# # 9. A filament that shears, fibre by fibre
#
# The published theory has no shear strain: its sections stay normal to the centreline. We let them tilt. A section at
# $X$ has a position $r$ and an angle $\psi$ of its own; with $d_1 = (\cos\psi, \sin\psi)$ normal to it and
# $d_2 = (-\sin\psi, \cos\psi)$ in it,
# $$ r_X = \Lambda\,d_1 + \Gamma\,d_2, \qquad k = \psi_X. $$
# Nothing here is small but the thickness. Each fibre $\zeta = 2y/h$ has its own plastic state, so that the stress may
# have any profile. We derive the strains, the forces conjugate to $(\Lambda,\Gamma,k)$, the balance from Hamilton's
# principle, the energy and the flow of a fibre from the three-dimensional law of notebook 6, whose plastic shear is
# carried along by the plastic stretch, and we recover the paper's theory as shear becomes rigid.
#
# Effects derived here: `shear` (`reissner.director_strains`, `reissner.fibre_spring`), `fibres`
# (`reissner.fibre_flow`), `rotary-inertia` (`reissner.rotary_inertia`).

# %%
import sympy as sp
from proving import prove_equal, vanishes

from softcat_sym.physics import bulk, constitutive_laws, kinematics, reissner, sections
from softcat_sym.physics import section_response as closures
from softcat_sym.physics.reissner import Gam, Lam, S, eps_e, gamma_e, gamma_p, k, kappa_s, psi, tau_d, tau_f
from softcat_sym.physics.section_response import PLANE_STRAIN
from softcat_sym.physics.symbols import (
    A0,
    M_X,
    E,
    L,
    M,
    Q,
    T,
    X,
    eta,
    g,
    h0,
    rho,
    s,
    sigma,
    t,
    theta,
    theta_X,
    x_X,
    y_X,
    zeta,
)

# %% [markdown]
# ## Strains
#
# The fibre at distance $y$ from the centreline runs along $r + y\,d_2$. Its derivative, by $d_{1X} = k\,d_2$,
# $d_{2X} = -k\,d_1$:

# %%
angle, length, offset = (sp.Function(name, real=True)(X) for name in ("angle", "length", "offset"))
transverse = sp.Function("transverse", real=True)(X)
d1 = sp.Matrix([sp.cos(angle), sp.sin(angle)])
d2 = sp.Matrix([-sp.sin(angle), sp.cos(angle)])
fibre = length * d1 + transverse * d2 + sp.diff(offset * d2, X)
prove_equal(fibre.dot(d1), length - offset * sp.diff(angle, X))
prove_equal(fibre.dot(d2), transverse + sp.diff(offset, X))

tangent = sp.Matrix([x_X, y_X])
directors = (sp.Matrix([sp.cos(psi), sp.sin(psi)]), sp.Matrix([-sp.sin(psi), sp.cos(psi)]))
for director, held in zip(directors, reissner.director_strains(), strict=True):
    prove_equal(tangent.dot(director), held)

# %% [markdown]
# So the fibre is stretched by $f = \Lambda - yk$ along the normal of its section, and sheared by $\Gamma$ against it:
# in the frame of the section its deformation gradient has the first column $(f, \Gamma)$. We take $\epsilon = \log f$
# to first order in $y$, $\log\Lambda - yk/\Lambda$, and $\gamma$ proportional to $\Gamma/\Lambda$; what is dropped,
# $\frac12(yk/\Lambda)^2$, is the square of a strain that slenderness keeps small. With a uniform contraction
# $h = h_0\Lambda^{-1/2}$ (2.9), $y = h\zeta/2$. $\gamma$ has a factor $\sqrt{\kappa_s}$, the shear correction, for a
# reason that is given below.

# %%
y, small = sp.symbols("y small", real=True)
first_order = sp.series(sp.log(Lam - small * y * k), small, 0, 3).removeO()
prove_equal(first_order.coeff(small, 0) + first_order.coeff(small, 1), sp.log(Lam) - y * k / Lam)
prove_equal(first_order.coeff(small, 2), -(y**2) * k**2 / (2 * Lam**2))

thickness = {"both ways": h0 / sp.sqrt(Lam), "sheet": h0 / Lam}
cells = {"both ways": reissner.shearing_cell(sections.UNIFORM), "sheet": reissner.shearing_cell(sections.WIDE)}
axial = {name: sp.log(Lam) - h * zeta / 2 * k / Lam for name, h in thickness.items()}
shear = sp.sqrt(kappa_s) * Gam / Lam
shear_modulus = E / (2 * (1 + bulk.nu))
for name, cell in cells.items():
    prove_equal(thickness[name], cell.thickness)
    prove_equal(A0 / Lam, cell.area)
    prove_equal(axial[name], cell.axial_strain)
    prove_equal(shear, cell.shear_strain)

# %% [markdown]
# ## Conjugate forces
#
# Per unit of $X$ there is the volume $A_0$ ($= A\Lambda$: it does not change). Let $\hat\sigma$ and $\tau$ be
# conjugate to $\epsilon$ and $\gamma$. The power of the stress is
# $A_0\langle\hat\sigma\,\epsilon_t + \tau\,\gamma_t\rangle$, and $(n_1, n_2, m)$ are what multiplies $\Lambda_t$,
# $\Gamma_t$, $k_t$. With $T = A\langle\hat\sigma\rangle$, $M = A\frac h2\langle\hat\sigma\zeta\rangle$,
# $S = \sqrt{\kappa_s}A\langle\tau\rangle$:

# %%
mean, mean_zeta, mean_shear = sp.symbols("mean mean_zeta mean_shear", real=True)


def conjugate(strain, thickness_now, variable):
    """The factor of v_t in A0 <sigma_c eps_t + tau gamma_t>, in T, M and S."""
    by_fibre = sp.Poly(sp.diff(strain, variable), zeta)
    power = A0 * (by_fibre.coeff_monomial(1) * mean + by_fibre.coeff_monomial(zeta) * mean_zeta)
    power += A0 * mean_shear * sp.diff(shear, variable)
    area = A0 / Lam
    means = {mean: T / area, mean_zeta: 2 * M / (area * thickness_now), mean_shear: S / (sp.sqrt(kappa_s) * area)}
    return sp.expand(power.subs(means))


derived = {name: [conjugate(axial[name], thickness[name], v) for v in (Lam, Gam, k)] for name in cells}
derived["both ways"]

# %%
for name, cell in cells.items():
    for found, held in zip(derived[name], (cell.normal_force, cell.section_force, cell.couple), strict=True):
        prove_equal(found, held)
    prove_equal(A0 / Lam * reissner.sigma_mean, cell.tension)
    prove_equal(A0 / Lam * thickness[name] / 2 * reissner.sigma_zeta, cell.moment)
    prove_equal(sp.sqrt(kappa_s) * A0 / Lam * reissner.tau_mean, cell.shear_force)
prove_equal(derived["both ways"][0], T + sp.Rational(3, 2) * M * k / Lam - S * Gam / Lam)
prove_equal(derived["sheet"][0], T + 2 * M * k / Lam - S * Gam / Lam)

# %% [markdown]
# The factor 3/2 counts that a stretching section turns less per length (1) and thins (1/2). $-S\Gamma/\Lambda$ is
# there because the shear strain is a ratio, $\Gamma/\Lambda$: stretching at a fixed $\Gamma$ reduces it. Leave either
# out, and an elastic filament makes or loses energy.
#
# ## Balance, from Hamilton's principle
#
# For any stored energy $W(\Lambda,\Gamma,k)$: the action of
# $\frac12\lambda_0|r_t|^2 + \frac12\rho I_0\psi_t^2 - W - \lambda_0gy$, with $\Lambda = r_X\cdot d_1$ and
# $\Gamma = r_X\cdot d_2$, is stationary. The forces that are not elastic do the same virtual work.

# %%
x_of, y_of, psi_of, n1, n2, m = (sp.Function(name, real=True)(X, t) for name in ("x", "y", "psi", "n_1", "n_2", "m"))
rates = sp.symbols("x_t y_t psi_t", real=True)
gradient = sp.symbols("x_X y_X psi_X", real=True)
height, turned = sp.symbols("height turned", real=True)
energy = sp.Function("W")
inertia, mass = sp.symbols("inertia mass", positive=True)
Lam_of = gradient[0] * sp.cos(turned) + gradient[1] * sp.sin(turned)
Gam_of = -gradient[0] * sp.sin(turned) + gradient[1] * sp.cos(turned)
kinetic = mass * (rates[0] ** 2 + rates[1] ** 2) / 2 + inertia * rates[2] ** 2 / 2


def potential_slope(variable):
    """dW/dv with W_Lam = n1, W_Gam = n2, W_k = m: the definition of the conjugate forces."""
    return n1 * sp.diff(Lam_of, variable) + n2 * sp.diff(Gam_of, variable) + m * sp.diff(gradient[2], variable)


fields = dict(zip(gradient, [sp.diff(f, X) for f in (x_of, y_of, psi_of)], strict=True)) | {turned: psi_of}
velocities = dict(zip(rates, [sp.diff(f, t) for f in (x_of, y_of, psi_of)], strict=True))


def euler_lagrange(n, own):
    """d/dt K_rate + d/dX(-W_gradient) + W_own = 0, solved for the inertia."""
    momentum = sp.diff(sp.diff(kinetic, rates[n]).subs(velocities), t)
    flux = sp.diff(potential_slope(gradient[n]).subs(fields), X)
    source = potential_slope(own).subs(fields) if own == turned else mass * g * sp.Integer(own == height)
    return momentum, flux - source


motions = (euler_lagrange(0, sp.Symbol("nothing")), euler_lagrange(1, height), euler_lagrange(2, turned))
section_inertia = rho * sp.integrate(y**2, (y, -h0 / 2, h0 / 2)) * A0 / h0
here = {mass: rho * A0, inertia: section_inertia}
turn = sp.Matrix([sp.cos(psi_of), sp.sin(psi_of)])
pull = (n1 * turn + n2 * sp.Matrix([-turn[1], turn[0]])).diff(X)
moment = m.diff(X) + Lam_of.subs(fields) * n2 - Gam_of.subs(fields) * n1
inertias = (rho * A0, rho * A0, reissner.rotary_inertia(sections.RECTANGLE))
forces = (pull[0], pull[1] - rho * A0 * g, moment)
for (left, right), of, field, force in zip(motions, inertias, (x_of, y_of, psi_of), forces, strict=True):
    prove_equal(left.subs(here), of * field.diff(t, 2))
    prove_equal(right.subs(here), force)
motions[2]

# %% [markdown]
# That is $\lambda_0r_{tt} = (n_1d_1 + n_2d_2)_X - \lambda_0g\,e_y$ and
# $\rho I_0\psi_{tt} = m_X + \Lambda n_2 - \Gamma n_1$. The pieces of it that a cell computes:

# %%
for cell in cells.values():
    for held, variable in zip(cell.force, gradient[:2], strict=True):
        slope = potential_slope(variable).subs(turned, psi)
        prove_equal(slope.subs({n1: reissner.n_1, n2: reissner.n_2}), held)
    turning = -potential_slope(turned).subs({n1: reissner.n_1, n2: reissner.n_2})
    as_strains = {
        gradient[0]: Lam * sp.cos(turned) - Gam * sp.sin(turned),
        gradient[1]: Lam * sp.sin(turned) + Gam * sp.cos(turned),
    }
    prove_equal(turning.subs(as_strains), cell.turning_moment)

# %% [markdown]
# ## Rotary inertia is negligible
#
# $I_0$ is that of the undeformed section. With the thinning it would be $I_0/\Lambda$ (and a force
# $\frac12\rho I_0\psi_t^2/\Lambda^2$ would join $n_1$). None of it matters: in a vibration of shape $w$ it lowers
# $\omega^2$ by the fraction $(I_0/A_0)\int w'^2/\int w^2$. For the first mode between clamps, and a rectangle:

# %%
thinned = (
    rho * sp.integrate(y**2, (y, -thickness["both ways"] / 2, thickness["both ways"] / 2)) * A0 / thickness["both ways"]
)
prove_equal(thinned, section_inertia / Lam)
for shape, squared in ((sections.RECTANGLE, sp.Rational(1, 12)), (sections.CIRCLE, sp.Rational(1, 16))):
    prove_equal(reissner.rotary_inertia(shape), rho * A0 * h0**2 * squared)

root = sp.nsolve(sp.cos(y) * sp.cosh(y) - 1, y, 4.73)
u = sp.Symbol("u", real=True)
ends = (sp.cosh(root) - sp.cos(root)) / (sp.sinh(root) - sp.sin(root))
mode = sp.cosh(root * u) - sp.cos(root * u) - ends * (sp.sinh(root * u) - sp.sin(root * u))
steps = 200
samples = [(sp.Rational(2 * n + 1, 2 * steps)) for n in range(steps)]
shape, slope = (sp.lambdify(u, f, "math") for f in (mode, sp.diff(mode, u)))
ratio = sum(slope(float(p)) ** 2 for p in samples) / sum(shape(float(p)) ** 2 for p in samples)
slenderness = 0.03
rotary_share = ratio * slenderness**2 / 12
assert abs(ratio - 12.30) < 0.01 and rotary_share < 1e-3
rotary_share

# %% [markdown]
# 0.09 % of $\omega^2$ at the paper's $\delta = 0.03$. Without it $\psi$ obeys $m_X + \Lambda n_2 - \Gamma n_1 = 0$, an
# algebraic equation.
#
# The shear itself is not negligible: under its weight a clamped elastic beam sags by $qL^4/(384EI)$ in bending and
# $qL^2/(8\kappa_s\mu A)$ in shear. Their ratio is $8(1+\nu)\delta^2/\kappa_s$, 1.3 % at $\delta = 0.03$.

# %%
load, delta = sp.symbols("load delta", positive=True)
second_moment = A0 * h0**2 / 12
bending_sag = load * L**4 / (384 * E * second_moment)
v = sp.Function("v")
position = sp.Symbol("position", real=True)
half_span = load * (L / 2 - position)  # shear force at a distance from the left clamp
shear_sag = sp.integrate(half_span / (kappa_s * shear_modulus * A0), (position, 0, L / 2))
share = sp.simplify((shear_sag / bending_sag).subs(h0, delta * L))
prove_equal(share, 8 * (1 + bulk.nu) * delta**2 / kappa_s)
assert 0.012 < share.subs({bulk.nu: sp.Rational(9, 20), kappa_s: sp.Rational(5, 6), delta: sp.Rational(3, 100)}) < 0.013

# %% [markdown]
# ## The Kirchhoff limit: the paper's filament
#
# Let the shear modulus grow, $\mu = \mu_1/\varepsilon$, at a finite shear force $S$. From
# $S = A\kappa_s\mu\,\Gamma/\Lambda$ (elastic shear) $\Gamma = O(\varepsilon)$. Then $\Lambda = |r_X| = s$ and
# $\psi = \theta$; the moment balance without rotary inertia becomes $m_X + s\,n_2 = 0$, and with $m = -M$:
# $$ n_2 = N = M_X/s, \qquad n_1 = T + \tfrac32 M\theta_s = Q. $$
# So $n_1d_1 + n_2d_2 = Q\,t + N\,n$, the force of the paper (corrected).

# %%
stiff, modulus_1 = sp.symbols("stiff modulus_1", positive=True)
tilt = sp.solve(A0 / Lam * kappa_s * modulus_1 / stiff * Gam / Lam - S, Gam)[0]
assert tilt.subs(stiff, 0) == 0
prove_equal(sp.sqrt(Lam**2 + tilt**2).subs(stiff, 0), Lam)
straight = {x_X: s * sp.cos(theta), y_X: s * sp.sin(theta)}
for held, limit in zip(reissner.director_strains(), (s, 0), strict=True):
    prove_equal(held.subs(psi, theta).subs(straight), limit)

unsheared = {Gam: 0, Lam: s, k: theta_X, psi: theta}
both = cells["both ways"]
moment_balance = -M_X + both.turning_moment.subs(unsheared)
transverse_force = sp.solve(moment_balance, reissner.n_2)[0]
prove_equal(transverse_force, M_X / s)
for name, contraction in (("both ways", sections.UNIFORM), ("sheet", sections.WIDE)):
    closed = closures.material(kinematics.TRUE_STRAIN, contraction)
    prove_equal(derived[name][0].subs(unsheared) - T, closed.axial_correction)
    prove_equal(-sp.diff(axial[name], zeta).subs(unsheared) / theta_X, closed.lever)

kirchhoff = kinematics.internal_force(kinematics.LARGE_ROTATION, bending=True)
for held, paper in zip(both.force, (kirchhoff.horizontal, kirchhoff.vertical), strict=True):
    limit = held.subs(unsheared).subs({reissner.n_1: Q, reissner.n_2: transverse_force})
    prove_equal(limit, paper.subs(straight))

# %% [markdown]
# ### Signs
#
# The upper side is $\zeta > 0$. $k > 0$ (a sagging filament at midspan) *shortens* it,
# $\epsilon_\zeta = -kh/(2\Lambda)$, and $M = A\frac h2\langle\sigma\zeta\rangle$ is then negative: $M$ has the sign of
# $-k$, and $m = -M$ that of $k$. For an elastic section:

# %%
weighted = sp.integrate(axial["both ways"] * zeta * sections.RECTANGLE.weight, (zeta, -1, 1))
elastic_moment = both.moment.subs(reissner.sigma_zeta, E * weighted)
prove_equal(elastic_moment, -E * (A0 * h0**2 / 12 / Lam**2) * k / Lam)

# %% [markdown]
# that is $M = -EI\theta_s$, $I = I_0/s^2$ (2.9)-(2.11) with the objective curvature.
#
# ## Plastic shear is carried by the plastic stretch
#
# In the frame of its section the deformation gradient of a fibre is lower triangular: it stretches by $f$ along the
# normal, contracts by $a(f)$ through the thickness and, unless the section is a sheet, by the same across it, and
# shears by $g$. The volume is kept: $a = f^{-1/2}$, in a sheet $a = 1/f$. Write $\epsilon = \log f$, $\gamma = g/f$ and
# $a/f = e^{-c\epsilon}$, so that $c = 3/2$ or $2$: minus the exponent of $\Lambda$ in the lever of a fibre.

# %%
c, f_e, f_p, g_e, g_p = sp.symbols("c f_e f_p g_e g_p", positive=True)


def triangular(stretch, slide):
    """Deformation gradient of a fibre in the frame of its section; the third direction follows from the volume."""
    return sp.Matrix([[stretch, 0, 0], [slide, stretch ** (1 - c), 0], [0, 0, stretch ** (c - 2)]])


for name, carry in (("both ways", sp.Rational(3, 2)), ("sheet", sp.Integer(2))):
    prove_equal(carry, cells[name].carry)
    prove_equal(triangular(Lam, 0).subs(c, carry).det(), 1)
    prove_equal(triangular(Lam, 0)[1, 1].subs(c, carry) * h0, thickness[name])
prove_equal(triangular(Lam, 0)[2, 2].subs(c, 2), 1)

# %% [markdown]
# Such gradients are a group: their products and inverses are such. So $F = F_eF_p$ (3.1) can be taken inside it, as
# the plane sections of a filament ask. Axial strains add, but a plastic shear is seen through the elastic stretch:
# $$ \epsilon = \epsilon^e + \epsilon^p, \qquad \gamma = \gamma^e + \gamma^p e^{-c\,\epsilon^e}. $$

# %%
product = triangular(f_e, g_e) * triangular(f_p, g_p)
for entry in range(3):
    prove_equal(sp.expand_power_base(triangular(f_e * f_p, 0)[entry, entry]), product[entry, entry])
prove_equal(sp.expand(product[1, 0] / product[0, 0]), g_e / f_e + g_p / f_p * f_e ** (-c))
for cell in cells.values():
    spring = reissner.fibre_spring(E, shear_modulus, cell.carry)
    prove_equal(reissner.eps - reissner.eps_p, spring.elastic[0])
    prove_equal(reissner.gamma - gamma_p * sp.exp(-cell.carry * eps_e), spring.elastic[1])

# %% [markdown]
# The plastic rate is the symmetric part of $L_p = F_{p,t}F_p^{-1}$ (3.8, corrected). Its axial entry is $\epsilon^p_t$,
# and twice its shear entry
# $$ 2D^p_{12} = \gamma^p_t + c\,\gamma^p\epsilon^p_t . $$
# The second term is what an addition of shears forgets: a fibre that stretches takes its shear along, and turns it
# towards itself.

# %%
plastic, plastic_shear, eps, gam = (sp.Function(name)(t) for name in ("plastic", "plastic_shear", "eps", "gam"))


def rate_of(strain, ratio):
    """Symmetric part of F_t F^-1 of a triangular F with these strains."""
    gradient_now = triangular(sp.exp(strain), ratio * sp.exp(strain))
    rate = sp.diff(gradient_now, t) * gradient_now.inv()
    return ((rate + rate.T) / 2).applyfunc(sp.simplify)


plastic_rate = rate_of(plastic, plastic_shear)
prove_equal(plastic_rate[0, 0], sp.diff(plastic, t))
prove_equal(2 * plastic_rate[0, 1], sp.diff(plastic_shear, t) + c * plastic_shear * sp.diff(plastic, t))
prove_equal(plastic_rate[1, 1], (1 - c) * sp.diff(plastic, t))

# %% [markdown]
# ## Stresses, and what is dissipated
#
# Let $W(\epsilon^e, \gamma^e)$ be any stored energy per volume, $\sigma = W_{\epsilon^e}$, $\tau = W_{\gamma^e}$. By
# the chain rule $W_t = \hat\sigma\epsilon_t + \tau\gamma_t - (\sigma\,\epsilon^p_t + \tau_d\,2D^p_{12})$ with
# $$ \tau_d = e^{-c\,\epsilon^e}\tau, \qquad \hat\sigma = \sigma + c\,\gamma^p\tau_d . $$
# $\hat\sigma$ and $\tau$ are conjugate to the strains: they make the forces. $(\sigma, \tau_d)$ are conjugate to the
# rates of $L_p$: they drive the flow.

# %%
W = sp.Function("W")(eps_e, gamma_e)
elastic_now = {eps_e: eps - plastic, gamma_e: gam - plastic_shear * sp.exp(-c * (eps - plastic))}
of_W = {sigma: sp.diff(W, eps_e), tau_f: sp.diff(W, gamma_e)}
stored_rate = sum(sp.diff(W, strain) * sp.diff(elastic_now[strain], t) for strain in (eps_e, gamma_e))
for cell in cells.values():
    spring = reissner.fibre_spring(E, shear_modulus, cell.carry)
    held_drive = spring.driving[0].subs(eps_e, elastic_now[eps_e])
    held_along = spring.conjugate.subs({tau_d: held_drive, gamma_p: plastic_shear})
    supplied = held_along * sp.diff(eps, t) + tau_f * sp.diff(gam, t)
    wasted = sigma * plastic_rate[0, 0] + held_drive * 2 * plastic_rate[0, 1]
    balance = (supplied - wasted).subs(of_W) - stored_rate
    prove_equal(balance.subs(c, cell.carry), 0)
    for symbol, value in zip((sigma, tau_f), spring.stress, strict=True):
        prove_equal(of_W[symbol].subs(W, spring.stored).doit(), value.subs(sigma, spring.stress[0]))

# %% [markdown]
# ### The three-dimensional law under $(\sigma, \tau_d)$
#
# A stress that does this power and no other has the entries $\sigma$ and $\tau_d$. In a sheet there is a third that
# does none, across the width, $\sigma/2$ if the width is not to flow. (3.7) then gives the rates, and keeps the flow in
# the group: it contracts as a triangular gradient does.

# %%
phi = sp.Function("phi", positive=True)
lateral = {"both ways": 0, "sheet": sigma / 2}
shares = {"both ways": sp.Integer(1), "sheet": PLANE_STRAIN**2}
for name, cell in cells.items():
    stress = sp.Matrix([[sigma, tau_d, 0], [tau_d, 0, 0], [0, 0, lateral[name]]])
    deviator = stress - sp.eye(3) * stress.trace() / 3
    equivalent = sp.sqrt(sp.Rational(3, 2) * sum(entry**2 for entry in deviator))
    flow = sp.Rational(3, 2) * phi(bulk.sigma_eq) / bulk.sigma_eq * deviator
    for ours, theirs in zip(flow, bulk.plastic_flow(stress, phi(sigma)), strict=True):
        prove_equal(ours, theirs)
    held_flow = reissner.fibre_flow(phi(sigma), shares[name], cell.carry)
    prove_equal(equivalent**2, shares[name] * sigma**2 + 3 * tau_d**2)
    prove_equal(equivalent**2, held_flow.equivalent**2)  # both are positive roots
    prove_equal(flow[0, 0], held_flow.axial_rate)
    prove_equal(2 * flow[0, 1], held_flow.shear_rate[0] + cell.carry * gamma_p * held_flow.axial_rate)
    prove_equal(flow[1, 1], (1 - cell.carry) * flow[0, 0])
    prove_equal(flow[0, 2], 0)
    spring = reissner.fibre_spring(E, shear_modulus, cell.carry)
    power = spring.conjugate * held_flow.axial_rate + tau_d * held_flow.shear_rate[0]
    prove_equal(power, phi(bulk.sigma_eq) * equivalent**2 / bulk.sigma_eq)
    prove_equal(power.subs(bulk.sigma_eq, equivalent), held_flow.dissipation.subs(bulk.sigma_eq, equivalent))

# %% [markdown]
# So the whole balance closes, $\hat\sigma\epsilon_t + \tau\gamma_t = W_t + \sigma_{eq}\varphi(\sigma_{eq})$, whatever
# the plastic state, and no fibre gives back what it has dissipated. The shear is twice $\epsilon_{12}$, hence the 3.
#
# ## The stored energy
#
# Hencky's, $\mu\sum\log^2\lambda_i$ (3.5) at constant volume. With $e^q$ the ratio of the two principal stretches in
# the plane, $\cosh q = (f/a + a/f)/2 + g^2/(2fa)$, and their product $fa$:
# $$ W = \tfrac12\mu\left(q^2 + \log^2(fa)\right) + \mu\log^2(fa), $$
# where $fa = 1$ in a sheet. To third order in the strains it is
# $\frac12E(\epsilon^e + \frac14\gamma^{e2})^2 + \frac12\mu\gamma^{e2}$ with $E = 3\mu$, in a sheet $4\mu$.
# $\frac14\gamma^{e2}$ is kinematics, whatever Poisson's ratio: the axial entry of $\log\sqrt{F^TF}$ in simple shear. A
# filament that is sheared pulls on its supports.

# %%
mu, size, e1, g1 = sp.symbols("mu size e1 g1", positive=True)
for carry, modulus in ((sp.Rational(3, 2), 3 * mu), (sp.Integer(2), 4 * mu)):
    # f/a and g^2/(fa) of f = exp(size e1), g = size g1 f.
    cosh_q = sp.cosh(carry * size * e1) + (size * g1) ** 2 * sp.exp(carry * size * e1) / 2
    matrix = triangular(f_e, g_e).subs(c, carry)[:2, :2]
    exact_cosh = ((matrix.T * matrix).trace() / (2 * matrix.det())).subs({g_e: size * g1 * f_e})
    prove_equal(exact_cosh.subs(f_e, sp.exp(size * e1)).rewrite(sp.exp), cosh_q.rewrite(sp.exp))
    x = sp.series(cosh_q - 1, size, 0, 4).removeO()
    of_volume = (2 - carry) * size * e1
    exact = mu * (2 * x + of_volume**2) / 2 + mu * of_volume**2  # arccosh(1 + x)^2 = 2 x to third order in the strains
    held_energy = reissner.fibre_spring(modulus, mu, carry).stored.subs({eps_e: size * e1, gamma_e: size * g1})
    for order in (2, 3):
        prove_equal(sp.expand(exact).coeff(size, order), sp.expand(held_energy).coeff(size, order))
simple = sp.Matrix([[1, 0], [small, 1]])
green = simple.T * simple - sp.eye(2)
log_stretch = (green / 2 - green**2 / 4).applyfunc(sp.expand)
prove_equal(log_stretch[0, 0].coeff(small, 2), sp.Rational(1, 4))

# %% [markdown]
# It also says how far a filament may be stretched. Turned by $\psi$ against a centreline that is held at a stretch $s$,
# $\Lambda = s\cos\psi$, $\Gamma = -s\sin\psi$, a section stores least when square to it only while
# $\log s\,(1 - \kappa_s/2) < \kappa_s\mu/E$.

# %%
held_at = {eps_e: sp.log(s) + sp.log(sp.cos(psi)), gamma_e: -sp.sqrt(kappa_s) * sp.tan(psi)}
turned = reissner.fibre_spring(E, shear_modulus).stored.subs(held_at)
stiffness = sp.diff(turned, psi, 2).subs(psi, 0)
prove_equal(sp.diff(turned, psi).subs(psi, 0), 0)
prove_equal(stiffness, kappa_s * shear_modulus - E * sp.log(s) * (1 - kappa_s / 2))

# %% [markdown]
# ### Small strains
#
# To first order in the strains $\gamma^e = \gamma - \gamma^p$, $\hat\sigma = \sigma = E(\epsilon - \epsilon^p)$,
# $\tau_d = \tau = \mu\gamma^e$, $\gamma^p_t = 3\varphi\tau/\sigma_{eq}$: shears that add. What is carried differs from
# it by a share of the order of the stretch.

# %%
strains = (reissner.eps, reissner.gamma, reissner.eps_p, gamma_p)
tiny = {one: size * one for one in strains}
for cell in cells.values():
    spring = reissner.fibre_spring(E, shear_modulus, cell.carry)
    elastic = {eps_e: spring.elastic[0].subs(tiny)}
    elastic[gamma_e] = spring.elastic[1].subs(tiny).subs(elastic)
    now = {sigma: spring.stress[0].subs(elastic)}
    now[tau_f] = spring.stress[1].subs(elastic).subs(now)
    now[tau_d] = spring.driving[0].subs(elastic).subs(now)
    now[reissner.sigma_c] = spring.conjugate.subs(tiny).subs(now)
    stretching, sliding = E * (reissner.eps - reissner.eps_p), shear_modulus * (reissner.gamma - gamma_p)
    for symbol, wanted in ((sigma, stretching), (reissner.sigma_c, stretching), (tau_f, sliding), (tau_d, sliding)):
        prove_equal(now[symbol].subs(size, 0), 0)
        prove_equal(sp.diff(now[symbol], size).subs(size, 0), wanted)
    added = reissner.fibre_flow(phi(sigma), sp.S.One, cell.carry).shear_rate[0].subs(gamma_p, 0)
    prove_equal(added, 3 * phi(bulk.sigma_eq) * tau_d / bulk.sigma_eq)

# %% [markdown]
# ## A viscous stress beside the springs
#
# It sees the whole deformation, whose rate has the entries $\epsilon_t$ and $\gamma_t + c\,\gamma\epsilon_t$: the same
# derivation with $F$ in place of $F_p$. With Trouton's $\eta = 3\mu$ the Rayleigh potential, half the power of
# $\frac23\eta D$, is
# $$ R = \tfrac12\eta\,\epsilon_t^2 + \tfrac16\eta\,(\gamma_t + c\,\gamma\epsilon_t)^2 , $$
# with $\frac43\eta$ for the stretch of a sheet.

# %%
for shape, name in ((sections.RECTANGLE, "both ways"), (sections.CIRCLE, "both ways"), (sections.SHEET, "sheet")):
    whole_rate = rate_of(eps, gam).subs(c, cells[name].carry)
    potential = reissner.resolve(shape, constitutive_laws.law_of("kelvin-voigt"), shear=True).viscous.rayleigh
    moving = {reissner.eps_t: sp.diff(eps, t), reissner.gamma_t: sp.diff(gam, t), reissner.gamma: gam}
    prove_equal(eta / 3 * sum(entry**2 for entry in whole_rate), potential.subs(moving))

# %% [markdown]
# ## Shear correction
#
# One shear for the whole section cannot be right: the true elastic shear stress vanishes at both surfaces,
# $\tau\propto1-\zeta^2$. Choose $\kappa_s$ so that the section stores the right energy,
# $\langle\tau^2\rangle/2\mu = \langle\tau\rangle^2/(2\kappa_s\mu)$.

# %%
parabola = 1 - zeta**2


def by_energy(weight):
    mean_stress = sp.integrate(parabola * weight, (zeta, -1, 1))
    return mean_stress**2 / sp.integrate(parabola**2 * weight, (zeta, -1, 1))


# The parabola follows from equilibrium: a bending stress linear in zeta leaves tau_zeta w proportional to zeta w.
for shape in (sections.RECTANGLE, sections.CIRCLE):
    carried = sp.diff(parabola * shape.weight, zeta) / (zeta * shape.weight)
    assert vanishes(sp.diff(carried, zeta))
prove_equal(by_energy(sp.Rational(1, 2)), sections.RECTANGLE.shear_correction)
prove_equal(by_energy(2 * sp.sqrt(1 - zeta**2) / sp.pi), sections.CIRCLE.shear_correction)

# %% [markdown]
# The circle's 9/10 counts the vertical shear stress alone. Cowper's $6(1+\nu)/(7+6\nu)$, from three-dimensional
# elasticity, is 9/10 too if the solid is incompressible, and 0.897 at $\nu = 0.45$.
#
# It stands as its root at the strain, $\gamma = \sqrt{\kappa_s}\,\Gamma/\Lambda$, $S =
# \sqrt{\kappa_s}A\langle\tau\rangle$. An elastic section has $S = \kappa_s\mu A\,\Gamma/\Lambda$ either way. So has a
# viscous one, with $\eta/3$ for $\mu$ and rates, as it must: its profile is the same parabola. At the modulus, $\tau =
# \kappa_s\mu(\Gamma/\Lambda - \gamma^p)$, a section that has flowed for long would resist with all of $\eta/3$ and none
# of $\kappa_s$. Where a section yields the profile is another: $\kappa_s$ is then a convention, and its transverse
# force at yield, $\sqrt{\kappa_s}A\tau_Y$, lies between that of the first point that yields in the parabola,
# $\frac23A\tau_Y$, and that of all, $A\tau_Y$.

# %%
sliding_rate = sp.Symbol("sliding_rate", positive=True)
maxwell = reissner.fibre_flow(constitutive_laws.maxwell_rate()).shear_rate[0].subs(gamma_p, 0)
steady = sp.solve(maxwell.subs(tau_d, tau_f) - sp.sqrt(kappa_s) * sliding_rate, tau_f)[0]
prove_equal(sp.sqrt(kappa_s) * A0 * steady, kappa_s * eta / 3 * A0 * sliding_rate)
cowper_circle = 6 * (1 + bulk.nu) / (7 + 6 * bulk.nu)
prove_equal(cowper_circle.subs(bulk.nu, sp.Rational(1, 2)), sections.CIRCLE.shear_correction)

# %% [markdown]
# ## What the package holds

# %%
spring = reissner.fibre_spring(E, bulk.shear_modulus())
prove_equal(spring.stress[0], E * (eps_e + gamma_e**2 / 4))
prove_equal(spring.stress[1], shear_modulus * gamma_e + sigma * gamma_e / 2)
prove_equal(spring.driving[0], tau_f * sp.exp(-sp.Rational(3, 2) * eps_e))
for held, found in zip((both.normal_force, both.section_force, both.couple), derived["both ways"], strict=True):
    prove_equal(held, found)
for rule in (constitutive_laws.bingham_rate(), constitutive_laws.maxwell_rate()):
    of_rule = reissner.fibre_flow(rule)
    prove_equal(of_rule.equivalent**2, sigma**2 + 3 * tau_d**2)
    speed = rule.subs(sigma, bulk.sigma_eq)
    prove_equal(of_rule.axial_rate, speed * sigma / bulk.sigma_eq)
    turning = sp.Rational(3, 2) * gamma_p * of_rule.axial_rate
    prove_equal(of_rule.shear_rate[0], 3 * speed * tau_d / bulk.sigma_eq - turning)
