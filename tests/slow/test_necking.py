"""The underdamped scene necks at its clamps: converged with the gradient, refused without it, and near rupture beyond.

The sag rings with a period of some 11 t~, so means over 60 < t~ < 460 are compared. No constant is fitted: beta is that
of plane stress, 1/48, and kappa_s is 5/6.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.selection import choose_effects
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.estimates.scaling import neck_length
from softcat_sym.results.verdict import neck_strain
from tests.common.elements import PUBLISHED, filament, mean, plane
from tests.common.random_scenes import NUMBER, SEED, random_scenes
from tests.common.table import show

pytestmark = pytest.mark.slow

NAME, CELLS = "arrested-underdamped", (40, 80)
TIGHT: Mapping[str, object] = {"numerics.rtol": 1e-4, "numerics.grading": 10.0}
"""The error of the integrator must not show beside a tenth of a percent; the ratio of the cells is fixed."""
HEADER = ("", "mean sag/L", "stretch at the clamp", "strain of the neck", "outcome", "because")


def run(cells: int, fibres: int = 6, G: float = 0.25, **more: object) -> sc.Run:
    # The bundled value is left alone, so that a run that another check made is found again.
    gravity = {} if G == 0.25 else {"groups.G": G}
    changes = {f"numerics.{name}": value for name, value in more.items()}
    return filament(NAME, {**TIGHT, "numerics.cells": cells, "numerics.fibres": fibres, **gravity, **changes})


def neck(found: sc.Run) -> float:
    lengths = np.diff(found.data.X_node.values)
    return neck_strain(found.data.stretch.values[-1], lengths, neck_length(found.scene))


def table(title: str, runs: Mapping[str, sc.Run]) -> list[float]:
    """Print runs; return the mean sags, none of those that are refused: a torn filament is followed no further."""
    scene = plane(NAME)
    rows, means = [], [-mean(scene, found) if found.outcome.is_success else math.nan for found in runs.values()]
    for (name, found), sag in zip(runs.items(), means, strict=True):
        judged = found.outcome.name, found.summary["message"]
        rows.append([name, f"{sag:.5g}", f"{found.data.stretch.values[-1].max():.4g}", f"{neck(found):.3g}", *judged])
    show(title, HEADER, rows)
    return means


def test_with_the_gradient_the_grids_agree() -> None:
    runs = {f"N = {cells}, 6 fibres": run(cells) for cells in CELLS}
    means = table("G = 0.25, V = 0.4", runs)
    necks = [float(f"{neck(found):.3g}") for found in runs.values()]
    assert all("necking-gradient" in found.summary["effects"] for found in runs.values())
    assert all(found.outcome is sc.Outcome.solved for found in runs.values())
    assert max(means) / min(means) < 1.015
    assert max(necks) / min(necks) < 1.05


def test_without_the_gradient_the_answer_is_refused() -> None:
    changes = {**TIGHT, "run.effects": (*PUBLISHED, "shear", "fibres")}
    runs = {f"N = {cells}, 6 fibres": filament(NAME, {**changes, "numerics.cells": cells}) for cells in CELLS}
    table("G = 0.25, V = 0.4 without the gradient", runs)
    for found in runs.values():
        assert found.outcome is sc.Outcome.localised and not found.outcome.is_success
        assert "necking-gradient" in found.outcome.value


def test_the_means_do_not_depend_on_the_integrator() -> None:
    runs = {"rosenbrock": run(40), "idas": run(40, solver="idas")}
    rings, damps = table("G = 0.25, N = 40, 6 fibres", runs)
    assert [found.summary["solver"] for found in runs.values()] == list(runs)
    assert abs(damps / rings - 1) < 2e-3


@pytest.mark.parametrize("G", [0.3, 0.4])
def test_near_rupture(G: float) -> None:
    # On twice the cells, and with twice the fibres.
    cases = ((40, 6), (80, 6), (40, 12))
    runs = {f"N = {cells}, {fibres} fibres": run(cells, fibres, G) for cells, fibres in cases}
    sags = table(f"G = {G}, V = 0.4, with the gradient", runs)
    expected = sc.Outcome.localised if G == 0.4 else sc.Outcome.solved
    assert all(found.outcome is expected for found in runs.values())
    assert G == 0.4 or max(sags) / min(sags) < 1.015


def test_where_it_is_left_out_it_changes_little() -> None:
    """Below free ends, between pins without yielding, and in hinges that are short beside the sag."""
    drawn, rows = random_scenes(NUMBER, SEED), []
    scenes = {"modelling-clay": sc.load_scene("modelling-clay")} | {f"random {k}": drawn[k] for k in (12, 72)}
    for name, scene in scenes.items():
        quick = scene.replace({"numerics.estimate": False, "run.dimensions": 2})
        chosen = {*choose_effects(quick).names}
        assert NECKING_GRADIENT.name not in chosen
        lists = chosen, chosen | {NECKING_GRADIENT.name, *NECKING_GRADIENT.needs, YIELDING.name}
        left, taken = (sc.simulate(quick.replace({"run.effects": sorted(one)})).data.midpoint.values for one in lists)
        worth = float(np.abs(taken - left).max() / np.abs(taken).max())
        rows.append([name, f"{worth:.1e}", f"{scene.run.accuracy:g}"])
        assert worth < scene.run.accuracy / 3, rows
    show("necking gradient left out", ["scene", "changes the midpoint by", "accuracy"], rows)
