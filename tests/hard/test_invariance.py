"""Left and right, and every place of a filament: what a hard case must not change."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.simulate import without_estimate
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence

from .dimensionless import asked

SCENES = {
    "maxwell": asked("maxwell", E=1e3, V=30, T=10, frames=11, numerics={"cells": 20, "rtol": 1e-7}),
    "bingham": asked("bingham", E=1e3, V=30, G=1, T=10, ramp=1, frames=11, numerics={"cells": 20, "rtol": 1e-7}),
    "slack": asked(
        "maxwell", E=1e4, V=1e3, T=5, frames=11, filament={"rest_length": 1.5}, numerics={"cells": 20, "rtol": 1e-7}
    ),
}


@pytest.mark.parametrize("name", ["maxwell", pytest.param("bingham", marks=pytest.mark.slow), "slack"])
def test_left_is_right_of_a_whole_span(name: str) -> None:
    """A support that moves by nothing takes the symmetry from the solver, but not from the answer."""
    half = without_estimate(SCENES[name])
    effects = list(sc.simulate(half).summary["effects"])
    half = half.replace({"run.effects": effects})
    whole = half.replace({"ends.motion": [["0 s", "0 m", "0 m"], ["1 s", "0 m", "0 m"]]})
    one, two = sc.simulate(half), sc.simulate(whole)
    assert one.outcome.is_success
    assert two.outcome.is_success
    y, x = np.asarray(two.data["y"]), np.asarray(two.data["x"])
    deep = np.max(np.abs(y))
    lopsided = max(np.max(np.abs(y - y[:, ::-1])), np.max(np.abs(x + x[:, ::-1])))
    apart = np.max(np.abs(np.asarray(one.data["midpoint"] - two.data["midpoint"])))
    print(f"{name}: left against right {lopsided / deep:.1e}, half against whole {apart / deep:.1e}")
    assert lopsided < 1e-7 * deep
    assert apart < 1e-5 * deep


@pytest.mark.parametrize("name", ["maxwell", pytest.param("bingham", marks=pytest.mark.slow), "slack"])
def test_every_cell_dissipates_at_every_moment(name: str) -> None:
    """The power that flow takes, cell by cell and not only in all, is never negative."""
    scene = SCENES[name]
    prepared = build(scene, choose_effects(scene))
    solution = prepared.solve(Silence())
    assert solution.outcome.is_success
    graph = prepared.graph
    power = ca.Function("power", [graph.t, graph.x, graph.z, graph.p], [graph.powers[0]])
    cells = np.array(
        [
            np.asarray(power(t, x, z, prepared.p)).ravel()
            for t, x, z in zip(solution.time, solution.x.T, solution.z.T, strict=True)
        ]
    )
    print(f"{name}: least power of {cells.size} cells and moments {cells.min() / cells.max():.1e} of the largest")
    assert cells.size >= 10 * 20
    assert cells.max() > 0
    assert cells.min() >= 0
