"""Limits of a filament with a temperature: no exchange of heat, immediate exchange, slow heating; each at its order."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.table import show
from tests.common.warm_bars import CAPACITY, DIAMETER, FLOWING, RHO, bar, run

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore:the section is assumed to have one temperature")]

LAW = {"initial": 370.0, "law": "arrhenius", "activation_energy": 40e3, "reference": 340.0}
PULLED: dict[str, Any] = {"initial": {"stretch": 1.05, "relaxed": False}, "duration": 1.0}


def _stress(scene: sc.Scene) -> float:
    """Stress of the bar at the end."""
    return float(run(scene).fields["stress_mean"][-1, 3])


def _orders(errors: list[float], factor: float) -> list[float]:
    return [float(np.log(a / b) / np.log(factor)) for a, b in pairwise(errors)]


def test_no_exchange_and_immediate_exchange() -> None:
    """h to 0: the adiabatic bar, by h; h to infinity: the bar without a temperature, at that around, by 1/h."""
    adiabatic = _stress(bar(LAW, *FLOWING, **PULLED))
    plain = _stress(bar(LAW, *(one for one in FLOWING if one != "temperature"), **PULLED))
    rows, orders = [], {}
    for limit, known, coefficients in (
        ("h to 0: adiabatic", adiabatic, (4.0, 1.0, 0.25)),
        ("h to infinity: without temperature", plain, (3e4, 1.2e5, 4.8e5)),
    ):
        errors = []
        for h in coefficients:
            heat = {**LAW, "ambient": 340.0, "heat_transfer": h}
            errors.append(abs(_stress(bar(heat, *FLOWING, **PULLED)) / known - 1))
        orders[limit] = _orders(errors, 4)
        rows += [(limit, h, f"{error:.3e}") for h, error in zip(coefficients, errors, strict=True)]
        rows.append((limit, "order", ", ".join(f"{one:.3f}" for one in orders[limit])))
    show("Stress of a warm bar that relaxes, from that of the limit", ("", "h [W/(m^2 K)]", "relative"), rows)
    for found in orders.values():
        assert found == pytest.approx([1, 1], abs=0.05)


def test_slow_heating_is_followed() -> None:
    """A bar lags behind a furnace that warms at b by b tau, tau = rho c_p d/(4 h), and so does its stress."""
    h = 400.0
    tau, rows, errors = RHO * CAPACITY * DIAMETER / (4 * h), [], []
    for duration in (20.0, 80.0, 320.0):
        furnace = {"0 s": "340 K", f"{duration} s": "370 K"}
        heat = {"initial": 340.0, "ambient": furnace, "heat_transfer": h}
        found = run(bar(heat, duration=duration)).fields
        lag, rate = 370 - float(found["temperature"][-1, 3]), 30 / duration
        errors.append(lag)
        rows.append((f"{rate:.3f}", f"{lag:.5f}", f"{rate * tau:.5f}"))
        assert lag == pytest.approx(rate * tau, rel=1e-4)
    show("Lag behind a furnace that warms", ("b [K/s]", "lag [K]", "b tau [K]"), rows)
    assert _orders(errors, 4) == pytest.approx([1, 1], abs=1e-3)
