"""The assembled Graph: a filament of N cells as one CasADi system, with every parameter an input."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from softcat_sym.graph.grid import Floats, Grid


def tidy(*expressions: ca.SX) -> list[ca.SX]:
    """Dense, with common subexpressions shared between them; integrators refuse structural zeros in an output."""
    return list(ca.cse([ca.densify(expression) for expression in expressions]))


@dataclass(frozen=True)
class Expressions:
    """What a filament is in terms of its unknowns, before common subexpressions are shared.

    Attributes
    ----------
    rates : tuple of casadi.SX
        `ode` and `alg`.
    powers : tuple of casadi.SX
        Plastic power, power of the changing load, power of the necking gradient.
    observables : mapping of str to casadi.SX
        What a trajectory shows.
    """

    rates: tuple[ca.SX, ca.SX]
    powers: tuple[ca.SX, ca.SX, ca.SX]
    observables: Mapping[str, ca.SX]


@dataclass(frozen=True)
class Graph:
    """Semi-discrete filament: dx/dt = ode, 0 = alg, with energies as quadratures.

    Unknowns are dimensionless: lengths in rest lengths, time in units of the parameter ``time_scale``; parameters
    are SI.

    Attributes
    ----------
    grid : Grid
        Nodes and ends.
    effects : tuple of str
        Names of the effects in force.
    conserves_energy : bool
        Whether forces and stored energy belong together, so that the energy balance can be judged.
    parameters : tuple of str
        Names of the inputs `p`, in order.
    t, x, z, p : casadi.SX
        Time, differential states (nx,), algebraic states (nz,), parameters.
    write : callable
        Writes the expressions, when they are first asked for.
    state_names, algebraic_names : tuple of str
        What each component is, for messages.
    start : ndarray, shape (nx,)
        Differential states of the straight, relaxed filament at rest.
    straight : ndarray, shape (nz,)
        Algebraic states of the straight filament: where the search for equilibrium begins.
    x_kinds, z_kinds : tuple of str
        Block of each component: ``x``, ``y``, ``u``, ``v``, ``psi``, ``a_0``, ...
    x_where, z_where : ndarray
        X/L_0 of each component.
    x_places, z_places : tuple of int
        Number of the node or cell of each component.
    profiles : mapping of str to (float, float)
        What each kind of plastic state is of a plastic strain a_0 + a_1 zeta.
    """

    grid: Grid
    effects: tuple[str, ...]
    conserves_energy: bool
    parameters: tuple[str, ...]
    t: ca.SX
    x: ca.SX
    z: ca.SX
    p: ca.SX
    write: Callable[[], Expressions]
    state_names: tuple[str, ...]
    algebraic_names: tuple[str, ...]
    start: Floats
    straight: Floats
    x_kinds: tuple[str, ...]
    z_kinds: tuple[str, ...]
    x_where: Floats
    z_where: Floats
    x_places: tuple[int, ...]
    z_places: tuple[int, ...]
    profiles: Mapping[str, tuple[float, float]]

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
        return self.write()

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
    def powers(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        """Plastic power, power of the changing load, power of the necking gradient: each place by place.

        In ``energy_scale`` times undeformed area and span. Their sums would fill a row of every Jacobian.
        """
        plastic, load, gradient = tidy(*self.raw.powers)
        return plastic, load, gradient

    @cached_property
    def observables(self) -> ca.Function:
        """(t, x, z, p) to node and cell fields and energies, in SI per unit undeformed area."""
        inputs, outputs = [self.t, self.x, self.z, self.p], self.raw.observables
        names = ["time", "state", "algebraic", "parameters"]
        return ca.Function("observables", inputs, tidy(*outputs.values()), names, list(outputs))

    @cached_property
    def _mapped(self) -> dict[int, ca.Function]:
        """`observables` for several times at once, by their number: filaments of one ensemble share it."""
        return {}

    @property
    def quad(self) -> ca.SX:
        """The powers of the whole filament, shape (3,)."""
        return ca.vertcat(*(ca.sum1(power) for power in self.powers))

    @cached_property
    def instructions(self) -> int:
        """Number of elementary operations in one evaluation of the right-hand side."""
        return int(ca.Function("rhs", [self.t, self.x, self.z, self.p], [self.ode, self.alg]).n_instructions())

    def vector(self, values: dict[str, float]) -> Floats:
        """Parameter values in the order of `p`.

        Raises
        ------
        KeyError
            If a parameter of the graph has no value.
        """
        return np.array([values[name] for name in self.parameters], dtype=float)

    def observe(self, time: Floats, x: Floats, z: Floats, p: Floats) -> dict[str, Floats]:
        """Fields and energies at several times.

        Parameters
        ----------
        time : ndarray, shape (frames,)
            Dimensionless times.
        x, z : ndarray, shapes (nx, frames) and (nz, frames)
            States.
        p : ndarray, shape (np,)
            Parameters.

        Returns
        -------
        dict of str to ndarray, shape (frames, size)
            Whatever `observables` computes, a row for each time.
        """
        frames = len(time)
        if frames not in self._mapped:
            self._mapped[frames] = self.observables.map(frames)
        mapped = self._mapped[frames]
        out = mapped(time=time.reshape(1, -1), state=x, algebraic=z, parameters=np.repeat(p[:, None], frames, axis=1))
        return {name: np.asarray(value, dtype=float).reshape(-1, frames, order="F").T for name, value in out.items()}
