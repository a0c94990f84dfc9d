"""What a run tells while it is being made."""

import ctypes
from typing import Protocol, runtime_checkable


class Progress(Protocol):
    """Listens to a run; one listener hears all of it, estimates and refinements included."""

    def stage(self, name: str) -> None:
        """Take note that something begins beside the first run: an estimate, a refinement."""
        ...

    def doing(self, what: str) -> None:
        """Take note of what begins within it: building, compiling, solving."""
        ...

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
    """Tells nobody; a listener that derives from it need not hear everything."""

    def stage(self, name: str) -> None:
        """Do nothing."""
        del name

    def doing(self, what: str) -> None:
        """Do nothing."""
        del what

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Do nothing."""
        del simulated_time, step_size
