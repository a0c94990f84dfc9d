"""The line from a scene to a trajectory, for a whole table at once."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping, Sequence
from typing import Any

import numpy.typing as npt

from softcat_sym.ensemble.ensemble import Ensemble, collect
from softcat_sym.ensemble.members import Choosing, members_of
from softcat_sym.ensemble.progress import MembersProgress, NobodyListens
from softcat_sym.ensemble.running import run_all, workers_of
from softcat_sym.ensemble.shared import Workshop
from softcat_sym.ensemble.table import Row, rows_of
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene import Scene, SceneLike, as_scene
from softcat_sym.solve import watched

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
