"""The table [material.structure]: how the material builds up at rest, and breaks down where it flows."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal

from softcat_sym.scene.units import (
    Choice,
    Dimension,
    Number,
    Quantity,
    Record,
    Refused,
    dimension_of,
    refusal,
    refusals,
)

Growth = Literal["saturating", "linear"]
Rheometer = Literal["tension", "shear"]
_NO_STRESS = Quantity("stress", "200 Pa", "non-negative")
_CHOICES = ("growth", "measured")
_ENDS = ("structured_yield_stress", "destroyed_yield_stress", "structured_viscosity", "destroyed_viscosity")


@dataclass(frozen=True, slots=True)
class Thixotropy:
    """How a structure parameter lambda, 0 destroyed to 1 built up, grows and is destroyed; SI, in tension."""

    # t_b of d lambda/dt = (1 - lambda - lambda (tau |rate|)^c)/t_b
    build_up_time: Annotated[float, Quantity("time", "60 s")]
    # tau, of the plastic strain rate
    breakdown_time: Annotated[float, Quantity("time", "2 s", "non-negative")] = 0.0
    exponent: Annotated[float, Number(above=0)] = 1.0  # c
    # At lambda = 1 and 0; None of what is as the material is at the beginning, or follows from it.
    structured_yield_stress: Annotated[float | None, Quantity("stress", "900 Pa")] = None
    destroyed_yield_stress: Annotated[float | None, _NO_STRESS] = None
    structured_viscosity: Annotated[float | None, Quantity("viscosity", "5 kPa*s")] = None
    destroyed_viscosity: Annotated[float | None, Quantity("viscosity", "500 Pa*s")] = None
    # lambda where the material's constants are measured, unless the yield stresses say it
    initial: Annotated[float | None, Number(above=0, closed=True)] = None
    rest: Annotated[float, Quantity("time", "30 s", "non-negative")] = 0.0  # Before it is let go
    # linear: d lambda/dt = (1 - lambda (tau |rate|)^c)/t_b, without a limit
    growth: Annotated[Growth, Choice(Growth)] = "saturating"
    measured: Annotated[Rheometer, Choice(Rheometer)] = "tension"

    @property
    def in_tension(self) -> Thixotropy:
        """The same with stresses, viscosities and rates of a rheometer in shear converted."""
        if self.measured == "tension":
            return self
        factors = dict.fromkeys(("structured_yield_stress", "destroyed_yield_stress", "breakdown_time"), math.sqrt(3.0))
        factors |= {"structured_viscosity": 3.0, "destroyed_viscosity": 3.0}
        changed = {name: factor * value for name, factor in factors.items() if (value := getattr(self, name))}
        return replace(self, measured="tension", **changed)

    @property
    def numbers(self) -> dict[str, tuple[float, Dimension]]:
        """Its numbers with the exponents of kg, m and s, by name."""
        given = ((name, getattr(self, name), kind.unit) for name, kind in STRUCTURE.kinds.items())
        return {
            name: (value, dimension_of(unit))
            for name, value, unit in given
            if value is not None and name not in _CHOICES
        }

    def start(self, yield_stress: float | None) -> float:
        """The structure parameter of the material as its constants state it."""
        high, low = self.structured_yield_stress, self.destroyed_yield_stress
        if yield_stress is None or (high is None and low is None):
            return self.initial or 0.0
        high, low = (yield_stress if one is None else one for one in (high, low))
        return (yield_stress - low) / (high - low) if high != low else 0.0

    def grown(self, start: float, time: float) -> float:
        """The structure parameter after a time at rest."""
        if self.growth == "linear":
            return start + time / self.build_up_time
        return 1 - (1 - start) * math.exp(-time / self.build_up_time)


class _Structure(Record):
    """The table of a structure, whose numbers can be together, in tension."""

    def check(self, value: Any) -> Thixotropy | None:
        one: Thixotropy | None = super().check(value)
        if one is None or one is value:
            return one and one.in_tension
        faults = list[Refused]()
        if one.initial is not None and any(getattr(one, name) is not None for name in _ENDS[:2]):
            found = "given, but the yield stresses say how far the material is built up at the beginning"
            faults.append((("initial",), refusal(found, "leaving it out")))
        if one.structured_viscosity is not None and one.destroyed_viscosity is not None:
            found = "given beside structured_viscosity: with the viscosity at the beginning it would be given twice"
            faults.append((("destroyed_viscosity",), refusal(found, "one of the two")))
        if all(getattr(one, name) is None for name in _ENDS):
            faults.append(((), refusal("no constant of the material depends on it", f"one of {', '.join(_ENDS)}")))
        if faults:
            raise refusals("structure", faults)
        return one.in_tension


STRUCTURE = _Structure(Thixotropy, 'a table such as {build_up_time = "60 s", structured_yield_stress = "900 Pa"}')
