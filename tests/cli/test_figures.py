"""``softcat figures``: figure 2 with its data, and one clear refusal of what is not there yet."""

from __future__ import annotations

import csv
import json
import subprocess
import sys
from pathlib import Path

import pytest

SOFTCAT = str(Path(sys.executable).with_name("softcat"))


def test_a_figure_that_is_not_there_yet_is_refused(tmp_path: Path) -> None:
    for number in ("3", "0", "two"):
        done = subprocess.run(
            [SOFTCAT, "figures", "--only", number, "-o", str(tmp_path / "out")],
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 2
        assert "--only" in done.stderr
        assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.slow
def test_figure_2_holds_every_curve_with_its_data(tmp_path: Path) -> None:
    subprocess.run([SOFTCAT, "figures", "--only", "2", "-o", str(tmp_path), "-q"], check=True)
    assert {path.name for path in tmp_path.iterdir()} == {"figure2.png", "figure2.csv", "figure2.json"}
    facts = json.loads((tmp_path / "figure2.json").read_text())
    assert len(facts["panels"]) == 4
    assert all(set(panel["outcomes"].values()) == {"solved"} for panel in facts["panels"])
    slender, thick = facts["panels"][0], facts["panels"][-1]
    assert slender["tension_over_bending_at_t_high"] > 9
    assert thick["tension_over_bending_at_t_high"] == pytest.approx(0.09, abs=0.005)
    assert "delta = 0.025" in facts["caption"]
    with (tmp_path / "figure2.csv").open(newline="") as stream:
        names = {row["curve"] for row in csv.DictReader(stream)}
    assert names == {
        "full model",
        "reduced model (2.18)",
        "free fall",
        "(2.20) from rest",
        "(2.20) as printed",
        "1/3 law",
        "(2.21) integrated",
        "(2.22)",
    }
