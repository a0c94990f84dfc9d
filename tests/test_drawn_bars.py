"""Filaments that a support draws: every law is its uniaxial solution, and none gains energy through a cycle."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np
import pytest

from tests.common import materials
from tests.common.rheology import GEOMETRY, flow_of, scene, solved
from tests.common.table import show

Laws = Mapping[str, tuple[dict[str, Any], materials.Bar]]

E1, ETA1 = 1e5, 3e4
DRAWN: Laws = {
    "maxwell": ({"youngs_modulus": E1, "viscosity": ETA1}, materials.maxwell(E1, ETA1)),
    "newtonian": ({"viscosity": ETA1}, materials.newtonian(ETA1)),
    "kelvin-voigt": ({"youngs_modulus": E1, "viscosity": ETA1}, materials.kelvin_voigt(E1, ETA1)),
    "herschel-bulkley": (
        {"youngs_modulus": E1, "viscosity": 1e4, "yield_stress": 5e3, "index": 0.5},
        materials.herschel_bulkley(E1, 1e4, 0.5, 5e3),
    ),
    "bingham": (
        {"youngs_modulus": E1, "viscosity": 1e4, "yield_stress": 5e3},
        materials.bingham(E1, 1e4, 5e3),
    ),
    "power-law": ({"youngs_modulus": E1, "viscosity": 1e4, "index": 0.5}, materials.power_law(E1, 1e4, 0.5)),
    "standard-linear": (
        {"youngs_modulus": E1, "second_modulus": 2e5, "viscosity": ETA1},
        materials.standard_linear(E1, 2e5, ETA1),
    ),
    "multimode-maxwell": (
        {"modes": [{"youngs_modulus": 1e5, "viscosity": 1e4}, {"youngs_modulus": 3e4, "viscosity": 3e4}]},
        materials.multimode([(1e5, 1e4), (3e4, 3e4)]),
    ),
}


def judge_drawn(laws: Iterable[str]) -> None:
    """Out to 1.6 times the length in 1 s, then held; tension and stretch of every cell, without gravity."""
    thickness, motion, rows = 0.02, [(0, 0, 0), (1, 0.6, 0)], []
    path = materials.Drawing(tuple((float(t), 1 + x) for t, x, _ in motion))
    for law in laws:
        constants, bar = DRAWN[law]
        asked = scene(
            {"law": law, **constants},
            {"thickness": thickness},
            effects=(*GEOMETRY, *flow_of(law)),
            ends={"motion": motion},
            load={"gravity": 0.0},
            run={"duration": 1.5, "frames": 16},
            cells=5,
            rtol=1e-8,
        )
        data = solved(asked)
        time, found = data["time"].values, data["tension"].values
        exact = materials.tension(bar, path, time, thickness**2)
        # At a sudden change of speed a viscous stress has two values.
        steady = np.abs(time - 1.0) > 1e-9
        error = np.abs(found[1:] - exact[1:, None]).max(axis=1)[steady[1:]] / np.abs(exact).max()
        rows.append([law, f"{exact.max():.6f}", f"{exact[-1]:.6f}", f"{error.max():.1e}"])
        assert error.max() < 1e-5, law
        np.testing.assert_allclose(data["stretch"].values, path.stretch(time)[:, None] + 0 * found, rtol=1e-6)
    show("drawn bridges", ("law", "largest tension [N]", "in the end", "largest error"), rows)


def test_drawn_bridge_is_its_uniaxial_solution() -> None:
    judge_drawn(["herschel-bulkley"])


def test_troutons_ratio_on_a_bar_drawn_to_twice_its_length() -> None:
    """T s/(A0 eps_t) = 3 mu, from the shear viscosity in the scene, with the section of constant volume."""
    mu, thickness, rows = 100.0, 0.02, []
    for ends in ("clamped", "pinned"):
        asked = scene(
            {"law": "newtonian", "shear_viscosity": mu},
            {"thickness": thickness},
            effects=(*GEOMETRY, "viscous-stress"),
            ends={"left": ends, "right": ends, "motion": [(0, 0, 0), (1, 1, 0)]},
            load={"gravity": 0.0},
            run={"duration": 0.9999, "frames": 6},
            rtol=1e-6,
        )
        data = solved(asked)
        length = 1 + data["time"].values
        stretch, tension = data["stretch"].values, data["tension"].values
        ratio = (tension * stretch / thickness**2).T / (mu / length)
        rows += [[ends, f"{s:.3f}", f"{r.min():.9f}", f"{r.max():.9f}"] for s, r in zip(length, ratio.T, strict=True)]
        np.testing.assert_allclose(stretch.T, np.broadcast_to(length, stretch.T.shape), rtol=1e-6)
        np.testing.assert_allclose(ratio[:, 1:], 3, rtol=1e-6)
    show("Trouton's ratio", ("ends", "stretch", "least over the cells", "largest"), rows)


E, YIELD, ETA = 1e6, 5e3, 5e4
CYCLE = [(0, 0, 0), (0.25, 0.03, 0), (0.75, -0.02, 0), (1.25, 0.03, 0), (1.5, 0.02, 0)]
"""Time, and displacement of the right support; half of the span's Euler strain in compression."""
BEYOND = {"youngs_modulus": E, "viscosity": ETA, "yield_stress": YIELD}
CUSTOM = {
    "youngs_modulus": E,
    "flow": "sign(sigma)*max(abs(sigma) - s0, 0)/e0",
    "parameters": {"s0": f"{YIELD!r} Pa", "e0": f"{ETA!r} Pa*s"},
}
CYCLED: Laws = {
    "bingham": ({"law": "bingham", **BEYOND}, materials.bingham(E, ETA, YIELD)),
    "herschel-bulkley, n = 0.5": (
        {"law": "herschel-bulkley", **BEYOND, "index": 0.5},
        materials.herschel_bulkley(E, ETA, 0.5, YIELD),
    ),
    "herschel-bulkley, n = 1.5": (
        {"law": "herschel-bulkley", **BEYOND, "index": 1.5},
        materials.herschel_bulkley(E, ETA, 1.5, YIELD),
    ),
    "custom": ({"law": "custom", **CUSTOM}, materials.bingham(E, ETA, YIELD)),
}
ROUNDING = 1e-7
"""Least increment of the dissipated energy, over all of it: a method of high order has weights of both signs."""


def cycled(law: str, gravity: float, more: tuple[str, ...] = (), **asked: Any) -> Any:
    """Data of a filament that is pulled out, pushed into compression, and pulled out again."""
    effects = (*GEOMETRY, *flow_of("bingham"), *more)
    run, load = {"duration": 1.5, "frames": 61}, {"gravity": gravity}
    material, filament = CYCLED[law][0], {"thickness": 0.1}
    return solved(scene(material, filament, effects=effects, ends={"motion": CYCLE}, load=load, run=run, **asked))


@pytest.mark.slow
def test_straight_bar_through_loading_reversal_and_reloading() -> None:
    """Without gravity: tension and dissipation against the uniaxial solution, too."""
    path, area, rows = materials.Drawing(tuple((float(t), 1 + x) for t, x, _ in CYCLE)), 0.1**2, []
    for law, (_, bar) in CYCLED.items():
        data = cycled(law, 0.0, cells=5, rtol=1e-7)
        time, found = data["time"].values, data["energy_dissipated"].values
        sigma, lost = materials.respond(bar, path, time)
        tension = area * sigma / path.stretch(time)
        error = float(np.max(np.abs(data["tension"].values - tension[:, None])) / np.max(tension))
        least, loss = float(np.min(np.diff(found)) / found[-1]), float(found[-1] / (area * lost[-1]) - 1)
        rows.append([law, f"{found[-1]:.6f}", f"{loss:+.1e}", f"{least:+.1e}", f"{error:.1e}", f"{tension.min():.3f}"])
        assert tension.min() < -0.5 * tension.max()
        assert least > -ROUNDING and error < 1e-5 and abs(loss) < 3e-5, rows[-1]
    head = ("law", "dissipated [J]", "error", "least increment, relative", "tension, error", "T_min [N]")
    show("straight bars through a cycle", head, rows)


def judge_heavy(cases: Iterable[tuple[str, bool]]) -> None:
    """Bending, tension and reversal at once: dissipation never decreases, the energy audit closes."""
    rows = []
    for law, with_inertia in cases:
        data = cycled(law, 2.0, ("inertia",) if with_inertia else (), cells=10, rtol=1e-5)
        found, work = data["energy_dissipated"].values, data["work_external"].values
        least = float(np.min(np.diff(found)) / found[-1])
        balance = sum(data[f"energy_{one}"].values for one in ("kinetic", "elastic", "potential", "dissipated")) - work
        residual = float(np.ptp(balance) / np.max(np.abs(work)))
        rows.append([law, "inertia" if with_inertia else "", f"{found[-1]:.5f}", f"{least:+.1e}", f"{residual:.1e}"])
        assert float(data["yielded_fraction"].max()) > 0
        assert least > -ROUNDING and residual < 0.01, rows[-1]
    show("heavy filaments", ("law", "", "dissipated [J]", "least increment, relative", "energy residual"), rows)


@pytest.mark.slow
def test_heavy_filament_through_the_same_cycle() -> None:
    judge_heavy([("herschel-bulkley, n = 0.5", False), ("bingham", True)])


def judge_elastic_cycle(gravity: float) -> None:
    """Quasi-static, out and back twice: the work of the support returns to nothing."""
    motion = [(0, 0, 0), (0.25, 0.1, 0.05), (0.75, -0.01, 0), (1.0, 0, 0), (1.25, 0.05, -0.05), (1.5, 0, 0)]
    asked = scene(
        {"law": "elastic", "youngs_modulus": E},
        {"thickness": 0.1},
        effects=GEOMETRY,
        ends={"motion": motion},
        load={"gravity": gravity},
        run={"duration": 1.5, "frames": 241},
        cells=10,
    )
    data = solved(asked)
    work, largest = data["work_external"].values, np.max(np.abs(data["work_external"].values))
    left = [float(abs(work[np.argmin(np.abs(data["time"].values - t))]) / largest) for t in (1.0, 1.5)]
    stored = data["energy_elastic"].values + data["energy_potential"].values
    audit = float(np.max(np.abs(stored - stored[0] - work)) / largest)
    head = ("g", "largest work [J]", "left after the first cycle", "after the second", "work against stored energy")
    show("elastic cycle", head, [[gravity, f"{work.max():.5f}", *(f"{one:.1e}" for one in left), f"{audit:.1e}"]])
    assert max(left) < 1e-6 and audit < 1e-6


def test_a_closed_elastic_cycle_loses_nothing() -> None:
    judge_elastic_cycle(10.0)
