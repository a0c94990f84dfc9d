"""The compiled solver of a scene as files, and the checked-in products made of it."""

from __future__ import annotations

from collections.abc import Callable, Collection
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING

from softcat_sym.codegen.c_model import model_for
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.export import (
    START,
    check_name,
    model_files,
    parameter_text,
    program_files,
    runtime_files,
    start_text,
)
from softcat_sym.codegen.forms import Forms
from softcat_sym.codegen.interface import Description, StepSettings, rendered
from softcat_sym.codegen.right_hand_side import rhs_source
from softcat_sym.codegen.sites import sites_of
from softcat_sym.discretization.parameters import parameter_values
from softcat_sym.discretization.unknowns import PLACES, TURN, Floats
from softcat_sym.effects.selection import Effects, choose_effects
from softcat_sym.error_control.estimate import Resolution, resolution_of
from softcat_sym.errors import Fault, SceneError, SoftcatError
from softcat_sym.files import write_results
from softcat_sym.scene.bundled import bundled_names
from softcat_sym.scene.ends import SYMMETRY
from softcat_sym.scene.reading import as_scene, load_scene
from softcat_sym.scene.scene import Scene, refuse_settled, rest_length, why_interpreted
from softcat_sym.simulate import recalled
from softcat_sym.solvers.compiled import CompiledNewton, compile_filament
from softcat_sym.solvers.initial_state import is_straight, starting_state
from softcat_sym.solvers.settings import NOTHING_TO_INTEGRATE, compiled_settings
from softcat_sym.solvers.solution import Newton
from softcat_sym.solvers.solve import Assembled, assembled

if TYPE_CHECKING:
    from softcat_sym.results.run import Run
    from softcat_sym.scene.reading import Changes, SceneLike
    from softcat_sym.solvers.solution import Progress

COMMAND = "softcat generate scene.toml -o ."
FORMS = ("static", "fmu", "simulink")
"""What :func:`generate` adds on request."""


def generate(
    scene: SceneLike,
    directory: str | Path,
    rhs: bool = False,
    name: str = "filament",
    progress: Progress | None = None,
    *,
    changes: Changes = (),
    forms: Collection[str] = (),
    on_note: Callable[[str], object] = lambda _: None,
) -> list[Path]:
    """Write the solver of a scene as C99 that needs no Python: to build, to call, or to run with other parameters.

    Unless ``numerics.estimate = false``, the scene is run as :func:`softcat_sym.simulate` runs it, or such a run taken
    from the store: effects, cells, fibres and tolerances of the program are those that it ends with.

    Parameters
    ----------
    scene : Scene, str, path or dict
        The scene. Its law, section, kinds of ends and effects become C text; its numbers are what the program
        starts from, and can be changed without writing it again.
    directory : str or pathlib.Path
        Folder for the files, made if missing. Files of the same name are replaced.
    rhs : bool
        Whether to add the right-hand side with its sparse Jacobian as plain CasADi functions, for an integrator of
        your own.
    name : str
        Name of the C file, and part of every name that it exports: two filaments in one program need two names.
    progress : Progress, optional
        Told of the run, as by :func:`softcat_sym.simulate`.
    changes : mapping or sequence of str, optional
        Values that replace the scene's, as :func:`load_scene` takes them: ``{"filament.span": "6 mm"}``.
    forms : collection of str
        What to add: ``static`` (memory of fixed size for one grid), ``fmu`` (FMI 3.0, co-simulation), ``simulink``
        (a C MEX S-function).
    on_note : callable
        Called with sentences on the forms: what memory one takes, and for which platforms there is no binary.

    Returns
    -------
    list of pathlib.Path
        The files that were written.

    Raises
    ------
    SceneError
        If the scene has no compiled form.
    SoftcatError
        If it has no shape to begin from, or the name is no name.
    OSError
        If the directory cannot be written. Nothing is written of a scene that is refused.
    """
    if unknown := set(forms) - set(FORMS):
        raise SoftcatError(f"unknown form {min(unknown)!r}; accepted: {', '.join(FORMS)}")
    contents = contents_of(as_scene(scene, changes), check_name(name), forms, on_note, rhs=rhs, progress=progress)
    return write_results(directory, contents)


def contents_of(
    scene: Scene,
    name: str,
    forms: Collection[str] = (),
    on_note: Callable[[str], object] = lambda _: None,
    *,
    rhs: bool,
    progress: Progress | None = None,
) -> dict[str, str | bytes]:
    """All files of a scene's solver, by name."""
    ended, accuracy = _as_it_ends(scene, progress)
    described, filament = export(ended)
    graph = filament.graph
    command = COMMAND if name == "filament" else f"{COMMAND} --name {name}"
    start = start_of(described, filament)
    writer = Forms(described, name, command, None if start is None else graph.grid.nodes, start)
    files: dict[str, str | bytes] = {
        **model_files(described, name, command),
        **runtime_files(),
        **writer.instance(),
        **program_files(described, name, command, rhs=rhs, accuracy=accuracy),
        "parameters.txt": parameter_text(described, command, has_start=start is not None),
        "scene.toml": scene.to_toml(),
    }
    if start is not None:
        files[START] = start_text(described, graph.grid.nodes, start)
    if "static" in forms:
        texts, sizes = writer.static()
        files |= texts
        on_note(sizes)
    if "simulink" in forms:
        files |= writer.simulink()
    if "fmu" in forms:
        files[f"{name}.fmu"], missing = writer.fmu()
        for platform, why in missing.items():
            on_note(f"no binary for {platform}: {why}")
    return {**files, **(rhs_source(graph, described.model).files if rhs else {})}


def _as_it_ends(scene: Scene, progress: Progress | None) -> tuple[Scene, str]:
    """The scene as its run ends, and in words how accurate that is."""
    _compilable(scene)
    if not scene.numerics.estimate:
        return scene, "The error was not estimated: numerics.estimate is false."
    run = recalled(scene, progress)
    chosen = "Cells, fibres and tolerances are the program's first choice"
    if run.scene.run.dimensions != scene.run.dimensions:
        return scene, f"{chosen}: `softcat run` leaves the plane, being unstable sideways, and this does not."
    if not run.outcome.is_success:
        return scene, f"{chosen}: `softcat run` has no answer, {run.outcome.value}."
    ended, at = ended_at(scene, run)
    errors, numbers = run.summary["error_estimate"] or {}, [f"{at.cells} cells"]
    numbers += [f"{at.fibres} fibres"] if at.fibres else []
    error = "was not found" if errors.get("total") is None else f"is about {errors['total']:.2g} of the sag"
    how = f"are those with which `softcat run` of the scene ends ({', '.join(numbers)}, relative {at.rtol:.2g})"
    asked = f"{scene.run.accuracy:g} was asked"
    return ended, f"Effects, cells, fibres and tolerances {how}; there its estimated error {error}, {asked}."


def ended_at(scene: Scene, run: Run) -> tuple[Scene, Resolution]:
    """The scene with the effects and the resolution that its run ended with."""
    named, found = scene.replace({"run.effects": list(run.summary["effects"])}), run.summary["resolution"]
    at = Resolution(**found) if found else resolution_of(named, choose_effects(named), compiled=True)
    return at.of(named), at


def _compilable(scene: Scene) -> Effects:
    """Effects of a scene; one without compiled form is refused."""
    effects = choose_effects(scene)
    refuse_settled(scene, "a generated program runs to the end of its duration")
    if scene.extrusion.present:
        found = "given, but a generated program does not end its steps where the nozzle hands a node over"
        raise SceneError([Fault("extrusion", found, "leaving it out, or softcat run")])
    if (obstacle := why_interpreted(scene)) is not None:
        raise SceneError([Fault("model", f"{scene.model!r}, but {obstacle}", "filament")])
    if not effects.terms().integrates:
        raise SceneError([Fault("run.effects", NOTHING_TO_INTEGRATE, "auto, or the effect inertia")])
    return effects


def export(scene: Scene) -> tuple[Description, Assembled]:
    """A scene's filament, described for C and as CasADi has it; one without compiled form is refused."""
    effects = _compilable(scene)
    filament, settings = assembled(scene, effects), compiled_settings(scene, effects)
    model = model_for(filament.structure)
    absolutes = tuple(settings.absolute(slot.name for slot in model.slots).tolist())
    steps = StepSettings(
        float(settings.rtol), float(settings.atol), absolutes, settings.method, settings.max_step or 0.0
    )
    return Description(scene, effects, filament.graph, filament.structure, model, steps), filament


def _newton(filament: Assembled) -> Newton | None:
    """Newton's method in C for a start in three dimensions, where there is a compiler: it is ten times as fast."""
    if not filament.structure.recorded.theory.is_spatial or find_compiler() is None:
        return None
    code, settings = (
        compile_filament(filament.graph, filament.structure),
        compiled_settings(filament.scene, filament.effects),
    )
    return CompiledNewton(filament.graph, code, filament.code_at_rest, settings)


def start_of(described: Description, filament: Assembled) -> Floats | None:
    """Unknowns at t = 0 in rows of sites, what the ends hold filled in; None of a filament that begins straight."""
    graph, scene = filament.graph, filament.scene
    if is_straight(scene) and not (filament.structure.recorded.theory.is_spatial and graph.positions_are_algebraic):
        return None
    p = graph.vector(parameter_values(scene))
    start = starting_state(scene, graph, p, filament.at_rest, _newton(filament))
    if start is None:
        raise SoftcatError("at t = 0 s: no shape in balance was found to begin from")
    state = sites_of(graph, described.model.slots).state(start.x, start.z)
    observed = graph.symbolic.observables(time=0.0, state=start.x, algebraic=start.z, parameters=p)
    names, length = [slot.name for slot in described.model.slots], rest_length(scene)
    for kind in {*PLACES, *TURN} & set(names):
        held, unit = observed[kind], length if kind in PLACES else 1.0
        state[[0, -1], names.index(kind)] = float(held[0]) / unit, float(held[-1]) / unit
    if "psi" in names:
        holding = (graph.grid.first, graph.grid.last)
        for place, support, (_, _, angle) in zip((0, -1), holding, scene.ends.sides, strict=True):
            if support.holds_angle:
                state[place, names.index("psi")] = 0.0 if support is SYMMETRY else angle
    return state


PRODUCTS_COMMAND = "softcat generate --bundled -o generated"
NAME = "filament"


def bundled(on_progress: Callable[[str], None] = lambda _: None) -> dict[str, Description]:
    """Each bundled scene, described for C, but those that a nozzle lays, which have no generated program."""
    described = {}
    for name in bundled_names():
        on_progress(name)
        if not (scene := load_scene(name)).extrusion.present:
            described[name] = export(scene)[0]
    return described


def contents(described: dict[str, Description]) -> dict[str, str]:
    """The runtime, and each structure in a folder named after the first scene that has it, by path."""
    templates = resources.files("softcat_sym.codegen") / "templates"
    files = {f"runtime/{file}": text for file, text in runtime_files().items()}
    files["runtime/main.c"] = (templates / "main.c").read_text(encoding="utf-8")
    folders: dict[str, str] = {}
    rows = []
    for scene, product in described.items():
        if product.digest not in folders:
            folders[product.digest] = scene
            model = model_files(product, NAME, PRODUCTS_COMMAND)
            files |= {f"{scene}/{file}": text for file, text in model.items()}
        material, section = product.scene.material, product.scene.filament.section
        rows.append(f"| {scene} | {material.law} | {section} | {folders[product.digest]} |")
    counts = {"count": len(folders), "scenes": len(described), "table": "\n".join(rows)}
    files["README.md"] = rendered("products.md", command=PRODUCTS_COMMAND, **counts)
    return files


def write(directory: str | Path, on_progress: Callable[[str], None] = lambda _: None) -> list[Path]:
    """Write the products, all or none; folders of structures that are no longer among them are left alone."""
    return write_results(directory, dict(sorted(contents(bundled(on_progress)).items())))
