"""CalculiX: its deck, its print-outs, its runs and their end."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.reference.calculix import calculix_deck, material_lines
from softcat_sym.reference.element_loop import Clamp, Mesh
from softcat_sym.reference.elements import run_elements
from softcat_sym.scene.scene import Scene
from tests.common.calculix import find_calculix, run_calculix
from tests.common.material_point import MaterialPoint
from tests.common.strips import shortened

SCENE = sc.load_scene("continual-descent", {"filament.width": "0.06 mm"})
MESH = Mesh(5, 4, grading=3.0)
MATERIAL, LENGTH = SCENE.material, SCENE.filament


@dataclass
class Card:
    """A keyword line and what follows it."""

    name: str
    rows: list[list[str]] = field(default_factory=list)


def cards(text: str) -> list[Card]:
    found: list[Card] = []
    for line in text.splitlines():
        if line.startswith("*"):
            found.append(Card(line))
        else:
            found[-1].rows.append([word.strip() for word in line.split(",")])
    return found


def rows_of(text: str, name: str) -> list[list[str]]:
    return [row for card in cards(text) if card.name.startswith(name) for row in card.rows]


def nodes_of(text: str) -> dict[int, np.ndarray]:
    return {int(row[0]): np.array([float(word) for word in row[1:]]) for row in rows_of(text, "*NODE, NSET")}


def elements_of(text: str) -> np.ndarray:
    flat = [int(word) for row in rows_of(text, "*ELEMENT") for word in row if word]
    return np.array(flat).reshape(-1, 21)[:, 1:]


def test_bricks_fill_half_the_span_and_half_the_width() -> None:
    text = calculix_deck(SCENE, MESH).text
    place = nodes_of(text)
    at = np.array([[place[number] for number in brick] for brick in elements_of(text)])
    assert len(at) == 20
    edge = [at[:, k] - at[:, 0] for k in (1, 3, 4)]
    volume = np.einsum("ei,ei->e", np.cross(edge[0], edge[1]), edge[2])
    assert volume.min() > 0  # right-handed, as a brick must be
    whole = 1e9 * LENGTH.span / 2 * LENGTH.thickness * LENGTH.width / 2
    assert volume.sum() == pytest.approx(whole, rel=1e-10)
    # Nodes 9 to 20 lie in the middles of the edges, in CalculiX's order.
    ends = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    for middle, (one, other) in enumerate(ends, start=8):
        assert at[:, middle] == pytest.approx((at[:, one] + at[:, other]) / 2, abs=1e-9)
    assert sorted(place) == sorted({int(number) for number in elements_of(text).ravel()})


@pytest.mark.parametrize("clamp", list(Clamp))
def test_supports_allow_what_those_of_our_elements_allow(clamp: Clamp) -> None:
    deck = calculix_deck(SCENE, MESH, clamp=clamp)
    place = nodes_of(deck.text)
    held = {(int(node), int(axis)) for node, axis in rows_of(deck.text, "*BOUNDARY")}
    tied = {}
    for row in rows_of(deck.text, "*EQUATION"):
        if len(row) > 1:
            tied[int(row[0]), int(row[1])] = (int(row[3]), int(row[4]), -float(row[5]))
    end, top = 1e3 * LENGTH.span / 2, 1e3 * LENGTH.thickness / 2
    for node, (x, y, z) in place.items():
        on_face = abs(x - end) < 1e-9
        assert ((node, 1) in held) == (on_face or x == 0)
        assert ((node, 3) in held) == (z == 0)
        assert ((node, 2) in held) == (on_face and (clamp is Clamp.FIXED or y == 0))
        if (node, 2) in tied:
            other, axis, share = tied[node, 2]
            assert on_face and axis == 2 and place[other][1] == pytest.approx(top)
            assert share == pytest.approx(y / top)
    face = sum(abs(x - end) < 1e-9 for x, _, _ in place.values())
    centre = sum(abs(x - end) < 1e-9 and y == 0 for x, y, _ in place.values())
    assert len(tied) == (0 if clamp is Clamp.FIXED else face - centre - 1)
    assert not held & set(tied)
    assert deck.dofs == 3 * len(place) - len(held) - len(tied)


def test_material_load_and_ramp() -> None:
    text = calculix_deck(SCENE, MESH).text
    numbers = {
        name: [float(word) for word in rows_of(text, name)[0]]
        for name in ("*ELASTIC", "*DENSITY", "*PLASTIC", "*CREEP")
    }
    assert numbers["*ELASTIC"] == pytest.approx([MATERIAL.youngs_modulus, MATERIAL.poisson])
    assert numbers["*DENSITY"] == pytest.approx([1e-6 * LENGTH.density])  # g/mm^3
    assert numbers["*PLASTIC"] == pytest.approx([MATERIAL.yield_stress, 0])
    assert numbers["*CREEP"] == pytest.approx([1 / MATERIAL.viscosity, 1, 0])
    assert float(rows_of(text, "*DLOAD")[0][2]) == pytest.approx(1e3 * SCENE.load.gravity)
    ramp = np.array(rows_of(text, "*AMPLITUDE"), dtype=float)
    between = np.linspace(0, SCENE.load.ramp, 997)
    u = between / SCENE.load.ramp
    assert np.interp(between, *ramp.T) == pytest.approx(10 * u**3 - 15 * u**4 + 6 * u**5, abs=2e-5)


SHORT = shortened(sc.load_scene("continual-descent", {"filament.width": "0.06 mm"}), 20.0, 5)
SMALL = Mesh(6, 2)
needs_calculix = pytest.mark.skipif(find_calculix() is None, reason="no CalculiX: apt-get install calculix-ccx")


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
    scene = SHORT.replace({"material.youngs_modulus": modulus})
    theirs = np.array(pulled_cube(scene, tmp_path, speed, duration, 500, prints))
    ours = np.array(pulled_point(scene, speed, duration, 500, prints))
    assert theirs.shape == ours.shape == (prints,)
    assert theirs / ours - 1 == pytest.approx(np.zeros(prints), abs=apart)
    # The law itself, by hand: true stress sY + eta times the rate; the volume hardly changes.
    stretch = 1 + speed * duration * np.arange(1, prints + 1) / prints
    by_hand = (SHORT.material.yield_stress + SHORT.material.viscosity * speed / stretch) / stretch
    assert theirs == pytest.approx(by_hand, rel=6e-3)


@needs_calculix
def test_a_short_fall_agrees_with_our_elements_the_better_the_shorter_its_increments() -> None:
    """CalculiX's flow is first order in the increment; what is left at none of it is less than a thousandth."""
    ours = run_elements(SHORT, SMALL)
    coarse, fine = (run_calculix(SHORT, SMALL, step=step) for step in (0.25, 0.125))
    assert fine.time == pytest.approx(ours.time, abs=0)
    apart = [float(run.midpoint[-1] / ours.midpoint[-1] - 1) for run in (coarse, fine)]
    assert abs(apart[1]) < 4e-3
    assert 1.7 < apart[0] / apart[1] < 2.6
    assert abs(2 * apart[1] - apart[0]) < 1e-3
    assert fine.x[-1] == pytest.approx(ours.x[-1], abs=1e-4 * SHORT.filament.span)
    assert fine.y[-1] == pytest.approx(ours.y[-1], abs=4e-4 * SHORT.filament.span)
    assert 1.8 < fine.steps / coarse.steps < 2.1
