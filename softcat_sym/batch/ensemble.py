"""Many runs that differ in some values: integrated side by side in threads, one result."""

from __future__ import annotations

import json
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import numpy.typing as npt
import xarray as xr

from softcat_sym.batch.executor import MembersProgress, counted, run_pool, worker_count
from softcat_sym.batch.lane_pool import Stop
from softcat_sym.batch.members import Choosing, Member, Row, column_of, members_of, rows_of
from softcat_sym.batch.records import Record, RecordColumn, table_of, variables_of, versions
from softcat_sym.batch.reference_member import RESOLUTION, reference_member, resolution_of
from softcat_sym.batch.worker import StructureCache, judged
from softcat_sym.drawing import html
from softcat_sym.errors import Fault, SceneError
from softcat_sym.results.breaking import breakable
from softcat_sym.results.fields import midpoint_heights
from softcat_sym.results.run import Run
from softcat_sym.scene.reading import Changes, SceneLike, as_scene
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import watched

_COLUMNS = {
    "midpoint": RecordColumn(
        "m", "height of the midpoint X = 0, negative down; NaN where it was not reached", ("time",)
    ),
    "midpoint_final": RecordColumn("m", "height of the midpoint in the last frame reached, negative down"),
    "time_final": RecordColumn("s", "time of the last frame reached"),
    "outcome": RecordColumn("", "how the run ended", dtype=str),
    "message": RecordColumn("", "why, if that is no success", dtype=str),
    "energy_residual": RecordColumn("1", "energy imbalance of the last frame against the first, of the largest energy"),
    "effects": RecordColumn("", "effects in force", dtype=str),
    "steps": RecordColumn("", "steps of the integrator", dtype=int),
    "wall_s": RecordColumn("s", "wall time, side by side with other members"),
    **{name: RESOLUTION[name] for name in ("cells", "fibres", "rtol")},
}


def _integrated(member: Member, structures: StructureCache, stop: Stop) -> Record:
    """Record a member."""
    begun, scene = time.perf_counter(), member.scene
    prepared, solution = structures.run(member, stop)
    ends = solution
    # Without velocities the work against the necking gradient is summed over frames; a break is sought in all of them.
    if prepared.graph.has_velocities and not breakable(scene):
        ends = solution.only([0, -1])
    run = judged(member, prepared, ends)
    midpoint = np.full(scene.run.frames, np.nan)
    # Adding zero leaves no minus zero.
    midpoint[: len(solution.time)] = midpoint_heights(prepared.graph, solution) * rest_length(scene) + 0.0
    return {
        "midpoint": midpoint,
        "midpoint_final": midpoint[~np.isnan(midpoint)][-1],
        "time_final": float(solution.time[-1]) * prepared.scale,
        "outcome": run.outcome.name,
        "message": run.message,
        "energy_residual": run.energy_residual,
        "effects": ", ".join(member.effects.names),
        "steps": solution.steps,
        "wall_s": time.perf_counter() - begun,
        **resolution_of(member, prepared),
    }


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
        ``effects``, ``steps``, ``wall_s``, ``cells``, ``fibres`` (NaN where the section is not resolved by them) and
        ``rtol``. The attribute ``centre`` says in JSON what was found for the member in the middle. Every column of
        the table is a coordinate along ``member``, quantities in SI. ``time`` is in seconds where all members last
        equally long; otherwise it is the share of each member's own ``duration`` [s], which is then a variable.
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

    def __repr__(self) -> str:
        counts = Counter(one.name for one in self.outcomes)
        ends = ", ".join(f"{name} {count}" for name, count in sorted(counts.items()))
        return f"Ensemble {self.data.title!r}: {len(self)} filaments ({ends})\n  .data, .trajectory(member), .scenes"

    def _repr_html_(self) -> str:
        return html(repr(self)) + str(self.data._repr_html_())

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


Table = Mapping[str, Sequence[object] | npt.NDArray[Any]] | Sequence[Mapping[str, object]] | npt.NDArray[Any]


def simulate_many(
    scene: SceneLike,
    parameters: Table,
    *,
    workers: int | None = None,
    progress: MembersProgress | None = None,
    effects: Choosing = "once",
    changes: Changes = (),
) -> Ensemble:
    """Run a filament for every row of a table of parameters.

    Members run through the compiled solver in threads; where there is none for a scene, one after the other. The middle
    one is run by :func:`simulate` before, or taken from the store, unless ``numerics.estimate = false``: all of them
    have at least the cells, fibres and tolerance with which it ends.

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
        Updated with members done and time left, such as :class:`softcat_sym.progress.MembersBar`.
    effects : {"once", "each"}
        Whether effects are chosen for the scene and hold for all rows (anew only where rows change a choice, such as
        the law or an end, or whether a number is zero), or for each row by itself. Either way no run is repeated with
        more effects.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.

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
    scene = as_scene(scene, changes)
    threads, rows = worker_count(workers), rows_of(parameters)
    with watched():
        return _simulated(scene, rows, threads, progress, effects)


def _simulated(
    scene: Scene, rows: list[Row], workers: int, progress: MembersProgress | None, choosing: Choosing
) -> Ensemble:
    begun = time.perf_counter()
    members = members_of(scene, rows, choosing)
    middle = len(members) // 2
    reference = reference_member(members[middle], rows[middle])
    members = [reference.refine(member) for member in members]
    # CasADi keeps Python's lock while it integrates: threads would only wait for each other.
    parallel = all(member.backend.compiled for member in members)
    threads = workers if parallel else 1
    with run_pool(threads, members=len(members) if parallel else 0) as pool:
        work = partial(_integrated, structures=StructureCache(), stop=pool.stop)
        records = dict(counted(pool.map_members(work, members), len(members), 0, progress))
    ordered: list[Any] = [records[number] for number in range(len(members))]
    scenes, frames = tuple(member.scene for member in members), scene.run.frames
    variables = variables_of(table_of(ordered, _COLUMNS, {"time": frames}), _COLUMNS)
    durations, share = np.array([one.run.duration for one in scenes]), np.linspace(0.0, 1.0, frames)
    if np.all(durations == durations[0]):
        instants = ("time", share * durations[0], {"units": "s", "long_name": "time"})
    else:
        instants = ("time", share, {"units": "1", "long_name": "time over the duration of the member"})
        variables["duration"] = (("member",), durations, {"units": "s", "long_name": "duration of the run"})
    columns = {key: ("member", *column_of(scene, key, [row[key] for row in rows])) for key in rows[0]}
    attrs = {
        "title": scene.title,
        "scene": scene.to_toml(),
        "versions": json.dumps(versions()),
        "effects_chosen": choosing,
        "effects": json.dumps(members[0].effects.reasons),
        "backend": "; ".join(sorted({str(member.backend) for member in members})),
        "workers": str(threads),
        "centre": json.dumps(reference.to_dict(), default=str),
        "wall_s": f"{time.perf_counter() - begun:.6g}",
    }
    data = xr.Dataset(variables, {"member": np.arange(len(rows)), "time": instants} | columns, attrs)
    return Ensemble(scenes, data, tuple(Outcome[record["outcome"]] for record in ordered))
