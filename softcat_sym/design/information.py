"""What films of one filament tell of its constants by Fisher information, for what may be chosen."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from numbers import Real
from typing import Any, NamedTuple, TypeVar

import numpy as np

from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.forward_model import ForwardModel
from softcat_sym.fitting.free_parameters import FreeParameter
from softcat_sym.fitting.identifiability import DERIVATIVE_ACCURACY
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.units import NotAQuantity, did_you_mean, shown, to_si

SPAN, THICKNESS, FRAME_RATE, DURATION = "filament.span", "filament.thickness", "frame_rate", "run.duration"
VARIABLES = (SPAN, THICKNESS, FRAME_RATE, DURATION)
_KINDS = {
    SPAN: ("length", "m", "20 mm"),
    THICKNESS: ("length", "m", "2 mm"),
    FRAME_RATE: ("frequency", "1/s", "100 Hz"),
    DURATION: ("time", "s", "5 s"),
}
_SAME = 1e-9

Within = Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Range:
    """Bounds of one design variable."""

    path: str  # One of `VARIABLES`
    low: float  # SI; equal if it is fixed
    high: float

    @property
    def is_fixed(self) -> bool:
        """Whether there is nothing to choose."""
        return self.low == self.high

    def snapped(self, value: float) -> float:
        """The value, or the bound that it lies at but for rounding, or beyond."""
        bound = self.bound_at(value)
        return self.low if self.is_fixed or bound == "lower" else self.high if bound else value

    def bound_at(self, value: float) -> str:
        """Name the bound at which a value lies: ``"lower"``, ``"upper"``, or empty."""
        if self.is_fixed:
            return ""
        if value <= self.low * (1 + _SAME):
            return "lower"
        return "upper" if value >= self.high * (1 - _SAME) else ""


def as_given(scene: Scene) -> dict[str, float]:
    """The design variables of the scene as it is [SI]; its frames are those of the camera."""
    run, filament = scene.run, scene.filament
    rate = (run.frames - 1) / run.duration
    return {SPAN: filament.span, THICKNESS: filament.thickness, FRAME_RATE: rate, DURATION: run.duration}


def read_ranges(scene: Scene, within: Within) -> dict[str, Range]:
    """Read the bounds of an experiment."""
    leaves = {path.rpartition(".")[2]: path for path in VARIABLES}
    ranges = {path: Range(path, value, value) for path, value in as_given(scene).items()}
    faults = []
    for name, bounds in within.items():
        path = leaves.get(name, name)
        if path not in VARIABLES:
            hint = did_you_mean(name, VARIABLES)
            faults.append(Fault(f"within {name}", f"no design variable{hint}", ", ".join(VARIABLES)))
            continue
        try:
            ranges[path] = _range(path, bounds)
        except NotAQuantity as error:
            kind, _, example = _KINDS[path]
            accepted = f'a positive {kind} such as "{example}", or a pair of them, the lower one first'
            faults.append(Fault(f"within {path}", str(error), accepted))
    if not faults and not ranges[THICKNESS].low < ranges[SPAN].high:
        found = f"{ranges[THICKNESS].low:g} m or more, and no span above {ranges[SPAN].high:g} m"
        faults.append(Fault(f"within {THICKNESS}", found, "a thickness below the span"))
    if faults:
        raise SceneError(faults)
    return ranges


def read_positive(value: object, kind: str, unit: str) -> float:
    """Read a positive quantity: text with a unit, or a number in SI."""
    if isinstance(value, (int, float, Real)) and not isinstance(value, bool):
        number = float(value)
        if not math.isfinite(number):
            raise NotAQuantity(f"{shown(value)} is not finite")
    else:
        number = to_si(value, kind, unit)
    if number <= 0:
        raise NotAQuantity(f"{shown(value)} is not positive")
    return number


def read_share(value: object) -> float | None:
    """Read a percentage such as ``"1 %"`` as a fraction; None if it is none."""
    found = re.fullmatch(r"\s*([^%]*?)\s*%\s*", value) if isinstance(value, str) else None
    if found is None:
        return None
    try:
        share = float(found[1]) / 100
    except ValueError:
        raise NotAQuantity(f"{shown(value)} is no percentage") from None
    if not 0 < share < math.inf:
        raise NotAQuantity(f"{shown(value)} is not positive and finite")
    return share


def _range(path: str, bounds: object) -> Range:
    kind, unit, _ = _KINDS[path]
    pair = bounds if isinstance(bounds, (tuple, list)) else (bounds, bounds)
    if len(pair) != 2:
        raise NotAQuantity(f"{len(pair)} values")
    low, high = (read_positive(bound, kind, unit) for bound in pair)
    if low > high:
        raise NotAQuantity(f"{shown(pair[0])} is above {shown(pair[1])}")
    return Range(path, low, high)


Sags = TypeVar("Sags", float, Floats)


@dataclass(frozen=True, slots=True)
class ReadingNoise:
    """Standard deviation of one reading."""

    value: float  # [m], or a share of the largest sag within the film
    of_sag: bool = False  # Which of them

    def of(self, sag: Sags) -> Sags:
        """Standard deviation [m] in a film in which the filament sags so far [m]; one for each of several films."""
        return self.value * sag if self.of_sag else self.value + 0 * sag


def read_noise(value: object) -> ReadingNoise:
    """Read a length such as ``"10 um"``, a number in m, or a share of the sag such as ``"1 %"``."""
    share = read_share(value)
    return ReadingNoise(read_positive(value, "length", "m")) if share is None else ReadingNoise(share, of_sag=True)


# Components of a direction that no experiment sees, below which an unknown does not take part in it.
_TAKES_PART = 1e-4


def relative_errors(matrices: Floats, free: Sequence[FreeParameter]) -> Floats:
    """Relative standard errors by the Cramer-Rao bound, sqrt((F^-1)_ii); in SI of what is typically zero."""
    scales = np.array([1.0 if one.logarithmic else one.scale / (abs(one.typical) or 1.0) for one in free])
    present = np.asarray(np.isfinite(matrices).all(axis=(-1, -2), keepdims=True))
    values, directions = np.linalg.eigh(np.where(present, matrices, 0.0))
    floor = np.maximum(DERIVATIVE_ACCURACY**2 * values[..., -1:], np.finfo(float).tiny)
    seen = (values > floor)[..., None, :]
    variance = 1 / np.maximum(values, floor)[..., None, :]
    parts = directions**2 * np.where(seen, variance, 0.0)
    hidden = (~seen & (np.abs(directions) > _TAKES_PART)).any(axis=-1)
    return np.where(hidden | ~present[..., 0], np.inf, np.sqrt(parts.sum(axis=-1)) * scales)


# Frames that are integrated; more are counted, as what lies between frames is seen by both.
_MAX_FRAMES = 2001
_FIRST, _OCTAVE = 300, 150
# Of the integrator while many experiments are compared: errors of the information below a percent.
_ROUGH_RTOL = 1e-3
# Of q: between runs whose fibres do not yield at the same instants.
_BESIDE = 1e-3


@dataclass(frozen=True, eq=False)
class Films:
    """All films of one filament from the release on, by their duration."""

    durations: Floats  # shape (m,); Increasing [s]
    # shape (m, k, k); Mean of s s^T over each film [m^2], s = d midpoint/dq; NaN where the filament does not hold so
    # long.
    mean: Floats
    sag: Floats  # shape (m,); Largest within each film [m]; NaN where there is none
    message: str  # Why it does not; empty if it does

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
    return Films(durations, area[-len(durations) :] / durations[:, None, None], sag, model.message)


class ExactFilm(NamedTuple):
    """One film by its own frames."""

    information: Floats  # shape (k, k); Fisher's, of q
    sag: float  # Largest within the film [m]
    message: str  # Why the filament does not hold; empty if it does


def exact_film(scene: Scene, free: tuple[FreeParameter, ...], frames: int, noise: ReadingNoise) -> ExactFilm:
    """Follow a filament through the frames of one film."""
    integrated = min(frames, _MAX_FRAMES)
    model = ForwardModel(scene, free, np.linspace(0.0, scene.run.duration, integrated))
    depth, slopes = _seen(model)
    sag = float(np.max(depth))
    information = slopes.T @ slopes * (frames / integrated / noise.of(sag) ** 2)
    return ExactFilm(information, sag, model.message)


def _seen(model: ForwardModel) -> tuple[Floats, Floats]:
    """Depths [m], shape (n,), and slopes d midpoint/dq, shape (n, k).

    Where things yield, both are the median over three neighbouring filaments.

    Differences across the instant at which a fibre yields are no derivatives, and would pass for information.
    """
    beside = (0.0, -_BESIDE, _BESIDE) if model.terms.yields else (0.0,)
    found = [model.with_derivatives(model.typical + step) for step in beside]
    heights, slopes = (np.asarray(np.median([one[k] for one in found], axis=0), dtype=float) for k in (0, 1))
    return np.abs(heights), slopes


@dataclass(frozen=True)
class Trial:
    """A design and the errors that it leaves."""

    span: float  # [m]
    thickness: float
    frame_rate: float  # [1/s]
    duration: float  # [s]
    frames: int  # The first at the release, the last at the end
    # Largest relative standard error of what counts; infinite if the film leaves it open.
    worst: float
    # Relative standard error of each unknown, of the camera's own in SI.
    errors: Mapping[str, float]
    sag: float = math.nan  # Largest within the film [m]; NaN where there is none
    note: str = ""  # Why there is no answer; empty if there is

    @property
    def values(self) -> dict[str, float]:
        """The design variables by path, in SI."""
        return dict(zip(VARIABLES, (self.span, self.thickness, self.frame_rate, self.duration), strict=True))

    def to_dict(self) -> dict[str, Any]:
        """What JSON and tables hold of it, in SI."""
        return {
            "span_m": self.span,
            "thickness_m": self.thickness,
            "frame_rate_1_s": self.frame_rate,
            "duration_s": self.duration,
            "frames": self.frames,
            "sag_m": self.sag,
            "worst": self.worst,
            "errors": dict(self.errors),
            "note": " ".join(self.note.split()),
        }

    @property
    def changes(self) -> dict[str, object]:
        """What makes a scene this experiment, for :meth:`softcat_sym.Scene.replace`."""
        return {
            SPAN: f"{self.span!r} m",
            THICKNESS: f"{self.thickness!r} m",
            DURATION: f"{self.duration!r} s",
            "run.frames": self.frames,
        }
