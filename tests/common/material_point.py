"""A material point of the elements, stepped under a prescribed deformation."""

from __future__ import annotations

import ctypes
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.library import compile_library, load
from softcat_sym.errors import SoftcatError
from softcat_sym.reference.material_point import point_code

Floats = npt.NDArray[np.float64]

_FAULTS = {
    1: "the deformation gradient has no positive determinant, or it is not finite",
    2: "the scalar equation of the step was not solved: take a shorter step",
}


class MaterialPoint:
    """A point of the law (3.1)-(3.8) in plane stress, from rest."""

    def __init__(self, law: str, parameters: Mapping[str, float]) -> None:
        code = point_code(law)
        if set(parameters) != set(code.parameters):
            raise SoftcatError(f"a point of this law takes {', '.join(code.parameters)}; got {', '.join(parameters)}")
        library = load(compile_library(code.source), "softcat_point")
        self._advance = library.softcat_point
        doubles = np.ctypeslib.ndpointer(dtype=np.float64, flags="C_CONTIGUOUS")
        self._advance.argtypes = [doubles, doubles, ctypes.c_double, doubles, doubles, doubles]
        self._advance.restype = ctypes.c_int
        self._material = np.array([parameters[name] for name in code.parameters], dtype=float)
        self._record = np.array([0.0, 0.0, 0.0, 1.0])
        self.deformation: Floats = np.eye(2)
        self.state: Floats = np.array([1.0, 0.0, 1.0])
        self.stress: Floats = np.zeros((2, 2))
        self.work = 0.0

    @property
    def energy(self) -> float:
        """Stored elastic energy per reference volume."""
        return float(self._record[0])

    @property
    def rate(self) -> float:
        """Equivalent (tensile) plastic rate."""
        return float(self._record[2])

    @property
    def width_stretch(self) -> float:
        """F_33."""
        return float(self._record[3])

    @property
    def kirchhoff(self) -> Floats:
        """Kirchhoff stress tau = P F^T in the plane, shape (2, 2)."""
        return np.asarray(self.stress @ self.deformation.T)

    @property
    def cauchy(self) -> Floats:
        """Cauchy stress tau/J in the plane, shape (2, 2)."""
        return self.kirchhoff / (float(np.linalg.det(self.deformation)) * self.width_stretch)

    def step(self, deformation: npt.ArrayLike, duration: float) -> None:
        """Advance to a deformation gradient."""
        target = np.ascontiguousarray(deformation, dtype=float)
        if target.shape != (2, 2):
            raise SoftcatError(f"a deformation gradient in the plane is 2 x 2, not of shape {target.shape}")
        if not 0 <= duration < np.inf:
            raise SoftcatError(f"a step takes a finite time >= 0, not {duration}")
        state, stress, record = self.state.copy(), np.empty((2, 2)), np.empty(4)
        fault = int(self._advance(target, state, duration, self._material, stress, record))
        if fault:
            raise SoftcatError(f"material point at F = {target.tolist()}: {_FAULTS[fault]}")
        self.deformation, self.state, self.stress = target.copy(), state, stress
        self._record = record
        self.work += float(record[1])
