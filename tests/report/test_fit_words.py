"""A fit in words: digits that the error allows, no number for what is not known, and a document that JSON takes."""

from __future__ import annotations

import io
import json
import math
from dataclasses import replace
from html import escape

import numpy as np
import pytest
from rich.console import Console

import softcat_sym as sc
from softcat_sym.fitting.fit import FitOutcome, FittedParameter
from softcat_sym.fitting.identifiability import Statistic
from softcat_sym.fitting.least_squares import Fall, Waterfall
from softcat_sym.plotting.fit import fit_page, fitted_toml, print_fit
from softcat_sym.plotting.fit_words import (
    display_unit,
    fit_document,
    fit_json,
    parameter_texts,
    rounded,
    warnings,
    with_error,
)
from tests.inverse.filmed import film, scene


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (13851.77, 243.4, "13850 ± 240"),
        (1957.417, 18.6, "1957 ± 19"),
        (1957.417, 0.996, "1957.4 ± 1.0"),
        (0.43012, 0.0023, "0.4301 ± 0.0023"),
        (-0.0001, 0.0012, "−0.0001 ± 0.0012"),
        (3.222e-5, 3.4e-7, "3.222e-5 ± 3.4e-7"),
        (5.0, 80.0, "5 ± 80"),
    ],
)
def test_as_many_digits_as_the_error_has_meaning(value: float, error: float, text: str) -> None:
    assert with_error(value, error) == text


def test_without_an_error_three_digits() -> None:
    assert rounded(1957.417, None) == rounded(1957.417, math.nan) == rounded(1957.417, 0.0) == "1957"


def test_units_have_prefixes_where_they_are_known() -> None:
    assert display_unit("Pa*s", 13.8e3).symbol == "kPa·s"
    assert display_unit("Pa", 1.6e8).text(1.6e8) == "160 MPa"
    assert display_unit("kg/m^3", 1900).symbol == "kg/m^3"
    assert display_unit("s", 5e-3).symbol == "ms"
    assert display_unit("m", 0.0).symbol == "nm"


KNOWN = FittedParameter(
    "viscosity", "Pa*s", 13.85e3, 13.85e3, 243.0, (13.4e3, 14.3e3), "identified", "", 13e3, (1, 1e6)
)


@pytest.mark.parametrize(
    ("changes", "value", "interval"),
    [
        ({}, "13.85 ± 0.24", "13.40 to 14.30"),
        ({"verdict": "one-sided", "value": None, "std": None, "ci95": (None, 14.3e3)}, "–", "< 14.3"),
        ({"verdict": "one-sided", "value": None, "std": None, "ci95": (13.4e3, None)}, "–", "> 13.4"),
        ({"verdict": "not identified", "value": None, "std": None, "ci95": (None, None)}, "–", "–"),
        ({"verdict": "not identified", "value": None, "std": None, "ci95": (1e3, 2e6)}, "–", "1.00 to 2000"),
        ({"verdict": "at a bound", "std": None, "ci95": (13.4e3, None)}, "13.8 (bound)", "> 13.4"),
    ],
)
def test_no_number_stands_for_what_is_not_known(changes: dict[str, object], value: str, interval: str) -> None:
    one = replace(KNOWN, **changes)  # type: ignore[arg-type]
    assert parameter_texts(one) == ("viscosity [kPa·s]", value, interval, one.verdict, "13.0")


@pytest.fixture(scope="module")
def fitted() -> sc.Fit:
    time, height = film()
    # Out of order, and one frame is missing: both are corrected, and said.
    height = np.where(np.arange(time.size) == 7, np.nan, height)
    return sc.fit(sc.Measurements.of(time[::-1], height[::-1]), scene(), ["viscosity"], starts=0)


def unknown(fit: sc.Fit) -> sc.Fit:
    """The same fit, had it told nothing."""
    lost = {"value": None, "std": None, "ci95": (None, None), "verdict": "not identified", "reason": "<no & why>"}
    return replace(
        fit,
        parameters={"viscosity": replace(fit.parameters["viscosity"], **lost)},  # type: ignore[arg-type]
        outcome=FitOutcome.not_identified,
        correlation=np.array([[math.nan]]),
        combinations=("viscosity^1 * density^-1 = 7.3 (7 to 7.6), SI",),
        noise=math.inf,
        repeats=("the fitted values call for <shear>",),
    )


def test_the_document_has_what_the_contract_says_and_no_nan(fitted: sc.Fit) -> None:
    for fit in (fitted, unknown(fitted)):
        found = json.loads(fit_json(fit), parse_constant=lambda name: pytest.fail(name))
        assert {"parameters", "correlation", "features", "outcome", "starts", "advice"} <= set(found)
        assert set(found["parameters"]["viscosity"]) >= {"value", "std", "ci95", "verdict", "unit", "best", "bounds"}
        assert len(found["notes"]) == 2 and len(found["features"]) == 1
    assert found["correlation"] == [[None]] and found["noise_m"] is None
    assert found["parameters"]["viscosity"]["value"] is None and found["parameters"]["viscosity"]["best"] > 0
    assert fit_document(fitted)["features"][0]["prefactor"]["value"] == pytest.approx(0.007, rel=0.1)


def test_terminal_page_and_scene_say_what_is_not_known(fitted: sc.Fit) -> None:
    fit = unknown(fitted)
    screen = Console(file=io.StringIO(), width=80, color_system=None)
    print_fit(fit, screen)
    printed = " ".join(screen.file.getvalue().split())  # type: ignore[attr-defined]
    page = fit_page(fit, {}, "softcat fit 'a <b>.csv'").decode()
    assert "<no & why>" in printed and "&lt;no &amp; why&gt;" in page and "<no" not in page and "<shear" not in page
    assert "&#39;a &lt;b&gt;.csv&#39;" in page and " doubtful" in page
    for words in fit.combinations + fit.repeats + fit.notes:
        assert words in printed and escape(words) in page
    assert "…" not in printed
    # Neither says where the optimum lies.
    assert f"{fit.parameters['viscosity'].best:.4g}"[:4] not in printed
    toml = fitted_toml(fit).decode()
    assert "# viscosity: not identified; <no & why>" in toml
    assert toml.splitlines()[0] == "# Fitted: not identified."


def test_what_a_reader_has_to_know_first_is_a_warning(fitted: sc.Fit) -> None:
    assert warnings(fitted) == []
    large = replace(fitted, checks=replace(fitted.checks, size=Statistic("chi-square", 700.0, 1e-9)))
    assert "larger than the stated errors (chi-square 700 for 59 readings, p < 1e-6)" in warnings(large)[0]
    best = fitted.starts.falls[0]
    lonely = Waterfall((best, Fall(best.start, best.optimum, 1), Fall(best.start, best.optimum, 2)), 0)
    assert "only one start" in warnings(replace(fitted, starts=lonely))[0]
    doubtful = replace(fitted.profiles[0], unconverged=2, better=best.start)
    assert len(warnings(replace(fitted, profiles=(doubtful,)))) == 2
