"""Expressions as C functions of one array, compiled and called."""

from __future__ import annotations

import ctypes as c
from collections.abc import Sequence

import casadi as ca
import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.c_printer import Target, When, helpers_of, statements
from softcat_sym.codegen.library import compile_library, load
from softcat_sym.codegen.recording import Code, code_of

STRICT = ("-O2", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Wno-unused-function")
Floats = npt.NDArray[np.float64]


def text_of(code: Code, inputs: int, uniform: Sequence[bool] = ()) -> str:
    """A C file with `void f(int n, const double *x, double *y)`: rows of x to rows of y, as a model has them."""
    same = list(uniform) or [False] * inputs
    given = [f"x[{k}]" if same[k] else f"x[{inputs} * i + {k}]" for k in range(inputs)]
    outputs = len(code.results)
    known = [When.BEFORE if one else When.SITE for one in same]
    found = statements(code, given, known, [Target(f"y[{outputs} * i + {k}]") for k in range(outputs)])
    lines = [*found[When.BEFORE], "for (int i = 0; i < n; i++) {", *found[When.SITE], "}"]
    body = "\n    ".join(lines)
    head = f"#include <math.h>\n{helpers_of(body)}\nvoid f(int n, const double *x, double *y)"
    return f"{head}\n{{\n    (void)x;\n    {body}\n}}\n"


def values(text: str, x: Floats, outputs: int) -> Floats:
    """What the C makes of rows of x, shape (rows, outputs)."""
    library = load(compile_library({"snippet.c": text}, flags=STRICT))
    given, found = np.ascontiguousarray(x, dtype=float), np.full((len(x), outputs), np.nan)
    pointers = (array.ctypes.data_as(c.POINTER(c.c_double)) for array in (given, found))
    library.f(len(x), *pointers)
    return found


def evaluated(symbols: Sequence[ca.SX], expressions: Sequence[ca.SX], x: Floats) -> Floats:
    """What CasADi makes of them."""
    function = ca.Function("f", [ca.vertcat(*symbols)], [ca.vertcat(*expressions)])
    return np.array([np.asarray(function(row)).ravel() for row in x])


def compiled(symbols: Sequence[ca.SX], expressions: Sequence[ca.SX], x: Floats) -> Floats:
    """What C makes of them."""
    code = code_of(list(symbols), list(expressions))
    return values(text_of(code, len(symbols)), x, len(expressions))
