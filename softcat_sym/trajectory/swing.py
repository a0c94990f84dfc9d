"""How often a filament swings, and whether frames at equal times show it."""

from __future__ import annotations

import math

import numpy as np

from softcat_sym.graph.grid import Floats

FRAMES_A_PERIOD = 4.0
"""Fewer pictures a period show a swing that is not there: the wheels of the stage-coach that turn backwards."""

SEEN = 0.01
"""Of the largest sag: smaller swings do not count."""

_TURNS = 4
"""Fewer turning points make no ringing."""


def swing_period(time: Floats, midpoint: Floats) -> float | None:
    """Period [s] with which the midpoint swings, by the turning points of its frames; None where it does not.

    Parameters
    ----------
    time, midpoint : ndarray, shape (frames,)
        [s], [m]; equally spaced.

    Returns
    -------
    float or None
        Twice the mean time between turning points. Frames too far apart to follow a swing show a slower one.
    """
    scale = SEEN * float(np.abs(midpoint).max())
    turns = [0]
    for frame in range(1, len(midpoint)):
        here, last = midpoint[frame], midpoint[turns[-1]]
        before = midpoint[turns[-2]] if len(turns) > 1 else last
        if (here - last) * (last - before) > 0:
            turns[-1] = frame  # still on the same way
        elif abs(here - last) > scale:
            turns.append(frame)
    turned = turns[1:-1]
    return 2 * float(time[turned[-1]] - time[turned[0]]) / (len(turned) - 1) if len(turned) >= _TURNS else None


def frames_a_period(time: Floats, midpoint: Floats, frequency: float) -> float | None:
    """Frames for each period of the ringing; None of a filament that does not ring.

    Parameters
    ----------
    time, midpoint : ndarray, shape (frames,)
        [s], [m].
    frequency : float
        Angular frequency that is forecast [1/s], infinite where none is. What the frames show is believed unless this
        says that they are too few to show it.
    """
    period = swing_period(time, midpoint)
    if period is None:
        return None
    step = float(time[-1] - time[0]) / (len(time) - 1)
    forecast = 2 * math.pi / frequency / step
    return forecast if 0 < forecast < FRAMES_A_PERIOD else period / step


def too_few_frames(time: Floats, per_period: float | None) -> list[str]:
    """Warn of frames that show a swing slower than it is, or jagged.

    Parameters
    ----------
    time : ndarray, shape (frames,)
        [s].
    per_period : float or None
        As from :func:`frames_a_period`.
    """
    if per_period is None or per_period >= FRAMES_A_PERIOD:
        return []
    period = per_period * float(time[-1] - time[0]) / (len(time) - 1)
    enough = math.ceil(2 * FRAMES_A_PERIOD / per_period * len(time))
    return [
        f"it rings at about {1 / period:.3g} Hz, with {per_period:.2g} frames a period: too few to show the swing, "
        f"which may look slower than it is in midpoint.csv, pictures and films; run.frames = {enough} shows it"
    ]
