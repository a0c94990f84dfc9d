"""Contours of a strand on pillars, as a photograph has them: level or tilted, with noise."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

import softcat_sym as sc
from softcat_sym.fitting.least_squares import Floats
from tests.common.draws import draws

YIELD_STRESS, MODULUS = 200.0, 30e3
"""Of the strand [Pa]."""

Line = tuple[Floats, Floats]


def strand(span: float, changes: dict[str, object] | None = None) -> sc.Scene:
    """A soft ink over one gap [m]: 0.4 mm thick, narrow, and overdamped; it gives way at 4 mm."""
    scene = sc.Scene(
        title="Strand over a gap",
        filament={"span": f"{span!r} m", "thickness": "0.4 mm", "width": "4 um", "density": "2000 kg/m^3"},
        material={
            "law": "bingham",
            "youngs_modulus": f"{MODULUS!r} Pa",
            "yield_stress": f"{YIELD_STRESS!r} Pa",
            "viscosity": "150 Pa*s",
        },
        load={"ramp": "20 ms"},
        run={"duration": "4 s", "accuracy": 0.02, "dimensions": 2},
    )
    return scene.replace(changes or {})


def photograph(
    lines: Sequence[Line],
    spans: Sequence[float],
    *,
    noise: float = 2e-6,
    tilt: float = 0.03,
    steps: Sequence[float] = (),
    pillar: float = 2e-3,
    apart: float = 25e-6,
    seed: int = 0,
) -> tuple[Floats, Floats, list[tuple[float, float]]]:
    """Points x, y [m] of the centre line over all gaps and pillars, and the x of both edges of each gap.

    `lines` are centre lines with x from halfway between the edges; `steps` the heights of the pillars after the first.
    """
    heights, begin = [0.0, *(steps or [0.0] * len(spans))], 1e-3
    places, levels = [np.arange(apart / 2, begin, apart)], []
    levels.append(np.zeros(places[0].size))
    edges = []
    for number, ((x, y), span) in enumerate(zip(lines, spans, strict=True)):
        inside, on_pillar = np.arange(apart / 2, span, apart), np.arange(apart / 2, pillar, apart)
        chord = heights[number] + (heights[number + 1] - heights[number]) * inside / span
        places += [begin + inside, begin + span + on_pillar]
        levels += [chord + np.interp(inside - span / 2, x, y), np.full(on_pillar.size, heights[number + 1])]
        edges.append(((begin, heights[number]), (begin + span, heights[number + 1])))
        begin += span + pillar
    x, y = np.concatenate(places), np.concatenate(levels)
    cos, sin = np.cos(tilt), np.sin(tilt)
    seen = cos * x - sin * y, sin * x + cos * y + noise * draws(seed).standard_normal(x.size)
    gaps = [tuple(float(cos * place - sin * height) for place, height in pair) for pair in edges]
    return *seen, gaps  # type: ignore[return-value]


def write(path: Path, x: Floats, y: Floats, gaps: Sequence[tuple[float, float]], *comments: str) -> Path:
    """Write a contour in mm."""
    lines = [f"# {one}" for one in comments]
    lines += [f"# pillars.gap = {1e3 * left:.5f}, {1e3 * right:.5f}" for left, right in gaps]
    lines += ["x_mm,y_mm", *(f"{1e3 * a:.6f},{1e3 * b:.6f}" for a, b in zip(x, y, strict=True))]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return path
