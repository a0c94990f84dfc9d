"""A newcomer's stopwatch: from a clone to the answer for a filament of one's own.

``pytest -s -m slow tests/slow/test_newcomer.py`` prints the seconds of each step. It installs from the registry that
pip is set up for, and compiles into a cache of its own.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
NEW = (
    "softcat new my-ink.toml --span '2 mm' --diameter '0.25 mm' --density '1100 kg/m^3' --youngs-modulus '45 kPa'"
    " --law herschel-bulkley --shear-yield-stress '200 Pa' --shear-consistency '60 Pa*s^0.4' --index 0.4"
    " --surface-tension '40 mN/m' --duration '20 ms'"
)


def test_from_a_clone_to_an_answer_of_ones_own(tmp_path: Path) -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    found = re.search(r"(?m)^python3 -m venv .*pip install.*softcat run.*$", readme)
    assert found is not None
    folder = tmp_path / "softcat_sym"
    own = "export PATH=$PWD/.venv/bin:$PATH && "
    steps = [
        ("clone", f"git clone -q '{ROOT}' '{folder}'", tmp_path),
        ("README's first command", found[0], folder),
        ("softcat new", own + NEW, folder),
        ("softcat run", own + "softcat run my-ink.toml", folder),
    ]
    # Neither the libraries nor the modules of who tests are there for a newcomer.
    environment = {name: text for name, text in os.environ.items() if name not in ("PYTHONPATH", "VIRTUAL_ENV")}
    environment |= {"SOFTCAT_CACHE": str(tmp_path / "cache")}
    print()
    began = time.monotonic()
    for name, command, where in steps:
        start = time.monotonic()
        done = subprocess.run(
            ["bash", "-c", command], cwd=where, env=environment, capture_output=True, text=True, check=False
        )
        print(f"{time.monotonic() - start:7.1f} s  {name}", flush=True)
        assert done.returncode == 0, f"{command}\n{done.stdout[-3000:]}{done.stderr[-3000:]}"
    print(f"{time.monotonic() - began:7.1f} s  together")
    summary = json.loads((folder / "softcat-out" / "my-ink" / "summary.json").read_text(encoding="utf-8"))
    assert summary["outcome"] == "solved"
    assert summary["midpoint_final_m"] < 0
