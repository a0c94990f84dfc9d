"""Initial stress of a filament: given, or in equilibrium with a relaxed surface."""

from __future__ import annotations

from softcat_sym.estimates.scaling import instant_modulus, section_of, surface_stress, yield_stress_of
from softcat_sym.physics.cross_sections import PLANE_STRAIN
from softcat_sym.scene.scene import Scene, surface_stretch


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
