"""The complete state of a run of the elements in one file, for the same problem only."""

from __future__ import annotations

import hashlib
import json
import zipfile
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError
from softcat_sym.files import fill_atomically
from softcat_sym.reference.mesh import Mesh
from softcat_sym.reference.problem import Problem
from softcat_sym.reference.supports import Clamp

State = Mapping[str, npt.NDArray[np.generic]]

# Raised when the Python side of a run changes what it computes; the C side is hashed.
_VERSION = 1
_KEY = "fingerprint"


def fingerprint(problem: Problem, mesh: Mesh, clamp: Clamp, step_factor: float, sources: Mapping[str, str]) -> str:
    """Hash of all that decides the numbers: dimensionless groups, mesh, clamp, step and code.

    Parameters
    ----------
    problem : Problem
        The groups.
    mesh : Mesh
        The mesh.
    clamp : Clamp
        What the clamped face may do.
    step_factor : float
        Step over the stable one that is taken by itself.
    sources : mapping of str to str
        C text by file name.
    """
    content = {
        "version": _VERSION,
        "problem": asdict(problem),
        "mesh": asdict(mesh),
        "clamp": clamp.name,
        "step_factor": step_factor,
        "sources": dict(sources),
    }
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()


def write_checkpoint(path: Path, key: str, state: State) -> None:
    """Write a state whole or not at all.

    Raises
    ------
    SoftcatError
        If the file cannot be written.
    """
    arrays: dict[str, Any] = {_KEY: np.array(key), **state}

    def fill(passing: Path) -> None:
        with passing.open("xb") as stream:
            np.savez(stream, **arrays)

    try:
        fill_atomically(path, fill)
    except OSError as error:
        raise SoftcatError(f"cannot write the checkpoint {path}: {error.strerror or error}") from error


def read_checkpoint(path: Path, key: str) -> dict[str, npt.NDArray[np.generic]] | None:
    """The state in a file, or None where there is no file.

    Raises
    ------
    SoftcatError
        If the file is damaged, or of another problem.
    """
    if not path.exists():
        return None
    try:
        # Opened here: NumPy leaves the file open where it is no archive.
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as archive:
            state = {name: archive[name] for name in archive.files}
    except (OSError, ValueError, EOFError, zipfile.BadZipFile) as error:
        raise SoftcatError(f"{path} is no checkpoint of elements ({error}); delete it or name another") from error
    if str(state.pop(_KEY, "")) != key:
        raise SoftcatError(
            f"{path} is the checkpoint of another problem, mesh, step or version of this program; "
            "delete it or name another"
        )
    return state
