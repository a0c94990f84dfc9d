"""Sweeps: a scene run for every value of some parameters."""

from __future__ import annotations

import json
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from concurrent import futures
from contextlib import nullcontext
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Final

import numpy as np
import pandas as pd
import xarray as xr

from softcat_sym import store
from softcat_sym.batch.executor import MembersProgress, check_workers, run_pool
from softcat_sym.batch.members import Member
from softcat_sym.batch.plan import SweepPlan, plan_sweep
from softcat_sym.batch.records import Batch, Record, RecordColumn, variables_of, versions
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
from softcat_sym.files import new_folder, write_results
from softcat_sym.results.fields import displacements
from softcat_sym.results.motion import observed_motion, time_to_share
from softcat_sym.results.verdict import measures, missing_effect
from softcat_sym.scene.reading import Changes, SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import identity_of, simulated, without_estimate
from softcat_sym.single_run import STEP_SIZE_OUTCOMES
from softcat_sym.solvers.solution import watched
from softcat_sym.store import key_of

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


@dataclass(frozen=True)
class SweepWork(RowWork):
    """Runs the member of a row of a sweep."""

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


@dataclass(frozen=True)
class Sweep(Drawable):
    """A finished sweep.

    Attributes
    ----------
    plan : SweepPlan
        The plan of the members.
    data : xarray.Dataset
        Dims ``member`` and ``frame``. A variable for each varied key, ``outcome``, ``regime``, ``message``,
        ``midpoint`` [m] and numbers of each member.
    centre : ReferenceMember
        The member in the middle, with its cells, fibres, rtol and estimated error; all others are at least as fine.
    resumed : int
        Number of members that were taken from an earlier command.
    place : str
        Where the members ran: threads, or an executor.
    wall_s : float
        Wall time [s].
    """

    plan: SweepPlan
    data: xr.Dataset
    centre: ReferenceMember
    resumed: int
    place: str
    wall_s: float

    def __len__(self) -> int:
        return self.plan.members

    @cached_property
    def outcomes(self) -> Counter[str]:
        """Number of members by outcome."""
        return Counter(self.data.outcome.values.tolist())

    @cached_property
    def regimes(self) -> Counter[str]:
        """Number of members by regime."""
        return Counter(filter(None, self.data.regime.values.tolist()))

    def __repr__(self) -> str:
        outcomes = ", ".join(f"{name} {count}" for name, count in sorted(self.outcomes.items()))
        return f"Sweep {self.plan.scene.title!r}: {len(self)} filaments ({outcomes})\n  .data, .to_frame(), .to_dict()"

    def to_dict(self) -> dict[str, Any]:
        """Content of ``sweep.json``."""
        ran = len(self) - self.resumed
        return {
            "title": self.plan.scene.title,
            "plan": self.plan.to_dict(),
            "centre": self.centre.to_dict(),
            "digest": self.plan.digest,
            "outcomes": dict(sorted(self.outcomes.items())),
            "regimes": dict(sorted(self.regimes.items())),
            "place": self.place,
            "wall_s": self.wall_s,
            "resumed_members": self.resumed,
            "members_per_second": ran / self.wall_s if self.wall_s > 0 else None,
            "versions": versions(),
        }

    summary = to_dict

    def to_frame(self) -> pd.DataFrame:
        """Content of ``sweep.csv``: a row for each member."""
        table = {"member": np.arange(len(self))}
        for name in (*(axis.key for axis in self.plan.axes), *_COLUMNS):
            unit = self.data[name].attrs.get("units", "")
            plain = unit in ("", "1") or name.endswith("_s")
            table[name if plain else f"{name} [{unit}]"] = self.data[name].values
        return pd.DataFrame(table)

    def files(self) -> dict[str, Any]:
        """What a folder of the sweep holds, pictures and summary apart."""
        packed = {"zlib": True, "complevel": 4}
        encoding = {name: packed for name, values in self.data.items() if values.ndim > 1}
        netcdf = self.data.to_netcdf(engine="h5netcdf", encoding=encoding)
        # In memory: on a full disk HDF5 would end the program.
        return {"sweep.nc": bytes(netcdf), "sweep.csv": self.to_frame()}


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
    estimate: bool = False,
    workers: int | None = None,
    executor: futures.Executor | None = None,
    fresh: bool = False,
    progress: MembersProgress | None = None,
    changes: Changes = (),
) -> Sweep:
    """Run a filament for every value of some parameters.

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
        Where ``sweep.nc`` and ``sweep.csv`` are written, too.
    mode, samples, seed
        ``"grid"``: every combination; ``"zip"``: values side by side; ``"lhs"``: a Latin hypercube of `samples`.
    estimate : bool
        Run each member by :func:`simulate` with an error estimate, instead of as :func:`simulate_many` does.
    workers, executor : optional
        Number of threads, by default all cores; or any :class:`concurrent.futures.Executor`, such as
        ``distributed.Client.get_executor()`` for a cluster.
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
    check_workers(workers, executor)
    base = as_scene(scene, changes)
    plan = plan_sweep(base, vary, mode, samples=samples, seed=seed, estimate=estimate)
    with store.fresh(fresh), nullcontext() if directory is None else new_folder(directory):
        done = run_sweep(plan, progress, workers, executor)
        if directory is not None:
            write_results(directory, done.files())
    return done


def run_sweep(
    plan: SweepPlan,
    progress: MembersProgress | None = None,
    workers: int | None = None,
    executor: futures.Executor | None = None,
) -> Sweep:
    """Run the members of a plan that are not in the store yet."""
    begun = time.perf_counter()
    _refuse_plan(plan)
    with watched():
        reference, identity = _reference(plan), identity_of(plan.scene)
        how = [plan.estimate, reference.cells, reference.fibres, reference.tighter]
        columns, sizes = {**_COLUMNS, **_MIDPOINT}, {"frame": plan.scene.run.frames}
        batch = Batch(plan.rows, plan.block_size, lambda rows: key_of("sweep", identity, rows, how), columns, sizes)
        tables = batch.stored()
        resumed = sum(len(batch.block(number)) for number in tables)
        with run_pool(workers, executor, len(plan.rows) - resumed) as pool:
            work = SweepWork(plan.scene, pool.stop, plan.estimate, reference)
            table = batch.run(tables, work, pool, plan.block_size, progress)
    about = {"title": plan.scene.title, "scene": plan.scene.to_toml(), "section": plan.scene.filament.section}
    about |= {"plan": plan.digest, "mode": plan.mode, "centre": json.dumps(reference.to_dict(), default=str)}
    share = np.linspace(0.0, 1.0, plan.scene.run.frames)
    frame = ("frame", share, {"units": "1", "long_name": "time over the duration of the member"})
    data = xr.Dataset(plan.variables() | variables_of(table, columns), coords={"frame": frame}, attrs=about)
    return Sweep(plan, data, reference, resumed, str(pool), time.perf_counter() - begun)


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
            maker.member(plan.rows[member])
        except SceneError as error:
            refusals = refusals or ["; ".join(map(str, error.faults))]
        else:
            return
    found = f"every one of the {plan.members} members is refused; the first: {refusals[0]}"
    raise SceneError([Fault("", found, "")], "of a sweep")
