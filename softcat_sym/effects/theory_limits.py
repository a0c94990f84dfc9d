"""Limits of the theory for a scene, before it is run."""

from __future__ import annotations

from softcat_sym.effects.expected_regime import ExpectedRegime
from softcat_sym.effects.forecast import expected_sag, expected_strain, forecast, neck_draw
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.scaling_estimates import viscous_number
from softcat_sym.scene.scene import Scene, groups_of

THICK = 0.1
"""h0/L above which the end zones, a thickness long at each end (Saint-Venant), fill more than a fifth of the span."""

RESOLVED_PER_SLENDERNESS = 0.4
"""Relative error of the sag that every filament theory has, over h0/L: a filament with shear and fibres differs from
plane-stress elements in continual descent by 1.0, 0.6 and 0.3 % at h0/L = 0.03, 0.015 and 0.0075."""

DRAWN_OUT = 0.58
"""Expected strain of the necks (:func:`neck_draw`) above which a warning is given.

The paper's filament ruptures at expected strains of 0.67 (G = 0.4, V = 0.4: the paper's own), 0.63 (0.8, 3) and 2.2
(1.2, 2); it stops at 0.53 (0.4, 1; on 40 and on 80 cells), 0.25 (0.4, 3 and 0.25, 0.4) and 0.04 (0.8, 26). The limit
fails for G = 0.3, V = 0.4 (0.37), which stops on 160 cells and ruptures on 320.
"""

SHALLOW = 0.1
"""Sag over span beyond which a warning about the small-deflection model (2.13) is given: its strain omits a term of 2 %
of the slope's square there."""

COUNTERED = 0.2
"""Strain at which the printed closure has lost a fifth of its viscous tension, whose factor is 1 - log s (THEORY 4)."""


def theory_limits(scene: Scene, regime: ExpectedRegime) -> tuple[str, ...]:
    """Warnings in words; empty if the theory should hold."""
    stated = [words for effect in REGISTRY for words in effect.warnings(scene, forecast(scene))]
    found = (*stated, _thickness(scene), _rupture(scene, regime), _descent(regime), *_reductions(scene))
    return tuple(filter(None, found))


def _thickness(scene: Scene) -> str:
    """Warning about a filament that is not slender."""
    delta = groups_of(scene).delta
    if delta <= THICK:
        return ""
    left, when = RESOLVED_PER_SLENDERNESS * delta, " at the start" if scene.ends.motion else ""
    return (
        f"too thick for a filament: h0/L = {delta:.2g}{when}, so that the zones at the ends, a thickness long, fill "
        f"{min(1.0, 2 * delta):.0%} of the span; about {left:.0%} of the sag is uncertain (0.4 h0/L)"
    )


def _rupture(scene: Scene, regime: ExpectedRegime) -> str:
    """Warning about a filament that may rupture before it stops, as the elongation concentrates in two necks."""
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
        f"about {strain:.0%} (limit {DRAWN_OUT:.0%}); no filament theory is reliable there"
    )


def _descent(regime: ExpectedRegime) -> str:
    """Warning about a filament beyond the threshold of arrest, whose descent does not end in the theory."""
    threshold, number = regime.arrest_exact, regime.gravity_number
    if threshold is None or number is None or number < threshold:
        return ""
    return (
        f"it never stops (G = {number:.3g}, nothing rests beyond {threshold:.4g}): in a longer run it thins until "
        "beads or rupture, neither of which is in the theory, end it"
    )


def _reductions(scene: Scene) -> tuple[str, str]:
    """Warnings about the limits of the reduced model and of the printed closure."""
    sag, strain = expected_sag(scene), expected_strain(scene)
    shallow = printed = ""
    if scene.model == "small-deflection" and sag > SHALLOW:
        shallow = f"the small-deflection model is for sags well below the span, and {sag:.2g} L is expected"
    if scene.run.closure == "printed" and strain > COUNTERED:
        printed = f"the printed closure loses log s of its viscous tension, and a strain of {strain:.2g} is expected"
    return shallow, printed
