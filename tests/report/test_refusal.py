"""A result that is refused says so across every picture, and its runaway scales no axis."""

from __future__ import annotations

import numpy as np
import pytest

from softcat_sym.plotting.animation import Animation
from softcat_sym.plotting.run import FIGURES, midpoint_figure, shapes_figure, write_pictures
from softcat_sym.plotting.style import refused, shown_part
from softcat_sym.solvers.outcome import Outcome

TIMES = np.linspace(0, 2, 201)


@pytest.fixture
def runaway(make_run, scene):
    """Free fall from 0.5 s on: 11 m deep in the end, of a filament of 0.2 m."""
    return make_run(scene, 0.01 + 4.905 * np.maximum(TIMES - 0.5, 0.0) ** 2, TIMES, cells=40)


def stamps(figure) -> list[str]:
    return [text.get_text() for text in figure.texts if text.get_text().startswith("REFUSED")]


def test_every_outcome_but_success_is_refused():
    for outcome in Outcome:
        assert refused({"outcome": outcome.name}) == ("" if outcome.is_success else outcome.name)
    assert refused({}) == refused({"outcome": ""}) == ""


@pytest.mark.parametrize("outcome", ["localised", "inaccurate", "solved"])
@pytest.mark.parametrize("style", ["screen", "column"])
@pytest.mark.parametrize("draw", FIGURES.values())
def test_pictures_are_stamped(descent, summary, scene, draw, style, outcome):
    figure = draw(descent, summary | {"outcome": outcome}, scene, style)
    assert stamps(figure) == ([] if outcome == "solved" else [f"REFUSED: {outcome}"])


def test_every_moment_of_a_film_is_stamped(descent, summary, scene):
    bad = Animation(descent, summary | {"outcome": "localised"}, scene, 3, width=640)
    good = Animation(descent, summary, scene, 3, width=640)
    assert stamps(bad.figure) == ["REFUSED: localised"]
    for number in range(3):
        differs = np.any(bad.picture(number) != good.picture(number), axis=2)
        assert differs[len(differs) // 3 : 2 * len(differs) // 3].mean() > 0.02


def test_the_stamp_lies_within_the_paper(descent, summary, scene):
    for draw in FIGURES.values():
        figure = draw(descent, summary | {"outcome": "no_equilibrium"}, scene)
        (stamp,) = (text for text in figure.texts if text.get_text().startswith("REFUSED"))
        box, paper = stamp.get_window_extent(), figure.bbox
        assert paper.x0 < box.x0 < box.x1 < paper.x1
        assert box.width > 0.4 * paper.width


def test_a_runaway_that_is_refused_scales_no_axis(runaway, summary, scene):
    bad = summary | {"outcome": "localised"}
    low = midpoint_figure(runaway, bad, scene).axes[0].get_ylim()[0]
    assert midpoint_figure(runaway, bad, scene).axes[0].get_ylabel() == "midpoint height [mm]"
    assert -300 < low < -100
    assert midpoint_figure(runaway, summary, scene).axes[0].get_ylim()[0] < -11
    assert min(axes.get_ylim()[0] for axes in shapes_figure(runaway, bad, scene).axes) > -300
    film = Animation(runaway, bad, scene, 5, width=640)
    assert film.times[-1] < 0.8
    assert film.axes.get_ylim()[0] > -300
    words = [text.get_text() for text in midpoint_figure(runaway, bad, scene).texts]
    assert "not drawn after 0.690 s: deeper than it is long" in words
    assert not any(text.get_text().startswith("final") for text in midpoint_figure(runaway, bad, scene).axes[0].texts)


def test_an_answer_is_drawn_whole_however_deep_it_hangs(runaway, summary):
    data, told = shown_part(runaway, summary)
    assert data.sizes["time"] == 201
    assert told == summary


def test_what_is_not_a_number_is_not_drawn(descent, summary):
    y = descent.y.values.copy()
    y[120:] = np.nan
    data, told = shown_part(descent.assign(y=(("time", "node"), y)), summary | {"outcome": "non_finite"})
    assert data.sizes["time"] == 120
    assert "not drawn after" in told["not_drawn"]


def test_the_table_keeps_every_frame(runaway, summary, scene, tmp_path):
    write_pictures(runaway, summary | {"outcome": "localised"}, scene, tmp_path)
    assert len((tmp_path / "midpoint.csv").read_text().splitlines()) == 202
