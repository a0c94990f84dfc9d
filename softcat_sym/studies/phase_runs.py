"""Runs behind a phase diagram: filaments by their groups, on a lattice that is refined along boundaries only."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, fields, replace
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt

from softcat_sym.batch.executor import MembersProgress, RunPool
from softcat_sym.batch.members import Member, Row
from softcat_sym.batch.records import Batch, Record, RecordColumn
from softcat_sym.batch.worker import MemberRun, RowWork, shared_by
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import Fault, SceneError
from softcat_sym.estimates.scaling import buoyant_share, pull_of_surface
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME
from softcat_sym.scene.scene import Scene, gravity_time, groups_of, is_held, is_slack, rest_length
from softcat_sym.simulate import identity_of
from softcat_sym.single_run import STEP_SIZE_OUTCOMES, TIGHTER, TRIES
from softcat_sym.store import key_of

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


class PhaseAxis(NamedTuple):
    """One group, in equal steps of its logarithm."""

    key: str  # ``"G"``, ``"V"`` or ``"delta"``
    low: float  # Ends of the axis
    high: float


class PhasePlane(NamedTuple):
    """Two groups that vary, the third as in the scene."""

    name: str  # Name for users
    x: PhaseAxis  # Horizontal axis, G, and vertical axis, the other group
    y: PhaseAxis


_GRAVITY = PhaseAxis("G", 0.01, 3.0)
PLANES: dict[str, PhasePlane] = {
    "G-delta": PhasePlane("G-delta", _GRAVITY, PhaseAxis("delta", 0.01, 0.1)),
    "G-V": PhasePlane("G-V", _GRAVITY, PhaseAxis("V", 0.1, 100.0)),
}


@dataclass(frozen=True, slots=True)
class Place:
    """Groups of one filament (3.9, 3.10)."""

    G: float
    V: float
    delta: float


def place_at(scene: Scene, plane: PhasePlane, x: float, y: float) -> Place:
    """The groups at a point of a plane; the third group is the scene's."""
    groups = groups_of(scene)
    if groups.G is None or groups.V is None:
        raise SceneError([Fault("material", "neither G nor V", "a yield stress and a viscosity")], "of a phase diagram")
    return Place(**{"G": groups.G, "V": groups.V, "delta": groups.delta} | {plane.x.key: x, plane.y.key: y})


def refuse_scene(scene: Scene) -> None:
    """Refuse a filament whose regimes do not depend on G, V and delta alone."""
    material, load, ends = scene.material, scene.load, scene.ends
    faults = [
        Fault(path, found, accepted)
        for path, there, found, accepted in (
            ("material.law", material.law != "bingham", f"{material.law!r} has no regimes by G and V", '"bingham"'),
            ("load.gravity", load.gravity == 0, "zero, but the groups are measured by it", "a positive gravity"),
            ("load.shake", load.shake > 0, "shaken gravity has other regimes", "0"),
            (
                "ends",
                not is_held(scene) or is_slack(scene),
                "the filament is not held straight at both ends",
                "both ends held, no slack",
            ),
            (
                "ends",
                bool(ends.motion) or ends.drop != 0,
                "a support moves or is lowered",
                "two level supports at rest",
            ),
        )
        if there
    ]
    faults += [
        Fault(path, f"{what} is no part of the groups", accepted)
        for path, there, what, accepted in (
            ("load.point_mass", load.point_mass > 0, "a weight at midspan", "0"),
            ("surroundings.surface_tension", pull_of_surface(scene) > 0, "the pull of a surface", "0"),
            ("surroundings.density", buoyant_share(scene) > 0, "buoyancy in a bath", "0"),
            ("temperature", scene.temperature.present, "a temperature", "leaving it out"),
            ("material.structure", material.structure is not None, "a structure", "leaving it out"),
            ("material.hardening_modulus", material.hardening_modulus is not None, "hardening", "leaving it out"),
            ("material", bool(material.histories()), "a change in time", "constants"),
        )
        if there
    ]
    if faults:
        raise SceneError(faults, "of a phase diagram")


def duration_at(scene: Scene, place: Place) -> float:
    """Duration of a run [s], long enough to show whether the filament stops.

    It is the ramp, `ELASTIC_TIME`, and for the flow the shorter of `ARREST_FLOW_TIME` and `WEIGHT_TIME`.
    """
    flow = place.V * min(WEIGHT_TIME, ARREST_FLOW_TIME * place.G)
    return scene.load.ramp + (ELASTIC_TIME + flow) * gravity_time(scene)


Node = tuple[int, int]
Square = tuple[int, int, int]
"""Lower left node and width, in lattice steps."""

COARSEST = 8
"""Smallest initial number of squares along an axis: regions smaller than such a square may be missed."""


@dataclass(frozen=True)
class RefinedLattice:
    """A lattice of so many squares along each axis, with a label at each node, shape (cells + 1, cells + 1)."""

    cells: int
    labels: npt.NDArray[np.str_]
    known: frozenset[Node]  # Nodes whose label was computed

    @property
    def saved(self) -> int:
        """Number of nodes whose label was never computed."""
        return self.labels.size - len(self.known)


def coarse_width(cells: int) -> int:
    """Width of the first squares in lattice steps: the largest power of two that leaves `COARSEST` along an axis."""
    width = 1
    while cells % (2 * width) == 0 and cells // (2 * width) >= COARSEST:
        width *= 2
    return width


def refined(cells: int, label: Callable[[Sequence[Node]], Sequence[str]]) -> RefinedLattice:
    """Label a lattice, refined only along the boundaries between labels.

    Every square in which two known labels differ, its edges included, is divided in four, down to one lattice step; the
    nodes of any other have the label of its corners.
    """
    labels, width = np.full((cells + 1, cells + 1), "", dtype=object), coarse_width(cells)
    new = [(i, j, width) for i in range(0, cells, width) for j in range(0, cells, width)]
    squares = set[Square]()
    while new:
        corners = {(i + a, j + b) for i, j, w in new for a in (0, w) for b in (0, w)}
        if missing := sorted(node for node in corners if not labels[node]):
            labels[tuple(np.transpose(missing))] = label(missing)
        squares.update(new)
        # Known nodes on the edges of a square may come from finer neighbours.
        seen = {(i, j, w): set(labels[i : i + w + 1, j : j + w + 1].flat) - {""} for i, j, w in squares if w > 1}
        cut = [square for square, marks in seen.items() if len(marks) > 1]
        squares.difference_update(cut)
        new = [(i + a, j + b, w // 2) for i, j, w in cut for a in (0, w // 2) for b in (0, w // 2)]
    known = frozenset(zip(*(index.tolist() for index in np.nonzero(labels)), strict=True))
    for i, j, w in squares:
        inside = labels[i : i + w + 1, j : j + w + 1]
        inside[inside == ""] = labels[i, j]
    return RefinedLattice(cells, labels.astype(str), known)


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
        return row | {name: getattr(self, name) for name in ("rate", "span_rate", "steps", "runs", "message")}


_TYPES = {"str": str, "int": int, "float": float}
_COLUMNS = {field.name: RecordColumn("", "", dtype=_TYPES[str(field.type)]) for field in fields(PhaseRun)[1:]}


def run_places(
    scene: Scene,
    places: Sequence[Place],
    pool: RunPool,
    progress: MembersProgress | None = None,
    duration: float | None = None,
) -> list[PhaseRun]:
    """Run one filament for each place, finished ones from the store."""
    rows: list[Row] = [
        {"groups.G": place.G, "groups.V": place.V, "run.duration": duration or duration_at(scene, place)}
        for place in places
    ]
    for row, place in zip(rows, places, strict=True):
        if place.delta != groups_of(scene).delta:
            row["groups.delta"] = place.delta
    identity = identity_of(scene)
    batch = Batch(rows, 1, lambda row: key_of("phase", identity, row), _COLUMNS, {})
    shared_by(scene)  # Made once, before threads use it
    table = batch.run(batch.stored(), PhaseWork(scene, pool.stop), pool, _CHUNK, progress)
    records = zip(*(table[name].tolist() for name in _COLUMNS), strict=True)
    return [
        PhaseRun(place, **dict(zip(_COLUMNS, record, strict=True)))
        for place, record in zip(places, records, strict=True)
    ]


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
        for _ in range(TRIES - 1):
            # As a single run, which is repeated in shorter steps where these may cure it.
            if run.outcome not in STEP_SIZE_OUTCOMES or self.scene.numerics.rtol is not None:
                break
            rtol = run.prepared.settings.rtol / TIGHTER
            numerics = member.scene.numerics.model_copy(update={"rtol": rtol})
            member = replace(member, scene=member.scene.model_copy(update={"numerics": numerics}))
            run = self.run(member)
        if run.solution.ended is not None:
            # It falls for ever, perhaps before its second frame: again, with its frames up to then.
            member = _lasting(member, run.solution.ended * run.prepared.scale)
            run = replace(self.run(member), outcome=run.outcome, message=run.message)
        sag = -run.midpoint / rest_length(member.scene)
        record: dict[str, Any] = {"regime": run.regime, "outcome": run.outcome.name, "message": run.message}
        record |= {"duration": member.scene.run.duration, "drawn_out": 0.0, "runs": 1, "steps": run.solution.steps}
        record |= {
            "sag": float(sag[-1]),
            "rate": _largest_rate(run, 0.0),
            "span_rate": _largest_rate(run, CLAMP_REGION),
        }
        return record, sag


def _lasting(member: Member, duration: float) -> Member:
    """The member with another duration [s]."""
    run = member.scene.run.model_copy(update={"duration": duration})
    return replace(member, scene=member.scene.model_copy(update={"run": run}))


def _largest_rate(run: MemberRun, ends: float) -> float:
    """Largest plastic rate of the last tenth over sigma_Y/eta, further than a share of the span from the ends."""
    material, rate = run.member.scene.material, run.fields["plastic_rate"]
    pace = (material.yield_stress or 0.0) / (material.viscosity or np.inf)
    last = rate[min(len(rate) - 1, int((1 - ARREST_TIME) * (len(rate) - 1))) :]
    inside = np.abs(run.cells) < (0.5 - ends) * rest_length(run.member.scene)
    return float(np.max(last[:, inside])) / pace if pace else 0.0
