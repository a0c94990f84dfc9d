"""Which backend a run gets, that it says so, and that nothing is hidden where the compiled one cannot be had."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.library import cache_entries
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers import compiled as c_model
from softcat_sym.solvers import compiled as compiling
from softcat_sym.solvers import settings as backend
from softcat_sym.solvers.settings import choose_backend
from tests.acceptance.table import show
from tests.common.compilers import Counter, compiler

from .filaments import scene_of, without

NO_COMPILER = "there is no C compiler that runs: install gcc or clang, or set CC"


def asking(scene: Scene, **numerics: Any) -> Scene:
    return scene.replace({f"numerics.{key}": value for key, value in numerics.items()})


def chosen(scene: Scene) -> backend.Backend:
    return choose_backend(scene, choose_effects(scene))


@pytest.fixture
def machine_without_a_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(backend, "find_compiler", lambda: None)


@pytest.fixture
def nothing_compiled_yet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An empty cache, and a process that has loaded nothing."""
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    _forget()
    yield tmp_path / "cache"
    _forget()


def _forget() -> None:
    compiling.compiled_model.cache_clear()
    c_model._runtime.cache_clear()


def test_auto_is_compiled_where_there_is_a_compiler() -> None:
    found, version = chosen(scene_of()), find_compiler()
    assert version is not None
    assert (found.compiled, found.reason) == (True, version.version)


@pytest.mark.usefixtures("machine_without_a_compiler")
def test_auto_is_interpreted_where_there_is_none() -> None:
    found = chosen(scene_of())
    assert (found.compiled, found.reason) == (False, NO_COMPILER)
    run = sc.simulate(scene_of())
    assert run.outcome is sc.Outcome.solved
    assert run.summary["backend"] == "interpreted"
    assert run.summary["backend_reason"] == NO_COMPILER


def test_the_summary_says_which_and_why() -> None:
    compiled, asked = sc.simulate(scene_of()), sc.simulate(asking(scene_of(), backend="interpreted"))
    assert compiled.summary["backend"] == "compiled"
    assert compiled.summary["backend_reason"] == chosen(scene_of()).reason
    assert compiled.summary["solver"] == "rosenbrock"
    assert asked.summary["backend"] == "interpreted"
    assert asked.summary["backend_reason"] == "named in numerics.backend"
    midpoints = [run.data.midpoint.values for run in (compiled, asked)]
    size = np.max(np.abs(midpoints[1]))
    np.testing.assert_allclose(*midpoints, rtol=0, atol=compiled.scene.run.accuracy * size)


EQUILIBRIA = without(scene_of("elastic"), "inertia")
SMALL = scene_of("elastic").replace({"model": "small-deflection", "run.effects": "auto"})


@pytest.mark.parametrize(
    ("scene", "why"),
    [(SMALL, "one number for all cells"), (EQUILIBRIA, "nothing to integrate, only a row of equilibria")],
)
def test_what_has_no_compiled_form_is_interpreted_or_refused(scene: Scene, why: str) -> None:
    assert not chosen(scene).compiled
    assert why in chosen(scene).reason
    _refused(scene, why)


@pytest.mark.usefixtures("machine_without_a_compiler")
def test_compiled_is_refused_where_there_is_no_compiler() -> None:
    _refused(scene_of(), NO_COMPILER)


def _refused(scene: Scene, why: str) -> None:
    with pytest.raises(SceneError) as refusal:
        sc.simulate(asking(scene, backend="compiled"))
    (fault,) = refusal.value.faults
    assert fault.path == "numerics.backend"
    assert why in fault.found
    assert fault.accepted == "auto or interpreted"


def test_an_integrator_of_casadi_is_interpreted_unless_asked_otherwise() -> None:
    found = chosen(asking(scene_of(), solver="cvodes"))
    assert not found.compiled
    assert "cvodes is named in numerics.solver" in found.reason


@pytest.mark.parametrize(("solver", "inertia"), [("cvodes", True), ("idas", False)])
def test_an_integrator_of_casadi_may_have_its_right_hand_side_compiled(solver: str, inertia: bool) -> None:
    scene = asking(scene_of() if inertia else without(scene_of(), "inertia"), solver=solver)
    one, other = (sc.simulate(asking(scene, backend=name)) for name in ("compiled", "interpreted"))
    assert one.summary["backend"] == "compiled"
    assert one.summary["solver"] == other.summary["solver"] == solver
    midpoints = [run.data.midpoint.values for run in (one, other)]
    np.testing.assert_allclose(*midpoints, rtol=0, atol=1e-4 * np.max(np.abs(midpoints[1])))


def test_a_failed_compilation_is_an_error_with_the_compilers_words(
    nothing_compiled_yet: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Never a silent fall back on the interpreted one."""
    compiler(tmp_path, monkeypatch, 'echo "filament.c:7:1: error: stray wrench in program" >&2; exit 1')
    with pytest.raises(SoftcatError, match=r"filament\.c:7:1: error: stray wrench in program"):
        sc.simulate(scene_of())
    assert cache_entries() == ()
    assert not list(nothing_compiled_yet.rglob("*.c"))


def test_a_variable_that_names_no_compiler_is_no_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "/nowhere/cc")
    assert chosen(scene_of()).reason == NO_COMPILER


RUN = """
import json, time
began = time.perf_counter()
from tests.solve.filaments import scene_of
import softcat_sym as sc
done = sc.simulate(scene_of())
print(json.dumps([done.summary["wall_s"]["compile"], time.perf_counter() - began, done.data.midpoint.values.tolist()]))
"""


@pytest.mark.slow
def test_a_second_process_compiles_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    counter = Counter(tmp_path, monkeypatch)
    found, compilations = [], []
    for _ in range(2):
        said = subprocess.run([sys.executable, "-c", RUN], capture_output=True, text=True, check=True).stdout
        found.append(json.loads(said))
        compilations.append(counter.compilations)
    assert compilations == [2, 2], "the runtime and the filament, once"
    assert found[0][2] == found[1][2]
    rows = [[name, f"{one[0]:.3f}", f"{one[1]:.2f}"] for name, one in zip(("first", "second"), found, strict=True)]
    show("two processes, one cache", ("process", "text and library [s]", "everything, imports too [s]"), rows)
