"""The sag card: everything a printer asks of a spanning filament, on one page."""

from softcat_sym.study.card.contents import Blame, Card, Certificate, Descent, Rule
from softcat_sym.study.card.making import card

__all__ = ["Blame", "Card", "Certificate", "Descent", "Rule", "card"]
