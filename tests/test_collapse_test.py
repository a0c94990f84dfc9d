"""The collapse test: contours are read, levelled and measured; the closed formula is exact where nothing bends."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.collapse_test import closed_form, level, measurements_of, read_contour
from softcat_sym.fitting.likelihood import shape_covariance
from tests.common.draws import shares
from tests.common.in_process import Softcat
from tests.common.strand import YIELD_STRESS, photograph, strand, write

SPANS = (2e-3, 4e-3, 6e-3)


def _parabola(span: float, sag: float) -> tuple[np.ndarray, np.ndarray]:
    x = np.linspace(-span / 2, span / 2, 401)
    return x, -sag * (1 - (2 * x / span) ** 2)


LINES = [_parabola(span, span / 10) for span in SPANS]


@pytest.mark.parametrize("tilt", [0.0, 0.03, -0.06])
@pytest.mark.parametrize("steps", [(), (0.2e-3, 0.2e-3, 0.0)], ids=["level pillars", "unequal pillars"])
def test_a_tilted_photograph_is_turned_level(tmp_path: Path, tilt: float, steps: tuple[float, ...]) -> None:
    """Pillars that differ in height but do not rise on the whole are no tilt."""
    seen = read_contour(write(tmp_path / "contour.csv", *photograph(LINES, SPANS, noise=0, tilt=tilt, steps=steps)))
    gaps, found = level(seen)
    # Pillars are equally many on either side, but not equally far.
    assert found == pytest.approx(tilt, abs=2e-2 if steps else 1e-6)
    heights = [0.0, *(steps or (0.0,) * 3)]
    for k, (gap, span) in enumerate(zip(gaps, SPANS, strict=True)):
        rise = (heights[k] - heights[k + 1]) / span
        assert gap.span == pytest.approx(span, rel=1e-3)
        assert gap.drop / gap.span == pytest.approx(rise - (tilt - found), abs=1.2e-2 if steps else 1e-5)
        assert gap.sag == pytest.approx(span / 10, rel=0.02)
        # Two thirds of the rectangle.
        assert gap.area == pytest.approx(2 / 3 * span**2 / 10, rel=5e-3)


def test_the_closed_formula_is_exact_for_a_string(tmp_path: Path) -> None:
    """A parabola of sag f has the slope 4 f/L at its edge, where the stress along it carries half of the weight.

    The angle is that of a line through an eighth of the gap, whose middle is a sixteenth from the edge.
    """
    seen = read_contour(write(tmp_path / "contour.csv", *photograph(LINES, SPANS, noise=0)))
    for gap, span in zip(level(seen)[0], SPANS, strict=True):
        slope = 4 * 0.1
        exact = 2000 * 9.81 * span / (2 * np.sin(np.arctan(slope)))
        found = closed_form(gap, strand(span))
        assert found is not None and exact < found < 1.1 * exact


@pytest.mark.statistical
def test_a_strand_that_does_not_sag_has_no_closed_formula(tmp_path: Path) -> None:
    straight, count = (np.array([-1.0, 1.0]), np.zeros(2)), 100

    def of(noise: float, tilt: float, seed: int) -> float | None:
        points = photograph([straight], (4e-3,), noise=noise, tilt=tilt, seed=seed)
        return closed_form(level(read_contour(write(tmp_path / "contour.csv", *points)))[0][0], strand(4e-3))

    assert of(0.0, 0.0, 0) is None
    # Three standard errors of the level, which are right within 6 %: one photograph in 400 seems to sag.
    seeming = sum(of(2e-6, 0.03, seed) is not None for seed in range(count))
    assert seeming / count <= shares(count, norm.sf(3 / 1.06))[1]


def test_an_outline_has_the_centre_line_between_its_edges(tmp_path: Path) -> None:
    """Both edges in one go around, and a file in pixels, which count downwards."""
    x, y, gaps = photograph(LINES, SPANS, noise=0, tilt=0.0)
    around = np.concatenate([x, x[::-1]]), np.concatenate([y + 0.2e-3, y[::-1] - 0.2e-3])
    pixel = 20e-6
    lines = ["# camera.pixel = 20 um", *(f"# pillars.gap = {a / pixel}, {b / pixel}" for a, b in gaps), "x_px,y_px"]
    lines += [f"{a / pixel!r},{-b / pixel!r}" for a, b in zip(*(one.tolist() for one in around), strict=True)]
    path = tmp_path / "outline.csv"
    path.write_text("\n".join(lines), encoding="utf-8")
    centre, _ = level(read_contour(write(tmp_path / "centre.csv", x, y, gaps)))
    outline, _ = level(read_contour(path))
    for one, other in zip(centre, outline, strict=True):
        assert other.sag == pytest.approx(one.sag, rel=0.02)
        assert other.span == pytest.approx(one.span, rel=1e-3)
        # Without the pillars' tops the level is less sure, and says so.
        assert abs(np.mean(other.below_chord) - np.mean(one.below_chord)) < 3 * other.level_std + 1e-6


def test_films_of_all_gaps_are_shapes_of_their_own_spans(tmp_path: Path) -> None:
    path = write(
        tmp_path / "contour.csv",
        *photograph(LINES, SPANS),
        "pillars.time = 30 s",
        "filament.thickness = 0.5 mm",
    )
    seen = read_contour(path)
    films = measurements_of(seen, level(seen)[0], strand(5e-3))
    for film, span in zip(films.series, SPANS, strict=True):
        assert film.shapes is not None
        assert np.all(film.shapes.time == 30)
        assert float(film.overrides["filament.span"].split()[0]) == pytest.approx(span, rel=1e-4)
    assert dict(seen.overrides) == {"filament.thickness": "0.5 mm"}


def test_the_error_of_a_shape_is_that_of_the_midpoint_and_more_towards_the_ends() -> None:
    """Covariances over the midpoint's: one with it everywhere, two far from it, the same on both sides."""
    place = np.array([-2e-3, -1e-3, 0.0, 0.5e-3, 1e-3, 2e-3, np.nan])
    alike = shape_covariance(place, 4e-3)
    assert alike[2] == pytest.approx(1, abs=0.02) and alike[6] == pytest.approx(alike[2])
    assert alike[0, 5] == pytest.approx(alike[0, 0]) and alike[1, 4] == pytest.approx(alike[1, 1])
    assert alike[0, 0] == pytest.approx(2, abs=0.02)
    near = np.exp(-0.5)
    assert alike[3, 3] == pytest.approx(2 - near**2, abs=0.02)
    assert alike[3, 4] == pytest.approx(1 + near - near * np.exp(-2), abs=0.02)


QUICK = {"run.effects": "paper", "numerics.cells": 8, "numerics.grading": 5.0, "run.accuracy": 0.05}


@pytest.fixture(scope="module")
def contour(tmp_path_factory: pytest.TempPathFactory) -> Path:
    spans, lines = (3e-3, 6e-3), []
    for span in spans:
        data = sc.simulate(strand(span, {**QUICK, "numerics.estimate": False})).data
        lines.append((data.x.values[-1], data.y.values[-1]))
    seen = photograph(lines, spans, noise=1e-6, tilt=0.02)
    return write(tmp_path_factory.mktemp("contour") / "photo.csv", *seen, "pillars.height = 3 mm")


def test_the_command_finds_the_yield_stress_of_a_strand(contour: Path, tmp_path: Path, softcat: Softcat) -> None:
    scene = strand(5e-3, {**QUICK, "material.yield_stress": "120 Pa"})
    (tmp_path / "ink.toml").write_text(scene.to_toml(), encoding="utf-8")
    words = ["fit", str(contour), "--test", "collapse", "--scene", str(tmp_path / "ink.toml"), "--no-discrepancy"]
    done = softcat(*words, "--no-profile-likelihood", "-o", str(tmp_path / "out"))
    assert done.status == 0, done.err
    assert "collapsed" in done.out and "remaining" in done.out
    found = json.loads((tmp_path / "out" / "fit.json").read_text(encoding="utf-8"))
    low, high = found["parameters"]["yield_stress"]["ci95"]
    assert low < YIELD_STRESS < high and high - low < 0.2 * YIELD_STRESS
    short, long = found["collapse_test"]["gaps"]
    assert found["collapse_test"]["tilt_rad"] == pytest.approx(0.02, abs=1e-3)
    assert long["collapsed"] + long["remaining"] == pytest.approx(1)
    # The weight of a short strand is carried by bending, of which the formula does not know.
    assert short["closed_form_over_fit"] > 3
    assert 0.95 < long["closed_form_over_fit"] < 1.3
    assert {"collapse.png", "fit.html"} <= {path.name for path in (tmp_path / "out").iterdir()}


WRONG = {
    "no gap is named": ("x_mm,y_mm\n0,0\n1,0\n", ()),
    "no column y": ("x_mm,z\n0,0\n", ("pillars.gap = 0, 1",)),
    "pixels": ("x_px,y_px\n0,0\n", ("pillars.gap = 0, 1",)),
    "has 1 point": ("x_mm,y_mm\n0.5,0\n2,0\n", ("pillars.gap = 0, 1",)),
    "gaps overlap": (
        "x_mm,y_mm\n" + "".join(f"{k / 10},0\n" for k in range(40)),
        ("pillars.gap = 0, 2", "pillars.gap = 1, 3"),
    ),
    "0.002 m to 0.001 m has 0 points": ("x_mm,y_mm\n0,0\n", ("pillars.gap = 2, 1",)),
    "'1'": ("x_mm,y_mm\n0,0\n", ("pillars.gap = 1",)),
    "pillars.heigth: unknown key": ("x_mm,y_mm\n0,0\n", ("pillars.heigth = 3 mm", "pillars.gap = 0, 1")),
    "'s' is a time, not a length": ("x_mm,y_mm\n0,0\n", ("pillars.height = 3 s", "pillars.gap = 0, 1")),
    "'5 px, 2 mm' in pixels": ("x_mm,y_mm\n0,0\n", ("pillars.gap = 5 px, 2 mm",)),
    "set again": ("x_mm,y_mm\n0,0\n", ("pillars.time = 3 s", "pillars.time = 4 s", "pillars.gap = 0, 1")),
}


@pytest.mark.parametrize("message", WRONG)
def test_a_contour_that_cannot_be_used_is_refused(tmp_path: Path, message: str) -> None:
    table, comments = WRONG[message]
    path = tmp_path / "contour.csv"
    path.write_text("".join(f"# {one}\n" for one in comments) + table, encoding="utf-8")
    with pytest.raises(SoftcatError) as refusal:
        read_contour(path)
    assert message in str(refusal.value)
    assert "accepted: " in str(refusal.value)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--test", "spread"], "accepted: collapse"),
        (["--test", "collapse", "--law", "bingham"], "fits the law of the scene"),
        (["--test", "collapse", "--flow-curve", "curve.csv"], "fits the contour alone"),
        (["--test", "collapse", "another.csv"], "has one contour"),
        ([], "name at least one parameter"),
    ],
)
def test_options_that_contradict_each_other_are_refused(softcat: Softcat, words: list[str], message: str) -> None:
    done = softcat("fit", "photo.csv", "--scene", "ink-bridge", *words)
    assert done.status == 2
    assert message in " ".join(done.err.replace("│", " ").split())
