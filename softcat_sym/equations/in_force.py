"""The equations in force, written out from the very objects that the graph is printed from."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from softcat_sym.equations.balance import F_x, F_y, mass_per_length
from softcat_sym.equations.closure import CLOSURES
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.equations.in_force_resolved import resolved_section
from softcat_sym.equations.in_force_section import gradient_term, plastic_rates, stresses, surface_term
from softcat_sym.equations.necking import s_slope
from softcat_sym.equations.paper_section import A, h
from softcat_sym.equations.section import NONE
from softcat_sym.equations.symbols import (
    A0,
    ACCELERATION,
    L_0,
    LENGTH,
    M_X,
    ONE,
    M,
    Q,
    T,
    X,
    enter,
    rho,
    s,
    t,
    theta,
    theta_X,
    x_X,
    x_X_before,
    y_X,
    y_X_before,
    zeta,
)
from softcat_sym.equations.written import Rate, Stated, stated

x_place = enter("x", "x", LENGTH, "horizontal position of the centreline", "2.1")
y_place = enter("y", "y", LENGTH, "height of the centreline", "2.1")
axial_strain = enter("eps", r"\epsilon", ONE, "axial strain of a fibre", "2.6")
weight = enter("g_t", "g(t)", ACCELERATION, "gravity while it is switched on", "section 3")
progress = enter("v_on", "v", ONE, "how far gravity is switched on, in time", "section 3")


def equations_in_force(equations: FilamentEquations, *, reduced: bool = False) -> tuple[Stated, ...]:
    """Write the equations of a filament out, in the order in which one would derive them.

    Means over the section stay means, and a rule that is rounded at zero stress for the integrator is written without
    the rounding.

    Parameters
    ----------
    equations : FilamentEquations
        What the graph is printed from.
    reduced : bool
        Whether it is used as the small-deflection model (2.13)-(2.17) does: one tension for the whole span.
    """
    if equations.resolved is not None:
        section = resolved_section(equations)
    elif reduced:
        section = (*_uniform_stretch(equations), *_section(equations))
    else:
        section = (*_kinematics(equations), *_strain(equations), *_section(equations))
    return (*section, *_balance(equations, reduced=reduced), *_gravity(equations))


def _kinematics(equations: FilamentEquations) -> Iterator[Stated]:
    terms = equations.terms
    if terms.stretches:
        yield stated("stretch of the centreline", s, terms.centreline.stretch, terms.centreline.source)
    if terms.bending:
        angle = terms.centreline.turning.subs({x_X_before: 1, y_X_before: 0})
        yield stated("angle of the tangent", theta, angle, terms.centreline.source)
        yield stated("turning", theta_X, Rate(theta, X, 1), terms.centreline.source)


def _uniform_stretch(equations: FilamentEquations) -> Iterator[Stated]:
    elongation = equations.terms.centreline.stretch.subs(x_X, 1) - 1
    if equations.terms.stretches:
        mean = sp.Integral(elongation, (X, -L_0 / 2, L_0 / 2)) / L_0
        yield stated("stretch, the same everywhere", s, 1 + mean, "2.13, 2.17")
    if equations.terms.bending:
        yield stated("turning", theta_X, Rate(y_place, X, 2), "2.13")


def _strain(equations: FilamentEquations) -> Iterator[Stated]:
    terms = equations.terms
    contraction = equations.shape.contraction if terms.thins else NONE
    lever = CLOSURES[equations.closure](terms.strain, contraction).lever
    along = terms.strain.strain if terms.stretches else sp.Integer(0)
    across = lever * theta_X * zeta if terms.bending else sp.Integer(0)
    yield stated("axial strain of the fibre zeta = 2z/h", axial_strain, along - across, terms.strain.source)
    if terms.thins:
        yield stated("area", A, equations.response.area, contraction.source)
        if terms.bending:
            yield stated("thickness", h, equations.response.thickness, contraction.source)


def _section(equations: FilamentEquations) -> Iterator[Stated]:
    terms, response = equations.terms, equations.response
    yield from stresses(equations)
    yield from plastic_rates(equations)
    if terms.stretches:
        yield stated("tension", T, response.tension, "2.10")
    if terms.bending:
        yield stated("bending moment", M, response.moment, "2.10")
    if terms.stretches:
        gain, pull = gradient_term(equations), surface_term(equations)
        source = "THEORY 4" if response.axial_correction != 0 else "2.4"
        source += "; Audoly & Hutchinson 2016" if gain else ""
        source += "; Eggers & Dupont 1994" if pull else ""
        yield stated("axial force, conjugate to the stretch", Q, T + response.axial_correction + gain + pull, source)
        if gain:
            yield stated("slope of a neck", s_slope, Rate(s, X, 1), "Audoly & Hutchinson 2016")
    if terms.bending:
        yield stated("change of the moment", M_X, Rate(M, X, 1), "2.3")


def _balance(equations: FilamentEquations, *, reduced: bool) -> Iterator[Stated]:
    terms, force = equations.terms, equations.force
    along = terms.stretches and not reduced
    if equations.resolved is None:
        if along:
            yield stated("internal force, horizontal", F_x, force.horizontal, "2.4, corrected")
        upwards = force.vertical.subs(Q, T + surface_term(equations)) if reduced else force.vertical
        yield stated("internal force, vertical", F_y, upwards, "2.14" if reduced else "2.4, corrected")
    mass, source = mass_per_length(), "2.14" if reduced else "2.1, 2.2"
    if not terms.inertia:
        mass = sp.Integer(0)
    if along:
        yield stated("balance of momentum, horizontal", mass * Rate(x_place, t, 2), Rate(F_x, X, 1), source)
    falling = rho * A0 * (weight if _changes(equations) else terms.load)
    yield stated("balance of momentum, vertical", mass * Rate(y_place, t, 2), Rate(F_y, X, 1) - falling, source)
    if along:
        yield stated("tangent, horizontal", x_X, Rate(x_place, X, 1), "2.5")
    yield stated("tangent, vertical", y_X, Rate(y_place, X, 1), "2.5")


def _gravity(equations: FilamentEquations) -> Iterator[Stated]:
    if not _changes(equations):
        return
    terms = equations.terms
    names = {"switched on smoothly": terms.gravity.has(t), "shaken": terms.shaking.has(t)}
    sources = {"section 3": terms.gravity.has(t), "Rayleigh 1877": terms.shaking.has(t)}
    how, source = ([what for what, there in found.items() if there] for found in (names, sources))
    shares = {part for part in terms.gravity.atoms(sp.Min) if part.has(t)}
    load = terms.load.subs(dict.fromkeys(shares, progress))
    yield stated(f"gravity, {' and '.join(how)}", weight, load, "; ".join(source))
    for share in shares:
        yield stated("time of switching on", progress, share, "section 3")


def _changes(equations: FilamentEquations) -> bool:
    return bool(equations.terms.load.has(t))
