"""Where the theory itself ends: what can be said of a scene before it is run."""

from __future__ import annotations

import math

from softcat_sym.effects.expected_regime import ExpectedRegime
from softcat_sym.effects.forecast import expected_sag, expected_strain
from softcat_sym.effects.law import is_solid
from softcat_sym.effects.plastic_overshoot import neck_draw
from softcat_sym.effects.prediction import (
    effective_viscosity,
    instant_modulus,
    viscous_number,
    weight_stress,
    yield_stress_of,
)
from softcat_sym.scene import Scene, groups_of

SMALL = 0.1
"""Capillary numbers below which surface tension is nothing, as a finished run is judged."""

THICK = 0.1
"""h0/L above which the end zones, a thickness long at each end (Saint-Venant), fill more than a fifth of the span."""

RESOLVED_PER_SLENDERNESS = 0.4
"""What no filament theory has, of the sag per h0/L: 1.0, 0.6 and 0.3 % at h0/L = 0.03, 0.015 and 0.0075 is left
between a filament that shears, with fibres, and plane-stress elements in continual descent."""

DRAWN_OUT = 0.58
"""Strain expected of the necks (:func:`neck_draw`) beyond which a warning is given.

Of the paper's filament those rupture of which it is 0.67 (G = 0.4, V = 0.4: the paper's own), 0.63 (0.8, 3) and 2.2
(1.2, 2); those stop of which it is 0.53 (0.4, 1; alike on 40 and on 80 cells), 0.25 (0.4, 3 and 0.25, 0.4) and 0.04
(0.8, 26). It does not tell G = 0.3, V = 0.4 (0.37), which stops on 160 cells and ruptures on 320.
"""

SHALLOW = 0.1
"""Sag over span beyond which the small-deflection model (2.13) is not used: its strain leaves out 2 % of the slope's
square there."""

COUNTERED = 0.2
"""Strain at which the printed closure has lost a fifth of its viscous tension: 1 - log s of it is left (THEORY 4)."""


def theory_limits(scene: Scene, regime: ExpectedRegime) -> tuple[str, ...]:
    """Warnings in words; none where the theory should hold.

    Parameters
    ----------
    scene : Scene
        What is asked.
    regime : ExpectedRegime
        What it should show.
    """
    found = (_surface_tension(scene), _thickness(scene), _rupture(scene, regime), _descent(regime), *_reductions(scene))
    return tuple(filter(None, found))


def fastest(scene: Scene) -> float:
    """Largest mean speed of the midpoint over the run or a fourth, a sixteenth or a 64th of it, past the ramp [m/s]."""
    span, duration = scene.filament.span, scene.run.duration
    parts = {max(duration / share, min(scene.load.ramp, duration)) for share in (1, 4, 16, 64)}
    shorter = (scene.model_copy(update={"run": scene.run.model_copy(update={"duration": part})}) for part in parts)
    return max(expected_sag(part) * span / part.run.duration for part in shorter)


def _surface_tension(scene: Scene) -> str:
    """Gamma/(rho g R L) against the weight, 1/Ca against viscosity, gamma/(R E) against elasticity."""
    gamma, radius = scene.surroundings.surface_tension, scene.filament.thickness / 2
    if gamma == 0:
        return ""
    weight, viscosity, modulus = weight_stress(scene), effective_viscosity(scene), instant_modulus(scene)
    speed, limit = fastest(scene), yield_stress_of(scene)
    static = gamma / (radius * weight) if weight > 0 else math.inf
    dynamic = gamma / (viscosity * speed) if viscosity and speed > 0 else math.inf
    if min(static, dynamic) < SMALL or (is_solid(scene) and modulus and _is_stiff(scene, gamma, radius, modulus)):
        return ""
    numbers = [f"gamma/(rho g R L) = {static:.2g}", f"1/Ca = gamma/(eta U) = {dynamic:.2g}"]
    numbers += [f"gamma/(R E) = {gamma / (radius * modulus):.2g}"] if modulus else []
    numbers += [f"gamma/(R sigma_Y) = {gamma / (radius * limit):.2g}"] if limit else []
    ends = "; it would make the thread yield by itself" if limit and gamma > radius * limit else ""
    return f"surface tension is left out, but {', '.join(numbers)}: neither of the first two is below {SMALL}{ends}"


def _is_stiff(scene: Scene, gamma: float, radius: float, modulus: float) -> bool:
    """Whether the capillary strain is little beside that of stretching and of buckling."""
    return gamma / (radius * modulus) < SMALL * max(expected_strain(scene), groups_of(scene).delta ** 2)


def _thickness(scene: Scene) -> str:
    """A filament is slender."""
    delta = groups_of(scene).delta
    if delta <= THICK:
        return ""
    left, when = RESOLVED_PER_SLENDERNESS * delta, " at the start" if scene.ends.motion else ""
    return (
        f"too thick for a filament: h0/L = {delta:.2g}{when}, so that the zones at the ends, a thickness long, fill "
        f"{min(1.0, 2 * delta):.0%} of the span; about {left:.0%} of the sag is uncertain (0.4 h0/L)"
    )


def _rupture(scene: Scene, regime: ExpectedRegime) -> str:
    """A filament that stops may still lose its ends: the elongation of its fall gathers in two necks."""
    depth, gravity_number, viscous = regime.stopping_depth_exact, regime.gravity_number, viscous_number(scene)
    if depth is None or gravity_number is None or viscous is None or regime.name == "no-yield":
        return ""
    if gravity_number < (regime.collapse or 0.0):
        return ""
    sag = depth * (regime.overshoot or 1.0)
    strain = neck_draw(scene, gravity_number, viscous, sag)
    if strain <= DRAWN_OUT:
        return ""
    return (
        f"near rupture: its fall to {sag:.2g} L, while necks grow at sigma_Y/eta, draws the necks at the ends out by "
        f"{strain:.0%} or so (limit {DRAWN_OUT:.0%}); there no filament theory has a number to trust"
    )


def _descent(regime: ExpectedRegime) -> str:
    """Beyond the threshold of arrest nothing in the theory ends the descent."""
    threshold, number = regime.arrest_exact, regime.gravity_number
    if threshold is None or number is None or number < threshold:
        return ""
    return (
        f"it never stops (G = {number:.3g}, nothing rests beyond {threshold:.4g}): in a longer run it thins until "
        "surface tension or rupture, neither of which is in the theory, ends it"
    )


def _reductions(scene: Scene) -> tuple[str, str]:
    """What the reduced model and the printed closure cannot follow."""
    sag, strain = expected_sag(scene), expected_strain(scene)
    shallow = printed = ""
    if scene.model == "small-deflection" and sag > SHALLOW:
        shallow = f"the small-deflection model is for sags well below the span, and {sag:.2g} L is expected"
    if scene.run.closure == "printed" and strain > COUNTERED:
        printed = f"the printed closure loses log s of its viscous tension, and a strain of {strain:.2g} is expected"
    return shallow, printed
