"""What an integration tells while it runs."""

from typing import Protocol


class Progress(Protocol):
    """Listens to a running integration."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Take note of the time reached [s] and of the mean step since the last call [s]."""
        ...


class Silence:
    """Tells nobody."""

    def update(self, simulated_time: float, step_size: float | None) -> None:
        """Do nothing."""
        del simulated_time, step_size
