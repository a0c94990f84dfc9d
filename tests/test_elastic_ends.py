"""Ends on springs: deflections, frequencies and energies of beams, in the plane and in space, and what is refused."""

from __future__ import annotations

import math
import tomllib
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.errors import SceneError
from softcat_sym.estimates.free_vibration import first_vibration
from softcat_sym.scene.ends import Hold
from softcat_sym.scene.scene import Scene
from tests.marks import few

SPAN, THICKNESS, DENSITY, E, POISSON = 0.2, 0.002, 1000.0, 1e9, 0.3
BENDING = E * THICKNESS**4 / 12
PLACE, TURN = BENDING / SPAN**3, BENDING / SPAN
"""Units of both stiffnesses."""
STATIC = ("bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear")
BOTH = {"left": "elastic", "right": "elastic"}
CASES: dict[str, dict[str, Any]] = {
    "turning": BOTH | {"left_rotational_stiffness": 2 * TURN, "right_rotational_stiffness": 2 * TURN},
    "giving way": BOTH | {"left_stiffness": 50 * PLACE, "right_stiffness": 50 * PLACE},
    "a soft pin": BOTH
    | {
        f"{side}_{key}": value
        for side in ("left", "right")
        for key, value in (("stiffness", 300 * PLACE), ("rotational_stiffness", 0.0))
    },
    "uneven": {
        "left": "elastic",
        "left_stiffness": 40 * PLACE,
        "left_rotational_stiffness": 5 * TURN,
        "right": "pinned",
    },
    "a cantilever": {"left": "elastic", "left_rotational_stiffness": 3 * TURN, "right": "free"},
}


def scene(ends: dict[str, Any], weight: float = 0.01, **changes: Any) -> Scene:
    """A thin elastic beam, so lightly loaded that its deflection is linear."""
    return sc.Scene(
        filament={"span": SPAN, "thickness": THICKNESS, "density": DENSITY},
        material={"law": "elastic", "youngs_modulus": E, "poisson": POISSON},
        ends=ends,
        load={"gravity": weight},
        run={"duration": 1.0, "frames": 2, "effects": list(STATIC)},
        numerics={"cells": 20, "estimate": False},
    ).replace(changes)


def stiffness(ends: dict[str, Any], side: str) -> tuple[float, float]:
    """Of one end, over the units; a large number where it is rigid."""
    plain = {"clamped": (math.inf, math.inf), "pinned": (math.inf, 0.0), "free": (0.0, 0.0)}
    if ends[side] != "elastic":
        place, turn = plain[ends[side]]
    else:
        place, turn = (ends.get(f"{side}_{key}", math.inf) for key in ("stiffness", "rotational_stiffness"))
    return min(place / PLACE, 1e12), min(turn / TURN, 1e12)


def boundary(ends: dict[str, Any], w: Any) -> np.ndarray:
    """What vanishes at both ends, of functions (derivative 0 to 3, place) of a deflection downwards."""
    rows = []
    for side, at, out in (("left", 0.0, -1.0), ("right", 1.0, 1.0)):
        place, turn = stiffness(ends, side)
        # Over a stiffness that is large, so that none is far larger than the others.
        rows.append((w(3, at) - out * place * w(0, at)) / (1 + place))
        rows.append((w(2, at) + out * turn * w(1, at)) / (1 + turn))
    return np.array(rows)


def deflection(ends: dict[str, Any], x: np.ndarray) -> np.ndarray:
    """w of E I w'''' = q between springs, over q L^4/(E I): a quartic."""

    def monomial(power: int, order: int, at: float) -> float:
        return math.perm(power, order) * at ** (power - order) if order <= power else 0.0

    def one(order: int, at: float) -> np.ndarray:
        return np.array([monomial(power, order, at) for power in range(4)])

    load = boundary(ends, lambda order, at: monomial(4, order, at) / 24)
    return np.polynomial.polynomial.polyval(x, [*np.linalg.solve(boundary(ends, one), -load), 1 / 24])


def frequency(ends: dict[str, Any]) -> float:
    """First root (b L)^2 of the frequency equation of Euler's beam between springs (Rayleigh 1877)."""

    def determinant(b: float) -> float:
        def one(order: int, at: float) -> np.ndarray:
            c, s, ch, sh = math.cos(b * at), math.sin(b * at), math.cosh(b * at), math.sinh(b * at)
            turned = ((c, s), (-s, c), (-c, -s), (s, -c))[order]
            grown = (ch, sh) if order % 2 == 0 else (sh, ch)
            return b**order * np.array([*turned, *grown])

        return float(np.linalg.det(boundary(ends, one)))

    grid = np.linspace(0.2, 5.0, 200)
    values = [determinant(b) for b in grid]
    first = next(n for n in range(len(grid) - 1) if values[n] * values[n + 1] < 0)
    return brentq(determinant, grid[first], grid[first + 1]) ** 2


def sheared(ends: dict[str, Any], x: np.ndarray) -> np.ndarray:
    """What shear adds to the deflection, in its unit, of equal reactions or of a free right end."""
    unit = THICKNESS**2 / 12 / SPAN**2 * 2 * (1 + POISSON) / (5 / 6)
    return unit * (x * (2 - x) if ends["right"] == "free" else x * (1 - x)) / 2


@pytest.mark.parametrize(
    ("name", "dimensions"), few([(name, count) for name in CASES for count in (2, 3)], *((name, 2) for name in CASES))
)
def test_a_beam_on_springs_bends_as_its_quartic_says(name: str, dimensions: int) -> None:
    ends, weight = CASES[name], 0.01
    data = sc.simulate(scene(ends, weight, **{"run.dimensions": dimensions})).data
    unit = DENSITY * THICKNESS**2 * weight * SPAN**4 / BENDING
    x = data["X_node"].values / SPAN + 0.5
    assert -data["y"].values[-1] / unit == pytest.approx(
        deflection(ends, x) + sheared(ends, x), rel=2e-3, abs=2e-3 * deflection(ends, x).max()
    )


@pytest.mark.parametrize("name", CASES)
def test_a_beam_on_springs_vibrates_as_its_determinant_says(name: str) -> None:
    ends = CASES[name]
    found = first_vibration(scene(ends, 1e-4, **{"run.effects": "auto"}))
    unit = math.sqrt(BENDING / (DENSITY * THICKNESS**2 * SPAN**4))
    assert found is not None
    assert found.frequency / unit == pytest.approx(frequency(ends), rel=2e-3)


@pytest.mark.parametrize("backend", ["interpreted", "compiled"])
def test_a_beam_let_go_on_springs_keeps_its_energy_and_its_frequency(backend: str) -> None:
    ends = CASES["uneven"]
    period = 2 * math.pi / frequency(ends) * math.sqrt(DENSITY * THICKNESS**2 * SPAN**4 / BENDING)
    changes = {"run.duration": f"{4 * period} s", "run.frames": 401, "numerics.backend": backend, "numerics.cells": 10}
    run = sc.simulate(scene(ends, **changes, **{"run.effects": [*STATIC, "inertia"]}))
    fields = run.data
    assert run.summary["backend"] == backend
    assert run.summary["energy_residual"] < 1e-3
    # The end on the spring moves as the first mode nearly alone: by its spectrum around that frequency.
    end, time = fields["y"].values[:, 0], fields["time"].values
    waves = np.exp(2j * np.pi * np.outer(np.linspace(0.9, 1.1, 401) / period, time))
    peak = np.abs(waves @ ((end - end.mean()) * np.hanning(len(end)))).argmax()
    assert np.linspace(0.9, 1.1, 401)[peak] == pytest.approx(1, rel=1e-2)
    # What the springs hold is the energy of the end alone.
    x, y = fields["x"].values[:, 0], end
    stored = 40 * PLACE / 2 * ((x + SPAN / 2) ** 2 + y**2)
    assert np.all(fields["energy_supports"].values >= stored * (1 - 1e-6))


@pytest.mark.parametrize("dimensions", [2, 3])
def test_a_support_that_moves_works_through_its_spring(dimensions: int) -> None:
    """The right one goes out: two springs and the filament, k and E A/L, in series; what it gives is what is stored."""
    k = E * THICKNESS**2 / SPAN / 2
    ends = BOTH | {"left_stiffness": k, "right_stiffness": k, "motion": [[0.0, 0.0, 0.0], [1.0, 1e-6, 0.0]]}
    run = sc.simulate(scene(ends, 0.0, **{"numerics.cells": 4, "run.dimensions": dimensions}))
    fields = run.data
    force = 1e-6 / (2 / k + SPAN / (E * THICKNESS**2))
    assert fields["tension"].values[-1] == pytest.approx(force, rel=1e-4)
    assert fields["energy_supports"].values[-1] == pytest.approx(force**2 / k, rel=1e-4)
    assert fields["work_external"].values[-1] == pytest.approx(force * 1e-6 / 2, rel=1e-2)


@pytest.mark.parametrize(
    ("rigid", "springs"),
    [("clamped", {"rotational_stiffness": 1e9 * TURN}), ("clamped", {"stiffness": 1e8 * PLACE}),
     ("pinned", {"rotational_stiffness": 1e-9 * TURN})],
)  # fmt: skip
def test_a_spring_is_a_clamp_where_it_is_stiff_and_a_pin_where_it_is_soft(
    rigid: str, springs: dict[str, float]
) -> None:
    elastic = BOTH | {f"{side}_{key}": value for side in ("left", "right") for key, value in springs.items()}
    wanted, found = (
        sc.simulate(scene(ends, **{"numerics.cells": 10, "numerics.grading": 1})).data["midpoint"].values[-1]
        for ends in ({"left": rigid, "right": rigid}, elastic)
    )
    assert found == pytest.approx(wanted, rel=1e-5)


def test_what_is_not_given_is_rigid_and_a_zero_is_a_pin() -> None:
    only = scene(BOTH | {"left_stiffness": 1.0, "right_rotational_stiffness": 0.0}).ends.supports
    assert [(one.x, one.y, one.angle) for one in only] == [
        (Hold.SPRING, Hold.SPRING, Hold.RIGID),
        (Hold.RIGID, Hold.RIGID, Hold.FREE),
    ]


GIVEN = """
[filament]
span = "0.2 m"
thickness = "2 mm"
density = "1000 kg/m^3"
[material]
law = "elastic"
youngs_modulus = "1 GPa"
[ends]
left = "elastic"
left_stiffness = "20 N/m"
[run]
duration = "1 s"
"""
SLIDING = {"ends.right": "elastic", "ends.right_stiffness": "1 N/m", "ends.right_slides": True}
FAULTS: dict[str, tuple[dict[str, Any], str]] = {
    "negative": ({"ends.left_stiffness": "-2 N/m"}, "ends.left_stiffness"),
    "zero in displacement": ({"ends.left_stiffness": "0 N/m"}, "ends.left_stiffness"),
    "infinite": ({"ends.left_stiffness": "inf N/m"}, "ends.left_stiffness"),
    "without a unit": ({"ends.left_stiffness": 20}, "ends.left_stiffness"),
    "the other unit": ({"ends.left_rotational_stiffness": "20 N/m"}, "ends.left_rotational_stiffness"),
    "of a clamp": ({"ends.left": "clamped"}, "ends.left_stiffness"),
    "of the other end": ({"ends.right_rotational_stiffness": "1 N*m"}, "ends.right_rotational_stiffness"),
    "no stiffness": ({"ends.right": "elastic"}, "ends.right"),
    "misspelt": ({"ends.left": "elastik"}, "ends.left"),
    "nothing holds": ({"ends.left": "free", "ends.right": "free"}, "ends"),
    "small deflections": ({"model": "small-deflection"}, "ends.left"),
    "printed": ({"ends.left_rotational_stiffness": "1 N*m", "run.closure": "printed"}, "run.closure"),
    "slides": (
        {"ends.right": "elastic", "ends.right_stiffness": "1 N/m", "ends.right_slides": True},
        "ends.right_slides",
    ),
}


@pytest.mark.parametrize("name", FAULTS)
def test_what_makes_no_sense_is_refused(name: str) -> None:
    changes, path = FAULTS[name]
    plain = sc.Scene.from_dict(tomllib.loads(GIVEN))
    with pytest.raises(SceneError) as refused:
        plain.replace(changes)
    assert path in [fault.path for fault in refused.value.faults]


def test_a_list_of_effects_needs_sections_that_turn() -> None:
    with pytest.raises(SceneError, match="rotational spring"):
        sc.simulate(scene(CASES["turning"], **{"run.effects": "paper"}))
