"""Measurements of falling filaments: midpoints over time, or whole shapes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from softcat_sym.errors import Fault
from softcat_sym.inverse.csv_text import counted, refusal
from softcat_sym.inverse.measurements.columns import MIDPOINT, STD, TIME
from softcat_sym.inverse.measurements.repairs import SAME_TIME, repaired

Floats = NDArray[np.float64]

FEWEST = 5
"""Distinct times, or points of shapes, that are needed: below it a trend and its noise cannot be told apart."""

# A filament is neither filmed for longer than 30 000 years nor known better than to a thousandth of an atom.
_MOST, _FINEST = 1e12, 1e-15
# Of the largest height: what is left of no movement after arithmetic.
_ROUNDING = 1e-12


@dataclass(frozen=True, eq=False)
class Shapes:
    """Points of the centre line at one or several times.

    Attributes
    ----------
    time, x, y : ndarray, shape (points,)
        [s], not decreasing; [m] with x = 0 halfway between the supports; [m] upwards from the supports' level. Kept
        as copies that cannot be written to.
    std : ndarray, shape (points,), or None
        Standard errors of y [m]; None if they are not known.

    Raises
    ------
    SoftcatError
        With every fault at once, if these are not lists of one length of at least `FEWEST` finite numbers.
    """

    time: Floats
    x: Floats
    y: Floats
    std: Floats | None = None

    def __post_init__(self) -> None:
        faults = _adopt(self, ("time", "x", "y", "std"))
        if not faults and self.time.size < FEWEST:
            faults = [Fault("", counted(self.time.size, "point"), f"at least {FEWEST}")]
        if not faults and _is_constant(self.y):
            faults = [Fault("y", f"{self.y[0]:g} m at every point", "the shape of a filament that sags")]
        if faults:
            raise refusal("shapes", None, faults)


@dataclass(frozen=True, eq=False)
class Series:
    """One filmed filament.

    Attributes
    ----------
    time : ndarray, shape (n,)
        [s] since the release, increasing; kept as a copy that cannot be written to, as the others are.
    midpoint : ndarray, shape (n,)
        Height of the midpoint [m], negative below the supports' level.
    std : ndarray, shape (n,), or None
        Standard errors of the midpoint [m]; None if they are not known, then they are estimated from the residuals.
    shapes : Shapes or None
        Whole shapes besides, or instead; then `time` and `midpoint` may be empty.
    overrides : mapping of str to str
        Values of the scene that this filament has of its own: ``{"filament.span": "5 mm"}``.
    path : pathlib.Path or None
        The file they come from.
    notes : tuple of str
        What was corrected, a sentence each.

    Raises
    ------
    SoftcatError
        With every fault at once: lists that differ in length, numbers that are not finite, times before 0 or that do
        not increase, fewer than `FEWEST` of them, a midpoint that never moves.
    """

    time: Floats
    midpoint: Floats
    std: Floats | None = None
    shapes: Shapes | None = None
    overrides: Mapping[str, str] = field(default_factory=dict)
    path: Path | None = None
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "overrides", dict(self.overrides))
        object.__setattr__(self, "notes", tuple(self.notes))
        faults = _adopt(self, ("time", "midpoint", "std"))
        if not faults:
            faults = self._too_little()
        if faults:
            raise refusal("measurements", self.path, faults)

    def _too_little(self) -> list[Fault]:
        if self.shapes is not None and not self.time.size:
            return []
        repeats = np.flatnonzero(np.diff(self.time) <= SAME_TIME * self.time[-1:])
        if repeats.size:
            again = int(repeats[0]) + 1
            return [
                Fault(f"time[{again}]", f"{self.time[again]:g} s again", "each time once (Measurements.of averages)")
            ]
        if self.time.size < FEWEST:
            accepted = f"at least {FEWEST}: fewer say nothing about a material"
            return [Fault("", counted(self.time.size, "distinct time"), accepted)]
        if _is_constant(self.midpoint):
            found = f"{self.midpoint[0]:g} m at every time: nothing moves"
            return [Fault("midpoint", found, "a filament filmed while it falls")]
        return []


@dataclass(frozen=True, eq=False)
class Measurements:
    """Filmed filaments of one material.

    Attributes
    ----------
    series : tuple of Series
        One for each filament, at least one.

    Raises
    ------
    SoftcatError
        If there is none.
    """

    series: tuple[Series, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "series", tuple(self.series))
        if not self.series or not all(isinstance(one, Series) for one in self.series):
            raise refusal("measurements", None, [Fault("series", "no filament", "at least one Series")])

    @classmethod
    def of(
        cls,
        time: ArrayLike,
        midpoint: ArrayLike,
        std: ArrayLike | None = None,
        overrides: Mapping[str, str] | None = None,
    ) -> Measurements:
        """Take one filament from arrays; what a file would be corrected for is corrected here too, and noted.

        Parameters
        ----------
        time : array_like, shape (n,)
            [s] since the release, in any order; rows with a NaN are left out if they are less than a third.
        midpoint : array_like, shape (n,)
            [m], negative below the supports' level.
        std : array_like, shape (n,), optional
            Standard errors of the midpoint [m]; one number stands for all.
        overrides : mapping of str to str, optional
            Values of the scene that this filament has of its own.

        Returns
        -------
        Measurements
            Of one series.

        Raises
        ------
        SoftcatError
            With every fault at once.
        """
        given = {TIME: time, MIDPOINT: midpoint} | ({} if std is None else {STD: std})
        table, faults = {}, []
        for name, values in given.items():
            try:
                table[name] = np.ma.filled(np.ma.array(values, dtype=np.float64), np.nan)
            except (TypeError, ValueError):
                faults.append(Fault(name, "not a list of numbers", "numbers in s or m"))
        if not faults:
            if STD in table and table[STD].ndim == 0:
                table[STD] = np.full(table[TIME].shape, table[STD])
            faults = _unequal(table)
        if not faults:
            faults = [fault for name, values in table.items() for fault in _wrong(name, values, missing=True)]
        if faults:
            raise refusal("measurements", None, faults)
        corrected, notes, faults = repaired(table, lambda k: f"index {k}")
        if faults:
            raise refusal("measurements", None, faults)
        one = Series(corrected[TIME], corrected[MIDPOINT], corrected.get(STD), overrides=overrides or {}, notes=notes)
        return cls((one,))


def _adopt(owner: Series | Shapes, names: tuple[str, ...]) -> list[Fault]:
    """Replace the fields of a frozen owner by read-only arrays of their own, and say what is wrong with them."""
    table: dict[str, Floats] = {}
    for name in names:
        if getattr(owner, name) is None:
            continue
        try:
            values = np.array(getattr(owner, name), dtype=np.float64)
        except (TypeError, ValueError):
            return [Fault(name, "not a list of numbers", "numbers in SI units")]
        values.flags.writeable = False
        object.__setattr__(owner, name, values)
        table[name] = values
    faults = _unequal(table)
    if faults:
        return faults
    faults = [fault for name, values in table.items() for fault in _wrong(name, values)]
    time = table["time"]
    if not faults and time.size and time.min() < 0:
        faults = [Fault(f"time[{int(time.argmin())}]", f"{time.min():g} s, before the release", "times from 0 s on")]
    back = np.flatnonzero(np.diff(time) < 0)
    if not faults and back.size:
        k = int(back[0])
        found = f"{time[k + 1]:g} s after {time[k]:g} s"
        faults = [Fault(f"time[{k + 1}]", found, "times in increasing order (Measurements.of sorts)")]
    return faults


def _unequal(table: Mapping[str, Floats]) -> list[Fault]:
    shapes = {values.shape for values in table.values()}
    if len(shapes) == 1 and len(next(iter(shapes))) == 1:
        return []
    found = ", ".join(f"{name} of shape {values.shape}" for name, values in table.items())
    return [Fault("", found, "lists of the same length")]


def _wrong(name: str, values: Floats, missing: bool = False) -> list[Fault]:
    """Numbers that cannot be measurements; with `missing`, NaN stands for one that was not made."""
    faults = []
    positive = name == STD
    for k in np.flatnonzero(~(np.abs(values) <= _MOST) | (positive & ~(values >= _FINEST))).tolist():
        if not (missing and np.isnan(values[k])):
            faults.append(Fault(f"{name}[{k}]", *what_is_wrong(float(values[k]), positive) or ("", "")))
    return faults


def what_is_wrong(value: float, is_std: bool = False) -> tuple[str, str] | None:
    """Say why a number in SI units cannot be a time, a height or, if so asked, a standard error; None if it can.

    Returns
    -------
    (str, str) or None
        What was found, what would be accepted.
    """
    accepted = "a positive number" if is_std else "a finite number"
    if not np.isfinite(value):
        return f"{value} is not finite", accepted
    if is_std and value <= 0:
        return f"{value:g} is not positive", "a positive standard error; leave the column out if it is not known"
    if abs(value) > _MOST or (is_std and value < _FINEST):
        return f"{value:g} is beyond anything measured", f"{accepted}, in the unit that its name says"
    return None


def _is_constant(values: Floats) -> bool:
    return bool(np.ptp(values) <= _ROUNDING * np.max(np.abs(values)))
