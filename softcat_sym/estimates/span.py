"""The longest span that the forecast knows: where its sag reaches a limit."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from softcat_sym.errors import SceneError
from softcat_sym.estimates.forecast import expected_sag
from softcat_sym.scene.scene import Scene

FACTOR = 30.0
"""Of a scene's own span, either way, between which others are looked for."""
RATIO = 1.8
"""Of neighbouring spans of a search, at most."""
CLEAR = 2.0
"""Logarithm of the sag over the limit that is clearly more, or less."""
_GUESS = 0.03  # of log span: the least step of a search


def crossings(values: Sequence[float]) -> tuple[int, ...]:
    """Numbers i for which values i and i + 1 lie on different sides of zero; infinities count by their sign."""
    return tuple(i for i, (a, b) in enumerate(pairwise(values)) if (a < 0) != (b < 0))


def with_span(scene: Scene, span: float) -> Scene:
    """The scene with another span [m]."""
    return scene.replace({"filament.span": f"{span!r} m"})


@dataclass(frozen=True, slots=True)
class Limit:
    """Of the sag: a length, or a fraction of the span."""

    value: float  # [m], or a fraction
    of_span: bool  # Which of them

    def at(self, span: float) -> float:
        """The limit [m]."""
        return self.value * span if self.of_span else self.value

    def excess(self, span: float, sag: float) -> float:
        """Logarithm of the sag over the limit."""
        if not sag > 0:
            return -math.inf
        return math.log(sag / self.at(span)) if math.isfinite(sag) else math.inf

    def slope(self, by_span: float) -> float:
        """Slope of the excess by log span, from that of log sag."""
        return by_span - 1.0 if self.of_span else by_span


DEFAULT_LIMIT = Limit(0.05, of_span=True)
"""The largest sag of a span that is called good where nothing else is asked for."""


def foreseen_span(scene: Scene, limit: Limit) -> float | None:
    """The span [m] at which the forecast's sag reaches a limit; None where it does not within a factor of thirty."""
    ends = math.log(scene.filament.span / FACTOR), math.log(scene.filament.span * FACTOR)
    found = foreseen_log_span(scene, limit, ends)
    return None if found in ends else math.exp(found)


def foreseen_log_span(scene: Scene, limit: Limit, within: tuple[float, float]) -> float:
    """Logarithm of the span at which the forecast's sag reaches the limit, else of the end nearest to it."""

    @functools.cache
    def excess(x: float) -> float:
        span = math.exp(x)
        try:
            sag = span * expected_sag(with_span(scene, span))
        except SceneError:  # A span that this scene cannot have.
            return CLEAR
        return float(np.clip(limit.excess(span, sag), -CLEAR, CLEAR))

    logs, values = steps_to_limit(excess, limit, math.log(scene.filament.span), within)
    turns = crossings(values)
    if not turns:
        return logs[0] if values[0] >= 0 else logs[-1]
    # Between neighbours of a rough forecast a power of the span is as good as more steps.
    (x, x_1), (y, y_1) = (pair[turns[0] : turns[0] + 2] for pair in (logs, values))
    return x - y * (x_1 - x) / (y_1 - y)


def steps_to_limit(
    excess: Callable[[float], float], limit: Limit, start: float, within: tuple[float, float]
) -> tuple[list[float], list[float]]:
    """Steps from a first guess until the sag has crossed the limit: logarithms of spans, ascending, and the excesses.

    A step is the one that a sag as the span to the power of 1.8 calls for: rather too long, as most sags grow faster.
    """
    x = min(max(start, within[0]), within[1])
    seen = {x: excess(x)}
    upwards = seen[x] < 0
    while (seen[x] < 0) == upwards and x != within[upwards]:
        step = min(max(abs(seen[x]) / limit.slope(1.8), _GUESS), math.log(RATIO))
        x = min(max(x + (step if upwards else -step), within[0]), within[1])
        seen[x] = excess(x)
    logs = sorted(seen)
    return logs, [seen[x] for x in logs]
