"""The solver as other programs take it: stepped by a controller, as an FMU, as one file for Python, for Simulink."""

from __future__ import annotations

import ctypes
import io
import platform as host
import re
import shutil
import subprocess
import zipfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from softcat_sym.codegen.c_text import CSource, c_array, number
from softcat_sym.codegen.compiler import find_compiler, first_of, of_a_wheel
from softcat_sym.codegen.export import model_files, runtime_files
from softcat_sym.codegen.interface import Description, constant, heading, prefix_of, rendered, symbol_of
from softcat_sym.codegen.library import OPTIMISED, compile_library, compiled_by, load
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.errors import SoftcatError
from softcat_sym.scene.scene import undeformed_area
from softcat_sym.scene.temperature_table import PREFIX
from softcat_sym.store import version

OUTPUTS: Final = (
    ("midpoint", "m", "height of the middle of the filament, negative down"),
    ("sag", "m", "of the lowest node below the left support"),
    ("tension_left", "N", "at the left support"),
    ("tension_right", "N", "at the right support"),
    ("max_stress", "Pa", "largest of tension over area and moment over section modulus, together"),
    ("energy_kinetic", "J", "of the whole filament"),
    ("energy_elastic", "J", "of the whole filament"),
    ("energy_potential", "J", "of its weight, 0 when straight"),
    ("energy_dissipated", "J", "plastic work since the start"),
)
"""What a filament shows, in the order of softcat_display.h: name, unit, meaning."""

_INPUTS: Final = re.compile(
    rf"gravity|drop|\w+_angle|direction_[xyz]|tip_(force|torque)\w*|motion_\d+_d[xyz]|{PREFIX}ambient"
)
_FIXED: Final = re.compile(r"rest_length|time_scale|thickness|aspect|area|span|curvature|twist|\w+_time")
_BASE: Final[Mapping[str, Mapping[str, int]]] = {
    **{unit: {unit: 1} for unit in ("kg", "m", "s", "K", "rad")},
    "N": {"kg": 1, "m": 1, "s": -2},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "mol": {"mol": 1},
    "1": {},
}
_SCALARS: Final = 9  # Of a saved session, before its parameters

TARGETS: Final = {
    # Folder of the standard: target of zig, and what a library is called there.
    "x86_64-linux": ("x86_64-linux-gnu", "so"),
    "x86_64-windows": ("x86_64-windows-gnu", "dll"),
    "aarch64-darwin": ("aarch64-macos", "dylib"),
}


@dataclass(frozen=True)
class Variable:
    """A variable of an FMU."""

    name: str
    reference: int
    causality: str
    variability: str
    attributes: dict[str, str]


def base_units(unit: str) -> dict[str, int]:
    """Powers of SI's base units in a unit such as ``Pa*s`` or ``kg/m^3``; empty if it has no such form."""
    found = dict[str, int]()
    for sign, name, power in re.findall(r"([*/]?)([A-Za-z]+|1)(?:\^(\d+))?", unit):
        if name not in _BASE:
            return {}
        for base, exponent in _BASE[name].items():
            found[base] = found.get(base, 0) + exponent * int(power or 1) * (-1 if sign == "/" else 1)
    return {} if "^n" in unit else {base: power for base, power in found.items() if power}


def variables_of(described: Description) -> list[Variable]:
    """Outputs, then inputs and parameters; the independent time is number 0."""
    found = [
        Variable(name, k + 1, "output", "continuous", {"initial": "calculated", "unit": unit, "description": words})
        for k, (name, unit, words) in enumerate(OUTPUTS)
    ]
    lowest = {"positive": "0", "not-negative": "0", "poisson": "-1"}
    for one in described.parameters:
        causality, variability = "parameter", "tunable"
        if _INPUTS.fullmatch(one.name):
            causality, variability = "input", "continuous"
        elif _FIXED.fullmatch(one.name):
            variability = "fixed"
        attributes = {} if one.unit == "1" else {"unit": one.unit}
        attributes |= {"min": lowest[one.bound]} if one.bound in lowest else {}
        attributes |= {"max": "0.5"} if one.bound == "poisson" else {}
        attributes |= {"start": repr(one.value)} | ({"description": one.meaning} if one.meaning else {})
        found.append(Variable(one.name, len(found) + 1, causality, variability, attributes))
    return found


@dataclass(frozen=True)
class Forms:
    """Writers of the forms of one filament."""

    described: Description
    name: str
    command: str
    nodes: Floats | None = None  # X of the starting shape, where there is one
    start: Floats | None = field(default=None, repr=False)  # Its unknowns

    @property
    def _common(self) -> dict[str, Any]:
        prefix = prefix_of(self.name)
        return {
            "heading": heading(self.described, self.command),
            "command": self.command,
            "title": " ".join(self.described.title.split()),
            "name": self.name,
            "prefix": prefix,
            "big": prefix.upper(),
            **{what: symbol_of(self.name, what) for what in ("structure", "settings", "display", "observe")},
            "cells": self.described.cells,
            "fibres": self.described.fibres,
        }

    def _guard(self, what: str) -> str:
        return f"SOFTCAT_{constant(self.name)}_{what}_H"

    def instance(self) -> dict[str, str]:
        """The filament as it is stepped, with its starting shape and what it shows."""
        described, model = self.described, self.described.model
        scene = described.scene
        shown = [one.name for one in model.signature.shown]
        rows, scratch = model.rows, model.template.scratch_shown

        def place(names: Iterable[str], name: str) -> int:
            return next((k for k, one in enumerate(names) if one == name), -1)

        circle = scene.filament.section == "circle"
        fields = {
            **{"rows": rows[0], "rows_each": rows[1], "scratch": scratch[0], "scratch_each": scratch[1]},
            **{name: place(shown, name) for name in ("tension", "moment", "relative_thickness")},
            **{name: place(shown, f"energy_{name}") for name in ("kinetic", "elastic", "potential")},
            "plastic": place(model.powers, "plastic"),
            "thickness": place((one.name for one in described.parameters), "thickness"),
            "area": number(undeformed_area(scene)),
            "height": number(scene.filament.thickness),
            "modulus": "0.125" if circle else number(1 / 6),
        }
        tables = []
        if self.start is not None and self.nodes is not None:
            tables = [
                c_array("double", f"start_{key}", [number(float(one)) for one in values])
                for key, values in (("X", self.nodes), ("values", self.start.ravel()))
            ]
        values = self._common | {"fields": fields, "start": tables}
        values |= {"rows": 0 if self.nodes is None else len(self.nodes), "guard": self._guard("INSTANCE")}
        values["observables"] = model.observables.replace("softcat_filament_observe", values["observe"])
        files = {f"{self.name}_instance.{end}": rendered(f"instance.{end}.jinja", **values) for end in ("c", "h")}
        return files | {f"{self.name}.py": self._python()}

    def _python(self) -> str:
        described = self.described
        axes = 3 if "z" in [slot.name for slot in described.model.slots] else 2
        values = {"parameters": described.parameters, "outputs": OUTPUTS, "axes": axes, "scalars": _SCALARS}
        return rendered("filament.py.jinja", **self._common, **values, duration=described.scene.run.duration)

    def sources(self) -> dict[str, str]:
        """All C that a stepped filament consists of."""
        model = model_files(self.described, self.name, self.command)
        files = {
            file: text for file, text in {**model, **runtime_files(), **self.instance()}.items() if file[-2] == "."
        }
        return {file: text for file, text in files.items() if not file.startswith(("softcat_text.", "softcat_rhs."))}

    def static(self) -> tuple[dict[str, str], str]:
        """The filament in memory of fixed size, and in words how much RAM and flash it takes."""
        sources = self.sources()
        library = load(compile_library(sources, flags=("-Os", *OPTIMISED[1:])), "softcat_session_size")
        size = library.softcat_session_size
        size.restype = ctypes.c_size_t
        exported = [self._common[what] for what in ("structure", "settings")]
        parts = [ctypes.byref(ctypes.c_char.in_dll(library, name)) for name in exported]
        ram = size(parts[0], self.described.cells, parts[1])
        values = self._common | {"doubles": -(-ram // 8), "guard": self._guard("STATIC")}
        files = {f"{self.name}_static.{end}": rendered(f"static.{end}.jinja", **values) for end in ("c", "h")}
        return files, f"RAM {ram} bytes (with pointers of 64 bits); {_flash(library._name)}"

    def simulink(self) -> dict[str, str]:
        """A C MEX S-function."""
        given = {one.name: one for one in self.described.parameters}
        inputs = [given[one.name] for one in variables_of(self.described) if one.causality == "input"]
        return {f"{self.name}_sfun.c": rendered("simulink.c.jinja", **self._common, inputs=inputs)}

    def fmu(self) -> tuple[bytes, dict[str, str]]:
        """An FMU of FMI 3.0, and for each platform that it has no binary for the reason."""
        scene, variables = self.described.scene, variables_of(self.described)
        units = {unit: base_units(unit) for _, unit, _ in OUTPUTS} | {"s": {"s": 1}}
        units |= {one.unit: base_units(one.unit) for one in self.described.parameters if one.unit != "1"}
        sources = self.sources()
        token = CSource(sources).digest
        code = rendered("fmi3.c.jinja", **self._common, token=token)
        sources |= {f"{self.name}_fmi3.c": code}
        described = rendered(
            "modelDescription.xml.jinja",
            **self._common,
            token=token,
            tool=f"softcat_sym {version('softcat_sym')}",
            description=f"effects: {', '.join(self.described.effects.names)}",
            units=units,
            variables=variables,
            stop=scene.run.duration,
            step=scene.run.duration / max(1, scene.run.frames - 1),
        )
        files = sorted(file for file in sources if file.endswith(".c"))
        build = rendered("buildDescription.xml.jinja", name=self.name, sources=files)
        contents: dict[str, str | bytes] = {f"sources/{file}": text for file, text in sources.items()}
        contents |= {"modelDescription.xml": described, "sources/buildDescription.xml": build}
        binaries, missing = _binaries(sources, self.name)
        archive = io.BytesIO()
        with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as into:
            for path, content in (contents | binaries).items():
                into.writestr(zipfile.ZipInfo(path, (1980, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED)
        return archive.getvalue(), missing


def _binaries(sources: Mapping[str, str], name: str) -> tuple[dict[str, bytes], dict[str, str]]:
    """Libraries of the platforms by their paths in an FMU, and why others are missing."""
    found, missing = dict[str, bytes](), dict[str, str]()
    here = _platform()
    zig = first_of(of_a_wheel())
    for platform, (target, ending) in TARGETS.items():
        path = f"binaries/{platform}/{name}.{ending}"
        try:
            if platform == here and find_compiler() is not None:
                found[path] = compile_library(sources, flags=OPTIMISED).read_bytes()
            elif zig is None:
                missing[platform] = "no compiler for it here: pip install ziglang"
            else:
                always = ("-std=c99", "-fPIC", "-shared", "-s", "-target", target)
                found[path] = compiled_by(zig, sources, always, OPTIMISED).read_bytes()
        except SoftcatError as error:
            missing[platform] = str(error).splitlines()[0]
    return found, missing


def _platform() -> str:
    """Folder of the binaries of this machine in an FMU."""
    system = {"Linux": "linux", "Windows": "windows", "Darwin": "darwin"}.get(host.system(), "unknown")
    machine = {"AMD64": "x86_64", "arm64": "aarch64"}.get(host.machine(), host.machine())
    return f"{machine}-{system}"


def _flash(library: str) -> str:
    """How large the code of a library is, as ``size`` of the binutils says."""
    tool = shutil.which("size")
    if tool is None:
        return "flash not measured: there is no program size here"
    said = subprocess.run([tool, str(Path(library))], capture_output=True, text=True, check=False).stdout.splitlines()
    return f"flash {said[-1].split()[0]} bytes of code and constants (-Os, this machine)" if said else "flash unknown"
