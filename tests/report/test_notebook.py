"""Results draw themselves, and show themselves in a notebook."""

from __future__ import annotations

from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError

SCENE = {"numerics.cells": 6, "numerics.estimate": False, "run.frames": 11, "run.effects": "paper"}


def test_a_run_a_sweep_and_a_scene_show_themselves(tmp_path: Path) -> None:
    scene = sc.load_scene("no-yield", SCENE)
    run = sc.simulate(scene)
    for what in ("midpoint", "shapes", "energy", "space-time"):
        assert run.plot(what).axes, what
    with pytest.raises(SoftcatError, match="no picture 'moment': there are midpoint, shapes, energy, space-time"):
        run.plot("moment")
    sweep = sc.sweep(scene, {"material.youngs_modulus": ["2 MPa", "4 MPa"]}, tmp_path)
    assert "2 filaments" in repr(sweep)
    for shown in (run, sweep):
        text = shown._repr_html_()
        assert text.startswith("<pre>") and "data:image/png;base64," in text
        assert "no-yield" in text or scene.title in text or "No yield" in text
    assert "youngs_modulus" in scene._repr_html_()
