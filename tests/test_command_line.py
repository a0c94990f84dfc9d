"""The ``softcat`` command as a user meets it: folders, faults, help, scenes, runs, films, explanations, its cache."""

from __future__ import annotations

import difflib
import io
import json
import os
import pty
import re
import select
import signal
import subprocess
import sys
import time
import tomllib
from importlib.metadata import version
from pathlib import Path

import pytest
import xarray as xr
from PIL import Image
from rich.console import Console

import softcat_sym as sc
from softcat_sym import cache as cached
from softcat_sym import drawing
from softcat_sym.cli import plain, print_whatever_the_terminal_takes
from softcat_sym.cli.application import output_directory
from softcat_sym.cli.completing import complete_change, complete_scene
from softcat_sym.cli.explain import article, print_explanation
from softcat_sym.codegen.library import store
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.errors import SceneError
from softcat_sym.fitting.flow_curve import fit_flow_curve
from softcat_sym.fitting.measurements import read_measurements
from softcat_sym.results.run import open_run
from softcat_sym.scene.bodies import BODIES
from softcat_sym.scene.keys import TEMPLATES, keys_in_markdown, scene_keys
from softcat_sym.scene.scene import known_keys
from softcat_sym.solvers.solve import Prepared
from softcat_sym.store import keep
from softcat_sym.studies.explanation import Explanation, explain
from tests.common.in_process import Softcat, sets
from tests.golden import help as help_record
from tests.test_generated_folder import LOCKED

ROOT = Path(__file__).parents[1]
PROGRAM = Path(sys.executable).with_name("softcat")
SHORT = (*sets("run.duration=0.01 s", "numerics.estimate=false"), "-q")
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


def test_each_command_has_a_folder_of_its_own() -> None:
    for command, scene, folder in (
        ("run", "ink-bridge", "ink-bridge"),
        ("card", "ink-bridge", "ink-bridge-card"),
        ("sweep", "deep/er/my-ink.toml", "my-ink-sweep"),
        ("run", "./no-yield", "no-yield"),
        ("figures", None, "figures"),
    ):
        assert output_directory(None, command, scene) == Path("softcat-out") / folder


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


def test_a_run_into_the_folder_of_another_scene_says_what_it_replaces(softcat: Softcat) -> None:
    tiny = (
        "-q",
        "--no-pictures",
        *sets("numerics.cells=4", "run.frames=2", "run.duration=1 ms", "numerics.estimate=false"),
    )
    wide = sets("filament.span=9 cm", "run.accuracy=0.02", "title=Mine")
    said = [softcat("run", "cold-honey", "-o", "out", *tiny, *more).err for more in ((), (), wide, wide)]
    replaced = 'filament.span "0.05 m" -> "0.09 m", run.accuracy 0.001 -> 0.02'
    assert said == [
        "",
        "",
        f"softcat: out has results of another scene, which are replaced: {replaced}; -o DIR keeps them\n",
        "",
    ]
    assert '-> "0.05 m"' in softcat("explain", "cold-honey", "-q", "-o", "out").err


def test_new_states_what_a_newcomer_forgets(softcat: Softcat) -> None:
    """Surface tension and the loss below yield, with the reason of each; moduli as a rheometer has them, or Young's."""
    for words, modulus, loss in (
        ((), 2.9 * 103e3, 0.1),
        (("--storage-modulus", "50 kPa", "--loss-modulus", "10 kPa"), 2.9 * 50e3, 0.2),
        (("--youngs-modulus", "45 kPa", "--loss-tangent", "0"), 45e3, 0.0),
    ):
        assert softcat("new", "ink.toml", "--force", *words).status == 0
        text, scene = Path("ink.toml").read_text(), sc.load_scene("ink.toml")
        assert (scene.material.youngs_modulus, scene.material.loss_tangent) == pytest.approx((modulus, loss))
        assert scene.surroundings.surface_tension == 0.072 and "# Without it a thin strand of ink sags" in text
        assert ("# Without it a strand that is let go rings for long" in text) is ("--loss-modulus" not in words)


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


def test_new_asks_on_a_terminal_again_where_an_answer_makes_no_sense(tmp_path: Path) -> None:
    answers = ["3 mmm", "3 mm", "0.1 mm", "", "newton", "newtonian", "", "", "20 ms"]
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(tmp_path)
        command = [sys.executable, "-c", "from softcat_sym.cli import main; main()", "new", "asked.toml"]
        os.execv(sys.executable, command)
    shown = b""
    for answer in answers:
        until = time.monotonic() + 60
        while not shown.rstrip().endswith(b"]:") and time.monotonic() < until:
            if select.select([terminal], [], [], 1.0)[0]:
                shown += os.read(terminal, 4096)
        shown = b""
        os.write(terminal, f"{answer}\n".encode())
        # What was typed comes back first.
        os.read(terminal, 1)
    while True:
        try:
            os.read(terminal, 4096)
        except OSError:
            break
    assert os.waitpid(child, 0)[1] == 0
    scene = sc.load_scene(tmp_path / "asked.toml")
    assert (scene.filament.span, scene.filament.thickness, scene.run.duration) == (0.003, 1e-4, 0.02)
    assert (scene.material.law, scene.material.shear_viscosity) == ("newtonian", 10.0)


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
            # Of a floor or pillars that are not there they are comments.
            absent = table in BODIES and not getattr(shown, table).present and f"# {key} = " in done.out
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
def test_overrides_reach_the_run_and_its_resolved_scene_runs_to_the_same_answer(softcat: Softcat) -> None:
    assert softcat("run", "ink-bridge", "-o", "first", "-q", "--set", "run.closure=printed", *ONCE).out == ""
    assert softcat("run", "first/scene.toml", "-o", "second", "-q").status == 0
    first, second = (json.loads(Path(folder, "summary.json").read_text()) for folder in ("first", "second"))
    assert first["closure"] == "printed"
    assert first["midpoint_final_m"] == second["midpoint_final_m"]
    assert sc.load_scene("first/scene.toml") == sc.load_scene("second/scene.toml")
    small = ("run", "maxwell-slow", "-o", "small", "-q", "--set", "model=small-deflection")
    assert softcat(*small, *ONCE).status == 0
    summary = json.loads(Path("small/summary.json").read_text())
    assert set(summary["effects"]) == {"inertia", "bending", "viscous-flow"}


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


@pytest.mark.slow
def test_an_interrupted_run_writes_what_there_is(tmp_path: Path) -> None:
    output = tmp_path / "out"
    hard = sets("numerics.cells=1000", "numerics.rtol=1e-10", "run.frames=5001")
    with subprocess.Popen([PROGRAM, "run", "no-yield", "-o", output, *hard], stderr=subprocess.PIPE) as process:
        time.sleep(6)
        process.send_signal(signal.SIGINT)
        message = process.communicate(timeout=60)[1].decode()
    assert process.returncode == 1
    assert f"softcat: interrupted; what was computed is in {output}" in message and "Traceback" not in message
    run = sc.open_run(output)
    assert run.outcome is sc.Outcome.interrupted and run.summary["message"].startswith("it was interrupted after")
    assert 0 < run.fields["time"][-1] < run.scene.run.duration
    assert {path.name for path in output.iterdir()} == FILES - PICTURES


def test_whoever_stops_it_while_it_draws_has_the_numbers(softcat: Softcat, monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(*_: object) -> bytes:
        assert json.loads(Path("out/summary.json").read_text())["wall_s"]["write"] > 0
        raise KeyboardInterrupt

    monkeypatch.setattr("softcat_sym.plotting.run.midpoint_csv", stopped)
    done = softcat("run", "cold-honey", "-q", "-o", "out", *sets("run.frames=3", "numerics.estimate=false"))
    again = "its pictures are not: softcat draw out -o out\n"
    assert (done.status, done.err) == (130, f"softcat: interrupted; the run is in out, {again}")
    assert {path.name for path in Path("out").iterdir()} == FILES - PICTURES
    assert sc.open_run("out").outcome.is_success


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A finished run."""
    folder = tmp_path_factory.mktemp("stored")
    run = sc.simulate(sc.load_scene("arrested-overdamped", (*COARSE, "numerics.estimate=false")))
    run.written(folder, {**run.files(), **drawing.report(run).files})
    return folder


@pytest.mark.slow
def test_a_run_drawn_again_is_the_same_to_the_byte(softcat: Softcat, stored: Path) -> None:
    assert softcat("draw", str(stored), "-o", "out").status in (0, None)
    assert {path.name for path in Path("out").iterdir()} == PICTURES | {"summary.json", "scene.toml"}
    for path in Path("out").iterdir():
        assert path.read_bytes() == (stored / path.name).read_bytes(), path.name
    film = ("--animate", "ink.gif", "--animate-seconds", "0.8", "-q")
    assert softcat("draw", str(stored / "trajectory.nc"), "-o", "out", *film).status in (0, None)
    with Image.open("out/ink.gif") as pictures:
        assert pictures.n_frames == 10
    film = ("--animate", "gif", "--animate-seconds", "0.4", "--style", "publication")
    done = softcat("run", "arrested-overdamped", "-o", "run", *ONCE, *film)
    assert done.status in (0, None), done.err
    assert {"film.gif", "shapes.pdf", "space-time.pdf", "trajectory.nc"} <= {
        path.name for path in Path("run").iterdir()
    }
    assert "film.gif, " in done.out
    # A film that cannot be written takes the pictures with it.
    Path("taken/film.gif").mkdir(parents=True)
    done = softcat("draw", str(stored), "-o", "taken", "--animate", "gif", "--animate-seconds", "0.2")
    assert (done.status, [path.name for path in Path("taken").iterdir()]) == (2, ["film.gif"])


def test_what_cannot_be_drawn_is_refused_before_anything_is_solved(softcat: Softcat) -> None:
    softcat.monkeypatch.delattr(Prepared, "solve")
    for arguments, text in (
        (("--animate", "film.avi"), "accepted: gif, mp4"),
        (("--animate", "../film.gif"), "it goes into DIR"),
        (("--animate", "gif", "--animate-seconds", "-3"), "more than 0"),
        (("--style", "fancy"), "accepted: screen, publication"),
    ):
        done = softcat("run", "arrested-overdamped", "-o", "out", *arguments)
        assert (done.status, text in done.err, Path("out").exists()) == (2, True, False)


@pytest.mark.slow
def test_what_is_no_trajectory_is_refused_and_a_summary_of_another_run_not_believed(
    softcat: Softcat, stored: Path, tmp_path: Path
) -> None:
    with xr.open_dataset(stored / "trajectory.nc", engine="h5netcdf") as opened:
        data = opened.load()
    (tmp_path / "text.nc").write_text("garbage")
    (tmp_path / "short.nc").write_bytes((stored / "trajectory.nc").read_bytes()[:20000])
    for name, changed in {
        "thin": data.drop_vars("thickness"),
        "scene": data.assign_attrs(scene="[filament"),
        "nan": data.assign(y=data.y.where(data.time < 1)),
        "empty": data.isel(time=slice(0, 0)),
        "turned": data.assign(y=data.y.transpose()),
    }.items():
        changed.to_netcdf(tmp_path / f"{name}.nc", engine="h5netcdf")
    for name, text in {
        "missing": "no such file",
        "text": "cannot be read as netCDF4",
        "short": "cannot be read as netCDF4",
        "thin": "it lacks thickness",
        "scene": "its scene cannot be read",
        "nan": "y is not finite everywhere",
        "empty": "it lacks frames",
        "turned": "it lacks y",
    }.items():
        done = softcat("draw", f"{name}.nc", "-o", "out")
        assert (done.status, text in done.err, Path("out").exists()) == (2, True, False), (name, done.err)
    (tmp_path / "trajectory.nc").write_bytes((stored / "trajectory.nc").read_bytes())
    (tmp_path / "summary.json").write_text('{"outcome": "solved", "regime": "viscous", "midpoint_final_m": -1.0}')
    run = open_run(tmp_path)
    assert run.summary == {"title": "Yields, flows slowly and stops", "outcome": "solved"}
    assert run.scene == sc.load_scene(stored / "scene.toml")


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


def test_explain_integrates_and_writes_nothing_by_itself(softcat: Softcat, monkeypatch: pytest.MonkeyPatch) -> None:
    """A scene that takes minutes to run, or ends in rupture, is explained at once."""
    monkeypatch.delattr(Prepared, "solve")
    done = softcat("explain", "edge-of-rupture", *sets(SMALL, "run.duration=1000 s"))
    assert (done.status, done.err, list(Path.cwd().iterdir())) == (0, "", [])
    Path("not.toml").write_text("span == 3")
    for words, text in (
        (("nowhere.toml",), "no such file"),
        (("not.toml",), "not TOML"),
        (("cold-honey", "--set", "nonsense"), "'nonsense' sets nothing"),
        (("cold-honey", "no-yield"), "unexpected extra argument"),
        (("cold-honey", "--frames", "3"), "No such option"),
        ((), "Missing argument"),
    ):
        done = softcat("explain", *words, "-o", "out")
        assert (done.status, done.out, text in done.err, Path("out").exists()) == (2, "", True, False), words


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


def test_an_absent_effect_takes_its_unknowns_and_parameters_along() -> None:
    def of(*changes: str) -> Explanation:
        return explain(sc.load_scene("arrested-overdamped", [*changes, "numerics.cells=8"]))

    flowing, fibres = of("run.effects=paper"), of("run.effects=paper", "numerics.fibres=5")
    elastic = of('run.effects=["inertia", "bending"]')
    gone = {"viscosity", "yield_stress", "ramp"}
    assert gone <= set(flowing.graph["parameters"]) and not gone & set(elastic.graph["parameters"])
    assert elastic.graph["instructions"] < flowing.graph["instructions"] < fibres.graph["instructions"]
    assert {kind["kind"] for kind in elastic.unknowns} == {"y", "v"}
    assert {kind["kind"] for kind in flowing.unknowns} == {"x", "y", "u", "v", "a_0", "a_1"}
    (axial,) = [kind for kind in fibres.unknowns if kind["kind"] == "axial"]
    assert axial["number"] == 5 * 8 and "fibres" in fibres.in_force
    assert not any(re.search(r"\b(eta|sigma_Y|g_on|T|Q)\b", equation.text) for equation in elastic.equations)


def test_an_explanation_can_be_written_whatever_its_title_and_groups(softcat: Softcat) -> None:
    title = "50 % of {braces} & [red]_markup_ \\ $"
    scene = sc.load_scene("no-yield", [SMALL, f"title={title}"])
    known = explain(scene)
    tex = article(known.title, known.in_force, known.equations)
    assert tex.startswith(r"\documentclass") and tex.rstrip().endswith(r"\end{document}")
    bare = tex.replace(r"\{", "").replace(r"\}", "")
    assert bare.count("{") == bare.count("}")
    assert r"50 \% of \{braces\} \& [red]\_markup\_ \textbackslash{} \$" in tex
    assert title in printed(known)
    assert "Effects in force: none." in article("", (), ())
    weightless = sc.load_scene("stretched-rubber-band", [SMALL, "load.gravity=0 m/s^2"])
    assert {group["name"]: group["value"] for group in explain(weightless).groups}["E_star"] is None
    assert "infinite" in printed(explain(weightless))


@pytest.mark.slow
def test_every_bundled_scene_is_explained() -> None:
    for name in sc.bundled_names():
        known = explain(sc.load_scene(name))
        assert known.regime.reason and known.equations and printed(known, 100), name


def put(name: str, size: int) -> None:
    store(name * 64, lambda folder: (folder / "library.so").write_bytes(bytes(size)), f"{name}.c by gcc")


def test_what_is_stored_is_shown_and_cleared(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache = tmp_path / "cache"
    monkeypatch.setenv("SOFTCAT_CACHE", str(cache))
    empty = softcat("cache")
    assert (empty.status, f"folder     {cache}\n" in empty.out, "libraries  0, 0 B of" in empty.out) == (0, True, True)
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "2 MB")
    put("a", 400_000)
    put("b", 100_000)
    keep("c" * 64, b"text", cached.TEXTS)
    (cache / "elements").mkdir()
    (cache / "elements" / "run.npz").write_bytes(bytes(3000))
    shown = softcat("cache").out
    assert "libraries  2, 500.2 kB of at most 2.0 MB\n" in shown and "texts      1, 7" in shown
    assert sorted(line.split()[0] for line in shown.splitlines() if ".c by gcc" in line) == ["a" * 12, "b" * 12]
    monkeypatch.setenv("CC", "/nowhere/cc")
    assert "compiler   none\n" in softcat("cache").out
    assert "deleted 2 compiled libraries" in softcat("cache", "--clear").out
    assert (cache / "elements" / "run.npz").exists()
    assert "libraries  0, " in softcat("cache").out
    # A folder of others is not cleared, and a limit that is no size is bad input.
    put("a", 100)
    (cache / "native").chmod(0o777)
    others = softcat("cache", "--clear")
    assert (others.status, "not cleared" in others.err, len(list((cache / "native").iterdir())) >= 1) == (2, True, True)
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "much")
    bad = softcat("cache")
    assert (bad.status, bad.out) == (2, "") and "SOFTCAT_CACHE_LIMIT is 'much'; accepted: " in bad.err


def offered(line: str, cwd: Path | None = None) -> str:
    """What the shell is offered behind the last word of a command line."""
    asking = {"COMP_WORDS": line, "COMP_CWORD": str(len(line.split(" ")) - 1)}
    done = program(cwd=cwd, _SOFTCAT_COMPLETE="complete_bash", **asking)
    assert done.stderr == ""
    return done.stdout


@pytest.mark.slow
def test_scenes_keys_and_paths_are_offered(tmp_path: Path) -> None:
    for line, offer in (
        *((f"{command} maxwell", ["maxwell-fast", "maxwell-slow"]) for command in ("run", "effects", "compare")),
        ("scenes --only putty", ["putty-arch"]),
        ("flow-curve curve.csv --scene putty", ["putty-arch"]),
        ("fit film.csv --scene putty", ["putty-arch"]),
        ("run ink-bridge --set numerics.c", ["numerics.cells="]),
    ):
        assert offered(f"softcat {line}").split() == offer
    for name in ("my-ink.toml", "my-ink.csv", "my-folder/inner.toml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("")
    assert set(offered("softcat run my", cwd=tmp_path).split()) == {"my-folder/", "my-ink.toml"}
    assert offered("softcat run my-folder/in", cwd=tmp_path).split() == ["my-folder/inner.toml"]
    assert offered("softcat run nowhere/in", cwd=tmp_path) == "\n"
    keys = complete_change("")
    assert {"title=", "material.yield_stress=", "groups.G=", "run.duration="} <= set(keys) - {"material="}
    assert tuple(complete_scene("")) == sc.bundled_names()


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


@pytest.mark.slow
def test_a_run_loads_neither_xarray_nor_dask_nor_scipy(tmp_path: Path) -> None:
    """Its fields are arrays, and its file is written without them; they take a second to load."""
    code = (
        "import sys\nsys.argv = ['softcat', 'run', 'cold-honey', '-q', '-o', sys.argv[1], '--set', 'run.frames=3']\n"
        "from softcat_sym.cli import main\n"
        "try:\n    main()\nexcept SystemExit as left:\n    assert not left.code, left.code\n"
        "heavy = {'xarray', 'pandas', 'dask', 'scipy', 'jinja2'} & set(sys.modules)\nassert not heavy, heavy\n"
    )
    done = subprocess.run([sys.executable, "-c", code, tmp_path], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def test_a_terminal_is_written_what_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "−10.1 mm ± 0.1 %, 3 µm × 2 μm, ≠ é, 日"
    assert plain(text) == "-10.1 mm +- 0.1 %, 3 um x 2 um, != e, ?"
    for encoding in ("ascii", "latin-1", "cp1252", "cp437", "utf-8"):
        written = io.BytesIO()
        monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding=encoding))
        print_whatever_the_terminal_takes()
        print(text, end="", flush=True)
        shown = written.getvalue().decode(encoding)
        assert shown == text if encoding == "utf-8" else shown.startswith("-10.1 mm ") and shown.endswith("?")
        # Bytes of a name that is no text are written as they are.
        print(os.fsdecode(b"d\xff"), end="", flush=True)
        assert written.getvalue().endswith(b"d\xff")


def test_nobody_reads_on() -> None:
    with subprocess.Popen([PROGRAM, "scenes"], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None and running.stderr is not None
        running.stdout.close()
        message = running.stderr.read()
    assert (running.returncode, message) == (141, b"")


def test_too_little_memory_is_one_sentence_and_no_window_is_needed(softcat: Softcat) -> None:
    for error in (MemoryError(), ImportError("libm.so: failed to map segment from shared object")):

        def refuse(*_: object, error: BaseException = error) -> None:
            raise error

        with softcat.monkeypatch.context() as patch:
            patch.setattr("softcat_sym.cli.application.scene_of", refuse)
            done = softcat("explain", "no-yield")
        assert done.status == 2
        assert "memory" in done.err and done.err.count("\n") == 1
    softcat.monkeypatch.setenv("MPLBACKEND", "nonsense")
    assert softcat("scenes").status in (0, None)
    assert os.environ["MPLBACKEND"] == "agg"


def test_whatever_is_no_scene_ends_soon(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.files._PATIENCE", 0.1)
    texts = {"deep": ".".join("a" * 200_000) + " = 1\n", "quoted": '"a".' * 100_000 + "b = 1\n"}
    texts |= {"brackets": "a = " + "[" * 500_000}
    for name, text in texts.items():
        (tmp_path / f"{name}.toml").write_text(text)
    cases = {"deep": "a key of more than 16 parts", "quoted": "a key of more than", "brackets": "not TOML"}
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe.toml")
        cases["pipe"] = "a pipe into which nobody has written"
    for name, text in cases.items():
        with pytest.raises(SceneError, match=text):
            sc.load_scene(tmp_path / f"{name}.toml")
    # Dots in a title are no parts of a key.
    (tmp_path / "dots.toml").write_text(sc.load_scene("no-yield").replace({"title": "a." * 100}).to_toml())
    assert sc.load_scene(tmp_path / "dots.toml").title == "a." * 100
