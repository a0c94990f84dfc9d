"""Other names of one quantity: shear data (THEORY 3), what a rheometer prints, and which of them exclude each other."""

from __future__ import annotations

import math
from dataclasses import dataclass

# Laws whose viscosity is a consistency, and which have an index.
INDEXED = ("power-law", "herschel-bulkley")


@dataclass(frozen=True, slots=True)
class Conversion:
    """One tensile constant from one shear datum.

    Attributes
    ----------
    constant, shear : str
        Names of the keys.
    indexed : bool or None
        Whether the law must have an index; None if that does not matter.
    words : str
        The rule.
    """

    constant: str
    shear: str
    indexed: bool | None
    words: str

    def suits(self, law: str | None) -> bool:
        """Tell whether a law takes this datum."""
        return self.indexed is None or self.indexed == (law in INDEXED)

    def factor(self, index: float, poisson: float) -> float:
        """Return the tensile value over the shear one; infinite where it overflows."""
        if self.constant == "youngs_modulus":
            return 2 * (1 + poisson)
        if self.constant == "yield_stress":
            return math.sqrt(3.0)
        if not self.indexed:
            return 3.0
        return power(3.0, (index + 1) / 2)


def power(base: float, exponent: float) -> float:
    """Raise a positive number to a power; infinite where it overflows."""
    try:
        return math.pow(base, exponent)
    except OverflowError:
        return math.inf


FROM_SHEAR = (
    Conversion("viscosity", "shear_viscosity", False, "3 x shear_viscosity (Trouton)"),
    Conversion("viscosity", "shear_consistency", True, "3^((n+1)/2) x shear_consistency (von Mises)"),
    Conversion("viscosity", "consistency", True, "3^((n+1)/2) x consistency, the one in shear (von Mises)"),
    Conversion("yield_stress", "shear_yield_stress", None, "sqrt(3) x shear_yield_stress (von Mises)"),
    Conversion("youngs_modulus", "storage_modulus", None, "2 (1 + poisson) x storage_modulus (isotropic)"),
)

_SAME = (
    *(
        {constant, *(one.shear for one in FROM_SHEAR if one.constant == constant)}
        for constant in ("youngs_modulus", "viscosity", "yield_stress")
    ),
    {"loss_tangent", "loss_modulus", "solid_viscosity"},
)
"""Keys of [material] of which a scene has one at most."""


def shear_names(constant: str) -> tuple[str, ...]:
    """Name the shear data that a tensile constant may come from."""
    return tuple(conversion.shear for conversion in FROM_SHEAR if conversion.constant == constant)


def physical_path(path: str) -> str:
    """Name the key that a value given in another way stands for: ``filament.thickness`` for the diameter."""
    table, _, key = path.partition(".")
    if path == "filament.diameter":
        return "filament.thickness"
    return f"material.{tensile_name(key) or key}" if table == "material" else path


def twins(path: str) -> tuple[str, ...]:
    """Name the other keys that say the same as this one, by their dotted paths."""
    table, _, key = path.partition(".")
    if table == "filament":
        return tuple(
            f"filament.{other}"
            for other in ("thickness", "diameter")
            if key in ("thickness", "diameter") and other != key
        )
    groups = [same for same in _SAME if key in same] if table == "material" else []
    return tuple(f"material.{other}" for same in groups for other in sorted(same - {key}))


def tensile_name(shear: str) -> str:
    """Name the tensile constant that a shear datum gives; empty if it is none."""
    return next((conversion.constant for conversion in FROM_SHEAR if conversion.shear == shear), "")
