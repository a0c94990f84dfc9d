"""Fields become loops: as few as can be, in an order in which all is known, with the ends apart."""

from __future__ import annotations

import pytest

from softcat_sym.codegen.loops import Where, loops_of, needed
from softcat_sym.codegen.recording import CELLS
from softcat_sym.errors import PrintingError

from .tiny import NODES, ON_CELLS, Tiny, item, recording

INNER = range(1, CELLS)


@pytest.mark.parametrize("odd", [4, 6, 8])
def test_a_middle_that_is_not_uniform_is_refused(odd: int) -> None:
    s = Tiny()
    with pytest.raises(PrintingError, match="lumpy is not computed alike"):
        loops_of(s.leaves, [item("lumpy", NODES, lambda i: s.y(i) * (2 if i == odd else 1))])


def test_sites_that_see_otherwise_too_far_from_an_end_are_refused() -> None:
    s = Tiny()
    with pytest.raises(PrintingError):
        loops_of(s.leaves, [item("half", NODES, lambda i: s.y(i) * (2 if i < 5 else 1))])


def test_a_position_in_the_text_is_no_difference() -> None:
    """Sites are compared by what they compute, not by how it is written."""
    s = Tiny()
    (loop,) = loops_of(s.leaves, [item("a", ON_CELLS, lambda i: s.y(i) + s.y(i + 1) if i % 2 else s.y(i + 1) + s.y(i))])
    assert loop.where == Where(0, 1)


@pytest.mark.parametrize(("sites", "where"), [(NODES, Where(0, 0)), (ON_CELLS, Where(0, 1)), (INNER, Where(1, 1))])
def test_loops_run_over_the_sites_of_a_field(sites: range, where: Where) -> None:
    s = Tiny()
    (loop,) = loops_of(s.leaves, [item("a", sites, lambda i: 2 * s.y(i))])
    assert (loop.where, loop.names) == (where, ("a",))
    assert [leaf.site for leaf in s.leaves.within(loop.values[0])] == [0]


def test_the_first_and_the_last_site_may_differ() -> None:
    s = Tiny()
    sizes = {0: 3, CELLS: 5}
    loops = loops_of(s.leaves, [item("a", NODES, lambda i: sizes.get(i, 1) * s.y(i))])
    assert [loop.where for loop in loops] == [Where(1, 1), Where(-1, 0, alone=True), Where(0, 0, alone=True)]
    assert ["5" in str(loop.values[0]) for loop in loops] == [False, True, False]
    assert ["3" in str(loop.values[0]) for loop in loops] == [False, False, True]


def test_the_last_site_may_look_back_and_the_first_ahead() -> None:
    s = Tiny()
    loops = loops_of(s.leaves, [item("a", NODES, lambda i: s.y(i + 1 if i < CELLS else i - 1))])
    seen = {loop.where: [leaf.site for leaf in s.leaves.within(loop.values[0])] for loop in loops}
    assert seen == {Where(0, 1): [1], Where(-1, 0, alone=True): [-1]}


def test_fields_of_the_same_sites_share_a_loop() -> None:
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


def test_what_neighbours_read_is_computed_before() -> None:
    s = Tiny()
    fields = [
        item("a", NODES, lambda i: 2 * s.y(i)),
        item("b", ON_CELLS, lambda i: s.field("a", i) + s.field("a", i + 1)),
        item("c", NODES, lambda i: 3 * s.y(i)),
        item("d", ON_CELLS, lambda i: s.field("c", i) * s.y(i)),
    ]
    names = [loop.names for loop in loops_of(s.leaves, fields)]
    assert names[0] == ("a", "c")
    assert sorted(sum(names, ())) == ["a", "b", "c", "d"]


def test_every_loop_finds_what_it_reads() -> None:
    """At every one of its sites, ends included."""
    taken = recording()
    loops = loops_of(taken.leaves, [*needed(taken.leaves, taken.staged, taken.rates), *taken.rates])
    known: dict[str, set[int]] = {}
    sites = range(30)
    for loop in loops:
        first = loop.where.first
        run = [sites[first]] if loop.where.alone else sites[first : len(sites) - loop.where.behind]
        for value in loop.values:
            for leaf in taken.leaves.within(value):
                if leaf.kind == "staged":
                    assert {i + leaf.site for i in run} <= known[leaf.name], (loop.names, leaf)
        for name in loop.names:
            known.setdefault(name, set()).update(run)
    assert known["f_y"] == set(sites)
    assert known["f_b"] == set(sites[:-1])


def test_only_what_is_needed_directly_or_not() -> None:
    taken = recording()
    assert [one.name for one in needed(taken.leaves, taken.staged, taken.rates)] == ["gap", "slope", "turn", "force"]
    powers = [one for power in taken.powers for one in power]
    assert "heat" in [one.name for one in needed(taken.leaves, taken.staged, powers)]
