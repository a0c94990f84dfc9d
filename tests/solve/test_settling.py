"""A slack filament starts in a minimum of its energy: hanging or buckled, not as a straight compressed bar."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.simulate import simulate
from softcat_sym.single_run import build
from softcat_sym.solvers import initial_state as starting
from softcat_sym.solvers.initial_state import Equilibrium, settled
from tests.acceptance.random_scenes import random_scenes

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

    @property
    def observed(self) -> dict[str, Floats]:
        seen = self.graph.observables(time=0.0, state=self.x, algebraic=self.z, parameters=self.p)
        return {name: np.asarray(value, dtype=float).ravel() for name, value in seen.items()}

    @property
    def energy(self) -> float:
        return float(self.observed["energy_elastic"][0] + self.observed["energy_potential"][0])

    @property
    def heights(self) -> Floats:
        """y over rest length, from the midpoint to the right support."""
        return self.z[np.isin(self.graph.z_kinds, ("y",))]

    @property
    def stiffnesses(self) -> Floats:
        """Eigenvalues of the tangent stiffness over the masses: real, as it is symmetric and they are positive."""
        graph = self.graph
        inputs = [graph.t, graph.x, graph.z, graph.p]
        stiffness = ca.Function("stiffness", inputs, [-ca.jacobian(graph.alg, graph.z)])
        values = np.linalg.eigvals(np.asarray(stiffness(0.0, self.x, self.z, self.p)))
        assert np.max(np.abs(values.imag)) <= 1e-9 * np.max(np.abs(values.real))
        return np.sort(values.real)


def started(scene: Scene, monkeypatch: pytest.MonkeyPatch) -> tuple[Shape, Shape]:
    """What Newton finds, and where the run begins."""
    given: list[Shape] = []

    def listen(graph: Graph, x: Floats, p: Floats, z: Floats, straight: Floats) -> Floats:
        given.append(Shape(graph, x, p, straight, z))
        return settled(graph, x, p, z, straight)

    monkeypatch.setattr(starting, "settled", listen)
    prepared = build(scene, choose_effects(scene))
    assert prepared.start is not None
    return given[0], given[0].at(prepared.start.z)


def thick_and_slack(theory: str) -> Scene:
    """A soft sheet between pins, 24 % longer than the span and a thirteenth of it thick."""
    asked = random_scenes(46)[45]
    names = [*THEORIES[theory], "viscous-flow", "yielding"]
    return asked.replace({"numerics.cells": 20, "numerics.grading": 1.0, "run.effects": names})


def column(
    slack: float, *, thickness: float = 0.01, gravity: float = 1e-6, E: float = 1e7, theory: str = "kirchhoff"
) -> Scene:
    """An elastic bar between clamps that are closer than it is long, by this share; span 1 m."""
    table: dict[str, Any] = {
        "filament": {
            "span": "1 m",
            "rest_length": f"{1 + slack!r} m",
            "thickness": f"{thickness!r} m",
            "density": "1000 kg/m^3",
        },
        "material": {"law": "elastic", "youngs_modulus": f"{E!r} Pa"},
        "load": {"gravity": f"{gravity!r} m/s^2"},
        "run": {"duration": "1 s", "frames": 2, "effects": list(THEORIES[theory])},
        "numerics": {"cells": 20, "grading": 1.0},
    }
    return Scene.model_validate(table)


def catenary_sag(length: float) -> float:
    """Sag of an inextensible chain of this length between level supports, lengths over the span."""
    half = brentq(lambda u: np.sinh(u) / u - length, 1e-6, 10.0)  # u = span/(2 a)
    return float((np.cosh(half) - 1) / (2 * half))


@pytest.mark.parametrize("theory", THEORIES)
def test_a_thick_slack_sheet_hangs_as_a_catenary_of_its_length(theory: str, monkeypatch: pytest.MonkeyPatch) -> None:
    scene = thick_and_slack(theory)
    found, begun = started(scene, monkeypatch)
    length = rest_length(scene) / scene.filament.span
    sag = -float(np.min(begun.heights)) * length
    stretch = begun.observed["stretch"]
    print(f"{theory}: stretch {found.observed['stretch'].min():.4f} -> {stretch.min():.4f}, sag {sag:.4f}")
    assert sag == pytest.approx(catenary_sag(length), rel=0.02)
    assert np.all(stretch > 1)
    assert np.all(stretch < 1.01)
    assert np.all(begun.heights < 0)
    assert begun.energy <= found.energy + 1e-9 * abs(found.energy)
    assert begun.stiffnesses[0] > 0


def test_newton_alone_would_leave_the_shearing_sheet_a_compressed_arch(monkeypatch: pytest.MonkeyPatch) -> None:
    found, begun = started(thick_and_slack("shearing"), monkeypatch)
    assert np.max(found.observed["stretch"]) < 1
    assert np.min(found.heights) > 0
    assert begun.energy < found.energy - 90


def test_a_section_that_shears_hangs_where_one_that_does_not_hangs(monkeypatch: pytest.MonkeyPatch) -> None:
    heights = [float(np.min(started(thick_and_slack(theory), monkeypatch)[1].heights)) for theory in THEORIES]
    assert heights[1] == pytest.approx(heights[0], rel=1e-3)


@pytest.mark.parametrize("theory", THEORIES)
def test_the_compressed_bar_is_left_whatever_led_to_it(theory: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """From the straight bar itself, which is in balance without weight."""
    scene = thick_and_slack(theory).replace({"load.gravity": "1e-9 m/s^2"})
    _, begun = started(scene, monkeypatch)
    z = Equilibrium(begun.graph).search(0.0, begun.x, begun.p, [begun.straight])
    assert z is not None
    bar = begun.at(z)
    assert np.max(np.abs(bar.heights)) < 1e-6
    assert bar.stiffnesses[0] < 0
    low = begun.at(settled(bar.graph, bar.x, bar.p, bar.z, bar.straight))
    assert low.energy < bar.energy
    assert low.stiffnesses[0] > 0
    assert np.all(low.heights < 0)


def test_an_arch_that_stands_is_turned_over(monkeypatch: pytest.MonkeyPatch) -> None:
    """A stiff arch rests both ways; hanging is lower by the work of its weight."""
    _, hanging = started(column(0.02, gravity=0.01), monkeypatch)
    mirrored = 2 * hanging.straight - hanging.z
    across = np.isin(hanging.graph.z_kinds, ("y", "psi"))
    z = Equilibrium(hanging.graph).search(0.0, hanging.x, hanging.p, [np.where(across, mirrored, hanging.z)])
    assert z is not None
    arch = hanging.at(z)
    assert np.all(arch.heights > 0)
    assert arch.stiffnesses[0] > 0
    low = arch.at(settled(arch.graph, arch.x, arch.p, arch.z, arch.straight))
    assert low.z == pytest.approx(hanging.z, abs=1e-9)
    assert low.energy < arch.energy


@pytest.mark.parametrize("theory", THEORIES)
@pytest.mark.parametrize(("thickness", "slack"), [(0.05, 0.05), (0.1, 0.05), (0.1, 2 * BETWEEN_CLAMPS * 0.01)])
def test_a_stiff_bar_hangs_rather_than_stands(
    thickness: float, slack: float, theory: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What leaves the saddle may rise: E = 100 000 rho g L holds it up, and yet hanging is lower."""
    found, begun = started(column(slack, thickness=thickness, gravity=10.0, E=1e9, theory=theory), monkeypatch)
    print(f"{theory}, h0/L = {thickness:g}, {slack:.0%}: {found.heights[0]:+.4f} -> {begun.heights[0]:+.4f}")
    assert begun.heights[0] < -0.08
    assert begun.energy <= found.energy * (1 + 1e-9)
    assert begun.stiffnesses[0] > 0


@pytest.mark.parametrize("theory", THEORIES)
@pytest.mark.parametrize("over", [1.2, 2.0, 10.0])
def test_a_column_between_clamps_buckles(over: float, theory: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """What Euler's strain does not take up is slope: y = a (1 + cos 2 pi X/L)/2 with a = (2 L/pi) sqrt(e - e_c)."""
    thickness = 0.01
    critical = BETWEEN_CLAMPS * thickness**2
    slack = over * critical
    _, begun = started(column(slack, thickness=thickness, theory=theory), monkeypatch)
    amplitude = -float(np.min(begun.heights))
    expected = 2 / np.pi * np.sqrt(slack - critical)
    profile = -begun.heights / amplitude
    where = begun.graph.z_where[np.isin(begun.graph.z_kinds, ("y",))]
    print(f"{theory}, {over:g} e_c: amplitude {amplitude:.6f}, {expected:.6f}, {amplitude / expected - 1:+.2e}")
    assert amplitude == pytest.approx(expected, rel=0.01 if over > 1.5 else 0.03)
    np.testing.assert_allclose(profile, (1 + np.cos(2 * np.pi * where)) / 2, atol=5e-3)
    assert begun.observed["stretch"] == pytest.approx(1 - critical, abs=0.03 * critical + slack**2)
    assert begun.stiffnesses[0] > 0


@pytest.mark.parametrize("share", [0.5, 0.9])
def test_a_column_below_eulers_strain_stays_straight(share: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """The nudge comes back, however soft the column has become."""
    _, begun = started(column(share * BETWEEN_CLAMPS * 1e-4), monkeypatch)
    assert np.max(np.abs(begun.heights)) < 1e-6
    assert begun.stiffnesses[0] > 0


def test_a_run_with_inertia_begins_at_rest_too() -> None:
    """The thick sheet is let go where it hangs, and stays there."""
    names = [*THEORIES["shearing"], "inertia"]
    still = simulate(thick_and_slack("shearing").replace({"run.effects": names, "run.duration": "0.02 s"}))
    assert still.outcome.is_success, still.summary["message"]
    heights = still.data["midpoint"].values
    assert heights[0] < -0.06
    np.testing.assert_allclose(heights, heights[0], rtol=1e-4)
