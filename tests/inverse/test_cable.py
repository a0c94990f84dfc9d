"""The cable's mode in complex arithmetic against the equation that derivations/07_rheometry proves."""

from __future__ import annotations

import math

import pytest

from softcat_sym.discretization.casadi_printer import evaluate
from softcat_sym.fitting.features import SLACKEST, TAUTEST, modulus_of, stiffness_number
from softcat_sym.physics import rheometry
from softcat_sym.physics.regimes import H as SAG
from softcat_sym.physics.symbols import L as SPAN


@pytest.mark.parametrize("mode", [3.3, 4.0, 6.0, 8.5])
def test_without_decay_it_is_the_derived_modulus(mode: float) -> None:
    sag = 0.03
    frequency = mode / math.sqrt(8 * sag)
    held = evaluate(rheometry.MODULUS_FROM_CABLE.right, {rheometry.R: frequency, SAG: sag, SPAN: 1.0})
    found = modulus_of(frequency, 0.0, sag, 1.0, 1.0)
    assert found is not None
    assert found.modulus == pytest.approx(held, rel=1e-12)
    assert math.isinf(found.relaxation_time)


def test_the_mode_ends_where_the_cable_no_longer_stretches() -> None:
    assert math.tan(SLACKEST / 2) == pytest.approx(SLACKEST / 2, rel=1e-3)
    assert abs(stiffness_number(complex(TAUTEST, 1e-9))) < 1e-6
    assert modulus_of(SLACKEST / math.sqrt(8 * 0.03) * 1.01, 0.0, 0.03, 1.0, 1.0) is None
