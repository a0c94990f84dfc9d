"""Phase diagrams: lines against their limits, refinement, runs against `simulate`, files and refusals."""

from __future__ import annotations

import csv
import json
import math
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.batch.executor import RunPool, run_pool
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.studies.phase import SETTINGS, PhaseLine, crossings, distances, phase_diagram, phase_lines
from softcat_sym.studies.phase_runs import (
    PLANES,
    Place,
    duration_at,
    refuse_scene,
    run_places,
)
from tests.common.in_process import Softcat

LAPLACE = 0.6627434193491816
"""Laplace limit constant, max of u/cosh u; no catenary carries itself beyond G = 2 of it."""
SCENE = sc.load_scene("arrested-overdamped", list(SETTINGS))


def lines_of(scene: sc.Scene, plane: str = "G-delta") -> dict[str, PhaseLine]:
    return {line.name: line for line in phase_lines(scene, PLANES[plane], 9)}


def test_papers_lines_and_the_exact_threshold() -> None:
    lines = lines_of(SCENE)
    np.testing.assert_allclose(lines["first yield of a beam"].G, 2 * lines["first yield of a beam"].other)
    np.testing.assert_allclose(lines["arrest of a shallow catenary"].G, np.sqrt(2))
    np.testing.assert_allclose(lines["arrest of the exact catenary"].G, 2 * LAPLACE, rtol=1e-12)
    np.testing.assert_allclose(lines["sudden load, undamped beam"].G, lines["sudden load, undamped beam"].other)


def test_what_the_groups_do_not_decide_is_refused() -> None:
    around = {"surroundings.surface_tension": "30 mN/m", "surroundings.density": "1000 kg/m^3"}
    for path, value in around.items():
        with pytest.raises(SceneError) as caught:
            refuse_scene(SCENE.replace({path: value, "run.effects": "auto"}))
        assert [fault.path for fault in caught.value.faults] == [path]
        refuse_scene(SCENE.replace({path: value, "run.effects": "paper"}))


def test_crossings_and_distances_of_a_known_lattice() -> None:
    G, V = np.geomspace(0.01, 3, 41), np.geomspace(0.1, 100, 5)
    marks = np.empty((41, 5), dtype="<U24")
    for i, value in enumerate(G):
        below = "arrested-underdamped" if value < 0.3 else "arrested-overdamped"
        marks[i, :] = "no-yield" if value < 0.06 else below if value < 1 else "descending-at-clamps"
    marks[G > 2, :] = "descending"
    marks[(G > 0.9) & (G < 1.3), 0] = "localised"
    found = crossings(G, V, marks)
    kinds = ("first yield", "overdamping", "arrest", "arrest of the span")
    rows = {kind: [crossing for crossing in found if crossing.kind == kind] for kind in kinds}
    assert [len(rows[kind]) for kind in kinds] == [5, 5, 4, 5]  # none beside a run that is no answer
    for kind, G_there in (("first yield", 0.06), ("arrest", 1), ("arrest of the span", 2)):
        assert all(crossing.G_low < G_there <= crossing.G_high for crossing in rows[kind])
    line = PhaseLine("half as much", "first yield", "paper", "", V, np.full(5, 0.03))
    [distance] = distances([line], found)
    assert distance.rows == 5
    assert distance.median == pytest.approx(rows["first yield"][0].G / 0.03 - 1)


@pytest.fixture(scope="module")
def pool() -> Iterator[RunPool]:
    with run_pool(2) as threads:
        yield threads


def by_hand(place: Place, duration: float) -> sc.Scene:
    """The filament of these groups, its constants worked out from their definitions (3.9), (3.10)."""
    span, density, gravity = 0.2, 1900.0, 9.81
    return SCENE.replace(
        {
            "filament.thickness": f"{place.delta * span!r} m",
            "material.yield_stress": f"{density * gravity * span / place.G!r} Pa",
            "material.viscosity": f"{place.V * density * math.sqrt(gravity * span**3)!r} Pa*s",
            "run.duration": f"{duration!r} s",
            "numerics.estimate": False,
        }
    )


def test_runs_are_those_of_simulate(pool: RunPool) -> None:
    answers = (
        (Place(0.02, 26.0, 0.03), "no-yield"),
        (Place(0.1, 3.0, 0.03), "arrested-underdamped"),
        (Place(0.5, 26.0, 0.05), "arrested-overdamped"),
        (Place(2.5, 26.0, 0.03), "descending"),
    )
    runs = run_places(SCENE, [place for place, _ in answers], pool)
    for run, (place, regime) in zip(runs, answers, strict=True):
        single = sc.simulate(by_hand(place, duration_at(SCENE, place)))
        assert run.regime == single.summary["regime"] == regime
        assert run.sag == pytest.approx(-single.summary["midpoint_final_m"] / 0.2, rel=2e-3, abs=1e-4)


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    monkeypatch.setenv("COLUMNS", "160")
    return Softcat(monkeypatch, capsys)


@pytest.mark.slow
def test_files_and_what_they_hold(softcat: Softcat, tmp_path: Path) -> None:
    out = tmp_path / "out"
    files = {"phase.json", "scene.toml", "phase_runs.csv", "phase_boundaries.csv", "phase_lines.csv"}
    pictures = {"phase_G-V.png"}
    done = softcat("phase", "-o", str(out), "--plane", "G-V", "--resolution", "4")
    assert done.status == 0, done.err
    assert {path.name for path in out.iterdir()} == files | pictures
    plane = json.loads((out / "phase.json").read_text())["planes"]["G-V"]
    assert plane["nodes"] == plane["nodes_run"] + plane["nodes_saved"] == 25
    with (out / "phase_runs.csv").open() as stream:
        rows = list(csv.DictReader(stream))
    assert len(rows) == plane["nodes_run"]
    assert Counter(row["mark"] for row in rows) == plane["marks"]
    assert sum(int(row["runs"]) for row in rows) == plane["runs"]
    for row in rows:
        assert bool(row["regime"]) is (row["outcome"] == "solved")
        assert row["regime"] or row["message"]
    assert {"localised", "no-yield", "descending"} <= set(plane["marks"])
    assert "were saved" in plane["caption"]
    assert "refinement saved" in done.out
    assert sc.load_scene(str(out / "scene.toml")).run.effects == "paper"
    assert all((out / name).read_bytes().startswith(b"\x89PNG") for name in pictures)


def test_refusals_write_nothing(softcat: Softcat, tmp_path: Path) -> None:
    for arguments, message in (
        (("--plane", "G-tau"), "G-delta, G-V"),
        (("--resolution", "2"), "4 to 640"),
        (("maxwell-slow",), "material.law"),
        (("--workers", "0"), "workers"),
    ):
        done = softcat("phase", *arguments, "-o", str(tmp_path / "out"))
        assert done.status == 2
        assert message in done.err
        assert not (tmp_path / "out").exists()
    with pytest.raises(SceneError, match="level supports"):
        phase_diagram(SCENE.replace({"ends.drop": "1 cm"}))
    with pytest.raises(SoftcatError, match="4 to 640"):
        phase_diagram(SCENE, resolution=641)
