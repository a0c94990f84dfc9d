"""How far shaken gravity swings a filament: the gain of its first mode."""

from __future__ import annotations

import math

from softcat_sym.effects.ringing import ringing
from softcat_sym.scene import Scene


def shaken_share(scene: Scene) -> float:
    """Largest swing by the shaking over the sag under steady gravity: a times the gain; 0 where nothing shakes.

    Of a mode of frequency omega, driven from rest at r omega, the forced and the free vibration together reach at most
    (1 + r)/sqrt((1 - r^2)^2 + (2 zeta r)^2) static deflections (Rayleigh 1877, section 46). In the damping zeta counts
    besides the decay that resonance has the time of the run to build up, by one static deflection in 2/omega. What
    flows has nothing to spring back: r = 0.

    Parameters
    ----------
    scene : Scene
        Any scene.
    """
    return scene.load.shake * (1 + _ratio(scene)) * steady_gain(scene)


def steady_gain(scene: Scene) -> float:
    """Amplitude of the forced vibration over that of a filament in balance at every instant."""
    ratio, rings = _ratio(scene), ringing(scene)
    if ratio == 0:
        return 1.0
    damping = rings.decay / rings.frequency + 1 / (rings.frequency * scene.run.duration)
    return 1 / math.hypot(1 - ratio**2, 2 * damping * ratio)


def shaken_peak(scene: Scene) -> float:
    """Steady load that would stretch and bend the filament as far as the shaken one does, over that without shaking."""
    return 1 + shaken_share(scene)


def shaken_phase(scene: Scene) -> float:
    """How many times a small change of the stiffness shows in the swing: d log gain / d log r^2 = r^2 gain."""
    return min(1.0, shaken_share(scene)) * 2 * _ratio(scene) ** 2 * steady_gain(scene)


def _ratio(scene: Scene) -> float:
    """Frequency of the shaking over that of the first mode; 0 where nothing springs back."""
    if scene.load.shake == 0:
        return 0.0
    frequency = ringing(scene).frequency
    return 2 * math.pi * scene.load.shake_frequency / frequency if math.isfinite(frequency) else 0.0
