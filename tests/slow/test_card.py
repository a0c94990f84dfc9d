"""The card of the bundled ink: every rule that fails is explained."""

from __future__ import annotations

import pytest

from softcat_sym.scene.reading import load_scene
from softcat_sym.studies.card import Card, card
from tests.common.table import show

pytestmark = pytest.mark.slow

HEADER = ("rule", "unit", "predicts", "solver", "error", "bare", "what makes it fail")


def rows(found: Card) -> list[tuple[str, ...]]:
    return [
        tuple(map(str, row)) for row in found.to_frame().drop(columns=["source", "quantity"]).itertuples(index=False)
    ]


def test_every_rule_of_the_bundled_ink_is_explained() -> None:
    """Without what a rule leaves out the solver and the rule agree, so that what is put back is what is to blame."""
    found = card(load_scene("ink-bridge"), span=False)
    show(f"{found.scene.title}: {found.regime}", HEADER, rows(found))
    off = [rule for rule in found.rules if rule.error is not None and not rule.holds]
    assert len(off) == 10
    for rule in off:
        assert rule.bare is not None and abs(rule.bare) < 0.05, rule.name
        assert rule.blames, rule.name
