"""What the functions of a generated C model say of one state, called as the runtime calls them."""

from __future__ import annotations

import ctypes as c
from dataclasses import dataclass

import numpy as np

from softcat_sym.codegen.library import OPTIMISED, compile_library, load
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.solvers.compiled import SOLVED, FilamentStruct, doubles
from tests.common.rosenbrock import RUNTIME, Model

STRICT = ("-Wall", "-Wextra", "-Werror", "-pedantic")
_Doubles = c.POINTER(c.c_double)
_Function = c.CFUNCTYPE(c.c_int, c.POINTER(FilamentStruct), c.c_double, _Doubles, _Doubles, _Doubles)
_BEYOND = 64
"""Doubles behind each array, so that a stray index is found."""


@dataclass(frozen=True)
class Values:
    """Rates, their Jacobian, powers and their slopes."""

    rates: Floats
    jacobian: Floats
    powers: Floats
    slopes: Floats


class CModel:
    """The text of a model as machine code; any warning of the compiler is an error."""

    def __init__(self, text: str) -> None:
        texts = {"filament.c": text, "softcat_model.h": (RUNTIME / "softcat_model.h").read_text()}
        self._library = load(compile_library(texts, flags=(*OPTIMISED, *STRICT)))
        self.table = Model.in_dll(self._library, "softcat_filament_model")

    def at(self, t: float, state: Floats, parameters: Floats, places: Floats) -> Values:
        """Every function at a state (sites, slots), of all unknowns, site by site."""
        of, sites = self.table, len(state)
        p, g, y = (np.ascontiguousarray(array, dtype=float) for array in (parameters, places, state))
        filament = FilamentStruct(sites, doubles(p), doubles(g))
        scratch = np.full(sites * of.scratch + _BEYOND, np.nan)

        def call(name: str, size: int) -> Floats:
            out = np.full(size + _BEYOND, np.nan)
            code = _Function(getattr(of, name))(c.byref(filament), t, doubles(y), doubles(out), doubles(scratch))
            assert code == SOLVED
            assert np.all(np.isnan(out[size:])), f"{name} writes beyond its array"
            assert np.all(np.isnan(scratch[-_BEYOND:])), f"{name} writes beyond its scratch"
            return out[:size]

        # In the order in which the runtime calls: each finds what the one before has left in the scratch.
        rates = call("rates", y.size)
        powers = call("work", of.powers) if of.powers else np.zeros(3)
        jacobian = self._dense(call("jacobian", sites * of.entries).reshape(sites, -1), sites)
        slopes = call("work_slope", of.powers * y.size) if of.powers else np.zeros(3 * y.size)
        return Values(rates, jacobian, powers, slopes.reshape(len(powers), -1))

    def _dense(self, entries: Floats, sites: int) -> Floats:
        of = self.table
        full = np.zeros((sites * of.slots, sites * of.slots))
        for k in range(of.entries):
            for site in range(max(0, -of.offset[k]), min(sites, sites - of.offset[k])):
                full[site * of.slots + of.row[k], (site + of.offset[k]) * of.slots + of.column[k]] += entries[site, k]
        return full
