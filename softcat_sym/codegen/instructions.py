"""A CasADi expression as a list of instructions, in single assignment form."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from softcat_sym.errors import PrintingError

_NAMES = {getattr(ca, name): name for name in dir(ca) if name.startswith("OP_")}


@dataclass(frozen=True)
class Instruction:
    """One elementary operation.

    Attributes
    ----------
    operation : str
        CasADi's name without ``OP_``; ``INPUT`` and ``CONST`` for what is given.
    arguments : tuple of int
        Numbers of earlier instructions; of an input its number.
    value : float
        Of a constant.
    """

    operation: str
    arguments: tuple[int, ...]
    value: float = 0.0


@dataclass(frozen=True)
class Code:
    """Instructions, and which of them are the results.

    Attributes
    ----------
    instructions : tuple of Instruction
        In the order of evaluation.
    results : tuple of int
        Number of the instruction that gives each output; -1 for a zero.
    """

    instructions: tuple[Instruction, ...]
    results: tuple[int, ...]


def code_of(inputs: list[ca.SX], outputs: list[ca.SX]) -> Code:
    """Instructions that compute scalars from scalars, equal ones shared.

    Raises
    ------
    PrintingError
        If an output holds a symbol that is not among the inputs.
    """
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
