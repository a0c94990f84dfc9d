"""The staggered grid along the filament: positions and moments on nodes, stretch and tension in cells."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.estimates.forecast import shaken_share
from softcat_sym.estimates.quasi_static_sag import load_factor
from softcat_sym.estimates.scaling import beam_of, first_yield_gravity_number, gravity_number_of
from softcat_sym.scene.ends import SYMMETRY, Support
from softcat_sym.scene.scene import Scene, carries_moment, groups_of


@dataclass(frozen=True, eq=False)
class Grid:
    """Nodes in units of the rest length, with what holds the first and the last."""

    nodes: Floats  # shape (cells + 1,); X/L_0, from 0 to 1/2 for half a span, from -1/2 to 1/2 for a whole one
    first: Support  # The end conditions
    last: Support

    @property
    def cells(self) -> int:
        """Number of cells on this grid."""
        return len(self.nodes) - 1

    @property
    def is_half(self) -> bool:
        """Whether the grid stops at the symmetry plane."""
        return self.first is SYMMETRY

    @property
    def cell_length(self) -> Floats:
        """Length of each cell, shape (cells,)."""
        return np.asarray(np.diff(self.nodes), dtype=float)

    @property
    def node_length(self) -> Floats:
        """Length that each node answers for, half of either neighbouring cell, shape (cells + 1,)."""
        half = self.cell_length / 2
        behind: Floats = np.concatenate([half, [0.0]])
        before: Floats = np.concatenate([[0.0], half])
        return behind + before

    @property
    def centres(self) -> Floats:
        """Middle of each cell, shape (cells,)."""
        return np.asarray((self.nodes[1:] + self.nodes[:-1]) / 2, dtype=float)


def half_span(cells: int, support: Support, grading: float = 1.0, *, middle: bool = False, edge: float = 0.5) -> Grid:
    """Half a symmetric filament, from the symmetry plane X = 0 to the support at X = L/2."""
    return Grid(_edged(cells, grading, middle=middle, edge=edge), SYMMETRY, support)


def whole_span(
    cells_per_half: int, left: Support, right: Support, grading: float = 1.0, *, middle: bool = False, edge: float = 0.5
) -> Grid:
    """A whole filament: the half span and its mirror image, so that X = 0 is a node and neighbours there are equal."""
    half = _edged(cells_per_half, grading, middle=middle, edge=edge)
    return Grid(np.concatenate([-half[:0:-1], half]), left, right)


def _edged(cells: int, grading: float, *, middle: bool, edge: float) -> Floats:
    """X/L from 0 to 1/2 with a node at the edge of a body, towards which the lengths decrease from either side.

    A node presses on a sharp edge where the edge is, only if it is there: elsewhere the span would be a cell longer.
    """
    inner = round(2 * cells * edge)
    if edge >= 0.5 or not 0 < inner < cells:
        return _graded(cells, grading, middle=middle)
    before = 2 * edge * _graded(inner, grading, middle=middle)
    behind = 0.5 - (1 - 2 * edge) * _graded(cells - inner, grading, middle=False)[::-1]
    return np.concatenate([before, behind[1:]])


def _graded(cells: int, grading: float, *, middle: bool) -> Floats:
    """X/L from 0 to 1/2, shape (cells + 1,), the lengths in geometric progression towards the support.

    Any two neighbours differ by ``grading ** (1/(cells - 1))``, which tends to 1 as cells are added: the nodes lie on a
    smooth map of an equal grid, X_xi = const grading^-xi, so differences that are of second order on equal cells
    remain so. A cell at the distance d from the support is in proportion to d + (L/2)/(grading - 1).
    Towards the middle too, lengths are grading^(-cos^2 (pi xi)) in the place of grading^-xi.
    """
    if cells < 1:
        raise SoftcatError(f"grid of {cells} cells per half span: take 1 or more")
    if not 0 < grading < np.inf:
        raise SoftcatError(f"grading of {grading}: take a positive number, 1 for equal cells")
    if grading == 1:
        return np.linspace(0.0, 0.5, cells + 1)
    if middle:
        lengths = grading ** -(np.cos(np.pi * (np.arange(cells) + 0.5) / cells) ** 2)
    else:
        lengths = grading ** -np.linspace(0.0, 1.0, cells)
    nodes = np.concatenate([[0.0], np.cumsum(lengths)]) / (2 * lengths.sum())
    nodes[-1] = 0.5
    return np.asarray(nodes, dtype=float)


LEAST = 3.0
"""Without a hinge a shearing filament is smooth at its clamps, and so is the small-deflection model: cells are soon
missed at midspan, and a ratio of 10 costs more than it gains."""

MOST = 30.0
"""Beyond it the cells at midspan, 3.5 times as long as equal ones, carry the error."""

SMOOTH_KIRCHHOFF = 10.0
"""A filament that does not shear has its moment, and with it the largest error, at the clamp even while elastic."""

_HEAVY = 2.0
"""Load of weight and filament, in that of the filament, from which on the weight makes a hinge of its own."""

HINGE_CELL = 1 / 15
"""Shortest cell over thickness at the hinge of a shearing filament: it bends and shears within about a thickness, and
at h0/L = 0.03 the error of the arrested filament falls from 1 % to 0.1 % as that cell shrinks from 1/5 to 1/10."""


def choose_grading(scene: Scene, cells: int, effects: Effects | None = None) -> float:
    """Choose the ratio of the longest cell to the shortest; 1 where no end is clamped or nothing bends."""
    terms = (effects or choose_effects(scene)).terms()
    if scene.extrusion.present or not (carries_moment(scene) and terms.bending):
        return 1.0
    hinge = terms.yields and may_yield(scene)
    if scene.model == "small-deflection":
        return LEAST
    if terms.turns:
        return _ratio_for(HINGE_CELL * groups_of(scene).delta, cells) if hinge else LEAST
    return MOST if hinge else SMOOTH_KIRCHHOFF


def towards_middle(scene: Scene, effects: Effects | None = None) -> bool:
    """Whether cells are to be short at midspan too: a weight that hangs there makes a hinge under it.

    With a weight of the filament's own, cells that are long there leave 0.15 % of error on 40 cells, of first order,
    which a comparison of two grids finds too small by a factor of three; short ones leave 0.02 %. A weight of less than
    half the filament's own makes no such hinge.
    """
    terms = (effects or choose_effects(scene)).terms()
    return terms.bending and terms.yields and load_factor(scene) > _HEAVY and may_yield(scene)


def may_yield(scene: Scene) -> bool:
    """Whether a fibre yields under a load at once, with at most twice the static moment, and what shaking adds."""
    gravity_number = gravity_number_of(scene)
    bound = beam_of(scene).overshoot_bound + shaken_share(scene)
    return gravity_number is not None and gravity_number * bound > first_yield_gravity_number(scene)


def _ratio_for(shortest: float, cells: int) -> float:
    """Ratio r at which the shortest of many cells in geometric progression, L ln r/(2 N (r - 1)), is `shortest` L."""
    ratios = np.geomspace(LEAST, MOST, 100)
    found = np.log(ratios) / (2 * cells * (ratios - 1))
    # np.interp wants ascending abscissae, and stays at the ends of the range beyond them.
    return float(np.interp(-shortest, -found, ratios))
