"""What strangers met: every point of their reports, with what happens now, as one table.

`pytest -m slow tests/slow/test_strangers.py` prints the table after the last test.
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.effects.expected_regime import expected_regime
from softcat_sym.plotting.terminal import print_summary
from softcat_sym.studies.card_rules import descent_of
from tests.common.table import rows_of

pytestmark = pytest.mark.slow

Says = Callable[..., None]


@pytest.fixture(scope="module")
def says(request: pytest.FixtureRequest) -> Iterator[Says]:
    """Take a row of the table: the point, what was met, what happens now."""
    rows = list[tuple[str, str, str]]()

    def say(point: str, met: str, now: object) -> None:
        rows.append((point, met, str(now)))

    yield say
    lines = rows_of(("point", "what strangers met", "what happens now"), sorted(rows))
    terminal = request.config.pluginmanager.getplugin("terminalreporter")
    for line in ("", *lines) if terminal is not None else ():
        terminal.write_line(line)


# --- A: checks on random draws


# --- B1: the regime does not depend on the frames

INK = """
[filament]
span = "5 mm"
thickness = "0.4 mm"
section = "circle"
density = "2200 kg/m^3"
[material]
law = "bingham"
youngs_modulus = "300 kPa"
loss_tangent = 0.1
shear_yield_stress = "200 Pa"
shear_viscosity = "10 Pa*s"
[surroundings]
surface_tension = "72 mN/m"
[run]
duration = "0.5 s"
"""
"""The scene of README."""


@pytest.mark.filterwarnings("ignore:it rings at")
def test_one_ink_has_one_regime(says: Says, tmp_path: Path) -> None:
    """README's: run long and short, with few frames, card, sweep and explain."""
    scene = sc.Scene.model_validate(tomllib.loads(INK)).replace({"numerics.estimate": False})
    runs = [sc.simulate(scene.replace(changes)) for changes in ({}, {"run.duration": "0.05 s"}, {"run.frames": 21})]
    whole = runs[0].summary
    descent = descent_of(runs[0])
    swept = sc.sweep(scene, {"material.youngs_modulus": ["300 kPa", "310 kPa"]}, tmp_path).data.isel(member=0)
    foreseen = expected_regime(scene, tuple(whole["effects"]))
    assert descent is not None
    regimes = [run.summary["regime"] for run in runs] + [f"arrested-{descent.damping}", str(swept.regime.values)]
    assert {*regimes, foreseen.name} == {"arrested-underdamped"}
    for run in runs:
        assert run.summary["rebound"] == pytest.approx(whole["rebound"], abs=1e-3)
    assert whole["rebound"] == descent.rise
    assert float(swept.sag_largest.values) == pytest.approx(-whole["midpoint_lowest_m"], rel=1e-3)
    told = [text for text in whole["warnings"] if text.startswith("it rings at")]
    assert whole["frames_a_period"] < 4 and told
    met = "run over, explain under, run of 0.05 s under, card over (4.5 %); 2.3 frames a period, no warning"
    says("B1", met, f"all {regimes[0]}, rebound {100 * whole['rebound']:.2g} %; {told[0].split(':')[0]}: warned")


@pytest.mark.filterwarnings("ignore")
def test_bundled_scenes_have_the_same_regime_with_any_frames(says: Says) -> None:
    """21, 201 and 2001 frames; the rebound, of the sag, to 1 %."""
    same, apart = 0, 0.0
    for name in sc.bundled_names():
        if name == "edge-of-rupture":  # it has no answer
            continue
        changes = {"numerics.estimate": False, "run.until": "duration"}
        found = [sc.simulate(sc.load_scene(name, {**changes, "run.frames": n})).summary for n in (21, 201, 2001)]
        assert len({(one["outcome"], one["regime"]) for one in found}) == 1, name
        apart = max(apart, float(np.ptp([one["rebound"] for one in found])))
        same += 1
    assert apart < 0.01
    says(
        "B1", "regimes by frames", f"{same} bundled scenes, 21 to 2001 frames: same regime, rebound within {apart:.1g}"
    )


# --- B2: a creep is not a swing


def test_a_creep_is_told_by_its_rate_and_by_where_it_tends(says: Says, capsys: pytest.CaptureFixture[str]) -> None:
    """A beam of a standard linear solid: q L^4/(384 E I) at last, from which it is E_2/(E_1 + E_2) exp(-t/tau) away."""
    first, second, viscosity, span, h = 100e3, 450e3, 120e3, 0.02, 1e-3
    scene = sc.Scene.model_validate(
        {
            "filament": {"span": "20 mm", "thickness": "1 mm", "density": "1050 kg/m^3"},
            "material": {
                "law": "standard-linear",
                "youngs_modulus": f"{first} Pa",
                "second_modulus": f"{second} Pa",
                "viscosity": f"{viscosity} Pa*s",
            },
            "load": {"ramp": "0.2 s", "gravity": "1 m/s^2"},
            "run": {
                "duration": "4 s",
                "frames": 41,
                "accuracy": 1e-3,
                "effects": ["inertia", "bending", "viscous-flow", "gravity-ramp"],
            },
        }
    )
    run = sc.simulate(scene)
    last = -1050 * 1.0 * span**4 / (32 * first * h**2)
    tau = viscosity * (first + second) / (first * second)
    left = second / (first + second) * math.exp(-(4 - 0.1) / tau)
    creep, settled = run.summary["creep"], run.summary["midpoint_settled_m"]
    assert run.summary["midpoint_final_m"] == pytest.approx(last * (1 - left), rel=5e-3)
    assert settled["amplitude"] < 2e-3 * abs(last)
    assert creep["rate_m_per_s"] == pytest.approx(last * left / tau, rel=0.05)
    assert creep["tends_to_m"] == pytest.approx(last, rel=5e-3)
    print_summary(run.summary, scene)
    out = " ".join(capsys.readouterr().out.split())
    assert "still moving down by" in out and "towards" in out and "swinging" not in out
    told = out.partition(" sag ")[2].partition(" next digit")[0]
    says("B2", "a creep to 520 µm: 380 µm ± 1.2 %, swinging by 121 µm about it", told)


def test_a_fall_without_end_swings_nowhere(says: Says) -> None:
    """A heavy viscous thread: no turning point, no amplitude, its speed at the end."""
    run = sc.simulate(sc.load_scene("cold-honey", {"numerics.estimate": False}))
    time, midpoint = run.fields["time"], run.fields["midpoint"]
    assert run.summary["extremes"] == [] and run.summary["midpoint_settled_m"]["amplitude"] == 0
    speed = np.gradient(midpoint, time, edge_order=2)[-1]
    assert run.summary["creep"] == {"rate_m_per_s": pytest.approx(speed, rel=0.02), "tends_to_m": None}
    says("B2", "what falls", f"cold-honey: no swing, {speed:.2g} m/s at last")


# --- B3: errors are relative to the largest displacement


# --- B4: natural frequencies of what hangs slack


# --- B5: polymer threads


# --- B6: the time of breaking


# --- B7: what a fit calls identified


# --- B8: what explain says an effect is worth


# --- B9: the error of the slender theory


# --- C1: the price of a run is said before it starts


# --- C2: a run that falls for ever ends


# --- C3: time limits and interrupts


# --- C4: helices and histories are bounded when a scene is read


# --- C5: time limits of fits


# --- D1: clearing the cache leaves the user's files alone


# --- D2: nobody else's code or results are loaded


# --- D3: a full disk is no crash
