"""Axial true strain next to the clamp, where filaments neck and tear, taken alike from filament and elements."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from softcat_sym.graph.grid import Floats
from softcat_sym.study.discrepancy import aligned

if TYPE_CHECKING:
    import xarray as xr

    from softcat_sym.reference import ElementRun

DEFINITION = (
    "axial true strain, mean and largest over the Gauss points of the elements at the clamp: log |F e_X| of the "
    "elements; log s - theta_s z of the filament [2.6, objective form], in its fibres through the same material points"
)


@dataclass(frozen=True)
class ClampStrain:
    """Axial true strain at the points of the elements at the clamp.

    Attributes
    ----------
    mean, largest : ndarray, shape (frames,)
        Over these points; NaN after a run has ended early.
    """

    mean: Floats
    largest: Floats


def elements_clamp_strain(run: ElementRun) -> ClampStrain:
    """What the elements recorded."""
    return ClampStrain(run.clamp_strain, run.clamp_strain_largest)


def filament_clamp_strain(data: xr.Dataset, run: ElementRun, thickness: float) -> ClampStrain:
    """Strain of the filament's fibres through the Gauss points of the elements at the clamp.

    The strain is the one that the theory itself uses, eps = log s - theta_s (h/2) zeta with the present thickness h.
    Along the filament it is interpolated between cell centres, and constant from the last centre to the clamp.

    Parameters
    ----------
    data : xarray.Dataset
        Trajectory with ``stretch``, ``curvature``, ``thickness`` (time, cell).
    run : ElementRun
        For the points and the output times.
    thickness : float
        h0 [m].
    """
    X, Y = run.point[-run.mesh.through :].reshape(-1, 2).T
    centres = data["X_cell"].values
    fields = (data[name].values for name in ("stretch", "curvature", "thickness"))
    stretch, curvature, height = (_along(X, centres, values) for values in fields)
    strain = np.log(stretch) - curvature * height / 2 * (Y / (thickness / 2))
    time = data["time"].values
    return ClampStrain(*(aligned(time, values, run.time) for values in (strain.mean(axis=1), strain.max(axis=1))))


def _along(X: Floats, centres: Floats, values: Floats) -> Floats:
    return np.array([np.interp(X, centres, frame) for frame in values])
