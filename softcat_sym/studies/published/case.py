"""Published cases, their results, and the runs of their filaments."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import cache
from importlib.resources import as_file, files

import numpy as np
import numpy.typing as npt

from softcat_sym.batch.lane_pool import Stop
from softcat_sym.batch.members import members_of
from softcat_sym.batch.worker import MemberRun, StructureCache, judged
from softcat_sym.errors import SoftcatError
from softcat_sym.results.run import Run
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.simulate import simulated

Floats = npt.NDArray[np.float64]


class DataKind(StrEnum):
    """Kind of data with which a case is compared."""

    MEASURED = "measured"
    COMPUTED = "computed by others"
    ASSUMED = "assumed, not predicted"


@dataclass(frozen=True)
class PublishedValue:
    """One number that others have published, and ours."""

    quantity: str
    unit: str  # Empty of a pure number
    published: float
    ours: float
    band: tuple[float, float] | None = None  # Range that the source states
    # Whether the difference is given in the unit, as for a temperature, instead of relative to the published number.
    is_absolute: bool = False

    @property
    def difference(self) -> float:
        """Our number minus the published one, in its unit or relative to it."""
        apart = self.ours - self.published
        return apart if self.is_absolute else apart / abs(self.published)

    @property
    def agrees(self) -> bool | None:
        """Whether our number lies in the published range; None if there is none."""
        return None if self.band is None else self.band[0] <= self.ours <= self.band[1]


@dataclass(frozen=True)
class CaseCurve:
    """A line, or points where it `is_published`, of a case's picture."""

    label: str
    x: Sequence[float]
    y: Sequence[float]
    is_published: bool = False


@dataclass(frozen=True)
class CasePicture:
    """Content of a case's picture."""

    x: str
    y: str
    curves: tuple[CaseCurve, ...]
    is_log_x: bool = False
    is_log_y: bool = False
    published_x: float | None = None  # Published values, drawn as a vertical or a horizontal line
    published_y: float | None = None


@dataclass(frozen=True)
class Finding:
    """Results of the runs of a case."""

    rows: tuple[PublishedValue, ...]
    picture: CasePicture | None = None


@dataclass(frozen=True)
class Case:
    """A published case."""

    name: str  # Name of the case for the command
    title: str  # Subject
    source: str  # Publication
    kind: DataKind  # Kind of the published data
    stated: str  # Statement of the source, and where it was read
    independent: str = ""  # Parts of the comparison that are independent of this package
    explains: str = ""  # Possible explanation of a difference
    run: Callable[[], Finding] | None = None  # None if the case cannot be run yet
    scenes: Sequence[str] = ()  # Names of its scenes
    needs: str = ""  # A package of the extra ``peers`` that the case needs
    reason: str = ""  # Why the case is not run


@cache
def published_scene(name: str) -> Scene:
    """The scene of a case."""
    with as_file(files("softcat_sym.studies.published") / "scenes" / f"{name}.toml") as path:
        return load_scene(path)


def answer_of(scene: Scene) -> Run:
    """Run a scene; raise an error if the run is no answer."""
    run = simulated(scene)
    if not run.outcome.is_answer:
        raise SoftcatError(f"{scene.title}: {run.outcome.name}; {run.summary['message'] or run.outcome.value}")
    return run


def answers_of(scene: Scene, rows: Sequence[Mapping[str, object]]) -> Iterator[MemberRun]:
    """Run a scene for each row of changes with shared equations; raise an error if a run is no answer."""
    structures, stop = StructureCache(), Stop()
    for member in members_of(scene, [dict(row) for row in rows], "once"):
        run = judged(member, *structures.run(member, stop))
        if not run.outcome.is_answer:
            raise SoftcatError(f"{scene.title}: {run.outcome.name}; {run.message or run.outcome.value}")
        yield run
