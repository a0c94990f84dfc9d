"""Out, back into compression, and out again: no law gains energy, and an elastic filament loses none."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

from tests.common import materials
from tests.marks import few

from .rheology import GEOMETRY, flow_of, scene, solved
from .table import show

E, YIELD = 1e6, 5e3
ETA = 5e4
CYCLE = [(0, 0, 0), (0.25, 0.03, 0), (0.75, -0.02, 0), (1.25, 0.03, 0), (1.5, 0.02, 0)]
"""Time, and displacement of the right support; half of the span's Euler strain in compression."""
SPRING = {"youngs_modulus": E}
BEYOND = {**SPRING, "viscosity": ETA, "yield_stress": YIELD}
LAWS: dict[str, tuple[dict[str, Any], materials.Bar]] = {
    "bingham": ({"law": "bingham", **BEYOND}, materials.bingham(E, ETA, YIELD)),
    "herschel-bulkley, n = 0.5": (
        {"law": "herschel-bulkley", **BEYOND, "index": 0.5},
        materials.herschel_bulkley(E, ETA, 0.5, YIELD),
    ),
    "herschel-bulkley, n = 1.5": (
        {"law": "herschel-bulkley", **BEYOND, "index": 1.5},
        materials.herschel_bulkley(E, ETA, 1.5, YIELD),
    ),
    "custom": (
        {
            "law": "custom",
            **SPRING,
            "flow": "sign(sigma)*max(abs(sigma) - s0, 0)/e0",
            "parameters": {"s0": f"{YIELD!r} Pa", "e0": f"{ETA!r} Pa*s"},
        },
        materials.bingham(E, ETA, YIELD),
    ),
}
ROUNDING = 1e-7
"""Least increment of the dissipated energy, over all of it: a method of high order has weights of both signs."""


@pytest.mark.parametrize("name", list(LAWS))
def test_straight_bar_through_loading_reversal_and_reloading(name: str) -> None:
    """Without gravity: tension and dissipation against the uniaxial solution, too."""
    material, bar = LAWS[name]
    thickness = 0.1
    asked = scene(
        material,
        {"thickness": thickness},
        effects=(*GEOMETRY, *flow_of("bingham")),
        ends={"motion": CYCLE},
        load={"gravity": 0.0},
        run={"duration": 1.5, "frames": 61},
        cells=5,
        rtol=1e-7,
    )
    data = solved(asked)
    path = materials.Drawing(tuple((float(t), 1 + x) for t, x, _ in CYCLE))
    time, area = data["time"].values, thickness**2
    sigma, lost = materials.respond(bar, path, time)
    tension = area * sigma / path.stretch(time)
    error = float(np.max(np.abs(data["tension"].values - tension[:, None])) / np.max(tension))
    found = data["energy_dissipated"].values
    least = float(np.min(np.diff(found)) / found[-1])
    loss = float(found[-1] / (area * lost[-1]) - 1)
    head = ("dissipated [J]", "error", "least increment, relative", "tension, error", "T_max [N]", "T_min [N]")
    row = [f"{found[-1]:.6f}", f"{loss:+.1e}", f"{least:+.1e}", f"{error:.1e}", tension.max(), tension.min()]
    show(f"{name}: bar", head, [[f"{cell:.3f}" if isinstance(cell, float) else cell for cell in row]])
    assert tension.min() < -0.5 * tension.max()
    assert least > -ROUNDING
    assert error < 1e-5
    assert abs(loss) < 3e-5


@pytest.mark.parametrize(
    ("name", "with_inertia"), few(product(LAWS, (False, True)), ("herschel-bulkley, n = 0.5", False), ("bingham", True))
)
def test_heavy_filament_through_the_same_cycle(name: str, with_inertia: bool) -> None:
    """Bending, tension and reversal at once: dissipation never decreases, the energy audit closes."""
    material, _ = LAWS[name]
    names = (*GEOMETRY, *flow_of("bingham"), *(("inertia",) if with_inertia else ()))
    asked = scene(
        material,
        {"thickness": 0.1},
        effects=names,
        ends={"motion": CYCLE},
        load={"gravity": 2.0},
        run={"duration": 1.5, "frames": 61},
        cells=10,
        rtol=1e-5,
    )
    data = solved(asked)
    found = data["energy_dissipated"].values
    least = float(np.min(np.diff(found)) / found[-1])
    stored = ("kinetic", "elastic", "potential", "dissipated")
    balance = sum(data[f"energy_{one}"].values for one in stored) - data["work_external"].values
    residual = float(np.ptp(balance) / np.max(np.abs(data["work_external"].values)))
    yielded = float(data["yielded_fraction"].max())
    head = ("dissipated [J]", "least increment, relative", "energy residual", "largest yielded share")
    show(f"{name}: heavy filament", head, [[f"{found[-1]:.5f}", f"{least:+.1e}", f"{residual:.1e}", f"{yielded:.2f}"]])
    assert yielded > 0
    assert least > -ROUNDING
    assert residual < asked.run.accuracy


@pytest.mark.parametrize("gravity", few((0.0, 10.0), 10.0))
def test_a_closed_elastic_cycle_loses_nothing(gravity: float) -> None:
    """Quasi-static, out and back twice: the work of the support returns to nothing."""
    rows = [(0, 0, 0), (0.25, 0.1, 0.05), (0.75, -0.01, 0), (1.0, 0, 0), (1.25, 0.05, -0.05), (1.5, 0, 0)]
    asked = scene(
        {"law": "elastic", **SPRING},
        {"thickness": 0.1},
        effects=GEOMETRY,
        ends={"motion": rows},
        load={"gravity": gravity},
        run={"duration": 1.5, "frames": 241},
        cells=10,
    )
    data = solved(asked)
    work = data["work_external"].values
    at_rest = [int(np.argmin(np.abs(data["time"].values - t))) for t in (1.0, 1.5)]
    left = [float(abs(work[frame]) / np.max(np.abs(work))) for frame in at_rest]
    stored = data["energy_elastic"].values + data["energy_potential"].values
    audit = float(np.max(np.abs(stored - stored[0] - work)) / np.max(np.abs(work)))
    head = ("largest work [J]", "left after the first cycle", "after the second", "work against stored energy")
    show(
        f"elastic, g = {gravity:g} m/s^2",
        head,
        [[f"{work.max():.5f}", *(f"{one:.1e}" for one in left), f"{audit:.1e}"]],
    )
    assert max(left) < 1e-6
    assert audit < 1e-6
