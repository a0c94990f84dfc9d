"""Imports that are done when they are first used, so that the help of a command, or its refusal, comes at once."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import LazyLoader
from typing import Any


class _LazyFinder:
    """Finds modules as ever, and has them loaded by the standard library's lazy loader; packages load at once."""

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> ModuleSpec | None:
        spec = PathFinder.find_spec(fullname, path, target)
        if spec is not None and spec.loader is not None and spec.submodule_search_locations is None:
            spec.loader = LazyLoader(spec.loader)
        return spec


@contextmanager
def lazy_imports() -> Iterator[None]:
    """Load the modules that are imported in this block at the first use of one of their names.

    They are imported as modules, ``from package import module``: a name of a module loads it. Only commands do so, in
    one thread; libraries of this package import at their top.
    """
    finder = _LazyFinder()
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)
