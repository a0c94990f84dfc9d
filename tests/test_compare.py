"""A filament against finite elements, ours and CalculiX: exact measures, theories, files, resumption, refusals."""

from __future__ import annotations

import json
import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.discretization.assembly import assemble, choose_grid, choose_theory
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.physics.filament import derive
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.plotting.compare import rate_fields, shapes_frame, write_comparison
from softcat_sym.plotting.files import finite, json_bytes
from softcat_sym.plotting.terminal import IntegrationProgress
from softcat_sym.reference import calculix
from softcat_sym.reference.calculix import find_calculix
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.reference.elements import ElementRun
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.compare import Comparison, aligned, compare, discrepancy, filament_clamp_strain
from tests.cli.in_process import Softcat, sets
from tests.reference.strips import shortened

COARSE = Mesh(8, 2)
QUICK = {"numerics.cells": 10, "numerics.estimate": False, "filament.width": "0.3 mm"}
YIELDING = shortened(sc.load_scene("continual-descent", QUICK), 10.0, 21)
THICK = shortened(
    sc.load_scene("no-yield", {**QUICK, "groups.delta": 0.06, "load.ramp": "0 s", "numerics.cells": 20}), 12.0, 49
)
THEORIES = ("filament", "published_material_closure", "published_printed_closure")
SHORT = sets("groups.duration=10", "run.frames=11", "numerics.cells=10", "numerics.estimate=false")
NARROW = sets("filament.width=60 um")
PICTURES = ("midpoint", "shapes", "plastic_rate", "clamp_strain")
FILES = {"compare.json", "scene.toml", "elements.npz", "compare_errors.csv"}
FILES |= {f"compare_{name}.{kind}" for name in PICTURES for kind in ("png", "csv")}
FILES |= {"vtk"} if find_spec("meshio") else set()
needs_calculix = pytest.mark.skipif(find_calculix() is None, reason="no CalculiX: apt-get install calculix-ccx")


@pytest.fixture(scope="module")
def yielding() -> Comparison:
    return compare(YIELDING, COARSE)


@pytest.fixture
def softcat(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Softcat:
    return Softcat(monkeypatch, capsys)


def names_in(folder: Path) -> set[str]:
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_discrepancy_of_known_curves() -> None:
    time = np.linspace(0, 7, 71)
    elements = -2 * time / 7
    found = discrepancy(time, elements + 0.1 * time, elements)
    np.testing.assert_allclose(found.error, 0.05 * time)
    np.testing.assert_allclose(found.at, [0.05 * 0.7, 0.05 * 1.8, 0.05 * 3.5, 0.35], rtol=1e-12)
    # Frames at 1.0, 1.1, ... 7.0: the first seventh is left out, its end is not.
    assert (found.mean, found.largest) == pytest.approx((0.05 * 4.0, 0.35))
    assert discrepancy(time, elements - 0.1, elements).mean == pytest.approx(-0.05)
    still = discrepancy(np.linspace(0, 1, 5), np.zeros(5), np.zeros(5))
    assert np.isnan([*still.at, still.mean, still.largest]).all()


def test_a_run_that_ends_early_is_compared_as_far_as_it_came() -> None:
    time = np.linspace(0, 1, 11)
    short = aligned(time[:6] * (1 + 1e-15), -time[:6], time)
    np.testing.assert_allclose(short[:6], -time[:6])
    assert np.isnan(short[6:]).all()
    found = discrepancy(time, short, -2 * time)
    assert found.at[:3] == pytest.approx((0.05, 0.1, 0.25)) and np.isnan([found.at[3], found.mean]).all()
    assert found.largest == pytest.approx(0.25)


def test_clamp_strain_of_a_stretched_arc(yielding: Comparison) -> None:
    run, thickness, stretch = yielding.elements, YIELDING.filament.thickness, 1.3
    cells, height = np.linspace(-0.09, 0.09, 19), thickness / np.sqrt(stretch)
    uniform = np.ones((len(run.time) - 4, len(cells)))
    # Two elements through the thickness: the outer Gauss points are at zeta = 1/2 + 1/(2 sqrt 3).
    bending = 40 * height / 2 * (0.5 + 0.5 / np.sqrt(3))
    for curvature in (40.0, -40.0):
        fields = {"stretch": stretch * uniform, "curvature": curvature * uniform, "thickness": height * uniform}
        data = xr.Dataset(
            {name: (("time", "cell"), values) for name, values in fields.items()},
            coords={"time": run.time[:-4], "X_cell": ("cell", cells)},
        )
        found = filament_clamp_strain(data, run, thickness)
        np.testing.assert_allclose(found.mean[:-4], np.log(stretch), rtol=1e-12)
        np.testing.assert_allclose(found.largest[:-4], np.log(stretch) + bending, rtol=1e-12)
        assert np.isnan([found.mean[-4:], found.largest[-4:]]).all()


def test_shear_brings_the_filament_to_the_elements() -> None:
    """A thick elastic beam over most of its first swing: the published theory is too stiff by its shear."""
    found = compare(THICK, Mesh(16, 2))
    own, material, _ = (row.discrepancy.largest for row in found.filaments)
    assert own < 0.02 and material > 4 * own
    # Strain next to the clamp: the largest is steep there, and comes near on finer grids (2 % on 80 cells and 48 x 6).
    peak, strains = int(np.argmin(found.elements.midpoint)), found.clamp_strains
    for which, tolerance in (("mean", 0.05), ("largest", 0.12)):
        elements, filament = (getattr(strains[key], which)[peak] for key in ("elements", "filament"))
        assert filament == pytest.approx(elements, rel=tolerance)


def test_the_published_theories_stand_beside_auto_only(yielding: Comparison) -> None:
    assert tuple(row.key for row in yielding.rows) == THEORIES
    assert [row.trajectory.scene.run.closure for row in yielding.filaments] == ["material", "material", "printed"]
    assert yielding.filament.trajectory.scene == YIELDING
    assert not {"shear", "fibres", "necking-gradient"} & set(yielding.filaments[1].trajectory.summary["effects"])
    named = compare(YIELDING.replace({"run.effects": "paper"}), COARSE)
    assert [row.name for row in named.rows] == ["filament"]
    assert np.array_equal(named.filament.midpoint, yielding.filaments[1].midpoint)
    # A published theory is not run twice; overruled fibres do not reach them.
    twice = compare(YIELDING.replace({"run.closure": "printed"}), COARSE)
    assert [row.key for row in twice.rows] == list(THEORIES[:2])
    fibres = compare(YIELDING.replace({"numerics.fibres": 4}), COARSE)
    assert ["fibres" in row.trajectory.summary["effects"] for row in fibres.filaments] == [True, False, False]
    assert yielding.warnings == ()
    wide = compare(YIELDING.replace({"filament.width": None, "run.effects": "paper"}), COARSE)
    assert len(wide.warnings) == 1 and "plane stress" in wide.warnings[0] and "0.3 mm" in wide.warnings[0]
    # The elements of unit width are the same: only the filament's necking coefficient knows.
    assert np.array_equal(wide.elements.midpoint, yielding.elements.midpoint)


def test_unknowns_are_those_of_the_graph(yielding: Comparison) -> None:
    for row in yielding.filaments:
        scene = row.trajectory.scene
        effects = choose_effects(scene)
        equations = derive(effects.terms(), SECTIONS["rectangle"], scene.run.closure)
        graph = assemble(equations, choose_grid(scene), effects.names, choose_theory(scene, equations))
        names = [name.split("[")[0] for name in (*graph.state_names, *graph.algebraic_names)]
        assert row.dofs == sum(name in ("x", "y", "psi") for name in names)


def test_an_interrupted_run_resumes(yielding: Comparison, tmp_path: Path) -> None:
    checkpoint, heard = tmp_path / "new" / "elements.npz", []

    class Stop(Silence):
        def update(self, simulated_time: float, step_size: float | None) -> None:
            signal.raise_signal(signal.SIGINT)

    @contextmanager
    def stopping(what: str) -> Iterator[Silence]:
        yield Stop() if what == "elements" else Silence()

    @contextmanager
    def listening(what: str) -> Iterator[Silence]:
        heard.append(what)
        yield Silence()

    with pytest.raises(KeyboardInterrupt):
        compare(YIELDING, COARSE, checkpoint=checkpoint, progress=stopping)
    assert checkpoint.is_file()
    resumed = compare(YIELDING, COARSE, checkpoint=checkpoint, progress=listening)
    assert heard == ["elements", *(row.name for row in yielding.rows)]
    assert np.array_equal(resumed.elements.midpoint, yielding.elements.midpoint)
    assert np.array_equal(resumed.elements.rate, yielding.elements.rate)


def test_refusals_and_failures_leave_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    circle = {"filament.section": "circle", "filament.width": None}
    for changes, path in (
        ({"ends.left": "pinned"}, "ends.left"),
        (circle, "filament.section"),
        ({"run.effects": ["shaer"]}, "run.effects"),
    ):
        with pytest.raises(SceneError, match=path):
            compare(YIELDING.replace(changes), COARSE, checkpoint=tmp_path / "out" / "elements.npz")
    monkeypatch.setenv("CC", "nonexistent")
    with pytest.raises(SoftcatError, match="no C compiler"):
        compare(YIELDING, COARSE, checkpoint=tmp_path / "deep" / "er" / "elements.npz")
    assert not list(tmp_path.iterdir())


def with_midpoints(comparison: Comparison, reference: np.ndarray, midpoints: list[np.ndarray]) -> Comparison:
    run = replace(comparison.elements, midpoint=reference)
    rows = [
        replace(row, midpoint=midpoint, discrepancy=discrepancy(run.time, midpoint, reference))
        for row, midpoint in zip(comparison.rows, midpoints, strict=True)
    ]
    return replace(comparison, reference=run, rows=tuple(rows))


def run_away(comparison: Comparison) -> Comparison:
    """The printed closure leaves every picture; the filament's run ended half way, in failure."""
    time, elements = comparison.elements.time, comparison.elements.midpoint
    own, material, _ = (row.midpoint for row in comparison.rows)
    found = with_midpoints(
        comparison, elements, [np.where(time <= time[-1] / 2, own, np.nan), material, 1e4 * elements]
    )
    run = found.filament.trajectory
    run = replace(run, data=run.data.isel(time=slice(0, 11)), outcome=Outcome.no_convergence)
    return replace(found, rows=(replace(found.filament, trajectory=run), *found.rows[1:]))


def at_rest(comparison: Comparison) -> Comparison:
    zero = np.zeros_like(comparison.elements.midpoint)
    found = with_midpoints(comparison, zero, [zero] * 3)
    run = found.elements
    return replace(found, reference=replace(run, x=run.x[:1] + 0 * run.x, y=0 * run.y, rate=0 * run.rate))


def test_pictures_tables_and_documents_of_every_case(yielding: Comparison, tmp_path: Path) -> None:
    cases: tuple[Callable[[Comparison], Comparison], ...] = (
        lambda c: c, run_away, at_rest, lambda c: replace(c, rows=c.rows[:1]),
    )  # fmt: skip
    for number, case in enumerate(cases):
        written = {path.name for path in write_comparison(case(yielding), tmp_path / str(number))}
        assert written == FILES - {"elements.npz", "vtk"}
        assert b"NaN" not in json_bytes(case(yielding).to_dict())
    broken = run_away(yielding)
    assert finite(broken.to_dict())["filament"]["midpoint_final_m"] is None
    assert finite(at_rest(yielding).to_dict())["errors"]["filament"]["mean"] is None
    errors = pd.read_csv(tmp_path / "1" / "compare_errors.csv", dtype={"filament": str})
    errors["filament"] = errors["filament"].astype(float)
    assert list(errors["what"]) == ["error"] * 4 + ["mean error", "largest error"]
    assert np.isnan(errors["filament"][3:5]).all() and errors["filament"][1] == broken.filament.discrepancy.at[1]
    assert list(errors["time_s"][:4]) == [broken.elements.time[k] for k in (2, 5, 10, 20)]
    shapes = shapes_frame(broken)
    assert len(shapes) == 3 * len(broken.elements.X) and shapes["elements_y_m"][0] == broken.elements.y[2, 0]


def test_each_rate_is_drawn_where_it_was_measured(yielding: Comparison) -> None:
    thickness = YIELDING.filament.thickness

    def marked(run: ElementRun) -> ElementRun:
        """An undeformed strip whose rate says where it was measured, and that stops flowing."""
        share = np.linspace(1, 0, len(run.rate_time))
        share[3:] = 0
        rate = share[:, None, None] * (1.0 + 100 * run.point[..., 0] + 10 * run.point[..., 1])
        return replace(run, rate=rate, x=np.broadcast_to(run.X, run.x.shape).copy(), y=np.zeros_like(run.y))

    run = marked(yielding.elements)
    fields = rate_fields(run, thickness)
    # Of the moments, that at 10 % flows still; the fastest is the first; the last is always there.
    assert [field.time for field in fields] == [run.time[0], run.time[2], run.time[-1]]
    first = fields[0]
    np.testing.assert_allclose(first.rate, np.sqrt(3) * (1 + 100 * first.X + 10 * first.Y))
    # Undeformed, a quarter of an element surrounds the reference position of its Gauss point.
    for corners, point in ((first.x, first.X), (first.y, first.Y)):
        assert np.all((corners[:-1, :-1] < point) & (point < corners[1:, 1:]))
    # A strip that turns stays as thick as its stretch allows; sections at midspan and clamp are vertical.
    run = yielding.elements
    for field in rate_fields(run, thickness):
        drawn = np.hypot(*(np.diff(c[:, [0, -1]], axis=1)[:, 0] for c in (field.x, field.y)))
        frame = int(np.abs(run.time - field.time).argmin())
        stretch = np.hypot(np.gradient(run.x[frame], run.X), np.gradient(run.y[frame], run.X))
        np.testing.assert_allclose(drawn, thickness / np.sqrt(stretch))
        assert max(np.ptp(field.x[0]), np.ptp(field.x[-1])) < 1e-9 * thickness


def test_files_table_and_document(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "deep" / "out"
    done = softcat("compare", "continual-descent", "-o", str(output), *SHORT, "--mesh", "8x2")
    assert done.status == 0 and {path.name for path in output.iterdir()} == FILES
    # As wide as thick.
    assert all(text in done.out for text in ("8 × 2", "error at t = 10", "plane stress"))
    found = json.loads((output / "compare.json").read_text())
    elements = found["elements"]
    assert (found["outcome"], elements["along"], elements["through"]) == ("solved", 8, 2)
    for who in THEORIES:
        assert min(found[who]["wall_s"], found[who]["dofs"]) > 0
        final = found[who]["midpoint_final_m"] / elements["midpoint_final_m"] - 1
        assert found["errors"][who]["at"][-1] == pytest.approx(-final)
    assert found["errors"]["time_elastic"] == pytest.approx([1, 2, 5, 10])
    errors = pd.read_csv(output / "compare_errors.csv", dtype=str)
    assert list(errors["filament"][:4].astype(float)) == found["errors"]["filament"]["at"]


def stop_at_once(self: IntegrationProgress, simulated_time: float, step_size: float | None) -> None:
    signal.raise_signal(signal.SIGINT)


def test_ctrl_c_stores_the_checkpoint_which_nothing_else_may_use(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = ("compare", "arrested-overdamped", *sets("run.effects=paper"), *SHORT, "--mesh", "8x2")
    straight, broken = tmp_path / "straight", tmp_path / "broken"
    done = softcat(*asked, "-o", str(straight), "-q")
    assert (done.status, done.out, done.err) == (0, "", "")
    with monkeypatch.context() as patch:
        patch.setattr(IntegrationProgress, "update", stop_at_once)
        stopped = softcat(*asked, "-o", str(broken))
    assert stopped.status == 130 and "interrupted; the same command goes on" in stopped.err
    assert names_in(broken) == {"elements.npz"}
    resumed = softcat(*asked, "-o", str(broken))
    assert resumed.status == 0 and "go on from" in resumed.out
    for name in ("compare_midpoint.csv", "compare_clamp_strain.csv", "compare_plastic_rate.csv"):
        assert (straight / name).read_bytes() == (broken / name).read_bytes()
    before = {path: path.read_bytes() for path in broken.rglob("*") if path.is_file()}
    other = softcat(*asked, "-o", str(broken), "--fixed-face")
    assert other.status == 2 and "another problem" in other.err
    assert {path: path.read_bytes() for path in broken.rglob("*") if path.is_file()} == before


def test_an_answer_not_to_be_trusted_exits_1_and_still_writes(softcat: Softcat, tmp_path: Path) -> None:
    changes = (*sets("run.effects=paper", "run.frames=11", "numerics.cells=20"), "--mesh", "4x2", "-q")
    done = softcat("compare", "edge-of-rupture", "-o", str(tmp_path), *changes)
    assert done.status == 1 and done.err.startswith("softcat: localised")
    assert {path.name for path in tmp_path.iterdir()} == FILES
    assert json.loads((tmp_path / "compare.json").read_text())["outcome"] == "localised"


VARY = ("continual-descent", "--vary")
BAD = [
    (("no-yield", "--mesh", "64"), "no mesh"),
    (("no-yield", "--mesh", "0x4"), "0 elements along"),
    (("no-yield", "--mesh", "8x3"), "even number"),
    (("no-yield", "--mesh", "-8x2"), "no mesh"),
    (("ink-bridge",), "filament.section"),
    (("no-yield", *sets("ends.left=pinned", "ends.right=pinned")), "ends.right"),
    (("no-such-scene",), "no-such-scene"),
    (("no-yield", *sets("run.effects=['shaer']")), "did you mean 'shear'"),
    (("maxwell-slow", *sets("model=small-deflection")), "model"),
    (("no-yield", *sets("groups.gravity=0")), "gravity"),
    ((*VARY, "groups.delta=0.03"), "has one value"),
    ((*VARY, "groups.delta=0.03,0.06", "--mesh", "4x2"), "half as many must be a mesh too"),
    ((*VARY, "groups.detla=0.03,0.06"), "detla"),
    ((*VARY, "filament.section=rectangle,circle"), "filament.section"),
    (("continual-descent", *sets("filament.section=circle"), "--write-input-only"), "filament.section"),
    ((*VARY, "groups.G=0.4,0.5", "--engine", "calculix"), "our own elements"),
]


def test_bad_input_is_one_message_and_leaves_nothing(softcat: Softcat, tmp_path: Path) -> None:
    output = tmp_path / "out"
    for arguments, message in BAD:
        done = softcat("compare", *arguments, "-o", str(output))
        assert done.status == 2 and message in done.err, (arguments, done.err)
        assert not output.exists(), arguments


def test_without_calculix_there_is_a_deck_or_one_message(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("softcat_sym.reference.calculix.find_calculix", lambda: None)
    asked = ("compare", "continual-descent", *SHORT, "--mesh", "6x2")
    missing = softcat(*asked, "-o", str(tmp_path / "out"), "--engine", "calculix")
    assert missing.status == 2 and "calculix-ccx" in missing.err and "--write-input-only" in missing.err
    assert not (tmp_path / "out").exists()
    done = softcat(*asked, "-o", str(tmp_path / "out"), "--write-input-only")
    assert done.status == 0 and "calculix/deck.inp" in done.out
    assert names_in(tmp_path / "out") == {"scene.toml", "calculix/deck.inp"}


@needs_calculix
def test_calculix_filament_and_elements_side_by_side(
    softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ctrl-C while the elements run: the same command resumes, without CalculiX, to the same numbers."""
    ran: list[str] = []
    own, execute = IntegrationProgress.update, calculix._execute

    def stop(self: IntegrationProgress, simulated_time: float, step_size: float | None) -> None:
        own(self, simulated_time, step_size)
        if ran == ["finished"]:
            signal.raise_signal(signal.SIGINT)

    def executed(program: str, folder: Path, progress: object) -> None:
        ran.append("begun")
        execute(program, folder, progress)
        ran[-1] = "finished"

    monkeypatch.setattr(calculix, "_execute", executed)
    asked = ("compare", "continual-descent", "--engine", "both", *SHORT, *NARROW, "--mesh", "6x2")
    cut, output = tmp_path / "cut", tmp_path / "out"
    with monkeypatch.context() as patch:
        patch.setattr(IntegrationProgress, "update", stop)
        assert softcat(*asked, "-o", str(cut)).status == 130
    assert softcat(*asked, "-o", str(cut)).status == 0 and ran == ["finished"]
    done = softcat(*asked, "-o", str(output), "--fresh")
    assert done.status == 0 and "CalculiX 6 × 2" in done.out
    assert (cut / "compare_midpoint.csv").read_bytes() == (output / "compare_midpoint.csv").read_bytes()
    own_files = {"compare.json", "compare_midpoint.csv", "compare_midpoint.png", "scene.toml", "elements.npz"}
    assert names_in(output) == own_files | {f"calculix/deck.{end}" for end in ("inp", "dat", "sta", "cvg")}
    found = json.loads((output / "compare.json").read_text())
    assert found["warnings"] == [] and found["engine"] == "calculix"
    midpoints = pd.read_csv(output / "compare_midpoint.csv", dtype=str).astype(float)
    for who in ("filament", "elements"):
        assert midpoints[f"{who}_m"].iloc[-1] == found[who]["midpoint_final_m"]
        apart = 1 - found[who]["midpoint_final_m"] / found["calculix"]["midpoint_final_m"]
        assert found["errors"][who]["at"][-1] == pytest.approx(apart) and abs(apart) < 0.05


@needs_calculix
def test_ctrl_c_in_calculix_writes_nothing(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(IntegrationProgress, "update", stop_at_once)
    long = (*sets("groups.duration=460"), *NARROW, "--mesh", "32x4", "--engine", "calculix")
    done = softcat("compare", "continual-descent", "-o", str(tmp_path / "out"), *long)
    assert done.status == 130 and "interrupted" in done.err and not (tmp_path / "out").exists()


def test_varied_and_interrupted(softcat: Softcat, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    varied = ("compare", "continual-descent", *SHORT, *sets("filament.width=0.1 mm"), "--mesh", "4x4", "-q", "--vary")
    output, heard = tmp_path / "out", list[str]()

    def stop(self: IntegrationProgress, simulated_time: float, step_size: float | None) -> None:
        heard.append(self.stages[-1].name)
        if heard[-1].startswith("groups.delta = 0.045, 4 x 4"):
            signal.raise_signal(signal.SIGINT)

    with monkeypatch.context() as patch:
        patch.setattr(IntegrationProgress, "update", stop)
        broken = softcat(*varied, "groups.delta=0.03,0.06,0.045", "-o", str(output))
    assert broken.status == 130 and "the same command goes on from" in broken.err
    # Two meshes of the first value, and what there was of the second.
    assert [path.name for path in output.iterdir()] == ["elements"] and len(names_in(output)) == 3
    assert softcat(*varied, "groups.delta=0.03,0.06,0.045", "-o", str(output)).status == 0
    tables = {f"compare_vary_{name}.csv" for name in ("errors", "cost", "limit")}
    files = {"compare.json", "scene.toml", "elements", "compare_vary.png"}
    assert {path.name for path in output.iterdir()} == files | tables
    found = json.loads((output / "compare.json").read_text())
    assert [value["value"] for value in found["values"]] == [0.03, 0.045, 0.06]
    for value in found["values"]:
        own = value["filament"]["midpoint_final_m"] / value["elements"]["midpoint_final_m"] - 1
        theory = value["theory_errors"]["filament"]
        assert theory["errors"][3] == pytest.approx(own, abs=1.01 * theory["grid"])
        assert theory["dofs_ratio"] == pytest.approx(value["elements"]["dofs"] / value["filament"]["dofs"])
    assert len(pd.read_csv(output / "compare_vary_errors.csv")) == 3 * (2 + 3)
    limits = pd.read_csv(output / "compare_vary_limit.csv")
    assert {name.replace(" ", "_") for name in limits["theory"]} == set(THEORIES)
    done = softcat(*varied, "groups.V=2.6:260:2:log", *sets("run.effects=paper"), "-o", str(tmp_path / "speed"))
    assert (done.status, done.out, done.err) == (0, "", "")
    assert json.loads((tmp_path / "speed" / "compare.json").read_text())["slender_limit"] is None


def test_files_of_a_comparison_with_calculix(yielding: Comparison, tmp_path: Path) -> None:
    """With a run in the shape of CalculiX's, for machines without it."""
    own, run = yielding.filament, yielding.elements
    arrays = {name: getattr(run, name) for name in ("time", "midpoint", "X", "x", "y", "elastic_time", "dofs", "steps")}
    stood_in = calculix.CalculixRun(
        **arrays, mesh=run.mesh, clamp=run.clamp, wall=1.0, files={"deck.inp": b"*HEADING", "deck.sta": b""}
    )
    write_comparison(replace(yielding, reference=stood_in, rows=(own,)), tmp_path)
    own_files = {"compare.json", "compare_midpoint.csv", "compare_midpoint.png", "scene.toml"}
    assert names_in(tmp_path) == own_files | {"calculix/deck.inp", "calculix/deck.sta"}
    found = json.loads((tmp_path / "compare.json").read_text())
    assert found["errors"]["filament"]["mean"] == own.discrepancy.mean
    assert found["calculix"]["midpoint_final_m"] == run.midpoint[-1] and "CalculiX" in found["errors"]["definition"]
