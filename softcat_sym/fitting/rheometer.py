"""Constants of a material from a rheometer's tests: flow curve, amplitude sweep, frequency sweep, recovery."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
from numpy.typing import NDArray
from scipy.optimize import least_squares, nnls

from softcat_sym.drawing import Drawable
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.fitting.criterion import charges
from softcat_sym.fitting.flow_curve import REPLACED, FlowCurveFit, fit_flow_curve, fitted_scene
from softcat_sym.fitting.identifiability import FittedConstant, estimate, standard_errors, student_quantile
from softcat_sym.scene.laws import LAWS
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.table_reader import MAX_MISSING, counted, read_table, refusal
from softcat_sym.scene.toml import read_overrides, toml_value

Floats = NDArray[np.float64]

_KIND = "rheometer's table"
_AMPLITUDES = ("strain", "shear_stress")
_MODULI = ("storage_modulus", "loss_modulus")
_QUANTITIES = (*_AMPLITUDES, "angular_frequency", "frequency", "time", "interval", *_MODULI, "shear_rate", "viscosity")
_ACCEPTED = (
    "an amplitude sweep (strain, G', G''), a frequency sweep (frequency, G', G''), a recovery test (time, G') or a "
    "flow curve (shear rate, shear stress)"
)

LINEAR_LIMIT = 0.03
"""Loss of G' at which the linear range of an amplitude sweep ends."""

_FEWEST = 5  # points of a test
_SPREAD = 1.5  # Ratio of smallest to largest abscissa below which it is not what was swept
_PER_DECADE = 8  # relaxation times among which modes begin
_DROP = 0.5  # Share of G' below which a material counts as broken down


@dataclass(frozen=True)
class RheometerConstant:
    """A constant of the scene that a test determines."""

    key: str  # Of [material], in shear, as a scene takes it
    unit: str
    estimate: FittedConstant
    source: str  # File, and how it was read off


@dataclass(frozen=True, eq=False)
class RheometerTest:
    """One table of a rheometer, and what was read off it.

    Attributes
    ----------
    kind : str
        ``"amplitude sweep"``, ``"frequency sweep"``, ``"recovery"``.
    path : Path
        The file.
    table : DataFrame
        Columns in SI: strain, shear_stress, angular_frequency or time; storage_modulus, loss_modulus.
    found : dict of str to Estimate
        What was read off, by name: ``storage_modulus`` [Pa], ``loss_modulus`` [Pa], ``yield_crossover`` [Pa],
        ``yield_linear`` [Pa], ``strain_linear``, ``build_up_time`` [s], ``destroyed_share``, ``recovered_share``.
    modes : tuple of (Estimate, Estimate)
        Of a frequency sweep: shear modulus [Pa] and relaxation time [s].
    notes : tuple of str
        What was skipped, and what the data do not say.
    curve : callable
        Fitted G' over the swept quantity, for the picture.
    """

    kind: str
    path: Path
    table: pd.DataFrame
    found: Mapping[str, FittedConstant]
    modes: tuple[tuple[FittedConstant, FittedConstant], ...] = ()
    notes: tuple[str, ...] = ()
    curve: Callable[[Floats], Floats] | None = None
    swept: str = "strain"

    @property
    def source(self) -> str:
        """Test and file, for the table of constants."""
        return f"{self.kind}, {self.path.name}"

    @property
    def is_solid(self) -> bool:
        """Whether G' is above G'' at the first point."""
        return bool(self.table["storage_modulus"].iloc[0] > self.table["loss_modulus"].iloc[0])


def _least_squares(
    residuals: Callable[[Floats], Floats], start: Sequence[float], bounds: tuple[Sequence[float], Sequence[float]]
) -> tuple[Floats, Floats, int]:
    """Optimum, standard errors and degrees of freedom; an infinite error of what is not determined or on a bound."""
    low, high = map(np.array, bounds)
    begin = np.clip(start, low, high)
    found = least_squares(residuals, begin, bounds=bounds, x_scale=np.maximum(np.abs(begin), 1e-3), xtol=1e-12)
    free = found.active_mask == 0
    errors = np.full(len(begin), np.inf)
    if free.any() and len(found.fun) > free.sum():
        errors[free] = standard_errors(found.jac[:, free], 2 * found.cost)
    return found.x, errors, len(found.fun) - int(free.sum())


def _of_log(log: float, error: float, freedom: int) -> FittedConstant:
    """A positive constant from its logarithm, with an interval that is even in the logarithm."""
    value, half = math.exp(log), student_quantile(max(freedom, 1)) * error
    known = estimate(value, value * error, student_quantile(max(freedom, 1)), (0.0, math.inf))
    if not math.isfinite(half):
        return known
    return FittedConstant(
        value, value * error, (value * math.exp(-half), value * math.exp(half)), value * half, known.verdict
    )


def read_amplitude_sweep(path: Path, table: pd.DataFrame, notes: tuple[str, ...]) -> RheometerTest:
    """Modulus, loss and yield stress of an amplitude sweep, by G' = G0/(1 + (strain/strain_c)^a) and the crossover.

    The linear range ends where G' has lost 3 % (DIN 51810-4); the flow point is where G' and G'' cross, interpolated
    in logarithms between the nearest three points on either side. Both stresses are amplitudes.
    """
    table = table.sort_values("strain" if "strain" in table else "shear_stress")
    if "strain" not in table:
        table = table.assign(strain=table["shear_stress"] / np.hypot(table["storage_modulus"], table["loss_modulus"]))
    if "shear_stress" not in table:
        table = table.assign(shear_stress=table["strain"] * np.hypot(table["storage_modulus"], table["loss_modulus"]))
    strain, stress, storage, loss = (
        table[name].to_numpy() for name in ("strain", "shear_stress", "storage_modulus", "loss_modulus")
    )
    level, found, said = (
        float(np.median(storage[: max(3, len(storage) // 3)])),
        dict[str, FittedConstant](),
        list(notes),
    )
    broken = np.flatnonzero(storage < _DROP * level)
    used = slice(0, max(int(broken[0]) + 1 if broken.size else len(storage), _FEWEST - 1))
    x, y = np.log(strain[used]), np.log(storage[used])

    def model(q: Floats, at: Floats) -> Floats:
        return np.asarray(q[0] - np.log1p(np.exp(q[2] * (at - q[1]))))

    edges = float(x[0]), float(x[-1])
    q, errors, freedom = _least_squares(
        lambda q: model(q, x) - y, (y[0], edges[1], 1.5), ((-60, edges[0] - 3, 0.3), (60, edges[1] + 8, 8))
    )
    found["storage_modulus"] = _of_log(q[0], errors[0], freedom)
    onset = math.log(LINEAR_LIMIT / (1 - LINEAR_LIMIT)) / q[2]
    linear = q[1] + onset
    plateau = x < min(linear, x[-1])
    if plateau.sum() >= 2:
        logs = np.log(loss[used][plateau])
        found["loss_modulus"] = _of_log(
            float(logs.mean()), float(logs.std(ddof=1)) / math.sqrt(plateau.sum()), int(plateau.sum()) - 1
        )
    solid = storage[0] > loss[0]
    if solid and linear < edges[1] and np.isfinite(errors[1:]).all():
        slope = onset / q[2]  # Of the limit by the exponent
        error = math.hypot(errors[1], slope * errors[2])
        found["strain_linear"] = _of_log(linear, error, freedom)
        lost = math.log(found["storage_modulus"].value * (1 - LINEAR_LIMIT)) + linear
        found["yield_linear"] = _of_log(lost, math.hypot(error, errors[0]), freedom)
    elif solid:
        said.append(f"G' loses less than {100 * LINEAR_LIMIT:g} % up to a strain of {strain[-1]:.3g}: no yield stress")
    crossing = _crossing(np.log(stress), np.log(storage / loss))
    if crossing is not None:
        found["yield_crossover"] = crossing
    elif solid:
        said.append("G' stays above G'': sweep to larger strains for the flow point")
    else:
        said.append("G'' is above G' from the first point on: a liquid at this frequency, without a yield stress")

    def curve(at: Floats) -> Floats:
        return np.exp(model(q, np.log(at)))

    return RheometerTest("amplitude sweep", path, table, found, (), tuple(said), curve, "strain")


def _crossing(x: Floats, ratio: Floats) -> FittedConstant | None:
    """Where log G'/G'' falls through zero, by a parabola through the three points on either side, and its error."""
    falls = np.flatnonzero((ratio[:-1] > 0) & (ratio[1:] <= 0))
    if not falls.size or ratio[0] <= 0:
        return None
    near = slice(max(int(falls[0]) - 2, 0), int(falls[0]) + 4)
    columns = np.vander(ratio[near], 3, increasing=True)
    solution, *_ = np.linalg.lstsq(columns, x[near], rcond=None)
    rest = x[near] - columns @ solution
    freedom = len(rest) - 3
    if freedom < 1:
        return None
    return _of_log(float(solution[0]), float(standard_errors(columns, float(rest @ rest))[0]), freedom)


def read_frequency_sweep(path: Path, table: pd.DataFrame, notes: tuple[str, ...]) -> RheometerTest:
    """Maxwell modes of a frequency sweep, relative least squares of G' and G''.

    Non-negative least squares over relaxation times on a fine grid (Baumgaertel & Winter 1989) say where modes lie;
    neighbours are joined one by one, each set is refined, and the criterion of the laws says how many are meant.
    """
    table = table.sort_values("angular_frequency")
    omega, storage, loss = (table[name].to_numpy() for name in ("angular_frequency", *_MODULI))
    data = np.concatenate([storage, loss])

    def shapes(times: Floats) -> Floats:
        turned = np.outer(omega, times)
        seen: Floats = np.concatenate([turned**2, turned]) / np.tile(1 + turned**2, (2, 1)) / data[:, None]
        return seen

    low, high = -math.log10(omega[-1]) - 0.5, -math.log10(omega[0]) + 0.5
    grid = np.logspace(low, high, max(int(_PER_DECADE * (high - low)), 2))
    weights, _ = nnls(shapes(grid), np.ones(len(data)))
    groups = np.split(np.arange(len(grid)), np.flatnonzero(weights == 0))
    begun = [(float(weights[one].sum()), float(np.log(grid[one]) @ weights[one])) for one in groups]
    begun = [(g, t / g) for g, t in begun if g > 0]
    best: tuple[float, Floats, Floats, int] | None = None
    while begun:
        count = len(begun)
        start = np.array([*(math.log(g) for g, _ in begun), *(t for _, t in begun)])

        def residuals(q: Floats, count: int = count) -> Floats:
            return shapes(np.exp(q[count:])) @ np.exp(q[:count]) - 1

        bounds = [-60.0] * count + [2.303 * (low - 1)] * count, [60.0] * count + [2.303 * (high + 1)] * count
        q, errors, freedom = _least_squares(residuals, start.tolist(), bounds)
        squares = float(np.sum(residuals(q) ** 2)) / len(data)
        # A mode may lie anywhere, so that noise has many places to look like one: twice a law's penalty.
        rating = len(data) * math.log(max(squares, 1e-18)) + 2 * charges(len(data), 2 * count)
        if best is None or rating < best[0]:
            best = rating, q, errors, freedom
        # One mode less: the two that are nearest to each other become one.
        k = int(np.argmin(np.diff([t for _, t in begun]))) if count > 1 else 0
        pair = begun[k : k + 2]
        total = sum(g for g, _ in pair)
        begun[k : k + 2] = [(total, sum(g * t for g, t in pair) / total)] if count > 1 else []
    if best is None:
        raise refusal(
            _KIND, path, [Fault("", "no relaxation is seen in G' and G''", "a sweep over two decades or more")]
        )
    _, q, errors, freedom = best
    count = len(q) // 2
    modes = tuple(
        (_of_log(q[k], errors[k], freedom), _of_log(q[count + k], errors[count + k], freedom))
        for k in np.argsort(q[count:])
    )
    values = np.exp(q)

    def curve(at: Floats) -> Floats:
        turned = np.outer(at, values[count:]) ** 2
        return np.asarray(turned / (1 + turned) @ values[:count])

    found = {}
    solid = storage > loss
    if solid.all():
        middle = len(omega) // 2
        found["loss_tangent"] = estimate(
            float(loss[middle] / storage[middle]), float(np.std(np.log(loss / storage))), 1.96, (0.0, math.inf)
        )
    return RheometerTest("frequency sweep", path, table, found, modes, notes, curve, "angular_frequency")


def read_recovery(path: Path, table: pd.DataFrame, notes: tuple[str, ...]) -> RheometerTest:
    """Build-up of G' (or of the viscosity) at rest after a time of shear: G = G_inf - (G_inf - G_0) exp(-t/t_b).

    The last interval is the rest where the table numbers its intervals; else what follows the smallest value.
    """
    table = table.sort_values("time", kind="stable")
    name = "storage_modulus" if "storage_modulus" in table else "viscosity"
    time, modulus = table["time"].to_numpy(), table[name].to_numpy()
    if "interval" in table and table["interval"].nunique() > 1:
        begin = int(np.flatnonzero(table["interval"].to_numpy() == table["interval"].to_numpy()[-1])[0])
    else:
        begin = int(np.argmin(modulus))
    t, y = time[begin:] - time[begin], modulus[begin:]
    if len(t) < _FEWEST or not t[-1] > 0:
        found_text = f"{counted(len(t), 'point')} of rest after the shear"
        raise refusal(_KIND, path, [Fault("", found_text, f"at least {_FEWEST}")])
    top = float(y.max())
    third = float(np.interp(0.63 * (top - y[0]) + y[0], np.maximum.accumulate(y), t)) or t[-1] / 3
    scale = np.maximum(y, 1e-3 * top)
    q, errors, freedom = _least_squares(
        lambda q: (q[0] - (q[0] - q[1]) * np.exp(-t / math.exp(q[2])) - y) / scale,
        (top, y[0], math.log(third)),
        ((0.0, 0.0, math.log(t[1] / 10)), (100 * top, top, math.log(100 * t[-1]))),
    )
    found = {"build_up_time": _of_log(q[2], errors[2], freedom)}
    share = q[1] / q[0]
    error = share * math.hypot(errors[0] / q[0], errors[1] / q[1] if q[1] > 0 else math.inf)
    found["destroyed_share"] = estimate(float(share), float(error), student_quantile(freedom), (0.0, 1.0))
    said = list(notes)
    if begin > 0:
        before = float(np.median(modulus[: max(1, int(np.argmax(modulus < _DROP * modulus[0])))]))
        share = q[0] / before
        found["recovered_share"] = estimate(
            float(share), float(share * errors[0] / q[0]), student_quantile(freedom), (0.0, math.inf)
        )
    if math.exp(q[2]) > t[-1]:
        said.append(f"the rest of {t[-1]:.3g} s is shorter than the build-up time: rest longer")

    def curve(at: Floats) -> Floats:
        since = at - time[begin]
        built = q[0] - (q[0] - q[1]) * np.exp(-since / math.exp(q[2]))
        return np.where(since >= 0, built, np.nan)

    return RheometerTest("recovery", path, table, found, (), tuple(said), curve, "time")


def _is_swept(table: pd.DataFrame, name: str) -> bool:
    """Whether a quantity takes more values than the few steps of a recovery test, which instruments nearly keep."""
    return name in table and len({*np.round(np.log10(table[name]), 1)}) >= _FEWEST - 1


def kind_of(table: pd.DataFrame) -> str:
    """Which test a table in SI is; empty if it is none."""
    oscillates = {*_MODULI} <= {*table}
    amplitude = "strain" if "strain" in table else "shear_stress"
    swept = [name for name in (amplitude, "angular_frequency") if oscillates and _is_swept(table, name)]
    if swept:
        return "" if len(swept) > 1 else "frequency sweep" if swept == ["angular_frequency"] else "amplitude sweep"
    if _is_swept(table, "shear_rate") and {"shear_stress", "viscosity"} & {*table}:
        return "flow curve"
    return "recovery" if "time" in table and {"storage_modulus", "viscosity"} & {*table} else ""


_READERS = {
    "amplitude sweep": read_amplitude_sweep,
    "frequency sweep": read_frequency_sweep,
    "recovery": read_recovery,
}


def read_test(path: str | os.PathLike[str], sample: str | None = None) -> RheometerTest | FlowCurveFit:
    """Read a table of a rheometer, and what it says of the material.

    Parameters
    ----------
    path : str or path
        A table as the instrument exports it, or with columns such as ``strain [%]``, ``storage_modulus_Pa``,
        ``loss_modulus_Pa``, ``angular_frequency_rad/s``, ``time_s``, ``shear_rate_1_s``, ``shear_stress_Pa``.
    sample : str, optional
        Which sample of a flow curve that holds several.

    Returns
    -------
    RheometerTest or FlowCurveFit
        The test that its columns are of.

    Raises
    ------
    SoftcatError
        If the file is no such table, with every fault.
    """
    file = Path(path)
    cells = read_table(file, _KIND, _ACCEPTED, _QUANTITIES)
    table = cells.numbers(cells.columns(_QUANTITIES), (), _QUANTITIES)
    if "frequency" in table and "angular_frequency" not in table:
        table = table.assign(angular_frequency=2 * np.pi * table["frequency"])
    swept = table[[name for name in table if name in (*_AMPLITUDES, "angular_frequency", *_MODULI, "shear_rate")]]
    bad = ~(swept > 0).all(axis=1)
    kind = kind_of(table if bad.mean() >= MAX_MISSING else table[~bad])
    if kind == "flow curve":
        return fit_flow_curve(file, sample)
    if not kind:
        found = f"columns {', '.join(table) or 'none'} that are read, of which none is swept alone, or several are"
        cells.refuse([Fault("", found, _ACCEPTED)])
    table = cells.without(table, bad, "positive number")
    if len(table) < _FEWEST:
        cells.refuse([Fault("", counted(len(table), "row"), f"at least {_FEWEST}")])
    return _READERS[kind](file, table, cells.notes)


_MISSING = {
    "storage_modulus": "an amplitude sweep, at small strains",
    "yield stress": "a flow curve, or an amplitude sweep beyond the crossing of G' and G''",
    "viscosity": "a flow curve",
    "structure": "a recovery test: rest, shear, rest",
}
"""What a scene of an ink needs, and the test that determines it."""


@dataclass(frozen=True, eq=False)
class RheometerMaterial(Drawable):
    """The constants of a material that tests of a rheometer determine.

    Attributes
    ----------
    tests : tuple of RheometerTest or FlowCurveFit
        What was read.
    constants : tuple of Constant
        Of [material], in shear, each with its interval and its source.
    told : tuple of Constant
        What was read off beside it and does not go into the scene, as the other of two yield stresses.
    keys : dict
        ``material.*`` keys as :meth:`Scene.replace` takes them.
    missing : dict of str to str
        What no test determined, and the test that would.
    warnings : tuple of str
        What to know of the data.
    """

    tests: tuple[RheometerTest | FlowCurveFit, ...]
    constants: tuple[RheometerConstant, ...]
    told: tuple[RheometerConstant, ...]
    keys: Mapping[str, object]
    missing: Mapping[str, str]
    warnings: tuple[str, ...] = field(default=())

    def scene(self, base: str | Scene, changes: Sequence[str] = ()) -> Scene:
        """A scene with this material in place of its own."""
        given = base if isinstance(base, Scene) else load_scene(base)
        curve = next((one for one in self.tests if isinstance(one, FlowCurveFit)), None)
        elastic = {name: value for name, value in self.keys.items() if name in _ELASTIC}
        if elastic:
            given = given.replace({**dict.fromkeys(_STIFFNESSES), **elastic})
        if curve is not None and "material.law" in self.keys:
            made = fitted_scene(curve, given, str(self.keys["material.law"]))
        else:
            gone = (*(f"material.{name}" for name in REPLACED), *_STIFFNESSES)
            made = given.replace({**dict.fromkeys(gone), **self.keys})
        structure = {"material.structure": self.keys["material.structure"]} if "material.structure" in self.keys else {}
        own, faults = read_overrides(changes)
        if faults:
            raise SceneError(faults)
        return made.replace({**structure, **{one.path: one.value for one in own}})

    def to_toml(self) -> str:
        """The table [material], in shear, as a scene takes it."""
        keys = {name.removeprefix("material."): value for name, value in self.keys.items()}
        return "\n".join(["[material]", *(f"{name} = {toml_value(value)}" for name, value in keys.items()), ""])

    def to_dict(self) -> dict[str, Any]:
        """Content of ``material.json``, in SI and in shear."""

        def rows(constants: Sequence[RheometerConstant]) -> dict[str, Any]:
            return {
                one.key: {
                    "value": one.estimate.value,
                    "unit": one.unit,
                    "std": one.estimate.standard_error,
                    "ci95": list(one.estimate.interval) if one.estimate.interval else None,
                    "verdict": one.estimate.verdict,
                    "source": one.source,
                }
                for one in constants
            }

        return {
            "constants": rows(self.constants),
            "told": rows(self.told),
            "keys": dict(self.keys),
            "missing": dict(self.missing),
            "warnings": list(self.warnings),
        }

    @property
    def text(self) -> tuple[str, ...]:
        """What is missing, and warnings, a sentence each."""
        missing = [f"not determined: {what}; it takes {test}" for what, test in self.missing.items()]
        return (*missing, *(f"warning: {one}" for one in self.warnings))


_STIFFNESSES = tuple(f"material.{name}" for name in ("youngs_modulus", "loss_tangent", "solid_viscosity"))
_ELASTIC = ("material.storage_modulus", "material.loss_modulus", "material.loss_tangent")
_UNITS = {"build_up_time": "s", "shear_viscosity": "Pa*s", "shear_consistency": "Pa*s^n"}
_RATIOS = ("index", "strain_linear", "destroyed_share", "recovered_share", "loss_tangent")


@dataclass
class _Collected:
    """What has been gathered of the tests, one after the other: what decides the law first."""

    constants: list[RheometerConstant] = field(default_factory=list)
    told: list[RheometerConstant] = field(default_factory=list)
    keys: dict[str, object] = field(default_factory=dict)
    warnings: list[str] = field(default_factory=list)

    def add(self, name: str, found: FittedConstant | None, source: str, *, into_scene: bool) -> None:
        """Add a constant that a test has, to those of the scene or to those that are told."""
        if found is not None:
            unit = "" if name in _RATIOS else _UNITS.get(name, "s" if name.endswith("time") else "Pa")
            (self.constants if into_scene else self.told).append(RheometerConstant(name, unit, found, source))

    def flow_curve(self, fit: FlowCurveFit, law: str | None) -> None:
        """Law, yield stress, viscosity or consistency, index."""
        best = fit.candidate(law)
        self.warnings += fit.warnings
        self.keys |= best.overrides
        if best.unfit:
            self.warnings.append(f"{best.law} of the flow curve goes into no scene: {best.unfit}")
        source = f"flow curve, {fit.curve.path.name if fit.curve.path else 'points'}, {best.law}"
        viscosity = "shear_consistency" if best.n else "shear_viscosity"
        for name, one in (("shear_yield_stress", best.tau_Y), (viscosity, best.k), ("index", best.n)):
            self.add(name, one, source, into_scene=not best.unfit)

    def amplitude_sweep(self, test: RheometerTest) -> None:
        """Modulus and loss below yield; the ends of the linear range and of the solid are told."""
        for name in ("storage_modulus", "loss_modulus"):
            self.add(name, test.found.get(name), test.source, into_scene=test.is_solid)
            if name in test.found and test.is_solid:
                self.keys[f"material.{name}"] = f"{test.found[name].value:.6g} Pa"
        for name in ("yield_crossover", "yield_linear", "strain_linear"):
            self.add(name, test.found.get(name), test.source, into_scene=False)

    def frequency_sweep(self, test: RheometerTest, *, fluid: bool) -> None:
        """Modes of a material that does not yield and has no flow curve; else they are told."""
        self.add("loss_tangent", test.found.get("loss_tangent"), test.source, into_scene=False)
        for number, (modulus, time) in enumerate(test.modes, start=1):
            self.add(f"mode {number} modulus", modulus, test.source, into_scene=fluid)
            self.add(f"mode {number} time", time, test.source, into_scene=fluid)
        if fluid:
            self.keys = {name: value for name, value in self.keys.items() if name not in _ELASTIC}
            self.keys["material.law"] = "multimode-maxwell"
            self.keys["material.modes"] = [
                {"youngs_modulus": f"{3 * g.value:.6g} Pa", "viscosity": f"{3 * g.value * t.value:.6g} Pa*s"}
                for g, t in test.modes
            ]

    def recovery(self, test: RheometerTest) -> None:
        """Structure, where the yield stress is known on which it acts."""
        limit, law = self.keys.get("material.shear_yield_stress"), LAWS.get(str(self.keys.get("material.law")))
        into = limit is not None and law is not None and law.has_structure
        time, share = test.found["build_up_time"], test.found["destroyed_share"]
        self.add("build_up_time", time, test.source, into_scene=into)
        self.add("destroyed_share", share, test.source, into_scene=into)
        self.add("recovered_share", test.found.get("recovered_share"), test.source, into_scene=False)
        if into:
            low = share.value * float(str(limit).split()[0])
            self.keys["material.structure"] = {
                "build_up_time": f"{time.value:.6g} s",
                "destroyed_yield_stress": f"{low:.6g} Pa",
                "measured": "shear",
            }
            self.warnings.append(
                "the yield stress is taken to be destroyed as the modulus is; the flow curve's is that of the built-up "
                f"material: fresh from the nozzle shear_yield_stress is nearer to {low:.3g} Pa"
            )


def read_material(
    paths: Sequence[str | os.PathLike[str]], law: str | None = None, sample: str | None = None
) -> RheometerMaterial:
    """Make a material of the files of a rheometer: a flow curve, sweeps, a recovery test, at most one of each.

    The flow curve gives law, yield stress, viscosity and index; the amplitude sweep modulus and loss below yield, and
    two more yield stresses, which are told; the frequency sweep the modes of a material that does not yield; the
    recovery test how fast structure builds up, and the share of the yield stress that is left after shear, taken to be
    that of the modulus.

    Parameters
    ----------
    paths : sequence of str or path
        The files, in any order.
    law : str, optional
        Law to take of the flow curve in place of the best.
    sample : str, optional
        Which sample of a flow curve that holds several.

    Returns
    -------
    RheometerMaterial
        The constants with their intervals and sources, and what no file determines.

    Raises
    ------
    SoftcatError
        If a file is no test of a rheometer, or two are the same test.
    """
    tests = tuple(read_test(path, sample) for path in paths)
    kinds = [one.kind if isinstance(one, RheometerTest) else "flow curve" for one in tests]
    twice = next((kind for kind in kinds if kinds.count(kind) > 1), None)
    if twice:
        raise SoftcatError(f"{kinds.count(twice)} files of a {twice}; accepted: one of each test")
    fit = next((one for one in tests if isinstance(one, FlowCurveFit)), None)
    if law is not None and fit is None:
        raise SoftcatError(f"law {law!r} is of a flow curve, and none of the files is one")
    of = {one.kind: one for one in tests if isinstance(one, RheometerTest)}
    found = _Collected()
    if fit is not None:
        found.flow_curve(fit, law)
    sweep, frequencies, recovery = (of.get(kind) for kind in _READERS)
    if sweep is not None:
        found.amplitude_sweep(sweep)
    if frequencies is not None:
        solid = sweep is not None and "yield_linear" in sweep.found
        found.frequency_sweep(frequencies, fluid=fit is None and not solid)
    if recovery is not None:
        found.recovery(recovery)
    keys = found.keys
    if "material.law" not in keys and "material.storage_modulus" in keys:
        keys = {"material.law": "elastic", **keys}
    flows = fit is not None or "material.modes" in keys
    determined = {
        "storage_modulus": "material.storage_modulus" in keys or "material.modes" in keys,
        "yield stress": flows,
        "viscosity": flows,
        "structure": recovery is not None or "material.modes" in keys,
    }
    missing = {what: test for what, test in _MISSING.items() if not determined[what]}
    notes = [f"{one.path.name}: {note}" for one in of.values() for note in one.notes]
    warnings = tuple(dict.fromkeys([*found.warnings, *notes]))
    return RheometerMaterial(tests, tuple(found.constants), tuple(found.told), keys, missing, warnings)
