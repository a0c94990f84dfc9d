"""Groups set what a scene file that is given by groups would: the same scene, to the last bit."""

from __future__ import annotations

import pytest

import softcat_sym as sc
from softcat_sym.ensemble.table import Row, constants_of
from softcat_sym.errors import SceneError

CASES: tuple[Row, ...] = (
    {"groups.G": 0.55},
    {"groups.V": 13.0},
    {"groups.G": 0.35, "groups.V": 31.0},
    {"groups.delta": 0.04},
)


@pytest.mark.parametrize("row", CASES)
@pytest.mark.parametrize("name", ["arrested-overdamped", "continual-descent"])
def test_as_the_scene_file_would(name: str, row: Row) -> None:
    scene = sc.load_scene(name)
    assert scene.replace(constants_of(scene, row)) == sc.load_scene(name, row)


def test_each_group_comes_out_as_it_was_asked() -> None:
    from softcat_sym.scene.scene import groups_of

    scene = sc.load_scene("arrested-overdamped")
    asked: Row = {"groups.E_star": 900.0, "groups.eps_Y": 0.004, "groups.tau": 0.02}
    found = groups_of(scene.replace(constants_of(scene, asked)))
    assert (found.E_star, found.eps_Y, found.tau_star) == pytest.approx((900.0, 0.004, 0.02), rel=1e-14)
    # Alone, a ratio to Young's modulus leaves that as it is.
    assert list(constants_of(scene, {"groups.eps_Y": 0.004})) == ["material.yield_stress"]
    assert list(constants_of(scene, {"groups.G": 0.5, "groups.eps_Y": 0.004})) == [
        "material.yield_stress",
        "material.youngs_modulus",
    ]
    assert groups_of(scene.replace(constants_of(scene, {"groups.B": 0.25}))).V == pytest.approx(2.0, rel=1e-14)


def test_what_comes_out_as_it_is_is_not_set_again() -> None:
    scene = sc.load_scene("arrested-overdamped")
    assert constants_of(scene, {"groups.G": 0.4, "groups.V": 26}) == {}


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ({"groups.Gee": 1.0}, "groups.Gee: no group that a table can change; accepted: delta, G, "),
        ({"groups.duration": 3}, "accepted: .*times as run.duration"),
        ({"groups.G": "5"}, "groups.G: '5' is no positive number"),
        ({"groups.G": -1.0}, "groups.G: -1.0 is no positive number"),
        ({"groups.G": float("nan")}, "groups.G: nan is no positive number"),
        ({"groups.V": 1.0, "groups.B": 0.5}, "given twice: V and B"),
        ({"groups.G": 1.0, "material.yield_stress": "5 kPa"}, "given twice: G and material.yield_stress"),
        ({"groups.G": 1.0, "material.shear_yield_stress": "5 kPa"}, "given twice"),
    ],
)
def test_groups_that_make_no_sense_are_refused(row: Row, said: str) -> None:
    with pytest.raises(SceneError, match=said):
        constants_of(sc.load_scene("arrested-overdamped"), row)


def test_a_law_without_the_constant_refuses_its_group() -> None:
    with pytest.raises(SceneError, match=r"groups.G: given, but the law 'maxwell' has no yield stress"):
        constants_of(sc.load_scene("maxwell-slow"), {"groups.G": 1.0})
    weightless = sc.load_scene("maxwell-slow").replace({"load.gravity": "0 m/s^2"})
    with pytest.raises(SceneError, match=r"load.gravity: zero, but the groups are measured by it"):
        constants_of(weightless, {"groups.V": 1.0})
