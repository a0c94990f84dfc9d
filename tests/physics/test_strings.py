"""Strings and cables, which carry their weight by tension alone: elastic and viscous."""

from __future__ import annotations

import numpy as np
import pytest

from .closed_forms import elastic_catenary, soft_catenary_sag, viscous_string_sag
from .scenes import extrapolated, run, sag, scene

WEIGHT = 1000.0 * 10.0
FULL = ("finite-stretch", "thinning", "large-rotation")


@pytest.mark.parametrize("E_star", [50.0, 1e3, 1e5])
def test_shallow_elastic_cable(E_star: float) -> None:
    """sag^3 = 3 rho g L^4/(64 E), with its prefactor: exact for the barest filament whatever E."""
    barest = (scene(thickness=0.01, E=E_star * WEIGHT, effects=("extensibility",), cells=n) for n in (20, 40))
    found = [sag(run(asked)) for asked in barest]
    prefactor = extrapolated(*(depth**3 * E_star for depth in found))
    print(f"E* = {E_star:g}: sag^3 E* = {prefactor:.8f}, 3/64 = {3 / 64:.8f}")
    assert prefactor == pytest.approx(3 / 64, rel=1e-6)


def test_shallow_cable_with_all_effects() -> None:
    """The same prefactor in the whole theory, bending included, for a stiff and thin filament."""
    E_star = 1e5
    asked = scene(thickness=1e-4, E=E_star * WEIGHT, effects=("bending", *FULL), cells=40)
    prefactor = sag(run(asked)) ** 3 * E_star
    print(f"sag^3 E* = {prefactor:.6f}, 3/64 = {3 / 64:.6f}")
    assert prefactor == pytest.approx(3 / 64, rel=5e-3)


def test_elastic_catenary_to_its_shape() -> None:
    """T = E A0 (s - 1) at any slope is the classical elastic catenary."""
    for E_star in [0.5, 5.0, 50.0, 1000.0]:
        coarse, fine = (
            run(scene(thickness=0.01, E=E_star * WEIGHT, effects=("large-rotation",), cells=cells))
            for cells in (20, 40)
        )
        assert coarse.outcome.is_success
        assert fine.outcome.is_success
        x, y = elastic_catenary(E_star, coarse.data["X_node"].values)
        worst = 0.0
        for name, exact in (("x", x), ("y", y)):
            found = extrapolated(coarse.data[name].values[-1], fine.data[name].values[-1, ::2])
            worst = max(worst, float(np.max(np.abs(found - exact))))
        print(f"E* = {E_star:g}: sag {-y.min():.5f} L, largest error of the shape {worst:.1e} L")
        assert worst < 1e-6 * -y.min()


@pytest.mark.parametrize("E_star", [3.0, 30.0, 1000.0])
def test_catenary_that_thins(E_star: float) -> None:
    """T = E A0 log(s)/s, by quadrature."""
    expected = soft_catenary_sag(E_star)
    error = (
        extrapolated(*(sag(run(scene(thickness=0.01, E=E_star * WEIGHT, effects=FULL, cells=n))) for n in (20, 40)))
        / expected
        - 1
    )
    print(f"E* = {E_star:g}: sag {expected:.6f} L, extrapolated {error:+.1e}")
    assert abs(error) < 1e-6


def viscous_string(*effects: str, E_star: float, final_sag: float) -> tuple[np.ndarray, np.ndarray, float]:
    """Times and sags of a quasi-static Maxwell string that should end at a given sag, and its viscosity."""
    eta = 1e6
    duration = final_sag**3 * 128 * eta / (9 * WEIGHT)
    done = run(
        scene(
            thickness=1e-4,
            E=E_star * WEIGHT,
            eta=eta,
            effects=("viscous-flow", *effects),
            duration=duration,
            frames=6,
            cells=40,
            rtol=1e-7,
        )
    )
    assert done.outcome.is_success, done.summary["message"]
    return done.data["time"].values, -done.data["midpoint"].values, eta


def test_shallow_maxwell_string_from_elastic_sag_to_creep() -> None:
    """The whole history, elastic sag, logarithm and one-third law, against its closed form."""
    E_star = 1e4
    t, found, eta = viscous_string(E_star=E_star, final_sag=0.03)
    expected = np.array([viscous_string_sag(time, E_star * WEIGHT, eta, WEIGHT) for time in t])
    print("Maxwell string:", np.array2string(found / expected - 1, precision=1))
    np.testing.assert_allclose(found, expected, rtol=2e-4)


@pytest.mark.parametrize("effects", [(), ("bending", *FULL)], ids=["bare", "all-effects"])
def test_viscous_string_prefactor(effects: tuple[str, ...]) -> None:
    """sag^3 = 9 rho g L^4 t/(128 eta) once the elastic sag is forgotten."""
    t, found, eta = viscous_string(*effects, E_star=1e8, final_sag=0.02)
    prefactor = found[1:] ** 3 * eta / (WEIGHT * t[1:])
    print(f"prefactor {prefactor}, 9/128 = {9 / 128:.6f}")
    np.testing.assert_allclose(prefactor, 9 / 128, rtol=5e-3)
