"""The sag card in words, and on a terminal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from softcat_sym.plotting.style import REGIMES, length_unit, significant, stress_unit, time_unit
from softcat_sym.studies.card_rules import percent, smay_modulus_needed, unusual

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

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


_RIGHT = (1, 2, 3)


def print_card(card: Card, console: Console | None = None) -> None:
    """Print facts and rules."""
    from rich.console import Console
    from rich.text import Text

    screen = console or Console()
    sound, sentence = verdict(card)
    screen.print(Text(card.scene.title or "Filament", style="bold"))
    screen.print(Text(sentence, style="bold green" if sound else "bold red"))
    screen.print(_facts(card))
    if any(rule.predicted is not None for rule in card.rules):
        screen.print(_rules(card))
    idle: dict[str, list[str]] = {}
    for rule in card.rules:
        if rule.predicted is None:
            idle.setdefault(rule.text, []).append(rule.name)
    for why, names in idle.items():
        listed = "no rule of the field" if len(names) == len(card.rules) else ", ".join(names)
        screen.print(Text(f"{listed}: {why.replace('does not apply', 'not applied')}", style="dim"))


def _facts(card: Card) -> Table:
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, show_header=False, padding=(0, 1, 0, 0))
    table.add_column(no_wrap=True, style="dim")
    table.add_column(overflow="fold")
    for name, text in facts(card):
        if name == "note":
            # On the page and in the scene; here they would take the room of the rules.
            continue
        table.add_row(Text(name), Text(text, style="yellow" if name == "warning" else ""))
    return table


def _rules(card: Card) -> Table:
    """The rules that apply."""
    from rich import box
    from rich.table import Table
    from rich.text import Text

    table = Table(box=box.SIMPLE_HEAD, padding=(0, 1, 0, 0), show_edge=False)
    for number, heading in enumerate(RULE_HEADINGS):
        right = number in _RIGHT
        table.add_column(heading, justify="right" if right else "left", no_wrap=right, overflow="fold")
    for rule in card.rules:
        if rule.predicted is None:
            continue
        _, predicted, solver, error, why = rule_texts(rule)
        style = "green" if rule.holds else ""
        cells = (rule.name, predicted, solver, error, why)
        table.add_row(*(Text(cell, style=style) for cell in cells))
    return table
