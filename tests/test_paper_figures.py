"""The paper's figures: snapshots of the elements, what figure 4 shades, stopping depths, ``softcat figures``."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import xarray as xr

import softcat_sym as sc
from softcat_sym.plotting.compare import boundary
from softcat_sym.plotting.paper_figures import strip_at
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.scene.scene import Scene, elastic_time
from softcat_sym.solvers.solution import Silence
from softcat_sym.studies.paper_figures import PAPER, ElementFilm, film_elements, stopping_depth

MESH = Mesh(8, 2)
INSTANTS = (6.0, 12.0, 24.0)


def falling() -> Scene:
    """The paper's descent while it falls; it flows from t~ = 6 or so on."""
    scene = sc.load_scene("continual-descent", {"filament.width": "0.06 mm", "run.frames": 13})
    return scene.replace({"run.duration": f"{24 * elastic_time(scene)!r} s"})


@pytest.fixture(scope="module")
def film(tmp_path_factory: pytest.TempPathFactory) -> ElementFilm:
    return film_elements(falling(), MESH, INSTANTS, Silence())


def areas(polygons: np.ndarray) -> np.ndarray:
    """Signed areas by the shoelace formula; shape (polygons,)."""
    x, y = polygons[..., 0], polygons[..., 1]
    return np.sum(x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y, axis=1) / 2


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


SPAN, LIMIT = 2.0, 5.0


def straight(mean: float, bending: float, *, angle: float = 0.0, shear: float | None = None) -> Any:
    """A straight filament of four cells at an angle, with the same stress everywhere; lengths in m."""
    nodes = np.linspace(-SPAN / 2, SPAN / 2, 5)
    cells = (nodes[1:] + nodes[:-1]) / 2
    fields = {"thickness": 0.2, "stress_mean": mean, "stress_bending": bending}
    fields |= {} if shear is None else {"shear": shear}
    data = xr.Dataset(
        {
            "x": (("time", "node"), [np.cos(angle) * nodes]),
            "y": (("time", "node"), [np.sin(angle) * nodes]),
            **{name: (("time", "cell"), np.full((1, 4), value)) for name, value in fields.items()},
        },
        coords={"time": [0.0], "X_node": ("node", nodes), "X_cell": ("cell", cells)},
    )
    filament = SimpleNamespace(span=SPAN, density=1.0)
    material = SimpleNamespace(yield_stress=LIMIT, youngs_modulus=1.0)
    scene = SimpleNamespace(filament=filament, material=material)
    return SimpleNamespace(scene=scene, filaments={PAPER: SimpleNamespace(data=data)})


def test_yielded_share_and_faces_of_a_linear_stress(monkeypatch: pytest.MonkeyPatch) -> None:
    """|sigma_0 + sigma_1 zeta| > 5 yields; drawn is the right half of a side view of 1 x 0.1 over the span."""
    monkeypatch.setattr("softcat_sym.plotting.paper_figures.elastic_time", lambda scene: 1.0)
    for mean, bending, share in ((0.0, 4.0, 0.0), (0.0, 10.0, 0.5), (3.0, 4.0, 0.25), (6.0, 0.0, 1.0)):
        strip = strip_at(straight(mean, bending), 0.0)
        assert strip.yielded_share == pytest.approx(share)
        assert (strip.yielded[..., 0] >= 0).all()
        assert np.abs(areas(strip.yielded)).sum() == pytest.approx(share * 0.05)
    for zeta in (-1.0, 0.0, 1.0):
        assert strip.side(zeta)[:, 1] == pytest.approx(0.05 * zeta)
        assert strip.side(zeta)[:, 0] == pytest.approx([0.0, 0.25, 0.5])
    # theta = psi + atan(Gam/Lam): where all of the slope is shear, sections stay vertical.
    angle = 0.2
    upright = strip_at(straight(0.0, 0.0, angle=angle, shear=float(np.tan(angle))), 0.0)
    assert np.allclose(upright.section.normal, [0.0, 1.0])
    bent = strip_at(straight(0.0, 0.0, angle=angle, shear=0.0), 0.0)
    assert np.allclose(bent.section.normal[1:-1], [-np.sin(angle), np.cos(angle)])


def test_stopping_depths() -> None:
    """(3.13) at G = 0.4 by hand: 1.25 - sqrt(1.5625 - 0.125); beyond the thresholds there is none."""
    assert stopping_depth(0.4)["paper"] == pytest.approx(1.25 - np.sqrt(1.4375), rel=1e-12)
    between, beyond = stopping_depth(1.4), stopping_depth(1.9)
    assert between["paper"] is not None and between["exact"] is None
    assert beyond == {"paper": None, "exact": None}
