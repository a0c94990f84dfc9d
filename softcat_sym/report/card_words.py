"""A sag card in words: the facts, the rules and the exponents of the longest span."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from softcat_sym.report.units import length_unit, significant, stress_unit, time_unit
from softcat_sym.report.words import REGIMES
from softcat_sym.study.card.causes import percent
from softcat_sym.study.card.rules import smay_modulus_needed, unusual

if TYPE_CHECKING:
    from softcat_sym.study.card import Card, Rule

RULE_HEADINGS = ("rule", "predicts", "solver", "error", "what makes it fail")
_FEW = 5
_NOTHING = 5e-3
_INCOMPRESSIBLE = 3.0


def verdict(card: Card) -> tuple[bool, str]:
    """Whether the card may be trusted, and one sentence that stands on top of it."""
    outcome = card.run.outcome
    if not outcome.is_success:
        complaint = str(card.summary.get("complaint") or "")
        return False, f"Not to be trusted: {outcome.name}; " + "; ".join(filter(None, [complaint, outcome.value]))
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
