"""What a sweep varies: ranges, lists, tables, hypercubes; each fault one clear refusal."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.studies.sweep_table import SweepPlan, plan_sweep

SCENE = sc.load_scene("ink-bridge", {"run.effects": "paper"})


def plan(*texts: str, mode: str = "grid", samples: int | None = None, seed: int = 0) -> SweepPlan:
    return plan_sweep(SCENE, texts, mode, samples=samples, seed=seed)


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("groups.G=0.01:1:3:log", (0.01, 0.1, 1.0)),
        ("groups.G=1:2:3", (1.0, 1.5, 2.0)),
        ("material.yield_stress=5:20 kPa:4", (5e3, 1e4, 1.5e4, 2e4)),
        ('material.yield_stress="5 kPa":"20000 Pa":4', (5e3, 1e4, 1.5e4, 2e4)),
        ("numerics.cells=10:40:4", (10, 20, 30, 40)),
        ("material.yield_stress=5 kPa,200 Pa", ("5 kPa", "200 Pa")),
        ('material.yield_stress="5 kPa", "200 Pa"', ("5 kPa", "200 Pa")),
        ("filament.span=4,5,6 mm", ("4 mm", "5 mm", "6 mm")),
        ("material.law=bingham,maxwell", ("bingham", "maxwell")),
        ('run.effects=["inertia"],["inertia", "bending"]', (["inertia"], ["inertia", "bending"])),
    ],
)
def test_values_of_an_axis(text: str, values: tuple[object, ...]) -> None:
    (axis,) = plan(text).axes
    assert axis.values == values
    assert axis.scale == ("log" if text.endswith("log") else "lin")


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (("groups.G",), "'groups.G' varies nothing"),
        (("groups.G=",), "varies nothing"),
        (("groups.G=1:2:1",), "at least 2 values"),
        (("groups.G=1:2:2.5",), "is no range"),
        (("groups.G=-1:2:5:log",), "logarithmic, and not positive"),
        (("groups.G=0:2:5:log",), "logarithmic, and not positive"),
        (("groups.G=1:1:5",), "are the same"),
        (("groups.G=1:2:5:cubic",), "is no range"),
        (("groups.G=1:2",), "is no range"),
        (("groups.G=1:nan:5",), "is not finite"),
        (("groups.G=a:b:5",), "no plain numbers"),
        (("groups.G=1,,2",), "an empty value"),
        (("groups.G=1,1",), "1 is named twice"),
        (("groups.G=1:2:5", "groups.G=3,4"), "varied twice"),
        (("material.yield_stress=5:20:3",), "has no unit"),
        (("material.yield_stress=5,20",), "has no unit"),
        (("material.yield_stress=5:20 kg:3",), "not a stress"),
        (("material.yield_stress=5:20 parsnips:3",), "unknown unit 'parsnips'"),
        (("filament.span=1 mm,2 parsek",), "unknown unit 'parsek'"),
        (("filament.span=1 mm,2 kg",), "'kg' is a mass"),
        (("numerics.cells=10:12:7",), "does not give 7 whole numbers"),
        (("run.frames=11,21",), "members share their frames"),
        (("groups.G=1:2:9999", "groups.V=1:2:9999"), "accepted: up to 10000000"),
    ],
    ids=lambda value: " ".join(value) if isinstance(value, tuple) else "",
)
def test_faults_of_an_axis(texts: tuple[str, ...], said: str) -> None:
    with pytest.raises(SoftcatError, match=said):
        plan(*texts)


def test_modes_and_their_faults() -> None:
    assert plan("groups.G=1,2,3", "groups.V=4,5").members == 6
    assert [plan("groups.G=1,2", "groups.V=4,5").row(k) for k in range(4)] == [
        {"groups.G": G, "groups.V": V} for G in (1, 2) for V in (4, 5)
    ]
    assert plan("groups.G=1,2", "groups.V=4,5", mode="zip").row(1) == {"groups.G": 2, "groups.V": 5}
    for texts, mode, samples, said in (
        (("groups.G=1,2,3", "groups.V=4,5"), "zip", None, "unequal lengths.*groups.G has 3, groups.V has 2"),
        (("groups.G=1,2",), "random", None, "no mode 'random'.*grid, zip, lhs"),
        (("groups.G=1:2",), "lhs", None, "needs a number of samples"),
        (("groups.G=1:2",), "lhs", 1, "needs a number of samples"),
        (("groups.G=1,2",), "grid", 10, "samples are for a Latin hypercube"),
    ):
        with pytest.raises(SoftcatError, match=said):
            plan(*texts, mode=mode, samples=samples)


def test_a_latin_hypercube_has_one_sample_in_each_part_of_each_axis() -> None:
    found = plan("groups.G=0.01:1:log", "filament.span=4:12 mm", "numerics.cells=10,20", mode="lhs", samples=50, seed=3)
    rows = [found.row(member) for member in range(found.members)]
    G = np.array([float(str(row["groups.G"])) for row in rows])
    span = np.array([float(str(row["filament.span"])) for row in rows])
    np.testing.assert_array_equal(np.sort(np.floor(50 * np.log(G / 0.01) / np.log(100))), np.arange(50))
    np.testing.assert_array_equal(np.sort(np.floor(50 * (span - 4e-3) / 8e-3)), np.arange(50))
    assert sorted(row["numerics.cells"] for row in rows) == [10] * 25 + [20] * 25  # type: ignore[type-var]
    assert abs(float(np.corrcoef(np.log(G), span)[0, 1])) < 0.5
    other = plan("groups.G=0.01:1:log", "filament.span=4:12 mm", "numerics.cells=10,20", mode="lhs", samples=50, seed=4)
    assert other.row(0) != found.row(0)
    assert other.digest != found.digest


def test_a_table(tmp_path: Path) -> None:
    file = tmp_path / "members.csv"
    file.write_text("# of mine\ngroups.G, filament.span [mm], material.law\n0.5, 4, bingham\n1, 5, bingham\n")
    found = plan_sweep(SCENE, file)
    assert (found.mode, found.members) == ("table", 2)
    assert found.row(0) == {"groups.G": 0.5, "filament.span": "4 mm", "material.law": "bingham"}


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "empty"),
        ("groups.G,groups.V\n", "no rows"),
        ("0.5,26\n0.6,27\n", "'0.5' is no dotted key"),
        ("groups.G,groups.G\n1,2\n", "groups.G stands there twice"),
        ("groups.G,groups.V\n1\n", "line 2: 1 value, but the header has 2 keys"),
        ("groups.G,groups.V\n1,\n", "line 2, groups.V: an empty cell"),
        ("groups.G\nNaN\n", "is not finite"),
        ("filament.span [bananas]\n4\n", "line 1, filament.span: unknown unit 'bananas'"),
        ("filament.span\n4\n", "'4' has no unit.*filament.span"),
    ],
)
def test_faults_of_a_table(text: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "members.csv"
    file.write_text(text)
    with pytest.raises(SoftcatError, match=said):
        plan_sweep(SCENE, file)
    with pytest.raises(SoftcatError, match="no such file"):
        plan_sweep(SCENE, tmp_path / "none.csv")
