"""First natural frequency of a filament, and its ringing under its load."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import Fault, SceneError
from softcat_sym.estimates import scaling as scales
from softcat_sym.estimates.discrete_filament import (
    Configuration,
    DeformedElements,
    Elements,
    angles_in,
    stiffness_of_angles,
    turns_by,
    unstrained,
)
from softcat_sym.estimates.quasi_static_sag import elastic_sag_under, retardation, slackness, solvent_lag
from softcat_sym.estimates.scaling import added_mass_ratio, initial_strain, may_have
from softcat_sym.physics.beams import ARREST_THRESHOLD
from softcat_sym.physics.cross_sections import PLANE_STRAIN
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.natural_curve import has_shape, natural_curve
from softcat_sym.scene.scene import (
    Scene,
    chord_angle,
    force_free_stretch,
    is_held,
    is_slack,
    straight_angle,
    stress_free_length,
    undeformed_area,
)

_ELEMENTS = 40
_TURN, _MOST = 0.4, 100
"""Turn of an element of a natural curve [rad], unless that would take too many of them."""
_EXCITED = 0.05
"""Smallest share of the way to rest that is of a mode which the load sets ringing."""

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Vibration:
    """A mode of small vibrations about the elastic shape under load."""

    frequency: float  # omega_1, angular [1/s]
    # Share of bending and stretching in its stiffness, besides that of the static tension: only straining dissipates,
    # so that a loss tangent gives the damping ratio material_share loss_tangent/2.
    material_share: float
    way: float  # Of the midpoint from where the filament begins to where it rests [m]; 0 if it begins at rest


def first_vibration(scene: Scene) -> Vibration | None:
    """The first mode of the elastic filament about its shape under load; None without a modulus.

    A solid that creeps rings with its stiffness of a sudden load about the shape to which it has crept by the end of
    the ramp: a strand that sags deeper is under less tension, but its arc is stiffer.

    It is the lowest of the modes that the load sets ringing, as it takes the filament from where it begins to where it
    rests; of a filament that begins at rest, slack or without a load, the lowest of all.
    """
    return _first_vibration(scene.without_numerics())


@lru_cache(maxsize=256)
def _first_vibration(scene: Scene) -> Vibration | None:
    modulus = scales.instant_modulus(scene)
    if modulus is None:
        return None
    natural = _natural_shape(scene)
    start = _held_shape(scene, natural)
    elements = _elements(scene, modulus, natural, start)
    begin = elements.at_rest(start, 0.0) if elements.is_strained(start) and not is_slack(scene) else start
    left = _left_by_creep(scene, modulus)
    crept = replace(elements, axial=left * elements.axial, bending=left * elements.bending)
    rest = None if begin is None else crept.at_rest(begin, 1.0)
    if begin is None or rest is None:
        return None
    cells = replace(DeformedElements.of(crept, rest), straining=DeformedElements.of(elements, rest).straining)
    squares, modes, strained, mass = elements.vibrations(cells)
    away = begin.seen_from(rest)
    first, way = 0, 0.0
    if not is_slack(scene):
        # Without a load: by whatever weight, however little.
        pushed = np.tile([*scene.load.direction, 0.0, 0.0, 0.0], len(away))[elements.free]
        is_loaded, way = np.any(elements.force), float(np.linalg.norm(away[len(away) // 2, :3]))
        rung = modes.T @ mass @ (away.ravel()[elements.free] if is_loaded else pushed)
        if not is_loaded:
            # What turns freely has no frequency.
            rung = np.divide(rung, squares, out=np.zeros_like(rung), where=squares > 0)
        first = int(np.argmax(rung**2 > _EXCITED * float(np.sum(rung**2))))
    square = float(squares[first])
    if not square > 0:
        return None
    share = min(1.0, max(0.0, float(strained[first]) / square))
    # Digits that are the same on every processor: what is chosen and printed by them is.
    return Vibration(*(float(f"{number:.7g}") for number in (math.sqrt(square), share, way)))


def _left_by_creep(scene: Scene, modulus: float) -> float:
    """Stiffness of a solid at the end of the ramp, over that under a sudden load: linear creep since half of it."""
    late, static = retardation(scene), scales.static_modulus(scene)
    if not late or not static:
        return 1.0
    return 1 / (modulus / static + (1 - modulus / static) * math.exp(-scene.load.ramp / 2 / late))


def solid_viscosity(scene: Scene) -> float:
    """eta_s of the viscous stress beside spring and flow [Pa s]: as given, or loss_tangent E/omega_1; 0 without one."""
    material, modulus = scene.material, scales.instant_modulus(scene)
    if material.solid_viscosity is not None or material.loss_tangent == 0 or modulus is None:
        return material.solid_viscosity or 0.0
    vibration = first_vibration(scene)
    if vibration is None:
        found = f"{material.loss_tangent:g}, but no stable elastic shape under the load is found, and so no frequency"
        raise SceneError([Fault("material.loss_tangent", found, "material.solid_viscosity, or leaving it out")])
    return material.loss_tangent * modulus * _fibre_ratio(scene) / vibration.frequency


def solid_retardation(scene: Scene) -> float:
    """Retardation time of the strain, eta_s/E of a fibre [s]."""
    modulus = scales.instant_modulus(scene)
    return solid_viscosity(scene) / (modulus * _fibre_ratio(scene)) if modulus else 0.0


def solid_decay(scene: Scene) -> float:
    """Decay rate of the first mode by the loss below yield [1/s]: eta_s omega^2 share/(2 E)."""
    vibration = first_vibration(scene) if scene.material.has_loss else None
    if vibration is None:
        return 0.0
    return solid_retardation(scene) * vibration.frequency**2 * vibration.material_share / 2


def damping_note(scene: Scene) -> str:
    """Text with the first natural frequency and the loss below yield at it; empty without a loss."""
    vibration = first_vibration(scene) if scene.material.has_loss else None
    if vibration is None:
        return ""
    tangent = f"loss tangent {vibration.frequency * solid_retardation(scene):.3g}"
    viscosity = f"solid viscosity {solid_viscosity(scene):.4g} Pa s"
    given = scene.material.solid_viscosity is not None
    words = f"{viscosity} -> {tangent}" if given else f"{tangent} -> {viscosity} (loss_tangent E/omega_1)"
    return f"first natural frequency {vibration.frequency / (2 * math.pi):.4g} Hz; {words}"


def _fibre_ratio(scene: Scene) -> float:
    """Stiffness of a fibre over that of the material: 1, unless the width is held (THEORY 3)."""
    section = scales.section_of(scene)
    return section.stiffness(PLANE_STRAIN**2, scene.material.poisson) if section.plane_strain else 1.0


def _natural_shape(scene: Scene) -> Configuration:
    """Without stress: its own curve, or straight along its supports, or from its only support in its direction."""
    filament, length = scene.filament, stress_free_length(scene)
    kappa = np.array([[filament.twist, 0.0, filament.curvature]])
    turned = math.ceil(float(np.linalg.norm(kappa)) * length / _TURN / 2) * 2
    share = np.linspace(0.0, 1.0, min(max(_ELEMENTS, turned), _MOST) + 1)
    if has_shape(scene):
        curve = natural_curve(scene)
        quaternions = curve.quaternions(share * length)
        half = np.arccos(np.clip(quaternions[:, :1], -1, 1))
        return Configuration(curve.places(share * length), turns_by(2 * quaternions[:, 1:] / np.sinc(half / np.pi)))
    at = (share[:, None] - float(scene.ends.supports[0].is_free)) * length
    first = _in_plane(np.array([straight_angle(scene)]))
    steps = np.diff(at, axis=0) * (first @ turns_by((at[1:] + at[:-1]) / 2 * kappa))[:, :, 0]
    return Configuration(np.vstack([np.zeros(3), np.cumsum(steps, axis=0)]), first @ turns_by(at * kappa))


def _held_shape(scene: Scene, natural: Configuration) -> Configuration:
    """Between two supports: straight, or as the catenary of its length; clamps turn its ends."""
    if has_shape(scene) or not is_held(scene):
        return natural
    ends, share, length = scene.ends, np.linspace(0.0, 1.0, len(natural.places)), stress_free_length(scene)
    places = np.outer(share, [scene.filament.span, -ends.drop, 0.0])
    angles = np.full(len(share), chord_angle(scene))
    if is_slack(scene):
        # The catenary (a asinh(s/a), hypot(a, s)); of what floats up it is upside down.
        up = -1.0 if scales.buoyant_share(scene) > 1 else 1.0
        rise, span = -up * ends.drop / length, scene.filament.span
        a = span / 2 / _half_catenary(length / span * math.sqrt(1 - rise**2))
        begin = a * math.atanh(rise) - span / 2
        s = a * math.sinh(begin / a) + share * length
        places[:, 0], places[:, 1] = a * np.arcsinh(s / a) - begin, up * (np.hypot(a, s) - math.hypot(a, s[0]))
        angles = up * np.arctan(s / a)
    for node, (_, support, angle) in zip((0, -1), ends.sides, strict=True):
        angles[node] = angle if support.carries_moment else angles[node]
    return Configuration(places, _in_plane(angles))


def _in_plane(angles: Floats) -> Floats:
    return turns_by(np.outer(angles, [0.0, 0.0, 1.0]))


def _half_catenary(ratio: float) -> float:
    """Solve sinh(u)/u = ratio: Newton's method in the logarithm, a convex function, from below."""
    u = math.sqrt(6 * math.log(ratio))
    for _ in range(50):
        u -= (math.log(math.sinh(u) / u) - math.log(ratio)) / (1 / math.tanh(u) - 1 / u)
    return u


def _elements(scene: Scene, modulus: float, natural: Configuration, begin: Configuration) -> Elements:
    filament, load, section = scene.filament, scene.load, scales.section_of(scene)
    chords, angles = angles_in(natural)
    length = unstrained(chords, angles) / force_free_stretch(scene)
    n, poisson = len(length), scene.material.poisson
    relative, strains = (
        np.interp((np.arange(n) + 0.5) / n, np.linspace(0, 1, len(values)), values)
        for values in (filament.profile or (1.0,), initial_strain(scene) or (0.0,))
    )
    areas = undeformed_area(scene) * relative**section.area_power
    # A drawn filament is thinner: I0/s^3 over the length at rest, of a sheet I0/s^4.
    drawn = (angles_in(begin)[0] / chords * force_free_stretch(scene)) ** (-4 if section.plane_strain else -3)
    square, across = (relative * filament.thickness) ** 2, filament.width**2
    axial = section.stiffness(modulus, poisson) * areas
    bent = axial * drawn * section.gyration * (isinstance(scene.run.effects, str) or may_have(scene, "bending"))
    sheared = axial * drawn / (2 * (1 + poisson))
    stiff = float(section.shear_correction) if may_have(scene, "shear") else math.inf
    bending = stiffness_of_angles(
        length,
        bent * square,
        bent * across,
        sheared * section.torsion(filament.width / filament.thickness) * square,
        sheared * stiff,
    )
    mass = filament.density * areas * length
    surface = np.array([scales.surface_stress(scene, one) for one in relative])
    attached, force = np.zeros(n + 1), np.zeros((n + 1, 6))
    attached[n // 2], attached[-1] = load.point_mass, load.tip_mass
    weight = (np.append(mass, 0.0) + np.append(0.0, mass)) / 2 * (1 - scales.buoyant_share(scene)) + attached
    force[:, :3] = np.outer(weight * load.gravity, load.direction)
    force[-1] += [*load.tip_force, *load.tip_torque]
    free = np.ones((n + 1, 6), dtype=bool)
    free[:, 2:5] = is_spatial(scene)
    left, right = scene.ends.supports
    springs = np.zeros((n + 1, 6))
    for node, (side, support, _) in zip((0, -1), scene.ends.sides, strict=True):
        springs[node] = np.repeat([k if k < math.inf else 0.0 for k in scene.ends.stiffness(side)], 3)
        held = support.holds_x, support.holds_height, support.holds_height, *[support.holds_angle] * 3
        free[node] &= ~np.array(held)
    return Elements(
        length=length,
        relaxed=math.log(force_free_stretch(scene)) + strains,
        axial=axial,
        pull=surface * areas * bool(scales.pull_of_surface(scene)),
        pull_power=1.0 if section.plane_strain else 0.5,
        bending=bending,
        natural=angles,
        mass=mass,
        mass_across=mass * (1 + may_have(scene, "added-mass") * added_mass_ratio(scene)),
        inertia=mass * section.gyration * (square + across),
        attached=attached,
        force=force,
        springs=springs,
        first=begin,
        closing=np.linspace(left.is_free, not right.is_free, n + 1),
        free=np.flatnonzero(free),
    )


_RAMP_ENVELOPE = 120.0
"""Ringing after the quintic ramp is 120/(omega ramp)^3 for a slow ramp (see regimes.ramp_gain)."""

_STRAIGHT = 1e-9
_OVERDAMPED = 5.0  # V above which a yielding filament stops without oscillation


@dataclass(frozen=True, slots=True)
class ExpectedRinging:
    """Ringing of the lowest mode about the elastic shape."""

    frequency: float  # Of the first mode, angular [1/s]; infinite for a filament that does not spring back
    decay: float  # Decay rate of its amplitude [1/s]
    amplitude: float  # In spans, at the start
    way: float = 0.0  # Of the midpoint from where the filament begins to where it rests, in spans

    def lasting(self, time: float) -> float:
        """Amplitude after a time [s]."""
        return self.amplitude * math.exp(-self.decay * time)

    def phase(self, duration: float) -> float:
        """Phase of the ringing while it lasts [rad]."""
        if self.amplitude == 0:
            return 0.0
        return self.frequency * min(duration, 1 / self.decay if self.decay > 0 else math.inf)


def ringing(scene: Scene, *, lossless: bool = False) -> ExpectedRinging:
    """Ringing that the load of a scene causes; without amplitude where the scene begins at rest under its load."""
    vibration = first_vibration(scene)
    if vibration is None:
        return ExpectedRinging(math.inf, 0.0, 0.0)
    frequency, way = vibration.frequency, vibration.way / scene.filament.span
    decay = _decay(scene, frequency) + (0.0 if lossless else solid_decay(scene))
    if scales.weight_stress(scene) == 0 or decay >= frequency:
        return ExpectedRinging(frequency, decay, 0.0, way)
    left = min(1.0, _left_by_ramp(scene, frequency, way)) if scene.load.ramp > 0 else 1.0
    return ExpectedRinging(frequency, decay, way * left, way)


def _left_by_ramp(scene: Scene, frequency: float, way: float) -> float:
    """Ringing after the ramp of gravity over that without a ramp.

    A straight filament without bending stiffness is soft while its load is small: its quasi-static sag starts with a
    speed of 2.15 sags per ramp, inertia keeps up with it from the time t_c on, when its phase has grown to one radian,
    and the action of that oscillation is conserved. From omega^2 H/g = constant the phase at t is omega(t) t/2.
    """
    ramp, speed = scene.load.ramp, 2.15 / scene.load.ramp
    smooth = _RAMP_ENVELOPE / (frequency * ramp) ** 3
    if not is_held(scene) or abs(slackness(scene)) > _STRAIGHT:
        return smooth
    beam = elastic_sag_under(scene, scales.weight_stress(scene), scales.instant_modulus(scene), taut=False)
    caught = math.sqrt(math.sqrt(4 * ramp**3 * speed / 10) / frequency)
    swing = speed * caught * math.sqrt(min(1.0, 2 / (frequency * caught)))
    # A beam that is stiff from the beginning follows its equilibrium; between beam and string the share falls with the
    # cube of the frequency of the beam alone.
    return max(smooth, swing / max(1.0, frequency * math.sqrt(way / beam) * caught) ** 3)


def _decay(scene: Scene, frequency: float) -> float:
    """Decay rate of the ringing by flow or a viscous stress [1/s]."""
    material = scene.material
    if material.modes:
        total = sum(mode.youngs_modulus for mode in material.modes)
        return sum(mode.youngs_modulus**2 / mode.viscosity for mode in material.modes) / total / 2
    if material.relaxation_time:
        return 1 / (2 * material.relaxation_time) + frequency**2 * solvent_lag(scene) / 2
    if scene.material.spec.is_solid:
        late = retardation(scene)
        if material.spec.viscous_stress:
            return frequency**2 * late / 2
        arm = (material.second_modulus or 0.0) / ((material.second_modulus or 0.0) + (material.youngs_modulus or 1.0))
        return arm / (2 * late) if late > 0 else 0.0
    viscosity, modulus, gravity_number = (
        scales.effective_viscosity(scene),
        scales.instant_modulus(scene),
        scales.gravity_number_of(scene),
    )
    held = gravity_number is not None and gravity_number < ARREST_THRESHOLD
    # An arrested filament keeps ringing, unless its whole section flows so slowly that it stops without oscillation; an
    # elastic core keeps ringing.
    creeps = (scales.viscous_number(scene) or 0.0) > _OVERDAMPED and scales.yields_throughout(scene)
    if not viscosity or modulus is None or (held and not creeps):
        return 0.0
    return modulus / (2 * viscosity)
