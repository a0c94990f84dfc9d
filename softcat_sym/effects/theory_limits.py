"""Limits of the theory for a scene, before it is run."""

from __future__ import annotations

import math
from collections.abc import Collection

from softcat_sym.effects.registry import REGISTRY
from softcat_sym.effects.temperature import cooling_time
from softcat_sym.estimates.expected_regime import ExpectedRegime, expected_regime
from softcat_sym.estimates.forecast import expected_sag, expected_strain, forecast, neck_draw
from softcat_sym.estimates.scaling import viscous_number
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.scene import Scene, groups_of, is_held

THICK = 0.1
"""h0/L above which the end zones, a thickness long at each end (Saint-Venant), fill more than a fifth of the span."""

# Standard deviation over d = h0/L or its square. First row: with shear and, for a law that yields, with fibres; _OWN is
# the error of the finite elements themselves, 0.04 %. Second row: without them, in either closure. _STOPPING holds near
# arrest, where the limit load of the hinges at the clamps decides.
_OWN, _FLOWING, _STOPPING = 4e-4, 0.7, 0.3
# Over h0/L and (1 - G_c/G)^2, G_c being the load of the plastic beam, and the most of it; as
# ``tests/studies/elements.py`` prints it.
_HINGES, _MAX_STOPPING = 0.09, 4.0
_PUBLISHED_FLOWING, _PUBLISHED_STOPPING = 0.6, 1.8

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


def theory_error(scene: Scene, effects: Collection[str], terms: Terms) -> float:
    """Return the relative error of a filament's height and pace against the continuum, its standard deviation.

    Fits allow for as much, and a run states it beside the error of its numbers.

    Parameters
    ----------
    scene : Scene
        Thickness over span, and whether the filament stops (3.12), decide.
    effects, terms : collection of str, Terms
        Effects in force, and the terms of the equations that they keep.

    Returns
    -------
    float
        The constants are those of clamped elastic, Maxwell and Bingham filaments of h0/L = 0.01 to 0.1 against
        plane-stress elements, as ``tests/slow/test_element_films.py`` prints them; other laws and ends are assumed to
        err by as much.
    """
    delta = groups_of(scene).delta
    return sum(part * delta**k for k, part in enumerate(error_by_slenderness(scene, effects, terms)))


def error_by_slenderness(scene: Scene, effects: Collection[str], terms: Terms) -> tuple[float, float, float]:
    """Coefficients of 1, h0/L and its square in :func:`theory_error`."""
    regime = expected_regime(scene, effects)
    number, limit = regime.gravity_number or 0.0, regime.arrest_exact
    stops = number > 0 and limit is not None and regime.name != "no-yield" and number < limit
    if terms.shear and (terms.resolved or not terms.yields):
        return (0.0, _stopping(number, regime.collapse), 0.0) if stops else (_OWN, 0.0, _FLOWING)
    return 0.0, _PUBLISHED_STOPPING if stops else _PUBLISHED_FLOWING, 0.0


def _stopping(number: float, collapse: float | None) -> float:
    """Error over h0/L of a filament that stops: largest near the load of the plastic beam, where its hinges decide."""
    beyond = 1 - (collapse or 0.0) / number
    return _STOPPING if beyond <= 0 else min(max(_STOPPING, _HINGES / beyond**2), _MAX_STOPPING)


def theory_limits(scene: Scene, effects: Collection[str], terms: Terms) -> tuple[str, ...]:
    """Warnings in words about the theory of a scene with these effects; empty if it should hold."""
    regime = expected_regime(scene, effects)
    stated = [words for effect in REGISTRY for words in effect.warnings(scene, forecast(scene))]
    sag, strain = expected_sag(scene), expected_strain(scene)
    shallow = printed = ""
    if scene.model == "small-deflection" and sag > SHALLOW:
        shallow = f"the small-deflection model is for sags well below the span, and {sag:.2g} L is expected"
    if scene.run.closure == "printed" and strain > COUNTERED:
        printed = f"the printed closure loses log s of its viscous tension, and a strain of {strain:.2g} is expected"
    found = (*stated, _thickness(scene, effects, terms), _rupture(scene, regime), _descent(regime), shallow, printed)
    return tuple(filter(None, found))


def _thickness(scene: Scene, effects: Collection[str], terms: Terms) -> str:
    """Warning about a filament that is not slender."""
    delta = groups_of(scene).delta
    if delta <= THICK:
        return ""
    left, when = theory_error(scene, effects, terms), " at the start" if scene.ends.motion else ""
    return (
        f"too thick for a filament: h0/L = {delta:.2g}{when}, so that the zones at the ends, a thickness long, fill "
        f"{min(1.0, 2 * delta):.0%} of the span; about {left:.0%} of the sag is uncertain"
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
    if threshold is None or number is None or number < threshold or regime.until:
        return ""
    return (
        f"it never stops (G = {number:.3g}, nothing rests beyond {threshold:.4g}): in a longer run it thins until "
        "beads or rupture, neither of which is in the theory, end it"
    )


PRINT_SPEED = 10e-3
"""Of a nozzle that lays strands [m/s]."""

_PRINTED = 2e-3
"""Thickness of the strands that nozzles lay at most [m]."""


def laying_note(scene: Scene, regime: str) -> str:
    """What a nozzle would change of a strand that the scene releases at once; empty if nothing by the accuracy.

    The time of laying counts where the strand changes meanwhile; what has arrested at every instant has not.
    """
    if scene.extrusion.present or is_spatial(scene) or not is_held(scene) or scene.filament.thickness > _PRINTED:
        return ""
    takes, lasting = scene.filament.span / PRINT_SPEED, scene.run.duration
    times = {
        "cools": cooling_time(scene) if scene.temperature.present else math.inf,
        "changes": lasting if scene.material.changes else math.inf,
        "creeps": lasting if regime in ("viscous", "descending") else math.inf,
    }
    how, within = min(times.items(), key=lambda one: one[1])
    if not takes > scene.run.accuracy * within < math.inf:
        return ""
    laid = f"a nozzle at {1e3 * PRINT_SPEED:g} mm/s lays it in {takes:.2g} s, in which it {how}"
    return f"{laid} ({within:.2g} s): [extrusion] follows that, released at once it sags otherwise"
