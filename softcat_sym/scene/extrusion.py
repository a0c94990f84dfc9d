"""The table [extrusion]: a nozzle that lays the strand while it hangs."""

from __future__ import annotations

import re
from typing import Annotated, Any, Literal

from softcat_sym.scene.bodies import QuantityOrWord
from softcat_sym.scene.history import ChangingQuantity
from softcat_sym.scene.parts import Part
from softcat_sym.scene.units import MOTION, Choice, Number, Quantity, refusal, shown

ALONG, DOWN = "along", "down"

_SHARE = re.compile(r"\s*([0-9.]+(?:[eE][-+]?\d+)?)\s*span\s*")


class _Stub(Quantity):
    """A length, or a share of the span."""

    def __init__(self) -> None:
        super().__init__("length", "0.5 mm")
        self.accepted = f'a share of the span, such as "0.1 span", or {self.accepted}'

    def read(self, value: object) -> Any:
        """A share as the text that it is; a length in SI."""
        if not isinstance(value, str) or not (found := _SHARE.fullmatch(value)):
            return super().read(value)
        if not 0 < float(found[1]) <= 1:
            raise refusal(f"{shown(value)} is not between 0 and 1", self.accepted)
        return f"{float(found[1])!r} span"

    def write(self, value: Any) -> object:
        """What TOML holds."""
        return value if isinstance(value, str) else super().write(value)


class _Feed(ChangingQuantity):
    """A quantity or a table of times, linear between its rows; no formula."""

    has_formulas = False


ExitEnd = Literal["clamped"]
After = Literal["hold"]


class Extrusion(Part, table="extrusion"):
    """A nozzle that lays the strand; lengths in m, velocities in m/s."""

    print_speed: Annotated[float | None, Quantity("velocity", "5 mm/s")] = None
    """Speed V of the nozzle, straight from the end of the stub to the right support; or path."""
    path: Annotated[tuple[tuple[float, ...], ...], MOTION] = ()
    """Path of the nozzle: rows of time, x and y from the left support, linear between them, held after the last."""
    speed: Annotated[float | None, _Feed("velocity", "5 mm/s")] = None
    """Feed U, rest length per time, which may be a table in time; or flow_rate, or draw_ratio."""
    flow_rate: Annotated[float | None, _Feed("volume rate", "0.6 uL/s")] = None
    """Volume per time, over the undeformed section."""
    draw_ratio: Annotated[float | None, Number(above=0)] = None
    """Speed of the nozzle over the feed, V/U; 1 unless a feed is given."""
    direction: Annotated[float | str, QuantityOrWord("angle", "60 deg", ALONG, DOWN, sign="any")] = ALONG
    """How the strand leaves the nozzle: along the path, down, or at the angle of its tangent there (down: 90 deg)."""
    exit_end: Annotated[ExitEnd, Choice(ExitEnd)] = "clamped"
    """Whether the nozzle holds the tangent of the strand."""
    swell: Annotated[float, Number(above=0)] = 1.0
    """Area of the strand over that of the nozzle; filament.thickness is the strand's."""
    start: Annotated[float | str, _Stub()] = "0.1 span"
    """Length that has come out at t = 0, straight and relaxed."""
    after: Annotated[After, Choice(After)] = "hold"
    """What the nozzle does when all is laid: it holds the strand as the right support."""

    @property
    def present(self) -> bool:
        """Whether the scene has it."""
        return bool(self.path) or self.print_speed is not None
