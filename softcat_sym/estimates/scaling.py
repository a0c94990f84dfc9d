"""Scaling estimates: moduli, viscosities, thresholds, static sag, growth of necks, initial stress (THEORY 5-7, 11)."""

from __future__ import annotations

import math

from softcat_sym.physics.beams import Beam, beam_between, beam_on_springs, first_yield, plastic_collapse
from softcat_sym.physics.cross_sections import CROSS_SECTIONS, PLANE_STRAIN, CrossSection
from softcat_sym.physics.terms import Rheology
from softcat_sym.scene.scene import Scene, groups_of, is_held, surface_stretch, undeformed_area
from softcat_sym.scene.tables import viscosity_factor


def law_in(scene: Scene) -> Rheology:
    """The law that the scene names, with its modes or its own flow rule."""
    material = scene.material
    return Rheology(
        material.law,
        modes=len(material.modes),
        flow=material.flow,
        threshold=bool(material.flow) and material.threshold > 0,
        solvent=not material.spec.has_chains or bool(material.solvent_viscosity),
    )


def may_have(scene: Scene, effect: str) -> bool:
    """Whether `auto` may choose an effect, or a list names it; those of the published theory are not asked for here."""
    requested = scene.run.effects
    return requested == "auto" if isinstance(requested, str) else effect in requested


def flow_nonlinearity(scene: Scene, overstress: float) -> float:
    """Nonlinearity of the flow rule, 0 to 1: with a linear one the plastic strain stays linear in z."""
    material = scene.material
    if material.spec.has_formula:
        return 1.0
    bent = abs(1 - 1 / material.index)
    return min(1.0, bent + 1 / max(1.0, overstress))


_THROUGHOUT = 2.0
"""G over that of first yield from which the whole section yields."""


def instant_modulus(scene: Scene) -> float | None:
    """Young's modulus of a sudden load [Pa]: all springs together; None for a fluid without any."""
    material = scene.material
    if material.modes:
        return sum(mode.youngs_modulus for mode in material.modes)
    if material.youngs_modulus is None:
        return None
    return material.youngs_modulus + (material.second_modulus or 0.0)


def static_modulus(scene: Scene) -> float | None:
    """Young's modulus of a solid under a lasting load [Pa]; otherwise that of a sudden load."""
    return scene.material.youngs_modulus if scene.material.spec.is_solid else instant_modulus(scene)


def yield_stress_of(scene: Scene) -> float | None:
    """Yield stress [Pa]; None for a law without one."""
    material = scene.material
    return material.yield_stress if material.yield_stress is not None else material.threshold or None


def surface_stress(scene: Scene, relative: float = 1.0) -> float:
    """Gam [Pa]: axial force of surface tension over the area, gamma P/(2 A) of the undeformed section.

    The section has this relative thickness of a profile.
    """
    pull = section_of(scene).pull(scene.filament.thickness * relative, scene.filament.width)
    return scene.surroundings.surface_tension * pull


def pull_of_surface(scene: Scene) -> float:
    """Gam [Pa]; 0 if a list of effects, the paper's list or the printed closure leaves surface tension out."""
    listed = may_have(scene, "surface-tension") and scene.run.closure != "printed"
    return surface_stress(scene) if listed else 0.0


def holding_stress_of(scene: Scene) -> float | None:
    """Largest tension over area of a filament at rest between supports [Pa]: sigma_Y plus the pull of its surface."""
    limit = yield_stress_of(scene)
    return limit if limit is None or not is_held(scene) else limit + pull_of_surface(scene)


def gravity_number_of(scene: Scene) -> float | None:
    """G = rho g L/sigma_Y (3.10), of any law that yields; with surface tension rho g L/(sigma_Y + gamma P/(2 A))."""
    limit = holding_stress_of(scene)
    return None if limit is None else weight_stress(scene) / limit


def moment_left_by_surface(scene: Scene) -> float:
    """Largest moment of the elastic beam with the pull of its surface over that without it; 1 with a free end."""
    modulus, pull = instant_modulus(scene), pull_of_surface(scene)
    if not modulus or not pull or not is_held(scene):
        return 1.0
    psi = math.sqrt(pull / (4 * modulus * section_of(scene).gyration)) / groups_of(scene).delta
    left = float(beam_of(scene).relief(min(psi, _STRONG))) if psi > _WEAK else 1.0
    # For a string in clamps it is proportional to 3/psi; between pins to 2/psi^2, which is small anyway.
    return left * min(1.0, _STRONG / psi)


_WEAK, _STRONG = 1e-3, 300.0
"""Below the first psi the pull has no effect, above the second hyperbolic functions overflow."""


def gravity_of(scene: Scene) -> float:
    """Gravity reduced by buoyancy, g |1 - rho_b/rho|."""
    return scene.load.gravity * abs(1 - buoyant_share(scene))


def fall_time(scene: Scene) -> float:
    """Time sqrt(L/g) with gravity reduced by buoyancy [s]."""
    gravity = gravity_of(scene)
    return math.sqrt(scene.filament.span / gravity) if gravity > 0 else math.inf


def weight_stress(scene: Scene) -> float:
    """Rho g L [Pa], with gravity reduced by buoyancy."""
    return scene.filament.density * gravity_of(scene) * scene.filament.span


def buoyant_share(scene: Scene) -> float:
    """rho_b/rho; 0 if a list of effects, the paper's list or the printed closure leaves buoyancy out."""
    in_bath = may_have(scene, "buoyancy") and scene.run.closure != "printed"
    return scene.surroundings.density / scene.filament.density if in_bath else 0.0


def effective_viscosity(scene: Scene) -> float | None:
    """Stress over flow rate [Pa s] at a stress of rho g L beyond yield, or eta where the two are proportional.

    None for a law that does not flow, 0 if the rule gives no number.
    """
    return effective_viscosity_at(scene, weight_stress(scene) or 1.0)


def effective_viscosity_at(scene: Scene, stress: float) -> float | None:
    """Stress over flow rate [Pa s] at a stress [Pa] beyond yield; None for a law that does not flow.

    0 if the rule gives no number.
    """
    material = scene.material
    if material.modes:
        return hot_viscosity_factor(scene) * sum(mode.viscosity for mode in material.modes)
    if scene.material.spec.has_chains:
        # In slow flow chains have the tensile viscosity E lambda.
        chains = (material.youngs_modulus or 0.0) * (material.relaxation_time or 0.0)
        return hot_viscosity_factor(scene) * (chains + (material.solvent_viscosity or 0.0))
    if material.formula is not None:
        values = material.values()
        values["viscosity"] = values.get("viscosity", 0.0) * hot_viscosity_factor(scene)
        rate = material.formula.value(material.threshold + stress, values)
        return stress / rate if rate > 0 and math.isfinite(rate) else 0.0
    if material.viscosity is None:
        return None
    consistency = material.viscosity * hot_viscosity_factor(scene)
    return float(consistency ** (1 / material.index) * stress ** (1 - 1 / material.index))


def hot_viscosity_factor(scene: Scene) -> float:
    """Viscosity at the highest temperature of the scene over the stated one."""
    heat = scene.temperature
    if not (heat.present and may_have(scene, "temperature")):
        return 1.0
    return viscosity_factor(scene, heat.extremes(scene.run.duration)[1])


def viscous_number(scene: Scene) -> float | None:
    """V = eta/(rho sqrt(g L^3)) (3.10) with the effective viscosity; infinite without gravity."""
    viscosity = effective_viscosity(scene)
    # Inertia is not reduced by buoyancy.
    density, span = scene.filament.density, scene.filament.span
    impulse = density * math.sqrt(gravity_of(scene) * span * span * span)
    return viscosity if viscosity is None else viscosity / impulse if impulse > 0 else math.inf


def duration_star(scene: Scene) -> float:
    """Duration of the run in units of sqrt(L/g); zero without gravity."""
    return scene.run.duration / fall_time(scene)


def beam_of(scene: Scene) -> Beam:
    """The straight beam between the scene's ends; with a free end, a cantilever."""
    nearest, modulus = beam_between(*scene.ends.supports), instant_modulus(scene)
    if not scene.ends.springs or not modulus:
        return nearest
    length = scene.filament.span
    turning = modulus * section_of(scene).gyration * undeformed_area(scene) * scene.filament.thickness**2 / length
    (left, left_turn), (right, right_turn) = (scene.ends.stiffness(side) for side in ("left", "right"))
    places = left * length**2 / turning, right * length**2 / turning
    return beam_on_springs(nearest, places, (left_turn / turning, right_turn / turning))


def section_of(scene: Scene) -> CrossSection:
    """The scene's cross-section."""
    return CROSS_SECTIONS[scene.filament.section]


def bending_stiffness(scene: Scene) -> float:
    """K delta^2 over the sag factor C of the beam: the linear beam sags by 1/(this E*), or t*/(this V) (2.18)."""
    return section_of(scene).gyration / beam_of(scene).midspan_sag * groups_of(scene).delta ** 2


def first_yield_gravity_number(scene: Scene) -> float:
    """G below which no fibre yields under a slowly applied weight: 2 delta for a clamped rectangle (3.11).

    It is a value of :func:`gravity_number_of`, and includes the part of the weight that surface tension carries.
    """
    plain = first_yield(section_of(scene), beam_of(scene), groups_of(scene).delta)
    return plain / moment_left_by_surface(scene) * share_of_yield(scene)


def yields_throughout(scene: Scene) -> bool:
    """Whether the weight is so far beyond first yield that the section has no elastic core."""
    gravity_number = gravity_number_of(scene)
    return gravity_number is not None and gravity_number > _THROUGHOUT * first_yield_gravity_number(scene)


def share_of_yield(scene: Scene) -> float:
    """Yield stress over the holding stress: 1 without surface tension, which does not load fibres in bending."""
    limit, holding = yield_stress_of(scene), holding_stress_of(scene)
    return limit / holding if limit and holding else 1.0


def smaller_of(bending: float, stretching: float) -> float:
    """Half the harmonic mean of two sags, below the smaller one: close to it if one resistance dominates."""
    return 1 / (1 / bending + 1 / stretching) if bending > 0 and stretching > 0 else 0.0


def elastic_sag(scene: Scene) -> float:
    """Static sag over span of the elastic filament: linear beam and elastic cable together (THEORY 11)."""
    modulus, weight = static_modulus(scene), weight_stress(scene)
    if modulus is None or weight == 0:
        return 0.0
    stiff = modulus / weight
    return smaller_of(1 / (bending_stiffness(scene) * stiff), (3 / (64 * stiff)) ** (1 / 3))


def collapse_gravity_number(scene: Scene) -> float:
    """G from which the hinges of the plastic beam turn."""
    return plastic_collapse(section_of(scene), beam_of(scene), groups_of(scene).delta) * share_of_yield(scene)


def neck_length(scene: Scene) -> float:
    """Half the shortest unstable wavelength, pi sqrt(beta) h0 [m], the shortest length of a neck."""
    filament = scene.filament
    beta = section_of(scene).neck(filament.width / filament.thickness)
    return math.pi * math.sqrt(beta) * filament.thickness


def neck_folds(scene: Scene, strain: float) -> float:
    """E-folds by which an unevenness grows in the run, at the rate sigma/eta = sigma_Y/eta + the rate of strain.

    Surface tension adds half its pull to sigma (Plateau & Rayleigh).
    """
    gravity_number, limit = gravity_number_of(scene), yield_stress_of(scene)
    viscosity = effective_viscosity(scene)
    stress = (limit or 0.0) + pull_of_surface(scene) / 2
    yields = limit is None or (gravity_number or 0.0) > first_yield_gravity_number(scene)
    if not viscosity or not yields or scene.material.spec.is_solid:
        return strain
    return strain + stress / viscosity * scene.run.duration


def added_mass_ratio(scene: Scene) -> float:
    """Mass of the surrounding fluid that moves with the filament over the filament's own mass."""
    filament = scene.filament
    coefficient = math.pi / 4 * filament.width / filament.thickness if filament.section == "rectangle" else 1.0
    return coefficient * scene.surroundings.density / filament.density


def initial_strain(scene: Scene) -> tuple[float, ...]:
    """Mean plastic strain at t = 0, equally spaced along the filament: as given, or by a relaxed surface.

    The latter gives the stress -min(Gam, sigma_Y): before it was held, the filament could shorten by yielding.
    """
    limit, modulus = yield_stress_of(scene), instant_modulus(scene)
    if scene.initial.surface == "fresh" or scene.material.spec.is_solid or limit is None or modulus is None:
        return scene.initial.P
    section = section_of(scene)
    limit /= PLANE_STRAIN if section.plane_strain else 1.0
    stiff = section.stiffness(modulus, scene.material.poisson)
    pulls = [surface_stress(scene, relative) for relative in scene.filament.profile or (1.0,)]
    return tuple(min(pull, limit) / stiff for pull in pulls)


def surface_note(scene: Scene) -> str:
    """Text on the assumption about the time before t = 0."""
    if scene.initial.surface == "fresh":
        return "surface tension acts at once on a filament without stress (initial.surface = 'fresh')"
    start = f"begins at the stretch {surface_stretch(scene):.6g} of its stress-free length"
    if not scene.material.spec.is_solid:
        stress = min(surface_stress(scene), yield_stress_of(scene) or 0.0)
        start = f"begins with the stress {-stress:.4g} Pa, at most the yield stress"
    return f"surface tension acted before t = 0 (initial.surface = 'relaxed'): the filament {start}"
