"""Structure at length: flow curves and loops, rest before release, limits of fast and slow build-up.

``test_rheojax.py`` has the laws at a point against RheoJAX.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import cumulative_trapezoid, solve_ivp
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.physics import structure as st
from tests.common.table import show
from tests.test_structure import BINGHAM, EFFECTS, RATE, L, bar, stress_and_structure

pytestmark = pytest.mark.slow

Floats = np.ndarray[Any, np.dtype[np.float64]]

_build_up = sp.lambdify((st.lam, st.speed, st.t_b, st.tau_b, st.exponent), st.build_up_rate(linear=False))


def test_flow_curve_and_hysteresis_loop() -> None:
    """Steady stresses of long bars lie on sigma_Y(1/(1 + b)) + eta rate; a loop that takes its time closes."""
    rows = []
    for breakdown in (1.0, 10.0, 100.0):
        scene = bar({"build_up_time": "0.05 s", "breakdown_time": f"{breakdown} s"})
        run = sc.simulate(scene)
        speed = float(run.data.plastic_rate.values[-1, 0])
        exact = 300 + 600 / (1 + breakdown * speed) + 5e4 * speed
        rows.append((breakdown, speed, float(run.data.stress_mean.values[-1, 0]), exact))
    show("steady stress [Pa]", ("tau_b [s]", "rate [1/s]", "run", "exact"), rows)
    assert all(abs(row[2] / row[3] - 1) < 2e-3 for row in rows)
    loops = []
    for duration in (3.0, 30.0, 300.0, 3000.0):
        half = duration / 2

        def speed_at(t: Any, half: float = half) -> Any:
            return 2.0 * np.minimum(t, 2 * half - t) / half

        times = np.linspace(0, duration, 4001)
        found = solve_ivp(
            lambda t, lam, at=speed_at: _build_up(lam, at(t), 2.0, 3.0, 1.0), (0, duration), [1.0], t_eval=times,
            rtol=1e-9, atol=1e-12,
        )  # fmt: skip
        stress = 300 + 600 * found.y[0] + 100 * speed_at(times)
        loops.append((duration, float(abs(cumulative_trapezoid(stress, speed_at(times))[-1]))))
    show("area of a loop up and down in rate [Pa/s]", ("time for it [s]", "area"), loops)
    assert loops[-1][1] < 0.02 * max(area for _, area in loops)


def test_structure_stays_between_nothing_and_all_in_five_hundred_histories() -> None:
    """Rates at random over ten decades, at every point of time, from every start."""
    rng = np.random.default_rng(7)
    number, steps = 500, 8
    lam, low, high = rng.uniform(0, 1, number), 1.0, 0.0
    build, breakdown, power = (10 ** rng.uniform(-2, 2, number) for _ in range(3))
    power = np.clip(power, 0.2, 3.0)
    for _ in range(steps):
        speed = np.where(rng.uniform(size=number) < 0.3, 0.0, 10 ** rng.uniform(-6, 4, number))
        span = float(10 ** rng.uniform(-3, 2))

        def rates(_: float, lam: Floats, speed: Floats = speed) -> Floats:
            return np.asarray(_build_up(lam, speed, build, breakdown, power))

        found = solve_ivp(rates, (0, span), lam, "LSODA", rtol=1e-8, atol=1e-12)
        lam = found.y[:, -1]
        low, high = min(low, float(found.y.min())), max(high, float(found.y.max()))
    show("structure of 500 histories", ("smallest", "largest"), [(f"{low:.3g}", f"1 - {1 - high:.3g}")])
    assert low > -1e-8 and high < 1 + 1e-8


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
