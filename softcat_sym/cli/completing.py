"""Completions for the shell: bundled scenes, scene files, and the keys of a scene.

The shell calls these functions at every Tab: they import nothing heavy, and return nothing after an error.
"""

from __future__ import annotations

import os

from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from importlib import resources

    from softcat_sym.scene import scene


def complete_scene(incomplete: str) -> list[str]:
    """Offer bundled scenes by name, and TOML files and folders by path."""
    folder = resources.files("softcat_sym") / "scene" / "bundled"
    names = sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))
    return [name for name in names if name.startswith(incomplete)] + _paths(incomplete)


def complete_change(incomplete: str) -> list[str]:
    """Offer the dotted keys of a scene, each with its equals sign."""
    known = scene.known_keys()
    tables = set(known) - {""}
    # "title" and "model" stand outside every table.
    keys = [name for name in known[""] if name not in tables] + [f"{t}.{name}" for t in tables for name in known[t]]
    return sorted(f"{name}=" for name in keys if name.startswith(incomplete))


def _paths(incomplete: str) -> list[str]:
    """TOML files and folders whose path begins like this."""
    head, tail = os.path.split(incomplete)
    before = incomplete.removesuffix(tail)
    try:
        with os.scandir(head or ".") as entries:
            found = sorted((each.name, each.is_dir()) for each in entries if each.name.startswith(tail))
    except OSError:
        return []
    # Hidden files only after a dot; without any input, only scenes by name.
    shown = [(name, folder) for name, folder in found if incomplete and (tail[:1] == "." or name[0] != ".")]
    return [before + name + "/" * folder for name, folder in shown if folder or name.endswith(".toml")]
