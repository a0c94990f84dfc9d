"""Whether a filament that was kept in its plane would leave it: the out-of-plane tangent of every frame (THEORY3D 8).

Planar equations never leave the plane and say nothing. What they do not see are the displacement z of a node and the
two turns of its section out of the plane; their stiffness is that of the cells in torsion and sideways bending, with
the geometric part of the forces and moments that the planar run has found. A disturbance that grows as exp(s t) meets
E + eta s where a viscous stress stands beside the spring; what flows counts as its spring, which is stiffer. A fluid
without one is left alone: as its curvature grows its sections turn at that pace, which is no buckling.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from softcat_sym.discretization.section_rule import warping_rule
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SceneError
from softcat_sym.estimates.free_vibration import solid_viscosity
from softcat_sym.estimates.scaling import instant_modulus, section_of
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.ends import Support
from softcat_sym.scene.scene import Scene, undeformed_area

Bools = npt.NDArray[np.bool_]

GROWN = math.log(100.0)
"""By how many e-folds a disturbance may grow sideways: what a hundredth of a thickness makes one."""

_FRAMES = 201
"""At most, evenly spaced: growth is an integral over the run."""

_PLACES = ("X_node", "X_cell")

SEED = 1e-4
"""Share of the weight that pushes a filament out of the plane in which it cannot stay."""

_MOST = 1e3
"""Fastest growth that is told from a faster one, in e-folds of the whole run."""

_HALVINGS = 14
"""Of that range on a scale of logarithms: to a thousandth."""

_SMALL = 1e-4
"""Half of the turn of a cell [rad] below which its cotangent is a series."""

_NEARLY_STRAIGHT = 0.2
"""Turn from one end to the other [rad]."""

_FREE = 3
"""Unknowns of a node out of the plane: z and the turns about d1 and d2."""


@dataclass(frozen=True)
class OutOfPlaneInstability:
    """How a planar motion would leave its plane."""

    time: float  # From when on it is unstable [s]
    growth: float  # By how many e-folds a disturbance grows until the end
    rate: float  # Fastest growth [1/s]

    @property
    def found(self) -> str:
        """Since when and how much it grows."""
        return (
            f"unstable sideways from {self.time:.4g} s on: a disturbance out of its plane grows by a factor of "
            f"e^{self.growth:.3g}"
        )

    @property
    def warning(self) -> str:
        """What a user of the planar run should know."""
        return (
            f"{self.found}, which this planar run does not follow; take run.dimensions = 3 and a load.direction "
            f"that is a little out of the plane, such as [0, -1, {SEED:g}]"
        )

    @property
    def followed(self) -> str:
        """What a user of the run in three dimensions that took its place should know."""
        return (
            f"in its plane it is {self.found}; it was followed in three dimensions instead, with {SEED:g} of its "
            "weight to the side: which side, and when, a disturbance of your own decides; run.dimensions = 2 keeps it "
            "in its plane"
        )


def perturbed_3d_scene(scene: Scene) -> Scene | None:
    """The scene in three dimensions, with a little of its weight to the side.

    None where nothing weighs, where three dimensions lack what it has, or where it names its effects or dimensions.
    """
    if scene.run.dimensions != "auto" or scene.run.effects != "auto" or scene.load.gravity == 0:
        return None
    try:
        return scene.replace({"run.dimensions": 3, "load.direction": [0.0, -1.0, SEED]})
    except SceneError:
        return None


def out_of_plane_instability(scene: Scene, fields: Mapping[str, Floats]) -> OutOfPlaneInstability | None:
    """How a planar run would leave its plane; None if it stays, or has no stiffness that could lose its balance."""
    modulus = instant_modulus(scene)
    if is_spatial(scene) or modulus is None or scene.material.spec.has_chains or section_of(scene).plane_strain:
        return None
    if "moment" not in fields or not np.any(fields["moment"]):
        return None
    times = len(fields["time"])
    if times > _FRAMES:
        frames = np.linspace(0, times - 1, _FRAMES).round().astype(int)
        fields = {name: values if name in _PLACES else values[frames] for name, values in fields.items()}
    time, held = fields["time"], _held(scene, fields["x"].shape[1])
    mass = _masses(scene, fields, held)
    cells = PlanarCells.of(scene, fields)
    if cells.stay(modulus, scene.ends.supports):
        return None
    # Of forces and moments, and of each unit of a modulus.
    carried, elastic = (cells.tangent(share, force=one) for share, one in ((0.0, 1.0), (1.0, 0.0)))
    for cell, first, side in ((0, 0, "left"), (-1, _FREE, "right")):
        place, turn = scene.ends.stiffness(side)
        spring = [k if k < math.inf else 0.0 for k in (place, turn, turn)]
        carried[:, cell, range(first, first + _FREE), range(first, first + _FREE)] += spring
    viscosity = solid_viscosity(scene)
    if scene.material.spec.viscous_stress:
        viscosity += float(scene.material.viscosity or 0.0)
    matrices = zip(banded(carried + modulus * elastic, held), banded(viscosity * elastic, held), strict=True)
    rates = np.array([_growth_rate(stiff, damped, mass, float(time[-1])) for stiff, damped in matrices])
    if not np.any(rates):
        return None
    # A support that stops presses for an instant: only what is unstable at both ends of an interval grows in it.
    growth = float(np.sum(np.minimum(rates[1:], rates[:-1]) * np.diff(time)))
    begins = float(time[np.flatnonzero(rates)[0]])
    return None if growth < GROWN else OutOfPlaneInstability(begins, growth, float(rates.max()))


@dataclass(frozen=True)
class PlanarCells:
    """Planar cells, all of shape (frames, cells): what holds them in their plane."""

    length: Floats  # At rest [m]
    Lam: Floats  # Strains of the cell, and by how much it turns from its first node to its last
    Gam: Floats
    turn: Floats
    n_1: Floats  # Conjugates [N, N m]
    n_2: Floats
    M: Floats
    stiffness: tuple[Floats, Floats, Floats]  # In Gam_3, twist and sideways bending, over the modulus [m^2, m^4]

    @classmethod
    def of(cls, scene: Scene, fields: Mapping[str, Floats]) -> PlanarCells:
        """From what a planar run has stored."""
        filament, area = scene.filament, undeformed_area(scene)
        length, stretch = np.diff(fields["X_node"]), fields["stretch"]
        shears = fields.get("shear", np.zeros_like(stretch))
        Lam = stretch / np.sqrt(1 + shears**2)
        relative = fields["thickness"] * np.sqrt(stretch) / filament.thickness
        size = area * relative ** section_of(scene).area_power
        h = filament.thickness * relative
        # Second moments over area, of bending about the second axis and of torsion.
        if filament.section == "circle":
            bending, torsion = h**2 / 16, h**2 / 8
        else:
            bending = np.full_like(h, filament.width**2 / 12)
            points = warping_rule(4, 4, filament.width / filament.thickness)
            torsion = h**2 / 4 * float(points.weight @ (points.tables["W_2"] ** 2 + points.tables["W_3"] ** 2))
        shear = size / (2 * (1 + scene.material.poisson))
        correction = float(section_of(scene).shear_correction)
        # n_1 of the tension (THEORY3D 4), in the plane.
        force = fields.get("axial_force", fields["tension"]) - fields["shear_force"] * shears
        force = force + 1.5 * fields["moment"] * fields["curvature"]
        # Not by a power of three, which takes thirty times as long.
        cubed = stretch * stretch * stretch
        stiffness = correction * shear / stretch**2, shear * torsion / cubed, size * bending / cubed
        strains = Lam, shears * Lam, fields["curvature"] * Lam * length
        return cls(length, *strains, force, fields["shear_force"], fields["moment"], stiffness)

    def stay(self, modulus: float, ends: Sequence[Support]) -> bool:
        """Whether they surely stay in their plane.

        In frames that do not turn with the filament the two turns phi of a section have the energy (A p^2 + B r^2 +
        M (phi_1 r - phi_2 p) - n_2 Lam phi_1 phi_2 + n_2 Gam phi_1^2)/2 with p^2 + r^2 = |phi_X|^2, more under tension,
        and less by |n_1| Lam phi^2 under pressure. By parts with M_X = n_2 Lam - n_1 Gam, phi^2 <= w int phi_X^2 with
        w = x (l - x)/l between two clamps and x from one, it is positive if the lesser of A and B exceeds
        2 sqrt(int M^2 w) + int (|M k| + |n_1 Gam| + 2 |n_2 Gam| + 2 <-n_1> Lam) w.
        Between pins the turn about d2 has no mean, as z vanishes at both: w = l (1/3 - x/l + x^2/l^2), if it is nearly
        straight.
        """
        whole, at = float(self.length.sum()), np.cumsum(self.length) - self.length / 2
        clamped = [end.holds_height and end.holds_angle for end in ends]
        if all(end.holds_height and not end.carries_moment for end in ends):
            weight = whole / 3 - at * (whole - at) / whole
            if np.abs(np.cumsum(self.turn, axis=1)).max() > _NEARLY_STRAIGHT:
                return False
        elif any(clamped):
            weight = at * (whole - at) / whole if all(clamped) else at if clamped[0] else whole - at
        else:
            return False
        weight = weight * self.length
        least = modulus * np.minimum(*self.stiffness[1:]).min(axis=1)
        potential = np.abs(self.M * self.turn / self.length) - 2 * np.minimum(self.n_1, 0) * self.Lam
        potential += (np.abs(self.n_1) + 2 * np.abs(self.n_2)) * np.abs(self.Gam)
        return bool(np.all(least > 2 * np.sqrt(self.M**2 @ weight) + potential @ weight))

    def tangent(self, modulus: float, force: float) -> Floats:
        """Second derivative of n_1 |(Lam, Gam_3)| + n_2 Gam - M k_3 + (C Gam_3^2 + GJ k_1^2 + EI k_2^2)/2 of each cell.

        By z and the turns a, b of its nodes about d1 and d2, shape (frames, cells, 6, 6), to second order in
        zeta = z_X, sigma = (a + b)/2 and delta = (b - a)/2: with T = tan(turn/4), J (v_1, v_2) = (-v_2, v_1) and
        g = turn cot(turn/2) the middle of the cell turns by m = sigma + T J delta and m_3 = -(T/2) sigma . delta,
        k d = g delta + turn J sigma, k_3 d = turn + h delta^2 - turn/2 sigma^2 + (1 - g) delta . J sigma.
        A tension pulls along the fibre: of itself it does not tilt the section, however soft that is in shear.
        """
        u, T, d = self.turn / 2, np.tan(self.turn / 4), self.length
        # u cot u, and cot u (1 - u cot u), which is u/3 where nothing turns.
        small = np.abs(u) < _SMALL
        safe = np.where(small, 1.0, u)
        ucot = np.where(small, 1 - u**2 / 3, safe / np.tan(safe))
        h = np.where(small, u / 3, (1 - ucot) / np.tan(safe))
        L, G, g = self.Lam, self.Gam, 2 * ucot
        zeta, s_1, s_2, d_1, d_2 = (np.eye(5)[k][:, None, None] + 0 * u for k in range(5))
        m_1, m_2 = s_1 - T * d_2, s_2 + T * d_1
        slide = zeta - G * m_1 + L * m_2
        k_1, k_2 = (g * d_1 - self.turn * s_2) / d, (g * d_2 + self.turn * s_1) / d
        # Each term a weight times the product of two linear forms, over the length.
        shears, twists, bends = (modulus * one for one in self.stiffness)
        n_1, n_2, M = (force * one for one in (self.n_1, self.n_2, self.M))
        m_3 = -T / 2 * (n_1 * G - n_2 * L)
        terms = (
            (-n_1, m_2, zeta),
            (n_1 * G / 2 + n_2 * L / 2, m_1, m_2),
            (-n_1 * L / 2, m_2, m_2),
            (n_2, m_1, zeta),
            (-n_2 * G / 2, m_1, m_1),
            (m_3, s_1, d_1),
            (m_3, s_2, d_2),
            (n_1 / (2 * L) + shears / 2, slide, slide),
            (twists / 2, k_1, k_1),
            (bends / 2, k_2, k_2),
            *((-M / d * h, one, one) for one in (d_1, d_2)),
            *((M / d * u, one, one) for one in (s_1, s_2)),
            (M / d * (1 - g), d_1, s_2),
            (-M / d * (1 - g), d_2, s_1),
        )
        form = sum((np.einsum("fc,ifc,jfc->fcij", weight, a, b) for weight, a, b in terms), np.zeros(()))
        form = (form + form.transpose(0, 1, 3, 2)) * d[:, None, None]
        # (zeta, sigma, delta) of (z, turns) of both nodes.
        of_nodes = np.zeros((len(d), 5, 2 * _FREE))
        of_nodes[:, 0, 0], of_nodes[:, 0, _FREE] = -1 / d, 1 / d
        for axis in (1, 2):
            of_nodes[:, axis, [axis, _FREE + axis]] = 0.5
            of_nodes[:, 2 + axis, axis], of_nodes[:, 2 + axis, _FREE + axis] = -0.5, 0.5
        return np.asarray(np.einsum("cki,fckl,clj->fcij", of_nodes, form, of_nodes, optimize=True))


def banded(blocks: Floats, held: Bools) -> Floats:
    """Lower bands of the matrices of all frames, shape (frames, 6, unknowns), from the blocks of their cells.

    What is held is a one on the diagonal.
    """
    frames, cells = blocks.shape[:2]
    bands = np.zeros((frames, 2 * _FREE, len(held)))
    for row in range(2 * _FREE):
        for column in range(row + 1):
            bands[:, row - column, column : column + _FREE * cells : _FREE] += blocks[:, :, row, column]
    bands[:, :, held] = 0.0
    for below in range(2 * _FREE):
        bands[:, below, np.flatnonzero(held[below:])] = 0.0
    bands[:, 0, held] = 1.0
    return bands


def is_positive(bands: Floats) -> bool:
    """Whether a matrix is positive definite: it has a Cholesky factor."""
    # Imported here: most planar runs surely stay in their plane, and do without SciPy, which takes long to load.
    from scipy.linalg.lapack import dpbtrf

    return bool(dpbtrf(bands, lower=1)[1] == 0)


def _held(scene: Scene, nodes: int) -> Bools:
    """Which unknowns the ends hold: all at a clamp, all but the turn about d2 at a pin."""
    held = np.zeros(_FREE * nodes, dtype=bool)
    for support, first in zip(scene.ends.supports, (0, _FREE * (nodes - 1)), strict=True):
        held[first : first + _FREE] = support.holds_height, support.holds_height, support.holds_angle
    return held


def _masses(scene: Scene, fields: Mapping[str, Floats], held: Bools) -> Floats:
    """Mass of every unknown: of z half of that of the cells beside it, none of a turn or of what is held."""
    cells = np.diff(fields["X_node"]) * undeformed_area(scene) * scene.filament.density
    nodes = np.append(cells, 0.0) / 2 + np.append(0.0, cells) / 2
    return np.where(held, 0.0, np.column_stack([nodes, 0 * nodes, 0 * nodes]).ravel())


def _growth_rate(stiffness: Floats, damping: Floats, mass: Floats, duration: float) -> float:
    """Fastest rate s at which a disturbance of a frame grows [1/s]: s^2 M + s C + K is positive definite beyond it.

    0 where it is less than an e-fold in the whole run.
    """

    def stops(rate: float) -> bool:
        bands = stiffness + rate * damping
        bands[0] += rate**2 * mass
        return is_positive(bands)

    low, high = 1 / duration, _MOST / duration
    if stops(low):
        return 0.0
    for _ in range(_HALVINGS):
        middle = math.sqrt(low * high)
        low, high = (low, middle) if stops(middle) else (middle, high)
    return high
