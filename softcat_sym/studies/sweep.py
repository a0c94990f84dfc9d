"""Sweeps: a scene run for every value of some parameters, in constant memory, on cores or a cluster."""

from __future__ import annotations

import contextlib
import importlib.metadata
import json
import math
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym import store
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.drawing import Drawable
from softcat_sym.ensemble.centre import RESOLUTION, Centre, centre_of, used, used_by
from softcat_sym.ensemble.ensemble import MemberRun, judged, study_of
from softcat_sym.ensemble.executor import Executor, Lost, MembersProgress, Stop, check_executor, counted, executor
from softcat_sym.ensemble.members import Row
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.files import fill_atomically, made, named, written_together
from softcat_sym.results.fields import displacements
from softcat_sym.results.motion import observed_motion
from softcat_sym.results.netcdf import netcdf_file
from softcat_sym.results.verdict import measures, missing_effect
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.single_run import OF_A_STEP_TOO_LONG
from softcat_sym.solvers.solution import watched
from softcat_sym.studies.sweep_table import SweepPlan, plan_sweep

if TYPE_CHECKING:
    import xarray as xr

REFUSED, FAILED, LOST = "refused", "failed", "lost"
"""Outcomes of members without a run: an invalid scene, an error of the program, workers that died."""

SHAPE_FRAMES, SHAPE_NODES = 21, 41
STORE, TABLE = "sweep.nc", "sweep.csv"

_ERRORS = (SoftcatError, RuntimeError, ArithmeticError, ValueError)
"""Errors that end a member without ending the sweep."""

_ABOUT: Final[Mapping[str, tuple[str, str]]] = {
    "outcome": ("", "how the run ended; refused: invalid scene; failed: error of the program; lost: its worker died"),
    "regime": ("", "regime that the run shows; empty if the run is no answer"),
    "message": ("", "why the run is no answer"),
    "midpoint_final": ("m", "height of midspan at the end, negative down"),
    "sag_largest": ("m", "largest sag of midspan, positive down"),
    "sag_over_span": ("1", "largest sag of midspan over the span"),
    "time_to_90": ("s", "time at which the sag first reaches 90 % of its last value"),
    "largest_stretch": ("1", "largest stretch of the centreline, at any place and time"),
    "energy_residual": ("1", "imbalance of energy over the largest energy"),
    "wall_s": ("s", "wall time, while other members run in parallel"),
    **{name: ("1", words) for name, words in RESOLUTION.items()},
    "span": ("m", "span of the filament"),
    "thickness": ("m", "thickness of the undeformed filament"),
    "duration": ("s", "duration of the run"),
}
_SHAPES: Final = (("x", "m", "across"), ("y", "m", "height"), ("stretch", "1", "stretch of the centreline"))
_TEXTS: Final = ("outcome", "regime", "message")
_MEMBERS, _MEMBERS_OF_FRAMES, _MEMBERS_OF_SHAPES = 256, 64, 16
"""Members of a chunk of the store."""
_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")

Columns = dict[str, npt.NDArray[Any]]


@dataclass(frozen=True)
class MemberResult:
    """A row of a sweep; numbers as `_ABOUT` has them, NaN where there is no answer."""

    outcome: str
    regime: str
    message: str
    midpoint: Floats  # shape (frames,); [m]
    midpoint_final: float = math.nan
    sag_largest: float = math.nan
    sag_over_span: float = math.nan
    time_to_90: float = math.nan
    largest_stretch: float = math.nan
    energy_residual: float = math.nan
    wall_s: float = math.nan
    cells: float = math.nan
    fibres: float = math.nan
    rtol: float = math.nan
    error_estimate: float = math.nan
    span: float = math.nan
    thickness: float = math.nan
    duration: float = math.nan
    # shape (3, SHAPE_FRAMES, SHAPE_NODES): x [m], y [m] and stretch at equal steps of time and of material
    shapes: npt.NDArray[np.float32] | None = None


def time_to_share(time: Floats, sag: Floats, share: float = 0.9) -> float:
    """Time at which the sag first reaches a share of its last value [s], linear between frames; NaN if it rises."""
    if not sag[-1] > 0:
        return math.nan
    level = share * float(sag[-1])
    frame = int(np.argmax(sag >= level))
    if frame == 0:
        return float(time[0])
    before, after = float(sag[frame - 1]), float(sag[frame])
    part = (level - before) / (after - before)
    return float(time[frame - 1] + part * (time[frame] - time[frame - 1]))


def _shapes(time: Floats, fields: Mapping[str, Floats], nodes: Floats, cells: Floats) -> npt.NDArray[np.float32]:
    """Shapes at equal steps of time and material, linear between frames and nodes."""
    places = np.linspace(nodes[0], nodes[-1], SHAPE_NODES)
    instants = np.linspace(time[0], time[-1], SHAPE_FRAMES)
    after = np.clip(np.searchsorted(time, instants), 1, len(time) - 1)
    part = np.clip((instants - time[after - 1]) / (time[after] - time[after - 1]), 0.0, 1.0)[:, None]
    shapes = np.empty((3, SHAPE_FRAMES, SHAPE_NODES), dtype=np.float32)
    for k, (name, at) in enumerate((("x", nodes), ("y", nodes), ("stretch", cells))):
        frames = (1 - part) * fields[name][after - 1] + part * fields[name][after]
        shapes[k] = [np.interp(places, at, row) for row in frames]
    return shapes


@dataclass(frozen=True)
class MemberWork:
    """Runs the member of a row; it can be sent to another process."""

    scene: Scene  # The common part of the members
    shapes: bool
    estimate: bool
    stop: Stop
    centre: Centre  # The member whose resolution all share

    def __call__(self, row: Row) -> MemberResult:
        """The row's result, even if its run fails."""
        begun, study, scene = time.perf_counter(), study_of(self.scene), None
        try:
            with study.workshop.alone():
                member = study.maker.member(row)
            scene = member.scene
            if self.estimate:
                return self._simulated(scene, begun)
            member = self.centre.of(member)
            run = judged(member, *study.workshop.run(member, self.stop))
            too_long = run.outcome in OF_A_STEP_TOO_LONG and scene.numerics.rtol is None
            if too_long or _has_missing_effect(run):
                # A rare case: a single run would be repeated here, so the member is repeated as one, one at a time.
                with study.workshop.alone():
                    own = {"numerics.rtol": scene.numerics.rtol}
                    return self._simulated(without_estimate(member.scene).replace(own), begun)
        except SceneError as error:
            return self.without_answer(REFUSED, "; ".join(map(str, error.faults)), scene, begun)
        except _ERRORS as error:
            message = " ".join(str(error).split()) or type(error).__name__
            return self.without_answer(FAILED, message, scene, begun)
        if not run.outcome.is_success:
            return self.without_answer(run.outcome.name, run.message, scene, begun)
        times, places = run.solution.time * run.prepared.scale, (run.nodes, run.cells)
        how = used(member, run.prepared)
        regime, sag = run.regime or "", -float(np.min(run.extremes.height))
        return self._answer(scene, regime, times, run.fields, places, sag, run.energy_residual, begun, how)

    def without_answer(
        self, outcome: str, message: str, scene: Scene | None = None, begun: float = math.nan
    ) -> MemberResult:
        """A member without results; it has the sizes of its scene, if there is one."""
        nothing = np.full(self.scene.run.frames, np.nan)
        if scene is None:
            return MemberResult(outcome, "", message, nothing)
        size: dict[str, Any] = {
            "span": rest_length(scene),
            "thickness": scene.filament.thickness,
            "duration": scene.run.duration,
        }
        return MemberResult(outcome, "", message, nothing, wall_s=time.perf_counter() - begun, **size)

    def _simulated(self, scene: Scene, begun: float) -> MemberResult:
        """A member by :func:`softcat_sym.simulate`, with every check, and with a repetition if the run needs one."""
        run = simulated(scene)
        if not run.outcome.is_success:
            return self.without_answer(run.outcome.name, run.summary["message"], scene, begun)
        fields = {name: run.data[name].values for name in ("x", "y", "stretch")}
        places = (run.data.X_node.values, run.data.X_cell.values)
        residual, regime = float(run.summary["energy_residual"]), str(run.summary["regime"] or "")
        sag, times = -float(run.summary["midpoint_lowest_m"]), run.data.time.values
        return self._answer(scene, regime, times, fields, places, sag, residual, begun, used_by(run))

    def _answer(
        self,
        scene: Scene,
        regime: str,
        times: Floats,
        fields: Mapping[str, Floats],
        places: tuple[Floats, Floats],
        sag: float,
        residual: float,
        begun: float,
        how: dict[str, float],
    ) -> MemberResult:
        height = fields["y"][:, fields["y"].shape[1] // 2] + 0.0  # no minus zero
        return MemberResult(
            "solved",
            regime,
            "",
            height,
            midpoint_final=float(height[-1]),
            sag_largest=sag,
            sag_over_span=sag / rest_length(scene),
            time_to_90=time_to_share(times, -height),
            largest_stretch=float(np.max(fields["stretch"])),
            energy_residual=residual,
            wall_s=time.perf_counter() - begun,
            span=rest_length(scene),
            thickness=scene.filament.thickness,
            duration=scene.run.duration,
            shapes=_shapes(times, fields, *places) if self.shapes else None,
            **how,
        )


def _has_missing_effect(run: MemberRun) -> bool:
    """Whether the finished run calls for an effect that the program has left out."""
    scene, effects = run.member.scene, run.member.effects
    if scene.run.effects != "auto":
        return False
    time, places, graph = run.solution.time * run.prepared.scale, (run.nodes, run.cells), run.prepared.graph
    moved = displacements(scene, time, run.fields, run.nodes, graph)
    motion = observed_motion(scene, effects, time, places, run.fields, moved, run.extremes)
    return bool(missing_effect(scene, effects, measures(scene, effects, motion), run.outcome))


def _packed(results: Sequence[MemberResult]) -> bytes:
    """The results of a block: a column for each variable, ``shapes`` (members, 3, frames, nodes) if there are any."""
    columns: Columns = {}
    for name in _ABOUT:
        kind: Any = np.str_ if name in _TEXTS else float
        columns[name] = np.array([getattr(result, name) for result in results], dtype=kind)
    columns["midpoint"] = np.stack([result.midpoint for result in results])
    if any(result.shapes is not None for result in results):
        nothing = np.full((len(_SHAPES), SHAPE_FRAMES, SHAPE_NODES), np.nan, dtype=np.float32)
        columns["shapes"] = np.stack([nothing if result.shapes is None else result.shapes for result in results])
    return store.packed(columns)


class _Blocks:
    """Finished blocks in a file, in the order in which they finish, so that memory does not grow with their number."""

    def __init__(self, plan: SweepPlan, file: IO[bytes]) -> None:
        self._plan, self._file, self._places = plan, file, dict[int, tuple[int, int]]()

    def __contains__(self, number: int) -> bool:
        return number in self._places

    def put(self, number: int, content: bytes) -> None:
        """Add a block."""
        self._places[number] = self._file.seek(0, 2), len(content)
        self._file.write(content)

    def parts(self) -> Iterator[tuple[int, Columns]]:
        """The first member and the columns of each block, varied values included, in order."""
        for number in range(self._plan.blocks):
            place, size = self._places[number]
            self._file.seek(place)
            part = store.unpacked(self._file.read(size))
            rows = self._plan.block(number)
            yield number * self._plan.block_size, self._plan.varied_values(rows) | part


@dataclass
class Counts:
    """Numbers of members by outcome and by regime."""

    outcomes: Counter[str] = field(default_factory=Counter)
    regimes: Counter[str] = field(default_factory=Counter)


def _write_store(plan: SweepPlan, blocks: _Blocks, directory: Path, centre: Centre) -> Counts:
    """Join the blocks into ``sweep.nc``."""
    counts = Counts()

    def fill(passing: Path) -> None:
        with netcdf_file(passing) as (file, check):
            _make_variables(file, plan)
            file.attrs["centre"] = json.dumps(centre.to_dict(), default=str)
            for start, part in blocks.parts():
                rows = slice(start, start + len(part["outcome"]))
                for name in (*plan.keys, *_ABOUT, "midpoint"):
                    values = part[name]
                    file.variables[name][rows] = values.astype(object) if values.dtype.kind == "U" else values
                for k, (name, _, _) in enumerate(_SHAPES if plan.shapes else ()):
                    file.variables[name][rows] = part["shapes"][:, k] if "shapes" in part else np.nan
                counts.outcomes.update(part["outcome"].tolist())
                counts.regimes.update(regime for regime in part["regime"].tolist() if regime)
                check()

    fill_atomically(directory / STORE, fill)
    return counts


def _make_variables(file: Any, plan: SweepPlan) -> None:
    """Dimensions and empty variables."""
    import h5py

    frames, members = plan.scene.run.frames, plan.members
    file.dimensions = {"member": members, "frame": frames}
    file.attrs.update(
        {"title": plan.scene.title, "scene": plan.scene.to_toml(), "section": plan.scene.filament.section}
        | {"plan": plan.digest, "mode": plan.mode}
    )
    text = h5py.string_dtype()
    packing = {"compression": "gzip", "compression_opts": 4, "shuffle": True}

    def make(name: str, dtype: Any, about: Mapping[str, Any], chunk: int = _MEMBERS, *dims: str) -> None:
        chunks = (min(members, chunk), *(file.dimensions[dim].size for dim in dims))
        options = {} if dtype is text else packing
        file.create_variable(name, ("member", *dims), dtype=dtype, chunks=chunks, **options).attrs.update(about)

    share = {"units": "1", "long_name": "time over the duration of the member"}
    file.create_variable("frame", ("frame",), data=np.linspace(0.0, 1.0, frames)).attrs.update(share)
    for column in plan.columns:
        about: dict[str, Any] = {"varied": 1, "scale": column.scale} | ({"units": column.units} if column.units else {})
        make(column.key, text if column.is_text else float, about)
    for name, (unit, meaning) in _ABOUT.items():
        make(name, text if name in _TEXTS else float, {"long_name": meaning} | ({"units": unit} if unit else {}))
    about = {"units": "m", "long_name": "height of midspan, negative down; NaN where there is no answer"}
    make("midpoint", float, about, _MEMBERS_OF_FRAMES, "frame")
    if plan.shapes:
        file.dimensions["shape_frame"], file.dimensions["shape_node"] = SHAPE_FRAMES, SHAPE_NODES
    for name, unit, meaning in _SHAPES if plan.shapes else ():
        about = {"units": unit, "long_name": f"{meaning}, at equal steps of time and material"}
        make(name, np.float32, about, _MEMBERS_OF_SHAPES, "shape_frame", "shape_node")


def _write_table(plan: SweepPlan, blocks: _Blocks, directory: Path) -> None:
    """Write ``sweep.csv``: a row for each member."""
    import pandas as pd

    headed = {name: name if unit in ("", "1") or name.endswith("_s") else f"{name} [{unit}]"
              for name, (unit, _) in _ABOUT.items()}  # fmt: skip
    headed |= {c.key: c.key if c.units in ("", "1") else f"{c.key} [{c.units}]" for c in plan.columns}

    def fill(passing: Path) -> None:
        with passing.open("x", newline="", encoding="utf-8") as stream:
            for start, part in blocks.parts():
                frame = pd.DataFrame({headed[name]: part[name] for name in (*plan.keys, *_ABOUT)})
                frame.index = pd.RangeIndex(start, start + len(frame), name="member")
                frame.to_csv(stream, header=start == 0, lineterminator="\n")

    fill_atomically(directory / TABLE, fill)


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
    centre : Centre
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
    centre: Centre
    loaded: xr.Dataset | None = None

    def __len__(self) -> int:
        return self.plan.members

    @cached_property
    def data(self) -> xr.Dataset:
        """The store, dims ``member`` and ``frame``, read from disk on use.

        A variable for each varied key, ``outcome``, ``regime``, ``message``, ``midpoint`` [m] and numbers of each
        member; with shapes ``x``, ``y`` [m] and ``stretch``.
        """
        import xarray as xr

        return self.loaded if self.loaded is not None else xr.open_dataset(self.path, engine="h5netcdf")

    def __repr__(self) -> str:
        outcomes = ", ".join(f"{name} {count}" for name, count in sorted(self.counts.outcomes.items()))
        return f"Sweep {self.plan.scene.title!r}: {len(self)} filaments ({outcomes})\n  .data, .to_dict(), {self.path}"

    def in_memory(self) -> Sweep:
        """The sweep with its data loaded into memory, independent of the file."""
        import xarray as xr

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
            "versions": {name: importlib.metadata.version(name) for name in _VERSIONS},
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
    fresh: bool = False,
    progress: MembersProgress | None = None,
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
    workers, scheduler, local_cluster : optional
        Number of threads, by default all cores; or the address of a Dask cluster, ``"tcp://host:8786"``; or a number of
        processes.
    fresh : bool
        Run every member, even finished ones, which otherwise come from the store, as after an interruption.
    progress : MembersProgress, optional
        Receiver of the number of finished members and the time left, such as
        :class:`softcat_sym.ensemble.MembersBar`.

    Raises
    ------
    SoftcatError, KeyboardInterrupt
        If the plan is invalid, before anything runs; if the user stops it.
    """
    check_executor(workers, scheduler, local_cluster)
    plan = plan_sweep(as_scene(scene), vary, mode, samples=samples, seed=seed, shapes=shapes, estimate=estimate)
    where = (workers, scheduler, local_cluster)
    with store.fresh(fresh), contextlib.ExitStack() as stack:
        if directory is not None:
            return run_sweep(plan, Path(directory), where, progress)
        passing = stack.enter_context(tempfile.TemporaryDirectory(prefix="softcat-sweep-"))
        return run_sweep(plan, Path(passing), where, progress).in_memory()


def run_sweep(
    plan: SweepPlan,
    directory: Path,
    where: tuple[int | None, str | None, int | None],
    progress: MembersProgress | None = None,
) -> Sweep:
    """Run the members of a plan that are not in the store yet, and write all of them."""
    begun = time.perf_counter()
    _refuse_plan(plan)
    with (
        made(directory),
        named(directory / STORE),
        tempfile.TemporaryFile(dir=directory) as passing,  # without a name it vanishes however the program ends
        watched(),
    ):
        blocks, centre = _Blocks(plan, passing), _centre(plan)
        for number in range(plan.blocks):
            content = store.recall(plan.key(number, centre))
            if content is not None:
                blocks.put(number, content)
        missing = [number for number in range(plan.blocks) if number not in blocks]
        before = plan.members - sum(len(plan.block(number)) for number in missing)
        place = "nothing left to run"
        if missing:
            with watched(), executor(*where, members=plan.members - before) as pool:
                place = str(pool)
                _run_blocks(plan, blocks, missing, (pool, centre), before, progress)
        with written_together():
            counts = _write_store(plan, blocks, directory, centre)
            _write_table(plan, blocks, directory)
    return Sweep(plan, directory / STORE, counts, before, place, time.perf_counter() - begun, peak_memory(), centre)


def _centre(plan: SweepPlan) -> Centre:
    """The member in the middle, run with an error estimate, unless every member is."""
    if plan.estimate:
        return Centre(plan.centre, why_not="each is estimated by itself")
    try:
        return centre_of(study_of(plan.scene).maker.member(plan.centre), plan.centre)
    except SceneError as error:
        return Centre(plan.centre, why_not=f"the middle one is refused, {'; '.join(map(str, error.faults))}")


def _run_blocks(
    plan: SweepPlan,
    blocks: _Blocks,
    missing: Sequence[int],
    how: tuple[Executor, Centre],
    before: int,
    progress: MembersProgress | None,
) -> None:
    """Run the members of the missing blocks, and store each block as soon as it is finished."""
    pool, centre = how
    work = MemberWork(plan.scene, plan.shapes, plan.estimate, pool.stop, centre)
    rows = (row for number in missing for row in plan.block(number))
    unfinished: defaultdict[int, dict[int, MemberResult | Lost]] = defaultdict(dict)
    results = pool.map_members(work, rows, plan.block_size)
    for place, result in counted(results, plan.members, before, progress):
        # The last block of a plan may be shorter; no other comes after it.
        number = missing[place // plan.block_size]
        block = unfinished[number]
        block[place] = result
        if len(block) == len(plan.block(number)):
            del unfinished[number]
            ordered = [block[place] for place in sorted(block)]
            is_lost = any(isinstance(result, Lost) for result in ordered)
            content = _packed(
                [work.without_answer(LOST, row.message) if isinstance(row, Lost) else row for row in ordered]
            )
            blocks.put(number, content)
            if not is_lost:
                store.keep(plan.key(number, centre), content)


def _refuse_plan(plan: SweepPlan) -> None:
    """Refuse a plan without any member that can be run, and keys that no scene has."""
    for key, value in plan.unknown_keys():
        plan.scene.replace({key: value})
    order = (0, plan.members - 1, plan.members // 2, *range(plan.members))
    if all(_refusal(plan, member) for member in order):
        found = f"every one of the {plan.members} members is refused; the first: {_refusal(plan, 0)}"
        raise SceneError([Fault("", found, "")], "of a sweep")


def _refusal(plan: SweepPlan, member: int) -> str:
    try:
        study_of(plan.scene).maker.member(plan.row(member))
    except SceneError as error:
        return "; ".join(map(str, error.faults))
    return ""
