"""The price of a run before it begins: `softcat explain` prints it, and a run that is long says it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from softcat_sym.codegen.c_model import model_for, signature_of
from softcat_sym.discretization.assembly import choose_grid
from softcat_sym.effects.selection import Effects
from softcat_sym.estimates.forecast import expected_sag, forecast
from softcat_sym.estimates.free_vibration import ringing
from softcat_sym.scene.dimensions import is_spatial
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.modal_tail import WINDOW
from softcat_sym.solvers.settings import choose_backend, settings_for
from softcat_sym.solvers.solve import conditions_of_tail, structure_for

STEPS_PER_PERIOD = {"sudden": (350.0, 0.7, 0.55), "ramp": (60.0, 1.0, 0.35), "damped": (20.0, 1.0, 0.35)}
"""Steps of the compiled Rosenbrock method in the first period at an accuracy of 0.01, the power of the number of
periods with which they grow, and that of 0.01/accuracy (tests/slow/test_speed.py).

A sudden load excites all modes, and a finer accuracy resolves more of them. Measured at 0.01 and 0.001: elastic strands
of 1 mm over 20 mm 253, 895 (450 kPa) and 167, 583 (45 kPa); a gel of 0.2 mm over 2 mm 119 to 187, 390 to 630; with a
ramp 60, 132 (no-yield); damped 15, 33 (rubber-strand) and 44, 73 (cooked-spaghetti).
Time steps that do not resolve the higher modes damp them, so that the steps become longer: users' inks take 4900,
19 000 and 54 000 steps for 73, 927 and 4316 periods, agar 48 000 for 619.
"""

SECONDS_PER_UNKNOWN = 0.35e-6
"""Processor time for each step and unknown of compiled models; 0.29 to 0.45 us were measured."""

MODAL_SAG = 150.0
"""Square of the sag over the thickness up to which a fit of modes leaves little enough, over the accuracy: the residual
is 0.007 to 0.017 of that square, and at most a tenth of the root of the accuracy."""

YIELDING = 100.0
"""Periods in which a strand that yields at first does so: 50 to 140 in five of users' inks."""

BUILDING = {False: 4e-3, True: 7e-3}
"""Processor time to write the equations of each unknown without a compiler, in the plane and in space, where 870 take
6 s and 400 MB: each cell is written out by itself."""

INTERPRETED = 3e-6
"""Processor time for each step and unknown of interpreted models; 0.4 to 8 us were measured."""

BESIDE = 3.0
"""Duration of a run together with the runs that estimate its error, over that of the run alone."""

LONG, ANNOUNCED = 5.0, 60.0
"""Processor time [s] above which a text advises how to shorten the run, and of which a run tells before it begins."""

_UNKNOWNS = {False: 10, True: 55}
"""Of a cell in the plane and in space, where nothing else says how many there are."""


@dataclass(frozen=True, slots=True)
class RunCost:
    """What a run costs."""

    seconds: float  # Of the processor, to a factor of two or three
    text: str  # In words, with what cuts it; empty where nothing is worth saying

    @property
    def is_announced(self) -> bool:
        """Whether a run tells its price before it begins."""
        return self.seconds >= ANNOUNCED


def run_cost(scene: Scene, effects: Effects) -> RunCost:
    """Foretell the processor time of a run: of its steps while it rings, and of its equations without a compiler."""
    rings = ringing(scene)
    compiled, size, runs = choose_backend(scene, effects).compiled, 0, BESIDE if scene.numerics.estimate else 1.0
    building = 0.0
    if not compiled:
        size = unknowns_of(scene, effects)
        building = size * BUILDING[is_spatial(scene)] * runs
    audible = 0 < rings.amplitude >= scene.run.accuracy * expected_sag(scene)
    if not effects.terms().inertia or not audible:
        about = float(f"{building:.1g}")
        text = f"takes about {about:g} s of the processor, to write the equations of {size} unknowns without a compiler"
        return RunCost(building, f"{text}; fewer numerics.cells or numerics.fibres cut it" if building >= LONG else "")
    frequency, damped = rings.frequency / (2 * math.pi), rings.decay > 0
    lasts = min(scene.run.duration, -math.log(scene.run.accuracy) / rings.decay if damped else math.inf)
    integrated = _integrated_periods(scene, effects) if compiled and not damped else math.inf
    periods = min(frequency * lasts, integrated)
    at_first, growth, power = STEPS_PER_PERIOD["damped" if damped else "ramp" if scene.load.ramp > 0 else "sudden"]
    steps = at_first * periods**growth * (0.01 / scene.run.accuracy) ** power
    size = size or unknowns_of(scene, effects)
    seconds = building + steps * size * (SECONDS_PER_UNKNOWN if compiled else INTERPRETED) * runs
    about = float(f"{seconds:.1g}")
    taken_over = ", most of them by its modes of vibration" if periods < frequency * lasts else ""
    text = f"rings some {frequency * lasts:.0f} periods of {1 / frequency:.3g} s{taken_over}: "
    text += f"about {about:g} s of the processor"
    if seconds >= ANNOUNCED:
        text += (
            "; load.ramp, material.loss_tangent, a larger run.accuracy, a shorter run.duration or run.effects without "
        )
        text += "inertia cut it, and --time-limit ends it"
    elif not damped and seconds >= LONG:
        text += "; set load.ramp or material.loss_tangent"
    return RunCost(seconds, text)


def _integrated_periods(scene: Scene, effects: Effects) -> float:
    """Periods of a ringing before its modes of vibration carry it to the end; infinite where they will not."""
    terms, settings = effects.terms(), settings_for(scene, effects, compiled=True)
    sag = expected_sag(scene) * scene.filament.span / scene.filament.thickness
    if conditions_of_tail(scene, terms, settings, 1.0) is None or sag > math.sqrt(MODAL_SAG * scene.run.accuracy):
        return math.inf
    return YIELDING if terms.yields and forecast(scene).overstress > 1 else WINDOW


def unknowns_of(scene: Scene, effects: Effects) -> int:
    """Number of unknowns of a run, by those of a site."""
    structure, cells = structure_for(scene, effects), choose_grid(scene, effects).cells
    found = signature_of(structure)
    if found is None and choose_backend(scene, effects).compiled:
        found = model_for(structure).signature
    if found is None:
        return _UNKNOWNS[is_spatial(scene)] * cells
    places = [slot.where for slot in found.slots]
    return sum(1 if where.alone else max(0, cells + 1 - where.first - where.behind) for where in places)
