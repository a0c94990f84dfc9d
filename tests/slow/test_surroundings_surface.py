"""Threads under their surface against closed forms: beads of a wave, drawing, free ends that are pulled in."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from tests.common.table import show
from tests.common.threads import evolve, newtonian, thread

pytestmark = pytest.mark.slow

COMPILED = {"backend": "compiled"}


def lasting(duration: float, frames: int) -> dict[str, float]:
    return {"duration": duration, "frames": frames}


def closed(done: sc.Run) -> str:
    """How well its energy is closed."""
    assert done.outcome.is_success, done.summary["message"]
    assert done.summary["energy_residual"] < 1e-5
    return f"{done.summary['energy_residual']:.0e}"


def slender(kR: float, oh: float) -> complex:
    lost = 3 * oh * kR**2
    return complex((-lost + np.sqrt(complex(lost**2 + 2 * kR**2 * (1 - kR**2)))) / 2)


def test_beads_of_half_a_wave() -> None:
    """From an amplitude of 1e-3 it grows as foretold; then beads, on ever finer grids, with its energy closed."""
    rows = []
    for oh in (0.1, 1.0):
        rate, ends = slender(0.5, oh).real, []
        for cells in (8, 16, 32):
            asked = thread(4 * np.pi, cells, newtonian(3 * oh), run=lasting(7 / rate, 29), numerics=COMPILED)
            done = evolve(asked, lambda X: 1 + 1e-3 * np.cos(2 * np.pi * X))
            wave = np.cos(2 * np.pi * done.data["X_cell"].values / asked.filament.span)
            grown = np.abs(done.data["stretch"].values @ wave)
            # From rest, a half of it decays at the other root.
            other = -rate - 3 * oh * 0.25
            t = done.data["time"].values[:9]
            expected = (rate * np.exp(other * t) - other * np.exp(rate * t)) / (rate - other)
            error = np.max(np.abs(grown[:9] / grown[0] / expected - 1))
            ends.append(float(done.data["stretch"].values[-1].max()))
            rows.append((oh, cells, f"{error:.1e}", f"{ends[-1]:.5f}", closed(done)))
            assert error < 0.2 / cells
        assert abs(ends[2] - ends[1]) < 0.5 * abs(ends[1] - ends[0])
        assert ends[2] > 1.8
    header = ("Oh", "cells", "error of the growth", "largest stretch at the end", "energy residual")
    show("A wave kR = 0.5 grows from 1e-3", header, rows)


def test_a_viscous_thread_between_plates() -> None:
    """Drawn at a constant speed: Q = A0 (eta s_t/s^2 + Gam s^-1/2)."""
    drawn = thread(20.0, 10, newtonian(0.5), inertia=False, run=lasting(3.0, 4), numerics=COMPILED)
    done = sc.simulate(drawn.replace({"ends.motion": [["0 s", "0 m", "0 m"], ["3 s", "60 m", "0 m"]]}))
    s = 1 + done.data["time"].values
    force = done.data["axial_force"].values.mean(axis=1) / np.pi
    expected = 0.5 / s**2 + s**-0.5
    row = [*(f"{one:.6f}" for one in force[1:]), closed(done)]
    show("Q/(Gam A0) of a viscous thread drawn between plates", ("1/3", "2/3", "1", "energy residual"), [row])
    np.testing.assert_allclose(force[1:-1], expected[1:-1], rtol=1e-5)


def test_a_free_end_runs_into_the_thread_at_kellers_speed() -> None:
    """v = sqrt(gamma/(rho R)), of a sheet sqrt(2 gamma/(rho h)); what it picks up is its pull times the time."""
    rows = []
    for section, mu, cells in (("circle", 0.3, 160), ("sheet", 0.3, 160)):
        asked = thread(
            60.0,
            cells,
            newtonian(3 * mu),
            run=lasting(30.0, 121),
            numerics=COMPILED,
            filament={"section": section},
        )
        done = sc.simulate(asked.replace({"ends.right": "free"}))
        x, time, X = (done.data[name].values for name in ("x", "time", "X_node"))
        mass = np.convolve(np.diff(X), [0.5, 0.5])
        inwards = (x[:-2] - x[2:]) / (time[2:] - time[:-2])[:, None]
        momentum = inwards @ mass
        centre = ((30.0 - x[1:-1]) * inwards) @ mass / momentum
        speed = np.polyfit(time[41:-1], centre[40:], 1)[0]
        rows.append((section, mu, f"{momentum[80] / time[81]:.6f}", f"{speed:.4f}", closed(done)))
        assert momentum[80] / time[81] == pytest.approx(1, abs=1e-5)
        assert speed == pytest.approx(1, abs=0.01)
    show(
        "Retraction",
        ("", "viscosity", "momentum/(Gam A0 t)", "speed/Keller's", "energy residual"),
        rows,
    )
