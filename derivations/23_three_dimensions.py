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
# # 23. Three dimensions
#
# A filament that bends sideways and twists: a centreline $r(X)$ and a section with axes $R=[d_1\,d_2\,d_3]$, which is
# a unit quaternion $q$ at every node. Its strains are $\Gamma = R^\mathsf{T}r'=(\Lambda,\Gamma_2,\Gamma_3)$ and
# $\kappa=\mathrm{axial}(R^\mathsf{T}R')$: twist $\kappa_1$ and two curvatures. What follows proves what the package
# holds in `physics/spatial.py`: turns, the strains of a point, the flow of what is stretched and twisted at once, the
# resultants, and that a filament in one plane is the planar one.

# %%
import sympy as sp
from proving import prove_equal, vanishes

from softcat_sym.physics import reissner
from softcat_sym.physics import spatial as sl
from softcat_sym.physics.bulk import nu, shear_modulus, sigma_eq
from softcat_sym.physics.reissner import eps_e
from softcat_sym.physics.symbols import E, h0, sigma

t, X = sp.symbols("t X", real=True)
w, x, y, z, a, b, c, psi = sp.symbols("w x y z a b c psi", real=True)
mu = sp.symbols("mu", positive=True)


def matrix(q):
    """R(q), column by column."""
    columns = [sl.rotated(q, axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return sp.Matrix(columns).T


def product(p, q):
    """Of two quaternions."""
    return sl.relative((p[0], -p[1], -p[2], -p[3]), q)


# %% [markdown]
# ## Turns
#
# $R(q)$ is orthogonal whatever the length of $q$; the turn of $pq$ is that of $q$ and then of $p$; `relative` is
# $\bar q_a q_b$, so that $R(\bar q_a q_b)=R_a^\mathsf{T}R_b$ knows nothing of a turn of the whole.

# %%
q = (w, x, y, z)
assert all(vanishes(entry) for entry in matrix(q).T * matrix(q) - sp.eye(3))
p = sp.symbols("p0:4", real=True)
assert all(vanishes(entry) for entry in matrix(product(p, q)) - matrix(p) * matrix(q))
assert all(vanishes(entry) for entry in matrix(sl.relative(p, q)) - matrix(p).T * matrix(q))
g = sp.symbols("g0:4", real=True)
whole = [sp.expand(one) for one in sl.relative(product(g, p), product(g, q))]
size = sum(one**2 for one in g)
for turned, plain in zip(whole, sl.relative(p, q), strict=True):
    prove_equal(turned, size * plain)

# %% [markdown]
# Along the filament $q' = \frac12 q\,(0,\kappa)$, so that $\bar q_a q_b$ of two nodes a distance $d$ apart is, for a
# constant $\kappa$, $(\cos\frac{|\kappa|d}{2},\ \frac{\kappa}{|\kappa|}\sin\frac{|\kappa|d}{2})$: the package's
# $2\,\mathrm{atan2}(|v|,w)\,v/(|v|d)$ is exact for arcs and helices.

# %%
k1, k2, k3, d = sp.symbols("k1 k2 k3 d", positive=True)
omega = sp.sqrt(k1**2 + k2**2 + k3**2)
along = (sp.cos(omega * X / 2), *(k / omega * sp.sin(omega * X / 2) for k in (k1, k2, k3)))
for moved, expected in zip([sp.diff(one, X) for one in along], product(along, (0, k1, k2, k3)), strict=True):
    prove_equal(moved, expected / 2)
kappa = matrix(along).T * matrix(along).diff(X)
for found, known in ((kappa[2, 1], k1), (kappa[0, 2], k2), (kappa[1, 0], k3)):
    assert abs((found - known).subs({k1: 0.7, k2: 1.1, k3: 0.4, X: 0.9}).evalf()) < 1e-14
# Numbers suffice there: both sides are analytic, and the line above proves the rate of the quaternion itself.

# %% [markdown]
# ## In one plane
#
# $q=(\cos\frac\psi2,0,0,\sin\frac\psi2)$ gives Reissner's strains: $\Lambda=x'\cos\psi+y'\sin\psi$,
# $\Gamma=y'\cos\psi-x'\sin\psi$, $\kappa_3=\psi'$, and nothing else.

# %%
level = (sp.cos(psi / 2), 0, 0, sp.sin(psi / 2))
Lam, Gam, Gam_3 = sl.unrotated(level, (a, b, 0))
prove_equal(Lam, a * sp.cos(psi) + b * sp.sin(psi))
prove_equal(Gam, b * sp.cos(psi) - a * sp.sin(psi))
prove_equal(Gam_3, 0)
angle = sp.Function("psi")(X)
level = (sp.cos(angle / 2), 0, 0, sp.sin(angle / 2))
rate = product((level[0], 0, 0, -level[3]), [sp.diff(one, X) for one in level])
prove_equal(2 * rate[3], sp.diff(angle, X))
assert vanishes(rate[1]) and vanishes(rate[2])

# %% [markdown]
# ## Strains of a point
#
# A point at $(Y,Z)$ is stretched along the filament by $f$ and carried beside by $g_i$; the section shrinks by
# $f^{-1/2}$: $F$ is lower triangular. Such matrices are a group, in which $F=F_eF_p$ makes
# $\gamma=\gamma_e+\gamma_p e^{-3\epsilon_e/2}$, $\epsilon=\epsilon_e+\epsilon_p$. Adding shears instead is wrong by
# 20 to 50 % where stretch and twist go together.

# %%
e, ep, ge2, ge3, gp2, gp3 = sp.symbols("e e_p g_e2 g_e3 g_p2 g_p3", real=True)


def gradient(strain, second, third):
    """F of an axial strain and two shears g/f."""
    f = sp.exp(strain)
    return sp.Matrix([[f, 0, 0], [f * second, f ** -sp.Rational(1, 2), 0], [f * third, 0, f ** -sp.Rational(1, 2)]])


whole = sp.simplify(gradient(e, ge2, ge3) * gradient(ep, gp2, gp3))
spring = reissner.fibre_spring(E, shear_modulus(), shears=sl.SHEARS)
total = [whole[1, 0] / whole[0, 0], whole[2, 0] / whole[0, 0]]
prove_equal(sp.log(whole[0, 0]).subs({e: 0.3, ep: 0.2}), sp.Float(0.5))
known = {sl.gamma[0]: total[0], sl.gamma[1]: total[1], sl.gamma_p[0]: gp2, sl.gamma_p[1]: gp3}

prove_equal(sp.simplify(spring.elastic[1].subs(known).subs(eps_e, e)), ge2)
prove_equal(sp.simplify(spring.elastic[2].subs(known).subs(eps_e, e)), ge3)

# %% [markdown]
# The plastic rate of shear is $2D_{p,12}=\dot\gamma_p+\frac32\gamma_p\dot\epsilon_p$, off the diagonal of
# $\dot F_pF_p^{-1}$; the flow rule that leaves $d_i$ its power is $\dot\gamma_p=3\varphi d/\sigma_{eq}
# -\frac32\gamma_p\dot\epsilon_p$.

# %%
ept, gpt = sp.Function("ep")(t), sp.Function("gp")(t)
Fp = gradient(ept, gpt, 0)
Lp = sp.simplify(Fp.diff(t) * Fp.inv())
prove_equal(Lp[1, 0], sp.diff(gpt, t) + sp.Rational(3, 2) * gpt * sp.diff(ept, t))

# %% [markdown]
# ## One energy
#
# Hencky's energy of such an $F$ at constant volume, $\mu\sum\log^2\lambda_i$, is exactly
# $\mu(\frac38\epsilon^2+\frac12q^2)$ with $\cosh q=\cosh\frac{3\epsilon}2+\frac{\gamma^2}2e^{3\epsilon/2}$.
# The package keeps $\frac E2(\epsilon+\frac14\gamma^2)^2+\frac\mu2\gamma^2$, $E=3\mu$, with an error
# of the fourth order: $\gamma^2/4$ is what lengthens a bar that is twisted (Poynting).

# %%
s, k = sp.symbols("s k", real=True)
F = gradient(s, k, 0)
in_plane = (F.T * F)[:2, :2]
prove_equal(sp.simplify(in_plane.det()), sp.exp(s))
half = sp.simplify(in_plane.trace() / (2 * sp.sqrt(in_plane.det())))
known_half = sp.cosh(3 * s / 2) + k**2 / 2 * sp.exp(3 * s / 2)
assert sp.simplify(sp.expand((half - known_half).rewrite(sp.exp))) == 0
spread = sp.Symbol("q")  # Principal stretches: log of (s/2 +- q)/2 in the plane, -s/2 across it
principal = ((s / 2 + spread) / 2, (s / 2 - spread) / 2, -s / 2)
prove_equal(sum(one**2 for one in principal), sp.Rational(3, 8) * s**2 + spread**2 / 2)
small = sp.Symbol("small", positive=True)
cosh = sp.series(known_half.subs({s: small * s, k: small * k}), small, 0, 6).removeO()
excess = sp.expand(cosh - 1)  # cosh q - 1 = q^2/2 + q^4/24 + ...
square = 2 * excess - excess**2 / 3
exact = sp.expand(sp.Rational(3, 8) * small**2 * s**2 + square / 2)
kept = spring.stored.subs({eps_e: small * s, sl.gamma_e[0]: small * k, sl.gamma_e[1]: 0})
kept = kept.subs({one: sp.Rational(1, 2) for one in kept.free_symbols if one.name == "nu"}).subs(E, 3)
for order in (2, 3):
    assert vanishes(sp.expand(exact).coeff(small, order) - sp.expand(kept).coeff(small, order)), order

# %% [markdown]
# Conjugate to the strains of a point are $\sigma$ and $t_i$, and the power of them is what is stored and what is lost,
# $\sigma\dot\epsilon+t_i\dot\gamma_i=\dot W+\varphi\,\sigma_{eq}$, identically:
# with the package's stress, drive and flow.

# %%
phi = sp.Symbol("phi")
flow = reissner.fibre_flow(phi, shears=sl.SHEARS)
total_eps, total_g = sp.Function("eps")(t), [sp.Function(f"gamma{n}")(t) for n in (2, 3)]
plastic_eps, plastic_g = sp.Function("eps_p")(t), [sp.Function(f"gamma_p{n}")(t) for n in (2, 3)]
elastic_eps = total_eps - plastic_eps
carried = sp.exp(-sp.Rational(3, 2) * elastic_eps)
elastic_g = [one - other * carried for one, other in zip(total_g, plastic_g, strict=True)]
now = {eps_e: elastic_eps, **dict(zip(sl.gamma_e, elastic_g, strict=True))}
s_now = spring.stress[0].subs(now)
t_now = [one.subs(now).subs(sigma, s_now) for one in spring.stress[1:]]
d_now = [one.subs(dict(zip(sl.tau, t_now, strict=True))).subs(now) for one in spring.driving]
state = {sigma: s_now, **dict(zip(sl.tau_d, d_now, strict=True)), **dict(zip(sl.gamma_p, plastic_g, strict=True))}
conjugate = spring.conjugate.subs(state)
rates = {
    sp.diff(plastic_eps, t): flow.axial_rate.subs(state),
    **{sp.diff(one, t): rate.subs(state) for one, rate in zip(plastic_g, flow.shear_rate, strict=True)},
}
stored = sp.diff(spring.stored.subs(now), t).subs(rates)
worked = conjugate * sp.diff(total_eps, t) + sum(
    one * sp.diff(g_now, t) for one, g_now in zip(t_now, total_g, strict=True)
)
equivalent = phi * flow.equivalent.subs(state) ** 2 / sigma_eq
names = {one: sp.Symbol(f"n{n}") for n, one in enumerate([total_eps, *total_g, *plastic_g])}
names[plastic_eps] = names[total_eps] - e
speeds = {sp.diff(one, t): sp.Symbol(f"v{n}") for n, one in enumerate([total_eps, *total_g])}
difference = (
    (worked - stored - equivalent).subs(speeds).subs(names).subs(sp.exp(-sp.Rational(3, 2) * e), sp.Symbol("c_e"))
)
assert sp.expand(difference.subs(nu, sp.Symbol("n") - 1)) == 0

# %% [markdown]
# ## Forces and moments
#
# The resultants are the derivatives of that power by the six strains, with the means over the section held:
# $n_2=c\langle t_2\rangle/\Lambda$, $m_1=\Lambda^{-3/2}\langle t_iW_i\rangle$,
# $m_2=\Lambda^{-3/2}\langle\sigma Z\rangle$, $m_3=-\Lambda^{-3/2}\langle\sigma Y\rangle$, and
# $n_1=\langle\sigma\rangle/\Lambda-(n_2\Gamma_2+n_3\Gamma_3)/\Lambda-\frac32\,m\cdot\kappa/\Lambda$.

# %%
root = sp.Symbol("c", positive=True)
power = sl.power(root**2)
L, G2, G3, *kappas = sl.STRAINS
mean, mean_Y, mean_Z, mean_2, mean_3, mean_W = sl.MEANS
n1, n2, n3, *m = (sp.diff(power, one) for one in sl.STRAINS)
lever = h0 / 2 * L ** -sp.Rational(3, 2)
prove_equal(n2, root * mean_2 / L)
prove_equal(n3, root * mean_3 / L)
for found, expected in zip(m, (lever * mean_W, lever * mean_Z, -lever * mean_Y), strict=True):
    prove_equal(found, expected)
bent = sum(one * k_now for one, k_now in zip(m, kappas, strict=True))
prove_equal(n1, mean / L - (n2 * G2 + n3 * G3) / L - sp.Rational(3, 2) * bent / L)

# %% [markdown]
# A round elastic bar has the bending stiffness $EAh_0^2/16$ about either axis and the torsional one $\mu Ah_0^2/8$.

# %%
r, angle = sp.symbols("r angle", positive=True)
place = {sl.Y: r * sp.cos(angle), sl.Z: r * sp.sin(angle)}
place |= {sl.W_2: -place[sl.Z], sl.W_3: place[sl.Y]}
axial, *sheared = sl.point_strain(sp.Rational(9, 10), natural=False)


def over_section(expression):
    """Mean over a disc of radius one."""
    return sp.integrate(sp.integrate(sp.expand(expression.subs(place)) * r, (r, 0, 1)), (angle, 0, 2 * sp.pi)) / sp.pi


at_rest = {L: 1, G2: 0, G3: 0}
prove_equal(over_section(E * axial.subs(at_rest).diff(kappas[2]) ** 2), E * h0**2 / 16)
prove_equal(over_section(E * axial.subs(at_rest).diff(kappas[1]) ** 2), E * h0**2 / 16)
prove_equal(over_section(mu * sum(one.subs(at_rest).diff(kappas[0]) ** 2 for one in sheared)), mu * h0**2 / 8)
