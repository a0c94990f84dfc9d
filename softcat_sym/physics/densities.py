"""What an effect adds to a filament beside its section: energies and Rayleigh potentials of a unit of rest length.

The force on the centreline is their Euler-Lagrange derivative, f = L_q - d/dX L_{q_X} - d/dt L_{q_t} - R_{q_t} +
d/dX R_{q_Xt} with L = T - W.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import sympy as sp

from softcat_sym.physics import symbols as sy
from softcat_sym.physics.constitutive_laws import Constant
from softcat_sym.physics.necking import aspect

_OF_A_POINT = (sy.x, sy.y, sy.x_t, sy.y_t, sy.X)
_OF_A_CELL = (sy.x_X, sy.y_X, sy.x_Xt, sy.y_Xt)
_GIVEN = (aspect, sy.t, sy.g_t, sy.A0, sy.h0, sy.rho, sy.g, sy.L_0)
_RATES = (sy.x_t, sy.y_t, sy.x_Xt, sy.y_Xt)


@dataclass(frozen=True, slots=True)
class Densities:
    """Energy and Rayleigh potential of the place, the tangent and their rates, as one effect adds them."""

    name: str  # Of the effect
    stored: sp.Expr = sp.S.Zero  # W(x, y, x_X, y_X, s, X, t) [J/m]
    dissipation: sp.Expr = sp.S.Zero  # R(..., x_t, y_t, x_Xt, y_Xt) [W/m], half of the power lost where quadratic
    kinetic: sp.Expr = sp.S.Zero  # T(x_X, y_X, s, x_t, y_t) [J/m], quadratic in the velocity
    constants: tuple[Constant, ...] = ()
    carried: sp.Expr = sp.S.Zero  # Velocity to the right of what dissipates: its power is external work [m/s]

    def __post_init__(self) -> None:
        known = {*_OF_A_POINT, *_OF_A_CELL, *_GIVEN, sy.s, *(one.symbol for one in self.constants)}
        if unknown := self._symbols - known:
            names = ", ".join(sorted(map(str, unknown)))
            raise ValueError(f"the densities of {self.name!r} hold {names}, which no filament has")
        if self.stored.free_symbols & set(_RATES):
            raise ValueError(f"the stored energy of {self.name!r} depends on rates")
        # Euler's theorem; simplifying takes long, and most need none.
        excess = sp.expand(sum(rate * sp.diff(self.kinetic, rate) for rate in _RATES[:2]) - 2 * self.kinetic)
        if self.kinetic.free_symbols & set(_RATES[2:]) or (excess != 0 and sp.simplify(excess) != 0):
            raise ValueError(f"the kinetic energy of {self.name!r} is not quadratic in the velocity")

    @property
    def _symbols(self) -> set[sp.Basic]:
        return {*self.stored.free_symbols, *self.dissipation.free_symbols, *self.kinetic.free_symbols}

    @property
    def label(self) -> str:
        """The name where it is part of another."""
        return self.name.replace("-", "_")

    @property
    def signature(self) -> tuple[str, ...]:
        """All that its expressions depend on, as text."""
        expressions = (self.stored, self.dissipation, self.kinetic)
        return (self.name, *map(sp.srepr, expressions), *(one.name for one in self.constants))

    @property
    def of_a_cell(self) -> bool:
        """Whether the tangent stands in them: they belong to a cell then, otherwise to a node."""
        return bool(self._symbols & {*_OF_A_CELL, sy.s})

    @property
    def symmetric(self) -> bool:
        """Whether a symmetric filament stays so."""
        turned = {one: -one for one in (sy.x, sy.x_t, sy.X, sy.y_X, sy.y_Xt)}
        given = (self.stored, self.dissipation, self.kinetic)
        return all(sp.expand(one - one.subs(turned, simultaneous=True)) == 0 for one in given)

    def of(self, stretch: sp.Expr) -> Densities:
        """The same with the stretch as a function of the tangent."""
        return self._with({sy.s: stretch})

    @property
    def level(self) -> Densities:
        """Of small slope: what depends on the velocity sees a level, unstretched centreline."""
        flat = self._with({sy.s: sp.S.One, sy.x_X: sp.S.One, sy.y_X: sp.S.Zero})
        return replace(flat, stored=self.stored)

    @property
    def at_rest(self) -> Densities:
        """Without what depends on rates."""
        return replace(self, dissipation=sp.S.Zero, kinetic=sp.S.Zero)

    def _with(self, values: dict[sp.Symbol, sp.Expr]) -> Densities:
        return replace(
            self,
            stored=self.stored.subs(values),
            dissipation=self.dissipation.subs(values),
            kinetic=self.kinetic.subs(values),
        )


def outer_force(densities: Iterable[Densities], stretch: sp.Expr) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """What they add, (horizontal, vertical): to the force on a unit of rest length, and to the internal force."""
    both = [one.of(stretch) for one in densities]

    def total(place: sp.Symbol, rate: sp.Symbol) -> sp.Expr:
        return sp.Add(*(sp.diff(one.stored - one.kinetic, place) + sp.diff(one.dissipation, rate) for one in both))

    outer = -total(sy.x, sy.x_t), -total(sy.y, sy.y_t)
    return outer, (total(sy.x_X, sy.x_Xt), total(sy.y_X, sy.y_Xt))


def outer_momentum(densities: Iterable[Densities], stretch: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Momentum (horizontal, vertical) per unit of rest length of what moves with the filament, T_v."""
    kinetic = sp.Add(*(one.of(stretch).kinetic for one in densities))
    return sp.diff(kinetic, sy.x_t), sp.diff(kinetic, sy.y_t)
