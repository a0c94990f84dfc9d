"""What strangers met: every point of their reports, with what happens now, as one table.

`pytest -m slow tests/slow/test_strangers.py` prints the table after the last test.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from hashlib import sha256
from pathlib import Path

import pytest

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.library import compile_library
from tests.common.compilers import ANSWER, COMPILE
from tests.common.in_process import Softcat, sets
from tests.common.table import rows_of
from tests.common.tiny_disk import files_in, tiny_disk

pytestmark = pytest.mark.slow

Says = Callable[..., None]


@pytest.fixture(scope="module")
def says(request: pytest.FixtureRequest) -> Iterator[Says]:
    """Take a row of the table: the point, what was met, what happens now."""
    rows = list[tuple[str, str, str]]()

    def say(point: str, met: str, now: object) -> None:
        rows.append((point, met, str(now)))

    yield say
    lines = rows_of(("point", "what strangers met", "what happens now"), sorted(rows))
    terminal = request.config.pluginmanager.getplugin("terminalreporter")
    for line in ("", *lines) if terminal is not None else ():
        terminal.write_line(line)


# --- A: checks on random draws


# --- B1: the regime does not depend on the frames


# --- B2: a creep is not a swing


# --- B3: errors are relative to the largest displacement


# --- B4: natural frequencies of what hangs slack


# --- B5: polymer threads


# --- B6: the time of breaking


# --- B7: what a fit calls identified


# --- B8: what explain says an effect is worth


# --- B9: the error of the slender theory


# --- C1: the price of a run is said before it starts


# --- C2: a run that falls for ever ends


# --- C3: time limits and interrupts


# --- C4: helices and histories are bounded when a scene is read


# --- C5: time limits of fits


# --- D1: clearing the cache leaves the user's files alone
def command(*words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """The ``softcat`` command in a process of its own."""
    given = [sys.executable, "-c", "import sys; sys.argv[0] = 'softcat'\nfrom softcat_sym.cli import main; main()"]
    changed = {**os.environ, **environment}
    return subprocess.run([*given, *words], env=changed, capture_output=True, text=True, check=False)


@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
def test_the_cache_is_cleared_of_what_the_program_made_alone(
    says: Says, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    cache, documents = tmp_path / "c", tmp_path / "documents"
    monkeypatch.setenv("SOFTCAT_CACHE", str(cache))
    compile_library(ANSWER)
    documents.mkdir()
    for place in (documents, *(cache / kind for kind in ("results", "native", "texts"))):
        place.mkdir(mode=0o700, exist_ok=True)
        (place / "thesis.csv").write_text("mine")
        (place / (64 * "a")).symlink_to(documents)
    mine = {name: content for name, content in files_in(tmp_path).items() if name.endswith("thesis.csv")}
    monkeypatch.setenv("SOFTCAT_CACHE_LIMIT", "0")
    compile_library({"other.c": "int other;\n"})
    assert mine.items() <= files_in(tmp_path).items()
    cleared = command("cache", "--clear")
    assert cleared.returncode == 0 and files_in(tmp_path) == mine
    shutil.rmtree(cache / "results")
    (cache / "results").symlink_to(documents)
    linked = command("cache", "--clear")
    assert linked.returncode == 2 and "not cleared" in linked.stderr and (documents / "thesis.csv").exists()
    says("D1", "cache --clear deletes c/results/thesis.csv", f"it stays; {cleared.stdout.split(' from')[0]}")
    says("D1", "a link c/results -> DOCS empties DOCS", linked.stderr.strip().replace(str(tmp_path), ""))


# --- D2: nobody else's code or results are loaded
@pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root can give files to another user")
def test_what_another_user_planted_is_not_loaded(says: Says, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    cache, made, mark = tmp_path / "home" / "c", tmp_path / "evil.so", tmp_path / "mark"
    monkeypatch.setenv("SOFTCAT_CACHE", str(cache))
    (tmp_path / "evil.c").write_text(
        "#include <stdio.h>\nint answer(void) { return 666; }\n__attribute__((constructor)) static void begin(void) "
        f'{{ FILE *file = fopen("{mark}", "w"); fclose(file); }}\n'
    )
    compiler = find_compiler()
    assert compiler is not None  # for mypy
    subprocess.run([*compiler.command, "-shared", "-fPIC", "-o", str(made), str(tmp_path / "evil.c")], check=True)

    def plant() -> None:
        """Put code in place of every library, with the digest that belongs to it."""
        for entry in (cache / "native").iterdir():
            shutil.copy(made, entry / "library.so")
            digest = sha256(entry.name.encode() + made.read_bytes()).hexdigest()
            for name in ("about.txt", "library.sha256"):
                (entry / name).write_text(digest + "\n")
            for path in (*entry.iterdir(), entry):
                os.chown(path, 12345, 12345)

    def ran() -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, "-c", COMPILE], capture_output=True, text=True, check=True)

    compile_library(ANSWER)
    plant()
    (cache / "native").chmod(0o700)  # as the message had advised
    done = ran()
    assert (done.stdout, done.stderr, mark.exists()) == ("42\n", "", False)
    assert {entry.stat().st_uid for entry in (cache / "native").iterdir()} == {0}
    says("D2", "a planted library is loaded once the mode was mended", "it is compiled again; the planted one is gone")
    plant()
    os.chown(cache.parent, 12345, 12345)
    done = ran()
    assert (done.stdout, mark.exists()) == ("42\n", False)
    assert f"{cache.parent} belongs to another user" in done.stderr
    said = done.stderr.splitlines()[0].partition("UserWarning: ")[2].partition(";")[0].replace(str(tmp_path), "")
    says("D2", "its folder is swapped where the parent is another's", said)


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root can give files to another user")
def test_what_others_put_among_the_results_is_not_there(
    says: Says, softcat: Softcat, tmp_path: Path, results_of_studies: Path
) -> None:
    short = sets("numerics.cells=6", "run.frames=21")
    words = ["sweep", "arrested-overdamped", "--vary", "groups.G=0.1:0.5:3", "--workers", "1", "-q", *short]

    def resumed() -> int:
        done = softcat(*words, "-o", str(tmp_path / "out"))
        assert (done.status, done.err) == (0, "")
        return int(json.loads((tmp_path / "out" / "sweep.json").read_text())["resumed_members"])

    assert [resumed(), resumed()] == [0, 3]
    for what in ("a pipe", "a link", "another's"):
        for path in list(results_of_studies.iterdir()):
            if what == "another's":
                os.chown(path, 12345, 12345)
                continue
            path.rename(tmp_path / path.name)
            os.mkfifo(path) if what == "a pipe" else path.symlink_to(tmp_path / path.name)
        assert resumed() == 0, what
    says("D2", "results that are another's, links or pipes are read", "they count as not there, and are run again")


# --- D3: a full disk is no crash
def test_on_a_full_disk_every_writer_says_so_and_leaves_nothing(says: Says, softcat: Softcat, tmp_path: Path) -> None:
    short, whole = sets("numerics.cells=6", "run.frames=21", "numerics.estimate=false"), str(tmp_path / "whole")
    assert softcat("run", "arrested-overdamped", "-q", "--no-pictures", *short, "-o", whole).status in (0, None)
    sweep = ("sweep", "arrested-overdamped", "--vary", "groups.G=0.1:0.5:25", "--workers", "1", "-q", *short)
    film = ("draw", whole, "-q", "--animate", "gif", "--animate-seconds", "0.5")
    for words, sizes in {sweep: (32, 64, 16), film: (300,), ("draw", whole, "-q", "--vtk"): (400,)}.items():
        for kilobytes in sizes:
            with tiny_disk(tmp_path / f"{words[-1]}-{kilobytes}", kilobytes) as disk:
                done = command(*words, "-o", str(disk / "out"))
                assert (done.returncode, done.stdout) == (2, ""), done.stderr
                assert done.stderr.startswith(f"softcat: cannot write the results: No space left on device ({disk}/out")
                assert done.stderr.count("\n") == 1 and not list(disk.iterdir())
    says("D3", "segmentation fault of sweep on a disk of 64 kB", "status 2: No space left on device (DIR); DIR is gone")
    says("D3", "films and VTK", "the same")
