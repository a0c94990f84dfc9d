"""More than one film in a fit: a flow curve, films with parameters of their own, and trackers' tables."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import softcat_sym as sc
from softcat_sym.errors import SceneError, SoftcatError
from softcat_sym.fitting.flow_curve import FlowCurve
from softcat_sym.fitting.identifiability import information
from softcat_sym.fitting.measurements import read_measurements
from softcat_sym.fitting.plausibility import checked
from softcat_sym.fitting.problem import FilamentProblem
from softcat_sym.fitting.result import FitOutcome
from tests.common.draws import RARE, draws, errors_away
from tests.common.filmed import TRUTH, film, scene
from tests.common.fitting import is_sound
from tests.common.written_films import written


@pytest.mark.statistical
def test_a_flow_curve_narrows_what_a_film_leaves_wide_or_contradicts_it() -> None:
    random, rate = draws(4), np.geomspace(0.01, 3, 20)
    stress = TRUTH["yield_stress"] / math.sqrt(3) + TRUTH["viscosity"] / 3 * rate
    stress *= 1 + 0.03 * random.standard_normal(rate.size)
    start = scene().replace({"material.viscosity": "20 kPa*s"})
    found = [
        sc.fit(sc.Measurements.of(*film()), start, [*TRUTH], starts=0, profiles=False, flow_curve=curve)
        for curve in (None, FlowCurve(rate, stress), FlowCurve(rate, 1.5 * stress))
    ]
    film_alone, both, apart = found
    for name, truth in TRUTH.items():
        wide, narrow = film_alone.parameters[name].std, both.parameters[name].std
        assert wide is not None and narrow is not None and narrow < wide / 3
        assert abs(both.parameters[name].best - truth) < errors_away(rate.size - 2) * narrow
    agree = both.problem.contradiction(both.starts.best.residuals, both.starts.best.jacobian)
    assert agree is not None and agree.p_value > RARE and is_sound(both)
    assert apart.outcome is FitOutcome.contradiction
    solid = start.replace({"material.law": "kelvin-voigt", "material.yield_stress": None})
    with pytest.raises(SceneError, match="the law 'kelvin-voigt' has none"):
        sc.fit(sc.Measurements.of(*film()), solid, ["viscosity"], flow_curve=FlowCurve(rate, stress))


def test_late_frames_of_what_is_arrested_tell_no_surface_tension_from_a_yield_stress() -> None:
    paper = "inertia bending extensibility finite-stretch thinning large-rotation viscous-flow yielding gravity-ramp"
    changes = {"surroundings.surface_tension": "4 N/m", "run.frames": 401, "run.duration": "4 s"}
    arrested = sc.load_scene("arrested-overdamped", ["numerics.cells=10"]).replace(
        changes | {"run.effects": [*paper.split(), "surface-tension"]}
    )
    data = sc.simulate(arrested).data
    for frames, told in ((slice(280, 401, 8), False), (slice(5, 401, 5), True)):
        time, midpoint = data.time.values[frames], data.midpoint.values[frames]
        films = sc.Measurements.of(time, midpoint, std=1e-5)
        problem = FilamentProblem(arrested, films, ["yield_stress", "surface_tension"], camera=True)
        residuals, jacobian = problem.linearised(problem.typical)
        box = problem.lower[:2], problem.upper[:2]
        known = information(problem.names[:2], problem.typical[:2], residuals, jacobian, box, noise_known=True)
        assert bool(known.identified.all()) is told, known.standard_errors
        assert told or any("yield_stress^1 * surface_tension^" in one.text for one in known.combinations)


FILM = "# camera.fps = 240\n# camera.pixel = 0.1 mm\n# camera.origin = 1000 200\nframe,x_px,y_px\n12,0,0\n"


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (FILM.replace("# camera.fps", "# fps"), "frames without a frame rate.*camera.fps = 240"),
        (FILM.replace("# camera.pixel", "# pixel"), "pixels, which only.*camera.pixel = 0.05 mm"),
        (FILM.replace("0.1 mm", "0.1 s"), r"camera.pixel: 's' is a time"),
        (FILM.replace("1000 200", "1000"), "camera.origin: '1000'; accepted: camera.origin = 640 212"),
    ],
)
def test_what_no_film_can_be_is_one_clear_refusal(text: str, words: str, tmp_path: Path) -> None:
    with pytest.raises(SoftcatError, match=words):
        checked(read_measurements(written(tmp_path, text)), sc.load_scene("no-yield"))
