"""What an ensemble tells while it runs: members done of all, time left."""

from __future__ import annotations

from types import TracebackType
from typing import TYPE_CHECKING, Protocol, Self

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import Progress, TaskID


class MembersProgress(Protocol):
    """Listens to a running ensemble."""

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of the members done, of how many there are, and of the time left [s]."""
        ...


class NobodyListens:
    """Tells nobody."""

    def update(self, done: int, members: int, left: float) -> None:
        """Do nothing."""
        del done, members, left


class MembersBar:
    """A progress bar on the terminal: members done, time left.

    Parameters
    ----------
    description : str
        What is going on.
    console : rich.console.Console or None
        Where to draw; standard error by default. Nothing is drawn where that is not a terminal.

    Examples
    --------
    >>> with MembersBar() as bar:  # doctest: +SKIP
    ...     ensemble = simulate_many(scene, table, progress=bar)
    """

    def __init__(self, description: str = "members", *, console: Console | None = None) -> None:
        self._description, self._console = description, console
        self._bar: Progress | None = None
        self._task: TaskID | None = None

    def __enter__(self) -> Self:
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

        console = self._console or Console(stderr=True)
        if console.is_terminal:
            left = TextColumn("{task.fields[left]:.0f} s left", markup=False)
            columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), left, TimeElapsedColumn())
            self._bar = Progress(*columns, console=console, transient=True)
            self._task = self._bar.add_task(self._description, total=None, left=0.0)
            self._bar.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()

    def update(self, done: int, members: int, left: float) -> None:
        """Show how far it is."""
        if self._bar is not None and self._task is not None:
            self._bar.update(self._task, completed=done, total=members, left=left)
