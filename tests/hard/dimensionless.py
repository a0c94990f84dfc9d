"""Scenes from their dimensionless groups, on a span, density and gravity that are free: any two must agree."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import softcat_sym as sc

from ..acceptance.rheology import scene

PAPER = ("inertia", "bending", "finite-stretch", "thinning", "large-rotation")
STATIC = PAPER[1:]
STRING = STATIC[1:]


@dataclass(frozen=True)
class Scales:
    """Span [m], density [kg/m^3] and gravity [m/s^2]: what the groups leave open."""

    span: float = 1.0
    density: float = 1000.0
    gravity: float = 10.0

    @property
    def stress(self) -> float:
        """rho g L [Pa]."""
        return self.density * self.gravity * self.span

    @property
    def time(self) -> float:
        """sqrt(L/g) [s]."""
        return math.sqrt(self.span / self.gravity)


def asked(
    law: str,
    *,
    delta: float = 0.03,
    E: float | None = None,
    V: float | None = None,
    G: float | None = None,
    n: float | None = None,
    T: float = 10.0,
    ramp: float = 0.0,
    frames: int = 101,
    accuracy: float = 1e-3,
    effects: str | tuple[str, ...] = "auto",
    closure: str = "material",
    ends: Mapping[str, Any] | None = None,
    filament: Mapping[str, Any] | None = None,
    initial: Mapping[str, Any] | None = None,
    material: Mapping[str, Any] | None = None,
    numerics: Mapping[str, Any] | None = None,
    model: str = "filament",
    scales: Scales | None = None,
) -> sc.Scene:
    """A scene; E = E/(rho g L), V = eta/(rho sqrt(g L^3)), G = rho g L/sY, times in sqrt(L/g), lengths in L."""
    unit = scales or Scales()
    constants: dict[str, Any] = {"law": law}
    if E is not None:
        constants["youngs_modulus"] = E * unit.stress
    if V is not None:
        constants["viscosity"] = V * unit.stress * unit.time ** (1.0 if n is None else n)
    if n is not None:
        constants["index"] = n
    if G is not None:
        constants["yield_stress"] = unit.stress / G
    for name, value in (material or {}).items():
        constants[name] = _modes(value, unit) if name == "modes" else value * unit.stress
    body: dict[str, Any] = {"span": unit.span, "thickness": delta * unit.span, "density": unit.density}
    for name, value in (filament or {}).items():
        body[name] = value * unit.span if name in ("rest_length", "width") else value
    held = dict(ends or {})
    if "drop" in held:
        held["drop"] *= unit.span
    if "motion" in held:
        held["motion"] = [(t * unit.time, x * unit.span, y * unit.span) for t, x, y in held["motion"]]
    made = scene(
        constants,
        body,
        effects=effects,
        ends=held,
        initial=initial,
        load={"gravity": unit.gravity, "ramp": ramp * unit.time},
        run={"duration": T * unit.time, "frames": frames, "accuracy": accuracy, "closure": closure},
    )
    return made.replace({"model": model, "numerics": dict(numerics or {})})


def _modes(modes: list[tuple[float, float]], unit: Scales) -> list[dict[str, float]]:
    """Pairs of E/(rho g L) and relaxation time in sqrt(L/g)."""
    return [{"youngs_modulus": E * unit.stress, "viscosity": E * unit.stress * tau * unit.time} for E, tau in modes]
