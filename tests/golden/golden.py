"""The golden record: what the program answers, number by number, so that moves and replacements can be held against it.

``python -m tests.golden.golden check`` computes everything anew and compares it with the JSON files beside this one;
``record`` writes these files. ``--sections scenes,code`` takes only some; ``--exact FILE`` compares bit for bit with
what an earlier call wrote into that scratch file, on the same machine. Only the public door is used:
``import softcat_sym``, and the ``softcat`` command line with its files.
"""

from __future__ import annotations

import argparse
import csv
import hashlib
import json
import math
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import softcat_sym as sc
from tests.test_generated_folder import without_numbers

# Whoever renames a key, an option or a folder of the program changes these tables, and nothing else here.

RENAMED = {"missing_effect": "overlooked"}
"""Keys of results (JSON, CSV, netCDF) as they are called now: as they were called when the record was taken."""

OPTIONS = {"no_profiles": "--no-profile-likelihood", "max_sag": "--sag"}
"""Command-line options that may get another name."""

PROGRAM = "from softcat_sym.cli import main; main()"
"""The `softcat` command of the interpreter that runs this."""
SAMPLES = Path(sc.__file__).parent / "samples"
"""Where the film, the flow curve and the ink are that come with the package."""

COMPILED, SOURCES = "native", "texts"
"""What of the cache may be used again, but for the sources where they are the subject; finished runs may not."""

WORDS = {
    *("arrested", "backend", "best", "clamp", "closure", "converged", "damping", "handed_on", "holds", "key", "law"),
    *("mark", "mode", "outcome", "regime", "solver", "verdict"),
}
"""Keys whose text is an answer; all other text may be reworded."""

TABLES = {"effects"}
"""Keys whose own keys or entries are the answer, whatever text stands under them."""

SKIPPED = {
    *("digest", "geometry", "memory", "members_per_second", "path", "peak_memory_MB", "place", "processor_s"),
    *("resumed_members", "schema", "seconds", "solve_s", "time_ratio", "versions", "wall_s", "workers"),
}
"""Keys of times, of memory and of the machine."""

TOLERANCE = {"scenes": 1e-8, "accuracy": 1e-8, "fits": 1e-8, "studies": 1e-8, "elements": 1e-8, "code": 0.0}
"""Largest difference allowed, relative to the largest value of an array."""

ROUNDING = {"energy_residual": 1e-10, "energy_error": 1e-10, "drift": 1e-10, "rate": 1e-12}
"""Values that are small differences of large ones: what counts as nothing."""
FLOOR = 1e-15
"""As much for all others."""

SMALL = {"numerics.cells": 8, "numerics.estimate": False, "run.frames": 41}
"""Coarse and once: where neither the resolution nor the error estimate is the subject."""

HERE = Path(__file__).parent
SHOWN, MOST = 21, 45
"""Of an array of more than the latter, the former are recorded, and its norm."""

Value = float | str | list[float] | None
Case = dict[str, Value]


def leaves(thing: object, path: str = "") -> Iterator[tuple[str, Any]]:
    """Every number, list of numbers and telling word of a JSON document, with its path."""
    key = path.rpartition("/")[2]
    if key in TABLES and isinstance(thing, Mapping | list) and all(isinstance(name, str) for name in thing):
        yield path, " ".join(sorted(thing))
    elif isinstance(thing, Mapping):
        for name, part in thing.items():
            if name not in SKIPPED:
                old = RENAMED.get(str(name), str(name))
                yield from leaves(part, f"{path}/{old}" if path else old)
    elif isinstance(thing, str):
        if key in WORDS:
            yield path, thing.split(":")[0]
    elif isinstance(thing, bool):
        yield path, str(thing)
    elif thing is None or isinstance(thing, int | float):
        yield path, thing
    elif isinstance(thing, Sequence):
        if thing and all(isinstance(part, int | float) and not isinstance(part, bool) for part in thing):
            yield path, list(thing)
        else:
            for number, part in enumerate(thing):
                yield from leaves(part, f"{path}/{number}")


def column(path: str, values: object) -> Iterator[tuple[str, Any]]:
    """An array: whole if it is short, otherwise some of it, and its norm."""
    array = np.asarray(values, dtype=float).ravel()
    if array.size <= MOST:
        yield path, array.tolist()
        return
    yield path, array[np.linspace(0, array.size - 1, SHOWN).round().astype(int)].tolist()
    yield f"{path}#norm", float(np.sqrt(np.nanmean(array**2)))
    yield f"{path}#size", array.size


def table(file: Path) -> Iterator[tuple[str, Any]]:
    """The columns of a CSV file: numbers, and words that tell something."""
    with file.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for name in rows[0] if rows else ():
        bare = name.partition(" [")[0]
        path = f"{file.name}/{RENAMED.get(bare, bare)}"
        cells = [row[name] for row in rows]
        if bare in SKIPPED:
            continue
        try:
            yield from column(path, [float(cell) if cell else math.nan for cell in cells])
        except ValueError:
            if bare in WORDS:
                yield path, " ".join(cells)


def answer(run: sc.Run) -> Case:
    """What a run shows: its midpoint, sizes of all it holds half-way and at the end, and its summary."""
    found: dict[str, Any] = dict(leaves(run.summary))
    found |= dict(column("midpoint", run.data["midpoint"].values[:: max(1, (run.data.sizes["time"] - 1) // 20)]))
    for name, values in run.data.data_vars.items():
        if "time" in values.dims and values.dtype.kind == "f" and name != "midpoint":
            frames = np.atleast_2d(values.transpose("time", ...).values.reshape(values.sizes["time"], -1))
            sizes = [float(np.sqrt(np.mean(frames[at] ** 2))) for at in (len(frames) // 2, -1)]
            found[f"sizes/{RENAMED.get(str(name), str(name))}"] = sizes
    return found


def run(scene: str, changes: Mapping[str, object]) -> Case:
    """Run a scene; warnings are texts, and left out."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return answer(sc.simulate(sc.load_scene(scene, changes)))


class Commands:
    """The ``softcat`` command line, in a folder that is thrown away."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def __call__(self, name: str, *arguments: object, changes: Mapping[str, object] | None = None) -> Path:
        """Run a command; return the folder that it wrote."""
        sets = [text for key, value in (changes or {}).items() for text in ("--set", f"{key}={json.dumps(value)}")]
        command = [sys.executable, "-c", PROGRAM, *map(str, arguments), *sets, "-q", "-o", name]
        done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=self.folder)
        if done.returncode not in (0, 1) or not (self.folder / name).is_dir():
            raise RuntimeError(f"{' '.join(command[3:])} ended with {done.returncode}:\n{done.stderr}")
        return self.folder / name


def files(folder: Path, *names: str) -> Case:
    """What the JSON and CSV files of a command hold."""
    found: dict[str, Any] = {}
    for name in names:
        file = folder / name
        found |= dict(table(file) if file.suffix == ".csv" else leaves(json.loads(file.read_text(encoding="utf-8"))))
    return found


def scenes(_: Commands) -> Iterator[tuple[str, Case]]:
    """Every bundled scene on both backends, coarsely; and other effects, orders, closures and integrators."""
    for name in sc.bundled_names():
        # With fewer cells than 16 the turns of a coil are refused.
        small = {**SMALL, "numerics.cells": 16} if name == "coil-spring" else SMALL
        for backend in ("interpreted", "compiled"):
            yield f"{name}, {backend}", run(name, {**small, "numerics.backend": backend})
    others: dict[str, dict[str, object]] = {
        "paper": {"run.effects": "paper"},
        "printed": {"run.effects": "paper", "run.closure": "printed"},
        "order 1": {"numerics.order": 1},
        "cvodes": {"run.effects": "paper", "numerics.solver": "cvodes"},
        "idas": {"numerics.solver": "idas"},
        "pinned": {"ends.left": "pinned", "ends.right": "pinned"},
        "until settled": {"run.until": "settled"},
    }
    for name, changes in others.items():
        yield f"arrested-overdamped, {name}", run("arrested-overdamped", {**SMALL, **changes})
    deflection = {**SMALL, "model": "small-deflection"}
    yield "maxwell-slow, small-deflection", run("maxwell-slow", deflection)


def accuracy(_: Commands) -> Iterator[tuple[str, Case]]:
    """Some scenes exactly as they stand, with the error estimate and the refinement it asks for."""
    for name in ("arrested-overdamped", "cold-honey", "glass-rod", "ink-bridge", "silicone-thread", "toothpaste"):
        yield name, run(name, {})


def film(file: Path) -> None:
    """Write a film of a ringing Maxwell filament, with an error of reading that is the same on every machine."""
    seen = sc.simulate(sc.load_scene("maxwell-fast", RINGING | {"run.frames": 61})).data
    time, height = seen["time"].values, seen["midpoint"].values
    noise = 2e-5 * np.sin(np.arange(len(time)) ** 2 * 1.7)
    rows = "".join(f"{t!r},{y!r}\n" for t, y in zip(time.tolist(), (height + noise).round(9).tolist(), strict=True))
    file.write_text(f"time_s,midpoint_m\n{rows}", encoding="utf-8")


FILMED = {"numerics.cells": 8, "numerics.estimate": False, "run.effects": "paper"}
RINGING = {**FILMED, "run.duration": "1.2 s"}


def fits(softcat: Commands) -> Iterator[tuple[str, Case]]:
    """A fit of each kind, a flow curve, and the design of an experiment."""
    maxwell, ink = softcat.folder / "maxwell.csv", SAMPLES / "my-ink.toml"
    film(maxwell)
    two = ("--free", "youngs_modulus", "--free", "viscosity")
    plain = OPTIONS["no_profiles"]
    done = softcat("profiles", "fit", maxwell, "--scene", "maxwell-fast", *two, "--starts", 0, changes=RINGING)
    yield "Maxwell, closed form and profiles", files(done, "fit.json", "fit.csv")
    three = ("--free", "yield_stress", "--free", "viscosity", "--starts", 0, plain)
    done = softcat("ink", "fit", SAMPLES / "film.csv", "--scene", ink, *three, changes=FILMED)
    yield "ink", files(done, "fit.json", "fit.csv")
    laws = ("--law", "maxwell", "--law", "kelvin-voigt", "--starts", 0, plain)
    done = softcat("laws", "fit", maxwell, "--scene", "maxwell-fast", *laws, changes=RINGING)
    yield "two laws", files(done, "fit.json", "laws.csv")
    done = softcat("curve", "flow-curve", SAMPLES / "my-curve.csv", "--scene", ink)
    yield "flow curve", files(done, "flow_curve.json", "flow_curve.csv")
    design = ("--free", "viscosity", "--noise", "10 um", "--span", "60:100 mm")
    done = softcat("experiment", "experiment", "cold-honey", *design, changes={**FILMED, "run.frames": 21})
    yield "experiment", files(done, "experiment.json", "experiment.csv")


def studies(softcat: Commands) -> Iterator[tuple[str, Case]]:
    """Sweeps, a phase diagram, a card, what effects are worth, what a scene calls for."""
    vary = ("--vary", "filament.thickness=4:8 mm:3", "--vary", "material.yield_stress=5:12 kPa:3", "--workers", 1)
    done = softcat("sweep", "sweep", "arrested-overdamped", *vary, changes=SMALL)
    yield "sweep", files(done, "sweep.json", "sweep.csv")
    cube = ("--vary", "filament.span=60:100 mm", "--mode", "lhs", "--samples", 5, "--seed", 3, "--workers", 1)
    done = softcat("hypercube", "sweep", "cold-honey", *cube, changes=SMALL)
    yield "sweep, hypercube", files(done, "sweep.json", "sweep.csv")
    many = {"material.viscosity": [20.0, 30.0, 40.0]}
    found = sc.simulate_many(sc.load_scene("cold-honey", SMALL), many, workers=1)
    yield "many", dict(column("midpoint", found.data["midpoint"].values))
    phase = ("phase", "--plane", "G-delta", "--plane", "G-V", "--resolution", 4, "--workers", 1)
    done = softcat("phase", *phase, changes={"numerics.cells": 8})
    yield "phase", files(done, "phase.json", "phase_runs.csv", "phase_boundaries.csv", "phase_lines.csv")
    coarse = {"numerics.cells": 8, "run.frames": 41, "run.effects": "paper"}
    done = softcat("card", "card", "ink-bridge", OPTIONS["max_sag"], "5 %", changes=coarse)
    yield "card", files(done, "card.json", "card.csv")
    done = softcat("effects", "effects", "no-yield", changes={"numerics.cells": 8, "run.frames": 21})
    yield "effects", files(done, "effects.json")
    for name in ("ink-bridge", "drawn-blob"):
        yield f"explain {name}", files(softcat(f"explain-{name}", "explain", name), "explain.json")


def elements(softcat: Commands) -> Iterator[tuple[str, Case]]:
    """The filament beside finite elements."""
    short = {"run.duration": "0.3 s", "numerics.cells": 8}
    done = softcat("compare", "compare", "arrested-overdamped", "--mesh", "16x2", changes=short)
    names = ("compare.json", "compare_midpoint.csv", "compare_clamp_strain.csv", "compare_shapes.csv")
    yield "Bingham", files(done, *names)
    done = softcat("maxwell", "compare", "maxwell-slow", "--mesh", "8x2", "--fixed-face", changes=short)
    yield "Maxwell, fixed face", files(done, *names)


def code(softcat: Commands) -> Iterator[tuple[str, Case]]:
    """Generated C of every bundled scene without its comments, which may be reworded."""
    for name in sc.bundled_names():
        if sc.load_scene(name).extrusion.present:
            continue  # It has no program of its own
        more = ("--rhs",) if name == "glass-rod" else ()
        done = softcat(name, "generate", name, *more)
        sources = sorted(path for path in done.iterdir() if path.suffix in {".c", ".h"})
        yield name, {path.name: digest(path.read_text(encoding="utf-8")) for path in sources}


def digest(source: str) -> str:
    """Of a C source without comments, blanks and computed numbers, whose last digits another libm has otherwise."""
    bare, _ = without_numbers(re.sub(r"/\*.*?\*/|//[^\n]*", " ", source, flags=re.DOTALL))
    return hashlib.sha256(bare.encode()).hexdigest()[:16]


SECTIONS: dict[str, Callable[[Commands], Iterator[tuple[str, Case]]]] = {
    "scenes": scenes,
    "accuracy": accuracy,
    "fits": fits,
    "studies": studies,
    "elements": elements,
    "code": code,
}


def difference(path: str, found: object, kept: object) -> float:
    """Of two values, relative to the largest; infinite where they cannot be compared."""
    if isinstance(found, str) or isinstance(kept, str) or found is None or kept is None:
        return 0.0 if found == kept else math.inf
    one, other = np.atleast_1d(np.asarray(found, float)), np.atleast_1d(np.asarray(kept, float))
    if one.shape != other.shape or not np.array_equal(np.isfinite(one), np.isfinite(other)):
        return math.inf
    finite = np.isfinite(one)
    if not np.array_equal(one[~finite], other[~finite], equal_nan=True):
        return math.inf
    apart = np.max(np.abs(one - other)[finite], initial=0.0)
    nothing = ROUNDING.get(path.rpartition("/")[2], FLOOR)
    if apart <= nothing:
        return 0.0
    return float(apart / np.max(np.abs(other)[finite], initial=nothing))


def compared(section: str, name: str, found: Case | None, kept: Case | None) -> bool:
    """Print a case against the record; what is new in it does not count, what is missing does."""
    worst, where, tolerance = math.inf, "not computed" if found is None else "not recorded", TOLERANCE[section]
    if found is not None and kept is not None:
        apart = {path: difference(path, found[path], kept[path]) if path in found else math.inf for path in kept}
        where, worst = max(apart.items(), key=lambda item: item[1], default=("", 0.0))
        wrong = sum(value > tolerance for value in apart.values())
        where += f" and {wrong - 1} more" if wrong > 1 else ""
    verdict = "ok" if worst <= tolerance else f"DIFFERS in {where}"
    print(f"{section:9} {name:44} {len(kept or ()):5} {worst:9.1e}  {verdict}", flush=True)
    return worst <= tolerance


def rounded(value: object) -> object:
    """Twelve significant digits; what is no number in JSON becomes text."""
    if isinstance(value, list):
        return [rounded(part) for part in value]
    if isinstance(value, float):
        return float(f"{value:.12g}")
    return value


def cases(section: str) -> dict[str, Case]:
    """Compute a section; nothing that was finished earlier is used again."""
    cache, used_again = Path(os.environ["SOFTCAT_CACHE"]), {COMPILED} if section == "code" else {COMPILED, SOURCES}
    for path in cache.iterdir() if cache.is_dir() else ():
        if path.name not in used_again:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    with tempfile.TemporaryDirectory() as folder:
        return dict(SECTIONS[section](Commands(Path(folder))))


def spent() -> float:
    """Processor seconds of this process and of those it has waited for."""
    both = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(each.ru_utime + each.ru_stime for each in both)


def bitwise(file: Path, found: dict[str, dict[str, Case]]) -> list[str]:
    """What differs in any bit from what the file holds; a section that it does not hold is written into it."""
    kept = json.loads(file.read_text(encoding="utf-8")) if file.is_file() else {}
    exact = json.loads(json.dumps(found))
    wrong = []
    for section in exact.keys() & kept.keys():
        for name in exact[section].keys() | kept[section].keys():
            one, other = exact[section].get(name, {}), kept[section].get(name, {})
            paths = sorted(path for path in one.keys() | other.keys() if repr(one.get(path)) != repr(other.get(path)))
            wrong += [f"{section}, {name}: {path}: {other.get(path)} is now {one.get(path)}" for path in paths]
    file.write_text(json.dumps(exact | kept), encoding="utf-8")
    return sorted(wrong)


def check(sections: Sequence[str], exact: Path | None = None, record: bool = False) -> bool:
    """Compute sections, print how they compare with the record (or record them); return whether all is as it was."""
    fine, wrong = True, list[str]()
    for section in sections:
        file, begun = HERE / f"{section}.json", spent()
        found = cases(section)
        if record:
            kept = {name: {path: rounded(value) for path, value in case.items()} for name, case in found.items()}
            lines = [f" {json.dumps(name)}: {json.dumps(case)}" for name, case in kept.items()]
            file.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
        kept = json.loads(file.read_text(encoding="utf-8"))
        for name in dict.fromkeys([*kept, *found]):
            fine = compared(section, name, found.get(name), kept.get(name)) and fine
        print(f"{section:9} took {spent() - begun:.0f} s of the processor", flush=True)
        wrong += bitwise(exact, {section: found}) if exact else []
    if exact:
        print("\n".join(wrong) or "bit for bit as in the file, where that held the section")
    return fine and not wrong


def main() -> int:
    """Read the command line."""
    parser = argparse.ArgumentParser(prog="python -m tests.golden.golden", description=__doc__)
    parser.add_argument("mode", nargs="?", choices=("check", "record"), default="check")
    parser.add_argument("--sections", default=",".join(SECTIONS), help="some of: %(default)s")
    parser.add_argument("--exact", type=Path, metavar="FILE", help="write full precision there, or compare with it")
    asked = parser.parse_args()
    sections = asked.sections.split(",")
    if unknown := set(sections) - set(SECTIONS):
        parser.error(f"no section {', '.join(sorted(unknown))}; there are {', '.join(SECTIONS)}")
    base = Path(os.environ.get("SOFTCAT_CACHE") or Path(tempfile.gettempdir()) / f"softcat-{os.getuid()}")
    os.environ |= {"SOFTCAT_CACHE": str(base / "golden"), "OMP_NUM_THREADS": "1", "MPLBACKEND": "agg"}
    return 0 if check(sections, asked.exact, asked.mode == "record") else 1


if __name__ == "__main__":
    sys.exit(main())
