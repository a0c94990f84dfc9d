"""The manual's walk from a rheometer and a slicer to a bridge table: each command as it is printed there."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pandas as pd
import pytest

pytestmark = pytest.mark.slow

PAGE = Path(__file__).parents[2] / ".docs" / "manual" / "bridges.md"
COMMANDS = re.findall(r"(?m)^softcat .*", PAGE.read_text(encoding="utf-8"))


def export(test: str, columns: dict[str, tuple[str, npt.NDArray[np.float64]]]) -> str:
    """A table as RheoCompass exports it."""
    values = np.column_stack([column for _, column in columns.values()])
    head = f"Project:\tInk\n\nTest:\t{test}\n\nResult:\t{test} 1\n\nInterval and data points:\t1\t{len(values)}\n"
    head += "\t".join(["Interval data:\tPoint No.", *columns, "Status"]) + "\n\t\t\n"
    head += "\t".join(["\t", *(unit for unit, _ in columns.values()), ""]) + "\n"
    rows = ["\t".join(["", str(k + 1), *(f"{one:.6g}" for one in row), "Dy_auto"]) for k, row in enumerate(values)]
    return head + "\n".join(rows) + "\n"


def test_five_commands_lead_to_a_table(tmp_path: Path) -> None:
    rate, strain = np.logspace(-1, 2, 16), np.logspace(-4, 0, 25)
    storage = 5e4 / (1 + (strain / 3e-3) ** 2) ** 0.7
    loss = 0.08 * storage * (1 + (strain / 1.2e-3) ** 1.1)
    flow = export("Flow curve", {"Shear Rate": ("[1/s]", rate), "Shear Stress": ("[Pa]", 150 + 30 * rate**0.6)})
    moduli = {"Storage Modulus": ("[Pa]", storage), "Loss Modulus": ("[Pa]", loss)}
    sweep = export("Amplitude sweep", {"Shear Strain": ("[%]", 100 * strain), **moduli})
    (tmp_path / "flow-curve.csv").write_text(flow, encoding="utf-16")
    (tmp_path / "amplitude-sweep.csv").write_text(sweep, encoding="utf-16")
    assert len(COMMANDS) == 5
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    for command in COMMANDS:
        done = subprocess.run(
            ["bash", "-c", command], cwd=tmp_path, env={**os.environ, "PATH": path}, capture_output=True, text=True
        )
        assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"
    span = json.loads((tmp_path / "span" / "span.json").read_text())
    rows = pd.read_csv(tmp_path / "table" / "bridges.csv")
    # The longest span parts the bridges of the table.
    assert rows.within_limit.tolist() == ["yes" if one < span["span_m"] else "no" for one in rows.length_m]
    assert set(rows.within_limit) == {"yes", "no"}
    assert "max_bridge_length = 6\n" in (tmp_path / "table" / "orcaslicer.txt").read_text()
    (beside,) = [(a, b) for a, b in zip(rows.length_m, rows.length_m[1:], strict=False) if a < span["span_m"] < b]
    assert np.interp(span["sag_m"], rows.sag_m, rows.length_m) == pytest.approx(span["span_m"], abs=0.1 * beside[1])
