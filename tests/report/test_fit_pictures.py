"""Pictures of a fit: room for every word, ticks to read, and bands and curves that are what they say."""

from __future__ import annotations

import itertools
import logging
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

import softcat_sym as sc
from softcat_sym.fitting.fit import FitOutcome
from softcat_sym.plotting import style
from softcat_sym.plotting.fit_figures import (
    JOINT,
    correlation_figure,
    curves_figure,
    model_bands,
    profiles_figure,
    smooth,
    starts_figure,
    unit_ellipse,
)
from softcat_sym.plotting.style import png
from tests.inverse.filmed import film, scene

FIGURES: dict[str, Callable[[sc.Fit], Figure]] = {
    "curves": curves_figure,
    "profiles": profiles_figure,
    "starts": starts_figure,
    "correlation": correlation_figure,
}


@pytest.fixture(scope="module")
def fitted() -> sc.Fit:
    return sc.fit(sc.Measurements.of(*film(), std=5e-4), scene(), ["yield_stress", "viscosity"], starts=2)


@pytest.mark.parametrize("name", FIGURES)
def test_every_word_is_on_the_paper_and_on_no_other(
    name: str, fitted: sc.Fit, caplog: pytest.LogCaptureFixture
) -> None:
    long = replace(fitted, scene=fitted.scene.model_copy(update={"title": "$x$ 世 " + 12 * "a very long title "}))
    worst = replace(long, outcome=FitOutcome.not_identified, checks=replace(long.checks, verdict="cannot tell"))
    figure = FIGURES[name](replace(worst, noise=9.99e-4, noise_known=False))
    with caplog.at_level(logging.WARNING):
        assert png(figure).startswith(b"\x89PNG")
    # A font that is missing is said there, and so is mathtext, which asks for many.
    assert not caplog.records
    boxes = []
    for text in figure.findobj(Text):
        box = text.get_window_extent()
        if not (text.get_visible() and text.get_text().strip()) or not _inside_limits(text, figure):
            continue
        assert box.x0 >= 0 and box.y0 >= 0, text
        assert box.x1 <= figure.bbox.width and box.y1 <= figure.bbox.height, text
        boxes.append((text.get_text(), box))
    for (one, a), (other, b) in itertools.combinations(boxes, 2):
        assert not a.overlaps(b), (one, other)
    for axes in figure.axes:
        assert not axes.xaxis.get_offset_text().get_text() and not axes.yaxis.get_offset_text().get_text()


def _inside_limits(text: Text, figure: Figure) -> bool:
    """Whether a label is one that is drawn: ticks beyond the limits are kept, but not shown."""
    for axes in figure.axes:
        for axis, low, high in ((axes.xaxis, *axes.get_xlim()), (axes.yaxis, *axes.get_ylim())):
            for tick in axis.get_major_ticks():
                if text is tick.label1 or text is tick.label2:
                    return min(low, high) <= tick.get_loc() <= max(low, high)
    return True


def test_parameter_axes_have_two_ticks_at_least(fitted: sc.Fit) -> None:
    for axes in (*profiles_figure(fitted).axes, *starts_figure(fitted).axes):
        low, high = axes.get_xlim()
        assert sum(low <= place <= high for place in axes.xaxis.get_majorticklocs()) >= 2


def test_the_band_is_what_the_covariance_makes_of_the_model(fitted: sc.Fit) -> None:
    """Against draws of the parameters: the half-width is 1.96 standard deviations of what the model then says."""
    draws = np.random.default_rng(3).multivariate_normal(
        fitted.starts.best.q, fitted.information.covariance, size=120, method="cholesky"
    )
    curves = np.array([fitted.problem.curves(q)[0] for q in draws])
    (band,) = model_bands(fitted)
    # 120 draws tell a standard deviation to 6.5 %; the readings share them.
    ratio = band / (fitted.information.quantile * curves.std(axis=0))
    assert np.median(ratio) == pytest.approx(1, abs=0.15)
    assert np.all((ratio > 0.6) & (ratio < 1.6))


def test_the_curve_of_a_profile_goes_through_its_points(fitted: sc.Fit) -> None:
    for one in fitted.profiles:
        q, increase = smooth(one)
        for at, value in zip(one.q, one.increase, strict=True):
            assert increase[np.argmin(np.abs(q - at))] == pytest.approx(value, rel=1e-6, abs=1e-9)
        assert np.all(np.diff(q) > 0)


@pytest.mark.parametrize("r", [-0.999, -0.4, 0.0, 0.7])
def test_the_ellipse_is_that_of_the_correlation(r: float) -> None:
    x, y = unit_ellipse(r)
    np.testing.assert_allclose((x**2 - 2 * r * x * y + y**2) / (1 - r**2), 1, rtol=1e-9)
    pairs = np.random.default_rng(1).multivariate_normal([0, 0], [[1, r], [r, 1]], size=20000).T
    inside = (pairs[0] ** 2 - 2 * r * pairs[0] * pairs[1] + pairs[1] ** 2) / (1 - r**2) < JOINT
    assert inside.mean() == pytest.approx(0.95, abs=0.006)


def test_a_parameter_of_no_correlation_and_films_of_one_sort_are_drawn(fitted: sc.Fit) -> None:
    unknown = replace(fitted, correlation=np.full((2, 2), np.nan), profiles=())
    words = [text.get_text() for text in correlation_figure(unknown).findobj(Text)]
    assert "–" in words
    with style.styled():
        correlation_figure(unknown).draw_without_rendering()
