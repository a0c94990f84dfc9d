"""Numbers as people read them: units, significant digits, regimes and errors in words."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Summary: TypeAlias = Mapping[str, Any]
"""The dictionary that ``summary.json`` holds."""


@dataclass(frozen=True, slots=True)
class Unit:
    """A display unit."""

    symbol: str  # Symbol written on the axis
    size: float  # Size of the unit in SI units
    begin: float | None = None  # Values from which it is taken, where that is not its size

    def of(self, value: ArrayLike) -> NDArray[np.float64]:
        """Express SI values in this unit."""
        return np.asarray(value, dtype=np.float64) / self.size

    def text(self, value: float) -> str:
        """Write one SI value with three significant digits and this unit."""
        return f"{significant(value / self.size)} {self.symbol}"


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def typeset(unit: str) -> str:
    """A unit as it is printed: ``Pa·s^0.5``, ``s⁻¹``, ``m/s²`` of ``Pa*s^0.5``, ``1/s``, ``m/s^2``."""
    inverse = re.fullmatch(r"1/(\w+)(?:\^(\d+))?", unit)
    text = f"{inverse[1]}^-{inverse[2] or 1}" if inverse else unit.replace("*", "·").replace(" ", "·")
    return re.sub(r"\^(-?\d+)(?![.\d])", lambda power: raised(power[1]), text)


def raised(power: object) -> str:
    """A whole number as an exponent."""
    return str(power).translate(_RAISED)


LENGTHS = (Unit("nm", 1e-9), Unit("µm", 1e-6), Unit("mm", 1e-3), Unit("m", 1.0), Unit("km", 1e3))
# An hour and a minute begin late: 90 s and 100 min read better than 1.5 min and 1.67 h.
TIMES = (Unit("µs", 1e-6), Unit("ms", 1e-3), Unit("s", 1.0), Unit("min", 60.0, 300.0), Unit("h", 3600.0, 10800.0))
ENERGIES = (Unit("pJ", 1e-12), Unit("nJ", 1e-9), Unit("µJ", 1e-6), Unit("mJ", 1e-3), Unit("J", 1.0), Unit("kJ", 1e3))
SHARES = (Unit("ppb", 1e-9), Unit("ppm", 1e-6), Unit("%", 1e-2, 1e-4))
STRESSES = (Unit("mPa", 1e-3), Unit("Pa", 1.0), Unit("kPa", 1e3), Unit("MPa", 1e6), Unit("GPa", 1e9))


def _choose(units: tuple[Unit, ...], largest: float) -> Unit:
    """Take the last unit whose range has begun; the slack keeps 0.999999999999 s in seconds."""
    size = abs(largest or 1.0)
    reached = [unit for unit in units if size >= (unit.begin or unit.size) * (1 - 1e-9)]
    return reached[-1] if reached else units[0]


def length_unit(largest: float, fallback: float = 1.0) -> Unit:
    """Choose nm, µm, mm, m or km for lengths up to ``largest`` [m]."""
    return _choose(LENGTHS, largest or fallback)


time_unit = partial(_choose, TIMES)  # of times up to a largest [s]: min from 300 s, h from 3 h
energy_unit, share_unit, stress_unit = (partial(_choose, units) for units in (ENERGIES, SHARES, STRESSES))


def significant(value: float) -> str:
    """Write a number with three significant digits, a true minus sign and no exponent between 1e-3 and 1e5."""
    if value == 0 or not math.isfinite(value):
        return f"{abs(value):g}" if value == 0 else str(value)
    exponent = math.floor(math.log10(abs(float(f"{value:.2e}"))))
    text = f"{value:.{max(0, 2 - exponent)}f}" if -3 <= exponent < 5 else f"{value:.2e}"
    return text.replace("-", "\N{MINUS SIGN}", 1) if value < 0 else text


def nice_floor(value: float) -> float:
    """Round a positive number down to 1, 2 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    # The tiny slack keeps 0.02 / 0.01 a two, and not 1.9999999999999998.
    return max((step for step in (1.0, 2.0, 5.0) if step * power <= value * (1 + 1e-12)), default=1.0) * power


REGIMES = {
    "no-yield": "it holds: no fibre yields",
    "arrested-overdamped": "it yields, sags and stops",
    "arrested-underdamped": "it yields, overshoots, swings back and stops",
    "descending": "it does not stop within this run",
    "viscous": "it flows for as long as it is loaded",
    "shaken": "it has yielded, is shaken, and flows no further",
    "elastic": "it is elastic and sags no further than its modulus lets it",
}
"""Regimes by name."""


def regime_words(name: str) -> str:
    """A regime in words, and its name."""
    return f"{REGIMES[name]} ({name})" if name in REGIMES else name


def error_percent(share: float) -> str:
    """An error in per cent with one digit, two if the first is a one: ``0.09 %``, ``1.1 %``."""
    digits = 2 if f"{100 * share:.1e}".startswith("1") else 1
    return f"{float(f'{100 * share:.{digits}g}'):g} %"
