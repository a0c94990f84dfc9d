"""A flow curve: steady shear stress against shear rate, as a rotational rheometer measures it."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault, SoftcatError
from softcat_sym.inverse.csv_text import cells_of, counted, data_lines, number_in, refusal, text_of
from softcat_sym.scene.faults import did_you_mean
from softcat_sym.scene.units import shown

Floats = NDArray[np.float64]

RATE, STRESS = "shear_rate_1_s", "shear_stress_Pa"
"""Names of the two columns that are read."""

FEWEST = 4
"""Distinct rates that are needed: one more than Herschel-Bulkley has constants."""

# No rheometer measures beyond these, in 1/s or Pa: whoever writes such a number has another unit in mind.
_LEAST, _MOST = 1e-12, 1e12
_NAMES_SHOWN = 8


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

    Raises
    ------
    SoftcatError
        If the two are not lists of the same length, hold a number that is not positive and finite, or fewer than
        `FEWEST` distinct rates.
    """

    shear_rate: Floats
    shear_stress: Floats
    path: Path | None = None

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
        found = []
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
        Comma-separated UTF-8 text with a header that names ``shear_rate_1_s`` and ``shear_stress_Pa``; other columns
        are not read, nor are empty lines and lines that start with ``#``.

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
    kept = data_lines(text_of(file, "flow curve", f"a CSV file with the columns {RATE} and {STRESS}"))
    if not kept:
        raise _refusal(file, [Fault("", "the file holds no data", f"a header with {RATE} and {STRESS}, then rows")])
    rows = [(number, cells_of(line)) for number, line in kept]
    (header_line, header), body = rows[0], rows[1:]
    places = _places(header, header_line, file)
    faults: list[Fault] = []
    points = []
    for number, cells in body:
        values = []
        for name, place in places.items():
            text = cells[place] if place < len(cells) else ""
            value, wrong = _number(text)
            faults += [Fault(f"line {number}, {name}", *wrong)] if wrong else []
            values.append(value)
        points.append(values)
    if faults:
        raise _refusal(file, faults)
    rate, stress = np.array(points, dtype=np.float64).reshape(-1, 2).T
    return FlowCurve(rate, stress, file)


def _places(header: list[str], line: int, file: Path) -> dict[str, int]:
    """Where the two columns stand."""
    faults = []
    for name in (RATE, STRESS):
        count = header.count(name)
        if count > 1:
            faults.append(Fault(f"line {line}", f"{count} columns are called {name}", "one"))
        elif not count:
            others = [other for other in header if other not in (RATE, STRESS)]
            near = did_you_mean(name, others).replace("did you mean", "is it what is called")
            found = ", ".join(shown(other) for other in header[:_NAMES_SHOWN])
            # A spreadsheet set to a language with decimal commas separates by semicolons.
            hint = "; the cells must be separated by commas" if len(header) == 1 else ""
            faults.append(Fault(f"line {line}", f"no column {name} among {found}{near}", f"that very name{hint}"))
    if faults:
        raise _refusal(file, faults)
    return {name: header.index(name) for name in (RATE, STRESS)}


def _number(text: str) -> tuple[float, tuple[str, str] | None]:
    """The number in a cell, or what is wrong with it."""
    accepted = "a positive number, such as 0.5"
    if not text:
        return math.nan, ("empty", accepted)
    value = number_in(text)
    if value is None:
        return math.nan, (f"{shown(text)} is not a number", accepted)
    return value, _wrong(value)


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
