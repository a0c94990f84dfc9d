"""Results and long integrations that outlive an interruption."""

from __future__ import annotations

import hashlib
import io
import json
import time
import zipfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically, made
from softcat_sym.solvers.solution import Progress, Reached, watched

Result = TypeVar("Result")
Arrays = Mapping[str, npt.NDArray[Any]]
Identity = Callable[[], Iterable[bytes | str]]
"""All that decides a result; asked for only where results are kept."""


class Keeper(Protocol):
    """Where results are kept."""

    def find(self, key: str) -> bytes | None:
        """Return what was kept under a key, None if nothing was."""

    def mark(self) -> int:
        """Return a number for this moment, to be given to :meth:`keep`."""

    def keep(self, key: str, content: bytes, since: int) -> None:
        """Keep a result; what was kept since a moment was part of it, and is not needed any more."""


@dataclass(frozen=True)
class Form(Generic[Result]):
    """How a result is written, so that reading it gives the same to the last bit."""

    write: Callable[[Result], bytes]  # To bytes and back
    read: Callable[[bytes], Result]


_keeper: ContextVar[Keeper | None] = ContextVar("keeper", default=None)


@contextmanager
def kept_by(keeper: Keeper) -> Iterator[None]:
    """Let whatever is :func:`kept` meanwhile, in this thread, be kept there."""
    before = _keeper.set(keeper)
    try:
        yield
    finally:
        _keeper.reset(before)


def kept(identity: Identity, compute: Callable[[], Result], form: Form[Result]) -> Result:
    """Return a result: what was kept of it, if anything was, otherwise what `compute` returns, which is then kept."""
    keeper = _keeper.get()
    if keeper is None:
        return compute()
    key = _hash(identity())
    content = keeper.find(key)
    if content is not None:
        return form.read(content)
    begun = keeper.mark()
    with watched() as interrupts:
        result = compute()
        interrupts.check()
    keeper.keep(key, form.write(result), begun)
    return result


def packed(arrays: Arrays) -> bytes:
    """Write arrays of numbers or text."""
    stream = io.BytesIO()
    np.savez(stream, **arrays)  # type: ignore[arg-type]
    return stream.getvalue()


def unpacked(content: bytes) -> dict[str, npt.NDArray[Any]]:
    """Read what :func:`packed` wrote."""
    with np.load(io.BytesIO(content), allow_pickle=False) as archive:
        return {name: archive[name] for name in archive.files}


def json_form(write: Callable[[Result], Any], read: Callable[[Any], Result]) -> Form[Result]:
    """Return the form of what becomes plain lists, dictionaries, text and numbers; infinities and NaN are kept."""
    return Form(lambda result: json.dumps(write(result)).encode(), lambda content: read(json.loads(content)))


def _hash(parts: Iterable[bytes | str]) -> str:
    """Hash of parts, each with its length, so that none can be taken for two."""
    found = hashlib.sha256()
    for part in parts:
        content = part.encode() if isinstance(part, str) else part
        found.update(len(content).to_bytes(8, "little"))
        found.update(content)
    return found.hexdigest()


EVERY = 5.0
"""Seconds between two checkpoints of an integration, and before the first."""

WORTH = 1.0
"""Seconds that an interrupted integration must have run for to be kept."""

_VERSION = "1"
_SHORT = 16

CheckpointIdentity = Callable[[], Iterable[bytes]]
"""All that decides the numbers of an integration; asked for only when there is something to find or to keep."""


class Checkpoints:
    """A folder with a file for each integration that takes long; it is made when the first is written.

    A run consists of several integrations: the answer, coarser ones beside it, finer ones after it. Each is known by a
    hash of all that decides its numbers, so that no file is ever taken for the state of another.
    """

    def __init__(self, folder: Path, owner: bytes, *, resume: bool = False, every: float = EVERY) -> None:
        self.folder, self.every = folder, every
        self.resumed, self.kept, self.trouble = 0, False, ""
        self._owner, self._resume = _hash_of_identity([owner])[:_SHORT], resume
        files = sorted(folder.glob("*.npz")) if resume else []
        if files and not any(path.name.startswith(self._owner) for path in files):
            raise SoftcatError(
                f"{folder} is the checkpoint of another scene or version of this program; "
                "leave out --resume to begin anew, or name another DIR"
            )

    def of(self, identity: CheckpointIdentity) -> Checkpoint:
        """The place of one integration that begins now."""
        return Checkpoint(self, identity)

    def path(self, key: str) -> Path:
        """The file of an integration."""
        return self.folder / f"{self._owner}-{key[:_SHORT]}.npz"

    def find(self, identity: CheckpointIdentity) -> Reached | None:
        """What is known of an integration, if it is to be resumed."""
        if not self._resume or not self.folder.is_dir():
            return None
        key = _hash_of_identity(identity())
        found = _read(self.path(key), key)
        self.resumed += found is not None
        return found

    def keep(self, identity: CheckpointIdentity, reached: Reached) -> None:
        """Write a state whole or not at all; a full disk is told, and does not end the run.

        The start alone is not worth a file.
        """
        if reached.frames == 1:
            return
        key = _hash_of_identity(identity())
        arrays: dict[str, Any] = {"key": np.array(key), "steps": np.array(reached.steps)}
        arrays |= {"x": reached.x, "z": reached.z, "quad": reached.quad}

        def fill(passing: Path) -> None:
            with passing.open("xb") as stream:
                np.savez(stream, **arrays)

        try:
            with made(self.folder):
                fill_atomically(self.path(key), fill)
        except OSError as error:
            self.trouble = f"cannot write the checkpoint in {self.folder}: {error.strerror or error}"
        else:
            self.kept = True

    def clear(self) -> None:
        """Remove the folder: the answer is there. Files of others in it are let alone."""
        if not self.folder.is_dir():
            return
        for path in self.folder.glob("*.npz"):
            path.unlink(missing_ok=True)
        if not any(self.folder.iterdir()):
            self.folder.rmdir()


class Checkpoint:
    """The state of one integration, written now and then."""

    def __init__(self, checkpoints: Checkpoints, identity: CheckpointIdentity) -> None:
        self._all, self._identity = checkpoints, identity
        self.before = checkpoints.find(identity)
        self._begun = self._written = time.monotonic()

    def offer(self, reached: Callable[[], Reached]) -> None:
        """Write a state if it is time to."""
        if time.monotonic() - self._written >= self._all.every:
            self._all.keep(self._identity, reached())
            self._written = time.monotonic()

    def leave(self, reached: Callable[[], Reached]) -> None:
        """Write the state of an integration that is interrupted, if that is worth it."""
        if time.monotonic() - self._begun >= min(WORTH, self._all.every):
            self._all.keep(self._identity, reached())

    def finish(self, reached: Callable[[], Reached]) -> None:
        """Write the end of a long one: the run that it is part of may still be interrupted."""
        if time.monotonic() - self._begun >= self._all.every:
            self._all.keep(self._identity, reached())


class Resumable:
    """Tells another listener, and brings checkpoints to the integrations that it listens to."""

    def __init__(self, listener: Progress, checkpoints: Checkpoints) -> None:
        self._listener, self.checkpoints = listener, checkpoints

    def stage(self, name: str) -> None:
        """Pass on."""
        self._listener.stage(name)

    def doing(self, what: str) -> None:
        """Pass on."""
        self._listener.doing(what)

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Pass on."""
        self._listener.update(simulated_time, step_size)


def checkpoint_of(progress: Progress, identity: CheckpointIdentity) -> Checkpoint | None:
    """The place of the integration that this listener is given, if it brings one."""
    return progress.checkpoints.of(identity) if isinstance(progress, Resumable) else None


def _hash_of_identity(parts: Iterable[bytes]) -> str:
    """Hash of parts, each with its length, so that none can be taken for two."""
    found = hashlib.sha256(_VERSION.encode())
    for part in parts:
        found.update(len(part).to_bytes(8, "little"))
        found.update(part)
    return found.hexdigest()


def _read(path: Path, key: str) -> Reached | None:
    if not path.exists():
        return None
    try:
        # Opened here: NumPy leaves the file open where it is no archive.
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            state = {name: archive[name] for name in archive.files}
        if str(state["key"]) != key:
            raise ValueError("it is of another integration")
        return Reached(state["x"], state["z"], state["quad"], int(state["steps"]))
    except (OSError, ValueError, EOFError, KeyError, zipfile.BadZipFile) as error:
        raise SoftcatError(f"{path} is no checkpoint ({error}); delete it, or leave out --resume") from error
