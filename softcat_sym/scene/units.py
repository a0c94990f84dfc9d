"""Text such as ``'6 mm'`` becomes a plain SI float, here and nowhere else; kinds of value, faults by path."""

from __future__ import annotations

import math
import re
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from difflib import get_close_matches
from functools import cache, lru_cache
from numbers import Integral, Real
from tokenize import TokenError
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Literal, Protocol, runtime_checkable
from unicodedata import category

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, ErrorDetails, InitErrorDetails, PydanticCustomError, ValidationError, core_schema

from softcat_sym.errors import Fault

if TYPE_CHECKING:
    from pint import UnitRegistry

_LENGTH, _TIME, _MASS, _ANGLE = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 0.0, 0.0)
_STRESS, _VISCOSITY, _DENSITY = (1.0, -1.0, -2.0), (1.0, -1.0, -1.0), (1.0, -3.0, 0.0)
_ACCELERATION, _TENSION, _CURVATURE, _FREQUENCY = (0.0, 1.0, -2.0), (1.0, 0.0, -2.0), (0.0, -1.0, 0.0), (0.0, 0.0, -1.0)

_FACTORS: Mapping[tuple[float, float, float], Mapping[str, float]] = {
    _LENGTH: {"m": 1.0, "cm": 0.01, "mm": 0.001, "um": 1e-6, "nm": 1e-9, "km": 1000.0},
    _TIME: {"s": 1.0, "ms": 0.001, "us": 1e-6, "min": 60.0, "h": 3600.0},
    _MASS: {"kg": 1.0, "g": 0.001, "mg": 1e-6},
    _ANGLE: {"rad": 1.0, "deg": 0.017453292519943295},
    _STRESS: {"Pa": 1.0, "mPa": 0.001, "kPa": 1000.0, "MPa": 1e6, "GPa": 1e9},
    _VISCOSITY: {"Pa*s": 1.0, "mPa*s": 0.001, "kPa*s": 1000.0, "MPa*s": 1e6, "GPa*s": 1e9},
    _DENSITY: {"kg/m^3": 1.0, "g/cm^3": 1000.0},
    _ACCELERATION: {"m/s^2": 1.0},
    _TENSION: {"N/m": 1.0, "mN/m": 0.001},
    _CURVATURE: {"1/m": 1.0},
    _FREQUENCY: {"Hz": 1.0, "kHz": 1000.0},
}

COMMON: Mapping[str, tuple[float, tuple[float, float, float]]] = MappingProxyType(
    {unit: (factor, dimension) for dimension, factors in _FACTORS.items() for unit, factor in factors.items()}
)
"""SI value and exponents of kg, m and s of each."""

SI_UNITS = {
    "length": "m",
    "stress": "Pa",
    "viscosity": "Pa*s",
    "density": "kg/m^3",
    "acceleration": "m/s^2",
    "time": "s",
    "mass": "kg",
    "surface tension": "N/m",
    "curvature": "1/m",
    "angle": "rad",
    "frequency": "Hz",
}

# Exponents of kg, m and s.
Dimension = tuple[float, float, float]
PURE: Dimension = (0.0, 0.0, 0.0)
STRESS: Dimension = (1.0, -1.0, -2.0)
_BASE = ("[mass]", "[length]", "[time]")
_SHORT: dict[Dimension, str] = {
    STRESS: "Pa",
    (1.0, -1.0, -1.0): "Pa*s",
    (-1.0, 1.0, 2.0): "1/Pa",
    (-1.0, 1.0, 1.0): "1/(Pa*s)",
    (0.0, 0.0, -1.0): "1/s",
}
# An exponent in a file is written with some digits: s^0.333333 is s^(1/3).
_SAME_EXPONENT = 1e-6

_NUMBER_AND_UNIT = re.compile(
    r"\s*(?P<number>[+-]?(?:(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?|nan\b|inf(?:inity)?\b))\s*(?P<unit>.*?)\s*",
    re.IGNORECASE | re.DOTALL | re.ASCII,
)
# Pint tokenises a unit as Python source, so text that could not be a unit is kept away from it.
_UNIT = re.compile(r"[A-Za-zµμΩ°²³⁻¹·*/^()0-9 .+-]{1,60}")
# Python would compute 9^9^9^9 to its last digit, and never end.
_TOWER = re.compile(r"[0-9.][\s)]*(\^|\*\*)")


class NotAQuantity(ValueError):  # noqa: N818 - its text is "what was found", never shown as an exception
    """A value that is no quantity of the dimension asked for; the text says what was found. Never leaves `scene`."""


class SI(float):
    """A bare number that Python gave for a quantity: its value in the SI unit of the key."""

    __slots__ = ()


def in_si(value: Any) -> Any:
    """Mark the bare numbers of a value, of its rows or of its tables, as SI."""
    if isinstance(value, Mapping):
        return {key: in_si(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [in_si(item) for item in value]
    if isinstance(value, bool) or not isinstance(value, Real):
        return value
    try:
        return SI(value)
    except OverflowError:
        return SI(math.inf)


@cache
def registry() -> UnitRegistry[float]:
    """Build pint's registry on first use; an import of the package should not pay for it."""
    import pint

    return pint.UnitRegistry()


# What pint leaks of its tokeniser and its arithmetic for malformed units; a lone sign fails an assertion of its parser.
_LEAKED = (
    *(ValueError, TypeError, AttributeError, LookupError, ArithmeticError),
    *(SyntaxError, TokenError, AssertionError, RecursionError),
)


@lru_cache(maxsize=1024)
def _measured(unit: str, wanted: str = "one of mass, length and time") -> tuple[float, Dimension]:
    """SI value of one `unit`, so that a file already in SI keeps its numbers to the last bit, and its dimension."""
    return COMMON[unit] if unit in COMMON else measured_by_pint(unit, wanted)


def measured_by_pint(unit: str, wanted: str) -> tuple[float, Dimension]:
    """SI value and dimension of any unit."""
    ureg = registry()
    from pint.errors import PintError

    try:
        one = ureg.Quantity(1.0, ureg.parse_units(unit))
        exponents = {str(name): float(str(power)) for name, power in one.dimensionality.items()}
        factor = _tidied(float(one.to_base_units().magnitude))
    except (PintError, *_LEAKED):
        raise NotAQuantity(f"unknown unit '{unit}'") from None
    dimension = (exponents.pop(_BASE[0], 0.0), exponents.pop(_BASE[1], 0.0), exponents.pop(_BASE[2], 0.0))
    if exponents:
        raise NotAQuantity(f"'{unit}' is of dimension {one.dimensionality}, not {wanted}")
    return factor, dimension


def _tidied(factor: float) -> float:
    """Take the last bits of pint's own arithmetic out of a short decimal: 1 g/cm^3 is 1000 kg/m^3 exactly."""
    short = float(f"{factor:.12g}")
    return short if math.isclose(short, factor, rel_tol=1e-15) else factor


def _dimension_of(dimension: Dimension) -> str:
    for name, si in SI_UNITS.items():
        if same_dimension(_measured(si)[1], dimension):
            return _article(name)
    return f"of unit {si_unit(dimension)}"


def same_dimension(one: Dimension, other: Dimension) -> bool:
    """Tell whether two dimensions are the same to the digits that a file gives an exponent."""
    return all(abs(a - b) < _SAME_EXPONENT for a, b in zip(one, other, strict=True))


def si_unit(dimension: Dimension) -> str:
    """Write the SI unit of a dimension, so that a quantity in it can be read back; empty for a pure number."""
    if dimension in _SHORT:
        return _SHORT[dimension]
    steps = [(name, power) for name, power in zip(("kg", "m", "s"), dimension, strict=True) if power]
    return "*".join(name if power == 1 else f"{name}^{_written(power)}" for name, power in steps)


def _written(exponent: float) -> str:
    return str(int(exponent)) if exponent.is_integer() else repr(exponent)


def consistency_unit(index: float) -> str:
    """Return the SI unit of a consistency, Pa s^n."""
    return "Pa*s" if index == 1 else f"Pa*s^{_written(index)}"


def _article(noun: str) -> str:
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def to_si(value: object, dimension: str, unit: str = "") -> float:
    """Turn a quantity into its SI value."""
    if isinstance(value, SI):
        if not math.isfinite(value):
            raise NotAQuantity(f"{shown(value)} is not finite")
        return float(value)
    wanted = _article(dimension) + (f" in {unit}" if unit else "")
    si, found, name = _read(value, wanted)
    if not same_dimension(found, _measured(unit or SI_UNITS[dimension])[1]):
        raise NotAQuantity(f"'{name}' is {_dimension_of(found)}, not {wanted}")
    if not math.isfinite(si):
        raise NotAQuantity(f"{shown(value)} is not finite")
    if dimension == "frequency" and _is_angular(name):
        raise NotAQuantity(f"'{name}' measures an angle, not cycles: a frequency is in Hz, 2 pi rad/s each")
    return si


def _is_angular(unit: str) -> bool:
    """Tell whether pint counts radians in it, which it takes for pure numbers: 1 rad/s would be read as 1 Hz."""
    if unit in COMMON:
        return False
    ureg = registry()
    return "radian" in str(ureg.get_root_units(ureg.parse_units(unit))[1])


def to_si_of_any(value: object) -> tuple[float, Dimension]:
    """Turn a quantity of whatever dimension into its SI value; a bare number is a pure one."""
    if isinstance(value, (int, float, Real)) and not isinstance(value, bool):
        try:
            si, dimension = float(value), PURE
        except OverflowError:
            raise NotAQuantity(f"{shown(value)} is not finite") from None
    else:
        si, dimension, _ = _read(value, "one of mass, length and time")
    if not math.isfinite(si):
        raise NotAQuantity(f"{shown(value)} is not finite")
    return si, dimension


def _read(value: object, wanted: str) -> tuple[float, Dimension, str]:
    """SI value, dimension and the unit as written."""
    if isinstance(value, str):
        magnitude, unit = _split(value)
    elif hasattr(value, "magnitude") and hasattr(value, "units"):
        magnitude, unit = _pint_quantity(value.magnitude, value.units)
    elif isinstance(value, (int, float, Real)) and not isinstance(value, bool):
        raise NotAQuantity(f"{value!r} has no unit")
    else:
        raise NotAQuantity(f"{shown(value)} is not a quantity")
    factor, dimension = _measured(unit, wanted)
    # In decimal, as the file is: 6 mm is then the same float as 0.006 m.
    return float(Decimal(repr(magnitude)) * Decimal(repr(factor))), dimension, unit


def _split(text: str) -> tuple[float, str]:
    match = _NUMBER_AND_UNIT.fullmatch(text)
    if match is None:
        raise NotAQuantity(f"{shown(text)} is not a number with a unit")
    magnitude = float(match["number"])
    if not math.isfinite(magnitude):
        raise NotAQuantity(f"{shown(text)} is not finite")
    if not match["unit"]:
        raise NotAQuantity(f"{shown(text)} has no unit")
    if not _UNIT.fullmatch(match["unit"]) or _TOWER.search(match["unit"]):
        raise NotAQuantity(f"unknown unit {shown(match['unit'])}")
    return magnitude, match["unit"]


def _pint_quantity(magnitude: object, units: object) -> tuple[float, str]:
    if not isinstance(magnitude, Real):
        raise NotAQuantity(f"{shown(magnitude)} is not a single number")
    if not math.isfinite(magnitude):
        raise NotAQuantity(f"{magnitude} is not finite")
    # By name, because a quantity of another registry cannot be converted by ours.
    return float(magnitude), str(units)


def with_unit(value: float, dimension: str, unit: str = "") -> str:
    """Write an SI value so that `to_si` returns it exactly."""
    return f"{float(value)!r} {unit or SI_UNITS[dimension]}"


def shown(value: object, longest: int = 60) -> str:
    """Describe a value from a file in a fault, on one line and not too long."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "a table"
    text = repr(value)
    return text if len(text) <= longest else f"{text[:longest]}..."


def did_you_mean(found: str, known: Iterable[str]) -> str:
    """Name the nearest known word, or nothing when none is near."""
    nearest = get_close_matches(found, list(known), n=1, cutoff=0.5)
    return f" (did you mean '{nearest[0]}'?)" if nearest else ""


def unknown_key(path: str, tables: Mapping[str, Sequence[str]]) -> Fault:
    """Build the fault for a key that does not exist."""
    table, _, key = path.rpartition(".")
    here = tables.get(table, ())
    hint = did_you_mean(key, here)
    elsewhere = [f"{other}.{key}".lstrip(".") for other, keys in tables.items() if key in keys]
    if elsewhere:
        hint = f" (did you mean '{elsewhere[0]}'?)"
    return Fault(path, f"unknown key{hint}", ", ".join(here))


def fault_of(error: ErrorDetails, tables: Mapping[str, Sequence[str]], accepted: Mapping[str, str]) -> Fault:
    """Translate one pydantic error."""
    path = ".".join(str(step) for step in error["loc"])
    context = error.get("ctx", {})
    if "found" in context:
        return Fault(path, str(context["found"]), str(context["accepted"]))
    if error["type"] == "extra_forbidden":
        return unknown_key(path, tables)
    if error["type"] == "missing":
        return Fault(path, "missing", accepted.get(path, ""))
    return Fault(path, f"{shown(error['input'])} is not a table", f"a table [{path}]")


# The protocol `Kind` documents the three methods once for all kinds.
# ruff: noqa: D102


Sign = Literal["any", "non-negative", "positive"]

SMALLEST, LARGEST = 1e-30, 1e30
"""No quantity of a filament lies beyond in SI units, and products of a few of them neither vanish nor overflow."""


def refusal(found: str, accepted: str, code: str = "scene") -> PydanticCustomError:
    """Build the error by which a validator hands ``Fault(found, accepted)`` through pydantic."""
    return PydanticCustomError(code, "{found}; accepted: {accepted}", {"found": found, "accepted": accepted})


def refusals(title: str, faults: Iterable[tuple[tuple[str, ...], PydanticCustomError]]) -> ValidationError:
    """Build the error by which a validator hands several refusals through, each at its own place below the field."""
    details = [InitErrorDetails(type=error, loc=steps, input=None) for steps, error in faults]
    return ValidationError.from_exception_data(title, details)


@runtime_checkable
class Kind(Protocol):
    """How one sort of value is read, described and written."""

    @property
    def accepted(self) -> str:
        """What is accepted, for a fault."""
        ...

    def read(self, value: object) -> Any:
        """Return the validated value; raises `refusal`."""
        ...

    def write(self, value: Any) -> object:
        """Return what TOML holds; ``read(write(value)) == value``."""
        ...


class AsValidator(ABC):
    """Lets a kind stand in ``Annotated[float, kind]``."""

    __slots__ = ()

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    @abstractmethod
    def read(self, value: object) -> Any: ...


@dataclass(frozen=True, slots=True)
class Quantity(AsValidator):
    """A dimensional quantity, stored as an SI float; `unit` where its SI unit is not that of its dimension."""

    dimension: str
    example: str
    sign: Sign = "positive"
    unit: str = ""

    @property
    def accepted(self) -> str:
        what = self.dimension if self.sign == "any" else f"{self.sign} {self.dimension}"
        return f'{"an" if what[0] in "aeiou" else "a"} {what} with its unit, such as "{self.example}"'

    def read(self, value: object) -> float:
        try:
            si = to_si(value, self.dimension, self.unit)
        except NotAQuantity as found:
            raise refusal(str(found), self.accepted) from None
        if si < 0 and self.sign != "any":
            raise refusal(f"{shown(value)} is negative", self.accepted)
        if si == 0 and self.sign == "positive":
            raise refusal(f"{shown(value)} is zero", self.accepted)
        if si != 0 and not SMALLEST <= abs(si) <= LARGEST:
            raise refusal(f"{shown(value)} is beyond {SMALLEST:g} to {LARGEST:g} in SI units", self.accepted)
        return si + 0.0  # -0.0 would make equal scenes print differently

    def write(self, value: float) -> object:
        return with_unit(value, self.dimension, self.unit)


@dataclass(frozen=True, slots=True)
class Number(AsValidator):
    """A dimensionless number strictly between two bounds, or equal to the lower one if that is `closed`."""

    above: float = -math.inf
    below: float = math.inf
    closed: bool = False

    @property
    def accepted(self) -> str:
        if self.below < math.inf:
            return f"a number between {self.above:g} and {self.below:g}, both excluded"
        sign = "" if self.above < 0 else "non-negative " if self.closed else "positive "
        return f"a {sign}number without a unit"

    def read(self, value: object) -> float:
        if isinstance(value, bool) or not isinstance(value, Real):
            raise refusal(f"{shown(value)} is not a number", self.accepted)
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            raise refusal(f"{shown(value)} is not finite", self.accepted)
        if not self.above < number < self.below and not (self.closed and number == self.above):
            raise refusal(f"{shown(value)} is out of range", self.accepted)
        return number

    def write(self, value: float) -> object:
        return float(value)


@dataclass(frozen=True, slots=True)
class Whole(AsValidator):
    """A whole number between two bounds, both included."""

    least: int
    most: int

    @property
    def accepted(self) -> str:
        return f"a whole number from {self.least} to {self.most}"

    def read(self, value: object) -> int:
        if isinstance(value, bool) or not isinstance(value, Integral):
            raise refusal(f"{shown(value)} is not a whole number", self.accepted)
        number = int(value)
        if not self.least <= number <= self.most:
            raise refusal(f"{shown(value)} is out of range", self.accepted)
        return number

    def write(self, value: int) -> object:
        return int(value)


@dataclass(frozen=True, slots=True)
class Choice(AsValidator):
    """One of a few names."""

    names: tuple[str, ...]

    @property
    def accepted(self) -> str:
        return ", ".join(self.names)

    def read(self, value: object) -> str:
        if isinstance(value, str) and value in self.names:
            return value
        raise refusal(self.unknown(value), self.accepted)

    def unknown(self, value: object) -> str:
        """Say what was found in place of a name."""
        return _unknown_name(value, self.names)

    def write(self, value: str) -> object:
        return value


@dataclass(frozen=True, slots=True)
class Text(AsValidator):
    """Any text."""

    accepted: str = "text in quotes"

    def read(self, value: object) -> str:
        if not isinstance(value, str):
            raise refusal(f"{shown(value)} is not text", self.accepted)
        # Half a letter has no bytes, NUL ends a text in a netCDF file, and the others would move a terminal's cursor.
        if any(category(letter) in ("Cc", "Cs") and letter not in "\t\n" for letter in value):
            raise refusal(f"{shown(value)} holds a control character", f"{self.accepted}, of letters and signs")
        return value

    def write(self, value: str) -> object:
        return value


@dataclass(frozen=True, slots=True)
class Flag(AsValidator):
    """True or false."""

    accepted: str = "true or false"

    def read(self, value: object) -> bool:
        if isinstance(value, bool):
            return value
        raise refusal(f"{shown(value)} is neither true nor false", self.accepted)

    def write(self, value: bool) -> object:
        return value


@dataclass(frozen=True, slots=True)
class Numbers(AsValidator):
    """A list of dimensionless numbers above a bound; if it is not empty, of at least so many."""

    above: float = -math.inf
    least: int = 1

    @property
    def accepted(self) -> str:
        sign = "" if self.above < 0 else "positive "
        return f"a list of {sign}numbers without units" + (f", at least {self.least}" if self.least > 1 else "")

    def read(self, value: object) -> tuple[float, ...]:
        if not isinstance(value, (list, tuple)):
            raise refusal(f"{shown(value)} is not a list", self.accepted)
        if 0 < len(value) < self.least:
            raise refusal(f"a list of {len(value)}", self.accepted)
        return tuple(Number(self.above).read(item) for item in value)

    def write(self, value: tuple[float, ...]) -> object:
        return list(value)


@dataclass(frozen=True, slots=True)
class Names(AsValidator):
    """A list of names, or one of a few words that stand for a list."""

    words: tuple[str, ...]

    @property
    def accepted(self) -> str:
        return f"{', '.join(self.words)}, or a list of names"

    def read(self, value: object) -> str | tuple[str, ...]:
        if isinstance(value, str):
            if value in self.words:
                return value
            if value.strip().startswith("["):
                raise refusal(f"{shown(value)} is not a list: its brackets or quotes do not match", self.accepted)
            list_of_one = f', or a list, even of one: ["{value}"]'
            raise refusal(_unknown_name(value, self.words), f"{', '.join(self.words)}{list_of_one}")
        if not isinstance(value, (list, tuple)) or not all(isinstance(item, str) for item in value):
            raise refusal(f"{shown(value)} is not a list of names", self.accepted)
        if not value:
            raise refusal(f"{shown(value)} names nothing", self.accepted)
        repeated = sorted({item for item in value if value.count(item) > 1})
        if repeated:
            raise refusal(f"{', '.join(map(repr, repeated))} named twice", "each name once")
        return tuple(value)

    def write(self, value: str | tuple[str, ...]) -> object:
        return value if isinstance(value, str) else list(value)


@dataclass(frozen=True, slots=True)
class Motion(AsValidator):
    """A path in the plane: rows of a time and two displacements."""

    accepted: str = '"hold", or a list of rows [time, dx, dy], such as [["0 s", "0 m", "0 m"], ["1 s", "5 mm", "0 m"]]'

    def read(self, value: object) -> tuple[tuple[float, float, float], ...]:
        if isinstance(value, (str, list, tuple)) and value in ("hold", "", [], ()):
            return ()
        if not isinstance(value, (list, tuple)):
            raise refusal(f"{shown(value)} is not a list of rows", self.accepted)
        return tuple(self._row(row) for row in value)

    def _row(self, row: object) -> tuple[float, float, float]:
        if not isinstance(row, (list, tuple)) or len(row) != 3:
            raise refusal(f"{shown(row)} is not a row [time, dx, dy]", self.accepted)
        return (_TIME_DIMENSION.read(row[0]), _SHIFT.read(row[1]), _SHIFT.read(row[2]))

    def write(self, value: tuple[tuple[float, float, float], ...]) -> object:
        return [[_TIME_DIMENSION.write(time), _SHIFT.write(dx), _SHIFT.write(dy)] for time, dx, dy in value] or "hold"


_TIME_DIMENSION = Quantity("time", "1 s", "any")
_SHIFT = Quantity("length", "5 mm", "any")


def _unknown_name(value: object, names: tuple[str, ...]) -> str:
    hint = did_you_mean(value, names) if isinstance(value, str) else ""
    return f"{shown(value)} is not a name known here{hint}"
