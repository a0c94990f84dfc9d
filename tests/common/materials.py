"""A homogeneous bar drawn along a prescribed path: stress and tension of every law, by SciPy at tight tolerances.

sigma = sum of E_j (eps - p_j) + eta eps_t with p_j' = phi_j(sigma_j), so sigma_j' = E_j (eps_t - phi_j(sigma_j));
eps = log s, T = A0 sigma/s.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from scipy.integrate import solve_ivp

Array = npt.NDArray[np.float64]
Rule = Callable[[float], float]


def rigid(sigma: float) -> float:
    """The flow rule of a spring."""
    del sigma
    return 0.0


@dataclass(frozen=True)
class Bar:
    """A material: springs in line with flow rules, side by side, and a viscous stress."""

    branches: tuple[tuple[float, Rule], ...] = ()
    viscosity: float = 0.0


def maxwell(E: float, eta: float) -> Bar:
    """(2.7)."""
    return multimode([(E, eta)])


def multimode(modes: Sequence[tuple[float, float]]) -> Bar:
    """Maxwell elements (E, eta) side by side (Wiechert 1893)."""
    return Bar(tuple((E, lambda sigma, eta=eta: sigma / eta) for E, eta in modes))


def newtonian(eta: float) -> Bar:
    """sigma = eta eps_t (Trouton 1906)."""
    return Bar(viscosity=eta)


def kelvin_voigt(E: float, eta: float) -> Bar:
    """sigma = E eps + eta eps_t."""
    return Bar(((E, rigid),), eta)


def standard_linear(E: float, second: float, eta: float) -> Bar:
    """A spring E beside a Maxwell element (Zener 1948)."""
    return Bar(((E, rigid), (second, lambda sigma: sigma / eta)))


def herschel_bulkley(E: float, consistency: float, index: float, yield_stress: float) -> Bar:
    """phi = sign(sigma) (<|sigma| - sY>/K)^(1/n) (Herschel and Bulkley 1926)."""

    def rule(sigma: float) -> float:
        over = max(abs(sigma) - yield_stress, 0.0)
        return float(np.copysign((over / consistency) ** (1 / index), sigma))

    return Bar(((E, rule),))


def bingham(E: float, eta: float, yield_stress: float) -> Bar:
    """(2.25)."""
    return herschel_bulkley(E, eta, 1.0, yield_stress)


def power_law(E: float, consistency: float, index: float) -> Bar:
    """Norton 1929."""
    return herschel_bulkley(E, consistency, index, 0.0)


@dataclass(frozen=True)
class Drawing:
    """Length of a bar over its first one, held after the last row."""

    rows: tuple[tuple[float, float], ...]
    true_rate: bool = False

    @property
    def knots(self) -> Array:
        """Times of the rows."""
        return np.array([time for time, _ in self.rows])

    def stretch(self, time: Array) -> Array:
        """s at the times."""
        lengths = np.array([stretch for _, stretch in self.rows])
        if self.true_rate:
            return np.exp(np.interp(time, self.knots, np.log(lengths)))
        return np.interp(time, self.knots, lengths)

    def strain_rate(self, time: Array) -> Array:
        """eps_t just before each time."""
        knots, lengths = self.knots, np.array([stretch for _, stretch in self.rows])
        piece = np.searchsorted(knots, time, side="left") - 1
        follow = np.log(lengths) if self.true_rate else lengths
        slope = np.append(np.diff(follow) / np.diff(knots), 0.0)[np.clip(piece, 0, len(knots) - 1)]
        return slope if self.true_rate else slope / self.stretch(time)


def respond(bar: Bar, drawing: Drawing, time: Array) -> tuple[Array, Array]:
    """True stress at ascending times, and energy dissipated by then per unit volume.

    The bar is free of stress at time 0; where the speed jumps, the stress is that before.
    """
    asked = np.asarray(time, dtype=float)
    stops = np.unique(np.concatenate([[0.0], asked, drawing.knots[drawing.knots < asked[-1]]]))
    state = np.zeros(len(bar.branches) + 1)
    history = [state]
    for begin, end in pairwise(stops):
        state = _advance(bar, drawing, state, float(begin), float(end))
        history.append(state)
    chosen = np.array(history)[np.searchsorted(stops, asked)]
    return chosen[:, :-1].sum(axis=1) + bar.viscosity * drawing.strain_rate(asked), chosen[:, -1]


def stress(bar: Bar, drawing: Drawing, time: Array) -> Array:
    """True stress; see `respond`."""
    return respond(bar, drawing, time)[0]


def tension(bar: Bar, drawing: Drawing, time: Array, area: float) -> Array:
    """T = A0 sigma/s."""
    return area * stress(bar, drawing, time) / drawing.stretch(time)


def _advance(bar: Bar, drawing: Drawing, state: Array, begin: float, end: float) -> Array:
    """Springs' stresses and dissipated energy after a time in which the speed does not jump."""
    middle = np.array([(begin + end) / 2])
    slope = float(drawing.strain_rate(middle)[0])
    speed = slope * float(drawing.stretch(middle)[0])
    first = float(drawing.stretch(np.array([begin]))[0])

    def rates(t: float, u: Array) -> Array:
        rate = slope if drawing.true_rate else speed / (first + speed * (t - begin))
        flows = np.array([rule(part) for (_, rule), part in zip(bar.branches, u[:-1], strict=True)])
        grow = np.array([E for E, _ in bar.branches]) * (rate - flows)
        return np.append(grow, u[:-1] @ flows + bar.viscosity * rate**2)

    scale = max([bar.viscosity * abs(slope), *(E for E, _ in bar.branches)])
    done = solve_ivp(rates, (begin, end), state, "LSODA", rtol=1e-10, atol=1e-12 * scale)
    if not done.success:
        raise ArithmeticError(done.message)
    return np.asarray(done.y[:, -1])
