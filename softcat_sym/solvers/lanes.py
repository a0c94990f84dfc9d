"""Integration of many filaments at once, one in each lane of a vector, by the C of `codegen.lanes_text`."""

from __future__ import annotations

import ctypes as ct
import sys
from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from softcat_sym.codegen.compiler import UNKNOWN, find_compiler, processor
from softcat_sym.codegen.lanes_text import SYMBOL, lanes_sources, lanes_text
from softcat_sym.codegen.library import SOON, STEADY, compile_library, load
from softcat_sym.errors import SoftcatError
from softcat_sym.solvers.compiled import (
    BEYOND,
    SOLVED,
    STOPPED,
    Answer,
    CModel,
    Doubles,
    FilamentStruct,
    Options,
    RunInput,
    Status,
    doubles,
    runtime_sources,
)

# The binary is for this machine only; fused multiply-add is used if the processor has it.
_NATIVE = ("-march=native", "-ffp-contract=fast", "-Wno-psabi")
_MODEL = (*SOON, *_NATIVE)
_RUNTIME = (*STEADY, *_NATIVE)
_INTEGRATE = "softcat_lanes_integrate"


class MemberStruct(ct.Structure):
    """softcat_member."""

    _fields_ = (
        ("filament", FilamentStruct),
        ("options", Options),
        ("state", Doubles),
        ("times", Doubles),
        ("count", ct.c_int),
        ("states", Doubles),
        ("work", Doubles),
        ("status", Status),
    )


def can_be_compiled() -> bool:
    """Whether there is a compiler that supports vectors and this processor.

    On Windows gcc stores vectors of 32 bytes although the stack is aligned to 16 (GCC's bug 54412). Clang before 15
    does not support ``-march=native`` on ARM.
    """
    found = find_compiler()
    if sys.platform == "win32" or found is None or found.path.name == "zig":
        return False
    return found.name.startswith(("gcc", "clang")) and processor(found, _NATIVE) != UNKNOWN


class LanesModel:
    """The lanes of a compiled model, ready to integrate any number of runs, from any number of threads.

    Parameters
    ----------
    model : CModel
        The model for one filament, which repeats runs that fail in a lane.

    Raises
    ------
    SoftcatError
        If the compiler refuses; with its message.
    """

    def __init__(self, model: CModel) -> None:
        self._one = model
        headers = {name: text for name, text in (runtime_sources() | lanes_sources()).items() if name.endswith(".h")}
        sources = headers | {"filament.c": lanes_text(model.model.text)}
        self._library = load(compile_library(sources, flags=_MODEL), SYMBOL)
        self._address = ct.c_void_p(ct.addressof(ct.c_char.in_dll(self._library, SYMBOL)))
        self._runtime = _runtime()

    def integrate(self, runs: Sequence[RunInput], rooms: Sequence[Answer], stop: ct.c_int | None = None) -> None:
        """Integrate runs with the same number of sites and the same method, as :meth:`CModel.integrate` does."""
        members, kept = (MemberStruct * len(runs))(), list[object]()
        for member, run, room in zip(members, runs, rooms, strict=True):
            arrays = [np.ascontiguousarray(array) for array in (run.parameters, run.places, run.state, run.times)]
            options = run.options(stop, room.turns)
            kept += [options, *arrays]
            parameters, places, state, times = (doubles(array) for array in arrays)
            member.filament = FilamentStruct(len(run.state), parameters, places)
            member.options = options
            member.state, member.times, member.count = state, times, len(run.times)
            member.states = doubles(room.states)
            member.work = doubles(room.work) if self._one.model.powers else None
        code = self._runtime.softcat_lanes_integrate(self._address, members, len(runs))
        if code != SOLVED:
            raise SoftcatError(f"the lanes of the compiled solver refused to begin: {self._one.message(code)}")
        for member, run, room in zip(members, runs, rooms, strict=True):
            if member.status.code in (SOLVED, STOPPED, BEYOND):
                ct.pointer(room.status)[0] = member.status
            else:
                room.states[...], room.work[...] = np.nan, 0.0
                self._one.integrate(run, room.status, stop, room)


@lru_cache(maxsize=16)
def lanes_of(model: CModel) -> LanesModel:
    """The lanes of a model, loaded once in a process."""
    return LanesModel(model)


@lru_cache(maxsize=1)
def _runtime() -> ct.CDLL:
    library = load(compile_library(runtime_sources() | lanes_sources(), flags=_RUNTIME), _INTEGRATE)
    library.softcat_lanes_integrate.argtypes = [ct.c_void_p, ct.POINTER(MemberStruct), ct.c_int]
    return library
