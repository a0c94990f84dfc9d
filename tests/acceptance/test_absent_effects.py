"""An absent effect leaves no symbol in the graph and fewer instructions, in the bundled scene in which it matters."""

from __future__ import annotations

import casadi as ca
import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.scene.reading import load_scene

from .effect_graphs import dispensing, graph_of, kinds, listed, lists, unknowns
from .table import show

NAMES = [effect.name for effect in REGISTRY]
SYMBOLS: dict[str, tuple[set[str], set[str]]] = {
    "inertia": (set(), {"u", "v"}),
    "bending": ({"thickness"}, {"a_1"}),
    "extensibility": (set(), {"x", "u", "a_0"}),
    "viscous-flow": ({"viscosity"}, {"axial", "shear"}),
    "viscous-stress": ({"viscosity"}, set()),
    "yielding": ({"yield_stress"}, set()),
    "gravity-ramp": ({"ramp"}, set()),
    "shear": ({"poisson"}, {"axial", "shear", "psi"}),
    "necking-gradient": ({"aspect"}, set()),
    "rotary-inertia": (set(), {"omega"}),
    "solid-damping": ({"solid_viscosity"}, set()),
    "gravity-shaking": ({"shake", "shake_frequency"}, set()),
}
"""Parameters and blocks of unknowns of each effect alone; the others change expressions, and have neither."""


def depends_on(graph: Graph) -> set[str]:
    """Parameters that the right-hand sides, powers and observables depend on."""
    arguments = [graph.t, graph.x, graph.z, graph.p]
    seen = graph.observables.call(arguments)
    everything = ca.vertcat(graph.ode, graph.alg, *graph.powers, *(ca.vec(value) for value in seen))
    used = np.asarray(ca.which_depends(everything, graph.p, 1, False), dtype=bool)
    return {name for name, is_used in zip(graph.parameters, used, strict=True) if is_used}


def pair(effect: Effect) -> tuple[Graph, Graph]:
    """Graphs with and without the effect."""
    with_it, without_it = lists(effect)
    return graph_of(effect.example, with_it), graph_of(effect.example, without_it)


def test_an_absent_effect_leaves_nothing() -> None:
    for effect in REGISTRY:
        present, absent = pair(effect)
        parameters = set(present.parameters) - set(absent.parameters)
        blocks = kinds(present) - kinds(absent)
        own_parameters, own_blocks = SYMBOLS.get(effect.name, (set(), set()))
        assert own_parameters <= parameters
        assert own_blocks <= blocks
        assert set(absent.parameters) <= set(present.parameters)
        assert unknowns(absent) <= unknowns(present)
        assert absent.instructions < present.instructions


def test_no_parameter_lies_idle() -> None:
    """Whatever a graph lists it uses, so that a parameter that is not listed has left no symbol anywhere."""
    for effect in REGISTRY:
        for graph in pair(effect):
            assert depends_on(graph) == set(graph.parameters)


def test_its_scene_can_have_it_and_do_without() -> None:
    for effect in REGISTRY:
        scene = load_scene(effect.example)
        assert effect.applies(scene)
        assert not effect.indispensable(dispensing(effect))


def row(effect: Effect) -> list[str]:
    """What leaves with the effect."""
    present, absent = pair(effect)
    return [
        *(effect.name, effect.example, listed(set(present.parameters) - set(absent.parameters))),
        *(listed(kinds(present) - kinds(absent)), f"{unknowns(present)} -> {unknowns(absent)}"),
        f"{present.instructions} -> {absent.instructions}",
    ]


def test_the_table() -> None:
    header = ("without", "scene", "parameters gone", "blocks gone", "unknowns", "instructions")
    show("Each effect left out of its scene", header, [row(effect) for effect in REGISTRY])
    assert set(SYMBOLS) <= set(NAMES)
