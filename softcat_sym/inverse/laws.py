"""Which law: several fitted to the same films, and ranked."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.inverse.contained_laws import contained_in, widened
from softcat_sym.inverse.defaults import STARTS
from softcat_sym.inverse.estimation.least_squares import LINEAR, Loss
from softcat_sym.inverse.filament_fit import FitProgress, NoProgress, fit
from softcat_sym.inverse.fitted import Fit
from softcat_sym.inverse.law_comparison import LawComparison, common_loss, compared
from softcat_sym.inverse.measurements.films import Films
from softcat_sym.inverse.measurements.plausibility import checked
from softcat_sym.inverse.measurements.reading import read_measurements
from softcat_sym.inverse.measurements.series import Measurements
from softcat_sym.inverse.scene_of_law import FITTED, constants_of, scene_of_law
from softcat_sym.scene import Scene
from softcat_sym.scene.faults import did_you_mean

__all__ = ["FITTED", "LawComparison", "fit_law", "fit_laws", "scene_of_law"]

# By which a wider law's sum of squares may exceed that of one it contains: the limit is never quite reached.
_NO_WORSE = 1e-6

Bounds = Mapping[str, tuple[object, object]]


@dataclass(frozen=True)
class _Asked:
    """How every law is to be fitted."""

    films: Measurements
    also_free: tuple[str, ...]
    bounds: Bounds
    loss: Loss
    starts: int
    backend: str
    rtol: float | None
    seed: int

    def fitted(self, scene: Scene, starts: int, *, profiles: bool = False, progress: FitProgress | None = None) -> Fit:
        """Fit all constants of the scene's own law."""
        law = scene.material.law
        names = [*constants_of(law), *self.also_free]
        leaves = {name.rpartition(".")[2] for name in names}
        return fit(
            # As they were read: a fit notes its own corrections.
            self.films,
            scene,
            names,
            bounds={name: pair for name, pair in self.bounds.items() if name.rpartition(".")[2] in leaves},
            loss=self.loss,
            starts=starts,
            profiles=profiles,
            backend=self.backend,
            rtol=self.rtol,
            seed=self.seed,
            progress=progress,
        )


def fit_law(
    measurements: Films,
    scene: Scene,
    law: str,
    *,
    also_free: Sequence[str] = (),
    bounds: Bounds | None = None,
    loss: Loss = LINEAR,
    starts: int = STARTS,
    profiles: bool = True,
    seed: int = 0,
    progress: FitProgress | None = None,
) -> Fit:
    """Fit every constant of one law, whatever the scene's; the arguments are those of :func:`fit_laws`.

    Raises
    ------
    SoftcatError
        If the law is unknown, or as :func:`softcat_sym.inverse.fit` does.
    """
    _refuse([law], also_free, bounds or {}, fewest=1)
    read = measurements if isinstance(measurements, Measurements) else read_measurements(measurements)
    asked = _Asked(read, tuple(also_free), bounds or {}, loss, starts, "auto", None, seed)
    return asked.fitted(scene_of_law(scene, law, checked(read, scene)), starts, profiles=profiles, progress=progress)


def fit_laws(
    measurements: Films,
    scene: Scene,
    laws: Sequence[str],
    *,
    also_free: Sequence[str] = (),
    bounds: Bounds | None = None,
    loss: Loss = LINEAR,
    starts: int = STARTS,
    profiles: bool = False,
    backend: str = "auto",
    rtol: float | None = None,
    seed: int = 0,
    progress: FitProgress | None = None,
) -> LawComparison:
    """Fit every constant of several laws, and compare them by AICc and BIC.

    A law that contains another, as Herschel and Bulkley's contains Bingham's, need not end worse than it: where its own
    starts do, it is started again from the other's optimum, and the better of both fits counts.

    Parameters
    ----------
    scene : Scene
        The filament; its material's values, where a law has them, are where that law's fit starts.
    laws : sequence of str
        Two or more of :data:`FITTED`.
    also_free : sequence of str
        What else is not known, ``["time_offset"]`` say.
    bounds : mapping, optional
        As for :func:`softcat_sym.inverse.fit`; each law takes those of its own constants.
    profiles : bool
        Whether the law that ranks first is fitted once more, with intervals from profile likelihoods.
    measurements, loss, starts, backend, rtol, seed, progress
        As for :func:`softcat_sym.inverse.fit`.

    Raises
    ------
    SoftcatError
        If a law is unknown or named twice, or none can be fitted.
    """
    _refuse(laws, also_free, bounds or {})
    read = measurements if isinstance(measurements, Measurements) else read_measurements(measurements)
    seen = checked(read, scene)
    told = progress or NoProgress()
    asked = _Asked(read, tuple(also_free), bounds or {}, loss, starts, backend, rtol, seed)
    found = _all_fitted(laws, scene, seen, asked, told)
    return _with_profiles(found, asked, told) if profiles else found


def _all_fitted(
    laws: Sequence[str], scene: Scene, seen: Measurements, asked: _Asked, told: FitProgress
) -> LawComparison:
    fits: dict[str, Fit] = {}
    failures: dict[str, str] = {}
    restarted: dict[str, str] = {}
    for number, law in enumerate(_narrow_first(laws)):
        told.stage(law, number, len(laws))
        try:
            fits[law] = asked.fitted(scene_of_law(scene, law, seen), asked.starts)
        except SoftcatError as error:
            failures[law] = str(error)
        narrower = _better_contained(law, fits, asked.loss)
        if narrower and _restart(law, narrower, asked, seen, fits):
            failures.pop(law, None)
            restarted[law] = narrower
    found = compared(laws, fits, failures, asked.loss, len(asked.also_free))
    return replace(found, restarted={law: other for law, other in restarted.items() if law in found.fits})


def _narrow_first(laws: Sequence[str]) -> list[str]:
    """Every law after those that it contains, otherwise in the order given."""
    return sorted(laws, key=lambda law: len(contained_in(law)))


def _better_contained(law: str, fits: Mapping[str, Fit], loss: Loss) -> str:
    """The best law that this one contains, if its own fit is none or worse; otherwise nothing."""
    inside = {name: fits[name] for name in contained_in(law) if name in fits and fits[name].outcome.converged}
    if not inside:
        return ""
    charged = common_loss(loss, {name: one for name, one in fits.items() if name in inside or name == law})
    values = {name: charged.value(one.starts.best.residuals) for name, one in inside.items()}
    best = min(values, key=lambda name: values[name])
    if law not in fits or not fits[law].outcome.converged:
        return best
    own = charged.value(fits[law].starts.best.residuals)
    return best if own > values[best] * (1 + _NO_WORSE) else ""


def _restart(law: str, narrower: str, asked: _Asked, seen: Measurements, fits: dict[str, Fit]) -> bool:
    """Fit a law from the optimum of one that it contains; keep that fit if it is better, and say so."""
    try:
        again = asked.fitted(widened(fits[narrower].fitted_scene, law, seen), 0)
    except SoftcatError:
        return False
    former = fits.get(law)
    if former is not None and former.outcome.converged:
        charged = common_loss(asked.loss, {"former": former, "again": again})
        before, after = (charged.value(one.starts.best.residuals) for one in (former, again))
        if not (again.outcome.converged and after < before):
            return False
    fits[law] = again
    return True


def _with_profiles(found: LawComparison, asked: _Asked, told: FitProgress) -> LawComparison:
    """Fit the law that ranks first once more, as thoroughly as a single fit is, from where its best fit began."""
    name = found.choice.table[0].law.name
    again = asked.fitted(found.best.scene, asked.starts, profiles=True, progress=told)
    return replace(found, fits={**found.fits, name: again})


def _refuse(laws: Sequence[str], also_free: Sequence[str], bounds: Bounds, fewest: int = 2) -> None:
    faults = [
        Fault(f"law {law}", f"none that can be fitted{did_you_mean(law, FITTED)}", ", ".join(FITTED))
        for law in laws
        if law not in FITTED
    ]
    if len(set(laws)) < len(laws):
        faults.append(Fault("laws", "one is named twice", "each once"))
    if len(laws) < fewest:
        faults.append(Fault("laws", "nothing to compare", "two laws or more"))
    if not faults:
        constants = {name for law in laws for name in constants_of(law)}
        own = [name for name in also_free if name.rpartition(".")[2] in constants]
        accepted = "what is no constant of a law, such as time_offset or density"
        faults += [Fault(f"free {name}", "a constant of a law is free without being named", accepted) for name in own]
        known = {*constants, *(name.rpartition(".")[2] for name in also_free)}
        strange = [name for name in bounds if name.rpartition(".")[2] not in known]
        faults += [Fault(f"bounds of {name}", "not free in any law", ", ".join(sorted(known))) for name in strange]
    if faults:
        raise SceneError(faults)
