"""``softcat figures``: every figure with its data, one clear refusal of what is none, interruption and resumption."""

from __future__ import annotations

import csv
import json
import subprocess
import sys
from pathlib import Path

import pytest

from softcat_sym.reference.element_loop import Mesh
from softcat_sym.studies import paper_figures as figure_scenes
from softcat_sym.studies.paper_figures import INSTANTS, SCENES, SNAPSHOTS

from .in_process import Softcat

SOFTCAT = str(Path(sys.executable).with_name("softcat"))


def test_a_figure_that_there_is_none_of_is_refused(tmp_path: Path) -> None:
    for number in ("3", "0", "two"):
        done = subprocess.run(
            [SOFTCAT, "figures", "--only", number, "-o", str(tmp_path / "out")],
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 2
        assert "--only" in done.stderr
        assert "2, 3a, 3b, 4" in done.stderr
        assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_figure_2_holds_every_curve_with_its_data(tmp_path: Path) -> None:
    subprocess.run([SOFTCAT, "figures", "--only", "2", "-o", str(tmp_path), "-q"], check=True)
    assert {path.name for path in tmp_path.iterdir()} == {f"figure2.{kind}" for kind in ("png", "pdf", "csv", "json")}
    facts = json.loads((tmp_path / "figure2.json").read_text())
    assert len(facts["panels"]) == 4
    assert all(set(panel["outcomes"].values()) == {"solved"} for panel in facts["panels"])
    slender, thick = facts["panels"][0], facts["panels"][-1]
    assert slender["tension_over_bending_at_t_high"] > 9
    assert thick["tension_over_bending_at_t_high"] == pytest.approx(0.09, abs=0.005)
    assert "delta = 0.025" in facts["caption"]
    with (tmp_path / "figure2.csv").open(newline="") as stream:
        names = {row["curve"] for row in csv.DictReader(stream)}
    assert names == {
        "full model",
        "reduced model (2.18)",
        "free fall",
        "(2.20) from rest",
        "(2.20) as printed",
        "1/3 law",
        "(2.21) integrated",
        "(2.22)",
    }


@pytest.fixture
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """Elements that take seconds."""
    whole = figure_scenes.film_scene
    monkeypatch.setattr(figure_scenes, "film_scene", lambda *given: whole(*given, mesh=Mesh(12, 2)))


@pytest.mark.slow
@pytest.mark.usefixtures("coarse")
def test_figures_3b_and_4_share_their_runs_and_keep_their_data(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    softcat = Softcat(monkeypatch, capsys)
    done = softcat("figures", "--only", "4", "--only", "3b", "-o", str(tmp_path))
    assert done.status == 0, done.err
    assert "Figure 3(b)." in done.out
    assert "Figure 4." in done.out
    kept = {path: path.stat().st_mtime_ns for path in tmp_path.glob("elements-*.npz")}
    assert len(kept) == len(SCENES)
    facts = json.loads((tmp_path / "figure3b.json").read_text())
    assert [scene["scene"] for scene in facts["scenes"]] == [of.name for of in SCENES]
    with (tmp_path / "figure3b.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert len({(row["scene"], row["curve"]) for row in rows}) == 4 * len(SCENES)
    last = facts["scenes"][-1]["midpoint_over_L"]["elements"]["460"]
    drawn = [row for row in rows if (row["scene"], row["curve"]) == (SCENES[-1].name, "elements")]
    assert float(drawn[-1]["midpoint_over_L"]) == pytest.approx(last, rel=1e-7)
    assert float(drawn[-1]["t_tilde"]) == pytest.approx(460)
    with (tmp_path / "figure4-elements.csv").open(newline="") as stream:
        points = list(csv.DictReader(stream))
    # Four points an element, four instants of three scenes, and the last of one.
    assert len(points) == 4 * 12 * 2 * (len(SNAPSHOTS) * (len(INSTANTS) - 1) + 1)
    assert all(float(row["plastic_shear_rate"]) == 0 for row in points if row["panel"] == "a")
    deepest = min(float(row["y_over_L"]) for row in points if row["panel"] == "d")
    assert deepest == pytest.approx(last, abs=0.5 * 0.03)

    assert softcat("figures", "--only", "4", "-o", str(tmp_path), "-q").status == 0
    assert all(path.stat().st_mtime_ns == before for path, before in kept.items())


@pytest.mark.usefixtures("coarse")
def test_interrupted_figures_say_how_to_go_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from softcat_sym.plotting import terminal as progress

    def stop(self: object, simulated_time: float, step_size: float | None) -> None:
        import signal

        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(progress.IntegrationProgress, "update", stop)
    done = Softcat(monkeypatch, capsys)("figures", "--only", "4", "-o", str(tmp_path / "out"))
    assert done.status == 130
    assert "the same command goes on" in done.err
    assert [path.name.split("-")[0] for path in (tmp_path / "out").iterdir()] == ["elements"]
