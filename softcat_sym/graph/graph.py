"""The assembled Graph: a filament of N cells as one CasADi system, with every parameter an input."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from softcat_sym.graph.grid import Floats, Grid


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
    ode, alg : casadi.SX
        Right-hand sides.
    plastic_powers, load_powers, gradient_powers : casadi.SX
        Plastic power, power of the changing load and of the necking gradient, in ``energy_scale`` times
        undeformed area and span. Place by place, because their sums would fill a row of every Jacobian.
    state_names, algebraic_names : tuple of str
        What each component is, for messages.
    observables : casadi.Function
        (t, x, z, p) to node and cell fields and energies, in SI per unit undeformed area.
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
    ode: ca.SX
    alg: ca.SX
    plastic_powers: ca.SX
    load_powers: ca.SX
    gradient_powers: ca.SX
    state_names: tuple[str, ...]
    algebraic_names: tuple[str, ...]
    observables: ca.Function
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

    @property
    def powers(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        """Plastic power, power of the changing load, power of the necking gradient: each place by place."""
        return self.plastic_powers, self.load_powers, self.gradient_powers

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
        mapped = self.observables.map(frames)
        out = mapped(time=time.reshape(1, -1), state=x, algebraic=z, parameters=np.repeat(p[:, None], frames, axis=1))
        return {name: np.asarray(value, dtype=float).reshape(-1, frames, order="F").T for name, value in out.items()}
