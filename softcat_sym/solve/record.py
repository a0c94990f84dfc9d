"""Frames that an integration has reached so far."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from softcat_sym.graph.grid import Floats
from softcat_sym.solve.outcome import Outcome
from softcat_sym.solve.solution import Solution

POWERS = 3
"""Quadratures: plastic work, work of the changing load, work against the necking gradient."""


@dataclass(frozen=True)
class Reached:
    """Where an integration stands, and how it got there; the first frame is its start.

    Attributes
    ----------
    x, z, quad : ndarray, shapes (nx, frames), (nz, frames), (3, frames)
        Differential and algebraic states, and quadratures.
    steps : int
        Taken so far.
    """

    x: Floats
    z: Floats
    quad: Floats
    steps: int

    @property
    def frames(self) -> int:
        """How many there are."""
        return int(self.x.shape[1])


def at_start(x: Floats, z: Floats) -> Reached:
    """The first frame.

    Parameters
    ----------
    x, z : ndarray, shapes (nx,), (nz,)
        States.
    """
    return Reached(x[:, None], z[:, None], np.zeros((POWERS, 1)), 0)


@dataclass(frozen=True)
class State:
    """Where an integration stands at one output time."""

    x: Floats
    z: Floats
    quad: Floats


class Record:
    """Frames gathered so far.

    Parameters
    ----------
    first : Reached
        Where it begins.
    """

    def __init__(self, first: Reached) -> None:
        self._x, self._z, self._quad = [first.x], [first.z], [first.quad]
        self.reached, self.steps, self.last_steps = first.frames - 1, first.steps, 0

    @property
    def last(self) -> State:
        """The last frame."""
        return State(self._x[-1][:, -1], self._z[-1][:, -1], self._quad[-1][:, -1])

    def extend(self, x: Floats, z: Floats, quad: Floats, steps: int) -> None:
        """Add frames as columns."""
        self._x.append(x)
        self._z.append(z)
        self._quad.append(quad)
        self.reached += x.shape[1]
        self.steps += steps
        self.last_steps = steps

    def so_far(self, frames: int) -> Reached:
        """All frames; the last chunk may overshoot the run: whatever lies beyond `frames` is dropped."""
        x, z, quad = (np.concatenate(parts, axis=1)[:, :frames] for parts in (self._x, self._z, self._quad))
        return Reached(x, z, quad, self.steps)

    def solution(self, interval: float, frames: int, outcome: Outcome, complaint: str) -> Solution:
        """The answer, with `frames` output times `interval` apart."""
        found = self.so_far(frames)
        time = np.arange(found.frames, dtype=float) * interval
        return Solution(time, found.x, found.z, found.quad, outcome, complaint, found.steps)
