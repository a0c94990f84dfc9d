"""Where the theory itself ends: what a run must warn of."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects import Effects
from softcat_sym.effects.surface_tension import neglected_surface, rounded_corners
from softcat_sym.graph.grading import choose_grading
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene

SHORTEST_CELL = 1 / 18
"""Of the thickness. A ringing filament whose hinge has cells of h0/17 stops where elements do, on 40, 80 and 160 cells;
with cells of h0/19 to h0/35 it sags a tenth to four times further, differently on every grid."""


def warnings_of(
    scene: Scene, effects: Effects, capillary: float, nodes: Floats, fields: dict[str, Floats], residual: float
) -> list[str]:
    """Warnings in words, none if the theory holds.

    Parameters
    ----------
    effects : Effects
        In force.
    capillary : float
        Share of the sag that surface tension would take.
    nodes : ndarray, shape (nodes,)
        X of the nodes [m].
    fields : dict of str to ndarray
        Of the whole span: ``yielded_fraction`` in cells.
    residual : float
        Of the energy balance; zero for a sequence of equilibria, which has none.
    """
    return [
        *filter(None, (neglected_surface(scene, capillary), rounded_corners(scene))),
        *_short_hinge_cells(scene, effects, nodes, fields["yielded_fraction"]),
        *_swelling(scene, effects, residual),
    ]


def shortest_hinge_cell(scene: Scene, effects: Effects, nodes: Floats, yielded: Floats) -> float | None:
    """Length over thickness of the shortest cell at a clamp whose section has yielded and shears, if it is too short.

    A sheared section that has yielded resists a neck only over lengths comparable with the thickness: below
    `SHORTEST_CELL` the answer may change with the grid. Only a grading set by hand makes such cells where they need
    not be: the program's own are that short in a filament too thick to neck.

    Parameters
    ----------
    effects : Effects
        In force.
    nodes : ndarray, shape (nodes,)
        X of the nodes [m].
    yielded : ndarray, shape (frames, cells)
        Share of the section that has yielded.
    """
    if not {"yielding", "bending"} <= set(effects.names) or not {"shear", "fibres"} & set(effects.names):
        return None
    asked = scene.numerics.grading
    if asked is None or asked <= choose_grading(scene, (len(nodes) - 1) // 2, effects):
        return None
    ends = [place for place, end in ((0, scene.ends.left), (-1, scene.ends.right)) if end == "clamped"]
    lengths = np.diff(nodes) / scene.filament.thickness
    short = [float(lengths[end]) for end in ends if np.max(yielded[:, end]) > 0.5 and lengths[end] < SHORTEST_CELL]
    return min(short, default=None)


def _short_hinge_cells(scene: Scene, effects: Effects, nodes: Floats, yielded: Floats) -> list[str]:
    shortest = shortest_hinge_cell(scene, effects, nodes, yielded)
    if shortest is None:
        return []
    return [
        f"cells of the hinge at a clamp are 1/{1 / shortest:.0f} of the thickness long: below "
        f"1/{1 / SHORTEST_CELL:.0f} a hinge may neck as the grid lets it; leave out numerics.grading or take fewer "
        "numerics.cells"
    ]


def _swelling(scene: Scene, effects: Effects, residual: float) -> list[str]:
    """Without thinning a section swells as it is drawn: the energy that this stores, no force gives back."""
    swells = "finite-stretch" in effects.names and "thinning" not in effects.names
    if not swells or scene.run.closure != "material" or residual <= scene.run.accuracy:
        return []
    return [
        f"the energy residual, {residual:.2g}, exceeds the accuracy of {scene.run.accuracy:g}: with finite-stretch and "
        "without thinning the section swells as it is drawn, and energy is not conserved; add thinning to run.effects"
    ]
