"""What accuracy costs: continual-descent to a true error of 1e-4 against every rival, and a limit that holds."""

from __future__ import annotations

import csv
import json
import time
from contextlib import closing
from math import inf
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.accuracy import program_rows
from softcat_sym.scene.scene import groups_of
from softcat_sym.studies.work_precision import DIED, LEVELS, Budget, Worker, WorkPrecision, study
from softcat_sym.studies.work_precision_programs import PROGRAMS, THIS_PROGRAM, Task
from tests.common.in_process import Softcat, sets
from tests.common.rk4_filament import run as paper_rk4
from tests.common.table import show

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]

NAME, ERROR = "continual-descent", 1e-4
SAME_RUNTIME = {THIS_PROGRAM, "compiled-rodas5p"}
LIMIT = 400.0


def judged(effects: str) -> tuple[WorkPrecision, float]:
    """Measure and print; seconds of the package, which is ahead of each rival."""
    found = study(NAME, sc.load_scene(NAME, {"run.effects": effects}), PROGRAMS, LIMIT)
    header = ("program", *(f"{level:.0e}" for level in LEVELS), "us/step", "")
    show(f"{NAME}, effects {effects}: quickest warm solve with at most this error", header, program_rows(found))
    best = {key: found.knee(ERROR, f"key == '{key}'") for key in found.names}
    times = {key: inf if run is None else run["seconds"] for key, run in best.items()}
    ours = times[THIS_PROGRAM]
    rows = []
    for key, run in best.items():
        cells = ["–", "", found.refusals.get(key, "not reached within the limit")]
        if run is not None:
            cells = [f"{1e3 * run['seconds']:.1f}", f"{run['error']:.1e}", run["task"].text]
        rows.append([found.names[key], *cells, f"{times[key] / ours:.3g}"])
    show(f"to {ERROR:.0e}", ("program", "ms", "error", "with", "times softcat"), rows)
    print(f"{found.sentence}\n{found.reference.note}")
    # What is read off must be well above what the reference can tell.
    assert found.reference.floor < ERROR / 5 and np.isfinite(found.reference.time)
    rival = min(seconds for key, seconds in times.items() if key not in SAME_RUNTIME)
    print(f"ratio to the best rival: {rival / ours:.3g}")
    assert ours < rival
    return found, ours


def test_published_theory_to_1e_4_is_faster_than_any_rival() -> None:
    found, ours = judged("paper")
    # All of them apply to the published theory: whoever has no answer was too slow.
    assert set(found.refusals) <= found.cut
    # The paper's own method, vectorised, on equal cells at its stability limit: it is far from the error asked.
    groups, rows = groups_of(found.scene), []
    times = np.linspace(0.0, 460.0, len(found.reference.midpoint))[1:].tolist()
    for cells in (10, 20, 40):
        numbers = (groups.delta, groups.G, groups.V, groups.eps_Y)
        run = paper_rk4(*numbers, "bingham", "material", cells, 460.0, outputs=times)  # type: ignore[arg-type]
        error, seconds = found.reference.error((0.0, *run.midpoint.tolist())), run.wall_seconds
        cost = (run.steps, f"{4 * run.rhs_microseconds:.0f}", f"{seconds / ours:.3g}")
        rows.append([cells, f"{1e3 * seconds:.0f}", f"{error:.1e}", *cost])
        assert error > ERROR
    header = ("cells", "ms", "error", "steps", "us/step", "times softcat, without reaching 1e-4")
    show("the paper's RK4 in NumPy, equal cells", header, rows)
    assert seconds > ours


def test_what_auto_chooses_to_1e_4_is_faster_than_any_rival() -> None:
    found, _ = judged("auto")
    assert found.knee(1e-3, "key == 'scipy-radau'") is not None


@pytest.mark.parametrize(("scene", "limit"), [("ink-bridge", 3.0), ("arrested-underdamped", 15.0)])
def test_the_limit_holds_and_the_time_left_never_jumps_up(scene: str, limit: float) -> None:
    """Of scenes that take far longer; one that leaves no time for a reference says so."""
    told, began, said = [], time.monotonic(), "all of it was done"
    try:
        found = study(scene, sc.load_scene(scene), limit=limit, on_progress=lambda what, share: told.append(share))
        said = f"cut off: {', '.join(found.cut)}"
        assert found.cut
    except SoftcatError as error:
        said = str(error)
        assert "no reference" in said
    spent = time.monotonic() - began
    show("what a limit does", ("scene", "limit s", "spent s", ""), [[scene, limit, f"{spent:.2f}", said]])
    assert spent < 1.2 * limit + 1.0
    assert told == sorted(told) and told[-1] <= 1


def test_what_takes_too_long_is_ended_and_the_next_begins_anew() -> None:
    scene, quick = sc.load_scene(NAME, {"run.effects": "paper", "numerics.estimate": False}), Task("cvodes", 10, 1.0)
    with closing(Worker(scene, Budget(300.0, lambda what, share: None))) as worker:
        # Over ten thousand steps of 640 cells: more than a minute.
        long = worker.measure(Task("cvodes", 640, 30.0, rtol=1e-11), 1.0)
        assert long.message == "stopped after 1 s" and long.stopped and long.midpoint == ()
        assert not worker.measure(quick, 60.0).message
        # Killed from outside: listed, and the next task gets a new process.
        assert worker.process is not None
        worker.process.kill()
        assert worker.measure(quick, 60.0).message.startswith(DIED)
        assert not worker.measure(quick, 60.0).message


def test_files_and_what_they_hold(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    short = ("run.effects=paper", "run.duration=0.05 s", "run.frames=6")
    done = Softcat(monkeypatch, capsys)("accuracy", NAME, "-o", str(tmp_path), "--limit", "200", *sets(*short))
    assert done.status == 0 and "At an error of" in done.out
    assert {path.name for path in tmp_path.iterdir()} == {f"accuracy.{kind}" for kind in ("csv", "json", "png")} | {
        "scene.toml"
    }
    found = json.loads((tmp_path / "accuracy.json").read_text())
    assert 0 < found["reference"]["floor"] < 1e-4
    assert [program["key"] for program in found["programs"]] == [THIS_PROGRAM, "idas", "scipy-radau"]
    # Every program converges to the one reference: on 20 cells a quarter of the error of 10.
    for program in found["programs"]:
        sound = [run for run in program["runs"] if run["error"] is not None]
        best = {n: min(run["error"] for run in sound if run["cells"] == n) for n in (10, 20)}
        assert best[20] < 0.5 * best[10] < 0.05
    table = list(csv.DictReader((tmp_path / "accuracy.csv").read_text().splitlines()))
    errors = [run["error"] for p in found["programs"] for run in p["runs"]]
    assert [float(line["error"]) if line["error"] else None for line in table] == errors
    assert all(knee["best"] is None or knee["best"]["error"] <= knee["error"] for knee in found["knees"])
