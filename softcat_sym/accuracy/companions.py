"""Runs beside the answer that tell how far it may be off: a coarser grid, other steps, another number of fibres.

Other steps and other fibres are tried on the coarser grid, where they cost half: what they change there, they change
on the finer one too, to the accuracy that an estimate needs. What has been found out at another resolution, and has not
been refined since, is not asked again.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from softcat_sym.accuracy.deviation import Deviation, Judge
from softcat_sym.accuracy.resolution import Resolution
from softcat_sym.graph.grid import Floats

Runner = Callable[[Resolution], Floats | None]
"""Midpoint over the run at a resolution, shape (frames,); None where that run has no answer."""

ORDER = 2
"""Of the grid: differences and averages are central."""

LOOSER = 8.0
"""Factor of the tolerance; the error of the time steps grows by five to twenty times with it, so about as much."""

TIGHTER = 1 / 3
"""Factor of the tolerance, of a filament that rings on. Looser steps tell nothing there: they lose all that there is of
the higher modes, as the judged ones may have done. Of six strands that ring for 300 to 600 periods the error is 0.9 to
1.5 times what is found so; an eightfold tolerance misses it by factors of 0.7 to 10, whatever order is supposed."""

RINGING_ORDER = 2
"""Power of the tolerance by which that is extrapolated."""

MORE = 1.5
"""Factor of the fibres: fewer than half as many again may be as wrong in the same direction."""

FIBRES = (8, 12, 16, 24, 32, 48, 64, 96)
"""Numbers of fibres that are tried."""

SECTION_ORDER = 2
"""Of the fibres: where a section yields from its surface inwards, the edge lies between two of them."""

SMALL = 0.2
"""Share of the accuracy below which an error of the time steps is not looked at again when they have become shorter."""

_FEWEST_CELLS = 4


@dataclass(frozen=True)
class Differences:
    """Estimated errors of one run, as in :class:`softcat_sym.accuracy.ErrorEstimate`, and what could not be had.

    Attributes
    ----------
    space, time, section : float or None
        Relative to the largest midpoint.
    phase : float or None
        Periods by which a ringing may be ahead or late at its end.
    failed : tuple of str
        Companions that have no answer.
    """

    space: float | None
    time: float | None
    section: float | None
    phase: float | None
    failed: tuple[str, ...]

    @property
    def total(self) -> float:
        """Of all that is known."""
        return sum(part for part in (self.space, self.time, self.section) if part is not None)


@dataclass(frozen=True)
class Before:
    """Errors found at an earlier resolution of the same scene."""

    at: Resolution
    found: Differences


def differences(
    answer: Floats, at: Resolution, run: Runner, judge: Judge, accuracy: float, before: Before | None = None
) -> Differences:
    """Estimate the errors of an answer from its companions.

    Parameters
    ----------
    answer : ndarray, shape (frames,)
        Midpoint at the resolution `at`.
    at : Resolution
        Of the answer.
    run : Runner
        Runs a companion.
    judge : Judge
        Compares them.
    accuracy : float
        Asked.
    before : Before
        What is known already.
    """
    coarser = replace(at, cells=max(_FEWEST_CELLS, at.cells // 2))
    beside = run(coarser)
    if beside is None or not np.any(answer) or coarser.cells == at.cells:
        return Differences(None, None, None, None, (f"{coarser.cells} cells",))
    failed: list[str] = []

    def change(resolution: Resolution, called: str, share: float) -> Deviation | None:
        found = run(resolution)
        if found is None:
            failed.append(called)
            return None
        deviation = judge.between(found, beside)
        return Deviation(deviation.size / abs(share), None if deviation.phase is None else deviation.phase / abs(share))

    apart = judge.between(answer, beside)
    space = 1 / ((at.cells / coarser.cells) ** ORDER - 1)
    parts = [Deviation(apart.size * space, None if apart.phase is None else apart.phase * space)]
    time = _time_known(at, before, accuracy)
    if time is None:
        factor, order = (TIGHTER, RINGING_ORDER) if judge.windows else (LOOSER, 1)
        stepped = replace(coarser, rtol=min(factor * at.rtol, 0.5))
        late = change(stepped, f"a tolerance of {stepped.rtol:.2g}", (stepped.rtol / at.rtol) ** order - 1)
        time = None if late is None else late.size
        parts += [late] if late is not None else []
    section = _section_known(at, before)
    if section is None and (other := _other_fibres(coarser, before)) != coarser:
        ratio = (other.fibres or 1) / (coarser.fibres or 1) if other.order is None else MORE
        across = change(other, f"{other.fibres or other.order} fibres", 1 - ratio**-SECTION_ORDER)
        section = None if across is None else across.size
    phases = [part.phase for part in parts if part.phase is not None]
    return Differences(parts[0].size, time, section, sum(phases) if phases else None, tuple(failed))


def _time_known(at: Resolution, before: Before | None, accuracy: float) -> float | None:
    """Error of the time steps by an earlier one, where it was small; it falls at least as fast as the tolerance."""
    if before is None or before.found.time is None or before.found.time > SMALL * accuracy:
        return None
    return before.found.time * at.rtol / before.at.rtol


def _section_known(at: Resolution, before: Before | None) -> float | None:
    """Error of the same fibres on another grid."""
    same = before is not None and (before.at.fibres, before.at.order) == (at.fibres, at.order)
    return before.found.section if before is not None and same else None


def _other_fibres(coarser: Resolution, before: Before | None) -> Resolution:
    """More fibres; or else fewer, those of an earlier answer: their library is there, and runs fast."""
    if before is not None and before.at.fibres is not None and coarser.order is None:
        return replace(coarser, fibres=before.at.fibres)
    return with_more_fibres(coarser, MORE)


def with_more_fibres(resolution: Resolution, factor: float) -> Resolution:
    """More fibres by about a factor, or a higher order; the same where the section has neither.

    Fibres come in few numbers, so that scenes share what is compiled for them.
    """
    if resolution.order is not None:
        return replace(resolution, order=max(resolution.order + 1, round(factor * resolution.order)))
    if resolution.fibres is not None:
        wanted = factor * resolution.fibres
        return replace(resolution, fibres=next((n for n in FIBRES if n >= wanted), 2 * round(wanted / 2)))
    return resolution
