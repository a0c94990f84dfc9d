"""What a fit is given: measurements, or the files that hold them."""

from __future__ import annotations

import os
from collections.abc import Sequence

from softcat_sym.inverse.measurements.plausibility import checked
from softcat_sym.inverse.measurements.reading import read_measurements
from softcat_sym.inverse.measurements.series import Measurements
from softcat_sym.scene import Scene

Films = Measurements | str | os.PathLike[str] | Sequence[str | os.PathLike[str]]
"""Measurements, or one file for each filament."""


def taken(films: Films, scene: Scene) -> Measurements:
    """Read measurements where they are files, and hold them against their scene.

    Raises
    ------
    SoftcatError
        If they cannot be used, with every fault.
    """
    read = films if isinstance(films, Measurements) else read_measurements(films)
    return checked(read, scene)
