"""Designs of experiments and critical spans: closed forms, scaling laws, brute force, files, refusals."""

from __future__ import annotations

import json
import math
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import brentq

import softcat_sym as sc
from softcat_sym.design.critical_span import critical_span
from softcat_sym.design.experiment import design_experiment
from softcat_sym.design.information import ReadingNoise, exact_film, relative_errors
from softcat_sym.fitting.free_parameters import free_parameters
from tests.common.in_process import Softcat, sets

_GRAVITY, _DENSITY, _THICKNESS, _DURATION, _VISCOSITY = 9.81, 1300.0, 2e-3, 3.0, 5e7


def _beam(ends: str, changes: dict[str, object] | None = None) -> sc.Scene:
    """A viscous beam of rectangular section without inertia."""
    return sc.Scene.model_validate(
        {
            "filament": {
                "span": "60 mm",
                "thickness": f"{_THICKNESS!r} m",
                "section": "rectangle",
                "density": f"{_DENSITY!r} kg/m^3",
            },
            "material": {"law": "newtonian", "viscosity": f"{_VISCOSITY!r} Pa*s"},
            "ends": {"left": ends, "right": ends},
            "run": {"duration": f"{_DURATION!r} s", "effects": ["bending", "viscous-stress"]},
        }
    ).replace(changes or {})


@pytest.mark.parametrize(("ends", "factor"), [("clamped", 1 / 384), ("pinned", 5 / 384)])
def test_a_viscous_beam_in_small_deflection(ends: str, factor: float) -> None:
    """Sag = factor q L^4 t/(eta I) by Stokes' analogy: L goes as (eta h^2/(rho t))^(1/4)."""
    limit = 2e-5
    found = critical_span(_beam(ends), f"{limit!r} m", within=("20 mm", "200 mm"))
    stiffness = _VISCOSITY * _THICKNESS**2 / (12 * _DENSITY * _GRAVITY * _DURATION)
    assert found.span == pytest.approx((limit * stiffness / factor) ** 0.25, rel=2e-3)
    assert found.sag == pytest.approx(limit, rel=1e-8)
    expected = {"material.viscosity": 0.25, "filament.density": -0.25, "filament.thickness": 0.5}
    assert {path: found.gradient[path] for path in expected} == pytest.approx(expected, abs=3e-3)
    assert found.gradient["filament.width"] == 0.0
    rough = critical_span(_beam(ends), f"{limit!r} m", within=("20 mm", "200 mm"), exponents=False)
    assert rough.span == pytest.approx(found.span, rel=4e-3) and rough.gradient == {}


def test_the_longest_span_of_a_viscous_beam_has_an_error_that_holds(softcat: Softcat, tmp_path: Path) -> None:
    """Sag = q L^4 t/(384 eta I), found from a span three times too long; the command says the same."""
    limit = 2e-5
    stiffness = _VISCOSITY * _THICKNESS**2 / (12 * _DENSITY * _GRAVITY * _DURATION)
    true = (384 * limit * stiffness) ** 0.25
    scene = _beam("clamped", {"filament.span": f"{3 * true!r} m"})
    (tmp_path / "beam.toml").write_text(scene.to_toml())
    done = softcat("span", str(tmp_path / "beam.toml"), "--max-sag", "20 um", "-o", str(tmp_path / "out"))
    assert done.status == 0, done.err
    found = json.loads((tmp_path / "out" / "span.json").read_text())
    assert abs(found["span_m"] - true) < found["error_m"] < 0.02 * true
    first, second, *_ = done.out.splitlines()
    assert first.startswith(f"longest span {1e3 * found['span_m']:.4g} mm +- ") and "more than 20 um" in second
    assert {path.name for path in (tmp_path / "out").iterdir()} == {"span.json", "span.csv", "span.png", "scene.toml"}
    assert sc.load_scene(tmp_path / "out" / "scene.toml").filament.span == pytest.approx(found["span_m"])
    for bad, words in (("-1 mm", "not positive"), ("little", "not a number"), ("1 Pa", "not a length")):
        refused = softcat("span", str(tmp_path / "beam.toml"), "--max-sag", bad, "-o", str(tmp_path / "no"))
        assert refused.status == 2 and words in refused.err and not (tmp_path / "no").exists()


@pytest.mark.slow
def test_a_yield_stress_string_is_arrested() -> None:
    """A stiff string stops as a catenary whose largest stress is the yield stress: G cosh u = 2 u [3.13, exact]."""
    scene = sc.load_scene("arrested-overdamped", {"groups.delta": 0.005, "groups.eps_Y": 2e-4})
    named = ["bending", "extensibility", "large-rotation", "finite-stretch", "viscous-flow", "yielding", "gravity-ramp"]
    scene = scene.replace({"run.duration": "60 s", "run.effects": named, "load.ramp": "1 s", "run.frames": 31})
    fraction, material = 0.07, scene.material
    assert material.yield_stress is not None
    found = critical_span(scene, fraction, within=("150 mm", "400 mm"))
    u = brentq(lambda u: (math.cosh(u) - 1) / (2 * u) - fraction, 0.1, 1.0, xtol=1e-12)
    ideal = 2 * u / math.cosh(u) * material.yield_stress / (scene.filament.density * scene.load.gravity)
    assert found.span == pytest.approx(ideal, rel=0.03)
    assert found.gradient["material.yield_stress"] == pytest.approx(1.0, abs=0.05)
    assert found.gradient["filament.density"] == pytest.approx(-1.0, abs=0.05)


def test_critical_spans_that_are_refused() -> None:
    """Each says what would do."""
    beam = _beam("clamped")
    with pytest.raises(sc.SceneError, match=r"limit: .*no unit"):
        critical_span(beam, "12")
    with pytest.raises(sc.SceneError, match=r"limit: .*not positive"):
        critical_span(beam, -0.1)
    with pytest.raises(sc.SceneError, match=r"within filament\.span"):
        critical_span(beam, "1 mm", within=("50 mm", "20 mm"))
    with pytest.raises(sc.SoftcatError, match="even a span of 20 mm sags"):
        critical_span(beam, "1e-9 m", within=("20 mm", "40 mm"))
    with pytest.raises(sc.SoftcatError, match="no span from 20 mm to 40 mm reaches the limit"):
        critical_span(beam, "1 m", within=("20 mm", "40 mm"))


_NOISE = 1e-5


def _maxwell(name: str = "maxwell-fast", duration: float = 6) -> sc.Scene:
    """The published theory on few cells."""
    return sc.load_scene(name, {"run.effects": "paper", "groups.duration": duration, "numerics.cells": 16})


def _errors(scene: sc.Scene, names: list[str], frames: int, noise: float = _NOISE) -> np.ndarray:
    free = free_parameters(scene, names)
    return relative_errors(exact_film(scene, free, frames, ReadingNoise(noise)).information, free)


def test_errors_go_as_noise_and_as_the_root_of_frames() -> None:
    """Four times the frames: half the errors, but for the ends of the film; twice the noise: twice the errors."""
    scene, both = _maxwell(), ["youngs_modulus", "viscosity"]
    few, many, noisy = (_errors(scene, both, n, s) for n, s in ((201, _NOISE), (801, _NOISE), (201, 2 * _NOISE)))
    assert few / many == pytest.approx(2.0, rel=0.02)
    assert noisy / few == pytest.approx(2.0, rel=1e-9)


@pytest.mark.slow
def test_what_film_tells_what_of_a_maxwell_fluid() -> None:
    """The modulus shows while it rings, the viscosity long after: for each its own duration, and both in between."""
    scene = _maxwell("maxwell-slow", 20)
    within = {"duration": ("0.1 s", f"{scene.run.duration!r} s"), "frame_rate": ("1 Hz", "1 kHz")}
    found = {
        name: design_experiment(scene, [name], _NOISE, within, nuisance=[other], max_frames=100)
        for name, other in (("youngs_modulus", "viscosity"), ("viscosity", "youngs_modulus"))
    }
    elastic, viscous = found["youngs_modulus"], found["viscosity"]
    assert elastic.best.duration < 0.5 * viscous.best.duration
    assert elastic.best.errors["material.youngs_modulus"] < viscous.best.errors["material.youngs_modulus"]
    assert viscous.best.errors["material.viscosity"] < elastic.best.errors["material.viscosity"]
    assert elastic.counted == ("material.youngs_modulus",)
    assert elastic.at_bounds == {"max_frames": "upper"}


def _brute_force(scene: sc.Scene, noise: float, frames: int) -> float:
    """Least worst error on a grid of spans, thicknesses and durations, by frames and with effects chosen anew."""
    worst = []
    for span, thickness, duration in product((0.1, 0.2, 0.3), (5e-4, 2e-3), (0.3, 0.6, 1.2)):
        changes = {
            "filament.span": f"{span} m",
            "filament.thickness": f"{thickness} m",
            "run.duration": f"{duration} s",
        }
        worst.append(_errors(scene.replace(changes), ["youngs_modulus", "viscosity"], frames, noise).max())
    return float(min(worst))


@pytest.mark.slow
def test_the_optimum_beats_a_grid() -> None:
    """And all that was tried, and the scene as given; a camera that keeps everything films at its highest rate."""
    scene = _maxwell()
    within = {"span": ("100 mm", "300 mm"), "thickness": ("0.5 mm", "2 mm"), "duration": ("0.3 s", "1.2 s")}
    found = design_experiment(
        scene,
        ["youngs_modulus", "viscosity"],
        "10 um",
        within | {"frame_rate": ("10 Hz", "400 Hz")},
        max_frames=101,
    )
    assert found.best.worst <= _brute_force(scene, _NOISE, 101) * 1.01
    assert found.best.worst <= min(trial.worst for trial in found.tried)
    assert found.gain == pytest.approx(found.as_given.worst / found.best.worst)
    assert found.gain > 1
    assert found.best.frames == 101
    assert found.at_bounds["filament.span"] == "upper"
    assert found.scene.filament.span == 0.3
    assert "Film a span of 300 mm" in found.text[0]


def test_refusals() -> None:
    """Every fault at once, with what would do."""
    scene = _maxwell()
    with pytest.raises(sc.SceneError) as caught:
        design_experiment(scene, ["time_offset"], "0 mm", {}, max_frames=1)
    assert [fault.path for fault in caught.value.faults] == ["free", "noise", "max_frames"]
    with pytest.raises(sc.SceneError) as caught:
        within = {"spann": ("1 mm", "2 mm"), "thickness": ("2 mm", "1 mm"), "duration": "5 m"}
        design_experiment(scene, ["viscosity"], "1 um", within)
    texts = [str(fault) for fault in caught.value.faults]
    assert "no design variable" in texts[0]
    assert "is above" in texts[1]
    assert "not a time" in texts[2]
    with pytest.raises(sc.SceneError, match="nothing is free"):
        design_experiment(scene, [], "1 um", {})


def test_errors_of_a_known_information() -> None:
    """The inverse where there is one; infinite for what takes part in a direction that is not seen."""
    free = free_parameters(_maxwell(), ["youngs_modulus", "viscosity"])
    matrix = np.array([[4.0, 1.0], [1.0, 9.0]])
    assert relative_errors(matrix, free) == pytest.approx(np.sqrt(np.diag(np.linalg.inv(matrix))))
    assert relative_errors(np.diag([4.0, 0.0]), free).tolist() == [0.5, math.inf]
    assert relative_errors(np.ones((2, 2)), free).tolist() == [math.inf, math.inf]
    assert relative_errors(np.full((2, 2), np.nan), free).tolist() == [math.inf, math.inf]


SCENE = ("maxwell-fast", *sets("run.effects=paper", "groups.duration=6", "numerics.cells=10"))
FILM = ("--free", "viscosity", "--noise", "10 um", "--duration", "0.2:0.8 s", "--frame-rate", "10:200 Hz")
FILES = {"experiment.json", "scene.toml", "experiment.csv", "experiment.png"}


@pytest.mark.slow
def test_a_limit_of_the_sag_and_noise_of_the_sag(softcat: Softcat, tmp_path: Path) -> None:
    limited = ("--max-sag", "2 mm", "--noise", "1 %", "--span", "0.1:0.2 m", "-q")
    # The last of an option counts.
    done = softcat("experiment", *SCENE, *FILM, *limited, "-o", str(tmp_path))
    assert (done.status, done.out, done.err) == (0, "", "")
    assert {path.name for path in tmp_path.iterdir()} == FILES
    found = json.loads((tmp_path / "experiment.json").read_text())
    scene = sc.load_scene(str(tmp_path / "scene.toml"))
    assert float(abs(sc.simulate(scene).data.midpoint.values).max()) <= 2e-3
    assert found["noise_m"] == pytest.approx(0.01 * found["best"]["sag_m"])


BAD = {
    "scene": (("maxwell-fsat", *FILM), "maxwell-fsat"),
    "nothing free": ((*SCENE, "--noise", "1 um"), "--free"),
    "no noise": ((*SCENE, "--free", "viscosity"), "--noise"),
    "unknown": ((*SCENE, *FILM, "--free", "viscsity"), "did you mean"),
    "camera only": ((*SCENE, "--noise", "1 um", "--free", "time_offset"), "nothing that counts is free"),
    "noise of no unit": ((*SCENE, *FILM, "--noise", "10"), "noise"),
    "noise in words": ((*SCENE, *FILM, "--noise", "few %"), "no percentage"),
    "three ends": ((*SCENE, *FILM, "--span", "5:10:20 mm"), "within filament.span"),
    "thick": ((*SCENE, *FILM, "--thickness", "1:2 m"), "a thickness below the span"),
    "frames": ((*SCENE, *FILM, "--max-frames", "1"), "--max-frames"),
    "sag": ((*SCENE, *FILM, "--max-sag", "-1 mm"), "not positive"),
    "sag too small": ((*SCENE, *FILM, "--max-sag", "1 nm"), "sags more than"),
    "set": ((*SCENE, *FILM, *sets("material.visosity=1 Pa*s")), "material.visosity"),
}


@pytest.mark.parametrize(("arguments", "message"), BAD.values(), ids=BAD)
def test_bad_input_is_one_message_and_leaves_nothing(
    arguments: tuple[str, ...], message: str, softcat: Softcat, tmp_path: Path
) -> None:
    output = tmp_path / "out"
    done = softcat("experiment", *arguments, "-o", str(output))
    assert done.status == 2 and done.out == ""
    assert message in " ".join(done.err.replace("│", " ").split())
    assert not output.exists()
