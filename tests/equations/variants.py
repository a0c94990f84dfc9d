"""Every filament that can be derived, and all expressions of one."""

from __future__ import annotations

from dataclasses import fields
from functools import cache
from itertools import product

import sympy as sp

from softcat_sym.physics import kinematics
from softcat_sym.physics import sections as section
from softcat_sym.physics.closures import CLOSURES
from softcat_sym.physics.filament import FilamentEquations, Terms, derive
from softcat_sym.physics.laws import law_of
from softcat_sym.physics.loads import ramp_rate, ramped_gravity
from softcat_sym.physics.section_response import BranchResponse, SectionResponse

LAWS = ("elastic", "maxwell", "bingham")


@cache
def filament(
    shape: str = "rectangle",
    closure: str = "material",
    law: str = "bingham",
    *,
    finite: bool = True,
    thin: bool = True,
    bending: bool = True,
    stretches: bool = True,
    large: bool = True,
    ramp: bool = True,
) -> FilamentEquations:
    """One cell, with or without each effect."""
    terms = Terms(
        centreline=kinematics.LARGE_ROTATION if large else kinematics.SMALL_SLOPE,
        strain=kinematics.TRUE_STRAIN if finite else kinematics.SMALL_STRAIN,
        thins=thin,
        inertia=True,
        bending=bending,
        stretches=stretches,
        gravity=ramped_gravity() if ramp else Terms().gravity,
        gravity_rate=ramp_rate() if ramp else sp.Integer(0),
        law=law_of(law),
        flows=True,
        yields=True,
    )
    return derive(terms, section.SECTIONS[shape], closure)


def all_filaments() -> list[FilamentEquations]:
    """Every section, both closures, three laws, with everything, with each effect missing, and without stretching."""
    missing = [{}, *({name: False} for name in ("finite", "thin", "bending", "large", "ramp"))]
    missing.append(dict.fromkeys(("finite", "thin", "large", "stretches"), False))
    return [
        filament(shape, closure, law, **options)
        for shape, closure, law, options in product(section.SECTIONS, CLOSURES, LAWS, missing)
    ]


def expressions(equations: FilamentEquations) -> dict[str, sp.Expr]:
    """All of its expressions by name."""
    response, terms = equations.response, equations.terms
    branch, whole = response.branch, {f.name for f in fields(SectionResponse)} - {"branches", "viscous"}
    found = {name: getattr(response, name) for name in whole}
    found |= {f.name: getattr(branch, f.name) for f in fields(BranchResponse) if f.name != "means"}
    if branch.means is not None:
        found |= {f"means.{f.name}": getattr(branch.means, f.name) for f in fields(type(branch.means))}
    gradients = {
        f"{name}_{axis}": component
        for name, pair in (
            ("stretch_gradient", terms.centreline.stretch_gradient()),
            ("angle_gradient", terms.centreline.angle_gradient()),
        )
        for axis, component in zip("xy", pair, strict=True)
    }
    return (
        found
        | gradients
        | {
            "force.horizontal": equations.force.horizontal,
            "force.vertical": equations.force.vertical,
            "gravity": terms.gravity,
            "gravity_rate": terms.gravity_rate,
            "stretch": terms.centreline.stretch,
            "turning": terms.centreline.turning,
            "strain": terms.strain.strain,
            "arc_stretch": terms.strain.arc_stretch,
        }
    )
