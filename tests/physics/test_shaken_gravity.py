"""Gravity that oscillates: modes of a beam, statics of a slow shake, energy over many periods, ratcheting."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import cumulative_simpson

from softcat_sym import Scene, simulate
from softcat_sym.simulate import without_estimate
from tests.common.truths import beam_shaken
from tests.marks import few

from .scenes import GEOMETRY, Array, extrapolated, paper_scene, run, scene

GRAVITY, DENSITY = 10.0, 1000.0
THICKNESS, MODULUS = 0.03, 1e12
FLOW = ("viscous-flow", "yielding")
FIRST = 22.373285 * THICKNESS * np.sqrt(MODULUS / (12 * DENSITY)) / (2 * np.pi)
"""First frequency of the linear clamped beam of span 1 m [Hz]."""


def shaken(asked: Scene, a: float, frequency: float) -> Scene:
    """The scene under g (1 + a sin(2 pi f t)), on its own grid alone."""
    effects = asked.run.effects
    listed = effects if isinstance(effects, str) else [*effects, "gravity-shaking"]
    made = {"load.shake": a, "load.shake_frequency": f"{float(frequency)!r} Hz", "run.effects": listed}
    return without_estimate(asked.replace(made))


def beam(periods: float, frames: int, **more: object) -> Scene:
    names = ("inertia", "bending", *(("gravity-ramp",) if "ramp" in more else ()))
    return scene(
        thickness=THICKNESS, E=MODULUS, effects=names, duration=periods / FIRST, frames=frames, **{"cells": 40} | more
    )  # type: ignore[arg-type]


@pytest.mark.parametrize(("a", "ratio"), few([(0.5, 0.3), (0.5, 0.8), (0.5, 1.3), (2.0, 3.7)], (0.5, 0.8)))
def test_a_beam_follows_duhamel(a: float, ratio: float) -> None:
    """Below, near and above the first frequency."""
    coarse, fine = (run(shaken(beam(3, 101, rtol=1e-6, cells=cells), a, ratio * FIRST)).data for cells in (32, 64))
    midpoint = extrapolated(np.asarray(coarse["midpoint"]), np.asarray(fine["midpoint"]))
    unit = np.sqrt(1.0 / GRAVITY)
    stiffness = MODULUS / (DENSITY * GRAVITY)
    truth = beam_shaken(np.asarray(fine["time"]) / unit, stiffness, THICKNESS, a, ratio * FIRST * unit)
    error = float(np.max(np.abs(midpoint - truth)) / np.max(np.abs(truth)))
    print(f"a = {a}, f = {ratio} f_1: {error:.1e}")
    assert error < 1e-3


def test_a_slow_shake_follows_statics() -> None:
    """It may miss a (f/f_1)^2 = 1.5/900 of the sag; the grid misses 5e-4 of at most 2.5 sags, the ramp leaves 6e-5."""
    period = 30.0
    asked = shaken(beam(70, 281, ramp=20 / FIRST, rtol=1e-7, cells=60), 1.5, FIRST / period)
    done = run(asked)
    time = np.asarray(done.data["time"])
    static = 12 * DENSITY * GRAVITY / (384 * MODULUS * THICKNESS**2)
    expected = -static * (1 + 1.5 * np.sin(2 * np.pi * FIRST / period * time))
    loaded = time > asked.load.ramp
    missed = float(np.max(np.abs(done.data["midpoint"] - expected)[loaded]) / static)
    assert missed < 1.5 / period**2 + 1.5e-3
    assert float(np.max(done.data["midpoint"])) > 0.45 * static


def work_of_gravity(done_time: Array, y: Array, masses: Array, asked: Scene) -> Array:
    """What the change of the weight does to the potential energy, int dg/dt sum m y dt, from stored frames [J]."""
    angular = 2 * np.pi * asked.load.shake_frequency
    rate = GRAVITY * asked.load.shake * angular * np.cos(angular * done_time)
    return np.asarray(cumulative_simpson(rate * (y @ masses), x=done_time, initial=0))


def test_energy_is_kept_while_gravity_is_turned_round_fifty_times() -> None:
    """An elastic cable; the work is integrated from the stored shapes, not by the package."""
    asked = shaken(
        scene(thickness=0.03, E=5e7, effects=("inertia", *GEOMETRY), duration=2.5, frames=2501, cells=12, rtol=1e-8),
        2.0, 20.0,
    )  # fmt: skip
    done = run(asked)
    data = done.data
    lengths = np.diff(data["X_node"])
    masses = DENSITY * THICKNESS**2 * (np.r_[lengths, 0] + np.r_[0, lengths]) / 2
    work = work_of_gravity(np.asarray(data["time"]), np.asarray(data["y"]), masses, asked)
    total = sum(np.asarray(data[f"energy_{kind}"]) for kind in ("kinetic", "elastic", "potential"))
    assert float(np.max(np.abs(total - work))) < 2e-3 * float(np.max(data["energy_elastic"]))
    assert done.summary["energy_residual"] < 1e-6
    assert float(np.max(data["midpoint"])) > 0


@pytest.fixture(scope="module")
def strand() -> Scene:
    """The paper's strand at G = 0.03: below first yield under a steady weight."""
    return paper_scene(
        0.03, 30.0, 900.0, effects=("inertia", *GEOMETRY, *FLOW, "gravity-ramp"), frames=181,
        cells=24, ramp=100.0,
    )  # fmt: skip


def test_a_strand_shaken_beyond_its_yield_ratchets(strand: Scene) -> None:
    """After the ramp, in every one of eight periods."""
    period = strand.run.duration / 10
    done = run(shaken(strand, 2.0, 1 / period))
    assert run(without_estimate(strand)).summary["regime"] == "no-yield"
    assert done.summary["regime"] in ("descending", "shaken")
    lost = np.asarray(done.data["energy_dissipated"])
    assert np.min(np.diff(lost)) > -done.summary["rtol"] * lost[-1]
    by_period = np.diff(lost[20::18])
    assert np.all(by_period > 0.01 * lost[-1])
    means = np.asarray(done.data["midpoint"])[20:164].reshape(-1, 18).mean(axis=1)
    # It sinks by a tenth; from one period to the next its ringing may hide that.
    assert means[-1] < 1.1 * means[0] < 0


def test_a_strand_shaken_below_its_yield_does_not_flow(strand: Scene) -> None:
    done = run(shaken(strand, 0.1, 0.2 / strand.load.ramp))
    assert done.summary["regime"] == "no-yield"
    assert float(np.max(done.data["energy_dissipated"])) == 0


def test_what_yielded_while_it_was_loaded_and_shakes_is_not_called_arrested() -> None:
    names = ("inertia", *GEOMETRY, *FLOW, "gravity-ramp")
    asked = paper_scene(0.2, 3.0, 300.0, effects=names, frames=121, cells=24)
    assert run(without_estimate(asked)).summary["regime"].startswith("arrested")
    done = run(shaken(asked, 0.02, 4 / asked.run.duration))
    assert done.summary["regime"] == "shaken"


@pytest.mark.parametrize("law", ["elastic", "bingham"])
def test_compiled_is_interpreted(law: str) -> None:
    flow = FLOW if law == "bingham" else ()
    asked = scene(
        thickness=0.03, E=2e6, eta=None if not flow else 3e4, yield_stress=None if not flow else 3e4,
        effects=("inertia", *GEOMETRY, "gravity-ramp", *flow), ramp=0.05, duration=0.4, frames=41, cells=10, rtol=1e-8,
        solver="rosenbrock",
    )  # fmt: skip
    asked = shaken(asked, 2.0, 9.0)
    heights = [
        np.asarray(simulate(asked.replace({"numerics.backend": name})).data["midpoint"])
        for name in ("compiled", "interpreted")
    ]
    assert np.max(np.abs(heights[0] - heights[1])) < 1e-6 * np.max(np.abs(heights[1]))
