"""Completion as a shell asks for it: through the environment, in a new process."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.cli.completing import complete_change, complete_scene

SOFTCAT = Path(sys.executable).parent / "softcat"
SHELLS = ("bash", "zsh", "fish")


def softcat(*arguments: str, cwd: Path | None = None, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [SOFTCAT, *arguments],
        cwd=cwd,
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
        timeout=30,
    )


def offered(line: str, shell: str = "bash", cwd: Path | None = None) -> str:
    """What the shell is offered behind the last word of a command line."""
    asking = {
        "bash": {"COMP_WORDS": line, "COMP_CWORD": str(len(line.split(" ")) - 1)},
        "zsh": {"_TYPER_COMPLETE_ARGS": line},
        "fish": {"_TYPER_COMPLETE_ARGS": line, "_TYPER_COMPLETE_FISH_ACTION": "get-args"},
    }[shell]
    done = softcat(cwd=cwd, _SOFTCAT_COMPLETE=f"complete_{shell}", **asking)
    assert done.stderr == ""
    return done.stdout


@pytest.mark.parametrize("shell", SHELLS)
def test_commands_and_scenes_are_offered(shell: str) -> None:
    assert "explain" in offered("softcat exp", shell)
    scenes = offered("softcat run ink", shell)
    assert "ink-bridge" in scenes
    assert "maxwell" not in scenes


@pytest.mark.parametrize("command", ["run", "explain", "effects", "accuracy", "generate", "compare"])
def test_every_command_with_a_scene_offers_them(command: str) -> None:
    assert offered(f"softcat {command} maxwell").split() == ["maxwell-fast", "maxwell-slow"]


def test_options_that_name_a_scene_offer_them() -> None:
    for line in ("scenes --only putty", "flow-curve curve.csv --scene putty", "fit film.csv --scene putty"):
        assert offered(f"softcat {line}").split() == ["putty-arch"]


def test_keys_of_a_scene_are_offered() -> None:
    assert offered("softcat run ink-bridge --set numerics.c").split() == ["numerics.cells="]


def test_every_offered_key_is_known_to_scenes_and_every_scene_is_a_scene() -> None:
    keys = complete_change("")
    assert {"title=", "material.yield_stress=", "groups.G=", "run.duration="} <= set(keys)
    assert "material=" not in keys
    for key in keys:
        with pytest.raises(sc.SceneError) as refused:
            sc.load_scene("continual-descent", [f"{key}nonsense", "title.spam=1"])
        assert "unknown key" not in str(refused.value).split("title.spam")[0], key
    assert tuple(complete_scene("")) == sc.bundled_names()


def test_files_and_folders_are_offered_by_path(tmp_path: Path) -> None:
    (tmp_path / "my-ink.toml").write_text("")
    (tmp_path / "my-ink.csv").write_text("")
    (tmp_path / "my-folder").mkdir()
    (tmp_path / "my-folder" / "inner.toml").write_text("")
    assert set(offered("softcat run my", cwd=tmp_path).split()) == {"my-folder/", "my-ink.toml"}
    assert offered("softcat run my-folder/in", cwd=tmp_path).split() == ["my-folder/inner.toml"]
    assert offered("softcat run nowhere/in", cwd=tmp_path) == "\n"


@pytest.mark.parametrize("shell", SHELLS)
def test_script_is_shown_and_installed(shell: str, tmp_path: Path) -> None:
    home = {"HOME": str(tmp_path), "ZDOTDIR": str(tmp_path), "_TYPER_COMPLETE_TEST_DISABLE_SHELL_DETECTION": "1"}
    shown = softcat("--show-completion", shell, **home)
    assert shown.returncode == 0
    assert "_SOFTCAT_COMPLETE" in shown.stdout
    assert not list(tmp_path.iterdir())
    done = softcat("--install-completion", shell, **home)
    assert done.returncode == 0, done.stderr
    files = [path for path in tmp_path.rglob("*") if path.is_file()]
    assert any("_SOFTCAT_COMPLETE" in path.read_text() for path in files)


def test_a_tab_is_answered_before_one_notices() -> None:
    """Half a second of the processor, the best of three: how long one waits where nothing else runs."""

    def seconds(line: str) -> float:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        assert offered(line).strip()
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime

    for line in ("softcat run ink", "softcat run ink-bridge --set material.y"):
        assert min(seconds(line) for _ in range(3)) < 0.5


def test_a_tab_loads_nothing_heavy() -> None:
    code = (
        "import sys\nfrom softcat_sym.cli.completing import complete_change, complete_scene\n"
        "assert complete_scene('ink') and complete_change('material.')\n"
        "heavy = {'sympy', 'casadi', 'matplotlib', 'xarray', 'numpy'} & set(sys.modules)\nassert not heavy, heavy"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
