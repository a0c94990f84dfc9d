"""What ``generate`` writes: its files, its program built under sanitizers, and the checked-in products.

``python -m tests.test_generated_folder`` writes ``generated/`` and the digests of the products anew.
"""

from __future__ import annotations

import ctypes
import hashlib
import math
import os
import re
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import casadi
import numpy as np
import pytest
import sympy

import softcat_sym as sc
from softcat_sym import generation
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.export import model_files, runtime_files
from softcat_sym.codegen.interface import comment, quoted
from softcat_sym.codegen.library import compile_library, load
from softcat_sym.discretization.section_rule import SectionRule, fibre_rule, ring_rule, warping_rule
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.generation import export
from softcat_sym.scene.scene import Scene
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence

ROOT = Path(__file__).parents[1]
COMMON = Path(__file__).with_name("common")
PROGRAMS, DIGESTS = COMMON / "programs", COMMON / "products.sha256"
FOLDERS = ("arrested-overdamped", "drying-ink")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic")
SANITIZED = ("-O1", "-g1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
OWN = {"filament.c", "filament.h", "filament.py", "main.c", "Makefile", "CMakeLists.txt", "README.md"}
OWN |= {"parameters.txt", "scene.toml"}


def once(name: str, changes: Mapping[str, object] | Sequence[str] = ()) -> Scene:
    """A bundled scene that is generated without a run before."""
    return sc.load_scene(name, changes).replace({"numerics.estimate": False})


PLAIN = once("maxwell-slow")
OTHERS = {
    # Another material, size, load, time and number of cells of the same structure each.
    "maxwell-slow": {
        "material.viscosity": "2 kPa*s",
        "filament.thickness": "5 mm",
        "run.duration": "1 s",
        "numerics.cells": 4,
    },
    "beam-viscometer": {"load.point_mass": "5 g", "filament.density": "1500 kg/m^3"},
    "drawn-blob": {"ends.motion": [["0 s", "0 m", "0 m"], ["0.3 s", "10 mm", "-8 mm"]], "numerics.cells": 4},
    "cooked-spaghetti": {"material.poisson": 0.3, "ends.left_angle": "0 deg", "run.duration": "0.3 s"},
}


def compiled(*arguments: object) -> None:
    """Call the C compiler, which must have nothing to say."""
    compiler = find_compiler()
    assert compiler is not None
    command = [*compiler.command, *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0 and not done.stderr, done.stderr


@dataclass(frozen=True)
class Program:
    """A built program."""

    path: Path

    def __call__(self, *arguments: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run([str(self.path), *map(str, arguments)], capture_output=True, text=True, check=False)

    def table(self, *arguments: object) -> Floats:
        """The numbers that it prints as CSV, below a heading."""
        done = self(*arguments)
        assert done.returncode == 0, done.stderr
        return np.array([[float(cell) for cell in line.split(",")] for line in done.stdout.splitlines()[1:]])


@dataclass(frozen=True)
class Workshop:
    """Where folders are built, as a user builds them but with every warning an error and under sanitizers."""

    root: Path

    @cache  # noqa: B019 (lives as long as the tests do)
    def runtime(self) -> Path:
        """The library of the C that is the same for all filaments, compiled once."""
        folder = self.root / "runtime"
        folder.mkdir()
        for name, text in runtime_files().items():
            (folder / name).write_text(text, encoding="utf-8")
        for source in sorted(folder.glob("*.c")):
            compiled(*STRICT, *SANITIZED, "-c", source, "-o", source.with_suffix(".o"))
        library = folder / "libsoftcat.a"
        subprocess.run(["ar", "rcs", library, *sorted(folder.glob("*.o"))], check=True)
        return library

    @cache  # noqa: B019
    def folder(self, scene: Scene, name: str = "filament") -> Path:
        """The scene, generated."""
        folder = self.root / f"{abs(hash(scene)):x}-{name}"
        sc.generate(scene, folder, name=name)
        compiled(*STRICT, *SANITIZED, "-c", folder / f"{name}.c", "-o", folder / f"{name}.o")
        return folder

    @cache  # noqa: B019
    def program(self, scene: Scene, main: Path | None = None) -> Program:
        """The program of a scene, with its own main or another."""
        folder = self.folder(scene)
        source = main or folder / "main.c"
        objects = (folder / "filament.o", self.runtime())
        compiled(*STRICT, *SANITIZED, f"-I{folder}", source, *objects, "-lm", "-o", folder / source.stem)
        return Program(folder / source.stem)


@pytest.fixture(scope="session")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Workshop:
    return Workshop(tmp_path_factory.mktemp("generated"))


def interpreted(scene: Scene) -> tuple[Floats, Floats, Floats]:
    """Times [s], and x and y [m] of the nodes, by CasADi's own integrator."""
    asked = scene.replace({"numerics.backend": "interpreted", "numerics.solver": "rosenbrock"})
    prepared = build(asked, choose_effects(asked))
    solution = prepared.solve(Silence())
    assert solution.outcome.is_success, solution.message
    observed = prepared.graph.observe(solution.time, solution.x, solution.z, prepared.p)
    return solution.time * prepared.scale, observed["x"], observed["y"]


def test_the_folder_holds_all_that_a_build_needs(tmp_path: Path) -> None:
    scene = once("no-yield", {"numerics.cells": 4})
    out = tmp_path / "deep" / "out"
    names = {path.name for path in sc.generate(scene, out)}
    assert names >= OWN and not names & {"start.csv", "softcat_rhs.c"}
    texts = {path.name: path.read_text(encoding="utf-8") for path in out.iterdir()}
    assert set(texts) == names
    for name, text in texts.items():
        assert "{{ " not in text and "{%" not in text, name
        includes = [line.split('"')[1] for line in text.splitlines() if line.startswith('#include "')]
        assert not name.endswith(".h") or set(includes) <= names, name
    assert sc.load_scene(out / "scene.toml") == scene
    # Written again from its own scene it is the same; the plain right-hand side comes on request.
    sc.generate(out / "scene.toml", tmp_path / "again", rhs=True)
    for name in names - {"README.md"}:
        assert (tmp_path / "again" / name).read_text(encoding="utf-8") == texts[name], name
    assert (tmp_path / "again" / "softcat_rhs.h").exists()
    assert "Your own integrator" in (tmp_path / "again" / "README.md").read_text()


def test_a_name_goes_through_all_files(tmp_path: Path) -> None:
    rod = once("glass-rod")
    sc.generate(rod, tmp_path, name="rod")
    source, header, main = ((tmp_path / name).read_text() for name in ("rod.c", "rod.h", "main.c"))
    assert "const softcat_model rod_model" in source and "int rod_solve(" in header and "ROD_P_THICKNESS" in header
    assert '#include "rod.h"' in main and "rod_structure" in main
    for name in ["", "Rod", "9rod", "main", "softcat_band", "a" * 41, "rod/../x", "rod.c", "all"]:
        with pytest.raises(SoftcatError, match="small letters"):
            sc.generate(rod, tmp_path / "out", name=name)
    small = once("maxwell-slow", ["model=small-deflection"])
    still = once("stretched-rubber-band", ["run.effects=['bending', 'extensibility', 'finite-stretch']"])
    for scene, where in ((small, "model"), (still, "run.effects")):
        with pytest.raises(SceneError) as refused:
            sc.generate(scene, tmp_path / "out")
        assert refused.value.faults[0].path == where, "what has no compiled form is refused"
    assert not (tmp_path / "out").exists()
    # No title ends a comment or a string.
    text = 'a */ b /* c ??/ "d" \\ \n é'
    assert comment([text]).count("*/") == 1 and "??/" not in comment([text])
    assert quoted(text) == '"a */ b /* c \\?\\?/ \\"d\\" \\\\ \\012 \\303\\251"'


NEAR = 4e-5
"""Of the sag: a program holds velocities ten times as loosely as positions, as `softcat run` does."""


@pytest.mark.slow
@pytest.mark.parametrize("name", OTHERS)
def test_one_build_serves_other_numbers_and_cells(name: str, workshop: Workshop, tmp_path: Path) -> None:
    first = once(name)
    short = {"numerics.rtol": 1e-7, "run.frames": 11, "numerics.cells": 10}
    other = first.replace({**short, **OTHERS[name], "run.effects": list(choose_effects(first).names)})
    program = workshop.program(first)
    sc.generate(other, tmp_path)
    # The digest of the structure, not that of the text: the text holds the scene's numbers as defaults.
    headers = [(folder / "filament.h").read_text().splitlines() for folder in (workshop.folder(first), tmp_path)]
    digests = [[line for line in header if "Digest" in line] for header in headers]
    assert digests[0] == digests[1]
    table = program.table(tmp_path / "parameters.txt", "--shape")
    time, x, y = interpreted(other)
    sag = np.max(np.abs(y - y[0]))
    np.testing.assert_allclose(table[:, 0], time, rtol=1e-12)
    np.testing.assert_allclose(table[:, 2::2], x, atol=NEAR * sag)
    np.testing.assert_allclose(table[:, 3::2], y, atol=NEAR * sag)
    np.testing.assert_allclose(table[:, 1], y[:, int(np.argmin(np.abs(x[0])))], atol=NEAR * sag)


SECTIONS = {"RECTANGLE": ("rectangle", False), "RECTANGLE_IN_HALVES": ("rectangle", True)}
SECTIONS |= {"CIRCLE": ("circle", False), "CIRCLE_IN_HALVES": ("circle", True)}


def test_fibres_are_where_python_has_them() -> None:
    """Gauss's rules in C against NumPy's, for every number of fibres that a run is refined to."""
    files = runtime_files()
    library = load(compile_library(files, units=["softcat_section.c"], flags=STRICT[1:]), "softcat_rule")
    order = re.search(r"typedef enum softcat_section \{(.*?)\}", files["softcat_solve.h"], re.DOTALL)
    assert order is not None
    names = re.findall(r"SOFTCAT_(\w+)", order[1])

    def close(name: str, fibres: int, aspect: float, rule: SectionRule) -> None:
        tables = np.array(list(rule.tables.values()))
        found, address = np.full_like(tables, np.nan), ctypes.c_void_p
        room = np.empty(library.softcat_rule_room(names.index(name), rule.points) or 1)
        arguments = names.index(name), fibres, rule.points, ctypes.c_double(aspect)
        library.softcat_rule(*arguments, address(found.ctypes.data), address(room.ctypes.data))
        np.testing.assert_allclose(found, tables, rtol=0, atol=1e-14, err_msg=f"{name} {fibres}")

    for fibres in range(2, 65):
        for name, (section, halves) in SECTIONS.items():
            close(name, fibres, 1.0, fibre_rule(section, fibres, halves=halves))
        rings, side = max(1, round(math.sqrt(0.6 * fibres))), math.ceil(math.sqrt(fibres))
        close("RINGS", fibres, 1.0, ring_rule(rings, max(3, math.ceil(fibres / rings))))
        for aspect in (0.3, 1.0, 8.0):
            close("WARPING", fibres, aspect, warping_rule(side, side, aspect))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["drying-ink", "windy-ink"])
def test_fibres_are_a_number_of_the_program(name: str, workshop: Workshop) -> None:
    first = once(name, {"numerics.rtol": 1e-6, "run.frames": 11, "numerics.cells": 8, "numerics.tail": "integrate"})
    scene = first.replace({"run.effects": list(choose_effects(first).names)})
    program, parameters = workshop.program(scene), workshop.folder(scene) / "parameters.txt"
    for fibres, cells in ((4, 8), (21, 6)):
        asked = {"numerics.fibres": fibres, "numerics.cells": cells}
        heights = sc.simulate(scene.replace(asked)).data.midpoint.values
        found = program.table(parameters, "--fibres", fibres, "--cells", cells)[:, 1]
        np.testing.assert_allclose(found, heights, rtol=0, atol=NEAR * np.max(np.abs(heights)))
    for words in ("--fibres=3", "--fibres 0", "--fibres many", "--cells -4"):
        assert program(parameters, *words.split()).returncode == 2
    refused = program(parameters, "--fibres", 1001)
    assert refused.returncode == 2 and "fibres is not 2 to 1000" in refused.stderr and "fibres = 1001" in refused.stderr


def test_the_program_has_the_grid_that_a_run_ends_with(tmp_path: Path) -> None:
    scene = sc.load_scene("glass-rod", {"run.accuracy": 1e-4, "run.frames": 11})
    run = sc.simulate(scene)
    assert run.summary["refinements"], "the first guess does not do"
    sc.generate(scene, tmp_path)
    at, lines = run.summary["resolution"], (tmp_path / "parameters.txt").read_text()
    assert f"cells = {at['cells']} " in lines and f"relative = {at['rtol']!r} " in lines
    words = " ".join((tmp_path / "README.md").read_text().split())
    assert f"error is about {run.summary['error_estimate']['total']:.2g} of the sag, 0.0001 was asked" in words


PULLED = {"load.tip_force": ["0 N", "-10 mN", "30 mN"], "load.tip_mass": "1 g"}
PULLED |= {"load.tip_torque": ["10 uN*m", "0 N*m", "20 uN*m"]}
IN_SPACE = {
    # A filament in three dimensions with other numbers each: straight, turned and curled.
    "windy-ink": ({}, {"load.direction": [0.0, -0.6, 0.8], "filament.density": "3000 kg/m^3"}),
    "wrung-thread": ({}, {"ends.right_twist": [["0 s", "0 deg"], ["0.4 s", "500 deg"]], "run.duration": "0.5 s"}),
    "hanging-curl": (PULLED, {"material.youngs_modulus": "40 kPa"}),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", IN_SPACE)
def test_a_filament_in_three_dimensions_is_generated_too(name: str, workshop: Workshop, tmp_path: Path) -> None:
    common, other = IN_SPACE[name]
    first = once(name).replace({**common, "numerics.rtol": 1e-6, "run.frames": 11})
    program, parameters = workshop.program(first), tmp_path / "parameters.txt"
    for scene in (first, first.replace({**other, "run.effects": list(choose_effects(first).names)})):
        sc.generate(scene, tmp_path)
        table, fields = program.table(parameters, "--shape"), sc.simulate(scene).fields
        places = np.stack([np.asarray(fields[axis]) for axis in "xyz"], axis=-1)
        moved = np.max(np.abs(places - places[0]))
        assert np.max(np.abs(table[:, 2:].reshape(places.shape) - places)) < 2e-5 * moved, name


@pytest.mark.slow
@pytest.mark.parametrize("name", ["curled-rod", "slack-taffy"])
def test_a_bent_start_is_read_and_carried_over_to_other_cells(name: str, workshop: Workshop, tmp_path: Path) -> None:
    scene = once(name, ["numerics.rtol=1e-6", "run.frames=11"])
    program, parameters = workshop.program(scene), tmp_path / "parameters.txt"
    sc.generate(scene.replace({"numerics.cells": 24}), tmp_path)
    own, text = program.table(parameters), parameters.read_text()
    start = workshop.folder(scene) / "start.csv"
    parameters.write_text(text.replace("start = start.csv", f"start = {start}"))
    carried = program.table(parameters)
    assert np.max(np.abs(carried[:, 1] - own[:, 1])) < 2e-3 * np.max(np.abs(own[:, 1] - own[0, 1]))
    parameters.write_text(text.replace("start = start.csv", ""))
    refused = program(parameters)
    assert refused.returncode == 2 and "does not begin straight" in refused.stderr


@pytest.mark.slow
@pytest.mark.parametrize("name", ["stretched-rubber-band", "drawn-blob", "glass-rod", "overtwisted-rod"])
def test_derivatives_are_those_of_whole_runs(name: str, workshop: Workshop) -> None:
    scene = once(name, [] if name == "glass-rod" else ["run.duration=0.1 s"])
    table = workshop.program(scene, PROGRAMS / "derivatives.c").table()
    assert len(table) > 4
    for number, error in table:
        assert error < 1e-4, (name, number)


@pytest.mark.slow
def test_two_filaments_live_in_one_program(workshop: Workshop, tmp_path: Path) -> None:
    scenes = {
        "band": once("stretched-rubber-band", ["run.duration=0.1 s"]),
        "rod": once("glass-rod"),
    }
    folders = {name: workshop.folder(scene, name) for name, scene in scenes.items()}
    includes = [f"-I{folder}" for folder in folders.values()]
    objects = [folder / f"{name}.o" for name, folder in folders.items()]
    built = tmp_path / "two"
    compiled(*STRICT, *SANITIZED, *includes, PROGRAMS / "two.c", *objects, workshop.runtime(), "-lm", "-o", built)
    for height, scene in zip(Program(built).table()[0], scenes.values(), strict=True):
        alone = interpreted(scene.replace({"numerics.cells": 10, "run.frames": 2}))
        assert height == pytest.approx(alone[2][-1, 0], rel=1e-3)


@pytest.mark.slow
def test_every_wrong_argument_has_its_code(workshop: Workshop) -> None:
    done = workshop.program(once("no-yield"), PROGRAMS / "arguments.c")()
    assert (done.returncode, done.stdout, done.stderr) == (0, "all as it should be\n", "")


BAD = [
    # what is replaced, by what, and what the program says
    ("gravity =", "gravitas =", "unknown name 'gravitas'; known: rest_length"),
    ("density =", "# density =", "missing: density"),
    ("density = ", "density = heavy ", "density 'heavy"),
    ("density = ", "density = nan # ", "density 'nan'"),
    ("kg/m^3", "g/cm^3", "accepted: kg/m^3"),
    ("density = ", "density = -", "out of range: density = -1900 kg/m^3"),
    ("frames =", "frames = 5\nframes =", "said twice: 'frames'"),
    ("cells = ", "cells = 3 # ", "cells = 3, the least is 4"),
    ("cells = ", "cells = 99999999999 # ", "a whole number above 0"),
    ("gravity =", "gravity", "accepted: name = number unit"),
    ("frames =", f"# {'x' * 5000}\nframes =", "too long"),
    ("frames =", "start = nowhere.csv\nframes =", "nowhere.csv: No such file"),
    ("frames =", "start = start.csv\nframes =", "its heading is X,x,y,u,v"),
    ("relative = ", "relative = 2 # ", "a setting is out of range"),
]


@pytest.mark.slow
def test_a_bad_parameter_file_is_refused_with_one_line(workshop: Workshop, tmp_path: Path) -> None:
    program, text = workshop.program(PLAIN), (workshop.folder(PLAIN) / "parameters.txt").read_text()
    parameters, out = tmp_path / "parameters.txt", tmp_path / "out.csv"
    (tmp_path / "start.csv").write_text("X,x,y\n0,0,0\n")
    for old, new, words in BAD:
        assert old in text
        parameters.write_text(text.replace(old, new, 1))
        done = program(parameters, "-o", out)
        assert (done.returncode, done.stdout, out.exists()) == (2, "", False), words
        assert words in done.stderr and done.stderr.count("\n") == 1, (words, done.stderr)
    parameters.write_text(
        text.replace("relative = ", "relative = 1e-19 # ").replace("absolute = ", "absolute = 1e-300 # ")
    )
    done = program(parameters, "-o", out)
    assert (done.returncode, done.stdout, out.exists()) == (1, "", False), "a run that fails"
    assert "stopped after t = " in done.stderr
    parameters.write_text(text)
    for arguments in ((), ("--fly",), (parameters, parameters), (parameters, "-o")):
        done = program(*arguments)
        assert done.returncode == 2 and done.stderr.startswith("usage: filament PARAMETERS")
    for arguments in (
        (tmp_path / "no.txt",),
        (tmp_path,),
        (parameters, "-o", tmp_path),
        (parameters, "-o", "/dev/full"),
    ):
        done = program(*arguments)
        assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
    assert program("--help").returncode == 0


def checked_in(path: str) -> bool:
    return path == "README.md" or path.startswith(FOLDERS)


COMPUTED = re.compile(r"(?<![\w.])(?=[\d.]{13})\d+\.\d+(?:e[+-]?\d+)?")
"""Numbers of twelve digits and more: steps by eigenvalues, gradings, units; another libm has other last digits."""


def without_numbers(text: str) -> tuple[str, list[float]]:
    """A text without its computed numbers, wherever its lines end, and these."""
    return " ".join(COMPUTED.sub("#", text).split()), [float(one) for one in COMPUTED.findall(text)]


def listed(files: dict[str, str]) -> str:
    """Digests of all files but the runtime, which is package data: of their texts without computed numbers."""
    products = {path: without_numbers(text)[0] for path, text in sorted(files.items()) if path[:8] != "runtime/"}
    return "".join(f"{hashlib.sha256(text.encode()).hexdigest()}  {path}\n" for path, text in products.items())


LOCKED = dict(line.split("==") for line in (ROOT / ".ci/requirements.txt").read_text("utf-8").split() if "==" in line)
HELP = "run python -m tests.test_generated_folder"
needs_locked_versions = pytest.mark.skipif(
    (casadi.__version__, sympy.__version__) != (LOCKED["casadi"], LOCKED["sympy"]),
    reason="the text is that of the locked CasADi and SymPy; answers are compared above",
)


@needs_locked_versions
def test_the_two_products_are_what_is_generated_today() -> None:
    digests = DIGESTS.read_text(encoding="utf-8")
    for folder in FOLDERS:
        files = model_files(export(sc.load_scene(folder))[0], generation.NAME, generation.PRODUCTS_COMMAND)
        assert listed({f"{folder}/{name}": text for name, text in files.items()}) in digests, HELP
        for name, text in files.items():
            checked, today = map(without_numbers, ((ROOT / "generated" / folder / name).read_text("utf-8"), text))
            assert checked[0] == today[0], HELP
            assert checked[1] == pytest.approx(today[1], rel=1e-9), HELP
            if name in ("filament.c", "filament.h"):
                assert "do not edit" in text[:400].lower() and generation.PRODUCTS_COMMAND in text[:400]
    files = [path for path in ROOT.glob("generated/**/*") if path.is_file()]
    assert sum(len(path.read_text(encoding="utf-8").splitlines()) for path in files) < 5200


@pytest.mark.slow
@needs_locked_versions
def test_all_products_have_their_digests_and_nothing_is_left_over() -> None:
    files = generation.contents(generation.bundled())
    assert listed(files) == DIGESTS.read_text(encoding="utf-8"), HELP
    found = {path.relative_to(ROOT / "generated").as_posix() for path in ROOT.glob("generated/**/*") if path.is_file()}
    assert {path for path in found if not path.startswith("examples/")} == set(filter(checked_in, files)), HELP


@pytest.mark.slow
def test_the_examples_in_c_and_cpp_are_the_scene_and_catch_what_is_refused(tmp_path: Path) -> None:
    compiler, make = find_compiler(), shutil.which("make")
    tools = compiler and make and shutil.which(os.environ.get("CXX", "c++"))
    if not tools:
        assert not os.environ.get("SOFTCAT_TESTS_NEED_A_COMPILER"), "make or a C++ compiler is missing"
        pytest.skip("no make or no C++ compiler here")
    for folder in ("generated", "softcat_sym/codegen"):
        shutil.copytree(ROOT / folder, tmp_path / folder)  # so that nothing is built within the repository
    flags = " ".join(flag for flag in SANITIZED if flag.startswith("-f"))
    examples, tables = tmp_path / "generated" / "examples", {}
    for target in ("midpoint", "sweep"):
        command = [str(make), target, f"CC={compiler.command[0]}", "OPTIMISED=-O1 -g", f"SANITIZED={flags}"]
        subprocess.run(command, cwd=examples, capture_output=True, text=True, check=True)
        done = subprocess.run([str(examples / target)], capture_output=True, text=True, check=True)
        assert not done.stderr
        tables[target] = [line.split(",") for line in done.stdout.splitlines()[1:]]
    # The scene by its groups cannot be given a yield stress besides: as resolved it can.
    scene, changes = sc.load_scene("arrested-overdamped"), {"material.yield_stress": "8 kPa", "run.frames": 5}
    names = list(export(scene)[0].effects.names)
    truth = sc.simulate(scene.replace({**changes, "run.duration": "2 s", "run.effects": names})).data.midpoint.values
    for row, height in zip(tables["midpoint"], truth, strict=True):
        assert float(row[1]) == pytest.approx(height, rel=2e-3, abs=1e-9)
    assert all(float(row[2]) > 0 for row in tables["midpoint"][1:])
    *table, refused = tables["sweep"]
    sags = [float(row[1]) for row in table]
    assert len(sags) == 11 and max(sags[1:6]) < sags[0] and sags[10] < 0.7 * sags[0]
    assert refused[2] == "a parameter is not finite or out of range: yield_stress"


if __name__ == "__main__":
    products = generation.contents(generation.bundled())
    DIGESTS.write_text(listed(products), encoding="utf-8")
    for path in filter(checked_in, products):
        (ROOT / "generated" / path).parent.mkdir(exist_ok=True)
        (ROOT / "generated" / path).write_text(products[path], encoding="utf-8")
