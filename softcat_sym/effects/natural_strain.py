"""Natural strain: the material is without stress at another strain as it dries, cures or cools, and curls if unevenly.

It is the same along and across the filament, so that the section shrinks, too; its mass stays.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from softcat_sym.effects.effect import Effect, Estimate, Motion
from softcat_sym.physics import symbols as sy
from softcat_sym.physics.clocks import Clock
from softcat_sym.physics.filament import Terms
from softcat_sym.physics.histories import varying
from softcat_sym.physics.laws import Constant
from softcat_sym.scene.scene import Scene

# Of the strain at the top less that at the bottom the top has half, beyond the mean.
_STRAINS = (("natural_strain", sy.n_0, sy.n_0_t, 1), ("natural_strain_difference", sy.n_1, sy.n_1_t, sp.Rational(1, 2)))


def _clock(scene: Scene) -> Clock:
    histories, replaces, constants = (
        scene.material.natural_strains(),
        list[tuple[sp.Symbol, sp.Expr]](),
        list[Constant](),
    )
    for name, strain, rate, share in _STRAINS:
        found = varying(histories[name], name) if name in histories else None
        replaces += (
            [(strain, found.value * share), (rate, found.rate * share)]
            if found
            else [(strain, sp.S.Zero), (rate, sp.S.Zero)]
        )
        constants += found.constants if found else ()
    return Clock("natural-strain", tuple(replaces), tuple(constants))


def _adapted(scene: Scene, terms: Terms) -> Terms:
    return replace(terms, clocks=(*terms.clocks, _clock(scene)), shrinks=True)


def _applies(scene: Scene) -> bool:
    return bool(scene.material.natural_strains())


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    del scene, motion
    return Estimate(1.0, "TODO")


NATURAL_STRAIN = Effect(
    name="natural-strain",
    summary="strain at which the material is without stress, that changes in time, more at the top or at the bottom",
    source="Timoshenko 1925",
    adapt=_adapted,
    applies=_applies,
    without_it="the scene states no material.natural_strain",
    estimate=_estimate,
    observable="TODO",
    example="solvent-cast-strand",
    derivation="21_curing",
    in_paper=False,
)
