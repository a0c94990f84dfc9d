"""Instructions as C99 text."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

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


def statements(
    code: Code, inputs: Sequence[str], uniform: Sequence[bool], targets: Sequence[str]
) -> tuple[list[str], list[str]]:
    """Statements that come before a loop over the sites, and those within.

    Parameters
    ----------
    code : Code
        What is computed.
    inputs : sequence of str
        C text of each input.
    uniform : sequence of bool
        Whether an input is the same for all sites.
    targets : sequence of str
        C text of what each result is assigned to.
    """
    uses = Counter(argument for one in code.instructions if one.operation != "INPUT" for argument in one.arguments)
    uses.update(result for result in code.results if result >= 0)
    text: dict[int, str] = {}
    alike: dict[int, bool] = {}
    before: list[str] = []
    within: list[str] = []
    for k, one in enumerate(code.instructions):
        if one.operation == "INPUT":
            alike[k], written = uniform[one.arguments[0]], inputs[one.arguments[0]]
        else:
            alike[k] = all(alike[a] for a in one.arguments)
            written = _expression(one, [text[a] for a in one.arguments])
        plain = one.operation in ("INPUT", "CONST")
        crosses = alike[k] and not plain
        if (plain and (uses[k] <= 1 or one.operation == "CONST")) or (
            uses[k] <= 1 and not crosses and len(written) < _LONGEST
        ):
            text[k] = written
            continue
        name = f"{'c' if alike[k] else 'v'}{k}"
        (before if alike[k] else within).append(f"const double {name} = {_bare(written)};")
        text[k] = name
    for target, result in zip(targets, code.results, strict=True):
        within.append(f"{target} = {_bare(text[result]) if result >= 0 else '0.0'};")
    return before, within


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
