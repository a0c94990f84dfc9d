"""What all commands share: a folder of their own, faults in order, help that fits, and the commands about scenes."""

from __future__ import annotations

import os
import pty
import re
import select
import sys
import time
import tomllib
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.cli.application import output_directory
from softcat_sym.fitting.flow_curve import fit_flow_curve
from softcat_sym.fitting.measurements import read_measurements
from softcat_sym.scene.keys import LAWS, keys_in_markdown, scene_keys
from softcat_sym.scene.scene import known_keys
from tests.cli.in_process import Softcat

ROOT = Path(__file__).parents[2]
QUICK = ("--set", "run.duration=0.01 s", "--set", "numerics.estimate=false", "-q")


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Softcat:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    return Softcat(monkeypatch, capsys)


def test_every_summary_fits_in_80_columns_under_its_group(softcat: Softcat) -> None:
    said = softcat("-h").out
    groups = re.split(r"(?m)^(Everyday|Fitting|Validation|Developer):\n", said)[1:]
    assert groups[::2] == ["Everyday", "Fitting", "Validation", "Developer"]
    lines = [line for text in groups[1::2] for line in text.splitlines() if re.match(r"  [a-z-]+  ", line)]
    assert len(lines) == 20
    assert all(line.endswith(".") and not line.endswith("...") and len(line) <= 80 for line in lines)
    assert softcat("--help").out == said
    for line in lines:
        assert f"softcat {line.split()[0]} [OPTIONS]" in softcat(line.split()[0], "-h").out


@pytest.mark.parametrize(
    ("command", "scene", "folder"),
    [
        ("run", "ink-bridge", "ink-bridge"),
        ("card", "ink-bridge", "ink-bridge-card"),
        ("sweep", "deep/er/my-ink.toml", "my-ink-sweep"),
        ("run", "./no-yield", "no-yield"),
        ("figures", None, "figures"),
    ],
)
def test_each_command_has_a_folder_of_its_own(command: str, scene: str | None, folder: str) -> None:
    assert output_directory(None, command, scene) == Path("softcat-out") / folder


def test_a_card_goes_beside_the_run(softcat: Softcat, tmp_path: Path) -> None:
    for command in (("run",), ("card", "--no-span")):
        assert softcat(*command, "no-yield", *QUICK).status == 0
    assert softcat("draw", "softcat-out/no-yield", "-q").status == 0
    found = {path.name for path in (tmp_path / "softcat-out").iterdir()}
    assert found == {"no-yield", "no-yield-card", "no-yield-draw"}
    assert (tmp_path / "softcat-out" / "no-yield" / "trajectory.nc").is_file()
    assert (tmp_path / "softcat-out" / "no-yield-card" / "card.html").is_file()


@pytest.mark.parametrize(
    "command",
    [
        *(["run"], ["card"], ["explain"], ["effects"], ["accuracy"], ["generate"], ["compare"], ["phase"]),
        ["compare", "--vary", "groups.V=26,260"],
        ["sweep", "--vary", "filament.span=5 mm,6 mm"],
        ["experiment", "--free", "viscosity", "--noise", "1 %"],
        ["fit", "film.csv", "--free", "viscosity", "--scene"],
        ["flow-curve", "my-curve.csv", "--scene"],
    ],
    ids=lambda command: " ".join(command[:2]),
)
@pytest.mark.parametrize("change", ["filament.spam=1", 'run.effects=["gravty"]'])
def test_faults_of_the_scene_come_before_those_of_the_folder(softcat: Softcat, command: list[str], change: str) -> None:
    assert softcat("samples", "-o", ".", "-q").status == 0
    Path("file").write_text("")
    last = command[-1:] if command[-1] == "--scene" else []
    rest = [word for word in command if word not in last]
    done = softcat(*rest, *last, "continual-descent", "-o", "file/out", "--set", change)
    assert done.status == 2
    assert "is not a directory" not in done.err
    assert "filament.spam: unknown key" in done.err or "gravty" in done.err
    good = softcat(*rest, *last, "continual-descent", "-o", "file/out")
    assert (good.status, "is not a directory" in good.err) == (2, True)


@pytest.mark.parametrize("law", LAWS)
def test_new_writes_a_scene_of_every_law_with_comments(softcat: Softcat, law: str) -> None:
    done = softcat("new", "my-ink.toml", "--law", law, "--span", "4 mm")
    assert (done.status, done.err) == (0, "")
    text = Path("my-ink.toml").read_text()
    scene = sc.load_scene("my-ink.toml")
    assert (scene.title, scene.material.law, scene.filament.span, scene.filament.section) == (
        *("My ink", law, 0.004),
        "circle",
    )
    # Uncommented, the defaults that it shows are a scene, and the same one.
    shown = re.sub(r"(?m)^# (\w+ = )", r"\1", text)
    assert sc.Scene.model_validate(tomllib.loads(shown)) == scene
    assert all(re.match(r"#|\[|$|title|\w+ = ", line) for line in text.splitlines())


def test_new_takes_shear_data_and_says_what_they_are_in_tension(softcat: Softcat) -> None:
    constants = ("--shear-consistency", "60 Pa*s^0.4", "--index", "0.4", "--shear-yield-stress", "0.2 kPa")
    done = softcat("new", "hb.toml", "--law", "herschel-bulkley", *constants, "--surface-tension", "72 mN/m")
    assert "yield stress 200 Pa in shear = 346.41 Pa in tension" in done.out
    scene = sc.load_scene("hb.toml")
    assert scene.material.viscosity == pytest.approx(3**0.7 * 60, rel=1e-12)
    assert scene.material.yield_stress == pytest.approx(3**0.5 * 200, rel=1e-12)
    assert scene.surroundings.surface_tension == 0.072


def test_new_refuses_values_like_a_scene_and_never_overwrites_by_itself(softcat: Softcat) -> None:
    done = softcat(
        "new", "ink.toml", "--span", "3 mmm", "--shear-yield-stress", "200", "--index", "x", "--density", "-1 kg/m^3"
    )
    assert done.status == 2
    assert "scene ink.toml: 4 faults" in done.err
    for fault in ("filament.span: unknown unit 'mmm'", "material.shear_yield_stress: '200' has no unit"):
        assert fault in done.err
    assert not Path("ink.toml").exists()
    assert "does not yield" in softcat("new", "ink.toml", "--law", "elastic", "--shear-yield-stress", "1 Pa").err
    assert "material.law: 'custom', whose" in softcat("new", "ink.toml", "--law", "custom").err
    assert "ends in .toml" in softcat("new", "ink").err
    Path("ink.toml").write_text("mine")
    done = softcat("new", "ink.toml")
    assert (done.status, Path("ink.toml").read_text()) == (2, "mine")
    assert "there already" in done.err
    assert softcat("new", "ink.toml", "--force").status == 0
    assert sc.load_scene("ink.toml").title == "Ink"


def test_new_asks_on_a_terminal_again_where_an_answer_makes_no_sense(tmp_path: Path) -> None:
    answers = ["3 mmm", "3 mm", "0.1 mm", "", "newton", "newtonian", "", "", "20 ms"]
    child, terminal = pty.fork()
    if child == 0:
        os.chdir(tmp_path)
        command = [sys.executable, "-c", "from softcat_sym.cli import main; main()", "new", "asked.toml"]
        os.execv(sys.executable, command)
    said = b""
    for answer in answers:
        until = time.monotonic() + 60
        while not said.rstrip().endswith(b"]:") and time.monotonic() < until:
            if select.select([terminal], [], [], 1.0)[0]:
                said += os.read(terminal, 4096)
        said = b""
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


@pytest.mark.parametrize("name", sc.bundled_names())
def test_show_is_the_same_scene_with_every_default(softcat: Softcat, name: str) -> None:
    done = softcat("show", name, "--set", "run.frames=77")
    assert (done.status, done.err) == (0, "")
    Path("shown.toml").write_text(done.out)
    shown = sc.load_scene("shown.toml")
    assert shown == sc.load_scene(name, ["run.frames=77"])
    assert shown.run.frames == 77
    tables = tomllib.loads(done.out)
    missing = [
        key.path
        for key in scene_keys()
        if key.default not in ("", "required")
        and not key.path.startswith("groups.")
        and key.path.split(".")[-1] not in (tables.get(key.path.split(".")[0], {}) if "." in key.path else tables)
    ]
    assert missing == []


def test_every_key_is_listed_with_its_meaning(softcat: Softcat) -> None:
    keys = scene_keys()
    known = {".".join(filter(None, (table, key))) for table, names in known_keys().items() for key in names}
    assert {key.path for key in keys} == known - set(known_keys())
    assert [key.path for key in keys if not re.fullmatch(r"\S.*\.", key.meaning)] == []
    said = softcat("keys")
    assert said.status == 0
    assert all(len(line) <= 80 for line in said.out.splitlines())
    assert "filament.density  [kg/m^3]  required\n    Mass per volume, rho.\n" in said.out
    some = softcat("keys", "material").out
    assert {line.split()[0].split(".")[0] for line in some.splitlines() if line[0] != " "} == {"material"}
    assert 'Accepted: a positive stress with its unit, such as "9.32 kPa".' in " ".join(some.split())
    assert "no key has 'spam' in its name" in softcat("keys", "spam").err


def test_the_page_of_keys_is_current(softcat: Softcat) -> None:
    page = (ROOT / ".docs" / "manual" / "keys.md").read_text(encoding="utf-8")
    assert softcat("keys", "--markdown").out == keys_in_markdown() == page


def test_samples_are_read_by_the_commands_they_are_for(softcat: Softcat, tmp_path: Path) -> None:
    done = softcat("samples")
    folder = tmp_path / "softcat-out" / "samples"
    assert done.status == 0
    assert {path.name for path in folder.iterdir()} == {"my-ink.toml", "film.csv", "my-curve.csv"}
    assert softcat("samples").status == 0, "the same files again"
    (folder / "my-ink.toml").write_text("mine")
    done = softcat("samples")
    assert (done.status, (folder / "my-ink.toml").read_text()) == (2, "mine")
    assert softcat("samples", "--force", "-q").status == 0
    (film,) = read_measurements(folder / "film.csv").series
    assert film.time.size == 41
    fit = fit_flow_curve(folder / "my-curve.csv")
    assert fit.best.law == "bingham"
    assert fit.best.tau_Y is not None
    assert fit.best.tau_Y.value == pytest.approx(200, rel=0.03)
    for name in ("film.csv", "my-curve.csv"):
        assert "Not a measurement" in (folder / name).read_text()
    assert sc.load_scene(folder / "my-ink.toml").material.shear_yield_stress == 200
