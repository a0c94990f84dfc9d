"""What must not matter to a material point: who looks on, equal stretches, sheer rotation. And what it refuses."""

from __future__ import annotations

import copy
import math

import numpy as np
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.material_point import MaterialPoint

from .paths import BINGHAM, ELASTIC, Floats, shear_and_stretch

E, NU = BINGHAM["youngs_modulus"], BINGHAM["poisson"]


def turned(angle: float) -> Floats:
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


def test_isotropic_turning_the_sample_first_turns_nothing_but_the_sample() -> None:
    first, second, spin = MaterialPoint("bingham", BINGHAM), MaterialPoint("bingham", BINGHAM), turned(0.6)
    for n in range(1, 101):
        first.step(shear_and_stretch(n / 100), 0.01)
        second.step(shear_and_stretch(n / 100) @ spin, 0.01)
    assert second.stress == pytest.approx(first.stress @ spin, abs=1e-13)
    assert second.energy == pytest.approx(first.energy, abs=1e-13)


@pytest.mark.parametrize("law", ["elastic", "bingham"])
def test_at_rest_and_purely_turned_there_is_no_stress(law: str) -> None:
    for angle in (0.0, 1e-9, 0.3, math.pi / 2, math.pi, 5.0):
        point = MaterialPoint(law, {"elastic": ELASTIC, "bingham": BINGHAM}[law])
        point.step(turned(angle), 1.0)
        assert point.stress == pytest.approx(np.zeros((2, 2)), abs=1e-15)
        assert point.width_stretch == pytest.approx(1, abs=1e-15)
        assert point.energy == pytest.approx(0, abs=1e-30)


def test_equal_principal_stretches() -> None:
    """Tau = E/(1 - nu) log(stretch) 1, and a disturbance of the equality is felt in proportion."""
    for stretch in [0.6, 0.9, 1 - 1e-12, 1 + 1e-12, 1.1, 1.8]:
        rest = MaterialPoint("elastic", ELASTIC)
        for disturbance in (0.0, 1e-16, 1e-12, 1e-8, 1e-6):
            for angle in (0.0, 0.4, math.pi / 4):
                point = copy.copy(rest)
                axes = turned(angle)
                point.step(axes @ np.diag([1 + disturbance, 1 - disturbance]) @ axes.T * stretch, 1.0)
                equal = E / (1 - NU) * (math.log(stretch) + math.log1p(-(disturbance**2)) / 2)
                deviator = E / (1 + NU) * math.atanh(disturbance) * axes @ np.diag([1, -1]) @ axes.T
                assert point.kirchhoff == pytest.approx(equal * np.eye(2) + deviator, abs=2e-15)


def test_equal_stretches_flow_into_the_width() -> None:
    """Equibiaxial tension flows as compression across: Lp_33 = -phi, the axes in the plane take half each."""
    point, rate, dt = MaterialPoint("bingham", BINGHAM), 0.05, 0.05
    for n in range(1, 301):
        point.step(np.eye(2) * math.exp(rate * n * dt), dt)
    tau = BINGHAM["yield_stress"] + BINGHAM["viscosity"] * 2 * rate
    assert point.kirchhoff == pytest.approx(tau * np.eye(2), rel=1e-10, abs=1e-12)
    assert point.rate == pytest.approx(2 * rate, rel=1e-10)


def test_compression_is_tension_with_the_other_sign() -> None:
    """Of the logarithmic law: principal stretches 1/lambda give -M, and the flow follows."""
    pulled, pressed = MaterialPoint("bingham", BINGHAM), MaterialPoint("bingham", BINGHAM)
    for n in range(1, 51):
        stretch = np.diag([math.exp(0.006 * n), math.exp(-0.002 * n)])
        pulled.step(stretch, 0.02)
        pressed.step(np.linalg.inv(stretch), 0.02)
    assert pressed.kirchhoff == pytest.approx(-pulled.kirchhoff, rel=1e-11)
    assert pressed.energy == pytest.approx(pulled.energy, rel=1e-11)
    assert pressed.width_stretch == pytest.approx(1 / pulled.width_stretch, rel=1e-11)
    assert pulled.work > 0


def test_what_is_inverted_or_not_finite_is_refused_and_leaves_the_point_alone() -> None:
    for wrong in [
        [[-1.0, 0], [0, 1]],
        [[0.0, 1], [1, 0]],
        [[1.0, 1], [1, 1]],
        [[0.0, 0], [0, 0]],
        [[math.nan, 0], [0, 1]],
        [[1.0, math.nan], [0, 1]],
        [[math.inf, 0], [0, 1]],
        [[1.0, math.inf], [0, 1]],
        [[1e200, 0], [0, 1e200]],
    ]:
        for law, constants in [("elastic", ELASTIC), ("bingham", BINGHAM)]:
            point = MaterialPoint(law, constants)
            point.step([[1.1, 0], [0, 1]], 0.1)
            state, stress, work = point.state.copy(), point.stress.copy(), point.work
            with pytest.raises(SoftcatError, match="no positive determinant, or it is not finite"):
                point.step(wrong, 0.1)
            assert np.array_equal(point.state, state)
            assert np.array_equal(point.stress, stress)
            assert point.work == work
