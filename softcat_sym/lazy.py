"""Imports that are done when they are first used: ``import softcat_sym`` and the help of a command come at once."""

from __future__ import annotations

import builtins
from _thread import get_ident  # `threading` would take longer to load than all else here
from collections.abc import Iterator
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


@contextmanager
def lazy_imports() -> Iterator[None]:
    """Import the modules in this block, each a ``from package import module``, when one of their names is first used.

    Linters and type checkers see imports like any others.
    """
    imports, here = builtins.__import__, get_ident()

    def lazily(name: str, *scopes: Any) -> Any:
        if get_ident() != here:
            return imports(name, *scopes)
        return SimpleNamespace(**{module: _LazyModule(f"{name}.{module}") for module in scopes[2]})

    builtins.__import__ = lazily  # type: ignore[assignment]
    try:
        yield
    finally:
        builtins.__import__ = imports
