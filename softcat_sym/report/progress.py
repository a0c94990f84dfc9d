"""Progress of an integration on the terminal: simulated time, mean step, elapsed."""

from __future__ import annotations

import time
from types import TracebackType
from typing import TYPE_CHECKING, Self

from softcat_sym.report.units import significant, time_unit

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress as RichProgress
    from rich.progress import TaskID

_DELAY = 1.0
_INTERVAL = 0.1


class IntegrationProgress:
    """A progress bar that appears once a run takes longer than a second, and disappears when it ends.

    Parameters
    ----------
    duration : float
        Time to be simulated [s].
    description : str
        What is going on.
    quiet : bool
        Show nothing.
    force : bool
        Show at once, without waiting a second.
    console : rich.console.Console or None
        Where to draw; standard error by default. Nothing is drawn where that is not a terminal.

    Notes
    -----
    Drawn from within `update`, ten times a second at most: no thread of its own competes with the integration.
    """

    def __init__(
        self,
        duration: float,
        description: str = "integrating",
        *,
        quiet: bool = False,
        force: bool = False,
        console: Console | None = None,
    ) -> None:
        self._duration = duration
        self._description = description
        self._silent = quiet
        self._delay = 0.0 if force else _DELAY
        self._console = console
        self._start = self._drawn = time.monotonic()
        self._reached = 0.0
        self._stepped = 0.0
        self._steps = 0.0
        self._bar: RichProgress | None = None
        self._task: TaskID | None = None

    def __enter__(self) -> Self:
        self._start = time.monotonic()
        if not self._silent and self._delay == 0:
            self._draw()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()
            self._bar = None

    @property
    def shown(self) -> bool:
        """Whether the bar is on the terminal."""
        return self._bar is not None

    @property
    def mean_step(self) -> float | None:
        """Mean step so far [s]: time covered over steps taken; ``None`` until a step is known."""
        return self._stepped / self._steps if self._steps > 0 else None

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the progress made, and draw it if it is time to.

        Parameters
        ----------
        simulated_time : float
            Time reached [s].
        step_size : float or None
            Mean step since the last call [s], or the last step; ``None`` if unknown.
        """
        advance = simulated_time - self._reached
        if advance > 0:
            self._reached = simulated_time
            if step_size is not None and step_size > 0:
                self._stepped += advance
                self._steps += advance / step_size
        if self._silent:
            return
        now = time.monotonic()
        waited = now - self._drawn >= _INTERVAL if self.shown else now - self._start >= self._delay
        if waited:
            self._drawn = now
            self._draw()

    def _draw(self) -> None:
        """Make the bar on first use, then bring it up to date."""
        if self._bar is None:
            self._make()
        if self._bar is None or self._task is None:
            return
        done = min(self._reached, self._duration)
        self._bar.update(self._task, completed=done, state=self._state())
        self._bar.refresh()

    def _make(self) -> None:
        """Load rich, unless there is no terminal to draw on: then stay silent for good."""
        from rich.console import Console
        from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

        console = self._console or Console(stderr=True)
        if not console.is_terminal:
            self._silent = True
            return
        self._bar = Progress(
            TextColumn("{task.description}", markup=False),
            BarColumn(bar_width=24),
            TextColumn("{task.fields[state]}", markup=False),
            TimeElapsedColumn(),
            console=console,
            auto_refresh=False,
            transient=True,
        )
        self._task = self._bar.add_task(self._description, total=self._duration, state=self._state())
        self._bar.start()

    def _state(self) -> str:
        """Simulated time of the duration, and the mean step."""
        clock = time_unit(self._duration)
        reached = f"{significant(self._reached / clock.size)} of {clock.text(self._duration)}"
        step = self.mean_step
        return reached if step is None else f"{reached}, step {time_unit(step).text(step)}"


class StepProgress:
    """A progress bar over a known number of tasks, such as the runs of a study.

    Parameters
    ----------
    steps : int
        How many there are.
    description : str
        What is going on.
    quiet : bool
        Show nothing.
    console : rich.console.Console or None
        Where to draw; standard error by default. Nothing is drawn where that is not a terminal.
    """

    def __init__(self, steps: int, description: str, *, quiet: bool = False, console: Console | None = None) -> None:
        self._steps, self._description, self._silent = steps, description, quiet
        self._console, self._begun = console, 0
        self._bar: RichProgress | None = None
        self._task: TaskID | None = None

    def __enter__(self) -> Self:
        from rich.console import Console
        from rich.progress import Progress as Bar

        console = self._console or Console(stderr=True)
        if not self._silent and console.is_terminal:
            self._bar = Bar(console=console, transient=True)
            self._task = self._bar.add_task(self._description, total=self._steps)
            self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()

    def step(self, what: str) -> None:
        """Say which task begins."""
        if self._bar is not None and self._task is not None:
            self._bar.update(self._task, description=what, completed=self._begun)
        self._begun += 1
