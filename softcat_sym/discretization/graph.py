"""The assembled Graph: a filament of N cells as one CasADi system, with every parameter an input."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from softcat_sym.discretization.grid import Floats, Grid
from softcat_sym.discretization.supports import DROP, LEFT_ANGLE, POINT_MASS, RIGHT_ANGLE, SPAN, path_name
from softcat_sym.effects.free_vibration import solid_viscosity
from softcat_sym.physics import symbols
from softcat_sym.physics.bulk import nu
from softcat_sym.physics.loads import surface_tension
from softcat_sym.physics.necking import aspect
from softcat_sym.scene.scene import Scene, elastic_time, gravity_time, rest_length, undeformed_area

REST_LENGTH = "rest_length"
TIME_SCALE = "time_scale"


@dataclass(frozen=True, slots=True)
class Parameter:
    """A numeric input of the graph: its leaf name in the scene, its symbol and its unit."""

    name: str
    symbol: symbols.Symbol
    unit: str


CATALOGUE: tuple[Parameter, ...] = (
    Parameter(REST_LENGTH, symbols.L_0, "m"),
    Parameter("thickness", symbols.h0, "m"),
    Parameter("density", symbols.rho, "kg/m^3"),
    Parameter("gravity", symbols.g, "m/s^2"),
    Parameter("ramp", symbols.g_on, "s"),
    Parameter("youngs_modulus", symbols.E, "Pa"),
    Parameter("viscosity", symbols.eta, "Pa*s"),
    Parameter("solid_viscosity", symbols.eta_s, "Pa*s"),
    Parameter("yield_stress", symbols.sigma_Y, "Pa"),
    Parameter("poisson", nu, "1"),
    Parameter("curvature", symbols.kappa_0, "1/m"),
    Parameter("aspect", aspect, "1"),
    Parameter("surface_tension", surface_tension, "N/m"),
    Parameter("shake", symbols.a_g, "1"),
    Parameter("shake_frequency", symbols.f_g, "Hz"),
)


def time_scale(scene: Scene) -> float:
    """Unit of time [s]: sqrt(L/g), or L sqrt(rho/E) without gravity, or else the duration of the run."""
    gravity_unit = gravity_time(scene)
    if gravity_unit < float("inf"):
        return gravity_unit
    return elastic_time(scene) or scene.run.duration


def parameter_values(scene: Scene) -> dict[str, float]:
    """Values of every parameter that a graph of this scene may ask for, in SI units."""
    filament, ends = scene.filament, scene.ends
    path = {
        path_name(kind, row): value
        for row, point in enumerate(ends.motion)
        for kind, value in zip(("time", "dx", "dy"), point, strict=True)
    }
    return {
        REST_LENGTH: rest_length(scene),
        "thickness": filament.thickness,
        "density": filament.density,
        "gravity": scene.load.gravity,
        "ramp": scene.load.ramp,
        "shake": scene.load.shake,
        "shake_frequency": scene.load.shake_frequency,
        "aspect": filament.width / filament.thickness,
        "curvature": filament.curvature,
        "surface_tension": scene.surroundings.surface_tension,
        POINT_MASS: scene.load.point_mass / undeformed_area(scene),
        SPAN: filament.span,
        DROP: ends.drop,
        LEFT_ANGLE: ends.left_angle,
        RIGHT_ANGLE: ends.right_angle,
        TIME_SCALE: time_scale(scene),
        "poisson": scene.material.poisson,
        "solid_viscosity": solid_viscosity(scene),
        **scene.material.values(),
        **path,
    }


def tidy(*expressions: ca.SX) -> list[ca.SX]:
    """Dense, with common subexpressions shared between them; integrators refuse structural zeros in an output."""
    return list(ca.cse([ca.densify(expression) for expression in expressions]))


@dataclass(frozen=True)
class Expressions:
    """What a filament is in terms of its unknowns, before common subexpressions are shared."""

    rates: tuple[ca.SX, ca.SX]  # `ode` and `alg`
    powers: tuple[ca.SX, ca.SX, ca.SX]  # Plastic power, power of the changing load, power of the necking gradient
    observables: Mapping[str, ca.SX]  # What a trajectory shows


@dataclass(frozen=True)
class Graph:
    """Semi-discrete filament: dx/dt = ode, 0 = alg, with energies as quadratures.

    Unknowns are dimensionless: lengths in rest lengths, time in units of the parameter ``time_scale``; parameters
    are SI.
    """

    grid: Grid  # Nodes and ends
    effects: tuple[str, ...]  # Names of the effects in force
    conserves_energy: bool  # Whether forces and stored energy belong together, so that the energy balance can be judged
    parameters: tuple[str, ...]  # Names of the inputs `p`, in order
    t: ca.SX  # Time, differential states (nx,), algebraic states (nz,), parameters
    x: ca.SX
    z: ca.SX
    p: ca.SX
    write: Callable[[], Expressions]  # Writes the expressions, when they are first asked for
    state_names: tuple[str, ...]  # What each component is, for messages
    algebraic_names: tuple[str, ...]
    start: Floats  # shape (nx,); Differential states of the straight, relaxed filament at rest
    straight: Floats  # shape (nz,); Algebraic states of the straight filament: where the search for equilibrium begins
    x_kinds: tuple[str, ...]  # Block of each component: ``x``, ``y``, ``u``, ``v``, ``psi``, ``a_0``,
    z_kinds: tuple[str, ...]
    x_where: Floats  # X/L_0 of each component
    z_where: Floats
    x_places: tuple[int, ...]  # Number of the node or cell of each component
    z_places: tuple[int, ...]
    profiles: Mapping[str, tuple[float, float]]  # What each kind of plastic state is of a plastic strain a_0 + a_1 zeta

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
