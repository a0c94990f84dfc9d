"""Modes carry a ringing without loss to its end: exactly for oscillators, as a tight integration does for strands."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.special import ellipj, ellipk

import softcat_sym as sc
from softcat_sym.codegen.sites import Sites
from softcat_sym.discretization.unknowns import Slot
from softcat_sym.effects.selection import choose_effects
from softcat_sym.single_run import build
from softcat_sym.solvers import modal_tail
from softcat_sym.solvers.compiled import CompiledIntegration
from softcat_sym.solvers.modal_tail import (
    Conditions,
    ModalFrames,
    Modes,
    Partition,
    Pieces,
    solved_with_tail,
    tail_of,
)
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Interrupted, Solution, Start

FREE = (False, False)
SLOTS = (
    Slot("y", "node", FREE, True, "v", False),
    Slot("v", "node", FREE, True, "", False),
    Slot("psi", "node", FREE, False, "", False),
    Slot("a_0", "node", FREE, True, "", True),
)


@dataclass(frozen=True)
class Chain:
    """Masses of one on springs, whose stiffness is of a turn: 0 = psi - y, v' = load - K psi - c y^3.

    Independent of the package: its motion is exp(A t) if it is linear, and an elliptic function for one mass.
    """

    stiffness: np.ndarray
    load: float
    cubic: float = 0.0
    yields_at: float = np.inf  # Of y, with a rate of one beyond

    @property
    def sites(self) -> Sites:
        count, width = len(self.stiffness), len(SLOTS)
        flat = np.arange(count)[:, None] * width
        return Sites((count, width), (flat + np.array([0, 1, 3])).ravel(), (flat + 2).ravel())

    @property
    def partition(self) -> Partition:
        found = Partition.of(SLOTS, self.sites)
        assert found is not None
        return found

    def state(self, y: np.ndarray) -> np.ndarray:
        zero = np.zeros_like(y)
        return np.stack([y, zero, y, zero], axis=-1).reshape(-1)

    def rates(self, states: np.ndarray) -> np.ndarray:
        y, v, psi, _ = np.moveaxis(states.reshape(len(states), -1, len(SLOTS)), -1, 0)
        flow = np.maximum(np.abs(y) - self.yields_at, 0.0) / self.yields_at if np.isfinite(self.yields_at) else 0 * y
        return np.stack([v, self.load - psi @ self.stiffness - self.cubic * y**3, psi - y, flow], axis=-1).reshape(
            len(states), -1
        )

    def powers(self, states: np.ndarray) -> np.ndarray:
        """Of plastic flow, none; and of the load, as though it were no potential."""
        return np.array([0 * states[:, 0], self.load * np.sum(states[:, 1 :: len(SLOTS)], axis=1)])

    def jacobian(self, state: np.ndarray, of: np.ndarray) -> np.ndarray:
        whole = np.zeros((len(state), len(state)))
        y = np.arange(len(self.stiffness)) * len(SLOTS)
        whole[y, y + 1], whole[y + 2, y + 2], whole[y + 2, y] = 1.0, 1.0, -1.0
        whole[np.ix_(y + 1, y + 2)] = -self.stiffness
        whole[y + 1, y] = -3 * self.cubic * state[y] ** 2
        return whole[np.ix_(of, of)]

    def exact(self, times: np.ndarray) -> np.ndarray:
        """States of the linear chain that is let go without displacement, by the exponential of its matrix."""
        count = len(self.stiffness)
        matrix = np.block([[np.zeros((count, count)), np.eye(count)], [-self.stiffness, np.zeros((count, count))]])
        rest = np.append(np.linalg.solve(self.stiffness, np.full(count, self.load)), np.zeros(count))
        motion = np.array([rest - expm(matrix * time) @ rest for time in times])
        y, v = motion[:, :count], motion[:, count:]
        return np.stack([y, v, y, 0 * y], axis=-1).reshape(len(times), -1)


def chain(count: int = 6) -> Chain:
    return Chain(2 * np.eye(count) - np.eye(count, k=1) - np.eye(count, k=-1), -0.3)


def test_a_linear_chain_is_followed_exactly_for_a_thousand_periods() -> None:
    one = chain()
    lowest = np.sqrt(np.min(np.linalg.eigvalsh(one.stiffness)))
    period = 2 * np.pi / lowest
    times = np.linspace(0.0, 5 * period, 161)
    states = one.exact(times)
    modes = Modes.of(one, one.partition, states[-1])
    assert modes is not None and np.isclose(modes.frequencies[0], lowest, rtol=1e-12)
    tail = tail_of(one.partition, modes, times, states, one.state(np.zeros(6)))
    later = np.array([7.3, 100.1, 1000.7]) * period
    # The frequency is that of the fit: rounding of it grows with the number of periods.
    assert np.allclose(tail.states(later), one.exact(later), rtol=0, atol=1e-7 * np.max(np.abs(states)))
    assert tail.residual < 1e-10 and tail.frequencies[1] == pytest.approx(lowest, rel=1e-11)


def duffing(amplitude: float) -> tuple[Chain, float]:
    """y'' = -y - y^3 and its exact frequency."""
    square = 1 + amplitude**2
    return Chain(np.eye(1), 0.0, cubic=1.0), np.pi * np.sqrt(square) / (2 * ellipk(amplitude**2 / (2 * square)))


@pytest.mark.parametrize("amplitude", [0.05, 0.2])
def test_the_frequency_of_a_finite_amplitude_is_that_of_duffings_oscillator(amplitude: float) -> None:
    one, frequency = duffing(amplitude)
    times = np.linspace(0.0, 5 * 2 * np.pi, 161)

    def exact(times: np.ndarray) -> np.ndarray:
        square = 1 + amplitude**2
        sn, cn, dn, _ = ellipj(np.sqrt(square) * times, amplitude**2 / (2 * square))
        y = amplitude * cn
        return np.stack([y, -amplitude * np.sqrt(square) * sn * dn, y, 0 * y], axis=-1)

    modes = Modes.of(one, one.partition, exact(times)[-1])
    assert modes is not None and np.isclose(modes.frequencies[0], 1.0)
    tail = tail_of(one.partition, modes, times, exact(times), one.state(np.array([-amplitude])))
    # What is left out is the fifth harmonic, amplitude^4/1024 of the first.
    assert tail.frequencies[1] == pytest.approx(frequency, rel=amplitude**4)
    assert abs(tail.frequencies[1] - frequency) < 1e-3 * abs(frequency - 1)
    assert tail.residual < amplitude**4 / 100
    assert modal_tail.FIT_ERROR * tail.residual**2 < 1e-6


def solved(one: Chain, conditions: Conditions, periods: int, calls: list[float]) -> Solution:
    """Through all frames, with integration replaced by SciPy's."""

    def integrate(start: Start, times: np.ndarray) -> Solution:
        calls.append(times[-1])
        rows = one.sites.state(start.x, start.z).ravel()

        def slope(_: float, moving: np.ndarray) -> np.ndarray:
            state = rows.copy()
            state[one.sites.x] = moving
            state[one.sites.z] = moving[::3]
            return one.rates(state[None])[0, one.sites.x]

        found = solve_ivp(slope, (times[0], times[-1]), start.x, "DOP853", times, rtol=1e-8, atol=1e-10)
        x, z = found.y, found.y[::3]
        work = np.array([0 * times, one.load * np.sum(z - z[:, :1], axis=0)])
        return Solution(times, x, z, work, Outcome.solved, "", len(times))

    frames = np.linspace(0.0, periods * conditions.period, 20 * periods + 1)
    rest = one.state(np.zeros(len(one.stiffness)))
    pieces = Pieces(integrate, one.sites, frames, Start(rest[one.sites.x], rest[one.sites.z]))
    return solved_with_tail(conditions, one, one.partition, pieces, 0)


def conditions_of(one: Chain, yield_strain: float = np.inf, begin: float = 0.0) -> Conditions:
    lowest = np.sqrt(np.min(np.linalg.eigvalsh(one.stiffness)))
    return Conditions(2 * np.pi / lowest, begin, 0.01, yield_strain)


def test_frames_rows_and_work_are_those_of_the_whole_run() -> None:
    one, calls = chain(3), list[float]()
    begin = 2.5 * conditions_of(one).period
    found = solved(one, conditions_of(one, begin=begin), 40, calls)
    exact = one.exact(found.time)
    assert found.tail_from == calls[-1] == pytest.approx(begin + 5 * conditions_of(one).period)
    assert len(found.time) == 801 and found.steps < 400
    y = exact[:, :: len(SLOTS)]
    scale = np.max(np.abs(y))
    for number, height in ((0, y[:, 0]), (3, y[:, 1]), (9, y[:, 0])):
        assert np.allclose(found.row(number), height, rtol=0, atol=1e-6 * scale)
    some = found.only([0, 3, 400, 800])
    assert some.tail_from == found.tail_from and some.whole is some
    assert np.allclose(some.x[0], y[[0, 3, 400, 800], 0], rtol=0, atol=1e-6 * scale)
    # The work of a dead load is its potential, on whatever way.
    assert np.allclose(some.quad[1], one.load * np.sum(y[[0, 3, 400, 800]], axis=1), rtol=0, atol=1e-6 * scale)
    assert np.array_equal(found.whole.row(0), found.row(0)) or np.allclose(found.whole.row(0), found.row(0), atol=1e-12)


def test_turning_points_and_their_means_are_those_of_the_motion() -> None:
    one = Chain(np.eye(1), -1.0)
    states = one.exact(np.linspace(0.0, 10 * np.pi, 161))
    modes = Modes.of(one, one.partition, states[-1])
    assert modes is not None
    tail = tail_of(one.partition, modes, np.linspace(0.0, 10 * np.pi, 161), states, 0 * states[0])
    # y = cos t - 1 from t = 10 pi on, with turning points at multiples of pi.
    found = tail.extremes(0, 30.5 * np.pi)
    assert np.allclose(found.time, np.pi * np.append(np.arange(10, 31), 30.5), atol=1e-3)
    assert np.allclose(found.height, np.cos(found.time) - 1, atol=1e-9)
    assert np.allclose(found.area, np.sin(found.time) - (found.time - 10 * np.pi), atol=1e-6)


@pytest.mark.parametrize(("load", "tries"), [(0.02, 1), (10.0, modal_tail.MAX_REFUSALS)])
def test_what_the_modes_do_not_describe_is_integrated_after_two_tries(load: float, tries: int) -> None:
    # Two masses that stiffen as far as the larger load takes them exchange their energy.
    one, calls = Chain(np.array([[2.0, -1.0], [-1.0, 1.7]]), -load, cubic=1.0), list[float]()
    found = solved(one, conditions_of(one), 34, calls)
    assert (found.tail_from is None) == (tries > 1)
    assert len(calls) == tries + (tries > 1)


STRAND = {
    "filament": {"span": "4 mm", "thickness": "0.6 mm", "section": "circle", "density": "1050 kg/m^3"},
    "material": {"law": "elastic", "youngs_modulus": "20 kPa"},
    "run": {"duration": "0.25 s"},
    "numerics": {"estimate": False, "cells": 12},
}


def test_a_strand_ends_where_a_tight_integration_does() -> None:
    scene = sc.Scene.from_dict(STRAND)
    tight = sc.simulate(scene, {"numerics.rtol": 1e-8, "numerics.tail": "integrate"})
    run = sc.simulate(scene)
    assert tight.summary["tail_from_s"] is None and run.summary["tail_from_s"] < scene.run.duration / 2
    sag = tight.summary["midpoint_largest_m"]
    for name in ("mean", "amplitude"):
        apart = run.summary["midpoint_settled_m"][name] - tight.summary["midpoint_settled_m"][name]
        assert abs(apart) < 5e-4 * sag
    assert np.max(np.abs(run.fields["midpoint"] - tight.fields["midpoint"])) < 5e-3 * sag
    assert run.summary["energy_residual"] < 1e-4
    assert len(run.summary["extremes"]) == len(tight.summary["extremes"])
    assert "modes of vibration" in run.summary["assumed"][0] and not tight.summary["assumed"]


def test_ctrl_c_while_the_tail_is_computed_leaves_what_was_integrated(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = sc.simulate(sc.Scene.from_dict(STRAND))

    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(ModalFrames, "at", stopped)
    with pytest.raises(Interrupted) as caught:
        sc.simulate(sc.Scene.from_dict(STRAND))
    part = caught.value.part()
    assert part.outcome is Outcome.interrupted and part.summary["tail_from_s"] is None
    frames = len(part.fields["time"])
    assert part.fields["time"][-1] <= whole.summary["tail_from_s"] < whole.fields["time"][frames]
    np.testing.assert_array_equal(part.fields["y"], whole.fields["y"][:frames])


@pytest.mark.parametrize(
    "changes",
    [
        {"load.shake": 0.1, "load.shake_frequency": "5 Hz"},
        {"material.loss_tangent": 0.1},
        {"numerics.tail": "integrate"},
        {"run.effects": ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation"]},
    ],
)
def test_what_moves_by_itself_or_dies_down_has_no_tail(changes: dict[str, object]) -> None:
    scene = sc.Scene.from_dict(STRAND).replace(changes)
    integration = build(scene, choose_effects(scene)).integration
    assert not isinstance(integration, CompiledIntegration) or integration.conditions is None
