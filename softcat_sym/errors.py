"""The exceptions that reach a user: each says what is wrong, where, and what would be accepted."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Fault:
    """One thing wrong with a scene.

    Attributes
    ----------
    path : str
        Dotted path in the scene, such as ``material.yield_stress``; empty for the file itself.
    found : str
        What was found there.
    accepted : str
        What would be accepted instead.
    """

    path: str
    found: str
    accepted: str

    def __str__(self) -> str:
        where = f"{self.path}: " if self.path else ""
        return f"{where}{self.found}; accepted: {self.accepted}" if self.accepted else f"{where}{self.found}"


class SoftcatError(Exception):
    """Anything this package refuses to do. Catch it to catch all the others; its text says what to change."""


class SceneError(SoftcatError):
    """A scene that cannot be read or makes no sense. Every fault is listed at once; mend the paths it names."""

    def __init__(self, faults: list[Fault] | tuple[Fault, ...], source: str = "") -> None:
        self.faults = tuple(faults)
        self.source = source
        count = "1 fault" if len(self.faults) == 1 else f"{len(self.faults)} faults"
        head = f"scene {source}: {count}" if source else f"scene: {count}"
        super().__init__("\n".join([head, *(f"  {fault}" for fault in self.faults)]))


class PrintingError(SoftcatError):
    """An expression holds a function or symbol that the CasADi printer does not know: extend its whitelist, or bind."""


class SoftcatWarning(UserWarning):
    """What speaks against the answer of a run that :func:`softcat_sym.simulate` returned; see it before you use it."""
