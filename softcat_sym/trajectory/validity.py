"""Where the theory itself ends: what a run must warn of."""

from __future__ import annotations

import numpy as np

from softcat_sym.effects import Effects
from softcat_sym.effects.prediction import effective_viscosity
from softcat_sym.graph.grading import choose_grading
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene

_SMALL = 0.1

SHORTEST_CELL = 1 / 18
"""Of the thickness. A ringing filament whose hinge has cells of h0/17 stops where elements do, on 40, 80 and 160 cells;
with cells of h0/19 to h0/35 it sags a tenth to four times further, differently on every grid."""


def warnings_of(
    scene: Scene, effects: Effects, time: Floats, nodes: Floats, fields: dict[str, Floats], residual: float
) -> list[str]:
    """Warnings in words, none if the theory holds.

    Parameters
    ----------
    effects : Effects
        In force.
    time : ndarray, shape (frames,)
        [s].
    nodes : ndarray, shape (nodes,)
        X of the nodes [m].
    fields : dict of str to ndarray
        Of the whole span: ``y`` at nodes, ``yielded_fraction`` in cells.
    residual : float
        Of the energy balance; zero for a sequence of equilibria, which has none.
    """
    midpoint = fields["y"][:, fields["y"].shape[1] // 2]
    return [
        *_surface_tension(scene, time, midpoint),
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


def _surface_tension(scene: Scene, time: Floats, midpoint: Floats) -> list[str]:
    """Capillary forces are left out: Ca = eta U/gamma must be large, or gamma/(rho g R L) small."""
    gamma = scene.surroundings.surface_tension
    if gamma == 0 or len(time) < 2:
        return []
    filament, viscosity = scene.filament, effective_viscosity(scene)
    weight = filament.density * scene.load.gravity * filament.thickness / 2 * filament.span
    static = gamma / weight if weight > 0 else np.inf
    speed = float(np.max(np.abs(np.diff(midpoint) / np.diff(time))))
    dynamic = gamma / (viscosity * speed) if viscosity and speed > 0 else np.inf
    if min(static, dynamic) < _SMALL:
        return []
    return [
        f"surface tension is left out, but gamma/(rho g R L) = {static:.2g} and 1/Ca = {dynamic:.2g}: "
        f"neither is below {_SMALL}"
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
