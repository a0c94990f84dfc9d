"""A nozzle that lays a filament on a grid that stays: the exit cell is cut, and nodes are guided until they are out.

A cell that is partly out has the length that is out, and its right end at the exit; its states are means over that
length. Nodes inside move as the strand does there: the force that guides them, and what it does, is the nozzle's. It
hands a node over while a small length is fed, so that the unknowns of a quasi-static filament do not jump.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import casadi as ca

from softcat_sym.discretization.held_ends import Nozzle
from softcat_sym.discretization.stencil import Neighbours
from softcat_sym.discretization.supports import GUIDE, STUB, feed_name
from softcat_sym.discretization.unknowns import CELLS, NODES
from softcat_sym.scene.extrusion import LEAST_EXPOSED, SWITCH

if TYPE_CHECKING:
    from softcat_sym.discretization.cell import Builder

_CATCHES_UP = 0.05
"""Fed length over that of a cell in which a node inside returns to its place, where velocities are unknown."""

_LEAST_MASS = 1e-3
"""Mass of a node over its whole one, below which nothing is divided by it."""


class Exit:
    """What of the filament is out of its nozzle, at one instant."""

    def __init__(self, b: Builder, nozzle: Nozzle) -> None:
        self.b, self.nozzle = b, nozzle
        self.whole = b.place("cell")  # Length of the cells
        share = (nozzle.exit - b.X[0]) / self.whole[0]
        self.exposed = b.stage("exposed", CELLS, ca.fmin(ca.fmax(share, 0), 1))
        self._kept = b.stage("exposed_at_least", CELLS, ca.fmin(ca.fmax(share, LEAST_EXPOSED), 1))
        self.length = b.stage("exposed_length", CELLS, self.whole[0] * self._kept[0])
        self.node = b.nodes("node_length", lambda *beside: self._half(self.length, *beside))
        self.fed_length = b.stage("fed_length", CELLS, self.whole[0] * self.exposed[0])
        self.fed_node = b.nodes("fed_node_length", lambda *beside: self._half(self.fed_length, *beside))
        self.mass = b.stage("mass_at_least", NODES, ca.fmax(self.fed_node[0], _LEAST_MASS * b.place("node")[0]))
        self.release = b.nodes("release", self._release)
        self.out = ca.gt(self.exposed[0], 0)
        # Rate at which what comes out dilutes the mean of a state [1/s]; of a cell as short as it gets nothing does.
        self.diluted = b.stage("dilution", CELLS, b.rate(ca.fmax(share, LEAST_EXPOSED) * (share < 1)) / self._kept[0])
        self.fresh = b.explicit_rate(self.fed_node[0]) / self.mass[0]  # That of the nodes

    @staticmethod
    def _half(cells: Neighbours, before: int | None, behind: int | None) -> ca.SX:
        return ca.SX(sum((cells[site] / 2 for site in (before, behind) if site is not None), ca.SX(0)))

    def _release(self, before: int | None, behind: int | None) -> ca.SX:
        """Share of a node that has been handed over to its neighbours; of the first one all."""
        del behind
        if before is None:
            return ca.SX(1)
        switch = SWITCH * self.whole[before]
        share = ca.fmin(ca.fmax((self.nozzle.exit - self.b.X[0]) / switch + 0.5, 0), 1)
        return ca.SX(share**2 * (3 - 2 * share))

    @property
    def inside(self) -> tuple[ca.SX, ca.SX]:
        """What is between the right end of a cell and the node behind it: straight, in rest lengths."""
        return tuple(one * (self.whole[0] - self.length[0]) for one in self.nozzle.along)  # type: ignore[return-value]

    @property
    def catching_up(self) -> ca.SX:
        """Time in which a node inside returns to its place, where velocities are unknown [time scales]."""
        b = self.b
        rows = b.body.supports.feeds
        lasting, fed = b.named[feed_name("time", rows - 1)] / b.scale, 1 - b.named[STUB] / b.span
        return ca.SX(_CATCHES_UP * self._cell / fed * lasting)

    @property
    def _cell(self) -> ca.SX:
        """Length of a cell, of nodes: all are equal, and the first node has no other than the one behind it."""
        return ca.SX(self.b.place("node")[0])


class Guided:
    """A coordinate of the nodes: in balance where they are out, where the nozzle has it before, and between the two.

    w F + (1 - w) G = 0, with the force F of neighbours and weight, and that of the guide G, stiff and weak as the
    strand itself; with inertia the nozzle gives an acceleration.
    """

    def __init__(
        self,
        exit_: Exit,
        name: str,
        force: ca.SX,  # Of neighbours and weight [Pa]; of an angle the torque over the rest length
        off: ca.SX,  # Place in the nozzle less that of the node, in rest lengths
        nozzle_speed: ca.SX,  # In rest lengths and time scales
        speed: ca.SX | None,  # Of the node; None where it is not known
        row: ca.SX,  # Of a force the acceleration that the integrator sees
        lever: ca.SX | float = 1.0,  # Square of that of the guide: an angle is held as by a beam
        *,
        accelerates: bool = False,
    ) -> None:
        b, w = exit_.b, exit_.release[0]
        # A node that is out is free of the nozzle, whatever is left of its balance.
        inside = 1 - ca.ge(w, 1)
        self.reaction = -force * inside
        self.energy = self.loss = ca.SX(0)
        k = b.named[GUIDE] / b.place("node")[0] * lever
        if speed is None:
            self.rate = row * (w * force + (1 - w) * k * off)
            self.power = self.reaction * nozzle_speed / b.scale
            # A spring K = k (1 - w)/w, which softens from rigid to nothing: it loses K_t off^2/2.
            self.energy = self.reaction * off / 2
            share = ca.if_else(w > 0.5, k * off / ca.fmax(w, 0.5), force / (1 - ca.fmin(w, 0.5)))
            self.loss = b.explicit_rate(w) * share**2 / (2 * k)
            return
        slower = nozzle_speed + off / exit_.catching_up - speed
        if not accelerates:
            self.rate = row * (w * force + (1 - w) * k * exit_.catching_up * slower)
            self.power = self.reaction * speed / b.scale
            return
        fed = b.explicit_rate(exit_.fed_node[0]) * b.density * b.span**2 / b.scale
        momentum = exit_.mass[0] * b.density * b.span**2 / b.scale**2
        arriving = fed * (nozzle_speed - speed)  # Momentum of what comes out
        self.rate = w * (force + arriving) / momentum + (1 - w) * slower / exit_.catching_up
        self.reaction = momentum * self.rate - force
        self.power = (self.reaction * speed + fed * speed**2 / 2) / b.scale
