"""The regime of a run, by what the run shows (THEORY 7)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

import numpy as np

from softcat_sym.effects import Effects
from softcat_sym.effects.law import is_solid
from softcat_sym.effects.prediction import effective_viscosity, yield_stress_of
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene

Regime = Literal[
    "no-yield", "arrested-overdamped", "arrested-underdamped", "descending", "viscous", "elastic", "shaken"
]

ARREST_RATE = 0.5
"""Arrested: the plastic rate stays below this fraction of sigma_Y/eta, in every fibre ...

The hinges at the clamps are the last to stop: in the paper's overdamped arrest they still flow at 0.25 sigma_Y/eta at
t~ = 460 (N = 320), in its continual descent at 2.
"""

ARREST_TIME = 0.1
"""... over this last fraction of the run."""

TURNED_BACK = 0.05
"""Underdamped: the midpoint came back up by more than this fraction of its largest sag."""


def regime_of(scene: Scene, effects: Effects, fields: Mapping[str, Floats], midpoint: Floats) -> Regime:
    """Name the regime.

    Under shaken gravity a filament that has yielded never comes to rest: it is "descending" where it flows on in the
    last tenth and the last period, and otherwise "shaken", of which nothing more is claimed.

    Parameters
    ----------
    fields : mapping of str to ndarray
        ``plastic_rate``, ``yielded_fraction``, ``stress_mean``, ``stress_bending`` (frames, cells),
        ``energy_dissipated`` (frames,).
    midpoint : ndarray, shape (frames,)
        Height of the midpoint [m].
    """
    if is_solid(scene):
        return "elastic"
    if not {"viscous-flow", "viscous-stress"} & set(effects.names):
        limit = yield_stress_of(scene)
        stress = np.abs(fields["stress_mean"]) + np.abs(fields["stress_bending"])
        return "no-yield" if limit is not None and float(np.max(stress)) < limit else "elastic"
    if "yielding" not in effects.names:
        return "viscous"
    # What has yielded between two frames has dissipated; but so has a loss below yield.
    lost = np.any(fields["energy_dissipated"] > 0) and "solid-damping" not in effects.names
    if not np.any(fields["yielded_fraction"] > 0) and not lost:
        return "no-yield"
    if not is_arrested(scene, fields["plastic_rate"]):
        return "descending"
    if scene.load.shake > 0:
        return "shaken"
    return "arrested-underdamped" if turned_back(midpoint) > TURNED_BACK else "arrested-overdamped"


def is_arrested(scene: Scene, plastic_rate: Floats) -> bool:
    """Whether flow has died out: see :data:`ARREST_RATE` and :data:`ARREST_TIME`."""
    pace = _pace(scene)
    if not pace:
        return False
    frames, share = len(plastic_rate), ARREST_TIME
    if scene.load.shake > 0:
        share = min(1.0, max(share, 1 / (scene.load.shake_frequency * scene.run.duration)))
    last = plastic_rate[min(frames - 1, int((1 - share) * (frames - 1))) :]
    return bool(np.max(last) < ARREST_RATE * pace)


def _pace(scene: Scene) -> float:
    """Plastic strain rate at an overstress as large as the yield stress [1/s]: sigma_Y/eta, (sigma_Y/K)^(1/n)."""
    yield_stress, viscosity = yield_stress_of(scene), effective_viscosity(scene)
    if not yield_stress or not viscosity:
        return 0.0
    material = scene.material
    if material.viscosity is None:
        return yield_stress / viscosity
    return float((yield_stress / material.viscosity) ** (1 / material.index))


def turned_back(midpoint: Floats) -> float:
    """Largest rise of the midpoint after it had been lower, relative to its largest sag."""
    sag = -midpoint
    deepest = np.maximum.accumulate(sag)
    return float(np.max(deepest - sag) / np.max(sag)) if np.max(sag) > 0 else 0.0
