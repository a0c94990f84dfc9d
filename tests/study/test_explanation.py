"""What is told of a scene before it runs is what the run then has."""

from __future__ import annotations

import dataclasses
import io
import json
import re
import tomllib
from pathlib import Path

import pytest
from rich.console import Console

import softcat_sym as sc
from softcat_sym.plotting.explain import article, print_explanation, write_explanation
from softcat_sym.studies.explanation import Explanation, explain

SCENES = ["no-yield", "cold-honey", "thermoforming-sheet", "cooked-spaghetti"]


def printed(explanation: Explanation, width: int = 150) -> str:
    out = io.StringIO()
    print_explanation(explanation, Console(file=out, width=width), verbose=True)
    return out.getvalue()


@pytest.mark.parametrize("name", ["no-yield", "cold-honey"])
def test_it_tells_what_the_run_then_has(name: str) -> None:
    scene = sc.load_scene(name, ["numerics.cells=6", "run.frames=3"])
    told, done = explain(scene), sc.simulate(scene)
    assert set(told.in_force) == set(done.summary["effects"])
    assert told.integrator.solver == done.summary["solver"]
    assert told.integrator.rtol == done.summary["rtol"]
    assert told.graph.cells == done.summary["cells"]


@pytest.mark.parametrize("name", SCENES)
def test_unknowns_add_up_and_parameters_are_the_scene_s(name: str) -> None:
    scene = sc.load_scene(name, ["numerics.cells=8"])
    told = explain(scene)
    for algebraic, total in ((False, told.graph.differential), (True, told.graph.algebraic)):
        assert sum(kind.number for kind in told.unknowns if kind.algebraic is algebraic) == total
    assert all(kind.meaning for kind in told.unknowns)
    parameters = dict(told.graph.parameters)
    assert parameters["density"] == scene.filament.density
    assert parameters["thickness"] == scene.filament.thickness


def test_fibres_are_one_kind_of_unknown() -> None:
    listed = "run.effects=paper"
    plain = explain(sc.load_scene("arrested-overdamped", [listed, "numerics.cells=8"]))
    fibres = explain(sc.load_scene("arrested-overdamped", [listed, "numerics.cells=8", "numerics.fibres=5"]))
    assert {kind.kind for kind in plain.unknowns} == {"x", "y", "u", "v", "a_0", "a_1"}
    (axial,) = [kind for kind in fibres.unknowns if kind.kind == "axial"]
    assert axial.number == 5 * 8
    assert "fibres" in fibres.in_force
    assert fibres.graph.instructions > plain.graph.instructions


def test_an_absent_effect_takes_its_parameters_along() -> None:
    flowing = explain(sc.load_scene("arrested-overdamped", ["run.effects=paper", "numerics.cells=8"]))
    elastic = explain(sc.load_scene("arrested-overdamped", ['run.effects=["inertia", "bending"]', "numerics.cells=8"]))
    gone = {"viscosity", "yield_stress", "ramp"}
    assert gone <= dict(flowing.graph.parameters).keys()
    assert not gone & dict(elastic.graph.parameters).keys()
    assert elastic.graph.instructions < flowing.graph.instructions
    assert {"y", "v"} == {kind.kind for kind in elastic.unknowns}
    assert not any(re.search(r"\b(eta|sigma_Y|g_on|T|Q)\b", equation.text) for equation in elastic.equations)


def test_every_effect_is_told_with_its_reason() -> None:
    from softcat_sym.effects.registry import REGISTRY

    told = explain(sc.load_scene("no-yield", ["numerics.cells=8"]))
    assert [decided.effect for decided in told.effects] == [effect.name for effect in REGISTRY]
    assert all(decided.reason and decided.summary for decided in told.effects)
    text = printed(told)
    assert all(decided.effect in text for decided in told.effects)


def test_it_is_frozen_plain_data() -> None:
    told = explain(sc.load_scene("cold-honey", ["numerics.cells=6"]))
    with pytest.raises(dataclasses.FrozenInstanceError):
        told.title = ""  # type: ignore[misc]
    again = json.loads(json.dumps(told.as_dict(), allow_nan=False))
    assert again["regime"]["name"] == told.regime.name
    assert again["graph"]["parameters"] == dict(told.graph.parameters)


def test_without_gravity_groups_are_infinite_and_still_told(tmp_path: Path) -> None:
    scene = sc.load_scene("stretched-rubber-band", ["numerics.cells=6", "load.gravity=0 m/s^2"])
    told = explain(scene)
    assert {group.name: group.value for group in told.groups}["E_star"] is None
    assert "infinite" in printed(told)
    write_explanation(told, scene, tmp_path)


def test_files(tmp_path: Path) -> None:
    scene = sc.load_scene("no-yield", ["numerics.cells=6", "title=50 % of {braces} & [red]_markup_ \\ $"])
    told = explain(scene)
    files = write_explanation(told, scene, tmp_path / "new")
    assert [path.name for path in files] == ["explain.json", "equations.tex", "scene.toml"]
    assert json.loads(files[0].read_text())["title"] == scene.title
    assert sc.Scene.model_validate(tomllib.loads(files[2].read_text())) == scene
    tex = files[1].read_text()
    assert tex.startswith(r"\documentclass")
    assert tex.rstrip().endswith(r"\end{document}")
    assert tex.count(r"\begin{equation*}") == tex.count(r"\end{equation*}") == len(told.equations)
    plain = tex.replace(r"\{", "").replace(r"\}", "")
    assert plain.count("{") == plain.count("}")
    assert r"50 \% of \{braces\} \& [red]\_markup\_ \textbackslash{} \$" in tex
    assert scene.title in printed(told)


def test_an_article_says_which_effects_are_in_force() -> None:
    assert "Effects in force: none." in article("", (), ())


@pytest.mark.slow
@pytest.mark.parametrize("name", sc.bundled_names())
def test_every_bundled_scene_is_explained(name: str) -> None:
    told = explain(sc.load_scene(name))
    assert told.regime.reason
    assert told.equations
    assert printed(told, 100)


def test_what_rings_long_is_told_beforehand_and_what_to_do_about_it() -> None:
    changes = {"run.duration": "60 s", "run.accuracy": 0.01}
    undamped = explain(sc.load_scene("agar-bar", {**changes, "material.loss_tangent": 0.0}))
    assert undamped.ringing.startswith("rings some 619 periods of 0.097 s: about ")
    assert undamped.ringing.endswith("set load.ramp or material.loss_tangent")
    assert undamped.damping == ""
    damped = explain(sc.load_scene("agar-bar", changes))
    assert damped.damping.startswith(
        "first natural frequency 10.31 Hz; loss tangent 0.05 -> solid viscosity 34.49 Pa s"
    )
    assert "rings some" in damped.ringing
    assert "set load.ramp" not in damped.ringing
    assert explain(sc.load_scene("cold-honey")).ringing == ""
