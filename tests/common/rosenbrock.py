"""The C runtime with the test problems as a library, called through ctypes; random and physical chains for it."""

from __future__ import annotations

import ctypes as c
import functools
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import softcat_sym.codegen
from softcat_sym.codegen.library import compile_library, load
from softcat_sym.solvers.compiled import CDirections, CTurns, FilamentStruct, Integers, Options, Status, Workspace

RUNTIME = Path(softcat_sym.codegen.__file__).parent / "runtime"
PROBLEMS = Path(__file__).parent / "problems"
STRICT = ("-O2", "-Wall", "-Wextra", "-Werror", "-pedantic")

RODAS5P, RODAS4, RODAS3P = range(1, 4)
METHODS = (RODAS5P, RODAS4, RODAS3P)


class Model(c.Structure):
    """softcat_model."""

    _fields_ = [
        *((name, c.c_int) for name in ("slots", "sections", "parameters", "places", "scratch", "entries", "powers")),
        ("moves_in_time", c.c_int),
        *((name, Integers) for name in ("rate", "differential", "held_first", "held_last", "row", "offset", "column")),
        *((name, c.c_void_p) for name in ("rates", "jacobian", "work", "work_slope")),
        *((name, c.c_void_p) for name in ("rates_in_time", "work_in_time")),
    ]


class Method(c.Structure):
    """softcat_method."""

    _fields_ = [
        ("name", c.c_char_p),
        ("stages", c.c_int),
        ("error_order", c.c_int),
        ("dense_rows", c.c_int),
        ("embedded", c.c_int),
        ("gamma", c.c_double),
        ("a", c.c_double * 8 * 8),
        ("c", c.c_double * 8 * 8),
        ("time", c.c_double * 8),
        ("slope", c.c_double * 8),
        ("dense", c.c_double * 8 * 3),
    ]


def sources() -> dict[str, str]:
    """C text of the runtime and the problems by file name."""
    files = sorted([*RUNTIME.glob("*.[ch]"), *PROBLEMS.glob("*.c")])
    return {file.name: file.read_text(encoding="utf-8") for file in files if file.name != "sanitised.c"}


@functools.cache
def library() -> c.CDLL:
    """The compiled runtime, which knows every warning as an error."""
    loaded = load(compile_library(sources(), flags=STRICT))
    loaded.softcat_method_of.restype = c.POINTER(Method)
    loaded.softcat_message.restype = c.c_char_p
    loaded.softcat_linear_new.restype = c.c_void_p
    loaded.softcat_integrate_size.restype = c.c_size_t
    return loaded


def doubles(values: np.ndarray | Sequence[float] | None) -> c.Array[c.c_double] | None:
    """The numbers as a C array that Python keeps alive, or NULL."""
    if values is None:
        return None
    flat = np.asarray(values, dtype=float).ravel()
    return (c.c_double * max(1, flat.size))(*flat)


def ints(values: Sequence[int]) -> c.Array[c.c_int]:
    """The numbers as a C array."""
    return (c.c_int * max(1, len(values)))(*(int(v) for v in values))


@dataclass(frozen=True)
class Problem:
    """A model, and the filament it is asked for."""

    model: Model
    sites: int = 1
    parameters: np.ndarray | Sequence[float] = ()
    places: np.ndarray | Sequence[float] = ()

    def filament(self) -> FilamentStruct:
        """The filament as C sees it."""
        return FilamentStruct(self.sites, doubles(self.parameters), doubles(self.places))


def problem(name: str, *parameters: float) -> Problem:
    """One of the problems of ordinary.c."""
    return Problem(Model.in_dll(library(), name), parameters=parameters)


@dataclass
class Run:
    """What softcat_sensitivities gave: states (times, sites * slots), work (times, powers), the state reached."""

    status: Status
    states: np.ndarray
    work: np.ndarray
    state: np.ndarray
    derivatives: np.ndarray | None = None
    work_derivatives: np.ndarray | None = None


@dataclass
class Moved:
    """Directions in which the filament is moved, each (count, ...) or None."""

    size: Sequence[float]
    parameters: np.ndarray | None = None
    places: np.ndarray | None = None
    state: np.ndarray | None = None
    two_sided: bool = False


@dataclass
class Settings:
    """softcat_options with Python's numbers; see softcat_rosenbrock.h."""

    relative: float = 1e-6
    absolute: float | Sequence[float] = 1e-9
    first_step: float = 0.0
    smallest_step: float = 0.0
    largest_step: float = 0.0
    max_steps: int = 0
    method: int = RODAS5P
    kinks: Sequence[float] = ()
    stop: c.c_int | None = None
    turns: CTurns | None = None
    kept: list[object] = field(default_factory=list)

    def options(self, slots: int) -> Options:
        """As C sees them."""
        absolute = doubles(np.broadcast_to(np.asarray(self.absolute, dtype=float), (slots,)))
        made = Options(self.relative, absolute, 0.0, self.first_step, self.smallest_step, self.largest_step)
        made.max_steps, made.method = self.max_steps, self.method
        made.kinks, made.kink_count = doubles(self.kinks), len(self.kinks)
        made.stop = c.pointer(self.stop) if self.stop is not None else None
        made.turns = c.pointer(self.turns) if self.turns is not None else None
        return made


def fixed(step: float, method: int) -> Settings:
    """Settings under which every step has this length."""
    return Settings(relative=1e30, absolute=1e30, first_step=step, largest_step=step, method=method)


def workspace(what: Problem, directions: CDirections | None = None) -> tuple[object, Workspace]:
    """Memory as large as the runtime asks for, to a byte, and how it is given it."""
    given = None if directions is None else c.byref(directions)
    size = library().softcat_integrate_size(c.byref(what.model), what.sites, given)
    room = c.create_string_buffer(size)
    return room, Workspace(c.addressof(room), size)


def integrate(
    what: Problem,
    start: Sequence[float] | np.ndarray,
    times: Sequence[float],
    settings: Settings,
    moved: Moved | None = None,
) -> Run:
    """Call softcat_integrate, or softcat_sensitivities where directions are given."""
    size, count, powers = what.sites * what.model.slots, len(times), what.model.powers
    status, state = Status(), doubles(start)
    states, work = doubles(np.full((count, size), np.nan)), doubles(np.full((count, powers), np.nan))
    options, filament = settings.options(what.model.slots), what.filament()
    shared = (c.byref(what.model), c.byref(filament), c.byref(options), state, doubles(times), count, states, work)
    directions = None
    if moved is not None:
        directions = CDirections(len(moved.size), int(moved.two_sided), doubles(moved.size))
        directions.parameters, directions.places = doubles(moved.parameters), doubles(moved.places)
        directions.state = doubles(moved.state)
        rows = (len(moved.size), count)
        directions.states, directions.work = doubles(np.zeros((*rows, size))), doubles(np.zeros((*rows, powers)))
        room, given = workspace(what, directions)
        library().softcat_sensitivities(*shared, c.byref(directions), given, c.byref(status))
    else:
        room, given = workspace(what)
        library().softcat_integrate(*shared, given, c.byref(status))
    del room
    run = Run(status, _array(states, count, size), _array(work, count, powers), np.array(state[:size]))
    if directions is not None:
        run.derivatives = _array(directions.states, *rows, size)
        run.work_derivatives = _array(directions.work, *rows, powers)
    return run


def _array(values: c.Array[c.c_double], *shape: int) -> np.ndarray:
    return np.array(values[: int(np.prod(shape))]).reshape(shape)


def consistent(what: Problem, t: float, start: Sequence[float], settings: Settings) -> tuple[Status, np.ndarray]:
    """Call softcat_consistent."""
    status, state = Status(), doubles(start)
    options, filament, (room, given) = settings.options(what.model.slots), what.filament(), workspace(what)
    library().softcat_consistent(
        c.byref(what.model), c.byref(filament), c.byref(options), c.c_double(t), state, given, c.byref(status)
    )
    del room
    return status, np.array(state[:])


def slopes(values: Sequence[float]) -> np.ndarray:
    """Observed orders where the step is halved from one value to the next."""
    return np.log2(np.asarray(values[:-1]) / np.asarray(values[1:]))


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
    """Any number of sites, unknowns, rates, section states, held ends and entries of reach 2, diagonally heavy.

    At two sites of five no kept unknown moves the section states.
    """
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
    at_rest = random.random(sites) < 0.4
    for place, (row, _, column) in enumerate(pattern):
        if row >= kept > column:
            entries[at_rest, place] = 0.0
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
