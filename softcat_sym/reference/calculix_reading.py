"""What CalculiX prints while it runs (.sta) and for printed nodes (.dat), as numbers."""

from __future__ import annotations

import re

import numpy as np

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.element import Floats
from softcat_sym.reference.mesh import Indices

_HEAD = re.compile(r"^ displacements \(vx,vy,vz\) for set \S+ and time\s+(\S+)\s*$", re.MULTILINE)

# Fortran leaves the letter out before an exponent of three digits.
_BARE_EXPONENT = re.compile(r"(?<=\d)(?=[+-]\d{3}\b)")

# The times of print-outs have eight digits.
_SAME_TIME = 1e-6


def read_displacements(text: str, nodes: Indices, time: Floats) -> Floats:
    """Displacements of printed nodes.

    Parameters
    ----------
    text : str
        Content of a .dat file.
    nodes : ndarray of int, shape (nodes,)
        Whose displacements are wanted, in this order.
    time : ndarray, shape (times,)
        When, in the order of the file [s].

    Returns
    -------
    ndarray, shape (times, nodes, 3)
        In the unit of the deck.

    Raises
    ------
    SoftcatError
        If the file holds other times or nodes.
    """
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


def read_status(text: str) -> tuple[int, float, float]:
    """How far a run is.

    Parameters
    ----------
    text : str
        Content of a .sta file, maybe while it is being written: an unfinished last line is left out.

    Returns
    -------
    (int, float, float)
        Increments that converged, time reached [s], last increment [s].
    """
    done, time, increment = 0, 0.0, 0.0
    for line in text.splitlines(keepends=True):
        words = line.split()
        # An attempt that failed has a U behind its number.
        if len(words) == 7 and line.endswith("\n") and all(word.isdigit() for word in words[:4]):
            done, time, increment = done + 1, float(words[4]), float(words[6])
    return done, time, increment
