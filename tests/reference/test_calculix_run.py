"""CalculiX found, run and ended, by a stand-in of a few lines; and its law and dynamics, where it is installed."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.reference.calculix import find_calculix, material_lines, run_calculix
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.reference.elements import run_elements
from softcat_sym.reference.material_point import MaterialPoint
from softcat_sym.scene.scene import Scene
from tests.reference.strips import shortened

SCENE = shortened(sc.load_scene("continual-descent", {"filament.width": "0.06 mm"}), 20.0, 5)
MESH = Mesh(6, 2)
needs_calculix = pytest.mark.skipif(find_calculix() is None, reason="no CalculiX: apt-get install calculix-ccx")


def stand_in(folder: Path, monkeypatch: pytest.MonkeyPatch, body: str) -> None:
    """Put a program of the name ``ccx`` first on the path."""
    program = folder / "bin" / "ccx"
    program.parent.mkdir()
    program.write_text(f"#!{sys.executable}\nimport os, pathlib, sys, time\n{body}\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent}{os.pathsep}{os.environ['PATH']}")


def test_missing_program_is_named_with_its_package(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(SoftcatError, match=r"apt-get install calculix-ccx.*--write-input-only"):
        run_calculix(SCENE, MESH)


def test_what_it_complains_of_is_passed_on(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    body = """print(" *ERROR: too many cutbacks\\n        best solution is in the file\\n\\n more"); sys.exit(201)"""
    stand_in(tmp_path, monkeypatch, body)
    with pytest.raises(SoftcatError, match=r"too many cutbacks best solution is in the file \(after 0 s"):
        run_calculix(SCENE, MESH)


def test_a_run_that_stops_short_is_no_answer(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    stand_in(tmp_path, monkeypatch, "pathlib.Path('deck.dat').write_text('')")
    with pytest.raises(SoftcatError, match="0 of 4 output times"):
        run_calculix(SCENE, MESH)


def test_ctrl_c_ends_it_and_leaves_nothing(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    row = "     1          1     1     2  0.100000E-01  0.100000E-01  0.100000E-02"
    note = tmp_path / "note"
    body = f"""pathlib.Path('deck.sta').write_text({row!r} + chr(10))
pathlib.Path({str(note)!r}).write_text(f"{{os.getpid()}} {{os.getcwd()}}")
time.sleep(60)"""
    stand_in(tmp_path, monkeypatch, body)

    heard: list[tuple[float, float | None]] = []

    class Interrupting:
        """Presses Ctrl-C as soon as it hears of the first increment."""

        def update(self, simulated_time: float, step_size: float | None) -> None:
            heard.append((simulated_time, step_size))
            signal.raise_signal(signal.SIGINT)

    with pytest.raises(KeyboardInterrupt):
        run_calculix(SCENE, MESH, progress=Interrupting())
    assert heard == [(0.01, 0.001)]
    number, folder = note.read_text().split(maxsplit=1)
    with pytest.raises(ProcessLookupError):
        os.kill(int(number), 0)
    assert not Path(folder).exists()


CORNERS = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]


def pulled_cube(scene: Scene, folder: Path, speed: float, duration: float, increments: int, prints: int) -> list[float]:
    """Forces on a unit cube of the scene's material, drawn out in CalculiX at a constant speed."""
    place = np.vstack([CORNERS, [(CORNERS[a] + CORNERS[b]) / 2 for a, b in EDGES]])
    lines = ["*NODE", *(f"{n}, {x}, {y}, {z}" for n, (x, y, z) in enumerate((place + 1) / 2, start=1))]
    lines += ["*ELEMENT, TYPE=C3D20R, ELSET=EALL", "1, " + ", ".join(map(str, range(1, 11))) + ","]
    lines += [", ".join(map(str, range(11, 21))), *material_lines(scene), "*BOUNDARY"]
    lines += [f"{n}, {axis + 1}" for axis in range(3) for n in range(1, 21) if place[n - 1, axis] == -1]
    pulled = [n for n in range(1, 21) if place[n - 1, 0] == 1]
    lines += ["*NSET, NSET=PULLED", ", ".join(map(str, pulled))]
    lines += ["*AMPLITUDE, NAME=A", f"0., 0., {duration}, 1.", f"*STEP, NLGEOM, INC={2 * increments}"]
    lines += ["*VISCO, DIRECT, CETOL=1.", f"{duration / increments:.12g}, {duration}", "*BOUNDARY, AMPLITUDE=A"]
    lines += [f"{n}, 1, 1, {speed * duration}" for n in pulled]
    lines += [f"*NODE PRINT, NSET=PULLED, TOTALS=ONLY, FREQUENCY={increments // prints}", "RF", "*END STEP", ""]
    (folder / "cube.inp").write_text("\n".join(lines))
    subprocess.run([str(find_calculix()), "cube"], cwd=folder, check=True, capture_output=True, timeout=60)
    return [float(force) for force in re.findall(r"total force.*\n\n\s+(\S+)", (folder / "cube.dat").read_text())]


def pulled_point(scene: Scene, speed: float, duration: float, steps: int, prints: int) -> list[float]:
    """The same with our material point: the force per reference area; the sides are free."""
    material = scene.material
    constants = {name: getattr(material, name) for name in ("youngs_modulus", "poisson", "viscosity", "yield_stress")}
    point, found, width = MaterialPoint("bingham", constants), [], 1.0
    for step in range(1, steps + 1):
        length, before = 1 + speed * duration * step / steps, point.state.copy()
        last = None
        for _ in range(20):
            # The secant for the width at which the side is free.
            point.state = before.copy()
            point.step([[length, 0], [0, width]], duration / steps)
            pressure = float(point.cauchy[1, 1])
            if abs(pressure) < 1e-9 * constants["youngs_modulus"]:
                break
            slope = constants["youngs_modulus"] if last is None else (pressure - last[1]) / (width - last[0])
            last, width = (width, pressure), width - pressure / slope
        if step % (steps // prints) == 0:
            found.append(float(point.stress[0, 0]))
    return found


@needs_calculix
@pytest.mark.parametrize(("modulus", "apart"), [("4 MPa", 2.5e-3), ("40 MPa", 4e-4)])
def test_one_brick_flows_as_our_material_point(tmp_path: Path, modulus: str, apart: float) -> None:
    """Drawn to 1.25 times its length, mostly by flow; the laws differ by the elastic strain, 2e-3 and 2e-4."""
    speed, duration, prints = 0.5, 0.5, 5
    scene = SCENE.replace({"material.youngs_modulus": modulus})
    theirs = np.array(pulled_cube(scene, tmp_path, speed, duration, 500, prints))
    ours = np.array(pulled_point(scene, speed, duration, 500, prints))
    assert theirs.shape == ours.shape == (prints,)
    assert theirs / ours - 1 == pytest.approx(np.zeros(prints), abs=apart)
    # The law itself, by hand: true stress sY + eta times the rate; the volume hardly changes.
    stretch = 1 + speed * duration * np.arange(1, prints + 1) / prints
    by_hand = (SCENE.material.yield_stress + SCENE.material.viscosity * speed / stretch) / stretch
    assert theirs == pytest.approx(by_hand, rel=6e-3)


@needs_calculix
def test_a_short_fall_agrees_with_our_elements_the_better_the_shorter_its_increments() -> None:
    """CalculiX's flow is first order in the increment; what is left at none of it is less than a thousandth."""
    heard: list[float] = []

    class Listener:
        def update(self, simulated_time: float, step_size: float | None) -> None:
            heard.append(simulated_time)

    ours = run_elements(SCENE, MESH)
    coarse, fine = (run_calculix(SCENE, MESH, step=step, progress=Listener()) for step in (0.25, 0.125))
    assert fine.time == pytest.approx(ours.time, abs=0)
    apart = [float(run.midpoint[-1] / ours.midpoint[-1] - 1) for run in (coarse, fine)]
    assert abs(apart[1]) < 4e-3
    assert 1.7 < apart[0] / apart[1] < 2.6
    assert abs(2 * apart[1] - apart[0]) < 1e-3
    assert fine.x[-1] == pytest.approx(ours.x[-1], abs=1e-4 * SCENE.filament.span)
    assert fine.y[-1] == pytest.approx(ours.y[-1], abs=4e-4 * SCENE.filament.span)
    assert 1.8 < fine.steps / coarse.steps < 2.1
    assert set(fine.files) >= {"deck.inp", "deck.dat", "deck.sta"}
    assert len(heard) > 4
