"""What the notebooks prove is what the code runs: a slip in the equations makes one of them fail."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow

ROOT = Path(__file__).parents[2]
CLOSURES, BATH, SURFACE = "02_section_and_closures", "17_surroundings", "18_surface_tension"
# What stands in softcat_sym/physics or effects, what a slip of the pen makes of it, the notebook that must notice.
MUTATIONS = [
    ("axial_correction=-M * theta_X", "axial_correction=M * theta_X", CLOSURES),
    ("sp.diff(closed.lever, s) * s_t * theta_X +", "-sp.diff(closed.lever, s) * s_t * theta_X +", CLOSURES),
    ("self._tilt(one) ** 2 / (2 * s)", "self._tilt(one) ** 2 / s", SURFACE),
    ("stored=-rho_b * A0 * g_t * y", "stored=rho_b * A0 * g_t * y", BATH),
    ("sp.Rational(30, 7)", "sp.Rational(30, 8)", BATH),
    ("kinetic=rho_b * A0 * _v_n**2 / 2", "kinetic=rho_b * A0 * _v_n**2", BATH),
    (
        "UNIFORM = Contraction(area=A0 / s, thickness=h0 / sp.sqrt(s)",
        "UNIFORM = Contraction(area=A0 / s, thickness=h0 / s",
        CLOSURES,
    ),
    ("stretch=x_X + y_X**2 / 2", "stretch=x_X + y_X**2 / 4", "03_small_deflection"),
    ("sp.Integer(1), 6 * (3 * t_star**2", "sp.Integer(1), 5 * (3 * t_star**2", "04_asymptotics"),
    ("CLAMPED = Beam(_F(1, 12)", "CLAMPED = Beam(_F(1, 8)", "05_regimes"),
    ("* sp.Rational(3, 2) / sigma_eq", "* sp.Rational(1, 2) / sigma_eq", "06_bulk_law"),
    ("B, Rational(64, 9) * (H / L)", "B, Rational(32, 9) * (H / L)", "07_rheometry"),
    ("(1 + aspect**2) / 48", "(1 + aspect**2) / 40", "08_necking"),
    ("1 / 2, Fraction(5, 6)),", "1 / 2, Fraction(4, 6)),", "09_shearing_filament"),
]


# The same of softcat_sym/discretization, with the tests that must notice.
OF_A_CELL = [
    ("-b.area_node * turn, b.area_node * correction", "b.area_node * turn, b.area_node * correction", "test_beams"),
    ("-(staged[1] - staged[0]) / b.length[0]", "(staged[1] - staged[0]) / b.length[0]", "test_beams"),
    ("turned = ca.jtimes(momentum, tangent, turning)", "turned = 0 * momentum", "test_surroundings"),
    ("across -= mass * self.gravity", "across += mass * self.gravity", "test_surroundings"),
    ("-length * (along[1] + across[1])", "-length * across[1]", "test_surroundings"),
]


def fails(folder: Path, old: str, new: str, tests: str) -> bool:
    """Whether tests fail on a copy of the package in which `old` stands as `new`."""
    for part in ("softcat_sym", "tests"):
        shutil.copytree(ROOT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__"))
    for part in ("pyproject.toml", "CONTRIBUTING.md"):
        shutil.copy(ROOT / part, folder / part)
    slip(folder, ("discretization",), old, new)
    command = [sys.executable, "-m", "pytest", "-q", "-x", "-n", "0", "-p", "no:cacheprovider", f"tests/{tests}.py"]
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode in (0, 1), done.stdout + done.stderr
    return done.returncode == 1


@pytest.mark.parametrize(("old", "new", "tests"), OF_A_CELL)
def test_a_slip_in_the_cell_makes_a_test_fail(old: str, new: str, tests: str, tmp_path: Path) -> None:
    assert fails(tmp_path / "copy", old, new, tests)


def notices(folder: Path, old: str, new: str, notebook: str) -> bool:
    """Whether the notebook fails on a copy of the package in which `old` stands as `new`."""
    for part in ("softcat_sym", "derivations"):
        shutil.copytree(ROOT / part, folder / part, ignore=shutil.ignore_patterns("__pycache__"))
    slip(folder, ("physics", "effects"), old, new)
    command, environment = [sys.executable, f"{notebook}.py"], {**os.environ, "PYTHONPATH": str(folder)}
    done = subprocess.run(command, cwd=folder / "derivations", env=environment, capture_output=True, check=False)
    return done.returncode != 0


def slip(folder: Path, parts: tuple[str, ...], old: str, new: str) -> None:
    """Let `old` stand as `new` in the first file that has it."""
    paths = [path for part in parts for path in sorted((folder / "softcat_sym" / part).rglob("*.py"))]
    files = [path for path in paths if old in path.read_text("utf-8")]
    assert files, f"no module of {parts} holds {old}"
    files[0].write_text(files[0].read_text("utf-8").replace(old, new), encoding="utf-8")


def test_a_copy_without_a_slip_passes(tmp_path: Path) -> None:
    assert not notices(tmp_path / "copy", "sp.", "sp.", "01_balance")


@pytest.mark.parametrize(("old", "new", "notebook"), MUTATIONS)
def test_a_slip_in_the_equations_makes_a_notebook_fail(old: str, new: str, notebook: str, tmp_path: Path) -> None:
    assert notices(tmp_path / "copy", old, new, notebook)
