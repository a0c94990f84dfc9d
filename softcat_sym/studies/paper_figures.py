"""The paper's figures 2, 3(b) and 4: their scenes, elements, and the numbers of the text."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.integrate import solve_ivp

from softcat_sym.discretization.casadi_printer import CellFunction, evaluate
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.physics import beams, closed_forms
from softcat_sym.physics.regimes import K_I
from softcat_sym.physics.regimes import delta as slenderness
from softcat_sym.physics.regimes import tau_star as tau
from softcat_sym.physics.rheometry import B, alpha, t_high, t_star
from softcat_sym.reference.element_loop import Mesh
from softcat_sym.reference.elements import ElementRun, Snapshot, recalled_elements, snapshot, strip_of
from softcat_sym.scene.reading import load_scene
from softcat_sym.scene.scene import Scene, elastic_time, gravity_time, groups_of
from softcat_sym.simulate import recalled
from softcat_sym.solvers.solution import Progress

if TYPE_CHECKING:
    from softcat_sym.results.run import Run


@dataclass(frozen=True)
class ElementFilm:
    """A finished run with its snapshots."""

    run: ElementRun  # Midpoint, energies and strains at all output times
    point: Floats  # shape (4 elements, 2); Reference positions of the Gauss points over the span
    snapshots: tuple[Snapshot, ...]  # In order of time

    def at(self, instant: float) -> Snapshot:
        """The snapshot nearest to a time t~."""
        return min(self.snapshots, key=lambda shot: abs(shot.time - instant))


def film_elements(scene: Scene, mesh: Mesh, instants: tuple[float, ...], progress: Progress) -> ElementFilm:
    """Run a scene with elements and keep the whole strip at some instants."""
    shares = [instant * elastic_time(scene) / scene.run.duration for instant in instants]
    run = recalled_elements(scene, mesh, fields=shares, progress=progress)
    strip, span = strip_of(scene, run), scene.filament.span
    times, rates = run.rate_time / run.elastic_time, run.rate * run.elastic_time
    shots = (snapshot(strip, *shot) for shot in zip(times.tolist(), run.displacement / span, rates, strict=True))
    return ElementFilm(run, strip.points.reshape(-1, 2), tuple(shots))


ALPHA = 46.0
"""The paper's unit of the snapshots' times, in L sqrt(rho/E)."""

INSTANTS = tuple(share * ALPHA for share in (0.25, 0.5, 1.0, 2.0, 10.0))
"""Times t~ of the snapshots."""

MESH = Mesh(64, 4)

PAPER, PRINTED, OWN = "paper's physics, material closure", "paper's physics, printed closure", "chosen by the program"
THEORIES: dict[str, dict[str, object]] = {
    PAPER: {"run.effects": "paper", "run.closure": "material"},
    PRINTED: {"run.effects": "paper", "run.closure": "printed"},
    OWN: {},
}

# A width that is small as the elements assume, and enough frames for oscillations.
_CHANGES: dict[str, object] = {"filament.width": "0.06 mm", "run.frames": 801}


@dataclass(frozen=True)
class FigureScene:
    """One set of the paper's parameters."""

    name: str  # Name of the bundled scene
    title: str  # Title in pictures
    parameters: str  # Text with parameters of the scene


SCENES = (
    FigureScene("no-yield", "no yielding", "G = 0.01"),
    FigureScene("arrested-overdamped", "arrested, overdamped", "G = 0.4, V = 26"),
    FigureScene("arrested-underdamped", "arrested, underdamped", "G = 0.25, V = 0.4"),
    FigureScene("edge-of-rupture", "edge of rupture (paper)", "G = 0.4, V = 0.4"),
    FigureScene("continual-descent", "continual descent", "G = 1.9, V = 26"),
)
SNAPSHOTS = ("no-yield", "arrested-overdamped", "continual-descent")
"""Scenes of figure 4(a), (b) and (c); the last one is also the scene of (d)."""


@dataclass(frozen=True)
class FilmedScene:
    """A scene with its runs as elements and as filaments."""

    of: FigureScene  # Its name and titles
    scene: Scene  # The scene with the effects that the program chooses
    film: ElementFilm  # The elements
    filaments: dict[str, Run]  # By the names of `THEORIES`, including localised runs

    @property
    def elements(self) -> tuple[Floats, Floats]:
        """t~ and y/L of the elements' midpoint."""
        run = self.film.run
        return run.time / run.elastic_time, run.midpoint / self.scene.filament.span

    def filament(self, theory: str) -> tuple[Floats, Floats]:
        """t~ and y/L of a filament's midpoint."""
        data = self.filaments[theory].data
        return data["time"].values / elastic_time(self.scene), data["midpoint"].values / self.scene.filament.span


def film_scene(of: FigureScene, progress: Progress, mesh: Mesh = MESH) -> FilmedScene:
    """Run a scene as elements and as filaments."""
    scene = load_scene(of.name, _CHANGES)
    progress.stage(f"{of.name}: elements")
    film = film_elements(scene, mesh, INSTANTS, progress)
    filaments = {}
    for theory, changes in THEORIES.items():
        progress.stage(f"{of.name}: {theory}")
        filaments[theory] = recalled(load_scene(of.name, {**_CHANGES, **changes}), progress)
    return FilmedScene(of, scene, film, filaments)


MOMENTS = (46.0, 115.0, 230.0, 460.0)
"""t~ at which midpoints are tabulated."""

RINGING_SINCE = 60.0
"""Time t~ from which means over oscillations are taken."""


def stopping_depth(gravity_number: float) -> dict[str, float | None]:
    """H_stop/L of (3.13) and of the exact catenary; None if the filament does not stop."""
    return {
        "paper": beams.stopping_depth(gravity_number) if gravity_number < beams.ARREST_THRESHOLD else None,
        "exact": beams.stopping_depth_exact(gravity_number) if gravity_number < beams.ARREST_THRESHOLD_EXACT else None,
    }


def scene_facts(filmed: FilmedScene) -> dict[str, Any]:
    """Parameters, midpoints, means and strains of a scene by elements and by filaments."""
    groups = groups_of(filmed.scene)
    material, run = filmed.scene.material, filmed.film.run
    gravity_number = float(groups.G or 0.0)
    curves = {"elements": filmed.elements} | {name: filmed.filament(name) for name in THEORIES}
    thickness = filmed.scene.filament.thickness / filmed.scene.filament.span
    return {
        "scene": filmed.of.name,
        "delta": thickness,
        "G": gravity_number,
        "eps_Y": (material.yield_stress or 0.0) / (material.youngs_modulus or 1.0),
        "V": float(groups.V or 0.0),
        "stopping_depth_over_L": stopping_depth(gravity_number),
        "midpoint_over_L": {name: _tabulated(*curve) for name, curve in curves.items()},
        "regime": {name: filmed.filaments[name].summary["regime"] for name in THEORIES},
        "outcome": {name: filmed.filaments[name].outcome.name for name in THEORIES},
        "effects": {name: list(filmed.filaments[name].summary["effects"]) for name in THEORIES},
        "strain_at_clamp": {
            "mean": float(np.expm1(run.clamp_strain[-1])),
            "largest": float(np.expm1(run.clamp_strain_largest[-1])),
        },
        "dissipated_over_work_of_gravity": float(run.energy_dissipated[-1] / run.work),
        "mesh": [run.mesh.along, run.mesh.through],
        "element_steps": run.steps,
    }


def _tabulated(time: Floats, height: Floats) -> dict[str, float | None]:
    """Heights at `MOMENTS`, and their mean while the filament rings; None after a run has ended early."""
    slack = 1e-9 * MOMENTS[-1]
    at = {f"{t:g}": float(np.interp(t, time, height)) if t <= time[-1] + slack else None for t in MOMENTS}
    late = time >= RINGING_SINCE
    whole = MOMENTS[-1] <= time[-1] + slack
    return {**at, "mean": float(height[late].mean()) if whole else None}


LOAD_OVER_VISCOSITY = 3.3e-5
DURATION = 20.0
_FRAMES = 4001
_FITTED_PERIODS, _SHOWN_PERIODS = 1.5, 4.0
_POINTS = 600

SLENDERNESS = (0.0025, 0.025)
"""The regimes of the figure need the first value; the paper prints the second in its caption."""

RELAXATION = (0.35, 0.035)


@dataclass(frozen=True)
class Curve:
    """Sag of the midpoint over the span against time in sqrt(L/g)."""

    name: str  # Label
    time: Floats  # shape (points,); Dimensionless; the sag is positive down
    sag: Floats


@dataclass(frozen=True)
class Panel:
    """One filament with its curves and numbers."""

    delta: float  # Slenderness and relaxation time
    tau_star: float
    curves: tuple[Curve, ...]  # Full and reduced model first, then the formulas
    t_low: float  # End of free fall and start of the 1/3 law by the formulas
    t_high: float
    tension_over_bending: float  # Load carried by tension over load carried by bending at t_high, on the 1/3 law
    outcomes: dict[str, str]  # Outcomes of the two runs


def maxwell_descents(on_progress: Callable[[str], None]) -> tuple[Panel, ...]:
    """Run the figure's filaments with both models, at both values of delta."""
    return tuple(_panel(delta, tau_star, on_progress) for delta in SLENDERNESS for tau_star in RELAXATION)


def _panel(delta: float, tau_star: float, on_progress: Callable[[str], None]) -> Panel:
    runs = {}
    for model in ("filament", "small-deflection"):
        on_progress(f"tau* = {tau_star:g}, delta = {delta:g}, {model}")
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
        runs[model] = recalled(load_scene("maxwell-slow", changes))
    scene = runs["filament"].scene
    unit, span = gravity_time(scene), scene.filament.span
    full, reduced = (
        Curve(name, runs[model].data.time.values / unit, -runs[model].data.midpoint.values / span)
        for name, model in (("full model", "filament"), ("reduced model (2.18)", "small-deflection"))
    )
    known = {B: LOAD_OVER_VISCOSITY, tau: tau_star, alpha: float(closed_forms.TOLERANCE)}
    high = _number(closed_forms.T_HIGH, known)
    sag_high = -_number(closed_forms.THIRD_LAW, {**known, t_star: high})
    slender = {closed_forms.phi: 4 * sag_high, slenderness: groups_of(scene).delta, K_I: 1 / 12}
    curves = (full, reduced, *_outer(known, high, full.time), *_ringing(known, high, full))
    return Panel(
        delta,
        tau_star,
        tuple(map(_thinned, curves)),
        t_low=_end_of_free_fall(known),
        t_high=high,
        tension_over_bending=_number(closed_forms.TENSION_TO_BENDING, slender),
        outcomes={model: run.outcome.name for model, run in runs.items()},
    )


def _number(expression: Any, values: dict[Any, Any]) -> float:
    return float(evaluate(expression, values)[0])


def _thinned(curve: Curve) -> Curve:
    """The curve with at most some hundred points, evenly spaced on a logarithmic axis."""
    later = np.flatnonzero(curve.time > 0)
    marks = np.geomspace(curve.time[later[0]], curve.time[-1], _POINTS)
    kept = np.unique(np.clip(np.searchsorted(curve.time, marks), 0, len(curve.time) - 1))
    return Curve(curve.name, curve.time[kept], curve.sag[kept])


def _end_of_free_fall(known: dict[object, float]) -> float:
    """Time at which tension over inertia reaches alpha on the parabola of free fall, for any ratio of t_low to tau."""
    limits = [_number(limit, known) for limit in (closed_forms.T_LOW_LONG, closed_forms.T_LOW_SHORT)]
    time = np.geomspace(min(limits) / 2, 4 * max(limits), 4000)
    ratio = evaluate(closed_forms.EARLY_RATIO, {**known, t_star: time})
    return float(np.interp(known[alpha], ratio, time))


def _outer(known: dict[object, float], high: float, time: Floats) -> tuple[Curve, ...]:
    """Free fall, (2.20) from rest and as printed, and the 1/3 law."""
    early = time[(time > 0) & (time < 3 * high)]
    fall = Curve("free fall", early, -evaluate(closed_forms.FREE_FALL, {**known, t_star: early}))
    first = _number(closed_forms.ELASTIC_START, known)
    last = _number(closed_forms.THIRD_LAW_FACTOR, {**known, t_star: time[-1]})
    phi = np.geomspace(first * 1.0001, last * 1.1, 400)
    outer = []
    for name, law in (
        ("(2.20) from rest", closed_forms.OUTER_TIME_FROM_REST),
        ("(2.20) as printed", closed_forms.OUTER_TIME),
    ):
        when = evaluate(law, {**known, closed_forms.phi: phi})
        shown = (when > time[1]) & (when <= time[-1])
        outer.append(Curve(name, when[shown], phi[shown] / 4))
    late = time[time > high / 10]
    return fall, *outer, Curve("1/3 law", late, -evaluate(closed_forms.THIRD_LAW, {**known, t_star: late}))


def _ringing(known: dict[object, float], high: float, full: Curve) -> tuple[Curve, ...]:
    """(2.21) integrated and (2.22), each with its three constants fitted to the full model after t_high."""

    def law(at: Floats) -> Floats:
        return -evaluate(closed_forms.THIRD_LAW, {**known, t_star: at})

    frequency = _number(closed_forms.FREQUENCY, {**known, t_high: high})
    if not np.isfinite(frequency):
        return ()
    period = 2 * np.pi / frequency
    window = (full.time >= high) & (full.time <= high + _SHOWN_PERIODS * period)
    time = full.time[window]
    fitted = time <= high + _FITTED_PERIODS * period
    rest = (full.sag[window] - law(time))[fitted]
    shift = time - high
    damped = np.exp(-_number(closed_forms.DECAY_RATE, known) * shift)
    closed = np.array([np.ones_like(time), damped * np.cos(frequency * shift), damped * np.sin(frequency * shift)])
    coefficients = CellFunction({f"{k}": c.subs(known) for k, c in enumerate(closed_forms.OSCILLATION)}, (t_star,))

    def rates(at: float, f: Floats) -> list[float]:
        third, second, first = (float(value) for value in coefficients({t_star: at}).values())
        return [f[1], f[2], -(second * f[2] + first * f[1]) / third]

    spans = {"t_span": (time[0], time[-1]), "t_eval": time, "method": "DOP853", "rtol": 1e-9, "atol": 1e-12}
    numeric = np.array([solve_ivp(rates, y0=start, **spans).y[0] for start in np.eye(3)])
    return tuple(
        Curve(name, time, law(time) + basis.T @ np.linalg.lstsq(basis.T[fitted], rest, rcond=None)[0])
        for name, basis in (("(2.21) integrated", numeric), ("(2.22)", closed))
    )
