"""A fitted material in a scene."""

from __future__ import annotations

import math

import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError
from softcat_sym.fitting.flow_curve import fit_flow_curve, fitted_scene
from tests.inverse.curves import curve_of

FIT = fit_flow_curve(curve_of(12.0, 3.4, 0.43, noise=0.02, seed=5))


@pytest.mark.parametrize("name", sc.bundled_names())
@pytest.mark.parametrize("law", ["bingham", "power-law", "herschel-bulkley"])
def test_every_scene_takes_every_law_and_reads_back(name: str, law: str) -> None:
    base = sc.load_scene(name)
    if base.model != "filament":
        return
    modulus = [] if base.material.youngs_modulus else ["material.youngs_modulus=1 kPa"]
    scene = fitted_scene(FIT, name, law, modulus)
    tensile = FIT.candidate(law).tensile
    material = scene.material
    assert material.law == law
    assert material.yield_stress == (tensile.yield_stress and pytest.approx(tensile.yield_stress, rel=1e-9))
    assert material.viscosity == pytest.approx(tensile.viscosity, rel=1e-9)
    if tensile.index is not None:
        assert material.index == pytest.approx(tensile.index, rel=1e-9)
    if base.material.youngs_modulus:
        assert material.youngs_modulus == base.material.youngs_modulus
        assert fitted_scene(FIT, base, law) == scene
    assert (scene.filament, scene.run) == (base.filament, base.run)
    # The shear data are stated.
    shear = [note for note in material.notes if "in shear" in note]
    assert len(shear) == (1 if law == "power-law" else 2)
    assert all(note in scene.to_toml() for note in material.notes)


def test_what_is_set_wins_over_the_fit() -> None:
    changes = ["material.youngs_modulus=40 kPa", "material.shear_yield_stress=7 Pa"]
    scene = fitted_scene(FIT, "no-yield", "bingham", changes)
    assert scene.material.youngs_modulus == 40e3
    assert scene.material.yield_stress == pytest.approx(7 * math.sqrt(3))
    # Given in tension, it takes the place of the fitted one in shear.
    scene = fitted_scene(FIT, "no-yield", "bingham", ["material.yield_stress=7 Pa"])
    assert scene.material.yield_stress == 7
    # What is not of the material is set before the scene is read, its groups included.
    scene = fitted_scene(FIT, "no-yield", "power-law", ["groups.duration=10"])
    assert scene.run == sc.load_scene("no-yield", ["groups.duration=10"]).run
    with pytest.raises(SceneError, match="sets nothing"):
        fitted_scene(FIT, "no-yield", "bingham", ["material.yield_stress"])
