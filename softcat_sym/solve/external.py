"""Compiled right-hand sides in CasADi's integrators, in place of the interpreted graph."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import casadi as ca

from softcat_sym.codegen.c_source import CSource
from softcat_sym.codegen.general import POWERS, RHS, SOLVER, rhs_source, solver_source
from softcat_sym.graph import Graph
from softcat_sym.native import compile_library
from softcat_sym.solve.settings import Settings

# Runs on every machine of this kind, and no number changes: no -march=native, no -ffast-math, no fused operations.
PORTABLE: tuple[str, ...] = ("-O2", "-fno-math-errno", "-fno-trapping-math", "-ffp-contract=off")


@dataclass(frozen=True)
class External:
    """A compiled right-hand side, to be built into an integrator; its derivatives are those by t, x and z only.

    Attributes
    ----------
    library : pathlib.Path
        What was compiled.
    rhs : casadi.Function
        (t, x, z, p) to (ode, alg).
    powers : casadi.Function
        (t, x, z, p) to the powers of the whole filament, shape (3,).
    """

    library: Path
    rhs: ca.Function
    powers: ca.Function

    def symbols(self) -> tuple[ca.MX, ca.MX, ca.MX]:
        """New symbols x, z, p of the right sizes."""
        x, z, p = (ca.MX.sym(name, self.rhs.size1_in(name)) for name in ("x", "z", "p"))
        return x, z, p


def compiled_rhs(graph: Graph) -> External:
    """The right-hand side of a graph as machine code, compiled now or found in the cache.

    Raises
    ------
    SoftcatError
        If there is no compiler, it refuses the text, or the cache cannot be written.
    """
    library = _compiled(rhs_source(graph))
    # Without these CasADi would look for forward derivatives in the library, and find none.
    options = {"enable_forward": False, "enable_reverse": False}
    rhs, powers = (ca.external(name, str(library), options) for name in (RHS, POWERS))
    return External(library, rhs, powers)


def compiled_rosenbrock(graph: Graph, settings: Settings, frames: int) -> ca.Function:
    """CasADi's Rosenbrock method on this graph as machine code.

    Parameters
    ----------
    graph : Graph
        It must have differential states.
    settings : Settings
        Tolerances; the solver named there is not asked for.
    frames : int
        Output times, the first included.

    Returns
    -------
    casadi.Function
        (x0, z0, p, start, interval) to (xf, zf, qf), with a column for each output time. It fails by returning NaN
        or a nonzero code from a buffer, and does not say why.

    Raises
    ------
    SoftcatError
        If there is no compiler, it refuses the text, or the cache cannot be written.
    """
    options = replace(settings, solver="rosenbrock").options()
    return ca.external(SOLVER, str(_compiled(solver_source(graph, frames, options))))


def _compiled(source: CSource) -> Path:
    return compile_library(source.files, flags=PORTABLE)
