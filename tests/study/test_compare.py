"""Filament against elements: exact measures, which theories stand beside it, resumption, refusals."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.discretization.assembly import assemble, choose_grid, choose_theory
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.compare import Comparison, aligned, compare, discrepancy, filament_clamp_strain
from tests.acceptance.table import show
from tests.reference.strips import shortened

COARSE = Mesh(8, 2)
QUICK = {"numerics.cells": 10, "numerics.estimate": False, "filament.width": "0.3 mm"}
YIELDING = shortened(sc.load_scene("continual-descent", QUICK), 10.0, 11)
THICK = shortened(
    sc.load_scene("no-yield", {**QUICK, "groups.delta": 0.06, "load.ramp": "0 s", "numerics.cells": 20}), 12.0, 49
)


@pytest.fixture(scope="module")
def yielding() -> Comparison:
    return compare(YIELDING, COARSE)


def test_discrepancy_of_known_curves() -> None:
    time = np.linspace(0, 7, 71)
    elements = -2 * time / 7
    found = discrepancy(time, elements + 0.1 * time, elements)
    np.testing.assert_allclose(found.error, 0.05 * time)
    np.testing.assert_allclose(found.at, [0.05 * 0.7, 0.05 * 1.8, 0.05 * 3.5, 0.35], rtol=1e-12)
    # Frames at 1.0, 1.1, ... 7.0: the first seventh is left out, its end is not.
    assert found.mean == pytest.approx(0.05 * 4.0)
    assert found.largest == pytest.approx(0.35)
    assert discrepancy(time, elements - 0.1, elements).mean == pytest.approx(-0.05)


def test_a_run_that_ends_early_is_compared_as_far_as_it_came() -> None:
    time = np.linspace(0, 1, 11)
    short = aligned(time[:6] * (1 + 1e-15), -time[:6], time)
    np.testing.assert_allclose(short[:6], -time[:6])
    assert np.isnan(short[6:]).all()
    found = discrepancy(time, short, -2 * time)
    assert found.at[:3] == pytest.approx((0.05, 0.1, 0.25)) and np.isnan(found.at[3])
    assert np.isnan(found.mean)
    assert found.largest == pytest.approx(0.25)


def test_without_motion_there_is_no_relative_error() -> None:
    found = discrepancy(np.linspace(0, 1, 5), np.zeros(5), np.zeros(5))
    assert np.isnan([*found.at, found.mean, found.largest]).all()


@pytest.mark.parametrize("curvature", [40.0, -40.0])
def test_clamp_strain_of_a_stretched_arc(yielding: Comparison, curvature: float) -> None:
    run, thickness, stretch = yielding.elements, YIELDING.filament.thickness, 1.3
    cells = np.linspace(-0.09, 0.09, 19)
    uniform = np.ones((len(run.time) - 4, len(cells)))
    height = thickness / np.sqrt(stretch)
    fields = {"stretch": stretch * uniform, "curvature": curvature * uniform, "thickness": height * uniform}
    data = xr.Dataset(
        {name: (("time", "cell"), values) for name, values in fields.items()},
        coords={"time": run.time[:-4], "X_cell": ("cell", cells)},
    )
    found = filament_clamp_strain(data, run, thickness)
    # Two elements through the thickness: the outer Gauss points are at zeta = 1/2 + 1/(2 sqrt 3).
    bending = 40 * height / 2 * (0.5 + 0.5 / np.sqrt(3))
    np.testing.assert_allclose(found.mean[:-4], np.log(stretch), rtol=1e-12)
    np.testing.assert_allclose(found.largest[:-4], np.log(stretch) + bending, rtol=1e-12)
    assert np.isnan(found.mean[-4:]).all() and np.isnan(found.largest[-4:]).all()


def test_shear_brings_the_filament_to_the_elements() -> None:
    """A thick elastic beam over most of its first swing: the published theory is too stiff by its shear."""
    found = compare(THICK, Mesh(16, 2))
    rows = [(row.name, f"{row.discrepancy.largest:.4f}") for row in found.filaments]
    show("Largest error of the first swing, delta = 0.06", ["theory", "error"], rows)
    own, material, _ = (row.discrepancy.largest for row in found.filaments)
    assert own < 0.02
    assert material > 4 * own
    # Strain next to the clamp: the largest is steep there, and comes near on finer grids (2 % on 80 cells and 48 x 6).
    peak = int(np.argmin(found.elements.midpoint))
    for which, tolerance in (("mean", 0.05), ("largest", 0.12)):
        elements, filament = (getattr(of, which)[peak] for of in (found.clamp_strain, found.filament.clamp_strain))
        assert filament == pytest.approx(elements, rel=tolerance)


def test_the_published_theories_stand_beside_auto_only(yielding: Comparison) -> None:
    assert [row.name for row in yielding.filaments] == [
        "filament",
        "published, material closure",
        "published, printed closure",
    ]
    assert [row.trajectory.scene.run.closure for row in yielding.filaments] == ["material", "material", "printed"]
    assert yielding.filament.trajectory.scene == YIELDING
    published = yielding.filaments[1].trajectory.summary["effects"]
    assert not {"shear", "fibres", "necking-gradient"} & set(published)
    named = compare(YIELDING.replace({"run.effects": "paper"}), COARSE)
    assert [row.name for row in named.filaments] == ["filament"]
    assert np.array_equal(named.filament.midpoint, yielding.filaments[1].midpoint)


def test_a_published_theory_is_not_run_twice() -> None:
    scene = YIELDING.replace({"run.closure": "printed"})
    assert [row.name for row in compare(scene, COARSE).filaments] == ["filament", "published, material closure"]


def test_overruled_fibres_do_not_reach_the_published_theories() -> None:
    found = compare(YIELDING.replace({"numerics.fibres": 4}), COARSE)
    assert "fibres" in found.filament.trajectory.summary["effects"]
    assert all("fibres" not in row.trajectory.summary["effects"] for row in found.filaments[1:])


def test_unknowns_are_those_of_the_graph(yielding: Comparison) -> None:
    for row in yielding.filaments:
        scene = row.trajectory.scene
        effects = choose_effects(scene)
        equations = derive(effects.terms(), SECTIONS["rectangle"], scene.run.closure)
        graph = assemble(equations, choose_grid(scene), effects.names, choose_theory(scene, equations))
        names = [name.split("[")[0] for name in (*graph.state_names, *graph.algebraic_names)]
        assert row.dofs == sum(name in ("x", "y", "psi") for name in names)


def test_width_is_warned_of(yielding: Comparison) -> None:
    assert yielding.warnings == ()
    wide = compare(YIELDING.replace({"filament.width": None, "run.effects": "paper"}), COARSE)
    assert len(wide.warnings) == 1
    assert "plane stress" in wide.warnings[0] and "0.3 mm" in wide.warnings[0]
    # The elements of unit width are the same: only the filament's necking coefficient knows.
    assert np.array_equal(wide.elements.midpoint, yielding.elements.midpoint)


def test_what_runs_is_told_and_an_interrupted_run_goes_on(yielding: Comparison, tmp_path: Path) -> None:
    checkpoint, told = tmp_path / "new" / "elements.npz", []

    class Listener(Silence):
        def __init__(self, stop: bool) -> None:
            self.stop = stop

        def update(self, simulated_time: float, step_size: float | None) -> None:
            if self.stop:
                signal.raise_signal(signal.SIGINT)

    @contextmanager
    def stopping(what: str) -> Iterator[Listener]:
        yield Listener(stop=what == "elements")

    @contextmanager
    def listening(what: str) -> Iterator[Listener]:
        told.append(what)
        yield Listener(stop=False)

    with pytest.raises(KeyboardInterrupt):
        compare(YIELDING, COARSE, checkpoint=checkpoint, progress=stopping)
    assert checkpoint.is_file()
    resumed = compare(YIELDING, COARSE, checkpoint=checkpoint, progress=listening)
    assert told == ["elements", *(row.name for row in yielding.filaments)]
    assert np.array_equal(resumed.elements.midpoint, yielding.elements.midpoint)
    assert np.array_equal(resumed.elements.rate, yielding.elements.rate)


@pytest.mark.parametrize(
    ("changes", "path"),
    [
        ({"ends.left": "pinned"}, "ends.left"),
        ({"filament.section": "circle", "filament.width": None}, "filament.section"),
        ({"run.effects": ["shaer"]}, "run.effects"),
    ],
)
def test_scenes_that_cannot_be_compared_are_refused_before_anything(
    changes: dict[str, object], path: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError, match=path):
        compare(YIELDING.replace(changes), COARSE, checkpoint=tmp_path / "out" / "elements.npz")
    assert not list(tmp_path.iterdir())


def test_a_failure_leaves_no_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "nonexistent")
    (tmp_path / "kept").mkdir()
    with pytest.raises(SoftcatError, match="no C compiler"):
        compare(YIELDING, COARSE, checkpoint=tmp_path / "kept" / "deep" / "er" / "elements.npz")
    assert [path.name for path in tmp_path.rglob("*")] == ["kept"]
