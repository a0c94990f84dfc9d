"""Text such as ``'6 mm'`` becomes a plain SI float, here and nowhere else; kinds of value, faults by path."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import MISSING, fields
from decimal import Decimal
from difflib import get_close_matches
from functools import cache, lru_cache
from numbers import Integral, Real
from tokenize import TokenError
from typing import Any, TypeGuard, get_args, get_type_hints
from unicodedata import category

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, ErrorDetails, InitErrorDetails, PydanticCustomError, ValidationError, core_schema

from softcat_sym.errors import Fault
from softcat_sym.lazy import lazy_imports

# The units of most scenes are known without pint.
with lazy_imports():
    import pint
    from pint import errors as pint_errors

# Exponents of kg, m and s.
Dimension = tuple[float, float, float]
PURE: Dimension = (0.0, 0.0, 0.0)
STRESS: Dimension = (1.0, -1.0, -2.0)
_VISCOSITY: Dimension = (1.0, -1.0, -1.0)

# The units of most scenes: with them a run never imports pint.
_FACTORS: Mapping[Dimension, Mapping[str, float]] = {
    (0.0, 1.0, 0.0): {"m": 1.0, "cm": 0.01, "mm": 0.001, "um": 1e-6, "nm": 1e-9, "km": 1000.0},
    (0.0, 0.0, 1.0): {"s": 1.0, "ms": 0.001, "us": 1e-6, "min": 60.0, "h": 3600.0},
    (1.0, 0.0, 0.0): {"kg": 1.0, "g": 0.001, "mg": 1e-6},
    PURE: {"rad": 1.0, "deg": 0.017453292519943295},
    STRESS: {"Pa": 1.0, "mPa": 0.001, "kPa": 1000.0, "MPa": 1e6, "GPa": 1e9},
    _VISCOSITY: {"Pa*s": 1.0, "mPa*s": 0.001, "kPa*s": 1000.0, "MPa*s": 1e6, "GPa*s": 1e9},
    (1.0, -3.0, 0.0): {"kg/m^3": 1.0, "g/cm^3": 1000.0},
    (0.0, 1.0, -2.0): {"m/s^2": 1.0},
    (0.0, 1.0, -1.0): {"m/s": 1.0, "mm/s": 0.001},
    (1.0, 1.0, -2.0): {"N": 1.0, "mN": 0.001},
    (1.0, 0.0, -2.0): {"N/m": 1.0, "mN/m": 0.001},
    (1.0, 2.0, -2.0): {"N*m": 1.0, "mN*m": 0.001},
    (0.0, -1.0, 0.0): {"1/m": 1.0},
    (0.0, 0.0, -1.0): {"Hz": 1.0, "kHz": 1000.0},
}
COMMON = {unit: (factor, dimension) for dimension, factors in _FACTORS.items() for unit, factor in factors.items()}
"""SI value and exponents of kg, m and s of each."""

SI_UNITS = {
    "length": "m",
    "stress": "Pa",
    "viscosity": "Pa*s",
    "density": "kg/m^3",
    "acceleration": "m/s^2",
    "time": "s",
    "mass": "kg",
    "force": "N",
    "torque": "N*m",
    "stiffness": "N/m",
    "rotational stiffness": "N*m/rad",
    "surface tension": "N/m",
    "curvature": "1/m",
    "angle": "rad",
    "frequency": "Hz",
    "velocity": "m/s",
    "volume rate": "m^3/s",
}
_SHORT: dict[Dimension, str] = {
    STRESS: "Pa",
    _VISCOSITY: "Pa*s",
    (-1.0, 1.0, 2.0): "1/Pa",
    (-1.0, 1.0, 1.0): "1/(Pa*s)",
    (0.0, 0.0, -1.0): "1/s",
}
_POWER = r"([A-Za-z]+)(?:\^(-?\d+(?:\.\d*)?))?"
_PRODUCT = re.compile(f"{_POWER}(?:[*/]{_POWER})*", re.ASCII)
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
# What pint leaks of its tokeniser and its arithmetic for malformed units; a lone sign fails an assertion of its parser.
_LEAKED = (
    *(ValueError, TypeError, AttributeError, LookupError, ArithmeticError),
    *(SyntaxError, TokenError, AssertionError, RecursionError),
)
_ANY_DIMENSION = "one of mass, length and time"


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
    return SI(_float(value)) if _is_number(value) else value


def _is_number(value: object) -> TypeGuard[Real]:
    return isinstance(value, Real) and not isinstance(value, bool)


def _float(value: Any) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf


@cache
def registry() -> pint.UnitRegistry[float]:
    """Build pint's registry on first use; an import of the package should not pay for it."""
    return pint.UnitRegistry()


def one_of(unit: str) -> pint.Quantity[float]:
    """One of a unit as pint knows it; raises `NotAQuantity`."""
    try:
        return registry().Quantity(1.0, registry().parse_units(unit))
    except (pint_errors.PintError, *_LEAKED):
        raise NotAQuantity(f"unknown unit '{unit}'") from None


def without_rounding(factor: float) -> float:
    """A factor without the last bits of pint's own arithmetic: 1 g/cm^3 is 1000 kg/m^3 exactly."""
    short = float(f"{factor:.12g}")
    return short if math.isclose(short, factor, rel_tol=1e-15) else factor


@lru_cache(maxsize=1024)
def _measured(unit: str, wanted: str = _ANY_DIMENSION) -> tuple[float, Dimension]:
    """SI value of one `unit`, so that a file already in SI keeps its numbers to the last bit, and its dimension.

    Of units of mechanics and products of their powers, such as Pa*s^0.5, without Pint, which takes a second to load.
    """
    return COMMON[unit] if unit in COMMON else _product(unit) or measured_by_pint(unit, wanted)


def _product(unit: str) -> tuple[float, Dimension] | None:
    """SI value and dimension of a product of powers of common units; None of any other unit, and of angles."""
    if not _PRODUCT.fullmatch(unit):
        return None
    total, exponents = 1.0, list(PURE)
    for sign, name, power in re.findall(f"(^|[*/]){_POWER}", unit):
        factor, dimension = COMMON.get(name, (0.0, PURE))
        exponent = float(power or 1) * (-1 if sign == "/" else 1)
        if dimension == PURE or (factor != 1.0 and exponent != 1.0):
            return None
        total *= factor
        exponents = [each + exponent * one for each, one in zip(exponents, dimension, strict=True)]
    mass, length, time = exponents
    return total, (mass, length, time)


def measured_by_pint(unit: str, wanted: str) -> tuple[float, Dimension]:
    """SI value and dimension of any unit."""
    one = one_of(unit)
    try:
        exponents = {str(name): float(str(power)) for name, power in one.dimensionality.items()}
        factor = float(one.to_base_units().magnitude)
    except (pint_errors.PintError, *_LEAKED):
        raise NotAQuantity(f"unknown unit '{unit}'") from None
    dimension = (exponents.pop("[mass]", 0.0), exponents.pop("[length]", 0.0), exponents.pop("[time]", 0.0))
    if exponents:
        raise NotAQuantity(f"'{unit}' is of dimension {one.dimensionality}, not {wanted}")
    return without_rounding(factor), dimension


def dimension_of(unit: str) -> Dimension:
    """Exponents of kg, m and s of a unit; of an empty one, those of a pure number."""
    return _measured(unit)[1] if unit else PURE


def same_dimension(a: Dimension, b: Dimension) -> bool:
    """Tell whether two dimensions are the same to the digits that a file gives an exponent."""
    return all(abs(x - y) < _SAME_EXPONENT for x, y in zip(a, b, strict=True))


def si_unit(dimension: Dimension) -> str:
    """Write the SI unit of a dimension, so that a quantity in it can be read back; empty for a pure number."""
    steps = (_power(name, power) for name, power in zip(("kg", "m", "s"), dimension, strict=True) if power)
    return _SHORT.get(dimension) or "*".join(steps)


def consistency_unit(index: float) -> str:
    """Return the SI unit of a consistency, Pa s^n."""
    return f"Pa*{_power('s', float(index))}"


def _power(unit: str, exponent: float) -> str:
    return unit if exponent == 1 else f"{unit}^{int(exponent) if exponent.is_integer() else repr(exponent)}"


def _article(noun: str) -> str:
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def to_si(value: object, dimension: str, unit: str = "") -> float:
    """Turn a quantity into its SI value."""
    if isinstance(value, SI):
        return _finite(float(value), value)
    wanted = _article(dimension) + (f" in {unit}" if unit != SI_UNITS.get(dimension, "") else "")
    si, found, name = _read(value, wanted)
    if not same_dimension(found, dimension_of(unit or SI_UNITS[dimension])):
        known = (noun for noun, si_name in SI_UNITS.items() if same_dimension(dimension_of(si_name), found))
        is_a = next(map(_article, known), f"of unit {si_unit(found)}")
        raise NotAQuantity(f"'{name}' is {is_a}, not {wanted}")
    # Pint takes radians for pure numbers: 1 rad/s would be read as 1 Hz.
    pure = dimension != "frequency" or name in COMMON
    if not pure and "radian" in str(registry().get_root_units(one_of(name).units)[1]):
        raise NotAQuantity(f"'{name}' measures an angle, not cycles: a frequency is in Hz, 2 pi rad/s each")
    return _finite(si, value)


def to_si_of_any(value: object) -> tuple[float, Dimension]:
    """Turn a quantity of whatever dimension into its SI value; a bare number is a pure one."""
    si, dimension = (_float(value), PURE) if _is_number(value) else _read(value, _ANY_DIMENSION)[:2]
    return _finite(si, value), dimension


def _finite(si: float, value: object) -> float:
    if not math.isfinite(si):
        raise NotAQuantity(f"{shown(value)} is not finite")
    return si


def _read(value: object, wanted: str) -> tuple[float, Dimension, str]:
    """SI value, dimension and the unit as written."""
    magnitude, unit = split_quantity(value)
    factor, dimension = _measured(unit, wanted)
    # In decimal, as the file is: 6 mm is then the same float as 0.006 m.
    return float(Decimal(repr(magnitude)) * Decimal(repr(factor))), dimension, unit


def split_quantity(value: object) -> tuple[float, str]:
    """Number and unit of a quantity as it is given: text, or a pint quantity."""
    if hasattr(value, "magnitude") and hasattr(value, "units"):
        if not isinstance(value.magnitude, Real):
            raise NotAQuantity(f"{shown(value.magnitude)} is not a single number")
        # By name, because a quantity of another registry cannot be converted by ours.
        return _finite(float(value.magnitude), float(value.magnitude)), str(value.units)
    if not isinstance(value, str):
        raise NotAQuantity(f"{value!r} has no unit" if _is_number(value) else f"{shown(value)} is not a quantity")
    match = _NUMBER_AND_UNIT.fullmatch(value)
    if match is None:
        raise NotAQuantity(f"{shown(value)} is not a number with a unit")
    magnitude = _finite(float(match["number"]), value)
    if not match["unit"]:
        raise NotAQuantity(f"{shown(value)} has no unit")
    if not _UNIT.fullmatch(match["unit"]) or _TOWER.search(match["unit"]):
        raise NotAQuantity(f"unknown unit {shown(match['unit'])}")
    return magnitude, match["unit"]


def with_unit(value: float, unit: str) -> str:
    """Write an SI value with its unit, if it has one, so that it is read back exactly."""
    return f"{float(value)!r} {unit}".rstrip()


def length_text(value: float, digits: int = 3) -> str:
    """A length [m] with a few digits and the unit that suits it."""
    factor, unit = next((pair for pair in ((1.0, "m"), (1e-3, "mm")) if abs(value) >= pair[0]), (1e-6, "um"))
    return f"{float(f'{value / factor:.{digits}g}'):g} {unit}"


def shown(value: object, longest: int = 60) -> str:
    """Describe a value from a file in a fault, on one line and not too long."""
    if isinstance(value, (bool, dict)):
        return str(value).lower() if isinstance(value, bool) else "a table"
    text = repr(value)
    return text if len(text) <= longest else f"{text[:longest]}..."


def did_you_mean(found: object, known: Iterable[str]) -> str:
    """Name the nearest known word, or nothing when none is near."""
    nearest = get_close_matches(found, list(known), n=1, cutoff=0.5) if isinstance(found, str) else []
    return f" (did you mean '{nearest[0]}'?)" if nearest else ""


def unknown_key(path: str, tables: Mapping[str, Sequence[str]]) -> Fault:
    """Build the fault for a key that does not exist."""
    table, _, key = path.rpartition(".")
    here = tables.get(table, ())
    if table and tables.get(key):
        accepted = ", ".join(f"{key}.{one}" for one in tables[key])
        return Fault(path, f"unknown key (did you mean the table [{key}]?)", accepted)
    elsewhere = [f"{other}.{key}".lstrip(".") for other, keys in tables.items() if key in keys]
    hint = f" (did you mean '{elsewhere[0]}'?)" if elsewhere else did_you_mean(key, here)
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


SMALLEST, LARGEST = 1e-30, 1e30
"""No quantity of a filament lies beyond in SI units, and products of a few of them neither vanish nor overflow."""

Refused = tuple[tuple[str, ...], PydanticCustomError]
"""Place below a field, and what is wrong there."""


def refusal(found: str, accepted: str, code: str = "scene") -> PydanticCustomError:
    """Build the error by which a validator hands ``Fault(found, accepted)`` through pydantic."""
    return PydanticCustomError(code, "{found}; accepted: {accepted}", {"found": found, "accepted": accepted})


def refusals(title: str, faults: Iterable[Refused]) -> ValidationError:
    """Build the error by which a validator hands several refusals through, each at its own place below the field."""
    details = [InitErrorDetails(type=error, loc=steps, input=None) for steps, error in faults]
    return ValidationError.from_exception_data(title, details)


def read_each(title: str, reads: Iterable[tuple[str, Callable[..., Any], tuple[Any, ...]]]) -> dict[str, Any]:
    """Read several values by key, function and arguments; raises the refusals of all at once, each at its place."""
    found, faults = dict[str, Any](), list[Refused]()
    for key, read, arguments in reads:
        try:
            found[key] = read(*arguments)
        except PydanticCustomError as error:
            faults.append(((key,), error))
        except ValidationError as error:
            inner = ((tuple(map(str, one["loc"])), one["ctx"]) for one in error.errors())
            faults += [((key, *steps), refusal(context["found"], context["accepted"])) for steps, context in inner]
    if faults:
        raise refusals(title, faults)
    return found


_LONGEST = 20_000
"""Items of a list: twenty thousand rows take half a second to read."""


class Kind:
    """How one sort of value is read, described and written; stands in ``Annotated[float, kind]``."""

    si = False  # Whether Python may give it as bare numbers in SI
    unit = ""  # In SI; empty for what has none

    def __init__(self, accepted: str, check: Callable[[Any], Any] | None = None) -> None:
        self.accepted = accepted  # In words for a fault
        if check is not None:
            self.check = check  # type: ignore[assignment, method-assign]

    def check(self, value: Any) -> Any:
        """Return the value as it is kept; raises `NotAQuantity` or `refusal`."""
        raise NotImplementedError

    def read(self, value: object) -> Any:
        """Return the validated value; raises `refusal`."""
        try:
            return self.check(value)
        except NotAQuantity as found:
            raise self.refuse(str(found)) from None

    def write(self, value: Any) -> object:
        """Return what TOML holds; ``read(write(value)) == value``."""
        return list(value) if isinstance(value, tuple) else value

    def refuse(self, found: str) -> PydanticCustomError:
        """Build the error for what was found instead."""
        return refusal(found, self.accepted)

    def listed(self, value: object, what: str) -> Sequence[Any]:
        """Return a list that is not too long to read; raises `refusal`."""
        if not isinstance(value, (list, tuple)):
            raise self.refuse(f"{shown(value)} is not {what}")
        if len(value) > _LONGEST:
            raise refusal(f"a list of {len(value)}", f"at most {_LONGEST}: {self.accepted}")
        return value

    def table(self, value: object) -> Mapping[Any, Any]:
        """Return a table; raises `refusal`."""
        if not isinstance(value, Mapping):
            raise self.refuse(f"{shown(value)} is not a table")
        return value

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)


# `Kind` documents the methods once for all kinds.
# ruff: noqa: D102


class Quantity(Kind):
    """A dimensional quantity, stored as an SI float; `unit` where its SI unit is not that of its dimension."""

    si = True

    def __init__(self, dimension: str, example: str, sign: str = "positive", unit: str = "") -> None:
        what = dimension if sign == "any" else f"{sign} {dimension}"
        super().__init__(f'{_article(what)} with its unit, such as "{example}"')
        self.dimension, self.example, self.sign, self.unit = dimension, example, sign, unit or SI_UNITS[dimension]

    def measured(self, value: object) -> float:
        """Return the value in its SI unit; raises `NotAQuantity`."""
        return to_si(value, self.dimension, self.unit)

    def check(self, value: object) -> float:
        si = self.measured(value)
        if si < 0 and self.sign != "any":
            raise NotAQuantity(f"{shown(value)} is negative")
        if si == 0 and self.sign == "positive":
            raise NotAQuantity(f"{shown(value)} is zero")
        if si != 0 and not SMALLEST <= abs(si) <= LARGEST:
            raise NotAQuantity(f"{shown(value)} is beyond {SMALLEST:g} to {LARGEST:g} in SI units")
        return si + 0.0  # -0.0 would make equal scenes print differently

    def write(self, value: float) -> object:
        return with_unit(value, self.unit)


class Number(Kind):
    """A dimensionless number strictly between two bounds, or equal to the lower one if that is `closed`."""

    def __init__(self, above: float = -math.inf, below: float = math.inf, *, closed: bool = False) -> None:
        sign = "" if above < 0 else "non-negative " if closed else "positive "
        between = f"a number between {above:g} and {below:g}, both excluded"
        super().__init__(between if below < math.inf else f"a {sign}number without a unit")
        self.above, self.below, self.closed = above, below, closed

    def check(self, value: object) -> float:
        if not _is_number(value):
            raise NotAQuantity(f"{shown(value)} is not a number")
        number = _finite(_float(value), value)
        if not self.above < number < self.below and not (self.closed and number == self.above):
            raise NotAQuantity(f"{shown(value)} is out of range")
        return number


class Whole(Kind):
    """A whole number between two bounds, both included."""

    def __init__(self, least: int, most: int) -> None:
        super().__init__(f"a whole number from {least} to {most}")
        self.least, self.most = least, most

    def check(self, value: object) -> int:
        if isinstance(value, bool) or not isinstance(value, Integral):
            raise NotAQuantity(f"{shown(value)} is not a whole number")
        if not self.least <= int(value) <= self.most:
            raise NotAQuantity(f"{shown(value)} is out of range")
        return int(value)


class Choice(Kind):
    """One of a few names or whole numbers, those of a `Literal` or a tuple."""

    def __init__(self, options: Any) -> None:
        self.options: tuple[str | int, ...] = get_args(options) or options
        super().__init__(", ".join(map(str, self.options)))

    def check(self, value: object) -> str | int:
        for option in self.options:
            if isinstance(value, type(option)) and not isinstance(value, bool) and value == option:
                return option
        names = [option for option in self.options if isinstance(option, str)]
        if len(names) < len(self.options) and not isinstance(value, str):
            raise NotAQuantity(f"{shown(value)} is none of these")
        raise NotAQuantity(f"{shown(value)} is not a name known here{did_you_mean(value, names)}")


def _text(value: object) -> str:
    if not isinstance(value, str):
        raise NotAQuantity(f"{shown(value)} is not text")
    # Half a letter has no bytes, NUL ends a text in a netCDF file, and the others would move a terminal's cursor.
    if any(category(letter) in ("Cc", "Cs") and letter not in "\t\n" for letter in value):
        raise refusal(f"{shown(value)} holds a control character", f"{TEXT.accepted}, of letters and signs")
    return value


def _flag(value: object) -> bool:
    if not isinstance(value, bool):
        raise NotAQuantity(f"{shown(value)} is neither true nor false")
    return value


TEXT, FLAG = Kind("text in quotes", _text), Kind("true or false", _flag)


class Values(Kind):
    """A list of values of one kind, of which there may be none if it is `optional`; ``then`` changes what was read."""

    def __init__(
        self,
        item: Kind,
        accepted: str,
        least: int = 0,
        most: int = _LONGEST,
        *,
        optional: bool = False,
        then: Callable[[Any, tuple[Any, ...]], Any] | None = None,
    ) -> None:
        super().__init__(accepted)
        self.item, self.si, self.least, self.most, self.optional, self.then = item, item.si, least, most, optional, then

    def check(self, value: object) -> Any:
        items = self.listed(value, "a list")
        if not self.least <= len(items) <= self.most and (items or not self.optional):
            raise NotAQuantity(f"a list of {len(items)}")
        if isinstance(self.item, Record):  # Each says its own faults
            values = tuple(read_each("", ((str(k), self.item.read, (row,)) for k, row in enumerate(items, 1))).values())
        else:
            values = tuple(self.item.read(item) for item in items)
        return values if self.then is None else self.then(value, values)

    def write(self, value: tuple[Any, ...]) -> object:
        return [self.item.write(item) for item in value]


def _of_length_one(value: object, given: tuple[float, ...]) -> tuple[float, ...]:
    largest = max(map(abs, given))
    if largest == 0:
        raise NotAQuantity(f"{shown(value)} points nowhere")
    # What has length one already stays as it is, so that a direction written is read back to the last bit.
    if not math.isclose(math.hypot(*given), 1, rel_tol=1e-12):
        given = tuple(one / largest for one in given)
        given = tuple(one / math.hypot(*given) for one in given)
    return tuple(one + 0.0 for one in given)


_THREE = "three numbers without units, right, up and towards the viewer, such as [0, -1, 0]"
UNIT_VECTOR = Values(Number(), _THREE, 3, 3, then=_of_length_one)
"""A direction: three numbers of any size, stored with length one."""
NUMBERS = Values(Number(), "a list of numbers without units")


class Names(Kind):
    """A list of names, or one of a few words that stand for a list."""

    def __init__(self, *words: str) -> None:
        super().__init__(f"{', '.join(words)}, or a list of names")
        self.words = words

    def check(self, value: Any) -> str | tuple[str, ...]:
        if isinstance(value, str):
            if value in self.words:
                return value
            if value.strip().startswith("["):
                raise NotAQuantity(f"{shown(value)} is not a list: its brackets or quotes do not match")
            accepted = f'{", ".join(self.words)}, or a list, even of one: ["{value}"]'
            raise refusal(f"{shown(value)} is not a name known here{did_you_mean(value, self.words)}", accepted)
        names = self.listed(value, "a list of names")
        if not all(isinstance(item, str) for item in names):
            raise NotAQuantity(f"{shown(value)} is not a list of names")
        if not names:
            raise NotAQuantity(f"{shown(value)} names nothing")
        if repeated := sorted({item for item in names if names.count(item) > 1}):
            raise refusal(f"{', '.join(map(repr, repeated))} named twice", "each name once")
        return tuple(names)


class Record(Kind):
    """A table whose keys are the fields of a dataclass, each ``Annotated[type, kind]``; None stays None."""

    si = True

    def __init__(self, made: type[Any], accepted: str) -> None:
        super().__init__(accepted)
        self.made, self.defaults = made, {one.name: one.default for one in fields(made)}
        self.kinds: dict[str, Kind] = {
            name: hint.__metadata__[0] for name, hint in get_type_hints(made, include_extras=True).items()
        }

    def check(self, value: Any) -> Any:
        if value is None or isinstance(value, self.made):
            return value
        unknown = [key for key in self.table(value) if key not in self.kinds]
        known = [key for key in self.kinds if key in value or self.defaults[key] is MISSING]

        def read(key: Any) -> Any:
            if key not in self.kinds:
                raise refusal("unknown key", ", ".join(self.kinds))
            if key not in value:
                raise self.kinds[key].refuse("missing")
            return self.kinds[key].read(value[key])

        return self.made(**read_each(self.made.__name__, ((str(key), read, (key,)) for key in (*unknown, *known))))

    def write(self, value: Any) -> object:
        given = {name: getattr(value, name, None) for name in self.kinds}
        kept = {name: one for name, one in given.items() if one is not None and one != self.defaults[name]}
        return value and {name: self.kinds[name].write(one) for name, one in kept.items()}


_TIME = Quantity("time", "1 s", "any")
_SHIFT = Quantity("length", "5 mm", "any")
_TURN = Quantity("angle", "90 deg", "any")


class Rows(Kind):
    """Rows of quantities, one a column; columns behind the first `least` are dropped where they are zero."""

    si = True

    def __init__(self, columns: Sequence[Quantity], named: str, accepted: str, least: int, min_rows: int = 0) -> None:
        super().__init__(accepted)
        self.columns, self.named, self.least, self.min_rows = columns, named, least, min_rows

    def check(self, value: object) -> tuple[tuple[float, ...], ...]:
        if isinstance(value, (str, list, tuple)) and value in ("hold", "", [], ()):
            return ()
        given = self.listed(value, "a list of rows")
        for row in given:
            if not isinstance(row, (list, tuple)) or not self.least <= len(row) <= len(self.columns):
                raise NotAQuantity(f"{shown(row)} is not a row {self.named}")
        rows = [tuple(column.read(item) for column, item in zip(self.columns, row, strict=False)) for row in given]
        if len(rows) < self.min_rows:
            raise NotAQuantity(f"a list of {len(rows)}")
        if any(any(row[self.least :]) for row in rows):
            return tuple((*row, *(0.0,) * (len(self.columns) - len(row))) for row in rows)
        return tuple(row[: self.least] for row in rows)

    def write(self, value: tuple[tuple[float, ...], ...]) -> object:
        rows = [[column.write(item) for column, item in zip(self.columns, row, strict=False)] for row in value]
        return rows or ("hold" if self.columns[0] is _TIME else rows)


MOTION = Rows(
    (_TIME, _SHIFT, _SHIFT, _SHIFT),
    "[time, dx, dy] or [time, dx, dy, dz]",
    '"hold", or a list of rows [time, dx, dy] or [time, dx, dy, dz], such as '
    '[["0 s", "0 m", "0 m"], ["1 s", "5 mm", "0 m"]]',
    least=3,
)
"""A path: a time and two displacements, or three where it leaves the plane."""
TURNS = Rows(
    (_TIME, _TURN),
    "[time, angle]",
    '"hold", or a list of rows [time, angle], such as [["0 s", "0 deg"], ["1 s", "360 deg"]]',
    least=2,
)
POINTS = Rows(
    (_SHIFT, _SHIFT, _SHIFT),
    "[x, y, z]",
    "a list of three points [x, y, z] or more, such as "
    '[["0 m", "0 m", "0 m"], ["10 cm", "-1 mm", "0 m"], ["20 cm", "0 m", "0 m"]]',
    least=3,
    min_rows=3,
)
"""Places in space."""
