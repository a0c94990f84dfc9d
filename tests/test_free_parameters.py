"""Free parameters: what may be free, its bounds, and values put into a scene as `Scene.replace` puts them."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.free_parameters import FreeParameter, candidates, free_parameters, with_values
from softcat_sym.scene.history import History
from softcat_sym.scene.material import tensile_name

OF_EACH_KIND = (
    "continual-descent",
    "solvent-cast-strand",
    "polyethylene-melt",
    "glass-fibre",
    "printed-lintel",
    "transient-gel",
    "bread-dough",
)


def _all(scene: sc.Scene) -> tuple[FreeParameter, ...]:
    return tuple(one for name in _names(scene) for one in free_parameters(scene, [name]))


def _names(scene: sc.Scene) -> list[str]:
    return [one.path for one in candidates(scene) if not one.trouble]


@pytest.mark.parametrize("name", OF_EACH_KIND)
def test_values_are_put_as_replace_puts_them(name: str) -> None:
    """Every number that may be free, one at a time, against the scene validated anew."""
    scene = sc.load_scene(name)
    for one in _all(scene):
        # What is free of a history is no key of its own: `tests/test_clocks.py`.
        numbered = re.sub(r"_\d+$", "", one.path.removeprefix("material."))
        changes = isinstance(getattr(scene.material, tensile_name(numbered) or numbered, None), History)
        if one.of_measurement or one.path == "material.index" or changes:
            continue
        value = one.typical * (1.0 + 1e-3) if one.typical else 1e-3
        quick = with_values(scene, [one], [value])
        assert _close(quick, scene.replace(_changes(scene, one, value))), one.path
        # What follows still follows after further changes.
        again = {"filament.thickness": f"{1.01 * scene.filament.thickness!r} m"}
        assert quick.replace(again).filament.width == scene.replace(_changes(scene, one, value) | again).filament.width


def _changes(scene: sc.Scene, one: FreeParameter, value: float) -> dict[str, object]:
    text: object = value if one.unit == "1" else f"{value!r} {one.unit}"
    if not one.name.startswith("mode_"):
        return {one.path: text}
    _, number, key = one.name.split("_", 2)
    modes: Any = scene.given()["material"]
    rows = [dict(mode) for mode in modes["modes"]]
    rows[int(number) - 1][key] = text
    return {"material.modes": rows}


def _close(one: sc.Scene, other: sc.Scene) -> bool:
    return all(
        _same(getattr(one, table).physics(), getattr(other, table).physics())
        for table in ("filament", "material", "ends", "load", "initial", "run")
    )


def _same(one: object, other: object) -> bool:
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_same(one[key], other[key]) for key in one)
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=1e-15)
    return one == other


@pytest.mark.parametrize(
    ("scene", "names", "said"),
    [
        ("continual-descent", ["youngs_modulu"], "did you mean 'youngs_modulus'"),
        ("continual-descent", ["viscosity", "viscosity"], "named twice"),
        ("continual-descent", ["viscosity", "material.viscosity"], "named twice"),
        ("continual-descent", ["viscosity", "shear_viscosity"], "the same constant as viscosity"),
        ("continual-descent", ["index"], "the law 'bingham' has no index"),
        ("maxwell-slow", ["yield_stress"], "the law 'maxwell' has no yield_stress"),
        ("continual-descent", ["shear_consistency"], "did you mean 'shear_viscosity'"),
        ("continual-descent", ["numerics.cells"], "not a number that the motion"),
        ("continual-descent", ["section"], "not a number that the motion"),
        ("continual-descent", ["rest_length"], "a rough filament.rest_length"),
        ("continual-descent", ["drop"], "zero in the scene"),
        ("maxwell-slow", ["ramp"], "zero in the scene"),
        ("continual-descent", [], "nothing is free"),
    ],
)
def test_what_cannot_be_free_is_said(scene: str, names: list[str], said: str) -> None:
    with pytest.raises(sc.SceneError) as error:
        free_parameters(sc.load_scene(scene), names)
    assert said in str(error.value)
    assert len(error.value.faults) == 1


def test_bounds_are_read_with_units() -> None:
    scene = sc.load_scene("toothpaste")
    unit = free_parameters(scene, ["viscosity"])[0].unit
    low, high = 0.5 * scene.material.viscosity, 2 * scene.material.viscosity
    bounds = {"viscosity": (f"{low!r} {unit}", high), "time_offset": ("-20 ms", "0.1 s")}
    consistency, offset = free_parameters(scene, ["viscosity", "time_offset"], bounds)
    assert consistency.bounds == pytest.approx((low, high))
    assert offset.bounds == (-0.02, 0.1)
    assert consistency.lower == pytest.approx(-math.log(2))
    assert offset.upper * offset.scale == pytest.approx(0.1)


@pytest.mark.parametrize("name", OF_EACH_KIND)
def test_scaling_goes_there_and_back(name: str) -> None:
    """Bounds hold the typical value; q of it is zero for positive numbers; the slope is that of the value."""
    for one in _all(sc.load_scene(name)):
        assert one.bounds[0] <= one.typical <= one.bounds[1], one.path
        assert np.isfinite([one.lower, one.upper]).all()
        for value in (one.typical, one.bounds[0], one.bounds[1]):
            assert one.value(one.scaled(value)) == pytest.approx(value, rel=1e-12)
        q, step = one.scaled(one.typical) + 0.1, 1e-6
        slope = (one.value(q + step) - one.value(q - step)) / (2 * step)
        assert one.slope(q) == pytest.approx(slope, rel=1e-8)
