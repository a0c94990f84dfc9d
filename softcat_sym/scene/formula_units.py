"""Dimensional analysis of a formula: both sides of a sum alike, functions of pure numbers, a rate in the end."""

from __future__ import annotations

from collections.abc import Mapping

from softcat_sym.scene.formula import STRESS_NAME, Formula, Node
from softcat_sym.scene.kinds import refusal
from softcat_sym.scene.units import PURE, STRESS, Dimension, same_dimension, si_unit

RATE: Dimension = (0.0, 0.0, -1.0)
_ALIKE = ("add", "sub", "min", "max")


def check_units(formula: Formula, of: Mapping[str, Dimension], values: Mapping[str, float]) -> None:
    """Refuse a formula that is not a rate.

    Parameters
    ----------
    formula : Formula
        Of known names only.
    of : mapping of str to tuple of float
        Exponents of kg, m and s of each parameter.
    values : mapping of str to float
        SI values, for exponents.

    Raises
    ------
    PydanticCustomError
        A `refusal` that names the piece whose units do not fit.
    """
    found = _dimension(formula.tree, of, values)
    if found is not None and not same_dimension(found, RATE):
        raise refusal(f"{formula.text!r} is {_words(found)}", "a strain rate, 1/s; check the units of the parameters")


def _dimension(node: Node, of: Mapping[str, Dimension], values: Mapping[str, float]) -> Dimension | None:  # noqa: C901 - one branch a kind of node
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
