"""A peer that shares nothing with this package: PyElastica on an undamped clamped rod let go under its weight.

Circle of radius 10 mm, 1 m long, 636.62 kg/m^3, both ends clamped, midpoint after 0.05, 0.1 and 0.2 s, E = 1e4 ... 1e7
Pa. The rod is undamped, so PyElastica's ``uniform_damping_constant`` is zero; its time step goes up to its stability
limit, its compiled kernels are warm, and only its loop over time steps is timed, as of this package the solve stage,
both in seconds of the processor. What goes before, building the filament or the rod, is printed by itself; compiling is
not in it: of a rod of a new kind one to two seconds here, of PyElastica's kernels once a machine. With
``SOFTCAT_PICTURES=folder`` the picture and its numbers are kept.
"""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import numpy as np
import pytest

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.plotting.accuracy import WorkPanel, draw, seconds_for

from .table import show

if TYPE_CHECKING:
    from .pyelastica_rod import Array

    Limits = dict[float, tuple[Array, Array]]

pytestmark = [
    pytest.mark.skipif(find_compiler() is None, reason="no C compiler: install gcc, or set CC"),
    pytest.mark.skipif(
        find_spec("elastica") is None, reason="PyElastica is not installed: pip install softcat_sym[peers]"
    ),
]

MODULI = {1e4: "10 kPa", 1e5: "100 kPa", 1e6: "1 MPa", 1e7: "10 MPa"}
STIFF = (1e6, 1e7)
GOALS = (1e-2, 1e-3, 1e-4, 1e-5)
"""Errors of the midpoint over the largest sag at which times are compared."""
MANUAL, MENDED = "PyElastica", "PyElastica, clamps of second order"


@pytest.fixture(scope="module")
def rods() -> ModuleType:
    """Both codes, loaded only where they run: PyElastica and its compiler take seconds. Its kernels are warm."""
    from . import rod_work_precision

    rod_work_precision.fall(20, 1e5, 0.5, "our material")
    return rod_work_precision


@pytest.fixture(scope="module")
def limits(rods: ModuleType) -> Limits:
    """Converged midpoints of this package and of PyElastica with its own material."""
    return {E: (rods.our_limit(E), rods.peer_limit(E, "second order")) for E in MODULI}


@pytest.mark.slow
def test_both_codes_tend_to_one_answer(rods: ModuleType, limits: Limits) -> None:
    """Their materials differ by the strain measure and by a work term; given one material, the codes agree."""
    rows, own, same = [], {}, {}
    for E, (ours, theirs) in limits.items():
        alike = rods.peer_limit(E, "our material")
        own[E], same[E] = rods.error_of(theirs, ours), rods.error_of(alike, ours)
        for name, values in (("softcat_sym", ours), ("PyElastica", theirs), ("PyElastica, our material", alike)):
            difference = "" if values is ours else f"{rods.error_of(values, ours):.1e}"
            rows.append([MODULI[E], name, *(f"{value:.6f}" for value in values), difference])
    header = ("E", "converged", *(f"{t:g} s [m]" for t in rods.TIMES), "difference/sag")
    show("clamped rod, midpoint", header, rows)
    for E, (ours, _) in limits.items():
        # Until the clamps are felt the midpoint falls freely, and at 1e4 Pa that is until 0.1 s.
        if E == 1e4:
            assert ours[:2] == pytest.approx(-rods.GRAVITY * np.square(rods.TIMES[:2]) / 2, rel=1e-6)
        assert same[E] < 2e-3, E
        assert own[E] < 2e-2, E
    # What is left of the 1.4 % at 1e6 Pa when the material is the same: the difference was the material's.
    assert same[1e6] < own[1e6] / 5


@pytest.mark.slow
def test_work_and_precision(rods: ModuleType, limits: Limits, tmp_path: Path) -> None:
    """Each code against its own converged answer; every program at the best of all its settings."""
    panels = []
    for E, (ours, theirs) in limits.items():
        curves = (
            rods.our_curve(E, ours),
            rods.peer_curve(E, theirs, "manual", MANUAL),
            rods.peer_curve(E, theirs, "second order", MENDED),
        )
        panels.append(WorkPanel(f"E = {MODULI[E]}", curves))
    rows, ratios, whole = [], {}, {}
    ahead = rods.setting_up(1e6)
    for E, panel in zip(MODULI, panels, strict=True):
        for goal in GOALS:
            times = [seconds_for(curve.points, goal) for curve in panel.curves]
            peer = min((t for t in times[1:] if t is not None), default=None)
            if times[0] is not None and peer is not None:
                ratios[E, goal] = peer / times[0]
                whole[E, goal] = (ahead[1] + peer) / (ahead[0] + times[0])
            ms = ["-" if t is None else f"{1e3 * t:.1f}" for t in times]
            rows.append(
                [
                    MODULI[E],
                    f"{goal:g}",
                    *ms,
                    *(f"{r[E, goal]:.2g}" if (E, goal) in r else "-" for r in (ratios, whole)),
                ]
            )
    show("milliseconds to an error", ("E", "error", "softcat_sym", MANUAL, MENDED, "best over ours", "set-up in"), rows)
    print(f"\nset-up: {1e3 * ahead[0]:.1f} ms here, {1e3 * ahead[1]:.1f} ms PyElastica")
    caption = (
        "An undamped rod, clamped at both ends, let go under its weight: largest error of the midpoint at 0.05, 0.1 "
        "and 0.2 s over the largest sag, each code against its own converged answer. Pale: all settings; joined: the "
        "best. Seconds of the processor: solve stage of this package, compiled; PyElastica's loop over time steps."
    )
    folder = Path(os.environ.get("SOFTCAT_PICTURES") or tmp_path)
    picture, table = draw(panels, folder / "pyelastica.png", "A clamped rod: error against time", caption)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert len(table.read_text().splitlines()) == 1 + sum(len(c.points) for p in panels for c in p.curves)
    # The claim: equal accuracy in less time where the rod is stiff. Where it is soft there is none; the table tells.
    for E in STIFF:
        assert {1e-2, 1e-3} <= {goal for modulus, goal in ratios if modulus == E}, E
        assert whole[E, 1e-3] > 1, E
        assert all(ratio > 3 for (modulus, _), ratio in ratios.items() if modulus == E), E
        assert all(seconds_for(panel.curves[0].points, goal) for panel in panels for goal in (1e-2, 1e-3))
