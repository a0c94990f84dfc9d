"""One shear law fitted to a flow curve, and what it is in tension and in a scene."""

from __future__ import annotations

import math
from dataclasses import dataclass

from softcat_sym.inverse.estimation.confidence import Estimate
from softcat_sym.inverse.flow_curve.curve import Floats


@dataclass(frozen=True)
class ShearLaw:
    """tau = tau_Y + k g^n with some of its constants left out: without n, n = 1; without tau_Y, tau_Y = 0."""

    name: str
    has_yield: bool
    has_index: bool

    @property
    def constants(self) -> int:
        """How many constants are fitted."""
        return 1 + self.has_yield + self.has_index


LAWS = (ShearLaw("bingham", True, False), ShearLaw("power-law", False, True), ShearLaw("herschel-bulkley", True, True))


@dataclass(frozen=True)
class Tensile:
    """The same law in tension, by von Mises' equivalence; SI.

    Attributes
    ----------
    yield_stress : float or None
        sqrt(3) tau_Y [Pa].
    viscosity : float
        3^((n+1)/2) k [Pa s^n]; with n = 1 Trouton's 3 k.
    index : float or None
        n.
    """

    yield_stress: float | None
    viscosity: float
    index: float | None


@dataclass(frozen=True, eq=False)
class Candidate:
    """One law, fitted.

    Attributes
    ----------
    law : str
        ``"bingham"``, ``"power-law"`` or ``"herschel-bulkley"``, as in a scene.
    tau_Y, k, n : Estimate or None
        Shear yield stress [Pa], consistency [Pa s^n], flow index; None where the law has none.
    relative_rms : float
        Root mean square of the relative residuals.
    aic, aicc : float
        Akaike's criterion, and corrected for few points; the latter is infinite with too few points for it.
    fitted : ndarray, shape (points,)
        Stress of the law [Pa].
    residuals : ndarray, shape (points,)
        (fitted - measured)/measured.
    """

    law: str
    tau_Y: Estimate | None
    k: Estimate
    n: Estimate | None
    relative_rms: float
    aic: float
    aicc: float
    fitted: Floats
    residuals: Floats

    def stress(self, shear_rate: Floats) -> Floats:
        """Shear stress [Pa] at shear rates [1/s], any shape."""
        return (self.tau_Y.value if self.tau_Y else 0.0) + self.k.value * shear_rate**self._index

    @property
    def tensile(self) -> Tensile:
        """The constants in tension."""
        return Tensile(
            yield_stress=math.sqrt(3) * self.tau_Y.value if self.tau_Y else None,
            viscosity=3 ** ((self._index + 1) / 2) * self.k.value,
            index=self.n.value if self.n else None,
        )

    @property
    def unfit(self) -> str | None:
        """Why no scene can take this law, if it cannot."""
        if self.k.value <= 0:
            return "its stress does not rise with the shear rate: it has no viscosity"
        if self.tau_Y is not None and self.tau_Y.value <= 0:
            return "its yield stress is zero: take power-law"
        return None

    @property
    def overrides(self) -> dict[str, str | float]:
        """Scene keys with their units, the shear data as fitted; empty for a law that is `unfit`."""
        if self.unfit:
            return {}
        keys: dict[str, str | float] = {"material.law": self.law}
        if self.tau_Y is not None:
            keys["material.shear_yield_stress"] = f"{_written(self.tau_Y.value)} Pa"
        if self.n is None:
            return keys | {"material.shear_viscosity": f"{_written(self.k.value)} Pa*s"}
        return keys | {
            "material.shear_consistency": f"{_written(self.k.value)} Pa*s^{_written(self.n.value)}",
            "material.index": float(_written(self.n.value)),
        }

    @property
    def _index(self) -> float:
        return self.n.value if self.n else 1.0


def _written(value: float) -> str:
    """Ten digits: more than any fit can know, and 0.43 instead of 0.42999999999998406."""
    return f"{value:.10g}"
