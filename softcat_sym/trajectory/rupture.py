"""States that no filament survives: drawn out to a thread, or holding more energy than anything gave it."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene
from softcat_sym.scene.laws import SOLIDS

THREAD = 1000.0
"""Stretch beyond which only a thread is left of a fluid: a thirtieth of the thickness, and nothing of the theory."""

STRONGEST = math.e
"""Stretch at which a bar of true strain is strongest, A0 E log(s)/s: an elastic solid drawn further runs away."""

_GIFT = 0.2
"""Share by which the energy of a filament may exceed what weight and supports gave it, where the closure is the paper's
printed one and its balance is no more than approximate; a filament that has run away exceeds it a millionfold."""

_NOISE = 0.01
"""Of the largest energy: the first frames hold next to nothing, to no accuracy."""


def largest_stretch(scene: Scene) -> float:
    """The stretch at which a filament counts as ruptured."""
    return STRONGEST if scene.material.law in SOLIDS else THREAD


def rupture_frame(scene: Scene, stretch: Floats) -> int | None:
    """The first frame in which a cell is drawn beyond what its material can bear; None without.

    Parameters
    ----------
    scene : Scene
        For its law.
    stretch : ndarray, shape (frames, cells)
        Of the whole span.
    """
    torn = np.flatnonzero(~(np.max(stretch, axis=1) <= largest_stretch(scene)))
    return int(torn[0]) if len(torn) else None


def rupture(scene: Scene, time: Floats, stretch: Floats, nodes: Floats) -> str:
    """When and where the filament ruptures, or an empty text.

    Parameters
    ----------
    time : ndarray, shape (frames,)
        [s].
    stretch : ndarray, shape (frames, cells)
        Of the whole span.
    nodes : ndarray
        X of the nodes.
    """
    frame = rupture_frame(scene, stretch)
    if frame is None:
        return ""
    cell = int(np.argmax(np.nan_to_num(stretch[frame], nan=np.inf)))
    where = round(float((nodes[cell] + nodes[cell + 1]) / 2 / (nodes[-1] - nodes[0])), 6) + 0.0
    return (
        f"by t = {time[frame]:.6g} s the cell at X/L = {where:.4g} is drawn to more than {largest_stretch(scene):.4g} "
        "times its length"
    )


def gained_energy(fields: Mapping[str, Floats], least: float) -> str:
    """That motion and stress hold more energy than weight and supports gave the filament, or an empty text.

    Dissipation only takes energy away, whatever the closure: this holds also where the balance itself is not audited.

    Parameters
    ----------
    fields : mapping of str to ndarray, shape (frames,)
        Energies and ``work_external`` [J].
    least : float
        Energy that counts as none [J].
    """
    held = fields["energy_kinetic"] + fields["energy_elastic"]
    stored = fields["energy_potential"] + fields["energy_surface"]
    given = held[0] + stored[0] - stored + fields["work_external"]
    noise = _NOISE * np.max(held) + least
    excess = held - (1 + _GIFT) * np.maximum(np.maximum.accumulate(given), 0.0) - noise
    frame = int(np.argmax(excess))
    if not excess[frame] > 0:
        return ""
    return (
        f"in frame {frame} motion and stress hold {held[frame]:.3g} J, but weight and supports gave "
        f"{given[frame]:.3g} J: no filament can be in that state"
    )
