"""The C of every filament says what its interpreted graph says; its text is one, short, and the same every time."""

from __future__ import annotations

import ctypes as c
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest
import sympy as sp

import softcat_sym as sc
from softcat_sym import cache
from softcat_sym.codegen.c_model import Structure, model_for
from softcat_sym.codegen.c_printer import Target, When, helpers_of, statements
from softcat_sym.codegen.c_text import CSource, number
from softcat_sym.codegen.instructions import Code, code_of
from softcat_sym.codegen.library import about, compile_library, load
from softcat_sym.codegen.right_hand_side import JACOBIAN, POWERS, RHS, rhs_source
from softcat_sym.discretization.casadi_printer import CasadiPrinter, CellFunction
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import PrintingError
from softcat_sym.solvers.solve import assembled
from tests.common.pairs import differences, pair_of
from tests.common.rosenbrock import RUNTIME

SAME, SEEDS = 1e-12, range(3)
LONGEST = 600_000  # Whatever the grid: 508 kB of a rod with a turning clamp in space, less than 200 kB in the plane
PAPER = ("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow")
WITH_FIBRES = [*PAPER, "yielding", "gravity-ramp", "shear", "fibres", "necking-gradient"]
# Structures that differ in what the unknowns are, in the ends and in the supports.
KINDS: dict[str, tuple[str, dict[str, Any]]] = {
    "paper": ("continual-descent", {"run.effects": "paper"}),
    "string": ("stretched-rubber-band", {"run.effects": ["inertia", "extensibility", "large-rotation"]}),
    "fibres, necking": ("arrested-overdamped", {"run.effects": WITH_FIBRES, "numerics.fibres": 4}),
    "fibres of a sheet": (
        "continual-descent",
        {"filament.section": "sheet", "run.effects": WITH_FIBRES[:-1], "numerics.fibres": 3},
    ),
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
QUICK = ("paper", "fibres, necking", "viscous stress, moving support")


def scene_of(kind: str, **changes: Any) -> sc.Scene:
    name, own = KINDS[kind]
    more = {key.replace("__", "."): value for key, value in changes.items()}
    return sc.load_scene(name, {"numerics.cells": 6, **own, **more})


def check(label: str, scene: sc.Scene) -> None:
    pair = pair_of(scene)
    worst = differences(pair, SEEDS)
    # Derivatives of the force of a stiff body cancel to the last few digits.
    has_body = scene.floor.present or scene.pillars.present
    allowed = dict.fromkeys(("jacobian", "slopes"), 1e3 * SAME) if has_body else {}
    assert all(value < allowed.get(what, SAME) for what, value in worst.items()), (label, worst)
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
        # A state at random is none of a strand that is partly in its nozzle; `test_laying` compares the backends.
        if not (scene := sc.load_scene(name)).extrusion.present:
            check(name, scene)
        # A cell of a curl or of a coil may turn by a little only.
        cells = 40 if sc.load_scene(name).filament.curvature else 4
        check(f"{name}, a small grid", sc.load_scene(name, {"numerics.cells": cells}))


def test_one_text_for_every_grid_and_every_number() -> None:
    for kind in ["paper", "fibres, necking"]:
        base = pair_of(scene_of(kind)).model
        for changes in (
            {"numerics__cells": 40, "numerics__grading": 1.0},
            {"material__youngs_modulus": "5 MPa", "filament__span": "0.3 m", "load__ramp": "0.2 s"},
            {"run__duration": "3 s", "run__frames": 7, "run__accuracy": 0.01},
        ):
            assert pair_of(scene_of(kind, **changes)).model is base, changes


def structure_in(name: str, **changes: Any) -> Structure:
    scene = sc.load_scene(name, {key.replace("__", "."): value for key, value in changes.items()})
    return assembled(scene, choose_effects(scene)).structure


def test_one_library_serves_every_number_of_fibres(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SOFTCAT_CACHE", str(tmp_path))
    runs, scenes = [], [scene_of("fibres, necking", numerics__fibres=n, groups__duration=5.0) for n in (4, 6)]
    for scene in scenes:
        runs.append(sc.simulate(scene.replace({"numerics.estimate": False, "numerics.backend": "compiled"})))
    compiled = [about(one.path)[1].split()[0] for one in cache.entries(cache.LIBRARIES)]
    assert compiled.count("filament.c") == compiled.count("observables.c") == 1
    for scene, run in zip(scenes, runs, strict=True):
        interpreted = sc.simulate(scene.replace({"numerics.estimate": False, "numerics.backend": "interpreted"}))
        wanted = interpreted.fields["midpoint"]
        assert np.max(np.abs(run.fields["midpoint"] - wanted)) < 5e-3 * np.max(np.abs(wanted))
    assert not np.array_equal(runs[0].fields["midpoint"], runs[1].fields["midpoint"])


@pytest.mark.parametrize("kind", QUICK)
def test_the_texts_of_any_number_of_fibres_make_no_compiler_warn(kind: str) -> None:
    model, header = pair_of(scene_of(kind)).model, {"softcat_model.h": (RUNTIME / "softcat_model.h").read_text()}
    for text in (model.of_any_fibres, model.observables):
        compile_library({"filament.c": text, **header}, flags=STRICT)


def test_surface_tension_is_another_structure_and_its_size_is_not() -> None:
    """A library without it must never be taken for one that has it: the answer would be six times off, silently."""
    bare, pulled = structure_in("ink-bridge", surroundings__surface_tension="0 N/m"), structure_in("ink-bridge")
    assert set(pulled.effects) - set(bare.effects) == {"surface-tension"}
    assert pulled.key != bare.key and model_for(pulled).text != model_for(bare).text
    assert "surface_tension" in model_for(pulled).parameters
    assert structure_in("ink-bridge", surroundings__surface_tension="50 mN/m").key == pulled.key


# Expressions as C: every operation, order and number is CasADi's.
STRICT = ("-O2", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wno-unused-function")
A, B, C = (ca.SX.sym(name) for name in "abc")
OPERATIONS: dict[str, ca.SX] = {
    "ADD": A + B,
    "SUB": A - B,
    "MUL": A * B,
    "DIV": A / B,
    "NEG": -A,
    "INV": 1 / A,
    "TWICE": 2 * A,
    "SQ": A * A,
    "EXP": ca.exp(A),
    "LOG": ca.log(ca.fabs(A)),
    "POW": ca.power(ca.fabs(A), B),
    "CONSTPOW": ca.power(ca.fabs(A), 0.3),
    "SQRT": ca.sqrt(ca.fabs(A)),
    "ASIN": ca.asin(A / 10),
    "ACOS": ca.acos(A / 10),
    "ATAN2": ca.atan2(A, B),
    "COPYSIGN": ca.copysign(A, B),
    "LOG1P": ca.log1p(ca.fabs(A)),
    "HYPOT": ca.hypot(A, B),
    "FMIN": ca.fmin(A, B),
    "FMAX": ca.fmax(A, B),
    "LT": A < B,
    "LE": A <= B,
    "EQ": ca.eq(A, B),
    "NE": ca.ne(A, B),
    "NOT": ca.logic_not(A),
    "AND": ca.logic_and(A, B),
    "OR": ca.logic_or(A, B),
    "IF_ELSE_ZERO": ca.if_else(A < B, C, 0),
    **{
        n.upper(): getattr(ca, n)(A)
        for n in ("sin", "cos", "tan", "atan", "sinh", "cosh", "tanh", "fabs", "expm1", "sign")
    },
}


def text_of(code: Code, inputs: int, uniform: Sequence[bool] = ()) -> str:
    """A C file with `void f(int n, const double *x, double *y)`: rows of x to rows of y, as a model has them."""
    same = list(uniform) or [False] * inputs
    given = [f"x[{k}]" if same[k] else f"x[{inputs} * i + {k}]" for k in range(inputs)]
    outputs = len(code.results)
    known = [When.BEFORE if one else When.SITE for one in same]
    found = statements(code, given, known, [Target(f"y[{outputs} * i + {k}]") for k in range(outputs)])
    body = "\n    ".join([*found[When.BEFORE], "for (int i = 0; i < n; i++) {", *found[When.SITE], "}"])
    head = f"#include <math.h>\n{helpers_of(body)}\nvoid f(int n, const double *x, double *y)"
    return f"{head}\n{{\n    (void)x;\n    {body}\n}}\n"


def values(text: str, x: Floats, outputs: int) -> Floats:
    """What the C makes of rows of x, shape (rows, outputs)."""
    library = load(compile_library({"snippet.c": text}, flags=STRICT))
    given, found = np.ascontiguousarray(x, dtype=float), np.full((len(x), outputs), np.nan)
    library.f(len(x), *(array.ctypes.data_as(c.POINTER(c.c_double)) for array in (given, found)))
    return found


def both(expressions: Sequence[ca.SX], x: Floats) -> tuple[Floats, Floats]:
    """What C and what CasADi make of expressions in A, B and C."""
    function = ca.Function("f", [ca.vertcat(A, B, C)], [ca.vertcat(*expressions)])
    in_c = values(text_of(code_of([A, B, C], list(expressions)), 3), x, len(expressions))
    return in_c, np.array([np.asarray(function(row)).ravel() for row in x])


def test_every_operation_is_casadis() -> None:
    """At random points, and those at which cases differ: equal, zero, of either sign."""
    edges = [[0, 0, 1], [0, 1, 2], [1, 0, 2], [-1, 0, 2], [2, 2, 3], [-2, -2, 3], [0, -1, 1]]
    x = np.concatenate([np.random.default_rng(3).uniform(-3, 3, (40, 3)), np.array(edges, dtype=float)])
    with np.errstate(all="ignore"):
        found, wanted = both(list(OPERATIONS.values()), x)
    for k, (name, expression) in enumerate(OPERATIONS.items()):
        used = {one.operation for one in code_of([A, B, C], [expression]).instructions}
        assert name in used, f"{name} is not what CasADi makes of it: {used}"
        np.testing.assert_allclose(found[:, k], wanted[:, k], rtol=4e-15, atol=0, err_msg=name)


def test_what_a_false_condition_makes_zero_is_not_evaluated() -> None:
    """A flow with its derivatives, by itself and beside what does not flow: as of CasADi, with `pow` in a branch."""
    flow = ca.fmax(0, A - B) * (ca.fmax(0, A - B) ** 2 + 1e-9) ** ((C - 1) / 2)
    by_condition = ca.if_else(B < A, ca.log(A - B) / (A - B), 0)
    stress = ca.sqrt(1 + A**2) - C * flow
    every = [
        flow,
        by_condition,
        stress,
        *(ca.jacobian(one, x) for one in (flow, stress, flow * stress) for x in (A, B)),
    ]
    edges = [[0, 0, 1], [1, 1, 0.5], [-1, 0, 0.5], [2, 1, 1]]
    x = np.concatenate([np.random.default_rng(5).uniform(0.1, 3, (60, 3)), np.array(edges)])
    np.testing.assert_allclose(*both(every, x), rtol=1e-13, atol=1e-300)
    lines = text_of(code_of([A, B, C], every), 3).splitlines()
    asked = [line for line in lines if re.search(r"\b(pow|log)\(", line)]
    assert asked and all(line.startswith("        ") for line in asked), "\n".join(lines)
    # Two conditions, one of which only matters where the other holds.
    nested = [ca.if_else(B < A, ca.exp(C) * ca.if_else(C < B, ca.log(B - C) * ca.exp(-A), 0), 0), ca.exp(C)]
    np.testing.assert_allclose(*both(nested, x), rtol=1e-13)


def test_what_has_no_c_is_refused() -> None:
    with pytest.raises(PrintingError, match="sum over all"):
        statements(code_of([A, B], [A * B]), ["z[k]", "sum"], [When.FIBRE, When.AFTER], [Target("f[i]")])
    with pytest.raises(PrintingError, match="fibres"):
        statements(code_of([A], [ca.sin(A)]), ["z[k]"], [When.FIBRE], [Target("f[i]")])
    with pytest.raises(PrintingError, match="not a number"):
        number(float("nan"))
    with pytest.raises(PrintingError, match="ERF"):
        statements(code_of([A], [ca.erf(A)]), ["x"], [When.SITE], [Target("y")])
    with pytest.raises(PrintingError, match="no input"):
        code_of([A], [A + B])


# SymPy to twenty digits, and the printer at the same point.
def exact(expr: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    """SymPy's own value: every double is the number it is, and nothing is rounded before the twentieth digit."""
    return float(expr.xreplace({symbol: sp.Float(value, 40) for symbol, value in values.items()}).evalf(20))


def printed_sympy(expr: sp.Expr, values: Mapping[sp.Symbol, float]) -> float:
    """The printer's value in double precision."""
    at = {symbol: ca.DM(value) for symbol, value in values.items()}
    return float(CellFunction({"out": expr}, tuple(at))(at)["out"])


# Numbers arrive in CasADi as the nearest double, whatever SymPy calls them.
x = sp.Symbol("x", real=True)


def number_sympy(expr: sp.Expr) -> float:
    return float(CasadiPrinter({}).value(expr))


def test_constants_are_the_nearest_double() -> None:
    for expr, wanted in [
        (sp.Rational(1, 10), 0.1),
        (sp.Float(0.1), 0.1),
        (sp.Float("0.1", 40), 0.1),
        (sp.Rational(1, 3), 1 / 3),
        (sp.Rational(-2, 7), -2 / 7),
        (sp.Rational(10**30 + 1, 10**30), 1.0),
        (sp.Rational(1, 10**300), 1e-300),
        (sp.Integer(10) ** 300, 1e300),
        (sp.Float(0.1) + sp.Float(0.2), 0.30000000000000004),
        (sp.Float(1 / 3), 0.3333333333333333),
        (sp.Float(5e-324), 5e-324),
        (sp.Float(1.7976931348623157e308), 1.7976931348623157e308),
        (sp.pi, math.pi),
        (sp.E, math.e),
        (sp.EulerGamma, 0.5772156649015329),
    ]:
        assert number_sympy(expr) == wanted


# The printer against twenty-digit SymPy, over a table of expressions at random admissible points.
x, y, z = sp.symbols("x y z", real=True)
Q = sp.Rational

# Smooth ones: (expression, (low, high) of x, y and z).
POSITIVE = (0.2, 3.0)
ANY = (-3.0, 3.0)
UNIT = (-0.95, 0.95)

SMOOTH: dict[str, tuple[sp.Expr, tuple[float, float]]] = {
    "square": (x**2, ANY),
    "cube": (x**3, ANY),
    "large power": (x**31, ANY),
    "reciprocal": (1 / x, POSITIVE),
    "negative power": (x**-4, ANY),
    "root": (sp.sqrt(x), POSITIVE),
    "three halves": (x ** Q(3, 2), POSITIVE),
    "minus a half": (x ** Q(-1, 2), POSITIVE),
    "cube root": (x ** Q(1, 3), POSITIVE),
    "float power": (x**1.25, POSITIVE),
    "symbolic power": (x**y, POSITIVE),
    "exp": (sp.exp(x), ANY),
    "log": (sp.log(x), (1.5, 20.0)),
    "sin": (sp.sin(x), UNIT),
    "cos": (sp.cos(x), UNIT),
    "tan": (sp.tan(x), UNIT),
    "asin": (sp.asin(x), UNIT),
    "acos": (sp.acos(x), UNIT),
    "atan": (sp.atan(x), ANY),
    "atan2": (sp.atan2(x, y), ANY),
    "sinh": (sp.sinh(x), ANY),
    "cosh": (sp.cosh(x), ANY),
    "tanh": (sp.tanh(x), ANY),
    "quotient": (x / y, POSITIVE),
    "several below": (x / (y * z**2 * sp.sqrt(x)), POSITIVE),
    "pi": (sp.pi * x / 4, ANY),
    "nested": (sp.exp(sp.sin(x) / (1 + y**2)) * sp.sqrt(1 + z**2), ANY),
    "abs": (sp.Abs(x - 1), ANY),
    "sign": (sp.sign(x) * y, ANY),
    "max": (sp.Max(x, y), ANY),
    "max of three": (sp.Max(x, y, z), ANY),
    "min": (sp.Min(x, y, Q(1, 2)), ANY),
    "clamp": (sp.Min(sp.Max(x, -1), 1) * y, ANY),
    "piecewise": (sp.Piecewise((x**2, x > 1), (y, x < -1), (z, True)), ANY),
    "nested piecewise": (sp.Piecewise((sp.Piecewise((x, y > 0), (y, True)), z > 0), (z, True)), ANY),
    "piecewise of roots outside their domain": (sp.Piecewise((sp.sqrt(x), x > 0), (sp.sqrt(-x), True)), ANY),
    "piecewise of a quotient by zero": (sp.Piecewise((1 / sp.Max(x, 0), x > 0), (y, True)), ANY),
}


def test_every_expression_to_fourteen_digits() -> None:
    for name in SMOOTH:
        expr, (low, high) = SMOOTH[name]
        symbols = sorted(expr.free_symbols, key=str)
        points = np.random.default_rng(20).uniform(low, high, (8, len(symbols)))
        for point in points:
            values = dict(zip(symbols, map(float, point), strict=True))
            assert printed_sympy(expr, values) == pytest.approx(exact(expr, values), rel=2e-14, abs=0), values


# What the printer does not know it refuses, by name: nothing becomes NaN, or zero, in silence.
x, y, hidden = sp.symbols("x y hidden", real=True)


def rhs_of(scene: sc.Scene) -> tuple[Graph, CSource]:
    filament = assembled(scene, choose_effects(scene))
    return filament.graph, rhs_source(filament.graph, model_for(filament.structure))


@pytest.mark.parametrize("kind", ["surface tension", "viscous stress, moving support", "point mass, no inertia"])
def test_the_plain_right_hand_side_has_every_value_and_slope_of_the_graph(kind: str) -> None:
    (graph, source), rng = rhs_of(scene := scene_of(kind)), np.random.default_rng(5)
    library = str(compile_library(source.files, flags=STRICT))
    rhs, jacobian, powers = (ca.external(name, library) for name in (RHS, JACOBIAN, POWERS))
    states = [start + 0.01 * rng.standard_normal(len(start)) for start in (graph.start, graph.straight)]
    at = (0.3, *states, graph.vector(parameter_values(scene)))
    symbols = graph.symbolic.inputs
    of_rates = [[ca.jacobian(value, by) for by in symbols[:3]] for value in (graph.symbolic.ode, graph.symbolic.alg)]
    of_powers = [ca.jacobian(graph.symbolic.quad, by) for by in symbols[:3]]
    # By parameters none is asked for.
    none = [ca.SX(len(rows), len(graph.parameters)) for rows in (graph.start, graph.straight, graph.powers)]
    for function, of in [
        (rhs, [graph.symbolic.ode, graph.symbolic.alg]),
        (jacobian, [*of_rates[0], *of_rates[1]]),
        (rhs.jacobian(), [*of_rates[0], none[0], *of_rates[1], none[1]]),
        (powers, [graph.symbolic.quad]),
        (powers.jacobian(), [*of_powers, none[2]]),
    ]:
        given = [*at, *[0] * (function.n_in() - 4)]
        for one, other in zip(function.call(given), ca.Function("graph", symbols, of).call(at), strict=True):
            found, expected = np.asarray(ca.densify(one)), np.asarray(ca.densify(other))
            assert found.shape == expected.shape and np.all(np.isfinite(expected))
            np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12 * np.max(np.abs(expected), initial=1e-300))
