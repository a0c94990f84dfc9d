"""What a camera sees of a filament: values against runs, derivatives against differences, both solvers."""

from __future__ import annotations

import _thread
import math
import threading
import time
from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.scene.reading import load_scene
from tests.marks import few

BACKENDS = ("compiled", "interpreted")
PAPER = {"run.effects": "paper", "numerics.cells": 8}


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
    ("slime-slope", ("drop", "span")),
    ("curled-rod", ("curvature",)),
    ("glass-rod", ("viscosity", "time_offset", "density")),
    ("beam-viscometer", ("viscosity", "span", "time_offset")),
    ("putty-arch", ("thickness",)),
    ("stretched-rubber-band", ("stretch", "youngs_modulus")),
    ("transient-gel", ("material.parameters.s0", "material.parameters.t0")),
    ("polyethylene-melt", ("mode_2_youngs_modulus", "mode_3_viscosity")),
    ("gelatin-strand", ("poisson", "viscosity")),
]


@pytest.mark.parametrize(("scene", "names"), few(OF_SCENES, OF_SCENES[1], OF_SCENES[3], OF_SCENES[4], OF_SCENES[8]))
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


@pytest.mark.parametrize("backend", BACKENDS)
def test_only_the_camera_is_free(backend: str) -> None:
    model = _model(_scene("continual-descent"), "time_offset", backend=backend)
    midpoint, derivatives = model.with_derivatives(model.typical)
    assert derivatives.shape == (len(midpoint), 1)
    assert np.isfinite(derivatives).all()


def test_absurd_values_have_no_answer() -> None:
    """A thousandth of the viscosity: it falls into thin air, NaN after that, soon; the next values are answered."""
    model = _model(_scene("continual-descent"), "viscosity")
    sound = model.midpoints(np.zeros(1))
    begun = time.process_time()
    midpoint, derivatives = model.with_derivatives(np.array([-6.5]))
    assert time.process_time() - begun < 25
    assert "steps" in model.message
    assert np.isfinite(midpoint[1])
    assert np.isfinite(derivatives[1]).all()
    assert np.isnan(midpoint[-1])
    assert np.isnan(derivatives[-1]).all()
    np.testing.assert_array_equal(model.midpoints(np.zeros(1)), sound)
    assert not model.message


@pytest.mark.slow
def test_neighbours_that_are_lost_are_found_again() -> None:
    """So loosely that a neighbour in lock-step falls apart where the run does not."""
    scene = sc.load_scene("arrested-underdamped", {"numerics.cells": 16})
    model = _model(scene, "viscosity", "yield_stress", times=np.linspace(0, 0.5, 9) * scene.run.duration, rtol=1e-4)
    midpoint = model.midpoints(np.zeros(2))
    again, derivatives = model.with_derivatives(np.zeros(2))
    assert not model.message
    assert np.isfinite(derivatives).all()
    np.testing.assert_allclose(again, midpoint, atol=1e-3 * np.max(np.abs(midpoint)))


@pytest.mark.parametrize("backend", BACKENDS)
def test_what_fails_is_no_number(backend: str, capfd: pytest.CaptureFixture[str]) -> None:
    """Whichever solver gives up, and none writes to the terminal."""
    model = _model(_scene("continual-descent"), "viscosity", backend=backend)
    model.__dict__["_max_steps"] = 10
    midpoint, derivatives = model.with_derivatives(np.zeros(1))
    assert model.message
    assert np.isnan(midpoint[-1])
    assert np.isnan(derivatives[-1]).all()
    point = model._filament.point(np.zeros(1), slopes=True)
    assert point is not None
    lost = replace(point, parameters=point.parameters * math.nan)
    assert model._filament.integrator.run_with_slopes(lost, np.array([1.0]), (0,), 1000).message
    assert capfd.readouterr() == ("", "")


def test_a_filament_that_would_be_slack_has_no_answer() -> None:
    """Bounds keep it from there; beyond them it is no error either."""
    scene = _scene("stretched-rubber-band", "inertia", "bending", "extensibility", "finite-stretch", "large-rotation")
    model = _model(scene, "stretch")
    assert np.isfinite(model.midpoints(np.array([0.0]))).all()
    below = model.free[0].scaled(0.9)
    assert below < model.lower[0]
    assert np.isnan(model.midpoints(np.array([below]))).all()
    assert "slack" in model.message


def test_what_does_nothing_is_refused() -> None:
    """Without shear nothing asks for Poisson's ratio."""
    with pytest.raises(sc.SceneError, match="free poisson: makes no difference with the effects in force") as error:
        _model(_scene("continual-descent"), "poisson", "viscosity")
    assert len(error.value.faults) == 1


def test_no_motion_is_refused() -> None:
    names = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "gravity-ramp"]
    with pytest.raises(sc.SceneError, match="the motion does not depend on time"):
        _model(_scene("no-yield", *names), "youngs_modulus")


@pytest.mark.parametrize("times", [np.array([0.0, np.nan]), np.zeros((2, 2))])
def test_times_that_are_none(times: np.ndarray) -> None:
    with pytest.raises(sc.SoftcatError, match="times"):
        _model(_scene("continual-descent"), "viscosity", times=times)


@pytest.mark.parametrize("backend", BACKENDS)
def test_ctrl_c_is_heard(backend: str) -> None:
    """While it integrates, tightly and for long."""
    scene = sc.load_scene("arrested-underdamped", {"run.effects": "paper", "numerics.cells": 60})
    model = _model(scene, "youngs_modulus", backend=backend, times=np.linspace(0, 20, 5), rtol=1e-10)
    model.__dict__["_max_steps"] = 1_000_000
    timer = threading.Timer(0.5, _thread.interrupt_main)
    timer.start()
    begun = time.process_time()
    with pytest.raises(KeyboardInterrupt):
        model.with_derivatives(model.typical)
    assert time.process_time() - begun < 50


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


def test_an_unknown_that_hardly_moves_the_filament_has_its_derivative() -> None:
    """The modulus of a filament that flows, at a loose tolerance, against wide differences at a tight one."""
    scene = load_scene("continual-descent", {"numerics.cells": 20})
    times = np.linspace(0.0, scene.run.duration, 101)[1:]
    free = free_parameters(scene, ("youngs_modulus",))
    loose, tight = (ForwardModel(scene, free, times, rtol=rtol) for rtol in (1e-3, 1e-5))
    assert "fibres" in loose.effects
    q, step = loose.typical, 0.2
    wide = (tight.midpoints(q + step) - tight.midpoints(q - step)) / (2 * step)
    found = loose.with_derivatives(q)[1][:, 0]
    assert np.linalg.norm(found - wide) < 0.1 * np.linalg.norm(wide)
