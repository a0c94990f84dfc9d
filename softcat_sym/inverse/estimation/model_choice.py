"""Several laws fitted to the same data, ranked by information criteria."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from softcat_sym.errors import SoftcatError

CLOSE = 2.0
"""Difference of AICc below which two laws are not told apart (Burnham and Anderson 2002, section 2.6)."""

# Mean squares below this share of the data's are rounding, and choose no law.
_ROUNDING = 1e-18


@dataclass(frozen=True)
class FittedLaw:
    """What the comparison needs of a fit.

    Attributes
    ----------
    name : str
        The law.
    unknowns : int
        How many were fitted.
    squares : float
        Sum of the squared residuals; chi^2 where the noise is known.
    failure : str
        Why there is no fit; empty if there is one.
    """

    name: str
    unknowns: int
    squares: float
    failure: str = ""


@dataclass(frozen=True)
class Ranked:
    """A law in the table.

    Attributes
    ----------
    law : FittedLaw
        The fit.
    aic, aicc, bic : float
        Akaike's criterion (1974), corrected for few data (Hurvich and Tsai 1989; infinite with too few for it), and
        Schwarz' (1978); without their common constant. All infinite for a fit that failed.
    difference : float
        Of the criterion that ranks, less its least value; infinite for a fit that failed.
    weight : float
        exp(-difference/2), normalised: Akaike weight.
    """

    law: FittedLaw
    aic: float
    aicc: float
    bic: float
    difference: float
    weight: float


@dataclass(frozen=True)
class ModelChoice:
    """The table, the best law first, those that failed last.

    Attributes
    ----------
    table : tuple of Ranked
        All laws.
    close : tuple of str
        Laws within `CLOSE` of the best, the best among them.
    verdict : str
        The name of the best law, or ``"cannot tell"`` if it is not alone.
    criterion : str
        What ranks: ``"AICc"``, or ``"BIC"`` where a law has too many constants for that.
    reason : str
        Why it cannot be told; empty if it can.
    """

    table: tuple[Ranked, ...]
    close: tuple[str, ...]
    verdict: str
    criterion: Literal["AICc", "BIC"] = "AICc"
    reason: str = ""


def choose_model(laws: Sequence[FittedLaw], points: int, *, noise_known: bool) -> ModelChoice:
    """Rank laws that were fitted to the same data.

    With known noise AIC = chi^2 + 2 k; with estimated noise AIC = m ln(RSS/m) + 2 (k + 1), the variance being one more
    constant. AICc adds 2 K (K + 1)/(m - K - 1) with K constants, BIC has K ln m in place of 2 K.

    AICc is infinite with m <= K + 1, which says nothing of the law: where that happens, BIC ranks all laws, and the
    verdict is ``"cannot tell"``.

    Parameters
    ----------
    laws : sequence of FittedLaw
        At least one.
    points : int
        m, how many data.
    noise_known : bool
        Whether the residuals are in standard errors that were measured.

    Raises
    ------
    SoftcatError
        If there is no law.
    """
    if not laws:
        raise SoftcatError("no law is given to choose from; accepted: one or more fitted laws")
    rows = [(law, *_criteria(law, points, noise_known=noise_known)) for law in laws]
    crowded = [law.name for law, _, aicc, _ in rows if not law.failure and math.isinf(aicc)]
    ranked = [(bic if crowded else aicc, law, aic, aicc, bic) for law, aic, aicc, bic in rows]
    ranked.sort(key=lambda row: (bool(row[1].failure), row[0], row[1].unknowns))
    least = ranked[0][0]
    differences = [math.inf if math.isinf(row[0]) else row[0] - least for row in ranked]
    weights = [math.exp(-0.5 * difference) for difference in differences]
    total = sum(weights)
    table = tuple(
        Ranked(law, aic, aicc, bic, difference, weight / total if total > 0 else 0.0)
        for (_, law, aic, aicc, bic), difference, weight in zip(ranked, differences, weights, strict=True)
    )
    fitted = tuple(row.law.name for row in table if not row.law.failure)
    close = fitted if crowded else tuple(row.law.name for row in table if row.difference < CLOSE)
    reason = _undecided(fitted, close, crowded, points)
    return ModelChoice(table, close, "cannot tell" if reason else close[0], "BIC" if crowded else "AICc", reason)


def _undecided(fitted: Sequence[str], close: Sequence[str], crowded: Sequence[str], points: int) -> str:
    """Why no law is alone; empty if one is."""
    if not fitted:
        return "no law could be fitted"
    if crowded:
        return f"{points} data are too few to weigh {', '.join(crowded)} by AICc; the order is that of BIC"
    return f"{', '.join(close)} fit about equally well" if len(close) > 1 else ""


def _criteria(law: FittedLaw, points: int, *, noise_known: bool) -> tuple[float, float, float]:
    if law.failure:
        return math.inf, math.inf, math.inf
    constants = law.unknowns + (not noise_known)
    misfit = law.squares if noise_known else points * math.log(max(law.squares / points, _ROUNDING))
    aic = misfit + 2 * constants
    spare = points - constants - 1
    aicc = aic + 2 * constants * (constants + 1) / spare if spare > 0 else math.inf
    return aic, aicc, misfit + constants * math.log(points)
