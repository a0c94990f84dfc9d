"""Energy audit: kinetic + elastic + surface + potential + dissipated + gradient - work must stay what it was."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from softcat_sym.graph.grid import Floats

_STORED = (
    "energy_kinetic",
    "energy_elastic",
    "energy_surface",
    "energy_potential",
    "energy_dissipated",
    "energy_gradient",
)


def energy_residual(fields: Mapping[str, Floats], least: float = 0.0) -> float:
    """Largest imbalance over the run, relative to the largest energy in it.

    Parameters
    ----------
    fields : mapping of str to ndarray, shape (frames,)
        The six energies and ``work_external`` [J].
    least : float
        Energy that counts as none [J]: where all are smaller, as in a filament that rests without stress, an imbalance
        is measured by this.
    """
    balance = sum(fields[name] for name in _STORED) - fields["work_external"]
    scale = max(float(np.max(np.abs(fields[name]))) for name in (*_STORED, "work_external"))
    scale = max(scale, least)
    return float(np.max(np.abs(balance - balance[0]))) / scale if scale > 0 else 0.0
