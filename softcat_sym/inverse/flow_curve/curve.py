"""A flow curve: steady shear stress against shear rate, as a rotational rheometer measures it."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.inverse.csv_columns import (
    Column,
    CsvTable,
    absent,
    header_pattern,
    missing_rows,
    named,
    numbers_in,
    table_in,
    unit_of,
)
from softcat_sym.inverse.csv_text import counted, refusal, text_of
from softcat_sym.scene.units import NotAQuantity, shown

Floats = NDArray[np.float64]

RATE, STRESS = "shear_rate_1_s", "shear_stress_Pa"
"""Names of the two columns that are read, with their SI units."""

# Name without its unit: the quantity, its dimension, its SI unit, and what is accepted.
_KNOWN = {
    "shear_rate": (RATE, "shear rate", "1/s", f"{RATE}, or shear rate [1/s]"),
    "shear_stress": (STRESS, "stress", "Pa", f"{STRESS}, shear_stress_kPa, or shear stress [Pa]"),
}
_NAME = header_pattern(_KNOWN)

FEWEST = 4
"""Distinct rates that are needed: one more than Herschel-Bulkley has constants."""

# No rheometer measures beyond these, in 1/s or Pa: whoever writes such a number has another unit in mind.
_LEAST, _MOST = 1e-12, 1e12


@dataclass(frozen=True, eq=False)
class FlowCurve:
    """Steady shear stresses at imposed shear rates, in any order; a rate may be repeated.

    Attributes
    ----------
    shear_rate : ndarray, shape (points,)
        [1/s], positive; kept as a copy that cannot be written to.
    shear_stress : ndarray, shape (points,)
        [Pa], positive; likewise.
    path : pathlib.Path or None
        The file they come from.
    notes : tuple of str
        What was corrected while it was read, a sentence each.

    Raises
    ------
    SoftcatError
        If the two are not lists of the same length, hold a number that is not positive and finite, or fewer than
        `FEWEST` distinct rates.
    """

    shear_rate: Floats
    shear_stress: Floats
    path: Path | None = None
    notes: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        faults = []
        for name, column in (("shear_rate", RATE), ("shear_stress", STRESS)):
            try:
                values = np.array(getattr(self, name), dtype=np.float64)
            except (TypeError, ValueError):
                raise _refusal(self.path, [Fault(name, "not a list of numbers", f"numbers, as in {column}")]) from None
            values.flags.writeable = False
            object.__setattr__(self, name, values)
            found = (_wrong(value) for value in values.flat)
            faults += [Fault(f"{name}[{k}]", *wrong) for k, wrong in enumerate(found) if wrong]
        rate, stress = self.shear_rate, self.shear_stress
        if rate.ndim != 1 or rate.shape != stress.shape:
            found_shapes = f"rates of shape {rate.shape}, stresses of shape {stress.shape}"
            raise _refusal(self.path, [Fault("", found_shapes, "two lists of the same length")])
        # Rates that agree to six digits are one rate, set twice.
        distinct = len({f"{value:.6g}" for value in rate})
        if not faults and distinct < FEWEST:
            accepted = f"at least {FEWEST}: Herschel-Bulkley alone has three constants"
            faults = [Fault("", f"{counted(distinct, 'distinct shear rate')}", accepted)]
        if faults:
            raise _refusal(self.path, faults)

    @property
    def decades(self) -> float:
        """Range of the shear rates, log10 of largest over smallest."""
        return float(np.log10(self.shear_rate.max() / self.shear_rate.min()))

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a reader must know about the data themselves."""
        found = list(self.notes)
        if self.decades < 1:
            found.append(
                f"the shear rates span a factor of {10**self.decades:.3g}, less than a decade: "
                "a yield stress is an extrapolation and hardly determined"
            )
        log_rate = np.log(self.shear_rate)
        if np.sum((log_rate - log_rate.mean()) * np.log(self.shear_stress)) < 0:
            found.append(
                "the flow curve falls: stress decreases with shear rate overall, as with thixotropy, wall slip or "
                "shear banding; no law of steady flow describes that"
            )
        return tuple(found)


def read_flow_curve(path: str | os.PathLike[str]) -> FlowCurve:
    """Read a flow curve from a CSV file.

    Parameters
    ----------
    path : str or path
        UTF-8 text with a header that names ``shear_rate_1_s`` and ``shear_stress_Pa``, in any unit
        (``shear_stress_kPa``, ``Shear rate [1/s]``); other columns are not read, nor are empty lines and lines that
        start with ``#``. Cells are separated by commas, or by semicolons or tabs, then with decimal points or commas;
        rows without a number are left out, up to a third of them.

    Returns
    -------
    FlowCurve
        The points, in the order of the file.

    Raises
    ------
    SoftcatError
        With every fault and its line.
    """
    file = Path(path)
    cells = table_in(text_of(file, "flow curve", f"a CSV file with the columns {RATE} and {STRESS}"))
    if cells is None:
        raise _refusal(file, [Fault("", "the file holds no data", f"a header with {RATE} and {STRESS}, then rows")])
    table, faults = numbers_in(cells, _columns(cells, file), lambda _, value: _wrong(value))
    if faults:
        raise _refusal(file, faults)
    missing, said, fault = missing_rows(table, lambda k: f"line {cells.rows[k][0]}")
    if fault:
        raise _refusal(file, [fault])
    return FlowCurve(table[RATE][~missing], table[STRESS][~missing], file, (said,) if said else ())


def _columns(table: CsvTable, file: Path) -> dict[str, Column]:
    """Where the two columns stand, and in which units."""
    where = f"line {table.line}"
    columns: dict[str, list[Column]] = {RATE: [], STRESS: []}
    faults: list[Fault] = []
    faulty = set()
    for place, name in enumerate(table.header):
        match = _NAME.fullmatch(name.strip())
        if match is None:
            continue
        known, unit, _ = named(match)
        quantity, dimension, si, accepted = _KNOWN[known]
        try:
            columns[quantity].append(Column(name, place, unit_of(unit, dimension, si)))
        except NotAQuantity as found:
            faults.append(Fault(where, f"column {shown(name)}: {found}", accepted))
            faulty.add(quantity)
    for quantity, _, _, accepted in _KNOWN.values():
        several = columns[quantity]
        if not several and quantity not in faulty:
            faults.append(absent(f"column {quantity}", quantity, accepted, table, _NAME))
        elif len(several) > 1:
            names = ", ".join(column.name for column in several)
            faults.append(Fault(where, f"{len(several)} columns for one quantity: {names}", "one of them"))
    if faults:
        raise _refusal(file, faults)
    return {quantity: several[0] for quantity, several in columns.items()}


def _wrong(value: float) -> tuple[str, str] | None:
    if not math.isfinite(value):
        return f"{value} is not finite", "a positive number"
    if value <= 0:
        return f"{value:g} is not positive", "a positive number: magnitudes, the fit is of relative residuals"
    if not _LEAST <= value <= _MOST:
        return f"{value:g} is beyond what a rheometer measures", f"a number from {_LEAST:g} to {_MOST:g}"
    return None


def _refusal(path: Path | None, faults: list[Fault]) -> SoftcatError:
    return refusal("flow curve", path, faults)
