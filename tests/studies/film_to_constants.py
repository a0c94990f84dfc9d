"""Whether constants come back from films: runs are rendered, tracked and fitted, and their 95 % intervals counted.

``python -m tests.studies.film_to_constants 100`` films each material so often, with other faults, places, noise and
first guesses every time, and prints how many intervals hold the constant. An hour of the processor for 20.
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import softcat_sym as sc
from tests.common.draws import draws
from tests.common.rendered_films import MJPEG, film, h264, simulated

WIDE = 250.0
"""Span in every film [px]."""
AT_REST = 0.08
"""Share of a film before the release."""


@dataclass(frozen=True)
class Material:
    """A strand with known constants."""

    scene: Mapping[str, Any]  # tables of the scene
    free: Mapping[str, str]  # constants to fit, with their units
    frames: int = 45

    @property
    def fell(self) -> sc.Scene:
        return sc.Scene(**self.scene)


def strand(material: Mapping[str, Any], duration: str, **filament: str) -> dict[str, Any]:
    """Scene of a round strand across 50 mm."""
    sizes = {"span": "50 mm", "thickness": "3 mm", "section": "circle", "density": "1400 kg/m^3"} | filament
    return {"filament": sizes, "material": dict(material), "run": {"duration": duration, "frames": 401}}


MATERIALS = {
    "honey": Material(strand({"law": "newtonian", "viscosity": "600 Pa*s"}, "0.3 s"), {"viscosity": "Pa*s"}),
    "maxwell": Material(
        strand({"law": "maxwell", "youngs_modulus": "60 kPa", "viscosity": "3 kPa*s"}, "0.6 s"),
        {"youngs_modulus": "Pa", "viscosity": "Pa*s"},
    ),
    "ink": Material(
        strand({"law": "bingham", "youngs_modulus": "300 kPa", "viscosity": "150 Pa*s", "yield_stress": "1.2 kPa",
                "loss_tangent": 0.1}, "0.1 s"),
        {"viscosity": "Pa*s", "yield_stress": "Pa"},
    ),
    "herschel-bulkley": Material(
        strand({"law": "herschel-bulkley", "youngs_modulus": "300 kPa", "viscosity": "150 Pa*s^0.6", "index": 0.6,
                "yield_stress": "1.2 kPa", "loss_tangent": 0.1}, "0.1 s"),
        {"viscosity": "Pa*s^0.6", "yield_stress": "Pa"},
    ),
    "arrested": Material(
        strand({"law": "bingham", "youngs_modulus": "300 kPa", "viscosity": "600 Pa*s", "yield_stress": "2 kPa",
                "loss_tangent": 0.1}, "0.3 s"),
        {"yield_stress": "Pa"},
    ),
}  # fmt: skip
FAULTS: tuple[tuple[Any, dict[str, Any]], ...] = (
    (MJPEG, {}),
    (h264(14), {}),
    (MJPEG, {"tilt": 0.03, "gradient": 0.3, "vignette": 0.3}),
    (MJPEG, {"light_strand": True, "glare": 0.6, "noise": 2.0}),
    (h264(14), {"dust": ((150, 60, 4), (40, 200, 3)), "supports": "pillars"}),
)


@cache
def fallen(name: str) -> Any:
    """Fields of the run of a material."""
    return sc.simulate(MATERIALS[name].fell).data


@dataclass(frozen=True)
class Answer:
    """What one film told."""

    outcome: str
    values: Mapping[str, float] = field(default_factory=dict)
    holds: Mapping[str, bool] = field(default_factory=dict)  # Whether the 95 % interval has the constant


def answer(name: str, seed: int, folder: Path) -> Answer:
    """Film a material, track the film and fit its constants; the seed chooses faults, places, noise, first guesses."""
    material, random = MATERIALS[name], draws(63, seed)
    codec, faults = FAULTS[seed % len(FAULTS)]
    scene, data = material.fell, fallen(name)
    duration, scale = float(data.time[-1]), WIDE / scene.filament.span
    frame = duration / material.frames
    release = (AT_REST * material.frames + random.random()) * frame
    path = film(
        folder / f"{name}-{seed}.mov", codec, depth=simulated(data, scale, release),
        thickness=scale * scene.filament.thickness, centre=160 + random.random(), level=50 + random.random(),
        times=frame * np.arange(round((1 + AT_REST) * material.frames)), seed=seed, **faults,
    ) and folder / f"{name}-{seed}.mov"  # fmt: skip
    table = sc.track(path, "span=50 mm").save(folder / f"{name}-{seed}.csv")
    truth = {one: float(getattr(scene.material, one)) for one in material.free}
    begin = {
        f"material.{one}": f"{value * random.uniform(0.7, 1.5)} {material.free[one]}" for one, value in truth.items()
    }
    found = sc.fit(table, scene.replace(begin), [*material.free], starts=0, profiles=False)
    ends = {one: found.parameters[one].ci95 for one in truth}
    holds = {one: (ends[one][0] or 0.0) <= value <= (ends[one][1] or np.inf) for one, value in truth.items()}
    return Answer(found.outcome.name, {one: found.parameters[one].best / value for one, value in truth.items()}, holds)


def main(films: int) -> None:
    counts, held = Counter[str](), Counter[str]()
    with tempfile.TemporaryDirectory() as folder:
        for name in MATERIALS:
            for seed in range(films):
                one = answer(name, seed, Path(folder))
                print(
                    name,
                    seed,
                    one.outcome,
                    {key: (round(one.values[key], 3), one.holds[key]) for key in one.holds},
                    flush=True,
                )
                for key, good in one.holds.items():
                    counts[f"{name} {key}"] += 1
                    held[f"{name} {key}"] += good
    for key, number in counts.items():
        print(f"{key}: {held[key]} of {number} intervals hold")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
