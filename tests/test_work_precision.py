"""What accuracy costs: the right-hand side that rivals are given, the reference, the knee, ``softcat accuracy``."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SoftcatError
from softcat_sym.single_run import build
from softcat_sym.solvers.rates import Rates
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.integrators import METHODS, THIS_PROGRAM, Measurement, Method, Task, ready, scene_of
from softcat_sym.studies.work_precision import (
    Answers,
    extrapolated,
)
from tests.common.in_process import Softcat

compiled = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
SHORT = {"run.effects": "paper", "run.duration": "0.05 s", "run.frames": 6, "numerics.estimate": False}
OWN = Method(THIS_PROGRAM, "softcat", "own", "compiled", "rosenbrock")


@pytest.fixture(scope="module")
def short() -> sc.Scene:
    scene = sc.load_scene("continual-descent", SHORT)
    return scene.replace({"run.effects": list(choose_effects(scene).names)})


@compiled
def test_jacobian_is_that_of_differences(short: sc.Scene) -> None:
    scene = scene_of(short, Task("scipy-radau", 12, 1.0, rtol=1e-9))
    prepared = build(scene, choose_effects(scene))
    assert prepared.start is not None and prepared.code is not None
    rates, solution = Rates(prepared.code, prepared.start, prepared.p), prepared.solve(Silence())
    state, step, t = np.append(solution.x[:, -1], solution.z[:, -1]), 1e-7, float(prepared.times[-1])
    moved = [rates.rates(t, state + step * unit) - rates.rates(t, state - step * unit) for unit in np.eye(len(state))]
    expected = np.array(moved).T / (2 * step)
    scale = {"rtol": 1e-5, "atol": 1e-6 * np.abs(expected).max()}
    np.testing.assert_allclose(rates.jacobian(t, state).toarray(), expected, **scale)


@pytest.mark.slow
@compiled
def test_methods_solve_the_same_equations(short: sc.Scene) -> None:
    exact = ready(short, Task("compiled-rodas5p", 12, 4.0, rtol=1e-9))().midpoint
    for method in ("compiled-rodas5p", "scipy-radau", "cvodes"):
        found = ready(short, Task(method, 12, 4.0, rtol=1e-6))().midpoint
        assert np.abs(found - exact).max() < 1e-4 * np.abs(exact).max(), method
    # Section angles without inertia have no rate; a stiffly accurate method has an answer nevertheless.
    sheared = short.replace({"run.effects": [*short.run.effects, "shear"]})
    exact = ready(sheared, Task("compiled-rodas5p", 12, 4.0, 4, 1e-9))().midpoint
    found = ready(sheared, Task("scipy-radau", 12, 4.0, 4, 1e-6))().midpoint
    assert np.abs(found - exact).max() < 1e-5 * np.abs(exact).max()


def ladder(number: int) -> Answers:
    """Errors of 3 h^2 + 30 h^4 on one grid after another."""
    answers: Answers = []
    for cells in (20, 40, 80, 160)[:number]:
        h = 1 / cells
        midpoint = (0.0, -2.0 * (1 + 3 * h**2 + 30 * h**4))
        answers.append((OWN, Task(THIS_PROGRAM, cells, 1.0), Measurement(1.0, midpoint=midpoint)))
    return answers


def test_reference_of_a_known_order_is_extrapolated_to_the_limit_and_confirmed_by_another_family() -> None:
    """Richardson's rule leaves errors of h^4, and the stated uncertainty covers them."""
    answers = ladder(4)
    found = extrapolated(answers)
    assert 0 < abs(found.midpoint[-1] + 2.0) / 2.0 <= found.space < 1e-5
    assert found.cells == (40, 80, 160) and math.isnan(found.confirmed(answers).time)
    rivals = {program.key: program for program in METHODS}
    for key, cells, shift in (("idas", 40, 1e-3), ("idas", 80, 1e-5), ("compiled-rodas5p", 160, 0.0)):
        midpoint = next(run.midpoint for _, task, run in ladder(4) if task.cells == cells)
        answers.append((rivals[key], Task(key, cells, 1.0), Measurement(1.0, midpoint=(0.0, midpoint[1] + shift))))
    confirmed = found.confirmed(answers)
    assert confirmed.time == pytest.approx(5e-6, rel=1e-2) and "IDAS (order 2), on 80 cells" in confirmed.note
    with pytest.raises(SoftcatError, match="2 of the three grids"):
        extrapolated(ladder(2))
    still = [(OWN, Task(THIS_PROGRAM, n, 1.0), Measurement(1.0, midpoint=(0.0, 0.0))) for n in (10, 20, 40)]
    with pytest.raises(SoftcatError, match="does not move"):
        extrapolated(still)


def test_faults_are_said_and_nothing_is_written(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    softcat = Softcat(monkeypatch, capsys)
    for options, named in (
        (("--limit", "0"), "--limit"),
        (("--set", "material.colour=red"), "material.colour"),
    ):
        done = softcat("accuracy", "continual-descent", "-o", str(tmp_path / "out"), *options)
        assert done.status == 2 and named in done.err, (options, done.err)
        assert not (tmp_path / "out").exists()
    (tmp_path / "file").write_text("")
    done = softcat("accuracy", "continual-descent", "-o", str(tmp_path / "file" / "out"))
    assert done.status == 2 and "not a directory" in done.err
