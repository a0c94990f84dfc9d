"""Symmetry: half a span stands for the whole, and left is right."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.discretization.grid import End, whole_span
from softcat_sym.scene.scene import Scene

from .scenes import GEOMETRY, paper_scene, run, scene

CELLS = 10
ODD = ("x", "shear_force")
EVEN = ("y", "stretch", "tension", "moment", "curvature", "stress_mean", "stress_bending", "thickness")

SCENES = {
    "elastic-statics": scene(thickness=0.03, E=3e5, effects=GEOMETRY, cells=CELLS),
    "maxwell-fall": scene(thickness=0.03, E=1e7, eta=2.6e5, frames=5, cells=CELLS, rtol=3e-9, solver="rosenbrock"),
    "bingham-descent": paper_scene(1.9, 26, 20, frames=5, cells=CELLS, rtol=1e-8, solver="rosenbrock"),
}


def difference(one: np.ndarray, two: np.ndarray) -> float:
    return float(np.max(np.abs(one - two)) / np.max(np.abs(one)))


@pytest.mark.parametrize("asked", SCENES.values(), ids=list(SCENES))
def test_half_span_equals_whole_span(asked: Scene) -> None:
    half = run(asked)
    whole = run(asked, whole_span(CELLS, End.CLAMPED, End.CLAMPED))
    assert half.outcome.is_success
    apart = {name: difference(half.data[name].values, whole.data[name].values) for name in ("midpoint", *ODD, *EVEN)}
    energies = {
        name: difference(half.data[name].values, whole.data[name].values)
        for name in ("energy_elastic", "energy_potential")
    }
    print("half against whole:", {name: f"{value:.0e}" for name, value in (apart | energies).items()})
    assert apart["midpoint"] < 1e-8
    assert max(apart.values()) < 1e-7
    assert max(energies.values()) < 1e-7


@pytest.mark.parametrize("asked", SCENES.values(), ids=list(SCENES))
def test_whole_span_is_left_right_symmetric(asked: Scene) -> None:
    data = run(asked, whole_span(CELLS, End.CLAMPED, End.CLAMPED)).data
    apart = {name: difference(data[name].values, -data[name].values[:, ::-1]) for name in ODD}
    apart |= {name: difference(data[name].values, data[name].values[:, ::-1]) for name in EVEN}
    print("left against right:", {name: f"{value:.0e}" for name, value in apart.items()})
    assert max(apart.values()) < 1e-10


@pytest.mark.parametrize("asked", SCENES.values(), ids=list(SCENES))
def test_clamped_pinned_is_the_mirror_image_of_pinned_clamped(asked: Scene) -> None:
    one = run(asked.replace({"ends.right": "pinned"}))
    two = run(asked.replace({"ends.left": "pinned"}))
    assert one.outcome.is_success
    apart = {name: difference(one.data[name].values, -two.data[name].values[:, ::-1]) for name in ODD}
    apart |= {name: difference(one.data[name].values, two.data[name].values[:, ::-1]) for name in EVEN}
    print("mirror images:", {name: f"{value:.0e}" for name, value in apart.items()})
    assert max(apart.values()) < 1e-10
    # The two ends do differ.
    heights = one.data["y"].values[-1]
    assert difference(heights, heights[::-1]) > 0.01
