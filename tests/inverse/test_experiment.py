"""Design of experiments: scaling laws of the errors, what duration and frame rate are for, a brute-force grid."""

from __future__ import annotations

import csv
import math
from itertools import product
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.design.experiment import Experiment, design_experiment, pattern_search
from softcat_sym.design.information import Noise, Trial, Unknowns, exact_film, film_times, films_of, relative_errors
from softcat_sym.fitting.free_parameters import free_parameters
from softcat_sym.plotting.design import write_experiment

_NOISE = 1e-5


def _maxwell(name: str = "maxwell-fast", duration: float = 6) -> sc.Scene:
    """The published theory on few cells."""
    return sc.load_scene(name, {"run.effects": "paper", "groups.duration": duration, "numerics.cells": 16})


def _errors(scene: sc.Scene, names: list[str], frames: int, noise: float = _NOISE) -> np.ndarray:
    free = free_parameters(scene, names)
    unknowns = Unknowns(free, np.ones(len(free), dtype=bool))
    return relative_errors(exact_film(scene, free, frames, Noise(noise)).information, unknowns)


def test_errors_go_as_noise_and_as_the_root_of_frames() -> None:
    """Four times the frames: half the errors, but for the ends of the film; twice the noise: twice the errors."""
    scene, both = _maxwell(), ["youngs_modulus", "viscosity"]
    few, many, noisy = (_errors(scene, both, n, s) for n, s in ((201, _NOISE), (801, _NOISE), (201, 2 * _NOISE)))
    assert few / many == pytest.approx(2.0, rel=0.02)
    assert noisy / few == pytest.approx(2.0, rel=1e-9)


def test_one_run_serves_all_its_films() -> None:
    """The integral over time agrees with the frames themselves, at every duration."""
    scene = _maxwell()
    free = free_parameters(scene, ["youngs_modulus", "viscosity"])
    unknowns = Unknowns(free, np.ones(2, dtype=bool))
    films = films_of(scene, free, 0.1, scene.run.duration)
    for number in (0, 150, 400, -1):
        short = scene.replace({"run.duration": f"{float(films.durations[number])!r} s"})
        by_frames = _errors(short, ["youngs_modulus", "viscosity"], 501)
        information = films.information(np.full(len(films.durations), 501.0), _NOISE)[number]
        assert relative_errors(information, unknowns) == pytest.approx(by_frames, rel=0.03)


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
    scene, told = _maxwell(), list[Trial]()
    within = {"span": ("100 mm", "300 mm"), "thickness": ("0.5 mm", "2 mm"), "duration": ("0.3 s", "1.2 s")}
    found = design_experiment(
        scene,
        ["youngs_modulus", "viscosity"],
        "10 um",
        within | {"frame_rate": ("10 Hz", "400 Hz")},
        max_frames=101,
        told=told.append,
    )
    assert found.best.worst <= _brute_force(scene, _NOISE, 101) * 1.01
    assert found.best.worst <= min(trial.worst for trial in found.tried)
    assert tuple(told) == found.tried
    assert found.gain == pytest.approx(found.as_given.worst / found.best.worst)
    assert found.gain > 1
    assert found.best.frames == 101
    assert found.at_bounds["filament.span"] == "upper"
    assert found.scene.filament.span == 0.3
    assert "Film a span of 300 mm" in found.text[0]


def _filmed(**changes: object) -> Experiment:
    scene = _maxwell()
    asked: dict[str, object] = {"duration": ("0.2 s", "0.8 s"), "frame_rate": ("10 Hz", "200 Hz")}
    return design_experiment(scene, ["viscosity"], _NOISE, asked, **changes)  # type: ignore[arg-type]


def test_nuisance_costs_and_roughness_is_the_worst_corner() -> None:
    """An unknown more makes every error larger; corners make the worst larger; the camera's highest rate is taken."""
    plain = _filmed()
    assert plain.best == _filmed().best
    assert plain.best.frame_rate == pytest.approx(200, rel=0.01)
    assert plain.at_bounds.keys() >= {"frame_rate"}
    more = _filmed(nuisance=["time_offset", "initial_sag"])
    assert more.best.worst > plain.best.worst
    assert more.counted == ("material.viscosity",)
    assert more.best.worst == more.best.errors["material.viscosity"]
    corners = _filmed(rough=3.0)
    assert corners.best.worst > plain.best.worst
    assert any("factor of 3" in sentence for sentence in corners.text)


def test_pictures_and_tables_are_written(tmp_path: Path) -> None:
    """The scene can be run; the table holds the best, the scene as given and every trial."""
    found = _filmed()
    written = {path.name: path for path in write_experiment(found, tmp_path)}
    assert written["experiment.png"].read_bytes().startswith(b"\x89PNG")
    assert sc.load_scene(written["scene.toml"]) == found.scene
    rows = list(csv.DictReader(written["experiment.csv"].read_text().splitlines()))
    assert [row["what"] for row in rows] == ["best", "as given", *["tried"] * len(found.tried)]
    assert float(rows[0]["worst"]) == found.best.worst


def test_what_cannot_be_told_apart_is_named() -> None:
    """Modulus, viscosity and density all scaled alike move nothing: only their ratios show."""
    scene = _maxwell()
    with pytest.raises(sc.SoftcatError, match=r"what is determined.*\^"):
        design_experiment(scene, ["youngs_modulus", "viscosity", "density"], _NOISE, {"duration": ("0.2 s", "0.8 s")})


def test_refusals() -> None:
    """Every fault at once, with what would do."""
    scene = _maxwell()
    with pytest.raises(sc.SceneError) as caught:
        design_experiment(scene, ["time_offset"], "0 mm", {}, max_frames=1, rough=0.5)
    assert [fault.path for fault in caught.value.faults] == ["free", "noise", "max_frames", "rough"]
    with pytest.raises(sc.SceneError) as caught:
        within = {"spann": ("1 mm", "2 mm"), "thickness": ("2 mm", "1 mm"), "duration": "5 m"}
        design_experiment(scene, ["viscosity"], "1 um", within)
    texts = [str(fault) for fault in caught.value.faults]
    assert "no design variable" in texts[0]
    assert "is above" in texts[1]
    assert "not a time" in texts[2]
    with pytest.raises(sc.SceneError, match="nothing is free"):
        design_experiment(scene, [], "1 um", {})


def test_the_search_finds_a_minimum_behind_a_jump() -> None:
    """A tilted quadratic with a step and a forbidden corner, to the fineness that is promised; bounds are reached."""

    def value(point: tuple[float, ...]) -> float:
        x, y = point
        if x + y > 3:
            return math.inf
        return (x - 0.7) ** 2 + (x - 0.7) * (y - 1.1) + (y - 1.1) ** 2 + (1.0 if x < 0.2 else 0.0)

    best = pattern_search(value, np.array([0.0, 0.0]), np.array([2.0, 2.0]), 200)
    assert best == pytest.approx((0.7, 1.1), abs=0.05)
    assert pattern_search(lambda point: point[0], np.array([1.0]), np.array([3.0]), 60) == (1.0,)
    assert pattern_search(lambda point: math.inf, np.array([1.0]), np.array([3.0]), 60) is None


def test_every_duration_is_resolved() -> None:
    """From the shortest film on, and where there is one only."""
    times, durations = film_times(0.5, 40.0)
    assert np.all(np.diff(times) > 0)
    assert (durations[0], durations[-1], times[-1]) == (0.5, 40.0, 40.0)
    assert film_times(2.0, 2.0)[1].tolist() == [2.0]


def test_errors_of_a_known_information() -> None:
    """The inverse where there is one; infinite for what takes part in a direction that is not seen."""
    free = free_parameters(_maxwell(), ["youngs_modulus", "viscosity"])
    unknowns = Unknowns(free, np.array([True, False]))
    matrix = np.array([[4.0, 1.0], [1.0, 9.0]])
    assert relative_errors(matrix, unknowns) == pytest.approx(np.sqrt(np.diag(np.linalg.inv(matrix))))
    assert relative_errors(np.diag([4.0, 0.0]), unknowns).tolist() == [0.5, math.inf]
    assert relative_errors(np.ones((2, 2)), unknowns).tolist() == [math.inf, math.inf]
    assert relative_errors(np.full((2, 2), np.nan), unknowns).tolist() == [math.inf, math.inf]
    assert unknowns.worst(np.array([0.5, math.inf])) == 0.5
