"""Every effect: its limit, its absence from the graph, and the bundled scene that shows it."""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from itertools import pairwise
from pathlib import Path

import casadi as ca
import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.discretization.assembly import assemble, choose_body, choose_grid, choose_theory
from softcat_sym.discretization.graph import Graph
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.physics.equation import all_equations, check
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.physics.symbols import fields, table
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from tests.acceptance import fading_filaments as fading
from tests.acceptance.fading_filaments import Pair
from tests.acceptance.rheology import STRING
from tests.acceptance.table import show


# How fast each effect fades as its coefficient goes to zero: the table of limits, by effect.
@dataclass(frozen=True)
class Limit:
    """An effect that fades."""

    effect: str
    what: str
    coefficient: str
    values: tuple[float, ...]
    exponent: float
    band: float
    pair: Callable[[float], Pair]
    prefactor: Callable[[], float] | None = None
    share: float = 0.03


@dataclass(frozen=True)
class Faded:
    """What a limit was measured to be."""

    shares: tuple[float, ...]
    exponents: tuple[float, ...]


def measure(limit: Limit) -> Faded:
    """Shares of the effect at every value, and the exponents between them."""
    shares = []
    for value in limit.values:
        with_it, without_it = limit.pair(value)
        shares.append(float(np.max(np.abs(with_it - without_it)) / np.max(np.abs(without_it))))
    exponents = np.diff(np.log(shares)) / np.diff(np.log(limit.values))
    return Faded(tuple(shares), tuple(float(exponent) for exponent in exponents))


def _constant(number: float) -> Callable[[], float]:
    return lambda: number


_GEOMETRY = {"finite-stretch": 1 / 6, "thinning": 1 / 3, "large-rotation": 2 / 5}

LIMITS: tuple[Limit, ...] = (
    Limit(
        "inertia",
        "falling viscous string, all times",
        "rho at fixed rho g",
        (1.0, 0.1, 0.01),
        1 / 5,
        0.03,
        fading.inertia_always,
    ),
    Limit(
        "inertia",
        "falling viscous string, late",
        "rho at fixed rho g",
        (0.1, 0.01, 0.001),
        13 / 60,
        0.03,
        fading.inertia_late,
    ),
    Limit("inertia", "viscous beam", "rho at fixed rho g", (1e-2, 1e-3, 1e-4), 1, 0.02, fading.inertia_of_a_beam),
    Limit(
        "bending",
        "elastic cable between clamps",
        "l/L",
        (0.016, 0.008, 0.004),
        1,
        0.06,
        partial(fading.bending_of_a_cable, {}),
        _constant(1.0),
        0.04,
    ),
    Limit(
        "bending",
        "elastic cable between pins",
        "l/L",
        (0.04, 0.02, 0.01),
        3,
        0.06,
        partial(fading.bending_of_a_cable, fading.PINNED),
        _constant(20.0),
        0.04,
    ),
    Limit(
        "bending",
        "creeping string between pins, late",
        "h/L",
        (0.04, 0.02, 0.01),
        2,
        0.1,
        fading.bending_of_a_creeping_string,
    ),
    Limit(
        "extensibility",
        "clamped elastic beam",
        "H/h",
        (0.2, 0.1, 0.05),
        2,
        0.03,
        fading.extensibility_of_a_beam,
        _constant(fading.STIFFENING),
    ),
    *(
        Limit(
            name,
            "elastic cable",
            "mean strain",
            (0.02, 0.01, 0.005),
            1,
            0.03,
            partial(fading.geometry_of_a_cable, name),
            _constant(_GEOMETRY[name]),
        )
        for name in STRING
    ),
    Limit(
        "viscous-flow",
        "Maxwell cable",
        "duration E/eta",
        (0.1, 0.05, 0.025),
        1,
        0.03,
        fading.flow_of_a_cable,
        _constant(1 / 3),
    ),
    Limit(
        "viscous-stress",
        "Kelvin-Voigt beam under a ramp",
        "eta/(E ramp)",
        (0.02, 0.01, 0.005),
        1,
        0.02,
        fading.viscous_stress_of_a_beam,
        _constant(15 / 8),
    ),
    Limit(
        "yielding",
        "creeping string",
        "sigma_Y/(rho g L)",
        (0.4, 0.2, 0.1),
        1,
        0.03,
        fading.yielding_of_a_string,
        _constant(2 * fading.CREPT),
    ),
    Limit(
        "gravity-ramp",
        "creeping beam",
        "ramp/duration",
        (0.1, 0.05, 0.025),
        1,
        0.02,
        fading.ramp_of_a_creeping_beam,
        _constant(1 / 2),
    ),
    Limit("gravity-ramp", "swinging beam", "ramp [s]", (0.04, 0.02, 0.01), 1, 0.05, fading.ramp_of_a_swinging_beam),
    Limit(
        "shear",
        "clamped elastic beam",
        "h/L",
        (0.1, 0.05, 0.025),
        2,
        0.02,
        fading.shear_of_a_beam,
        _constant(8 * 1.45 * 6 / 5),
        0.01,
    ),
    Limit("fibres", "Bingham beam between pins", "sigma_Y/(rho g L)", (0.4, 0.2, 0.1), 2, 0.1, fading.fibres_of_a_beam),
    Limit(
        "necking-gradient",
        "Maxwell string between pins",
        "h/L",
        (0.1, 0.05, 0.025),
        2,
        0.04,
        fading.gradient_of_a_string,
    ),
    Limit(
        "rotary-inertia",
        "swinging clamped beam",
        "h/L",
        (0.05, 0.025, 0.0125),
        2,
        0.04,
        fading.rotation_of_a_beam,
        fading.rayleigh_share,
        0.04,
    ),
    Limit(
        "gravity-shaking",
        "swinging clamped beam",
        "a",
        (0.4, 0.2, 0.1),
        1,
        0.01,
        fading.shaking_of_a_beam,
        fading.duhamel_share,
        0.01,
    ),
    Limit(
        "surface-tension",
        "clamped beam",
        "F L^2/(E I)",
        (0.4, 0.2, 0.1),
        1,
        0.02,
        fading.surface_of_a_beam,
        lambda: 1 / 40,
        0.01,
    ),
    Limit(
        "solid-damping",
        "swinging clamped beam",
        "G''/G'",
        (0.02, 0.01, 0.005),
        1,
        0.04,
        fading.loss_of_a_beam,
        fading.loss_share,
        0.04,
    ),
)
"""Every limit; each effect has one or more."""


# What every effect must have: a bundled scene, a limit test and a derivation.
NOTEBOOKS = Path(__file__).parents[2] / "derivations"
EQUATIONS = "softcat_sym.physics"
_SENTENCE = re.compile(r"Effects derived here:(.*?)\.(?:\s|$)(?!`)", re.DOTALL)
_ENTRY = re.compile(r"`([a-z-]+)`\s+\(([^)]*)\)")
_CELL = re.compile(r"^# %%(.*)$", re.MULTILINE)


def lacking(effect: Effect, limits: Sequence[Limit], notebooks: Path = NOTEBOOKS) -> list[str]:
    """Whatever of the three the effect lacks; empty if it has them all."""
    missing = [*_without_scene(effect), *_without_derivation(effect, notebooks)]
    if not any(limit.effect == effect.name for limit in limits):
        missing.append("limit: none in the table")
    return missing


def _without_scene(effect: Effect) -> list[str]:
    if effect.example not in bundled_names():
        return [f"scene: no bundled scene {effect.example!r}"]
    scene = load_scene(effect.example)
    if not effect.applies(scene):
        return [f"scene: {effect.example} cannot have it"]
    if reason := effect.indispensable(dispensing(effect)):
        return [f"scene: {effect.example} cannot do without it, so that nothing shows: {reason}"]
    asked = scene if not effect.saved(scene) else scene.replace({"run.effects": list(lists(effect)[0])})
    if effect.name not in choose_effects(asked).names:
        return [f"scene: {effect.example} does not take it in"]
    return []


def _without_derivation(effect: Effect, notebooks: Path) -> list[str]:
    path = notebooks / f"{effect.derivation}.py"
    if not path.is_file():
        return [f"derivation: no notebook {effect.derivation!r}"]
    prose, code = _cells(path.read_text("utf-8"))
    objects = derived_in(prose).get(effect.name)
    if not objects:
        return [f"derivation: {effect.derivation} does not say that it derives it"]
    missing = [name for name in objects if not _is_held(name)]
    missing += [name for name in objects if not re.search(rf"\b{name.rpartition('.')[2]}\b", code)]
    return [f"derivation: {effect.derivation} compares nothing with {name}" for name in missing]


def derived_in(prose: str) -> dict[str, tuple[str, ...]]:
    """Effects that a notebook says it derives, with the objects that they are compared with."""
    sentence = _SENTENCE.search(prose)
    entries = _ENTRY.findall(sentence.group(1)) if sentence else []
    return {name: tuple(re.findall(r"`([\w.]+)`", objects)) for name, objects in entries}


def _cells(text: str) -> tuple[str, str]:
    """Text of the markdown cells, and of the code cells without their imports."""
    prose, code = [], []
    parts = _CELL.split(text)[1:]
    for kind, cell in zip(parts[::2], parts[1::2], strict=True):
        if "[markdown]" in kind:
            prose.append(re.sub(r"^# ?", "", cell, flags=re.MULTILINE))
        else:
            code.append(re.sub(r"^from \S+ import (\([^)]*\)|.*)$", "", cell, flags=re.MULTILINE))
    return "\n".join(prose), "\n".join(code)


def _is_held(name: str) -> bool:
    """Whether the equations have an object of this name."""
    module, _, attribute = name.rpartition(".")
    try:
        return hasattr(importlib.import_module(f"{EQUATIONS}.{module}" if module else EQUATIONS), attribute)
    except ModuleNotFoundError:
        return False


# Graphs of bundled scenes with and without one effect, like with like.
CELLS = 6
BESIDE = {"shear": ("fibres",)}
"""Effects that hide another one: a resolved section keeps its shear, made stiff."""
STEADY = {"load.shake": 0.0, "load.shake_frequency": "0 Hz"}
"""What a scene must no longer ask for where an effect is left out that it could not do without."""


def dependents(name: str) -> set[str]:
    """Effects that make no sense without this one."""
    found = {name}
    while more := {effect.name for effect in REGISTRY if found & set(effect.needs)} - found:
        found |= more
    return found - {name}


def lists(effect: Effect) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """What ``auto`` holds in the effect's scene, with the effect and what it needs, and the same without it.

    Neither has what needs the effect: that would leave with it, and be mistaken for it.
    """
    chosen = set(choose_effects(load_scene(effect.example)).names) | {effect.name}
    for other in reversed(REGISTRY):
        chosen |= set(other.needs) if other.name in chosen else set()
    chosen -= dependents(effect.name) | set(BESIDE.get(effect.name, ()))
    listed = tuple(other.name for other in REGISTRY if other.name in chosen)
    return listed, tuple(name for name in listed if name != effect.name)


def with_effects(scene: Scene, names: Iterable[str]) -> Scene:
    """The scene with these effects and no other; under steady gravity where its shaking is not among them."""
    named = list(names)
    return scene.replace({"run.effects": named, **({} if "gravity-shaking" in named else STEADY)})


def dispensing(effect: Effect) -> Scene:
    """The effect's scene, as it may do without the effect."""
    scene = load_scene(effect.example)
    return scene.replace(STEADY) if effect.name == "gravity-shaking" else scene


@cache
def graph_of(scene_name: str, names: tuple[str, ...]) -> Graph:
    """The scene's graph on few cells, with these effects and no other."""
    asked = with_effects(load_scene(scene_name), names).replace({"numerics.cells": CELLS, "numerics.grading": 1.0})
    effects = choose_effects(asked)
    if effects.names != names:
        raise ValueError(f"asked for {names}, got {effects.names}")
    equations = derive(effects.terms(), SECTIONS[asked.filament.section], asked.run.closure)
    grid = choose_grid(asked)
    return assemble(equations, grid, names, choose_theory(asked, equations), choose_body(asked, grid))


def unknowns(graph: Graph) -> int:
    """Number of differential and algebraic states."""
    return len(graph.state_names) + len(graph.algebraic_names)


def kinds(graph: Graph) -> set[str]:
    """Blocks of unknowns; plastic states through the thickness without their number."""
    return {without_number(kind) for kind in (*graph.x_kinds, *graph.z_kinds)}


def without_number(kind: str) -> str:
    """``axial_3`` is ``axial``, ``a_1`` itself."""
    head, _, tail = kind.rpartition("_")
    return head if tail.isdigit() and head in ("axial", "shear") else kind


def listed(names: Iterable[str]) -> str:
    """For a table."""
    return ", ".join(sorted(names)) or "-"


# An effect whose coefficient goes to zero converges to its absence, at the rate that theory gives.
@pytest.mark.slow
@pytest.mark.parametrize("limit", LIMITS, ids=lambda limit: f"{limit.effect}: {limit.what}")
def test_a_fading_effect_is_its_absence(limit: Limit) -> None:
    found = measure(limit)
    prefactor = limit.prefactor() if limit.prefactor is not None else None
    rows = []
    for value, share, exponent in zip(limit.values, found.shares, (None, *found.exponents), strict=True):
        per = share / value**limit.exponent
        rows.append([f"{value:g}", f"{share:.3e}", "" if exponent is None else f"{exponent:.3f}", f"{per:.4g}"])
    theory = f"exponent {limit.exponent:.4g}" + ("" if prefactor is None else f", prefactor {prefactor:.4g}")
    title = f"{limit.effect}, {limit.what}; theory: {theory}"
    show(title, (limit.coefficient, "share of the sag", "exponent", "prefactor"), rows)
    assert all(value > after for value, after in pairwise(limit.values)), "the coefficient must fall"
    assert found.exponents[-1] == pytest.approx(limit.exponent, abs=limit.band)
    if prefactor is not None:
        assert found.shares[-1] / limit.values[-1] ** limit.exponent == pytest.approx(prefactor, rel=limit.share)


@pytest.mark.slow
def test_a_linear_profile_of_fibres_is_the_run_without_them() -> None:
    """The two are discretised differently, so they agree as the square of the cells, down to a thousandth of shear."""
    threshold, rows, differences = 0.4, [], []
    for cells in (10, 20, 40):
        linear = fading.bingham_beam(threshold, (*fading.BENDING_FLOW, "fibres"), cells, {"order": 1})
        without = fading.bingham_beam(threshold, fading.BENDING_FLOW, cells, {})
        differences.append(float(np.max(np.abs(linear - without)) / np.max(without)))
        rows.append([cells, f"{without[-1]:.6f}", f"{linear[-1]:.6f}", f"{differences[-1]:.1e}"])
    show("linear profile", ("cells", "sag without fibres", "sag of linear fibres", "difference"), rows)
    assert differences[0] / differences[1] == pytest.approx(4, rel=0.2)
    assert differences[2] < 1e-3


# Every registered effect has a bundled scene in which it matters, a limit test and a derivation.
NAMES = [effect.name for effect in REGISTRY]
WHOLE = REGISTRY[0]
COARSE = {"numerics.cells": 10, "numerics.fibres": 6}


def test_every_effect_has_its_scene_its_limit_and_its_derivation() -> None:
    for effect in REGISTRY:
        assert not lacking(effect, LIMITS)


def test_no_limit_is_of_an_unknown_effect() -> None:
    assert {limit.effect for limit in LIMITS} == set(NAMES)


def test_one_that_lacks_any_is_caught() -> None:
    for changes, message in [
        ({"example": "no-such-scene"}, "scene: no bundled scene"),
        ({"applies": lambda scene: False}, "scene: maxwell-slow cannot have it"),
        ({"indispensable": lambda scene: "it rests on it"}, "scene: maxwell-slow cannot do without it"),
        ({"name": "magnetism"}, "scene: maxwell-slow does not take it in"),
        ({"name": "magnetism"}, "derivation: 01_balance does not say"),
        ({"name": "magnetism"}, "limit: none"),
        ({"derivation": "99_magnetism"}, "derivation: no notebook"),
        ({"derivation": "03_small_deflection"}, "derivation: 03_small_deflection does not say"),
    ]:
        made_up = replace(WHOLE, **changes)  # type: ignore[arg-type]
        assert any(message in fault for fault in lacking(made_up, LIMITS))


def test_a_limit_taken_out_of_the_table_is_missed() -> None:
    assert not lacking(WHOLE, LIMITS)
    assert lacking(WHOLE, [limit for limit in LIMITS if limit.effect != WHOLE.name]) == ["limit: none in the table"]


@pytest.mark.parametrize(
    ("objects", "code"), [("`kinematics.NOTHING`", "kinematics.NOTHING"), ("`kinematics.MOTION`", "kinematics.other")]
)
def test_a_notebook_that_only_says_so_is_caught(tmp_path: Path, objects: str, code: str) -> None:
    notebook = f"# %% [markdown]\n# Effects derived here: `inertia` ({objects}).\n\n# %%\n{code}\n"
    (tmp_path / "01_balance.py").write_text(notebook, "utf-8")
    assert any("compares nothing" in fault for fault in lacking(WHOLE, LIMITS, tmp_path))


def test_what_a_notebook_says_may_run_over_lines() -> None:
    said = "Some. Effects derived here: `a-b` (`motion.X`,\n`laws.y.Z`), `c` (`balance.q`).\n\nMore (`d`)."
    assert derived_in(said) == {"a-b": ("motion.X", "laws.y.Z"), "c": ("balance.q",)}


@pytest.mark.slow
@pytest.mark.parametrize("effect", REGISTRY, ids=NAMES)
def test_it_matters_in_its_scene(effect: Effect) -> None:
    """Leaving it out changes the midpoint by more than the accuracy asked, or the run cannot be finished."""
    scene = sc.load_scene(effect.example, COARSE if "fibres" in lists(effect)[1] else {"numerics.cells": 10})
    runs = [sc.simulate(with_effects(scene, names)) for names in lists(effect)]
    assert runs[0].outcome is sc.Outcome.solved
    change = float("inf")
    if runs[1].outcome is sc.Outcome.solved:
        present, absent = (run.data["midpoint"].values for run in runs)
        change = float(np.max(np.abs(present - absent)) / np.max(np.abs(present)))
    header = ("scene", "change without it", "accuracy", "outcome without it")
    accuracy = scene.run.accuracy
    show(effect.name, header, [[effect.example, f"{change:.2e}", f"{accuracy:g}", runs[1].outcome.name]])
    assert change > accuracy


# An absent effect leaves no symbol in the graph and fewer instructions, in the bundled scene in which it matters.
NAMES_ABSENT_EFFECTS = [effect.name for effect in REGISTRY]
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
    assert set(SYMBOLS) <= set(NAMES_ABSENT_EFFECTS)


# One table of symbols with LaTeX, dimensions and equation numbers; a machine checks every term of every equation.
def test_every_term_of_every_equation_has_its_dimension() -> None:
    rows = []
    for module, equations in all_equations().items():
        for equation in equations:
            check(equation)
        sources = {equation.source.split(",")[0] for equation in equations}
        rows.append([module, len(equations), ", ".join(sorted(sources)[:6])])
    rows.append(["all", sum(int(row[1]) for row in rows), f"{len(table())} symbols, {len(fields())} fields"])
    show("equations whose every term passes the dimension check", ("module", "equations", "from"), rows)
    assert int(rows[-1][1]) > 150
    assert all(row.latex and row.source for row in (*table(), *fields()))
