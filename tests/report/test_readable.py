"""Every word of every picture can be read: none over another, none beyond the paper, no power of ten beside an axis."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np
import pytest
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from softcat_sym.plotting.run import FIGURES, midpoint_figure, shapes_figure, space_time_figure, styled_for
from softcat_sym.plotting.style import styled

TIMES = np.linspace(0, 2, 201)
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


def run_and_scene(name, make_run, make_scene):
    span, thickness, sags, times, limit = SCENES[name]
    scene = make_scene(title=name, span=span, thickness=thickness, law="bingham", limit=limit)
    return make_run(scene, sags, times, cells=60), scene


def words(figure: Figure) -> Iterator[tuple[str, Bbox]]:
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
        if text not in hidden and text.get_visible() and text.get_text().strip() and text.axes_visible:
            yield text.get_text(), text.get_window_extent()


@pytest.fixture(autouse=True)
def axes_visible(monkeypatch):
    """A text is not drawn where its axes or its axis are not."""

    def shown(text: Text) -> bool:
        return text.axes is None or (text.axes.get_visible() and text.axes.axison)

    monkeypatch.setattr(Text, "axes_visible", property(shown), raising=False)


def check(figure: Figure) -> None:
    shown = list(words(figure))
    assert len(shown) > 4
    paper = figure.bbox.padded(1.0)
    beyond = [text for text, box in shown if not (paper.contains(*box.min) and paper.contains(*box.max))]
    assert beyond == []
    over = [(a, b) for (a, one), (b, two) in combinations(shown, 2) if one.padded(-0.5).overlaps(two.padded(-0.5))]
    assert over == []
    offsets = [axis.get_offset_text().get_text() for axis in figure.findobj(Axis)]
    assert [text for text in offsets if text] == []


@pytest.mark.parametrize("draw", FIGURES.values())
@pytest.mark.parametrize("style", ["screen", "column", "page"])
@pytest.mark.parametrize("name", SCENES)
def test_pictures_can_be_read(make_run, make_scene, summary, name, style, draw):
    run, scene = run_and_scene(name, make_run, make_scene)
    with styled_for(style):
        check(draw(run, summary, scene, style))


def test_what_is_drawn_for_print_is_named(descent, summary, scene):
    midpoint, shapes = (draw(descent, summary, scene, "column") for draw in (midpoint_figure, shapes_figure))
    assert [text.get_text() for text in midpoint.legends[0].get_texts()] == ["midpoint", "shapes drawn"]
    assert [text.get_text().split(",")[0] for text in shapes.legends[0].get_texts()] == ["yielded: stress > 9.32 kPa"]


@pytest.mark.parametrize("style", ["screen", "column", "page"])
def test_panels_of_shapes_have_one_scale_and_equal_lengths(descent, summary, scene, style):
    with styled_for(style):
        figure = shapes_figure(descent, summary, scene, style)
        figure.canvas.draw()
    scales = []
    for axes in figure.axes:
        origin, right, up = axes.transData.transform([(0, 0), (1, 0), (0, 1)])
        scales += [(right - origin)[0], (up - origin)[1]]
    np.testing.assert_allclose(scales, scales[0], rtol=1e-3)


def test_numbers_that_hardly_differ_stand_whole_beside_their_axis(descent, summary, scene):
    with styled():
        figure = Figure()
        figure.add_subplot().plot([100000.1, 100000.2], [1.0000001, 1.0000002])
        figure.canvas.draw()
        assert [axis.get_offset_text().get_text() for axis in figure.findobj(Axis)] == ["", ""]
    barely = descent.assign(stretch=1 + 1e-4 * descent.yielded_fraction)
    assert space_time_figure(barely, summary, scene).axes[2].get_ylabel() == "stretch \N{MINUS SIGN} 1 [ppm]"
