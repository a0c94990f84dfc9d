"""C by CasADi from any graph: the same numbers and the same text every time, with loops where cells are alike."""

from __future__ import annotations

import subprocess
import sys
from functools import cache

import casadi as ca
import numpy as np
import pytest

from softcat_sym.codegen.c_printer import CSource
from softcat_sym.codegen.export import Dynamics, rhs_source, solver_source
from softcat_sym.codegen.loops import rolled
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats

from ..solve.filaments import graph_of, scene_of, without

TEXT = """
from softcat_sym.codegen.export import rhs_source, solver_source
from tests.solve.filaments import graph_of, scene_of
graph = graph_of(scene_of("elastic"))
print(rhs_source(graph).digest, solver_source(graph, 3, {"reltol": 1e-4}).digest)
"""


@cache
def graph(law: str = "bingham", inertia: bool = True, cells: int = 5) -> Graph:
    scene = scene_of(law, cells=cells)
    return graph_of(scene if inertia else without(scene, "inertia"))


def point(of: Graph) -> tuple[float, Floats, Floats, Floats]:
    """Somewhere beside the straight filament; every parameter about one."""
    rng = np.random.default_rng(5)
    sizes = (of.x.numel(), of.z.numel(), of.p.numel())
    states = (np.asarray(start) + 0.05 * rng.standard_normal(len(start)) for start in (of.start, of.straight))
    return (0.3, *states, 1 + 0.1 * rng.random(sizes[2]))


@pytest.mark.parametrize(("law", "inertia"), [("elastic", True), ("bingham", True), ("bingham", False)])
def test_every_value_and_slope_is_that_of_the_graph(law: str, inertia: bool) -> None:
    of, at = graph(law, inertia), point(graph(law, inertia))
    dynamics = Dynamics(of)
    symbols = [of.t, of.x, of.z, of.p]
    blocks = [ca.jacobian(value, by) for value in (of.ode, of.alg) for by in symbols[:3]]
    pairs = [
        (dynamics.rhs, [of.ode, of.alg]),
        (dynamics.jacobian, blocks),
        (dynamics.local_powers, [ca.vertcat(*of.powers)]),
    ]
    for function, expressions in pairs:
        wanted = ca.Function("wanted", symbols, expressions).call(at)
        for one, other in zip(function.call(at), wanted, strict=True):
            np.testing.assert_array_equal(np.asarray(one), np.asarray(other))
    slopes = dynamics.powers.jacobian()(*at, 0)[:3]
    wanted = ca.Function("wanted", symbols, [ca.jacobian(of.quad, by) for by in symbols[:3]]).call(at)
    for one, other in zip(slopes, wanted, strict=True):
        np.testing.assert_allclose(np.asarray(one), np.asarray(other), rtol=1e-12, atol=1e-14)


def test_cells_that_do_the_same_are_calls_of_one_function() -> None:
    x = ca.SX.sym("x", 200)
    inner = ca.sin(x[1:]) * x[:-1]
    function = ca.Function("chain", [x], [inner[1:] - inner[:-1] * np.linspace(1, 2, 198)], ["x"], ["out"])
    found = rolled(function, [list(range(198))])
    assert found.n_instructions() < 60 < function.n_instructions()
    at = np.random.default_rng(1).standard_normal(200)
    np.testing.assert_array_equal(np.asarray(found(at)), np.asarray(function(at)))


def test_outputs_may_be_inputs_constants_or_empty() -> None:
    x = ca.SX.sym("x", 3)
    function = ca.Function("plain", [x], [ca.vertcat(x[2], 7, x[0] ** 2), ca.SX(2, 2)], ["x"], ["a", "b"])
    one, two = rolled(function, [[0, 1, 2], []])([1.5, 2, 3])
    np.testing.assert_array_equal(np.asarray(one).ravel(), [3, 7, 2.25])
    assert two.nnz() == 0


def test_the_text_grows_by_tables_only() -> None:
    few, many = (rhs_source(graph(cells=cells)).size for cells in (20, 40))
    straight = ca.CodeGenerator("straight")
    of = graph(cells=40)
    for outputs in ([of.ode], [ca.jacobian(of.ode, of.x)], [ca.jacobian(of.quad, of.x)]):
        straight.add(ca.Function(f"f{len(outputs[0].sparsity().row())}", [of.t, of.x, of.z, of.p], outputs))
    assert many < 1.5 * few
    assert 2 * many < len(straight.dump())


@pytest.mark.slow
def test_the_text_is_the_same_whatever_the_hash_seed() -> None:
    texts = {
        subprocess.run(
            [sys.executable, "-c", TEXT], env={"PYTHONHASHSEED": seed}, capture_output=True, text=True, check=True
        ).stdout
        for seed in ("1", "2")
    }
    assert texts == {
        f"{rhs_source(graph('elastic')).digest} {solver_source(graph('elastic'), 3, {'reltol': 1e-4}).digest}\n"
    }


def test_the_header_says_what_it_is() -> None:
    files = rhs_source(graph()).files
    assert list(files) == ["softcat_rhs.c", "softcat_rhs.h"]
    for text in files.values():
        top = text.split("*/")[0]
        for said in ("do not edit", f"CasADi {ca.CasadiMeta.version()}", "yield_stress", "softcat_jacobian"):
            assert said in top


def test_a_digest_tells_names_from_texts() -> None:
    assert CSource({"a": "bc"}).digest != CSource({"ab": "c"}).digest
    assert CSource({"a": "1", "b": "2"}).digest == CSource({"b": "2", "a": "1"}).digest
