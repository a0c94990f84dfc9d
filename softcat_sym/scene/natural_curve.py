"""The curve that a filament follows without stress: straight, an arc, a helix, or through given points."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from functools import lru_cache
from typing import TYPE_CHECKING

from softcat_sym.lazy import lazy_imports
from softcat_sym.scene.parts import if_given
from softcat_sym.scene.shapes import ARC, HELIX, STRAIGHT
from softcat_sym.scene.tables import Tables

if TYPE_CHECKING:
    from softcat_sym.scene.parts import Filament, Point, Rule

# Most scenes are read without NumPy and SciPy.
with lazy_imports():
    import numpy as np
    from scipy import optimize

    from softcat_sym.scene import curve as curves

_STEP = 0.05
"""Part of a turn, over 2 pi, by which the end of a helix is sought."""
_TURNS = 1000
"""Of a helix: each takes tens of cells."""
_APART = 1e-9
"""Part of the span by which a curve may miss a support."""


def has_shape(scene: Tables) -> bool:
    """Tell whether `filament.shape` says anything but straight."""
    return scene.filament.shape != STRAIGHT


def is_curved(scene: Tables) -> bool:
    """Tell whether a relaxed filament is bent or twisted."""
    filament = scene.filament
    return filament.curvature != 0 or filament.twist != 0 or has_shape(scene)


@lru_cache(maxsize=64)
def _curve(shape: object, chord: Point, twist: float, curvature: float, rest_length: float | None) -> curves.SpaceCurve:
    distance = math.hypot(*chord)
    if isinstance(shape, tuple):
        return curves.SplineCurve(np.array(shape) - shape[0])
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
    return curves.SteadyCurve(length, np.array([twist, 0.0, curvature]), np.array(chord))


def _root(function: Callable[[float], float], low: float, high: float) -> float:
    return float(optimize.brentq(function, low, high, xtol=1e-15 * high))


def natural_curve(scene: Tables) -> curves.SpaceCurve:
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
