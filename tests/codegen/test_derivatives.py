"""The chain rule from loop to loop gives the Jacobian of the whole, for any number of sites."""

from __future__ import annotations

import casadi as ca
import numpy as np

from softcat_sym.codegen.loops import Chain, loops_of
from softcat_sym.codegen.model import template_of
from softcat_sym.codegen.recording import STAGED, UNKNOWN, Leaf

from .c_values import CModel
from .tiny import NODES, ON_CELLS, Tiny, item, recording, written_out


def test_rates_and_derivatives_are_those_of_the_filament_written_out() -> None:
    for sites in [7, 8, 13, 40]:
        rng, p, t = np.random.default_rng(sites), 0.7, 0.4
        state = rng.uniform(0.2, 1, (sites, 2))
        cell = rng.uniform(0.5, 1.5, sites)
        y, b = ca.SX.sym("y", sites), ca.SX.sym("b", sites - 1)
        f_y, f_b, powers = written_out(ca.vertsplit(y), ca.vertsplit(b), cell.tolist(), p, t)
        rates, unknowns = ca.vertcat(*f_y, *f_b), ca.vertcat(y, b)
        outputs = [rates, ca.jacobian(rates, unknowns), ca.vertcat(*powers), ca.jacobian(ca.vertcat(*powers), unknowns)]
        wanted = [
            np.asarray(one) for one in ca.Function("f", [unknowns], outputs)(np.append(state[:, 0], state[:-1, 1]))
        ]

        found = CModel(template_of(recording()).with_fibres().text).at(
            t, state, np.array([p]), np.stack([cell, 1 / cell], axis=1)
        )
        order = np.append(2 * np.arange(sites), 2 * np.arange(sites - 1) + 1)
        np.testing.assert_allclose(found.rates[order], wanted[0].ravel(), rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(found.jacobian[np.ix_(order, order)], wanted[1], rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(found.powers, wanted[2].ravel(), rtol=1e-12)
        np.testing.assert_allclose(found.slopes[:, order], wanted[3], rtol=1e-12, atol=1e-12)


def test_the_tables_say_what_the_entries_are() -> None:
    model = template_of(recording()).with_fibres()
    table = CModel(model.text).table
    assert (table.slots, table.parameters, table.places, table.powers, table.moves_in_time) == (2, 1, 2, 3, 1)
    assert [table.held_first[k] for k in range(2)] == [0, 0]
    assert [table.held_last[k] for k in range(2)] == [0, 1]
    names = [slot.name for slot in model.slots]
    entries = [(names[table.row[k]], names[table.column[k]], table.offset[k]) for k in range(table.entries)]
    assert tuple(entries) == model.entries
    assert {(column, distance) for row, column, distance in entries if row == "b"} == {
        *(("y", distance) for distance in (-1, 0, 1)),
        *(("b", distance) for distance in (-1, 0)),
    }


def test_fields_that_nothing_reads_are_left_out() -> None:
    assert "log(" not in template_of(recording()).with_fibres().text


def test_derivatives_that_are_the_same_number_everywhere_are_not_stored() -> None:
    s = Tiny()
    fields = [
        item("gap", ON_CELLS, lambda i: s.y(i + 1) - s.y(i)),
        item("square", ON_CELLS, lambda i: s.y(i) ** 2),
    ]
    chain = Chain(s.leaves)
    for loop in loops_of(s.leaves, fields):
        chain.learn([loop], [chain.of(loop)])
    assert chain.constants == {("gap", ("y", 0)): -1.0, ("gap", ("y", 1)): 1.0}
    assert chain.stored("gap") == []
    assert chain.stored("square") == [("y", 0)]


def test_a_number_that_an_end_has_otherwise_is_stored() -> None:
    s = Tiny()
    twice = [item("gap", NODES, lambda i: (2 if i == 0 else 1) * s.y(i))]
    chain, loops = Chain(s.leaves), loops_of(s.leaves, twice)
    chain.learn(loops, [chain.of(loop) for loop in loops])
    assert chain.stored("gap") == [("y", 0)]


def test_distances_add_up_along_the_chain() -> None:
    s = Tiny()
    fields = [
        item("square", NODES, lambda i: s.y(i) ** 2),
        item("next", range(1, 12), lambda i: s(STAGED, "square", i + 1) * s(UNKNOWN, "y", i - 1)),
    ]
    chain = Chain(s.leaves)
    for loop in loops_of(s.leaves, fields):
        found = chain.of(loop)
        chain.learn([loop], [found])
    assert set(found["next"]) == {("y", 1), ("y", -1)}
    (leaf,) = s.leaves.within(found["next"]["y", 1])[:1]
    assert leaf == Leaf("derivative", "square/y+0", 1)
