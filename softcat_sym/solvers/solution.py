"""The raw answer of an integration, its frames so far, and what a run tells while it is being made."""

from __future__ import annotations

import ctypes
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from types import FrameType
from typing import Protocol, runtime_checkable

import numpy as np

from softcat_sym.discretization.grid import Floats
from softcat_sym.interrupts import interrupts_go_to
from softcat_sym.solvers.outcome import Outcome


class Progress(Protocol):
    """Listens to a run; one listener hears all of it, estimates and refinements included."""

    def stage(self, name: str) -> None:
        """Take note that something begins beside the first run: an estimate, a refinement."""
        ...

    def doing(self, what: str) -> None:
        """Take note of what begins within it: building, compiling, solving."""
        ...

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s] and of the mean step since the last call [s]."""
        ...


@runtime_checkable
class Flagged(Protocol):
    """A listener that ends integrations by a flag the compiled solver itself looks at: no thread need watch it."""

    @property
    def flag(self) -> ctypes.c_int:
        """Not zero once they are to end."""
        ...


class Silence:
    """Tells nobody; a listener that derives from it need not hear everything."""

    def stage(self, name: str) -> None:
        """Do nothing."""
        del name

    def doing(self, what: str) -> None:
        """Do nothing."""
        del what

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Do nothing."""
        del simulated_time, step_size


@dataclass(frozen=True)
class Solution:
    """States at the output times that were reached."""

    time: Floats  # shape (frames,); In units of the time scale; shorter than asked if the integration failed
    # Differential and algebraic states, and the quadratures (plastic work, work of the changing load, work against
    # the necking gradient).
    x: Floats
    z: Floats
    quad: Floats
    outcome: Outcome  # How it ended
    message: str  # Time, worst component and the integrator's words, if it failed
    steps: int  # Steps taken

    def every(self, stride: int, time: Floats) -> Solution:
        """The same at every so many of its times, called those of `time`."""
        x, z, quad = (part[:, ::stride] for part in (self.x, self.z, self.quad))
        return replace(self, time=time[: x.shape[1]], x=x, z=z, quad=quad)


class Interrupts:
    """Whether SIGINT has come since the watch began."""

    def __init__(self) -> None:
        self._noticed = False

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal: remember it, and raise as Python does."""
        del number, frame
        self._noticed = True
        raise KeyboardInterrupt

    def check(self) -> None:
        """Raise what was swallowed."""
        if self._noticed:
            raise KeyboardInterrupt


@contextmanager
def watched() -> Iterator[Interrupts]:
    """Watch for SIGINT, unless the program handles it in its own way or this is not its main thread.

    Within a watch it is that one.
    """
    around = getattr(signal.getsignal(signal.SIGINT), "__self__", None)
    if isinstance(around, Interrupts):
        yield around
        return
    interrupts = Interrupts()
    with interrupts_go_to(interrupts.note):
        yield interrupts


POWERS = 3
"""Quadratures: plastic work, work of the changing load, work against the necking gradient."""


@dataclass(frozen=True)
class State:
    """Where an integration stands at one output time."""

    x: Floats
    z: Floats
    quad: Floats


class Record:
    """Frames gathered so far."""

    def __init__(self, x: Floats, z: Floats) -> None:
        self._x, self._z, self._quad = [x[:, None]], [z[:, None]], [np.zeros((POWERS, 1))]
        self.reached = self.steps = self.last_steps = 0

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

    def solution(self, interval: float, frames: int, outcome: Outcome, message: str) -> Solution:
        """The answer, with output times `interval` apart; the last chunk may overshoot: only `frames` are kept."""
        x, z, quad = (np.concatenate(parts, axis=1)[:, :frames] for parts in (self._x, self._z, self._quad))
        return Solution(np.arange(x.shape[1], dtype=float) * interval, x, z, quad, outcome, message, self.steps)
