"""How a filament rings when its load comes on: frequency, decay, amplitude."""

from __future__ import annotations

import math
from dataclasses import dataclass

from softcat_sym.effects.law import is_solid
from softcat_sym.effects.natural_frequency import solid_decay
from softcat_sym.effects.prediction import (
    effective_viscosity,
    gravity_number_of,
    instant_modulus,
    static_modulus,
    viscous_number,
    weight_stress,
    yields_throughout,
)
from softcat_sym.effects.quasi_static import elastic_sag_under, load_factor, retardation, slackness, start_sag
from softcat_sym.equations import regimes
from softcat_sym.scene import Scene, is_held, is_slack

_FREQUENCY = 1.3
"""Omega^2 H/g of a filament with static sag H: 22.37^2/384 of a clamped beam, pi^2/8 of a string."""

_RAMP_ENVELOPE = 120.0
"""Ringing left by the quintic ramp falls off as 120/(omega ramp)^3 (see regimes.ramp_gain)."""

_STRAIGHT = 1e-9
_OVERDAMPED = 5.0  # V above which a filament that yields is stopped without a swing


@dataclass(frozen=True, slots=True)
class Ringing:
    """Ringing of the lowest mode about the elastic shape.

    Attributes
    ----------
    frequency : float
        Angular [1/s]; infinite where nothing springs back.
    decay : float
        Rate at which its amplitude falls [1/s].
    amplitude : float
        In spans, at the start.
    """

    frequency: float
    decay: float
    amplitude: float

    def lasting(self, time: float) -> float:
        """Amplitude that is left after a time [s]."""
        return self.amplitude * math.exp(-self.decay * time)

    def phase(self, duration: float) -> float:
        """Phase that it runs through while it lasts [rad]."""
        if self.amplitude == 0:
            return 0.0
        return self.frequency * min(duration, 1 / self.decay if self.decay > 0 else math.inf)


def ringing(scene: Scene, *, lossless: bool = False) -> Ringing:
    """Ringing that the load of a scene sets off.

    Parameters
    ----------
    scene : Scene
        Any scene.
    lossless : bool
        Without the loss below yield (``material.loss_tangent``, ``material.solid_viscosity``).
    """
    modulus, weight = instant_modulus(scene), weight_stress(scene) * load_factor(scene)
    if modulus is None or weight == 0 or is_slack(scene):
        return Ringing(math.inf, 0.0, 0.0)
    static = static_modulus(scene) if scene.material.law == "kelvin-voigt" else modulus
    deep = elastic_sag_under(scene, weight, static) - start_sag(scene)
    if deep <= 0:
        return Ringing(math.inf, 0.0, 0.0)
    frequency = math.sqrt(_FREQUENCY * scene.load.gravity / (deep * scene.filament.span))
    decay = _decay(scene, frequency) + (0.0 if lossless else solid_decay(scene))
    left = min(1.0, _left_by_ramp(scene, frequency, deep)) if scene.load.ramp > 0 else 1.0
    return Ringing(frequency, decay, deep * left if decay < frequency else 0.0)


def _left_by_ramp(scene: Scene, frequency: float, deep: float) -> float:
    """Share of the ringing that the ramp of gravity leaves.

    A straight filament without bending stiffness is soft while its load is small: its balanced sag begins at once, with
    a speed of 2.15 sags per ramp, is caught up by inertia when its frequency has grown to one radian, at t_c, and keeps
    the action of that swing.
    """
    ramp, gravity, span = scene.load.ramp, scene.load.gravity, scene.filament.span
    smooth = _RAMP_ENVELOPE / (frequency * ramp) ** 3
    beam = elastic_sag_under(scene, weight_stress(scene), instant_modulus(scene), taut=False)
    straight = is_held(scene) and abs(slackness(scene)) < _STRAIGHT
    speed = 2.15 * deep * span / ramp
    caught = math.sqrt(math.sqrt(ramp**3 * speed / (10 * _FREQUENCY * gravity)))
    stiff = math.sqrt(_FREQUENCY * gravity / (beam * span))
    if not straight:
        return smooth
    swing = speed * caught / (deep * span) / math.sqrt(max(1.0, frequency * caught))
    # A beam that is stiff from the beginning follows; between beam and string it is the cube of the frequency.
    return max(smooth, swing / float(max(1.0, stiff * caught)) ** 3)


def _decay(scene: Scene, frequency: float) -> float:
    """Rate at which flow or a viscous stress takes the ringing away [1/s]."""
    material = scene.material
    if material.modes:
        total = sum(mode.youngs_modulus for mode in material.modes)
        return sum(mode.youngs_modulus**2 / mode.viscosity for mode in material.modes) / total / 2
    if is_solid(scene):
        late = retardation(scene)
        if material.law == "kelvin-voigt":
            return frequency**2 * late / 2
        arm = (material.second_modulus or 0.0) / ((material.second_modulus or 0.0) + (material.youngs_modulus or 1.0))
        return arm / (2 * late) if late > 0 else 0.0
    viscosity, modulus, gravity_number = effective_viscosity(scene), instant_modulus(scene), gravity_number_of(scene)
    held = gravity_number is not None and gravity_number < float(regimes.ARREST_THRESHOLD)
    # What is held rings on, unless all of a section has flowed so slowly that it comes to rest without a swing; as long
    # as a part of it stays elastic, that rings.
    creeps = (viscous_number(scene) or 0.0) > _OVERDAMPED and yields_throughout(scene)
    if not viscosity or modulus is None or (held and not creeps):
        return 0.0
    return modulus / (2 * viscosity)
