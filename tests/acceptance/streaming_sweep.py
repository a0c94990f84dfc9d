"""A sweep in a process of its own that prints its peak memory as members are done."""

from __future__ import annotations

import json
import sys
import time
from pathlib import Path

import softcat_sym as sc
from softcat_sym.studies.sweep import peak_memory

STEP = 1000


class Memory:
    """Notes the peak memory [MB] at every thousand members."""

    def __init__(self) -> None:
        self.peaks: dict[int, float] = {}

    def update(self, done: int, members: int, left: float) -> None:
        """Note it if it is time to."""
        del members, left
        if done % STEP == 0:
            self.peaks[done] = peak_memory()


def main(directory: str, members: int) -> None:
    """Run a Latin hypercube of so many members; print what was measured."""
    changes = {"run.effects": "paper", "numerics.cells": 10, "run.accuracy": 0.01, "run.frames": 41}
    scene = sc.load_scene("continual-descent", changes)
    memory, begun = Memory(), time.monotonic()
    vary = ("groups.G=0.05:1.5:log", "groups.V=10:100:log")
    done = sc.sweep(scene, vary, Path(directory), mode="lhs", samples=members, seed=1, progress=memory)
    memory.peaks[members] = peak_memory()
    told = {"peaks": memory.peaks, "wall": time.monotonic() - begun, "outcomes": dict(done.counts.outcomes)}
    print(json.dumps(told | {"place": done.place, "bytes": done.path.stat().st_size}))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
