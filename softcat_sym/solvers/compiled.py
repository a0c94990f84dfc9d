"""Time integration by the C runtime, which is independent of Python and the fastest solver."""

from __future__ import annotations

import ctypes as ct
import threading
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, wait
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from importlib import resources
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

import numpy as np
import numpy.typing as npt

from softcat_sym.codegen.c_model import Model, Structure, model_for
from softcat_sym.codegen.compiler import beside
from softcat_sym.codegen.library import SOON, STEADY, compile_library, load
from softcat_sym.codegen.sites import Sites, places_in_rows, sites_of
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.section_rule import POINT, shown_of_section
from softcat_sym.discretization.unknowns import Floats, Numbers
from softcat_sym.errors import SoftcatError
from softcat_sym.interrupts import check_time
from softcat_sym.solvers.modal_tail import Conditions, Partition, Pieces, solved_with_tail
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import RODAS5P, Settings
from softcat_sym.solvers.solution import Bounds, Extremes, Progress, Solution, Start, is_torn, watched
from softcat_sym.store import version

Doubles = ct.POINTER(ct.c_double)
Integers = ct.POINTER(ct.c_int)

_VERSIONS = {"casadi": version("casadi")}
_MODEL, _OBSERVE = "softcat_filament_model", "softcat_filament_observe"
_SHOWN = ("-O2",)

SOLVED, STEP_LIMIT, STEP_TOO_SMALL, NON_FINITE, SINGULAR, MEMORY, ARGUMENT, STOPPED, NO_CONVERGENCE, BEYOND = range(10)
OUTCOMES = {
    STEP_LIMIT: Outcome.step_limit,
    STEP_TOO_SMALL: Outcome.no_convergence,
    NON_FINITE: Outcome.non_finite,
    SINGULAR: Outcome.no_convergence,
    NO_CONVERGENCE: Outcome.no_convergence,
}

_LOOK = 0.1  # s between two progress reports
_MAX_TURNS = 4096  # That are kept, of a ringing of thousands of periods: 100 kB
_MAX_STEPS, _STEPS_PER_FRAME = 1_000_000, 500  # Minutes of work: a run with more steps makes no progress


class FilamentStruct(ct.Structure):
    """softcat_filament."""

    _fields_ = (
        ("sites", ct.c_int),
        ("parameters", Doubles),
        ("places", Doubles),
        ("fibres", ct.c_int),
        ("points", Doubles),
    )


class Physics(ct.Structure):
    """softcat_model."""

    _fields_ = (
        *((name, ct.c_int) for name in ("slots", "sections", "parameters", "places", "scratch", "entries")),
        *((name, ct.c_int) for name in ("powers", "moves_in_time")),
        *((name, Integers) for name in ("rate", "differential", "held_first", "held_last", "row", "offset", "column")),
        *((name, ct.c_void_p) for name in ("rates", "jacobian", "work", "work_slope", "rates_in_time", "work_in_time")),
    )


Evaluation = tuple[Callable[[float, Floats], None], Floats]
"""A function of a time and a state, and the array into which it writes."""

_Evaluated = ct.CFUNCTYPE(ct.c_int, ct.POINTER(FilamentStruct), ct.c_double, *[Doubles] * 3)
"""A function of a softcat_model at a time and a state, with its result and scratch."""


class CBounds(ct.Structure):
    """softcat_bounds."""

    _fields_ = (("slots", ct.c_int * 3), ("farthest", ct.c_double), ("longest", Doubles), ("held", ct.c_double * 6))
    kept: Floats  # The array of `longest`, which ctypes does not keep alive


class CTurns(ct.Structure):
    """softcat_turns."""

    _fields_ = (
        *((name, ct.c_int) for name in ("site", "slot", "capacity", "count", "direction")),
        ("rows", Doubles),
    )


class Options(ct.Structure):
    """softcat_options."""

    _fields_ = (
        ("relative", ct.c_double),
        ("absolute", Doubles),
        *((name, ct.c_double) for name in ("work_absolute", "first_step", "smallest_step", "largest_step")),
        ("max_steps", ct.c_long),
        ("method", ct.c_int),
        ("kinks", Doubles),
        ("kink_count", ct.c_int),
        ("stop", Integers),
        ("bounds", ct.POINTER(CBounds)),
        ("turns", ct.POINTER(CTurns)),
    )
    kept: Floats  # The array of `absolute`, which ctypes does not keep alive


class Status(ct.Structure):
    """softcat_status."""

    _fields_ = (
        ("code", ct.c_int),
        *((name, ct.c_long) for name in ("steps", "rejected", "evaluations", "factorisations")),
        ("reached", ct.c_double),
        ("worst_site", ct.c_int),
        ("worst_slot", ct.c_int),
    )


class Workspace(ct.Structure):
    """softcat_workspace."""

    _fields_ = (("memory", ct.c_void_p), ("bytes", ct.c_size_t))


class CDirections(ct.Structure):
    """softcat_directions."""

    _fields_ = (
        ("count", ct.c_int),
        ("two_sided", ct.c_int),
        *((name, Doubles) for name in ("size", "parameters", "places", "state", "states", "work")),
    )


def doubles(array: Floats | None) -> ct._Pointer[ct.c_double] | None:
    """A pointer to an array's memory, which the caller keeps alive; NULL for None."""
    return None if array is None else array.ctypes.data_as(Doubles)


@dataclass(frozen=True)
class RunInput:
    """Numbers of one integration."""

    parameters: Floats  # In the order of the model
    places: Floats  # Geometry, shape (sites, places)
    state: Floats  # Initial state, shape (sites, slots)
    times: Floats  # Increasing, shape (frames,); the first is that of the initial state
    relative: float  # Tolerances; the absolute one may have a number for each slot, shape (slots,)
    absolute: float | Floats
    work_absolute: float  # Absolute tolerance of the work; 0 if its error is not controlled
    kinks: Floats  # Times at which steps must end
    max_steps: int
    max_step: float = 0.0  # Longest step; 0 for no limit
    method: int = RODAS5P  # Number of the method in softcat_rosenbrock.h
    bounds: CBounds | None = None  # Where it ends before its last time
    watched: tuple[int, int] | None = None  # Site and slot of the unknown whose turning points are sought

    def options(self, stop: ct.c_int | None = None, turns: CTurns | None = None) -> Options:
        """Options of the C runtime."""
        absolute = np.full(self.state.shape[1], self.absolute)
        found = Options(
            relative=self.relative,
            absolute=doubles(absolute),
            work_absolute=self.work_absolute,
            largest_step=self.max_step,
            max_steps=self.max_steps,
            method=self.method,
        )
        found.kept = absolute
        if len(self.kinks):
            found.kinks, found.kink_count = doubles(self.kinks), len(self.kinks)
        if stop is not None:
            found.stop = ct.pointer(stop)
        if self.bounds is not None:
            found.bounds = ct.pointer(self.bounds)
        if turns is not None:
            found.turns = ct.pointer(turns)
        return found


@dataclass(frozen=True)
class Answer:
    """States (frames, sites, slots) and work (frames, powers); states are NaN at frames that were not reached."""

    states: Floats
    work: Floats
    status: Status
    turns: CTurns | None = None  # Of the unknown that is watched
    rows: Floats | None = None  # Their memory: time, value and integral of each

    @property
    def extremes(self) -> Extremes | None:
        """Values between which the unknown that is watched only rises or only falls."""
        if self.turns is None or self.rows is None:
            return None
        return Extremes(*self.rows[: self.turns.count + 1].T.copy())


@dataclass(frozen=True)
class Directions:
    """Variables q by which a run is differentiated."""

    parameters: Floats  # d parameters/dq, shape (count, parameters)
    state: Floats  # d initial state/dq, shape (count, sites, slots); algebraic unknowns are made consistent
    # Step in each q, positive: the truncation error is about its square, relative to the scale of the solution's
    # nonlinearity in q, and the rounding error is 1e-16 over it.
    size: Floats


class CModel:
    """A compiled model, ready for integration from any number of threads.

    Parameters
    ----------
    model : Callable
        Returns the model with its C text.

    Raises
    ------
    SoftcatError
        If the compiler refuses; with its message.
    """

    def __init__(self, model: Callable[[], Model]) -> None:
        with beside(_runtime), watched() as interrupts:
            self.model = model()
            # CasADi swallows an interrupt while it reads its arguments; check before the wait for the compiler.
            interrupts.check()
            self._library = load(self._compiled("filament.c", self.model.of_any_fibres, SOON), _MODEL)
        self._lock = threading.Lock()
        self._runtime = _runtime()
        # The functions of the library hold for any number of fibres; sizes that depend on it are set here.
        self._physics = Physics.from_buffer_copy(Physics.in_dll(self._library, _MODEL))
        self._columns = {name: np.array(values, dtype=np.intc) for name, values in self.model.columns.items()}
        for name, size in self.model.sizes.items():
            setattr(self._physics, name, size)
        for name, column in self._columns.items():
            setattr(self._physics, name, column.ctypes.data_as(Integers))
        self._points = np.array(self.model.points)
        self._address = ct.c_void_p(ct.addressof(self._physics))

    @staticmethod
    def _compiled(name: str, text: str, flags: tuple[str, ...]) -> Path:
        header = "softcat_model.h"
        return compile_library({name: text, header: runtime_sources()[header]}, flags=flags, versions=_VERSIONS)

    def _filament(self, sites: int, parameters: Floats, places: Floats) -> FilamentStruct:
        return FilamentStruct(sites, doubles(parameters), doubles(places), self.model.fibres, doubles(self._points))

    @cached_property
    def _observe(self) -> Any:
        """Function that computes the stored fields of a run, compiled on first use."""
        path = self._compiled("observables.c", self.model.observables, _SHOWN)
        function = load(path, _OBSERVE).softcat_filament_observe
        function.argtypes = [ct.POINTER(FilamentStruct), ct.c_int, *[Doubles] * 4]
        return function

    @cached_property
    def _rows(self) -> list[tuple[str, int | slice, int, int, bool]]:
        """Name and row of each field with the sites that have it; fields of all points have a range of rows."""
        shown, found = self.model.signature.shown, list[tuple[str, int | slice, int, int, bool]]()
        points = [one.name.rpartition("_")[0] for one in shown if one.name.startswith(POINT)]
        for row, one in enumerate(shown):
            kind, _, number = one.name.rpartition("_")
            if not one.name.startswith(POINT):
                found.append((one.name, row, one.first, one.behind, one.summed))
            elif number == "0":
                found.append((kind, slice(row, row + points.count(kind)), one.first, one.behind, False))
        return found

    def observe(
        self, parameters: Floats, places: Floats, times: Floats, states: Floats
    ) -> tuple[dict[str, Floats], dict[str, Floats]]:
        """Stored fields of a run at several times, and values at the points of its sections.

        Returns
        -------
        fields : dict
            Shape (frames, sites that have it), sums (frames, 1).
        points : dict
            As :func:`softcat_sym.discretization.section_rule.shown_of_section` takes them.
        """
        with self._lock:
            function = self._observe
        sites, rows = len(places), len(self.model.signature.shown)
        out, scratch = np.zeros((len(times), rows, sites)), np.empty(self.model.scratch * sites)
        filament = self._filament(sites, parameters, places)
        given = [np.ascontiguousarray(part) for part in (times, states)]
        function(ct.byref(filament), len(times), *map(doubles, (*given, out, scratch)))
        fields, points = dict[str, Floats](), dict[str, Floats]()
        for name, row, first, behind, summed in self._rows:
            values = out[:, row, first : sites - behind]
            if isinstance(row, slice):
                points[name] = values
            else:
                fields[name] = values.sum(axis=1, keepdims=True) if summed else values
        return fields, points

    def evaluation(self, name: str, parameters: Floats, places: Floats) -> Evaluation:
        """The ``rates`` (sites, slots), powers (``work``) or ``jacobian`` (sites, entries) at a state (sites, slots).

        Entries of a Jacobian stand as `places_of_entries` says.
        """
        sites, sizes = len(places), self.model.sizes
        shapes = {"rates": (sites, sizes["slots"]), "work": (len(self.model.powers),)}
        result = np.zeros(shapes.get(name, (sites, sizes["entries"])))
        state, scratch = np.zeros((sites, sizes["slots"])), np.zeros(sites * sizes["scratch"])
        filament, call = self._filament(sites, parameters, places), ct.cast(getattr(self._physics, name), _Evaluated)
        arrays = [doubles(array) for array in (state, result, scratch)]

        def evaluate(time: float, values: Floats) -> None:
            state[:] = values
            call(filament, time, *arrays)

        return evaluate, result

    def places_of_entries(self, sites: int) -> tuple[Numbers, Numbers, npt.NDArray[np.bool_]]:
        """Flat index of the rate and of the unknown of each entry, and whether the latter's site exists."""
        slots, here = self.model.sizes["slots"], np.arange(sites)[:, None]
        beside = here + self._columns["offset"]
        rows, columns = here * slots + self._columns["row"], beside * slots + self._columns["column"]
        return rows, columns, (beside >= 0) & (beside < sites)

    def room(self, run: RunInput, status: Status) -> Answer:
        """Arrays for the frames of a run, filled with NaN, and for its turning points."""
        frames = len(run.times)
        states, work = np.full((frames, *run.state.shape), np.nan), np.zeros((frames, len(self.model.powers)))
        if run.watched is None:
            return Answer(states, work, status)
        rows = np.zeros((_MAX_TURNS, 3))
        return Answer(states, work, status, CTurns(*run.watched, _MAX_TURNS, rows=doubles(rows)), rows)

    def integrate(
        self, run: RunInput, status: Status, stop: ct.c_int | None = None, room: Answer | None = None
    ) -> Answer:
        """Integrate; `status` has the time reached during the integration, and a non-zero `stop` ends it.

        During the integration the frames up to that time are in `room`, if it is given.
        """
        answer = room or self.room(run, status)
        work = answer.work if self.model.powers else None
        self._call(run, answer.states, work, None, status, stop, answer.turns)
        return answer

    def sensitivities(
        self, run: RunInput, directions: Directions, status: Status, stop: ct.c_int | None = None
    ) -> tuple[Floats, Floats]:
        """Integrate, with two-sided differences of neighbours in lock-step: derivatives of the discrete solution.

        The work is not returned; if its error is controlled, it still limits the steps.

        Returns
        -------
        states : ndarray, shape (frames, sites, slots)
            NaN at frames that were not reached.
        slopes : ndarray, shape (count, frames, sites, slots)
            Their derivatives.
        """
        shape = (len(run.times), *run.state.shape)
        states, slopes = np.full(shape, np.nan), np.full((len(directions.size), *shape), np.nan)
        moved = [np.ascontiguousarray(part) for part in (directions.size, directions.parameters, directions.state)]
        given = CDirections(count=len(directions.size), two_sided=1, states=doubles(slopes))
        given.size, given.parameters, given.state = (doubles(part) for part in moved)
        # Without an array the work would not be integrated, and the steps would differ from those of `integrate`.
        powers = len(self.model.powers)
        work = np.zeros((len(run.times), powers)) if powers and run.work_absolute > 0 else None
        self._call(run, states, work, given, status, stop)
        return states, slopes

    def consistent(self, run: RunInput, status: Status) -> Floats:
        """The initial state of a run, with its algebraic unknowns in balance."""
        state = run.state.copy()
        filament = self._filament(len(state), run.parameters, run.places)
        options = run.options()
        found = [ct.byref(part) for part in (filament, options)]
        room, workspace = self._workspace(len(state))
        self._runtime.softcat_consistent(
            self._address, *found, run.times[0], doubles(state), workspace, ct.byref(status)
        )
        del room
        return state

    def _workspace(self, sites: int, directions: CDirections | None = None) -> tuple[Floats, Workspace]:
        """Memory for one call of the C runtime; the caller keeps the array alive meanwhile."""
        given = None if directions is None else ct.byref(directions)
        size = self._runtime.softcat_integrate_size(self._address, sites, given)
        room = np.empty(size // 8 + 1)
        return room, Workspace(room.ctypes.data, room.nbytes)

    def _call(
        self,
        run: RunInput,
        states: Floats,
        work: Floats | None,
        directions: CDirections | None,
        status: Status,
        stop: ct.c_int | None,
        turns: CTurns | None = None,
    ) -> None:
        state, options = run.state.copy(), run.options(stop, turns)
        filament = self._filament(len(state), run.parameters, run.places)
        room, workspace = self._workspace(len(state), directions)
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
            workspace,
            ct.byref(status),
        )
        del room

    def message(self, code: int) -> str:
        """Meaning of a status code."""
        return str(self._runtime.softcat_message(code).decode())


@runtime_checkable
class Flagged(Protocol):
    """A receiver that performs and stops compiled integrations itself, so that no thread need watch them."""

    def integrate(self, model: CModel, run: RunInput, room: Answer) -> None:
        """Integrate a run into its arrays."""
        ...


def runtime_sources() -> dict[str, str]:
    """C files of the runtime by name."""
    folder = resources.files("softcat_sym.codegen") / "runtime"
    files = sorted(folder.iterdir(), key=str)
    return {file.name: file.read_text(encoding="utf-8") for file in files if file.name[-2:] in (".c", ".h")}


@lru_cache(maxsize=1)
def _runtime() -> ct.CDLL:
    sources = runtime_sources()
    # One file that includes all others, so that the compiler starts once.
    whole = {"softcat_runtime.c": "".join(f'#include "{name}"\n' for name in sources if name.endswith(".c"))}
    path = compile_library(sources | whole, flags=STEADY, units=tuple(whole))
    library = load(path, "softcat_sensitivities", "softcat_message")
    setup: list[Any] = [ct.c_void_p, ct.POINTER(FilamentStruct), ct.POINTER(Options), Doubles, Doubles, ct.c_int]
    results: list[Any] = [Doubles, Doubles, ct.POINTER(CDirections), Workspace, ct.POINTER(Status)]
    library.softcat_sensitivities.argtypes = [*setup, *results]
    library.softcat_consistent.argtypes = [*setup[:3], ct.c_double, Doubles, Workspace, ct.POINTER(Status)]
    library.softcat_integrate_size.argtypes = [ct.c_void_p, ct.c_int, ct.POINTER(CDirections)]
    library.softcat_integrate_size.restype = ct.c_size_t
    library.softcat_message.restype = ct.c_char_p
    return library


def refuse(code: int, message: str) -> None:
    """Raise an error if the cause is not the filament: too little memory, or a wrong argument."""
    if code in (MEMORY, ARGUMENT):
        raise SoftcatError(f"the compiled solver refused to begin: {message}")


@dataclass(frozen=True)
class CompiledFilament:
    """A compiled model with the geometry of one grid."""

    model: CModel
    sites: Sites  # Positions of the graph's unknowns in the model
    places: Floats  # Geometry, shape (sites, places)
    graph: Graph  # The same filament, for names of unknowns

    def observe(self, time: Floats, x: Floats, z: Floats, p: Floats) -> dict[str, Floats]:
        """As :meth:`softcat_sym.discretization.graph.Graph.observe`, in C."""
        fields, points = self._seen(time, x, z, p)
        return fields if self.graph.rule is None else fields | shown_of_section(points, self.graph.rule)

    def stretch(self, time: Floats, x: Floats, z: Floats, p: Floats) -> Floats:
        """Stretch of the cells alone, shape (frames, cells)."""
        return self._seen(time, x, z, p)[0]["stretch"]

    def _seen(self, time: Floats, x: Floats, z: Floats, p: Floats) -> tuple[dict[str, Floats], dict[str, Floats]]:
        return self.model.observe(np.ascontiguousarray(p), self.places, time, self.sites.states(x, z))


@dataclass(frozen=True)
class CompiledNewton:
    """Newton's method in C, a :data:`softcat_sym.solvers.solution.Newton`."""

    graph: Graph
    filament: CompiledFilament
    at_rest: Callable[[Graph], CompiledFilament]  # Compiles the graph of the filament at rest
    settings: Settings

    def __call__(self, graph: Graph, x: Floats, p: Floats, guess: Floats) -> Floats | None:
        """Algebraic unknowns in balance; None if none are found."""
        filament = self.filament if graph is self.graph else self.at_rest(graph)
        run, status = (
            RunInput(
                parameters=np.ascontiguousarray(p),
                places=filament.places,
                state=filament.sites.state(x, guess),
                times=np.zeros(1),
                relative=self.settings.rtol,
                absolute=self.settings.absolute(slot.name for slot in filament.model.model.slots),
                work_absolute=0.0,
                kinks=np.empty(0),
                max_steps=0,
            ),
            Status(),
        )
        state = filament.model.consistent(run, status)
        refuse(status.code, filament.model.message(status.code))
        return filament.sites.vectors(state[None])[1][:, 0] if status.code == SOLVED else None


@dataclass(frozen=True)
class CompiledRates:
    """Rates at one instant, as :class:`softcat_sym.solvers.modal_tail.Rates` has them."""

    filament: CompiledFilament
    p: Floats
    time: float

    def rates(self, states: Floats) -> Floats:
        """Rates of states (frames, sites * slots)."""
        return self._evaluated("rates", states)

    def powers(self, states: Floats) -> Floats:
        """Powers of them, shape (powers, frames); none of a filament whose balance has none."""
        return self._evaluated("work", states).T if self.filament.model.model.powers else np.zeros((0, len(states)))

    def jacobian(self, state: Floats, of: Numbers) -> Floats:
        """Derivatives of the rates of unknowns that are no section's, by each other."""
        number, entries = np.full(state.size, -1), self._evaluated("jacobian", state.reshape(1, -1))[0]
        number[of] = np.arange(len(of))
        rows, columns, there = self.filament.model.places_of_entries(self.filament.sites.shape[0])
        rows, columns = number[rows[there]], number[columns[there]]
        used, found = (rows >= 0) & (columns >= 0), np.zeros((len(of), len(of)))
        np.add.at(found, (rows[used], columns[used]), entries[there.ravel()][used])
        return found

    def _evaluated(self, name: str, states: Floats) -> Floats:
        """A function of the library at each state, shape (frames, numbers)."""
        evaluate, result = self.filament.model.evaluation(name, self.p, self.filament.places)
        found = np.empty((len(states), result.size))
        for state, row in zip(states.reshape(-1, *self.filament.sites.shape), found, strict=True):
            evaluate(self.time, state)
            row[:] = result.ravel()
        return found


@dataclass(frozen=True)
class CompiledIntegration:
    """A prepared run of the C model."""

    graph: Graph  # The same filament, for names
    settings: Settings
    filament: CompiledFilament
    frames: int  # Output times, t = 0 included
    kinks: Floats  # Times, in units of the time scale, at which a support changes its rate
    bounds: Bounds | None = None  # Where the filament falls for ever
    conditions: Conditions | None = None  # When its modes may carry it to the end

    def run(self, start: Start, p: Floats, duration: float, scale: float, progress: Progress) -> Solution:
        """Integrate from a filament at rest; parameters as :meth:`softcat_sym.solvers.interpreted.Integration.run`."""
        frames, sites, conditions = np.linspace(0.0, duration, self.frames), self.filament.sites, self.conditions

        def piece(start: Start, times: Floats) -> Solution:
            return self.piece(start, p, times, scale, progress)

        at = None if conditions is None else Partition.of(self.filament.model.model.slots, sites)
        if conditions is None or at is None:
            return piece(start, frames)
        rates = CompiledRates(self.filament, np.ascontiguousarray(p), conditions.begin)
        midpoint = self.graph.midpoint_row("y")
        found = solved_with_tail(conditions, rates, at, Pieces(piece, sites, frames, start), midpoint)
        if found.tail_from is not None:
            progress.doing("following its modes of vibration")
            progress.update(duration * scale, None)
        return found

    def piece(self, start: Start, p: Floats, times: Floats, scale: float, progress: Progress) -> Solution:
        """Integrate from a state at the first of several times to the last."""
        model, sites, status = self.filament.model, self.filament.sites, Status()
        run = RunInput(
            parameters=np.ascontiguousarray(p),
            places=self.filament.places,
            state=sites.state(start.x, start.z),
            times=times,
            relative=self.settings.rtol,
            absolute=self.settings.absolute(slot.name for slot in model.model.slots),
            # Without inertia only flow limits the steps; with little flow the error of the work would be uncontrolled.
            work_absolute=0.0 if "v" in self.graph.differential.kinds else self.settings.atol,
            kinks=self.kinks,
            max_steps=max(_MAX_STEPS, _STEPS_PER_FRAME * len(times)),
            max_step=(self.settings.max_step or 0.0) / scale,
            method=self.settings.method,
            bounds=None if self.bounds is None else self._bounds(self.bounds, start, p, times[:1]),
            watched=sites.of(self.graph.midpoint_row("y")),
        )
        room = model.room(run, status)

        def torn() -> bool:
            frame = _reached(times, status)
            x, z = sites.vectors(room.states[frame : frame + 1])
            return frame > 0 and is_torn(self.graph.terms, self.filament.stretch(times[frame : frame + 1], x, z, p))

        stopped = False
        try:
            self._watched(run, room, torn, scale, progress)
        except KeyboardInterrupt:
            stopped = True
        refuse(status.code, model.message(status.code))
        frames = _reached(times, status) + 1
        x, z = sites.vectors(room.states[:frames])
        x[:, 0], z[:, 0] = start.x, start.z
        quad = np.zeros((len(self.graph.powers), frames))
        quad[: room.work.shape[1], 1:] = room.work[1:frames].T
        outcome, message = Outcome.solved, ""
        if status.code not in (SOLVED, STOPPED, BEYOND):
            outcome, worst = OUTCOMES[status.code], ""
            if status.worst_slot >= 0:
                name, site = model.model.slots[status.worst_slot].name, status.worst_site
                worst = f"; worst: {name}[{site}] at X/L = {self.graph.grid.nodes[site]:.4g}"
            message = f"stopped after t = {status.reached * scale:.6g} s{worst}; {model.message(status.code)}"
        found = Solution(times[:frames], x, z, quad, outcome, message, int(status.steps), extremes=room.extremes)
        if status.code == BEYOND:
            return found.left(status.reached, scale, falls=self.bounds is None or self.bounds.never)
        found = found.to_rupture(self.graph.terms, partial(self.filament.stretch, p=p), scale)
        if stopped or (status.code == STOPPED and found.outcome is Outcome.solved):
            raise found.interrupted(scale)
        return found

    def _bounds(self, bounds: Bounds, start: Start, p: Floats, time: Floats) -> CBounds:
        """The bounds of the nodes and cells, with where the first and the last node are held."""
        slots = {slot.name: (column, slot.held) for column, slot in enumerate(self.filament.model.model.slots)}
        seen = self.filament.observe(time, start.x[:, None], start.z[:, None], p)
        longest, held = bounds.stretch * np.diff(self.graph.grid.nodes), np.full((2, 3), np.nan)
        for axis, name in enumerate("xyz"):
            for side, is_held in enumerate(slots[name][1] if name in slots else ()):
                held[side, axis] = seen[name][0, -side] / bounds.length if is_held else np.nan
        columns = [slots[axis][0] if axis in slots else -1 for axis in "xyz"]
        found = CBounds((ct.c_int * 3)(*columns), bounds.distance, doubles(longest), (ct.c_double * 6)(*held.flat))
        found.kept = longest
        return found

    def _watched(self, run: RunInput, room: Answer, torn: Callable[[], bool], scale: float, progress: Progress) -> None:
        """Integrate in a thread, so that Ctrl-C and progress reports work; or let the listener integrate."""
        status, integrate = room.status, self.filament.model.integrate

        def report() -> None:
            reached = status.reached * scale
            progress.update(reached, reached / status.steps if status.steps else None)

        if isinstance(progress, Flagged):
            progress.integrate(self.filament.model, run, room)
            report()
            return
        stop = ct.c_int(0)
        with ThreadPoolExecutor(1) as pool:
            answer = pool.submit(integrate, run, status, stop, room)
            try:
                while not wait([answer], _LOOK).done:
                    report()
                    check_time()
                    stop.value = int(torn())
            finally:
                stop.value = 1
        report()
        answer.result()


def _reached(times: Floats, status: Status) -> int:
    """The last frame that was reached."""
    return max(1, int(np.count_nonzero(times <= status.reached))) - 1


def compile_filament(graph: Graph, structure: Structure) -> CompiledFilament:
    """Compile a filament, or take it from the cache."""
    compiled = compiled_model(structure)
    return CompiledFilament(compiled, sites_of(graph, compiled.model.slots), places_in_rows(graph), graph)


@lru_cache(maxsize=128)
def compiled_model(structure: Structure) -> CModel:
    """The library of a structure, loaded once in a process."""
    return CModel(partial(model_for, structure))
