"""Unknowns are sorted along the filament, and gathering undoes laying out."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from softcat_sym.discretization.grid import End, Layout, cell_block, half_span, node_block, whole_span

from .filaments import build, place, scene_of

GRID = half_span(5, End.CLAMPED)


def example() -> Layout:
    heights = np.linspace(1.0, 2.0, 6)
    return Layout("q", [node_block("y", [0, 2, 3], GRID, heights), cell_block("a", GRID)])


def test_names_are_sorted_by_position() -> None:
    layout = example()
    positions = [float(name.rsplit("= ", 1)[1]) for name in layout.names]
    assert positions == sorted(positions)
    assert len(layout.names) == layout.vector.numel() == len(layout.start) == 8


def test_starting_values_sit_at_their_names() -> None:
    layout = example()
    for name, start in zip(layout.names, layout.start, strict=True):
        kind, number = place(name)
        assert start == (1.0 + 0.2 * number if kind == "y" else 0.0)


def test_gathering_is_the_inverse_of_laying_out() -> None:
    layout = example()
    fields = {"y": layout.field("y", ca.SX(6, 1)), "a": layout.field("a", ca.SX(5, 1))}
    back = ca.Function("back", [layout.vector], [layout.gather(fields)])
    state = np.arange(8.0) ** 2
    np.testing.assert_array_equal(np.asarray(back(state)).ravel(), state)


def test_fixed_places_keep_what_they_were_given() -> None:
    layout = example()
    field = ca.Function("field", [layout.vector], [layout.field("y", ca.SX(np.full(6, 7.0)))])
    values = np.asarray(field(np.zeros(8))).ravel()
    assert [k for k, v in enumerate(values) if v == 7.0] == [1, 4, 5]


def test_an_unknown_kind_is_all_fixed() -> None:
    assert example().field("u", ca.SX(6, 1)).is_zero()


def test_an_empty_layout() -> None:
    layout = Layout("z", [])
    assert layout.names == ()
    assert layout.vector.numel() == 0
    assert layout.gather({}).numel() == 0


@pytest.mark.parametrize("grid", [GRID, whole_span(3, End.CLAMPED, End.PINNED)], ids=["half", "whole"])
def test_a_graph_starts_straight_and_at_rest(grid: object) -> None:
    graph = build(scene_of(), grid)  # type: ignore[arg-type]
    for name, start in zip(graph.state_names, graph.start, strict=True):
        kind, number = place(name)
        assert start == (graph.grid.nodes[number] if kind == "x" else 0.0), name
