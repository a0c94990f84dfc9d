"""The laws by name, and what each is made of."""

from __future__ import annotations

from typing import Literal

from softcat_sym.scene.kinds import Quantity, refusal
from softcat_sym.scene.shear_data import INDEXED
from softcat_sym.scene.units import consistency_unit

Law = Literal[
    "elastic",
    "maxwell",
    "newtonian",
    "kelvin-voigt",
    "standard-linear",
    "multimode-maxwell",
    "bingham",
    "power-law",
    "herschel-bulkley",
    "custom",
]

# A constant that a law does not use is refused, never ignored. The index, modes and formulas stand apart.
CONSTANTS: dict[str, tuple[str, ...]] = {
    "elastic": ("youngs_modulus",),
    "maxwell": ("youngs_modulus", "viscosity"),
    "newtonian": ("viscosity",),
    "kelvin-voigt": ("youngs_modulus", "viscosity"),
    "standard-linear": ("youngs_modulus", "second_modulus", "viscosity"),
    "multimode-maxwell": (),
    "bingham": ("youngs_modulus", "viscosity", "yield_stress"),
    "power-law": ("youngs_modulus", "viscosity"),
    "herschel-bulkley": ("youngs_modulus", "viscosity", "yield_stress"),
    "custom": ("youngs_modulus",),
}
# The laws that a scene may give by its dimensionless groups.
GROUPED = ("elastic", "maxwell", "newtonian", "kelvin-voigt", "bingham", "power-law", "herschel-bulkley")
# Laws of a solid that remembers its shape: what they leave behind is no plastic strain.
SOLIDS = ("elastic", "kelvin-voigt", "standard-linear")
# Laws that consist of more than their constants.
_LISTS = {"modes": "multimode-maxwell", "flow": "custom", "parameters": "custom"}
_NEEDED = ("modes", "flow")

OF_THE_INDEX = ("viscosity", "shear_viscosity", "shear_consistency", "consistency")
"""Keys whose unit may depend on the law and its index."""

_STRESS = Quantity("stress", "9.32 kPa")


def kind_of_constant(name: str, law: str | None, index: float) -> Quantity:
    """Return how a constant is read and written: a consistency has a unit of its own."""
    if name not in OF_THE_INDEX:
        return _STRESS
    if name in ("shear_consistency", "consistency") or (name == "viscosity" and law in INDEXED):
        unit = consistency_unit(index)
        return Quantity("consistency", f"120 {unit}", unit=unit)
    return Quantity("viscosity", "13.84 kPa*s")


def check_loss(law: str | None) -> None:
    """Refuse a loss below yield of a law that has no spring, or whose only stress beside it is a viscous one already.

    Raises
    ------
    PydanticCustomError
        A `refusal`.
    """
    why = {"newtonian": "has no spring that could ring", "kelvin-voigt": "has this viscosity as material.viscosity"}
    if law in why:
        others = ", ".join(other for other in CONSTANTS if other not in why)
        raise refusal(f"given, but the law '{law}' {why[law]}", f"leaving it out, or one of the laws {others}")


def check_against_law(name: str, law: str | None, value: object, accepted: str) -> None:
    """Refuse a constant or list that the law needs and has not, or has and does not use.

    Parameters
    ----------
    name : str
        Key of the table ``[material]``.
    law : str or None
        None if it was faulty itself.
    value : object
        None or empty if not given.
    accepted : str
        What the key accepts.

    Raises
    ------
    PydanticCustomError
        A `refusal`.
    """
    if law is None:
        return
    needed = _LISTS[name] == law and name in _NEEDED if name in _LISTS else name in CONSTANTS[law]
    used = _LISTS[name] == law if name in _LISTS else needed
    missing = value is None or value in ((), "")
    if missing and needed:
        raise refusal(f"missing: the law '{law}' needs it", accepted)
    if not missing and not used:
        laws = _LISTS.get(name) or ", ".join(other for other, constants in CONSTANTS.items() if name in constants)
        verb = {"yield_stress": "yield", "viscosity": "flow"}.get(name, "use it")
        raise refusal(f"given, but the law '{law}' does not {verb}", f"leaving it out, or one of the laws {laws}")
