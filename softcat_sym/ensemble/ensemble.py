"""Many runs that differ in some values: integrated side by side in threads, one result."""

from __future__ import annotations

import ctypes
import importlib.metadata
import json
import os
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import AbstractContextManager
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

import numpy as np
import numpy.typing as npt

from softcat_sym.discretization.assembly import Body, choose_body, choose_grid
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats, Grid
from softcat_sym.ensemble.table import Choosing, Member, Row, is_group, is_number, kind_of, members_of, rows_of
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.progress import Display
from softcat_sym.results.fields import (
    energy_residual,
    midpoint_heights,
    min_energy,
    node_positions,
    whole_span_fields,
)
from softcat_sym.results.trajectory import Trajectory
from softcat_sym.results.verdict import verdict as trajectory_verdict
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.scene.units import SI_UNITS, Number, Quantity
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run import Assembled, Code, Prepared, assembled, prepare
from softcat_sym.solvers.settings import Settings, settings_for
from softcat_sym.solvers.solution import Silence, Solution, watched

if TYPE_CHECKING:
    import xarray as xr
    from rich.console import Console


def verdict(member: Member, prepared: Prepared, solution: Solution) -> tuple[Outcome, str, float]:
    """Outcome, complaint and energy residual of a run."""
    scene = member.scene
    fields = whole_span_fields(scene, prepared, solution)
    residual = energy_residual(fields, min_energy(scene))
    audited = residual if prepared.graph.conserves_energy and prepared.integration is not None else 0.0
    nodes = node_positions(prepared.graph, rest_length(scene))[0]
    return *trajectory_verdict(scene, member.effects, solution, fields, nodes, audited), residual


class MembersProgress(Protocol):
    """Listens to a running ensemble."""

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of the members done, of how many there are, and of the time left [s]."""
        ...


class NobodyListens:
    """Tells nobody."""

    def update(self, done: int, members: int, left: float) -> None:
        """Do nothing."""
        del done, members, left


class MembersBar(Display):
    """Tells on standard error how many members are done, and how long the rest takes."""

    def __init__(self, description: str = "members", *, console: Console | None = None) -> None:
        super().__init__(console=console)
        self.stage(description)

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of how far it is."""
        self.reach(done / members, f"{done} of {members}", left)


_FIRST_AND_LAST = 2

Key = tuple[object, ...]


class Workshop:
    """Prepares members for integration; what several of them share is made by the first that needs it."""

    def __init__(self, most: int | None = None) -> None:
        self._filaments: dict[Key, SharedFilament] = {}
        self._most = most
        self._lock = threading.RLock()

    def alone(self) -> AbstractContextManager[object]:
        """While this is held no other thread makes equations, graphs or code here."""
        return self._lock

    def prepare(self, member: Member) -> Prepared:
        """A member with its parameters, start and integrator, as :func:`softcat_sym.simulate.build` makes it."""
        scene, effects, backend = member.scene, member.effects, member.backend
        settings = tolerances(member)
        grid = choose_grid(scene, effects)
        body = choose_body(scene, grid)
        with self._lock:
            key = (member.pattern, effects.names, backend, settings.solver, *_key_of(grid, body))
            shared = self._filaments.get(key)
            if shared is None:
                if self._most is not None and len(self._filaments) >= self._most:
                    del self._filaments[next(iter(self._filaments))]
                first = assembled(scene, effects)
                shared = self._filaments[key] = SharedFilament(first, first.code(backend, settings))
        return prepare(scene, shared.first.graph, settings, shared.statics, (backend, shared.code))


def tolerances(member: Member) -> Settings:
    """Integrator and tolerances as `simulate` has them, without what these do not depend on.

    Absolute tolerances follow the largest sag that is foreseen, which under a load that never falls is the last: to
    foresee it at every output time, as estimates of effects need it, would take longer than many an integration.
    """
    scene = member.scene
    brief = scene.model_copy(update={"run": scene.run.model_copy(update={"frames": _FIRST_AND_LAST})})
    return settings_for(brief, member.effects, compiled=member.backend.compiled)


@dataclass(frozen=True)
class SharedFilament:
    """Filaments that differ in numbers only."""

    first: Assembled  # One of them, with the graph of all
    code: Code  # None if interpreted

    def statics(self) -> Graph:
        """The filament without inertia and viscous stress, for a start that is not straight."""
        return self._statics

    @cached_property
    def _statics(self) -> Graph:
        return self.first.at_rest()


def _key_of(grid: Grid, body: Body) -> Key:
    profile = (_bytes(body.profile.nodes), _bytes(body.profile.cells))
    return _bytes(grid.nodes), grid.first, grid.last, body.supports, body.weighted, profile


def _bytes(values: object) -> bytes | None:
    return None if values is None else np.asarray(values, dtype=float).tobytes()


Item = TypeVar("Item")
Done = TypeVar("Done")


@dataclass(frozen=True)
class Record:
    """What is kept of a member's run."""

    midpoint: Floats  # shape (frames,); [m]; NaN after the time that was reached
    outcome: Outcome  # How it ended
    message: str  # Why, if that was no success
    reached: float  # Last frame [s]
    energy_residual: float  # Between the first and the last frame, relative to the largest energy in them
    steps: int  # Of the integrator
    wall: float  # Seconds, waiting for other threads included


class Stop(Silence):
    """Ends integrations from outside: as their listener, it raises when told to."""

    def __init__(self) -> None:
        self.flag = ctypes.c_int(0)

    def tell(self) -> None:
        """Let no integration go on."""
        self.flag.value = 1

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Look whether to stop."""
        del simulated_time, step_size
        if self.flag.value:
            raise KeyboardInterrupt


def workers_of(workers: int | None) -> int:
    """As many as asked, otherwise one for each core that this process may use."""
    if workers is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if isinstance(workers, bool) or not isinstance(workers, int) or workers < 1:
        raise SoftcatError(f"workers = {workers!r}: give a whole number of threads, 1 or more, or None for all cores")
    return workers


def run_all(members: Sequence[Member], workshop: Workshop, workers: int, progress: MembersProgress) -> list[Record]:
    """Run the members, `workers` at a time."""
    begun, stop = time.monotonic(), Stop()

    def told(done: int) -> None:
        progress.update(done, len(members), (time.monotonic() - begun) / done * (len(members) - done))

    return side_by_side(lambda member: _run(member, workshop, stop), members, workers, stop, told)


def side_by_side(
    work: Callable[[Item], Done], items: Sequence[Item], workers: int, stop: Stop, told: Callable[[int], None]
) -> list[Done]:
    """Work on items in threads."""
    with ThreadPoolExecutor(workers, thread_name_prefix="softcat-member") as pool:
        try:
            futures = [pool.submit(work, item) for item in items]
            for done, future in enumerate(as_completed(futures), start=1):
                future.result()
                told(done)
        finally:
            stop.tell()
            pool.shutdown(cancel_futures=True)
    return [future.result() for future in futures]


def _run(member: Member, workshop: Workshop, stop: Stop) -> Record:
    begun = time.perf_counter()
    scene = member.scene
    stop.update(0.0, None)
    prepared = workshop.prepare(member)
    solution = prepared.solve(stop)
    # Without velocities the work against the necking gradient is summed over frames.
    judged = _first_and_last(solution) if prepared.graph.has_velocities else solution
    outcome, message, residual = verdict(member, prepared, judged)
    midpoint = np.full(scene.run.frames, np.nan)
    heights = midpoint_heights(prepared.graph, solution) * rest_length(scene)
    midpoint[: len(solution.time)] = heights + 0.0  # no minus zero
    reached = float(solution.time[-1]) * prepared.scale
    wall = time.perf_counter() - begun
    return Record(midpoint, outcome, message, reached, residual, solution.steps, wall)


def _first_and_last(solution: Solution) -> Solution:
    ends = [0, -1]
    return replace(
        solution,
        time=solution.time[ends],
        x=solution.x[:, ends],
        z=solution.z[:, ends],
        quad=solution.quad[:, ends],
    )


_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")


@dataclass(frozen=True)
class Ensemble:
    """Finished members, in the order of the table.

    Attributes
    ----------
    scenes : tuple of Scene
        What each member is.
    data : xarray.Dataset
        Dims ``member`` and ``time``. Variables ``midpoint`` (member, time) [m], NaN after the time that a member has
        reached; and for each member ``midpoint_final`` [m] and ``time_final`` [s] (the last frame reached),
        ``outcome`` (name of the `Outcome`), ``complaint``, ``energy_residual`` (between first and last frame),
        ``effects``, ``steps`` and ``wall_s``. Every column of the table is a coordinate along ``member``, quantities in
        SI. ``time`` is in seconds where all members last equally long; otherwise it is the share of each member's own
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

    def trajectory(self, member: int) -> Trajectory:
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


def collect(
    scene: Scene, rows: Sequence[Row], members: Sequence[Member], records: Sequence[Record], notes: dict[str, str]
) -> Ensemble:
    """Records become a Dataset."""
    import xarray as xr

    scenes = tuple(member.scene for member in members)
    durations = np.array([one.run.duration for one in scenes])
    alike = bool(np.all(durations == durations[0]))
    share = np.linspace(0.0, 1.0, scene.run.frames)
    if alike:
        time = ("time", share * durations[0], {"units": "s", "long_name": "time"})
    else:
        time = ("time", share, {"units": "1", "long_name": "time over the duration of the member"})
    variables = _variables(members, records)
    if not alike:
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
    each: dict[str, tuple[Any, dict[str, str]]] = {
        "midpoint_final": (
            midpoint[np.arange(len(last)), last],
            {"units": "m", "long_name": "height of the midpoint in the last frame reached, negative down"},
        ),
        "time_final": ([r.reached for r in records], {"units": "s", "long_name": "time of the last frame reached"}),
        "outcome": ([r.outcome.name for r in records], {"long_name": "how the run ended"}),
        "message": ([r.message for r in records], {"long_name": "why, if that is no success"}),
        "energy_residual": (
            [r.energy_residual for r in records],
            {"units": "1", "long_name": "energy imbalance of the last frame against the first, of the largest energy"},
        ),
        "effects": ([", ".join(member.effects.names) for member in members], {"long_name": "effects in force"}),
        "steps": ([r.steps for r in records], {"long_name": "steps of the integrator"}),
        "wall_s": (
            [r.wall for r in records],
            {"units": "s", "long_name": "wall time, side by side with other members"},
        ),
    }
    whole = {"units": "m", "long_name": "height of the midpoint X = 0, negative down; NaN where it was not reached"}
    found: dict[str, Any] = {"midpoint": (("member", "time"), midpoint, whole)}
    return found | {name: (("member",), np.asarray(values), note) for name, (values, note) in each.items()}


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
) -> Ensemble:
    """Run a filament for every row of a table of parameters.

    Members run through the compiled solver in threads; where there is none for a scene, one after the other.

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
        Told about members done and time left, such as :class:`softcat_sym.ensemble.MembersBar`.
    effects : {"once", "each"}
        Whether effects are chosen for the scene and hold for all rows (anew only where rows change a choice, such as
        the law or an end, or whether a number is zero), or for each row by itself. Either way no run is repeated with
        more effects.

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
    threads, rows = workers_of(workers), rows_of(parameters)
    with watched() as interrupts:
        try:
            return _simulated(scene, rows, threads, progress or NobodyListens(), effects)
        finally:
            interrupts.check()


def _simulated(scene: Scene, rows: list[Row], threads: int, progress: MembersProgress, choosing: Choosing) -> Ensemble:
    begun = time.perf_counter()
    members = members_of(scene, rows, choosing)
    if not all(member.parallel for member in members):
        # CasADi keeps Python's lock while it integrates: threads would only wait for each other.
        threads = 1
    records = run_all(members, Workshop(), threads, progress)
    notes = {
        "effects_chosen": choosing,
        "effects": json.dumps(members[0].effects.reasons),
        "backend": "; ".join(sorted({str(member.backend) for member in members})),
        "workers": str(threads),
        "wall_s": f"{time.perf_counter() - begun:.6g}",
    }
    return collect(scene, rows, members, records, notes)
