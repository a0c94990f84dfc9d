"""Inertia: momentum in the balance."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import Effect, OfMotion, always

INERTIA = Effect(
    name="inertia",
    summary="acceleration of the filament",
    source="2.1, 2.2",
    contribute=partial(replace, inertia=True),
    applies=always,
    without_it="",
    estimate=OfMotion("missed", "how far it lags behind its weight, or rings", "|y - y balanced| over the largest sag"),
    observable="lag behind the balanced sag: its jump, its pace against free fall, acceleration over gravity",
    example="maxwell-slow",
    derivation="01_balance",
)
