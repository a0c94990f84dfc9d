"""Beams and cables on a floor, beside their closed forms."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

import softcat_sym as sc

RHO, G, THICK = 1000.0, 9.81, 1e-3
WEIGHT = RHO * G * THICK**2
STRING = ["extensibility", "finite-stretch", "thinning", "large-rotation", "contact"]


@dataclass(frozen=True)
class Lying:
    """What a beam on a floor shows, over the closed forms."""

    run: sc.Run
    moment: float  # At the clamp
    force: float  # Of the floor
    length: float  # Of the contact, less the closed form [m]
    blur: float  # Of either end of it [m]


def beam_on_floor(cells: int, share: float, free: float = 0.3) -> Lying:
    """A clamped beam of small slope on a floor a hundredth of its thickness below it, free over a part of the span.

    Euler and Bernoulli: the free part a = (72 E I D/q)^(1/4) presses with q a/3 where it touches, and lies flat behind.
    """
    span, depth = 0.1, THICK / 100
    a = free * span
    modulus = WEIGHT * a**4 / (72 * depth) / (THICK**4 / 12)
    scene = sc.Scene(
        filament={"span": span, "thickness": THICK, "density": RHO},
        material={"law": "elastic", "youngs_modulus": modulus},
        load={"ramp": 1.0, "gravity": G},
        floor={"depth": depth, "penetration": share * depth},
        run={"duration": 1.0, "frames": 3, "effects": ["bending", "gravity-ramp", "contact"], "accuracy": 1e-3},
        numerics={"cells": cells, "grading": 1.0, "estimate": False},
    )
    run = sc.simulate(scene)
    moments = np.polyfit(run.data.X_cell.values[-3:], run.data.moment.values[-1, -3:], 2)
    return Lying(
        run,
        float(np.polyval(moments, span / 2)) / (WEIGHT * a**2 / 6),
        run.summary["contact_force_N"] / (WEIGHT * (span - 4 / 3 * a)),
        run.summary["contact_length_m"] - (span - 2 * a),
        run.summary["contact_length_blur_m"],
    )


def cable_on_floor(cells: int, share: float) -> float:
    """Horizontal tension over q c of a cable that rises from a floor to its right end.

    It lies d_p deep, so that it rises by d_p more: c acosh(1 + H/c) + L - sqrt(H^2 + 2 c H) = span.
    """
    rise, length, c = 0.05, 0.3, 0.1
    height = rise * (1 + share)
    scene = sc.Scene(
        filament={
            "span": c * math.acosh(1 + height / c) + length - math.sqrt(height**2 + 2 * c * height),
            "rest_length": length,
            "thickness": THICK,
            "density": RHO,
        },
        material={"law": "elastic", "youngs_modulus": 1e9},
        load={"gravity": G},
        ends={"left": "pinned", "right": "pinned", "drop": -rise},
        floor={"depth": 0.0, "penetration": share * rise},
        run={"duration": 1.0, "frames": 2, "effects": STRING, "accuracy": 1e-3},
        numerics={"cells": cells, "grading": 1.0, "estimate": False},
    )
    data = sc.simulate(scene).data
    along, up = (np.diff(data[name].values[-1]) for name in ("x", "y"))
    return float((data.tension.values[-1] * along / np.hypot(along, up)).mean()) / (WEIGHT * c)
