"""Runs of the elements that acceptance checks share, kept in the user's cache: a second run of the checks is immediate.

A run is found again by the hash of its problem, mesh, clamp, step and code, so that none is ever out of date.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from functools import cache

import numpy as np
import numpy.typing as npt

import softcat_sym as sc
from softcat_sym.cache import cache_folder
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.files import replace_atomically
from softcat_sym.reference.element_loop import Clamp, Mesh, element_sources, problem_of
from softcat_sym.reference.elements import ElementRun, element_form, run_elements
from softcat_sym.reference.material_point import point_code
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene, elastic_time

Floats = npt.NDArray[np.float64]

PLANE_STRESS = {"filament.width": "0.06 mm"}
"""A hundredth of the paper's thickness: what the elements assume of the width."""

INSTANTS = (46.0, 115.0, 230.0, 460.0)
"""t~ = (t/L) sqrt(E/rho); the bundled scenes end at 460 with 201 frames, which hits all four."""

FRAMES: Mapping[str, Mapping[str, object]] = {"no-yield": {"run.frames": 1001}}
"""Scenes whose period is to be measured to a thousandth have more frames."""

PUBLISHED = tuple(effect.name for effect in REGISTRY if effect.in_paper and effect.name != "viscous-stress")
"""The paper's effects on a law that yields, by name, for lists that add to them or leave some out."""

RINGING = (60.0, 460.0)
"""Means are taken over these t~: some 35 periods of the ringing of the underdamped scene."""


def plane(name: str, changes: Mapping[str, object] | None = None) -> Scene:
    """A bundled scene, narrow."""
    return sc.load_scene(name, {**PLANE_STRESS, **FRAMES.get(name, {}), **(changes or {})})


def filament(name: str, changes: Mapping[str, object]) -> Run:
    """The run of a narrow bundled scene; the same run is not made twice by one process."""
    return _filament(name, tuple(changes.items()))


@cache
def _filament(name: str, changes: tuple[tuple[str, object], ...]) -> Run:
    return sc.simulate(plane(name, dict(changes)))


def elements(
    scene: Scene, mesh: Mesh | None = None, *, clamp: Clamp = Clamp.THINNING, step_factor: float = 1.0
) -> ElementRun:
    """The run of a scene, from the cache if it is there."""
    mesh, problem = mesh or Mesh(), problem_of(scene)
    form, sources = element_form(mesh, clamp), element_sources(point_code(problem.law))
    sizes = (scene.filament.span, scene.filament.width, scene.material.youngs_modulus, elastic_time(scene))
    key = hashlib.sha256(repr((problem, sizes, mesh, clamp, step_factor, sources)).encode()).hexdigest()
    path = cache_folder() / "elements" / f"{key}.npz"
    if not path.is_file():
        path.parent.mkdir(parents=True, exist_ok=True)
        replace_atomically(path, form.write(run_elements(scene, mesh, clamp=clamp, step_factor=step_factor)))
    return form.read(path.read_bytes())


AnyRun = ElementRun | Run


def midpoints(scene: Scene, run: AnyRun, instants: Iterable[float] = INSTANTS) -> Floats:
    """Midpoint/L at some t~; between frames by interpolation."""
    time, midpoint = curve(scene, run)
    return np.asarray(np.interp(list(instants), time, midpoint), dtype=np.float64)


def mean(scene: Scene, run: AnyRun) -> float:
    """Mean of midpoint/L while the filament rings."""
    time, midpoint = curve(scene, run)
    begin, end = RINGING
    return float(midpoint[(time >= begin) & (time <= end)].mean())


def curve(scene: Scene, run: AnyRun) -> tuple[Floats, Floats]:
    """t~ and midpoint/L of every frame."""
    if isinstance(run, ElementRun):
        time, midpoint = run.time, run.midpoint
    else:
        time, midpoint = run.data.time.values, run.data.midpoint.values
    return time / elastic_time(scene), midpoint / scene.filament.span


def name_of(mesh: Mesh) -> str:
    """Such as "64 x 4, graded 3"."""
    return f"{mesh.along} x {mesh.through}" + (f", graded {mesh.grading:g}" if mesh.grading != 1 else "")


def digits(values: Sequence[float] | Floats) -> list[str]:
    """Midpoints as they are printed."""
    return [f"{value:.5f}" for value in values]


def percent(values: Sequence[float] | Floats, than: Sequence[float] | Floats) -> list[str]:
    """Differences from a reference, relative to it."""
    return [f"{100 * (value / reference - 1):+.2f} %" for value, reference in zip(values, than, strict=True)]
