"""The C model of a filament and the C runtime that integrates it, as ctypes sees them (softcat_model.h, ...)."""

from __future__ import annotations

import ctypes as ct
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from importlib import resources
from importlib.metadata import version
from typing import Any

import numpy as np

from softcat_sym.codegen.model_text import Model
from softcat_sym.errors import SoftcatError
from softcat_sym.graph.grid import Floats
from softcat_sym.native import OPTIMISED, SOON, beside, compile_library, load
from softcat_sym.solve.interrupts import watched

Doubles = ct.POINTER(ct.c_double)
Integers = ct.POINTER(ct.c_int)

_VERSIONS = {"casadi": version("casadi")}
_MODEL = "softcat_filament_model"

# As fast as at -O3, and compiled in two thirds of the time.
_RUNTIME = ("-O2", *OPTIMISED[1:])

SOLVED, STEP_LIMIT, STEP_TOO_SMALL, NON_FINITE, SINGULAR, MEMORY, ARGUMENT, STOPPED, NO_CONVERGENCE = range(9)


class Filament(ct.Structure):
    """softcat_filament."""

    _fields_ = (("sites", ct.c_int), ("parameters", Doubles), ("places", Doubles))


class Options(ct.Structure):
    """softcat_options."""

    _fields_ = (
        ("relative", ct.c_double),
        ("absolute", Doubles),
        ("work_absolute", ct.c_double),
        ("first_step", ct.c_double),
        ("smallest_step", ct.c_double),
        ("largest_step", ct.c_double),
        ("most_steps", ct.c_long),
        ("method", ct.c_int),
        ("kinks", Doubles),
        ("kink_count", ct.c_int),
        ("stop", Integers),
    )


class Status(ct.Structure):
    """softcat_status."""

    _fields_ = (
        ("code", ct.c_int),
        ("steps", ct.c_long),
        ("rejected", ct.c_long),
        ("evaluations", ct.c_long),
        ("factorisations", ct.c_long),
        ("reached", ct.c_double),
        ("worst_site", ct.c_int),
        ("worst_slot", ct.c_int),
    )


class CDirections(ct.Structure):
    """softcat_directions."""

    _fields_ = (
        ("count", ct.c_int),
        ("two_sided", ct.c_int),
        ("size", Doubles),
        ("parameters", Doubles),
        ("places", Doubles),
        ("state", Doubles),
        ("states", Doubles),
        ("work", Doubles),
    )


def doubles(array: Floats | None) -> ct._Pointer[ct.c_double] | None:
    """A pointer to an array's memory, which the caller keeps alive; NULL for None."""
    return None if array is None else array.ctypes.data_as(Doubles)


@dataclass(frozen=True)
class Run:
    """Numbers of one integration.

    Attributes
    ----------
    parameters : ndarray
        In the order of the model.
    places : ndarray, shape (sites, places)
        Geometry.
    state : ndarray, shape (sites, slots)
        Where it begins.
    times : ndarray, shape (frames,)
        Increasing; the first is where it begins.
    relative, absolute : float
        Tolerances; the absolute one may have a number for each slot, shape (slots,).
    work_absolute : float
        Absolute tolerance of the work; 0 where its error is not controlled.
    kinks : ndarray
        Times that no step runs over.
    most_steps : int
        Before it gives up.
    max_step : float
        0 for none.
    method : int
        0: Rodas5P, 1: Rodas4, 2: Rodas3P, as softcat_rosenbrock.h numbers them.
    """

    parameters: Floats
    places: Floats
    state: Floats
    times: Floats
    relative: float
    absolute: float | Floats
    work_absolute: float
    kinks: Floats
    most_steps: int
    max_step: float = 0.0
    method: int = 0


@dataclass(frozen=True)
class Answer:
    """What came of it: states (frames, sites, slots) and work (frames, powers), NaN where it did not get."""

    states: Floats
    work: Floats
    status: Status


@dataclass(frozen=True)
class Directions:
    """Numbers q that move a run, in which it is to be differentiated.

    Attributes
    ----------
    parameters : ndarray, shape (count, parameters)
        d parameters/dq.
    state : ndarray, shape (count, sites, slots)
        d initial state/dq; algebraic unknowns are made consistent.
    size : ndarray, shape (count,)
        Step in each q, positive: the derivative errs by about its square relative to the scale on which the solution
        bends in q, and by 1e-16 over it.
    """

    parameters: Floats
    state: Floats
    size: Floats


class CModel:
    """A compiled model, ready to be integrated from any number of threads.

    Parameters
    ----------
    model : Callable
        Gives its text.

    Raises
    ------
    SoftcatError
        If the compiler refuses; with its message.
    """

    def __init__(self, model: Callable[[], Model]) -> None:
        with beside(_runtime), watched() as interrupts:
            self.model = model()
            # CasADi swallows what is raised while it looks at its arguments; what follows waits for a compiler.
            interrupts.check()
            sources = {"filament.c": self.model.text, **_headers()}
            self._library = load(compile_library(sources, flags=SOON, versions=_VERSIONS), _MODEL)
        self._runtime = _runtime()
        self._address = ct.c_void_p(ct.addressof(ct.c_char.in_dll(self._library, _MODEL)))

    def room(self, run: Run, status: Status) -> Answer:
        """Where the frames of a run go: NaN until they do."""
        frames = len(run.times)
        return Answer(np.full((frames, *run.state.shape), np.nan), np.zeros((frames, len(self.model.powers))), status)

    def integrate(self, run: Run, status: Status, stop: ct.c_int | None = None, room: Answer | None = None) -> Answer:
        """Integrate; `status` tells the time reached even while it works, and a non-zero `stop` ends it.

        Frames up to the time reached are in the `room`, if it was given, already then.
        """
        answer = room or self.room(run, status)
        self._call(run, answer.states, answer.work if self.model.powers else None, None, status, stop)
        return answer

    def sensitivities(
        self, run: Run, directions: Directions, status: Status, stop: ct.c_int | None = None
    ) -> tuple[Floats, Floats]:
        """Integrate, with two-sided differences of neighbours in lock-step: derivatives of the discrete solution.

        The work is left out; where its error is controlled it still limits the steps.

        Returns
        -------
        states : ndarray, shape (frames, sites, slots)
            NaN where it did not get.
        slopes : ndarray, shape (count, frames, sites, slots)
            Their derivatives.
        """
        shape = (len(run.times), *run.state.shape)
        states, slopes = np.full(shape, np.nan), np.full((len(directions.size), *shape), np.nan)
        moved = [np.ascontiguousarray(part) for part in (directions.size, directions.parameters, directions.state)]
        given = CDirections(count=len(directions.size), two_sided=1, states=doubles(slopes))
        given.size, given.parameters, given.state = (doubles(part) for part in moved)
        # Without room for the work it would not be integrated, and steps would differ from those of `integrate`.
        work = np.zeros((len(run.times), len(self.model.powers))) if run.work_absolute > 0 else None
        self._call(run, states, work if self.model.powers else None, given, status, stop)
        return states, slopes

    def _call(
        self,
        run: Run,
        states: Floats,
        work: Floats | None,
        directions: CDirections | None,
        status: Status,
        stop: ct.c_int | None,
    ) -> None:
        sites, slots = run.state.shape
        state, absolute = run.state.copy(), np.full(slots, run.absolute)
        filament = Filament(sites, doubles(run.parameters), doubles(run.places))
        options = Options(relative=run.relative, absolute=doubles(absolute), most_steps=run.most_steps)
        options.work_absolute, options.method = run.work_absolute, run.method
        options.largest_step = run.max_step
        if len(run.kinks):
            options.kinks, options.kink_count = doubles(run.kinks), len(run.kinks)
        if stop is not None:
            options.stop = ct.pointer(stop)
        self._runtime.softcat_sensitivities(
            self._address,
            ct.byref(filament),
            ct.byref(options),
            doubles(state),
            doubles(run.times),
            len(run.times),
            doubles(states),
            doubles(work),
            None if directions is None else ct.byref(directions),
            ct.byref(status),
        )

    def message(self, code: int) -> str:
        """What a code means."""
        return str(self._runtime.softcat_message(code).decode())


def runtime_sources() -> dict[str, str]:
    """The C files of the runtime by name."""
    folder = resources.files("softcat_sym.codegen") / "runtime"
    files = sorted(folder.iterdir(), key=str)
    return {file.name: file.read_text(encoding="utf-8") for file in files if file.name[-2:] in (".c", ".h")}


def _headers() -> dict[str, str]:
    return {name: text for name, text in runtime_sources().items() if name == "softcat_model.h"}


@lru_cache(maxsize=1)
def _runtime() -> ct.CDLL:
    library = load(compile_library(runtime_sources(), flags=_RUNTIME), "softcat_sensitivities", "softcat_message")
    library.softcat_sensitivities.argtypes = _signature()
    library.softcat_message.restype = ct.c_char_p
    return library


def _signature() -> list[Any]:
    given: list[Any] = [ct.c_void_p, ct.POINTER(Filament), ct.POINTER(Options), Doubles, Doubles, ct.c_int]
    return [*given, Doubles, Doubles, ct.POINTER(CDirections), ct.POINTER(Status)]


def refuse(code: int, message: str) -> None:
    """Raise where the fault is not in the filament.

    Raises
    ------
    SoftcatError
        If memory is short, or an argument is wrong.
    """
    if code in (MEMORY, ARGUMENT):
        raise SoftcatError(f"the compiled solver refused to begin: {message}")
