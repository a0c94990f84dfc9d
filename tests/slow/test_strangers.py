"""What strangers met: every point of their reports, with what happens now, as one table.

`pytest -m slow tests/slow/test_strangers.py` prints the table after the last test.
"""

from __future__ import annotations

import re
import resource
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.measurements import Measurements
from tests.common.filmed import film, scene
from tests.common.table import rows_of

pytestmark = pytest.mark.slow

Says = Callable[..., None]
CASES = Path(__file__).parents[1] / "cases"
PROGRAM = Path(sys.executable).with_name("softcat")


@dataclass(frozen=True)
class Timed:
    """A command that has ended."""

    status: int
    out: str
    err: str
    seconds: float  # Of the processor


def timed(*arguments: str) -> Timed:
    """Run ``softcat``."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False, timeout=300)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    return Timed(done.returncode, done.stdout, done.stderr, seconds)


@pytest.fixture(scope="module")
def says(request: pytest.FixtureRequest) -> Iterator[Says]:
    """Take a row of the table: the point, what was met, what happens now."""
    rows = list[tuple[str, str, str]]()

    def say(point: str, met: str, now: object) -> None:
        rows.append((point, met, str(now)))

    yield say
    lines = rows_of(("point", "what strangers met", "what happens now"), sorted(rows))
    terminal = request.config.pluginmanager.getplugin("terminalreporter")
    for line in ("", *lines) if terminal is not None else ():
        terminal.write_line(line)


# --- A: checks on random draws


# --- B1: the regime does not depend on the frames


# --- B2: a creep is not a swing


# --- B3: errors are relative to the largest displacement


# --- B4: natural frequencies of what hangs slack


# --- B5: polymer threads


# --- B6: the time of breaking


# --- B7: what a fit calls identified


# --- B8: what explain says an effect is worth


# --- B9: the error of the slender theory


# --- C1: the price of a run is said before it starts


def test_a_long_run_tells_its_price_before_it_begins(says: Says, tmp_path: Path) -> None:
    """The number that explain prints; the run is ended then, long before its four hundred million seconds."""
    scene = str(CASES / "beam-for-50000-years.toml")
    # This makes the equations, which the run then finds in the cache.
    explained = timed("explain", scene)
    ended = timed("run", scene, "-q", "-o", str(tmp_path / "out"), "--time-limit", "15")
    price = re.search(r"about (\S+) s of the\s+processor", " ".join(explained.out.split()))
    assert price is not None and float(price[1]) > 1e8
    assert f"this run takes long: it rings some 23632115370 periods of 66.8 s: about {price[1]} s" in ended.err
    assert "load.ramp" in ended.err and "--time-limit" in ended.err and ended.status == 1
    says("C1", "beam-for-50000-years.toml starts what takes 4e8 s and says nothing", ended.err.split(";")[0])


# --- C2: a run that falls for ever ends


@pytest.mark.parametrize("name", ["runaway-concrete", "runaway-chocolate"])
def test_a_run_that_falls_for_ever_ends(says: Says, name: str, tmp_path: Path) -> None:
    done = timed("run", str(CASES / f"{name}.toml"), "-q", "-o", str(tmp_path))
    run = sc.open_run(tmp_path)
    end, span = run.summary["descends"], run.scene.filament.span
    assert done.status == 1 and run.outcome is sc.Outcome.descends and len(run.fields["time"]) > 190
    assert done.seconds < 10 and end["rate_m_per_s"] < 0 and -10 < end["midpoint_m"] / span < -4
    met = "63 s of the processor and killed, nothing written" if name == "runaway-concrete" else "alike"
    says("C2", f"{name}.toml: {met}", f"descends after {end['time_s']:.3g} s, in {done.seconds:.1f} s of the processor")


def test_a_neck_that_goes_on_for_ever_ends(says: Says) -> None:
    """G = 0.83: a catenary would bear it, but its clamps are drawn out."""
    begun = time.process_time()
    changes = ["material.shear_yield_stress=3 kPa", "numerics.cells=10", "numerics.estimate=false"]
    run = sc.simulate(sc.load_scene(CASES / "runaway-concrete.toml", changes))
    spent = time.process_time() - begun
    assert run.outcome in (sc.Outcome.localised, sc.Outcome.ruptured) and spent < 20
    says("C2", "a strand whose clamps neck runs on for minutes", f"{run.outcome.name}, in {spent:.1f} s")


# --- C3: time limits and interrupts

LONG = ("--set", "run.duration=10 min", "--set", "run.frames=20001", "--set", "numerics.cells=20")
LASTING: dict[str, tuple[str, ...]] = {
    "run": ("no-yield", *LONG),
    "card": ("no-yield", *LONG),
    "effects": ("no-yield", "--fresh", *LONG),
    "accuracy": ("no-yield", *LONG),
    "compare": ("no-yield", *LONG),
    "validate": ("--fresh",),
    "figures": ("--fresh",),
    "phase": ("--fresh",),
}


@pytest.mark.parametrize("command", LASTING)
def test_a_time_limit_ends_a_command(says: Says, command: str, tmp_path: Path) -> None:
    limit = "15" if command == "run" else "4"
    done = timed(command, *LASTING[command], "-q", "-o", str(tmp_path / "out"), "--time-limit", limit)
    assert done.status == 1 and f"softcat: the time limit of {limit} s is over" in done.err
    assert "Traceback" not in done.err
    left = sorted(path.name for path in (tmp_path / "out").iterdir()) if (tmp_path / "out").exists() else []
    if command == "run":
        assert left == ["scene.toml", "summary.json", "trajectory.nc"]
        assert sc.open_run(tmp_path / "out").outcome is sc.Outcome.interrupted
    says(
        "C3",
        f"softcat {command} --time-limit {limit}: no such option",
        f"status 1, {', '.join(left) or 'nothing written'}",
    )


# --- C4: helices and histories are bounded when a scene is read


# --- C5: time limits of fits


def test_a_fit_ends_within_a_tenth_of_its_limit(says: Says) -> None:
    """On a grid whose single evaluations take seconds: the limit is reached amid one, or a better grid is built."""
    limit, known = 8.0, {"numerics.cells": 160, "numerics.rtol": 1e-8}
    data, free, fit = Measurements.of(*film()), ["viscosity", "yield_stress"], sc.fit
    begun = time.monotonic()
    try:
        found = fit(data, scene().replace(known), free, time_limit=limit)
        how = found.outcome.word
    except SoftcatError as error:
        how = str(error)
    spent = time.monotonic() - begun
    # And what a compiler takes, which is waited for.
    assert spent < 1.1 * limit + 4
    says("C5", "fit --time-limit 40 took 78 s", f"{spent:.1f} s for {limit:g} s: {how}")


# --- D1: clearing the cache leaves the user's files alone


# --- D2: nobody else's code or results are loaded


# --- D3: a full disk is no crash
