"""Equations as a LaTeX article that compiles by itself."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from softcat_sym.equations.written import Stated

_ESCAPED = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "_": r"\_",
    "%": r"\%",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\ensuremath{<}",
    ">": r"\ensuremath{>}",
}

_HEAD = r"""\documentclass[a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage[margin=25mm]{geometry}
\usepackage{amsmath,amssymb}
\setlength{\parindent}{0pt}
\begin{document}
"""


def article(title: str, effects: Sequence[str], equations: Sequence[Stated]) -> str:
    """An article of one section: the effects in force, and each equation with its name and source.

    Parameters
    ----------
    title : str
        Of the scene; any text.
    effects : sequence of str
        In force.
    equations : sequence of Stated
        In their order.
    """
    lines = [
        _HEAD,
        rf"\section*{{{escaped(title or 'Filament')}}}",
        rf"Effects in force: {escaped(', '.join(effects) or 'none')}. "
        r"Angle brackets are means over the section, $\zeta = 2z/h$.",
        "",
    ]
    for equation in equations:
        lines += [
            rf"\textbf{{{escaped(equation.name)}}} ({escaped(equation.source)})",
            r"\begin{equation*}",
            equation.latex,
            r"\end{equation*}",
        ]
    return "\n".join([*lines, r"\end{document}", ""])


def escaped(text: str) -> str:
    """Text in which nothing is a command of LaTeX."""
    return "".join(_ESCAPED.get(letter, letter) for letter in text)
