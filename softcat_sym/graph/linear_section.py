"""What a section with a stress linear through its thickness shows and stores: for theories without shear."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca

from softcat_sym.graph.discretisation import Fields
from softcat_sym.graph.grid import Grid
from softcat_sym.graph.means import to_cells


@dataclass(frozen=True)
class Places:
    """Section quantities where the filament is cut: on all cells, or on all nodes; `turning` is always on nodes."""

    stretch: ca.SX
    turning: ca.SX
    stress_mean: ca.SX
    stress_bending: ca.SX
    flow: Mapping[str, ca.SX]


def section_fields(
    grid: Grid,
    x: ca.SX,
    y: ca.SX,
    force: tuple[ca.SX, ca.SX],
    cells: Places,
    nodes: Places,
    shown: Mapping[str, ca.SX],
    double_force: ca.SX | None = None,
) -> Fields:
    """Gather rates, energies and observables from cells (stretching) and nodes (bending).

    Parameters
    ----------
    force : tuple of casadi.SX, shape (cells,)
        Internal force.
    shown : mapping of str to casadi.SX
        Observables that the theory has at hand.
    """
    cell, node = ca.DM(grid.cell_length), ca.DM(grid.node_length)
    dissipation = ca.vertcat(cell * cells.flow["dissipation_mean"], node * nodes.flow["dissipation_bending"])
    return Fields(
        x=x,
        y=y,
        stretch=cells.stretch,
        force_x=force[0],
        force_y=force[1],
        plastic_rates={"a_0": cells.flow["rate_mean"], "a_1": nodes.flow["rate_bending"]},
        elastic_energy=ca.dot(cell, cells.flow["elastic_mean"]) + ca.dot(node, nodes.flow["elastic_bending"]),
        dissipation=dissipation,
        observables={
            **shown,
            "curvature": to_cells(nodes.turning / nodes.stretch),
            "shear": ca.SX(grid.cells, 1),
            "yielded_fraction": to_cells(nodes.flow["yielded_fraction"]),
            "plastic_rate": to_cells(nodes.flow["plastic_rate"]),
            "stress_mean": cells.stress_mean,
            "stress_bending": cells.stress_bending,
        },
        double_force=double_force,
    )
