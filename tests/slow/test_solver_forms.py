"""The table of the solver's forms: digits against `softcat run`, memory, code and time; ``pytest -s`` prints it."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen import forms
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.effects.selection import choose_effects
from softcat_sym.generation import export, generate
from softcat_sym.web.module import find_wasm_compiler, wasm_module

ROOT = Path(__file__).parents[2]
PROGRAM = ROOT / "tests/common/programs/static.c"
COARSE = {"numerics.cells": 10, "numerics.estimate": False, "run.frames": 31}
SCENES: Mapping[str, tuple[str, dict[str, object]]] = {
    "elastic": ("stretched-rubber-band", {}),
    "ink with surface tension": (
        "arrested-overdamped",
        {"numerics.fibres": 4, "surroundings.surface_tension": "0.05 N/m"},
    ),
    "cooling glass": (str(ROOT / "generated/examples/furnace.toml"), {"temperature.ambient": "600 degC"}),
    "three dimensions": ("wrung-thread", {}),
}


def code_of(library: Path) -> int:
    """Bytes of code and constants."""
    tool = shutil.which("size")
    if tool is None:
        return library.stat().st_size
    return int(subprocess.run([tool, str(library)], capture_output=True, text=True, check=True).stdout.split()[6])


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_every_form_gives_the_digits_of_a_run(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Library, fixed memory, FMU and Python to 1e-9 of the largest height; no message of FMPy's validation."""
    fmpy, compiler = pytest.importorskip("fmpy"), find_compiler()
    if compiler is None:
        pytest.skip("no C compiler here")
    from fmpy.validation import validate_fmu

    here = {platform: target for platform, target in forms.TARGETS.items() if platform == forms._platform()}
    monkeypatch.setattr(forms, "TARGETS", here)
    scene = sc.load_scene(SCENES[name][0], {**COARSE, **SCENES[name][1]})
    # Those of the first choice: a run would take in what it finds to matter.
    scene = scene.replace({"run.effects": list(choose_effects(scene).names)})
    generate(scene, tmp_path, forms=("static", "fmu"))
    heights = sc.simulate(scene).data.midpoint.values
    duration, scale = scene.run.duration, float(np.max(np.abs(heights)))
    spec = importlib.util.spec_from_file_location("filament", tmp_path / "filament.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    times, library = np.linspace(0.0, duration, len(heights)), module.build()
    rows = {}

    def measured(form: str, call: Callable[[], Any], ram: int, code: int) -> None:
        begun = time.process_time()
        found = np.asarray(call())
        seconds = time.process_time() - begun
        rows[form] = (float(np.max(np.abs(found - heights)) / scale), ram, code, 1e6 * seconds / steps)

    built = [path for path in tmp_path.glob("*.c") if path.name not in ("main.c", "softcat_text.c")]
    program = tmp_path / "static"
    command = [*compiler.command, "-std=c99", "-O2", f"-I{tmp_path}", str(PROGRAM), *map(str, built), "-lm"]
    subprocess.run([*command, "-o", str(program)], check=True)
    said = subprocess.run([str(program), str(len(heights))], capture_output=True, text=True, check=True).stdout.split()
    *static, steps, per_step, ram = map(float, said)
    code = code_of(library)
    error = float(np.max(np.abs(np.array(static) - heights)) / scale)
    rows["static"] = (error, int(ram), code, per_step)
    whole, stepped = module.Filament(library=library), module.Filament(library=library)
    workspace = whole._library.softcat_workspace_size(10, len(times), None)
    measured("library", lambda: whole.run(times), workspace, code)
    stepped.begin(duration)
    measured("ctypes", lambda: [stepped.step(one) for one in times], stepped._memory.nbytes, code)
    fmu = str(tmp_path / "filament.fmu")
    assert validate_fmu(fmu) == []
    where = fmpy.extract(fmu, str(tmp_path / "fmu"))
    binary = next(Path(where).glob("binaries/*/*"))
    asked = {"stop_time": duration, "output_interval": duration / (len(times) - 1)}
    measured("FMU", lambda: fmpy.simulate_fmu(where, **asked)["midpoint"], int(ram), code_of(binary))
    print(f"\n{name}\n| form | against softcat run | RAM [B] | code [B] | us a step |\n|---|---|---|---|---|")
    for form, (error, bytes_, size, microseconds) in rows.items():
        print(f"| {form} | {error:.1e} | {bytes_} | {size} | {microseconds:.1f} |")
        assert error < 1e-9, (name, form)
    if name == "elastic" and find_wasm_compiler() is not None:
        # Its digits are held in tests/test_web_module.py to the accuracy: sums are taken there in any order.
        print(f"| WASM | in a browser | | {len(wasm_module(export(scene)[0]))} | |")
