"""How much of the sag shear makes: Timoshenko's beam, the bent ends of a string, the hinges of a yielding filament."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from softcat_sym.effects.prediction import beam_of, instant_modulus, yield_stress_of
from softcat_sym.equations import regimes
from softcat_sym.equations.fibres import SHEAR_CORRECTION
from softcat_sym.equations.section import SECTIONS
from softcat_sym.scene import Scene, groups_of, undeformed_area

_HINGES = 0.7
"""Change of the sag per h0/L, against plane-stress elements: the hinges of a yielding filament shear most."""

_BENT_ENDS = 5.0
"""Of a string in clamps: its bent ends, about h0/(6 H) long, are stiffened by less where they shear."""

_SHEAR_SAG = {
    regimes.CLAMPED: 1 / 8,
    regimes.PROPPED: 1 / 8,
    regimes.PINNED: 1 / 8,
    regimes.CANTILEVER: 3 / 8,
}
"""Midspan sag by shear alone over q L^2/(kappa mu A)."""


def sheared_share(scene: Scene, sag: float, tension_share: float) -> float:
    """Change of the sag by shear, of it.

    Parameters
    ----------
    scene : Scene
        Section, ends and law.
    sag : float
        Over span.
    tension_share : float
        Share of the load that is carried in tension, which does not shear.
    """
    delta, beam = groups_of(scene).delta, beam_of(scene)
    shape, correction = SECTIONS[scene.filament.section], float(SHEAR_CORRECTION[scene.filament.section])
    compliance = float(regimes.gyration(shape)) * 2 * (1 + scene.material.poisson) / correction * delta**2
    bent = _SHEAR_SAG[beam] / float(beam.midspan_sag) * compliance * (1 - tension_share)
    clamped = "clamped" in (scene.ends.left, scene.ends.right)
    ends = _BENT_ENDS * delta * sag * tension_share if clamped else 0.0
    hinges = _HINGES * delta if clamped and yield_stress_of(scene) is not None else 0.0
    return max(hinges, bent + ends)


def lagging(time: npt.NDArray[np.float64], force: npt.NDArray[np.float64], lag: float) -> npt.NDArray[np.float64]:
    """Force that a spring beside a dashpot has given way to: lag dF/dt + F = force, from 0 at the first frame.

    Parameters
    ----------
    time : ndarray, shape (frames,)
        [s].
    force : ndarray, shape (frames, cells)
        Constant from each frame to the next.
    lag : float
        Retardation time [s]; with 0 the spring follows at once.
    """
    if lag <= 0:
        return force
    felt = np.zeros_like(force)
    for frame, kept in enumerate(np.exp(-np.diff(time) / lag)):
        felt[frame + 1] = kept * felt[frame] + (1 - kept) * force[frame]
    return felt


def compliant_sag(scene: Scene, shear_force: npt.NDArray[np.float64], length: npt.NDArray[np.float64]) -> float:
    """Sag over span that the transverse force of a finished run would add elastically: its sum times 1/(kappa mu A).

    Parameters
    ----------
    shear_force : ndarray, shape (frames, cells)
        [N].
    length : ndarray, shape (cells,)
        Of each cell [m].
    """
    modulus = instant_modulus(scene)
    if modulus is None:
        return 0.0
    correction = float(SHEAR_CORRECTION[scene.filament.section])
    stiffness = correction * modulus / (2 * (1 + scene.material.poisson)) * undeformed_area(scene)
    half = len(length) // 2
    return float(np.max(np.abs(shear_force[:, :half] @ length[:half]))) / stiffness / scene.filament.span
