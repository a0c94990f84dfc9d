"""Plastic collapse by every theory; and the rigid-viscoplastic bridge, as the limit of a filament without elasticity.

Balmforth & Hewitt (2013) published the bridge's theory. Its equations and solver are ``rigid_bridge``'s, derived here;
of the publication no number is used.
The filament has an elastic modulus and exact geometry: it must tend to the rigid bridge as eps_Y = sY/E goes to zero,
in proportion to it, up to what small slope leaves out, some (4 H/L)^2, and fibres resolve. In the groups of the
bridge, Gamma = (rho g L/sY)/(h/L), the elasticity is eps_Y (L/h)^2: the elastic sag over h is 5/32 Gamma times it.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.common.rheology import GEOMETRY, Array, scene, solved
from tests.common.rigid_bridge import Bridge
from tests.common.table import show
from tests.test_plastic_collapse import QUASI_STATIC, Theory, judge

pytestmark = pytest.mark.slow

FIBRES = (*QUASI_STATIC, "fibres")
EFFECTS = (*GEOMETRY, "extensibility", "viscous-flow", "yielding", "fibres")
GAMMA, SLENDERNESS, STRESS = 8.0, 0.01, 1e4
"""Load; h/L; rho g L [Pa] with L = 1 m."""
ELASTICITIES = (0.04, 0.02, 0.01, 0.005)


def test_every_theory_collapses_where_it_should() -> None:
    """More fibres, no shear, a circle, the program's own choice and the published list, both with inertia."""
    theories = [
        (Theory("6 fibres", FIBRES, 10, 0.02, fibres=6), 5e-3),
        (Theory("6 fibres", FIBRES, 20, 0.02, fibres=6), 5e-3),
        (Theory("6 fibres", FIBRES, 40, 0.02, fibres=6), 5e-3),
        (Theory("12 fibres", FIBRES, 20, 0.02, fibres=12), 5e-3),
        (Theory("circle, 6 fibres", (*QUASI_STATIC, "shear", "fibres"), 20, 0.02, "circle", 6), 5e-3),
        (Theory("auto", "auto", 20, 0.1), 5e-3),
        (Theory("paper, rectangle", "paper", 40, 1e-3, "rectangle", linear=True), 3e-2),
        (Theory("paper, circle", "paper", 40, 1e-3, "circle", linear=True), 3e-2),
    ]
    judge(theories)


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


# A clamp's hinge turns within a few cells, all of its fibres at the yield stress: it takes more of them.
@pytest.mark.parametrize(("ends", "fibres", "end", "left"), [("pinned", 8, 3.0, 2e-3), ("clamped", 24, 6.0, 1e-2)])
def test_filament_tends_to_the_rigid_bridge(ends: str, fibres: int, end: float, left: float) -> None:
    times = end * np.arange(1, 7) / 6
    rigid = Bridge(GAMMA, ends == "clamped").sag(times)
    misses = np.array([filament_sag(e, ends, times, fibres) / rigid - 1 for e in ELASTICITIES])
    limit = 2 * misses[-1] - misses[-2]
    steps = misses[:-1] - misses[1:]
    rates = np.log2(steps[:-1] / steps[1:])
    rows = [["rigid, W = sag/h", *(f"{value:.4f}" for value in rigid)]]
    for name, values in zip([f"eps_Y (L/h)^2 = {e:g}" for e in ELASTICITIES], misses, strict=True):
        rows.append([name, *(f"{value:+.2%}" for value in values)])
    rows += [["extrapolated to none", *(f"{m:+.2%}" for m in limit)], ["rate", *(f"{rate:.2f}" for rate in rates[-1])]]
    header = ("t sY/eta (L/h)^2", *(f"{t:g}" for t in times))
    show(f"bridge between {ends} ends, Gamma = {GAMMA:g}", header, rows)
    assert np.max(np.abs(limit)) < left
    assert np.all(np.diff(np.abs(misses[:, 0])) < 0)
    # The earliest time, where elasticity counts most, shows its rate best.
    assert rates[:, 0] == pytest.approx(1, abs=0.15)
