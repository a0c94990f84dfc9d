"""A flow rule of one's own, generated as C and compiled with the right-hand side, against the built-in law."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects import choose_effects
from softcat_sym.equations.filament import derive
from softcat_sym.equations.section import SECTIONS
from softcat_sym.graph import Graph, assemble
from softcat_sym.graph.choosing import choose_body, choose_grid, choose_theory
from softcat_sym.native import compile_library
from softcat_sym.solve import choose_settings, prepare

from .table import show
from .test_custom_law import PAIRS, difference, scene_of


def graph_of(scene: sc.Scene) -> Graph:
    """The graph that a run of the scene integrates."""
    effects, grid = choose_effects(scene), choose_grid(scene)
    equations = derive(effects.terms(), SECTIONS[scene.filament.section], scene.run.closure)
    return assemble(equations, grid, effects.names, choose_theory(scene, equations), choose_body(scene, grid))


def heights(scene: sc.Scene, *, compiled: bool) -> np.ndarray:
    """Midpoint in rest lengths over the run, with the right-hand side interpreted or compiled from its own C."""
    graph = graph_of(scene)
    prepared = prepare(scene, graph, choose_settings(scene, choose_effects(scene)))
    rate = ca.Function("rate", [graph.x, graph.t, graph.p], [graph.ode], ["x", "t", "p"], ["ode"])
    if compiled:
        generator = ca.CodeGenerator("rate.c")
        for function in (rate, rate.jacobian(), rate.forward(1), rate.reverse(1)):
            generator.add(function)
        rate = ca.external("rate", str(compile_library({"rate.c": generator.dump()}, flags=["-O1"])))
    x, t, p = ca.MX.sym("x", graph.x.numel()), ca.MX.sym("t"), ca.MX.sym("p", graph.p.numel())
    options = prepared.settings.options()
    call = ca.integrator(
        "run", "cvodes", {"x": x, "t": t, "p": p, "ode": rate(x, t, p)}, 0, prepared.times.tolist(), options
    )
    row = next(k for k, name in enumerate(graph.state_names) if name.startswith("y[0]"))
    return np.asarray(call(x0=graph.start, p=prepared.p)["xf"])[row]


@pytest.mark.parametrize("name", ["bingham", "herschel-bulkley"])
def test_compiled_it_is_the_same_again(name: str) -> None:
    """The C of the right-hand side holds the user's rule as it holds a built-in one."""
    built_in, own = (scene_of(dict(material), "paper") for material in PAIRS[name])
    runs = {
        "built-in, interpreted": heights(built_in, compiled=False),
        "built-in, compiled": heights(built_in, compiled=True),
        "custom, interpreted": heights(own, compiled=False),
        "custom, compiled": heights(own, compiled=True),
    }
    first = runs["built-in, interpreted"]
    errors = {label: difference(first, run) for label, run in runs.items()}
    show(f"{name} in C", ["right-hand side", "difference/sag"], [[k, f"{v:.1e}"] for k, v in errors.items()])
    assert max(errors.values()) < 1e-4
