"""Files, units, and TOML there and back."""

from __future__ import annotations

import copy
import math
import os
import pickle
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from softcat_sym.errors import SceneError
from softcat_sym.scene.bundled import bundled_names, bundled_text
from softcat_sym.scene.parts import Filament
from softcat_sym.scene.reading import as_scene, load_scene
from softcat_sym.scene.scene import Scene

from .tables import BINGHAM, faults_of, refused, spoiled


@pytest.mark.parametrize(
    ("content", "says"),
    [
        (b"", "the file is empty"),
        (b"# nothing but a comment\n\n", "the file is empty"),
        (b"[filament]\nspan = 0.2 m\n", "not TOML: "),
        (b"[filament]\nspan = 0.2 m\n", "line 2"),
        (b"span\n", "not TOML"),
        (b"a = 1\na = 2\n", "not TOML"),
        (b'title = "\xff"\n', "not UTF-8 text (line 1)"),
        (b"a = " + b"9" * 5000, "not TOML"),
        (b"a = " + b"[" * 20000, "not TOML"),
        (b"#" * 2_000_000, "longer than 1 MiB"),
        (b"\x00\x01", "not TOML"),
    ],
)
def test_a_bad_file_is_one_clear_error(tmp_path: Path, content: bytes, says: str) -> None:
    path = tmp_path / "scene.toml"
    path.write_bytes(content)
    text = refused(path)
    assert says in text
    assert str(path) in text


def test_a_missing_file_names_the_nearest_scene() -> None:
    assert "did you mean 'arrested-overdamped'?" in refused("arested-overdamped")
    assert "did you mean 'no-yield'?" in refused("scenes/noyield.toml")
    assert all(name in refused("zzz") for name in bundled_names())


def test_a_directory_and_other_unreadable_things(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert "a directory, not a file" in refused(tmp_path)
    assert "cannot be read" in refused("nul\0character")
    assert "cannot be read" in refused("x" * 5000)

    def forbidden(*_: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(os, "open", forbidden)
    assert "cannot be read: Permission denied" in refused(tmp_path / "secret.toml")


def test_a_bundled_scene_is_found_by_name_and_a_file_by_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("no-yield").write_text("")
    assert load_scene("no-yield").title
    assert "empty" in refused("./no-yield")
    marked = tmp_path / "marked.toml"
    marked.write_bytes(b"\xef\xbb\xbf" + bundled_text("no-yield").replace("\n", "\r\n").encode())
    assert load_scene(str(marked)) == load_scene("no-yield")


def test_shear_data_are_converted_and_said() -> None:
    sheared = spoiled(
        {
            "material.viscosity": None,
            "material.yield_stress": None,
            "material.shear_viscosity": "10 Pa*s",
            "material.shear_yield_stress": "200 Pa",
        }
    )
    scene = Scene.model_validate(sheared)
    assert scene.material.viscosity == 30.0
    assert scene.material.yield_stress == pytest.approx(200 * math.sqrt(3))
    assert scene.material.notes == (
        "viscosity 10 Pa s in shear = 30 Pa s in tension, times 3",
        "yield stress 200 Pa in shear = 346.41 Pa in tension, times sqrt(3)",
    )
    text = scene.to_toml()
    assert all(f"# {note}" in text for note in scene.material.notes)
    assert not any(line.startswith("shear_") for line in text.splitlines())
    assert scene.replace({"numerics.cells": 9}).material.notes == scene.material.notes
    again = scene.replace({"material.viscosity": "7 Pa*s"})
    assert (again.material.viscosity, len(again.material.notes)) == (7.0, 1)


def test_millimetres_and_metres_are_the_same_scene() -> None:
    metres = spoiled({"filament.span": "0.2 m", "filament.thickness": "0.006 m", "run.duration": "2 s"})
    millimetres = spoiled({"filament.span": "200 mm", "filament.thickness": "6 mm", "run.duration": "2000 ms"})
    other = spoiled({"material.youngs_modulus": "4 N/mm^2", "filament.density": "1.9 g/cm³"})
    assert Scene.model_validate(metres) == Scene.model_validate(millimetres) == Scene.model_validate(other)
    assert Scene.model_validate(metres).to_toml() == Scene.model_validate(millimetres).to_toml()


@given(st.floats(1e-3, 1e3), st.floats(1e-6, 0.9))
@settings(deadline=None)
def test_millimetres_and_metres_agree_to_rounding(span: float, slenderness: float) -> None:
    thickness = span * slenderness
    here = spoiled({"filament.span": f"{span!r} m", "filament.thickness": f"{thickness!r} m"})
    there = spoiled({"filament.span": f"{span * 1e3!r} mm", "filament.thickness": f"{thickness * 1e3!r} mm"})
    one, two = Scene.model_validate(here).filament, Scene.model_validate(there).filament
    assert (one.span, one.thickness) == pytest.approx((two.span, two.thickness), rel=1e-14)


def test_python_values() -> None:
    ureg = pint.UnitRegistry()
    table = spoiled(
        {
            "filament.span": ureg.Quantity(200, "mm"),
            "filament.thickness": ureg.Quantity(np.float64(6.0), "mm"),
            "run.frames": np.int64(201),
            "run.accuracy": np.float32(0.5),
            "ends.left_angle": "0 deg",
        }
    )
    before = copy.deepcopy(table)
    scene = Scene.model_validate(table)
    assert table == before
    assert scene.replace({"run.accuracy": 0.01}) == Scene.model_validate(BINGHAM)
    assert type(scene.filament.thickness) is float
    assert type(scene.run.frames) is int
    assert Scene.model_validate(scene) is scene
    parts = {name: getattr(scene, name) for name in ("filament", "material", "run")}
    assert Scene.model_validate(parts) == scene
    assert Scene(**parts) == scene
    assert isinstance(parts["filament"], Filament)
    assert pickle.loads(pickle.dumps(scene)) == scene
    with pytest.raises(ValueError, match="frozen"):
        scene.filament.span = 1.0  # type: ignore[misc]


def in_three_forms(ureg: pint.UnitRegistry[float]) -> list[dict[str, Any]]:
    """A scene with numbers in SI, text with units, and pint quantities: a consistency, modes and a path among them."""
    values: dict[str, Any] = {
        "filament.span": (0.2, "m"),
        "filament.thickness": (0.006, "m"),
        "filament.density": (1900, "kg/m^3"),
        "material.youngs_modulus": (4e6, "Pa"),
        "material.yield_stress": (9320.0, "Pa"),
        "material.shear_consistency": (120.0, "Pa*s^0.5"),
        "run.duration": (2, "s"),
    }
    forms = []
    for write in (lambda n, _: n, lambda n, unit: f"{n!r} {unit}", lambda n, unit: ureg.Quantity(n, unit)):
        table = spoiled({key: write(*value) for key, value in values.items()}, {})
        table["material"] |= {"law": "herschel-bulkley", "index": 0.5}
        table["ends"] = {"motion": [[write(t, "s"), write(dx, "m"), write(0, "m")] for t, dx in ((0, 0), (1.0, 0.01))]}
        forms.append(table)
    return forms


def test_numbers_in_si_text_and_pint_quantities_give_the_same_scene() -> None:
    number, text, quantity = in_three_forms(pint.UnitRegistry())
    scene = Scene.model_validate(text)
    assert scene.to_toml() == Scene(**number).to_toml() == Scene(**text).to_toml() == Scene(**quantity).to_toml()
    assert scene == Scene.from_dict(number) == Scene.from_dict(text) == Scene.from_dict(quantity) == as_scene(number)
    modes = {"law": "multimode-maxwell", "modes": [{"youngs_modulus": 1e6, "viscosity": 2000}]}
    units = {"law": "multimode-maxwell", "modes": [{"youngs_modulus": "1 MPa", "viscosity": "2 kPa*s"}]}
    assert Scene(**number | {"material": modes}) == Scene.model_validate(text | {"material": units})
    grouped = {"groups": {"delta": 0.03, "law": "elastic", "E_star": 1000.0}, "filament": {"span": 0.3}}
    assert Scene(**grouped, run={"duration": 2}).filament.thickness == pytest.approx(0.009)


def test_bad_numbers_of_python_are_refused_and_a_file_still_needs_units() -> None:
    number, text, _ = in_three_forms(pint.UnitRegistry())
    number["filament"] |= {"span": -1, "thickness": math.nan, "density": True, "spam": 1.0}
    number["material"]["shear_consistency"] = 10**400
    with pytest.raises(SceneError) as caught:
        Scene(**number)
    found = {fault.path: fault.found for fault in caught.value.faults}
    assert found == {
        "filament.span": "-1.0 is negative",
        "filament.thickness": "nan is not finite",
        "filament.density": "true is not a quantity",
        "filament.spam": "unknown key (did you mean 'span'?)",
        "material.shear_consistency": "inf is not finite",
    }
    text["filament"]["span"] = 0.2
    assert [fault.found for fault in faults_of(text)] == ["0.2 has no unit"]
    with pytest.raises(SceneError, match="is not a table"):
        Scene.from_dict([1])  # type: ignore[arg-type]


positive = st.floats(1e-12, 1e12)


@st.composite
def tables(draw: st.DrawFn) -> dict[str, Any]:
    span = draw(positive)
    law = draw(st.sampled_from(["elastic", "maxwell", "bingham"]))
    constants: dict[str, Any] = {"youngs_modulus": f"{draw(positive)!r} {draw(st.sampled_from(['Pa', 'kPa', 'psi']))}"}
    if law != "elastic":
        constants[draw(st.sampled_from(["viscosity", "shear_viscosity"]))] = f"{draw(positive)!r} cP"
    if law == "bingham":
        constants[draw(st.sampled_from(["yield_stress", "shear_yield_stress"]))] = f"{draw(positive)!r} mbar"
    section = draw(st.sampled_from(["rectangle", "circle"]))
    filament = {
        "span": f"{span!r} m",
        "thickness": f"{span * draw(st.floats(1e-6, 0.99))!r} m",
        "density": f"{draw(positive)!r} g/cm^3",
        "section": section,
    }
    if section == "rectangle" and draw(st.booleans()):
        filament["width"] = f"{draw(positive)!r} inch"
    end = st.sampled_from(["clamped", "pinned"])
    words = st.sampled_from(["auto", "paper"])
    some = st.just(0.0) | st.floats(1e-6, 1e6)
    numerics: dict[str, Any] = {"cells": 40, "rtol": 1e-7, "solver": "idas", "order": 1, "backend": "interpreted"}
    return {
        "title": draw(st.text(st.characters(exclude_categories=("Cs", "Cc")), max_size=20)),
        "filament": filament,
        "material": {"law": law} | constants,
        "ends": {"left": draw(end), "right": draw(end)},
        "load": {"gravity": f"{draw(some)!r} m/s^2", "ramp": f"{draw(some)!r} min"},
        "surroundings": {"surface_tension": f"{draw(some)!r} mN/m"},
        "run": {
            "duration": f"{draw(positive)!r} hour",
            "frames": draw(st.integers(2, 1000)),
            "accuracy": draw(st.floats(1e-12, 0.999)),
            "effects": draw(words | st.lists(st.text(max_size=5), min_size=1, max_size=3, unique=True)),
            "closure": draw(st.sampled_from(["material", "printed"])),
        },
        "numerics": draw(st.fixed_dictionaries({}, optional={key: st.just(value) for key, value in numerics.items()})),
    }


@given(tables())
@settings(max_examples=200, deadline=None)
def test_toml_there_and_back_is_the_identity(table: dict[str, Any]) -> None:
    scene = Scene.model_validate(table)
    text = scene.to_toml()
    again = Scene.model_validate(tomllib.loads(text))
    assert again == scene
    assert hash(again) == hash(scene)
    assert scene.replace({}) == scene


@pytest.mark.parametrize("name", bundled_names())
def test_a_bundled_scene_there_and_back(name: str, tmp_path: Path) -> None:
    scene = load_scene(name)
    path = tmp_path / "scene.toml"
    path.write_text(scene.to_toml(), encoding="utf-8")
    assert load_scene(path) == scene
    # What follows another value still follows it in the resolved file.
    assert load_scene(path, ["filament.thickness=0.1 mm"]).filament.width == 1e-4


def test_the_import_is_light() -> None:
    heavy = "{'sympy', 'casadi', 'matplotlib', 'xarray', 'pint', 'scipy'}"
    code = f"import sys, softcat_sym.scene; sys.exit(', '.join({heavy} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stderr.strip() == ""
