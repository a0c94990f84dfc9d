"""One measurement of a work-precision diagram, as it is asked of another process and as it comes back."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Task:
    """One program with one set of its numbers.

    Attributes
    ----------
    program : str
        Key of a program, such as ``"compiled-rodas5p"``.
    cells : int
        Per half span.
    grading : float
        Length of the cells at midspan over that at the clamps.
    section : int
        Fibres through the thickness, or the order of their polynomial; 0 where a section has no choice.
    by_order : bool
        Whether `section` is an order.
    rtol : float
        Relative tolerance; of RK4 its step over the longest stable one.
    """

    program: str
    cells: int
    grading: float
    section: int = 0
    by_order: bool = False
    rtol: float = 1e-3

    @property
    def text(self) -> str:
        """As people read it: ``40 cells, 8 fibres, rtol 1e-03``."""
        parts = [f"{self.cells} cells"]
        if self.section:
            parts.append(f"k = {self.section}" if self.by_order else f"{self.section} fibres")
        if self.program in STEPPED:
            parts += [f"grading {self.grading:.3g}", f"{self.rtol:g} of the stable step"]
        else:
            parts.append(f"rtol {self.rtol:.0e}")
        return ", ".join(parts)


STEPPED = frozenset({"compiled-rk4", "numpy-rk4"})
"""Programs that take equal steps."""


@dataclass(frozen=True, slots=True)
class Measured:
    """What came of a task.

    Attributes
    ----------
    seconds : float
        Median wall time of the integration of several warm runs [s]; of what failed, how long it took to.
    build : float
        Wall time of everything before, the first time in a process, libraries found in the cache [s].
    steps, evaluations : int
        Steps, and right-hand sides without those of Jacobians; 0 where nobody counts.
    repeats : int
        Runs of which `seconds` is the median.
    midpoint : tuple of float
        Height of midspan at the output times, in rest lengths; empty if it failed.
    complaint : str
        Why it failed, else empty.
    first : float
        Wall time of the first integration, before anything is warm [s].
    """

    seconds: float
    build: float = 0.0
    steps: int = 0
    evaluations: int = 0
    repeats: int = 0
    midpoint: tuple[float, ...] = ()
    complaint: str = ""
    first: float = 0.0

    @property
    def microseconds(self) -> float | None:
        """Of one step; None where nobody counts them."""
        return 1e6 * self.seconds / self.steps if self.steps else None

    def document(self) -> dict[str, Any]:
        """Plain values."""
        return asdict(self)

    @classmethod
    def from_document(cls, values: dict[str, Any]) -> Measured:
        """From plain values.

        Raises
        ------
        TypeError
            If they are those of something else.
        """
        return cls(**{**values, "midpoint": tuple(values["midpoint"])})
