"""The raw answer of an integration."""

from __future__ import annotations

from dataclasses import dataclass, replace

from softcat_sym.graph.grid import Floats
from softcat_sym.solve.outcome import Outcome


@dataclass(frozen=True)
class Solution:
    """States at the output times that were reached.

    Attributes
    ----------
    time : ndarray, shape (frames,)
        In units of the time scale; shorter than asked if the integration failed.
    x, z, quad : ndarray, shapes (nx, frames), (nz, frames), (3, frames)
        Differential and algebraic states, and the quadratures (plastic work, work of the changing load, work against
        the necking gradient).
    outcome : Outcome
        How it ended.
    complaint : str
        Time, worst component and the integrator's words, if it failed.
    steps : int
        Steps taken.
    """

    time: Floats
    x: Floats
    z: Floats
    quad: Floats
    outcome: Outcome
    complaint: str
    steps: int

    def every(self, stride: int, time: Floats) -> Solution:
        """The same at every so many of its times, called those of `time`."""
        x, z, quad = (part[:, ::stride] for part in (self.x, self.z, self.quad))
        return replace(self, time=time[: x.shape[1]], x=x, z=z, quad=quad)
