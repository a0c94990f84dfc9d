"""Effects from outside the package: the example of CONTRIBUTING.md, and drag, against closed forms."""

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import softcat_sym as sc
from softcat_sym.effects.registry import REGISTRY
from softcat_sym.physics import symbols as sy
from tests.common.draws import draws, errors_away

ROOT = Path(__file__).parents[1]
SCENE = {
    "filament": {"span": "0.2 m", "thickness": "2 mm", "density": "1000 kg/m^3"},
    "material": {"law": "elastic", "youngs_modulus": "10 MPa"},
    "effects": {"elastic-foundation": {"stiffness": "300 Pa"}},
    "run": {"duration": "1 s", "frames": 11, "accuracy": 1e-4},
}
DAMPED = {"law": "kelvin-voigt", "youngs_modulus": "1 MPa", "viscosity": "20 kPa*s"}


@pytest.fixture(autouse=True)
def foundation():
    """Run the example's text; the registry is left as it was."""
    before = list(REGISTRY)
    (text,) = re.findall(r"```python\n(.*?)```", (ROOT / "CONTRIBUTING.md").read_text(), re.DOTALL)
    assert text.count("\n") < 40
    exec(compile(text, "CONTRIBUTING.md", "exec"), {})
    yield
    REGISTRY[:] = before


def hetenyi(scene, k):
    """Depth at midspan of a clamped beam on springs under its weight (Hetenyi 1946), by the boundary value problem."""
    filament = scene.filament
    stiffness = scene.material.youngs_modulus * filament.thickness**4 / 12
    weight = filament.density * filament.thickness**2 * scene.load.gravity
    a = (k / (4 * stiffness)) ** 0.25
    x, c, d = sp.symbols("x c d")
    shape = weight / k + c * sp.cosh(a * x) * sp.cos(a * x) + d * sp.sinh(a * x) * sp.sin(a * x)
    end = filament.span / 2
    found = sp.solve([shape.subs(x, end), sp.diff(shape, x).subs(x, end)], [c, d])
    return float(shape.subs(found).subs(x, 0))


def test_a_foundation_holds_a_beam_as_hetenyi_says():
    """Statically, by `auto`, and over the stiffness: E I y'''' + k y = q."""
    for k in (20.0, 300.0, 5e3):
        scene = sc.Scene.from_dict({**SCENE, "effects": {"elastic-foundation": {"stiffness": f"{k} Pa"}}})
        still = scene.replace({"run.effects": ["bending", "elastic-foundation"], "run.accuracy": 1e-3})
        run = sc.simulate(still)
        assert -run.summary["midpoint_final_m"] == pytest.approx(hetenyi(scene, k), rel=1e-3), k


def test_it_is_in_force_everywhere(tmp_path):
    """In explain, by `auto`, in C and interpreter, the energy audit, the file of a run, an ensemble."""
    effects = ["inertia", "bending", "extensibility", "viscous-stress", "elastic-foundation"]
    numerics = {"rtol": 1e-8, "estimate": False, "cells": 20, "solver": "rosenbrock"}
    scene = sc.Scene.from_dict({**SCENE, "material": DAMPED, "numerics": numerics})
    assert "elastic-foundation" in sc.explain(scene).in_force  # by `auto`
    scene = scene.replace({"run.effects": effects, "run.duration": "0.2 s"})
    told = sc.explain(scene)
    (balance,) = (one for one in told.equations if one.name == "balance of momentum, vertical")
    assert "- k_f*y" in balance.text and "elastic-foundation" in balance.source
    runs = [sc.simulate(scene.replace({"numerics.backend": backend})) for backend in ("interpreted", "compiled")]
    one, other = (run.data for run in runs)
    assert np.ptp(one.energy_elastic_foundation.values) > 0
    np.testing.assert_allclose(one.y.values, other.y.values, rtol=0, atol=1e-6 * np.abs(one.y.values).max())
    assert all(run.summary["energy_residual"] < 1e-6 for run in runs)
    runs[1].save(tmp_path / "run")
    again = sc.open_run(tmp_path / "run")
    np.testing.assert_array_equal(again.data.energy_elastic_foundation, other.energy_elastic_foundation)
    assert again.scene == scene.replace({"numerics.backend": "compiled"})
    key = "effects.elastic-foundation.stiffness"
    table = sc.simulate_many(scene, {key: [300.0, 100.0]}).data.midpoint_final
    assert float(table[0]) == pytest.approx(other.midpoint.values[-1], rel=1e-6) != float(table[1])
    described = sc.generate(scene, tmp_path / "c")
    python = (tmp_path / "c" / "filament.py").read_text(encoding="utf-8") if described else ""
    assert re.search(r'"elastic_foundation_stiffness": \([\d.]+, "Pa"\)', python)


@pytest.mark.slow
@pytest.mark.statistical
def test_a_fit_reads_its_stiffness_off_a_film(tmp_path):
    """A film of a damped beam on springs, with noise: the truth lies within the error bars."""
    table = {"elastic-foundation": {"stiffness": "3 kPa"}}
    filament = {**SCENE["filament"], "thickness": "6 mm"}
    # The springs ring at 46 Hz, which frames closer than 11 ms tell: with less than two a period several answers fit.
    asked = {"duration": "0.25 s", "frames": 101, "accuracy": 1e-3}
    scene = sc.Scene.from_dict({"filament": filament, "material": DAMPED, "effects": table, "run": asked})
    run = sc.simulate(scene)
    largest = abs(run.summary["midpoint_largest_m"])
    noise = draws(4).normal(0, 1e-2 * largest, 101)
    table = np.column_stack([run.data.time, run.data.midpoint + noise])
    np.savetxt(tmp_path / "film.csv", table, delimiter=",", header="time_s,midpoint_m", comments="")
    guess = scene.replace({"effects.elastic-foundation.stiffness": "1 kPa", "material.viscosity": "50 kPa*s"})
    free = ["effects.elastic-foundation.stiffness", "material.viscosity"]
    fit = sc.fit(tmp_path / "film.csv", guess, free, profiles=False, starts=1)
    for name, truth in (("stiffness", 3e3), ("viscosity", 2e4)):
        found = fit.parameters[name]
        assert abs(found.value - truth) < errors_away(98) * found.std, name
        assert found.std < 0.05 * truth, name


def drag(tangential, normal):
    """Two coefficients of a slender body [Pa s]: R = s (c_t v_t^2 + c_n v_n^2)/2 of the velocity along and across."""
    c_t = sc.EffectConstant("along", "c_t", "Pa*s", "force per length and velocity along the filament")
    c_n = sc.EffectConstant("across", "c_n", "Pa*s", "force per length and velocity across it")
    along, across = sy.x_X * sy.x_t + sy.y_X * sy.y_t, sy.x_X * sy.y_t - sy.y_X * sy.x_t
    sc.register_effect(
        sc.Effect(
            name="slender-bath",
            summary="resistance of a viscous bath",
            source="Cox 1970",
            dissipation=(c_t.symbol * along**2 + c_n.symbol * across**2) / sy.s / 2,
            constants=(c_t, c_n),
            estimate=lambda scene, motion: sc.Estimate(1.0, "as asked"),
        )
    )
    return {"slender-bath": {"along": f"{tangential} Pa*s", "across": f"{normal} Pa*s"}}


def test_without_inertia_weight_falls_through_a_bath_at_its_terminal_velocity():
    """Away from its clamps a strand that hardly resists falls at m g/c_n: velocities are algebraic there."""
    table = drag(1.0, 2.0)
    scene = sc.Scene.from_dict(
        {
            "filament": {"span": "0.2 m", "thickness": "2 mm", "density": "1000 kg/m^3"},
            "material": {"law": "newtonian", "viscosity": "1e-3 Pa*s"},
            "effects": table,
            "run": {
                "duration": "1e-4 s",
                "frames": 11,
                "effects": ["bending", "extensibility", "viscous-stress", "slender-bath"],
            },
            "numerics": {"rtol": 1e-8, "estimate": False},
        }
    )
    for backend in ("interpreted", "compiled"):
        run = sc.simulate(scene.replace({"numerics.backend": backend}))
        speed = np.gradient(run.data.midpoint.values, run.data.time.values)[5]
        assert -speed == pytest.approx(1000 * 4e-6 * 9.81 / 2.0, rel=1e-6), backend


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"elastic-foundation": {}}, "stiffness: missing"),
        ({"elastic-foundation": {"stiffness": 3}}, "in plain numbers; accepted: a value in Pa"),
        ({"elastic-foundation": {"stiffness": "3 m"}}, "in m; accepted: a value in Pa"),
        ({"elastic-foundation": {"stiffness": "3 Pa", "depth": "1 m"}}, "has no such constant; accepted: stiffness"),
        ({"elastic-fundation": {"stiffness": "3 Pa"}}, "accepted: an effect with constants: elastic-foundation"),
        ({"elastic-foundation": 3}, "effects.elastic-foundation: 3 is not a table"),
        (3, "effects: 3 is not a table"),
    ],
)
def test_tables_that_no_effect_has(given, words):
    """One message, with its place in the scene."""
    with pytest.raises(sc.SceneError, match=re.escape(words)):
        sc.explain({**SCENE, "effects": given})
    with pytest.raises(sc.SceneError, match=r"no \[effects.elastic-foundation\]"):
        sc.explain(
            {
                **{k: v for k, v in SCENE.items() if k != "effects"},
                "run": {"duration": 1, "effects": ["elastic-foundation"]},
            }
        )


def test_what_is_no_effect_is_refused():
    """When it is registered, not when a scene runs."""

    def effect(**changed):
        given = {"name": "mine", "summary": "", "source": "", "estimate": lambda *_: None, "stored": sy.y}
        return sc.Effect(**{**given, **changed})

    for wrong, words in (
        (effect(name="bending"), "belongs to the package"),
        (effect(name="My effect"), "lower-case words"),
        (effect(stored=0), "adds nothing"),
        (effect(needs=("magnetism",)), "needs magnetism, which is not registered"),
        (effect(stored=sp.Symbol("B")), "hold B, which no filament has"),
        (effect(stored=sy.y_t**2), "depends on rates"),
    ):
        with pytest.raises(ValueError, match=words):
            sc.register_effect(wrong)


def installed(folder: Path, module: str, value: str) -> subprocess.CompletedProcess[str]:
    """What `explain` says where a package `winkler` of this module and entry point is installed."""
    (folder / "winkler.py").write_text(module)
    described = folder / "winkler-1.0.dist-info"
    described.mkdir()
    (described / "METADATA").write_text("Metadata-Version: 2.1\nName: winkler\nVersion: 1.0\n")
    (described / "entry_points.txt").write_text(f"[softcat_sym.effects]\nelastic-foundation = {value}\n")
    (folder / "bed.toml").write_text(sc.Scene.from_dict(SCENE).to_toml())
    path = os.pathsep.join(filter(None, [str(folder), str(ROOT), os.environ.get("PYTHONPATH")]))
    command = [sys.executable, "-c", "from softcat_sym.cli import main; main()", "explain", "bed.toml"]
    given = {"cwd": folder, "env": {**os.environ, "PYTHONPATH": path}, "capture_output": True, "text": True}
    return subprocess.run(command, **given, check=False)


def test_an_installed_package_brings_its_effect(tmp_path):
    """By its entry point, on the command line, and in the C that is written."""
    (text,) = re.findall(r"```python\n(.*?)```", (ROOT / "CONTRIBUTING.md").read_text(), re.DOTALL)
    done = installed(tmp_path, text.replace("sc.register_effect(FOUNDATION)\n", ""), "winkler:FOUNDATION")
    assert done.returncode == 0, done.stderr
    assert "elastic-foundation" in done.stdout
