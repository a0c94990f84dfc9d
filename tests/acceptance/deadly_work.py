"""Work for a cluster in which one item kills whoever runs it."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class DeadlyWork:
    """Doubles numbers; one of them ends the process."""

    poison: int

    def run(self, items: Sequence[int], threads: int, told: Callable[[int], None]) -> list[str]:
        """Each doubled, as text."""
        del threads
        if self.poison in items:
            os.kill(os.getpid(), signal.SIGKILL)
        time.sleep(0.02)
        told(len(items))
        return [str(2 * item) for item in items]

    def lost(self, item: int, why: str) -> str:
        """What stands for an item that is lost."""
        return f"{item} lost: {why}"
