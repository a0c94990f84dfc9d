"""Divisions that are shared: a divisor of many quotients, or the same at all sites, is inverted once.

A division takes as long as four products, and the loops over the sites hold little else that is slow. What is rounded
otherwise differs by one unit in the last place.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence

from softcat_sym.codegen.instructions import Code, Instruction
from softcat_sym.codegen.leaves import PLACE, Leaf

PER = "per_"
INVERTED = "cell", "node", "mass"
"""Lengths and mass of a site whose inverses a run is given too, under names that begin with `PER`."""


def with_reciprocals(code: Code, leaves: Sequence[Leaf]) -> tuple[Code, list[Leaf]]:
    """The same results with fewer divisions, and what they are made of.

    Parameters
    ----------
    code : Code
        Instructions.
    leaves : sequence of Leaf
        Its inputs; those that the new code has besides follow them.
    """
    divisors = Counter(one.arguments[-1] for one in code.instructions if one.operation in ("DIV", "INV"))
    inputs, found = list(leaves), list[Instruction]()
    known: dict[Instruction, int] = {}
    number: dict[int, int] = {}
    alike: dict[int, bool] = {}

    def add(instruction: Instruction, *, uniform: bool) -> int:
        if instruction not in known:
            known[instruction] = len(found)
            alike[len(found)] = uniform
            found.append(instruction)
        return known[instruction]

    def inverse(divisor: int) -> int:
        one = found[divisor]
        if one.operation == "CONST":
            return add(Instruction("CONST", (), 1 / one.value), uniform=True)
        if _is_inverted(one, inputs):
            leaf = inputs[one.arguments[0]]
            other = Leaf(PLACE, PER + leaf.name, leaf.site)
            if other not in inputs:
                inputs.append(other)
            return add(Instruction("INPUT", (inputs.index(other),)), uniform=False)
        return add(Instruction("INV", (divisor,)), uniform=alike[divisor])

    for k, one in enumerate(code.instructions):
        if one.operation == "INPUT":
            number[k] = add(one, uniform=not inputs[one.arguments[0]].is_local)
            continue
        arguments = tuple(number[argument] for argument in one.arguments)
        uniform = all(alike[argument] for argument in arguments)
        if one.operation in ("DIV", "INV") and _pays(found, inputs, alike, arguments, divisors[one.arguments[-1]]):
            over = inverse(arguments[-1])
            number[k] = (
                over if one.operation == "INV" else add(Instruction("MUL", (arguments[0], over)), uniform=uniform)
            )
        else:
            number[k] = add(Instruction(one.operation, arguments, one.value), uniform=uniform)
    return Code(tuple(found), tuple(number[r] if r >= 0 else -1 for r in code.results)), inputs


def _pays(
    found: Sequence[Instruction],
    inputs: Sequence[Leaf],
    alike: dict[int, bool],
    arguments: Sequence[int],
    times: int,
) -> bool:
    """Whether the divisor is better inverted."""
    divisor = found[arguments[-1]]
    if divisor.operation == "CONST":
        return math.isfinite(divisor.value) and divisor.value != 0
    if _is_inverted(divisor, inputs):
        return True
    if alike[arguments[-1]]:
        return not all(alike[argument] for argument in arguments)
    return times > 1


def _is_inverted(one: Instruction, inputs: Sequence[Leaf]) -> bool:
    if one.operation != "INPUT":
        return False
    leaf = inputs[one.arguments[0]]
    return leaf.kind == PLACE and leaf.name in INVERTED
