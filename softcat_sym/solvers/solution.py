"""The raw answer of an integration, and who listens while it is made."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from types import FrameType
from typing import TYPE_CHECKING, Protocol, runtime_checkable

import numpy as np

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.interrupts import interrupts_go_to
from softcat_sym.physics.terms import Terms
from softcat_sym.solvers.outcome import POLYMER_THREAD, THREAD, Outcome

if TYPE_CHECKING:
    from softcat_sym.solvers.compiled import Answer, CModel, RunInput


class Progress(Protocol):
    """Listens to a run; one listener hears all of it, estimates and refinements included."""

    def stage(self, name: str) -> None:
        """Take note that something begins beside the first run: an estimate, a refinement."""
        ...

    def doing(self, what: str) -> None:
        """Take note of what begins within it: building, compiling, solving."""
        ...

    def reach(self, share: float, state: str) -> None:
        """Take note of how much of the stage is done, 0 to 1, and in words."""
        ...

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s] and of the mean step since the last call [s]."""
        ...


@runtime_checkable
class Flagged(Protocol):
    """A listener that sees to compiled integrations, and ends them: no thread need watch it."""

    def integrate(self, model: CModel, run: RunInput, room: Answer) -> None:
        """Integrate a run into its room."""
        ...


class Silence:
    """A listener that does nothing; one that derives from it need not hear everything."""

    def stage(self, name: str) -> None:
        """Do nothing."""

    def doing(self, what: str) -> None:
        """Do nothing."""

    def reach(self, share: float, state: str) -> None:
        """Do nothing."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Do nothing."""


def counting(progress: Progress, stage: str) -> Callable[[int, int], None]:
    """Begin a stage of so many parts, and hear how many of them are done."""
    progress.stage(stage)
    return lambda done, total: progress.reach(done / total, f"{done + 1} of {total}")


Stretch = Callable[[Floats, Floats, Floats], Floats]
"""Stretch (frames, cells) at times (frames,) of unknowns in columns (nx, frames), (nz, frames)."""


def thread_of(terms: Terms) -> float:
    """Stretch beyond which a filament of this law is followed no further."""
    return POLYMER_THREAD if terms.law.has_chains else THREAD


def is_torn(terms: Terms, stretch: Floats) -> bool:
    """Whether only a thread is left somewhere: what becomes of it may take a million steps, and means nothing."""
    return bool(np.any(stretch > thread_of(terms)))


@dataclass(frozen=True)
class Solution:
    """States at the output times that were reached, in columns."""

    time: Floats  # shape (frames,), in units of the time scale; shorter than requested if the integration failed
    x: Floats  # Differential states
    z: Floats  # Algebraic states
    quad: Floats  # Quadratures, shape (powers, frames)
    outcome: Outcome
    message: str  # Time, worst component and the integrator's words, if it failed
    steps: int

    @classmethod
    def at(cls, x: Floats, z: Floats, powers: int) -> Solution:
        """The frame from which an integration begins, at time zero."""
        return cls(np.zeros(1), x[:, None], z[:, None], np.zeros((powers, 1)), Outcome.solved, "", 0)

    @classmethod
    def joined(cls, parts: Sequence[Solution]) -> Solution:
        """Parts one behind the other, ended as the last one."""
        time, x, z, quad = (
            np.concatenate([getattr(part, name) for part in parts], axis=-1) for name in ("time", "x", "z", "quad")
        )
        return replace(parts[-1], time=time, x=x, z=z, quad=quad, steps=sum(part.steps for part in parts))

    def every(self, stride: int, time: Floats) -> Solution:
        """The same at every so many of its times, which become those of `time`."""
        x, z, quad = (part[:, ::stride] for part in (self.x, self.z, self.quad))
        return replace(self, time=time[: x.shape[1]], x=x, z=z, quad=quad)

    def to_rupture(self, terms: Terms, stretch: Stretch, scale: float) -> Solution:
        """The same up to the first frame in which only a thread is left somewhere, if the last one is such."""

        def torn(frame: int) -> bool:
            at = slice(frame, frame + 1)
            return frame > 0 and is_torn(terms, stretch(self.time[at], self.x[:, at], self.z[:, at]))

        frames = len(self.time)
        if not torn(frames - 1):
            return self
        while torn(frames - 2):
            frames -= 1
        time, x, z, quad = (part[..., :frames] for part in (self.time, self.x, self.z, self.quad))
        message = (
            f"stopped after t = {time[-1] * scale:.6g} s: a cell is drawn to {thread_of(terms):g} times its length"
        )
        return replace(self, time=time, x=x, z=z, quad=quad, outcome=Outcome.ruptured, message=message)


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
