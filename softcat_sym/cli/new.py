"""``softcat new`` and ``softcat samples``: a first scene of the user, and sample files for the commands."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from importlib import resources
from pathlib import Path
from typing import Annotated, Any

import typer

from softcat_sym.cli import application as cli
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.lazy import lazy_imports

with lazy_imports():
    from softcat_sym import files
    from softcat_sym.scene import keys as scene_keys


def _value(help_text: str, *names: str) -> Any:
    return cli.option("VALUE", help_text, *names)


ForceOption = Annotated[bool, cli.switch("Replace an existing file.", "--force")]


def new(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="File to write: my-ink.toml.")],
    span: Annotated[cli.Text, _value("Distance of the supports: '5 mm'.")] = None,
    diameter: Annotated[cli.Text, _value("Diameter of the strand: '0.4 mm'.")] = None,
    density: Annotated[cli.Text, _value("Density: '2200 kg/m^3'.")] = None,
    law: Annotated[cli.Text, _value("Law: bingham, herschel-bulkley, newtonian, elastic, ...")] = None,
    storage_modulus: Annotated[cli.Text, _value("Storage modulus G' below yield, from a rheometer: '103 kPa'.")] = None,
    loss_modulus: Annotated[cli.Text, _value("Loss modulus G'' below yield, beside G': '10 kPa'.")] = None,
    loss_tangent: Annotated[cli.Text, _value("G''/G' in place of G'': 0.1.")] = None,
    youngs_modulus: Annotated[
        cli.Text, _value("Young's modulus in place of G': '300 kPa'. That of an ink is three times its G'.")
    ] = None,
    yield_stress: Annotated[
        cli.Text, _value("Yield stress in shear, from a rheometer: '200 Pa'.", "--shear-yield-stress")
    ] = None,
    viscosity: Annotated[cli.Text, _value("Viscosity in shear once it flows: '10 Pa*s'.", "--shear-viscosity")] = None,
    consistency: Annotated[
        cli.Text, _value("Consistency in shear of a law with an index: '10 Pa*s^0.5'.", "--shear-consistency")
    ] = None,
    index: Annotated[cli.Text, _value("Index of herschel-bulkley or power-law: 0.5.")] = None,
    surface_tension: Annotated[cli.Text, _value("Surface tension: '72 mN/m'.")] = None,
    duration: Annotated[cli.Text, _value("Duration of the run: '0.5 s'.")] = None,
    force: ForceOption = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Write a first scene of your own, with comments.

    On a terminal the command asks for the values. With options, or without a terminal, values that are not given are
    those of an ink.
    """
    if file.suffix != ".toml":
        raise typer.BadParameter(f"{str(file)!r}; accepted: a name that ends in .toml", param_hint="FILE")
    flags = {
        "filament.span": span,
        "filament.thickness": diameter,
        "filament.density": density,
        "material.law": law,
        "material.storage_modulus": storage_modulus,
        "material.loss_modulus": loss_modulus,
        "material.loss_tangent": loss_tangent,
        "material.youngs_modulus": youngs_modulus,
        "material.shear_yield_stress": yield_stress,
        "material.shear_viscosity": viscosity,
        "material.shear_consistency": consistency,
        "material.index": index,
        "surroundings.surface_tension": surface_tension,
        "run.duration": duration,
    }
    given = {path: text for path, text in flags.items() if text is not None}
    if not given and sys.stdin.isatty() and sys.stdout.isatty():
        given = _prompted()
    try:
        text, scene = scene_keys.scene_template(file.stem.replace("-", " ").replace("_", " ").capitalize(), given)
    except SceneError as error:
        raise SceneError(error.faults, str(file)) from None
    _write_new(file.parent, {file.name: text.encode()}, force=force)
    if not quiet:
        for note in scene.material.notes:
            typer.echo(note)
        typer.echo(f"wrote {file}; next: softcat run {file}")


def _prompted() -> dict[str, str]:
    """Ask for one value after the other, each until it is valid."""
    meaning = {key.path: key.meaning for key in scene_keys.scene_keys()}
    answers: dict[str, str] = {}

    def accepted(text: str) -> tuple[str, str]:
        key = scene_keys.LOSS_MODULUS if path == scene_keys.LOSS and text.strip()[-1:].isalpha() else path
        try:
            scene_keys.scene_template("", {**answers, key: text})
        except SceneError as error:
            # Faults of values that are asked for later do not count yet.
            here = [f"{fault.found}; accepted: {fault.accepted}" for fault in error.faults if fault.path == key]
            if here:
                raise typer.BadParameter("; ".join(here)) from None
        return key, text

    while waiting := [path for path in scene_keys.example_values(answers) if path not in answers]:
        path = waiting[0]
        other = "Or G'' itself, with its unit: 10 kPa." if path == scene_keys.LOSS else ""
        typer.echo(" ".join(filter(None, [meaning[path], scene_keys.REASONS.get(path), other])))
        key, text = typer.prompt(path, default=scene_keys.example_values(answers)[path], value_proc=accepted)
        answers[key] = text
    return answers


def samples(
    output: cli.OutputOption = None,
    force: ForceOption = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Copy sample files: a scene, a film, a flow curve.

    my-ink.toml is an ink, film.mov a film of its fall across a gap of 10 mm, film.csv the numbers of such a film,
    my-curve.csv its flow curve. This package computed films and curve, with added noise.
    """
    output = cli.output_directory(output, "samples")
    folder = resources.files("softcat_sym") / "samples"
    contents = {entry.name: entry.read_bytes() for entry in sorted(folder.iterdir(), key=lambda entry: entry.name)}
    _write_new(output, contents, force=force)
    if not quiet:
        typer.echo(f"wrote {', '.join(contents)} to {output}")


def _write_new(folder: Path, contents: Mapping[str, bytes], *, force: bool) -> None:
    """Write all files, or none if some exist already with other content."""
    paths = {folder / name: content for name, content in contents.items()}
    there = [
        str(path)
        for path, content in paths.items()
        if path.exists() and not (path.is_file() and path.read_bytes() == content)
    ]
    if there and not force:
        raise SoftcatError(f"already exist, and not replaced without --force: {', '.join(there)}")
    files.write_results(folder, contents)
