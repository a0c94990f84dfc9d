"""The solution of an integration, and receivers of its progress."""

from __future__ import annotations

import math
import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, nullcontext
from dataclasses import dataclass, replace
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.estimates.expected_regime import worst_gravity_number
from softcat_sym.estimates.scaling import initial_strain
from softcat_sym.interrupts import Interrupts, interrupts_go_to
from softcat_sym.physics import beams
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene, force_free_stretch, is_held, rest_length
from softcat_sym.scene.tables import farthest
from softcat_sym.solvers.outcome import POLYMER_THREAD, THREAD, Outcome


class Progress(Protocol):
    """Receiver of the progress of a run, with its estimates and refinements."""

    def stage(self, name: str) -> None:
        """Receive the name of a stage that begins, such as an estimate or a refinement."""
        ...

    def doing(self, what: str) -> None:
        """Receive the part of the stage that begins: building, compiling, solving."""
        ...

    def reach(self, share: float, state: str) -> None:
        """Receive the finished share of the stage, 0 to 1, and its state in words."""
        ...

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Receive the time reached [s] and the mean step since the last call [s]."""
        ...


class Silence:
    """A receiver that ignores all reports; subclasses implement those that they need."""

    def stage(self, name: str) -> None:
        """Do nothing."""

    def doing(self, what: str) -> None:
        """Do nothing."""

    def reach(self, share: float, state: str) -> None:
        """Do nothing."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Do nothing."""


def counting(progress: Progress, stage: str) -> Callable[[int, int], None]:
    """Begin a stage with several parts; return a function that reports the number of finished parts."""
    progress.stage(stage)
    return lambda done, total: progress.reach(done / total, f"{done + 1} of {total}")


@dataclass(frozen=True)
class Start:
    """Differential and algebraic states at t = 0."""

    x: Floats
    z: Floats


Newton = Callable[[Graph, Floats, Floats, Floats], Floats | None]
"""Algebraic unknowns in balance at t = 0, from a graph, its differential unknowns, parameters and a guess."""


def with_plastic_strain(x: Floats, graph: Graph, scene: Scene, share: float) -> Floats:
    """The state with a share of the scene's initial plastic strain."""
    where = graph.differential.where
    # Values are equally spaced from left to right; a single value holds for the whole filament.
    mean, bending = (
        np.interp(where, np.linspace(-0.5, 0.5, len(values)), values) if values else np.zeros(len(where))
        for values in (initial_strain(scene), scene.initial.C)
    )
    mean = mean + math.log(force_free_stretch(scene))
    result = np.array(x, dtype=float)
    kinds = np.array(graph.differential.kinds)
    for kind, weight in graph.profiles.items():
        here = kinds == kind
        result[here] = share * (weight[0] * mean[here] + weight[1] * bending[here])
    return result


Stretch = Callable[[Floats, Floats, Floats], Floats]
"""Stretch (frames, cells) at times (frames,) of unknowns in columns (nx, frames), (nz, frames)."""


def thread_of(terms: Terms) -> float:
    """Stretch at which the run of a filament with this law ends."""
    return POLYMER_THREAD if terms.law.spec.has_chains else THREAD


def is_torn(terms: Terms, stretch: Floats) -> bool:
    """Whether a section is stretched to a thread, whose further motion takes very many steps and has no meaning."""
    return bool(np.any(stretch > thread_of(terms)))


@dataclass(frozen=True, slots=True)
class Extremes:
    """Heights of the midpoint between which it only rises or only falls: the first, its turning points, the last."""

    time: Floats
    height: Floats
    area: Floats  # Integral of the height over the time up to then

    @classmethod
    def of(cls, time: Floats, height: Floats) -> Extremes:
        """Those of frames, which show no more of them than they are many."""
        return cls(time, height, np.append(0.0, np.cumsum(np.diff(time) * (height[1:] + height[:-1]) / 2)))

    def scaled(self, time: float, length: float) -> Extremes:
        """The same in other units."""
        return Extremes(self.time * time, self.height * length, self.area * time * length)

    def followed_by(self, later: Extremes) -> Extremes:
        """These and those of what follows, whose integral begins anew."""
        parts = ((getattr(self, name), getattr(later, name)) for name in ("time", "height"))
        time, height = (np.append(*pair) for pair in parts)
        return Extremes(time, height, np.append(self.area, self.area[-1] + later.area)).beyond(0.0)

    def beyond(self, least: float) -> Extremes:
        """Without swings of this size and smaller ones."""
        height, kept = self.height, [0]
        for number in range(1, len(height)):
            here, last = height[number], height[kept[-1]]
            before = height[kept[-2]] if len(kept) > 1 else last
            if (here - last) * (last - before) > 0:
                kept[-1] = number  # still on the same way
            elif abs(here - last) > least:
                kept.append(number)
        if kept[-1] != len(height) - 1:
            kept[1 if len(kept) == 1 else -1 :] = [len(height) - 1]
        return Extremes(self.time[kept], height[kept], self.area[kept])


@dataclass(frozen=True)
class Bounds:
    """Where a run ends as one that does not come to rest any more."""

    distance: float  # Largest coordinate of a node over the rest length, from the middle of the straight filament
    stretch: Floats  # Of each cell; infinite without a yield stress
    length: float  # Rest length [m]
    never: bool  # Whether it would not have come to rest from the beginning


FALLEN = 10.0
"""Sag at which a filament between supports falls for ever, over its span or its rest length, whichever is longer.

It is then a thread of twenty times its length. The deepest bundled scene, drawn apart meanwhile, sags by 1.4 spans.
"""

DRAWN = 100.0
"""Stretch below which a section counts as not drawn out yet, though it does not come to rest.

At rest the section at X bears the weight between it and midspan at no more than the yield stress, so that its stretch
is at most sigma_Y/(rho g |X|), and what tension has drawn out it never shortens: a section beyond that limit, and a
tenth as thick as it was, is on its way to a thread. Where no catenary rests (3.12), the filament falls for ever;
elsewhere it has necked.
"""


def bounds_of(scene: Scene, terms: Terms, nodes: Floats) -> Bounds | None:
    """Where the run of a filament with nodes at these X/L ends; None where nothing says that it falls or necks.

    What has a free end hangs on one support and is drawn out by its own weight as far as its law allows: its run ends
    as a thread. Solids come to rest, and chains of polymers may hold what they are drawn to.
    """
    if scene.model != "filament" or not is_held(scene) or scene.material.spec.is_solid or terms.law.spec.has_chains:
        return None
    if not (terms.flows or terms.viscous):
        return None
    longest = max(scene.filament.span, rest_length(scene), farthest(scene))
    weight = worst_gravity_number(scene.at(scene.run.duration)) if terms.yields else None
    stretch = np.full(len(nodes) - 1, np.inf)
    # Of supports that move it is not known which of them draws a section out.
    if weight and not scene.ends.motion:
        stretch = np.maximum(DRAWN, 1 / (weight * np.maximum(np.abs(nodes[1:] + nodes[:-1]) / 2, 1e-9)))
    falls = weight is None or weight > beams.ARREST_THRESHOLD_EXACT
    return Bounds(FALLEN * longest / rest_length(scene), stretch, rest_length(scene), falls)


class Later(Protocol):
    """Frames behind those that were integrated, computed when they are asked for."""

    def row(self, number: int) -> Floats:
        """One unknown in all of them, differential ones first."""
        ...

    def at(self, frames: npt.NDArray[np.int64]) -> tuple[Floats, Floats, Floats]:
        """Differential and algebraic unknowns and quadratures in some of them, in columns."""
        ...


@dataclass(frozen=True)
class Solution:
    """States at the output times that were reached, in columns."""

    time: Floats  # shape (frames,), in units of the time scale; shorter than requested if the integration failed
    x: Floats  # Differential states, of the frames before `later`
    z: Floats  # Algebraic states
    quad: Floats  # Quadratures, shape (powers, frames)
    outcome: Outcome
    message: str  # Time, worst component and message of the integrator, if it failed
    steps: int
    ended: float | None = None  # Time at which it was left to fall for ever
    extremes: Extremes | None = None  # Of the midpoint over the rest length; None of a sequence of equilibria
    later: Later | None = None  # The frames of the modal tail
    tail_from: float | None = None  # Time from which it is
    tail_error: float = 0.0  # That it adds to the error, relative to the largest displacement

    @classmethod
    def at(cls, x: Floats, z: Floats, powers: int) -> Solution:
        """The first frame of an integration, at time zero."""
        return cls(np.zeros(1), x[:, None], z[:, None], np.zeros((powers, 1)), Outcome.solved, "", 0)

    def row(self, number: int) -> Floats:
        """One unknown in all frames, differential ones first."""
        moving = len(self.x)
        known = np.asarray(self.x[number] if number < moving else self.z[number - moving], dtype=float)
        return known if self.later is None else np.append(known, self.later.row(number))

    @property
    def whole(self) -> Solution:
        """The solution with the columns of all its frames."""
        return self if self.later is None else self.only(slice(None))

    @classmethod
    def joined(cls, parts: Sequence[Solution]) -> Solution:
        """Parts joined in time, with the outcome of the last one."""
        time, x, z, quad = (
            np.concatenate([getattr(part, name) for part in parts], axis=-1) for name in ("time", "x", "z", "quad")
        )
        return replace(parts[-1], time=time, x=x, z=z, quad=quad, steps=sum(part.steps for part in parts))

    def left(self, ended: float, scale: float, *, falls: bool) -> Solution:
        """The solution before the time from which the filament falls for ever, or is drawn out where it necks."""
        found = self.only(slice(0, max(1, int(np.count_nonzero(self.time <= ended)))))
        what = "it falls for ever" if falls else "a section is drawn out, and cannot bear what hangs on it any more"
        message = f"{what}: the run ends after {ended * scale:.4g} s"
        if falls:
            return replace(found, outcome=Outcome.descends, message=message, ended=ended)
        return replace(found, outcome=Outcome.ruptured, message=message)

    def interrupted(self, scale: float) -> Interrupted:
        """What to raise after Ctrl-C, with the solution up to then."""
        message = f"it was interrupted after {self.time[-1] * scale:.4g} s"
        part = replace(self, outcome=Outcome.interrupted, message=message)
        return Interrupted(lambda: part)

    def integrated(self, scale: float) -> Solution:
        """What was integrated, as the part of a run that was interrupted before its modal tail was known."""
        time = self.time[: self.x.shape[1]]
        message = f"it was interrupted after {time[-1] * scale:.4g} s, before the rest of its ringing was computed"
        part = replace(self, time=time, later=None, extremes=None, tail_from=None, tail_error=0.0)
        return replace(part, outcome=Outcome.interrupted, message=message)

    def only(self, frames: slice | list[int]) -> Solution:
        """The solution at some of its frames."""
        parts = self.x, self.z, self.quad
        if self.later is None:
            x, z, quad = (part[:, frames] for part in parts)
        else:
            chosen, known = np.arange(len(self.time))[frames], self.x.shape[1]
            more = self.later.at(chosen[chosen >= known] - known)
            x, z, quad = (np.hstack([a[:, chosen[chosen < known]], b]) for a, b in zip(parts, more, strict=True))
        return replace(self, time=self.time[frames], x=x, z=z, quad=quad, later=None)

    def every(self, stride: int, time: Floats) -> Solution:
        """The solution at every `stride`-th frame, with the times of `time`."""
        found = self if stride == 1 else self.only(slice(None, None, stride))
        return replace(found, time=time[: len(found.time)])

    def to_rupture(self, terms: Terms, stretch: Stretch, scale: float) -> Solution:
        """The solution up to the first frame with a section stretched to a thread, if the last frame has one."""

        def torn(frame: int) -> bool:
            at = slice(frame, frame + 1)
            return frame > 0 and is_torn(terms, stretch(self.time[at], self.x[:, at], self.z[:, at]))

        frames = len(self.time)
        if not torn(frames - 1):
            return self
        while torn(frames - 2):
            frames -= 1
        message = (
            f"stopped after t = {self.time[frames - 1] * scale:.6g} s: a cell is drawn to {thread_of(terms):g} times "
            "its length"
        )
        return replace(self.only(slice(frames)), outcome=Outcome.ruptured, message=message)


class Interrupted(KeyboardInterrupt):
    """Ctrl-C during a computation; `part` returns what was computed until then."""

    def __init__(self, part: Callable[[], Any]) -> None:
        super().__init__()
        self.part = part


@contextmanager
def watched() -> Iterator[Interrupts]:
    """Watch for SIGINT, unless the program has its own handler or this is not its main thread.

    At the end KeyboardInterrupt is raised if it was swallowed. A nested watch is the outer one.
    """
    around = getattr(signal.getsignal(signal.SIGINT), "__self__", None)
    nested = isinstance(around, Interrupts)
    interrupts = around if isinstance(around, Interrupts) else Interrupts()
    with nullcontext() if nested else interrupts_go_to(interrupts.note):
        try:
            yield interrupts
        except KeyboardInterrupt:
            raise
        except BaseException:
            interrupts.check()
            raise
        interrupts.check()
