"""How the half filament is held: by the plane of symmetry at midspan and by one of two clamps."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np
import numpy.typing as npt

from softcat_sym.reference.mesh import Indices, Strip


class Clamp(Enum):
    """What a clamped face may still do.

    Holding the centre node alone is not offered: a point load indents without limit as the mesh is refined.
    """

    THINNING = "no axial displacement, centre fixed, section plane, vertical and free to thin: u_y = (lambda - 1) Y"
    FIXED = "every node of the face fixed"


@dataclass(frozen=True)
class Supports:
    """Which displacements are zero, and which face thins as one.

    Attributes
    ----------
    held : ndarray of bool, shape (nodes, 2)
        Displacements along x and y that stay zero.
    face : ndarray of int, shape (face nodes,)
        Nodes that move as u_y = (lambda - 1) Y with a common lambda; empty where no face does.
    """

    held: npt.NDArray[np.bool_]
    face: Indices


def half_span_supports(strip: Strip, clamp: Clamp) -> Supports:
    """Symmetry at midspan (u_x = 0, u_y free), the clamp at X = L/2."""
    held = np.zeros(strip.position.shape, dtype=bool)
    held[strip.midspan, 0] = True
    held[strip.face] = True
    return Supports(held, strip.face if clamp is Clamp.THINNING else strip.face[:0])
