"""The formula of a user's own flow rule: parsed by a whitelist into an immutable tree, units and meaning checked."""

from __future__ import annotations

import ast
import math
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TypeVar

from softcat_sym.scene.units import PURE, STRESS, Dimension, did_you_mean, refusal, same_dimension, shown, si_unit

T = TypeVar("T")

STRESS_NAME = "sigma"
# How many arguments each function takes.
_ELEMENTARY = ("exp", "log", "sqrt", "sinh", "cosh", "tanh", "asinh", "atan", "sin", "cos")
FUNCTIONS = dict.fromkeys((*_ELEMENTARY, "abs", "sign"), 1) | {"min": 2, "max": 2}
FORMULA_CONSTANTS = {"pi": math.pi}
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
    """A number, a name, or an operation on other nodes: one of the three is set."""

    piece: str = field(compare=False)  # The text it was read from
    number: float | None = None
    name: str = ""
    operation: str = ""
    arguments: tuple[Node, ...] = ()


@dataclass(frozen=True, slots=True)
class Formula:
    """An expression in `sigma` and named parameters. Build one with `parse_formula`."""

    text: str  # As the user wrote it
    tree: Node = field(compare=False, repr=False)  # What it means

    @property
    def names(self) -> frozenset[str]:
        """Names besides sigma and pi."""
        return frozenset(node.name for node in _walk(self.tree) if node.name) - {STRESS_NAME, *FORMULA_CONSTANTS}

    def fold(
        self, number: Callable[[float], T], name: Callable[[str], T], operation: Callable[[str, tuple[T, ...]], T]
    ) -> T:
        """Rebuild the expression from its leaves up, in any arithmetic."""
        return _fold(self.tree, number, name, operation)

    def value(self, sigma: float, parameters: Mapping[str, float]) -> float:
        """Evaluate in plain floats."""
        known = {**parameters, STRESS_NAME: sigma}
        return self.fold(float, known.__getitem__, _compute)


@lru_cache(maxsize=256)
def parse_formula(text: str) -> Formula:
    """Read a formula."""
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


def _read(node: ast.expr, text: str, depth: int) -> Node:
    piece = ast.get_source_segment(text, node) or text
    if depth > _DEEPEST:
        raise refusal(f"nested more than {_DEEPEST} deep", "a shorter formula")
    match node:
        case ast.Constant(value=bool()):
            raise refusal(f"{shown(piece)} is not arithmetic", ACCEPTED)
        case ast.Constant(value=int() | float() as number):
            return Node(piece, number=_finite(number, piece))
        case ast.Name(id=name) if name in FORMULA_CONSTANTS:
            return Node(piece, number=FORMULA_CONSTANTS[name])
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


RATE: Dimension = (0.0, 0.0, -1.0)
_ALIKE = ("add", "sub", "min", "max")


def check_units(formula: Formula, of: Mapping[str, Dimension], values: Mapping[str, float]) -> None:
    """Refuse a formula that is not a rate."""
    found = _dimension(formula.tree, of, values)
    if found is not None and not same_dimension(found, RATE):
        raise refusal(f"{formula.text!r} is {_words(found)}", "a strain rate, 1/s; check the units of the parameters")


def _dimension(node: Node, of: Mapping[str, Dimension], values: Mapping[str, float]) -> Dimension | None:
    """Exponents of kg, m and s; None for a literal zero, which goes with any unit."""
    if node.number is not None:
        return PURE if node.number else None
    if node.name:
        return STRESS if node.name == STRESS_NAME else of[node.name]
    operands = [_dimension(argument, of, values) for argument in node.arguments]
    match node.operation:
        case "neg" | "abs":
            return operands[0]
        case "sign":
            return PURE
        case "sqrt":
            return _times(operands[0], 0.5)
        case "mul":
            return _plus(operands[0], operands[1], 1)
        case "div":
            return _plus(operands[0], operands[1], -1)
        case "pow":
            return _power(node, operands, values)
        case _ if node.operation in _ALIKE:
            return _alike(node, operands)
        case _:
            if operands[0] is not None and not same_dimension(operands[0], PURE):
                found = f"the argument {node.arguments[0].piece!r} of {node.operation} is {_words(operands[0])}"
                raise refusal(found, "a pure number, such as sigma over a stress")
            return PURE


def _alike(node: Node, operands: list[Dimension | None]) -> Dimension | None:
    one, other = operands
    if one is not None and other is not None and not same_dimension(one, other):
        left, right = (argument.piece for argument in node.arguments)
        raise refusal(
            f"{node.piece!r} puts {left!r}, {_words(one)}, beside {right!r}, {_words(other)}", "two of the same unit"
        )
    return one if one is not None else other


def _power(node: Node, operands: list[Dimension | None], values: Mapping[str, float]) -> Dimension | None:
    base, exponent = operands
    written = node.arguments[1]
    if exponent is not None and not same_dimension(exponent, PURE):
        raise refusal(f"the exponent {written.piece!r} is {_words(exponent)}", "a pure number")
    if base is None or same_dimension(base, PURE):
        return base
    part = Formula(written.piece, written)
    if STRESS_NAME in _names(written):
        raise refusal(
            f"{node.piece!r}: the exponent depends on sigma, but the base is {_words(base)}", "a base without a unit"
        )
    return _times(base, part.value(0.0, values))


def _names(node: Node) -> set[str]:
    return {node.name}.union(*(_names(argument) for argument in node.arguments))


def _times(dimension: Dimension | None, factor: float) -> Dimension | None:
    return None if dimension is None else (dimension[0] * factor, dimension[1] * factor, dimension[2] * factor)


def _plus(one: Dimension | None, other: Dimension | None, sign: int) -> Dimension | None:
    if one is None or other is None:
        return None
    return (one[0] + sign * other[0], one[1] + sign * other[1], one[2] + sign * other[2])


def _words(dimension: Dimension) -> str:
    return "a pure number" if same_dimension(dimension, PURE) else f"of unit {si_unit(dimension)}"


# Below and above the stress scales of the scene.
_LOWEST, _HIGHEST = 1e-6, 30.0
_PER_DECADE = 40
# Faster than this nothing is worth looking at [1/s].
_FASTEST = 1e30
_ROUNDING = 1e-9
# A rate below this is the underflow of a rule that never quite vanishes, not a yield stress.
_VANISHING = 1e-250


def check_rule(formula: Formula, values: dict[str, float], scales: Iterable[float]) -> None:
    """Refuse a rule that is not odd, not finite, decreases or creates energy, at many stresses."""
    stresses = _stresses(scales)
    at_rest = formula.value(0.0, values)
    rates = _rates(lambda sigma: formula.value(sigma, values), stresses)
    if not rates or not any(rates):
        raise refusal(f"nothing flows at any stress up to {stresses[-1]:.4g} Pa", "a rate that grows with stress")
    tiny = 1e-12 * next(rate for rate in map(abs, rates) if rate)
    if not abs(at_rest) <= tiny:
        raise refusal(f"the rate without stress is {at_rest:.4g} 1/s", "a rate that is 0 at sigma = 0")
    for sigma, rate in zip(stresses, rates, strict=False):
        mirror = formula.value(-sigma, values)
        if not abs(rate + mirror) <= _ROUNDING * abs(rate) + tiny:
            found = f"not odd: {rate:.4g} 1/s at {sigma:.4g} Pa, but {mirror:.4g} 1/s at {-sigma:.4g} Pa"
            raise refusal(found, "phi(-sigma) = -phi(sigma), such as sign(sigma)*abs(sigma)**2")
    _check_dissipation(stresses, rates, tiny)


def _check_dissipation(stresses: list[float], rates: list[float], tiny: float) -> None:
    accepted = "a rate that has the sign of the stress and never decreases"
    last = 0.0
    for sigma, rate in zip(stresses, rates, strict=False):
        if rate < -tiny:
            raise refusal(f"negative dissipation: the rate is {rate:.4g} 1/s at sigma = {sigma:.4g} Pa", accepted)
        if rate < last - _ROUNDING * last - tiny:
            found = f"decreases from {last:.4g} to {rate:.4g} 1/s at sigma = {sigma:.4g} Pa (negative dissipation)"
            raise refusal(found, accepted)
        last = rate


@lru_cache(maxsize=256)
def threshold(text: str, values: tuple[tuple[str, float], ...], scales: tuple[float, ...]) -> float:
    """Find the stress below which a rule is exactly 0, by bisection."""
    formula, known = parse_formula(text), dict(values)
    stresses = _stresses(scales)
    beyond = next((i for i, sigma in enumerate(stresses) if formula.value(sigma, known) != 0), 0)
    if beyond == 0:
        return 0.0
    closed, flowing = stresses[beyond - 1], stresses[beyond]
    if abs(formula.value(flowing * (1 + 1e-3), known)) < _VANISHING:
        return 0.0
    while (middle := (closed + flowing) / 2) not in (closed, flowing):
        if formula.value(middle, known) == 0:
            closed = middle
        else:
            flowing = middle
    # The last stress at which nothing flows, rid of the rounding of the bisection.
    short = float(f"{closed:.13g}")
    return short if formula.value(short, known) == 0 else closed


def _rates(rule: Callable[[float], float], stresses: list[float]) -> list[float]:
    """Rates up to where they are too fast to matter."""
    rates: list[float] = []
    for sigma in stresses:
        rate = rule(sigma)
        if math.isnan(rate):
            raise refusal(f"not a number at sigma = {sigma:.4g} Pa", "a rate that is finite at every stress")
        if abs(rate) > _FASTEST:
            if not rates:
                raise refusal(f"{rate:.4g} 1/s at sigma = {sigma:.4g} Pa", "a rate that is small at small stresses")
            break
        rates.append(rate)
    return rates


def _stresses(scales: Iterable[float]) -> list[float]:
    """Evenly over the decades, and on both sides of each scale, where a rule may have a corner."""
    given = sorted(scales)
    low, high = _LOWEST * given[0], _HIGHEST * given[-1]
    count = math.ceil(_PER_DECADE * math.log10(high / low))
    sampled = [low * (high / low) ** (i / count) for i in range(count + 1)]
    near = [scale * factor for scale in given for factor in (1 - 1e-9, 1.0, 1 + 1e-9)]
    return sorted({*sampled, *near})
