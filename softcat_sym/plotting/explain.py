"""An explanation in the terminal and on disk, with its equations as a LaTeX article."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.plotting.files import write_results
from softcat_sym.plotting.terminal import left_out_words, print_rows, text_table
from softcat_sym.plotting.units import regime_words, significant

if TYPE_CHECKING:
    from rich.console import Console

    from softcat_sym.physics.equation import Stated
    from softcat_sym.scene.scene import Scene
    from softcat_sym.studies.explanation import Decided, Explanation

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
    """An article of one section: the effects in force, and each equation with its name and source."""
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


Rows = list[tuple[str, ...]]


def print_explanation(explanation: Explanation, console: Console | None = None, *, verbose: bool = False) -> None:
    """Print what a scene calls for."""
    from rich.console import Console
    from rich.text import Text

    out = console or Console()
    out.print(Text(explanation.title or "Filament", style="bold"))
    if verbose:
        _print_tables(explanation, out)
    else:
        print_rows(short_rows(explanation), out)


def short_rows(explanation: Explanation) -> list[tuple[str, str]]:
    """What a user asks first: what it will do, which physics that takes, what it costs, and where the theory ends."""
    regime, graph, integrator = explanation.regime, explanation.graph, explanation.integrator
    inside = [one for one in explanation.effects if one.in_force]
    outside = {one.effect: one.estimate for one in explanation.effects if not one.in_force and one.estimate is not None}
    rows = [
        ("expected", regime_words(regime.name)),
        ("because", regime.reason),
        ("sag", f"about {float(f'{100 * explanation.sag:.2g}'):g} % of the span"),
        ("effects", "\n".join(f"{one.effect}: on, {one.reason}" for one in inside) or "none"),
    ]
    if outside:
        rows.append(("left out", left_out_words(list(outside), sum(outside.values()))))
    unknowns = graph.differential + graph.algebraic
    rows.append(("solver", f"{integrator.solver}, {integrator.backend}; {graph.cells} cells, {unknowns} unknowns"))
    rows += [(name, text) for name, text in (("damping", explanation.damping), ("cost", explanation.ringing)) if text]
    rows += [("warning", warning) for warning in explanation.warnings]
    return [*rows, ("more", "-v for groups, equations, formulas and limits")]


def _print_tables(explanation: Explanation, out: Console) -> None:
    from rich.text import Text

    for title, heads, rows in (
        ("Groups", ("group", "value", "meaning"), group_rows(explanation)),
        ("Expected", (), regime_rows(explanation)),
        (
            f"Effects; the accuracy asked is {significant(explanation.accuracy)}",
            ("effect", "", "why", "what the estimate is"),
            effect_rows(explanation),
        ),
        ("Equations in force", ("equation", "", "source"), equation_rows(explanation)),
        ("Numerics", (), numeric_rows(explanation)),
    ):
        styles = ["dim" if title.startswith("Effects") and row[1] == "off" else "" for row in rows]
        header = heads or ("",) * len(rows[0])
        first = 0 if title == "Equations in force" else 1
        out.print(text_table(header, rows, title=title, styles=styles, title_style="none", whole=range(first)))
    for warning in explanation.warnings:
        out.print(Text(f"warning: {warning}", style="yellow"))


def group_rows(explanation: Explanation) -> Rows:
    """Name, value and meaning of each group."""
    return [(g.name, "infinite" if g.value is None else significant(g.value), g.meaning) for g in explanation.groups]


def regime_rows(explanation: Explanation) -> Rows:
    """Regime, why, stopping depth and the thresholds that decide."""
    regime = explanation.regime
    rows: Rows = [("regime", regime_words(regime.name)), ("because", regime.reason)]
    rows.append(
        (
            "largest sag",
            f"about {significant(explanation.sag)} of the span, a mean strain of {significant(explanation.strain)}",
        )
    )
    rows += [
        (name, text) for name, text in (("damping", explanation.damping), ("ringing", explanation.ringing)) if text
    ]
    if regime.gravity_number is None:
        return rows
    thresholds = (
        ("first yield", regime.first_yield), ("plastic collapse of the beam", regime.collapse),
        ("arrest, the paper's [3.12]", regime.arrest_paper), ("arrest, exact", regime.arrest_exact),
    )  # fmt: skip
    rows.append(("thresholds of G", "; ".join(f"{n} {v:.4g}" for n, v in thresholds if v is not None)))
    rows.append(("stopping depth", _depths(explanation)))
    return rows


def _depths(explanation: Explanation) -> str:
    regime = explanation.regime
    paper, exact = regime.stopping_depth_paper, regime.stopping_depth_exact
    if paper is None and exact is None:
        return "none: nothing holds it" if regime.name == "descending" else "none: it has a free end, or no weight"
    told = [f"{significant(v)} L ({n})" for v, n in ((paper, "[3.13]"), (exact, "exact catenary")) if v is not None]
    if regime.name == "no-yield":
        return "; ".join(told) + "; not called on, since no fibre yields"
    stops = regime.overshoot
    beam_alone = (regime.gravity_number or 0.0) < (regime.collapse or 0.0)
    if stops and not beam_alone and exact is not None:
        told.append(f"first stop, after its fall, at about {significant(stops * exact)} L")
    elif beam_alone:
        told.append("the beam itself holds it")
    return "; ".join(told)


def effect_rows(explanation: Explanation) -> Rows:
    """Each effect, whether it is on, why, and what its estimate is."""
    return [
        (
            decided.effect,
            "on" if decided.in_force else "off",
            decided.reason,
            "" if decided.estimate is None else f"{significant(decided.estimate)}: {_in_full(decided)}",
        )
        for decided in explanation.effects
    ]


def _in_full(decided: Decided) -> str:
    return f"{decided.meaning} [{decided.formula}]" if decided.formula else decided.meaning


def equation_rows(explanation: Explanation) -> Rows:
    """Name, text and source of each equation."""
    return [(equation.name, equation.text, equation.source) for equation in explanation.equations]


def numeric_rows(explanation: Explanation) -> Rows:
    """Unknowns, graph and integrator."""
    graph, integrator = explanation.graph, explanation.integrator
    rows: Rows = [
        ("algebraic" if unknown.algebraic else "differential", f"{unknown.number} {unknown.kind}: {unknown.meaning}")
        for unknown in explanation.unknowns
    ]
    over = "half the span, by symmetry" if graph.half else "the whole span"
    rows.append(
        (
            "graph",
            f"{graph.cells} cells over {over}; {graph.differential} differential and {graph.algebraic} "
            f"algebraic unknowns, {graph.instructions} instructions",
        )
    )
    rows.append(("parameters", ", ".join(f"{name} {significant(value)}" for name, value in graph.parameters) + " (SI)"))
    rows.append(("integrator", f"{integrator.solver}, rtol {significant(integrator.rtol)}: {integrator.reason}"))
    rows.append(("backend", integrator.backend))
    rows.append(("closure", f"{explanation.closure}; accuracy asked {significant(explanation.accuracy)}"))
    return rows


def write_explanation(explanation: Explanation, scene: Scene, directory: str | Path) -> list[Path]:
    """Write ``explain.json``, ``equations.tex`` and ``scene.toml``, each whole or not at all."""
    contents = {
        "explain.json": explanation.as_dict(),
        "equations.tex": article(explanation.title, explanation.in_force, explanation.equations),
        "scene.toml": scene.to_toml(),
    }
    return write_results(directory, contents)
