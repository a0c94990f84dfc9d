"""Ctrl-C ends an ensemble at once: nothing goes on in the background, nothing hangs."""

from __future__ import annotations

import os
import signal
import threading
import time

import pytest

import softcat_sym as sc

# Minutes of steps that may not be longer than a hair.
LONG = sc.load_scene(
    "arrested-underdamped",
    {"run.effects": "paper", "numerics.cells": 20, "numerics.rtol": 1e-13, "run.frames": 4, "run.duration": "1000 s"},
)


class Pressed:
    """Ctrl-C after so many members."""

    def update(self, done: int, members: int, left: float) -> None:
        os.kill(os.getpid(), signal.SIGINT)


def test_ctrl_c_between_members_and_within_one() -> None:
    before = threading.active_count()
    brief = {"run.duration": ["1 ms", *["1000 s"] * 20]}
    sc.simulate_many(LONG, {"run.duration": ["1 ms"]})
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        sc.simulate_many(LONG, brief, workers=2, progress=Pressed())
    assert time.monotonic() - begun < 5
    assert threading.active_count() == before
    press = threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT))
    press.start()
    begun = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        sc.simulate_many(LONG, {"run.duration": ["1000 s"] * 20}, workers=2)
    assert time.monotonic() - begun < 5
    press.join()
    assert threading.active_count() == before
    # And the next one runs as if nothing had been.
    assert sc.simulate_many(LONG, {"run.duration": ["1 ms"] * 3}).outcomes == (sc.Outcome.solved,) * 3
