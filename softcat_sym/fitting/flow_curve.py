"""Fits of laws to a flow curve from a rheometer, and scenes with the fitted material."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.optimize import least_squares, nnls

from softcat_sym.drawing import Drawable
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.fitting.criterion import CRITERION, charge, charges
from softcat_sym.fitting.identifiability import FittedConstant, estimate, standard_errors, student_quantile
from softcat_sym.fitting.measurements import arrays_of
from softcat_sym.scene.laws import CONSTANTS, LAWS, LawSpec
from softcat_sym.scene.material import shear_names
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.table_reader import Table, counted, implausible, read_table, refusal
from softcat_sym.scene.toml import read_overrides
from softcat_sym.scene.units import did_you_mean

Floats = NDArray[np.float64]

RATE, STRESS = "shear_rate_1_s", "shear_stress_Pa"
"""Names of columns, with their SI units."""

_KIND = "flow curve"
_QUANTITIES = ("shear_rate", "shear_stress", "viscosity", "shear_stress_std")
_SAMPLE = re.compile(r"sample(?:[_ ]?(?:id|name))?", re.IGNORECASE)
"""Name of a column with the sample of each row."""

FEWEST = 4
"""Smallest number of distinct rates: one more than Herschel-Bulkley has constants."""


@dataclass(frozen=True, eq=False)
class FlowCurve:
    """Steady shear stresses at imposed shear rates, in any order; a rate may be repeated."""

    shear_rate: Floats  # shape (points,); [1/s], positive; kept as a copy that cannot be written to
    shear_stress: Floats  # shape (points,); [Pa], positive; likewise
    path: Path | None = None  # The file they come from
    notes: tuple[str, ...] = ()  # What was corrected while it was read, a sentence each
    std: Floats | None = None  # shape (points,); Standard errors of the stresses [Pa], for a fit together with films

    def __post_init__(self) -> None:
        names = ("shear_rate", "shear_stress", *(() if self.std is None else ("std",)))
        arrays, faults = arrays_of({name: getattr(self, name) for name in names}, _wrong)
        for name, values in arrays.items():
            object.__setattr__(self, name, values)
        # Rates that agree to six digits are repetitions of one rate.
        distinct = 0 if faults else len({f"{value:.6g}" for value in self.shear_rate})
        if not faults and distinct < FEWEST:
            accepted = f"at least {FEWEST}: Herschel-Bulkley alone has three constants"
            faults = [Fault("", f"{counted(distinct, 'distinct shear rate')}", accepted)]
        if faults:
            raise refusal(_KIND, self.path, faults)

    @property
    def decades(self) -> float:
        """Range of the shear rates, log10 of largest over smallest."""
        return float(np.log10(self.shear_rate.max() / self.shear_rate.min()))

    @property
    def falls(self) -> bool:
        """Whether the stress decreases with the shear rate overall, by more than rounding errors."""
        return float(np.polyfit(np.log(self.shear_rate), np.log(self.shear_stress), 1)[0]) < -_ROUNDING

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the data themselves."""
        found = list(self.notes)
        if self.decades < 1:
            found.append(
                f"the shear rates span a factor of {10**self.decades:.3g}, less than a decade: "
                "a yield stress is an extrapolation and hardly determined"
            )
        if self.falls:
            found.append(
                "the flow curve falls: stress decreases with shear rate overall, as with thixotropy, wall slip or "
                "shear banding; no law of steady flow describes that"
            )
        return tuple(found)


def read_flow_curve(path: str | os.PathLike[str], sample: str | None = None) -> FlowCurve:
    """Read a flow curve from a table, or from what a rheometer exports.

    Its columns are a shear rate and a shear stress or a viscosity, in any unit (``shear_rate_1_s``, ``Stress [kPa]``,
    units in a line of their own). Rows without positive numbers, as below the least torque, are left out, up to a third
    of them. `sample` names the rows to take where a column ``sample`` (or ``sample_id``) names several.
    """
    file, std = Path(path), "shear_stress_std"
    table = read_table(file, _KIND, f"a CSV file with the columns {RATE} and {STRESS}", _QUANTITIES)
    columns = table.columns(_QUANTITIES)
    read = {one.quantity for one in columns if one.fault is None}
    by_viscosity = "viscosity" in read and "shear_stress" not in read
    _take_sample(table, sample)
    numbers = table.numbers(columns, ("shear_rate", "viscosity" if by_viscosity else "shear_stress"), [std])
    numbers = table.without(numbers, ~(numbers > 0).all(axis=1), "positive number")
    if by_viscosity:
        numbers = numbers.assign(shear_stress=numbers["shear_rate"] * numbers["viscosity"])
        table.said.append("computed stresses, rate times viscosity")
    rate, stress, error = (numbers.get(name) for name in ("shear_rate", "shear_stress", std))
    return FlowCurve(rate.to_numpy(), stress.to_numpy(), file, table.notes, None if error is None else error.to_numpy())


def _take_sample(table: Table, sample: str | None) -> None:
    """Take the rows of one sample, where a column names several."""
    places = [place for place, name in enumerate(table.header) if _SAMPLE.fullmatch(name)][:1]
    of = ["".join(row[place] for place in places) for _, row in table.rows]
    names = [name for name in dict.fromkeys(of) if name]
    if sample is None and len(names) < 2:
        return
    if sample not in names:
        found = f"no sample {sample!r}{did_you_mean(sample, names)}" if sample else counted(len(names), "sample")
        table.refuse([Fault("", found, f"--sample with one of {', '.join(names) or 'a column sample_id'}")])
    table.rows = [row for row, name in zip(table.rows, of, strict=True) if name == sample]


def _wrong(name: str, value: float) -> tuple[str, str] | None:
    is_positive = "a positive number: magnitudes, the fit is of relative residuals"
    return implausible(name, value) or (None if value > 0 else (f"{value:g} is not positive", is_positive))


def shear_stress(law: LawSpec, tau_Y: float, k: float, n: float, shear_rate: Floats) -> Floats:
    """Stress of steady shear [Pa]: tau^p = tau_Y^p + (k g^n)^p, of which a law may have no tau_Y, or n = 1."""
    p = law.shear_exponent
    flowing = k * np.asarray(shear_rate) ** n
    return tau_Y + flowing if p == 1 else (tau_Y**p + flowing**p) ** (1 / p)


def _constants(law: LawSpec) -> int:
    """Number of constants fitted to a flow curve."""
    return 1 + law.yields + law.has_index


def _contains(law: LawSpec, other: LawSpec) -> bool:
    """Whether the other law is this one with fewer constants, in steady shear."""
    same = law.shear_exponent == other.shear_exponent or not other.yields
    return same and law.yields >= other.yields and law.has_index >= other.has_index


FITTED = tuple(one for one in LAWS.values() if one.flow_curve == one.name)
"""Laws that are fitted to a flow curve: those whose curve is not that of another law."""


@dataclass(frozen=True)
class Tensile:
    """The same law in tension, by von Mises' equivalence; SI."""

    yield_stress: float | None  # sqrt(3) tau_Y [Pa]
    viscosity: float  # 3^((n+1)/2) k [Pa s^n]; with n = 1 Trouton's 3 k
    index: float | None  # n


@dataclass(frozen=True, eq=False)
class Candidate:
    """One fitted law."""

    law: str  # Its name
    tau_Y: (
        FittedConstant | None
    )  # Shear yield stress [Pa], consistency [Pa s^n], flow index; None where the law has none
    k: FittedConstant
    n: FittedConstant | None
    relative_rms: float  # Root mean square of the relative residuals
    criterion: float  # `CRITERION`, without a common constant; infinite with too few points for it
    fitted: Floats  # shape (points,); Stress of the law [Pa]
    residuals: Floats  # shape (points,); (fitted - measured)/measured

    def stress(self, shear_rate: Floats) -> Floats:
        """Shear stress [Pa] at shear rates [1/s], any shape."""
        limit = self.tau_Y.value if self.tau_Y else 0.0
        return shear_stress(LAWS[self.law], limit, self.k.value, self._index, shear_rate)

    @property
    def tensile(self) -> Tensile:
        """The constants in tension."""
        return Tensile(
            yield_stress=math.sqrt(3) * self.tau_Y.value if self.tau_Y else None,
            viscosity=3 ** ((self._index + 1) / 2) * self.k.value,
            index=self.n.value if self.n else None,
        )

    @property
    def unfit(self) -> str | None:
        """Why no scene can use the fitted law; None if one can."""
        if self.k.value <= 0:
            return "its stress does not rise with the shear rate: it has no viscosity"
        if self.tau_Y is not None and self.tau_Y.value <= 0:
            return f"its yield stress is zero: take {'power-law' if self.n else 'newtonian'}"
        return None

    @property
    def overrides(self) -> dict[str, str | float]:
        """Scene keys with their units, the shear data as fitted; empty for a law that is `unfit`."""
        if self.unfit:
            return {}
        # With the modulus of the scene: a Newtonian fluid is then Maxwell's.
        alike = (one.name for one in LAWS.values() if one.flow_curve == self.law and "youngs_modulus" in one.constants)
        keys: dict[str, str | float] = {"material.law": next(alike)}
        if self.tau_Y is not None:
            keys["material.shear_yield_stress"] = f"{_written(self.tau_Y.value)} Pa"
        if self.n is None:
            return keys | {"material.shear_viscosity": f"{_written(self.k.value)} Pa*s"}
        return keys | {
            "material.shear_consistency": f"{_written(self.k.value)} Pa*s^{_written(self.n.value)}",
            "material.index": float(_written(self.n.value)),
        }

    def to_dict(self) -> dict[str, Any]:
        """Entry of the law in JSON."""
        consistency = "shear_consistency" if self.n else "shear_viscosity"
        constants = {"shear_yield_stress": self.tau_Y, consistency: self.k, "index": self.n}
        return {
            "parameters": {
                name: {
                    "value": one.value,
                    "std": one.standard_error,
                    "ci95": list(one.interval) if one.interval else None,
                    "verdict": one.verdict,
                }
                for name, one in constants.items()
                if one is not None
            },
            "tensile": asdict(self.tensile),
            "relative_rms": self.relative_rms,
            "criterion": self.criterion,
            "overrides": self.overrides,
            "unfit": self.unfit,
        }

    @property
    def _index(self) -> float:
        return self.n.value if self.n else 1.0


def _written(value: float) -> str:
    """Write ten digits: more than any fit determines, and 0.43 instead of 0.42999999999998406."""
    return f"{value:.10g}"


CONVERSION = "in tension: yield stress √3 τ_Y, consistency K = 3^((n+1)/2) k"

INDEX_BOUNDS = (0.05, 3.0)
"""Smallest and largest flow index n of a fit."""

_STEP = 0.05  # Of the index, of which the best is refined


def optimum(ratio: Floats, stress: Floats, law: LawSpec) -> tuple[float, float, float]:
    """The best tau_Y >= 0 [Pa], k >= 0 [Pa] at the reference rate, and n within `INDEX_BOUNDS`.

    For a given n, tau^p is linear in tau_Y^p and k^p: non-negative least squares over a grid of n give the start.
    """
    p, ones, has_index = law.shear_exponent, np.ones_like(stress), int(law.has_index)

    def columns(n: float) -> Floats:
        return np.column_stack([ones, ratio ** (p * n)][not law.yields :])

    def residuals(x: Floats) -> Floats:
        linear, n = (x[:-1], float(x[-1])) if has_index else (x, 1.0)
        return np.asarray((columns(n) @ linear) ** (1 / p) / stress - 1)

    grid = np.append(np.arange(INDEX_BOUNDS[0], INDEX_BOUNDS[1], _STEP), INDEX_BOUNDS[1]) if has_index else ones[:1]
    starts = [nnls(columns(n) / stress[:, None] ** p, ones) for n in grid.tolist()]
    best = int(np.argmin([root for _, root in starts]))
    linear = starts[best][0]
    pairs = [(0.0, np.inf)] * len(linear) + [INDEX_BOUNDS] * has_index
    scale = [float(np.mean(stress)) ** p] * len(linear) + [1.0] * has_index
    how: dict[str, Any] = {"method": "dogbox", "jac": "3-point", "xtol": 1e-15, "ftol": 1e-15, "gtol": 1e-15}
    start = np.append(linear, grid[best : best + has_index])
    x = least_squares(residuals, start, bounds=tuple(zip(*pairs, strict=True)), x_scale=scale, **how).x.tolist()
    tau_Y, k = ([0.0, *x[: len(linear)]])[-2:]
    return tau_Y ** (1 / p), k ** (1 / p), x[-1] if has_index else 1.0


REPLACED = (
    *(name for constant in CONSTANTS if constant != "youngs_modulus" for name in (constant, *shear_names(constant))),
    *("index", "modes", "flow", "parameters", "structure", "hardening_modulus", "hardening_recovery"),
)
"""Constants that are removed together with a scene's law; elastic ones stay, as no flow curve determines them."""


def fitted_scene(fit: FlowCurveFit, scene: str | Scene, law: str | None = None, overrides: Sequence[str] = ()) -> Scene:
    """Give a scene the material of a fit."""
    own, faults = read_overrides(overrides)
    if faults:
        raise SceneError(faults)
    # Overrides of the material are applied after the fit, as they may not suit the scene's own law.
    later = {change.path: change.value for change in own if change.path.startswith("material.")}
    earlier = {change.path: change.value for change in own if change.path not in later}
    base = scene.replace(earlier) if isinstance(scene, Scene) else load_scene(scene, earlier)
    changes: dict[str, object] = {f"material.{name}": None for name in REPLACED}
    changes |= fit.overrides(law)
    has_modulus = base.material.youngs_modulus is not None or "material.youngs_modulus" in later
    without = LAWS[str(changes["material.law"])].flow_curve
    if not has_modulus and "youngs_modulus" not in LAWS[without].constants:
        changes["material.law"] = without
    for path, value in later.items():
        # Moved to the end, where it replaces the same constant given in another form.
        changes.pop(path, None)
        changes[path] = value
    return base.replace(changes)


# Relative residuals below this are rounding errors of the file or of the arithmetic, and do not decide between laws.
_ROUNDING = 1e-9
# Relative residual above which a warning is given.
_POOR = 0.1


@dataclass(frozen=True, eq=False)
class FlowCurveFit(Drawable):
    """Fits of all laws to a flow curve.

    Attributes
    ----------
    curve : FlowCurve
        The data.
    candidates : tuple of Candidate
        Every law, the best first.
    """

    curve: FlowCurve
    candidates: tuple[Candidate, ...]

    def __repr__(self) -> str:
        laws = [f"{one.law}, {100 * one.relative_rms:.2g} % rms" for one in self.candidates]
        points = counted(len(self.curve.shear_rate), "point")
        return "\n  ".join(
            [f"FlowCurveFit of {points}, the best law first", *laws, ".candidates, .overrides(), .plot()"]
        )

    def to_dict(self, law: str | None = None) -> dict[str, Any]:
        """Content of ``flow_curve.json``, with the law that is handed on to a scene."""
        curve, least = self.curve, self.best.criterion
        return {
            "curve": str(curve.path) if curve.path else None,
            "points": len(curve.shear_rate),
            "shear_rate_1_s": [float(curve.shear_rate.min()), float(curve.shear_rate.max())],
            "best": self.best.law,
            "handed_on": self.candidate(law).law,
            "overrides": self.candidate(law).overrides,
            "criterion": CRITERION,
            "conversion": CONVERSION,
            "candidates": {one.law: one.to_dict() | {"above_best": one.criterion - least} for one in self.candidates},
            "warnings": list(self.warnings),
        }

    def to_frame(self) -> pd.DataFrame:
        """Measured and fitted stresses [Pa] and relative residuals, point by point in the order of the file."""
        columns = {RATE: self.curve.shear_rate, STRESS: self.curve.shear_stress}
        for one in self.candidates:
            name = one.law.replace("-", "_")
            columns |= {f"{name}_Pa": one.fitted, f"{name}_relative_residual": one.residuals}
        return pd.DataFrame(columns)

    @property
    def best(self) -> Candidate:
        """The law with the smallest criterion."""
        return self.candidates[0]

    def candidate(self, law: str | None = None) -> Candidate:
        """Return the fit of a law, of the best one if none is named."""
        found = [one for one in self.candidates if law in (None, one.law)]
        if not found:
            names = [one.name for one in FITTED]
            raise SoftcatError(f"no law {law!r} is fitted{did_you_mean(str(law), names)}: take {', '.join(names)}")
        return found[0]

    @property
    def _close(self) -> bool:
        """Whether the second law fits about as well: its criterion differs by less than the penalty of a constant.

        If it contains the best law, which it then never fits worse, the limit is half that penalty.
        """
        (best, one), (second, other) = ((each, LAWS[each.law]) for each in self.candidates[:2])
        last = charge(len(self.curve.shear_rate), max(_constants(one), _constants(other)))
        return second.criterion - best.criterion < (0.5 if _contains(other, one) else 1.0) * last

    def overrides(self, law: str | None = None) -> dict[str, str | float]:
        """Scene keys that hand the material of a law on, by default of the best, as ``scene.replace`` takes them.

        They are ``material.law``, the shear constants as text with their units, and the index, a number. A fit that no
        scene can take is refused. :func:`softcat_sym.fitting.fitted_scene` also removes constants of another law from a
        scene, and replaces ``maxwell`` by ``newtonian`` in a scene without a modulus.
        """
        candidate = self.candidate(law)
        unfit = candidate.unfit
        if law is None and self.curve.falls:
            unfit = "the flow curve falls; a law that is named is handed on all the same"
        if unfit:
            raise SoftcatError(f"the fit of {candidate.law} cannot be handed on: {unfit}")
        return candidate.overrides

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the data and the fits."""
        best, second = self.candidates[:2]
        found = list(self.curve.warnings)
        if self._close:
            above = second.criterion - best.criterion
            found.append(f"{best.law} and {second.law} fit about equally well (the criterion differs by {above:.2g})")
        if best.relative_rms > _POOR:
            found.append(f"the best law, {best.law}, misses the data by {100 * best.relative_rms:.2g} % (rms)")
        for name, one in (("yield stress", best.tau_Y), ("consistency", best.k), ("flow index", best.n)):
            if one is not None and one.verdict != "determined":
                found.append(f"the {name} of {best.law} is {one.verdict}")
        return tuple(found)


def fit_flow_curve(curve: str | os.PathLike[str] | FlowCurve, sample: str | None = None) -> FlowCurveFit:
    """Fit every law of `FITTED` to a flow curve, by relative least squares, and compare them.

    The yield stress and the consistency are not negative, the index lies in [0.05, 3]. The optimum within these bounds
    is global: for a given index the other two are those of a linear fit, and the whole range of the index is searched.

    Parameters
    ----------
    curve : str, path or FlowCurve
        A CSV file with the columns ``shear_rate_1_s`` and ``shear_stress_Pa``, or the points.
    sample : str, optional
        Which sample of a file that holds several.

    Returns
    -------
    FlowCurveFit
        The laws in the order of :data:`softcat_sym.fitting.criterion.CRITERION`, the best first.

    Raises
    ------
    SoftcatError
        If the file or the points are not a valid flow curve, with every fault.
    """
    data = curve if isinstance(curve, FlowCurve) else read_flow_curve(curve, sample)
    candidates = [_fit(data, law) for law in FITTED]
    # Of laws that fit equally well the one with fewer constants, then one without a yield stress, is first.
    candidates.sort(key=lambda one: (one.criterion, _constants(LAWS[one.law]), LAWS[one.law].yields))
    return FlowCurveFit(data, tuple(candidates))


def _fit(curve: FlowCurve, law: LawSpec) -> Candidate:
    rate, stress, points = curve.shear_rate, curve.shear_stress, len(curve.shear_rate)
    reference = float(np.exp(np.log(rate).mean()))
    ratio = rate / reference
    tau_Y, k, n = optimum(ratio, stress, law)
    k *= reference**-n
    # With a consistency of zero the index has no meaning.
    n = n if k > 0 else 1.0
    fitted = shear_stress(law, tau_Y, k, n, rate)
    squares = float(np.sum((fitted / stress - 1) ** 2))
    judged = _judged(rate, stress, law, {"tau_Y": tau_Y, "k": k, "n": n}, squares)
    return Candidate(
        law=law.name,
        tau_Y=judged["tau_Y"] if law.yields else None,
        k=judged["k"],
        n=judged["n"] if law.has_index else None,
        relative_rms=math.sqrt(squares / points),
        criterion=points * math.log(max(squares / points, _ROUNDING**2)) + charges(points, _constants(law)),
        fitted=fitted,
        residuals=fitted / stress - 1,
    )


def scatter(curve: FlowCurve, law: str) -> float:
    """Standard deviation of the relative residuals about the best fit of a law, corrected for its constants."""
    points, spec = len(curve.shear_rate), LAWS[law]
    return _fit(curve, spec).relative_rms * math.sqrt(points / max(points - _constants(spec), 1))


def _judged(
    rate: Floats, stress: Floats, law: LawSpec, values: dict[str, float], squares: float
) -> dict[str, FittedConstant]:
    """Estimate of every constant; constants on a bound do not count as free."""
    k, n = values["k"], values["n"]
    slack = 1e-6
    on_bound = {
        "tau_Y": values["tau_Y"] <= 0,
        "k": k <= 0,
        "n": not INDEX_BOUNDS[0] + slack < n < INDEX_BOUNDS[1] - slack,
    }
    # With a consistency of zero the index has no meaning.
    fitted = {"tau_Y": law.yields, "k": True, "n": law.has_index and k > 0}
    flowing = k * rate**n
    parts = {"tau_Y": np.full_like(rate, values["tau_Y"]), "k": flowing, "n": flowing}
    slopes = {"tau_Y": np.ones_like(rate), "k": rate**n, "n": flowing * np.log(rate)}
    fitted_stress, rest = shear_stress(law, values["tau_Y"], k, n, rate), 1 - law.shear_exponent
    free = [name for name in values if fitted[name] and not on_bound[name]]
    columns = [slopes[name] * (fitted_stress / parts[name]) ** rest if rest else slopes[name] for name in free]
    errors = standard_errors(np.column_stack(columns) / stress[:, None], squares)
    quantile = student_quantile(len(rate) - len(free))
    bounds = {"tau_Y": (0.0, math.inf), "k": (0.0, math.inf), "n": INDEX_BOUNDS}
    judged = {
        name: FittedConstant(value, None, None, None, "on a bound" if fitted[name] else "undetermined")
        for name, value in values.items()
    }
    for name, error in zip(free, errors, strict=True):
        judged[name] = estimate(values[name], float(error), quantile, bounds[name])
    return judged
