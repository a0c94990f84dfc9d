"""Planes of dimensionless groups, and the runs behind a phase diagram, refined only along its boundaries."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, fields, replace
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym.batch.executor import MembersProgress, RunPool
from softcat_sym.batch.members import Member, Row
from softcat_sym.batch.records import Batch, Column, Record, unpacked
from softcat_sym.batch.worker import MemberRun, RowWork, shared_by
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.scaling_estimates import buoyant_share, pull_of_surface
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME
from softcat_sym.scene.scene import Scene, gravity_time, groups_of, is_held, is_slack, rest_length
from softcat_sym.simulate import identity_of
from softcat_sym.store import key_of

MIN_RESOLUTION, MAX_RESOLUTION = 4, 640

ELASTIC_TIME: Final = 4.0
"""Minimum time of a run in sqrt(L/g), after the ramp of gravity.

In this time an elastic filament of the paper's modulus oscillates at least four times, and an undamped fall past the
catenary, which takes half a period pi sqrt(G/10), has turned back.
"""

ARREST_FLOW_TIME: Final = 4.0
"""Time in eta/sigma_Y after which an arrest shows: overstress relaxes, and hinges rotate, in a time eta/sigma_Y."""

WEIGHT_TIME: Final = 1.0
"""Maximum time in eta/(rho g L), in which the stress rho g L causes a strain of one: a catenary without arrest has
fallen by some 0.4 L by then, and soon after it is drawn out at its clamps."""


@dataclass(frozen=True, slots=True)
class PhaseAxis:
    """One group, in equal steps of its logarithm."""

    key: str  # ``"G"``, ``"V"`` or ``"delta"``
    low: float  # Ends of the axis
    high: float

    def values(self, cells: int) -> Floats:
        """Lattice values, shape (cells + 1,)."""
        return np.geomspace(self.low, self.high, cells + 1)


@dataclass(frozen=True, slots=True)
class PhasePlane:
    """Two groups that vary, the third as in the scene."""

    name: str  # Name for users
    x: PhaseAxis  # Horizontal axis, G, and vertical axis, the other group
    y: PhaseAxis


GRAVITY = PhaseAxis("G", 0.01, 3.0)
PLANES: dict[str, PhasePlane] = {
    "G-delta": PhasePlane("G-delta", GRAVITY, PhaseAxis("delta", 0.01, 0.1)),
    "G-V": PhasePlane("G-V", GRAVITY, PhaseAxis("V", 0.1, 100.0)),
}


@dataclass(frozen=True, slots=True)
class Place:
    """Groups of one filament (3.9, 3.10)."""

    G: float
    V: float
    delta: float


def planes_of(names: Sequence[str]) -> tuple[PhasePlane, ...]:
    """The planes of these names."""
    unknown = [name for name in names if name not in PLANES]
    if unknown or not names:
        raise SoftcatError(f"no phase plane {', '.join(unknown) or 'named'}; accepted: {', '.join(PLANES)}")
    return tuple(PLANES[name] for name in dict.fromkeys(names))


def checked_resolution(resolution: int) -> int:
    """Return a valid number of cells along an axis; raise an error for others."""
    if isinstance(resolution, bool) or not isinstance(resolution, int):
        raise SoftcatError(f"resolution = {resolution!r}: a whole number of cells along each axis")
    if not MIN_RESOLUTION <= resolution <= MAX_RESOLUTION:
        raise SoftcatError(f"resolution = {resolution}: accepted: {MIN_RESOLUTION} to {MAX_RESOLUTION} cells")
    return resolution


def refuse_scene(scene: Scene) -> None:
    """Refuse a filament whose regimes do not depend on G, V and delta alone."""
    faults = []
    if scene.material.law != "bingham":
        faults.append(Fault("material.law", f"{scene.material.law!r} has no regimes by G and V", '"bingham"'))
    if scene.load.gravity == 0:
        faults.append(Fault("load.gravity", "zero, but the groups are measured by it", "a positive gravity"))
    if scene.load.shake > 0:
        faults.append(Fault("load.shake", "shaken gravity has other regimes", "0"))
    if not is_held(scene) or is_slack(scene):
        faults.append(Fault("ends", "the filament is not held straight at both ends", "both ends held, no slack"))
    if scene.ends.motion or scene.ends.drop != 0:
        faults.append(Fault("ends", "a support moves or is lowered", "two level supports at rest"))
    for path, there, what, accepted in (
        ("load.point_mass", scene.load.point_mass > 0, "a weight at midspan", "0"),
        ("surroundings.surface_tension", pull_of_surface(scene) > 0, "the pull of a surface", "0"),
        ("surroundings.density", buoyant_share(scene) > 0, "buoyancy in a bath", "0"),
        ("temperature", scene.temperature.present, "a temperature", "leaving it out"),
        ("material.structure", scene.material.structure is not None, "a structure", "leaving it out"),
        ("material.hardening_modulus", scene.material.hardening_modulus is not None, "hardening", "leaving it out"),
        ("material", bool(scene.material.histories()), "a change in time", "constants"),
    ):
        if there:
            faults.append(Fault(path, f"{what} is no part of the groups", accepted))
    if faults:
        raise SceneError(faults, "of a phase diagram")


def place_at(scene: Scene, plane: PhasePlane, x: float, y: float) -> Place:
    """The groups at a point of a plane; the third group is the scene's."""
    groups = groups_of(scene)
    if groups.G is None or groups.V is None:
        raise SceneError([Fault("material", "neither G nor V", "a yield stress and a viscosity")], "of a phase diagram")
    held = {"G": groups.G, "V": groups.V, "delta": groups.delta} | {plane.x.key: x, plane.y.key: y}
    return Place(**held)


def duration_at(scene: Scene, place: Place) -> float:
    """Duration of a run [s], long enough to show whether the filament stops.

    It is the ramp, `ELASTIC_TIME`, and for the flow the shorter of `ARREST_FLOW_TIME` and `WEIGHT_TIME`.
    """
    flow = place.V * min(WEIGHT_TIME, ARREST_FLOW_TIME * place.G)
    return scene.load.ramp + (ELASTIC_TIME + flow) * gravity_time(scene)


def row_of(scene: Scene, place: Place, duration: float) -> Row:
    """Changes of the scene for the filament at a point, as a row of :func:`softcat_sym.simulate_many`."""
    delta: Row = {} if place.delta == groups_of(scene).delta else {"groups.delta": place.delta}
    return delta | {"groups.G": place.G, "groups.V": place.V, "run.duration": duration}


Node = tuple[int, int]
Label = Callable[[Sequence[Node]], Sequence[str]]

COARSEST = 8
"""Smallest initial number of squares along an axis: regions smaller than such a square may be missed."""


@dataclass(frozen=True, slots=True)
class Square:
    """Lower left node and width, in lattice steps."""

    i: int
    j: int
    width: int

    def corners(self) -> tuple[Node, Node, Node, Node]:
        """Its four nodes."""
        i, j, w = self.i, self.j, self.width
        return (i, j), (i + w, j), (i, j + w), (i + w, j + w)

    def quarters(self) -> tuple[Square, ...]:
        """Four squares of half the width."""
        half = self.width // 2
        return tuple(Square(i, j, half) for i in (self.i, self.i + half) for j in (self.j, self.j + half))


@dataclass(frozen=True)
class RefinedLattice:
    """Labels of a lattice."""

    cells: int  # Lattice squares along each axis
    known: dict[Node, str]  # Labels that were computed
    squares: tuple[Square, ...]  # Squares that tile the plane: one step wide where corners differ, wider elsewhere

    @property
    def saved(self) -> int:
        """Number of nodes whose label was never computed."""
        return (self.cells + 1) ** 2 - len(self.known)

    def labels(self) -> npt.NDArray[np.str_]:
        """The label of every node, shape (cells + 1, cells + 1); a wide square has the label of its corners."""
        longest = max(map(len, self.known.values()))
        filled = np.zeros((self.cells + 1, self.cells + 1), dtype=f"<U{longest}")
        for square in self.squares:
            if square.width > 1:
                i, j, w = square.i, square.j, square.width
                filled[i : i + w + 1, j : j + w + 1] = self.known[square.corners()[0]]
        for node, label in self.known.items():
            filled[node] = label
        return filled


def coarse_width(cells: int) -> int:
    """Width of the first squares in lattice steps: the largest power of two that leaves `COARSEST` along an axis."""
    width = 1
    while cells % (2 * width) == 0 and cells // (2 * width) >= COARSEST:
        width *= 2
    return width


def refined(cells: int, label: Label) -> RefinedLattice:
    """Label a lattice, refined only along the boundaries between labels.

    Every square in which two known labels differ, its edges included, is divided in four, down to one lattice step.
    """
    width = coarse_width(cells)
    squares = [Square(i, j, width) for i in range(0, cells, width) for j in range(0, cells, width)]
    known: dict[Node, str] = {}
    _ask(squares, known, label)
    while True:
        cut = [square for square in squares if square.width > 1 and _differs(square, known)]
        if not cut:
            return RefinedLattice(cells, known, tuple(squares))
        quarters = [quarter for square in cut for quarter in square.quarters()]
        gone = set(cut)
        squares = [square for square in squares if square not in gone] + quarters
        _ask(quarters, known, label)


def _ask(squares: Sequence[Square], known: dict[Node, str], label: Label) -> None:
    nodes = sorted({node for square in squares for node in square.corners()} - known.keys())
    if nodes:
        known.update(zip(nodes, label(nodes), strict=True))


def _differs(square: Square, known: dict[Node, str]) -> bool:
    """Whether two known nodes of a square differ; known nodes on its edges may come from finer neighbours."""
    i, j, w = square.i, square.j, square.width
    nodes = ((i + a, j + b) for a in range(w + 1) for b in range(w + 1))
    return len({known[node] for node in nodes if node in known}) > 1


PASSED = 0.5
"""Sag over span beyond which no catenary is in equilibrium: that of the smallest stress sags by 0.338 (3.12, exact)."""

CLAMP_REGION = 0.1
"""Share of the span next to each end that counts as the clamp's region; hinges are much shorter."""

DESCENDING = "descending"

CLAMPS_ONLY = "descending-at-clamps"
"""Mark of a descending filament that is arrested further than `CLAMP_REGION` from the ends."""

_CHUNK = 16
"""Number of filaments that a worker of a cluster receives together: some tenths of a second."""


@dataclass(frozen=True)
class PhaseRun:
    """One filament."""

    place: Place  # Its groups
    regime: str = ""  # Regime of the run; empty if the run is no answer
    outcome: str = ""  # Name of the outcome: of the run that gave the regime, or of the one that failed
    message: str = ""  # Why a run is no answer
    duration: float = math.nan  # Of the run that gave the regime [s]
    # Duration [s] of a longer run that was no answer, if the run that gave the regime ends as its sag passes `PASSED`;
    # else zero.
    drawn_out: float = 0.0
    runs: int = 1  # Number of runs, 1 or 2
    sag: float = math.nan  # Of the midpoint at the end, over the span
    # Largest plastic rate in the last tenth of the run over sigma_Y/eta: of all fibres, and of those further than
    # `CLAMP_REGION` from the ends.
    rate: float = math.nan
    span_rate: float = math.nan
    # True axial strain at the end of the run in the cells at a clamp and at midspan: of the most stretched fibre (2.6,
    # objective form), and of the centreline.
    clamp_strain: float = math.nan
    clamp_strain_centreline: float = math.nan
    midspan_strain: float = math.nan
    midspan_strain_centreline: float = math.nan
    steps: int = 0  # Time steps of all runs

    @property
    def mark(self) -> str:
        """The regime, or the name of the outcome without one; `CLAMPS_ONLY` is a part of the descending regime."""
        if self.regime == DESCENDING and self.span_rate < ARREST_RATE:
            return CLAMPS_ONLY
        return self.regime or self.outcome

    def to_dict(self) -> dict[str, Any]:
        """A row of the table of runs."""
        row = {**asdict(self.place), "regime": self.regime, "outcome": self.outcome, "mark": self.mark}
        row |= {"duration_s": self.duration, "drawn_out_within_s": self.drawn_out or None, "sag_over_span": self.sag}
        others = "rate span_rate clamp_strain clamp_strain_centreline midspan_strain midspan_strain_centreline"
        return row | {name: getattr(self, name) for name in (*others.split(), "steps", "runs", "message")}


_TYPES = {"str": str, "int": int, "float": float}
_COLUMNS = {field.name: Column("", "", dtype=_TYPES[str(field.type)]) for field in fields(PhaseRun)[1:]}


def run_places(
    scene: Scene,
    places: Sequence[Place],
    pool: RunPool,
    progress: MembersProgress | None = None,
    durations: Sequence[float] | None = None,
) -> list[PhaseRun]:
    """Run one filament for each place, finished ones from the store."""
    lasting = durations or [duration_at(scene, place) for place in places]
    rows = [row_of(scene, place, duration) for place, duration in zip(places, lasting, strict=True)]
    identity = identity_of(scene)
    batch = Batch(
        len(rows), 1, lambda number: rows[number : number + 1], lambda row: key_of("phase", identity, row), _COLUMNS, {}
    )
    found = dict(batch.recalled())
    missing = [number for number in range(len(rows)) if number not in found]
    shared_by(scene)  # Made once, before threads use it
    found.update(batch.run(missing, PhaseWork(scene, pool.stop), pool, _CHUNK, progress))
    runs = []
    for number, place in enumerate(places):
        record = unpacked(found[number])[0]
        runs.append(PhaseRun(place, **{name: record[name].item() for name in _COLUMNS}))
    return runs


@dataclass(frozen=True)
class PhaseWork(RowWork):
    """Runs the filament at a point for a time."""

    def observe(self, member: Member) -> Record:
        """Run the filament; if the run is no answer, repeat it up to the time at which the sag passes `PASSED`.

        A filament that descends without arrest is drawn out in the end, so that its run is no answer; the shorter run
        is one.
        """
        first, sag = self._observed(member)
        passed = np.flatnonzero(sag > PASSED)
        if first["regime"] or not len(passed):
            return first
        scene = member.scene
        short = first["duration"] * float(passed[0]) / (scene.run.frames - 1)
        second, _ = self._observed(_lasting(member, short))
        both = {"runs": 2, "steps": first["steps"] + second["steps"]}
        if second["regime"] != DESCENDING:
            return first | both
        return second | both | {"drawn_out": scene.run.duration}

    def _observed(self, member: Member) -> tuple[dict[str, Any], Floats]:
        """A run, and its sag over the span, shape (frames,)."""
        run = self.run(member)
        if run.solution.ended is not None:
            # It falls for ever, perhaps before its second frame: again, with its frames up to then.
            member = _lasting(member, run.solution.ended * run.prepared.scale)
            run = replace(self.run(member), outcome=run.outcome, message=run.message)
        sag = -run.midpoint / rest_length(member.scene)
        rate, span_rate = _rates(run)
        record = {
            "regime": run.regime,
            "outcome": run.outcome.name,
            "message": run.message,
            "duration": member.scene.run.duration,
            "drawn_out": 0.0,
            "runs": 1,
            "sag": float(sag[-1]),
            "rate": rate,
            "span_rate": span_rate,
            **_strains("clamp", run.fields, 0),
            **_strains("midspan", run.fields, run.fields["stretch"].shape[1] // 2),
            "steps": run.solution.steps,
        }
        return record, sag


def _lasting(member: Member, duration: float) -> Member:
    """The member with another duration [s]."""
    run = member.scene.run.model_copy(update={"duration": duration})
    return replace(member, scene=member.scene.model_copy(update={"run": run}))


def _rates(run: MemberRun) -> tuple[float, float]:
    """Largest plastic rate of the last tenth over sigma_Y/eta: everywhere, and away from the ends."""
    material, rate = run.member.scene.material, run.fields["plastic_rate"]
    pace = (material.yield_stress or 0.0) / (material.viscosity or np.inf)
    if not pace:
        return 0.0, 0.0
    last = rate[min(len(rate) - 1, int((1 - ARREST_TIME) * (len(rate) - 1))) :]
    away = np.abs(run.cells) < (0.5 - CLAMP_REGION) * rest_length(run.member.scene)
    return float(np.max(last)) / pace, float(np.max(last[:, away])) / pace


def _strains(place: str, fields: dict[str, Floats], cell: int) -> dict[str, float]:
    """Strain in the last frame, eps = log s - theta_s z, in the outer fibres of the present thickness."""
    stretch, curvature, thickness = (float(fields[name][-1, cell]) for name in ("stretch", "curvature", "thickness"))
    centreline = float(np.log(stretch))
    largest = centreline + abs(curvature) * thickness / 2
    return {f"{place}_strain": largest, f"{place}_strain_centreline": centreline}
