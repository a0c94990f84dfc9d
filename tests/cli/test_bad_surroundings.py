"""What surrounds the command: terminals without signs, closed pipes, windows that are not there, little memory."""

from __future__ import annotations

import io
import os
import subprocess
import sys
from pathlib import Path

import pytest

from softcat_sym.cli.streams import plain, print_whatever_the_terminal_takes
from softcat_sym.errors import SceneError
from softcat_sym.scene.reading import load_scene

from .in_process import Softcat

PROGRAM = str(Path(sys.executable).with_name("softcat"))


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "cp1252", "cp437", "utf-8"])
def test_a_terminal_is_written_what_it_has(encoding: str, monkeypatch: pytest.MonkeyPatch) -> None:
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding=encoding))
    print_whatever_the_terminal_takes()
    text = "−10.1 mm ± 0.1 %, 3 µm × 2 μm, ≠ é, 日"
    print(text, end="", flush=True)
    said = written.getvalue().decode(encoding)
    if encoding == "utf-8":
        assert said == text
    else:
        assert said.startswith("-10.1 mm ") and said.endswith("?")
    assert plain(text) == "-10.1 mm +- 0.1 %, 3 um x 2 um, != e, ?"


def test_bytes_of_a_name_that_is_no_text_are_written_as_they_are(monkeypatch: pytest.MonkeyPatch) -> None:
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding="utf-8"))
    print_whatever_the_terminal_takes()
    print(os.fsdecode(b"d\xff"), end="", flush=True)
    assert written.getvalue() == b"d\xff"


@pytest.mark.skipif(sys.platform == "win32", reason="pipes of POSIX")
def test_nobody_reads_on() -> None:
    with subprocess.Popen([PROGRAM, "scenes"], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None and running.stderr is not None
        running.stdout.close()
        said = running.stderr.read()
    assert (running.returncode, said) == (141, b"")


@pytest.mark.parametrize("error", [MemoryError(), ImportError("libm.so: failed to map segment from shared object")])
def test_too_little_memory_is_one_sentence(error: BaseException, softcat: Softcat, tmp_path: Path) -> None:
    def refuse(*_: object) -> None:
        raise error

    softcat.monkeypatch.setattr("softcat_sym.cli.explain.scene_of", refuse)
    done = softcat("explain", "no-yield")
    assert done.status == 2
    assert "memory" in done.err and done.err.count("\n") == 1


def test_no_window_is_needed(softcat: Softcat) -> None:
    softcat.monkeypatch.setenv("MPLBACKEND", "nonsense")
    assert softcat("scenes").status in (0, None)
    assert os.environ["MPLBACKEND"] == "agg"


@pytest.mark.parametrize("command", ["run", "explain", "sweep"])
def test_an_empty_name_is_no_folder(command: str, softcat: Softcat) -> None:
    done = softcat(command, "no-yield", "-o", "")
    assert (done.status, "an empty name is no folder" in done.err) == (2, True)


def test_whatever_is_no_scene_ends_soon(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.files._PATIENCE", 0.1)
    (tmp_path / "deep.toml").write_text(".".join("a" * 200_000) + " = 1\n")
    (tmp_path / "quoted.toml").write_text('"a".' * 100_000 + "b = 1\n")
    (tmp_path / "brackets.toml").write_text("a = " + "[" * 500_000)
    cases = {"deep": "a key of more than 16 parts", "quoted": "a key of more than", "brackets": "not TOML"}
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe.toml")
        cases["pipe"] = "a pipe into which nobody has written"
    for name, said in cases.items():
        with pytest.raises(SceneError, match=said):
            load_scene(tmp_path / f"{name}.toml")


def test_dots_in_a_title_are_no_parts_of_a_key(tmp_path: Path) -> None:
    scene = tmp_path / "dots.toml"
    scene.write_text(load_scene("no-yield").replace({"title": "a." * 100}).to_toml())
    assert load_scene(scene).title == "a." * 100


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)
