"""Results that are refused: stamped on every picture, and drawn no further than they look like a filament."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from softcat_sym.report.style import VERMILLION
from softcat_sym.report.units import time_unit

if TYPE_CHECKING:
    import xarray as xr
    from matplotlib.figure import Figure
    from matplotlib.text import Text

    from softcat_sym.report.contract import Summary

STAMP: Final = "REFUSED: "

_USED: Final = ("", "solved")
"""Outcomes of answers that may be used; nothing is known of one without outcome."""


def refused(summary: Summary) -> str:
    """Outcome of a result that is refused; empty of one that may be used."""
    outcome = str(summary.get("outcome") or "")
    return "" if outcome in _USED else outcome


def stamp(figure: Figure, summary: Summary) -> list[Text]:
    """Write across a picture that its result is refused, and what of it is not drawn.

    Returns
    -------
    list of matplotlib.text.Text
        Empty for a result that may be used.
    """
    outcome = refused(summary)
    if not outcome:
        return []
    width, height = figure.get_size_inches()
    lines = [STAMP + outcome, *([str(summary["not_drawn"])] if summary.get("not_drawn") else [])]
    texts = []
    # Letters of a bold font are three quarters as wide as it is high.
    big, small = (
        min(size, 72 * 0.8 * width / (0.75 * len(line)))
        for size, line in zip((30.0, 11.0), (lines * 2)[:2], strict=True)
    )
    for text, size, below in zip(lines, (big, small), (0.0, 1.1 * big / 72), strict=False):
        texts.append(
            figure.text(
                0.5, 0.5 - below / height, text, ha="center", va="center", fontsize=size, fontweight="bold",
                color=VERMILLION, alpha=0.75, zorder=100, parse_math=False, in_layout=False,
                bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.6, "pad": 1.5},
            )
        )  # fmt: skip
    return texts


def shown_part(data: xr.Dataset, summary: Summary) -> tuple[xr.Dataset, Summary]:
    """A run as it is drawn: one that is refused ends where it hangs deeper than it is long.

    A neck that runs away would otherwise scale the axes, as if its depth were an answer.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with ``x``, ``y`` (time, node) and ``X_node`` [m].
    summary : mapping
        The run's summary.

    Returns
    -------
    data : xarray.Dataset
        The frames that are drawn, at least one.
    summary : mapping
        With ``not_drawn``, in words, if frames are left out.
    """
    if not refused(summary):
        return data, summary
    x, y = (np.asarray(data[name].values, dtype=np.float64) for name in ("x", "y"))
    line = y[:, :1] + (y[:, -1:] - y[:, :1]) * np.linspace(0.0, 1.0, y.shape[1])
    reach = np.maximum(np.ptp(data["X_node"].values), np.hypot(x[:, -1] - x[:, 0], y[:, -1] - y[:, 0]))
    # Written so that what is not a number is beyond it too.
    beyond = ~(np.abs(y - line).max(axis=1) <= reach)
    if not beyond.any():
        return data, summary
    end = max(1, int(beyond.argmax()))
    time = data["time"].values
    said = time_unit(float(time[-1])).text(float(time[end - 1]))
    words = f"not drawn after {said}: deeper than it is long"
    return data.isel(time=slice(0, end)), {**summary, "not_drawn": words}
