"""Backstress at length: RheoJAX's MIKH, energy of sections that shear, orders of its limits.

RheoJAX asks for Python 3.12; its kernels run on 3.11 with jax, where ``import rheojax`` finds them.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import softcat_sym as sc
from tests.common.table import show
from tests.test_backstress import EFFECTS, PLAIN, bar, strand
from tests.test_structure import RATE, STRUCTURE, L

pytestmark = pytest.mark.slow

Floats = np.ndarray[Any, np.dtype[np.float64]]


def test_a_bar_is_the_mikh_law_of_rheojax() -> None:
    """Start-up and steady flow against its kernel in shear: C/3 and q/sqrt 3 there, with structure and without."""
    kernels = pytest.importorskip("rheojax.models.ikh._kernels", exc_type=ImportError)
    rows, root = [], math.sqrt(3)
    for modulus, recovery, structured in ((2e3, 5.0, True), (2e4, 100.0, True), (2e3, 0.0, False), (2e4, 400.0, False)):
        changes: dict[str, Any] = {
            "material.hardening_modulus": f"{modulus} Pa",
            "material.hardening_recovery": recovery,
        }
        if structured:
            changes |= {"material.structure": STRUCTURE, "run.effects": [*EFFECTS, "structure"]}
        run = sc.simulate(bar(**changes))
        given = {"G": 1e5 / 3, "C": modulus / 3, "gamma_dyn": recovery / root, "m": 1.0, "eta": 1e30, "mu_p": 5e4 / 3}
        given |= {"sigma_y0": 300 / root, "delta_sigma_y": 600 / root if structured else 0.0, "k3": 0.0}
        given |= {"tau_thix": 4.0, "Gamma": 30.0 / root / 4.0}

        def rates(t: float, state: Floats, given: dict[str, float] = given) -> Floats:
            shear = root * RATE / (L + RATE * t)
            return np.asarray(kernels.ikh_maxwell_ode_rhs(t, state, {**given, "gamma_dot": shear}), dtype=float)

        times = run.data.time.values
        found = solve_ivp(rates, (0, times[-1]), np.zeros(3), t_eval=times, rtol=1e-8, atol=1e-8, max_step=0.05)
        own = run.data.stress_mean.values[:, 0], run.data.backstress.values[:, 0]
        theirs = root * found.y[0], root * found.y[1]
        apart = [np.max(np.abs(a - b)) / np.max(a) for a, b in zip(own, theirs, strict=True)]
        ends = [value for pair in zip(own, theirs, strict=True) for value in (pair[0][-1], pair[1][-1])]
        rows.append((modulus, recovery, structured, *ends, *apart))
    show(
        "start-up of a bar, RheoJAX's MIKH",
        ("C [Pa]", "q", "structure", "stress [Pa]", "RheoJAX", "backstress", "RheoJAX", "stress apart", "back apart"),
        [[f"{one:.6g}" for one in row] for row in rows],
    )
    assert all(max(row[-2:]) < 1e-4 for row in rows)


def test_energy_of_sections_that_shear() -> None:
    """Interpreter and C, of strands whose sections shear or not, and of sheets, which may not change their width."""
    rows = []
    for section in ("rectangle", "sheet"):
        for more in ((), ("shear",), ("shear", "inertia")):
            scene = strand(section, *more)
            runs = [sc.simulate(scene.replace({"numerics.backend": b})) for b in ("interpreted", "compiled")]
            sag = abs(runs[1].summary["midpoint_final_m"])
            apart = float(np.max(np.abs(runs[0].data.y.values - runs[1].data.y.values))) / sag
            residuals = [float(run.summary["energy_residual"]) for run in runs]
            rows.append((section, "+".join(more), float(runs[1].data.backstress.max()), *residuals, apart))
    columns = ("section", "besides", "backstress [Pa]", "residual", "residual in C", "backends apart")
    show("energy with a backstress", columns, rows)
    assert all(row[2] > 1 and max(row[3:5]) < 1e-6 and row[5] < 1e-5 for row in rows)


def test_limits_of_the_modulus_and_of_recovery() -> None:
    """C to 0 and q to infinity meet the law without it, q to 0 Prager's: each of first order."""
    rows: list[tuple[str, float, float]] = []

    def last(effects: list[str] = EFFECTS, **numbers: Any) -> float:
        scene = bar(**{f"material.{key}": value for key, value in numbers.items()}, **{"run.effects": effects})
        return float(sc.simulate(scene).data.stress_mean.values[-1, 0])

    plain, prager = last(PLAIN, hardening_modulus=None, hardening_recovery=0), last(hardening_recovery=0)
    rows += [("C to 0", C, last(hardening_modulus=f"{C} Pa") - plain) for C in (40.0, 20.0, 10.0)]
    rows += [("q to infinity", 1 / q, last(hardening_recovery=q) - plain) for q in (500.0, 1000.0, 2000.0)]
    rows += [("q to 0", q, last(hardening_recovery=q) - prager) for q in (0.04, 0.02, 0.01)]
    orders = [math.log2(abs(a[2] / b[2])) for a, b in pairwise(rows)]
    shown = [(*row, "" if k % 3 == 0 else f"{orders[k - 1]:.3f}") for k, row in enumerate(rows)]
    show("limits of the backstress", ("limit", "C, 1/q or q", "stress apart [Pa]", "order"), shown)
    assert all(abs(orders[k] - 1) < 0.05 for k in (0, 1, 3, 4, 6, 7)), orders
