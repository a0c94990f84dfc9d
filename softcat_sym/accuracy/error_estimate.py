"""The error of an answer, split by where it comes from."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class ErrorEstimate:
    """Largest error of the midpoint over the run, relative to the largest midpoint; None where it was not found.

    Of a filament that rings on to the end for ten periods or more it is that of the height about which it rings and of
    the amplitude, over every five periods: see :mod:`softcat_sym.accuracy.deviation`.

    Attributes
    ----------
    space : float or None
        Of the grid, by Richardson's extrapolation from a coarser one.
    time : float or None
        Of the time steps, from a run at a looser tolerance, or at a tighter one of a filament that rings on.
    section : float or None
        Of the fibres (or of the order k) through the thickness, from a run with more of them; None also where a
        section has nothing to resolve.
    effects : float
        What the effects that were left out would change, as the finished run measures them. It is no part of the
        total: the answer is held to the accuracy asked with the effects in force.
    phase : float or None
        Of a filament that rings on: periods by which its ringing may be ahead or late at the end of the run, which is
        no part of the total either. None where the midpoint is compared instant by instant.
    """

    space: float | None
    time: float | None
    section: float | None
    effects: float
    phase: float | None = None

    @property
    def total(self) -> float | None:
        """Of grid, time steps and section together; None unless grid and time steps were both looked at."""
        if self.space is None or self.time is None:
            return None
        return self.space + self.time + (self.section or 0.0)

    def as_table(self) -> dict[str, float | None]:
        """What ``summary.json`` holds."""
        return {
            "total": self.total,
            "space": self.space,
            "time": self.time,
            "section": self.section,
            "effects": self.effects,
            "phase": self.phase,
        }
