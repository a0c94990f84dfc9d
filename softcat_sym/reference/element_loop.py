"""The compiled element loop: explicit steps of a strip, whose arrays live here and are advanced in C."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping
from importlib.resources import files

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError
from softcat_sym.native import compile_library, load
from softcat_sym.reference.element import POINTS, Floats, shape_gradients
from softcat_sym.reference.mesh import Strip
from softcat_sym.reference.point_code import PointCode
from softcat_sym.reference.supports import Supports

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
    """A strip in motion. Span, Young's modulus and density are 1; energies are for unit width.

    Parameters
    ----------
    strip : Strip
        The mesh.
    supports : Supports
        How it is held.
    code : PointCode
        C of the law.
    material : mapping of str to float
        Constants by the names of ``code.parameters``, over E and L sqrt(rho/E).
    gravity : float
        rho g L/E.
    ramp : float
        Duration of the quintic step from 0 to gravity; 0: at once.

    Raises
    ------
    SoftcatError
        If the loop cannot be compiled.
    """

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
        """Compute accelerations, elastic energy and rates where the strip is, its points flowing for `step`.

        Raises
        ------
        SoftcatError
            If a material point fails.
        """
        self._check(self._library.softcat_evaluate(ctypes.byref(self._structure), step, time))

    def begin(self, start: float, step: float, steps: int) -> None:
        """Begin a stretch of time."""
        self._structure.start, self._structure.step = start, step
        self._structure.steps, self._structure.taken = steps, 0

    def march(self, until: int) -> None:
        """Step until so many steps of this stretch are taken; the last one leaves elastic energy and rates.

        Raises
        ------
        SoftcatError
            If a material point fails.
        """
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
