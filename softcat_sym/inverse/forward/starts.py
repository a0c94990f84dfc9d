"""Where a filament begins, for one set of values after another: followed from the last one, not sought anew."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np
import numpy.typing as npt

from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, is_slack
from softcat_sym.solve.assembled import Assembled
from softcat_sym.solve.equilibrium import Equilibrium
from softcat_sym.solve.starting import Start, is_straight, starting_state

_Unknown = tuple[str, int]


class Starts:
    """Starting states of a filament whose numbers change.

    Parameters
    ----------
    assembled : Assembled
        The filament with its typical numbers.
    follow : bool
        Whether plastic strains at the start are the same for all values, so that only shapes need to be followed.

    Attributes
    ----------
    last : Start or None
        The last one found, from which the next is followed.
    """

    def __init__(self, assembled: Assembled, *, follow: bool = True) -> None:
        self._follow = follow
        self._graph = assembled.graph
        self._assembled = assembled
        self._straight, self._slack = is_straight(assembled.scene), is_slack(assembled.scene)
        # Without algebraic unknowns nothing is sought: the straight filament as it is.
        self._bare = replace(self._graph, z=ca.SX(0, 1))
        self._equilibrium = Equilibrium(self._graph) if self._graph.is_dae else None
        self._followed = _Followed(self._graph, assembled.at_rest()) if self._is_followed else None
        self.last: Start | None = None

    @property
    def _is_followed(self) -> bool:
        """Whether its shape at rest is that of another graph, without inertia and viscous stress."""
        return not self._straight and not self._graph.positions_are_algebraic

    def at(self, scene: Scene, p: Floats, near: Start | None = None, *, settle: bool = True) -> Start | None:
        """Where the filament begins; None if no shape in balance is found, or it is of another kind.

        Parameters
        ----------
        scene, p
            With the values asked for.
        near : Start
            That of neighbouring values; by default the last one found.
        settle : bool
            Whether algebraic unknowns must be consistent; otherwise they are about those of `near`.
        """
        if is_slack(scene) != self._slack or is_straight(scene) != self._straight:
            return None
        near = near or self.last
        found = self._near(scene, p, near, settle) if near is not None and self._follow else None
        if found is None:
            statics = None if self._followed is None else self._followed.statics
            found = starting_state(scene, self._graph, p, statics)
        if found is not None and settle:
            self.last = found
        return found

    def _near(self, scene: Scene, p: Floats, near: Start, settle: bool) -> Start | None:
        if self._followed is not None:
            rested = self._followed.at(near, p, slack=self._slack)
            if rested is None:
                return None
            x, guess = rested.x, rested.z
        elif self._straight and not self._graph.positions_are_algebraic:
            plain = starting_state(scene, self._bare, p, None)
            if plain is None:
                return None
            x, guess = plain.x, near.z if near.z.size else plain.z
        else:
            x, guess = near.x, near.z
        if self._equilibrium is None or not settle:
            return Start(x, guess)
        z = self._equilibrium.search(0.0, x, p, [guess])
        return None if z is None else Start(x, z)


class _Followed:
    """A shape at rest, as unknowns of the filament that moves."""

    def __init__(self, graph: Graph, rest: Graph) -> None:
        self._graph, self._rest = graph, rest
        self._equilibrium = Equilibrium(rest)
        x = _numbered(graph.x_kinds, graph.x_places)
        z = _numbered(graph.z_kinds, graph.z_places)
        rest_x, rest_z = _numbered(rest.x_kinds, rest.x_places), _numbered(rest.z_kinds, rest.z_places)
        self._plastic = _pairs(rest_x, x)
        self._moving, self._still = _pairs(rest_z, x), _pairs(rest_z, z)
        self._complete = len(self._moving[0]) + len(self._still[0]) == len(rest_z)

    def statics(self) -> Graph:
        """The graph of the shape at rest."""
        return self._rest

    def at(self, near: Start, p: Floats, *, slack: bool) -> Start | None:
        """The shape at rest with these parameters, followed from a neighbouring one; algebraic unknowns as there."""
        if not self._complete:
            return None
        x, z = self._rest.start.copy(), np.zeros(self._rest.z.numel())
        x[self._plastic[0]] = near.x[self._plastic[1]]
        z[self._moving[0]], z[self._still[0]] = near.x[self._moving[1]], near.z[self._still[1]]
        values = dict(zip(self._graph.parameters, p.tolist(), strict=True))
        if not slack:
            # A taut filament starts without its weight.
            values["gravity"] = 0.0
        constants = np.array([values[name] for name in self._rest.parameters])
        shape = self._equilibrium.search(0.0, x, constants, [z])
        if shape is None:
            return None
        result = Start(near.x.copy(), near.z.copy())
        result.x[self._moving[1]], result.z[self._still[1]] = shape[self._moving[0]], shape[self._still[0]]
        return result


def _numbered(kinds: tuple[str, ...], places: tuple[int, ...]) -> dict[_Unknown, int]:
    return {unknown: number for number, unknown in enumerate(zip(kinds, places, strict=True))}


def _pairs(
    ours: dict[_Unknown, int], theirs: dict[_Unknown, int]
) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    both = [(number, theirs[unknown]) for unknown, number in ours.items() if unknown in theirs]
    return np.array([a for a, _ in both], dtype=np.int64), np.array([b for _, b in both], dtype=np.int64)
