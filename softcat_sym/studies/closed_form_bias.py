"""How far the closed forms for modulus and viscosity are off on real filaments: (2.22), the sag, the cable.

Noise-free full-model Maxwell filaments are read and inverted as a film would be. The sag counts as known to a
thousandth of its final value, as on a film a thousand pixels high; without a floor the reading would follow an
oscillation down to rounding, where no camera sees it.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from itertools import product

import numpy as np

from softcat_sym.fitting.closed_form import ClosedForm, Constants, closed_form
from softcat_sym.fitting.features import Features, read_features
from softcat_sym.scene.reading import load_scene
from softcat_sym.simulate import recalled

SLENDERNESS = (0.001, 0.0025, 0.01)
LOADS = (1e-6, 1e-5, 1e-4, 1e-3)
RELAXATION = (0.035, 0.1, 0.35, 1.0, 3.0)

FORMULAS = ("(2.22)", "sag", "cable")
"""Of the modulus."""

RESOLUTION = 1e-3
"""Standard error of a frame over the final sag."""

TOLERANCE = 0.1
"""Bias that is called small."""

_FRAMES, _DURATION = 1001, 20.0


@dataclass(frozen=True, eq=False)
class BiasPoint:
    """One filament."""

    delta: float  # Slenderness, load over viscosity, relaxation time over sqrt(L/g)
    B: float
    tau_star: float
    outcome: str  # Of the run
    features: Features  # As read
    closed: ClosedForm  # As inverted
    modulus: dict[str, float]  # Bias E/E_true - 1 by each of `FORMULAS`; NaN where it gives nothing
    viscosity: float  # Bias of eta by the 1/3 law; NaN where the film does not show it


def closed_form_bias(
    told: Callable[[str], None],
    slenderness: tuple[float, ...] = SLENDERNESS,
    loads: tuple[float, ...] = LOADS,
    relaxation: tuple[float, ...] = RELAXATION,
) -> tuple[BiasPoint, ...]:
    """Run, read and invert a grid of filaments, by the paper's effects."""
    return tuple(_point(*place, told) for place in product(slenderness, loads, relaxation))


def _point(delta: float, load: float, tau_star: float, told: Callable[[str], None]) -> BiasPoint:
    told(f"delta = {delta:g}, B = {load:g}, tau* = {tau_star:g}")
    changes: dict[str, object] = {
        "groups.delta": delta,
        "groups.B": load,
        "groups.tau": tau_star,
        "groups.duration": _DURATION,
        "run.frames": _FRAMES,
        "run.effects": "paper",
        "numerics.estimate": False,
    }
    run = recalled(load_scene("maxwell-slow", changes))
    scene = run.scene
    time, midpoint = run.data.time.values, run.data.midpoint.values
    std = np.full_like(midpoint, RESOLUTION * abs(midpoint[-1]))
    features = read_features(time, midpoint, std, scene.load.gravity, scene.filament.span)
    closed = closed_form(features, scene.filament.density)
    true_modulus, true_viscosity = scene.material.youngs_modulus, scene.material.viscosity
    if true_modulus is None or true_viscosity is None:
        raise ValueError("a Maxwell scene has a modulus and a viscosity")
    found: dict[str, Constants | None] = {
        "(2.22)": closed.paper or closed.ringing,
        "sag": closed.from_sag,
        "cable": closed.from_cable,
    }
    by_law = features.prefactor.value
    return BiasPoint(
        delta,
        load,
        tau_star,
        run.outcome.name,
        features,
        closed,
        {name: one.youngs_modulus / true_modulus - 1 if one else math.nan for name, one in found.items()},
        load / by_law - 1 if by_law else math.nan,
    )
