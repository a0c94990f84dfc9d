"""The table [temperature]: heat of the filament, and what its temperature makes of the material."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache, partial
from typing import Annotated, ClassVar, Literal

from pydantic_core import PydanticCustomError

from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.history import History, read_table, table_history
from softcat_sym.scene.parts import Part
from softcat_sym.scene.units import (
    SI,
    Choice,
    Kind,
    NotAQuantity,
    Number,
    Quantity,
    Values,
    read_each,
    refusal,
    registry,
    shown,
    split_quantity,
)

with lazy_imports():
    from pint import errors as pint_errors

# `scene.units.Kind` documents the methods once for all kinds.
# ruff: noqa: D102

GAS_CONSTANT = 8.31446261815324
"""R [J/(mol K)], exact since 2019."""

FROZEN = 1e15
"""Viscosity [Pa s] at which that of a strand is capped which cools below where its law ends: it flows no more."""

MOST = 1e25
"""Viscosity over the stated one above which a law that ends at some temperature counts as ended."""

PREFIX = "temperature_"
"""Of the names of the numbers of this table in a run."""

_ZERO_CELSIUS = 273.15
_CELSIUS = ("degC", "°C", "celsius", "degree_Celsius")
_FAHRENHEIT = ("degF", "°F", "fahrenheit")


class AbsoluteTemperature(Quantity):
    """A temperature on a scale with its zero: stored in kelvin."""

    def __init__(self, example: str) -> None:
        super().__init__("temperature", example, sign="any", unit="K")
        self.accepted = f'a temperature above absolute zero with its unit, such as "{example}" or "300 K"'

    def measured(self, value: object) -> float:
        return float(value) if isinstance(value, SI) else _kelvin(*split_quantity(value))

    def read(self, value: object) -> float:
        kelvin = super().read(value)
        if kelvin <= 0:
            raise self.refuse(f"{shown(value)} is {kelvin:g} K, not above absolute zero")
        return kelvin


def _kelvin(number: float, unit: str) -> float:
    if unit in ("K", "kelvin"):
        return number
    # Without the last bits of the sum: 20.1 degC is 293.25 K.
    if unit in _CELSIUS:
        return float(f"{number + _ZERO_CELSIUS:.15g}")
    if unit in _FAHRENHEIT:
        return float(f"{(number - 32) / 1.8 + _ZERO_CELSIUS:.15g}")
    raise NotAQuantity(f"'{unit}' is no unit of temperature known here (K, degC, degF)")


class TimedTemperature(AbsoluteTemperature):
    """A temperature that may change in time: a float in kelvin, or a table of times as a `History`."""

    def __init__(self, example: str) -> None:
        super().__init__(example)
        self.constant = AbsoluteTemperature(example)
        self.accepted += ', or a table of times, such as {"0 s" = "20 degC", "60 s" = "80 degC"}'

    def read(self, value: object) -> float:
        if isinstance(value, History):
            return value
        if isinstance(value, Mapping):
            return read_table(value, self.constant)
        try:
            return self.constant.read(value)
        except PydanticCustomError as error:
            raise refusal(str((error.context or {}).get("found")), self.accepted) from None

    def write(self, value: float) -> object:
        if isinstance(value, History):
            return {f"{time!r} s": self.constant.write(one) for time, one in value.table}
        return self.constant.write(value)


class Thermal(Quantity):
    """A quantity whose unit holds kelvin or mole; of differences of temperature, not of temperatures."""

    def __init__(self, what: str, unit: str, example: str, sign: str = "positive") -> None:
        super().__init__(what, example, sign, unit)

    def measured(self, value: object) -> float:
        if isinstance(value, SI):
            return float(value)
        number, unit = split_quantity(value)
        return number * _factor(unit, self.unit)


@lru_cache(maxsize=256)
def _factor(unit: str, wanted: str) -> float:
    """One `unit` in another one."""
    if unit == wanted:
        return 1.0
    if unit in (*_CELSIUS, *_FAHRENHEIT):
        raise NotAQuantity(f"'{unit}' is a unit of temperatures, not of their differences: K")
    ureg = registry()
    try:
        found = ureg.Quantity(1.0, ureg.parse_units(unit))
    except (pint_errors.PintError, ValueError, TypeError, AttributeError, LookupError, ArithmeticError, SyntaxError):
        raise NotAQuantity(f"unknown unit '{unit}'") from None
    try:
        factor = float(found.to(wanted).magnitude)
    except pint_errors.PintError:
        raise NotAQuantity(f"'{unit}' is not a unit like {wanted}") from None
    short = float(f"{factor:.12g}")
    return short if math.isclose(short, factor, rel_tol=1e-15) else factor


class ModulusTable(Kind):
    """A table of temperatures and of moduli over those that the material states."""

    si = True
    accepted = (
        "a table of at least two temperatures and of moduli over that of [material], such as "
        '{"20 degC" = 1.0, "80 degC" = 0.2}'
    )
    _temperature, _relative = AbsoluteTemperature("20 degC"), Number(above=0)

    def read(self, value: object) -> History | None:
        if value is None or isinstance(value, History):
            return value
        if not isinstance(value, Mapping):
            raise self.refuse(f"{shown(value)} is not a table")
        rows = dict(
            read_each("modulus", {str(key): partial(self._row, key, one) for key, one in value.items()}).values()
        )
        if len(rows) < 2:
            raise self.refuse(f"a table of {len(rows)} temperatures")
        return table_history(rows)

    def _row(self, key: object, given: object) -> tuple[float, float]:
        kelvin = self._temperature.read(key if isinstance(key, str) else SI(key))  # type: ignore[arg-type]
        return kelvin, self._relative.read(float(given) if isinstance(given, SI) else given)

    def write(self, value: History | None) -> object:
        return None if value is None else {f"{kelvin!r} K": relative for kelvin, relative in value.table}


class HeatedPart(Values):
    """Two places along the rest length, from the left end."""

    def __init__(self) -> None:
        accepted = 'two places from the left end along the rest length, the nearer first, such as ["0 mm", "100 mm"]'
        super().__init__(Quantity("length", "100 mm", "non-negative"), accepted, 2)

    def read(self, value: object) -> tuple[float, ...]:
        places = super().read(value)
        if len(places) > 2:
            raise self.refuse(f"a list of {len(places)}")
        if places and not places[0] < places[1]:
            raise self.refuse(f"{' is not below '.join(map(shown, self.listed(value, 'a list')))}")
        return places


Softened = Literal["constant", "vft", "wlf", "arrhenius"]
Correlation = Literal["none", "cylinder-in-air"]


class Temperature(Part):
    """Heat of the filament; temperatures in K."""

    table_name: ClassVar[str] = "temperature"

    initial: Annotated[float | None, AbsoluteTemperature("20 degC")] = None
    """Temperature of the filament at the start; with it the filament has a temperature at all."""
    ambient: Annotated[float | None, TimedTemperature("20 degC")] = None
    """Temperature of what surrounds the filament, or of the furnace."""
    heated: Annotated[tuple[float, ...], HeatedPart()] = ()
    """Part of the filament that is in the furnace, from the left end along the rest length; all of it unless given."""
    outside: Annotated[float | None, AbsoluteTemperature("20 degC")] = None
    """Temperature around the part that is not in the furnace."""
    heat_capacity: Annotated[float | None, Thermal("specific heat capacity", "J/(kg*K)", "1200 J/(kg*K)")] = None
    """Specific heat capacity."""
    heat_transfer: Annotated[
        float | None, Thermal("heat transfer coefficient", "W/(m^2*K)", "50 W/(m^2*K)", "non-negative")
    ] = None
    """Heat transfer coefficient at the surface; neither it nor a correlation: nothing is exchanged."""
    correlation: Annotated[Correlation, Choice(Correlation)] = "none"
    """Coefficient in place of heat_transfer: natural convection around a cylinder in air (Churchill & Chu 1975)."""
    conductivity: Annotated[float | None, Thermal("thermal conductivity", "W/(m*K)", "1.2 W/(m*K)")] = None
    """Thermal conductivity: along the filament, and for the Biot number; without it nothing is conducted."""
    expansion: Annotated[float, Thermal("coefficient of expansion", "1/K", "9e-6 1/K", "any")] = 0.0
    """Coefficient of linear thermal expansion, from the initial temperature: a natural strain."""
    law: Annotated[Softened, Choice(Softened)] = "constant"
    """Law of the viscosity."""
    reference: Annotated[float | None, AbsoluteTemperature("150 degC")] = None
    """Temperature at which the material has the viscosity that [material] states."""
    A: Annotated[float | None, Number()] = None
    """VFT: log10 of the viscosity at infinite temperature; in units of the one that [material] states."""
    B: Annotated[float | None, Thermal("difference of temperature", "K", "4236.1 K")] = None
    """VFT: log10 eta = A + B/(T - T_0)."""
    T_0: Annotated[float | None, AbsoluteTemperature("265.5 degC")] = None
    """VFT: temperature at which the viscosity would be infinite."""
    C1: Annotated[float | None, Number(above=0)] = None
    """WLF: log10 of the viscosity over that at the reference is -C1 (T - T_r)/(C2 + T - T_r)."""
    C2: Annotated[float | None, Thermal("difference of temperature", "K", "51.6 K")] = None
    """WLF: C2 of the formula at C1."""
    activation_energy: Annotated[float | None, Thermal("molar energy", "J/mol", "50 kJ/mol")] = None
    """Arrhenius: log of the viscosity over that at the reference is E/R (1/T - 1/T_r)."""
    modulus: Annotated[History | None, ModulusTable()] = None
    """Moduli over those of [material], at temperatures; a monotone cubic between."""

    @property
    def present(self) -> bool:
        """Whether the filament has a temperature."""
        return self.initial is not None

    @property
    def exchanges(self) -> bool:
        """Whether heat passes the surface."""
        return self.correlation != "none" or bool(self.heat_transfer)

    @property
    def activation_temperature(self) -> float | None:
        """E/R of Arrhenius [K]."""
        return None if self.activation_energy is None else self.activation_energy / GAS_CONSTANT

    def viscosity_factor(self, kelvin: float) -> float:
        """Viscosity at a temperature over the one that [material] states; infinite where it overflows."""
        decades = 0.0
        if self.law == "vft" and self.B is not None and self.T_0 is not None:
            if kelvin <= self.T_0:
                return math.inf
            at_reference = -self.B / (self.reference - self.T_0) if self.reference is not None else self.A or 0.0
            decades = at_reference + self.B / (kelvin - self.T_0)
        elif self.law == "wlf" and self.C1 is not None and self.C2 is not None and self.reference is not None:
            above = kelvin - self.reference
            if self.C2 + above <= 0:
                return math.inf
            decades = -self.C1 * above / (self.C2 + above)
        elif self.law == "arrhenius" and self.activation_temperature is not None and self.reference is not None:
            decades = self.activation_temperature * (1 / kelvin - 1 / self.reference) / math.log(10)
        try:
            return math.pow(10.0, decades)
        except OverflowError:
            return math.inf

    def frozen_below(self, factor: float) -> float:
        """Temperature at which VFT or WLF have this viscosity over the stated one [K]."""
        decades = math.log10(factor)
        if self.law == "wlf" and self.C1 is not None and self.C2 is not None and self.reference is not None:
            return self.reference - decades * self.C2 / (self.C1 + decades)
        if self.B is None or self.T_0 is None:
            return 0.0
        least = -self.B / (self.reference - self.T_0) if self.reference is not None else self.A or 0.0
        return self.T_0 + self.B / (decades - least) if decades > least else math.inf

    def modulus_factor(self, kelvin: float) -> float:
        """Modulus at a temperature over the one that [material] states."""
        return 1.0 if self.modulus is None else self.modulus.at(kelvin)

    def extremes(self, duration: float) -> tuple[float, float]:
        """Return the lowest and the highest temperature that the filament or its surroundings have in a run [K]."""
        found = [one for one in (self.initial, self.outside) if one is not None]
        if isinstance(self.ambient, History):
            found += self.ambient.extremes(duration)
        elif self.ambient is not None:
            found.append(self.ambient)
        return min(found), max(found)
