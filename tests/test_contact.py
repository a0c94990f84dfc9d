"""Contact with floor and pillars, against closed forms; scenes that may not have it, and when ``auto`` takes it in."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.reference.element_loop import problem_of
from softcat_sym.scene.bodies import Pillars, overlap
from softcat_sym.web.description import describe_page
from tests.common.contact import beam_on_floor, cable_on_floor
from tests.common.scenes import BINGHAM, faults_of, spoiled


def test_the_smoothed_contact_is_a_parabola_with_two_continuous_derivatives() -> None:
    """Its force is the derivative of its energy, and rises from nothing with a continuous slope."""
    gap = np.linspace(-3.0, 2.0, 100_001)
    energy, depth = overlap(gap, 0.7)
    assert np.allclose(energy[gap < -0.7], gap[gap < -0.7] ** 2 / 2 + 0.7**2 / 6, rtol=1e-12)
    assert not np.any(energy[gap > 0.7])
    assert np.allclose(-np.gradient(energy, gap), depth, atol=1e-4)
    assert np.allclose(-np.gradient(depth, gap)[1:-1], np.clip(0.5 - gap / 1.4, 0, 1)[1:-1], atol=1e-4)


def test_pillars_keep_half_the_thickness_from_their_walls_and_their_round_edges() -> None:
    """A disk touches where its centre has its radius as the distance from walls, tops and edges."""
    pillars = Pillars(gap="5 mm", edge="1 mm")
    touching = {
        "top": (4e-3, 0.0),
        "wall": (2.3e-3, -5e-3),
        "edge": (3.5e-3 - 1.2e-3 * math.cos(0.7), -1.2e-3 * (1 - math.sin(0.7))),
    }
    for side in (-1, 1):
        for x, y in touching.values():
            assert abs(pillars.clearance(pillars, side * x, y, 4e-4, math.sqrt)) < 1e-9


def test_a_clamped_beam_lies_on_a_floor_as_the_free_part_of_a_beam_does() -> None:
    """D = q a^4/(72 E I): clamp moment q a^2/6, reaction q (L - 4 a/3); the error is of first order in d_p/D."""
    errors = []
    for share in (0.1, 0.01):
        beam = beam_on_floor(cells=40, share=share)
        errors.append(beam.moment - 1)
        assert beam.run.outcome is sc.Outcome.solved
        assert beam.force == pytest.approx(1, abs=0.004)
        assert abs(beam.length) < 2 * beam.blur
    assert 0.003 < errors[0] < 0.02 and abs(errors[1]) < 0.1 * errors[0] + 0.001


def test_a_cable_lies_on_a_floor_and_rises_as_a_catenary() -> None:
    assert cable_on_floor(cells=20, share=0.002) == pytest.approx(1, abs=0.01)


def test_auto_takes_contact_where_the_forecast_sag_reaches_a_body() -> None:
    found = {
        depth: choose_effects(sc.load_scene("ink-bridge", [f"floor.depth={depth}"])).names
        for depth in ("15 um", "3 mm")
    }
    assert "contact" in found["15 um"] and "contact" not in found["3 mm"]
    over = sc.load_scene("ink-bridge", ["filament.span=12 mm", "pillars.gap=5 mm"])
    assert {"contact", "inertia"} <= set(choose_effects(over).names)
    with pytest.raises(sc.SceneError, match=r"without 'contact', but the filament lies on \[pillars\]"):
        choose_effects(over.replace({"run.effects": "paper", "surroundings": None}))


def test_a_live_page_refuses_bodies_and_elements_a_bond_by_name() -> None:
    scene = sc.load_scene("ink-over-a-layer", ["filament.section=rectangle", "surroundings.surface_tension=0 N/m"])
    with pytest.raises(sc.SceneError, match="floor: given, but a page"):
        describe_page(scene)
    with pytest.raises(sc.SceneError, match=r"floor.bond: 'stick' has no finite elements"):
        problem_of(scene)


FLOOR, PILLARS = {"floor.depth": "1 mm"}, {"pillars.gap": "0.1 m"}
BAD: list[tuple[dict[str, Any], str, str]] = [
    ({"floor.bond": "stick"}, "floor.depth", "missing, but floor.bond is given"),
    ({"floor.depth": "-1 mm"}, "floor.depth", "is negative"),
    ({**FLOOR, "floor.bond": "glue"}, "floor.bond", "accepted: none, stick, or a positive viscosity"),
    ({**FLOOR, "floor.penetration": "0 m"}, "floor.penetration", "is zero"),
    ({**FLOOR, "floor.friction": -1}, "floor.friction", "-1"),
    ({**FLOOR, "floor.speed": "1 mm/s"}, "floor.speed", "carries the filament along"),
    ({**FLOOR, "ends.drop": "2 mm"}, "ends.drop", "0.001 m below the floor"),
    ({**FLOOR, "load.gravity": "0 m/s^2"}, "load.gravity", "[floor] bears a weight"),
    ({**FLOOR, "run.closure": "printed"}, "floor", "run.closure = 'printed'"),
    ({**FLOOR, "run.dimensions": 3}, "floor", "only in the plane so far"),
    ({**FLOOR, "filament.profile": [1, 2, 1]}, "filament.profile", "one thickness"),
    ({**PILLARS, "pillars.gap": "0.2 m"}, "pillars.gap", "stand over the pillars"),
    ({**PILLARS, "pillars.height": "1 mm"}, "pillars.height", "begin inside the pillars"),
    ({**PILLARS, "ends.drop": "2 mm"}, "ends.drop", "equally high"),
    ({**PILLARS, "floor.depth": "0 mm"}, "floor.depth", "not below the tops"),
    ({**PILLARS, "model": "small-deflection"}, "pillars", "given with model 'small-deflection'"),
]


@pytest.mark.parametrize(("changes", "path", "found"), BAD, ids=[f"{path}: {found}" for _, path, found in BAD])
def test_scenes_that_contact_does_not_suit_are_refused_by_name(changes: dict[str, Any], path: str, found: str) -> None:
    faults = [fault for fault in faults_of(spoiled(changes, BINGHAM)) if fault.path == path]
    assert any(found in str(fault) for fault in faults), faults
