"""The compiled solver of a scene as files: Scene -> Effects -> Equations -> Graph -> C."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from softcat_sym.codegen.description import Description
    from softcat_sym.graph import Graph
    from softcat_sym.graph.grid import Floats
    from softcat_sym.scene import Scene, SceneLike
    from softcat_sym.solve.assembled import Assembled

COMMAND = "softcat generate scene.toml -o ."


def generate(scene: SceneLike, directory: str | Path, rhs: bool = False, name: str = "filament") -> list[Path]:
    """Write the solver of a scene as C99 that needs no Python: to build, to call, or to run with other parameters.

    Parameters
    ----------
    scene : Scene, str, path or dict
        What is asked. Its law, section, kinds of ends and effects become C text; its numbers are what the program
        starts from, and can be changed without writing it again.
    directory : str or pathlib.Path
        Where the files go; made if missing. Files of the same name are replaced.
    rhs : bool
        Whether to add the right-hand side with its sparse Jacobian as plain CasADi functions, for an integrator of
        your own.
    name : str
        Of the C file, and part of all that it exports: two filaments in one program want two names.

    Returns
    -------
    list of pathlib.Path
        What was written.

    Raises
    ------
    SceneError
        If the scene has no compiled form.
    SoftcatError
        If it has no shape to begin from, or the name is no name.
    OSError
        If the directory cannot be written. Nothing is written of a scene that is refused.
    """
    from softcat_sym.codegen.export import check_name
    from softcat_sym.files import write_all
    from softcat_sym.scene import as_scene

    contents = contents_of(as_scene(scene), check_name(name), rhs=rhs)
    return write_all(directory, {file: text.encode() for file, text in contents.items()})


@dataclass(frozen=True)
class Exported:
    """A described filament with its graph.

    Attributes
    ----------
    description : Description
        What C is told.
    filament : Assembled
        The same as CasADi has it.
    """

    description: Description
    filament: Assembled

    @property
    def graph(self) -> Graph:
        """The graph of the filament."""
        return self.filament.graph


def contents_of(scene: Scene, name: str, *, rhs: bool) -> dict[str, str]:
    """All files of a scene's solver, by name."""
    from softcat_sym.codegen.export import model_files, program_files, runtime_files
    from softcat_sym.codegen.general import rhs_source
    from softcat_sym.codegen.parameter_file import START, parameter_text, start_text
    from softcat_sym.solve.starting import is_straight

    exported = export(scene)
    described, command = exported.description, COMMAND if name == "filament" else f"{COMMAND} --name {name}"
    straight = is_straight(scene)
    files = {
        **model_files(described, name, command),
        **runtime_files(),
        **program_files(described, name, command, rhs=rhs),
        "parameters.txt": parameter_text(described, command, has_start=not straight),
        "scene.toml": scene.to_toml(),
    }
    if not straight:
        files[START] = start_text(described, exported.graph.grid.nodes, _start(scene, exported))
    if rhs:
        files |= rhs_source(exported.graph).files
    return files


def export(scene: Scene) -> Exported:
    """A scene's filament, described for C.

    Raises
    ------
    SceneError
        If it has no compiled form, or names effects that it cannot have.
    """
    from softcat_sym.codegen.description import describe
    from softcat_sym.codegen.structure import model_for
    from softcat_sym.effects import choose_effects
    from softcat_sym.solve import compiled_settings
    from softcat_sym.solve.assembled import assembled

    effects = choose_effects(scene)
    _refuse(scene, effects.names)
    filament, settings = assembled(scene, effects), compiled_settings(scene, effects)
    structure, tolerances = filament.structure(), (settings.rtol, settings.atol)
    return Exported(describe(scene, effects, filament.graph, structure, model_for(structure), tolerances), filament)


def _refuse(scene: Scene, effects: tuple[str, ...]) -> None:
    """Refuse what has no compiled form.

    Raises
    ------
    SceneError
        With the reason.
    """
    from softcat_sym.errors import Fault, SceneError
    from softcat_sym.scene.consistency import refuse_settled
    from softcat_sym.solve.backend import NOTHING_TO_INTEGRATE, ONE_TENSION, integrates

    refuse_settled(scene, "a generated program runs to the end of its duration")
    if scene.model == "small-deflection":
        raise SceneError([Fault("model", f"'small-deflection', but {ONE_TENSION}", "filament")])
    if not integrates(effects):
        raise SceneError([Fault("run.effects", NOTHING_TO_INTEGRATE, "auto, or the effect inertia")])


def _start(scene: Scene, exported: Exported) -> Floats:
    """Unknowns at t = 0 in rows of sites, what the ends hold filled in.

    Raises
    ------
    SoftcatError
        If no equilibrium was found.
    """
    from softcat_sym.codegen.sites import sites_of
    from softcat_sym.errors import SoftcatError
    from softcat_sym.graph.parameters import parameter_values
    from softcat_sym.scene import rest_length
    from softcat_sym.solve.starting import starting_state

    graph, described = exported.graph, exported.description
    p = graph.vector(parameter_values(scene))
    start = starting_state(scene, graph, p, exported.filament.at_rest)
    if start is None:
        raise SoftcatError("at t = 0 s: no shape in balance was found to begin from")
    state = sites_of(graph, described.model.slots).state(start.x, start.z)
    seen = graph.observables(time=0.0, state=start.x, algebraic=start.z, parameters=p)
    names, ends, length = [slot.name for slot in described.model.slots], scene.ends, rest_length(scene)
    for kind in ("x", "y"):
        if kind in names:
            slot, places = names.index(kind), seen[kind]
            state[0, slot], state[-1, slot] = float(places[0]) / length, float(places[-1]) / length
    if "psi" in names:
        slot, (first, last) = names.index("psi"), described.structure.ends
        if first.holds_angle:
            state[0, slot] = 0.0 if graph.grid.is_half else ends.left_angle
        if last.holds_angle:
            state[-1, slot] = ends.right_angle
    return state
