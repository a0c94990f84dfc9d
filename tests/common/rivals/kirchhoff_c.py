"""The hand-written C right-hand side, called through ctypes."""

from __future__ import annotations

import ctypes
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from softcat_sym.codegen.library import compile_library, load
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats

HERE = Path(__file__).parent
PORTABLE = ("-O3", "-fno-math-errno", "-fno-trapping-math")
"""Flags of both sides: no instruction set beyond the processor's family."""

NODE_KINDS = ("x", "y", "u", "v", "a_1")
SCRATCH = 12
_Doubles = ctypes.POINTER(ctypes.c_double)


class _Filament(ctypes.Structure):
    _fields_ = (
        ("cells", ctypes.c_int),
        *((name, ctypes.c_double) for name in ("half_thickness", "yield_strain", "flow", "gravity", "ramp")),
        *((name, _Doubles) for name in ("per_cell", "per_node", "before", "behind", "per_mass")),
    )


@dataclass(frozen=True)
class Numbers:
    """A half filament without units, as `kirchhoff.h` defines it."""

    half_thickness: float
    yield_strain: float
    flow: float
    gravity: float
    ramp: float
    per_cell: Floats
    per_node: Floats
    before: Floats
    behind: Floats
    per_mass: Floats


def numbers_of(nodes: Floats, given: dict[str, float]) -> Numbers:
    """From the node positions X/L_0 and the parameters in SI units, by their names in the scene."""
    length, scale, modulus = given["rest_length"], given["time_scale"], given["youngs_modulus"]
    cell = np.diff(nodes)
    left, right = np.concatenate([[0.0], cell / 2]), np.concatenate([cell / 2, [0.0]])
    node = left + right
    return Numbers(
        half_thickness=given["thickness"] / (2 * length),
        yield_strain=given["yield_stress"] / modulus,
        flow=scale * modulus / given["viscosity"],
        gravity=given["gravity"] * scale**2 / length,
        ramp=given["ramp"] / scale,
        per_cell=1 / cell,
        per_node=1 / node,
        before=left / node,
        behind=right / node,
        per_mass=modulus * scale**2 / (given["density"] * length**2) / node,
    )


def places_of(graph: Graph) -> np.ndarray:
    """Where each state of a graph stands in the blocks x, y, u, v, a_1 (nodes), a_0 (cells), shape (nx,)."""
    cells = graph.grid.cells
    at = np.array(graph.x_where)
    nodes, centres = np.searchsorted(graph.grid.nodes, at - 1e-12), np.searchsorted(graph.grid.centres, at - 1e-12)
    first = {kind: block * (cells + 1) for block, kind in enumerate((*NODE_KINDS, "a_0"))}
    is_cell = np.array([kind == "a_0" for kind in graph.x_kinds])
    return np.array([first[kind] for kind in graph.x_kinds]) + np.where(is_cell, centres, nodes)


class HandWritten:
    """`kirchhoff.c` for one filament."""

    def __init__(self, graph: Graph, p: Floats) -> None:
        texts = {name: (HERE / name).read_text(encoding="utf-8") for name in ("kirchhoff.c", "kirchhoff.h")}
        self._library = load(compile_library(texts, flags=PORTABLE))
        nodes = graph.grid.cells + 1
        self._numbers = numbers_of(graph.grid.nodes, dict(zip(graph.parameters, p.tolist(), strict=True)))
        self._places = places_of(graph)
        self._filament = _filament(graph.grid.cells, self._numbers)
        self._state, self._rates = np.zeros(6 * nodes - 1), np.zeros(6 * nodes - 1)
        # The clamp: x = 1/2, y = 0 and no velocity. x of midspan is zero.
        self._state[nodes - 1] = 0.5
        self._scratch = np.zeros(SCRATCH * (nodes + 1))

    def rates(self, t: float, state: Floats) -> Floats:
        """Rates in the order of the graph, shape (nx,)."""
        self._call(self._library.kirchhoff_rates, t, state)
        return self._rates[self._places].copy()

    def seconds(self, t: float, state: Floats, calls: int) -> float:
        """Time of one call, of many in a row."""
        return _per_call(lambda: self._call(self._library.kirchhoff_repeat, t, state, ctypes.c_int(calls)), calls)

    def _call(self, function: Callable[..., object], t: float, state: Floats, *rest: object) -> None:
        self._state[self._places] = state
        arrays = (_pointer(a) for a in (self._state, self._rates, self._scratch))
        function(ctypes.byref(self._filament), ctypes.c_double(t), *arrays, *rest)


def _filament(cells: int, numbers: Numbers) -> _Filament:
    """The structure; it points into the arrays of `numbers`."""
    values = (getattr(numbers, name) for name, _ in _Filament._fields_[1:])
    return _Filament(cells, *(_pointer(v) if isinstance(v, np.ndarray) else v for v in values))


def _pointer(array: Floats) -> ctypes._Pointer[ctypes.c_double]:
    return array.ctypes.data_as(_Doubles)


def _per_call(run: Callable[[], object], calls: int) -> float:
    began = time.perf_counter()
    run()
    return (time.perf_counter() - began) / calls
