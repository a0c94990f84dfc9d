"""The grid and the theory that a scene calls for."""

from __future__ import annotations

from softcat_sym.graph.discretisation import Discretisation
from softcat_sym.graph.grid import End, Grid, half_span, whole_span
from softcat_sym.graph.kirchhoff import KIRCHHOFF
from softcat_sym.graph.small_deflection import SMALL_DEFLECTION
from softcat_sym.scene import Scene

_THEORIES = {"filament": KIRCHHOFF, "small-deflection": SMALL_DEFLECTION}
_ENDS = {"clamped": End.CLAMPED, "pinned": End.PINNED}

DEFAULT_CELLS = 80
"""Cells per half span while nothing estimates the error of the grid."""


def choose_grid(scene: Scene) -> Grid:
    """Equal cells, as many per half span as the scene says; half the span when it is symmetric."""
    cells = scene.numerics.cells or DEFAULT_CELLS
    left, right = _ENDS[scene.ends.left], _ENDS[scene.ends.right]
    return half_span(cells, right) if left is right else whole_span(cells, left, right)


def choose_theory(scene: Scene) -> Discretisation:
    """The discretisation of the scene's model."""
    return _THEORIES[scene.model]
