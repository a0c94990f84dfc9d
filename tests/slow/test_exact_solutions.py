"""The cases of ``test_exact_shapes`` and ``test_drawn_bars`` that are not run every time."""

from __future__ import annotations

from functools import partial

import pytest

from tests import test_drawn_bars as bars
from tests import test_exact_shapes as shapes
from tests.common.rheology import GEOMETRY

pytestmark = pytest.mark.slow

SHAPES: shapes.Cases = {
    "cantilever, w L^3/EI = 12": (partial(shapes.heavy_elastica, 12.0, 0.0), 2e-4),
    "natural curvature 1.5/m": (shapes.natural_curvature, 1e-5),
    "cantilever, w L^3/EI = 12, clamp at 0.8": (partial(shapes.heavy_elastica, 12.0, 0.8), 2e-4),
    "catenary, level": (partial(shapes.catenary, 0.0), 5e-5),
    "catenary, drop 0.3 m": (partial(shapes.catenary, 0.3), 5e-5),
    "elastic catenary, E* = 3, linear": (partial(shapes.elastic_catenary, ("large-rotation",), 3.0), 2e-5),
    "catenary, bending included, h/L = 1e-4": (
        partial(shapes.elastic_catenary, GEOMETRY, 1e3, 1.3, 0.3, 1e-4),
        5e-5,
    ),
    "clamps at -0.6 and 0.6": (shapes.arc_between_turned_clamps, 2e-4),
    "clamps at 0.2 and 0.2": (partial(shapes.turned_clamps, 0.2, 0.2, 0.0), 5e-4),
}


def test_filaments_hang_as_the_exact_curves() -> None:
    shapes.judge(SHAPES, 1e-2)


def test_every_law_is_drawn_and_cycled() -> None:
    bars.judge_drawn(bars.DRAWN)
    bars.judge_heavy((law, with_inertia) for law in bars.CYCLED for with_inertia in (False, True))
    bars.judge_elastic_cycle(0.0)
