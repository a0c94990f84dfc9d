"""What strangers met: every point of their reports, with what happens now, as one table.

`pytest -m slow tests/slow/test_strangers.py` prints the table after the last test.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path
from time import process_time

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym import Run
from softcat_sym.design.experiment import design_experiment
from softcat_sym.fitting.result import FitOutcome
from tests.common.table import rows_of
from tests.test_breaking import cantilever

pytestmark = pytest.mark.slow

Says = Callable[..., None]

FOLDER = Path(__file__).parents[1] / "cases"


@pytest.fixture(scope="module")
def says(request: pytest.FixtureRequest) -> Iterator[Says]:
    """Take a row of the table: the point, what was met, what happens now."""
    rows = list[tuple[str, str, str]]()

    def say(point: str, met: str, now: object) -> None:
        rows.append((point, met, str(now)))

    yield say
    lines = rows_of(("point", "what strangers met", "what happens now"), sorted(rows))
    terminal = request.config.pluginmanager.getplugin("terminalreporter")
    for line in ("", *lines) if terminal is not None else ():
        terminal.write_line(line)


# --- A: checks on random draws


# --- B1: the regime does not depend on the frames


# --- B2: a creep is not a swing


# --- B3: errors are relative to the largest displacement


# --- B4: natural frequencies of what hangs slack


# --- B5: polymer threads


def test_a_thread_of_chains_that_converges_is_no_neck(says: Says) -> None:
    """A thread whose strain gathers at its pins: -0.29048 m, from 320 cells at tolerances of 1e-9."""
    found, cut = dict[int, Run](), dict[int, Run]()
    for cells in (20, 40, 80, 160):
        changes = {"numerics.cells": cells, "numerics.estimate": False}
        found[cells] = sc.simulate(sc.load_scene(FOLDER / "giesekus-thread.toml", changes))
        cut[cells] = sc.simulate(sc.load_scene(FOLDER / "giesekus-thread.toml", changes | {"material.mobility": 0.9}))
    sags = [run.summary["midpoint_final_m"] for run in found.values()]
    shares = [[share_of_one_cell(run) for run in runs.values()] for runs in (found, cut)]
    told = [f"{' '.join(f'{one:.2f}' for one in share)} of its half" for share in shares]
    met = "a giesekus thread refused as localised"
    says("B5", met, f"midpoint {' '.join(f'{sag:.4f}' for sag in sags)} m with {' '.join(map(str, found))} cells")
    says("B5", met, f"solved: the last cell carries {told[0]}, less on finer grids")
    says("B5", met, f"refused with a mobility of 0.9, which cuts it: {told[1]} on every grid")
    assert sags == pytest.approx([-0.29048] * 4, rel=0.01) and sags[-1] == pytest.approx(-0.29048, rel=1e-4)
    assert {run.outcome for run in found.values()} == {sc.Outcome.solved}
    assert {run.outcome for run in cut.values()} == {sc.Outcome.localised}
    assert shares[0][-1] < 0.75 * shares[0][0] and shares[1][-1] > 0.95 * shares[1][0]


def share_of_one_cell(run: Run) -> float:
    """What the last cell of a half carries of its elongation."""
    elongation = (run.fields["stretch"][-1] - 1) * np.diff(run.fields["X_node"])
    return float(elongation[0] / np.sum(elongation[: len(elongation) // 2]))


# --- B6: the time of breaking


def test_the_instant_of_a_break_has_an_error_and_its_strain_a_name(says: Says) -> None:
    """The cantilever of tests/test_breaking.py: log(1 + eps0 (1 + t/tau)) = 0.012; ringing, by a tolerance of 1e-6."""
    exact, met = 1.801 * (math.expm1(0.012) / 0.004 - 1), "a breaking time without an error, of a strain without a name"
    for name, effects, expected in (("creeps", ["bending", "viscous-flow"], exact), ("rings", "auto", 2.93490)):
        scene, *_ = cantilever(**{"run.effects": effects, "run.frames": 41})
        found = sc.simulate(scene).summary["broken"]
        told = f"{found['time_s']:.5g} s ± {found['time_error_s']:.1g} s, right: {expected:.5g} s"
        says("B6", met, f"{name}: {told}, true strain of the outer fibre {found['strain']:.4g}")
        assert abs(found["time_s"] - expected) < found["time_error_s"] < 0.01 * expected
        assert found["strain"] == pytest.approx(0.012, rel=1e-3)


# --- B7: what a fit calls identified


def test_a_fit_calls_poorly_determined_what_it_knows_to_a_factor_of_seven(says: Says) -> None:
    """README's own command, and the experiment that is to tell more."""
    samples = Path(sc.__file__).parent / "samples"
    scene, names = sc.load_scene(samples / "my-ink.toml"), ["viscosity", "yield_stress"]
    found = sc.fit(samples / "film.csv", scene, names, calibrated=True, profiles=False)
    for one in found.parameters.values():
        low, high = one.ci95
        assert low is not None and high is not None
        assert one.verdict == ("identified" if high < 2 * low else "poorly determined")
        told = f"{one.name} {one.best:.3g} {one.unit}, 95 % {low:.3g} to {high:.3g}: {one.verdict}"
        says("B7", "a viscosity known to a factor of seven called identified", f"{told}; outcome {found.outcome.word}")
    assert [one.verdict for one in found.parameters.values()] == ["poorly determined", "identified"]
    assert found.outcome is FitOutcome.not_identified and found.outcome.converged
    with pytest.raises(sc.SoftcatError, match="identified is less than 2") as refused:
        design_experiment(scene, names, "6 um", {})
    says("B7", "experiment, of the same two: nothing better than 100 %", str(refused.value).split(";")[0])


# --- B8: what explain says an effect is worth


def test_an_effect_is_told_by_the_sag_without_it(says: Says) -> None:
    """What explain foresees of a slowly loaded strand beside what runs without the effect show."""
    scene = sc.load_scene("no-yield", {"numerics.estimate": False})
    reasons, names = sc.explain(scene).to_dict()["effects"], list(sc.simulate(scene).summary["effects"])
    told = {one["effect"]: one["reason"] for one in reasons if one["in_force"]}
    assert not any("whole sag" in text or "worth" in text for text in told.values())
    for name, along in {"bending": ("shear",), "inertia": ()}.items():
        without = sc.simulate(scene.replace({"run.effects": [one for one in names if one not in (name, *along)]}))
        run = f"a run without it ends at {1e3 * abs(without.summary['midpoint_final_m']):.2g} mm"
        says("B8", "each of three effects is worth the whole sag", f"{name}: {told[name]}; {run}")
    assert "without it" in told["bending"] and "swings" in told["inertia"]


# --- B9: the error of the slender theory


# --- C1: the price of a run is said before it starts


# --- C2: a run that falls for ever ends


# --- C3: time limits and interrupts


# --- C4: helices and histories are bounded when a scene is read


@pytest.mark.parametrize(
    ("name", "met", "path"),
    [
        ("helix-too-many-turns", "a helix that never loads", "filament.shape"),
        ("history-dips-below-zero", "a viscosity that is negative between two samples", "material.viscosity"),
    ],
)
def test_a_scene_is_bounded_when_it_is_read(says: Says, name: str, met: str, path: str) -> None:
    began = process_time()
    with pytest.raises(sc.SceneError) as refused:
        sc.load_scene(FOLDER / f"{name}.toml")
    spent, (fault,) = process_time() - began, refused.value.faults
    says("C4", met, f"{1e3 * spent:.0f} ms: {fault.path}: {fault.found}")
    assert fault.path == path and spent < 2


# --- C5: time limits of fits


# --- D1: clearing the cache leaves the user's files alone


# --- D2: nobody else's code or results are loaded


# --- D3: a full disk is no crash
