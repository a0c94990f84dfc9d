"""Progress of a run, or of several, on standard error."""

from __future__ import annotations

from typing import TYPE_CHECKING, Self

from softcat_sym.progress import Display
from softcat_sym.report.units import significant, time_unit

if TYPE_CHECKING:
    from rich.console import Console


class IntegrationProgress(Display):
    """Tells the stages of a run, and how far its integration is.

    Parameters
    ----------
    duration : float
        Time to be simulated [s].
    description : str
        What is going on, where the run is one of several; each stage of it is a line of its own otherwise.
    quiet : bool
        Tell nothing.
    console : rich.console.Console or None
        Where to; standard error by default.
    """

    def __init__(
        self, duration: float, description: str = "", *, quiet: bool = False, console: Console | None = None
    ) -> None:
        super().__init__(quiet=quiet, console=console)
        self._duration, self._clock = duration, time_unit(duration)
        self.stage(description)

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s]."""
        del step_size
        reached = significant(min(simulated_time, self._duration) / self._clock.size)
        self.reach(simulated_time / self._duration, f"{reached} of {self._clock.text(self._duration)}")


class StepProgress(Display):
    """Tells which of a known number of tasks is being done, such as the runs of a study.

    Parameters
    ----------
    steps : int
        How many there are.
    description : str
        What is going on.
    quiet : bool
        Tell nothing.
    console : rich.console.Console or None
        Where to; standard error by default.
    """

    def __init__(self, steps: int, description: str, *, quiet: bool = False, console: Console | None = None) -> None:
        super().__init__(quiet=quiet, console=console)
        self._steps, self._begun = steps, 0
        self.stage(description)

    def step(self, what: str) -> None:
        """Say which task begins."""
        self.reach(self._begun / self._steps, f"{self._begun + 1} of {self._steps}, {what}")
        self._begun += 1


class FitProgressBar(Display):
    """Tells what a fit is doing.

    Parameters
    ----------
    quiet : bool
        Tell nothing.
    console : rich.console.Console or None
        Where to; standard error by default.
    """

    def __enter__(self) -> Self:
        self.doing("reading and compiling")
        return super().__enter__()

    def stage(self, name: str, done: int = 0, total: int = 1) -> None:
        """Say what begins, and how much of it is done."""
        if not self.stages or self.stages[-1].name != name:
            super().stage(name)
        if total > 1:
            self.reach(done / total, f"{done + 1} of {total}")
