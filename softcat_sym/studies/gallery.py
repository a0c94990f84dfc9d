"""The bundled scenes, run one after another for a gallery: what each shows, and what it teaches."""

from __future__ import annotations

import hashlib
import importlib.metadata
import time
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.scene.bundled import bundled_lesson, bundled_text
from softcat_sym.scene.reading import load_scene
from softcat_sym.simulate import simulated, without_estimate

if TYPE_CHECKING:
    from softcat_sym.results.trajectory import Trajectory
    from softcat_sym.scene.scene import Scene


@dataclass(frozen=True)
class Exhibit:
    """What the gallery tells of one scene; SI units."""

    name: str  # Of the scene, and what to learn from it
    title: str
    lesson: str
    law: str  # Of its material
    outcome: str  # Name of the run's :class:`~softcat_sym.Outcome`
    regime: str  # What the run shows; empty where it is refused
    span: float  # Of the filament [m]
    thickness: float
    duration: float  # Simulated time [s]
    sag_final: float | None  # Of the midpoint, downwards [m]; None where the run is refused
    sag_largest: float | None
    largest_stretch: float | None  # At the end, of any cell [-]; None where the run is refused
    wall: float  # Time that the run took [s]
    identity: str  # Of program and scene: a gallery keeps an exhibit for as long as it stays the same


@dataclass(frozen=True)
class Asked:
    """A scene of the gallery before it is run."""

    name: str  # Of the scene
    scene: Scene  # Without the estimate of its error
    text: str  # As a scene file, to begin one's own with
    identity: str  # Of program and scene


def asked_of(name: str, changes: Iterable[str] = ()) -> Asked:
    """Read a bundled scene for the gallery."""
    overrides = list(changes)
    scene = load_scene(name, overrides)
    text = scene.to_toml() if overrides else bundled_text(name)
    version = importlib.metadata.version("softcat_sym")
    digest = hashlib.sha256(f"{version}\n{bundled_lesson(name)}\n{scene.to_toml()}".encode()).hexdigest()
    return Asked(name, without_estimate(scene), text, digest[:16])


def exhibit_of(asked: Asked) -> tuple[Exhibit, Trajectory]:
    """Run a scene of the gallery."""
    began = time.perf_counter()
    trajectory = simulated(asked.scene)
    spent = time.perf_counter() - began
    scene, data, sound = asked.scene, trajectory.data, trajectory.outcome.is_success
    midpoint = np.asarray(data["midpoint"].values, dtype=np.float64)
    exhibit = Exhibit(
        name=asked.name,
        title=scene.title,
        lesson=bundled_lesson(asked.name),
        law=scene.material.law,
        outcome=trajectory.outcome.name,
        regime=str(trajectory.summary["regime"]) if sound else "",
        span=scene.filament.span,
        thickness=scene.filament.thickness,
        duration=scene.run.duration,
        sag_final=-float(midpoint[-1]) if sound else None,
        sag_largest=-float(midpoint.min()) if sound else None,
        largest_stretch=float(data["stretch"].values[-1].max()) if sound else None,
        wall=spent,
        identity=asked.identity,
    )
    return exhibit, trajectory
