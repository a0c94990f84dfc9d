"""Our elements against CalculiX, a solver that is not ours: the same mesh, clamp, law, gravity and inertia.

Runs of CalculiX are kept in the user's cache by their deck, so that a second check is immediate.
"""

from __future__ import annotations

import shutil
from dataclasses import dataclass

import numpy as np
import pytest

from softcat_sym.reference.calculix import STEP, calculix_deck
from softcat_sym.reference.element_loop import Clamp, Mesh
from softcat_sym.scene.scene import elastic_time
from tests.common.calculix import find_calculix, run_calculix
from tests.common.elements import INSTANTS, Floats, digits, elements, midpoints, name_of, percent, plane
from tests.common.kept_answers import kept
from tests.common.table import show

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_calculix() is None, reason="no CalculiX: apt-get install calculix-ccx"),
    pytest.mark.skipif(shutil.which("cc") is None, reason="no C compiler: install gcc, or set CC"),
]

GOAL = 0.004
"""At t~ = 460, relative."""

HALF = STEP / 2


@dataclass(frozen=True)
class Case:
    """One run of CalculiX and the elements it is held against."""

    mesh: Mesh
    step: float = STEP
    clamp: Clamp = Clamp.THINNING

    @property
    def title(self) -> str:
        face = "" if self.clamp is Clamp.THINNING else ", fixed face"
        return f"{name_of(self.mesh)}{face}"


CASES = (Case(Mesh(16, 2)), Case(Mesh(16, 2), step=HALF), Case(Mesh(16, 2), clamp=Clamp.FIXED))


def calculix(name: str, case: Case) -> tuple[Floats, float, int, int]:
    """Midpoints at the instants, seconds, increments, unknowns."""
    scene = plane(name)
    deck = calculix_deck(scene, case.mesh, clamp=case.clamp, step=case.step)

    def answer() -> list[object]:
        run = run_calculix(scene, case.mesh, clamp=case.clamp, step=case.step)
        height = np.interp(INSTANTS, run.time / elastic_time(scene), run.midpoint / scene.filament.span)
        return [height.tolist(), run.wall, run.steps]

    height, wall, steps = kept(("calculix", deck.text), "", answer)[:3]
    return np.array(height), wall, steps, deck.dofs


# What half the increment may change at t~ = 460. CalculiX's flow is of first order in it, and an arrested filament
# keeps the error of its fall: 0.23 % of the 0.4 %. A descending one forgets it.
@pytest.mark.parametrize(("name", "halving"), [("arrested-overdamped", GOAL), ("continual-descent", GOAL / 4)])
def test_elements_agree_with_calculix(name: str, halving: float) -> None:
    """Within 0.4 % at t~ = 460 on every mesh.

    What is left is of the size of the elastic strain, sY/E = 0.23 % and 0.05 %, by which CalculiX's law (Simo 1988,
    neo-Hookean) differs from ours; tests/test_calculix.py shows it on one brick.
    """
    scene, rows, apart = plane(name), [], []
    found: dict[Case, Floats] = {}
    for case in CASES:
        ours = elements(scene, case.mesh, clamp=case.clamp)
        height, wall, steps, dofs = calculix(name, case)
        found[case], own = height, midpoints(scene, ours)
        apart.append(float(height[-1] / own[-1] - 1))
        both = [f"{value} ({off})" for value, off in zip(digits(height), percent(height, own), strict=True)]
        step = f"{case.step:g}"
        rows.append(["elements", case.title, "", *digits(own), ours.dofs, ours.steps, f"{ours.wall:.0f}"])
        rows.append(["CalculiX", case.title, step, *both, dofs, steps, f"{wall:.0f}"])
    header = ["", "mesh", "increment", *(f"t~ = {t:g}" for t in INSTANTS), "unknowns", "steps", "seconds"]
    show(f"{name}, midpoint/L; of CalculiX also the difference from our elements on the same mesh", header, rows)
    assert max(np.abs(apart)) < GOAL
    assert np.abs(found[CASES[1]] / found[CASES[0]] - 1)[-1] < halving
    # What is compared is not one number that every mesh and clamp gives.
    assert len({float(height[-1]) for height in found.values()}) == len(CASES)
