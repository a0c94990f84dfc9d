"""Every integrator and both backends find the same motion; what fails says when, where and what to do."""

from __future__ import annotations

import os
import signal
import threading
import time
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.discretization.graph import Graph
from softcat_sym.discretization.parameters import energy_scale
from softcat_sym.discretization.unknowns import Floats
from softcat_sym.effects.selection import choose_effects
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.scene.scene import Scene, rest_length
from softcat_sym.single_run import build
from softcat_sym.solvers import compiled, equilibrium, settings
from softcat_sym.solvers.compiled import CompiledIntegration
from softcat_sym.solvers.equilibrium import Equilibrium, settled
from softcat_sym.solvers.outcome import Outcome
from softcat_sym.solvers.settings import choose_backend, choose_settings
from softcat_sym.solvers.solution import Silence, Solution
from softcat_sym.solvers.solve import Prepared
from tests.common.assembled import (
    Listener,
    largest_difference,
    midpoint,
    prepared,
    settings_of,
    short_scene,
    without,
)

TIGHT = 1e-9
FIBRES = [
    *("inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "viscous-flow"),
    *("yielding", "gravity-ramp", "shear", "fibres", "necking-gradient"),
]
MOTION = [["0 s", "0 mm", "0 mm"], ["0.3 s", "20 mm", "0 mm"], ["0.6 s", "30 mm", "5 mm"]]
LONG = sc.load_scene("no-yield", {"numerics.cells": 200, "numerics.rtol": "1e-10"})
"""Takes far longer than any of the waits below."""


@cache
def kinds() -> dict[str, Scene]:
    """Filaments with differential and algebraic unknowns, sections, moving supports, profiles and free ends."""
    small = {"numerics.cells": 4, "run.frames": 7}
    fibres = {"run.effects": FIBRES, "numerics.fibres": 3, "groups.duration": 20.0}
    return {
        "bingham": short_scene("bingham"),
        "no inertia": without(short_scene("bingham"), "inertia"),
        "fibres": sc.load_scene("arrested-overdamped", small | fibres),
        "viscous stress, moving support": sc.load_scene(
            "drawn-blob", small | {"ends.motion": MOTION, "run.duration": "1 s"}
        ),
        "profile, free end": sc.load_scene(
            "curled-rod", small | {"filament.profile": [1.5, 1, 0.5], "run.duration": "0.3 s"}
        ),
        "point mass, no inertia": sc.load_scene("beam-viscometer", small),
        "supports apart": sc.load_scene("slime-slope", small | {"run.duration": "0.2 s"}),
        "elastic": short_scene("elastic"),
        "maxwell": short_scene("maxwell"),
    }


QUICK = ("bingham", "no inertia", "fibres", "viscous stress, moving support")


def asking(scene: Scene, **numerics: Any) -> Scene:
    return scene.replace({f"numerics.{key}": value for key, value in numerics.items()})


def twin(scene: Scene, backend: str = "compiled", **numerics: Any) -> Prepared:
    """Ready to be solved by the Rosenbrock method, on either backend."""
    scene = asking(scene, **{"backend": backend, "solver": "rosenbrock", **numerics})
    return build(scene, choose_effects(scene))


def integration(run: Prepared) -> CompiledIntegration:
    assert isinstance(run.integration, CompiledIntegration)
    return run.integration


def test_the_integrator_follows_from_what_rings_and_what_is_algebraic() -> None:
    for name, published, sheared in [
        ("continual-descent", "cvodes", "idas"),
        ("silicone-thread", "cvodes", "rosenbrock"),
        ("arrested-underdamped", "rosenbrock", "rosenbrock"),
        ("no-yield", "rosenbrock", "rosenbrock"),
        ("maxwell-slow", "rosenbrock", "rosenbrock"),
    ]:
        for effects, solver in (("paper", published), ("auto", sheared)):
            scene = sc.load_scene(name, {"run.effects": effects})
            chosen = choose_settings(scene, choose_effects(scene))
            assert chosen.solver == solver and chosen.reason, (name, effects)
    creeping = sc.load_scene("arrested-overdamped")
    chosen = choose_settings(creeping, choose_effects(creeping))
    assert chosen.solver == "idas" and chosen.rtol < 0.1 * creeping.run.accuracy
    assert settings_of(without(short_scene(), "inertia")).solver == "idas"
    refused = {"numerics.solver": "cvodes", "run.effects": ["bending", "viscous-flow", "yielding"]}
    with pytest.raises(SceneError, match=r"numerics\.solver: 'cvodes' cannot"):
        sc.simulate(sc.load_scene("arrested-overdamped", refused))


def test_a_run_has_the_frames_that_were_requested_however_it_is_cut_into_chunks() -> None:
    """Also where the last chunk goes beyond the end, as nine intervals in eight chunks do."""
    moving = [
        (short_scene(frames=n, cells=4), solver) for n in (2, 3, 9, 10, 33) for solver in ("cvodes", "rosenbrock")
    ]
    still = [
        (without(short_scene(law, frames=n, cells=4), "inertia"), None)
        for n in (2, 9)
        for law in ("elastic", "bingham")
    ]
    for scene, solver in [*moving, *still]:
        listener = Listener()
        run = prepared(scene, **({"solver": solver} if solver else {}))
        solution = run.solve(listener)
        assert (solution.outcome, solution.message) == (Outcome.solved, "")
        np.testing.assert_allclose(solution.time, run.times, rtol=1e-12)
        assert len(run.times) == scene.run.frames
        for states in (solution.x, solution.z, solution.quad):
            assert states.shape[1] == scene.run.frames
        np.testing.assert_array_equal(solution.x[:, 0], run.graph.start)
        np.testing.assert_array_equal(solution.quad[:, 0], 0)
        assert np.all(np.diff(listener.times) > 0) and listener.times[-1] == pytest.approx(0.1, rel=1e-12)
        if solver and scene.run.frames != 10:
            assert all(step is not None for step in listener.steps)
            lengths = np.diff([0.0, *listener.times])
            counted = sum(length / step for length, step in zip(lengths, listener.steps, strict=True) if step)
            assert solution.steps == pytest.approx(counted, abs=0.01)


@cache
def tight(law: str, solver: str, inertia: bool) -> tuple[Floats, Solution]:
    scene = short_scene(law) if inertia else without(short_scene(law), "inertia")
    run = prepared(scene, solver=solver, rtol=1e-8, atol=1e-10)
    solution = run.solve(Silence())
    assert solution.outcome is Outcome.solved
    return midpoint(run, solution.x if inertia else solution.z), solution


def test_independent_integrators_find_the_same_motion() -> None:
    for law in ("elastic", "maxwell", "bingham"):
        one, two = (tight(law, solver, True)[0] for solver in ("cvodes", "rosenbrock"))
        assert np.max(np.abs(two)) > 1e-4
        np.testing.assert_allclose(one, two, rtol=0, atol=2e-5 * np.max(np.abs(two)))
    for law in ("maxwell", "bingham"):
        (one, first), (two, second) = (tight(law, solver, False) for solver in ("idas", "rosenbrock"))
        assert np.max(np.abs(two)) > 1e-4
        np.testing.assert_allclose(one, two, rtol=0, atol=2e-6 * np.max(np.abs(two)))
        np.testing.assert_allclose(first.quad, second.quad, rtol=0, atol=1e-5 * np.max(np.abs(second.quad)))
    wanted, _ = tight("bingham", "rosenbrock", True)
    for accuracy in (1e-2, 1e-3):
        for solver in ("cvodes", "rosenbrock"):
            run = prepared(short_scene().replace({"run.accuracy": accuracy}), solver=solver)
            found = midpoint(run, run.solve(Silence()).x)
            np.testing.assert_allclose(found, wanted, rtol=0, atol=accuracy * np.max(np.abs(wanted)))


def test_equilibria_are_the_limit_of_slow_motion_and_their_work_is_stored() -> None:
    slow = short_scene("elastic", frames=5, duration="2 s", ramp="2 s")
    moving, still = prepared(slow, solver="rosenbrock", rtol=1e-6, atol=1e-9), prepared(without(slow, "inertia"))
    one, two = midpoint(moving, moving.solve(Silence()).x), midpoint(still, still.solve(Silence()).z)
    np.testing.assert_allclose(one, two, rtol=0, atol=5e-3 * abs(two[-1]))
    scene, listener = without(short_scene("elastic", frames=41), "inertia"), Listener()
    run = prepared(scene)
    assert run.integration is None
    solution = run.solve(listener)
    np.testing.assert_allclose(listener.times, 0.1 * np.arange(1, 41) / 40, rtol=1e-12)
    assert np.all(np.diff(midpoint(run, solution.z)) <= 1e-12)
    observed = run.graph.observe(solution.time, solution.x, solution.z, run.p)
    stored = (observed["energy_elastic"] + observed["energy_potential"])[:, 0]
    span = scene.filament.span
    work = solution.quad[1] * energy_scale(scene.filament.density, span, run.scale) * span
    assert abs(work[-1]) > 0
    np.testing.assert_allclose(work, stored - stored[0], rtol=0, atol=2e-3 * np.max(np.abs(stored)))


@pytest.mark.parametrize(
    "kind", [pytest.param(kind, marks=() if kind in QUICK else pytest.mark.slow) for kind in kinds()]
)
def test_the_compiled_run_is_the_interpreted_one(kind: str) -> None:
    runs = [twin(kinds()[kind], backend, rtol=TIGHT) for backend in ("compiled", "interpreted")]
    starts = [run.start for run in runs if run.start is not None]
    # Newton's method in C and by CasADi meets the same equilibrium.
    np.testing.assert_allclose(*(np.append(start.x, start.z) for start in starts), rtol=0, atol=1e-15)
    one, other = (run.solve(Silence()) for run in runs)
    assert one.outcome is other.outcome is Outcome.solved
    np.testing.assert_allclose(one.time, other.time, rtol=1e-13)
    np.testing.assert_array_equal(np.append(one.x[:, 0], one.z[:, 0]), np.append(starts[0].x, starts[0].z))
    assert largest_difference(runs[0], one, other) < 2e-6
    assert float(np.max(np.abs(one.quad - other.quad)) / np.max(np.abs(other.quad))) < 2e-6


def test_compiled_failures_keep_the_sound_part(monkeypatch: pytest.MonkeyPatch) -> None:
    run = twin(short_scene(frames=11))
    whole = run.solve(Silence())
    monkeypatch.setattr(compiled, "_MAX_STEPS", whole.steps // 2)
    monkeypatch.setattr(compiled, "_STEPS_PER_FRAME", 0)
    cut = run.solve(Silence())
    frames = len(cut.time)
    assert cut.outcome is Outcome.step_limit and 1 < frames < 11
    np.testing.assert_array_equal(cut.x, whole.x[:, :frames])
    np.testing.assert_array_equal(cut.quad, whole.quad[:, :frames])
    assert "] at X/L = " in cut.message
    reached = float(cut.message.removeprefix("stopped after t = ").split(" s")[0])
    assert cut.time[-1] * run.scale <= reached * (1 + 1e-5) < whole.time[frames] * run.scale
    p = run.p.copy()
    p[run.graph.parameters.index("youngs_modulus")] = np.nan
    lost = replace(run, p=p).solve(Silence())
    assert lost.outcome is Outcome.non_finite and "not finite" in lost.message
    assert len(lost.time) == 1 and np.all(np.isfinite(lost.x))
    assert run.start is not None
    with pytest.raises(SoftcatError, match="refused to begin"):
        integration(run).run(run.start, run.p, -1.0, run.scale, Silence())


def test_ctrl_c_stops_a_long_run() -> None:
    interpreted_one = sc.load_scene("no-yield", {"numerics.cells": 60, "numerics.rtol": "1e-9"})
    for scene in (LONG, asking(interpreted_one, backend="interpreted")):
        sent: list[float] = []

        def press(sent: list[float] = sent) -> None:
            sent.append(time.process_time())
            os.kill(os.getpid(), signal.SIGINT)

        class Started(Silence):
            timer = threading.Timer(0.3, press)

            def update(self, simulated_time: float, step_size: float | None) -> None:
                if not self.timer.ident:
                    self.timer.start()

        threads = threading.active_count()
        with pytest.raises(KeyboardInterrupt):
            sc.simulate(scene, progress=Started())
        # Of the processor, on a machine five times slower than one on which it is a second, or one frame.
        assert time.process_time() - sent[0] < (5 if scene is LONG else 25)
        assert threading.active_count() <= threads + 1, "the integration goes on"
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def chosen(scene: Scene) -> settings.Backend:
    return choose_backend(scene, choose_effects(scene))


def refused(scene: Scene, why: str) -> None:
    with pytest.raises(SceneError) as refusal:
        sc.simulate(asking(scene, backend="compiled"))
    (fault,) = refusal.value.faults
    assert (fault.path, fault.accepted) == ("numerics.backend", "auto or interpreted") and why in fault.found


# Where a run begins: equilibria that Newton's method finds, and that are stable.
KIRCHHOFF = ("bending", "finite-stretch", "thinning", "large-rotation")
THEORIES = {"kirchhoff": KIRCHHOFF, "shearing": (*KIRCHHOFF, "shear")}
BETWEEN_CLAMPS = np.pi**2 / 3
"""Euler's strain of a rectangular column between clamps, over (h0/L)^2: 4 pi^2 I/(A h0^2)."""


@dataclass(frozen=True)
class Shape:
    """A filament in some equilibrium."""

    graph: Graph
    x: Floats
    p: Floats
    straight: Floats
    z: Floats

    def at(self, z: Floats) -> Shape:
        """The same filament elsewhere."""
        return Shape(self.graph, self.x, self.p, self.straight, z)

    def searched(self, guess: Floats) -> Shape:
        """The equilibrium that Newton's method finds from a guess."""
        z = Equilibrium(self.graph).search(0.0, self.x, self.p, [guess])
        assert z is not None
        return self.at(z)

    def settled(self) -> Shape:
        return self.at(settled(self.graph, self.x, self.p, self.z, self.straight))

    @property
    def observed(self) -> dict[str, Floats]:
        found = self.graph.symbolic.observables(time=0.0, state=self.x, algebraic=self.z, parameters=self.p)
        return {name: np.asarray(value, dtype=float).ravel() for name, value in found.items()}

    @property
    def energy(self) -> float:
        return float(self.observed["energy_elastic"][0] + self.observed["energy_potential"][0])

    @property
    def heights(self) -> Floats:
        """y over rest length, from the midpoint to the right support."""
        return self.z[np.isin(self.graph.algebraic.kinds, ("y",))]

    @property
    def stiffness(self) -> float:
        """Lowest eigenvalue of the tangent stiffness over the masses: real, as it is symmetric and they positive."""
        graph = self.graph
        tangent = ca.Function("k", graph.symbolic.inputs, [-ca.jacobian(graph.symbolic.alg, graph.symbolic.z)])
        values = np.linalg.eigvals(np.asarray(tangent(0.0, self.x, self.z, self.p)))
        assert np.max(np.abs(values.imag)) <= 1e-9 * np.max(np.abs(values.real))
        return float(np.min(values.real))


@cache
def started(scene: Scene) -> tuple[Shape, Shape]:
    """What Newton's method finds, and where the run begins."""
    given: list[Shape] = []

    def listen(graph: Graph, x: Floats, p: Floats, z: Floats, straight: Floats) -> Floats:
        given.append(Shape(graph, x, p, straight, z))
        return settled(graph, x, p, z, straight)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(equilibrium, "settled", listen)
        start = build(scene, choose_effects(scene)).start
    assert start is not None
    return given[0], given[0].at(start.z)


@cache
def thick_and_slack(theory: str, gravity: str = "9.81 m/s^2") -> Scene:
    """A soft sheet between pins, 24 % longer than the span and a thirteenth of it thick."""
    table: dict[str, Any] = {
        "filament": {
            "span": "0.2 m",
            "rest_length": "0.2477351494308748 m",
            "thickness": "0.015546410410976368 m",
            "section": "sheet",
            "density": "1000 kg/m^3",
        },
        "material": {
            "law": "bingham",
            "youngs_modulus": "245545.7452684251 Pa",
            "viscosity": "2305.3075020013207 Pa*s",
            "yield_stress": "6178.290227976348 Pa",
        },
        "ends": {"left": "pinned", "right": "pinned"},
        "load": {"gravity": gravity},
        "run": {"duration": "0.58 s", "effects": [*THEORIES[theory], "viscous-flow", "yielding"]},
        "numerics": {"backend": "interpreted", "cells": 16, "grading": 1.0},
    }
    return Scene.model_validate(table)


def column(
    slack: float, *, thickness: float = 0.01, gravity: float = 1e-6, E: float = 1e7, theory: str = "kirchhoff"
) -> Scene:
    """An elastic bar between clamps that are closer than it is long, by this share; span 1 m."""
    filament = {"span": 1.0, "rest_length": 1 + slack, "thickness": thickness, "density": 1000.0}
    return Scene(
        filament=filament,
        material={"law": "elastic", "youngs_modulus": E},
        load={"gravity": gravity},
        run={"duration": 1.0, "frames": 2, "effects": list(THEORIES[theory])},
        numerics={"cells": 20, "grading": 1.0},
    )


def test_a_thick_slack_sheet_hangs_as_a_catenary_of_its_length() -> None:
    depths = []
    for theory in THEORIES:
        scene = thick_and_slack(theory)
        found, begun = started(scene)
        length = rest_length(scene) / scene.filament.span
        # Of an inextensible chain between level supports; u = span/(2 a).
        half = brentq(lambda u, length=length: np.sinh(u) / u - length, 1e-6, 10.0)
        depths.append(-float(np.min(begun.heights)))
        assert depths[-1] * length == pytest.approx((np.cosh(half) - 1) / (2 * half), rel=0.02)
        stretch = begun.observed["stretch"]
        assert np.all((stretch > 1) & (stretch < 1.01)) and np.all(begun.heights < 0)
        assert begun.energy <= found.energy + 1e-9 * abs(found.energy)
        assert begun.stiffness > 0
        if theory == "shearing":  # Newton's method alone would leave it a compressed arch
            assert np.max(found.observed["stretch"]) < 1 and np.min(found.heights) > 0
            assert begun.energy < found.energy - 90
    assert depths[1] == pytest.approx(depths[0], rel=1e-3), "a section that shears hangs where one that does not hangs"


def test_a_stiff_bar_hangs_rather_than_stands() -> None:
    """What leaves the saddle may rise: E = 100 000 rho g L holds it up, and yet hanging is lower."""
    for theory in THEORIES:
        for thickness, slack in [(0.05, 0.05), (0.1, 0.05), (0.1, 2 * BETWEEN_CLAMPS * 0.01)]:
            found, begun = started(column(slack, thickness=thickness, gravity=10.0, E=1e9, theory=theory))
            assert begun.heights[0] < -0.08, (theory, thickness, slack)
            assert begun.energy <= found.energy * (1 + 1e-9)
            assert begun.stiffness > 0


def test_a_column_between_clamps_buckles() -> None:
    """What Euler's strain does not take up is slope: y = a (1 + cos 2 pi X/L)/2 with a = (2 L/pi) sqrt(e - e_c)."""
    critical = BETWEEN_CLAMPS * 1e-4
    for theory in THEORIES:
        for over in (1.2, 2.0, 10.0):
            slack = over * critical
            begun = started(column(slack, theory=theory))[1]
            amplitude, expected = -float(np.min(begun.heights)), 2 / np.pi * np.sqrt(slack - critical)
            where = begun.graph.algebraic.where[np.isin(begun.graph.algebraic.kinds, ("y",))]
            assert amplitude == pytest.approx(expected, rel=0.01 if over > 1.5 else 0.03), (theory, over)
            np.testing.assert_allclose(-begun.heights / amplitude, (1 + np.cos(2 * np.pi * where)) / 2, atol=5e-3)
            assert begun.observed["stretch"] == pytest.approx(1 - critical, abs=0.03 * critical + slack**2)
            assert begun.stiffness > 0
    for share in (0.5, 0.9):  # below Euler's strain the nudge comes back, however soft the column has become
        begun = started(column(share * critical))[1]
        assert np.max(np.abs(begun.heights)) < 1e-6 and begun.stiffness > 0


def test_a_run_with_inertia_begins_at_rest_too() -> None:
    """The thick sheet is let go where it hangs, and stays there."""
    changes = {"run.effects": [*THEORIES["shearing"], "inertia"], "run.duration": "0.02 s", "numerics.estimate": False}
    still = sc.simulate(thick_and_slack("shearing").replace(changes))
    assert still.outcome.is_success, still.summary["message"]
    heights = still.data["midpoint"].values
    assert heights[0] < -0.06
    np.testing.assert_allclose(heights, heights[0], rtol=1e-4)


def test_without_inertia_a_run_begins_in_equilibrium() -> None:
    for law in ["elastic", "bingham"]:
        for ramp in ["0 s", "0.04 s"]:
            run = prepared(without(short_scene(law, ramp=ramp), "inertia"))
            graph = run.graph
            assert run.start is not None
            forces = ca.Function("forces", graph.symbolic.inputs, [graph.symbolic.alg])
            left = np.abs(np.asarray(forces(0.0, graph.start, run.start.z, run.p))).max()
            straight = np.abs(np.asarray(forces(1e9, graph.start, graph.straight, run.p))).max()
            assert left <= 1e-8 * straight
            height = midpoint(run, run.start.z)
            assert height < 0 if ramp == "0 s" else height == pytest.approx(0, abs=1e-12)


def test_a_string_hangs_as_a_cable_or_has_no_shape_to_begin_with() -> None:
    """Before a ramp it carries nothing and resists nothing: its height is anything."""

    def string(law: str, ramp: str) -> Scene:
        return without(short_scene(law, frames=4, ramp=ramp), "inertia", "bending")

    for law in ("elastic", "bingham"):
        solution = prepared(string(law, "0.05 s")).solve(Silence())
        assert solution.outcome is Outcome.no_equilibrium
        assert len(solution.time) == 1 and "t = 0 s" in solution.message
    run = prepared(string("elastic", "0 s"))
    solution = run.solve(Silence())
    assert solution.outcome is Outcome.solved
    wanted = (3 * 1900 * 9.81 * 0.2 / (64 * 4e6)) ** (1 / 3)
    assert -midpoint(run, solution.z)[0] == pytest.approx(wanted, rel=0.03)
