"""A nozzle that lays a filament on a grid that stays: the exit cell is cut, and nodes are guided until they are out.

A cell that is partly out has the length that is out, and its right end at the exit; its states are means over that
length. Nodes inside move as the strand does there: the force that guides them, and what it does, is the nozzle's. It
hands a node over while a small length is fed, so that the unknowns of a quasi-static filament do not jump.
"""

from __future__ import annotations

import casadi as ca

from softcat_sym.discretization.cell import Builder, Exit
from softcat_sym.discretization.held_ends import Nozzle
from softcat_sym.discretization.stencil import Neighbours
from softcat_sym.discretization.supports import GUIDE, STUB, feed_name
from softcat_sym.discretization.unknowns import CELLS, NODES
from softcat_sym.physics.exit_cell import arriving_momentum, guide_energy, guide_loss, handed_over
from softcat_sym.scene.feed import LEAST_EXPOSED, SWITCH

_CATCHES_UP = 0.05
"""Fed length over that of a cell in which a node inside returns to its place, where velocities are unknown."""

_LEAST_MASS = 1e-3
"""Mass of a node over its whole one, below which nothing is divided by it."""


def cut_by(b: Builder, nozzle: Nozzle) -> None:
    """Let the cells and nodes of a filament be those that are out of its nozzle."""
    whole, full_node = b.place("cell"), b.place("node")[0]
    share = (nozzle.exit - b.X[0]) / whole[0]
    exposed = b.stage("exposed", CELLS, ca.fmin(ca.fmax(share, 0), 1))
    kept = b.stage("exposed_at_least", CELLS, ca.fmin(ca.fmax(share, LEAST_EXPOSED), 1))
    length = b.stage("exposed_length", CELLS, whole[0] * kept[0])
    fed = b.stage("fed_length", CELLS, whole[0] * exposed[0])

    def half(cells: Neighbours, before: int | None, behind: int | None) -> ca.SX:
        return ca.SX(sum((cells[site] / 2 for site in (before, behind) if site is not None), ca.SX(0)))

    def release(before: int | None, behind: int | None) -> ca.SX:
        """Share of a node that has been handed over to its neighbours; of the first one all."""
        del behind
        if before is None:
            return ca.SX(1)
        passed = (nozzle.exit - b.X[0]) / (SWITCH * whole[before]) + 0.5
        return ca.SX(handed_over(ca.fmin(ca.fmax(passed, 0), 1)))

    fed_node = b.nodes("fed_node_length", lambda *beside: half(fed, *beside))
    mass = b.stage("mass_at_least", NODES, ca.fmax(fed_node[0], _LEAST_MASS * full_node))
    lasting, stub = b.named[feed_name("time", b.body.supports.feeds - 1)] / b.scale, b.named[STUB] / b.span
    x, y = (one * (whole[0] - length[0]) for one in nozzle.along)
    b.exit = Exit(
        nozzle,
        exposed,
        b.nodes("release", release),
        fed_node,
        mass,
        # Of a cell as short as it gets nothing is diluted.
        b.stage("dilution", CELLS, b.rate(ca.fmax(share, LEAST_EXPOSED) * (share < 1)) / kept[0]),
        b.explicit_rate(fed_node[0]) / mass[0],
        (x, y),
        _CATCHES_UP * full_node / (1 - stub) * lasting,
    )
    b.length, b.borne = length, fed_node
    b.node = b.nodes("node_length", lambda *beside: half(length, *beside))


class Guided:
    """A coordinate of the nodes: in balance where they are out, where the nozzle has it before, and between the two.

    w F + (1 - w) G = 0, with the force F of neighbours and weight, and that of the guide G, stiff and weak as the
    strand itself; with inertia the nozzle gives an acceleration.
    """

    def __init__(
        self,
        b: Builder,
        exit_: Exit,
        force: ca.SX,  # Of neighbours and weight [Pa]; of an angle the torque over the rest length
        off: ca.SX,  # Place in the nozzle less that of the node, in rest lengths
        nozzle_speed: ca.SX,  # In rest lengths and time scales
        speed: ca.SX | None,  # Of the node; None where it is not known
        row: ca.SX,  # Of a force the acceleration that the integrator sees
        lever: ca.SX | float = 1.0,  # Square of that of the guide: an angle is held as by a beam
        *,
        accelerates: bool = False,
    ) -> None:
        w = exit_.release[0]
        # A node that is out is free of the nozzle, whatever is left of its balance.
        inside = 1 - ca.ge(w, 1)
        self.reaction = -force * inside
        self.energy = self.loss = ca.SX(0)
        k = b.named[GUIDE] / b.place("node")[0] * lever
        if speed is None:
            self.rate = row * (w * force + (1 - w) * k * off)
            self.power = self.reaction * nozzle_speed / b.scale
            # The same in balance: of a small w known by the force, of a large one by the place.
            self.energy = guide_energy(self.reaction, off)
            share = ca.if_else(w > 0.5, k * off / ca.fmax(w, 0.5), force / (1 - ca.fmin(w, 0.5)))
            self.loss = guide_loss(b.explicit_rate(w), k, share)
            return
        slower = nozzle_speed + off / exit_.catching_up - speed
        if not accelerates:
            self.rate = row * (w * force + (1 - w) * k * exit_.catching_up * slower)
            self.power = self.reaction * speed / b.scale
            return
        fed = b.explicit_rate(exit_.fed_node[0]) * b.density * b.span**2 / b.scale
        momentum = exit_.mass[0] * b.density * b.span**2 / b.scale**2
        self.rate = (
            w * (force + arriving_momentum(fed, nozzle_speed, speed)) / momentum + (1 - w) * slower / exit_.catching_up
        )
        self.reaction = momentum * self.rate - force
        self.power = (self.reaction * speed + fed * speed**2 / 2) / b.scale
