"""``softcat flow-curve`` as a user meets it: files, table, picture, refusals."""

from __future__ import annotations

import csv
import io
import json
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.legend import Legend
from matplotlib.text import Text
from rich.console import Console

import softcat_sym as sc
from softcat_sym.cli import main
from softcat_sym.fitting.flow_curve import FlowCurve, FlowCurveFit, fit_flow_curve
from softcat_sym.plotting import style
from softcat_sym.plotting.flow_curve import flow_curve_document, flow_curve_figure, print_flow_curve
from tests.inverse.curves import RATE, curve_of, write_csv

FILES = {"flow_curve.json", "flow_curve.csv", "flow_curve.png"}
LAWS = {"bingham", "power-law", "herschel-bulkley"}


def flow_curve(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int | str | None:
    """Exit status of the command, in this process."""
    monkeypatch.setattr(sys, "argv", ["softcat", "flow-curve", *arguments])
    with pytest.raises(SystemExit) as left:
        main()
    return left.value.code


@pytest.fixture
def paste(tmp_path: Path) -> Path:
    return write_csv(tmp_path / "paste.csv", curve_of(12.0, 3.4, 0.43, noise=0.02, seed=6))


def test_files_table_and_document(
    paste: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "deep" / "out"
    assert flow_curve(monkeypatch, str(paste), "-o", str(output)) == 0
    assert {path.name for path in output.iterdir()} == FILES
    printed = capsys.readouterr().out
    assert "paste.csv" in printed and "herschel-bulkley" in printed and "AICc" in printed
    fit = fit_flow_curve(paste)
    found = json.loads((output / "flow_curve.json").read_text())
    assert (found["best"], found["handed_on"], found["points"]) == ("herschel-bulkley", "herschel-bulkley", RATE.size)
    assert found["overrides"] == fit.overrides()
    assert set(found["candidates"]) == LAWS
    assert found["candidates"]["herschel-bulkley"]["delta_aicc"] == 0
    best = found["candidates"]["herschel-bulkley"]["parameters"]
    assert set(best) == {"shear_yield_stress", "shear_consistency", "index"}
    assert best["index"]["value"] == fit.best.n.value  # type: ignore[union-attr]
    assert best["index"]["ci95"][0] < 0.43 < best["index"]["ci95"][1]
    assert set(found["candidates"]["bingham"]["parameters"]) == {"shear_yield_stress", "shear_viscosity"}
    with (output / "flow_curve.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    np.testing.assert_array_equal([float(row["shear_rate_1_s"]) for row in rows], fit.curve.shear_rate)
    for law in LAWS:
        name = law.replace("-", "_")
        fitted = np.array([float(row[f"{name}_Pa"]) for row in rows])
        np.testing.assert_array_equal(fitted, fit.candidate(law).fitted)
        residual = [float(row[f"{name}_relative_residual"]) for row in rows]
        np.testing.assert_allclose(residual, fitted / fit.curve.shear_stress - 1, atol=1e-15)


def test_a_scene_is_handed_on(
    paste: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    output = tmp_path / "out"
    choice = ("--law", "bingham", "--set", "material.youngs_modulus=40 kPa")
    assert flow_curve(monkeypatch, str(paste), "-o", str(output), "--scene", "no-yield", *choice, "-q") == 0
    assert capsys.readouterr() == ("", "")
    assert {path.name for path in output.iterdir()} == {*FILES, "scene.toml"}
    scene = sc.load_scene(str(output / "scene.toml"))
    tensile = fit_flow_curve(paste).candidate("bingham").tensile
    assert scene.material.youngs_modulus == 40e3
    assert scene.material.yield_stress == pytest.approx(tensile.yield_stress, rel=1e-9)
    assert scene.material.viscosity == pytest.approx(tensile.viscosity, rel=1e-9)
    assert "in tension, times 3" in (output / "scene.toml").read_text()
    assert json.loads((output / "flow_curve.json").read_text())["handed_on"] == "bingham"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("nowhere.csv",), "no such file"),
        (("PASTE", "--law", "binham"), "did you mean 'bingham'"),
        (("PASTE", "--scene", "no-such-scene"), "no-such-scene"),
        (("PASTE", "--set", "run.duration=1 s"), "--scene"),
        (
            ("PASTE", "--scene", "no-yield", "--law", "bingham", "--set", "material.visosity=1 Pa*s"),
            "material.visosity",
        ),
        (("FALLING", "--scene", "no-yield"), "cannot be handed on"),
    ],
)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: tuple[str, ...],
    message: str,
    paste: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    falling = write_csv(tmp_path / "falling.csv", FlowCurve(RATE, 10 * RATE**-0.2))
    files = {"PASTE": str(paste), "FALLING": str(falling)}
    output = tmp_path / "out"
    assert flow_curve(monkeypatch, *(files.get(word, word) for word in arguments), "-o", str(output)) == 2
    said = capsys.readouterr().err
    assert message in said and "Traceback" not in said
    assert not output.exists()


@cache
def cases() -> dict[str, FlowCurveFit]:
    narrow = np.geomspace(1, 1.02, 5)
    return {
        "exact": fit_flow_curve(curve_of(12.0, 3.4, 0.43)),
        "noisy": fit_flow_curve(curve_of(0.0, 3.4, 1.6, noise=0.4, seed=2)),
        "falling": fit_flow_curve(FlowCurve(RATE, 10 * RATE**-0.2)),
        "narrow": fit_flow_curve(FlowCurve(narrow, 5 + narrow)),
        "wide": fit_flow_curve(FlowCurve(np.geomspace(1e-9, 1e9, 19), 1e3 * np.geomspace(1e-9, 1e9, 19) ** 0.5)),
        "plateau": fit_flow_curve(FlowCurve(RATE, 0 * RATE + 7)),
    }


@pytest.mark.parametrize("name", ["exact", "noisy", "falling", "narrow", "wide", "plateau"])
def test_the_picture_has_room_for_its_words(name: str) -> None:
    fit = cases()[name]
    figure: Figure = flow_curve_figure(fit)
    with style.styled():
        figure.draw_without_rendering()
    paper = figure.bbox
    ticks = [label for axes in figure.axes for label in (*axes.get_xticklabels(), *axes.get_yticklabels())]
    for text in figure.findobj(Text):
        box = text.get_window_extent()
        if text.get_visible() and text.get_text().strip() and text not in ticks:
            assert box.x0 >= 0 and box.y0 >= 0, text
            assert box.x1 <= paper.width and box.y1 <= paper.height, text
    above, below = figure.axes
    (legend,) = figure.findobj(Legend)
    assert not any(legend.get_window_extent().overlaps(axes.bbox) for axes in figure.axes)
    assert above.get_xlim() == below.get_xlim()
    low, high = above.get_ylim()
    for one in fit.candidates:
        assert low < one.fitted.min() and one.fitted.max() < high
    for axis in (above.yaxis, below.xaxis):
        shown = [label for label in axis.get_ticklabels() if label.get_text()]
        limits = axis.get_view_interval()
        places = [place for place in axis.get_majorticklocs() if limits[0] <= place <= limits[1]]
        assert len(shown) >= 2 and len(places) >= 2, name


@pytest.mark.parametrize(("name", "fit"), cases().items(), ids=cases())
def test_table_and_document_of_every_case(name: str, fit: FlowCurveFit) -> None:
    screen = Console(file=io.StringIO(), width=80, color_system=None)
    print_flow_curve(fit, screen)
    printed = screen.file.getvalue()  # type: ignore[attr-defined]
    assert "…" not in printed, name
    assert all(text.split()[0] in printed for text in fit.warnings)
    json.dumps(flow_curve_document(fit), allow_nan=False)
