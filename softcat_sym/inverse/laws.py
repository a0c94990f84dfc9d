"""Which law: several fitted to the same films, and ranked."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from softcat_sym.effects import REGISTRY
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.inverse.defaults import STARTS
from softcat_sym.inverse.estimation.least_squares import LINEAR, Loss
from softcat_sym.inverse.estimation.model_choice import FittedLaw, ModelChoice, choose_model
from softcat_sym.inverse.filament_fit import FitProgress, NoProgress, fit
from softcat_sym.inverse.fitted import Fit
from softcat_sym.inverse.flow_curve.handing_on import REPLACED
from softcat_sym.inverse.measurements.films import Films
from softcat_sym.inverse.measurements.plausibility import checked
from softcat_sym.inverse.measurements.reading import read_measurements
from softcat_sym.inverse.measurements.series import Measurements
from softcat_sym.inverse.rough_constants import rough_constants
from softcat_sym.scene import Scene
from softcat_sym.scene.faults import did_you_mean
from softcat_sym.scene.laws import CONSTANTS, kind_of_constant
from softcat_sym.scene.shear_data import INDEXED

FITTED = tuple(law for law, constants in CONSTANTS.items() if constants and law != "custom")
"""Laws that have a fixed set of constants."""

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
    """

    fits: dict[str, Fit]
    failures: dict[str, str]
    choice: ModelChoice

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


def fit_laws(
    measurements: Films,
    scene: Scene,
    laws: Sequence[str],
    *,
    also_free: Sequence[str] = (),
    loss: Loss = LINEAR,
    starts: int = STARTS,
    backend: str = "auto",
    rtol: float | None = None,
    seed: int = 0,
    progress: FitProgress | None = None,
) -> LawComparison:
    """Fit every constant of several laws, and compare them by AICc and BIC.

    Parameters
    ----------
    scene : Scene
        The filament; its material's values, where a law has them, are where that law's fit starts.
    laws : sequence of str
        Two or more of :data:`FITTED`.
    also_free : sequence of str
        What else is not known, ``["time_offset"]`` say.
    measurements, loss, starts, backend, rtol, seed, progress
        As for :func:`softcat_sym.inverse.fit`.

    Raises
    ------
    SoftcatError
        If a law is unknown or named twice, or none can be fitted.
    """
    _refuse(laws)
    read = measurements if isinstance(measurements, Measurements) else read_measurements(measurements)
    seen = checked(read, scene)
    told = progress or NoProgress()
    one = partial(fit, loss=loss, starts=starts, profiles=False, backend=backend, rtol=rtol, seed=seed)
    fits: dict[str, Fit] = {}
    failures: dict[str, str] = {}
    for number, law in enumerate(laws):
        told.stage(law, number, len(laws))
        try:
            # As they were read: a fit notes its own corrections.
            fits[law] = one(read, scene_of_law(scene, law, seen), [*_constants(law), *also_free])
        except SoftcatError as error:
            failures[law] = str(error)
    return _compared(laws, fits, failures, loss, len(also_free))


def _compared(
    laws: Sequence[str], fits: Mapping[str, Fit], failures: Mapping[str, str], loss: Loss, besides: int
) -> LawComparison:
    if not fits:
        raise SoftcatError("none of the laws can be fitted:\n" + "\n".join(f"  {k}: {v}" for k, v in failures.items()))
    best = _ranked(laws, fits, failures, loss, besides).table[0].law.name
    # An optimum that was not reached would lie lower still: of the best law that is no objection.
    unreached = {law: one.outcome.value for law, one in fits.items() if not one.outcome.converged and law != best}
    fits = {law: one for law, one in fits.items() if law not in unreached}
    failed = {**failures, **unreached}
    return LawComparison(fits, failed, _undecided_by_too_few(_ranked(laws, fits, failed, loss, besides)))


def _ranked(
    laws: Sequence[str], fits: Mapping[str, Fit], failures: Mapping[str, str], loss: Loss, besides: int
) -> ModelChoice:
    one, charged = next(iter(fits.values())), _common(loss, fits)
    rows = [
        FittedLaw(law, len(fits[law].problem.names), 2 * charged.value(fits[law].starts.best.residuals))
        if law in fits
        else FittedLaw(law, len(_constants(law)) + besides, 0.0, failures[law])
        for law in laws
    ]
    return choose_model(rows, one.starts.best.residuals.size, noise_known=one.noise_known)


def _undecided_by_too_few(choice: ModelChoice) -> ModelChoice:
    """A law with too many constants for the criterion, which is infinite then, is not ruled out by that."""
    fitted = tuple(row for row in choice.table if not row.law.failure)
    if all(math.isfinite(row.aicc) for row in fitted):
        return choice
    return replace(choice, close=tuple(row.law.name for row in fitted), verdict="cannot tell")


def _constants(law: str) -> tuple[str, ...]:
    return (*CONSTANTS[law], *(("index",) if law in INDEXED else ()))


def _common(loss: Loss, fits: Mapping[str, Fit]) -> Loss:
    """One loss for all laws: a robust one has each fit's own estimate of the noise for its scale; the least is used."""
    if loss.kind == "linear" or next(iter(fits.values())).noise_known:
        return loss
    medians = [float(np.median(np.abs(one.starts.best.residuals))) for one in fits.values()]
    return Loss(loss.kind, loss.scale * max(_MEDIAN_TO_DEVIATION * min(medians), _LEAST_NOISE))


def scene_of_law(scene: Scene, law: str, films: Measurements) -> Scene:
    """Give a scene another law, with its own values where it has them and rough ones otherwise.

    Parameters
    ----------
    scene : Scene
        Any.
    law : str
        One of :data:`FITTED`.
    films : Measurements
        How far it sags, and in which time, tells rough values.

    Returns
    -------
    Scene
        Where effects are listed, without those that the law cannot have, and with what only it has.
    """
    material, rough = scene.material, rough_constants(scene, films, law)
    index = material.index if law in INDEXED and material.law in INDEXED else 1.0
    # A consistency is no viscosity, and its rough value is only right for an index of one.
    same = (material.law in INDEXED) == (law in INDEXED) or material.index == 1
    changes: dict[str, object] = {f"material.{name}": None for name in REPLACED}
    changes["material.law"] = law
    if law not in FITTED or "youngs_modulus" not in CONSTANTS[law]:
        changes["material.youngs_modulus"] = None
    for name in CONSTANTS[law]:
        own = getattr(material, name)
        keeps = own is not None and (name != "viscosity" or same)
        changes[f"material.{name}"] = kind_of_constant(name, law, index).write(own if keeps else rough[name])
    if law in INDEXED:
        changes["material.index"] = index
    if isinstance(scene.run.effects, str):
        return scene.replace(changes)
    freed = scene.replace({**changes, "run.effects": "auto"})
    return freed.replace({"run.effects": _effects(scene, freed, scene.run.effects)})


def _effects(former: Scene, scene: Scene, listed: Sequence[str]) -> list[str]:
    """The listed effects that another law can have, and those of published theory that only it has, not the former."""
    able = {one.name: one for one in REGISTRY if one.applies(scene)}
    own = [name for name, one in able.items() if one.in_paper and not one.applies(former)]
    kept = [name for name in listed if name in able]
    names = [*kept, *(name for name in own if name not in kept)]
    while lacking := [name for name in names if not {*able[name].needs} <= {*names}]:
        names = [name for name in names if name not in lacking]
    return names


def _refuse(laws: Sequence[str]) -> None:
    faults = [
        Fault(f"law {law}", f"none that can be fitted{did_you_mean(law, FITTED)}", ", ".join(FITTED))
        for law in laws
        if law not in FITTED
    ]
    if len(set(laws)) < len(laws):
        faults.append(Fault("laws", "one is named twice", "each once"))
    if len(laws) < 2:
        faults.append(Fault("laws", "nothing to compare", "two laws or more"))
    if faults:
        raise SceneError(faults)
