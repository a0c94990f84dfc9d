"""The end of a long undamped ringing, by the modes of vibration about equilibrium.

Where nothing flows any more, plastic strains are constant and the filament is conservative: v' = f(q, a), 0 = g(q, a)
for positions q with q' = v and turns a without inertia. About the equilibrium q* the modes X of -df/dq, with turns
eliminated, have frequencies w_k, and in modal coordinates eta = X^-1 (q - q*) linear theory is a cosine for each.
A finite amplitude a of the loudest mode, over the thickness h, shifts means, adds harmonics and moves the frequency,
all of order (a/h)^2, so that over a window of the integrated run

    eta_k(T) = c_k0 + sum_{h=1..3} Re(c_kh exp(i h W T)) + Re(d_k exp(i w_k T))

is fitted by least squares to displacements, weighted by w_k, and velocities, with W common to all modes. It is then
evaluated to the end of the run; stress and energy follow from q, not from linear theory.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.sites import Sites
from softcat_sym.discretization.unknowns import PLACES, Floats, Numbers, Slot
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.solution import Extremes, Interrupted, Solution, Start

Complex = npt.NDArray[np.complex128]

SAMPLES = 32
"""Of a window in each period: the loudest mode's third harmonic has ten."""

WINDOW, LONGEST_WINDOW, GROWTH, FIRST_WINDOWS = 5.0, 40.0, 1.5, 3
"""Periods of a window: of each of the first ones, at most, and by what the later ones grow."""

LEAST_LEFT = 20.0
"""Periods that a tail has to spare: a refusal costs as much as one or two of them."""

MAX_REFUSALS = 2
"""Windows whose motion the modes do not describe: an amplitude that does not decay fits no better later on."""

_HARMONICS = 3
_SEARCHED = np.linspace(0.92, 1.2, 29)
"""Frequency of the loudest mode over that of linear theory."""

_QUIET = 1e-9
"""Energy of a mode over that of the loudest one below which it is left out."""

_FIT, _FIT_OF_ENERGY = 0.13, 7e-4
"""Largest residual of the fit in any place, relative to the largest displacement: over the accuracy, so that the error
it adds is a fifth of it; and at all, since the energy of a tail errs by some six hundred times its square, of which a
thousandth is refused."""

_FLOWN, _TO_FLOW = 0.02, 0.1
"""Largest plastic strain of the window, and of the tail as foretold, over the yield strain."""

_GLANCE, _LOOK = 128, 1024
"""Instants of the tail at which flow is looked for: few first, since most refusals show there."""

FIT_ERROR, FLOW_ERROR = 1.5, 6e-3
"""Error of a tail over the residual of its fit, and over the plastic strain foretold in yield strains.

Means and amplitudes of five strands that had flowed before (ink, chocolate, gels) differ from those of integrated runs
by 0.9 to 1.9 residuals; those of strands that never flow by much less.
"""

_NEWTON, _CONVERGED = 12, 1e-11
_KEPT_PERIODS = 1000.0
"""From the beginning and from the end of a tail, in which turning points are looked for."""

_BLOCK = 256


@dataclass(frozen=True)
class Conditions:
    """When a run may end by its modes, in units of the time scale."""

    period: float  # Of the first mode, as foreseen
    begin: float  # Time from which neither load nor supports change
    accuracy: float
    yield_strain: float  # Infinite without a yield stress

    def windows(self, end: float) -> Iterator[tuple[float, float]]:
        """Windows of a run, one behind the other, that leave enough of it."""
        begin, length, number = self.begin, WINDOW * self.period, 0
        while begin + length + LEAST_LEFT * self.period < end:
            yield begin, begin + length
            begin, number = begin + length, number + 1
            if number >= FIRST_WINDOWS:
                length = min(GROWTH * length, LONGEST_WINDOW * self.period)


class FilamentRates(Protocol):
    """Right-hand side of a filament at one instant of a time at which nothing changes by itself."""

    def rates(self, states: Floats) -> Floats:
        """Rates of states (frames, sites * slots), in the same shape."""
        ...

    def powers(self, states: Floats) -> Floats:
        """Powers that are integrated beside the unknowns, shape (powers, frames)."""
        ...

    def jacobian(self, state: Floats, of: Numbers) -> Floats:
        """Derivatives of the rates of some unknowns, none of them plastic, by these unknowns."""
        ...


@dataclass(frozen=True)
class Partition:
    """Which unknowns are positions, their velocities, algebraic turns and plastic strains: flat indices of a state."""

    q: Numbers
    v: Numbers
    a: Numbers
    plastic: Numbers
    places: Numbers  # Of `q`, those that are coordinates of nodes

    @classmethod
    def of(cls, slots: Sequence[Slot], sites: Sites) -> Partition | None:
        """Those of a model; None if some unknown is none of these."""
        number = {slot.name: k for k, slot in enumerate(slots)}
        unknown, speeds = np.append(sites.x, sites.z), {slot.rate for slot in slots if slot.rate}
        which = unknown % len(slots)

        def those(names: Sequence[str]) -> Numbers:
            return np.asarray(unknown[np.isin(which, [number[name] for name in names])])

        moving = [slot.name for slot in slots if slot.rate]
        still = [slot.name for slot in slots if not slot.differential]
        frozen = [slot.name for slot in slots if slot.section]
        others = {slot.name for slot in slots} - {*moving, *speeds, *still, *frozen}
        if others or speeds & {*still}:
            return None
        q = those(moving)
        v = q - q % len(slots) + np.array([number[slots[k].rate] for k in q % len(slots)], dtype=np.int64)
        places = np.flatnonzero(np.isin(q % len(slots), [number[name] for name in PLACES if name in number]))
        return cls(q, v, those(still), those(frozen), places) if np.isin(v, unknown).all() else None


@dataclass(frozen=True)
class Modes:
    """Modes of vibration about an equilibrium at the present plastic strains."""

    rest: Floats  # State in equilibrium
    frequencies: Floats  # (modes,)
    shapes: Floats  # X, (q, modes)
    coordinates: Floats  # Its inverse
    turns: Floats  # da/dq of what is algebraic, (a, q)

    @classmethod
    def of(cls, rates: FilamentRates, at: Partition, state: Floats) -> Modes | None:
        """Newton's method from a state nearby, then eigenvectors; None without a stable equilibrium or with damping."""
        rest, free, forces = state.copy(), np.append(at.q, at.a), np.append(at.v, at.a)
        rest[at.v] = 0.0
        every, scale = np.concatenate([at.q, at.v, at.a]), float(np.max(np.abs(state[at.q])))
        q, v, a = (slice(0, len(at.q)), slice(len(at.q), 2 * len(at.q)), slice(2 * len(at.q), None))
        with np.errstate(all="ignore"):
            for _ in range(_NEWTON):
                slopes = rates.jacobian(rest, every)
                if np.any(slopes[v, v]) or np.any(slopes[a, v]):
                    return None
                by_free = np.hstack([slopes[:, q], slopes[:, a]])
                matrix = np.vstack([by_free[v], by_free[a]])
                try:
                    step = np.linalg.solve(matrix, rates.rates(rest[None])[0, forces])
                except np.linalg.LinAlgError:
                    return None
                rest[free] -= step
                scale = max(scale, float(np.max(np.abs(rest[at.q]))))
                if not np.max(np.abs(step)) > _CONVERGED * scale:
                    break
            else:
                return None
            if not np.isfinite(rest).all():
                return None
            turns = -np.linalg.solve(slopes[a, a], slopes[a, q]) if len(at.a) else np.zeros((0, len(at.q)))
            squares, shapes = np.linalg.eig(-(slopes[v, q] + slopes[v, a] @ turns))
        if np.iscomplexobj(squares) or not np.all(squares > 0):
            return None
        order = np.argsort(squares)
        shapes = np.asarray(shapes[:, order], dtype=float)
        return cls(rest, np.sqrt(squares[order]), shapes, np.linalg.inv(shapes), np.asarray(turns, dtype=float))


@dataclass(frozen=True)
class ModalTail:
    """A state as a sum of oscillations: y(t) = rest + Re(sum_m amplitudes_m exp(i frequencies_m (t - begin)))."""

    begin: float
    rest: Floats  # (unknowns,)
    frequencies: Floats  # (terms,); the first is 0
    amplitudes: Complex  # (unknowns, terms)
    residual: float  # Of the fit, in any place, relative to the largest displacement
    flow: float = 0.0  # Plastic strain foretold, over the yield strain

    @property
    def error(self) -> float:
        """Error of the height or the amplitude, relative to the largest displacement."""
        return FIT_ERROR * self.residual + FLOW_ERROR * self.flow

    def states(self, times: Floats) -> Floats:
        """States at any times, shape (times, unknowns)."""
        waves = np.exp(1j * np.outer(times - self.begin, self.frequencies))
        return np.asarray(self.rest + (waves @ self.amplitudes.T).real)

    def path(self, unknown: int, first: float, step: float, count: int, derivative: int = 0) -> Floats:
        """One unknown, or its derivative of some order, at evenly spaced times."""
        terms, turned = self.amplitudes[unknown] * (1j * self.frequencies) ** derivative, 1j * self.frequencies
        starts = first - self.begin + step * _BLOCK * np.arange(-(-count // _BLOCK))
        blocks = terms * np.exp(np.outer(starts, turned))
        values = (blocks @ np.exp(np.outer(turned, step * np.arange(_BLOCK)))).real.ravel()[:count]
        return np.asarray(values + (self.rest[unknown] if derivative == 0 else 0.0))

    def extremes(self, unknown: int, end: float) -> Extremes:
        """Turning points of an unknown up to the end; its integral counts from the beginning."""
        period = 2 * np.pi / self.frequencies[1]
        spans, kept = [(self.begin, end)], _KEPT_PERIODS * period
        if end - self.begin > 2 * kept:
            spans = [(self.begin, self.begin + kept), (end - kept, end)]
        turns = [np.array([self.begin])]
        for first, last in spans:
            count = math.ceil((last - first) / period * SAMPLES) + 1
            step = (last - first) / (count - 1)
            speed = self.path(unknown, first, step, count, 1)
            here = np.flatnonzero(speed[1:] * speed[:-1] < 0)
            turns.append(first + step * (here + speed[here] / (speed[here] - speed[here + 1])))
        times = np.concatenate([*turns, [end]])
        terms, turned, rest = self.amplitudes[unknown], 1j * self.frequencies, self.rest[unknown]
        constant = rest + terms[0].real
        after = times - self.begin
        waves = np.exp(np.outer(after, turned[1:]))
        integrals = terms[1:] / turned[1:]
        area = constant * after + ((waves - 1) @ integrals).real
        return Extremes(times, constant + (waves @ terms[1:]).real, np.asarray(area))


def tail_of(at: Partition, modes: Modes, times: Floats, states: Floats, start: Floats) -> ModalTail:
    """Fit the modes to states (times, unknowns) of a window; `start` is the state from which displacements count."""
    after = times - times[-1]
    q, v = ((states[:, part] - modes.rest[part]) @ modes.coordinates.T for part in (at.q, at.v))
    energy = np.max(v**2 + (modes.frequencies * q) ** 2, axis=0)
    loudest = int(np.argmax(energy))
    heard = np.flatnonzero(energy > _QUIET * energy[loudest])
    others = heard[heard != loudest]
    own = _frequency(after, q[:, loudest], v[:, loudest], float(modes.frequencies[loudest]))
    common = own * np.arange(_HARMONICS + 1)
    frequencies = np.append(common, modes.frequencies[others])
    found = np.zeros((len(modes.frequencies), len(frequencies)), dtype=complex)
    terms = np.arange(len(common))
    for k, own_terms in ((loudest, terms), *((k, np.append(terms, len(terms) + n)) for n, k in enumerate(others))):
        weight = float(modes.frequencies[k])
        found[k, own_terms] = _fitted(after, q[:, k], v[:, k], frequencies[own_terms], weight)[0]
    amplitudes = np.zeros((states.shape[1], len(frequencies)), dtype=complex)
    amplitudes[at.q] = modes.shapes @ found
    amplitudes[at.v] = 1j * frequencies * amplitudes[at.q]
    amplitudes[at.a] = modes.turns @ amplitudes[at.q]
    rest = modes.rest.copy()
    tail = ModalTail(float(times[-1]), rest, frequencies, amplitudes, 0.0)
    places = at.q[at.places]
    moved = float(np.max(np.abs(states[:, places] - start[places])))
    residual = float(np.max(np.abs(tail.states(times)[:, places] - states[:, places]))) / (moved or 1.0)
    return ModalTail(tail.begin, rest, frequencies, amplitudes, residual)


def _fitted(
    after: Floats, q: Floats, v: Floats, frequencies: npt.NDArray[Any], weight: float, more: Sequence[Floats] = ()
) -> tuple[Complex, Floats]:
    """Complex amplitudes of some frequencies, and coefficients of other columns, by least squares; and what is left."""
    turn = np.outer(after, frequencies)
    cosine, sine = np.cos(turn), np.sin(turn)
    displaced = np.hstack([cosine, -sine])
    moving = np.hstack([-frequencies * sine, -frequencies * cosine])
    matrix = np.column_stack([np.vstack([weight * displaced, moving]), *more])
    found = np.linalg.lstsq(matrix, np.append(weight * q, v), rcond=1e-10)[0]
    count = len(frequencies)
    return found[:count] + 1j * found[count : 2 * count], found[2 * count :]


def _frequency(after: Floats, q: Floats, v: Floats, linear: float) -> float:
    """Frequency of the loudest mode: the best of a grid, then Gauss and Newton's method."""
    numbers = np.arange(_HARMONICS + 1)

    def left(frequency: float) -> float:
        terms = _fitted(after, q, v, frequency * numbers, linear)[0]
        waves = np.exp(1j * frequency * np.outer(after, numbers))
        apart = (linear * ((waves @ terms).real - q), (waves @ (1j * frequency * numbers * terms)).real - v)
        return float(np.sum(np.square(apart)))

    found = linear * float(min(_SEARCHED, key=lambda share: left(linear * share)))
    for _ in range(_NEWTON):
        terms = _fitted(after, q, v, found * numbers, linear)[0]
        waves = np.exp(1j * found * np.outer(after, numbers)) * terms
        turned = (waves @ (1j * numbers)) * after, waves @ (1j * numbers) - after * found * (waves @ numbers**2)
        slope = np.append(linear * turned[0].real, turned[1].real)
        step = float(_fitted(after, q, v, found * numbers, linear, [slope])[1][0])
        found += min(max(step, -0.01 * linear), 0.01 * linear)
        if abs(step) < 1e-12 * linear:
            break
    return found


def foretold_flow(conditions: Conditions, rates: FilamentRates, at: Partition, tail: ModalTail, end: float) -> float:
    """Plastic strain of the tail of the fibre that flows most, over the yield strain; more than allowed if it is."""
    if not len(at.plastic):
        return 0.0
    flow = 0.0
    for count in (_GLANCE, _LOOK):
        # Shares of the golden section are at all phases of all modes.
        share = np.arange(count) * ((math.sqrt(5) - 1) / 2) % 1.0
        states = tail.states(np.asarray(tail.begin + share * (end - tail.begin), dtype=float))
        rate = np.mean(np.abs(rates.rates(states)[:, at.plastic]), axis=0)
        flow = float(np.max(rate)) * (end - tail.begin) / conditions.yield_strain
        if flow > _TO_FLOW:
            break
    return flow


@dataclass(frozen=True)
class ModalFrames:
    """Frames of a solution behind the last that was integrated, computed when they are asked for."""

    tail: ModalTail
    pieces: Pieces  # What was integrated
    rates: FilamentRates
    partition: Partition

    @cached_property
    def times(self) -> Floats:
        """Times of the frames, evenly spaced."""
        frames = self.pieces.frames
        return frames[frames > self.tail.begin]

    def row(self, number: int) -> Floats:
        """One unknown in all these frames, differential ones first."""
        first, step = self.times[0], self.pieces.frames[1] - self.pieces.frames[0]
        unknown = int(np.append(self.pieces.sites.x, self.pieces.sites.z)[number])
        return self.tail.path(unknown, float(first), float(step), len(self.times))

    def at(self, frames: Numbers) -> tuple[Floats, Floats, Floats]:
        """Unknowns and quadratures of some of these frames, in columns."""
        states, begun = self.tail.states(self.times[frames]), self.tail.states(np.array([self.tail.begin]))
        work, sites = self._work(np.vstack([begun, states])), self.pieces.sites
        quad = self.pieces.quad[:, None] + np.zeros(len(frames))
        quad[1:] += work[1:, 1:] - work[1:, :1]  # The first, plastic, does nothing any more
        return *sites.vectors(states.reshape(-1, *sites.shape)), quad

    def _work(self, states: Floats) -> Floats:
        """Work on a straight way from rest, at unit speed, by two points of Gauss."""
        away, total = states - self.tail.rest, np.zeros((len(self.pieces.quad), len(states)))
        for share in (0.5 - math.sqrt(1 / 12), 0.5 + math.sqrt(1 / 12)):
            there = self.tail.rest + share * away
            there[:, self.partition.v] = away[:, self.partition.q]
            powers = self.rates.powers(there)
            total[: len(powers)] += powers / 2
        return total


@dataclass
class Pieces:
    """A run that is integrated piece by piece."""

    integrate: Callable[[Start, Floats], Solution]  # From a state through some times
    sites: Sites
    frames: Floats
    here: Start
    done: list[Solution] = field(default_factory=list)

    @property
    def reached(self) -> float:
        """Time up to which it is integrated."""
        return float(self.done[-1].time[-1] if self.done else self.frames[0])

    @property
    def goes_on(self) -> bool:
        """Whether there is anything left to integrate."""
        stopped = self.done and (self.done[-1].outcome is not Outcome.solved or self.done[-1].ended is not None)
        return not stopped and self.reached < self.frames[-1]

    def go_to(self, time: float, samples: int = 1) -> tuple[Floats, Floats]:
        """Integrate to a time; times and states of evenly spaced samples on the way, whatever the frames are."""
        if not self.goes_on or time <= self.reached:
            return np.zeros(0), np.zeros(0)
        inside = self.frames[(self.frames > self.reached) & (self.frames <= time)]
        sampled = np.linspace(self.reached, time, samples + 1)
        try:
            self.done.append(self.integrate(self.here, np.union1d(sampled, inside)))
        except Interrupted as stopped:
            self.done.append(stopped.part())
            raise Interrupted(self.joined) from None
        times, x, z = self.done[-1].time, self.done[-1].x, self.done[-1].z
        self.here, kept = Start(x[:, -1], z[:, -1]), np.isin(times, sampled)
        return times[kept], self.sites.states(x[:, kept], z[:, kept]).reshape(np.count_nonzero(kept), -1)

    @property
    def quad(self) -> Floats:
        """Quadratures up to the time reached."""
        return np.asarray(np.sum([part.quad[:, -1] for part in self.done], axis=0))

    def joined(self) -> Solution:
        """The pieces one behind the other, with those of their times that are frames, and all their turning points."""
        parts, quad, extremes = list[Solution](), np.zeros(len(self.done[0].quad)), self.done[0].extremes
        for part in self.done:
            kept = np.flatnonzero(np.isin(part.time, self.frames) & ((np.arange(len(part.time)) > 0) | (not parts)))
            parts.append(replace(part.only(kept.tolist()), quad=part.quad[:, kept] + quad[:, None]))
            quad = quad + part.quad[:, -1]
            if part is not self.done[0] and extremes is not None and part.extremes is not None:
                extremes = extremes.followed_by(part.extremes)
        return replace(Solution.joined(parts), extremes=extremes)


def solved_with_tail(
    conditions: Conditions, rates: FilamentRates, at: Partition, pieces: Pieces, midpoint: int
) -> Solution:
    """Integrate until the modes carry a run to its end, or all of it; `midpoint` is a row, differential ones first."""
    end, sites, refusals = float(pieces.frames[-1]), pieces.sites, 0
    start, fits = (
        sites.state(pieces.here.x, pieces.here.z).ravel(),
        min(_FIT * conditions.accuracy, _FIT_OF_ENERGY),
    )
    for begin, stop in conditions.windows(end):
        pieces.go_to(begin)
        times, states = pieces.go_to(stop, SAMPLES * round((stop - begin) / conditions.period))
        if not pieces.goes_on:
            break
        if np.any(np.ptp(states[:, at.plastic], axis=0) > _FLOWN * conditions.yield_strain):
            continue
        near = states[-1].copy()
        for part in (at.q, at.a):
            near[part] = np.mean(states[:, part], axis=0)
        modes = Modes.of(rates, at, near)
        tail = None if modes is None else tail_of(at, modes, times, states, start)
        if tail is None or tail.residual > fits:
            refusals += 1
            if refusals == MAX_REFUSALS:
                break
            continue
        tail = replace(tail, flow=foretold_flow(conditions, rates, at, tail, end))
        if tail.flow <= _TO_FLOW:
            return _ended(pieces, tail, ModalFrames(tail, pieces, rates, at), midpoint)
    pieces.go_to(end)
    return pieces.joined()


def _ended(pieces: Pieces, tail: ModalTail, later: ModalFrames, midpoint: int) -> Solution:
    head, sites, frames = pieces.joined(), pieces.sites, pieces.frames
    turns = tail.extremes(int(np.append(sites.x, sites.z)[midpoint]), float(frames[-1]))
    extremes = None if head.extremes is None else head.extremes.followed_by(turns)
    error = tail.error
    return replace(head, time=frames, extremes=extremes, later=later, tail_from=tail.begin, tail_error=error)
