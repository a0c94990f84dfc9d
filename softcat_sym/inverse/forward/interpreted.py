"""The forward model by CasADi's Rosenbrock method, whose derivatives are those of the discrete solution, both ways.

Adjoints through CVODES and IDAS are not: their quadratures are outside of the error control unless asked in.
"""

from __future__ import annotations

import contextlib
import io
from functools import lru_cache
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.graph import Graph
from softcat_sym.graph.grid import Floats
from softcat_sym.inverse.forward.path import Begin, Path
from softcat_sym.solve import Settings, watched

_FAILED = "the integrator gave up: its steps ran out, or the state became infinite"


class InterpretedForward:
    """CasADi's `rosenbrock` on the graph, from t = 0 to the first time and from there through the others.

    Parameters
    ----------
    graph : Graph
        The filament.
    settings : Settings
        Tolerances.
    """

    def __init__(self, graph: Graph, settings: Settings) -> None:
        self._graph, self._settings = graph, settings
        # One for each pattern of times and each number of directions; both hardly ever change.
        self._function = lru_cache(maxsize=8)(self._make)
        self._forward = lru_cache(maxsize=8)(lambda key, count: self._function(*key).forward(count))
        self._reverse = lru_cache(maxsize=8)(lambda key: self._function(*key).reverse(1))

    def run(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> Path:
        """Integrate; parameters as :class:`softcat_sym.inverse.forward.path.Integrator`."""
        key = self._key(begin, seen, most_steps)
        values = _called(self._function(*key), *_inputs(begin))
        return self._path(values, None, begin, seen)

    def run_with_slopes(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> Path:
        """Integrate with exact forward derivatives."""
        key, count = self._key(begin, seen, most_steps), len(begin.d_parameters)
        inputs = _inputs(begin)
        values = _called(self._function(*key), *inputs)
        slopes = None
        if values is not None and count:
            seeds = (begin.d_x.T, begin.d_z.T, begin.d_parameters.T, np.zeros((1, count)))
            slopes = _called(self._forward(key, count), *inputs, values, *seeds)
        return self._path(values, slopes, begin, seen)

    def pull_back(self, begin: Begin, seen: tuple[int, ...], most_steps: int, weights: Floats) -> Floats:
        """Derivatives of a weighted sum of what is seen, by the adjoint of the discrete solution.

        Parameters
        ----------
        weights : ndarray, shape (n, seen)

        Returns
        -------
        ndarray, shape (k,)
            NaN if the integration fails.
        """
        key, inputs = self._key(begin, seen, most_steps), _inputs(begin)
        values = _called(self._function(*key), *inputs)
        if values is None:
            return np.full(len(begin.d_parameters), np.nan)
        with watched() as interrupts, _silent():
            try:
                pulled = self._reverse(key)(*inputs, values, weights.T)
            finally:
                interrupts.check()
        x, z, p = (np.asarray(part, dtype=float).ravel() for part in pulled[:3])
        return np.asarray(begin.d_x @ x + begin.d_z @ z + begin.d_parameters @ p, dtype=float)

    def _key(self, begin: Begin, seen: tuple[int, ...], most_steps: int) -> tuple[tuple[float, ...], Any, int]:
        # Later times as distances from the first, so that a shift of the clock asks for no other integrator.
        later = tuple(round(float(time), 12) for time in begin.times[1:] - begin.times[0])
        return later, seen, most_steps

    def _make(self, later: tuple[float, ...], seen: tuple[int, ...], most_steps: int) -> ca.Function:
        graph = self._graph
        x, z, p = (ca.MX.sym(name, part.numel()) for name, part in (("x", graph.x), ("z", graph.z), ("p", graph.p)))
        first = ca.MX.sym("first")
        states, algebraic = self._step(x, z, p, ca.MX(0), first, (1.0,), most_steps)
        if later:
            inner = np.append(0.0, later)
            more = self._step(states, algebraic, p, first, ca.MX(1), tuple(inner[1:]), most_steps)
            states, algebraic = ca.horzcat(states, more[0]), ca.horzcat(algebraic, more[1])
        rows = ca.vertcat(states, algebraic) if graph.is_dae else states
        return ca.Function("path", [x, z, p, first], [rows[list(seen), :]])

    def _step(
        self, x: ca.MX, z: ca.MX, p: ca.MX, start: ca.MX, unit: ca.MX, taus: tuple[float, ...], most_steps: int
    ) -> tuple[ca.MX, ca.MX]:
        """States at start + unit * taus."""
        graph = self._graph
        tau, begins, interval = ca.SX.sym("tau"), ca.SX.sym("begins"), ca.SX.sym("interval")
        ode, alg = ca.substitute([graph.ode, graph.alg], [graph.t], [begins + interval * tau])
        dae: dict[str, Any] = {"t": tau, "x": graph.x, "p": ca.vertcat(graph.p, begins, interval)}
        dae |= {"ode": ode * interval}
        if graph.is_dae:
            dae |= {"z": graph.z, "alg": alg}
        options = {"reltol": self._settings.rtol, "abstol": self._settings.atol, "max_num_steps": most_steps}
        call = ca.integrator("filament", "rosenbrock", dae, 0.0, list(taus), options)
        found = (
            call(x0=x, z0=z, p=ca.vertcat(p, start, unit)) if graph.is_dae else call(x0=x, p=ca.vertcat(p, start, unit))
        )
        return found["xf"], found["zf"]

    def _path(self, values: ca.DM | None, slopes: ca.DM | None, begin: Begin, seen: tuple[int, ...]) -> Path:
        count, shape = len(begin.d_parameters), (len(begin.times), len(seen))
        if values is None:
            return Path(np.full(shape, np.nan), np.full((count, *shape), np.nan), 0, _FAILED)
        rows = np.asarray(values, dtype=float).T
        if slopes is None:
            return Path(rows, None if count else np.zeros((0, *shape)), 0)
        # Directions stand side by side.
        each = np.asarray(slopes, dtype=float).T.reshape(count, *shape)
        return Path(rows, each, 0)


def _inputs(begin: Begin) -> tuple[Floats, Floats, Floats, float]:
    return begin.start.x, begin.start.z, begin.parameters, float(begin.times[0])


@contextlib.contextmanager
def _silent() -> Any:
    silence = io.StringIO()
    with contextlib.redirect_stdout(silence), contextlib.redirect_stderr(silence):
        yield


def _called(function: ca.Function, *inputs: Any) -> ca.DM | None:
    """The only output; None where it fails.

    Raises
    ------
    KeyboardInterrupt
        If the user stops it, which CasADi turns into an error of its own.
    """
    with watched() as interrupts, _silent():
        try:
            found = function(*inputs)
        except RuntimeError:
            return None
        finally:
            interrupts.check()
    return found if np.all(np.isfinite(np.asarray(found))) else None
