"""What surface tension adds to the axial force of each cell, and the energy of its surface."""

from __future__ import annotations

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.necking import aspect
from softcat_sym.equations.surface import Surface, surface_tension
from softcat_sym.graph.discretisation import Setting
from softcat_sym.graph.profile import Outline
from softcat_sym.printing import CellFunction


def surface_force(surface: Surface, setting: Setting, outline: Outline, stretch: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Axial force of each cell per unit undeformed area of the scene's section, and the surface energy per unit span.

    Parameters
    ----------
    surface : Surface
        Of the section.
    setting : Setting
        Parameters and grid.
    outline : Outline
        How the section varies along the filament.
    stretch : casadi.SX, shape (cells,)
        Stretch of the centreline.
    """
    values = setting.values
    # Along a profile the width stays, so that its ratio to the thickness does not.
    given = {sy.s: stretch, sy.h0: outline.h_cells, surface_tension: values[surface_tension]}
    if aspect in values:
        given[aspect] = values[aspect] / outline.relative
    expressions = {"force": surface.force(), "energy": surface.energy()}
    found = CellFunction(expressions, (sy.s, sy.h0, surface_tension, aspect))(given)
    per_cell = ca.SX.ones(setting.grid.cells) * outline.area_cells
    return found["force"] * per_cell, ca.dot(setting.lengths.cell * per_cell, found["energy"])
