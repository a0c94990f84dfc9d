"""CasADi expressions as instructions, one operation each."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca

from softcat_sym.discretization.stencil import PLACE, Leaf
from softcat_sym.discretization.unknowns import INVERTED, PER
from softcat_sym.errors import PrintingError

_NAMES = {getattr(ca, name): name for name in dir(ca) if name.startswith("OP_")}


@dataclass(frozen=True)
class Instruction:
    """One elementary operation."""

    operation: str  # CasADi's name without ``OP_``; ``INPUT`` and ``CONST`` for what is given
    arguments: tuple[int, ...]  # Numbers of earlier instructions; of an input its number
    value: float = 0.0  # Of a constant

    @property
    def is_given(self) -> bool:
        """Whether it is an input or a constant."""
        return self.operation in ("INPUT", "CONST")

    @property
    def operands(self) -> tuple[int, ...]:
        """Numbers of the instructions that it is made of."""
        return () if self.is_given else self.arguments


@dataclass(frozen=True)
class Code:
    """Instructions, and which of them are the results."""

    instructions: tuple[Instruction, ...]  # In the order of evaluation
    results: tuple[int, ...]  # Number of the instruction that gives each output; -1 for a zero

    @cached_property
    def users(self) -> list[list[int]]:
        """Instructions that each instruction is an argument of."""
        found: list[list[int]] = [[] for _ in self.instructions]
        for k, one in enumerate(self.instructions):
            for argument in one.operands:
                found[argument].append(k)
        return found


def code_of(inputs: list[ca.SX], outputs: list[ca.SX]) -> Code:
    """Instructions that compute scalars from scalars, equal ones shared."""
    shared = ca.cse([ca.densify(ca.SX(output)) for output in outputs])
    try:
        function = ca.Function("code", [ca.vertcat(*inputs)], [ca.vertcat(*shared)])
    except RuntimeError as error:
        raise PrintingError(f"an expression of the generated code has a symbol that is no input: {error}") from error
    found: list[Instruction] = []
    at: dict[int, int] = {}
    known: dict[Instruction, int] = {}
    results = [-1] * len(outputs)

    def add(instruction: Instruction) -> int:
        if instruction not in known:
            known[instruction] = len(found)
            found.append(instruction)
        return known[instruction]

    for k in range(function.n_instructions()):
        name = _NAMES[function.instruction_id(k)].removeprefix("OP_")
        read, written = function.instruction_input(k), function.instruction_output(k)
        if name == "OUTPUT":
            results[written[1]] = at[read[0]]
        elif name == "INPUT":
            at[written[0]] = add(Instruction("INPUT", (read[1],)))
        elif name == "CONST":
            at[written[0]] = add(Instruction("CONST", (), float(function.instruction_constant(k))))
        else:
            at[written[0]] = add(Instruction(name, tuple(at[place] for place in read)))
    return Code(tuple(found), tuple(results))


def with_reciprocals(code: Code, leaves: Sequence[Leaf]) -> tuple[Code, list[Leaf]]:
    """The same results with fewer divisions, and what they are made of."""
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
