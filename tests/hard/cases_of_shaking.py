"""Hard cases of gravity that oscillates, below and above the first frequency, and that is turned round in every period.

Fixed before they were run, with the allowance of the other cases.
"""

from __future__ import annotations

import math

import softcat_sym as sc

from .case import PLASTIC, Case
from .dimensionless import PAPER, Scales, asked
from .judging import follows, refined
from .truths import beam_shaken

_STIFF, _DELTA = 1e8, 0.03
_FIRST = 22.373285 * _DELTA * math.sqrt(_STIFF / 12) / (2 * math.pi)
"""First frequency of the clamped beam in sqrt(g/L)."""


def shaken(scene: sc.Scene, a: float, frequency: float) -> sc.Scene:
    """A scene under g (1 + a sin(2 pi f t)), f in sqrt(g/L)."""
    named = scene.run.effects
    effects = named if isinstance(named, str) else [*named, "gravity-shaking"]
    hertz = f"{frequency / Scales().time!r} Hz"
    return scene.replace({"load.shake": a, "load.shake_frequency": hertz, "run.effects": effects})


def _beams() -> list[Case]:
    return [
        Case(
            "gravity",
            f"oscillating, a = {a:g}, f = {ratio:g} f_1",
            lambda a=a, ratio=ratio: shaken(asked("elastic", E=_STIFF, effects=PAPER, T=4 / _FIRST), a, ratio * _FIRST),
            follows(lambda t, a=a, ratio=ratio: beam_shaken(t, _STIFF, _DELTA, a, ratio * _FIRST)),
        )
        for a, ratio in ((0.5, 0.6), (0.5, 1.7), (2.0, 0.6))
    ]


def _flows() -> list[Case]:
    return [
        Case(
            "gravity",
            f"oscillating, {law}, a = {a:g}",
            lambda law=law, a=a, more=more, flows=flows: shaken(
                asked(law, E=1e3, V=30, T=4, effects=(*PAPER, *flows), **more), a, 1.0
            ),
            refined,
            allowed=allowed,
        )
        for law, a, more, flows, allowed in (
            ("maxwell", 2.0, {}, PLASTIC[:1], 2e-3),
            # Yields in every period; the accuracy asked is that of the other filaments that yield.
            ("bingham", 2.0, {"G": 0.5, "accuracy": 5e-3}, PLASTIC, 1e-2),
        )
    ]


FAMILIES = (_beams, _flows)
