"""Held against the world: every published case, its number and ours, as `softcat validate` prints them.

Bounds are those of the sources where they have any; elsewhere they hold what the table in the documentation says.
"""

from __future__ import annotations

import math

import pytest

from softcat_sym import drawing
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.studies.validate import validate

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: install gcc, or set CC"),
]

BOUNDS = {
    # Measured without a stated scatter; the wave of the runs is long, and their profile rounded to 1e-6.
    "mora": (0.0, 1e-3),
    # The law here is no rubber's: 6 (1 - log(2)/3)/2^(1/6) over sqrt 32, less one.
    "stretched-gel": (6 * (1 - math.log(2) / 3) / 2 ** (1 / 6) / math.sqrt(32) - 1, 2e-3),
    # Solid elements hold the flat section; their own beams are as far.
    "princeton": (0.0, 0.035),
    "curved-beam": (0.0, 0.015),
    "smay": (0.0, 0.05 / 1.4),
    # It is still under way when the thread is a 25th of its radius.
    "sachsenheimer": (0.0, 8e-3),
    "zylstra": (0.0, 5e-3),
    "brochard": (0.0, 0.02),
    "beam-bending": (0.0, 5e-4),
}
"""Of each case the difference expected, and how far from it."""


def test_held_against_the_world() -> None:
    validation = validate()
    drawing.report(validation).print()
    assert not validation.failures
    results = {result.case.name: result for result in validation.results}
    rows = {name: result.finding.rows for name, result in results.items() if result.finding}
    for name, (expected, most) in BOUNDS.items():
        for row in rows[name]:
            assert row.difference == pytest.approx(expected, abs=most), (name, row.quantity)
    # Their beams, not their solids: the same theory.
    beams = [row.difference for row in rows["princeton"] if "beam elements" in row.quantity]
    assert len(beams) == 2 and max(map(abs, beams)) < 6e-3
    for name in ("softening-710", "softening-717a"):
        point, decades = rows[name]
        # Ten kelvin below what is published: see test_softening_point.py for what would explain it.
        assert -14 < point.difference < -8
        assert decades.agrees
    if "rheodata" in rows:
        assert rows["rheodata"][0].agrees
    unrun = {name for name, result in results.items() if result.not_run}
    assert unrun - {"rheodata"} == {"u-shape", "teichman", "roy", "annealing"}
