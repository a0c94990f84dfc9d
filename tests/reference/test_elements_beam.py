"""A clamped elastic strip under a small load against Timoshenko's beam: static sag and first period.

Beams do not know that a clamp keeps the material from swelling across where it bends: with Poisson's ratio 0.45 that
makes the strip stiffer by about 0.13 h/L in the sag. Without a Poisson's ratio the two agree ten times better.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from softcat_sym.reference.element_loop import Mesh, largest_frequency
from tests.acceptance.table import show
from tests.reference.strips import Floats, clamped_loop, timoshenko_frequency, timoshenko_sag

REISSNER = 5 / 6
_PERIODS, _SAMPLES = 3, 200


def cowper(poisson: float) -> float:
    return 10 * (1 + poisson) / (12 + 11 * poisson)


def swing(mesh: Mesh, thickness: float, poisson: float) -> tuple[float, float]:
    """Sag and frequency of the swing under sudden gravity, over Timoshenko's with kappa = 5/6."""
    sag = timoshenko_sag(thickness, 1.0, REISSNER, poisson)
    frequency = timoshenko_frequency(thickness, REISSNER, poisson)
    # A hundredth of the thickness: the tension of the swing is some 1e-4 of the bending force.
    gravity = 0.01 * thickness / sag
    loop = clamped_loop(mesh, thickness, gravity, poisson)
    interval = 2 * math.pi / frequency / _SAMPLES
    steps = math.ceil(interval * largest_frequency(loop.strip.size, poisson) / 1.8)
    loop.evaluate(0.0, 0.0)
    height = [0.0]
    for k in range(_PERIODS * _SAMPLES):
        loop.begin(k * interval, interval / steps, steps)
        loop.march(steps)
        height.append(loop.displacement[loop.strip.centreline[0], 1])
    mean, found = harmonic(interval * np.arange(len(height)), np.array(height), frequency)
    return -mean / (gravity * sag), found / frequency


def harmonic(time: Floats, height: Floats, near: float) -> tuple[float, float]:
    """Mean and frequency of the harmonic that fits best, in least squares."""

    def fit(omega: float) -> tuple[float, float]:
        basis = np.stack([np.ones_like(time), np.cos(omega * time), np.sin(omega * time)], axis=1)
        solution, residual, *_ = np.linalg.lstsq(basis, height, rcond=None)
        return float(residual[0]), float(solution[0])

    centre, reach = near, 0.04 * near
    while reach > 1e-7 * near:
        tried = np.linspace(centre - reach, centre + reach, 21)
        centre, reach = tried[np.argmin([fit(omega)[0] for omega in tried])], reach / 8
    return fit(centre)[1], centre


def compare(title: str, cases: list[tuple[Mesh, float, float]]) -> list[tuple[float, float]]:
    found = [swing(*case) for case in cases]
    rows = []
    for (mesh, thickness, nu), (sag, frequency) in zip(cases, found, strict=True):
        other = timoshenko_sag(thickness, 1, cowper(nu), nu) / timoshenko_sag(thickness, 1, REISSNER, nu)
        percent = [f"{100 * (ratio - 1):+.3f} %" for ratio in (sag, 1 / frequency, other)]
        rows.append((f"{mesh.along} x {mesh.through}, {mesh.grading:g}", thickness, nu, *percent))
    show(title, ["mesh, grading", "h/L", "nu", "sag", "period", "sag with Cowper's kappa"], rows)
    return found


def test_timoshenkos_formulas_become_the_thin_beams() -> None:
    thin = 4.730040744862704**2 * 1e-4 / math.sqrt(12)
    assert timoshenko_frequency(1e-4, REISSNER, 0.45) == pytest.approx(thin, rel=1e-6)
    assert timoshenko_sag(1e-4, 1.0, REISSNER, 0.45) == pytest.approx(1e8 / 32, rel=1e-6)
    # Huang (1961), clamped: shear and rotation lower the frequency, here by 0.7 %.
    assert timoshenko_frequency(0.03, REISSNER, 0.45) / timoshenko_frequency(1e-4, REISSNER, 0.45) < 0.994 * 300


def test_sag_and_period_of_the_papers_strip() -> None:
    sag, frequency = compare("Elements against Timoshenko", [(Mesh(32, 2, grading=4.0), 0.03, 0.45)])[0]
    assert sag == pytest.approx(1, abs=5e-3)
    assert frequency == pytest.approx(1, abs=3e-3)


def test_without_poissons_ratio_the_clamp_is_a_beams_clamp() -> None:
    sag, frequency = compare("Elements against Timoshenko, no Poisson's ratio", [(Mesh(32, 4), 0.1, 0.0)])[0]
    assert sag == pytest.approx(1, abs=1.2e-3)
    assert frequency == pytest.approx(1, abs=6e-4)


@pytest.mark.slow
def test_finer_meshes_stay_within_half_a_percent() -> None:
    cases = [(Mesh(a, t), 0.03, 0.45) for a, t in ((16, 2), (32, 4), (64, 4))]
    errors = [1 - sag for sag, _ in compare("Elements against Timoshenko", cases)]
    assert errors[0] > errors[1] > errors[2]
    assert max(errors[1:]) < 5e-3
