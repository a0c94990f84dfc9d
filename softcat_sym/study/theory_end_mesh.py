"""Elements that follow the thickness: short enough at the clamp however thin the filament, and a coarser companion."""

from __future__ import annotations

import math
from dataclasses import replace

from softcat_sym.errors import SoftcatError
from softcat_sym.reference import Mesh

ASPECT = 1.5
"""Length of the elements at the clamp over their height, where `along` elements of equal length would be longer."""

_STEEPEST = 64.0


def mesh_following(thickness: float, along: int = 32, through: int = 4) -> Mesh:
    """A mesh whose elements at the clamp are `ASPECT` times as long as high, and longer towards midspan.

    The layer in which the clamp bends the filament is as short as the filament is thin, so that equal elements would
    lose it; the explicit step is that of the shortest edge, which stays the height.

    Parameters
    ----------
    thickness : float
        h0/L.
    along, through : int
        Elements over half the span and through the thickness.

    Raises
    ------
    SoftcatError
        If the elements cannot be halved for the coarser companion.
    """
    if along < 2 or along % 2 or through < 4 or through % 4:
        raise SoftcatError(
            f"mesh of {along} x {through} elements: half as many must be a mesh too; take an even number along, and "
            "4 or a multiple of it through the thickness"
        )
    equal, wanted = 0.5 / along, ASPECT * thickness / through
    return Mesh(along, through, grading=_grading(wanted / equal, along))


def coarser(mesh: Mesh) -> Mesh:
    """Half as many elements both ways, graded alike."""
    return replace(mesh, along=mesh.along // 2, through=mesh.through // 2)


def _grading(share: float, along: int) -> float:
    """The grading that makes the last element `share` times as long as the mean; by bisection, rounded."""
    if share >= 1:
        return 1.0

    def last(grading: float) -> float:
        ratio = grading ** (-1 / (along - 1))
        return float(along * (1 / grading) * (1 - ratio) / (1 - ratio**along))

    low, high = 1.0, _STEEPEST
    for _ in range(60):
        middle = math.sqrt(low * high)
        low, high = (middle, high) if last(middle) > share else (low, middle)
    # Two digits: a mesh that people can name.
    return max(1.0, float(f"{low:.2g}"))
