"""Results that outlive an interruption: each is looked for before it is computed, and kept when it is there."""

from __future__ import annotations

import hashlib
import io
import json
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

import numpy as np
import numpy.typing as npt

from softcat_sym.solve.interrupts import watched

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
    """How a result is written, so that reading it gives the same to the last bit.

    Attributes
    ----------
    write, read : callable
        To bytes and back.
    """

    write: Callable[[Result], bytes]
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
    """Return a result: what was kept of it, if anything was, otherwise what `compute` returns, which is then kept.

    Parameters
    ----------
    identity : callable
        Of all that decides the result, the kind of result first.
    compute : callable
        What takes time. What it keeps itself is dropped when it has ended.
    form : Form
        Of the result.

    Raises
    ------
    KeyboardInterrupt
        On Ctrl-C, even where CasADi swallowed it: such a result is never kept.
    """
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
