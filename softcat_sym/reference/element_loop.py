"""The problem, mesh and supports of the elements, the eight-node element, and the compiled loop of explicit steps."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from functools import cache
from importlib.resources import files
from operator import attrgetter
from typing import Any

import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.library import compile_library, load
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.reference.material_point import LAWS, PointCode
from softcat_sym.scene.parts import DOWN
from softcat_sym.scene.scene import Scene, elastic_time, rest_length
from softcat_sym.scene.tables import bodies_of

_ONLY: dict[str, object] = {
    "model": "filament",
    "filament.section": "rectangle",
    **dict.fromkeys(("filament.profile", "ends.motion", "initial.P", "initial.C"), ()),
    **dict.fromkeys(("ends.left", "ends.right"), "clamped"),
    **dict.fromkeys(("filament.curvature", "ends.drop", "ends.left_angle", "ends.right_angle"), 0.0),
    **dict.fromkeys(("material.loss_tangent", "load.point_mass", "load.shake"), 0.0),
    **dict.fromkeys(("surroundings.density", "surroundings.viscosity"), 0.0),
    "material.solid_viscosity": None,
    "material.hardening_modulus": None,
    "temperature.initial": None,
    **dict.fromkeys(("filament.twist", "load.tip_mass"), 0.0),
    "load.direction": DOWN,
    **dict.fromkeys(("load.tip_force", "load.tip_torque"), (0.0, 0.0, 0.0)),
    "ends.right_twist": (),
    "ends.right_slides": False,
    "initial.centreline": (),
    "run.until": "duration",
    "initial.stretch": 1.0,
    "extrusion.print_speed": None,
    "extrusion.path": (),
    **dict.fromkeys(("floor.friction", "floor.speed", "pillars.friction"), 0.0),
}
"""The only value of each key that the elements know."""


@dataclass(frozen=True, slots=True)
class Problem:
    """What the elements solve, in units of span, Young's modulus and density."""

    law: str  # A key of `LAWS`
    thickness: float  # h0/L
    material: tuple[tuple[str, float], ...]  # Constants of the law over E and the elastic time
    poisson: float  # Poisson's ratio
    gravity: float  # rho g L/E
    pull: float  # Of the surface in the undeformed filament, gamma (1/h0 + 1/D0)/E
    ramp: float  # Over the elastic time
    bodies: tuple[tuple[str, float], ...]  # Levels, place and radius of what the lower edge may lie on
    duration: float
    frames: int  # Evenly spaced output times, the first at 0


def _bodies(scene: Scene) -> tuple[tuple[str, float], ...]:
    """Floor and pillars over the span, as the loop takes them; none of a scene without."""
    span, pillars, half, floor = scene.filament.span, scene.pillars, scene.filament.thickness / 2, scene.floor
    if not (pillars.present or floor.present):
        return ()
    sizes = {
        "floor": -floor.room() - half if floor.present else -_FAR,
        "wall": (pillars.gap or _FAR) / 2,
        "top": pillars.height - half if pillars.present else -_FAR,
        "roundness": pillars.edge,
    }
    return tuple((name, size / span) for name, size in sizes.items())


def problem_of(scene: Scene) -> Problem:
    """Make a scene dimensionless."""
    found = {path: attrgetter(path)(scene) for path in _ONLY} | {"filament.rest_length": rest_length(scene)}
    only = _ONLY | {"filament.rest_length": scene.filament.span}
    if math.isclose(rest_length(scene), scene.filament.span, rel_tol=1e-12):
        del found["filament.rest_length"]
    faults = [
        Fault(
            path,
            f"{value!r} has no finite elements",
            "leaving it out" if only[path] in ((), None) else repr(only[path]),
        )
        for path, value in found.items()
        if value != only[path]
    ]
    faults += [
        Fault(f"material.{name}", f"{value!r}, which changes in time, has no finite elements", "a constant")
        for name, value in (*scene.material.histories().items(), *scene.material.natural_strains().items())
    ]
    faults += [
        Fault(f"{body.table_name}.bond", f"{body.bond!r} has no finite elements", "none")
        for body in bodies_of(scene)
        if body.bond != "none"
    ]
    if scene.material.law not in LAWS:
        faults.append(Fault("material.law", f"'{scene.material.law}' has no finite elements", ", ".join(LAWS)))
    if faults or scene.material.youngs_modulus is None:
        raise SceneError(faults)
    modulus, time, filament = scene.material.youngs_modulus, elastic_time(scene), scene.filament
    scales = {"youngs_modulus": modulus, "poisson": 1.0, "viscosity": modulus * time, "yield_stress": modulus}
    constants = ((name, getattr(scene.material, name), scale) for name, scale in scales.items())
    return Problem(
        law=scene.material.law,
        thickness=filament.thickness / filament.span,
        material=tuple((name, value / scale) for name, value, scale in constants if value is not None),
        poisson=scene.material.poisson,
        gravity=filament.density * scene.load.gravity * filament.span / modulus,
        pull=scene.surroundings.surface_tension * (1 / filament.thickness + 1 / filament.width) / modulus,
        ramp=scene.load.ramp / time,
        bodies=_bodies(scene),
        duration=scene.run.duration / time,
        frames=scene.run.frames,
    )


Floats = npt.NDArray[np.float64]

# Corners, then the middles of the edges, on the square of edge 2.
NODES: Floats = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, -1], [1, 0], [0, 1], [-1, 0]], dtype=np.float64)
_ROOT = 1 / math.sqrt(3)
POINTS: Floats = np.array([[-_ROOT, -_ROOT], [_ROOT, -_ROOT], [-_ROOT, _ROOT], [_ROOT, _ROOT]])

# Powers of the two coordinates in the serendipity space: no xi^2 eta^2.
_POWERS = np.array([[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2], [2, 1], [1, 2]])

# Elements whose frequency is computed: those with the largest sums of squared frequencies.
_CANDIDATES = 16


@cache
def _coefficients() -> Floats:
    """Coefficients of the monomials, a column for each shape function: 1 at its node, 0 at the others."""
    return np.asarray(np.linalg.inv(_monomials(NODES)[0]), dtype=np.float64)


def _monomials(at: Floats) -> tuple[Floats, Floats, Floats]:
    """Monomials of the serendipity space and their derivatives along the two edges; each of shape (points, 8)."""
    (m, n), x, y = _POWERS.T, at[:, :1], at[:, 1:]
    slope_x, slope_y = m * x ** np.maximum(m - 1, 0), n * y ** np.maximum(n - 1, 0)
    return x**m * y**n, slope_x * y**n, x**m * slope_y


def shape_values(at: Floats) -> Floats:
    """Shape functions at some points of the square; shape (points, 8)."""
    return np.asarray(_monomials(at)[0] @ _coefficients())


def shape_gradients(at: Floats) -> Floats:
    """Derivatives of the shape functions along the two edges; shape (2, 8, points)."""
    _, along, across = _monomials(at)
    return np.ascontiguousarray(np.stack([(along @ _coefficients()).T, (across @ _coefficients()).T]))


def mass_shares() -> Floats:
    """Share of the element's mass at each node (HRZ): the consistent diagonal, scaled to the whole."""
    gauss, weights = np.polynomial.legendre.leggauss(3)
    at = np.array([[x, y] for x in gauss for y in gauss])
    diagonal = np.array([p * q for p in weights for q in weights]) @ shape_values(at) ** 2
    return np.asarray(diagonal / diagonal.sum())


def largest_frequency(size: Floats, poisson: float, deformation: Floats | None = None) -> float:
    """Upper bound of the largest elastic frequency of a mesh: the largest of any of its elements on its own.

    The eigenvalues of assembled elements lie between those of the elements (Irons & Treharne 1971; Fried 1972), and
    supports only lower the largest.
    """
    gradient = shape_gradients(POINTS).transpose(2, 0, 1)[None] * (2 / size)[:, None, :, None]
    if deformation is not None:
        # Derivatives in space: F^-T times those in the reference shape.
        gradient = np.swapaxes(np.linalg.inv(deformation), -1, -2) @ gradient
    # The sum of all squared frequencies is proportional to this, whatever the isotropic moduli.
    trace = np.einsum("epia,a->e", gradient**2, 1 / mass_shares())
    gradient = gradient[np.argsort(trace)[-_CANDIDATES:]]
    strain = np.zeros((*gradient.shape[:2], 3, 16))
    strain[..., 0, 0::2] = strain[..., 2, 1::2] = gradient[..., 0, :]
    strain[..., 1, 1::2] = strain[..., 2, 0::2] = gradient[..., 1, :]
    # Elastic moduli over E in plane stress, for strains 11, 22 and the engineering shear 12.
    moduli = np.array([[1, poisson, 0], [poisson, 1, 0], [0, 0, (1 - poisson) / 2]]) / (1 - poisson**2)
    # Per mass: the area cancels between stiffness and mass.
    stiffness = np.einsum("epai,ab,epbj->eij", strain, moduli, strain, optimize=True)
    lightness = np.repeat(mass_shares(), 2) ** -0.5
    values = np.linalg.eigvalsh(stiffness / len(POINTS) * np.outer(lightness, lightness))
    return math.sqrt(float(values.max()))


Indices = npt.NDArray[np.int32]


@dataclass(frozen=True, slots=True)
class Mesh:
    """How many elements, and where they are short."""

    along: int = 64  # Elements over half the span
    through: int = 4  # Elements through the thickness; even, so that the centreline runs along nodes
    # Length of the element at midspan over that of the one at the clamp; lengths in between are geometric.
    grading: float = 1.0

    def __post_init__(self) -> None:
        """Refuse what is no mesh."""
        if self.along < 1:
            raise SoftcatError(f"mesh of {self.along} elements along the half span: take 1 or more")
        if self.through < 2 or self.through % 2:
            raise SoftcatError(f"mesh of {self.through} elements through the thickness: take an even number, 2 or more")
        if not 0 < self.grading < np.inf:
            raise SoftcatError(f"mesh grading of {self.grading}: take a positive number, 1 for equal elements")

    def edges(self) -> Floats:
        """X/L of the element boundaries, from 0 to 1/2; shape (along + 1,)."""
        exponent = np.linspace(0, 1, self.along) if self.along > 1 else np.zeros(1)
        lengths = self.grading**-exponent
        edges = np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum() / 2
        edges[-1] = 0.5
        return np.asarray(edges)


class HalfFilament:
    """Nodes and elements of half a filament; lengths over the span, mass over density times span^2 times width."""

    def __init__(self, mesh: Mesh, thickness: float) -> None:
        self.mesh, self.thickness = mesh, thickness
        edges, along, through = mesh.edges(), mesh.along, mesh.through
        # Node at each place of the half-element lattice, -1 in the middles of elements.
        lattice = np.full((2 * along + 1, 2 * through + 1), -1, dtype=np.int32)
        taken = np.ones(lattice.shape, dtype=bool)
        taken[1::2, 1::2] = False
        lattice[taken] = np.arange(taken.sum())
        # From midspan to the clamp, and upwards.
        self.centreline: Indices = np.ascontiguousarray(lattice[:, through])
        self.midspan: Indices = np.ascontiguousarray(lattice[0])
        self.face: Indices = np.ascontiguousarray(lattice[-1])  # Nodes of the clamped face
        columns = np.empty(2 * len(edges) - 1)
        columns[::2], columns[1::2] = edges, (edges[1:] + edges[:-1]) / 2
        # Symmetric to the last bit, so that the centreline lies at 0 and a face has no net height.
        rows = thickness * np.arange(-through, through + 1) / (2 * through)
        grid = np.stack(np.meshgrid(columns, rows, indexing="ij"), axis=-1)
        # Reference positions X, Y; shape (nodes, 2)
        self.position: Floats = np.ascontiguousarray(grid[lattice >= 0])
        # Nodes of each element, in the order of `NODES`; shape (along x through, 8), column by column
        i, k = (a.ravel() for a in np.mgrid[:along, :through])
        x, y = (NODES.astype(int) + 1).T
        self.corner: Indices = np.ascontiguousarray(lattice[2 * i[:, None] + x, 2 * k[:, None] + y])
        # Nodes of the lower and the upper edge of each column of elements: ends, middle; shape (along, 2, 3)
        lower, upper = self.corner[::through, [0, 1, 4]], self.corner[through - 1 :: through, [3, 2, 6]]
        self.edge: Indices = np.ascontiguousarray(np.stack([lower, upper], axis=1))
        # Edge lengths of each element; shape (elements, 2)
        lengths = np.repeat(np.diff(edges), through)
        self.size: Floats = np.stack([lengths, np.full_like(lengths, thickness / through)], axis=1)
        # Lumped mass; shape (nodes,)
        shares = self.size.prod(axis=1)[:, None] * mass_shares()
        self.mass: Floats = np.bincount(self.corner.ravel(), weights=shares.ravel()).astype(np.float64)
        # Reference positions of the Gauss points; shape (elements, 4, 2)
        self.points: Floats = np.asarray(np.einsum("pa,eai->epi", shape_values(POINTS), self.position[self.corner]))


class Clamp(Enum):
    """What a clamped face may still do.

    Holding the centre node alone is not offered: a point load indents without limit as the mesh is refined.
    """

    THINNING = "no axial displacement, centre fixed, section plane, vertical and free to thin: u_y = (lambda - 1) Y"
    FIXED = "every node of the face fixed"


@dataclass(frozen=True)
class Restraints:
    """Which displacements are zero, and which face thins as one."""

    held: npt.NDArray[np.bool_]  # shape (nodes, 2); Displacements along x and y that stay zero
    # shape (face nodes,); Nodes that move as u_y = (lambda - 1) Y with a common lambda; empty where no face does.
    face: Indices


def half_span_supports(strip: HalfFilament, clamp: Clamp) -> Restraints:
    """Symmetry at midspan (u_x = 0, u_y free), the clamp at X = L/2."""
    held = np.zeros(strip.position.shape, dtype=bool)
    held[strip.midspan, 0] = True
    held[strip.face] = True
    return Restraints(held, strip.face if clamp is Clamp.THINNING else strip.face[:0])


POINT_STATE = 3
_DOUBLES, _INTEGERS = ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_int)


def element_sources(code: PointCode) -> dict[str, str]:
    """C text by file name: the element loop, and the material point that it includes."""
    own = {name: (files(__package__) / "c" / name).read_text(encoding="utf-8") for name in ("elements.c", "elements.h")}
    return {**code.source, **own}


_STIFFNESS = 0.3
"""Of bodies over that of an element: they are nearly rigid, and the stable step stays that of the elements."""

_FAR = 1e30

_ARRAYS = ("displacement", "velocity", "acceleration", "point", "rate")
_ENERGIES = ("gravity_work", "plastic_work", "elastic_energy", "surface_energy", "contact_energy")
_TYPES: dict[str, Any] = {
    **dict.fromkeys(("elements", "nodes"), ctypes.c_long),
    "p_corner": _INTEGERS,
    **dict.fromkeys(("p_size", "p_gradient", "p_mass", "p_mobility"), _DOUBLES),
    "columns": ctypes.c_long,
    "p_edge": _INTEGERS,
    "face": ctypes.c_long,
    "p_face_node": _INTEGERS,
    "p_face_height": _DOUBLES,
    "face_inertia": ctypes.c_double,
    "p_material": _DOUBLES,
    "pull": ctypes.c_double,
    **dict.fromkeys(("half", "floor", "wall", "top", "roundness", "stiffness"), ctypes.c_double),
    **dict.fromkeys(("full_gravity", "ramp", "start", "step"), ctypes.c_double),
    **dict.fromkeys(("steps", "taken"), ctypes.c_long),
    **dict.fromkeys(("p_displacement", "p_velocity", "p_acceleration", "p_point"), _DOUBLES),
    **dict.fromkeys(_ENERGIES, ctypes.c_double),
    "p_rate": _DOUBLES,
}
"""``struct softcat_strip`` of elements.h in its order; ``p_`` stands before what points at an array."""


class ElementLoop(ctypes.Structure):
    """A strip in motion. Span, Young's modulus and density are 1; energies are for unit width.

    What C counts it holds itself: `step`, `steps` and `taken` of the present stretch of time, the works of gravity and
    of the flow since the beginning, and the energies, elastic and of the surface, at the end of a stretch, or when last
    evaluated.
    """

    _fields_ = tuple(_TYPES.items())

    def __init__(
        self,
        strip: HalfFilament,
        supports: Restraints,
        code: PointCode,
        material: Mapping[str, float],
        *,
        gravity: float = 0.0,
        pull: float = 0.0,
        ramp: float = 0.0,
        bodies: Mapping[str, float] | None = None,
    ) -> None:
        height = np.ascontiguousarray(strip.position[supports.face, 1])
        elements, nodes = len(strip.corner), len(strip.position)
        inertia = float(strip.mass[supports.face] @ height**2)
        super().__init__(
            elements=elements,
            nodes=nodes,
            columns=strip.mesh.along,
            face=len(height),
            face_inertia=inertia,
            pull=pull * strip.thickness,
            full_gravity=gravity,
            ramp=ramp,
            half=strip.thickness / 2,
            stiffness=_STIFFNESS * strip.mesh.through / strip.thickness if bodies else 0.0,
            **(bodies or {}),
        )
        functions = ("softcat_gravity", "softcat_evaluate", "softcat_march")
        self._library = load(compile_library(element_sources(code), units=["elements.c"]), *functions)
        this, real, count = ctypes.POINTER(ElementLoop), ctypes.c_double, ctypes.c_long
        for name, given, returned in zip(
            functions, ((real,), (real, real), (count,)), (real, count, count), strict=True
        ):
            function = getattr(self._library, name)
            function.argtypes, function.restype = (this, *given), returned
        self.strip = strip
        self.displacement, self.velocity, self.acceleration = (np.zeros((nodes, 2)) for _ in range(3))
        self.point = np.tile([1.0, 0.0, 1.0], (elements, len(POINTS), 1))
        self.rate = np.zeros((elements, len(POINTS)))
        # What C points at is kept alive here.
        self._constant: dict[str, npt.NDArray[Any]] = {
            "corner": strip.corner,
            "edge": strip.edge,
            "size": strip.size,
            "gradient": shape_gradients(POINTS),
            "mass": strip.mass,
            "mobility": np.where(supports.held, 0.0, 1 / strip.mass[:, None]),
            "face_node": supports.face,
            "face_height": height,
            "material": np.array([material[name] for name in code.parameters]),
        }
        for name, array in {**self._constant, **{name: getattr(self, name) for name in _ARRAYS}}.items():
            setattr(self, f"p_{name}", array.ctypes.data_as(_TYPES[f"p_{name}"]))

    @property
    def time(self) -> float:
        """Time reached."""
        return float(self.start + self.step * self.taken)

    @property
    def kinetic_energy(self) -> float:
        """Kinetic energy, from the speeds half a step before and after.

        In a linear system the sum of it and the elastic energy is what the leap-frog keeps to round-off; with the speed
        at the step itself the sum would swing with the square of the step.
        """
        squares = self.velocity**2 - (0.5 * self.step * self.acceleration) ** 2
        return float(0.5 * self.strip.mass @ squares.sum(axis=1))

    def gravity(self, time: float) -> float:
        """Gravity at a time, rho g L/E."""
        return float(self._library.softcat_gravity(ctypes.byref(self), time))

    def deformation(self) -> Floats:
        """Deformation gradients at the Gauss points; shape (elements, 4, 2, 2)."""
        return deformation_of(self.strip, self.displacement)

    def evaluate(self, step: float, time: float) -> None:
        """Compute accelerations, elastic energy and rates where the strip is, its points flowing for `step`."""
        self._check(self._library.softcat_evaluate(ctypes.byref(self), step, time))

    def begin(self, start: float, step: float, steps: int) -> None:
        """Begin a stretch of time."""
        self.start, self.step, self.steps, self.taken = start, step, steps, 0

    def march(self, until: int) -> None:
        """Step until so many steps of this stretch are taken; the last one leaves elastic energy and rates."""
        self._check(self._library.softcat_march(ctypes.byref(self), until))

    def _check(self, failed: int) -> None:
        if failed == 0:
            return
        mesh = self.strip.mesh
        column, row = divmod(failed - 1, mesh.through)
        place = f"element {column + 1} of {mesh.along} from midspan, {row + 1} of {mesh.through} from below"
        raise SoftcatError(
            f"finite elements: {place}, was turned inside out at t = {self.time:.6g} L sqrt(rho/E); "
            "shorten the steps (step_factor below 1), refine the mesh where it stretches most, or end the run earlier"
        )


def deformation_of(strip: HalfFilament, displacement: Floats) -> Floats:
    """Deformation gradients at the Gauss points; shape (elements, 4, 2, 2)."""
    slopes = np.einsum("eai,Jap->epiJ", displacement[strip.corner], shape_gradients(POINTS))
    return np.asarray(np.eye(2) + slopes * (2 / strip.size)[:, None, None, :])
