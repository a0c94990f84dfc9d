"""Random and physical chains for linear.c: f = J y - cubic y^3 with any pattern of J."""

from __future__ import annotations

import ctypes as c
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tests.codegen.rosenbrock_library import Model, Problem, ints, library

Pattern = Sequence[tuple[int, int, int]]

_FUNCTIONS = "rates", "jacobian", "work", "work_slope"


@dataclass(frozen=True)
class Chain:
    """A linear chain."""

    sites: int
    sections: int
    rate: list[int]
    differential: list[int]
    held_first: list[int]
    held_last: list[int]
    pattern: Pattern
    entries: np.ndarray
    cubic: float = 0.0

    @property
    def slots(self) -> int:
        """Unknowns of a site."""
        return len(self.rate)

    @property
    def free(self) -> np.ndarray:
        """Which unknowns are not held, shape (sites * slots,)."""
        free = np.ones((self.sites, self.slots), dtype=bool)
        free[0] &= ~np.array(self.held_first, dtype=bool)
        free[-1] &= ~np.array(self.held_last, dtype=bool)
        return free.ravel()

    @property
    def mass(self) -> np.ndarray:
        """Diagonal of M, shape (sites * slots,)."""
        return np.tile(np.array(self.differential, dtype=float), self.sites)

    def problem(self) -> Problem:
        """As the integrator is given it."""
        row, offset, column = (list(numbers) for numbers in zip(*self.pattern, strict=True))
        functions = [c.cast(getattr(library(), f"linear_{name}"), c.c_void_p) for name in _FUNCTIONS]
        per_slot = (self.rate, self.differential, self.held_first, self.held_last)
        lists = [ints(numbers) for numbers in (*per_slot, row, offset, column)]
        count = len(self.pattern)
        numbers = (self.slots, self.sections, 3 + 3 * count, count, 0, count, 2, 0)
        model = Model(*numbers, *lists, *(function.value for function in functions))
        return Problem(model, self.sites, [self.slots, count, self.cubic, *row, *offset, *column], self.entries)

    def jacobian(self, *, with_held: bool = False) -> np.ndarray:
        """Dense J, without rows (and columns, unless asked for) of held unknowns."""
        size = self.sites * self.slots
        dense = np.zeros((size, size))
        for site in range(self.sites):
            for (row, offset, column), value in zip(self.pattern, self.entries[site], strict=True):
                if 0 <= site + offset < self.sites:
                    dense[site * self.slots + row, (site + offset) * self.slots + column] += value
        dense[~self.free] = 0.0
        if not with_held:
            dense[:, ~self.free] = 0.0
        return dense


def random_chain(random: np.random.Generator) -> Chain:
    """Any number of sites, unknowns, rates, section states, held ends and entries of reach 2, diagonally heavy."""
    sites, kept, sections = (int(random.integers(*bounds)) for bounds in ((1, 9), (1, 7), (0, 6)))
    slots, half = kept + sections, kept // 2
    rate, differential = [-1] * slots, [1] * slots
    for slot in range(half):
        if random.random() < 0.7:
            rate[slot] = int(random.integers(half, kept))
    for slot in range(half, slots):
        differential[slot] = int(random.random() < 0.7)
    pattern = sorted(_entries(random, rate, kept, sections))
    entries = random.normal(size=(sites, len(pattern)))
    for place, (row, offset, column) in enumerate(pattern):
        if rate[row] >= 0:
            entries[:, place] = 1.0
        elif row == column and offset == 0:
            entries[:, place] -= 3.0
    held = [[int(random.random() < 0.3) for _ in range(slots)] for _ in range(2)]
    return Chain(sites, sections, rate, differential, *held, pattern, entries)


def _entries(random: np.random.Generator, rate: list[int], kept: int, sections: int) -> set[tuple[int, int, int]]:
    found = set()
    for row, its_rate in enumerate(rate):
        if its_rate >= 0:
            found.add((row, 0, its_rate))
            continue
        found.add((row, 0, row))
        for _ in range(6):
            at_section = sections > 0 and random.random() < 0.5
            reach = {(True, True): (-1, 2), (True, False): (-2, 3), (False, True): (0, 1), (False, False): (0, 2)}
            columns = (kept, kept + sections) if at_section else (0, kept)
            found.add((row, int(random.integers(*reach[row < kept, at_section])), int(random.integers(*columns))))
    return found


def masses_on_relaxing_springs(sites: int) -> Chain:
    """x' = u, u' = p - p(left), 0 = x(right) - x - p / 50 - (sum of s) / 9, s' = p - (3 + k) s, in pairs: reach 1, the
    last site has no spring, the first mass is held. Slots x, u, p, then four section states.
    """
    pattern, values = (
        [(0, 0, 1), (1, 0, 2), (1, -1, 2), (2, 1, 0), (2, 0, 0), (2, 0, 2)],
        [1.0, 80.0, -80.0, 1, -1, -0.02],
    )
    for s in range(4):
        pattern += [(2, 0, 3 + s), (3 + s, 0, 2), (3 + s, 0, 3 + s), (3 + s, 0, 3 + (s ^ 1))]
        values += [-1.0 / 9.0, 1.0, -3.0 - s, 0.5]
    last = [0, 0, 1, 1, 1, 1, 1]
    entries = np.tile(values, (sites, 1))
    return Chain(sites, 4, [1] + [-1] * 6, [1, 1, 0, 1, 1, 1, 1], [1, 1, 0, 0, 0, 0, 0], last, pattern, entries)


def beam(sites: int) -> Chain:
    """w' = v, v' = -D2 (D2 w) - v / 2: reach 2, both ends clamped by held values."""
    pattern = [(0, 0, 1), (1, 0, 1), *((1, offset, 0) for offset in range(-2, 3))]
    values = [1.0, -0.5, -1.0, 4.0, -6.0, 4.0, -1.0]
    return Chain(sites, 0, [1, -1], [1, 1], [1, 1], [1, 1], pattern, np.tile(values, (sites, 1)))


def reduced(chain: Chain) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """y' = A y for the differential free unknowns, and all unknowns = B y: (A, B, which)."""
    jacobian, differential = chain.jacobian(with_held=True), chain.free & (chain.mass == 1.0)
    algebraic = chain.free & (chain.mass == 0.0)
    everything = np.zeros((chain.free.size, differential.sum()))
    everything[np.flatnonzero(differential), np.arange(differential.sum())] = 1.0
    inner = jacobian[np.ix_(algebraic, algebraic)]
    everything[algebraic] = -np.linalg.solve(inner, jacobian[np.ix_(algebraic, differential)])
    return jacobian[differential] @ everything, everything, differential
