"""Kelvin-Voigt solid: a spring beside a dashpot, sigma = E eps + eta eps_t (Voigt 1892)."""

from __future__ import annotations

from softcat_sym.equations.law import Branch, Law
from softcat_sym.equations.symbols import eta

LAW = Law("kelvin-voigt", branches=(Branch(),), viscosity=eta)
