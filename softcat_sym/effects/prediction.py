"""How far a scene will sag, roughly: the smallest of free fall, elastic and flowing estimates (THEORY 5-7, 11)."""

from __future__ import annotations

import math

from softcat_sym.equations.section import SECTIONS
from softcat_sym.scene import Scene, gravity_time, groups_of


def duration_star(scene: Scene) -> float:
    """Duration of the run in units of sqrt(L/g); zero without gravity."""
    return scene.run.duration / gravity_time(scene)


def radius_of_gyration_squared(scene: Scene) -> float:
    """K = I/(A h0^2): 1/12 for a rectangle, 1/16 for a circle (2.18)."""
    return float(SECTIONS[scene.filament.section].zeta_squared) / 4


def beam_constant(scene: Scene) -> float:
    """C in sag = rho g A L^4/(C E I): 384 between clamps, 384/5 between pins, 1/0.0054 = 185 for one of each."""
    ends = sorted((scene.ends.left, scene.ends.right))
    return {("clamped", "clamped"): 384.0, ("clamped", "pinned"): 184.6, ("pinned", "pinned"): 76.8}[(ends[0], ends[1])]


def first_yield_gravity_number(scene: Scene) -> float:
    """G below which no fibre yields under a slowly applied weight: 2 delta for a clamped rectangle (3.11).

    Largest static moment q L^2/12 between clamps, q L^2/8 otherwise; yield at M = sigma_Y I/(h0/2).
    """
    delta = groups_of(scene).delta
    moment = 1 / 12 if (scene.ends.left, scene.ends.right) == ("clamped", "clamped") else 1 / 8
    return 2 * radius_of_gyration_squared(scene) * delta / moment


def smaller_of(bending: float, stretching: float) -> float:
    """Sag that bending and stretching resist together: H/bending + (H/stretching)^3 = 1, to its leading orders."""
    return 1 / (1 / bending + 1 / stretching) if bending > 0 and stretching > 0 else 0.0


def elastic_sag(scene: Scene) -> float:
    """Static sag over span of the elastic filament: linear beam and elastic cable together (THEORY 11)."""
    groups = groups_of(scene)
    if groups.E_star is None or not math.isfinite(groups.E_star):
        return 0.0
    stiffness = beam_constant(scene) * radius_of_gyration_squared(scene) * groups.delta**2
    return smaller_of(1 / (stiffness * groups.E_star), (3 / (64 * groups.E_star)) ** (1 / 3))


def flowing_sag(scene: Scene) -> float:
    """Sag over span that flow adds by the end of the run: viscous beam and string, up to H_stop (3.13)."""
    groups = groups_of(scene)
    if groups.V is None or (groups.G is not None and groups.G < first_yield_gravity_number(scene)):
        return 0.0
    time = duration_star(scene)
    if time == 0:
        return 0.0
    stiffness = beam_constant(scene) * radius_of_gyration_squared(scene) * groups.delta**2
    flowing = smaller_of(time / (stiffness * groups.V), (9 * time / (128 * groups.V)) ** (1 / 3))
    if groups.G is None or groups.G >= math.sqrt(2):
        return flowing
    u = 1 / (2 * groups.G)
    return min(flowing, u - math.sqrt(u * u - 1 / 8))


def predicted_sag(scene: Scene) -> float:
    """Sag over span at the end of the run, no further than free fall goes."""
    fall = duration_star(scene) ** 2 / 2
    return min(fall, elastic_sag(scene) + flowing_sag(scene))


def predicted_strain(scene: Scene) -> float:
    """Mean stretch minus one of a parabola of the predicted sag: (8/3) (H/L)^2."""
    return 8 / 3 * predicted_sag(scene) ** 2
