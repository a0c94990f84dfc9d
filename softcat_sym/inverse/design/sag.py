"""The largest sag of a filament as a function of its span: by whole runs, and with derivatives, effects fixed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass

import numpy as np

from softcat_sym.errors import SceneError
from softcat_sym.inverse.design.variables import SPAN
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.forward.free import FreeParameter, free_parameters
from softcat_sym.inverse.forward.model import ForwardModel
from softcat_sym.inverse.forward.substituting import with_values
from softcat_sym.scene import Scene
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.solve.keeping import json_form, kept

# Between which the largest sag is found by a parabola.
_LEAST_FRAMES = 2001
_STEP = 1e-3
_NO_DIFFERENCE = "makes no difference"


@dataclass(frozen=True)
class Sag:
    """A finished run.

    Attributes
    ----------
    value : float
        Largest distance of the midpoint from the supports' level, or that at the end [m]; infinite without an answer.
    effects : tuple of str
        In force.
    note : str
        Why there is no answer; empty if there is.
    """

    value: float
    effects: tuple[str, ...]
    note: str


def with_span(scene: Scene, span: float) -> Scene:
    """The scene with another span [m]."""
    return scene.replace({SPAN: f"{span!r} m"})


_SAG = json_form(asdict, lambda told: Sag(told["value"], tuple(told["effects"]), told["note"]))


def sag_of_run(scene: Scene, *, at_end: bool) -> Sag:
    """Run a filament as the program chooses to, and measure its sag."""
    return kept(lambda: ("sag", scene.to_toml(), str(at_end)), lambda: _sag_of_run(scene, at_end=at_end), _SAG)


def _sag_of_run(scene: Scene, *, at_end: bool) -> Sag:
    try:
        run = simulated(without_estimate(scene))
    except SceneError as error:
        return Sag(np.inf, (), str(error))
    names = tuple(run.summary["effects"])
    if not run.outcome.is_success:
        return Sag(np.inf, names, run.outcome.name)
    return Sag(abs(float(_extreme(run.data.midpoint.values, at_end=at_end) @ run.data.midpoint.values)), names, "")


class FrozenSag:
    """Sag as a smooth function of the logarithms of span and parameters: effects, grid and tolerances are fixed.

    Parameters
    ----------
    scene : Scene
        At about the span that is sought.
    effects : tuple of str
        For all spans.
    paths : sequence of str
        Of the parameters.
    at_end : bool
        Whether the sag at the end is meant, not the largest.

    Attributes
    ----------
    idle : tuple of str
        Parameters that make no difference.
    """

    def __init__(self, scene: Scene, effects: tuple[str, ...], paths: Sequence[str], *, at_end: bool) -> None:
        self._scene = scene.replace({"run.effects": list(effects)})
        self._at_end = at_end
        duration = scene.run.duration
        frames = 2 if at_end else max(scene.run.frames, _LEAST_FRAMES)
        self._times = np.linspace(0.0, duration, frames)[1:]
        self._paths = tuple(paths)
        self.idle: tuple[str, ...] = ()
        self._model = self._made()

    def at(self, span: float) -> tuple[float, float, dict[str, float]]:
        """Sag [m], d log sag/d log span, and d log sag/d log parameter of each parameter that matters.

        By the envelope theorem the largest sag moves as the midpoint at its time.
        """
        if self._model is None:
            return self._by_runs(span)
        model = self._model
        q = model.typical
        q[0] = model.free[0].scaled(span)
        midpoint, slopes = model.with_derivatives(q)
        if not np.all(np.isfinite(midpoint)):
            return np.inf, np.nan, {}
        weights = _extreme(midpoint, at_end=self._at_end)
        height = float(weights @ midpoint)
        by_log = (weights @ slopes) / height
        rest = zip(model.free[1:], by_log[1:].tolist(), strict=True)
        return abs(height), float(by_log[0]), {one.path: slope for one, slope in rest}

    def _made(self) -> ForwardModel | None:
        """The forward model without what makes no difference; None if nothing is integrated, or nothing with slopes."""
        names = [SPAN, *self._paths]
        try:
            return ForwardModel(self._scene, free_parameters(self._scene, names), self._times)
        except SceneError as error:
            idle = {one.path.removeprefix("free ") for one in error.faults if one.found.startswith(_NO_DIFFERENCE)}
            if not idle:
                return None
        free = [one for one in free_parameters(self._scene, names) if one.name not in idle]
        self.idle = tuple(path for path in self._paths if path not in [one.path for one in free])
        self._paths = tuple(one.path for one in free[1:])
        return ForwardModel(self._scene, free, self._times)

    def _by_runs(self, span: float) -> tuple[float, float, dict[str, float]]:
        """The same by central differences of runs, for a row of equilibria, which has no forward model."""
        scene = with_span(self._scene, span)
        free = free_parameters(scene, [SPAN, *self._paths])
        slopes = [_central(self._log_sag(scene, one)) for one in free]
        value = sag_of_run(scene, at_end=self._at_end).value
        return value, slopes[0], dict(zip(self._paths, slopes[1:], strict=True))

    def _log_sag(self, scene: Scene, one: FreeParameter) -> Callable[[float], float]:
        def of(step: float) -> float:
            return float(np.log(sag_of_run(with_values(scene, [one], [one.value(step)]), at_end=self._at_end).value))

        return of


def _central(function: Callable[[float], float]) -> float:
    return (function(_STEP) - function(-_STEP)) / (2 * _STEP)


def _extreme(midpoint: Floats, *, at_end: bool) -> Floats:
    """Weights, shape (n,), that turn heights at even times into the extreme one, by the parabola about it."""
    weights = np.zeros(len(midpoint))
    depth = np.abs(midpoint)
    number = len(depth) - 1 if at_end else int(np.argmax(depth))
    if at_end or not 0 < number < len(depth) - 1:
        weights[number] = 1.0
        return weights
    before, here, after = depth[number - 1 : number + 2]
    curvature = before - 2 * here + after
    x = 0.5 * (before - after) / curvature if curvature < 0 else 0.0
    weights[number - 1 : number + 2] = 0.5 * x * (x - 1), 1 - x**2, 0.5 * x * (x + 1)
    return weights
