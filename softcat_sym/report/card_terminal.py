"""The sag card on a terminal: one screen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from softcat_sym.report.card_words import RULE_HEADINGS, facts, rule_texts, verdict

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

    from softcat_sym.study.card import Card

_RIGHT = (1, 2, 3)


def print_card(card: Card, console: Console | None = None) -> None:
    """Print facts and rules.

    Parameters
    ----------
    card : Card
        As from :func:`softcat_sym.study.card.card`.
    console : rich.console.Console or None
        Where to; standard output by default.
    """
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
