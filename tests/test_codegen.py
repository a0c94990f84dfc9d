"""The C of every filament says what its interpreted graph says; its text is one, short, and the same every time."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import FunctionType
from typing import Any

import casadi as ca
import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym import store
from softcat_sym.codegen import model as models
from softcat_sym.codegen.c_printer import CSource
from softcat_sym.codegen.library import kept_texts
from softcat_sym.codegen.model import Structure, model_for, template_kept, template_of
from softcat_sym.codegen.recording import record
from softcat_sym.codegen.right_hand_side import Dynamics, rhs_source, rolled
from softcat_sym.discretization.graph import Graph
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.physics.laws import Branch, Flow
from softcat_sym.physics.symbols import sigma
from softcat_sym.solvers.run import assembled
from tests.common.assembled import graph_of, short_scene, without
from tests.common.pairs import differences, pair_of

SAME, SEEDS, LONGEST = 1e-12, range(3), 200_000
PAPER = ("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow")
WITH_FIBRES = [*PAPER, "yielding", "gravity-ramp", "shear", "fibres", "necking-gradient"]
# Structures that differ in what the unknowns are, in the ends and in the supports.
KINDS: dict[str, tuple[str, dict[str, Any]]] = {
    "paper": ("continual-descent", {"run.effects": "paper"}),
    "string": ("stretched-rubber-band", {"run.effects": ["inertia", "extensibility", "large-rotation"]}),
    "fibres, necking": ("arrested-overdamped", {"run.effects": WITH_FIBRES, "numerics.fibres": 4}),
    "profile, free end": ("curled-rod", {"filament.profile": [1.5, 1.0, 0.5]}),
    "point mass, no inertia": ("beam-viscometer", {}),
    "several modes": ("polyethylene-melt", {}),
    "a law of one's own": ("transient-gel", {}),
    "viscous stress, moving support": ("drawn-blob", {}),
    "supports apart": ("slime-slope", {"numerics.grading": 4.0}),
    "printed closure": ("continual-descent", {"run.effects": "paper", "run.closure": "printed"}),
    "linear beam": ("no-yield", {"run.effects": ["inertia", "bending", "gravity-ramp"]}),
    "profile, point mass": ("silicone-thread", {"filament.profile": [1, 0.8, 1], "load.point_mass": "10 mg"}),
    "surface tension": ("silicone-thread", {"run.effects": [*PAPER, "surface-tension"]}),
    "surface tension, profile, fibres, necking": (
        "ink-bridge",
        {"filament.profile": [1, 0.8, 1], "run.effects": [*WITH_FIBRES, "surface-tension"], "numerics.fibres": 3},
    ),
    "surface tension of a rectangle": (
        "continual-descent",
        {
            "filament.width": "3 mm",
            "filament.profile": [1, 0.8, 1],
            "surroundings.surface_tension": "2 N/m",
            "run.effects": [*PAPER, "yielding", "surface-tension"],
        },
    ),
}
QUICK = list(KINDS)[:9]
TEXTS = """
import hashlib, sys
from softcat_sym.codegen.right_hand_side import rhs_source
from tests.common.assembled import graph_of, short_scene
from tests.test_codegen import pair_of, scene_of
print(rhs_source(graph_of(short_scene("elastic"))).digest)
for kind in ("paper", "fibres, necking", "viscous stress, moving support"):
    print(kind, hashlib.sha256(pair_of(scene_of(kind)).model.text.encode()).hexdigest())
"""
KEYS = """
import softcat_sym as sc
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.solvers.run import assembled
for name in ("arrested-overdamped", "bread-dough"):
    scene = sc.load_scene(name)
    print(assembled(scene, choose_effects(scene)).structure().key)
"""


def printed(code: str, seed: str) -> str:
    """What a new process prints."""
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    command = [sys.executable, "-c", code]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=True).stdout


def scene_of(kind: str, **changes: Any) -> sc.Scene:
    name, own = KINDS[kind]
    more = {key.replace("__", "."): value for key, value in changes.items()}
    return sc.load_scene(name, {"numerics.cells": 6, **own, **more})


def check(label: str, scene: sc.Scene) -> None:
    pair = pair_of(scene)
    worst = differences(pair, SEEDS)
    assert max(worst.values()) < SAME, (label, worst)
    assert len(pair.model.text.encode()) < LONGEST, label


@pytest.mark.parametrize(
    "kind", [kind if kind in QUICK else pytest.param(kind, marks=pytest.mark.slow) for kind in KINDS]
)
def test_every_number_is_that_of_the_graph(kind: str) -> None:
    check(kind, scene_of(kind))
    if kind in ("paper", "fibres, necking", "viscous stress, moving support"):
        check(f"{kind}, the smallest grid", scene_of(kind, numerics__cells=4))
        check(f"{kind}, graded", scene_of(kind, numerics__cells=9, numerics__grading=3.0))


@pytest.mark.slow
def test_every_number_of_every_bundled_scene_is_that_of_the_graph() -> None:
    for name in sc.bundled_names():
        check(name, sc.load_scene(name))
        check(f"{name}, the smallest grid", sc.load_scene(name, {"numerics.cells": 4}))


def test_a_parameter_that_is_a_little_off_would_be_noticed() -> None:
    pair = pair_of(scene_of("fibres, necking"))
    off = pair.p.copy()
    off[pair.graph.parameters.index("youngs_modulus")] *= 1 + 1e-9
    worst = differences(pair, SEEDS, replace(pair, p=off))
    assert all(SAME < value < 1e-5 for value in worst.values()), worst


def test_one_text_for_every_grid_and_every_number() -> None:
    for kind in ["paper", "fibres, necking"]:
        base = pair_of(scene_of(kind)).model
        for changes in (
            {"numerics__cells": 40, "numerics__grading": 1.0},
            {"material__youngs_modulus": "5 MPa", "filament__span": "0.3 m", "load__ramp": "0.2 s"},
            {"run__duration": "3 s", "run__frames": 7, "run__accuracy": 0.01},
        ):
            assert pair_of(scene_of(kind, **changes)).model is base, changes


@pytest.mark.slow
def test_texts_are_the_same_whatever_the_hash_seed() -> None:
    texts = {printed(TEXTS, seed) for seed in ("1", "2")}
    assert len(texts) == 1 and texts.pop().count("\n") == 4


@cache
def graph(law: str = "bingham", inertia: bool = True, cells: int = 5) -> Graph:
    scene = short_scene(law, cells=cells)
    return graph_of(scene if inertia else without(scene, "inertia"))


def test_the_plain_right_hand_side_has_every_value_and_slope_of_the_graph() -> None:
    for law, inertia in [("elastic", True), ("bingham", True), ("bingham", False)]:
        of, rng = graph(law, inertia), np.random.default_rng(5)
        states = [start + 0.05 * rng.standard_normal(len(start)) for start in (of.start, of.straight)]
        at, symbols = (0.3, *states, 1 + 0.1 * rng.random(of.p.numel())), [of.t, of.x, of.z, of.p]
        dynamics = Dynamics(of)
        blocks = [ca.jacobian(value, by) for value in (of.ode, of.alg) for by in symbols[:3]]
        for function, expressions in [
            (dynamics.rhs, [of.ode, of.alg]),
            (dynamics.jacobian, blocks),
            (dynamics.local_powers, [ca.vertcat(*of.powers)]),
        ]:
            wanted = ca.Function("wanted", symbols, expressions).call(at)
            for one, other in zip(function.call(at), wanted, strict=True):
                np.testing.assert_array_equal(np.asarray(one), np.asarray(other))
        wanted = ca.Function("wanted", symbols, [ca.jacobian(of.quad, by) for by in symbols[:3]]).call(at)
        for one, other in zip(dynamics.powers.jacobian()(*at, 0)[:3], wanted, strict=True):
            np.testing.assert_allclose(np.asarray(one), np.asarray(other), rtol=1e-12, atol=1e-14)


def test_cells_that_do_the_same_are_calls_of_one_function() -> None:
    x = ca.SX.sym("x", 200)
    inner = ca.sin(x[1:]) * x[:-1]
    function = ca.Function("chain", [x], [inner[1:] - inner[:-1] * np.linspace(1, 2, 198)], ["x"], ["out"])
    found = rolled(function, [list(range(198))])
    assert found.n_instructions() < 60 < function.n_instructions()
    at = np.random.default_rng(1).standard_normal(200)
    np.testing.assert_array_equal(np.asarray(found(at)), np.asarray(function(at)))
    x = ca.SX.sym("x", 3)
    function = ca.Function("plain", [x], [ca.vertcat(x[2], 7, x[0] ** 2), ca.SX(2, 2)], ["x"], ["a", "b"])
    one, two = rolled(function, [[0, 1, 2], []])([1.5, 2, 3])
    assert (np.asarray(one).ravel().tolist(), two.nnz()) == ([3, 7, 2.25], 0)
    few, many = (rhs_source(graph("elastic", cells=cells)).size for cells in (10, 20))
    assert many < 1.5 * few, "the text grows by tables only"


def test_a_source_says_what_it_is_and_a_digest_tells_names_from_texts() -> None:
    files = rhs_source(graph()).files
    assert list(files) == ["softcat_rhs.c", "softcat_rhs.h"]
    for text in files.values():
        for words in ("do not edit", f"CasADi {ca.CasadiMeta.version()}", "yield_stress", "softcat_jacobian"):
            assert words in text.split("*/")[0]
    assert CSource({"a": "bc"}).digest != CSource({"ab": "c"}).digest
    assert CSource({"a": "1", "b": "2"}).digest == CSource({"b": "2", "a": "1"}).digest


@pytest.fixture
def new_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path / "cache"))
    forget()


def forget() -> None:
    model_for.cache_clear()
    models._template.cache_clear()


def structure_in(name: str, **changes: Any) -> Structure:
    scene = sc.load_scene(name, {key.replace("__", "."): value for key, value in changes.items()})
    return assembled(scene, choose_effects(scene)).structure()


def never() -> Any:
    raise AssertionError("it was there already")


@pytest.mark.usefixtures("new_cache")
def test_a_text_that_is_read_from_the_cache_is_the_one_that_was_written(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ["maxwell-fast", "cold-honey"]:
        of = structure_in(name)
        written = template_of(record(of.equations, of.theory, of.ends, of.body))
        assert template_kept(of.key, lambda written=written: written) is written
        assert template_kept(of.key, never) == written
    of = structure_in("maxwell-fast", run__effects="paper")
    first = model_for(of)
    assert len(kept_texts()) == 3
    forget()
    assert model_for(of) == first and len(kept_texts()) == 3, "a further process writes none"
    monkeypatch.setattr(store, "_program", lambda: ["changed"])
    again: list[bool] = []
    template_kept(of.key, lambda: again.append(True) or written)
    assert again, "another program writes its own"


@pytest.mark.usefixtures("new_cache")
def test_another_number_of_fibres_is_another_library_of_the_same_template() -> None:
    first, second = (structure_in("ink-bridge", numerics__fibres=fibres) for fibres in (8, 12))
    assert first.key == second.key and first != second
    assert [len(model_for(of).slots) for of in (first, second)] == [5 + 2 * 8, 5 + 2 * 12]
    assert len(kept_texts()) == 1


def test_surface_tension_is_another_structure_and_its_size_is_not() -> None:
    """A library without it must never be taken for one that has it: the answer would be six times off, silently."""
    bare, pulled = structure_in("ink-bridge", surroundings__surface_tension="0 N/m"), structure_in("ink-bridge")
    assert set(pulled.effects) - set(bare.effects) == {"surface-tension"}
    assert pulled.key != bare.key and model_for(pulled).text != model_for(bare).text
    assert "surface_tension" in model_for(pulled).parameters
    assert structure_in("ink-bridge", surroundings__surface_tension="50 mN/m").key == pulled.key


def test_structures_have_the_same_names_in_every_process(monkeypatch: pytest.MonkeyPatch) -> None:
    assert printed(KEYS, "1").split() == [structure_in(name).key for name in ("arrested-overdamped", "bread-dough")]
    closure = (lambda: None,)
    here = models._digest(closure)
    namesake = FunctionType(never.__code__, {}, never.__name__)
    namesake.__module__ = "elsewhere"
    one, other = (models._digest((Branch(flow=Flow(sigma, closed_means=means)),)) for means in (never, namesake))
    assert one != other, "functions of one name in two modules are two"
    assert models._digest(closure) == here
    monkeypatch.setattr(models, "_PROCESS", "another")
    assert models._digest(closure) != here, "what only an address tells apart is not the same elsewhere"


@pytest.mark.slow
def test_no_bundled_scene_is_named_by_an_address(monkeypatch: pytest.MonkeyPatch) -> None:
    keys = {name: structure_in(name).key for name in sc.bundled_names()}
    monkeypatch.setattr(models, "_PROCESS", "another")
    assert {name: structure_in(name).key for name in keys} == keys
