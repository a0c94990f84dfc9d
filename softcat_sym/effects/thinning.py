"""Thinning: area and thickness shrink as the filament stretches."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, OfMotion, let_down, of_large_deflections
from softcat_sym.scene.dimensions import needs_section_angles

THINNING = Effect(
    name="thinning",
    summary="A = A0/s, h = h0/sqrt(s), of a sheet h0/s",
    source="2.9",
    contribute=partial(replace, thins=True),
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=OfMotion(
        "strain",
        "stiffness lost as the section thins",
        "half the mean strain",
        amplified=True,
        factor=0.5,
        without=let_down,
    ),
    needs=("extensibility",),
    observable="mean strain, and ringing of the midpoint",
    example="continual-descent",
    derivation="02_section_and_closures",
    causes=("slopes",),
    indispensable=needs_section_angles,
)
