"""What the report reads of a scene; stated as protocols, so that a picture needs no scene file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol, TypeAlias

Summary: TypeAlias = Mapping[str, Any]
"""The dictionary that ``summary.json`` holds."""


class PicturedFilament(Protocol):
    """Geometry and density of the filament, SI."""

    @property
    def span(self) -> float:
        """Distance between the supports [m]."""

    @property
    def thickness(self) -> float:
        """Initial thickness [m]."""

    @property
    def density(self) -> float:
        """Density [kg/m^3]."""


class PicturedMaterial(Protocol):
    """The law and the two moduli that scale a picture, SI."""

    @property
    def law(self) -> str:
        """Name of the law."""

    @property
    def youngs_modulus(self) -> float | None:
        """Young's modulus [Pa]; ``None`` for a law without elasticity."""

    @property
    def yield_stress(self) -> float | None:
        """Tensile yield stress [Pa]; ``None`` for a law that does not yield."""


class PicturedLoad(Protocol):
    """The load, SI."""

    @property
    def gravity(self) -> float:
        """Acceleration of gravity [m/s^2]."""


class PicturedEnds(Protocol):
    """What holds the ends."""

    @property
    def left(self) -> str:
        """``"clamped"``, or another kind of end."""

    @property
    def right(self) -> str:
        """Likewise."""

    @property
    def drop(self) -> float:
        """Right support below the left one [m]."""

    @property
    def motion(self) -> tuple[tuple[float, float, float], ...]:
        """Path of the right support; empty where it stays."""


class PicturedRun(Protocol):
    """What was asked of the run."""

    @property
    def accuracy(self) -> float:
        """Accuracy of the midpoint relative to its largest sag."""


class PicturedScene(Protocol):
    """The part of a scene that reaches a picture or a table."""

    @property
    def title(self) -> str:
        """Title, possibly empty."""

    @property
    def filament(self) -> PicturedFilament:
        """The filament."""

    @property
    def material(self) -> PicturedMaterial:
        """The material."""

    @property
    def ends(self) -> PicturedEnds:
        """The ends."""

    @property
    def load(self) -> PicturedLoad:
        """The load."""

    @property
    def run(self) -> PicturedRun:
        """The run."""
