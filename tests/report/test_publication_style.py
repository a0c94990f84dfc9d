"""Pictures for print: as wide as asked, fonts that stay text, colours that the colour-blind tell apart."""

from __future__ import annotations

import itertools
import re
import zlib
from importlib import resources

import matplotlib
import numpy as np
import pytest

from softcat_sym.errors import SoftcatError
from softcat_sym.plotting.run import FIGURES, LINES, space_time_figure, styled_for, write_pictures
from softcat_sym.plotting.style import STYLES, picture_style, printed

NAMES = {f"{name}.{ending}" for name in ("midpoint", "shapes", "energy", "space-time") for ending in ("pdf", "png")}

# Machado, Oliveira and Fernandes (2009), severity 1, in linear RGB.
DEUTERANOPIA = [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
PROTANOPIA = [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
XYZ = [[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]]
D65 = np.array([0.95047, 1.0, 1.08883])


def seen(colour: str, eye: list[list[float]]) -> np.ndarray:
    """L*, a*, b* of a colour as such an eye sees it (IEC 61966-2-1, CIE 1976)."""
    rgb = np.array(matplotlib.colors.to_rgb(colour))
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    ratio = np.array(XYZ) @ np.clip(np.array(eye) @ linear, 0, 1) / D65
    f = np.where(ratio > (6 / 29) ** 3, np.cbrt(ratio), ratio / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def closest(colours: list[str], eye: list[list[float]]) -> float:
    return min(float(np.linalg.norm(seen(a, eye) - seen(b, eye))) for a, b in itertools.combinations(colours, 2))


@pytest.mark.parametrize("eye", [DEUTERANOPIA, PROTANOPIA], ids=["deuteranopia", "protanopia"])
def test_the_colour_blind_tell_all_series_from_each_other_and_from_the_paper(eye):
    series = [colour for colour, _ in LINES]
    # A difference of 2.3 is just seen (Mahy, Van Eycken and Oosterlinck 1994); this is seven times as much.
    assert closest([*series, "#ffffff"], eye) > 16
    assert len({line for _, line in LINES[1:]}) == len(LINES) - 1
    # The measure itself: red and green of equal lightness, which such an eye confuses.
    assert closest(["#d62728", "#8c6d1f"], eye) < closest(["#d62728", "#8c6d1f"], np.eye(3).tolist()) / 2


def test_the_lines_of_the_sliders_are_told_apart_too():
    script = (resources.files("softcat_sym.plotting") / "templates" / "sliders_data.js").read_text(encoding="utf-8")
    colours = re.findall(r'"(#[0-9A-F]{6})"', re.search(r"COLOURS = \[(.*?)\]", script)[1])
    assert len(colours) == 6
    assert closest(colours, DEUTERANOPIA) > 10
    assert closest(colours[:3], DEUTERANOPIA) > 20


def pages(pdf: bytes) -> tuple[float, float]:
    box = re.search(rb"/MediaBox \[ *([\d.]+) ([\d.]+) ([\d.]+) ([\d.]+) *\]", pdf)
    assert box is not None
    return float(box[3]) / 72 * 25.4, float(box[4]) / 72 * 25.4


@pytest.mark.parametrize(("width", "millimetres"), [("column", 84.0), ("page", 174.0)])
def test_pdfs_are_as_wide_as_asked_and_hold_truetype(descent, summary, scene, tmp_path, width, millimetres):
    before = matplotlib.rcParams.copy()
    write_pictures(descent, summary, scene, tmp_path, width)
    assert matplotlib.rcParams.copy() == before, "the style of the caller stays"
    files = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert set(files) == {*NAMES, "midpoint.csv"}
    for name in (name for name in files if name.endswith("pdf")):
        content = files[name]
        wide, tall = pages(content)
        assert wide == pytest.approx(millimetres, abs=0.05)
        assert tall < 235
        assert b"/FontFile2" in content
        assert b"/CIDFontType2" in content
        assert b"/Type3" not in content
        streams = [zlib.decompress(one) for one in re.findall(rb"stream\r?\n(\x78.*?)\r?\nendstream", content, re.S)]
        sizes = {float(size) for one in streams for size in re.findall(rb"/F\d+ ([\d.]+) Tf", one)}
        assert sizes
        assert min(sizes) >= 7
        assert max(sizes) <= 8


def test_the_same_figure_gives_the_same_bytes(descent, scene):
    def twice() -> dict[str, bytes]:
        with styled_for("column"):
            assert matplotlib.rcParams["font.size"] == 8
            return printed("space-time", space_time_figure(descent, {}, scene, "column"), 400)

    assert twice() == twice()


@pytest.mark.parametrize("frames", [1, 5])
@pytest.mark.parametrize("draw", FIGURES.values())
def test_a_run_that_never_moves_and_a_single_frame_are_drawn(make_run, make_scene, draw, frames):
    still = make_scene(limit=None, law="elastic")
    at_rest = make_run(still, np.zeros(frames), np.linspace(0, 1, frames), cells=20)
    with styled_for("column"):
        draw(at_rest, {}, still, "column").canvas.draw()


def test_styles_have_names():
    assert {asked: picture_style(asked) for asked in STYLES}["publication"] == "column"
    with pytest.raises(SoftcatError, match="--style: no style 'jfm'; accepted: screen, publication"):
        picture_style("jfm")
