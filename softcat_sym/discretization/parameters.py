"""The numbers that a filament is given, by their names in a scene."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

from softcat_sym.discretization.supports import (
    DIRECTION,
    DROP,
    END_TURNS,
    GUIDE,
    LEFT_ANGLE,
    NOZZLE_PLACE,
    POINT_MASS,
    RIGHT_ANGLE,
    SPAN,
    STUB,
    TIP_FORCE,
    TIP_MASS,
    TIP_TORQUE,
    feed_name,
    path_name,
    turn_name,
)
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.estimates.free_vibration import solid_viscosity
from softcat_sym.estimates.scaling import effective_viscosity, instant_modulus
from softcat_sym.scene.feed import exit_angle, feed_rows, laid_at, nozzle_path, stub_length
from softcat_sym.scene.history import History, named_numbers
from softcat_sym.scene.material import Material, constant_in_c
from softcat_sym.scene.natural_curve import has_shape, natural_curve
from softcat_sym.scene.scene import Scene, elastic_time, gravity_time, rest_length, undeformed_area
from softcat_sym.scene.tables import frozen_below
from softcat_sym.scene.temperature_table import PREFIX

REST_LENGTH = "rest_length"
AREA = "area"
TIME_SCALE = "time_scale"


def time_scale(scene: Scene) -> float:
    """Unit of time [s]: sqrt(L/g), or L sqrt(rho/E) without gravity, or else the duration of the run."""
    gravity_unit = gravity_time(scene)
    if gravity_unit < float("inf"):
        return gravity_unit
    return elastic_time(scene) or scene.run.duration


def history_values(material: Material) -> dict[str, float]:
    """Numbers that the histories of a material are computed from."""
    changing = {**material.histories(), **material.natural_strains()}
    return {key: value for name, one in changing.items() for key, value in named_numbers(name, one).items()}


def parameter_values(scene: Scene) -> dict[str, float]:
    """Values of every parameter that a graph of this scene may ask for, in SI units."""
    filament, ends = scene.filament, scene.ends
    path = {
        path_name(kind, row): value
        for row, point in enumerate(ends.motion)
        for kind, value in zip(("time", "dx", "dy", "dz"), point, strict=False)
    }
    path |= _of_nozzle(scene)
    path |= {
        turn_name(kind, row): value
        for row, point in enumerate(ends.right_twist)
        for kind, value in zip(("time", "angle"), point, strict=True)
    }
    return {
        REST_LENGTH: rest_length(scene),
        "thickness": filament.thickness,
        "density": filament.density,
        "gravity": scene.load.gravity,
        "ramp": scene.load.ramp,
        "shake": scene.load.shake,
        "shake_frequency": scene.load.shake_frequency,
        "aspect": filament.width / filament.thickness,
        "curvature": filament.curvature,
        "twist": filament.twist,
        "bath_density": scene.surroundings.density,
        "bath_viscosity": scene.surroundings.viscosity,
        "surface_tension": scene.surroundings.surface_tension,
        AREA: undeformed_area(scene),
        POINT_MASS: scene.load.point_mass / undeformed_area(scene),
        TIP_MASS: scene.load.tip_mass / undeformed_area(scene),
        **dict(zip(TIP_FORCE, (one / undeformed_area(scene) for one in scene.load.tip_force), strict=True)),
        **dict(zip(TIP_TORQUE, (one / undeformed_area(scene) for one in scene.load.tip_torque), strict=True)),
        **dict(zip(DIRECTION, scene.load.direction, strict=True)),
        SPAN: filament.span,
        DROP: ends.drop,
        LEFT_ANGLE: ends.left_angle,
        RIGHT_ANGLE: exit_angle(scene) if scene.extrusion.present else ends.right_angle,
        **ends.springs,
        TIME_SCALE: time_scale(scene),
        "poisson": scene.material.poisson,
        "solid_viscosity": solid_viscosity(scene),
        **_of_temperature(scene),
        **scene.material.values(),
        **history_values(scene.material),
        **{name: one for effect in REGISTRY if effect.applies(scene) for name, one in effect.values(scene).items()},
        **{constant_in_c(path): one.value for path, one in scene.named_constants().items()},
        **path,
        **_of_clamps(scene),
    }


def _of_nozzle(scene: Scene) -> dict[str, float]:
    """Numbers of a nozzle that lays the strand; none of another."""
    if not scene.extrusion.present:
        return {}
    rows, feeds, stub = nozzle_path(scene), feed_rows(scene), stub_length(scene)
    first = rows[0][1:]
    found = {STUB: stub, **dict(zip(NOZZLE_PLACE, first, strict=True))}
    for row, (time, x, y) in enumerate(rows):
        found |= {path_name("time", row): time, path_name("dx", row): x - first[0], path_name("dy", row): y - first[1]}
    for row, (time, feed) in enumerate(feeds):
        found |= {feed_name("time", row): time, feed_name("speed", row): feed}
    # As stiff as the strand, or as much as a fluid resists on a grid of a hundred cells while one comes out.
    modulus, fed = instant_modulus(scene), rest_length(scene) - stub
    rate = 1e3 * fed / (rest_length(scene) * laid_at(scene))
    return found | {GUIDE: modulus or (effective_viscosity(scene) or 0.0) * rate}


def _of_clamps(scene: Scene) -> dict[str, float]:
    """Turns of clamps that hold the ends of a shape; none of a straight filament."""
    if not has_shape(scene):
        return {}
    curve = natural_curve(scene)
    turns = curve.quaternions(np.array([0.0, curve.length]))
    return dict(zip(itertools.chain(*END_TURNS), turns.ravel().tolist(), strict=True))


def _of_temperature(scene: Scene) -> dict[str, float]:
    """Numbers of a filament with a temperature, by their names; none of one without."""
    heat = scene.temperature
    if not heat.present:
        return {}
    begin, end = heat.heated or (0.0, 0.0)
    values: dict[str, object] = {name: getattr(heat, name) for name in type(heat).model_fields}
    values |= {"heated_begin": begin, "heated_end": end, "activation_temperature": heat.activation_temperature}
    values["frozen"] = frozen_below(scene)
    found = {f"{PREFIX}{name}": float(value) for name, value in values.items() if isinstance(value, (int, float))}
    for name, value in values.items():
        found |= named_numbers(f"{PREFIX}{name}", value) if isinstance(value, History) else {}
    return found


def energy_scale(density: Any, span: Any, time_scale: Any) -> Any:
    """Unit of the quadratures [Pa]: density times the square of span over time scale.

    An integrator that controls the quadratures measures them with the tolerances of the unknowns, so they have the same
    size whatever the units of the scene.
    """
    return density * (span / time_scale) ** 2


def heat_unit(density: float, capacity: float, kelvin: float) -> float:
    """Heat of a unit of volume at its initial temperature [Pa]: the unit in which lost heat is integrated."""
    return density * capacity * kelvin
