"""The cache is this user's alone: it deletes only what the program has made, and takes nothing from anybody else."""

from __future__ import annotations

import os
import shutil
import time
from pathlib import Path

import pytest

from softcat_sym import cache, store
from softcat_sym.codegen.library import compile_library, load
from softcat_sym.errors import SoftcatError
from tests.common.compilers import ANSWER
from tests.common.in_process import Softcat
from tests.common.tiny_disk import files_in

ANOTHER = 12345
"""A user who is not there."""
KEY, OTHER = 64 * "a", 64 * "b"
OLD = 10 * cache.GRACE

of_root = pytest.mark.skipif(os.geteuid() != 0, reason="only root can give a file to another user")


@pytest.fixture(autouse=True)
def root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of the cache, with results in it as without tests."""
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "c"))
    monkeypatch.setattr(cache, "folder", lambda kind: cache.cache_folder() / kind)
    return tmp_path / "c"


# What is deleted.
def of_the_user(root: Path) -> dict[str, bytes]:
    """Files that a user may keep in the folder that SOFTCAT_CACHE names, and elsewhere with links from there to it."""
    documents = root.parent / "documents"
    for kind in cache.KINDS:
        # What the program keeps as a file may be a folder of the user, and the other way round.
        other = 64 * "3" if kind in (cache.LIBRARIES, cache.ZIG) else 64 * "3" + "/a"
        for name in ("thesis.csv", f"{KEY}.csv", f"{KEY[1:]}", f"{KEY.upper()}", f".{KEY}", f".{KEY}.copy/a", other):
            place = root / kind / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_bytes(b"mine")
        (documents / kind).mkdir(parents=True)
        (documents / kind / "letter").write_bytes(b"mine")
        (root / kind).chmod(0o700)
        (root / kind / (64 * "1")).symlink_to(documents / kind)
        (root / kind / (64 * "2")).symlink_to(documents / kind / "letter")
    (root / "zig" / "project").mkdir()
    (root / "zig" / "project" / "main.zig").write_bytes(b"mine")
    return files_in(root.parent)


def fill(root: Path, kind: str, key: str, age: float = OLD, size: int = 1000) -> Path:
    """An entry as the program makes it: of libraries and of zig it is a folder."""
    place = root / kind / key
    if kind in (cache.LIBRARIES, cache.ZIG):
        place.mkdir(mode=0o700)
        (place / "library.so").write_bytes(bytes(size))
    else:
        place.write_bytes(bytes(size))
        place.chmod(0o600)
    os.utime(place, (time.time() - age,) * 2)
    return place


def test_clearing_and_trimming_take_what_the_program_made_and_nothing_else(softcat: Softcat, root: Path) -> None:
    mine = of_the_user(root)
    made = [fill(root, kind, name) for kind in cache.KINDS for name in (KEY, OTHER, f".{KEY}.{8 * '0'}")]
    os.utime(made[2], (0, 0))
    for kind in cache.KINDS:
        cache.trim(kind, 1500, KEY)
    assert {path.name for path in made if path.exists()} == {KEY, f".{KEY}.{8 * '0'}"} and not made[2].exists()
    done = softcat("cache", "--clear")
    assert done.status in (0, None) and f"deleted 1 compiled library from {root / 'native'}: 1.0 kB freed" in done.out
    assert [path for path in made if path.exists()] == [made[k] for k in (5, 8, 11)], "what is being made stays"
    for path in (made[5], made[8], made[11]):
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    assert files_in(root.parent) == mine


@pytest.mark.parametrize(
    "whose",
    [*(pytest.param(f"the {name}'s", marks=of_root) for name in ("parent", "parent's parent", "cache")), "of all"],
)
def test_where_others_can_write_nothing_is_taken_and_nothing_kept(
    whose: str, root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Not even for a moment: who owns a folder above could swap what is below between a check and the loading."""
    above = tmp_path / "x" / "y"
    root = above / "c"
    monkeypatch.setenv("SOFTCAT_CACHE", str(root))
    path = compile_library(ANSWER)
    store.keep(KEY, b"content")
    assert root.stat().st_mode & 0o777 == path.parent.stat().st_mode & 0o777 == 0o700, "and what was missing above"
    place = {"the parent's": above, "the parent's parent's": above.parent}.get(whose, root)
    if whose == "of all":
        place.chmod(0o777)
    else:
        os.chown(place, ANOTHER, ANOTHER)
    before = files_in(tmp_path)
    message = "can be written by others.*chmod go-w" if whose == "of all" else "belongs to another user"
    with pytest.warns(UserWarning, match=f"nothing is kept in {root}: {place}.* {message}"):
        assert store.recall(KEY) is None
        store.keep(OTHER, b"content")
        other = compile_library(ANSWER)
    assert root not in other.parents and load(other, "answer").answer() == 42
    assert not any(root in entry.path.parents for entry in cache.entries(cache.LIBRARIES))
    with pytest.raises(SoftcatError, match=f"not cleared: .*{message}"):
        cache.clear(*cache.KINDS)
    assert files_in(tmp_path) == before


@of_root
@pytest.mark.parametrize("what", ["another's", "open", "link", "pipe", "folder", "huge"])
def test_a_result_that_is_not_this_users_own_file_is_not_there(
    what: str, root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    store.keep(KEY, b"content")
    path = root / "results" / KEY
    if what == "another's":
        os.chown(path, ANOTHER, ANOTHER)
    elif what == "open":
        path.chmod(0o666)
    elif what != "huge":
        path.rename(root / "elsewhere")
        make = {"link": lambda: path.symlink_to(root / "elsewhere"), "pipe": lambda: os.mkfifo(path)}
        make.get(what, path.mkdir)()
    with monkeypatch.context() as patch:
        if what == "huge":
            patch.setattr(cache, "_LARGEST", 50)
        assert store.recall(KEY) is None
    if what != "folder":
        store.keep(KEY, b"another")
        assert store.recall(KEY) == b"another", "and another takes its place"


# The limit: what was used least recently goes.
def test_the_least_recently_used_go_until_the_limit_holds(root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (root / "native").mkdir(parents=True, mode=0o700)

    def left(stored: str, limit: int = 3500) -> str:
        cache.trim(cache.LIBRARIES, limit, 64 * stored)
        return "".join(sorted(entry.path.name[0] for entry in cache.entries(cache.LIBRARIES)))

    for name, age in zip("abcd", (3 * OLD, 2 * OLD, OLD, 0), strict=True):
        fill(root, cache.LIBRARIES, 64 * name, age)
    cache.touch(root / "native" / (64 * "a"))
    assert left("d") == "acd"
    assert left("d", 0) == "ad", "used within the minute"
    monkeypatch.setattr(cache, "GRACE", -1.0)  # a file server whose clock is behind
    fill(root, cache.LIBRARIES, 64 * "f", OLD, size=10_000)
    assert left("f") == "f", "the one just stored stays, however large"
