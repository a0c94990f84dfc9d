"""A run that fails says when, where and what to do, and keeps what is sound."""

from __future__ import annotations

import dataclasses

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.graph import Graph
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers import settings
from softcat_sym.solvers.interpreted import worst_component
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import prepare
from softcat_sym.solvers.solution import Silence

from .filaments import graph_of, midpoint, prepared, scene_of, settings_of, without


def _with_ode(graph: Graph, ode: ca.SX) -> Graph:
    return dataclasses.replace(graph, write=lambda: dataclasses.replace(graph.raw, rates=(ode, graph.alg)))


def test_every_outcome_gives_its_own_advice() -> None:
    advice = [outcome.value for outcome in Outcome]
    assert len(set(advice)) == len(advice) == len(list(Outcome)) == len(Outcome.__members__)
    assert all(len(text) > 20 for text in advice)


def test_only_one_outcome_is_a_success() -> None:
    assert [outcome for outcome in Outcome if outcome.is_success] == [Outcome.solved]


def test_advice_names_keys_that_exist() -> None:
    for outcome in Outcome:
        known = {name: set(type(getattr(scene_of(), name)).model_fields) for name in ("run", "load", "numerics")}
        for word in outcome.value.replace(",", " ").replace(";", " ").replace(":", " ").split():
            table, _, key = word.partition(".")
            if table in known and key:
                assert key in known[table], word


@pytest.mark.parametrize("solver", ["cvodes", "rosenbrock"])
def test_too_many_steps_is_a_step_limit(solver: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(settings, "_STEPS_PER_FRAME", 2)
    scene = scene_of(frames=5)
    solution = prepared(scene, solver=solver).solve(Silence())
    assert solution.outcome is Outcome.step_limit
    assert "stopped after t = 0 s" in solution.message
    assert "] at X/L = " in solution.message
    assert len(solution.time) == 1


def spoiled(graph: Graph, after: float) -> Graph:
    """The same filament, whose right-hand side becomes undefined after a time: log of what is left of it."""
    lost = ca.log(after - graph.t)
    return _with_ode(graph, graph.ode + 1e-3 * lost * ca.SX.ones(graph.ode.numel()))


@pytest.mark.parametrize("solver", ["cvodes", "rosenbrock"])
def test_a_run_that_breaks_keeps_its_sound_part(solver: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(settings, "_STEPS_PER_FRAME", 2000)
    scene = scene_of(frames=11)
    whole = graph_of(scene)
    run = prepare(scene, whole, settings_of(scene, solver=solver))
    end = float(run.times[-1])
    broken = prepare(scene, spoiled(whole, 0.55 * end), settings_of(scene, solver=solver))
    solution = broken.solve(Silence())
    assert solution.outcome in (Outcome.non_finite, Outcome.no_convergence, Outcome.step_limit)
    # frames 0 to 5 lie before the break
    assert len(solution.time) == 6
    for states in (solution.x, solution.quad):
        assert states.shape[1] == 6
        assert np.all(np.isfinite(states))
    np.testing.assert_allclose(solution.time, run.times[:6], rtol=1e-12)
    assert f"stopped after t = {solution.time[-1] * broken.scale:.6g} s" in solution.message
    assert "fastest: " in solution.message


@pytest.mark.parametrize("solver", ["cvodes", "rosenbrock"])
def test_a_right_hand_side_that_is_undefined_at_once(solver: str) -> None:
    scene = scene_of(frames=4)
    graph = graph_of(scene)
    nowhere = _with_ode(graph, graph.ode + ca.log(-1 - graph.t) * ca.SX.ones(graph.ode.numel()))
    solution = prepare(scene, nowhere, settings_of(scene, solver=solver)).solve(Silence())
    assert solution.outcome is Outcome.non_finite
    assert len(solution.time) == 1
    assert np.all(np.isfinite(solution.x))


def worst_of(graph: Graph) -> str:
    return worst_component(graph, 0.0, graph.start, graph.straight, np.ones(len(graph.parameters)))


def test_the_worst_component_is_named() -> None:
    graph = graph_of(scene_of())
    chosen = 7
    only = ca.SX(graph.x.numel(), 1)
    only[chosen] = -5
    name = worst_of(_with_ode(graph, only))
    assert name == graph.state_names[chosen]


def test_an_undefined_component_is_worse_than_any() -> None:
    graph = graph_of(scene_of())
    rates = ca.SX.ones(graph.x.numel())
    rates[3] = ca.log(graph.t - 1)
    name = worst_of(_with_ode(graph, rates))
    assert name == graph.state_names[3]


def string(ramp: str, law: str = "bingham") -> Scene:
    return without(scene_of(law, frames=4, ramp=ramp), "inertia", "bending")


@pytest.mark.parametrize("law", ["elastic", "bingham"])
def test_a_string_without_inertia_has_no_shape_to_begin_with(law: str) -> None:
    """Before the ramp it carries nothing and resists nothing: its height is anything."""
    run = prepared(string("0.05 s", law))
    solution = run.solve(Silence())
    assert solution.outcome is Outcome.no_equilibrium
    assert len(solution.time) == 1
    assert "t = 0 s" in solution.message


def test_a_string_under_its_whole_weight_hangs_as_a_cable() -> None:
    run = prepared(string("0 s", "elastic"))
    solution = run.solve(Silence())
    assert solution.outcome is Outcome.solved
    sag = -midpoint(run, solution.z)[0]
    wanted = (3 * 1900 * 9.81 * 0.2 / (64 * 4e6)) ** (1 / 3)
    assert sag == pytest.approx(wanted, rel=0.03)
