"""Bad input: one clear error each, exit status 2, and nothing written."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

GOOD = """
[filament]
span = "0.2 m"
thickness = "6 mm"
density = "1900 kg/m^3"
[material]
law = "bingham"
youngs_modulus = "4 MPa"
viscosity = "13.84 kPa*s"
yield_stress = "9.32 kPa"
[run]
duration = "2 s"
"""


def changed(old: str, new: str) -> bytes:
    assert old in GOOD
    return GOOD.replace(old, new).encode()


CASES: dict[str, tuple[bytes | None, str]] = {
    "unknown key": (changed("[run]", '[run]\ncolour = "red"'), "run.colour"),
    "misspelt key": (changed("thickness =", "thicknes ="), "thickness"),
    "misspelt law": (changed('"bingham"', '"binghan"'), "bingham"),
    "missing unit": (changed('"0.2 m"', "0.2"), "filament.span"),
    "wrong dimension": (changed('"0.2 m"', '"0.2 Pa"'), "filament.span"),
    "negative density": (changed('"1900 kg/m^3"', '"-1900 kg/m^3"'), "filament.density"),
    "zero thickness": (changed('"6 mm"', '"0 mm"'), "filament.thickness"),
    "NaN": (changed('"6 mm"', '"nan mm"'), "filament.thickness"),
    "infinity": (changed('"4 MPa"', '"inf Pa"'), "material.youngs_modulus"),
    "thickness not below span": (changed('"6 mm"', '"0.2 m"'), "filament.thickness"),
    "yield stress missing": (changed('yield_stress = "9.32 kPa"', ""), "material.yield_stress"),
    "yield stress of a law that does not yield": (changed('"bingham"', '"maxwell"'), "material.yield_stress"),
    "duration 0": (changed('"2 s"', '"0 s"'), "run.duration"),
    "frames -3": (changed("[run]", "[run]\nframes = -3"), "run.frames"),
    "unknown effect": (changed("[run]", '[run]\neffects = ["inertia", "magic"]'), "run.effects"),
    "backend": (changed("[run]", '[numerics]\nbackend = "compile"\n[run]'), "numerics.backend"),
    "empty file": (b"", "empty"),
    "not TOML": (b"span == 3 metres", "TOML"),
    "binary": (b"\xff\xfe\x00\x01", "UTF-8"),
    "missing file": (None, "no such"),
}


@pytest.mark.parametrize("case", CASES)
def test_bad_input_is_one_clear_error(case: str, tmp_path: Path) -> None:
    content, named = CASES[case]
    scene, output = tmp_path / "scene.toml", tmp_path / "out"
    if content is not None:
        scene.write_bytes(content)
    done = _softcat("run", str(scene), "-o", str(output))
    print(done.stderr)
    assert done.returncode == 2
    assert named.lower() in done.stderr.lower()
    assert "Traceback" not in done.stderr
    assert done.stdout == ""
    assert not output.exists()


def test_a_directory_is_not_a_scene(tmp_path: Path) -> None:
    done = _softcat("run", str(tmp_path), "-o", str(tmp_path / "out"))
    assert done.returncode == 2
    assert "directory" in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


def test_every_fault_is_listed_at_once(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_bytes(changed('"6 mm"', '"0 mm"').replace(b'"2 s"', b'"0 s"').replace(b'"4 MPa"', b"4"))
    done = _softcat("run", str(scene), "-o", str(tmp_path / "out"))
    assert done.returncode == 2
    assert "3 faults" in done.stderr
    for path in ("filament.thickness", "run.duration", "material.youngs_modulus"):
        assert path in done.stderr


def _softcat(*arguments: str) -> subprocess.CompletedProcess[str]:
    softcat = Path(sys.executable).with_name("softcat")
    return subprocess.run([str(softcat), *arguments], capture_output=True, text=True, check=False)
