"""All tables of a scene, and what must hold of the motion of its ends and of its temperature."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Annotated, Literal, TypeVar

from softcat_sym.scene.bodies import BODIES, Body, Floor, Pillars
from softcat_sym.scene.ends import Ends
from softcat_sym.scene.extrusion import Extrusion
from softcat_sym.scene.history import History
from softcat_sym.scene.laws import laws_with
from softcat_sym.scene.material import EFFECT_TABLES, EffectTable, Material
from softcat_sym.scene.parts import (
    Filament,
    Initial,
    Load,
    Numerics,
    Part,
    Point,
    Rule,
    RunSettings,
    Surroundings,
)
from softcat_sym.scene.temperature_table import FROZEN, MOST, Temperature
from softcat_sym.scene.units import TEXT, Choice

_OF_LAW: dict[str, tuple[str, ...]] = {
    "constant": (),
    "vft": ("B", "T_0"),
    "wlf": ("C1", "C2", "reference"),
    "arrhenius": ("activation_energy", "reference"),
}
"""Constants that each law of the viscosity needs; VFT also A or reference."""

_ENDING = ("vft", "wlf")
"""Laws whose viscosity is infinite at some temperature."""

Model = Literal["filament", "small-deflection"]


class Tables(Part):
    """What a scene file holds; :class:`softcat_sym.scene.scene.Scene` reads it, and sees that it goes together."""

    title: Annotated[str, TEXT] = ""
    """Title for pictures and tables."""
    model: Annotated[Model, Choice(Model)] = "filament"
    """The theory: the filament with all its effects, or small deflections of an elastic or Maxwell one."""
    filament: Filament
    material: Material
    ends: Ends = Ends()
    load: Load = Load()
    initial: Initial = Initial()
    surroundings: Surroundings = Surroundings()
    temperature: Temperature = Temperature()
    floor: Floor = Floor()
    pillars: Pillars = Pillars()
    extrusion: Extrusion = Extrusion()
    run: RunSettings
    numerics: Numerics = Numerics()
    effects: Annotated[tuple[EffectTable, ...], EFFECT_TABLES] = ()
    """Constants of effects that other packages register, a table [effects.NAME] each."""


def right_places(scene: Tables) -> list[Point]:
    """Return the places of the right support seen from the left one, first and at each row of its motion [m]."""
    first = (scene.filament.span, -scene.ends.drop)
    aside = (*first, 0.0)
    return [first, *(tuple(map(sum, zip(aside, moved, strict=False))) for _, *moved in scene.ends.motion)]


def farthest(scene: Tables) -> float:
    """Return the greatest distance of the supports at any time [m]; a straight path has it at one of its ends."""
    return max(math.hypot(*place) for place in right_places(scene))


def nearest(scene: Tables) -> float:
    """Return the least distance of the supports at any time [m]."""
    path = right_places(scene)
    return min((_to_origin(a, b) for a, b in pairwise(path)), default=math.hypot(*path[0]))


def motion_rules(scene: Tables) -> Iterator[Rule]:
    """List what may be wrong with the motion and the twist of the right support."""
    thickness, path = scene.filament.thickness, "ends.motion"
    still = 'a first row without displacement, such as ["0.0 s", "0 m", "0 m"]'
    yield from _rules_of_rows(path, scene.ends.motion, "moves the support at once", still)
    if scene.ends.motion:
        found = f"the supports come within {nearest(scene):.4g} m of each other"
        yield nearest(scene) < thickness, path, found, f"a path that keeps them the thickness apart, {thickness:g} m"
    still = 'a first row without turn, such as ["0.0 s", "0 deg"]'
    yield from _rules_of_rows("ends.right_twist", scene.ends.right_twist, "turns the clamp at once", still)


def _rules_of_rows(path: str, rows: tuple[tuple[float, ...], ...], at_once: str, accepted: str) -> Iterator[Rule]:
    """List what may be wrong with rows of a time and what has changed by then."""
    if not rows:
        return
    times = [row[0] for row in rows]
    yield min(times) < 0, path, f"a row at {min(times):g} s, before the start", "times from 0 s on"
    back = next(((before, after) for before, after in pairwise(times) if after <= before), None)
    if back:
        yield True, path, f"a row at {back[1]:g} s after one at {back[0]:g} s", "times that increase from row to row"
    yield any(rows[0][1:]), path, f"the first row, at {times[0]:g} s, {at_once}", accepted


def _to_origin(start: Point, end: Point) -> float:
    """Distance of the origin from the straight line between two points."""
    # The first place of all has no third coordinate.
    start = (*start, 0.0)[: len(end)]
    along = [after - before for before, after in zip(start, end, strict=True)]
    squared = sum(one**2 for one in along)
    if squared == 0:
        return math.hypot(*start)
    at = min(1.0, max(0.0, -sum(a * b for a, b in zip(start, along, strict=True)) / squared))
    return math.hypot(*(a + at * b for a, b in zip(start, along, strict=True)))


def bodies_of(scene: Tables) -> tuple[Body, ...]:
    """Return the bodies that a scene has."""
    return tuple(one for one in (getattr(scene, name) for name in BODIES) if one.present)


SceneT = TypeVar("SceneT", bound=Tables)


def unsupported(scene: SceneT) -> SceneT:
    """Return the scene of what hangs free at the start: over pillars, a filament clamped where their tops end."""
    place = scene.pillars.edge_place
    if place is None:
        return scene
    filament = scene.filament.model_copy(update={"span": 2 * place, "rest_length": None})
    return scene.model_copy(update={"filament": filament, "pillars": Pillars()})


def body_rules(scene: Tables) -> Iterator[Rule]:
    """List what may be wrong with the tables of bodies, and what does not go with them."""
    out, small, printed = "leaving it out", scene.model == "small-deflection", scene.run.closure == "printed"
    for name in BODIES:
        body = getattr(scene, name)
        given = sorted(key for key in body.model_fields_set if key != body.required)
        missing = given and not body.present
        found = f"missing, but {name}.{given[0]} is given" if missing else ""
        yield missing, f"{name}.{body.required}", found, f'a length, such as "0.2 mm", or no table [{name}]'
    for body in bodies_of(scene):
        name, gravity = body.table_name, scene.load.gravity
        yield small, name, "given with model 'small-deflection'", f'{out}, or model = "filament"'
        yield printed, name, "given with run.closure = 'printed'", f'{out}, or run.closure = "material"'
        yield gravity == 0, "load.gravity", f"zero, but [{name}] bears a weight", f"an acceleration, or no [{name}]"
        yield scene.filament.profile, "filament.profile", f"given, but what lies on [{name}] has one thickness", out
    if scene.floor.present:
        yield from _of_floor(scene)
    if scene.pillars.present:
        yield from _of_pillars(scene)


def _of_floor(scene: Tables) -> Iterator[Rule]:
    """The right support stands above it; a belt that nothing couples to the filament drives nothing."""
    floor, depths = scene.floor, [-y for _, y, *_ in right_places(scene)]
    path = "ends.drop" if depths[0] > floor.room() else "ends.motion"
    found = f"the right support comes {max(depths) - floor.room():.3g} m below the floor"
    yield max(depths) > floor.room(), path, found, f"at most floor.depth, {floor.room():.4g} m"
    found = f"{floor.speed:g} m/s, but neither floor.bond nor floor.friction carries the filament along"
    accepted = 'floor.bond = "stick", or a coefficient floor.friction'
    yield floor.speed and not floor.resists_sliding, "floor.speed", found, accepted


def _of_pillars(scene: Tables) -> Iterator[Rule]:
    """Both supports stand over the tops, at the height of the filament at rest."""
    pillars, span, floor = scene.pillars, scene.filament.span, scene.floor
    found = f"{pillars.gap:.4g} m, but the supports are {span:.4g} m apart and stand over the pillars"
    yield (pillars.gap or 0.0) >= span, "pillars.gap", found, f"less than filament.span, {span:.4g} m"
    yield scene.ends.drop, "ends.drop", "given, but the pillars are equally high", "leaving it out"
    found = f"{pillars.height:.4g} m: the filament would begin inside the pillars"
    yield pillars.height > 0, "pillars.height", found, "zero, or a negative length"
    found = f"{floor.room():.4g} m, not below the tops of the pillars"
    yield floor.present and floor.room() <= -pillars.height, "floor.depth", found, "a floor between the pillars"


def temperature_rules(scene: Tables) -> Iterator[Rule]:
    """List what may be wrong with the table [temperature]."""
    heat = scene.temperature
    if not heat.present:
        fields = type(heat).model_fields
        given = sorted(name for name in heat.model_fields_set if getattr(heat, name) != fields[name].default)
        needs = f"missing, but temperature.{given[0]} is given" if given else ""
        yield given, "temperature.initial", needs, 'a temperature, such as "20 degC", or no table [temperature]'
        return
    yield from _of_exchange(scene, heat)
    yield from _of_the_law(scene, heat)
    # What a law of the viscosity says of the temperatures of the scene; below where it ends a strand is frozen.
    if heat.law == "vft" and heat.T_0 is not None and heat.reference is not None:
        found = f"{heat.T_0:g} K, not below the reference {heat.reference:g} K: the viscosity there would be infinite"
        yield heat.reference <= heat.T_0, "temperature.T_0", found, f"a temperature below {heat.reference:g} K"
    for kelvin in {*heat.extremes(scene.run.duration)}:
        factor = heat.viscosity_factor(kelvin)
        found = f"'{heat.law}', whose viscosity at {kelvin:g} K is {factor:.3g} times that of [material]"
        broken = factor <= 1 / MOST or (factor >= MOST and heat.law not in _ENDING)
        yield broken, "temperature.law", found, "constants that fit the temperatures of the scene"


def _of_exchange(scene: Tables, heat: Temperature) -> Iterator[Rule]:
    out, either = "leaving it out", "temperature.heat_transfer, or temperature.correlation"
    found = "missing: it says how much heat a temperature is"
    yield heat.heat_capacity is None, "temperature.heat_capacity", found, 'such as "1200 J/(kg*K)"'
    small = scene.model == "small-deflection"
    yield small, "temperature", "given with model 'small-deflection'", f'{out}, or model = "filament"'
    printed = scene.run.closure == "printed"
    yield printed, "temperature", "given with run.closure = 'printed'", f'{out}, or run.closure = "material"'
    named, twice = heat.correlation != "none", "given twice, here and as temperature.correlation"
    yield named and heat.heat_transfer is not None, "temperature.heat_transfer", twice, "one of the two"
    round_ = scene.filament.section == "circle"
    found = f"'{heat.correlation}', but the section is a {scene.filament.section}"
    yield named and not round_, "temperature.correlation", found, "temperature.heat_transfer, or a circle"
    weightless = named and scene.load.gravity == 0
    found = f"'{heat.correlation}', but load.gravity is zero, without which no air rises"
    yield weightless, "temperature.correlation", found, "temperature.heat_transfer"
    alone, deaf = heat.ambient is not None, "given, but no heat passes the surface"
    yield alone and not named and heat.heat_transfer is None, "temperature.ambient", deaf, either
    lost = named or heat.heat_transfer
    yield lost and not alone, "temperature.ambient", "missing, but heat passes the surface", 'such as "20 degC"'
    found = "missing: temperature.heated leaves a part of the filament out of the furnace"
    yield heat.heated and heat.outside is None, "temperature.outside", found, 'a temperature, such as "20 degC"'
    found = "given, but the whole filament is at temperature.ambient"
    yield heat.outside is not None and not heat.heated, "temperature.outside", found, f"{out}, or temperature.heated"


def _of_the_law(scene: Tables, heat: Temperature) -> Iterator[Rule]:
    law, needed, material = heat.law, _OF_LAW[heat.law], scene.material.law
    every = {name for names in _OF_LAW.values() for name in names} | {"A"}
    allowed = {*needed, *(("A", "reference") if law == "vft" else ())}
    for name in sorted(every):
        given = getattr(heat, name) is not None
        others = ", ".join(other for other, names in _OF_LAW.items() if name in (*names, *("A",) * (other == "vft")))
        found = f"given, but the law of the viscosity is '{law}'"
        yield given and name not in allowed, f"temperature.{name}", found, f"leaving it out, or law = {others}"
        found = f"missing: the law '{law}' needs it"
        yield not given and name in needed, f"temperature.{name}", found, f"a value, or a law other than '{law}'"
    if law == "vft":
        both, neither = heat.A is not None and heat.reference is not None, heat.A is None and heat.reference is None
        found = "given with temperature.reference: each says how large the viscosity is"
        yield both, "temperature.A", found, "one of the two"
        found = "missing, and so is temperature.reference: nothing says how large the viscosity is"
        yield neither, "temperature.A", found, "one of the two"
    viscous = [*laws_with("viscosity"), *laws_with("modes")]
    fixed = law != "constant" and material not in viscous
    found = f"'{law}', but the material's law '{material}' states no viscosity"
    yield fixed, "temperature.law", found, f"constant, or one of the laws {', '.join(viscous)}"
    lags = scene.material.spec.viscous_stress == "viscosity" or scene.material.has_loss
    found = f"given, but the law '{material}' has a viscous stress, which the rate of the expansion would need"
    path, accepted = "temperature.expansion", "leaving it out, or a law without a viscous stress or a loss below yield"
    yield heat.expansion and lags, path, found, accepted
    stiff = heat.modulus is not None and not scene.material.spec.is_elastic
    yield stiff, "temperature.modulus", "given, but a newtonian fluid has no modulus", "leaving it out"


def frozen_below(scene: Tables) -> float | None:
    """Temperature below which a strand is frozen [K]; None for one that stays where the law of its viscosity holds."""
    heat, material = scene.temperature, scene.material
    if not heat.present or heat.law not in _ENDING:
        return None
    if heat.viscosity_factor(heat.extremes(scene.run.duration)[0]) < MOST:
        return None
    chains = (material.youngs_modulus or 0.0) * (material.relaxation_time or 0.0)
    stated = (material.viscosity, material.solvent_viscosity, chains, *(mode.viscosity for mode in material.modes))
    return heat.frozen_below(max(1.0, FROZEN / max(float(one) for one in stated if one)))


def viscosity_factor(scene: Tables, kelvin: float) -> float:
    """Viscosity of the filament at a temperature over the one that [material] states."""
    return scene.temperature.viscosity_factor(max(kelvin, frozen_below(scene) or 0.0))


def frozen_note(scene: Tables) -> str:
    """From where on the strand is frozen, in words; empty if it never is."""
    if (kelvin := frozen_below(scene)) is None:
        return ""
    return f"below {kelvin - 273.15:.4g} degC the strand is frozen: its viscosity is capped at {FROZEN:.0e} Pa s"


def kinks(scene: Tables) -> tuple[float, ...]:
    """Return the times at which the surroundings begin or cease to change [s]."""
    ambient = scene.temperature.ambient
    return tuple(time for time, _ in ambient.table) if isinstance(ambient, History) else ()
