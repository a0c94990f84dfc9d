"""A strand that rings for long is integrated once at the resolution of its answer, however few its frames."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.solvers.compiled import CompiledIntegration

SCENE = {
    "filament": {"span": "0.1 m", "thickness": "2 mm", "density": "1000 kg/m^3"},
    "material": {"law": "elastic", "youngs_modulus": "1 MPa"},
    "run": {"duration": "4 s", "frames": 21, "effects": ["inertia", "bending", "extensibility", "large-rotation"]},
    "numerics": {"cells": 12, "backend": "compiled"},
}


@pytest.mark.parametrize(("most", "fewest"), [(20_000_000, 800), (10_000, 100)])
def test_a_long_ringing_is_integrated_once_to_be_told_and_to_be_judged(
    most: int, fewest: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Companions have its output times, also where memory limits their number (``most`` values)."""
    monkeypatch.setattr("softcat_sym.error_control.control.MAX_NUMBERS", most)
    plain = CompiledIntegration.run
    begun: list[tuple[int, int]] = []

    def counted(self: CompiledIntegration, *given: object) -> object:
        begun.append((self.graph.grid.cells, self.frames))
        return plain(self, *given)  # type: ignore[arg-type]

    scene = sc.Scene.model_validate(SCENE)
    alone = sc.simulate(scene.replace({"numerics.estimate": False}))
    monkeypatch.setattr(CompiledIntegration, "run", counted)
    judged = sc.simulate(scene)
    assert [cells for cells, _ in begun].count(12) == 1
    assert {frames for _, frames in begun} == {begun[0][1]}
    assert (begun[0][1] - 1) % 20 == 0
    assert begun[0][1] > fewest
    for name in ("time", "midpoint", "tension", "energy_kinetic"):
        np.testing.assert_allclose(judged.data[name], alone.data[name], rtol=1e-9, atol=1e-12)
