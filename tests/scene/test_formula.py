"""A user's own flow rule: what is read, what is refused, and that the tree means what the text says."""

from __future__ import annotations

import math
import time
import tomllib
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic_core import PydanticCustomError

from softcat_sym.scene.formula import FUNCTIONS, parse_formula
from softcat_sym.scene.scene import Scene

from .tables import BINGHAM, faults_of, spoiled


def own(flow: object, parameters: object = None, **changes: Any) -> dict[str, Any]:
    """A scene of a custom law."""
    material = {"law": "custom", "youngs_modulus": "4 MPa", "flow": flow}
    if parameters is not None:
        material["parameters"] = parameters
    return spoiled({"material": material | changes})


SINH = {"s0": "1 kPa", "t0": "2 s"}


def test_a_tree_means_what_its_text_says() -> None:
    for text, expected in [
        ("sinh(sigma/s0)/t0", math.sinh(1.5) / 2),
        ("sigma - -sigma*2**3**2", 3 * (1 + 2**9)),
        ("+sigma*(1 + pi)/1e1", 3 * (1 + math.pi) / 10),
        ("sign(sigma)*max(abs(sigma) - s0, 0)**(1/0.5)/t0", 0.5),
        ("min(sigma, s0) - exp(0)*log(t0)", 2 - math.log(2)),
        (
            "cosh(sigma) + tanh(sigma) + asinh(sigma) + atan(sigma)",
            math.cosh(3) + math.tanh(3) + math.asinh(3) + math.atan(3),
        ),
        ("sqrt(sigma)*sin(sigma)*cos(sigma)", math.sqrt(3) * math.sin(3) * math.cos(3)),
    ]:
        assert parse_formula(text).value(3.0, {"s0": 2.0, "t0": 2.0}) == pytest.approx(expected, rel=1e-14)


@given(
    st.recursive(
        st.sampled_from(["sigma", "a", "2.5"]),
        lambda x: st.tuples(x, st.sampled_from("+-*"), x).map(lambda t: f"({t[0]}{t[1]}{t[2]})"),
        max_leaves=12,
    )
)
@settings(max_examples=100, deadline=None)
def test_the_tree_agrees_with_python(text: str) -> None:
    names = {"__builtins__": {}, "sigma": 1.25, "a": -0.75}
    assert parse_formula(text).value(1.25, {"a": -0.75}) == eval(text, names)


def test_a_fold_rebuilds_the_expression_in_any_arithmetic() -> None:
    formula = parse_formula("sinh(sigma/s0)/t0 + pi*0")
    assert formula.names == {"s0", "t0"}
    text = formula.fold(str, str, lambda name, parts: f"{name}({','.join(parts)})")
    assert text == f"add(div(sinh(div(sigma,s0)),t0),mul({math.pi!r},0.0))"
    assert formula == parse_formula(formula.text)
    assert hash(formula) == hash(parse_formula(formula.text))


def test_what_is_not_finite_is_said_and_never_raised() -> None:
    for text, sigma, expected in [
        ("exp(sigma)", 1e4, math.inf),
        ("sinh(sigma)", -1e4, -math.inf),
        ("sigma**3", -1e200, -math.inf),
        ("9**9**9**9", 0.0, math.inf),
        ("1/sigma", 0.0, math.inf),
        ("sigma**-1", 0.0, math.inf),
        ("log(sigma)", -1.0, math.nan),
        ("sigma**0.5", -1.0, math.nan),
        ("sigma/sigma", 0.0, math.nan),
        ("max(log(sigma), 0)", -1.0, math.nan),
    ]:
        assert parse_formula(text).value(sigma, {}) == pytest.approx(expected, nan_ok=True)


HOSTILE = [
    ("__import__('os').system('true')", "is not arithmetic"),
    ("__import__('os')", "unknown function '__import__'"),
    ("sigma.real", "'sigma.real' is not arithmetic"),
    ("().__class__.__bases__[0]", "is not arithmetic"),
    ("sigma[0]", "'sigma[0]' is not arithmetic"),
    ("lambda: sigma", "'lambda: sigma' is not arithmetic"),
    ("(lambda x: x)(sigma)", "is not arithmetic"),
    ("'sigma'", "is not arithmetic"),
    ("f'{sigma}'", "is not arithmetic"),
    ("sigma > 0", "'sigma > 0' is not arithmetic"),
    ("sigma if sigma else 0", "is not arithmetic"),
    ("sigma and 1", "is not arithmetic"),
    ("not sigma", "is not arithmetic"),
    ("~sigma", "is not arithmetic"),
    ("[sigma for sigma in (1,)]", "is not arithmetic"),
    ("{sigma}", "is not arithmetic"),
    ("(sigma := 3)", "is not arithmetic"),
    ("sigma, sigma", "is not arithmetic"),
    ("await sigma", "is not"),
    ("True*sigma", "'True' is not arithmetic"),
    ("1j*sigma", "'1j' is not arithmetic"),
    ("sigma // 2", "is not arithmetic"),
    ("sigma % 2", "is not arithmetic"),
    ("sigma @ sigma", "is not arithmetic"),
    ("sigma^2", "accepted: ** for powers"),
    ("eval(sigma)", "unknown function 'eval'"),
    ("sinn(sigma)", "did you mean 'sin'?"),
    ("exp", "the function exp has no argument"),
    ("exp()", "exp of 0 arguments"),
    ("max(sigma)", "max of 1 arguments; accepted: max of two arguments"),
    ("exp(*sigma)", "is not arithmetic"),
    ("exp(x=sigma)", "is not arithmetic"),
    ("sigma; import os", "is no formula"),
    ("import os", "is no formula"),
    ("sigma = 3", "is no formula"),
    ("", "empty"),
    ("  ", "empty"),
    ("\0", "accepted"),
    ("sigma +", "is no formula"),
    ("(" * 10_000 + "sigma" + ")" * 10_000, "characters long"),
    ("abs(" * 70 + "-" * 40 + "sigma" + ")" * 70, "nested more than"),
    ("-" * 450 + "sigma", "nested more than"),
    ("--" * 100 + "sigma", "nested more than"),
    ("9" * 450, "is not finite"),
    ("1e999", "is not finite"),
]


def test_what_is_no_arithmetic_is_refused_by_name() -> None:
    for text, says in HOSTILE:
        before = time.perf_counter()
        with pytest.raises(PydanticCustomError) as caught:
            parse_formula(text)
        assert says in str(caught.value)
        assert len(str(caught.value)) < 400
        assert time.perf_counter() - before < 1
        if text.strip():
            (fault,) = faults_of(own(text))
            assert fault.path == "material.flow"
            assert says in str(fault)


@given(st.text(alphabet="sigma0123456789.+-*/()[]{}'\"^ ,=:<>\\\n_jex", max_size=30))
@settings(max_examples=300, deadline=None)
def test_no_text_escapes_as_another_exception(text: str) -> None:
    faults_of(own(text, {"s0": "1 kPa"}))


def test_a_tower_of_powers_does_not_hang() -> None:
    before = time.perf_counter()
    faults_of(own("9**9**9**9*sigma/s0", {"s0": "1 Pa*s"}))
    for unit in ("m^9^9^9^9", "9^9^9 m", "(9)^(9)^(9) m", "m**9**9**9"):
        (fault,) = faults_of(spoiled({"filament.span": f"1 {unit}"}))
        assert "unknown unit" in fault.found
    assert time.perf_counter() - before < 2


SOUND: list[tuple[str, dict[str, Any], float]] = [
    ("sinh(sigma/s0)/t0", SINH, 0.0),
    ("sigma/eta", {"eta": "3 kPa*s"}, 0.0),
    ("sign(sigma)*(abs(sigma)/K)**(1/n)", {"K": "120 Pa*s^0.4", "n": 0.4}, 0.0),
    ("sigma*abs(sigma)**1.5/K**2.5", {"K": "120 Pa*s^0.4"}, 0.0),
    ("sign(sigma)*max(abs(sigma) - sY, 0)/eta", {"sY": "9.32 kPa", "eta": "3 kPa*s"}, 9320.0),
    ("sign(sigma)*(max(abs(sigma) - sY, 0)/K)**(1/n)", {"sY": "37 Pa", "K": "3 Pa*s^0.3", "n": 0.3}, 37.0),
    ("(max(sigma - sY, 0) + min(sigma + sY, 0))/eta", {"sY": "1 mPa", "eta": "1 Pa*s"}, 1e-3),
    ("sqrt(sigma**2/s0**2)*sigma/s0/t0", SINH, 0.0),
    ("sign(sigma)*sqrt(abs(sigma))/c", {"c": "2 Pa^0.5*s"}, 0.0),
    ("(sigma/s0)**61/t0", SINH, 0.0),
    ("(1/(1 + exp(-sigma/s0)) - 0.5)/t0", SINH, 0.0),
]


def test_a_sound_rule_is_taken_and_its_threshold_found() -> None:
    for flow, parameters, yields_at in SOUND:
        scene = Scene.model_validate(own(flow, parameters))
        assert Scene.model_validate(tomllib.loads(scene.to_toml())) == scene
        material = scene.material
        assert material.threshold == pytest.approx(yields_at, rel=1e-12, abs=1e-300)
        values = material.values()
        assert set(values) == {"youngs_modulus", *parameters} | ({"yield_stress"} if yields_at else set())
        assert material.formula is not None
        if yields_at:
            assert material.formula.value(material.threshold, values) == 0
            assert material.formula.value(material.threshold * (1 + 1e-9), values) > 0


UNSOUND: list[tuple[str, dict[str, Any], list[tuple[str, str]]]] = [
    ("sinh(sigma)/t0", {"t0": "1 s"}, [("flow", "the argument 'sigma' of sinh is of unit Pa")]),
    ("sinh(sigma/s0)", {"s0": "1 kPa"}, [("flow", "is a pure number; accepted: a strain rate, 1/s")]),
    ("sigma/s0", {"s0": "1 kPa*s^2"}, [("flow", "of unit s^-2")]),
    ("sigma/s0 + 1/t0*sigma", {"s0": "1 Pa*s", "t0": "1 s"}, [("flow", "puts 'sigma/s0', of unit 1/s, beside")]),
    ("max(sigma, 1)/s0", {"s0": "1 Pa*s"}, [("flow", "puts 'sigma', of unit Pa, beside '1', a pure number")]),
    ("2**sigma/t0", {"t0": "1 s"}, [("flow", "the exponent 'sigma' is of unit Pa")]),
    ("abs(sigma)**(sigma/s0)/t0", SINH, [("flow", "the exponent depends on sigma")]),
    ("sinh(sigma/s0)/t0", {"s0": 1000.0, "t0": "1 s"}, [("flow", "'sigma/s0' of sinh is of unit Pa")]),
    ("sinh(sigma/s1)/t0", SINH, [("flow", "unknown symbol 's1'"), ("parameters.s0", "not used by material.flow")]),
    ("sinh(sigma/a)/b", {}, [("flow", "unknown symbol 'a'"), ("flow", "unknown symbol 'b'")]),
    ("1/t0", {"t0": "1 s"}, [("flow", "the rate without stress is 1 1/s")]),
    ("(sigma/s0)**2/t0", SINH, [("flow", "not odd: ")]),
    ("sign(sigma)*sqrt(sigma/s0)/t0", SINH, [("flow", "not odd: ")]),
    ("log(sigma/s0)/t0", SINH, [("flow", "the rate without stress is nan")]),
    ("sin(sigma/s0)/t0", SINH, [("flow", "decreases from ")]),
    ("(sigma - sigma**3/s0**2)/s0/t0", SINH, [("flow", "decreases from ")]),
    ("-sigma/eta", {"eta": "1 Pa*s"}, [("flow", "negative dissipation: the rate is")]),
    ("sigma/eta", {"eta": "-1 Pa*s"}, [("flow", "negative dissipation: the rate is")]),
    ("s0/sigma/t0", SINH, [("flow", "the rate without stress is")]),
    ("0*sigma", {}, [("flow", "nothing flows at any stress")]),
    ("sigma/eta", {"eta": "0 Pa*s"}, [("flow", "at sigma =")]),
    ("log(1 - sigma/s0)/t0 - log(1 + sigma/s0)/t0", SINH, [("flow", "")]),
]


def test_an_unsound_rule_is_refused() -> None:
    for flow, parameters, expected in UNSOUND:
        faults = faults_of(own(flow, parameters))
        assert [fault.path for fault in faults] == [f"material.{path}" for path, _ in expected]
        for fault, (_, says) in zip(faults, expected, strict=True):
            assert says in str(fault)


def test_a_bad_parameter_is_one_fault() -> None:
    for name, value, says in [
        ("s0", "1 kPaa", "unknown unit 'kPaa'"),
        ("s0", "1", "has no unit"),
        ("s0", "5 K", "'K' is of dimension [temperature]"),
        ("s0", math.nan, "is not finite"),
        ("s0", 10**400, "is not finite"),
        ("s0", True, "is not a quantity"),
        ("s0", [1], "is not a quantity"),
        *[(name, "1 kPa", "already means something") for name in ("span", "pi", "sigma", "index", "time_scale")],
        *[(name, "1 kPa", "already means something") for name in FUNCTIONS],
        *[(name, "1 kPa", "is no name") for name in ("", "1a", "a b", "a.b", "lambda", "σ0")],
    ]:
        (fault,) = faults_of(own("sinh(sigma/s0)/t0", {name: value}))
        assert fault.path == f"material.parameters.{name}"
        assert says in str(fault)


def test_a_custom_law_needs_its_rule_and_others_refuse_it() -> None:
    material = {"law": "custom", "youngs_modulus": "4 MPa"}
    (fault,) = faults_of(spoiled({"material": material}))
    assert (fault.path, fault.found) == ("material.flow", "missing: the law 'custom' needs it")
    given_for_nothing = {"material.flow": "sigma/eta", "material.parameters": {"eta": "1 Pa*s"}}
    paths = [fault.path for fault in faults_of(spoiled(given_for_nothing, BINGHAM))]
    assert paths == list(given_for_nothing)
