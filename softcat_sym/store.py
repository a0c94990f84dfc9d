"""Finished runs of studies, kept by content in the user's cache: a study given again takes them from here.

A key is a hash of all that decides a result, the program's own text included. What is kept is text, JSON or arrays,
never a pickle. An entry that is harmed, or that another user may have made, counts as not there, and what cannot be
written is computed again another time.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import importlib.metadata
import io
import json
import os
import zlib
from collections.abc import Callable, Iterator, Mapping
from contextvars import ContextVar
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum
from pathlib import Path
from typing import Any, Generic, TypeVar

import numpy as np
import numpy.typing as npt

from softcat_sym import cache

Result = TypeVar("Result")
Arrays = Mapping[str, npt.NDArray[Any]]

LIMIT = 10**9
"""Bytes that results may take together; beyond it those go that were not used for longest."""

_LIMIT_OF_TEXTS = 10**7
"""The same of texts, of which one takes some 20 kB."""

_NO_PHYSICS = ("cli", "plotting", "web")
_VERSIONS = ("casadi", "numpy", "sympy")
_DIGEST = 64
_QUICKLY = 1
_TRIMMING = "000", "400", "800", "c00"
"""Beginnings of the keys after which the limit is looked at: one in 1024, as a full store has 100 000 files."""

_fresh: ContextVar[bool] = ContextVar("fresh", default=False)


@contextlib.contextmanager
def fresh(wanted: bool = True) -> Iterator[None]:
    """Let nothing be recalled meanwhile; what is computed replaces what was kept."""
    before = _fresh.set(wanted or _fresh.get())
    try:
        yield
    finally:
        _fresh.reset(before)


@dataclass(frozen=True)
class Form(Generic[Result]):
    """How a result is written, so that reading it gives the same to the last bit."""

    write: Callable[[Result], bytes]
    read: Callable[[bytes], Result]


def stored(key: str, compute: Callable[[], Result], form: Form[Result]) -> Result:
    """Return the result of a key: from the store, else what `compute` returns, which is then kept."""
    content = recall(key)
    if content is not None:
        return form.read(content)
    result = compute()
    keep(key, form.write(result))
    return result


def key_of(what: str, *parts: object) -> str:
    """Hash of what is asked for; parts are text, numbers, bytes, arrays, dataclasses, and lists or tables of these."""
    text = json.dumps([what, _program(), *parts], default=_plain, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def recall(key: str, kind: str = cache.RESULTS) -> bytes | None:
    """Return what was kept under a key; None if nothing was, if it was harmed, or if others may have put it there."""
    if kind == cache.RESULTS and _fresh.get():
        return None
    with contextlib.suppress(OSError):
        for folder in cache.folders(kind):
            with contextlib.suppress(OSError):
                content = cache.content_of(folder / key)
                if content[:_DIGEST] == cache.digest(key, content[_DIGEST:]).encode():
                    cache.touch(folder / key)
                    return zlib.decompress(content[_DIGEST:])
    return None


def keep(key: str, content: bytes, kind: str = cache.RESULTS) -> None:
    """Keep a result whole or not at all; where that is impossible, as on a full disk, it will be computed again."""
    packed = zlib.compress(content, _QUICKLY)
    with contextlib.suppress(OSError):
        folder = cache.folders(kind)[-1]
        with cache.passing(folder, key) as passing:
            with open(passing, "xb", opener=lambda name, flags: os.open(name, flags, 0o600)) as stream:
                stream.write(cache.digest(key, packed).encode() + packed)
            passing.replace(folder / key)
        if kind != cache.RESULTS:
            cache.trim(kind, _LIMIT_OF_TEXTS, key)
        elif key.startswith(_TRIMMING):
            cache.trim(kind, LIMIT, key)


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


def _plain(value: object) -> object:
    if is_dataclass(value) and not isinstance(value, type):
        return {type(value).__name__: {field.name: getattr(value, field.name) for field in fields(value)}}
    if isinstance(value, np.ndarray):
        return [value.dtype.str, value.shape, _plain(value.tobytes())]
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, Enum):
        return [type(value).__name__, value.name]
    if isinstance(value, bytes):
        return hashlib.sha256(value).hexdigest()
    raise TypeError(f"no part of a key: {type(value).__name__}")


@functools.cache
def _program() -> list[str]:
    """Hash of the code that decides results, and versions of what it calculates with."""
    package, digest = str(Path(__file__).parent), hashlib.sha256()
    for folder, folders, names in os.walk(package):
        folders[:] = sorted(name for name in folders if folder != package or name not in _NO_PHYSICS)
        for name in sorted(name for name in names if name.endswith((".py", ".c", ".h"))):
            content = Path(folder, name).read_bytes()
            digest.update(f"{folder.removeprefix(package)}/{name} {len(content)}\n".encode() + content)
    return [digest.hexdigest(), *map(version, _VERSIONS)]


@functools.cache
def version(package: str) -> str:
    """Version of an installed package, looked up once a process."""
    return importlib.metadata.version(package)
