"""The pint boundary: text such as ``"6 mm"`` becomes a plain SI float here and nowhere else."""

from __future__ import annotations

import math
import re
from decimal import Decimal
from functools import cache, lru_cache
from numbers import Real
from tokenize import TokenError
from typing import TYPE_CHECKING

from softcat_sym.scene.common_units import COMMON

if TYPE_CHECKING:
    from pint import UnitRegistry

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
    """SI value and dimension of any unit.

    Raises
    ------
    NotAQuantity
        If it is none, or not of mass, length and time alone.
    """
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
    """Turn a quantity into its SI value.

    Parameters
    ----------
    value : object
        Text with a number and a unit, or a pint quantity.
    dimension : str
        A key of `SI_UNITS`, or any word for what `unit` measures.
    unit : str, optional
        SI unit of the result; by default ``SI_UNITS[dimension]``.

    Returns
    -------
    float
        Finite SI value.

    Raises
    ------
    NotAQuantity
        Its text says what was found.
    """
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
    """Turn a quantity of whatever dimension into its SI value; a bare number is a pure one.

    Parameters
    ----------
    value : object
        A number, text with a number and a unit, or a pint quantity.

    Returns
    -------
    float, tuple of float
        Finite SI value, and the exponents of kg, m and s.

    Raises
    ------
    NotAQuantity
        Its text says what was found.
    """
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
