"""Finite stretch: true strain log s and the curvature theta_s of the stretched centreline."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from softcat_sym.effects.effect import SMALL_MODEL, Effect, OfMotion, let_down, of_large_deflections
from softcat_sym.scene.dimensions import needs_section_angles

FINITE_STRETCH = Effect(
    name="finite-stretch",
    summary="true strain log s instead of s - 1",
    source="2.6",
    contribute=partial(replace, finite=True),
    applies=of_large_deflections,
    without_it=SMALL_MODEL,
    estimate=OfMotion(
        "strain",
        "difference of true strain and engineering strain",
        "0.4 of the mean strain",
        amplified=True,
        factor=0.4,
        without=let_down,
    ),
    needs=("extensibility",),
    observable="mean strain, and ringing of the midpoint",
    example="continual-descent",
    derivation="02_section_and_closures",
    causes=("slopes",),
    indispensable=needs_section_angles,
)
