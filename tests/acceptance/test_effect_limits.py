"""An effect whose coefficient goes to zero converges to its absence, at the rate that theory gives."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from . import fading_filaments as fading
from .effect_limits import LIMITS, Limit, measure
from .table import show


@pytest.mark.slow
@pytest.mark.parametrize("limit", LIMITS, ids=lambda limit: f"{limit.effect}: {limit.what}")
def test_a_fading_effect_is_its_absence(limit: Limit) -> None:
    found = measure(limit)
    prefactor = limit.prefactor() if limit.prefactor is not None else None
    rows = []
    for value, share, exponent in zip(limit.values, found.shares, (None, *found.exponents), strict=True):
        per = share / value**limit.exponent
        rows.append([f"{value:g}", f"{share:.3e}", "" if exponent is None else f"{exponent:.3f}", f"{per:.4g}"])
    theory = f"exponent {limit.exponent:.4g}" + ("" if prefactor is None else f", prefactor {prefactor:.4g}")
    title = f"{limit.effect}, {limit.what}; theory: {theory}"
    show(title, (limit.coefficient, "share of the sag", "exponent", "prefactor"), rows)
    assert all(value > after for value, after in pairwise(limit.values)), "the coefficient must fall"
    assert found.exponents[-1] == pytest.approx(limit.exponent, abs=limit.band)
    if prefactor is not None:
        assert found.shares[-1] / limit.values[-1] ** limit.exponent == pytest.approx(prefactor, rel=limit.share)


@pytest.mark.slow
def test_a_linear_profile_of_fibres_is_the_run_without_them() -> None:
    """The two are discretised differently, so they agree as the square of the cells, down to a thousandth of shear."""
    threshold, rows, differences = 0.4, [], []
    for cells in (10, 20, 40):
        linear = fading.bingham_beam(threshold, (*fading.BENDING_FLOW, "fibres"), cells, {"order": 1})
        without = fading.bingham_beam(threshold, fading.BENDING_FLOW, cells, {})
        differences.append(float(np.max(np.abs(linear - without)) / np.max(without)))
        rows.append([cells, f"{without[-1]:.6f}", f"{linear[-1]:.6f}", f"{differences[-1]:.1e}"])
    show("linear profile", ("cells", "sag without fibres", "sag of linear fibres", "difference"), rows)
    assert differences[0] / differences[1] == pytest.approx(4, rel=0.2)
    assert differences[2] < 1e-3
