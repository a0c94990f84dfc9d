"""Estimated errors are the true ones within a factor of three, and what is called accurate is: some scenes and inks.

True errors are those against twice the cells and fibres and a tenth of the tolerance. ``python -m
tests.studies.error_calibration`` looks at 140 scenes.
"""

from __future__ import annotations

import pytest

import softcat_sym as sc
from tests.common.table import show
from tests.common.true_error import true_error
from tests.studies.error_calibration import LEAST, MOST, NOTHING, users_inks

pytestmark = pytest.mark.slow

NAMES = ("cold-honey", "gelatin-strand", "no-yield", "silicone-thread", "beam-viscometer", "curled-rod")
SCENES = {**{name: sc.load_scene(name) for name in NAMES}, **dict(users_inks()[:3])}


@pytest.mark.parametrize("name", SCENES)
def test_estimates_are_right_within_a_factor_of_three(name: str) -> None:
    scene = SCENES[name]
    run = sc.simulate(scene)
    assert run.outcome.is_success
    total, accuracy = run.summary["error_estimate"]["total"], scene.run.accuracy
    true, why_not = true_error(scene, run)
    show(name, ("accuracy", "estimate", "true"), [[f"{accuracy:g}", f"{total:.1e}", f"{true:.1e}"]])
    assert not why_not and true <= 1.5 * accuracy
    nothing = NOTHING * accuracy
    assert LEAST <= true / total <= MOST or max(true, total) < nothing
