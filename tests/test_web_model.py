"""The page's model.js against Python: parameters, the scene as TOML, links, and where a shape ends."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from softcat_sym.batch.members import written
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.errors import SceneError
from softcat_sym.scene.scene import Scene
from softcat_sym.web import sliders
from tests.common.javascript import evaluated
from tests.common.pages import quick_page, random_states
from tests.common.runs import scene_of

FOLDER = Path(__file__).parent / "cases"

INK: dict[str, dict[str, Any]] = {
    "filament": {"span": "5 mm", "thickness": "0.4 mm", "section": "circle", "density": "2200 kg/m^3"},
    "material": {
        "law": "herschel-bulkley",
        "index": 0.5,
        "youngs_modulus": "300 kPa",
        "shear_yield_stress": "200 Pa",
        "shear_consistency": "10 Pa*s^0.5",
    },
    "load": {"ramp": "2 ms"},
    "run": {"duration": "10 ms", "frames": 5, "accuracy": 0.02},
    "surroundings": {"surface_tension": "72 mN/m"},
    "numerics": {"cells": 6, "fibres": 4, "estimate": False},
}


def ink() -> Scene:
    return Scene.model_validate({table: dict(values) for table, values in INK.items()})


def test_parameters_toml_and_links_of_a_state_are_those_of_its_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    few_keys = ("filament.span", "material.shear_consistency", "surroundings.surface_tension")
    monkeypatch.setattr(sliders, "_DEFAULT", few_keys)
    scene = ink()
    data = quick_page(scene, "load.gravity=1:20 m/s^2", "load.ramp=1:10 ms")
    keys = [one["key"] for one in data["sliders"]]
    assert {*few_keys, "load.gravity", "load.ramp"} == set(keys)
    states = random_states({**data, "sliders": [one for one in data["sliders"] if one["low"] > 0]}, 4)
    asked = "given.states.map(state => [numbersOf(given.data, state), tomlOf(given.data, state), "
    asked += "linkOf(given.data, state), stateOf(given.data, '#' + linkOf(given.data, state))])"
    found = evaluated(asked, in_node=True, data=data, states=states)
    for state, (parameters, toml, link, back) in zip(states, found, strict=True):
        moved = scene.replace(written(scene, state["values"]))
        values = parameter_values(moved)
        assert parameters == pytest.approx([values[name] for name in data["numbers"]], rel=1e-12)
        assert load_scene_text(toml) == moved, toml
        assert back == {"values": data["keys"] | state["values"]}
        assert "filament.span=" in link and "<" not in link


def load_scene_text(text: str) -> Scene:
    return Scene.model_validate(tomllib.loads(text))


def test_a_run_ends_where_a_cell_is_drawn_beyond_what_its_material_bears() -> None:
    """Of six frames over half a span the fourth tears: three are shown, mirrored, and called ruptured."""
    data = quick_page(ink(), only_numbers=True)
    frames, sites = 6, len(data["resolution"]["nodes"])
    rows = {one["name"]: 0.01 * (1 + k) * np.ones((frames, sites)) for k, one in enumerate(data["resolution"]["rows"])}
    rows["stretch"] += 1.0
    rows["stretch"][3:, 2] = 1.01 * data["largest_stretch"]
    rows["x"] = np.tile(np.arange(sites, dtype=float), (frames, 1))
    raw = {"code": 0, "reached": 1.0, "steps": 9, "site": -1, "slot": -1, "frames": frames, "sites": sites}
    raw |= {"sentence": "", "midpoint": -0.1 * np.arange(frames)}
    raw |= {"rows": np.stack([*rows.values()], axis=1).ravel()}
    asked = "runOf(given.data, ownState(given.data), given.data.resolution, unlisted(given.raw))"
    run = evaluated(asked, data=data, raw=raw)
    assert (run["verdict"]["outcome"], run["verdict"]["is_success"]) == ("ruptured", False)
    assert run["midpoint"] == pytest.approx([0.0, -0.1, -0.2]) and run["sag"] == pytest.approx(0.2)
    x = np.reshape(run["fields"]["x"], (3, -1))
    assert data["half"] and x.shape[1] == 2 * sites - 1
    np.testing.assert_array_equal(x[:, 1:-1], -x[:, -2:0:-1])
    raw["rows"] = np.stack([*(rows | {"stretch": 0 * rows["stretch"] + 1}).values()], axis=1).ravel()
    sound, limited = (evaluated(asked, data=data, raw=raw | {"code": code}) for code in (0, 1))
    assert (sound["verdict"]["outcome"], limited["verdict"]["outcome"]) == ("computed", "step_limit")
    assert limited["verdict"]["message"].startswith("stopped after t = 1 s") and len(sound["time"]) == frames


def test_what_cannot_be_a_slider_is_refused_in_one_line_each(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sliders, "_DEFAULT", ())
    scene = scene_of()
    for asked, words in {
        "numerics.cells=10:20": "it says how the filament is computed",
        "ends.left": "it is no number",
        "filament.span=1:2": "has no unit",
        "load.point_mass=1:2 g": "it changes the equations",
        "surroundings.surface_tension=0:1 N/m": "no number of the solver depends on it",
        "filament.thickness=1 mm:1 m": "1000 mm is refused",
        "filament.drop": "it is no number",
        "load.gravity=0:20 m/s^2": "time_scale is no product of powers with it",
    }.items():
        with pytest.raises(SceneError) as refused:
            quick_page(scene, asked)
        assert words in str(refused.value), (asked, str(refused.value))
