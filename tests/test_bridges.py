"""The bridge table: sags of an elastic beam by hand, verdicts, fields of slicers, and what is refused."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

import softcat_sym as sc
from softcat_sym.design.bridges import Bridge, BridgeTable
from softcat_sym.design.critical_span import read_limit
from softcat_sym.results.motion import time_of_rest
from tests.common.in_process import Softcat

RHO, E, WIDTH, HEIGHT, NOZZLE = 1000.0, 50e6, 0.42e-3, 0.2e-3, 0.4e-3
DIAMETER = math.sqrt(4 * WIDTH * HEIGHT / math.pi)
SCENE: dict[str, Any] = {
    "title": "A strand",
    "filament": {"span": "1 m", "density": RHO, "line_width": WIDTH, "layer_height": HEIGHT, "nozzle": NOZZLE},
    "material": {"law": "elastic", "youngs_modulus": E, "loss_tangent": 0.5},
    "load": {"ramp": "0.2 s"},
    "run": {"duration": "0.4 s", "frames": 41},
}


def beam(length: float) -> float:
    """Sag of a clamped beam under its weight, rho g A L^4/(384 E I) [m]."""
    return RHO * 9.81 * 16 * length**4 / (384 * E * DIAMETER**2)


def table(filament: dict[str, Any], *sags: float, errors: float = 1e-6) -> BridgeTable:
    """A table of 1 mm, 2 mm, ... with these sags and a limit of 0.1 mm."""
    scene = sc.Scene.from_dict({**SCENE, "filament": {"span": "1 m", "density": RHO, **filament}})
    limit = read_limit("0.1 mm")
    rows = [Bridge(1e-3 * (k + 1), sag, errors, 1e-4, 0.1, "solved", "") for k, sag in enumerate(sags)]
    return BridgeTable(scene, limit, tuple(rows))


def fields(text: str) -> dict[str, str]:
    """The lines ``key = value`` of a slicer's settings."""
    lines = [line for line in text.splitlines() if line and not line.startswith("#")]
    return dict(line.split(" = ") for line in lines)


def test_the_table_has_the_sags_of_a_beam(softcat: Softcat, tmp_path: Path) -> None:
    lengths = [10e-3, 14e-3, 18e-3]
    scene = sc.Scene.from_dict(SCENE)
    (tmp_path / "strand.toml").write_text(scene.to_toml())
    line = ["filament.line_width=0.42 mm", "filament.layer_height=0.2 mm", "filament.nozzle=0.4 mm"]
    changes = [word for change in line for word in ("--set", change)]
    limit = 1e6 * (beam(14e-3) + beam(18e-3)) / 2
    how = ["--lengths", "10:18 mm:3", "--max-sag", f"{limit} um", "--workers", "1"]
    done = softcat("bridges", str(tmp_path / "strand.toml"), *how, *changes, "-o", str(tmp_path / "out"))
    assert done.status == 0, done.err
    assert done.out.startswith("bridges up to 14 mm sag less than")
    rows = pd.read_csv(tmp_path / "out" / "bridges.csv")
    assert rows.length_m.tolist() == pytest.approx(lengths)
    # Shear, rotary inertia and the ramp that ends are left out by hand.
    assert rows.sag_m.tolist() == pytest.approx([beam(one) for one in lengths], rel=0.02)
    assert np.all(rows.sag_error_m > 0) and np.all(rows.sag_error_m < 0.02 * rows.sag_m)
    assert rows.within_limit.tolist() == ["yes", "yes", "no"]
    # The sag follows the quintic ramp, which has 99 % of its end at 0.885 of it.
    assert rows.settled_s.tolist() == pytest.approx([0.18] * 3, abs=0.011)
    found = json.loads((tmp_path / "out" / "bridges.json").read_text())
    assert found["longest_m"] == pytest.approx(14e-3) and found["bridges"][2]["within_limit"] == "no"
    orca = fields((tmp_path / "out" / "orcaslicer.txt").read_text())
    assert orca == {"max_bridge_length": "14", "thick_bridges": "0", "bridge_flow": "1"}
    other = fields((tmp_path / "out" / "superslicer.ini").read_text())
    area = 100 * WIDTH * HEIGHT / (math.pi / 4 * NOZZLE**2)
    assert other == {"dont_support_bridges": "1", "bridge_flow_ratio": f"{area:.4g}%"}
    again = sc.bridges(scene, lengths[::-1], f"{limit} um", workers=1)
    assert again.to_frame().sag_m.tolist() == pytest.approx(rows.sag_m.tolist(), rel=1e-6)


@pytest.mark.parametrize(
    ("sag", "error", "outcome", "verdict"),
    [
        (0.9e-4, 1e-6, "solved", "yes"),
        (1.1e-4, 1e-6, "solved", "no"),
        (0.9e-4, 2e-5, "solved", "undecided"),
        (0.9e-4, math.nan, "solved", "yes"),
        (math.nan, math.nan, "broken", "no"),
        (math.nan, math.nan, "inaccurate", "no answer"),
    ],
)
def test_a_verdict_counts_the_error(sag: float, error: float, outcome: str, verdict: str) -> None:
    assert Bridge(1e-2, sag, error, 1e-4, None, outcome, "").within == verdict


def test_the_longest_bridge_has_none_beyond_the_limit_below_it() -> None:
    strand = {"diameter": "0.3 mm"}
    assert table(strand, 1e-5, 2e-5, 2e-4, 3e-5).longest == pytest.approx(2e-3)
    nothing = table(strand, 2e-4, 1e-5)
    assert nothing.longest is None and nothing.text[0].startswith("not even a bridge of 1 mm surely sags")
    assert fields(nothing.slicer_fields("OrcaSlicer"))["max_bridge_length"] == "0"
    assert fields(nothing.slicer_fields("SuperSlicer"))["dont_support_bridges"] == "0"


def test_a_flow_against_the_nozzle_needs_the_nozzle() -> None:
    without = table({"diameter": "0.3 mm"}, 1e-5).slicer_fields("OrcaSlicer")
    assert set(fields(without)) == {"max_bridge_length"} and "Not determined here: bridge_flow, which needs" in without
    known = fields(table({"diameter": "0.3 mm", "nozzle": "0.4 mm"}, 1e-5).slicer_fields("OrcaSlicer"))
    assert known["thick_bridges"] == "1" and float(known["bridge_flow"]) == pytest.approx(0.5625, rel=1e-3)
    thick = table({"diameter": "0.6 mm", "nozzle": "0.4 mm"}, 1e-5).slicer_fields("SuperSlicer")
    assert "bridge_flow_ratio" not in fields(thick) and "would be 225%" in thick


def test_rest_is_the_time_from_which_nothing_changes() -> None:
    time = np.linspace(0.0, 20.0, 2001)
    assert time_of_rest(time, 1 - np.exp(-time)) == pytest.approx(math.log(100), abs=0.011)
    assert time_of_rest(time, time) is None
    assert time_of_rest(time, np.zeros_like(time)) == 0.0


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--lengths", "2mm:20mm"], "lengths: '2mm:20mm' is no range"),
        (["--lengths", "2:20:10"], "lengths: '2' has no unit"),
        (["--lengths", "2 kg:20 kg:3"], "lengths: 'kg' is a mass"),
        (["--lengths", "5 mm:5 mm:3"], "lengths: both ends"),
        (["--lengths", "-2 mm:20 mm:3"], "lengths: -2 mm is not more than the thickness"),
        (["--lengths", "0.1mm:20mm:3"], "lengths: 100 um is not more than the thickness of the strand, 400 um"),
        (["--lengths", "5 mm, 5 mm"], "named twice"),
        (["--lengths", "5 mm,,8 mm"], "has an empty value"),
        (["--lengths", "5mm:9mm:3", "--max-sag", "-1 mm"], "max_sag: '-1 mm' is not positive"),
        (["--lengths", "5mm:9mm:3", "--max-sag", "little"], "max_sag: 'little' is not a number with a unit"),
        (["--lengths", "5mm:9mm:3", "--set", "pillars.gap=4 mm"], "pillars: given, whose gap no table varies"),
        (["--lengths", "5mm:9mm:3", "--set", "run.until=settled"], "'settled', but members share"),
        ([], "Missing option '--lengths'"),
    ],
)
def test_what_is_no_table_is_refused_before_it_runs(
    softcat: Softcat, tmp_path: Path, options: list[str], says: str
) -> None:
    done = softcat("bridges", "ink-bridge", *options, "-o", str(tmp_path / "out"))
    assert done.status == 2
    assert says in " ".join(done.err.replace("│", "").split())
    assert not (tmp_path / "out").exists()
