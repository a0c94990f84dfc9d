"""``auto`` against the run with everything switched on: some random scenes, and some in random surroundings.

The ranges of the scenes stand in ``random_scenes.py`` and were fixed before any was run. ``python -m
tests.studies.auto_and_everything`` runs all of them: 97 % and more are within the accuracy. Nothing is drawn here.
"""

from __future__ import annotations

import pytest

from tests.common.random_scenes import in_surroundings, random_scenes
from tests.common.table import show
from tests.studies.auto_and_everything import answer_of

pytestmark = pytest.mark.slow

DRAWN = random_scenes(5)
SCENES = {f"random {k}": scene for k, scene in enumerate(DRAWN)}
SCENES |= {f"surrounded {k}": scene for k, scene in enumerate(in_surroundings(DRAWN)[:3])}


@pytest.mark.parametrize("name", SCENES)
def test_auto_is_within_the_accuracy_of_everything(name: str) -> None:
    """On the grid that both get, or on one that is twice as fine; and no estimate was wrong twice."""
    found = answer_of(name, SCENES[name].to_toml(), idle="")
    row = [f"{found.accuracy:g}", f"{found.error:.1e}", f"{found.finer:.1e}", ", ".join(found.chosen), found.messages]
    show(name, ("accuracy", "error", "on a finer grid", "chosen", "no answer"), [row])
    assert found.messages or found.error <= found.accuracy or found.finer <= found.accuracy
    assert len(found.repeats) <= 1
