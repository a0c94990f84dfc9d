"""A scene in CalculiX, a finite element program that is not ours: found, run, watched, ended, and read."""

from __future__ import annotations

import re
import shutil
import signal
import subprocess
import tempfile
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.calculix_deck import STEP, Deck, calculix_deck
from softcat_sym.reference.calculix_reading import read_displacements, read_status
from softcat_sym.reference.element import Floats
from softcat_sym.reference.elements import Progress
from softcat_sym.reference.mesh import Mesh
from softcat_sym.reference.supports import Clamp
from softcat_sym.scene import Scene
from softcat_sym.scene.scales import elastic_time

_PROGRAM = "ccx"
_JOB = "deck"
_KEPT = (f"{_JOB}.inp", f"{_JOB}.dat", f"{_JOB}.sta", f"{_JOB}.cvg")

# Seconds between two looks at how far the run is, and those a program is given to end by itself.
_LOOK, _GRACE = 0.2, 5.0

_METRE = 1e-3
"""A millimetre, the unit of the deck."""


@dataclass(frozen=True)
class CalculixRun:
    """A finished run of CalculiX; shapes are of the half X >= 0.

    Attributes
    ----------
    time : ndarray, shape (frames,)
        Output times [s].
    elastic_time : float
        L sqrt(rho/E) [s].
    midpoint : ndarray, shape (frames,)
        Height of the node X = 0, Y = 0 [m].
    X : ndarray, shape (columns,)
        Reference positions of the nodes of the centreline [m].
    x, y : ndarray, shape (frames, columns)
        Where they are [m].
    dofs : int
        Displacements that are free.
    steps : int
        Increments taken.
    wall : float
        Seconds spent.
    mesh : Mesh
        The bricks, in the plane.
    clamp : Clamp
        What the clamped face may do.
    files : mapping of str to bytes
        Deck and print-outs, by file name.
    """

    time: Floats
    elastic_time: float
    midpoint: Floats
    X: Floats
    x: Floats
    y: Floats
    dofs: int
    steps: int
    wall: float
    mesh: Mesh
    clamp: Clamp
    files: Mapping[str, bytes] = field(repr=False)


def find_calculix() -> str | None:
    """Path of the program ``ccx``, or None."""
    return shutil.which(_PROGRAM)


def require_calculix() -> str:
    """Path of the program ``ccx``.

    Raises
    ------
    SoftcatError
        If it is not installed.
    """
    found = find_calculix()
    if found is None:
        raise SoftcatError(
            f"CalculiX is not installed: there is no program {_PROGRAM!r} on the path. On Debian and Ubuntu: "
            "apt-get install calculix-ccx. The deck can be written without it: --deck-only"
        )
    return found


def run_calculix(
    scene: Scene,
    mesh: Mesh | None = None,
    *,
    clamp: Clamp = Clamp.THINNING,
    step: float = STEP,
    progress: Progress | None = None,
) -> CalculixRun:
    """Run a scene in CalculiX.

    It works in a folder of its own that does not outlive the run. Ctrl-C ends it, and is passed on.

    Parameters
    ----------
    scene, mesh, clamp, step
        As :func:`softcat_sym.reference.calculix_deck.calculix_deck`.
    progress : Progress, optional
        Told the simulated time.

    Returns
    -------
    CalculixRun

    Raises
    ------
    SceneError
        If the scene holds what the elements do not know.
    SoftcatError
        If CalculiX is not installed, or gives up.
    """
    mesh = mesh if mesh is not None else Mesh()
    deck, program = calculix_deck(scene, mesh, clamp=clamp, step=step), require_calculix()
    start = time.perf_counter()
    files = _files_of(deck, program, progress)
    wall = time.perf_counter() - start
    x, y = _centreline(deck, _text(files, "dat"))
    return CalculixRun(
        time=deck.time,
        elastic_time=elastic_time(scene),
        midpoint=y[:, 0],
        X=deck.X,
        x=x,
        y=y,
        dofs=deck.dofs,
        steps=read_status(_text(files, "sta"))[0],
        wall=wall,
        mesh=mesh,
        clamp=clamp,
        files=files,
    )


def _files_of(deck: Deck, program: str, progress: Progress | None) -> dict[str, bytes]:
    """Run a deck in a folder of its own; what is kept of it, by file name."""
    with tempfile.TemporaryDirectory(prefix="softcat-calculix-") as name:
        folder = Path(name)
        (folder / f"{_JOB}.inp").write_text(deck.text, encoding="ascii")
        _execute(program, folder, progress)
        return {kept: (folder / kept).read_bytes() for kept in _KEPT if (folder / kept).is_file()}


def _text(files: Mapping[str, bytes], ending: str) -> str:
    return files.get(f"{_JOB}.{ending}", b"").decode("ascii", "replace")


def _execute(program: str, folder: Path, progress: Progress | None) -> None:
    """Run the deck of a folder to its end, telling how far it is."""
    status = folder / f"{_JOB}.sta"
    with (folder / "log").open("wb") as log:
        # In a session of its own: Ctrl-C reaches this program first, which then ends the other.
        child = subprocess.Popen(
            [program, _JOB], cwd=folder, stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True
        )
        try:
            while True:
                try:
                    child.wait(_LOOK)
                    break
                except subprocess.TimeoutExpired:
                    if progress is not None and status.is_file():
                        _, reached, increment = read_status(status.read_text("ascii", "replace"))
                        progress.update(reached, increment)
        finally:
            _end(child)
    if child.returncode:
        raise SoftcatError(f"CalculiX gave up: {_complaint(folder, child.returncode)}")


def _end(child: subprocess.Popen[bytes]) -> None:
    """End a program that still runs."""
    if child.poll() is not None:
        return
    child.terminate()
    try:
        child.wait(_GRACE)
    except subprocess.TimeoutExpired:
        child.kill()
        child.wait()


def _complaint(folder: Path, code: int) -> str:
    """What the log says went wrong, and when."""
    log = (folder / "log").read_text("ascii", "replace")
    found = re.findall(r"\*ERROR[^\n]*(?:\n +\S[^\n]*)*", log)
    ended = f"exit status {code}" if code > 0 else f"killed by signal {-code}: {signal.strsignal(-code) or 'unknown'}"
    words = " ".join(found[-1].split()) if found else ended
    status = folder / f"{_JOB}.sta"
    _, reached, _ = read_status(status.read_text("ascii", "replace") if status.is_file() else "")
    advice = "refine the mesh, or shorten the increments" if code > 0 else "if memory ran out, coarsen the mesh"
    return f"{words} (after {reached:.6g} s of simulated time); {advice}"


def _centreline(deck: Deck, printed: str) -> tuple[Floats, Floats]:
    """Positions of the centreline [m], at rest in the first frame; two arrays of shape (frames, columns)."""
    displacement = np.zeros((len(deck.time), len(deck.centreline), 3))
    displacement[1:] = _METRE * read_displacements(printed, deck.centreline, deck.time[1:])
    return deck.X + displacement[..., 0], displacement[..., 1]
