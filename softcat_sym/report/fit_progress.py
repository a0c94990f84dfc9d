"""Progress of a fit on the terminal."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, Self

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID


class FitProgressBar:
    """A line that says what the fit is doing, for how long, and disappears when it ends.

    Parameters
    ----------
    quiet : bool
        Show nothing.
    console : rich.console.Console or None
        Where to draw; standard error by default. Nothing is drawn where that is not a terminal.
    """

    def __init__(self, *, quiet: bool = False, console: Console | None = None) -> None:
        self._quiet, self._console = quiet, console
        self._bar: Progress | None = None
        self._task: TaskID | None = None

    def __enter__(self) -> Self:
        from rich.console import Console
        from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

        console = self._console or Console(stderr=True)
        if not self._quiet and console.is_terminal:
            text = TextColumn("{task.description}", markup=False)
            columns = (SpinnerColumn(), text, BarColumn(bar_width=24), TimeElapsedColumn())
            self._bar = Progress(*columns, console=console, transient=True, refresh_per_second=4)
            self._task = self._bar.add_task("reading and compiling", total=None)
            self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()
            self._bar = None

    def stage(self, name: str, done: int, total: int) -> None:
        """Say what begins, and how much of it is done; what is one piece only moves."""
        if self._bar is not None and self._task is not None:
            what = f"{name} {done + 1} of {total}" if total > 1 else name
            self._bar.update(self._task, description=what, completed=done, total=total if total > 1 else None)
