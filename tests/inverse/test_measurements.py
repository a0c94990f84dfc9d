"""Measurements as arrays, and held against their scene."""

from __future__ import annotations

import copy
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

import softcat_sym as sc
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.fitting.measurements import Measurements, Series, Shapes
from softcat_sym.fitting.plausibility import checked, own_scene
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene
from tests.inverse.written_films import FALL, TIME

Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def scene() -> Scene:
    """Span 0.2 m, duration 2.86 s, sqrt(L/g) = 0.143 s."""
    return load_scene("maxwell-slow")


def of_checked(time: Floats, midpoint: Floats, scene: Scene) -> Series:
    return checked(Measurements.of(time, midpoint), scene).series[0]


@pytest.mark.parametrize(
    ("time", "midpoint", "std", "message"),
    [
        ([0, 1, 2], [0, 1, 2, 3, 4], None, r"time of shape \(3,\), midpoint of shape \(5,\)"),
        ([[0, 1], [2, 3]], [[0, 1], [2, 3]], None, "lists of the same length"),
        ("abc", [1.0], None, "time: not a list of numbers"),
        ([0, 1, 2, 3, np.nan], [0, 1, 2, np.inf, 4], [0, -1, 1, 1, 1], r"4 faults.*time\[4\].*std\[1\]: -1 is not pos"),
        ([0, 1, 2, 1, 4], [0, 1, 2, 3, 4], None, r"time\[3\]: 1 s after 2 s; .*Measurements.of sorts"),
        ([0, 1, 2, 2, 4], [0, 1, 2, 3, 4], None, r"time\[3\]: 2 s again; .*Measurements.of averages"),
        ([-1, 1, 2, 3, 4], [0, 1, 2, 3, 4], None, r"time\[0\]: -1 s, before the release"),
        ([0, 1, 2, 3], [0, 1, 2, 3], None, "4 distinct times"),
        ([], [], None, "0 distinct times"),
        ([0, 1, 2, 3, 4], [0.3] * 5, None, "0.3 m at every time"),
    ],
)
def test_a_bad_series_is_refused(time: object, midpoint: object, std: object, message: str) -> None:
    with pytest.raises(SoftcatError, match=rf"(?s)measurements: {message}|{message}"):
        Series(time, midpoint, std)  # type: ignore[arg-type]


def test_bad_shapes_and_no_series_are_refused() -> None:
    with pytest.raises(SoftcatError, match="0 m at every point"):
        Shapes([0.0] * 5, [1.0] * 5, [0.0] * 5)  # type: ignore[arg-type]
    with pytest.raises(SoftcatError, match="4 points; accepted: at least 5"):
        Shapes([0.0] * 4, [1, 2, 3, 4], [0, 1, 2, 3])  # type: ignore[arg-type]
    with pytest.raises(SoftcatError, match="at least one Series"):
        Measurements(())


def test_a_series_cannot_be_changed_and_can_be_copied() -> None:
    time = TIME.copy()
    series = Series(time, FALL, FALL * 0 + 1e-4)
    time[0] = 9
    assert series.time[0] == TIME[0]
    assert series.std is not None
    for values in (series.time, series.midpoint, series.std):
        with pytest.raises(ValueError, match="read-only"):
            values[0] = 9
    again = copy.deepcopy(series)
    np.testing.assert_array_equal(again.midpoint, FALL)


def test_arrays_are_corrected_as_files_are() -> None:
    time, height = np.append(TIME[::-1], [TIME[3], 2.0]), np.append(FALL[::-1], [FALL[3], np.nan])
    (series,) = Measurements.of(time, height, 1e-4, {"filament.span": "1 cm"}).series
    np.testing.assert_array_equal(series.time, TIME)
    np.testing.assert_allclose(series.midpoint, FALL, rtol=1e-15)
    assert series.std is not None
    np.testing.assert_allclose(series.std, np.where(TIME == TIME[3], 1e-4 / np.sqrt(2), 1e-4))
    assert [note.split()[0] for note in series.notes] == ["Left", "Sorted", "Averaged"]
    assert "index 21" in series.notes[0]
    assert series.overrides == {"filament.span": "1 cm"}
    masked = np.ma.masked_array(FALL, mask=TIME == TIME[5])
    assert Measurements.of(TIME, masked).series[0].time.size == TIME.size - 1
    with pytest.raises(SoftcatError, match=r"midpoint\[1\]: inf is not finite"):
        Measurements.of([1, 2], [3, np.inf])
    with pytest.raises(SoftcatError, match="std: not a list of numbers"):
        Measurements.of([1, 2], [3, 4], "few")


@pytest.mark.parametrize("name", ["maxwell-slow", "drawn-blob", "putty-arch", "curled-rod", "slack-taffy", "glass-rod"])
def test_what_a_scene_itself_does_is_neither_refused_nor_remarked_on(name: str) -> None:
    scene = load_scene(name, {"run.frames": 60, "numerics.cells": 12})
    data = sc.simulate(scene).data
    time, midpoint = np.asarray(data["time"]), np.asarray(data["midpoint"])
    series = of_checked(time, midpoint, scene)
    np.testing.assert_array_equal(series.midpoint, midpoint)
    assert series.notes == ()


@pytest.mark.parametrize("noise", [0.0, 5e-4])
def test_heights_that_count_downwards_are_turned_and_said(scene: Scene, noise: float) -> None:
    heights = FALL + noise * np.random.default_rng(1).standard_normal(TIME.size)
    turned = of_checked(TIME, -heights, scene)
    np.testing.assert_array_equal(turned.midpoint, heights)
    assert "Turned the sign of midpoint" in turned.notes[0]
    upright = of_checked(TIME, heights, scene)
    np.testing.assert_array_equal(upright.midpoint, heights)
    assert upright.notes == ()


def test_an_elastic_film_that_counts_downwards_is_turned_though_it_swings_back(scene: Scene) -> None:
    ringing = 0.005 * (1 - np.exp(-TIME) * np.cos(40 * TIME))
    np.testing.assert_array_equal(of_checked(TIME, ringing, scene).midpoint, -ringing)


def test_an_arch_may_stand_above_its_supports() -> None:
    arch = load_scene("putty-arch")
    np.testing.assert_array_equal(of_checked(TIME, 0.003 - FALL / 10, arch).midpoint, 0.003 - FALL / 10)


def test_heights_from_another_level_are_not_guessed_at(scene: Scene) -> None:
    with pytest.raises(SoftcatError, match=r"midpoint: above the supports' level and falling, from 0.09.* sag_m for"):
        of_checked(TIME, 0.1 + FALL, scene)
    astride = of_checked(TIME, 0.01 + FALL, scene)
    np.testing.assert_array_equal(astride.midpoint, 0.01 + FALL)
    assert "up to 0.00995 m above the supports' level" in astride.notes[0]


@pytest.mark.parametrize(
    ("time", "length", "message"),
    [
        (
            1.0,
            1000.0,
            r"midpoint: -20 m at 1 s, 100 times the 0.2 m .*-0.02 m would do, as of mm in a column named for m",
        ),
        (1.0, 1e9, r"-20 m would do|as of um|at most 2 m from the supports' level$"),
        (
            1000.0,
            1.0,
            r"time: the last is 1000 s, long after the scene.*1 s would do, as of ms in a column named for s",
        ),
        (1e-3, 1.0, r"time: the last is 0.001 s, before anything.*1 s would do, as of s in a column named for ms"),
        (
            5e-3,
            1.0,
            r"midpoint: moves by 0.01995 m within 0.005 s, in which a free body falls 0.000123 m.*as of s in a col",
        ),
    ],
    ids=["mm as m", "no unit does", "ms as s", "s as ms", "faster than free fall"],
)
def test_wrong_units_are_named(scene: Scene, time: float, length: float, message: str) -> None:
    with pytest.raises(SoftcatError, match=message):
        of_checked(time * TIME, length * FALL, scene)


@pytest.mark.parametrize(
    ("time", "midpoint", "remark"),
    [
        (TIME, 1e-6 * FALL, "less than is ever seen: right unit"),
        (TIME, 30 * FALL, "gets to -0.6 m, 3 times the length of the filament: right unit"),
        (TIME + 50, FALL, "begins at 50.05 s and is shorter than that: is time 0 the release"),
        (TIME / 40, FALL, "is time 0 the release, and the supports' level the zero"),
    ],
    ids=["small", "large", "late", "early"],
)
def test_what_is_odd_is_remarked_on_and_kept(scene: Scene, time: Floats, midpoint: Floats, remark: str) -> None:
    series = of_checked(time, midpoint, scene)
    np.testing.assert_array_equal(series.midpoint, midpoint)
    assert any(remark in note for note in series.notes)


def test_shapes_are_held_against_the_supports(scene: Scene) -> None:
    x = np.tile(np.linspace(-0.1, 0.1, 9), 2)
    shapes = Shapes(np.repeat([0.5, 1.0], 9), x, np.repeat([0.5, 1.0], 9) * -(0.01 - x**2))
    none = np.empty(0)

    def seen(shapes: Shapes) -> Series:
        return checked(Measurements((Series(none, none, shapes=shapes),)), scene).series[0]

    def y_of(series: Series) -> Floats:
        assert series.shapes is not None
        return series.shapes.y

    np.testing.assert_array_equal(y_of(seen(shapes)), shapes.y)
    turned = seen(replace(shapes, y=-shapes.y))
    np.testing.assert_array_equal(y_of(turned), shapes.y)
    assert "Turned the sign of y" in turned.notes[0]
    with pytest.raises(SoftcatError, match=r"x: from 0 m to 0.2 m; .*halfway between the supports; subtract 0.1 m\?"):
        seen(replace(shapes, x=x + 0.1))
    with pytest.raises(SoftcatError, match=r"x: from -100 m to 100 m.*as of mm in a column named for m"):
        seen(replace(shapes, x=1000 * x))
    with pytest.raises(SoftcatError, match="y: -10 m at 1 s"):
        seen(replace(shapes, y=1000 * shapes.y))


def test_a_slack_filament_may_bulge_beyond_its_supports() -> None:
    x = np.linspace(-0.115, 0.115, 9)
    series = Series(np.empty(0), np.empty(0), shapes=Shapes(0 * x + 1, x, x**2 - 0.014))
    assert checked(Measurements((series,)), load_scene("slack-taffy")).series[0].shapes is not None
    with pytest.raises(SoftcatError, match=r"x: from -0.115 m to 0.115 m"):
        checked(Measurements((series,)), load_scene("maxwell-slow"))


def test_each_filament_has_its_own_scene(scene: Scene) -> None:
    short = Series(TIME, FALL, overrides={"filament.span": "1 cm", "filament.thickness": "1 mm"})
    assert own_scene(short, scene).filament.span == 0.01
    assert own_scene(Series(TIME, FALL), scene) is scene
    both = Measurements((Series(TIME, 60 * FALL), Series(TIME, 60 * FALL, overrides=short.overrides)))
    # 1.2 m is 6 spans of the one, and 120 of the other.
    with pytest.raises(SoftcatError, match=r"120 times the 0.01 m") as refused:
        checked(both, scene)
    assert str(refused.value).count("fault") == 1
    with pytest.raises(SceneError, match=r"(?s)filament.thickness: '5 m' is not less.*material.viscosity: 'big'"):
        own_scene(Series(TIME, FALL, overrides={"filament.thickness": "5 m", "material.viscosity": "big"}), scene)
    with pytest.raises(SoftcatError, match="is not less than the span"):
        checked(Measurements((Series(TIME, FALL, overrides={"filament.thickness": "5 m"}),)), scene)
