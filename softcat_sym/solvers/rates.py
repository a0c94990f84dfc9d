"""Rates of a filament and their sparse Jacobian as Python functions, for integrators of others."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.sparse import csc_matrix

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import Fault, SceneError
from softcat_sym.solvers.compiled import CompiledFilament, Evaluation
from softcat_sym.solvers.solution import Start

_STIFF = 1e9
"""Relaxation rate of algebraic unknowns towards the solution of their equation, in units of the time scale; for large
rates a stiffly accurate method solves that equation itself (Hairer & Wanner 1996, VI.1)."""


class Rates:
    """Rates of all unknowns, differential ones first, and their Jacobian, from the C of the filament."""

    def __init__(self, filament: CompiledFilament, start: Start, p: Floats) -> None:
        self.start, sites = np.concatenate([start.x, start.z]), filament.sites
        given = np.ascontiguousarray(p), filament.places
        self._rates, self._entries = (filament.model.evaluation(name, *given) for name in ("rates", "jacobian"))
        self._sites, self._unknown = np.zeros(sites.shape), np.append(sites.x, sites.z)
        self._flat = self._sites.ravel()  # The same memory
        # Entries of the C by site belong to pairs of unknowns; several may belong to one.
        count, number = len(self._unknown), np.full(sites.shape[0] * sites.shape[1], -1)
        number[self._unknown] = np.arange(count)
        row, column, there = filament.model.places_of_entries(sites.shape[0])
        row, column = number[np.where(there, row, 0)], number[np.where(there, column, 0)]
        self._used = there & (row >= 0) & (column >= 0)
        pairs, self._pair = np.unique(column[self._used] * count + row[self._used], return_inverse=True)
        self._rows = pairs % count
        self._begins = np.searchsorted(pairs // count, np.arange(count + 1))
        self._weight = np.ones(count)
        if len(start.z):
            own = self.jacobian(0.0, self.start).diagonal()[len(start.x) :]
            if np.any(own == 0):
                fault = Fault("run.effects", "algebraic unknowns without an equation of their own", "others")
                raise SceneError([fault])
            self._weight[len(start.x) :] = -_STIFF / own

    def rates(self, t: float, state: Floats) -> Floats:
        """Rates at a time and a state."""
        return self._weight * self._at(self._rates, t, state).ravel()[self._unknown]

    def jacobian(self, t: float, state: Floats) -> Any:
        """The Jacobian as a ``scipy.sparse.csc_matrix``."""
        entries = self._at(self._entries, t, state)[self._used]
        values = np.bincount(self._pair, entries, len(self._rows)) * self._weight[self._rows]
        return csc_matrix((values, self._rows, self._begins), shape=2 * (len(self._unknown),))

    def _at(self, evaluation: Evaluation, t: float, state: Floats) -> Floats:
        evaluate, result = evaluation
        self._flat[self._unknown] = state
        evaluate(t, self._sites)
        return result
