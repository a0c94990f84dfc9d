"""Least-squares problems with a known answer, in plain NumPy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from tests.common.draws import draws

Model = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


@dataclass
class Problem:
    """Residuals (model(q) - data)/std; `model` returns values and derivatives with respect to q."""

    names: tuple[str, ...]
    lower: np.ndarray
    upper: np.ndarray
    model: Model
    data: np.ndarray
    std: float
    seen: list[np.ndarray] = field(default_factory=list)

    def residuals(self, q: np.ndarray) -> np.ndarray:
        return (self.model(q)[0] - self.data) / self.std

    def linearised(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        self.seen.append(q.copy())
        values, derivatives = self.model(q)
        return (values - self.data) / self.std, derivatives / self.std


def problem(
    names: str, model: Model, truth: list[float], std: float, seed: int | None = 0, half: float = 6.0
) -> Problem:
    """Synthetic data at the truth, in a box around zero; without a seed they are exact."""
    exact = model(np.array(truth))[0]
    noise = 0.0 if seed is None else std * draws(seed).standard_normal(exact.size)
    count = len(names.split())
    return Problem(tuple(names.split()), np.full(count, -half), np.full(count, half), model, exact + noise, std)


X = np.linspace(0.0, 3.0, 60)


def line(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Offset + slope x; both of any sign."""
    columns = np.stack([np.ones_like(X), X], axis=1)
    return columns @ q, columns


def decay(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A exp(-k x) with q = log A, log k."""
    amplitude, rate = np.exp(q)
    values = amplitude * np.exp(-rate * X)
    return values, np.stack([values, -rate * X * values], axis=1)


def saturation(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Michaelis and Menten's v x/(K + x) with q = log v, log K."""
    v, K = np.exp(q)
    values = v * X / (K + X)
    return values, np.stack([values, -values * K / (K + X)], axis=1)


def product(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A exp(-(a/b) x): only a/b is identified; q = log A, log a, log b."""
    amplitude, a, b = np.exp(q)
    values = amplitude * np.exp(-a / b * X)
    slope = -a / b * X * values
    return values, np.stack([values, slope, -slope], axis=1)


def unused(q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The decay with a third unknown that does nothing."""
    values, columns = decay(q[:2])
    return values, np.column_stack([columns, np.zeros_like(X)])
