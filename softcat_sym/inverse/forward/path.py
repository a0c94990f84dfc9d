"""What a forward model hears from an integrator: some unknowns at some times, and their derivatives."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Protocol

from softcat_sym.graph.grid import Floats
from softcat_sym.solve.starting import Start


@dataclass(frozen=True)
class Begin:
    """Where a run begins and with which numbers, and how these move with the unknowns of a fit.

    Attributes
    ----------
    start : Start
        Differential and algebraic states.
    parameters : ndarray, shape (p,)
        In the order of the graph.
    times : ndarray, shape (n,)
        Increasing and positive, in units of the time scale.
    d_parameters : ndarray, shape (k, p)
        By each unknown.
    d_x, d_z : ndarray, shapes (k, nx) and (k, nz)
        Of the start.
    """

    start: Start
    parameters: Floats
    times: Floats
    d_parameters: Floats
    d_x: Floats
    d_z: Floats

    def moved(self, unknown: int, step: float) -> Begin:
        """The same with one unknown moved, to first order."""
        start = Start(self.start.x + step * self.d_x[unknown], self.start.z + step * self.d_z[unknown])
        return replace(self, start=start, parameters=self.parameters + step * self.d_parameters[unknown])


@dataclass(frozen=True)
class Path:
    """Some unknowns at the times asked for; NaN where the integration did not get.

    Attributes
    ----------
    values : ndarray, shape (n, seen)
        The unknowns that are seen.
    slopes : ndarray, shape (k, n, seen) or None
        Their derivatives.
    steps : int
        Taken.
    complaint : str
        What went wrong; empty if nothing did.
    """

    values: Floats
    slopes: Floats | None
    steps: int
    complaint: str = ""


class Integrator(Protocol):
    """Carries a filament through the times of the data, for one set of values after another.

    Unknowns that are seen are numbered: differential ones first, algebraic ones behind them.
    """

    def run(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> Path:
        """Integrate."""
        ...

    def run_with_slopes(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> Path:
        """Integrate, with derivatives of the discrete solution."""
        ...
