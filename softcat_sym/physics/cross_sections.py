"""Cross-sections as numbers; what is rational is a fraction, exact in expressions too."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

PLANE_STRAIN = math.sqrt(3) / 2
"""Equivalent stress over axial stress in a section too wide to change its width."""

_ODD_TERMS = 120


@dataclass(frozen=True, slots=True)
class CrossSection:
    """Numbers of one shape of section."""

    name: str  # As in the scene
    zeta_squared: Fraction  # <zeta^2>; the second moment of area is I = A (h/2)^2 <zeta^2>
    mean_lever: float  # <|zeta|>: the fully plastic moment is sigma_Y A (h_0/2) of it
    shear_correction: Fraction  # kappa_s, from the energy of a parabolic shear stress
    area_power: int = 1  # The area goes with this power of a relative thickness that varies along the filament
    plane_strain: bool = False  # Whether it is too wide to change its width

    @property
    def gyration(self) -> float:
        """K = I/(A h_0^2) = <zeta^2>/4 (before 2.18)."""
        return float(self.zeta_squared / 4)

    def stiffness(self, modulus: float, poisson: float) -> float:
        """E, or E/(1 - nu^2) where the width is held."""
        return modulus / (1 - poisson**2) if self.plane_strain else modulus

    def pull(self, thickness: float, width: float) -> float:
        """Axial force of a unit of surface tension over the area, P/(2 A); of a sheet, whose width stays, 2/h_0."""
        return 1 / thickness + 1 / width if self.name == "rectangle" else 2 / thickness

    def torsion(self, aspect: float) -> float:
        """J/(A h_0^2) at a width over thickness (Saint-Venant)."""
        if self.name == "circle":
            return 1 / 8
        terms = (math.tanh(n * math.pi / 2 * aspect) / n**5 for n in range(1, _ODD_TERMS, 2))
        return (1 - 192 / math.pi**5 / aspect * sum(terms)) / 3

    def neck(self, aspect: Any) -> Any:
        """Beta of the gradient term beta h_0^2 T/s^4, at a width over thickness, a number or a symbol."""
        return (1 + aspect**2) / 48 if self.name == "rectangle" else Fraction(1, 32 if self.name == "circle" else 12)


CROSS_SECTIONS: dict[str, CrossSection] = {
    one.name: one
    for one in (
        CrossSection("rectangle", Fraction(1, 3), 1 / 2, Fraction(5, 6)),
        CrossSection("circle", Fraction(1, 4), 4 / (3 * math.pi), Fraction(9, 10), area_power=2),
        CrossSection("sheet", Fraction(1, 3), 1 / 2, Fraction(5, 6), plane_strain=True),
    )
}
