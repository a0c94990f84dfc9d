"""Every effect there is, in the order in which they are listed."""

from __future__ import annotations

from softcat_sym.effects.bending import BENDING
from softcat_sym.effects.effect import Effect
from softcat_sym.effects.extensibility import EXTENSIBILITY
from softcat_sym.effects.fibres import FIBRES
from softcat_sym.effects.finite_stretch import FINITE_STRETCH
from softcat_sym.effects.gravity_ramp import GRAVITY_RAMP
from softcat_sym.effects.gravity_shaking import GRAVITY_SHAKING
from softcat_sym.effects.inertia import INERTIA
from softcat_sym.effects.large_rotation import LARGE_ROTATION
from softcat_sym.effects.necking_gradient import NECKING_GRADIENT
from softcat_sym.effects.rotary_inertia import ROTARY_INERTIA
from softcat_sym.effects.shear import SHEAR
from softcat_sym.effects.solid_damping import SOLID_DAMPING
from softcat_sym.effects.surface_tension import SURFACE_TENSION
from softcat_sym.effects.thinning import THINNING
from softcat_sym.effects.viscous_flow import VISCOUS_FLOW
from softcat_sym.effects.viscous_stress import VISCOUS_STRESS
from softcat_sym.effects.yielding import YIELDING

REGISTRY: tuple[Effect, ...] = (
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
)
