"""A work-precision study: points that outlive an interruption, processes that die, errors and the knee."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.studies.work_precision import (
    DIED,
    Curve,
    Plan,
    Reference,
    Row,
    Worker,
    WorkPrecision,
    _rows,
    reference_of,
)
from softcat_sym.studies.work_precision_programs import PROGRAMS, Measured, Task

TASK = Task("cvodes", 40, 1.0)
REFERENCE = Reference(np.array([0.0, -1.0, -2.0]), 1e-6, 2e-6, ("Rosenbrock", "BDF"), "made up")


def test_error_is_the_largest_of_the_largest() -> None:
    assert REFERENCE.error_of((0.0, -1.1, -2.0)) == pytest.approx(0.05)
    assert REFERENCE.error_of((0.0, -1.0)) == math.inf
    assert REFERENCE.error_of((0.0, math.nan, -2.0)) == math.inf
    assert REFERENCE.floor == 2e-6


def test_reference_of_a_known_order_is_extrapolated_to_the_limit() -> None:
    """Errors of 3 h^2 + h^4: Richardson's rule leaves those of h^4, and the stated uncertainty covers them."""

    def measure(task: Task) -> Measured:
        h = 1 / task.cells
        time_error = 1e-5 if task.program == "idas" else 0.0
        return Measured(1.0, midpoint=(0.0, -2.0 * (1 + 3 * h**2 + 30 * h**4) + time_error))

    found = reference_of(measure, 1.0, 8, compiled=True)
    left = abs(found.midpoint[-1] + 2.0) / 2.0
    assert 0 < left <= found.space < 1e-5
    assert found.time == pytest.approx(5e-6, rel=1e-3)


def test_a_second_family_without_an_answer_is_said() -> None:
    def measure(task: Task) -> Measured:
        return Measured(1.0, message="gave up") if task.program == "idas" else Measured(1.0, midpoint=(0.0, -1.0))

    found = reference_of(measure, 1.0, 0, compiled=True)
    assert math.isnan(found.time)
    assert "gave no answer (gave up)" in found.note
    with pytest.raises(SoftcatError, match="no reference"):
        reference_of(lambda task: Measured(1.0, message="bad"), 1.0, 0, compiled=True)
    with pytest.raises(SoftcatError, match="does not move"):
        reference_of(lambda task: Measured(1.0, midpoint=(0.0, 0.0)), 1.0, 0, compiled=True)


def test_a_rival_is_given_a_second_chance_and_not_a_third() -> None:
    """Stopped at a loose tolerance it is tried at the next; stopped there too it gets no finer grid."""
    plan = Plan(cells=(10, 20), tolerances=(1e-2, 1e-3, 1e-4, 1e-5))

    def rows(answers: dict[float, float]) -> list[tuple[int, float]]:
        def measure(task: Task) -> Measured:
            error = answers.get(task.rtol)
            if error is None:
                return Measured(10.0, message="stopped after 10 s, integrating")
            return Measured(1.0, midpoint=(0.0, -1.0, -2.0 * (1 + error)))

        program = next(program for program in PROGRAMS if program.key == "cvodes")
        found = _rows(program, plan, (1.0, 0), REFERENCE, measure, lambda what: None)
        return [(row.task.cells, row.task.rtol) for row in found]

    assert rows({}) == [(10, 1e-2), (10, 1e-3)]
    assert rows({1e-3: 1e-3, 1e-4: 1e-5}) == [(n, rtol) for n in (10, 20) for rtol in plan.tolerances]
    # 3e-4 cannot get better on this grid: one tolerance more shows it, and is the last.
    assert rows(dict.fromkeys(plan.tolerances, 3e-4)) == [(n, rtol) for n in (10, 20) for rtol in (1e-2, 1e-3, 1e-4)]


def test_knee_is_the_quickest_that_is_good_enough() -> None:
    own, rival = (next(p for p in PROGRAMS if p.kind == kind) for kind in ("own", "rival"))
    rows = [Row(TASK, Measured(t), e) for t, e in ((1.0, 1e-2), (2.0, 1e-4), (0.1, math.inf), (3.0, 1e-4))]
    slower = [Row(TASK, Measured(5.0), 1e-5)]
    curves = (Curve(own, tuple(rows), None), Curve(rival, tuple(slower), None))
    found = WorkPrecision("x", sc.load_scene("cold-honey"), (), 1.0, 10.0, REFERENCE, curves)
    best, other = found.knee(1e-4), found.knee(1e-4, ("rival",))
    assert best is not None
    assert other is not None
    assert (best[0], best[1].measured.seconds) == (own, 2.0)
    assert (other[0], other[1].measured.seconds) == (rival, 5.0)
    assert found.knee(1e-6) is None


@pytest.mark.slow  # each new process imports all of the package
def test_what_takes_too_long_is_ended_and_the_next_begins_anew(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.studies.work_precision._GRACE", 0.1)
    path = tmp_path / "scene.toml"
    scene = sc.load_scene("continual-descent", {"run.effects": "paper", "numerics.estimate": False})
    path.write_text(scene.to_toml())
    with Worker(path, 1.0) as worker:
        # Over ten thousand steps of 640 cells: more than a minute.
        long = worker.measure(Task("cvodes", 640, 30.0, rtol=1e-11))
        assert long.message == "stopped after 1 s, integrating"
        assert long.midpoint == ()
        assert not worker.measure(Task("cvodes", 10, 1.0, rtol=1e-2)).message
        # Killed from outside: listed, and the next task gets a new process.
        worker._running().kill()
        assert worker.measure(TASK).message.startswith(DIED)
        assert not worker.measure(Task("cvodes", 10, 1.0, rtol=1e-2)).message


@pytest.mark.slow
def test_a_run_over_the_limit_counts_as_stopped(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(sc.load_scene("continual-descent", {"run.effects": "paper"}).to_toml())
    with Worker(path, 1e-4) as worker:
        found = worker.measure(Task("cvodes", 10, 1.0, rtol=1e-2))
    assert found.message.startswith("stopped: it took")
    assert found.midpoint == ()


def test_measured_survives_being_written() -> None:
    whole = Measured(1.0, 2.0, 3, 4, 5, (0.0, -0.5), "", 6.0)
    assert Measured.from_document(json.loads(json.dumps(whole.document()))) == whole
    with pytest.raises(TypeError):
        Measured.from_document({"midpoint": [], "else": 1})
