"""What a scene may state is bounded when it is read: turns of a helix, lengths of lists, formulas between samples."""

from __future__ import annotations

import math
from time import process_time
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.scene.formula import parse_formula
from softcat_sym.scene.history import read_formula

VISCOSITY = (1.0, -1.0, -1.0)
STRAND: dict[str, Any] = {
    "filament": {"span": 0.1, "thickness": 3e-3, "section": "circle", "density": 1200.0},
    "material": {"law": "maxwell", "youngs_modulus": 1e6, "viscosity": 6e4},
    "run": {"duration": 0.02},
}
ABOUT = ["x", "1 - x", "(x - 0.3)**2", "x**3 - x", "abs(x - 0.2)**1.5", "1/(2 + x)", "x**-2", "sin(7*x)*cos(3*x)"]
ABOUT += ["exp(-x**2)", "log(2 + x)", "sqrt(abs(x))", "sinh(x) - cosh(x)", "tanh(x)/asinh(3 + x)", "atan(x) - sign(x)"]
ABOUT += ["min(x, 0.1) + max(x, 0.2)", "2**x", "(1 + x*x)**x", "-(x/3 - 1)**4", "sqrt(x)", "1/x"]


@pytest.mark.parametrize("text", ABOUT)
@pytest.mark.parametrize("between", [(-1.0, 1.0), (0.2, 0.3), (0.0, 5.0), (-0.5, -0.4)])
def test_bounds_hold_every_value_and_are_those_of_a_small_part(text: str, between: tuple[float, float]) -> None:
    formula = parse_formula(text)
    low, high = formula.bounds({"x": between})
    values = np.array([formula.value_of({"x": x}) for x in np.linspace(*between, 301).tolist()])
    values = values[np.isfinite(values)]
    assert np.all((low <= values) & (values <= high))
    if values.size == 301 and math.isfinite(high - low):
        place = 0.63 * between[0] + 0.37 * between[1]
        width = np.diff(formula.bounds({"x": (place - 1e-6, place + 1e-6)}))[0]
        assert width < 1e-4 * max(1.0, np.abs(values).max())


DIPS = {
    "60 Pa*s*(1 - 2*exp(-((t - 7.31 s)/1e-6 s)**2))": (7.31, -60.0),
    "60 Pa*s*(1 - 0.999*exp(-((t - 7.31 s)/1e-6 s)**2))": None,
    "60 Pa*s*(1.001 + cos(t/1e-7 s))": None,
    "60 Pa*s*(0.999 + cos(t/1e-7 s))": "some",
    "60 Pa*s*sqrt(9.9999 - t/1s)": "some",
    "60 Pa*s*exp(-t/1s)": None,
    "60 Pa*s/(1 + (t/1e-3 s)**2) + 1 Pa*s": None,
}


@pytest.mark.parametrize("text", DIPS)
def test_a_formula_is_refused_where_it_dips_below_zero_between_any_samples(text: str) -> None:
    expected = DIPS[text]
    tables = STRAND | {"material": STRAND["material"] | {"viscosity": text}, "run": {"duration": 10.0}}
    began = process_time()
    if expected is None:
        assert sc.Scene.from_dict(tables).material.viscosity == read_formula(text, VISCOSITY)
    else:
        with pytest.raises(sc.SceneError, match=r"material.viscosity: .* at t = .*at every time of the run") as error:
            sc.Scene.from_dict(tables)
        if expected != "some":
            found = str(error.value).partition(" is ")[2].split()
            assert (float(found[4]), float(found[0])) == pytest.approx(expected, rel=1e-3)
    assert process_time() - began < 1


def test_a_flow_rule_is_refused_where_it_creates_energy_between_samples() -> None:
    dip = "sigma/a*(1 - 2*exp(-((sigma - s)/w)**2) - 2*exp(-((sigma + s)/w)**2))"
    law = {"law": "custom", "youngs_modulus": 1e6, "parameters": {"a": "1 Pa*s", "s": "12345 Pa", "w": "1e-3 Pa"}}
    sc.Scene.from_dict(STRAND | {"material": law | {"flow": "sigma/a + s/a*0 + w/a*0"}})
    with pytest.raises(sc.SceneError, match=r"material.flow: negative dissipation: -.* at 12345 Pa"):
        sc.Scene.from_dict(STRAND | {"material": law | {"flow": dip}})


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
