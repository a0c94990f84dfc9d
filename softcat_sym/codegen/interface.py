"""A scene's filament as C sees it, and the texts around its physics: C, header, parameters."""

from __future__ import annotations

import itertools
import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import resources
from typing import Any, NamedTuple

import jinja2
import numpy as np

from softcat_sym.codegen.c_model import Model, Structure
from softcat_sym.codegen.c_text import VERSIONS, CSource, c_array, number
from softcat_sym.discretization.assembly import asked_points, in_halves
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.grid import choose_grading, towards_middle
from softcat_sym.discretization.parameters import history_values, parameter_values
from softcat_sym.discretization.supports import (
    DIRECTION,
    END_TURNS,
    NATURAL_PLACES,
    TIP_FORCE,
    TIP_MASS,
    TIP_TORQUE,
)
from softcat_sym.discretization.unknowns import PER_FIBRE, TURN
from softcat_sym.effects.selection import Effects
from softcat_sym.errors import PrintingError
from softcat_sym.estimates.scaling import initial_strain
from softcat_sym.physics.section_equations import PARAMETERS
from softcat_sym.scene.material import NamedConstant, constant_in_c
from softcat_sym.scene.parts import kinds_of
from softcat_sym.scene.scene import Scene, force_free_stretch
from softcat_sym.scene.temperature_table import PREFIX, Temperature
from softcat_sym.scene.units import si_unit

MIN_CELLS = 4
"""Per half span: with fewer, the two ends see each other."""

_UNITS = {
    "span": "m",
    "area": "m^2",
    "drop": "m",
    "left_angle": "rad",
    "right_angle": "rad",
    "point_mass_per_area": "kg/m^2",
    TIP_MASS: "kg/m^2",
    **dict.fromkeys(TIP_FORCE, "N/m^2"),
    **dict.fromkeys(TIP_TORQUE, "N/m"),
    "time_scale": "s",
    "second_modulus": "Pa",
    "index": "1",
}
_ENDINGS = {"_time": "s", "_dx": "m", "_dy": "m", "_dz": "m", "_youngs_modulus": "Pa", "_viscosity": "Pa*s"}
_ENDINGS |= {"_angle": "rad", "_rotational_stiffness": "N*m/rad", "_stiffness": "N/m"}

_MEANINGS = {
    "area": "undeformed, of the section",
    "rest_length": "length of the undeformed filament",
    "thickness": "of the section; the diameter of a circle",
    "gravity": "acceleration",
    "ramp": "time within which gravity comes on, 0 at once",
    "shake": "amplitude with which gravity oscillates, over g",
    "shake_frequency": "cycles in a second",
    "viscosity": "extensional",
    "yield_stress": "in tension",
    "index": "exponent n of the flow",
    "poisson": "used by shear only",
    "curvature": "natural",
    "aspect": "width over thickness",
    "bath_density": "of what surrounds the filament",
    "bath_viscosity": "shear viscosity of what surrounds the filament",
    "surface_tension": "of the filament's surface",
    "span": "horizontal distance between the supports",
    "drop": "of the right support below the left one",
    "left_angle": "of the clamp, counterclockwise",
    "right_angle": "of the clamp, counterclockwise",
    "point_mass_per_area": "mass at midspan over the undeformed section",
    TIP_MASS: "mass at the free end over the undeformed section",
    **dict.fromkeys(TIP_FORCE, "force at the free end over the undeformed section"),
    **dict.fromkeys(TIP_TORQUE, "torque at the free end over the undeformed section"),
    **dict.fromkeys(DIRECTION, "of gravity; the three make a vector of length one"),
    **{name: "of the quaternion of a clamp, of length one" for turn in END_TURNS for name in turn},
    **dict.fromkeys(("left_stiffness", "right_stiffness"), "of the spring between an end and its support"),
    **dict.fromkeys(("left_rotational_stiffness", "right_rotational_stiffness"), "of the spring that turns it back"),
    "time_scale": "unit of time in which the computation works; 0: sqrt(rest_length / gravity)",
}


@dataclass(frozen=True, slots=True)
class Given:
    """A parameter of a filament."""

    name: str  # SI
    unit: str
    meaning: str
    bound: str  # ``any``, ``not-negative``, ``positive`` or ``poisson``
    value: float  # That of the scene


class StepSettings(NamedTuple):
    """How a scene is integrated."""

    relative: float  # Tolerances
    absolute: float
    absolutes: tuple[float, ...]  # Of each slot
    method: int  # As softcat_rosenbrock.h numbers them
    largest_step: float  # [s]; 0 for none


@dataclass(frozen=True)
class Description:
    """A scene's filament as C sees it."""

    scene: Scene  # What was asked
    effects: Effects  # The physics in force
    graph: Graph  # On the scene's grid
    structure: Structure  # What its text depends on
    model: Model  # Its physics as C text
    steps: StepSettings

    @property
    def title(self) -> str:
        """Of the scene."""
        return self.scene.title or "a filament"

    @cached_property
    def digest(self) -> str:
        """Of the text of the physics: two filaments share a structure if theirs are the same, whatever their fibres."""
        return CSource({"model.c": self.model.of_any_fibres}).digest

    @cached_property
    def parameters(self) -> tuple[Given, ...]:
        """In the order of the model."""
        values, names = parameter_values(self.scene), self.model.parameters
        units = {name: _unit(self.scene, name, names) for name in names}
        return tuple(
            Given(
                name,
                unit,
                "consistency K of the flow" if unit == "Pa*s^n" else _MEANINGS.get(name, ""),
                _bound(self.scene, name),
                float(values[name]),
            )
            for name, unit in units.items()
        )

    @property
    def on_cells(self) -> tuple[bool, ...]:
        """Whether each slot belongs to the cell of its site."""
        return tuple(slot.on == "cell" for slot in self.model.slots)

    @property
    def profiles(self) -> list[tuple[float, float]]:
        """What each slot is of a plastic strain that is linear through the thickness.

        Of a fibre it is what its coordinate is multiplied by.
        """
        signature, each = self.model.template.signature, range(self.model.fibres)
        kinds = [slot.name for slot in signature.slots for _ in (each if PER_FIBRE in slot.name else (0,))]
        return [signature.profiles.get(kind, (0.0, 0.0)) for kind in kinds]

    @property
    def cells(self) -> int:
        """Per half span."""
        return self.graph.grid.cells if self.graph.grid.is_half else self.graph.grid.cells // 2

    @property
    def fibres(self) -> int:
        """Asked of the section; 0 where it is not resolved by them."""
        theory = self.structure.recorded.theory
        if theory.fibres is None:
            return 0
        return asked_points(self.scene, self.effects.terms()) if theory.is_spatial else theory.fibres.points

    @property
    def section(self) -> str:
        """How fibres are placed, as softcat_solve.h names it."""
        circle = self.scene.filament.section == "circle"
        if self.structure.recorded.theory.is_spatial:
            return "RINGS" if circle else "WARPING"
        return ("CIRCLE" if circle else "RECTANGLE") + "_IN_HALVES" * in_halves(self.scene, self.effects.terms())

    @property
    def grading(self) -> float:
        """Ratio of the longest cell to the shortest."""
        return float(self.scene.numerics.grading or choose_grading(self.scene, self.cells, self.effects))

    @property
    def natural(self) -> tuple[float, ...]:
        """Of cells from left to right: X, twist and curvatures of a shape [1/m]."""
        natural = self.structure.recorded.body.natural
        return () if natural is None else tuple(np.column_stack([self.graph.grid.centres, natural]).ravel().tolist())


def _named_by_user(scene: Scene) -> dict[str, NamedConstant]:
    """Constants that only this scene has, by their names in C."""
    return {constant_in_c(path): one for path, one in scene.named_constants().items()}


def _unit(scene: Scene, name: str, names: tuple[str, ...]) -> str:
    if name == "viscosity" and "index" in names:
        return "Pa*s^n"
    known = {one.name: one.unit for one in PARAMETERS} | _UNITS
    if name in known:
        return known[name]
    if name.startswith(PREFIX):
        kind = kinds_of(Temperature).get(name.removeprefix(PREFIX))
        kelvin = "K" if name.startswith(f"{PREFIX}activation") else "m" if name.startswith(f"{PREFIX}heated") else "1"
        return kind.unit if kind and kind.unit else kelvin
    own = _named_by_user(scene)
    if name in own:
        return str(si_unit(own[name].dimension)).replace(" ", "") or "1"
    return next((unit for ending, unit in _ENDINGS.items() if name.endswith(ending)), "1")


_ANY = ("curvature", "twist", "drop", "left_angle", "right_angle", *TIP_FORCE, *TIP_TORQUE, *DIRECTION)
_WEIGHT = ("gravity", "ramp", "shake", "shake_frequency", "point_mass_per_area", "time_scale", TIP_MASS)
_NOT_NEGATIVE = (*_WEIGHT, "surface_tension", "bath_density", "bath_viscosity")
_BOUNDS = {"poisson": "poisson", **dict.fromkeys((*_ANY, *itertools.chain(*END_TURNS)), "any")}
_BOUNDS |= dict.fromkeys(_NOT_NEGATIVE, "not-negative")


def _bound(scene: Scene, name: str) -> str:
    if name.startswith(PREFIX) or name in {*_named_by_user(scene), *history_values(scene.material)}:
        return "any"
    if name.startswith(("motion_", "turn_")):
        return "not-negative" if name.endswith("_time") else "any"
    return _BOUNDS.get(name, "positive")


DEFAULT_NAME = "filament"

_RANGES = {
    "any": "SOFTCAT_ANY",
    "not-negative": "SOFTCAT_NOT_NEGATIVE",
    "positive": "SOFTCAT_POSITIVE",
    "poisson": "SOFTCAT_POISSON",
}
_PLACES = frozenset({"X", "cell", "node", "mass", "per_cell", "per_node", "per_mass", "h_node", "h_cell", "hung"})
_PLACES |= set(NATURAL_PLACES)
_KNOWN = (
    *("rest_length", "time_scale", "gravity", "density", "span", "drop", "left_angle", "right_angle"),
    *("curvature", "twist"),
)


def prefix_of(name: str) -> str:
    """What the names of the functions begin with: no other than the default may begin as those of the runtime do."""
    return "softcat" if name == DEFAULT_NAME else name


def symbol_of(name: str, what: str) -> str:
    """Name of the model or the structure that the file exports."""
    return f"softcat_{name}_{what}" if name == DEFAULT_NAME else f"{name}_{what}"


def constant(text: str) -> str:
    """A name as part of a C constant."""
    return re.sub(r"\W", "_", text, flags=re.ASCII).upper()


@cache
def _templates() -> jinja2.Environment:
    folder = resources.files("softcat_sym.codegen") / "templates"
    loader = jinja2.FunctionLoader(lambda name: (folder / name).read_text(encoding="utf-8"))
    return jinja2.Environment(
        loader=loader,
        autoescape=False,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=jinja2.StrictUndefined,
    )


def rendered(template: str, **values: Any) -> str:
    """A file of codegen/templates, filled in."""
    return _templates().get_template(template).render(**values)


def comment(lines: Sequence[str]) -> str:
    """Lines as a C comment that nothing in them can end."""
    safe = [re.sub(r"\?(?=\?)", "? ", line.replace("*/", "* /").replace("/*", "/ *")) for line in lines]
    options = {"subsequent_indent": "    ", "break_on_hyphens": False}
    wrapped = [part for line in safe for part in textwrap.wrap(line, 96, **options) or [""]]  # type: ignore[arg-type]
    return "\n".join(["/*", *(f" * {line}".rstrip() for line in wrapped), " */"])


def quoted(text: str) -> str:
    """A C string."""

    def escaped(sign: str) -> str:
        if sign in '"\\?':
            return f"\\{sign}"
        # Octal: unlike hexadecimal, it ends after three digits.
        return sign if sign.isascii() and sign.isprintable() else "".join(f"\\{byte:03o}" for byte in sign.encode())

    return f'"{"".join(map(escaped, text))}"'


def heading(described: Description, command: str) -> str:
    """The comment that stands above all generated text."""
    return comment(
        [
            described.title,
            "",
            f"Generated, do not edit; written by: {command}",
            ", ".join(f"{package} {version}" for package, version in VERSIONS.items()),
            f"Effects: {', '.join(described.effects.names)}",
            f"Digest of the structure: {described.digest}",
        ]
    )


def _lists(described: Description) -> dict[str, tuple[float, ...]]:
    """What a scene states along the filament."""
    initial, filament = described.scene.initial, described.scene.filament
    return {
        "initial_mean": initial_strain(described.scene),
        "initial_bending": initial.C,
        "thickness": filament.profile,
        "natural": described.natural,
    }


def source_text(described: Description, name: str, command: str) -> str:
    """The C file: the model, then its description and the functions of the header."""
    given, model = described.parameters, described.model
    if unknown := set(model.places) - _PLACES:
        raise PrintingError(
            f"the generated code asks sites for {sorted(unknown)}, which softcat_places.c does not know"
        )
    texts = "char *const"
    arrays = {
        "parameters": (texts, [quoted(one.name) for one in given]),
        "units": (texts, [quoted(one.unit) for one in given]),
        "ranges": ("softcat_range", [_RANGES[one.bound] for one in given]),
        "values": ("double", [number(one.value) for one in given]),
        "slots": (texts, [quoted(slot.name) for slot in model.slots]),
        "places": ("softcat_place", [f"SOFTCAT_PLACE_{constant(place)}" for place in model.places]),
        "on_cells": ("int", [str(int(one)) for one in described.on_cells]),
        "mean": ("double", [number(one) for one, _ in described.profiles]),
        "bending": ("double", [number(one) for _, one in described.profiles]),
        "absolutes": ("double", [number(one) for one in described.steps.absolutes]),
        "nodes": ("double", [number(float(one)) for one in described.graph.grid.nodes]),
        **{key: ("double", list(map(number, values))) for key, values in _lists(described).items() if values},
    }
    if model.fibres:
        arrays["section_points"] = "double", [number(one) for one in model.points]
    return rendered(
        "filament.c.jinja",
        heading=heading(described, command),
        name=name,
        prefix=prefix_of(name),
        structure=symbol_of(name, "structure"),
        # Its head includes what the model needs; the header of this file brings more.
        model=model.text_to_take_away.replace("softcat_filament_model", symbol_of(name, "model")),
        arrays=[c_array(kind, f"described_{key}", values) for key, (kind, values) in arrays.items()],
        fields=_fields(described, name),
    )


def _fields(described: Description, name: str) -> dict[str, str]:
    """Of the structure."""
    scene, model, recorded = described.scene, described.model, described.structure.recorded
    supports = recorded.body.supports
    parameters = [one.name for one in described.parameters]
    slots = [slot.name for slot in model.slots]

    def place(names: list[str], name: str) -> str:
        return str(names.index(name) if name in names else -1)

    fields = {
        "model": f"&{symbol_of(name, 'model')}",
        "title": quoted(described.title),
        "parameter_names": "described_parameters",
        "parameter_units": "described_units",
        "parameter_ranges": "described_ranges",
        "parameter_values": "described_values",
        "slot_names": "described_slots",
        "on_cells": "described_on_cells",
        "mean": "described_mean",
        "bending": "described_bending",
        "first": f"SOFTCAT_{recorded.grid.first.kind.upper()}",
        "last": f"SOFTCAT_{recorded.grid.last.kind.upper()}",
        "least_cells": str(MIN_CELLS),
        "area_power": str(recorded.formulation.area_power),
        "profiled": str(int(recorded.body.profile.nodes is not None)),
        "places": "described_places",
        **{slot: place(slots, slot) for slot in ("x", "y", "z", "psi")},
        "q": place(slots, TURN[0]),
        **{one: place(parameters, one) for one in _KNOWN},
        "motion": place(parameters, "motion_0_time"),
        "motion_rows": str(supports.rows),
        "motion_width": str(4 if supports.sideways else 3),
        "turn": place(parameters, "turn_0_time"),
        "turn_rows": str(supports.turns),
        "stretch": number(force_free_stretch(scene)),
        "aspect": place(parameters, "aspect"),
        "width": number(scene.filament.width / scene.filament.thickness),
        "section": f"SOFTCAT_{described.section}",
        "fibres": str(described.fibres),
        "points": str(model.fibres),
        "nodes": "described_nodes",
        "plain_slots": str(model.plain_slots),
        "plain_entries": str(model.plain_entries),
        "plain_scratch": str(model.template.scratch[0]),
    }
    for key, values in _lists(described).items():
        if values:
            rows = len(values) // (4 if key == "natural" else 1)
            fields |= {key: f"described_{key}", f"{key}_count": str(rows)}
    fields |= {"section_points": "described_section_points"} if model.fibres else {}
    steps = described.steps
    fields |= {"grading": number(described.grading), "relative": number(steps.relative)}
    fields |= {"absolute": number(steps.absolute), "absolutes": "described_absolutes"}
    fields |= {"largest_step": number(steps.largest_step), "method": str(steps.method)}
    middle = towards_middle(scene, described.effects)
    fields |= {"towards_middle": str(int(middle)), "duration": number(scene.run.duration)}
    return fields | {"cells": str(described.cells), "frames": str(scene.run.frames)}


def header_text(described: Description, name: str, command: str) -> str:
    """The C header."""
    big, scene, slots = prefix_of(name).upper(), described.scene, described.model.slots
    words = [f"[{one.unit}] {one.value:.6g}{f': {one.meaning}' if one.meaning else ''}" for one in described.parameters]
    parameters, unknowns = [constant(one.name) for one in described.parameters], [constant(slot.name) for slot in slots]
    kinds = [
        f"{'cell' if on_cells else 'node'}, {'differential' if slot.differential else 'algebraic'}"
        for slot, on_cells in zip(slots, described.on_cells, strict=True)
    ]
    return rendered(
        "filament.h.jinja",
        heading=heading(described, command),
        guard=f"SOFTCAT_{constant(name)}_H",
        big=big,
        prefix=prefix_of(name),
        structure=symbol_of(name, "structure"),
        half=described.structure.recorded.grid.is_half,
        min_cells=MIN_CELLS,
        axes=3 if "z" in [slot.name for slot in slots] else 2,
        parameters=list(zip(parameters, words, strict=True)),
        parameter_width=max(map(len, parameters)) + len(f"{big}_P_") + 1,
        slots=list(zip(unknowns, kinds, strict=True)),
        slot_width=max(map(len, unknowns)) + len(f"{big}_SLOT_") + 1,
        scene={
            "CELLS": described.cells,
            "FIBRES": described.fibres,
            "GRADING": number(described.grading),
            "RELATIVE": number(described.steps.relative),
            "ABSOLUTE": number(described.steps.absolute),
            "DURATION": number(scene.run.duration),
            "FRAMES": scene.run.frames,
        },
    )
