"""Choice of integrator, backend and tolerances, for a time error of a tenth of the requested accuracy."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np

from softcat_sym.codegen.compiler import TO_INSTALL, find_compiler
from softcat_sym.discretization.assembly import choose_grid
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import Effects
from softcat_sym.errors import Fault, SceneError
from softcat_sym.estimates.forecast import expected_sag, expected_strain
from softcat_sym.estimates.free_vibration import ringing
from softcat_sym.estimates.scaling import (
    effective_viscosity,
    gravity_number_of,
    instant_modulus,
    viscous_number,
    weight_stress,
    yield_stress_of,
    yields_throughout,
)
from softcat_sym.scene.natural_curve import is_curved
from softcat_sym.scene.scene import Scene, groups_of, is_held, is_slack, why_interpreted
from softcat_sym.scene.tables import unsupported

Name = Literal["cvodes", "idas", "rosenbrock"]

NOTHING_TO_INTEGRATE = "without inertia or flow there is nothing to integrate, only a sequence of equilibria"

RODAS5P, RODAS4 = 1, 2
"""Methods of the compiled solver, as softcat_rosenbrock.h numbers them."""

# BDF of order 3-5 is unstable on the imaginary axis, where the elastic waves are; order 2 is A-stable.
_BDF_ORDER = 2
_STEPS_PER_FRAME = 100_000

# Measured on the bundled scenes (tests/slow/test_bundled_scenes.py): with these the time error of the midpoint is
# a tenth of the accuracy requested or less.
_RTOL_PER_ACCURACY = {"cvodes": 0.3, "idas": 0.2, "rosenbrock": 0.012}
_VISCOUS = 0.2  # BDF without a yield stress: the whole filament flows at once, and further
_TURNING = 0.05  # BDF with inertia of the sections, whose waves must not affect the energy balance
_CREEP = 0.003  # BDF with a slow load and little to resolve: its few steps must be accurate
_REST = 0.04  # IDAS for a filament that yields throughout and comes to rest, with small final oscillations
_QUASI_STATIC = 0.04  # BDF without inertia: the flow after a sudden load must be resolved from the beginning


class _Choice(NamedTuple):
    """Method and tolerances of the compiled solver."""

    share: float  # Relative tolerance over the accuracy
    loosest: float  # Relative tolerance; a looser one rejects more steps than it saves, or errs by too much
    method: int
    # Absolute tolerance of velocities over that of positions. In an oscillation the error of a position is that of the
    # velocity over the frequency, which is above one. With equal tolerances the integrator would resolve the fastest
    # waves of a fine grid, which position errors within the tolerance excite, in thousands of steps.
    per_velocity: float
    # That of the plastic strains of fibres. They begin to flow and stop one by one, with an error each; what moves the
    # filament is their mean.
    per_fibre: float = 1.0


_FLOWING = _Choice(0.3, 1e-3, RODAS5P, 10.0)
_DESCENDING = _Choice(1.0, 3e-3, RODAS4, 10.0)  # With a yield stress, in unlimited flow
_HELD_BACK = _Choice(0.02, 3e-3, RODAS4, 10.0)  # With a viscous stress
# With flow that comes to rest at the yield stress, where a stage that goes beyond a wave makes fibres flow that neither
# did nor will, and this excites new waves: a thousand steps, whatever the tolerance. Where a step does not resolve a
# wave, stages of Rodas5P reach 3.4 times its amplitude, those of Rodas4 never beyond it (tests/test_rosenbrock.py).
_CREEPING = _Choice(1.0, 1e-3, RODAS4, 10.0, 10.0)
_STILL = _Choice(0.03, 3e-3, RODAS4, 10.0)  # The same without inertia
_LAID = _STILL._replace(share=0.1)  # Where each release of a node is followed for itself: the sag is the same to 1e-5
_RINGING = _Choice(0.02, 1e-3, RODAS5P, 3.0)
_TIGHTEST_RODAS4 = 1e-5  # Below this a method of fifth order takes so many steps fewer that it is cheaper
# Numerical damping of a ringing in a run, over rtol: a tenth of the accuracy for a ringing by half of the sag. With n
# steps in a period, n at least nine, the method damps 5e-6 (2 pi)^6/n^5 of the amplitude in each period.
_TAKEN, _TAKEN_PER_PERIOD = 10.2, 0.31
# Number of periods of an undamped ringing above which its phase error matters: the error grows with this number, and
# for a thousand periods is 0.2 of the accuracy at the share above (tests/slow/test_energy_drift.py).
_MANY_PERIODS = 500.0
_PLASTIC = ("axial_", "shear_", "shear2_", "shear3_")
_VELOCITIES = frozenset({"u", "v", "w", "omega", "o1", "o2", "o3"})
_PER_YIELD_STRAIN = 0.02  # Strain scale of the absolute tolerance, over the yield strain, of flow that comes to rest
_ATOL_PER_RTOL = {"cvodes": 0.1, "idas": 0.1, "rosenbrock": 1.0}

_OVERDAMPED = 5.0  # V above which a descending filament does not rebound
_SHORT_MEMORY = 0.02  # relaxation time in sqrt(L/g) below which a Maxwell filament does not ring
_SLOW_PERIODS = 20.0
_AT_ONCE = 1e9  # Run over rho L^2/eta: on a grid of forty cells the fastest wave relaxes 1e6 times sooner
_NOISE = 5 * float(np.finfo(float).eps)


@dataclass(frozen=True, slots=True)
class Backend:
    """Evaluation of the right-hand side."""

    compiled: bool  # Whether generated C evaluates and integrates it; otherwise CasADi interprets the graph
    reason: str  # The compiler, or the reason why there is none

    def __str__(self) -> str:
        return f"{'compiled' if self.compiled else 'interpreted'}: {self.reason}"


def choose_backend(scene: Scene, effects: Effects) -> Backend:
    """Choose the backend: compiled if there is a compiler and the filament has a compiled form."""
    requested, solver, obstacle = scene.numerics.backend, scene.numerics.solver, ""
    if requested == "interpreted":
        return Backend(False, "named in numerics.backend")
    if (only_interpreted := why_interpreted(scene)) is not None:
        obstacle = only_interpreted
    elif solver in ("cvodes", "idas"):
        obstacle = f"{solver} is named in numerics.solver, which CasADi interprets"
    elif not effects.terms().integrates:
        obstacle = NOTHING_TO_INTEGRATE
    elif (compiler := find_compiler()) is not None:
        return Backend(True, compiler.version)
    else:
        obstacle = f"there is no C compiler that runs: {TO_INSTALL}"
    if requested == "compiled":
        raise SceneError([Fault("numerics.backend", f"'compiled', but {obstacle}", "auto or interpreted")])
    return Backend(False, obstacle)


@dataclass(frozen=True, slots=True)
class Settings:
    """An integrator and its tolerances."""

    solver: Name  # ``cvodes``, ``idas`` or ``rosenbrock``
    rtol: float  # Relative tolerance, and absolute tolerance in units of span and time scale
    atol: float
    reason: str  # Reason for this integrator
    # Absolute tolerance of all unknowns except axial velocities, whose tolerance is looser due to rounding.
    across: float | None = None
    velocity: float = 0.0  # Absolute tolerance of velocities, if it is looser than those
    max_step: float | None = None  # [s]; None if only the tolerances limit the steps
    method: int = RODAS5P  # Of the compiled solver
    lasting: float | None = None  # Period of an undamped ringing [s]
    fibre: float = 0.0  # Absolute tolerance of plastic strains at the points of a section, if it is looser

    def absolute(self, kinds: Iterable[str]) -> Floats:
        """Absolute tolerance of unknowns of these kinds."""
        across = self.atol if self.across is None else self.across

        def looser(kind: str) -> float:
            return self.velocity if kind in _VELOCITIES else self.fibre if kind.startswith(_PLASTIC) else 0.0

        return np.array([max(self.atol if kind == "u" else across, looser(kind)) for kind in kinds])

    def options(self) -> dict[str, Any]:
        """Options of the CasADi integrator."""
        common = {"reltol": self.rtol, "abstol": self.atol, "max_num_steps": _STEPS_PER_FRAME}
        bdf = {"max_order": _BDF_ORDER, "disable_internal_warnings": True} if self.solver != "rosenbrock" else {}
        return {**common, "show_eval_warnings": False, **bdf}


def settings_for(scene: Scene, effects: Effects, *, compiled: bool) -> Settings:
    """Integrator and tolerances of a compiled or interpreted run."""
    return compiled_settings(scene, effects) if compiled else choose_settings(scene, effects)


def choose_settings(scene: Scene, effects: Effects) -> Settings:
    """Choose the integrator: the scene's, or one that depends on whether flow damps the elastic waves.

    BDF of order 2 is the cheapest if flow damps the waves, or if a filament creeps to rest. Its numerical damping would
    affect the ringing of filaments that stay elastic or stop early: these use the fifth-order Rosenbrock method.
    """
    solver, reason = _solver(scene, effects)
    rtol = scene.numerics.rtol or scene.run.accuracy * _tightening(scene, effects, solver)
    atol = rtol * _ATOL_PER_RTOL[solver] * _smallest_strain(scene)
    return Settings(solver, rtol, max(atol, _roundoff(scene, effects)), reason)


def compiled_settings(scene: Scene, effects: Effects) -> Settings:
    """Method and tolerances of the compiled solver, for which a Rosenbrock method is the cheapest in all cases.

    If flow damps all motion, Rodas4 takes as many steps as Rodas5P, with six stages instead of eight.
    """
    choice, smallest, terms = _RINGING, _smallest_strain(scene), effects.terms()
    if terms.viscous:
        choice = _HELD_BACK
    elif _creeps_to_rest(scene, effects):
        choice = _CREEPING if terms.inertia else _LAID if terms.laid else _STILL
        # The remaining stress beyond yield decides where it stops.
        limit, modulus = yield_stress_of(scene), instant_modulus(scene)
        if limit and modulus:
            smallest = min(smallest, _PER_YIELD_STRAIN * (limit / modulus))
    elif _flow_damps(scene, effects):
        choice = _DESCENDING if terms.yields else _FLOWING
    lasting = _lasting_period(scene, effects) if choice is _RINGING else None
    if lasting is not None:
        share = choice.share * min(1.0, _MANY_PERIODS * lasting / scene.run.duration)
        choice = choice._replace(share=share, per_velocity=1.0)
    rtol = scene.numerics.rtol or min(choice.loosest, scene.run.accuracy * choice.share)
    method = choice.method if rtol >= _TIGHTEST_RODAS4 else RODAS5P
    noise = _roundoff(scene, effects)
    # Rounding noise along the filament affects transverse unknowns in proportion to the slope.
    level = is_held(scene) and scene.ends.drop == 0 and not scene.ends.motion and not is_slack(scene)
    level = level and not scene.initial.centreline and not is_curved(scene)
    slope = min(1.0, 4 * expected_sag(scene)) if level else 1.0
    across = max(rtol * smallest, noise * slope)
    longest = None if lasting is None else _longest_step(scene, lasting, rtol)
    atol, velocity = max(rtol * smallest, noise), choice.per_velocity * rtol * smallest
    fibre = choice.per_fibre * rtol * smallest if scene.numerics.order is None else 0.0
    return Settings("rosenbrock", rtol, atol, "the compiled one", across, velocity, longest, method, lasting, fibre)


def _lasting_period(scene: Scene, effects: Effects) -> float | None:
    """Period [s] of an undamped ringing; None if there is none above the accuracy."""
    rings = ringing(scene)
    lasts = rings.decay == 0 and rings.amplitude > scene.run.accuracy * expected_sag(scene)
    return 2 * math.pi / rings.frequency if effects.terms().inertia and lasts else None


def _longest_step(scene: Scene, period: float, rtol: float) -> float:
    """Longest step [s] for an undamped ringing, which an L-stable method damps without exceeding its tolerances.

    The tolerances limit the error of a step, which is proportional to the amplitude: as the method damps the ringing,
    steps become longer, and a ringing with a small share of the sag is damped from the beginning.
    """
    per_period = (_TAKEN_PER_PERIOD * scene.run.duration / period / (_TAKEN * rtol)) ** 0.2
    return period / float(per_period)


def _roundoff(scene: Scene, effects: Effects) -> float:
    """Rounding noise of an axial velocity: rounding of the positions over a cell, times the speed of elastic waves."""
    modulus, weight = instant_modulus(scene), weight_stress(scene)
    if not effects.terms().inertia or modulus is None or weight <= 0:
        return 0.0
    cells = 0.5 / float(np.min(choose_grid(scene, effects).cell_length))
    return _NOISE * cells * math.sqrt(modulus / weight)


def _tightening(scene: Scene, effects: Effects, solver: Name) -> float:
    """Relative tolerance over the accuracy requested."""
    if solver == "rosenbrock":
        return _RTOL_PER_ACCURACY[solver]
    if not effects.terms().inertia:
        return _QUASI_STATIC
    if _is_slow(scene) or _relaxes_at_once(scene, effects):
        return _CREEP
    if effects.terms().rotary_inertia:
        return _TURNING
    if not effects.terms().yields:
        return _VISCOUS
    return _REST if _creeps_to_rest(scene, effects) else _RTOL_PER_ACCURACY[solver]


def _smallest_strain(scene: Scene) -> float:
    """Strain scale of absolute tolerances: that of the expected sag, at most a hundredth."""
    expected = max(4 * expected_sag(scene) * groups_of(scene).delta, expected_strain(scene))
    return min(0.01, expected) if expected > 0 else 0.01


def _solver(scene: Scene, effects: Effects) -> tuple[Name, str]:
    requested, algebraic = scene.numerics.solver, _algebraic(effects)
    if requested == "cvodes" and algebraic:
        unknowns, _, effect = algebraic.partition(" without ")
        found = f"'cvodes' cannot hold {unknowns} that are algebraic, as they are without {effect}"
        accepted = f"idas or rosenbrock, or the effect {effect.replace(' ', '-')}"
        raise SceneError([Fault("numerics.solver", found, accepted)])
    if requested is not None:
        return requested, "named in numerics.solver"
    if not effects.terms().inertia:
        unknowns = "velocities" if effects.terms().resists else "positions"
        return "idas", f"{unknowns} are algebraic without inertia"
    turning = algebraic or effects.terms().rotary_inertia
    if turning and not effects.terms().yields and not (_is_slow(scene) or _relaxes_at_once(scene, effects)):
        return "rosenbrock", "nothing yields, so that a method of fifth order takes few steps"
    bdf: Name = "idas" if algebraic else "cvodes"
    if _flow_damps(scene, effects):
        return bdf, "flow damps the elastic waves: BDF of order 2 is the cheapest"
    if _creeps_to_rest(scene, effects):
        return bdf, "it yields throughout and creeps to rest: BDF of order 2, tightly, is the cheapest"
    return "rosenbrock", "elastic waves ring on: a fifth-order method does not damp them by itself"


def _relaxes_at_once(scene: Scene, effects: Effects) -> bool:
    """Whether a viscous stress stops all waves so soon that the Rosenbrock method would reject its smallest step."""
    viscosity, filament = effective_viscosity(scene), scene.filament
    if viscosity is None or not effects.terms().viscous:
        return False
    return viscosity * scene.run.duration > _AT_ONCE * filament.density * filament.span**2


def _algebraic(effects: Effects) -> str:
    """Unknowns that are algebraic, and the effect that would make them differential; empty if there are none."""
    if not effects.terms().inertia:
        return "velocities without inertia" if effects.terms().resists else "positions without inertia"
    algebraic = effects.terms().turns and not effects.terms().rotary_inertia
    return "section angles without rotary inertia" if algebraic else ""


def _flow_damps(scene: Scene, effects: Effects) -> bool:
    """Whether flow continues through the run and damps the motion that the load excites."""
    viscous, modulus, gravity_number = viscous_number(scene), instant_modulus(scene), gravity_number_of(scene)
    if effects.terms().viscous:
        return True
    if not effects.terms().flows or viscous is None or modulus is None:
        return False
    if effects.terms().yields and gravity_number is not None:
        return (gravity_number > math.sqrt(2) and viscous > _OVERDAMPED) or _is_slow(scene)
    return viscous * weight_stress(scene) / modulus < _SHORT_MEMORY or _is_slow(scene)


def _creeps_to_rest(scene: Scene, effects: Effects) -> bool:
    """Whether the filament, or the part of it that pillars leave free, yields, stops, and is too viscous to rebound."""
    scene = unsupported(scene)
    gravity_number, viscous = gravity_number_of(scene), viscous_number(scene)
    if not effects.terms().yields or gravity_number is None or viscous is None:
        return False
    if scene.load.shake > 0:
        return False
    return yields_throughout(scene) and gravity_number <= math.sqrt(2) and viscous > _OVERDAMPED


def _is_slow(scene: Scene) -> bool:
    """Whether the ramp of the load is so slow, compared with the elastic period, that there is no ringing."""
    frequency = ringing(scene).frequency
    if not math.isfinite(frequency) or weight_stress(scene) == 0 or scene.load.shake > 0:
        return False
    return scene.load.ramp > _SLOW_PERIODS * 2 * math.pi / frequency
