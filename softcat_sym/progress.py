"""What a command is doing, told on standard error: a line a stage on a terminal, plain lines now and then without."""

from __future__ import annotations

import sys
import threading
import time
from collections import deque
from dataclasses import dataclass, field
from types import TracebackType
from typing import TYPE_CHECKING, Self

if TYPE_CHECKING:
    from rich.console import Console
    from rich.live import Live
    from rich.table import Table

LOOK = 0.25
"""Seconds between two looks at what there is to tell."""

_DELAY, _PLAIN_DELAY = 1.0, 2.0
"""A command that ends sooner tells nothing: on a terminal, and without one [s]."""

_PLAIN_EVERY, _PLAIN_BETWEEN = 5.0, 1.0
"""Between two plain lines of one stage, and of two [s]."""

_KEPT, _WORTH = 6, 0.5
"""So many finished stages stay on the screen, those that took so long [s]."""

_SURE, _PATIENT = 0.02, 1.0
"""Share of a stage, and seconds of it, from which on its pace tells how long the rest will take."""

_BAR = 12


@dataclass
class Stage:
    """One stage of a command."""

    name: str  # What it is called
    began: float  # When [s]
    ended: float | None = None  # When; None while it lasts
    doing: str = ""  # What is being done in it
    share: float | None = None  # How much of it is done, 0 to 1; None where nobody knows
    state: str = ""  # The same in words
    _seen: deque[tuple[float, float]] = field(default_factory=deque)
    _since: float = 0.0
    _left: float | None = None

    def reach(self, now: float, share: float, state: str, left: float | None) -> None:
        """Take note of how far it is; its pace is that of the last half of the time it has taken so far."""
        if self.share is None or share < self.share:
            self._seen.clear()
            self._since = now
        self._seen.append((now, share))
        while len(self._seen) > 2 and self._seen[1][0] <= (self._since + now) / 2:
            self._seen.popleft()
        self.share, self.state, self._left = share, state, left

    def left(self) -> float | None:
        """How long the rest of it takes [s]; None where that is not known."""
        if self._left is not None or self.share is None or len(self._seen) < 2:
            return self._left
        (first, before), (last, share) = self._seen[0], self._seen[-1]
        if share < _SURE or last - self._since < _PATIENT or share <= before:
            return None
        return (1 - share) * (last - first) / (share - before)


class Display:
    """Tells on standard error which stage a command is in, for how long, and how long it still takes if that is known.

    On a terminal there is a line for each stage, from a second on, and none is left at the end. Elsewhere, as in a
    pipe, plain lines are written: at each stage that lasts, and every five seconds.
    """

    def __init__(self, *, quiet: bool = False, console: Console | None = None) -> None:
        self.stages: list[Stage] = []
        self._quiet, self._console, self._named = quiet, console, False
        # Kept, since an integrator redirects it while it works.
        self._stream = sys.stderr
        self._began = self._told_at = time.monotonic()
        self._told: Stage | None = None
        self._live: Live | None = None
        self._over, self._thread = threading.Event(), threading.Thread(target=self._watch, daemon=True)

    def __enter__(self) -> Self:
        self._began = time.monotonic()
        if not self._quiet:
            self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._over.set()
        if self.stages:
            self.stages[-1].ended = time.monotonic()
        if self._thread.ident is not None:
            self._thread.join()
        if self._live is not None:
            self._live.stop()
            self._live = None

    @property
    def shown(self) -> bool:
        """Whether anything is on the terminal."""
        return self._live is not None

    def stage(self, name: str) -> None:
        """A stage begins; without a name, whatever is done from now on is a stage of its own."""
        self._named = bool(name)
        if name:
            self._begin(name)

    def doing(self, what: str) -> None:
        """Something begins within the stage: compiling, solving."""
        if not self._named or not self.stages:
            self._begin(what)
            return
        stage = self.stages[-1]
        stage.doing, stage.share, stage.state = what, None, ""

    def reach(self, share: float, state: str, left: float | None = None) -> None:
        """Say how much of it is done, in words too, and how long it still takes if that is known [s]."""
        if self.stages:
            self.stages[-1].reach(time.monotonic(), min(1.0, share), state, left)

    def tick(self) -> None:
        """Look whether there is something to tell, and tell it."""
        now = time.monotonic()
        if self._quiet or not self.stages or now - self._began < _DELAY:
            return
        if self._live is None and self._console is None:
            from rich.console import Console

            self._console = Console(file=self._stream)
        if self._console is not None and not self._console.is_terminal:
            self._tell_plainly(now, self._console)
        elif self._console is not None:
            self._draw(now, self._console)

    def _begin(self, name: str) -> None:
        now = time.monotonic()
        if self.stages:
            self.stages[-1].ended = now
        self.stages.append(Stage(name, now))

    def _watch(self) -> None:
        while not self._over.wait(LOOK):
            self.tick()

    def _tell_plainly(self, now: float, console: Console) -> None:
        stage = self.stages[-1]
        wait = _PLAIN_EVERY if stage is self._told else _PLAIN_BETWEEN
        if now - self._began < _PLAIN_DELAY or now - max(self._told_at, stage.began) < wait:
            return
        self._told, self._told_at = stage, now
        left = stage.left()
        parts = (f"{stage.name} for {seconds(now - stage.began)}", stage.state or stage.doing, _left(left))
        console.file.write(f"softcat: {', '.join(filter(None, parts))}\n")
        console.file.flush()

    def _draw(self, now: float, console: Console) -> None:
        from rich.live import Live

        lines = self._lines(now)
        if self._live is None:
            # The integrators redirect both streams for themselves, and would restore them in the wrong order.
            self._live = Live(
                lines, console=console, transient=True, auto_refresh=False, redirect_stdout=False, redirect_stderr=False
            )
            self._live.start(refresh=True)
        else:
            self._live.update(lines, refresh=True)

    def _lines(self, now: float) -> Table:
        from rich.progress_bar import ProgressBar
        from rich.table import Table
        from rich.text import Text

        grid = Table.grid(padding=(0, 1, 0, 0))
        for width in (20, _BAR + 1, 17, 15):
            grid.add_column(no_wrap=True, overflow="ellipsis", min_width=width)
        finished = [one for one in self.stages if one.ended is not None and one.ended - one.began >= _WORTH]
        for one in finished[-_KEPT:]:
            took = seconds((one.ended or now) - one.began)
            grid.add_row(*(Text(text, style="dim") for text in (one.name, "", "done", took)))
        stage = self.stages[-1]
        bar = Text("") if stage.share is None else ProgressBar(1.0, stage.share, width=_BAR, complete_style="green")
        times = _left(stage.left()) or seconds(now - stage.began)
        grid.add_row(Text(stage.name, style="bold"), bar, Text(stage.state or stage.doing), Text(times))
        return grid


def seconds(value: float) -> str:
    """A time as people say it: ``7 s``, ``2 min 5 s``, ``1 h 10 min``."""
    whole = round(value)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60} s"
    return f"{whole // 3600} h {whole % 3600 // 60} min"


def _left(value: float | None) -> str:
    """``about 12 s left``, with two digits at most; empty where it is not known."""
    if value is None:
        return ""
    return f"about {seconds(float(f'{max(1.0, value):.2g}'))} left"
