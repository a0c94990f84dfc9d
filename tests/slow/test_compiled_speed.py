"""What generated C costs: beside C by hand, SciPy, NumPy, CasADi and SUNDIALS, on fine grids, and before it starts."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.library import SOON, STEADY, compile_library
from softcat_sym.scene.scene import groups_of
from softcat_sym.solvers import compiled as compiling
from softcat_sym.solvers.compiled import runtime_sources
from softcat_sym.solvers.settings import RODAS5P
from softcat_sym.solvers.solution import Silence
from tests.common.compiled_speed import REPEATS, Bare, GeneratedRates, compiled, error_of, medians, whole_error
from tests.common.rivals import casadi_rosenbrock, radau, scenes
from tests.common.rivals.casadi_rosenbrock import CompiledRosenbrock, Interpreted
from tests.common.rivals.kirchhoff_c import HandWritten
from tests.common.rivals.radau import RadauRival
from tests.common.rk4_filament import run as oracle
from tests.common.table import show

ENOUGH = 1e-3
DESCENT = "continual-descent"
# What is asserted leaves room for a machine that others use; the goals are in the docstrings.
HAND_WRITTEN = 1.9
MILLISECONDS, RADAU, RK4 = 5.0, 40, 2000
WITH_FIBRES = {DESCENT: 4.0, "arrested-overdamped": 3.5}
LINEAR, MORE_STEPS, COMPILATION = 56, 8, 6.0
FROM_CACHE, AGAIN = 4.0, 0.2
HEADER = ("", "ms", "ms of processor", "error", "steps", "times ours")


@pytest.mark.slow
def test_right_hand_side_against_c_by_hand() -> None:
    """Goal: 1.3 times as long. Measured 1.5: unknowns lie site by site, so that loops load with strides."""
    rows, ratios = [], []
    for cells in (40, 320):
        prepared = compiled(DESCENT, cells=cells)
        # Beside an answer: in one the forces of neighbours nearly cancel, and what is left is rounding.
        answer = prepared.solve(Silence()).x[:, -1]
        state = answer + 1e-4 / cells * np.random.default_rng(0).normal(size=answer.shape)
        ours, hand = GeneratedRates(prepared), HandWritten(prepared.graph, prepared.p)
        one, other = ours.rates(0.3, state), hand.rates(0.3, state)
        difference = float(np.max(np.abs(one - other)) / np.max(np.abs(other)))
        calls = 800_000 // cells
        spent = [[side.seconds(0.3, state, calls) for side in (ours, hand)] for _ in range(9)]
        # Of neighbours in time, so that a machine that changes its pace changes both.
        ratios.append(float(np.median([a / b for a, b in spent])))
        found = np.median(spent, axis=0) * 1e6
        rows.append([cells, f"{found[0]:.3f}", f"{found[1]:.3f}", f"{ratios[-1]:.2f}", f"{difference:.0e}"])
        assert difference < 1e-12
    show("us per right-hand side, paper's physics", ("cells", "generated", "by hand", "ratio", "difference"), rows)
    assert ratios[0] < HAND_WRITTEN


@pytest.mark.slow
def test_paper_descent_against_scipy_and_the_rk4_oracle() -> None:
    """Goals: 5 ms, 40 times faster than Radau, 2000 times faster than RK4; to 1e-3 of the converged midpoint.

    Measured on a machine shared with others: 3.05 ms in one run, 58 and 5000 times, at a smaller error than Radau's, by
    Rodas4, which is the default where a filament yields and flows. RK4 has no step control, and cells that are all
    alike: it ends 7e-3 off.
    """
    prepared = compiled(DESCENT)
    bare, whole, fifth = Bare(prepared), prepared, Bare(prepared, RODAS5P)
    rival, tolerances = RadauRival(prepared), radau.LOOSEST[DESCENT]
    spent = medians(
        {
            "generated C": bare.solve,
            "generated C, Rodas5P": fifth.solve,
            "with powers and frames": lambda: whole.solve(Silence()),
            "SciPy's Radau": lambda: rival.solve(*tolerances),
        }
    )
    groups = groups_of(sc.load_scene(DESCENT))
    assert groups.G is not None and groups.V is not None
    began = time.process_time()
    plain = oracle(groups.delta, groups.G, groups.V, groups.eps_Y, "bingham", "material", 40, 460.0)
    plain_processor = time.process_time() - began
    ours, higher, other = bare.solve(), fifth.solve(), rival.solve(*tolerances)
    errors = {
        "generated C": error_of(ours, DESCENT),
        "generated C, Rodas5P": error_of(higher, DESCENT),
        "with powers and frames": whole_error(whole, DESCENT),
        "SciPy's Radau": error_of(other, DESCENT),
        "RK4 in NumPy": float(plain.midpoint[-1]) / scenes.converged_midpoint(DESCENT) - 1,
    }
    steps = [ours.steps, higher.steps, ours.steps, other.steps, plain.steps]
    walls = [*(one.wall for one in spent.values()), plain.wall_seconds]
    processor = [*(one.processor for one in spent.values()), plain_processor]
    rows = [
        [name, f"{w * 1e3:.2f}", f"{s * 1e3:.2f}", f"{error:.1e}", step, f"{s / processor[0]:.1f}"]
        for (name, error), w, s, step in zip(errors.items(), walls, processor, steps, strict=True)
    ]
    show(f"{DESCENT}, paper's physics, N = 40, medians of {REPEATS} (RK4 once)", HEADER, rows)
    assert all(abs(error) < ENOUGH for error in list(errors.values())[:4])
    assert processor[0] < MILLISECONDS * 1e-3
    assert processor[3] / processor[0] > RADAU
    assert processor[4] / processor[0] > RK4


@pytest.mark.slow
@pytest.mark.parametrize("name", [DESCENT, "arrested-overdamped"])
def test_shear_and_fibres_against_casadi_and_idas(name: str) -> None:
    """Goal for the descent: 4 times faster than CasADi's rosenbrock as C, and than IDAS interpreted.

    Measured 7.4 and 6.3 times, in 9.8 ms; 10.3 and 6.1 of the arrested filament (its hinges need short steps).
    """
    prepared = compiled(name, "fibres")
    interpreted = scenes.prepare(name, "fibres", numerics={"backend": "interpreted"})
    bare = Bare(prepared)
    rosenbrock = CompiledRosenbrock(interpreted, *casadi_rosenbrock.LOOSEST[name, "fibres", "rosenbrock"])
    reltol, abstol = casadi_rosenbrock.LOOSEST[name, "fibres", "idas"]
    idas = Interpreted(interpreted, "idas", {**interpreted.settings.options(), "reltol": reltol, "abstol": abstol})
    calls: dict[str, Any] = {
        "generated C": bare.solve,
        "with powers and frames": lambda: prepared.solve(Silence()),
        "CasADi's rosenbrock as C": rosenbrock.solve,
        "IDAS interpreted": idas.solve,
    }
    spent = medians(calls)
    found = {label: calls[label]() for label in calls if label != "with powers and frames"}
    errors = {label: error_of(one, name, "fibres") for label, one in found.items()}
    errors["with powers and frames"] = whole_error(prepared, name, "fibres")
    base = spent["generated C"].processor
    rows = []
    for label, one in spent.items():
        steps = found[label].steps if label in found and found[label].steps else ""
        row = [label, f"{one.wall * 1e3:.1f}", f"{one.processor * 1e3:.1f}", f"{errors[label]:.1e}", steps]
        rows.append([*row, f"{one.processor / base:.1f}"])
        assert abs(errors[label]) < ENOUGH, label
    show(f"{name}, shear and 6 fibres, N = 40, medians of {REPEATS}", HEADER, rows)
    for label in ("CasADi's rosenbrock as C", "IDAS interpreted"):
        assert spent[label].processor / base > WITH_FIBRES[name], label


@pytest.mark.slow
@pytest.mark.parametrize(("physics", "rtol"), [("paper", 1e-4), ("fibres", 1e-4)])
def test_cost_is_linear_in_the_number_of_cells(physics: scenes.Physics, rtol: float) -> None:
    """Goal: 32 times the cells under 40 times the time of a step; measured 38 to 45, with fibres 27 to 46.

    With velocities held as tightly as positions N = 640 took 6409 tries, not 281, most of them at one instant when
    a cell yields, to follow bending waves of that cell whose displacement is far below its tolerance.
    """
    sizes = (40, 320, 1280)
    runs = {cells: Bare(compiled(DESCENT, physics, cells, rtol)) for cells in sizes}
    spent = medians({str(cells): run.solve for cells, run in runs.items()}, 3)
    solved = {cells: run.solve() for cells, run in runs.items()}
    base, steps = spent["40"].processor, solved[40].steps
    rows, per_step = [], 0.0
    for cells in sizes:
        one = spent[str(cells)]
        per_step = one.processor / base * steps / solved[cells].steps
        times = [f"{one.wall * 1e3:.1f}", f"{one.processor * 1e3:.1f}", f"{one.processor / base:.1f}"]
        rows.append([cells, *times, solved[cells].steps, f"{per_step:.1f}", f"{solved[cells].midpoint:.6f}"])
    header = ("cells", "ms", "ms of processor", "times that of 40", "steps", "times a step", "midpoint")
    show(f"{DESCENT}, {physics}, rtol {rtol:g}, medians of 3", header, rows)
    assert per_step < LINEAR
    assert solved[sizes[-1]].steps < MORE_STEPS * steps


@pytest.mark.slow
def test_text_and_seconds_of_compilation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Goals: under 200 kB whatever the grid, under 3 s, for what is compiled once a scene."""
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path))
    rows, slowest = [], 0.0
    texts = {"runtime": runtime_sources()}
    header = {"softcat_model.h": texts["runtime"]["softcat_model.h"]}
    for label, name, physics in (("paper", DESCENT, "paper"), ("shear, fibres", DESCENT, "fibres")):
        prepared = compiled(name, physics)  # type: ignore[arg-type]
        texts[label] = {"filament.c": prepared.integration.filament.model.model.of_any_fibres, **header}  # type: ignore[union-attr]
    compiling.compiled_model.cache_clear()
    compiling._runtime.cache_clear()
    for label, files in texts.items():
        spent = []
        for k in range(5):
            wall = time.perf_counter()
            compile_library({**files, "again.h": f"/* {k} */\n"}, flags=STEADY if label == "runtime" else SOON)
            spent.append(time.perf_counter() - wall)
        size = sum(len(text.encode()) for text in files.values())
        rows.append([label, f"{size / 1e3:.0f}", f"{np.median(spent):.2f}"])
        assert size < 200_000
        slowest = max(slowest, float(np.median(spent)) if label != "runtime" else 0.0)
    show("C text and its compilation, medians of 5", ("", "kB", "seconds"), rows)
    assert slowest < COMPILATION


_STAGES = """
import json, sys, time
marks = [("interpreter", time.perf_counter())]
def mark(name): marks.append((name, time.perf_counter()))
import softcat_sym as sc
scene = sc.load_scene("continual-descent", json.loads(sys.argv[1])); mark("scene")
from softcat_sym.single_run import build
from softcat_sym.effects.choosing import choose_effects
mark("imports")
def line():
    effects = choose_effects(scene); mark("effects")
    build(scene, effects); mark("library, grid, parameters, start")
line()
first = {name: after - before for (_, before), (name, after) in zip(marks, marks[1:])}
marks = [("", time.perf_counter())]
line()
again = {name: after - before for (_, before), (name, after) in zip(marks, marks[1:])}
print(json.dumps([first, again]))
"""


@pytest.mark.slow
@pytest.mark.parametrize("physics", ["paper", "fibres"])
def test_seconds_before_a_solve_from_the_cache_starts(physics: str) -> None:
    """Goal: 50 ms. Met by a further run of the same process, missed by a new one, which spends its time importing."""
    effects: dict[str, Any] = {"run.effects": "paper"} if physics == "paper" else {"numerics.fibres": 6}
    argument = json.dumps({**effects, "numerics.cells": 40})
    command = [sys.executable, "-c", _STAGES, argument]
    stages = []
    for _ in range(6):
        said = subprocess.run(command, capture_output=True, text=True, check=True, env=os.environ).stdout
        stages.append(json.loads(said))
    names = list(stages[0][0])
    first, again = ({n: float(np.median([one[k].get(n, 0.0) for one in stages[1:]])) for n in names} for k in (0, 1))
    rows = [[name, f"{first[name] * 1e3:.1f}", f"{again[name] * 1e3:.1f}"] for name in names]
    totals = sum(first.values()), sum(again.values())
    rows.append(["all", *(f"{total * 1e3:.0f}" for total in totals)])
    show(f"ms before the solve starts, {physics}, medians of 5", ("stage", "new process", "again, same process"), rows)
    assert totals[0] < FROM_CACHE
    assert totals[1] < AGAIN
