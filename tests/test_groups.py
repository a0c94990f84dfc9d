"""Groups against the formulas written out by hand, and the bundled scenes against the paper's numbers."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Groups, Scene, elastic_time, gravity_time, groups_of
from tests.common.scenes import GROUPS, faults_of, spoiled

L, G_ACC, RHO, E = 0.2, 9.81, 1900.0, 4e6
STRESS = RHO * G_ACC * L
TIME = math.sqrt(L / G_ACC)


def scene_of(**groups: object) -> Scene:
    return Scene.model_validate({"groups": {"delta": 0.03, "law": "bingham", "duration": 1.0} | groups})


def test_the_papers_set() -> None:
    scene = scene_of(G=0.4, V=26, ramp=10, duration=460, time_unit="elastic")
    assert scene.filament.span == L
    assert scene.filament.thickness == pytest.approx(0.006, rel=1e-15)
    assert scene.filament.width == scene.filament.thickness
    assert scene.filament.density == RHO
    assert scene.load.gravity == G_ACC
    assert scene.material.youngs_modulus == E
    assert scene.material.yield_stress == pytest.approx(RHO * G_ACC * L / 0.4)
    assert scene.material.viscosity == pytest.approx(26 * RHO * math.sqrt(G_ACC * L**3))
    assert scene.load.ramp == pytest.approx(10 * L * math.sqrt(RHO / E))
    assert scene.run.duration == pytest.approx(460 * L * math.sqrt(RHO / E))
    assert elastic_time(scene) == pytest.approx(L * math.sqrt(RHO / E))
    assert gravity_time(scene) == pytest.approx(TIME)


def test_hand_formulas() -> None:
    flow, limit = 2 * STRESS * TIME, STRESS / 0.5
    for groups, modulus, viscosity, yields_at in [
        ({"G": 0.5, "V": 2.0}, E, flow, limit),
        ({"G": 0.5, "B": 0.25}, E, flow, limit),
        ({"G": 0.5, "V": 2.0, "E_star": 100.0}, 100 * STRESS, flow, limit),
        ({"G": 0.5, "V": 2.0, "eps_Y": 0.01}, 200 * STRESS, flow, limit),
        ({"eps_Y": 0.01, "V": 2.0, "E_star": 100.0}, 100 * STRESS, flow, STRESS),
        ({"eps_Y": 0.01, "V": 2.0, "tau": 0.04}, 50 * STRESS, flow, 0.5 * STRESS),
        ({"G": 0.5, "tau": 0.02, "E_star": 100.0}, 100 * STRESS, flow, limit),
        ({"G": 0.5, "tau": 0.02, "eps_Y": 0.02}, 100 * STRESS, flow, limit),
        ({"law": "maxwell", "tau": 0.02, "B": 0.25}, 100 * STRESS, flow, None),
        ({"law": "maxwell", "V": 2}, E, flow, None),
        ({"law": "elastic", "E_star": 7}, 7 * STRESS, None, None),
        ({"law": "elastic"}, E, None, None),
        ({"law": "newtonian", "V": 2.0}, None, flow, None),
        ({"law": "newtonian", "B": 0.25}, None, flow, None),
        ({"law": "kelvin-voigt", "V": 2.0, "E_star": 50}, 50 * STRESS, flow, None),
        ({"law": "kelvin-voigt", "tau": 0.5, "E_star": 50}, 50 * STRESS, 25 * STRESS * TIME, None),
        ({"law": "power-law", "V": 2.0, "n": 0.4}, E, 2 * STRESS * TIME**0.4, None),
        ({"law": "power-law", "V": 2.0}, E, flow, None),
        ({"law": "power-law", "B": 0.25, "n": 1}, E, flow, None),
        ({"law": "power-law", "tau": 0.5, "E_star": 50}, 50 * STRESS, 25 * STRESS * TIME, None),
        ({"law": "herschel-bulkley", "V": 3.0, "n": 2, "G": 0.5}, E, 3 * STRESS * TIME**2, limit),
    ]:
        scene = scene_of(**groups)
        material, back = scene.material, groups_of(scene)
        values = (material.youngs_modulus, material.viscosity, material.yield_stress, material.index)
        for value, expected in zip(values, (modulus, viscosity, yields_at, groups.get("n", 1.0)), strict=True):
            assert value == (None if expected is None else pytest.approx(expected, rel=1e-13)), groups
        for name in set(groups) - {"law", "n"}:
            value = back.tau_star if name == "tau" else getattr(back, name)
            assert value == pytest.approx(groups[name], rel=1e-13), groups


def test_groups_of_laws_with_more_constants() -> None:
    def groups(material: dict[str, Any], **changes: object) -> Groups:
        return groups_of(Scene.model_validate(spoiled({"material": material} | changes)))

    modes = [{"youngs_modulus": "1 MPa", "viscosity": "2 kPa*s"}, {"youngs_modulus": "3 MPa", "viscosity": "1 kPa*s"}]
    found = groups({"law": "multimode-maxwell", "modes": modes})
    assert (found.E_star, found.V) == pytest.approx((4e6 / STRESS, 3e3 / (STRESS * TIME)))
    solid = {"law": "standard-linear", "youngs_modulus": "1 MPa", "second_modulus": "9 MPa", "viscosity": "2 Pa*s"}
    assert groups(solid).E_star == pytest.approx(1e6 / STRESS)
    own = {"law": "custom", "youngs_modulus": "1 MPa", "flow": "sigma/eta", "parameters": {"eta": "2 Pa*s"}}
    assert (groups(own).V, groups(own).G, groups(own).tau_star, groups(own).B) == (None,) * 4
    yielding = own | {"flow": "(max(sigma - c, 0) + min(sigma + c, 0))/eta"}
    yielding["parameters"] = {"eta": "2 Pa*s", "c": "1 kPa"}
    assert groups(yielding).G == pytest.approx(STRESS / 1e3)
    fluid = Scene.model_validate(spoiled({"material": {"law": "newtonian", "viscosity": "2 Pa*s"}}))
    assert elastic_time(fluid) == 0
    assert groups_of(fluid).E_star is None
    thick = {"law": "power-law", "youngs_modulus": "1 MPa", "viscosity": "2 Pa*s^2", "index": 2}
    afloat = groups(thick, **{"load.gravity": "0 m/s^2"})
    assert (afloat.V, afloat.B, afloat.tau_star) == (math.inf, 0, 0)


group = st.floats(1e-6, 1e6)


@settings(deadline=None)
@given(g=group, v=group, e=group, span=st.floats(1e-4, 1e2), gravity=st.floats(1e-2, 1e3))
def test_round_trip(g: float, v: float, e: float, span: float, gravity: float) -> None:
    block = {"delta": 0.01, "law": "bingham", "G": g, "V": v, "E_star": e, "duration": 2.0}
    table = {"groups": block, "filament": {"span": f"{span} m"}, "load": {"gravity": f"{gravity} m/s^2"}}
    scene = Scene.model_validate(table)
    groups = groups_of(scene)
    expected = (0.01, e, g, v, 1 / (g * e), v / e, 1 / (2 * v))
    found = (groups.delta, groups.E_star, groups.G, groups.V, groups.eps_Y, groups.tau_star, groups.B)
    assert found == pytest.approx(expected, rel=1e-12)
    assert scene.run.duration == pytest.approx(2 * math.sqrt(span / gravity))


BAD: list[tuple[dict[str, Any], list[tuple[str, str]]]] = [
    ({"groups.eps_Y": 0.1, "groups.E_star": 9}, [("groups.E_star", "given twice: eps_Y, G and E_star")]),
    ({"groups.B": 0.1}, [("groups.B", "given twice: V and B")]),
    ({"groups.tau": 0.1, "groups.E_star": 9}, [("groups.tau", "given twice: V, E_star and tau")]),
    ({"groups.G": None}, [("groups", "nothing fixes the yield stress; accepted: one more of groups.G")]),
    ({"groups.V": None}, [("groups", "nothing fixes the viscosity; accepted: one more of groups.V, groups.B")]),
    ({"groups.G": None, "groups.eps_Y": 0.1}, [("groups", "fixes Young's modulus and the yield stress")]),
    ({"groups.V": None, "groups.tau": 0.1}, [("groups", "fixes Young's modulus and the viscosity")]),
    ({"groups.delta": None}, [("groups.delta", "missing")]),
    ({"groups.law": None}, [("groups.law", "missing")]),
    ({"groups.law": "bingam"}, [("groups.law", "did you mean 'bingham'?")]),
    ({"groups.law": "maxwell"}, [("groups.G", "the law 'maxwell' has no yield stress")]),
    ({"groups.law": "elastic", "groups.V": None}, [("groups.G", "the law 'elastic' has no yield stress")]),
    (
        {"groups.law": "custom"},
        [("groups.law", "the law 'custom' has more constants than groups; accepted: give phys")],
    ),
    ({"groups.law": "multimode-maxwell"}, [("groups.law", "give physical values")]),
    ({"groups.law": "standard-linear"}, [("groups.law", "give physical values")]),
    ({"groups.n": 0.5}, [("groups.n", "given, but the law 'bingham' has no index")]),
    ({"groups.n": 0}, [("groups.n", "0 is out of range")]),
    (
        {"groups.law": "herschel-bulkley", "groups.n": 0.5, "groups.V": None, "groups.B": 1},
        [("groups.B", "with an index of 0.5 there is no viscosity to scale")],
    ),
    (
        {"groups.law": "herschel-bulkley", "groups.n": 0.5, "groups.V": None, "groups.tau": 1, "groups.E_star": 9},
        [("groups.tau", "with an index of 0.5 there is no viscosity to scale")],
    ),
    (
        {"groups.law": "herschel-bulkley", "groups.n": 0.5, "material.index": 0.5},
        [("material.index", "given twice, here and as groups.n")],
    ),
    ({"groups.law": "newtonian", "groups.G": None, "groups.V": None}, [("groups", "nothing fixes the viscosity")]),
    ({"groups.law": "newtonian", "groups.G": None, "groups.E_star": 9}, [("groups.E_star", "no youngs modulus")]),
    (
        {"groups.law": "newtonian", "groups.G": None, "groups.time_unit": "elastic"},
        [("groups.time_unit", "the law 'newtonian' has no Young's modulus; accepted: gravity")],
    ),
    ({"groups.delta": 1.5}, [("groups.delta", "out of range")]),
    ({"groups.G": "0.4"}, [("groups.G", "'0.4' is not a number")]),
    ({"groups.G": math.nan}, [("groups.G", "nan is not finite")]),
    ({"groups.V": -1}, [("groups.V", "out of range; accepted: a positive number")]),
    ({"groups.duration": 0}, [("groups.duration", "out of range")]),
    ({"groups.duration": None}, [("run.duration", "missing")]),
    ({"groups.ramp": -1}, [("groups.ramp", "out of range; accepted: a non-negative number")]),
    ({"groups.time_unit": "s"}, [("groups.time_unit", "accepted: gravity, elastic")]),
    ({"groups.Gee": 1}, [("groups.Gee", "unknown key")]),
    ({"groups": 3}, [("groups", "3 is not a table")]),
    ({"groups.V": 1e-320, "groups.tau": 1e10}, [("groups", "beyond 1e-30 to 1e+30 in SI units")]),
    ({"groups.delta": 1e-300}, [("groups", "thickness 2e-301, beyond")]),
    ({"groups.G": 1e300}, [("groups", "yield_stress 3.7278e-297, beyond")]),
    ({"filament.thickness": "6 mm"}, [("filament.thickness", "given twice, here and as groups.delta")]),
    ({"material.law": "bingham"}, [("material.law", "given twice, here and as groups.law")]),
    ({"run.duration": "2 s"}, [("run.duration", "given twice, here and as groups.duration")]),
    ({"groups.ramp": 1, "load.ramp": "2 s"}, [("load.ramp", "given twice, here and as groups.ramp")]),
    ({"material.yield_stress": "9 kPa"}, [("groups.G", "given twice: material.yield_stress and G")]),
    ({"material.shear_viscosity": "9 Pa s"}, [("groups.V", "given twice: material.shear_viscosity and V")]),
    (
        {"groups.E_star": 9, "material.youngs_modulus": "4 MPa"},
        [("groups.E_star", "given twice: material.youngs_modulus and E_star")],
    ),
    ({"load.gravity": "0 m/s^2"}, [("load.gravity", "zero, but [groups] is scaled by gravity")]),
    ({"filament.span": "0.2"}, [("filament.span", "has no unit")]),
    ({"material.youngs_modulus": "-4 MPa"}, [("material.youngs_modulus", "is negative")]),
    (
        {"groups.G": -1, "groups.B": 0.1, "run.frames": -3, "filament.width": "1 s"},
        [("groups.G", "out of range"), ("groups.B", "given twice"), ("filament.width", "a time"), ("run.frames", "-3")],
    ),
]


def test_bad_groups() -> None:
    for changes, expected in BAD:
        faults = faults_of(spoiled(changes, GROUPS))
        assert [fault.path for fault in faults] == [path for path, _ in expected]
        for fault, (_, says) in zip(faults, expected, strict=True):
            assert says in str(fault)


BUNDLED = {
    "no-yield": (0.03, 0.01, 26.0),
    "arrested-overdamped": (0.03, 0.4, 26.0),
    "arrested-underdamped": (0.03, 0.25, 0.4),
    "continual-descent": (0.03, 1.9, 26.0),
    "edge-of-rupture": (0.03, 0.4, 0.4),
}


def test_the_papers_scenes() -> None:
    for name, expected in BUNDLED.items():
        scene = load_scene(name)
        groups = groups_of(scene)
        assert (groups.delta, groups.G, groups.V) == pytest.approx(expected, rel=1e-13)
        assert groups.eps_Y == pytest.approx(STRESS / expected[1] / E)
        assert scene.material.law == "bingham"
        assert scene.load.ramp / elastic_time(scene) == pytest.approx(10)
        assert scene.run.duration / elastic_time(scene) == pytest.approx(460)
