"""Whether a filament that was kept in its plane would leave it: the out-of-plane tangent of every frame (THEORY3D 8).

Planar equations never leave the plane and say nothing. What they do not see are the displacement z of a node and the
two turns of its section out of the plane; their stiffness is that of the cells in torsion and sideways bending, with
the geometric part of the forces and moments that the planar run has found. A disturbance that grows as exp(s t) meets
E + eta s where a viscous stress stands beside the spring; what flows counts as its spring, which is stiffer. A fluid
without one is left alone: as its curvature grows its sections turn at that pace, which is no buckling.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.linalg import LinAlgError, cholesky_banded
from scipy.optimize import brentq

from softcat_sym.discretization.grid import Floats
from softcat_sym.discretization.point_rule import warping_rule
from softcat_sym.discretization.spatial import sideways_tangent
from softcat_sym.effects.free_vibration import solid_viscosity
from softcat_sym.effects.law import has_chains
from softcat_sym.effects.scaling_estimates import instant_modulus
from softcat_sym.errors import SceneError
from softcat_sym.physics.reissner import SHEAR_CORRECTION
from softcat_sym.physics.sections import SECTIONS
from softcat_sym.scene.dimensions import is_spatial
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

_FREE = 3
"""Unknowns of a node out of the plane: z and the turns about d1 and d2."""


@dataclass(frozen=True)
class Sideways:
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


def seeded(scene: Scene) -> Scene | None:
    """The scene in three dimensions, with a little of its weight to the side.

    None where nothing weighs, where three dimensions lack what it has, or where it names its effects or dimensions.
    """
    if scene.run.dimensions != "auto" or scene.run.effects != "auto" or scene.load.gravity == 0:
        return None
    try:
        return scene.replace({"run.dimensions": 3, "load.direction": [0.0, -1.0, SEED]})
    except SceneError:
        return None


def sideways(scene: Scene, fields: Mapping[str, Floats]) -> Sideways | None:
    """How a planar run would leave its plane; None if it stays, or has no stiffness that could lose its balance."""
    modulus = instant_modulus(scene)
    if is_spatial(scene) or modulus is None or has_chains(scene) or SECTIONS[scene.filament.section].plane_strain:
        return None
    if "moment" not in fields or not np.any(fields["moment"]):
        return None
    frames = np.unique(np.linspace(0, len(fields["time"]) - 1, _FRAMES).round().astype(int))
    fields = {name: values if name in _PLACES else values[frames] for name, values in fields.items()}
    time, held = fields["time"], _held(scene, fields["x"].shape[1])
    mass = _masses(scene, fields, held)
    # Of forces and moments, and of each unit of a modulus.
    carried = _stiffness(scene, fields, 0.0)
    geometric, elastic = (_bands(blocks, held) for blocks in (carried, _stiffness(scene, fields, 1.0) - carried))
    viscosity = solid_viscosity(scene)
    if scene.material.law == "kelvin-voigt":
        viscosity += float(scene.material.viscosity or 0.0)
    rates = np.array(
        [
            _growth_rate(band + modulus * unit, viscosity * unit, mass, time[-1])
            for band, unit in zip(geometric, elastic, strict=True)
        ]
    )
    if not np.any(rates):
        return None
    # A support that stops presses for an instant: only what is unstable at both ends of an interval grows in it.
    growth = float(np.sum(np.minimum(rates[1:], rates[:-1]) * np.diff(time)))
    return None if growth < GROWN else Sideways(float(time[np.flatnonzero(rates)[0]]), growth, float(rates.max()))


def _stiffness(scene: Scene, fields: Mapping[str, Floats], modulus: float) -> Floats:
    """Tangent of every cell in (z, turn about d1, about d2) of its two nodes, shape (frame, cell, 6, 6)."""
    filament, area = scene.filament, undeformed_area(scene)
    x, y, nodes = fields["x"], fields["y"], fields["X_node"]
    length = np.diff(nodes)
    psi = _section_angles(fields, length)
    stretch = np.hypot(np.diff(x, axis=1), np.diff(y, axis=1)) / length
    relative = fields["thickness"] * np.sqrt(stretch) / filament.thickness
    size = area * relative ** (SECTIONS[filament.section].area_power)
    h = filament.thickness * relative
    # Second moments over area, of bending about the second axis and of torsion.
    if filament.section == "circle":
        bending, torsion = h**2 / 16, h**2 / 8
    else:
        bending = np.full_like(h, filament.width**2 / 12)
        points = warping_rule(4, 4, filament.width / filament.thickness)
        torsion = h**2 / 4 * float(points.weight @ (points.W_2**2 + points.W_3**2))
    shear = modulus / (2 * (1 + scene.material.poisson))
    correction = float(SHEAR_CORRECTION[filament.section])
    shears = fields.get("shear", 0 * stretch)
    # n_1 of the tension (THEORY3D 4), in the plane.
    force = fields.get("axial_force", fields["tension"]) - fields["shear_force"] * shears
    force = force + 1.5 * fields["moment"] * fields["curvature"]
    given = (
        *(x[:, :-1], y[:, :-1], psi[:, :-1], x[:, 1:], y[:, 1:], psi[:, 1:], length),
        *(force, fields["shear_force"], fields["moment"], correction * shear * size / stretch**2),
        *(shear * size * torsion / stretch**3, modulus * size * bending / stretch**3),
    )
    flat = np.vstack([np.broadcast_to(one, stretch.shape).ravel() for one in given])
    return sideways_tangent(flat).reshape(*stretch.shape, 6, 6)


def _section_angles(fields: Mapping[str, Floats], length: Floats) -> Floats:
    """Angle of the sections at the nodes: of the tangent less the shear, averaged from the cells; cells at the ends."""
    theta = np.unwrap(np.arctan2(np.diff(fields["y"], axis=1), np.diff(fields["x"], axis=1)), axis=1)
    theta = theta - np.arctan(fields.get("shear", 0 * theta))
    inner = (theta[:, 1:] * length[:-1] + theta[:, :-1] * length[1:]) / (length[1:] + length[:-1])
    ends = (
        theta[:, 0] - (inner[:, 0] - theta[:, 0]) if inner.shape[1] else theta[:, 0],
        theta[:, -1] + (theta[:, -1] - inner[:, -1]) if inner.shape[1] else theta[:, -1],
    )
    return np.column_stack([ends[0], inner, ends[1]])


def _bands(blocks: Floats, held: Bools) -> Floats:
    """Lower bands of the matrix of every frame, shape (frame, 6, unknowns); what is held is a one on the diagonal."""
    frames, cells = blocks.shape[:2]
    bands = np.zeros((frames, 2 * _FREE, _FREE * (cells + 1)))
    for row in range(2 * _FREE):
        for column in range(row + 1):
            bands[:, row - column, column : column + _FREE * cells : _FREE] += blocks[:, :, row, column]
    for k in range(2 * _FREE):
        below = np.append(held[k:], np.ones(k, dtype=bool))
        bands[:, k, held | below] = float(k == 0)
    return bands


def _held(scene: Scene, nodes: int) -> Bools:
    """Which unknowns the ends hold: all at a clamp, all but the turn about d2 at a pin."""
    held = np.zeros(_FREE * nodes, dtype=bool)
    for kind, first in ((scene.ends.left, 0), (scene.ends.right, _FREE * (nodes - 1))):
        held[first : first + {"clamped": 3, "pinned": 2, "free": 0}[kind]] = True
    return held


def _masses(scene: Scene, fields: Mapping[str, Floats], held: Bools) -> Floats:
    """Mass of every unknown: of z half of that of the cells beside it, none of a turn or of what is held."""
    cells = np.diff(fields["X_node"]) * undeformed_area(scene) * scene.filament.density
    nodes = np.append(cells, 0.0) / 2 + np.append(0.0, cells) / 2
    return np.where(held, 0.0, np.column_stack([nodes, 0 * nodes, 0 * nodes]).ravel())


def _is_positive(band: Floats) -> bool:
    """Whether the matrix of a lower band is positive definite, its unknowns scaled to each other."""
    size, diagonal = band.shape[1], band[0]
    if np.min(diagonal) <= 0:
        return False
    scale = 1 / np.sqrt(diagonal)
    following = np.array([np.append(scale[k:], np.zeros(k)) for k in range(len(band))])
    try:
        cholesky_banded(band * following * scale[None, :size], lower=True, check_finite=False)
    except LinAlgError:
        return False
    return True


def _growth_rate(stiffness: Floats, damping: Floats, mass: Floats, duration: float) -> float:
    """Fastest rate s at which a disturbance grows [1/s]: s^2 M + s C + K is positive definite beyond it.

    0 where it is less than an e-fold in the whole run.
    """
    inertia = np.zeros_like(stiffness)
    inertia[0] = mass

    def resists(log_rate: float) -> float:
        rate = math.exp(log_rate)
        return 1.0 if _is_positive(stiffness + rate * damping + rate**2 * inertia) else -1.0

    low, high = math.log(1 / duration), math.log(_MOST / duration)
    if resists(low) > 0:
        return 0.0
    return math.exp(high if resists(high) < 0 else float(brentq(resists, low, high, xtol=1e-3)))
