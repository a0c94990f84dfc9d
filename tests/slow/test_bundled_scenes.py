"""Bundled scenes that are not run every time; the energy balance and the time error of all."""

from __future__ import annotations

import math
import tomllib
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.estimates.forecast import expected_sag
from softcat_sym.results.motion import period_of
from softcat_sym.scene.bundled import bundled_lesson
from tests.common import curves
from tests.common.table import show
from tests.test_bundled_scenes import Checked, at_cells, drawn_blob, final, judge, polyethylene_melt, run
from tests.test_films import check_lesson

pytestmark = pytest.mark.slow
RUPTURES = "edge-of-rupture"
TIMED = ("agar-bar", "arrested-underdamped", "bread-dough", "coil-spring", "drawn-blob", "glass-fibre", "glass-rod")
TIMED += ("ink-bridge", "polymer-thread", "shaken-strand", "slack-taffy", "transient-gel")
"""One for each kind of law, end, start and load."""
TRIED = np.linspace(0.7, 1.3, 601)
"""Frequencies of a string, over the one expected."""
WITHOUT_INERTIA = ["bending", "finite-stretch", "thinning", "large-rotation", "shear"]


def hardly_bent(done: sc.Run) -> tuple[np.ndarray[Any, Any], np.ndarray[Any, Any]]:
    """Mean stress and plastic rate, at the end, of the cells that hardly bend."""
    mean, bending, rate = (at_cells(done, name) for name in ("stress_mean", "stress_bending", "plastic_rate"))
    straight = np.abs(bending) < 0.1 * mean
    return mean[straight], rate[straight]


def drying_ink(done: sc.Run) -> Checked:
    """Tension -E P at the start; without the initial state nothing yields."""
    part, material = done.scene.filament, done.scene.material
    pull = 0.003 * material.youngs_modulus * math.pi * part.thickness**2 / 4
    idle = run("drying-ink", "initial.P=[0.0]", "initial.C=[0.0]")
    return [
        ("tension at the start [N]", float(at_cells(done, "tension", 0).mean()), pull, 1e-6),
        ("has yielded", float(done.data.yielded_fraction.values.max() > 0.1), 1, 0),
        ("yields without P and C", float(idle.data.yielded_fraction.values.max()), 0, 0),
    ]


def oobleck(done: sc.Run) -> Checked:
    """Where it hardly bends, stress is K rate^1.5; it sags less than the fluid of index one."""
    mean, rate = hardly_bent(done)
    of_rate = (mean / done.scene.material.viscosity) ** (1 / 1.5)
    newtonian = run("oobleck", "material.index=1", "material.shear_consistency=60 Pa*s")
    return [
        ("rate over (stress/K)^(2/3)", float((rate / of_rate).mean()), 1, 0.05),
        ("sags less than with n = 1", float(final(done) > 0.8 * final(newtonian)), 1, 0),
    ]


def thermoforming_sheet(done: sc.Run) -> Checked:
    """It keeps its width: 4/3 more viscous than the strip, so (3/4)^(1/3) of its sag."""
    strip = run("thermoforming-sheet", "filament.section=rectangle")
    late = [one.data.midpoint.values[-60:].mean() for one in (done, strip)]
    return [("sag over that of a strip", float(late[0] / late[1]), 0.75 ** (1 / 3), 0.015)]


def toothpaste(done: sc.Run) -> Checked:
    """Yields, then stops; a paste of ten times the strength does not yield."""
    midpoint = done.data.midpoint.values
    strong = run("toothpaste", "material.shear_yield_stress=2 kPa")
    return [
        ("last quarter's sag over the one before", float(midpoint[-50:].mean() / midpoint[-100:-50].mean()), 1, 0.02),
        ("has yielded", float(done.data.yielded_fraction.values.max() > 0.02), 1, 0),
        ("a strong paste yields", float(strong.data.yielded_fraction.values.max()), 0, 0),
    ]


def transient_gel(done: sc.Run) -> Checked:
    """Where it hardly bends the rate is sinh(sigma/s0)/t0; the fluid of its viscosity at rest, s0 t0, flows less."""
    mean, rate = hardly_bent(done)
    eyring = np.sinh(mean / 500) / 60
    linear = run("transient-gel", "material.flow=sigma/s0/t0")
    return [
        ("rate over Eyring's", float((rate / eyring).mean()), 1, 0.1),
        ("flows more than linearly", float(final(done) < 1.1 * final(linear)), 1, 0),
    ]


def bread_dough(done: sc.Run) -> Checked:
    """Index 0.3: a fifth more weight on the same shape makes it flow 1.2^(1/0.3) = 1.84 times as fast."""

    def speed(one: sc.Run) -> float:
        midpoint = one.data.midpoint.values
        return float(midpoint[100] - midpoint[180:].mean())

    heavier = run("bread-dough", "load.gravity=11.77 m/s^2")
    return [("speed with 1.2 g, over that with g", speed(heavier) / speed(done), 1.2 ** (1 / 0.3), 0.3)]


def cooked_spaghetti(done: sc.Run) -> Checked:
    """Peirce's heavy elastica, which does not shear: 1 % is left to that and to the last of the swinging."""
    part, E = done.scene.filament, done.scene.material.youngs_modulus
    area = math.pi * part.thickness**2 / 4
    section = curves.uniform(E * area, E * area * part.thickness**2 / 16)
    weight = part.density * done.scene.load.gravity * area
    X = np.linspace(0, part.span, 41)
    shape = curves.held(section, weight, part.span, part.span, X, ("clamped", 0.0), ("free", 0.0))
    y = at_cells(done, "y")
    return [("tip [m]", float(y[-1]), float(shape.y[-1]), 0.01), ("lowest node", float(y.argmin()), 40, 0)]


def gelatin_strand(done: sc.Run) -> Checked:
    """It comes to rest as the elastic beam."""
    table = tomllib.loads(done.scene.to_toml())
    table["material"] = {"law": "elastic", "youngs_modulus": table["material"]["youngs_modulus"]}
    table["run"] |= {"effects": WITHOUT_INERTIA, "frames": 2}
    rest = sc.simulate(sc.Scene.model_validate(table))
    return [("sag at the end [m]", -final(done), -final(rest), 2e-3)]


def hot_glue_string(done: sc.Run) -> Checked:
    """It starts as its profile, 1 to 0.6; all of it carries the same pull, which stretches the thin half more."""
    thickness, stretch = at_cells(done, "thickness", 0), at_cells(done, "stretch")
    thin, thick = np.log(stretch[20:]).mean(), np.log(stretch[:20]).mean()
    return [
        ("thin over thick end", float(thickness[-1] / thickness[0]), 0.605 / 0.995, 2e-2),
        ("thin half strains more", float(thin > 1.1 * thick), 1, 0),
    ]


def putty_arch(done: sc.Run) -> Checked:
    """It leaves the grips at 15 degrees, stands above the line at first and hangs below it in the end."""
    x, y = at_cells(done, "x", 0), at_cells(done, "y", 0)
    midpoint = done.data.midpoint.values
    # of the parabola through the first three nodes
    first = np.polyfit(x[:3] - x[0], y[:3] - y[0], 2)[1]
    return [
        ("slope at the left grip", float(first), math.tan(math.radians(15)), 0.04),
        ("above, then below", float(midpoint[0] > 1e-3 and midpoint[-1] < -1e-3), 1, 0),
    ]


def rubber_strand(done: sc.Run) -> Checked:
    """The elastic cable of its long-time modulus."""
    part, E = done.scene.filament, done.scene.material.youngs_modulus
    cable = (3 * part.density * done.scene.load.gravity * part.span**4 / (64 * E)) ** (1 / 3)
    return [("sag at the end [m]", -float(done.data.midpoint.values[-20:].mean()), cable, 0.03)]


def slack_taffy(done: sc.Run) -> Checked:
    """It starts as the elastic catenary of its rest length, but for its stiff ends, and grows."""
    length, part = 0.3, done.scene.filament
    stress = part.density * done.scene.load.gravity
    X = np.linspace(0, length, 41)
    stretch = curves.true_strain_stretch(done.scene.material.youngs_modulus / stress)
    chain = curves.hanging_string(stretch, 1.0, length, part.span, X)
    drawn = [float(np.hypot(np.diff(at_cells(done, "x", k)), np.diff(at_cells(done, "y", k))).sum()) for k in (0, -1)]
    exact = float(np.hypot(np.diff(chain.x), np.diff(chain.y)).sum())
    return [
        ("length at the start [m]", drawn[0], exact, 2e-3),
        ("sag at the start [m]", -float(done.data.midpoint.values[0]), -float(chain.y[20]), 0.04),
        ("grows longer", float(drawn[1] > 1.05 * drawn[0]), 1, 0),
    ]


def slime_slope(done: sc.Run) -> Checked:
    """Supports at their heights, the deepest point on the side of the lower one."""
    x, y = at_cells(done, "x"), at_cells(done, "y")
    return [
        ("drop [m]", float(y[0] - y[-1]), 0.030, 1e-9),
        ("deepest right of midspan", float(x[y.argmin()] > x.mean() + 0.1 * 0.080), 1, 0),
    ]


def stretched_rubber_band(done: sc.Run) -> Checked:
    """A string of tension E log(1.25): 2 L/c between two visits to the top."""
    part, E = done.scene.filament, done.scene.material.youngs_modulus
    period = 2 * part.span / math.sqrt(E * math.log(1.25) / part.density)
    time, height = done.data.time.values, done.data.midpoint.values
    spectrum = [abs(np.sum((height - height.mean()) * np.exp(-2j * np.pi * time * k / period))) for k in TRIED]
    return [("frequency over c/(2 L)", float(TRIED[int(np.argmax(spectrum))]), 1, 0.03)]


def test_scenes_show_their_physics() -> None:
    judge(
        drawn_blob,
        polyethylene_melt,
        drying_ink,
        oobleck,
        thermoforming_sheet,
        toothpaste,
        transient_gel,
        bread_dough,
        cooked_spaghetti,
    )
    judge(gelatin_strand, hot_glue_string, putty_arch, rubber_strand, slack_taffy, slime_slope, stretched_rubber_band)


@pytest.mark.parametrize("name", sc.bundled_names())
def test_a_scene_shows_its_lesson_keeps_its_energy_and_is_saved_as_it_was_read(name: str, tmp_path: Path) -> None:
    scene = sc.load_scene(name, {"numerics.estimate": False})
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        done = sc.simulate(scene)
    done.save(tmp_path / name)
    assert done.outcome is (sc.Outcome.localised if name == RUPTURES else sc.Outcome.solved)
    assert done.summary["energy_residual"] < scene.run.accuracy
    check_lesson(bundled_lesson(name), done)
    assert sc.open_run(tmp_path / name).scene == sc.load_scene(tmp_path / name / "scene.toml") == scene


@pytest.mark.parametrize("name", TIMED)
def test_time_error_is_a_tenth_of_the_accuracy(name: str) -> None:
    """Against CasADi's Rosenbrock method on the interpreted graph, with a tolerance far below the default's.

    Scenes run compiled by themselves: neither the integrator nor the evaluation of the right-hand side is shared. Few
    cells, the same for both: what the time steps lose does not need more.
    """
    cells = 16 if name == "coil-spring" else 6  # A cell may not turn far
    scene = sc.load_scene(name, {"numerics.estimate": False, "numerics.cells": cells})
    tight = {"backend": "interpreted", "solver": "rosenbrock", "rtol": 1e-7 if name == "glass-rod" else 1e-6}
    run, fine = (sc.simulate(scene.replace({f"numerics.{key}": tight[key] for key in keys})) for keys in ((), tight))
    assert (run.summary["backend"], fine.summary["backend"]) == ("compiled", "interpreted")
    assert run.outcome is fine.outcome is sc.Outcome.solved
    assert list(run.summary["effects"]) == list(fine.summary["effects"])
    found, exact = ({axis: one.data[axis].values for axis in ("midpoint", "x", "y")} for one in (run, fine))
    gone = max(np.abs(exact[axis] - exact[axis][0]).max() for axis in ("x", "y"))
    errors = {axis: float(np.abs(found[axis] - exact[axis]).max() / gone) for axis in exact}
    show(name, ("solver", "steps", *errors), [[run.summary["solver"], run.summary["steps"], *errors.values()]])
    assert errors["midpoint"] * gone < 0.1 * scene.run.accuracy * np.abs(exact["midpoint"]).max()
    assert max(errors.values()) < scene.run.accuracy


def test_steps_keep_a_ringing_of_hundreds_of_periods() -> None:
    """Within a tenth of the accuracy of a run in much shorter steps; four steps a period would lose most of it.

    Chocolate: it yields a little at first, at its clamps only, and then rings by less than a tenth of its sag, which is
    foreseen: absolute tolerances are measured by it.
    """
    strand = sc.Scene(
        filament={"span": "7.3 mm", "thickness": "1.1 mm", "section": "circle", "density": "1200 kg/m^3"},
        material={
            "law": "bingham",
            "youngs_modulus": "940 kPa",
            "shear_yield_stress": "120 Pa",
            "shear_viscosity": "4.9 Pa*s",
        },
        surroundings={"surface_tension": "0.04 N/m"},
        run={"duration": "0.8 s", "frames": 2001},
        numerics={"cells": 10, "fibres": 8, "estimate": False},
    )
    found, exact = (sc.simulate(scene).summary for scene in (strand, strand.replace({"numerics.rtol": 2e-5})))
    largest, accuracy = exact["midpoint_largest_m"], strand.run.accuracy
    assert 0.2 < expected_sag(strand) * strand.filament.span / largest < 2
    assert strand.run.duration > 100 * period_of(strand)
    assert exact["midpoint_settled_m"]["amplitude"] > 3 * accuracy * largest
    for name, value in exact["midpoint_settled_m"].items():
        assert found["midpoint_settled_m"][name] == pytest.approx(value, abs=0.1 * accuracy * largest), name
