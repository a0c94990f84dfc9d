"""Overrides from the command line, and replacements in Python."""

from __future__ import annotations

import math

import pytest

from softcat_sym.errors import SceneError
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene

from .tables import BINGHAM, refused


def test_overrides_are_toml_or_text() -> None:
    texts = ["run.effects=paper", "numerics.cells=40", "groups.G=0.3", "title = a = b", "run.closure='printed'"]
    scene = load_scene("arrested-overdamped", texts)
    assert (scene.run.effects, scene.numerics.cells, scene.title) == ("paper", 40, "a = b")
    assert scene.run.closure == "printed"
    assert scene.material.yield_stress == pytest.approx(1900 * 9.81 * 0.2 / 0.3)
    assert scene == load_scene(
        "arrested-overdamped",
        dict(text.split("=", 1) for text in texts[:3])
        | {
            "title": "a = b",
            "run.closure": "printed",
        },
    )
    listed = load_scene("no-yield", ['run.effects=["inertia", "bending"]'])
    assert listed.run.effects == ("inertia", "bending")


def test_an_override_wins_over_groups() -> None:
    for override, path, si in [
        ("material.yield_stress=5 kPa", "material.yield_stress", 5e3),
        ("material.shear_yield_stress=5 kPa", "material.yield_stress", math.sqrt(3) * 5e3),
        ("material.viscosity=5 kPa*s", "material.viscosity", 5e3),
        ("material.youngs_modulus=5 MPa", "material.youngs_modulus", 5e6),
        ("filament.thickness=2 mm", "filament.thickness", 2e-3),
        ("filament.thickness=2 mm", "filament.width", 2e-3),
        ("filament.span=0.1 m", "filament.thickness", 3e-3),
        ("material.poisson=0.3", "material.poisson", 0.3),
        ("run.duration=3 s", "run.duration", 3.0),
        ("load.ramp=3 s", "load.ramp", 3.0),
    ]:
        part, _, name = path.partition(".")
        assert getattr(getattr(load_scene("arrested-overdamped", [override]), part), name) == pytest.approx(si)


def test_an_override_of_the_law_must_fit() -> None:
    with pytest.raises(SceneError) as caught:
        load_scene("arrested-overdamped", ["material.law=maxwell"])
    assert [fault.path for fault in caught.value.faults] == ["material.yield_stress"]
    assert load_scene("ink-bridge", ["material.viscosity=1 Pa*s"]).material.viscosity == 1.0


def test_a_bad_override_is_one_clear_error() -> None:
    for override, says in [
        ("numerics.cells", "--set: 'numerics.cells' sets nothing"),
        ("=3", "--set: '=3' sets nothing"),
        ("numerics..cells=3", "leads to no key"),
        ("title.x=3", "title.x: leads to no key"),
        ("run.duration=2", "run.duration: 2 has no unit"),
        ("run.duraton=2 s", "run.duraton: unknown key (did you mean 'duration'?)"),
        ("numerics.cells=4\n[x]", "numerics.cells: '4\\n[x]' is not a whole number"),
        ("run.accuracy=nan", "run.accuracy: nan is not finite"),
        ("groups.V=-1", "groups.V: -1 is out of range"),
        ("nosuch.table=1", "nosuch: unknown key"),
    ]:
        assert says in refused("arrested-overdamped", [override])


def test_faults_of_overrides_and_file_come_together() -> None:
    with pytest.raises(SceneError) as caught:
        load_scene("no-yield", ["nonsense", "run.frames=1", "groups.B=3"])
    assert [fault.path for fault in caught.value.faults] == ["--set", "groups.B", "run.frames"]


def test_replace() -> None:
    scene = Scene.model_validate(BINGHAM)
    other = scene.replace({"numerics.cells": 40, "material.yield_stress": "5 kPa", "filament.thickness": "3 mm"})
    assert (other.numerics.cells, other.material.yield_stress, other.filament.width) == (40, 5e3, 3e-3)
    assert scene.numerics.cells is None
    assert other.replace({"numerics.cells": None}).numerics.cells is None
    assert scene.replace({}) == scene
    assert hash(scene.replace({})) == hash(scene)
    assert scene != other
    with pytest.raises(SceneError, match="a resolved scene has no groups"):
        scene.replace({"groups.G": 0.3})
    with pytest.raises(SceneError, match="unknown key"):
        scene.replace({"numerics.cell": 40})


def test_an_empty_table_is_the_defaults_in_python() -> None:
    fine = load_scene("no-yield", {"numerics.cells": 40})
    assert fine.replace({"numerics": {}}) == load_scene("no-yield", {"numerics": {}}) == load_scene("no-yield")


def test_an_empty_table_is_no_value() -> None:
    assert "run: an empty table, which would drop every key" in refused("no-yield", ["run={}"])
