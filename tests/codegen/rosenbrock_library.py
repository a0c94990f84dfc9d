"""The C runtime with the test problems as a library, called through ctypes."""

from __future__ import annotations

import ctypes as c
import functools
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import softcat_sym.codegen
from softcat_sym.codegen.library import compile_library, load

RUNTIME = Path(softcat_sym.codegen.__file__).parent / "runtime"
PROBLEMS = Path(__file__).parent / "problems"
STRICT = ("-O2", "-Wall", "-Wextra", "-Werror", "-pedantic")

RODAS5P, RODAS4, RODAS3P = range(3)
METHODS = (RODAS5P, RODAS4, RODAS3P)
(
    SOLVED,
    STEP_LIMIT,
    STEP_TOO_SMALL,
    NON_FINITE,
    SINGULAR,
    MEMORY,
    ARGUMENT,
    STOPPED,
    NO_CONVERGENCE,
) = range(9)

_Doubles, _Ints = c.POINTER(c.c_double), c.POINTER(c.c_int)


class Filament(c.Structure):
    """softcat_filament."""

    _fields_ = [("sites", c.c_int), ("parameters", _Doubles), ("places", _Doubles)]


class Model(c.Structure):
    """softcat_model."""

    _fields_ = [
        *((name, c.c_int) for name in ("slots", "sections", "parameters", "places", "scratch", "entries", "powers")),
        ("moves_in_time", c.c_int),
        *((name, _Ints) for name in ("rate", "differential", "held_first", "held_last", "row", "offset", "column")),
        *((name, c.c_void_p) for name in ("rates", "jacobian", "work", "work_slope")),
    ]


class Options(c.Structure):
    """softcat_options."""

    _fields_ = [
        ("relative", c.c_double),
        ("absolute", _Doubles),
        ("work_absolute", c.c_double),
        ("first_step", c.c_double),
        ("smallest_step", c.c_double),
        ("largest_step", c.c_double),
        ("max_steps", c.c_long),
        ("method", c.c_int),
        ("kinks", _Doubles),
        ("kink_count", c.c_int),
        ("stop", _Ints),
    ]


class Status(c.Structure):
    """softcat_status."""

    _fields_ = [
        ("code", c.c_int),
        *((name, c.c_long) for name in ("steps", "rejected", "evaluations", "factorisations")),
        ("reached", c.c_double),
        ("worst_site", c.c_int),
        ("worst_slot", c.c_int),
    ]


class Directions(c.Structure):
    """softcat_directions."""

    _fields_ = [
        ("count", c.c_int),
        ("two_sided", c.c_int),
        *((name, _Doubles) for name in ("size", "parameters", "places", "state", "states", "work")),
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

    def filament(self) -> Filament:
        """The filament as C sees it."""
        return Filament(self.sites, doubles(self.parameters), doubles(self.places))


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
    kept: list[object] = field(default_factory=list)

    def options(self, slots: int) -> Options:
        """As C sees them."""
        absolute = doubles(np.broadcast_to(np.asarray(self.absolute, dtype=float), (slots,)))
        made = Options(self.relative, absolute, 0.0, self.first_step, self.smallest_step, self.largest_step)
        made.max_steps, made.method = self.max_steps, self.method
        made.kinks, made.kink_count = doubles(self.kinks), len(self.kinks)
        made.stop = c.pointer(self.stop) if self.stop is not None else None
        return made


def fixed(step: float, method: int) -> Settings:
    """Settings under which every step has this length."""
    return Settings(relative=1e30, absolute=1e30, first_step=step, largest_step=step, method=method)


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
        directions = Directions(len(moved.size), int(moved.two_sided), doubles(moved.size))
        directions.parameters, directions.places = doubles(moved.parameters), doubles(moved.places)
        directions.state = doubles(moved.state)
        rows = (len(moved.size), count)
        directions.states, directions.work = doubles(np.zeros((*rows, size))), doubles(np.zeros((*rows, powers)))
        library().softcat_sensitivities(*shared, c.byref(directions), c.byref(status))
    else:
        library().softcat_integrate(*shared, c.byref(status))
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
    options, filament = settings.options(what.model.slots), what.filament()
    library().softcat_consistent(
        c.byref(what.model), c.byref(filament), c.byref(options), c.c_double(t), state, c.byref(status)
    )
    return status, np.array(state[:])


def slopes(values: Sequence[float]) -> np.ndarray:
    """Observed orders where the step is halved from one value to the next."""
    return np.log2(np.asarray(values[:-1]) / np.asarray(values[1:]))
