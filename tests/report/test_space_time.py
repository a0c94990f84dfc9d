"""Space-time maps show the fields where they are, and the mark stands at 90 % of the sag."""

from __future__ import annotations

import time
from io import BytesIO

import numpy as np
import pytest
from matplotlib.collections import QuadMesh
from matplotlib.colors import LogNorm
from PIL import Image

from softcat_sym.plotting.run import MAX_FRAMES, ROWS, maps_of, space_time_figure, time_to_nine_tenths
from softcat_sym.plotting.style import png


def meshes(figure) -> list[QuadMesh]:
    return [made for axes in figure.axes[:2] for made in axes.collections if isinstance(made, QuadMesh)]


def test_maps_hold_stretch_and_yielded_share(descent, summary, scene):
    figure = space_time_figure(descent, summary, scene)
    stretch, share = meshes(figure)
    lengths = np.hypot(np.diff(descent.x.values, axis=1), np.diff(descent.y.values, axis=1))
    per_cent = 100 * (lengths / np.diff(descent.X_node.values) - 1)
    # 240 rows over 160 equal cells: two rows whole, every third half in one cell and half in the next.
    drawn = stretch.get_array().T.reshape(201, 80, 3)
    np.testing.assert_allclose(drawn[:, :, ::2].reshape(201, 160), per_cent, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(drawn[:, :, 1], per_cent.reshape(201, 80, 2).mean(axis=2), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(share.get_array().T.mean(axis=1), descent.yielded_fraction.values.mean(axis=1))
    corners = stretch.get_coordinates()
    np.testing.assert_allclose(corners[:, 0, 1], np.linspace(-0.5, 0.5, ROWS + 1))
    np.testing.assert_allclose([corners[0, 0, 0], corners[0, 2, 0], corners[0, -1, 0]], [0, 0.015, 2])
    assert (share.norm.vmin, share.norm.vmax) == (0, 1)


def test_both_clamps_of_a_symmetric_filament_have_one_colour(descent, summary, scene):
    """Its last cells are thinner than a pixel: drawn as they are, one end would show and the other not."""
    half = 0.1 * (1 - np.linspace(1, 0, 81) ** 1.4)
    nodes = np.concatenate([-half[:0:-1], half])
    assert nodes[1] - nodes[0] < 0.2 / 400
    stretch = 1.001 * np.ones((201, 160))
    stretch[:, [0, -1]] = 2.0
    run = descent.assign(stretch=(("time", "cell"), stretch)).assign_coords(X_node=("node", nodes))
    figure = space_time_figure(run, summary, scene)
    low, high = figure.axes[0].get_ylim()
    assert low < -0.5 and high > 0.5, "the frame hides neither end"
    with Image.open(BytesIO(png(figure))) as image:
        pixels = np.asarray(image.convert("RGB")).astype(int)
    box = figure.axes[0].get_window_extent()
    across, tall = round(0.5 * (box.x0 + box.x1)), pixels.shape[0]
    rows = pixels[tall - int(box.y1) + 1 : tall - int(box.y0) - 1, across]
    bright = [int((end.sum(axis=1) > 400).sum()) for end in (rows[:8], rows[-8:])]
    assert bright[0] == bright[1] > 0


def test_the_mark_stands_where_the_sag_is_nine_tenths_of_the_last(descent, summary, scene):
    # sag ~ 1 - exp(-3 t), so exp(-3 t) = 1 - 0.9 (1 - exp(-6))
    exact = -np.log(1 - 0.9 * (1 - np.exp(-6))) / 3
    assert time_to_nine_tenths(descent) == pytest.approx(exact, rel=1e-4)
    axes = space_time_figure(descent, summary, scene).axes[0]
    assert axes.get_title(loc="left") == f"dashed: 90 % of the final sag at {exact:.3f} s"
    refused = space_time_figure(descent, summary | {"outcome": "localised"}, scene).axes[0]
    assert refused.get_title(loc="left") == ""


def test_a_filament_that_rises_or_rests_has_a_mark_or_none(descent):
    risen = descent.assign(midpoint=-descent.midpoint)
    assert time_to_nine_tenths(risen) == pytest.approx(time_to_nine_tenths(descent))
    assert time_to_nine_tenths(descent.assign(midpoint=0 * descent.midpoint)) is None


def test_without_a_yield_stress_the_second_map_is_the_stress(descent, make_scene):
    _, second = maps_of(descent, make_scene(law="maxwell", limit=None))
    np.testing.assert_allclose(second.values[:, 0], descent.stress_mean.values[:, 0] / 1e3)
    assert second.label == "mean stress [kPa]"


def test_a_few_hinges_do_not_take_the_colours_from_the_rest(descent, scene):
    stretch = 1 + 0.01 * np.linspace(0, 1, 201)[:, None] * np.ones((201, 160))
    stretch[:, 0] = 1.5
    first, _ = maps_of(descent.assign(stretch=(("time", "cell"), stretch)), scene)
    assert first.beyond
    assert 0.9 < first.norm.vmax <= 1.0  # per cent
    stretch[:] = np.geomspace(1, 900, 201)[:, None]
    first, _ = maps_of(descent.assign(stretch=(("time", "cell"), stretch)), scene)
    assert isinstance(first.norm, LogNorm)


def test_colours_that_count_powers_have_plain_numbers(descent, scene, summary, caplog):
    stretch = np.geomspace(1, 900, 201)[:, None] * np.ones((201, 160))
    figure = space_time_figure(descent.assign(stretch=(("time", "cell"), stretch)), summary, scene)
    with caplog.at_level("WARNING"):
        png(figure)
    shown = [text.get_text() for text in figure.axes[2].get_yticklabels()]
    assert {"10.0", "100"} <= set(shown)
    assert not any("$" in text for text in shown)
    assert caplog.records == []


def test_long_runs_are_thinned_to_the_pixels_there_are_and_cost_less_than_a_second(make_run, scene, summary):
    times = np.linspace(0, 2, 6001)
    run = make_run(scene, 0.05 * times / 2, times, cells=40)
    began = time.process_time()
    figure = space_time_figure(run, summary, scene)
    assert png(figure).startswith(b"\x89PNG")
    assert time.process_time() - began < 1.0
    assert meshes(figure)[0].get_array().shape[1] <= MAX_FRAMES


@pytest.mark.parametrize("frames", [1, 2])
def test_short_runs_are_drawn(descent, summary, scene, frames):
    assert png(space_time_figure(descent.isel(time=slice(0, frames)), summary, scene)).startswith(b"\x89PNG")
