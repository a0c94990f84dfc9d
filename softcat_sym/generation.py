"""The compiled solver of a scene as files, and the checked-in products made of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from softcat_sym.codegen.interface import Description
    from softcat_sym.discretization.graph import Graph
    from softcat_sym.discretization.grid import Floats
    from softcat_sym.scene.reading import SceneLike
    from softcat_sym.scene.scene import Scene
    from softcat_sym.solvers.run import Assembled

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
    from softcat_sym.scene.reading import as_scene

    contents = contents_of(as_scene(scene), check_name(name), rhs=rhs)
    return write_all(directory, {file: text.encode() for file, text in contents.items()})


@dataclass(frozen=True)
class Exported:
    """A described filament with its graph."""

    description: Description  # What C is told
    filament: Assembled  # The same as CasADi has it

    @property
    def graph(self) -> Graph:
        """The graph of the filament."""
        return self.filament.graph


def contents_of(scene: Scene, name: str, *, rhs: bool) -> dict[str, str]:
    """All files of a scene's solver, by name."""
    from softcat_sym.codegen.export import (
        START,
        model_files,
        parameter_text,
        program_files,
        runtime_files,
        start_text,
    )
    from softcat_sym.codegen.right_hand_side import rhs_source
    from softcat_sym.solvers.initial_state import is_straight

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
    """A scene's filament, described for C."""
    from softcat_sym.codegen.interface import describe
    from softcat_sym.codegen.model import model_for
    from softcat_sym.effects.choosing import choose_effects
    from softcat_sym.solvers.run import assembled
    from softcat_sym.solvers.settings import compiled_settings

    effects = choose_effects(scene)
    _refuse(scene, effects.names)
    filament, settings = assembled(scene, effects), compiled_settings(scene, effects)
    structure, tolerances = filament.structure(), (settings.rtol, settings.atol)
    return Exported(describe(scene, effects, filament.graph, structure, model_for(structure), tolerances), filament)


def _refuse(scene: Scene, effects: tuple[str, ...]) -> None:
    """Refuse what has no compiled form."""
    from softcat_sym.errors import Fault, SceneError
    from softcat_sym.scene.scene import refuse_settled
    from softcat_sym.solvers.settings import NOTHING_TO_INTEGRATE, ONE_TENSION, integrates

    refuse_settled(scene, "a generated program runs to the end of its duration")
    if scene.model == "small-deflection":
        raise SceneError([Fault("model", f"'small-deflection', but {ONE_TENSION}", "filament")])
    if not integrates(effects):
        raise SceneError([Fault("run.effects", NOTHING_TO_INTEGRATE, "auto, or the effect inertia")])


def _start(scene: Scene, exported: Exported) -> Floats:
    """Unknowns at t = 0 in rows of sites, what the ends hold filled in."""
    from softcat_sym.codegen.loops import sites_of
    from softcat_sym.discretization.graph import parameter_values
    from softcat_sym.errors import SoftcatError
    from softcat_sym.scene.scene import rest_length
    from softcat_sym.solvers.initial_state import starting_state

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


PRODUCTS_COMMAND = "softcat generate --bundled -o generated"
NAME = "filament"


def bundled(told: Callable[[str], None] = lambda _: None) -> dict[str, Description]:
    """Each bundled scene, described for C."""
    from softcat_sym.scene.bundled import bundled_names
    from softcat_sym.scene.reading import load_scene

    described = {}
    for name in bundled_names():
        told(name)
        described[name] = export(load_scene(name)).description
    return described


def contents(described: dict[str, Description]) -> dict[str, str]:
    """The runtime, and each structure in a folder named after the first scene that has it, by path."""
    from softcat_sym.codegen.export import model_files, runtime_files
    from softcat_sym.codegen.interface import rendered

    templates = resources.files("softcat_sym.codegen") / "templates"
    files = {f"runtime/{file}": text for file, text in runtime_files().items()}
    files["runtime/main.c"] = (templates / "main.c").read_text(encoding="utf-8")
    folders: dict[str, str] = {}
    rows = []
    for scene, one in described.items():
        if one.digest not in folders:
            folders[one.digest] = scene
            model = model_files(one, NAME, PRODUCTS_COMMAND)
            files |= {f"{scene}/{file}": text for file, text in model.items()}
        material, section = one.scene.material, one.scene.filament.section
        rows.append(f"| {scene} | {material.law} | {section} | {folders[one.digest]} |")
    counts = {"count": len(folders), "scenes": len(described), "table": "\n".join(rows)}
    files["README.md"] = rendered("products.md", command=PRODUCTS_COMMAND, **counts)
    return files


def write(directory: str | Path, told: Callable[[str], None] = lambda _: None) -> list[Path]:
    """Write the products, all or none; folders of structures that are no longer among them are left alone."""
    from softcat_sym.files import write_all, written_together

    root, files = Path(directory), contents(bundled(told))
    written: list[Path] = []
    with written_together():
        for folder in sorted({Path(path).parent for path in files}):
            inside = {Path(path).name: text.encode() for path, text in files.items() if Path(path).parent == folder}
            written += write_all(root / folder, inside)
    return written
