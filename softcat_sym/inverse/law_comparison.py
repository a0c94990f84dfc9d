"""Several laws fitted to the same films, and what their comparison says."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.inverse.estimation.least_squares import Loss
from softcat_sym.inverse.estimation.model_choice import FittedLaw, ModelChoice, choose_model
from softcat_sym.inverse.fitted import Fit
from softcat_sym.inverse.scene_of_law import constants_of

# Of a normal distribution, over the median of magnitudes; the floor is for data that are met exactly.
_MEDIAN_TO_DEVIATION, _LEAST_NOISE = 1.4826, 1e-9


@dataclass(frozen=True, eq=False)
class LawComparison:
    """Several laws beside the same films.

    Attributes
    ----------
    fits : dict of str to Fit
        Of the laws that could be fitted.
    failures : dict of str to str
        Why others could not.
    choice : ModelChoice
        Their ranking; its verdict is a law, or ``"cannot tell"``.
    restarted : dict of str to str
        Wider laws whose own starts ended worse than a law that they contain, which is named, and that were therefore
        started from its optimum.
    """

    fits: dict[str, Fit]
    failures: dict[str, str]
    choice: ModelChoice
    restarted: dict[str, str] = field(default_factory=dict)

    @property
    def best(self) -> Fit:
        """The fit of the law that ranks first, even where the verdict is ``"cannot tell"``."""
        return self.fits[self.choice.table[0].law.name]

    @property
    def sentence(self) -> str:
        """The verdict in words."""
        name = self.choice.table[0].law.name
        if self.choice.verdict != "cannot tell":
            doubt = ", though its residuals are not white" if self.fits[name].checks.verdict == "not white" else ""
            if not self.fits[name].outcome.converged:
                doubt += ", though its fit did not reach its optimum"
            alone = "only {} could be fitted" if len(self.fits) == 1 else "the films speak for {}"
            said = alone.format(name) + doubt
        elif any(math.isinf(row.aicc) for row in self.choice.table if not row.law.failure):
            said = f"cannot tell: too few readings to weigh {', '.join(self.choice.close)} against each other"
        else:
            said = f"cannot tell: {', '.join(self.choice.close)} fit about equally well"
        return said + (f"; no fit of {', '.join(self.failures)}" if self.failures else "")


def compared(
    laws: Sequence[str], fits: Mapping[str, Fit], failures: Mapping[str, str], loss: Loss, besides: int
) -> LawComparison:
    """Rank fits of the same films.

    Parameters
    ----------
    laws : sequence of str
        In the order asked.
    fits, failures : mapping
        By law; every law has one or the other.
    loss : Loss
        That was asked for.
    besides : int
        How many parameters are free besides every law's constants.

    Raises
    ------
    SoftcatError
        If there is no fit.
    """
    if not fits:
        raise SoftcatError("none of the laws can be fitted:\n" + "\n".join(f"  {k}: {v}" for k, v in failures.items()))
    best = _ranked(laws, fits, failures, loss, besides).table[0].law.name
    # An optimum that was not reached would lie lower still: of the best law that is no objection.
    unreached = {law: one.outcome.value for law, one in fits.items() if not one.outcome.converged and law != best}
    fits = {law: one for law, one in fits.items() if law not in unreached}
    failed = {**failures, **unreached}
    return LawComparison(fits, failed, _ranked(laws, fits, failed, loss, besides))


def _ranked(
    laws: Sequence[str], fits: Mapping[str, Fit], failures: Mapping[str, str], loss: Loss, besides: int
) -> ModelChoice:
    one, charged = next(iter(fits.values())), common_loss(loss, fits)
    rows = [
        FittedLaw(law, len(fits[law].problem.names), 2 * charged.value(fits[law].starts.best.residuals))
        if law in fits
        else FittedLaw(law, len(constants_of(law)) + besides, 0.0, failures[law])
        for law in laws
    ]
    return choose_model(rows, one.starts.best.residuals.size, noise_known=one.noise_known)


def common_loss(loss: Loss, fits: Mapping[str, Fit]) -> Loss:
    """One loss for all laws: a robust one has each fit's own estimate of the noise for its scale; the least is used."""
    if loss.kind == "linear" or next(iter(fits.values())).noise_known:
        return loss
    medians = [float(np.median(np.abs(one.starts.best.residuals))) for one in fits.values()]
    return Loss(loss.kind, loss.scale * max(_MEDIAN_TO_DEVIATION * min(medians), _LEAST_NOISE))
