"""Where the theory ends: values, meshes, errors and limits of known answer; a study goes on; failures are said."""

from __future__ import annotations

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.scene.scene import Scene
from softcat_sym.studies.theory_end import (
    TheoryEnd,
    Variation,
    relative_error,
    slender_limit,
    where_theory_ends,
)
from tests.common.strips import timoshenko_sag


def test_relative_error_of_known_curves() -> None:
    time = np.linspace(0, 7, 71)
    elements = -(1 + time)
    found = relative_error(time, elements * (1 + 0.01 * time), elements)
    np.testing.assert_allclose(found[:4], [0.007, 0.018, 0.035, 0.07], rtol=1e-10)
    assert found[-1] == pytest.approx(0.07)
    settled = time[10:]
    assert found[4] == pytest.approx(0.01 * float(((1 + settled) * settled).mean() / (1 + settled).mean()))
    # With its sign, and not from the frames before a tenth of the duration.
    early = np.where(time < 0.6, 5.0, 1 - 0.02 * time)
    assert relative_error(time, elements * early, elements)[-1] == pytest.approx(-0.14)
    assert np.isnan(relative_error(time, elements, np.zeros(71))).all()


DELTA = np.array([0.0075, 0.01, 0.02, 0.03, 0.045, 0.06])


def test_the_limit_of_a_parabola_is_exact() -> None:
    error = 0.004 - 0.6 * DELTA + 3 * DELTA**2
    mesh = -0.001 + 0.02 * DELTA
    found = slender_limit(DELTA, error, mesh)
    assert found is not None
    np.testing.assert_allclose(found["coefficients"], [0.004, -0.6, 3.0], rtol=1e-9)
    assert found["leaving_out"] == pytest.approx(0.0, abs=1e-12)
    assert found["mesh"] == pytest.approx(0.001)
    assert found["uncertainty"] == pytest.approx(0.001)


def test_the_order_of_an_error_is_found() -> None:
    for power in (1, 2):
        found = slender_limit(DELTA, -0.7 * DELTA**power, np.zeros(6))
        assert found is not None
        assert found["order"] == pytest.approx(power)
        assert found["intercept"] == pytest.approx(0.0, abs=1e-12)
    # An error of third order shows in leaving out.
    found = slender_limit(DELTA, 100 * DELTA**3, np.zeros(6))
    assert found is not None and abs(found["intercept"]) > 1e-5
    assert found["leaving_out"] > abs(found["intercept"]) / 3


THICK = Variation("groups.delta", ("0.12", "0.08", "0.1"))
SLOWLY = (
    "filament.width=0.1 mm",
    "groups.ramp=60",
    "groups.duration=60",
    "run.frames=13",
    "load.gravity=0.5 m/s^2",
    "numerics.cells=24",
)


def beam(*changes: str) -> Scene:
    """An elastic beam, loaded so slowly that it hangs at rest in the end, by a hundredth of its thickness at most."""
    return sc.load_scene("no-yield", [*SLOWLY, *changes])


@pytest.fixture(scope="module")
def thick() -> TheoryEnd:
    return where_theory_ends(beam(), THICK, beam, along=8, through=4)


@pytest.mark.slow
def test_a_beam_theory_misses_what_shear_adds(thick: TheoryEnd) -> None:
    """Timoshenko's sag over that of a beam that does not shear is known in closed form."""
    assert [each.value for each in thick.measured] == [0.08, 0.1, 0.12]
    assert thick.unmeasured == ()
    for each in thick.measured:
        poisson = each.comparison.scene.material.poisson
        stiff = timoshenko_sag(each.value, 1.0, np.inf, poisson)
        shear = stiff / timoshenko_sag(each.value, 1.0, 5 / 6, poisson) - 1
        found = each.theories
        beam_theory, own = found["published, material closure"].error[3], found["filament"].error[3]
        # The elements cancel: what is left is the shear, and what 48 cells and the last swing miss of it.
        assert (1 + beam_theory) / (1 + own) - 1 == pytest.approx(shear, rel=0.06)
        # They are too stiff on meshes this coarse, and say so; and a face that is held does not warp.
        assert abs(own) < 1.5 * abs(each.mesh[3]) < 0.03
        assert each.mesh[3] < 0
        # 24 cells instead of 48; a quarter of the percent that 12 cells would leave.
        assert all(0 < theory.grid < 4e-3 for theory in found.values())
    limit = thick.limits["published, material closure"][3]
    assert limit is not None
    # The square of the thickness, but for the denominator in 1/(1 + 13.92 delta^2).
    assert 1.6 < limit["order"] < 2.3
