"""Filament against elements: exact measures, which theories stand beside it, files, pictures, resumption, refusals."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.studies.compare import (
    aligned,
    compare,
    discrepancy,
)
from tests.common.in_process import Softcat, sets

COARSE = Mesh(8, 2)
QUICK = {"numerics.cells": 10, "numerics.estimate": False, "filament.width": "0.3 mm"}
YIELDING = sc.load_scene("continual-descent", {**QUICK, "groups.duration": 10, "run.frames": 21})
THICK = {**QUICK, "groups.delta": 0.06, "load.ramp": "0 s", "numerics.cells": 20}
THICK |= {"groups.duration": 12, "run.frames": 49}
SHORT = (
    *sets("groups.duration=10", "run.frames=11", "numerics.cells=10", "numerics.estimate=false", "run.effects=paper"),
    *("--mesh", "8x2"),
)


def test_discrepancy_of_known_curves() -> None:
    time = np.linspace(0, 7, 71)
    elements = -2 * time / 7
    found = discrepancy(time, elements + 0.1 * time, elements)
    np.testing.assert_allclose(found.error, 0.05 * time)
    np.testing.assert_allclose(found.at, [0.05 * 0.7, 0.05 * 1.8, 0.05 * 3.5, 0.35], rtol=1e-12)
    # Frames at 1.0, 1.1, ... 7.0: the first seventh is left out, its end is not.
    assert found.mean == pytest.approx(0.05 * 4.0)
    assert found.largest == pytest.approx(0.35)
    assert discrepancy(time, elements - 0.1, elements).mean == pytest.approx(-0.05)
    # A run that ends early is compared as far as it came.
    time = np.linspace(0, 1, 11)
    short = aligned(time[:6] * (1 + 1e-15), -time[:6], time)
    np.testing.assert_allclose(short[:6], -time[:6])
    assert np.isnan(short[6:]).all()
    found = discrepancy(time, short, -2 * time)
    assert found.at[:3] == pytest.approx((0.05, 0.1, 0.25)) and np.isnan([found.at[3], found.mean]).all()
    assert found.largest == pytest.approx(0.25)
    # Without motion there is no relative error.
    found = discrepancy(time, 0 * time, 0 * time)
    assert np.isnan([*found.at, found.mean, found.largest]).all()


def test_shear_brings_the_filament_to_the_elements() -> None:
    """A thick elastic beam over most of its first swing: the published theory is too stiff by its shear."""
    found = compare(sc.load_scene("no-yield", THICK), Mesh(16, 2))
    own, material, _ = (row.discrepancy.largest for row in found.rows)
    assert own < 0.02
    assert material > 4 * own
    # Strain next to the clamp: the largest is steep there, and comes near on finer grids (2 % on 80 cells and 48 x 6).
    peak = int(np.argmin(found.elements.midpoint))
    strain = found.filament.clamp_strain
    assert strain is not None
    assert strain.mean[peak] == pytest.approx(found.elements.clamp_strain[peak], rel=0.05)
    assert strain.largest[peak] == pytest.approx(found.elements.clamp_strain_largest[peak], rel=0.12)


def test_what_cannot_be_compared_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    for changes, path in (
        ({"ends.left": "pinned"}, "ends.left"),
        ({"filament.section": "circle", "filament.width": None}, "filament.section"),
        ({"run.effects": ["shaer"]}, "run.effects"),
    ):
        with pytest.raises(SceneError, match=path):
            compare(YIELDING.replace(changes), COARSE)
    monkeypatch.setenv("CC", "nonexistent")
    with pytest.raises(SoftcatError, match="no C compiler"):
        compare(YIELDING, Mesh(10, 2))


def test_bad_input_is_one_message_and_leaves_nothing(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "out"
    for arguments, message in (
        ("no-yield --mesh 64", "no mesh"),
        ("no-yield --mesh 0x4", "0 elements along"),
        ("no-yield --mesh 8x3", "even number"),
        ("no-yield --mesh -8x2", "no mesh"),
        ("no-yield --mesh 8x2x2", "no mesh"),
        ("ink-bridge", "filament.section"),
        ("no-yield --set ends.left=pinned --set ends.right=pinned", "ends.right"),
        ("no-such-scene", "no-such-scene"),
        ("no-yield --set run.effects=['shaer']", "did you mean 'shear'"),
        ("maxwell-slow --set model=small-deflection", "model"),
        ("no-yield --set groups.gravity=0", "gravity"),
        ("no-yield --write-input-only --set filament.section=circle", "filament.section"),
        ("no-yield --write-input-only --vary groups.G=0.4,0.5", "a deck is of one scene"),
        ("continual-descent --vary groups.delta=0.03", "has one value"),
        ("continual-descent --vary groups.delta=0.03,0.06 --mesh 4x2", "half as many must be a mesh too"),
        ("continual-descent --vary groups.detla=0.03,0.06", "detla"),
        ("continual-descent --vary filament.section=rectangle,circle", "filament.section"),
    ):
        done = softcat("compare", *arguments.split(), "-o", str(output))
        assert done.status == 2 and message in done.err, arguments
        assert not output.exists()
    # The deck alone needs no CalculiX.
    done = softcat("compare", "continual-descent", "--write-input-only", *SHORT, "-o", str(output))
    assert done.status == 0 and "calculix/deck.inp" in done.out
    assert {path.relative_to(output).as_posix() for path in output.rglob("*") if path.is_file()} == {
        *("scene.toml", "calculix/deck.inp")
    }
    assert "C3D20R" in (output / "calculix" / "deck.inp").read_text()
