"""One experiment as it would be made, and what it would tell."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from softcat_sym.inverse.design.variables import DURATION, FRAME_RATE, SPAN, THICKNESS


@dataclass(frozen=True)
class Trial:
    """A design and the errors that it leaves.

    Attributes
    ----------
    span, thickness : float
        [m].
    frame_rate : float
        [1/s].
    duration : float
        [s].
    frames : int
        The first at the release, the last at the end.
    worst : float
        Largest relative standard error of what counts, over all rough values; infinite if the film leaves it open.
    errors : mapping of str to float
        Relative standard error of each unknown, of the camera's own in SI: each the largest over all rough values.
    sag : float
        Largest within the film [m], over all rough values; NaN where there is none.
    note : str
        Why there is no answer; empty if there is.
    """

    span: float
    thickness: float
    frame_rate: float
    duration: float
    frames: int
    worst: float
    errors: Mapping[str, float]
    sag: float = math.nan
    note: str = ""

    @property
    def values(self) -> dict[str, float]:
        """The design variables by path, in SI."""
        return {
            SPAN: self.span,
            THICKNESS: self.thickness,
            FRAME_RATE: self.frame_rate,
            DURATION: self.duration,
        }

    @property
    def changes(self) -> dict[str, object]:
        """What makes a scene this experiment, for :meth:`softcat_sym.Scene.replace`."""
        return {
            SPAN: f"{self.span!r} m",
            THICKNESS: f"{self.thickness!r} m",
            DURATION: f"{self.duration!r} s",
            "run.frames": self.frames,
        }
