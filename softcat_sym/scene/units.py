"""The pint boundary: text such as ``"6 mm"`` becomes a plain SI float here and nowhere else."""

from __future__ import annotations

import math
import re
from decimal import Decimal
from functools import cache, lru_cache
from numbers import Real
from tokenize import TokenError
from typing import TYPE_CHECKING

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
}

_NUMBER_AND_UNIT = re.compile(
    r"\s*(?P<number>[+-]?(?:(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?|nan\b|inf(?:inity)?\b))\s*(?P<unit>.*?)\s*",
    re.IGNORECASE | re.DOTALL | re.ASCII,
)
# Pint tokenises a unit as Python source, so text that could not be a unit is kept away from it.
_UNIT = re.compile(r"[A-Za-zµμΩ°²³⁻¹·*/^()0-9 .+-]{1,60}")


class NotAQuantity(ValueError):  # noqa: N818 - its text is "what was found", never shown as an exception
    """A value that is no quantity of the dimension asked for; the text says what was found. Never leaves `scene`."""


@cache
def registry() -> UnitRegistry[float]:
    """Build pint's registry on first use; an import of the package should not pay for it."""
    import pint

    return pint.UnitRegistry()


@lru_cache(maxsize=1024)
def _factor(unit: str, dimension: str) -> float:
    """SI value of one `unit`, so that a file already in SI keeps its numbers to the last bit."""
    ureg = registry()
    from pint.errors import PintError

    try:
        one = ureg.Quantity(1.0, ureg.parse_units(unit))
        if one.dimensionality != ureg.Quantity(1.0, SI_UNITS[dimension]).dimensionality:
            raise NotAQuantity(f"'{unit}' is {_dimension_of(unit)}, not {_article(dimension)}")
        return _tidied(float(one.to(SI_UNITS[dimension]).magnitude))
    except NotAQuantity:
        raise
    # Pint leaks its tokeniser's and its arithmetic's errors for malformed units.
    except (PintError, ValueError, TypeError, AttributeError, KeyError, ArithmeticError, SyntaxError, TokenError):
        raise NotAQuantity(f"unknown unit '{unit}'") from None


def _tidied(factor: float) -> float:
    """Take the last bits of pint's own arithmetic out of a short decimal: 1 g/cm^3 is 1000 kg/m^3 exactly."""
    short = float(f"{factor:.12g}")
    return short if math.isclose(short, factor, rel_tol=1e-15) else factor


def _dimension_of(unit: str) -> str:
    ureg = registry()
    dimensionality = ureg.Quantity(1.0, ureg.parse_units(unit)).dimensionality
    for name, si in SI_UNITS.items():
        if ureg.Quantity(1.0, si).dimensionality == dimensionality:
            return _article(name)
    return f"of dimension {dimensionality}"


def _article(noun: str) -> str:
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"


def to_si(value: object, dimension: str) -> float:
    """Turn a quantity into its SI value.

    Parameters
    ----------
    value : object
        Text with a number and a unit, or a pint quantity.
    dimension : str
        A key of `SI_UNITS`.

    Returns
    -------
    float
        Finite value in ``SI_UNITS[dimension]``.

    Raises
    ------
    NotAQuantity
        Its text says what was found.
    """
    if isinstance(value, str):
        magnitude, unit = _split(value)
    elif hasattr(value, "magnitude") and hasattr(value, "units"):
        magnitude, unit = _pint_quantity(value.magnitude, value.units)
    elif isinstance(value, (int, float, Real)) and not isinstance(value, bool):
        raise NotAQuantity(f"{value!r} has no unit")
    else:
        raise NotAQuantity(f"{shown(value)} is not a quantity")
    # In decimal, as the file is: 6 mm is then the same float as 0.006 m.
    si = float(Decimal(repr(magnitude)) * Decimal(repr(_factor(unit, dimension))))
    if not math.isfinite(si):
        raise NotAQuantity(f"{shown(value)} is not finite")
    return si


def _split(text: str) -> tuple[float, str]:
    match = _NUMBER_AND_UNIT.fullmatch(text)
    if match is None:
        raise NotAQuantity(f"{shown(text)} is not a number with a unit")
    magnitude = float(match["number"])
    if not math.isfinite(magnitude):
        raise NotAQuantity(f"{shown(text)} is not finite")
    if not match["unit"]:
        raise NotAQuantity(f"{shown(text)} has no unit")
    if not _UNIT.fullmatch(match["unit"]):
        raise NotAQuantity(f"unknown unit {shown(match['unit'])}")
    return magnitude, match["unit"]


def _pint_quantity(magnitude: object, units: object) -> tuple[float, str]:
    if not isinstance(magnitude, Real):
        raise NotAQuantity(f"{shown(magnitude)} is not a single number")
    if not math.isfinite(magnitude):
        raise NotAQuantity(f"{magnitude} is not finite")
    # By name, because a quantity of another registry cannot be converted by ours.
    return float(magnitude), str(units)


def with_unit(value: float, dimension: str) -> str:
    """Write an SI value so that `to_si` returns it exactly."""
    return f"{float(value)!r} {SI_UNITS[dimension]}"


def shown(value: object, longest: int = 60) -> str:
    """Describe a value from a file in a fault, on one line and not too long."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "a table"
    text = repr(value)
    return text if len(text) <= longest else f"{text[:longest]}..."
