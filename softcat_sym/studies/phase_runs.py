"""Planes of dimensionless groups, and the runs behind a phase diagram, refined only along its boundaries."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym.discretization.grid import Floats
from softcat_sym.ensemble.ensemble import MembersProgress, Stop, Workshop, side_by_side
from softcat_sym.ensemble.executor import Count, Embedded, Told, Workplace, blocks_of, run_blocks
from softcat_sym.ensemble.table import Member, members_of
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.results.fields import energy_residual, min_energy, node_positions, whole_span_fields
from softcat_sym.results.motion import ARREST_RATE, ARREST_TIME, regime_of, seen
from softcat_sym.results.verdict import measures, missing_effect, verdict
from softcat_sym.scene.scene import Scene, gravity_time, groups_of, is_held, is_slack, rest_length
from softcat_sym.simulate import identity_of
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Solution
from softcat_sym.store import json_form, keep, key_of, recall

MIN_RESOLUTION, MAX_RESOLUTION = 4, 640

ELASTIC_TIME: Final = 4.0
"""Least time of a run in sqrt(L/g), after the ramp of gravity.

An elastic filament of the paper's modulus swings four times or more in it, and an undamped fall past the catenary, half
a period pi sqrt(G/10), has turned back.
"""

ARREST_FLOW_TIME: Final = 4.0
"""Time in eta/sigma_Y after which an arrest shows: overstress relaxes, and hinges turn, in a time eta/sigma_Y."""

WEIGHT_TIME: Final = 1.0
"""Longest time in eta/(rho g L). It is the time in which the stress rho g L makes a strain of one: a catenary that
nothing stops has fallen by some 0.4 L by then, and soon after it is drawn out at its clamps."""


@dataclass(frozen=True, slots=True)
class PhaseAxis:
    """One group, in equal steps of its logarithm."""

    key: str  # ``"G"``, ``"V"`` or ``"delta"``
    low: float  # Its ends
    high: float

    def values(self, cells: int) -> Floats:
        """Lattice values, shape (cells + 1,)."""
        return np.geomspace(self.low, self.high, cells + 1)


@dataclass(frozen=True, slots=True)
class PhasePlane:
    """Two groups that vary, the third as in the scene."""

    name: str  # As a user names it
    x: PhaseAxis  # G across, the other one upwards
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
    """A number of cells along an axis that can be had."""
    if isinstance(resolution, bool) or not isinstance(resolution, int):
        raise SoftcatError(f"resolution = {resolution!r}: a whole number of cells along each axis")
    if not MIN_RESOLUTION <= resolution <= MAX_RESOLUTION:
        raise SoftcatError(f"resolution = {resolution}: accepted: {MIN_RESOLUTION} to {MAX_RESOLUTION} cells")
    return resolution


def refuse_scene(scene: Scene) -> None:
    """Refuse a filament whose regimes G, V and delta do not decide."""
    faults = []
    if scene.material.law != "bingham":
        faults.append(Fault("material.law", f"{scene.material.law!r} has no regimes by G and V", '"bingham"'))
    if scene.load.gravity == 0:
        faults.append(Fault("load.gravity", "zero, but the groups are measured by it", "a positive gravity"))
    if scene.load.shake > 0:
        faults.append(Fault("load.shake", "shaken gravity has regimes of its own", "0"))
    if not is_held(scene) or is_slack(scene):
        faults.append(Fault("ends", "the filament is not held straight at both ends", "both ends held, no slack"))
    if scene.ends.motion or scene.ends.drop != 0:
        faults.append(Fault("ends", "a support moves or is lowered", "two level supports at rest"))
    if scene.load.point_mass > 0:
        faults.append(Fault("load.point_mass", "a weight at midspan is no part of the groups", "0"))
    if faults:
        raise SceneError(faults, "of a phase diagram")


def place_at(scene: Scene, plane: PhasePlane, x: float, y: float) -> Place:
    """The groups at a place of a plane; the one that does not vary is the scene's."""
    groups = groups_of(scene)
    if groups.G is None or groups.V is None:
        raise SceneError([Fault("material", "neither G nor V", "a yield stress and a viscosity")], "of a phase diagram")
    held = {"G": groups.G, "V": groups.V, "delta": groups.delta} | {plane.x.key: x, plane.y.key: y}
    return Place(**held)


def duration_at(scene: Scene, place: Place) -> float:
    """How long a filament is watched [s]: long enough for it to show whether it stops.

    The ramp, `ELASTIC_TIME`, and of flow the shorter of `ARREST_TIME` and `WEIGHT_TIME`.
    """
    flow = place.V * min(WEIGHT_TIME, ARREST_FLOW_TIME * place.G)
    return scene.load.ramp + (ELASTIC_TIME + flow) * gravity_time(scene)


def row_of(scene: Scene, place: Place, duration: float) -> dict[str, object]:
    """What the filament at a place changes in the scene, as a row of :func:`softcat_sym.simulate_many`."""
    delta: dict[str, object] = {} if place.delta == groups_of(scene).delta else {"groups.delta": place.delta}
    return delta | {"groups.G": place.G, "groups.V": place.V, "run.duration": duration}


_SORTS = 16
"""Sorts of filament that are remembered from block to block: their graphs are what takes memory."""


@dataclass(frozen=True)
class JudgedMember:
    """A finished run."""

    prepared: Prepared  # How it was integrated
    solution: Solution  # What came out
    fields: dict[str, Floats]  # Over the whole span, as from :func:`softcat_sym.results.fields.whole_span_fields`
    nodes: Floats  # Their material coordinates [m]
    cells: Floats
    midpoint: Floats  # shape (frames,); Height of midspan [m]
    outcome: Outcome  # How it ended
    message: str  # Why, if that was no success
    energy_residual: float  # Of the balance at every frame
    regime: str | None  # What the run shows; None if it is no answer
    # Effects that ``auto`` has left out and that the run shows to matter, and how: a single run would be repeated.
    missing_effect: dict[str, str]


def judged(member: Member, workshop: Workshop, stop: Stop) -> JudgedMember:
    """Integrate a member and judge it by all its frames."""
    stop.update(0.0, None)
    scene = member.scene
    prepared = workshop.prepare(member)
    solution = prepared.solve(stop)
    fields = whole_span_fields(scene, prepared, solution)
    nodes, cells = node_positions(prepared.graph, rest_length(scene))
    residual = energy_residual(fields, min_energy(scene))
    audits = prepared.graph.conserves_energy and prepared.integration is not None
    outcome, message = verdict(scene, member.effects, solution, fields, nodes, residual if audits else 0.0)
    midpoint = fields["y"][:, fields["y"].shape[1] // 2]
    regime = regime_of(scene, member.effects, fields, midpoint) if outcome.is_success else None
    missing = _overlooked(member, solution.time * prepared.scale, (nodes, cells), fields, outcome)
    return JudgedMember(prepared, solution, fields, nodes, cells, midpoint, outcome, message, residual, regime, missing)


def _overlooked(
    member: Member, time: Floats, places: tuple[Floats, Floats], fields: dict[str, Floats], outcome: Outcome
) -> dict[str, str]:
    """What the program has left out of a member and the finished run calls for."""
    if member.scene.run.effects != "auto":
        return {}
    motion = seen(member.scene, member.effects, time, places, fields)
    return missing_effect(member.scene, member.effects, measures(member.scene, member.effects, motion), outcome)


@lru_cache(maxsize=2)
def shared_workshop(plan: str) -> Workshop:
    """What the blocks of a plan share in this process; `plan` is any text that tells plans apart."""
    del plan
    return Workshop(_SORTS)


Node = tuple[int, int]
Label = Callable[[Sequence[Node]], Sequence[str]]

COARSEST = 8
"""Least number of squares along an axis to begin with: what is smaller than such a square may be missed."""


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
    known: dict[Node, str]  # Labels that were asked for
    squares: tuple[Square, ...]  # What tiles the plane: one step wide where corners differ, wider elsewhere

    @property
    def saved(self) -> int:
        """Nodes whose label was never asked for."""
        return (self.cells + 1) ** 2 - len(self.known)

    def labels(self) -> npt.NDArray[np.str_]:
        """The label of every node, shape (cells + 1, cells + 1); in a wide square it is that of its corners."""
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
    """Label a lattice, looking closely only along the boundaries.

    Every square on whose edge or inside two known labels differ is cut in four, down to one lattice step.
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
    """Whether two known nodes of a square differ; a finer neighbour may know nodes on its edges."""
    i, j, w = square.i, square.j, square.width
    nodes = ((i + a, j + b) for a in range(w + 1) for b in range(w + 1))
    return len({known[node] for node in nodes if node in known}) > 1


PASSED = 0.5
"""Sag over span beyond which no catenary rests: the one of least stress sags by 0.338 (3.12, exact)."""

CLAMP_REGION = 0.1
"""Share of the span next to each end that is not counted as the span: hinges are much shorter."""

DESCENDING = "descending"

CLAMPS_ONLY = "descending-at-clamps"
"""Mark of a descending filament whose span, `CLAMP_REGION` away from the ends, counts as arrested by itself."""

Watched = tuple[Place, float]
"""A filament's groups, and how long it is watched [s]."""

LOST = "lost"
"""Outcome of a run whose worker died."""

_BLOCK = 16
"""Filaments that are run, kept and lost together: some tenths of a second."""


@dataclass(frozen=True)
class LocalStrains:
    """True axial strain at one section: of the centreline, and of its most stretched fibre (2.6, objective form)."""

    centreline: float
    largest: float


@dataclass(frozen=True)
class PhaseRun:
    """One filament."""

    place: Place  # Its groups
    regime: str | None  # What the run shows; None if it is no answer
    outcome: str  # Name of the outcome: of the run that gave the regime, or of the one that failed
    message: str  # Why, of a run that is no answer
    duration: float  # Of the run that was judged [s]
    # Duration [s] of the longer run that was no answer, where the judged one ends as its sag passes `PASSED`.
    drawn_out: float | None
    runs: int  # How many were made: 1 or 2
    sag: float  # Of the midpoint at the end, over the span
    # Largest plastic rate in the last tenth of the run over sigma_Y/eta: of all fibres, and of those further than
    # `CLAMP_REGION` from the ends.
    rate: float
    span_rate: float
    clamp: LocalStrains  # At the end of the run, in the cell at a clamp and in the one at midspan
    midspan: LocalStrains
    steps: int  # Of the integrator, of all runs

    @property
    def mark(self) -> str:
        """The regime, or the name of the outcome of a run that has none; `CLAMPS_ONLY` sets a part of one apart."""
        if self.regime == DESCENDING and self.span_rate < ARREST_RATE:
            return CLAMPS_ONLY
        return self.regime if self.regime is not None else self.outcome


class PhaseRunner:
    """Runs filaments that differ in their groups, side by side; equations, graph and C code are made once."""

    def __init__(
        self,
        scene: Scene,
        workers: int,
        progress: MembersProgress,
        place: Workplace | None = None,
    ) -> None:
        self._scene, self._progress, self._place = scene, progress, place or Embedded(workers)
        self._work = PhaseWork(scene)

    def run(self, places: Sequence[Place], durations: Sequence[float] | None = None) -> list[PhaseRun]:
        """Run one filament for each place."""
        watched = durations or [duration_at(self._scene, place) for place in places]
        asked = list(zip(places, watched, strict=True))
        identity = identity_of(self._scene)
        keys = {one: key_of("phase", identity, one) for one in asked}
        known = {one: recall(key) for one, key in keys.items()}
        found = {one: _FORM.read(content) for one, content in known.items() if content is not None}
        blocks = blocks_of([one for one in asked if one not in found], _BLOCK)

        def keep_all(number: int, runs: Sequence[PhaseRun]) -> None:
            for one, run in zip(blocks[number].items, runs, strict=True):
                found[one] = run
                if run.outcome != LOST:
                    keep(keys[one], _FORM.write(run))

        told = Count(len(asked), len(found), self._progress)
        run_blocks(self._work, blocks, self._place, told, keep_all)
        return [found[one] for one in asked]


@dataclass(frozen=True)
class PhaseWork:
    """What is done with places; it can be sent to another process."""

    scene: Scene  # What the filaments have in common

    def run(self, items: Sequence[Watched], threads: int, told: Told) -> list[PhaseRun]:
        """Run filaments, each for its time, `threads` of them at once."""
        members = members_of(self.scene, [row_of(self.scene, *item) for item in items], "once")
        # CasADi keeps Python's lock while it integrates: threads would only wait for each other.
        threads = threads if all(member.parallel for member in members) else 1
        stop, workshop = Stop(), shared_workshop(self.scene.to_toml())
        pairs = [(place, member) for (place, _), member in zip(items, members, strict=True)]
        return side_by_side(lambda pair: _one(*pair, workshop, stop), pairs, threads, stop, lambda _: told(1))

    def lost(self, item: Watched, why: str) -> PhaseRun:
        """The run of a filament that has killed whoever ran it: no answer."""
        place, duration = item
        none = LocalStrains(0.0, 0.0)
        return PhaseRun(place, None, LOST, why, duration, None, 1, 0.0, 0.0, 0.0, none, none, 0)


def _one(place: Place, member: Member, workshop: Workshop, stop: Stop) -> PhaseRun:
    """Run a filament; one that is no answer once more, to the time at which it has fallen past every catenary.

    What descends for ever is drawn out in the end, and then it is no answer: what it did before is one.
    """
    first, sag = _run(place, member, workshop, stop)
    if first.regime is not None or not np.any(sag > PASSED):
        return first
    frames = member.scene.run.frames
    short = first.duration * float(np.argmax(sag > PASSED)) / (frames - 1)
    run = member.scene.run.model_copy(update={"duration": short})
    shorter = replace(member, scene=member.scene.model_copy(update={"run": run}))
    second, _ = _run(place, shorter, workshop, stop)
    steps = first.steps + second.steps
    if second.regime != DESCENDING:
        return replace(first, runs=2, steps=steps)
    return replace(second, runs=2, steps=steps, drawn_out=first.duration)


def _run(place: Place, member: Member, workshop: Workshop, stop: Stop) -> tuple[PhaseRun, Floats]:
    """A run, and its sag over the span, shape (frames,)."""
    scene, one = member.scene, judged(member, workshop, stop)
    rate, span_rate = _rates(scene, one.prepared, one.fields["plastic_rate"])
    sag = -one.midpoint / rest_length(scene)
    run = PhaseRun(
        place,
        one.regime,
        one.outcome.name,
        one.message,
        scene.run.duration,
        None,
        1,
        float(sag[-1]),
        rate,
        span_rate,
        _strains(one.fields, 0),
        _strains(one.fields, one.fields["stretch"].shape[1] // 2),
        one.solution.steps,
    )
    return run, sag


def _rates(scene: Scene, prepared: Prepared, rate: Floats) -> tuple[float, float]:
    """Largest plastic rate of the last tenth over sigma_Y/eta: everywhere, and away from the ends."""
    material, span = scene.material, rest_length(scene)
    pace = (material.yield_stress or 0.0) / (material.viscosity or np.inf)
    if not pace:
        return 0.0, 0.0
    last = rate[min(len(rate) - 1, int((1 - ARREST_TIME) * (len(rate) - 1))) :]
    cells = node_positions(prepared.graph, span)[1]
    away = np.abs(cells) < (0.5 - CLAMP_REGION) * span
    return float(np.max(last)) / pace, float(np.max(last[:, away])) / pace


def _strains(fields: dict[str, Floats], cell: int) -> LocalStrains:
    """Strain in the last frame, eps = log s - theta_s z at z of the outer fibres, with the present thickness."""
    stretch, curvature, thickness = (float(fields[name][-1, cell]) for name in ("stretch", "curvature", "thickness"))
    centreline = float(np.log(stretch))
    return LocalStrains(centreline, centreline + abs(curvature) * thickness / 2)


def _read_run(told: dict[str, Any]) -> PhaseRun:
    parts = {"place": Place(**told["place"])} | {name: LocalStrains(**told[name]) for name in ("clamp", "midspan")}
    return PhaseRun(**{**told, **parts})


_FORM = json_form(asdict, _read_run)
