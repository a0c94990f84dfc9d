"""Surface tension against closed forms: strings, beams, beading threads, free ends that are pulled in."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import iv, ivp

import softcat_sym as sc
from tests.common.closed_forms import GYRATION
from tests.common.filaments import GEOMETRY, sag, scene
from tests.common.table import show
from tests.common.threads import INVISCID, evolve, growth, newtonian, thread
from tests.test_filament_effects import STRING, WEIGHT, pulled, string_sag

pytestmark = pytest.mark.slow

GRIDS = (20, 40, 80)
COMPILED = {"backend": "compiled"}


def lasting(duration: float, frames: int) -> dict[str, float]:
    return {"duration": duration, "frames": frames}


def closed(done: sc.Run) -> str:
    """How well its energy is closed."""
    assert done.outcome.is_success, done.summary["message"]
    assert done.summary["energy_residual"] < 1e-5
    return f"{done.summary['energy_residual']:.0e}"


def of_order_two(errors: list[float]) -> bool:
    return all(before / after == pytest.approx(4, rel=0.1) for before, after in pairwise(errors))


def test_strings_and_beams_are_exact_in_the_second_order() -> None:
    """Gam = 0.5, E = 50 in rho g L; F L^2/(EI) = 0, 4.4, 18, 71 of a clamped beam, (1 - (2/u) tanh(u/2))/(8 F)."""
    rows = []
    for section, power in (("circle", 0.5), ("rectangle", 0.5), ("sheet", 0.0)):
        modulus = 50.0 / (1 - 0.45**2) if section == "sheet" else 50.0
        expected, errors = string_sag(modulus, 0.5, power), []
        for cells in GRIDS:
            asked = scene(thickness=0.01, E=50.0 * WEIGHT, section=section, effects=STRING, cells=cells)
            errors.append(abs(sag(sc.simulate(pulled(asked, 0.5 * WEIGHT))) / expected - 1))
        rows.append((f"string, {section}", f"{expected:.7f}", *(f"{one:.2e}" for one in errors)))
        assert of_order_two(errors)
    h, E, tiny = 0.01, 1e8, 1e-7
    stiffness = GYRATION["circle"] * h**2 * E
    for number in (0.0, 4.4, 18.0, 71.0):
        u, errors = np.sqrt(number) / 2, []
        expected = (1 - 2 / u * np.tanh(u / 2)) / (8 * number) if number else 1 / 384
        for cells in GRIDS:
            effects = (*GEOMETRY, *(["surface-tension"] if number else []))
            asked = scene(thickness=h, E=E, section="circle", effects=effects, gravity=10 * tiny, cells=cells)
            found = sag(sc.simulate(pulled(asked, number * stiffness)))
            errors.append(found * stiffness / (1e4 * tiny) / expected - 1)
        rows.append((f"beam, F L^2/EI = {number}", f"{expected:.7f}", *(f"{one:.2e}" for one in errors)))
        assert of_order_two(errors)
    show("Error of the sag", ("", "exact", *(f"N = {cells}" for cells in GRIDS)), rows)


def rayleigh(kR: float) -> complex:
    return complex(np.sqrt(complex(kR * iv(1, kR) / iv(0, kR) * (1 - kR**2))))


def slender(kR: float, oh: float) -> complex:
    lost = 3 * oh * kR**2
    return complex((-lost + np.sqrt(complex(lost**2 + 2 * kR**2 * (1 - kR**2)))) / 2)


def chandrasekhar(k: float, oh: float) -> float:
    """Growth of a viscous cylinder (Hydrodynamic and hydromagnetic stability, section 111)."""

    def missed(omega: float) -> float:
        q = np.sqrt(k**2 + omega / oh)
        both = 2 * k * q / (k**2 + q**2) * iv(1, k) * ivp(1, q) / (iv(1, q) * ivp(1, k))
        viscous = 2 * k**2 * (k**2 + q**2) * ivp(1, k) / iv(0, k) * (1 - both) - k**4 + q**4
        return float(viscous - k * iv(1, k) / iv(0, k) * (1 - k**2) / oh**2)

    return float(brentq(missed, 1e-9, 1.0, xtol=1e-14))


def test_growth_of_waves_inviscid_and_viscous() -> None:
    """Slender dispersion relation, and the exact ones beside; 64 cells on half a wave."""
    rows, cells = [], 64
    for kR in (0.3, 0.5, 0.697, 0.8, 0.95, 1.2):
        found = growth(thread(2 * np.pi / kR, cells, INVISCID), 1, youngs_modulus=0.0)
        theory, exact = slender(kR, 0.0), rayleigh(kR)
        rows.append((0, kR, *(f"{one:.6f}" for one in (found, theory, exact)), f"{abs(theory / exact) - 1:.4f}"))
        assert abs(abs(found) / abs(theory) - 1) < 1e-3
        assert (found.real > 1e-9) == (kR < 1)
    for oh in (0.1, 1.0, 10.0):
        for kR in (0.2, 0.5, 0.697, 0.8, 0.95):
            found, theory = growth(thread(2 * np.pi / kR, cells, newtonian(3 * oh)), 1).real, slender(kR, oh).real
            exact = chandrasekhar(kR, oh)
            rows.append((oh, kR, *(f"{one:.6f}" for one in (found, theory, exact)), f"{theory / exact - 1:.4f}"))
            assert found / theory == pytest.approx(1, abs=2e-3 if kR > 0.9 else 5e-4)
            assert 0 < theory / exact - 1 < 0.06
    header = ("Oh", "kR", "package", "slender", "Rayleigh, Chandrasekhar", "slender - exact")
    show("Growth of a wave [sqrt(gamma/(rho R^3))]", header, rows)


def test_beads_of_half_a_wave() -> None:
    """From an amplitude of 1e-3 it grows as foretold; then beads, on ever finer grids, with its energy closed."""
    rows = []
    for oh in (0.1, 1.0):
        rate, ends = slender(0.5, oh).real, []
        for cells in (8, 16, 32):
            asked = thread(4 * np.pi, cells, newtonian(3 * oh), run=lasting(7 / rate, 29), numerics=COMPILED)
            done = evolve(asked, lambda X: 1 + 1e-3 * np.cos(2 * np.pi * X))
            wave = np.cos(2 * np.pi * done.data["X_cell"].values / asked.filament.span)
            grown = np.abs(done.data["stretch"].values @ wave)
            # From rest, a half of it decays at the other root.
            other = -rate - 3 * oh * 0.25
            t = done.data["time"].values[:9]
            expected = (rate * np.exp(other * t) - other * np.exp(rate * t)) / (rate - other)
            error = np.max(np.abs(grown[:9] / grown[0] / expected - 1))
            ends.append(float(done.data["stretch"].values[-1].max()))
            rows.append((oh, cells, f"{error:.1e}", f"{ends[-1]:.5f}", closed(done)))
            assert error < 0.2 / cells
        assert abs(ends[2] - ends[1]) < 0.5 * abs(ends[1] - ends[0])
        assert ends[2] > 1.8
    header = ("Oh", "cells", "error of the growth", "largest stretch at the end", "energy residual")
    show("A wave kR = 0.5 grows from 1e-3", header, rows)


def test_viscous_threads_with_a_free_end_and_between_plates() -> None:
    """R/R0 = 1 + Gam t/(2 eta) with a free end; drawn at a constant speed Q = A0 (eta s_t/s^2 + Gam s^-1/2)."""
    rows = []
    for inertia in (False, True):
        eta = 0.5 if not inertia else 5000.0
        asked = thread(20.0, 10, newtonian(eta), inertia=inertia, run=lasting(1.2 * eta, 4), numerics=COMPILED)
        done = sc.simulate(asked.replace({"ends.right": "free"}))
        thicker = done.data["thickness"].values.mean(axis=1) / 2
        rows.append(
            (
                f"free end, {'with' if inertia else 'no'} inertia",
                *(f"{one:.6f}" for one in thicker[1:]),
                closed(done),
            )
        )
        np.testing.assert_allclose(thicker, [1.0, 1.2, 1.4, 1.6], rtol=1e-4)
    drawn = thread(20.0, 10, newtonian(0.5), inertia=False, run=lasting(3.0, 4), numerics=COMPILED)
    done = sc.simulate(drawn.replace({"ends.motion": [["0 s", "0 m", "0 m"], ["3 s", "60 m", "0 m"]]}))
    s = 1 + done.data["time"].values
    force = done.data["axial_force"].values.mean(axis=1) / np.pi
    expected = 0.5 / s**2 + s**-0.5
    rows.append(("between plates, Q/Gam A0", *(f"{one:.6f}" for one in force[1:]), closed(done)))
    np.testing.assert_allclose(force[1:-1], expected[1:-1], rtol=1e-5)
    show("Viscous threads", ("", "1/3", "2/3", "1", "energy residual"), rows)


def test_a_free_end_runs_into_the_thread_at_kellers_speed() -> None:
    """v = sqrt(gamma/(rho R)), of a sheet sqrt(2 gamma/(rho h)); what it picks up is its pull times the time."""
    rows = []
    for section, mu, cells in (("circle", 0.3, 160), ("sheet", 0.3, 160)):
        asked = thread(
            60.0,
            cells,
            newtonian(3 * mu),
            run=lasting(30.0, 121),
            numerics=COMPILED,
            filament={"section": section},
        )
        done = sc.simulate(asked.replace({"ends.right": "free"}))
        x, time, X = (done.data[name].values for name in ("x", "time", "X_node"))
        mass = np.convolve(np.diff(X), [0.5, 0.5])
        inwards = (x[:-2] - x[2:]) / (time[2:] - time[:-2])[:, None]
        momentum = inwards @ mass
        centre = ((30.0 - x[1:-1]) * inwards) @ mass / momentum
        speed = np.polyfit(time[41:-1], centre[40:], 1)[0]
        rows.append((section, mu, f"{momentum[80] / time[81]:.6f}", f"{speed:.4f}", closed(done)))
        assert momentum[80] / time[81] == pytest.approx(1, abs=1e-5)
        assert speed == pytest.approx(1, abs=0.01)
    show(
        "Retraction",
        ("", "viscosity", "momentum/(Gam A0 t)", "speed/Keller's", "energy residual"),
        rows,
    )
