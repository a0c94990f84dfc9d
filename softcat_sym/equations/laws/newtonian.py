"""Newtonian fluid: sigma = eta eps_t, with no spring at all; what a Maxwell fluid becomes as E grows."""

from __future__ import annotations

from softcat_sym.equations.law import Law
from softcat_sym.equations.symbols import eta

LAW = Law("newtonian", branches=(), viscosity=eta)
