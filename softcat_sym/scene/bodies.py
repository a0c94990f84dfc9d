"""Bodies that a filament may come to lie on: the tables [floor] and [pillars], and their signed distances."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated, Any, ClassVar

from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.parts import Part
from softcat_sym.scene.units import Number, Quantity

if TYPE_CHECKING:
    import numpy.typing as npt

with lazy_imports():
    import numpy as np

_AUTO, _NONE, _STICK = "auto", "none", "stick"


class QuantityOrWord(Quantity):
    """A quantity, or one of a few words that stand for one which the program chooses."""

    def __init__(self, dimension: str, example: str, *words: str, sign: str = "positive") -> None:
        super().__init__(dimension, example, sign)
        self.words, self.accepted = words, f"{', '.join(words)}, or {self.accepted}"

    def read(self, value: object) -> Any:
        """A word as it is; a quantity in SI."""
        return value if isinstance(value, str) and value in self.words else super().read(value)

    def write(self, value: Any) -> object:
        """What TOML holds."""
        return value if isinstance(value, str) else super().write(value)


_KINK = 1e-3
"""Of the radius of an edge with half the thickness: changes the distance by half its square, 5e-7 of that radius."""

_BOND = Annotated[float | str, QuantityOrWord("viscosity", "1 GPa*s", _NONE, _STICK)]


def positive(value: Any) -> Any:
    """<v> = max(v, 0) of a number, an array or an expression."""
    return (value + abs(value)) / 2


def overlap(gap: Any, half: Any) -> tuple[Any, Any]:
    """Energy and force of a contact smoothed over |gap| < half, over its stiffness.

    The energy has two continuous derivatives, of which the negative first one is the force; it vanishes beyond `half`
    and is gap^2/2 + half^2/6 below -half.
    """
    near, deep = positive(half - gap), positive(-half - gap)
    return (near**3 - deep**3) / (12 * half), (near**2 - deep**2) / (4 * half)


class Body(Part):
    """A rigid body on which the filament may lie; lengths in m."""

    sizes: ClassVar[tuple[str, ...]] = ()  # Keys of the lengths that its signed distance depends on
    required: ClassVar[str] = ""  # Key without which there is no such body

    penetration: Annotated[float | str, QuantityOrWord("length", "0.2 um", _AUTO)] = _AUTO
    """How deep the filament sinks in under its own weight; auto: a tenth of run.accuracy times the smallest length."""
    bond: _BOND = _NONE
    """Viscous bond along the surface, force per length and velocity where the own weight presses: or none, or stick."""
    friction: Annotated[float, Number(above=0, closed=True)] = 0.0
    """Coefficient of Coulomb friction."""

    @property
    def present(self) -> bool:
        """Whether the scene has it."""
        return getattr(self, self.required) is not None

    @property
    def resists_sliding(self) -> bool:
        """Whether a force along its surface depends on the velocity of the filament."""
        return self.bond != _NONE or self.friction > 0

    @property
    def speed_along(self) -> float:
        """Velocity of its surface to the right [m/s]."""
        return 0.0

    @staticmethod
    def clearance(size: Any, x: Any, y: Any, thickness: Any, root: Callable[[Any], Any]) -> Any:
        """Signed distance of the lower surface of the filament from the body, of the place of its centreline.

        `size` has the lengths of the body by their keys, as numbers or as symbols.
        """
        raise NotImplementedError

    def room(self) -> float:
        """How far the midpoint can sink before it touches [m]."""
        raise NotImplementedError

    @property
    def edge_place(self) -> float | None:
        """Distance from midspan at which a filament at rest leaves it [m]; None where nothing leaves it."""
        return None

    def outlines(self, thickness: float, left: float, right: float, bottom: float) -> list[npt.NDArray[np.float64]]:
        """Its parts within a picture as polygons, (points, 2) [m]."""
        raise NotImplementedError


class Floor(Body, table="floor"):
    """A level floor, or a belt; lengths in m, velocities in m/s."""

    sizes = ("depth",)
    required = "depth"

    depth: Annotated[float | None, Quantity("length", "0.2 mm", "non-negative")] = None
    """Depth of the floor below the underside of the filament at rest; none: no floor."""
    speed: Annotated[float, Quantity("velocity", "1 mm/s", "any")] = 0.0
    """Velocity of the floor to the right, as of a belt."""

    @property
    def speed_along(self) -> float:
        """Velocity of the belt [m/s]."""
        return self.speed

    @staticmethod
    def clearance(size: Any, x: Any, y: Any, thickness: Any, root: Callable[[Any], Any]) -> Any:
        """Height of the lower surface above the floor."""
        del x, thickness, root
        return y + size.depth

    def room(self) -> float:
        """Its depth."""
        return self.depth or 0.0

    def outlines(self, thickness: float, left: float, right: float, bottom: float) -> list[npt.NDArray[np.float64]]:
        """One rectangle below its surface."""
        top = -self.room() - thickness / 2
        return [np.array([(left, min(bottom, top)), (left, top), (right, top), (right, min(bottom, top))])]


class Pillars(Body, table="pillars"):
    """Two pillars on either side of a gap, on whose level tops the filament lies; lengths in m."""

    sizes = ("gap", "edge", "height")
    required = "gap"

    gap: Annotated[float | None, Quantity("length", "5 mm")] = None
    """Distance between the walls of the pillars, whose middle is that of the span; none: no pillars."""
    edge: Annotated[float, Quantity("length", "0.1 mm", "non-negative")] = 0.0
    """Radius of their edges; 0: sharp."""
    height: Annotated[float, Quantity("length", "0 mm", "any")] = 0.0
    """Height of their tops above the underside of the filament at rest."""
    bond: _BOND = _STICK
    """Viscous bond along the tops, likewise."""

    @staticmethod
    def clearance(size: Any, x: Any, y: Any, thickness: Any, root: Callable[[Any], Any]) -> Any:
        """Distance of the centreline from edges rounded by half the thickness more, about the same centres.

        It holds down to the centres: where the two coordinates vanish together, the root is kept from its kink.
        """
        radius = size.edge + thickness / 2
        inwards, upwards = positive(size.gap / 2 + size.edge - abs(x)), positive(y - size.height + radius)
        return root(inwards**2 + upwards**2 + (_KINK * radius) ** 2) - radius

    @property
    def edge_place(self) -> float | None:
        """Where the level tops end."""
        return None if self.gap is None else self.gap / 2 + self.edge

    def room(self) -> float:
        """None where the filament lies on them."""
        return -self.height

    def outlines(self, thickness: float, left: float, right: float, bottom: float) -> list[npt.NDArray[np.float64]]:
        """Two pillars, each with its round edge."""
        top, wall, turn = self.height - thickness / 2, (self.gap or 0.0) / 2, np.linspace(0, np.pi / 2, 16)
        x = np.concatenate([[wall], wall + self.edge * (1 - np.cos(turn)), [max(right, wall), max(right, wall)]])
        y = np.concatenate([[bottom], top - self.edge * (1 - np.sin(turn)), [top, bottom]])
        return [np.stack([x, y], axis=1), np.stack([np.minimum(-x, -wall), y], axis=1)]


BODIES: dict[str, type[Body]] = {one.table_name: one for one in (Floor, Pillars)}
"""Bodies by the names of their tables."""


def body_number(body: str, key: str) -> str:
    """Name of a number of a body among those of a run."""
    return f"{body}_{key}"
