"""What the text of the paper's section 3.2 says of its figures, beside what the runs show."""

from __future__ import annotations

from typing import Any

import numpy as np

from softcat_sym.equations import regimes
from softcat_sym.graph.grid import Floats
from softcat_sym.printing import evaluate
from softcat_sym.scene import groups_of
from softcat_sym.study.figure_scenes import THEORIES, FilmedScene

MOMENTS = (46.0, 115.0, 230.0, 460.0)
"""t~ at which midpoints are tabulated."""

RINGING_SINCE = 60.0
"""Means of what rings are taken from here on."""


def stopping_depth(gravity_number: float) -> dict[str, float | None]:
    """H_stop/L of (3.13) and of the exact catenary; None where there is none."""
    stops = gravity_number < float(regimes.ARREST_THRESHOLD)
    held = gravity_number < float(regimes.arrest_threshold_exact())
    return {
        "paper": float(evaluate(regimes.STOPPING_DEPTH.right, {regimes.G: gravity_number})[0]) if stops else None,
        "exact": float(regimes.stopping_depth_exact(gravity_number)) if held else None,
    }


def scene_facts(filmed: FilmedScene) -> dict[str, Any]:
    """Parameters, midpoints, means and strains of a scene run in every way.

    Parameters
    ----------
    filmed : FilmedScene
        As from :func:`softcat_sym.study.figure_scenes.film_scene`.
    """
    groups = groups_of(filmed.scene)
    material, run = filmed.scene.material, filmed.film.run
    gravity_number = float(groups.G or 0.0)
    curves = {"elements": filmed.elements} | {name: filmed.filament(name) for name in THEORIES}
    thickness = filmed.scene.filament.thickness / filmed.scene.filament.span
    return {
        "scene": filmed.of.name,
        "delta": thickness,
        "G": gravity_number,
        "eps_Y": (material.yield_stress or 0.0) / (material.youngs_modulus or 1.0),
        "V": float(groups.V or 0.0),
        "stopping_depth_over_L": stopping_depth(gravity_number),
        "midpoint_over_L": {name: _tabulated(*curve) for name, curve in curves.items()},
        "regime": {name: filmed.filaments[name].summary["regime"] for name in THEORIES},
        "outcome": {name: filmed.filaments[name].outcome.name for name in THEORIES},
        "effects": {name: list(filmed.filaments[name].summary["effects"]) for name in THEORIES},
        "strain_at_clamp": {
            "mean": float(np.expm1(run.clamp_strain[-1])),
            "largest": float(np.expm1(run.clamp_strain_largest[-1])),
        },
        "dissipated_over_work_of_gravity": float(run.energy_dissipated[-1] / run.work),
        "mesh": [run.mesh.along, run.mesh.through],
        "element_steps": run.steps,
    }


def _tabulated(time: Floats, height: Floats) -> dict[str, float | None]:
    """Heights at `MOMENTS`, and their mean while the filament rings; None after a run has ended early."""
    slack = 1e-9 * MOMENTS[-1]
    at = {f"{t:g}": float(np.interp(t, time, height)) if t <= time[-1] + slack else None for t in MOMENTS}
    late = time >= RINGING_SINCE
    whole = MOMENTS[-1] <= time[-1] + slack
    return {**at, "mean": float(height[late].mean()) if whole else None}
