"""What a published case is, what is found of it, and how its filaments are run."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from importlib.resources import as_file, files

import numpy as np
import numpy.typing as npt

from softcat_sym.ensemble.ensemble import MemberRun, Workshop, judged
from softcat_sym.ensemble.executor import Stop
from softcat_sym.ensemble.members import members_of
from softcat_sym.errors import SoftcatError
from softcat_sym.results.run import Run
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import simulated

Floats = npt.NDArray[np.float64]


class Kind(StrEnum):
    """What a case is held against."""

    MEASURED = "measured"
    COMPUTED = "computed by others"
    ASSUMED = "assumed, not predicted"


@dataclass(frozen=True)
class Row:
    """One number that others have published, and ours.

    Attributes
    ----------
    quantity, unit : str
        What it is; an empty unit is none.
    published, ours : float
        The two numbers.
    band : (float, float) or None
        Between what the source has it; None where it says nothing of that.
    is_absolute : bool
        Whether the difference is told in the unit, as of a temperature, and not relative to what is published.
    """

    quantity: str
    unit: str
    published: float
    ours: float
    band: tuple[float, float] | None = None
    is_absolute: bool = False

    @property
    def difference(self) -> float:
        """Ours less the published, in its unit or relative to it."""
        apart = self.ours - self.published
        return apart if self.is_absolute else apart / abs(self.published)

    @property
    def agrees(self) -> bool | None:
        """Whether ours lies in the published band; None where there is none."""
        return None if self.band is None else self.band[0] <= self.ours <= self.band[1]


@dataclass(frozen=True)
class Curve:
    """A line, or points where it `is_published`, of a case's picture."""

    label: str
    x: Sequence[float]
    y: Sequence[float]
    is_published: bool = False


@dataclass(frozen=True)
class Picture:
    """What a case's picture shows."""

    x: str
    y: str
    curves: tuple[Curve, ...]
    is_log_x: bool = False
    is_log_y: bool = False
    published_x: float | None = None  # Where a line is drawn down, or across
    published_y: float | None = None


@dataclass(frozen=True)
class Finding:
    """What the runs of a case have come to."""

    rows: tuple[Row, ...]
    picture: Picture | None = None


@dataclass(frozen=True)
class Case:
    """A published case.

    Attributes
    ----------
    name : str
        By which the command is asked for it.
    title, source : str
        What it is about, and who published it.
    kind : Kind
        What ours is held against.
    stated : str
        What the source states, and where it was read.
    independent : str
        What of the comparison is not ours.
    explains : str
        What may explain a difference.
    run : callable or None
        Runs the package and returns what it finds; None where that cannot be done yet.
    scenes : tuple of str
        Names of its scenes.
    needs : str
        A package of the extra ``peers`` without which it cannot be run; empty if none.
    reason : str
        Why it is not run.
    """

    name: str
    title: str
    source: str
    kind: Kind
    stated: str
    independent: str = ""
    explains: str = ""
    run: Callable[[], Finding] | None = None
    scenes: tuple[str, ...] = ()
    needs: str = ""
    reason: str = ""


@cache
def published_scene(name: str) -> Scene:
    """The scene of a case."""
    with as_file(files("softcat_sym.studies.published") / "scenes" / f"{name}.toml") as path:
        return load_scene(path)


def answer_of(scene: Scene) -> Run:
    """A run that is an answer."""
    run = simulated(scene)
    if not run.outcome.is_answer:
        raise SoftcatError(f"{scene.title}: {run.outcome.name}; {run.summary['message'] or run.outcome.value}")
    return run


def answers_of(scene: Scene, rows: Sequence[Mapping[str, object]]) -> Iterator[MemberRun]:
    """Runs that are answers, one for each row of changes; they share their equations."""
    workshop, stop = Workshop(), Stop()
    for member in members_of(scene, [dict(row) for row in rows], "once"):
        run = judged(member, *workshop.run(member, stop))
        if not run.outcome.is_answer:
            raise SoftcatError(f"{scene.title}: {run.outcome.name}; {run.message or run.outcome.value}")
        yield run
