"""A run begins in equilibrium; a slack filament in a minimum of its energy, not as a straight compressed bar."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.single_run import build
from softcat_sym.solvers import initial_state
from softcat_sym.solvers.initial_state import Equilibrium, sagging_guesses, settled
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Silence
from tests.common.assembled import midpoint, prepared, short_scene, without

KIRCHHOFF = ("bending", "finite-stretch", "thinning", "large-rotation")
THEORIES = {"kirchhoff": KIRCHHOFF, "shearing": (*KIRCHHOFF, "shear")}
BETWEEN_CLAMPS = np.pi**2 / 3
"""Euler's strain of a rectangular column between clamps, over (h0/L)^2: 4 pi^2 I/(A h0^2)."""


@dataclass(frozen=True)
class Shape:
    """A filament in some equilibrium."""

    graph: Graph
    x: Floats
    p: Floats
    straight: Floats
    z: Floats

    def at(self, z: Floats) -> Shape:
        """The same filament elsewhere."""
        return Shape(self.graph, self.x, self.p, self.straight, z)

    def searched(self, guess: Floats) -> Shape:
        """The equilibrium that Newton's method finds from a guess."""
        z = Equilibrium(self.graph).search(0.0, self.x, self.p, [guess])
        assert z is not None
        return self.at(z)

    def settled(self) -> Shape:
        return self.at(settled(self.graph, self.x, self.p, self.z, self.straight))

    @property
    def observed(self) -> dict[str, Floats]:
        found = self.graph.observables(time=0.0, state=self.x, algebraic=self.z, parameters=self.p)
        return {name: np.asarray(value, dtype=float).ravel() for name, value in found.items()}

    @property
    def energy(self) -> float:
        return float(self.observed["energy_elastic"][0] + self.observed["energy_potential"][0])

    @property
    def heights(self) -> Floats:
        """y over rest length, from the midpoint to the right support."""
        return self.z[np.isin(self.graph.z_kinds, ("y",))]

    @property
    def stiffness(self) -> float:
        """Lowest eigenvalue of the tangent stiffness over the masses: real, as it is symmetric and they positive."""
        graph = self.graph
        tangent = ca.Function("k", [graph.t, graph.x, graph.z, graph.p], [-ca.jacobian(graph.alg, graph.z)])
        values = np.linalg.eigvals(np.asarray(tangent(0.0, self.x, self.z, self.p)))
        assert np.max(np.abs(values.imag)) <= 1e-9 * np.max(np.abs(values.real))
        return float(np.min(values.real))


@cache
def started(scene: Scene) -> tuple[Shape, Shape]:
    """What Newton's method finds, and where the run begins."""
    given: list[Shape] = []

    def listen(graph: Graph, x: Floats, p: Floats, z: Floats, straight: Floats) -> Floats:
        given.append(Shape(graph, x, p, straight, z))
        return settled(graph, x, p, z, straight)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(initial_state, "settled", listen)
        start = build(scene, choose_effects(scene)).start
    assert start is not None
    return given[0], given[0].at(start.z)


@cache
def thick_and_slack(theory: str, gravity: str = "9.81 m/s^2") -> Scene:
    """A soft sheet between pins, 24 % longer than the span and a thirteenth of it thick."""
    table: dict[str, Any] = {
        "filament": {
            "span": "0.2 m",
            "rest_length": "0.2477351494308748 m",
            "thickness": "0.015546410410976368 m",
            "section": "sheet",
            "density": "1000 kg/m^3",
        },
        "material": {
            "law": "bingham",
            "youngs_modulus": "245545.7452684251 Pa",
            "viscosity": "2305.3075020013207 Pa*s",
            "yield_stress": "6178.290227976348 Pa",
        },
        "ends": {"left": "pinned", "right": "pinned"},
        "load": {"gravity": gravity},
        "run": {"duration": "0.58 s", "effects": [*THEORIES[theory], "viscous-flow", "yielding"]},
        "numerics": {"backend": "interpreted", "cells": 20, "grading": 1.0},
    }
    return Scene.model_validate(table)


def column(
    slack: float, *, thickness: float = 0.01, gravity: float = 1e-6, E: float = 1e7, theory: str = "kirchhoff"
) -> Scene:
    """An elastic bar between clamps that are closer than it is long, by this share; span 1 m."""
    filament = {"span": 1.0, "rest_length": 1 + slack, "thickness": thickness, "density": 1000.0}
    return Scene(
        filament=filament,
        material={"law": "elastic", "youngs_modulus": E},
        load={"gravity": gravity},
        run={"duration": 1.0, "frames": 2, "effects": list(THEORIES[theory])},
        numerics={"cells": 20, "grading": 1.0},
    )


def test_a_thick_slack_sheet_hangs_as_a_catenary_of_its_length() -> None:
    depths = []
    for theory in THEORIES:
        scene = thick_and_slack(theory)
        found, begun = started(scene)
        length = rest_length(scene) / scene.filament.span
        # Of an inextensible chain between level supports; u = span/(2 a).
        half = brentq(lambda u, length=length: np.sinh(u) / u - length, 1e-6, 10.0)
        depths.append(-float(np.min(begun.heights)))
        assert depths[-1] * length == pytest.approx((np.cosh(half) - 1) / (2 * half), rel=0.02)
        stretch = begun.observed["stretch"]
        assert np.all((stretch > 1) & (stretch < 1.01)) and np.all(begun.heights < 0)
        assert begun.energy <= found.energy + 1e-9 * abs(found.energy)
        assert begun.stiffness > 0
        if theory == "shearing":  # Newton's method alone would leave it a compressed arch
            assert np.max(found.observed["stretch"]) < 1 and np.min(found.heights) > 0
            assert begun.energy < found.energy - 90
    assert depths[1] == pytest.approx(depths[0], rel=1e-3), "a section that shears hangs where one that does not hangs"


def test_the_compressed_bar_is_left_whatever_led_to_it() -> None:
    """From the straight bar itself, which is in balance without weight."""
    for theory in THEORIES:
        begun = started(thick_and_slack(theory, "1e-9 m/s^2"))[1]
        bar = begun.searched(begun.straight)
        assert np.max(np.abs(bar.heights)) < 1e-6 and bar.stiffness < 0
        low = bar.settled()
        assert low.energy < bar.energy and low.stiffness > 0 and np.all(low.heights < 0)


def test_an_arch_that_stands_is_turned_over() -> None:
    """A stiff arch rests both ways; hanging is lower by the work of its weight."""
    _, hanging = started(column(0.02, gravity=0.01))
    across = np.isin(hanging.graph.z_kinds, ("y", "psi"))
    arch = hanging.searched(np.where(across, 2 * hanging.straight - hanging.z, hanging.z))
    assert np.all(arch.heights > 0) and arch.stiffness > 0
    low = arch.settled()
    assert low.z == pytest.approx(hanging.z, abs=1e-9)
    assert low.energy < arch.energy


def test_a_stiff_bar_hangs_rather_than_stands() -> None:
    """What leaves the saddle may rise: E = 100 000 rho g L holds it up, and yet hanging is lower."""
    for theory in THEORIES:
        for thickness, slack in [(0.05, 0.05), (0.1, 0.05), (0.1, 2 * BETWEEN_CLAMPS * 0.01)]:
            found, begun = started(column(slack, thickness=thickness, gravity=10.0, E=1e9, theory=theory))
            assert begun.heights[0] < -0.08, (theory, thickness, slack)
            assert begun.energy <= found.energy * (1 + 1e-9)
            assert begun.stiffness > 0


def test_a_column_between_clamps_buckles() -> None:
    """What Euler's strain does not take up is slope: y = a (1 + cos 2 pi X/L)/2 with a = (2 L/pi) sqrt(e - e_c)."""
    critical = BETWEEN_CLAMPS * 1e-4
    for theory in THEORIES:
        for over in (1.2, 2.0, 10.0):
            slack = over * critical
            begun = started(column(slack, theory=theory))[1]
            amplitude, expected = -float(np.min(begun.heights)), 2 / np.pi * np.sqrt(slack - critical)
            where = begun.graph.z_where[np.isin(begun.graph.z_kinds, ("y",))]
            assert amplitude == pytest.approx(expected, rel=0.01 if over > 1.5 else 0.03), (theory, over)
            np.testing.assert_allclose(-begun.heights / amplitude, (1 + np.cos(2 * np.pi * where)) / 2, atol=5e-3)
            assert begun.observed["stretch"] == pytest.approx(1 - critical, abs=0.03 * critical + slack**2)
            assert begun.stiffness > 0
    for share in (0.5, 0.9):  # below Euler's strain the nudge comes back, however soft the column has become
        begun = started(column(share * critical))[1]
        assert np.max(np.abs(begun.heights)) < 1e-6 and begun.stiffness > 0


def test_a_run_with_inertia_begins_at_rest_too() -> None:
    """The thick sheet is let go where it hangs, and stays there."""
    changes = {"run.effects": [*THEORIES["shearing"], "inertia"], "run.duration": "0.02 s", "numerics.estimate": False}
    still = sc.simulate(thick_and_slack("shearing").replace(changes))
    assert still.outcome.is_success, still.summary["message"]
    heights = still.data["midpoint"].values
    assert heights[0] < -0.06
    np.testing.assert_allclose(heights, heights[0], rtol=1e-4)


def test_without_inertia_a_run_begins_in_equilibrium() -> None:
    for law in ["elastic", "bingham"]:
        for ramp in ["0 s", "0.04 s"]:
            run = prepared(without(short_scene(law, ramp=ramp), "inertia"))
            graph = run.graph
            assert run.start is not None
            forces = ca.Function("forces", [graph.t, graph.x, graph.z, graph.p], [graph.alg])
            left = np.abs(np.asarray(forces(0.0, graph.start, run.start.z, run.p))).max()
            straight = np.abs(np.asarray(forces(1e9, graph.start, graph.straight, run.p))).max()
            assert left <= 1e-8 * straight
            height = midpoint(run, run.start.z)
            assert height < 0 if ramp == "0 s" else height == pytest.approx(0, abs=1e-12)


def test_guesses_sag_and_no_guess_is_no_equilibrium() -> None:
    run = prepared(without(short_scene(), "inertia"))
    guesses = sagging_guesses(run.graph, run.graph.straight, 0.1)
    assert [float(midpoint(run, guess)) for guess in guesses] == pytest.approx([-0.1, -0.025, 0, -0.3])
    for guess in guesses:
        moved = guess - run.graph.straight
        assert all(shift == 0 for shift, name in zip(moved, run.graph.algebraic_names, strict=True) if name[0] == "x")
    search = Equilibrium(run.graph).search
    assert search(0.0, run.graph.start, run.p, []) is None
    assert search(0.0, run.graph.start, run.p, [np.full(run.graph.straight.shape, np.nan)]) is None


def test_a_string_hangs_as_a_cable_or_has_no_shape_to_begin_with() -> None:
    """Before a ramp it carries nothing and resists nothing: its height is anything."""

    def string(law: str, ramp: str) -> Scene:
        return without(short_scene(law, frames=4, ramp=ramp), "inertia", "bending")

    for law in ("elastic", "bingham"):
        solution = prepared(string(law, "0.05 s")).solve(Silence())
        assert solution.outcome is Outcome.no_equilibrium
        assert len(solution.time) == 1 and "t = 0 s" in solution.message
    run = prepared(string("elastic", "0 s"))
    solution = run.solve(Silence())
    assert solution.outcome is Outcome.solved
    wanted = (3 * 1900 * 9.81 * 0.2 / (64 * 4e6)) ** (1 / 3)
    assert -midpoint(run, solution.z)[0] == pytest.approx(wanted, rel=0.03)
