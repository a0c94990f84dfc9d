"""Breaking against a program of its own: an elastic cable under a load that grows."""

from __future__ import annotations

import math

import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import softcat_sym as sc
from tests.common.table import show

pytestmark = pytest.mark.slow

L, H, RHO, E, RAMP = 0.2, 5e-5, 1000.0, 2e4, 10.0
AREA = math.pi * H**2 / 4


def ramped(time: float) -> float:
    """Gravity of a quintic smooth step."""
    share = time / RAMP
    return 9.81 * share**3 * (10 - 15 * share + 6 * share**2)


def stretch_of(tension: float) -> float:
    """Stretch of a bar of true strain that thins, T = A_0 E log(s)/s."""
    return float(brentq(lambda s: AREA * E * math.log(s) / s - tension, 1.0, math.e))


def support_stress(gravity: float) -> float:
    """True stress at the supports of an elastic cable of rest length L between supports L apart."""

    def span(pull: float) -> float:
        def along(X: float) -> float:
            tension = math.hypot(pull, RHO * AREA * gravity * X)
            return stretch_of(tension) * pull / tension

        return 2 * float(quad(along, 0, L / 2, epsabs=1e-13, epsrel=1e-12)[0])

    least = 1e-6 * RHO * AREA * gravity * L
    most = 0.9 * AREA * E / math.e
    pull = brentq(lambda H: span(H) - L, least, most, xtol=1e-16, rtol=1e-13)
    tension = math.hypot(pull, RHO * AREA * gravity * L / 2)
    return E * math.log(stretch_of(tension))


def test_an_elastic_cable_breaks_when_its_supports_pull_too_hard() -> None:
    """At a stress and at the strain that goes with it, by an integration of the exact cable."""
    rows = []
    for limit in (500.0, 1000.0, 1300.0):
        exact = brentq(lambda time, limit=limit: support_stress(ramped(time)) - limit, 0.5, RAMP)
        for key, value in (("breaking_stress", f"{limit} Pa"), ("breaking_strain", limit / E)):
            for cells in (20, 40):
                run = sc.simulate(
                    {
                        "filament": {"span": L, "diameter": H, "density": RHO},
                        "material": {"law": "elastic", "youngs_modulus": E, key: value},
                        "ends": {"left": "pinned", "right": "pinned"},
                        "load": {"ramp": f"{RAMP} s"},
                        "run": {
                            "duration": f"{RAMP} s",
                            "effects": [
                                "bending",
                                "extensibility",
                                "finite-stretch",
                                "thinning",
                                "large-rotation",
                                "gravity-ramp",
                            ],
                        },
                        "numerics": {"estimate": False, "cells": cells},
                    }
                )
                time = run.summary["broken"]["time_s"]
                rows.append((key, f"{limit:g} Pa", cells, f"{exact:.6f} s", f"{time:.6f} s", f"{time / exact - 1:.1e}"))
                assert abs(run.summary["broken"]["X_m"]) > 0.9 * L / 2
                assert time == pytest.approx(exact, rel=1e-3)
    show("an elastic cable under a load that grows", ("limit", "stress", "cells", "exact", "run", "error"), rows)
