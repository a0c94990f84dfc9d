"""CalculiX: where it is, its runs and what they print."""

from __future__ import annotations

import math
import re
import shutil
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from softcat_sym.codegen.compiler import run
from softcat_sym.errors import SoftcatError
from softcat_sym.reference.calculix import STEP, calculix_deck
from softcat_sym.reference.element_loop import Clamp, Floats, Indices, Mesh
from softcat_sym.scene.scene import Scene

_HEAD = re.compile(r"^ displacements \(vx,vy,vz\) for set \S+ and time\s+(\S+)\s*$", re.MULTILINE)

# Fortran leaves the letter out before an exponent of three digits.
_BARE_EXPONENT = re.compile(r"(?<=\d)(?=[+-]\d{3}\b)")

# The times of print-outs have eight digits.
_SAME_TIME = 1e-6


def read_displacements(text: str, nodes: Indices, time: Floats) -> Floats:
    """Displacements of printed nodes."""
    parts = _HEAD.split(_BARE_EXPONENT.sub("E", text))
    found = np.array([float(instant) for instant in parts[1::2]])
    if found.shape != time.shape or np.abs(found - time).max(initial=0.0) > _SAME_TIME * time[-1]:
        reached = f"; the last is {found[-1]:.6g} s of {time[-1]:.6g} s" if found.size else ""
        raise SoftcatError(f"CalculiX printed {found.size} of {time.size} output times{reached}")
    place = {int(number): column for column, number in enumerate(nodes)}
    displacement = np.full((len(time), len(nodes), 3), np.nan)
    for frame, block in enumerate(parts[2::2]):
        for line in block.splitlines():
            words = line.split()
            if len(words) == 4 and words[0].isdigit() and int(words[0]) in place:
                displacement[frame, place[int(words[0])]] = [float(word) for word in words[1:]]
    if np.isnan(displacement).any():
        raise SoftcatError("CalculiX did not print the displacements of every node of the centreline")
    return displacement


def read_status(text: str) -> tuple[int, float]:
    """Increments done, and the time reached [s]."""
    done, time = 0, 0.0
    for line in text.splitlines(keepends=True):
        words = line.split()
        # An attempt that failed has a U behind its number.
        if len(words) == 7 and line.endswith("\n") and all(word.isdigit() for word in words[:4]):
            done, time = done + 1, float(words[4])
    return done, time


_JOB = "deck"


@dataclass(frozen=True)
class CalculixRun:
    """A finished run of CalculiX; shapes are of the half X >= 0."""

    time: Floats  # shape (frames,); Output times [s]
    midpoint: Floats  # shape (frames,); Height of the node X = 0, Y = 0 [m]
    x: Floats  # shape (frames, columns); Where the nodes of the centreline are [m]
    y: Floats
    steps: int  # Increments taken
    wall: float  # Seconds spent


def find_calculix() -> str | None:
    """Path of the program ``ccx``, or None."""
    return shutil.which("ccx")


def run_calculix(scene: Scene, mesh: Mesh, *, clamp: Clamp = Clamp.THINNING, step: float = STEP) -> CalculixRun:
    """Run a scene in CalculiX, in a folder of its own that does not outlive the run."""
    deck, start = calculix_deck(scene, mesh, clamp=clamp, step=step), time.perf_counter()
    with tempfile.TemporaryDirectory(prefix="calculix-") as name:
        folder = Path(name)
        (folder / f"{_JOB}.inp").write_text(deck.text, encoding="ascii")
        done = run([str(find_calculix()), _JOB], math.inf, folder)
        if done.returncode:
            raise SoftcatError(f"CalculiX failed: {_message(folder, done)}")
        printed, status = ((folder / f"{_JOB}.{ending}").read_text("ascii", "replace") for ending in ("dat", "sta"))
    displacement = np.zeros((len(deck.time), len(deck.centreline), 3))
    displacement[1:] = 1e-3 * read_displacements(printed, deck.centreline, deck.time[1:])
    x, y = deck.X + displacement[..., 0], displacement[..., 1]
    return CalculixRun(deck.time, y[:, 0], x, y, read_status(status)[0], time.perf_counter() - start)


def _message(folder: Path, done: subprocess.CompletedProcess[str]) -> str:
    """What the program says went wrong, and when."""
    code, found = done.returncode, re.findall(r"\*ERROR[^\n]*(?:\n +\S[^\n]*)*", done.stdout + done.stderr)
    ended = f"exit status {code}" if code > 0 else f"killed by signal {-code}: {signal.strsignal(-code) or 'unknown'}"
    words = " ".join(found[-1].split()) if found else ended
    status = folder / f"{_JOB}.sta"
    _, reached = read_status(status.read_text("ascii", "replace") if status.is_file() else "")
    advice = "refine the mesh, or shorten the increments" if code > 0 else "if memory ran out, coarsen the mesh"
    return f"{words} (after {reached:.6g} s of simulated time); {advice}"
