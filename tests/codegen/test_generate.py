"""What ``generate`` writes: the files, their text, and that it is the same every time."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.codegen.interface import comment, quoted
from softcat_sym.errors import SceneError, SoftcatError

OWN = {"filament.c", "filament.h", "manifest.json", "main.c", "Makefile", "CMakeLists.txt", "README.md"}
OWN |= {"parameters.txt", "scene.toml"}
TEXT = """
import hashlib
from softcat_sym.generation import contents_of
from softcat_sym.scene.reading import load_scene
for name in ("no-yield", "slime-slope"):
    files = contents_of(load_scene(name), "filament", rhs=name == "no-yield")
    for file, text in sorted(files.items()):
        if file != "start.csv":
            print(file, hashlib.sha256(text.encode()).hexdigest())
"""


def test_the_folder_holds_all_that_a_build_needs(tmp_path: Path) -> None:
    written = sc.generate(sc.load_scene("no-yield"), tmp_path / "deep" / "out")
    names = {path.name for path in written}
    assert names >= OWN and "start.csv" not in names and "softcat_rhs.c" not in names
    assert {path.name for path in (tmp_path / "deep" / "out").iterdir()} == names
    for name in names:
        text = (tmp_path / "deep" / "out" / name).read_text(encoding="utf-8")
        assert "@" not in text.replace("$@", "") or name == "scene.toml", name
    for header in [name for name in names if name.endswith(".h")]:
        text = (tmp_path / "deep" / "out" / header).read_text()
        for included in [line.split('"')[1] for line in text.splitlines() if line.startswith('#include "')]:
            assert included in names
    assert sc.load_scene(tmp_path / "deep" / "out" / "scene.toml") == sc.load_scene("no-yield")


def test_written_again_from_its_own_scene_it_is_the_same(tmp_path: Path) -> None:
    sc.generate(sc.load_scene("no-yield"), tmp_path / "one")
    sc.generate(sc.load_scene(tmp_path / "one" / "scene.toml"), tmp_path / "two")
    for path in (tmp_path / "one").iterdir():
        assert (tmp_path / "two" / path.name).read_bytes() == path.read_bytes(), path.name


@pytest.mark.slow
def test_the_text_does_not_depend_on_the_hash_seed() -> None:
    found = set()
    for seed in ("1", "4711"):
        command = [sys.executable, "-c", TEXT]
        environment = {"PYTHONHASHSEED": seed, "OMP_NUM_THREADS": "1", "PATH": ""}
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment)
        assert done.returncode == 0, done.stderr
        found.add(done.stdout)
    assert len(found) == 1


def test_the_manifest_says_what_it_is(tmp_path: Path) -> None:
    scene = sc.load_scene("transient-gel")
    sc.generate(scene, tmp_path)
    manifest = json.loads((tmp_path / "manifest.json").read_text(encoding="utf-8"))
    structure, units = manifest["structure"], {one["name"]: one["unit"] for one in manifest["parameters"]}
    assert (structure["law"], structure["section"], structure["theory"]) == ("custom", "circle", "reissner")
    assert structure["ends"] == ["plane of symmetry", "clamped"]
    # Those of the user's own law, too.
    assert (units["s0"], units["t0"], units["youngs_modulus"]) == ("kg/m/s^2", "s", "Pa") or units["s0"] == "Pa"
    assert "shear" in structure["effects"]
    assert manifest["sizes"]["bytes_of_text"] < 200_000
    assert [one["kind"] for one in manifest["unknowns"]][:2] == ["differential", "differential"]
    lines = (tmp_path / "parameters.txt").read_text().splitlines()
    listed = [line.split(" ")[0] for line in lines if " = " in line and not line.startswith("#")]
    assert listed[: len(units)] == list(units)


def test_a_consistency_has_its_own_unit_and_a_bent_scene_its_start(tmp_path: Path) -> None:
    sc.generate(sc.load_scene("oobleck"), tmp_path / "power")
    assert "Pa*s^n" in (tmp_path / "power" / "parameters.txt").read_text()
    sc.generate(sc.load_scene("slime-slope", ["numerics.cells=6"]), tmp_path / "bent")
    heading, first, *_, last = (tmp_path / "bent" / "start.csv").read_text().splitlines()
    assert heading.startswith("X,x,y,u,v,psi,omega,axial_0")
    assert first.startswith("-0.5,") and last.startswith("0.5,")
    # What the supports hold stands there, too.
    drop = sc.load_scene("slime-slope").ends.drop
    length = float(
        next(
            line
            for line in (tmp_path / "bent" / "parameters.txt").read_text().splitlines()
            if line.startswith("rest_length")
        ).split()[2]
    )
    assert float(last.split(",")[2]) == pytest.approx(-drop / length, rel=1e-12)


def test_the_plain_right_hand_side_comes_on_request(tmp_path: Path) -> None:
    sc.generate(sc.load_scene("no-yield", ["numerics.cells=4"]), tmp_path, rhs=True)
    assert {"softcat_rhs.c", "softcat_rhs.h"} <= {path.name for path in tmp_path.iterdir()}
    assert "Your own integrator" in (tmp_path / "README.md").read_text()


def test_a_name_goes_through_all_files(tmp_path: Path) -> None:
    sc.generate(sc.load_scene("glass-rod"), tmp_path, name="rod")
    source, header = (tmp_path / "rod.c").read_text(), (tmp_path / "rod.h").read_text()
    assert "const softcat_model rod_model" in source and "int rod_solve(" in header
    assert "ROD_P_THICKNESS" in header
    assert '#include "rod.h"' in (tmp_path / "main.c").read_text()
    assert "rod_structure" in (tmp_path / "main.c").read_text()


@pytest.mark.parametrize("name", ["", "Rod", "9rod", "main", "softcat_band", "a" * 41, "rod/../x", "rod.c", "all"])
def test_a_name_that_is_no_name_is_refused(name: str, tmp_path: Path) -> None:
    with pytest.raises(SoftcatError, match="small letters"):
        sc.generate(sc.load_scene("glass-rod"), tmp_path / "out", name=name)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("name", "changes", "where"),
    [
        ("maxwell-slow", ["model=small-deflection"], "model"),
        (
            "stretched-rubber-band",
            ["run.effects=['bending', 'extensibility', 'finite-stretch', 'thinning']"],
            "run.effects",
        ),
    ],
)
def test_what_has_no_compiled_form_is_refused(name: str, changes: list[str], where: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError) as refused:
        sc.generate(sc.load_scene(name, changes), tmp_path / "out")
    assert refused.value.faults[0].path == where
    assert not (tmp_path / "out").exists()


def test_no_title_ends_a_comment_or_a_string() -> None:
    text = 'a */ b /* c ??/ "d" \\ \n é'
    assert comment([text]).count("*/") == 1
    assert "??/" not in comment([text])
    assert quoted(text) == '"a */ b /* c \\?\\?/ \\"d\\" \\\\ \\012 \\303\\251"'
