"""What is kept of the elements at each output time; dimensionless, for half the filament and unit width."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from softcat_sym.reference.element import POINTS, Floats
from softcat_sym.reference.element_loop import POINT_STATE, ElementLoop
from softcat_sym.reference.mesh import Strip
from softcat_sym.reference.problem import Problem

# Fields kept, evenly spaced; the last output time is always among them.
_FIELDS = 21
_LATER = ("displacement", "flow")
ENERGIES = ("kinetic", "elastic", "dissipated", "gravity_work", "potential")


class Records:
    """Arrays that fill up as a run goes on.

    Parameters
    ----------
    problem : Problem
        For the number of output times and gravity.
    strip : Strip
        For the number of nodes and points.
    """

    def __init__(self, problem: Problem, strip: Strip) -> None:
        frames = problem.frames
        self.frame_of_field = np.unique(np.linspace(0, frames - 1, min(_FIELDS, frames)).round().astype(int))
        fields = len(self.frame_of_field)
        self.arrays: dict[str, Floats] = {
            "centreline": np.full((frames, len(strip.centreline), 2), np.nan),
            "thinning": np.full(frames, np.nan),
            "clamp_strain_mean": np.full(frames, np.nan),
            "clamp_strain_largest": np.full(frames, np.nan),
            "steps": np.full(frames, np.nan),
            "rate": np.full((fields, len(strip.corner), len(POINTS)), np.nan),
            "displacement": np.full((fields, *strip.position.shape), np.nan),
            "flow": np.full((fields, len(strip.corner), len(POINTS), POINT_STATE), np.nan),
            **{name: np.full(frames, np.nan) for name in ENERGIES},
        }

    def take(self, frame: int, loop: ElementLoop, gravity: float, steps: int) -> None:
        """Keep what the loop holds now.

        Parameters
        ----------
        frame : int
            Number of the output time.
        loop : ElementLoop
            At the end of a stretch of time.
        gravity : float
            rho g L/E at this time.
        steps : int
            Taken since the beginning.
        """
        strip, arrays = loop.strip, self.arrays
        place = strip.position + loop.displacement
        arrays["centreline"][frame] = place[strip.centreline]
        arrays["thinning"][frame] = np.ptp(place[strip.face, 1]) / np.ptp(strip.position[strip.face, 1])
        fibre = np.linalg.norm(loop.deformation()[-strip.mesh.through :, :, :, 0], axis=-1)
        arrays["clamp_strain_mean"][frame] = np.log(fibre).mean()
        arrays["clamp_strain_largest"][frame] = np.log(fibre.max())
        arrays["steps"][frame] = steps
        arrays["kinetic"][frame] = loop.kinetic_energy
        arrays["elastic"][frame] = loop.elastic_energy
        arrays["dissipated"][frame] = loop.plastic_work
        arrays["gravity_work"][frame] = loop.gravity_work
        arrays["potential"][frame] = gravity * (strip.mass @ loop.displacement[:, 1])
        field = np.searchsorted(self.frame_of_field, frame)
        if field < len(self.frame_of_field) and self.frame_of_field[field] == frame:
            arrays["rate"][field] = loop.rate
            arrays["displacement"][field] = loop.displacement
            arrays["flow"][field] = loop.point

    def state(self) -> dict[str, Floats]:
        """The arrays, for a checkpoint."""
        return {f"record_{name}": array for name, array in self.arrays.items()}

    def restore(self, state: Mapping[str, npt.NDArray[np.generic]]) -> None:
        """Take the arrays of a :meth:`state`.

        A checkpoint from before displacements and flow were kept lacks them: those instants stay NaN.
        """
        for name, array in self.arrays.items():
            if name not in _LATER or f"record_{name}" in state:
                array[...] = state[f"record_{name}"]
