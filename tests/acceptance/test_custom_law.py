"""A flow rule of one's own, one line in the scene, against the built-in law that it repeats: interpreted and in C."""

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

BODY = {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"}
PAIRS = {
    "maxwell": (
        {"law": "maxwell", "viscosity": "13.84 kPa*s"},
        {"flow": "sigma/e0", "parameters": {"e0": "13.84 kPa*s"}},
    ),
    "bingham": (
        {"law": "bingham", "viscosity": "13.84 kPa*s", "yield_stress": "2.5 kPa"},
        {
            "flow": "max(abs(sigma) - sY, 0)*sign(sigma)/e0",
            "parameters": {"e0": "13.84 kPa*s", "sY": "2.5 kPa"},
        },
    ),
    "power-law": (
        {"law": "power-law", "viscosity": "5 kPa*s^0.5", "index": 0.5},
        {"flow": "sigma*abs(sigma)/K**2", "parameters": {"K": "5 kPa*s^0.5"}},
    ),
    "herschel-bulkley": (
        {"law": "herschel-bulkley", "viscosity": "5 kPa*s^0.5", "index": 0.5, "yield_stress": "2.5 kPa"},
        {
            "flow": "(max(abs(sigma) - sY, 0)/K)**2*sign(sigma)",
            "parameters": {"K": "5 kPa*s^0.5", "sY": "2.5 kPa"},
        },
    ),
}


def scene_of(material: dict[str, object], effects: str) -> sc.Scene:
    """A clamped filament of 4 MPa that sags for half a second."""
    law = {"law": "custom", **material} if "flow" in material else material
    return sc.Scene.model_validate(
        {
            "filament": BODY,
            "material": {"youngs_modulus": "4 MPa", **law},
            "load": {"ramp": "50 ms"},
            "run": {"duration": "0.5 s", "frames": 26, "effects": effects},
            "numerics": {"cells": 20},
        }
    )


def difference(one: np.ndarray, other: np.ndarray) -> float:
    """Largest difference of two midpoints over the largest sag."""
    return float(np.max(np.abs(one - other)) / np.max(np.abs(one)))


@pytest.mark.parametrize("effects", ["paper", "auto"])
def test_a_custom_law_is_the_built_in_one(effects: str) -> None:
    """Both theories: closed-form or split means of the published one, fibres with shear of the other."""
    rows, errors = [], []
    for name, pair in PAIRS.items():
        runs = [sc.simulate(scene_of(dict(material), effects)) for material in pair]
        assert all(run.outcome.is_success for run in runs)
        errors.append(difference(*(run.data.midpoint.values for run in runs)))
        rows.append([name, pair[1]["flow"], f"{1e3 * runs[0].data.midpoint.values[-1]:.4f}", f"{errors[-1]:.1e}"])
    show(f"custom laws, effects = {effects}", ["law", "phi(sigma)", "midpoint/mm", "difference/sag"], rows)
    # The time error asked for is a tenth of the accuracy of 1e-3.
    assert max(errors) < 1e-4


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
