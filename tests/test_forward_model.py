"""What a camera sees of a filament: values against runs, derivatives against differences, both solvers."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.scene.reading import load_scene
from tests.marks import few

BACKENDS = ("compiled", "interpreted")


@lru_cache(maxsize=32)
def _scene(name: str, *effects: str, **changes: object) -> sc.Scene:
    over = {"run.effects": list(effects) if effects else "paper", "numerics.cells": 8}
    return sc.load_scene(name, over | {key.replace("__", "."): value for key, value in changes.items()})


def _model(
    scene: sc.Scene,
    *names: str,
    backend: str = "compiled",
    times: np.ndarray | None = None,
    rtol: float | None = None,
) -> ForwardModel:
    times = np.linspace(0.0, 0.8, 9) * scene.run.duration if times is None else times
    return ForwardModel(scene, free_parameters(scene, names), times, backend, rtol)


def _differences(model: ForwardModel, q: np.ndarray, h: float = 4e-4) -> np.ndarray:
    units = np.eye(len(q))
    return np.stack([(model.midpoints(q + h * e) - model.midpoints(q - h * e)) / (2 * h) for e in units], axis=1)


@pytest.mark.parametrize("backend", BACKENDS)
def test_it_is_the_midpoint_of_a_run(backend: str) -> None:
    """With other values than the typical ones, against `simulate` of the scene validated with them."""
    scene = _scene("continual-descent", run__frames=11)
    model = _model(
        scene, "viscosity", "thickness", backend=backend, times=np.linspace(0, scene.run.duration, 11), rtol=1e-7
    )
    q = np.array([0.3, -0.1])
    eta, thickness = scene.material.viscosity * math.exp(0.3), scene.filament.thickness * math.exp(-0.1)
    # On the same grid: the program would grade it anew.
    grading = _grading(scene)
    changed = {"material.viscosity": f"{eta!r} Pa*s", "filament.thickness": f"{thickness!r} m"}
    run = sc.simulate(scene.replace({**changed, "numerics.grading": grading, "numerics.rtol": 1e-7}))
    np.testing.assert_allclose(model.midpoints(q), run.data.midpoint.values, atol=2e-7 * scene.filament.span)


def _grading(scene: sc.Scene) -> float:
    from softcat_sym.discretization.assembly import choose_grid

    lengths = choose_grid(scene).cell_length
    return float(lengths[0] / lengths[-1])


OF_SCENES = [
    ("continual-descent", ("gravity", "density", "span", "ramp", "thickness")),
    ("slack-taffy", ("rest_length", "viscosity")),
    ("curled-rod", ("curvature",)),
    ("glass-rod", ("viscosity", "time_offset", "density")),
    ("stretched-rubber-band", ("stretch", "youngs_modulus")),
    ("transient-gel", ("material.parameters.s0", "material.parameters.t0")),
    ("polyethylene-melt", ("mode_2_youngs_modulus", "mode_3_viscosity")),
]


@pytest.mark.parametrize(("scene", "names"), few(OF_SCENES, OF_SCENES[1], OF_SCENES[3]))
def test_derivatives_of_what_moves_lengths_starts_and_units(scene: str, names: tuple[str, ...]) -> None:
    """Against differences of neighbouring values, with the program's own effects."""
    asked = sc.load_scene(scene, {"numerics.cells": 8})
    times = np.linspace(0.01, 0.1, 7) * asked.run.duration
    model = _model(asked, *names, times=times, rtol=1e-7)
    q = model.typical.copy()
    q[[name == "time_offset" for name in model.names]] = -0.01
    midpoint, derivatives = model.with_derivatives(q)
    assert not model.message
    found = _differences(model, q)
    largest = np.max(np.abs(derivatives), axis=0)
    assert np.all(largest > 0)
    # Where fibres yield one after another, differences further apart see the slope to the root of the tolerance.
    tolerance = 1e-3 if "fibres" in model.effects else 2e-4
    np.testing.assert_allclose(derivatives / largest, found / largest, atol=tolerance)
    assert np.max(np.abs(midpoint)) > 0


@pytest.mark.parametrize("backend", BACKENDS)
def test_clock_and_zero_of_the_camera(backend: str) -> None:
    """Data = model(time - offset) + sag; before it moves the filament is where it begins."""
    scene = _scene("continual-descent")
    times = np.array([0.3, 0.0, 0.7, 0.3, -0.5])
    model = _model(scene, "viscosity", "time_offset", "initial_sag", backend=backend, times=times)
    plain = _model(scene, "viscosity", backend=backend, times=np.array([0.2, 0.6]))
    offset, sag = model.free[1], model.free[2]
    q = np.array([0.1, 0.1 / offset.scale, 0.003 / sag.scale])
    seen, derivatives = model.with_derivatives(q)
    moved = plain.midpoints(np.array([0.1])) + 0.003
    np.testing.assert_allclose(seen, [moved[0], 0.003, moved[1], moved[0], 0.003], atol=2e-5 * abs(moved[1]))
    np.testing.assert_array_equal(derivatives[:, 2], sag.scale)
    np.testing.assert_array_equal(derivatives[[1, 4], :2], 0.0)
    np.testing.assert_array_equal(seen[0], seen[3])
    early = np.array([0.0, 2.0 / offset.scale, 0.0])
    np.testing.assert_array_equal(model.with_derivatives(early)[0], 0.0)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["continual-descent", "slime-slope"])
def test_shapes(name: str) -> None:
    """Against the nodes of a run, whether half or all of it is computed, and against neighbouring values."""
    scene = sc.load_scene(name, {"numerics.cells": 8, "run.effects": "auto", "run.frames": 6})
    share = 0.2 * scene.run.duration
    run = sc.simulate(
        scene.replace({"run.duration": f"{share!r} s", "run.effects": list(_model(scene, "viscosity").effects)})
    )
    names = ("viscosity", "span", "time_offset", "initial_sag")
    model = _model(scene, *names, times=np.array([]), rtol=1e-7)
    assert model.with_derivatives(model.typical)[1].shape == (0, 4)
    q = model.typical
    at_nodes = run.data.x.values[-1]
    inner = at_nodes[1:-1]
    height, _ = model.shapes(q, np.full(len(inner), share), inner)
    largest = float(np.max(np.abs(run.data.y.values[-1])))
    np.testing.assert_allclose(height, run.data.y.values[-1][1:-1], atol=1e-3 * largest)
    x = np.linspace(-0.8, 0.8, 7) * np.max(at_nodes)
    times = share * np.linspace(0.3, 1.0, 7)
    height, derivatives = model.shapes(q, times, x)
    units = np.eye(len(q))
    found = [(model.shapes(q + 4e-4 * e, times, x)[0] - model.shapes(q - 4e-4 * e, times, x)[0]) / 8e-4 for e in units]
    largest_slope = np.max(np.abs(derivatives), axis=0)
    np.testing.assert_allclose(derivatives / largest_slope, np.stack(found, axis=1) / largest_slope, atol=5e-4)
    beyond, _ = model.shapes(q, np.array([share]), np.array([scene.filament.span]))
    assert np.isnan(beyond).all()


_FREE = ("thickness", "yield_stress")


def test_derivatives_are_those_of_wide_differences() -> None:
    """At the default tolerance: differences over 4 % see the slope, and none of the jumps.

    Where both of its causes cancel, a column is known to a hundredth of the others.
    """
    scene = load_scene("arrested-overdamped", {"filament.span": "210 mm"})
    model = ForwardModel(scene, free_parameters(scene, _FREE), np.array([scene.run.duration]))
    assert "fibres" in model.effects
    q, step = model.typical, 0.02
    found = model.with_derivatives(q)[1]
    wide = [(model.midpoints(q + h) - model.midpoints(q - h)) / (2 * step) for h in step * np.eye(len(_FREE))]
    np.testing.assert_allclose(found, np.stack(wide, axis=1), rtol=0.02, atol=0.01 * float(np.max(np.abs(wide))))
