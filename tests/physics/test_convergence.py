"""Second order in 1/N: the observed order of three grids, each twice as fine as the last."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.scene.scene import Scene

from .scenes import GEOMETRY, paper_scene, run, sag, scene

SCENES = {
    "elastic-beam": scene(thickness=0.03, E=3e6, effects=GEOMETRY),
    "elastic-swing": scene(thickness=0.03, E=3e6, ramp=0.3, duration=0.4, rtol=1e-5),
    "maxwell-creep": scene(
        thickness=0.03, E=1e7, eta=1e5, effects=(*GEOMETRY, "viscous-flow"), duration=0.3, rtol=1e-6
    ),
    "maxwell-descent": scene(thickness=0.03, E=1e7, eta=2.6e5, duration=1.0, rtol=1e-6, solver="rosenbrock"),
    "bingham-descent": paper_scene(1.9, 26, 46, rtol=1e-6, solver="rosenbrock"),
}


@pytest.mark.parametrize("asked", SCENES.values(), ids=list(SCENES))
def test_midpoint_is_second_order(asked: Scene) -> None:
    sags = [sag(run(asked.replace({"numerics.cells": cells}))) / asked.filament.span for cells in (20, 40, 80)]
    order = np.log2((sags[0] - sags[1]) / (sags[1] - sags[2]))
    print(f"sag/L at N = 20, 40, 80: {', '.join(f'{depth:.7f}' for depth in sags)}; order {order:.2f}")
    assert 1.7 < order < 2.3
