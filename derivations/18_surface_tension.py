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
# # 18. Surface tension
#
# Surface tension $\gamma$ pulls on a filament with whatever force changes its area. All follows from that area: the
# axial force, what a sloping outline adds to it, why no moment appears, which threads bead and how fast.
#
# Effects derived here: `surface-tension` (`loads.SURFACES`).

# %%
import sympy as sp
from proving import prove_equal

from softcat_sym.physics import loads, necking
from softcat_sym.physics.symbols import X, h0, s, x_X, y_X

gamma, R, R0, kappa, phi, rho, eta, k = sp.symbols("gamma R R0 kappa phi rho eta k", positive=True)

# %% [markdown]
# ## The area
#
# Of a tube of radius $R$ around a bent centreline, $r_c + R(\cos\varphi\,n + \sin\varphi\,b)$, the area per length is
# $2\pi R$ whatever the curvature (Pappus), and likewise for every outline whose centroid is on the centreline: no
# moment.

# %%
around = sp.Matrix([0, -R * sp.sin(phi), R * sp.cos(phi)])  # along t, n, b
along = sp.Matrix([1 - kappa * R * sp.cos(phi), 0, 0])  # t' = kappa n, n' = - kappa t
prove_equal(along.cross(around).norm() ** 2, (R * (1 - kappa * R * sp.cos(phi))) ** 2)
prove_equal(sp.integrate(R * (1 - kappa * R * sp.cos(phi)), (phi, 0, 2 * sp.pi)), 2 * sp.pi * R)

# %% [markdown]
# A section that tilts against the centreline, $r_X = \Lambda d_1 + \Gamma d_2$, makes the outline oblique. Its area is
# that of the *centreline's* stretch $s = \sqrt{\Lambda^2+\Gamma^2}$ up to $(3/64)(\Gamma/\Lambda)^4$: in either
# kinematics the energy is one of $s$, and its force is along the tangent $r_X/s$.

# %%
q = sp.Symbol("q", positive=True)
oblique = sp.Matrix([1, q, 0]).cross(sp.Matrix([0, -sp.sin(phi), sp.cos(phi)]))
prove_equal(oblique.norm() ** 2, 1 + q**2 * sp.cos(phi) ** 2)
element = sp.series(sp.sqrt(1 + q**2 * sp.cos(phi) ** 2), q, 0, 6).removeO()
mean = sp.integrate(sp.expand(element), (phi, 0, 2 * sp.pi)) / (2 * sp.pi)
ratio = sp.series(mean / (1 + q**2) ** sp.Rational(1, 4), q, 0, 6).removeO()
prove_equal(ratio, 1 + sp.Rational(3, 64) * q**4)

# %% [markdown]
# A slope along the filament lengthens the outline to $\sqrt{s^2+R_X^2}$. The position of the surface of a round thread
# is $(z, R\cos\varphi, R\sin\varphi)$ with $z_X = s$; two faces of width $D$ are $h$ apart, and of a rectangle two more
# of width $h$ are $D$ apart. Of a sheet the width is held, and the edges $2hs = 2h_0$ do not change.

# %%
R_X = sp.Symbol("R_X", real=True)
lengthwise = sp.Matrix([s, R_X * sp.cos(phi), R_X * sp.sin(phi)])
prove_equal(lengthwise.cross(around).norm() ** 2, R**2 * (s**2 + R_X**2))

s_X, h0_X = necking.s_slope, loads.h0_slope
width = necking.aspect * h0


def changes(of):
    """Change along the filament of something that depends on the stretch and on the undeformed thickness."""
    return sp.diff(of, s) * s_X + sp.diff(of, h0) * h0_X


def faces(wide, apart, slope):
    """Two faces that lean away from the centreline by half of what their distance changes."""
    return 2 * wide * sp.sqrt(s**2 + (slope / 2) ** 2)


h, shrunk, D0 = h0 / sp.sqrt(s), 1 / sp.sqrt(s), sp.Symbol("D_0", positive=True)
held = {
    "circle": (sp.pi * h * sp.sqrt(s**2 + (changes(h) / 2) ** 2), sp.pi * h0**2 / 4),
    # Along a profile the width stays.
    "rectangle": (
        faces(D0 * shrunk, h, changes(h)) + faces(h, D0 * shrunk, changes(D0 * shrunk)),
        h0 * D0,
    ),
    "sheet": (faces(D0, h0 / s, changes(h0 / s)), h0 * D0),
}
small = sp.Symbol("small", positive=True)


def in_slopes(expression, power):
    """The terms of one power of the slopes."""
    scaled = expression.subs({s_X: small * s_X, h0_X: small * h0_X})
    return sp.diff(scaled, small, power).subs(small, 0) / sp.factorial(power)


densities = {}
for name, (area, section) in held.items():
    kept = loads.SURFACES[name]
    density = densities[name] = (gamma * area / section).subs(D0, width)
    package = {loads.surface_tension: gamma}
    prove_equal(in_slopes(density, 0), kept.energy().subs(package))
    prove_equal(in_slopes(density, 1), 0)
    prove_equal(in_slopes(density, 2), kept.gradient_energy().subs(package))

# %% [markdown]
# The energies of a uniform filament and what they pull with, and the gradient part $g$ where the undeformed filament
# is uniform:
#
# | | $e$ | $Q_c$ at $s = 1$ | $g$ |
# |-|-|-|-|
# | circle | $2\pi\gamma R_0\sqrt s$ | $\pi\gamma R_0$ | $\frac\pi4\gamma R_0^3 s^{-9/2}s_X^2$ |
# | rectangle | $2\gamma(h_0+D_0)\sqrt s$ | $\gamma(h_0+D_0)$ | $\frac1{16}\gamma D_0h_0(D_0+h_0)s^{-9/2}s_X^2$ |
# | sheet | $2\gamma D_0s$ | $2\gamma D_0$ | $\frac14\gamma D_0h_0^2s^{-5}s_X^2$ |

# %%
circle_area = sp.pi * R0**2
pulls = {"circle": sp.pi * gamma * R0, "rectangle": gamma * (h0 + width), "sheet": 2 * gamma * width}
gradients = {
    "circle": sp.pi / 4 * gamma * R0**3 * s_X**2 / s ** sp.Rational(9, 2),
    "rectangle": gamma * width * h0 * (width + h0) * s_X**2 / s ** sp.Rational(9, 2) / 16,
    "sheet": gamma * width * h0**2 * s_X**2 / s**5 / 4,
}
for name, kept in loads.SURFACES.items():
    section = circle_area if name == "circle" else h0 * width
    here = {loads.surface_tension: gamma, h0_X: 0, **({h0: 2 * R0} if name == "circle" else {})}
    prove_equal(section * kept.force().subs(here).subs(s, 1), pulls[name])
    prove_equal(kept.pressure, kept.force().subs(s, 1))
    prove_equal(section * kept.gradient_energy().subs(here), gradients[name])
    stretched = kept.energy().subs(s, sp.sqrt(x_X**2 + y_X**2))
    tangential = kept.force().subs(s, sp.sqrt(x_X**2 + y_X**2)) / sp.sqrt(x_X**2 + y_X**2)
    for component in (x_X, y_X):
        prove_equal(sp.diff(stretched, component), tangential * component)

# %% [markdown]
# ## The force, and the full curvature
#
# The axial force is what is conjugate to $s$: $Q_c = e' + g_s - (g_{s_X})_X$. With the whole root it is that of the
# full curvature of a thread (Eggers & Dupont 1994), identically,
#
# $$\pi\gamma\Big[\frac{R}{\sqrt{1+R_z^2}} + \frac{R^2R_{zz}}{(1+R_z^2)^{3/2}}\Big],$$
#
# its pull $2\pi\gamma R/\sqrt{1+R_z^2}$ less $\pi R^2$ times the pressure under the two curvatures. The second order is
# what is left of it where slopes are small.

# %%
stretch = sp.Function("s_X", real=True)(X)
slope = sp.Symbol("slope")


def conjugate(energy):
    """Euler-Lagrange derivative of an energy of the stretch and of its change."""
    here = {s: stretch, s_X: sp.diff(stretch, X)}
    return sp.diff(energy, s).subs(here) - sp.diff(sp.diff(energy, s_X).subs(here), X)


round_thread = {h0: 2 * R0, h0_X: 0, loads.surface_tension: gamma}
whole = conjugate(circle_area * densities["circle"].subs(round_thread))
radius = R0 / sp.sqrt(stretch)
R_z = sp.diff(radius, X) / stretch
R_zz = sp.diff(R_z, X) / stretch
root = sp.sqrt(1 + R_z**2)
tilt, bend = sp.symbols("tilt bend", real=True)


def in_tilt(expression):
    """In the slope R_z of the thread, so that both roots are that of 1 + R_z^2."""
    first = -2 * tilt * s ** sp.Rational(5, 2) / R0
    return expression.doit().subs({sp.diff(stretch, X, 2): bend}).subs({sp.diff(stretch, X): first}).subs(stretch, s)


prove_equal(in_tilt(R_z), tilt)
classical = sp.pi * gamma * (radius / root + radius**2 * R_zz / root**3)
prove_equal(in_tilt(whole), in_tilt(classical))
curvatures = 1 / (radius * root) - R_zz / root**3
prove_equal(in_tilt(classical), in_tilt(2 * sp.pi * gamma * radius / root - sp.pi * radius**2 * gamma * curvatures))

kept = loads.CIRCLE.energy() + loads.CIRCLE.gradient_energy()
second_order = conjugate(circle_area * kept.subs(round_thread))
written = (
    sp.pi * gamma * R0 / sp.sqrt(stretch)
    - sp.Rational(9, 8) * sp.pi * gamma * R0**3 * sp.diff(stretch, X) ** 2 / stretch ** sp.Rational(11, 2)
    - sp.diff(sp.pi / 2 * gamma * R0**3 * sp.diff(stretch, X) / stretch ** sp.Rational(9, 2), X)
)
prove_equal(second_order, written)
order = sp.Symbol("order", positive=True)


def in_symbols(expression):
    return expression.doit().subs(sp.diff(stretch, X, 2), bend).subs(sp.diff(stretch, X), tilt).subs(stretch, s)


# Powers of R_0 over the length of the neck.
expanded = sp.series(in_symbols(whole).subs(R0, order), order, 0, 4).removeO()
prove_equal(expanded.subs(order, R0), in_symbols(second_order))
direct, across = (
    one.subs(round_thread).subs({s: stretch, s_X: sp.diff(stretch, X)}) for one in loads.CIRCLE.slope_forces()
)
pulled = loads.CIRCLE.force().subs(round_thread).subs(s, stretch) + direct - sp.diff(across, X)
prove_equal(circle_area * pulled, second_order)

# %% [markdown]
# ## On cells and joints
#
# $U_h = \sum_c\Delta X_c\,e(s_c) + \sum_n\Delta X_n\,g(s_n, D_n)$, $D_n = (s_{c+1}-s_c)/\Delta X_n$ and $s_n$ the mean
# that a joint answers for. The force of a cell is $U_h$'s derivative; that of $g_s$ cannot be left out, or the energy
# leaks. Three cells of different lengths:

# %%
cells, lengths = sp.symbols("s_1:4", positive=True), sp.symbols("l_1:4", positive=True)
e, g = sp.Function("e"), sp.Function("g")


def joint(j):
    """Length, stretch and slope of the joint behind a cell."""
    span = (lengths[j] + lengths[j + 1]) / 2
    return (
        span,
        (lengths[j] * cells[j] + lengths[j + 1] * cells[j + 1]) / (2 * span),
        (cells[j + 1] - cells[j]) / span,
    )


p_0, p_1 = sp.symbols("p_0 p_1")
energy = sum(length * e(one) for length, one in zip(lengths, cells, strict=True))
energy += sum(joint(j)[0] * g(joint(j)[1], joint(j)[2]) for j in (0, 1))
by_stretch, by_slope = [], []
for j in (0, 1):
    at = {p_0: joint(j)[1], p_1: joint(j)[2]}
    by_stretch.append(sp.diff(g(p_0, p_1), p_0).subs(at))
    by_slope.append(sp.diff(g(p_0, p_1), p_1).subs(at))
of_the_cell = sp.diff(e(cells[1]), cells[1]) - (by_slope[1] - by_slope[0]) / lengths[1] + sum(by_stretch) / 2
example = {
    "e": (e, lambda u: u**3),
    "g": (g, lambda u, v: v**2 / u**2 + u * v**3),
}


def concrete(expression):
    for function, what in example.values():
        expression = expression.replace(function, what)
    return expression.doit()


prove_equal(concrete(sp.diff(energy, cells[1]) / lengths[1]), concrete(of_the_cell))

# %% [markdown]
# ## Which threads bead, and how fast (Plateau 1873, Rayleigh 1878)
#
# Small changes $s = 1 + \epsilon e^{\omega t + ikX}$ of a thread with inertia and extensional viscosity $\eta = 3\mu$:
# $\rho\,\epsilon_{tt} = (\eta\,\epsilon_t + Q_c/A_0)_{XX}$, so
#
# $$\omega^2 + \frac{\eta}{\rho}k^2\omega = \frac{\gamma k^2}{2\rho R_0}\big(1 - k^2R_0^2\big).$$

# %%
eps = sp.Symbol("eps")
wave = sp.exp(sp.I * k * X)
linear = sp.diff(second_order.subs(stretch, 1 + eps * wave).doit() / circle_area, eps).subs(eps, 0) / wave
prove_equal(linear, -gamma / (2 * R0) * (1 - (k * R0) ** 2))
omega = sp.Symbol("omega", positive=True)
dispersion = rho * omega**2 + k**2 * (eta * omega + linear)
prove_equal(dispersion / rho, omega**2 + eta / rho * k**2 * omega - gamma * k**2 / (2 * rho * R0) * (1 - (k * R0) ** 2))

# %% [markdown]
# Rayleigh's own, of an inviscid cylinder, is $\omega^2 = \frac{\gamma}{\rho R^3}\,kR\,\frac{I_1(kR)}{I_0(kR)}\,
# (1-k^2R^2)$. The slender one has the same cut-off $kR = 1$, exactly, and misses a factor $1 - (kR)^2/8$ in between.
# It grows fastest at $kR = 1/\sqrt2$ (Rayleigh: 0.697).

# %%
u = k * R0
bessel_1 = sum((u / 2) ** (2 * j + 1) / (sp.factorial(j) * sp.factorial(j + 1)) for j in range(4))
bessel_0 = sum((u / 2) ** (2 * j) / sp.factorial(j) ** 2 for j in range(4))
rayleigh = u * bessel_1 / bessel_0 * (1 - u**2) * gamma / (rho * R0**3)
inviscid = gamma * k**2 / (2 * rho * R0) * (1 - u**2)
prove_equal(sp.series(rayleigh / inviscid, k, 0, 4).removeO(), 1 - u**2 / 8)
fastest = [one for one in sp.solve(sp.diff(inviscid, k), k) if one.is_positive]
prove_equal(fastest[0], 1 / (sp.sqrt(2) * R0))

# %% [markdown]
# Without inertia $\omega = \frac{\gamma}{2\eta R_0}(1-k^2R_0^2)$, fastest for the longest waves. Without the gradient
# part every wavelength grows, the shortest fastest, $\omega\sim k$: no grid has an answer. With it a grid of equal
# cells has the same relation with $K = (2/\Delta X)\sin(k\Delta X/2)$ in the place of $k$. The cut-off is on the grid
# if $2/\Delta X > 1/R_0$, cells shorter than a diameter; the fastest mode of an inviscid thread if
# $\Delta X < 2\sqrt2 R_0$, with its rate to 2 % if $\Delta X < R_0$; where the cells are longer all waves of the grid
# grow, but no faster than the fastest mode, and the answer is one of waves that the grid can show.

# %%
length, site = sp.symbols("length site", positive=True)
on_grid = sp.exp(sp.I * k * length * site)
second_difference = sp.simplify((on_grid.subs(site, site + 1) - 2 * on_grid + on_grid.subs(site, site - 1)) / on_grid)
prove_equal(second_difference.rewrite(sp.cos).simplify(), -((2 * sp.sin(k * length / 2)) ** 2))
K = 2 * sp.sin(k * length / 2) / length
prove_equal(sp.Max(*[K.subs(k, sp.pi / length)]), 2 / length)

# %% [markdown]
# ## The stress of a fibre; what it does to laws
#
# The stress of a fibre is $\sigma_{xx}-\sigma_{rr}$ with $\sigma_{rr} = -\gamma/R$, so that the law stays as it is and
# only the axial force gains $Q_c$. An elastic filament, $Q = A_0(E\log s/s + \mathrm{Gam}\,s^{-1/2})$, pulls less the
# more it is stretched once $\mathrm{Gam} > 2E$, $\gamma > 6\mu R$ of a circle with $E = 3\mu$ (Mora et al. 2010): it
# gathers into beads. Stretched, $\gamma/(\mu R_0) = 6(1-\log s)/\sqrt s$.

# %%
E, pressure, mu = sp.symbols("E pressure mu", positive=True)
stiffness = sp.diff(E * sp.log(s) / s + pressure / sp.sqrt(s), s)
prove_equal(stiffness.subs(s, 1), E - pressure / 2)
threshold = sp.solve(stiffness.subs({pressure: gamma / R0, E: 3 * mu}), gamma)[0]
prove_equal(threshold, 6 * mu * R0 * (1 - sp.log(s)) / sp.sqrt(s))
prove_equal(-gamma / R + 2 * gamma / R, gamma / R)  # A sigma_xx + 2 pi gamma R = A sigma + pi gamma R

# %% [markdown]
# A viscous thread whose end is free, $Q = 0$, thickens at a constant rate, $R/R_0 = 1 + \mathrm{Gam}\,t/(2\eta)$ with
# $\mathrm{Gam} = \gamma/R_0$; fed from a reservoir, $Q = 2\pi\gamma R$, it thins at the same one. A thread that yields
# stops at $R = \gamma/\sigma_Y$, where $\sigma = -\gamma/R = -\sigma_Y$.

# %%
for way, force in ((1, 0), (-1, 2 * pressure / sp.sqrt(s))):
    rate = sp.solve(eta * X / s**2 + pressure / sp.sqrt(s) - force, X)[0]  # X in the place of s_t
    prove_equal(sp.diff(1 / sp.sqrt(s), s) * rate, way * pressure / (2 * eta))

# %% [markdown]
# A free end of an inviscid thread gathers a bead that runs into the thread at a constant speed: what it picks up,
# $\rho\pi R^2v^2$, is what pulls it, $\pi\gamma R$: $v = \sqrt{\gamma/(\rho R)}$ (Keller 1983), and of a sheet
# $\rho h v^2 = 2\gamma$ (Taylor 1959, Culick 1960).

# %%
v = sp.Symbol("v", positive=True)
prove_equal(sp.solve(rho * sp.pi * R**2 * v**2 - sp.pi * gamma * R, v)[0], sp.sqrt(gamma / (rho * R)))
prove_equal(
    sp.solve(rho * h0 * v**2 - h0 * loads.SHEET.pressure.subs(loads.surface_tension, gamma), v)[0],
    sp.sqrt(2 * gamma / (rho * h0)),
)
