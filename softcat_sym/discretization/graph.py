"""The assembled Graph: a filament of N cells as one CasADi system, with every parameter an input."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import casadi as ca
import numpy as np

from softcat_sym.discretization.cell import Program
from softcat_sym.discretization.grid import Floats, Grid, Layout
from softcat_sym.discretization.stencil import PARAMETER, TIME, Field, Leaf, Spread
from softcat_sym.physics.filament import Terms


def tidy(*expressions: ca.SX) -> list[ca.SX]:
    """Dense, with common subexpressions shared between them; integrators refuse structural zeros in an output."""
    return list(ca.cse([ca.densify(expression) for expression in expressions]))


@dataclass(frozen=True)
class Expressions:
    """What a filament is in terms of its unknowns, before common subexpressions are shared."""

    rates: tuple[ca.SX, ca.SX]  # `ode` and `alg`
    powers: tuple[ca.SX, ...]  # In the order of the program
    observables: Mapping[str, ca.SX]  # What a trajectory shows


@dataclass(frozen=True)
class Graph:
    """Semi-discrete filament: dx/dt = ode, 0 = alg, with energies as quadratures.

    Unknowns are dimensionless: lengths in rest lengths, time in units of the parameter ``time_scale``; parameters
    are SI.
    """

    grid: Grid  # Nodes and ends
    effects: tuple[str, ...]  # Names of the effects in force
    terms: Terms  # What they left of the equations
    conserves_energy: bool  # Whether forces and stored energy belong together, so that the energy balance can be judged
    program: Program  # What its sites compute
    places: Mapping[str, Floats]  # Geometry of each site
    moving: Layout  # Where the differential and the algebraic unknowns stand
    still: Layout

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of the inputs `p`, in order."""
        return self.program.parameters

    @property
    def profiles(self) -> Mapping[str, tuple[float, float]]:
        """What each kind of plastic state is of a plastic strain a_0 + a_1 zeta."""
        return self.program.profiles

    @cached_property
    def t(self) -> ca.SX:
        """Time, in time scales."""
        return ca.SX.sym("t")

    @cached_property
    def p(self) -> ca.SX:
        """Parameters, SI."""
        return ca.vertcat(*(ca.SX.sym(name) for name in self.parameters))

    @property
    def x(self) -> ca.SX:
        """Differential states, shape (nx,)."""
        return self.moving.vector

    @property
    def z(self) -> ca.SX:
        """Algebraic states, shape (nz,)."""
        return self.still.vector

    @property
    def start(self) -> Floats:
        """Differential states of the straight, relaxed filament at rest, shape (nx,)."""
        return self.moving.start

    @property
    def straight(self) -> Floats:
        """Algebraic states of the straight filament, where the search for equilibrium begins, shape (nz,)."""
        return self.still.start

    @property
    def state_names(self) -> tuple[str, ...]:
        """What each component is, for messages."""
        return self.moving.names

    @property
    def algebraic_names(self) -> tuple[str, ...]:
        """Of the algebraic states."""
        return self.still.names

    @property
    def x_kinds(self) -> tuple[str, ...]:
        """Block of each component: ``x``, ``y``, ``u``, ``v``, ``psi``, ``a_0``, ..."""
        return self.moving.kinds

    @property
    def z_kinds(self) -> tuple[str, ...]:
        """Of the algebraic states."""
        return self.still.kinds

    @property
    def x_where(self) -> Floats:
        """X/L_0 of each component."""
        return self.moving.where

    @property
    def z_where(self) -> Floats:
        """Of the algebraic states."""
        return self.still.where

    @property
    def x_places(self) -> tuple[int, ...]:
        """Number of the node or cell of each component."""
        return self.moving.places

    @property
    def z_places(self) -> tuple[int, ...]:
        """Of the algebraic states."""
        return self.still.places

    @property
    def is_dae(self) -> bool:
        """Whether some unknowns are algebraic: positions without inertia, section angles without rotary inertia."""
        return bool(self.z.numel())

    @property
    def has_velocities(self) -> bool:
        """Whether velocities are among the unknowns: with inertia or a viscous stress."""
        return not {"u", "v"}.isdisjoint((*self.x_kinds, *self.z_kinds))

    @property
    def positions_are_algebraic(self) -> bool:
        """Whether the filament is in equilibrium at every instant: without inertia and without a viscous stress."""
        return "y" in self.z_kinds

    @cached_property
    def raw(self) -> Expressions:
        """The expressions; a compiled run needs them only for what a trajectory shows."""
        program = self.program
        shared = {Leaf(PARAMETER, name): self.p[k] for k, name in enumerate(self.parameters)}
        spread = self.spread(self.x, self.z, {**shared, Leaf(TIME, "t"): self.t})
        for one in program.fields:
            spread.take(one)
        rates = {slot.name: spread.values(rate) for slot, rate in zip(program.slots, program.rates, strict=True)}
        powers = tuple(
            ca.vertcat(*(spread.values(one) for one in power)) if power else ca.SX(1, 1)
            for power in program.powers.values()
        )
        shown = {
            name: spread.values(item)
            if isinstance(item, Field)
            else sum((ca.sum1(spread.values(one)) for one in item), ca.SX(0))
            for name, item in program.shown.items()
        }
        ode, alg = (layout.gather(rates) for layout in (self.moving, self.still))
        return Expressions((ca.SX(ode), ca.SX(alg)), powers, shown)

    def spread(self, x: Any, z: Any, shared: Mapping[Leaf, Any]) -> Spread:
        """The sites of this grid with these unknowns, ready for the fields of the program."""
        parts = {**self.moving.split(x), **self.still.split(z)}
        slots = self.program.slots
        unknowns = {slot.name: (int(slot.held[0]), parts[slot.name]) for slot in slots if slot.on != "whole"}
        wholes = {slot.name: parts[slot.name] for slot in slots if slot.on == "whole"}
        return Spread(self.program.leaves, self.grid.cells + 1, self.places, unknowns, {**wholes}, shared)

    @cached_property
    def rates(self) -> tuple[ca.SX, ca.SX]:
        """`ode` and `alg`: tidied when first asked for, which a compiled run never does."""
        ode, alg = tidy(*self.raw.rates)
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
        inputs = [self.t, self.x, self.z, self.p]
        # As built: a handful of evaluations is not worth the search for common subexpressions.
        alg = ca.densify(self.raw.rates[1])
        jacobian = ca.jacobian(alg, self.z)
        linear = not ca.depends_on(jacobian, self.z)
        return ca.Function("residual", inputs, [alg]), ca.Function("jacobian", inputs, [jacobian]), linear

    @cached_property
    def powers(self) -> tuple[ca.SX, ...]:
        """Plastic power, power of the changing load, of the necking gradient, of effects: each place by place.

        In ``energy_scale`` times undeformed area and span. Their sums would fill a row of every Jacobian.
        """
        return tuple(tidy(*self.raw.powers))

    @cached_property
    def observables(self) -> ca.Function:
        """(t, x, z, p) to node and cell fields and energies, in SI per unit undeformed area."""
        inputs, outputs = [self.t, self.x, self.z, self.p], self.raw.observables
        names = ["time", "state", "algebraic", "parameters"]
        # What cells share is left unshared: finding it takes longer than computing it for all frames.
        return ca.Function("observables", inputs, [ca.densify(one) for one in outputs.values()], names, list(outputs))

    @cached_property
    def stretch(self) -> ca.Function:
        """(t, x, z, p) to the stretch of the cells."""
        return ca.Function("stretch", [self.t, self.x, self.z, self.p], [self.raw.observables["stretch"]])

    @cached_property
    def _mapped(self) -> dict[int, ca.Function]:
        """`observables` for several times at once, by their number: filaments of one ensemble share it."""
        return {}

    @property
    def quad(self) -> ca.SX:
        """The powers of the whole filament, shape (powers,)."""
        return ca.vertcat(*(ca.sum1(power) for power in self.powers))

    @cached_property
    def instructions(self) -> int:
        """Number of elementary operations in one evaluation of the right-hand side."""
        return int(ca.Function("rhs", [self.t, self.x, self.z, self.p], [self.ode, self.alg]).n_instructions())

    def vector(self, values: dict[str, float]) -> Floats:
        """Parameter values in the order of `p`."""
        return np.array([values[name] for name in self.parameters], dtype=float)

    def observe(self, time: Floats, x: Floats, z: Floats, p: Floats) -> dict[str, Floats]:
        """Fields and energies at several times."""
        frames = len(time)
        if frames not in self._mapped:
            self._mapped[frames] = self.observables.map(frames)
        mapped = self._mapped[frames]
        out = mapped(time=time.reshape(1, -1), state=x, algebraic=z, parameters=np.repeat(p[:, None], frames, axis=1))
        return {name: np.asarray(value, dtype=float).reshape(-1, frames, order="F").T for name, value in out.items()}
