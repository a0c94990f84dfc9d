"""The posterior of a fit: sampled by nutpie's NUTS with the derivatives of the model, assessed by ArviZ."""

from __future__ import annotations

import contextvars
import math
import time
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from scipy.linalg import solve_triangular
from scipy.special import expit, log_expit, logit

from softcat_sym import drawing
from softcat_sym.errors import SoftcatError
from softcat_sym.files import replace_atomically
from softcat_sym.fitting.free_parameters import FreeParameter
from softcat_sym.fitting.identifiability import ResidualNoise, is_identified
from softcat_sym.fitting.least_squares import Floats, LeastSquares
from softcat_sym.fitting.priors import Prior, read_priors, refuse_excluded
from softcat_sym.solvers.solution import Progress, Silence

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from softcat_sym.fitting.result import Fit

DRAWS, TUNE, CHAINS = 500, 100, 2
"""Defaults: draws and tuning steps of each chain, and number of chains."""

MAX_R_HAT = 1.01
MIN_ESS = 100
"""Effective draws for each chain (Vehtari et al. 2021, section 4)."""

_PRIOR_DRAWS = 1000
# Maximum depth of a tree: deeper trees gain nothing in whitened unknowns.
_MAX_DEPTH = 6
# Smallest distance of the centre from a bound, as a share of the width between the bounds.
_EDGE = 1e-4
# Difference of q for the curvature of a prior.
_CURVED = 1e-3
_LEVEL = 0.95
_TINY = 1e-300
_POLL = 0.1


class Sampled(LeastSquares, Protocol):
    """A problem of least squares that states whether its noise is known."""

    @property
    def noise_known(self) -> bool:
        """Whether residuals are in known standard deviations; otherwise in units of one unknown deviation."""


class PosteriorOutcome(Enum):
    """Whether a posterior can be used; ``name`` with blanks for underscores goes into ``fit.json``."""

    sampled = "the chains agree, and their draws suffice for 95 % intervals"
    not_mixed = (
        "the chains do not agree: do not use the intervals; ask for more draws and tuning, or give priors to the "
        "parameters that the data do not tell"
    )
    divergent = (
        "some steps ended where the model has no answer, or followed the posterior too coarsely: near there the draws "
        "are too few; give nearer bounds or a prior, or more tuning"
    )
    too_few = "too few independent draws for 95 % intervals: ask for more draws, or for more time"

    @property
    def is_success(self) -> bool:
        """Whether the intervals may be used."""
        return self is PosteriorOutcome.sampled

    @property
    def word(self) -> str:
        """The name with blanks, for files and terminals."""
        return self.name.replace("_", " ")


@dataclass(frozen=True, eq=False)
class Posterior:
    """Draws of the parameters, given the data."""

    # arviz.InferenceData with the groups `posterior` (SI, by names), `sample_stats`, `prior` and `observed_data`
    data: Any
    # For each: mean, sd, median, hdi95 and eti95 (interval of highest density, and between quantiles), ess_bulk,
    # ess_tail, r_hat
    parameters: dict[str, dict[str, Any]]
    priors: tuple[Prior, ...]  # In the order of the parameters
    outcome: PosteriorOutcome  # Whether the posterior can be used
    divergences: int  # Steps that failed after tuning
    draws: int  # Of each chain
    evaluations: int  # Of the model with its derivatives
    seconds: float  # Their duration

    @property
    def message(self) -> str:
        """Diagnostics behind the outcome, in one line."""
        worst = max(one["r_hat"] for one in self.parameters.values())
        least = min(min(one["ess_bulk"], one["ess_tail"]) for one in self.parameters.values())
        return (
            f"{self.data.posterior.sizes['chain']} chains of {self.draws} draws, r-hat up to {worst:.3f}, at least "
            f"{least:.0f} independent draws, {self.divergences} divergences"
        )

    def verdict(self, free: FreeParameter) -> str:
        """Whether the 95 % of the draws between their quantiles identify a parameter, as for an interval of a fit."""
        low, high = (free.scaled(value) for value in self.parameters[free.name]["eti95"])
        return "identified" if is_identified(low, high, logarithmic=free.logarithmic) else "poorly determined"

    def to_netcdf(self, path: str | Path) -> None:
        """Write the draws; ``arviz.from_netcdf`` reads them."""
        replace_atomically(Path(path), self.to_bytes())

    def to_bytes(self) -> bytes:
        """Content of ``posterior.nc``."""
        import xarray as xr

        groups = {f"/{name}": group for name, group in self.data.items()}
        return bytes(xr.DataTree.from_dict(groups).to_netcdf(engine="h5netcdf"))

    def to_dict(self) -> dict[str, Any]:
        """Its entry in ``fit.json``."""
        parameters = {
            one.free.name: {
                **self.parameters[one.free.name],
                "verdict": self.verdict(one.free),
                "unit": one.free.unit,
                "prior": one.text,
            }
            for one in self.priors
        }
        keys = ("message", "divergences", "draws", "evaluations", "seconds")
        outcome = {"outcome": self.outcome.word, "advice": self.outcome.value}
        return outcome | {key: getattr(self, key) for key in keys} | {"parameters": parameters}

    def plot(self, fit: Fit) -> Figure:
        """Draw the densities of all parameters and pairs beside the best fit and its intervals."""
        return drawing.plot(self, fit)


def posterior_of(
    fit: Fit,
    priors: Mapping[str, str] | None = None,
    *,
    draws: int = DRAWS,
    seed: int = 0,
    progress: Progress | None = None,
) -> Posterior:
    """Draw from the posterior of a fit's parameters, with the fit's noise, camera and theory error.

    `priors` has the prior of each parameter, as :func:`softcat_sym.fitting.priors.read_priors` takes them, by default
    those that the fit was given; the other arguments are those of :func:`sample`. A fit without an optimum is refused.
    """
    if not fit.outcome.converged:
        raise SoftcatError(f"a posterior starts at an optimum, but the fit ended as {fit.outcome.word!r}")
    problem, best = fit.problem, fit.starts.best.q
    problem.deadline = math.inf
    read = read_priors(fit.priors if priors is None else priors, problem.free)
    seen, noise = {film.name: film.measured for film in fit.films}, fit.information.spread
    return sample(problem, best, read, draws=draws, seed=seed, noise=noise, observed=seen, progress=progress)


def sample(
    problem: Sampled,
    best: Floats,
    priors: Sequence[Prior],
    *,
    draws: int = DRAWS,
    tune: int = TUNE,
    chains: int = CHAINS,
    seed: int = 0,
    noise: ResidualNoise | None = None,
    observed: Mapping[str, Floats] | None = None,
    progress: Progress | None = None,
) -> Posterior:
    """Draw from the posterior of a problem of least squares, around its best fit.

    The likelihood is Gaussian. Where the noise is not known, its deviation has Jeffreys' prior 1/s and is integrated
    out: the logarithm is then -m/2 log(r.r) of m residuals r. If r is whitened by systematic errors too, it is
    -(f + k)/2 log(f s^2 + r.r - r0.r0), where s and f are the deviation and degrees of freedom of the noise at the best
    fit (`noise`), and r0 its residuals: in the linear case Student's distribution of f degrees of freedom.
    Where residuals are NaN the model has no answer, and there is no density.

    Unknowns are mapped from their bounds to the real line, and whitened by the curvature at the best fit, so that a
    short tuning suffices. Convergence cannot be assessed with a single chain.
    """
    nutpie, arviz = packages()
    if min(draws, tune, chains) < 1:
        raise SoftcatError(f"{draws} draws, {tune} tuning, {chains} chains; accepted: 1 or more of each")
    refuse_excluded(priors, best)
    listener, begin = progress or Silence(), time.perf_counter()
    listener.stage("posterior")
    density = _Density(problem, priors, best, noise)
    data = _drawn(nutpie, density, listener, draws=draws, tune=tune, chains=chains, seed=seed)
    random = np.random.default_rng([seed, chains])
    drawn = {one.free.name: one.draw(random, _PRIOR_DRAWS).tolist() for one in priors}
    before = {one.free.name: np.array([[one.free.value(q) for q in drawn[one.free.name]]]) for one in priors}
    data.extend(arviz.from_dict(prior=before, observed_data=dict(observed) if observed else None))
    for one in priors:
        for group in (data.posterior, data.prior):
            group[one.free.name].attrs["units"] = one.free.unit
        data.prior[one.free.name].attrs["prior"] = one.text
    divergences, parameters = int(data.sample_stats.diverging.sum()), _summary(arviz, data)
    outcome, seconds = _outcome(parameters, divergences, chains), time.perf_counter() - begin
    return Posterior(data, parameters, tuple(priors), outcome, divergences, draws, density.evaluations, seconds)


def packages() -> tuple[Any, Any]:
    """Import nutpie and ArviZ, or say how to install them."""
    try:
        with warnings.catch_warnings():
            # ArviZ announces its next version on import.
            warnings.simplefilter("ignore", FutureWarning)
            import nutpie  # isort: skip
            import arviz
    except ImportError:
        raise SoftcatError(
            "a posterior needs nutpie and ArviZ, which are not installed: pip install 'softcat_sym[bayes]'"
        ) from None
    return nutpie, arviz


class _Density:
    """The logarithm of the posterior density in whitened unknowns z, which are unbounded.

    With y = logit((q - lower)/(upper - lower)): y = centre + spread z.
    """

    def __init__(
        self, problem: Sampled, priors: Sequence[Prior], best: Floats, noise: ResidualNoise | None = None
    ) -> None:
        self._problem, self.priors, self.evaluations = problem, priors, 0
        self._lower = np.array([one.lower for one in priors])
        self._width = np.array([one.upper for one in priors]) - self._lower
        residuals, _ = self._linearised(best)
        # Added to r.r, and the number of readings that count, where the noise is integrated out.
        self._added, self._count = 0.0, residuals.size
        if noise is not None and noise.freedom is not None:
            self._added = noise.freedom * noise.deviation**2 - float(residuals @ residuals)
            self._count = noise.freedom + best.size
        self._whiten(best)

    def q(self, z: Floats) -> Floats:
        """The unknowns of the problem."""
        return np.asarray(self._lower + self._width * expit(self._centre + self._spread @ z))

    def __call__(self, z: Floats) -> tuple[float, Floats]:
        """Logarithm and gradient; minus infinity where the model has no answer."""
        y = self._centre + self._spread @ z
        share = expit(y)
        q = self._lower + self._width * share
        residuals, jacobian = self._linearised(q)
        pairs = [(one.log_density(float(x)), one.slope(float(x))) for one, x in zip(self.priors, q, strict=True)]
        before, slopes = np.array(pairs).T
        squares, weight = float(residuals @ residuals), 1.0
        fit = -0.5 * squares
        if not self._problem.noise_known:
            squares = max(squares + self._added, _TINY)
            fit, weight = -0.5 * self._count * math.log(squares), self._count / squares
        # Logarithm of the Jacobian of the map from y to q.
        stretch = log_expit(y) + log_expit(-y)
        value = fit + float(before.sum() + stretch.sum())
        by_q = slopes - weight * (jacobian.T @ residuals)
        gradient = self._spread.T @ (self._width * share * (1 - share) * by_q + 1 - 2 * share)
        if not (math.isfinite(value) and np.isfinite(gradient).all()):
            return -math.inf, np.zeros_like(z)
        return value, gradient

    def _linearised(self, q: Floats) -> tuple[Floats, Floats]:
        self.evaluations += 1
        return self._problem.linearised(q)

    def _whiten(self, q: Floats) -> None:
        """Scale the unknowns to unit curvature near the best fit."""
        share = np.clip((q - self._lower) / self._width, _EDGE, 1 - _EDGE)
        q = self._lower + self._width * share
        stretch = self._width * share * (1 - share)
        residuals, jacobian = self._linearised(q)
        if not (np.isfinite(residuals).all() and np.isfinite(jacobian).all()):
            raise SoftcatError("the model has no answer at the best fit: its posterior cannot be drawn")
        squares = float(residuals @ residuals) + self._added
        variance = 1.0 if self._problem.noise_known else max(squares, _TINY) / self._count
        scaled = jacobian * stretch / math.sqrt(variance)
        curvature = []
        for one, x in zip(self.priors, q.tolist(), strict=True):
            low, high = max(x - _CURVED, one.lower), min(x + _CURVED, one.upper)
            curvature.append(max((one.slope(low) - one.slope(high)) / (high - low), 0.0))
        precision = scaled.T @ scaled + np.diag(stretch**2 * np.array(curvature) + 2 * share * (1 - share))
        lower = np.linalg.cholesky(precision)
        self._centre = logit(share)
        self._spread = solve_triangular(lower, np.eye(q.size), lower=True, trans="T")


def _drawn(nutpie: Any, density: _Density, progress: Progress, *, draws: int, tune: int, chains: int, seed: int) -> Any:
    """Draw the chains, one after another: ArviZ's data."""
    free, failure, done = [one.free for one in density.priors], list[BaseException](), 0
    total, random = chains * (tune + draws), np.random.default_rng(seed)
    # The context variables of the store are those of the calling thread.
    context = contextvars.copy_context()

    def logarithm(z: Floats) -> tuple[float, Floats]:
        try:
            return context.run(density, z) if not failure else (-math.inf, np.zeros_like(z))
        except SoftcatError:
            return -math.inf, np.zeros_like(z)
        except BaseException as error:  # noqa: BLE001 - raised again where the chains are waited for
            failure.append(error)
            return -math.inf, np.zeros_like(z)

    def expanded(z: Floats) -> dict[str, Floats]:
        nonlocal done
        done += 1
        return {one.name: np.array(one.value(float(x))) for one, x in zip(free, density.q(z), strict=True)}

    model = nutpie.compiled_pyfunc.from_pyfunc(
        len(free),
        lambda: logarithm,
        lambda *_: expanded,
        [np.dtype(float)] * len(free),
        [()] * len(free),
        [one.name for one in free],
        make_initial_point_fn=lambda _: random.standard_normal(len(free)),
    )
    settings = {"draws": draws, "tune": tune, "chains": chains, "cores": 1, "maxdepth": _MAX_DEPTH}
    run = nutpie.sample(model, seed=seed, save_warmup=False, progress_bar=False, blocking=False, **settings)
    try:
        while True:
            try:
                return run.wait(timeout=_POLL)
            except TimeoutError:
                progress.reach(min(done / total, 1.0), f"{done} of {total} draws")
                if failure:
                    raise failure[0] from None
            except RuntimeError as error:
                # Rust appends a stack trace.
                reason = str(error).partition("\n")[0]
                raise SoftcatError(f"no chain could start near the best fit: {reason}") from None
    finally:
        run.cancel()


def _summary(arviz: Any, data: Any) -> dict[str, dict[str, Any]]:
    """Statistics of the draws by parameter name."""
    table = arviz.summary(data, hdi_prob=_LEVEL, round_to="none")
    found = {}
    for name in data.posterior.data_vars:
        values, row = data.posterior[name].values.ravel(), table.loc[name]
        low, middle, high = np.quantile(values, [0.5 - _LEVEL / 2, 0.5, 0.5 + _LEVEL / 2]).tolist()
        found[str(name)] = {
            **{key: float(row[key]) for key in ("mean", "sd")},
            "median": middle,
            "hdi95": [float(row["hdi_2.5%"]), float(row["hdi_97.5%"])],
            "eti95": [low, high],
            **{key: float(row[key]) for key in ("ess_bulk", "ess_tail", "r_hat")},
        }
    return found


def _outcome(parameters: Mapping[str, Mapping[str, Any]], divergences: int, chains: int) -> PosteriorOutcome:
    # The comparison is false for NaN, which a single chain gives.
    if not all(one["r_hat"] <= MAX_R_HAT for one in parameters.values()):
        return PosteriorOutcome.not_mixed
    if divergences:
        return PosteriorOutcome.divergent
    enough = all(min(one["ess_bulk"], one["ess_tail"]) >= MIN_ESS * chains for one in parameters.values())
    return PosteriorOutcome.sampled if enough else PosteriorOutcome.too_few
