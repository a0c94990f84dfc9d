"""Seconds spent in each stage of a run."""

from __future__ import annotations

import time

_STAGES = ("build", "compile", "solve", "estimate", "write")


class Clock:
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
