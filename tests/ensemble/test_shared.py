"""What members share or leave out changes nothing: tolerances as `simulate` has them, one graph for many."""

from __future__ import annotations

import pytest

import softcat_sym as sc
from softcat_sym.discretization.assembly import Body, assemble
from softcat_sym.discretization.graph import Discretisation, Graph
from softcat_sym.discretization.grid import Grid
from softcat_sym.ensemble.ensemble import Workshop, tolerances
from softcat_sym.ensemble.table import members_of
from softcat_sym.physics.filament import FilamentEquations
from softcat_sym.solvers.settings import settings_for


@pytest.mark.parametrize("name", sc.bundled_names())
def test_tolerances_are_those_of_a_single_run(name: str) -> None:
    scene = sc.load_scene(name, {"run.frames": 41})
    member = members_of(scene, [{"title": name}], "each")[0]
    assert tolerances(member) == settings_for(scene, member.effects, compiled=member.backend.compiled)


def test_equations_are_assembled_once_for_each_structure_and_grid(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[int] = []

    def counted(
        equations: FilamentEquations, grid: Grid, effects: tuple[str, ...], theory: Discretisation, body: Body
    ) -> Graph:
        made.append(grid.cells)
        return assemble(equations, grid, effects, theory, body)

    monkeypatch.setattr("softcat_sym.solvers.run.assemble", counted)
    scene = sc.load_scene("arrested-overdamped", {"run.effects": "paper", "numerics.cells": 6})
    workshop = Workshop()
    for member in members_of(scene, [{"filament.span": 0.2 + 0.01 * number} for number in range(5)], "once"):
        workshop.prepare(member)
    assert made == [6]
    rows: list[dict[str, object]] = [
        {"ends.right": right, "numerics.cells": cells} for right in ("clamped", "pinned") for cells in (6, 8)
    ]
    for member in members_of(scene, rows, "once"):
        workshop.prepare(member)
    # Clamped at both ends, half a span is enough.
    assert made == [6, 6, 8, 12, 16]
