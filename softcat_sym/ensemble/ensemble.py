"""Many runs that differ in some values: integrated side by side in threads, one result."""

from __future__ import annotations

import importlib.metadata
import json
import threading
import time
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from softcat_sym.discretization.assembly import choose_body, choose_grid
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.ensemble.centre import RESOLUTION, Centre, centred, used, used_by
from softcat_sym.ensemble.executor import MembersProgress, Stop, counted, executor, worker_count
from softcat_sym.ensemble.members import (
    Choosing,
    Member,
    MemberMaker,
    Row,
    is_group,
    is_number,
    kind_of,
    members_of,
    rows_of,
)
from softcat_sym.errors import Fault, SceneError
from softcat_sym.progress import Display
from softcat_sym.results.breaking import breakable
from softcat_sym.results.fields import (
    energy_residual,
    midpoint_heights,
    min_energy,
    node_positions,
    whole_span_fields,
)
from softcat_sym.results.motion import beyond_noise, has_yielded, midpoint_extremes, regime_of
from softcat_sym.results.run import Run
from softcat_sym.results.verdict import verdict
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.scene.units import SI_UNITS, Number, Quantity
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import Assembled, Code, Prepared, assembled, prepare
from softcat_sym.solvers.settings import Settings, settings_for
from softcat_sym.solvers.solution import Extremes, Solution, watched

if TYPE_CHECKING:
    import xarray as xr
    from rich.console import Console

_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")
_MAX_STRUCTURES = 16
_ROUNDING = 1e-9
"""Structures whose graphs a study remembers: they are what takes memory."""


class MembersBar(Display):
    """Shows on standard error how many members are done, and how long the rest takes."""

    def __init__(self, description: str = "members", *, quiet: bool = False, console: Console | None = None) -> None:
        super().__init__(quiet=quiet, console=console)
        self.stage(description)

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of how far it is."""
        self.reach(done / members, f"{done} of {members}", left)


@dataclass(frozen=True)
class SharedFilament:
    """Filaments that differ in numbers only."""

    first: Assembled  # One of them, with the graph of all
    code: Code  # None if interpreted

    @cached_property
    def statics(self) -> Graph:
        """The filament without inertia and viscous stress, for a start that is not straight."""
        return self.first.at_rest()


class Workshop:
    """Prepares members for integration; what several of them share is made by the first that needs it."""

    def __init__(self, max_structures: int | None = None) -> None:
        self._filaments: dict[tuple[object, ...], SharedFilament] = {}
        self._max_structures = max_structures
        self._lock = threading.RLock()

    def alone(self) -> AbstractContextManager[object]:
        """While this is held no other thread makes equations, graphs or code here."""
        return self._lock

    def prepare(self, member: Member) -> Prepared:
        """A member with its parameters, start and integrator, as a single run has them."""
        scene, effects, backend = member.scene, member.effects, member.backend
        settings = tolerances(member)
        grid = choose_grid(scene, effects)
        body = choose_body(scene, grid)
        arrays = tuple(map(_bytes, (grid.nodes, body.profile.nodes, body.profile.cells, body.natural)))
        place = (*arrays, grid.first, grid.last, body.supports, body.weighted)
        with self._lock:
            key = (member.pattern, effects.names, backend, settings.solver, *place)
            shared = self._filaments.get(key)
            if shared is None:
                if self._max_structures is not None and len(self._filaments) >= self._max_structures:
                    del self._filaments[next(iter(self._filaments))]
                first = assembled(scene, effects)
                shared = self._filaments[key] = SharedFilament(first, first.code(backend, settings))
        compiled, at_rest = (backend, shared.code), shared.first.code_at_rest
        return prepare(scene, shared.first.graph, settings, lambda: shared.statics, compiled, at_rest)

    def run(self, member: Member, stop: Stop) -> tuple[Prepared, Solution]:
        """Integrate a member; one that Python integrates by itself, since CasADi keeps Python's lock meanwhile."""
        stop.update(0.0, None)
        prepared = self.prepare(member)
        if member.parallel:
            return prepared, prepared.solve(stop)
        with self._lock:
            return prepared, prepared.solve(stop)


def tolerances(member: Member) -> Settings:
    """Integrator and tolerances as `simulate` has them, without what these do not depend on.

    Absolute tolerances follow the largest sag that is foreseen, which under a load that never falls is the last: to
    foresee it at every output time, as estimates of effects need it, would take longer than many an integration.
    """
    scene = member.scene
    brief = scene.model_copy(update={"run": scene.run.model_copy(update={"frames": 2})})
    return settings_for(brief, member.effects, compiled=member.backend.compiled)


def _bytes(values: object) -> bytes | None:
    return None if values is None else np.asarray(values, dtype=float).tobytes()


@dataclass(frozen=True)
class Study:
    """What the members of a study share in one process."""

    maker: MemberMaker
    workshop: Workshop


@lru_cache(maxsize=2)
def study_of(scene: Scene) -> Study:
    """What members of this scene share in this process; no member depends on its neighbours.

    Where the program chooses the effects, it does so for each member by itself. Where the scene names them, the choice
    is made once, and again for a row of other equations.
    """
    choosing: Choosing = "each" if scene.run.effects == "auto" else "once"
    return Study(MemberMaker(scene, choosing, neighbours=False), Workshop(_MAX_STRUCTURES))


@dataclass(frozen=True)
class MemberRun:
    """A finished run of a member, judged."""

    member: Member
    prepared: Prepared  # How it was integrated
    solution: Solution
    fields: dict[str, Floats]  # Over the whole span, as from :func:`softcat_sym.results.fields.whole_span_fields`
    nodes: Floats  # Their material coordinates [m]
    cells: Floats
    outcome: Outcome
    message: str  # Why, if that was no success
    energy_residual: float

    @property
    def midpoint(self) -> Floats:
        """Height of midspan [m], shape (frames,)."""
        heights: Floats = self.fields["y"][:, self.fields["y"].shape[1] // 2]
        return heights

    @cached_property
    def extremes(self) -> Extremes:
        """Turning points of midspan."""
        scene = self.member.scene
        return beyond_noise(scene, midpoint_extremes(scene, self.prepared, self.solution))

    @cached_property
    def regime(self) -> str | None:
        """What the run shows; None if it is no answer."""
        if not self.outcome.is_success:
            return None
        yielded = has_yielded(self.prepared, self.solution)
        return regime_of(self.member.scene, self.member.effects, self.fields, self.extremes.height, yielded=yielded)


def judged(member: Member, prepared: Prepared, solution: Solution) -> MemberRun:
    """Judge a run by the frames of its solution."""
    scene = member.scene
    fields = whole_span_fields(scene, prepared, solution)
    nodes, cells = node_positions(prepared.graph, rest_length(scene))
    residual = energy_residual(fields, min_energy(scene))
    audits = prepared.graph.conserves_energy and prepared.integration is not None
    outcome, message = verdict(scene, member.effects, solution, fields, nodes, residual if audits else 0.0)
    return MemberRun(member, prepared, solution, fields, nodes, cells, outcome, message, residual)


@dataclass(frozen=True)
class Record:
    """What an ensemble stores of a member's run."""

    midpoint: Floats  # shape (frames,); [m]; NaN after the time that was reached
    outcome: Outcome  # How it ended
    message: str  # Why, if that was no success
    reached: float  # Last frame [s]
    energy_residual: float  # Between the first and the last frame, relative to the largest energy in them
    steps: int  # Of the integrator
    wall: float  # Seconds, waiting for other threads included
    used: dict[str, float]  # Cells, fibres and tolerance, and the error if it was estimated


def _record(member: Member, workshop: Workshop, stop: Stop) -> Record:
    begun, scene = time.perf_counter(), member.scene
    prepared, solution = workshop.run(member, stop)
    ends = solution
    # Without velocities the work against the necking gradient is summed over frames; a break is sought in all of them.
    if prepared.graph.has_velocities and not breakable(scene):
        ends = solution.only([0, -1])
    run = judged(member, prepared, ends)
    midpoint = np.full(scene.run.frames, np.nan)
    heights = midpoint_heights(prepared.graph, solution) * rest_length(scene)
    midpoint[: len(solution.time)] = heights + 0.0  # no minus zero
    reached, wall = float(solution.time[-1]) * prepared.scale, time.perf_counter() - begun
    how = used(member, prepared)
    return Record(midpoint, run.outcome, run.message, reached, run.energy_residual, solution.steps, wall, how)


def _estimated(member: Member) -> Record:
    """A member as :func:`softcat_sym.simulate` runs it with these effects, its error estimated."""
    begun = time.perf_counter()
    run = simulated(member.scene.replace({"run.effects": list(member.effects.names)}))
    summary, lasts = run.summary, member.scene.run
    # What breaks or falls for ever has frames of its own up to then.
    midpoint, times = np.full(lasts.frames, np.nan), np.linspace(0.0, lasts.duration, lasts.frames)
    seen = times <= (1 + _ROUNDING) * summary["time_final_s"]
    midpoint[seen] = np.interp(times[seen], run.fields["time"], run.fields["midpoint"])
    reached, residual, wall = summary["time_final_s"], summary["energy_residual"], time.perf_counter() - begun
    return Record(midpoint, run.outcome, summary["message"], reached, residual, summary["steps"], wall, used_by(run))


@dataclass(frozen=True)
class Ensemble:
    """Finished members, in the order of the table.

    Attributes
    ----------
    scenes : tuple of Scene
        Scene of each member.
    data : xarray.Dataset
        Dims ``member`` and ``time``. Variables ``midpoint`` (member, time) [m], NaN after the time that a member has
        reached; and for each member ``midpoint_final`` [m] and ``time_final`` [s] (the last frame reached),
        ``outcome`` (name of the `Outcome`), ``message``, ``energy_residual`` (between first and last frame),
        ``effects``, ``steps``, ``wall_s``, ``cells``, ``fibres`` (NaN where the section is not resolved by them),
        ``rtol`` and ``error_estimate`` (NaN where it was not estimated). The attribute ``centres`` says in JSON which
        members were estimated for those of the same structure, and what was found. Every column of the table is a
        coordinate along ``member``, quantities in SI. ``time`` is in seconds where all members last equally long;
        otherwise it is the share of each member's own
        ``duration`` [s], which is then a variable.
    outcomes : tuple of Outcome
        Verdict on each member.

    Notes
    -----
    A member is judged by its integration, by the neck in its last frame, and by the energy balance between its first
    and its last frame. What `simulate` does beyond that is left to `trajectory`: an energy balance at every frame, and
    a look whether an effect that was left out has mattered, with a repetition if so.
    """

    scenes: tuple[Scene, ...]
    data: xr.Dataset
    outcomes: tuple[Outcome, ...]

    def __len__(self) -> int:
        return len(self.scenes)

    def trajectory(self, member: int) -> Run:
        """Run one member again by `simulate`: whole shapes, every check, effects as its own scene asks for them.

        Parameters
        ----------
        member : int
            Its row in the table, from 0.

        Raises
        ------
        IndexError
            If there is no such row.
        """
        return simulated(without_estimate(self.scenes[member]))


def _collected(
    scene: Scene, rows: Sequence[Row], members: Sequence[Member], records: Sequence[Record], notes: dict[str, str]
) -> Ensemble:
    import xarray as xr

    scenes = tuple(member.scene for member in members)
    durations = np.array([row.run.duration for row in scenes])
    share = np.linspace(0.0, 1.0, scene.run.frames)
    variables = _variables(members, records)
    if np.all(durations == durations[0]):
        time = ("time", share * durations[0], {"units": "s", "long_name": "time"})
    else:
        time = ("time", share, {"units": "1", "long_name": "time over the duration of the member"})
        variables["duration"] = (("member",), durations, {"units": "s", "long_name": "duration of the run"})
    coordinates = {key: _column(scenes, rows, key) for key in rows[0]}
    versions = json.dumps({name: importlib.metadata.version(name) for name in _VERSIONS})
    data = xr.Dataset(
        variables,
        coords={"member": np.arange(len(rows)), "time": time, **coordinates},
        attrs={"title": scene.title, "scene": scene.to_toml(), "versions": versions, **notes},
    )
    return Ensemble(scenes, data, tuple(record.outcome for record in records))


def _variables(members: Sequence[Member], records: Sequence[Record]) -> dict[str, Any]:
    midpoint = np.stack([record.midpoint for record in records])
    # At least the first frame is always there.
    last = np.count_nonzero(~np.isnan(midpoint), axis=1) - 1
    columns: tuple[tuple[str, Any, str, str], ...] = (
        (
            "midpoint_final",
            midpoint[np.arange(len(last)), last],
            "m",
            "height of the midpoint in the last frame reached, negative down",
        ),
        ("time_final", [record.reached for record in records], "s", "time of the last frame reached"),
        ("outcome", [record.outcome.name for record in records], "", "how the run ended"),
        ("message", [record.message for record in records], "", "why, if that is no success"),
        (
            "energy_residual",
            [record.energy_residual for record in records],
            "1",
            "energy imbalance of the last frame against the first, of the largest energy",
        ),
        ("effects", [", ".join(member.effects.names) for member in members], "", "effects in force"),
        ("steps", [record.steps for record in records], "", "steps of the integrator"),
        ("wall_s", [record.wall for record in records], "s", "wall time, side by side with other members"),
        *(
            (name, [record.used.get(name, np.nan) for record in records], "1", words)
            for name, words in RESOLUTION.items()
        ),
    )
    about = {"units": "m", "long_name": "height of the midpoint X = 0, negative down; NaN where it was not reached"}
    variables: dict[str, Any] = {"midpoint": (("member", "time"), midpoint, about)}
    for name, values, unit, meaning in columns:
        about = {"units": unit, "long_name": meaning} if unit else {"long_name": meaning}
        variables[name] = (("member",), np.asarray(values), about)
    return variables


def _column(scenes: Sequence[Scene], rows: Sequence[Row], key: str) -> tuple[str, Any, dict[str, str]]:
    """A column of the table: quantities in SI, other numbers as they are, the rest as text."""
    kind = kind_of(scenes[0], rows[0], key)
    if isinstance(kind, (Quantity, Number)):
        table, _, name = key.partition(".")
        values = [getattr(getattr(scene, table), name) for scene in scenes]
        unit = (kind.unit or SI_UNITS[kind.dimension]) if isinstance(kind, Quantity) else "1"
        return "member", np.array([np.nan if value is None else value for value in values], float), {"units": unit}
    given = [row[key] for row in rows]
    if all(is_number(value) for value in given):
        return "member", np.array(given), {"units": "1"} if is_group(key) else {}
    return "member", np.array([str(value) for value in given]), {}


Table = Mapping[str, Sequence[object] | npt.NDArray[Any]] | Sequence[Mapping[str, object]] | npt.NDArray[Any]


def simulate_many(
    scene: SceneLike,
    parameters: Table,
    *,
    workers: int | None = None,
    progress: MembersProgress | None = None,
    effects: Choosing = "once",
    estimate: bool = False,
) -> Ensemble:
    """Run a filament for every row of a table of parameters.

    Members run through the compiled solver in threads; where there is none for a scene, one after the other. The middle
    one of those with the same structure is run by :func:`simulate` before, or taken from the store, unless
    ``numerics.estimate = false``: all of them have at least the cells, fibres and tolerance with which it ends.

    Parameters
    ----------
    scene : Scene, str, path or dict
        What the rows have in common.
    parameters : mapping of str to sequence, sequence of mappings, or structured array
        Columns by dotted keys, as :meth:`Scene.replace` takes them; a plain number is in the SI unit of its key, text
        has a unit of its own: ``{"material.yield_stress": [4e3, "5 kPa"], "filament.span": [0.2, 0.3]}``. The groups
        ``groups.delta``, ``G``, ``V``, ``B``, ``E_star``, ``eps_Y`` and ``tau`` set the thickness and the constants of
        the law, Young's modulus and times stay unless they are columns themselves [Kamrin & Mahadevan 2012, 3.9, 3.10].
    workers : int, optional
        Threads; by default as many as there are cores.
    progress : MembersProgress, optional
        Updated with members done and time left, such as :class:`softcat_sym.ensemble.MembersBar`.
    effects : {"once", "each"}
        Whether effects are chosen for the scene and hold for all rows (anew only where rows change a choice, such as
        the law or an end, or whether a number is zero), or for each row by itself. Either way no run is repeated with
        more effects.
    estimate : bool
        Run each by :func:`simulate`, its own error estimated: several times as long.

    Returns
    -------
    Ensemble
        ``.data`` is an :class:`xarray.Dataset`; a member that fails is a row like the others, with its outcome.

    Raises
    ------
    SceneError
        If the table, or the scene of any row, makes no sense: every fault with its rows, before anything runs.
    KeyboardInterrupt
        If the user stops it: all threads have ended then.
    """
    if effects not in ("once", "each"):
        raise SceneError([Fault("effects", f"{effects!r}", "'once' or 'each'")], "of an ensemble")
    scene = as_scene(scene)
    threads, rows = worker_count(workers), rows_of(parameters)
    with watched():
        return _simulated(scene, rows, threads, progress, effects, estimate=estimate)


def _simulated(
    scene: Scene,
    rows: list[Row],
    workers: int,
    progress: MembersProgress | None,
    choosing: Choosing,
    *,
    estimate: bool,
) -> Ensemble:
    begun = time.perf_counter()
    members, centres = members_of(scene, rows, choosing), list[Centre]()
    if not estimate:
        members, centres = centred(members, rows)
    # CasADi keeps Python's lock while it integrates: threads would only wait for each other.
    parallel = all(member.parallel for member in members)
    threads = workers if parallel else 1
    records: dict[int, Any] = {}
    with executor(threads, members=len(members) if parallel else 0) as pool:
        run = _estimated if estimate else partial(_record, workshop=Workshop(), stop=pool.stop)
        records.update(counted(pool.map_members(run, members), len(members), 0, progress))
    notes = {
        "effects_chosen": choosing,
        "effects": json.dumps(members[0].effects.reasons),
        "backend": "; ".join(sorted({str(member.backend) for member in members})),
        "workers": str(threads),
        "centres": json.dumps([centre.to_dict() for centre in centres], default=str),
        "wall_s": f"{time.perf_counter() - begun:.6g}",
    }
    return _collected(scene, rows, members, [records[k] for k in range(len(members))], notes)
