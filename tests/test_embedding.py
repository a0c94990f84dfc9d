"""The solver in other people's programs: without a heap, stepped from outside, as FMU, as one file for Python."""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys
import types
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen import forms
from softcat_sym.codegen.compiler import find_compiler, of_a_wheel
from softcat_sym.codegen.export import runtime_files
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SoftcatError
from softcat_sym.generation import generate

ROOT = Path(__file__).parents[1]
STUBS = Path(__file__).with_name("common") / "stubs"
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wconversion", "-Wshadow")
OF_LIBM = """
acos asin atan atan2 ceil cos cosh erf exp expm1 fabs floor fmax fmin hypot log log1p nextafter pow sin sincos sinh sqrt
tan tanh
"""
MEMORY = {"memcpy", "memmove", "memset", "memcmp"}


def compiler() -> list[str]:
    found = find_compiler()
    if found is None:
        assert not os.environ.get("SOFTCAT_TESTS_NEED_A_COMPILER"), "a C compiler is missing"
        pytest.skip("no C compiler here")
    return list(found.command)


def test_the_library_allocates_nothing_and_bounds_its_stack(tmp_path: Path) -> None:
    """Of the runtime and a product: libm and four functions of memory, no other symbol, no data that changes."""
    command, nm = compiler(), shutil.which("nm")
    if nm is None:
        pytest.skip("no nm here")
    for name, text in runtime_files().items():
        (tmp_path / name).write_text(text, encoding="utf-8")
    shutil.copy(ROOT / "generated/arrested-overdamped/filament.c", tmp_path)
    shutil.copy(ROOT / "generated/arrested-overdamped/filament.h", tmp_path)
    bounded = ["-Wstack-usage=4096"] if "gcc" in find_compiler().name else []  # type: ignore[union-attr]
    sources = [path.name for path in sorted(tmp_path.glob("*.c")) if path.name != "softcat_text.c"]
    subprocess.run([*command, *STRICT, *bounded, "-O1", "-fno-pie", "-c", *sources], cwd=tmp_path, check=True)
    objects = [name.replace(".c", ".o") for name in sources]
    said = subprocess.run([nm, *objects], cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    symbols = [line.split() for line in said.splitlines() if line and not line.endswith(":")]
    defined = {words[-1] for words in symbols if len(words) == 3}
    needed = {words[-1] for words in symbols if words[0] in ("U", "w")} - defined
    allowed = set(OF_LIBM.split()) | MEMORY
    assert needed <= allowed | {"_GLOBAL_OFFSET_TABLE_", "__stack_chk_fail"}, needed - allowed
    assert not [words for words in symbols if words[-2] in "BbDdCG"], "a global that can be written"


SMALL = ("numerics.cells=8", "numerics.fibres=4", "run.frames=41", "numerics.estimate=false")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small filament in all forms; of the binaries of its FMU that of this machine alone."""
    compiler()
    out, targets = tmp_path_factory.mktemp("forms"), forms.TARGETS
    here = {platform: target for platform, target in targets.items() if platform == forms._platform()}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(forms, "TARGETS", here)
        generate("arrested-overdamped", out, changes=SMALL, forms=("static", "fmu", "simulink"))
    return out


@pytest.fixture(scope="module")
def heights() -> Floats:
    """What `softcat run` says of it."""
    return sc.simulate(sc.load_scene("arrested-overdamped", SMALL)).data.midpoint.values


def module_of(folder: Path) -> types.ModuleType:
    """Its file for Python, without the package."""
    spec = importlib.util.spec_from_file_location("filament", folder / "filament.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.slow
def test_one_file_of_python_runs_steps_and_comes_back(folder: Path, heights: Floats) -> None:
    """Stepped or run, the digits are those of `softcat run`; what is saved is come back to; nonsense is refused."""
    filament = module_of(folder)
    one = filament.Filament()
    times = np.linspace(0.0, filament.DURATION, len(heights))
    np.testing.assert_allclose(one.run(times), heights, rtol=0, atol=1e-12)
    stepped = [one.step(time) for time in times[:15]]
    saved, params = one.save(), dict(one._values)
    stepped += [one.step(time) for time in times[15:]]
    np.testing.assert_allclose(stepped, heights, rtol=0, atol=1e-12)
    one.load(saved)
    assert one.time == pytest.approx(times[14]) and one._values == params
    assert [one.step(time) for time in times[15:]] == stepped[15:]
    # Into another one, looked at more often: the same to the last digit.
    other = filament.Filament()
    other.load(saved)
    for time in np.linspace(times[14], times[-1], 150):
        other.step(time)
    assert other.step(times[-1]) == stepped[-1] == other.get("midpoint")
    shown = other.outputs()
    assert shown["tension_left"] == shown["tension_right"] > 0 and shown["max_stress"] > 0
    other.begin()
    other.step(0.5 * times[-1])
    other.set(gravity=0.0)
    assert other.step(times[-1]) > 0.95 * stepped[-1], "without weight it springs back"
    for wrong, code in (({"gravity": np.nan}, 100), ({"poisson": 0.5}, 100), ({"rest_length": 0.3}, 100)):
        with pytest.raises(filament.SolverError, match=next(iter(wrong))) as refused:
            other.set(**wrong)
        assert refused.value.code == code
    for time in (0.1, np.nan, -1.0):
        with pytest.raises(filament.SolverError, match="times must be"):
            other.step(time)
    for data in (saved[:-1], np.full_like(saved, np.nan), np.zeros(3)):
        with pytest.raises(filament.SolverError, match="contradicts"):
            other.load(data)
    with pytest.raises(KeyError, match="known: rest_length"):
        other.set(gravitas=1.0)
    with pytest.raises(filament.SolverError, match="cells"):
        filament.Filament(cells=3).begin()
    other.begin(max_steps=2)
    with pytest.raises(filament.SolverError, match="allowed steps"):
        other.step(times[-1])
    assert 0.0 < other.time < times[-1]


@pytest.mark.slow
def test_the_forms_compile_without_a_warning_and_without_a_library_of_c(folder: Path, tmp_path: Path) -> None:
    command = compiler()
    own = [*command, *STRICT, "-O1", f"-I{folder}", f"-I{STUBS}", "-c"]
    for name in ("filament_instance.c", "filament_static.c", "filament_sfun.c"):
        subprocess.run([*own, str(folder / name), "-o", str(tmp_path / "one.o")], check=True)
    solver = [path for path in folder.glob("*.c") if path.name not in ("main.c", "softcat_text.c", "filament_sfun.c")]
    bare = [*command, "-std=c99", "-O1", "-ffreestanding", "-nostdinc", f"-I{STUBS}"]
    found = subprocess.run([*command, "-print-file-name=include"], capture_output=True, text=True, check=True)
    bare += ["-isystem", found.stdout.strip(), "-c", *map(str, solver)]
    subprocess.run(bare, cwd=tmp_path, check=True)


@pytest.mark.slow
def test_the_static_form_compiles_for_a_microcontroller(folder: Path, tmp_path: Path) -> None:
    zig = next(iter(of_a_wheel()), None)
    if zig is None:
        pytest.skip("ziglang is not installed")
    solver = [path for path in folder.glob("*.c") if path.name not in ("main.c", "softcat_text.c", "filament_sfun.c")]
    for source in solver:
        command = [*zig, "-target", "thumb-freestanding-eabihf", "-mcpu=cortex_m7", "-std=c99", "-Os", f"-I{STUBS}"]
        subprocess.run([*command, "-c", str(source), "-o", str(tmp_path / f"{source.stem}.o")], check=True)


def fmpy() -> types.ModuleType:
    """FMPy, of others; skipped loudly without."""
    return pytest.importorskip("fmpy", reason="FMPy is not installed: pip install 'softcat_sym[peers]'")


@pytest.mark.slow
def test_an_fmu_is_valid_and_gives_the_digits_of_a_run(folder: Path, heights: Floats) -> None:
    program = fmpy()
    from fmpy.validation import validate_fmu

    fmu, duration = str(folder / "filament.fmu"), sc.load_scene("arrested-overdamped", SMALL).run.duration
    assert validate_fmu(fmu) == []
    found = program.simulate_fmu(fmu, stop_time=duration, output_interval=duration / (len(heights) - 1))
    np.testing.assert_allclose(found["midpoint"], heights, rtol=0, atol=1e-9 * np.max(np.abs(heights)))
    first = next(one for one in program.read_model_description(fmu).modelVariables if one.causality == "output")
    assert first.name == "midpoint" and first.unit == "m"
    # An input that changes in time: without weight from a third of the time on.
    rows, kinds = [(0.0, 9.81), (duration / 3, 9.81), (duration / 3, 0.0)], [("time", "f8"), ("gravity", "f8")]
    risen = program.simulate_fmu(
        fmu, stop_time=duration, output_interval=duration / 40, input=np.array(rows, dtype=kinds)
    )
    assert risen["midpoint"][-1] > 0.95 * heights[-1]


@pytest.mark.slow
def test_an_fmu_answers_bad_input_with_a_status_and_comes_back(folder: Path, tmp_path: Path) -> None:
    program = fmpy()
    from fmpy.fmi3 import FMU3Slave

    where = program.extract(str(folder / "filament.fmu"), str(tmp_path / "fmu"))
    told = program.read_model_description(where)
    number = {one.name: one.valueReference for one in told.modelVariables}
    arguments = {"guid": told.instantiationToken, "modelIdentifier": "filament", "unzipDirectory": where}

    def begun() -> FMU3Slave:
        fmu = FMU3Slave(instanceName="one", **arguments)
        fmu.instantiate(loggingOn=False, earlyReturnAllowed=True)
        fmu.enterInitializationMode(stopTime=1.0)
        fmu.exitInitializationMode()
        return fmu

    fmu = begun()
    fmu.doStep(0.0, 0.1)
    state = fmu.getFMUState()
    kept = fmu.serializeFMUState(state)
    fmu.doStep(0.1, 0.3)
    height = fmu.getFloat64([number["midpoint"]])
    for refused in (
        lambda: fmu.doStep(0.4, -0.1),
        lambda: fmu.doStep(0.1, 0.1),
        lambda: fmu.doStep(0.4, float("nan")),
        lambda: fmu.setFloat64([number["gravity"]], [float("nan")]),
        lambda: fmu.setFloat64([number["poisson"]], [0.7]),
        lambda: fmu.setFloat64([number["midpoint"]], [0.0]),
        lambda: fmu.getFloat64([12345]),
        lambda: fmu.setInt32([number["gravity"]], [1]),
    ):
        with pytest.raises(Exception, match=r"Error|status|failed|3"):
            refused()
    assert fmu.getFloat64([number["midpoint"]]) == height, "what is refused changes nothing"
    fmu.setFMUState(state)
    fmu.doStep(0.1, 0.3)
    assert fmu.getFloat64([number["midpoint"]]) == height
    other = begun()
    other.setFMUState(other.deserializeFMUState(kept))
    other.doStep(0.1, 0.3)
    assert other.getFloat64([number["midpoint"]]) == height, "to the last digit"
    for one in (fmu, other):
        one.terminate()
        one.freeInstance()


@pytest.mark.slow
def test_fmpy_compiles_the_sources_of_an_fmu(folder: Path, heights: Floats, tmp_path: Path) -> None:
    program = fmpy()
    from fmpy.build import build_platform_binary

    if shutil.which("cmake") is None:
        pytest.skip("FMPy compiles by CMake, which is not here")
    unpacked, duration = tmp_path / "fmu", sc.load_scene("arrested-overdamped", SMALL).run.duration
    program.extract(str(folder / "filament.fmu"), str(unpacked))
    shutil.rmtree(unpacked / "binaries")
    (tmp_path / "build").mkdir()
    build_platform_binary(str(unpacked), build_dir=str(tmp_path / "build"))
    found = program.simulate_fmu(str(unpacked), stop_time=duration, output_interval=duration / (len(heights) - 1))
    np.testing.assert_allclose(found["midpoint"], heights, rtol=0, atol=1e-9 * np.max(np.abs(heights)))


EXAMPLES = ROOT / "generated/examples"


@pytest.mark.slow
def test_a_controller_holds_a_sag_in_c_and_around_the_fmu(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both loops give the same rows; the rod stays above the sag that is asked for, and comes within a tenth of it."""
    fmpy()
    make = shutil.which("make")
    if make is None:
        pytest.skip("no make here")
    here = {platform: target for platform, target in forms.TARGETS.items() if platform == forms._platform()}
    monkeypatch.setattr(forms, "TARGETS", here)
    for name in ("Makefile", "hold_sag.c", "hold_sag.py"):
        shutil.copy(EXAMPLES / name, tmp_path)
    generate(EXAMPLES / "furnace.toml", tmp_path / "furnace", forms=("static", "fmu"))
    subprocess.run([make, "hold_sag", f"CC={compiler()[0]}"], cwd=tmp_path, check=True, capture_output=True)
    loops = [[str(tmp_path / "hold_sag")], [sys.executable, "hold_sag.py", "furnace/filament.fmu", "picture.png"]]
    found = [subprocess.run(one, cwd=tmp_path, check=True, capture_output=True, text=True).stdout for one in loops]
    rows = np.array([[float(cell) for cell in line.split(",")] for line in found[0].splitlines()[1:]])
    assert found[1] == found[0] and (tmp_path / "picture.png").exists() and rows.shape == (120, 3)
    assert 0.9 * 2e-3 < rows[-1, 2] < 2e-3 and np.all(rows[:, 2] < 2e-3) and np.ptp(rows[:, 1]) > 50.0


def test_units_are_those_of_si_and_an_unknown_form_is_refused(tmp_path: Path) -> None:
    assert forms.base_units("Pa*s") == {"kg": 1, "m": -1, "s": -1}
    assert forms.base_units("kg/m^3") == {"kg": 1, "m": -3}
    assert forms.base_units("N*m/rad") == {"kg": 1, "m": 2, "s": -2, "rad": -1}
    assert forms.base_units("furlong") == forms.base_units("Pa*s^n") == {}
    with pytest.raises(SoftcatError, match="accepted: static, fmu, simulink"):
        generate("arrested-overdamped", tmp_path, forms=("exe",))
    assert not list(tmp_path.iterdir())
