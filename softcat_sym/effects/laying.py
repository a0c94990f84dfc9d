"""Laying: a nozzle lays the strand while it hangs, with the feed and on the path of [extrusion]."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from softcat_sym.effects.effect import Effect, Estimate, Fields, Observed
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.extrusion import emplaced, exit_time, extruded, laid_at, stub_length
from softcat_sym.scene.scene import Scene, rest_length


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    del motion
    share = 1 - stub_length(scene) / rest_length(scene)
    return Estimate(1.0, "share of the strand that is not out at the start", f"{share:.2g}")


def _adapt(scene: Scene, terms: Terms) -> Terms:
    del scene
    return replace(terms, laid=True)


def _observe(scene: Scene, fields: Fields) -> Observed:
    """What is out, how long it has been, and with what force the nozzle holds it."""
    time, nodes = fields["time"], fields["X_node"]
    centres = (nodes[1:] + nodes[:-1]) / 2 + rest_length(scene) / 2
    out = np.array([exit_time(scene, float(place)) for place in centres])
    found = {
        "extruded_length": np.array([extruded(scene, float(now)) for now in time]),
        "emplaced_length": np.array([emplaced(scene, float(now)) for now in time]),
        "age": np.maximum(time[:, None] - out, 0.0),
    }
    # The feed ends at once, and with it the force of what resists: that of the last frame before counts.
    last = max(int(np.searchsorted(time, laid_at(scene))) - 1, 0)
    fed, passed = (float(found[f"{name}_length"][-1]) for name in ("extruded", "emplaced"))
    summary = {
        "laid_at_s": laid_at(scene),
        "extruded_length_m": fed,
        "emplaced_length_m": passed,
        "draw_ratio": (passed - stub_length(scene)) / (fed - stub_length(scene)) if fed > stub_length(scene) else None,
        "nozzle_force_x_N": float(fields["nozzle_force_x"][last]),
        "nozzle_force_y_N": float(fields["nozzle_force_y"][last]),
    }
    return Observed(found, summary)


LAYING = Effect(
    name="laying",
    summary="a nozzle lays the strand while it hangs",
    source="Ribe 2004; Crisfield & Jelenic 1999",
    adapt=_adapt,
    applies=lambda scene: scene.extrusion.present,
    without_it="the scene has no [extrusion]",
    estimate=_estimate,
    observable="the length that has come out",
    example="laid-ink",
    derivation="25_laying",
    in_paper=False,
    indispensable=lambda scene: "the scene has an [extrusion]" if scene.extrusion.present else "",
    observe=_observe,
)
