"""The same filament in plain NumPy, written without a look at this package: staggered in space, RK4 in time."""

from __future__ import annotations

import numpy as np
import pytest

from tests.common.rk4_filament import run as oracle

from .scenes import PAPER, paper_scene, run

CELLS = 20


@pytest.mark.parametrize("closure", ["material", "printed"])
@pytest.mark.parametrize("end", ["clamped", "pinned"])
@pytest.mark.parametrize(
    ("G", "V"), [(0.01, 26.0), (0.4, 26.0), (1.9, 26.0)], ids=["no-yield", "overdamped", "descent"]
)
def test_midpoint_and_shape_agree_with_the_oracle(G: float, V: float, end: str, closure: str) -> None:
    expected = oracle(PAPER["delta"], G, V, None, "bingham", closure, CELLS, 20.0, outputs=(5, 10, 15), ends=end)
    asked = paper_scene(
        G, V, 20, frames=5, cells=CELLS, rtol=1e-7, solver="rosenbrock", closure=closure, ends=(end, end)
    )
    done = run(asked)
    assert done.outcome.is_success
    data, span = done.data, PAPER["span"]
    found = data["midpoint"].values[1:] / span
    shape = np.abs(data["x"].values[-1, CELLS:] / span - expected.x[-1]) + np.abs(
        data["y"].values[-1, CELLS:] / span - expected.y[-1]
    )
    error = np.max(np.abs(found / expected.midpoint - 1))
    print(f"G = {G}, {end}, {closure}: sag {-found[-1]:.6f} L, midpoint {error:.0e}, shape {np.max(shape):.0e} L")
    assert error < 1e-5
    assert np.max(shape) < 1e-6
