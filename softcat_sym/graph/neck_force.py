"""The gradient term on the grid: what a change of the stretch from cell to cell adds to the forces.

Its discrete form is the derivative of the power sum over inner nodes of (b s_X) s_Xt, so the ends, where s_X = 0, are
left alone and the power is the one that the audit integrates.
"""

from __future__ import annotations

import casadi as ca

from softcat_sym.equations import symbols as sy
from softcat_sym.equations.necking import Neck, aspect, s_slope
from softcat_sym.graph.discretisation import Setting
from softcat_sym.graph.lengths import Lengths
from softcat_sym.graph.means import to_nodes
from softcat_sym.graph.profile import as_values
from softcat_sym.printing import CellFunction

_INPUTS = (sy.T, sy.s, s_slope, sy.h0, aspect)


def neck_double_force(neck: Neck, setting: Setting, stretch: ca.SX, tension: ca.SX) -> ca.SX:
    """B s_X at inner nodes, over the rest length [Pa], shape (cells - 1,).

    Parameters
    ----------
    neck : Neck
        The gradient term.
    setting : Setting
        Parameters, grid and profile.
    stretch, tension : casadi.SX, shape (cells,)
        Stretch of the centreline and tension per unit undeformed area.
    """
    lengths, span = setting.lengths, setting.values[sy.L_0]
    slope = ca.diff(stretch) / lengths.node[1:-1] / span
    at_nodes = {sy.T: to_nodes(lengths, tension)[1:-1], sy.s: to_nodes(lengths, stretch)[1:-1], s_slope: slope}
    known = {symbol: setting.values[symbol] for symbol in _INPUTS if symbol in setting.values}
    if setting.profile.nodes is not None:
        known[sy.h0] = known[sy.h0] * as_values(setting.profile.nodes)[1:-1]
    force = CellFunction({"b": neck.double_force()}, _INPUTS)({**known, **at_nodes})["b"]
    return setting.stage("double_force", ca.SX(force / span))


def neck_tension(lengths: Lengths, double_force: ca.SX) -> ca.SX:
    """- d/dX (b s_X), what the axial force of each cell gains, shape (cells,)."""
    padded = ca.vertcat(0, double_force, 0)
    return ca.SX(-ca.diff(padded) / lengths.cell)
