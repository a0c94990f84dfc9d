"""The C of every filament says what its interpreted graph says, whatever the grid; its text is one, short and clean."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from typing import Any

import pytest

import softcat_sym as sc
from tests.acceptance.table import show
from tests.marks import few

from .pairs import Pair, differences, pair_of

SAME = 1e-12
SEEDS = range(3)
LONGEST = 200_000

PAPER = ("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow")
WITH_FIBRES = [*PAPER, "yielding", "gravity-ramp", "shear", "fibres", "necking-gradient"]
# Structures that differ in what the unknowns are, in the ends and in the supports.
KINDS: dict[str, tuple[str, dict[str, Any]]] = {
    "paper": ("continual-descent", {"run.effects": "paper"}),
    "printed closure": ("continual-descent", {"run.effects": "paper", "run.closure": "printed"}),
    "linear beam": ("no-yield", {"run.effects": ["inertia", "bending", "gravity-ramp"]}),
    "string": ("stretched-rubber-band", {"run.effects": ["inertia", "extensibility", "large-rotation"]}),
    "fibres, necking": ("arrested-overdamped", {"run.effects": WITH_FIBRES, "numerics.fibres": 4}),
    "viscous stress, moving support": ("drawn-blob", {}),
    "profile, free end": ("curled-rod", {"filament.profile": [1.5, 1.0, 0.5]}),
    "profile, point mass": ("silicone-thread", {"filament.profile": [1, 0.8, 1], "load.point_mass": "10 mg"}),
    "point mass, no inertia": ("beam-viscometer", {}),
    "supports apart": ("slime-slope", {}),
    "several modes": ("polyethylene-melt", {}),
    "surface tension": ("silicone-thread", {"run.effects": [*PAPER, "surface-tension"]}),
    "surface tension, profile, fibres, necking": (
        "ink-bridge",
        {"filament.profile": [1, 0.8, 1], "run.effects": [*WITH_FIBRES, "surface-tension"], "numerics.fibres": 3},
    ),
    "surface tension of a rectangle": (
        "continual-descent",
        {
            "filament.width": "3 mm",
            "filament.profile": [1, 0.8, 1],
            "surroundings.surface_tension": "2 N/m",
            "run.effects": [*PAPER, "yielding", "surface-tension"],
        },
    ),
}


def scene_of(kind: str, **changes: Any) -> sc.Scene:
    name, own = KINDS[kind]
    return sc.load_scene(name, {**own, **{key.replace("__", "."): value for key, value in changes.items()}})


def check(title: str, pairs: dict[str, Pair]) -> None:
    """Print and assert the differences of some filaments."""
    rows = []
    for label, pair in pairs.items():
        worst = differences(pair, SEEDS)
        sizes = [
            pair.graph.grid.cells,
            len(pair.kinds),
            pair.compiled.table.entries,
            f"{len(pair.model.text) / 1e3:.0f}",
        ]
        rows.append([label, *sizes, *(f"{value:.0e}" for value in worst.values())])
        assert max(worst.values()) < SAME, (label, worst)
        assert len(pair.model.text.encode()) < LONGEST, label
    header = ("", "cells", "unknowns", "entries a site", "kB of C", "rates", "Jacobian", "powers", "slopes")
    show(title, header, rows)


QUICK = ("paper", "string", "fibres, necking", "profile, free end", "point mass, no inertia", "several modes")


@pytest.mark.parametrize("kind", few(KINDS, *QUICK))
def test_every_number_is_that_of_the_graph(kind: str) -> None:
    check(f"{kind}: C against the interpreted graph", {kind: pair_of(scene_of(kind, numerics__cells=6))})


@pytest.mark.parametrize("kind", ["paper", "fibres, necking", "viscous stress, moving support"])
def test_of_the_smallest_grid_and_of_a_graded_one_too(kind: str) -> None:
    grids = {
        "smallest": scene_of(kind, numerics__cells=4),
        "graded": scene_of(kind, numerics__cells=9, numerics__grading=3.0),
    }
    check(f"{kind}: C against the interpreted graph", {label: pair_of(scene) for label, scene in grids.items()})


def test_of_a_whole_span_that_is_graded_too() -> None:
    pair = pair_of(scene_of("supports apart", numerics__cells=8, numerics__grading=4.0))
    lengths = pair.graph.grid.cell_length
    assert not pair.graph.grid.is_half
    assert lengths.max() > 2 * lengths.min()
    check("a graded whole span: C against the interpreted graph", {"supports apart": pair})


@pytest.mark.slow
@pytest.mark.parametrize("name", sc.bundled_names())
def test_of_every_bundled_scene(name: str) -> None:
    scenes = {"as it is": sc.load_scene(name), "smallest": sc.load_scene(name, {"numerics.cells": 4})}
    check(f"{name}: C against the interpreted graph", {label: pair_of(scene) for label, scene in scenes.items()})


def test_a_parameter_that_is_a_little_off_would_be_noticed() -> None:
    pair = pair_of(scene_of("fibres, necking", numerics__cells=6))
    off = pair.p.copy()
    off[pair.graph.parameters.index("youngs_modulus")] *= 1 + 1e-9
    worst = differences(pair, SEEDS, replace(pair, p=off))
    assert all(SAME < value < 1e-5 for value in worst.values()), worst


@pytest.mark.parametrize("kind", ["paper", "fibres, necking"])
def test_one_text_for_every_grid_and_every_number(kind: str) -> None:
    base = pair_of(scene_of(kind, numerics__cells=6)).model
    others = (
        {"numerics__cells": 4},
        {"numerics__cells": 40, "numerics__grading": 1.0},
        {"material__youngs_modulus": "5 MPa", "filament__span": "0.3 m", "load__ramp": "0.2 s"},
        {"run__duration": "3 s", "run__frames": 7, "run__accuracy": 0.01},
    )
    for changes in others:
        assert pair_of(scene_of(kind, **changes)).model is base, changes


TEXT = """
import hashlib, sys
from tests.codegen.test_model_agreement import pair_of, scene_of
for kind in ("paper", "fibres, necking", "viscous stress, moving support"):
    print(kind, hashlib.sha256(pair_of(scene_of(kind, numerics__cells=6)).model.text.encode()).hexdigest())
"""


@pytest.mark.slow
def test_the_text_is_the_same_whatever_the_hash_seed() -> None:
    texts = {
        subprocess.run(
            [sys.executable, "-c", TEXT],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(texts) == 1
    assert texts.pop().count("\n") == 3
