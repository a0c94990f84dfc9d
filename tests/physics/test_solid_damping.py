"""A loss below yield: closed forms of its decay, no trace in what has settled, every law, theory and backend."""

from __future__ import annotations

import math
from functools import cache
from itertools import product
from typing import Any

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.free_vibration import first_vibration, solid_decay
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.scene.scene import Scene
from softcat_sym.single_run import build
from softcat_sym.solvers.run import assembled
from softcat_sym.solvers.settings import choose_backend
from tests.marks import few

KIRCHHOFF = ("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "solid-damping")
BACKENDS = ("interpreted", "compiled")
LAWS: dict[str, dict[str, Any]] = {
    "elastic": {"youngs_modulus": "90 kPa"},
    "maxwell": {"youngs_modulus": "90 kPa", "viscosity": "90 kPa*s"},
    "bingham": {"youngs_modulus": "90 kPa", "viscosity": "200 Pa*s", "yield_stress": "100 Pa"},
    "herschel-bulkley": {
        "youngs_modulus": "90 kPa", "consistency": "60 Pa*s^0.4", "index": 0.4, "shear_yield_stress": "60 Pa",
    },
    "power-law": {"youngs_modulus": "90 kPa", "consistency": "600 Pa*s^0.4", "index": 0.4},
    "custom": {"youngs_modulus": "90 kPa", "flow": "sigma/s0/t0", "parameters": {"s0": "100 Pa", "t0": "1 s"}},
    "standard-linear": {"youngs_modulus": "60 kPa", "second_modulus": "30 kPa", "viscosity": "30 kPa*s"},
    "multimode-maxwell": {
        "modes": [
            {"youngs_modulus": "50 kPa", "viscosity": "50 kPa*s"}, {"youngs_modulus": "40 kPa", "viscosity": "4 kPa*s"},
        ],
    },
}  # fmt: skip
YIELDS = ("bingham", "herschel-bulkley")


def strand(law: str = "elastic", **tables: dict[str, Any]) -> Scene:
    table: dict[str, Any] = {
        "filament": {"span": "20 mm", "diameter": "1 mm", "density": "1050 kg/m^3"},
        "material": {"law": law, "loss_tangent": 0.1, **LAWS[law]},
        "run": {"duration": "0.1 s", "frames": 401, "effects": list(KIRCHHOFF)},
        "numerics": {"estimate": False, "cells": 16},
    }
    for name, values in tables.items():
        table.setdefault(name, {}).update(values)
    return Scene.model_validate(table)


def decay_and_frequency(run: Trajectory, last: float = 0.6) -> tuple[float, float]:
    """Of the first mode: the peak of the spectrum near its frequency, and how much lower it is in a later window."""
    time, height = run.data.time.values, run.data.midpoint.values
    first = int((1 - last) * len(time))
    half = (len(time) - first) // 2
    vibration = first_vibration(run.scene)
    assert vibration is not None
    near = vibration.frequency * np.linspace(0.85, 1.15, 1201)

    def spectrum(begin: int) -> Any:
        part = slice(begin, begin + half)
        swing = (height[part] - np.average(height[part], weights=np.hanning(half))) * np.hanning(half)
        return np.abs(np.exp(-1j * np.outer(near, time[part])) @ swing)

    early, late = spectrum(first), spectrum(first + half)
    peak = int(np.argmax(early))
    return math.log(early[peak] / late[peak]) / (time[half] - time[0]), float(near[peak])


@cache
def ringing(backend: str, tangent: float) -> tuple[Trajectory, float]:
    """A beam so stiff that it hardly sags, let go; and its static sag."""
    scene = strand(
        material={"youngs_modulus": "9 MPa", "loss_tangent": tangent},
        run={"duration": "0.06 s", "frames": 1201, "accuracy": 1e-3},
        numerics={"backend": backend, "cells": 40},
    )
    still = ("bending", "extensibility", "finite-stretch", "thinning", "large-rotation")
    rest = simulate(scene.replace({"run.effects": list(still), "run.frames": 2, "numerics.backend": None}))
    return simulate(scene), float(rest.data.midpoint[-1])


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_beam_rings_down_by_half_its_loss_tangent(backend: str) -> None:
    run, _ = ringing(backend, 0.1)
    assert run.outcome.is_success
    decay, frequency = decay_and_frequency(run)
    vibration = first_vibration(run.scene)
    assert vibration is not None
    assert decay / vibration.frequency == pytest.approx(0.1 / 2, rel=0.01)
    assert frequency == pytest.approx(vibration.frequency, rel=0.005)
    assert run.summary["backend"] == backend


def test_without_a_loss_it_rings_on_and_a_tenth_of_it_loses_a_tenth() -> None:
    undamped = strand(
        material={"youngs_modulus": "9 MPa", "loss_tangent": 0.0},
        run={"duration": "0.06 s", "frames": 1201, "effects": list(KIRCHHOFF[:-1])},
    )
    run, _ = ringing("compiled", 0.01)
    decay, frequency = decay_and_frequency(run)
    assert decay / frequency == pytest.approx(0.01 / 2, rel=0.03)
    free = simulate(undamped)
    assert abs(decay_and_frequency(free)[0]) < 0.02 * decay
    assert decay_and_frequency(free)[1] == pytest.approx(frequency, rel=3e-3)


def test_a_string_that_hangs_loses_only_what_its_stretching_does() -> None:
    """Tension that is there anyway stores energy and loses none (Irvine 1981): a share of half the loss tangent."""
    scene = strand(
        filament={"diameter": "0.05 mm"},
        material={"youngs_modulus": "9 MPa"},
        ends={"left": "pinned", "right": "pinned"},
        # Let go slowly: the first mode swings little, and the higher ones, which lose less, hardly at all.
        load={"ramp": "40 ms"},
        run={
            "duration": "0.3 s",
            "frames": 1201,
            "effects": [*(n for n in KIRCHHOFF if n != "bending"), "gravity-ramp"],
        },
        numerics={"backend": "compiled", "cells": 24},
    )
    run = simulate(scene)
    assert run.outcome.is_success
    decay, frequency = decay_and_frequency(run)
    vibration = first_vibration(scene)
    assert vibration is not None
    assert 0.6 < vibration.material_share < 0.65
    assert frequency == pytest.approx(vibration.frequency, rel=0.01)
    # Small vibrations of a small sag; this one has a hundredth of the span.
    assert decay == pytest.approx(solid_decay(scene), rel=0.04)
    assert decay < 0.7 * 0.1 / 2 * frequency


def test_what_has_settled_shows_nothing_of_it() -> None:
    run, rest = ringing("compiled", 0.1)
    longer = simulate(run.scene.replace({"run.duration": "0.2 s", "run.frames": 201}))
    assert float(longer.data.midpoint[-1]) == pytest.approx(rest, rel=2e-5)
    lost = float(longer.data.energy_dissipated[-1])
    # Half of the work of a weight put on at once is stored, the other half lost.
    assert lost == pytest.approx(float(longer.data.energy_elastic[-1]), rel=1e-3)


@pytest.mark.parametrize(
    ("law", "theory"),
    few(
        product(LAWS, ("kirchhoff", "shear")),
        ("elastic", "shear"),
        ("maxwell", "kirchhoff"),
        ("standard-linear", "kirchhoff"),
        ("bingham", "shear"),
    ),
)
def test_every_law_has_it_in_both_theories_and_backends(law: str, theory: str) -> None:
    effects = [*KIRCHHOFF, *(["viscous-flow"] if law != "elastic" else []), *(["yielding"] if law in YIELDS else [])]
    if theory == "shear":
        effects += ["shear", *(["fibres"] if law in ("power-law", *YIELDS) else [])]
    runs = []
    for backend in BACKENDS:
        asked = {"effects": effects, "frames": 41, "accuracy": 1e-3}
        scene = strand(law, run=asked, numerics={"backend": backend, "cells": 8})
        run = simulate(scene)
        assert run.outcome.is_success, run.summary["message"]
        assert run.summary["energy_residual"] < 1e-3
        assert float(run.data.energy_dissipated[-1]) > 0
        runs.append(run.data.midpoint.values)
    assert np.max(np.abs(runs[0] - runs[1])) < 5e-4 * np.max(np.abs(runs[0]))


def test_a_model_with_it_and_one_without_are_two_structures() -> None:
    scene = strand()
    without = scene.replace({"run.effects": list(KIRCHHOFF[:-1])})
    keys = []
    for one in (scene, without):
        effects = choose_effects(one)
        keys.append(assembled(one, effects).structure().key)
    assert keys[0] != keys[1]
    # And they are two answers, whichever was compiled first.
    ends = [
        float(simulate(one.replace({"numerics.backend": "compiled"})).data.midpoint[-1]) for one in (scene, without)
    ]
    assert abs(ends[0] - ends[1]) > 0.05 * abs(ends[0])
    assert choose_backend(scene, choose_effects(scene)).compiled


def test_the_model_reads_its_viscosity_as_a_number() -> None:
    scene = strand()
    prepared = build(scene, choose_effects(scene))
    assert "solid_viscosity" in prepared.graph.parameters
    bare = scene.replace({"run.effects": list(KIRCHHOFF[:-1])})
    assert "solid_viscosity" not in build(bare, choose_effects(bare)).graph.parameters
