"""One table of symbols with LaTeX, dimensions and equation numbers; a machine checks every term of every equation."""

from __future__ import annotations

from softcat_sym.physics.equation import all_equations, check
from softcat_sym.physics.symbols import fields, table

from .table import show


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
