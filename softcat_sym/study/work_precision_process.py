"""Asking another process for measurements, and ending it when it takes too long."""

from __future__ import annotations

import contextlib
import json
import os
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Mapping
from dataclasses import asdict, replace
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from softcat_sym.study.work_precision_task import Measured, Task

_BUILDING = 600.0  # s; compiling a large filament takes seconds
_GRACE = 3.0  # s that repeated runs may take beyond the limit of one
_MODULE = "softcat_sym.study.work_precision_worker"
DIED = "its process died"


class Worker:
    """One process at a time that measures tasks; started when it is first needed, and again after it was ended.

    Parameters
    ----------
    scene : pathlib.Path
        A scene file.
    limit : float
        How long one integration may take [s].
    variables : mapping, optional
        Of the process's environment, beside ours.
    """

    def __init__(self, scene: Path, limit: float, variables: Mapping[str, str] | None = None) -> None:
        self._command = [sys.executable, "-m", _MODULE, str(scene), repr(limit)]
        self._limit, self._variables = limit, dict(variables or {})
        self._child: subprocess.Popen[str] | None = None
        self._lines: queue.SimpleQueue[str] = queue.SimpleQueue()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.end()

    def measure(self, task: Task) -> Measured:
        """Have a task measured; what is not done in time, or dies, comes back as a failure."""
        child = self._running()
        began = time.perf_counter()
        with contextlib.suppress(BrokenPipeError):
            child.stdin.write(json.dumps(asdict(task)) + "\n")  # type: ignore[union-attr]
            child.stdin.flush()  # type: ignore[union-attr]
        build: Any = self._answer(_BUILDING)
        if not isinstance(build, float):
            return self._lost(build, time.perf_counter() - began, "building")
        found: Any = self._answer(self._limit + _GRACE)
        if not isinstance(found, dict):
            return replace(self._lost(found, self._limit, "integrating"), build=build)
        measured = Measured.from_document(found)
        if measured.first > self._limit:
            return replace(measured, midpoint=(), complaint=f"stopped: it took {measured.first:.3g} s")
        return measured

    def end(self) -> None:
        """End the process, at once."""
        child, self._child = self._child, None
        if child is None:
            return
        child.kill()
        child.wait()
        for stream in (child.stdin, child.stdout):
            with contextlib.suppress(BrokenPipeError):
                stream.close()  # type: ignore[union-attr]

    def _running(self) -> subprocess.Popen[str]:
        if self._child is None:
            self._lines = queue.SimpleQueue()
            self._child = subprocess.Popen(
                self._command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
                env={**os.environ, **self._variables},
                # Ctrl-C is ours to hear: the process is then ended, in whatever call it is.
                start_new_session=True,
            )
            threading.Thread(target=_read, args=(self._child, self._lines), daemon=True).start()
        return self._child

    def _answer(self, seconds: float) -> object:
        """What the process says next: None if it is silent for too long, an empty text if it is gone."""
        try:
            line = self._lines.get(timeout=seconds)
        except queue.Empty:
            return None
        return json.loads(line) if line else ""

    def _lost(self, answer: object, seconds: float, doing: str) -> Measured:
        gone = answer == ""
        code = self._child.wait() if gone and self._child is not None else None
        self.end()
        text = f"{DIED} while {doing} (status {code})" if gone else f"stopped after {seconds:.3g} s, {doing}"
        return Measured(seconds, complaint=text)


def _read(child: subprocess.Popen[str], lines: queue.SimpleQueue[str]) -> None:
    """Pass on what a process says, and an empty text at its end."""
    with contextlib.suppress(ValueError):
        for line in child.stdout:  # type: ignore[union-attr]
            lines.put(line)
    lines.put("")
