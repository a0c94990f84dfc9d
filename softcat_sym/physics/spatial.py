"""A filament in three dimensions: strains, one point of the section, and what its stresses do (THEORY3D 1 to 4).

A section has the frame d1, d2, d3, with d1 along its normal; a unit quaternion turns the fixed axes into it. Strains
are Gamma = R^T r_X = (Lam, Gam_2, Gam_3) and kappa = (k_1, k_2, k_3), twist and two curvatures. In the plane Gam_2 is
``Gam``, k_3 is ``k``, and everything else vanishes: what remains is :mod:`softcat_sym.physics.reissner`.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.physics.constitutive_laws import Law
from softcat_sym.physics.reissner import (
    CARRY,
    Gam,
    Gam_t,
    Lam,
    Lam_t,
    SampledSection,
    Shear,
    fibre_branches,
    sigma_c,
    viscous_fibre,
)
from softcat_sym.physics.sections import Section
from softcat_sym.physics.symbols import ONE, PER_LENGTH, RATE, STRESS, enter, h0, s

SOURCE = "THEORY3D"
Three = tuple[sp.Expr, sp.Expr, sp.Expr]

Gam_3 = enter("Gam_3", r"\Gamma_3", ONE, "r_X along the third axis of the section", SOURCE)
k_1 = enter("k_1", r"\kappa_1", PER_LENGTH, "twist per unit material length", SOURCE)
k_2 = enter("k_2", r"\kappa_2", PER_LENGTH, "curvature about the second axis", SOURCE)
k_3 = enter("k_3", r"\kappa_3", PER_LENGTH, "curvature about the third axis, that of the plane", SOURCE)
STRAINS = (Lam, Gam, Gam_3, k_1, k_2, k_3)
"""Gamma and kappa."""
RATES = (
    *(Lam_t, Gam_t, enter("Gam_3_t", r"\dot\Gamma_3", RATE, "rate of Gam_3", SOURCE)),
    *(enter(f"k_{n}_t", rf"\dot\kappa_{n}", (0, -1, -1), f"rate of k_{n}", SOURCE) for n in (1, 2, 3)),
)
"""Their rates."""

NATURAL: Three = tuple(
    enter(f"k0_{n}", rf"\kappa^0_{n}", PER_LENGTH, f"natural {what}", SOURCE)
    for n, what in ((1, "twist"), (2, "curvature about the second axis"), (3, "curvature about the third axis"))
)

natural_twist = enter("twist_0", r"\kappa_1^0", PER_LENGTH, "natural twist of the whole filament", SOURCE)

Y = enter("Y_f", "Y", ONE, "place of a point along the second axis, over h0/2", SOURCE)
Z = enter("Z_f", "Z", ONE, "place of a point along the third axis, over h0/2", SOURCE)
W_2 = enter("W_2", "W_2", ONE, "shear along the second axis by a twist, over h0/2; -Z of a circle", SOURCE)
W_3 = enter("W_3", "W_3", ONE, "shear along the third axis by a twist, over h0/2; Y of a circle", SOURCE)
POINT = (Y, Z, W_2, W_3)
"""Numbers of a point of the section."""

gamma = tuple(enter(f"gamma_s{n}", rf"\gamma_{n}", ONE, f"shear of a point along axis {n}", SOURCE) for n in (2, 3))
gamma_p = tuple(enter(f"gamma_p{n}", rf"\gamma^p_{n}", ONE, f"plastic shear along axis {n}", SOURCE) for n in (2, 3))
gamma_e = tuple(enter(f"gamma_e{n}", rf"\gamma^e_{n}", ONE, f"elastic shear along axis {n}", SOURCE) for n in (2, 3))
gamma_t = tuple(enter(f"gamma_t{n}", rf"\dot\gamma_{n}", RATE, f"rate of gamma along axis {n}", SOURCE) for n in (2, 3))
tau = tuple(enter(f"tau_s{n}", rf"\tau_{n}", STRESS, f"shear stress conjugate to gamma_{n}", SOURCE) for n in (2, 3))
tau_d = tuple(enter(f"tau_d{n}", rf"d_{n}", STRESS, f"stress that drives gamma_p{n}", SOURCE) for n in (2, 3))
SHEARS = tuple(map(Shear, gamma, gamma_p, gamma_e, gamma_t, tau, tau_d))

MEANS = tuple(
    enter(name, latex, STRESS, f"mean over the section of {what}", SOURCE)
    for name, latex, what in (
        ("mean_s", r"\langle\sigma\rangle", "the axial stress"),
        ("mean_sY", r"\langle\sigma Y\rangle", "the axial stress times Y"),
        ("mean_sZ", r"\langle\sigma Z\rangle", "the axial stress times Z"),
        ("mean_t2", r"\langle\tau_2\rangle", "the shear stress along the second axis"),
        ("mean_t3", r"\langle\tau_3\rangle", "the shear stress along the third axis"),
        ("mean_tW", r"\langle\tau_i W_i\rangle", "the shear stresses times what a twist shears"),
    )
)
"""What the resultants of a section are made of."""


def rotated(quaternion: tuple[sp.Expr, ...], vector: Three) -> Three:
    """R(q) v, in products of the quaternion's components, which need not be of length one: R is divided by q.q."""
    w, x, y, z = quaternion
    a, b, c = vector
    size = w**2 + x**2 + y**2 + z**2
    return (
        ((w**2 + x**2 - y**2 - z**2) * a + 2 * (x * y - w * z) * b + 2 * (x * z + w * y) * c) / size,
        (2 * (x * y + w * z) * a + (w**2 - x**2 + y**2 - z**2) * b + 2 * (y * z - w * x) * c) / size,
        (2 * (x * z - w * y) * a + 2 * (y * z + w * x) * b + (w**2 - x**2 - y**2 + z**2) * c) / size,
    )


def unrotated(quaternion: tuple[sp.Expr, ...], vector: Three) -> Three:
    """R(q)^T v."""
    w, x, y, z = quaternion
    return rotated((w, -x, -y, -z), vector)


def relative(first: tuple[sp.Expr, ...], second: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    """The turn from one frame to the next, seen from either: conj(q_a) q_b."""
    a, (b, c, d) = first[0], first[1:]
    w, (x, y, z) = second[0], second[1:]
    return (
        a * w + b * x + c * y + d * z,
        a * x - b * w - c * z + d * y,
        a * y + b * z - c * w - d * x,
        a * z - b * y + c * x - d * w,
    )


def point_strain(correction: sp.Expr, *, natural: bool) -> Three:
    """Strains of a point of the section (2.1, 2.2), less the natural ones: axial, and the shears along both axes.

    Log Lam + Lam^-3/2 (k_2 Z - k_3 Y), and c Gam_i/Lam with what the twist shears.
    """
    lever, root = Lam ** (-CARRY), sp.sqrt(correction)
    at_rest = NATURAL if natural else (sp.Integer(0),) * 3
    turned = [lever * now - before for now, before in zip((k_1, k_2, k_3), at_rest, strict=True)]
    return (
        sp.log(Lam) + h0 / 2 * (turned[1] * Z - turned[2] * Y),
        root * Gam / Lam + h0 / 2 * turned[0] * W_2,
        root * Gam_3 / Lam + h0 / 2 * turned[0] * W_3,
    )


def power(correction: sp.Expr) -> sp.Expr:
    """Power of the stresses in the strains, per unit rest length and undeformed area.

    Its derivatives by `STRAINS` at fixed `MEANS` are the force and the moment of section 4.
    """
    mean, mean_Y, mean_Z, mean_2, mean_3, mean_W = MEANS
    lever, root = Lam ** (-CARRY), sp.sqrt(correction)
    bent = h0 / 2 * lever * (k_2 * mean_Z - k_3 * mean_Y + k_1 * mean_W)
    return mean * sp.log(Lam) + root * (Gam * mean_2 + Gam_3 * mean_3) / Lam + bent


def spatial_section(shape: Section, law: Law, *, natural: bool) -> SampledSection:
    """A section that shrinks both ways; that of a sheet does not twist without warping, and is refused.

    Raises
    ------
    ValueError
        For a sheet, and for a law of polymer chains or whose springs grow.
    """
    if shape.plane_strain:
        raise ValueError("a sheet twists and bends as a plate: take a rectangle")
    if law.chains is not None or any(branch.growth is not None for branch in law.branches):
        raise ValueError("chains and springs that grow are those of a filament in its plane")
    correction, (second, third) = shape.shear_correction, tau
    strains = point_strain(correction, natural=natural)
    of_points = (sigma_c, sigma_c * Y, sigma_c * Z, second, third, second * W_2 + third * W_3)
    return SampledSection(
        point_strains=strains,
        kinds=SHEARS,
        branches=fibre_branches(shape, law, shears=SHEARS),
        viscous=viscous_fibre(shape, law, strains, zip(STRAINS, RATES, strict=True), shears=SHEARS),
        means={mean.name: (mean, of_point, sp.S.One) for mean, of_point in zip(MEANS, of_points, strict=True)},
        strains=STRAINS,
        strain_rates=RATES,
        power=power(correction),
        relative_thickness=shape.contraction.thickness.subs(s, Lam) / h0,
    )
