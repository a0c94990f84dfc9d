"""Instructions as C99: functions, files, and where everything lies in the arrays that they work on."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from enum import IntEnum

import casadi as ca

from softcat_sym.codegen.branches import branches_of
from softcat_sym.codegen.c_text import number
from softcat_sym.codegen.instructions import Code, Instruction, code_of, with_reciprocals
from softcat_sym.discretization.cell import Program
from softcat_sym.discretization.section_rule import POINT_TABLES
from softcat_sym.discretization.stencil import DERIVATIVE, FIBRE, PARAMETER, PLACE, STAGED, SUM, UNKNOWN, Leaf
from softcat_sym.discretization.unknowns import PER_FIBRE, SiteRange
from softcat_sym.errors import PrintingError

_LONGEST = 60
"""Of an expression that is written out where it is used, once."""

_INFIX = {"ADD": "+", "SUB": "-", "MUL": "*", "DIV": "/", "LT": "<", "LE": "<=", "EQ": "==", "NE": "!="}
_CALLS = {
    name.upper(): name
    for name in (
        *("exp", "log", "pow", "sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"),
        *("fabs", "copysign", "log1p", "expm1", "hypot"),
    )
} | {"CONSTPOW": "pow", "ATAN2": "angle_of", "FMIN": "smaller", "FMAX": "larger", "SIGN": "sign_of"}

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
    """What a result is assigned to."""

    text: str  # C text
    each: bool = False  # Whether there is one for each fibre
    adds: bool = False  # Whether the result is added to it
    zeroed: bool = False  # Whether it is zero before, so that a zero need not be assigned


def statements(
    code: Code, inputs: Sequence[str], known: Sequence[When], targets: Sequence[Target]
) -> dict[When, list[str]]:
    """Statements by when they are executed."""
    when = _when(code, known)
    stages = [
        _stage(target, when[result] if result >= 0 else When.BEFORE)
        for target, result in zip(targets, code.results, strict=True)
    ]
    lines = _Lines(code, inputs, when, list(zip(targets, stages, strict=True)))
    for stage in When:
        lines.write(stage)
    for target, stage, result in zip(targets, stages, code.results, strict=True):
        if not lines.is_within_branch(target, stage, result):
            lines.found[stage].append(lines.assignment(target, result))
    return lines.found


def _stage(target: Target, ready: When) -> When:
    """When a result is assigned."""
    if ready == (When.AFTER if target.each else When.FIBRE):
        raise PrintingError(f"{target.text} is computed when its fibres are not, or for each of them")
    return When.FIBRE if target.each else max(When.SITE, ready)


class _Lines:
    """Statements under way."""

    def __init__(
        self, code: Code, inputs: Sequence[str], when: Sequence[When], targets: Sequence[tuple[Target, When]]
    ) -> None:
        self._code, self._inputs, self._when = code, inputs, when
        self._branch = branches_of(code, when, When.SITE)
        self._conditions = set(self._branch)
        self._targets: list[list[tuple[Target, When]]] = [[] for _ in code.instructions]
        for target, result in zip(targets, code.results, strict=True):
            if result >= 0:
                self._targets[result].append(target)
        self._text: dict[int, str] = {}
        self.found: dict[When, list[str]] = {at: [] for at in When}

    def write(self, stage: When) -> None:
        """What is always executed as soon as it can be, and else one branch after the other."""
        waiting = [k for k, at in enumerate(self._when) if at == stage]
        while waiting:
            waiting = self._write_branch(waiting, None, stage)
            branch = next((self._branch[k] for k in waiting if self._is_ready(k)), None)
            if branch is not None:
                waiting = self._write_branch(waiting, branch, stage)

    def is_within_branch(self, target: Target, stage: When, result: int) -> bool:
        """Whether a result is assigned in a branch, as nothing else need be where that is not executed."""
        if result < 0 or self._branch[result] is None:
            return False
        return (target.adds or target.zeroed) and self._when[result] == stage

    def assignment(self, target: Target, result: int) -> str:
        """The statement that assigns a result."""
        return f"{target.text} {'+=' if target.adds else '='} {_bare(self._text[result]) if result >= 0 else '0.0'};"

    def _is_ready(self, k: int, written: Collection[int] = ()) -> bool:
        branch = self._branch[k]
        known = all(one in self._text or one in written for one in self._code.instructions[k].operands)
        return known and (branch is None or branch in self._text)

    def _write_branch(self, waiting: Sequence[int], branch: int | None, stage: When) -> list[int]:
        """Write the instructions of a branch, or those of none, as far as they can be; those that are left."""
        block: dict[int, None] = {}
        for k in waiting:
            if self._branch[k] == branch and self._is_ready(k, block):
                block[k] = None
        outside, inside = list[str](), list[str]()
        for k in block:
            self._write_instruction(k, block, outside, inside)
            for target, at in self._targets[k]:
                if self.is_within_branch(target, at, k):
                    inside.append(self.assignment(target, k))
        if branch is not None and inside:
            inside = [f"if ({self._text[branch]} != 0.0) {{", *(f"    {line}" for line in inside), "}"]
        self.found[stage] += outside + inside
        return [k for k in waiting if k not in block]

    def _write_instruction(self, k: int, block: Collection[int], outside: list[str], inside: list[str]) -> None:
        """Text of an instruction: where it is used, or else a name; of what is zero without a branch, outside of it."""
        one, stage = self._code.instructions[k], self._when[k]
        written = self._inputs[one.arguments[0]] if one.operation == "INPUT" else self._expression(k)
        plain, users = one.is_given, self._code.users[k]
        leaves = self._leaves(k, block)
        # What is known early is computed early, not where it is used.
        crosses = (stage == When.BEFORE and not plain) or (
            stage == When.SITE and any(self._when[user] == When.FIBRE for user in users)
        )
        named = k in self._conditions or leaves or crosses or len(users) + len(self._targets[k]) > 1
        if one.operation == "CONST" or not (named or (len(written) >= _LONGEST and not plain)):
            self._text[k] = written
            return
        self._text[k] = name = f"{'c' if stage == When.BEFORE else 'v'}{k}"
        if leaves:
            outside.append(f"double {name} = 0.0;")
        inside.append(f"{'' if leaves else 'const double '}{name} = {_bare(written)};")

    def _leaves(self, k: int, block: Collection[int]) -> bool:
        """Whether something outside of the block of statements of its branch uses it."""
        if self._branch[k] is None:
            return False
        used = any(user not in block for user in self._code.users[k])
        return used or not all(self.is_within_branch(*target, k) for target in self._targets[k])

    def _expression(self, k: int) -> str:
        one = self._code.instructions[k]
        args = [self._text[argument] for argument in one.arguments]
        if one.operation == "IF_ELSE_ZERO" and one.arguments[0] == self._branch[k]:
            return args[1]
        return _expression(one, args)


def _when(code: Code, known: Sequence[When]) -> list[When]:
    """When each instruction is executed."""
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


SIZES = {"fibres": "FIBRES", "slots": "SLOTS", "entries": "ENTRIES"}
"""Numbers that depend on how many fibres a section has, by the names of functions for them; what they are follows."""

TABLES = ("zeta", *POINT_TABLES)
"""Numbers of each fibre."""

_ARGUMENTS = (
    *((size, "int ") for size in SIZES),
    *((table, "const double *") for table in TABLES),
    ("t", "double "),
    ("p", "const double *"),
    ("g", "const double *"),
    ("y", "const double *"),
    ("w", "double *"),
    ("f", "double *"),
    ("e", "double *"),
    ("q", "double *"),
    ("s", "double *"),
    ("o", "double *"),
)


class Writer:
    """Functions of one C file, and where everything lies in its arrays."""

    def __init__(self, program: Program) -> None:
        self._leaves = program.leaves
        self._results = {item.name for items in (program.rates, *program.powers.values()) for item in items}
        self.slots = Row("slots", [slot.name for slot in program.slots])
        self._place = {name: k for k, name in enumerate(program.places)}
        self._parameter = {name: k for k, name in enumerate(program.parameters)}
        self._scratch: dict[str, int] = {}
        self._scratch_each: dict[str, int] = {}
        self.functions: list[str] = []
        self.moves_in_time = False

    @property
    def scratch(self) -> tuple[int, int]:
        """Doubles per site, and per site and fibre."""
        return len(self._scratch), len(self._scratch_each)

    def is_field(self, name: str) -> bool:
        """Whether it is a staged field, not a rate or a power."""
        return name not in self._results

    def field(self, name: str) -> Target:
        """A field at the site that is looked at."""
        return Target(self._stored(name, 0), each=PER_FIBRE in name)

    def _stored(self, name: str, site: int) -> str:
        if PER_FIBRE in name:
            number = self._scratch_each.setdefault(name, len(self._scratch_each))
            return f"each{number}[fibres * {f'(i {_signed(site)})' if site else 'i'} + k]"
        number = self._scratch.setdefault(name, len(self._scratch))
        return f"w{number}[i{f' {_signed(site)}' if site else ''}]"

    def leaf(self, leaf: Leaf) -> str:
        """C text of a leaf as seen from site i."""
        if leaf.kind == PARAMETER:
            return f"p[{self._parameter[leaf.name]}]"
        if leaf.kind == UNKNOWN:
            return f"y[{self.slots.at(leaf.name, leaf.site)}]"
        if leaf.kind == PLACE:
            return f"g[{at(len(self._place), leaf.site, self._place[leaf.name])}]"
        if leaf.kind in (STAGED, DERIVATIVE):
            return self._stored(leaf.name, leaf.site)
        if leaf.kind == FIBRE:
            return f"{leaf.name}[k]"
        if leaf.kind == SUM:
            return f"sum{leaf.name}"
        self.moves_in_time = True
        return "t"

    def function(self, name: str, where: SiteRange, values: Sequence[ca.SX], targets: Sequence[Target]) -> str:
        """Write a function that computes values at its sites; the call of it."""
        sums = [leaf for leaf in self._leaves.within(ca.vertcat(*values)) if leaf.kind == SUM]
        values = [*values, *(self._leaves.summed(leaf) for leaf in sums)]
        targets = [*targets, *(Target(self.leaf(leaf), each=True, adds=True, zeroed=True) for leaf in sums)]
        leaves = self._leaves.within(ca.vertcat(*values))
        plain = code_of([self._leaves.symbol(leaf) for leaf in leaves], list(values))
        code, leaves = with_reciprocals(plain, leaves)
        inputs = [self.leaf(leaf) for leaf in leaves]
        found = statements(code, inputs, [_known(leaf) for leaf in leaves], targets)
        within = found[When.SITE]
        if found[When.FIBRE]:
            within = [f"double {self.leaf(leaf)} = 0.0;" for leaf in sums] + within
            within += ["for (int k = 0; k < fibres; k++) {", *(f"    {one}" for one in found[When.FIBRE]), "}"]
        within = within + found[When.AFTER]
        before = found[When.BEFORE]
        body = "\n".join([*before, *within])
        rows = sorted({int(row) for row in re.findall(r"\beach(\d+)\[", body)})
        each = [
            f"    double *restrict each{row} = w + (SCRATCH{f' + {row} * fibres' if row else ''}) * n;" for row in rows
        ]
        whole = "\n".join([body, *each])
        letters = [(c, kind) for c, kind in _ARGUMENTS if re.search(rf"\b{c}\b", whole) or (c == "w" and _STORED(body))]
        lines = [f"static void {name}(int n{''.join(f', {kind}{c}' for c, kind in letters)})", "{"]
        rows = sorted({int(row) for row in re.findall(r"\bw(\d+)\[", body)})
        lines += [f"    double *restrict w{row} = w{f' + {row} * n' if row else ''};" for row in rows]
        lines += [*each, *(f"    {line}" for line in before)]
        if where.alone:
            site = where.first if where.first >= 0 else f"n - {-where.first}"
            lines += [f"    const int i = {site};"] if re.search(r"\bi\b", "\n".join(within)) else []
            lines += [f"    {line}" for line in within] + ["    (void)n;"]
        else:
            end = f"n - {where.behind}" if where.behind else "n"
            lines.append(f"    for (int i = {where.first}; i < {end}; i++) {{")
            lines += [f"        {line}" for line in within] + ["    }"]
        self.functions.append("\n".join([*lines, "}"]))
        return f"    {name}(n{''.join(f', {c}' for c, _ in letters)});"


_STORED = re.compile(r"\b(?:w|each)\d+\[").search


def _known(leaf: Leaf) -> When:
    if leaf.is_each:
        return When.FIBRE
    if leaf.kind == SUM:
        return When.AFTER
    return When.SITE if leaf.is_local else When.BEFORE


class Row:
    """Numbers of a site: those that it has once first, then those of its fibres, kind by kind."""

    def __init__(self, size: str, names: Sequence[str]) -> None:
        self.plain, self.each = ([n for n in names if (PER_FIBRE in n) is each] for each in (False, True))
        self._size = size

    @property
    def count(self) -> str:
        """How many there are."""
        return self._size if self.each else str(len(self.plain))

    def at(self, name: str, distance: int = 0) -> str:
        """Index of a number of the site at a distance from site i."""
        if not self.each:
            return at(len(self.plain), distance, self.plain.index(name))
        site = f"(i {_signed(distance)})" if distance else "i"
        if PER_FIBRE not in name:
            return f"{self._size} * {site} + {self.plain.index(name)}"
        kind = self.each.index(name)
        return f"{self._size} * {site} + {len(self.plain)}{f' + {kind} * fibres' if kind else ''} + k"


def _signed(distance: int) -> str:
    return f"{'+' if distance > 0 else '-'} {abs(distance)}"


def times(number: int, letter: str) -> str:
    """Beginning of the index of a row of numbers: so many times as long as the letter says."""
    return {0: "", 1: f"{letter} + "}.get(number, f"{number} * {letter} + ")


def at(size: int, distance: int, number: int) -> str:
    """Index of a number of a site at a distance from site i."""
    shift = size * distance + number
    return f"{size} * i{f' {_signed(shift)}' if shift else ''}"
