"""A finished run of CalculiX that outlives an interruption."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.reference.calculix import CalculixRun, run_calculix
from softcat_sym.solve.keeping import Form, kept, packed, unpacked

if TYPE_CHECKING:
    from softcat_sym.reference import Clamp, Mesh
    from softcat_sym.scene import Scene
    from softcat_sym.solve import Progress

_NUMBERS = ("elastic_time", "dofs", "steps", "wall")
_ARRAYS = ("time", "midpoint", "X", "x", "y")
_FILE = "file "


def kept_calculix(scene: Scene, mesh: Mesh, clamp: Clamp, step: float, progress: Progress) -> CalculixRun:
    """Run a scene in CalculiX, or take up what is kept of it.

    Parameters
    ----------
    scene, mesh, clamp, step, progress
        As :func:`softcat_sym.reference.calculix.run_calculix`.
    """
    return kept(
        lambda: ("calculix", scene.to_toml(), str(mesh), clamp.value, repr(step)),
        lambda: run_calculix(scene, mesh, clamp=clamp, step=step, progress=progress),
        Form(_written, lambda content: _read(content, mesh, clamp)),
    )


def _written(run: CalculixRun) -> bytes:
    told = {name: np.asarray(getattr(run, name)) for name in (*_NUMBERS, *_ARRAYS)}
    return packed(told | {_FILE + name: np.frombuffer(one, np.uint8) for name, one in run.files.items()})


def _read(content: bytes, mesh: Mesh, clamp: Clamp) -> CalculixRun:
    found = unpacked(content)
    told = {name: found[name].item() for name in _NUMBERS} | {name: found[name] for name in _ARRAYS}
    files = {name.removeprefix(_FILE): one.tobytes() for name, one in found.items() if name.startswith(_FILE)}
    return CalculixRun(**told, mesh=mesh, clamp=clamp, files=files)
