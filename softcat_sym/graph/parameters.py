"""The inputs of a graph: material, geometry and load by the names of the scene, in SI units."""

from __future__ import annotations

from dataclasses import dataclass

from softcat_sym.equations import symbols
from softcat_sym.equations.bulk import nu
from softcat_sym.equations.necking import aspect
from softcat_sym.scene import Scene, elastic_time, gravity_time

SPAN = "span"
TIME_SCALE = "time_scale"


@dataclass(frozen=True, slots=True)
class Parameter:
    """A numeric input of the graph: its leaf name in the scene, its symbol and its unit."""

    name: str
    symbol: symbols.Symbol
    unit: str


CATALOGUE: tuple[Parameter, ...] = (
    Parameter(SPAN, symbols.L, "m"),
    Parameter("thickness", symbols.h0, "m"),
    Parameter("density", symbols.rho, "kg/m^3"),
    Parameter("gravity", symbols.g, "m/s^2"),
    Parameter("ramp", symbols.g_on, "s"),
    Parameter("youngs_modulus", symbols.E, "Pa"),
    Parameter("viscosity", symbols.eta, "Pa*s"),
    Parameter("yield_stress", symbols.sigma_Y, "Pa"),
    Parameter("poisson", nu, "1"),
    Parameter("aspect", aspect, "1"),
)


def time_scale(scene: Scene) -> float:
    """Unit of time [s]: sqrt(L/g), or L sqrt(rho/E) without gravity."""
    gravity_unit = gravity_time(scene)
    return gravity_unit if gravity_unit < float("inf") else elastic_time(scene)


def parameter_values(scene: Scene) -> dict[str, float]:
    """Values of every parameter that a graph of this scene may ask for, in SI units."""
    material = scene.material
    candidates = {
        SPAN: scene.filament.span,
        "thickness": scene.filament.thickness,
        "density": scene.filament.density,
        "gravity": scene.load.gravity,
        "ramp": scene.load.ramp,
        "youngs_modulus": material.youngs_modulus,
        "viscosity": material.viscosity,
        "yield_stress": material.yield_stress,
        "poisson": material.poisson,
        "aspect": scene.filament.width / scene.filament.thickness,
        TIME_SCALE: time_scale(scene),
    }
    return {name: value for name, value in candidates.items() if value is not None}
