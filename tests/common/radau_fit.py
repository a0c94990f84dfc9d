"""What somebody would write with SciPy alone: `least_squares` around `solve_ivp` with Radau."""

from __future__ import annotations

import copy
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

from softcat_sym.fitting.measurements import Series
from softcat_sym.solvers.run import Prepared
from tests.common.rivals.kirchhoff_c import numbers_of
from tests.common.rivals.radau import NumpyFilament, RadauRival

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Tolerances:
    """How exact it is to be."""

    rtol: float
    atol: float
    difference: float
    gain: float


@dataclass(frozen=True)
class Found:
    """Logarithms of the constants over those of the start, and how often the filament was integrated."""

    q: Floats
    runs: int


class RadauFit:
    """The rival's half filament with logarithms of its constants as unknowns."""

    def __init__(self, prepared: Prepared, series: Series, names: tuple[str, ...]) -> None:
        self._nodes = prepared.graph.grid.nodes
        self._given = dict(zip(prepared.graph.parameters, prepared.p.tolist(), strict=True))
        self._names, self._series = names, series
        self._times = series.time / self._given["time_scale"]
        self._rival = RadauRival(prepared)
        self.runs = 0

    def residuals(self, q: Floats, tolerances: Tolerances) -> Floats:
        """(model - measured)/standard error."""
        self.runs += 1
        moved = {name: self._given[name] * float(np.exp(x)) for name, x in zip(self._names, q, strict=True)}
        filament = NumpyFilament(numbers_of(self._nodes, {**self._given, **moved}))
        # Where it is not zero is the same for all constants.
        jacobian = copy.copy(self._rival.jacobian)
        jacobian.filament = filament
        found = solve_ivp(
            filament.rates,
            (0.0, float(self._times[-1])),
            self._rival.start,
            method="Radau",
            t_eval=self._times,
            rtol=tolerances.rtol,
            atol=tolerances.atol,
            jac=jacobian,
        )
        if not found.success:
            raise RuntimeError(found.message)
        std = self._series.std
        return np.asarray((found.y[1] * self._given["rest_length"] - self._series.midpoint) / std)

    def fit(self, start: Floats, tolerances: Tolerances, method: str = "trf") -> Found:
        """Minimise the sum of squares."""
        before = self.runs
        # SciPy's steps are relative, and around zero they would be far below what Radau resolves.
        found = least_squares(
            lambda x: self.residuals(x - 1, tolerances),
            start + 1,
            jac="2-point",
            method=method,
            diff_step=tolerances.difference,
            ftol=tolerances.gain,
            xtol=tolerances.gain,
            gtol=tolerances.gain,
        )
        return Found(found.x - 1, self.runs - before)
