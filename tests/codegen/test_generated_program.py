"""The program that ``generate`` writes, built under sanitizers, against the interpreted filament."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects

from .building import PROGRAMS, SANITIZED, STRICT, TIGHT, Program, Workshop, compiled, interpreted

PLAIN = "no-yield"
SHORT = {**TIGHT, "numerics.cells": 10}
OTHERS = {
    # Another material, size, load, time and number of cells of the same structure each.
    "stretched-rubber-band": {"material.youngs_modulus": "2 MPa", "filament.span": "0.3 m", "load.gravity": "5 m/s^2"},
    "maxwell-slow": {"material.viscosity": "2 kPa*s", "filament.thickness": "5 mm", "numerics.cells": 4},
    "hot-glue-string": {"material.youngs_modulus": "3 MPa", "numerics.grading": 3.0, "numerics.cells": 7},
    "beam-viscometer": {"load.point_mass": "5 g", "filament.density": "1500 kg/m^3"},
    "drawn-blob": {"ends.motion": [["0 s", "0 m", "0 m"], ["0.3 s", "10 mm", "-8 mm"]], "numerics.cells": 4},
    "cooked-spaghetti": {"material.poisson": 0.3, "ends.left_angle": "0 deg", "run.duration": "0.3 s"},
    "glass-rod": {"material.viscosity": "2e10 Pa*s"},
}


def slow_but(quick: str, name: str) -> object:
    return name if name == quick else pytest.param(name, marks=pytest.mark.slow)


@pytest.fixture(scope="session")
def workshop(tmp_path_factory: pytest.TempPathFactory) -> Workshop:
    return Workshop(tmp_path_factory.mktemp("generated"))


@pytest.mark.parametrize("name", [slow_but("maxwell-slow", name) for name in OTHERS])
def test_one_build_serves_other_numbers_and_cells(name: str, workshop: Workshop, tmp_path: Path) -> None:
    first = sc.load_scene(name)
    other = first.replace({**SHORT, **OTHERS[name], "run.effects": list(choose_effects(first).names)})
    program = workshop.program(first)
    sc.generate(other, tmp_path)
    # The digest of the structure, not that of the text: the text holds the scene's numbers as defaults.
    keys = [
        next(line for line in (folder / "filament.h").read_text().splitlines() if "Digest" in line)
        for folder in (workshop.folder(first), tmp_path)
    ]
    assert keys[0] == keys[1]
    table = program.table(tmp_path / "parameters.txt", "--shape")
    time, x, y = interpreted(other)
    sag = np.max(np.abs(y - y[0]))
    np.testing.assert_allclose(table[:, 0], time, rtol=1e-12)
    np.testing.assert_allclose(table[:, 2::2], x, atol=2e-5 * sag)
    np.testing.assert_allclose(table[:, 3::2], y, atol=2e-5 * sag)
    middle = int(np.argmin(np.abs(x[0])))
    np.testing.assert_allclose(table[:, 1], y[:, middle], atol=2e-5 * sag)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["curled-rod", "slack-taffy"])
def test_a_bent_start_is_read_and_carried_over_to_other_cells(name: str, workshop: Workshop, tmp_path: Path) -> None:
    scene = sc.load_scene(name, ["numerics.rtol=1e-6", "run.frames=11"])
    program, other = workshop.program(scene), scene.replace({"numerics.cells": 24})
    sc.generate(other, tmp_path)
    own = program.table(tmp_path / "parameters.txt")
    text = (tmp_path / "parameters.txt").read_text()
    path = workshop.folder(scene) / "start.csv"
    (tmp_path / "parameters.txt").write_text(text.replace("start = start.csv", f"start = {path}"))
    carried = program.table(tmp_path / "parameters.txt")
    moved = np.max(np.abs(own[:, 1] - own[0, 1]))
    assert np.max(np.abs(carried[:, 1] - own[:, 1])) < 2e-3 * moved
    (tmp_path / "parameters.txt").write_text(text.replace("start = start.csv", ""))
    refused = program(tmp_path / "parameters.txt")
    assert refused.returncode == 2
    assert "does not begin straight" in refused.stderr


@pytest.mark.slow
@pytest.mark.parametrize("name", ["stretched-rubber-band", "no-yield", "drawn-blob", "glass-rod"])
def test_derivatives_are_those_of_whole_runs(name: str, workshop: Workshop) -> None:
    scene = sc.load_scene(name, [] if name == "glass-rod" else ["run.duration=0.1 s"])
    program = workshop.program(scene, PROGRAMS / "derivatives.c")
    table = program.table()
    assert len(table) > 4
    for number, error in table:
        assert error < 1e-4, (name, number)


def test_every_wrong_argument_has_its_code(workshop: Workshop) -> None:
    done = workshop.program(sc.load_scene(PLAIN), PROGRAMS / "arguments.c")()
    assert (done.returncode, done.stdout, done.stderr) == (0, "all as it should be\n", "")


@pytest.mark.slow
def test_two_filaments_live_in_one_program(workshop: Workshop, tmp_path: Path) -> None:
    scenes = {
        "band": sc.load_scene("stretched-rubber-band", ["run.duration=0.1 s"]),
        "rod": sc.load_scene("glass-rod"),
    }
    folders = {name: workshop.folder(scene, name) for name, scene in scenes.items()}
    includes = [f"-I{folder}" for folder in folders.values()]
    objects = [folder / f"{name}.o" for name, folder in folders.items()]
    built = tmp_path / "two"
    source = PROGRAMS / "two.c"
    compiled(*STRICT, *SANITIZED, *includes, source, *objects, workshop.runtime(), "-lm", "-o", built)
    heights = Program(built).table()[0]
    for height, scene in zip(heights, scenes.values(), strict=True):
        alone = interpreted(scene.replace({"numerics.cells": 10, "run.frames": 2}))
        assert height == pytest.approx(alone[2][-1, 0], rel=1e-3)


@pytest.fixture
def parameters(workshop: Workshop, tmp_path: Path) -> Path:
    path = tmp_path / "parameters.txt"
    path.write_text((workshop.folder(sc.load_scene(PLAIN)) / "parameters.txt").read_text())
    return path


BAD = {
    # what is replaced, by what, and what the program says
    "unknown": ("gravity =", "gravitas =", "unknown name 'gravitas'; known: rest_length"),
    "missing": ("density =", "# density =", "missing: density"),
    "no number": ("density = ", "density = heavy ", "density 'heavy"),
    "not finite": ("density = ", "density = inf # ", "density 'inf'"),
    "nan": ("density = ", "density = nan # ", "density 'nan'"),
    "unit": ("kg/m^3", "g/cm^3", "accepted: kg/m^3"),
    "negative": ("density = ", "density = -", "out of range: density = -1900 kg/m^3"),
    "zero": ("thickness = ", "thickness = 0 m # ", "out of range: thickness = 0 m"),
    "twice": ("frames =", "frames = 5\nframes =", "said twice: 'frames'"),
    "cells": ("cells = ", "cells = 3 # ", "cells = 3, the least is 4"),
    "no count": ("cells = ", "cells = 3.5 # ", "a whole number above 0"),
    "huge": ("cells = ", "cells = 99999999999 # ", "a whole number above 0"),
    "frames": ("frames = ", "frames = 0 # ", "a whole number above 0"),
    "no sign": ("gravity =", "gravity", "accepted: name = number unit"),
    "duration": ("duration = ", "duration = -", "a number above 0"),
    "long": ("frames =", f"# {'x' * 5000}\nframes =", "too long"),
    "start": ("frames =", "start = nowhere.csv\nframes =", "nowhere.csv: No such file"),
    "relative": ("relative = ", "relative = 2 # ", "a setting is out of range"),
}


@pytest.mark.parametrize("case", BAD)
def test_a_bad_parameter_file_is_refused_with_one_line(case: str, workshop: Workshop, parameters: Path) -> None:
    old, new, said = BAD[case]
    text = parameters.read_text()
    assert f"\n{old}" in text or old in text
    parameters.write_text(text.replace(old, new, 1))
    done = workshop.program(sc.load_scene(PLAIN))(parameters, "-o", parameters.with_name("out.csv"))
    assert done.returncode == 2
    assert done.stdout == ""
    assert said in done.stderr and done.stderr.count("\n") == 1
    assert not parameters.with_name("out.csv").exists()


def test_bad_arguments_and_places_are_refused(workshop: Workshop, parameters: Path) -> None:
    program, folder = workshop.program(sc.load_scene(PLAIN)), parameters.parent
    for arguments in ((), ("--fly",), (parameters, parameters), (parameters, "-o")):
        done = program(*arguments)
        assert done.returncode == 2 and done.stderr.startswith("usage: filament PARAMETERS")
    for arguments in ((folder / "no.txt",), (folder,), (parameters, "-o", folder), (parameters, "-o", "/dev/full")):
        done = program(*arguments)
        assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
    assert program("--help").returncode == 0
    (folder / "start.csv").write_text("X,x,y\n0,0,0\n")
    parameters.write_text(parameters.read_text() + "start = start.csv\n")
    done = program(parameters)
    assert done.returncode == 2 and "its heading is X,x,y,u,v" in done.stderr


def test_a_run_that_fails_says_when_and_writes_nothing(workshop: Workshop, parameters: Path) -> None:
    text = (
        parameters.read_text()
        .replace("relative = ", "relative = 1e-19 # ")
        .replace("absolute = ", "absolute = 1e-300 # ")
    )
    parameters.write_text(text)
    done = workshop.program(sc.load_scene(PLAIN))(parameters, "-o", parameters.with_name("out.csv"))
    assert done.returncode == 1
    assert "stopped after t = " in done.stderr and done.stdout == ""
    assert not parameters.with_name("out.csv").exists()
