"""Lengths add up, and every node and cell is somebody's."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.discretization.assembly import CLAMPED_CELLS, choose_grid
from softcat_sym.discretization.grid import End, Grid, half_span, whole_span
from softcat_sym.discretization.kirchhoff import bending_nodes, free_nodes

from .filaments import scene_of

GRADED = Grid(np.array([0.0, 0.05, 0.2, 0.4, 0.5]), End.SYMMETRY, End.CLAMPED)
GRIDS = {
    "half": half_span(7, End.CLAMPED),
    "half pinned": half_span(7, End.PINNED),
    "whole": whole_span(5, End.CLAMPED, End.PINNED),
    "graded": GRADED,
}


def test_lengths_sum_to_the_span() -> None:
    for name in GRIDS:
        grid = GRIDS[name]
        span = 0.5 if grid.is_half else 1.0
        assert np.sum(grid.cell_length) == pytest.approx(span, rel=1e-14)
        assert np.sum(grid.node_length) == pytest.approx(span, rel=1e-14)
        assert np.all(grid.cell_length > 0)
        assert np.all(grid.node_length > 0)


def test_nodes_and_cells_partition_the_span() -> None:
    for name in GRIDS:
        grid = GRIDS[name]
        assert len(grid.nodes) == grid.cells + 1
        assert len(grid.centres) == len(grid.cell_length) == grid.cells
        assert np.all((grid.nodes[:-1] < grid.centres) & (grid.centres < grid.nodes[1:]))
        inner = grid.centres[1:] - grid.centres[:-1]
        np.testing.assert_allclose(grid.node_length[1:-1], inner, rtol=1e-13)


def test_midspan_is_a_node() -> None:
    assert half_span(9, End.CLAMPED).nodes[0] == 0
    whole = whole_span(9, End.CLAMPED, End.PINNED)
    assert whole.cells == 18
    assert whole.nodes[9] == pytest.approx(0, abs=1e-16)
    np.testing.assert_allclose(whole.nodes, -whole.nodes[::-1], atol=1e-16)


def test_what_is_free_and_what_carries_a_moment() -> None:
    for grid, moments, heights in [
        (half_span(4, End.CLAMPED), [0, 1, 2, 3, 4], [0, 1, 2, 3]),
        (half_span(4, End.PINNED), [0, 1, 2, 3], [0, 1, 2, 3]),
        (whole_span(2, End.CLAMPED, End.CLAMPED), [0, 1, 2, 3, 4], [1, 2, 3]),
        (whole_span(2, End.CLAMPED, End.PINNED), [0, 1, 2, 3], [1, 2, 3]),
        (whole_span(2, End.PINNED, End.PINNED), [1, 2, 3], [1, 2, 3]),
    ]:
        assert bending_nodes(grid) == moments
        assert free_nodes(grid) == ([1, 2, 3], heights)


def test_a_symmetric_scene_takes_half_the_span() -> None:
    scene = scene_of().replace({"run.accuracy": 1e-3})
    grid = choose_grid(scene)
    assert grid.is_half
    assert grid.cells == CLAMPED_CELLS
    uneven = choose_grid(scene.replace({"ends.left": "pinned", "numerics.cells": 6}))
    assert not uneven.is_half
    assert (uneven.cells, uneven.first, uneven.last) == (12, End.PINNED, End.CLAMPED)
    pinned = choose_grid(scene.replace({"ends.left": "pinned", "ends.right": "pinned"}))
    assert pinned.last is End.PINNED
