"""Rods that leave their line or their plane, against Greenhill and Kirchhoff; springs against Wahl."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_bvp
from scipy.interpolate import BarycentricInterpolator
from scipy.linalg import eigh
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.discretization.unknowns import Floats
from tests.common.spatial_statics import FREE, PLACES, TURN, Statics, lowest
from tests.common.table import show

pytestmark = pytest.mark.slow

THIN, MODULUS, POISSON = 2e-3, 1e9, 0.3  # Over a length of one metre
BENDING = MODULUS * THIN**2 / 16  # Over the area
AT_THE_END = 1.0  # [s]
Quaternions = Floats


def about(axis: int, angles: Floats) -> Quaternions:
    """Turns about a fixed axis."""
    found = np.zeros((len(angles), 4))
    found[:, 0], found[:, 1 + axis] = np.cos(angles / 2), np.sin(angles / 2)
    return found


def matrix(q: Floats) -> Floats:
    """Rotation of a unit quaternion."""
    w, x, y, z = q
    return np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )


def rod(cells: int, **tables: dict[str, Any]) -> Statics:
    """A thin elastic rod of a metre with so many cells."""
    table: dict[str, dict[str, Any]] = {
        "filament": {"span": 1.0, "thickness": THIN, "section": "circle", "density": 1000.0},
        "material": {"law": "elastic", "youngs_modulus": MODULUS, "poisson": POISSON},
        "load": {"gravity": 0.0},
        "run": {"duration": AT_THE_END, "frames": 2},
        "numerics": {"cells": cells // 2, "grading": 1.0, "estimate": False},
    }
    for name, changes in tables.items():
        table[name] = {**table.get(name, {}), **changes}
    return Statics(sc.Scene.from_dict(table))


def turned_by_its_end(cells: int) -> Statics:
    """Between clamps, of which the right one is moved along the line and turned about it."""
    motion = [[0.0, 0.0, 0.0], [AT_THE_END, -0.1, 0.0]]
    return rod(cells, ends={"motion": motion, "right_twist": [[0.0, 0.0], [AT_THE_END, 1.0]]})


class Shaft:
    """A rod that is straight and twisted, its ends free to come together or held."""

    def __init__(self, cells: int, *, held: bool) -> None:
        self.statics, self.held = turned_by_its_end(cells), held
        self.X = self.statics.graph.grid.nodes + 0.5

    def state(self, turn: float, closer: float) -> tuple[Floats, Floats]:
        """State and numbers of an end turned by an angle and moved along."""
        p = self.statics.p(turn_1_angle=turn, motion_1_dx=closer)
        places = np.column_stack([-0.5 + (1 + closer) * self.X, 0 * self.X, 0 * self.X])
        return self.statics.guess(places, about(0, turn * self.X)), p

    def forces(self, turn: float, closer: float) -> tuple[float, float]:
        """Along the rod, and torque about it; over the area."""
        shown = self.statics.fields(AT_THE_END, *self.state(turn, closer))
        tension, torque, twist, stretch = (float(shown[n][3]) for n in ("tension", "torque", "twist", "stretch"))
        return tension - 1.5 * torque * twist / stretch, torque

    def lowest(self, turn: float) -> tuple[float, float]:
        """Lowest eigenvalue of the stiffness, and the torque over bending stiffness and length."""
        closer = 0.0 if self.held else brentq(lambda one: self.forces(turn, one)[0], -1e-2, 1e-2, xtol=1e-15)
        least = lowest(self.statics.stiffness(AT_THE_END, *self.state(turn, closer)))
        return least, self.forces(turn, closer)[1] / BENDING


def test_greenhill() -> None:
    """A rod between clamps that may come together buckles at a torque of 8.987 EI/L: tan(x) = x, x = M L/(2 EI).

    If they may not, the twisted rod presses against them (Poynting) and buckles long before.
    """
    exact = 2 * float(brentq(lambda x: np.sin(x) - x * np.cos(x), 4.0, 4.7))
    rows, errors = [], []
    for cells in (20, 40, 80):
        shaft = Shaft(cells, held=False)
        turn = float(brentq(lambda one, shaft=shaft: shaft.lowest(one)[0], 8.0, 14.0, xtol=1e-8))
        torque = shaft.lowest(turn)[1]
        errors.append(torque / exact - 1)
        rows.append([cells, f"{turn:.4f}", f"{torque:.4f}", f"{errors[-1]:+.1e}"])
    show(f"Greenhill's torque, {exact:.4f} EI/L", ("cells", "turn", "M L/EI", "error"), rows)
    assert abs(errors[-1]) < 5e-4
    # Of the second order; what is left is that of the thickness, of the order of (h0 k_1)^2.
    (first, second) = (coarse - fine for coarse, fine in pairwise(errors))
    assert np.log2(first / second) == pytest.approx(2, abs=0.1)
    held = Shaft(80, held=True)
    turn = float(brentq(lambda one: held.lowest(one)[0], 4.0, 8.0, xtol=1e-8))
    expected = float(brentq(held_ends, 4.0, 7.0))
    show("its ends held", ("turn", "of Kirchhoff's rod under that force"), [[f"{turn:.4f}", f"{expected:.4f}"]])
    assert turn == pytest.approx(expected, rel=2e-3)
    assert turn < 0.6 * exact * (1 + POISSON)


def held_ends(turn: float) -> float:
    """Vanishes where a rod buckles between clamps under its torque and the force with which it would lengthen.

    The energy E (gam^2/4)^2/2 + mu gam^2/2 of a shear gam = Lam^-3/2 k_1 r, with E gam^2/4 along the rod, presses with
    P = (3 mu J - E I) k_1^2/2. Then w = y + i z has w'''' - i m w''' + P w'' = 0: it is 1, X and exp(i n X), where
    n^2 - m n - P = 0. The determinant of w = w' = 0 at both ends is imaginary but for a factor exp(i m/2).
    """
    m, P = turn / (1 + POISSON), turn**2 * (3 / (1 + POISSON) - 1) / 2
    n = m / 2 + np.array([1, -1]) * np.sqrt(m * m / 4 + P)
    wave = np.exp(1j * n)
    matrix_ = np.array(
        [[1, 0, 1, 1], [0, 1, 1j * n[0], 1j * n[1]], [1, 1, *wave], [0, 1, 1j * n[0] * wave[0], 1j * n[1] * wave[1]]]
    )
    return float(np.imag(np.linalg.det(matrix_) * np.exp(-0.5j * m)))


class Curl:
    """A naturally curved rod that hangs from a clamp: Kirchhoff's inextensible rod, by polynomials.

    Lengths in that of the rod, moments in EI/L. In its plane theta_XX = w (1 - X) cos(theta), theta(0) that of the
    clamp, theta_X(1) = kappa. Out of it by turns a_1, a_2 about its own axes: the second variation of
    GJ k_1^2/2 + EI k_2^2/2 + EI (k_3 - kappa)^2/2 less the work of the weight, w (1 - X) at every section.
    """

    def __init__(self, curvature: float, angle: float, poisson: float) -> None:
        self.curvature, self.angle, self.torsion = curvature, angle, 1 / (1 + poisson)
        self._shape = lambda X: np.vstack([angle + curvature * X, curvature + 0 * X])

    def planar(self, weight: float) -> Any:
        """Angle and curvature in the plane; from the weight before."""

        def slope(X: Floats, y: Floats) -> Floats:
            return np.vstack([y[1], weight * (1 - X) * np.cos(y[0])])

        def ends(first: Floats, last: Floats) -> Floats:
            return np.array([first[0] - self.angle, last[1] - self.curvature])

        X = np.linspace(0, 1, 41)
        found = solve_bvp(slope, ends, X, self._shape(X), tol=1e-9, max_nodes=20000)
        assert found.success
        self._shape = found.sol
        return found.sol

    def lowest(self, weight: float, degree: int = 24) -> float:
        """Lowest eigenvalue out of the plane."""
        x, share = np.polynomial.legendre.leggauss(80)
        X, share = (x + 1) / 2, share / 2
        theta, k = self.planar(weight)(X)
        along, across = -weight * (1 - X) * np.sin(theta), -weight * (1 - X) * np.cos(theta)
        moment = k - self.curvature
        bases = [np.polynomial.legendre.Legendre.basis(n) for n in range(degree)]
        value = np.array([X * one(x) for one in bases])
        slope = np.array([one(x) + 2 * X * one.deriv()(x) for one in bases])
        a_1, a_2 = np.vstack([value, 0 * value]), np.vstack([0 * value, value])
        k_1, k_2 = np.vstack([slope, -k * value]), np.vstack([k * value, slope])

        def form(weights: Floats, one: Floats, other: Floats) -> Floats:
            found: Floats = (one * (weights * share)) @ other.T
            return found

        K = form(self.torsion + 0 * X, k_1, k_1) + form(1 + 0 * X, k_2, k_2) + form(along, a_2, a_2)
        mixed = form(moment, k_1, a_2) - form(moment, k_2, a_1) - form(across, a_1, a_2)
        mass = form(1 + 0 * X, a_1, a_1) + form(1 + 0 * X, a_2, a_2)
        return float(eigh(K + (mixed + mixed.T) / 2, mass, eigvals_only=True)[0])


LENGTH = 0.1
CURLED: dict[str, Any] = {"span": LENGTH, "thickness": 3.1e-3, "section": "circle", "density": 1200.0}
"""The bundled curled-rod."""
SOFT, GRAVITY = 1.3e6, 9.81
ONE_G = 16 * 1200.0 * GRAVITY * LENGTH**3 / (SOFT * 3.1e-3**2)
"""Weight over EI/L^2 of that rod."""


class HangingRod:
    """The package's rod of the same numbers at rest under a weight that grows."""

    def __init__(self, curvature: float, angle: float, poisson: float, cells: int) -> None:
        self.statics = rod(
            cells,
            filament={**CURLED, "curvature": curvature / LENGTH},
            material={"youngs_modulus": SOFT, "poisson": poisson},
            ends={"right": "free", "left_angle": angle},
        )
        self._shapes = {0.0: self.statics.start}

    def lowest(self, weight: float) -> float:
        """Lowest eigenvalue at a weight over EI/L^2; from the nearest shape that is known."""
        p = self.statics.p(gravity=GRAVITY * weight / ONE_G)
        near = self._shapes[min(self._shapes, key=lambda one: abs(one - weight))].copy()
        # In the plane: where the rod is about to leave it, Newton's method would.
        near[[self.statics.at(kind, node) for kind in ("z", "q1", "q2") for node in self.statics.nodes]] = 0.0
        self._shapes[weight] = self.statics.equilibrium(0.0, near, p)
        return lowest(self.statics.stiffness(0.0, self._shapes[weight], p))


def onset(lowest_at: Any, weights: Floats) -> float | None:
    """First weight at which the lowest eigenvalue changes its sign: the root of a cubic around it.

    Nearer to it no equilibrium is found by Newton's method, whose matrix is singular there.
    """
    first, before = float(weights[0]), lowest_at(float(weights[0]))
    for weight in weights[1:].tolist():
        now = lowest_at(weight)
        if before > 0 > now:
            inside = np.linspace(first, weight, 4)[1:3].tolist()
            values = [before, *(lowest_at(one) for one in inside), now]
            return float(brentq(BarycentricInterpolator([first, *inside, weight], values), first, weight))
        first, before = weight, now
    return None


CURLS = {
    0.0: ((2.0, 0.45), (3.0, 0.4), (4.0, 0.45)),
    -np.pi / 2: ((4.0, 0.45), (6.0, 0.3)),
}
"""By the angle of the clamp: curvature times length, and Poisson's ratio."""


@pytest.mark.parametrize(("name", "angle"), [("level", 0.0), ("downwards", -np.pi / 2)])
def test_curls_leave_their_plane(name: str, angle: float) -> None:
    """Weight at which a planar curl is no longer stable: the package's rod of 40 cells, and Kirchhoff's.

    Where a curl of the kind of Miller, Lazarus, Audoly & Reis (Phys. Rev. Lett. 112, 068103) becomes a helix: of their
    paper no table of numbers is to be had, so that the boundary is computed by polynomials instead.
    """
    rows = []
    weights = np.linspace(0.0, 40.0, 41)
    for curvature, poisson in CURLS[angle]:
        exact = onset(Curl(curvature, angle, poisson).lowest, weights)
        found = onset(HangingRod(curvature, angle, poisson, 40).lowest, weights)
        shown = ["stable", "stable", ""]
        assert (exact is None) == (found is None)
        if exact is not None and found is not None:
            shown = [f"{found:.4f}", f"{exact:.4f}", f"{found / exact - 1:+.1e}"]
            assert found == pytest.approx(exact, rel=5e-3)
        rows.append([f"{curvature:g}", f"{poisson:g}", *shown, "" if found is None else f"{found / ONE_G:.4f}"])
        if (angle, curvature, poisson) == (0.0, 3.0, 0.4):
            assert found is not None and 0.51 < found / ONE_G < 0.54
    header = ("curvature L", "Poisson", "w L^3/EI", "Kirchhoff", "error", "over g, curled-rod")
    show(f"weight from which a curl is unstable sideways, its clamp {name}; up to 40", header, rows)


STEEL, STEEL_POISSON, WIRE = 2e11, 0.3, 1e-3


class Spring:
    """A helical spring of round wire, its first end clamped and its last one free."""

    def __init__(self, index: float, pitch: float, coils: float, cells: int) -> None:
        self.radius, self.pitch = index * WIRE / 2, pitch
        c, s = np.cos(pitch), np.sin(pitch)
        self.length = 2 * np.pi * self.radius * coils / c
        shape = {"curvature": c * c / self.radius, "twist": s * c / self.radius}
        self.statics = rod(
            cells,
            filament={"span": self.length, "thickness": WIRE, **shape},
            material={"youngs_modulus": STEEL, "poisson": STEEL_POISSON},
            ends={"right": "free"},
        )
        self.axis = np.array([s, 0, c])
        shear = STEEL / (2 * (1 + STEEL_POISSON))
        area = np.pi / 4 * WIRE**2
        self.bending, self.torsion = STEEL * area * WIRE**2 / 16, shear * area * WIRE**2 / 8
        # The last is what a straight wire loses by shear and by being pulled.
        self.aside = self.length * (c * c / (0.9 * shear * area) + s * s / (STEEL * area))
        self.twisted = self.radius**2 * self.length * (c * c / self.torsion + s * s / self.bending)
        self.plain = 8 * (2 * self.radius) ** 3 * coils / (shear * WIRE**4)

    def compliances(self) -> Floats:
        """Of the tip against a force along the axis of the helix and a torque about it, 2 x 2."""
        z = self.statics.start
        K = self.statics.stiffness(0.0, z, self.statics.p())
        lengths = np.repeat([self.length, 1.0], 3)
        tip = np.linalg.inv(K)[-FREE:, -FREE:] / self.statics.unit * np.outer(lengths, lengths)
        last = self.statics.nodes[-1]
        place, q = (np.array([z[self.statics.at(kind, last)] for kind in kinds]) for kinds in (PLACES, TURN))
        centre = np.array([-0.5 * self.length, self.radius, 0.0])
        force = np.append(self.axis, matrix(q).T @ np.cross(centre - place * self.length, self.axis))
        torque = np.append(np.zeros(3), matrix(q).T @ self.axis)
        loads = np.array([force, torque])
        found: Floats = loads @ tip @ loads.T
        return found


SPRINGS = ((10, 5, 1, 20), (10, 30, 3, 60), (5, 10, 3, 60))
"""D/d, pitch in degrees, coils and cells."""


def test_helical_springs() -> None:
    """delta = 64 P R^3 n sec(alpha)/d^4 (cos^2/G + 2 sin^2/E), Wahl's for open coils, and with shear of the wire.

    Held against rotation: P = delta (GJ cos^2 + EI sin^2)/(L R^2) (Love, article 271). What the curvature of the wire
    does to the stresses inside, of the order of d^2/D^2, no theory of rods has.
    """
    rows = []
    for index, degrees, coils, cells in SPRINGS:
        spring = Spring(index, np.radians(degrees), coils, cells)
        found = spring.compliances()
        free = found[0, 0]
        c, s = np.cos(spring.pitch), np.sin(spring.pitch)
        love = (spring.torsion * c * c + spring.bending * s * s) / (spring.length * spring.radius**2)
        held = float(np.linalg.inv(found)[0, 0])
        errors = [free / (spring.twisted + spring.aside) - 1, free / spring.twisted - 1, free / spring.plain - 1]
        rows.append([index, degrees, coils, cells, *(f"{one:+.1e}" for one in (*errors, 1 / (held / love) - 1))])
        assert abs(errors[0]) < 2e-5
        assert 0 < errors[1] < 0.6 / index**2 and abs(1 / (held / love) - 1) < 0.6 / index**2
    header = ("D/d", "pitch [deg]", "coils", "cells", "exact rod", "Wahl", "8 P D^3 n/(G d^4)", "held: Love")
    show("lengthening of a helical spring over that of formulas, less 1", header, rows)
