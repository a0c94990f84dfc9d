"""Pictures of a run: geometry in closed form, values where they belong, words that can be read, whole files."""

from __future__ import annotations

import csv
import itertools
from collections.abc import Iterator, Mapping
from typing import Any

import matplotlib
import numpy as np
import pytest
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.image import PcolorImage
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from softcat_sym.plotting.run import (
    FIGURES,
    LINES,
    ROWS,
    maps_of,
    shapes_figure,
    space_time_figure,
)
from softcat_sym.plotting.section import (
    FilamentOutline,
    elastic_core,
    node_angles,
    outline,
    quads_outside,
    section_at,
)
from softcat_sym.plotting.style import (
    png,
    styled,
)
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


def scales(figure: Figure) -> np.ndarray:
    """Pixels per unit, across and up, of all drawn axes."""
    figure.canvas.draw()
    corners = [axes.transData.transform([(0, 0), (1, 0), (0, 1)]) for axes in figure.axes]
    return np.array([[(right - origin)[0], (up - origin)[1]] for origin, right, up in corners])


def words_of(figure: Figure) -> list[str]:
    return [text.get_text() for text in figure.findobj(Text)]


def test_shapes_have_equal_lengths_along_both_axes_or_say_their_stretch(scene, make_scene, make_run, descent, summary):
    found = scales(shapes_figure(descent, summary, scene))
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


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.slow
def test_every_word_can_be_read(make_run, make_scene, summary, name):
    """None over another, none beyond the paper, no power of ten beside an axis."""
    span, thickness, sags, times, limit = SCENES[name]
    scene = make_scene(title=f"$x^{{ {name} 漢", span=span, thickness=thickness, limit=limit)
    run = make_run(scene, sags, times, cells=60)
    for what, draw in FIGURES.items():
        with styled():
            figure = draw(run, summary, scene)
            shown = list(drawn_words(figure))
            assert len(shown) > 4
            paper = figure.bbox.padded(1.0)
            beyond = [text for text, box in shown if not (paper.contains(*box.min) and paper.contains(*box.max))]
            assert beyond == [], what
            assert overlapping(shown) == [], what
            assert not any(axis.get_offset_text().get_text() for axis in figure.findobj(Axis))


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
        for cells, of in ((1, scene), (20, still)):
            data = make_run(of, np.array(sags), np.array(times), cells)
            for draw in FIGURES.values():
                assert png(draw(data, summary, of)).startswith(b"\x89PNG"), name


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
