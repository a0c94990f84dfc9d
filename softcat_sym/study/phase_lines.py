"""Lines of a phase plane by formulas: the paper's, those without its approximations, and estimates in closed form."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

import numpy as np

from softcat_sym.effects.expected_regime import TURNS_BACK
from softcat_sym.effects.plastic_overshoot import overshoot, rebound, ringing_share
from softcat_sym.effects.prediction import beam_of, instant_modulus, weight_stress
from softcat_sym.equations import regimes
from softcat_sym.equations.section import SECTIONS, Section
from softcat_sym.graph.grid import Floats
from softcat_sym.scene import Scene
from softcat_sym.scene.scales import gravity_time
from softcat_sym.study.phase_plane import PhasePlane, Place, place_at
from softcat_sym.trajectory.regime import ARREST_RATE

Kind = Literal["first yield", "arrest", "overdamping", "arrest of the span"]
Source = Literal["paper", "exact", "estimate"]

_CLAMPED_BEAM = 4.730041**2  # first natural frequency of a clamped beam, in sqrt(EI/(rho A L^4))
_PSI, _PSI_POINTS = (0.1, 300.0), 160  # psi of first yield: linear beam to taut string


@dataclass(frozen=True)
class PhaseLine:
    """One line.

    Attributes
    ----------
    name : str
        What it says.
    kind : str
        The boundary that it is a formula of.
    source : str
        ``"paper"``, ``"exact"`` of its own idealisation, or ``"estimate"``.
    equation : str
        Where it is from.
    other : ndarray
        delta or V, shape (points,).
    G : ndarray
        Gravity number there; NaN where there is none.
    """

    name: str
    kind: Kind
    source: Source
    equation: str
    other: Floats
    G: Floats

    def at(self, other: float) -> float:
        """G at a value of the other group, between its points by the logarithm."""
        return float(np.exp(np.interp(math.log(other), np.log(self.other), np.log(self.G))))


def phase_lines(scene: Scene, plane: PhasePlane, points: int = 81) -> tuple[PhaseLine, ...]:
    """The lines of a plane.

    Parameters
    ----------
    scene : Scene
        For its section, ends, modulus and ramp.
    plane : PhasePlane
        G and another group.
    points : int
        Of each line.
    """
    other = np.geomspace(plane.y.low, plane.y.high, points)
    places = [place_at(scene, plane, 1.0, float(value)) for value in other]
    section, beam = SECTIONS[scene.filament.section], beam_of(scene)

    def line(name: str, kind: Kind, source: Source, equation: str, G: Callable[[Place], float]) -> PhaseLine:
        return PhaseLine(name, kind, source, equation, other, np.array([G(place) for place in places]))

    def beam_line(expression: Any) -> Callable[[Place], float]:
        slope = float(expression.subs(regimes.delta, 1))
        return lambda place: slope * place.delta

    static, sudden = regimes.first_yield(section, beam), regimes.first_yield_at_once(section, beam)
    exact = float(regimes.arrest_threshold_exact())
    # What counts as arrested may flow at this rate still: its stress is that much above the yield stress.
    at_rate = 1 + ARREST_RATE
    found = [
        line("first yield of a beam", "first yield", "paper", "(3.11)", beam_line(static)),
        line("arrest of a shallow catenary", "arrest", "paper", "(3.12)", lambda _: math.sqrt(2)),
        line("sudden load, undamped beam", "first yield", "exact", "(3.11) over the bound", beam_line(sudden)),
        line("arrest of the exact catenary", "arrest", "exact", "(3.12), exact", lambda _: exact),
        line("the same, of rate 0.5", "arrest of the span", "exact", "(3.12) at 1.5 σʏ", lambda _: exact * at_rate),
        line("spring-back of 5 %", "overdamping", "estimate", "one-mode fall", _overdamped(scene)),
    ]
    if beam == regimes.CLAMPED:
        slow = _slow_yield(scene, section)
        found += [
            line("slow load, bending and tension", "first yield", "exact", "(3.11) with tension", slow),
            line(
                "this ramp, first mode", "first yield", "estimate", "ramp gain", _ramped(scene, section, static, slow)
            ),
        ]
    return tuple(found)


def modulus_number(scene: Scene) -> float:
    """E* = E/(rho g L), which all filaments of a diagram share."""
    return (instant_modulus(scene) or math.inf) / weight_stress(scene)


def _slow_yield(scene: Scene, section: Section) -> Callable[[Place], float]:
    """G of first yield under a slow load, from eps_Y G E* = 1 along the curve of psi; NaN beyond its end.

    eps_Y goes as delta^2 and G as delta at a given psi: one table of their product serves every filament.
    """
    product, gravity = _yield_curve(section)
    modulus = modulus_number(scene)

    def found(place: Place) -> float:
        wanted = -math.log(modulus * place.delta**3)
        return place.delta * math.exp(float(np.interp(wanted, product, gravity, right=math.nan)))

    return found


@cache
def _yield_curve(section: Section) -> tuple[Floats, Floats]:
    """Logarithms of eps_Y G and of G along the curve of first yield, of a filament as thick as long."""
    curve = regimes.first_yield_stretched(section)
    strain, gravity = (side.subs(regimes.delta, 1) for side in (curve.yield_strain, curve.gravity_number))
    points = np.geomspace(*_PSI, _PSI_POINTS)
    values = [[float(side.subs(regimes.psi_T, psi)) for psi in points] for side in (strain, gravity)]
    logarithms = np.log(np.array(values))
    return logarithms[0] + logarithms[1], logarithms[1]


def _ramped(scene: Scene, section: Section, static: Any, slow: Callable[[Place], float]) -> Callable[[Place], float]:
    """Static first yield over what the first mode of the beam overshoots by after the ramp.

    A filament that swings is not relied on to have its tension when it bends most.
    """
    beam = beam_of(scene)
    slope, bound = float(static.subs(regimes.delta, 1)), float(beam.overshoot_bound)
    speed = _CLAMPED_BEAM * math.sqrt(float(regimes.gyration(section)) * modulus_number(scene))
    ramp = scene.load.ramp / gravity_time(scene)

    def found(place: Place) -> float:
        left = ringing_share(speed * place.delta, ramp)
        linear = slope * place.delta
        return (linear + (1 - left) * (slow(place) - linear)) / (1 + (bound - 1) * left)

    return found


def _overdamped(scene: Scene) -> Callable[[Place], float]:
    """G at which the filament springs back by `TURNS_BACK` of its sag; NaN if at none between 0.1 and 1.3255."""
    ramp, modulus = scene.load.ramp / gravity_time(scene), modulus_number(scene)
    G = np.geomspace(0.1, float(regimes.arrest_threshold_exact()), 60)
    left = [ringing_share(math.sqrt(10 / value), ramp) for value in G]

    def found(place: Place) -> float:
        past = [1 + (overshoot(value, place.V, 0.0) - 1) * share for value, share in zip(G, left, strict=True)]
        springs = [rebound(value, 1 / (modulus * value), far) for value, far in zip(G, past, strict=True)]
        excess = np.array(springs) - TURNS_BACK
        falls = np.flatnonzero((excess[:-1] > 0) & (excess[1:] <= 0))
        if not len(falls):
            return math.nan
        k = int(falls[0])
        return float(np.exp(np.interp(0.0, -excess[k : k + 2], np.log(G[k : k + 2]))))

    return found
