"""``softcat doctor``: installed packages, and a test of the installation."""

from __future__ import annotations

import os
import platform
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata
from shutil import get_terminal_size
from textwrap import TextWrapper
from time import perf_counter
from typing import TYPE_CHECKING

import typer

from softcat_sym import cache
from softcat_sym.cli import application as cli
from softcat_sym.errors import SoftcatError
from softcat_sym.lazy import lazy_imports
from softcat_sym.progress import StudyDisplay
from softcat_sym.simulate import simulated

if TYPE_CHECKING:
    from softcat_sym.scene.scene import Scene

with lazy_imports():
    from packaging import requirements

    from softcat_sym import store
    from softcat_sym.batch import executor
    from softcat_sym.codegen import compiler as compilers
    from softcat_sym.codegen import library as libraries
    from softcat_sym.scene import reading

_SCENE, _CELLS, _TOLERANCE = "beam-viscometer", 20, 2e-3


@dataclass(frozen=True, slots=True)
class Check:
    """Result of one check."""

    name: str
    text: str
    remedy: str = ""  # Advice to the user; empty if none is needed
    is_fault: bool = False  # Whether the package does not work without the remedy


def doctor(quiet: cli.QuietOption = False) -> None:
    """Check the installation, the compiler and the cache, and run a test.

    The test runs a bundled scene, interpreted and compiled, and compares its sag with the exact one of a viscous beam.
    Exit status: 0 if all works, 1 if something that is needed does not. A missing extra or compiler is no fault: runs
    without a compiler are interpreted, and slower. --quiet prints faults only.
    """
    faults = 0
    for finding in _findings(quiet=quiet):
        faults += finding.is_fault
        if not quiet:
            option = f"; to have it: {finding.remedy}" if finding.remedy and not finding.is_fault else ""
            _say(finding.name, finding.text + option)
            if finding.is_fault:
                _say("", f"remedy: {finding.remedy}")
        elif finding.is_fault:
            cli.print_error(f"{finding.name}: {finding.text}; {finding.remedy}")
    if not quiet:
        _say("result", f"faults: {faults}; each has its remedy above" if faults else "everything works")
    if faults:
        raise typer.Exit(cli.UNTRUSTED)


def _say(name: str, text: str) -> None:
    width = max(get_terminal_size().columns, 60) - 2
    wrapper = TextWrapper(width, initial_indent=f"{name:12}", subsequent_indent=" " * 12)
    wrapper.break_long_words = wrapper.break_on_hyphens = False
    typer.echo(wrapper.fill(text))


def _findings(*, quiet: bool) -> Iterator[Check]:
    packages = list(_packages())
    cores = f"{executor.worker_count(None)} of {os.cpu_count()} processors"
    system = f"{platform.system()} {platform.machine()}"
    yield from (Check("python", f"{platform.python_version()} on {system}, {cores} ({sys.executable})"), *packages)
    if any(finding.is_fault for finding in packages):
        yield Check("self-test", "not run, since required packages are missing or too old")
        return
    compiler, kept = _compiler(), _cache()
    yield from (compiler, kept)
    if not kept.is_fault:
        found, place = cache.entries(cache.RESULTS), cache.folder(cache.RESULTS)
        size, limit = libraries.size_text(sum(entry.size for entry in found)), libraries.size_text(store.LIMIT)
        yield Check("results", f"{place}, {len(found)} of studies, {size} of at most {limit}")
    yield _tested("interpreted", quiet=quiet)
    if compiler.remedy or kept.is_fault:
        yield Check("self-test", f"compiled: not run, see {'compiler' if compiler.remedy else 'cache'}")
    else:
        yield _tested("compiled", quiet=quiet)


def _packages() -> Iterator[Check]:
    """The package, its requirements, and each extra; missing or old packages have the command that installs them."""
    about = metadata.metadata("softcat_sym")
    required = [requirements.Requirement(text) for text in metadata.requires("softcat_sym") or ()]
    yield Check("softcat_sym", about["Version"])
    for extra in ("", *about.get_all("Provides-Extra", ())):
        found, lacking = [], []
        for each in required:
            always = each.marker is None or each.marker.evaluate({"extra": ""})
            if always is bool(extra) or (each.marker is not None and not each.marker.evaluate({"extra": extra})):
                continue
            try:
                version = metadata.version(each.name)
            except metadata.PackageNotFoundError:
                version = ""
            fits = bool(version) and each.specifier.contains(version, prereleases=True)
            found.append(f"{each.name} {version or 'missing'}{f' ({each.specifier})' if version and not fits else ''}")
            lacking += [] if fits else [f"{each.name}{each.specifier}"]
        line = f"pip install 'softcat_sym[{extra}]'" if extra else f"pip install {' '.join(map(repr, lacking))}"
        name, is_fault = f"[{extra}]" if extra else "required", bool(lacking) and not extra
        yield Check(name, ", ".join(found), line if lacking else "", is_fault)


def _compiler() -> Check:
    """The C compiler, tested on a short function with the flags of a run."""
    try:
        found = compilers.find_compiler()
        if found is None:
            named = os.environ.get("CC", "")
            text = f"CC is {named!r}, which is no C compiler that runs" if named else "none: runs are interpreted"
            return Check("compiler", text, compilers.TO_INSTALL, bool(named))
        libraries.check_compiler(found)
    except (SoftcatError, OSError) as error:
        return Check("compiler", str(error), "set CC to a compiler that works, or look at SOFTCAT_CFLAGS", True)
    return Check("compiler", f"{found.name}, which compiles ({' '.join(found.command)})")


def _cache() -> Check:
    """The folder of the cache, whether it can be used, and how much compiled libraries take."""
    try:
        folder, limit = cache.cache_folder(), libraries.size_text(libraries.cache_limit())
        for kind in cache.KINDS:
            if reason := cache.problem(kind):
                return Check("cache", f"{cache.folder(kind)} cannot be used: {reason}", cache.ADVICE, True)
        with cache.passing(cache.folder(cache.LIBRARIES), 64 * "0") as passing:
            passing.touch()
        size = libraries.size_text(sum(entry.size for entry in cache.entries(cache.LIBRARIES)))
    except SoftcatError as error:
        return Check("cache", str(error), "correct the variable", True)
    except OSError as error:
        return Check("cache", f"{folder} cannot be written: {error.strerror or error}", cache.ADVICE, True)
    return Check("cache", f"{folder}, can be written; compiled libraries take {size} of at most {limit}")


def _tested(backend: str, *, quiet: bool) -> Check:
    """A run of a bundled scene against the exact sag."""
    began, advice = perf_counter(), "install softcat_sym again; if that does not help, report it with these lines"
    try:
        with StudyDisplay(quiet=quiet) as progress:
            progress.stage(f"self-test, {backend}")
            changes = {"numerics.cells": _CELLS, "numerics.estimate": False, "numerics.backend": backend}
            scene = reading.load_scene(_SCENE, changes)
            found, exact = -float(simulated(scene, progress).data.midpoint.values[-1]), exact_sag(scene)
    except (SoftcatError, ImportError, OSError, RuntimeError) as error:
        return Check("self-test", f"{backend}: {error}", advice, True)
    text = f"{backend}: sag {1e6 * found:.3f} um, exact {1e6 * exact:.3f} um ({perf_counter() - began:.1f} s)"
    is_fault = not abs(found / exact - 1) < _TOLERANCE
    return Check("self-test", text, advice if is_fault else "", is_fault)


def exact_sag(scene: Scene) -> float:
    """Sag at the end [m] of a viscous bar between pins, with a weight at its middle.

    It is the exact small deflection of a Timoshenko beam, with rates in place of deflections; the bending part is the
    formula of ASTM C598.
    """
    part, gravity = scene.filament, scene.load.gravity
    span, area, second_moment = part.span, part.thickness**2, part.thickness**4 / 12
    viscosity = float(scene.material.viscosity or "nan")
    bending, shear = viscosity * second_moment, 5 / 6 * viscosity / 3 * area
    weight, hung = part.density * area * gravity, gravity * scene.load.point_mass
    rate = hung * span**3 / (48 * bending) + 5 * weight * span**4 / (384 * bending)
    rate += (hung * span / 4 + weight * span**2 / 8) / shear
    return scene.run.duration * rate
