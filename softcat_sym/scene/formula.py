"""The formula of a user's own flow rule: text to an immutable tree by a whitelist; nothing in it is ever executed."""

from __future__ import annotations

import ast
import math
import warnings
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TypeVar

from softcat_sym.scene.faults import did_you_mean
from softcat_sym.scene.kinds import refusal
from softcat_sym.scene.units import shown

T = TypeVar("T")

STRESS_NAME = "sigma"
# How many arguments each function takes.
_ELEMENTARY = ("exp", "log", "sqrt", "sinh", "cosh", "tanh", "asinh", "atan", "sin", "cos")
FUNCTIONS = dict.fromkeys((*_ELEMENTARY, "abs", "sign"), 1) | {"min": 2, "max": 2}
CONSTANTS = {"pi": math.pi}
ACCEPTED = f"numbers, names, + - * / **, and {', '.join(FUNCTIONS)} of {STRESS_NAME} and the parameters"

_BINARY: dict[type[ast.operator], str] = {
    ast.Add: "add",
    ast.Sub: "sub",
    ast.Mult: "mul",
    ast.Div: "div",
    ast.Pow: "pow",
}
_LONGEST = 500
_DEEPEST = 100


@dataclass(frozen=True, slots=True)
class Node:
    """A number, a name, or an operation on other nodes: one of the three is set.

    Attributes
    ----------
    piece : str
        The text it was read from.
    """

    piece: str = field(compare=False)
    number: float | None = None
    name: str = ""
    operation: str = ""
    arguments: tuple[Node, ...] = ()


@dataclass(frozen=True, slots=True)
class Formula:
    """An expression in `sigma` and named parameters. Build one with `parse_formula`.

    Attributes
    ----------
    text : str
        As the user wrote it.
    tree : Node
        What it means.
    """

    text: str
    tree: Node = field(compare=False, repr=False)

    @property
    def names(self) -> frozenset[str]:
        """Names besides sigma and pi."""
        return frozenset(node.name for node in _walk(self.tree) if node.name) - {STRESS_NAME, *CONSTANTS}

    def fold(
        self,
        number: Callable[[float], T],
        name: Callable[[str], T],
        operation: Callable[[str, tuple[T, ...]], T],
    ) -> T:
        """Rebuild the expression from its leaves up, in any arithmetic.

        Parameters
        ----------
        number, name : callable
            Turn a leaf into a value. ``pi`` comes as the number; ``sigma`` and the parameters come as names.
        operation : callable
            Gets ``add``, ``sub``, ``mul``, ``div``, ``pow``, ``neg`` or a function of `FUNCTIONS`, and its operands.

        Returns
        -------
        T
            The value of the whole.
        """
        return _fold(self.tree, number, name, operation)

    def value(self, sigma: float, parameters: Mapping[str, float]) -> float:
        """Evaluate in plain floats.

        Parameters
        ----------
        sigma : float
            Stress [Pa].
        parameters : mapping of str to float
            SI values by name.

        Returns
        -------
        float
            Infinite where it overflows, NaN where it is not defined.
        """
        known = {**parameters, STRESS_NAME: sigma}
        return self.fold(float, known.__getitem__, _compute)


@lru_cache(maxsize=256)
def parse_formula(text: str) -> Formula:
    """Read a formula.

    Parameters
    ----------
    text : str
        Such as ``"sinh(sigma/s0)/t0"``.

    Returns
    -------
    Formula

    Raises
    ------
    PydanticCustomError
        A `refusal` that names the piece which is no arithmetic.
    """
    if not text.strip():
        raise refusal("empty", f'a formula such as "sinh(sigma/s0)/t0": {ACCEPTED}')
    if len(text) > _LONGEST:
        raise refusal(f"{len(text)} characters long", f"at most {_LONGEST} characters")
    try:
        with warnings.catch_warnings():
            # Of text that is refused below in any case.
            warnings.simplefilter("ignore")
            body = ast.parse(text.strip(), mode="eval").body
        return Formula(text, _read(body, text.strip(), 0))
    except SyntaxError as error:
        raise refusal(f"{shown(text)} is no formula: {error.msg}", ACCEPTED) from None
    except (ValueError, RecursionError, MemoryError) as error:
        if hasattr(error, "context"):
            raise
        raise refusal(f"{shown(text)} is no formula", ACCEPTED) from None


def _read(node: ast.expr, text: str, depth: int) -> Node:  # noqa: C901 - one branch a kind of node
    piece = ast.get_source_segment(text, node) or text
    if depth > _DEEPEST:
        raise refusal(f"nested more than {_DEEPEST} deep", "a shorter formula")
    match node:
        case ast.Constant(value=bool()):
            raise refusal(f"{shown(piece)} is not arithmetic", ACCEPTED)
        case ast.Constant(value=int() | float() as number):
            return Node(piece, number=_finite(number, piece))
        case ast.Name(id=name) if name in CONSTANTS:
            return Node(piece, number=CONSTANTS[name])
        case ast.Name(id=name) if name in FUNCTIONS:
            raise refusal(f"the function {name} has no argument", f"{name}(...)")
        case ast.Name(id=name):
            return Node(piece, name=name)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return Node(piece, operation="neg", arguments=(_read(operand, text, depth + 1),))
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _read(operand, text, depth + 1)
        case ast.BinOp(op=ast.BitXor()):
            raise refusal(f"'^' in {shown(piece)}", "** for powers")
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _BINARY:
            both = (_read(left, text, depth + 1), _read(right, text, depth + 1))
            return Node(piece, operation=_BINARY[type(op)], arguments=both)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
            _check_call(name, arguments)
            read = tuple(_read(argument, text, depth + 1) for argument in arguments)
            return Node(piece, operation=name, arguments=read)
        case _:
            raise refusal(f"{shown(piece)} is not arithmetic", ACCEPTED)


def _finite(number: float, piece: str) -> float:
    try:
        finite = float(number)
    except OverflowError:
        finite = math.inf
    if not math.isfinite(finite):
        raise refusal(f"{shown(piece)} is not finite", "a moderate number")
    return finite


def _check_call(name: str, arguments: list[ast.expr]) -> None:
    if name not in FUNCTIONS:
        raise refusal(f"unknown function {shown(name)}{did_you_mean(name, FUNCTIONS)}", ", ".join(FUNCTIONS))
    if len(arguments) != FUNCTIONS[name]:
        count = "one argument" if FUNCTIONS[name] == 1 else "two arguments"
        raise refusal(f"{name} of {len(arguments)} arguments", f"{name} of {count}")


def _walk(node: Node) -> Iterator[Node]:
    yield node
    for argument in node.arguments:
        yield from _walk(argument)


def _fold(
    node: Node, number: Callable[[float], T], name: Callable[[str], T], operation: Callable[[str, tuple[T, ...]], T]
) -> T:
    if node.number is not None:
        return number(node.number)
    if node.name:
        return name(node.name)
    return operation(node.operation, tuple(_fold(a, number, name, operation) for a in node.arguments))


_COMPUTE: dict[str, Callable[..., float]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "div": lambda a, b: a / b,
    "pow": math.pow,
    "neg": lambda a: -a,
    "abs": abs,
    "sign": lambda a: math.copysign(1.0, a) if a else a,
    "min": lambda a, b: math.nan if math.isnan(a) or math.isnan(b) else min(a, b),
    "max": lambda a, b: math.nan if math.isnan(a) or math.isnan(b) else max(a, b),
    **{
        name: getattr(math, name)
        for name in ["exp", "log", "sqrt", "sinh", "cosh", "tanh", "asinh", "atan", "sin", "cos"]
    },
}


def _compute(operation: str, operands: tuple[float, ...]) -> float:
    try:
        return float(_COMPUTE[operation](*operands))
    except OverflowError:
        # Only an odd function of a negative number, or an odd power of one, falls to minus infinity.
        odd_power = operation == "pow" and operands[0] < 0 and operands[1] % 2 == 1
        return -math.inf if odd_power or (operation == "sinh" and operands[0] < 0) else math.inf
    except ZeroDivisionError:
        return math.copysign(math.inf, operands[0]) if operands[0] else math.nan
    except ValueError:
        # math.pow calls 0 to a negative power a domain error.
        return math.inf if operation == "pow" and operands[0] == 0 else math.nan
