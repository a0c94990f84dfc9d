"""A process that measures: what hangs or dies in it is one lost point of a diagram, not the diagram.

``python -m softcat_sym.study.work_precision_worker SCENE LIMIT`` reads tasks as lines of JSON and answers each with
two lines: how long it took to build, then what was measured.
"""

from __future__ import annotations

import json
import os
import sys
import time
from collections.abc import Callable
from dataclasses import asdict
from statistics import median
from typing import TextIO

from softcat_sym.errors import SoftcatError
from softcat_sym.scene import load_scene
from softcat_sym.study.work_precision_programs import Bench, Solved
from softcat_sym.study.work_precision_task import Measured, Task

_REPEATS = 7
_LONG = 1.5  # s; what takes longer altogether is not repeated again
_EXPECTED = (SoftcatError, RuntimeError, ArithmeticError, ValueError, MemoryError)
"""What integrators of others raise when they cannot go on, beside our own refusals."""


def serve(scene: str, limit: float, asked: TextIO, answers: TextIO) -> None:
    """Answer tasks until there are no more."""
    bench = Bench(load_scene(scene), limit)
    for line in asked:
        began = time.perf_counter()
        try:
            solve = bench.ready(Task(**json.loads(line)))
        except _EXPECTED as error:
            _tell(answers, time.perf_counter() - began)
            _tell(answers, asdict(Measured(0.0, complaint=_words(error))))
            continue
        build = time.perf_counter() - began
        _tell(answers, build)
        _tell(answers, asdict(measure(solve, build)))


def measure(solve: Callable[[], Solved], build: float) -> Measured:
    """Integrate once to warm up, then several times; what takes long is integrated once."""
    began = time.perf_counter()
    try:
        found = solve()
    except _EXPECTED as error:
        return Measured(time.perf_counter() - began, build, complaint=_words(error))
    first = spent = time.perf_counter() - began
    seconds: list[float] = []
    while len(seconds) < _REPEATS and spent < _LONG:
        began = time.perf_counter()
        solve()
        seconds.append(time.perf_counter() - began)
        spent += seconds[-1]
    seconds = seconds or [first]
    midpoint = tuple(found.midpoint.tolist())
    return Measured(median(seconds), build, found.steps, found.evaluations, len(seconds), midpoint, first=first)


def _words(error: BaseException) -> str:
    return " ".join(str(error).split())[:300] or type(error).__name__


def _tell(answers: TextIO, what: object) -> None:
    answers.write(json.dumps(what) + "\n")
    answers.flush()


def _main() -> None:
    # SUNDIALS and SciPy's Fortran print where they like: answers go another way.
    answers = os.fdopen(os.dup(1), "w")
    silent = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silent, 1)
    os.dup2(silent, 2)
    serve(sys.argv[1], float(sys.argv[2]), sys.stdin, answers)


if __name__ == "__main__":
    _main()
