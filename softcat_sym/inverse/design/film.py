"""Information in films of one filament: by exact frames, and of every duration at once from one run."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from softcat_sym.inverse.design.noise import Noise
from softcat_sym.inverse.estimation.least_squares import Floats
from softcat_sym.inverse.forward.free import FreeParameter
from softcat_sym.inverse.forward.model import ForwardModel
from softcat_sym.scene import Scene

# Frames that are integrated; more are counted, as what lies between frames is seen by both.
_MOST_FRAMES = 2001
_FIRST, _OCTAVE = 300, 150
# Of the integrator while many experiments are compared: errors of the information below a percent.
_ROUGH_RTOL = 1e-3
# Of q: between runs whose fibres do not yield at the same instants.
_BESIDE = 1e-3


@dataclass(frozen=True, eq=False)
class Films:
    """All films of one filament from the release on, by their duration.

    Attributes
    ----------
    durations : ndarray, shape (m,)
        Increasing [s].
    mean : ndarray, shape (m, k, k)
        Mean of s s^T over each film [m^2], s = d midpoint/dq; NaN where the filament does not hold so long.
    sag : ndarray, shape (m,)
        Largest within each film [m]; NaN where there is none.
    complaint : str
        Why it does not; empty if it does.
    """

    durations: Floats
    mean: Floats
    sag: Floats
    complaint: str

    def information(self, frames: Floats, noise: float | Floats) -> Floats:
        """Fisher information of q, shape (m, k, k), for so many frames, shape (m,), spread evenly over each film.

        The noise [m] is one for all, or one for each film, shape (m,).
        """
        return self.mean * (frames / noise**2)[:, None, None]


def film_times(shortest: float, longest: float) -> tuple[Floats, Floats]:
    """Times [s] at which a run is seen so that films of any duration between two can be judged, and these durations.

    Even up to the shortest film, then by octaves: every film is then resolved by more than a hundred times.
    """
    times = np.linspace(0.0, shortest, _FIRST + 1)
    octaves = math.log2(longest / shortest)
    count = max(1, math.ceil(octaves)) if octaves > 0 else 0
    edges = shortest * (longest / shortest) ** (np.arange(count + 1) / max(count, 1))
    pieces = [np.linspace(a, b, _OCTAVE + 1)[1:] for a, b in pairwise(edges.tolist())]
    durations = np.concatenate([times[-1:], *pieces])
    durations[-1] = longest
    return np.concatenate([times[:-1], durations]), durations


def films_of(scene: Scene, free: tuple[FreeParameter, ...], shortest: float, longest: float) -> Films:
    """Run a filament once, to the longest duration, and judge every shorter film of it.

    The sum over n frames spread evenly over [0, T] is n/T times the integral over time, up to terms of order 1/n.

    Raises
    ------
    SceneError
        If there is no such filament, or something free makes no difference to it.
    """
    times, durations = film_times(shortest, longest)
    scene = scene.replace({"run.duration": f"{longest!r} s"})
    # What yields has slopes that scatter enough at its own tolerances.
    smooth = scene.material.yield_stress is None
    model = ForwardModel(scene, free, times, rtol=max(_ROUGH_RTOL, scene.numerics.rtol or 0.0) if smooth else None)
    depth, slopes = _seen(model)
    density = slopes[:, :, None] * slopes[:, None, :]
    steps = np.diff(times)[:, None, None]
    area = np.cumsum(0.5 * steps * (density[1:] + density[:-1]), axis=0)
    sag = np.maximum.accumulate(depth)[-len(durations) :]
    return Films(durations, area[-len(durations) :] / durations[:, None, None], sag, model.complaint)


@dataclass(frozen=True, eq=False)
class ExactFilm:
    """One film by its own frames.

    Attributes
    ----------
    information : ndarray, shape (k, k)
        Fisher's, of q.
    sag : float
        Largest within the film [m].
    complaint : str
        Why the filament does not hold; empty if it does.
    """

    information: Floats
    sag: float
    complaint: str


def exact_film(scene: Scene, free: tuple[FreeParameter, ...], frames: int, noise: Noise) -> ExactFilm:
    """Follow a filament through the frames of one film.

    Parameters
    ----------
    frames : int
        Spread evenly over the scene's duration, the first at the release; beyond 2001 every so many are integrated.

    Raises
    ------
    SceneError
        If there is no such filament, or something free makes no difference to it.
    """
    integrated = min(frames, _MOST_FRAMES)
    model = ForwardModel(scene, free, np.linspace(0.0, scene.run.duration, integrated))
    depth, slopes = _seen(model)
    sag = float(np.max(depth))
    information = slopes.T @ slopes * (frames / integrated / noise.of(sag) ** 2)
    return ExactFilm(information, sag, model.complaint)


def _seen(model: ForwardModel) -> tuple[Floats, Floats]:
    """Depths [m], shape (n,), and slopes d midpoint/dq, shape (n, k).

    Where things yield, both are the median over three neighbouring filaments.

    Differences across the instant at which a fibre yields are no derivatives, and would pass for information.
    """
    beside = (0.0, -_BESIDE, _BESIDE) if "yielding" in model.effects else (0.0,)
    found = [model.with_derivatives(model.typical + step) for step in beside]
    heights, slopes = (np.asarray(np.median([one[k] for one in found], axis=0), dtype=float) for k in (0, 1))
    return np.abs(heights), slopes
