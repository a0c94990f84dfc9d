"""Multi-mode Maxwell fluid: Maxwell fluids in parallel, for a spectrum of relaxation times.

Source: Wiechert (1893); Bird, Armstrong & Hassager, Dynamics of Polymeric Liquids, volume 1 (1987), section 5.2.
"""

from __future__ import annotations

import sympy as sp

from softcat_sym.equations.law import Branch, Constant, Law
from softcat_sym.equations.laws.maxwell import linear_flow
from softcat_sym.equations.symbols import STRESS, VISCOSITY, enter

_SOURCE = "Wiechert 1893"


def mode(number: int) -> tuple[sp.Symbol, sp.Symbol]:
    """Modulus and tensile viscosity of one mode; the first is number 1."""
    return (
        enter(f"E_m{number}", f"E_{{m{number}}}", STRESS, f"modulus of mode {number}", _SOURCE, positive=True),
        enter(
            f"eta_m{number}", rf"\eta_{{m{number}}}", VISCOSITY, f"viscosity of mode {number}", _SOURCE, positive=True
        ),
    )


def multimode_maxwell(modes: int) -> Law:
    """The law of so many modes, whose constants are ``mode_1_youngs_modulus``, ``mode_1_viscosity`` and so on.

    Raises
    ------
    ValueError
        If there is no mode.
    """
    if modes < 1:
        raise ValueError(f"a multi-mode fluid has one mode or more, not {modes}")
    branches, constants = [], []
    for number in range(1, modes + 1):
        modulus, viscosity = mode(number)
        branches.append(Branch(modulus, flow=linear_flow(viscosity)))
        constants.append(Constant(f"mode_{number}_youngs_modulus", modulus))
        constants.append(Constant(f"mode_{number}_viscosity", viscosity))
    return Law("multimode-maxwell", branches=tuple(branches), constants=tuple(constants))
