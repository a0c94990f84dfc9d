"""Checks of measurements against their scene: signs, units and clocks."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.fitting.measurements import Measurements, Series, Shapes, read_measurements
from softcat_sym.scene.scene import (
    Scene,
    gravity_time,
    groups_of,
    is_held,
    is_slack,
    stress_free_length,
)
from softcat_sym.scene.table_reader import refusal
from softcat_sym.scene.tables import farthest
from softcat_sym.scene.toml import read_overrides

Floats = NDArray[np.float64]

_REACH = 10.0
"""Largest plausible height, over the length of the filament or the distance of its supports, whichever is longer."""

_UNUSUAL, _INVISIBLE = 2.0, 1e-6
"""In the same unit: heights outside of this range are possible, but probably wrong."""

_SOONER, _LATER = 1e-2, 100.0
"""Plausible range of a film's times over a scene's. In a hundredth of sqrt(L/g) a body falls by L/20 000."""

# Share of the largest height that noise and a wrong zero may put on the other side of the supports' level.
_OTHER_SIDE = 0.2
# Share of the range of heights by which a falling midpoint differs from the settled one.
_FALLING = 0.1
# Multiples of free fall since time 0: beyond the first the release was earlier, beyond the second the film is wrong.
_EARLY, _IMPOSSIBLE = 4.0, 100.0
_BEYOND_THE_SUPPORTS = 1.1
_LENGTHS = ((1e-3, "mm", "m"), (1e-6, "um", "m"), (1e-2, "cm", "m"), (1e-1, "mm", "cm"))
_SHORTER_TIMES = ((1e-3, "ms", "s"), (1e-6, "us", "s"), (1 / 60, "s", "min"), (1 / 3600, "s", "h"))
_LONGER_TIMES = ((1e3, "s", "ms"), (60.0, "min", "s"), (3600.0, "h", "s"))


def checked(measurements: Measurements, scene: Scene) -> Measurements:
    """Check measurements against their scene, and return them with corrected signs and notes."""
    series, refused = [], []
    for one in measurements.series:
        try:
            series.append(_checked(one, own_scene(one, scene)))
        except SoftcatError as error:
            refused.append(str(error))
    if refused:
        raise SoftcatError("\n".join(refused))
    return Measurements(tuple(series))


def own_scene(series: Series, scene: Scene) -> Scene:
    """Return the scene of one filament: the common scene with this filament's own values."""
    changes, _ = read_overrides(series.overrides)
    if not changes:
        return scene
    try:
        return scene.replace({change.path: change.value for change in changes})
    except SceneError as error:
        raise SceneError(error.faults, f"of the filament in {series.path}" if series.path else "") from None


@dataclass(frozen=True, slots=True)
class _Track:
    """Heights over time of one point, or of the point of a shape that is farthest from the supports' level."""

    name: str
    time: Floats
    height: Floats


def _checked(series: Series, scene: Scene) -> Series:
    notes: list[str] = []
    faults: list[Fault] = []
    turn: dict[str, bool] = {}
    for track in _tracks(series):
        # In a photograph of the supports themselves up is up.
        if _sags(scene) and not (series.shapes and series.shapes.shows_supports):
            turn[track.name], note, fault = _sign(track)
            notes += note
            faults += fault
        for test in (_implausible_height, _implausible_times, _faster_than_free_fall):
            # A wrong unit is reported once.
            note, fault = test(track, scene) if not faults or test is _implausible_times else ([], [])
            notes += note
            faults += fault
    faults += _beside_the_supports(series.shapes, scene) if series.shapes is not None else []
    if faults:
        raise refusal("measurements", series.path, faults)
    midpoint, shapes = series.midpoint, series.shapes
    if turn.get("midpoint"):
        midpoint = 0.0 - midpoint
    if shapes is not None and turn.get("y"):
        shapes = replace(shapes, y=0.0 - shapes.y)
    return replace(series, midpoint=midpoint, shapes=shapes, notes=(*series.notes, *notes))


def _tracks(series: Series) -> Iterator[_Track]:
    if series.time.size:
        yield _Track("midpoint", series.time, series.midpoint)
    if series.shapes is not None:
        shapes = series.shapes
        by_depth = np.lexsort((-np.abs(shapes.y), shapes.time))
        time, first = np.unique(shapes.time[by_depth], return_index=True)
        yield _Track("y", time, shapes.y[by_depth][first])


def _sags(scene: Scene) -> bool:
    """Whether the filament hangs below its supports at all times, as nothing can lift it."""
    ends, filament = scene.ends, scene.filament
    bent = ends.left_angle > 0 or ends.right_angle < 0 or filament.curvature != 0 or any(scene.initial.C)
    return scene.load.gravity > 0 and scene.load.shake == 0 and not bent and ends.drop == 0 and not ends.motion


Findings = tuple[list[str], list[Fault]]


def _sign(track: _Track) -> tuple[bool, list[str], list[Fault]]:
    """Whether the heights have the wrong sign; notes and faults."""
    height = track.height
    top, bottom = float(height.max()), float(height.min())
    if top <= 0 or top <= -_OTHER_SIDE * bottom:
        return False, [], []
    if -bottom > _OTHER_SIDE * top:
        note = (
            f"The {track.name} is up to {top:g} m above the supports' level, where this filament never is: a sign or "
            "the zero of the heights may be wrong; nothing was changed."
        )
        return False, [note], []
    settled = float(height[-max(1, height.size // 3) :].mean())
    much = _FALLING * (top - bottom)
    # Lengths that count downwards start small and grow; a film that starts during the ringing starts in between.
    if height[0] - settled > much and height[0] > top - much:
        found = (
            f"above the supports' level and falling, from {height[0]:g} m to {height[-1]:g} m, while the filament sags"
        )
        accepted = "heights from the supports' level, negative below it; sag_m for lengths that count downwards"
        return False, [], [Fault(track.name, found, accepted)]
    note = (
        f"Turned the sign of {track.name}: it is above the supports' level throughout and goes away from it, while "
        "this filament sags."
    )
    return True, [note], []


def _implausible_height(track: _Track, scene: Scene) -> Findings:
    apart = farthest(scene)
    length = max(apart, stress_free_length(scene))
    worst = int(np.abs(track.height).argmax())
    height, time = float(track.height[worst]), float(track.time[worst])
    ratio = abs(height) / length
    if ratio > _REACH:
        found = f"{height:g} m at {time:g} s, {ratio:.3g} times the {length:g} m that the filament is long"
        hint = _in_another_unit(height, 1e-3 * length, length, _LENGTHS, "m")
        return [], [Fault(track.name, found, f"at most {_REACH * length:g} m from the supports' level{hint}")]
    if ratio > _UNUSUAL:
        found = f"reaches {height:g} m, {ratio:.3g} times the length of the filament"
        return [f"The {track.name} {found}: is the unit right?"], []
    if ratio < _INVISIBLE:
        found = f"never exceeds {abs(height):g} m, less than a camera can resolve"
        return [f"The {track.name} {found}: is the unit right?"], []
    return [], []


def _implausible_times(track: _Track, scene: Scene) -> Findings:
    first, last = float(track.time[0]), float(track.time[-1])
    fall, duration = gravity_time(scene), scene.run.duration
    groups = groups_of(scene)
    relaxation = fall * groups.tau_star if groups.tau_star and math.isfinite(fall) else 0.0
    shortest, longest = min(fall, duration), max(fall if math.isfinite(fall) else 0.0, duration, relaxation)
    known = f"the scene runs for {duration:g} s" + (f", sqrt(span/gravity) is {fall:.3g} s" if fall < math.inf else "")
    if last < _SOONER * shortest:
        hint = _in_another_unit(last, shortest, longest, _LONGER_TIMES, "s")
        found = f"the last time is {last:g} s, before any visible motion: {known}"
        return [], [Fault("time", found, f"times beyond {_SOONER * shortest:.3g} s{hint}")]
    if last > _LATER * longest:
        hint = _in_another_unit(last, shortest, longest, _SHORTER_TIMES, "s")
        found = f"the last time is {last:g} s, long after the end of the scene: {known}"
        accepted = f"times from the release up to {_LATER * longest:.3g} s, or a longer run.duration{hint}"
        return [], [Fault("time", found, accepted)]
    if track.time.size > 1 and first > last - first:
        return [f"The film begins at {first:g} s and is shorter than that: is time 0 the release?"], []
    return [], []


def _faster_than_free_fall(track: _Track, scene: Scene) -> Findings:
    """Check that the midpoint does not fall faster than a free body; if it does, its release was before time 0."""
    if not track.time[-1] > 0 or not _sags(scene) or not is_held(scene) or is_slack(scene):
        return [], []
    fallen = 0.5 * scene.load.gravity * track.time**2
    moved = float(np.ptp(track.height))
    if moved > _IMPOSSIBLE * fallen[-1]:
        last = float(track.time[-1])
        found = f"moves by {moved:g} m within {last:g} s, in which a free body falls {fallen[-1]:.3g} m"
        longer = _in_another_unit(last, math.sqrt(2 * moved / scene.load.gravity), math.inf, _LONGER_TIMES, "s")
        return [], [Fault(track.name, found, f"no more than free fall{longer}")]
    early = np.flatnonzero(np.abs(track.height) > _EARLY * fallen + _OTHER_SIDE * moved)
    if not early.size:
        return [], []
    k = int(early[0])
    note = (
        f"At {track.time[k]:g} s the {track.name} is at {track.height[k]:g} m already, while a free body released at "
        f"time 0 has fallen {fallen[k]:.3g} m: is time 0 the release, and the supports' level the zero of the heights?"
    )
    return [note], []


def _beside_the_supports(shapes: Shapes, scene: Scene) -> list[Fault]:
    span = scene.filament.span
    between = is_held(scene) and not is_slack(scene) and not scene.ends.motion
    most = 0.5 * span * _BEYOND_THE_SUPPORTS if between else _REACH * max(farthest(scene), stress_free_length(scene))
    left, right = float(shapes.x.min()), float(shapes.x.max())
    if max(-left, right) <= most:
        return []
    hint = f"; subtract {0.5 * (left + right):g} m?"
    if right - left > 2 * most:
        hint = _in_another_unit(right - left, 0.1 * span, 2 * most, _LENGTHS, "m")
    accepted = f"{-0.5 * span:g} m to {0.5 * span:g} m, counted from halfway between the supports{hint}"
    return [Fault("x", f"from {left:g} m to {right:g} m", accepted)]


def _in_another_unit(value: float, low: float, high: float, units: Sequence[tuple[float, str, str]], si: str) -> str:
    """Name the mistaken unit that would bring a value between two bounds; empty if none does."""
    for factor, meant, written in units:
        if low <= abs(value) * factor <= high:
            return f"; wrong unit? {value * factor:.4g} {si} would do, as of {meant} in a column named for {written}"
    return ""


Films = Measurements | str | os.PathLike[str] | Sequence[str | os.PathLike[str]]
"""Measurements, or one file for each filament."""


def taken(films: Films, scene: Scene) -> Measurements:
    """Return measurements, read from files if need be, after the checks against their scene."""
    read = films if isinstance(films, Measurements) else read_measurements(films)
    return checked(read, scene)
