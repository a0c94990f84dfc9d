"""Published flow curves: the curated set of rheodata (Caggioni; MIT), every sample of it.

``pip install softcat_sym[peers]`` brings it.
"""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from softcat_sym.fitting.flow_curve import fit_flow_curve
from tests.common.in_process import Softcat
from tests.common.table import show

rheodata = pytest.importorskip("rheodata", reason="pip install softcat_sym[peers]")
pytestmark = pytest.mark.slow

POOR = 0.1
"""Relative rms from which on a warning must say that no law fits."""

GLASS = {"mason1996_fig5": 0.58}
"""Volume fraction below which these emulsions flow as liquids (Mason, Bibette and Weitz 1996)."""

SETS = rheodata.search(experiment="flow_curve")["id"].tolist()
YIELDING = set(rheodata.search(experiment="flow_curve", tag="yield-stress")["id"])


def _is_solid(name: str, sample: str) -> bool:
    """Whether the authors say that it has a yield stress."""
    return name in YIELDING and (name not in GLASS or float(sample.removeprefix("phi_")) >= GLASS[name])


def test_published_flow_curves(tmp_path: Path) -> None:
    rows = []
    for name in SETS:
        frame = rheodata.load(name).df
        file = tmp_path / f"{name}.csv"
        frame.to_csv(file, index=False)
        for sample in frame["sample_id"].unique():
            fit = fit_flow_curve(file, sample)
            best, curve = fit.best, fit.curve
            constants = [f"{one.value:.3g}" if one else "" for one in (best.tau_Y, best.k, best.n)]
            rms, warned = f"{100 * best.relative_rms:.1f}", "; ".join(fit.warnings)
            points = [str(curve.shear_rate.size), f"{curve.decades:.1f}"]
            rows.append([name, sample, *points, best.law, *constants, rms, warned])
            assert (best.tau_Y is not None) == _is_solid(name, sample), (name, sample)
            assert best.tau_Y is None or best.tau_Y.verdict == "determined", (name, sample)
            others = [one.relative_rms for one in fit.candidates if one.tau_Y]
            assert best.relative_rms < 2 * min(others), (name, sample)
            assert (best.relative_rms > POOR) == ("misses the data" in warned), (name, sample)
    header = ["data set", "sample", "points", "decades", "law", "tau_Y [Pa]", "k [Pa s^n]", "n", "rms [%]", "warnings"]
    show(f"rheodata: {len(rows)} flow curves of {len(SETS)} data sets", header, rows)
    assert len(SETS) >= 11 and len(rows) >= 58


@pytest.mark.parametrize("name", SETS)
def test_the_command_asks_for_one_sample_and_takes_it(name: str, softcat: Softcat, tmp_path: Path) -> None:
    frame = rheodata.load(name).df
    file, output = tmp_path / "curve.csv", tmp_path / "out"
    frame.to_csv(file, index=False)
    samples = frame["sample_id"].unique().tolist()
    asked = softcat("flow-curve", str(file), "-o", str(output), "-q")
    assert (asked.status, output.exists()) == ((2, False) if len(samples) > 1 else (0, True)), asked.err
    assert len(samples) == 1 or f"{len(samples)} samples; accepted: --sample with one of {samples[0]}" in asked.err
    done = softcat("flow-curve", str(file), "--sample", samples[-1], "-o", str(output), "-q")
    assert (done.status, done.err) == (0, ""), done.err
    found = json.loads((output / "flow_curve.json").read_text())
    assert found["points"] == (frame["sample_id"] == samples[-1]).sum()
    assert found["best"] == fit_flow_curve(file, samples[-1]).best.law
