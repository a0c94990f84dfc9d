"""The longest span against brute force: fifty spans, each run by itself, for six materials."""

from __future__ import annotations

import resource

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.simulate import without_estimate

SCENES = {
    "ink-bridge": "0.2 mm",
    "arrested-overdamped": "5 %",
    "rubber-strand": "5 %",
    "hot-glue-string": "5 %",
    "toothpaste": "5 %",
    "maxwell-slow": "8 mm",
}


def _sag(scene: sc.Scene, span: float) -> float:
    run = sc.simulate(without_estimate(scene), {"filament.span": f"{span!r} m"})
    return float(np.max(np.abs(run.data["midpoint"].values)))


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_the_longest_span_is_that_of_fifty_runs(name: str) -> None:
    """Between the last of fifty spans that sags less and the first that sags more, by a line between logarithms."""
    scene, limit = sc.load_scene(name), SCENES[name]
    before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    found = sc.longest_span(scene, limit)
    cost = resource.getrusage(resource.RUSAGE_SELF).ru_utime - before
    assert found.error is not None
    spans = (found.span * np.geomspace(0.7, 1.3, 50)).tolist()
    allowed = [found.limit.at(span) for span in spans]
    excess = np.log([_sag(scene, span) / limit for span, limit in zip(spans, allowed, strict=True)])
    first = int(np.argmax(excess >= 0))
    assert first > 0 and np.all(excess[first:] >= 0)
    share = -excess[first - 1] / (excess[first] - excess[first - 1])
    true = spans[first - 1] * (spans[first] / spans[first - 1]) ** share
    said = f"{1e3 * found.span:8.4g} mm +- {1e3 * found.error:.2g}"
    print(f"{name:20s} {said}, brute force {1e3 * true:8.4g}, {cost:.1f} s")
    assert abs(found.span - true) <= found.error
    assert found.error < 0.05 * found.span
