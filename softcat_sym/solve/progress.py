"""What an integration tells while it runs."""

import ctypes
from typing import Protocol, runtime_checkable


class Progress(Protocol):
    """Listens to a running integration."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s] and of the mean step since the last call [s]."""
        ...


@runtime_checkable
class Flagged(Protocol):
    """A listener that ends integrations by a flag the compiled solver itself looks at: no thread need watch it."""

    @property
    def flag(self) -> ctypes.c_int:
        """Not zero once they are to end."""
        ...


class Silence:
    """Tells nobody."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Do nothing."""
        del simulated_time, step_size
