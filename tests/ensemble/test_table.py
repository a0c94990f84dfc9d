"""A table, however it is given, is the same rows; what is no table is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.ensemble.table import Row, rows_of, written
from softcat_sym.errors import SceneError

COLUMNS = {"filament.span": [0.2, 0.3], "material.law": ["bingham", "elastic"]}
ROWS = [{"filament.span": 0.2, "material.law": "bingham"}, {"filament.span": 0.3, "material.law": "elastic"}]


class Frame:
    """What a data frame and this table have in common."""

    def keys(self) -> list[str]:
        return list(COLUMNS)

    def __getitem__(self, key: str) -> np.ndarray[Any, Any]:
        return np.array(COLUMNS[key])


STRUCTURED = np.array([(0.2, "bingham"), (0.3, "elastic")], dtype=[("filament.span", float), ("material.law", "U9")])


@pytest.mark.parametrize("table", [COLUMNS, ROWS, tuple(ROWS), STRUCTURED, Frame()])
def test_every_form_gives_the_same_rows_of_plain_values(table: object) -> None:
    rows = rows_of(table)
    assert rows == ROWS
    assert {type(value) for row in rows for value in row.values()} == {float, str}


@pytest.mark.parametrize(
    ("table", "said"),
    [
        ({"filament.span": [1, 2], "load.gravity": [1]}, "unequal lengths: filament.span has 2, load.gravity has 1"),
        ({}, "without rows"),
        ([], "without rows"),
        ({"filament.span": []}, "without rows"),
        ({"filament.span": "20 cm"}, "filament.span: '20 cm' is not a column"),
        ({"filament.span": 0.2}, "filament.span: 0.2 is not a column"),
        ({"filament.span": np.array(0.2)}, "is not a column"),
        ("arrested", "'arrested' is no table"),
        (3, "3 is no table"),
        ([{"filament.span": 0.2}, 3], "row 1: 3 is not a mapping"),
        (
            [{"filament.span": 0.2}, {"filament.spam": 0.2}],
            "row 1: its keys differ from those of row 0 by .*spam, .*span",
        ),
        ({"run.frames": [3, 4]}, "run.frames: given in the table, but members share"),
    ],
)
def test_what_is_no_table_is_refused(table: object, said: str) -> None:
    with pytest.raises(SceneError, match=said):
        rows_of(table)


def test_plain_numbers_get_the_unit_of_their_key() -> None:
    scene = sc.load_scene("oobleck")
    row: Row = {"filament.span": 0.25, "ends.drop": 1, "material.viscosity": 3.0, "material.index": 0.5, "run.title": 1}
    assert written(scene, row) == {
        "filament.span": "0.25 m",
        "ends.drop": "1.0 m",
        "material.viscosity": "3.0 Pa*s^0.5",
        "material.index": 0.5,
        "run.title": 1,
    }
    assert written(scene, {"filament.span": "25 cm", "numerics.cells": 8}) == {
        "filament.span": "25 cm",
        "numerics.cells": 8,
    }


def test_plain_numbers_get_the_unit_of_a_parameter_of_a_law_of_ones_own() -> None:
    scene = sc.load_scene("transient-gel")
    for one in scene.material.parameters:
        key, value = f"material.parameters.{one.name}", one.value
        assert scene.replace(written(scene, {key: 2 * value})).replace(written(scene, {key: value})) == scene
