"""Instructions that need not be executed where a condition is false, since all that comes of them is zero then.

Where no fibre flows, neither its rate nor a derivative of it asks for powers, roots and quotients.
"""

from __future__ import annotations

from collections.abc import Sequence

from softcat_sym.codegen.instructions import Code, Instruction

_BOOLEAN = frozenset({"LT", "LE", "EQ", "NE", "NOT", "AND", "OR"})
_OF_FIRST = frozenset({"DIV", "NEG", "TWICE", "SQ", "SQRT", "FABS", "ASSIGN"})
_OF_BOTH = frozenset({"ADD", "SUB", "FMAX"})
_CHEAP = _BOOLEAN | frozenset({"ADD", "SUB", "MUL", "NEG", "TWICE", "SQ", "FABS", "ASSIGN", "IF_ELSE_ZERO"})
_QUOTIENT, _CALL = 5, 20
"""Costs, over that of a sum."""
_WORTHWHILE = 12
"""Cost of what a branch is made for."""


def branches_of(code: Code, stages: Sequence[int], first: int) -> list[int | None]:
    """Number of the instruction that is the condition of each instruction; None where it is always executed.

    Parameters
    ----------
    code : Code
        What is computed.
    stages : sequence of int
        At which point of a loop each instruction is executed.
    first : int
        Earliest stage at which a branch is made.
    """
    vanishing = _vanishing(code.instructions)
    found: list[int | None] = [None] * len(code.instructions)
    kept: set[int] = set()  # Conditions, and what they are made of
    waiting = set().union(*vanishing)
    while waiting:
        free = [k for k, one in enumerate(found) if one is None and k not in kept and stages[k] >= first]
        choices = {one: _within(code, stages, free, one, vanishing) for one in sorted(waiting) if found[one] is None}
        cost = {condition: sum(_cost(code.instructions[k]) for k in inside) for condition, inside in choices.items()}
        best = max(cost, key=cost.__getitem__, default=0)
        if cost.get(best, 0) < _WORTHWHILE:
            break
        for k in choices[best]:
            found[k] = best
        waiting.discard(best)
        kept |= _ancestors(code.instructions, best)
    return found


def _within(
    code: Code, stages: Sequence[int], free: Sequence[int], condition: int, vanishing: Sequence[frozenset[int]]
) -> set[int]:
    """Those of the free instructions that the branch of a condition can take in."""
    inside: set[int] = set()
    results = set(code.results)
    for k in reversed(free):
        if k == condition or code.instructions[k].is_given or stages[k] < stages[condition]:
            continue
        only = k not in results and all(user in inside and stages[user] == stages[k] for user in code.users[k])
        if only or condition in vanishing[k]:
            inside.add(k)
    return inside


def _vanishing(instructions: Sequence[Instruction]) -> list[frozenset[int]]:
    """Conditions, any of which makes an instruction zero where it is zero itself."""
    found: list[frozenset[int]] = []
    number = {one: k for k, one in enumerate(instructions)}
    zero = number.get(Instruction("CONST", (), 0.0))
    for k, one in enumerate(instructions):
        of = [found[a] for a in one.operands]
        if one.operation in _BOOLEAN:
            made = frozenset({k})
        elif one.operation == "FMAX" and zero in one.arguments:
            other = one.arguments[one.arguments[0] == zero]
            # Its derivative asks whether it is positive: one condition for both.
            made = frozenset({number.get(Instruction("LE", (zero, other)), k)})
        elif one.operation == "IF_ELSE_ZERO":
            made = of[0] | of[1] | {one.arguments[0]}
        elif one.operation == "MUL":
            made = of[0] | of[1]
        elif one.operation in _OF_FIRST:
            made = of[0]
        elif one.operation in _OF_BOTH:
            made = of[0] & of[1]
        else:
            made = frozenset()
        found.append(made)
    return found


def _cost(one: Instruction) -> int:
    if one.operation in _CHEAP:
        return 1
    return _QUOTIENT if one.operation in ("DIV", "INV", "SQRT", "FMAX", "FMIN") else _CALL


def _ancestors(instructions: Sequence[Instruction], last: int) -> set[int]:
    """An instruction and all that it is made of."""
    found, waiting = set[int](), [last]
    while waiting:
        k = waiting.pop()
        if k not in found:
            found.add(k)
            waiting += instructions[k].operands
    return found
