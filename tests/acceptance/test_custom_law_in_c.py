"""A flow rule of one's own, in the generated C and in the interpreted graph, against the built-in law."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from tests.slow.test_laws import PAIRS_CUSTOM_LAW as PAIRS
from tests.slow.test_laws import difference, scene_of

from .table import show


def heights(scene: sc.Scene, backend: str) -> np.ndarray:
    """Midpoint [m] over the run."""
    numerics = {"backend": backend, "solver": "rosenbrock", "rtol": 1e-6, "cells": 8, "estimate": False}
    run = sc.simulate(scene.replace({"numerics": numerics}))
    assert run.outcome is sc.Outcome.solved
    assert run.summary["backend"] == backend
    return np.asarray(run.data.midpoint.values)


@pytest.mark.parametrize("name", ["bingham", pytest.param("herschel-bulkley", marks=pytest.mark.slow)])
def test_compiled_it_is_the_same_again(name: str) -> None:
    """The C of the filament holds the user's rule as it holds a built-in one."""
    built_in, own = (scene_of(dict(material), "paper") for material in PAIRS[name])
    runs = {
        f"{law}, {backend}": heights(scene, backend)
        for law, scene in (("built-in", built_in), ("custom", own))
        for backend in ("interpreted", "compiled")
    }
    first = runs["built-in, interpreted"]
    errors = {label: difference(first, run) for label, run in runs.items()}
    show(f"{name} in C", ["filament", "difference/sag"], [[k, f"{v:.1e}"] for k, v in errors.items()])
    assert max(errors.values()) < 1e-6
