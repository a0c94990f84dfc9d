"""Ctrl-C handled in one's own way for a while, and the signals that end a program going the same way."""

from __future__ import annotations

import _thread
import math
import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from types import FrameType

from softcat_sym.errors import SoftcatError

_SHELL = 128
"""What a shell adds to the number of the signal that ended a program."""


@contextmanager
def interrupts_go_to(note: Callable[[int, FrameType | None], None]) -> Iterator[None]:
    """Let `note` handle SIGINT, unless the program handles it in its own way or this is not its main thread."""
    ours = threading.current_thread() is threading.main_thread()
    if not ours or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield
        return
    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)


class Interrupts:
    """Record of SIGINT since the watch began, and whether it is held back once or raised at once, as Python does."""

    def __init__(self, *, held_back: bool = False) -> None:
        self.noticed, self._held_back = False, held_back

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal."""
        del number, frame
        again, self.noticed = self.noticed, True
        if again or not self._held_back:
            raise KeyboardInterrupt

    def check(self) -> None:
        """Raise KeyboardInterrupt if it was swallowed, or held back; from now on whatever comes is raised."""
        self._held_back = False
        if self.noticed:
            raise KeyboardInterrupt


class Ending:
    """What has ended the program before it was done: a signal, or a time limit."""

    def __init__(self) -> None:
        self.number: int | None = None
        self._clock: threading.Timer | None = None
        self._limit = 0.0  # [s], once it is over

    @property
    def status(self) -> int:
        """Exit status of the interrupted program: 1 at a limit, or as a shell gives it, 130, 143 or 129."""
        return 1 if self._limit else _SHELL + (self.number or signal.SIGINT)

    def __str__(self) -> str:
        return f"the time limit of {self._limit:g} s is over" if self._limit else "interrupted"

    def limit(self, seconds: float) -> None:
        """Interrupt the main thread after so many seconds as Ctrl-C does."""

        def over() -> None:
            self._limit = seconds
            interrupt_main_thread()

        self._clock = threading.Timer(seconds, over)
        self._clock.daemon = True
        self._clock.start()

    def no_limit(self) -> None:
        """Take back a limit that is not over: what is left to do is brief."""
        if self._clock is not None:
            self._clock.cancel()

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal: do what Ctrl-C does at this moment."""
        self.number = number
        handler = signal.getsignal(signal.SIGINT)
        if not callable(handler):
            raise KeyboardInterrupt
        handler(signal.SIGINT, frame)


def interrupt_main_thread() -> None:
    """Do from another thread what Ctrl-C does, if the main thread hears it; a real signal wakes it where it waits."""
    ident = threading.main_thread().ident
    if ident is None or not hasattr(signal, "pthread_kill") or signal.SIGINT in signal.pthread_sigmask(0, ()):
        _thread.interrupt_main()
    else:
        signal.pthread_kill(ident, signal.SIGINT)


class TimeLimitError(SoftcatError):
    """An evaluation is requested, or lasts, after the time limit."""

    def __init__(self) -> None:
        super().__init__("the time limit passed before the first start was evaluated; accepted: a longer one")


_DEADLINE: ContextVar[float] = ContextVar("deadline", default=math.inf)


@contextmanager
def until(deadline: float) -> Iterator[None]:
    """Let what is computed meanwhile end with TimeLimitError at a time of the monotonic clock, integrations too."""
    before = _DEADLINE.set(min(deadline, _DEADLINE.get()))
    try:
        check_time()
        yield
    finally:
        _DEADLINE.reset(before)


def check_time() -> None:
    """End what is computed if its time is over."""
    if time.monotonic() > _DEADLINE.get():
        raise TimeLimitError


_NOW: ContextVar[Ending] = ContextVar("ending")


def ending() -> Ending:
    """What has ended the program that runs now; of a library, what Ctrl-C would."""
    return _NOW.get(Ending())


@contextmanager
def ended_like_ctrl_c() -> Iterator[Ending]:
    """Let SIGTERM and SIGHUP end the program as Ctrl-C does: children are ended, temporary files removed.

    For a program's entry: a library must not do so behind its user's back. A signal that is ignored or handled in
    another way stays so, and nothing is done outside the main thread.
    """
    ending = Ending()
    _NOW.set(ending)
    if threading.current_thread() is not threading.main_thread():
        yield ending
        return
    wanted = [signal.SIGTERM, *([signal.SIGHUP] if hasattr(signal, "SIGHUP") else [])]
    ours = [number for number in wanted if signal.getsignal(number) is signal.SIG_DFL]
    with _ignored_by_mask():
        for number in ours:
            signal.signal(number, ending.note)
        try:
            yield ending
        finally:
            ending.no_limit()
            for number in ours:
                signal.signal(number, signal.SIG_DFL)


@contextmanager
def _ignored_by_mask() -> Iterator[None]:
    """Where Ctrl-C is ignored, as in the background of a script, block it instead: a handler can then be installed.

    Only with a handler does a call into C notice that it is to end, whichever signal says so.
    """
    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN or not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        # Ignored first: a Ctrl-C that waits is then dropped.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
