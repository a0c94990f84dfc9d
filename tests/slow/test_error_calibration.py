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
INKS = 3


@pytest.mark.parametrize("which", [*NAMES, *range(INKS)])
def test_estimates_are_right_within_a_factor_of_three(which: str | int) -> None:
    name, scene = (which, sc.load_scene(which)) if isinstance(which, str) else users_inks(INKS)[which]
    run = sc.simulate(scene)
    assert run.outcome.is_success
    total, accuracy = run.summary["error_estimate"]["total"], scene.run.accuracy
    true, why_not = true_error(scene, run)
    show(name, ("accuracy", "estimate", "true"), [[f"{accuracy:g}", f"{total:.1e}", f"{true:.1e}"]])
    assert not why_not and true <= 1.5 * accuracy
    nothing = NOTHING * accuracy
    assert LEAST <= true / total <= MOST or max(true, total) < nothing


BENT = {
    "filament": {"span": "0.1 m", "diameter": "4 mm", "density": "1200 kg/m^3"},
    "ends": {"right": "free"},
    "run": {"duration": "2 s", "frames": 41},
}
ASIDE: dict[str, dict[str, dict[str, object]]] = {
    "viscous, pulled aside": {
        "material": {"law": "newtonian", "viscosity": "2e4 Pa*s"},
        "load": {"tip_force": ["0 N", "0 N", "2e-3 N"]},
    },
    "a Maxwell helix": {
        "filament": {**BENT["filament"], "curvature": "8 1/m", "twist": "6 1/m"},
        "material": {"law": "maxwell", "youngs_modulus": "0.5 MPa", "viscosity": "2e5 Pa*s"},
    },
}
