"""A run of the elements: stretches of time with a stable step each, output times, the energy audit, where it stands."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from softcat_sym.errors import SoftcatError
from softcat_sym.reference.element import largest_frequency
from softcat_sym.reference.element_loop import ElementLoop
from softcat_sym.reference.problem import Problem
from softcat_sym.reference.records import Records

# Step over the largest stable one, 2/omega: the rest is for stiffening until the step is chosen anew.
SAFETY = 0.9

# The step is chosen anew at least this often, in L sqrt(rho/E): an elastic wave has crossed the span once.
_STRETCH = 1.0

# Element steps between two looks at the clock and the keyboard: about a tenth of a second.
_CHUNK = 200_000

# A run whose energies do not add up to this, relative to the work of gravity, is not an answer. A sound one is at 1e-5.
_UNBALANCED = 1e-3


class March:
    """Marches an element loop through the output times of a problem.

    Parameters
    ----------
    problem : Problem
        What is solved.
    loop : ElementLoop
        At rest and unstrained.
    step_factor : float
        Step over the stable one that is taken by itself.
    """

    def __init__(self, problem: Problem, loop: ElementLoop, step_factor: float) -> None:
        self._problem, self._loop, self._factor = problem, loop, step_factor
        interval = problem.duration / (problem.frames - 1)
        self._per_frame = math.ceil(interval / _STRETCH)
        self._length = interval / self._per_frame
        self._stretches = 0
        self._steps = 0
        self._work = 0.0
        self.records = Records(problem, loop.strip)
        self._begin()
        loop.evaluate(loop.step, 0.0)
        self.records.take(0, loop, loop.gravity(0.0), 0)

    @property
    def finished(self) -> bool:
        """Whether the last output time is reached."""
        return self._stretches == self._per_frame * (self._problem.frames - 1)

    @property
    def time(self) -> float:
        """Time reached, in L sqrt(rho/E)."""
        return self._loop.time

    @property
    def step(self) -> float:
        """Length of the steps now, in L sqrt(rho/E)."""
        return self._loop.step

    def advance(self) -> None:
        """Take some steps, up to the end of this stretch of time.

        Raises
        ------
        SoftcatError
            If a material point fails or the energies do not add up.
        """
        loop = self._loop
        loop.march(loop.taken + max(1, _CHUNK // len(loop.strip.corner)))
        if loop.taken < loop.steps:
            return
        self._steps += loop.steps
        self._stretches += 1
        self._audit()
        if self._stretches % self._per_frame == 0:
            self.records.take(self._stretches // self._per_frame, loop, loop.gravity(loop.time), self._steps)
        if not self.finished:
            self._begin()

    def state(self) -> dict[str, npt.NDArray[np.generic]]:
        """All that is needed to go on."""
        progress = {
            "stretches": np.array(self._stretches),
            "total": np.array(self._steps),
            "work": np.array(self._work),
        }
        return {**self._loop.state(), **self.records.state(), **progress}

    def restore(self, state: Mapping[str, npt.NDArray[np.generic]]) -> None:
        """Go back to a :meth:`state` of the same problem, loop and step factor."""
        self._loop.restore(state)
        self.records.restore(state)
        self._stretches, self._steps = int(state["stretches"].item()), int(state["total"].item())
        self._work = float(state["work"].item())

    def _begin(self) -> None:
        loop = self._loop
        frequency = largest_frequency(loop.strip.size, self._problem.poisson, loop.deformation())
        steps = math.ceil(self._length * frequency / (2 * SAFETY * self._factor))
        loop.begin(self._stretches * self._length, self._length / steps, steps)

    def _audit(self) -> None:
        """Refuse a state whose energies do not add up: steps too long for what the strip has become."""
        loop = self._loop
        residual = loop.kinetic_energy + loop.elastic_energy + loop.plastic_work - loop.gravity_work
        self._work = max(self._work, abs(loop.gravity_work))
        # Written so that NaN is refused too.
        if not abs(residual) <= _UNBALANCED * self._work:
            raise SoftcatError(
                f"finite elements: at t = {loop.time:.6g} L sqrt(rho/E) the energies miss the work of gravity by "
                f"{abs(residual) / self._work if self._work else math.inf:.2g} of it; shorten the steps "
                "(step_factor below 1) or refine the mesh where it is stretched most"
            )
