"""One hard case: a scene, whether it must be answered, and what its answer is held against."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import softcat_sym as sc

from .judging import Judge

PLASTIC = ("viscous-flow", "yielding")
RUPTURES = ("ruptured", "localised")


@dataclass(frozen=True)
class Case:
    """Fixed before it is run."""

    family: str
    name: str
    scene: Callable[[], sc.Scene]
    judge: Judge | None
    allowed: float = 2e-3
    refusals: tuple[str, ...] = ()
    says: str = ""
    gap: str = ""
    fast: bool = False

    @property
    def title(self) -> str:
        """For the table and the test's name."""
        return f"{self.family}: {self.name}"
