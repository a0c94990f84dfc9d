"""The closed form on films of the full model: errors of E and eta, and how many intervals hold.

``python -m tests.studies.closed_form`` prints the table of ``measured.md``: sixty filaments over the phase diagram by
which the theory's errors were set, sixty random ones that were held back, and these with noise; a quarter of an hour.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import product

import numpy as np

import softcat_sym as sc
from softcat_sym.errors import SoftcatError
from softcat_sym.fitting.closed_form import constants_of, features_of
from softcat_sym.fitting.measurements import Series
from tests.common.table import show

GRID = tuple(product((0.001, 0.0025, 0.01), (1e-6, 1e-5, 1e-4, 1e-3), (0.035, 0.1, 0.35, 1.0, 3.0)))
"""Slenderness, B and tau/sqrt(L/g)."""
RESOLUTION = 1e-3
"""Standard error of a frame over the final sag."""


def random_filaments(count: int = 60) -> Iterator[tuple[float, float, float]]:
    """Filaments between those of the grid."""
    rng = np.random.default_rng(3)
    for _ in range(count):
        delta, load, tau = np.exp(rng.uniform(np.log([0.0013, 1e-6, 0.03]), np.log([0.02, 1e-3, 3.0])))
        yield float(delta), float(load), float(tau)


def filmed(delta: float, load: float, tau: float) -> tuple[sc.Scene, Series]:
    """A filament and its film, of a thousand frames without noise."""
    groups = {"groups.delta": delta, "groups.B": load, "groups.tau": tau, "groups.duration": 20.0}
    how = {"run.frames": 1001, "run.effects": "paper", "numerics.estimate": False}
    run = sc.simulate(sc.load_scene("maxwell-slow", {**groups, **how}))
    height = run.data.midpoint.values
    return run.scene, Series(run.data.time.values, height, np.full_like(height, RESOLUTION * float(abs(height[-1]))))


def errors_of(scene: sc.Scene, film: Series) -> list[tuple[float, float] | None]:
    """log(found/true) and its stated error for E and eta; None where the film does not determine it."""
    features = features_of(film, scene)
    try:
        found = constants_of(film, features, scene) if features is not None else None
    except SoftcatError:
        found = None
    if found is None:
        return [None, None]
    pairs = (found.youngs_modulus, scene.material.youngs_modulus), (found.viscosity, scene.material.viscosity)
    return [
        None
        if one.value is None or one.log_error is None or true is None
        else (math.log(one.value / true), one.log_error)
        for one, true in pairs
    ]


def main() -> None:
    """Print both tables."""
    films = {"grid": [filmed(*one) for one in GRID], "random": [filmed(*one) for one in random_filaments()]}
    rows = []
    for place, (scene, film) in zip(GRID, films["grid"], strict=True):
        texts = ["-" if one is None else f"{math.expm1(one[0]):+.1%} ± {one[1]:.1%}" for one in errors_of(scene, film)]
        rows.append([*(f"{value:g}" for value in place), *texts])
    show("closed form, full model", ("delta", "B", "tau*", "E", "eta"), rows)
    rng, rows = np.random.default_rng(1), []
    for name, noise in (("grid", 0.0), ("random", 0.0), ("grid", 1.0), ("random", 1.0), ("random", 3.0)):
        found = []
        for scene, film in films[name]:
            std = np.asarray(film.std) * max(noise, 1.0)
            found.append(
                errors_of(
                    scene, Series(film.time, film.midpoint + (noise > 0) * std * rng.standard_normal(std.size), std)
                )
            )
        for number, constant in enumerate(("E", "eta")):
            known = np.array([one[number] for one in found if one[number] is not None])
            near, held = np.abs(np.expm1(known[:, 0])) < 0.1, np.abs(known[:, 0]) < 1.96 * known[:, 1]
            rows.append([name, f"{noise * RESOLUTION:g}", constant, len(known), int(near.sum()), int(held.sum())])
    show("of sixty filaments", ("films", "noise", "constant", "determined", "within 10 %", "intervals hold"), rows)


if __name__ == "__main__":
    main()
