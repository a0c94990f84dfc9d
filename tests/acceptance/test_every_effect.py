"""Every registered effect has a bundled scene in which it matters, a limit test and a derivation."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.registry import REGISTRY

from .effect_graphs import lists, with_effects
from .effect_limits import LIMITS
from .effect_walk import derived_in, lacking
from .table import show

NAMES = [effect.name for effect in REGISTRY]
WHOLE = REGISTRY[0]
COARSE = {"numerics.cells": 10, "numerics.fibres": 6}


def test_every_effect_has_its_scene_its_limit_and_its_derivation() -> None:
    for effect in REGISTRY:
        assert not lacking(effect, LIMITS)


def test_no_limit_is_of_an_unknown_effect() -> None:
    assert {limit.effect for limit in LIMITS} == set(NAMES)


def test_one_that_lacks_any_is_caught() -> None:
    for changes, message in [
        ({"example": "no-such-scene"}, "scene: no bundled scene"),
        ({"applies": lambda scene: False}, "scene: maxwell-slow cannot have it"),
        ({"indispensable": lambda scene: "it rests on it"}, "scene: maxwell-slow cannot do without it"),
        ({"name": "magnetism"}, "scene: maxwell-slow does not take it in"),
        ({"name": "magnetism"}, "derivation: 01_balance does not say"),
        ({"name": "magnetism"}, "limit: none"),
        ({"derivation": "99_magnetism"}, "derivation: no notebook"),
        ({"derivation": "03_small_deflection"}, "derivation: 03_small_deflection does not say"),
    ]:
        made_up = replace(WHOLE, **changes)  # type: ignore[arg-type]
        assert any(message in fault for fault in lacking(made_up, LIMITS))


def test_a_limit_taken_out_of_the_table_is_missed() -> None:
    assert not lacking(WHOLE, LIMITS)
    assert lacking(WHOLE, [limit for limit in LIMITS if limit.effect != WHOLE.name]) == ["limit: none in the table"]


@pytest.mark.parametrize(
    ("objects", "code"), [("`kinematics.NOTHING`", "kinematics.NOTHING"), ("`kinematics.MOTION`", "kinematics.other")]
)
def test_a_notebook_that_only_says_so_is_caught(tmp_path: Path, objects: str, code: str) -> None:
    notebook = f"# %% [markdown]\n# Effects derived here: `inertia` ({objects}).\n\n# %%\n{code}\n"
    (tmp_path / "01_balance.py").write_text(notebook, "utf-8")
    assert any("compares nothing" in fault for fault in lacking(WHOLE, LIMITS, tmp_path))


def test_what_a_notebook_says_may_run_over_lines() -> None:
    said = "Some. Effects derived here: `a-b` (`motion.X`,\n`laws.y.Z`), `c` (`balance.q`).\n\nMore (`d`)."
    assert derived_in(said) == {"a-b": ("motion.X", "laws.y.Z"), "c": ("balance.q",)}


@pytest.mark.slow
@pytest.mark.parametrize("effect", REGISTRY, ids=NAMES)
def test_it_matters_in_its_scene(effect: Effect) -> None:
    """Leaving it out changes the midpoint by more than the accuracy asked, or the run cannot be finished."""
    scene = sc.load_scene(effect.example, COARSE if "fibres" in lists(effect)[1] else {"numerics.cells": 10})
    runs = [sc.simulate(with_effects(scene, names)) for names in lists(effect)]
    assert runs[0].outcome is sc.Outcome.solved
    change = float("inf")
    if runs[1].outcome is sc.Outcome.solved:
        present, absent = (run.data["midpoint"].values for run in runs)
        change = float(np.max(np.abs(present - absent)) / np.max(np.abs(present)))
    header = ("scene", "change without it", "accuracy", "outcome without it")
    accuracy = scene.run.accuracy
    show(effect.name, header, [[effect.example, f"{change:.2e}", f"{accuracy:g}", runs[1].outcome.name]])
    assert change > accuracy
