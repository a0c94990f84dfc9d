"""The collapse test on contours of finite elements: intervals hold the constants, the closed formula is too large.

The elements take half an hour, once; they are kept in the user's cache.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.fitting.collapse_test import collapse_test
from softcat_sym.reference.element_loop import Mesh
from tests.common.elements import elements
from tests.common.strand import MODULUS, YIELD_STRESS, Line, photograph, strand, write
from tests.common.table import show

pytestmark = pytest.mark.slow

SPANS = (3e-3, 5e-3, 6e-3)
MESH = Mesh(48, 6, grading=4.0)
EARLY = {"run.duration": "1 s", "run.frames": 11}
"""When the photograph is taken: at 4 s the elements have necked at their clamps, and those over 6 mm still go down."""


@cache
def _line(span: float) -> Line:
    """Centre line [m] of the whole gap at the end of the elements' run."""
    run = elements(strand(span, EARLY), MESH)
    x, y = run.x[-1], run.y[-1]
    return [*-x[:0:-1], *x], [*y[:0:-1], *y]  # type: ignore[return-value]


def test_contours_of_the_elements_have_their_constants(tmp_path: Path) -> None:
    seen = photograph([_line(span) for span in SPANS], SPANS, tilt=0.03)
    guess = strand(5e-3, {"material.yield_stress": "120 Pa", "material.youngs_modulus": "50 kPa"})
    found = collapse_test(
        write(tmp_path / "photo.csv", *seen, "pillars.height = 3 mm", "pillars.time = 1 s"), guess, profiles=False
    )
    truth = {"yield_stress": YIELD_STRESS, "youngs_modulus": MODULUS}
    rows = [
        [name, truth[name], f"{one.best:.5g}", *one.ci95, one.verdict] for name, one in found.fit.parameters.items()
    ]
    title = f"contours of elements, 2 um noise: {found.fit.outcome.word}, {found.fit.seconds:.0f} s"
    show(title, ["Pa", "truth", "fit", "from", "to", "verdict"], rows)
    gaps = [
        [
            f"{1e3 * one.span:.2f}",
            f"{1e6 * one.sag:.1f}",
            f"{one.collapsed or 0:.4f}",
            f"{one.remaining or 0:.4f}",
            f"{(one.closed_form or 0) / YIELD_STRESS:.2f}",
            f"{one.ratio or 0:.2f}",
            f"{sc.simulate(strand(span, EARLY)).data.midpoint.values[-1] / min(_line(span)[1]):.3f}",
        ]
        for span, one in zip(SPANS, found.results, strict=True)
    ]
    show(
        "",
        ["gap, mm", "sag, um", "collapsed", "remaining", "closed formula / truth", "/ fit", "theory / elements"],
        gaps,
    )
    assert found.fit.outcome.converged
    for name, one in found.fit.parameters.items():
        low, high = one.ci95
        assert (low is None or low < truth[name]) and (high is None or high > truth[name]), name
    assert found.fit.parameters["yield_stress"].verdict == "identified"
    assert min(one.closed_form or 0 for one in found.results) > YIELD_STRESS
