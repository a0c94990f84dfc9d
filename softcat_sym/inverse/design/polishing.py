"""The last digits of a critical span, and its gradient, with effects that are fixed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from numbers import Real
from typing import Protocol

import numpy as np

from softcat_sym.inverse.design.variables import read_positive, read_share

_STEPS = 8
_FINE, _GOOD = 1e-9, 1e-4  # of log sag over the limit
_NEAR = 0.1  # of log span, in which effects chosen at one span hold for another
_BESIDE = 1e-3  # of log span: slopes that differ over so little are no derivatives of something smooth
_SCATTER = 0.02


LIMITS = 'a positive length such as "2 mm", or a fraction of the span such as "5 %"'
"""Limits of the sag that are accepted."""


class SagWithSlopes(Protocol):
    """Something whose sag is known with its derivatives."""

    def at(self, span: float) -> tuple[float, float, dict[str, float]]:
        """Sag [m], d log sag/d log span, d log sag/d log parameter."""
        ...


@dataclass(frozen=True, slots=True)
class Limit:
    """Of the sag: a length, or a fraction of the span.

    Attributes
    ----------
    value : float
        [m], or a fraction.
    of_span : bool
        Which of them.
    """

    value: float
    of_span: bool

    def at(self, span: float) -> float:
        """The limit [m]."""
        return self.value * span if self.of_span else self.value

    def excess(self, span: float, sag: float) -> float:
        """Logarithm of the sag over the limit."""
        if not sag > 0:
            return -math.inf
        return math.log(sag / self.at(span)) if math.isfinite(sag) else math.inf

    def slope(self, by_span: float) -> float:
        """Slope of the excess by log span, from that of log sag."""
        return by_span - 1.0 if self.of_span else by_span


def read_limit(value: object) -> Limit:
    """Read a length with its unit, or a fraction of the span: a number, or text such as ``"5 %"``.

    Raises
    ------
    NotAQuantity
        Its text says what was found.
    """
    share = read_share(value)
    if share is not None:
        return Limit(share, of_span=True)
    return Limit(read_positive(value, "length", "m"), of_span=isinstance(value, (int, float, Real)))


@dataclass(frozen=True, eq=False)
class Root:
    """A critical span.

    Attributes
    ----------
    span, sag : float
        [m].
    gradient : dict of str to float
        d log span/d log parameter.
    notes : tuple of str
        What to know beside it.
    """

    span: float
    sag: float
    gradient: dict[str, float]
    notes: tuple[str, ...]


def polished(frozen: SagWithSlopes, limit: Limit, near: float) -> Root:
    """Find the root by Newton's method in logarithms, and its gradient by implicit differentiation.

    Where things yield fibre by fibre, slopes scatter from one span to the next: then the median over five neighbouring
    spans is taken, and said.

    Parameters
    ----------
    near : float
        Span [m] within some 0.1 % of the root.
    """
    x, best = math.log(near), (math.inf, near, math.nan)
    for _ in range(_STEPS):
        sag, by_span, _ = frozen.at(math.exp(x))
        left = limit.excess(math.exp(x), sag)
        best = min(best, (abs(left), math.exp(x), sag))
        slope = limit.slope(by_span)
        if not math.isfinite(left) or abs(left) < _FINE or not slope > 0 or abs(left / slope) > _NEAR:
            break
        x -= left / slope
    left, span, sag = best
    notes: list[str] = []
    if not left < _GOOD:
        notes.append(
            "Other effects set in here, where the sag jumps: the span is known to 0.2 %, the gradient roughly."
        )
        span, sag = near, limit.at(near)
    gradient, scatter = _gradient(frozen, limit, span)
    if scatter > _SCATTER:
        notes.append(
            f"The exponents scatter by {scatter:.2g} from span to span, as fibres yield: their median is given."
        )
    return Root(span, sag, gradient, tuple(notes))


def _gradient(frozen: SagWithSlopes, limit: Limit, span: float) -> tuple[dict[str, float], float]:
    """Exponents, and by how much they scatter."""
    rows = [row for row in (_exponents(frozen, limit, span * math.exp(_BESIDE * k)) for k in (0, 1)) if row]
    scatter = _spread(rows)
    if len(rows) == 2 and scatter <= _SCATTER:
        return rows[0], scatter
    rows += [row for row in (_exponents(frozen, limit, span * math.exp(_BESIDE * k)) for k in (-2, -1, 2)) if row]
    if not rows:
        return {}, math.inf
    medians = {path: float(np.median([row[path] for row in rows])) for path in rows[0]}
    typical = sorted(rows, key=lambda row: max(abs(row[path] - medians[path]) for path in medians))
    return medians, _spread(typical[: max(2, len(rows) - 1)])


def _exponents(frozen: SagWithSlopes, limit: Limit, span: float) -> dict[str, float]:
    sag, by_span, by_parameter = frozen.at(span)
    slope = limit.slope(by_span)
    if not math.isfinite(sag) or not slope > 0:
        return {}
    return {path: -value / slope for path, value in by_parameter.items()}


def _spread(rows: Sequence[dict[str, float]]) -> float:
    if len(rows) < 2:
        return math.inf
    return max(max(row[path] for row in rows) - min(row[path] for row in rows) for path in rows[0])
