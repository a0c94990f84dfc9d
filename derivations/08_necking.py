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
# # 8. Necking
#
# A filament that yields and stretches thins where it flows, so the stress rises there, so it flows faster there. The
# paper sets the matter aside ("we avoid any discussion of flow instabilities such as necking"); a program cannot.
# With a stress that depends on the local stretch alone there is no length in the problem, and on a computer all strain
# ends in one cell.
#
# Nature has a length: the thickness. The surface of a neck slopes; near the surface the stress must follow the slope;
# and equilibrium across the filament then puts the core of the neck under lateral tension. A material whose flow
# depends on $\sigma_{11} - \sigma_{22}$ carries more axial stress there. We compute how much, by three independent
# ways.
#
# Throughout: $y, z$ across the filament; material lines stay at the same relative distance from the centreline, which
# is the uniform contraction (2.9); slopes are small; a prime is $d/dx$ with $x$ the *current* axial position.
#
# Effects derived here: `necking-gradient` (`necking.NECKS`).

# %%
import sympy as sp
from proving import prove_equal, vanishes

from softcat_sym.physics import constitutive_laws, necking, sections
from softcat_sym.physics.symbols import A0, T, X, eta, h0, s, sigma, sigma_Y, t

# %% [markdown]
# ## First way: equilibrium
#
# Two exact statements. Multiply a component of $\partial_j\sigma_{ij} = 0$ by something and integrate over a section
# whose lateral surface is free of traction; the divergence theorem leaves only what passes through the section:
#
# * axial equilibrium times $y^2/2$: $\int y\,\sigma_{12}\,dA = (\int \frac12 y^2\,\sigma_{11}\,dA)'$,
# * lateral equilibrium times $y$: $\int \sigma_{22}\,dA = (\int y\,\sigma_{12}\,dA)'$,
#
# and the same with $z$, $\sigma_{13}$, $\sigma_{33}$. No material has been mentioned. For a layer we need not even
# trust the divergence theorem: *every* stress in equilibrium, symmetric, with free surfaces $y = \pm a(x)$ and force
# $Q$ derives from the Airy function below with some even $\Psi$.

# %%
x, y = sp.symbols("x y", real=True)
a = sp.Function("a", positive=True)(x)
psi_0, psi_2 = (sp.Function(name)(x) for name in ("psi_0", "psi_2"))
force = sp.Symbol("force")
airy = force * (y**2 / a + a) / 4 + (a**2 - y**2) ** 2 * (psi_0 + psi_2 * y**2)
s11, s12, s22 = sp.diff(airy, y, 2), -sp.diff(airy, x, y), sp.diff(airy, x, 2)


def through(integrand):
    """Integral over the section of a layer, for an even polynomial in y."""
    return 2 * sp.integrate(sp.expand(integrand), (y, 0, a))


slope = sp.diff(a, x)
assert vanishes((s12 - s11 * slope).subs(y, a).doit()) and vanishes((s22 - s12 * slope).subs(y, a).doit())
prove_equal(through(s11), force)
prove_equal(through(y * s12), sp.diff(through(y**2 * s11), x) / 2)
prove_equal(through(s22), sp.diff(through(y * s12), x))

# %% [markdown]
# To leading order the axial stress is uniform over the section, $\sigma_{11} = T/A$, so that
# $\int y^2\sigma_{11}dA = T\langle y^2\rangle$. If a load along the filament changes $T$, $T' = -f$, axial equilibrium
# times $y^2/2$ gains $\langle y^2\rangle f/2$, and in either case
#
# $$\int y\,\sigma_{12}\,dA = \tfrac12 T\langle y^2\rangle',\qquad
# \int\sigma_{22}\,dA = \tfrac12\big(T\langle y^2\rangle'\big)'.$$
#
# The axial force is then, identically, what the material resists with,
# $T = \int[\sigma_{11} - \frac12(\sigma_{22}+\sigma_{33})]dA$, plus half of the lateral forces:
#
# $$Q = T + \tfrac14\big(T\,\langle y^2+z^2\rangle'\big)',\qquad
# \text{sheet } (\sigma_{11}-\sigma_{22}\text{ resists}):\quad Q = T + \tfrac12\big(T\,\langle y^2\rangle'\big)'.$$
#
# In material coordinates $' = s^{-1}\partial_X$, and $\langle y^2\rangle$ shrinks with $s$.

# %%
stretch, tension = (sp.Function(name, real=True)(X, t) for name in ("s_X", "T"))
gyration = sp.Symbol("gyration", positive=True)  # <y^2 + z^2> of the undeformed section
lateral = sp.Symbol("lateral", positive=True)


def along(field):
    return sp.diff(field, X) / stretch


both_ways = along(tension * along(gyration / stretch)) / 4
one_way = along(tension * along(gyration / stretch**2)) / 2

second, first = sp.diff(stretch, X, 2), sp.diff(stretch, X)
b_both = -both_ways.expand().coeff(second)
b_sheet = -one_way.expand().coeff(second)
b_both, b_sheet

# %% [markdown]
# In both cases the coefficient $b$ of $-s_{XX}$ makes the whole $Q = T - (b\,s_X)_X - b\,s_X^2/s$.

# %%
for gain, b in ((both_ways, b_both), (one_way, b_sheet)):
    prove_equal(gain, -sp.diff(b * first, X) - b * first**2 / stretch)

# %% [markdown]
# The radii of gyration: a rectangle $h_0\times D_0$, whose limit of small width is plane stress; a circle of *diameter*
# $h_0$; a sheet.

# %%
z, r, angle = sp.symbols("z r angle", real=True)
width = necking.aspect * h0
gyration_rectangle = (
    sp.integrate(y**2 + z**2, (y, -h0 / 2, h0 / 2), (z, -width / 2, width / 2)) / (h0 * width)
).simplify()
gyration_circle = sp.integrate(r**3, (r, 0, h0 / 2), (angle, 0, 2 * sp.pi)) / (sp.pi * h0**2 / 4)
derived_stiffness = {
    "rectangle": b_both.subs(gyration, gyration_rectangle),
    "circle": b_both.subs(gyration, gyration_circle),
    "sheet": b_sheet.subs(gyration, sp.integrate(y**2, (y, -h0 / 2, h0 / 2)) / h0),
}
pull = sp.Symbol("pull", positive=True)
for name, derived in derived_stiffness.items():
    held = necking.NECKS[name].stiffness()
    prove_equal(derived.subs({tension: pull, stretch: s}), held.subs(T, pull))
    assert held.subs(T, -pull) == 0
derived_stiffness

# %% [markdown]
# ## Which quadratic terms are kept
#
# A slope has two further effects of order $s_X^2$. One we have: $-b\,s_X^2/s$. The other sits in $T$: the sloping
# fibres carry the shear stress $\sigma_{12} = \sigma\,(h'/h)\,y$ (it satisfies equilibrium and the free surface,
# below), and a rigid-plastic material that shears has less left for tension:
# $\sigma_Y^2 = \Sigma^2 + 3(\sigma_{12}^2+\sigma_{13}^2)$ with
# $\Sigma = \sigma_{11}-\frac12(\sigma_{22}+\sigma_{33})$; in a sheet $\sigma_Y^2 = \frac34\Sigma^2 + 3\sigma_{12}^2$.

# %%
height, depth = (sp.Function(name, positive=True)(x) for name in ("height", "depth"))
axial = force / (height * depth)
shear_y, shear_z = axial * sp.diff(height, x) / height * y, axial * sp.diff(depth, x) / depth * z
assert vanishes(sp.diff(axial, x) + sp.diff(shear_y, y) + sp.diff(shear_z, z))
prove_equal(shear_y.subs(y, height / 2), axial * sp.diff(height / 2, x))
prove_equal(shear_z.subs(z, depth / 2), axial * sp.diff(depth / 2, x))

small = sp.Symbol("small", positive=True)
first_s = sp.Symbol("first_s", real=True)  # s_X
flow_stress = sp.Symbol("flow_stress", positive=True)


def loss(contraction, squares, shear_weight):
    """Tension that shear takes away, to leading order, with h = h0 s^-n: h'/h = -n s_X/s^2."""
    power = sp.simplify(-s * sp.diff(contraction.thickness, s) / contraction.thickness)
    shear_squared = (flow_stress * power * first_s / s**2) ** 2 * squares
    left = sp.sqrt(flow_stress**2 - small * shear_weight * shear_squared)
    return A0 / s * sp.diff(left, small).subs(small, 0)


square_of_distance = {"both": gyration / s, "sheet": gyration / s**2}
lost = {
    "both": loss(sections.UNIFORM, square_of_distance["both"], 3),
    "sheet": loss(sections.WIDE, square_of_distance["sheet"], 4),
}
flowing = {tension: flow_stress * A0 / s, stretch: s}
for name in necking.NECKS:
    kind, b = ("sheet", b_sheet) if name == "sheet" else ("both", b_both)
    b = b.subs(flowing)
    factor = sp.simplify(-lost[kind] / (b * first_s**2 / s))
    assert factor == (2 if name == "sheet" else sp.Rational(3, 2))

# %% [markdown]
# So a rigid-plastic filament has $Q = T - (b\,s_X)_X - \frac52\,b\,s_X^2/s$ (sheet $-3\,b\,s_X^2/s$). The package
# keeps $-(b\,s_X)_X = -b\,s_{XX} - b_s s_X^2 - b_T T_Xs_X$: all of the linear term, which decides the growth and the
# width of a neck and is exact whatever the isotropic material, and of the quadratic terms $-b_s s_X^2 = 4\,b\,s_X^2/s$
# (sheet 5) and the change of $T$. The others depend on the material. They vanish at the throat, where $s_X = 0$, and
# are small while the stretch changes little along one neck, $s_X^2/s \ll |s_{XX}|$. In return the term is the
# conjugate of a definite power.
#
# ## Second way: energy (Audoly & Hutchinson 2016)
#
# In an isotropic elastic bar put $x = \int s\,dX + u(X,Y)$, $y = Y\mu(s)$, $\mu = s^{-1/2}$. Let $\beta = Y\mu'(s)s_X$
# be the slope of a fibre and $\alpha = u_Y$; then $C = F^TF$ has $C_{12} = s\alpha + \mu\beta$. Any $C_{12}\ne0$ costs
# energy at second order, with a positive coefficient under tension, and $\alpha$ is free: $C_{12} = 0$, material lines
# and sections stay orthogonal. What is left is the stretch of the sloping line itself, $\sqrt{s^2+\beta^2}$. The
# lateral stretches stay where the energy is stationary.

# %%
bend, tilt = sp.symbols("beta alpha", real=True)
mu = sp.Symbol("mu", positive=True)
deformation = sp.Matrix([[s, tilt], [bend, mu]])
cauchy_green = deformation.T * deformation
free_tilt = sp.solve(cauchy_green[0, 1], tilt)[0]
line = sp.sqrt(cauchy_green[0, 0])
w = sp.Function("w")  # energy per volume in simple tension
energy = sp.series(w(s) + sp.diff(w(s), s) * (line - s), bend, 0, 3).removeO() - w(s)
prove_equal(free_tilt, -mu * bend / s)
prove_equal(energy, bend**2 / (2 * s) * sp.diff(w(s), s))

# %%
contraction_rate = sp.diff(s ** sp.Rational(-1, 2), s)
nominal = sp.Symbol("nominal", positive=True)  # w'(s), so that T = A0 w'(s)
density = A0 * nominal / (2 * s) * contraction_rate**2 * gyration * first_s**2
prove_equal(density, b_both.subs({tension: A0 * nominal, stretch: s}) * first_s**2 / 2)
sheet_rate = sp.diff(1 / s, s)
density = A0 * nominal / (2 * s) * sheet_rate**2 * gyration * first_s**2
prove_equal(density, b_sheet.subs({tension: A0 * nominal, stretch: s}) * first_s**2 / 2)

# %% [markdown]
# The same $b$, now as the coefficient of $\frac12 s_X^2$ in the energy. The variation of
# $\int(w + \frac12 b\,s_X^2)dX$ is $Q = w' + \frac12 b_s s_X^2 - (b\,s_X)_X$: the linear term is the one of the first
# way; the quadratic one is that of this material, in which $b_s$ contains $w''$. It is a matter of material, as said.

# %%
b_of = sp.Function("b", positive=True)
functional = w(stretch) + b_of(stretch) * first**2 / 2
variation = sp.diff(functional, stretch) - sp.diff(sp.diff(functional, first), X)
prove_equal(variation.doit().expand().coeff(second), -b_of(stretch))

# %% [markdown]
# ## Third way: Bridgman's necks
#
# Bridgman's mean stress at the throat of a neck of radius $a$ and profile curvature $1/R$: $(1 + 2R/a)\ln(1 + a/2R)$
# (round bar), $\sqrt{1+2R/a}\,\ln(1 + a/R + \sqrt{2a/R}\sqrt{1 + a/2R}) - 1$ (plane strain; $a$ half the thickness),
# over the flow stress. Ours is $1 - b\,s_{XX}/T$, with $1/R = a''$.

# %%
bluntness = sp.Symbol("bluntness", positive=True)  # a/R
root = sp.Symbol("root", positive=True)
round_bar = (1 + 2 / bluntness) * sp.log(1 + bluntness / 2)
in_root = sp.sqrt(1 + 2 / root**2) * sp.log(1 + root**2 + sp.sqrt(2) * root * sp.sqrt(1 + root**2 / 2)) - 1
round_excess = sp.series(round_bar, bluntness, 0, 2).removeO() - 1
sheet_excess = sp.series(in_root, root, 0, 3).removeO().subs(root, sp.sqrt(bluntness)) - 1
round_excess, sheet_excess

# %%
curvature_of_s = sp.Symbol("s_XX", real=True)
for name, excess, contraction in (("circle", round_excess, sections.UNIFORM), ("sheet", sheet_excess, sections.WIDE)):
    radius = contraction.thickness / 2
    profile = sp.diff(radius, s) * curvature_of_s / s**2  # a'' at the throat, s_X = 0
    bridgman = excess.subs(bluntness, radius * profile)
    stiffness = derived_stiffness[name].subs({tension: pull, stretch: s})
    prove_equal(bridgman, -stiffness * curvature_of_s / pull)

# %% [markdown]
# ## Growth of a neck
#
# Let a uniform filament flow under a force. Write $s(1 + q)$, $q\propto\cos KX$ small. The stress answers the
# extension rate alone, $s_t/s = \varphi(\sigma)$, and for $K\ne0$ the force does not change along the filament.

# %%
q, q_t, stress_change, K, slope_of_rule = sp.symbols("q q_t stress_change K slope_of_rule", real=True)
b_here = sp.Symbol("b_here", positive=True)
# Q = A0 sigma/s - b s_XX, linear in q: sigma -> sigma + stress_change, s -> s (1 + q), s_XX = -K^2 s q.
force_change = A0 / s * (stress_change - sigma * q) + b_here * K**2 * s * q
answer = sp.solve(force_change, stress_change)[0]
growth = sp.expand(slope_of_rule * answer / q)  # q_t = phi'(sigma) stress_change
growth

# %% [markdown]
# Without the term every wavelength grows at $\sigma\varphi'(\sigma)$, $\sigma/\eta$ for Maxwell and Bingham: there is
# no scale. With it the rate is $\sigma\varphi'(\sigma)\,[1-\beta(hk)^2]$, $k = K/s$ the current wavenumber: long necks
# grow as before, and those shorter than $2\pi\sqrt\beta\,h$ not at all.

# %%
prove_equal(growth.subs(b_here, 0), sigma * slope_of_rule)
beyond = sp.Symbol("beyond", positive=True)
for rule in (constitutive_laws.bingham_rate(), constitutive_laws.maxwell_rate()):
    stress = sigma_Y + beyond
    slope_here = sp.diff(rule, sigma).subs(sigma, stress)
    prove_equal(slope_here, 1 / eta)
    assert sp.simplify(stress * slope_here * t - stress / eta * t) == 0
    for name, derived in derived_stiffness.items():
        beta, contraction = necking.NECKS[name].beta, sections.WIDE if name == "sheet" else sections.UNIFORM
        stiffness = derived.subs({tension: A0 * stress / s, stretch: s})
        rate = growth.subs({b_here: stiffness, sigma: stress, slope_of_rule: slope_here})
        prove_equal(rate, stress * slope_here * (1 - beta * (contraction.thickness * K / s) ** 2))
        critical = [k for k in sp.solve(rate, K) if k.subs({necking.aspect: 1, h0: 1, s: 1}) > 0]
        prove_equal(2 * sp.pi * s / critical[0], 2 * sp.pi * sp.sqrt(beta) * contraction.thickness)
{name: sp.N(2 * sp.pi * sp.sqrt(neck.beta), 3) for name, neck in necking.NECKS.items()}

# %% [markdown]
# Shortest growing necks in thicknesses: 0.91 plane stress, 1.28 square, 1.11 circle, 1.81 sheet. A neck grows by
# $\int\sigma\varphi'dt$ e-folds while the section flows: the effect matters once that exceeds
# $\log(\text{accuracy}/\text{noise})$.
#
# ### The exact answer for a viscous layer and a viscous thread
#
# In a Newtonian liquid the small neck can be solved for without any slender approximation: Stokes flow inside, with
# the traction $\sigma_{12} = \sigma\zeta'$ that the axial stress leaves on a surface displaced by $\zeta\cos kx$. For
# a layer $|y|<a$, even in thickness, with shear viscosity $m$ (so that $\sigma = 4m\,\dot\epsilon$):

# %%
k, m, half, bump, c_1, c_2 = sp.symbols("k m half bump c_1 c_2", positive=True)
across = c_1 * sp.sinh(k * y) + c_2 * k * y * sp.cosh(k * y)
v_y = across * sp.cos(k * x)
v_x = -sp.diff(across, y) / k * sp.sin(k * x)
pressure = 2 * m * c_2 * k * sp.cosh(k * y) * sp.cos(k * x)


def laplacian(field):
    return sp.diff(field, x, 2) + sp.diff(field, y, 2)


assert vanishes(sp.diff(v_x, x) + sp.diff(v_y, y))
assert vanishes(m * laplacian(v_x) - sp.diff(pressure, x)) and vanishes(m * laplacian(v_y) - sp.diff(pressure, y))
shear = (m * (sp.diff(v_x, y) + sp.diff(v_y, x)) / sp.sin(k * x)).simplify().subs(y, half)
normal = ((2 * m * sp.diff(v_y, y) - pressure) / sp.cos(k * x)).simplify().subs(y, half)
free = sp.solve([shear + sigma * bump * k, normal], [c_1, c_2], dict=True)[0]
exact = sp.simplify((across.subs(y, half).subs(free) / bump).rewrite(sp.exp))
exact_layer = sp.series(exact.subs(k, small), small, 0, 3).removeO()
prove_equal(exact_layer, sigma / (4 * m) * (1 - necking.SHEET.beta * (2 * half * small) ** 2))
closed = sigma / (2 * m) / (1 + sp.sinh(2 * k * half) / (2 * k * half))
prove_equal(exact, closed.rewrite(sp.exp))

# %% [markdown]
# The first two terms are the ones above, $\beta = 1/12$: the coefficient is exact. And the closed form shows what the
# gradient term does to short necks: their growth does not vanish at $k h = \beta^{-1/2}$ but dies out exponentially.
# The term errs on the stable side, for necks shorter than a thickness, which a filament theory cannot know about
# anyway.
#
# A round thread: the same with Bessel functions, here by their power series; $\sigma = 3m\,\dot\epsilon$.

# %%
order = 6


def bessel(n, argument):
    terms = range(order)
    return sum((argument / 2) ** (2 * j + n) / (sp.factorial(j) * sp.factorial(j + n)) for j in terms)


radial = c_1 * bessel(1, k * r) + c_2 * k * r * bessel(0, k * r)
axial_v = -(c_1 * bessel(0, k * r) + c_2 * (2 * bessel(0, k * r) + k * r * bessel(1, k * r)))
pressure_r = 2 * m * c_2 * k * bessel(0, k * r)


def beyond_series(expression):
    """Whether a power series in k vanishes up to the terms cut off."""
    expanded = sp.expand(expression)
    return all(expanded.coeff(k, n) == 0 for n in range(2 * order - 2))


assert beyond_series(sp.diff(r * radial, r) / r + k * axial_v)
assert beyond_series(m * (sp.diff(r * sp.diff(axial_v, r), r) / r - k**2 * axial_v) + k * pressure_r)
assert beyond_series(
    m * (sp.diff(r * sp.diff(radial, r), r) / r - radial / r**2 - k**2 * radial) - sp.diff(pressure_r, r)
)
shear = m * (sp.diff(axial_v, r) - k * radial).subs(r, half)
normal = (2 * m * sp.diff(radial, r) - pressure_r).subs(r, half)
free = sp.solve([shear + sigma * bump * k, normal], [c_1, c_2], dict=True)[0]
thread = sp.cancel(radial.subs(r, half).subs(free) / bump)
exact_thread = sp.series(thread, k, 0, 3).removeO()
prove_equal(exact_thread, sigma / (3 * m) * (1 - necking.CIRCLE.beta * (2 * half * k) ** 2))

# %% [markdown]
# ## Power, for the energy audit
#
# The term's power is $\int -(b\,s_X)_X s_t\,dX = \int b\,s_Xs_{Xt}\,dX - [b\,s_Xs_t]$, and the bracket vanishes with
# $s_X = 0$ at the ends. It is the change of $\frac12 b\,s_X^2$ minus $\frac12 b_t s_X^2$: not dissipation only, hence
# its own column.

# %%
b_field = sp.Function("b_field")(X, t)
work = -sp.diff(b_field * first, X) * sp.diff(stretch, t)
gained = b_field * first * sp.diff(stretch, X, t)
prove_equal(work - gained, -sp.diff(b_field * first * sp.diff(stretch, t), X))
prove_equal(gained, sp.diff(b_field * first**2 / 2, t) - sp.diff(b_field, t) * first**2 / 2)
for name, derived in derived_stiffness.items():
    here = {tension: pull, stretch: s}
    neck = necking.NECKS[name]
    prove_equal(derived.subs(here) * necking.s_slope, neck.double_force().subs(T, pull))
