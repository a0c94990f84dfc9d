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
# # 6. The three-dimensional law
#
# Section 3.1 of the paper tests its filament against finite elements of a solid,
# $F = F^e F^p$ (3.2) with the elastic strain $E^e = \log\sqrt{F^{eT}F^e}$ (3.3). For that test to mean anything, a bar
# of this solid under simple tension must do what a fibre of the filament does,
# $\sigma = E(\epsilon - \epsilon^p)$ (2.8) and $\epsilon^p_t = \varphi(\sigma)$ (2.25).
# We build the law from this requirement and from four others: isotropy, frame indifference, incompressible flow, and no
# negative dissipation. Two of the printed equations, (3.7) and (3.8), then turn out to be misprinted.

# %%
import sympy as sp
from proving import Erratum, prove_equal, record_errata, vanishes

from softcat_sym.physics import bulk, constitutive_laws
from softcat_sym.physics.symbols import E, eta, sigma, sigma_Y

nu = bulk.nu
tensile = sp.Symbol("tensile", positive=True)  # a stress in simple tension
phi = sp.Function("phi", positive=True)  # any flow rule, beyond its yield stress


def entries_vanish(matrix):
    return all(vanishes(entry) for entry in matrix)


cos_a, sin_a, cos_b, sin_b = sp.symbols("cos_a sin_a cos_b sin_b", real=True)
turn_3 = sp.Matrix([[cos_a, -sin_a, 0], [sin_a, cos_a, 0], [0, 0, 1]])
turn_1 = sp.Matrix([[1, 0, 0], [0, cos_b, -sin_b], [0, sin_b, cos_b]])
circles = ((cos_a, cos_a**2 + sin_a**2 - 1), (cos_b, cos_b**2 + sin_b**2 - 1))


def agree_turned(matrix, other):
    """Whether two matrices, polynomials in cosines and sines, are equal on the unit circles."""
    differences = [sp.numer(sp.together(entry)) for entry in matrix - other]
    for cosine, circle in circles:
        differences = [sp.rem(sp.expand(entry), circle, cosine) for entry in differences]
    return all(sp.expand(entry) == 0 for entry in differences)


# %% [markdown]
# ## Elasticity (3.6)
#
# The most general isotropic linear map from one symmetric tensor to another is
# $M = K\,\mathrm{tr}(E^e)1 + 2\mu E^{e\prime}$. Simple tension along 1 shall give $E^e_{11} = M_{11}/E$ and a lateral
# strain $-\nu M_{11}/E$. Two equations, two unknowns.

# %%
K, mu = sp.symbols("K mu", positive=True)


def isotropic(strain):
    spherical = strain.trace() / 3 * sp.eye(3)
    return 3 * K * spherical + 2 * mu * (strain - spherical)


simple_tension = sp.diag(tensile, 0, 0)
tensile_strain = sp.diag(1, -nu, -nu) * tensile / E
moduli = sp.solve(list(isotropic(tensile_strain) - simple_tension), [K, mu], dict=True)[0]
moduli

# %%
held_strain = bulk.elastic_strain
derived_stress = isotropic(held_strain).subs(moduli)
for derived, held in zip(derived_stress, bulk.mandel_stress(held_strain), strict=True):
    prove_equal(derived, held)
prove_equal(moduli[mu], bulk.shear_modulus())

# %% [markdown]
# So with $\nu = 0.45$ a stretch $\lambda$ narrows the bar by $\lambda^{-0.45}$: the filament, which takes
# $\lambda^{-1/2}$ throughout (2.9), is right for the plastic part and off by a tenth of the *elastic* strain.
#
# This stress has a potential. With elastic strains in fixed principal axes, $E^e_i = \log\lambda_i$ and the power of
# the Kirchhoff stress, $\sum_i \tau_i \dot\lambda_i/\lambda_i$, is exactly $\sum_i \tau_i\dot E^e_i$: Hencky strain is
# conjugate to it, no matter how large.

# %%
entries = [held_strain[i, j] for i in range(3) for j in range(i, 3)]
potential = bulk.elastic_energy(held_strain)
for i in range(3):
    for j in range(i, 3):
        weight = 1 if i == j else 2  # an off-diagonal strain occurs twice
        prove_equal(sp.diff(potential, held_strain[i, j]), weight * derived_stress[i, j])

lam, lam_rate = sp.symbols("lambda lambda_rate", positive=True)
time = sp.Symbol("time")
growing = sp.Function("growing", positive=True)(time)
prove_equal(sp.diff(sp.log(growing), time), sp.diff(growing, time) / growing)

# %% [markdown]
# ## The Mandel stress is symmetric (3.4)
#
# Take the polar decomposition $F^e = RU$. In an isotropic solid the Cauchy stress has the axes of $V = RUR^T$, so
# $R^T\sigma R$ commutes with $U$. Then the printed $J F^{e-1}\sigma F^e$ is the same as the usual
# $J F^{eT}\sigma F^{e-T}$, and both are symmetric. For a stress with other axes the two differ, so isotropy is needed.

# %%
u1, u2, u3 = sp.symbols("u1:4", positive=True)
p1, p2, p3, q12 = sp.symbols("p1:4 q12", real=True)
R = turn_3 * turn_1
U = sp.diag(u1, u2, u3)


def printed_mandel(stress):
    return (U.inv() * R.T) * stress * (R * U)


def usual_mandel(stress):
    return (R * U).T * stress * (R * U.inv())


coaxial = R * sp.diag(p1, p2, p3) * R.T
assert agree_turned(printed_mandel(coaxial), sp.diag(p1, p2, p3))
assert agree_turned(usual_mandel(coaxial), sp.diag(p1, p2, p3))

oblique = R * sp.Matrix([[p1, q12, 0], [q12, p2, 0], [0, 0, p3]]) * R.T
assert not agree_turned(printed_mandel(oblique), usual_mandel(oblique))

# %% [markdown]
# ## Isotropy and frame indifference
#
# *Frame.* An observer who turns with $Q$ sees $QF$, that is $QF^e$ and the same $F^p$: $F^{eT}F^e$ does not change, and
# with it neither $E^e$, $M$ nor $L^p$.
#
# *Material.* Turning the reference, $F \to FQ^T$, $F^p \to QF^pQ^T$, $F^e \to F^eQ^T$, turns $E^e$ into $QE^eQ^T$.
# The law is isotropic if $M$ and $L^p$ turn along, and (below) if the turned $F^p$ obeys the turned evolution.
# Rotations about two axes generate all of them.

# %%
general_fe = sp.Matrix(3, 3, sp.symbols("f:9", real=True))
held_equivalent, held_flow = bulk.equivalent_stress(bulk.mandel), bulk.plastic_flow(bulk.mandel, phi(sigma))
for Q in (turn_3, turn_1):
    turned = Q * general_fe
    assert agree_turned(turned.T * turned, general_fe.T * general_fe)
    assert agree_turned(bulk.mandel_stress(Q * held_strain * Q.T), Q * bulk.mandel_stress(held_strain) * Q.T)
    turned_stress = Q * bulk.mandel * Q.T
    assert agree_turned(sp.Matrix([bulk.equivalent_stress(turned_stress) ** 2]), sp.Matrix([held_equivalent**2]))
    assert agree_turned(bulk.plastic_flow(turned_stress, phi(sigma)), Q * held_flow * Q.T)

# %% [markdown]
# ## The flow rule (3.7)
#
# Isotropy, incompressible flow and a rate that depends on the stress only through $\tau$ (or $\sigma_{eq}$) leave
# $L^p = c\,M'$. Under simple tension $\sigma_{eq}$ shall be the tensile stress and $L^p_{11}$ shall be $\varphi$.

# %%
ratio, c = sp.symbols("ratio c", positive=True)
deviatoric = simple_tension - tensile / 3 * sp.eye(3)
square = sum(entry**2 for entry in deviatoric)
factor = sp.solve(ratio * square - tensile**2, ratio)[0]  # sig_eq^2 = ratio M':M'
strength = sp.solve(c * deviatoric[0, 0] - phi(tensile), c)[0]
factor, strength

# %%
M = bulk.mandel
stress_deviator = M - M.trace() / 3 * sp.eye(3)
derived_equivalent = sp.sqrt(factor * sum(entry**2 for entry in stress_deviator))
prove_equal(derived_equivalent**2, held_equivalent**2)  # both are positive roots
derived_flow = stress_deviator * strength.subs(tensile, bulk.sigma_eq)
for derived, held in zip(derived_flow, held_flow, strict=True):
    prove_equal(derived, held)
for rule in (constitutive_laws.bingham_rate(), constitutive_laws.maxwell_rate()):
    flow_of_rule = derived_flow.subs(phi(bulk.sigma_eq), rule.subs(sigma, bulk.sigma_eq))
    assert entries_vanish(flow_of_rule - bulk.plastic_flow(M, rule))

# %% [markdown]
# With $\sigma_{eq} = \sqrt3\,\tau$ this is $L^p = \frac32\varphi\,M'/\sigma_{eq}$. Now what is printed: prefactor
# $3/\eta$, and a direction $M'/|M'|$. Read $|M'|$ as the Frobenius norm, as the paper's colon product suggests. A bar
# pulled with $\sigma > \sigma_Y$ then flows $\sqrt2$ times as fast as (2.25) says; with $3/(\sqrt2\,\eta)$ it does
# not.

# %%
norm = sp.sqrt(square)
tau = sp.sqrt(square / 2)
prove_equal(sp.sqrt(3) * tau, tensile)
printed_rate = 3 / eta * (tau - sigma_Y / sp.sqrt(3)) * (deviatoric / norm)[0, 0]
axial_rate = (tensile - sigma_Y) / eta
prove_equal(printed_rate, sp.sqrt(2) * axial_rate)
prove_equal(printed_rate / sp.sqrt(2), axial_rate)

excess = sp.Symbol("excess", positive=True)
held_rate = bulk.plastic_flow(simple_tension, constitutive_laws.bingham_rate())[0, 0].subs(bulk.sigma_eq, tensile)
prove_equal(held_rate.subs(tensile, sigma_Y + excess), axial_rate.subs(tensile, sigma_Y + excess))
assert held_rate.subs(tensile, sigma_Y / 2) == 0

# %% [markdown]
# Could $|M'|$ mean something else? The one norm with which 3/eta is right is $\sqrt2$ times Frobenius, that is $2\tau$.
# No reader would guess it, and (3.5) gives $\tau$ its own name.

# %%
prove_equal(3 / eta * (tau - sigma_Y / sp.sqrt(3)) * (deviatoric / (2 * tau))[0, 0], axial_rate)

# %% [markdown]
# ## Incompressible flow, (3.8), and what its misprint does
#
# $F = F^eF^p$ gives $F_t F^{-1} = F^e_tF^{e-1} + F^e(F^p_tF^{p-1})F^{e-1}$: the plastic rate is $L^p = F^p_tF^{p-1}$,
# hence $F^p_t = L^pF^p$. Then $(\det F^p)_t = \mathrm{tr}(L^p)\det F^p$, which is zero.

# %%
prove_equal(held_flow.trace(), 0)
components = sp.symbols("l:9", real=True)
L = sp.Matrix(3, 3, components)
plastic = sp.Matrix(3, 3, sp.symbols("p:9", real=True))
for Q in (turn_3, turn_1):
    assert agree_turned(Q * held_flow * Q.T * Q * plastic * Q.T, Q * held_flow * plastic * Q.T)
determinant = plastic.det()
jacobi = sum(sp.diff(determinant, plastic[i, j]) * (L * plastic)[i, j] for i in range(3) for j in range(3))
assert sp.expand(jacobi - L.trace() * determinant) == 0

# %% [markdown]
# The printed $F^p_t = L^pF^{p-1}$ fails already for a bar that flows at the constant rate $l$,
# $L^p = l\,\mathrm{diag}(1,-\frac12,-\frac12)$. Right: $F^p = \mathrm{diag}(e^{lt}, e^{-lt/2}, e^{-lt/2})$, and the
# logarithmic strain $lt$ of (2.25). Printed: each diagonal entry obeys $ff_t = l_i$, so that the volume shrinks
# although $\mathrm{tr}\,L^p = 0$, and vanishes at $t = 1/l$.

# %%
speed, t = sp.symbols("l t", positive=True)
rates = sp.diag(speed, -speed / 2, -speed / 2)
right = sp.diag(sp.exp(speed * t), sp.exp(-speed * t / 2), sp.exp(-speed * t / 2))
wrong = sp.diag(sp.sqrt(1 + 2 * speed * t), sp.sqrt(1 - speed * t), sp.sqrt(1 - speed * t))
assert entries_vanish(sp.diff(right, t) - rates * right)
assert entries_vanish(sp.diff(wrong, t) - rates * wrong.inv())
assert right.det() == 1 and sp.diff(sp.log(right[0, 0]), t) == speed
prove_equal(wrong.det(), sp.sqrt(1 + 2 * speed * t) * (1 - speed * t))
prove_equal(sp.series(wrong.det(), t, 0, 3).removeO(), 1 - sp.Rational(3, 2) * (speed * t) ** 2)
assert wrong.det().subs(t, 1 / speed) == 0

# %% [markdown]
# At small plastic strain the two agree to first order, which may be why nobody saw it.
#
# With the right (3.8) the logarithms add, $\log F_{11} = E^e_{11} + \log F^p_{11}$, for any motion along fixed axes:
# this is the additive split (2.6)-(2.8) of the filament, exact.

# %%
elastic_part, plastic_part = (sp.Function(name, positive=True)(t) for name in ("fe", "fp"))
total_rate = sp.diff(sp.log(elastic_part * plastic_part), t)
prove_equal(total_rate - sp.diff(sp.log(elastic_part), t), sp.diff(plastic_part, t) / plastic_part)
uniaxial_strain = sp.solve(bulk.mandel_stress(sp.diag(lam, lam_rate, lam_rate))[1, 1], lam_rate)[0]
prove_equal(uniaxial_strain, -nu * lam)
prove_equal(bulk.mandel_stress(sp.diag(lam, -nu * lam, -nu * lam))[0, 0], E * lam)

# %% [markdown]
# $M = J\sigma$ there, with $J = \exp((1-2\nu)\epsilon^e)$: the filament's true stress differs from the Mandel stress
# by a tenth of the elastic strain at $\nu = 0.45$, 0.02 % at the yield strains of the paper's flowing scenes.
#
# ## Dissipation
#
# $M : L^p = \frac32\varphi\,M':M'/\sigma_{eq} = \sigma_{eq}\,\varphi(\sigma_{eq}) \ge 0$ for any rule with
# $\sigma\varphi(\sigma) \ge 0$; and the equivalent rate $\sqrt{\frac23L^p:L^p}$ is $\varphi$.

# %%
power = sp.expand(sum(m * f for m, f in zip(M, derived_flow, strict=True)))
squares = sp.expand(power * bulk.sigma_eq / phi(bulk.sigma_eq))
prove_equal(squares, derived_equivalent**2)
prove_equal(
    squares / bulk.sigma_eq * phi(bulk.sigma_eq),
    derived_equivalent**2 / bulk.sigma_eq**2 * bulk.dissipation(phi(sigma)),
)
rate_square = sp.Rational(2, 3) * sum(f**2 for f in derived_flow)
prove_equal(rate_square, phi(bulk.sigma_eq) ** 2 * derived_equivalent**2 / bulk.sigma_eq**2)

# %% [markdown]
# ## In shear, and in a wide sheet
#
# The law fixes how tensile constants translate. Simple shear $\tau$: $\sigma_{eq} = \sqrt3\,\tau$ and
# $\dot\gamma = 2L^p_{12}$. For Bingham the shear yield stress is $\sigma_Y/\sqrt3$ and the shear viscosity is $\eta/3$
# (Trouton). A sheet
# that cannot narrow, $L^p_{33} = 0$: $M_{33} = \sigma/2$, yield at $\frac2{\sqrt3}\sigma_Y$, viscosity $\frac43\eta$.

# %%
beyond = (bulk.sigma_eq - sigma_Y) / eta
shear = sp.Matrix([[0, tensile, 0], [tensile, 0, 0], [0, 0, 0]])
shear_equivalent = bulk.equivalent_stress(shear)
shear_rate = 2 * (bulk.flow_direction(shear) * beyond)[0, 1].subs(bulk.sigma_eq, shear_equivalent)
prove_equal(shear_equivalent, sp.sqrt(3) * tensile)
prove_equal(shear_rate, (tensile - sigma_Y / sp.sqrt(3)) / (eta / 3))

across = sp.Symbol("across", real=True)
sheet = sp.diag(tensile, 0, across)
sheet = sheet.subs(across, sp.solve(bulk.flow_direction(sheet)[2, 2], across)[0])
sheet_equivalent = bulk.equivalent_stress(sheet)
sheet_rate = (bulk.flow_direction(sheet) * beyond)[0, 0].subs(bulk.sigma_eq, sheet_equivalent)
prove_equal(sheet[2, 2], tensile / 2)
prove_equal(sheet_rate, (tensile - 2 / sp.sqrt(3) * sigma_Y) / (sp.Rational(4, 3) * eta))

# %% [markdown]
# ## Plane stress
#
# Principal axes, $M_{33} = 0$: the width strain follows, and the moduli are those of plane stress.

# %%
e1, e2 = held_strain[0, 0], held_strain[1, 1]
e3 = sp.Symbol("e3")
no_stress = sp.solve(isotropic(sp.diag(e1, e2, e3)).subs(moduli)[2, 2], e3)[0]
flat = bulk.mandel_stress(bulk.flat_strain())
prove_equal(no_stress, bulk.width_strain())
prove_equal(E / (1 - nu**2) * (e1 + nu * e2), flat[0, 0])
prove_equal(E / (1 - nu**2) * (e2 + nu * e1), flat[1, 1])
prove_equal(flat[2, 2], 0)
prove_equal(bulk.equivalent_stress(sp.diag(M[0, 0], M[1, 1], 0)) ** 2, M[0, 0] ** 2 - M[0, 0] * M[1, 1] + M[1, 1] ** 2)
in_axes = bulk.mandel_stress(sp.diag(e1, e2, held_strain[2, 2]))
for i in range(3):
    prove_equal(in_axes[i, i], isotropic(sp.diag(e1, e2, held_strain[2, 2])).subs(moduli)[i, i])

# %% [markdown]
# ## An implicit step
#
# $F^p_{new} = e^{\Delta t\,L^p}F^p$ keeps $\det F^p = 1$ exactly. With $M$ and $E^e$ coaxial, the logarithms add once
# more: $E^e = E^e_{trial} - \Delta t\,L^p$, $L^p$ taken at the end of the step. Deviator, times $2\mu$:
# $M'(1 + 3\mu\Delta t\,\varphi/\sigma_{eq}) = M'_{trial}$. The direction is the trial's; the size is one scalar
# equation.

# %%
dt, new, trial = bulk.step, bulk.sigma_eq, sp.Symbol("sigma_trial", positive=True)
n1, n2 = sp.symbols("n1 n2", real=True)
direction = sp.diag(n1, n2, -n1 - n2)  # M' = sig_eq times this, whose equivalent stress is one
update = 2 * mu * dt * sp.Rational(3, 2) * phi(new) * direction  # 2 mu dt Lp
shrink = (new * direction + update - trial * direction)[0, 0] / n1
prove_equal(shrink.subs(moduli), new + 3 * bulk.shear_modulus() * dt * phi(new) - trial)

flowing = shrink.subs(moduli).subs(phi(new), (new - sigma_Y) / eta)
root = sp.solve(flowing, new)[0]
slowed = excess / (1 + 3 * bulk.shear_modulus() * bulk.step / eta)
prove_equal(root.subs(trial, sigma_Y + excess), sigma_Y + slowed)

# %%
record_errata(
    "06_bulk_law",
    [
        Erratum(
            equation="(3.7)",
            printed=r"$L^p = \frac{3}{\eta}\langle\tau - \sigma_Y/\sqrt3\rangle\, M'/|M'|$",
            correct=r"$L^p = \frac{3}{\sqrt2\,\eta}\langle\tau - \sigma_Y/\sqrt3\rangle\, M'/|M'|$",
            proof=r"In simple tension ($|M'|$ Frobenius) the printed law gives $\sqrt2$ times the rate (2.25).",
        ),
        Erratum(
            equation="(3.8)",
            printed=r"$\dot F^p = L^p F^{p-1}$",
            correct=r"$\dot F^p = L^p F^p$",
            proof=r"Steady extension $l$: the printed form gives $\det F^p = \sqrt{1+2lt}\,(1-lt)$, not 1, though "
            r"$\mathrm{tr}\,L^p = 0$.",
        ),
    ],
)
