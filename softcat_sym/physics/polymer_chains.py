"""Polymer chains in a fibre: their conformation A along and across it, stretched with it and relaxing by itself.

The chains of a fibre that keeps its volume have principal extensions A_i, each stretched with a power p_i of the
fibre's own stretch: A_i = exp(p_i eps - b_i), with eps the true strain of the fibre and b_i what relaxation has taken
of log A_i. Written this way the upper-convected law needs no rate of strain, A_i stays positive whatever a step of an
integrator does, and the stress is the derivative of a stored energy, as that of a spring is.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from softcat_sym.physics.sections import Section
from softcat_sym.physics.symbols import ONE, TIME, VISCOSITY, E, enter

_SOURCE = "Bird et al. 1987"

relaxation_time = enter("lambda_r", r"\lambda", TIME, "relaxation time of the chains", _SOURCE, positive=True)
solvent_viscosity = enter(
    "eta_sol", r"\eta_{sol}", VISCOSITY, "tensile viscosity of the solvent", _SOURCE, positive=True
)
extensibility = enter(
    "L2", "L^2", ONE, "trace of the conformation of a chain drawn out straight", "Bird et al. 1980", positive=True
)
mobility = enter("alpha_G", r"\alpha", ONE, "mobility factor of drag along the chains", "Giesekus 1982", positive=True)
destruction = enter(
    "eps_PTT", r"\epsilon_{PTT}", ONE, "share of a network's junctions that its stretch undoes", "Phan-Thien 1977",
    positive=True,
)  # fmt: skip
strain = enter("eps_c", r"\epsilon", ONE, "true strain of a fibre", "2.6")
trace = enter("tr_A", r"\mathrm{tr} A", ONE, "trace of the conformation", _SOURCE, positive=True)
spring_factor = enter("f_A", "f", ONE, "stiffening of the chains by their stretch", "Bird et al. 1980", positive=True)


@dataclass(frozen=True, slots=True)
class Direction:
    """A principal direction of the conformation."""

    name: str
    power: int  # A of it grows with this power of the fibre's stretch
    count: int  # How many directions are alike
    extension: sp.Symbol  # A
    taken: sp.Symbol  # b, what relaxation has taken of log A


def _direction(name: str, letter: str, power: int, count: int) -> Direction:
    words = {"along": "along a fibre", "across": "across a fibre", "width": "in the width of a sheet"}[name]
    return Direction(
        name,
        power,
        count,
        enter(f"A_{letter}", f"A_{letter}", ONE, f"conformation of the chains {words}", _SOURCE, positive=True),
        enter(f"b_{letter}", f"b_{letter}", ONE, f"what relaxation took of its logarithm {words}", _SOURCE),
    )


_ALONG = _direction("along", "z", 2, 1)
UNIAXIAL = (_ALONG, _direction("across", "r", -1, 2))
"""A fibre that is free to contract both ways."""
PLANE = (_ALONG, _direction("across", "t", -2, 1), _direction("width", "w", 0, 1))
"""A fibre of a sheet, which keeps its width: across is its thickness."""


def directions_of(section: Section) -> tuple[Direction, ...]:
    """Directions of the conformation in a section."""
    return PLANE if section.plane_strain else UNIAXIAL


@dataclass(frozen=True, slots=True)
class Chains:
    """What tells one law of polymer chains from another.

    Attributes
    ----------
    energy : sympy.Expr
        U of the trace: the stored energy is G/2 (U - log det A), zero at rest, and f = dU/dtr A.
    haste : sympy.Expr
        Y of the trace: how many times faster than at rest the chains relax.
    anisotropy : sympy.Expr
        alpha: how much faster per A_i - 1 relaxes what is drawn, by the lesser drag along stretched chains.
    relaxes : bool
        Whether the chains relax at all; otherwise they are a rubber.
    """

    energy: sp.Expr = trace - 3
    haste: sp.Expr = sp.S.One
    anisotropy: sp.Expr = sp.S.Zero
    relaxes: bool = True

    @property
    def spring_factor(self) -> sp.Expr:
        """Stiffening f of the trace, one at rest."""
        return sp.diff(self.energy, trace)

    def relaxation(self, extension: sp.Expr, factor: sp.Expr) -> sp.Expr:
        """Rate at which relaxation takes from log A_i: Y (f A_i - 1)(1 + alpha (A_i - 1))/(lambda A_i)."""
        if not self.relaxes:
            return sp.S.Zero
        haste = self.haste * (1 + self.anisotropy * (extension - 1))
        return haste * (factor - 1 / extension) / relaxation_time


OLDROYD_B = Chains()
FENE_P = Chains(energy=(extensibility - 3) * sp.log((extensibility - 3) / (extensibility - trace)))
GIESEKUS = Chains(anisotropy=mobility)
PTT = Chains(haste=1 + destruction * (trace - 3))


@dataclass(frozen=True, slots=True)
class ChainResponse:
    """The chains of one fibre."""

    directions: tuple[Direction, ...]
    extensions: tuple[sp.Expr, ...]  # A_i of the strain and the b_i
    trace: sp.Expr  # Of the A_i
    spring_factor: sp.Expr  # f of the trace
    stress: sp.Expr  # Of f and the A_i
    rates: tuple[sp.Expr, ...]  # b_i,t of f, the trace and the A_i
    dissipation: sp.Expr  # Per unit volume, of the same
    stored: sp.Expr  # Per unit volume, of the strain and the b_i; the stress is its derivative by the strain
    relaxes: bool

    @property
    def states(self) -> tuple[Direction, ...]:
        """Directions whose b_i is a state."""
        return self.directions if self.relaxes else ()

    def of_states(self, expression: sp.Expr) -> sp.Expr:
        """An expression of f, the trace and the A_i as one of the strain and the b_i."""
        known = {one.extension: value for one, value in zip(self.directions, self.extensions, strict=True)}
        return expression.xreplace({spring_factor: self.spring_factor}).xreplace({trace: self.trace}).xreplace(known)


def modulus() -> sp.Expr:
    """Shear modulus G = E/3 of chains that keep their volume."""
    return E / 3


def respond(section: Section, chains: Chains) -> ChainResponse:
    """Put the chains of a law into a fibre of a section."""
    directions = directions_of(section)
    extensions = tuple(sp.exp(one.power * strain - (one.taken if chains.relaxes else 0)) for one in directions)
    total = sp.Add(*(one.count * one.extension for one in directions))
    # -log det A: the powers of the stretch cancel, since the volume is kept.
    taken = sp.Add(*(one.count * one.taken for one in directions)) if chains.relaxes else sp.S.Zero
    rates = tuple(chains.relaxation(one.extension, spring_factor) for one in directions)
    lost = (one.count * (spring_factor * one.extension - 1) * rate for one, rate in zip(directions, rates, strict=True))
    drawn = sp.Add(*(sp.Rational(one.power * one.count, 2) * one.extension for one in directions))
    bare = ChainResponse(
        directions=directions,
        extensions=extensions,
        trace=total,
        spring_factor=chains.spring_factor,
        stress=modulus() * spring_factor * drawn,
        rates=rates,
        dissipation=modulus() / 2 * sp.Add(*lost),
        stored=chains.energy,
        relaxes=chains.relaxes,
    )
    return replace(bare, stored=modulus() / 2 * (bare.of_states(chains.energy) + taken))
