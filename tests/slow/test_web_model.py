"""The page's module, driven by model.js in node, against `simulate` with the page's effects and grid."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
import pytest

from softcat_sym import load_scene
from softcat_sym.batch.members import written
from softcat_sym.discretization import assembly
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SceneError
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import simulated
from softcat_sym.solvers.settings import compiled_settings
from softcat_sym.web.description import Page, describe_page
from tests.common.javascript import solved_in_node
from tests.common.pages import quick_page, random_states
from tests.common.runs import scene_of
from tests.common.table import show

pytestmark = pytest.mark.slow

SCENES = ("ink-bridge", "hot-glue-string")
STATES, AMID = 3, 0.5
"""States of a scene, drawn from this share of the ranges: at their ends `simulate` follows what falls for minutes."""
TIGHTER = 0.1
"""Of simulate: with the page's relative tolerance its looser absolute ones let a hinge flow in one late frame."""
HEADER = ("scene", "state", "outcome", "sag", "sag of simulate", "apart", "fields apart", "ms")
FIELDS = ("x", "y", "stretch", "thickness", "yielded_fraction")


def simulated_with(page: Page, scene: Scene, values: dict[str, float]) -> Run:
    """The run of a state with what the page fixes."""
    at = page.data["resolution"]
    numerics = {"cells": at["cells"], "grading": at["grading"], "estimate": False}
    fixed: dict[str, Any] = {f"numerics.{name}": value for name, value in numerics.items()}
    if "fibres" in page.data["effects"]:
        fixed["numerics.fibres"] = page.data["resolution"]["points"]
    moved = scene.replace(written(scene, dict(values)))
    # Where the fibres are is compiled in: in either half where hinges of the page's own scene carry.
    halves = assembly._hinges_carry(scene)
    with mock.patch.object(assembly, "_hinges_carry", lambda _: halves):
        held = moved.replace({**fixed, "run.effects": list(page.data["effects"])})
        rtol = TIGHTER * compiled_settings(held, choose_effects(held)).rtol
        return simulated(held.replace({"numerics.rtol": rtol}))


@pytest.mark.parametrize("name", SCENES)
def test_the_module_answers_as_simulate_does(name: str, tmp_path: Path) -> None:
    module = pytest.importorskip("softcat_sym.web.module")
    if module.find_wasm_compiler() is None:
        pytest.skip("no compiler for WebAssembly")
    scene = load_scene(name)
    page = describe_page(scene, name=name)
    place = tmp_path / "page.wasm"
    place.write_bytes(module.wasm_module(page.described))
    own = {"values": page.data["keys"]}
    states = [own, *random_states(page.data, STATES - 1, AMID)]
    rows, answers = [], solved_in_node(page.data, place, states, FIELDS)
    for number, (state, found) in enumerate(zip(states, answers, strict=True)):
        run = simulated_with(page, scene, state["values"])
        verdict, sag = found["verdict"], max(0.0, float(-run.fields["midpoint"].min()))
        apart = abs(found["sag"] - sag) / max(sag, 1e-12)
        fields = [worst(found["fields"][one], run.fields[one]) for one in FIELDS if one in run.fields]
        told = (verdict["outcome"], f"{found['sag']:.5g}", f"{sag:.5g}", f"{apart:.1e}")
        rows.append([name, str(number), *map(str, told), f"{max(fields):.1e}", f"{found['milliseconds']:.0f}"])
        show(f"page of {name}", HEADER, rows)
        if run.outcome.is_success:
            assert verdict["outcome"] == "computed" and apart < scene.run.accuracy, (state, rows[-1])
            assert max(fields[:4]) < 5 * scene.run.accuracy or number, rows[-1]


def worst(found: list[float], expected: np.ndarray[Any, Any]) -> float:
    """Largest difference over the largest value; infinite between arrays of other sizes."""
    if len(found) != expected.size:
        return float("inf")
    scale = float(np.max(np.abs(expected))) or 1.0
    return float(np.max(np.abs(np.reshape(found, expected.shape) - expected))) / scale


def test_a_shape_that_depends_on_a_key_keeps_it_from_being_a_slider() -> None:
    slack = scene_of("maxwell", filament={"rest_length": "0.21 m"}, load={"ramp": "0 s"}, numerics={"cells": 8})
    data = quick_page(slack)
    assert data["start"]["rows"] == len(data["resolution"]["nodes"])
    keys = [one["key"] for one in data["sliders"]]
    assert "filament.span" not in keys and "material.viscosity" in keys
    with pytest.raises(SceneError, match="shape that the filament begins with"):
        quick_page(slack, "filament.span=0.15:0.2 m")
