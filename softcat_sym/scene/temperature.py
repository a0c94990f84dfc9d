"""The table [temperature]: heat of the filament, and what its temperature makes of the material."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic_core import PydanticCustomError

from softcat_sym.scene.history import History, read_table, table_history
from softcat_sym.scene.parts import Part, Rule
from softcat_sym.scene.units import (
    SI,
    Choice,
    Kind,
    NotAQuantity,
    Number,
    Quantity,
    refusal,
    refusals,
    registry,
    shown,
    split_quantity,
)

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

# `scene.units.Kind` documents the methods once for all kinds.
# ruff: noqa: D102

GAS_CONSTANT = 8.31446261815324
"""R [J/(mol K)], exact since 2019."""

PREFIX = "temperature_"
"""Of the names of the numbers of this table in a run."""

_ZERO_CELSIUS = 273.15
_CELSIUS = ("degC", "°C", "celsius", "degree_Celsius")
_FAHRENHEIT = ("degF", "°F", "fahrenheit")


class AbsoluteTemperature(Quantity):
    """A temperature on a scale with its zero: stored in kelvin."""

    def __init__(self, example: str) -> None:
        super().__init__("temperature", example, unit="K")
        self.accepted = f'a temperature above absolute zero with its unit, such as "{example}" or "300 K"'

    def measured(self, value: object) -> float:
        return float(value) if isinstance(value, SI) else _kelvin(*split_quantity(value))

    def read(self, value: object) -> float:
        try:
            kelvin = self.measured(value)
        except NotAQuantity as found:
            raise self.refuse(str(found)) from None
        if not math.isfinite(kelvin):
            raise self.refuse(f"{shown(value)} is not finite")
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
    from pint.errors import PintError

    ureg = registry()
    try:
        found = ureg.Quantity(1.0, ureg.parse_units(unit))
    except (PintError, ValueError, TypeError, AttributeError, LookupError, ArithmeticError, SyntaxError):
        raise NotAQuantity(f"unknown unit '{unit}'") from None
    try:
        factor = float(found.to(wanted).magnitude)
    except PintError:
        raise NotAQuantity(f"'{unit}' is not a unit like {wanted}") from None
    short = float(f"{factor:.12g}")
    return short if math.isclose(short, factor, rel_tol=1e-15) else factor


class Softening(Kind):
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
        rows: dict[float, float] = {}
        faults = []
        for key, given in value.items():
            try:
                kelvin = self._temperature.read(key if isinstance(key, str) else SI(key))
                rows[kelvin] = self._relative.read(float(given) if isinstance(given, SI) else given)
            except PydanticCustomError as error:
                faults.append(((str(key),), error))
        if faults:
            raise refusals("modulus", faults)
        if len(rows) < 2:
            raise self.refuse(f"a table of {len(rows)} temperatures")
        return table_history(rows)

    def write(self, value: History | None) -> object:
        return None if value is None else {f"{kelvin!r} K": relative for kelvin, relative in value.table}


class Stretch(Kind):
    """Two places along the rest length, from the left end."""

    si = True
    accepted = 'two places from the left end along the rest length, the nearer first, such as ["0 mm", "100 mm"]'
    _place = Quantity("length", "100 mm", "non-negative")

    def read(self, value: object) -> tuple[float, ...]:
        if not isinstance(value, (list, tuple)):
            raise self.refuse(f"{shown(value)} is not a list")
        if not value:
            return ()
        if len(value) != 2:
            raise self.refuse(f"a list of {len(value)}")
        low, high = (self._place.read(one) for one in value)
        if not low < high:
            raise self.refuse(f"{shown(value[0])} is not below {shown(value[1])}")
        return low, high

    def write(self, value: tuple[float, ...]) -> object:
        return [self._place.write(one) for one in value]


Softened = Literal["constant", "vft", "wlf", "arrhenius"]
Correlation = Literal["none", "cylinder-in-air"]

_OF_LAW: dict[str, tuple[str, ...]] = {
    "constant": (),
    "vft": ("B", "T_0"),
    "wlf": ("C1", "C2", "reference"),
    "arrhenius": ("activation_energy", "reference"),
}
"""Constants that each law of the viscosity needs; VFT also A or reference."""

VISCOUS = ("maxwell", "newtonian", "kelvin-voigt", "standard-linear", "multimode-maxwell")
VISCOUS_TOO = ("bingham", "power-law", "herschel-bulkley")
"""Laws of the material that have a viscosity or a consistency."""


class Temperature(Part):
    """Heat of the filament; temperatures in K."""

    table_name: ClassVar[str] = "temperature"

    initial: Annotated[float | None, AbsoluteTemperature("20 degC")] = None
    """Temperature of the filament at the start; with it the filament has a temperature at all."""
    ambient: Annotated[float | None, TimedTemperature("20 degC")] = None
    """Temperature of what surrounds the filament, or of the furnace."""
    heated: Annotated[tuple[float, ...], Stretch()] = ()
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
    modulus: Annotated[History | None, Softening()] = None
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


def temperature_rules(scene: Scene) -> Iterator[Rule]:
    """List what may be wrong with the table [temperature]."""
    heat = scene.temperature
    if not heat.present:
        fields = type(heat).model_fields
        given = sorted(name for name in heat.model_fields_set if getattr(heat, name) != fields[name].default)
        needs = f"missing, but temperature.{given[0]} is given" if given else ""
        yield given, "temperature.initial", needs, 'a temperature, such as "20 degC", or no table [temperature]'
        return
    yield from _of_exchange(scene, heat)
    yield from _of_the_law(scene, heat)
    yield from _of_the_extremes(scene, heat)


def _of_exchange(scene: Scene, heat: Temperature) -> Iterator[Rule]:
    out, either = "leaving it out", "temperature.heat_transfer, or temperature.correlation"
    found = "missing: it says how much heat a temperature is"
    yield heat.heat_capacity is None, "temperature.heat_capacity", found, 'such as "1200 J/(kg*K)"'
    small = scene.model == "small-deflection"
    yield small, "temperature", "given with model 'small-deflection'", f'{out}, or model = "filament"'
    printed = scene.run.closure == "printed"
    yield printed, "temperature", "given with run.closure = 'printed'", f'{out}, or run.closure = "material"'
    named, twice = heat.correlation != "none", "given twice, here and as temperature.correlation"
    yield named and heat.heat_transfer is not None, "temperature.heat_transfer", twice, "one of the two"
    round_ = scene.filament.section == "circle"
    found = f"'{heat.correlation}', but the section is a {scene.filament.section}"
    yield named and not round_, "temperature.correlation", found, "temperature.heat_transfer, or a circle"
    weightless = named and scene.load.gravity == 0
    found = f"'{heat.correlation}', but load.gravity is zero, without which no air rises"
    yield weightless, "temperature.correlation", found, "temperature.heat_transfer"
    alone, deaf = heat.ambient is not None, "given, but no heat passes the surface"
    yield alone and not named and heat.heat_transfer is None, "temperature.ambient", deaf, either
    lost = named or heat.heat_transfer
    yield lost and not alone, "temperature.ambient", "missing, but heat passes the surface", 'such as "20 degC"'
    if heat.heated:
        from softcat_sym.scene.scene import rest_length

        length = rest_length(scene)
        found = f"to {heat.heated[1]:.4g} m, but the filament is {length:.4g} m long"
        yield heat.heated[1] > length * (1 + 1e-9), "temperature.heated", found, f"places from 0 to {length:.4g} m"
    found = "missing: temperature.heated leaves a part of the filament out of the furnace"
    yield heat.heated and heat.outside is None, "temperature.outside", found, 'a temperature, such as "20 degC"'
    found = "given, but the whole filament is at temperature.ambient"
    yield heat.outside is not None and not heat.heated, "temperature.outside", found, f"{out}, or temperature.heated"


def _of_the_law(scene: Scene, heat: Temperature) -> Iterator[Rule]:
    law, needed, material = heat.law, _OF_LAW[heat.law], scene.material.law
    every = {name for names in _OF_LAW.values() for name in names} | {"A"}
    allowed = {*needed, *(("A", "reference") if law == "vft" else ())}
    for name in sorted(every):
        given = getattr(heat, name) is not None
        others = ", ".join(other for other, names in _OF_LAW.items() if name in (*names, *("A",) * (other == "vft")))
        found = f"given, but the law of the viscosity is '{law}'"
        yield given and name not in allowed, f"temperature.{name}", found, f"leaving it out, or law = {others}"
        found = f"missing: the law '{law}' needs it"
        yield not given and name in needed, f"temperature.{name}", found, f"a value, or a law other than '{law}'"
    if law == "vft":
        both, neither = heat.A is not None and heat.reference is not None, heat.A is None and heat.reference is None
        found = "given with temperature.reference: each says how large the viscosity is"
        yield both, "temperature.A", found, "one of the two"
        found = "missing, and so is temperature.reference: nothing says how large the viscosity is"
        yield neither, "temperature.A", found, "one of the two"
    fixed = law != "constant" and material not in (*VISCOUS, *VISCOUS_TOO)
    found = f"'{law}', but the material's law '{material}' states no viscosity"
    yield fixed, "temperature.law", found, f"constant, or one of the laws {', '.join((*VISCOUS, *VISCOUS_TOO))}"
    viscous = material in ("newtonian", "kelvin-voigt") or scene.material.has_loss
    found = f"given, but the law '{material}' has a viscous stress, which the rate of the expansion would need"
    path, accepted = "temperature.expansion", "leaving it out, or a law without a viscous stress or a loss below yield"
    yield heat.expansion and viscous, path, found, accepted
    stiff = heat.modulus is not None and material == "newtonian"
    yield stiff, "temperature.modulus", "given, but a newtonian fluid has no modulus", "leaving it out"


def _of_the_extremes(scene: Scene, heat: Temperature) -> Iterator[Rule]:
    """A law ends where its viscosity would be infinite."""
    low, high = heat.extremes(scene.run.duration)
    if heat.law == "vft" and heat.T_0 is not None:
        for name, kelvin in (("reference", heat.reference), ("coldest temperature", low)):
            if kelvin is not None:
                found = f"{heat.T_0:g} K, not below the {name} {kelvin:g} K: the viscosity would be infinite"
                yield kelvin <= heat.T_0, "temperature.T_0", found, f"a temperature below {kelvin:g} K"
    if heat.law == "wlf" and heat.C2 is not None and heat.reference is not None:
        found = f"{heat.C2:g} K, but the coldest temperature is {heat.reference - low:g} K below the reference"
        broken = heat.C2 + low - heat.reference <= 0
        yield broken, "temperature.C2", found, f"more than {heat.reference - low:g} K, or temperature.reference nearer"
    for kelvin in {low, high}:
        factor = heat.viscosity_factor(kelvin)
        found = f"'{heat.law}', whose viscosity at {kelvin:g} K is {factor:.3g} times that of [material]"
        broken = not 1e-25 < factor < 1e25 and factor != math.inf
        yield broken, "temperature.law", found, "constants that fit the temperatures of the scene"


def is_even(scene: Scene) -> bool:
    """Tell whether the furnace leaves left and right alike."""
    from softcat_sym.scene.scene import rest_length

    heated = scene.temperature.heated
    return not heated or math.isclose(sum(heated), rest_length(scene), rel_tol=1e-12)


def kinks(scene: Scene) -> tuple[float, ...]:
    """Return the times at which the surroundings begin or cease to change [s]."""
    ambient = scene.temperature.ambient
    return tuple(time for time, _ in ambient.table) if isinstance(ambient, History) else ()
