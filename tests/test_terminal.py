"""What is on the screen while a command works, and after a run."""

from __future__ import annotations

import dataclasses

from softcat_sym.plotting.terminal import (
    answer_rows,
    detail_rows,
)
from tests.common.catenary import make_scene, scene, summary

__all__ = ["make_scene", "scene", "summary"]


def test_a_sag_is_that_of_a_level_strand_and_else_it_is_a_midpoint(summary, scene):
    for final, largest, ends, row in (
        (-0.05, 0.05, {}, ("sag", "50.0 mm ± 1.1 %, 25 % of the span")),
        (-0.005, 0.05, {}, ("sag", "5.00 mm ± 560 µm, 2.5 % of the span")),
        (0.02, 0.02, {}, ("midpoint", "20.0 mm up ± 1.1 %, 10 % of the span")),
        (-0.05, 0.05, {"right": "free"}, ("midpoint", "50.0 mm down ± 1.1 %, 25 % of the span")),
    ):
        held = dataclasses.replace(scene, ends=scene.ends.model_copy(update=ends))
        found = {"midpoint_final_m": final, "midpoint_largest_m": largest, "error_estimate": {"total": 0.0112}}
        assert row in answer_rows(summary | found, held)
    # The error of the theory stands beside that of the numbers; where the midpoint tells nothing, another node does.
    moved = {
        "scale_m": 0.1,
        "largest_m": 0.1,
        "where": 0.5,
        "final_m": [0.08, -0.06],
        "last_fifth_m": 0.01,
        "midpoint_m": 0.05,
    }
    told = {"midpoint_final_m": -0.05, "midpoint_largest_m": 0.05, "error_estimate": {"total": 5e-4}}
    both = summary | told | {"theory_error": 0.012, "displacement": moved}
    row = ("sag", "50.0 mm ± 0.1 % (numbers), about 1.2 % (slender theory), 25 % of the span")
    assert row in answer_rows(both, scene)
    place = "moved 100 mm, 80.0 mm to the right, 60.0 mm down ± 0.05 % (numbers), about 1.2 % (slender theory), "
    for changes in ({"displacement": moved | {"midpoint_m": 0.009}}, {"midpoint_largest_m": 0.21}):
        assert ("right end", place + "50 % of the span") in answer_rows(both | changes, scene)
    summary |= {"midpoint_settled_m": {"mean": -0.049, "amplitude": 2e-3}, "settled_s": None}
    words = dict(answer_rows(summary, scene))
    assert "49.0 mm" in words["sag"] and "swinging by 2.00 mm" in words["sag"] and words["settled"].startswith("no")
    # A creep is no swing.
    still = summary | {"midpoint_settled_m": {"mean": -0.049, "amplitude": 0.0}}
    creeps = still | {"creep": {"rate_m_per_s": -2e-4, "tends_to_m": -0.06}, "time_final_s": 4.0}
    (sag,) = [text for name, text in answer_rows(creeps, scene) if name == "sag"]
    assert sag.endswith(", still moving down by 200 µm/s towards 60.0 mm") and "swing" not in sag
    # What was left out is one number, shown where it exceeds the accuracy.
    summary |= {"left_out": {"shear": 0.021, "rotary-inertia": 1e-4}, "checked": {"shear": 0.03, "rotary-inertia": 0.0}}
    row = ("left out", "shear, rotary-inertia: at most 3 % of the sag together")
    assert [row in answer_rows({**summary, "accuracy": limit}, scene) for limit in (0.05, 0.01)] == [False, True]
    estimate = {"total": 8e-4, "space": 6e-4, "time": 1e-4, "section": None, "effects": 1e-4, "torque": None}
    details = dict(detail_rows(summary | {"error_estimate": estimate}))
    words = "0.08 % of the largest displacement (grid 0.06 %, time steps 0.01 %)"
    assert details["error"] == words
    details = dict(detail_rows(summary | {"error_estimate": estimate | {"turn": 0.01, "torque": 0.2}}))
    assert details["error"] == f"{words}; 1 % of the largest turn; 20 % of the largest torque"
