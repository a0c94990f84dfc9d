"""What a sweep keeps of a member: its verdict, a few numbers, the midpoint, and its shape if asked for."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene, rest_length
from softcat_sym.study.sweep.plan import SHAPE_FRAMES, SHAPE_NODES

REFUSED, FAILED, LOST = "refused", "failed", "lost"
"""Outcomes that no run has: a scene that makes no sense, a program that failed, workers that died."""

Shapes = npt.NDArray[np.float32]


@dataclass(frozen=True)
class MemberResult:
    """A row of a sweep.

    Attributes
    ----------
    outcome : str
        Name of the outcome, or `REFUSED`, `FAILED`, `LOST`.
    regime : str
        What the run shows; an empty text if it is no answer.
    message : str
        Why it is none.
    midpoint : ndarray, shape (frames,)
        Height of midspan [m], negative down; NaN where there is no answer, as all numbers but `wall_s`.
    midpoint_final, sag_largest : float
        At the end, and the largest sag [m], positive down.
    sag_over_span : float
        `sag_largest` over the span.
    time_to_90 : float
        When the sag first reaches 90 % of its last value [s].
    largest_stretch : float
        Of the centreline, anywhere and ever.
    energy_residual : float
        Imbalance of energy over the largest energy.
    wall_s : float
        Time that it took [s], beside others.
    span, thickness, duration : float
        Of its scene [m], [m], [s].
    shapes : ndarray or None, shape (3, SHAPE_FRAMES, SHAPE_NODES)
        x [m], y [m] and stretch at equal steps of time and of material.
    """

    outcome: str
    regime: str
    message: str
    midpoint: Floats
    midpoint_final: float = math.nan
    sag_largest: float = math.nan
    sag_over_span: float = math.nan
    time_to_90: float = math.nan
    largest_stretch: float = math.nan
    energy_residual: float = math.nan
    wall_s: float = math.nan
    span: float = math.nan
    thickness: float = math.nan
    duration: float = math.nan
    shapes: Shapes | None = None


def no_answer(
    outcome: str, message: str, frames: int, scene: Scene | None = None, *, wall: float = math.nan
) -> MemberResult:
    """A member that gives no numbers; its scene, if there is one, tells how large it was."""
    nothing = np.full(frames, np.nan)
    if scene is None:
        return MemberResult(outcome, "", message, nothing, wall_s=wall)
    size = (rest_length(scene), scene.filament.thickness, scene.run.duration)
    return MemberResult(outcome, "", message, nothing, wall_s=wall, span=size[0], thickness=size[1], duration=size[2])


def answer(
    scene: Scene,
    regime: str,
    time: Floats,
    fields: Mapping[str, Floats],
    places: tuple[Floats, Floats],
    numbers: tuple[float, float],
    *,
    shapes: bool,
) -> MemberResult:
    """What is kept of a run that is an answer.

    Parameters
    ----------
    time : ndarray, shape (frames,)
        [s].
    fields : mapping of str to ndarray
        ``x``, ``y`` (frames, nodes) [m], ``stretch`` (frames, cells).
    places : pair of ndarray
        Material coordinates of nodes and cells [m].
    numbers : pair of float
        Energy residual, and wall time [s].
    shapes : bool
        Whether they are kept.
    """
    height = fields["y"][:, fields["y"].shape[1] // 2] + 0.0  # no minus zero
    span = rest_length(scene)
    sag = float(np.max(-height))
    return MemberResult(
        "solved",
        regime,
        "",
        height,
        float(height[-1]),
        sag,
        sag / span,
        time_to_share(time, -height),
        float(np.max(fields["stretch"])),
        numbers[0],
        numbers[1],
        span,
        scene.filament.thickness,
        scene.run.duration,
        _shapes(time, fields, places) if shapes else None,
    )


def time_to_share(time: Floats, sag: Floats, share: float = 0.9) -> float:
    """When the sag first reaches a share of its last value [s], between frames by a straight line; NaN if it rises."""
    if not sag[-1] > 0:
        return math.nan
    wanted = share * float(sag[-1])
    frame = int(np.argmax(sag >= wanted))
    if frame == 0:
        return float(time[0])
    before, after = float(sag[frame - 1]), float(sag[frame])
    part = (wanted - before) / (after - before)
    return float(time[frame - 1] + part * (time[frame] - time[frame - 1]))


def _shapes(time: Floats, fields: Mapping[str, Floats], places: tuple[Floats, Floats]) -> Shapes:
    """Shapes at equal steps of time and material, between frames and nodes by straight lines."""
    nodes, cells = places
    wanted = np.linspace(nodes[0], nodes[-1], SHAPE_NODES)
    instants = np.linspace(time[0], time[-1], SHAPE_FRAMES)
    after = np.clip(np.searchsorted(time, instants), 1, len(time) - 1)
    part = np.clip((instants - time[after - 1]) / (time[after] - time[after - 1]), 0.0, 1.0)[:, None]
    kept = np.empty((3, SHAPE_FRAMES, SHAPE_NODES), dtype=np.float32)
    for k, (name, at) in enumerate((("x", nodes), ("y", nodes), ("stretch", cells))):
        shown = (1 - part) * fields[name][after - 1] + part * fields[name][after]
        kept[k] = [np.interp(wanted, at, row) for row in shown]
    return kept
