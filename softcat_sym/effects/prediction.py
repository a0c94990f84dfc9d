"""How far a scene will sag, roughly: the smallest of free fall, elastic and flowing estimates (THEORY 5-7, 11)."""

from __future__ import annotations

import math

from softcat_sym.equations import regimes
from softcat_sym.equations.section import SECTIONS
from softcat_sym.scene import Scene, gravity_time, groups_of


def duration_star(scene: Scene) -> float:
    """Duration of the run in units of sqrt(L/g); zero without gravity."""
    return scene.run.duration / gravity_time(scene)


def beam_of(scene: Scene) -> regimes.Beam:
    """The straight beam between the scene's ends."""
    first, second = sorted((scene.ends.left, scene.ends.right))
    return regimes.BEAMS[first, second]


def bending_stiffness(scene: Scene) -> float:
    """K delta^2 over the sag factor C of the beam: the linear beam sags by 1/(this E*), or t*/(this V) (2.18)."""
    shape = SECTIONS[scene.filament.section]
    return float(regimes.gyration(shape) / beam_of(scene).midspan_sag) * groups_of(scene).delta ** 2


def first_yield_gravity_number(scene: Scene) -> float:
    """G below which no fibre yields under a slowly applied weight: 2 delta for a clamped rectangle (3.11)."""
    threshold = regimes.first_yield(SECTIONS[scene.filament.section], beam_of(scene))
    return float(threshold.subs(regimes.delta, groups_of(scene).delta))


def smaller_of(bending: float, stretching: float) -> float:
    """Harmonic mean of two sags, never above the smaller: where one resistance rules it is that one's sag."""
    return 1 / (1 / bending + 1 / stretching) if bending > 0 and stretching > 0 else 0.0


def elastic_sag(scene: Scene) -> float:
    """Static sag over span of the elastic filament: linear beam and elastic cable together (THEORY 11)."""
    groups = groups_of(scene)
    if groups.E_star is None or not math.isfinite(groups.E_star):
        return 0.0
    return smaller_of(1 / (bending_stiffness(scene) * groups.E_star), (3 / (64 * groups.E_star)) ** (1 / 3))


def flowing_sag(scene: Scene) -> float:
    """Sag over span that flow adds by the end of the run: viscous beam and string, up to H_stop (3.13)."""
    groups = groups_of(scene)
    if groups.V is None or (groups.G is not None and groups.G < first_yield_gravity_number(scene)):
        return 0.0
    time = duration_star(scene)
    if time == 0:
        return 0.0
    flowing = smaller_of(time / (bending_stiffness(scene) * groups.V), (9 * time / (128 * groups.V)) ** (1 / 3))
    if groups.G is None or float(regimes.ARREST_THRESHOLD) <= groups.G:
        return flowing
    return min(flowing, float(regimes.STOPPING_DEPTH.right.subs(regimes.G, groups.G)))


def predicted_sag(scene: Scene) -> float:
    """Sag over span at the end of the run, no further than free fall goes."""
    fall = duration_star(scene) ** 2 / 2
    return min(fall, elastic_sag(scene) + flowing_sag(scene))


def predicted_strain(scene: Scene) -> float:
    """Mean stretch minus one of a parabola of the predicted sag: (8/3) (H/L)^2."""
    return 8 / 3 * predicted_sag(scene) ** 2
