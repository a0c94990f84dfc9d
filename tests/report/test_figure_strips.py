"""What figure 4 shades and outlines, on filaments whose answer is known; files that repeat to the byte."""

from __future__ import annotations

import csv
import io
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import xarray as xr

from softcat_sym.plotting.files import json_bytes
from softcat_sym.plotting.paper_figures import DPI, printed, strip_at, table
from softcat_sym.plotting.style import axes_in_inches, new_figure
from softcat_sym.studies.paper_figures import PAPER, stopping_depth

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


@pytest.fixture(autouse=True)
def _unit_of_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("softcat_sym.plotting.paper_figures.elastic_time", lambda scene: 1.0)


@pytest.mark.parametrize(
    ("mean", "bending", "share"),
    [
        (0.0, 4.0, 0.0),
        # |10 zeta| > 5: the outer halves of both sides.
        (0.0, 10.0, 0.5),
        # 3 + 4 zeta > 5 above zeta = 1/2, a quarter of the thickness; below it is -1 at least.
        (3.0, 4.0, 0.25),
        (6.0, 0.0, 1.0),
    ],
)
def test_yielded_share_of_a_linear_stress(mean: float, bending: float, share: float) -> None:
    strip = strip_at(straight(mean, bending), 0.0)
    assert strip.yielded_share == pytest.approx(share)
    quads = strip.yielded
    # Drawn is the right half: half of the share of a side view of 1 x 0.1 (over the span).
    assert (quads[..., 0] >= 0).all()
    x, y = quads[..., 0], quads[..., 1]
    drawn = np.abs(np.sum(x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y, axis=1) / 2).sum()
    assert drawn == pytest.approx(share * 0.05)


def test_faces_are_half_a_thickness_from_the_centreline() -> None:
    strip = strip_at(straight(0.0, 0.0), 0.0)
    assert strip.side(0.0)[:, 1] == pytest.approx(0.0)
    assert strip.side(1.0)[:, 1] == pytest.approx(0.05)
    assert strip.side(-1.0)[:, 1] == pytest.approx(-0.05)
    assert strip.side(0.0)[:, 0] == pytest.approx([0.0, 0.25, 0.5])


def test_sheared_sections_turn_by_less_than_the_centreline() -> None:
    """theta = psi + atan(Gam/Lam): where all of the slope is shear, sections stay vertical."""
    angle = 0.2
    upright = strip_at(straight(0.0, 0.0, angle=angle, shear=float(np.tan(angle))), 0.0)
    assert np.allclose(upright.section.normal, [0.0, 1.0])
    bent = strip_at(straight(0.0, 0.0, angle=angle, shear=0.0), 0.0)
    assert np.allclose(bent.section.normal[1:-1], [-np.sin(angle), np.cos(angle)])


def test_stopping_depths() -> None:
    """(3.13) at G = 0.4 by hand: 1.25 - sqrt(1.5625 - 0.125); beyond the thresholds there is none."""
    assert stopping_depth(0.4)["paper"] == pytest.approx(1.25 - np.sqrt(1.4375), rel=1e-12)
    between, beyond = stopping_depth(1.4), stopping_depth(1.9)
    assert between["paper"] is not None
    assert between["exact"] is None
    assert beyond == {"paper": None, "exact": None}


def test_same_figure_same_bytes() -> None:
    def drawn() -> dict[str, bytes]:
        figure = new_figure(2.0, 1.0)
        axes_in_inches(figure, 0.3, 0.3, 1.5, 0.6).plot([0, 1], [0, 1])
        return printed("try", figure)

    first = drawn()
    assert first == drawn()
    assert first["try.pdf"].startswith(b"%PDF")
    assert b"/CreationDate" not in first["try.pdf"]
    width = int.from_bytes(first["try.png"][16:20], "big")
    assert width == 2 * DPI
    assert DPI >= 200


def test_table_reads_back() -> None:
    rows = list(csv.DictReader(io.StringIO(table(("name", "value"), [("a", 1 / 3), ("b", 2)]).decode())))
    assert [row["name"] for row in rows] == ["a", "b"]
    assert float(rows[0]["value"]) == pytest.approx(1 / 3, rel=1e-7)
    assert json_bytes({"a": 1}) == b'{\n  "a": 1\n}\n'
