"""The dimensionless groups and the time units of a scene (THEORY 5)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from softcat_sym.scene.model import Scene


@dataclass(frozen=True, slots=True)
class Groups:
    """Dimensionless groups of a scene; None where the law has no such constant.

    Attributes
    ----------
    delta : float
        Thickness over span.
    E_star : float or None
        E/(rho g L).
    G : float or None
        rho g L/sY [3.10].
    V : float or None
        eta/(rho sqrt(g L^3)) [3.10].
    eps_Y : float or None
        sY/E [3.9].
    tau_star : float or None
        V/E_star: relaxation time in units of sqrt(L/g).
    B : float or None
        1/(2 V).
    """

    delta: float
    E_star: float | None
    G: float | None
    V: float | None
    eps_Y: float | None
    tau_star: float | None
    B: float | None


def gravity_time(scene: Scene) -> float:
    """Return sqrt(L/g).

    Parameters
    ----------
    scene : Scene
        Any scene.

    Returns
    -------
    float
        In s; infinite without gravity.
    """
    gravity = scene.load.gravity
    return math.sqrt(scene.filament.span / gravity) if gravity > 0 else math.inf


def elastic_time(scene: Scene) -> float:
    """Return L sqrt(rho/E).

    Parameters
    ----------
    scene : Scene
        Any scene.

    Returns
    -------
    float
        In s; zero for a law without a modulus, which is infinitely stiff.
    """
    modulus = scene.material.youngs_modulus
    return scene.filament.span * math.sqrt(scene.filament.density / modulus) if modulus is not None else 0.0


def groups_of(scene: Scene) -> Groups:
    """Compute the dimensionless groups [3.9, 3.10].

    Parameters
    ----------
    scene : Scene
        Any scene.

    Returns
    -------
    Groups
        Without gravity the groups take their limits: E_star and V infinite, G, B and tau_star zero.
    """
    filament, material = scene.filament, scene.material
    modulus, viscosity, yields_at = material.youngs_modulus, material.viscosity, material.yield_stress
    stress, time = filament.density * scene.load.gravity * filament.span, gravity_time(scene)
    # rho g L sqrt(L/g), written so that it has a limit without gravity.
    impulse = filament.density * math.sqrt(scene.load.gravity * filament.span * filament.span * filament.span)
    return Groups(
        delta=filament.thickness / filament.span,
        E_star=None if modulus is None else _ratio(modulus, stress),
        G=None if yields_at is None else stress / yields_at,
        V=None if viscosity is None else _ratio(viscosity, impulse),
        eps_Y=None if yields_at is None or modulus is None else yields_at / modulus,
        tau_star=None if viscosity is None or modulus is None else _ratio(viscosity / modulus, time),
        B=None if viscosity is None else impulse / (2 * viscosity),
    )


def _ratio(value: float, scale: float) -> float:
    return value / scale if scale > 0 else math.inf
