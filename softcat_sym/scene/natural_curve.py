"""The curve of a filament without stress and the turns of its sections: straight, arc, helix, through points."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.parts import if_given
from softcat_sym.scene.shapes import ARC, HELIX, STRAIGHT
from softcat_sym.scene.tables import Tables

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from softcat_sym.scene.parts import Filament, Point, Rule

# Most scenes are read without NumPy and SciPy.
with lazy_imports():
    import numpy as np
    from scipy import interpolate, optimize
    from scipy.spatial import transform

if TYPE_CHECKING:
    Floats = NDArray[np.float64]

_STEP = 0.05
"""Part of a turn, over 2 pi, by which the end of a helix is sought."""
_TURNS = 1000
"""Of a helix: each takes tens of cells."""
_APART = 1e-9
"""Part of the span by which a curve may miss a support."""
_SAMPLES = 50
"""Pieces of the curve between two given points, over which its length is summed."""
_OPPOSITE = 1e-14
_ALONG = (1.0, 0.0, 0.0)


class SpaceCurve(ABC):
    """Places and turns of sections by the length along a curve [m]; it begins at the origin."""

    length: float
    _steps: Floats  # Lengths along the curve, near enough to each other to follow its turns

    @abstractmethod
    def places(self, along: Floats) -> Floats:
        """Places, shape (..., 3)."""

    @abstractmethod
    def _turns(self, along: Floats) -> transform.Rotation: ...

    def quaternions(self, along: Floats) -> Floats:
        """Turns w, x, y, z of the sections at lengths that grow, without a change of sign, shape (..., 4)."""
        fine = np.union1d(along, self._steps)
        found: Floats = continuous(self._turns(fine))[np.searchsorted(fine, along)]
        return found


class SteadyCurve(SpaceCurve):
    """An arc or a helix: twist and curvature, about the axes of the section, are the same everywhere.

    Parameters
    ----------
    length : float
        Along the curve [m].
    kappa : ndarray, shape (3,)
        Twist and curvatures [1/m].
    chord : ndarray, shape (3,)
        Direction from its first point to its last one; it is turned there by the least turn.
    """

    def __init__(self, length: float, kappa: Floats, chord: Floats) -> None:
        self.length, self._kappa = length, kappa
        self._omega = float(np.linalg.norm(kappa))
        self._steps = np.linspace(0, length, 2 + int(4 * self._omega * length))
        self._start = least_turn(self._own(np.array([length]))[0], chord)

    def _own(self, along: Floats) -> Floats:
        """Places seen from the first section."""
        axis, s = self._kappa / self._omega, along[:, None]
        straight = axis[0] * axis
        angle = self._omega * s
        around = np.sin(angle) * (np.array(_ALONG) - straight) + (1 - np.cos(angle)) * np.cross(axis, np.array(_ALONG))
        found: Floats = s * straight + around / self._omega
        return found

    def places(self, along: Floats) -> Floats:
        """Places, shape (..., 3)."""
        return np.asarray(self._start.apply(self._own(along)))

    def _turns(self, along: Floats) -> transform.Rotation:
        return self._start * transform.Rotation.from_rotvec(along[:, None] * self._kappa)


class SplineCurve(SpaceCurve):
    """A cubic spline through points over the distances between them; its sections do not turn about it.

    Parameters
    ----------
    points : ndarray, shape (points, 3)
        Places [m], the first one the origin.
    """

    def __init__(self, points: Floats) -> None:
        at = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
        self._spline: Any = interpolate.make_interp_spline(at, points, k=3)
        fine = np.interp(np.linspace(0, len(at) - 1, _SAMPLES * (len(at) - 1) + 1), np.arange(len(at)), at)
        nodes, weights = np.polynomial.legendre.leggauss(4)
        half = np.diff(fine) / 2
        speeds = np.linalg.norm(self._spline(fine[:-1, None] + half[:, None] * (1 + nodes), 1), axis=-1)
        self._steps, self._parameters = np.append(0.0, np.cumsum(half * (speeds @ weights))), fine
        self.length = float(self._steps[-1])
        self._parameter_at: Any = interpolate.make_interp_spline(self._steps, fine, k=3)

    def places(self, along: Floats) -> Floats:
        """Places, shape (..., 3)."""
        return np.asarray(self._spline(self._parameter_at(along)))

    def _turns(self, along: Floats) -> transform.Rotation:
        return carried(transform.Rotation.identity(), self._spline(self._parameter_at(along), 1))


def carried(first: transform.Rotation, tangents: Iterable[Floats]) -> transform.Rotation:
    """Turns of sections square to tangents, which do not turn about them, from one that need not be square yet."""
    along = np.array([first.apply(np.array(_ALONG)), *tangents])
    # From each tangent to the next; then products of all before, of ever twice as many.
    found = least_turn(along[:-1], along[1:])
    behind = 1
    while behind < len(found):
        found = transform.Rotation.concatenate([found[:behind], found[behind:] * found[:-behind]])
        behind *= 2
    return found * first


def continuous(turns: transform.Rotation) -> Floats:
    """Quaternions w, x, y, z of neighbouring turns, without a change of sign, shape (..., 4)."""
    found: Floats = np.roll(turns.as_quat(), 1, axis=1)
    signs = np.where(np.sum(found[1:] * found[:-1], axis=1) < 0, -1.0, 1.0)
    found[1:] *= np.cumprod(signs)[:, None]
    return found


def least_turn(first: Floats, second: Floats) -> transform.Rotation:
    """Least turns that take directions into others, shape (..., 3); of opposite ones, about an axis across them."""
    a, b = (one / np.linalg.norm(one, axis=-1, keepdims=True) for one in (first, second))
    one_plus_cosine = 1 + np.sum(a * b, axis=-1, keepdims=True)
    across = np.cross(a, np.eye(3)[np.argmin(np.abs(a), axis=-1)])
    half_turn = np.concatenate([across, np.zeros_like(one_plus_cosine)], axis=-1)
    turn = np.concatenate([np.cross(a, b), one_plus_cosine], axis=-1)
    return transform.Rotation.from_quat(np.where(one_plus_cosine < _OPPOSITE, half_turn, turn))


def has_shape(scene: Tables) -> bool:
    """Tell whether `filament.shape` says anything but straight."""
    return scene.filament.shape != STRAIGHT


def is_curved(scene: Tables) -> bool:
    """Tell whether a relaxed filament is bent or twisted."""
    filament = scene.filament
    return filament.curvature != 0 or filament.twist != 0 or has_shape(scene)


@lru_cache(maxsize=64)
def _curve(shape: object, chord: Point, twist: float, curvature: float, rest_length: float | None) -> SpaceCurve:
    distance = math.hypot(*chord)
    if isinstance(shape, tuple):
        return SplineCurve(np.array(shape) - shape[0])
    if shape == HELIX:
        # Longest helix whose ends are so far apart: 4 R^2 sin^2(omega l/2) + (l twist/omega)^2 = distance^2.
        omega = math.hypot(curvature, twist)
        radius, climb = abs(curvature) / omega**2, abs(twist) / omega

        def beyond(length: float) -> float:
            return (2 * radius * math.sin(omega * length / 2)) ** 2 + (climb * length) ** 2 - distance**2

        longest, low = distance / climb, distance / climb
        while beyond(low) >= 0:
            low -= _STEP * min(longest, 1 / omega)
        length = _root(beyond, low, min(longest, low + _STEP * min(longest, 1 / omega)))
    elif rest_length is not None:
        half = _root(lambda x: math.sin(x) / x - distance / rest_length, 1e-9, math.pi)
        length, curvature = rest_length, 2 * half / rest_length
    else:
        length = 2 / abs(curvature) * math.asin(abs(curvature) * distance / 2)
    return SteadyCurve(length, np.array([twist, 0.0, curvature]), np.array(chord))


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    return float(optimize.brentq(function, low, high, xtol=1e-15 * high))


def natural_curve(scene: Tables) -> SpaceCurve:
    """Return the curve of a filament that has a shape, from its first end to its last one."""
    filament = scene.filament
    chord = (filament.span, 0.0 - scene.ends.drop, 0.0)
    return _curve(filament.shape, chord, filament.twist, filament.curvature, filament.rest_length)


def shape_rules(scene: Tables) -> Iterator[Rule]:
    """List what does not go with a shape."""
    filament, ends, out = scene.filament, scene.ends, "leaving it out"
    if not has_shape(scene):
        return
    shape = "through points" if isinstance(filament.shape, tuple) else filament.shape
    given = f"given, but filament.shape is {shape!r}"
    yield from if_given(scene, given, out, "initial.stretch", "initial.surface", "initial.centreline")
    yield from if_given(scene, f"{given}: a clamp holds its end as it is", out, "ends.left_angle", "ends.right_angle")
    yield from if_given(scene, given, out, "ends.right_slides")
    fluid = f"{shape!r}, but a fluid has no shape of its own: the law is '{scene.material.law}'"
    yield not scene.material.spec.is_elastic, "filament.shape", fluid, "another law"
    distance = math.hypot(filament.span, ends.drop)
    if shape == ARC:
        yield filament.twist, "filament.twist", "given, but filament.shape is 'arc'", "leaving it out, or 'helix'"
        both = filament.rest_length is not None and filament.curvature != 0
        none = filament.rest_length is None and filament.curvature == 0
        how = "filament.curvature, or filament.rest_length, one of them"
        yield both, "filament.shape", "'arc', with a curvature and a rest length, which need not agree", how
        yield none, "filament.shape", "'arc', but nothing says how much it is bent", how
        long = filament.rest_length is not None and filament.rest_length <= distance
        found = f"{filament.rest_length} m, no longer than the chord"
        yield long, "filament.rest_length", found, f"more than {distance} m"
        most = 2 / distance
        bent = abs(filament.curvature) > most
        yield bent, "filament.curvature", f"{filament.curvature} 1/m, of a circle smaller than the chord", f"{most} 1/m"
        return
    yield filament.rest_length is not None, "filament.rest_length", f"{given}, which has a length", out
    if shape == HELIX:
        yield from _of_turns(filament, distance)
        return
    yield from if_given(scene, given, out, "filament.curvature", "filament.twist")
    yield from misses_supports(scene, filament.shape, "filament.shape")  # type: ignore[arg-type]


def _of_turns(filament: Filament, distance: float) -> Iterator[Rule]:
    lacks = [name for name in ("curvature", "twist") if getattr(filament, name) == 0]
    yield lacks, "filament.shape", f"'helix' without {' and '.join(lacks)}", "filament.curvature and filament.twist"
    if lacks:
        return
    turns = distance * (filament.curvature / filament.twist * filament.curvature + filament.twist) / (2 * math.pi)
    accepted = f"a helix of at most {_TURNS} turns: less curvature, more twist, or a shorter span"
    yield abs(turns) > _TURNS, "filament.shape", f"'helix' of up to {abs(turns):.3g} turns", accepted


def misses_supports(scene: Tables, points: tuple[Point, ...], path: str) -> Iterator[Rule]:
    """List the ends that are held away from those of a curve."""
    ends, span = scene.ends, scene.filament.span
    places = (points[0], (0.0, 0.0, 0.0)), (points[-1], (span, 0.0 - ends.drop, 0.0))
    for (side, support, _), (found, asked) in zip(ends.sides, places, strict=True):
        missed = not support.is_free and math.dist(found, asked) > _APART * span
        given = f"a {side} end at {list(found)} m, but the support is at {list(asked)} m"
        yield missed, path, given, f"a curve that ends at its support, or a free {side} end"
