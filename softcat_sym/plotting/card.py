"""The sag card: words, picture, a page that prints on A4, and all its files."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import cycle, pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from rich.console import Console, RenderableType
from rich.table import Table
from rich.text import Text

from softcat_sym import drawing
from softcat_sym.drawing import Report, TextTable
from softcat_sym.effects.selection import choose_effects
from softcat_sym.estimates.expected_regime import expected_regime
from softcat_sym.estimates.forecast import expected_sag
from softcat_sym.estimates.scaling import yield_stress_of
from softcat_sym.plotting import style
from softcat_sym.plotting.run import Shape, Sheet, draw_shape, shapes_of
from softcat_sym.plotting.section import Magnification, array, largest_sag, quads_outside, yielding_of
from softcat_sym.plotting.style import styled, titled_figure
from softcat_sym.plotting.units import REGIMES, length_unit, regime_words, significant, stress_unit, time_unit
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.run_cost import run_cost
from softcat_sym.studies.card import CAUSES, SPAN, Card
from softcat_sym.studies.card_rules import Rule, elastic_sags, percent, smay_modulus_needed, unusual

_RULES = ("rule", "predicts", "solver", "error", "what makes it fail")
_NUMBERS = (1, 2, 3)
"""Columns of the table of rules that are numbers."""

_STRONGEST, _NEGLIGIBLE = 5, 5e-3
_INCOMPRESSIBLE = 3.0


def _length(value: float, span: float = 1.0) -> str:
    """A length in the unit of its size; of one that is zero, of a span."""
    return length_unit(abs(value), span).text(value)


def verdict(card: Card) -> tuple[bool, str]:
    """Whether the card may be trusted, and one sentence that stands on top of it."""
    outcome = card.run.outcome
    if card.pending and outcome.is_success:
        return False, card.incomplete
    if outcome is Outcome.broken:
        return True, f"It breaks: {card.summary['message'].removeprefix('it breaks ')}."
    if not outcome.is_success:
        reasons = "; ".join(filter(None, [str(card.summary.get("message") or ""), outcome.value]))
        return False, f"Not to be trusted: {outcome.name}; {reasons}"
    words = REGIMES.get(card.regime, card.regime)
    return True, f"{words[:1].upper()}{words[1:]}."


def facts(card: Card) -> list[tuple[str, str]]:
    """Name and text of every fact, in the order of reading."""
    rows = list(_descent(card))
    proof = card.certificate
    if proof is not None:
        limits, numbers = "", (proof["gravity_number"], proof["first_yield"], proof["threshold"])
        if None not in numbers:
            limits = "G = {:.3g}; yields from {:.3g}, no catenary rests above {:.4g}; ".format(*numbers)
        rows.append(("arrest", limits + proof["text"]))
    if SPAN not in card.pending:
        rows.append(("longest span", f"none found: {card.span_text}"))
    if card.span is not None:
        sags = f"{_length(card.span.span)} sags {_length(card.span.sag)} (limit {card.limit})"
        sags += ", and a longer one breaks" if card.span.breaks else ""
        powers = ", ".join(f"{name}^{power:.2g}" for name, power in exponents(card)[:_STRONGEST])
        rows[-1:] = [
            ("longest span", sags),
            *([] if card.span.breaks else [("it grows as", powers or "nothing that is known here")]),
        ]
    rows += _of_surface(card)
    modulus = card.scene.material.youngs_modulus
    if modulus is not None and not unusual(card.scene):
        needed, own = smay_modulus_needed(card.scene), modulus / _INCOMPRESSIBLE
        unit, meets = stress_unit(max(needed, own)), "meets" if own >= needed else "misses"
        text = f"{meets} it: G' = {unit.text(own)}, asked for {unit.text(needed)} (0.05 D, pins)"
        rows.append(("Smay's criterion", text))
    rows += [("note", text) for text in card.notes]
    rows += [("warning", str(text)) for text in card.summary.get("warnings") or ()]
    return rows


def _of_surface(card: Card) -> Iterator[tuple[str, str]]:
    """What surface tension holds, and the span that it adds."""
    hold, limit = card.surface, yield_stress_of(card.scene)
    if hold is None:
        return
    pull = stress_unit(hold.pull).text(hold.pull)
    if limit:
        unit = stress_unit(limit)
        read = unit.text(limit + hold.pull)
        pull += f" beside a yield stress of {unit.text(limit)} ({read} together, read from an arrested sag)"
    carried = "" if hold.share is None else f", carries {100 * hold.share:.2g} % of the weight"
    bare = f"no answer ({hold.outcome_without})" if hold.sag_without is None else _length(hold.sag_without)
    yield "surface tension", f"pulls with {pull}{carried}; sag without it {bare}"
    if hold.span_text and hold.span_text != card.span_text:
        yield "span without it", f"none found: {hold.span_text}"
    elif hold.span_without is not None:
        added = "" if hold.span_added is None else f": it adds {_length(hold.span_added)}"
        yield "span without it", _length(hold.span_without) + added


def _descent(card: Card) -> Iterator[tuple[str, str]]:
    """The regime, and how far and how fast it sags."""
    descent, filament = card.descent, card.scene.filament
    if descent is None:
        yield from [("regime", card.regime)] if card.regime else []
        return
    if card.regime:
        back = f"comes back up by {percent(descent.rise)[1:]}" if descent.rise >= 1e-3 else "never comes back up"
        yield "regime", f"{card.regime}; {descent.damping} ({back})"
    final, clock = descent.final, time_unit(card.scene.run.duration)
    error = "" if card.error_estimate is None else f" ± {100 * card.error_estimate:.2g} %"
    shares = f"{100 * final / filament.span:.3g} % of the span, {final / filament.thickness:.3g} thicknesses"
    yield "final sag", f"{_length(final, filament.span)}{error} = {shares}"
    rest = "still moving when the run ends"
    if descent.settled is not None:
        rest = f"within 1 % from {clock.text(descent.settled)} on"
    reached = "" if descent.to_90 is None else f"90 % of it after {clock.text(descent.to_90)}; "
    yield "when", f"{reached}{rest}"
    yield "largest stretch", f"{descent.stretch:.4g} at X/L = {significant(descent.stretch_at)}"


def exponents(card: Card) -> list[tuple[str, float]]:
    """Parameter and d ln span/d ln parameter, the strongest first; without those that make no difference."""
    powers = [
        (path.rpartition(".")[2].replace("_", " ").replace("youngs", "Young's"), power)
        for path, power in (card.span.gradient if card.span else {}).items()
        if math.isfinite(power) and abs(power) > _NEGLIGIBLE
    ]
    return sorted(powers, key=lambda pair: -abs(pair[1]))


def rule_texts(rule: Rule) -> tuple[str, str, str, str, str]:
    """Cells of one row of the table of rules."""
    if rule.predicted is None:
        return rule.name, "", "", "", rule.text
    unit = length_unit if rule.unit == "m" else stress_unit
    predicted, solver = (unit(abs(value)).text(value) for value in (rule.predicted, rule.solver))
    error = "" if rule.error is None else percent(rule.error)
    return f"{rule.name} {rule.source}", predicted, solver, error, rule.text


_ROWS = {2: ("<18", "<"), 5: ("<24", ">9", ">9", ">9", "<")}
"""Formats of the cells of a row, by their number, so that rows printed one by one stand below each other."""


def row_of(*cells: str, look: str = "") -> Table:
    """A row for a terminal: a label and a text, or a rule."""
    row = [format(cell, form) for cell, form in zip(cells, _ROWS[len(cells)], strict=True)]
    return TextTable([""] * len(row), [row], kinds=[look], whole=range(len(row) - 1)).for_terminal()


def lines(card: Card) -> dict[str, RenderableType]:
    """What a terminal shows of a card, line by line, of what is known; the key of a line is its words."""
    sound, sentence = verdict(replace(card, pending=()))
    found: dict[str, RenderableType] = {sentence: Text(sentence, style="bold green" if sound else "bold red")}
    for label, text in facts(card):
        if label != "note":
            found[f"{label} {text}"] = row_of(label, text, look="yellow" if label == "warning" else "")
    idle, rows = dict[str, list[str]](), [_RULES]
    for rule in card.rules:
        if rule.predicted is None:
            idle.setdefault(rule.text, []).append(rule.name)
        elif rule.text or CAUSES not in card.pending:
            rows.append((rule.name, *rule_texts(rule)[1:]))
    for row in rows if rows[1:] else []:
        look = "bold" if row is _RULES else "green" if row[-1] == "holds" else ""
        found[" ".join(row)] = row_of(*row, look=look)
    for why, names in idle.items():
        listed = "no rule of the field" if len(names) == len(card.rules) else ", ".join(names)
        found[why] = Text(f"{listed}: {why.replace('does not apply', 'not applied')}", style="dim")
    return found


def foreseen(scene: Scene) -> Iterator[tuple[str, str]]:
    """Regime, sag, where it stops, and closed forms of the elastic sag: all that needs no run."""
    effects, span = choose_effects(scene), scene.filament.span
    regime, sag = expected_regime(scene, effects.names), expected_sag(scene)
    yield "expected", ", ".join(filter(None, [regime_words(regime.name), regime.near]))
    yield "because", regime.reason
    yield "expected sag", f"about {significant(100 * sag)} % of the span, {_length(sag * span, span)}"
    if regime.stopping_depth_exact is not None:
        yield "stops at most at", f"{_length(regime.stopping_depth_exact * span, span)}, a catenary at yield"
    if sags := elastic_sags(scene):
        yield "elastic sags", ", ".join(f"{name} {_length(value, span)}" for name, value in sags.items())
    if cost := run_cost(scene, effects).text:
        yield "cost of a run", cost


class CardPrinter:
    """Prints what is known of a card line by line, as soon as it is known; nothing twice."""

    def __init__(self, *, quiet: bool) -> None:
        self.card: Card | None = None  # As far as it is
        self._quiet, self._printed = quiet, set[str]()

    def print_forecast(self, scene: Scene) -> None:
        """Print the scene's title, and what can be said before anything is integrated."""
        if not self._quiet:
            self._print(Text(scene.title or "Filament", style="bold"), *(row_of(*row) for row in foreseen(scene)))

    def update(self, card: Card) -> None:
        """Take note of what is known by now."""
        self.card, known = card, lines(card)
        if not self._quiet:
            self._print(*(known[words] for words in known if words not in self._printed))
        self._printed |= known.keys()

    @staticmethod
    def _print(*found: RenderableType) -> None:
        console = Console()
        for line in found:
            with console.capture() as shown:
                console.print(line, markup=False, highlight=False)
            # By way of print, as bars on the same terminal replace its stream.
            print(shown.get(), end="", flush=True)


@drawing.report.register(Card)
def card_report(card: Card, command: str = "") -> Report:
    """Verdict, facts and rules, the picture, and a page with all of it."""
    sound, sentence = verdict(card)
    looks = ["green" if rule.holds else "dim" if rule.predicted is None else "" for rule in card.rules]
    rules = TextTable(
        _RULES, [rule_texts(rule) for rule in card.rules], _NUMBERS, looks, "Rules of the field beside the solver",
        "error: rule over solver, minus one; behind a cause, of a filament with nothing else that the rule leaves out",
    )  # fmt: skip
    files = {
        "card.json": card.to_dict,
        "card.csv": card.to_frame,
        "scene.toml": card.scene.to_toml,
        "card.png": card_figure(card) if card.descent is not None else None,
    }
    said = Text(sentence, style=f"bold {'green' if sound else 'red'}")
    known = TextTable(("", ""), facts(card), whole=[0])
    captions = {"card": "final shape, and descent with the predictions of the rules"}
    title = f"{card.scene.title or 'Filament'}: sag card"
    return Report(files, [said, known, rules], title, "card.html", captions, command)


_TALLEST, _FLATTEST, _LOW = 1.7, 0.55, 2.1
_WIDE = style.WIDTH - 0.85
_DEEPEST = 2.5
"""A rule that predicts more than this many times the sag is only named."""

_AGREE = 0.01
"""Relative difference of rules that share a line."""

_LINES = (
    (style.VERMILLION, "--"), (style.ORANGE, "-."), (style.PURPLE, ":"), (style.SKY, (0, (5, 1, 1, 1, 1, 1))),
    (style.BLACK, (0, (1, 1))), (style.GREY, "--"), (style.GREEN, "-."),
)  # fmt: skip


@drawing.plot.register(Card)
@styled()
def card_figure(card: Card) -> Figure:
    """Draw the final shape, and the descent beside the rules."""
    sheet, filament = Sheet.of(card.run.fields, card.summary, card.scene), card.scene.filament
    larger = Magnification.of(largest_sag(array(sheet.data, "y")[-1:]), filament.thickness, filament.span)
    (shape,) = shapes_of(larger.drawn(sheet.data), card.scene, [len(sheet.time) - 1])
    wide, high = np.ptp(shape.outline, axis=0)
    tall = min(max(1.1 * float(high / wide) * larger.sag * _WIDE, _FLATTEST), _TALLEST)
    scaled = f", {larger}" if str(larger) else ""
    figure, body = titled_figure(card.scene, f"shape at the end{scaled}", sheet.summary, height=tall + _LOW + 1.1)
    above, below = body.subplots(2, 1, height_ratios=[tall, _LOW])
    _draw_end(above, sheet, shape, larger)
    _draw_descent(below, sheet, card)
    return figure


def _draw_end(axes: Axes, sheet: Sheet, shape: Shape, larger: Magnification) -> None:
    """The filament with what has yielded; one scale along both axes but for what is magnified."""
    unit, ever = length_unit(sheet.scene.filament.span), np.empty((0, 4, 2))
    if sheet.scene.material.yield_stress is not None:
        core = yielding_of(sheet.data, sheet.scene)
        low, high = np.max(core.low, axis=0), np.min(core.high, axis=0)
        ever = quads_outside(shape.section, np.minimum(low, high), np.maximum(low, high))
    axes.update_datalim(unit.of(shape.outline))
    draw_shape(axes, shape, unit, ever)
    names = {"has yielded": (style.ORANGE, ever), "yields at the end": (style.VERMILLION, shape.yielded)}
    patches = [Patch(facecolor=colour, label=name) for name, (colour, quads) in names.items() if len(quads)]
    if patches:
        axes.legend(handles=patches, loc="lower center", ncols=2, bbox_to_anchor=(0.5, 1.0), borderaxespad=0.0)
    axes.margins(0.02, 0.06)
    axes.set_aspect(larger.sag, adjustable="datalim")
    axes.yaxis.set_major_locator(MaxNLocator(3))
    axes.set_xlabel(f"x [{unit.symbol}]")
    axes.set_ylabel(f"y [{unit.symbol}]")


def predictions(card: Card) -> list[tuple[str, float]]:
    """Names, with errors, and depths [m] that rules predict, and that the filament has without surface tension.

    Rules that as good as agree are named together, a rule in two forms once.
    """
    rules = [
        (rule.name, "" if rule.error is None else f" {percent(rule.error)}", rule.predicted)
        for rule in card.rules
        if rule.unit == "m" and rule.predicted is not None
    ]
    if card.surface is not None and card.surface.sag_without is not None:
        rules.append(("no surface tension", "", card.surface.sag_without))
    groups: list[list[tuple[str, str, float]]] = []
    for rule in sorted(rules, key=lambda rule: rule[2]):
        if groups and abs(rule[2] - groups[-1][-1][2]) < _AGREE * abs(rule[2]):
            groups[-1].append(rule)
        else:
            groups.append([rule])
    found = []
    for group in groups:
        names = [group[0][0]] + [after[0].removeprefix(f"{before[0]}, ") for before, after in pairwise(group)]
        labels = (name + error for name, (_, error, _) in zip(names, group, strict=True))
        found.append((", ".join(labels), group[0][2]))
    return found


def _draw_descent(axes: Axes, sheet: Sheet, card: Card) -> None:
    """Sag over time, downwards, and a line at each depth predicted; of what lies far below an arrow at the edge."""
    time, height = sheet.curves("midpoint")
    deepest = -float(height.min())
    unit = length_unit(float(np.abs(height).max()), card.scene.filament.span)
    axes.plot(time, unit.of(-height[:, 0]), color=style.BLUE, zorder=3, label="solver")
    arrows = 0
    for (name, depth), (colour, line) in zip(predictions(card), cycle(_LINES)):
        if depth <= _DEEPEST * deepest:
            axes.axhline(float(unit.of(depth)), color=colour, linewidth=1.0, linestyle=line, label=name)
            continue
        look: dict[str, Any] = {"marker": "v", "color": colour, "markersize": 5, "linestyle": "none", "clip_on": False}
        axes.plot([0.06 + 0.07 * arrows], [0.0], transform=axes.transAxes, label=name, **look)
        arrows += 1
    if card.descent is not None and card.descent.to_90 is not None:
        at = (float(sheet.axis.unit.of(card.descent.to_90)), float(unit.of(0.9 * -height[-1, 0])))
        axes.plot(*at, "o", color=style.BLUE, markersize=4, zorder=4, label="90 %")
    axes.margins(y=0.08)
    axes.grid(True)
    sheet.axis.dress(axes, 5)
    axes.invert_yaxis()
    axes.set_ylabel(f"sag of the midpoint [{unit.symbol}]")
    axes.set_title("descent, and what the rules predict" + (" (▼ deeper)" if arrows else ""), fontsize=8.5, loc="left")
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), fontsize=6.8, handlelength=1.8, labelspacing=0.4)
