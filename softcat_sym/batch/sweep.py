"""Sweeps: a scene run for every value of some parameters, in constant memory, on cores or a cluster."""

from __future__ import annotations

import contextlib
import json
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from concurrent import futures
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import IO, Any, Final

import numpy as np
import pandas as pd
import xarray as xr

from softcat_sym import store
from softcat_sym.batch.executor import MembersProgress, Where
from softcat_sym.batch.members import Member
from softcat_sym.batch.plan import SweepPlan, plan_sweep
from softcat_sym.batch.records import (
    Batch,
    Record,
    RecordColumn,
    Table,
    Variables,
    append,
    unpacked,
    variables_of,
    versions,
)
from softcat_sym.batch.reference_member import (
    RESOLUTION,
    ReferenceMember,
    reference_member,
    resolution_of,
    resolution_of_run,
)
from softcat_sym.batch.worker import MemberRun, RowWork, shared_by
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Drawable
from softcat_sym.errors import Fault, SceneError
from softcat_sym.files import fill_atomically, named, new_folder, written_together
from softcat_sym.results.fields import displacements
from softcat_sym.results.motion import observed_motion, time_to_share
from softcat_sym.results.netcdf import netcdf_file
from softcat_sym.results.verdict import measures, missing_effect
from softcat_sym.scene.reading import Changes, SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.single_run import STEP_SIZE_OUTCOMES
from softcat_sym.solvers.solution import watched

SHAPE_FRAMES, SHAPE_NODES = 21, 41
STORE, TABLE = "sweep.nc", "sweep.csv"

_COLUMNS: Final[Mapping[str, RecordColumn]] = {
    "outcome": RecordColumn(
        "", "how the run ended; refused: invalid scene; failed: error of the program; lost: its worker died", dtype=str
    ),
    "regime": RecordColumn("", "regime that the run shows; empty if the run is no answer", dtype=str),
    "message": RecordColumn("", "why the run is no answer", dtype=str),
    "midpoint_final": RecordColumn("m", "height of midspan at the end, negative down"),
    "sag_largest": RecordColumn("m", "largest sag of midspan, positive down"),
    "sag_over_span": RecordColumn("1", "largest sag of midspan over the span"),
    "time_to_90": RecordColumn("s", "time at which the sag first reaches 90 % of its last value"),
    "largest_stretch": RecordColumn("1", "largest stretch of the centreline, at any place and time"),
    "energy_residual": RecordColumn("1", "imbalance of energy over the largest energy"),
    "wall_s": RecordColumn("s", "wall time, while other members run in parallel"),
    **RESOLUTION,
    "span": RecordColumn("m", "span of the filament"),
    "thickness": RecordColumn("m", "thickness of the undeformed filament"),
    "duration": RecordColumn("s", "duration of the run"),
}
"""Columns of the table."""

_MIDPOINT: Final = {
    "midpoint": RecordColumn("m", "height of midspan, negative down; NaN where there is no answer", ("frame",))
}
_SHAPES: Final[Mapping[str, RecordColumn]] = {
    name: RecordColumn(
        unit, f"{meaning}, at equal steps of time and material", ("shape_frame", "shape_node"), dtype=np.float32
    )
    for name, unit, meaning in (
        ("x", "m", "across"),
        ("y", "m", "height"),
        ("stretch", "1", "stretch of the centreline"),
    )
}


def _shapes(time: Floats, fields: Mapping[str, Floats], nodes: Floats, cells: Floats) -> Record:
    """Shapes at equal steps of time and material, linear between frames and nodes."""
    places = np.linspace(nodes[0], nodes[-1], SHAPE_NODES)
    instants = np.linspace(time[0], time[-1], SHAPE_FRAMES)
    after = np.clip(np.searchsorted(time, instants), 1, len(time) - 1)
    part = np.clip((instants - time[after - 1]) / (time[after] - time[after - 1]), 0.0, 1.0)[:, None]
    shapes = {}
    for name, at in (("x", nodes), ("y", nodes), ("stretch", cells)):
        frames = (1 - part) * fields[name][after - 1] + part * fields[name][after]
        shapes[name] = [np.interp(places, at, row) for row in frames]
    return shapes


@dataclass(frozen=True)
class SweepWork(RowWork):
    """Runs the member of a row of a sweep."""

    shapes: bool
    estimate: bool
    reference: ReferenceMember  # The member whose resolution all share

    def observe(self, member: Member) -> Record:
        """Run the member as :func:`simulate_many` does, or by :func:`simulate` where that would do more."""
        scene = member.scene
        if self.estimate:
            return self._simulated(scene)
        run = self.run(self.reference.refine(member))
        resolution = resolution_of(run.member, run.prepared)
        too_long = run.outcome in STEP_SIZE_OUTCOMES and scene.numerics.rtol is None
        if too_long or _has_missing_effect(run):
            # A rare case: a single run would be repeated here, so the member is repeated as one, one at a time.
            with shared_by(self.scene).structures.alone():
                rtol = {"numerics.rtol": scene.numerics.rtol}
                return self._simulated(without_estimate(run.member.scene).replace(rtol))
        if not run.outcome.is_success:
            return {"outcome": run.outcome.name, "message": run.message}
        sag = -float(np.min(run.extremes.height))
        known = {"regime": run.regime, "energy_residual": run.energy_residual}
        return self._measured(scene, sag, run.time, run.fields, run.nodes, run.cells) | known | resolution

    def _simulated(self, scene: Scene) -> Record:
        """Run the member by :func:`softcat_sym.simulate`, with every check, and with a repetition if it needs one."""
        run = simulated(scene)
        summary = run.summary
        if not run.outcome.is_success:
            return {"outcome": run.outcome.name, "message": summary["message"]}
        known = {"regime": summary["regime"] or "", "energy_residual": summary["energy_residual"]}
        data = run.data.time.values, run.fields, run.data.X_node.values, run.data.X_cell.values
        return self._measured(scene, -summary["midpoint_lowest_m"], *data) | known | resolution_of_run(run)

    def _measured(
        self, scene: Scene, sag: float, time: Floats, fields: Mapping[str, Floats], nodes: Floats, cells: Floats
    ) -> dict[str, Any]:
        """What is measured in frames."""
        # Adding zero leaves no minus zero.
        height = fields["y"][:, fields["y"].shape[1] // 2] + 0.0
        return {
            "outcome": "solved",
            "midpoint": height,
            "midpoint_final": float(height[-1]),
            "sag_largest": sag,
            "sag_over_span": sag / rest_length(scene),
            "time_to_90": time_to_share(time, -height),
            "largest_stretch": float(np.max(fields["stretch"])),
            **(_shapes(time, fields, nodes, cells) if self.shapes else {}),
        }


def _has_missing_effect(run: MemberRun) -> bool:
    """Whether the finished run calls for an effect that the program has left out."""
    scene, effects = run.member.scene, run.member.effects
    if scene.run.effects != "auto":
        return False
    time, places, graph = run.solution.time * run.prepared.scale, (run.nodes, run.cells), run.prepared.graph
    moved = displacements(scene, time, run.fields, run.nodes, graph)
    motion = observed_motion(scene, effects, time, places, run.fields, moved, run.extremes)
    return bool(missing_effect(scene, effects, measures(scene, effects, motion), run.outcome))


class _Parts:
    """Finished blocks in a file, in the order in which they finish, so that memory does not grow with their number."""

    def __init__(self, plan: SweepPlan, columns: Mapping[str, RecordColumn], file: IO[bytes]) -> None:
        self._plan, self._columns, self._file = plan, columns, file
        self.places: dict[int, tuple[int, int]] = {}

    def put(self, number: int, content: bytes) -> None:
        """Add a block."""
        self.places[number] = self._file.seek(0, 2), len(content)
        self._file.write(content)

    def __iter__(self) -> Iterator[tuple[int, Table]]:
        """The first member and the table of each block, in order."""
        for number in range(len(self.places)):
            place, size = self.places[number]
            self._file.seek(place)
            yield number * self._plan.block_size, unpacked(self._file.read(size))

    def variables(self, start: int, table: Table) -> Variables:
        """A block as it is in ``sweep.nc``."""
        plan = self._plan
        values = plan.varied_values(plan.rows(start, len(table)))
        varied = {column.key: (("member",), values[column.key], column.attrs) for column in plan.columns}
        share = np.linspace(0.0, 1.0, plan.scene.run.frames)
        frame = (("frame",), share, {"units": "1", "long_name": "time over the duration of the member"})
        return {"frame": frame, **varied, **variables_of(table, self._columns)}


@dataclass
class Counts:
    """Numbers of members by outcome and by regime."""

    outcomes: Counter[str] = field(default_factory=Counter)
    regimes: Counter[str] = field(default_factory=Counter)
    refusal: str = ""  # Why the first member without an answer has none


def _write(plan: SweepPlan, parts: _Parts, directory: Path, reference: ReferenceMember) -> Counts:
    """Join the blocks into ``sweep.nc`` and ``sweep.csv``, a row for each member."""
    counts, scene = Counts(), plan.scene
    about = {"title": scene.title, "scene": scene.to_toml(), "section": scene.filament.section}
    about |= {"plan": plan.digest, "mode": plan.mode, "centre": json.dumps(reference.to_dict(), default=str)}
    units = {c.key: c.units for c in plan.columns} | {name: column.units for name, column in _COLUMNS.items()}
    headed = {
        name: name if unit in ("", "1") or name.endswith("_s") else f"{name} [{unit}]" for name, unit in units.items()
    }

    def fill_store(passing: Path) -> None:
        with netcdf_file(passing) as (file, check):
            file.attrs.update(about)
            for start, table in parts:
                append(file, parts.variables(start, table), start, plan.members)
                counts.outcomes.update(table["outcome"].tolist())
                counts.regimes.update(filter(None, table["regime"].tolist()))
                counts.refusal = counts.refusal or next(filter(None, table["message"].tolist()), "")
                check()

    def fill_table(passing: Path) -> None:
        with passing.open("x", newline="", encoding="utf-8") as stream:
            for start, table in parts:
                values = plan.varied_values(plan.rows(start, len(table))) | {name: table[name] for name in _COLUMNS}
                frame = pd.DataFrame({header: values[name] for name, header in headed.items()})
                frame.index = pd.RangeIndex(start, start + len(frame), name="member")
                frame.to_csv(stream, header=start == 0, lineterminator="\n")

    with written_together():
        fill_atomically(directory / STORE, fill_store)
        fill_atomically(directory / TABLE, fill_table)
    return counts


@dataclass(frozen=True)
class Sweep(Drawable):
    """A finished sweep.

    Attributes
    ----------
    plan : SweepPlan
        The plan of the members.
    path : pathlib.Path
        The store, ``sweep.nc``.
    counts : Counts
        Numbers of members by outcome and by regime.
    resumed : int
        Number of members that were taken from an earlier command.
    place : str
        Where the members ran: threads, or a cluster.
    wall_s : float
        Wall time [s].
    peak_memory : float
        Largest memory of this process so far [MB].
    centre : ReferenceMember
        The member in the middle, with its cells, fibres, rtol and estimated error; all others are at least as fine.
    loaded : xarray.Dataset or None
        The results in memory, if they are no longer on disk.
    """

    plan: SweepPlan
    path: Path
    counts: Counts
    resumed: int
    place: str
    wall_s: float
    peak_memory: float
    centre: ReferenceMember
    loaded: xr.Dataset | None = None

    def __len__(self) -> int:
        return self.plan.members

    @cached_property
    def data(self) -> xr.Dataset:
        """The store, dims ``member`` and ``frame``, read from disk on use.

        A variable for each varied key, ``outcome``, ``regime``, ``message``, ``midpoint`` [m] and numbers of each
        member; with shapes ``x``, ``y`` [m] and ``stretch``.
        """
        return self.loaded if self.loaded is not None else xr.open_dataset(self.path, engine="h5netcdf")

    def __repr__(self) -> str:
        outcomes = ", ".join(f"{name} {count}" for name, count in sorted(self.counts.outcomes.items()))
        return f"Sweep {self.plan.scene.title!r}: {len(self)} filaments ({outcomes})\n  .data, .to_dict(), {self.path}"

    def in_memory(self) -> Sweep:
        """The sweep with its data loaded into memory, independent of the file."""
        return replace(self, loaded=xr.load_dataset(self.path, engine="h5netcdf"))

    def to_dict(self) -> dict[str, Any]:
        """Content of ``sweep.json``."""
        ran = len(self) - self.resumed
        return {
            "title": self.plan.scene.title,
            "plan": self.plan.to_dict(),
            "centre": self.centre.to_dict(),
            "digest": self.plan.digest,
            "outcomes": dict(sorted(self.counts.outcomes.items())),
            "regimes": dict(sorted(self.counts.regimes.items())),
            "place": self.place,
            "wall_s": self.wall_s,
            "resumed_members": self.resumed,
            "members_per_second": ran / self.wall_s if self.wall_s > 0 else None,
            "peak_memory_MB": self.peak_memory,
            "versions": versions(),
        }

    summary = to_dict


def peak_memory() -> float:
    """Largest resident memory of this process so far [MB]; zero where the system does not provide it."""
    # On Linux getrusage includes the peak of the parent process.
    with contextlib.suppress(OSError):
        lines = Path("/proc/self/status").read_text(encoding="utf-8").splitlines()
        for line in lines:
            if line.startswith("VmHWM:"):
                return float(line.split()[1]) * 1.024e-3  # kB of 1024 bytes
    try:
        import resource
    except ImportError:
        return 0.0
    largest = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return largest / (1e6 if sys.platform == "darwin" else 1e3)


Vary = Mapping[str, Sequence[object] | str] | Sequence[str] | Path
"""Values by dotted key, texts as on the command line, or the path of a CSV file."""


def sweep(
    scene: SceneLike,
    vary: Vary,
    directory: str | Path | None = None,
    *,
    mode: str = "grid",
    samples: int | None = None,
    seed: int = 0,
    shapes: bool = False,
    estimate: bool = False,
    workers: int | None = None,
    scheduler: str | None = None,
    local_cluster: int | None = None,
    executor: futures.Executor | None = None,
    fresh: bool = False,
    progress: MembersProgress | None = None,
    changes: Changes = (),
) -> Sweep:
    """Run a filament for every value of some parameters, in constant memory; results go to disk.

    A member that is invalid or fails is a row like the others. Unless ``numerics.estimate = false``, :func:`simulate`
    first runs the member in the middle of the ranges; all members have at least its cells and fibres, and at most its
    tolerance.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The common part of the members.
    vary : mapping, sequence of str, or pathlib.Path
        ``{"groups.G": "0.01:3:40:log", "material.yield_stress": ["5 kPa", 1e4]}``, plain numbers in SI; or texts
        ``"KEY=a:b:n:log"``, ``"KEY=v1,v2"``; or a CSV file whose header names the keys.
    directory : str or pathlib.Path, optional
        For ``sweep.nc`` and ``sweep.csv``, else in memory.
    mode, samples, seed
        ``"grid"``: every combination; ``"zip"``: values side by side; ``"lhs"``: a Latin hypercube of `samples`.
    shapes, estimate : bool
        Keep 21 x 41 points of each shape; run each member by :func:`simulate` with an error estimate, instead of as
        :func:`simulate_many` does.
    workers, scheduler, local_cluster, executor : optional
        Number of threads, by default all cores; or the address of a Dask cluster, ``"tcp://host:8786"``; or a number of
        processes; or any :class:`concurrent.futures.Executor`, such as ``distributed.Client.get_executor()``.
    fresh : bool
        Run every member, even finished ones, which otherwise come from the store, as after an interruption.
    progress : MembersProgress, optional
        Receiver of the number of finished members and the time left, such as
        :class:`softcat_sym.progress.MembersBar`.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

    Raises
    ------
    SoftcatError, KeyboardInterrupt
        If the plan is invalid, before anything runs; if the user stops it.
    """
    where = Where(workers, scheduler, local_cluster, executor)
    base = as_scene(scene, changes)
    plan = plan_sweep(base, vary, mode, samples=samples, seed=seed, shapes=shapes, estimate=estimate)
    with store.fresh(fresh), contextlib.ExitStack() as stack:
        if directory is not None:
            return run_sweep(plan, Path(directory), where, progress)
        passing = stack.enter_context(tempfile.TemporaryDirectory(prefix="softcat-sweep-"))
        return run_sweep(plan, Path(passing), where, progress).in_memory()


def run_sweep(plan: SweepPlan, directory: Path, where: Where, progress: MembersProgress | None = None) -> Sweep:
    """Run the members of a plan that are not in the store yet, and write all of them."""
    begun = time.perf_counter()
    _refuse_plan(plan)
    with (
        new_folder(directory),
        named(directory / STORE),
        tempfile.TemporaryFile(dir=directory) as passing,  # without a name it vanishes however the program ends
        watched(),
    ):
        reference = _reference(plan)
        columns = {**_COLUMNS, **_MIDPOINT, **(_SHAPES if plan.shapes else {})}
        parts = _Parts(plan, columns, passing)
        batch = Batch(
            plan.members,
            plan.block_size,
            lambda number: plan.rows(number * plan.block_size, plan.block_size),
            lambda rows: plan.key(rows, reference),
            columns,
            {"frame": plan.scene.run.frames, "shape_frame": SHAPE_FRAMES, "shape_node": SHAPE_NODES},
        )
        for found in batch.recalled():
            parts.put(*found)
        missing = [number for number in range(batch.blocks) if number not in parts.places]
        left = sum(map(batch.size, missing))
        place = "nothing left to run"
        if missing:
            with watched(), where.pool(left) as pool:
                place = str(pool)
                work = SweepWork(plan.scene, pool.stop, plan.shapes, plan.estimate, reference)
                for found in batch.run(missing, work, pool, plan.block_size, progress):
                    parts.put(*found)
        counts = _write(plan, parts, directory, reference)
    wall, resumed = time.perf_counter() - begun, plan.members - left
    return Sweep(plan, directory / STORE, counts, resumed, place, wall, peak_memory(), reference)


def _reference(plan: SweepPlan) -> ReferenceMember:
    """The member in the middle, run with an error estimate, unless every member is."""
    if plan.estimate:
        return ReferenceMember(plan.middle, why_not="each is estimated by itself")
    try:
        return reference_member(shared_by(plan.scene).maker.member(plan.middle), plan.middle)
    except SceneError as error:
        why = "; ".join(map(str, error.faults))
        return ReferenceMember(plan.middle, why_not=f"the middle one is refused, {why}")


def _refuse_plan(plan: SweepPlan) -> None:
    """Refuse a plan without any member that can be run, and keys that no scene has."""
    for key, value in plan.unknown_keys():
        plan.scene.replace({key: value})
    maker, refusals = shared_by(plan.scene).maker, list[str]()
    for member in (0, plan.members - 1, plan.members // 2, *range(plan.members)):
        try:
            maker.member(plan.row(member))
        except SceneError as error:
            refusals = refusals or ["; ".join(map(str, error.faults))]
        else:
            return
    found = f"every one of the {plan.members} members is refused; the first: {refusals[0]}"
    raise SceneError([Fault("", found, "")], "of a sweep")
