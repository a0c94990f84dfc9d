"""Surface tension against quadratures, closed forms and energy: nothing here shares a formula with the package."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.scene.scene import Scene

from .closed_forms import GYRATION
from .scenes import GEOMETRY, run, sag, scene

WEIGHT = 1000.0 * 10.0
THICKNESS = 0.01
STRING = ("finite-stretch", "thinning", "large-rotation", "surface-tension")


def pulled(asked: Scene, pull: float, **changes: Any) -> Scene:
    """With the surface tension whose axial force is `pull` [Pa] times the undeformed area."""
    h = float(asked.filament.thickness)
    side = {"circle": h / 2, "rectangle": 1 / (1 / h + 1 / asked.filament.width), "sheet": h / 2}
    gamma = float(pull) * side[asked.filament.section]
    return asked.replace({"surroundings.surface_tension": f"{gamma!r} N/m", **changes})


def string_sag(E: float, pull: float, power: float) -> float:
    """Sag/L of a string with Q = A0 (E log(s)/s + pull s^-power), over rho g L: exact, by quadrature."""

    def stretch(force: float) -> float:
        return float(brentq(lambda s: E * np.log(s) / s + pull * s**-power - force, 0.3, 2.0, xtol=1e-15))

    def across(H: float) -> float:
        return quad(lambda X: H * stretch(np.hypot(H, X)) / np.hypot(H, X), 0, 0.5, epsabs=1e-13)[0]

    H = brentq(lambda H: across(H) - 0.5, 0.1 * (pull + 1), 2 * pull + E / 4, xtol=1e-14)
    return quad(lambda X: X * stretch(np.hypot(H, X)) / np.hypot(H, X), 0, 0.5, epsabs=1e-13)[0]


@pytest.mark.parametrize("section", ["circle", "rectangle", "sheet"])
def test_string_with_the_pull_of_its_surface_is_exact_in_the_second_order(section: str) -> None:
    """Gam = 0.5 rho g L, E = 50 rho g L."""
    E, pull = 50.0, 0.5
    # A sheet is in plane strain across its width, which it keeps: so does the force of its surface.
    modulus = E / (1 - 0.45**2) if section == "sheet" else E
    expected = string_sag(modulus, pull, 0.0 if section == "sheet" else 0.5)
    found = []
    for cells in (20, 40, 80):
        asked = scene(thickness=THICKNESS, E=E * WEIGHT, section=section, effects=STRING, cells=cells)
        found.append(sag(run(pulled(asked, pull * WEIGHT))))
    errors = [abs(one / expected - 1) for one in found]
    print(f"{section}: sag {expected:.7f} L, errors {errors[0]:.1e} {errors[1]:.1e} {errors[2]:.1e}")
    assert errors[2] < 2e-5
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.05)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.05)


def test_the_pull_alone_holds_a_soft_string() -> None:
    """Sag rho g L^2/(8 Gam) as long as the modulus is no larger, to the mean strain of 3e-4."""
    asked = scene(thickness=THICKNESS, E=1250.0, effects=STRING, gravity=0.1, cells=80)
    assert sag(run(pulled(asked, 1250.0))) == pytest.approx(0.01, rel=5e-4)


@pytest.mark.parametrize("shear", [False, True], ids=["Kirchhoff", "Reissner"])
@pytest.mark.parametrize("number", [4.4, 18.0, 71.0])
def test_clamped_beam_with_the_pull_of_its_surface(number: float, shear: bool) -> None:
    """Sag (q L^2/8F) (1 - (2/u) tanh(u/2)), u = (L/2) sqrt(F/EI), F L^2/(EI) = `number`; second order in the cells."""
    h, E = 0.01, 1e8
    stiffness = GYRATION["circle"] * h**2 * E
    pull, tiny = number * stiffness, 1e-7
    u = np.sqrt(number) / 2
    expected = (1 - 2 / u * np.tanh(u / 2)) / (8 * number)
    effects = (*GEOMETRY, "surface-tension", *(("shear",) if shear else ()))
    errors = []
    for cells in (20, 40, 80):
        asked = scene(thickness=h, E=E, section="circle", effects=effects, gravity=10 * tiny, cells=cells)
        found = sag(run(pulled(asked, pull)))
        errors.append(found / (expected * 1000 * 10 * tiny / stiffness) - 1)
    # Shear, of the order (h/L)^2, is no error of the grid.
    left = errors[2] + (errors[2] - errors[1]) / 3
    print(f"F L^2/(EI) = {number}: errors {errors[0]:+.2e} {errors[1]:+.2e} {errors[2]:+.2e}, left {left:+.1e}")
    assert abs(left) < (3e-3 if shear else 1e-4)
    assert (errors[0] - errors[1]) / (errors[1] - errors[2]) == pytest.approx(4, rel=0.1)


def test_the_small_deflection_model_takes_it_as_one_tension() -> None:
    h, E, number = 0.01, 1e8, 18.0
    stiffness = GYRATION["circle"] * h**2 * E
    u = np.sqrt(number) / 2
    expected = (1 - 2 / u * np.tanh(u / 2)) / (8 * number) * 1e-3 / stiffness
    asked = scene(thickness=h, E=E, section="circle", effects="auto", gravity=1e-6, cells=80)
    small = pulled(asked, number * stiffness, **{"model": "small-deflection"}).replace({"load.ramp": "20 s"})
    done = run(small.replace({"run.duration": "40 s"}))
    assert "surface-tension" in done.summary["effects"]
    assert sag(done) == pytest.approx(expected, rel=1e-3)


def energy_closes(asked: Scene) -> sc.Trajectory:
    done = sc.simulate(asked)
    assert done.outcome.is_success, done.summary["message"]
    assert done.summary["energy_residual"] < 1e-5
    return done


@pytest.mark.parametrize("backend", ["interpreted", "compiled"])
@pytest.mark.parametrize("shear", [False, True], ids=["Kirchhoff", "Reissner"])
def test_energy_is_conserved(shear: bool, backend: str) -> None:
    """A heavy, soft filament with a profile swings: the energy of its surface is a tenth of what it trades."""
    effects = ["inertia", *GEOMETRY, "extensibility", "surface-tension", *(["shear"] if shear else [])]
    asked = scene(thickness=0.05, E=3e5, effects=tuple(effects), section="circle", cells=10, rtol=1e-8, frames=21)
    done = energy_closes(
        pulled(
            asked, 1e5, **{"filament.profile": [1.2, 0.8, 1.2], "numerics.backend": backend, "run.duration": "1.5 s"}
        )
    )
    energy = done.data["energy_surface"].values
    assert energy[0] == 0
    assert np.max(np.abs(energy)) > 0.1 * np.max(np.abs(done.data["energy_elastic"].values))


def test_the_energy_is_surface_tension_times_the_growth_of_the_area() -> None:
    """Lateral area of cones: 2 pi R0 sqrt(s) dX, of each cell, with its own R0."""
    asked = scene(thickness=0.05, E=3e5, effects=("inertia", *GEOMETRY, "surface-tension"), section="circle", cells=10)
    pinched = pulled(asked, 5e4, **{"filament.profile": [1.2, 0.8, 1.2], "numerics.rtol": 1e-6})
    done = sc.simulate(pinched)
    length, stretch = np.diff(done.data["X_node"].values), done.data["stretch"].values
    area = np.sum(2 * np.pi * done.data["thickness"].values / 2 * stretch * length, axis=1)
    grown = pinched.surroundings.surface_tension * (area - area[0])
    np.testing.assert_allclose(done.data["energy_surface"].values, grown, rtol=1e-10, atol=1e-18)


@pytest.mark.parametrize(("gam", "stops"), [(1.25, 1.25), (2.0, 2.0)])
def test_a_free_end_of_a_bingham_strand_is_pulled_in_until_it_holds(gam: float, stops: float) -> None:
    """A sigma = - pi gamma R at the free end: it thickens until R = gamma/sigma_Y, beyond the elastic strain."""
    E, limit, eta = 1e6, 1e4, 1e4
    asked = scene(
        thickness=0.02,
        E=E,
        eta=eta,
        yield_stress=limit,
        section="circle",
        gravity=0.0,
        ends=("clamped", "free"),
        effects=(
            "finite-stretch",
            "thinning",
            "large-rotation",
            "bending",
            "viscous-flow",
            "yielding",
            "surface-tension",
        ),
        duration=60.0,
        frames=7,
        cells=10,
    )
    done = sc.simulate(pulled(asked, gam * limit))
    assert done.outcome.is_success, done.summary["message"]
    thicker = done.data["thickness"].values[-1] / 0.02
    print(f"gamma/(R sigma_Y) = {gam}: R/R0 = {thicker.min():.5f} to {thicker.max():.5f}, expected {stops}")
    np.testing.assert_allclose(thicker, stops, rtol=1e-3)
    np.testing.assert_allclose(done.data["tension"].values[-1], -np.pi * gam * limit * 0.01**2 * thicker, rtol=1e-3)


def test_below_the_yield_stress_a_free_end_only_gives_elastically() -> None:
    asked = scene(
        thickness=0.02,
        E=1e6,
        eta=1e4,
        yield_stress=1e4,
        section="circle",
        gravity=0.0,
        ends=("clamped", "free"),
        effects=(
            "finite-stretch",
            "thinning",
            "large-rotation",
            "bending",
            "viscous-flow",
            "yielding",
            "surface-tension",
        ),
        duration=60.0,
        cells=10,
    )
    done = sc.simulate(pulled(asked, 0.7e4))
    # E log s/s = - Gam/sqrt(s)
    strained = brentq(lambda s: 1e6 * np.log(s) / s + 0.7e4 / np.sqrt(s), 0.9, 1)
    np.testing.assert_allclose(done.data["stretch"].values[-1], strained, rtol=1e-6)


@pytest.mark.parametrize("inertia", [True, False], ids=["inertia", "without inertia"])
def test_a_viscous_thread_with_a_free_end_thickens_at_gam_over_two_eta(inertia: bool) -> None:
    """R/R0 = 1 + Gam t/(2 eta) of a Newtonian thread."""
    asked = scene(thickness=0.02, E=1.0, section="circle", gravity=0.0, ends=("clamped", "free"), cells=10, frames=4)
    effects = ["extensibility", "bending", "finite-stretch", "thinning", "large-rotation", "viscous-stress"]
    thread = pulled(asked, 1e3).replace(
        {
            "material": {"law": "newtonian", "viscosity": "10 kPa*s"},
            "run.effects": [*effects, "surface-tension", *(["inertia"] if inertia else [])],
            "filament.density": "1 kg/m^3",
            "run.duration": "6 s",
            # There is no sag whose error could be estimated.
            "numerics.estimate": False,
        }
    )
    done = sc.simulate(thread)
    assert done.outcome.is_success, done.summary["message"]
    thicker = done.data["thickness"].values.mean(axis=1) / 0.02
    print(np.array2string(thicker, precision=5))
    np.testing.assert_allclose(thicker, [1.0, 1.1, 1.2, 1.3], rtol=2e-3)
