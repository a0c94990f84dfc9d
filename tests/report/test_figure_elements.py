"""Snapshots of the elements: the same run as without them, the geometry of a strip, interruption and resumption."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.plotting.paper_figures import boundary
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.reference.elements import run_elements
from softcat_sym.scene.scene import Scene, elastic_time
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.paper_figures import ElementFilm, film_elements

MESH = Mesh(8, 2)
INSTANTS = (6.0, 12.0, 24.0)


def falling() -> Scene:
    """The paper's descent while it falls; it flows from t~ = 6 or so on."""
    scene = sc.load_scene("continual-descent", {"filament.width": "0.06 mm", "run.frames": 13})
    return scene.replace({"run.duration": f"{24 * elastic_time(scene)!r} s"})


@pytest.fixture(scope="module")
def film(tmp_path_factory: pytest.TempPathFactory) -> ElementFilm:
    return film_elements(falling(), MESH, INSTANTS, tmp_path_factory.mktemp("film"), "falling", Silence())


def areas(polygons: np.ndarray) -> np.ndarray:
    """Signed areas by the shoelace formula; shape (polygons,)."""
    x, y = polygons[..., 0], polygons[..., 1]
    return np.sum(x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y, axis=1) / 2


def test_run_is_that_of_the_elements_alone(film: ElementFilm) -> None:
    alone = run_elements(falling(), MESH)
    assert np.array_equal(film.run.midpoint, alone.midpoint)
    assert np.array_equal(film.run.rate, alone.rate)


def test_snapshots_stand_where_the_run_does(film: ElementFilm) -> None:
    """Against what the run itself keeps of these frames: its centreline and its plastic rates."""
    span, run = falling().filament.span, film.run
    for shot, instant in zip(film.snapshots, INSTANTS, strict=True):
        frame = int(np.argmin(np.abs(run.time / run.elastic_time - instant)))
        assert shot.time == pytest.approx(instant)
        # The upper edges of the lower row of elements are the centreline: corners 6, 5, 4 are its nodes.
        lower = shot.outline[:: MESH.through]
        line = np.concatenate([lower[:, 6], lower[-1:, 4]])
        assert np.allclose(line, np.column_stack([run.x[frame], run.y[frame]])[::2] / span, rtol=0, atol=1e-14)
        field = int(np.argmin(np.abs(run.rate_time - run.time[frame])))
        assert np.allclose(shot.rate, np.sqrt(3) * run.rate[field].ravel() * run.elastic_time, rtol=1e-12)
    assert film.snapshots[-1].rate.min() > 0
    assert film.at(20.0) is film.snapshots[-1]


def test_quarters_and_outline_cover_the_strip_once(film: ElementFilm) -> None:
    for shot in film.snapshots:
        whole = areas(boundary(shot, MESH.through)[None])[0]
        quarters = np.abs(areas(shot.quarter))
        # Edges are parabolas, drawn by their chords: quarters and outline agree but for what lies between.
        assert quarters.sum() == pytest.approx(whole, rel=1e-3)
        assert areas(shot.outline).sum() == pytest.approx(whole, rel=1e-12)
        # A Gauss point lies within its quarter: nearer to that quarter's middle than to any other's.
        middles = shot.quarter.mean(axis=1)
        nearest = np.argmin(np.linalg.norm(shot.place[:, None] - middles[None], axis=2), axis=1)
        assert np.array_equal(nearest, np.arange(len(shot.place)))


class Stops:
    """Interrupts a run, as Ctrl-C does, once it has come so far."""

    def __init__(self, after: float) -> None:
        self.after = after

    def update(self, simulated_time: float, step_size: float | None) -> None:
        import signal

        del step_size
        if simulated_time > self.after:
            signal.raise_signal(signal.SIGINT)


def test_interrupted_run_goes_on_to_the_same_numbers(film: ElementFilm, tmp_path: Path) -> None:
    scene = falling()
    with pytest.raises(KeyboardInterrupt):
        film_elements(scene, MESH, INSTANTS, tmp_path, "falling", Stops(14 * elastic_time(scene)))
    (kept,) = tmp_path.glob("elements-falling-*.npz")
    with np.load(kept) as state:
        taken = np.isfinite(state["shot_rate"][:, 0, 0])
    assert taken.tolist() == [True, True, False]
    again = film_elements(scene, MESH, INSTANTS, tmp_path, "falling", Silence())
    assert np.array_equal(again.run.midpoint, film.run.midpoint)
    for shot, wanted in zip(again.snapshots, film.snapshots, strict=True):
        assert np.array_equal(shot.outline, wanted.outline)
        assert np.array_equal(shot.rate, wanted.rate)


def test_another_mesh_has_another_file(tmp_path: Path) -> None:
    scene = falling()
    scene = scene.replace({"run.duration": f"{2 * elastic_time(scene)!r} s"})
    for mesh in (Mesh(4, 2), Mesh(6, 2)):
        film_elements(scene, mesh, (2.0,), tmp_path, "short", Silence())
    assert len(list(tmp_path.glob("elements-short-*.npz"))) == 2
