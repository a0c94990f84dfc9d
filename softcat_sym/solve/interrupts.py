"""Ctrl-C during a call into CasADi, which turns it into a RuntimeError of its own: it must be noticed here."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from softcat_sym.interrupts import interrupts_go_to


class Interrupts:
    """Whether SIGINT has come since the watch began."""

    def __init__(self) -> None:
        self._noticed = False

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal: remember it, and raise as Python does.

        Raises
        ------
        KeyboardInterrupt
            Always.
        """
        del number, frame
        self._noticed = True
        raise KeyboardInterrupt

    def check(self) -> None:
        """Raise what was swallowed.

        Raises
        ------
        KeyboardInterrupt
            If the signal has come.
        """
        if self._noticed:
            raise KeyboardInterrupt


@contextmanager
def watched() -> Iterator[Interrupts]:
    """Watch for SIGINT, unless the program handles it in its own way or this is not its main thread.

    Within a watch it is that one.
    """
    around = getattr(signal.getsignal(signal.SIGINT), "__self__", None)
    if isinstance(around, Interrupts):
        yield around
        return
    interrupts = Interrupts()
    with interrupts_go_to(interrupts.note):
        yield interrupts
