"""Threads and bars of polymer solution: thinning by Entov & Hinch, bounded viscosity."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.polymers import (
    OWN,
    SOLVENT,
    STRING,
    Floats,
    G,
    bar,
    drawn_by_pieces,
    stress_of,
)
from tests.common.table import show
from tests.test_conformation import integrated

pytestmark = pytest.mark.slow

RADIUS, SURFACE, MEMORY = 0.5e-3, 0.03, 0.1
"""Of the thread: half the thickness in its middle [m], surface tension [N/m], relaxation time [s]."""


def thread(elasticity: float, solvent: float, duration: float, **changes: Any) -> sc.Run:
    """A thread between two drops on plates held apart, next to massless, that its surface drains."""
    at = np.linspace(-1, 1, 41)
    scene = {
        "filament": {"span": 0.005, "thickness": 2 * RADIUS, "section": "circle", "density": 1.0}
        | {"profile": [float(one) for one in 1 + 0.1 * at**2 + 2 * at**4]},
        "material": {"law": "oldroyd-b", "youngs_modulus": 3 * elasticity * SURFACE / RADIUS}
        | {"relaxation_time": MEMORY, "solvent_viscosity": 3 * solvent},
        "ends": {"left": "pinned", "right": "pinned"},
        "load": {"gravity": 0.0},
        "surroundings": {"surface_tension": SURFACE},
        "run": {"duration": duration * MEMORY, "frames": 401}
        | {"effects": [*STRING, "viscous-flow", "viscous-stress", "surface-tension"]},
        "numerics": {"cells": 400, "grading": 1e-4, "rtol": 1e-6, "estimate": False, "backend": "compiled"},
    }
    return sc.simulate(sc.Scene.from_dict(scene).replace(changes))


def slopes(run: sc.Run, at: Floats) -> tuple[Floats, Floats]:
    """Stretch of the middle, and -3 lambda d log R/dt, at some times in relaxation times."""
    middle = np.argmin(np.abs(run.data.X_cell.values))
    s, time = run.data.stretch.values[:, middle], run.data.time.values / MEMORY
    fall = 1.5 * np.gradient(np.log(s), time)
    return np.interp(at, time, s), np.interp(at, time, fall)


def test_a_thread_thins_as_entov_and_hinch_say() -> None:
    """R ~ exp(-t/(3 lambda)) in the limit of a thread that is thin beside its drops: what is left goes as R itself."""
    rows = []
    for elasticity, solvent, end, cells in ((0.1, 0.1, 6.6, 400), (0.01, 0.05, 4.4, 600)):
        run = thread(elasticity, solvent, end, **{"numerics.cells": cells})
        late = np.linspace(end - 1.2, end - 0.1, 12)
        s, fall = slopes(run, late)
        relative = s**-0.5
        # A line in R over the last part, carried on to R = 0.
        limit = float(np.polyval(np.polyfit(relative, fall, 1), 0.0))
        rows.append((elasticity, 3 * solvent, end, relative[-1], fall[-1], limit, run.summary["energy_residual"]))
    words = ("G R0/gamma", "eta_s [Pa s]", "t/lambda", "R/R0", "-3 lambda d log R/dt", "carried to R = 0", "energy")
    show("A thread of Oldroyd-B between two drops", words, [[f"{one:.4g}" for one in row] for row in rows])
    for row in rows:
        assert row[4] == pytest.approx(1, abs=0.0105), "at the end of the run"
        assert row[5] == pytest.approx(1, abs=0.01), "in the limit"
        # The audit closes to the tolerance of the run, 1e-6, of which each of thousands of steps may use its part.
        assert row[6] < 5e-6
    assert min(row[4] for row in rows) < 1.01


def closed_viscosity(wi: float, limit: float) -> float:
    """Steady tensile viscosity of FENE-P over that at rest, 3 G lambda: its f is the largest root of a cubic.

    A_zz = 1/(f - 2 Wi), A_rr = 1/(f + Wi) and f (L^2 - A_zz - 2 A_rr) = L^2 - 3.
    """
    f = np.polynomial.Polynomial([0, 1])
    along, across = f - 2 * wi, f + wi
    cubic = f * (limit * along * across - across - 2 * along) - (limit - 3) * along * across
    root = max(one.real for one in cubic.roots() if abs(one.imag) < 1e-9)
    return float(root * (1 / (root - 2 * wi) - 1 / (root + wi)) / (3 * wi))


def fast_bar(wi: float) -> tuple[float, float]:
    """Tensile viscosity of the chains over 3 G lambda at the end of a bar drawn 90 times as long: run, whole tensor."""
    run = sc.simulate(bar("fene-p", lambda t: np.exp(wi * t), 4.5 / wi, 60, **{"numerics.backend": "compiled"}))
    (before, short, _), (after, long, _) = run.scene.ends.motion[-2:]
    rate = (long - short) / (after - before) / float(run.data.stretch[-1, 0])
    last = float((run.data.tension * run.data.stretch).values[-1, 0]) / (np.pi / 4 * 0.05**2)
    whole = stress_of("fene-p", drawn_by_pieces("fene-p", run)[-1])
    return (last - SOLVENT * rate) / (3 * G * rate), whole / (3 * G * rate)


def test_fene_p_has_a_bounded_viscosity() -> None:
    """Where Oldroyd-B has none any more it tends to (2/3) L^2: 2 G lambda L^2 over 3 G lambda."""
    rows, limit = [], OWN["fene-p"]["finite_extensibility"]
    for wi in (0.1, 0.4, 0.6, 2.0, 20.0, 200.0):
        # Until exp(-|1 - 2 Wi| t/lambda) is gone.
        along, across = integrated("fene-p", wi, np.array([30.0 / abs(1 - 2 * wi)]))[0]
        stress = stress_of("fene-p", np.diag([along, across, across]))
        in_run, whole = fast_bar(wi) if 1 < wi < 100 else (float("nan"), float("nan"))
        rows.append((wi, stress / (3 * G * wi), closed_viscosity(wi, limit), in_run, whole))
    show(
        "FENE-P, L^2 = 60: steady tensile viscosity over 3 G lambda",
        ("lambda rate", "point", "closed form", "bar", "tensor along its pieces"),
        [[f"{one:.6g}" for one in row] for row in rows],
    )
    for _, found, exact, in_run, whole in rows:
        assert found == pytest.approx(exact, rel=1e-6)
        if not np.isnan(in_run):
            assert in_run == pytest.approx(whole, rel=1e-4)
            # At the end of a straight piece the rate is half of 4.5/60 below its mean, which the chains have seen.
            assert in_run == pytest.approx(exact, rel=0.04)
    assert rows[-1][1] == pytest.approx(2 / 3 * limit, rel=0.02)
