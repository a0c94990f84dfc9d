"""Structure at length: the flow curve, rest before release, limits of fast and slow build-up.

``test_rheojax.py`` has the laws at a point against RheoJAX.
"""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from tests.common.table import show
from tests.test_structure import BINGHAM, EFFECTS, RATE, L, bar, stress_and_structure

pytestmark = pytest.mark.slow


def test_flow_curve() -> None:
    """Steady stresses of long bars lie on sigma_Y(1/(1 + b)) + eta rate."""
    rows = []
    for breakdown in (1.0, 10.0, 100.0):
        scene = bar({"build_up_time": "0.05 s", "breakdown_time": f"{breakdown} s"})
        run = sc.simulate(scene)
        speed = float(run.data.plastic_rate.values[-1, 0])
        exact = 300 + 600 / (1 + breakdown * speed) + 5e4 * speed
        rows.append((breakdown, speed, float(run.data.stress_mean.values[-1, 0]), exact))
    show("steady stress [Pa]", ("tau_b [s]", "rate [1/s]", "run", "exact"), rows)
    assert all(abs(row[2] / row[3] - 1) < 2e-3 for row in rows)


def test_a_strand_that_rests_before_it_is_let_go() -> None:
    """The slower the build-up against the run, the closer its sag is to that of the yield stress after the rest."""
    strand = {
        "filament": {"span": "45 mm", "thickness": "15 mm", "width": "15 mm", "density": "2100 kg/m^3"},
        "run": {"duration": "2 s", "frames": 11, "effects": EFFECTS},
        "numerics": {"estimate": False, "cells": 12, "grading": 4, "fibres": 24},
    }
    rows, errors = [], []
    for slow in (10.0, 100.0, 1000.0):
        for share in (0.0, 0.2, 0.5):
            rested = 300 + 600 * (1 - math.exp(-share))
            table = {
                "build_up_time": f"{2 * slow} s",
                "structured_yield_stress": "900 Pa",
                "rest": f"{2 * slow * share} s",
            }
            material = {**BINGHAM, "youngs_modulus": 2e5}
            built = sc.simulate({**strand, "material": {**material, "structure": table}})
            plain = sc.Scene.from_dict({**strand, "material": {**material, "yield_stress": rested}})
            law = sc.simulate(plain.replace({"run.effects": EFFECTS[:-1]}))
            sags = [-1e3 * run.summary["midpoint_final_m"] for run in (built, law)]
            rows.append((slow, share, rested, *sags, sags[0] / sags[1] - 1))
            errors.append(abs(rows[-1][-1]))
    show(
        "sag after a rest [mm]",
        ("t_b/duration", "rest/t_b", "yield stress then [Pa]", "with structure", "with that yield stress", "apart"),
        [[f"{one:.4g}" for one in row] for row in rows],
    )
    assert max(errors[6:]) < 4e-3 and max(errors[6:]) < max(errors[3:6]) < max(errors[:3])


def test_limits_of_fast_and_slow_build_up() -> None:
    """First order in t_b to a structure in equilibrium with the flow, and in 1/t_b to one that stays."""
    rows = []
    for build_up in (0.4, 0.2, 0.1):
        scene = bar({"build_up_time": f"{build_up} s", "breakdown_time": "30 s"})
        run = sc.simulate(scene)
        speed = RATE / (L + RATE * 10)

        def rest(flow: float, speed: float = speed) -> float:
            # The stress in equilibrium with the flow changes as the bar grows longer; its rate is that of the strain.
            def stress(at: float) -> float:
                return 300 + 600 / (1 + 30 * at) + 5e4 * at

            change = (stress(flow * (1 + 1e-6)) - stress(flow)) / (flow * 1e-6) * -(flow**2)
            return 1e5 * (speed - flow) - change

        flow = brentq(rest, 0.5 * speed, 2 * speed)
        exact = 300 + 600 / (1 + 30 * flow) + 5e4 * flow
        rows.append(("t_b to 0", build_up, float(run.data.stress_mean.values[-1, 0] / exact - 1)))
    plain = sc.simulate(bar().replace({"material.structure": None, "run.effects": EFFECTS[:-1]}))
    for build_up in (1e3, 2e3, 4e3):
        run = sc.simulate(bar({"build_up_time": f"{build_up} s"}))
        apart = run.data.stress_mean.values[-1, 0] / plain.data.stress_mean.values[-1, 0] - 1
        rows.append(("t_b to infinity", build_up, float(apart)))
    orders = [math.log2(abs(a[2] / b[2])) for a, b in pairwise(rows)]
    shown = [(*row, "" if k % 3 == 0 else f"{orders[k - 1]:.3f}") for k, row in enumerate(rows)]
    show("limits of build-up", ("limit", "t_b [s]", "stress apart", "order"), shown)
    assert all(abs(orders[k] - 1) < 0.25 for k in (0, 1, 3, 4)), orders
    structure = bar().material.structure
    assert structure is not None
    assert np.all(np.diff(stress_and_structure(structure, np.linspace(0, 1, 3))[1]) > 0)
