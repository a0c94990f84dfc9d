"""What a command is doing, on standard error: bars on a terminal, plain lines now and then without one."""

from __future__ import annotations

import sys
import threading
import time
from dataclasses import dataclass, field
from types import TracebackType
from typing import TYPE_CHECKING, Self

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import TaskID

LOOK = 0.25
"""Seconds between two looks at what there is to show."""

_DELAY, _PLAIN_DELAY, _PLAIN_EVERY = 1.0, 2.0, 5.0
"""A command that ends sooner shows nothing, on a terminal and without one; and between two plain lines [s]."""

_WORTH = 0.5
"""Finished stages stay on the screen that took so long [s]."""


@dataclass
class Stage:
    """One stage of a command."""

    name: str
    began: float = field(default_factory=time.monotonic)  # [s]
    ended: float | None = None  # None while it lasts
    doing: str = ""  # What is being done in it
    share: float | None = None  # How much of it is done, 0 to 1; None where nobody knows
    state: str = ""  # The same in words


class Display:
    """Shows on standard error which stage a command is in, for how long, and how long it still takes if that is known.

    A thread of its own looks, since what compiles says nothing for a while. On a terminal none of it is left at the
    end.
    """

    def __init__(self, *, quiet: bool = False, console: Console | None = None) -> None:
        self.stages: list[Stage] = []
        self._quiet, self._console, self._named = quiet, console, False
        self._stream = sys.stderr
        self._over, self._thread = threading.Event(), threading.Thread(target=self._show, daemon=True)

    def __enter__(self) -> Self:
        if not self._quiet:
            self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._over.set()
        if self._thread.ident is not None:
            self._thread.join()

    def stage(self, name: str) -> None:
        """A stage begins; without a name, whatever is done from now on is a stage of its own."""
        self._named = bool(name)
        if name:
            self._begin(name)

    def doing(self, what: str) -> None:
        """Something begins within the stage: compiling, solving."""
        if not self._named or not self.stages:
            self._begin(what)
        else:
            stage = self.stages[-1]
            stage.doing, stage.share, stage.state = what, None, ""

    def reach(self, share: float, state: str, left: float | None = None) -> None:
        """Say how much of it is done, in words too."""
        del left  # the pace shows it
        if self.stages:
            self.stages[-1].share, self.stages[-1].state = min(1.0, share), state

    def _begin(self, name: str) -> None:
        now = time.monotonic()
        if self.stages:
            self.stages[-1].ended = now
        self.stages.append(Stage(name, now))

    def _show(self) -> None:
        if self._over.wait(_DELAY):
            return
        from rich.console import Console

        console = self._console or Console(file=self._stream)
        if console.is_terminal:
            self._draw(console)
        elif not self._over.wait(min(_PLAIN_DELAY - _DELAY, threading.TIMEOUT_MAX)):
            self._write(console)
            while not self._over.wait(_PLAIN_EVERY):
                self._write(console)

    def _write(self, console: Console) -> None:
        if self.stages:
            stage = self.stages[-1]
            parts = (f"{stage.name} for {time.monotonic() - stage.began:.0f} s", stage.state or stage.doing)
            console.file.write(f"softcat: {', '.join(filter(None, parts))}\n")
            console.file.flush()

    def _draw(self, console: Console) -> None:
        from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

        columns = (
            TextColumn("{task.description}", markup=False),
            BarColumn(12),
            TextColumn("{task.fields[state]}", markup=False),
            TimeElapsedColumn(),
            TimeRemainingColumn(),
        )
        tasks: dict[int, TaskID] = {}
        # What is printed meanwhile on the same terminal goes above the bars.
        shared = sys.stdout.isatty()
        with Progress(
            *columns, console=console, transient=True, redirect_stdout=shared, redirect_stderr=False, auto_refresh=False
        ) as bars:
            over = False
            while True:
                for number, stage in enumerate(self.stages):
                    if number not in tasks:
                        tasks[number] = bars.add_task(stage.name, total=None, state="")
                        bars.tasks[-1].start_time = stage.began
                    task = tasks[number]
                    if stage.ended is None:
                        total = None if stage.share is None else 1.0
                        bars.update(task, total=total, completed=stage.share or 0.0, state=stage.state or stage.doing)
                    elif bars.tasks[number].stop_time is None:
                        short = stage.ended - stage.began < _WORTH
                        bars.update(task, total=1.0, completed=1.0, state="done", visible=not short)
                        bars.tasks[number].stop_time = stage.ended
                bars.refresh()
                if over:
                    return
                over = self._over.wait(LOOK)


class MembersBar(Display):
    """Shows on standard error how many members are done, and how long the rest takes."""

    def __init__(self, description: str = "members", *, quiet: bool = False, console: Console | None = None) -> None:
        super().__init__(quiet=quiet, console=console)
        self.stage(description)

    def update(self, done: int, members: int, left: float) -> None:
        """Take note of how far it is."""
        self.reach(done / members, f"{done} of {members}", left)


class StudyDisplay(Display):
    """Shows the stages of a study; how far each of its integrations has come is not among them."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Hear how far an integration has come, which a command of many runs does not show."""


def seconds_text(seconds: float) -> str:
    """A time as people read it: ``4.2 ms``, ``1.3 s``, ``12 min``."""
    for size, unit in ((3600.0, "h"), (60.0, "min"), (1.0, "s"), (1e-3, "ms")):
        if seconds >= (2 if size > 1 else 1) * size:
            return f"{seconds / size:.2g} {unit}" if seconds < 100 * size else f"{seconds / size:.0f} {unit}"
    return f"{1e6 * seconds:.0f} us"


_STAGES = ("build", "compile", "solve", "estimate", "write")


class Stopwatch:
    """A stopwatch with one lap for each stage of a run."""

    def __init__(self) -> None:
        self._start = self._last = time.perf_counter()
        self._laps = dict.fromkeys(_STAGES, 0.0)

    def lap(self, stage: str) -> None:
        """Put what has passed since the last lap down to a stage."""
        now = time.perf_counter()
        self._laps[stage] += now - self._last
        self._last = now

    def set_aside(self) -> None:
        """Put everything so far down to ``estimate``, it was a trial; but for what was compiled, and is kept."""
        compiled = self._laps["compile"]
        trial = sum(self._laps.values()) - compiled
        self._laps = dict.fromkeys(_STAGES, 0.0) | {"estimate": trial, "compile": compiled}

    def laps(self) -> dict[str, float]:
        """Seconds of each stage, and their total."""
        return {**self._laps, "total": sum(self._laps.values())}
