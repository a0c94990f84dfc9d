"""All effects in the order of lists, and those that other packages register."""

from __future__ import annotations

import re
from dataclasses import replace
from importlib.metadata import EntryPoint, entry_points

from softcat_sym.effects.added_mass import ADDED_MASS
from softcat_sym.effects.backstress import BACKSTRESS
from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.buoyancy import BUOYANCY
from softcat_sym.effects.contact import CONTACT
from softcat_sym.effects.curing import CURING
from softcat_sym.effects.drag import DRAG
from softcat_sym.effects.effect import SMALL_MODEL, Effect, never
from softcat_sym.effects.extensibility import EXTENSIBILITY
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.finite_stretch import FINITE_STRETCH
from softcat_sym.effects.gravity_ramp import GRAVITY_RAMP
from softcat_sym.effects.gravity_shaking import GRAVITY_SHAKING
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.large_rotation import LARGE_ROTATION
from softcat_sym.effects.laying import LAYING
from softcat_sym.effects.natural_strain import NATURAL_STRAIN
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.rotary_inertia import ROTARY_INERTIA
from softcat_sym.effects.shear import SHEAR
from softcat_sym.effects.solid_damping import SOLID_DAMPING
from softcat_sym.effects.structural_build_up import STRUCTURE
from softcat_sym.effects.surface_tension import SURFACE_TENSION
from softcat_sym.effects.temperature import TEMPERATURE
from softcat_sym.effects.thinning import THINNING
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.viscous_stress import VISCOUS_STRESS
from softcat_sym.effects.yielding import YIELDING
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.scene import Scene

REGISTRY: list[Effect] = [
    INERTIA,
    BENDING,
    EXTENSIBILITY,
    FINITE_STRETCH,
    THINNING,
    LARGE_ROTATION,
    VISCOUS_FLOW,
    VISCOUS_STRESS,
    YIELDING,
    GRAVITY_RAMP,
    SHEAR,
    FIBRES,
    NECKING_GRADIENT,
    ROTARY_INERTIA,
    GRAVITY_SHAKING,
    SURFACE_TENSION,
    SOLID_DAMPING,
    BUOYANCY,
    DRAG,
    ADDED_MASS,
    TEMPERATURE,
    CURING,
    STRUCTURE,
    BACKSTRESS,
    NATURAL_STRAIN,
    CONTACT,
    LAYING,
]

ENTRY_POINTS = "softcat_sym.effects"
"""Entry point group of effects from installed packages."""


def register_effect(effect: Effect) -> Effect:
    """Register an effect from outside the package.

    Parameters
    ----------
    effect : Effect
        An effect with its own densities, or with a change of the terms. It replaces an effect of the same name that was
        registered before. An installed package registers its effects by the entry point group ``softcat_sym.effects``.

    Returns
    -------
    Effect
        The registered effect, with default fields filled in.

    Raises
    ------
    ValueError
        If an effect of the package has this name, if it needs an unknown effect, if it adds nothing, or if its
        densities contain unknown symbols.
    """
    names = [one.name for one in REGISTRY]
    if not re.fullmatch(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", effect.name):
        raise ValueError(f"effect {effect.name!r}: a name is lower-case words joined by hyphens")
    if effect.name in names[:_OWN]:
        raise ValueError(f"effect {effect.name!r} belongs to the package")
    if effect.contribute is None and effect.adapt is None and not effect.adds_densities:
        raise ValueError(f"effect {effect.name!r} adds nothing: neither densities nor terms")
    if missing := set(effect.needs) - set(names):
        raise ValueError(f"effect {effect.name!r} needs {', '.join(sorted(missing))}, which is not registered")
    if effect.applies is never:

        def applies(scene: Scene) -> bool:
            given = not effect.constants or any(name == effect.name for name, _ in scene.effects)
            return scene.model == "filament" and given

        without = f"the scene has no [effects.{effect.name}], or {SMALL_MODEL}"
        effect = replace(effect, applies=applies, without_it=effect.without_it or without)
    # The densities are derived once here, so that their faults are found now.
    if effect.adds_densities and effect.densities.of_a_cell and not {"extensibility"} & set(effect.needs):
        effect = replace(effect, needs=(*effect.needs, "extensibility"))
    effect = _of_the_plane(replace(effect, in_paper=False))
    if effect.name in names:
        REGISTRY[names.index(effect.name)] = effect
    else:
        REGISTRY.append(effect)
    return effect


def _of_the_plane(effect: Effect) -> Effect:
    """Exclude an effect with its own densities, which are plane, from three dimensions."""
    own, only = effect.applies, "a scene in three dimensions has no densities but its own"
    if not effect.adds_densities or only in effect.without_it:
        return effect
    without = f"{effect.without_it}, or {only}" if effect.without_it else only
    return replace(effect, applies=lambda scene: own(scene) and not is_spatial(scene), without_it=without)


_OWN = len(REGISTRY)


def _register_installed(point: EntryPoint) -> None:
    """Register the effect of an installed package; SoftcatError, naming the package, whatever is wrong with it."""
    try:
        effect = point.load()
        if not isinstance(effect, Effect):
            raise TypeError(f"it is no softcat_sym.Effect but of type {type(effect).__name__}")
        register_effect(effect)
    except (Exception, SystemExit) as error:
        package = point.dist.name if point.dist else "unknown"
        reason = " ".join(f"{type(error).__name__}: {error}".split())
        raise SoftcatError(
            f"package {package}, entry point {point.name} = {point.value} of {ENTRY_POINTS}: {reason}; "
            "mend or uninstall the package"
        ) from error


for _point in entry_points(group=ENTRY_POINTS):
    _register_installed(_point)
