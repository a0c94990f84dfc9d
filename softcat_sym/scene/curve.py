"""A curve in space with turns of sections along it: of constant twist and curvature, or through points."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_interp_spline
from scipy.spatial.transform import Rotation

Floats = NDArray[np.float64]

_SAMPLES = 50
"""Pieces of the curve between two given points, over which its length is summed."""
_OPPOSITE = 1e-14
_FIRST = np.array([1.0, 0.0, 0.0])


class SpaceCurve(ABC):
    """Places and turns of sections by the length along a curve [m]; it begins at the origin."""

    length: float
    _steps: Floats  # Lengths along the curve, near enough to each other to follow its turns

    @abstractmethod
    def places(self, along: Floats) -> Floats:
        """Places, shape (..., 3)."""

    @abstractmethod
    def _turns(self, along: Floats) -> Rotation: ...

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
        around = np.sin(angle) * (_FIRST - straight) + (1 - np.cos(angle)) * np.cross(axis, _FIRST)
        found: Floats = s * straight + around / self._omega
        return found

    def places(self, along: Floats) -> Floats:
        """Places, shape (..., 3)."""
        return np.asarray(self._start.apply(self._own(along)))

    def _turns(self, along: Floats) -> Rotation:
        return self._start * Rotation.from_rotvec(along[:, None] * self._kappa)


class SplineCurve(SpaceCurve):
    """A cubic spline through points over the distances between them; its sections do not turn about it.

    Parameters
    ----------
    points : ndarray, shape (points, 3)
        Places [m], the first one the origin.
    """

    def __init__(self, points: Floats) -> None:
        at = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1)))
        self._spline: Any = make_interp_spline(at, points, k=3)
        fine = np.interp(np.linspace(0, len(at) - 1, _SAMPLES * (len(at) - 1) + 1), np.arange(len(at)), at)
        nodes, weights = np.polynomial.legendre.leggauss(4)
        half = np.diff(fine) / 2
        speeds = np.linalg.norm(self._spline(fine[:-1, None] + half[:, None] * (1 + nodes), 1), axis=-1)
        self._steps, self._parameters = np.append(0.0, np.cumsum(half * (speeds @ weights))), fine
        self.length = float(self._steps[-1])
        self._parameter_at: Any = make_interp_spline(self._steps, fine, k=3)

    def places(self, along: Floats) -> Floats:
        """Places, shape (..., 3)."""
        return np.asarray(self._spline(self._parameter_at(along)))

    def _turns(self, along: Floats) -> Rotation:
        return carried(Rotation.identity(), self._spline(self._parameter_at(along), 1))


def carried(first: Rotation, tangents: Iterable[Floats]) -> Rotation:
    """Turns of sections square to tangents, which do not turn about them, from one that need not be square yet."""
    along = np.array([first.apply(_FIRST), *tangents])
    # From each tangent to the next; then products of all before, of ever twice as many.
    found = least_turn(along[:-1], along[1:])
    behind = 1
    while behind < len(found):
        found = Rotation.concatenate([found[:behind], found[behind:] * found[:-behind]])
        behind *= 2
    return found * first


def continuous(turns: Rotation) -> Floats:
    """Quaternions w, x, y, z of neighbouring turns, without a change of sign, shape (..., 4)."""
    found: Floats = np.roll(turns.as_quat(), 1, axis=1)
    signs = np.where(np.sum(found[1:] * found[:-1], axis=1) < 0, -1.0, 1.0)
    found[1:] *= np.cumprod(signs)[:, None]
    return found


def least_turn(first: Floats, second: Floats) -> Rotation:
    """Least turns that take directions into others, shape (..., 3); of opposite ones, about an axis across them."""
    a, b = (one / np.linalg.norm(one, axis=-1, keepdims=True) for one in (first, second))
    one_plus_cosine = 1 + np.sum(a * b, axis=-1, keepdims=True)
    across = np.cross(a, np.eye(3)[np.argmin(np.abs(a), axis=-1)])
    half_turn = np.concatenate([across, np.zeros_like(one_plus_cosine)], axis=-1)
    turn = np.concatenate([np.cross(a, b), one_plus_cosine], axis=-1)
    return Rotation.from_quat(np.where(one_plus_cosine < _OPPOSITE, half_turn, turn))
