"""A flow curve beside films: its readings are compared with the same law in steady shear."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from softcat_sym.errors import Fault, SceneError
from softcat_sym.fitting.flow_curve import FlowCurve, scatter, shear_stress
from softcat_sym.fitting.free_parameters import FreeParameter, with_values
from softcat_sym.fitting.least_squares import Floats
from softcat_sym.scene.history import is_history
from softcat_sym.scene.laws import LAWS
from softcat_sym.scene.material import Material
from softcat_sym.scene.scene import Scene

_STEP = 1e-5
_MIN_SCATTER = 0.005  # Relative scatter of the best rheometers
_MAX_SCATTER = 0.1  # Relative scatter about the best fit above which a warning is given


def steady_shear_stress(material: Material, shear_rate: Floats) -> Floats:
    """Shear stress of steady flow [Pa] at shear rates [1/s], from the constants in tension, by von Mises' equivalence.

    ((sigma_Y/sqrt(3))^p + (K/3^((n+1)/2) g^n)^p)^(1/p); with p = n = 1 Trouton's K/3. Laws without a flow curve, and
    those whose stress changes during the flow, are refused.
    """
    spec = material.spec
    if not spec.flow_curve:
        accepted = ", ".join(one.name for one in LAWS.values() if one.flow_curve)
        raise SceneError([Fault("flow curve", f"the law '{material.law}' has none", accepted)])
    plain = material.yield_stress, material.viscosity, material.index, *(mode.viscosity for mode in material.modes)
    if any(is_history(one) for one in plain) or material.structure is not None or material.hardening_modulus:
        found = "the material hardens, ages or has a structure: its stress in steady flow is not one curve"
        raise SceneError([Fault("flow curve", found, "a law with constants, or the film alone")])
    viscosity = sum(mode.viscosity for mode in material.modes) or material.viscosity or 0.0
    consistency = viscosity / 3 ** ((material.index + 1) / 2)
    limit = (material.yield_stress or 0.0) / math.sqrt(3)
    return shear_stress(spec, limit, consistency, material.index, shear_rate)


@dataclass(frozen=True, eq=False)
class FlowReadings:
    """A flow curve, and the unknowns of a problem on which its law depends."""

    curve: FlowCurve
    scene: Scene
    free: tuple[FreeParameter, ...]
    columns: tuple[int, ...]  # Number of each in the problem
    std: Floats  # shape (n,); Standard errors of the stresses [Pa]
    known: bool  # Whether the standard errors are stated

    @classmethod
    def of(cls, curve: FlowCurve, scene: Scene, free: Sequence[FreeParameter], columns: Sequence[int]) -> FlowReadings:
        """Take the stated errors, or else the relative scatter about the best fit of the same law."""
        steady_shear_stress(scene.material, curve.shear_rate)
        if curve.std is not None:
            return cls(curve, scene, tuple(free), tuple(columns), curve.std, known=True)
        relative = max(scatter(curve, scene.material.spec.flow_curve), _MIN_SCATTER)
        return cls(curve, scene, tuple(free), tuple(columns), relative * curve.shear_stress, known=False)

    def stress(self, q: Floats) -> Floats:
        """Stress of the law at the rates of the curve [Pa], for the unknowns of the whole problem."""
        values = [one.value(float(q[k])) for one, k in zip(self.free, self.columns, strict=True)]
        return steady_shear_stress(with_values(self.scene, self.free, values).material, self.curve.shear_rate)

    def residuals(self, q: Floats) -> Floats:
        """(law - datum)/standard error, shape (n,)."""
        return (self.stress(q) - self.curve.shear_stress) / self.std

    def slopes(self, q: Floats) -> Floats:
        """Derivatives of the residuals by the unknowns, shape (n, k)."""
        found = np.zeros((self.std.size, q.size))
        for k in self.columns:
            step = _STEP * np.eye(q.size)[k]
            found[:, k] = (self.stress(q + step) - self.stress(q - step)) / (2 * _STEP * self.std)
        return found

    @property
    def warnings(self) -> tuple[str, ...]:
        """Warnings about the curve itself."""
        law = self.scene.material.spec.flow_curve
        missed = scatter(self.curve, law)
        said = (
            f"even without films the best {law} law misses the flow curve by {missed:.2g} of its stress: this is taken "
            "as the relative error of the curve"
        )
        return (*self.curve.warnings, *((said,) if missed > _MAX_SCATTER else ()))
