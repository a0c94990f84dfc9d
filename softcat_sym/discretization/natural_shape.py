"""A natural shape on a grid: places and quaternions of nodes that strain no cell, and the curvatures of the cells."""

from __future__ import annotations

import math

import numpy as np
from scipy.spatial.transform import Rotation

from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import Fault, SceneError
from softcat_sym.scene.natural_curve import natural_curve
from softcat_sym.scene.scene import Scene

_CLOSED = 1e-13
"""Part of the length by which a chain of cells may miss the end of its curve."""
_TRIES = 50
_MOST_TURN = 1.0
"""Of a cell [rad]: beyond, a chain of cells is no longer like its curve."""


def shaped(scene: Scene, nodes: Floats) -> tuple[Floats, Floats, Floats]:
    """Sample a natural shape.

    The nodes turn as the curve does; the chain of straight cells, each in the middle of the turns of its nodes, would
    end beside the curve by the square of their length, so that the turns between the ends are corrected by as much.

    Parameters
    ----------
    scene : Scene
        With a shape.
    nodes : ndarray, shape (nodes,)
        X over the length, from -1/2 to 1/2.

    Returns
    -------
    places : ndarray, shape (nodes, 3)
        From the left support, over the length.
    quaternions : ndarray, shape (nodes, 4)
        w, x, y, z.
    natural : ndarray, shape (cells, 3)
        Twist and curvatures [1/m].
    """
    curve = natural_curve(scene)
    share, cells = nodes + 0.5, np.diff(nodes)[:, None]
    quaternions = curve.quaternions(share * curve.length)
    # The cosine of half the turn from node to node.
    turn = float(2 * np.arccos(np.min(np.sum(quaternions[1:] * quaternions[:-1], axis=1).clip(-1, 1))))
    if turn > _MOST_TURN:
        half = len(cells) / 2
        found, accepted = f"{half:g}: a cell turns by {turn:.2g} rad", f"{math.ceil(half * turn)} or more"
        raise SceneError([Fault("numerics.cells", found, accepted)])
    goal, bump = curve.places(np.array([curve.length]))[0] / curve.length, (4 * share * (1 - share))[:, None]
    for _ in range(_TRIES):
        turns = Rotation.from_quat(np.roll(quaternions, -1, axis=1))
        steps = (turns[:-1].inv() * turns[1:]).as_rotvec()
        slopes = (turns[:-1] * Rotation.from_rotvec(steps / 2)).apply([1.0, 0.0, 0.0])
        places = np.vstack([np.zeros(3), np.cumsum(cells * slopes, axis=0)])
        missed = goal - places[-1]
        if np.abs(missed).max() < _CLOSED:
            break
        # Turned by d1 x lam, a cell leads on by lam - d1 (d1 . lam).
        weight = cells * (bump[1:] + bump[:-1]) / 2
        moved = weight.sum() * np.eye(3) - (weight * slopes).T @ slopes
        lam = np.linalg.lstsq(moved, missed, rcond=1e-12)[0]
        corrected = Rotation.from_rotvec(bump * np.cross(turns.apply([1.0, 0.0, 0.0]), lam)) * turns
        found = np.roll(corrected.as_quat(), 1, axis=1)
        quaternions = found * np.sign(np.sum(found * quaternions, axis=1, keepdims=True))
    else:
        found = "a curve whose end a chain of cells does not reach"
        raise SceneError([Fault("filament.shape", found, "a curve that bends less, or more numerics.cells")])
    return places, quaternions, steps / (cells * curve.length)
