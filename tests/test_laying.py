"""A nozzle that lays a strand while it hangs, against closed forms; and scenes that may not have one."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.reference.element_loop import problem_of
from softcat_sym.scene.extrusion import exit_time, extruded, laid_at, laid_length
from softcat_sym.scene.scene import rest_length
from softcat_sym.web.description import describe_page
from tests.common.laying import beam_over_law, extruded_downwards, hanging_bar, laid_beam
from tests.common.scenes import BINGHAM, faults_of, spoiled


def test_a_strand_extruded_downwards_is_as_long_as_it_hangs_and_the_nozzle_carries_it() -> None:
    """E log(s)/s = rho g X: the error has the period of a cell, and no mean to speak of."""
    run = extruded_downwards(10)
    assert run.outcome is sc.Outcome.solved
    hangs, carried = hanging_bar(run)
    # The stub is one cell or two, whose middle stands for it; the force is that of the exposed mass.
    assert np.max(np.abs(hangs[10:] - 1)) < 1e-3 and np.max(np.abs(carried - 1)) < 1e-2
    assert abs(np.mean(carried[10:]) - 1) < 1e-3
    assert run.summary["energy_residual"] < 1e-3
    weights = run.data.exposed.values.sum(axis=1) / run.data.exposed.shape[1]
    assert np.max(np.abs(weights * rest_length(run.scene) / run.data.extruded_length.values - 1)) < 1e-12


def test_interpreted_and_compiled_laying_are_one() -> None:
    """Both print or evaluate the same graph; the methods differ, so that the tolerances decide how far they agree."""
    runs = [extruded_downwards(4, backend=backend, rtol=1e-6) for backend in ("interpreted", "compiled")]
    for name in ("y", "nozzle_force_y", "energy_exit", "work_nozzle"):
        one, two = (run.data[name].values for run in runs)
        assert np.max(np.abs(one - two)) < 2e-3 * np.max(np.abs(two)), name


def test_a_viscous_beam_laid_at_the_speed_of_its_flow_sags_a_sixth() -> None:
    """Q x^2 (L - x)^3/(72 eta I V), largest at 0.4 L; the shear of so thin a beam adds some thousandths."""
    run = laid_beam(16)
    assert run.outcome is sc.Outcome.solved and run.summary["energy_residual"] < 1e-3
    ratios = beam_over_law(run)
    assert abs(ratios[len(ratios) // 2] - 1) < 0.01
    deepest = int(np.argmin(run.data.y.values[-1]))
    assert deepest / (len(ratios) + 1) == pytest.approx(0.4, abs=0.05)


def test_what_comes_out_follows_a_feed_that_changes() -> None:
    """A feed that rises from 4 to 12 mm/s in a second: L_e = L_i + 4 t + 4 t^2 [mm]."""
    feed = {"0 s": "4 mm/s", "1 s": "12 mm/s"}
    path = [["0 s", "1 mm", "0 mm"], ["1 s", "5 mm", "0 mm"]]
    nozzle = {"extrusion": {"path": path, "speed": feed, "start": "1 mm"}}
    scene = sc.load_scene("laid-ink").replace({"extrusion": None}).replace(nozzle)
    assert laid_length(scene) == pytest.approx(9e-3) and laid_at(scene) == 1.0
    for time in (0.0, 0.3, 1.0, 2.0):
        now = min(time, 1.0)
        assert extruded(scene, time) == pytest.approx(1e-3 * (1 + 4 * now + 4 * now**2), rel=1e-12)
        assert exit_time(scene, extruded(scene, time)) == pytest.approx(now, abs=1e-9)


def test_a_scene_with_a_nozzle_needs_laying_and_sections_that_turn() -> None:
    assert {"laying", "shear"} <= set(choose_effects(sc.load_scene("laid-ink")).names)
    with pytest.raises(sc.SceneError, match=r"without 'laying', but the scene has an \[extrusion\]"):
        choose_effects(sc.load_scene("laid-ink", ["run.effects=paper", "surroundings.surface_tension=0 N/m"]))


def test_pages_elements_and_generated_programs_refuse_a_nozzle_by_name(tmp_path: Path) -> None:
    for made in (describe_page, problem_of, partial(sc.generate, directory=tmp_path / "c")):
        with pytest.raises(sc.SceneError, match="extrusion"):
            made(sc.load_scene("laid-ink"))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("scene", "told"), [("hot", "cools"), ("ink-bridge", ""), ("laid-pla", ""), ("beam", "")])
def test_explain_says_when_the_time_of_laying_would_change_the_sag(scene: str, told: str) -> None:
    """Of what cools while a nozzle at 10 mm/s lays it; not of an ink that arrests, of what is laid, of a thick bar."""
    tables = {"hot": sc.load_scene("laid-pla").replace({"extrusion": None}), "beam": sc.load_scene("cold-honey")}
    note = sc.explain(tables.get(scene, scene)).laying
    assert told in note and bool(note) == bool(told)


LAID = {"extrusion.print_speed": "50 mm/s"}
PATH = [["0 s", "20 mm", "0 mm"], ["1 s", "0.2 m", "0 mm"]]
STILL = {"ends.left": "free", "extrusion.path": [["0 s", "0 m", "0 m"]], "extrusion.direction": "down"}
BAD: list[tuple[dict[str, Any], str, str]] = [
    ({"extrusion.swell": 1.2}, "extrusion.print_speed", "missing, but extrusion.swell is given"),
    ({"extrusion.print_speed": "50 mm"}, "extrusion.print_speed", "velocity"),
    ({"extrusion.print_speed": "0 mm/s"}, "extrusion.print_speed", "is zero"),
    ({**LAID, "extrusion.path": PATH}, "extrusion.path", "given with extrusion.print_speed"),
    ({**LAID, "extrusion.speed": "1 mm/s", "extrusion.draw_ratio": 1}, "extrusion.draw_ratio", "how much comes out"),
    ({**LAID, "extrusion.flow_rate": "1 mm/s"}, "extrusion.flow_rate", "volume rate"),
    ({**LAID, "extrusion.speed": "5 mm/s*t/s"}, "extrusion.speed", "velocity"),
    ({**LAID, "extrusion.start": "2 span"}, "extrusion.start", "not between 0 and 1"),
    ({**LAID, "extrusion.start": "0.3 m"}, "extrusion.start", "not shorter than the span"),
    ({**LAID, "extrusion.direction": "up"}, "extrusion.direction", "along, down, or an angle"),
    ({**LAID, "extrusion.exit_end": "pinned"}, "extrusion.exit_end", "clamped"),
    ({**LAID, "extrusion.after": "cut"}, "extrusion.after", "hold"),
    ({**LAID, "filament.rest_length": "0.21 m"}, "filament.rest_length", "says how long the strand is"),
    ({**LAID, "ends.right": "pinned"}, "ends.right", "is the right support"),
    ({**LAID, "ends.motion": [["1 s", "1 mm", "0 m"]]}, "ends.motion", "is the right support"),
    ({**LAID, "initial.stretch": 1.1}, "initial.stretch", "relaxed"),
    ({**LAID, "load.point_mass": "1 g"}, "load.point_mass", "has not this so far"),
    ({**LAID, "filament.profile": [1, 2]}, "filament.profile", "has not this so far"),
    ({**LAID, "numerics.grading": 3}, "numerics.grading", "equal cells"),
    ({**LAID, "run.dimensions": 3}, "run.dimensions", "in its plane only"),
    ({**LAID, "run.closure": "printed"}, "run.closure", "'printed'"),
    ({**LAID, "model": "small-deflection"}, "model", "'small-deflection'"),
    ({**LAID, "pillars.gap": "0.1 m"}, "pillars.gap", "has not this so far"),
    ({**LAID, "ends.left_angle": "10 deg"}, "ends.left_angle", "leaves the nozzle at 0 deg"),
    ({"extrusion.path": PATH[::-1]}, "extrusion.path", "begins at 1 s"),
    ({"extrusion.path": [["0 s", "30 mm", "0 mm"], PATH[1]]}, "extrusion.path", "does not end"),
    (STILL, "extrusion.speed", "no draw ratio says how much comes out"),
    ({**STILL, "extrusion.speed": "1 mm/s", "extrusion.direction": "along"}, "extrusion.direction", "stands still"),
]


@pytest.mark.parametrize(("changes", "path", "found"), BAD, ids=[f"{path}: {found}" for _, path, found in BAD])
def test_scenes_that_a_nozzle_does_not_suit_are_refused_by_name(changes: dict[str, Any], path: str, found: str) -> None:
    faults = [fault for fault in faults_of(spoiled(changes, BINGHAM)) if fault.path == path]
    assert any(found in str(fault) for fault in faults), faults_of(spoiled(changes, BINGHAM))
