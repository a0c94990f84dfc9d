"""The varied values as columns of the store: numbers in SI with their unit, or text."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from softcat_sym.ensemble.grouped import is_group
from softcat_sym.ensemble.table import is_number, kind_of
from softcat_sym.graph.grid import Floats
from softcat_sym.scene.kinds import Number, Quantity, Whole
from softcat_sym.scene.units import SI_UNITS, NotAQuantity, si_unit, to_si, to_si_of_any
from softcat_sym.study.sweep.plan import SweepPlan

_LISTED = 3
"""Positive values over more than this ratio are shown over a logarithm, whatever way they were spaced."""


@dataclass(frozen=True)
class VariedColumn:
    """How the values of a key are stored.

    Attributes
    ----------
    key : str
        Which.
    units : str
        ``"1"`` of pure numbers; an empty text of text.
    scale : str
        ``"lin"`` or ``"log"``.
    dimension : str
        By which text with a unit is read; empty where any unit will do.
    is_text : bool
        Whether values are no numbers.
    """

    key: str
    units: str
    scale: str
    dimension: str
    is_text: bool

    def numbers(self, values: Sequence[object]) -> Floats:
        """Values as numbers in SI, NaN where one makes none."""
        return np.array([self._number(value) for value in values], dtype=float)

    def _number(self, value: object) -> float:
        if is_number(value):
            return float(value)
        try:
            return to_si(value, self.dimension, self.units) if self.dimension else to_si_of_any(value)[0]
        except NotAQuantity:
            return math.nan


def columns_of(plan: SweepPlan) -> tuple[VariedColumn, ...]:
    """A column for each axis of a plan."""
    return tuple(_column(plan, k) for k in range(len(plan.axes)))


def _column(plan: SweepPlan, k: int) -> VariedColumn:
    axis = plan.axes[k]
    kind = kind_of(plan.scene, {}, axis.key)
    if isinstance(kind, Quantity):
        units, dimension = kind.unit or SI_UNITS[kind.dimension], kind.dimension
    elif isinstance(kind, (Number, Whole)) or is_group(axis.key) or all(map(is_number, axis.values)):
        units, dimension = "1", ""
    else:
        found = [to_si_of_any(value) for value in axis.values if _is_quantity(value)]
        if len(found) < len(axis.values):
            return VariedColumn(axis.key, "", "lin", "", True)
        units, dimension = si_unit(found[0][1]) or "1", ""
    column = VariedColumn(axis.key, units, axis.scale, dimension, False)
    if axis.ends is None and _spreads(column.numbers(axis.values)):
        column = VariedColumn(axis.key, units, "log", dimension, False)
    return column


def _spreads(values: Floats) -> bool:
    """Whether listed values are better seen over a logarithm: positive, and over more than a decade."""
    known = values[np.isfinite(values)]
    return len(known) > _LISTED - 1 and bool(np.min(known) > 0) and float(np.max(known) / np.min(known)) > 10


def _is_quantity(value: object) -> bool:
    try:
        to_si_of_any(value)
    except NotAQuantity:
        return False
    return True
