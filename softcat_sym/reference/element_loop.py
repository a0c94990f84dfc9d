"""The problem, mesh and supports of the elements, the eight-node element, and the compiled loop of explicit steps."""

from __future__ import annotations

import ctypes
import hashlib
import json
import math
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from enum import Enum
from functools import cache, cached_property
from importlib.resources import files
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.library import compile_library, load
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.files import fill_atomically
from softcat_sym.interrupts import interrupts_go_to
from softcat_sym.reference.material_point import LAWS, PointCode
from softcat_sym.scene.scene import Scene, elastic_time, rest_length

# The only value of each key that the elements know.
_ONLY: tuple[tuple[str, object], ...] = (
    ("model", "filament"),
    ("filament.section", "rectangle"),
    ("filament.profile", ()),
    ("filament.curvature", 0.0),
    ("ends.left", "clamped"),
    ("ends.right", "clamped"),
    ("ends.drop", 0.0),
    ("ends.left_angle", 0.0),
    ("ends.right_angle", 0.0),
    ("ends.motion", ()),
    ("material.loss_tangent", 0.0),
    ("material.solid_viscosity", None),
    ("run.until", "duration"),
    ("load.point_mass", 0.0),
    ("load.shake", 0.0),
    ("surroundings.surface_tension", 0.0),
    ("initial.stretch", 1.0),
    ("initial.P", ()),
    ("initial.C", ()),
)


@dataclass(frozen=True, slots=True)
class Problem:
    """What the elements solve, in units of span, Young's modulus and density."""

    law: str  # A name of ``point_code.LAWS``
    thickness: float  # h0/L
    material: tuple[tuple[str, float], ...]  # Constants of the law over E and the elastic time
    poisson: float  # Poisson's ratio
    gravity: float  # rho g L/E
    ramp: float  # Over the elastic time
    duration: float
    frames: int  # Evenly spaced output times, the first at 0


def problem_of(scene: Scene) -> Problem:
    """Make a scene dimensionless."""
    faults = [_fault(path, value, wanted) for path, wanted in _ONLY if (value := _value(scene, path)) != wanted]
    if not math.isclose(rest_length(scene), scene.filament.span, rel_tol=1e-12):
        faults.append(_fault("filament.rest_length", rest_length(scene), scene.filament.span))
    if scene.material.law not in LAWS:
        faults.append(Fault("material.law", f"'{scene.material.law}' has no finite elements", ", ".join(LAWS)))
    if faults or scene.material.youngs_modulus is None:
        raise SceneError(faults)
    modulus, time = scene.material.youngs_modulus, elastic_time(scene)
    scales = {"youngs_modulus": modulus, "poisson": 1.0, "viscosity": modulus * time, "yield_stress": modulus}
    constants = ((name, getattr(scene.material, name), scale) for name, scale in scales.items())
    return Problem(
        law=scene.material.law,
        thickness=scene.filament.thickness / scene.filament.span,
        material=tuple((name, value / scale) for name, value, scale in constants if value is not None),
        poisson=scene.material.poisson,
        gravity=scene.filament.density * scene.load.gravity * scene.filament.span / modulus,
        ramp=scene.load.ramp / time,
        duration=scene.run.duration / time,
        frames=scene.run.frames,
    )


def _value(scene: Scene, path: str) -> object:
    value: object = scene
    for name in path.split("."):
        value = getattr(value, name)
    return value


def _fault(path: str, value: object, wanted: object) -> Fault:
    return Fault(path, f"{value!r} has no finite elements", "leaving it out" if wanted in ((), None) else f"{wanted!r}")


Floats = npt.NDArray[np.float64]

# Corners, then the middles of the edges, on the square of edge 2.
NODES: Floats = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [0, -1], [1, 0], [0, 1], [-1, 0]], dtype=np.float64)
_ROOT = 1 / math.sqrt(3)
POINTS: Floats = np.array([[-_ROOT, -_ROOT], [_ROOT, -_ROOT], [-_ROOT, _ROOT], [_ROOT, _ROOT]])

# Powers of the two coordinates in the serendipity space: no xi^2 eta^2.
_POWERS = np.array([[0, 0], [1, 0], [0, 1], [2, 0], [1, 1], [0, 2], [2, 1], [1, 2]])

# Elements whose frequency is computed: those with the largest sums of squared frequencies.
_CANDIDATES = 16


def shape_values(at: Floats) -> Floats:
    """Shape functions."""
    return _powers(at[:, :1], 0) * _powers(at[:, 1:], 1) @ _coefficients()


def shape_gradients(at: Floats) -> Floats:
    """Derivatives of the shape functions along the two edges."""
    x, y = at[:, :1], at[:, 1:]
    along = _slopes(x, 0) * _powers(y, 1) @ _coefficients()
    across = _powers(x, 0) * _slopes(y, 1) @ _coefficients()
    return np.ascontiguousarray(np.stack([along.T, across.T]))


def mass_shares() -> Floats:
    """Share of the element's mass at each node (HRZ): the consistent diagonal, scaled to the whole."""
    gauss, weights = np.polynomial.legendre.leggauss(3)
    at = np.array([[x, y] for x in gauss for y in gauss])
    diagonal = np.array([p * q for p in weights for q in weights]) @ shape_values(at) ** 2
    return np.asarray(diagonal / diagonal.sum())


def plane_stress_moduli(poisson: float) -> Floats:
    """Elastic moduli over E in plane stress, for strains 11, 22 and the engineering shear 12; shape (3, 3)."""
    return np.array([[1, poisson, 0], [poisson, 1, 0], [0, 0, (1 - poisson) / 2]]) / (1 - poisson**2)


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
    # Per mass: the area cancels between stiffness and mass.
    stiffness = np.einsum("epai,ab,epbj->eij", strain, plane_stress_moduli(poisson), strain, optimize=True)
    lightness = np.repeat(mass_shares(), 2) ** -0.5
    values = np.linalg.eigvalsh(stiffness / len(POINTS) * np.outer(lightness, lightness))
    return math.sqrt(float(values.max()))


def _powers(x: Floats, axis: int) -> Floats:
    """Powers of one coordinate in the serendipity monomials; shape (points, 8)."""
    return np.asarray(x ** _POWERS[:, axis])


def _slopes(x: Floats, axis: int) -> Floats:
    """Derivatives of :func:`_powers`."""
    powers = _POWERS[:, axis]
    return np.asarray(powers * x ** np.maximum(powers - 1, 0))


@cache
def _coefficients() -> Floats:
    """Coefficients of the monomials, a column for each shape function: 1 at its node, 0 at the others."""
    return np.asarray(np.linalg.inv(_powers(NODES[:, :1], 0) * _powers(NODES[:, 1:], 1)), dtype=np.float64)


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


@dataclass(frozen=True)
class Strip:
    """Nodes and elements of half a filament; lengths over the span, mass over density times span^2 times width."""

    mesh: Mesh
    thickness: float

    @cached_property
    def _lattice(self) -> Indices:
        """Node at each place of the half-element lattice, -1 in the middles of elements."""
        lattice = np.full((2 * self.mesh.along + 1, 2 * self.mesh.through + 1), -1, dtype=np.int32)
        taken = np.ones(lattice.shape, dtype=bool)
        taken[1::2, 1::2] = False
        lattice[taken] = np.arange(taken.sum())
        return lattice

    @cached_property
    def position(self) -> Floats:
        """Reference positions X, Y; shape (nodes, 2)."""
        edges = self.mesh.edges()
        columns = np.empty(2 * len(edges) - 1)
        columns[::2], columns[1::2] = edges, (edges[1:] + edges[:-1]) / 2
        # Symmetric to the last bit, so that the centreline lies at 0 and a face has no net height.
        rows = self.thickness * np.arange(-self.mesh.through, self.mesh.through + 1) / (2 * self.mesh.through)
        grid = np.stack(np.meshgrid(columns, rows, indexing="ij"), axis=-1)
        return np.ascontiguousarray(grid[self._lattice >= 0])

    @cached_property
    def corner(self) -> Indices:
        """Nodes of each element, in the order of ``element.NODES``; shape (along x through, 8), column by column."""
        i, j = (a.ravel() for a in np.mgrid[: self.mesh.along, : self.mesh.through])
        x, y = (NODES.astype(int) + 1).T
        return np.ascontiguousarray(self._lattice[2 * i[:, None] + x, 2 * j[:, None] + y])

    @cached_property
    def size(self) -> Floats:
        """Edge lengths of each element; shape (elements, 2)."""
        lengths = np.repeat(np.diff(self.mesh.edges()), self.mesh.through)
        return np.stack([lengths, np.full_like(lengths, self.thickness / self.mesh.through)], axis=1)

    @cached_property
    def mass(self) -> Floats:
        """Lumped mass; shape (nodes,)."""
        shares = self.size.prod(axis=1)[:, None] * mass_shares()
        return np.asarray(np.bincount(self.corner.ravel(), weights=shares.ravel()), dtype=np.float64)

    @cached_property
    def centreline(self) -> Indices:
        """Nodes at Y = 0, from midspan to the clamp; shape (2 along + 1,)."""
        return np.ascontiguousarray(self._lattice[:, self.mesh.through])

    @cached_property
    def midspan(self) -> Indices:
        """Nodes in the plane of symmetry, upwards; shape (2 through + 1,)."""
        return np.ascontiguousarray(self._lattice[0])

    @cached_property
    def face(self) -> Indices:
        """Nodes of the clamped face, upwards; shape (2 through + 1,)."""
        return np.ascontiguousarray(self._lattice[-1])

    @cached_property
    def points(self) -> Floats:
        """Reference positions of the Gauss points; shape (elements, 4, 2)."""
        return np.asarray(np.einsum("pa,eai->epi", shape_values(POINTS), self.position[self.corner]))


class Clamp(Enum):
    """What a clamped face may still do.

    Holding the centre node alone is not offered: a point load indents without limit as the mesh is refined.
    """

    THINNING = "no axial displacement, centre fixed, section plane, vertical and free to thin: u_y = (lambda - 1) Y"
    FIXED = "every node of the face fixed"


@dataclass(frozen=True)
class Supports:
    """Which displacements are zero, and which face thins as one."""

    held: npt.NDArray[np.bool_]  # shape (nodes, 2); Displacements along x and y that stay zero
    # shape (face nodes,); Nodes that move as u_y = (lambda - 1) Y with a common lambda; empty where no face does.
    face: Indices


def half_span_supports(strip: Strip, clamp: Clamp) -> Supports:
    """Symmetry at midspan (u_x = 0, u_y free), the clamp at X = L/2."""
    held = np.zeros(strip.position.shape, dtype=bool)
    held[strip.midspan, 0] = True
    held[strip.face] = True
    return Supports(held, strip.face if clamp is Clamp.THINNING else strip.face[:0])


class Interrupt:
    """Whether SIGINT has come."""

    def __init__(self) -> None:
        self.pending = False

    def note(self, number: int, frame: FrameType | None) -> None:
        """Handle the signal: remember it; when it comes again, do not wait any longer."""
        del number, frame
        if self.pending:
            raise KeyboardInterrupt
        self.pending = True


@contextmanager
def deferred() -> Iterator[Interrupt]:
    """Put SIGINT off, unless the program handles it in its own way or this is not its main thread."""
    interrupt = Interrupt()
    with interrupts_go_to(interrupt.note):
        yield interrupt


State = Mapping[str, npt.NDArray[np.generic]]

# Raised when the Python side of a run changes what it computes; the C side is hashed.
_VERSION = 1
_KEY = "fingerprint"


def fingerprint(problem: Problem, mesh: Mesh, clamp: Clamp, step_factor: float, sources: Mapping[str, str]) -> str:
    """Hash of all that decides the numbers: dimensionless groups, mesh, clamp, step and code."""
    content = {
        "version": _VERSION,
        "problem": asdict(problem),
        "mesh": asdict(mesh),
        "clamp": clamp.name,
        "step_factor": step_factor,
        "sources": dict(sources),
    }
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def write_checkpoint(path: Path, key: str, state: State) -> None:
    """Write a state whole or not at all."""
    arrays: dict[str, Any] = {_KEY: np.array(key), **state}

    def fill(passing: Path) -> None:
        with passing.open("xb") as stream:
            np.savez(stream, **arrays)

    try:
        fill_atomically(path, fill)
    except OSError as error:
        raise SoftcatError(f"cannot write the checkpoint {path}: {error.strerror or error}") from error


def read_checkpoint(path: Path, key: str) -> dict[str, npt.NDArray[np.generic]] | None:
    """The state in a file, or None where there is no file."""
    if not path.exists():
        return None
    try:
        # Opened here: NumPy leaves the file open where it is no archive.
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            state = {name: archive[name] for name in archive.files}
    except (OSError, ValueError, EOFError, zipfile.BadZipFile) as error:
        raise SoftcatError(f"{path} is no checkpoint of elements ({error}); delete it or name another") from error
    if str(state.pop(_KEY, "")) != key:
        raise SoftcatError(
            f"{path} is the checkpoint of another problem, mesh, step or version of this program; "
            "delete it or name another"
        )
    return state


POINT_STATE = 3
_UNSTRAINED = (1.0, 0.0, 1.0)
_FUNCTIONS = ("softcat_gravity", "softcat_evaluate", "softcat_march")
_ARRAYS = ("displacement", "velocity", "acceleration", "point", "rate")
_SCALARS = ("start", "step", "steps", "taken", "gravity_work", "plastic_work", "elastic_energy")

_DOUBLES, _INTEGERS = ctypes.POINTER(ctypes.c_double), ctypes.POINTER(ctypes.c_int)


class StripStructure(ctypes.Structure):
    """``struct softcat_strip`` of elements.h, field by field."""

    _fields_ = (
        ("elements", ctypes.c_long),
        ("nodes", ctypes.c_long),
        ("corner", _INTEGERS),
        ("size", _DOUBLES),
        ("gradient", _DOUBLES),
        ("mass", _DOUBLES),
        ("mobility", _DOUBLES),
        ("face", ctypes.c_long),
        ("face_node", _INTEGERS),
        ("face_height", _DOUBLES),
        ("face_inertia", ctypes.c_double),
        ("material", _DOUBLES),
        ("gravity", ctypes.c_double),
        ("ramp", ctypes.c_double),
        ("start", ctypes.c_double),
        ("step", ctypes.c_double),
        ("steps", ctypes.c_long),
        ("taken", ctypes.c_long),
        ("displacement", _DOUBLES),
        ("velocity", _DOUBLES),
        ("acceleration", _DOUBLES),
        ("point", _DOUBLES),
        ("gravity_work", ctypes.c_double),
        ("plastic_work", ctypes.c_double),
        ("elastic_energy", ctypes.c_double),
        ("rate", _DOUBLES),
    )


def element_sources(code: PointCode) -> dict[str, str]:
    """C text by file name: the element loop, and the material point that it includes."""
    own = {name: (files(__package__) / "c" / name).read_text(encoding="utf-8") for name in ("elements.c", "elements.h")}
    return {**code.source, **own}


class ElementLoop:
    """A strip in motion. Span, Young's modulus and density are 1; energies are for unit width."""

    def __init__(
        self,
        strip: Strip,
        supports: Supports,
        code: PointCode,
        material: Mapping[str, float],
        *,
        gravity: float = 0.0,
        ramp: float = 0.0,
    ) -> None:
        self._library = load(compile_library(element_sources(code), units=["elements.c"]), *_FUNCTIONS)
        _declare(self._library)
        self.strip = strip
        elements, nodes = len(strip.corner), len(strip.position)
        self.displacement, self.velocity, self.acceleration = (np.zeros((nodes, 2)) for _ in range(3))
        self.point = np.tile(_UNSTRAINED, (elements, len(POINTS), 1))
        self.rate = np.zeros((elements, len(POINTS)))
        height = np.ascontiguousarray(strip.position[supports.face, 1])
        # What C points at is kept alive here.
        self._constant: dict[str, npt.NDArray[np.float64] | npt.NDArray[np.int32]] = {
            "corner": strip.corner,
            "size": strip.size,
            "gradient": shape_gradients(POINTS),
            "mass": strip.mass,
            "mobility": np.where(supports.held, 0.0, 1 / strip.mass[:, None]),
            "face_node": supports.face,
            "face_height": height,
            "material": np.array([material[name] for name in code.parameters]),
        }
        self._structure = StripStructure(
            elements=elements,
            nodes=nodes,
            face=len(height),
            face_inertia=float(strip.mass[supports.face] @ height**2),
            gravity=gravity,
            ramp=ramp,
        )
        for name, array in {**self._constant, **{name: getattr(self, name) for name in _ARRAYS}}.items():
            kind = _INTEGERS if array.dtype == np.int32 else _DOUBLES
            setattr(self._structure, name, array.ctypes.data_as(kind))

    @property
    def taken(self) -> int:
        """Steps taken in this stretch of time."""
        return int(self._structure.taken)

    @property
    def steps(self) -> int:
        """Steps of this stretch of time."""
        return int(self._structure.steps)

    @property
    def step(self) -> float:
        """Length of a step."""
        return float(self._structure.step)

    @property
    def time(self) -> float:
        """Time reached."""
        return float(self._structure.start + self._structure.step * self._structure.taken)

    @property
    def gravity_work(self) -> float:
        """Work done by gravity since the beginning."""
        return float(self._structure.gravity_work)

    @property
    def plastic_work(self) -> float:
        """Work dissipated since the beginning."""
        return float(self._structure.plastic_work)

    @property
    def elastic_energy(self) -> float:
        """Stored energy at the end of the last stretch of time, or when last evaluated."""
        return float(self._structure.elastic_energy)

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
        return float(self._library.softcat_gravity(ctypes.byref(self._structure), time))

    def deformation(self) -> Floats:
        """Deformation gradients at the Gauss points; shape (elements, 4, 2, 2)."""
        slopes = np.einsum("eai,Jap->epiJ", self.displacement[self.strip.corner], shape_gradients(POINTS))
        return np.asarray(np.eye(2) + slopes * (2 / self.strip.size)[:, None, None, :])

    def evaluate(self, step: float, time: float) -> None:
        """Compute accelerations, elastic energy and rates where the strip is, its points flowing for `step`."""
        self._check(self._library.softcat_evaluate(ctypes.byref(self._structure), step, time))

    def begin(self, start: float, step: float, steps: int) -> None:
        """Begin a stretch of time."""
        self._structure.start, self._structure.step = start, step
        self._structure.steps, self._structure.taken = steps, 0

    def march(self, until: int) -> None:
        """Step until so many steps of this stretch are taken; the last one leaves elastic energy and rates."""
        self._check(self._library.softcat_march(ctypes.byref(self._structure), until))

    def state(self) -> dict[str, npt.NDArray[np.float64]]:
        """All that is needed to go on, as copies."""
        arrays = {name: np.array(getattr(self, name)) for name in _ARRAYS}
        return {**arrays, **{name: np.array(getattr(self._structure, name)) for name in _SCALARS}}

    def restore(self, state: Mapping[str, npt.NDArray[np.generic]]) -> None:
        """Go back to a :meth:`state` of the same strip."""
        for name in _ARRAYS:
            getattr(self, name)[...] = state[name]
        for name in _SCALARS:
            setattr(self._structure, name, state[name].item())

    def _check(self, failed: int) -> None:
        if failed == 0:
            return
        column, row = divmod(failed - 1, self.strip.mesh.through)
        mesh = self.strip.mesh
        place = f"element {column + 1} of {mesh.along} from midspan, {row + 1} of {mesh.through} from below"
        raise SoftcatError(
            f"finite elements: {place}, was turned inside out at t = {self.time:.6g} L sqrt(rho/E); "
            "shorten the steps (step_factor below 1), refine the mesh where it stretches most, or end the run earlier"
        )


def _declare(library: ctypes.CDLL) -> None:
    """Say what the functions of elements.h take and return."""
    strip, real, count = ctypes.POINTER(StripStructure), ctypes.c_double, ctypes.c_long
    library.softcat_gravity.argtypes, library.softcat_gravity.restype = (strip, real), real
    library.softcat_evaluate.argtypes, library.softcat_evaluate.restype = (strip, real, real), count
    library.softcat_march.argtypes, library.softcat_march.restype = (strip, count), count
