"""What runs cost, as ratios of seconds of the processor: beside SciPy's Radau, IDAS, RK4, and other runs of our own.

Rivals solve the same scene in turns with this package, so that a busy machine slows both.
"""

from __future__ import annotations

import statistics
import time
import warnings
from collections.abc import Callable, Mapping
from types import SimpleNamespace

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.discretization.assembly import choose_grid
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SoftcatWarning
from softcat_sym.scene.scene import groups_of
from softcat_sym.single_run import build
from softcat_sym.solvers.compiled import CModel
from softcat_sym.solvers.lanes import LanesModel
from softcat_sym.solvers.solution import Silence
from softcat_sym.solvers.solve import Prepared
from softcat_sym.studies.integrators import Task, ready
from tests.common.rk4_filament import run as rk4
from tests.common.table import show

pytestmark = [pytest.mark.slow, pytest.mark.skipif(find_compiler() is None, reason="no C compiler")]

DESCENT, ENOUGH = "continual-descent", 1e-3
"""The scene, and the error of its last midpoint against the converged one."""

CONVERGED = {DESCENT: -0.24427817, f"{DESCENT}, fibres": -0.24936181, "arrested-overdamped, fibres": -0.06645224}
"""Last midpoints over the rest length for vanishing cells and steps, of 160 and 320 cells at rtol 1e-6; to 4e-7."""


def ready_to_solve(name: str, *, fibres: bool = False, cells: int = 40, **numerics: object) -> Prepared:
    """A bundled scene with the paper's effects, or with shear and six fibres besides; cells as long at the clamps."""
    changes: dict[str, object] = {"run.frames": 2, "run.effects": "paper"}
    if fibres:
        published = choose_effects(sc.load_scene(name, changes)).names
        changes |= {"run.effects": [*published, "shear", "fibres"], "numerics.fibres": 6}
    lengths = choose_grid(sc.load_scene(name, {**changes, "numerics.cells": 40})).cell_length
    changes |= {"numerics.cells": cells, "numerics.grading": float(lengths[0] / lengths[-1])}
    scene = sc.load_scene(name, changes | {f"numerics.{key}": value for key, value in numerics.items()})
    return build(scene, choose_effects(scene))


def seconds(calls: Mapping[str, Callable[[], object]], repeats: int = 5) -> dict[str, float]:
    """Medians of seconds of the processor; each is called once before."""
    spent: dict[str, list[float]] = {name: [] for name in calls}
    for turn in range(repeats + 1):
        for name, call in calls.items():
            began = time.process_time()
            call()
            if turn:
                spent[name].append(time.process_time() - began)
    return {name: statistics.median(found) for name, found in spent.items()}


def last_midpoint(prepared: Prepared) -> float:
    return float(prepared.solve(Silence()).x[prepared.graph.differential.kinds.index("y"), -1])


def table(title: str, spent: Mapping[str, float], errors: Mapping[str, float]) -> None:
    base = next(iter(spent.values()))
    rows = [[name, f"{1e3 * one:.1f}", f"{one / base:.1f}", f"{errors[name]:.1e}"] for name, one in spent.items()]
    show(title, ("", "ms of the processor", "times ours", "error"), rows)


def test_published_physics_beside_radau_and_rk4() -> None:
    """Radau has our C and its exact Jacobian. RK4 has no step control, and cells that are all alike: it is 7e-3 off."""
    ours = ready_to_solve(DESCENT, rtol=3e-3)
    lengths, paper = ours.graph.grid.cell_length, {"run.frames": 2, "run.effects": "paper"}
    # Of 1e-1 to 1e-3 this tolerance costs the least.
    task = Task("scipy-radau", 40, float(lengths[0] / lengths[-1]), rtol=3e-2)
    radau = ready(sc.load_scene(DESCENT, paper), task)
    spent = seconds({"ours": lambda: ours.solve(Silence()), "Radau": radau})
    groups = groups_of(sc.load_scene(DESCENT))
    assert groups.G is not None and groups.V is not None
    began = time.process_time()
    plain = rk4(groups.delta, groups.G, groups.V, groups.eps_Y, "bingham", "material", 40, 460.0)
    spent["RK4"] = time.process_time() - began
    found = {"ours": last_midpoint(ours), "Radau": radau().midpoint[-1], "RK4": float(plain.midpoint[-1])}
    errors = {name: one / CONVERGED[DESCENT] - 1 for name, one in found.items()}
    table(f"{DESCENT}, published physics, N = 40", spent, errors)
    assert max(abs(errors["ours"]), abs(errors["Radau"])) < ENOUGH
    assert spent["Radau"] > 8 * spent["ours"] and spent["RK4"] > 500 * spent["ours"]


@pytest.mark.parametrize("name", [DESCENT, "arrested-overdamped"])
def test_shear_and_fibres_beside_idas(name: str) -> None:
    """Measured 6 to 10 times faster than IDAS on the interpreted graph."""
    sides = {"ours": ready_to_solve(name, fibres=True, rtol=3e-3)}
    sides["IDAS"] = ready_to_solve(name, fibres=True, backend="interpreted", solver="idas", rtol=1e-4)
    spent = seconds({side: (lambda one=one: one.solve(Silence())) for side, one in sides.items()}, 3)
    errors = {side: last_midpoint(one) / CONVERGED[f"{name}, fibres"] - 1 for side, one in sides.items()}
    table(f"{name}, shear and 6 fibres, N = 40", spent, errors)
    assert max(map(abs, errors.values())) < ENOUGH
    assert spent["IDAS"] > 3.5 * spent["ours"]


def test_a_step_costs_in_proportion_to_the_cells() -> None:
    """16 times the cells, at most 28 times a step; with velocities held too tightly the steps were 23 times as many."""
    few, many = (ready_to_solve(DESCENT, fibres=True, cells=cells, rtol=1e-4) for cells in (40, 640))
    spent = seconds({"40": lambda: few.solve(Silence()), "640": lambda: many.solve(Silence())}, 3)
    steps = [one.solve(Silence()).steps for one in (few, many)]
    show("cells", ("", "ms", "steps"), [[n, 1e3 * s, k] for (n, s), k in zip(spent.items(), steps, strict=True)])
    assert spent["640"] / steps[1] < 28 * spent["40"] / steps[0]
    assert steps[1] < 8 * steps[0]


def test_three_dimensions_beside_the_plane() -> None:
    """An ink strand in a side wind, 15 points a section: a step of a cell costs at most 3.5 times that of its plane."""
    settings = {"numerics.cells": 20, "numerics.estimate": False}
    planar, spatial = sc.load_scene("ink-bridge", settings), sc.load_scene("windy-ink", settings)
    each = {}
    for name, scene in (("plane", planar), ("15 points", spatial.replace({"numerics.fibres": 15}))):
        prepared = build(scene, choose_effects(scene))
        spent = seconds({name: lambda prepared=prepared: prepared.solve(Silence())}, 3)[name]
        each[name] = 1e6 * spent / prepared.solve(Silence()).steps / prepared.graph.grid.cells
    show("us a cell and step", tuple(each), [[f"{one:.1f}" for one in each.values()]])
    assert each["15 points"] < 3.5 * each["plane"]


def test_lanes_beside_filaments_one_by_one(monkeypatch: pytest.MonkeyPatch) -> None:
    """Seconds of the processor in C; few members are not worth lanes."""
    quick = {"run.effects": "paper", "numerics.cells": 40, "numerics.rtol": 1e-2}
    scene, random = sc.load_scene("arrested-overdamped", quick), np.random.default_rng(0)
    varied = {"groups.G": random.uniform(0.3, 0.6, 160), "groups.V": random.uniform(15, 40, 160)}
    spent: list[float] = []

    def timed(call: Callable[..., object]) -> Callable[..., object]:
        def inner(*given: object) -> object:
            began = time.thread_time()
            try:
                return call(*given)
            finally:
                spent.append(time.thread_time() - began)

        return inner

    monkeypatch.setattr(CModel, "integrate", timed(CModel.integrate))
    monkeypatch.setattr(LanesModel, "integrate", timed(LanesModel.integrate))
    took: dict[int, list[float]] = {160: [], 40: []}
    for _ in range(2):
        for members, found in took.items():
            spent.clear()
            sc.simulate_many(scene, {key: values[:members] for key, values in varied.items()}, workers=1)
            found.append(sum(spent) / members)
    lanes, one_by_one = (1e3 * min(found) for found in took.values())
    show("ms of a member in C", ("lanes", "one by one"), [[f"{lanes:.2f}", f"{one_by_one:.2f}"]])
    assert one_by_one > 1.5 * lanes


@pytest.mark.parametrize("name", ["continual-descent", "cold-honey", "bread-dough", "polymer-thread"])
def test_the_price_of_the_next_digit_is_right_within_a_factor_of_two(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    # Others use the machine: the clock of a run counts what it does itself. Compilers are counted apart.
    clock = SimpleNamespace(**vars(time) | {"perf_counter": time.process_time})
    monkeypatch.setattr("softcat_sym.progress.time", clock)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", SoftcatWarning)
        found, accuracy = [], {}
        for _ in range(2):
            scene = sc.load_scene(name, accuracy)
            sc.simulate(scene)  # What is compiled and imported is there for the second
            began = time.process_time()
            summary = sc.simulate(scene).summary
            found.append((summary, time.process_time() - began))
            accuracy = {"run.accuracy": summary["next_digit"]["accuracy"]}
    price, taken = found[0][0]["next_digit"]["seconds"], found[1][1]
    show("the next digit", ("scene", "foretold [s]", "taken [s]"), [[name, f"{price:.2f}", f"{taken:.2f}"]])
    assert 0.5 <= price / taken <= 2
