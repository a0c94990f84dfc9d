"""The C text of a filament for many at once: vectors whose lanes are one filament each, in place of doubles."""

from __future__ import annotations

import re
from importlib import resources

from softcat_sym.errors import PrintingError

SYMBOL = "softcat_filament_lanes"
"""Name of the softcat_lanes_model in the text."""

_HELPERS = re.compile(r"^(?:/\*.*\*/\n)?static inline double \w+\(.*\n", re.MULTILINE)
_TABLE = re.compile(r"static const double fibre_(\w+)\[\]")
_NUMBER = re.compile(r" = (\(?-?(?:HUGE_VAL|\d+\.\d+(?:e[-+]?\d+)?|\d+e[-+]?\d+)\)?);")
_MODEL = re.compile(r"^const softcat_model softcat_filament_model = \{(.*?)^\};", re.MULTILINE | re.DOTALL)
_FUNCTIONS = re.compile(r"^    (rates, jacobian, .*),$", re.MULTILINE)
_BRANCH = re.compile(r"^( +)if \((\w+) != 0\.0\) \{\n(.*?)^\1\}\n", re.MULTILINE | re.DOTALL)
_ASSIGNED = re.compile(r"^( +(?!const )[^=]*=) (.*);$", re.MULTILINE)
_ASKS, _ELSE = " != 0.0 ? ", " : 0.0"


def lanes_text(text: str) -> str:
    """The lanes of a model's C text: the same expressions, of vectors.

    C knows no vectors in conditions, in casts of comparisons and where a number is assigned: these become calls of what
    softcat_lanes_math.h defines.
    """
    body, tables, model = _parts(_HELPERS.sub("", text))
    body = body.replace("#include <math.h>\n\n", "")
    body = body.replace('#include "softcat_model.h"', '#include "softcat_lanes_math.h"')
    names = _TABLE.findall(body)
    body = _BRANCH.sub(_branch_of_any, body)
    body = _without_conditions(body.replace("(double)", "truth").replace(" && ", " & ").replace(" || ", " | "))
    body = re.sub(r"\bdouble\b", "real", body.replace("const softcat_filament *", "const softcat_lanes_filament *"))
    body = _NUMBER.sub(r" = REAL(\1);", body)
    for name in names:
        body = re.sub(rf"\bconst real (\*?{name}\b)", r"const double \1", body)
        body = body.replace(f"static const real fibre_{name}[]", f"static const double fibre_{name}[]")
        body = body.replace(f"{name}[k]", f"REAL({name}[k])")
    functions = _FUNCTIONS.search(model)
    if functions is None:
        raise PrintingError("the C text of a filament has no table of functions where its lanes look for it")
    one = f"static const softcat_model one = {{{_FUNCTIONS.sub('    0, 0, 0, 0,', model)}}};"
    lanes = f"const softcat_lanes_model {SYMBOL} = {{\n    &one, LANES, {functions[1]},\n}};\n"
    return "\n".join([body, tables, one, "", lanes])


def _branch_of_any(found: re.Match[str]) -> str:
    """A branch that is executed where any lane asks for it: the others assign nothing, or zero."""
    indent, condition, lines = found.groups()
    first = f"{indent}if (lanes_any((lanes_mask)({condition} != 0.0))) {{\n"
    return first + _ASSIGNED.sub(rf"\1 where({condition}, \2);", lines) + f"{indent}}}\n"


def _parts(text: str) -> tuple[str, str, str]:
    """Functions, tables of the pattern, and what the model is initialised with."""
    found, begin = _MODEL.search(text), text.find("static const int rate[]")
    if found is None or begin < 0:
        raise PrintingError("the C text of a filament has no model where its lanes look for it")
    return text[:begin], text[begin : found.start()], found[1]


def _without_conditions(text: str) -> str:
    """``a != 0.0 ? b : 0.0`` becomes ``where(a, b)``."""
    while (asks := text.find(_ASKS)) >= 0:
        begin, depth = asks, 0
        while depth >= 0 and not (depth == 0 and text[begin - 2 : begin] in ("= ", ", ")):
            begin -= 1
            depth += {")": 1, "(": -1}.get(text[begin], 0)
        begin += depth < 0
        end, depth = asks + len(_ASKS), 0
        while depth > 0 or not text.startswith(_ELSE, end):
            depth += {"(": 1, ")": -1}.get(text[end], 0)
            end += 1
        call = f"where({text[begin:asks]}, {text[asks + len(_ASKS) : end]})"
        text = text[:begin] + call + text[end + len(_ELSE) :]
    return text


def lanes_sources() -> dict[str, str]:
    """The C files of the lanes by name, beside which those of the runtime are compiled."""
    folder = resources.files("softcat_sym.codegen") / "lanes"
    files = sorted(folder.iterdir(), key=str)
    return {file.name: file.read_text(encoding="utf-8") for file in files if file.name[-2:] in (".c", ".h")}
