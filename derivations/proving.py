"""What every notebook here uses: proofs of equality, and rows of the errata table."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

import sympy as sp

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


def record_errata(notebook: str, rows: list[Erratum]) -> None:
    """Leave the misprints that a notebook has proved where `10_errata` collects them."""
    ERRATA.mkdir(exist_ok=True)
    text = json.dumps([asdict(row) for row in rows], indent=2, ensure_ascii=False) + "\n"
    (ERRATA / f"{notebook}.json").write_text(text, encoding="utf-8")
