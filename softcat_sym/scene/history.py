"""Quantities that change while the filament hangs: a table of times and values, or a formula of the time t."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

from pydantic_core import PydanticCustomError

from softcat_sym.lazy import lazy_imports
from softcat_sym.scene import units
from softcat_sym.scene.formula import ACCEPTED, FUNCTIONS, Formula, formula_dimension, parse_formula
from softcat_sym.scene.units import SI, Dimension, Kind, NotAQuantity, Number, Quantity, refusal, shown, si_unit

if TYPE_CHECKING:
    import numpy.typing as npt

# To complete a name on the command line takes no NumPy, and most scenes do without SciPy.
with lazy_imports():
    import numpy as np
    from scipy import interpolate

# `scene.units.Kind` documents the methods once for all kinds.
# ruff: noqa: D102

TIME_NAME = "t"
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


class _Literal(NamedTuple):
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
        literals.append(_Literal(match.group(), *units.to_si_of_any(given)))
        return f"quantity_{len(literals) - 1}"

    return _LITERAL.sub(named, text.strip()), tuple(literals)


class History(float):
    """A quantity that changes in time; as a plain number it is its value at t = 0.

    A monotone cubic runs between the rows of a table (Fritsch & Butland 1984); it is constant before and behind. Two
    are equal if they are the same at all times, as far as their numbers and formulas say.
    """

    __slots__ = ("table", "text")

    table: tuple[tuple[float, float], ...]  # Times and values [s, SI], in their order; empty for a formula
    text: str  # The formula; empty for a table

    def __new__(cls, table: Iterable[tuple[float, float]], text: str = "") -> History:
        rows = tuple(sorted((time, float(value)) for time, value in table))
        made = super().__new__(cls, _value(rows, text, 0.0))
        made.table, made.text = rows, text
        return made

    def __getnewargs__(self) -> tuple[Any, ...]:
        return self.table, self.text

    def __eq__(self, other: object) -> bool:
        return isinstance(other, History) and (self.table, self.text) == (other.table, other.text)

    def __ne__(self, other: object) -> bool:
        return not self == other

    def __hash__(self) -> int:
        return hash((self.table, self.text))

    def __repr__(self) -> str:
        if self.text:
            return self.text
        (start, first), (end, last) = self.table[0], self.table[-1]
        return f"{first:g} at {start:g} s to {last:g} at {end:g} s"

    @property
    def numbers(self) -> tuple[float, ...]:
        """What its expression is computed from: quantities of the formula; times, values and slopes of the table."""
        if self.text:
            return tuple(literal.value for literal in _lexed(self.text)[1])
        times, values = zip(*self.table, strict=True)
        return (*times, *values, *map(float, _cubic(self.table)(times, 1)))

    @property
    def formula(self) -> Formula | None:
        """The formula of ``t`` and ``quantity_0``, ``quantity_1``, ...; None for a table."""
        return parse_formula(_lexed(self.text)[0]) if self.text else None

    def at(self, time: float) -> float:
        """Return its value at a time [s]."""
        return _value(self.table, self.text, time)

    def extremes(self, duration: float) -> tuple[float, float]:
        """Return the smallest and the largest value from the start to a time [s]."""
        return _extremes(self, duration)

    def refused(self, kind: Changing, duration: float) -> str:
        """Say which value of a run is none that the constant may have; empty if all may be."""

        def is_fine(value: float) -> bool:
            try:
                kind.constant(SI(value) if kind.si else value)
            except PydanticCustomError:
                return False
            return True

        formula = self.formula
        if formula is None:  # Every row of a table was read by itself, and between two rows nothing lies beyond them.
            return ""
        for highest in (False, True):
            time, value = formula.least(TIME_NAME, (0.0, duration), _known(self.text), is_fine, highest=highest)
            if not is_fine(value):
                return f"{shown(self.text)} is {value:.4g} at t = {time:.8g} s"
        return ""

    def quantities(self, unit: str) -> tuple[tuple[float, str], ...]:
        """Return the values of the table, in the unit of the whole, or the quantities of the formula, in their own."""
        if self.table:
            return tuple((value, unit) for _, value in self.table)
        return tuple((one.value, si_unit(one.dimension)) for one in _lexed(self.text)[1])

    def with_quantity(self, number: int, value: float) -> History:
        """Return it with another value of the table, or another quantity of the formula, counted from 0."""
        if self.table:
            return History((time, value if k == number else one) for k, (time, one) in enumerate(self.table))
        written, literals = _lexed(self.text)
        texts = [one.text for one in literals]
        texts[number] = units.with_unit(value, si_unit(literals[number].dimension))
        return History((), _PLACEHOLDER.sub(lambda match: texts[int(match[1])], written))

    def scaled(self, factor: float) -> History:
        """Return it times a number."""
        rows = ((time, factor * value) for time, value in self.table)
        return History(rows, f"{factor!r} * ({self.text})" if self.text else "")


def _known(text: str) -> dict[str, float]:
    return {f"quantity_{k}": literal.value for k, literal in enumerate(_lexed(text)[1])}


@lru_cache(maxsize=256)
def _cubic(table: tuple[tuple[float, float], ...]) -> interpolate.PchipInterpolator:
    return interpolate.PchipInterpolator(*zip(*table, strict=True))


def _value(table: tuple[tuple[float, float], ...], text: str, time: float) -> float:
    if text:
        return parse_formula(_lexed(text)[0]).value_of({**_known(text), TIME_NAME: time})
    (start, first), (end, last) = table[0], table[-1]
    return float(_cubic(table)(time)) if start < time < end else first if time <= start else last


@lru_cache(maxsize=256)
def _extremes(history: History, duration: float) -> tuple[float, float]:
    """Smallest and largest value in a run; of a formula as seen at many times, and in between by its bounds."""
    formula, known = history.formula, _known(history.text)
    if formula is None:
        values = [history.at(time) for time in (0.0, *(time for time, _ in history.table if 0 < time < duration))]
        return min(*values, history.at(duration)), max(*values, history.at(duration))
    seen = [history.at(duration * k / (_SAMPLES - 1)) for k in range(_SAMPLES)]
    low, high = min(seen), max(seen)
    within, run = _APART * (high - low), (0.0, duration)
    _, least = formula.least(TIME_NAME, run, known, lambda value: value >= low - within, tolerance=_APART)
    _, most = formula.least(TIME_NAME, run, known, lambda value: value <= high + within, highest=True, tolerance=_APART)
    return min(low, least), max(high, most)


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


def read_formula(text: str, wanted: Dimension) -> History:
    """Read a formula of t whose value has this dimension; raises `refusal`."""
    try:
        written, literals = _lexed(text)
    except NotAQuantity as error:
        raise refusal(str(error), _FORMULA) from None
    dimensions = {f"quantity_{k}": literal.dimension for k, literal in enumerate(literals)}
    try:
        formula = parse_formula(written)
        if unknown := sorted(formula.all_names - {*dimensions, TIME_NAME}):
            joined = ": a unit follows its number, joined without blanks as in 5 Pa/s"
            hint = joined if unknown[0] in units.COMMON else ""
            raise refusal(f"unknown name {shown(unknown[0])} in {shown(text)}{hint}", _FORMULA)
        found = formula_dimension(formula, {**dimensions, TIME_NAME: (0.0, 0.0, 1.0)}, _known(text))
    except PydanticCustomError as error:
        # In the user's words: with the quantities as they were written.
        what, accepted = (
            _PLACEHOLDER.sub(lambda match: literals[int(match[1])].text, str((error.context or {}).get(part, "")))
            for part in ("found", "accepted")
        )
        raise refusal(what, _FORMULA if accepted == ACCEPTED else accepted) from None
    if found is not None and not units.same_dimension(found, wanted):
        of, needed = (f"of unit {unit}" if (unit := si_unit(one)) else "" for one in (found, wanted))
        needed = f"a formula of t {needed}" if needed else "a formula of t that is a pure number"
        raise refusal(f"{shown(text)} is {of or 'a pure number'}", needed)
    return History((), text.strip())


class Changing(Kind):
    """Mixin of a kind of number that may change in time: a value of that kind, or a `History` of such values."""

    has_formulas = True
    argument = Quantity("time", "60 s", "any")

    def constant(self, value: object) -> float:
        """Return one value; raises `refusal`."""
        try:
            return float(super().check(value))
        except NotAQuantity as found:
            raise self.refuse(str(found)) from None

    def check(self, value: Any) -> float:
        if isinstance(value, History):
            return value
        if isinstance(value, Mapping):
            return self._from_table(value)
        if self.has_formulas and isinstance(value, str) and _TIME_WORD.search(_LITERAL.sub("0", value)):
            history = read_formula(value, units.dimension_of(self.unit))
            # At the start, before anything is computed from it; `refused` looks at the rest of the run.
            self.constant(SI(history) if self.si else float(history))
            return history
        return self.constant(value)

    def _from_table(self, value: Mapping[Any, object]) -> History:
        """Read a table of times, or of another argument, and values; every fault at its own row."""
        what = self.argument.dimension
        if not 2 <= len(value) <= _MOST:
            raise refusal(f"a table of {len(value)} {what}s", f"2 to {_MOST}: {self.accepted}")
        rows: dict[float, float] = {}

        def read(key: Any, given: object) -> None:
            try:
                # A bare number is a key in Python only, and SI as all bare numbers there.
                at = self.argument.check(key if isinstance(key, str) else SI(key))
            except (NotAQuantity, TypeError, ValueError) as error:
                raise refusal(f"the {what} {shown(key)}: {error}", self.argument.accepted) from None
            if at in rows:
                raise refusal(f"the {what} {at:g} {self.argument.unit} twice", f"each {what} once")
            rows[at] = math.nan
            rows[at] = self.constant(given)

        units.read_each("history", ((str(key), read, (key, given)) for key, given in value.items()))
        return History(rows.items())

    def write(self, value: float) -> object:
        if not isinstance(value, History):
            return super().write(value)
        unit = self.argument.unit
        return value.text or {f"{at!r} {unit}": super(Changing, self).write(one) for at, one in value.table}


class ChangingQuantity(Changing, Quantity):
    """A quantity that may change in time."""


class ChangingNumber(Changing, Number):
    """A dimensionless number that may change in time."""
