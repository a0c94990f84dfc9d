"""Generated folders, built as a user builds them but with every warning an error and under sanitizers."""

from __future__ import annotations

import subprocess
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import numpy as np

import softcat_sym as sc
from softcat_sym.codegen.compiler import find_compiler
from softcat_sym.codegen.export import runtime_files
from softcat_sym.discretization.grid import Floats
from softcat_sym.effects.choosing import choose_effects
from softcat_sym.scene.scene import Scene
from softcat_sym.single_run import build
from softcat_sym.solvers.solution import Silence

PROGRAMS = Path(__file__).parent / "programs"
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic")
SANITIZED = ("-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
TIGHT = {"numerics.rtol": 1e-7, "run.frames": 11}


def compiled(*arguments: object) -> None:
    """Call the C compiler, which must have nothing to say."""
    compiler = find_compiler()
    assert compiler is not None
    command = [*compiler.command, *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert not done.stderr


@dataclass(frozen=True)
class Program:
    """A built program."""

    path: Path

    def __call__(self, *arguments: object) -> subprocess.CompletedProcess[str]:
        return subprocess.run([str(self.path), *map(str, arguments)], capture_output=True, text=True, check=False)

    def table(self, *arguments: object) -> Floats:
        """The numbers that it prints as CSV, below a heading."""
        done = self(*arguments)
        assert done.returncode == 0, done.stderr
        return np.array([[float(cell) for cell in line.split(",")] for line in done.stdout.splitlines()[1:]])


@dataclass(frozen=True)
class Workshop:
    """Where things are built; the runtime is compiled once."""

    root: Path

    @cache  # noqa: B019 (lives as long as the tests do)
    def runtime(self) -> Path:
        """The library of the C that is the same for all filaments."""
        folder = self.root / "runtime"
        folder.mkdir()
        for name, text in runtime_files().items():
            (folder / name).write_text(text, encoding="utf-8")
        for source in sorted(folder.glob("*.c")):
            compiled(*STRICT, *SANITIZED, "-c", source, "-o", source.with_suffix(".o"))
        library = folder / "libsoftcat.a"
        subprocess.run(["ar", "rcs", library, *sorted(folder.glob("*.o"))], check=True)
        return library

    @cache  # noqa: B019
    def folder(self, scene: Scene, name: str = "filament") -> Path:
        """The scene, generated."""
        folder = self.root / f"{abs(hash(scene)):x}-{name}"
        sc.generate(scene, folder, name=name)
        compiled(*STRICT, *SANITIZED, "-c", folder / f"{name}.c", "-o", folder / f"{name}.o")
        return folder

    def program(self, scene: Scene, main: Path | None = None) -> Program:
        """The program of a scene, with its own main or another."""
        folder = self.folder(scene)
        source = main or folder / "main.c"
        built = folder / source.stem
        if not built.exists():
            compiled(
                *STRICT, *SANITIZED, f"-I{folder}", source, folder / "filament.o", self.runtime(), "-lm", "-o", built
            )
        return Program(built)


def interpreted(scene: Scene) -> tuple[Floats, Floats, Floats]:
    """Times [s], and x and y [m] of the nodes, by CasADi's own integrator."""
    asked = scene.replace({"numerics.backend": "interpreted", "numerics.solver": "rosenbrock"})
    prepared = build(asked, choose_effects(asked))
    solution = prepared.solve(Silence())
    assert solution.outcome.is_success, solution.message
    seen = prepared.graph.observe(solution.time, solution.x, solution.z, prepared.p)
    return solution.time * prepared.scale, seen["x"], seen["y"]
