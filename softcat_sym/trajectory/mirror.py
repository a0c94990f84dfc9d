"""A half span becomes the whole one: every field is even or odd about the symmetry plane X = 0."""

from __future__ import annotations

import numpy as np

from softcat_sym.graph.grid import Floats

_ODD = frozenset({"x", "shear", "shear_force"})
_NODE = frozenset({"x", "y"})


def mirrored(name: str, values: Floats) -> Floats:
    """Whole-span field from its right half.

    Parameters
    ----------
    name : str
        Name of the field; x, shear and the transverse force are odd, all others even.
    values : ndarray, shape (frames, size)
        The right half, from the symmetry plane outwards.

    Returns
    -------
    ndarray, shape (frames, 2 size) or (frames, 2 size - 1)
        The node on the plane stands once.
    """
    sign = -1.0 if name in _ODD else 1.0
    left = sign * values[:, ::-1]
    return np.concatenate([left[:, :-1] if name in _NODE else left, values], axis=1)
