"""Expressions as C, fields as loops over sites, and derivatives from loop to loop."""

from __future__ import annotations

import ctypes as c
from collections.abc import Callable, Sequence

import casadi as ca
import numpy as np
import pytest

from softcat_sym.codegen.c_printer import Target, When, helpers_of, number, statements
from softcat_sym.codegen.library import compile_library, load
from softcat_sym.codegen.loops import Chain, Where, loops_of, needed
from softcat_sym.codegen.model import template_of
from softcat_sym.codegen.recording import (
    CELLS,
    PARAMETER,
    PER,
    PLACE,
    STAGED,
    TIME,
    UNKNOWN,
    Code,
    Instruction,
    Item,
    Leaf,
    Leaves,
    Recording,
    Slot,
    code_of,
    with_reciprocals,
)
from softcat_sym.discretization.grid import Floats
from softcat_sym.errors import PrintingError
from tests.common.c_values import CModel

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

Y, Z, P, H = (ca.SX.sym(name) for name in "yzph")
LEAVES = [Leaf(UNKNOWN, "y"), Leaf(UNKNOWN, "z", 1), Leaf(PARAMETER, "p"), Leaf(PLACE, "cell")]

NODES, ON_CELLS, INNER = range(CELLS + 1), range(CELLS), range(1, CELLS)


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
        np.testing.assert_allclose(found[:, k], wanted[:, k], rtol=4e-16, atol=0, err_msg=name)


def test_the_order_of_operations_is_kept_in_deep_expressions_too() -> None:
    nested = [A - (B - C), (A - B) - C, A / (B / C), A / B / C, -(A + B) * C, A - (-B), (A + B) * (A - C), -(-A - 1.5)]
    x = np.random.default_rng(4).uniform(0.5, 2, (20, 3))
    np.testing.assert_allclose(*both(nested, x), rtol=1e-15, atol=1e-15)
    deep = A
    for k in range(60):
        deep = ca.sin(deep * B + k) - C
    assert max(map(len, text_of(code_of([A, B, C], [deep]), 3).splitlines())) < 200
    np.testing.assert_allclose(*both([deep], x), rtol=1e-13)


def test_equal_expressions_are_computed_once_and_as_early_as_can_be() -> None:
    code = code_of([A, B], [ca.exp(A * B) + 1, ca.exp(A * B) * 2, ca.SX(0), A])
    names = [one.operation for one in code.instructions]
    assert names.count("EXP") == names.count("MUL") == 1
    assert code.instructions[code.results[2]] == Instruction("CONST", (), 0.0)
    code = code_of([A, B], [ca.exp(B) * A, ca.exp(B) + B])
    found = statements(code, ["y[i]", "p[0]"], [When.SITE, When.BEFORE], [Target("f[i]"), Target("g[i]")])
    assert sum("exp" in line for line in found[When.BEFORE]) == 1
    assert not any("exp" in line for line in found[When.SITE])
    rows, e = values(text_of(code, 2, [False, True]), np.array([[1.0, 0.5], [2.0, 99.0]]), 2), np.exp(0.5)
    np.testing.assert_allclose(rows, [[e, e + 0.5], [2 * e, e + 0.5]])
    found = statements(
        code_of([A, B], [ca.exp(B) * A]),
        ["z[k]", "y[i]"],
        [When.FIBRE, When.SITE],
        [Target("sum", each=True, adds=True)],
    )
    assert "exp" in found[When.SITE][0] and found[When.FIBRE] == ["sum += v1 * z[k];"]


def test_numbers_are_read_as_the_same() -> None:
    for value in [0.1, -0.1, 1e-300, 1 / 3, 5e-324, 1.7976931348623157e308, 12345678901234567.0]:
        assert float(number(value).strip("()")) == value
    code = Code(tuple(Instruction("CONST", (), value) for value in (-0.1, 5e-324)), (0, 1))
    assert values(text_of(code, 1), np.zeros((1, 1)), 2).tolist() == [[-0.1, 5e-324]]
    assert (number(float("inf")), number(float("-inf"))) == ("HUGE_VAL", "(-HUGE_VAL)")


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


def divisions(code: Code) -> int:
    return sum(one.operation in ("DIV", "INV") for one in code.instructions)


def inverted(expressions: list[ca.SX]) -> tuple[Code, Code, list[Leaf]]:
    plain = code_of([Y, Z, P, H], expressions)
    return plain, *with_reciprocals(plain, LEAVES)


def test_divisions_that_are_shared_become_products_without_another_value() -> None:
    mixed = [
        Y / Z + P / Z,
        1 / Z,
        (Y + Z) / P,
        Y / 7,
        (Y - Z) / H,
        1 / H,
        Y / (Z + P),
        Z / (P * P),
        P / (P + 1),
        ca.SX(0),
        Y,
    ]
    plain, code, leaves = inverted(mixed)
    x = np.random.default_rng(1).uniform(0.4, 3, (200, 4)) * np.array([1, -1, 1, 1])
    x[:, 2] = x[0, 2]
    assert leaves == [*LEAVES, Leaf(PLACE, PER + "cell")]
    more = np.concatenate([x, 1 / x[:, 3:]], axis=1)
    wanted, found = (values(text_of(c, r.shape[1]), r, len(mixed)) for c, r in ((plain, x), (code, more)))
    # Three roundings in place of one, against the larger of what is added.
    np.testing.assert_allclose(found, wanted, rtol=1e-15, atol=1e-15)
    assert divisions(code) <= divisions(plain) / 2
    for expressions, left in [
        ([Y / Z], 1),  # a single quotient is no dearer than an inverse and a product
        ([Y / Z, P / Z, H / Z], 1),  # one inverse for three quotients
        ([Y / P], 1),  # one inverse for all sites
        ([P / (P + 1)], 1),  # computed once for all sites anyway
        ([Y / 3], 0),  # the inverse of a number is a number
        ([Y / H, 1 / H], 0),  # the inverse of a length is given
    ]:
        assert divisions(inverted(expressions)[1]) == left
    _, code, leaves = inverted([Y / P, Z / P])
    text = text_of(code, 4, [not leaf.is_local for leaf in leaves])
    head, loop = text[text.index("void f") :].split("for (int i")
    assert "1.0 /" in head and "/" not in loop
    plain, code, _ = inverted([Y / Z, H / Z])
    by_zero = np.array([[1.0, 0, 1, 0], [-1.0, 0, 1, 2], [0.0, 0, 1, 2]])
    assert divisions(code) < divisions(plain)
    np.testing.assert_array_equal(*(values(text_of(one, 4), by_zero, 2) for one in (code, plain)))


def item(name: str, sites: range, value: Callable[[int], ca.SX]) -> Item:
    """A field from what it is at a site."""
    return Item(name, sites, tuple(value(site) for site in sites))


class Tiny:
    """Symbols of a filament by name and site."""

    def __init__(self) -> None:
        self.leaves = Leaves()

    def __call__(self, kind: str, name: str, site: int = 0) -> ca.SX:
        return self.leaves.symbol(Leaf(kind, name, site))

    def y(self, site: int) -> ca.SX:
        return self(UNKNOWN, "y", site)

    def field(self, name: str, site: int) -> ca.SX:
        return self(STAGED, name, site)


def recording() -> Recording:
    """The filament of `written_out`, taken apart: two unknowns a site."""
    s = Tiny()
    p, t = s(PARAMETER, "p"), s(TIME, "t")

    def b(i: int) -> ca.SX:
        return s(UNKNOWN, "b", i)

    def turn(i: int) -> ca.SX:
        if i == 0:
            return s.field("slope", 0) ** 2
        if i == CELLS:
            return p * ca.sin(s.field("slope", CELLS - 1))
        return s.field("slope", i) * s.field("slope", i - 1)

    def rate(i: int) -> ca.SX:
        if i == 0:
            return 2 * s.field("force", 0)
        return -s.field("force", i - 1) + (s.field("force", i) + t if i < CELLS else -s.y(i))

    def force(i: int) -> ca.SX:
        return ca.exp(s.field("slope", i)) * b(i) + s.field("turn", i) - s.field("turn", i + 1)

    staged = (
        item("gap", ON_CELLS, lambda i: s.y(i + 1) - s.y(i)),
        item("slope", ON_CELLS, lambda i: s.field("gap", i) / s(PLACE, "cell", i) + p * b(i)),
        item("turn", NODES, turn),
        item("force", ON_CELLS, force),
        item("unused", NODES, lambda i: ca.log(s.y(i))),
        item("heat", ON_CELLS, lambda i: b(i) * s.field("force", i)),
    )
    rates = (item("f_y", NODES, rate), item("f_b", ON_CELLS, lambda i: s.field("turn", i) * s.field("gap", i) - b(i)))
    powers = (
        (item("power_plastic_0", ON_CELLS, lambda i: s.field("heat", i) ** 2),),
        (
            item("power_load_0", NODES, lambda i: s.field("turn", i) * s.y(i)),
            item("power_load_1", ON_CELLS, lambda i: t * s.field("gap", i)),
        ),
        (item("power_gradient_0", ON_CELLS, lambda i: p * s.field("heat", i)),),
    )
    slots = Slot("y", True, "", False, NODES), Slot("b", True, "", False, ON_CELLS)
    return Recording(s.leaves, slots, staged, rates, powers, ("p",), ("cell", "per_cell"))


def written_out(
    y: Sequence[ca.SX], b: Sequence[ca.SX], cell: Sequence[float], p: float, t: float
) -> tuple[list[ca.SX], ...]:
    """Rates of y, rates of b and powers of a filament of any number of sites; b has one less."""
    cells = len(b)
    gap = [y[i + 1] - y[i] for i in range(cells)]
    slope = [gap[i] / cell[i] + p * b[i] for i in range(cells)]
    turn = [slope[0] ** 2, *(slope[i] * slope[i - 1] for i in range(1, cells)), p * ca.sin(slope[-1])]
    force = [ca.exp(slope[i]) * b[i] + turn[i] - turn[i + 1] for i in range(cells)]
    f_y = [2 * force[0], *(force[i] - force[i - 1] + t for i in range(1, cells)), -force[-1] - y[-1]]
    f_b = [turn[i] * gap[i] - b[i] for i in range(cells)]
    heat = [b[i] * force[i] for i in range(cells)]
    load = sum(turn[i] * y[i] for i in range(cells + 1)) + sum(t * one for one in gap)
    return f_y, f_b, [sum(one**2 for one in heat), load, sum(p * one for one in heat)]


def test_rates_and_derivatives_are_those_of_the_filament_written_out() -> None:
    model = template_of(recording()).with_fibres()
    assert "log(" not in model.text, "fields that nothing reads are left out"
    compiled = CModel(model.text)
    for sites in [7, 8, 13, 40]:
        rng, p, t = np.random.default_rng(sites), 0.7, 0.4
        state, cell = rng.uniform(0.2, 1, (sites, 2)), rng.uniform(0.5, 1.5, sites)
        y, b = ca.SX.sym("y", sites), ca.SX.sym("b", sites - 1)
        f_y, f_b, powers = (ca.vertcat(*part) for part in written_out(ca.vertsplit(y), ca.vertsplit(b), cell, p, t))
        rates, unknowns = ca.vertcat(f_y, f_b), ca.vertcat(y, b)
        outputs = [rates, ca.jacobian(rates, unknowns), powers, ca.jacobian(powers, unknowns)]
        at = np.append(state[:, 0], state[:-1, 1])
        wanted = [np.asarray(one) for one in ca.Function("f", [unknowns], outputs)(at)]
        found = compiled.at(t, state, np.array([p]), np.stack([cell, 1 / cell], axis=1))
        order = np.append(2 * np.arange(sites), 2 * np.arange(sites - 1) + 1)
        np.testing.assert_allclose(found.rates[order], wanted[0].ravel(), rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(found.jacobian[np.ix_(order, order)], wanted[1], rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(found.powers, wanted[2].ravel(), rtol=1e-12)
        np.testing.assert_allclose(found.slopes[:, order], wanted[3], rtol=1e-12, atol=1e-12)
    table = compiled.table
    assert (table.slots, table.parameters, table.places, table.powers, table.moves_in_time) == (2, 1, 2, 3, 1)
    assert [table.held_first[k] for k in range(2)] == [0, 0] and [table.held_last[k] for k in range(2)] == [0, 1]
    names = [slot.name for slot in model.slots]
    entries = [(names[table.row[k]], names[table.column[k]], table.offset[k]) for k in range(table.entries)]
    assert tuple(entries) == model.entries
    of_b = {(column, distance) for row, column, distance in entries if row == "b"}
    assert of_b == {("y", -1), ("y", 0), ("y", 1), ("b", -1), ("b", 0)}


def learned(leaves: Leaves, fields: Sequence[Item]) -> tuple[Chain, dict]:
    chain, last = Chain(leaves), {}
    for loop in loops_of(leaves, fields):
        last = chain.of(loop)
        chain.learn([loop], [last])
    return chain, last


def test_derivatives_that_are_one_number_are_not_stored_and_distances_add_up() -> None:
    s = Tiny()
    gap = item("gap", ON_CELLS, lambda i: s.y(i + 1) - s.y(i))
    chain, _ = learned(s.leaves, [gap, item("square", ON_CELLS, lambda i: s.y(i) ** 2)])
    assert chain.constants == {("gap", ("y", 0)): -1.0, ("gap", ("y", 1)): 1.0}
    assert (chain.stored("gap"), chain.stored("square")) == ([], [("y", 0)])
    s = Tiny()
    loops = loops_of(s.leaves, [item("gap", NODES, lambda i: (2 if i == 0 else 1) * s.y(i))])
    chain = Chain(s.leaves)
    chain.learn(loops, [chain.of(loop) for loop in loops])
    assert chain.stored("gap") == [("y", 0)], "an end has another number"
    s = Tiny()
    square = item("square", NODES, lambda i: s.y(i) ** 2)
    further = item("next", INNER, lambda i: s(STAGED, "square", i + 1) * s(UNKNOWN, "y", i - 1))
    _, found = learned(s.leaves, [square, further])
    assert set(found["next"]) == {("y", 1), ("y", -1)}
    assert s.leaves.within(found["next"]["y", 1])[0] == Leaf("derivative", "square/y+0", 1)


def test_a_middle_that_is_not_uniform_is_refused() -> None:
    for odd in (lambda i: i == 4, lambda i: i == 6, lambda i: i == 8, lambda i: i < 5):
        s = Tiny()
        with pytest.raises(PrintingError, match="lumpy is not computed alike"):
            loops_of(s.leaves, [item("lumpy", NODES, lambda i, s=s, odd=odd: s.y(i) * (2 if odd(i) else 1))])
    # Sites are compared by what they compute, not by how it is written.
    s = Tiny()
    (loop,) = loops_of(s.leaves, [item("a", ON_CELLS, lambda i: s.y(i) + s.y(i + 1) if i % 2 else s.y(i + 1) + s.y(i))])
    assert loop.where == Where(0, 1)


def test_loops_run_over_the_sites_of_a_field_with_the_ends_apart() -> None:
    for sites, where in [(NODES, Where(0, 0)), (ON_CELLS, Where(0, 1)), (INNER, Where(1, 1))]:
        s = Tiny()
        (loop,) = loops_of(s.leaves, [item("a", sites, lambda i, s=s: 2 * s.y(i))])
        assert (loop.where, loop.names) == (where, ("a",))
        assert [leaf.site for leaf in s.leaves.within(loop.values[0])] == [0]
    s = Tiny()
    loops = loops_of(s.leaves, [item("a", NODES, lambda i: {0: 3, CELLS: 5}.get(i, 1) * s.y(i))])
    assert [loop.where for loop in loops] == [Where(1, 1), Where(-1, 0, alone=True), Where(0, 0, alone=True)]
    assert ["5" in str(loop.values[0]) for loop in loops] == [False, True, False]
    s = Tiny()
    loops = loops_of(s.leaves, [item("a", NODES, lambda i: s.y(i + 1 if i < CELLS else i - 1))])
    distances = {loop.where: [leaf.site for leaf in s.leaves.within(loop.values[0])] for loop in loops}
    assert distances == {Where(0, 1): [1], Where(-1, 0, alone=True): [-1]}


def test_fields_share_a_loop_unless_a_neighbour_reads_them() -> None:
    s = Tiny()
    fields = [
        item("a", NODES, lambda i: 2 * s.y(i)),
        item("b", NODES, lambda i: s.field("a", i) + 1),
        item("c", NODES, lambda i: s.field("b", i) * s.field("a", i)),
    ]
    (loop,) = loops_of(s.leaves, fields)
    assert loop.names == ("a", "b", "c")
    # What the loop computes itself is not read back.
    assert {leaf.kind for value in loop.values for leaf in s.leaves.within(value)} == {"unknown"}
    s = Tiny()
    fields = [
        item("a", NODES, lambda i: 2 * s.y(i)),
        item("b", ON_CELLS, lambda i: s.field("a", i) + s.field("a", i + 1)),
        item("c", NODES, lambda i: 3 * s.y(i)),
        item("d", ON_CELLS, lambda i: s.field("c", i) * s.y(i)),
    ]
    names = [loop.names for loop in loops_of(s.leaves, fields)]
    assert names[0] == ("a", "c") and sorted(sum(names, ())) == ["a", "b", "c", "d"]


def test_every_loop_finds_what_it_reads() -> None:
    """At every one of its sites, ends included; and only what is needed is computed."""
    whole = recording()
    staged = needed(whole.leaves, whole.staged, whole.rates)
    assert [one.name for one in staged] == ["gap", "slope", "turn", "force"]
    assert "heat" in [one.name for one in needed(whole.leaves, whole.staged, [i for p in whole.powers for i in p])]
    known: dict[str, set[int]] = {}
    sites = range(30)
    for loop in loops_of(whole.leaves, [*staged, *whole.rates]):
        first = loop.where.first
        run = [sites[first]] if loop.where.alone else sites[first : len(sites) - loop.where.behind]
        for leaf in (leaf for value in loop.values for leaf in whole.leaves.within(value) if leaf.kind == "staged"):
            assert {i + leaf.site for i in run} <= known[leaf.name], (loop.names, leaf)
        for name in loop.names:
            known.setdefault(name, set()).update(run)
    assert (known["f_y"], known["f_b"]) == (set(sites), set(sites[:-1]))
