"""Steps and seconds per period of the first mode: what ``softcat explain`` foretells of a strand that rings."""

from __future__ import annotations

import math
import time
from typing import Any

import pytest

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.free_vibration import first_vibration
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.explanation import SECONDS_PER_UNKNOWN, STEPS_PER_PERIOD

pytestmark = pytest.mark.slow

SCENES: dict[str, tuple[str, str, dict[str, Any]]] = {
    "agar without loss": ("agar-bar", "sudden", {"material.loss_tangent": 0.0, "run.duration": "2 s"}),
    "agar, stiffer": (
        "agar-bar", "sudden",
        {"material.loss_tangent": 0.0, "material.youngs_modulus": "450 kPa", "run.duration": "0.7 s"},
    ),
    "with a ramp": ("no-yield", "ramp", {}),
    "agar": ("agar-bar", "damped", {}),
    "rubber": ("rubber-strand", "damped", {}),
}  # fmt: skip


@pytest.mark.parametrize("name", list(SCENES))
@pytest.mark.parametrize("accuracy", [0.01, 0.001])
def test_steps_are_foretold_to_a_factor_of_three(name: str, accuracy: float) -> None:
    bundled, kind, changes = SCENES[name]
    scene = sc.load_scene(bundled, {**changes, "run.accuracy": accuracy})
    vibration = first_vibration(scene)
    assert vibration is not None
    prepared = build(scene, choose_effects(scene))
    begun = time.process_time()
    steps = prepared.solve(Silence()).steps
    seconds = time.process_time() - begun
    periods = scene.run.duration * vibration.frequency / (2 * math.pi)
    unknowns = prepared.graph.x.numel() + prepared.graph.z.numel()
    at_first, growth, power = STEPS_PER_PERIOD[kind]
    foretold = at_first * periods ** (growth - 1) * (0.01 / accuracy) ** power
    print(
        f"\n{name}, {accuracy:g}: {periods:.0f} periods, {steps / periods:.0f} steps each (foretold {foretold:.0f}), "
        f"{1e6 * seconds / steps / unknowns:.2f} us a step and unknown (foretold {1e6 * SECONDS_PER_UNKNOWN:.2f})"
    )
    assert 1 / 3 < steps / periods / foretold < 3
