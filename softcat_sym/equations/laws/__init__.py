"""The constitutive laws, one a file, by the names that a scene gives them."""

from __future__ import annotations

from softcat_sym.equations.law import Law
from softcat_sym.equations.laws import (
    bingham,
    elastic,
    herschel_bulkley,
    kelvin_voigt,
    maxwell,
    newtonian,
    power_law,
    standard_linear,
)
from softcat_sym.equations.laws.custom import Formula, custom_law
from softcat_sym.equations.laws.multimode_maxwell import multimode_maxwell

__all__ = ["FIXED", "Formula", "law_of"]

FIXED: dict[str, Law] = {
    law.name: law
    for law in (
        elastic.LAW,
        maxwell.LAW,
        newtonian.LAW,
        kelvin_voigt.LAW,
        standard_linear.LAW,
        bingham.LAW,
        power_law.LAW,
        herschel_bulkley.LAW,
    )
}


def law_of(name: str, *, modes: int = 0, formula: Formula | None = None, yields: bool = False) -> Law:
    """A law by its name.

    Parameters
    ----------
    name : str
        As in the scene.
    modes : int
        How many, for ``multimode-maxwell``.
    formula : Formula or None
        The flow rule of ``custom``.
    yields : bool
        Whether the rule of ``custom`` is zero up to the yield stress.

    Raises
    ------
    ValueError
        If there is no such law, or it lacks its modes or its formula.
    """
    if name == "multimode-maxwell":
        return multimode_maxwell(modes)
    if name == "custom":
        if formula is None:
            raise ValueError("a custom law is made of a formula")
        return custom_law(formula, yields=yields)
    if name not in FIXED:
        raise ValueError(f"no law {name}: there are custom, multimode-maxwell, {', '.join(FIXED)}")
    return FIXED[name]
