"""The ``softcat`` command as a user meets it: folders, faults, help, scenes, runs, films, explanations, its cache."""

from __future__ import annotations

import difflib
import io
import json
import os
import re
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path

import pytest
import xarray as xr
from rich.console import Console

import softcat_sym as sc
from softcat_sym.cli.explain import print_explanation
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.fitting.flow_curve import fit_flow_curve
from softcat_sym.fitting.measurements import read_measurements
from softcat_sym.scene.bodies import BODIES
from softcat_sym.scene.keys import TEMPLATES, keys_in_markdown, scene_keys
from softcat_sym.scene.scene import known_keys
from softcat_sym.studies.explanation import Explanation, explain
from tests.common.in_process import Softcat, sets
from tests.golden import help as help_record
from tests.test_generated_folder import LOCKED

ROOT = Path(__file__).parents[1]
PROGRAM = Path(sys.executable).with_name("softcat")
COARSE = ("numerics.cells=10", "run.frames=21")
ONCE = sets(*COARSE, "numerics.estimate=false")
PICTURES = {"midpoint.png", "shapes.png", "energy.png", "space-time.png", "midpoint.csv"}
FILES = {"trajectory.nc", "summary.json", "scene.toml"} | PICTURES


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Softcat:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    return Softcat(monkeypatch, capsys)


def program(*arguments: str | Path, cwd: Path | None = None, **environment: str) -> subprocess.CompletedProcess[str]:
    """The installed command in a new process."""
    return subprocess.run(
        [PROGRAM, *arguments],
        cwd=cwd,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )


@pytest.mark.skipif(version("typer") != LOCKED["typer"], reason="the layout is that of the locked typer")
def test_help_texts_and_public_names_are_the_recorded_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", str(help_record.WIDTH))
    found, kept = help_record.texts().splitlines(), help_record.FILE.read_text(encoding="utf-8").splitlines()
    changed = "\n".join(difflib.unified_diff(kept, found, "recorded", "now", n=1, lineterm=""))
    assert not changed, f"{changed}\nif this is meant: python -m tests.golden.help records it anew"


def test_faults_of_the_scene_come_before_those_of_the_folder(softcat: Softcat) -> None:
    assert softcat("samples", "-o", ".", "-q").status == 0
    Path("file").write_text("")
    for command in (
        *("run", "card", "explain", "effects", "accuracy", "generate", "compare", "phase"),
        "compare --vary groups.V=26,260",
        "sweep --vary filament.span=0.1m,0.2m",
        "experiment --free viscosity --noise 1%",
        "fit film.csv --free viscosity --scene",
        "flow-curve my-curve.csv --scene",
    ):
        words = [word.replace("m,", " m,").replace("2m", "2 m").replace("1%", "1 %") for word in command.split()]
        last = words[-1:] if words[-1] == "--scene" else []
        asked = [*(word for word in words if word not in last), *last, "continual-descent", "-o", "file/out"]
        for change in ("filament.spam=1", 'run.effects=["gravty"]'):
            done = softcat(*asked, "--set", change)
            assert (done.status, "is not a directory" in done.err) == (2, False), command
            assert "filament.spam: unknown key" in done.err or "gravty" in done.err
        good = softcat(*asked)
        assert (good.status, "is not a directory" in good.err) == (2, True), (command, good.err)
    assert Path("file").read_text() == ""
    for command in ("run", "explain", "sweep"):
        done = softcat(command, "no-yield", "-o", "")
        assert (done.status, "an empty name is no folder" in done.err) == (2, True)


def test_new_writes_a_scene_of_every_law_with_comments(softcat: Softcat) -> None:
    for law in TEMPLATES:
        done = softcat("new", "my-ink.toml", "--law", law, "--span", "4 mm", "--force")
        assert (done.status, done.err) == (0, ""), law
        text, scene = Path("my-ink.toml").read_text(), sc.load_scene("my-ink.toml")
        assert (scene.title, scene.material.law) == ("My ink", law)
        assert (scene.filament.span, scene.filament.section) == (0.004, "circle")
        # Uncommented, the defaults that it shows are a scene, and the same one.
        shown = re.sub(r"(?m)^# (\w+ = )", r"\1", text)
        assert sc.Scene.model_validate(tomllib.loads(shown)) == scene
        assert all(re.match(r"#|\[|$|title|\w+ = ", line) for line in text.splitlines())
    constants = ("--shear-consistency", "60 Pa*s^0.4", "--index", "0.4", "--shear-yield-stress", "0.2 kPa")
    done = softcat("new", "hb.toml", "--law", "herschel-bulkley", *constants, "--surface-tension", "72 mN/m")
    assert "yield stress 200 Pa in shear = 346.41 Pa in tension" in done.out
    scene = sc.load_scene("hb.toml")
    assert scene.material.viscosity == pytest.approx(3**0.7 * 60, rel=1e-12)
    assert scene.material.yield_stress == pytest.approx(3**0.5 * 200, rel=1e-12)
    assert scene.surroundings.surface_tension == 0.072


def test_new_refuses_values_like_a_scene_and_never_overwrites_by_itself(softcat: Softcat) -> None:
    values = ("--span", "3 mmm", "--shear-yield-stress", "200", "--index", "x", "--density", "-1 kg/m^3")
    done = softcat("new", "ink.toml", *values)
    assert done.status == 2 and "scene ink.toml: 4 faults" in done.err
    for fault in ("filament.span: unknown unit 'mmm'", "material.shear_yield_stress: '200' has no unit"):
        assert fault in done.err
    assert not Path("ink.toml").exists()
    assert "does not yield" in softcat("new", "ink.toml", "--law", "elastic", "--shear-yield-stress", "1 Pa").err
    assert "material.law: 'custom', whose" in softcat("new", "ink.toml", "--law", "custom").err
    assert "ends in .toml" in softcat("new", "ink").err
    Path("ink.toml").write_text("mine")
    done = softcat("new", "ink.toml")
    assert (done.status, Path("ink.toml").read_text()) == (2, "mine") and "already exist" in done.err
    assert softcat("new", "ink.toml", "--force").status == 0
    assert sc.load_scene("ink.toml").title == "Ink"


def test_show_is_the_same_scene_with_every_default(softcat: Softcat) -> None:
    defaults = [key.path for key in scene_keys() if key.default not in ("", "required")]
    for name in sc.bundled_names():
        done = softcat("show", name, "--set", "run.frames=77")
        assert (done.status, done.err) == (0, "")
        Path("shown.toml").write_text(done.out)
        shown = sc.load_scene("shown.toml")
        assert shown == sc.load_scene(name, ["run.frames=77"]) and shown.run.frames == 77
        tables = tomllib.loads(done.out)
        for path in defaults:
            table, _, key = path.rpartition(".")
            # Of a floor, pillars or a nozzle that are not there they are comments.
            absent = table in (*BODIES, "extrusion") and not getattr(shown, table).present and f"# {key} = " in done.out
            assert table == "groups" or absent or key in (tables[table] if table else tables), (name, path)


def test_every_key_is_listed_with_its_meaning_and_the_page_of_keys_is_current(softcat: Softcat) -> None:
    keys = scene_keys()
    known = {".".join(filter(None, (table, key))) for table, names in known_keys().items() for key in names}
    assert {key.path for key in keys} == known - set(known_keys())
    assert [key.path for key in keys if not re.fullmatch(r"\S.*\.", key.meaning)] == []
    listed = softcat("keys")
    assert listed.status == 0 and "filament.density  [kg/m^3]  required" in listed.out
    some = softcat("keys", "material").out
    assert {line.split()[0].split(".")[0] for line in some.splitlines() if line[0] != " "} == {"material"}
    assert "no key has 'spam' in its name" in softcat("keys", "spam").err
    page = (ROOT / ".docs" / "manual" / "keys.md").read_text(encoding="utf-8")
    assert softcat("keys", "--markdown").out == keys_in_markdown() == page


def test_samples_are_read_by_the_commands_they_are_for(softcat: Softcat, tmp_path: Path) -> None:
    folder = tmp_path / "softcat-out" / "samples"
    assert softcat("samples").status == 0
    assert {path.name for path in folder.iterdir()} == {"my-ink.toml", "film.csv", "film.mov", "my-curve.csv"}
    assert softcat("samples").status == 0, "the same files again"
    (folder / "my-ink.toml").write_text("mine")
    done = softcat("samples")
    assert (done.status, (folder / "my-ink.toml").read_text()) == (2, "mine")
    assert softcat("samples", "--force", "-q").status == 0
    (film,) = read_measurements(folder / "film.csv").series
    assert film.time.size == 41
    best = fit_flow_curve(folder / "my-curve.csv").best
    assert best.law == "bingham" and best.tau_Y is not None
    assert best.tau_Y.value == pytest.approx(200, rel=0.03)
    assert all("Not a measurement" in (folder / name).read_text() for name in ("film.csv", "my-curve.csv"))
    assert sc.load_scene(folder / "my-ink.toml").material.shear_yield_stress == 200


@pytest.mark.slow
def test_run_writes_its_files_and_is_short_on_the_screen_or_in_full(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    done = program("run", "arrested-overdamped", "-o", output, *sets(*COARSE))
    assert done.returncode == 0, done.stderr
    assert {path.name for path in output.iterdir()} == FILES
    assert all(line.startswith("softcat: ") for line in done.stderr.splitlines()), "what goes on, and nothing else"
    assert "arrested-overdamped" in done.stdout
    summary = json.loads((output / "summary.json").read_text())
    assert (summary["outcome"], summary["cells"]) == ("solved", 10)
    assert set(summary["wall_s"]) == {"build", "compile", "solve", "estimate", "write", "total"}
    with xr.open_dataset(output / "trajectory.nc") as data:
        assert dict(data.sizes) == {"time": 21, "node": 21, "cell": 20}
        assert data.midpoint.values[-1] == pytest.approx(summary["midpoint_final_m"])
        assert data.time.dtype.kind == "f"
    asked = ("run", "arrested-overdamped", "-o", str(output), "--set", "title=[red]ink[/] at [5 mm]", *sets(*COARSE))
    short, full = softcat(*asked), softcat(*asked, "-v")
    first, second = short.out.splitlines()[:2]
    assert (first, second.split()) == ("[red]ink[/] at [5 mm]", ["outcome", "solved"])
    reason = json.loads((output / "summary.json").read_text())["effects"]["inertia"]
    for text in (f"inertia: on, {reason}", "left out", "wall time", "energy"):
        assert text in " ".join(full.out.split()) and text not in " ".join(short.out.split())
    assert all(name in full.out for name in FILES)
    assert "\x1b" not in short.out + short.err, "no colour in a pipe"


@pytest.mark.slow
def test_an_answer_not_to_be_trusted_exits_1_is_stamped_and_still_writes(softcat: Softcat) -> None:
    asked = ("run", "edge-of-rupture", "-o", "out", "--set", "run.effects=paper", *ONCE)
    done, quiet = softcat(*asked), softcat(*asked, "-q")
    assert done.status == quiet.status == 1
    assert done.out.startswith("NOT TO BE TRUSTED (localised): ")
    assert quiet.err.startswith("softcat: localised")
    assert {path.name for path in Path("out").iterdir()} == FILES
    table = Path("out/midpoint.csv").read_text().splitlines()
    assert table[0] == "time_s,midpoint_m,refused" and all(line.endswith(",localised") for line in table[1:])
    summary = json.loads(Path("out/summary.json").read_text())
    assert (summary["outcome"], summary["regime"]) == ("localised", None)
    assert summary["advice"] == sc.Outcome.localised.value


EXPLAINED = {"explain.json", "equations.tex", "scene.toml"}
KEYS = {
    "title", "law", "model", "closure", "accuracy", "groups", "regime", "sag", "strain",
    "effects", "equations", "unknowns", "graph", "integrator", "warnings",
}  # fmt: skip
SMALL = "numerics.cells=5"


def printed(explanation: Explanation, width: int = 150) -> str:
    out = io.StringIO()
    print_explanation(explanation, Console(file=out, width=width), verbose=True)
    return out.getvalue()


def test_explain_prints_and_writes_what_python_knows(softcat: Softcat, tmp_path: Path) -> None:
    softcat.monkeypatch.setenv("COLUMNS", "160")
    output = tmp_path / "deep" / "out"
    done = softcat("explain", "arrested-overdamped", "-o", str(output), "--set", SMALL)
    assert (done.status, done.err) == (0, "")
    assert {path.name for path in output.iterdir()} == EXPLAINED
    assert f"wrote explain.json, equations.tex, scene.toml to {output}" in done.out
    scene = sc.load_scene("arrested-overdamped", [SMALL])
    assert sc.load_scene(output / "scene.toml") == scene
    found = json.loads((output / "explain.json").read_text())
    assert set(found) >= KEYS
    assert found == json.loads(json.dumps(sc.explain(scene).to_dict()))
    assert found["graph"]["cells"] == 5
    assert {group["name"]: group["value"] for group in found["groups"]}["G"] == pytest.approx(0.4, rel=1e-9)
    assert [row["effect"] for row in found["effects"]] == [effect.name for effect in REGISTRY]
    assert (output / "equations.tex").read_text().count(r"\begin{equation*}") == len(found["equations"])
    assert "Groups" not in done.out
    whole = softcat("explain", "arrested-overdamped", "--verbose", "--set", SMALL).out
    for row in found["effects"]:
        assert row["effect"] in done.out or row["estimate"] is None
        assert row["effect"] in whole and row["meaning"][:12] in whole
    # The written scene is explained alike, but for the remarks on what was converted.
    for name, folder in (("glass-rod", "first"), ("first/scene.toml", "second")):
        done = softcat("explain", name, "-q", "-o", folder, "--set", SMALL)
        assert (done.status, done.out, done.err) == (0, "", "")
    for name in ("explain.json", "equations.tex"):
        assert Path("first", name).read_bytes() == Path("second", name).read_bytes()


def test_what_is_explained_is_what_the_run_then_has() -> None:
    for name in ("no-yield", "cold-honey"):
        scene = sc.load_scene(name, ["numerics.cells=6", "run.frames=3"])
        known, run = explain(scene), sc.simulate(scene)
        assert set(known.in_force) == set(run.summary["effects"])
        for key in ("solver", "rtol"):
            assert known.integrator[key] == run.summary[key]
        assert known.graph["cells"] == run.summary["cells"]
    for name in ("no-yield", "cold-honey", "thermoforming-sheet", "cooked-spaghetti"):
        scene = sc.load_scene(name, ["numerics.cells=8"])
        known = explain(scene)
        for algebraic, total in ((False, known.graph["differential"]), (True, known.graph["algebraic"])):
            assert sum(kind["number"] for kind in known.unknowns if kind["algebraic"] is algebraic) == total
        assert all(kind["meaning"] for kind in known.unknowns)
        assert known.graph["parameters"]["density"] == scene.filament.density
        assert known.graph["parameters"]["thickness"] == scene.filament.thickness
        assert all(effect["reason"] and effect["summary"] for effect in known.effects)


@pytest.mark.slow
def test_every_bundled_scene_is_explained() -> None:
    for name in sc.bundled_names():
        known = explain(sc.load_scene(name))
        assert known.regime.reason and known.equations and printed(known, 100), name


@pytest.mark.parametrize(
    "code",
    [
        "from softcat_sym.cli.completing import complete_change, complete_scene\n"
        "assert complete_scene('ink') and complete_change('material.')",
        "from typer.main import get_command\nfrom softcat_sym.cli.application import app\n"
        "group = get_command(app)\n"
        "for name in group.commands:\n    assert group([name, '--help'], standalone_mode=False) == 0",
    ],
)
def test_completion_and_help_load_nothing_heavy(code: str) -> None:
    code += "\nimport sys\nheavy = {'sympy', 'casadi', 'matplotlib', 'xarray', 'numpy'} & set(sys.modules)\n"
    command = [sys.executable, "-c", f"{code}assert not heavy, heavy"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_run_without_pictures_writes_its_numbers_and_loads_no_matplotlib(tmp_path: Path) -> None:
    code = (
        "import sys\nsys.argv = ['softcat', 'run', 'cold-honey', '-q', '-o', sys.argv[1], '--set', 'run.frames=3', "
        "'--set', 'numerics.estimate=false', '--no-pictures']\n"
        "from softcat_sym.cli import main\n"
        "try:\n    main()\nexcept SystemExit as left:\n    assert not left.code, left.code\n"
        "assert 'matplotlib' not in sys.modules\n"
    )
    done = subprocess.run([sys.executable, "-c", code, tmp_path / "out"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"trajectory.nc", "summary.json", "scene.toml"}
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert summary["wall_s"]["write"] > 0
