"""The sag card: words, picture, a page that prints on A4, and all its files."""

from __future__ import annotations

import importlib.metadata
import math
from base64 import b64encode
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from rich import box
from rich.console import Console
from rich.table import Table
from rich.text import Text

from softcat_sym.plotting import style
from softcat_sym.plotting.files import csv_bytes, json_bytes, page, write_results
from softcat_sym.plotting.section import (
    Floats,
    Section,
    outline,
    quads_outside,
    section_at,
    vertical_stretch,
    yielding_of,
)
from softcat_sym.plotting.style import HEADING, axes_in_inches, head, new_figure, png, shown_part
from softcat_sym.plotting.units import REGIMES, Unit, length_unit, significant, stress_unit, time_unit
from softcat_sym.studies.card_rules import percent, smay_modulus_needed, unusual

if TYPE_CHECKING:
    from softcat_sym.studies.card_rules import Card, Rule

RULE_HEADINGS = ("rule", "predicts", "solver", "error", "what makes it fail")
_FEW = 5
_NOTHING = 5e-3
_INCOMPRESSIBLE = 3.0


def verdict(card: Card) -> tuple[bool, str]:
    """Whether the card may be trusted, and one sentence that stands on top of it."""
    outcome = card.run.outcome
    if not outcome.is_success:
        message = str(card.summary.get("message") or "")
        return False, f"Not to be trusted: {outcome.name}; " + "; ".join(filter(None, [message, outcome.value]))
    words = REGIMES.get(card.regime, card.regime)
    return True, f"{words[:1].upper()}{words[1:]}."


def facts(card: Card) -> list[tuple[str, str]]:
    """Name and text of every fact, in the order of reading."""
    rows = [("regime", _regime(card))] if card.regime else []
    if card.descent is not None:
        rows += _descent(card)
    if card.certificate is not None:
        rows.append(("arrest", _certificate(card)))
    rows.append(("longest span", span_text(card)))
    if card.span is not None:
        rows.append(("it grows as", exponents_text(card)))
    if needed := _smay(card):
        rows.append(("Smay's criterion", needed))
    rows += [("note", text) for text in card.notes]
    rows += [("warning", str(text)) for text in card.summary.get("warnings") or ()]
    return rows


def _regime(card: Card) -> str:
    if card.descent is None:
        return card.regime
    back = "never comes back up" if card.descent.rise < 1e-3 else f"comes back up by {percent(card.descent.rise)[1:]}"
    return f"{card.regime}; {card.descent.damping} ({back})"


def _descent(card: Card) -> list[tuple[str, str]]:
    found = card.descent
    if found is None:
        return []
    filament = card.scene.filament
    ruler = length_unit(abs(found.final), filament.span)
    clock = time_unit(card.scene.run.duration)
    sure = "" if card.error_estimate is None else f" ± {100 * card.error_estimate:.2g} %"
    parts = f"{100 * found.final / filament.span:.3g} % of the span, {found.final / filament.thickness:.3g} thicknesses"
    rest = "still moving when the run ends"
    if found.settled is not None:
        rest = f"within 1 % from {clock.text(found.settled)} on"
    reached = "" if found.to_90 is None else f"90 % of it after {clock.text(found.to_90)}; "
    return [
        ("final sag", f"{ruler.text(found.final)}{sure} = {parts}"),
        ("when", f"{reached}{rest}"),
        ("largest stretch", f"{found.stretch:.4g} at X/L = {significant(found.stretch_at)}"),
    ]


def _certificate(card: Card) -> str:
    found = card.certificate
    if found is None or found.gravity_number is None:
        return "" if found is None else found.text
    limits = f"yields from {found.first_yield:.3g}, no catenary rests above {found.threshold:.4g}"
    return f"G = {found.gravity_number:.3g}; {limits}; {found.text}"


def span_text(card: Card) -> str:
    """The longest span that sags less than the limit."""
    if card.span is None:
        return f"none found: {card.span_text}"
    span, sag = card.span.span, card.span.sag
    return f"{length_unit(span).text(span)} sags {length_unit(sag).text(sag)} (limit {card.limit})"


def exponents(card: Card) -> list[tuple[str, float]]:
    """Parameter and d ln span/d ln parameter, the strongest first; without those that make no difference."""
    if card.span is None:
        return []
    found = [(_plain(path), power) for path, power in card.span.gradient.items()]
    known = [(name, power) for name, power in found if math.isfinite(power) and abs(power) > _NOTHING]
    return sorted(known, key=lambda pair: -abs(pair[1]))


def _plain(path: str) -> str:
    return path.rpartition(".")[2].replace("_", " ").replace("youngs", "Young's")


def exponents_text(card: Card) -> str:
    """The exponents in one line."""
    listed = [f"{name}^{power:.2g}" for name, power in exponents(card)[:_FEW]]
    return ", ".join(listed) or "nothing that is known here"


def _smay(card: Card) -> str:
    modulus = card.scene.material.youngs_modulus
    if modulus is None or unusual(card.scene):
        return ""
    needed, own = smay_modulus_needed(card.scene), modulus / _INCOMPRESSIBLE
    ruler = stress_unit(max(needed, own))
    meets = "meets" if own >= needed else "misses"
    return f"{meets} it: G' = {ruler.text(own)}, asked for {ruler.text(needed)} (0.05 D, pins)"


def rule_texts(rule: Rule) -> tuple[str, str, str, str, str]:
    """Cells of one row of the table of rules."""
    if rule.predicted is None:
        return rule.name, "", "", "", rule.text
    return (
        f"{rule.name} {rule.source}",
        quantity(rule, rule.predicted),
        quantity(rule, rule.solver),
        "" if rule.error is None else percent(rule.error),
        rule.text,
    )


def quantity(rule: Rule, value: float) -> str:
    """A sag or a stress with its unit."""
    return (length_unit if rule.unit == "m" else stress_unit)(abs(value)).text(value)


_NUMBERS = (1, 2, 3)
"""Columns of the table of rules that are numbers."""


def print_card(card: Card, console: Console | None = None) -> None:
    """Print facts and rules."""
    screen = console or Console()
    sound, sentence = verdict(card)
    screen.print(Text(card.scene.title or "Filament", style="bold"))
    screen.print(Text(sentence, style="bold green" if sound else "bold red"))
    screen.print(_facts_table(card))
    if any(rule.predicted is not None for rule in card.rules):
        screen.print(_rules_table(card))
    idle: dict[str, list[str]] = {}
    for rule in card.rules:
        if rule.predicted is None:
            idle.setdefault(rule.text, []).append(rule.name)
    for why, names in idle.items():
        listed = "no rule of the field" if len(names) == len(card.rules) else ", ".join(names)
        screen.print(Text(f"{listed}: {why.replace('does not apply', 'not applied')}", style="dim"))


def _facts_table(card: Card) -> Table:
    """The facts; notes are on the page and in the scene, here they would take the room of the rules."""
    table = Table(box=None, show_header=False, padding=(0, 1, 0, 0))
    table.add_column(no_wrap=True, style="dim")
    table.add_column(overflow="fold")
    for name, text in facts(card):
        if name != "note":
            table.add_row(Text(name), Text(text, style="yellow" if name == "warning" else ""))
    return table


def _rules_table(card: Card) -> Table:
    """The rules that apply."""
    table = Table(box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0), show_edge=False)
    for number, heading in enumerate(RULE_HEADINGS):
        right = number in _NUMBERS
        table.add_column(heading, justify="right" if right else "left", no_wrap=right, overflow="fold")
    for rule in (one for one in card.rules if one.predicted is not None):
        cells = (rule.name, *rule_texts(rule)[1:])
        table.add_row(*(Text(cell, style="green" if rule.holds else "") for cell in cells))
    return table


_LEFT, _RIGHT, _BETWEEN, _BOTTOM, _LOW = 0.65, 0.2, 0.78, 0.52, 1.95
_TALLEST, _LEAST = 1.7, 0.55
_CURVE, _MARKS, _NAMES = 2.0, 1.87, 1.12
_ABOVE = 1.35
"""Height of the curve's axes over the largest sag that is shown."""

_SHOWN = 2.5
"""A rule that predicts more than this many times the sag is named at the edge."""


def card_figure(card: Card) -> Figure:
    """Draw the card's picture."""
    data, summary = shown_part(card.run.fields, card.summary)
    card = replace(card, run=replace(card.run, fields=data))
    ends = card.scene.ends
    section = section_at(card.run.data, -1, (ends.left == "clamped", ends.right == "clamped"))
    body = outline(section)
    stretch = vertical_stretch(float(np.ptp(section.y)), card.scene.filament.thickness, card.scene.filament.span)
    width = style.WIDTH - _LEFT - _RIGHT
    across = float(np.ptp(body[:, 0])) * 1.04
    tall = float(np.ptp(body[:, 1])) * 1.15 * stretch / across * width
    drawn = min(max(tall, _LEAST), _TALLEST)
    with style.styled():
        figure = new_figure(style.WIDTH, _BOTTOM + _LOW + _BETWEEN + drawn + HEADING)
        head(figure, _caption(stretch), summary, card.scene, 0.2)
        shape = axes_in_inches(figure, _LEFT, _BOTTOM + _LOW + _BETWEEN, width, drawn)
        _shape(shape, card, section, body, width / drawn, stretch)
        _curve(axes_in_inches(figure, _LEFT, _BOTTOM, _CURVE, _LOW), card)
        left = _LEFT + _CURVE + _MARKS + _NAMES
        _bars(axes_in_inches(figure, left, _BOTTOM, style.WIDTH - _RIGHT - left, _LOW), card)
    return figure


def _caption(stretch: float) -> str:
    scaled = "" if stretch == 1 else f", heights and thickness × {stretch:g}"
    return f"shape at the end{scaled}"


def _shape(axes: Axes, card: Card, section: Section, body: Floats, aspect: float, stretch: float) -> None:
    """The filament with what has yielded; one scale along both axes but for the stretch."""
    limit = card.scene.material.yield_stress
    ruler = length_unit(card.scene.filament.span)
    (inside,) = axes.fill(*ruler.of(body).T, facecolor=style.FILAMENT, edgecolor="none", zorder=2)
    handles = []
    if limit is not None:
        for colour, now, label in ((style.ORANGE, False, "has yielded"), (style.VERMILLION, True, "yields at the end")):
            quads = quads_outside(section, *_core(card, now=now))
            if len(quads):
                patch = PolyCollection(list(ruler.of(quads)), facecolors=colour, edgecolors="none", antialiaseds=False)
                patch.set_zorder(4 if now else 3)
                axes.add_collection(patch, autolim=False)
                # At a clamp the sections of the first cell cross: what they cover beyond the body is none.
                patch.set_clip_path(inside)
                handles.append(Patch(facecolor=colour, label=label))
    axes.fill(*ruler.of(body).T, facecolor="none", edgecolor=style.BLACK, linewidth=0.5, zorder=5)
    centre = ruler.of(body.min(axis=0) + body.max(axis=0)) / 2
    half = 0.52 * float(ruler.of(np.ptp(body[:, 0])))
    axes.set_xlim(centre[0] - half, centre[0] + half)
    high = max(half / aspect / stretch, 0.54 * float(ruler.of(np.ptp(body[:, 1]))))
    axes.set_ylim(centre[1] - high, centre[1] + high)
    axes.plot(ruler.of(section.x[[0, -1]]), ruler.of(section.y[[0, -1]]), ":", color=style.GREY, lw=0.7)
    axes.yaxis.set_major_locator(MaxNLocator(3))
    axes.set_xlabel(f"x [{ruler.symbol}]", labelpad=1)
    axes.set_ylabel(f"y [{ruler.symbol}]")
    style.lighten(axes)
    if handles:
        axes.legend(handles=handles, loc="lower center", ncols=2, bbox_to_anchor=(0.5, 0.98), borderaxespad=0.0)


def _core(card: Card, *, now: bool) -> tuple[Floats, Floats]:
    """Limits in zeta between which no fibre yields at the end, or none ever did, shape (cell,)."""
    found = yielding_of(card.run.data, card.scene)
    if now:
        return found.low[-1], found.high[-1]
    low, high = np.max(found.low, axis=0), np.min(found.high, axis=0)
    return np.minimum(low, high), np.maximum(low, high)


def _curve(axes: Axes, card: Card) -> None:
    """Sag over time, downwards, and what the rules say of it."""
    data = card.run.data
    time, sag = data["time"].values, -data["midpoint"].values
    clock, ruler = time_unit(float(time[-1])), length_unit(float(np.max(np.abs(sag))), card.scene.filament.span)
    axes.plot(clock.of(time), ruler.of(sag), color=style.BLUE, zorder=3)
    final = float(sag[-1])
    rules = [one for one in card.rules if one.unit == "m" and one.predicted is not None]
    inside = [one for one in rules if (one.predicted or 0.0) <= _SHOWN * float(np.max(sag))]
    deepest = max([float(np.max(sag)), *((one.predicted or 0.0) for one in inside)])
    bottom = _ABOVE * deepest if deepest > 0 else 1.0
    axes.set_ylim(float(ruler.of(bottom)), min(0.0, float(ruler.of(np.min(sag)))))
    axes.set_xlim(0.0, float(clock.of(time[-1])))
    found = card.descent
    if found is not None and found.to_90 is not None:
        at = (float(clock.of(found.to_90)), float(ruler.of(0.9 * final)))
        axes.plot(*at, "o", color=style.BLUE, markersize=4, zorder=4)
        axes.annotate("90 %", at, xytext=(4, 4), textcoords="offset points", fontsize=7.5, color=style.BLUE)
    axes.set_xlabel(f"time [{clock.symbol}]")
    axes.set_ylabel(f"sag of the midpoint [{ruler.symbol}]")
    axes.grid(True)
    style.lighten(axes)
    axes.set_title("descent, and what the rules predict", fontsize=8.5, loc="left")
    _marks(axes, rules, ruler, bottom, final)


def _marks(axes: Axes, rules: list[Rule], ruler: Unit, bottom: float, final: float) -> None:
    """A mark at the depth of each rule, names spread out so that none covers another; deeper ones in the last lines."""
    marked = sorted([*rules], key=lambda one: one.predicted or 0.0)
    named = [("solver", final, style.BLUE)]
    named += [
        (f"{one.name} {percent(one.error)}" if one.error is not None else one.name, one.predicted or 0.0, _colour(one))
        for one in marked
    ]
    named.sort(key=lambda one: one[1])
    step = 0.085
    places: list[float] = []
    for _, depth, _ in named:
        wanted = min(depth / bottom, 1.0)
        places.append(max(wanted, places[-1] + step if places else 0.0))
    excess = max(0.0, places[-1] - 1.0)
    for k in range(len(places) - 1, -1, -1):
        # Pushed back up from the lower edge, each above the next.
        ceiling = 1.0 if k == len(places) - 1 else places[k + 1] - step
        places[k] = min(places[k], ceiling) if excess else places[k]
    for (name, depth, colour), place in zip(named, places, strict=True):
        beyond = depth > bottom
        level = 0.0 if beyond else 1 - depth / bottom
        axes.plot(
            [1.0, 1.03, 1.07], [level, level, 1 - place], color=colour, lw=0.9, clip_on=False, transform=axes.transAxes
        )
        text = f"{name} ↓" if beyond else name
        axes.text(1.09, 1 - place, text, transform=axes.transAxes, va="center", fontsize=6.8, color=colour)


def _colour(rule: Rule) -> str:
    return style.GREEN if rule.holds else style.BLACK


def _bars(axes: Axes, card: Card) -> None:
    """Exponents of the longest span, the strongest on top."""
    found = exponents(card)
    if not found:
        axes.set_axis_off()
        note = "longest span:\n" + ("not known" if card.span is None else "nothing moves it")
        axes.text(0.5, 0.5, note, ha="center", va="center", fontsize=8.0, color=style.GREY, transform=axes.transAxes)
        return
    axes.set_title(f"longest span for {style.printable(card.limit, 12)}: exponents", fontsize=8.5, loc="right")
    names, powers = zip(*found, strict=True)
    places = np.arange(len(found))[::-1]
    colours = [style.BLUE if power > 0 else style.VERMILLION for power in powers]
    axes.barh(places, powers, color=colours, height=0.62, zorder=2)
    widest = 3.2 * max(abs(power) for power in powers)
    axes.set_xlim(-widest, widest)
    axes.set_ylim(-0.6, len(found) - 0.4)
    for place, power in zip(places, powers, strict=True):
        right = power > 0
        axes.annotate(
            significant(round(power, 3)), (power, place), xytext=(3 if right else -3, 0), textcoords="offset points",
            ha="left" if right else "right", va="center", fontsize=7.0,
        )  # fmt: skip
    axes.axvline(0.0, color=style.GREY, lw=0.6)
    axes.set_yticks(places, [style.printable(name, 18) for name in names])
    axes.xaxis.set_major_locator(MaxNLocator(3))
    axes.set_xlabel("d ln span / d ln parameter", loc="right")
    style.lighten(axes)
    axes.tick_params(axis="y", length=0)


def card_page(card: Card, picture: bytes | None, command: str = "") -> bytes:
    """Write the page."""
    sound, sentence = verdict(card)
    return page(
        "card.html",
        title=card.scene.title or "Filament",
        version=importlib.metadata.version("softcat_sym"),
        is_sound=sound,
        verdict=sentence,
        numbers=list(_headline(card)),
        picture=None if picture is None else b64encode(picture).decode(),
        facts=facts(card),
        headings=RULE_HEADINGS,
        rules=[
            ("holds" if rule.holds else "idle" if rule.predicted is None else "", rule_texts(rule))
            for rule in card.rules
        ],
        right=_NUMBERS,
        command=command,
    )


def _headline(card: Card) -> Iterable[tuple[str, str]]:
    """The numbers that a printer looks for first."""
    found = card.descent
    if found is not None:
        yield length_unit(abs(found.final), card.scene.filament.span).text(found.final), "final sag"
        yield f"{100 * found.final / card.scene.filament.span:.3g} %", "of the span"
        if found.to_90 is not None:
            yield time_unit(found.to_90).text(found.to_90), "to 90 % of it"
    if card.span is not None:
        yield length_unit(card.span.span).text(card.span.span), f"longest span for {card.limit}"
    if card.error_estimate is not None:
        yield f"{100 * card.error_estimate:.2g} %", "estimated error"


_COLUMNS = ("rule", "source", "quantity", "unit", "predicted", "solver", "error", "error_bare", "what_makes_it_fail")


def card_csv(card: Card) -> bytes:
    """One row a rule, in SI; empty where a rule does not apply."""
    return csv_bytes(
        _COLUMNS,
        (
            (one.name, one.source, one.quantity, one.unit, one.predicted, one.solver, one.error, one.bare, one.text)
            for one in card.rules
        ),
    )


def write_card(card: Card, directory: str | Path, command: str = "") -> list[Path]:
    """Write ``card.html``, ``card.json``, ``card.csv``, ``card.png`` and ``scene.toml``."""
    figure = None if card.descent is None else card_figure(card)
    contents = {
        "card.html": card_page(card, None if figure is None else png(figure, titled=False), command),
        "card.json": json_bytes(card.as_dict(), is_ascii=False),
        "card.csv": card_csv(card),
        "scene.toml": card.scene.to_toml(),
        "card.png": figure,
    }
    return write_results(directory, contents)
