"""The few numbers that describe a motion, ringing and settling, of shapes and histories that are known exactly."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from softcat_sym import simulate
from softcat_sym.effects.selection import choose_effects
from softcat_sym.error_control.estimate import Judge
from softcat_sym.estimates.expected_motion import Motion
from softcat_sym.estimates.forecast import compliant_sag, lagging
from softcat_sym.results.fields import displacements
from softcat_sym.results.motion import (
    STRIDE,
    Ringing,
    creep_of,
    frames_a_period,
    observed_motion,
    period_of,
    ringing_of,
    still_to_move,
    too_few_frames,
)
from softcat_sym.results.observed import DISPLACEMENT
from softcat_sym.results.run import Run
from softcat_sym.scene.scene import Scene
from softcat_sym.solvers.solution import Extremes

Array = np.ndarray[Any, Any]

SPAN, CELLS, FRAMES = 2.0, 200, 2001
DENSITY, GRAVITY = 1000.0, 10.0
NODES = np.linspace(-SPAN / 2, SPAN / 2, CELLS + 1)
LIMIT, VISCOSITY = 2000.0, 1e4
ALL = ("inertia", "bending", "finite-stretch", "thinning", "large-rotation", "viscous-flow", "yielding")


def scene_of(*effects: str, thickness: float = 0.02, E: float = 1e7, **tables: dict[str, Any]) -> Scene:
    """A Bingham filament, or one of another law, with named effects."""
    table: dict[str, Any] = {
        "filament": {"span": f"{SPAN} m", "thickness": f"{thickness!r} m", "density": f"{DENSITY} kg/m^3"},
        "material": {
            "law": "bingham",
            "youngs_modulus": f"{E!r} Pa",
            "viscosity": f"{VISCOSITY} Pa*s",
            "yield_stress": f"{LIMIT} Pa",
        },
        "load": {"gravity": f"{GRAVITY} m/s^2"},
        "run": {"duration": "3 s", "frames": FRAMES, "effects": list(effects)},
        "numerics": {"estimate": False},
    }
    for name, values in tables.items():
        table[name] = table.get(name, {}) | values
    return Scene.model_validate(table)


def shapes(depth: Array, drop: float = 0.0) -> dict[str, Array]:
    """Parabolas of these depths [m] below a line that falls by a drop, without any stress."""
    line = -drop * (NODES / SPAN + 0.5)
    y = line - depth[:, None] * (1 - (2 * NODES / SPAN) ** 2)
    x = np.broadcast_to(NODES, y.shape)
    stretch = np.hypot(np.diff(x), np.diff(y)) / np.diff(NODES)
    names = ("shear_force", "stress_mean", "stress_bending", "yielded_fraction")
    energies = dict.fromkeys(("energy_dissipated", "energy_elastic"), np.zeros(len(y)))
    return {"x": x, "y": y, "stretch": stretch} | dict.fromkeys(names, np.zeros_like(stretch)) | energies


def motion_of(scene: Scene, fields: dict[str, Array]) -> Motion:
    time = np.linspace(0.0, scene.run.duration, len(fields["y"]))
    places, moved = (NODES, (NODES[1:] + NODES[:-1]) / 2), displacements(scene, time, fields, NODES)
    seen = Extremes.of(time, fields["y"][:, CELLS // 2])
    return observed_motion(scene, choose_effects(scene), time, places, fields, moved, seen)


def motion_of_run(run: Run) -> Motion:
    places = (run.fields["X_node"], run.fields["X_cell"])
    time = run.fields["time"]
    moved, seen = displacements(run.scene, time, run.fields, places[0]), Extremes.of(time, run.fields["midpoint"])
    return observed_motion(run.scene, choose_effects(run.scene), time, places, run.fields, moved, seen)


def test_swings_are_the_phase_times_the_share_of_the_sag() -> None:
    """About 0.7 of the largest sag it swings by 0.3 of it; of A exp(-t/tau) cos(omega t) the phase omega tau counts."""
    for periods in (1, 3.5, 12):
        phase = 2 * np.pi * periods * np.linspace(0, 1, FRAMES)
        found = motion_of(scene_of(*ALL), shapes(0.1 * (0.7 - 0.3 * np.cos(phase))))
        exact = 0.3 * 2 * np.pi * periods
        # The way that it has gone for good is no swing: half a period more ends at the other side.
        assert found.swings == pytest.approx(exact - (0.3 * np.pi if periods % 1 else 0), rel=1e-3)
    assert motion_of(scene_of(*ALL), shapes(np.linspace(0, 0.3, FRAMES) ** 2)).swings == pytest.approx(0, abs=1e-12)
    assert motion_of(scene_of(*ALL), shapes(np.zeros(3))).swings == 0
    time = np.linspace(0, 8, FRAMES)
    found = motion_of(scene_of(*ALL), shapes(0.1 * (1 - np.exp(-time) * np.cos(40 * time))))
    # Travelled, less what it has come down by for good.
    assert found.swings == pytest.approx((40 - np.pi / 2) / (1 + math.exp(-np.pi / 40)), rel=0.02)


def test_sag_slope_and_strain_of_a_parabola() -> None:
    """Slope 4 H/L at the ends; arc length of y = -H (1 - u^2) in closed form; the largest frame counts."""
    for depth in (1e-3, 0.1, 0.6):
        found = motion_of(scene_of(*ALL), shapes(np.append(np.linspace(0, depth, 5), depth / 4)))
        steep = 4 * depth / SPAN
        arc = math.sqrt(1 + steep**2) / 2 + math.asinh(steep) / (2 * steep)
        assert (found.sag, found.scale) == pytest.approx((depth / SPAN, depth / SPAN))
        assert found.slope == pytest.approx(math.atan(steep), rel=0.01)
        assert found.strain == pytest.approx(arc - 1, rel=1e-3)
    # From the line between the supports.
    found = motion_of(scene_of(*ALL, ends={"drop": "0.4 m"}), shapes(np.linspace(0, 0.1, 5), drop=0.4))
    assert (found.sag, found.scale) == pytest.approx((0.1 / SPAN, 0.1 / SPAN))
    assert found.slope == pytest.approx(math.atan(0.4 / SPAN + 4 * 0.1 / SPAN), rel=0.01)
    still = motion_of(scene_of(*ALL), shapes(np.zeros(5)))
    assert 0 < still.sag < 1e-9 and still.strain == 0
    assert all(math.isfinite(value) for value in (still.sheared, still.tension_share, still.missed))


def test_folds_of_a_uniform_flow() -> None:
    """Sigma/eta for as long as the whole section flows; without a yield stress a neck grows with the strain."""
    fields = shapes(np.zeros(301))
    flowing = fields["stretch"] * 0
    flowing[100:201] = 1.0  # a second
    fields |= {"stress_mean": np.full_like(flowing, 3 * LIMIT), "yielded_fraction": flowing}
    assert motion_of(scene_of(*ALL), fields).folds == pytest.approx(3 * LIMIT / VISCOSITY * 1.0, rel=0.02)
    pushed = motion_of(scene_of(*ALL), fields | {"stress_mean": np.full_like(flowing, -3 * LIMIT)})
    assert pushed.folds == 0
    scene = scene_of(*(name for name in ALL if name != "yielding"), material={"law": "maxwell", "yield_stress": None})
    found = motion_of(scene, shapes(np.linspace(0, 0.4, 5)))
    assert found.folds == found.strain > 0.05
    assert math.isinf(found.overstress)


def test_overstress_is_that_of_the_outermost_fibre() -> None:
    for mean, bent in ((0.5, 0.25), (-0.5, 0.25), (0.5, -0.25)):
        fields = shapes(np.zeros(4))
        stress, bending = fields["stress_mean"].copy(), np.zeros_like(fields["stress_mean"])
        stress[2, 7], bending[2, 7] = mean * LIMIT, bent * LIMIT
        found = motion_of(scene_of(*ALL), fields | {"stress_mean": stress, "stress_bending": bending})
        assert found.overstress == pytest.approx(0.75)
    # Below first yield, between clamps, rho g L^2/(2 h0): w L^2/12 over w h0^2/6.
    thickness, strength = 0.1, 1e6
    scene = scene_of("bending", thickness=thickness, E=1e10, run={"frames": 2}, numerics={"cells": 40}).replace(
        {"material.yield_stress": f"{strength!r} Pa"}
    )
    found = motion_of_run(simulate(scene))
    assert found.overstress == pytest.approx(DENSITY * GRAVITY * SPAN**2 / (2 * thickness) / strength, rel=0.03)
    assert found.relaxed == 0


def test_what_relaxes_is_what_flowed_or_without_flow_all_above_the_yield_stress() -> None:
    fields = shapes(np.zeros(4))
    fields["stress_mean"] = np.full_like(fields["stress_mean"], 4 * LIMIT)
    assert motion_of(scene_of("bending"), fields).relaxed == pytest.approx(3 / 4)
    scene, fields = scene_of(*ALL, material={"yield_stress": "1 GPa"}), shapes(np.zeros(4))
    assert motion_of(scene, fields).relaxed == 0
    fields["energy_elastic"] = np.array([0.0, 1.0, 0.5, 0.5])
    fields["energy_dissipated"] = np.array([0.0, 1.0, 2.0, 3.0])
    assert motion_of(scene, fields).relaxed == pytest.approx(3 / 4)


def test_compliance_is_timoshenkos() -> None:
    """The sag by shear alone, q L^2/(8 kappa mu A), of the transverse force of a run without shear."""
    poisson, E = 0.3, 1e9
    corrections = {
        "rectangle": 10 * (1 + poisson) / (12 + 11 * poisson),
        "circle": 6 * (1 + poisson) / (7 + 6 * poisson),
    }
    for end in ("clamped", "pinned"):
        for section, correction in corrections.items():
            scene = scene_of(
                "bending",
                thickness=0.2,
                filament={"section": section},
                material={"poisson": poisson, "yield_stress": "1 GPa"},
                E=E,
                ends={"left": end, "right": end},
                run={"frames": 2},
                numerics={"cells": 40},
            )
            run = simulate(scene)
            added = compliant_sag(scene, run.fields["shear_force"], np.diff(run.fields["X_node"])) * SPAN
            found = motion_of_run(run)
            exact = DENSITY * GRAVITY * SPAN**2 / (8 * correction * E / (2 * (1 + poisson)))
            assert added == pytest.approx(exact, rel=0.03), (end, section)
            assert found.sheared * found.sag * SPAN == pytest.approx(exact, rel=0.07), (end, section)
    # A Kelvin-Voigt solid follows a force that sets in and stays as 1 - exp(-t/lag).
    time, lag = np.linspace(0, 3, 31), 0.7
    force = np.tile([2.0, -1.0], (31, 1))
    np.testing.assert_allclose(lagging(time, force, lag), force * (1 - np.exp(-time / lag))[:, None], atol=1e-14)
    assert lagging(time, force, 0.0) is force


@pytest.mark.slow
def test_a_mass_on_a_viscoelastic_string_shears_it() -> None:
    """Beside the mass, where the string bends, its transverse force shears it; the check sees what shear makes."""
    scene = Scene.model_validate(
        {
            "filament": {"span": "0.2 m", "thickness": "4 mm", "density": "1000 kg/m^3"},
            "material": {"law": "kelvin-voigt", "youngs_modulus": "28 kPa", "viscosity": "29 kPa*s"},
            "ends": {"left": "pinned", "right": "pinned"},
            "load": {"ramp": "0.75 s", "point_mass": "1.5 g"},
            "run": {"duration": "12 s", "accuracy": 1e-3},
        }
    )
    chosen = simulate(scene)
    assert [text.split(":")[0] for text in chosen.summary["repeats"]] == ["shear"]
    less = simulate(scene.replace({"run.effects": [name for name in chosen.summary["effects"] if name != "shear"]}))
    made = abs(less.data.midpoint.values[-1] / chosen.data.midpoint.values[-1] - 1)
    assert 1 < motion_of_run(less).sheared / made < 4


def test_a_run_without_inertia_misses_its_free_fall_and_shows_its_share_within_the_ramp() -> None:
    """A viscous descent H = c t: late by what it falls while it catches up, c^2/g."""
    speed, duration = 0.05, 3.0
    names = [name for name in ALL if name != "inertia"]
    found = motion_of(scene_of(*names), shapes(speed * np.linspace(0, duration, 301)))
    assert 1 < found.missed / (speed / GRAVITY / duration) < 3
    # A coil that draws out along a level axis, at twice a quarter of gravity: its midpoint stays at its height.
    time = np.linspace(0, 0.2, 101)
    still, away = shapes(np.zeros(101)), (GRAVITY / 4 * time**2)[:, None] * (NODES / SPAN + 0.5)
    level = still | {"x": still["x"] + away, "z": np.zeros_like(away)}
    coil = scene_of(*names, load={"ramp": "0.2 s"}, run={"duration": "0.2 s"})
    assert motion_of(coil, level).missed == pytest.approx(0.5, rel=0.05)
    assert motion_of(coil, still).missed == 0
    for reached in (0.25, 0.75):
        depth = np.interp(np.linspace(0, 3, 301), [0, 1.5, 3], [0, reached * 0.1, 0.1])
        assert motion_of(scene_of(*names, load={"ramp": "1.5 s"}), shapes(depth)).risen == pytest.approx(reached)


def path(height: Callable[[Array], Array], duration: float = 2.0, samples: int = 20001) -> Extremes:
    """The extremes of a history that is known everywhere."""
    time = np.linspace(0, duration, samples)
    return Extremes.of(time, height(time)).beyond(0.0)


def swing(frequency: float, amplitude: float = 0.5, decay: float = 0.0) -> Callable[[Array], Array]:
    return lambda time: -1 + amplitude * np.exp(-decay * time) * np.cos(2 * math.pi * frequency * time)


def ringing(extremes: Extremes) -> Ringing:
    found = ringing_of(extremes)
    assert found is not None
    return found


def test_extremes_are_the_turning_points_between_both_ends() -> None:
    found = path(swing(2.0))
    np.testing.assert_allclose(found.time, np.arange(0, 2.01, 0.25), atol=2e-4)
    np.testing.assert_allclose(found.height, -1 + 0.5 * (-1.0) ** np.arange(9), atol=1e-6)
    np.testing.assert_allclose(found.area, -found.time, atol=1e-4)
    # A ripple of a hundredth is none where swings count from two hundredths on, whichever way it all goes meanwhile.
    assert len(path(lambda t: swing(2.0)(t) + 0.01 * np.cos(300 * t)).beyond(0.021).time) == 9
    assert len(path(lambda t: -t + 0.01 * np.cos(300 * t)).beyond(0.021).time) == 2


def test_frames_too_far_apart_for_the_period_of_the_swing_are_told() -> None:
    """53.75 Hz in a hundred frames a second are seen as 46.25 Hz, in fifty as 3.75 Hz."""
    found = path(swing(53.75))
    per_period = frames_a_period(found, 101)
    assert per_period == pytest.approx(50 / 53.75, rel=1e-3)
    (warning,) = too_few_frames(2.0, 101, per_period)
    assert "rings at about 53.7 Hz" in warning or "rings at about 53.8 Hz" in warning
    enough = int(warning.rpartition("run.frames = ")[2].split()[0])
    assert (frames_a_period(found, enough) or 0) > 4 and too_few_frames(
        2.0, enough, frames_a_period(found, enough)
    ) == []
    # A swing of 0.4 % is not seen, a drift is no swing.
    for height in (swing(5.0, 0.004), lambda t: -1 + np.exp(-t), lambda t: -0.5 * t):
        assert frames_a_period(path(height), 11) is None
    assert too_few_frames(2.0, 101, None) == []


ACCURACY = 0.01


def strand(*, backend: str = "compiled", run: dict[str, Any] | None = None, **material: Any) -> Scene:
    return Scene.model_validate(
        {
            "filament": {"span": "20 mm", "diameter": "1 mm", "density": "1050 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "450 kPa", "loss_tangent": 0.1, **material},
            "run": {"duration": "3 s", "frames": 41, "accuracy": ACCURACY, "until": "settled", **(run or {})},
            "numerics": {"estimate": False, "cells": 16, "backend": backend},
        }
    )


@pytest.mark.slow
def test_a_damped_strand_ends_early_at_its_static_sag() -> None:
    rests = float(simulate(strand(run={"until": "duration"})).data.midpoint[-1])
    for backend in ("interpreted", "compiled"):
        run = simulate(strand(backend=backend))
        settled = run.summary["settled_s"]
        assert settled is not None and settled < 1
        assert run.summary["time_final_s"] == pytest.approx(settled)
        times = run.fields["time"]
        np.testing.assert_allclose(np.diff(times), times[-1] / 40)
        largest = float(np.max(np.abs(run.fields["midpoint"])))
        assert abs(float(run.fields["midpoint"][-1]) - rests) < ACCURACY * largest
        assert run.summary["midpoint_settled_m"]["mean"] == pytest.approx(rests, abs=1e-3 * largest)
        assert run.summary["midpoint_settled_m"]["amplitude"] < ACCURACY * largest
        # What was asked stays, and it is a scene.
        assert run.scene.run.until == "settled" and 'until = "settled"' in run.scene.to_toml()
    estimated = simulate(strand().replace({"numerics.estimate": True, "numerics.cells": None}))
    assert estimated.outcome.is_success
    assert estimated.summary["error_estimate"]["total"] < ACCURACY
    assert estimated.summary["time_final_s"] == pytest.approx(estimated.summary["settled_s"])


@pytest.mark.slow
def test_an_undamped_strand_runs_on_and_tells_its_mean_and_amplitude() -> None:
    dense, sparse = (
        simulate(strand(loss_tangent=0.0, run={"duration": "0.8 s", "frames": frames})).summary
        for frames in (1601, 77)
    )  # fmt: skip
    for summary in (dense, sparse):
        assert summary["settled_s"] is None
        assert summary["time_final_s"] == pytest.approx(0.8)
    # 77 frames over 38 periods would show an amplitude and a mean of their own.
    full, thin = dense["midpoint_settled_m"], sparse["midpoint_settled_m"]
    assert thin["mean"] == pytest.approx(full["mean"], rel=0.01)
    assert thin["amplitude"] == pytest.approx(full["amplitude"], rel=0.02)
    rests = float(simulate(strand()).summary["midpoint_settled_m"]["mean"])
    assert full["mean"] == pytest.approx(rests, rel=0.1)
    assert full["amplitude"] == pytest.approx(abs(rests), rel=0.2)


@pytest.mark.slow
def test_a_creeping_strand_does_not_end_early_and_one_that_hardly_creeps_does() -> None:
    """In 20 s it flows by three times its elastic sag, but hardly at all in the time in which its ringing ends."""
    for backend in ("interpreted", "compiled"):
        run = simulate(strand(backend=backend, law="maxwell", viscosity="4500 kPa*s", run={"duration": "20 s"}))
        assert run.summary["settled_s"] is None
        assert run.summary["time_final_s"] == pytest.approx(20)
    scene = strand(law="maxwell", viscosity="4500 MPa*s", run={"duration": "5 s"})
    geometry = ["bending", "extensibility", "finite-stretch", "thinning", "large-rotation"]
    run = simulate(scene.replace({"run.effects": ["inertia", *geometry, "solid-damping", "viscous-flow"]}))
    assert run.summary["settled_s"] is not None and run.summary["settled_s"] < 1
    # Without inertia it has settled when the load is there.
    scene = strand(run={"effects": [*geometry, "gravity-ramp"]})
    run = simulate(scene.replace({"load.ramp": "0.5 s", "numerics.backend": None}))
    assert run.summary["settled_s"] == pytest.approx(0.5)
    assert run.summary["midpoint_settled_m"] == {"mean": run.summary["midpoint_final_m"], "amplitude": 0.0}
    brief = simulate(strand(run={"duration": "5 ms", "until": "duration"})).summary
    assert brief["midpoint_settled_m"] is None
    assert "shorter than one period" in brief["midpoint_settled_why"]


def test_the_mean_is_that_of_whole_periods_and_what_does_not_turn_back_does_not_swing() -> None:
    for cycles in (5.0, 4.3, 17.71):
        for phase in (0.0, 1.0, 2.5):
            height = lambda t, w=math.pi * cycles, p=phase: -2.0 + 0.7 * np.cos(w * t + p) - 0.01 * t  # noqa: E731
            found = ringing(path(height, samples=80001))
            assert found.mean == pytest.approx(-2.0, abs=0.025)
            assert found.amplitude == pytest.approx(0.7, rel=0.01)
            assert found.period == pytest.approx(2 / cycles, rel=0.01)
            assert found.drift == pytest.approx(-0.01, rel=0.05)
    for height in (lambda t: -t, lambda t: np.exp(-t), lambda t: -1 + np.exp(-9 * t) * np.cos(9 * t), lambda t: 0 * t):
        assert ringing_of(path(height).beyond(1e-4)) is None
    # It has swung, and swings no more.
    assert ringing_of(path(swing(9.0, decay=9.0)).beyond(0.01)) is None


def creep(move: Callable[[Array], Array], law: str = "standard-linear", duration: float = 8.0) -> Any:
    second = {"second_modulus": "1 MPa"} if law == "standard-linear" else {}
    material = {"law": law, "youngs_modulus": "1 MPa", "viscosity": "1 MPa*s", "loss_tangent": 0.0, **second}
    scene = strand(run={"duration": f"{duration} s", "until": "duration"}, **material)
    time, seen = np.linspace(0, duration, 41), path(move, duration)
    return creep_of(scene, seen, time, move(time))


def test_a_creep_has_a_rate_and_a_solid_a_height_to_which_it_tends() -> None:
    found = creep(lambda t: -1 + np.exp(-t / 5))
    assert found["rate_m_per_s"] == pytest.approx(-math.exp(-8 / 5) / 5, rel=3e-3)
    assert found["tends_to_m"] == pytest.approx(-1, rel=1e-6)
    # What goes on for ever, or may, tends nowhere that could be told.
    for move in (lambda t: -np.log(1 + t), lambda t: -np.cbrt(t), lambda t: -t, lambda t: -(t**2)):
        assert creep(move)["tends_to_m"] is None
    assert creep(lambda t: -1 + np.exp(-t / 5), "maxwell")["tends_to_m"] is None
    assert creep(lambda t: -1 + np.exp(-t)) is None, "it has come to rest by the accuracy asked"
    assert creep(lambda t: -1 - 0.2 * np.cos(9 * t)) is None, "it swings"
    # Beside a ripple the rate is that of the mean.
    slow = creep(lambda t: -0.1 * t + 0.004 * np.cos(60 * t))
    assert slow["rate_m_per_s"] == pytest.approx(-0.1, rel=0.01)


CREEP: dict[str, Callable[[float], float]] = {
    "logarithm": lambda t: 0.01 * math.log(t),
    "cube root": lambda t: 0.02 * t ** (1 / 3),
    "exponential": lambda t: 1 - math.exp(-t / 2),
    "late stop": lambda t: 1 - 1 / t,
    "constant rate": lambda t: 1e-3 * t,
}


def test_what_is_foreseen_is_no_less_than_what_comes() -> None:
    for name, move in CREEP.items():
        for end in (30.0, 1e3, 1e5):
            longest = 0
            for n in range(60):
                t = 1.5 * STRIDE**n
                if t > end:
                    break
                means = [move(t / STRIDE**2), move(t / STRIDE), move(t)]
                expected = still_to_move(means, end / t, 1e-6, flows=True)
                assert expected >= 0.98 * abs(move(end) - move(t)), (name, end, t)
                longest = n if expected > 0.01 else longest
            if name == "exponential":
                # It is not called moving for much longer than it moves, 2 log(100) = 9.2, or than noise could hide.
                assert 1.5 * STRIDE**longest < max(20, 6e-4 * end)
    # What cannot flow is not expected to go on.
    assert still_to_move([1.0, 1.0, 1.0], 1e6, 1e-3, flows=False) == 1e-3
    assert still_to_move([1.0, 1.0, 1.0], 1e6, 1e-3, flows=True) > 1e2


def test_of_a_long_ringing_the_phase_that_rotary_inertia_shifts_is_not_told() -> None:
    """It slows the swing by half a per cent: a quarter of the swing after forty periods, hardly any of its height."""
    effects = ["inertia", "bending", "extensibility", "finite-stretch", "thinning", "large-rotation", "shear"]
    scene = Scene.model_validate(
        {
            "filament": {"span": "3 mm", "thickness": "0.25 mm", "section": "circle", "density": "1100 kg/m^3"},
            "material": {"law": "elastic", "youngs_modulus": "30 kPa"},
            "run": {"duration": "0.3 s", "frames": 2001, "effects": effects},
            "numerics": {"estimate": False, "cells": 20},
        }
    )
    without, turning = (simulate(s) for s in (scene, scene.replace({"run.effects": [*effects, "rotary-inertia"]})))
    first, second = without.series, turning.series
    judge = Judge.of(first, without.watched, scene.run.duration / period_of(scene), scene.run.accuracy)
    apart = first[DISPLACEMENT] - second[DISPLACEMENT]
    assert float(np.max(np.abs(apart))) > 0.2 * float(np.max(np.abs(first[DISPLACEMENT])))
    assert judge.windows
    assert judge.between(first, second).size < without.summary["checked"]["rotary-inertia"] < 1e-3
    brief = simulate(scene.replace({"run.duration": "0.06 s"}))
    assert brief.summary["checked"]["rotary-inertia"] > scene.run.accuracy
