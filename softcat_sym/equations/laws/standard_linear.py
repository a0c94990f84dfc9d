"""Standard linear solid: a spring E beside an arm of a second spring in line with a dashpot (Zener 1948).

E acts always and is the modulus at rest; at once the solid answers with E + E_2. As E_2 grows it becomes that of
Kelvin and Voigt.
"""

from __future__ import annotations

from softcat_sym.equations.law import Branch, Constant, Law
from softcat_sym.equations.laws.maxwell import linear_flow
from softcat_sym.equations.symbols import STRESS, enter, eta

E_2 = enter("E_2", "E_2", STRESS, "modulus of the spring in line with the dashpot", "Zener 1948", positive=True)

LAW = Law(
    "standard-linear",
    branches=(Branch(), Branch(E_2, flow=linear_flow(eta))),
    constants=(Constant("second_modulus", E_2),),
)
