"""A strand without loss goes on ringing: the steps may not take from it what no law of it takes."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.forecast import expected_sag
from softcat_sym.results.motion import period_of


@pytest.fixture(scope="module")
def strand() -> sc.Scene:
    """Chocolate: it yields a little at first, at its clamps only, and then rings by less than a tenth of its sag."""
    return sc.Scene.model_validate(
        {
            "filament": {"span": "7.3 mm", "thickness": "1.1 mm", "section": "circle", "density": "1200 kg/m^3"},
            "material": {
                "law": "bingham",
                "youngs_modulus": "940 kPa",
                "shear_yield_stress": "120 Pa",
                "shear_viscosity": "4.9 Pa*s",
            },
            "surroundings": {"surface_tension": "0.04 N/m"},
            "run": {"duration": "0.8 s", "frames": 2001},
            "numerics": {"cells": 10, "fibres": 8, "estimate": False},
        }
    )


@pytest.fixture(scope="module")
def run(strand: sc.Scene) -> sc.Trajectory:
    return sc.simulate(strand)


@pytest.mark.slow
def test_steps_keep_a_ringing_of_hundreds_of_periods(strand: sc.Scene, run: sc.Trajectory) -> None:
    """Within a tenth of the accuracy of a run in much shorter steps; four steps a period would lose most of it."""
    exact = sc.simulate(strand.replace({"numerics.rtol": 2e-5})).summary
    told, largest = run.summary, exact["midpoint_largest_m"]
    assert strand.run.duration > 100 * period_of(strand)
    assert exact["midpoint_settled_m"]["amplitude"] > 3 * strand.run.accuracy * largest
    for name, value in exact["midpoint_settled_m"].items():
        assert told["midpoint_settled_m"][name] == pytest.approx(value, abs=0.1 * strand.run.accuracy * largest), name


def test_a_strand_of_which_a_part_stays_elastic_is_not_expected_to_fall(strand: sc.Scene, run: sc.Trajectory) -> None:
    """What is expected is what absolute tolerances are measured by."""
    deep = float(np.max(np.abs(run.data.midpoint.values))) / strand.filament.span
    assert 0.2 < expected_sag(strand) / deep < 2
