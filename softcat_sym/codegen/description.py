"""What a compiled filament must be told beside its physics: names, units, what holds its ends, how a scene runs it."""

from __future__ import annotations

from dataclasses import dataclass

from softcat_sym.codegen.c_source import CSource
from softcat_sym.codegen.model_text import Model
from softcat_sym.codegen.structure import Structure
from softcat_sym.effects import Effects
from softcat_sym.graph import Graph
from softcat_sym.graph.grading import choose_grading, towards_middle
from softcat_sym.graph.parameters import CATALOGUE, parameter_values
from softcat_sym.scene import Scene
from softcat_sym.scene.units import si_unit

LEAST_CELLS = 4
"""Per half span: with fewer, the two ends see each other."""

_UNITS = {
    "span": "m",
    "drop": "m",
    "left_angle": "rad",
    "right_angle": "rad",
    "point_mass_per_area": "kg/m^2",
    "time_scale": "s",
    "second_modulus": "Pa",
    "index": "1",
}
_ENDINGS = {"_time": "s", "_dx": "m", "_dy": "m", "_youngs_modulus": "Pa", "_viscosity": "Pa*s"}

_MEANINGS = {
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
    "surface_tension": "of the filament's surface",
    "span": "horizontal distance between the supports",
    "drop": "of the right support below the left one",
    "left_angle": "of the clamp, counterclockwise",
    "right_angle": "of the clamp, counterclockwise",
    "point_mass_per_area": "mass at midspan over the undeformed section",
    "time_scale": "unit of time in which the computation works; 0: sqrt(rest_length / gravity)",
}


@dataclass(frozen=True, slots=True)
class Given:
    """A parameter of a filament.

    Attributes
    ----------
    name, unit, meaning : str
        SI.
    bound : str
        ``any``, ``not-negative``, ``positive`` or ``poisson``.
    value : float
        That of the scene.
    """

    name: str
    unit: str
    meaning: str
    bound: str
    value: float


@dataclass(frozen=True)
class Description:
    """A scene's filament as C sees it.

    Attributes
    ----------
    scene : Scene
        What was asked.
    effects : Effects
        The physics in force.
    structure : Structure
        What its text depends on.
    model : Model
        Its physics as C text.
    parameters : tuple of Given
        In the order of the model.
    on_cells : tuple of bool
        Whether each slot belongs to the cell of its site.
    profiles : tuple of (float, float)
        What each slot is of a plastic strain that is linear through the thickness.
    cells : int
        Per half span.
    grading, relative, absolute : float
        Ratio of the longest cell to the shortest, and tolerances.
    towards_middle : bool
        Whether cells are short at midspan, too.
    """

    scene: Scene
    effects: Effects
    structure: Structure
    model: Model
    parameters: tuple[Given, ...]
    on_cells: tuple[bool, ...]
    profiles: tuple[tuple[float, float], ...]
    cells: int
    grading: float
    relative: float
    absolute: float
    towards_middle: bool

    @property
    def title(self) -> str:
        """Of the scene."""
        return self.scene.title or "a filament"

    @property
    def digest(self) -> str:
        """Of the text of the physics: two filaments share a structure if theirs are the same."""
        return CSource({"model.c": self.model.text}).digest

    @property
    def least_cells(self) -> int:
        """Per half span."""
        return LEAST_CELLS


def describe(
    scene: Scene, effects: Effects, graph: Graph, structure: Structure, model: Model, tolerances: tuple[float, float]
) -> Description:
    """Gather what is known of a scene's filament.

    Parameters
    ----------
    scene, effects
        What is asked, and the physics in force.
    graph, structure, model
        What it became.
    tolerances : (float, float)
        Relative and absolute.
    """
    values = parameter_values(scene)
    units = {name: _unit(scene, name, model.parameters) for name in model.parameters}
    given = tuple(
        Given(name, units[name], _meaning(name, units[name]), _bound(scene, name), float(values[name]))
        for name in model.parameters
    )
    cells = graph.grid.cells if graph.grid.is_half else graph.grid.cells // 2
    names = [slot.name for slot in model.slots]
    grading = scene.numerics.grading or choose_grading(scene, cells, effects)
    return Description(
        scene=scene,
        effects=effects,
        structure=structure,
        model=model,
        parameters=given,
        on_cells=tuple(_is_on_cells(graph, name) for name in names),
        profiles=tuple(graph.profiles.get(name, (0.0, 0.0)) for name in names),
        cells=cells,
        grading=float(grading),
        relative=float(tolerances[0]),
        absolute=float(tolerances[1]),
        towards_middle=towards_middle(scene, effects),
    )


def _is_on_cells(graph: Graph, kind: str) -> bool:
    """Whether the unknowns of a kind stand in the middle of cells."""
    for kinds, places, where in (
        (graph.x_kinds, graph.x_places, graph.x_where),
        (graph.z_kinds, graph.z_places, graph.z_where),
    ):
        if kind in kinds:
            first = kinds.index(kind)
            return bool(where[first] != graph.grid.nodes[places[first]])
    return False


def _unit(scene: Scene, name: str, names: tuple[str, ...]) -> str:
    if name == "viscosity" and "index" in names:
        return "Pa*s^n"
    known = {one.name: one.unit for one in CATALOGUE} | _UNITS
    if name in known:
        return known[name]
    for own in scene.material.parameters:
        if own.name == name:
            return str(si_unit(own.dimension)).replace(" ", "") or "1"
    return next((unit for ending, unit in _ENDINGS.items() if name.endswith(ending)), "1")


def _meaning(name: str, unit: str) -> str:
    return "consistency K of the flow" if unit == "Pa*s^n" else _MEANINGS.get(name, "")


def _bound(scene: Scene, name: str) -> str:
    if name == "poisson":
        return "poisson"
    own = {parameter.name for parameter in scene.material.parameters}
    free = ("curvature", "drop", "left_angle", "right_angle")
    if name in own or name in free or (name.startswith("motion_") and not name.endswith("_time")):
        return "any"
    zero = ("gravity", "ramp", "shake", "shake_frequency", "point_mass_per_area", "time_scale", "surface_tension")
    return "not-negative" if name in zero or name.startswith("motion_") else "positive"
