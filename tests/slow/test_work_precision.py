"""What accuracy costs: continual-descent to a true error of 1e-4, against every rival in the diagram."""

from __future__ import annotations

import csv
import json
from math import inf
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.plotting.accuracy import program_rows
from softcat_sym.scene.scene import groups_of
from softcat_sym.studies.work_precision import DIED, LEVELS, Plan, Worker, WorkPrecision, study
from softcat_sym.studies.work_precision_programs import Task
from tests.common.in_process import Softcat, sets
from tests.common.rk4_filament import run as paper_rk4
from tests.common.table import show

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]

NAME, ERROR = "continual-descent", 1e-4
OWN = "compiled-rodas5p"
SAME_RUNTIME = {OWN, "compiled-rodas4"}
GRIDS, TOLERANCES = (20, 40, 60, 80), (1e-2, 1e-3, 1e-4, 1e-5)


def judged(effects: str) -> tuple[WorkPrecision, float, dict[str, str]]:
    """Measure and print; seconds of the package, which is ahead of each rival, and why others have no answer."""
    plan = Plan(cells=GRIDS, tolerances=TOLERANCES, orders=(), cold=False, limit=10.0)
    found = study(NAME, sc.load_scene(NAME, {"run.effects": effects}), plan)
    header = ("program", *(f"{level:.0e}" for level in LEVELS), "us/step", "", "")
    show(f"{NAME}, effects {effects}: quickest warm solve with at most this error", header, program_rows(found))
    programs = found.runs.drop_duplicates("key").set_index("key")["program"]
    best = {key: found.knee(ERROR, f"key == '{key}'") for key in programs.index}
    times = {key: inf if run is None else run["seconds"] for key, run in best.items()}
    rows = []
    for key, run in best.items():
        cells = ["–", "", found.refusals.get(key, "not reached within the limit")]
        if run is not None:
            cells = [f"{1e3 * run['seconds']:.1f}", f"{run['error']:.1e}", run["task"].text]
        rows.append([programs[key], *cells, f"{times[key] / times[OWN]:.3g}"])
    show(f"to {ERROR:.0e}", ("program", "ms", "error", "with", "times Rodas5P"), rows)
    reference = found.reference
    print(f"{found.sentence}\n{reference.note}: families {reference.time:.1e} apart, space {reference.space:.1e}")
    # What is read off must be well above what the reference can tell.
    assert reference.floor < ERROR / 5 and np.isfinite(reference.time)
    rival = min(seconds for key, seconds in times.items() if key not in SAME_RUNTIME)
    print(f"ratio to the best rival: {rival / times[OWN]:.3g}")
    assert times[OWN] < rival
    return found, times[OWN], found.refusals


def test_published_theory_to_1e_4_is_faster_than_any_rival() -> None:
    found, ours, refused = judged("paper")
    # All of them apply to the published theory: whoever has no answer was too slow.
    assert all("stopped" in why or "would take" in why for why in refused.values())
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
    header = ("cells", "ms", "error", "steps", "us/step", "times Rodas5P, without reaching 1e-4")
    show("the paper's RK4 in NumPy, equal cells", header, rows)
    assert seconds > ours


def test_what_auto_chooses_to_1e_4_is_faster_than_any_rival() -> None:
    _, _, refused = judged("auto")
    assert "algebraic" in refused["compiled-rk4"] and "algebraic" in refused["scipy-radau"]


def test_a_tighter_limit_lists_what_it_stops() -> None:
    """A rival that is stopped is a line of the table with its reason, not a gap."""
    plan = Plan((40,), (1e-2,), (), ("compiled-rk4", "cvodes"), limit=0.05, cold=False)
    found = study(NAME, sc.load_scene(NAME, {"run.effects": "paper"}), plan)
    assert "steps would take" in found.refusals["compiled-rk4"]


def test_what_takes_too_long_is_ended_and_the_next_begins_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.studies.work_precision._GRACE", 0.1)
    scene, quick = sc.load_scene(NAME, {"run.effects": "paper", "numerics.estimate": False}), Task("cvodes", 10, 1.0)
    worker = Worker(scene, 1.0)
    # Over ten thousand steps of 640 cells: more than a minute.
    long = worker.measure(Task("cvodes", 640, 30.0, rtol=1e-11))
    assert long.message == "stopped after 1 s, integrating" and long.stopped and long.midpoint == ()
    assert not worker.measure(quick).message
    # Killed from outside: listed, and the next task gets a new process.
    assert worker.process is not None
    worker.process.kill()
    assert worker.measure(quick).message.startswith(DIED)
    assert not worker.measure(quick).message
    monkeypatch.undo()
    worker.limit = 1e-4
    assert worker.measure(quick).message.startswith("stopped: it took")
    worker.close()


def test_files_and_what_they_hold(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    short = ("run.effects=paper", "run.duration=0.05 s", "run.frames=6")
    keys = ["compiled-rodas5p", "cvodes", "compiled-rk4"]
    asked = ("--cells", "10,20", "--rtol", "1e-2,1e-4", "--limit", "20", "--warm-only")
    programs = [word for key in keys for word in ("--program", key)]
    done = Softcat(monkeypatch, capsys)("accuracy", NAME, "-o", str(tmp_path), *asked, *programs, *sets(*short))
    assert done.status == 0
    assert {path.name for path in tmp_path.iterdir()} == {f"accuracy.{kind}" for kind in ("csv", "json", "png")} | {
        "scene.toml"
    }
    found = json.loads((tmp_path / "accuracy.json").read_text())
    assert 0 < found["reference"]["floor"] < 1e-4
    assert [program["key"] for program in found["programs"]] == keys
    # Every program converges to the one reference: on 20 cells a quarter of the error of 10.
    for program in found["programs"]:
        best = {n: min(run["error"] for run in program["runs"] if run["cells"] == n) for n in (10, 20)}
        assert best[20] < 0.5 * best[10] < 0.05
    table = list(csv.DictReader((tmp_path / "accuracy.csv").read_text().splitlines()))
    assert [float(line["error"]) for line in table] == [run["error"] for p in found["programs"] for run in p["runs"]]
    assert all(knee["best"] is None or knee["best"]["error"] <= knee["error"] for knee in found["knees"])
