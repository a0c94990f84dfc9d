"""``softcat track``: midpoint, thickness and shapes of a strand in a film, for ``softcat fit``."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from softcat_sym.cli import application as cli
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import StudyDisplay

with lazy_imports():
    from softcat_sym import files
    from softcat_sym.tracking import contour as contours
    from softcat_sym.tracking import track as tracking


def track(
    film: Annotated[
        Path,
        typer.Argument(metavar="FILM", help="A film, a TIFF stack, or a folder of pictures in the order of names."),
    ],
    scale: Annotated[
        str,
        cli.option(
            "WHAT=LENGTH",
            "Scale: 'span=50 mm' (distance of the supports), 'pixel=20 um', or 'needle@x0,x1,y0,y1=1.2 mm' (width of a "
            "bar in a region).",
        ),
    ],
    output: Annotated[
        Path | None, cli.output_option("softcat-out/FILM-track", "Folder for the files, or the CSV file among them.")
    ] = None,
    shapes: Annotated[
        int, cli.option("N", "Points of whole shapes to write for each frame, instead of the midpoint.", min=0, max=11)
    ] = 0,
    roi: Annotated[cli.Text, cli.option("X0,X1,Y0,Y1", "Part of the picture: its columns and rows.")] = None,
    supports: Annotated[
        cli.Text, cli.option("X0,X1", "Columns of the supports' edges, in that part; found by default.")
    ] = None,
    release: Annotated[
        cli.Text, cli.option("FRAME|TIME", "Frame or time ('0.35 s') of the release; found to half a frame by default.")
    ] = None,
    fps: Annotated[
        cli.Number, cli.option("NUMBER", "Frames a second; by default the times of the file. Pictures need it.")
    ] = None,
    dark: Annotated[
        bool | None,
        typer.Option("--dark/--light", help="Whether the strand is darker than the background; else found."),
    ] = None,
    vertical: Annotated[bool, cli.switch("Turn the picture by 90 degrees: the strand hangs.", "--vertical")] = False,
    every: Annotated[int, cli.option("N", "Read every so many frames.", min=1)] = 1,
    no_flatten: Annotated[bool, cli.switch("Leave uneven light in.", "--no-flatten")] = False,
    contour: Annotated[
        bool,
        cli.switch(
            "FILM is one picture of a strand over pillars: its contour for softcat fit --test collapse.", "--contour"
        ),
    ] = False,
    overlay: Annotated[bool, cli.switch("Also write overlay.mp4, every frame with its edges.", "--overlay")] = False,
    quiet: cli.QuietOption = False,
) -> None:
    """Track a strand through a film: midpoint and thickness over time, with errors.

    DIR gets track.csv as softcat fit reads it, refused.csv, track.json, track.png, and the first, middle, last and
    worst frame with the edges that were found; of one picture with --contour it gets contour.csv and that picture.
    Exit status 1 if more frames were refused than read.
    """
    table = "contour.csv" if contour else "track.csv"
    if output is not None and output.suffix.lower() == ".csv":
        output, table = output.parent, output.name
    output = cli.output_directory(output, "track", film.stem or film.resolve().name)
    edges, region = (None if text is None else text.split(",") for text in (supports, roi))
    if contour:
        strand = contours.contour(film, scale, region=region, dark=dark, flatten=not no_flatten)
        cli.present(strand, output, quiet=quiet, table=table)
        return
    with files.new_folder(output), StudyDisplay(quiet=quiet) as progress:
        progress.stage("tracking")
        found = tracking.track(
            film, scale, region=region, supports=edges, release=release, fps=fps, dark=dark, vertical=vertical,
            every=every, flatten=not no_flatten, progress=progress,
        )  # fmt: skip
    cli.present(found, output, quiet=quiet, table=table, points=shapes, overlay=overlay)
    if not found.is_trusted:
        cli.print_error(f"{len(found.refused)} frames refused, {found.number.size} read: see refused.csv")
        raise typer.Exit(cli.UNTRUSTED)
