"""What the notebooks prove is what the code runs: a slip in the equations makes one of them fail."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from .table import show

ROOT = Path(__file__).parents[2]

# module, what stands there, what a slip of the pen makes of it, the notebook that must notice
MUTATIONS = [
    ("kinematics", "x_X_before * y_X - y_X_before", "x_X_before * y_X + y_X_before", "01_balance"),
    ("closure", "axial_correction=-M * theta_X", "axial_correction=M * theta_X", "02_section_and_closures"),
    (
        "closure",
        "recall_bending=shrink * h0 / contraction.thickness",
        "recall_bending=shrink",
        "02_section_and_closures",
    ),
    ("section", "overstress_mean=((2 + c**2)", "overstress_mean=((2 - c**2)", "02_section_and_closures"),
    ("section", "zeta_squared=sp.Rational(1, 3)", "zeta_squared=sp.Rational(1, 4)", "02_section_and_closures"),
    (
        "section",
        "UNIFORM = Contraction(area=A0 / s, thickness=h0 / sp.sqrt(s)",
        "UNIFORM = Contraction(area=A0 / s, thickness=h0 / s",
        "02_section_and_closures",
    ),
    ("laws/bingham", "/ (section.zeta_squared * eta)", "/ eta", "02_section_and_closures"),
    ("small_deflection", "-(delta**2) * K_I * _mb / 2", "-(delta**2) * K_I * _mb", "03_small_deflection"),
    ("small_deflection", "moment_rate=-E * inertia", "moment_rate=E * inertia", "03_small_deflection"),
    ("asymptotics", "Rational(-3, 5)", "Rational(-2, 5)", "04_asymptotics"),
    ("asymptotics", "sp.Integer(1), 6 * (3 * t_star**2", "sp.Integer(1), 5 * (3 * t_star**2", "04_asymptotics"),
    ("regimes", "CLAMPED = Beam(Rational(1, 12)", "CLAMPED = Beam(Rational(1, 8)", "05_regimes"),
    ("regimes", "(1 / (2 * G)) ** 2 - Rational(1, 8)", "(1 / (2 * G)) ** 2 + Rational(1, 8)", "05_regimes"),
    ("bulk", "* sp.Rational(3, 2) / sigma_eq", "* sp.Rational(1, 2) / sigma_eq", "06_bulk_law"),
    ("rheometry", "24 * tension_stiffness() * tau_star", "12 * tension_stiffness() * tau_star", "07_rheometry"),
    ("necking", "beta=sp.Rational(1, 48)", "beta=sp.Rational(1, 40)", "08_necking"),
    ("reissner", "RECTANGLE_SHEAR = sp.Rational(5, 6)", "RECTANGLE_SHEAR = sp.Rational(4, 6)", "09_shearing_filament"),
]


@pytest.mark.slow
def test_a_slip_in_the_equations_makes_a_notebook_fail(tmp_path: Path) -> None:
    rows, survivors = [], []
    for module, old, new, notebook in MUTATIONS:
        killed = _fails(tmp_path, module, old, new, notebook)
        rows.append([module, f"`{old}`", f"`{new}`", notebook, "noticed" if killed else "MISSED"])
        survivors += [] if killed else [(module, old)]
    show("mutations of softcat_sym/equations", ("module", "from", "to", "notebook", ""), rows)
    assert len(rows) >= 10
    assert not survivors


def _fails(folder: Path, module: str, old: str, new: str, notebook: str) -> bool:
    """Whether the notebook fails on a copy of the package in which `old` stands as `new`."""
    copy = folder / "copy"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(ROOT / "softcat_sym", copy / "softcat_sym", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "derivations", copy / "derivations", ignore=shutil.ignore_patterns("__pycache__"))
    target = copy / "softcat_sym" / "equations" / f"{module}.py"
    text = target.read_text(encoding="utf-8")
    assert old in text, f"{module}.py no longer holds {old}"
    target.write_text(text.replace(old, new), encoding="utf-8")
    environment = {**os.environ, "PYTHONPATH": str(copy)}
    done = subprocess.run(
        [sys.executable, f"{notebook}.py"], cwd=copy / "derivations", env=environment, capture_output=True, check=False
    )
    return done.returncode != 0
