"""One run with what it cost: unknowns, instructions and the median of its solve times."""

from __future__ import annotations

import time
from dataclasses import asdict, dataclass
from statistics import median
from typing import TYPE_CHECKING, Any

import numpy as np

from softcat_sym.effects import choose_effects
from softcat_sym.graph.grid import Floats
from softcat_sym.simulate import simulated, without_estimate
from softcat_sym.single_run import build
from softcat_sym.solve import Outcome, watched
from softcat_sym.solve.keeping import json_form, kept

if TYPE_CHECKING:
    from softcat_sym.scene import Scene
    from softcat_sym.solve import Prepared, Progress
    from softcat_sym.trajectory import Trajectory

_SHORT = 1.0
"""Runs below this many seconds are repeated: what else the machine does would show."""

_REPEATS = 3


@dataclass(frozen=True)
class PricedRun:
    """A run of one list of effects.

    Attributes
    ----------
    effects : tuple of str
        Names in force.
    time, midpoint : ndarray, shape (frames,)
        Output times [s] and height of the midpoint [m]; fewer frames where the run ended early.
    states, algebraic : int
        Differential and algebraic unknowns.
    instructions : int
        Elementary operations in one evaluation of the right-hand side.
    solve : float
        Wall time of the integration [s], the median of three where it is short.
    solver : str
        The integrator that these effects call for.
    outcome : Outcome
        Verdict.
    complaint : str
        Why it is not a success.
    """

    effects: tuple[str, ...]
    time: Floats
    midpoint: Floats
    states: int
    algebraic: int
    instructions: int
    solve: float
    solver: str
    outcome: Outcome
    complaint: str

    @property
    def reach(self) -> float:
        """Largest |midpoint| [m]."""
        heights = np.abs(self.midpoint[np.isfinite(self.midpoint)])
        return float(heights.max()) if heights.size else 0.0


def plain(run: PricedRun) -> dict[str, Any]:
    """A run as lists, text and numbers."""
    told = {"time": run.time.tolist(), "midpoint": run.midpoint.tolist(), "outcome": run.outcome.name}
    return asdict(run) | told


def from_plain(told: dict[str, Any]) -> PricedRun:
    """The run that :func:`plain` has told of."""
    arrays = {name: np.array(told[name], dtype=float) for name in ("time", "midpoint")}
    return PricedRun(**{**told, **arrays, "effects": tuple(told["effects"]), "outcome": Outcome[told["outcome"]]})


_FORM = json_form(plain, from_plain)


def priced_run(scene: Scene, progress: Progress, first: Trajectory | None = None) -> PricedRun:
    """Run a scene with a list of effects and take down what it cost.

    Parameters
    ----------
    scene : Scene
        Its effects are a list.
    progress : Progress
        Told how far each repetition is.
    first : Trajectory, optional
        A run of the same effects that has been made already.

    Raises
    ------
    SceneError
        If the scene cannot have these effects.
    KeyboardInterrupt
        If the user stops it, wherever in CasADi that happens.
    """

    def price() -> PricedRun:
        with watched() as interrupts:
            try:
                return _priced(scene, progress, first)
            finally:
                interrupts.check()

    return kept(lambda: ("priced run", scene.to_toml(), str(first is None)), price, _FORM)


def _priced(scene: Scene, progress: Progress, first: Trajectory | None) -> PricedRun:
    run = first or simulated(without_estimate(scene), progress)
    prepared = build(scene, choose_effects(scene))
    graph = prepared.graph
    seconds = [float(run.summary["wall_s"]["solve"])]
    if seconds[0] < _SHORT:
        seconds += [_seconds(prepared, progress) for _ in range(_REPEATS - 1)]
    return PricedRun(
        effects=tuple(run.summary["effects"]),
        time=run.data["time"].values,
        midpoint=run.data["midpoint"].values,
        states=int(graph.x.numel()),
        algebraic=int(graph.z.numel()),
        instructions=graph.instructions,
        solve=median(seconds),
        solver=run.summary["solver"],
        outcome=run.outcome,
        complaint=run.summary["complaint"],
    )


def _seconds(prepared: Prepared, progress: Progress) -> float:
    """Wall time of one more integration [s]."""
    start = time.perf_counter()
    prepared.solve(progress)
    return time.perf_counter() - start
