"""How long a fit takes, libraries compiled: the goals and what is reached.

``python -m pytest -s -m slow tests/slow/test_fit_times.py`` prints the table.
"""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.fitting.fit import fit
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.result import Fit
from tests.common.draws import draws, misses
from tests.common.fitting import WRONG, beside
from tests.common.table import show

pytestmark = pytest.mark.slow

FILMS = {
    "continual-descent": ("viscosity", "yield_stress", "youngs_modulus"),
    "arrested-overdamped": ("viscosity", "yield_stress", "youngs_modulus"),
    "maxwell-slow": ("youngs_modulus", "viscosity"),
}
# Seconds of two, of three constants without profiles, and with them.
GOALS = {"auto": (2.0, 5.0, 20.0), "paper": (0.5, 1.0, 5.0)}
# Seconds on the slowest of the machines tried, where the goal is missed there; a fit may take twice as long.
REACHED = {
    ("arrested-overdamped", "auto"): (4.2, 8.0, 41.0),
    ("maxwell-slow", "auto"): (2.5,),
    ("continual-descent", "paper"): (0.9, 1.0, 10.0),
    ("arrested-overdamped", "paper"): (2.7, 7.2, 53.0),
    ("maxwell-slow", "paper"): (4.1,),
}
FRAMES, NOISE = 200, 0.01


def _timed(
    film: Measurements, scene: sc.Scene, free: Sequence[str], seed: int, *, profiles: bool
) -> tuple[Fit, float, float]:
    begin, processor = time.perf_counter(), time.process_time()
    found = fit(film, beside(scene, {name: WRONG[name] for name in free}), free, profiles=profiles, seed=seed)
    return found, time.perf_counter() - begin, time.process_time() - processor


def test_fits_are_done_in_seconds() -> None:
    """A film of its own each time, so that nothing is remembered; every fit finds its constants."""
    rows = []
    for physics, (two, three, profiled) in GOALS.items():
        for name, constants in FILMS.items():
            scene = sc.load_scene(name, {"run.effects": physics, "run.frames": FRAMES + 1})
            run = sc.simulate(scene).data
            height, random = run.midpoint.values[1:], draws(7)
            noise = NOISE * float(np.max(np.abs(height)))
            for seed, (count, profiles) in enumerate([(2, False), (2, False), (3, False), (3, True)]):
                free = constants[:count]
                if len(free) < count:
                    continue
                film = Measurements.of(run.time.values[1:], height + noise * random.standard_normal(height.size))
                found, wall, processor = _timed(film, scene, free, seed, profiles=profiles)
                goal = profiled if profiles else (two, three)[count - 2]
                if seed:
                    rows.append(
                        [name, physics, count, profiles, f"{wall:.2f}", f"{processor:.2f}", goal, found.outcome.name]
                    )
                print(*rows[-1:], len(found.starts.results), flush=True)
                assert found.outcome.converged
                for key in free:
                    one, truth = found.parameters[key], getattr(scene.material, key)
                    # Of published arrest several moduli fit, of which an interval may hold a neighbour.
                    near = abs(one.best / truth - 1) < 0.1
                    assert near or not misses(one.best, one.ci95, truth, FRAMES - 6), (name, physics, key)
    header = ("film", "physics", "constants", "profiles", "wall [s]", "processor [s]", "goal", "outcome")
    show(f"{FRAMES} readings, 1 % noise; compiled before", header, rows)
    for name, told, count, profiles, wall, *_ in rows:
        which = 2 if profiles else int(count) - 2
        assert float(wall) < 2 * REACHED.get((name, told), GOALS[told])[which], (name, told, count, profiles)
