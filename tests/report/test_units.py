"""Units that read well."""

from __future__ import annotations

import pytest

from softcat_sym.plotting.units import energy_unit, length_unit, nice_floor, significant, stress_unit, time_unit


@pytest.mark.parametrize(
    ("value", "symbol"),
    [(0.2, "mm"), (1.0, "m"), (0.999999999999, "m"), (-0.013, "mm"), (4.4e-5, "µm"), (3e-8, "nm"), (1e-15, "nm")],
)
def test_length(value, symbol):
    assert length_unit(value).symbol == symbol


def test_no_length_takes_the_unit_of_the_span():
    assert length_unit(0.0, fallback=0.2).symbol == "mm"


@pytest.mark.parametrize(
    ("value", "symbol"), [(2.0, "s"), (0.5, "ms"), (290, "s"), (300, "min"), (1e4, "min"), (2e4, "h"), (0.0, "s")]
)
def test_time(value, symbol):
    assert time_unit(value).symbol == symbol


@pytest.mark.parametrize(
    ("value", "text"), [(9.32e3, "9.32 kPa"), (4e6, "4.00 MPa"), (200.0, "200 Pa"), (-7e10, "\N{MINUS SIGN}70.0 GPa")]
)
def test_stress(value, text):
    assert stress_unit(value).text(value) == text


def test_energy_and_conversion():
    unit = energy_unit(2.5e-4)
    assert unit.symbol == "µJ"
    assert unit.of([2.5e-4, 0.0]) == pytest.approx([250.0, 0.0])


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (-0.0, "0"),
        (12.345, "12.3"),
        (99.96, "100"),
        (0.0666, "0.0666"),
        (-0.24409, "\N{MINUS SIGN}0.244"),
        (4.01e-5, "4.01e-05"),
        (1e12, "1.00e+12"),
        (float("inf"), "inf"),
    ],
)
def test_three_significant_digits(value, text):
    assert significant(value) == text


@pytest.mark.parametrize(("value", "floor"), [(10.6, 10), (2.0, 2), (0.02 / 0.01, 2), (4.99, 2), (0.07, 0.05)])
def test_nice_floor(value, floor):
    assert nice_floor(value) == pytest.approx(floor)
