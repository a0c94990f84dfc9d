"""What only a sequence of frames tells: repeated frames, spikes, the release, and scatter beyond the stated errors."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray
from scipy.optimize import least_squares

Floats = NDArray[np.float64]

REPEATED = "repeats the frame before"
UNSEEN = "middle not seen"

_SPIKE, _BEYOND_MOTION = 8.0, 1.5
"""Standard errors by which a spike is off, and multiple of its neighbours' distance."""
_WORSE = 2.5
"""Residuals of the edges over the film's median from which on a frame is refused."""
_REPEATED_SHARE, _SAME = 0.5, 0.02
"""Change of a repeated frame over the median of its neighbours' changes: of a predicted one, and of a whole one."""
_MOVING = 5.0
"""Standard errors by which three frames in a row are off where the strand moves."""
_FITTED, _FIRST_PART = 15, 0.3
"""Frames after the onset that the release is fitted to at most, and share of the fall that they see; four at least."""

_RESOLVED = 0.6
"""Share to which differences of two more orders may shrink where they are noise alone."""

_DOUBT = 8.0
"""Independent windows that have as much weight as the errors stated without them."""


def refusals(change: Floats, rms: Floats, height: Floats, std: Floats, *, is_predicted: bool) -> dict[int, str]:
    """Reasons to refuse frames, by their places in the sequence.

    `change` is the mean difference to the frame before over that of their times, infinite for the first frame; `rms` of
    the edges' residuals; `height`, `std` of the midpoint, NaN where it was not seen. A codec that predicts writes a
    repeated frame as a small change, others once more.
    """
    seen = np.isfinite(height)
    share = _REPEATED_SHARE if is_predicted else _SAME
    # At rest, frames are alike where a codec drops the noise, and do no harm.
    moving = range(max(onset(height[seen], std[seen]), 1), change.size)
    near = {k: np.concatenate([change[max(k - 2, 1) : k], change[k + 1 : k + 3]]) for k in moving}
    off, apart = np.abs(height[1:-1] - (height[:-2] + height[2:]) / 2), np.abs(height[2:] - height[:-2])
    # Of several reasons the last one counts.
    jumps = (off > _SPIKE * std[1:-1]) & (off > _BEYOND_MOTION * apart)
    places: dict[str, Iterable[int]] = {
        "midpoint jumps there and back": 1 + np.flatnonzero(jumps),
        REPEATED: [k for k, others in near.items() if others.size and change[k] < share * np.median(others)],
        "edges unlike those of the other frames": np.flatnonzero(rms > _WORSE * np.median(rms)),
        UNSEEN: np.flatnonzero(~seen),
    }
    return {int(k): reason for reason, those in places.items() for k in those}


def onset(height: Floats, std: Floats) -> int:
    """Place of the first of three frames in which the strand moves; 0 if it does from the beginning."""
    for k in range(1, height.size - 2):
        rest = height[:k]
        error = np.hypot(np.maximum(std[k : k + 3], np.std(rest)), np.median(std[:k]))
        # Of the frames at rest the last may be in motion already, and so hide the onset.
        if np.all(np.abs(height[k : k + 3] - np.median(rest[: max(k - 1, 1)])) > _MOVING * error):
            return k if k > 1 else 0
    return height.size


def release_of(time: Floats, height: Floats, std: Floats) -> tuple[float, float]:
    """Time of the release and its standard error, by y0 + a (t - t0)^p after it; half a frame at least.

    A strand that is let go at once begins as t^2, a viscous string as t^(1/3), and one under a ramp later than it is
    released; the error says no more than that the release is near.
    """
    start, frame = onset(height, std), float(np.median(np.diff(time)))
    if start == 0 or start == height.size:
        return float(time[0]), frame
    rest = float(np.median(height[: max(start - 1, 1)]))
    beyond = np.abs(height[start:] - rest) > _FIRST_PART * np.abs(height - rest).max()
    part = slice(max(start - _FITTED, 0), start + int(np.clip(beyond.argmax(), 4, _FITTED)))
    t, y, error = time[part], height[part], std[part]
    late = float(t[-1] - time[start])

    def residual(q: Floats) -> Floats:
        elapsed = np.maximum(t - q[0], 0.0) / late
        return np.asarray((rest + q[1] * elapsed ** q[2] - y) / error)

    earliest, latest = float(time[max(start - 3, 0)]), float(time[start])
    begin = [0.5 * (time[start - 1] + latest), y[-1] - rest, 1.0]
    fitted = least_squares(residual, begin, bounds=([earliest, -np.inf, 0.3], [latest, np.inf, 3.0]),
                           x_scale=[frame, abs(begin[1]) + 1e-9, 1.0])  # fmt: skip
    return float(fitted.x[0]), 0.5 * frame


def time_factor(time: Floats, values: Floats, std: Floats) -> float:
    """Factor by which values scatter over time more than their errors say, 1 to 10.

    Divided differences of orders 3, 5 and 7 over their stated errors: the order that sees the least motion counts, in
    the slower half of its windows. Where differences go on to shrink with their order, the frames do not resolve the
    motion, and nothing is known about the noise.
    """
    found = list[float]()
    for order in (3, 5, 7):
        if time.size < 2 * order + 4:
            break
        t, y, error = (sliding_window_view(one, order + 1) for one in (time, values, std))
        # Weights of the divided difference of this order.
        apart = (t[:, :, None] - t[:, None]) / np.ptp(t, axis=1)[:, None, None] + np.eye(order + 1)
        weight = 1 / apart.prod(axis=2)
        difference = np.abs(np.sum(weight * y, axis=1)) / np.sqrt(np.sum((weight * error) ** 2, axis=1))
        slower = np.argsort(np.ptp(y, axis=1))[: max(len(y) // 2, 4)]
        found.append(1.4826 * float(np.median(difference[slower])))
    if len(found) < 2 or found[-1] < _RESOLVED * found[-2]:
        return 1.0
    # Windows overlap: so many are worth one reading. Few of them tell little against errors that hold within a frame.
    readings = time.size / 8
    factor = float(np.sqrt((readings * min(found) ** 2 + _DOUBT) / (readings + _DOUBT)))
    return float(np.clip(factor, 1.0, 10.0))
