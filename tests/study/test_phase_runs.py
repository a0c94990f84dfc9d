"""Runs of a phase diagram against `simulate`, what becomes of runs that are no answer, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.ensemble.ensemble import NobodyListens
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.studies.phase import SETTINGS, descent_run, phase_diagram
from softcat_sym.studies.phase_runs import (
    CLAMPS_ONLY,
    PASSED,
    PLANES,
    PhaseRunner,
    Place,
    duration_at,
    place_at,
    row_of,
)

SCENE = sc.load_scene("arrested-overdamped", list(SETTINGS))

ANSWERS = (
    (Place(0.02, 26.0, 0.03), "no-yield"),
    (Place(0.1, 3.0, 0.03), "arrested-underdamped"),
    (Place(0.5, 26.0, 0.05), "arrested-overdamped"),
    (Place(2.5, 26.0, 0.03), "descending"),
)


def by_hand(place: Place, duration: float) -> sc.Scene:
    """The filament of these groups, its constants worked out from their definitions (3.9), (3.10)."""
    span, density, gravity = 0.2, 1900.0, 9.81
    return SCENE.replace(
        {
            "filament.thickness": f"{place.delta * span!r} m",
            "material.yield_stress": f"{density * gravity * span / place.G!r} Pa",
            "material.viscosity": f"{place.V * density * math.sqrt(gravity * span**3)!r} Pa*s",
            "run.duration": f"{duration!r} s",
        }
    )


def test_runs_are_those_of_simulate() -> None:
    runs = PhaseRunner(SCENE, 2, NobodyListens()).run([place for place, _ in ANSWERS])
    for run, (place, regime) in zip(runs, ANSWERS, strict=True):
        single = sc.simulate(by_hand(place, duration_at(SCENE, place)))
        assert run.regime == single.summary["regime"] == regime
        assert run.sag == pytest.approx(-single.summary["midpoint_final_m"] / 0.2, rel=2e-3, abs=1e-4)
        last = single.data.isel(time=-1)
        for found, cell in ((run.clamp, 0), (run.midspan, last.sizes["cell"] // 2)):
            at = last.isel(cell=cell)
            bending = abs(float(at.curvature)) * float(at.thickness) / 2
            assert found.centreline == pytest.approx(np.log(float(at.stretch)), rel=5e-3, abs=1e-4)
            assert found.largest == pytest.approx(np.log(float(at.stretch)) + bending, rel=5e-3, abs=1e-4)


def test_a_run_that_is_no_answer_has_no_regime() -> None:
    """The paper's ringing filament at G = 0.4, whose clamps are drawn out; and one that falls as a whole before."""
    necked, fallen, creeping = PhaseRunner(SCENE, 2, NobodyListens()).run(
        [Place(0.4, 0.3, 0.03), Place(3.0, 1.0, 0.03), Place(1.0, 26.0, 0.03)]
    )
    assert (necked.regime, necked.mark, necked.runs) == (None, "localised", 2)
    assert necked.message
    assert (fallen.regime, fallen.runs) == ("descending", 2)
    assert fallen.drawn_out == duration_at(SCENE, fallen.place)
    assert fallen.sag == pytest.approx(PASSED, abs=0.05)
    assert fallen.duration < fallen.drawn_out
    assert (creeping.regime, creeping.mark, creeping.runs) == ("descending", CLAMPS_ONLY, 1)
    assert creeping.rate > 0.5 > creeping.span_rate


def test_papers_continual_descent() -> None:
    run = descent_run(SCENE)
    assert run.regime == "descending"
    assert run.sag == pytest.approx(0.245, abs=0.005)  # "about a quarter of its original length"
    assert run.clamp.largest > run.clamp.centreline > 0.23  # "local strains over 23 % near the clamp"
    assert run.midspan.largest < 0.23


def test_rows_give_the_groups_back() -> None:
    place = place_at(SCENE, PLANES["G-V"], 0.7, 2.0)
    assert (place.G, place.V) == (0.7, 2.0)
    assert place.delta == pytest.approx(0.03)
    assert row_of(SCENE, Place(0.7, 2.0, 0.05), 1.5) == {
        "groups.delta": 0.05, "groups.G": 0.7, "groups.V": 2.0, "run.duration": 1.5,
    }  # fmt: skip


def test_refusals() -> None:
    with pytest.raises(SceneError, match=r"material\.law"):
        phase_diagram(sc.load_scene("maxwell-slow"))
    with pytest.raises(SceneError, match="level supports"):
        phase_diagram(SCENE.replace({"ends.drop": "1 cm"}))
    with pytest.raises(SoftcatError, match="G-delta, G-V"):
        phase_diagram(SCENE, ["G-tau"])
    for resolution in (3, 641):
        with pytest.raises(SoftcatError, match="4 to 640"):
            phase_diagram(SCENE, resolution=resolution)
