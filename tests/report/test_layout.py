"""Frames chosen and scales drawn."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from matplotlib.text import Text

from softcat_sym.plotting.run import shapes_figure
from softcat_sym.plotting.section import telling_frames, vertical_stretch

TIMES = np.linspace(0, 2, 201)


def inches_per_metre(axes, millimetres=True) -> tuple[float, float]:
    """Scale of drawn axes, from their transform: what a ruler on the picture would find."""
    origin, right, up = axes.transData.transform([(0, 0), (1, 0), (0, 1)]) / axes.figure.dpi
    per = 1e3 if millimetres else 1.0
    return per * (right - origin)[0], per * (up - origin)[1]


def test_a_steady_descent_is_cut_into_falling_steps(scene, make_run):
    data = make_run(scene, 0.05 * (TIMES / 2), TIMES)
    frames = telling_frames(data)
    assert len(frames) == 5
    assert frames == sorted(frames)
    assert frames[-1] == 200
    drops = np.diff(-data["midpoint"].values[[0, *frames]])
    assert drops.min() > 0.1 * 0.05


def test_frames_are_spent_where_the_sag_changes(scene, make_run):
    sags = np.where(TIMES < 0.2, 0.05 * TIMES / 0.2, 0.05)
    frames = telling_frames(make_run(scene, sags, TIMES))
    assert frames[-1] == 200
    assert all(TIMES[frame] < 0.2 for frame in frames[:-1])


@pytest.mark.parametrize(("count", "expected"), [(1, [0]), (2, [1]), (3, [1, 2])])
def test_short_runs(scene, make_run, count, expected):
    times = np.linspace(0, 1, count)
    assert telling_frames(make_run(scene, 0.04 * times + 0.01, times)) == expected


def test_a_filament_at_rest_is_drawn_once(scene, make_run):
    assert telling_frames(make_run(scene, 0 * TIMES, TIMES)) == [200]


def test_an_oscillation_shows_both_turning_points(scene, make_run):
    sags = 0.01 - 0.01 * np.cos(9 * TIMES)
    frames = telling_frames(make_run(scene, sags, TIMES))
    shown = np.append(sags[frames], sags[0])
    assert np.ptp(shown) > 0.9 * np.ptp(sags)


@pytest.mark.parametrize(
    ("sag", "thickness", "factor"), [(0.05, 0.01, 1), (0.02, 0.01, 1), (0.01, 0.01, 10), (0.0, 0.01, 1), (0.01, 0.2, 1)]
)
def test_vertical_stretch(sag, thickness, factor):
    assert vertical_stretch(sag, thickness, 1.0) == factor


def test_a_flat_filament_is_stretched_by_the_factor_that_is_said(make_scene, make_run):
    scene = make_scene(span=0.2, thickness=1e-3)
    figure = shapes_figure(make_run(scene, 1e-3 * TIMES / 2, TIMES), {}, scene)
    figure.canvas.draw()
    for axes in figure.axes:
        horizontal, vertical = inches_per_metre(axes)
        assert vertical / horizontal == pytest.approx(20.0)
    assert "x [mm] (vertical scale × 20, thickness too)" in [text.get_text() for text in figure.findobj(Text)]


def test_a_deep_sag_is_laid_side_by_side_at_equal_aspect(scene, make_run):
    figure = shapes_figure(make_run(scene, 4.4 * (TIMES / 2) ** 2, TIMES), {}, scene)
    figure.canvas.draw()
    scales = np.array([inches_per_metre(axes, millimetres=False) for axes in figure.axes])
    np.testing.assert_allclose(scales, scales[0, 0], rtol=1e-9)
    places = [axes.get_position() for axes in figure.axes]
    assert all(left.x1 < right.x0 for left, right in pairwise(places))
    assert max(figure.get_size_inches()) < 9


def test_everything_drawn_lies_within_its_panel_and_says_its_time(descent, scene):
    figure = shapes_figure(descent, {}, scene)
    times = []
    for axes, frame in zip(figure.axes, telling_frames(descent), strict=True):
        low, high = axes.get_ylim()
        vertices = np.concatenate([patch.get_path().vertices for patch in axes.patches])
        assert low < vertices[:, 1].min() < vertices[:, 1].max() < high
        assert axes.get_xlim()[0] < vertices[:, 0].min() < vertices[:, 0].max() < axes.get_xlim()[1]
        times.append(float(axes.get_title("left").split()[2]))
        assert times[-1] == pytest.approx(float(descent["time"].values[frame]))
    assert times == sorted(times)


def test_a_law_without_yield_stress_is_said_to_shade_nothing(make_scene, descent):
    figure = shapes_figure(descent, {}, make_scene(law="maxwell", limit=None))
    assert "law “maxwell”: no yield stress" in [text.get_text() for text in figure.findobj(Text)]
    assert all(len(collection.get_paths()) == 0 for axes in figure.axes for collection in axes.collections)
