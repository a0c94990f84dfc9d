"""Models that an earlier process wrote: taking a filament apart takes a second, reading what came of it a hundredth."""

from __future__ import annotations

import functools
import hashlib
import json
from collections.abc import Callable
from dataclasses import asdict
from importlib import resources

from softcat_sym.codegen.model_text import Template
from softcat_sym.codegen.recording import Slot
from softcat_sym.codegen.versions import VERSIONS
from softcat_sym.native import texts

_MADE_BY = ("codegen", "effects", "equations", "graph", "printing", "scene")
"""Packages whose code decides what the text is."""


def template_kept(key: str, made: Callable[[], Template]) -> Template:
    """The model of a key from the cache, or else made and kept there.

    Parameters
    ----------
    key : str
        Of all that the model depends on, but for the program itself and the libraries that it uses.
    made : callable
        Makes it.
    """
    full = hashlib.sha256(f"{key}\n{dict(VERSIONS)}\n{_program()}".encode()).hexdigest()
    kept = texts.recall(full)
    if kept is not None:
        return _read(kept)
    model = made()
    texts.keep(full, _written(model))
    return model


@functools.lru_cache(maxsize=1)
def _program() -> str:
    """Hash of the code that writes models: whoever changes it has others at once."""
    digest = hashlib.sha256()
    for package in _MADE_BY:
        files = [path for path in _files(resources.files(f"softcat_sym.{package}")) if path.name.endswith(".py")]
        for path in sorted(files, key=str):
            content = path.read_bytes()
            digest.update(f"{path.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def _files(folder: resources.abc.Traversable) -> list[resources.abc.Traversable]:
    """Files in a folder and in those below it."""
    found = []
    for path in folder.iterdir():
        found += _files(path) if path.is_dir() else [path]
    return found


def _written(model: Template) -> str:
    slots = [{**asdict(slot), "sites": [slot.sites.start, slot.sites.stop]} for slot in model.slots]
    return json.dumps({**asdict(model), "slots": slots})


def _read(text: str) -> Template:
    parts = json.loads(text)
    slots = tuple(Slot(**{**slot, "sites": range(*slot["sites"])}) for slot in parts["slots"])
    names = {name: tuple(parts[name]) for name in ("parameters", "places", "powers")}
    entries = tuple((row, column, distance) for row, column, distance in parts["entries"])
    return Template(
        functions=parts["functions"],
        slots=slots,
        entries=entries,
        scratch=tuple(parts["scratch"]),
        moves=parts["moves"],
        **names,
    )
