"""Beams: static sag for every pair of ends, stretching columns, large deflections, viscous creep."""

from __future__ import annotations

import numpy as np
import pytest

from .closed_forms import BEAM_CONSTANT, GYRATION, soft_beam_sag, von_karman_sag
from .scenes import GEOMETRY, extrapolated, run, sag, scene

TINY = 2e-5
"""Sag of the linear beams, over the span: a thousandth of their thickness."""


def test_static_sag_of_a_linear_beam() -> None:
    for section in ["rectangle", "circle"]:
        for ends in list(BEAM_CONSTANT):
            thickness, weight = 0.02, 1000.0 * 10.0
            E = weight / (BEAM_CONSTANT[ends] * GYRATION[section] * thickness**2 * TINY)
            found = [
                sag(run(scene(thickness=thickness, E=E, section=section, ends=ends, effects=GEOMETRY, cells=cells)))
                for cells in (20, 40)
            ]
            error = extrapolated(*found) / TINY - 1
            print(f"{'-'.join(ends)} {section}: N = 40 {found[1] / TINY - 1:+.1e}, extrapolated {error:+.1e}")
            assert abs(found[1] / TINY - 1) < 2e-3
            assert abs(error) < 1e-4


COLUMN = {1e5: 0.139709, 1e6: 0.062621, 1e7: 0.025403, 1e8: 0.005982}
"""E [Pa] to sag [m], small strain and slope: rod of 636.62 kg/m^3, R = 0.01 m, L = 1 m, g = 9.80665 m/s^2."""


def column_sag(E: float, effects: tuple[str, ...], cells: int) -> float:
    asked = scene(thickness=0.02, E=E, section="circle", density=636.62, gravity=9.80665, effects=effects, cells=cells)
    return sag(run(asked))


def test_table_of_the_column_is_von_karmans() -> None:
    for E, printed in COLUMN.items():
        assert von_karman_sag(E, GYRATION["circle"] * 0.02**2, 636.62 * 9.80665) == pytest.approx(printed, abs=6e-7)


def test_small_strain_column_is_von_karmans() -> None:
    """Without large rotation, finite stretch and thinning the package solves von Karman's equations.

    The softer the column, the thinner the layers at its clamps: 2 cells of N = 40 at 1e5 Pa.
    """
    for E, tolerance in [(1e8, 1e-5), (1e7, 5e-5), (1e6, 3e-4), (1e5, 1.5e-3)]:
        expected = von_karman_sag(E, GYRATION["circle"] * 0.02**2, 636.62 * 9.80665)
        error = extrapolated(*(column_sag(E, ("bending", "extensibility"), cells) for cells in (20, 40))) / expected - 1
        print(f"E = {E:.0e} Pa: extrapolated {error:+.1e}")
        assert abs(error) < tolerance


def test_soft_column_leaves_von_karman_by_its_strain() -> None:
    """The full theory is softer: its section thins and its strain is true strain, 5 % of it at 1e5 Pa."""
    for E, low, high in [(1e8, 0, 0.002), (1e7, 0, 0.005), (1e6, 0.005, 0.02), (1e5, 0.04, 0.07)]:
        error = extrapolated(*(column_sag(E, GEOMETRY, cells) for cells in (20, 40))) / COLUMN[E] - 1
        print(f"E = {E:.0e} Pa: {error:+.2%} from von Karman, mean strain {8 / 3 * COLUMN[E] ** 2:.2%}")
        assert low < error < high


@pytest.mark.parametrize(
    ("E_star", "delta", "section"), [(10.0, 0.05, "rectangle"), (20.0, 0.05, "circle"), (300.0, 0.03, "rectangle")]
)
def test_large_deflection_against_a_boundary_value_solver(E_star: float, delta: float, section: str) -> None:
    expected = soft_beam_sag(E_star, delta, GYRATION[section])
    found = [
        sag(run(scene(thickness=delta, E=E_star * 1e4, section=section, effects=GEOMETRY, cells=cells)))
        for cells in (20, 40)
    ]
    error = extrapolated(*found) / expected - 1
    fine = found[1] / expected - 1
    print(f"E* = {E_star:g}, {section}: sag {expected:.6f} L, N = 40 {fine:+.1e}, extrapolated {error:+.1e}")
    assert abs(error) < 3e-4


def test_creep_of_a_clamped_viscous_beam_of_circular_section() -> None:
    """sag = rho g L^4 t/(72 mu D^2) with the shear viscosity mu, on top of the elastic sag."""
    D, mu, E, weight = 0.02, 1e9, 1e12, 1000.0 * 10.0
    duration = 72 * mu * D**2 * TINY / weight
    asked = scene(
        thickness=D,
        E=E,
        eta=3 * mu,
        section="circle",
        effects=(*GEOMETRY, "viscous-flow"),
        duration=duration,
        frames=5,
        cells=40,
        rtol=1e-6,
    )
    done = run(asked)
    assert done.outcome.is_success
    t, found = done.data["time"].values, -done.data["midpoint"].values
    expected = weight * t / (72 * mu * D**2) + weight / (24 * E * D**2)
    print("creep of a viscous beam:", found / expected - 1)
    np.testing.assert_allclose(found, expected, rtol=2e-3)


def test_beam_bending_viscometer() -> None:
    """ASTM C598 without a load: mu = g L^3/(2.4 I v) rho A L/1.6, v in midpoint travel per minute; pinned ends."""
    D, mu, L, rho, g = 3e-3, 1e12, 0.05, 2500.0, 9.81
    asked = scene(
        span=L,
        thickness=D,
        section="circle",
        density=rho,
        gravity=g,
        E=70e9,
        eta=3 * mu,
        ends=("pinned", "pinned"),
        effects=(*GEOMETRY, "viscous-flow"),
        duration=600.0,
        frames=3,
        cells=40,
        rtol=1e-6,
    )
    done = run(asked)
    assert done.outcome.is_success
    heights = done.data["midpoint"].values
    speed = (heights[1] - heights[2]) / 300 * 60
    area, second_moment = np.pi * D**2 / 4, np.pi * D**4 / 64
    found = g * L**3 / (2.4 * second_moment * speed) * rho * area * L / 1.6
    print(f"viscometer: {found:.5e} Pa s, {found / mu - 1:+.1e}")
    assert found == pytest.approx(mu, rel=2e-3)
