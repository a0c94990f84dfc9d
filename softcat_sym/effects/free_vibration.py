"""First natural frequency of a held strand, and its ringing under its load."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from softcat_sym.effects import scaling_estimates as scales
from softcat_sym.effects.law import is_solid
from softcat_sym.effects.quasi_static import (
    elastic_sag_under,
    load_factor,
    mean_of,
    retardation,
    slackness,
    solvent_lag,
    start_sag,
)
from softcat_sym.physics.beams import ARREST_THRESHOLD
from softcat_sym.physics.cross_sections import PLANE_STRAIN
from softcat_sym.scene.natural_curve import has_shape
from softcat_sym.scene.scene import (
    Scene,
    chord_angle,
    distance,
    is_held,
    is_slack,
    rest_length,
    stress_free_length,
    undeformed_area,
)

_ELEMENTS = 40
_HALVINGS = 100
_EXCITED = 0.05
"""Smallest share of modal mass of a mode that the weight excites."""

Floats = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Vibration:
    """The lowest mode that the weight excites, of small vibrations about the elastic shape under that weight."""

    frequency: float  # omega_1, angular [1/s]
    # Share of bending and stretching in its stiffness, besides that of the static tension: only straining dissipates,
    # so that a loss tangent gives the damping ratio material_share loss_tangent/2.
    material_share: float


def first_vibration(scene: Scene) -> Vibration | None:
    """The first mode of an elastic strand; None without a modulus, or if a single pin holds the strand.

    Euler-Bernoulli elements of small slope between the supports include bending E I, the tension N by the initial
    stretch and by the weight, and the stretching of a sagging strand as it vibrates (Irvine 1981). N solves
    N = E A (eps_0 + int y'^2 dX/(2 L)) with the shape y under the weight and N; it is zero with a free end.
    """
    return _first_vibration(scene.without_numerics())


@lru_cache(maxsize=256)
def _first_vibration(scene: Scene) -> Vibration | None:
    modulus = scales.instant_modulus(scene)
    kinds = (scene.ends.left, scene.ends.right)
    if modulus is None or sorted(kinds) == ["free", "pinned"]:
        return None
    strand = _strand(scene, modulus)
    tension, shape = strand.at_rest()
    bending, geometric = strand.bending, strand.geometric
    pulled = geometric @ shape
    stretching = strand.axial * np.outer(pulled, pulled)
    squares, modes = eigen(bending + tension * geometric + stretching, strand.mass)
    carried = (modes.T @ strand.push) ** 2 / float(strand.push @ np.linalg.solve(strand.mass, strand.push))
    first = next((n for n in range(len(squares)) if squares[n] > 0 and carried[n] > _EXCITED), None)
    if first is None:
        return None
    mode = modes[:, first]
    strained = float(mode @ (bending + stretching) @ mode)
    return Vibration(math.sqrt(float(squares[first])), min(1.0, strained / float(squares[first])))


def solid_viscosity(scene: Scene) -> float:
    """eta_s of the viscous stress beside spring and flow [Pa s]: as given, or loss_tangent E/omega_1; 0 without one."""
    material = scene.material
    if material.solid_viscosity is not None:
        return material.solid_viscosity
    vibration = first_vibration(scene) if material.loss_tangent > 0 else None
    if vibration is None:
        return 0.0
    return material.loss_tangent * (scales.instant_modulus(scene) or 0.0) * _fibre_ratio(scene) / vibration.frequency


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


@dataclass(frozen=True)
class _Strand:
    """Matrices of deflections and slopes at the free nodes, over the distance of the supports [SI]."""

    bending: Floats  # shape (n, n); Stiffness of bending, stiffness of a unit of tension, mass
    geometric: Floats
    mass: Floats
    push: Floats  # shape (n,); Forces of a unit acceleration along the deflection
    weight: float  # Gravity perpendicular to the line between the supports
    axial: float  # E A over the distance; 0 with a free end
    strain: float  # Elastic strain of the straight strand
    length: float  # Distance of the supports

    def at_rest(self) -> tuple[float, Floats]:
        """Tension, and the shape under weight and tension."""
        force = self.weight * self.push
        if self.axial == 0:
            return 0.0, np.asarray(np.linalg.solve(self.bending, force), dtype=np.float64)
        # With the buckling modes v of the thrusts lambda, y = v (v.f)/(lambda + N).
        thrusts, shapes = eigen(self.bending, self.geometric)
        along = shapes.T @ force

        def missing(tension: float) -> float:
            return (
                self.axial * (self.strain * self.length + float(np.sum((along / (thrusts + tension)) ** 2)) / 2)
                - tension
            )

        low, high = max(self.axial * self.strain * self.length, -float(thrusts[0])), 2 * float(thrusts[0])
        while missing(high) > 0:
            high *= 4
        high = max(low, high)
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            low, high = (middle, high) if missing(middle) > 0 else (low, middle)
        return high, np.asarray(shapes @ (along / (thrusts + high)), dtype=np.float64)


def eigen(stiffness: Floats, mass: Floats) -> tuple[Floats, Floats]:
    """Solve K v = lambda M v: values in ascending order, vectors with v.M v = 1."""
    root = np.linalg.inv(np.linalg.cholesky(mass))
    values, vectors = np.linalg.eigh(root @ stiffness @ root.T)
    return values, root.T @ vectors


def _strand(scene: Scene, modulus: float) -> _Strand:
    section, length = scales.section_of(scene), distance(scene)
    # A filament with a natural shape is longer than the distance, but not compressed.
    drawn = 1.0 if has_shape(scene) else length / rest_length(scene)
    # A drawn strand is thinner: A0/s, I0/s^2.
    area, stiff = undeformed_area(scene) / drawn, section.stiffness(modulus, scene.material.poisson)
    gyration = section.gyration * scene.filament.thickness**2 / drawn
    places = (np.arange(_ELEMENTS) + 0.5) / _ELEMENTS
    values = scene.filament.profile or (1.0,)
    relative = np.interp(places, np.linspace(0, 1, len(values)), values)
    ell, areas = length / _ELEMENTS, relative**section.area_power
    size = 2 * (_ELEMENTS + 1)
    bending, geometric, mass = (np.zeros((size, size)) for _ in range(3))
    push = np.zeros(size)
    for n in range(_ELEMENTS):
        at = slice(2 * n, 2 * n + 4)
        bending[at, at] += stiff * area * areas[n] * gyration * relative[n] ** 2 / ell**3 * _bent(ell)
        geometric[at, at] += _pulled(ell) / (30 * ell)
        mass[at, at] += scene.filament.density * area * areas[n] * ell / 420 * _inert(ell)
        push[at] += scene.filament.density * area * areas[n] * ell * np.array([1 / 2, ell / 12, 1 / 2, -ell / 12])
    mass[_ELEMENTS, _ELEMENTS] += scene.load.point_mass
    push[_ELEMENTS] += scene.load.point_mass
    free = _free_places((scene.ends.left, scene.ends.right), size)
    cut = np.ix_(free, free)
    held = is_held(scene)
    relaxed = (length if has_shape(scene) else stress_free_length(scene)) * math.exp(mean_of(scene.initial.P))
    return _Strand(
        bending=bending[cut],
        geometric=geometric[cut],
        mass=mass[cut],
        push=push[free],
        weight=scales.gravity_of(scene) * math.cos(chord_angle(scene)),
        axial=stiff * area * float(np.mean(1 / areas)) ** -1 / length if held else 0.0,
        strain=math.log(length / relaxed) if held else 0.0,
        length=length,
    )


def _free_places(kinds: tuple[str, str], size: int) -> list[int]:
    """Numbers of the deflections and slopes that the ends leave free."""
    first, last = ({"clamped": {0, 1}, "pinned": {0}, "free": set()}[kind] for kind in kinds)
    held = {*first, *(size - 2 + one for one in last)}
    return [place for place in range(size) if place not in held]


def _bent(ell: float) -> Floats:
    a, b = 6 * ell, ell * ell
    return np.array([[12, a, -12, a], [a, 4 * b, -a, 2 * b], [-12, -a, 12, -a], [a, 2 * b, -a, 4 * b]])


def _pulled(ell: float) -> Floats:
    a, b = 3 * ell, ell * ell
    return np.array([[36, a, -36, a], [a, 4 * b, -a, -b], [-36, -a, 36, -a], [a, -b, -a, 4 * b]])


def _inert(ell: float) -> Floats:
    a, b, c = 22 * ell, 13 * ell, ell * ell
    return np.array([[156, a, 54, -b], [a, 4 * c, b, -3 * c], [54, b, 156, -a], [-b, -3 * c, -a, 4 * c]])


_FREQUENCY = 1.3
"""Omega^2 H/g of a filament with static sag H: 22.37^2/384 of a clamped beam, pi^2/8 of a string."""

_RAMP_ENVELOPE = 120.0
"""Ringing after the quintic ramp is 120/(omega ramp)^3 for a slow ramp (see regimes.ramp_gain)."""

_STRAIGHT = 1e-9
_OVERDAMPED = 5.0  # V above which a yielding filament stops without oscillation


@dataclass(frozen=True, slots=True)
class Ringing:
    """Ringing of the lowest mode about the elastic shape."""

    frequency: float  # Angular [1/s]; infinite for a filament that does not spring back
    decay: float  # Decay rate of its amplitude [1/s]
    amplitude: float  # In spans, at the start

    def lasting(self, time: float) -> float:
        """Amplitude after a time [s]."""
        return self.amplitude * math.exp(-self.decay * time)

    def phase(self, duration: float) -> float:
        """Phase of the ringing while it lasts [rad]."""
        if self.amplitude == 0:
            return 0.0
        return self.frequency * min(duration, 1 / self.decay if self.decay > 0 else math.inf)


def ringing(scene: Scene, *, lossless: bool = False) -> Ringing:
    """Ringing that the load of a scene causes."""
    modulus, weight = scales.instant_modulus(scene), scales.weight_stress(scene) * load_factor(scene)
    if modulus is None or weight == 0 or is_slack(scene):
        return Ringing(math.inf, 0.0, 0.0)
    static = scales.static_modulus(scene) if scene.material.law == "kelvin-voigt" else modulus
    deep = elastic_sag_under(scene, weight, static) - start_sag(scene)
    if deep <= 0:
        return Ringing(math.inf, 0.0, 0.0)
    frequency = math.sqrt(_FREQUENCY * scales.gravity_of(scene) / (deep * scene.filament.span))
    decay = _decay(scene, frequency) + (0.0 if lossless else solid_decay(scene))
    left = min(1.0, _left_by_ramp(scene, frequency, deep)) if scene.load.ramp > 0 else 1.0
    return Ringing(frequency, decay, deep * left if decay < frequency else 0.0)


def _left_by_ramp(scene: Scene, frequency: float, deep: float) -> float:
    """Ringing after the ramp of gravity over that without a ramp.

    A straight filament without bending stiffness is soft while its load is small: its quasi-static sag starts with a
    speed of 2.15 sags per ramp, inertia keeps up with it from the time t_c on, when its phase has grown to one radian,
    and the action of that oscillation is conserved.
    """
    ramp, gravity, span = scene.load.ramp, scales.gravity_of(scene), scene.filament.span
    smooth = _RAMP_ENVELOPE / (frequency * ramp) ** 3
    beam = elastic_sag_under(scene, scales.weight_stress(scene), scales.instant_modulus(scene), taut=False)
    straight = is_held(scene) and abs(slackness(scene)) < _STRAIGHT
    speed = 2.15 * deep * span / ramp
    caught = math.sqrt(math.sqrt(ramp**3 * speed / (10 * _FREQUENCY * gravity)))
    stiff = math.sqrt(_FREQUENCY * gravity / (beam * span))
    if not straight:
        return smooth
    swing = speed * caught / (deep * span) / math.sqrt(max(1.0, frequency * caught))
    # A beam that is stiff from the beginning follows its equilibrium; between beam and string the share falls with the
    # cube of the frequency.
    return max(smooth, swing / float(max(1.0, stiff * caught)) ** 3)


def _decay(scene: Scene, frequency: float) -> float:
    """Decay rate of the ringing by flow or a viscous stress [1/s]."""
    material = scene.material
    if material.modes:
        total = sum(mode.youngs_modulus for mode in material.modes)
        return sum(mode.youngs_modulus**2 / mode.viscosity for mode in material.modes) / total / 2
    if material.relaxation_time:
        return 1 / (2 * material.relaxation_time) + frequency**2 * solvent_lag(scene) / 2
    if is_solid(scene):
        late = retardation(scene)
        if material.law == "kelvin-voigt":
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
