"""When a filament falls for ever, so that its run ends: it shows nothing new, in steps that grow ever shorter."""

from __future__ import annotations

import numpy as np

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.estimates.expected_regime import worst_gravity_number
from softcat_sym.physics import beams
from softcat_sym.physics.terms import Terms
from softcat_sym.scene.scene import Scene, is_held, rest_length
from softcat_sym.scene.tables import farthest
from softcat_sym.solvers.solution import Bounds

FALLEN = 10.0
"""Sag at which a filament between supports falls for ever, over its span or its rest length, whichever is longer.

It is then a thread of twenty times its length. The deepest bundled scene, drawn apart meanwhile, sags by 1.4 spans.
"""

DRAWN = 100.0
"""Stretch below which a section counts as not drawn out yet, though it does not come to rest.

At rest the section at X bears the weight between it and midspan at no more than the yield stress, so that its stretch
is at most sigma_Y/(rho g |X|), and what tension has drawn out it never shortens: a section beyond that limit, and a
tenth as thick as it was, is on its way to a thread. Where no catenary rests (3.12), the filament falls for ever;
elsewhere it has necked.
"""


def bounds_of(scene: Scene, terms: Terms, nodes: Floats) -> Bounds | None:
    """Where the run of a filament with nodes at these X/L ends; None where nothing says that it falls or necks.

    What has a free end hangs on one support and is drawn out by its own weight as far as its law allows: its run ends
    as a thread. Solids come to rest, and chains of polymers may hold what they are drawn to.
    """
    if scene.model != "filament" or not is_held(scene) or scene.material.spec.is_solid or terms.law.spec.has_chains:
        return None
    if not (terms.flows or terms.viscous):
        return None
    longest = max(scene.filament.span, rest_length(scene), farthest(scene))
    weight = worst_gravity_number(scene.at(scene.run.duration)) if terms.yields else None
    stretch = np.full(len(nodes) - 1, np.inf)
    # Of supports that move it is not known which of them draws a section out.
    if weight and not scene.ends.motion:
        stretch = np.maximum(DRAWN, 1 / (weight * np.maximum(np.abs(nodes[1:] + nodes[:-1]) / 2, 1e-9)))
    falls = weight is None or weight > beams.ARREST_THRESHOLD_EXACT
    return Bounds(FALLEN * longest / rest_length(scene), stretch, rest_length(scene), falls)
