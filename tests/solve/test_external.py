"""Compiled right-hand sides and solvers find what the interpreted ones find."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

from softcat_sym.codegen.c_printer import CSource
from softcat_sym.codegen.compiler import cache_folder
from softcat_sym.codegen.export import rosenbrock
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers import compiled as external_module
from softcat_sym.solvers.compiled import External, compiled_rhs, compiled_rosenbrock
from softcat_sym.solvers.run import Prepared
from softcat_sym.solvers.solution import Silence
from tests.common.compilers import Counter

from .filaments import graph_of, prepared, scene_of, without


def few_cells(inertia: bool) -> Scene:
    scene = scene_of("maxwell" if inertia else "bingham", cells=4)
    return scene if inertia else without(scene, "inertia")


@cache
def run(inertia: bool) -> Prepared:
    return prepared(few_cells(inertia), solver="cvodes" if inertia else "idas", rtol=1e-6, atol=1e-8)


@cache
def compiled(inertia: bool) -> External:
    return compiled_rhs(run(inertia).graph)


def integrated(of: Prepared, external: External | None) -> ca.DM:
    """States at the end of a few intervals, with the settings of the run."""
    graph, settings = of.graph, of.settings
    if external is None:
        t, (x, z, p) = graph.t, (graph.x, graph.z, graph.p)
        ode, alg, quad = graph.ode, graph.alg, graph.quad
    else:
        t, (x, z, p) = ca.MX.sym("t"), external.symbols()
        (ode, alg), quad = external.rhs(t, x, z, p), external.powers(t, x, z, p)
    # The powers as unknowns too, as where nothing but flow limits the steps: their slopes are then asked for.
    work = type(x).sym("work", 3)
    dae = {"t": t, "x": ca.vertcat(x, work), "p": p, "ode": ca.vertcat(ode, quad)}
    dae |= {"z": z, "alg": alg} if graph.is_dae else {}
    assert of.start is not None
    call = ca.integrator("call", settings.solver, dae, 0, [0.1, 0.2, 0.3], settings.options())
    return call(x0=ca.vertcat(of.start.x, 0, 0, 0), z0=of.start.z, p=of.p)["xf"]


@pytest.mark.parametrize("inertia", [True, False])
def test_right_hand_sides_agree_at_random_states(inertia: bool) -> None:
    graph, p, rng = run(inertia).graph, run(inertia).p, np.random.default_rng(2)
    wanted = ca.Function("wanted", [graph.t, graph.x, graph.z, graph.p], [graph.ode, graph.alg, graph.quad])
    for _ in range(5):
        states = [v + 0.01 * rng.standard_normal(len(v)) for v in (graph.start, graph.straight)]
        at = (float(rng.random()), *states, p)
        for one, other in zip((*compiled(inertia).rhs(*at), compiled(inertia).powers(*at)), wanted(*at), strict=True):
            scale = float(ca.norm_inf(other)) if other.numel() else 1.0
            np.testing.assert_allclose(np.asarray(one), np.asarray(other), rtol=0, atol=1e-12 * scale)


@pytest.mark.parametrize("inertia", [True, False])
def test_cvodes_and_idas_find_the_same_with_it(inertia: bool) -> None:
    one, other = (np.asarray(integrated(run(inertia), way)) for way in (None, compiled(inertia)))
    assert np.max(np.abs(other[-3:])) > 0
    np.testing.assert_allclose(one, other, rtol=0, atol=1e-6 * np.max(np.abs(other)))


@pytest.mark.parametrize("inertia", [True, pytest.param(False, marks=pytest.mark.slow)])
def test_the_compiled_solver_repeats_the_interpreted_one(inertia: bool) -> None:
    of = run(inertia)
    settings = replace(of.settings, solver="rosenbrock")
    assert of.start is not None
    given = {"x0": of.start.x, "z0": of.start.z, "p": of.p, "start": 0, "interval": of.times[1]}
    found = compiled_rosenbrock(of.graph, settings, len(of.times))(**given)
    same = rosenbrock(of.graph, len(of.times), settings.options())(**given)
    # The program's own goes by chunks, and so in other steps.
    solution = prepared(few_cells(inertia), solver="rosenbrock", rtol=settings.rtol, atol=settings.atol).solve(
        Silence()
    )
    other = {"xf": solution.x, "zf": solution.z, "qf": solution.quad}
    for name, states in other.items():
        scale = np.max(np.abs(states)) if states.size else 1.0
        np.testing.assert_allclose(np.asarray(found[name]), np.asarray(same[name]), rtol=0, atol=1e-9 * scale)
        np.testing.assert_allclose(np.asarray(found[name]), states, rtol=0, atol=10 * settings.rtol * scale)


def test_it_is_compiled_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    counter = Counter(tmp_path, monkeypatch)
    small = graph_of(scene_of("elastic", cells=4))
    first = compiled_rhs(small)
    calls = counter.calls
    assert compiled_rhs(small).library == first.library
    assert first.library.is_relative_to(cache_folder())
    assert (counter.compilations, counter.calls) == (1, calls)
    assert not any("-march" in call for call in calls if "-shared" in call)


def test_what_the_compiler_says_reaches_the_user(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path))
    monkeypatch.setattr(
        external_module, "rhs_source", lambda graph: CSource({"broken.c": "int f(void) { return g; }\n"})
    )
    with pytest.raises(SoftcatError, match=r"cannot compile[^$]*broken\.c:1[^$]*'?g'? undeclared"):
        compiled_rhs(run(False).graph)
