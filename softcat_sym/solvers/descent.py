"""When a filament falls for ever, so that its run ends: it shows nothing new, in steps that grow ever shorter."""

from __future__ import annotations

import math

from softcat_sym.effects.expected_regime import worst_gravity_number
from softcat_sym.effects.law import is_solid
from softcat_sym.physics import beams
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.parts import farthest
from softcat_sym.scene.scene import Scene, is_held, rest_length
from softcat_sym.solvers.solution import Bounds

FALLEN = 10.0
"""Sag at which a filament between supports falls for ever, over its span or its rest length, whichever is longer.

It is then a thread of twenty times its length. The deepest bundled scene, drawn apart meanwhile, sags by 1.4 spans.
"""

DRAWN = 100.0
"""Stretch from which a filament beyond the threshold of arrest (3.12) does not come back.

At rest the section at X bears the weight between it and midspan at no more than the yield stress, so that its stretch
is at most sigma_Y/(rho g |X|); and what tension has drawn out it never shortens. Beyond the threshold that is 1.5 at
the supports, and a stretch of 100 is possible only within 0.8 % of the span from midspan.
"""


def bounds_of(scene: Scene, terms: Terms) -> Bounds | None:
    """Where the run of a filament ends as one that falls for ever; None where nothing says that it does.

    What has a free end hangs on one support and is drawn out by its own weight as far as its law allows: its run ends
    as a thread. Solids come to rest, and chains of polymers may hold what they are drawn to.
    """
    if scene.model != "filament" or not is_held(scene) or is_solid(scene) or terms.law.has_chains:
        return None
    if not (terms.flows or terms.viscous):
        return None
    longest = max(scene.filament.span, rest_length(scene), farthest(scene))
    final = scene.at(scene.run.duration)
    weight = worst_gravity_number(final) if terms.yields else None
    never = weight is not None and weight > beams.ARREST_THRESHOLD_EXACT
    return Bounds(FALLEN * longest / rest_length(scene), DRAWN if never else math.inf)
