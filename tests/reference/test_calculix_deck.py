"""The deck of CalculiX as a program would read it: geometry, supports, ramp, numbers that are not cut."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.reference.calculix import calculix_deck
from softcat_sym.reference.element_loop import Clamp, Mesh

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


def test_no_number_is_cut() -> None:
    """CalculiX reads 20 characters of a number: of 7.225955632632416e-05 it makes 7.2."""
    for card in cards(calculix_deck(SCENE, MESH).text):
        assert len(card.name) <= 80
        if card.name != "*HEADING":
            assert all(len(word) <= 20 for row in card.rows for word in row)
            assert all(len(row) <= 16 for row in card.rows)


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


def test_laws_and_sudden_load() -> None:
    nothing_flows = {"material.law": "elastic", "material.viscosity": None, "material.yield_stress": None}
    elastic = calculix_deck(SCENE.replace(nothing_flows), MESH).text
    assert "*PLASTIC" not in elastic and "*CREEP" not in elastic
    flowing = SCENE.replace({"material.law": "maxwell", "material.yield_stress": None})
    assert "*PLASTIC" not in calculix_deck(flowing, MESH).text and "*CREEP" in calculix_deck(flowing, MESH).text
    sudden = calculix_deck(SCENE.replace({"load.ramp": "0 s"}), MESH).text
    assert "RAMP" not in sudden and "AMPLITUDE=STEP" in sudden


def test_centreline_is_printed_at_every_frame() -> None:
    deck = calculix_deck(SCENE, MESH)
    place = nodes_of(deck.text)
    found = np.array([place[int(number)] for number in deck.centreline])
    assert found == pytest.approx(np.column_stack([1e3 * deck.X, 0 * deck.X, 0 * deck.X]), abs=1e-9)
    assert [int(word) for row in rows_of(deck.text, "*NSET") for word in row] == list(deck.centreline)
    times = [float(word) for row in rows_of(deck.text, "*TIME POINTS") for word in row]
    assert times == pytest.approx(np.linspace(0, SCENE.run.duration, SCENE.run.frames)[1:])


def test_a_title_is_one_line_and_no_keyword() -> None:
    text = calculix_deck(SCENE.replace({"title": "*STEP\n*END Übung " + 200 * "x"}), MESH).text
    assert [card.name for card in cards(text)].count("*STEP") == 0
    assert text.isascii()


def test_refusals() -> None:
    with pytest.raises(SceneError, match="filament\\.section"):
        calculix_deck(sc.load_scene("ink-bridge"), MESH)
    for step in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(SoftcatError, match="positive number"):
            calculix_deck(SCENE, MESH, step=step)
