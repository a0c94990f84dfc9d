"""Clocks of a material: constants of its law that change while the filament hangs, and the states they follow."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from softcat_sym.physics.constitutive_laws import Constant


@dataclass(frozen=True, slots=True)
class State:
    """What a clock follows at every point of a section; nothing at the start."""

    name: str  # Of what a run stores of it, its mean over the section
    symbol: sp.Symbol  # Change since the start
    shown: sp.Symbol  # What it is a change of, and that in terms of the change
    value: sp.Expr
    rate: sp.Expr  # [1/s], of the flow there


@dataclass(frozen=True, slots=True)
class Clock:
    """What an effect makes of constants of the material.

    Attributes
    ----------
    name : str
        Of its effect.
    replaces : tuple of (symbol, expression)
        Constants of the law, and what stands for them: an expression in ``t`` [s], in the clock's own constants and in
        the constants themselves as the scene states them.
    constants : tuple of Constant
        Its own.
    grows : tuple of (symbol, symbol)
        Moduli of the law that springs without stress join, and what stands for the rate of that over the modulus.
    state : State or None
        Of every point of a section, on which what it replaces depends.
    """

    name: str
    replaces: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    constants: tuple[Constant, ...] = ()
    grows: tuple[tuple[sp.Symbol, sp.Symbol], ...] = ()
    state: State | None = None
