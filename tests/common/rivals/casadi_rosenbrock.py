"""CasADi's own integrators: `rosenbrock` generated as C, the whole solver, and the interpreted ones of SUNDIALS."""

from __future__ import annotations

import ctypes
import time
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.codegen.library import compile_library, load
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.solvers.run import Prepared
from tests.common.rivals.kirchhoff_c import PORTABLE
from tests.common.rivals.radau import Solved
from tests.common.rivals.scenes import Physics

_MAX_STEPS = 1_000_000

# rtol and atol: of those tried, rtol in 1e-2, 3e-3, 1e-3, 3e-4, 1e-4 and atol/rtol in 1e-3, 1e-2, 1e-1, 1, the pair of
# the fewest steps with the midpoint of 40 cells within 1e-3 of the converged one. Space takes 2e-4 of that in the
# descent and 9e-4 in the arrest, with fibres 3e-5 and 4e-4.
LOOSEST: dict[tuple[str, Physics, str], tuple[float, float]] = {
    ("continual-descent", "fibres", "rosenbrock"): (3e-3, 3e-3),
    ("arrested-overdamped", "fibres", "rosenbrock"): (3e-3, 3e-5),
    ("continual-descent", "fibres", "idas"): (1e-3, 1e-4),
    ("arrested-overdamped", "fibres", "idas"): (1e-3, 1e-4),
}
_Doubles = ctypes.POINTER(ctypes.c_double)


class CompiledRosenbrock:
    """The whole solver as C: CasADi writes it, the compiler of this machine compiles it."""

    def __init__(self, prepared: Prepared, rtol: float, atol: float) -> None:
        began = time.perf_counter()
        call = integrator(prepared, "rosenbrock", {"reltol": rtol, "abstol": atol})
        function = _of_start(call, prepared)
        generator = ca.CodeGenerator("rosenbrock.c")
        generator.add(function)
        text = generator.dump()
        self.size, self.generating = len(text.encode()), time.perf_counter() - began
        began = time.perf_counter()
        self._library = load(compile_library({"rosenbrock.c": text}, flags=PORTABLE))
        self.compiling = time.perf_counter() - began
        self._prepared = prepared
        self._inputs = [np.array(a, dtype=float) for a in _given(prepared)]
        self._final, self._unused = np.zeros(prepared.graph.x.numel()), np.zeros(prepared.graph.z.numel())
        self._arguments = (_Doubles * function.sz_arg())(*map(_pointer, self._inputs))
        self._results = (_Doubles * function.sz_res())(_pointer(self._final), _pointer(self._unused))
        self._whole = np.zeros(function.sz_iw() + 1, dtype=np.int64)
        self._work = np.zeros(function.sz_w() + 1)

    def solve(self) -> Solved:
        """Integrate; the steps are not to be had from the C."""
        whole = self._whole.ctypes.data_as(ctypes.POINTER(ctypes.c_longlong))
        began = time.perf_counter()
        code = self._library.solve(self._arguments, self._results, whole, _pointer(self._work), 0)
        seconds = time.perf_counter() - began
        if code:
            raise RuntimeError(f"the generated rosenbrock returned {code}")
        return Solved(seconds, _midpoint(self._prepared.graph, self._final), 0)


class Interpreted:
    """One of CasADi's integrators, from the start to the end in one call, without quadratures."""

    def __init__(self, prepared: Prepared, solver: str, options: dict[str, Any]) -> None:
        self._graph, self._given = prepared.graph, _given(prepared)
        self._call = integrator(prepared, solver, options)

    def solve(self) -> Solved:
        """Integrate."""
        began = time.perf_counter()
        x, z, p = self._given
        found = self._call(x0=x, z0=z, p=p)
        seconds = time.perf_counter() - began
        stats = self._call.stats()
        steps = int(stats.get("nsteps", stats.get("n_steps", 0)))
        return Solved(seconds, _midpoint(self._graph, np.asarray(found["xf"]).ravel()), steps)


def integrator(prepared: Prepared, solver: str, options: dict[str, Any]) -> ca.Function:
    """From the start to the end of the run in one call, without anything beside the unknowns."""
    graph = prepared.graph
    dae = {"t": graph.t, "x": graph.x, "p": graph.p, "ode": graph.ode}
    if graph.is_dae:
        dae |= {"z": graph.z, "alg": graph.alg}
    every = {"max_num_steps": _MAX_STEPS, **options}
    return ca.integrator("filament", solver, dae, 0, [float(prepared.times[-1])], every)


def _of_start(call: ca.Function, prepared: Prepared) -> ca.Function:
    graph = prepared.graph
    x, z, p = (ca.MX.sym(name, size) for name, size in _sizes(graph))
    found = call(x0=x, z0=z, p=p)
    return ca.Function("solve", [x, z, p], [found["xf"], found["zf"]])


def _sizes(graph: Graph) -> tuple[tuple[str, int], ...]:
    return ("x", graph.x.numel()), ("z", graph.z.numel()), ("p", graph.p.numel())


def _given(prepared: Prepared) -> tuple[Floats, Floats, Floats]:
    if prepared.start is None:
        raise ValueError("no shape at rest to start from")
    return prepared.start.x, prepared.start.z, prepared.p


def _midpoint(graph: Graph, x: Floats) -> float:
    return float(x[graph.x_kinds.index("y")])


def _pointer(array: Floats) -> ctypes._Pointer[ctypes.c_double]:
    return array.ctypes.data_as(_Doubles)
