"""How a fit ended; the value of each member is the advice."""

from enum import Enum


class FitOutcome(Enum):
    """End of a fit; ``name`` with blanks for underscores goes into ``fit.json``."""

    solved = "the model fits within its noise; every free parameter is identified"
    not_identified = (
        "the model fits, but the data do not tell every parameter: read the verdicts and the combinations, fix what is "
        "known otherwise, or film what softcat's experiment design proposes"
    )
    at_a_bound = "the best fit lies on a bound that the data push against: widen the bound, or doubt the law"
    model_error = (
        "the residuals are not white noise: the model misses something that the data show, so that the intervals, "
        "which know of noise only, are too narrow; try another law, more effects, or free time_offset and initial_sag"
    )
    localised = (
        "in the filament that fits best strain gathers in one cell, and the midpoint that was fitted changes with the "
        "grid: do not use the numbers; take the effect necking-gradient in, or film a shorter or thicker filament"
    )
    run_in_doubt = (
        "a run of the filament that fits best is not to be trusted: do not use the numbers before `softcat run` of the "
        "fitted scene ends as solved; its advice says what to change"
    )
    not_converged = (
        "IPOPT did not reach an optimum: do not use the numbers; give nearer starting values in the scene, or bounds"
    )

    @property
    def converged(self) -> bool:
        """Whether an optimum was found."""
        return self is not FitOutcome.not_converged

    @property
    def word(self) -> str:
        """As files and terminals say it."""
        return self.name.replace("_", " ")
