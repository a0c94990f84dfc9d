"""Cards of inks: every rule that fails is explained, and the regime is that of everybody else."""

from __future__ import annotations

from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.scene.reading import load_scene
from softcat_sym.studies.card import Card, card
from softcat_sym.studies.card_rules import descent_of
from tests.common.table import show

pytestmark = pytest.mark.slow

SAMPLE = Path(sc.__file__).parent / "samples" / "my-ink.toml"
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


@pytest.mark.filterwarnings("ignore:it rings at")
def test_one_ink_has_one_regime_whoever_tells_it(tmp_path: Path) -> None:
    """README's: run long and short, with few frames, card, sweep and what is foreseen."""
    ink = load_scene(SAMPLE, {"numerics.estimate": False, "run.frames": 201})
    runs = [sc.simulate(ink.replace(changes)) for changes in ({}, {"run.duration": "0.05 s"}, {"run.frames": 21})]
    whole, descent = runs[0].summary, descent_of(runs[0])
    swept = sc.sweep(ink, {"material.storage_modulus": ["103 kPa", "107 kPa"]}, tmp_path).data.isel(member=0)
    assert descent is not None
    regimes = {run.summary["regime"] for run in runs} | {f"arrested-{descent.damping}", str(swept.regime.values)}
    assert regimes == {expected_regime(ink, tuple(whole["effects"])).name} == {"arrested-underdamped"}
    assert [run.summary["rebound"] for run in runs] == pytest.approx([descent.rise] * 3, abs=1e-3)
    assert float(swept.sag_largest.values) == pytest.approx(-whole["midpoint_lowest_m"], rel=1e-3)
    assert whole["frames_a_period"] < 4 and any(text.startswith("it rings at") for text in whole["warnings"])
