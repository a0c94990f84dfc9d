"""Sweeps: a scene run for every value of some parameters, in constant memory, on cores or a cluster."""

from __future__ import annotations

import contextlib
import csv
import importlib.metadata
import math
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cached_property
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from softcat_sym import store
from softcat_sym.discretization.grid import Floats
from softcat_sym.ensemble.ensemble import MembersProgress, NobodyListens, Stop, Workshop, side_by_side
from softcat_sym.ensemble.executor import Count, Told, check_workplace, run_blocks, workplace
from softcat_sym.ensemble.table import Choosing, Member, Row, members_of, pattern_of
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.files import fill_atomically, made, written_together
from softcat_sym.scene.reading import SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.single_run import OF_A_STEP_TOO_LONG
from softcat_sym.solvers.solution import watched
from softcat_sym.studies.phase_runs import judged, shared_workshop
from softcat_sym.studies.sweep_table import SHAPE_FRAMES, SHAPE_NODES, SweepPlan, VariedColumn, columns_of, plan_sweep

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure

REFUSED, FAILED, LOST = "refused", "failed", "lost"
"""Outcomes that no run has: a scene that makes no sense, a program that failed, workers that died."""

Shapes = npt.NDArray[np.float32]


@dataclass(frozen=True)
class MemberResult:
    """A row of a sweep."""

    outcome: str  # Name of the outcome, or `REFUSED`, `FAILED`, `LOST`
    regime: str  # What the run shows; an empty text if it is no answer
    message: str  # Why it is none
    # shape (frames,); Height of midspan [m], negative down; NaN where there is no answer, as all numbers but
    # `wall_s`.
    midpoint: Floats
    midpoint_final: float = math.nan  # At the end, and the largest sag [m], positive down
    sag_largest: float = math.nan
    sag_over_span: float = math.nan  # `sag_largest` over the span
    time_to_90: float = math.nan  # When the sag first reaches 90 % of its last value [s]
    largest_stretch: float = math.nan  # Of the centreline, anywhere and ever
    energy_residual: float = math.nan  # Imbalance of energy over the largest energy
    wall_s: float = math.nan  # Time that it took [s], beside others
    span: float = math.nan  # Of its scene [m], [m], [s]
    thickness: float = math.nan
    duration: float = math.nan
    # shape (3, SHAPE_FRAMES, SHAPE_NODES); x [m], y [m] and stretch at equal steps of time and of material.
    shapes: Shapes | None = None


def no_answer(
    outcome: str, message: str, frames: int, scene: Scene | None = None, *, wall: float = math.nan
) -> MemberResult:
    """A member that gives no numbers; its scene, if there is one, tells how large it was."""
    nothing = np.full(frames, np.nan)
    if scene is None:
        return MemberResult(outcome, "", message, nothing, wall_s=wall)
    size = (rest_length(scene), scene.filament.thickness, scene.run.duration)
    return MemberResult(outcome, "", message, nothing, wall_s=wall, span=size[0], thickness=size[1], duration=size[2])


def answer(
    scene: Scene,
    regime: str,
    time: Floats,
    fields: Mapping[str, Floats],
    places: tuple[Floats, Floats],
    numbers: tuple[float, float],
    *,
    shapes: bool,
) -> MemberResult:
    """What is kept of a run that is an answer."""
    height = fields["y"][:, fields["y"].shape[1] // 2] + 0.0  # no minus zero
    span = rest_length(scene)
    sag = float(np.max(-height))
    return MemberResult(
        "solved",
        regime,
        "",
        height,
        float(height[-1]),
        sag,
        sag / span,
        time_to_share(time, -height),
        float(np.max(fields["stretch"])),
        numbers[0],
        numbers[1],
        span,
        scene.filament.thickness,
        scene.run.duration,
        _shapes(time, fields, places) if shapes else None,
    )


def time_to_share(time: Floats, sag: Floats, share: float = 0.9) -> float:
    """When the sag first reaches a share of its last value [s], between frames by a straight line; NaN if it rises."""
    if not sag[-1] > 0:
        return math.nan
    wanted = share * float(sag[-1])
    frame = int(np.argmax(sag >= wanted))
    if frame == 0:
        return float(time[0])
    before, after = float(sag[frame - 1]), float(sag[frame])
    part = (wanted - before) / (after - before)
    return float(time[frame - 1] + part * (time[frame] - time[frame - 1]))


def _shapes(time: Floats, fields: Mapping[str, Floats], places: tuple[Floats, Floats]) -> Shapes:
    """Shapes at equal steps of time and material, between frames and nodes by straight lines."""
    nodes, cells = places
    wanted = np.linspace(nodes[0], nodes[-1], SHAPE_NODES)
    instants = np.linspace(time[0], time[-1], SHAPE_FRAMES)
    after = np.clip(np.searchsorted(time, instants), 1, len(time) - 1)
    part = np.clip((instants - time[after - 1]) / (time[after] - time[after - 1]), 0.0, 1.0)[:, None]
    kept = np.empty((3, SHAPE_FRAMES, SHAPE_NODES), dtype=np.float32)
    for k, (name, at) in enumerate((("x", nodes), ("y", nodes), ("stretch", cells))):
        shown = (1 - part) * fields[name][after - 1] + part * fields[name][after]
        kept[k] = [np.interp(wanted, at, row) for row in shown]
    return kept


TEXTS: Final = ("outcome", "regime", "message")
NUMBERS: Final = tuple(f.name for f in fields(MemberResult) if f.name not in (*TEXTS, "midpoint", "shapes"))

Columns = dict[str, npt.NDArray[Any]]


def packed(results: Sequence[MemberResult]) -> bytes:
    """Write the results of a block: a column for each variable, ``shapes`` (members, 3, frames, nodes) if kept."""
    columns: Columns = {name: np.array([getattr(one, name) for one in results], dtype=np.str_) for name in TEXTS}
    columns |= {name: np.array([getattr(one, name) for one in results], dtype=float) for name in NUMBERS}
    columns["midpoint"] = np.stack([one.midpoint for one in results])
    known = [one.shapes for one in results if one.shapes is not None]
    if known:
        nothing = np.full_like(known[0], np.nan)
        columns["shapes"] = np.stack([nothing if one.shapes is None else one.shapes for one in results])
    return store.packed(columns)


@dataclass(frozen=True)
class SweepWork:
    """Runs members; it can be sent to another process."""

    scene: Scene  # What they have in common
    digest: str  # Of the plan: blocks of one plan share equations, graphs and C code
    shapes: bool  # As in the plan
    estimate: bool

    def run(self, items: Sequence[Row], threads: int, told: Told) -> list[MemberResult]:
        """Run rows, `threads` at a time; where Python's lock is held while they integrate, one by one."""
        if self.estimate:
            return [self._estimated(row, told) for row in items]
        admitted = admit(self.scene, items)
        found = {k: one for k, one in enumerate(admitted) if isinstance(one, Member)}
        if not all(member.parallel for member in found.values()):
            threads = 1
        stop, workshop = Stop(), shared_workshop(self.digest)
        if len(found) < len(items):
            told(len(items) - len(found))
        ran = side_by_side(
            lambda member: self._ran(member, workshop, stop), [*found.values()], threads, stop, lambda _: told(1)
        )
        results = dict(zip(found, ran, strict=True))
        frames = self.scene.run.frames
        return [results[k] if k in results else no_answer(REFUSED, str(why), frames) for k, why in enumerate(admitted)]

    def lost(self, item: Row, why: str) -> MemberResult:
        """The row of a member that has killed whoever ran it."""
        del item
        return no_answer(LOST, why, self.scene.run.frames)

    def _ran(self, member: Member, workshop: Workshop, stop: Stop) -> MemberResult:
        begun, scene = time.perf_counter(), member.scene
        try:
            run = judged(member, workshop, stop)
        except (SoftcatError, RuntimeError, ArithmeticError, ValueError) as error:
            # What a sweep is worth does not hang on one member.
            return no_answer(FAILED, _text(error), scene.run.frames, scene, wall=time.perf_counter() - begun)
        if run.missing_effect or (run.outcome in OF_A_STEP_TOO_LONG and scene.numerics.rtol is None):
            # Rare: what a single run would be repeated for is repeated as a single run, one at a time.
            with workshop.alone():
                return self._simulated(without_estimate(scene), begun)
        wall = time.perf_counter() - begun
        if not run.outcome.is_success:
            return no_answer(run.outcome.name, run.message, scene.run.frames, scene, wall=wall)
        times, numbers = run.solution.time * run.prepared.scale, (run.energy_residual, wall)
        places = (run.nodes, run.cells)
        return answer(scene, run.regime or "", times, run.fields, places, numbers, shapes=self.shapes)

    def _estimated(self, row: Row, told: Told) -> MemberResult:
        """A member with its error estimated, refined if it must be."""
        begun = time.perf_counter()
        try:
            (member,) = members_of(self.scene, [row], "each")
            return self._simulated(member.scene, begun)
        except SceneError as error:
            return no_answer(REFUSED, faults_text(error), self.scene.run.frames)
        finally:
            told(1)

    def _simulated(self, scene: Scene, begun: float) -> MemberResult:
        """A member by :func:`softcat_sym.simulate`: every check, and repeated where the finished run calls for it."""
        frames = scene.run.frames
        try:
            run = simulated(scene)
        except (SoftcatError, RuntimeError, ArithmeticError, ValueError) as error:
            outcome = REFUSED if isinstance(error, SceneError) else FAILED
            return no_answer(outcome, _text(error), frames, scene, wall=time.perf_counter() - begun)
        wall = time.perf_counter() - begun
        if not run.outcome.is_success:
            return no_answer(run.outcome.name, run.summary["message"], frames, scene, wall=wall)
        fields = {name: run.data[name].values for name in ("x", "y", "stretch")}
        places = (run.data.X_node.values, run.data.X_cell.values)
        numbers = (float(run.summary["energy_residual"]), wall)
        regime = str(run.summary["regime"] or "")
        return answer(scene, regime, run.data.time.values, fields, places, numbers, shapes=self.shapes)


def admit(scene: Scene, rows: Sequence[Row]) -> list[Member | str]:
    """The members that rows make, each whatever the others are; or why one makes none.

    Where the program chooses the effects, it does so for each member by itself. Where the scene names them, the choice
    is made once, and again for a row that changes a choice.
    """
    how: Choosing = "each" if scene.run.effects == "auto" else "once"
    try:
        members = members_of(scene, rows, how)
    except SceneError as error:
        if len(rows) == 1:
            return [faults_text(error)]
        half = len(rows) // 2
        return admit(scene, rows[:half]) + admit(scene, rows[half:])
    # What the first row of its sort was given in a table, each is given here: no member depends on its neighbours.
    base = [pattern_of(scene, row) for row in rows]
    return [
        member if member.pattern == own or how == "each" else members_of(scene, [row], "each")[0]
        for member, row, own in zip(members, rows, base, strict=True)
    ]


def faults_text(error: SceneError) -> str:
    """What is wrong with the scene of a single row."""
    faults = [str(fault).removeprefix("row 0").removeprefix(": ") for fault in error.faults]
    return "; ".join(faults)


def _text(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__


STORE, TABLE = "sweep.nc", "sweep.csv"

_ABOUT: Final[Mapping[str, tuple[str, str]]] = {
    "outcome": ("", "how the run ended; refused: no sound scene; failed: the program; lost: its worker died"),
    "regime": ("", "what the run shows; empty if it is no answer"),
    "message": ("", "why it is no answer"),
    "midpoint_final": ("m", "height of midspan at the end, negative down"),
    "sag_largest": ("m", "largest sag of midspan, positive down"),
    "sag_over_span": ("1", "largest sag of midspan over the span"),
    "time_to_90": ("s", "when the sag first reaches 90 % of its last value"),
    "largest_stretch": ("1", "largest stretch of the centreline, anywhere and ever"),
    "energy_residual": ("1", "imbalance of energy over the largest energy"),
    "wall_s": ("s", "wall time, beside other members"),
    "span": ("m", "span of the filament"),
    "thickness": ("m", "thickness of the undeformed filament"),
    "duration": ("s", "duration of the run"),
}
_SHAPES: Final = (("x", "m", "across"), ("y", "m", "height"), ("stretch", "1", "stretch of the centreline"))
_CHUNK = 256


@dataclass
class Counts:
    """How members ended."""

    outcomes: Counter[str] = field(default_factory=Counter)  # Members of each
    regimes: Counter[str] = field(default_factory=Counter)

    def add(self, part: Columns) -> None:
        """Count the members of a part."""
        self.outcomes.update(part["outcome"].tolist())
        self.regimes.update(regime for regime in part["regime"].tolist() if regime)


class _Blocks:
    """Finished blocks in a file, in whatever order they are finished: memory stays the same however many there are."""

    def __init__(self, file: IO[bytes]) -> None:
        self._file, self._places = file, dict[int, tuple[int, int]]()

    def put(self, number: int, content: bytes) -> None:
        """Add a block."""
        self._places[number] = self._file.seek(0, 2), len(content)
        self._file.write(content)

    def read(self, number: int) -> bytes:
        """Read a block."""
        start, size = self._places[number]
        self._file.seek(start)
        return self._file.read(size)


def parts_of(plan: SweepPlan, blocks: _Blocks) -> Iterator[tuple[int, Columns]]:
    """The first member and the columns of each part, varied values included, in order."""
    varied = columns_of(plan)
    for number in range(plan.blocks):
        rows = plan.block(number).items
        part = store.unpacked(blocks.read(number))
        for column in varied:
            values = [row[column.key] for row in rows]
            part[column.key] = np.array(list(map(str, values))) if column.is_text else column.numbers(values)
        yield number * plan.block_size, part


def write_store(plan: SweepPlan, blocks: _Blocks, directory: Path) -> Counts:
    """Join the parts into ``sweep.nc``."""
    counts = Counts()

    def fill(passing: Path) -> None:
        import h5netcdf

        with h5netcdf.File(passing, "w") as file:
            _make(file, plan)
            for start, part in parts_of(plan, blocks):
                _put(file, plan, start, part)
                counts.add(part)

    fill_atomically(directory / STORE, fill)
    return counts


def write_table(plan: SweepPlan, blocks: _Blocks, directory: Path) -> None:
    """Write ``sweep.csv``: a row for each member."""

    def fill(passing: Path) -> None:
        with passing.open("x", newline="", encoding="utf-8") as stream:
            writer = csv.writer(stream, lineterminator="\n")
            writer.writerow(["member", *(_headed(column) for column in columns_of(plan)), *map(_named, _ABOUT)])
            for start, part in parts_of(plan, blocks):
                columns = [part[name].tolist() for name in (*plan.keys, *_ABOUT)]
                for k, row in enumerate(zip(*columns, strict=True)):
                    writer.writerow([start + k, *map(_cell, row)])

    fill_atomically(directory / TABLE, fill)


def _cell(value: object) -> str:
    """A value of the table; an empty cell where there is none."""
    if isinstance(value, float):
        return repr(value) if value == value else ""
    return str(value)


def _headed(column: VariedColumn) -> str:
    return column.key if column.units in ("", "1") else f"{column.key} [{column.units}]"


def _named(name: str) -> str:
    unit = _ABOUT[name][0]
    return name if unit in ("", "1") or name.endswith("_s") else f"{name} [{unit}]"


def _make(file: Any, plan: SweepPlan) -> None:
    """Dimensions and empty variables."""
    import h5py

    frames, members = plan.scene.run.frames, plan.members
    file.dimensions = {"member": members, "frame": frames}
    if plan.shapes:
        file.dimensions["shape_frame"], file.dimensions["shape_node"] = SHAPE_FRAMES, SHAPE_NODES
    file.attrs.update(
        {"title": plan.scene.title, "scene": plan.scene.to_toml(), "section": plan.scene.filament.section}
        | {"plan": plan.digest, "mode": plan.mode}
    )
    packing = {"compression": "gzip", "compression_opts": 4, "shuffle": True}
    text = h5py.string_dtype()
    few = min(members, _CHUNK)

    def make(name: str, dims: tuple[str, ...], dtype: Any, chunks: tuple[int, ...], attrs: dict[str, Any]) -> None:
        packed = {} if dtype is text else packing
        file.create_variable(name, dims, dtype=dtype, chunks=chunks, **packed).attrs.update(attrs)

    share = {"units": "1", "long_name": "time over the duration of the member"}
    file.create_variable("frame", ("frame",), data=np.linspace(0.0, 1.0, frames)).attrs.update(share)
    for column in columns_of(plan):
        about: dict[str, Any] = {"varied": 1, "scale": column.scale} | ({"units": column.units} if column.units else {})
        make(column.key, ("member",), text if column.is_text else float, (few,), about)
    for name, (unit, meaning) in _ABOUT.items():
        about = {"long_name": meaning} | ({"units": unit} if unit else {})
        make(name, ("member",), text if name in TEXTS else float, (few,), about)
    whole = {"units": "m", "long_name": "height of midspan, negative down; NaN where there is no answer"}
    make("midpoint", ("member", "frame"), float, (min(members, 64), frames), whole)
    for name, unit, meaning in _SHAPES if plan.shapes else ():
        size = (min(members, 16), SHAPE_FRAMES, SHAPE_NODES)
        about = {"units": unit, "long_name": f"{meaning}, at equal steps of time and material"}
        make(name, ("member", "shape_frame", "shape_node"), np.float32, size, about)


def _put(file: Any, plan: SweepPlan, start: int, part: Columns) -> None:
    """A part into its rows."""
    count = len(part["outcome"])
    rows = slice(start, start + count)
    for name in (*plan.keys, *TEXTS, *NUMBERS):
        values: npt.NDArray[Any] = part[name]
        file.variables[name][rows] = values.astype(object) if values.dtype.kind == "U" else values
    file.variables["midpoint"][rows] = part["midpoint"]
    if plan.shapes:
        nothing = np.full((count, len(_SHAPES), SHAPE_FRAMES, SHAPE_NODES), np.nan, dtype=np.float32)
        shapes = part.get("shapes", nothing)
        for k, (name, _, _) in enumerate(_SHAPES):
            file.variables[name][rows] = shapes[:, k]


_VERSIONS = ("softcat_sym", "casadi", "sympy", "numpy")


@dataclass(frozen=True)
class Sweep:
    """A finished sweep.

    Attributes
    ----------
    plan : SweepPlan
        What was run.
    path : pathlib.Path
        The store, ``sweep.nc``.
    counts : Counts
        Members by outcome and by regime.
    resumed : int
        Members that were there from before.
    place : str
        Where it ran.
    wall_s : float
        How long [s].
    peak_memory : float
        Largest memory of this process so far [MB].
    loaded : xarray.Dataset or None
        The store in memory, where it is no longer on disk.
    """

    plan: SweepPlan
    path: Path
    counts: Counts
    resumed: int
    place: str
    wall_s: float
    peak_memory: float
    loaded: xr.Dataset | None = None

    def __len__(self) -> int:
        return self.plan.members

    @cached_property
    def data(self) -> xr.Dataset:
        """The store, dims ``member`` and ``frame``; read from disk as it is used.

        A variable for each varied key, ``outcome``, ``regime``, ``message``, ``midpoint`` [m] and numbers of each
        member; with shapes ``x``, ``y`` [m] and ``stretch``.
        """
        import xarray as xr

        return self.loaded if self.loaded is not None else xr.open_dataset(self.path, engine="h5netcdf")

    def plot(self) -> Figure:
        """Draw the sag over what varies.

        Raises
        ------
        SoftcatError
            If no key takes two values.
        """
        from softcat_sym.plotting.notebook import drawn
        from softcat_sym.plotting.sweep import sweep_figure

        return drawn({"sag": sweep_figure}, "sag", self)

    def __repr__(self) -> str:
        outcomes = ", ".join(f"{name} {count}" for name, count in sorted(self.counts.outcomes.items()))
        return f"Sweep {self.plan.scene.title!r}: {len(self)} filaments ({outcomes})\n  .data, .summary(), {self.path}"

    def _repr_html_(self) -> str:
        from softcat_sym.plotting.notebook import html

        return html(repr(self), self.plot())

    def in_memory(self) -> Sweep:
        """The same with its data loaded, independent of the file."""
        import xarray as xr

        return replace(self, loaded=xr.load_dataset(self.path, engine="h5netcdf"))

    def summary(self) -> dict[str, Any]:
        """What ``sweep.json`` holds."""
        ran = len(self) - self.resumed
        return {
            "title": self.plan.scene.title,
            "plan": self.plan.described(),
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


def peak_memory() -> float:
    """Largest resident memory of this process so far [MB]; zero where the system does not tell."""
    # What getrusage says of a Linux process begins at the peak of the one that started it.
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
    """Run a filament for every value of some parameters, block by block in constant memory; results go to disk.

    A member that makes no sense, fails or is no answer is a row like the others.

    Parameters
    ----------
    scene : Scene, str, path or dict
        What the members have in common.
    vary : mapping, sequence of str, or pathlib.Path
        ``{"groups.G": "0.01:3:40:log", "material.yield_stress": ["5 kPa", 1e4]}``, plain numbers in SI; or texts
        ``"KEY=a:b:n:log"``, ``"KEY=v1,v2"``; or a CSV file whose header names the keys.
    directory : str or pathlib.Path, optional
        For ``sweep.nc`` and ``sweep.csv``, else in memory.
    mode, samples, seed
        ``"grid"``: every combination; ``"zip"``: side by side; ``"lhs"``: so many samples of a Latin hypercube.
    shapes, estimate : bool
        Keep 21 x 41 points of shape; run each by :func:`simulate`, its error estimated, not as :func:`simulate_many`.
    workers, scheduler, local_cluster : optional
        Threads, all cores by default; or the address of a Dask cluster, ``"tcp://host:8786"``; or how many processes.
    fresh : bool
        Run every member, finished ones too: otherwise these are taken from the store, as after an interruption.
    progress : MembersProgress, optional
        Told about members done and time left, such as :class:`softcat_sym.ensemble.MembersBar`.

    Raises
    ------
    SoftcatError, KeyboardInterrupt
        If the plan makes no sense, before anything runs; if the user stops it.
    """
    check_workplace(workers, scheduler, local_cluster)
    plan = plan_sweep(as_scene(scene), vary, mode, samples=samples, seed=seed, shapes=shapes, estimate=estimate)
    where, listener = (workers, scheduler, local_cluster), progress or NobodyListens()
    with store.fresh(fresh), contextlib.ExitStack() as stack:
        if directory is not None:
            return run_sweep(plan, Path(directory), where, listener)
        passing = stack.enter_context(tempfile.TemporaryDirectory(prefix="softcat-sweep-"))
        return run_sweep(plan, Path(passing), where, listener).in_memory()


def run_sweep(
    plan: SweepPlan, directory: Path, where: tuple[int | None, str | None, int | None], listener: MembersProgress
) -> Sweep:
    """Run what of a plan is not in the store yet, and write all of it."""
    begun = time.perf_counter()
    refuse_plan(plan)
    # A file without a name: whatever ends the program, nothing of it is left.
    with made(directory), tempfile.TemporaryFile(dir=directory) as passing, watched() as interrupts:
        blocks = _Blocks(passing)
        missing = []
        for number in range(plan.blocks):
            content = store.recall(plan.key(plan.block(number)))
            if content is None:
                missing.append(number)
            else:
                blocks.put(number, content)
        before = plan.members - sum(len(plan.block(number).items) for number in missing)
        try:
            place = _run_missing(plan, blocks, where, Count(plan.members, before, listener), missing)
        finally:
            interrupts.check()
        with written_together():
            counts = write_store(plan, blocks, directory)
            write_table(plan, blocks, directory)
    return Sweep(plan, directory / STORE, counts, before, place, time.perf_counter() - begun, peak_memory())


def _run_missing(
    plan: SweepPlan,
    blocks: _Blocks,
    where: tuple[int | None, str | None, int | None],
    told: Count,
    missing: Sequence[int],
) -> str:
    """Run the blocks that are not there, and keep each as soon as it is finished; where that was."""
    if not missing:
        return "nothing left to run"
    work = SweepWork(plan.scene, plan.digest, plan.shapes, plan.estimate)

    def finished(number: int, results: Sequence[MemberResult]) -> None:
        content = packed(results)
        blocks.put(number, content)
        if all(one.outcome != LOST for one in results):
            store.keep(plan.key(plan.block(number)), content)

    with workplace(*where) as place:
        run_blocks(work, (plan.block(number) for number in missing), place, told, finished)
        return place.named()


def refuse_plan(plan: SweepPlan) -> None:
    """Look for a member that can be run."""
    first = 0
    probes = dict.fromkeys([0, plan.members - 1, plan.members // 2])
    for member in probes:
        if not _why_not(plan, plan.row(member)):
            return
    _refuse_keys(plan)
    for number in range(plan.blocks):
        if any(not isinstance(one, str) for one in admit(plan.scene, plan.block(number).items)):
            return
    why = _why_not(plan, plan.row(first))
    raise SceneError(
        [Fault("", f"every one of the {plan.members} members is refused; the first: {why}", "")], "of a sweep"
    )


def _why_not(plan: SweepPlan, row: Row) -> str:
    (one,) = admit(plan.scene, [row])
    return one if isinstance(one, str) else ""


def _refuse_keys(plan: SweepPlan) -> None:
    """Refuse a key that no scene has."""
    for axis in plan.axes:
        try:
            plan.scene.replace({axis.key: axis.values[0]}) if not axis.key.startswith("groups.") else None
        except SceneError as error:
            unknown = [f for f in error.faults if f.found.startswith("unknown key") or "leads to no key" in f.found]
            if unknown:
                raise SceneError(unknown, "of a sweep") from None
        except SoftcatError:
            continue
