"""Instructions as C99 text."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum

from softcat_sym.codegen.instructions import Code, Instruction
from softcat_sym.errors import PrintingError

_LONGEST = 60
"""Of an expression that is written out where it is used, once."""

_INFIX = {"ADD": "+", "SUB": "-", "MUL": "*", "DIV": "/", "LT": "<", "LE": "<=", "EQ": "==", "NE": "!="}
_CALLS = {
    "EXP": "exp",
    "LOG": "log",
    "POW": "pow",
    "CONSTPOW": "pow",
    "SQRT": "sqrt",
    "SIN": "sin",
    "COS": "cos",
    "TAN": "tan",
    "ASIN": "asin",
    "ACOS": "acos",
    "ATAN": "atan",
    "ATAN2": "angle_of",
    "SINH": "sinh",
    "COSH": "cosh",
    "TANH": "tanh",
    "FABS": "fabs",
    "COPYSIGN": "copysign",
    "LOG1P": "log1p",
    "EXPM1": "expm1",
    "HYPOT": "hypot",
    "FMIN": "smaller",
    "FMAX": "larger",
    "SIGN": "sign_of",
}

_HELPERS = {
    "smaller": "static inline double smaller(double a, double b) { return a < b ? a : b; }\n",
    "larger": "static inline double larger(double a, double b) { return a > b ? a : b; }\n",
    "sign_of": "static inline double sign_of(double a) { return a > 0 ? 1.0 : a < 0 ? -1.0 : a; }\n",
    "angle_of": "/* atan2, by the quicker atan where that is the same. */\n"
    "static inline double angle_of(double y, double x) { return x > 0 ? atan(y / x) : atan2(y, x); }\n",
    "squared": "static inline double squared(double a) { return a * a; }\n",
}


def helpers_of(text: str) -> str:
    """The functions that a C text calls and C does not have; compilers warn of those that nobody calls."""
    return "".join(line for name, line in _HELPERS.items() if f"{name}(" in text)


def number(value: float) -> str:
    """A double that C reads as the same one.

    Raises
    ------
    PrintingError
        If it is not a number.
    """
    if math.isnan(value):
        raise PrintingError("an expression of the generated code holds a constant that is not a number")
    if math.isinf(value):
        return "HUGE_VAL" if value > 0 else "(-HUGE_VAL)"
    return repr(value) if value >= 0 else f"({value!r})"


class When(IntEnum):
    """At which point of a loop over the sites something is computed."""

    BEFORE = 0
    """Before the loop: it is the same for all sites."""
    SITE = 1
    """At a site."""
    FIBRE = 2
    """For each fibre of a site."""
    AFTER = 3
    """At a site, when its sums over the fibres are known."""


@dataclass(frozen=True)
class Target:
    """What a result is assigned to.

    Attributes
    ----------
    text : str
        C text.
    each : bool
        Whether there is one for each fibre.
    adds : bool
        Whether the result is added to it.
    """

    text: str
    each: bool = False
    adds: bool = False


def statements(
    code: Code, inputs: Sequence[str], known: Sequence[When], targets: Sequence[Target]
) -> dict[When, list[str]]:
    """Statements by when they are executed.

    Parameters
    ----------
    code : Code
        What is computed.
    inputs : sequence of str
        C text of each input.
    known : sequence of When
        From when on each input is known.
    targets : sequence of Target
        What each result is assigned to.

    Raises
    ------
    PrintingError
        If something of a fibre needs a sum over all of them, or a site something of a fibre.
    """
    uses = Counter(argument for one in code.instructions if one.operation != "INPUT" for argument in one.arguments)
    uses.update(result for result in code.results if result >= 0)
    when = _when(code, known)
    by_fibres = {a for k, one in enumerate(code.instructions) if when[k] == When.FIBRE and one.operation != "INPUT"
                 for a in one.arguments}  # fmt: skip
    text: dict[int, str] = {}
    found: dict[When, list[str]] = {at: [] for at in When}
    for k, one in enumerate(code.instructions):
        if one.operation == "INPUT":
            written = inputs[one.arguments[0]]
        else:
            written = _expression(one, [text[a] for a in one.arguments])
        plain = one.operation in ("INPUT", "CONST")
        # What is known early is computed early, not where it is used.
        crosses = (when[k] == When.BEFORE and not plain) or (when[k] == When.SITE and k in by_fibres)
        if one.operation == "CONST" or (uses[k] <= 1 and not crosses and (plain or len(written) < _LONGEST)):
            text[k] = written
            continue
        text[k] = f"{'c' if when[k] == When.BEFORE else 'v'}{k}"
        found[when[k]].append(f"const double {text[k]} = {_bare(written)};")
    for target, result in zip(targets, code.results, strict=True):
        ready = when[result] if result >= 0 else When.BEFORE
        if ready == (When.AFTER if target.each else When.FIBRE):
            raise PrintingError(f"{target.text} is computed when its fibres are not, or for each of them")
        at = When.FIBRE if target.each else max(When.SITE, ready)
        sign = "+=" if target.adds else "="
        found[at].append(f"{target.text} {sign} {_bare(text[result]) if result >= 0 else '0.0'};")
    return found


def _when(code: Code, known: Sequence[When]) -> list[When]:
    """When each instruction is executed.

    Raises
    ------
    PrintingError
        If one needs both a fibre and the sum over all of them.
    """
    found: list[When] = []
    for one in code.instructions:
        needs = {known[one.arguments[0]]} if one.operation == "INPUT" else {found[a] for a in one.arguments}
        if {When.FIBRE, When.AFTER} <= needs:
            raise PrintingError("a fibre would need the sum over all of them")
        found.append(max(needs, default=When.BEFORE))
    return found


def _bare(text: str) -> str:
    """Without the brackets around the whole."""
    if not (text.startswith("(") and text.endswith(")")):
        return text
    depth = 0
    for place, sign in enumerate(text):
        depth += {"(": 1, ")": -1}.get(sign, 0)
        if depth == 0 and place < len(text) - 1:
            return text
    return text[1:-1]


def _expression(one: Instruction, args: list[str]) -> str:
    name = one.operation
    if name == "CONST":
        return number(one.value)
    if name in _INFIX:
        written = f"({args[0]} {_INFIX[name]} {args[1]})"
        return f"(double){written}" if name in ("LT", "LE", "EQ", "NE") else written
    if name in _CALLS:
        return f"{_CALLS[name]}({', '.join(_bare(a) for a in args)})"
    shapes = {
        "NEG": "(-{0})",
        "INV": "(1.0 / {0})",
        "TWICE": "(2.0 * {0})",
        "SQ": "squared({0})",
        "NOT": "(double)({0} == 0.0)",
        "AND": "(double)(({0} != 0.0) && ({1} != 0.0))",
        "OR": "(double)(({0} != 0.0) || ({1} != 0.0))",
        "IF_ELSE_ZERO": "({0} != 0.0 ? {1} : 0.0)",
        "ASSIGN": "{0}",
    }
    if name not in shapes:
        raise PrintingError(f"CasADi's operation {name} has no C text")
    return shapes[name].format(*args)
