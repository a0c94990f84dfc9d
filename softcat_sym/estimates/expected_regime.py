"""Expected regime of a scene, from its groups alone (3.9)-(3.14), with the names that finished runs use."""

from __future__ import annotations

import functools
import math
from collections.abc import Collection
from dataclasses import dataclass, replace

from softcat_sym.estimates import scaling as scales
from softcat_sym.estimates.forecast import expected_sag, hinge_pace, overshoot, rebound, ringing_share, shaken_share
from softcat_sym.estimates.quasi_static_sag import load_factor
from softcat_sym.estimates.scaling import initial_strain
from softcat_sym.physics import beams
from softcat_sym.physics.cross_sections import CROSS_SECTIONS
from softcat_sym.scene.scene import (
    Scene,
    carries_moment,
    groups_of,
    is_held,
    is_slack,
    stress_free_length,
)
from softcat_sym.scene.tables import bodies_of, farthest, unsupported

TURNS_BACK = 0.05
"""A filament is underdamped if it springs back by more than this share of its sag, the criterion of finished runs.

The rebound of the parabola is about 1.3 times that of the filament: for G = 0.04 to 0.4 and V = 0.4 to 26 of the
paper's filament, run and parabola are always on the same side of the limit.
"""

BORDER = 4.0
"""Factor about that limit within which an estimate does not decide. Estimate and run of bundled scenes: 0.078 and 0.037
(drying-ink, stressed from the start), 0.070 and 0.127 (wrung-thread); of README's ink, with a loss, 0.24 and 0.067."""

HINGES_CREEP = 0.78
"""Predicted plastic rate of a hinge at a clamp above which the regime is descending.

A finished run counts as arrested below 0.5 sigma_Y/eta. In the paper's overdamped arrest (G = 0.4, V = 26) a hinge
flows at 0.25 sigma_Y/eta at the end, for which :func:`hinge_pace` predicts 0.39: the limit is 0.5 (0.39/0.25).
"""

HANGING = 1.0
"""G above which a filament with a free end never stops: hanging vertically, it carries rho g L at its support."""


@dataclass(frozen=True, slots=True)
class ExpectedRegime:
    """Expected regime of a run, with its numbers; None where the law has no such number."""

    name: str  # One of :data:`softcat_sym.results.motion.Regime`
    reason: str  # In words, with the decisive numbers
    # G (3.10) of the most stressed section, with a point mass at midspan counted twice; with surface tension rho g
    # L/(sigma_Y + gamma P/(2 A)), and the thresholds below are of this number.
    gravity_number: float | None = None
    # G from which a fibre yields, (3.11) with stretching, overshoot and initial stress.
    first_yield: float | None = None
    collapse: float | None = None  # G of plastic collapse of the straight beam, above which only the sag can hold it
    # G above which there is no equilibrium: sqrt 2 (3.12), and that of the exact catenary; 1 with a free end.
    arrest_paper: float | None = None
    arrest_exact: float | None = None
    # Sag over span of a catenary whose largest stress is sigma_Y (3.13), and the exact one; None beyond the thresholds,
    # and with a free end.
    stopping_depth_paper: float | None = None
    stopping_depth_exact: float | None = None
    overshoot: float | None = None  # Sag at the first stop, over that depth
    rebound: float | None = None  # Rebound after the first stop, over the sag
    hinge_pace: float | None = None  # Plastic rate at a clamp at the end of the run, over sigma_Y/eta
    until: str = ""  # Body that it touches first, after which nothing of this holds; empty if it touches none
    near: str = ""  # What it is near the border of, where the rebound does not decide


def expected_regime(scene: Scene, effects: Collection[str]) -> ExpectedRegime:
    """Predict the regime.

    A filament that yields (G above first yield) descends for ever above the exact threshold of (3.12). Below the
    threshold it stops: underdamped if it springs back by more than :data:`TURNS_BACK`, otherwise overdamped; unless
    the hinges at its clamps still flow when the run ends (:data:`HINGES_CREEP`).

    For a material that changes in time, the constants at the end of the run decide. Where something is there to be
    touched, the regime is that of the filament until then.
    """
    sag = expected_sag(scene) * scene.filament.span
    reached = [body.table_name for body in bodies_of(scene) if 0 < body.room() < sag]
    found = _regime(unsupported(scene.at(scene.run.duration)), effects)
    if not reached:
        return found
    return replace(found, until=reached[0], reason=f"{found.reason}; until it touches [{reached[0]}]")


def _regime(scene: Scene, effects: Collection[str]) -> ExpectedRegime:
    gravity_number = worst_gravity_number(scene)
    if scene.material.spec.is_solid:
        return ExpectedRegime(
            "elastic", "the law is that of a solid: it oscillates about, or creeps to, its elastic sag"
        )
    if not {"viscous-flow", "viscous-stress"} & set(effects):
        if gravity_number is not None:
            sound = _with_yield_stress(scene, effects, gravity_number)
            if sound.name == "no-yield":
                return sound
        return ExpectedRegime("elastic", "no flow is in force: it oscillates about its elastic sag")
    if "yielding" not in effects or gravity_number is None:
        why = "yielding is not in force" if gravity_number is not None else "the law has no yield stress"
        return ExpectedRegime("viscous", f"{why}: it flows for as long as it is loaded")
    return _with_yield_stress(scene, effects, gravity_number)


def worst_gravity_number(scene: Scene) -> float | None:
    """G of the thinnest section, which carries the same tension; a weight at midspan counts twice."""
    plain = scales.gravity_number_of(scene)
    if plain is None:
        return None
    areas = [part ** scales.section_of(scene).area_power for part in scene.filament.profile] or [1.0]
    mean = sum(areas) / len(areas)
    return plain * (mean + load_factor(scene) - 1) / min(areas)


def first_yield_under_load(scene: Scene, effects: Collection[str]) -> float:
    """G from which a fibre yields: static (3.11) over the overshoot by weight and shaking, less the initial stress."""
    ringing = ringing_share(_first_frequency(scene), _ramp(scene, effects)) if "inertia" in effects else 0.0
    overshot = 1 + (scales.beam_of(scene).overshoot_bound - 1) * ringing + shaken_share(scene)
    limit, modulus, initial = scales.yield_stress_of(scene) or 0.0, scales.instant_modulus(scene) or 0.0, scene.initial
    there = max(map(abs, initial_strain(scene)), default=0.0) + max(map(abs, initial.C), default=0.0)
    there += 0.0 if initial.relaxed else abs(math.log(initial.stretch))
    # Tension relieves a slowly loaded filament. An oscillating one may not have it at its largest bending: the paper's
    # filament yields at G = 0.04, where first yield with the tension of the static sag would be at 0.041.
    linear = scales.first_yield_gravity_number(scene)
    static = linear + (1 - ringing) * (_static_first_yield(scene) - linear)
    return static / overshot * max(0.0, 1 - modulus * there / limit)


def _with_yield_stress(scene: Scene, effects: Collection[str], gravity_number: float) -> ExpectedRegime:
    held = is_held(scene)
    paper, exact = (beams.ARREST_THRESHOLD, beams.ARREST_THRESHOLD_EXACT) if held else (HANGING, HANGING)
    found = functools.partial(
        ExpectedRegime,
        gravity_number=gravity_number,
        first_yield=first_yield_under_load(scene, effects),
        collapse=scales.collapse_gravity_number(scene),
        arrest_paper=paper,
        arrest_exact=exact,
        stopping_depth_paper=beams.stopping_depth(gravity_number) if held and 0 < gravity_number < paper else None,
        stopping_depth_exact=beams.stopping_depth_exact(gravity_number)
        if held and 0 < gravity_number < exact
        else None,
    )
    blank = found("no-yield", "")
    limit, pull = scales.yield_stress_of(scene) or 0.0, scales.pull_of_surface(scene)
    if pull > limit and not held and gravity_number < exact:
        thicker = f"surface tension alone makes it yield ({pull:.3g} over {limit:.3g} Pa)"
        return found("arrested-overdamped", f"{thicker}: it thickens until gamma P/(2 A) is the yield stress")
    if gravity_number < (blank.first_yield or 0.0) and not _pulled_beyond_yield(scene):
        return found("no-yield", f"{_said(scene, gravity_number)} is below first yield at {blank.first_yield:.3g}")
    if gravity_number >= exact:
        what = "no catenary is in equilibrium" if held else "it is not even in equilibrium hanging straight down"
        return found("descending", f"{what}: {_said(scene, gravity_number)} is beyond {exact:.4g}")
    if scene.ends.motion and scene.ends.motion[-1][0] > 0.9 * scene.run.duration:
        return found("descending", "its support still moves when the run ends")
    if scene.load.shake > 0:
        return found("shaken", "gravity is shaken: it yields repeatedly, or oscillates about its plastic shape")
    return _arrested(scene, effects, blank, found)


def _arrested(
    scene: Scene, effects: Collection[str], numbers: ExpectedRegime, found: functools.partial[ExpectedRegime]
) -> ExpectedRegime:
    """Overdamped, underdamped, or still creeping when the run ends."""
    gravity_number, viscous = numbers.gravity_number or 0.0, scales.viscous_number(scene) or 0.0
    modulus, limit = scales.instant_modulus(scene), scales.holding_stress_of(scene)
    if gravity_number == 0 or not modulus or not limit:
        return found("arrested-overdamped", "only its supports make it flow")
    past, left = 1.0, 0.0
    if "inertia" in effects:
        frequency = math.hypot(_first_frequency(scene), math.sqrt(10 / gravity_number))
        left = ringing_share(frequency, _ramp(scene, effects))
        past += left * (overshoot(gravity_number, viscous, 0.0) - 1)
    springs = rebound(gravity_number, limit / modulus, past)
    if gravity_number < (numbers.collapse or 0.0):
        # It rings about its static sag, by bending and the tension at yield.
        springs = 2 * left / (1 + left)
    depth = past * (numbers.stopping_depth_exact or 0.0)
    clamped = carries_moment(scene) and "bending" in effects
    # The tension that rotates the hinge includes that of the surface; the rate is over sigma_Y/eta.
    pace = hinge_pace(gravity_number, viscous, depth, scales.duration_star(scene)) if clamped else 0.0
    pace /= scales.share_of_yield(scene)
    named = functools.partial(found, overshoot=past, rebound=springs, hinge_pace=pace)
    carried = _how_it_is_held(scene, numbers)
    if pace > HINGES_CREEP:
        creeps = f"but at the end of the run its clamps still flow at about {pace:.2g} sigma_Y/eta"
        return named("descending", f"{carried}, {creeps}")
    kind = "underdamped" if springs > TURNS_BACK else "overdamped"
    stops = "" if gravity_number < (numbers.collapse or 0.0) else f"stops at {past:.3g} times its equilibrium sag and "
    beyond = f"it {stops}springs back by {springs:.2g} of its sag"
    undecided = TURNS_BACK / BORDER < springs < BORDER * TURNS_BACK
    near = "near the border between over- and underdamped" if undecided else ""
    return named(f"arrested-{kind}", f"{carried}; {beyond} ({near or kind}: limit {TURNS_BACK:g})", near=near)


def _said(scene: Scene, gravity_number: float) -> str:
    what = "G = rho g L/(sigma_Y + gamma P/(2 A))" if scales.pull_of_surface(scene) and is_held(scene) else "G"
    return f"{what} = {gravity_number:.3g}"


def _how_it_is_held(scene: Scene, numbers: ExpectedRegime) -> str:
    value = _said(scene, numbers.gravity_number or 0.0)
    if (numbers.gravity_number or 0.0) < (numbers.collapse or 0.0):
        return f"some fibres yield and the beam itself holds it ({value} is below its plastic collapse at " + (
            f"{numbers.collapse:.3g})"
        )
    if not is_held(scene):
        return f"it bends down until it hangs ({value} is below {HANGING:g})"
    slack = ", though it starts slack" if is_slack(scene) else ""
    return f"it yields and a catenary holds it ({value} is below {numbers.arrest_exact:.4g}){slack}"


def _pulled_beyond_yield(scene: Scene) -> bool:
    """Whether moving supports stretch the filament beyond its yield strain."""
    limit, modulus = scales.yield_stress_of(scene), scales.instant_modulus(scene)
    if not scene.ends.motion or not limit or not modulus or not is_held(scene):
        return False
    return modulus * math.log(farthest(scene) / stress_free_length(scene)) > limit


def _ramp(scene: Scene, effects: Collection[str]) -> float:
    """Ramp in sqrt(L/g); zero if its effect is left out."""
    return scene.load.ramp / scales.fall_time(scene) if "gravity-ramp" in effects else 0.0


def _first_frequency(scene: Scene) -> float:
    """First natural frequency of the elastic beam with shear, in sqrt(g/L)."""
    modulus, weight = scales.instant_modulus(scene) or 0.0, scales.weight_stress(scene)
    gyration = scales.section_of(scene).gyration
    speed = math.sqrt(gyration * modulus / weight) * groups_of(scene).delta if weight > 0 else math.inf
    # Sag of a uniform beam by shear over that by bending, E I/(kappa_s mu A L^2 8 C), with q L^2/8 of a held beam.
    stiffness = 8 * scales.section_of(scene).shear_correction / (2 * (1 + scene.material.poisson))
    return scales.beam_of(scene).frequency * speed / math.sqrt(1 + scales.bending_stiffness(scene) / stiffness)


def _static_first_yield(scene: Scene) -> float:
    """G of first yield under a slow load: between clamps with the tension of the sag, otherwise for the linear beam."""
    linear, strain = scales.first_yield_gravity_number(scene), groups_of(scene).eps_Y
    if scales.beam_of(scene) is not beams.CLAMPED or not strain:
        return linear
    stretched = _stretched_first_yield(scene.filament.section, groups_of(scene).delta, strain)
    return max(linear, stretched * scales.share_of_yield(scene))


@functools.cache
def _stretched_first_yield(section: str, slenderness: float, yield_strain: float) -> float:
    """G of :func:`beams.stretched_first_yield` at a yield strain, by bisection in the logarithm of psi."""

    def at(logarithm: float) -> tuple[float, float]:
        gyration = CROSS_SECTIONS[section].gyration
        return beams.stretched_first_yield(math.exp(logarithm), gyration, slenderness)

    low, high = math.log(0.05), math.log(300.0)
    if yield_strain <= at(low)[0]:
        return 0.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if at(middle)[0] > yield_strain else (middle, high)
    return at(low)[1]
