"""The dimensionless groups and the time units of a scene (THEORY 5)."""

from __future__ import annotations

import math
from dataclasses import dataclass

from softcat_sym.scene.model import Scene
from softcat_sym.scene.shear_data import power


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
        rho g L/sY [3.10]; of a custom law with the stress below which nothing flows.
    V : float or None
        eta/(rho sqrt(g L^3)) [3.10]; with an index K/(rho g L (L/g)^(n/2)).
    eps_Y : float or None
        sY/E [3.9].
    tau_star : float or None
        V/E_star: relaxation time in units of sqrt(L/g), where the index is 1.
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
    modulus = _modulus(scene)
    return scene.filament.span * math.sqrt(scene.filament.density / modulus) if modulus is not None else 0.0


def _modulus(scene: Scene) -> float | None:
    """E [Pa]; of parallel modes their sum, of a standard linear solid the spring that always acts."""
    modes = scene.material.modes
    return sum(mode.youngs_modulus for mode in modes) if modes else scene.material.youngs_modulus


def _viscosity(scene: Scene) -> float | None:
    """Eta [Pa s], or K [Pa s^n]; of parallel modes their sum."""
    modes = scene.material.modes
    return sum(mode.viscosity for mode in modes) if modes else scene.material.viscosity


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
    modulus, viscosity, yields_at = _modulus(scene), _viscosity(scene), material.threshold or None
    stress, impulse = filament.density * scene.load.gravity * filament.span, _impulse(scene)
    slowness = None if viscosity is None or modulus is None else viscosity / modulus
    return Groups(
        delta=filament.thickness / filament.span,
        E_star=None if modulus is None else _ratio(modulus, stress),
        G=None if yields_at is None else stress / yields_at,
        V=None if viscosity is None else _ratio(viscosity, impulse),
        eps_Y=None if yields_at is None or modulus is None else yields_at / modulus,
        tau_star=None if slowness is None else _ratio(slowness, power(gravity_time(scene), material.index)),
        B=None if viscosity is None else impulse / (2 * viscosity),
    )


def _impulse(scene: Scene) -> float:
    """Scale of a viscosity, rho g L (L/g)^(n/2), written so that it has a limit without gravity."""
    filament, gravity, n = scene.filament, scene.load.gravity, scene.material.index
    if n == 1:
        return filament.density * math.sqrt(gravity * filament.span * filament.span * filament.span)
    if gravity == 0:
        return 0.0
    return filament.density * gravity * filament.span * power(filament.span / gravity, n / 2)


def _ratio(value: float, scale: float) -> float:
    return value / scale if scale > 0 else math.inf
