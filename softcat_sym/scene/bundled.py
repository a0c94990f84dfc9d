"""The scenes that come with the package."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable

_FOLDER = "bundled"
_LESSON = "# Lesson: "


@cache
def bundled_names() -> tuple[str, ...]:
    """Name the scenes that come with the package.

    Returns
    -------
    tuple of str
        In alphabetical order; each may be given wherever a scene file may.
    """
    names = (entry.name for entry in _folder().iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in names if name.endswith(".toml")))


def bundled_text(name: str) -> str:
    """Return the TOML text of a bundled scene."""
    return (_folder() / f"{name}.toml").read_text(encoding="utf-8")


def bundled_title(name: str) -> str:
    """Return the title of a bundled scene."""
    return str(tomllib.loads(bundled_text(name))["title"])


def bundled_lesson(name: str) -> str:
    """Return what a bundled scene teaches, from the comment that begins with ``# Lesson:``."""
    lines = bundled_text(name).splitlines()
    return next((line.removeprefix(_LESSON) for line in lines if line.startswith(_LESSON)), "")


def _folder() -> Traversable:
    return files("softcat_sym.scene") / _FOLDER
