"""A filament that does not stretch: what is left of its section, and what it cannot have."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from softcat_sym.physics import symbols as sy
from softcat_sym.physics.filament import FilamentEquations, Terms, derive
from softcat_sym.physics.kinematics import LARGE_ROTATION, TRUE_STRAIN
from softcat_sym.physics.laws import law_of
from softcat_sym.physics.sections import SECTIONS, SectionMeans, of_bending_alone

AXIAL = {sy.s, sy.s_t, sy.x_X, sy.x_Xt, sy.sigma_0, sy.a_0, sy.T, sy.Q}
CLOSED = ("elastic", "maxwell", "newtonian", "kelvin-voigt", "standard-linear", "bingham")
CASES = [
    *((law, section) for law in CLOSED for section in SECTIONS),
    ("power-law", "sheet"),
    ("herschel-bulkley", "circle"),
]
BEAM = Terms(bending=True, flows=True, yields=True, viscous=True)
VALUES = {sy.E: 3.0, sy.eta: 0.7, sy.sigma_Y: 0.4, sy.sigma_0: 0.0}


def beam(law: str, section: str, *, stretches: bool) -> FilamentEquations:
    return derive(replace(BEAM, law=law_of(law), stretches=stretches), SECTIONS[section], "material")


def test_no_axial_symbol_is_left() -> None:
    for law, section in CASES:
        unstretched, stretched = (beam(law, section, stretches=stretches) for stretches in (False, True))
        left, before = (
            set().union(
                *(e.free_symbols for e in (*cell.response.expressions(), cell.force.horizontal, cell.force.vertical))
            )
            for cell in (unstretched, stretched)
        )
        assert not left & AXIAL
        assert left < before
        assert unstretched.force.horizontal == unstretched.response.tension == 0
        assert unstretched.conserves_energy


def test_bending_is_that_of_a_stretched_section_under_no_tension() -> None:
    for law, section in CASES:
        unstretched, stretched = (beam(law, section, stretches=stretches) for stretches in (False, True))
        assert unstretched.response.moment == stretched.response.moment
        for left, whole in zip(unstretched.response.parts, stretched.response.parts, strict=True):
            assert left.stress_bending == whole.stress_bending
            for name, relation in left.flow().items():
                full = whole.flow()[name]
                symbols = sorted((relation.free_symbols | full.free_symbols) - set(VALUES) - {sy.sigma_1}, key=str)
                known = {**VALUES, **dict.fromkeys(symbols, 0.5)}
                one, other = (sp.lambdify(sy.sigma_1, e.subs(known), modules="numpy") for e in (relation, full))
                for stress in (-2.3, -0.41, -0.3, 0.2, 0.5, 1.7):
                    np.testing.assert_allclose(one(stress), other(stress), rtol=1e-12, atol=1e-15, err_msg=name)


def test_means_without_a_mean_stress_are_odd_in_the_moment() -> None:
    (branch,) = beam("bingham", "circle", stretches=True).response.branches
    assert isinstance(branch.means, SectionMeans)
    alone = of_bending_alone(branch.means)
    known = {sy.E: 3.0, sy.eta: 0.7, sy.sigma_Y: 0.4}
    rate = sp.lambdify(sy.sigma_1, alone.bending_rate.subs(known), modules="numpy")
    assert alone.rate == 0
    assert rate(0.39) == rate(-0.39) == 0
    assert rate(0.9) == -rate(-0.9) > 0


def test_what_only_stretching_brings_is_refused() -> None:
    for changes, named in [
        ({"bending": False}, "carries no weight"),
        ({"thins": True}, "thinning"),
        ({"strain": TRUE_STRAIN}, "finite strain"),
        ({"centreline": LARGE_ROTATION}, "large rotation"),
        ({"shear": True}, "shear"),
        ({"resolved": True}, "point by point"),
        ({"necking_gradient": True}, "necking gradient"),
    ]:
        with pytest.raises(ValueError, match=named):
            derive(replace(BEAM, **changes), SECTIONS["rectangle"], "material")  # type: ignore[arg-type]
