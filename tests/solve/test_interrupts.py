"""Ctrl-C stops an integration, wherever it is, and leaves Python's own handler in place."""

from __future__ import annotations

import os
import signal
import threading
import time

import pytest

import softcat_sym as sc
from softcat_sym.solvers.solution import Silence, watched


def test_a_signal_in_the_middle_of_the_integration_stops_it() -> None:
    """The run takes far longer than the signal needs to come; the time it took is the time to the signal."""
    scene = sc.load_scene("no-yield", {"numerics.cells": 60, "numerics.rtol": "1e-9"})
    started: list[float] = []

    class Started(Silence):
        def update(self, simulated_time: float, step_size: float | None) -> None:
            del simulated_time, step_size
            if not started:
                started.append(time.monotonic())
                threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()

    with pytest.raises(KeyboardInterrupt):
        sc.simulate(scene, Started())
    assert time.monotonic() - started[0] < 5
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_what_was_swallowed_is_raised_again() -> None:
    with watched() as interrupts, pytest.raises(KeyboardInterrupt):
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            interrupts.check()
    with watched() as quiet:
        quiet.check()


def test_a_program_that_handles_the_signal_itself_is_left_alone() -> None:
    seen: list[int] = []
    before = signal.signal(signal.SIGINT, lambda number, frame: seen.append(number))
    try:
        with watched() as interrupts:
            signal.raise_signal(signal.SIGINT)
            interrupts.check()
    finally:
        signal.signal(signal.SIGINT, before)
    assert seen == [signal.SIGINT]
