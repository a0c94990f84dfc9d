"""The equations of a filament on a grid as CasADi expressions: what is interpreted, or differentiated as a whole."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.cell import Program
from softcat_sym.discretization.small_deflection import SmallDeflection
from softcat_sym.discretization.stencil import Evaluated
from softcat_sym.discretization.unknowns import Floats, Layout


def tidy(*expressions: ca.SX) -> list[ca.SX]:
    """Dense, with common subexpressions shared between them; integrators refuse structural zeros in an output."""
    return list(ca.cse([ca.densify(expression) for expression in expressions]))


@dataclass(frozen=True)
class Symbolic:
    """Semi-discrete filament: dx/dt = ode, 0 = alg, with energies as quadratures."""

    program: Program | SmallDeflection
    places: Mapping[str, Floats]  # Geometry of each site
    differential: Layout  # Where the differential and the algebraic unknowns stand
    algebraic: Layout

    @cached_property
    def t(self) -> ca.SX:
        """Time, in time scales."""
        return ca.SX.sym("t")

    @cached_property
    def p(self) -> ca.SX:
        """Parameters, SI."""
        return ca.vertcat(*(ca.SX.sym(name) for name in self.program.signature.parameters))

    @cached_property
    def x(self) -> ca.SX:
        """Differential states, shape (nx,)."""
        return ca.SX.sym("x", len(self.differential))

    @cached_property
    def z(self) -> ca.SX:
        """Algebraic states, shape (nz,)."""
        return ca.SX.sym("z", len(self.algebraic))

    @property
    def inputs(self) -> list[ca.SX]:
        """What all of it depends on: time, differential and algebraic states, parameters."""
        return [self.t, self.x, self.z, self.p]

    @cached_property
    def raw(self) -> Evaluated:
        """The expressions; a compiled run needs them only for what a trajectory shows."""
        named = dict(zip(self.program.signature.parameters, ca.vertsplit(self.p), strict=True))
        unknowns = {**self.differential.split(self.x), **self.algebraic.split(self.z)}
        return self.program.evaluate(self.t, unknowns, named, self.places)

    @cached_property
    def balances(self) -> tuple[ca.SX, ca.SX]:
        """`ode` and `alg`, as built."""
        ode, alg = (ca.SX(gathered(layout, self.raw.rates)) for layout in (self.differential, self.algebraic))
        return ode, alg

    @cached_property
    def rates(self) -> tuple[ca.SX, ca.SX]:
        """`ode` and `alg`: tidied when first asked for, which a compiled run never does."""
        ode, alg = tidy(*self.balances)
        return ode, alg

    @property
    def ode(self) -> ca.SX:
        """Right-hand side of the differential states, shape (nx,)."""
        return self.rates[0]

    @property
    def alg(self) -> ca.SX:
        """Right-hand side of the algebraic states, shape (nz,)."""
        return self.rates[1]

    @cached_property
    def balance(self) -> tuple[ca.Function, ca.Function, bool]:
        """(t, x, z, p) to what must vanish, to its derivative by z, and whether that is the same for all z."""
        # As built: a handful of evaluations is not worth the search for common subexpressions.
        alg = ca.densify(self.balances[1])
        jacobian = ca.jacobian(alg, self.z)
        linear = not ca.depends_on(jacobian, self.z)
        residual = ca.Function("residual", self.inputs, [alg])
        return residual, ca.Function("jacobian", self.inputs, [jacobian]), linear

    @cached_property
    def powers(self) -> tuple[ca.SX, ...]:
        """Plastic power, power of the changing load, of the necking gradient, of effects: each place by place.

        In ``energy_scale`` times undeformed area and span. Their sums would fill a row of every Jacobian.
        """
        return tuple(tidy(*self.raw.powers))

    @cached_property
    def observables(self) -> ca.Function:
        """(t, x, z, p) to node and cell fields and energies, in SI per unit undeformed area."""
        inputs, outputs = self.inputs, self.raw.observables
        names = ["time", "state", "algebraic", "parameters"]
        # What cells share is left unshared: finding it takes longer than computing it for all frames.
        return ca.Function("observables", inputs, [ca.densify(one) for one in outputs.values()], names, list(outputs))

    @cached_property
    def stretch(self) -> ca.Function:
        """(t, x, z, p) to the stretch of the cells."""
        return ca.Function("stretch", self.inputs, [self.raw.observables["stretch"]])

    @property
    def quad(self) -> ca.SX:
        """The powers of the whole filament, shape (powers,)."""
        return ca.vertcat(*(ca.sum1(power) for power in self.powers))

    @cached_property
    def instructions(self) -> int:
        """Number of elementary operations in one evaluation of the right-hand side."""
        return int(ca.Function("rhs", self.inputs, [self.ode, self.alg]).n_instructions())

    def observe(self, time: Floats, x: Floats, z: Floats, p: Floats) -> dict[str, Floats]:
        """What is stored at several times."""
        frames = len(time)
        mapped = self.observables.map(frames)
        out = mapped(time=time.reshape(1, -1), state=x, algebraic=z, parameters=np.repeat(p[:, None], frames, axis=1))
        return {name: np.asarray(value, dtype=float).reshape(-1, frames, order="F").T for name, value in out.items()}


def gathered(layout: Layout, fields: Mapping[str, Any]) -> Any:
    """Values of each block in the order of the state vector."""
    if not layout.blocks:
        return ca.DM(0, 1)
    return ca.vertcat(*(fields[block.name] for block in layout.blocks))[layout.order]
