"""``softcat explain``: expected regime, effects and cost of a scene, before it is run."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports

if TYPE_CHECKING:
    from softcat_sym.estimates.expected_regime import ExpectedRegime
    from softcat_sym.physics.equation import Stated

with lazy_imports():
    from rich import console as rich_console
    from rich import text as rich_text

    from softcat_sym import drawing, files
    from softcat_sym.plotting import terminal, units
    from softcat_sym.studies import explanation as study

Rows = list[tuple[str, ...]]


def explain(
    scene: cli.SceneArgument,
    output: Annotated[
        Path | None,
        cli.output_option(
            None, "Folder for explain.json, equations.tex and scene.toml; without it nothing is written."
        ),
    ] = None,
    changes: cli.SetOption = None,
    verbose: cli.VerboseOption = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Explain before a run what to expect, and which effects are on.

    The command prints the groups of the scene, its regime, each effect with the reason why it is in or out, the size of
    the problem and the limits of the theory; with -v the equations too.
    """
    if output is None:
        resolved = cli.scene_of(scene, changes)
    else:
        resolved, output = cli.scene_and_directory(scene, changes, output, "explain")
    explanation = study.explain(resolved)
    contents = {
        "explain.json": explanation.to_dict(),
        "equations.tex": article(explanation.title, explanation.in_force, explanation.equations),
        "scene.toml": resolved.to_toml(),
    }
    written = [] if output is None else files.write_results(output, contents)
    if not quiet:
        assumed = filter(None, [resolved.material.assumed])
        notes = [*(("converted", note) for note in resolved.notes), *(("assumed", note) for note in assumed)]
        print_explanation(explanation, notes=notes, verbose=verbose)
        if output is not None:
            cli.print_written(written, output)


_ESCAPED = str.maketrans(
    {letter: rf"\{letter}" for letter in "{}$&#_%"}
    | {"\\": r"\textbackslash{}", "~": r"\textasciitilde{}", "^": r"\textasciicircum{}"}
    | {letter: rf"\ensuremath{{{letter}}}" for letter in "<>"}
)

_HEAD = r"""\documentclass[a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage[margin=25mm]{geometry}
\usepackage{amsmath,amssymb}
\setlength{\parindent}{0pt}
\begin{document}
"""


def article(title: str, effects: Sequence[str], equations: Sequence[Stated]) -> str:
    """A LaTeX article of one section, with the effects in force, and each equation with its name and source."""
    lines = [
        _HEAD,
        rf"\section*{{{(title or 'Filament').translate(_ESCAPED)}}}",
        rf"Effects in force: {(', '.join(effects) or 'none').translate(_ESCAPED)}. "
        r"Angle brackets are means over the section, $\zeta = 2z/h$.",
        "",
    ]
    for equation in equations:
        lines += [
            rf"\textbf{{{equation.name.translate(_ESCAPED)}}} ({equation.source.translate(_ESCAPED)})",
            r"\begin{equation*}",
            equation.latex,
            r"\end{equation*}",
        ]
    return "\n".join([*lines, r"\end{document}", ""])


def print_explanation(
    explanation: study.Explanation,
    console: rich_console.Console | None = None,
    *,
    notes: Sequence[tuple[str, str]] = (),
    verbose: bool = False,
) -> None:
    """Print an explanation in short, with notes on the scene; with `verbose`, print all of it in tables."""
    out = console or rich_console.Console()
    out.print(rich_text.Text(explanation.title or "Filament", style="bold"))
    if not verbose:
        more = ("more", "-v for groups, equations, formulas and limits")
        terminal.print_rows([*_short_rows(explanation), *notes, more], out)
        return
    groups: Rows = [
        (group["name"], "infinite" if group["value"] is None else units.significant(group["value"]), group["meaning"])
        for group in explanation.groups
    ]
    effects: Rows = []
    for each in explanation.effects:
        estimate = "" if each["estimate"] is None else f"{units.significant(each['estimate'])}: {each['meaning']}"
        formula = f" [{each['formula']}]" if estimate and each["formula"] else ""
        effects.append((each["effect"], "on" if each["in_force"] else "off", each["reason"], estimate + formula))
    equations: Rows = [(equation.name, equation.text, equation.source) for equation in explanation.equations]
    accuracy = f"Effects; the requested accuracy is {units.significant(explanation.accuracy)}"
    tables: list[tuple[str, tuple[str, ...], Rows, int]] = [
        ("Groups", ("group", "value", "meaning"), groups, 1),
        ("Expected", ("", ""), _regime_rows(explanation), 1),
        (accuracy, ("effect", "", "why", "estimate and its meaning"), effects, 1),
        ("Equations in force", ("equation", "", "source"), equations, 0),
        ("Numerics", ("", ""), _numeric_rows(explanation), 1),
    ]
    for title, heads, rows, whole in tables:
        kinds = ["dim" if rows is effects and row[1] == "off" else "" for row in rows]
        out.print(drawing.TextTable(heads, rows, kinds=kinds, title=title, whole=range(whole)).for_terminal())
    for what, note in notes:
        out.print(rich_text.Text(f"{what}: {note}"))
    for warning in explanation.warnings:
        out.print(rich_text.Text(f"warning: {warning}", style="yellow"))


def _short_rows(explanation: study.Explanation) -> list[tuple[str, str]]:
    """The most important rows: expected behaviour, effects, cost, and limits of the theory."""
    graph, integrator = explanation.graph, explanation.integrator
    inside = [f"{each['effect']}: on, {each['reason']}" for each in explanation.effects if each["in_force"]]
    outside = [each for each in explanation.effects if not each["in_force"] and each["estimate"] is not None]
    worth = sum(each["estimate"] for each in outside)
    unknowns = graph["differential"] + graph["algebraic"]
    rows = [
        ("dimensions", f"{explanation.dimensions}, {explanation.dimensions_reason}"),
        ("expected", ", ".join(filter(None, [units.regime_words(explanation.regime.name), explanation.regime.near]))),
        ("because", explanation.regime.reason),
        ("sag", f"about {float(f'{100 * explanation.sag:.2g}'):g} % of the span"),
        ("effects", "\n".join(inside) or "none"),
        ("left out", terminal.left_out_words([each["effect"] for each in outside], worth) if outside else ""),
        ("solver", f"{integrator['solver']}, {integrator['backend']}; {graph['cells']} cells, {unknowns} unknowns"),
        ("damping", explanation.damping),
        ("cost", explanation.ringing),
        *(("warning", warning) for warning in explanation.warnings),
        ("longest span", _span_words(explanation.longest_span)),
    ]
    return [row for row in rows if row[1]]


def _span_words(span: float | None) -> str:
    return (
        "" if span is None else f"roughly {units.length_unit(span).text(span)} for a sag of 5 %; softcat span finds it"
    )


def _regime_rows(explanation: study.Explanation) -> Rows:
    """Regime with its reason, thresholds and stopping depths."""
    regime = explanation.regime
    sag, strain = units.significant(explanation.sag), units.significant(explanation.strain)
    thresholds = {
        "first yield": regime.first_yield,
        "plastic collapse of the beam": regime.collapse,
        "arrest, the paper's [3.12]": regime.arrest_paper,
        "arrest, exact": regime.arrest_exact,
    }
    depths = {"[3.13]": regime.stopping_depth_paper, "exact catenary": regime.stopping_depth_exact}
    listed = [f"{units.significant(value)} L ({name})" for name, value in depths.items() if value is not None]
    yields = regime.gravity_number is not None
    rows: Rows = [
        ("dimensions", f"{explanation.dimensions}, {explanation.dimensions_reason}"),
        ("regime", ", ".join(filter(None, [units.regime_words(regime.name), regime.near]))),
        ("because", regime.reason),
        ("largest sag", f"about {sag} of the span, a mean strain of {strain}"),
        ("damping", explanation.damping),
        ("cost", explanation.ringing),
        ("thresholds of G", "; ".join(f"{name} {G:.4g}" for name, G in thresholds.items() if yields and G is not None)),
        ("stopping depth", "; ".join([*listed, *_remarks(regime)]) if yields else ""),
    ]
    return [row for row in rows if row[1]]


def _remarks(regime: ExpectedRegime) -> Iterator[str]:
    """Remarks on the stopping depths."""
    if regime.stopping_depth_paper is None and regime.stopping_depth_exact is None:
        yield "none: nothing holds it" if regime.name == "descending" else "none: it has a free end, or no weight"
    elif regime.name == "no-yield":
        yield "not reached, since no fibre yields"
    elif (regime.gravity_number or 0.0) < (regime.collapse or 0.0):
        yield "the beam itself holds it"
    elif regime.overshoot and regime.stopping_depth_exact is not None:
        depth = units.significant(regime.overshoot * regime.stopping_depth_exact)
        yield f"first stop, after its fall, at about {depth} L"


def _numeric_rows(explanation: study.Explanation) -> Rows:
    """Unknowns, graph and integrator."""
    graph, integrator = explanation.graph, explanation.integrator
    over = "half the span, by symmetry" if graph["half"] else "the whole span"
    sizes = f"{graph['differential']} differential and {graph['algebraic']} algebraic unknowns"
    parameters = ", ".join(f"{name} {units.significant(value)}" for name, value in graph["parameters"].items())
    return [
        *(
            (
                "algebraic" if each["algebraic"] else "differential",
                f"{each['number']} {each['kind']}: {each['meaning']}",
            )
            for each in explanation.unknowns
        ),
        ("graph", f"{graph['cells']} cells over {over}; {sizes}, {graph['instructions']} instructions"),
        ("parameters", f"{parameters} (SI)"),
        ("integrator", f"{integrator['solver']}, rtol {units.significant(integrator['rtol'])}: {integrator['reason']}"),
        ("backend", integrator["backend"]),
        ("closure", f"{explanation.closure}; requested accuracy {units.significant(explanation.accuracy)}"),
    ]
