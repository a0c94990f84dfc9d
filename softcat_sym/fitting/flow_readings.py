"""A flow curve beside films: what it reads is compared with the same law in steady shear."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.flow_curve import FlowCurve, scatter
from softcat_sym.fitting.free_parameters import FreeParameter, with_values
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.scene.history import is_history
from softcat_sym.scene.material import INDEXED, Material
from softcat_sym.scene.scene import Scene

SHEARED = {
    "newtonian": "newtonian",
    "maxwell": "newtonian",
    "multimode-maxwell": "newtonian",
    "bingham": "bingham",
    "power-law": "power-law",
    "herschel-bulkley": "herschel-bulkley",
}
"""Laws that have a flow curve, and which law of steady shear it is."""

_STEP = 1e-5
_LEAST_SCATTER = 0.005  # No rheometer is better
_SMALL = 0.1  # Relative error of the law from which on a reader is told


def steady_shear_stress(material: Material, shear_rate: Floats) -> Floats:
    """Shear stress of steady flow, from the constants in tension.

    Parameters
    ----------
    material : Material
        Of a law that has a flow curve.
    shear_rate : ndarray
        [1/s].

    Returns
    -------
    ndarray
        sigma_Y/sqrt(3) + K/3^((n+1)/2) g^n [Pa], by von Mises' equivalence; with n = 1 Trouton's K/3.

    Raises
    ------
    SceneError
        If the law has none, or one that changes while it flows.
    """
    if material.law not in SHEARED:
        raise SceneError([Fault("flow curve", f"the law '{material.law}' has none that is known", ", ".join(SHEARED))])
    plain = material.yield_stress, material.viscosity, material.index, *(mode.viscosity for mode in material.modes)
    if any(is_history(one) for one in plain) or material.structure is not None or material.hardening_modulus:
        found = "the material hardens, ages or has a structure: its stress in steady flow is not one curve"
        raise SceneError([Fault("flow curve", found, "a law with constants, or the film alone")])
    if material.law == "multimode-maxwell":
        return np.asarray(sum(mode.viscosity for mode in material.modes) / 3 * shear_rate)
    index = material.index if material.law in INDEXED else 1.0
    stress = (material.viscosity or 0.0) / 3 ** ((index + 1) / 2) * shear_rate**index
    return np.asarray(stress + (material.yield_stress or 0.0) / math.sqrt(3))


@dataclass(frozen=True, eq=False)
class FlowReadings:
    """A flow curve, and which unknowns of a problem its law has."""

    curve: FlowCurve
    scene: Scene
    free: tuple[FreeParameter, ...]
    columns: tuple[int, ...]  # For each of them its number in the problem
    std: Floats  # shape (n,); Standard errors of the stresses [Pa]
    known: bool  # Whether they are stated

    @classmethod
    def of(cls, curve: FlowCurve, scene: Scene, free: Sequence[FreeParameter], columns: Sequence[int]) -> FlowReadings:
        """With the errors that are stated, or the relative scatter about the best of the same law."""
        steady_shear_stress(scene.material, curve.shear_rate)
        if curve.std is not None:
            return cls(curve, scene, tuple(free), tuple(columns), curve.std, known=True)
        relative = max(scatter(curve, SHEARED[scene.material.law]), _LEAST_SCATTER)
        return cls(curve, scene, tuple(free), tuple(columns), relative * curve.shear_stress, known=False)

    def stress(self, q: Floats) -> Floats:
        """What the law says at the rates of the curve [Pa], of the unknowns of the whole problem."""
        values = [one.value(float(q[k])) for one, k in zip(self.free, self.columns, strict=True)]
        return steady_shear_stress(with_values(self.scene, self.free, values).material, self.curve.shear_rate)

    def residuals(self, q: Floats) -> Floats:
        """(law - datum)/standard error, shape (n,)."""
        return (self.stress(q) - self.curve.shear_stress) / self.std

    def slopes(self, q: Floats) -> Floats:
        """Their derivatives, shape (n, k)."""
        found = np.zeros((self.std.size, q.size))
        for k in self.columns:
            step = _STEP * np.eye(q.size)[k]
            found[:, k] = (self.stress(q + step) - self.stress(q - step)) / (2 * _STEP * self.std)
        return found

    @property
    def warnings(self) -> tuple[str, ...]:
        """What a reader must know about the curve itself."""
        law = SHEARED[self.scene.material.law]
        missed = scatter(self.curve, law)
        said = f"{law} misses the flow curve by {missed:.2g} of its stress even alone: its part is weighted by that"
        return (*self.curve.warnings, *((said,) if missed > _SMALL else ()))
