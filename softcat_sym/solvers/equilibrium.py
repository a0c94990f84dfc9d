"""Equilibria of a filament, by CasADi: Newton's method, descent to a stable one, and a sequence of them in time."""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import casadi as ca
import numpy as np

from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.unknowns import WORK_OF_AGEING, Floats
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Progress, Solution

_ITERATIONS = 60
_HALVINGS = 30
_TOLERANCE = 1e-10
_ROUNDING = 1e-7
_LONGEST_STEP = 0.1

_POSITIONS = ("x", "y", "z", "psi", "q0", "q1", "q2", "q3")


class Stiffness:
    """A factorised sparse matrix; steps are None if it is singular, as for a straight string without bending."""

    def __init__(self, sparsity: ca.Sparsity) -> None:
        # The name "qr" selects the sparse solver; the default factorisation is a thousand times slower.
        self._solver = ca.Linsol("stiffness", "qr", sparsity)
        self._matrix: ca.DM | None = None

    def factorise(self, matrix: ca.DM) -> Stiffness:
        """Factorise a matrix; if it is singular, the next steps are None."""
        self._matrix = matrix
        try:
            self._solver.sfact(matrix)
            self._solver.nfact(matrix)
        except RuntimeError:
            self._matrix = None
        return self

    def step(self, force: Floats | ca.DM) -> Floats | None:
        """Displacement by a force."""
        if self._matrix is None:
            return None
        try:
            step = np.asarray(self._solver.solve(self._matrix, ca.DM(force))).ravel()
        except RuntimeError:
            return None
        return step if np.all(np.isfinite(step)) else None


class Equilibrium:
    """Newton's method on 0 = alg(t, x, z, p), with a damping that does not depend on the scaling of the equations.

    A step is shortened until the next step with the same stiffness would be the shorter one (Deuflhard, Newton Methods
    for Nonlinear Problems, 2004, section 3.3: natural monotonicity).
    """

    def __init__(self, graph: Graph) -> None:
        # Only positions and angles make the equations nonlinear: steps of velocities are not limited.
        self._shape = np.isin(graph.algebraic.kinds, _POSITIONS)
        self._bends = graph.terms.bending
        # For a linear beam without stretch the first full step gives the solution.
        self._residual, self._jacobian, self._linear = graph.symbolic.balance
        self._stiffness = Stiffness(self._jacobian.sparsity_out(0))

    def search(self, time: float, x: Floats, p: Floats, guesses: Iterable[Floats]) -> Floats | None:
        """Equilibrium reached from the first guess that leads to one; None if none does."""
        return next((z for guess in guesses if (z := self._newton(time, x, guess, p)) is not None), None)

    def _newton(self, time: float, x: Floats, z: Floats, p: Floats) -> Floats | None:
        before = np.inf
        for _ in range(_ITERATIONS):
            self._stiffness.factorise(self._jacobian(time, x, z, p))
            step = self._stiffness.step(-self._evaluate(time, x, z, p))
            if step is None:
                return None
            size = float(np.max(np.abs(step))) / max(1.0, float(np.max(np.abs(z + step), initial=0.0)))
            # Rounding of positions, times the axial over the bending stiffness, limits the accuracy of thin filaments.
            if size < _TOLERANCE or (self._bends and size < _ROUNDING and size > 0.9 * before):
                return z + step
            before = size
            z = z + self._fraction(time, x, z, p, step) * step
        return None

    def _fraction(self, time: float, x: Floats, z: Floats, p: Floats, step: Floats) -> float:
        """Largest tested fraction of the step that shortens the next step; the longest if there is none."""
        if self._linear:
            return 1.0
        size = float(np.linalg.norm(step))
        # A straight string has hardly any stiffness: its first full step would be several spans long.
        reach = float(np.max(np.abs(step[self._shape]), initial=0.0))
        longest = fraction = min(1.0, _LONGEST_STEP / reach) if reach > 0 else 1.0
        for _ in range(_HALVINGS):
            value = self._evaluate(time, x, z + fraction * step, p)
            if np.all(np.isfinite(value)):
                remains = self._stiffness.step(-value)
                if remains is not None and float(np.linalg.norm(remains)) <= (1 - fraction / 4) * size:
                    return fraction
            fraction /= 2
        return longest

    def _evaluate(self, time: float, x: Floats, z: Floats, p: Floats) -> Floats:
        return np.asarray(self._residual(time, x, z, p), dtype=float).ravel()


def newton_of_graph(graph: Graph, x: Floats, p: Floats, guess: Floats) -> Floats | None:
    """Solve as `Newton`, by CasADi."""
    return Equilibrium(graph).search(0.0, x, p, [guess])


_NUDGE = 1e-3  # Perturbation, over the span
_LARGEST = 0.05  # Largest change of a position in one step, over the span
_GROWTH, _SHRINKAGE = 2.0, 0.25
_SETTLED = 1e-11
_SETTLING_ITERATIONS = 400
_SETTLING_ROUNDING = 1e-13


def settled(graph: Graph, x: Floats, p: Floats, z: Floats, straight: Floats) -> Floats:
    """Minimum of the energy reached from a perturbed equilibrium; the equilibrium itself if it is a minimum.

    As a standing arch may be a minimum, too, the shape is first reflected to the lower side, so that the result hangs.

    The steps are linearly implicit along dz/dtau = alg, the forces over the masses: each must lower the energy, so that
    none returns to a saddle.
    """
    slope, nudge = _Slope(graph, x, p), _nudge(graph)

    def turned_over(shape: Floats) -> Floats:
        """The shape on the other side of the line between the supports."""
        return np.where(np.isin(graph.algebraic.kinds, ("y", "psi")), 2 * straight - shape, shape)

    low = slope.descended(min((z, turned_over(z)), key=slope.energy) - nudge)
    # A straight bar may buckle upwards or downwards.
    other = slope.descended(turned_over(low) - nudge)
    return min((low, other), key=slope.energy)


def snapped(graph: Graph, time: float, x: Floats, p: Floats, z: Floats) -> Floats:
    """Minimum of the energy reached from a perturbed shape out of balance, beyond a fold of its equilibria."""
    return _Slope(graph, x, p, time).descended(z - _nudge(graph))


def _nudge(graph: Graph) -> Floats:
    """Downward perturbation, slightly larger on one side."""
    weight, size = np.abs(graph.algebraic.where) / 0.5, np.where(np.isin(graph.algebraic.kinds, "y"), _NUDGE, 0.0)
    return np.asarray(size * (1 - weight**2) * (1 + 0.1 * np.sign(graph.algebraic.where)))


class _Slope:
    """Energy of the filament, and implicit steps along its negative gradient."""

    def __init__(self, graph: Graph, x: Floats, p: Floats, time: float = 0.0) -> None:
        self._x, self._p, self._time, self._observables = x, p, time, graph.symbolic.observables
        pace = ca.SX.sym("pace")
        matrix = ca.SX.eye(len(graph.straight)) / pace - ca.jacobian(graph.symbolic.alg, graph.symbolic.z)
        self._system = ca.Function("system", [*graph.symbolic.inputs, pace], [graph.symbolic.alg, matrix])
        self._stiffness = Stiffness(self._system.sparsity_out(1))

    def energy(self, z: Floats) -> float:
        """Stored energy per undeformed area."""
        observed = self._observables(time=self._time, state=self._x, algebraic=z, parameters=self._p)
        names = (name for name in observed if name.startswith("energy_") and name != "energy_kinetic")
        return sum(float(observed[name]) for name in names)

    def descended(self, start: Floats) -> Floats:
        """Minimum of the energy reached from a shape.

        The first step is as short as that of an explicit method: stiff modes come to rest before the steps become long
        enough to end on a saddle.
        """
        _, matrix = self._system(self._time, self._x, start, self._p, 1.0)
        pace = 1 / float(np.max(np.abs(np.diag(np.asarray(matrix)))))
        best, lowest = start, self.energy(start)
        for _ in range(_SETTLING_ITERATIONS):
            force, matrix = self._system(self._time, self._x, best, self._p, pace)
            step = self._stiffness.factorise(matrix).step(force)
            if step is None:
                pace *= _SHRINKAGE
                continue
            size = float(np.max(np.abs(step)))
            if size < _SETTLED and pace > 1:
                return best + step
            energy = self.energy(best + step)
            if size > _LARGEST or not energy <= lowest + _SETTLING_ROUNDING * abs(lowest):
                pace *= _SHRINKAGE
                continue
            best, lowest, pace = best + step, energy, pace * _GROWTH
        return best


# Gauss points between two frames for the power, which may jump at a frame, where a load or a support changes its rate.
_GAUSS = (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5)

_MIN_STEP = 1 / 1024  # Over the time from one instant to the next
_GROWTH = 1.5


def march(graph: Graph, z0: Floats, p: Floats, times: Floats, scale: float, progress: Progress) -> Solution:
    """Equilibrium at each output time, each found from the one before.

    Parameters
    ----------
    graph : Graph
        Without differential states.
    z0 : ndarray, shape (nz,)
        Equilibrium at the first time.
    p : ndarray
        Parameters.
    times : ndarray, shape (frames,)
        In units of the time scale.
    scale : float
        Time scale [s].
    progress : Progress
        Called after every frame.
    """
    path = _Path(graph, p, float(times[0]), z0)
    power = ca.Function("power", graph.symbolic.inputs, [graph.symbolic.quad])
    shapes, outcome, message = [z0], Outcome.solved, ""
    # External work: by the load, and by a material that shrinks.
    works = np.array([name in ("load", WORK_OF_AGEING) for name in graph.powers])
    work = [np.zeros(len(works))]
    stopped = False
    try:
        for before, time in itertools.pairwise(times.tolist()):
            instants = [before + share * (time - before) for share in (*_GAUSS, 1.0)]
            passed: list[Floats] = []
            while len(passed) < len(instants) and (z := path.to(instants[len(passed)])) is not None:
                passed.append(z)
            if len(passed) < len(instants):
                outcome = Outcome.no_equilibrium
                message = f"no equilibrium at t = {instants[len(passed)] * scale:.6g} s"
                break
            powers = [power(instant, [], z, p) for instant, z in zip(instants[:-1], passed[:-1], strict=True)]
            done = sum(np.where(works, np.asarray(found, dtype=float).ravel(), 0.0) for found in powers)
            work.append(work[-1] + (time - before) * done / len(_GAUSS))
            shapes.append(path.last)
            progress.update(time * scale, None)
    except KeyboardInterrupt:
        stopped = True
    frames = len(shapes)
    x, z, quad = np.zeros((0, frames)), np.array(shapes).T, np.array(work[:frames]).T
    found = Solution(times[:frames], x, z, quad, outcome, message, frames - 1)
    if stopped:
        raise found.interrupted(scale)
    return found


class _Path:
    """A sequence of equilibria, with smaller steps than requested if a support moves far."""

    def __init__(self, graph: Graph, p: Floats, time: float, z: Floats) -> None:
        self._graph, self._p, self._equilibrium = graph, p, Equilibrium(graph)
        self._known = [(time, z)]
        self._step = np.inf

    @property
    def last(self) -> Floats:
        """The last equilibrium."""
        return self._known[-1][1]

    def to(self, until: float) -> Floats | None:
        """Equilibrium at a later time; None if there is none.

        If even the smallest step fails, the branch has ended: a filament with bending snaps to a lower equilibrium.
        """
        whole = until - self._known[-1][0]
        falls = self._graph.terms.bending and self._graph.conserves_energy
        while (left := until - self._known[-1][0]) > 0:
            step = min(left, self._step)
            at = until if step == left else self._known[-1][0] + step
            further = self._search(at, self._guess(at))
            if further is None and step > _MIN_STEP * whole:
                self._step = step / 2
                continue
            if further is None and falls:
                further = self._search(at, snapped(self._graph, at, np.zeros(0), self._p, self.last))
            if further is None:
                return None
            self._known = [self._known[-1], (at, further)]
            self._step *= _GROWTH
        return self.last

    def _search(self, at: float, guess: Floats) -> Floats | None:
        return self._equilibrium.search(at, np.zeros(0), self._p, [guess])

    def _guess(self, at: float) -> Floats:
        """Initial guess: the last equilibrium, or with reduced steps an extrapolation."""
        last, z = self._known[-1]
        if not np.isfinite(self._step) or len(self._known) < 2:
            return z
        first, before = self._known[0]
        return np.asarray(z + (at - last) / (last - first) * (z - before))
