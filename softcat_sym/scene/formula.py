"""The formula of a user's own flow rule: parsed by a whitelist into an immutable tree, units and meaning checked."""

from __future__ import annotations

import ast
import math
import re
import warnings
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from heapq import heappop, heappush
from typing import TypeVar

from softcat_sym.scene.units import PURE, STRESS, Dimension, did_you_mean, refusal, same_dimension, shown, si_unit

T = TypeVar("T")

Interval = tuple[float, float]
"""A lower bound and an upper one."""

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
_HUGE = 10**308


@dataclass(frozen=True, slots=True)
class Formula:
    """An expression in `sigma` and named parameters. Build one with `parse_formula`."""

    text: str  # As the user wrote it
    tree: ast.expr = field(compare=False, repr=False)  # What it means: of nothing but `_operation`

    @property
    def names(self) -> frozenset[str]:
        """Names besides sigma and pi."""
        return self.all_names - {STRESS_NAME}

    @property
    def all_names(self) -> frozenset[str]:
        """Names besides pi."""
        return _names(self.tree)

    def fold(
        self, number: Callable[[float], T], name: Callable[[str], T], operation: Callable[[str, tuple[T, ...]], T]
    ) -> T:
        """Rebuild the expression from its leaves up, in any arithmetic."""

        def rebuilt(node: ast.expr) -> T:
            head, operands = _operation(node)
            if operands:
                return operation(str(head), tuple(map(rebuilt, operands)))
            return name(head) if isinstance(head, str) else number(head)

        return rebuilt(self.tree)

    def value(self, sigma: float, parameters: Mapping[str, float]) -> float:
        """Evaluate in plain floats."""
        return self.value_of({**parameters, STRESS_NAME: sigma})

    def value_of(self, known: Mapping[str, float]) -> float:
        """Evaluate in plain floats, every name given."""
        return self.fold(float, known.__getitem__, _compute)

    def bounds(self, known: Mapping[str, Interval]) -> Interval:
        """Bounds of its values while every name lies between its own bounds: at least as wide as they are."""
        return self.fold(lambda number: (number, number), known.__getitem__, _enclosed)

    def least(
        self,
        name: str,
        between: Interval,
        known: Mapping[str, float],
        is_fine: Callable[[float], bool],
        *,
        highest: bool = False,
        tolerance: float = 1e-9,
    ) -> Interval:
        """Find where it is least (or highest) while one name runs, by bounds over ever smaller parts of its range.

        Parameters
        ----------
        name : str
            What runs.
        between : (float, float)
            From where to where.
        known : mapping of str to float
            Values of the other names.
        is_fine : callable
            Whether a value is one that may be: the search ends where the bounds of all parts are.
        highest : bool
            Look for the highest value instead.
        tolerance : float
            Difference of values, over the largest that was seen, that does not matter.

        Returns
        -------
        (float, float)
            Where it is least of all that was looked at, and its value there.
        """
        sign = -1.0 if highest else 1.0
        points = {one: (value, value) for one, value in known.items()}

        def at(where: float) -> tuple[float, float]:
            value = self.value_of({**known, name: where})
            return where, value if math.isfinite(value) else math.nan

        def order(point: tuple[float, float]) -> float:
            return -math.inf if math.isnan(point[1]) else sign * point[1]

        def part(begin: float, end: float) -> tuple[float, float, float]:
            low, high = self.bounds({**points, name: (begin, end)})
            return (-high if highest else low), begin, end

        best = min(map(at, between), key=order)
        parts, scale = [part(*between)], abs(best[1])
        for _ in range(_PARTS):
            low, begin, end = heappop(parts)
            if is_fine(sign * low) or low >= sign * best[1] - tolerance * scale:
                break
            middle = at(begin + (end - begin) / 2)
            best = min(best, middle, key=order)
            scale = max(scale, abs(middle[1]))
            for half in (part(begin, middle[0]), part(middle[0], end)):
                heappush(parts, half)
        return best


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
            tree = ast.parse(text.strip(), mode="eval").body
        _check(tree)
    except SyntaxError as error:
        raise refusal(f"{shown(text)} is no formula: {error.msg}", ACCEPTED) from None
    except (ValueError, RecursionError, MemoryError) as error:
        if hasattr(error, "context"):
            raise
        raise refusal(f"{shown(text)} is no formula", ACCEPTED) from None
    return Formula(text, tree)


def _check(node: ast.expr, depth: int = 0) -> None:
    if depth > _DEEPEST:
        raise refusal(f"nested more than {_DEEPEST} deep", "a shorter formula")
    head, operands = _operation(node)
    if isinstance(head, float) and not math.isfinite(head):
        raise refusal(f"{_piece(node)} is not finite", "a moderate number")
    if isinstance(node, ast.Call):
        if head not in FUNCTIONS:
            raise refusal(f"unknown function {shown(head)}{did_you_mean(head, FUNCTIONS)}", ", ".join(FUNCTIONS))
        if len(operands) != FUNCTIONS[head]:
            count = "one argument" if FUNCTIONS[head] == 1 else "two arguments"
            raise refusal(f"{head} of {len(operands)} arguments", f"{head} of {count}")
    elif not operands and head in FUNCTIONS:
        raise refusal(f"the function {head} has no argument", f"{head}(...)")
    for operand in operands:
        _check(operand, depth + 1)


def _operation(node: ast.expr) -> tuple[float | str, list[ast.expr]]:
    """Name and operands of an operation; of a number its value, of a name itself, and none."""
    match node:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            return (float(number) if abs(number) < _HUGE else math.inf), []
        case ast.Name(id=name):
            return FORMULA_CONSTANTS.get(name, name), []
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return "neg", [operand]
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _operation(operand)
        case ast.BinOp(op=ast.BitXor()):
            raise refusal(f"'^' in {_piece(node)}", "** for powers")
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _BINARY:
            return _BINARY[type(op)], [left, right]
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
            return name, arguments
    raise refusal(f"{_piece(node)} is not arithmetic", ACCEPTED)


def _piece(node: ast.expr) -> str:
    return shown(re.sub(r" ([*/]+) ", r"\1", ast.unparse(node)))


_PARTS = 300
"""Parts of a range that are looked into: a dip of a billionth of it is found in thirty."""


_ROUNDED = 4e-16
"""Relative error of one operation."""


def _enclosed(operation: str, operands: tuple[Interval, ...]) -> Interval:
    """Bounds of an operation on all numbers between bounds (Moore 1966); without any where it may be undefined."""
    found = _bounds(operation, *operands)
    if any(map(math.isnan, found)):
        return -math.inf, math.inf
    if operation in ("neg", "abs", "sign", "min", "max"):
        return found
    low, high = found
    low, high = low - _ROUNDED * abs(low), high + _ROUNDED * abs(high)
    return (max(low, -1.0), min(high, 1.0)) if operation in ("sin", "cos") else (low, high)


def _bounds(operation: str, one: Interval, other: Interval = (0.0, 0.0)) -> Interval:
    (a, b), (c, d) = one, other
    match operation:
        case "sub":
            return a - d, b - c
        case "neg":
            return -b, -a
        case "abs" | "cosh":
            least = 0.0 if a <= 0 <= b else min(abs(a), abs(b))
            return _compute(operation, (least,)), _compute(operation, (max(abs(a), abs(b)),))
        case "sin" | "cos":
            # Bounds of a sine or cosine, whose crests are 2 pi apart and whose troughs lie between them.
            crest = 0.5 * math.pi if operation == "sin" else 0.0
            if not b - a < 2 * math.pi:
                return -1.0, 1.0
            ends = _compute(operation, (a,)), _compute(operation, (b,))
            holds = [
                math.floor((b - place) / (2 * math.pi)) != math.floor((a - place) / (2 * math.pi))
                for place in (crest, crest + math.pi)
            ]
            return -1.0 if holds[1] else min(ends), 1.0 if holds[0] else max(ends)
        case "div" if c <= 0 <= d:
            return -math.inf, math.inf
        case "pow":
            return _of_power(a, b, c, d)
        case "add" | "min" | "max":
            return _compute(operation, (a, c)), _compute(operation, (b, d))
        case "mul" | "div":
            corners = [_compute(operation, (x, y)) for x in one for y in other]
            return (math.nan, math.nan) if any(map(math.isnan, corners)) else (min(corners), max(corners))
    # All others grow; a logarithm or a root of what may be negative has no bounds.
    return _compute(operation, (a,)), _compute(operation, (b,))


def _of_power(a: float, b: float, c: float, d: float) -> Interval:
    """Bounds of a power: monotone in base and exponent where the base is positive, odd or even for a whole exponent."""
    if a >= 0:
        corners = [_compute("pow", (x, y)) for x in (a, b) for y in (c, d)]
        return min(corners), max(corners)
    if c != d or c != round(c) or c < 0:
        return -math.inf, math.inf
    if c % 2:
        return _compute("pow", (a, c)), _compute("pow", (b, c))
    least, most = 0.0 if a <= 0 <= b else min(abs(a), abs(b)), max(abs(a), abs(b))
    return _compute("pow", (least, c)), _compute("pow", (most, c))


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
    **{name: getattr(math, name) for name in _ELEMENTARY},
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
Sized = Dimension | None
"""Exponents of kg, m and s; None for a literal zero, which goes with any unit."""


def check_units(formula: Formula, of: Mapping[str, Dimension], values: Mapping[str, float]) -> None:
    """Refuse a formula that is not a rate."""
    found = formula_dimension(formula, {**of, STRESS_NAME: STRESS}, values)
    if found is not None and not same_dimension(found, RATE):
        raise refusal(f"{formula.text!r} is {_words(found)}", "a strain rate, 1/s; check the units of the parameters")


def formula_dimension(formula: Formula, of: Mapping[str, Dimension], values: Mapping[str, float]) -> Sized:
    """Dimension of a formula of names of these dimensions; what has no value among `values` varies."""

    def found(node: ast.expr) -> Sized:
        head, operands = _operation(node)
        if not operands:
            return of[head] if isinstance(head, str) else PURE if head else None
        first, *others = map(found, operands)
        if head in ("neg", "abs", "sign"):
            return PURE if head == "sign" else first
        if head == "sqrt":
            return _sum(0.5, first)
        if head in ("mul", "div"):
            return _sum(1.0, first, 1.0 if head == "mul" else -1.0, others[0])
        if head == "pow":
            return _raised(node, operands[1], first, others[0], values)
        if not others and not _is_pure(first):
            what = f"the argument {_piece(operands[0])} of {head} is {_words(first)}"
            raise refusal(what, "a pure number, such as sigma over a stress")
        if first is not None and not all(one is None or same_dimension(first, one) for one in others):
            (left, size), (right, other) = zip(map(_piece, operands), map(_words, (first, *others)), strict=True)
            raise refusal(f"{_piece(node)} puts {left}, {size}, beside {right}, {other}", "two of the same unit")
        return PURE if not others else others[0] if first is None else first

    return found(formula.tree)


def _raised(node: ast.expr, exponent: ast.expr, base: Sized, power: Sized, values: Mapping[str, float]) -> Sized:
    if not _is_pure(power):
        raise refusal(f"the exponent {_piece(exponent)} is {_words(power)}", "a pure number")
    if _is_pure(base):
        return base
    if varying := sorted(_names(exponent) - set(values)):
        found = f"{_piece(node)}: the exponent depends on {varying[0]}, but the base is {_words(base)}"
        raise refusal(found, "a base without a unit")
    return _sum(Formula("", exponent).value(0.0, values), base)


def _is_pure(dimension: Sized) -> bool:
    return dimension is None or same_dimension(dimension, PURE)


def _names(node: ast.expr) -> frozenset[str]:
    """Names in an expression but for functions and constants."""
    head, operands = _operation(node)
    own = {head} if isinstance(head, str) and not operands else set()
    return frozenset(own.union(*map(_names, operands)))


def _sum(factor: float, one: Sized, other_factor: float = 0.0, other: Sized = PURE) -> Sized:
    if one is None or other is None:
        return None
    kg, m, s = (factor * x + other_factor * y for x, y in zip(one, other, strict=True))
    return kg, m, s


def _words(dimension: Sized) -> str:
    return "a pure number" if dimension is None or _is_pure(dimension) else f"of unit {si_unit(dimension)}"


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
    rates = _rates(formula, values, stresses)
    if not any(rates):
        raise refusal(f"nothing flows at any stress up to {stresses[-1]:.4g} Pa", "a rate that grows with stress")
    at_rest, tiny = formula.value(0.0, values), 1e-12 * next(rate for rate in map(abs, rates) if rate)
    if not abs(at_rest) <= tiny:
        raise refusal(f"the rate without stress is {at_rest:.4g} 1/s", "a rate that is 0 at sigma = 0")
    for sigma, rate in zip(stresses, rates, strict=False):
        mirror = formula.value(-sigma, values)
        if not abs(rate + mirror) <= _ROUNDING * abs(rate) + tiny:
            found = f"not odd: {rate:.4g} 1/s at {sigma:.4g} Pa, but {mirror:.4g} 1/s at {-sigma:.4g} Pa"
            raise refusal(found, "phi(-sigma) = -phi(sigma), such as sign(sigma)*abs(sigma)**2")
    sigma, rate = formula.least(STRESS_NAME, (0.0, stresses[len(rates) - 1]), values, lambda one: one >= -tiny)
    found = "" if rate >= -tiny else f"{rate:.4g} 1/s at {sigma:.6g} Pa"
    for sigma, last, rate in zip(stresses, [0.0, *rates], rates, strict=False):
        if not found and (rate < -tiny or rate < last - _ROUNDING * last - tiny):
            found = f"from {last:.4g} to {rate:.4g} 1/s the rate decreases at {sigma:.4g} Pa"
    if found:
        raise refusal(f"negative dissipation: {found}", "a rate that has the sign of the stress and never decreases")


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


def _rates(formula: Formula, values: dict[str, float], stresses: list[float]) -> list[float]:
    """Rates up to where they are too fast to matter."""
    rates: list[float] = []
    for sigma in stresses:
        rate = formula.value(sigma, values)
        if math.isnan(rate):
            raise refusal(f"not a number at sigma = {sigma:.4g} Pa", "a rate that is finite at every stress")
        if abs(rate) > _FASTEST:
            break
        rates.append(rate)
    if not rates:
        raise refusal(f"{rate:.4g} 1/s at sigma = {sigma:.4g} Pa", "a rate that is small at small stresses")
    return rates


def _stresses(scales: Iterable[float]) -> list[float]:
    """Evenly over the decades, and on both sides of each scale, where a rule may have a corner."""
    given = sorted(scales)
    low, high = _LOWEST * given[0], _HIGHEST * given[-1]
    count = math.ceil(_PER_DECADE * math.log10(high / low))
    sampled = [low * (high / low) ** (i / count) for i in range(count + 1)]
    near = [scale * factor for scale in given for factor in (1 - 1e-9, 1.0, 1 + 1e-9)]
    return sorted({*sampled, *near})
