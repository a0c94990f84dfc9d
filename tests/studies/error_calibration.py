"""Estimated errors beside true ones: bundled and random scenes, forty users' inks, and a hinge under a hanging mass.

``python -m tests.studies.error_calibration [SCENE ...]`` prints the table of ``measured.md``, hours of the processor;
scenes to look at alone are named so: ``cold-honey "random 7" "ink 12 bioink"``.
``tests/slow/test_error_calibration.py`` looks at some of them.

The inks are gels, bioinks, ceramics, chocolate and toothpaste, strands of which span a gap, as users have them. Numbers
are drawn once and for all (the seed is fixed), evenly in the logarithm between limits that the literature of direct ink
writing, food and rheology gives for each kind; E is three times G', two digits each, so that every machine has the same
scenes. Nothing is ramped, and nobody says how accurate the answer is to be. No chance is left in what is
counted: rounding moves a ratio by less than a per cent, and a scene or two that lie at a limit may change sides.
"""

from __future__ import annotations

import math
import resource
import sys
import tomllib
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, field, replace
from multiprocessing import get_context
from typing import Any

import numpy as np
import pandas as pd

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from tests.common.random_scenes import random_scenes
from tests.common.time_limit import within
from tests.common.true_error import true_error

LEAST, MOST = 0.3, 3.0
"""True error over the estimate."""
NOTHING = 1e-3
"""Share of the accuracy below which estimate and true error are both nothing, and their ratio is rounding."""
LIMITS, INK_LIMITS = (600.0, 1800.0), (120.0, 180.0)
"""Seconds of the processor for a run with its estimates, and for its reference, eight times as much of one."""

INKS = """
gel         6e3 6e4  50  400   5  80   0.3  0.6  1000 1100  0.03  0.045  0.2e-3  0.8e-3  1e-3  5e-3
bioink      3e3 3e4  30  200   5  60   0.3  0.7  1000 1080  0.045 0.072  0.2e-3  0.6e-3  1e-3  4e-3
ceramic     1e5 3e6  100 2000  5  100  1    1    1800 3000  0.05  0.072  0.2e-3  1.2e-3  1e-3  10e-3
silicone    3e4 5e5  100 1000  20 300  0.4  0.8  1000 1300  0.03  0.04   0.25e-3 1.5e-3  2e-3  12e-3
chocolate   5e4 1e6  30  300   2  40   1    1    1200 1300  0.03  0.04   0.5e-3  1.5e-3  3e-3  20e-3
toothpaste  3e3 3e4  60  300   10 100  0.35 0.6  1200 1600  0.035 0.06   0.8e-3  1.5e-3  3e-3  20e-3
"""
"""Limits of Young's modulus and the yield stress in shear [Pa]; Herschel and Bulkley's consistency in shear [Pa s^n]
and index (Bingham's where that is one); density [kg/m^3]; surface tension [N/m]; diameter and span [m]."""


def users_inks(number: int = 40, seed: int = 20261122) -> list[tuple[str, sc.Scene]]:
    """Names and scenes, always the same."""
    generator, kinds = np.random.default_rng(seed), [line.split() for line in INKS.split("\n") if line]
    inks = []
    for index in range(number):
        name, *limits = kinds[index % len(kinds)]
        inks.append((f"ink {index + 1} {name}", ink(np.reshape(limits, (8, 2)).astype(float), generator)))
    return inks


def ink(limits: np.ndarray, generator: np.random.Generator) -> sc.Scene:
    def drawn(low: float, high: float) -> float:
        return float(f"{float(np.exp(generator.uniform(math.log(low), math.log(high)))):.2g}")

    modulus, strength, consistency, index, density, tension, diameter, span = limits
    filament = {
        "thickness": f"{(thick := drawn(*diameter))!r} m",
        # A strand bridges three of its diameters or more.
        "span": f"{max(drawn(*span), 3 * thick):.2g} m",
        "section": "circle",
        "density": f"{drawn(*density):g} kg/m^3",
    }
    material: dict[str, object] = {
        "youngs_modulus": f"{drawn(*modulus):g} Pa",
        "shear_yield_stress": f"{drawn(*strength):g} Pa",
    }
    K, n = drawn(*consistency), drawn(*index)
    if math.isclose(n, 1.0):
        material |= {"law": "bingham", "shear_viscosity": f"{K:g} Pa*s"}
    else:
        material |= {"law": "herschel-bulkley", "shear_consistency": f"{K:g} Pa*s^{n:g}", "index": n}
    surroundings, run = {"surface_tension": f"{drawn(*tension):g} N/m"}, {"duration": f"{drawn(0.5, 5.0):g} s"}
    return sc.Scene.model_validate(
        {"filament": filament, "material": material, "surroundings": surroundings, "run": run}
    )


@dataclass(frozen=True)
class Calibrated:
    """A scene, its estimated error and its true one; or why there is nothing to compare."""

    name: str
    outcome: str
    why_not: str = ""
    accuracy: float = np.nan
    sag: float = np.nan
    true: float = np.nan
    estimate: dict[str, float | None] = field(default_factory=dict)
    resolution: dict[str, Any] = field(default_factory=dict)
    refinements: tuple[str, ...] = ()
    seconds: tuple[float, float, float] = (np.nan, np.nan, np.nan)  # solve, estimate, processor with compilers

    @property
    def ratio(self) -> float:
        """True error over the estimate."""
        total = self.estimate["total"]
        return self.true / total if total else np.inf

    @property
    def is_kept(self) -> bool:
        """Whether it is as accurate as asked."""
        return self.true <= self.accuracy

    @property
    def is_calibrated(self) -> bool:
        nothing = NOTHING * self.accuracy
        return LEAST <= self.ratio <= MOST or (self.true < nothing and (self.estimate["total"] or 0.0) < nothing)


def processor() -> float:
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


def calibrate(name: str, text: str, run_limit: float, reference_limit: float) -> Calibrated:
    """Run a scene as a user would do it, then with its true error; without what there is no time for."""
    scene, begun = sc.Scene.model_validate(tomllib.loads(text)), processor()
    try:
        with within(run_limit):
            run = sc.simulate(scene)
    except SoftcatError as refusal:
        return Calibrated(name, "refused", str(refusal)[:200])
    except TimeoutError:
        return Calibrated(name, "dear", f"not as accurate as asked within {run_limit:g} s")
    summary = run.summary
    estimate, wall = summary["error_estimate"] or {}, summary["wall_s"]
    judged = run.outcome.is_success and estimate.get("total") is not None
    found = Calibrated(
        name,
        run.outcome.name,
        "" if judged else summary["message"] or "no estimate",
        scene.run.accuracy,
        -summary["midpoint_final_m"],
        estimate=estimate,
        resolution=summary["resolution"] or {},
        refinements=tuple(summary["refinements"]),
        seconds=(wall["solve"], wall["estimate"], processor() - begun),
    )
    if found.why_not:
        return found
    try:
        with within(reference_limit):
            true, why_not = true_error(scene, run)
    except TimeoutError:
        return replace(found, why_not=f"no reference within {reference_limit:g} s")
    return replace(found, true=true, why_not=why_not)


def calibrated(scenes: Iterable[tuple[str, sc.Scene]], limits: tuple[float, float]) -> list[Calibrated]:
    """Calibrate scenes, side by side."""
    with ProcessPoolExecutor(mp_context=get_context("spawn")) as pool:
        asked = [pool.submit(calibrate, name, scene.to_toml(), *limits) for name, scene in scenes]
        return [one.result() for one in asked]


def hanging_masses() -> list[tuple[str, sc.Scene]]:
    """A Bingham strand whose hinges turn until tension carries it; the mass is some share of its own, 13.7 g."""
    paste = {"law": "bingham", "youngs_modulus": "4 MPa", "yield_stress": "20 kPa", "viscosity": "13.84 kPa*s"}
    strand = {
        "filament": {"span": "0.2 m", "thickness": "6 mm", "density": "1900 kg/m^3"},
        "material": paste,
        "run": {"duration": "1 s", "accuracy": 1e-3, "frames": 101},
    }
    masses = {f"mass {share} of its own": {"point_mass": f"{share * 13.7e-3} kg"} for share in (0.3, 1.0, 2.0)}
    return [(name, sc.Scene.model_validate({**strand, "load": load})) for name, load in masses.items()]


if __name__ == "__main__":
    named = sys.argv[1:]
    drawn = [(f"random {number}", scene) for number, scene in enumerate(random_scenes(60))]
    every = [*((name, sc.load_scene(name)) for name in sc.bundled_names()), *drawn, *hanging_masses()]
    for scenes, limits in ((every, LIMITS), (users_inks(), INK_LIMITS)):
        found = calibrated([one for one in scenes if not named or one[0] in named], limits)
        table = pd.json_normalize([asdict(one) | {"ratio": one.ratio if one.estimate else None} for one in found])
        print(table.to_string())
        answered = [one for one in found if not one.why_not]
        if answered:
            within, kept = (np.mean([getattr(one, name) for one in answered]) for name in ("is_calibrated", "is_kept"))
            ratio = np.median([one.ratio for one in answered])
            print(
                f"{len(answered)} of {len(found)} answered; within a factor of three {within:.1%}, median {ratio:.2f}"
            )
            print(f"true error within the accuracy asked {kept:.1%}")
