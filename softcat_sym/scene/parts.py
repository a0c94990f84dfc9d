"""The parts of a scene beside its material: frozen models without unknown keys, in plain SI values."""

from __future__ import annotations

import ast
import inspect
import math
from collections.abc import Iterator, Mapping
from functools import cache
from itertools import pairwise
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationInfo, field_validator, model_validator

from softcat_sym.scene.shapes import SHAPE
from softcat_sym.scene.units import (
    FLAG,
    NUMBERS,
    POINTS,
    UNIT_VECTOR,
    Choice,
    Kind,
    Names,
    Number,
    Quantity,
    Values,
    Whole,
    length_text,
    refusal,
    shown,
)


class Part(BaseModel):
    """One table of the scene file, every value plain SI.

    Two parts are equal when their physics is: how a value was given (in shear or in tension) does not count.
    """

    # Built when first used: parts are read as fields of a scene, whose build has them all.
    model_config = ConfigDict(frozen=True, extra="forbid", defer_build=True)
    table_name: ClassVar[str]

    def __init_subclass__(cls, table: str = "", **settings: Any) -> None:
        cls.table_name = table
        super().__init_subclass__(**settings)

    def kinds(self) -> Mapping[str, Kind]:
        """Return how each value is written, by field name."""
        return kinds_of(type(self))

    def physics(self) -> dict[str, Any]:
        """Values that make a difference to the answer, by field name; SI."""
        return {name: getattr(self, name) for name in _physical(type(self))}

    @property
    def notes(self) -> tuple[str, ...]:
        """What was converted from other names or data, in words and numbers."""
        return ()

    def given(self) -> dict[str, object]:
        """Return the raw table as it was asked for: only what was set, so that what follows from it still follows."""
        return {
            name: kind.write(getattr(self, name))
            for name, kind in self.kinds().items()
            if name in self.model_fields_set and getattr(self, name) is not None
        }

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and isinstance(other, Part) and self.physics() == other.physics()

    def __hash__(self) -> int:
        return hash((type(self), *(getattr(self, name) for name in _physical(type(self)))))


@cache
def _physical(part: type[BaseModel]) -> tuple[str, ...]:
    """Names of the fields that make a difference to the answer."""
    return tuple(name for name, info in part.model_fields.items() if not info.exclude)


def dotted(*names: str) -> str:
    """Join the names that are not empty by dots."""
    return ".".join(name for name in names if name)


@cache
def kinds_of(part: type[BaseModel]) -> Mapping[str, Kind]:
    """Return the kind of each field that holds a value (not a part)."""
    found = ((name, kind) for name, info in part.model_fields.items() for kind in info.metadata)
    return MappingProxyType({name: kind for name, kind in found if isinstance(kind, Kind)})


@cache
def meanings_of(part: type[BaseModel]) -> dict[str, str]:
    """Return the sentence below each field of a part's source, which pydantic would parse at every start."""
    sources = [inspect.getsource(one) for one in part.__mro__ if issubclass(one, Part)]
    body = [line for text in sources for whole in ast.parse(text).body for line in getattr(whole, "body", ())]
    return {
        field.target.id: inspect.cleandoc(str(below.value.value))
        for field, below in pairwise(body)
        if isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name)
        if isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant)
    }


Point = tuple[float, ...]
Section = Literal["rectangle", "circle", "sheet"]
_THICKNESS = Quantity("length", "6 mm")
Length = Annotated[float, _THICKNESS]
LineShape = Literal["rectangle", "rounded"]
_LAYER = Quantity("length", "0.2 mm")
LINE = ("line_width", "layer_height", "flow_ratio", "line_shape")
"""Keys of a slicer's line, which say together how thick a round strand is."""


def line_area(width: float, height: float, flow_ratio: float | None, shape: LineShape | None) -> float:
    """Area of the strand that a slicer extrudes for a line [m^2].

    A rectangle is w h, as in Cura; a rounded one, h (w - (1 - pi/4) h), has half circles as its sides, as PrusaSlicer
    and OrcaSlicer have it (libslic3r, ``Flow::mm3_per_mm``). Without a flow ratio it is 1, without a shape a rectangle.
    """
    corners = (1 - math.pi / 4) * height if shape == "rounded" else 0.0
    return (1.0 if flow_ratio is None else flow_ratio) * height * (width - corners)


_PROFILE = Values(Number(above=0), "a list of positive numbers without units, at least 2", 2, optional=True)


def _of_a_line(default: Any, **settings: Any) -> Any:
    """A field that only says how thick the filament is."""
    return Field(default=default, exclude=True, repr=False, **settings)


class Filament(Part, table="filament"):
    """Geometry and density; lengths in m, density in kg/m^3."""

    span: Annotated[float, Quantity("length", "0.2 m")]
    """Horizontal distance between the supports, L."""
    rest_length: Annotated[float | None, Quantity("length", "0.21 m")] = None
    """Length of the reference configuration; the distance between the supports over initial.stretch unless given."""
    diameter: Annotated[float | None, Quantity("length", "6 mm")] = _of_a_line(None)
    """Diameter of a circle, which the section then is; instead of thickness."""
    line_width: Annotated[float | None, Quantity("length", "0.42 mm")] = _of_a_line(None)
    """Width of a slicer's line: with layer_height the section is a circle of the same area; instead of thickness."""
    layer_height: Annotated[float | None, _LAYER] = _of_a_line(None, validate_default=True)
    """Height of that line."""
    flow_ratio: Annotated[float | None, Number(above=0)] = _of_a_line(None)
    """Material extruded for that line over what fills its shape; 1 unless given."""
    line_shape: Annotated[LineShape | None, Choice(LineShape)] = _of_a_line(None)
    """Shape of that line: rectangle as in Cura, which it is unless given, rounded as in PrusaSlicer and OrcaSlicer."""
    thickness: Length = Field(default=None, validate_default=True)
    """Thickness h0 in the plane of bending; the diameter of a circle."""
    section: Annotated[Section, Choice(Section)] = "rectangle"
    """Shape of the cross-section."""
    width: Length = Field(default=None, validate_default=True)
    """Width D0 across the plane of bending; the thickness unless given."""
    nozzle: Annotated[float | None, Quantity("length", "0.4 mm")] = _of_a_line(None)
    """Inner diameter of the nozzle: its area over that of a round strand is the draw ratio, which the notes tell."""
    density: Annotated[float, Quantity("density", "1900 kg/m^3")]
    """Mass per volume, rho."""
    profile: Annotated[tuple[float, ...], _PROFILE] = ()
    """Relative thickness at equally spaced points from left to right, linear between them; empty: 1."""
    shape: Annotated[str | tuple[Point, ...], SHAPE] = "straight"
    """Natural curve between the supports: straight, arc, helix, or through points of a CSV file; in space."""
    curvature: Annotated[float, Quantity("curvature", "0 1/m", "any")] = 0.0
    """Natural curvature, in the plane."""
    twist: Annotated[float, Quantity("curvature", "0 1/m", "any")] = 0.0
    """Natural twist, turn of the section about the centreline over length; relaxed with a curvature it is a helix."""

    @model_validator(mode="before")
    @classmethod
    def _round_if_it_has_a_diameter(cls, data: Any) -> Any:
        is_round = isinstance(data, dict) and any(data.get(key) is not None for key in ("diameter", "line_width"))
        return {"section": "circle", **data} if is_round else data

    @field_validator("layer_height", mode="plain")
    @classmethod
    def _with_a_line_width(cls, value: Any, info: ValidationInfo) -> float | None:
        if value is None and info.data.get("line_width") is not None:
            raise refusal("missing, but filament.line_width is given", _LAYER.accepted)
        if value is not None and info.data.get("line_width", math.nan) is None:
            raise refusal("given without filament.line_width", "both, or neither")
        return None if value is None else float(_LAYER.read(value))

    @field_validator("flow_ratio", "line_shape")
    @classmethod
    def _of_a_whole_line(cls, value: Any, info: ValidationInfo) -> Any:
        width, height = (info.data.get(key, math.nan) for key in ("line_width", "layer_height"))
        if width is None:
            raise refusal("given without filament.line_width", "filament.line_width and filament.layer_height, or none")
        if value == "rounded" and height is not None and width < height:
            found = f"'rounded', but the line is {length_text(width)} wide and {length_text(height)} high"
            raise refusal(found, "a line_width not below the layer_height, or rectangle")
        return value

    @field_validator("thickness", mode="plain")
    @classmethod
    def _thinner_than_long(cls, value: Any, info: ValidationInfo) -> float:
        others = [key for key in ("diameter", "line_width") if info.data.get(key, math.nan) is not None]
        span = info.data.get("span", math.inf)
        if value is None and not others and "layer_height" in info.data:
            raise refusal("missing", f"{_THICKNESS.accepted}, filament.diameter, or filament.line_width")
        if len(others) + (value is not None) > 1:
            where = " and ".join(f"filament.{key}" for key in others)
            twice = f"given twice, here and as {where}" if value is not None else f"given twice, as {where}"
            raise refusal(twice, "one of the two")
        thickness = _THICKNESS.read(value) if value is not None else info.data.get("diameter") or math.nan
        if others == ["line_width"]:
            # NaN never escapes: a part of the line that is missing here is faulty itself.
            line = [info.data.get(key, math.nan) for key in LINE]
            thickness = math.sqrt(4 / math.pi * line_area(*line))
        if thickness >= span:
            found = f"{shown(value) if not others else f'the diameter, {thickness:g} m,'} is not less than the span"
            raise refusal(found, f"a thickness below the span, {span:g} m")
        return float(thickness)

    @field_validator("section", "nozzle")
    @classmethod
    def _round_where_it_has_a_diameter(cls, value: Any, info: ValidationInfo) -> Any:
        if info.field_name == "nozzle":
            if value is not None and info.data.get("section", "circle") != "circle":
                raise refusal(f"given, but the section is a {info.data['section']}", "leaving it out, or a circle")
            return value
        other = next((key for key in ("diameter", "line_width") if info.data.get(key) is not None), None)
        if value != "circle" and other is not None:
            accepted = f"circle, or filament.thickness instead of filament.{other}"
            raise refusal(f"{value!r}, but filament.{other} is given", accepted)
        return value

    @field_validator("width", mode="plain")
    @classmethod
    def _follow_thickness(cls, value: Any, info: ValidationInfo) -> float:
        # NaN never escapes: without a thickness there is a fault, and with a fault there is no filament.
        thickness = info.data.get("thickness", math.nan)
        width = thickness if value is None else _THICKNESS.read(value)
        if info.data.get("section") == "circle" and math.isfinite(thickness) and width != thickness:
            raise refusal("a circle has no width of its own", "leaving it out; the diameter is filament.thickness")
        return float(width)

    @property
    def area(self) -> float:
        """A0 [m^2] where the relative thickness is 1."""
        return math.pi * self.thickness**2 / 4 if self.section == "circle" else self.thickness * self.width

    @property
    def notes(self) -> tuple[str, ...]:
        """What was given under another name, in words and numbers."""
        notes = [] if self.diameter is None else [f"thickness = diameter of a circle: {self.thickness:.6g} m"]
        area = math.pi / 4 * self.thickness**2
        if self.line_width is not None and self.layer_height is not None:
            size = f"{1e3 * self.line_width:g} mm x {1e3 * self.layer_height:g} mm"
            line = f"{self.line_shape or 'rectangle'} line of {size}"
            now = f"round strand of the same area, {1e6 * area:.4g} mm^2: diameter {1e3 * self.thickness:.4g} mm"
            notes.append(f"{line}, flow ratio {self.flow_ratio or 1:g} = {now}")
        if self.nozzle is not None:
            ratio = (self.nozzle / self.thickness) ** 2
            notes.append(f"draw ratio {ratio:.4g} = area of the nozzle over that of the strand; it changes no answer")
        return tuple(notes)

    def follows(self) -> dict[str, str]:
        """Name the values that only repeat another, and need not be written: ``{field: the other}``."""
        return {"width": "thickness"} if self.width == self.thickness else {}


Rule = tuple[object, str, str, str]
"""Whether it is broken; by which key, what was found, and what is accepted."""


def if_given(scene: Any, found: str, accepted: str, *paths: str) -> Iterator[Rule]:
    """List the rules that keys by their dotted paths say nothing but their defaults."""
    for path in paths:
        table, _, key = path.partition(".")
        part = getattr(scene, table)
        yield getattr(part, key) != type(part).model_fields[key].default, path, found, accepted


_FORCES = 'three forces with their units, right, up and towards the viewer, such as ["0 N", "1 N", "0 N"]'
_TIP_FORCE = Values(Quantity("force", "1 N", "any"), _FORCES, 3, 3)
_TORQUES = _FORCES.replace("forces", "torques").replace(" N", " N*m")
_TIP_TORQUE = Values(Quantity("torque", "1 N*m", "any"), _TORQUES, 3, 3)


DOWN = (0.0, -1.0, 0.0)
"""Direction of gravity unless a scene states another."""


class Load(Part, table="load"):
    """Gravity, its ramp and its shaking, and what hangs or pulls at a right end that is free or slides; SI."""

    gravity: Annotated[float, Quantity("acceleration", "9.81 m/s^2", "non-negative")] = 9.81
    """Acceleration g, downwards unless load.direction says otherwise."""
    direction: Annotated[tuple[float, ...], UNIT_VECTOR] = DOWN
    """Where gravity points: right, up and towards the viewer; of any length."""
    ramp: Annotated[float, Quantity("time", "0.1 s", "non-negative")] = 0.0
    """Time in which gravity grows from nothing, by a quintic smooth step; 0: at once."""
    point_mass: Annotated[float, Quantity("mass", "0 kg", "non-negative")] = 0.0
    """Mass at midspan."""
    tip_mass: Annotated[float, Quantity("mass", "0 kg", "non-negative")] = 0.0
    """Mass at a free right end; in three dimensions."""
    tip_force: Annotated[tuple[float, ...], _TIP_FORCE] = (0.0, 0.0, 0.0)
    """Dead force on a right end that is free, or slides: right, up, towards the viewer; in three dimensions."""
    tip_torque: Annotated[tuple[float, ...], _TIP_TORQUE] = (0.0, 0.0, 0.0)
    """Dead torque on a free right end, about axes that point right, up and towards the viewer; in three dimensions."""
    shake: Annotated[float, Number(above=0, closed=True)] = 0.0
    """Amplitude a of oscillating gravity over g, after the ramp: g (1 + a sin(2 pi f t)); 0: steady."""
    shake_frequency: Annotated[float, Quantity("frequency", "5 Hz", "non-negative")] = 0.0
    """Frequency f of oscillating gravity, in cycles a second; given together with load.shake."""


SurfaceAge = Literal["fresh", "relaxed"]


class Initial(Part, table="initial"):
    """State at the first instant; dimensionless."""

    stretch: Annotated[float, Number(above=0)] = 1.0
    """Stretch before the load acts, s0."""
    relaxed: Annotated[bool, FLAG] = True
    """Whether that stretch is free of stress, a plastic strain log(s0) everywhere, or elastic."""
    P: Annotated[tuple[float, ...], NUMBERS] = ()
    """Mean plastic strain P/A0 at equally spaced material points from left to right; one value: everywhere."""
    C: Annotated[tuple[float, ...], NUMBERS] = ()
    """Bending plastic strain at the surface, C/(A0 (h0/2) <zeta^2>), at equally spaced points, too."""
    centreline: Annotated[tuple[Point, ...], POINTS] = ()
    """Places of equally spaced material points, from the left support: begins there, strained; in three dimensions."""
    surface: Annotated[SurfaceAge, Choice(SurfaceAge)] = "fresh"
    """Whether surface tension acts at once on a filament without stress, or has shortened it before it was held."""


class Surroundings(Part, table="surroundings"):
    """The medium around the filament; SI."""

    surface_tension: Annotated[float, Quantity("surface tension", "21 mN/m", "non-negative")] = 0.0
    """Surface tension Gamma between the filament and what surrounds it."""
    density: Annotated[float, Quantity("density", "1.2 kg/m^3", "non-negative")] = 0.0
    """Mass per volume of the surroundings, which buoy the filament."""
    viscosity: Annotated[float, Quantity("viscosity", "18 uPa*s", "non-negative")] = 0.0
    """Shear viscosity of the surroundings, which drag at the filament."""


Until = Literal["duration", "settled"]
Closure = Literal["material", "printed"]
Dimensions = Literal["auto", 2, 3]


class RunSettings(Part, table="run"):
    """What is asked of the run; times in s."""

    duration: Annotated[float, Quantity("time", "2 s")]
    """Simulated time; the longest one where the run may settle before."""
    frames: Annotated[int, Whole(2, 1_000_000)] = 201
    """Number of evenly spaced output times, t = 0 included."""
    accuracy: Annotated[float, Number(above=0, below=1)] = 0.01
    """Largest error of midpoint or farthest-moving node over the largest displacement of any node."""
    until: Annotated[Until, Choice(Until)] = "duration"
    """Whether the run ends with its duration, or before when nothing moves any more by the accuracy asked."""
    effects: Annotated[str | tuple[str, ...], Names("auto", "paper")] = "auto"
    """Which physics is in force: auto chooses by estimates, paper is the published theory; or names of effects."""
    closure: Annotated[Closure, Choice(Closure)] = "material"
    """Plastic state, strain measure and axial force: that of the material, or as the paper prints it."""
    dimensions: Annotated[Dimensions, Choice(Dimensions)] = "auto"
    """Whether the filament stays in a plane, 2, or moves in space, 3; auto: in a plane if the scene has one."""


Solver = Literal["cvodes", "idas", "rosenbrock"]
Backend = Literal["auto", "interpreted", "compiled"]
Tail = Literal["auto", "integrate"]


class Numerics(Part, table="numerics"):
    """Overrules; None means that the program chooses."""

    cells: Annotated[int | None, Whole(4, 100_000)] = None
    """N, cells per half span; chosen by the program unless given."""
    grading: Annotated[float | None, Number(above=0, below=1000)] = None
    """Length of the cells at midspan over that at the clamps, 1: all equal; chosen by the program unless given."""
    order: Annotated[int | None, Whole(1, 20)] = None
    """k, order of the plastic strain through the thickness; chosen by the program unless given."""
    fibres: Annotated[int | None, Whole(2, 1000)] = None
    """Fibres through the thickness; chosen by the program unless given."""
    solver: Annotated[Solver | None, Choice(Solver)] = None
    """Integrator; chosen by the program unless given."""
    rtol: Annotated[float | None, Number(above=0, below=1)] = None
    """Relative tolerance of the integrator; chosen by the program unless given."""
    backend: Annotated[Backend, Choice(Backend)] = "auto"
    """Interpreted by CasADi, or compiled from generated C; auto: compiled where there is a C compiler."""
    tail: Annotated[Tail, Choice(Tail)] = "auto"
    """A long undamped ringing that no longer yields: by its modes of vibration where they serve, or step by step."""
    estimate: Annotated[bool, FLAG] = True
    """Whether the error is estimated on other grids, and the run refined until it is below run.accuracy."""
