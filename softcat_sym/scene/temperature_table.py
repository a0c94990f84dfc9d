"""The table [temperature]: heat of the filament, and what its temperature makes of the material."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Annotated, Any, Literal

from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.history import Changing, History
from softcat_sym.scene.parts import Part
from softcat_sym.scene.units import (
    SI,
    Choice,
    NotAQuantity,
    Number,
    Quantity,
    Values,
    one_of,
    shown,
    split_quantity,
    without_rounding,
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

_CELSIUS = ("degC", "°C", "celsius", "degree_Celsius")
_FAHRENHEIT = ("degF", "°F", "fahrenheit")


class AbsoluteTemperature(Quantity):
    """A temperature on a scale with its zero: stored in kelvin."""

    def __init__(self, example: str) -> None:
        super().__init__("temperature", example, sign="any", unit="K")
        self.accepted = f'a temperature above absolute zero with its unit, such as "{example}" or "300 K"'

    def measured(self, value: object) -> float:
        if isinstance(value, SI):
            return float(value)
        number, unit = split_quantity(value)
        if unit in ("K", "kelvin"):
            return number
        if unit not in (*_CELSIUS, *_FAHRENHEIT):
            raise NotAQuantity(f"'{unit}' is no unit of temperature known here (K, degC, degF)")
        # Without the last bits of the sum: 20.1 degC is 293.25 K.
        return float(f"{(number if unit in _CELSIUS else (number - 32) / 1.8) + 273.15:.15g}")

    def check(self, value: object) -> float:
        kelvin = super().check(value)
        if kelvin <= 0:
            raise NotAQuantity(f"{shown(value)} is {kelvin:g} K, not above absolute zero")
        return kelvin


class TimedTemperature(Changing, AbsoluteTemperature):
    """A temperature that may change in time by a table."""

    has_formulas = False

    def __init__(self, example: str) -> None:
        super().__init__(example)
        self.accepted += ', or a table of times, such as {"0 s" = "20 degC", "60 s" = "80 degC"}'


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
    try:
        return without_rounding(float(one_of(unit).to(wanted).magnitude))
    except pint_errors.PintError:
        raise NotAQuantity(f"'{unit}' is not a unit like {wanted}") from None


class ModulusTable(Changing, Number):
    """A table of temperatures and of moduli over those that the material states."""

    si = True
    argument = AbsoluteTemperature("20 degC")

    def __init__(self) -> None:
        super().__init__(above=0)
        example = '{"20 degC" = 1.0, "80 degC" = 0.2}'
        self.accepted = f"a table of temperatures and of moduli over that of [material], such as {example}"

    def check(self, value: Any) -> Any:
        return value if value is None or isinstance(value, History) else self._from_table(self.table(value))


def _nearer_first(given: Any, places: tuple[float, ...]) -> tuple[float, ...]:
    if places and not places[0] < places[1]:
        raise NotAQuantity(" is not below ".join(map(shown, given)))
    return places


HEATED = Values(
    Quantity("length", "100 mm", "non-negative"),
    'two places from the left end along the rest length, the nearer first, such as ["0 mm", "100 mm"]',
    2,
    2,
    optional=True,
    then=_nearer_first,
)

Softened = Literal["constant", "vft", "wlf", "arrhenius"]
Correlation = Literal["none", "cylinder-in-air"]


class Temperature(Part, table="temperature"):
    """Heat of the filament; temperatures in K."""

    initial: Annotated[float | None, AbsoluteTemperature("20 degC")] = None
    """Temperature of the filament at the start; with it the filament has a temperature at all."""
    ambient: Annotated[float | None, TimedTemperature("20 degC")] = None
    """Temperature of what surrounds the filament, or of the furnace."""
    heated: Annotated[tuple[float, ...], HEATED] = ()
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

    def _least_decades(self) -> float:
        """VFT: log10 of the viscosity at infinite temperature over the stated one."""
        return self.A or 0.0 if self.reference is None else -(self.B or 0.0) / (self.reference - (self.T_0 or 0.0))

    def viscosity_factor(self, kelvin: float) -> float:
        """Viscosity at a temperature over the one that [material] states; infinite where it overflows."""
        decades = 0.0
        match self.law, self.B, self.T_0, self.C1, self.C2, self.reference, self.activation_temperature:
            case "vft", float(B), float(T_0), *_:
                decades = self._least_decades() + B / (kelvin - T_0) if kelvin > T_0 else math.inf
            case "wlf", _, _, float(C1), float(C2), float(reference), _:
                above = kelvin - reference
                decades = -C1 * above / (C2 + above) if C2 + above > 0 else math.inf
            case "arrhenius", _, _, _, _, float(reference), float(activation):
                decades = activation * (1 / kelvin - 1 / reference) / math.log(10)
        try:
            return math.pow(10.0, decades)
        except OverflowError:
            return math.inf

    def frozen_below(self, factor: float) -> float:
        """Temperature at which VFT or WLF have this viscosity over the stated one [K]."""
        decades = math.log10(factor)
        match self.law, self.B, self.T_0, self.C1, self.C2, self.reference:
            case "wlf", _, _, float(C1), float(C2), float(reference):
                return reference - decades * C2 / (C1 + decades)
            case _, float(B), float(T_0), *_:
                least = self._least_decades()
                return T_0 + B / (decades - least) if decades > least else math.inf
        return 0.0

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
