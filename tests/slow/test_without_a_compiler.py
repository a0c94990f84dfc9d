"""A machine whose PATH holds no C compiler: with the extra `compiler` runs are compiled by zig, without it interpreted.

An environment of its own is made, for which the package index must be within reach. `pytest -s` shows the table.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.library import size_text
from tests.common.in_process import sets
from tests.common.table import show

ROOT = Path(__file__).parents[2]
ADVICE = "pip install 'softcat_sym[compiler]'"
pytestmark = pytest.mark.slow


def ran(environment: Path, folder: Path, path: str) -> tuple[dict[str, Any], str]:
    """Summary and screen of a run whose home cannot be written."""
    asked = ["run", "ink-bridge", "-o", folder / "out", "--no-pictures", *sets("numerics.estimate=false")]
    variables = {"PATH": path, "HOME": os.devnull, "SOFTCAT_CACHE": str(folder / "cache"), "COLUMNS": "200"}
    done = subprocess.run(
        [environment / "bin" / "softcat", *asked], env=variables, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return json.loads((folder / "out" / "summary.json").read_text(encoding="utf-8")), done.stdout


def test_zig_takes_the_place_of_a_compiler_and_its_absence_says_how_to_have_it(tmp_path: Path) -> None:
    assert find_compiler() is not None, "what runs are compared with is compiled"
    made = tmp_path / "environment"
    pip = [made / "bin" / "python", "-m", "pip", "--quiet"]
    subprocess.run([sys.executable, "-m", "venv", made], check=True)
    subprocess.run([*pip, "install", f"{ROOT}[compiler]"], check=True)
    bare = str(made / "bin")
    runs = {"machine's own": ran(made, tmp_path / "own", os.environ["PATH"])}
    runs["zig"] = ran(made, tmp_path / "zig", bare)
    subprocess.run([*pip, "uninstall", "--yes", "ziglang"], check=True)
    runs["none"] = ran(made, tmp_path / "none", bare)
    rows = [
        [
            name, one["backend"], one["backend_reason"][:40], f"{one['wall_s']['compile']:.1f}",
            f"{1e6 * one['midpoint_final_m']:.4f}",
        ]
        for name, (one, _) in runs.items()
    ]  # fmt: skip
    show("ink-bridge without estimate", ["compiler", "backend", "found", "compiling [s]", "midpoint [um]"], rows)
    kept = tmp_path / "zig" / "cache" / "zig"
    print(f"zig keeps {size_text(sum(file.stat().st_size for file in kept.rglob('*') if file.is_file()))} of its own")
    own, zig, none = (one for one, _ in runs.values())
    assert (own["backend"], zig["backend"], none["backend"]) == ("compiled", "compiled", "interpreted")
    assert "clang" in zig["backend_reason"] and ADVICE in none["backend_reason"]
    assert [ADVICE in screen for _, screen in runs.values()] == [False, False, True]
    for other, steps in ((zig, 1), (none, 10)):
        assert other["midpoint_final_m"] == pytest.approx(own["midpoint_final_m"], rel=steps * own["rtol"])
