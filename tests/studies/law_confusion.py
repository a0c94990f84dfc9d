"""Which law: a confusion matrix over films of five materials, each fitted by all five laws from wrong constants.

``python -m tests.studies.law_confusion`` prints the table of ``measured.md``: 70 films, 350 fits, an hour or two of the
processor. ``tests/slow/test_which_law.py`` looks at some films.
"""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
from scipy.signal import lfilter

import softcat_sym as sc
from softcat_sym.effects.selection import choose_effects
from softcat_sym.fitting.measurements import Measurements
from softcat_sym.fitting.model_selection import CANNOT, fit_laws
from softcat_sym.scene.material import CONSTANTS
from tests.common.draws import draws, gain
from tests.common.table import show

LAWS = ("newtonian", "maxwell", "kelvin-voigt", "bingham", "power-law")
FRAMES = 40
NARROWER = "a narrower law, nothing gained by the true one"
BY_CHANCE = "a wrong law, by no more than chance"
WRONG = 2.0
"""Factor by which the constants that a fit is given are off."""

# Published physics on six cells, without the ringing that would tell springs at once.
PLAIN = {"run.effects": "paper", "numerics.cells": 6, "run.frames": FRAMES + 1, "run.duration": "1 s"}


def _scene(law: str, factors: np.ndarray, index: float) -> sc.Scene:
    """A filament of 20 cm that sags by 5 to 20 % within a second, whatever its law."""
    modulus, viscosity, yield_stress = (np.array([4e5 if law == "kelvin-voigt" else 1e6, 60e3, 6e3]) * factors).tolist()
    own = {
        "youngs_modulus": f"{modulus!r} Pa",
        "viscosity": f"{viscosity!r} Pa*s" + (f"^{index!r}" if law == "power-law" else ""),
        "yield_stress": f"{yield_stress!r} Pa",
    }
    changes: dict[str, object] = {f"material.{name}": None for name in own} | {"material.law": law}
    changes |= {f"material.{name}": own[name] for name in CONSTANTS[law]}
    changes |= {"material.index": index} if law == "power-law" else {}
    scene = sc.load_scene("continual-descent", PLAIN).replace(changes)
    return scene.replace({"run.effects": [name for name in choose_effects(scene).names if name != "inertia"]})


def _verdict(law: str, film: int, noise: float, correlation: float, *, theory: bool) -> str:
    """The verdict on a film with errors of a share of the largest sag, each correlated with the one before."""
    random = draws(film, LAWS.index(law))
    factors, index = np.exp(random.uniform(-0.7, 0.7, 3)), round(random.uniform(0.3, 0.7), 3)
    run = sc.simulate(_scene(law, factors, index)).data
    height = run.midpoint.values[1:]
    error = random.standard_normal(height.size)
    if correlation:
        start = [correlation * random.standard_normal()]
        error = lfilter([np.sqrt(1 - correlation**2)], [1, -correlation], error, zi=start)[0]
    readings = Measurements.of(run.time.values[1:], height + noise * np.abs(height).max() * error)
    found = fit_laws(readings, _scene(law, WRONG * factors, index), LAWS, starts=1, seed=film, discrepancy=theory)
    print(f"{law} {film}: {found.sentence}")
    if law in found.choice.wider:
        return NARROWER
    best, squares = found.choice.table[0].law, {row.law.name: row.law.squares for row in found.choice.table}
    if found.choice.verdict == CANNOT:
        return f"{CANNOT}, {best.name}"
    # A difference of ten is passed by chance once in some thousand films; what 70 films have by chance, 280 laws, is
    # far less than what one law's film is apart from another law at this noise.
    allowed = gain(FRAMES, best.unknowns, comparisons=280)
    lucky = best.name != law and FRAMES * math.log(squares[law] / best.squares) < allowed
    return BY_CHANCE if lucky else best.name


STUDIES = (
    ("1 % noise", range(5), 0.01, 0.0, False),
    ("0.2 % noise", range(5, 7), 0.002, 0.0, False),
    ("1 % noise, and the theory may err", range(5), 0.01, 0.0, True),
    ("1 % noise, correlated, and the theory may err", range(7, 9), 0.01, 0.9, True),
)
"""Films of each law, noise over the largest sag and correlation of neighbours.

Without shear and fibres the theory errs by 2 to 5 %: as much as laws differ, which then cannot be told.
"""


if __name__ == "__main__":
    for title, films, noise, correlation, theory in STUDIES:
        found = {law: Counter(_verdict(law, f, noise, correlation, theory=theory) for f in films) for law in LAWS}
        verdicts = [*LAWS, NARROWER, BY_CHANCE, *(f"{CANNOT}, {law}" for law in LAWS)]
        show(
            title, ["truth", *verdicts], [[law, *(one[verdict] for verdict in verdicts)] for law, one in found.items()]
        )
        told = sum(one[law] for law, one in found.items())
        wrong = sum(one[law] for truth, one in found.items() for law in LAWS if law != truth)
        first = told + sum(one[f"{CANNOT}, {law}"] for law, one in found.items())
        print(f"\ntold: {told} of {len(LAWS) * len(films)}; first, told or not: {first}; wrong with certainty: {wrong}")
