"""The equations in force as text: nothing of an absent effect, LaTeX that is well formed, exact where it is checked."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest
import sympy as sp

from softcat_sym.physics.equation import Stated
from softcat_sym.physics.filament import Terms, derive
from softcat_sym.physics.in_force import equations_in_force, plain_rate
from softcat_sym.physics.kinematics import LARGE_ROTATION, TRUE_STRAIN
from softcat_sym.physics.laws import FIXED, K, law_of, n
from softcat_sym.physics.loads import ramp_rate, ramped_gravity, shaking, shaking_rate
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.symbols import E, sigma, sigma_Y, table

LARGE = Terms(
    centreline=LARGE_ROTATION, strain=TRUE_STRAIN, thins=True, inertia=True, bending=True, stretches=True, flows=True
)
BINGHAM = replace(LARGE, law=FIXED["bingham"], yields=True)
EVERYTHING = replace(
    BINGHAM, shear=True, resolved=True, rotary_inertia=True, necking_gradient=True,
    gravity=ramped_gravity(), gravity_rate=ramp_rate(), shaking=shaking(), shaking_rate=shaking_rate(),
)  # fmt: skip


def written(terms: Terms, shape: str = "rectangle", closure: str = "material") -> tuple[Stated, ...]:
    return equations_in_force(derive(terms, SECTIONS[shape], closure))


def words(equations: tuple[Stated, ...]) -> set[str]:
    return set(re.findall(r"[A-Za-z_]\w*", " ".join(equation.text for equation in equations)))


def line(equations: tuple[Stated, ...], name: str) -> str:
    (found,) = [equation.text for equation in equations if equation.name == name]
    return found


ABSENT = [
    ("yielding", replace(BINGHAM, yields=False), {"sigma_Y"}),
    ("viscous flow", replace(BINGHAM, flows=False, yields=False), {"sigma_Y", "eta", "a_0", "a_1", "eps_p_t"}),
    ("bending", replace(BINGHAM, bending=False), {"M", "M_X", "sigma_1", "a_1", "theta_X", "h0"}),
    ("inertia", replace(BINGHAM, inertia=False), {"d2x", "d2y"}),
    ("ramp", BINGHAM, {"g_on", "g_t", "v_on"}),
    ("shaking", replace(EVERYTHING, shaking=sp.S.One, shaking_rate=sp.S.Zero), {"a_g", "f_g"}),
    ("gradient", BINGHAM, {"s_slope"}),
    ("shear", replace(EVERYTHING, shear=False, rotary_inertia=False), {"Gam", "tau_f", "gamma_p", "nu"}),
    ("rotary inertia", replace(EVERYTHING, rotary_inertia=False), {"d2psi"}),
    (
        "stretching",
        Terms(law=FIXED["bingham"], bending=True, inertia=True, flows=True, yields=True),
        {"s", "T", "Q", "sigma_0", "a_0", "dx", "F_x"},
    ),
]


def test_an_absent_effect_leaves_no_symbol() -> None:
    for _, terms, symbols in ABSENT:
        there = words(written(EVERYTHING)) | words(written(BINGHAM)) | {f"d2{name}" for name in ("x", "y")}
        assert not symbols & words(written(terms))
        # Where it is in force they are there: what is looked for is spelled right.
        assert symbols - {"d2x", "d2y"} <= there | {"a_0", "a_1"}


def test_latex_is_well_formed() -> None:
    for shape in list(SECTIONS):
        for law in [*FIXED, "multimode-maxwell"]:
            for resolved in [False, True]:
                made = law_of(law, modes=3 if law == "multimode-maxwell" else 0)
                terms = replace(LARGE, law=made, yields=True, viscous=True, shear=resolved, resolved=resolved)
                for equation in written(terms, shape):
                    tex = equation.latex
                    assert tex.count("{") == tex.count("}"), tex
                    assert tex.count(r"\left") == tex.count(r"\right"), tex
                    assert tex.count(r"\begin") == tex.count(r"\end"), tex
                    # One superscript after another stops LaTeX.
                    assert not re.search(r"\^(\{[^{}]*\}|[^{}\\])\^", tex), tex
                    assert len(equation.text) < 200, equation.text
                    assert "part" not in tex.replace(r"\partial", ""), tex


def test_every_symbol_that_is_written_stands_in_the_table() -> None:
    names = {row.symbol.name for row in table()} | {f"d{row.symbol.name}" for row in table()}
    functions = {"pi", "sin", "cos", "log", "sqrt", "Min", "Max", "if", "otherwise", "d2x", "d2y", "d2psi", "dt2", "d"}
    assert not words(written(EVERYTHING)) - names - functions


def test_the_paper_s_filament_reads_as_published() -> None:
    found = written(BINGHAM)
    assert line(found, "stretch of the centreline") == "s = sqrt(x_X^2 + y_X^2)"
    assert line(found, "tension") == "T = A0*sigma_0/s"
    assert line(found, "axial flow") == "da_0/dt = <eps_p_t>"
    # <zeta^2> of a rectangle is 1/3, of a circle 1/4.
    assert line(found, "bending flow") == "da_1/dt = 3*<eps_p_t*zeta>"
    assert line(written(BINGHAM, "circle"), "bending flow") == "da_1/dt = 4*<eps_p_t*zeta>"
    assert line(found, "axial force, conjugate to the stretch") == "Q = 3*M*theta_X/(2*s) + T"
    assert line(written(BINGHAM, closure="printed"), "axial force, conjugate to the stretch") == "Q = T"
    assert line(written(BINGHAM, closure="printed"), "axial flow") == "da_0/dt = <eps_p_t>/s"
    assert line(written(BINGHAM, closure="printed"), "bending flow") == "da_1/dt = 3*<eps_p_t*zeta>/s^(3/2)"


def test_gravity_is_written_as_it_comes_on_and_shakes() -> None:
    shaken = replace(BINGHAM, shaking=shaking(), shaking_rate=shaking_rate())
    assert line(written(shaken), "gravity, shaken") == "g_t = g*(a_g*sin(2*pi*f_g*t) + 1)"
    both = line(written(EVERYTHING), "gravity, switched on smoothly and shaken")
    assert both == "g_t = g*v_on^3*(a_g*sin(2*pi*f_g*t) + 1)*(v_on*(6*v_on - 15) + 10)"
    assert not any("gravity" in equation.name for equation in written(BINGHAM))


def test_a_linear_law_shows_its_closed_means() -> None:
    found = written(replace(LARGE, law=FIXED["maxwell"]))
    assert line(found, "axial flow") == "da_0/dt = sigma_0/eta"
    # A sheet flows by 3/4 of its stress (von Mises in plane strain).
    assert line(written(replace(LARGE, law=FIXED["maxwell"]), "sheet"), "axial flow") == "da_0/dt = 3*sigma_0/(4*eta)"


def test_the_rule_shown_is_the_rule_integrated() -> None:
    for law in ["power-law", "herschel-bulkley"]:
        for stress in [-3.0, 0.4, 2.5]:
            (branch,) = FIXED[law].branches
            flow = branch.flow_beyond_yield or branch.flow
            assert flow is not None
            values = {sigma: stress, K: 2.0, n: 0.5, sigma_Y: 1.0, E: 10.0}
            shown = plain_rate(flow)
            assert not shown.has(E)
            assert float(shown.subs(values)) == pytest.approx(float(flow.rate.subs(values)), rel=1e-12, abs=1e-15)


def test_a_user_s_own_rule_keeps_its_names() -> None:
    class Formula:
        def fold(self, number, name, operation):  # type: ignore[no-untyped-def]
            return operation("div", [operation("sinh", [operation("div", [name("sigma"), name("s_0")])]), name("t0")])

    made = law_of("custom", formula=Formula())
    found = written(replace(LARGE, law=made))
    assert line(found, "flow rule of a fibre") == "eps_p_t = sinh(sigma/s_0)/t0"
    (tex,) = [equation.latex for equation in found if equation.name == "flow rule of a fibre"]
    assert r"\mathrm{s\_0}" in tex
    assert sp.Symbol("custom_s_0").name not in tex
