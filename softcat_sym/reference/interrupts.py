"""Ctrl-C that waits until the state is whole: it is noticed between two calls into C, never in the midst of one."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from softcat_sym.interrupts import interrupts_go_to


class Interrupt:
    """Whether SIGINT has come."""

    def __init__(self) -> None:
        self.pending = False

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal: remember it; when it comes again, do not wait any longer.

        Raises
        ------
        KeyboardInterrupt
            The second time.
        """
        del number, frame
        if self.pending:
            raise KeyboardInterrupt
        self.pending = True


@contextmanager
def deferred() -> Iterator[Interrupt]:
    """Put SIGINT off, unless the program handles it in its own way or this is not its main thread."""
    interrupt = Interrupt()
    with interrupts_go_to(interrupt.note):
        yield interrupt
