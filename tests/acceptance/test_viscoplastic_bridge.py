"""The rigid-viscoplastic bridge, of which Balmforth & Hewitt (2013) published the theory, as the limit of ours.

The equations and the solver are ``rigid_viscoplastic_bridge``'s, derived here; of the publication no number is used.
The filament has an elastic modulus and exact geometry: it must tend to the rigid bridge as eps_Y = sY/E goes to zero,
in proportion to it, up to what small slope leaves out, some (4 H/L)^2, and fibres resolve. In the groups of the
bridge, Gamma = (rho g L/sY)/(h/L), the elasticity is eps_Y (L/h)^2: the elastic sag over h is 5/32 Gamma times it.
"""

from __future__ import annotations

import numpy as np
import pytest

from .rheology import GEOMETRY, Array, scene, solved
from .rigid_viscoplastic_bridge import Bridge, first_speed, section_rates
from .table import show

EFFECTS = (*GEOMETRY, "extensibility", "viscous-flow", "yielding", "fibres")
GAMMA, SLENDERNESS, STRESS = 8.0, 0.01, 1e4
"""Load; h/L; rho g L [Pa] with L = 1 m."""
ELASTICITIES = (0.04, 0.02, 0.01, 0.005)


def test_section_law_inverts_its_means() -> None:
    """Tension and moment of the rates, summed over fibres, are those that were asked; rigid below yield."""
    zeta, weight = np.polynomial.legendre.leggauss(2000)
    rng = np.random.default_rng(3)
    for n in (0.0, 0.3, 0.9, 1.0, 1.4):
        m = rng.uniform(-2, 2, 40)
        e, k = section_rates(n, m)
        rate = e[:, None] + k[:, None] * zeta
        stress = np.sign(rate) + rate
        flows = (e != 0) | (k != 0)
        assert np.array_equal(flows, (np.abs(m) > (1 - n**2) / 2) if n < 1 else np.full(40, n > 1) | (m != 0))
        assert stress[flows] @ weight / 2 == pytest.approx(n, abs=2e-3)
        assert (stress[flows] * zeta) @ weight / 2 == pytest.approx(m[flows], abs=2e-3)


@pytest.mark.parametrize(("clamped", "load"), [(False, 2.0), (True, 4.0)])
def test_bridge_falls_above_its_collapse_load_only(clamped: bool, load: float) -> None:
    """8 M_p/L^2 between pins and 16 M_p/L^2 between clamps are Gamma = 2 and 4."""
    for gamma, falls in ((0.99 * load, False), (1.01 * load, True)):
        bridge = Bridge(gamma, clamped, 400)
        assert bool(bridge.rates(0.0, np.zeros_like(bridge.xi))[0] > 1e-7) is falls


def test_bridge_starts_at_its_closed_form_speed() -> None:
    for gamma in (3.0, GAMMA, 30.0):
        bridge = Bridge(gamma, clamped=False)
        assert bridge.rates(0.0, np.zeros_like(bridge.xi))[0] == pytest.approx(first_speed(gamma), rel=1e-4)


def filament_sag(elasticity: float, ends: str, times: Array, fibres: int) -> Array:
    """Sag over h of the filament at times of the bridge, equally spaced from the start, which is left out."""
    yield_stress = STRESS / (GAMMA * SLENDERNESS)
    material = {
        "law": "bingham",
        "youngs_modulus": yield_stress / (elasticity * SLENDERNESS**2),
        "viscosity": yield_stress / SLENDERNESS**2,
        "yield_stress": yield_stress,
    }
    asked = scene(
        material,
        {"thickness": SLENDERNESS},
        effects=EFFECTS,
        ends={"left": ends, "right": ends},
        run={"duration": times[-1], "frames": len(times) + 1},
        cells=40,
        rtol=1e-5,
    )
    numerics = asked.numerics.model_copy(update={"grading": None, "fibres": fibres})
    return -solved(asked.model_copy(update={"numerics": numerics}))["midpoint"].values[1:] / SLENDERNESS


@pytest.mark.slow
@pytest.mark.parametrize(
    ("ends", "fibres", "end", "left"),
    # A clamp's hinge turns within a few cells, all of its fibres at the yield stress: it takes more of them.
    [("pinned", 8, 3.0, 2e-3), ("clamped", 24, 6.0, 1e-2)],
)
def test_filament_tends_to_the_rigid_bridge(ends: str, fibres: int, end: float, left: float) -> None:
    times = end * np.arange(1, 7) / 6
    rigid = Bridge(GAMMA, ends == "clamped").sag(times)
    misses = np.array([filament_sag(e, ends, times, fibres) / rigid - 1 for e in ELASTICITIES])
    limit = 2 * misses[-1] - misses[-2]
    steps = misses[:-1] - misses[1:]
    rates = np.log2(steps[:-1] / steps[1:])
    rows = [["rigid, W = sag/h", *(f"{value:.4f}" for value in rigid)]]
    rows += [
        [f"eps_Y (L/h)^2 = {e:g}", *(f"{m:+.2%}" for m in miss)] for e, miss in zip(ELASTICITIES, misses, strict=True)
    ]
    rows += [["extrapolated to none", *(f"{m:+.2%}" for m in limit)], ["rate", *(f"{rate:.2f}" for rate in rates[-1])]]
    header = ("t sY/eta (L/h)^2", *(f"{t:g}" for t in times))
    show(f"bridge between {ends} ends, Gamma = {GAMMA:g}", header, rows)
    assert np.max(np.abs(limit)) < left
    assert np.all(np.diff(np.abs(misses[:, 0])) < 0)
    # The earliest time, where elasticity counts most, shows its rate best.
    assert rates[:, 0] == pytest.approx(1, abs=0.15)
