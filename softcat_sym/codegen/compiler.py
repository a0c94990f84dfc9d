"""The C compiler of this machine: where it is, what it takes, how it is run so that nothing outlives Ctrl-C."""

from __future__ import annotations

import contextlib
import functools
import hashlib
import importlib.util
import itertools
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path

from softcat_sym import cache, store
from softcat_sym.errors import SoftcatError
from softcat_sym.interrupts import Interrupts, interrupts_go_to


def run(
    command: Sequence[str],
    seconds: float,
    folder: Path,
    zig: Path | None = None,
    on_wait: Callable[[], object] = lambda: None,
) -> subprocess.CompletedProcess[str]:
    """Run a command to its end in a folder, and take what it says; `on_wait` is called now and then until then.

    Zig compiles the libraries of C for itself, once; where `zig` does not say where it keeps them, the folder has them.
    """
    kept = os.environ.get("ZIG_GLOBAL_CACHE_DIR") or str(zig or folder / "zig")
    # Held back while the process is being started: raised then, it would leave one that nobody knows of.
    interrupts = Interrupts(held_back=True)
    with (
        interrupts_go_to(interrupts.note),
        subprocess.Popen(
            command,
            cwd=folder,
            # In the C locale messages are in English, where the word "error" marks the lines that matter.
            env={**os.environ, "LC_ALL": "C", "TMPDIR": str(folder), "ZIG_GLOBAL_CACHE_DIR": kept},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            # A group of its own: a compiler is a driver whose passes would live on if only the driver were killed.
            start_new_session=True,
        ) as process,
    ):
        began, stop = time.monotonic(), _stop.get()
        try:
            interrupts.check()
            while process.returncode is None:
                try:
                    out, err = process.communicate(timeout=_LOOK)
                except subprocess.TimeoutExpired:
                    if stop is not None and stop.is_set():
                        raise KeyboardInterrupt from None
                    on_wait()
                    if time.monotonic() - began > seconds:
                        raise
        except BaseException:
            _kill_group(process)
            process.wait()  # After Ctrl-C Popen would wait for a quarter of a second only, and leave the process behind
            raise
    return subprocess.CompletedProcess(command, process.returncode, out, err)


_LOOK = 0.1  # s, between two looks at whether to go on waiting for a process

_stop: ContextVar[threading.Event | None] = ContextVar("stop", default=None)
"""Set by another thread where what :func:`run` runs in this one is to end."""


def _kill_group(process: subprocess.Popen[str]) -> None:
    if sys.platform == "win32":
        process.kill()
    else:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)


_DAY = 86400.0
# A clang on Windows usually makes libraries for Microsoft's linker, which takes other flags and exports no name.
_USUAL = ("cc", "gcc") if sys.platform == "win32" else ("cc", "gcc", "clang")
TO_INSTALL = "install gcc or clang (or pip install 'softcat_sym[compiler]'), or set CC"
"""What a user without a C compiler can do."""
_PATIENCE = 10.0  # s, for a compiler to say its version, which takes a tenth of one


@dataclass(frozen=True, slots=True)
class Compiler:
    """A C compiler that runs."""

    command: tuple[str, ...]  # How it is called: its path first, then what the variable CC says besides
    version: str  # First line of what ``--version`` prints

    @property
    def path(self) -> Path:
        """The executable."""
        return Path(self.command[0])

    @property
    def name(self) -> str:
        """In short, for summaries: ``gcc 12.2.0``."""
        # GNU: "cc (Debian 12.2.0-14+deb12u1) 12.2.0", whatever name it was called by; others: "clang version 17.0.6".
        gnu = re.match(r"(\S+) \(.*?\) (\d+(?:\.\d+)+)", self.version)
        if gnu is not None:
            return f"gcc {gnu[2]}"
        number = re.search(r"\d+(?:\.\d+)+", self.version)
        kind = "clang" if "clang" in self.version else self.version.split()[0]
        return f"{kind} {number[0]}" if number is not None else kind


def compiler_name() -> str:
    """In short what :func:`find_compiler` finds, such as ``gcc 12.2.0``; empty where there is none."""
    found = find_compiler()
    return "" if found is None else found.name


def find_compiler() -> Compiler | None:
    """The compiler that the variable CC names (with its flags), else cc, gcc or clang on the PATH, else ziglang's.

    It is asked for its version once: as long as its file stays the same, what it said is read from the cache.
    """
    named = split_variable("CC")
    wheel = ([*command, "-mcpu=baseline"] for command in of_a_wheel())
    return first_of([named] if named else itertools.chain(([name] for name in _USUAL), wheel))


def first_of(commands: Iterable[Sequence[str]]) -> Compiler | None:
    """The first of these commands that runs; None where none does."""
    for command in commands:
        path = shutil.which(command[0])
        if path is not None:
            # Absolute, since it will be called from another folder.
            whole = (str(Path(path).absolute()), *command[1:])
            # Of every executable that is named: ``ccache gcc`` names two.
            words = (shutil.which(word) for word in whole if not word.startswith("-"))
            stats = [(word, Path(word).stat()) for word in words if word is not None]
            version = _version(whole, tuple((word, stat.st_size, stat.st_mtime_ns) for word, stat in stats))
            if version:
                return Compiler(whole, version)
    return None


def of_a_wheel() -> Iterator[list[str]]:
    """The C compiler of the package ziglang, for processors of many kinds; none where it is not installed."""
    found = importlib.util.find_spec("ziglang")
    folders = found.submodule_search_locations if found is not None else None
    yield from ([str(Path(folder) / "zig"), "cc"] for folder in folders or ())


def build_identity() -> list[str]:
    """What decides machine code beside its sources: command and version of the compiler, and flags from outside."""
    found = find_compiler()
    return [] if found is None else [*found.command, found.version, *split_variable("SOFTCAT_CFLAGS")]


def split_variable(name: str) -> list[str]:
    """The words of an environment variable, as a shell would split them."""
    text = os.environ.get(name, "")
    try:
        return shlex.split(text)
    except ValueError as error:
        raise SoftcatError(f"{name} is {text!r}: {error}") from error


@functools.lru_cache(maxsize=8)
def _version(command: tuple[str, ...], files: tuple[tuple[str, int, int], ...]) -> str:
    """The version that a compiler says it has; empty where it does not run, or has no linker.

    It is asked again if its files change.

    A wrapper's file does not change with the compiler behind it, so what was said counts for a day.
    """
    key = store.key_of("compiler", command, files, time.time() // _DAY)
    if (known := store.recall(key, cache.TEXTS)) is not None:
        return known.decode()
    said = (_output(*command, "--version") or "").strip()
    # One without its linker (gcc where there is no PATH) says its version, too. Apple's linker knows -v alone.
    asks_linker = ((*command, "-nostdlib", "-shared", f"-Wl,{version}") for version in ("--version", "-v"))
    version = said.splitlines()[0].strip() if said and any(_output(*one) is not None for one in asks_linker) else ""
    if version:
        store.keep(key, version.encode(), cache.TEXTS)
    return version


UNKNOWN = "unknown"
"""The processor of a compiler that does not know flags such as ``-march=native``."""


def processor(compiler: Compiler, flags: Sequence[str]) -> str:
    """Hash of what flags such as ``-march=native`` make of this processor; empty where no flag asks for it.

    It hashes the macros that the compiler defines under these flags, which name the instruction sets. Not kept on disk:
    machines with different processors may share a home.
    """
    native = tuple(flag for flag in flags if flag.startswith("-m") and flag.endswith("=native"))
    return _processor(compiler, native) if native else ""


@functools.lru_cache(maxsize=8)
def _processor(compiler: Compiler, flags: tuple[str, ...]) -> str:
    macros = _output(*compiler.command, *flags, "-dM", "-E", "-x", "c", os.devnull)
    return hashlib.sha256(macros.encode()).hexdigest()[:16] if macros else UNKNOWN


def _output(*command: str) -> str | None:
    """What a command prints, or None where it fails."""
    try:
        with tempfile.TemporaryDirectory(prefix="softcat_sym-") as passing:
            done = run(command, _PATIENCE, Path(passing))
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout if done.returncode == 0 else None


@contextlib.contextmanager
def beside(work: Callable[[], object]) -> Iterator[None]:
    """Do some work while the block does its own; both are done at its end."""
    stop = threading.Event()

    def whole() -> None:
        _stop.set(stop)
        work()

    with ThreadPoolExecutor(1, "softcat beside") as pool:
        done = pool.submit(whole)
        try:
            yield
            done.result()
        except BaseException:
            stop.set()
            raise
