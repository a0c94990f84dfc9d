"""What a scene may state is bounded when it is read: turns of a helix, lengths of lists, values of formulas."""

from __future__ import annotations

import math
from time import process_time
from typing import Any

import pytest

import softcat_sym as sc
from softcat_sym.scene.history import read_formula

VISCOSITY = (1.0, -1.0, -1.0)
STRAND: dict[str, Any] = {
    "filament": {"span": 0.1, "thickness": 3e-3, "section": "circle", "density": 1200.0},
    "material": {"law": "maxwell", "youngs_modulus": 1e6, "viscosity": 6e4},
    "run": {"duration": 0.02},
}


@pytest.mark.parametrize(
    ("text", "where", "found"),
    [
        ("60 Pa*s*(1 - 2*exp(-((t - 7.31 s)/20 ms)**2))", 7.31, -60.0),
        ("60 Pa*s*(0.9999 + cos(t/3s))", 3 * math.pi, -0.006),
        ("60 Pa*s*sqrt(9.9999 - t/1s)", 10.0, math.nan),
    ],
)
def test_a_formula_is_refused_where_it_dips_below_zero(text: str, where: float, found: float) -> None:
    tables = STRAND | {"material": STRAND["material"] | {"viscosity": text}, "run": {"duration": 10.0}}
    with pytest.raises(sc.SceneError, match=r"material.viscosity: .* at t = .*at every time of the run") as error:
        sc.Scene.from_dict(tables)
    words = str(error.value).rpartition(" is ")[2].split()
    assert float(words[4]) == pytest.approx(where, rel=1e-3)
    assert float(words[0]) == pytest.approx(found, rel=1e-3, nan_ok=True)


@pytest.mark.parametrize("text", ["60 Pa*s*(1.0001 + cos(t/3s))", "60 Pa*s*exp(-t/1s)", "1 Pa*s/(1 + (t/1ms)**2)"])
def test_a_formula_that_stays_positive_is_read(text: str) -> None:
    tables = STRAND | {"material": STRAND["material"] | {"viscosity": text}, "run": {"duration": 10.0}}
    assert sc.Scene.from_dict(tables).material.viscosity == read_formula(text, VISCOSITY)


def helix(**shape: float) -> dict[str, Any]:
    return STRAND | {
        "filament": STRAND["filament"] | {"shape": "helix"} | shape,
        "run": {"duration": 1.0, "dimensions": 3},
    }


MANY = 30_000
LONG: dict[str, dict[str, Any]] = {
    "filament.shape: 'helix' of up to": helix(curvature=1e6, twist=1e-6),
    "filament.profile: a list of 30000": STRAND | {"filament": STRAND["filament"] | {"profile": [1.0] * MANY}},
    "ends.motion: a list of 30000": STRAND | {"ends": {"motion": [(0.0, 0.0, 0.0)] * MANY}},
    "run.effects: a list of 30000": STRAND | {"run": {"duration": 1.0, "effects": [f"e{k}" for k in range(MANY)]}},
    "initial.P: a list of 30000": STRAND | {"initial": {"P": [0.0] * MANY}},
}


@pytest.mark.parametrize("found", LONG)
def test_what_would_take_long_to_read_is_one_clear_error(found: str) -> None:
    began = process_time()
    with pytest.raises(sc.SceneError) as error:
        sc.Scene.from_dict(LONG[found])
    assert str(error.value).splitlines()[1].strip().startswith(found) and len(error.value.faults) == 1
    assert process_time() - began < 5
