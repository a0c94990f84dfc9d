"""The body of the filament beyond its equations: where it is held, how thick it is where, and what hangs on it."""

from __future__ import annotations

from dataclasses import dataclass, field

import casadi as ca
import numpy as np

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.filament import FilamentEquations
from softcat_sym.graph.cell_printer import Inputs
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.parameters import POINT_MASS
from softcat_sym.graph.profile import Profile, node_mass
from softcat_sym.graph.supports import Supports


@dataclass(frozen=True)
class Body:
    """What of the filament's body and its supports a graph has to know, beyond equations and grid.

    Attributes
    ----------
    supports : Supports
        Where they are and how they move.
    profile : Profile
        How the section varies along the filament.
    weighted : bool
        Whether a mass hangs at midspan.
    """

    supports: Supports = field(default_factory=Supports)
    profile: Profile = field(default_factory=Profile)
    weighted: bool = False

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the numbers that it needs."""
        return (*self.supports.parameters, *((POINT_MASS,) if self.weighted else ()))


def node_masses(equations: FilamentEquations, grid: Grid, body: Body, given: Inputs) -> ca.SX:
    """Mass of each node over density, undeformed area and rest length, shape (cells + 1,)."""
    mass = ca.SX(node_mass(grid, body.profile, equations.shape.area_power))
    if body.weighted:
        middle = int(np.argmin(np.abs(grid.nodes)))
        hung = given.named[POINT_MASS] / (given.symbols[sy.rho] * given.symbols[sy.L_0])
        mass[middle] += hung / 2 if grid.is_half else hung
    return mass
