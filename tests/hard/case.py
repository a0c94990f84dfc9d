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
    """Fixed before it is run.

    Attributes
    ----------
    family, name : str
        For the table.
    scene : callable
        Builds the scene.
    judge : callable or None
        Error of an answer; None for a case that has none to be held against.
    allowed : float
        Largest error, relative to the largest midpoint: twice the accuracy asked, as runs know their errors to a factor
        of some two, and what a limit neglects.
    refusals : tuple of str
        Outcomes (or ``SceneError``) by which the scene may be refused; empty if it must be answered. A case without a
        judge must be refused.
    says : str
        What the refusal must tell.
    gap : str
        Why the case is known to fail, where it does: it is shown in the table, and must be struck out once it passes.
    fast : bool
        Whether it runs in continuous integration.
    """

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
