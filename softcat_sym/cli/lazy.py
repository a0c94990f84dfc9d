"""Imports that are done when they are first used, so that the help of a command, or its refusal, comes at once."""

from __future__ import annotations

import builtins
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from importlib import import_module
from types import SimpleNamespace
from typing import Any


class _LazyModule:
    """Stands for a module, which is imported when it is asked for a name."""

    def __init__(self, name: str) -> None:
        self._name = name

    def __getattr__(self, attribute: str) -> Any:
        return getattr(import_module(self._name), attribute)


def _import_lazily(name: str, _globals: object, _locals: object, modules: Sequence[str], _level: int) -> object:
    """Answer ``from name import modules`` without importing anything."""
    return SimpleNamespace(**{module: _LazyModule(f"{name}.{module}") for module in modules})


@contextmanager
def lazy_imports() -> Iterator[None]:
    """Import the modules in this block, each a ``from package import module``, when one of their names is first used.

    Linters and type checkers see imports like any others.
    """
    imports, builtins.__import__ = builtins.__import__, _import_lazily  # type: ignore[assignment]
    try:
        yield
    finally:
        builtins.__import__ = imports
