"""Bisecting along boundaries: the same labels as without it, fewer of them, each node asked for once."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest

from softcat_sym.studies.phase_runs import Node, coarse_width, refined

Rule = Callable[[int, int], str]


def wedge(i: int, j: int) -> str:
    """Three regimes that meet in a point, as no yield, arrest and descent do."""
    if i >= 27:
        return "c"
    return "a" if i < 0.6 * j + 3 else "b"


def disc(i: int, j: int) -> str:
    return "in" if (i - 17) ** 2 + (j - 21) ** 2 < 81 else "out"


def asked_of(rule: Rule, asked: list[Node]) -> Callable[[Sequence[Node]], list[str]]:
    def label(nodes: Sequence[Node]) -> list[str]:
        asked.extend(nodes)
        return [rule(*node) for node in nodes]

    return label


@pytest.mark.parametrize("rule", [wedge, disc])
def test_labels_are_those_of_every_node(rule: Rule) -> None:
    asked: list[Node] = []
    lattice = refined(40, asked_of(rule, asked))
    assert len(asked) == len(set(asked)) == len(lattice.known)
    np.testing.assert_array_equal(lattice.labels(), [[rule(i, j) for j in range(41)] for i in range(41)])
    assert lattice.saved == 41**2 - len(asked)
    # Ten squares to begin with are 121 nodes; a boundary of 40 to 80 steps takes a few nodes a step.
    assert len(asked) < 0.45 * 41**2


def test_squares_tile_the_plane_and_end_at_one_step_along_a_boundary() -> None:
    lattice = refined(40, asked_of(wedge, []))
    assert sum(square.width**2 for square in lattice.squares) == 40**2
    assert all(square.width == 1 for square in lattice.squares if len({wedge(*c) for c in square.corners()}) > 1)


def test_a_finer_neighbour_is_heeded() -> None:
    """A bump that reaches a coarse edge between its corners: the neighbour's nodes show it."""

    def bump(i: int, j: int) -> str:
        return "b" if i >= 20 or (i >= 15 and 20 < j < 24) else "a"

    np.testing.assert_array_equal(
        refined(40, asked_of(bump, [])).labels(), [[bump(i, j) for j in range(41)] for i in range(41)]
    )


@pytest.mark.parametrize(("cells", "width"), [(40, 4), (20, 2), (80, 8), (16, 2), (37, 1), (4, 1)])
def test_first_squares(cells: int, width: int) -> None:
    assert coarse_width(cells) == width
    assert refined(cells, lambda nodes: ["same"] * len(nodes)).labels().shape == (cells + 1, cells + 1)
