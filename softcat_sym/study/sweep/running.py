"""``sweep``: from a scene and what varies to a store on disk, block by block."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from softcat_sym.ensemble.progress import MembersProgress, NobodyListens
from softcat_sym.ensemble.table import Row
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.files import made, written_together
from softcat_sym.scene import SceneLike, as_scene
from softcat_sym.solve import watched
from softcat_sym.study.blocks import KeptBlocks, run_blocks, workplace
from softcat_sym.study.blocks.running import Count
from softcat_sym.study.blocks.workplaces import check_workplace
from softcat_sym.study.sweep.member_result import MemberResult
from softcat_sym.study.sweep.part_file import packed
from softcat_sym.study.sweep.plan import SweepPlan, plan_sweep
from softcat_sym.study.sweep.result import Sweep, peak_memory
from softcat_sym.study.sweep.store import STORE, counts_of, write_store, write_table
from softcat_sym.study.sweep.work import SweepWork, admit

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
    resume: bool = False,
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
        For ``sweep.nc`` and ``sweep.csv``, else in memory; `resume` goes on from what an interruption left there.
    mode, samples, seed
        ``"grid"``: every combination; ``"zip"``: side by side; ``"lhs"``: so many samples of a Latin hypercube.
    shapes, estimate : bool
        Keep 21 x 41 points of shape; run each by :func:`simulate`, its error estimated, not as :func:`simulate_many`.
    workers, scheduler, local_cluster : optional
        Threads, all cores by default; or the address of a Dask cluster, ``"tcp://host:8786"``; or how many processes.
    progress : MembersProgress, optional
        Told about members done and time left, such as :class:`softcat_sym.ensemble.MembersBar`.

    Raises
    ------
    SoftcatError, KeyboardInterrupt
        If the plan makes no sense or is not the one in `directory`, before anything runs; if the user stops it.
    """
    check_workplace(workers, scheduler, local_cluster)
    plan = plan_sweep(as_scene(scene), vary, mode, samples=samples, seed=seed, shapes=shapes, estimate=estimate)
    where, listener = (workers, scheduler, local_cluster), progress or NobodyListens()
    if directory is not None:
        return run_sweep(plan, Path(directory), where, listener, resume=resume)
    with tempfile.TemporaryDirectory(prefix="softcat-sweep-") as passing:
        return run_sweep(plan, Path(passing), where, listener).in_memory()


def run_sweep(
    plan: SweepPlan,
    directory: Path,
    where: tuple[int | None, str | None, int | None],
    listener: MembersProgress,
    *,
    resume: bool = False,
) -> Sweep:
    """Run what of a plan is not there yet, and join it.

    Parameters
    ----------
    plan : SweepPlan
        From :func:`softcat_sym.study.sweep.plan.plan_sweep`.
    directory : pathlib.Path
        Where the results go.
    where : tuple
        `workers`, `scheduler` and `local_cluster` of :func:`sweep`.
    listener : MembersProgress
        Told about members done.
    resume : bool
        Whether to go on from what is there.

    Raises
    ------
    SoftcatError, KeyboardInterrupt
        As :func:`sweep`.
    """
    begun = time.perf_counter()
    kept = KeptBlocks(directory, plan.digest, plan.described(), resume=resume)
    if resume and not kept.numbers() and (counts := counts_of(plan, directory)) is not None:
        spent = time.perf_counter() - begun
        return Sweep(plan, directory / STORE, counts, plan.members, "finished before", spent, peak_memory())
    known = kept.sound() if resume else set()
    if not known:
        refuse_plan(plan)
    before = sum(len(plan.block(number).items) for number in known)
    with watched() as interrupts:
        try:
            place = _run_missing(plan, kept, where, Count(plan.members, before, listener), known)
        finally:
            interrupts.check()
    with written_together():
        counts = write_store(plan, kept, directory)
        write_table(plan, kept, directory)
    wall = time.perf_counter() - begun
    kept.clear()
    return Sweep(plan, directory / STORE, counts, before, place, wall, peak_memory())


def _run_missing(
    plan: SweepPlan, kept: KeptBlocks, where: tuple[int | None, str | None, int | None], told: Count, known: set[int]
) -> str:
    """Run the blocks that are not there, and keep each as soon as it is finished; where that was."""
    missing = [number for number in range(plan.blocks) if number not in known]
    if not missing:
        return "nothing left to run"
    work = SweepWork(plan.scene, plan.digest, plan.shapes, plan.estimate)

    def keep(number: int, results: Sequence[MemberResult]) -> None:
        with made(kept.directory):
            kept.keep(number, packed(results))

    with workplace(*where) as place:
        run_blocks(work, (plan.block(number) for number in missing), place, told, keep)
        return place.named()


def refuse_plan(plan: SweepPlan) -> None:
    """Look for a member that can be run.

    Raises
    ------
    SceneError
        If there is none, with what is wrong with the first.
    """
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
    """Refuse a key that no scene has.

    Raises
    ------
    SceneError
        If a key is one.
    """
    for axis in plan.axes:
        try:
            plan.scene.replace({axis.key: axis.values[0]}) if not axis.key.startswith("groups.") else None
        except SceneError as error:
            unknown = [f for f in error.faults if f.found.startswith("unknown key") or "leads to no key" in f.found]
            if unknown:
                raise SceneError(unknown, "of a sweep") from None
        except SoftcatError:
            continue
