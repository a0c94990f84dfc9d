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
    """Import the modules in this block when one of their names is first used.

    Each is a ``from package import module`` or ``import package``; linters and type checkers see them like any others.
    """
    imports, here = builtins.__import__, get_ident()

    def lazily(name: str, *given: Any) -> Any:
        if get_ident() != here:
            return imports(name, *given)
        _, _, modules, _ = given
        if not modules:
            return _LazyModule(name)
        return SimpleNamespace(**{module: _LazyModule(f"{name}.{module}") for module in modules})

    builtins.__import__ = lazily  # type: ignore[assignment]
    try:
        yield
    finally:
        builtins.__import__ = imports
