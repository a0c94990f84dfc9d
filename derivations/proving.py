"""What every notebook here uses: proofs of equality, and rows of the errata table."""

from __future__ import annotations

import json
import random
from dataclasses import asdict, dataclass
from pathlib import Path

import sympy as sp

from softcat_sym.physics.equation import Equation
from softcat_sym.physics.symbols import entry

ERRATA = Path(__file__).parent / "errata"


@dataclass(frozen=True, slots=True)
class Erratum:
    """One misprint: where, what stands there, what should, and how that is proved."""

    equation: str
    printed: str
    correct: str
    proof: str


def vanishes(expression: sp.Expr) -> bool:
    """Whether SymPy can show that an expression is zero identically."""
    expression = sp.sympify(expression)
    return any(sp.simplify(form) == 0 for form in (expression, sp.expand(expression), sp.trigsimp(expression)))


def prove_equal(derived: sp.Expr, held: sp.Expr) -> None:
    """Fail unless what was derived is what the package holds."""
    difference = sp.sympify(derived) - sp.sympify(held)
    if not vanishes(difference):
        raise AssertionError(f"derived {derived}\nheld    {held}\ndiffer  {sp.simplify(difference)}")


def check(equation: Equation) -> None:
    """Fail unless all terms of both sides change by one factor when the units of mass, length and time do."""
    draw, sides = random.Random(1), (sp.expand(equation.left), sp.expand(equation.right))
    values = {
        symbol: sp.Float(draw.uniform(0.5, 1.5), 30)
        for symbol in sorted(sides[0].free_symbols | sides[1].free_symbols, key=str)
    }
    units = [sp.Integer(2), sp.Integer(3), sp.Integer(5)]
    scaled = {
        symbol: value * sp.prod(unit**power for unit, power in zip(units, entry(symbol).dimension, strict=True))
        for symbol, value in values.items()
    }
    terms = [term for side in sides for term in sp.Add.make_args(side) if term != 0]
    factors = [sp.N(term.subs(scaled) / term.subs(values), 20) for term in terms]
    assert all(abs(factor / factors[0] - 1) < 1e-12 for factor in factors), f"{equation.name}: {factors}"


def record_errata(notebook: str, rows: list[Erratum]) -> None:
    """Leave the misprints that a notebook has proved where `10_errata` collects them."""
    ERRATA.mkdir(exist_ok=True)
    text = json.dumps([asdict(row) for row in rows], indent=2, ensure_ascii=False) + "\n"
    (ERRATA / f"{notebook}.json").write_text(text, encoding="utf-8")
