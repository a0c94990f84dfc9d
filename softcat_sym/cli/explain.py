"""``softcat explain``: expected regime, effects and cost of a scene, before it is run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports

if TYPE_CHECKING:
    from softcat_sym.physics.equation import Stated

with lazy_imports():
    from rich import console as rich_console
    from rich import text as rich_text

    from softcat_sym import drawing, files
    from softcat_sym.plotting import terminal, units
    from softcat_sym.studies import explanation as study


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
    """Print an explanation in short, with notes on the scene; with `verbose`, all of it, with tables."""
    out = console or rich_console.Console()
    out.print(rich_text.Text(explanation.title or "Filament", style="bold"))
    rows = [*_rows(explanation), *(_more_rows(explanation) if verbose else ()), *notes]
    more = () if verbose else (("more", "-v for groups, equations, formulas and limits"),)
    terminal.print_rows([row for row in (*rows, *more) if row[1]], out)
    for table in _tables(explanation) if verbose else ():
        out.print(table.for_terminal())


def _rows(explanation: study.Explanation) -> list[tuple[str, str]]:
    """The most important: expected behaviour, effects, cost, and limits of the theory."""
    graph, integrator, span = explanation.graph, explanation.integrator, explanation.longest_span
    inside = [f"{each['effect']}: on, {each['reason']}" for each in explanation.effects if each["in_force"]]
    outside = [each for each in explanation.effects if not each["in_force"] and each["estimate"] is not None]
    worth, unknowns = sum(each["estimate"] for each in outside), graph["differential"] + graph["algebraic"]
    longest = "" if span is None else units.length_unit(span).text(span)
    return [
        ("dimensions", f"{explanation.dimensions}, {explanation.dimensions_reason}"),
        ("expected", ", ".join(filter(None, [units.regime_words(explanation.regime.name), explanation.regime.near]))),
        ("because", explanation.regime.reason),
        ("sag", f"about {float(f'{100 * explanation.sag:.2g}'):g} % of the span"),
        ("effects", "\n".join(inside) or "none"),
        ("left out", terminal.left_out_words([each["effect"] for each in outside], worth) if outside else ""),
        ("solver", f"{integrator['solver']}, {integrator['backend']}; {graph['cells']} cells, {unknowns} unknowns"),
        ("damping", explanation.damping),
        ("cost", explanation.ringing),
        ("moving nozzle", explanation.laying),
        *(("warning", warning) for warning in explanation.warnings),
        ("longest span", longest and f"roughly {longest} for a sag of 5 %; softcat span finds it"),
    ]


def _more_rows(explanation: study.Explanation) -> list[tuple[str, str]]:
    """Thresholds and stopping depths of the regime, unknowns, graph and integrator."""
    regime, graph, integrator = explanation.regime, explanation.graph, explanation.integrator
    thresholds = {
        "first yield": regime.first_yield,
        "plastic collapse of the beam": regime.collapse,
        "arrest, the paper's [3.12]": regime.arrest_paper,
        "arrest, exact": regime.arrest_exact,
    }
    depths = {"[3.13]": regime.stopping_depth_paper, "exact catenary": regime.stopping_depth_exact}
    over = "half the span, by symmetry" if graph["half"] else "the whole span"
    sizes = f"{graph['differential']} differential and {graph['algebraic']} algebraic unknowns"
    parameters = ", ".join(f"{name} {units.significant(value)}" for name, value in graph["parameters"].items())
    return [
        ("mean strain", units.significant(explanation.strain)),
        ("thresholds of G", _listed(thresholds, "{name} {value:.4g}")),
        ("stopping depth", _listed(depths, "{value:.3g} L ({name})")),
        *(("unknown", f"{each['number']} {each['kind']}: {each['meaning']}") for each in explanation.unknowns),
        ("graph", f"{graph['cells']} cells over {over}; {sizes}, {graph['instructions']} instructions"),
        ("parameters", f"{parameters} (SI)"),
        ("tolerance", f"{units.significant(integrator['rtol'])}: {integrator['reason']}"),
        ("closure", f"{explanation.closure}; requested accuracy {units.significant(explanation.accuracy)}"),
    ]


def _listed(values: Mapping[str, float | None], form: str) -> str:
    return "; ".join(form.format(name=name, value=value) for name, value in values.items() if value is not None)


def _tables(explanation: study.Explanation) -> Iterator[drawing.TextTable]:
    """Groups, effects with their estimates, and the equations in force."""
    groups = [
        (group["name"], "infinite" if group["value"] is None else units.significant(group["value"]), group["meaning"])
        for group in explanation.groups
    ]
    yield drawing.TextTable(("group", "value", "meaning"), groups, title="Groups", whole=[0])
    effects = []
    for each in explanation.effects:
        estimate = "" if each["estimate"] is None else f"{units.significant(each['estimate'])}: {each['meaning']}"
        formula = f" [{each['formula']}]" if estimate and each["formula"] else ""
        effects.append((each["effect"], "on" if each["in_force"] else "off", each["reason"], estimate + formula))
    heads, looks = ("effect", "", "why", "estimate and its meaning"), {"on": "", "off": "dim"}
    kinds = [looks[row[1]] for row in effects]
    yield drawing.TextTable(heads, effects, kinds=kinds, title="Effects", whole=[0])
    equations = [(equation.name, equation.text, equation.source) for equation in explanation.equations]
    yield drawing.TextTable(("equation", "", "source"), equations, title="Equations in force")
