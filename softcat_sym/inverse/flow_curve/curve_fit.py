"""Bingham, Herschel-Bulkley and power law fitted to a flow curve, and which of them the data speak for."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.inverse.estimation.confidence import Estimate, estimate, standard_errors, student_quantile
from softcat_sym.inverse.flow_curve.candidate import LAWS, Candidate, ShearLaw
from softcat_sym.inverse.flow_curve.curve import Floats, FlowCurve, read_flow_curve
from softcat_sym.inverse.flow_curve.variable_projection import INDEX_BOUNDS, best_index, linear_part
from softcat_sym.scene.faults import did_you_mean

CRITERION = (
    "least AICc = N ln(RSS/N) + 2 p + 2 p (p + 1)/(N - p - 1) of the relative residuals (model - measured)/measured, "
    "N points, p constants with the variance among them (Akaike 1974, Hurvich and Tsai 1989)"
)

# Relative residuals below this are rounding, of the file's digits or of the arithmetic: they choose no law.
_ROUNDING = 1e-9
# A difference of AICc below two tells two laws hardly apart (Burnham and Anderson 2002, 2.6).
_CLOSE = 2.0
_POOR = 0.1


@dataclass(frozen=True, eq=False)
class FlowCurveFit:
    """What a flow curve says about the material.

    Attributes
    ----------
    curve : FlowCurve
        The data.
    candidates : tuple of Candidate
        Every law, the best first.
    """

    curve: FlowCurve
    candidates: tuple[Candidate, ...]

    @property
    def best(self) -> Candidate:
        """The law of least AICc."""
        return self.candidates[0]

    def candidate(self, law: str | None = None) -> Candidate:
        """Return the fit of a law, of the best one if none is named.

        Raises
        ------
        SoftcatError
            If no such law was fitted.
        """
        found = [one for one in self.candidates if law in (None, one.law)]
        if not found:
            names = [one.name for one in LAWS]
            raise SoftcatError(f"no law {law!r} is fitted{did_you_mean(str(law), names)}: take {', '.join(names)}")
        return found[0]

    def overrides(self, law: str | None = None) -> dict[str, str | float]:
        """Scene keys that hand the material on, for ``scene.replace`` or ``load_scene``.

        Parameters
        ----------
        law : str or None
            The law, by default the best.

        Returns
        -------
        dict of str to str or float
            ``material.law``, the shear constants as text with their units, and the index, a number. A scene of another
            law has constants that must go: :func:`softcat_sym.inverse.fitted_scene` sees to that.

        Raises
        ------
        SoftcatError
            If no such law was fitted, or the fit is one that no scene can take.
        """
        candidate = self.candidate(law)
        if candidate.unfit:
            raise SoftcatError(f"the fit of {candidate.law} cannot be handed on: {candidate.unfit}")
        return candidate.overrides

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a reader must know beside the numbers."""
        best, second = self.candidates[:2]
        found = list(self.curve.warnings)
        points, needed = len(self.curve.shear_rate), max(law.constants for law in LAWS) + 3
        if points < needed:
            found.append(f"{points} points are too few to compare every law by AICc, which needs {needed}")
        if second.aicc - best.aicc < _CLOSE:
            found.append(
                f"{best.law} and {second.law} are hardly told apart (AICc differs by {second.aicc - best.aicc:.2g})"
            )
        if best.relative_rms > _POOR:
            found.append(f"the best law, {best.law}, misses the data by {100 * best.relative_rms:.2g} % (rms)")
        for name, one in (("yield stress", best.tau_Y), ("consistency", best.k), ("flow index", best.n)):
            if one is not None and one.verdict != "determined":
                found.append(f"the {name} of {best.law} is {one.verdict}")
        return tuple(found)


def fit_flow_curve(curve: str | os.PathLike[str] | FlowCurve) -> FlowCurveFit:
    """Fit Bingham, Herschel-Bulkley and power law to a flow curve, by relative least squares, and compare them.

    The yield stress and the consistency are not negative, the index lies in [0.05, 3]. Within these bounds the
    optimum is global: for a given index the other two follow in closed form, and all indices are searched.

    Parameters
    ----------
    curve : str, path or FlowCurve
        A CSV file with the columns ``shear_rate_1_s`` and ``shear_stress_Pa``, or the points.

    Returns
    -------
    FlowCurveFit
        The laws in the order of AICc = N ln(RSS/N) + 2 p + 2 p (p + 1)/(N - p - 1), the best first.

    Raises
    ------
    SoftcatError
        If the file or the points make no flow curve, with every fault.
    """
    data = curve if isinstance(curve, FlowCurve) else read_flow_curve(curve)
    candidates = [_fit(data, law) for law in LAWS]
    # Of a Newtonian fluid Bingham and the power law are the same; a scene takes the latter. With too few points for
    # AICc, the fewest constants come first, then the least squares.
    fewest = {law.name: law.constants for law in LAWS}
    candidates.sort(key=lambda one: (one.aicc, fewest[one.law], one.unfit is not None, one.aic))
    return FlowCurveFit(data, tuple(candidates))


def _fit(curve: FlowCurve, law: ShearLaw) -> Candidate:
    rate, stress = curve.shear_rate, curve.shear_stress
    reference = float(np.exp(np.log(rate).mean()))
    ratio = rate / reference
    n = best_index(ratio, stress, yields=law.has_yield) if law.has_index else 1.0
    part = linear_part(ratio, stress, np.array([n]), yields=law.has_yield)
    tau_Y, k = float(part.tau_Y[0]), float(part.k[0]) * reference**-n
    n = n if k > 0 else 1.0
    fitted = tau_Y + k * rate**n
    squares = float(np.sum((fitted / stress - 1) ** 2))
    values = {"tau_Y": tau_Y, "k": k, "n": n}
    judged = _judged(rate, stress, law, values, squares)
    points, p = len(rate), law.constants + 1
    aic = points * math.log(max(squares / points, _ROUNDING**2)) + 2 * p
    spare = points - p - 1
    return Candidate(
        law=law.name,
        tau_Y=judged["tau_Y"] if law.has_yield else None,
        k=judged["k"],
        n=judged["n"] if law.has_index else None,
        relative_rms=math.sqrt(squares / points),
        aic=aic,
        aicc=aic + 2 * p * (p + 1) / spare if spare > 0 else math.inf,
        fitted=fitted,
        residuals=fitted / stress - 1,
    )


def _judged(
    rate: Floats, stress: Floats, law: ShearLaw, values: dict[str, float], squares: float
) -> dict[str, Estimate]:
    """Judge every constant; those on a bound do not count as free."""
    k, n = values["k"], values["n"]
    slack = 1e-6
    on_bound = {
        "tau_Y": values["tau_Y"] <= 0,
        "k": k <= 0,
        "n": not INDEX_BOUNDS[0] + slack < n < INDEX_BOUNDS[1] - slack,
    }
    # Without flow the index is not on a bound but without meaning.
    fitted = {"tau_Y": law.has_yield, "k": True, "n": law.has_index and k > 0}
    columns = {"tau_Y": np.ones_like(rate), "k": rate**n, "n": k * rate**n * np.log(rate)}
    free = [name for name in values if fitted[name] and not on_bound[name]]
    errors = standard_errors(np.column_stack([columns[name] for name in free]) / stress[:, None], squares)
    quantile = student_quantile(len(rate) - len(free))
    bounds = {"tau_Y": (0.0, math.inf), "k": (0.0, math.inf), "n": INDEX_BOUNDS}
    judged = {
        name: Estimate(value, None, None, None, "on a bound" if fitted[name] else "undetermined")
        for name, value in values.items()
    }
    for name, error in zip(free, errors, strict=True):
        judged[name] = estimate(values[name], float(error), quantile, bounds[name])
    return judged
