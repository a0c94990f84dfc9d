"""Where the one-dimensional theory ends: its error against elements over delta, G and V, its limit, and its cost.

Set ``SOFTCAT_PICTURES`` to a folder to keep the charts.
"""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.cache import cache_folder
from softcat_sym.plotting.style import png
from softcat_sym.plotting.theory_end import remarks, tables, theory_end_figure
from softcat_sym.scene.scene import Scene
from softcat_sym.studies.theory_end import TheoryEnd, TheoryError, Variation, where_theory_ends
from tests.common.elements import PLANE_STRESS
from tests.common.table import show

pytestmark = pytest.mark.slow

NAME = "continual-descent"
PUBLISHED = "published, material closure"
OWN = "filament"

# Below V = 10 the filament tears off before the end: elements fall by spans, and both theories are refused.
VARIED = {
    "delta": ("0.015", "0.02", "0.03", "0.045", "0.06"),
    "G": ("0.5", "1", "1.9", "3"),
    "V": ("10", "26", "80", "260"),
}


@cache
def study(group: str) -> TheoryEnd:
    """The elements are in the user's cache, each value as soon as it is finished."""

    def scene_with(*changes: str) -> Scene:
        narrow = [f"{path}={value}" for path, value in PLANE_STRESS.items()]
        return sc.load_scene(NAME, [*narrow, *changes])

    variation = Variation(f"groups.{group}", VARIED[group])
    end = where_theory_ends(scene_with(), variation, scene_with, cache_folder() / "elements")
    for title, header, rows in tables(end):
        show(title, header, rows)
    print("\n".join(remarks(end)))
    if place := os.environ.get("SOFTCAT_PICTURES"):
        (Path(place) / f"theory-end-{group}.png").write_bytes(png(theory_end_figure(end)))
    return end


def theories(end: TheoryEnd, name: str) -> list[TheoryError]:
    return [each.theories[name] for each in end.measured]


def at(found: list[TheoryError]) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Errors at the four instants; shape (values, 4)."""
    return np.array([theory.error[:4] for theory in found])


def check_judges(end: TheoryEnd) -> None:
    """What the meshes and the grids leave is well below what is claimed of the published theory."""
    for each, theory in zip(end.measured, theories(end, PUBLISHED), strict=True):
        assert abs(each.mesh[-1]) < 0.2 * abs(theory.error[-1])
        assert theory.grid < 0.1 * abs(theory.error[-1])


def test_slenderness() -> None:
    """Without thickness both theories are exact, within a tenth of a percent; the printed closure is not."""
    end = study("delta")
    check_judges(end)
    for name in (OWN, PUBLISHED):
        assert all(theory.trusted for theory in theories(end, name))
        for limit in end.limits[name][:4]:
            assert limit is not None
            assert abs(limit["intercept"]) < limit["uncertainty"] < 0.0015
    orders = [limit["order"] for limit in end.limits[PUBLISHED][:4] if limit is not None]
    assert orders == pytest.approx([1.1] * 4, abs=0.12)
    printed = end.limits["published, printed closure"][3]
    assert printed is not None
    assert printed["intercept"] > 0.03 > 10 * printed["uncertainty"]
    # Shear and fibres leave at most a fifth of the published error until half of the run, less than half in the end.
    own, published = np.abs(at(theories(end, OWN))), np.abs(at(theories(end, PUBLISHED)))
    assert np.all(own[:, :3] < 0.25 * published[:, :3])
    assert np.all(own[:, 3] < 0.65 * published[:, 3])


def test_weight() -> None:
    end = study("G")
    # Light filaments hang from a hinge at the clamp, which half as many elements do not resolve.
    lightest = theories(end, PUBLISHED)[0].row.trajectory
    assert lightest.summary["regime"] == "arrested-overdamped"
    heavy = at(theories(end, PUBLISHED))[-2:]
    assert np.all((heavy < -0.01) & (heavy > -0.025))
    assert np.all(np.abs(at(theories(end, OWN))[-2:, :3]) < 0.003)


def test_viscosity() -> None:
    """The less viscous, the farther it falls in the same time and the more it necks, until it tears."""
    end = study("V")
    published, own = theories(end, PUBLISHED), theories(end, OWN)
    check_judges(end)
    assert np.all(np.diff(at(published)[:, 3]) > 0)
    assert [theory.trusted for theory in own] == [False, True, True, True]
    assert all(theory.trusted for theory in published)
    assert np.all(np.abs(at(own)[2:]) < 0.004)


def test_what_it_costs() -> None:
    """Cheap elements, which judge better than any filament theory, take tens of times as long; fine ones hundreds."""
    for group in VARIED:
        for each in study(group).measured:
            for theory in list(each.theories.values())[:2]:
                solve = theory.row.trajectory.summary["wall_s"]["solve"]
                assert each.coarse.wall > 10 * solve
                assert each.comparison.elements.wall > 100 * solve
                assert each.comparison.elements.steps > 500 * theory.row.trajectory.summary["steps"]
