"""The module of a scene, run by wasmtime, and the same C compiled for this machine."""

from __future__ import annotations

import ctypes as ct
import importlib
import importlib.util
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest

from softcat_sym.codegen.interface import Description
from softcat_sym.codegen.library import compile_library, load
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.web.module import find_wasm_compiler, module_sources, wasm_module

ROOMS = ("parameters", "absolute", "start", "fields", "midpoint", "work", "extremes", "status")


def need_wasmtime() -> None:
    """Skip where a module cannot be compiled or run: the compiler takes 100 MB, so that only who makes pages has it."""
    lacking = [] if importlib.util.find_spec("wasmtime") else ["the package wasmtime"]
    lacking += [] if find_wasm_compiler() else ["a C compiler for WebAssembly: the package ziglang, or SOFTCAT_WASM_CC"]
    if lacking:
        pytest.skip(f"no {lacking[0]}")


@dataclass(frozen=True)
class How:
    """What a run is given besides its parameters."""

    cells: int
    fibres: int
    frames: int
    duration: float
    grading: float
    relative: float
    absolute: Sequence[float]
    largest_step: float = 0.0
    method: int = 1
    max_steps: int = 0


def as_the_scene(described: Description, **others: Any) -> How:
    """What `softcat run` gives it."""
    run, steps = described.scene.run, described.steps
    given = {"duration": run.duration, "frames": run.frames, "relative": steps.relative, "absolute": steps.absolutes}
    given |= {"largest_step": steps.largest_step, "method": steps.method}
    given |= {"cells": described.cells, "fibres": described.fibres, "grading": described.grading}
    return How(**{**given, **others})


@dataclass(frozen=True)
class Solved:
    """What a run left."""

    code: int
    reached: float
    steps: int
    rejected: int
    worst: tuple[int, int]  # Site and slot
    midpoint: Floats
    fields: dict[str, Floats]  # (frames, sites) of each row
    work: Floats
    extremes: Floats  # Time, height and its integral: at first, at each turning point, at last
    yielded: bool
    words: str


@dataclass
class Page:
    """A solver with the functions that a page calls."""

    described: Description
    start: Floats = field(default_factory=lambda: np.empty(0))  # Rows of X and the unknowns

    def call(self, name: str, *given: float) -> int:
        """Call an exported function."""
        raise NotImplementedError

    def numbers(self, address: int, count: int) -> Floats:
        """Numbers in its memory, which may be written."""
        raise NotImplementedError

    def text(self, address: int) -> str:
        """A text in its memory."""
        raise NotImplementedError

    def solve(self, parameters: Sequence[float], how: How) -> Solved:
        """Solve as the page does."""
        model = self.described.model
        self.numbers(self.call("page_parameters"), len(parameters))[:] = parameters
        self.numbers(self.call("page_absolute", len(how.absolute)), len(how.absolute))[:] = how.absolute
        room = self.call("page_start", len(self.start))
        if self.start.size:
            self.numbers(room, self.start.size)[:] = np.r_[self.start[:, 0], self.start[:, 1:].ravel()]
        given = (how.duration, how.grading, how.relative, how.largest_step, how.method, how.max_steps)
        code = self.call("page_solve", how.cells, how.fibres, how.frames, *given)
        status = self.numbers(self.call("page_status"), 10).copy()
        assert code == status[0]
        frames, sites, shown = int(status[6]), int(status[7]), [one.name for one in model.signature.shown]

        def copy(name: str, *shape: int) -> Floats:
            count = int(np.prod(shape))
            return self.numbers(self.call(f"page_{name}"), count).copy().reshape(shape) if count else np.empty(shape)

        fields = copy("fields", frames, len(shown), sites)
        return Solved(
            code,
            float(status[1]),
            int(status[2]),
            int(status[3]),
            (int(status[4]), int(status[5])),
            copy("midpoint", frames),
            {name: fields[:, row] for row, name in enumerate(shown)},
            copy("work", frames, len(model.powers)),
            copy("extremes", int(status[8]), 3),
            bool(status[9]),
            self.text(self.call("page_explain", code)),
        )


class WasmPage(Page):
    """The module under wasmtime."""

    def __init__(self, described: Description) -> None:
        super().__init__(described)
        wasmtime: Any = importlib.import_module("wasmtime")
        self._store = wasmtime.Store()
        module = wasmtime.Module(self._store.engine, wasm_module(described))
        self.imports = [one.name for one in module.imports]
        self._exports = wasmtime.Instance(self._store, module, []).exports(self._store)
        if "_initialize" in self._exports:
            self._exports["_initialize"](self._store)

    def call(self, name: str, *given: float) -> int:
        return int(self._exports[name](self._store, *given))

    def numbers(self, address: int, count: int) -> Floats:
        memory = self._exports["memory"]
        assert 0 < address and address + 8 * count <= memory.data_len(self._store)
        whole = ct.addressof(memory.data_ptr(self._store).contents)
        return np.ctypeslib.as_array(ct.cast(whole + address, ct.POINTER(ct.c_double)), (count,))

    def text(self, address: int) -> str:
        return ct.string_at(ct.addressof(self._exports["memory"].data_ptr(self._store).contents) + address).decode()


class NativePage(Page):
    """The same C as a library of this machine."""

    def __init__(self, described: Description) -> None:
        super().__init__(described)
        self._library = load(compile_library(module_sources(described)), "page_solve")
        for name in (*ROOMS, "explain"):
            getattr(self._library, f"page_{name}").restype = ct.c_void_p
        integers, doubles = ct.c_int, ct.c_double
        self._library.page_solve.argtypes = [*[integers] * 3, *[doubles] * 4, integers, integers]

    def call(self, name: str, *given: float) -> int:
        return int(getattr(self._library, name)(*given) or 0)

    def numbers(self, address: int, count: int) -> Floats:
        return np.ctypeslib.as_array(ct.cast(address, ct.POINTER(ct.c_double)), (count,))

    def text(self, address: int) -> str:
        return ct.string_at(address).decode()
