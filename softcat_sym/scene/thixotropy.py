"""The table [material.structure]: how the material builds up at rest, and breaks down where it flows."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

from pydantic_core import PydanticCustomError

from softcat_sym.scene.units import Choice, Kind, Number, Quantity, read_fields, refusal, refusals, shown

Growth = Literal["saturating", "linear"]
Rheometer = Literal["tension", "shear"]

# `scene.units.Kind` documents the methods once for all kinds.
# ruff: noqa: D102

_TIME = ("build_up_time", "breakdown_time", "rest")
_ENDS = ("structured_yield_stress", "destroyed_yield_stress", "structured_viscosity", "destroyed_viscosity")

_KINDS: dict[str, Kind] = {
    "build_up_time": Quantity("time", "60 s"),
    "breakdown_time": Quantity("time", "2 s", "non-negative"),
    "exponent": Number(above=0),
    "structured_yield_stress": Quantity("stress", "900 Pa"),
    "destroyed_yield_stress": Quantity("stress", "200 Pa", "non-negative"),
    "structured_viscosity": Quantity("viscosity", "5 kPa*s"),
    "destroyed_viscosity": Quantity("viscosity", "500 Pa*s"),
    "initial": Number(above=0, closed=True),
    "rest": Quantity("time", "30 s", "non-negative"),
    "growth": Choice(Growth),
    "measured": Choice(Rheometer),
}

_UNITS = dict.fromkeys(_TIME, (0, 0, 1)) | {name: (1, -1, -2 if "stress" in name else -1) for name in _ENDS}


@dataclass(frozen=True, slots=True)
class Thixotropy:
    """How a structure parameter lambda, 0 destroyed to 1 built up, grows and is destroyed; SI, in tension."""

    build_up_time: float  # t_b of d lambda/dt = (1 - lambda - lambda (tau |rate|)^c)/t_b
    breakdown_time: float = 0.0  # tau, of the plastic strain rate
    exponent: float = 1.0  # c
    # At lambda = 1 and 0; None of what is as the material is at the beginning, or follows from it.
    structured_yield_stress: float | None = None
    destroyed_yield_stress: float | None = None
    structured_viscosity: float | None = None
    destroyed_viscosity: float | None = None
    initial: float | None = None  # lambda where the material's constants are measured, unless the yield stresses say it
    rest: float = 0.0  # For which it is held up before it is let go
    growth: Growth = "saturating"  # linear: d lambda/dt = (1 - lambda (tau |rate|)^c)/t_b, without a limit
    measured: Rheometer = "tension"

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
    def numbers(self) -> dict[str, tuple[float, tuple[int, int, int]]]:
        """Its numbers with the exponents of kg, m and s, by name."""
        values = {name: getattr(self, name) for name in _KINDS if name not in ("growth", "measured")}
        return {name: (value, _UNITS.get(name, (0, 0, 0))) for name, value in values.items() if value is not None}

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


class ThixotropyTable(Kind):
    """The table of a structure, or nothing."""

    accepted = 'a table such as {build_up_time = "60 s", structured_yield_stress = "900 Pa"}'

    def read(self, value: object) -> Thixotropy | None:
        if value is None or isinstance(value, Thixotropy):
            return None if value is None else value.in_tension
        if not isinstance(value, Mapping):
            raise self.refuse(f"{shown(value)} is not a table")
        structure = Thixotropy(**read_fields("structure", value, _KINDS, ("build_up_time",)))
        if faults := _contradictions(structure):
            raise refusals("structure", faults)
        return structure.in_tension

    def write(self, value: Thixotropy | None) -> object:
        if value is None:
            return None
        given = {name: getattr(value, name) for name in _KINDS}
        return {
            name: _KINDS[name].write(one)
            for name, one in given.items()
            if one is not None and (name == "build_up_time" or one != getattr(Thixotropy(1.0), name))
        }


def _contradictions(one: Thixotropy) -> list[tuple[tuple[str, ...], PydanticCustomError]]:
    """What its numbers cannot be together."""
    faults = list[tuple[tuple[str, ...], PydanticCustomError]]()
    of_yield = one.structured_yield_stress is not None or one.destroyed_yield_stress is not None
    if of_yield and one.initial is not None:
        found = "given, but the yield stresses say how far the material is built up at the beginning"
        faults.append((("initial",), refusal(found, "leaving it out")))
    if one.structured_viscosity is not None and one.destroyed_viscosity is not None:
        found = "given beside structured_viscosity: with the viscosity at the beginning it would be given twice"
        faults.append((("destroyed_viscosity",), refusal(found, "one of the two")))
    if not of_yield and one.structured_viscosity is None and one.destroyed_viscosity is None:
        accepted = ", ".join(_ENDS)
        faults.append(((), refusal("no constant of the material depends on it", f"one of {accepted}")))
    return faults


KEYS = tuple(_KINDS)
"""Keys of the table."""
