"""``auto`` against the run with everything switched on, over two hundred random scenes in random surroundings."""

from __future__ import annotations

import os
from collections import Counter

import pytest

from tests.common.auto_and_everything import answers
from tests.common.random_scenes import NUMBER, SEED, in_surroundings, random_scenes
from tests.common.table import show

pytestmark = pytest.mark.slow

WITHIN = 0.97


def test_auto_is_within_the_accuracy_of_everything_in_any_surroundings() -> None:
    number = int(os.environ.get("SOFTCAT_SCENES", NUMBER))
    drawn = in_surroundings(random_scenes(number, SEED), SEED)
    studied = answers([(f"random {number}", scene) for number, scene in enumerate(drawn)], idle=False)
    answered = [answer for answer in studied if not answer.messages]
    beyond = [answer for answer in answered if answer.error > answer.accuracy]
    missed = [answer for answer in beyond if answer.finer > answer.accuracy]
    rows = [(a.name, f"{a.accuracy:g}", f"{a.error:.1e}", f"{a.finer:.1e}", ", ".join(a.chosen)) for a in beyond]
    show("beyond the accuracy", ("scene", "accuracy", "error", "on a finer grid", "chosen"), rows)
    show("without an answer", ("scene", "why"), [(a.name, a.messages[0][:100]) for a in studied if a.messages])
    chosen = Counter(effect for answer in answered for effect in answer.chosen)
    print("\n" + ", ".join(f"{effect} in {count}" for effect, count in chosen.most_common()))
    share = 1 - len(missed) / len(answered)
    print(f"{len(answered)} scenes with an answer, {share:.1%} within the accuracy asked")
    assert len(answered) > 0.85 * len(studied)
    assert share >= WITHIN
