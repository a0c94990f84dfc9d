"""The paper's figure 2: a sagging Maxwell filament against free fall, outer solution, 1/3 law and ringing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from softcat_sym.equations import asymptotics as far
from softcat_sym.equations.regimes import delta as slenderness
from softcat_sym.equations.regimes import tau_star as tau
from softcat_sym.equations.rheometry import B, alpha, t_high, t_star
from softcat_sym.equations.small_deflection import K_I
from softcat_sym.graph.grid import Floats
from softcat_sym.printing import evaluate
from softcat_sym.scene import gravity_time, groups_of, load_scene
from softcat_sym.simulate import simulated
from softcat_sym.solve.linear_ode import fundamental_solutions

LOAD_OVER_VISCOSITY = 3.3e-5
DURATION = 20.0
_FRAMES = 4001
_FITTED_PERIODS, _SHOWN_PERIODS = 1.5, 4.0
_POINTS = 600

SLENDERNESS = (0.0025, 0.025)
"""The figure's own regimes need the first; the second is printed under it."""

RELAXATION = (0.35, 0.035)


@dataclass(frozen=True)
class Curve:
    """Sag of the midpoint over the span against time in sqrt(L/g).

    Attributes
    ----------
    name : str
        What it is.
    time, sag : ndarray, shape (points,)
        Dimensionless, positive down.
    """

    name: str
    time: Floats
    sag: Floats


@dataclass(frozen=True)
class Panel:
    """One filament and all that is said of it.

    Attributes
    ----------
    delta, tau_star : float
        Slenderness and relaxation time.
    curves : tuple of Curve
        Full and reduced model first, then the formulas.
    t_low, t_high : float
        End of free fall and start of the 1/3 law by the formulas.
    tension_over_bending : float
        Load borne by tension over load borne by bending at t_high, on the 1/3 law.
    outcomes : dict of str to str
        Verdicts of the two runs.
    """

    delta: float
    tau_star: float
    curves: tuple[Curve, ...]
    t_low: float
    t_high: float
    tension_over_bending: float
    outcomes: dict[str, str]


def maxwell_descents(told: Callable[[str], None]) -> tuple[Panel, ...]:
    """Run the figure's filaments, both models, at both slendernesses.

    Parameters
    ----------
    told : callable
        Told what is being run.
    """
    return tuple(_panel(delta, tau_star, told) for delta in SLENDERNESS for tau_star in RELAXATION)


def _panel(delta: float, tau_star: float, told: Callable[[str], None]) -> Panel:
    runs = {}
    for model in ("filament", "small-deflection"):
        told(f"tau* = {tau_star:g}, delta = {delta:g}, {model}")
        changes: dict[str, object] = {
            "groups.delta": delta,
            "groups.tau": tau_star,
            "groups.B": LOAD_OVER_VISCOSITY,
            "groups.duration": DURATION,
            "run.frames": _FRAMES,
            "run.effects": "paper",
            "model": model,
            "numerics.estimate": False,
        }
        runs[model] = simulated(load_scene("maxwell-slow", changes))
    scene = runs["filament"].scene
    unit, span = gravity_time(scene), scene.filament.span
    full, reduced = (
        Curve(name, runs[model].data.time.values / unit, -runs[model].data.midpoint.values / span)
        for name, model in (("full model", "filament"), ("reduced model (2.18)", "small-deflection"))
    )
    known = {B: LOAD_OVER_VISCOSITY, tau: tau_star, alpha: float(far.TOLERANCE)}
    low = _end_of_free_fall(known)
    high = float(evaluate(far.T_HIGH, known)[0])
    sag_high = -float(evaluate(far.THIRD_LAW, {**known, t_star: high})[0])
    formulas = (*_outer(known, high, full.time), *_ringing(known, high, full))
    outcomes = {model: run.outcome.name for model, run in runs.items()}
    share = float(
        evaluate(far.TENSION_TO_BENDING, {far.phi: 4 * sag_high, slenderness: groups_of(scene).delta, K_I: 1 / 12})[0]
    )
    curves = tuple(_thinned(curve) for curve in (full, reduced, *formulas))
    return Panel(delta, tau_star, curves, low, high, share, outcomes)


def _thinned(curve: Curve) -> Curve:
    """At most some hundred points, evenly spaced on a logarithmic axis."""
    later = np.flatnonzero(curve.time > 0)
    marks = np.geomspace(curve.time[later[0]], curve.time[-1], _POINTS)
    kept = np.unique(np.clip(np.searchsorted(curve.time, marks), 0, len(curve.time) - 1))
    return Curve(curve.name, curve.time[kept], curve.sag[kept])


def _end_of_free_fall(known: dict[object, float]) -> float:
    """Time at which tension reaches alpha of inertia on the falling parabola, for any ratio of t_low to tau."""
    limits = [float(evaluate(limit, known)[0]) for limit in (far.T_LOW_LONG, far.T_LOW_SHORT)]
    time = np.geomspace(min(limits) / 2, 4 * max(limits), 4000)
    ratio = evaluate(far.EARLY_RATIO, {**known, t_star: time})
    return float(np.interp(known[alpha], ratio, time))


def _outer(known: dict[object, float], high: float, time: Floats) -> tuple[Curve, ...]:
    """Free fall, (2.20) from rest and as printed, and the 1/3 law."""
    early = time[(time > 0) & (time < 3 * high)]
    fall = Curve("free fall", early, -evaluate(far.FREE_FALL, {**known, t_star: early}))
    first = float(evaluate(far.ELASTIC_START, known)[0])
    last = float(evaluate(far.THIRD_LAW_FACTOR, {**known, t_star: time[-1]})[0])
    phi = np.geomspace(first * 1.0001, last * 1.1, 400)
    outer = []
    for name, law in (("(2.20) from rest", far.OUTER_TIME_FROM_REST), ("(2.20) as printed", far.OUTER_TIME)):
        when = evaluate(law, {**known, far.phi: phi})
        shown = (when > time[1]) & (when <= time[-1])
        outer.append(Curve(name, when[shown], phi[shown] / 4))
    late = time[time > high / 10]
    return fall, *outer, Curve("1/3 law", late, -evaluate(far.THIRD_LAW, {**known, t_star: late}))


def _ringing(known: dict[object, float], high: float, full: Curve) -> tuple[Curve, ...]:
    """(2.21) integrated and (2.22), each with its three constants fitted to the full model after t_high."""

    def law(at: Floats) -> Floats:
        return -evaluate(far.THIRD_LAW, {**known, t_star: at})

    frequency = float(evaluate(far.FREQUENCY, {**known, t_high: high})[0])
    if not np.isfinite(frequency):
        return ()
    period = 2 * np.pi / frequency
    window = (full.time >= high) & (full.time <= high + _SHOWN_PERIODS * period)
    time = full.time[window]
    fitted = time <= high + _FITTED_PERIODS * period
    wanted = (full.sag[window] - law(time))[fitted]
    shift = time - high
    damped = np.exp(-float(evaluate(far.DECAY_RATE, known)[0]) * shift)
    closed = np.array([np.ones_like(time), damped * np.cos(frequency * shift), damped * np.sin(frequency * shift)])
    coefficients = tuple(c.subs(known) for c in far.OSCILLATION)
    numeric = fundamental_solutions(coefficients, t_star, time)
    return tuple(
        Curve(name, time, law(time) + basis.T @ np.linalg.lstsq(basis.T[fitted], wanted, rcond=None)[0])
        for name, basis in (("(2.21) integrated", numeric), ("(2.22)", closed))
    )
