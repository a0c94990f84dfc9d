"""The kinds of value a scene holds: each reads raw TOML, says what it accepts, and writes itself back."""

# The protocol `Kind` documents the three methods once for all kinds.
# ruff: noqa: D102

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from numbers import Integral, Real
from typing import Any, Literal, Protocol, runtime_checkable
from unicodedata import category

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError, ValidationError, core_schema

from softcat_sym.scene.faults import did_you_mean
from softcat_sym.scene.units import NotAQuantity, shown, to_si, with_unit

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
        return (_TIME.read(row[0]), _SHIFT.read(row[1]), _SHIFT.read(row[2]))

    def write(self, value: tuple[tuple[float, float, float], ...]) -> object:
        return [[_TIME.write(time), _SHIFT.write(dx), _SHIFT.write(dy)] for time, dx, dy in value] or "hold"


_TIME = Quantity("time", "1 s", "any")
_SHIFT = Quantity("length", "5 mm", "any")


def _unknown_name(value: object, names: tuple[str, ...]) -> str:
    hint = did_you_mean(value, names) if isinstance(value, str) else ""
    return f"{shown(value)} is not a name known here{hint}"
