"""Temperature: uniform over the section, variable along the filament; viscosity and stiffness depend on it.

rho c_p A T_t = D - h P (T - T_a) + (k A T_s)_s in lengths of the moving filament, with the dissipation D of flow and
viscous stress. Radiation is not included, and the ends are insulated.
"""

from __future__ import annotations

import math
from dataclasses import replace

from softcat_sym.effects.effect import SMALL_MODEL, Effect, Estimate
from softcat_sym.effects.natural_strain import shrinking
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.scaling import gravity_of
from softcat_sym.physics.terms import Course, Terms, Warming
from softcat_sym.scene.history import History
from softcat_sym.scene.scene import Scene
from softcat_sym.scene.tables import frozen_below, viscosity_factor
from softcat_sym.scene.temperature_table import PREFIX

_THICK = 0.1
"""Biot number above which the temperature is not uniform: the middle lags by a twentieth of the difference."""


def _applies(scene: Scene) -> bool:
    return scene.model == "filament" and scene.temperature.present


def _adapted(scene: Scene, terms: Terms) -> Terms:
    stated = scene.temperature
    exchange = "coefficient" if stated.heat_transfer else ""
    heat = Warming(
        law=stated.law,
        by_reference=stated.law == "vft" and stated.reference is not None,
        exchange=exchange if stated.correlation == "none" else stated.correlation,
        ambient=Course.of(f"{PREFIX}ambient", stated.ambient) if isinstance(stated.ambient, History) else None,
        modulus=Course.of(f"{PREFIX}modulus", stated.modulus) if stated.modulus is not None else None,
        conducts=stated.conductivity is not None,
        expands=stated.expansion != 0,
        partial=bool(stated.heated),
        freezes=frozen_below(scene) is not None,
    )
    return replace(terms, heat=heat)


def transfer_coefficient(scene: Scene) -> float:
    """Heat transfer coefficient [W/(m^2 K)]; for a correlation, the largest one for the scene's temperatures."""
    stated = scene.temperature
    if stated.correlation == "none":
        return stated.heat_transfer or 0.0
    low, high = stated.extremes(scene.run.duration)
    return cylinder_in_air(low, high, scene.filament.thickness, scene.load.gravity)


def cylinder_in_air(kelvin: float, around: float, diameter: float, gravity: float) -> float:
    """The correlation of Churchill & Chu (1975) in numbers, as :func:`softcat_sym.physics.heat.cylinder_in_air`."""
    film = (kelvin + around) / 2
    conducts = 2.64638e-3 * math.pow(film, 1.5) / (film + 245.4 * math.pow(10, -12 / film))
    viscosity = 1.458e-6 * math.pow(film, 1.5) / (film + 110.4) * 287.05287 * film / 101325
    rayleigh = gravity * math.hypot(kelvin - around, 0.01) * diameter**3 * 0.7 / (film * viscosity**2)
    slope = 0.387 / math.pow(1 + math.pow(0.559 / 0.7, 9 / 16), 8 / 27)
    return math.pow(0.6 + slope * math.pow(rayleigh, 1 / 6), 2) * conducts / diameter


def half_thickness(scene: Scene) -> float:
    """Volume over surface [m], the length over which heat is conducted."""
    filament = scene.filament
    if filament.section == "sheet":
        return filament.thickness / 2
    return filament.thickness * filament.width / (2 * (filament.thickness + filament.width))


def cooling_time(scene: Scene) -> float:
    """Time constant of Newton's cooling, rho c_p V/(h S) [s]; infinite if nothing is exchanged."""
    stated, coefficient = scene.temperature, transfer_coefficient(scene)
    if coefficient == 0:
        return math.inf
    return scene.filament.density * (stated.heat_capacity or 0.0) * half_thickness(scene) / coefficient


def biot_number(scene: Scene) -> float | None:
    """Bi = h (V/S)/k; None without a conductivity."""
    conductivity = scene.temperature.conductivity
    return None if conductivity is None else transfer_coefficient(scene) * half_thickness(scene) / conductivity


def coldest_and_hottest(scene: Scene, motion: Motion) -> tuple[float, float]:
    """Lowest and highest temperature of the filament in the run [K], by Newton's cooling and dissipation."""
    stated = scene.temperature
    start = stated.initial or 0.0
    reached = -math.expm1(-scene.run.duration / cooling_time(scene))
    low, high = (start + reached * (one - start) for one in stated.extremes(scene.run.duration))
    # Upper bound: the potential energy of a fall by the sag heats the filament.
    fall = gravity_of(scene) * motion.sag * scene.filament.span
    return low, high + fall / (stated.heat_capacity or math.inf)


def _estimate(scene: Scene, motion: Motion) -> Estimate:
    meaning = "change of the viscosity times the stress that flow relaxes, of the modulus, or by contraction"
    stated, change = scene.temperature, 0.0
    if not stated.present:
        return Estimate(0.0, meaning)
    reached = coldest_and_hottest(scene, motion)
    for kelvin in reached:
        flow, spring = viscosity_factor(scene, kelvin), stated.modulus_factor(kelvin)
        for factor, share in ((flow, motion.relaxed), (spring, 1.0)):
            change = max(change, share * (1 - min(factor, 1 / factor)) if factor > 0 else share)
    apart = max(abs(one - (stated.initial or 0.0)) for one in reached)
    change = max(change, shrinking(scene, motion, abs(stated.expansion) * apart))
    return Estimate(motion.amplified(change), meaning, "relaxed (1 - min(a_T, 1/a_T)), 1 - min(m_T, 1/m_T)")


def _indispensable(scene: Scene) -> str:
    stated = scene.temperature
    by_unit = stated.law == "vft" and stated.A is not None
    return "temperature.A determines the viscosity, not material.viscosity" if by_unit else ""


def _warnings(scene: Scene, motion: Motion) -> list[str]:
    del motion
    if not _applies(scene) or not scene.temperature.exchanges:
        return []
    biot = biot_number(scene)
    if biot is None:
        return ["the section is assumed to have one temperature, which needs temperature.conductivity for a check"]
    if biot <= _THICK:
        return []
    return [
        f"the section is assumed to have one temperature, but its Biot number h (V/S)/k is {biot:.2g}: above "
        f"{_THICK:g} its middle lags behind its surface"
    ]


TEMPERATURE = Effect(
    name="temperature",
    summary="rho c_p A T_t = D - h P (T - T_a) + conduction; viscosity and moduli of the temperature",
    source="Incropera 2007; Fulcher 1925; Churchill & Chu 1975",
    adapt=_adapted,
    applies=_applies,
    without_it=f"the scene states no temperature.initial, or {SMALL_MODEL}",
    estimate=_estimate,
    observable="viscosities and moduli at the temperatures that the run reaches, over those that the scene states",
    example="glass-fibre",
    derivation="20_temperature",
    in_paper=False,
    indispensable=_indispensable,
    warnings=_warnings,
)
