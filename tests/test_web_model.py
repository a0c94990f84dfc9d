"""The page's model.js against Python: parameters, the scene as TOML, links, and what is said of a run."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.batch.members import written
from softcat_sym.discretization.parameters import parameter_values, time_scale
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SceneError
from softcat_sym.results.fields import energy_residual, min_energy, node_positions, whole_span_fields
from softcat_sym.results.motion import has_yielded, midpoint_extremes
from softcat_sym.results.run import judge
from softcat_sym.results.verdict import rupture_frame, verdict
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.single_run import build
from softcat_sym.solvers import compiled
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Silence
from softcat_sym.web import sliders
from tests.common.javascript import evaluated
from tests.common.pages import quick_page, random_states
from tests.common.runs import scene_of
from tests.marks import few

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
    states = random_states({**data, "sliders": [one for one in data["sliders"] if one["low"] > 0]}, 10)
    asked = "given.states.map(state => [parametersOf(given.data, state), tomlOf(given.data, state), "
    asked += "linkOf(given.data, state), stateOf(given.data, '#' + linkOf(given.data, state))])"
    for state, (parameters, toml, link, back) in zip(states, evaluated(asked, data=data, states=states), strict=True):
        moved = scene.replace(written(scene, state["values"]))
        values = parameter_values(moved)
        assert parameters == pytest.approx([values[name] for name in data["parameters"]], rel=1e-12)
        assert load_scene_text(toml) == moved, toml
        assert back == {"scene": 0, "values": data["scenes"][0]["keys"] | state["values"]}
        assert "scene=" in link and "<" not in link


def load_scene_text(text: str) -> Scene:
    return Scene.model_validate(tomllib.loads(text))


LONG = {"run": {"duration": "2 s", "frames": 41, "accuracy": 0.01}, "numerics": {"cells": 8}}
STRING = ["inertia", "extensibility", "finite-stretch", "thinning", "large-rotation"]
UNLIMITED = ["inertia", "bending", "extensibility", "large-rotation", "viscous-flow", "yielding", "gravity-ramp"]
SQUEEZED = [["0 s", "0 m", "0 m"], ["0.1 s", "-20 mm", "0 m"]]


def weak() -> Scene:
    changes = {"material.youngs_modulus": "2 kPa", "run.effects": "paper", "load.ramp": "0 s", "run.duration": "1 s"}
    return scene_of("elastic").replace(changes)


def thread(duration: float) -> Scene:
    """A thread of polymer chains, whose last cell carries four tenths of its elongation, or nine."""
    changes = {"run.duration": f"{duration} s", "run.frames": 5, "numerics.cells": 20, "numerics.estimate": False}
    return sc.load_scene(FOLDER / "giesekus-thread.toml", changes)


CASES: Mapping[str, tuple[Any, str, str | None]] = {
    "stops": (lambda: scene_of(**LONG, material={"yield_stress": "9.32 kPa"}), "solved", "arrested-overdamped"),
    "swings back": (
        lambda: scene_of(
            run={**LONG["run"], "frames": 201},
            numerics={"cells": 8},
            material={"yield_stress": "14.9 kPa", "viscosity": "213 Pa*s"},
        ),
        "solved",
        "arrested-underdamped",
    ),
    "descends": (scene_of, "solved", "descending"),
    "holds": (lambda: scene_of(material={"yield_stress": "400 kPa"}), "solved", "no-yield"),
    "flows": (lambda: scene_of("maxwell"), "solved", "viscous"),
    "elastic": (lambda: scene_of("elastic", ends={"right": "pinned"}), "solved", "elastic"),
    "tears": (weak, "ruptured", None),
    "necks": (scene_of, "localised", None),
    "necks in one cell": (lambda: scene_of(run={"effects": UNLIMITED}), "localised", None),
    "thread": (lambda: thread(0.5), "solved", "viscous"),
    "thread that is cut": (lambda: thread(0.7), "localised", None),
    "gives up": (scene_of, "step_limit", None),
    "folds": (
        lambda: scene_of("elastic", run={"effects": STRING}, ends={"motion": SQUEEZED, "left": "pinned"}),
        "compressed",
        None,
    ),
    "drifts": (scene_of, "energy_drift", None),
    "breaks": (lambda: scene_of("elastic", material={"breaking_strain": 0.002}), "broken", None),
}


SLOW = ("swings back", "necks in one cell", "thread", "thread that is cut", "breaks")


@pytest.mark.parametrize("case", few(CASES, *(case for case in CASES if case not in SLOW)))
def test_a_run_is_judged_in_the_words_of_the_program(case: str, monkeypatch: pytest.MonkeyPatch) -> None:
    made, outcome, regime = CASES[case]
    scene = made()
    data = quick_page(scene, only_numbers=True)
    scene = scene.replace({"run.effects": list(data["effects"])})
    effects = choose_effects(scene)
    prepared = build(scene, effects)
    if case == "gives up":
        monkeypatch.setattr(compiled, "_MAX_STEPS", 40)
        monkeypatch.setattr(compiled, "_STEPS_PER_FRAME", 1)
    solution = prepared.solve(Silence())
    fields, nodes = whole_span_fields(scene, prepared, solution), node_positions(prepared.graph, rest_length(scene))[0]
    if case == "drifts":
        fields["energy_dissipated"] = 1.2 * fields["energy_dissipated"]
    if case.startswith("necks"):
        fields["stretch"][-1, [0, -1]] += 3.0
    residual = energy_residual(fields, min_energy(scene))
    expected, message = verdict(scene, effects, solution, fields, nodes, residual)
    code = next((code for code, one in compiled.OUTCOMES.items() if one is solution.outcome), 0)
    seen = midpoint_extremes(scene, prepared, solution)
    run = {
        "code": code,
        "steps": solution.steps,
        "message": solution.message,
        "time": solution.time * time_scale(scene),
        "X_node": nodes,
        "fields": fields,
        "extremes": np.stack([seen.time, seen.height, seen.area], axis=1).ravel(),
        "yielded": has_yielded(prepared, solution),
    }
    judged = evaluated("judge(given.data, ownState(given.data), unlisted(given.run))", data=data, run=run)
    said = judged["verdict"]
    assert (expected.name, said["outcome"], said["advice"]) == (outcome, outcome, expected.value)
    if case == "breaks":
        # The instant between two frames is by a straight line, not by a curve through all.
        assert said["message"].split()[6:] == message.split()[6:]
    else:
        assert said["message"] == message
    sound = rupture_frame(scene, fields["stretch"]) if expected is Outcome.ruptured else len(solution.time)
    assert case == "breaks" or len(judged["time"]) == sound
    assert judged["residual"] == pytest.approx(residual, rel=1e-9)
    assert said["is_success"] is expected.is_success
    ours = judge(scene, effects, prepared, solution, {})
    if case not in ("drifts", "necks", "necks in one cell"):  # what is spoilt here it has not seen
        assert ours.summary["regime"] == regime
        np.testing.assert_allclose([one[:2] for one in judged["extremes"][1:-1]][:25], ours.summary["extremes"][:25])
    assert said["regime"] == regime
    told = ours.summary["warnings"]
    assert [text for text in said["warnings"] if not text.startswith(("too thick", "it never stops"))] == told


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
