"""Quantities that change while the filament hangs: a table of times and values, or a formula of the time t."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import TYPE_CHECKING, Any

from pydantic_core import PydanticCustomError

from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.formula import ACCEPTED, FUNCTIONS, Formula, dimension_of, parse_formula
from softcat_sym.scene.units import (
    COMMON,
    PURE,
    SI,
    SI_UNITS,
    Dimension,
    Kind,
    NotAQuantity,
    Number,
    Quantity,
    read_each,
    refusal,
    same_dimension,
    shown,
    si_unit,
    to_si,
    to_si_of_any,
)

if TYPE_CHECKING:
    import numpy.typing as npt

# To complete a name on the command line takes no NumPy, and most scenes do without SciPy.
with lazy_imports():
    import numpy as np
    from scipy import interpolate

# `scene.units.Kind` documents the methods once for all kinds.
# ruff: noqa: D102

TIME_NAME = "t"
_TIME: Dimension = (0.0, 0.0, 1.0)
EXAMPLE = '{"0 s" = "200 Pa", "60 s" = "900 Pa"} or "200 Pa + 5 Pa/s * t"'
_FORMULA = f"numbers, quantities such as 5 Pa/s, the time t, + - * / **, and {', '.join(FUNCTIONS)}"
_MOST = 100
# At how many times of a run a formula is looked at for its extremes, and the share of their difference by which a value
# between two of them may exceed them.
_SAMPLES, _APART = 401, 1e-3

_POWER = r"(?:(?:\^|\*\*)[-+]?\d+(?:\.\d+)?)?"
_WORD = r"(?!t\b|pi\b)[^\W\d_]+(?!\w|\s*\()"
# A quantity inside a formula: a unit is joined without blanks, and goes on as long as words that are no function do.
_LITERAL = re.compile(
    rf"(?<![\w.])(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)"
    rf"(?:\s*(?P<unit>(?:1/)?{_WORD}{_POWER}(?:[*/]{_WORD}{_POWER})*))?"
)
_EXPONENT = re.compile(r"\*\*\s*[-+]?\s*$")
_PLACEHOLDER = re.compile(r"\bquantity_(\d+)\b")
_TIME_WORD = re.compile(r"(?<![\w.])t(?!\w)")


@dataclass(frozen=True, slots=True)
class _Table:
    """Values at times, between which a monotone cubic runs (Fritsch & Butland 1984); constant before and behind."""

    times: tuple[float, ...]
    values: tuple[float, ...]

    @property
    def slopes(self) -> tuple[float, ...]:
        """Slopes of the cubics at the times, on their inner side."""
        return tuple(map(float, _cubic(self)(self.times, 1)))

    @property
    def numbers(self) -> tuple[float, ...]:
        """Times, values and slopes, in the order in which :meth:`fold` names them."""
        return (*self.times, *self.values, *self.slopes)

    def at(self, time: float) -> float:
        """Value at a time [s]."""
        if not self.times[0] < time < self.times[-1]:
            return self.values[0 if time <= self.times[0] else -1]
        return float(_cubic(self)(time))


@lru_cache(maxsize=256)
def _cubic(table: _Table) -> interpolate.PchipInterpolator:
    return interpolate.PchipInterpolator(table.times, table.values)


@dataclass(frozen=True, slots=True)
class _Timely:
    """A formula of t whose quantities have become named numbers."""

    formula: Formula
    numbers: tuple[float, ...]

    def at(self, time: float) -> float:
        """Value at a time [s]."""
        return self.formula.value_of({**self._known, TIME_NAME: time})

    @property
    def _known(self) -> dict[str, float]:
        return {f"quantity_{k}": number for k, number in enumerate(self.numbers)}

    def least(self, duration: float, is_fine: Callable[[float], bool], **how: Any) -> tuple[float, float]:
        """When a run has the least value, and that: see :meth:`Formula.least`."""
        return self.formula.least(TIME_NAME, (0.0, duration), self._known, is_fine, **how)


@lru_cache(maxsize=256)
def _extremes(formula: _Timely, duration: float) -> tuple[float, float]:
    """Smallest and largest value of a formula in a run, as seen at many times and in between by its bounds."""
    seen = [formula.at(duration * k / (_SAMPLES - 1)) for k in range(_SAMPLES)]
    low, high = min(seen), max(seen)
    within = _APART * (high - low)
    _, least = formula.least(duration, lambda value: value >= low - within, tolerance=_APART)
    _, most = formula.least(duration, lambda value: value <= high + within, highest=True, tolerance=_APART)
    return min(low, least), max(high, most)


class History(float):
    """A quantity that changes in time; as a plain number it is its value at t = 0.

    Two are equal if they are the same at all times, as far as their numbers and formulas say.
    """

    __slots__ = ("_of_time", "text")

    text: str  # The formula; empty for a table
    _of_time: _Table | _Timely

    def __new__(cls, of_time: _Table | _Timely, text: str = "") -> History:
        made = super().__new__(cls, of_time.at(0.0))
        made._of_time, made.text = of_time, text
        return made

    def __getnewargs__(self) -> tuple[Any, ...]:
        return self._of_time, self.text

    def __eq__(self, other: object) -> bool:
        return isinstance(other, History) and (self._of_time, self.text) == (other._of_time, other.text)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash((self._of_time, self.text))

    def __repr__(self) -> str:
        return self.words

    @property
    def is_table(self) -> bool:
        """Whether it is a table of times and values."""
        return isinstance(self._of_time, _Table)

    @property
    def table(self) -> tuple[tuple[float, float], ...]:
        """Times and values of a table [s, SI]; empty for a formula."""
        of_time = self._of_time
        return tuple(zip(of_time.times, of_time.values, strict=True)) if isinstance(of_time, _Table) else ()

    @property
    def words(self) -> str:
        """It in one line: the formula, or first and last row of the table."""
        if not self.is_table:
            return self.text
        (start, first), (end, last) = self.table[0], self.table[-1]
        return f"{first:g} at {start:g} s to {last:g} at {end:g} s"

    @property
    def numbers(self) -> tuple[float, ...]:
        """What its expression is computed from: quantities of the formula; times, values and slopes of the table."""
        return self._of_time.numbers

    @property
    def formula(self) -> Formula | None:
        """The formula of ``t`` and ``quantity_0``, ``quantity_1``, ...; None for a table."""
        return self._of_time.formula if isinstance(self._of_time, _Timely) else None

    def at(self, time: float) -> float:
        """Return its value at a time [s]."""
        return self._of_time.at(time)

    def extremes(self, duration: float) -> tuple[float, float]:
        """Return the smallest and the largest value from the start to a time [s]."""
        if not self.is_table:
            return _extremes(self._of_time, duration)
        values = [self.at(time) for time in (0.0, *(time for time, _ in self.table if 0 < time < duration), duration)]
        return min(values), max(values)

    def refused(self, kind: Kind, duration: float) -> str:
        """Say which value of a run is none that the constant may have; empty if all may be."""
        if isinstance(self._of_time, _Table):
            # Every row was read by itself, and between two rows nothing lies beyond them.
            return ""

        def is_fine(value: float) -> bool:
            try:
                kind.read(SI(value) if isinstance(kind, Quantity) else value)
            except PydanticCustomError:
                return False
            return True

        for highest in (False, True):
            time, value = self._of_time.least(duration, is_fine, highest=highest)
            if not is_fine(value):
                return f"{shown(self.text)} is {value:.4g} at t = {time:.8g} s"
        return ""

    def quantities(self, unit: str) -> tuple[tuple[float, str], ...]:
        """Return the values of the table, in the unit of the whole, or the quantities of the formula, in their own."""
        if self.is_table:
            return tuple((value, unit) for _, value in self.table)
        return tuple((one.value, si_unit(one.dimension)) for one in _lexed(self.text)[1])

    def with_quantity(self, number: int, value: float) -> History:
        """Return it with another value of the table, or another quantity of the formula, counted from 0."""
        if isinstance(self._of_time, _Table):
            values = list(self._of_time.values)
            values[number] = value
            return History(_Table(self._of_time.times, tuple(values)))
        written, literals = _lexed(self.text)
        unit = si_unit(literals[number].dimension)
        texts = [one.text for one in literals]
        texts[number] = f"{value!r} {unit}" if unit else repr(value)
        text = _PLACEHOLDER.sub(lambda match: texts[int(match[1])], written)
        numbers = tuple(value if k == number else one.value for k, one in enumerate(literals))
        return History(_Timely(parse_formula(written), numbers), text)

    def scaled(self, factor: float) -> History:
        """Return it times a number."""
        if isinstance(self._of_time, _Table):
            return History(_Table(self._of_time.times, tuple(factor * value for value in self._of_time.values)))
        text = f"{factor!r} * ({self.text})"
        written, literals = _lexed(text)
        return History(_Timely(parse_formula(written), tuple(literal.value for literal in literals)), text)


def is_history(value: object) -> bool:
    """Tell whether a constant changes in time."""
    return isinstance(value, History)


def value_at(value: float, time: float) -> float:
    """Value of a constant at a time [s], whether it changes or not."""
    return value.at(time) if isinstance(value, History) else value


def scaled(value: float, factor: float) -> float:
    """Return a constant times a number, at all times."""
    return value.scaled(factor) if isinstance(value, History) else factor * value


def values_at(value: float, times: Iterable[float]) -> npt.NDArray[np.float64]:
    """Values of a constant at several times [s]."""
    return np.array([value_at(value, float(time)) for time in times])


def extremes_of(value: float, duration: float) -> tuple[float, float]:
    """Smallest and largest value of a constant during a run [s]."""
    return value.extremes(duration) if isinstance(value, History) else (value, value)


def named_numbers(name: str, history: History) -> dict[str, float]:
    """Name the numbers of a history as the symbols of its expression are named."""
    return {f"{name}_{k}": number for k, number in enumerate(history.numbers)}


def table_history(rows: Mapping[float, float]) -> History:
    """Return the history of values at times [s], SI."""
    times = tuple(sorted(rows))
    return History(_Table(times, tuple(float(rows[time]) for time in times)))


@dataclass(frozen=True, slots=True)
class _Literal:
    """A quantity in a formula."""

    text: str  # As written
    value: float
    dimension: Dimension


@lru_cache(maxsize=256)
def _lexed(text: str) -> tuple[str, tuple[_Literal, ...]]:
    """The formula with names for its quantities, and these; an exponent stays, and so does a bare whole number."""
    literals: list[_Literal] = []

    def named(match: re.Match[str]) -> str:
        number, unit = match["number"], match["unit"]
        if unit is None and (number.isdigit() or _EXPONENT.search(text[: match.start()])):
            return match.group()
        given = float(number) if unit is None else f"{number} {unit.replace('**', '^')}"
        literals.append(_Literal(match.group(), *to_si_of_any(given)))
        return f"quantity_{len(literals) - 1}"

    return _LITERAL.sub(named, text.strip()), tuple(literals)


def read_formula(text: str, wanted: Dimension) -> History:
    """Read a formula of t whose value has this dimension; raises `refusal`."""
    try:
        written, literals = _lexed(text)
    except NotAQuantity as error:
        raise refusal(str(error), _FORMULA) from None
    dimensions = {f"quantity_{k}": literal.dimension for k, literal in enumerate(literals)}
    numbers = {f"quantity_{k}": literal.value for k, literal in enumerate(literals)}
    try:
        formula = parse_formula(written)
        if unknown := sorted(formula.all_names - {*dimensions, TIME_NAME}):
            hint = ": a unit follows its number, joined without blanks as in 5 Pa/s" if unknown[0] in COMMON else ""
            raise refusal(f"unknown name {shown(unknown[0])} in {shown(text)}{hint}", _FORMULA)
        found = dimension_of(formula, {**dimensions, TIME_NAME: _TIME}, numbers)
    except PydanticCustomError as error:
        raise _in_the_users_words(error, literals) from None
    if found is not None and not same_dimension(found, wanted):
        unit = si_unit(found)
        raise refusal(f"{shown(text)} is {'of unit ' + unit if unit else 'a pure number'}", _of_unit(wanted))
    return History(_Timely(formula, tuple(numbers.values())), text.strip())


def _of_unit(wanted: Dimension) -> str:
    unit = si_unit(wanted)
    return f"a formula of t of unit {unit}" if unit else "a formula of t that is a pure number"


def _in_the_users_words(error: PydanticCustomError, literals: tuple[_Literal, ...]) -> PydanticCustomError:
    """The refusal of a formula with the quantities as they were written."""
    context = error.context or {}
    found, accepted = (
        _PLACEHOLDER.sub(lambda match: literals[int(match[1])].text, str(context.get(part, "")))
        for part in ("found", "accepted")
    )
    return refusal(found, _FORMULA if accepted == ACCEPTED else accepted)


def read_table(value: Mapping[Any, Any], item: Kind) -> History:
    """Read a table of times and values; every fault at its own row."""
    if not 2 <= len(value) <= _MOST:
        raise refusal(f"a table of {len(value)} times", f"2 to {_MOST} times, such as {EXAMPLE.split(' or ')[0]}")
    rows: dict[float, float] = {}

    def read(key: Any, given: object) -> None:
        try:
            # A bare number is a key in Python only, and SI as all bare numbers there.
            time = to_si(key if isinstance(key, str) else SI(key), "time")
        except (NotAQuantity, TypeError, ValueError) as error:
            raise refusal(f"the time {shown(key)}: {error}", 'a time with its unit, such as "60 s"') from None
        if time in rows:
            raise refusal(f"the time {time:g} s twice", "each time once")
        rows[time] = math.nan
        rows[time] = item.read(given)

    read_each("history", {str(key): partial(read, key, given) for key, given in value.items()})
    return table_history(rows)


def _read(value: object, item: Kind, dimension: Dimension) -> float:
    if isinstance(value, History):
        return value
    if isinstance(value, Mapping):
        return read_table(value, item)
    if isinstance(value, str) and _TIME_WORD.search(_LITERAL.sub("0", value)):
        history = read_formula(value, dimension)
        # At the start, before anything is computed from it; `refused` looks at the rest of the run.
        item.read(SI(history.at(0.0)) if isinstance(item, Quantity) else history.at(0.0))
        return history
    return float(item.read(value))


def _write(value: Any, item: Kind) -> object:
    if not isinstance(value, History):
        return item.write(value)
    return {f"{time!r} s": item.write(one) for time, one in value.table} if value.is_table else value.text


class Timed(Quantity):
    """A quantity that may change in time: stored as an SI float, or as a `History` of SI floats."""

    def __init__(self, dimension: str, example: str, sign: str = "positive", unit: str = "") -> None:
        super().__init__(dimension, example, sign, unit)
        self.constant = Quantity(dimension, example, sign, unit)

    def read(self, value: object) -> float:
        wanted = to_si_of_any(f"1 {self.unit or SI_UNITS[self.dimension]}")[1]
        return _read(value, self.constant, wanted)

    def write(self, value: float) -> object:
        return _write(value, self.constant)


class TimedNumber(Number):
    """A dimensionless number that may change in time."""

    def __init__(self, above: float = -math.inf, below: float = math.inf, *, closed: bool = False) -> None:
        super().__init__(above, below, closed=closed)
        self.constant = Number(above, below, closed=closed)

    def read(self, value: object) -> float:
        return _read(value, self.constant, PURE)

    def write(self, value: float) -> object:
        return _write(value, self.constant)
