"""Pictures of a run: geometry in closed form, values where they belong, words that can be read, whole files."""

from __future__ import annotations

import csv
import itertools
import re
import subprocess
import sys
import zlib
from collections.abc import Iterator, Mapping
from importlib import import_module
from io import BytesIO
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.image import PcolorImage
from matplotlib.text import Text
from matplotlib.transforms import Bbox
from PIL import Image

import softcat_sym as sc
from softcat_sym import drawing, plotting
from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.run import (
    FIGURES,
    LINES,
    ROWS,
    energy_figure,
    maps_of,
    midpoint_figure,
    shapes_figure,
    space_time_figure,
    time_to_nine_tenths,
)
from softcat_sym.plotting.section import (
    FilamentOutline,
    Magnification,
    elastic_core,
    largest_sag,
    node_angles,
    outline,
    quads_outside,
    section_at,
    slowest_flow,
    telling_frames,
    yielding_of,
)
from softcat_sym.plotting.style import (
    STYLES,
    first_frames,
    picture_style,
    png,
    printed,
    refused,
    shown_part,
    styled,
)
from softcat_sym.plotting.time_axis import TimeAxis
from softcat_sym.plotting.units import (
    energy_unit,
    length_unit,
    nice_floor,
    significant,
    stress_unit,
    time_unit,
    typeset,
)
from softcat_sym.results.fields import audit_of, energy_imbalance
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.outcome import Outcome
from tests.common.catenary import descent, make_run, make_scene, scene, summary

__all__ = ["descent", "make_run", "make_scene", "scene", "summary"]

TIMES = np.linspace(0, 2, 201)
NAMES = ["midpoint.png", "shapes.png", "energy.png", "space-time.png", "midpoint.csv"]


def run_of(data: Mapping[str, np.ndarray], summary: dict[str, Any], scene: Scene) -> Run:
    return Run(scene, data, summary, Outcome[summary["outcome"]], {})


def yielded_quads(section: FilamentOutline, mean: np.ndarray, bending: np.ndarray, limit: float) -> np.ndarray:
    return quads_outside(section, *elastic_core(mean, bending, limit))


def area(polygon: np.ndarray) -> float:
    """Signed area by the shoelace formula, positive anticlockwise."""
    x, y = polygon[:, 0], polygon[:, 1]
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def arc(radius: float, half_angle: float, thickness: float, nodes: int = 401) -> FilamentOutline:
    """A circular arc that opens upwards: its normal points to the centre."""
    angle = np.linspace(-half_angle, half_angle, nodes)
    normal = np.column_stack([-np.sin(angle), np.cos(angle)])
    return FilamentOutline(radius * np.sin(angle), -radius * np.cos(angle), normal, np.full(nodes, thickness))


def test_outline_is_half_a_thickness_from_the_centreline_and_encloses_the_thickness(descent):
    for frame in (0, 40, 200):
        x, y = descent["x"][frame], descent["y"][frame]
        expected = float(np.sum(descent["thickness"][frame] * np.hypot(np.diff(x), np.diff(y))))
        assert area(outline(section_at(descent, frame))) == pytest.approx(expected, rel=2e-4)
    section = section_at(descent, 200)
    below, above = np.split(outline(section), 2)
    above, centre = above[::-1], np.column_stack([section.x, section.y])
    np.testing.assert_allclose(np.linalg.norm(above - centre, axis=1), section.thickness / 2, rtol=1e-12)
    np.testing.assert_allclose(above + below, 2 * centre, atol=1e-15)
    assert np.all(above[:, 1] > below[:, 1]), "zeta = +1 is the side of (-sin th, cos th): above"
    # The section in a clamp stays vertical.
    held = section_at(descent, 200, (True, False))
    np.testing.assert_allclose(held.normal[0], [0.0, 1.0], atol=1e-15)
    np.testing.assert_array_equal(held.normal[1:], section.normal[1:])
    assert abs(section.normal[0][0]) > 0.01


def test_node_angles_are_second_order_and_turn_past_the_vertical():
    errors = []
    for nodes in (41, 81):
        x = np.linspace(-1, 1, nodes)
        errors.append(np.abs(node_angles(x, np.cosh(x)) - np.arctan(np.sinh(x))).max())
    assert errors[1] < min(errors[0] / 3.5, 1e-3)
    angle = np.linspace(0, 1.9 * np.pi, 200)
    np.testing.assert_allclose(node_angles(np.sin(angle), -np.cos(angle)), angle, atol=1e-3)
    # A kink at the clamp does not turn the end face around.
    x, y = np.array([0.0, 1e-3, 1.0, 2.0]), np.array([0.0, -5.0, -5.0, -5.0])
    assert abs(node_angles(x, y)[0] + np.pi / 2) < 0.31


def test_elastic_core():
    # Every shaded point exceeds yield and no other does, but within rounding of the boundary.
    generator = np.random.default_rng(7)
    mean, bending = generator.normal(size=400), 3 * generator.normal(size=400)
    lower, upper = elastic_core(mean, bending, 1.0)
    zeta = np.linspace(-0.999, 0.999, 301)[:, None]
    shaded = (zeta < lower) | (zeta > upper)
    stress = np.abs(mean + bending * zeta)
    clear = np.abs(stress - 1.0) > 1e-9
    np.testing.assert_array_equal(shaded[clear], (stress > 1.0)[clear])
    # A cell beyond yield everywhere is shaded whole and once.
    section = arc(1.0, 0.5, 0.1, nodes=3)
    for mean, bending in itertools.product((3.0, -3.0), (0.0, 1.0, -1.0, 1e-320)):
        quads = yielded_quads(section, np.full(2, mean), np.full(2, bending), 1.0)
        assert sum(map(area, quads)) == pytest.approx(area(outline(section)), rel=1e-12)


def test_the_shaded_area_is_the_analytic_one(make_scene, make_run):
    """Stress Y(0.5 + 2 c zeta): the area fraction integrates (1 - core/2) over X.

    Tension beyond zeta = 0.5/|slope| where |slope| > 0.5, compression beyond 1.5/|slope| where |slope| > 1.5; with
    u = |slope| uniform on (0, 2) the fraction is 1/2 E[(1 - 0.5/u)+] + 1/2 E[(1 - 1.5/u)+].
    """
    straight, cells = make_scene(limit=1.0), 4000
    data = make_run(straight, np.zeros(1), np.zeros(1), cells)
    section = section_at(data, 0)
    quads = yielded_quads(section, np.full(cells, 0.5), 4.0 * data["X_cell"] / straight.filament.span, 1.0)
    tension = (1.5 - 0.5 * np.log(2 / 0.5)) / 2
    compression = (0.5 - 1.5 * np.log(2 / 1.5)) / 2
    share = sum(map(area, quads)) / area(outline(section))
    assert share == pytest.approx(0.5 * (tension + compression), rel=1e-4)
    # Of an arc, stress 0.8 + zeta (or its mirror) exceeds 1 beyond zeta = 0.2: a ring sector.
    radius, half_angle, thickness = 1.0, 0.6, 0.2
    section = arc(radius, half_angle, thickness)
    for side in (1, -1):
        quads = yielded_quads(section, np.full(400, 0.8), np.full(400, float(side)), 1.0)
        inner, outer = sorted(radius - side * thickness / 2 * zeta for zeta in (0.2, 1.0))
        assert sum(map(area, quads)) == pytest.approx(half_angle * (outer**2 - inner**2), rel=1e-5)


def test_yielded_is_what_flows_and_not_what_rests_on_the_yield_stress(descent, scene, make_scene):
    """Flow of a unit of strain in the first half; then specks of single frames, as a solver's tolerance makes them."""
    frame, cell = np.meshgrid(np.arange(201), np.arange(160), indexing="ij")
    moving = frame < 101
    specks = (frame > 120) & ((7 * frame + 13 * cell) % 29 == 0)
    rate = np.where(moving, 1.0, np.where(specks, 3e-3, 0.0))
    fraction = np.where(moving, 0.4, np.where(specks, 0.9, 0.0))
    run = descent | {
        "plastic_rate": rate,
        "yielded_fraction": fraction,
        "stress_mean": np.where(fraction > 0, 1.001, 0.999) * scene.material.yield_stress,
        "stress_bending": 0 * rate,
    }
    # A thousandth, the accuracy asked, of the strain of the run, in its two seconds.
    assert slowest_flow(run, scene) == pytest.approx(1e-3 * 1.0 / 2.0, rel=0.01)
    found = yielding_of(run, scene)
    np.testing.assert_array_equal(found.share, np.where(moving, 0.4, 0.0))
    np.testing.assert_array_equal(found.high - found.low, np.where(moving, 0.0, 2.0))
    slow = run | {"plastic_rate": np.where(moving, 1.0, 1e-3)}
    np.testing.assert_array_equal(yielding_of(slow, scene).share, fraction)
    for limit in (None, 1e9):
        found = yielding_of(descent | {"yielded_fraction": 0 * fraction}, make_scene(limit=limit))
        assert quads_outside(section_at(descent, 200), found.low[200], found.high[200]).shape == (0, 4, 2)
        assert not found.share.any()


def test_frames_are_spent_where_the_shape_changes(scene, make_run):
    def frames(sags: np.ndarray, times: np.ndarray = TIMES) -> list[int]:
        return telling_frames(make_run(scene, sags, times))

    steady = frames(0.05 * TIMES / 2)
    assert len(steady) == 5 and steady == sorted(steady) and steady[-1] == 200
    assert np.diff(0.05 * TIMES[[0, *steady]] / 2).min() > 0.1 * 0.05
    early = frames(np.where(TIMES < 0.2, 0.05 * TIMES / 0.2, 0.05))
    assert early[-1] == 200 and all(TIMES[frame] < 0.2 for frame in early[:-1])
    for count, expected in ((1, [0]), (2, [1]), (3, [1, 2])):
        times = np.linspace(0, 1, count)
        assert frames(0.04 * times + 0.01, times) == expected
    assert frames(0 * TIMES) == [200]
    sags = 0.01 - 0.01 * np.cos(9 * TIMES)
    assert np.ptp(np.append(sags[frames(sags)], sags[0])) > 0.9 * np.ptp(sags)


def test_what_is_too_flat_to_see_is_magnified(scene, make_scene, make_run):
    """Of thick strands the sag alone, about the line between their ends; both factors are stated."""
    factors = {(0.05, 0.01): "", (0.02, 0.01): "", (0.0, 0.01): "", (0.01, 0.01): "sag and thickness × 10"}
    factors |= {(0.01, 0.2): "sag × 10", (1e-3, 0.02): "sag × 100, thickness × 5", (1e-9, 0.3): "sag × 1000"}
    assert {key: str(Magnification.of(*key, 1.0)) for key in factors} == factors
    thick = make_scene(span=0.2, thickness=0.03)
    figure = shapes_figure(make_run(thick, 4e-4 * TIMES / 2, TIMES), {}, thick)
    assert "x [mm] (sag × 50)" in words_of(figure)
    across, up = scales(figure)[-1]
    body = np.array(figure.axes[-1].patches[0].get_xy())
    middle = len(body) // 4
    lower, upper = body[middle, 1], body[len(body) - 2 - middle, 1]
    # In pixels: 30 mm thick as across, the sag 50 times as much; y in mm is that of the centreline.
    assert (upper - lower) * up == pytest.approx(30 * across, rel=2e-3)
    assert ((upper + lower) / 2, up / across) == (pytest.approx(-0.4, rel=2e-3), pytest.approx(50, rel=1e-3))
    y = make_run(scene, np.array([0.0, 0.01]), np.array([0.0, 1.0]))["y"]
    assert largest_sag(y + np.linspace(0, 1, y.shape[1])) == pytest.approx(0.01)


def scales(figure: Figure) -> np.ndarray:
    """Pixels per unit, across and up, of all drawn axes."""
    figure.canvas.draw()
    corners = [axes.transData.transform([(0, 0), (1, 0), (0, 1)]) for axes in figure.axes]
    return np.array([[(right - origin)[0], (up - origin)[1]] for origin, right, up in corners])


def words_of(figure: Figure) -> list[str]:
    return [text.get_text() for text in figure.findobj(Text)]


def test_shapes_have_equal_lengths_along_both_axes_or_say_their_stretch(scene, make_scene, make_run, descent, summary):
    for style in ("screen", "column", "page"):
        with styled(style):
            found = scales(shapes_figure(descent, summary, scene, style))
        np.testing.assert_allclose(found, found[0, 0], rtol=1e-3)
    thin = make_scene(span=0.2, thickness=1e-3)
    flat = shapes_figure(make_run(thin, 1e-3 * TIMES / 2, TIMES), {}, thin)
    found = scales(flat)
    np.testing.assert_allclose(found[:, 1] / found[:, 0], 20.0, rtol=1e-3)
    assert "x [mm] (sag and thickness × 20)" in words_of(flat)
    # A deep sag is laid side by side.
    deep = shapes_figure(make_run(scene, 4.4 * (TIMES / 2) ** 2, TIMES), {}, scene)
    found = scales(deep)
    np.testing.assert_allclose(found, found[0, 0], rtol=1e-3)
    places = [axes.get_position() for axes in deep.axes]
    assert all(left.x1 < right.x0 for left, right in itertools.pairwise(places))
    assert max(deep.get_size_inches()) < 9


def test_everything_drawn_lies_within_its_panel_and_says_its_time(descent, scene, make_scene):
    figure = shapes_figure(descent, {}, scene)
    figure.canvas.draw()
    for axes, frame in zip(figure.axes, telling_frames(descent), strict=True):
        vertices = np.concatenate([patch.get_path().vertices for patch in axes.patches])
        for (low, high), values in zip((axes.get_xlim(), axes.get_ylim()), vertices.T, strict=True):
            assert low < values.min() < values.max() < high
        assert float(axes.get_title("left").split()[2]) == pytest.approx(descent["time"][frame])
    plain = shapes_figure(descent, {}, make_scene(law="maxwell", limit=None))
    assert "law “maxwell”: no yield stress" in words_of(plain)
    assert all(len(collection.get_paths()) == 0 for axes in plain.axes for collection in axes.collections)


def test_the_midpoint_ends_with_the_run_and_has_the_papers_dimensionless_axes(descent, summary, scene):
    early = first_frames(descent, 38)
    axes = midpoint_figure(early, summary, scene).axes[0]
    assert axes.get_xlabel() == "time [ms]"
    assert axes.get_xlim() == pytest.approx((0.0, 370.0))
    time, height = axes.lines[1].get_data()
    np.testing.assert_allclose(np.interp(1e3 * early["time"], time, height), 1e3 * early["midpoint"], atol=1e-9)
    axes, top = midpoint_figure(descent, summary, scene).axes
    (right,) = axes.child_axes
    right.figure.canvas.draw()
    assert (axes.get_ylabel(), right.get_ylabel()) == ("midpoint height [mm]", "midpoint height [% of L]")
    np.testing.assert_allclose(np.array(right.get_ylim()) * 2.0, axes.get_ylim())
    # t sqrt(E/rho)/L of 2 s, the paper's 10 alpha = 460 nearly
    assert top.get_xlim()[1] == pytest.approx(2.0 * np.sqrt(4e6 / 1900) / 0.2)


def test_an_axis_shows_the_part_in_which_something_happens():
    """A quarter of 1 - exp(-t) is done after ln 4/3 = 0.29, half after ln 2; of log(1 + 100 t) after 0.08."""
    even = np.linspace(0, 60, 20001)
    arrested = TimeAxis.of(even, 1 - np.exp(-even))
    assert (arrested.even, arrested.unit.symbol, arrested.is_even) == (0.2, "s", False)
    assert arrested.label == "time [s], logarithmic after 0.2 s"
    # By three time constants it has moved by 95 %.
    assert 0.4 < arrested.place(3.0) < 0.6
    assert TimeAxis.of(even, np.log1p(even / 1e-2)).even == pytest.approx(0.05)
    for steady in (even, np.sqrt(even), np.cos(20 * even), np.zeros(20001), (even / 60) ** (1 / 3)):
        assert TimeAxis.of(even, steady).is_even
    np.testing.assert_allclose(arrested.place(arrested.times(np.linspace(0, 1, 99))), np.linspace(0, 1, 99), atol=1e-12)
    for axis in (arrested, TimeAxis.of(np.linspace(0, 7200, 201), -(np.linspace(0, 7200, 201) > 0).astype(float))):
        ticks = np.array(axis.ticks(8, axis.unit.size))
        assert 4 < len(ticks) < 14 and ticks[0] == 0 and ticks[-1] <= axis.end / axis.unit.size
        assert np.diff(axis.place(ticks * axis.unit.size)).min() > 0.08
    one = TimeAxis.of(np.array([3.0]), np.array([1.0]))
    assert one.is_even and one.columns(np.array([3.0]), np.ones((1, 5))).shape == (1, 5)


def test_ringing_is_drawn_from_all_that_is_known_of_it(descent, summary, scene):
    """Five frames for each period of a cosine, and its turning points."""
    frames = np.linspace(0, 4, 101)
    turns = np.stack([np.arange(1, 40) / 10, 1e-3 * np.cos(np.pi * np.arange(1, 40))], axis=1)
    time, height = TimeAxis.of(frames).between(frames, 1e-3 * np.cos(10 * np.pi * frames)[:, None], turns)
    missed = np.abs(height[:, 0] - 1e-3 * np.cos(10 * np.pi * time))[(time > 0.1) & (time < 3.9)]
    assert missed.max() < 0.06e-3 and np.ptp(height) == pytest.approx(2e-3)
    # What only rises does so between frames too, and no corner of a fall that ends at once is passed.
    time, height = TimeAxis.of(frames).between(frames, np.minimum(frames, 1.0)[:, None])
    assert np.diff(height[:, 0]).min() >= -1e-14 and height.max() <= 1.0 + 1e-14
    # A run's midpoint and energies at more times than the frames are drawn at these.
    dense = np.linspace(0, 2, 1001)
    more = {"dense_time": dense, "dense_midpoint": -1e-3 * np.sin(99 * dense), "dense_energy_elastic": np.sin(dense)}
    held = {f"dense_{name}": np.interp(dense, TIMES, descent[name]) for name in audit_of(descent)}
    lines = midpoint_figure({**descent, **held, **more}, summary, scene).axes[0].lines
    np.testing.assert_allclose(np.interp(dense, *lines[1].get_data()), 1e3 * more["dense_midpoint"], atol=1e-6)
    drawn = {
        line.get_label(): line.get_data() for line in energy_figure(descent | held | more, summary, scene).axes[0].lines
    }
    np.testing.assert_allclose(np.interp(dense, *drawn["elastic"]), 1e6 * np.sin(dense), rtol=1e-6)


def test_energies_have_one_unit_and_the_imbalance_is_what_is_missing(descent, summary, scene):
    upper, lower = energy_figure(descent, summary, scene).axes
    assert (upper.get_ylabel(), lower.get_ylabel()) == ("energy [µJ]", "imbalance [ppm]")
    drawn = {line.get_label(): np.interp(TIMES, *line.get_data()) for line in upper.lines}
    np.testing.assert_allclose(drawn["potential"], 1e6 * descent["energy_potential"], rtol=1e-9)
    assert {"kinetic", "elastic", "dissipated", "external work"} < set(drawn)
    imbalance, largest = energy_imbalance(descent)
    np.testing.assert_allclose(lower.lines[0].get_ydata(), 1e6 * imbalance / largest)


def test_every_column_of_the_audit_is_drawn_by_its_name(descent, summary, scene):
    """Those of effects too, whatever their names; what is nothing at all times is left out."""
    held = {**descent, "energy_elastic_foundation": 0.1 * descent["energy_elastic"]}
    lines = {str(line.get_label()): line for line in energy_figure(held, summary, scene, "column").axes[0].lines}
    shown = np.interp(TIMES, *lines["elastic foundation"].get_data())
    np.testing.assert_allclose(shown, 1e6 * held["energy_elastic_foundation"], rtol=1e-9)
    assert "gradient" not in lines


def test_shapes_are_drawn_swollen(descent, summary, scene):
    """About the same centreline, by as much as is asked and said."""
    plain, swollen = (shapes_figure(descent, summary, scene, radius=radius) for radius in (1.0, 5.0))
    (thin, thick) = (np.array(figure.axes[-1].patches[0].get_xy()) for figure in (plain, swollen))
    middle = len(thin) // 4
    across = [np.ptp(body[[middle, len(body) - 2 - middle], 1]) for body in (thin, thick)]
    assert across[1] == pytest.approx(5 * across[0], rel=1e-6)
    words = [text.get_text() for text in swollen.findobj(Text)]
    assert any("thickness × 5" in text for text in words) and not any("true thickness" in text for text in words)
    with pytest.raises(SoftcatError, match="radius: -1; accepted: a positive factor"):
        shapes_figure(descent, summary, scene, radius=-1.0)


def maps_in(figure: Figure) -> list[PcolorImage]:
    return [image for axes in figure.axes for image in axes.images]


def test_maps_hold_stretch_and_yielded_share_or_stress(descent, summary, scene, make_scene, make_run):
    stretch, share = maps_in(space_time_figure(descent, summary, scene))
    per_cent, columns = 100 * (descent["stretch"] - 1), stretch.get_array().shape[1]
    # 240 rows over 160 equal cells: every third row lies half in one cell and half in the next.
    at, rows = (np.arange(columns) + 0.5) * 2 / columns, per_cent.reshape(201, 80, 2).mean(axis=2)
    expected = np.array([np.interp(at, TIMES, row) for row in rows.T])
    np.testing.assert_allclose(stretch.get_array()[1::3], expected, rtol=1e-9, atol=1e-9)
    assert abs(share.get_array().mean() - descent["yielded_fraction"].mean()) < 3e-3
    np.testing.assert_allclose(stretch._Ay, np.linspace(-0.5, 0.5, ROWS + 1))
    np.testing.assert_allclose(stretch._Ax[[0, -1]], [0, 2])
    assert (share.norm.vmin, share.norm.vmax) == (0, 1)
    _, second = maps_of(descent, make_scene(law="maxwell", limit=None))
    np.testing.assert_allclose(second.values[:, 0], descent["stress_mean"][:, 0] / 1e3)
    assert second.label == "mean stress [kPa]"


def test_both_clamps_of_a_symmetric_filament_have_one_colour(descent, summary, scene):
    """Its last cells are thinner than a pixel: drawn as they are, one end would show and the other not."""
    half = 0.1 * (1 - np.linspace(1, 0, 81) ** 1.4)
    nodes = np.concatenate([-half[:0:-1], half])
    stretch = 1.001 * np.ones((201, 160))
    stretch[:, [0, -1]] = 2.0
    figure = space_time_figure(descent | {"stretch": stretch, "X_node": nodes}, summary, scene)
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
    assert time_to_nine_tenths(descent | {"midpoint": -descent["midpoint"]}) == pytest.approx(exact, rel=1e-4)
    assert time_to_nine_tenths(descent | {"midpoint": 0 * descent["midpoint"]}) is None
    axes = space_time_figure(descent, summary, scene).axes[0]
    assert axes.get_title(loc="left") == f"dashed: 90 % of the final sag at {exact:.3f} s"
    bad = space_time_figure(descent, summary | {"outcome": "localised"}, scene).axes[0]
    assert bad.get_title(loc="left") == ""


def test_a_few_hinges_do_not_take_the_colours_from_the_rest(descent, summary, scene):
    stretch = 1 + 0.01 * np.linspace(0, 1, 201)[:, None] * np.ones((201, 160))
    stretch[:, 0] = 1.5
    first, _ = maps_of(descent | {"stretch": stretch}, scene)
    assert first.beyond and 0.9 < first.norm.vmax <= 1.0  # per cent
    stretch[:] = np.geomspace(1, 900, 201)[:, None]
    figure = space_time_figure(descent | {"stretch": stretch}, summary, scene)
    png(figure)
    assert {"10.0", "100"} <= set(words_of(figure)) and not any("$" in text for text in words_of(figure))


HELD = 1 - np.exp(-3 * TIMES)
# Span, thickness [m], sag [m] of every frame, times [s], yield stress [Pa]: the bundled scenes' like, and worse.
SCENES = {
    "arrested": (0.2, 6e-3, 0.0131 * HELD, TIMES, 9.32e3),
    "ink": (5e-3, 4e-4, 1.69e-4 * HELD, 0.25 * TIMES, 346.0),
    "rings": (0.2, 6e-3, 0.004 * (1 - np.cos(60 * TIMES)), TIMES, 9.32e3),
    "creeps": (0.2, 1e-3, 8.9e-3 * HELD, 1.43 * TIMES, None),
    "glass": (0.05, 3e-3, 8.6e-6 * TIMES / 2, 3600 * TIMES, None),
    "deep": (0.08, 1e-2, 0.06 * HELD, 0.3 * TIMES, 1e3),
    "at-rest": (0.2, 6e-3, 0 * TIMES, TIMES, 9.32e3),
}


def drawn_words(figure: Figure) -> Iterator[tuple[str, Bbox]]:
    """Every text that is drawn, and its box [pixel]; of tick labels those within the axis."""
    figure.canvas.draw()
    hidden: set[Text] = set()
    for axis in figure.findobj(Axis):
        low, high = sorted(axis.get_view_interval())
        room = 1e-9 * (high - low)
        for tick in [*axis.get_major_ticks(), *axis.get_minor_ticks()]:
            if not low - room <= tick.get_loc() <= high + room:
                hidden |= {tick.label1, tick.label2}
    for text in figure.findobj(Text):
        shown = text.axes is None or (text.axes.get_visible() and text.axes.axison)
        if shown and text not in hidden and text.get_visible() and text.get_text().strip():
            yield text.get_text(), text.get_window_extent()


def overlapping(shown: list[tuple[str, Bbox]]) -> list[tuple[str, str]]:
    pairs = itertools.combinations(shown, 2)
    return [(a, b) for (a, one), (b, two) in pairs if one.padded(-0.5).overlaps(two.padded(-0.5))]


def test_shapes_are_as_large_as_they_can_be_and_side_by_side_have_numbers_apart(make_run, make_scene, summary):
    low = make_run(make_scene(span=0.06, thickness=8e-3), 9e-3 * TIMES, TIMES, cells=60)
    below = shapes_figure(low, summary, make_scene(span=0.06, thickness=8e-3))
    assert len({axes.get_position().y0 for axes in below.axes}) == len(below.axes) == 5
    run = make_run(make_scene(span=0.06, thickness=8e-3), 9e-2 * TIMES, TIMES, cells=60)
    figure = shapes_figure(run, summary, make_scene(span=0.06, thickness=8e-3))
    assert len({axes.get_position().y0 for axes in figure.axes}) == 1 < len(figure.axes)
    assert overlapping(list(drawn_words(figure))) == []


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.slow
def test_every_word_can_be_read(make_run, make_scene, summary, name):
    """None over another, none beyond the paper, no power of ten beside an axis."""
    span, thickness, sags, times, limit = SCENES[name]
    scene = make_scene(title=f"$x^{{ {name} 漢", span=span, thickness=thickness, limit=limit)
    run = make_run(scene, sags, times, cells=60)
    for style, (what, draw) in itertools.product(("screen", "column", "page"), FIGURES.items()):
        with styled(style):
            figure = draw(run, summary, scene, style)
            shown = list(drawn_words(figure))
            assert len(shown) > 4
            paper = figure.bbox.padded(1.0)
            beyond = [text for text, box in shown if not (paper.contains(*box.min) and paper.contains(*box.max))]
            assert beyond == [], (what, style)
            assert overlapping(shown) == [], (what, style)
            assert not any(axis.get_offset_text().get_text() for axis in figure.findobj(Axis))


def stamps(figure: Figure) -> list[Text]:
    return [text for text in figure.texts if text.get_text().startswith("REFUSED")]


def test_pictures_of_what_is_refused_are_stamped_within_the_paper(descent, summary, scene):
    for outcome in Outcome:
        assert refused({"outcome": outcome.name}) == ("" if outcome.is_answer else outcome.name)
    assert refused({}) == refused({"outcome": ""}) == ""
    for draw, style in itertools.product(FIGURES.values(), ("screen", "column")):
        assert stamps(draw(descent, summary, scene, style)) == []
        figure = draw(descent, summary | {"outcome": "no_equilibrium"}, scene, style)
        (stamp,) = stamps(figure)
        assert stamp.get_text() == "REFUSED: no_equilibrium"
        box, paper = stamp.get_window_extent(), figure.bbox
        assert paper.x0 < box.x0 < box.x1 < paper.x1
        assert box.width > 0.4 * paper.width


def test_a_runaway_that_is_refused_scales_no_axis_and_an_answer_is_drawn_whole(
    make_run, descent, summary, scene, tmp_path
):
    """Free fall from 0.5 s on: 11 m deep in the end, of a filament of 0.2 m."""
    runaway = make_run(scene, 0.01 + 4.905 * np.maximum(TIMES - 0.5, 0.0) ** 2, TIMES, cells=40)
    bad = summary | {"outcome": "localised"}
    figure = midpoint_figure(runaway, bad, scene)
    assert figure.axes[0].get_ylabel() == "midpoint height [mm]"
    assert -300 < figure.axes[0].get_ylim()[0] < -100
    assert midpoint_figure(runaway, summary, scene).axes[0].get_ylim()[0] < -11
    assert min(axes.get_ylim()[0] for axes in shapes_figure(runaway, bad, scene).axes) > -300
    assert "not drawn after 0.690 s: deeper than it is long" in words_of(figure)
    assert not any(text.startswith("final") for text in words_of(figure))
    assert shown_part(runaway, summary) == (runaway, summary)
    y = descent["y"].copy()
    y[120:] = np.nan
    data, about = shown_part(descent | {"y": y}, summary | {"outcome": "non_finite"})
    assert len(data["time"]) == 120 and "not drawn after" in about["not_drawn"]
    run_of(runaway, bad, scene).write(tmp_path)
    table = (tmp_path / "midpoint.csv").read_text().splitlines()
    assert (table[0], len(table)) == ("time_s,midpoint_m,refused", 202)


@pytest.mark.slow
def test_files_are_whole_the_table_reads_back_exactly_and_the_caller_s_style_stays(descent, summary, scene, tmp_path):
    folder = tmp_path / "new" / "out"
    (tmp_path / "new").mkdir()
    with matplotlib.rc_context({"font.size": 17.0, "axes.grid": True}):
        before = matplotlib.rcParams.copy()
        paths = run_of(descent, summary, scene).write(folder)
        assert matplotlib.rcParams.copy() == before
    assert [path.name for path in paths] == NAMES
    assert sorted(path.name for path in folder.iterdir()) == sorted(NAMES)
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in paths[:4])
    with paths[4].open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    np.testing.assert_array_equal([float(row["time_s"]) for row in rows], descent["time"])
    np.testing.assert_array_equal([float(row["midpoint_m"]) for row in rows], descent["midpoint"])
    taken = tmp_path / "taken"
    (taken / "shapes.png").mkdir(parents=True)
    with pytest.raises(OSError, match=r"shapes\.png"):
        run_of(descent, summary, scene).write(taken)
    assert [path.name for path in taken.iterdir()] == ["shapes.png"]
    less = {name: values for name, values in descent.items() if name != "stretch"}
    with pytest.raises(KeyError):
        run_of(less, summary, scene).write(tmp_path / "nowhere")
    assert not (tmp_path / "nowhere").exists()


@pytest.mark.slow
def test_whatever_a_run_leaves_is_drawn_without_a_warning(scene, summary, make_run, make_scene):
    cases = {
        "one frame": ([0.01], [0.0]),
        "one frame at rest": ([0.0], [0.0]),
        "minute": ([0.0, 1e-9], [0.0, 1e-7]),
        "at rest": ([0.0, 0.0, 0.0], [0.0, 1.0, 2.0]),
        "huge": ([0.0, 1e9], [0.0, 1e9]),
        "runaway": ([0.0, 0.01, 1e100], [0.0, 1.0, 2.0]),
        "ended early": ([0.0, 0.004, 0.01], [0.0, 0.013, 0.0171]),
    }
    still = make_scene(limit=None, law="elastic")
    for name, (sags, times) in cases.items():
        for cells, of, style in ((1, scene, "screen"), (20, still, "column")):
            data = make_run(of, np.array(sags), np.array(times), cells)
            for draw in FIGURES.values():
                with styled(style):
                    assert png(draw(data, summary, of, style)).startswith(b"\x89PNG"), name


def test_what_draws_loads_no_more_than_it_needs():
    code = (
        "import sys, softcat_sym.plotting, softcat_sym.plotting.terminal, softcat_sym.plotting.files\n"
        "assert not {'matplotlib', 'rich', 'casadi', 'sympy', 'xarray', 'jinja2'} & set(sys.modules)\n"
        "import softcat_sym.plotting.run\n"
        "assert not {'matplotlib.pyplot', 'casadi', 'sympy', 'pandas', 'scipy'} & set(sys.modules)\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


def test_each_result_that_plotting_knows_is_drawn_by_the_module_that_it_names(descent):
    with pytest.raises(SoftcatError, match="no plot of a dict: there are some of Run, Fit, ClosedForm"):
        plotting.plot(descent)
    for module in plotting.DRAWN_IN.values():
        import_module(f"softcat_sym.plotting.{module}")
    drawers = plotting.plot.registry | drawing.report.registry
    found = {kind.__name__: draw.__module__.rpartition(".")[2] for kind, draw in drawers.items()}
    assert found == plotting.DRAWN_IN | {"object": "drawing"}


@pytest.mark.slow
def test_results_show_themselves_in_a_notebook(tmp_path: Path) -> None:
    changes = {"numerics.cells": 6, "numerics.estimate": False, "run.frames": 11, "run.effects": "paper"}
    scene = sc.load_scene("no-yield", changes)
    run = sc.simulate(scene)
    assert all(run.plot(what).axes for what in FIGURES) and list(run.figures()) == list(FIGURES)
    np.testing.assert_array_equal(run.to_frame()["midpoint_m"], run.fields["midpoint"])
    assert run.to_dict() == run.summary
    with pytest.raises(SoftcatError, match="no picture 'moment': there are midpoint, shapes, energy, space-time"):
        run.plot("moment")
    sweep = sc.sweep(scene, {"material.youngs_modulus": ["2 MPa", "4 MPa"]}, tmp_path)
    assert "2 filaments" in repr(sweep)
    for shown in (run, sweep):
        text = shown._repr_html_()
        assert text.startswith("<pre>") and "data:image/png;base64," in text
        assert any(name in text for name in ("no-yield", scene.title, "No yield"))
    assert "youngs_modulus" in scene._repr_html_()


# Machado, Oliveira and Fernandes (2009), severity 1, in linear RGB.
DEUTERANOPIA = [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
PROTANOPIA = [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
XYZ = [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
D65 = np.array([0.95047, 1.0, 1.08883])


def lab(colour: str, eye: list[list[float]]) -> np.ndarray:
    """L*, a*, b* of a colour as such an eye sees it (IEC 61966-2-1, CIE 1976)."""
    rgb = np.array(matplotlib.colors.to_rgb(colour))
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    ratio = np.array(XYZ) @ np.clip(np.array(eye) @ linear, 0, 1) / D65
    f = np.where(ratio > (6 / 29) ** 3, np.cbrt(ratio), ratio / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def closest(colours: list[str], eye: list[list[float]]) -> float:
    return min(float(np.linalg.norm(lab(a, eye) - lab(b, eye))) for a, b in itertools.combinations(colours, 2))


def test_the_colour_blind_tell_all_series_from_each_other_and_from_the_paper():
    series = [colour for colour, _ in LINES]
    for eye in (DEUTERANOPIA, PROTANOPIA):
        # A difference of 2.3 is just seen (Mahy, Van Eycken and Oosterlinck 1994); this is seven times as much.
        assert closest([*series, "#ffffff"], eye) > 16
        # The measure itself: red and green of equal lightness, which such an eye confuses.
        assert closest(["#d62728", "#8c6d1f"], eye) < closest(["#d62728", "#8c6d1f"], np.eye(3).tolist()) / 2
    assert len({line for _, line in LINES[1:]}) == len(LINES) - 1


@pytest.mark.parametrize(("width", "millimetres"), [("column", 84.0), ("page", 174.0)])
@pytest.mark.slow
def test_pdfs_are_as_wide_as_asked_and_hold_truetype(descent, summary, scene, tmp_path, width, millimetres):
    before = matplotlib.rcParams.copy()
    run_of(descent, summary, scene).write(tmp_path, name=width)
    assert matplotlib.rcParams.copy() == before, "the style of the caller stays"
    written = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert set(written) == {f"{name}.{ending}" for name in FIGURES for ending in ("pdf", "png")} | {"midpoint.csv"}
    for content in (written[name] for name in written if name.endswith("pdf")):
        box = re.search(rb"/MediaBox \[ *([\d.]+) ([\d.]+) ([\d.]+) ([\d.]+) *\]", content)
        assert box is not None
        assert float(box[3]) / 72 * 25.4 == pytest.approx(millimetres, abs=0.05)
        assert float(box[4]) / 72 * 25.4 < 235
        assert b"/FontFile2" in content and b"/CIDFontType2" in content and b"/Type3" not in content
        streams = [
            zlib.decompressobj().decompress(one)
            for one in re.findall(rb"stream\r?\n(\x78.*?)\r?\nendstream", content, re.S)
        ]
        sizes = {float(size) for one in streams for size in re.findall(rb"/F\d+ ([\d.]+) Tf", one)}
        assert sizes and min(sizes) >= 7 and max(sizes) <= 8


def test_the_same_figure_gives_the_same_bytes_and_styles_have_names(descent, scene):
    def twice() -> dict[str, bytes]:
        with styled("column"):
            assert matplotlib.rcParams["font.size"] == 8
            return printed("space-time", space_time_figure(descent, {}, scene, "column"), 400)

    assert twice() == twice()
    assert {asked: picture_style(asked) for asked in STYLES}["publication"] == "column"
    with pytest.raises(SoftcatError, match="--style: no style 'jfm'; accepted: screen, publication"):
        picture_style("jfm")


def test_units_and_numbers_read_well():
    lengths = {0.2: "mm", 1.0: "m", 0.999999999999: "m", -0.013: "mm", 4.4e-5: "µm", 3e-8: "nm", 1e-15: "nm"}
    times = {2.0: "s", 0.5: "ms", 290: "s", 300: "min", 1e4: "min", 2e4: "h", 0.0: "s"}
    for choose, symbols in ((length_unit, lengths), (time_unit, times), (energy_unit, {2.5e-4: "µJ"})):
        assert {value: choose(value).symbol for value in symbols} == symbols
    assert length_unit(0.0, fallback=0.2).symbol == "mm"
    units = {
        "Pa*s": "Pa·s",
        "m/s^2": "m/s²",
        "mm^3": "mm³",
        "1/s": "s⁻¹",
        "1/m^2": "m⁻²",
        "Pa*s^0.5": "Pa·s^0.5",
        "m": "m",
    }
    assert {unit: typeset(unit) for unit in units} == units
    minus = "\N{MINUS SIGN}"
    for value, text in ((9.32e3, "9.32 kPa"), (4e6, "4.00 MPa"), (200.0, "200 Pa"), (-7e10, f"{minus}70.0 GPa")):
        assert stress_unit(value).text(value) == text
    texts = {0.0: "0", 12.345: "12.3", 99.96: "100", 0.0666: "0.0666", -0.24409: f"{minus}0.244", 4.01e-5: "4.01e-05"}
    texts |= {1e12: "1.00e+12", float("inf"): "inf"}
    assert {value: significant(value) for value in texts} == texts and significant(-0.0) == "0"
    for value, floor in ((10.6, 10), (2.0, 2), (0.02 / 0.01, 2), (4.99, 2), (0.07, 0.05)):
        assert nice_floor(value) == pytest.approx(floor)
