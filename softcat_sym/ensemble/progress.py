"""What an ensemble tells while it runs: members done of all, time left."""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from softcat_sym.progress import Display

if TYPE_CHECKING:
    from rich.console import Console


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


class MembersBar(Display):
    """Tells on standard error how many members are done, and how long the rest takes.

    Parameters
    ----------
    description : str
        What is going on.
    console : rich.console.Console or None
        Where to; standard error by default.

    Examples
    --------
    >>> with MembersBar() as bar:  # doctest: +SKIP
    ...     ensemble = simulate_many(scene, table, progress=bar)
    """

    def __init__(self, description: str = "members", *, console: Console | None = None) -> None:
        super().__init__(console=console)
        self.stage(description)

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of how far it is."""
        self.reach(done / members, f"{done} of {members}", left)
