"""One section of the printed graph pulled at a constant rate: Trouton's tension, and what the closures make of it."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from softcat_sym.discretization.cell_printer import CellPrinter
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS

from .scenes import scene

E, ETA, RATE = 1e7, 1e4, 1.0
"""Relaxation time 1 ms, strained by 1 per second: Newtonian to 0.1 %."""


def pulled(closure: str, strains: np.ndarray) -> np.ndarray:
    """Tension per undeformed area at the given true strains, pulled at a constant true strain rate."""
    asked = scene(thickness=0.01, E=E, eta=ETA, closure=closure)
    equations = derive(choose_effects(asked).terms(), SECTIONS["rectangle"], closure)
    cell = CellPrinter(equations, {sy.E: E, sy.eta: ETA, sy.h0: 0.01})
    s, a_0, sigma_0 = ca.SX.sym("s"), ca.SX.sym("a_0"), ca.SX.sym("sigma_0")
    stress = ca.Function("stress", [s, a_0], [cell.stress(0, "stress_mean", {sy.s: s, sy.a_0: a_0})])
    tension = ca.Function("tension", [s, sigma_0], [cell.section("tension", {sy.s: s, sy.sigma_0: sigma_0})])
    flow = ca.Function("flow", [s, sigma_0], [cell.flow(0, s, sigma_0, ca.SX(0))["rate_mean"]])

    def rate(time: float, plastic: np.ndarray) -> np.ndarray:
        stretch = np.exp(RATE * time)
        return np.array([float(flow(stretch, stress(stretch, plastic[0])))])

    times = strains / RATE
    history = solve_ivp(rate, (0, times[-1]), [0.0], "Radau", times, rtol=1e-9, atol=1e-12)
    stretches = np.exp(strains)
    return np.array([float(tension(x, stress(x, a))) for x, a in zip(stretches, history.y[0], strict=True)])


def test_material_closure_gives_trouton_tension() -> None:
    """T = eta A s_t/s at any stretch, less what has not built up yet: 1 - exp(-t/tau)."""
    strains = np.array([0.001, 0.005, 0.2, 0.5, 1.0, 1.5])
    expected = ETA * RATE / np.exp(strains) * (1 - np.exp(-strains / RATE * E / ETA))
    found = pulled("material", strains)
    print("Trouton:", found / expected - 1)
    np.testing.assert_allclose(found, expected, rtol=1e-6)


def test_printed_closure_loses_its_tension_at_a_stretch_of_e() -> None:
    """T = eta A s_t/s (1 - log s): 20 % too small at 20 % strain, nothing at s = e, negative beyond."""
    strains = np.array([0.2, 0.5, 1.0, 1.5])
    found = pulled("printed", strains)
    print("printed over Trouton:", found / (ETA * RATE / np.exp(strains)))
    np.testing.assert_allclose(found / (ETA * RATE / np.exp(strains)), 1 - strains, atol=5e-3)
    assert found[0] == pytest.approx(0.8 * ETA * RATE / np.exp(0.2), rel=5e-3)
    assert found[3] < 0
