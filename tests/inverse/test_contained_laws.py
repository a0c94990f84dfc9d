"""Laws that contain others: their limits by runs, and fits that start again from the law inside."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.model_selection import FITTED, contained_in, fit_law, fit_laws, widened
from softcat_sym.scene.material import CONSTANTS

PAIRS = [(wider, narrower) for wider in FITTED for narrower in contained_in(wider)]


def _scene(law: str) -> sc.Scene:
    """A filament that sags by a good tenth of its span and does not ring."""
    own = {"youngs_modulus": "4 MPa", "second_modulus": "1 MPa", "viscosity": "60 kPa*s", "yield_stress": "2 kPa"}
    changes: dict[str, object] = {f"material.{name}": None for name in own} | {"material.law": law}
    changes |= {f"material.{name}": own[name] for name in CONSTANTS[law]}
    if law in ("power-law", "herschel-bulkley"):
        changes |= {"material.index": 0.8, "material.viscosity": "60 kPa*s^0.8"}
    plain = {"run.effects": "paper", "numerics.cells": 6, "run.frames": 41}
    scene = sc.load_scene("continual-descent", plain).replace(changes)
    return scene.replace({"run.effects": [name for name in choose_effects(scene).names if name != "inertia"]})


def _fallen(scene: sc.Scene) -> tuple[np.ndarray, np.ndarray]:
    data = sc.simulate(scene).data
    return data.time.values[1:], data.midpoint.values[1:]


@pytest.mark.parametrize(("wider", "narrower"), PAIRS)
def test_the_wider_law_falls_as_the_one_inside(wider: str, narrower: str) -> None:
    """Two percent of the sag: negligible constants are a hundredth of what would matter, not nothing."""
    scene = _scene(narrower)
    time, height = _fallen(scene)
    inside = widened(scene, wider, Measurements.of(time, height))
    assert inside.material.law == wider
    after, found = _fallen(inside)
    late = time > 0.2 * time[-1]
    scale = float(np.abs(height).max())
    assert np.abs(np.interp(time, after, found) - height)[late].max() < 0.02 * scale


def test_a_wider_law_starts_again_from_the_one_inside() -> None:
    """A solid's modulus that is far too large cannot be left behind by its own starts, whose bounds lie about it."""
    scene = _scene("newtonian")
    time, height = _fallen(scene)
    film = Measurements.of(time, height + 1e-4 * np.random.default_rng(4).standard_normal(height.size))
    stiff = scene.replace(
        {"material.law": "kelvin-voigt", "material.youngs_modulus": "300 MPa", "run.effects": "paper"}
    ).replace({"run.effects": [name for name in choose_effects(_scene("kelvin-voigt")).names if name != "inertia"]})
    alone = fit_law(film, stiff, "kelvin-voigt", starts=0, profiles=False)
    found = fit_laws(film, stiff, ["kelvin-voigt", "newtonian"], starts=0)
    assert found.restarted == {"kelvin-voigt": "newtonian"}
    assert alone.squares > 10 * found.fits["kelvin-voigt"].squares
    # What has one constant more is no worse, but for how little its modulus may be made.
    assert found.fits["kelvin-voigt"].squares < 1.01 * found.fits["newtonian"].squares
    assert "newtonian" in found.choice.close


def test_the_narrower_comes_first() -> None:
    """Laws are fitted in the order of how many others they contain."""
    for law in FITTED:
        assert all(len(contained_in(inside)) < len(contained_in(law)) for inside in contained_in(law))
