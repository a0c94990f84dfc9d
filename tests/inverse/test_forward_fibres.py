"""Derivatives where fibres yield one after another, and the discrete solution jumps with its parameters."""

from __future__ import annotations

import numpy as np

from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.scene.reading import load_scene

_FREE = ("thickness", "yield_stress")


def test_derivatives_are_those_of_wide_differences() -> None:
    """At the default tolerance: differences over 4 % see the slope, and none of the jumps."""
    scene = load_scene("arrested-overdamped", {"filament.span": "210 mm"})
    model = ForwardModel(scene, free_parameters(scene, _FREE), np.array([scene.run.duration]))
    assert "fibres" in model.effects
    q, step = model.typical, 0.02
    found = model.with_derivatives(q)[1]
    wide = [(model.midpoints(q + h) - model.midpoints(q - h)) / (2 * step) for h in step * np.eye(len(_FREE))]
    np.testing.assert_allclose(found, np.stack(wide, axis=1), rtol=0.02)
