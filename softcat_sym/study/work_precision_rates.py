"""The compiled right-hand side of a filament, without the integrator that it was written for.

What explicit Runge-Kutta methods and SciPy are given is the text that the package's own solver runs: rates in C, and
their Jacobian with its zeros known. A state is the flat row of sites, in which every neighbour is near: the Jacobian
is a band.
"""

from __future__ import annotations

import ctypes as ct
from functools import lru_cache
from importlib import resources
from typing import Any

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.native import compile_library, load
from softcat_sym.solve import Prepared
from softcat_sym.solve.c_model import Doubles, Filament, Integers, runtime_sources
from softcat_sym.solve.compiled import CompiledIntegration

_HEADER, _SOURCE = "softcat_model.h", "work_precision_explicit.c"
_ON_THE_LIMIT = 1 + 1e-9
_REACH = 2.83
"""RK4 is stable up to 2.83 on the imaginary axis and 2.79 on the real one."""


class _Model(ct.Structure):
    """softcat_model."""

    _fields_ = (
        *(
            (n, ct.c_int)
            for n in ("slots", "sections", "parameters", "places", "scratch", "entries", "powers", "moves")
        ),
        *((n, Integers) for n in ("rate", "differential", "held_first", "held_last", "row", "offset", "column")),
        *((n, ct.c_void_p) for n in ("rates", "jacobian", "work", "work_slope")),
    )


_JACOBIAN = ct.CFUNCTYPE(ct.c_int, ct.POINTER(Filament), ct.c_double, Doubles, Doubles, Doubles)


class CompiledRates:
    """Rates and Jacobian of a compiled filament that has no algebraic unknowns.

    Parameters
    ----------
    prepared : Prepared
        A compiled run, with a start.

    Attributes
    ----------
    size : int
        Numbers in a state, held ones included.
    band : int
        How far from the diagonal the Jacobian reaches.

    Raises
    ------
    SoftcatError
        If the run is not compiled, has no start, or has algebraic unknowns.
    """

    def __init__(self, prepared: Prepared) -> None:
        whole = prepared.integration
        if not isinstance(whole, CompiledIntegration) or prepared.start is None:
            raise SoftcatError("an explicit method needs a compiled right-hand side and a shape to begin from")
        if prepared.graph.is_dae:
            raise SoftcatError(f"cannot: {prepared.graph.z.numel()} algebraic unknowns")
        compiled = whole.filament.model
        library = _library("filament.c", compiled.model.text)
        self._keep = library, np.ascontiguousarray(prepared.p), whole.filament.places
        self._model = _Model.in_dll(library, "softcat_filament_model")
        text = (resources.files("softcat_sym.study") / _SOURCE).read_text(encoding="utf-8")
        self._c = _library(_SOURCE, text)
        self._c.explicit_rates.restype = self._c.explicit_rk4.restype = ct.c_int
        self._sites = whole.filament.sites
        sites, slots = self._sites.shape
        self.size = sites * slots
        self._filament = Filament(sites, _pointer(self._keep[1]), _pointer(self._keep[2]))
        live = np.zeros(self.size, dtype=bool)
        live[self._sites.x] = True
        self._held = np.flatnonzero(~live).astype(np.int32)
        self._start = self._sites.state(prepared.start.x, prepared.start.z).ravel()
        scratch = sites * self._model.scratch
        self._scratch, self._room = np.zeros(scratch + 1), np.zeros(3 * self.size + scratch)
        self._entries = np.zeros(sites * self._model.entries)
        self._call = _JACOBIAN(self._model.jacobian)
        self._rows, self._columns, self._taken = self._pattern(live)
        self.band = int(np.max(np.abs(self._rows - self._columns), initial=0))
        # Memory of its own, and pointers made once: a call then costs little more than its arithmetic.
        self._state, self._found = np.zeros(self.size), np.zeros(self.size)
        self._head = (
            ct.byref(self._model),
            ct.byref(self._filament),
            self._held.ctypes.data_as(Integers),
            ct.c_int(len(self._held)),
        )
        self._memory = _pointer(self._state), _pointer(self._found), _pointer(self._scratch)
        self._for_entries = self._memory[0], _pointer(self._entries), self._memory[2]
        self._order, self._starts = self._by_columns()

    def start(self) -> Floats:
        """The state at t = 0, shape (size,)."""
        return self._start.copy()

    def unknowns(self, states: Floats) -> tuple[Floats, Floats]:
        """What :class:`softcat_sym.solve.Solution` holds as x and z, of states (frames, size)."""
        return self._sites.vectors(states.reshape(len(states), *self._sites.shape))

    def rates(self, t: float, state: Floats) -> Floats:
        """Rates of a state, shape (size,), zero of what is held."""
        self._state[:] = state
        self._c.explicit_rates(*self._head, ct.c_double(t), *self._memory)
        return self._found.copy()

    def values(self, t: float, state: Floats) -> Floats:
        """Entries of the Jacobian that can differ from zero, in the order of the pattern."""
        self._state[:] = state
        self._call(self._head[1], t, *self._for_entries)
        return self._entries[self._taken]

    def sparse(self, t: float, state: Floats) -> Any:
        """The Jacobian as a ``scipy.sparse.csc_matrix``, shape (size, size)."""
        from scipy.sparse import csc_matrix  # type: ignore[import-untyped]

        values = self.values(t, state)[self._order]
        return csc_matrix((values, self._rows[self._order], self._starts), shape=(self.size, self.size))

    def banded(self, t: float, state: Floats) -> Floats:
        """The Jacobian by diagonals, shape (2 band + 1, size), as LAPACK and LSODA have it."""
        packed = np.zeros((2 * self.band + 1, self.size))
        packed[self._rows - self._columns + self.band, self._columns] = self.values(t, state)
        return packed

    def dense(self, t: float, state: Floats) -> Floats:
        """The Jacobian of what is not held, shape (nx, nx)."""
        whole = np.zeros((self.size, self.size))
        whole[self._rows, self._columns] = self.values(t, state)
        live = np.sort(self._sites.x)
        return whole[np.ix_(live, live)]

    def advance(self, state: Floats, begin: float, end: float, steps: int) -> bool:
        """Carry a state through equal steps of RK4, in place; whether it is still finite."""
        code = self._c.explicit_rk4(
            *self._head,
            ct.c_double(begin),
            ct.c_double(end),
            ct.c_long(steps),
            _pointer(state),
            _pointer(self._room),
        )
        return code == 0 and bool(np.isfinite(state).all())

    def _pattern(self, live: npt.NDArray[np.bool_]) -> tuple[npt.NDArray[np.int64], ...]:
        """Row, column and place among the entries of each that counts."""
        sites, slots = self._sites.shape
        count = self._model.entries
        row, offset, column = (
            np.array(part[:count], dtype=np.int64) for part in (self._model.row, self._model.offset, self._model.column)
        )
        site = np.arange(sites)[:, None]
        other = site + offset
        rows, columns = site * slots + row, other * slots + column
        inside = (other >= 0) & (other < sites)
        inside[inside] = live[rows[inside]] & live[columns[inside]]
        return rows[inside], columns[inside], np.flatnonzero(inside.ravel())

    def _by_columns(self) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
        """Order of the entries column by column, and where each column begins."""
        order = np.lexsort((self._rows, self._columns))
        counts = np.bincount(self._columns, minlength=self.size)
        return order, np.concatenate([[0], np.cumsum(counts)])


def stable_step(jacobian: Floats) -> float:
    """The longest step of RK4 that lets no mode of a linear system grow.

    Parameters
    ----------
    jacobian : ndarray, shape (n, n)
        Of the rates.

    Returns
    -------
    float
        Infinite where nothing moves. |1 + q + q^2/2 + q^3/6 + q^4/24| <= 1 for q = step times each eigenvalue.
    """
    modes = np.linalg.eigvals(jacobian)
    # What grows by itself grows whatever the step.
    modes = modes[modes.real <= 1e-6 * np.abs(modes)]
    fastest = float(np.abs(modes).max(initial=0.0))
    if fastest == 0:
        return np.inf
    low, high = 0.0, _REACH / fastest
    for _ in range(40):
        middle = (low + high) / 2
        q = middle * np.minimum(modes.real, 0.0) + 1j * middle * modes.imag
        stable = np.abs(1 + q * (1 + q / 2 * (1 + q / 3 * (1 + q / 4)))).max() <= _ON_THE_LIMIT
        low, high = (middle, high) if stable else (low, middle)
    return float(low)


@lru_cache(maxsize=16)
def _library(name: str, text: str) -> ct.CDLL:
    """A C text that asks for the model's header, loaded once a process."""
    return load(compile_library({name: text, _HEADER: runtime_sources()[_HEADER]}))


def _pointer(array: Floats) -> ct._Pointer[ct.c_double]:
    return array.ctypes.data_as(Doubles)
